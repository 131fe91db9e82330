//! Stations of a machine along its axis: every point of a body whose displacement is known, with its place, for pictures of shapes and orbits.

use crate::model::capability::scope::Axis;
use crate::model::field::Attach;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::Link;
use crate::model::probe::Sight;
use crate::model::system::{Pair, Slot, System};
use crate::outcome::{TableBuilder, Tiles};
use crate::solve::sectors::circular;
use laval_num::complex::C64;
use serde::{Deserialize, Serialize};

/// A point of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Name of the body.
    pub body: String,
    /// Height above its reference point, m.
    pub height: f64,
    /// Place along the axis of the machine, m; where that is not known, in steps.
    pub place: f64,
    /// What the axis of a picture says there: the height, and along a shaft the position on it, m.
    pub mark: f64,
    /// From the axis of the first body to its own, m.
    #[serde(default)]
    pub axis: [f64; 2],
    /// Stations of one line are joined: those of the shaft, and of every body beside it.
    pub line: usize,
    /// Something is attached there, or names it; else an end of a body, which shows its tilt, or a node of one that bends.
    pub named: bool,
    /// Both components of the displacement over the coordinates.
    pub rows: Pair,
}

/// All stations, bodies in the order of the machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stations {
    /// In the order of bodies, each from its lowest to its highest.
    pub all: Vec<Point>,
    /// Places are distances; else bodies stand one below the other in equal steps.
    pub to_scale: bool,
}

/// Share of the extent of a machine within which two places are one.
const SAME: f64 = 1e-9;

impl Stations {
    /// The stations of a machine.
    pub fn of(system: &System) -> Stations {
        let bodies = bodies(system);
        let mut all = Vec::new();
        for (k, body) in bodies.iter().enumerate() {
            let probes = system.probes().iter().filter(|p| body.stations.contains(&p.station));
            let mut own: Vec<Point> = probes.filter_map(|p| named(body, p)).collect();
            own.extend(if body.flexible { nodes(system, body, &own) } else { ends(system, body, &own) });
            own.sort_by(|a, b| a.height.total_cmp(&b.height));
            all.extend(own.into_iter().map(|s| (k, s)));
        }
        let (lines, offsets) = (lines(system, &bodies), offsets(system, &bodies));
        let carried = carried(system, &bodies);
        let placed = |(k, s): (usize, Point)| {
            let [x, y, z] = offsets[k];
            Point { line: lines[k], place: z + s.height, axis: [x, y], mark: carried[k] + s.height, ..s }
        };
        let mut out = Stations { all: all.into_iter().map(placed).collect(), to_scale: true };
        if out.coincide(&bodies, &lines) {
            out.stack(system, &bodies);
        }
        out
    }

    /// More than a single point moves.
    pub fn have_shape(&self) -> bool {
        self.all.len() > 1
    }

    /// Nothing is known of where bodies stand: all places are one, or those of two bodies of a shaft are.
    fn coincide(&self, bodies: &[Body], lines: &[usize]) -> bool {
        let extent = |own: &mut dyn Iterator<Item = f64>| own.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        let (low, high) = extent(&mut self.all.iter().map(|s| s.place));
        let size = low.abs().max(high.abs());
        let of = |k: usize| extent(&mut self.all.iter().filter(|s| s.body == bodies[k].name).map(|s| s.place));
        let pairs = (0..bodies.len()).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|(i, j)| lines[*i] == lines[*j]);
        let overlap = |(i, j): (usize, usize)| {
            let (a, b) = (of(i), of(j));
            a.0.max(b.0) <= a.1.min(b.1) + SAME * size
        };
        high - low <= SAME * size || pairs.into_iter().any(overlap)
    }

    /// Bodies one below the other: what turns above what carries it.
    fn stack(&mut self, system: &System, bodies: &[Body]) {
        self.to_scale = false;
        self.all.iter_mut().for_each(|s| s.axis = [0.0; 2]);
        let mut order: Vec<&Body> = bodies.iter().collect();
        order.sort_by_key(|b| !turns(system, b));
        let extent = |name: &str| {
            let own = self.all.iter().filter(|s| s.body == name).map(|s| s.height);
            own.fold((0.0f64, 0.0f64), |(a, b), x| (a.min(x), b.max(x)))
        };
        let extents: Vec<(f64, f64)> = order.iter().map(|b| extent(b.name)).collect();
        let largest = extents.iter().map(|(a, b)| b - a).fold(0.0, f64::max);
        let gap = if largest > 0.0 { 0.6 * largest } else { 1.0 };
        let mut top = 0.0;
        for (b, (low, high)) in order.iter().zip(extents) {
            for s in self.all.iter_mut().filter(|s| s.body == b.name) {
                s.place = top - high + s.height;
            }
            top -= high - low + gap;
        }
    }

    /// Forward and backward circular amplitudes of every station.
    pub fn motion(&self, q: &[C64]) -> Vec<[C64; 2]> {
        let one = |s: &Point| {
            let [x, y] = s.rows.amplitudes(q);
            let (f, b) = circular(x, y);
            [f, b]
        };
        self.all.iter().map(one).collect()
    }

    /// Adds the columns by which pictures are drawn: stations of all pictures one after the other, with the motion of each.
    pub(in crate::study) fn columns(&self, table: TableBuilder, motions: &[&[[C64; 2]]], unit: &str) -> TableBuilder {
        let rows = || motions.iter().flat_map(|m| self.all.iter().zip(m.iter()));
        let number = |f: &dyn Fn(&Point, &[C64; 2]) -> f64| rows().map(|(s, m)| f(s, m)).collect::<Vec<f64>>();
        let size = |m: &[C64; 2], sign: f64| m[0].abs() + sign * m[1].abs();
        let table = if self.all.iter().all(|s| s.axis == [0.0; 2]) {
            table
        } else {
            table
                .float(Tiles::AXIS[0], "m", "from the axis of the first body to that of this one, along x", number(&|s, _| s.axis[0]))
                .float(Tiles::AXIS[1], "m", "from the axis of the first body to that of this one, along y", number(&|s, _| s.axis[1]))
        };
        table
            .names(Tiles::BODY, "body", rows().map(|r| r.0.body.clone()).collect())
            .float(
                Tiles::HEIGHT,
                "m",
                "height above the reference point of the body, or position on the shaft that carries it",
                number(&|s, _| s.mark),
            )
            .float(Tiles::PLACE, if self.to_scale { "m" } else { "" }, "place along the axis", number(&|s, _| s.place))
            .int(Tiles::LINE, "", "stations of one line are joined", rows().map(|r| r.0.line as i64).collect())
            .flag(Tiles::NAMED, "something is attached there; else an end of the body", rows().map(|r| r.0.named).collect())
            .float("major", unit, "semi-major axis of the orbit", number(&|_, m| size(m, 1.0)))
            .float("minor", unit, "semi-minor axis of the orbit, negative for backward whirl", number(&|_, m| size(m, -1.0)))
            .float(Tiles::FORWARD, unit, "forward amplitude", number(&|_, m| m[0].abs()))
            .float(Tiles::FORWARD_PHASE, "rad", "angle of the forward amplitude", number(&|_, m| m[0].arg()))
            .float(Tiles::BACKWARD, unit, "backward amplitude", number(&|_, m| m[1].abs()))
            .float(Tiles::BACKWARD_PHASE, "rad", "angle of the backward amplitude", number(&|_, m| m[1].arg()))
    }

    /// The speed of the body of a station over that of the machine is negative: it whirls forward where it goes round backward.
    pub fn reversed(&self, system: &System, station: usize) -> bool {
        let slot = self.all.get(station).and_then(|s| system.slots().iter().find(|slot| slot.name == s.body));
        slot.is_some_and(|s| s.speed(system.params(), 1.0) < 0.0)
    }

    /// Whether the axis lies.
    pub fn horizontal(system: &System) -> bool {
        system.machine.axis == Axis::Horizontal
    }
}

/// A body with its stations in the model.
struct Body<'s> {
    name: &'s str,
    slot: usize,
    flexible: bool,
    stations: Vec<usize>,
}

fn bodies(system: &System) -> Vec<Body<'_>> {
    let mut out: Vec<Body> = Vec::new();
    for (k, s) in system.stations().iter().enumerate() {
        match out.last_mut().filter(|b| b.slot == s.slot) {
            Some(body) => body.stations.push(k),
            None => out.push(Body { name: &system.slots()[s.slot].name, slot: s.slot, flexible: s.flexible, stations: vec![k] }),
        }
    }
    out
}

/// The station of a probe of a displacement.
fn named(body: &Body, probe: &crate::model::probe::Probe) -> Option<Point> {
    let Sight::Displacement(height) = probe.sight else { return None };
    Some(Point {
        body: body.name.to_string(),
        height,
        place: 0.0,
        axis: [0.0; 2],
        mark: height,
        line: 0,
        named: true,
        rows: probe.rows.clone(),
    })
}

/// Nodes of a body that bends, beside those known.
fn nodes(system: &System, body: &Body, known: &[Point]) -> Vec<Point> {
    let nodes = system.slots()[body.slot].part.body().and_then(|b| b.nodes()).unwrap_or_default();
    let size = nodes.iter().fold(0.0f64, |m, z| m.max(z.abs()));
    let beside = |z: &f64| known.iter().all(|s| (s.height - z).abs() > SAME * size);
    let one = |z: f64| {
        let rows = system.point(body.slot, z)?;
        Some(Point { body: body.name.to_string(), height: z, place: 0.0, axis: [0.0; 2], mark: z, line: 0, named: false, rows })
    };
    nodes.into_iter().filter(beside).filter_map(one).collect()
}

/// Ends of a body that tilts and whose other stations lie too near each other to show it: a radius of gyration from its reference point. A body that is carried by
/// another needs none.
fn ends(system: &System, body: &Body, known: &[Point]) -> Vec<Point> {
    let of = |s: &crate::model::system::Station| Some((s.lateral.first()?, s.tilt.as_ref()?.first()?));
    if !system.slots()[body.slot].layout.ports.is_empty() {
        return Vec::new();
    }
    let Some((x, t)) = body.stations.first().and_then(|&k| of(&system.stations()[k])) else { return Vec::new() };
    let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
    system.linear(system.params(), system.machine.speed.unwrap_or(0.0), Form::Frequency, &mut model, &mut scratch);
    let heights = known.iter().map(|s| s.height);
    let (low, high) = heights.fold((0.0f64, 0.0f64), |(a, b), x| (a.min(x), b.max(x)));
    let radius = (model.mass(t, t) / model.mass(x, x)).sqrt();
    let radius = if radius.is_finite() && radius > 0.0 { radius } else { high - low };
    let radius = if radius > 0.0 { radius } else { 1.0 };
    if high - low >= radius {
        return Vec::new();
    }
    let one = |z: f64| Point {
        body: body.name.to_string(),
        height: z,
        place: 0.0,
        axis: [0.0; 2],
        mark: z,
        line: 0,
        named: false,
        rows: Pair([vec![(x, 1.0), (t + 1, z)], vec![(x + 1, 1.0), (t, -z)]]),
    };
    // beside a station there is no need of an end
    [-radius, radius].into_iter().filter(|z| known.iter().all(|s| (s.height - z).abs() > 0.2 * radius)).map(one).collect()
}

fn turns(system: &System, body: &Body) -> bool {
    system.slots()[body.slot].part.body().is_some_and(|b| b.turns())
}

/// Pairs of bodies that a part joins, with the way from the reference point of the first to that of the second, m: across the axis (x, y), and along it.
fn joints(system: &System, bodies: &[Body]) -> Vec<(usize, usize, [f64; 3])> {
    let number = |name: &Option<String>| bodies.iter().position(|b| Some(b.name) == name.as_deref());
    let mut out = Vec::new();
    for slot in system.slots() {
        let wheels = slot.part.mesh().map(|m| m.wheels(&system.params()[slot.params.clone()]));
        if let (Some(wheels), [Some(a), Some(b)]) = (wheels, carriers(slot)) {
            let [x, y] = wheels.centres();
            out.extend(number(&a.body).zip(number(&b.body)).map(|(i, j)| (i, j, [x, y, a.position - b.position])));
            continue;
        }
        for port in &slot.layout.ports {
            out.extend(match &port.link {
                Link::Between(a, b) => number(&a.body).zip(number(&b.body)).map(|(i, j)| (i, j, [0.0, 0.0, a.position - b.position])),
                Link::On(a) => number(&a.body).zip(number(&Some(slot.name.clone()))).map(|(i, j)| (i, j, [0.0, 0.0, a.position])),
            });
        }
    }
    out.retain(|(a, b, _)| a != b);
    out
}

/// What the first two ports of a part are attached to.
pub(in crate::study) fn carriers(slot: &Slot) -> [Option<&Attach>; 2] {
    [0, 1].map(|k| match &slot.layout.ports.get(k)?.link {
        Link::On(a) => Some(a),
        Link::Between(..) => None,
    })
}

/// The line of every body: bodies of a shaft, which turn and are joined, share one. What a body that bends carries is drawn beside it.
fn lines(system: &System, bodies: &[Body]) -> Vec<usize> {
    let mut line: Vec<usize> = (0..bodies.len()).collect();
    for (a, b, d) in joints(system, bodies) {
        let rigid = d[..2] == [0.0; 2] && !bodies[a].flexible && !bodies[b].flexible;
        if rigid && turns(system, &bodies[a]) && turns(system, &bodies[b]) {
            let (keep, leave) = (line[a].min(line[b]), line[a].max(line[b]));
            line.iter_mut().filter(|l| **l == leave).for_each(|l| *l = keep);
        }
    }
    line
}

/// Position of the reference point of every body on the one that bends and carries it; 0 of others.
fn carried(system: &System, bodies: &[Body]) -> Vec<f64> {
    let position = |b: &Body| {
        let port = system.slots()[b.slot].layout.ports.first()?;
        let Link::On(attach) = &port.link else { return None };
        let carrier = bodies.iter().find(|c| Some(c.name) == attach.body.as_deref())?;
        carrier.flexible.then_some(attach.position)
    };
    bodies.iter().map(|b| position(b).unwrap_or_default()).collect()
}

/// Place of the reference point of every body across and along the axis, from the points that parts join.
fn offsets(system: &System, bodies: &[Body]) -> Vec<[f64; 3]> {
    let joints = joints(system, bodies);
    let mut out: Vec<Option<[f64; 3]>> = vec![None; bodies.len()];
    let moved = |x: [f64; 3], d: [f64; 3], sign: f64| std::array::from_fn(|k| x[k] + sign * d[k]);
    for first in 0..bodies.len() {
        if out[first].is_none() {
            out[first] = Some([0.0; 3]);
        }
        // each pass reaches one body farther
        for _ in 0..bodies.len() {
            for &(a, b, d) in &joints {
                match (out[a], out[b]) {
                    (Some(x), None) => out[b] = Some(moved(x, d, 1.0)),
                    (None, Some(x)) => out[a] = Some(moved(x, d, -1.0)),
                    _ => {}
                }
            }
        }
    }
    out.into_iter().map(|x| x.unwrap_or_default()).collect()
}
