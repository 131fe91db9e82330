//! A plain journal bearing by the closed form of the short bearing.
//!
//! Equations, on the displacement d = (x, y) of the journal relative to the bearing ([`film`](super::film)):
//!
//! ```text
//! F = mu R L^3/(4 c^2) f(d/c, d'/c, W)
//! T = 2 pi mu R^3 L W/(c sqrt(1 - e^2)) + (x Fy - y Fx)/2
//! ```
//!
//! Symbols: mu viscosity, Pa s; R radius and L length of the bearing, m; c radial clearance, m; e eccentricity over the clearance; W spin speed, rad/s, from x
//! towards y; T torque of the film against the spin, N m.
//!
//! Under a load the journal rests where the film carries it; what is linear about that state are its eight coefficients, at every speed. Without a load it rests in
//! the middle, where the film has cross stiffness alone and drives whirl.
//!
//! Validity: length up to half of the diameter (forces too large by 8, 28, 94 % at L/D = 0.25, 0.5, 1 and e = 0.6); laminar film, constant viscosity; the journal
//! stays parallel to the bearing; eccentricity up to 0.95 of the clearance.
//!
//! Theory: `docs/theory/oil-films.md`.
//!
//! Sources: F. W. Ocvirk, NACA TN 2808 (1952); R. Holmes, J. Mech. Eng. Sci. 2 (1960) 337; M. I. Friswell, J. E. T. Penny, S. D. Garvey, A. W. Lees, Dynamics of
//! Rotating Machines, Cambridge 2010, section 5.5 (coefficients).

use super::film::{Film, Measures};
use crate::diagnostic::Diagnostics;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, Rows, Uses, Validity};
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`BearingJournal`].
    pub struct BearingJournalParams in BearingJournalFamily {
        diameter: scalar, "m", Bounds::closed(1e-4, 10.0), required, "diameter 2 R of the journal";
        length: scalar, "m", Bounds::closed(1e-5, 10.0), required, "length L of the bearing along the axis";
        clearance: scalar, "m", Bounds::closed(1e-7, 0.1), required, "radial clearance c: half of the difference of the diameters";
        viscosity: scalar, "Pa s", Bounds::closed(1e-6, 1e3), required, "dynamic viscosity mu of the oil at its temperature in the film";
    }
}

/// Eccentricity over the clearance up to which the law holds.
const LIMIT: f64 = 0.95;
/// Length over diameter from which on the law is too stiff to be used.
const SHORT: f64 = 1.0;

/// See the [module](self).
pub struct BearingJournal {
    link: Link,
    film: Film,
}

impl BearingJournal {
    /// From the journal to the bearing, with a film that ruptures.
    pub fn new(link: Link) -> Self {
        BearingJournal { link, film: Film::Ruptured }
    }
    /// With this film.
    pub fn film(self, film: Film) -> Self {
        BearingJournal { film, ..self }
    }
    #[inline(always)]
    fn measures<S: Scalar>(p: &BearingJournalParams<S>) -> Measures<S> {
        Measures { viscosity: p.viscosity, diameter: p.diameter, length: p.length, clearance: p.clearance }
    }
    #[inline(always)]
    fn force<S: Scalar>(&self, p: &BearingJournalParams<S>, at: &At<S>) -> [S; 2] {
        Self::measures(p).force(self.film, [at.q[0], at.q[1]], [at.v[0], at.v[1]], at.speed)
    }
    /// Torque against the spin.
    #[inline(always)]
    fn torque<S: Scalar>(&self, p: &BearingJournalParams<S>, at: &At<S>) -> S {
        let f = self.force(p, at);
        Self::measures(p).drag([at.q[0], at.q[1]], at.speed) + (at.q[0] * f[1] - at.q[1] * f[0]).scale(0.5)
    }
}

/// Choices of the film.
pub(super) const FILMS: &[(&str, &str)] = &[
    ("ruptured", "pressure only where it is positive, as in a bearing with free ends"),
    ("full", "pressure all around, as in a film under high supply pressure"),
];

/// The film that a file chooses.
pub(super) fn chosen(values: &Values) -> Film {
    if values.choice("film") == Some("full") { Film::Full } else { Film::Ruptured }
}

impl Part for BearingJournal {
    const KIND: &'static str = "bearing_journal";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
diameter = "60 mm"
length = "25 mm"
clearance = "60 um"
viscosity = "20 mPa s"
"#;
    const DOC: &'static str = "A plain journal bearing from its geometry, load, speed and oil by the closed form of the short bearing: nonlinear film forces, with the \
        eight coefficients at the state where it carries the load. It drives whirl (oil whirl) where it carries little.";
    type Family = BearingJournalFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the journal and what the bearing is fixed to"),
        Field::optional("film", FieldKind::Choice(FILMS), "ruptured", "where the film carries pressure"),
    ];

    fn build(values: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        Some(BearingJournal::new(Link::Between(a, b)).film(chosen(values)))
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
        Uses { velocity: true, acceleration: false, spin: true }
    }
    #[inline(always)]
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let f = self.force(p, at);
        out.force[0] -= f[0];
        out.force[1] -= f[1];
        *out.spin += self.torque(p, at);
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let f = self.force(p, at);
        let dissipated = at.speed * self.torque(p, at) - f[0] * at.v[0] - f[1] * at.v[1];
        Some(Energy { dissipated, ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let (f, e) = (self.force(p, at), at.q[0].hypot(at.q[1]));
        out.push(Observed { name: "force", unit: "N", value: f[0].hypot(f[1]) });
        out.push(Observed { name: Observed::ECCENTRICITY, unit: "", value: e / p.clearance });
        out.push(Observed { name: Observed::FILM, unit: "m", value: p.clearance - e });
        out.push(Observed { name: Observed::TORQUE, unit: "N m", value: self.torque(p, at) });
    }
    fn validity(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        out.push(Validity { what: ECCENTRICITY, ratio: at.q[0].hypot(at.q[1]) / (LIMIT * p.clearance) });
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        wide(p.clearance, p.diameter)
    }
    fn warnings(&self, p: &Params<Self, f64>) -> Vec<Text> {
        long(p.length, p.diameter)
    }
}

/// What limits a film.
pub(super) const ECCENTRICITY: &str = "eccentricity over 0.95 of the clearance";

/// A clearance that makes no film.
pub(super) fn wide(clearance: f64, diameter: f64) -> Vec<(&'static str, Text)> {
    if clearance <= 0.05 * diameter {
        return Vec::new();
    }
    let (clearance, diameter) = (text::quantity(clearance, "m"), text::quantity(diameter, "m"));
    vec![(
        "clearance",
        text!(
            "a clearance of {clearance} makes no film at a diameter of {diameter}: usual are 0.05 to 0.2 % of the diameter",
            clearance,
            diameter
        ),
    )]
}

/// A bearing that is too long for the law.
pub(super) fn long(length: f64, diameter: f64) -> Vec<Text> {
    let ratio = length / diameter;
    if ratio <= SHORT {
        return Vec::new();
    }
    vec![text!(
        "its length is {ratio} of its diameter: the closed form of the short bearing holds up to 0.5, and from 1 on it is far too stiff",
        ratio = text::number(ratio, 3)
    )]
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::model::field::Attach;
    use laval_num::dual::Dual;

    pub(in crate::parts) fn link() -> Link {
        Link::Between(Attach::on("drum"), Attach::ground())
    }
    pub(super) fn params() -> BearingJournalParams {
        BearingJournalParams { diameter: 0.1, length: 0.03, clearance: 1e-4, viscosity: 0.1 }
    }

    /// The bearing of 100 mm diameter, 30 mm length, 0.1 mm clearance and 0.1 Pa s under 525 N at 1500 rpm: eccentricity 0.266298 and its eight coefficients in
    /// MN/m and kN s/m (Friswell et al. 2010, example 5.5.1, printed and recomputed digits).
    #[test]
    fn published_coefficients() {
        type D = Dual<f64, 4>;
        let (bearing, p) = (BearingJournal::new(link()), params());
        let speed = 1500.0 * std::f64::consts::PI / 30.0;
        let forces = |q: [f64; 2]| {
            let lift = |x: f64, k: usize| {
                let mut d = D::lift(x);
                d.eps[k] = 1.0;
                d
            };
            let (q, v) = ([lift(q[0], 0), lift(q[1], 1)], [lift(0.0, 2), lift(0.0, 3)]);
            let zero = D::lift(0.0);
            let at = At { q: &q, v: &v, a: &[], z: &[], phase: zero, speed: D::lift(speed), spin_accel: zero, t: zero };
            let own = BearingJournalParams {
                diameter: D::lift(p.diameter),
                length: D::lift(p.length),
                clearance: D::lift(p.clearance),
                viscosity: D::lift(p.viscosity),
            };
            bearing.force(&own, &at)
        };
        // the load acts along -y
        let mut q = [0.0, 0.0];
        for _ in 0..50 {
            let f = forces(q);
            let r = [f[0].re, f[1].re - 525.0];
            let (a, b, c, d) = (f[0].eps[0], f[0].eps[1], f[1].eps[0], f[1].eps[1]);
            let det = a * d - b * c;
            q = [q[0] - (d * r[0] - b * r[1]) / det, q[1] - (a * r[1] - c * r[0]) / det];
        }
        let e = q[0].hypot(q[1]) / p.clearance;
        assert!((e - 0.266298).abs() < 1e-6, "{e}");
        let f = forces(q);
        let of = |i: usize, k: usize, unit: f64| -f[i].eps[k] / unit;
        let found =
            [of(0, 0, 1e6), of(0, 1, 1e6), of(1, 0, 1e6), of(1, 1, 1e6), of(0, 2, 1e3), of(0, 3, 1e3), of(1, 2, 1e3), of(1, 3, 1e3)];
        let expected = [12.80796, 16.393593, -25.060393, 8.815303, 232.897, -81.924, -81.924, 294.912];
        for (a, b) in found.iter().zip(expected) {
            assert!((a / b - 1.0f64).abs() < 5e-6, "{found:?}");
        }
    }

    /// The torque of a full film is the moment of the shear at the journal, `mu W R/h + h/(2 R) dp/dtheta`, summed around it.
    #[test]
    fn torque_is_the_moment_of_the_shear() {
        let (p, speed, q) = (params(), 157.0, [3e-5, -4e-5]);
        let at = At { q: &q, v: &[0.0; 2], a: &[], z: &[], phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let found = BearingJournal::new(link()).film(Film::Full).torque(&p, &at);
        let (n, r) = (20_000, 0.5 * p.diameter);
        let h = |theta: f64| p.clearance - q[0] * theta.cos() - q[1] * theta.sin();
        // integrated over the length
        let pressure =
            |theta: f64| -p.viscosity * p.length.powi(3) / h(theta).powi(3) * 0.5 * speed * (q[0] * theta.sin() - q[1] * theta.cos());
        let step = std::f64::consts::TAU / f64::from(n);
        let shear = |theta: f64| {
            let slope = (pressure(theta + 1e-4) - pressure(theta - 1e-4)) / 2e-4;
            p.viscosity * speed * r / h(theta) * p.length + 0.5 * h(theta) / r * slope
        };
        let expected: f64 = (0..n).map(|k| shear((f64::from(k) + 0.5) * step) * r * r * step).sum();
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    }

    #[test]
    fn films_that_are_none() {
        let bearing = BearingJournal::new(link());
        assert!(bearing.check(&BearingJournalParams { clearance: 0.02, ..params() })[0].1.contains("makes no film"));
        assert!(bearing.warnings(&BearingJournalParams { length: 0.15, ..params() })[0].contains("1.5 of its diameter"));
        assert!(bearing.check(&params()).is_empty() && bearing.warnings(&params()).is_empty());
    }
}

crate::conformance! {
    BearingJournal {
        ruptured: BearingJournal::new(tests::link()), tests::params(), Options { length: 4e-5, rate: 100.0, ..Options::default() };
        full: BearingJournal::new(tests::link()).film(Film::Full), tests::params(), Options { length: 4e-5, rate: 100.0, ..Options::default() };
    }
}
