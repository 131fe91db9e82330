//! One liquid on nonlinear orbits by two paths: in time, and through its impedance alone.

use super::{FILE, at, build, changed, isotropic, spatial, truncated, viscous};
use crate::common::Planar;
use laval::cavity::Cavity;
use laval::diagnostic::Diagnostics;
use laval::file::load;
use laval::model::builder::Builder;
use laval::model::capability::FrequencyDomain;
use laval::model::erased;
use laval::model::field::{Attach, Field, ParamValues, Values};
use laval::model::params::NoParams;
use laval::model::part::{Domain, Layout, Link, Params, Part, Physics, TimeForm};
use laval::model::system::{Pair, System};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::branch::State;
use laval::solve::harmonic::branches::response::{Request, Response, respond};
use laval::solve::harmonic::stability::determinant::{Effort, exponents};
use laval::solve::linear_response::response;
use laval::solve::rest::rest;
use laval::solve::roots;
use laval::study::Context;
use laval_num::complex::{C64, Complex, c};
use laval_num::scalar::Scalar;
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

/// The plane flow of the liquid in the drum, as nothing but its impedance.
struct ByImpedance(Cavity<f64>);

impl Part for ByImpedance {
    const KIND: &'static str = "by_impedance";
    const DOC: &'static str = "The plane flow of an ideal liquid without its time form.";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::point(Link::On(Attach::on("drum")))
    }
    fn physics(&self) -> Physics {
        Physics::Frequency(TimeForm::None("for comparison"))
    }
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        Some(self)
    }
}

impl FrequencyDomain for ByImpedance {
    fn impedance<S: Scalar>(&self, _: &Params<Self, S>, s: Complex<S>, speed: S, out: &mut [Complex<S>]) {
        let cavity = Cavity {
            radius: S::cst(self.0.radius),
            free: S::cst(self.0.free),
            height: S::cst(self.0.height),
            density: S::cst(self.0.density),
        };
        let forward = -cavity.planar(laval_num::complex::c(s.im, -s.re), speed);
        let mirrored = s.conj();
        let backward = (-cavity.planar(laval_num::complex::c(mirrored.im, -mirrored.re), speed)).conj();
        let (mean, skew) = ((forward + backward).scale(S::cst(0.5)), (forward - backward).mul_i().scale(S::cst(0.5)));
        for (i, x) in [mean, skew, -skew, mean].into_iter().enumerate() {
            out[i] += x;
        }
    }
    fn domain(&self, _: &Params<Self, f64>, speed: f64) -> Option<Domain> {
        Some(Domain { left: true, axis: false, waves: self.0.plane_waves(speed), gap: 0.0, ..Domain::passive() })
    }
}

fn into_strip(z: C64, width: f64) -> C64 {
    c(z.re, z.im - width * (z.im / width + 0.381_966).floor())
}

/// Distance modulo the width of the strip.
fn apart(a: C64, b: C64, width: f64) -> f64 {
    let turns = (a.im - b.im) / width;
    (a.re - b.re).hypot((turns - turns.round()) * width)
}

fn branch_of(system: &System, speed: f64, stability: bool) -> Response {
    respond(system, &Request { stability, ..Request::over(speed - 0.5, speed) }, &NEVER, &|_| {}).unwrap()
}

/// On orbits of a rotor on a cubic bearing that knows its directions: exponents of the map over the period with the liquid's states, zeros of Hill's determinant with these states, and
/// zeros of Hill's determinant with the liquid's impedance in their place.
#[test]
fn a_planar_liquid_by_two_paths() {
    let mut growing = 0;
    for (speed, fill) in [(180.0, 0.667), (420.0, 0.667), (700.0, 0.8)] {
        let machine = Planar { fill, ..Planar::default() };
        let timed = machine.builder().build().unwrap();
        let cavity = Cavity { radius: 0.07, free: 0.07 * fill, height: 0.06, density: 1000.0 };
        let dry: Builder = Planar { fill: 1.0, ..machine }.builder();
        let spectral = dry.part("liquid", ByImpedance(cavity), ()).build().unwrap();
        let found = branch_of(&timed, speed, true);
        let (branch, state) =
            found.branches.iter().flat_map(|b| b.points.iter().map(move |p| (b, p))).find(|(_, p)| (p.speed - speed).abs() < 1e-9).unwrap();
        let map = state.exponents.as_ref().unwrap();
        // the same motion through the impedance
        let mut by_states = Balance::new(&timed, branch.discretisation, (speed, speed), None).unwrap();
        let mut by_impedance = Balance::new(&spectral, branch.discretisation, (speed, speed), None).unwrap();
        let (a, b) = (Orbit::of(&mut by_states, &state.x, speed).unwrap(), Orbit::of(&mut by_impedance, &state.x, speed).unwrap());
        for (a, b) in a.coordinates.iter().zip(&b.coordinates) {
            for (a, b) in a.iter().zip(b) {
                assert!((*a - *b).abs() < 1e-11 * 1e-3, "{a:?} {b:?}");
            }
        }
        let margin = 1e-3 * speed;
        for system in [&timed, &spectral] {
            let assessed = exponents(system, branch.discretisation, &state.x, speed, &map.values, &mut Effort::endless()).unwrap();
            for z in &assessed.values {
                let near = map.values.iter().map(|&m| apart(*z, m, speed)).fold(f64::INFINITY, f64::min);
                assert!(near < 1e-8 * speed.max(z.abs()), "{speed}: {z:?} is {near:e} from {:?}", map.values);
            }
            let strong = |values: &[C64]| values.iter().filter(|z| z.re > 1.5 * margin).count();
            assert_eq!(strong(&assessed.values), strong(&map.values), "{speed}: {:?} {:?}", assessed.values, map.values);
            // from the exponents of the map every exponent is met that is no wave at rest: states and mirror images, but for those on the axis
            let off = map.values.iter().filter(|z| z.re.abs() > 1.5 * margin && z.re > -0.2 * speed).count();
            let met = |z: &C64| assessed.values.iter().any(|&j| apart(j, *z, speed) < 1e-8 * speed.max(z.abs()));
            let all = map.values.iter().filter(|z| z.re.abs() > 1.5 * margin && z.re > -0.2 * speed).filter(|z| met(z)).count();
            assert!(all == off, "{speed}: {all} of {off}: {:?} {:?}", assessed.values, map.values);
            growing += strong(&assessed.values);
        }
        assert!(into_strip(c(0.0, 1.5 * speed), speed).im < 0.7 * speed);
    }
    assert!(growing >= 4, "{growing}");
}

/// S1 with a bearing beside its shaft that hardly moves at these amplitudes.
fn with_bearing(text: &str, eccentricity: &str) -> String {
    let bearing = "\n[[part]]\nkind = \"bearing_cubic\"\nname = \"bearing\"\nbetween = [\"rotor\", \"base\"]\nlaw = \"per_axis\"\nstiffness = \"1e5 N/m\"\n\
                   cubic_stiffness = \"1e10 N/m^3\"\n";
    let text = text.split("\n[[study]]").next().unwrap();
    changed(text, &[("eccentricity = \"50 um\"", &format!("eccentricity = \"{eccentricity}\""))]) + bearing
}

/// At small amplitude harmonic balance is the linear response, whatever the liquid, and the exponents that grow are the roots of the characteristic function.
#[test]
fn spatial_and_viscous_liquids_at_small_amplitude() {
    let small = |text: &str| changed(&with_bearing(text, "5 nm"), &[("skew = 2e-4", "skew = 2e-8")]);
    for (name, text, speed, assess) in [
        ("spatial", truncated(FILE, 3).replace("\naxial_harmonics = 3", ""), 330.0, false),
        ("spatial, three harmonics", truncated(FILE, 3), 330.0, true),
        ("strip, viscous", viscous(FILE, "1e-4"), 420.0, true),
        ("spatial, viscous", viscous(&truncated(FILE, 3), "1e-4"), 420.0, true),
        ("isotropic", viscous(&isotropic(FILE), "1e-4"), 420.0, false),
    ] {
        let system = build(&small(&text));
        let found = branch_of(&system, speed, false);
        let (branch, state) =
            found.branches.iter().flat_map(|b| b.points.iter().map(move |p| (b, p))).find(|(_, p)| (p.speed - speed).abs() < 1e-9).unwrap();
        let mut balance = Balance::new(&system, branch.discretisation, (speed, speed), None).unwrap();
        let orbit = Orbit::of(&mut balance, &state.x, speed).unwrap();
        let linear = response(&system, &|w| rest(&system, w), speed).unwrap().unwrap();
        for i in 0..3 {
            let ((f, b), (lf, lb)) = (orbit.whirl(&Pair::coordinates(2 * i), 1), linear.circles(2 * i));
            let off = (f - lf).abs() + (b.conj() - lb).abs().min((b - lb).abs());
            assert!(off < 1e-8 * (lf.abs() + lb.abs()), "{name} {i}: {f:?} {lf:?} {b:?} {lb:?}");
        }
        if !assess {
            continue;
        }
        let assessed = exponents(&system, branch.discretisation, &state.x, speed, &[], &mut Effort::endless()).unwrap();
        let margin = 1e-3 * speed;
        let found = at(&system, speed, &roots::Request { margin, growing: true, ..roots::Request::default() });
        let growing: Vec<C64> = found.spectrum.modes.iter().map(|m| m.value).filter(|z| z.re > margin).collect();
        assert!(!growing.is_empty() && found.growing() == Some(growing.len()), "{name}: {:?}", found.areas);
        let strong = assessed.values.iter().filter(|z| z.re > margin).count();
        assert_eq!(strong, 2 * growing.len(), "{name}: {:?} {growing:?}", assessed.values);
        for z in growing {
            let near = assessed.values.iter().map(|&j| apart(j, z, speed)).fold(f64::INFINITY, f64::min);
            assert!(near < 1e-7 * z.abs(), "{name}: {z:?} {:?}", assessed.values);
        }
    }
}

/// Over the speeds of S1: as many exponents grow as roots of the characteristic function, once with no order that moves another, once with all of them moved.
#[test]
fn exponents_are_counted_at_every_speed() {
    let mut met = [0usize; 4];
    for (name, text) in [
        ("no nonlinear part", truncated(FILE, 3).split("\n[[study]]").next().unwrap().to_string()),
        ("hardly moving", changed(&with_bearing(&truncated(FILE, 3), "5 nm"), &[("skew = 2e-4", "skew = 2e-8")])),
        ("moving", with_bearing(&truncated(FILE, 3), "5 um")),
        ("viscous", with_bearing(&viscous(&truncated(FILE, 3), "1e-4"), "5 um")),
    ] {
        let system = build(&text);
        let before = met.iter().sum::<usize>();
        for k in 0..12 {
            let speed = 95.0 + 71.0 * k as f64;
            let found = branch_of(&system, speed, false);
            let near = |p: &&State| (p.speed - speed).abs() < 1e-9;
            let Some((branch, state)) = found.branches.iter().find_map(|b| Some((b, b.points.iter().find(near)?))) else { continue };
            let assessed = exponents(&system, branch.discretisation, &state.x, speed, &[], &mut Effort::endless())
                .unwrap_or_else(|e| panic!("{name}, {speed}: {e}"));
            let margin = 1e-3 * speed;
            let roots = at(&system, speed, &roots::Request { margin, growing: true, ..roots::Request::default() });
            let growing: Vec<C64> = roots.spectrum.modes.iter().map(|m| m.value).filter(|z| z.re > margin).collect();
            if growing.iter().any(|z| z.re < 1.5 * margin) || assessed.values.iter().any(|z| (z.re - margin).abs() < 0.5 * margin) {
                continue;
            }
            let strong = assessed.values.iter().filter(|z| z.re > margin).count();
            assert_eq!(strong, 2 * growing.len(), "{name}, {speed}: {:?} {growing:?}", assessed.values);
            for z in &growing {
                let near = assessed.values.iter().map(|&j| apart(j, *z, speed)).fold(f64::INFINITY, f64::min);
                assert!(near < 1e-2 * z.re, "{name}, {speed}: {z:?} {:?}", assessed.values);
            }
            met[growing.len().min(3)] += 1;
        }
        assert!(met.iter().sum::<usize>() > before + 5, "{name}: {met:?}");
    }
    assert!(met[0] > 5 && met[1] > 12, "{met:?}");
}

/// Orders among the inertial waves of an ideal liquid are reported; odd orders are not among them, and viscosity has an answer.
#[test]
fn orders_inside_the_dense_range() {
    let study = |symmetry: &str| {
        format!(
            "\n[[study]]\nkind = \"nonlinear_response\"\nspeed = {{ from = \"60 rad/s\", to = \"62 rad/s\" }}\nharmonics = 3\nsymmetry = \"{symmetry}\"\nstability = false\n"
        )
    };
    let run = |text: &str| {
        let machine = load(text).unwrap_or_else(|d| panic!("{d:?}"));
        machine.studies[0].study.run(&machine.system, &Context::quiet("study"))
    };
    let ideal = with_bearing(&truncated(FILE, 3).replace("\naxial_harmonics = 3", ""), "5 um");
    let refused = run(&format!("{ideal}{}", study("none"))).unwrap_err();
    let says = |text: &str| refused.message.contains(text);
    // the speeds at which it is tried lie inside the range, the first one tells
    assert!(says("order 2 of the motion") && says("dense range of inertial waves of an ideal liquid") && says("from -60.1"), "{refused}");
    assert!(
        ["half", "viscosity", "axial_harmonics", "strip"].iter().all(|w| refused.help.as_ref().is_some_and(|h| h.contains(w))),
        "{refused}"
    );
    let reported = |text: &str| run(text).unwrap().findings.into_iter().find(|f| f.id == "inside_dense_range");
    assert!(reported(&format!("{ideal}{}", study("half"))).is_none());
    // of the waves of a few harmonics there is a response, and it is said to be that of these waves
    let few = with_bearing(&truncated(FILE, 3), "5 um");
    let finding = reported(&format!("{few}{}", study("none"))).unwrap();
    assert!(
        finding.sentence().contains("Order 2 of the response lies in the continuous spectrum")
            && finding.sentence().contains("axial harmonics kept"),
        "{}",
        finding.sentence()
    );
    assert_eq!(finding.value, Some(62.0));
    assert!(reported(&format!("{few}{}", study("half"))).is_none());
    // of a motion of three turns of the rotor there are more, of one sign and the other
    let thrice = study("half").replace("harmonics = 3", "harmonics = 7\nsubharmonic = 3");
    let finding = reported(&format!("{few}{thrice}")).unwrap();
    let orders: Vec<f64> = finding.evidence.iter().filter(|e| e.what == "order").map(|e| e.value).collect();
    let should = [-1.0 / 3.0, 1.0 / 3.0, 5.0 / 3.0, 7.0 / 3.0];
    assert!(orders.len() == 4 && orders.iter().zip(should).all(|(a, b)| (a - b).abs() < 1e-12), "{orders:?}");
    let refused = run(&format!("{ideal}{thrice}")).unwrap_err();
    assert!(refused.code == "harmonic.dense" && refused.message.contains("-0.3333, 0.3333, 1.6667, 2.3333"), "{refused}");
    // the linear response has the orders 1 and -1 alone, where all is known in closed form
    let linear = "\n[[study]]\nkind = \"forced_response\"\nspeed = { from = \"60 rad/s\", to = \"62 rad/s\", points = 5 }\n";
    assert!(reported(&format!("{}{linear}", spatial(FILE))).is_none());
    let thick = with_bearing(&viscous(&truncated(FILE, 3), "1e-4"), "5 um");
    assert!(reported(&format!("{thick}{}", study("none"))).is_none());
}
