//! Shafts of many stations, made of discs and massless elements.

use super::files::load;
use laval::model::system::System;
use std::f64::consts::PI;

pub const LENGTH: f64 = 1.5;
pub const RADIUS: f64 = 0.025;
pub const MODULUS: f64 = 2.1e11;
pub const DENSITY: f64 = 7800.0;
pub const SUPPORT: f64 = 2e6;

/// A round shaft of equal beam elements without shear, its mass at the stations, on two damped bearings; with an unbalance in the middle and, on request, a foundation
/// below both bearings. `plain` leaves out what a slender beam on springs does not have: rotary inertia and damping.
pub fn shaft(stations: usize, founded: bool, plain: bool) -> System {
    let mut text = elements(stations, plain);
    let foot = if founded { "base" } else { "ground" };
    for k in [0, stations - 1] {
        text += &format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"b{k}\"\nbetween = [\"n{k}\", \"{foot}\"]\nkxx = {SUPPORT}\nkyy = {}\ncxx = {}\ncyy = 400.0\n",
            1.2 * SUPPORT,
            if plain { 0.0 } else { 300.0 }
        );
    }
    if founded {
        text += "[[part]]\nkind = \"disc\"\nname = \"base\"\nmass = 80.0\n[[part]]\nkind = \"bearing_linear\"\nname = \"soil\"\nbetween = [\"base\", \"ground\"]\nkxx = 5e7\nkyy = 6e7\ncxx = 2e4\ncyy = 2e4\n";
    }
    load(&text).system
}

/// Its elements with the masses between them.
pub fn elements(stations: usize, plain: bool) -> String {
    let (area, second) = (PI * RADIUS.powi(2), 0.25 * PI * RADIUS.powi(4));
    let step = LENGTH / (stations - 1) as f64;
    let mut text = String::from("[machine]\nname = \"shaft\"\nspeed = \"3000 rpm\"\naxis = \"vertical\"\n");
    for k in 0..stations {
        let share = if k == 0 || k + 1 == stations { 0.5 } else { 1.0 };
        let mass = share * DENSITY * area * step;
        let unbalance = if k == stations / 2 { "unbalance = \"20 g mm\"\n" } else { "" };
        text += &format!(
            "[[part]]\nkind = \"disc\"\nname = \"n{k}\"\nmass = {mass}\ndiametral_inertia = {}\npolar_inertia = {}\n{unbalance}",
            0.25 * mass * RADIUS.powi(2) * if plain { 1e-6 } else { 1.0 },
            if plain { 0.0 } else { 0.5 * mass * RADIUS.powi(2) }
        );
    }
    let bending = MODULUS * second;
    for k in 1..stations {
        text += &format!(
            "[[part]]\nkind = \"shaft_lumped\"\nname = \"e{k}\"\nbetween = [{{ body = \"n{k}\", at = {} }}, {{ body = \"n{}\", at = {} }}]\n\
             stiffness = {}\ntilt_stiffness = {}\n",
            -0.5 * step,
            k - 1,
            0.5 * step,
            12.0 * bending / step.powi(3),
            bending / step
        );
    }
    text
}

/// A shaft with damped bearings alike in all directions.
pub fn isotropic(stations: usize) -> String {
    let mut text = elements(stations, false);
    for k in [0, stations - 1] {
        text += &format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"b{k}\"\nbetween = [\"n{k}\", \"ground\"]\nkxx = {SUPPORT}\nkyy = {SUPPORT}\ncxx = 300.0\ncyy = 300.0\n"
        );
    }
    text
}

/// On isotropic bearings whose force grows with the cube of the displacement.
pub fn cubic(stations: usize) -> System {
    load(&cubic_text(stations)).system
}

/// The file of it.
pub fn cubic_text(stations: usize) -> String {
    let mut text = elements(stations, false);
    for k in [0, stations - 1] {
        text += &format!(
            "[[part]]\nkind = \"bearing_cubic\"\nname = \"b{k}\"\nbetween = [\"n{k}\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = {SUPPORT}\ncubic_stiffness = 1e14\n\
             [[part]]\nkind = \"damper\"\nname = \"c{k}\"\nbetween = [\"n{k}\", \"ground\"]\ndamping = 250.0\n"
        );
    }
    text
}
