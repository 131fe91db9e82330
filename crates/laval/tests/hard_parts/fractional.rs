//! A part exact in the frequency domain only: `F = c s^a d` per axis, a damper of fractional order; with and without a fitted time form.

use super::tools::{orbits, response};
use laval::diagnostic::Diagnostics;
use laval::model::blocks::Blocks;
use laval::model::builder::Builder;
use laval::model::capability::FrequencyDomain;
use laval::model::erased;
use laval::model::field::{Attach, Bounds, Field, ParamValues, Value, Values};
use laval::model::params::Family;
use laval::model::part::{Domain, Layout, Link, Params, Part, Physics, TimeForm};
use laval::model::system::{Pair, System};
use laval::params;
use laval::parts::{bearing_cubic::*, disc::*};
use laval::solve::harmonic::stability::floquet::Unassessed;
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::pencil::modes_about;
use laval::solve::programme::Programme;
use laval::solve::rest::rest;
use laval::solve::symmetry::{Symmetry, probe};
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::{Context, ErasedStudy, Study};
use laval_num::complex::{C64, Complex, c};
use laval_num::scalar::Scalar;

params! {
    /// Parameters of a [`Fractional`] damper.
    pub struct FractionalParams in FractionalFamily {
        strength: lateral, "N s^a/m", Bounds::up_to(1e12), required, "c";
        order: scalar, "", Bounds::positive(2.0), required, "a";
    }
}

pub struct Fractional {
    link: Link,
    time: TimeForm,
    /// It says where it is analytic.
    declared: bool,
}

const WHY: &str = "a fractional derivative remembers the whole past";

/// s^a, principal branch, 0 at 0.
fn power<S: Scalar>(s: Complex<S>, a: S) -> Complex<S> {
    let r = s.re.norm2(s.im);
    let size = r.select_pos((a * r.ln()).exp(), S::zero());
    Complex::cis(a * s.im.atan2(s.re)).scale(size)
}

impl Part for Fractional {
    const KIND: &'static str = "fractional";
    const DOC: &'static str = "A damper of fractional order.";
    type Family = FractionalFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::point(self.link.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Frequency(self.time)
    }
    /// Stiffness and damping that agree with it at 500 rad/s.
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let w = 500.0;
        let z = power(c(S::zero(), S::cst(w)), p.order);
        for i in 0..2 {
            b.stiffness[(i, i)] = p.strength[i] * z.re;
            b.damping[(i, i)] = (p.strength[i] * z.im).scale(1.0 / w);
        }
    }
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        Some(self)
    }
}

impl FrequencyDomain for Fractional {
    fn impedance<S: Scalar>(&self, p: &Params<Self, S>, s: Complex<S>, _: S, out: &mut [Complex<S>]) {
        for i in 0..2 {
            out[3 * i] += power(s, p.order).scale(p.strength[i]);
        }
    }
    /// A branch cut to the left from 0.
    fn domain(&self, _: &Params<Self, f64>, _: f64) -> Option<Domain> {
        self.declared.then(|| Domain { waves: vec![0.0], gap: 0.0, ..Domain::passive() })
    }
}

const MASS: f64 = 3.0;
const LOAD: f64 = 3e-4;
const SPRING: f64 = 1e6;
const STRENGTH: f64 = 6e3;
const ORDER: f64 = 0.6;

fn machine(time: TimeForm, strength: [f64; 2], cubic: f64, horizontal: bool) -> System {
    declaring(false, time, strength, cubic, horizontal)
}

fn declaring(declared: bool, time: TimeForm, strength: [f64; 2], cubic: f64, horizontal: bool) -> System {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let bearing = BearingCubicParams { stiffness: [SPRING; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 };
    let b = Builder::new("fractional")
        .part("disc", Disc::planar(), DiscParams { unbalance: LOAD, ..DiscParams::new(MASS) })
        .part("bearing", BearingCubic::isotropic(link()), bearing)
        .part("polymer", Fractional { link: link(), time, declared }, FractionalParams { strength, order: ORDER });
    if horizontal { b.horizontal() } else { b }.build().unwrap()
}

#[test]
fn impedance_is_that_of_a_real_force() {
    let part = Fractional { link: Link::Between(Attach::on("a"), Attach::ground()), time: TimeForm::None(WHY), declared: false };
    for s in [c(0.0, 300.0), c(-20.0, 40.0), c(5.0, -700.0), c(0.0, 0.0)] {
        let (mut z, mut zc) = ([C64::zero(); 4], [C64::zero(); 4]);
        let p = FractionalFamily::to_vec(&FractionalParams { strength: [2.0, 3.0], order: 0.4 });
        erased::FrequencyDomain::impedance_f64(&part, &p, s, 100.0, &mut z);
        erased::FrequencyDomain::impedance_f64(&part, &p, s.conj(), 100.0, &mut zc);
        for (z, zc) in z.iter().zip(zc) {
            assert!((*z - zc.conj()).abs() <= 1e-15 * z.abs() && z.is_finite());
        }
    }
}

#[test]
fn linear_response_is_exact() {
    for strength in [[STRENGTH; 2], [STRENGTH, 0.3 * STRENGTH]] {
        for horizontal in [false, true] {
            let (system, range) = (machine(TimeForm::None(WHY), strength, 0.0, horizontal), (50.0, 2000.0));
            let found = response(&system, range);
            let Some(Unassessed::NoTimeForm(part, why)) = &found.unassessed else { panic!("{:?}", found.unassessed) };
            assert_eq!((part.as_str(), *why), ("polymer", WHY));
            for orbit in orbits(&system, &found, range) {
                let w = orbit.speed;
                let first = orbit.orders.iter().position(|&k| k == 1).unwrap();
                let z = |i: usize| {
                    let angle = 0.5 * std::f64::consts::PI * ORDER;
                    let damper = C64::cis(angle).scale(strength[i] * w.powf(ORDER));
                    damper + c(SPRING - MASS * w * w, 0.0)
                };
                let force = LOAD * w * w;
                let (x, y) = (c(force, 0.0) / z(0), c(0.0, -force) / z(1));
                let got = &orbit.coordinates[first];
                assert!((got[0] - x).abs() < 1e-11 * x.abs(), "{strength:?} at {w}: {:?} {x:?}", got[0]);
                assert!((got[1] - y).abs() < 1e-11 * y.abs(), "{strength:?} at {w}: {:?} {y:?}", got[1]);
                if horizontal {
                    let sag = orbit.coordinates[orbit.orders.iter().position(|&k| k == 0).unwrap()][1].re;
                    assert!((sag + MASS * 9.80665 / SPRING).abs() < 1e-11 * sag.abs(), "{sag}");
                }
            }
        }
    }
}

/// With the word of the part that it is analytic right of the imaginary axis its motions are assessed on Hill's determinant with the exact impedance, and its roots are counted.
#[test]
fn where_it_is_analytic_lets_it_be_assessed() {
    for strength in [[STRENGTH; 2], [STRENGTH, 0.3 * STRENGTH]] {
        let system = declaring(true, TimeForm::None(WHY), strength, 0.0, false);
        let found = response(&system, (50.0, 2000.0));
        assert!(found.unassessed.is_none(), "{:?}", found.unassessed);
        let states: Vec<_> = found.branches.iter().flat_map(|b| &b.points).collect();
        assert!(states.len() > 2, "{}", states.len());
        for state in states {
            let assessed = state.exponents.as_ref().unwrap();
            assert!(assessed.stable(), "{} rad/s: {assessed:?}", state.speed);
        }
        // m s^2 + k + c s^a = 0 of each axis, by Newton's method from the spring alone
        let spectrum = modes_about(&system, &rest(&system, 300.0).unwrap(), false).unwrap();
        for strength in strength {
            let mut s = c(-1.0, (SPRING / MASS).sqrt());
            for _ in 0..50 {
                let damper = power(s, ORDER).scale(strength);
                let value = (s * s).scale(MASS) + c(SPRING, 0.0) + damper;
                s -= value / (s.scale(2.0 * MASS) + damper.scale(ORDER) / s);
            }
            assert!(spectrum.modes.iter().any(|m| (m.value - s).abs() < 1e-10 * s.abs()), "{s:?}: {:?}", spectrum.modes);
        }
    }
}

/// With the isotropic cubic law the motion is one circle: its equation by hand.
#[test]
fn nonlinear_circle_is_exact() {
    let cubic = 4e12;
    let (system, range) = (machine(TimeForm::None(WHY), [STRENGTH; 2], cubic, false), (50.0, 1500.0));
    let found = response(&system, range);
    assert_eq!(found.discretisation.symmetry, Symmetry::Circular);
    for orbit in orbits(&system, &found, range) {
        let (w, d) = (orbit.speed, orbit.whirl(&Pair::coordinates(0), 1).0);
        let z = C64::cis(0.5 * std::f64::consts::PI * ORDER).scale(STRENGTH * w.powf(ORDER));
        let rest = d * (z + c(SPRING - MASS * w * w + cubic * d.norm_sqr(), 0.0)) - c(LOAD * w * w, 0.0);
        assert!(rest.abs() < 1e-10 * SPRING * d.abs(), "{w}: {rest:?}");
    }
}

#[test]
fn an_anisotropic_impedance_breaks_the_symmetry() {
    let found = |strength| probe(&machine(TimeForm::None(WHY), strength, 4e12, false), &[400.0]);
    assert_eq!(found([STRENGTH; 2]).0, Symmetry::Circular);
    let (symmetry, broken) = found([STRENGTH, 0.3 * STRENGTH]);
    assert_eq!(symmetry, Symmetry::Half);
    assert!(broken.iter().all(|b| b.part == "polymer") && broken.len() == 2, "{broken:?}");
}

#[test]
fn studies_in_time_refuse_it_by_name() {
    let system = machine(TimeForm::None(WHY), [STRENGTH; 2], 0.0, false);
    let at = rest(&system, 300.0).unwrap();
    let refusals = [
        modes_about(&system, &at, false).err().unwrap(),
        Motion::new(&system, SpinLaw::Programme(Programme::constant(300.0, 0.0))).err().unwrap(),
    ];
    for d in refusals {
        assert!(d.message.contains("\"polymer\"") && d.message.contains(WHY), "{d}");
    }
}

fn study(system: &System) -> laval::outcome::Outcome {
    let mut values = Values::default();
    values.set("speed", Value::Range(laval::model::field::RangeValue { from: 100.0, to: 900.0, points: None }), None);
    let study = NonlinearResponse::build(&values, system, &mut Diagnostics::default()).unwrap();
    ErasedStudy::run(&study, system, &Context::quiet("response")).unwrap()
}

/// A fitted time form serves stability, and its error is said; the response itself stays exact.
#[test]
fn the_error_of_a_fit_is_evidence() {
    let error = 0.037;
    let system = machine(TimeForm::Fit(error), [STRENGTH; 2], 4e12, false);
    let outcome = study(&system);
    let said = outcome.findings.iter().find(|f| f.id == "stability_fit").unwrap_or_else(|| panic!("{:?}", outcome.findings));
    assert!(said.sentence().contains("\"polymer\"") && said.evidence.iter().any(|e| e.value == error), "{said:?}");
    let (a, b) = (response(&system, (100.0, 900.0)), response(&machine(TimeForm::None(WHY), [STRENGTH; 2], 4e12, false), (100.0, 900.0)));
    assert!(a.unassessed.is_none() && b.unassessed.is_some());
    for (p, q) in a.branches.iter().flat_map(|b| &b.points).zip(b.branches.iter().flat_map(|b| &b.points)) {
        assert_eq!((p.speed, &p.x), (q.speed, &q.x));
    }
    let none = study(&machine(TimeForm::None(WHY), [STRENGTH; 2], 4e12, false));
    let unknown = none.findings.iter().find(|f| f.id == "stability_unknown").unwrap();
    assert!(unknown.sentence().contains("\"polymer\"") && unknown.sentence().contains(WHY), "{unknown:?}");
}

/// Different in x and y, without a time form.
pub fn linear() -> System {
    machine(TimeForm::None(WHY), [STRENGTH, 0.3 * STRENGTH], 0.0, false)
}
