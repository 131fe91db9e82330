//! A linear bearing or seal: eight coefficients on the deflection `d = (x, y)` of one point against another, constant, tabulated over speed, or
//! over speed and frequency of vibration.
//!
//! Equations, force on the first point (its opposite on the second):
//!
//! ```text
//! [Fx]     [kxx kxy] [x]   [cxx cxy] [x']
//! [Fy] = - [kyx kyy] [y] - [cyx cyy] [y']
//! ```
//!
//! A table is interpolated by a monotone piecewise cubic over the spin speed W (PCHIP, `laval_num::interpolate`), with exact derivatives over the speed and over
//! each coefficient of its rows. Beyond its ends it has no values unless `beyond` says
//! how it continues: as a constant, or along the tangents at its ends.
//!
//! A table over speed and frequency of vibration nu (tilting pads, gas seals, active bearings) gives the force in steady vibration at that frequency,
//!
//! ```text
//! Z(i nu) = K(W, nu) + i nu C(W, nu)
//! ```
//!
//! and has no form in time. A mode has the coefficients of its own frequency nu = |Im s|, one that does not oscillate those of nu = 0: no analytic function of s, so that
//! roots cannot be counted on it. With nu held (`FrequencyDomain::frozen`) it is a linear bearing like any other. Interpolation first over nu at each speed, then over W.
//!
//! `stiffness = k` is short for kxx = kyy = k, `damping = c` for cxx = cyy = c.
//!
//! Along the axis `Fz = -kzz z - czz z'`, at every speed.
//!
//! Symbols: kxx kxy kyx kyy stiffness, N/m; cxx cxy cyx cyy damping, N s/m; W spin speed, rad/s, from x towards y. `kxy = -dFx/dy`;
//! `kxy > 0 > kyx` drives forward whirl.
//!
//! Validity: small motion about the static position; coefficients without a column `frequency` belong to vibration at the frequency they were found for; speeds and
//! frequencies of the table.
//!
//! Theory: `docs/theory/machine.md#linear-bearings`.
//!
//! Sources: J. W. Lund, K. K. Thomsen (1978) as in every text on rotor bearings; signs as in API 684 and most codes; coefficients of tilting pads over the
//! frequency of vibration: J. K. Parsell, P. E. Allaire, L. E. Barrett, ASLE Trans. 26 (1983) 222. A data sheet that gives
//! F = +K q, or turns the other way, needs the signs of its terms changed.

mod asynchronous;
mod table;
#[cfg(test)]
mod tests;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::capability::{Extent, FrequencyDomain, Scope};
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::params::{Family, RowCounts, WithRows};
use crate::model::part::{
    At, Beyond, Energy, ErasedPart, Frozen, Layout, Link, Observed, Params, Part, Physics, PortKind, Tabulated, TimeForm, Validity,
};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;
use std::sync::Arc;
use table::{Coefficients, FREQUENCIES, NAMES, RANGE};

pub use table::{Table, TableRow, TableRowFamily};

params! {
    /// Parameters of a [`BearingLinear`]; unused when it has a table.
    pub struct BearingLinearParams in BearingLinearFamily {
        kxx: scalar, "N/m", Bounds::within(1e15), default 0.0, "stiffness in x against x";
        kxy: scalar, "N/m", Bounds::within(1e15), default 0.0, "force in -x per displacement in y";
        kyx: scalar, "N/m", Bounds::within(1e15), default 0.0, "force in -y per displacement in x";
        kyy: scalar, "N/m", Bounds::within(1e15), default 0.0, "stiffness in y against y";
        cxx: scalar, "N s/m", Bounds::within(1e12), default 0.0, "damping in x against x";
        cxy: scalar, "N s/m", Bounds::within(1e12), default 0.0, "force in -x per velocity in y";
        cyx: scalar, "N s/m", Bounds::within(1e12), default 0.0, "force in -y per velocity in x";
        cyy: scalar, "N s/m", Bounds::within(1e12), default 0.0, "damping in y against y";
        kzz: scalar, "N/m", Bounds::up_to(1e15), default 0.0, "stiffness along the axis, at every speed; when given, the bearing acts on axial motion";
        czz: scalar, "N s/m", Bounds::up_to(1e12), default 0.0, "damping along the axis, with kzz";
    }
}

/// One value for both coefficients of a shorthand.
const SHORT: [(&str, [&str; 2]); 2] = [("stiffness", ["kxx", "kyy"]), ("damping", ["cxx", "cyy"])];

/// See the [module](self).
pub struct BearingLinear {
    link: Link,
    table: Option<Arc<Table>>,
    /// It acts along the axis.
    axial: bool,
    /// Of a table over the frequency of vibration: the one whose coefficients it has at all of them.
    frozen: Option<Frozen>,
}

/// Local coordinate of the displacement along the axis.
const AXIAL: usize = 2;

/// Over the end of a table by which a frequency may be rounded.
const ROUNDED: f64 = 1e-9;

impl BearingLinear {
    /// With constant coefficients.
    pub fn constant(link: Link) -> Self {
        BearingLinear { link, table: None, axial: false, frozen: None }
    }
    /// With coefficients over the speeds (and frequencies) of a table; the coefficients themselves are parameters ([`Table::params`]).
    pub fn tabulated(link: Link, table: Table) -> Self {
        BearingLinear { table: Some(Arc::new(table)), ..BearingLinear::constant(link) }
    }
    /// With kzz and czz.
    pub fn axial(self) -> Self {
        BearingLinear { axial: true, ..self }
    }
    /// Its coefficients depend on the frequency of vibration, which is not held.
    fn asynchronous(&self) -> Option<&Table> {
        self.table.as_deref().filter(|t| self.frozen.is_none() && t.frequencies().is_some())
    }
    /// Frequency whose coefficients it has, and how that rises with the speed.
    #[inline(always)]
    fn frequency<S: Scalar>(&self, speed: S) -> (S, S) {
        match self.frozen {
            None => (S::zero(), S::zero()),
            Some(Frozen::At(frequency)) => (S::cst(frequency), S::zero()),
            Some(Frozen::Order(order)) => (speed.abs().scale(order), speed.select_pos(S::cst(order), S::cst(-order))),
        }
    }
    #[inline(always)]
    fn values<S: Scalar>(&self, p: &Params<Self, S>, speed: S) -> [S; 8] {
        match &self.table {
            None => [p.kxx, p.kxy, p.kyx, p.kyy, p.cxx, p.cxy, p.cyx, p.cyy],
            Some(table) => table.values(&p.rows, speed, self.frequency(speed).0),
        }
    }
    #[inline(always)]
    fn coefficients<S: Scalar>(&self, p: &Params<Self, S>, speed: S) -> Coefficients<S> {
        match &self.table {
            None => Coefficients { value: self.values(p, speed), slope: [S::zero(); 8] },
            Some(table) => {
                let (frequency, rate) = self.frequency(speed);
                table.coefficients(&p.rows, speed, frequency, rate)
            }
        }
    }
}

/// `(x, y) -> (a x + b y, c x + d y)`.
#[inline(always)]
fn apply<S: Scalar>(k: &[S], x: &[S]) -> [S; 2] {
    [k[0] * x[0] + k[1] * x[1], k[2] * x[0] + k[3] * x[1]]
}

impl Part for BearingLinear {
    const KIND: &'static str = "bearing_linear";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
kxx = "2e7 N/m"
kxy = "5e6 N/m"
kyx = "-5e6 N/m"
kyy = "3e7 N/m"
cxx = "2e4 N s/m"
cyy = "3e4 N s/m"
"#;
    const DOC: &'static str = "A bearing or seal given by its eight linear coefficients kxx kxy kyx kyy cxx cxy cyx cyy, constant, in a table \
        over speed, or in one over speed and frequency of vibration. The force on the first point is -K d - C d'; kxy > 0 > kyx drives forward whirl.";
    type Family = WithRows<BearingLinearFamily, TableRowFamily>;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the two points it joins"),
        Field::optional(
            "table",
            FieldKind::Columns(&[
                ("speed", "rad/s", true, "spin speed, increasing from row to row where no frequency is given"),
                (
                    "frequency",
                    "rad/s",
                    false,
                    "frequency of vibration; the rows are then all pairs of the speeds and frequencies, in any order",
                ),
                ("kxx", "N/m", true, "stiffness in x against x"),
                ("kxy", "N/m", false, "force in -x per displacement in y"),
                ("kyx", "N/m", false, "force in -y per displacement in x"),
                ("kyy", "N/m", true, "stiffness in y against y"),
                ("cxx", "N s/m", false, "damping in x against x"),
                ("cxy", "N s/m", false, "force in -x per velocity in y"),
                ("cyx", "N s/m", false, "force in -y per velocity in x"),
                ("cyy", "N s/m", false, "damping in y against y"),
            ]),
            "",
            "coefficients over speed, or over speed and frequency of vibration, instead of constant ones; between the rows each column is a monotone cubic (PCHIP, slopes of Fritsch and Butland), which stays between \
                the values of neighbouring rows; two rows are joined by a straight line; with frequencies first over \
                the frequency at each speed, then over the speed",
        ),
        Field::optional(
            "beyond",
            FieldKind::Choice(&[
                ("refuse", "a study beyond the speeds or frequencies of the table is refused"),
                ("hold", "the first and last row hold beyond; results there are marked as outside the table"),
                ("linear", "straight on along the slope at the ends; results there are marked as outside the table"),
            ]),
            "refuse",
            "coefficients at speeds and frequencies outside the table",
        ),
        Field::optional(
            "stiffness",
            FieldKind::Quantity { unit: "N/m", bounds: Bounds::within(1e15) },
            "",
            "one stiffness in all directions, instead of kxx and kyy",
        ),
        Field::optional(
            "damping",
            FieldKind::Quantity { unit: "N s/m", bounds: Bounds::within(1e12) },
            "",
            "one damping in all directions, instead of cxx and cyy",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        let link = Link::Between(a, b);
        for (short, both) in SHORT {
            let Some(value) = values.number(short) else { continue };
            if let Some(twice) = both.into_iter().find(|name| params.get(name).is_some_and(|x| x != 0.0)) {
                diagnostics.push(
                    Diagnostic::error("bearing_linear.twice", text!("{short} is given beside {twice}", short, twice))
                        .at(values.span_of(short))
                        .help(text!(
                            "{short} stands for {first} and {second}: give the one value or these two",
                            short,
                            first = both[0],
                            second = both[1]
                        )),
                );
            }
            for name in both {
                params.set(name, value);
            }
        }
        let beyond = match values.choice("beyond") {
            Some("hold") => Beyond::Hold,
            Some("linear") => Beyond::Linear,
            _ => Beyond::Refuse,
        };
        let axial = params.get("kzz").is_some_and(|x| x != 0.0);
        let along = |bearing: BearingLinear| if axial { bearing.axial() } else { bearing };
        let given: Vec<&str> = NAMES.into_iter().filter(|name| params.get(name).is_some_and(|x| x != 0.0)).collect();
        let Some(columns) = values.columns("table") else {
            if given.is_empty() && !axial {
                diagnostics.push(
                    Diagnostic::error("bearing_linear.empty", text!("the bearing has no coefficient: all eight are zero"))
                        .at(values.span.clone())
                        .help(text!("give stiffness, or kxx and kyy (and what else it has), or a table over speed")),
                );
            }
            if values.written("beyond") {
                diagnostics.push(
                    Diagnostic::error("bearing_linear.beyond", text!("beyond is given without a table"))
                        .at(values.span_of("beyond"))
                        .help(text!("constant coefficients hold at every speed: take beyond away, or give a table over speed")),
                );
            }
            return Some(along(BearingLinear::constant(link)));
        };
        if let Some(name) = given.first() {
            let name = SHORT.into_iter().find(|s| s.1.contains(name) && values.number(s.0).is_some()).map_or(*name, |s| s.0);
            diagnostics.push(
                Diagnostic::error("bearing_linear.twice", text!("{name} is given as a constant beside a table", name))
                    .at(values.span_of(name))
                    .help(text!("a bearing has constant coefficients or a table: put constants into the table as equal rows")),
            );
        }
        match Table::new(columns.get("speed").map_or(&[][..], Vec::as_slice), |name| columns.get(name).cloned()) {
            Ok(table) => Some(along(BearingLinear::tabulated(link, table.beyond(beyond)))),
            Err(wrong) => {
                for message in wrong {
                    diagnostics.push(Diagnostic::error("bearing_linear.table", message).at(values.span_of("table")));
                }
                None
            }
        }
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::on(PortKind { axial: self.axial, ..PortKind::POINT }, self.link.clone())
    }
    #[inline(always)]
    fn physics(&self) -> Physics {
        match self.asynchronous() {
            None => Physics::Linear,
            Some(_) => Physics::Frequency(TimeForm::None("its coefficients are a table over the frequency of vibration")),
        }
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, speed: S, b: &mut Blocks<S>) {
        if self.asynchronous().is_some() {
            return;
        }
        let k = self.values(p, speed);
        for i in 0..2 {
            for j in 0..2 {
                b.stiffness[(i, j)] = k[2 * i + j];
                b.damping[(i, j)] = k[4 + 2 * i + j];
            }
        }
        if self.axial {
            b.stiffness[(AXIAL, AXIAL)] = p.kzz;
            b.damping[(AXIAL, AXIAL)] = p.czz;
        }
    }
    /// The symmetric part of K stores; the skew part and a change of K with speed bring power in (from the drive, through the film).
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        if self.asynchronous().is_some() {
            return None;
        }
        let Coefficients { value, slope } = self.coefficients(p, at.speed);
        let quadratic = |k: &[S]| {
            let f = apply(k, at.q);
            (at.q[0] * f[0] + at.q[1] * f[1]).scale(0.5)
        };
        let damping = apply(&value[4..], at.v);
        let skew = (value[1] - value[2]).scale(0.5);
        let (stored, dissipated) = match self.axial {
            true => ((p.kzz * at.q[AXIAL].square()).scale(0.5), p.czz * at.v[AXIAL].square()),
            false => (S::zero(), S::zero()),
        };
        Some(Energy {
            stored: stored + quadratic(&value[..4]),
            dissipated: dissipated + at.v[0] * damping[0] + at.v[1] * damping[1],
            supplied: skew * (at.v[1] * at.q[0] - at.v[0] * at.q[1]) + at.spin_accel * quadratic(&slope[..4]),
        })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        if self.asynchronous().is_some() {
            return;
        }
        let k = self.values(p, at.speed);
        let (elastic, viscous) = (apply(&k[..4], at.q), apply(&k[4..], at.v));
        out.push(Observed { name: "force", unit: "N", value: (elastic[0] + viscous[0]).hypot(elastic[1] + viscous[1]) });
    }
    fn validity(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        if let Some(table) = &self.table {
            // 1 at either end
            let used = |(first, last): (f64, f64), x: f64| {
                let ratio = (x - 0.5 * (first + last)).abs() / (0.5 * (last - first));
                // the ends belong to the table, whatever rounding makes of them
                if ratio <= 1.0 + ROUNDED { ratio.min(1.0) } else { ratio }
            };
            out.push(Validity { what: RANGE, ratio: used(table.range(), at.speed) });
            if let (Some(range), Some(_)) = (table.frequencies(), self.frozen) {
                // of a speed that is no number none is
                let ratio = used(range, self.frequency(at.speed).0) + 0.0 * at.speed;
                out.push(Validity { what: FREQUENCIES, ratio });
            }
        }
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        if !self.axial && (p.kzz != 0.0 || p.czz != 0.0) {
            return vec![("kzz", text!("this bearing was built without kzz"))];
        }
        let constants = BearingLinearFamily::to_vec(&p.own);
        if self.table.is_some() && constants[..NAMES.len()].iter().any(|x| *x != 0.0) {
            return vec![("table", text!("the coefficients come from the table: a constant beside it has no effect"))];
        }
        Vec::new()
    }
    fn scope(&self) -> Option<&dyn erased::Scope> {
        Some(self)
    }
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        self.asynchronous().is_some().then_some(self)
    }
    #[inline(always)]
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for BearingLinear {
    #[inline(always)]
    fn rows(&self) -> RowCounts {
        [self.table.as_deref().map_or(0, Table::count), 0]
    }
    fn is_steady(&self) -> bool {
        self.table.is_none()
    }
}

impl Scope for BearingLinear {
    fn tabulated(&self) -> Option<Tabulated> {
        let table = self.table.as_ref()?;
        let (from, to) = table.range();
        Some(Tabulated { from, to, beyond: table.rule(), statement: RANGE })
    }
    fn table_speeds(&self) -> Vec<f64> {
        self.table.as_ref().map_or_else(Vec::new, |t| t.speeds().to_vec())
    }
}

impl FrequencyDomain for BearingLinear {
    /// Derivatives over s are those along the real axis, where the frequency stays.
    fn impedance<S: Scalar>(&self, p: &Params<Self, S>, s: Complex<S>, speed: S, out: &mut [Complex<S>]) {
        let Some(table) = self.asynchronous() else { return };
        let k = table.values(&p.rows, speed, s.im.abs());
        let n = if self.axial { AXIAL + 1 } else { 2 };
        let force = |stiffness: S, damping: S| s.scale(damping) + c(stiffness, S::zero());
        for i in 0..2 {
            for j in 0..2 {
                out[n * i + j] += force(k[2 * i + j], k[4 + 2 * i + j]);
            }
        }
        if self.axial {
            out[n * AXIAL + AXIAL] += force(p.kzz, p.czz);
        }
    }
    fn frequencies(&self) -> Option<Tabulated> {
        let table = self.asynchronous()?;
        let (from, to) = table.frequencies()?;
        Some(Tabulated { from, to, beyond: table.rule(), statement: FREQUENCIES })
    }
    fn frozen(&self, at: Frozen) -> Option<Self> {
        self.asynchronous()?;
        Some(BearingLinear { link: self.link.clone(), table: self.table.clone(), axial: self.axial, frozen: Some(at) })
    }
}

crate::conformance! {
    BearingLinear {
        constant: BearingLinear::constant(tests::link()),
            BearingLinearParams { kxx: 1e6, kxy: 2e5, kyx: -3e5, kyy: 2e6, cxx: 500.0, cxy: -60.0, cyx: 70.0, cyy: 800.0, kzz: 0.0, czz: 0.0 },
            Options::anisotropic();
        isotropic: BearingLinear::constant(tests::link()),
            BearingLinearParams { kxx: 1e6, kxy: 2e5, kyx: -2e5, kyy: 1e6, cxx: 500.0, cxy: -60.0, cyx: 60.0, cyy: 500.0, kzz: 0.0, czz: 0.0 },
            Options::default();
        axial: BearingLinear::constant(tests::link()).axial(), BearingLinearParams { kxx: 1e6, kyy: 1e6, kzz: 2e5, czz: 90.0, ..BearingLinearParams::new() },
            Options::default();
        tabulated: BearingLinear::tabulated(tests::link(), tests::table()), tests::table().params(),
            Options { speed: 630.0, ..Options::anisotropic() };
        straight_on: BearingLinear::tabulated(tests::link(), tests::table().beyond(Beyond::Linear)), tests::table().params(),
            Options { speed: 630.0, ..Options::anisotropic() };
        over_frequency: BearingLinear::tabulated(tests::link(), tests::grid()), tests::grid().params(),
            Options { speed: 550.0, energy: false, ..Options::default() };
        at_a_frequency: BearingLinear::tabulated(tests::link(), tests::grid()).frozen(Frozen::At(130.0)).unwrap(), tests::grid().params(),
            Options { speed: 550.0, ..Options::anisotropic() };
        synchronous: BearingLinear::tabulated(tests::link(), tests::grid()).frozen(Frozen::Order(1.0)).unwrap(), tests::grid().params(),
            Options { speed: 550.0, ..Options::anisotropic() };
        straight_on_over_frequency: BearingLinear::tabulated(tests::link(), tests::grid().beyond(Beyond::Linear)).axial().frozen(Frozen::Order(1.7)).unwrap(),
            crate::model::params::Listed { own: BearingLinearParams { kzz: 2e5, czz: 90.0, ..BearingLinearParams::new() }, rows: tests::grid().params().rows },
            Options { speed: 630.0, ..Options::anisotropic() };
    }
}
