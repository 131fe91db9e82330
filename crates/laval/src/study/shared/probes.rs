//! What is reported of the motion of bodies: the displacement of their reference points, of every other point that something names, and their tilts. One order, one
//! set of names and one measure of size for all studies.

use super::speed_range::SpinSpeeds;
use super::support::probe_name;
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Message};
use crate::solve::characteristic::Characteristic;
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::rest::rest;

/// Indices of the probes: reference points of the bodies in their order, then further points, then tilts.
pub fn ordered(system: &System) -> Vec<usize> {
    let probes = system.probes();
    let class = |k: &usize| (probes[*k].is_tilt(), !probes[*k].is_reference());
    let mut all: Vec<usize> = (0..probes.len()).collect();
    all.sort_by_key(class);
    all
}

/// The probes in that order.
pub fn all(system: &System) -> Vec<Probe> {
    ordered(system).into_iter().map(|k| system.probes()[k].clone()).collect()
}

/// Column of the largest value: "amplitude.drum", "amplitude.drum at 100 mm", "tilt.drum".
pub fn column(probe: &Probe) -> String {
    if probe.is_tilt() { format!("tilt.{}", probe.name) } else { format!("amplitude.{}", probe_name(probe)) }
}

/// The same in words, as columns of studies of periodic motions are named: "drum at 100 mm largest displacement".
pub fn largest_column(probe: &Probe) -> String {
    if probe.is_tilt() { format!("{} largest tilt", probe.name) } else { format!("{} largest displacement", probe_name(probe)) }
}

/// What a column of largest values over a period holds.
pub fn largest_doc(probe: &Probe) -> &'static str {
    if probe.is_tilt() { "largest tilt over a period" } else { "largest distance of this point from its rest position over a period" }
}

/// "displacement" or "tilt".
pub fn quality(probe: &Probe) -> &'static str {
    if probe.is_tilt() { "tilt" } else { "displacement" }
}

/// Name of the body, or of the point of a body, to which a size belongs.
pub fn owner(probe: &Probe) -> String {
    if probe.is_tilt() { probe.name.clone() } else { probe_name(probe) }
}

/// The body, point of a body or tilt of a body, as an argument of a sentence.
pub fn arg(probe: &Probe) -> Arg {
    let body = |key: &str| Message::new(key).arg("body", Arg::name(&probe.name));
    match probe.height() {
        Some(z) => body("point").arg("height", Arg::quantity(z, "m").digits(probe.digits as u8)).into(),
        None if probe.is_tilt() => body("tilt-of").into(),
        None => body("body").into(),
    }
}

/// The body or point of a body to which a size belongs, as a label.
pub fn label(probe: &Probe) -> Arg {
    point(probe, "label-point")
}

/// The same in front of a number.
pub fn named(probe: &Probe) -> Arg {
    point(probe, "named-point")
}

fn point(probe: &Probe, key: &str) -> Arg {
    match probe.height() {
        Some(z) => {
            let height = Arg::quantity(z, "m").digits(probe.digits as u8);
            Message::new(key).arg("body", Arg::name(&probe.name)).arg("height", height).into()
        }
        None => Arg::name(&probe.name),
    }
}

/// Its size, as a label: `amplitude of drum`, `tilt of drum`.
pub fn size_of(probe: &Probe) -> Arg {
    Arg::of(if probe.is_tilt() { "tilt" } else { "amplitude" }, label(probe))
}

/// An axis of its sizes, in a unit in which `most` is read easily.
pub fn axis(label: impl Into<Arg>, probe: &Probe, most: f64) -> Axis {
    match (probe.is_tilt(), most < 1e-3) {
        (true, _) => Axis::new(label, "mrad").factor(1e3),
        (false, true) => Axis::new(label, "µm").factor(1e6),
        (false, false) => Axis::new(label, "mm").factor(1e3),
    }
}

/// Largest value over a period of each of these probes; NaN of no motion.
pub fn sizes(system: &System, which: &[usize], orbit: &Orbit, turns: usize) -> Vec<f64> {
    let size = |&k: &usize| if orbit.orders.is_empty() { f64::NAN } else { Measure::Probe(k).largest(system, orbit, turns).0 };
    which.iter().map(size).collect()
}

/// The largest of sizes over what is typical of each; NaN counts as none.
pub fn loudest<'p>(sizes: impl IntoIterator<Item = (&'p Probe, f64)>) -> f64 {
    sizes.into_iter().map(|(p, x)| x.abs() / p.typical()).fold(0.0, f64::max)
}

/// Share of the loudest below which a size is what a computation leaves of none.
pub const ROUNDING: f64 = 1e-9;

/// Times the tolerance of settling that the size of a motion beside another must be, to be known.
pub const UNRESOLVED: f64 = 10.0;

/// Sizes by probe without those of displacements that are not resolved beside the tilt of their body, where motions settle within this tolerance.
pub fn resolved(sizes: Vec<(Probe, Vec<f64>)>, tolerance: f64) -> Vec<(Probe, Vec<f64>)> {
    let most = |x: &[f64]| x.iter().copied().fold(0.0, f64::max);
    let loud = loudest(sizes.iter().map(|(p, x)| (p, most(x))));
    let tilting: Vec<usize> = sizes.iter().filter(|s| s.0.is_tilt()).map(|s| s.0.station).collect();
    let nothing = |p: &Probe, x: &[f64]| !p.is_tilt() && tilting.contains(&p.station) && still(p, most(x), loud, UNRESOLVED * tolerance);
    sizes.into_iter().filter(|(p, x)| !nothing(p, x)).collect()
}

/// Some point is displaced, and not only by what rounding leaves beside the tilts; so too where nothing moves.
pub fn displaced<'p, I: IntoIterator<Item = (&'p Probe, f64)>>(sizes: impl Fn() -> I) -> bool {
    let loud = loudest(sizes());
    loud == 0.0 || sizes().into_iter().any(|(p, x)| !p.is_tilt() && !still(p, x, loud, ROUNDING))
}

/// How much farther another point of a body moves than its reference point, where that other point is named.
const FARTHER: f64 = 1.001;

/// The point of each body with the largest size, its reference point where they move alike; a size that is no number is the largest.
pub fn farthest(system: &System, size: impl Fn(&Probe) -> f64) -> Vec<(&Probe, f64)> {
    let mut out: Vec<(&Probe, f64)> = Vec::new();
    for reference in system.probes().iter().filter(|p| p.is_reference()) {
        let others = system.probes().iter().filter(|p| !p.is_tilt() && !p.is_reference() && p.station == reference.station);
        let farther = |a: (&'_ Probe, f64), x: f64| !(a.1.is_nan() || x <= FARTHER * a.1);
        out.push(others.map(|p| (p, size(p))).fold((reference, size(reference)), |a, b| if farther(a, b.1) { b } else { a }));
    }
    out
}

/// Which probe of this kind has the largest of these sizes, and how large that is; sizes that are not known count as none.
pub fn most(probes: &[Probe], sizes: &[f64], tilt: bool) -> Option<(usize, f64)> {
    let own = sizes.iter().copied().enumerate().filter(|&(k, x)| probes[k].is_tilt() == tilt && x.is_finite());
    own.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// A size that is none beside the loudest of a motion, where what is smaller than this `share` of it is not resolved.
pub fn still(probe: &Probe, size: f64, loudest: f64, share: f64) -> bool {
    size.abs() <= share * loudest * probe.typical()
}

/// Sentence in place of the largest of sizes that are [`unforced`].
pub const UNFORCED: &str = "unforced";

/// No force turns with the rotor at these speeds, and of a motion there is rounding at most: the sizes tell of no resonance.
pub fn unforced<'p>(system: &System, speeds: &[SpinSpeeds], sizes: impl IntoIterator<Item = (&'p Probe, f64)>) -> bool {
    let known: Vec<_> = sizes.into_iter().filter(|s| !s.1.is_nan()).collect();
    if known.is_empty() || !(loudest(known) <= ROUNDING) {
        return false;
    }
    // unbalance does not act at standstill; what has no rest is not known to be without force
    let still = |w: f64| rest(system, w).is_ok_and(|about| Characteristic::new(system, &about).loads().1.iter().all(|f| f.abs() == 0.0));
    let mut ends = speeds.iter().flat_map(|s| [s.from, s.to]).filter(|w| *w != 0.0).peekable();
    ends.peek().is_some() && ends.all(still)
}
