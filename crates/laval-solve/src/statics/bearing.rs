//! What a support does at a state of rest: the load that it carries, the place of the turning body in it, and its eight coefficients about that state.
//!
//! ```text
//! K = d(-F)/d(x, y),  C = d(-F)/d(x', y')      F force on the turning body
//! ```
//!
//! A rigid mass on one support whirls without damping where `K + i g C - M g^2` is singular:
//!
//! ```text
//! M g^2 = (kxx cyy + kyy cxx - kxy cyx - kyx cxy)/(cxx + cyy)
//! g^2   = ((kxx - M g^2)(kyy - M g^2) - kxy kyx)/(cxx cyy - cxy cyx)
//! ```
//!
//! Symbols: M mass at the threshold, kg; g frequency of its whirl, rad/s.
//!
//! Source: J. W. Lund, K. K. Thomsen, A calculation method and data for the dynamic coefficients of oil-lubricated journal bearings, ASME 1978.

use super::Statics;
use super::supports::turning_first;
use crate::model::blocks::Blocks;
use crate::model::erased::{D8, Evaluate};
use crate::model::part::{At, Observed, Physics, Rows};
use crate::model::slot::gather;
use crate::model::system::System;
use laval_num::scalar::Scalar;

/// A support at a state of rest.
#[derive(Clone, Debug)]
pub struct BearingState {
    /// Displacement of the turning body relative to what the support stands on, x and y, m.
    pub place: [f64; 2],
    /// Force of the support on the turning body, N.
    pub force: [f64; 2],
    /// kxx, kxy, kyx, kyy, N/m.
    pub stiffness: [f64; 4],
    /// cxx, cxy, cyx, cyy, N s/m.
    pub damping: [f64; 4],
    /// What the part shows there.
    pub observed: Vec<Observed>,
}

/// The state of a support in a machine at rest; `None` of a part without two lateral components, and of one given in the frequency domain.
pub fn bearing_state(system: &System, slot: usize, at: &Statics) -> Option<BearingState> {
    let part = &system.slots()[slot];
    if part.map.len() < 2 || matches!(part.physics, Physics::Frequency(_)) {
        return None;
    }
    let mut q = Vec::new();
    gather(&part.map, &at.seen_by(slot), &mut q);
    let (n, z) = (q.len(), &at.z[part.states.clone()]);
    let own = &system.params()[part.params.clone()];
    let speed = part.speed(system.params(), at.speed);
    let still = vec![0.0; n];
    let plain = At { q: &q, v: &still, a: &still, z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let mut observed = Vec::new();
    part.part.observe(own, &plain, &mut observed);
    // derivatives over x, y and their rates
    let lifted = |all: &[f64]| -> Vec<D8> { all.iter().map(|&x| D8::lift(x)).collect() };
    let (mut dq, mut dv, da) = (lifted(&q), lifted(&still), lifted(&still));
    for i in 0..2 {
        dq[i].eps[i] = 1.0;
        dv[i].eps[2 + i] = 1.0;
    }
    let (mut force, mut rate, mut spin) = (vec![D8::zero(); n], vec![D8::zero(); z.len()], D8::zero());
    let (own, z) = (lifted(own), lifted(z));
    let seeded = At { q: &dq, v: &dv, a: &da, z: &z, phase: D8::zero(), speed: D8::lift(speed), spin_accel: D8::zero(), t: D8::zero() };
    let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
    D8::residual(&*part.part, &own, &seeded, &mut rows, &mut Blocks::default());
    // the part pulls its first point by the opposite of its rows
    let sign = if turning_first(system, slot) { 1.0 } else { -1.0 };
    let of = |first: usize| [force[0].eps[first], force[0].eps[first + 1], force[1].eps[first], force[1].eps[first + 1]];
    Some(BearingState {
        place: [sign * q[0], sign * q[1]],
        force: [-sign * force[0].re, -sign * force[1].re],
        stiffness: of(0),
        damping: of(2),
        observed,
    })
}

/// Where a rigid mass on a support begins to whirl.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    /// The mass, kg: a larger one whirls.
    pub mass: f64,
    /// Frequency of the whirl, rad/s.
    pub frequency: f64,
}

impl BearingState {
    /// The threshold of a rigid mass; `None` of a support on which every mass is stable, and of one that does not damp or hold it.
    pub fn threshold(&self) -> Option<Threshold> {
        let ([kxx, kxy, kyx, kyy], [cxx, cxy, cyx, cyy]) = (self.stiffness, self.damping);
        let held = (kxx * cyy + kyy * cxx - kxy * cyx - kyx * cxy) / (cxx + cyy);
        let square = ((kxx - held) * (kyy - held) - kxy * kyx) / (cxx * cyy - cxy * cyx);
        let found = held.is_finite() && square.is_finite() && square > 0.0 && held >= 0.0;
        found.then(|| Threshold { mass: held / square, frequency: square.sqrt() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::builder::Builder;
    use crate::model::field::Attach;
    use crate::model::part::Link;
    use crate::pencil::modes_about;
    use crate::rest::rest;
    use crate::statics::own;
    use laval_model::parts::bearing_journal::{BearingJournal, BearingJournalParams};
    use laval_model::parts::bearing_linear::{BearingLinear, BearingLinearParams};
    use laval_model::parts::disc::{Disc, DiscParams};

    /// D = 100 mm, L = 30 mm, c = 0.1 mm, 0.1 Pa s under 525 N at 1500 rpm: Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines, example 5.5.1.
    fn journal(turned: bool) -> System {
        let oil = BearingJournalParams { diameter: 0.1, length: 0.03, clearance: 1e-4, viscosity: 0.1 };
        let (rotor, ground) = (Attach::on("rotor"), Attach::ground());
        let link = if turned { Link::Between(ground, rotor) } else { Link::Between(rotor, ground) };
        Builder::new("journal")
            .horizontal()
            .part("rotor", Disc::planar(), DiscParams::new(525.0 / crate::model::system::GRAVITY))
            .part("bearing", BearingJournal::new(link), oil)
            .build()
            .unwrap()
    }

    #[test]
    fn a_short_bearing_of_the_literature() {
        let speed = 1500.0 * std::f64::consts::TAU / 60.0;
        for turned in [false, true] {
            let system = journal(turned);
            let b = bearing_state(&system, 1, &own(&system, speed).unwrap()).unwrap();
            assert!(b.force[0].abs() < 1e-6 && (b.force[1] / 525.0 - 1.0).abs() < 1e-9, "{:?}", b.force);
            let e = b.place[0].hypot(b.place[1]) / 1e-4;
            assert!((e - 0.266298).abs() < 1e-6, "{e}");
            // pushed down, the journal rests to the side that the film is dragged to
            assert!(b.place[1] < 0.0 && b.place[0] > 0.0);
            let near = |own: [f64; 4], unit: f64, book: [f64; 4]| {
                assert!(own.iter().zip(book).all(|(own, book)| (own * unit / book - 1.0).abs() < 1e-5), "{own:?}");
            };
            near(b.stiffness, 1e-6, [12.80796, 16.393593, -25.060393, 8.815303]);
            near(b.damping, 1e-3, [232.897, -81.924, -81.924, 294.912]);
        }
    }

    /// A mass at the threshold has a pair of roots on the imaginary axis at that frequency; more of it grows, less decays.
    #[test]
    fn a_mass_at_the_threshold_neither_grows_nor_decays() {
        let system = journal(false);
        let b = bearing_state(&system, 1, &own(&system, 300.0).unwrap()).unwrap();
        let found = b.threshold().unwrap();
        assert!((0.3..0.6).contains(&(found.frequency / 300.0)), "{found:?}");
        let ([kxx, kxy, kyx, kyy], [cxx, cxy, cyx, cyy]) = (b.stiffness, b.damping);
        let growth = |mass: f64| {
            let p = BearingLinearParams { kxx, kxy, kyx, kyy, cxx, cxy, cyx, cyy, kzz: 0.0, czz: 0.0 };
            let system = Builder::new("mass")
                .part("rotor", Disc::planar(), DiscParams::new(mass))
                .part("bearing", BearingLinear::constant(Link::Between(Attach::on("rotor"), Attach::ground())), p)
                .build()
                .unwrap();
            let modes = modes_about(&system, &rest(&system, 300.0).unwrap(), true).unwrap();
            modes.least_stable().unwrap().value
        };
        let at = growth(found.mass);
        assert!(at.re.abs() < 1e-9 * found.frequency && (at.im.abs() / found.frequency - 1.0).abs() < 1e-9, "{at:?} {found:?}");
        assert!(growth(1.1 * found.mass).re > 0.0 && growth(0.9 * found.mass).re < 0.0);
    }

    /// Without a load the film drives whirl at half of the speed, however small the mass; an isotropic bearing without cross terms is stable.
    #[test]
    fn limits_of_the_threshold() {
        let state = |stiffness, damping| BearingState { place: [0.0; 2], force: [0.0; 2], stiffness, damping, observed: vec![] };
        let film = state([0.0, 4e6, -4e6, 0.0], [8e4, 0.0, 0.0, 8e4]).threshold().unwrap();
        assert!(film.mass == 0.0 && (film.frequency - 50.0).abs() < 1e-12);
        assert!(state([1e6, 0.0, 0.0, 1e6], [1e3, 0.0, 0.0, 1e3]).threshold().is_none());
        assert!(state([1e6, 1e5, -1e5, 1e6], [0.0; 4]).threshold().is_none());
        assert!(state([f64::NAN; 4], [1e3; 4]).threshold().is_none());
    }
}
