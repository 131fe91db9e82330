//! Run-ups so slow that nothing moves by more than the absolute tolerance for long: steps still follow the loads that turn.

use laval::file::load;
use laval::outcome::{Data, Outcome};
use laval::study::Context;

fn machine(unbalance: f64, drive: &str, parts: &str) -> String {
    format!(
        "[machine]\nspeed = 0\ndrive = \"{drive}\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 4\npolar_inertia = 0.02\nunbalance = {unbalance:e}\n\
         [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nstiffness = 4e4\ndamping = 8\n{parts}[[study]]\n"
    )
}

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("slow")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    match &o.find_table(table).unwrap().column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

/// Moves this machine by less than the absolute tolerance for most of the time; at its critical speed, of a quality of 50, by far more. kg m.
const SMALL: f64 = 8e-8;

fn run_up(unbalance: f64, study: &str) -> Vec<f64> {
    let o = run(&format!("{}kind = \"run_up\"\nfrom = 0\n{study}\n", machine(unbalance, "prescribed", "")));
    let envelope = column(&o, "envelope", "d amplitude");
    assert_eq!(envelope.len(), 400, "every window of the envelope has a value");
    envelope
}

fn largest(list: &[f64]) -> f64 {
    list.iter().fold(0.0, |m: f64, x| if *x > m || x.is_nan() { *x } else { m })
}

/// The equations are linear: displacements are in proportion to the unbalance.
#[test]
fn small_unbalances_move_in_proportion() {
    for study in [
        "to = 200\nduration = 300",
        "to = 200\nduration = 300\nshape = \"smooth\"",
        "to = -200\nduration = 300",
        "to = 200\nduration = 60\nmethod = \"stiff\"",
    ] {
        let (usual, small) = (run_up(8e-5, study), run_up(SMALL, study));
        let most = largest(&usual);
        assert!(most > 20.0 * 8e-5 / 4.0, "{study}: it passes its critical speed: {most:e}");
        for (a, b) in usual.iter().zip(small) {
            let b = 1e3 * b;
            assert!((a - b).abs() < 5e-3 * most, "{study}: {a:e} {b:e} of {most:e}");
        }
    }
}

/// Steps longer than the windows of the envelope leave none of them without a value.
#[test]
fn long_steps_fill_all_windows() {
    run_up(1e-2 * SMALL, "to = 200\nduration = 60\nmethod = \"stiff\"");
}

/// A constant torque drives a free spin as a programme of constant acceleration does: so small a vibration takes nothing from it.
#[test]
fn a_free_spin_is_followed_as_one_that_is_prescribed() {
    let motor = "[[part]]\nkind = \"motor\"\ntorque = 0.01\n";
    let free = run(&format!("{}kind = \"transient\"\nduration = 400\n", machine(SMALL, "free", motor)));
    let (free, prescribed) = (largest(&column(&free, "envelope", "d amplitude")), largest(&run_up(SMALL, "to = 200\nduration = 400")));
    assert!(prescribed > 20.0 * SMALL / 4.0 && (free - prescribed).abs() < 1e-3 * prescribed, "{free:e} {prescribed:e}");
}

/// A disc on a spin of a fixed ratio is followed by its own speed.
#[test]
fn a_load_on_a_faster_spin_is_followed_by_its_speed() {
    let ratio = "[[part]]\nkind = \"speed_ratio\"\nname = \"fast\"\nratio = -20\n";
    let text = machine(SMALL, "prescribed", ratio).replacen("name = \"d\"", "name = \"d\"\nspin = \"fast\"", 1);
    let geared = run(&format!("{text}kind = \"run_up\"\nfrom = 0\nto = 10\nduration = 300\n"));
    let (geared, direct) = (largest(&column(&geared, "envelope", "d amplitude")), largest(&run_up(SMALL, "to = 200\nduration = 300")));
    assert!((geared - direct).abs() < 1e-3 * direct, "{geared:e} {direct:e}");
}

#[test]
fn the_fastest_load_of_a_machine() {
    let of = |text: &str| load(text).unwrap_or_else(|d| panic!("{d:?}")).system.fastest_load();
    let disc = |more: &str| format!("[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 4\n{more}");
    assert_eq!(of(&disc("")), 0.0);
    assert_eq!(of(&disc("eccentricity = 1e-30\n")), 1.0);
    let fast = "[[part]]\nkind = \"speed_ratio\"\nname = \"fast\"\nratio = -20\n";
    assert_eq!(of(&disc(&format!("spin = \"fast\"\nunbalance = 1e-5\n{fast}"))), 20.0);
    // without an unbalance nothing turns on the faster spin
    assert_eq!(of(&disc(&format!("spin = \"fast\"\n{fast}"))), 0.0);
    // masses that move in the rotor turn with it
    let balls = "[[part]]\nkind = \"balancer_ball\"\non = \"d\"\nballs = 2\nball_mass = \"20 g\"\ntrack_radius = \"60 mm\"\ndrag = 5e-3\n";
    assert_eq!(of(&disc(balls)), 1.0);
}

/// Where loads turn slowly the response is that of each speed by itself: the largest is the height of the resonance, e/(2 zeta sqrt(1 - zeta^2)).
#[test]
fn the_slowest_passage_reaches_the_height_of_the_resonance() {
    // 1 rad/s at resonance, of a quality of 5
    let text = "[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 1\neccentricity = 1e-8\n\
                [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nstiffness = 1\ndamping = 0.2\n\
                [[study]]\nkind = \"run_up\"\nfrom = 0\nto = 2\nduration = 2e4\n";
    let largest = largest(&column(&run(text), "envelope", "d amplitude"));
    let zeta: f64 = 0.1;
    let height = 1e-8 / (2.0 * zeta * (1.0 - zeta * zeta).sqrt());
    assert!((largest - height).abs() < 2e-3 * height, "{largest:e} {height:e}");
}
