//! Parameters of a part, declared once.

use super::field::{Bounds, Field, FieldKind};
use crate::text;
use crate::text::{Arg, Text};
use laval_num::scalar::Scalar;
use std::marker::PhantomData;
use std::ops::Deref;

/// One scalar parameter after lateral pairs have been split.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamSlot {
    /// Declared name, with `.x` or `.y` for one half of a lateral pair.
    pub name: String,
    /// SI unit.
    pub unit: &'static str,
    /// Admissible interval.
    pub bounds: Bounds,
    /// Value where none is given; required parameters have none.
    pub default: Option<f64>,
}

#[derive(PartialEq)]
enum Wrong {
    Missing,
    Value(Arg, Text),
}

/// What is wrong with values of parameters, in the names and units of a machine file: a lateral pair by its one name where both halves are alike.
pub fn inadmissible(slots: &[ParamSlot], values: &[f64]) -> Vec<Text> {
    let wrong = |slot: &ParamSlot, x: f64| match slot.bounds.contains(x) {
        true => None,
        false if x.is_nan() => Some(Wrong::Missing),
        false => Some(Wrong::Value(text::quantity(x, slot.unit), slot.bounds.text(slot.unit))),
    };
    let mut out: Vec<(&str, Wrong)> = Vec::new();
    for (slot, &x) in slots.iter().zip(values) {
        let Some(what) = wrong(slot, x) else { continue };
        let pair = slot.name.strip_suffix(".y");
        match (pair, out.last_mut()) {
            (Some(pair), Some(last)) if last.0.strip_suffix(".x") == Some(pair) && last.1 == what => last.0 = pair,
            _ => out.push((slot.name.as_str(), what)),
        }
    }
    let said = |(name, what): (&str, Wrong)| match what {
        Wrong::Missing => text!("{name} is missing", name),
        Wrong::Value(value, wanted) => text!("{name} is {value}; it must be {wanted}", name, value, wanted),
    };
    out.into_iter().map(said).collect()
}

/// A set of parameters with a struct for every scalar and a lift between them. Written by [`params!`](crate::params).
pub trait Family: Send + Sync + 'static {
    /// The parameters as numbers of kind `S`.
    type P<S: Scalar>: Clone + Send + Sync;
    /// The declarations; those of a list are among the fields of its part.
    const FIELDS: &'static [Field];
    /// Their defaults in SI units; required parameters have none.
    const DEFAULTS: &'static [Option<f64>];
    /// How many scalars (a lateral pair counts two), without those in lists.
    const COUNT: usize;
    /// How many lists hold parameters row by row.
    const LISTS: usize = 0;
    /// These lists, in order.
    fn lists() -> Vec<List> {
        Vec::new()
    }
    /// From consecutive scalars, those of so many rows of each list last.
    fn from_slice<S: Scalar>(v: &[S], rows: RowCounts) -> Self::P<S>;
    /// To consecutive scalars.
    fn to_vec(p: &Self::P<f64>) -> Vec<f64>;
    /// The scalar slots in order: those of so many rows of each list (`section[1].outer_diameter`) come last.
    fn all_slots(rows: RowCounts) -> Vec<ParamSlot> {
        let mut out = Self::slots();
        for (list, count) in Self::lists().iter().zip(rows) {
            for k in 0..count {
                out.extend(list.slots.iter().map(|s| ParamSlot { name: list.path(k, &s.name), ..s.clone() }));
            }
        }
        out
    }
    /// The scalar slots in order, without those of a list.
    fn slots() -> Vec<ParamSlot> {
        let mut out = Vec::with_capacity(Self::COUNT);
        for (f, &default) in Self::FIELDS.iter().zip(Self::DEFAULTS) {
            match f.kind {
                FieldKind::Quantity { unit, bounds } => out.push(ParamSlot { name: f.name.into(), unit, bounds, default }),
                FieldKind::Lateral { unit, bounds } => {
                    out.extend(["x", "y"].map(|half| ParamSlot { name: format!("{}.{half}", f.name), unit, bounds, default }));
                }
                _ => {}
            }
        }
        out
    }
}

/// Most lists with parameters of one part.
pub const MOST_LISTS: usize = 2;

/// How many rows each list of a part has, in the order of [`Family::lists`].
pub type RowCounts = [usize; MOST_LISTS];

/// A list whose rows hold parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct List {
    /// The field that holds it.
    pub name: &'static str,
    /// It is a list of numbers: one value in a row, without a name.
    pub bare: bool,
    /// The parameters of one row.
    pub fields: &'static [Field],
    /// Their scalar slots, in order.
    pub slots: Vec<ParamSlot>,
}

impl List {
    /// Name of a parameter in a row, which is counted from 0 here and from 1 there: `section[1].outer_diameter`, `mass_ratios[1]`.
    pub fn path(&self, row: usize, parameter: &str) -> String {
        let (name, number) = (self.name, row + 1);
        if self.bare { format!("{name}[{number}]") } else { format!("{name}[{number}].{parameter}") }
    }
    /// The parameter that a path without its part names, in any row.
    pub fn find(&self, path: &str) -> Option<&ParamSlot> {
        let (number, rest) = path.strip_prefix(self.name)?.strip_prefix('[')?.split_once(']')?;
        let numbered = number.parse::<usize>().is_ok_and(|n| n > 0);
        let names = |s: &&ParamSlot| if self.bare { rest.is_empty() } else { rest.strip_prefix('.') == Some(s.name.as_str()) };
        self.slots.iter().find(names).filter(|_| numbered)
    }
}

/// What has parameters: every [`Part`](super::part::Part).
pub trait Parametric: Send + Sync + Sized + 'static {
    /// The parameters, declared with [`params!`](crate::params).
    type Family: Family;
    /// How many rows its lists have.
    fn row_counts(&self) -> RowCounts;
    /// Its parameters from consecutive scalars.
    #[inline(always)]
    fn given<S: Scalar>(&self, v: &[S]) -> Params<Self, S> {
        Self::Family::from_slice(v, self.row_counts())
    }
}

/// The parameters of part `P` as numbers of kind `S`.
pub type Params<P, S> = <<P as Parametric>::Family as Family>::P<S>;

/// Shapes a parameter can have, by the word used in [`params!`](crate::params).
#[allow(non_camel_case_types)]
pub mod shape {
    /// One number.
    pub type scalar<S> = S;
    /// One number for x and one for y.
    pub type lateral<S> = [S; 2];
}

/// A family of parameters whose values stand in the rows of a list of the file.
pub trait RowFamily: Family {
    /// The field that holds the list: its columns have the names of these parameters, and may have others.
    const LIST: &'static str;
    /// It is a list of numbers, and this one parameter is their meaning.
    const BARE: bool = false;
}

/// The parameters of `F` and, in every row of a list, those of `R`. With two lists `F` is of this kind too.
pub struct WithRows<F, R>(PhantomData<(F, R)>);

/// Values of [`WithRows`]: the parameters beside the list are reached directly.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed<P, R> {
    /// Beside the list.
    pub own: P,
    /// Row by row.
    pub rows: Vec<R>,
}

impl<P, R> Deref for Listed<P, R> {
    type Target = P;
    #[inline(always)]
    fn deref(&self) -> &P {
        &self.own
    }
}

/// Without rows.
impl<P, R> From<P> for Listed<P, R> {
    fn from(own: P) -> Self {
        Listed { own, rows: Vec::new() }
    }
}

/// Without rows of either list.
impl<P, A, B> From<P> for Listed<Listed<P, A>, B> {
    fn from(own: P) -> Self {
        Listed { own: Listed { own, rows: Vec::new() }, rows: Vec::new() }
    }
}

impl<F: Family, R: RowFamily> Family for WithRows<F, R> {
    type P<S: Scalar> = Listed<F::P<S>, R::P<S>>;
    const FIELDS: &'static [Field] = F::FIELDS;
    const DEFAULTS: &'static [Option<f64>] = F::DEFAULTS;
    const COUNT: usize = F::COUNT;
    const LISTS: usize = F::LISTS + 1;
    fn lists() -> Vec<List> {
        let mut out = F::lists();
        out.push(List { name: R::LIST, bare: R::BARE, fields: R::FIELDS, slots: R::slots() });
        out
    }
    #[inline(always)]
    fn from_slice<S: Scalar>(v: &[S], counts: RowCounts) -> Self::P<S> {
        let (own, last) = v.split_at(v.len() - counts[F::LISTS] * R::COUNT);
        let mut rows = Vec::with_capacity(counts[F::LISTS]);
        for row in last.chunks_exact(R::COUNT) {
            rows.push(R::from_slice(row, [0; MOST_LISTS]));
        }
        Listed { own: F::from_slice(own, counts), rows }
    }
    fn to_vec(p: &Self::P<f64>) -> Vec<f64> {
        F::to_vec(&p.own).into_iter().chain(p.rows.iter().flat_map(R::to_vec)).collect()
    }
}

/// A part without parameters.
pub struct NoParams;
impl Family for NoParams {
    type P<S: Scalar> = ();
    const FIELDS: &'static [Field] = &[];
    const DEFAULTS: &'static [Option<f64>] = &[];
    const COUNT: usize = 0;
    fn from_slice<S: Scalar>(_: &[S], _: RowCounts) {}
    fn to_vec(_: &()) -> Vec<f64> {
        Vec::new()
    }
}

/// Declares the parameters of a part once: name, shape (`scalar` or `lateral`), unit, bounds, default, meaning.
///
/// ```
/// use laval_model::{params, model::field::Bounds, model::params::Family};
/// params! {
///     /// Parameters of a stop.
///     pub struct StopParams in StopFamily {
///         stiffness: lateral, "N/m", Bounds::positive(1e15), required, "contact stiffness";
///         gap: scalar, "m", Bounds::up_to(1.0), default 0.0, "gap on each side";
///     }
/// }
/// let p = StopParams::new([1e6, 2e6]);
/// assert_eq!(StopFamily::to_vec(&p), [1e6, 2e6, 0.0]);
/// let with_gap = StopParams { gap: 1e-3, ..p };
/// ```
#[macro_export]
macro_rules! params {
    ($(#[$m:meta])* pub struct $p:ident in $fam:ident {
        $( $name:ident : $shape:ident, $unit:literal, $bounds:expr, $how:ident $($default:literal)?, $doc:literal; )*
    }) => {
        $(#[$m])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $p<S = f64> { $( #[doc = concat!($doc, ", `", $unit, "`")] pub $name: $crate::model::params::shape::$shape<S>, )* }
        #[doc = concat!("Marker that lifts [`", stringify!($p), "`] between scalars.")]
        pub struct $fam;
        impl $crate::model::params::Family for $fam {
            type P<S: $crate::laval_num::scalar::Scalar> = $p<S>;
            const FIELDS: &'static [$crate::model::field::Field] = &[ $(
                $crate::model::field::Field {
                    name: stringify!($name),
                    kind: $crate::params!(@kind $shape, $unit, $bounds),
                    required: $crate::params!(@required $how),
                    default: $crate::params!(@text $($default, $unit)?),
                    doc: $doc,
                }, )* ];
            const DEFAULTS: &'static [Option<f64>] = &[ $( $crate::params!(@value $($default)?), )* ];
            const COUNT: usize = 0 $( + $crate::params!(@len $shape) )*;
            #[inline(always)]
            #[allow(unused_mut, unused_variables, unused_assignments)]
            fn from_slice<S: $crate::laval_num::scalar::Scalar>(v: &[S], _: $crate::model::params::RowCounts) -> $p<S> {
                let mut i = 0;
                $( let $name = $crate::params!(@read $shape, v, i); i += $crate::params!(@len $shape); )*
                $p { $($name),* }
            }
            fn to_vec(p: &$p<f64>) -> Vec<f64> {
                let mut v = Vec::with_capacity(Self::COUNT);
                $( $crate::params!(@write $shape, v, p.$name); )*
                v
            }
        }
        $crate::params!(@new $p () () $( $name $shape $how $($default)?; )*);
    };
    (@new $p:ident ($($argument:tt)*) ($($field:tt)*)) => {
        #[allow(clippy::new_without_default, dead_code)]
        impl $p<f64> {
            /// The required parameters, in the order of the declaration; all others at their defaults.
            pub fn new($($argument)*) -> Self {
                $p { $($field)* }
            }
        }
    };
    (@new $p:ident ($($argument:tt)*) ($($field:tt)*) $name:ident scalar required; $($rest:tt)*) => {
        $crate::params!(@new $p ($($argument)* $name: f64,) ($($field)* $name,) $($rest)*);
    };
    (@new $p:ident ($($argument:tt)*) ($($field:tt)*) $name:ident lateral required; $($rest:tt)*) => {
        $crate::params!(@new $p ($($argument)* $name: [f64; 2],) ($($field)* $name,) $($rest)*);
    };
    (@new $p:ident ($($argument:tt)*) ($($field:tt)*) $name:ident $shape:ident default $default:literal; $($rest:tt)*) => {
        $crate::params!(@new $p ($($argument)*) ($($field)* $name: $crate::params!(@default $shape, $default),) $($rest)*);
    };
    (@len scalar) => { 1 };
    (@len lateral) => { 2 };
    (@kind scalar, $unit:literal, $b:expr) => { $crate::model::field::FieldKind::Quantity { unit: $unit, bounds: $b } };
    (@kind lateral, $unit:literal, $b:expr) => { $crate::model::field::FieldKind::Lateral { unit: $unit, bounds: $b } };
    (@required required) => { true };
    (@required default) => { false };
    (@value) => { None };
    (@value $d:literal) => { Some($d) };
    (@text) => { "" };
    (@text $d:literal, $unit:literal) => { concat!($d, " ", $unit) };
    (@read scalar, $v:ident, $i:ident) => { $v[$i] };
    (@read lateral, $v:ident, $i:ident) => { [$v[$i], $v[$i + 1]] };
    (@write scalar, $v:ident, $x:expr) => { $v.push($x) };
    (@write lateral, $v:ident, $x:expr) => { $v.extend($x) };
    (@default scalar, $d:literal) => { $d };
    (@default lateral, $d:literal) => { [$d; 2] };
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names and units of a machine file, digits for people.
    #[test]
    fn inadmissible_values_are_named_as_in_a_machine_file() {
        let slot = |name: &str, unit: &'static str, bounds: Bounds| ParamSlot { name: name.into(), unit, bounds, default: None };
        let k = Bounds::positive(1e15);
        let slots = [slot("stiffness.x", "N/m", k), slot("stiffness.y", "N/m", k), slot("mass", "kg", Bounds::closed(1.0, 2.0))];
        let of = |values: [f64; 3]| inadmissible(&slots, &values);
        assert!(of([1.0, 2.0, 1.5]).is_empty());
        assert_eq!(of([-2e6, -2e6, 1.5]), ["stiffness is -2 MN/m; it must be above 0 and at most 1e15 N/m"]);
        assert_eq!(of([1.0, -2e6, 1.5]), ["stiffness.y is -2 MN/m; it must be above 0 and at most 1e15 N/m"]);
        let apart = of([-1.0, -2e6, 0.300_000_000_000_000_04]);
        assert_eq!(apart.len(), 3, "{apart:?}");
        assert!(apart[0].starts_with("stiffness.x is -1 N/m;") && apart[1].starts_with("stiffness.y is -2 MN/m;"), "{apart:?}");
        assert_eq!(apart[2], "mass is 300 g; it must be between 1 kg and 2 kg");
        assert_eq!(of([f64::NAN, f64::NAN, 1.0]), ["stiffness is missing"]);
    }
}
