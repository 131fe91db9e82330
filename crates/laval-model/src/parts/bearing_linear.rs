//! A linear bearing or seal: eight coefficients on the deflection `d = (x, y)` of one point against another, constant or tabulated over speed.
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
//! `stiffness = k` is short for kxx = kyy = k, `damping = c` for cxx = cyy = c.
//!
//! Along the axis `Fz = -kzz z - czz z'`, at every speed.
//!
//! Symbols: kxx kxy kyx kyy stiffness, N/m; cxx cxy cyx cyy damping, N s/m; W spin speed, rad/s, from x towards y. `kxy = -dFx/dy`;
//! `kxy > 0 > kyx` drives forward whirl.
//!
//! Validity: small motion about the static position; coefficients belong to vibration at the frequency they were found for; speeds of the table.
//!
//! Theory: `docs/theory/machine.md#linear-bearings`.
//!
//! Sources: J. W. Lund, K. K. Thomsen (1978) as in every text on rotor bearings; signs as in API 684 and most codes. A data sheet that gives
//! F = +K q, or turns the other way, needs the signs of its terms changed.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::capability::{Extent, Scope};
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::params::{Family, Listed, RowCounts, RowFamily, WithRows};
use crate::model::part::{At, Beyond, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, PortKind, Tabulated, Validity};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::interpolate::{Knots, Ordinates, TableError};
use laval_num::scalar::Scalar;
use std::sync::Arc;

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

params! {
    /// Coefficients in a row of the table of a [`BearingLinear`].
    pub struct TableRow in TableRowFamily {
        kxx: scalar, "N/m", Bounds::within(1e15), default 0.0, "stiffness in x against x";
        kxy: scalar, "N/m", Bounds::within(1e15), default 0.0, "force in -x per displacement in y";
        kyx: scalar, "N/m", Bounds::within(1e15), default 0.0, "force in -y per displacement in x";
        kyy: scalar, "N/m", Bounds::within(1e15), default 0.0, "stiffness in y against y";
        cxx: scalar, "N s/m", Bounds::within(1e12), default 0.0, "damping in x against x";
        cxy: scalar, "N s/m", Bounds::within(1e12), default 0.0, "force in -x per velocity in y";
        cyx: scalar, "N s/m", Bounds::within(1e12), default 0.0, "force in -y per velocity in x";
        cyy: scalar, "N s/m", Bounds::within(1e12), default 0.0, "damping in y against y";
    }
}

impl RowFamily for TableRowFamily {
    const LIST: &'static str = "table";
}

/// A column of the table by its place in [`NAMES`].
struct Column<'a, S>(&'a [TableRow<S>], usize);

impl<S: Scalar> Ordinates<S> for Column<'_, S> {
    #[inline(always)]
    fn at(&self, row: usize) -> S {
        let r = &self.0[row];
        match self.1 {
            0 => r.kxx,
            1 => r.kxy,
            2 => r.kyx,
            3 => r.kyy,
            4 => r.cxx,
            5 => r.cxy,
            6 => r.cyx,
            _ => r.cyy,
        }
    }
}

/// The coefficients in order: kxx kxy kyx kyy cxx cxy cyx cyy.
const NAMES: [&str; 8] = ["kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"];

/// One value for both coefficients of a shorthand.
const SHORT: [(&str, [&str; 2]); 2] = [("stiffness", ["kxx", "kyy"]), ("damping", ["cxx", "cyy"])];

/// What limits a table, as a statement of validity.
const RANGE: &str = "distance of the speed from the middle of the bearing table over half its range";

/// Coefficients over speed; a coefficient without a column is zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    speeds: Knots,
    rows: Vec<TableRow>,
    beyond: Beyond,
}

impl Table {
    /// From increasing speeds (rad/s, at least two) and columns by coefficient name; every mistake is one sentence.
    pub fn new(speed: &[f64], column: impl Fn(&str) -> Option<Vec<f64>>) -> Result<Self, Vec<Text>> {
        let mut wrong = Vec::new();
        let speeds = Knots::new(speed);
        if speed.len() < 2 {
            wrong.push(text!("a table over speed has at least two rows; for one speed give the coefficients themselves"));
        } else if let Err(error) = &speeds {
            let error = *error;
            wrong.push(match error {
                TableError::NotIncreasing(row) => {
                    let shown = |w: f64| text::quantity(w, "rad/s");
                    text!(
                        "speeds must increase from row to row: row {number} has {speed} after {before}",
                        number = row + 1,
                        speed = shown(speed[row]),
                        before = shown(speed[row - 1])
                    )
                }
                other => text!("column speed: {why}", why = other),
            });
        }
        let columns = NAMES.map(|name| {
            let Some(values) = column(name) else { return Some(vec![0.0; speed.len()]) };
            if values.len() != speed.len() {
                wrong.push(text!(
                    "column {name} has {values} rows and column speed has {speed}",
                    name,
                    values = values.len(),
                    speed = speed.len()
                ));
                return None;
            }
            if let Some(row) = values.iter().position(|v| !v.is_finite()) {
                wrong.push(text!("column {name}: row {number} is not a finite number", name, number = row + 1));
            }
            Some(values)
        });
        let columns: Option<Vec<Vec<f64>>> = columns.into_iter().collect();
        let (Ok(speeds), Some(columns), true) = (speeds, columns, wrong.is_empty()) else { return Err(wrong) };
        let row = |k: usize| TableRowFamily::from_slice(&columns.iter().map(|c| c[k]).collect::<Vec<_>>(), RowCounts::default());
        Ok(Table { speeds, rows: (0..speed.len()).map(row).collect(), beyond: Beyond::Refuse })
    }

    /// The same, continued like this outside its range.
    #[must_use]
    pub fn beyond(self, beyond: Beyond) -> Self {
        let speeds = if beyond == Beyond::Linear { self.speeds.straight_outside() } else { self.speeds };
        Table { speeds, beyond, ..self }
    }

    /// Its coefficients as the parameters of a bearing.
    pub fn params(&self) -> Params<BearingLinear, f64> {
        Listed { own: BearingLinearParams::new(), rows: self.rows.clone() }
    }

    /// First and last speed, rad/s.
    pub fn range(&self) -> (f64, f64) {
        self.speeds.range()
    }
}

/// See the [module](self).
pub struct BearingLinear {
    link: Link,
    table: Option<Table>,
    /// It acts along the axis.
    axial: bool,
}

/// Local coordinate of the displacement along the axis.
const AXIAL: usize = 2;

/// Coefficients and their derivatives over speed.
struct Coefficients<S> {
    value: [S; 8],
    slope: [S; 8],
}

impl BearingLinear {
    /// With constant coefficients.
    pub fn constant(link: Link) -> Self {
        BearingLinear { link, table: None, axial: false }
    }
    /// With coefficients over the speeds of a table; the coefficients themselves are parameters ([`Table::params`]).
    pub fn tabulated(link: Link, table: Table) -> Self {
        BearingLinear { link, table: Some(table), axial: false }
    }
    /// With kzz and czz.
    pub fn axial(self) -> Self {
        BearingLinear { axial: true, ..self }
    }
    #[inline(always)]
    fn coefficients<S: Scalar>(&self, p: &Params<Self, S>, speed: S) -> Coefficients<S> {
        match &self.table {
            None => Coefficients { value: [p.kxx, p.kxy, p.kyx, p.kyy, p.cxx, p.cxy, p.cyx, p.cyy], slope: [S::zero(); 8] },
            Some(table) => {
                let mut out = Coefficients { value: [S::zero(); 8], slope: [S::zero(); 8] };
                for i in 0..NAMES.len() {
                    let column = Column(&p.rows, i);
                    let mut empty = true;
                    for k in 0..p.rows.len() {
                        empty &= column.at(k).is_nothing();
                    }
                    if !empty {
                        (out.value[i], out.slope[i]) = table.speeds.value_and_slope(&column, speed);
                    }
                }
                out
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
    const DOC: &'static str = "A bearing or seal given by its eight linear coefficients kxx kxy kyx kyy cxx cxy cyx cyy, constant or in a table \
        over speed. The force on the first point is -K d - C d'; kxy > 0 > kyx drives forward whirl.";
    type Family = WithRows<BearingLinearFamily, TableRowFamily>;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the two points it joins"),
        Field::optional(
            "table",
            FieldKind::Columns(&[
                ("speed", "rad/s", true, "spin speed, increasing"),
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
            "coefficients over speed, instead of constant ones; between the rows each column is a monotone cubic (PCHIP, slopes of Fritsch and Butland), which stays between \
                the values of neighbouring rows; two rows are joined by a straight line",
        ),
        Field::optional(
            "beyond",
            FieldKind::Choice(&[
                ("refuse", "a study beyond the speeds of the table is refused"),
                ("hold", "the first and last row hold beyond; results there are marked as outside the table"),
                ("linear", "straight on along the slope at the ends; results there are marked as outside the table"),
            ]),
            "refuse",
            "coefficients at speeds outside the table",
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
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, speed: S, b: &mut Blocks<S>) {
        let k = self.coefficients(p, speed).value;
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
        let k = self.coefficients(p, at.speed).value;
        let (elastic, viscous) = (apply(&k[..4], at.q), apply(&k[4..], at.v));
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "force", unit: "N", value: (elastic[0] + viscous[0]).hypot(elastic[1] + viscous[1]) });
    }
    fn validity(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        if let Some(table) = &self.table {
            let (first, last) = table.range();
            let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
            // 1 at either end of the table
            out.push(Validity { what: RANGE, ratio: (at.speed - middle).abs() / half });
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
    #[inline(always)]
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for BearingLinear {
    #[inline(always)]
    fn rows(&self) -> RowCounts {
        [self.table.as_ref().map_or(0, |t| t.speeds.count()), 0]
    }
}

impl Scope for BearingLinear {
    fn tabulated(&self) -> Option<Tabulated> {
        let table = self.table.as_ref()?;
        let (from, to) = table.range();
        Some(Tabulated { from, to, beyond: table.beyond, statement: RANGE })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::conformance::local_stiffness;
    use crate::model::field::{Attach, Value};
    use laval_num::complex::c;
    use std::collections::BTreeMap;

    pub(super) fn link() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }
    pub(super) fn table() -> Table {
        let columns = |name: &str| match name {
            "kxx" => Some(vec![1e6, 3e6, 4e6, 3.5e6]),
            "kyy" => Some(vec![2e6, 2.5e6, 2.6e6, 5e6]),
            "kxy" => Some(vec![1e5, 4e5, 9e5, 1.2e6]),
            "kyx" => Some(vec![-2e5, -3e5, -8e5, -9e5]),
            "cxx" => Some(vec![900.0, 700.0, 500.0, 400.0]),
            "cxy" => Some(vec![90.0, 70.0, -50.0, 40.0]),
            "cyy" => Some(vec![800.0, 810.0, 700.0, 100.0]),
            _ => None,
        };
        Table::new(&[50.0, 200.0, 350.0, 600.0], columns).unwrap()
    }
    fn build(f: impl Fn(&mut Values, &mut ParamValues)) -> (Option<BearingLinear>, Vec<String>) {
        let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
        values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
        f(&mut values, &mut params);
        let part = BearingLinear::build(&values, &mut params, &mut d);
        (part, d.0.iter().map(|d| d.to_string()).collect())
    }
    fn columns(speed: &[f64], kxx: &[f64]) -> Value {
        Value::Columns(BTreeMap::from([("speed", speed.to_vec()), ("kxx", kxx.to_vec()), ("kyy", vec![1e6; speed.len()])]))
    }

    #[test]
    fn coefficients_stand_where_the_convention_says() {
        let p = BearingLinearParams { kxx: 1.0, kxy: 2.0, kyx: 3.0, kyy: 4.0, cxx: 5.0, cxy: 6.0, cyx: 7.0, cyy: 8.0, kzz: 0.0, czz: 0.0 };
        let mut b = Blocks::default();
        b.reset(2, 0, 100.0);
        BearingLinear::constant(link()).linear(&p.into(), 100.0, &mut b);
        let z = local_stiffness(&b, c(0.0, 10.0)).unwrap();
        assert_eq!((z[(0, 1)], z[(1, 0)]), (c(2.0, 60.0), c(3.0, 70.0)));
        assert_eq!((z[(0, 0)], z[(1, 1)]), (c(1.0, 50.0), c(4.0, 80.0)));
    }

    /// A forward circle at deflection r receives pi r^2 (kxy - kyx) per turn, a backward one loses it.
    #[test]
    fn positive_kxy_with_negative_kyx_feeds_forward_whirl() {
        let p = BearingLinearParams { kxy: 3e5, kyx: -1e5, ..BearingLinearParams::new() };
        let bearing = BearingLinear::constant(link());
        for (direction, sign) in [(1.0, 1.0), (-1.0, -1.0)] {
            let (q, v) = ([1e-3, 0.0], [0.0, direction * 1e-3 * 200.0]);
            let at = At { q: &q, v: &v, a: &[0.0; 2], z: &[], phase: 0.0, speed: 300.0, spin_accel: 0.0, t: 0.0 };
            let e = bearing.energy(&p.into(), &at).unwrap();
            let per_turn = e.supplied * std::f64::consts::TAU / 200.0;
            assert!((per_turn - sign * std::f64::consts::PI * 1e-6 * 4e5).abs() < 1e-12);
        }
    }

    /// The harmonic mean of the slopes beside an inner row, weighted by `p = 2 h_i + h_{i-1}` and `r = h_i + 2 h_{i-1}`, and no slope where the column turns.
    #[test]
    fn between_its_rows_a_table_is_the_cubic_that_its_documentation_names() {
        let field = BearingLinear::FIELDS.iter().find(|f| f.name == "table").unwrap();
        assert!(field.doc.contains("monotone cubic") && field.doc.contains("PCHIP"), "{}", field.doc);
        let kxx = |speed: f64| BearingLinear::tabulated(link(), table()).coefficients(&table().params(), speed).value[0];
        let (d0, d1, h) = (2e6 / 150.0, 1e6 / 150.0, 150.0);
        let (s1, s2) = (6.0 * h / (3.0 * h / d0 + 3.0 * h / d1), 0.0);
        // cubic Hermite in the middle of the second interval
        let middle = 0.5 * (3e6 + 4e6) + h / 8.0 * (s1 - s2);
        assert!((kxx(275.0) / middle - 1.0).abs() < 1e-12, "{} {middle}", kxx(275.0));
        for k in 0..=60 {
            let speed = 350.0 + 250.0 * f64::from(k) / 60.0;
            assert!((3.5e6 - 1e-3..=4e6 + 1e-3).contains(&kxx(speed)), "{speed}");
        }
    }

    #[test]
    fn a_table_is_exact_at_its_rows_and_marks_speeds_outside() {
        let bearing = BearingLinear::tabulated(link(), table());
        let p = table().params();
        for (speed, kxx, inside) in [(200.0, 3e6, true), (600.0, 3.5e6, true), (900.0, 3.5e6, false), (49.0, 1e6, false)] {
            assert!((bearing.coefficients(&p, speed).value[0] - kxx).abs() < 1e-6);
            let at = At { q: &[0.0; 2], v: &[0.0; 2], a: &[0.0; 2], z: &[], phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
            let mut v = Vec::new();
            bearing.validity(&p, &at, &mut v);
            assert_eq!(v[0].ratio <= 1.0, inside, "{speed}");
        }
    }

    #[test]
    fn mistakes_are_reported() {
        let (part, text) = build(|v, _| v.set("table", columns(&[100.0, 300.0, 200.0], &[1e6; 3]), None));
        assert!(part.is_none());
        assert_eq!(text, ["speeds must increase from row to row: row 3 has 200 rad/s (1910 rpm) after 300 rad/s (2865 rpm)"]);
        let (_, text) = build(|v, _| v.set("table", columns(&[100.0, 300.0], &[1e6; 3]), None));
        assert_eq!(text, ["column kxx has 3 rows and column speed has 2"]);
        let (_, text) = build(|v, _| v.set("table", columns(&[100.0], &[1e6]), None));
        assert!(text[0].contains("at least two rows"));
        let (_, text) = build(|v, _| v.set("table", columns(&[100.0, 200.0], &[1e6, f64::NAN]), None));
        assert_eq!(text, ["column kxx: row 2 is not a finite number"]);
        let (_, text) = build(|v, p| {
            v.set("table", columns(&[100.0, 200.0], &[1e6; 2]), None);
            p.set("cxx", 3.0);
        });
        assert!(text[0].contains("cxx is given as a constant beside a table"));
        assert!(build(|_, _| ()).1[0].contains("all eight are zero"));
        assert!(build(|_, p| p.set("kxx", 1e6)).1.is_empty());
        let (_, text) = build(|v, p| {
            p.set("kxx", 1e6);
            v.set("beyond", Value::Choice("hold"), Some(0..1));
        });
        assert!(text[0].contains("without a table"));
        let (_, text) = build(|v, _| {
            v.set("table", columns(&[100.0, 200.0], &[1e6; 2]), None);
            v.set("damping", Value::Number(3.0), None);
        });
        assert!(text[0].contains("damping is given as a constant beside a table"));
    }

    /// `stiffness` and `damping` are kxx = kyy and cxx = cyy, and nothing beside these.
    #[test]
    fn one_value_stands_for_both_directions() {
        let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
        values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
        values.set("stiffness", Value::Number(2e6), None);
        values.set("damping", Value::Number(300.0), None);
        params.set("kxy", 1e5);
        assert!(BearingLinear::build(&values, &mut params, &mut d).is_some() && d.0.is_empty());
        let is = |name: &str, x: f64| params.get(name) == Some(x);
        assert!(is("kxx", 2e6) && is("kyy", 2e6) && is("cxx", 300.0) && is("cyy", 300.0) && is("kxy", 1e5));
        let (_, text) = build(|v, p| {
            v.set("stiffness", Value::Number(2e6), None);
            p.set("kyy", 1e6);
        });
        assert!(text.len() == 1 && text[0].starts_with("stiffness is given beside kyy"), "{text:?}");
    }

    #[test]
    fn beyond_its_ends_a_table_holds_or_goes_straight_on() {
        let p = table().params();
        let kxx = |beyond, speed| BearingLinear::tabulated(link(), table().beyond(beyond)).coefficients(&p, speed);
        let end = kxx(Beyond::Hold, 600.0 - 1e-6).slope[0];
        let (held, straight) = (kxx(Beyond::Hold, 700.0), kxx(Beyond::Linear, 700.0));
        assert!((held.value[0] - 3.5e6).abs() < 1e-3 && held.slope[0] == 0.0);
        assert!((straight.value[0] - 3.5e6 - 100.0 * end).abs() < 1.0 && (straight.slope[0] - end).abs() < 1e-2);
        assert!((kxx(Beyond::Linear, 200.0).value[0] - 3e6).abs() < 1e-6);
        let stated = BearingLinear::tabulated(link(), table()).tabulated().unwrap();
        assert_eq!((stated.from, stated.to, stated.beyond), (50.0, 600.0, Beyond::Refuse));
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
    }
}
