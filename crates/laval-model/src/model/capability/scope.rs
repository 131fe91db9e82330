//! Machines and speeds that a part is made for.

use super::super::params::{Parametric, Params};
use crate::text::Text;

/// Direction of the shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Axis {
    /// Weight acts along the shaft.
    #[default]
    Vertical,
    /// Weight acts along -y.
    Horizontal,
}

/// How a part that is known at some spin speeds, or frequencies of vibration, only goes on at others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// Not at all: a study there is refused.
    Refuse,
    /// As at the end.
    Hold,
    /// Along the tangent at the end.
    Linear,
}

/// The spin speeds, or frequencies of vibration, at which a part is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tabulated {
    /// First and last, rad/s.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// Outside.
    pub beyond: Beyond,
    /// The [`Validity`](super::super::part::Validity) that states the same of a motion.
    pub statement: &'static str,
}

/// A part that does not serve every machine or every speed.
pub trait Scope: Parametric {
    /// The spin speeds at which it is known, of a part given in a table over them.
    fn tabulated(&self) -> Option<Tabulated> {
        None
    }
    /// The spin speeds of the rows of that table, rad/s: its coefficients may bend there, and have their largest values.
    fn table_speeds(&self) -> Vec<f64> {
        Vec::new()
    }
    /// Why it does not fit a machine with this axis, and what to change.
    fn refuses_axis(&self, _p: &Params<Self, f64>, _axis: Axis) -> Option<Text> {
        None
    }
    /// Of a part that others name as their spin: the index of the parameter that is the ratio of its speed to that of the machine.
    fn spin_ratio(&self) -> Option<usize> {
        None
    }
    /// Why it does not join bodies that do not twist, and what to change.
    fn refuses_untwisted(&self, _p: &Params<Self, f64>) -> Option<Text> {
        None
    }
    /// Why it does not join two turning bodies of which the second turns `ratio` times as fast as the first, and what to change.
    fn refuses_ratio(&self, _p: &Params<Self, f64>, _ratio: f64) -> Option<Text> {
        None
    }
}

/// The object-safe face.
pub mod erased {
    use super::{Axis, Tabulated};
    use crate::text::Text;

    /// See the [trait of the author](super::Scope).
    #[allow(missing_docs)]
    pub trait Scope {
        fn tabulated(&self) -> Option<Tabulated>;
        fn table_speeds(&self) -> Vec<f64>;
        fn refuses_axis(&self, p: &[f64], axis: Axis) -> Option<Text>;
        fn spin_ratio(&self) -> Option<usize>;
        fn refuses_untwisted(&self, p: &[f64]) -> Option<Text>;
        fn refuses_ratio(&self, p: &[f64], ratio: f64) -> Option<Text>;
    }

    impl<T: super::Scope> Scope for T {
        fn tabulated(&self) -> Option<Tabulated> {
            super::Scope::tabulated(self)
        }
        fn table_speeds(&self) -> Vec<f64> {
            super::Scope::table_speeds(self)
        }
        fn refuses_axis(&self, p: &[f64], axis: Axis) -> Option<Text> {
            super::Scope::refuses_axis(self, &self.given(p), axis)
        }
        fn spin_ratio(&self) -> Option<usize> {
            super::Scope::spin_ratio(self)
        }
        fn refuses_untwisted(&self, p: &[f64]) -> Option<Text> {
            super::Scope::refuses_untwisted(self, &self.given(p))
        }
        fn refuses_ratio(&self, p: &[f64], ratio: f64) -> Option<Text> {
            super::Scope::refuses_ratio(self, &self.given(p), ratio)
        }
    }
}
