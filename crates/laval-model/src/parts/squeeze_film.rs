//! A squeeze-film damper: an oil film around a ring that does not turn, by the closed form of the short film.
//!
//! Equations, on the displacement d = (x, y) of the ring relative to its housing ([`film`](super::film)):
//!
//! ```text
//! F = mu R L^3/(4 c^2) f(d/c, d'/c, 0)
//! ```
//!
//! Symbols: mu viscosity, Pa s; R radius and L length of the film, m; c radial clearance, m.
//!
//! The film damps and carries nothing: what centres the ring is another part, as a `bearing_linear` with the stiffness of the cage.
//!
//! Validity: open ends, length up to half of the diameter; no inertia of the oil; eccentricity up to 0.95 of the clearance.
//!
//! Theory: `docs/theory/oil-films.md`.
//!
//! Sources: as for [`bearing_journal`](super::bearing_journal).

use super::bearing_journal::{ECCENTRICITY, FILMS, chosen, long, wide};
use super::film::{Film, Measures};
use crate::diagnostic::Diagnostics;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, Rows, Uses, Validity};
use crate::params;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`SqueezeFilm`].
    pub struct SqueezeFilmParams in SqueezeFilmFamily {
        diameter: scalar, "m", Bounds::closed(1e-4, 10.0), required, "diameter 2 R of the film";
        length: scalar, "m", Bounds::closed(1e-5, 10.0), required, "length L of the film along the axis";
        clearance: scalar, "m", Bounds::closed(1e-7, 0.1), required, "radial clearance c: half of the difference of the diameters";
        viscosity: scalar, "Pa s", Bounds::closed(1e-6, 1e3), required, "dynamic viscosity mu of the oil at its temperature in the film";
    }
}

/// Eccentricity over the clearance up to which the law holds.
const LIMIT: f64 = 0.95;

/// See the [module](self).
pub struct SqueezeFilm {
    link: Link,
    film: Film,
}

impl SqueezeFilm {
    /// From the ring to its housing.
    pub fn new(link: Link, film: Film) -> Self {
        SqueezeFilm { link, film }
    }
    #[inline(always)]
    fn force<S: Scalar>(&self, p: &SqueezeFilmParams<S>, at: &At<S>) -> [S; 2] {
        let measures = Measures { viscosity: p.viscosity, diameter: p.diameter, length: p.length, clearance: p.clearance };
        measures.force(self.film, [at.q[0], at.q[1]], [at.v[0], at.v[1]], S::zero())
    }
}

impl Part for SqueezeFilm {
    const KIND: &'static str = "squeeze_film";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
diameter = "120 mm"
length = "30 mm"
clearance = "0.15 mm"
viscosity = "10 mPa s"
film = "full"
"#;
    const DOC: &'static str = "A squeeze-film damper from its geometry and oil by the closed form of the short film: it damps without stiffness, with forces that grow \
        with the eccentricity. What centres its ring is another part.";
    type Family = SqueezeFilmFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the ring and its housing"),
        Field::optional("film", FieldKind::Choice(FILMS), "ruptured", "where the film carries pressure"),
    ];

    fn build(values: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        Some(SqueezeFilm::new(Link::Between(a, b), chosen(values)))
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
        Uses { velocity: true, acceleration: false, spin: false }
    }
    #[inline(always)]
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let f = self.force(p, at);
        out.force[0] -= f[0];
        out.force[1] -= f[1];
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let f = self.force(p, at);
        Some(Energy { dissipated: -(f[0] * at.v[0] + f[1] * at.v[1]), ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let (f, e) = (self.force(p, at), at.q[0].hypot(at.q[1]));
        out.push(Observed { name: "force", unit: "N", value: f[0].hypot(f[1]) });
        out.push(Observed { name: Observed::ECCENTRICITY, unit: "", value: e / p.clearance });
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

#[cfg(test)]
mod tests {
    use super::super::bearing_journal::tests::link;
    use super::*;

    pub(super) fn params() -> SqueezeFilmParams {
        SqueezeFilmParams { diameter: 0.1, length: 0.03, clearance: 1e-4, viscosity: 0.02 }
    }

    /// On a circle about the centre a full film damps with pi mu R L^3/(c^3 m^1.5), with damping alone.
    #[test]
    fn a_circle_about_the_centre() {
        let (p, e, w): (_, f64, f64) = (params(), 0.5, 300.0);
        let r = e * p.clearance;
        let at = At { q: &[r, 0.0], v: &[0.0, w * r], a: &[], z: &[], phase: 0.0, speed: 500.0, spin_accel: 0.0, t: 0.0 };
        let f = SqueezeFilm::new(link(), Film::Full).force(&p, &at);
        let c = std::f64::consts::PI * p.viscosity * 0.5 * p.diameter * p.length.powi(3) / (p.clearance.powi(3) * (1.0 - e * e).powf(1.5));
        assert!(f[0].abs() < 1e-12 * f[1].abs() && (f[1] / (-c * w * r) - 1.0).abs() < 1e-12, "{f:?} {c}");
    }
}

crate::conformance! {
    SqueezeFilm {
        ruptured: SqueezeFilm::new(crate::parts::bearing_journal::tests::link(), Film::Ruptured), tests::params(), Options { length: 4e-5, ..Options::default() };
        full: SqueezeFilm::new(crate::parts::bearing_journal::tests::link(), Film::Full), tests::params(), Options { length: 4e-5, ..Options::default() };
    }
}
