//! A disc on a flexible hub: a disc with coordinates of its own, joined to the shaft by a coupling.

use super::rotors::modes;
use crate::common::files::load;
use laval::model::system::System;

const SHAFT: &str = "[machine]\nname = \"t\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 6\nsection = { length = [0.4, 0.5], outer_diameter = [0.04, 0.04] }\n\
     [[part]]\nkind = \"bearing_linear\"\nname = \"a\"\nbetween = [\"shaft\", \"ground\"]\nstiffness = 5e7\n\
     [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [{ body = \"shaft\", at = 0.9 }, \"ground\"]\nstiffness = 5e7\n";
const MASS: f64 = 9.0;
const DIAMETRAL: f64 = 0.05;
const POLAR: f64 = 0.07;

fn on_hub(lateral: f64, tilt: f64, damping: f64) -> System {
    let disc = format!(
        "[[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = {MASS:?}\ndiametral_inertia = {DIAMETRAL:?}\npolar_inertia = {POLAR:?}\n"
    );
    let hub = format!(
        "[[part]]\nkind = \"coupling\"\nname = \"hub\"\nbetween = [\"wheel\", {{ body = \"shaft\", at = 0.4 }}]\nstiffness = {lateral:?}\ntilt_stiffness = {tilt:?}\ndamping = {damping:?}\n"
    );
    load(&format!("{SHAFT}{disc}{hub}")).system
}

fn on_shaft(mass: f64, diametral: f64, polar: f64) -> System {
    let disc = format!(
        "[[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.4 }}\nmass = {mass:?}\ndiametral_inertia = {diametral:?}\npolar_inertia = {polar:?}\n"
    );
    load(&format!("{SHAFT}{disc}")).system
}

/// At a frequency w of forward whirl the disc behind its hub acts on the shaft like a mass `k m/(k - m w^2)` and a moment of inertia `-Z/w^2`, Z the springs of tilt kt and
/// `-Id w^2 + Ip W w` in series: a disc with these on the shaft has a frequency at w.
#[test]
fn a_hub_is_in_series_with_its_disc() {
    let (lateral, tilt, speed) = (4e7, 6e5, 120.0);
    let found = modes(&on_hub(lateral, tilt, 0.0), speed, 5000.0);
    assert!(found.len() >= 6, "{found:?}");
    let mut tested = 0;
    for m in &found {
        for sign in [1.0, -1.0] {
            let w = sign * m.im;
            let disc = -DIAMETRAL * w * w + POLAR * speed * w;
            let (mass, inertia) = (lateral * MASS / (lateral - MASS * w * w), -tilt * disc / (tilt + disc) / (w * w));
            if !(mass > 0.0 && inertia > 1e-4) {
                continue;
            }
            // forward or backward: the one of both to which this frequency belongs
            let other = modes(&on_shaft(mass, inertia, 0.0), speed, 5000.0);
            tested += usize::from(other.iter().any(|o| (o.im - m.im).abs() <= 1e-9 * m.im));
        }
    }
    assert!(tested >= 4, "{tested} of {found:?}");
}

/// A stiff hub is none; a soft one leaves the shaft alone and the disc on its springs.
#[test]
fn limits_of_a_hub() {
    let speed = 200.0;
    let (stiff, fixed) = (modes(&on_hub(1e13, 1e11, 0.0), speed, 3000.0), modes(&on_shaft(MASS, DIAMETRAL, POLAR), speed, 3000.0));
    assert!(fixed.len() >= 4);
    for m in &fixed {
        assert!(stiff.iter().any(|s| (s.im - m.im).abs() <= 1e-5 * m.im), "{m:?} {stiff:?}");
    }
    let soft = modes(&on_hub(100.0, 2.0, 0.0), speed, 3000.0);
    let expected = (100.0 / MASS).sqrt();
    assert!(soft.iter().any(|s| (s.im - expected).abs() <= 1e-3 * expected), "{soft:?}");
    // of the tilt: w^2 Id - w Ip W - kt = 0
    let forward = (POLAR * speed + (POLAR * POLAR * speed * speed + 8.0 * DIAMETRAL).sqrt()) / (2.0 * DIAMETRAL);
    assert!(soft.iter().any(|s| (s.im - forward).abs() <= 1e-3 * forward), "{soft:?} {forward}");
}

/// Damping of the hub turns with the rotor: forward whirl slower than the spin becomes unstable, backward whirl does not.
#[test]
fn damping_of_a_hub_turns() {
    let system = on_hub(4e7, 6e5, 500.0);
    let lowest = fixed_lowest(&system, 5.0);
    let grows = |speed: f64| modes(&system, speed, 3000.0).iter().any(|m| m.re > 1e-9 * m.im);
    assert!(!grows(0.5 * lowest) && grows(1.5 * lowest));
}

fn fixed_lowest(system: &System, speed: f64) -> f64 {
    modes(system, speed, 3000.0).iter().map(|m| m.im).fold(f64::INFINITY, f64::min)
}
