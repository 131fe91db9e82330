//! A massless elastic shaft, or support, between two points: one stiffness matrix, with optional damping of its material.
//!
//! Equations, on the motion `u = (x, y, alpha, beta)` of the first point relative to the second (tilt only where the shaft couples to it):
//!
//! ```text
//! K = [ kx   kxy   .    kc ]      f = K u                                 elastic
//!     [ kxy  ky   -kc   .  ]      f = K u + b K (u' - W R u)              with material damping, in axes that turn with the rotor
//!     [ .   -kc    kt   .  ]
//!     [ kc   .     .    kt ]      R: (x, y, alpha, beta) -> (-y, x, -beta, alpha)
//! ```
//!
//! Symbols: kx, ky, kxy stiffness, N/m; kc coupling of deflection and tilt, N/rad (moment per deflection, and force per tilt); kt tilt stiffness,
//! N m/rad; b = c/k damping of the material as a time, s; W spin speed, rad/s. Slopes are beta = dx/dz, alpha = -dy/dz.
//! A shaft clamped at the second point, length L, bending stiffness EI, with the first point at its end: k = 12 EI/L^3, kc = -6 EI/L^2,
//! kt = 4 EI/L (z from the clamp to the end; kc = +6 EI/L^2 where the end hangs below the clamp). Where the second body tilts too, give both points at the same height.
//!
//! A round shaft gives these from its geometry. It reaches a below the point and b above it (0: not at all), clamped or pinned at its ends:
//!
//! ```text
//! k  = E I ( n1/a^3 + m1/b^3)          n, m = 12, 6, 4   clamped
//! kc = E I (-n2/a^2 + m2/b^2)                  3, 3, 3   pinned        I = pi (d^4 - di^4)/64
//! kt = E I ( n3/a   + m3/b  )                  0, 0, 0   not there
//! ```
//!
//! Without a moment at the point (`moment = false`, for a body without tilt) it has k - kc^2/kt: 3 E I/a^3 of a cantilever, 48 E I/l^3 in the middle of a shaft
//! pinned at both ends, 192 E I/l^3 clamped.
//!
//! Validity: mass of the shaft small against what it carries; unequal stiffness in x and y belongs to fixed axes (a support, not a shaft with flats); of the
//! geometry: slender, no shear deflection.
//!
//! Theory: `docs/theory/machine.md#massless-shafts`.
//!
//! Sources: any text on beams for the matrix; A. L. Kimball, Gen. Electr. Rev. 27 (1924) for damping in rotor axes.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::capability::Extent;
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::f64::consts::PI;
use std::sync::Arc;

params! {
    /// Parameters of a [`ShaftLumped`].
    pub struct ShaftLumpedParams in ShaftLumpedFamily {
        stiffness: lateral, "N/m", Bounds::up_to(1e15), default 0.0, "stiffness k (kx, ky), unless the geometry is given";
        cross_stiffness: scalar, "N/m", Bounds::within(1e15), default 0.0, "stiffness kxy = kyx of a support whose main axes are not x and y";
        coupling: scalar, "N/rad", Bounds::within(1e15), default 0.0, "coupling kc of deflection and tilt: the moment about y per deflection along x. Negative where the first point lies above what holds the shaft (towards larger z), positive where it hangs below; a shaft of length L and bending stiffness EI clamped at its other end has -6 EI/L^2 or +6 EI/L^2, with stiffness 12 EI/L^3 and tilt_stiffness 4 EI/L";
        tilt_stiffness: scalar, "N m/rad", Bounds::up_to(1e15), default 0.0, "tilt stiffness kt; when given, the shaft acts on tilt";
        material_damping: scalar, "s", Bounds::up_to(1e3), default 0.0, "damping of the material b = c/k, in axes that turn with the rotor";
        diameter: scalar, "m", Bounds::up_to(10.0), default 0.0, "diameter d of a round shaft, instead of its stiffness";
        inner_diameter: scalar, "m", Bounds::up_to(10.0), default 0.0, "inner diameter di of a hollow shaft";
        below: scalar, "m", Bounds::up_to(100.0), default 0.0, "length a of a round shaft from its lower end to the point; 0 when it has no lower end";
        above: scalar, "m", Bounds::up_to(100.0), default 0.0, "length b of a round shaft from the point to its upper end; 0 when it has no upper end";
        modulus: scalar, "Pa", Bounds::closed(1e5, 1e13), default 2.06e11, "Young's modulus E of a round shaft";
    }
}

const ENDS: &[(&str, &str)] = &[("clamped", "against deflection and slope"), ("pinned", "against deflection only")];

/// Keys of a stiffness that is stated, and of one that follows from a geometry.
const STATED: [&str; 5] = ["stiffness.x", "stiffness.y", "cross_stiffness", "coupling", "tilt_stiffness"];
const GEOMETRY: [&str; 4] = ["inner_diameter", "below", "above", "diameter"];

/// A limit with four digits that does not exceed it, so that the value that is printed is admissible.
fn below(limit: f64) -> f64 {
    if !(limit > 0.0 && limit.is_finite()) {
        return limit;
    }
    let unit = 10f64.powi(limit.log10().floor() as i32 - 3);
    (limit / unit * (1.0 + 4.0 * f64::EPSILON)).floor() * unit
}

/// How an end of a round shaft is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// Against deflection and slope.
    Clamped,
    /// Against deflection.
    Pinned,
}

impl Held {
    fn factors(self) -> [f64; 3] {
        match self {
            Held::Clamped => [12.0, 6.0, 4.0],
            Held::Pinned => [3.0; 3],
        }
    }
}

/// A round shaft: its lower and upper end, where it has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Round {
    lower: Option<Held>,
    upper: Option<Held>,
}

impl Round {
    /// k, kc and kt.
    #[inline(always)]
    fn stiffness<S: Scalar>(self, p: &ShaftLumpedParams<S>) -> [S; 3] {
        let bending = p.modulus * (p.diameter.square().square() - p.inner_diameter.square().square()).scale(PI / 64.0);
        let mut sum = [S::zero(); 3];
        for (held, length, side) in [(self.lower, p.below, -1.0), (self.upper, p.above, 1.0)] {
            let Some(held) = held else { continue };
            let (f, unit) = (held.factors(), bending / length);
            sum[0] += (unit / length.square()).scale(f[0]);
            sum[1] += (unit / length).scale(side * f[1]);
            sum[2] += unit.scale(f[2]);
        }
        sum
    }
}

/// See the [module](self).
pub struct ShaftLumped {
    link: Link,
    tilts: bool,
    damped: bool,
    round: Option<Round>,
}

impl ShaftLumped {
    /// Acts on displacements only.
    pub fn lateral(link: Link) -> Self {
        ShaftLumped { link, tilts: false, damped: false, round: None }
    }
    /// Acts on displacements and tilts.
    pub fn with_tilt(link: Link) -> Self {
        ShaftLumped { link, tilts: true, damped: false, round: None }
    }
    /// The same with damping of its material; it must be equal in x and y.
    pub fn damped(self) -> Self {
        ShaftLumped { damped: true, ..self }
    }
    /// The same with the stiffness of a round shaft, whose lower and upper end are held like this.
    pub fn round(self, lower: Option<Held>, upper: Option<Held>) -> Self {
        ShaftLumped { round: Some(Round { lower, upper }), ..self }
    }
    fn size(&self) -> usize {
        if self.tilts { 4 } else { 2 }
    }
    #[inline(always)]
    fn matrix<S: Scalar>(&self, p: &ShaftLumpedParams<S>) -> [[S; 4]; 4] {
        let o = S::zero();
        if let Some(round) = self.round {
            let [k, kc, kt] = round.stiffness(p);
            let free = k - kc * kc / kt;
            let k = if self.tilts { k } else { free };
            return [[k, o, o, kc], [o, k, -kc, o], [o, -kc, kt, o], [kc, o, o, kt]];
        }
        let (kc, kt, kxy) = (p.coupling, p.tilt_stiffness, p.cross_stiffness);
        [[p.stiffness[0], kxy, o, kc], [kxy, p.stiffness[1], -kc, o], [o, -kc, kt, o], [kc, o, o, kt]]
    }
    /// `K x` over the coordinates it acts on.
    #[inline(always)]
    fn apply<S: Scalar>(&self, k: &[[S; 4]; 4], x: &[S]) -> [S; 4] {
        let mut f = [S::zero(); 4];
        for (f, row) in f.iter_mut().zip(k).take(self.size()) {
            for (&k, &x) in row.iter().zip(&x[..self.size()]) {
                *f += k * x;
            }
        }
        f
    }
    /// `R x`: a quarter turn of each pair.
    #[inline(always)]
    fn quarter<S: Scalar>(&self, x: &[S]) -> [S; 4] {
        let mut r = [S::zero(); 4];
        for i in (0..self.size()).step_by(2) {
            (r[i], r[i + 1]) = (-x[i + 1], x[i]);
        }
        r
    }
    /// Rate seen in rotor axes and the damping force on it.
    #[inline(always)]
    fn slip<S: Scalar>(&self, p: &ShaftLumpedParams<S>, at: &At<S>) -> ([S; 4], [S; 4]) {
        let mut slip = self.quarter(at.q);
        for (s, &v) in slip.iter_mut().zip(at.v) {
            *s = v - at.speed * *s;
        }
        let mut force = self.apply(&self.matrix(p), &slip);
        for f in &mut force {
            *f *= p.material_damping;
        }
        (slip, force)
    }
}

#[inline(always)]
fn dot<S: Scalar>(a: &[S], b: &[S]) -> S {
    let mut s = S::zero();
    for (&a, &b) in a.iter().zip(b) {
        s += a * b;
    }
    s
}

impl Part for ShaftLumped {
    const KIND: &'static str = "shaft_lumped";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
stiffness = "2.9e6 N/m"
material_damping = "2e-5 s"         # loss of the material, turning with the shaft
"#;
    const DOC: &'static str = "A massless elastic shaft or support between two points: stiffness in x and y, optionally coupled to the tilt of a \
        disc, and optionally with damping of the shaft's material, which turns with the rotor and destabilises above the critical speed. A round shaft gives its \
        stiffness by its diameter, its lengths below and above the point and how its ends are held.";
    type Family = ShaftLumpedFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the two points it joins, the carried one first"),
        Field::optional(
            "lower_end",
            FieldKind::Choice(ENDS),
            "clamped",
            "how the lower end of a round shaft is held by the second point's body",
        ),
        Field::optional(
            "upper_end",
            FieldKind::Choice(ENDS),
            "clamped",
            "how the upper end of a round shaft is held by the second point's body",
        ),
        Field::optional(
            "moment",
            FieldKind::Flag,
            "true",
            "a round shaft acts on the tilt of what it carries; false for a body without tilt, which leaves the slope of the shaft free",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        let nonzero = |name: &str| params.get(name).is_some_and(|x| x != 0.0);
        let (tilts, damped) = (nonzero("coupling") || nonzero("tilt_stiffness"), nonzero("material_damping"));
        if nonzero("diameter") {
            return round(values, params, diagnostics, Link::Between(a, b), damped);
        }
        let beside = GEOMETRY.into_iter().find(|name| nonzero(name));
        let beside = beside.or_else(|| ["lower_end", "upper_end", "moment", "modulus"].into_iter().find(|name| values.written(name)));
        if let Some(name) = beside {
            diagnostics.push(
                Diagnostic::error("shaft_lumped.geometry", text!("{name} is given without a diameter", name))
                    .at(values.span_of(name))
                    .help(text!("a round shaft takes diameter, below or above or both; a stated stiffness takes none of them")),
            );
        } else if !["stiffness.x", "stiffness.y", "tilt_stiffness"].into_iter().any(nonzero) && !values.written("stiffness") {
            diagnostics.push(
                Diagnostic::error("shaft_lumped.stiffness", text!("the shaft has no stiffness"))
                    .at(values.span.clone())
                    .help(text!("give stiffness, or the diameter of a round shaft and its length below or above the point")),
            );
        }
        let unequal = params.get("stiffness.x") != params.get("stiffness.y") || nonzero("cross_stiffness");
        if damped && unequal {
            diagnostics.push(
                Diagnostic::error("shaft_lumped.damping", text!("a shaft with material damping must be equally stiff in x and y"))
                    .at(values.span_of("material_damping"))
                    .help(text!("unequal stiffness in fixed axes is a support, which does not turn: use a damper part beside it")),
            );
        }
        Some(ShaftLumped { link: Link::Between(a, b), tilts, damped, round: None })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        if self.tilts { Layout::point_and_tilt(self.link.clone()) } else { Layout::point(self.link.clone()) }
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let k = self.matrix(p);
        for (i, row) in k.iter().enumerate().take(self.size()) {
            for j in 0..self.size() {
                b.stiffness[(i, j)] = row[j];
                if self.damped {
                    b.damping[(i, j)] = p.material_damping * row[j];
                    // -b K R: column j of K R is the partner column of K
                    let turned = if j % 2 == 0 { row[j + 1] } else { -row[j - 1] };
                    b.circulatory[(i, j)] = -(p.material_damping * turned);
                }
            }
        }
    }
    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        if self.damped { -dot(&self.quarter(at.q), &self.slip(p, at).1) } else { S::zero() }
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let stored = dot(at.q, &self.apply(&self.matrix(p), at.q)).scale(0.5);
        let (slip, force) = self.slip(p, at);
        Some(Energy { stored, dissipated: dot(&slip, &force), ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let (f, damping) = (self.apply(&self.matrix(p), at.q), self.slip(p, at).1);
        let total: Vec<f64> = f.iter().zip(damping).map(|(f, d)| f + d).collect();
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "force", unit: "N", value: total[0].hypot(total[1]) });
        if self.tilts {
            out.push(Observed { name: Observed::MOMENT, unit: "N m", value: total[2].hypot(total[3]) });
        }
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let [kx, ky] = p.stiffness;
        let mut wrong = Vec::new();
        if p.cross_stiffness * p.cross_stiffness > kx * ky {
            let limit = text::quantity(below((kx * ky).sqrt()), "N/m");
            wrong.push(("cross_stiffness", text!("cross_stiffness is at most sqrt(kx ky) = {limit}: more would push outwards", limit)));
        } else if p.coupling != 0.0 && p.coupling * p.coupling > p.tilt_stiffness * least(p) {
            let limit = text::quantity(below((p.tilt_stiffness * least(p)).sqrt()), "N/rad");
            wrong.push((
                "coupling",
                text!("coupling is at most sqrt(stiffness tilt_stiffness) = {limit}: more would give energy when bent (a clamped shaft has 0.87 of that)", limit),
            ));
        }
        if self.round.is_none() && !self.tilts && (p.coupling != 0.0 || p.tilt_stiffness != 0.0) {
            wrong.push(("tilt_stiffness", text!("this shaft was built without tilt")));
        }
        if !self.damped && p.material_damping != 0.0 {
            wrong.push(("material_damping", text!("this shaft was built without material damping")));
        }
        if let Some(round) = self.round {
            wrong.extend(round.check(p));
        } else if p.diameter != 0.0 {
            wrong.push(("diameter", text!("this shaft was built from its stiffness")));
        }
        if self.damped && (kx != ky || p.cross_stiffness != 0.0) {
            wrong.push(("material_damping", text!("a shaft with material damping must be equally stiff in x and y")));
        }
        wrong
    }
    #[inline(always)]
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for ShaftLumped {
    fn is_steady(&self) -> bool {
        true
    }
}

/// A round shaft from its fields.
fn round(values: &Values, params: &ParamValues, diagnostics: &mut Diagnostics, link: Link, damped: bool) -> Option<ShaftLumped> {
    let given = |name: &str| params.get(name).is_some_and(|x| x != 0.0);
    if let Some(name) = STATED.into_iter().find(|name| given(name)) {
        let name = name.split('.').next().unwrap_or(name);
        diagnostics.push(
            Diagnostic::error("shaft_lumped.twice", text!("{name} is given beside the diameter of a round shaft", name))
                .at(values.span_of(name))
                .help(text!("the stiffness follows from the geometry: take one of them away")),
        );
        return None;
    }
    let held = |end: &str, length: &str| {
        let word = if values.choice(end) == Some("pinned") { Held::Pinned } else { Held::Clamped };
        given(length).then_some(word)
    };
    let (lower, upper) = (held("lower_end", "below"), held("upper_end", "above"));
    for (end, length, there) in [("lower_end", "below", lower.is_some()), ("upper_end", "above", upper.is_some())] {
        if !there && values.written(end) {
            diagnostics.push(
                Diagnostic::error("shaft_lumped.geometry", text!("{end} is given without the length {length}", end, length))
                    .at(values.span_of(end))
                    .help(text!("give {length} as well, or take {end} away", length, end)),
            );
        }
    }
    if lower.is_none() && upper.is_none() {
        diagnostics.push(
            Diagnostic::error("shaft_lumped.geometry", text!("a round shaft needs a length"))
                .at(values.span_of("diameter"))
                .help(text!("give below, the length from its lower end to the point, or above, or both")),
        );
        return None;
    }
    let moment = values.flag("moment").unwrap_or(true);
    let shaft = if moment { ShaftLumped::with_tilt(link) } else { ShaftLumped::lateral(link) };
    Some(ShaftLumped { damped, ..shaft.round(lower, upper) })
}

impl Round {
    fn check(self, p: &ShaftLumpedParams) -> Vec<(&'static str, Text)> {
        let mut wrong = Vec::new();
        if !(p.inner_diameter < p.diameter) {
            wrong.push(("inner_diameter", text!("inner_diameter is less than diameter")));
        }
        for (held, length, name) in [(self.lower, p.below, "below"), (self.upper, p.above, "above")] {
            match held {
                Some(_) if !(length >= 1e-4) => {
                    wrong.push((name, text!("{name} is at least {value}", name, value = text::quantity(1e-4, "m"))))
                }
                None if length != 0.0 => wrong.push((name, text!("this shaft was built without {name}", name))),
                _ => {}
            }
        }
        if self.lower.is_none_or(|h| h == Held::Pinned) && self.upper.is_none() || self.lower.is_none() && self.upper == Some(Held::Pinned)
        {
            wrong.push(("diameter", text!("a shaft pinned at its only end holds nothing: clamp it, or give its other end")));
        }
        if p.stiffness != [0.0; 2] || p.cross_stiffness != 0.0 || p.coupling != 0.0 || p.tilt_stiffness != 0.0 {
            wrong.push(("stiffness", text!("the stiffness of this shaft follows from its geometry")));
        }
        wrong
    }
}

/// Smaller main stiffness, N/m.
fn least(p: &ShaftLumpedParams) -> f64 {
    let [kx, ky] = p.stiffness;
    0.5 * (kx + ky) - (0.5 * (kx - ky)).hypot(p.cross_stiffness)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::{Attach, Value};

    pub(super) fn joint() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }
    fn build(set: &[(&str, f64)]) -> (ShaftLumped, Vec<String>) {
        let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
        values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
        for (name, x) in [("stiffness.x", 1e6), ("stiffness.y", 1e6)].iter().chain(set) {
            params.set(name, *x);
        }
        let part = ShaftLumped::build(&values, &mut params, &mut d).unwrap();
        (part, d.0.iter().map(|d| d.to_string()).collect())
    }

    /// A cantilever: a force alone at its end bends it by F L^3/(3 EI) and tilts it by F L^2/(2 EI).
    #[test]
    fn clamped_shaft_has_the_flexibility_of_a_cantilever() {
        let (ei, l) = (5e3, 0.4);
        let p = ShaftLumpedParams {
            stiffness: [12.0 * ei / (l * l * l); 2],
            coupling: -6.0 * ei / (l * l),
            tilt_stiffness: 4.0 * ei / l,
            ..ShaftLumpedParams::new()
        };
        let shaft = ShaftLumped::with_tilt(joint());
        assert!(shaft.check(&p).is_empty());
        let (deflection, slope) = (l * l * l / (3.0 * ei), l * l / (2.0 * ei));
        // force along x bends with beta = dx/dz; force along y with alpha = -dy/dz
        let f = shaft.apply(&shaft.matrix(&p), &[deflection, 0.0, 0.0, slope]);
        assert!((f[0] - 1.0).abs() < 1e-12 && f[1] == 0.0 && f[2] == 0.0 && f[3].abs() < 1e-12);
        let f = shaft.apply(&shaft.matrix(&p), &[0.0, deflection, -slope, 0.0]);
        assert!((f[1] - 1.0).abs() < 1e-12 && f[0] == 0.0 && f[2].abs() < 1e-12 && f[3] == 0.0);
    }

    /// The same hanging from its clamp: z is counted upwards, so that the slope dx/dz at its end has the other sign, and with it the coupling.
    #[test]
    fn a_hanging_shaft_has_the_other_sign_of_coupling() {
        let (ei, l) = (5e3, 0.4);
        let (deflection, slope) = (l * l * l / (3.0 * ei), -l * l / (2.0 * ei));
        let force = |coupling: f64| {
            let stiffness = [12.0 * ei / (l * l * l); 2];
            let p = ShaftLumpedParams { stiffness, coupling, tilt_stiffness: 4.0 * ei / l, ..ShaftLumpedParams::new() };
            let shaft = ShaftLumped::with_tilt(joint());
            assert!(shaft.check(&p).is_empty());
            shaft.apply(&shaft.matrix(&p), &[deflection, 0.0, 0.0, slope])
        };
        let right = force(6.0 * ei / (l * l));
        assert!((right[0] - 1.0).abs() < 1e-12 && right[3].abs() < 1e-12, "{right:?}");
        // with the sign of a standing shaft the same bend would need seven times the force
        assert!((force(-6.0 * ei / (l * l))[0] - 7.0).abs() < 1e-12);
    }

    /// Textbook deflections under a load at the point, with the slope left free.
    #[test]
    fn round_shafts_have_the_stiffness_of_their_supports() {
        use Held::{Clamped, Pinned};
        let (d, di, e) = (0.04, 0.03, 2.1e11);
        let ei = e * PI * (f64::powi(d, 4) - f64::powi(di, 4)) / 64.0;
        let (a, b) = (0.3, 0.5);
        let l = a + b;
        for (lower, upper, should) in [
            (Some(Clamped), None, 3.0 * ei / f64::powi(a, 3)),
            (None, Some(Clamped), 3.0 * ei / f64::powi(b, 3)),
            (Some(Pinned), Some(Pinned), 3.0 * ei * l / (a * a * b * b)),
            (Some(Clamped), Some(Clamped), 3.0 * ei * f64::powi(l, 3) / (f64::powi(a, 3) * f64::powi(b, 3))),
            // Roark, propped cantilever: a^3 b^2 (3 a + 4 b)/(12 E I l^3) with the clamp at the side of a
            (Some(Clamped), Some(Pinned), 12.0 * ei * f64::powi(l, 3) / (f64::powi(a, 3) * b * b * (3.0 * a + 4.0 * b))),
        ] {
            let p = ShaftLumpedParams {
                diameter: d,
                inner_diameter: di,
                below: if lower.is_some() { a } else { 0.0 },
                above: if upper.is_some() { b } else { 0.0 },
                modulus: e,
                ..ShaftLumpedParams::new()
            };
            let free = ShaftLumped::lateral(joint()).round(lower, upper);
            assert!(free.check(&p).is_empty(), "{:?}", free.check(&p));
            let k = free.matrix(&p)[0][0];
            assert!((k / should - 1.0).abs() < 1e-12, "{lower:?} {upper:?}: {k} {should}");
            // with the moment at the point the same stiffness once the slope follows
            let m = ShaftLumped::with_tilt(joint()).round(lower, upper).matrix(&p);
            assert!(((m[0][0] - m[0][3] * m[3][0] / m[3][3]) / should - 1.0).abs() < 1e-12 && m[1][2] == -m[0][3]);
        }
        let p = ShaftLumpedParams { diameter: d, below: a, ..ShaftLumpedParams::new() };
        assert!(ShaftLumped::with_tilt(joint()).round(Some(Pinned), None).check(&p)[0].1.contains("holds nothing"));
        let p = ShaftLumpedParams { inner_diameter: d, ..p };
        assert_eq!(ShaftLumped::with_tilt(joint()).round(Some(Clamped), None).check(&p)[0].0, "inner_diameter");
    }

    #[test]
    fn fields_choose_the_variant_and_mistakes_are_reported() {
        let (mut values, mut params) = (Values::default(), ParamValues::default());
        values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
        let reported = |values: &Values, params: &mut ParamValues| {
            let mut d = Diagnostics::default();
            let part = ShaftLumped::build(values, params, &mut d);
            (part.map(|p| (p.size(), p.round)), d.0.iter().map(|d| d.message.clone()).collect::<Vec<_>>())
        };
        assert_eq!(reported(&values, &mut params).1, ["the shaft has no stiffness"]);
        params.set("below", 0.2);
        assert_eq!(reported(&values, &mut params).1, ["below is given without a diameter"]);
        params.set("diameter", 0.02);
        assert_eq!(reported(&values, &mut params), (Some((4, Some(Round { lower: Some(Held::Clamped), upper: None }))), vec![]));
        values.set("moment", Value::Flag(false), None);
        assert_eq!(reported(&values, &mut params).0.unwrap().0, 2);
        values.set("upper_end", Value::Choice("pinned"), Some(0..1));
        assert_eq!(reported(&values, &mut params).1, ["upper_end is given without the length above"]);
        params.set("stiffness.x", 1e6);
        assert_eq!(reported(&values, &mut params).1, ["stiffness is given beside the diameter of a round shaft"]);
        assert_eq!(build(&[]).0.size(), 2);
        assert_eq!(build(&[("tilt_stiffness", 10.0)]).0.size(), 4);
        assert!(build(&[("material_damping", 1e-5)]).1.is_empty());
        assert!(build(&[("material_damping", 1e-5), ("stiffness.y", 2e6)]).1[0].contains("equally stiff"));
        let p = ShaftLumpedParams { stiffness: [1e6; 2], coupling: 2e4, tilt_stiffness: 100.0, ..ShaftLumpedParams::new() };
        assert!(ShaftLumped::with_tilt(joint()).check(&p)[0].1.contains("at most sqrt"));
        let p = ShaftLumpedParams { stiffness: [1e6; 2], cross_stiffness: 2e6, ..ShaftLumpedParams::new() };
        assert_eq!(ShaftLumped::lateral(joint()).check(&p)[0].0, "cross_stiffness");
    }
}

#[cfg(test)]
fn tried(stiffness: [f64; 2], cross_stiffness: f64, coupling: f64, tilt_stiffness: f64, material_damping: f64) -> ShaftLumpedParams {
    ShaftLumpedParams { stiffness, cross_stiffness, coupling, tilt_stiffness, material_damping, ..ShaftLumpedParams::new() }
}

#[cfg(test)]
fn tried_round(below: f64, above: f64, material_damping: f64) -> ShaftLumpedParams {
    ShaftLumpedParams { diameter: 0.03, inner_diameter: 0.01, below, above, material_damping, ..ShaftLumpedParams::new() }
}

crate::conformance! {
    ShaftLumped {
        lateral: ShaftLumped::lateral(tests::joint()), tried([1e6; 2], 0.0, 0.0, 0.0, 0.0), Options::default();
        support: ShaftLumped::lateral(tests::joint()), tried([1e6, 2e6], 3e5, 0.0, 0.0, 0.0), Options::anisotropic();
        tilting: ShaftLumped::with_tilt(tests::joint()), tried([1e6; 2], 0.0, -7e4, 1e4, 0.0), Options::default();
        tilting_support: ShaftLumped::with_tilt(tests::joint()), tried([1e6, 2e6], 3e5, -7e4, 1e4, 0.0), Options::anisotropic();
        damped: ShaftLumped::lateral(tests::joint()).damped(), tried([1e6; 2], 0.0, 0.0, 0.0, 2e-4), Options::default();
        damped_tilting: ShaftLumped::with_tilt(tests::joint()).damped(), tried([1e6; 2], 0.0, -7e4, 1e4, 2e-4), Options::default();
        round: ShaftLumped::with_tilt(tests::joint()).damped().round(Some(Held::Clamped), Some(Held::Pinned)), tried_round(0.2, 0.3, 2e-4), Options::default();
        round_free: ShaftLumped::lateral(tests::joint()).round(Some(Held::Pinned), Some(Held::Pinned)), tried_round(0.2, 0.3, 0.0), Options::default();
    }
}
