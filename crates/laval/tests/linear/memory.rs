//! Memory states and frequency-domain parts in the linear studies.

use crate::common;

use common::Planar;
use laval::model::blocks::{Axes, Blocks, Memory};
use laval::model::builder::Builder;
use laval::model::capability::{Contacts, FrequencyDomain};
use laval::model::erased;
use laval::model::field::{Attach, Field, ParamValues, RangeValue, Values};
use laval::model::params::NoParams;
use laval::model::part::{At, Dof, DofKind, Domain, Layout, Link, Params, Part, Physics, Rows, TimeForm, Uses};
use laval::model::system::System;
use laval::outcome::Status;
use laval::parts::disc::*;
use laval::solve::co_rotating::turning;
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::study::campbell::Campbell;
use laval::study::criterion::Criterion;
use laval::study::forced_response::at_speed;
use laval::study::modes::Modes;
use laval::study::stability_map::StabilityMap;
use laval::study::{Context, ErasedStudy, support::About};
use laval_num::complex::{C64, Complex, c};
use laval_num::scalar::Scalar;

const K: f64 = 2e6;
const GAIN: f64 = -3e8;
const RATE: f64 = 400.0;
const FAST: f64 = 1e9;

/// Spring to the ground with two relaxing branches, one very fast; as memory states or as impedance only.
struct Relaxing {
    rotor: bool,
    impedance: bool,
}

impl Part for Relaxing {
    const KIND: &'static str = "relaxing";
    const DOC: &'static str = "";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut laval::diagnostic::Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        let mut l = Layout::point(Link::On(Attach::on("disc")));
        if !self.impedance {
            l.states = Dof::pair("slow_", DofKind::VectorX, "m s", 1e-6);
            l.states.extend(Dof::pair("fast_", DofKind::VectorX, "m s", 1e-12));
        }
        l
    }
    fn memory(&self) -> usize {
        if self.impedance { 0 } else { 4 }
    }
    fn physics(&self) -> Physics {
        if self.impedance { Physics::Frequency(TimeForm::None("it is a formula in s")) } else { Physics::Linear }
    }
    fn linear<S: Scalar>(&self, _: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        for i in 0..2 {
            b.stiffness[(i, i)] = S::cst(K);
        }
        for (rate, gain) in [(RATE, GAIN), (FAST, -1e12)] {
            for (i, axes) in [(0, Axes::RotorX), (1, Axes::RotorY)] {
                let axes = if self.rotor { axes } else { Axes::Fixed };
                b.memory.push(Memory { rate: S::cst(rate), gain: S::cst(gain), input: i, output: i, axes });
            }
        }
    }
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        Some(self)
    }
}

impl FrequencyDomain for Relaxing {
    fn impedance<S: Scalar>(&self, _: &Params<Self, S>, s: Complex<S>, _: S, out: &mut [Complex<S>]) {
        let branch = |rate: f64, gain: f64| (s + Complex::real(S::cst(rate))).recip().scale(S::cst(gain));
        let z = Complex::real(S::cst(K)) + branch(RATE, GAIN) + branch(FAST, -1e12);
        out[0] += z;
        out[3] += z;
    }
    fn domain(&self, _: &Params<Self, f64>, _: f64) -> Option<Domain> {
        Some(Domain { gap: RATE, ..Domain::passive() })
    }
}

const MASS: f64 = 4.0;

fn machine(rotor: bool, impedance: bool) -> System {
    Builder::new("relaxing")
        .part("disc", Disc::planar(), DiscParams { eccentricity: 1e-4, ..DiscParams::new(MASS) })
        .part("shaft", Relaxing { rotor, impedance }, ())
        .build()
        .unwrap()
}

/// m s^2 + k + sum gain/(s + rate), in axes that turn with `turn`, over the size of its terms.
fn closed(s: C64, turn: f64) -> f64 {
    let r = s - c(0.0, turn);
    let terms = [(s * s).scale(MASS), c(K, 0.0), c(GAIN, 0.0) / (r + c(RATE, 0.0)), c(-1e12, 0.0) / (r + c(FAST, 0.0))];
    terms.iter().fold(c(0.0, 0.0), |a, b| a + *b).abs() / terms.iter().map(|t| t.abs()).sum::<f64>()
}

#[test]
fn memory_is_polished_on_the_exact_function() {
    for (rotor, speed) in [(false, 300.0), (true, 300.0), (true, 1500.0)] {
        let system = machine(rotor, false);
        let spectrum = modes_about(&system, &rest(&system, speed).unwrap(), false).unwrap();
        assert_eq!(spectrum.modes.len(), 4);
        assert_eq!(spectrum.polished, 4);
        for m in &spectrum.modes {
            // the sign of the frequency is the sector's: try both, and the memory's own decay sits on its pole
            let turn = if rotor { speed } else { 0.0 };
            let defect = closed(m.value, turn).min(closed(m.value.conj(), turn));
            assert!(defect < 1e-12 || m.value.re < -0.9 * FAST, "{rotor} {speed} {:?} {defect:e}", m.value);
        }
        let growing = spectrum.modes.iter().any(|m| m.growth() > 0.0);
        // damping that turns with the rotor destabilises above the critical speed, damping in fixed axes never
        assert_eq!(growing, rotor && speed > 1000.0, "{rotor} {speed}");
    }
}

#[test]
fn memory_about_a_turning_state() {
    let system = machine(true, false);
    let speed = 300.0;
    let fixed = modes_about(&system, &rest(&system, speed).unwrap(), true).unwrap();
    let state = turning(&system, speed, None).unwrap();
    let rotating = modes_about(&system, &state, true).unwrap();
    for m in fixed.modes.iter().filter(|m| m.value.re > -0.9 * FAST) {
        let signed = if m.sector == Some(laval::solve::sectors::Sector::Backward) { m.value.conj() } else { m.value };
        let seen = signed - c(0.0, speed);
        let d = rotating.modes.iter().map(|r| (r.value - seen).abs().min((r.value.conj() - seen).abs())).fold(f64::INFINITY, f64::min);
        assert!(d < 1e-9 * seen.abs(), "{:?} {d:e}", m.value);
    }
    // the turning state is the unbalance response
    let r = at_speed(&system, speed).unwrap().unwrap();
    assert!((state.q[0] - r.x[0].re).abs() < 1e-12 * r.x[0].abs() && (state.q[1] - r.x[1].re).abs() < 1e-12 * r.x[0].abs());
}

#[test]
fn impedance_answers_in_frequency_and_as_modes() {
    let (exact, memory) = (machine(false, true), machine(false, false));
    let (a, b) = (at_speed(&exact, 500.0).unwrap().unwrap(), at_speed(&memory, 500.0).unwrap().unwrap());
    assert!((a.x[0] - b.x[0]).abs() < 1e-13 * b.x[0].abs());
    // roots of the formula are those of the memory states it stands for, but for the real ones of the memory itself
    let modes = |system: &System| {
        let out =
            Modes { speed: 500.0, about: About::Rest, threshold: 0.0, frequency: None }.run(system, &Context::quiet("modes")).unwrap();
        let table = out.tables.iter().find(|t| t.name() == "modes").unwrap();
        let column = |name: &str| (0..table.rows()).map(|r| table.column(name).unwrap().number(r).unwrap()).collect::<Vec<f64>>();
        let all: Vec<C64> = column("growth").into_iter().zip(column("frequency")).map(|(g, w)| c(g, w)).collect();
        let findings: Vec<String> = out.findings.iter().map(|f| f.id.to_string()).collect();
        (all, findings)
    };
    let ((formula, reported), (states, _)) = (modes(&exact), modes(&memory));
    assert!(reported.iter().any(|id| id == "all_roots"), "{reported:?}");
    for z in states.iter().filter(|z| z.im > 1.0) {
        assert!(formula.iter().any(|f| (*f - *z).abs() < 1e-9 * z.abs()), "{z:?} is not among {formula:?}");
    }
}

/// A contact without stiffness at rest.
struct Loose;

impl Part for Loose {
    const KIND: &'static str = "loose";
    const DOC: &'static str = "";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut laval::diagnostic::Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::point(Link::On(Attach::on("drum")))
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn uses(&self) -> Uses {
        Uses { velocity: false, acceleration: false, spin: false }
    }
    fn residual<S: Scalar>(&self, _: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let r = at.q[0].norm2(at.q[1]);
        out.force[0] += r * at.q[0];
        out.force[1] += r * at.q[1];
    }
    fn contacts(&self) -> Option<&dyn erased::Contacts> {
        Some(self)
    }
}

impl Contacts for Loose {
    fn refuses_rest(&self, _: &Params<Self, f64>) -> Option<laval::text::Text> {
        Some(laval::text!("give a preload"))
    }
}

#[test]
fn a_part_that_refuses_rest_is_named() {
    let system = Planar::default().builder().part("contact", Loose, ()).build().unwrap();
    let e = rest(&system, 10.0).unwrap_err();
    assert!(e.message.contains("\"contact\"") && e.message.contains("give a preload"), "{e}");
    // the bearing's law is per axis, which turning states do not bear
    let e = turning(&system, 10.0, None).unwrap_err();
    assert!(e.message.contains("\"bearing\""), "{e}");
}

#[test]
fn one_line_map_and_campbell_tell_the_same_story() {
    let system = Planar { fill: 0.667, ..Planar::default() }.build();
    let speed = RangeValue { from: 1500.0, to: 6000.0, points: Some(40) };
    let map = StabilityMap { speed, parameter: None, about: About::Rest, criterion: Criterion::Growth, threshold: 1.0, frequency: None }
        .run(&system, &Context::quiet("map"))
        .unwrap();
    let edges: Vec<f64> = map.special_points.iter().filter(|p| p.kind != "growth_peak").map(|p| p.at).collect();
    assert_eq!(edges.len(), 2);
    assert!(map.special_points.iter().all(|p| p.status == Status::Located));
    let campbell = Campbell { speed, orders: vec![1.0], threshold: 1.0, frequency: None, compare: false }
        .run(&system, &Context::quiet("campbell"))
        .unwrap();
    let t = campbell.find_table("modes").unwrap();
    for k in 0..t.rows() {
        let number = |name: &str| t.column(name).unwrap().number(k).unwrap();
        let (w, growth) = (number("speed"), number("growth"));
        if growth > 1.0 {
            assert!(w > edges[0] && w < edges[1], "{w} {growth}");
        }
    }
}
