//! A motor: its torque on the rotor against speed, with the drag of bearings and windage and the inertia of its own rotor.
//!
//! Equations, the share of the spin row (inertia + drag - torque), spin speed W:
//!
//! ```text
//! J W' + c W - L(W)
//!
//! constant          L = T
//! linear            L = T (1 - W/W_s)
//! squirrel_cage     L = 2 T s s_k/(s^2 + s_k^2),   s = (W_s - W)/W_s            (Kloss)
//! limited_power     L = T while |W| < P/T, else P/|W|
//! table             L = T times the share through given points, constant outside
//! ```
//!
//! Symbols: T torque (at standstill; the breakdown torque of a squirrel cage; the largest of limited power), N m; W_s synchronous or no-load speed, rad/s; s slip, s_k
//! breakdown slip; P power, W; c drag, N m s; J inertia, kg m^2.
//!
//! The spin is a coordinate when the machine says `drive = "free"`. While it is prescribed, the torque of the drive that a study reports is what is needed
//! in addition to the motor's.
//!
//! Validity: slow changes of speed, so that the steady curve holds; no torsion between motor and rotor.
//!
//! Theory: `docs/theory/motors-and-run-up.md#torque-curves`.
//!
//! Sources: M. Kloss, Arch. Elektrotech. 5 (1916) 59; limited power after V. O. Kononenko, Vibrating Systems with a Limited Power Supply (Iliffe, 1969).

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::capability::{Extent, SpinDrive};
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::params::{RowCounts, RowFamily, WithRows};
use crate::model::part::{At, Energy, ErasedPart, Layout, Observed, Params, Part, Physics, Validity};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::interpolate::{Interpolant, Knots, Ordinates};
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`Motor`].
    pub struct MotorParams in MotorFamily {
        torque: scalar, "N m", Bounds::within(1e9), required, "torque T: at standstill, at breakdown for a squirrel cage, the largest for limited power, what the shares of a table are multiplied with";
        synchronous_speed: scalar, "rad/s", Bounds::up_to(1e6), default 0.0, "speed W_s at which the torque is zero";
        breakdown_slip: scalar, "", Bounds::positive(100.0), default 0.2, "slip s_k of the largest torque of a squirrel cage";
        power: scalar, "W", Bounds::up_to(1e12), default 0.0, "limit P of the power";
        drag: scalar, "N m s", Bounds::up_to(1e9), default 0.0, "drag c of bearings and windage: torque over speed";
        inertia: scalar, "kg m^2", Bounds::up_to(1e9), default 0.0, "moment of inertia J of the motor's rotor";
    }
}

params! {
    /// A row of the table of a [`Motor`].
    pub struct TorqueRow in TorqueRowFamily {
        share: scalar, "", Bounds::within(1e9), required, "torque there over torque";
    }
}

impl RowFamily for TorqueRowFamily {
    const LIST: &'static str = "table";
}

struct Shares<'a, S>(&'a [TorqueRow<S>]);

impl<S: Scalar> Ordinates<S> for Shares<'_, S> {
    #[inline(always)]
    fn at(&self, row: usize) -> S {
        self.0[row].share
    }
}

/// Torque against speed.
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// The same at every speed.
    Constant,
    /// Falls in a straight line to the no-load speed.
    Linear,
    /// Kloss's curve.
    SquirrelCage,
    /// Constant torque up to a power, constant power above.
    LimitedPower,
    /// Through points at these speeds, whose shares are parameters.
    Table(Knots),
}

/// See the [module](self).
pub struct Motor {
    curve: Curve,
}

impl Motor {
    /// With a torque curve.
    pub fn new(curve: Curve) -> Self {
        Motor { curve }
    }
    /// Torque at a speed, N m.
    #[inline(always)]
    pub fn torque<S: Scalar>(&self, p: &Params<Self, S>, speed: S) -> S {
        match &self.curve {
            // 0 times the speed: one that is not a number is not hidden
            Curve::Constant => p.torque + speed.scale(0.0),
            Curve::Linear => p.torque * (S::one() - speed / p.synchronous_speed),
            Curve::SquirrelCage => {
                let s = (p.synchronous_speed - speed) / p.synchronous_speed;
                (p.torque * s * p.breakdown_slip).scale(2.0) / (s * s + p.breakdown_slip * p.breakdown_slip)
            }
            Curve::LimitedPower => {
                let w = speed.abs();
                let over = w * p.torque - p.power;
                over.select_pos(p.power / over.select_pos(w, S::one()), p.torque) + over.scale(0.0)
            }
            Curve::Table(f) => p.torque * f.value_and_slope(&Shares(&p.rows), speed).0,
        }
    }
}

/// What each curve needs.
const NEEDS: &[(&str, &[&str])] =
    &[("linear", &["synchronous_speed"]), ("squirrel_cage", &["synchronous_speed"]), ("limited_power", &["power"])];

impl Part for Motor {
    const KIND: &'static str = "motor";
    const EXAMPLE: &'static str = r#"torque = "12 N m"
curve = "linear"
synchronous_speed = "3000 rpm"
inertia = "0.02 kg m^2"
"#;
    const DOC: &'static str = "A motor with a torque curve: constant, linear, squirrel cage, limited power or a table. With drive = \"free\" in the machine the \
        speed follows from its torque and what the vibration takes, so that it may be caught at a resonance.";
    type Family = WithRows<MotorFamily, TorqueRowFamily>;
    const FIELDS: &'static [Field] = &[
        Field::optional(
            "curve",
            FieldKind::Choice(&[
                ("constant", "torque at every speed"),
                ("linear", "torque at standstill falls in a straight line to zero at synchronous_speed"),
                ("squirrel_cage", "Kloss's curve: torque at breakdown, synchronous_speed, breakdown_slip"),
                ("limited_power", "torque up to the speed where it takes the power, less above"),
                ("table", "through the points of the table"),
            ]),
            "constant",
            "torque against speed",
        ),
        Field::optional(
            "table",
            FieldKind::Columns(&[("speed", "rad/s", true, "spin speed, increasing"), ("share", "", true, "torque there over torque")]),
            "",
            "torque at given speeds as shares of torque; between the rows a monotone cubic (PCHIP, slopes of Fritsch and Butland), constant outside",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let word = values.choice("curve").unwrap_or("constant");
        let before = diagnostics.0.len();
        let mut refuse = |field: &str, message: Text, help: Text| {
            diagnostics.push(Diagnostic::error("motor.curve", message).at(values.span_of(field)).help(help));
        };
        for name in NEEDS.iter().filter(|n| n.0 == word).flat_map(|n| n.1) {
            if params.get(name).is_none_or(|x| x == 0.0) {
                refuse("curve", text!("a motor with curve = \"{word}\" needs {name}", word, name), text!("add {name}", name));
            }
        }
        let curve = match (word, values.columns("table")) {
            ("table", None) => {
                refuse(
                    "curve",
                    text!("a motor with curve = \"table\" needs a table"),
                    text!("add table = {{ speed = [..], share = [..] }}"),
                );
                return None;
            }
            ("table", Some(columns)) => {
                let column = |name: &str| columns.get(name).map_or(&[][..], Vec::as_slice);
                // lengths and numbers as well as the speeds
                match Interpolant::new(column("speed"), column("share")).and_then(|_| Knots::new(column("speed"))) {
                    Ok(f) => Curve::Table(f),
                    Err(e) => {
                        refuse(
                            "table",
                            text!("the torque cannot be interpolated: {why}", why = e),
                            text!("speeds must increase from row to row"),
                        );
                        return None;
                    }
                }
            }
            (_, Some(_)) => {
                refuse(
                    "table",
                    text!("a table is given beside curve = \"{word}\"", word),
                    text!("say curve = \"table\", or take the table away"),
                );
                return None;
            }
            ("linear", None) => Curve::Linear,
            ("squirrel_cage", None) => Curve::SquirrelCage,
            ("limited_power", None) => Curve::LimitedPower,
            _ => Curve::Constant,
        };
        (diagnostics.0.len() == before).then_some(Motor { curve })
    }

    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::default()
    }
    /// Nothing but a share of the spin row.
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, _: &Params<Self, S>, _: S, _: &mut Blocks<S>) {}
    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        p.inertia * at.spin_accel + p.drag * at.speed - self.torque(p, at.speed)
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let w = at.speed;
        Some(Energy { stored: (p.inertia * w * w).scale(0.5), dissipated: p.drag * w * w, supplied: self.torque(p, w) * w })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        out.push(Observed { name: "torque", unit: "N m", value: self.torque(p, at.speed) });
        out.push(Observed { name: "power", unit: "W", value: self.torque(p, at.speed) * at.speed });
    }
    fn validity(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        // at a constant speed the torque moves nothing
        if let (Curve::Table(f), true) = (&self.curve, at.spin_accel != 0.0) {
            let (first, last) = f.range();
            let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
            // one row is a torque at every speed
            if half > 0.0 {
                let what = "distance of the speed from the middle of the torque table over half its range";
                out.push(Validity { what, ratio: (at.speed - middle).abs() / half });
            }
        }
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let mut wrong = Vec::new();
        if matches!(self.curve, Curve::Linear | Curve::SquirrelCage) && p.synchronous_speed == 0.0 {
            wrong.push(("synchronous_speed", text!("the torque curve needs a synchronous_speed above 0")));
        }
        if self.curve == Curve::LimitedPower && !(p.torque > 0.0 && p.power > 0.0) {
            wrong.push(("power", text!("limited power needs a torque and a power above 0")));
        }
        wrong
    }
    fn spin_drive(&self) -> Option<&dyn erased::SpinDrive> {
        Some(self)
    }
    #[inline(always)]
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for Motor {
    #[inline(always)]
    fn rows(&self) -> RowCounts {
        [if let Curve::Table(f) = &self.curve { f.count() } else { 0 }, 0]
    }
}

impl SpinDrive for Motor {
    fn torque(&self, p: &Params<Self, f64>, speed: f64) -> f64 {
        Motor::torque(self, p, speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::params::Listed;

    pub(super) fn table() -> Curve {
        Curve::Table(Knots::new(&[0.0, 200.0, 700.0]).unwrap())
    }
    pub(super) fn tabulated() -> Listed<MotorParams, TorqueRow> {
        Listed { own: params(), rows: [0.5, 1.0, 0.1].map(TorqueRow::new).to_vec() }
    }

    pub(super) fn params() -> MotorParams {
        MotorParams { torque: 3.0, synchronous_speed: 800.0, breakdown_slip: 0.2, power: 900.0, drag: 1e-3, inertia: 0.02 }
    }

    #[test]
    fn curves_have_their_marks() {
        let p = tabulated();
        let at = |curve: Curve, w: f64| Motor::new(curve).torque(&p, w);
        assert_eq!(at(Curve::Constant, 123.0), 3.0);
        assert_eq!((at(Curve::Linear, 0.0), at(Curve::Linear, 400.0), at(Curve::Linear, 800.0)), (3.0, 1.5, 0.0));
        // largest at the breakdown slip, and nothing at the synchronous speed
        let kloss = |w: f64| at(Curve::SquirrelCage, w);
        assert!((kloss(640.0) - 3.0).abs() < 1e-14 && kloss(630.0) < 3.0 && kloss(650.0) < 3.0 && kloss(800.0) == 0.0);
        let power = |w: f64| at(Curve::LimitedPower, w);
        assert_eq!((power(200.0), power(300.0), power(600.0), power(-600.0)), (3.0, 3.0, 1.5, 1.5));
        assert_eq!((at(table(), 0.0), at(table(), 200.0)), (1.5, 3.0));
        assert!((at(table(), 1e4) - 0.3).abs() < 1e-14);
        assert!(power(f64::NAN).is_nan() && at(Curve::Constant, f64::NAN).is_nan());
    }
}

#[cfg(test)]
mod mistakes {
    use super::*;
    use crate::model::field::Value;

    fn reported(curve: &'static str, table: Option<Value>, params: &[(&str, f64)]) -> String {
        let (mut values, mut given, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
        values.set("curve", Value::Choice(curve), None);
        if let Some(table) = table {
            values.set("table", table, None);
        }
        for (name, x) in params {
            given.set(name, *x);
        }
        let part = Motor::build(&values, &mut given, &mut d);
        assert_eq!(part.is_some(), d.0.is_empty());
        d.0.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn are_reported() {
        let table = |w: [f64; 2]| Some(Value::Columns([("speed", w.to_vec()), ("share", vec![1.0, 0.5])].into()));
        assert!(reported("linear", None, &[]).contains("needs synchronous_speed"));
        assert!(reported("limited_power", None, &[]).contains("needs power"));
        assert!(reported("table", None, &[]).contains("needs a table"));
        assert!(reported("linear", table([0.0, 1.0]), &[("synchronous_speed", 5.0)]).contains("a table is given beside curve"));
        assert!(reported("table", table([1.0, 1.0]), &[]).contains("row"));
        assert_eq!(reported("table", table([0.0, 1.0]), &[]), "");
        let p = MotorParams { torque: -1.0, ..tests::params() };
        assert_eq!(Motor::new(Curve::LimitedPower).check(&p.into())[0].0, "power");
        assert_eq!(Motor::new(Curve::Linear).check(&MotorParams { synchronous_speed: 0.0, ..p }.into())[0].0, "synchronous_speed");
    }
}

crate::conformance! {
    Motor {
        constant: Motor::new(Curve::Constant), tests::params(), Options::default();
        linear: Motor::new(Curve::Linear), tests::params(), Options::default();
        squirrel_cage: Motor::new(Curve::SquirrelCage), tests::params(), Options::default();
        limited_power: Motor::new(Curve::LimitedPower), tests::params(), Options::default();
        table: Motor::new(tests::table()), tests::tabulated(), Options::default();
    }
}
