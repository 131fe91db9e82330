//! Shear forces and bending moments along a body that bends, by cuts: the forces of all other parts on one side, and the weight of that length.
//!
//! ```text
//! T(z) = sum F_i + int w dz,   M(z) = sum F_i (z - z_i) - sum m_i + int w(t) (z - t) dt + P [u(z) - u(0)]      over what is below z
//! ```
//!
//! F_i, m_i forces and moments (conjugate to the slope) at the nodes, w weight per length, P axial tension, u deflection; `E I u'' = M`. Above the last node both vanish,
//! which is the check.
//!
//! Theory: `docs/theory/shafts.md#sag`.

use super::Statics;
use super::forces::share;
use crate::model::blocks::Blocks;
use crate::model::slot::scatter;
use crate::model::station::Row;
use crate::model::system::{Slot, System};
use laval_num::dense::Mat;
use serde::{Deserialize, Serialize};

/// The state on both sides of a node.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Cut {
    /// Position along the body, m.
    pub position: f64,
    /// Deflection x, y, m.
    pub deflection: [f64; 2],
    /// Slope of the section in x and y, rad.
    pub slope: [f64; 2],
    /// Force in x and y of what is below on what is above, just below and just above, N.
    pub shear: [[f64; 2]; 2],
    /// Bending moment in the plane of x and of y, just below and just above, N m; positive where the curvature of the deflection is.
    pub moment: [[f64; 2]; 2],
}

/// A body that bends.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Beam {
    /// Its slot.
    pub slot: usize,
    /// From its lower end to its upper.
    pub cuts: Vec<Cut>,
    /// Shear force above the upper end, which is 0 but for rounding, over all forces on the body.
    pub force_defect: f64,
    /// Bending moment there, likewise, over all forces times the length.
    pub moment_defect: f64,
}

/// Every body that bends, with forces at places that are held.
pub fn beams(system: &System, at: &Statics, ties: &[Row]) -> Vec<Beam> {
    (0..system.slots().len()).filter_map(|k| beam(system, at, ties, k)).collect()
}

fn linear(system: &System, slot: &Slot, part: &dyn crate::model::erased::Erased, n: usize) -> Blocks<f64> {
    let mut b = Blocks::default();
    b.reset_band(n, 0, slot.reach, 0.0);
    part.linear_f64(&system.params()[slot.params.clone()], 0.0, &mut b);
    b
}

/// Coordinates of a node: x, y, tilt_x, tilt_y, then those along and about the axis.
fn node(slot: &Slot, nodes: &[f64]) -> usize {
    slot.own.len() / nodes.len().max(1)
}

fn beam(system: &System, at: &Statics, ties: &[Row], k: usize) -> Option<Beam> {
    let slot = &system.slots()[k];
    let nodes = slot.part.body()?.nodes()?;
    let n = slot.own.len();
    let size = node(slot, &nodes);
    if slot.map.len() != n || n != size * nodes.len() || nodes.len() < 2 {
        return None;
    }
    let own = linear(system, slot, &*slot.part, n);
    let mut force = vec![0.0; system.n()];
    for (i, other) in system.slots().iter().enumerate().filter(|x| x.0 != k && !at.left_out[x.0]) {
        let share = share(system, other, at.speed, &at.seen_by(i), &at.z);
        let all: Vec<f64> = share.elastic.iter().zip(&share.weight).map(|(a, b)| -(a + b)).collect();
        scatter(&other.map, &all, &mut force);
    }
    for (row, holding) in ties.iter().zip(&at.holding) {
        row.iter().for_each(|&(i, a)| force[i] += a * holding);
    }
    let q = &at.q[slot.own.clone()];
    let at_node = |i: usize| -> [f64; 4] { [0, 1, 2, 3].map(|c| force[slot.own.start + size * i + c] + own.force[size * i + c]) };
    // gravity along x and y
    let field: [f64; 2] = [0, 1].map(|p| slot.weight.get(p).map_or(0.0, |w| -w));
    let lengths = line_masses(system, slot, &nodes, &own);
    let tension = tension(&own, &nodes, size);
    let (mut shear, mut moment) = ([0.0; 2], [0.0; 2]);
    let (mut forces, mut cuts) = (0.0f64, Vec::with_capacity(nodes.len()));
    for i in 0..nodes.len() {
        let node: [f64; 4] = [0, 1, 2, 3].map(|c| q[size * i + c]);
        let (deflection, slope) = ([node[0], node[1]], [node[3], -node[2]]);
        if i > 0 {
            let (length, (mass, first)) = (nodes[i] - nodes[i - 1], lengths[i - 1]);
            for p in 0..2 {
                moment[p] += shear[p] * length + field[p] * (mass * length - first);
                shear[p] += field[p] * mass;
                forces += (field[p] * mass).abs();
            }
        }
        let axial: [f64; 2] = [0, 1].map(|p| tension * (deflection[p] - q[p]));
        let (below, bent) = (shear, [moment[0] + axial[0], moment[1] + axial[1]]);
        let [fx, fy, about_x, about_y] = at_node(i);
        for (p, (f, m)) in [(fx, about_y), (fy, -about_x)].into_iter().enumerate() {
            shear[p] += f;
            moment[p] -= m;
            forces += f.abs();
        }
        let after = [moment[0] + axial[0], moment[1] + axial[1]];
        cuts.push(Cut { position: nodes[i], deflection, slope, shear: [below, shear], moment: [bent, after] });
    }
    let last = cuts.last()?;
    let (f, m) = (last.shear[1][0].hypot(last.shear[1][1]), last.moment[1][0].hypot(last.moment[1][1]));
    let over = |x: f64, size: f64| if size > 0.0 { x / size } else { x };
    Some(Beam { slot: k, force_defect: over(f, forces), moment_defect: over(m, forces * nodes[nodes.len() - 1]), cuts })
}

/// Tension: the stiffness against a rigid tilt, which nothing else than an axial force gives, is P L.
fn tension(own: &Blocks<f64>, nodes: &[f64], size: usize) -> f64 {
    const ROUNDING: f64 = 1e-11;
    let field = |i: usize| match i % size {
        0 => nodes[i / size] - nodes[0],
        3 => 1.0,
        _ => 0.0,
    };
    let (mut sum, mut all) = (0.0, 0.0);
    for i in 0..size * nodes.len() {
        for j in own.stiffness.columns(i) {
            let x = field(i) * own.stiffness[(i, j)] * field(j);
            sum += x;
            all += x.abs();
        }
    }
    if sum.abs() > ROUNDING * all { sum / (nodes[nodes.len() - 1] - nodes[0]) } else { 0.0 }
}

/// Parts that every element is divided into, to see how its mass is spread.
const PARTS: usize = 4;
/// Points and weights of Gauss' rule of five points on [0, 1].
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_6, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Mass (kg) and first moment about the lower node (kg m) of every element.
///
/// The mass matrix holds them only mixed with those of the neighbours. Inside an element that is divided in four, the loads `int m N_j dz` of the three inner nodes are its own; with a mass per
/// length `c0 + c1 s + c2 s^2`, as of a cone, they give it exactly.
fn line_masses(system: &System, slot: &Slot, nodes: &[f64], own: &Blocks<f64>) -> Vec<(f64, f64)> {
    let elements = nodes.len() - 1;
    let inner = |e: usize| (1..PARTS).map(move |k| nodes[e] + (nodes[e + 1] - nodes[e]) * k as f64 / PARTS as f64);
    let positions: Vec<f64> = nodes.iter().copied().chain((0..elements).flat_map(inner)).collect();
    let fine = slot.part.body().and_then(|b| b.divided(&positions));
    let found = fine.as_ref().and_then(|f| Some((f.body()?.nodes()?, f)));
    let size = node(slot, nodes);
    let loads =
        |b: &Blocks<f64>, i: usize| -> f64 { b.mass.columns(size * i).filter(|j| j % size == 0).map(|j| b.mass[(size * i, j)]).sum() };
    let Some((places, fine)) = found else { return halves(nodes, |i| loads(own, i)) };
    let blocks = linear(system, slot, &**fine, size * places.len());
    let same = |a: f64, b: f64| (a - b).abs() <= 1e-12 * nodes[elements];
    let mut out: Vec<Option<(f64, f64)>> = Vec::with_capacity(elements);
    for e in 0..elements {
        let first = places.iter().position(|z| same(*z, nodes[e]));
        let all = first.filter(|f| inner(e).enumerate().all(|(k, z)| places.get(f + 1 + k).is_some_and(|p| same(*p, z))));
        out.push(all.and_then(|f| {
            let of: [f64; PARTS - 1] = [0, 1, 2].map(|k| loads(&blocks, f + 1 + k));
            let length = nodes[e + 1] - nodes[e];
            if of.iter().all(|x| (x - of[1]).abs() <= 1e-13 * of[1].abs()) {
                let mass = PARTS as f64 * of[1];
                return Some((mass, 0.5 * mass * length));
            }
            cone(system, slot, &**fine, (f, nodes[e], length), of)
        }));
    }
    // elements too short to be divided, a few millionths of the body, are as heavy as a neighbour
    let line = |e: usize| out[e].map(|x| x.0 / (nodes[e + 1] - nodes[e]));
    let near = |e: usize| {
        (0..elements).filter_map(|d| (e + d < elements).then(|| line(e + d)).flatten().or_else(|| line(e.checked_sub(d)?))).next()
    };
    let one = |e: usize| {
        let length = nodes[e + 1] - nodes[e];
        let mass = near(e).unwrap_or(0.0) * length;
        out[e].unwrap_or((mass, 0.5 * mass * length))
    };
    (0..elements).map(one).collect()
}

/// A body that cannot be divided: uniform elements.
fn halves(nodes: &[f64], load: impl Fn(usize) -> f64) -> Vec<(f64, f64)> {
    let mut left = 0.0;
    let one = |e: usize| {
        let half = load(e) - left;
        left = half;
        (2.0 * half, half * (nodes[e + 1] - nodes[e]))
    };
    (0..nodes.len() - 1).map(one).collect()
}

/// From the loads of the inner nodes, by the shape functions of the divided body.
fn cone(
    system: &System,
    slot: &Slot,
    fine: &dyn crate::model::erased::Erased,
    (first, start, length): (usize, f64, f64),
    of: [f64; PARTS - 1],
) -> Option<(f64, f64)> {
    let (body, p) = (fine.body()?, &system.params()[slot.params.clone()]);
    let size = fine.layout().own.len() / body.nodes()?.len();
    // loads of 1, s, s^2
    let mut a = Mat::zeros(PARTS - 1, 3);
    for part in 0..PARTS {
        for (x, weight) in GAUSS {
            let s = (part as f64 + x) / PARTS as f64;
            let shape = body.shape(p, start + s * length);
            let dz = weight * length / PARTS as f64;
            for k in 0..PARTS - 1 {
                let n = shape.get(size * (first + 1 + k))?[0];
                [1.0, s, s * s].into_iter().enumerate().for_each(|(j, f)| a[(k, j)] += n * f * dz);
            }
        }
    }
    let c = super::solved(&a, of.to_vec())?;
    let mass = length * (c[0] + c[1] / 2.0 + c[2] / 3.0);
    Some((mass, length * length * (c[0] / 2.0 + c[1] / 3.0 + c[2] / 4.0)))
}
