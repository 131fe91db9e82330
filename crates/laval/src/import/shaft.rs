//! From elements to the sections of one shaft.

use super::model::{Model, Rayleigh, Shaft};
use super::notes::{Note, Notes};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// The shaft of a machine file.
#[derive(Clone, Debug)]
pub(super) struct Sections {
    /// Whose material, shear, forces and damping are those of the shaft.
    pub first: Shaft,
    /// Diameters and lengths from the left end.
    pub rows: Vec<Shaft>,
    /// Elements of each section.
    pub elements: usize,
    /// Positions of the nodes.
    pub nodes: Vec<f64>,
    /// Cylindrical layers: positions of their ends, and the layer.
    pub layers: Vec<(f64, f64, Shaft)>,
    /// What has mass and no stiffness: name, place, mass, diametral and polar moment of inertia.
    pub sleeves: Vec<(String, f64, [f64; 3])>,
    pub conical: bool,
}

/// A number as short as twelve digits hold it: a sum of lengths has no further ones.
pub(super) fn rounded(x: f64) -> f64 {
    format!("{x:.11e}").parse().unwrap_or(x)
}

/// Modulus of a layer over that of the core up to which it stands for a mass alone.
const NOTHING: f64 = 1e-4;

pub(super) fn sections(model: &Model, notes: &mut Notes) -> Result<Sections, Diagnostics> {
    let mut at: BTreeMap<usize, Vec<&Shaft>> = BTreeMap::new();
    for s in &model.shafts {
        at.entry(s.node).or_default().push(s);
    }
    let mut rows = Vec::new();
    let mut nodes = vec![0.0];
    let (mut covers, mut sleeves): (Vec<(f64, f64, Shaft)>, Vec<_>) = Default::default();
    let mut position = 0.0;
    for (k, (node, mut layers)) in at.into_iter().enumerate() {
        if node != k {
            let d = Diagnostic::error("ross.gap", text!("no element of the shaft lies between the nodes {k} and {next}", k, next = k + 1));
            return Err(Diagnostics(vec![
                d.at(layers[0].span.clone()).help(text!("the shafts of several rotors in one model are not imported")),
            ]));
        }
        layers.sort_by(|a, b| a.inner[0].total_cmp(&b.inner[0]));
        let core = layers[0].clone();
        let end = rounded(position + core.length);
        for layer in &layers[1..] {
            let straight = layer.outer[0] == layer.outer[1] && layer.inner[0] == layer.inner[1];
            let beside = layer.inner[0] >= core.outer[0].max(core.outer[1]) - 1e-9;
            let stiff = layer.material.modulus > NOTHING * core.material.modulus;
            if straight && beside && stiff {
                let goes_on = |l: &&mut (f64, f64, Shaft)| {
                    l.1 == position && l.2.inner == layer.inner && l.2.outer == layer.outer && l.2.material == layer.material
                };
                match covers.iter_mut().find(goes_on) {
                    Some(before) => before.1 = end,
                    None => covers.push((position, end, (*layer).clone())),
                }
                notes.add(Note::Layer, &layer.name);
            } else {
                sleeves.push((layer.name.clone(), rounded(position + 0.5 * core.length), ring(layer)));
                notes.add(Note::MassAlone, &layer.name);
            }
        }
        position = end;
        nodes.push(position);
        rows.push(core);
    }
    let first = rows[0].clone();
    same(&rows, &first, notes);
    let conical = rows.iter().any(|s| s.outer[0] != s.outer[1] || s.inner[0] != s.inner[1]);
    let elements = if sleeves.is_empty() { common(&rows) } else { 1 };
    let rows = rows.chunks(elements).map(|run| Shaft { length: rounded(run.iter().map(|s| s.length).sum()), ..run[0].clone() }).collect();
    Ok(Sections { first, rows, elements, nodes, layers: covers, sleeves, conical })
}

/// Mass, diametral and polar moment of inertia of a layer with its mean diameters.
fn ring(s: &Shaft) -> [f64; 3] {
    let (outer, inner) = (0.5 * (s.outer[0] + s.outer[1]), 0.5 * (s.inner[0] + s.inner[1]));
    let mass = 0.25 * PI * s.material.density * (outer * outer - inner * inner) * s.length;
    let polar = mass * (outer * outer + inner * inner) / 8.0;
    [mass, 0.5 * polar + mass * s.length * s.length / 12.0, polar]
}

/// How many equal elements every section can have: the largest number that divides all runs of equal cylinders.
fn common(rows: &[Shaft]) -> usize {
    let equal = |a: &Shaft, b: &Shaft| {
        a.length == b.length && a.outer == b.outer && a.inner == b.inner && a.outer[0] == a.outer[1] && a.inner[0] == a.inner[1]
    };
    let gcd = |mut a: usize, mut b: usize| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    rows.chunk_by(equal).fold(0, |n, run| gcd(n, run.len()))
}

/// Says where elements differ in what the whole shaft has once.
fn same(rows: &[Shaft], first: &Shaft, notes: &mut Notes) {
    let mut differs = |key: &str, other: &dyn Fn(&Shaft) -> bool| {
        let n = rows.iter().filter(|s| other(s)).count();
        if n > 0 {
            notes.say(text!(
                "{key} of {n} elements differs; that of {first} is taken for the whole shaft",
                key,
                n,
                first = text::quoted(&first.name)
            ));
        }
    };
    let bits = |m: &super::model::Material| [m.modulus, m.shear_modulus, m.density];
    differs("material", &|s| bits(&s.material) != bits(&first.material));
    differs("shear_effects", &|s| s.shear != first.shear);
    differs("axial_force", &|s| s.axial_force != first.axial_force);
    differs("torque", &|s| s.torque != first.torque);
    let apart = |s: &Shaft| s.damping != first.damping && [s.damping, first.damping].iter().any(|d| *d != Rayleigh::default());
    differs("alpha, beta", &apart);
    let n = rows.iter().filter(|s| !s.turns).count();
    if n > 0 {
        notes.say(text!("rotary_inertia and gyroscopic are on in all elements; {n} have them off", n));
    }
}
