//! A rolling bearing as Hertz contacts: a force that grows with the deflection to the power 3/2, with clearance or preload.
//!
//! Equations, on the deflection `d = z_a - z_b`, with `[u] = max(u, 0)`:
//!
//! ```text
//! radial:    f = Cb [|d| - d0]^(3/2) d/|d|                          the same in all directions; d0 >= 0 radial clearance
//! per axis:  f_x = Cb ([dx - d0]^(3/2) - [-dx - d0]^(3/2)), f_y alike: two opposed contacts on each axis
//! ```
//!
//! Without clearance both are `Cb |d|^(1/2) d` (radial, per axis). Per axis, a negative clearance is an interference: the preloaded pair
//! `Cb [(i + d)^(3/2) - (i - d)^(3/2)] = 3 Cb i^(1/2) d - (1/8) Cb i^(-3/2) d^3 + ...`, i = -d0, which softens.
//!
//! Symbols: Cb contact coefficient of the whole bearing, N/m^1.5; d0 clearance, m.
//!
//! Validity: elastic contact, many rolling elements (no dependence on the cage angle), no centrifugal load of the rolling elements.
//! Without preload the stiffness at rest is zero: a linear study needs an amplitude, a preload, or, where there is clearance, other parts that hold the rotor
//! inside it.
//!
//! Theory: `docs/theory/rolling-bearings.md#hertz-law`.
//!
//! Sources: H. Hertz (1882); `000_a291f7ede1484e56` section 1.1 for the law and its cubic approximation, [`cubic_fit`].

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::capability::Contacts;
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, Rows, Uses};
use crate::params;
use crate::parts::bearing_rolling::hertz_coefficient;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`BearingHertz`].
    pub struct BearingHertzParams in BearingHertzFamily {
        coefficient: scalar, "N/m^1.5", Bounds::up_to(1e20), default 0.0, "contact coefficient Cb of the whole bearing; or give balls and ball_diameter";
        clearance: scalar, "m", Bounds::within(0.1), default 0.0, "radial clearance d0; negative is interference (preload), per axis only";
    }
}

/// See the [module](self).
pub struct BearingHertz {
    link: Link,
    radial: bool,
}

impl BearingHertz {
    /// The same in all directions.
    pub fn radial(link: Link) -> Self {
        BearingHertz { link, radial: true }
    }
    /// Opposed contacts on each axis.
    pub fn per_axis(link: Link) -> Self {
        BearingHertz { link, radial: false }
    }
    #[inline(always)]
    fn force<S: Scalar>(&self, p: &BearingHertzParams<S>, d: &[S]) -> [S; 2] {
        if self.radial {
            let r = d[0].norm2(d[1]);
            let factor = p.coefficient * (r - p.clearance).pow_pos(1.5) / r.select_pos(r, S::one());
            [factor * d[0], factor * d[1]]
        } else {
            let mut force = [d[0], d[1]];
            for f in &mut force {
                *f = p.coefficient * ((*f - p.clearance).pow_pos(1.5) - (-*f - p.clearance).pow_pos(1.5));
            }
            force
        }
    }
}

impl Part for BearingHertz {
    const KIND: &'static str = "bearing_hertz";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
law = "radial"
coefficient = "3e9 N/m^1.5"
clearance = "10 um"
"#;
    const DOC: &'static str = "A rolling bearing with the force of Hertz contacts, growing with the deflection to the power 3/2, with clearance \
        or preload. Without preload it has no stiffness at rest; a linear study of a machine that other parts hold inside the clearance leaves it open.";
    type Family = BearingHertzFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the two points it joins"),
        Field::required(
            "law",
            FieldKind::Choice(&[
                ("radial", "Cb [|d| - d0]^(3/2) along d: the same in all directions"),
                ("per_axis", "opposed contacts on each axis; a negative clearance is a preloaded pair"),
            ]),
            "how the force depends on direction",
        ),
        Field::optional(
            "balls",
            FieldKind::Integer { min: 3, max: 200 },
            "",
            "number of steel balls, from which the coefficient follows, in place of coefficient: (2/3 13e6)^(3/2) n D^(1/2) cos(a)^(5/2)",
        ),
        Field::optional(
            "ball_diameter",
            FieldKind::Quantity { unit: "m", bounds: Bounds::closed(1e-4, 1.0) },
            "",
            "diameter D of a ball, with balls",
        ),
        Field::optional(
            "contact_angle",
            FieldKind::Quantity { unit: "rad", bounds: Bounds::closed(0.0, 1.4) },
            "",
            "contact angle a of the balls; 0 unless given",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        let radial = values.choice("law")? == "radial";
        if radial && params.get("clearance").is_some_and(|d| d < 0.0) {
            diagnostics.push(
                Diagnostic::error("bearing_hertz.preload", text!("a radial law has no preload: its clearance cannot be negative"))
                    .at(values.span_of("clearance"))
                    .help(text!("use law = \"per_axis\", where a negative clearance is the interference of opposed contacts")),
            );
            return None;
        }
        let given = params.get("coefficient").is_some_and(|c| c != 0.0);
        match (values.integer("balls"), values.number("ball_diameter")) {
            (Some(n), Some(d)) if !given => {
                params.set("coefficient", hertz_coefficient(n as f64, d, values.number("contact_angle").unwrap_or(0.0)));
            }
            (None, None) if given => {
                if values.written("contact_angle") {
                    diagnostics.push(
                        Diagnostic::error("bearing_hertz.geometry", text!("contact_angle is given without balls"))
                            .at(values.span_of("contact_angle"))
                            .help(text!("a coefficient holds the angle already: take contact_angle away")),
                    );
                }
            }
            (None, None) => {
                diagnostics.push(
                    Diagnostic::error("bearing_hertz.coefficient", text!("the bearing has no contact coefficient"))
                        .at(values.span.clone())
                        .help(text!("give coefficient, or balls and ball_diameter")),
                );
                return None;
            }
            (balls, _) => {
                let (message, field) = match (given, balls.is_some()) {
                    (true, _) => (text!("coefficient is given beside the geometry of the balls"), "coefficient"),
                    (_, true) => (text!("balls is given without ball_diameter"), "balls"),
                    _ => (text!("ball_diameter is given without balls"), "ball_diameter"),
                };
                let help = text!("give coefficient, or balls and ball_diameter");
                diagnostics.push(Diagnostic::error("bearing_hertz.geometry", message).at(values.span_of(field)).help(help));
                return None;
            }
        }
        Some(BearingHertz { link: Link::Between(a, b), radial })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        Layout::point(self.link.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn uses(&self) -> Uses {
        Uses { velocity: false, acceleration: false, spin: false }
    }
    #[inline(always)]
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let f = self.force(p, at.q);
        out.force[0] += f[0];
        out.force[1] += f[1];
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let contact = |d: S| (d - p.clearance).pow_pos(2.5);
        let sum = if self.radial {
            contact(at.q[0].norm2(at.q[1]))
        } else {
            contact(at.q[0]) + contact(-at.q[0]) + contact(at.q[1]) + contact(-at.q[1])
        };
        Some(Energy { stored: (p.coefficient * sum).scale(0.4), ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let f = self.force(p, at.q);
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "force", unit: "N", value: f[0].hypot(f[1]) });
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        if self.radial && p.clearance < 0.0 {
            return vec![("clearance", text!("a radial law has no preload: its clearance cannot be negative"))];
        }
        if !(p.coefficient > 0.0) {
            return vec![("coefficient", text!("the contact coefficient must be positive"))];
        }
        Vec::new()
    }
    fn contacts(&self) -> Option<&dyn erased::Contacts> {
        Some(self)
    }
}

impl Contacts for BearingHertz {
    fn clearance(&self, p: &Params<Self, f64>, at: &At<f64>) -> Option<f64> {
        let deflection = if self.radial { at.q[0].hypot(at.q[1]) } else { at.q[0].abs().max(at.q[1].abs()) };
        Some(p.clearance - deflection)
    }
    fn refuses_rest(&self, p: &Params<Self, f64>) -> Option<Text> {
        let loaded = !self.radial && p.clearance < 0.0;
        (!loaded).then(|| {
            text!(
                "a Hertz contact without preload has no stiffness at rest: give an amplitude to linearise at (a harmonic study does), \
                 a preload (law = \"per_axis\" with a negative clearance), or a bearing_cubic fitted over the amplitudes of interest"
            )
        })
    }
    fn switches(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<f64>) {
        if self.radial {
            out.push(at.q[0].norm2(at.q[1]) - p.clearance);
        } else {
            for &d in &at.q[..2] {
                out.extend([d - p.clearance, -d - p.clearance]);
            }
        }
    }
}

/// What a cubic law `c0 d + c1 d^3` should have in common with the Hertz law `Cb d^(3/2)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// The force, in the least-squares sense over deflections from 0 to the amplitude.
    LeastSquares,
    /// The first harmonic of the force on a harmonic deflection, at the amplitude and at half of it: best for whirl.
    FirstHarmonic,
}

/// A cubic law fitted to a Hertz law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicFit {
    /// Linear coefficient, N/m.
    pub c0: f64,
    /// Cubic coefficient, N/m^3.
    pub c1: f64,
    /// Largest error of the force from 0 to the amplitude, over the Hertz force at the amplitude.
    pub largest_error: f64,
    /// Deflection where it is reached, m.
    pub at: f64,
}

/// First harmonic of `|cos|^(1/2) cos`: `(2/sqrt(pi)) Gamma(7/4)/Gamma(9/4)`.
pub const FIRST_HARMONIC: f64 = 0.915_311_716_202_176_1;

/// Cubic approximation of `cb d^(3/2)` (cb in N/m^1.5) for deflections up to `amplitude` (m). `None` unless both are positive and finite.
pub fn cubic_fit(cb: f64, amplitude: f64, criterion: Criterion) -> Option<CubicFit> {
    if !(cb > 0.0 && amplitude > 0.0 && cb.is_finite() && amplitude.is_finite()) {
        return None;
    }
    // in units of cb amplitude^(3/2) and amplitude: a u + b u^3 against u^(3/2)
    let (a, b) = match criterion {
        Criterion::LeastSquares => (45.0 / 77.0, 5.0 / 11.0),
        Criterion::FirstHarmonic => {
            let b = FIRST_HARMONIC * (1.0 - 0.5f64.sqrt()) * 16.0 / 9.0;
            (FIRST_HARMONIC - 0.75 * b, b)
        }
    };
    let error = |u: f64| (a * u + b * u * u * u - u.powf(1.5)).abs();
    // the error is largest at the end or where its derivative a - (3/2) s + 3 b s^4 vanishes, s = sqrt(u)
    let slope = |s: f64| a - 1.5 * s + 3.0 * b * s.powi(4);
    let stationary = |mut lo: f64, mut hi: f64| {
        for _ in 0..60 {
            let middle = 0.5 * (lo + hi);
            if (slope(middle) > 0.0) == (slope(lo) > 0.0) { lo = middle } else { hi = middle }
        }
        lo * lo
    };
    // one minimum of the slope, at s^3 = 1/(8 b)
    let bottom = (8.0 * b).recip().cbrt().min(1.0);
    let at = [1.0, stationary(0.0, bottom), stationary(bottom, 1.0)].into_iter().fold(1.0, |m, u| if error(u) > error(m) { u } else { m });
    let scale = cb * amplitude.sqrt();
    Some(CubicFit { c0: a * scale, c1: b * scale / (amplitude * amplitude), largest_error: error(at), at: at * amplitude })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::Attach;
    use laval_num::dual::Dual;
    use std::f64::consts::{FRAC_PI_2, PI};

    pub(super) fn joint() -> Link {
        Link::Between(Attach::on("drum"), Attach::on("base"))
    }
    /// Cosine coefficient of the first harmonic of f(a cos t), by the substitution that removes the root at cos t = 0.
    fn first_harmonic(f: impl Fn(f64) -> f64) -> f64 {
        // t = pi/2 (1 - (1 - w)^2) clusters at pi/2; midpoint rule
        let n = 200_000;
        (0..n)
            .map(|k| {
                let w = (k as f64 + 0.5) / n as f64;
                let t = FRAC_PI_2 * (1.0 - (1.0 - w) * (1.0 - w));
                f(t.cos()) * t.cos() * FRAC_PI_2 * 2.0 * (1.0 - w) / n as f64
            })
            .sum::<f64>()
            * 4.0
            / PI
    }

    #[test]
    fn least_squares_fit_has_the_printed_numbers() {
        let (cb, a) = (3e10, 2e-4);
        let fit = cubic_fit(cb, a, Criterion::LeastSquares).unwrap();
        assert!((fit.c0 / (45.0 / 77.0 * cb * a.sqrt()) - 1.0).abs() < 1e-15);
        assert!((fit.c1 / (5.0 / 11.0 * cb * a.powf(-1.5)) - 1.0).abs() < 1e-15);
        assert!((fit.largest_error - 3.0 / 77.0).abs() < 1e-12 && fit.at == a, "{fit:?}"); // 3.9 % at the end
        let harmonic = |x: f64| (fit.c0 * a * x + fit.c1 * (a * x).powi(3)) / (cb * a.powf(1.5));
        let h = first_harmonic(harmonic);
        assert!((h - (45.0 / 77.0 + 0.75 * 5.0 / 11.0)).abs() < 1e-9 && (h - 0.9253).abs() < 5e-5);
        assert!(((h / FIRST_HARMONIC - 1.0) - 0.011).abs() < 5e-4); // +1.1 %
        // normal equations: the error is orthogonal to d and d^3
        for power in [1, 3] {
            let n = 100_000;
            let inner: f64 = (0..n)
                .map(|k| (k as f64 + 0.5) / n as f64)
                .map(|u| (45.0 / 77.0 * u + 5.0 / 11.0 * u.powi(3) - u.powf(1.5)) * u.powi(power))
                .sum::<f64>()
                / n as f64;
            assert!(inner.abs() < 1e-10, "{inner:e}");
        }
    }

    #[test]
    fn first_harmonic_constant_and_fit() {
        assert!((first_harmonic(|x| x * x.abs().sqrt()) - FIRST_HARMONIC).abs() < 1e-9);
        assert!((FIRST_HARMONIC - 0.9153).abs() < 5e-5);
        let (cb, a) = (3e10, 2e-4);
        let fit = cubic_fit(cb, a, Criterion::FirstHarmonic).unwrap();
        for amplitude in [a, 0.5 * a] {
            let cubic = fit.c0 * amplitude + 0.75 * fit.c1 * amplitude.powi(3);
            assert!((cubic / (FIRST_HARMONIC * cb * amplitude.powf(1.5)) - 1.0).abs() < 1e-14);
        }
        // the stated error is the largest over a fine grid
        let grid = (0..=10_000).map(|k| a * f64::from(k) / 1e4).map(|d| (fit.c0 * d + fit.c1 * d.powi(3) - cb * d.powf(1.5)).abs());
        let largest = grid.fold(0.0, f64::max) / (cb * a.powf(1.5));
        assert!((fit.largest_error - largest).abs() < 1e-8, "{fit:?} {largest}");
        assert!(cubic_fit(cb, f64::NAN, Criterion::LeastSquares).is_none() && cubic_fit(cb, 0.0, Criterion::LeastSquares).is_none());
    }

    #[test]
    fn laws_have_their_closed_forms() {
        let (cb, d) = (2e9, [3e-5, -4e-5]);
        let p = |clearance| BearingHertzParams { coefficient: cb, clearance };
        let f = BearingHertz::radial(joint()).force(&p(0.0), &d);
        assert!((f[0] - cb * 5e-5f64.sqrt() * 3e-5).abs() < 1e-12 * f[0].abs());
        let f = BearingHertz::radial(joint()).force(&p(2e-5), &d);
        assert!((f[1] + cb * 3e-5f64.powf(1.5) * 0.8).abs() < 1e-12 * f[1].abs());
        assert_eq!(BearingHertz::radial(joint()).force(&p(6e-5), &d), [0.0, 0.0].map(|x: f64| x));
        let f = BearingHertz::per_axis(joint()).force(&p(0.0), &d);
        assert!((f[1] + cb * 4e-5f64.powf(1.5)).abs() < 1e-12 * f[1].abs());
    }

    /// 3 Cb i^(1/2) d - (1/8) Cb i^(-3/2) d^3: first and third derivative at rest.
    #[test]
    fn a_preloaded_pair_softens() {
        type D3 = Dual<Dual<Dual<f64, 1>, 1>, 1>;
        let (cb, i) = (2e9, 1e-5);
        let x = Dual { re: Dual { re: Dual::seed(0.0, 0), eps: [Dual::cst(1.0)] }, eps: [Dual::cst(1.0)] };
        let p = BearingHertzParams { coefficient: D3::cst(cb), clearance: D3::cst(-i) };
        let f = BearingHertz::per_axis(joint()).force(&p, &[x, D3::zero()])[0];
        let (first, third) = (f.eps[0].re.re, f.eps[0].eps[0].eps[0]);
        assert!((first / (3.0 * cb * i.sqrt()) - 1.0).abs() < 1e-12);
        assert!((third / (-0.75 * cb * i.powf(-1.5)) - 1.0).abs() < 1e-12);
    }

    /// The coefficient of balls; one of both, and whole.
    #[test]
    fn the_coefficient_follows_from_the_balls() {
        use crate::model::field::Value;
        let build = |f: &dyn Fn(&mut Values, &mut ParamValues)| {
            let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
            values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
            values.set("law", Value::Choice("radial"), None);
            params.set("coefficient", 0.0);
            f(&mut values, &mut params);
            let built = BearingHertz::build(&values, &mut params, &mut d);
            (built.is_some(), params.get("coefficient").unwrap(), d.0.first().map(|d| d.code))
        };
        let balls = |v: &mut Values| {
            v.set("balls", Value::Integer(10), None);
            v.set("ball_diameter", Value::Number(0.01), None);
        };
        let (built, coefficient, _) = build(&|v, _| {
            balls(v);
            v.set("contact_angle", Value::Number(0.3), None);
        });
        let expected = (13e6f64 / 1.5).powf(1.5) * 10.0 * 0.1 * 0.3f64.cos().powf(2.5);
        assert!(built && (coefficient / expected - 1.0).abs() < 1e-13);
        assert_eq!(build(&|_, _| ()).2, Some("bearing_hertz.coefficient"));
        assert_eq!(build(&|v, _| v.set("balls", Value::Integer(10), None)).2, Some("bearing_hertz.geometry"));
        assert_eq!(build(&|v, _| v.set("ball_diameter", Value::Number(0.01), None)).2, Some("bearing_hertz.geometry"));
        let both = build(&|v, p| {
            balls(v);
            p.set("coefficient", 1e9);
        });
        assert_eq!(both.2, Some("bearing_hertz.geometry"));
        let angle = build(&|v, p| {
            v.set("contact_angle", Value::Number(0.3), Some(0..1));
            p.set("coefficient", 1e9);
        });
        assert_eq!(angle.2, Some("bearing_hertz.geometry"));
        let p = |coefficient| BearingHertzParams { coefficient, clearance: 0.0 };
        assert!(BearingHertz::radial(joint()).check(&p(0.0)).len() == 1 && BearingHertz::radial(joint()).check(&p(f64::NAN)).len() == 1);
    }

    #[test]
    fn rest_is_refused_only_without_preload() {
        let p = |clearance| BearingHertzParams { coefficient: 1e9, clearance };
        assert!(BearingHertz::radial(joint()).refuses_rest(&p(0.0)).unwrap().contains("amplitude"));
        assert!(BearingHertz::per_axis(joint()).refuses_rest(&p(1e-5)).is_some());
        assert!(BearingHertz::per_axis(joint()).refuses_rest(&p(-1e-5)).is_none());
        assert_eq!(BearingHertz::radial(joint()).check(&p(-1e-5)).len(), 1);
    }
}

crate::conformance! {
    BearingHertz {
        radial: BearingHertz::radial(tests::joint()), BearingHertzParams { coefficient: 2e9, clearance: 0.0 }, Options::default();
        radial_clearance: BearingHertz::radial(tests::joint()), BearingHertzParams { coefficient: 2e9, clearance: 5e-4 }, Options::default();
        per_axis: BearingHertz::per_axis(tests::joint()), BearingHertzParams { coefficient: 2e9, clearance: 0.0 }, Options::anisotropic();
        per_axis_clearance: BearingHertz::per_axis(tests::joint()), BearingHertzParams { coefficient: 2e9, clearance: 4e-4 }, Options::anisotropic();
        preloaded_pair: BearingHertz::per_axis(tests::joint()), BearingHertzParams { coefficient: 2e9, clearance: -6e-4 }, Options::anisotropic();
    }
}
