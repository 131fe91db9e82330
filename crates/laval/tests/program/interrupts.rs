//! Every study ends when it is stopped, wherever it is, and under every limit on its work.
//!
//! Work is counted in the kernels, so that a stop comes at a place of the computation and not at a time of the clock.

use laval::file::{Loaded, load};
use laval::outcome::{End, Outcome};
use laval::study::{self, Cancel, Context, STEP};
use laval_num::work::GRACE;
use std::collections::BTreeSet;

/// A rotor on a stiffening bearing with damping in itself: it jumps, and whirls by itself at high speed.
const ROTOR: &str = r#"
[machine]
speed = "300 rad/s"
[[part]]
kind = "disc"
name = "drum"
mass = "2 kg"
eccentricity = "50 um"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "ground"]
law = "isotropic"
stiffness = "2e5 N/m"
cubic_stiffness = "1e11 N/m^3"
[[part]]
kind = "damper"
name = "losses"
between = ["drum", "ground"]
damping = "30 N s/m"
[[part]]
kind = "damper"
name = "joint"
between = ["drum", "ground"]
axes = "rotating"
damping = "25 N s/m"
"#;

const ON_ROTOR: &[&str] = &[
    r#"kind = "modes""#,
    r#"kind = "static""#,
    r#"kind = "bearing_coefficients"
speed = { from = "10 rad/s", to = "900 rad/s", points = 20 }"#,
    r#"kind = "support_stiffness_map"
rest_frequencies = true"#,
    r#"kind = "campbell"
speed = { from = "10 rad/s", to = "900 rad/s", points = 20 }"#,
    r#"kind = "critical_speeds"
speed = { from = "10 rad/s", to = "900 rad/s", points = 20 }"#,
    r#"kind = "stability_map"
speed = { from = "10 rad/s", to = "900 rad/s", points = 20 }
parameter = { parameter = "drum.mass", from = "1 kg", to = "3 kg", points = 5 }"#,
    r#"kind = "harmonic_force"
place = "drum"
speed = { from = "10 rad/s", to = "900 rad/s", points = 40 }"#,
    r#"kind = "stability_threshold"
place = "drum"
speed = "300 rad/s"
up_to = "1e5 N/m""#,
    r#"kind = "forced_response"
speed = { from = "10 rad/s", to = "900 rad/s", points = 40 }"#,
    r#"kind = "nonlinear_response"
speed = { from = "100 rad/s", to = "600 rad/s" }
symmetry = "none"
harmonics = 3"#,
    r#"kind = "bifurcation_loci"
speed = { from = "100 rad/s", to = "600 rad/s" }
parameter = { parameter = "drum.eccentricity", from = "20 um", to = "80 um", points = 2 }
harmonics = 3"#,
    r#"kind = "response_map"
x = { parameter = "drum.mass", from = "1 kg", to = "3 kg", points = 3 }
y = { parameter = "drum.eccentricity", from = "20 um", to = "80 um", points = 3 }
speed = { from = "100 rad/s", to = "600 rad/s" }"#,
    r#"kind = "sensitivity"
speed = { from = "100 rad/s", to = "600 rad/s" }"#,
    r#"kind = "backbone"
max_points = 50"#,
    r#"kind = "limit_cycles"
speed = { from = "100 rad/s", to = "900 rad/s", points = 12 }
max_points = 40"#,
    r#"kind = "methods"
speed = { from = "200 rad/s", to = "500 rad/s", points = 4 }
harmonics = 3"#,
    r#"kind = "transient"
duration = "2 s""#,
    r#"kind = "run_up"
to = "600 rad/s"
duration = "2 s""#,
    r#"kind = "sweep"
speed = { from = "200 rad/s", to = "500 rad/s", points = 4 }"#,
    r#"kind = "motion_map"
speed = { from = "200 rad/s", to = "500 rad/s", points = 3 }
y = { parameter = "drum.mass", from = "1 kg", to = "3 kg", points = 3 }"#,
    r#"kind = "basins"
from = { "drum.x" = "-1 mm", "drum.y" = "-1 mm" }
to = { "drum.x" = "1 mm", "drum.y" = "1 mm" }
points = 4"#,
    r#"kind = "uncertainty"
study = { kind = "critical_speeds", speed = { from = "10 rad/s", to = "900 rad/s", points = 12 } }
parameters = [{ parameter = "drum.mass", distribution = "uniform", tolerance = "10 %" }]
samples = 16"#,
    r#"kind = "optimum"
study = { kind = "nonlinear_response", speed = { from = "100 rad/s", to = "200 rad/s" }, stability = false }
vary = [{ parameter = "losses.damping", from = "20 N s/m", to = "60 N s/m" }]
minimise = "largest_displacement"
starts = 1
runs = 20"#,
];

const BALANCER: &str = r#"
[machine]
speed = "900 rad/s"
[[part]]
kind = "disc"
name = "disc"
mass = "8.91 kg"
eccentricity = "50 um"
[[part]]
kind = "shaft_lumped"
between = ["disc", "ground"]
stiffness = "2.92e6 N/m"
[[part]]
kind = "damper"
name = "losses"
between = ["disc", "ground"]
damping = "400 N s/m"
[[part]]
kind = "balancer_ball"
name = "balancer"
on = "disc"
balls = 2
ball_mass = "3.6 g"
track_radius = "100 mm"
drag = "2e-3 N m s"
body_tilt = false
"#;

const ON_BALANCER: &[&str] = &[r#"kind = "stationary"
speed = { from = "300 rad/s", to = "1200 rad/s", points = 5 }
starts = 20
seeds = 2
chart = { parameter = "balancer.ball_mass", from = "1 g", to = "10 g", points = 3 }"#];

const SEPARATOR: &str = r#"
[machine]
speed = "1350 rpm"
[[part]]
kind = "disc"
name = "rotor"
mass = "28 kg"
eccentricity = "15 um"
[[part]]
kind = "bearing_linear"
name = "spindle"
between = ["rotor", "ground"]
kxx = "1.6e6 N/m"
kyy = "1.6e6 N/m"
cxx = "300 N s/m"
cyy = "300 N s/m"
[[cup]]
kind = "swinging"
name = "cups"
on = "rotor"
count = 4
mass = "2.6 kg"
centre_of_mass = "170 mm"
hinge_radius = "200 mm"
cup_radius = "45 mm"
bottom = "300 mm"
surface = "20 mm"
[suspension]
liquid_density = "870 kg/m^3"
viscosity = "15 mPa s"
particle_density = "2650 kg/m^3"
diameter = "10 um"
[limits]
displacement = "0.3 mm"
growth_margin = "1 1/s"
"#;

const ON_SEPARATOR: &[&str] = &[
    r#"kind = "operating_window"
speed = { from = "100 rpm", to = "2600 rpm", points = 10 }
time = "8 min"
recovery = "95 %"
particles = 64"#,
    r#"kind = "separation"
time = "8 min"
particles = 64"#,
];

fn loaded() -> impl Iterator<Item = Loaded> {
    let of = |machine: &str, study: &str| load(&format!("{machine}[[study]]\n{study}\n")).unwrap_or_else(|d| panic!("{study}: {d:?}"));
    let machines = [(ROTOR, ON_ROTOR), (BALANCER, ON_BALANCER), (SEPARATOR, ON_SEPARATOR)];
    machines.into_iter().flat_map(move |(machine, studies)| studies.iter().map(move |study| of(machine, study)))
}

fn run(l: &Loaded, cancel: &Cancel, work_limit: u64) -> Outcome {
    let context = Context { cancel, work_limit, ..Context::quiet("study") };
    l.studies[0].study.run(&l.system, &context).unwrap_or_else(|d| panic!("{}: {d:?}", l.studies[0].study.kind()))
}

#[test]
fn every_study_ends_wherever_it_is_stopped() {
    let mut left: BTreeSet<&str> = study::registry().iter().map(|k| k.info.kind).collect();
    // multiplicative generator of Lehmer
    let mut seed: u64 = 20_240_501;
    let mut draw = |below: u64| {
        seed = seed * 48_271 % 2_147_483_647;
        (below as f64 * seed as f64 / 2_147_483_647.0) as u64
    };
    // these machines are small: little time, so that loops that ask nothing are met
    let grace = 10_000_000;
    let threads = rayon::current_num_threads() as u64;
    for l in loaded() {
        let kind = l.studies[0].study.kind();
        left.remove(kind);
        let whole = Cancel::default();
        let o = run(&l, &whole, u64::MAX);
        // points that the file allows are no stop
        let ended = |o: &Outcome| o.end.is_complete() || o.end == End::MaxPoints;
        assert!(ended(&o), "{kind}: {:?}", o.end);
        let all = whole.spent();
        for k in 0..3 {
            // the first is stopped before it begins
            let at = if k == 0 { 0 } else { draw(all) };
            let stop = Cancel::after(at).within(grace);
            let o = run(&l, &stop, u64::MAX);
            let late = stop.spent().saturating_sub(at);
            // to the end of what it computes, or at the latest of the time it has for that, and what was done is put together
            assert!(late <= 5 * grace + 3_000_000 * threads, "{kind} went on for {late} units after {at} of {all}");
            // what was computed when the stop came may have been the last
            assert!(o.end == End::Cancelled || ended(&o), "{kind} stopped after {at} of {all}: {:?}", o.end);
        }
    }
    assert!(left.is_empty(), "no machine for {left:?}");
}

/// Machines on which one computation inside a study takes tens of seconds.
#[test]
fn what_takes_long_within_ends_in_time() {
    let machines = [
        include_str!("machines/campbell.toml"),
        include_str!("machines/limit_cycles.toml"),
        include_str!("machines/methods.toml"),
        include_str!("machines/sensitivity.toml"),
    ];
    // little time after a stop: each is ended from within
    let grace = GRACE / 20;
    for text in machines {
        let l = load(text).unwrap_or_else(|d| panic!("{d:?}"));
        let kind = l.studies[0].study.kind();
        for at in [grace, 4 * grace] {
            let cancel = Cancel::after(at).within(grace);
            let o = run(&l, &cancel, u64::MAX);
            let late = cancel.spent().saturating_sub(at);
            assert_eq!(o.end, End::Cancelled, "{kind} stopped after {at}");
            assert!(late <= 2 * grace, "{kind} went on for {late} units after {at}");
        }
    }
    // the time beyond a limit on the work is some seconds, the same for every study
    let l = load(machines[2]).unwrap_or_else(|d| panic!("{d:?}"));
    let cancel = Cancel::default();
    let o = run(&l, &cancel, 1);
    assert!(matches!(o.end, End::WorkLimit | End::MaxPoints), "{:?}", o.end);
    assert!(cancel.spent() <= STEP + 5 * GRACE, "{} units under a limit of one step", cancel.spent());
}

#[test]
fn every_study_ends_at_the_limit_on_its_work() {
    for l in loaded() {
        let kind = l.studies[0].study.kind();
        for limit in [1, 5] {
            let stop = Cancel::default();
            let o = run(&l, &stop, limit);
            assert!(stop.spent() <= limit * STEP + 5 * GRACE, "{kind}: {} units under a limit of {limit}", stop.spent());
            let ended = matches!(o.end, End::WorkLimit | End::MaxPoints) || o.end.is_complete();
            assert!(ended, "{kind} under a limit of {limit}: {:?}", o.end);
        }
    }
}

/// A shaft of so many discs, one above the other.
fn shaft(discs: usize) -> String {
    let mut text = String::from("[machine]\nspeed = \"300 rad/s\"\n");
    for k in 0..discs {
        let below = if k == 0 { "ground".to_string() } else { format!("d{}", k - 1) };
        text += &format!(
            "[[part]]\nkind = \"disc\"\nname = \"d{k}\"\nmass = \"1 kg\"\neccentricity = \"1 um\"\n\
             [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"d{k}\", \"{below}\"]\nstiffness = \"1e6 N/m\"\nmaterial_damping = \"1e-5 s\"\n"
        );
    }
    text
}

#[test]
fn what_no_memory_holds_is_refused_before_it_begins() {
    let many: &[(&str, usize)] = &[
        ("kind = \"transient\"\nduration = \"0.01 s\"\nvelocities = true\npoints = POINTS", 1_000_000),
        ("kind = \"transient\"\nduration = \"0.01 s\"\noutput_step = \"STEP s\"", 1_000_000),
        ("kind = \"run_up\"\nduration = \"0.01 s\"\npoints = POINTS", 1_000_000),
        ("kind = \"campbell\"\nspeed = { from = 1, to = 9, points = POINTS }", 100_000),
        ("kind = \"critical_speeds\"\nspeed = { from = 1, to = 9, points = POINTS }", 100_000),
        ("kind = \"stability_map\"\nspeed = { from = 1, to = 9, points = POINTS }", 100_000),
        ("kind = \"forced_response\"\nspeed = { from = 1, to = 9, points = POINTS }", 100_000),
        ("kind = \"nonlinear_response\"\nspeed = { from = 10, to = 90 }\nmax_points = POINTS", 1_000_000),
        ("kind = \"sweep\"\nspeed = { from = 1, to = 9, points = POINTS }", 100_000),
        (
            "kind = \"basins\"\nfrom = { \"d0.x\" = -1e-3, \"d0.y\" = -1e-3 }\nto = { \"d0.x\" = 1e-3, \"d0.y\" = 1e-3 }\npoints = POINTS",
            500,
        ),
    ];
    let machine = shaft(120);
    for (study, points) in many {
        for (points, fits) in [(*points, false), (100, true)] {
            let requested = study.replace("POINTS", &points.to_string()).replace("STEP", &format!("{:e}", 0.01 / points as f64));
            let l = load(&format!("{machine}[[study]]\n{requested}\n")).unwrap_or_else(|d| panic!("{study}: {d:?}"));
            let refused = l.refusals();
            let codes: Vec<&str> = refused.iter().map(|r| r.diagnostic.code).collect();
            if fits {
                assert!(!codes.contains(&"request.memory"), "{requested}: {codes:?}");
                continue;
            }
            assert_eq!(codes, ["request.memory"], "{requested}");
            let d = &refused[0].diagnostic;
            assert!(
                (d.message.contains(&points.to_string()) || study.contains("sweep")) && d.message.contains("GB") && d.help.is_some(),
                "{requested}: {d:?}"
            );
            // nobody who leaves the check out runs into it either
            let d = l.studies[0].study.run(&l.system, &Context::quiet("study")).unwrap_err();
            assert_eq!(d.code, "request.memory", "{requested}");
        }
    }
}

#[test]
fn a_check_leaves_to_the_run_what_takes_long() {
    let machine = r#"
[machine]
speed = "400 rad/s"
[[part]]
kind = "disc"
name = "drum"
mass = "38 kg"
polar_inertia = "0.3 kg m^2"
diametral_inertia = "0.6 kg m^2"
[[part]]
kind = "bearing_hertz"
between = [{ body = "drum", at = "80 mm" }, "ground"]
law = "per_axis"
coefficient = "2.7e9 N/m^1.5"
clearance = "-20 um"
[[part]]
kind = "bearing_linear"
between = [{ body = "drum", at = "-200 mm" }, "ground"]
kxx = "1.3e7 N/m"
kyy = "1.3e7 N/m"
cxx = "30 N s/m"
cyy = "30 N s/m"
[[part]]
kind = "liquid"
name = "oil"
in = "drum"
model = "spatial"
cavity_radius = "40 mm"
cavity_height = "24 mm"
density = "970 kg/m^3"
fill = { volume_fraction = 0.5 }
"#;
    for study in ["kind = \"backbone\"", "kind = \"limit_cycles\"\nspeed = { from = 1, to = 377, points = 5 }"] {
        let l = load(&format!("{machine}[[study]]\n{study}\n")).unwrap_or_else(|d| panic!("{d:?}"));
        let cancel = Cancel::default();
        let refused = laval_num::work::watched(Some(&cancel), u64::MAX, || l.refusals()).unwrap();
        assert!(cancel.spent() < 60_000_000, "{study}: {} units, {refused:?}", cancel.spent());
    }
}
