//! The studies in time: against closed forms, eigenvalues and each other; bad inputs; partial results.

use crate::common;

use common::Base;
use laval::diagnostic::Diagnostics;
use laval::model::builder::Builder;
use laval::model::capability::Contacts;
use laval::model::erased;
use laval::model::field::{Attach, Field, ParamValues, Value, Values};
use laval::model::params::NoParams;
use laval::model::part::*;
use laval::model::system::System;
use laval::outcome::{Data, End, Level, Outcome};
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*, liquid::*};
use laval::solve::motion::envelope::growth;
use laval::solve::motion::trajectory::{Choice, Plan, Trajectory, simulate};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::programme::Programme;
use laval::study::run_up::RunUp;
use laval::study::transient::Transient;
use laval::study::{Cancel, Context, ErasedStudy, Silent, Study};
use laval_num::complex::{C64, c};
use laval_num::ode::Ode;
use laval_num::scalar::Scalar;
use std::sync::atomic::{AtomicBool, Ordering};

fn values(list: &[(&str, Value)]) -> Values {
    let mut v = Values::default();
    for (name, value) in list {
        v.set(name, value.clone(), None);
    }
    v
}

fn number(x: f64) -> Value {
    Value::Number(x)
}

fn states(list: &[(&str, f64)]) -> Value {
    Value::StateMap(list.iter().map(|&(n, x)| (n.to_string(), x, 0..1)).collect())
}

fn run<S: Study>(system: &System, list: &[(&str, Value)]) -> Outcome {
    let mut d = Diagnostics::default();
    let study = S::build(&values(list), system, &mut d);
    assert!(d.0.is_empty(), "{d:?}");
    study.unwrap().run(system, &Context::quiet("t")).unwrap()
}

fn refused<S: Study>(system: &System, list: &[(&str, Value)]) -> String {
    let mut d = Diagnostics::default();
    assert!(S::build(&values(list), system, &mut d).is_none());
    d.0.iter().map(|d| format!("{d}\n")).collect()
}

fn column<'a>(o: &'a Outcome, table: &str, name: &str) -> &'a [f64] {
    match &o.find_table(table).unwrap().column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v,
        _ => panic!("{name} is no number"),
    }
}

fn finding(o: &Outcome, id: &str) -> f64 {
    o.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("no finding {id}")).value.unwrap()
}

/// The base set with a linear bearing.
fn linear(e: f64, fill: Option<f64>, chi: f64, chi0: f64) -> System {
    let disc = DiscParams { eccentricity: e, polar_inertia: 0.01, ..DiscParams::new(2.4) };
    let joint = Link::Between(Attach::on("drum"), Attach::on("base"));
    let ground = Link::Between(Attach::on("drum"), Attach::ground());
    let mut b = Builder::new("linear")
        .part("drum", Disc::planar(), disc)
        .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: [3.26e5; 2], damping: [chi0; 2] })
        .part(
            "bearing",
            BearingCubic::isotropic(joint),
            BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 },
        )
        .part("air", Damper::fixed(ground), DamperParams { damping: [chi; 2], tilt_damping: 0.0 });
    if let Some(r) = fill {
        let p = LiquidParams { wave_damping: 0.0, ..LiquidParams::new(0.07, 0.06, 1000.0, 0.07 * r) };
        b = b.part("liquid", Liquid::new(Attach::on("drum"), Fill::Partial), p);
    }
    b.build().unwrap()
}

/// Steady circular response of the empty linear machine.
fn steady(speed: f64, e: f64) -> (C64, C64) {
    let k1 = c(1.1e7 - 2.4 * speed * speed, 42.0 * speed);
    let k2 = c(1.1e7 + 3.26e5 - 25.0 * speed * speed, 6.59 * speed);
    let det = k1 * k2 - c(1.1e7 * 1.1e7, 0.0);
    let f = 2.4 * e * speed * speed;
    (k2.scale(f) / det, c(1.1e7 * f, 0.0) / det)
}

#[test]
fn study_reaches_the_reference_end_state_and_closes_its_balance() {
    let system = Base { fill: Some(0.8), wave_damping: 20.0, ..Base::default() }.builder().build().unwrap();
    let list = [
        ("duration", number(0.05)),
        ("speed", number(2000.0)),
        ("initial", states(&[("drum.x", 1e-4)])),
        ("relative_tolerance", number(1e-12)),
        ("absolute_tolerance", number(1e-12)),
        ("velocities", Value::Flag(true)),
        ("points", Value::Integer(20_001)),
    ];
    let o = run::<Transient>(&system, &list);
    assert_eq!(o.end, End::Reached);
    let want = [
        ("drum.x", 0.006651349909),
        ("drum.y", -0.002022407778),
        ("drum.x'", 1.60602607),
        ("drum.y'", 13.31563285),
        ("base.x", -0.0009018062842),
        ("base.y", -0.0009974692977),
        ("liquid.surface_x", -0.00658957267),
        ("liquid.surface_y", 0.0009131497997),
    ];
    for (name, want) in want {
        let got = *column(&o, "motion", name).last().unwrap();
        assert!((got - want).abs() < 1e-8 * want.abs(), "{name}: {got:e} {want:e}");
    }
    assert_eq!(o.find_table("motion").unwrap().column("drum.x'").unwrap().unit, "m/s");
    let balance = finding(&o, "energy_balance");
    assert!(balance < 1e-9, "{balance:e}");
    // the largest displacement against the outputs, 5 mrad of whirl apart
    let (x, y) = (column(&o, "motion", "drum.x"), column(&o, "motion", "drum.y"));
    let most = x.iter().zip(y).map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    let found = finding(&o, "largest_displacement");
    assert!(found >= most * (1.0 - 1e-9) && found < most * (1.0 + 1e-5), "{found} {most}");
    assert!(o.findings.iter().any(|f| f.id == "validity"));
    assert!(column(&o, "observed", "bearing.force").iter().all(|x| x.is_finite()));
}

fn trajectory(motion: &mut Motion, y: &[f64], t_end: f64, windows: usize, tolerance: f64) -> Trajectory {
    let plan = Plan {
        t_end,
        choice: Choice::Explicit,
        relative: tolerance,
        absolute: tolerance,
        outputs: &[],
        windows,
        rest: &[],
        bound: f64::INFINITY,
        kick: None,
        max_steps: u64::MAX,
        cancel: &|| false,
        progress: &|_| {},
    };
    simulate(motion, y, &plan).unwrap()
}

/// Growth and whirl frequency from the envelope against eigenvalues (e = 0, linear bearing): damping, fill, speed, growth, frequency.
#[test]
fn growth_from_time_is_the_eigenvalue() {
    let rows = [
        (42.0, 0.93, 2500.0, 209.875276, 2014.053377),
        (42.0, 0.8, 3000.0, 231.4462558, 2051.073956),
        (42.0, 0.667, 3000.0, 192.0108286, 1966.243843),
        (42.0, 0.667, 2600.0, 86.47837268, 1830.288075),
        (42.0, 0.5, 3200.0, 150.4758255, 1968.036901),
        (42.0, 0.125, 3300.0, 35.86453144, 1938.534096),
        (42.0, 0.93, 135.0, 3.672774113, 107.5474851),
        (0.0, 0.93, 2500.0, 212.931033, 2014.326316),
        (0.0, 0.8, 3000.0, 234.4728281, 2050.109617),
        (0.0, 0.667, 3000.0, 194.929817, 1966.064027),
        (0.0, 0.667, 2600.0, 89.23476678, 1834.235816),
        (0.0, 0.5, 3200.0, 153.3224967, 1967.557672),
        (0.0, 0.125, 3300.0, 38.56162932, 1938.427764),
        (0.0, 0.93, 135.0, 4.08393491, 107.5877298),
    ];
    for (chi, fill, speed, rate, frequency) in rows {
        let system = linear(0.0, Some(fill), chi, if chi == 0.0 { 0.0 } else { 6.59 });
        let mut m = Motion::new(&system, SpinLaw::Programme(Programme::constant(speed, 0.0))).unwrap();
        let mut y = vec![0.0; m.dim()];
        y[0] = 1e-4;
        // by half time all else is below the growing mode by exp(-25)
        let f = trajectory(&mut m, &y, 50.0 / rate, 200, 1e-11);
        let g = growth(&f.windows[0], std::f64::consts::TAU / speed).unwrap();
        assert!((g.rate - rate).abs() < 1e-6 * rate, "{chi} {fill} {speed}: {} {rate} {:e}", g.rate, g.uncertainty);
        assert!((g.frequency - frequency).abs() < 1e-6 * frequency, "{} {frequency}", g.frequency);
        assert!(g.uncertainty < 1e-5 * rate, "{:e}", g.uncertainty);
    }
}

#[test]
fn steady_orbit_stays() {
    let system = linear(1e-3, None, 42.0, 6.59);
    let speed = 900.0;
    let (z1, z2) = steady(speed, 1e-3);
    let list = [
        ("duration", number(0.5)),
        ("speed", number(speed)),
        ("relative_tolerance", number(1e-11)),
        (
            "initial",
            states(&[
                ("drum.x", z1.re),
                ("drum.y", z1.im),
                ("base.x", z2.re),
                ("base.y", z2.im),
                ("drum.x'", -speed * z1.im),
                ("drum.y'", speed * z1.re),
                ("base.x'", -speed * z2.im),
                ("base.y'", speed * z2.re),
            ]),
        ),
    ];
    let o = run::<Transient>(&system, &list);
    for (name, z) in [("drum", z1), ("base", z2)] {
        let (x, y) = (column(&o, "motion", &format!("{name}.x")), column(&o, "motion", &format!("{name}.y")));
        for (x, y) in x.iter().zip(y) {
            assert!((x.hypot(*y) - z.abs()).abs() < 1e-8 * z.abs());
        }
    }
    let g = o.findings.iter().find(|f| f.id == "growth_rate").unwrap();
    assert!(g.value.unwrap().abs() < 1e-6 && g.level == Level::Info);
    let turning = g.evidence.iter().find(|e| e.what.to_string().starts_with("mean turning")).unwrap().value;
    assert!((turning - speed).abs() < 1e-6 * speed);
}

/// A one-sided stop, linear behind its gap.
struct Stop(Link);
const GAP: f64 = 1e-3;
const STOP: f64 = 5e5;
impl Part for Stop {
    const KIND: &'static str = "test_stop";
    const DOC: &'static str = "A stop on one side.";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::point(self.0.clone())
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn uses(&self) -> Uses {
        Uses { velocity: false, acceleration: false, spin: false }
    }
    fn residual<S: Scalar>(&self, _: &(), at: &At<S>, out: &mut Rows<S>) {
        out.force[0] += (at.q[0] - S::cst(GAP)).pos().scale(STOP);
    }
    fn energy<S: Scalar>(&self, _: &(), at: &At<S>) -> Option<Energy<S>> {
        Some(Energy { stored: (at.q[0] - S::cst(GAP)).pos().square().scale(0.5 * STOP), ..Energy::zero() })
    }
    fn contacts(&self) -> Option<&dyn erased::Contacts> {
        Some(self)
    }
}

impl Contacts for Stop {
    fn switches(&self, _: &(), at: &At<f64>, out: &mut Vec<f64>) {
        out.push(at.q[0] - GAP);
    }
}

#[test]
fn contacts_are_met_exactly() {
    let (mass, k, v0) = (2.0, 2e4, 0.3);
    let ground = Link::Between(Attach::on("body"), Attach::ground());
    let system = Builder::new("stop")
        .part("body", Foundation, FoundationParams { mass, stiffness: [k; 2], damping: [0.0; 2] })
        .part("stop", Stop(ground), ())
        .build()
        .unwrap();
    // closed form: half a swing outside, an arc within the stop, and again
    let w = (k / mass).sqrt();
    let u = ((k + STOP) / mass).sqrt();
    let t1 = (GAP * w / v0).asin() / w;
    let v1 = v0 * (w * t1).cos();
    // inside: x = s + (g - s) cos u t + v1/u sin u t about the rest point s
    let s = STOP * GAP / (k + STOP);
    let phase = (v1 / u).atan2(GAP - s);
    let inside = 2.0 * phase / u;
    let outside = std::f64::consts::PI / w + 2.0 * t1;
    let period = inside + outside;
    let list = [
        ("duration", number(10.0 * period)),
        ("speed", number(0.0)),
        ("initial", states(&[("body.x'", v0)])),
        ("relative_tolerance", number(1e-11)),
        ("absolute_tolerance", number(1e-11)),
    ];
    let o = run::<Transient>(&system, &list);
    assert_eq!(finding(&o, "contacts"), 20.0);
    let x = column(&o, "motion", "body.x").last().unwrap();
    assert!(x.abs() < 1e-9, "{x:e}");
    let deepest = s + (GAP - s).hypot(v1 / u);
    let other = v0 / w;
    let found = finding(&o, "largest_displacement");
    assert!((found - deepest.max(other)).abs() < 1e-6 * found, "{found} {deepest} {other}");
    let balance = finding(&o, "energy_balance");
    assert!(balance < 1e-9, "{balance:e}");
}

#[test]
fn kick_is_an_impulse_the_balance_knows() {
    let system = linear(1e-3, Some(0.8), 42.0, 6.59);
    let list = [
        ("duration", number(0.05)),
        ("speed", number(700.0)),
        ("kick", states(&[("drum.y'", 0.4)])),
        ("kick_time", number(0.02)),
        ("relative_tolerance", number(1e-12)),
        ("absolute_tolerance", number(1e-12)),
        ("points", Value::Integer(101)),
    ];
    let o = run::<Transient>(&system, &list);
    assert!(finding(&o, "energy_balance") < 1e-9);
    // without loss the kick of the liquid follows from g z'': the flow state jumps by -g dv
    let mut m = Motion::new(&system, SpinLaw::Programme(Programme::constant(700.0, 0.0))).unwrap();
    let mut y = vec![0.0; m.dim()];
    m.kick(0.0, &mut y, &[0.0, 0.4, 0.0, 0.0]).unwrap();
    let g = (1.0 - 0.64) / (1.0 + 0.64);
    assert!((y[9] + g * 0.4).abs() < 1e-15 && y[5] == 0.4 && y[8] == 0.0, "{y:?}");
}

#[test]
fn free_spin_keeps_energy_and_reports_its_speed() {
    let disc = DiscParams { eccentricity: 2e-3, polar_inertia: 0.01, ..DiscParams::new(2.0) };
    let spring = BearingCubicParams { stiffness: [4e4; 2], cubic_stiffness: [1e9; 2], valid_to: 0.0 };
    let system = Builder::new("free")
        .speed(130.0)
        .free_spin()
        .part("drum", Disc::planar(), disc)
        .part("spring", BearingCubic::isotropic(Link::Between(Attach::on("drum"), Attach::ground())), spring)
        .build()
        .unwrap();
    let list = [("duration", number(1.0)), ("relative_tolerance", number(1e-12)), ("absolute_tolerance", number(1e-13))];
    let o = run::<Transient>(&system, &list);
    let missing = column(&o, "energy", "missing").iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let stored = column(&o, "energy", "stored")[0];
    assert!(missing < 1e-11 * stored, "{missing:e} {stored}");
    assert!((finding(&o, "end_speed") - 130.0).abs() > 1e-3);
    let change = column(&o, "energy", "change");
    assert!(change[0] == 0.0 && change.iter().zip(column(&o, "energy", "stored")).all(|(c, s)| *c == s - stored));
    // a balance that closes is not drawn; of one that does not, not the energy of the spin
    assert!(o.figures.iter().all(|f| f.name != "energy"));
    let rough =
        run::<Transient>(&system, &[("duration", number(1.0)), ("relative_tolerance", number(1e-3)), ("absolute_tolerance", number(1e-4))]);
    let reported = &rough.figures.iter().find(|f| f.name == "energy").unwrap().panels[0].marks;
    assert!(reported.iter().any(|m| matches!(m, laval::outcome::Mark::Line(l) if l.y == "change")), "{reported:?}");
    assert!(reported.iter().all(|m| !matches!(m, laval::outcome::Mark::Line(l) if l.y == "stored")), "{reported:?}");
    // a programme is refused when requested, so that it hides no other refusal
    let given = [("to", number(200.0)), ("duration", number(1.0))];
    let up = RunUp::build(&values(&given), &system, &mut Diagnostics::default()).unwrap();
    assert!(ErasedStudy::admit(&up, &system).unwrap_err().message.contains("free") && up.run(&system, &Context::quiet("t")).is_err());
}

#[test]
fn auto_chooses_the_implicit_method_where_stability_limits() {
    let build = |damping: f64| {
        let ground = Link::Between(Attach::on("body"), Attach::ground());
        Builder::new("oil")
            .part("body", Foundation, FoundationParams { mass: 1.0, stiffness: [1e4; 2], damping: [0.0; 2] })
            .part("oil", Damper::fixed(ground), DamperParams { damping: [damping; 2], tilt_damping: 0.0 })
            .build()
            .unwrap()
    };
    let list = |method: &'static str| {
        vec![("duration", number(1.0)), ("speed", number(0.0)), ("initial", states(&[("body.x", 1e-3)])), ("method", Value::Choice(method))]
    };
    let o = run::<Transient>(&build(1e6), &list("auto"));
    assert!(o.work.contains_key("stiff") && o.work["steps"] < 1000, "{:?}", o.work);
    // x decays at k / damping
    let x = column(&o, "motion", "body.x").last().unwrap();
    assert!((x - 1e-3 * (-0.01f64).exp()).abs() < 1e-8, "{x}");
    let o = run::<Transient>(&build(1.0), &list("auto"));
    assert!(o.work.contains_key("explicit"));
}

#[test]
fn wrong_inputs_are_reported() {
    let system = linear(1e-3, Some(0.8), 42.0, 6.59);
    let with =
        |name: &'static str, v: Value| refused::<Transient>(&system, &[("duration", number(1.0)), ("speed", number(100.0)), (name, v)]);
    let text = with("initial", states(&[("drumm.x", 1e-3)]));
    assert!(text.contains("\"drumm.x\"") && text.contains("did you mean \"drum.x\""), "{text}");
    let text = with("initial", states(&[("drum.z'", 1e-3)]));
    assert!(text.contains("\"drum\" has \"drum.x\", \"drum.y\""), "{text}");
    assert!(with("initial", states(&[("drum.x", f64::NAN)])).contains("must lie between"));
    assert!(with("initial", states(&[("drum.x", 1.0), ("drum.x", 2.0)])).contains("twice"));
    assert!(with("kick", states(&[("drum.x", 1.0)])).contains("rates only"));
    assert!(with("output_step", number(1e-9)).contains("too many"));
    let mut both = Values::default();
    for (name, x) in [("duration", 1.0), ("speed", 100.0), ("output_step", 0.1)] {
        both.set(name, number(x), None);
    }
    both.set("points", Value::Integer(100), Some(0..3));
    let mut reported = Diagnostics::default();
    assert!(
        Transient::build(&both, &system, &mut reported).is_none() && format!("{reported:?}").contains("both output_step and points"),
        "{reported:?}"
    );
    let late = [("duration", number(1.0)), ("speed", number(1.0)), ("kick", states(&[("drum.x'", 1.0)])), ("kick_time", number(2.0))];
    assert!(refused::<Transient>(&system, &late).contains("after the end"));
    assert!(refused::<Transient>(&system, &[("duration", number(1.0))]).contains("speed"));
    let ramp = |list: &[(&str, Value)]| refused::<RunUp>(&system, list);
    assert!(ramp(&[("to", number(10.0))]).contains("duration"));
    let to_rest = [("from", number(10.0)), ("to", number(0.0)), ("duration", number(1.0)), ("shape", Value::Choice("exponential"))];
    assert!(ramp(&to_rest).contains("standstill"));
    let table = |t: &[f64]| Value::Columns([("time", t.to_vec()), ("speed", vec![0.0, 10.0])].into());
    assert!(ramp(&[("programme", table(&[0.0, 0.0]))]).contains("increase"));
    assert!(ramp(&[("programme", table(&[1.0, 2.0]))]).contains("begin at 0"));
}

/// A run-up that ends where it begins is refused where the file says so, whichever way its speeds are given; one that returns is not.
#[test]
fn a_run_up_at_one_speed_is_refused() {
    let machine = "[machine]\nspeed = 80\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 10\n[[part]]\nkind = \"shaft_lumped\"\n\
                   between = [\"d\", \"ground\"]\nstiffness = 1e6\n[[study]]\nkind = \"run_up\"\n";
    for (study, marked) in [
        ("duration = 1\nfrom = \"100 rad/s\"\nto = \"100 rad/s\"\n", "to = \"100 rad/s\""),
        ("duration = 1\nfrom = 0.30000000000000004\nto = 0.3\n", "to = 0.3"),
        ("duration = 1\nto = 0\n", "to = 0"),
        ("duration = 1\nfrom = 80\n", "from = 80"),
        ("duration = 1\nfrom = -5\nto = -5\nshape = \"smooth\"\n", "to = -5"),
        ("duration = 1\npolynomial = [90]\n", "polynomial = [90]"),
        ("duration = 1\npolynomial = [90, 0]\n", "polynomial = [90, 0]"),
        ("programme = { time = [0, 1, 2], speed = [60, 60, 60] }\n", "programme = {"),
    ] {
        let text = format!("{machine}{study}");
        let found = laval::file::load(&text).err().unwrap_or_else(|| panic!("{study}")).0;
        let [d] = found.as_slice() else { panic!("{found:?}") };
        assert!(d.code == "run_up.speed" && d.message.contains("two different speeds"), "{d:?}");
        assert!(d.help.as_deref().is_some_and(|h| h.contains("transient")), "{d:?}");
        // the place of the value, in the line of its field
        let line = text[..d.span.clone().unwrap().start].rfind('\n').unwrap() + 1;
        assert!(text[line..].starts_with(marked), "{study}: {}", &text[line..]);
    }
    let returns = "programme = { time = [0, 1, 2], speed = [60, 90, 60] }\n";
    assert!(laval::file::load(&format!("{machine}{returns}")).is_ok());
}

#[test]
fn limits_and_cancellation_leave_partial_results() {
    let system = linear(1e-3, None, 42.0, 6.59);
    let list = [("duration", number(10.0)), ("speed", number(2000.0))];
    let study = Transient::build(&values(&list), &system, &mut Diagnostics::default()).unwrap();
    let o = study.run(&system, &Context { work_limit: 500, ..Context::quiet("t") }).unwrap();
    assert_eq!(o.end, End::WorkLimit);
    let rows = o.find_table("motion").unwrap().rows();
    assert!(rows > 1 && rows < 2000, "{rows}");
    assert!(finding(&o, "work_limit") > 0.0 && o.work["steps"] + o.work["rejected_steps"] <= 500);
    let stop = Cancel::default();
    struct Stops<'a>(&'a AtomicBool);
    impl laval::study::Progress for Stops<'_> {
        fn report(&self, _: u64, _: u64) {
            self.0.store(true, Ordering::Relaxed);
        }
    }
    let context = Context { name: "t", cancel: &stop, progress: &Stops(&stop), work_limit: u64::MAX, keep: None };
    let o = study.run(&system, &context).unwrap();
    assert_eq!(o.end, End::Cancelled);
    assert!(o.find_table("motion").unwrap().rows() > 1);
    // what was stopped has no end
    let reported: Vec<String> = o.findings.iter().map(|f| f.sentence()).collect();
    assert!(
        reported.iter().any(|s| s.contains("where the integration stopped"))
            && !reported.iter().any(|s| s.to_lowercase().contains("the end")),
        "{reported:?}"
    );
    let _ = Silent;
}

#[test]
fn slow_run_up_follows_the_linear_response_and_fast_passage_stays_below_it() {
    let system = linear(1e-4, None, 42.0, 6.59);
    let o = run::<RunUp>(&system, &[("from", number(50.0)), ("to", number(300.0)), ("duration", number(20.0))]);
    assert_eq!(o.end, End::Reached);
    let (speed, envelope, quasi) =
        (column(&o, "envelope", "speed"), column(&o, "envelope", "drum amplitude"), column(&o, "envelope", "drum linear"));
    for (w, q) in speed.iter().zip(quasi) {
        let want = steady(*w, 1e-4).0.abs();
        assert!((q - want).abs() < 1e-10 * want, "{w}: {q:e} {want:e}");
    }
    // the foundation mode: passed later and lower than the steady peak
    let peak = o
        .special_points
        .iter()
        .filter(|p| p.kind == "peak")
        .map(|p| (p.evidence[0].value, p.at))
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap();
    let steady_peak = (1090..1100).map(|i| steady(0.1 * f64::from(i), 1e-4).0.abs()).fold(0.0, f64::max);
    assert!(peak.1 > 109.07 && peak.1 < 130.0, "{peak:?}");
    assert!(peak.0 < steady_peak && peak.0 > 0.1 * steady_peak, "{peak:?} {steady_peak}");
    // long after, the free vibration left by the passage has mostly gone
    let last = envelope.len() - 1;
    assert!((envelope[last] / quasi[last] - 1.0).abs() < 0.25, "{} {}", envelope[last], quasi[last]);
    assert!(finding(&o, "energy_balance") < 1e-6);
}

/// A balanced rotor needs its inertia times the acceleration, and the phase is the exact integral of the speed.
#[test]
fn torque_is_inertia_times_acceleration() {
    let system = linear(0.0, None, 42.0, 6.59);
    for (list, angle) in [
        (vec![("from", number(10.0)), ("to", number(400.0)), ("duration", number(3.0)), ("shape", Value::Choice("smooth"))], 615.0),
        (
            vec![("from", number(400.0)), ("to", number(40.0)), ("duration", number(3.0)), ("shape", Value::Choice("exponential"))],
            3.0 * 360.0 / 10f64.ln(),
        ),
    ] {
        let list = [list, vec![("relative_tolerance", number(1e-11)), ("absolute_tolerance", number(1e-12))]].concat();
        let o = run::<RunUp>(&system, &list);
        for (m, a) in column(&o, "drive", "torque").iter().zip(column(&o, "drive", "acceleration")) {
            assert!((m - 0.01 * a).abs() < 1e-12, "{m} {a}");
        }
        let phase = column(&o, "motion", "phase").last().unwrap();
        assert!((phase - angle).abs() < 1e-10 * angle, "{phase} {angle}");
        let work = column(&o, "energy", "drive");
        let speed = column(&o, "motion", "speed");
        let gained = 0.005 * (speed[speed.len() - 1].powi(2) - speed[0].powi(2));
        assert!((work[work.len() - 1] - gained).abs() < 1e-9 * gained.abs(), "{} {gained}", work[work.len() - 1]);
    }
}
