//! A motion in time can start from the stored end of another, and a stored result is reported as the run was.

use laval::file::{construct, load};
use laval::model::system::System;
use laval::prelude::*;
use laval::study::basins::BasinsResult;
use laval::study::motion_map::MotionMapResult;
use laval::study::record::MotionState;
use laval::study::run_up::RunUpResult;
use laval::study::sweep::SweepResult;
use laval::study::transient::TransientResult;
use serde_json::json;

fn machine(text: &str) -> System {
    load(text).unwrap_or_else(|d| panic!("{d:?}")).system
}

const DISC: &str = "[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 4\neccentricity = \"0.2 mm\"\npolar_inertia = 0.05\n";
const AIR: &str = "[[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\ndamping = 60\n";
const SHAFT: &str = "[[part]]\nkind = \"shaft_lumped\"\nbetween = [\"d\", \"ground\"]\nstiffness = \"2e5 N/m\"\n";
const CUBIC: &str = "[[part]]\nkind = \"bearing_cubic\"\nbetween = [\"d\", \"ground\"]\nlaw = \"per_axis\"\nstiffness = \"2e5 N/m\"\n\
                     cubic_stiffness = \"5e11 N/m^3\"\n";
const MEMORY: &str = "[[part]]\nkind = \"shaft_viscoelastic\"\nbetween = [\"d\", \"ground\"]\nmemory = \"rotor\"\nsupports = \"simply_supported\"\n\
                      modulus = \"20 GPa\"\ndiameter = \"40 mm\"\nlength = \"0.6 m\"\nposition = \"0.3 m\"\namplitude = 0.008\nexponent = 0.15\n\
                      decay = \"0.05 1/s\"\n";
const BALLS: &str = "[[part]]\nkind = \"balancer_ball\"\nname = \"b\"\non = \"d\"\nballs = 2\nball_mass = \"3.6 g\"\ntrack_radius = \"100 mm\"\n\
                     drag = \"2e-3 N m s\"\nbody_tilt = false\n";
const MOTOR: &str = "[[part]]\nkind = \"motor\"\ncurve = \"linear\"\ntorque = \"3 N m\"\nsynchronous_speed = \"300 rad/s\"\n";

fn apart(a: &MotionState, b: &MotionState) -> f64 {
    let most = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let size = |x: &[f64]| x.iter().fold(1e-12, |m: f64, x| m.max(x.abs()));
    let all = [(&a.coordinates, &b.coordinates), (&a.rates, &b.rates), (&a.states, &b.states)];
    let own = all.into_iter().map(|(a, b)| most(a, b) / size(a)).fold(0.0, f64::max);
    own.max((a.spin.phase - b.spin.phase).abs()).max((a.spin.speed - b.spin.speed).abs() / b.spin.speed)
}

/// Two halves of a motion are the whole of it, with nonlinear parts, memory, movable masses and a free spin.
#[test]
fn two_halves_are_the_whole() {
    let context = Context::quiet("motion");
    for (drive, parts) in
        [("prescribed", CUBIC), ("prescribed", MEMORY), ("free", &format!("{SHAFT}{MOTOR}")), ("prescribed", &format!("{SHAFT}{BALLS}"))]
    {
        let machine = machine(&format!("[machine]\nspeed = \"150 rad/s\"\ndrive = \"{drive}\"\n{DISC}{parts}{AIR}"));
        let study = |duration: f64| {
            let fields = json!({ "duration": duration, "initial": { "d.x": 2e-4 }, "relative_tolerance": 1e-11, "absolute_tolerance": 1e-12, "points": 20, "phase": 0.3 });
            construct::<Transient>(&machine, &fields).unwrap()
        };
        let whole = study(0.3).result(&machine, &context).unwrap().motion.end_state;
        let first = study(0.13).result(&machine, &context).unwrap().motion.end_state;
        let again = study(0.17).continued_from(&first).result(&machine, &context).unwrap().motion.end_state;
        assert!(apart(&whole, &again) < 1e-6, "{parts}: {:e}\n{whole:?}\n{again:?}", apart(&whole, &again));
        assert_eq!((first.t, again.t), (0.13, 0.17));
        assert!(apart(&whole, &first) > 1e-3, "the halves differ");
    }
}

/// A run-up and its hold are those of a transient that starts where the run-up ends.
#[test]
fn a_transient_goes_on_from_a_run_up() {
    let machine = machine(&format!("[machine]\n{DISC}{SHAFT}{AIR}"));
    let context = Context::quiet("motion");
    let study = |hold: f64| {
        let fields = json!({ "from": 20.0, "to": 300.0, "duration": 0.5, "hold": hold, "relative_tolerance": 1e-11, "absolute_tolerance": 1e-12, "points": 20 });
        construct::<RunUp>(&machine, &fields).unwrap().result(&machine, &context).unwrap().motion.end_state
    };
    let transient = json!({ "speed": 100.0, "duration": 0.2, "relative_tolerance": 1e-11, "absolute_tolerance": 1e-12 });
    let transient = construct::<Transient>(&machine, &transient).unwrap().continued_from(&study(0.0));
    let held = transient.result(&machine, &context).unwrap().motion.end_state;
    assert!(apart(&study(0.2), &held) < 1e-6, "{:e}", apart(&study(0.2), &held));
}

#[test]
fn a_state_of_another_machine_is_refused() {
    let [one, other] = ["", BALLS].map(|more| machine(&format!("[machine]\nspeed = \"150 rad/s\"\n{DISC}{SHAFT}{AIR}{more}")));
    let study = |machine: &System| construct::<Transient>(machine, &json!({ "duration": 0.01 })).unwrap();
    let context = Context::quiet("motion");
    let state = study(&one).result(&one, &context).unwrap().motion.end_state;
    let refused = study(&other).continued_from(&state).result(&other, &context).err().unwrap();
    assert_eq!(refused.code, "transient.start");
}

/// What a result is reported as is what a run says, and the results can be stored.
#[test]
fn results_are_reported_as_runs() {
    fn stored<T: serde::Serialize + serde::de::DeserializeOwned>() {}
    stored::<TransientResult>();
    stored::<RunUpResult>();
    stored::<SweepResult>();
    stored::<BasinsResult>();
    stored::<MotionMapResult>();

    fn same<S: TypedStudy>(machine: &System, fields: serde_json::Value) {
        let study = construct::<S>(machine, &fields).unwrap();
        let result = study.result(machine, &Context::quiet("x")).unwrap();
        let run = study.run(machine, &Context::quiet("x")).unwrap();
        // numbers that are none are not equal
        assert_eq!(format!("{:?}", study.outcome(machine, &result, "x").unwrap()), format!("{run:?}"));
        assert!(!run.tables.is_empty() && !run.figures.is_empty());
    }
    let balls = machine(&format!("[machine]\nspeed = \"500 rad/s\"\n{DISC}{SHAFT}{AIR}{BALLS}"));
    same::<Transient>(&balls, json!({ "duration": 0.1, "waterfall": "d", "spectra": 3, "velocities": true }));
    same::<RunUp>(&balls, json!({ "from": 100.0, "duration": 0.2, "observables": true }));
    same::<Basins>(
        &balls,
        json!({ "from": { "b.ball_1": -1.0, "b.ball_2": -1.0 }, "to": { "b.ball_1": 1.0, "b.ball_2": 1.0 }, "points": 2 }),
    );
    let cubic = machine(&format!("[machine]\nspeed = \"150 rad/s\"\n{DISC}{CUBIC}{AIR}"));
    same::<Sweep>(&cubic, json!({ "speed": { "from": 200.0, "to": 260.0, "points": 3 }, "waterfall": "d" }));
    same::<Basins>(&cubic, json!({ "from": { "d.x": -1e-4, "d.y": -1e-4 }, "to": { "d.x": 1e-4, "d.y": 1e-4 }, "points": 2 }));
    let y = json!({ "parameter": "d.eccentricity", "from": 1e-5, "to": 1e-4, "points": 2 });
    same::<MotionMap>(&cubic, json!({ "speed": { "from": 200.0, "to": 260.0, "points": 2 }, "y": y }));
}
