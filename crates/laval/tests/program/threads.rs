//! Results have the same bits whatever the number of threads.

use super::stopped::ROTOR;
use crate::common::files::load;
use laval::study::{Context, overview};

/// An elastic shaft with two discs on damped bearings that differ in x and y.
const SHAFT: &str = r#"
[machine]
speed = "3000 rpm"
[[part]]
kind = "shaft"
name = "s"
material = "steel"
elements = 6
[[part.section]]
length = 0.9
outer_diameter = 0.04
[[part]]
kind = "disc"
name = "a"
on = { body = "s", at = 0.3 }
mass = 8.0
polar_inertia = 0.09
diametral_inertia = 0.05
unbalance = "80 g mm"
[[part]]
kind = "disc"
name = "b"
on = { body = "s", at = 0.9 }
mass = 5.0
polar_inertia = 0.05
diametral_inertia = 0.03
[[part]]
kind = "bearing_linear"
name = "left"
between = [{ body = "s", at = 0.0 }, "ground"]
kxx = 2e6
kyy = 3e6
cxx = 200.0
cyy = 200.0
[[part]]
kind = "bearing_linear"
name = "right"
between = [{ body = "s", at = 0.7 }, "ground"]
kxx = 2e6
kyy = 3e6
cxx = 200.0
cyy = 200.0
[operation]
run_up_time = "2 s"
"#;

/// A balancer with two balls.
const BALLS: &str = r#"
[machine]
speed = 2.5
[[part]]
kind = "disc"
name = "disc"
mass = 1
eccentricity = 0.01
[[part]]
kind = "shaft_lumped"
name = "shaft"
between = ["disc", "ground"]
stiffness = 1
[[part]]
kind = "damper"
name = "air"
between = ["disc", "ground"]
damping = 0.02
[[part]]
kind = "balancer_ball"
name = "ring"
on = "disc"
balls = 2
body_tilt = false
gravity = 0
ball_mass = 0.05
track_radius = 1
drag = 0.01
"#;

fn with<R: Send>(threads: usize, f: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(f)
}

fn same(machine: &str, studies: &[&str]) {
    for study in studies {
        let l = load(&format!("{machine}\n[[study]]\n{study}\n"));
        let run = |threads| {
            with(threads, || {
                let o = l.studies[0].study.run(&l.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{study}: {d:?}"));
                format!("{o:?}")
            })
        };
        let one = run(1);
        for threads in [2, 3] {
            assert!(one == run(threads), "{study}: {threads} threads give another result than one");
        }
    }
}

#[test]
fn linear_studies_do_not_depend_on_threads() {
    let range = "speed = { from = \"100 rpm\", to = \"12000 rpm\" }";
    let of = |kind: &str| format!("kind = \"{kind}\"\n{range}");
    let all = ["campbell", "critical_speeds", "forced_response", "stability_map"].map(of);
    same(SHAFT, &all.each_ref().map(String::as_str));
}

#[test]
fn sensitivities_and_sweeps_do_not_depend_on_threads() {
    same(
        ROTOR,
        &[
            "kind = \"sensitivity\"\nspeed = { from = 200, to = 600 }",
            "kind = \"sweep\"\nstart = \"up_and_down\"\nspeed = { from = 300, to = 500, points = 24 }\ntolerance = 1e-4",
        ],
    );
}

#[test]
fn stationary_states_do_not_depend_on_threads() {
    same(BALLS, &["kind = \"stationary\"\nspeed = { from = 1.5, to = 4.0, points = 9 }\nstarts = 30"]);
}

#[test]
fn the_first_page_does_not_depend_on_threads() {
    let l = load(SHAFT);
    let run = |threads| with(threads, || format!("{:?}", overview(&l.system, &[], &[], &Context::quiet("page"))));
    let one = run(1);
    assert!(one.contains("check-run-up"), "{one}");
    assert!(one == run(2));
}
