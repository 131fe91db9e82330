//! Roots of machines with a liquid that has no time form: all of them, against tables computed by other methods.

mod approximation;
mod bands;
mod criteria;
mod one_coordinate;
mod orbits;
mod paths;
mod spectra;
mod viscous;

use laval::file::load;
use laval::model::system::System;
use laval::solve::rest::rest;
use laval::solve::roots::{Request, Roots, roots};

const FILE: &str = include_str!("../reference/spatial/s1.toml");

fn build(text: &str) -> System {
    load(text).unwrap_or_else(|d| panic!("{text}\n{d:?}")).system
}

/// The file with pieces of its text replaced; every piece must be there.
fn changed(text: &str, pieces: &[(&str, &str)]) -> String {
    pieces.iter().fold(text.to_string(), |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replace(old, new)
    })
}

/// S1i: the values of x in y as well.
fn isotropic(text: &str) -> String {
    changed(text, &[("4e6 N/m", "3e6 N/m"), ("1.2e7 N/m", "2e7 N/m")])
}

/// A spatial liquid with harmonics up to this one.
fn truncated(text: &str, last: usize) -> String {
    changed(text, &[("model = \"strip\"", &format!("model = \"spatial\"\naxial_harmonics = {last}"))])
}

fn spatial(text: &str) -> String {
    changed(text, &[("model = \"strip\"", "model = \"spatial\"")])
}

fn filled(text: &str, ratio: f64) -> String {
    changed(text, &[("free_surface_radius = \"105 mm\"", &format!("free_surface_radius = \"{} mm\"", 150.0 * ratio))])
}

fn viscous(text: &str, nu: &str) -> String {
    changed(text, &[("density = \"1000", &format!("viscosity = {nu}\ndensity = \"1000"))])
}

fn without(text: &str, name: &str) -> String {
    let parts = text.split("\n[[").filter(|block| !block.contains(&format!("name = \"{name}\"")));
    parts.collect::<Vec<_>>().join("\n[[")
}

/// Roots at a speed.
fn at(system: &System, speed: f64, request: &Request) -> Roots {
    roots(system, &rest(system, speed).unwrap(), request).unwrap()
}
