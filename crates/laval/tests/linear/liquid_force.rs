//! The force of a liquid on the wall of its cavity. In synchronous whirl of radius a the liquid rests in axes that turn with the rotor, its surface about the spin
//! axis: it presses outwards like the full cavity, `F = pi R^2 h rho W^2 a`, however little of it is filled.

use laval::file::load;
use laval::outcome::{Outcome, Table};
use laval::study::Context;
use std::f64::consts::PI;

const RADIUS: f64 = 0.1;
const LENGTH: f64 = 0.2;
const DENSITY: f64 = 900.0;

fn full() -> f64 {
    PI * RADIUS * RADIUS * LENGTH * DENSITY
}

fn machine(bearing: &str, liquid: &str) -> String {
    format!(
        "[machine]\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 20\neccentricity = \"20 um\"\n\
         [[part]]\nname = \"bearing\"\nbetween = [\"d\", \"ground\"]\n{bearing}\n\
         [[part]]\nkind = \"damper\"\nname = \"losses\"\nbetween = [\"d\", \"ground\"]\ndamping = 4000\n\
         [[part]]\nkind = \"liquid\"\nname = \"contents\"\nin = \"d\"\ncavity_radius = {RADIUS}\ncavity_height = {LENGTH}\ndensity = {DENSITY}\n\
         fill = {{ free_surface_radius = 0.06 }}\n{liquid}\n"
    )
}

const LINEAR: &str = "kind = \"bearing_linear\"\nstiffness = \"2e6 N/m\"";
const CUBIC: &str = "kind = \"bearing_cubic\"\nstiffness = \"2e6 N/m\"\ncubic_stiffness = \"1e13 N/m^3\"\nlaw = \"isotropic\"";

fn run(machine: &str, study: &str) -> Outcome {
    let loaded = load(&format!("{machine}[[study]]\n{study}\n")).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("liquid")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn column(t: &Table, name: &str) -> Vec<f64> {
    let names = || t.columns().iter().map(|c| c.name.clone()).collect::<Vec<_>>();
    let c = t.column(name).unwrap_or_else(|| panic!("no column {name}: {:?}", names()));
    (0..t.rows()).map(|i| c.number(i).unwrap_or(f64::NAN)).collect()
}

fn near(found: f64, known: f64, relative: f64) {
    assert!((found - known).abs() <= relative * known.abs(), "{found} {known}");
}

/// In the plane and without friction the equations have this motion exactly; with viscosity the liquid turns as one all the more.
#[test]
fn of_a_linear_response() {
    for liquid in ["wave_damping = 2", "viscosity = 1e-4", "model = \"frozen\""] {
        let o = run(&machine(LINEAR, liquid), "kind = \"forced_response\"\nspeed = { from = 50, to = 600, points = 12 }");
        let t = o.find_table("response").expect("a response");
        let (speeds, moved, forces) = (column(t, "speed"), column(t, "amplitude.d"), column(t, "force.contents"));
        // frozen liquid is a ring about the axis of the cavity
        let mass = if liquid.contains("frozen") { full() * (1.0 - 0.36) } else { full() };
        for ((w, a), f) in speeds.iter().zip(moved).zip(forces) {
            near(f, mass * w * w * a, 1e-9);
        }
    }
}

#[test]
fn of_steady_and_settled_motions() {
    let o = run(&machine(CUBIC, "wave_damping = 2"), "kind = \"nonlinear_response\"\nspeed = { from = 100, to = 250 }");
    let t = o.find_table("response").expect("a response");
    let (speeds, moved) = (column(t, "speed"), column(t, "d largest displacement"));
    for forces in [column(t, "contents force"), column(t, "contents first-order force")] {
        for ((w, a), f) in speeds.iter().zip(&moved).zip(forces) {
            near(f, full() * w * w * a, 1e-7);
        }
    }
    let largest = o.findings.iter().find(|f| f.id == "largest_force" && f.subject == "contents").and_then(|f| f.value).expect("a force");
    let known = speeds.iter().zip(&moved).map(|(w, a)| full() * w * w * a).fold(0.0, f64::max);
    assert!(largest >= known * (1.0 - 1e-9) && largest <= known * 1.05, "{largest} {known}");
    // a limit on it counts where it is reached
    let limit = |force: f64| {
        let text = machine(LINEAR, "wave_damping = 2") + &format!("[limits]\nforce = {{ contents = {force} }}\n");
        let o = run(&text, "kind = \"operating_window\"\nspeed = { from = 50, to = 250 }");
        o.special_points.iter().filter(|p| p.kind == "window_high").map(|p| p.at).fold(f64::NAN, f64::max)
    };
    let o = run(&machine(LINEAR, "wave_damping = 2"), "kind = \"forced_response\"\nspeed = 200");
    let force = column(o.find_table("response").expect("a response"), "force.contents")[0];
    near(limit(force), 200.0, 1e-4);
}
