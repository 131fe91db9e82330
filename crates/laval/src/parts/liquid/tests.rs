//! Unit tests of the liquid part.

use super::*;
use crate::model::field::Value;

pub(super) fn cavity(free: f64, wave_damping: f64) -> LiquidParams {
    LiquidParams {
        cavity_radius: 0.07,
        cavity_height: 0.06,
        density: 1000.0,
        free_surface_radius: 0.07 * free,
        wave_damping,
        viscosity: 0.0,
    }
}

pub(super) fn partial() -> Liquid {
    Liquid::new(Attach::on("drum"), Fill::Partial)
}

pub(super) fn viscous() -> LiquidParams {
    LiquidParams { viscosity: 2e-5, ..cavity(0.667, 0.0) }
}

fn build(kind: &'static str, value: f64) -> (Option<Liquid>, f64, Vec<String>) {
    let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
    values.set("in", Value::Attach(Attach::on("drum")), None);
    values.set("fill", Value::OneOf(kind, value), None);
    for (name, x) in [("cavity_radius", 0.07), ("cavity_height", 0.06), ("density", 1000.0)] {
        params.set(name, x);
    }
    let part = Liquid::build(&values, &mut params, &mut d);
    (part, params.get("free_surface_radius").unwrap_or(f64::NAN), d.0.iter().map(|d| d.to_string()).collect())
}

#[test]
fn four_ways_of_saying_the_fill_agree() {
    let (radius, volume) = (0.667 * 0.07, PI * 0.07 * 0.07 * 0.06);
    let fraction = 1.0 - 0.667f64 * 0.667;
    for (kind, value) in [
        ("free_surface_radius", radius),
        ("volume_fraction", fraction),
        ("volume", fraction * volume),
        ("mass", fraction * volume * 1000.0),
    ] {
        let (part, free, text) = build(kind, value);
        assert!(part.is_some_and(|l| l.fill == Fill::Partial) && text.is_empty());
        assert!((free - radius).abs() < 1e-15, "{kind}");
    }
    // 55.5 % of the volume, not a third
    assert!((fraction - 0.555).abs() < 5e-4);
}

#[test]
fn empty_and_full_are_cases_of_their_own() {
    for (kind, value, fill) in [
        ("volume_fraction", 1.0, Fill::Full),
        ("free_surface_radius", 0.0, Fill::Full),
        ("volume_fraction", 0.0, Fill::Empty),
        ("free_surface_radius", 0.07, Fill::Empty),
        ("mass", 0.0, Fill::Empty),
    ] {
        assert!(build(kind, value).0.is_some_and(|l| l.fill == fill), "{kind} {value}");
    }
    let empty = Liquid::new(Attach::on("drum"), Fill::Empty);
    assert!(empty.check(&cavity(1.0, 0.0)).is_empty());
    assert!(empty.check(&cavity(0.9, 0.0))[0].1.contains("different machines"));
}

#[test]
fn impossible_fills_are_told() {
    let (part, _, text) = build("free_surface_radius", 0.08);
    assert!(part.is_none() && text[0].starts_with("the free surface (radius 80 mm) lies outside the cavity (radius 70 mm)"), "{text:?}");
    let (part, _, text) = build("volume_fraction", 1.2);
    assert!(part.is_none() && text[0].starts_with("this is 1.2 times what the cavity holds"), "{text:?}");
    let (part, _, text) = build("mass", 2.0);
    assert!(part.is_none() && text[0].contains("923.6 g of this liquid"), "{text:?}");
    assert!(build("volume", f64::NAN).0.is_none());
    assert!(Liquid::new(Attach::on("drum"), Fill::Partial).check(&cavity(1.1, 0.0))[0].1.contains("outside the cavity"));
}

#[test]
fn without_spin_the_layer_is_outside_its_validity() {
    let liquid = Liquid::new(Attach::on("drum"), Fill::Partial);
    let ratio = |speed: f64| {
        let at = At { q: &[0.0; 2], v: &[0.0; 2], a: &[9.81, 0.0], z: &[0.0; 4], phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let mut out = Vec::new();
        liquid.validity(&cavity(0.667, 0.0), &at, &mut out);
        out[1].ratio
    };
    assert!(ratio(0.0) > 1.0 && ratio(5.0) > 1.0 && ratio(300.0) < 0.01);
}
