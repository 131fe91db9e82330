//! The machine as solids of revolution in metres, for its section and for its picture in space.
//!
//! Shafts, cavities and liquids have the sizes of the machine file. Discs have the mass and the moments of inertia of the file as discs of steel do; bearings and housings, whose
//! size no file gives, follow from what stands beside them.

use laval::model::system::System;
use laval::outcome::Block;
use laval::study::stations::Stations;
use serde_json::{Value as Json, json};
use std::f64::consts::PI;

/// Steel, kg/m^3.
const STEEL: f64 = 7850.0;
/// Thickness of a disc whose moments of inertia are not known, over its radius.
const FLAT: f64 = 0.35;
/// Wall of a cavity, and its opening, over its radius.
const WALL: f64 = 0.07;
const OPENING: f64 = 0.3;

/// A solid of revolution.
pub(crate) struct Solid {
    pub name: String,
    /// The body it moves with; none at rest.
    pub body: Option<String>,
    pub kind: &'static str,
    /// Closed half section: place along the axis and radius, m.
    pub outline: Vec<[f64; 2]>,
    /// From the axis of the machine to its own, m.
    pub at: [f64; 2],
}

/// The machine in section.
pub(crate) struct Section {
    pub solids: Vec<Solid>,
    pub horizontal: bool,
    /// The file gives distances along the axis.
    to_scale: bool,
    /// Places of the reference points of the bodies, m.
    places: Vec<(String, f64)>,
}

fn rectangle(z: (f64, f64), r: (f64, f64)) -> Vec<[f64; 2]> {
    vec![[z.0, r.0], [z.0, r.1], [z.1, r.1], [z.1, r.0]]
}

fn value(system: &System, body: &str, name: &str) -> Option<f64> {
    let i = *system.param(&format!("{body}.{name}"))?.first()?;
    system.params().get(i).copied().filter(|x| *x > 0.0 && x.is_finite())
}

/// Radius and thickness of a rigid disc.
fn disc(system: &System, body: &str) -> (f64, f64) {
    let slot = system.slot(body);
    let mass = slot.and_then(|s| s.part.body()).and_then(|b| b.parameters().mass).and_then(|m| value(system, body, m)).unwrap_or(1.0);
    let volume = mass / STEEL;
    let free = (volume / (FLAT * PI)).cbrt();
    let (polar, across) = (value(system, body, "polar_inertia"), value(system, body, "diametral_inertia"));
    let radius = match (polar, across) {
        (Some(c), _) => (2.0 * c / mass).sqrt(),
        (None, Some(a)) => (4.0 * a / mass).sqrt().min(3.0 * free),
        _ => free,
    };
    let long = across.map(|a| 12.0 * a / mass - 3.0 * radius * radius).filter(|h2| *h2 > 0.0).map(f64::sqrt);
    (radius, long.unwrap_or(volume / (PI * radius * radius)).max(0.05 * radius))
}

impl Section {
    pub fn of(system: &System, blocks: &[Block], horizontal: bool) -> Section {
        let to_scale = Stations::of(system).to_scale;
        let mut out = Section { solids: Vec::new(), horizontal, to_scale, places: places(system, blocks, to_scale) };
        for block in blocks {
            out.rotor(system, block);
        }
        for block in blocks.iter().filter(|_| to_scale) {
            out.spindle(block, blocks);
        }
        let size = out.extent().1.max(0.02);
        for block in blocks {
            out.housing(block, blocks, size);
        }
        for block in blocks {
            out.joint(block, size);
        }
        out
    }

    /// Place along the axis of a point of a body, m.
    pub fn place(&self, body: &str, height: f64) -> f64 {
        self.places.iter().find(|p| p.0 == body).map_or(0.0, |p| p.1) + height
    }

    /// Lowest and highest place, and the largest radius.
    pub fn extent(&self) -> ((f64, f64), f64) {
        let points = || self.solids.iter().flat_map(|s| s.outline.iter().map(move |p| (p[0], p[1] + s.at[0].hypot(s.at[1]))));
        let ends = points().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.0), b.max(p.0)));
        (ends, points().map(|p| p.1).fold(0.0, f64::max))
    }

    /// The largest radius of shafts at a place.
    pub fn radius(&self, z: f64) -> f64 {
        self.widest(z, &["shaft"])
    }

    /// The largest radius of solids of these kinds at a place.
    fn widest(&self, z: f64, kinds: &[&str]) -> f64 {
        let at = |s: &Solid| {
            let edges = s.outline.windows(2).filter(|w| (w[0][0] - z) * (w[1][0] - z) <= 0.0);
            edges
                .map(|w| {
                    let t = if w[1][0] == w[0][0] { 0.5 } else { (z - w[0][0]) / (w[1][0] - w[0][0]) };
                    w[0][1] + t * (w[1][1] - w[0][1])
                })
                .fold(0.0, f64::max)
        };
        self.solids.iter().filter(|s| kinds.contains(&s.kind)).map(at).fold(0.0, f64::max)
    }

    fn rotor(&mut self, system: &System, block: &Block) {
        match block {
            Block::Body { name, flexible: true, profile, axis, .. } => {
                let mut outline = Vec::new();
                for [a, b, from, to] in profile {
                    outline.push([self.place(name, *a), 0.5 * from]);
                    outline.push([self.place(name, *b), 0.5 * to]);
                }
                if let (Some(first), Some(last)) = (outline.first().map(|p| p[0]), outline.last().map(|p| p[0])) {
                    outline.insert(0, [first, 0.0]);
                    outline.push([last, 0.0]);
                    self.solids.push(Solid { name: name.clone(), body: Some(name.clone()), kind: "shaft", outline, at: *axis });
                }
            }
            Block::Body { name, rotor: true, cavity, axis, .. } => {
                let z = self.place(name, 0.0);
                let outline = match cavity {
                    Some((radius, _, height)) => {
                        let (wall, half) = (WALL * radius, 0.5 * height);
                        let (low, high) = (z - half - wall, z + half + wall);
                        let open = OPENING * radius;
                        vec![
                            [low, 0.0],
                            [low, radius + wall],
                            [high, radius + wall],
                            [high, open],
                            [z + half, open],
                            [z + half, *radius],
                            [z - half, *radius],
                            [z - half, 0.0],
                        ]
                    }
                    None => {
                        let (radius, thick) = disc(system, name);
                        rectangle((z - 0.5 * thick, z + 0.5 * thick), (0.0, radius))
                    }
                };
                self.solids.push(Solid { name: name.clone(), body: Some(name.clone()), kind: "disc", outline, at: *axis });
                if let Some((radius, surface, height)) = cavity {
                    let outline = rectangle((z - 0.5 * height, z + 0.5 * height), (*surface, *radius));
                    let kind = "liquid";
                    self.solids.push(Solid { name: format!("{name} {kind}"), body: Some(name.clone()), kind, outline, at: *axis });
                }
            }
            _ => {}
        }
    }

    /// The axis of a rigid body that is held at a distance from its reference point: no file gives its diameter.
    fn spindle(&mut self, block: &Block, blocks: &[Block]) {
        let Block::Body { name, rotor: true, flexible: false, axis, .. } = block else { return };
        let heights = || {
            blocks.iter().flat_map(|b| match b {
                Block::Link { ends, .. } => ends.iter().flatten().filter(|e| e.0 == *name).map(|e| e.1).collect::<Vec<f64>>(),
                _ => Vec::new(),
            })
        };
        let (low, high) = heights().fold((0.0f64, 0.0f64), |(a, b), z| (a.min(z), b.max(z)));
        if low == high {
            return;
        }
        let radius = 0.08 * self.extent().1;
        let outline = rectangle((self.place(name, low) - radius, self.place(name, high) + radius), (0.0, radius));
        self.solids.push(Solid { name: name.clone(), body: Some(name.clone()), kind: "shaft", outline, at: *axis });
    }

    /// What stands still or on springs: where a rotor is joined to it a ring about it, else a block.
    fn housing(&mut self, block: &Block, blocks: &[Block], size: f64) {
        let Block::Body { name, rotor: false, flexible: false, axis, .. } = block else { return };
        let joined = blocks.iter().find_map(|b| match b {
            Block::Link { ends: [Some(a), Some(b)], .. } if b.0 == *name => Some(self.place(&a.0, a.1)),
            Block::Link { ends: [Some(a), Some(b)], .. } if a.0 == *name => Some(self.place(&b.0, b.1)),
            _ => None,
        });
        let own = self.place(name, 0.0);
        let ring = joined.filter(|z| (z - own).abs() < 0.5 * size);
        let outline = match ring {
            Some(z) => {
                let inner = (1.9 * self.radius(z)).max(1.1 * self.widest(z, &["disc"])).max(0.35 * size);
                rectangle((z - 0.12 * size, z + 0.12 * size), (inner, inner + 0.25 * size))
            }
            None => rectangle((own - 0.2 * size, own + 0.2 * size), (0.0, 0.9 * size)),
        };
        self.solids.push(Solid { name: name.clone(), body: Some(name.clone()), kind: "housing", outline, at: *axis });
    }

    /// A bearing about the rotor.
    fn joint(&mut self, block: &Block, size: f64) {
        let Block::Link { name, ends, joint, .. } = block else { return };
        if !joint.elastic {
            return;
        }
        let turning = |e: &(String, f64)| self.solids.iter().any(|s| s.body.as_deref() == Some(&e.0) && matches!(s.kind, "shaft" | "disc"));
        let (own, other) = match ends {
            [Some(a), b] if turning(a) => (a, b),
            [b, Some(a)] if turning(a) => (a, b),
            _ => return,
        };
        // two bodies that turn are joined by a coupling
        if other.as_ref().is_some_and(turning) {
            return;
        }
        let z = self.place(&own.0, own.1);
        let inner = self.radius(z).max(0.12 * size);
        let half = (0.5 * inner).clamp(0.04 * size, 0.12 * size);
        // below a body without a shaft
        let below = self
            .solids
            .iter()
            .find(|s| s.body.as_deref() == Some(&own.0) && s.kind == "disc")
            .map(|s| s.outline.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min));
        let z = match below {
            Some(low) if !self.to_scale => (low - 1.6 * half).min(z),
            _ => z,
        };
        let outline = rectangle((z - half, z + half), (inner, inner + 1.4 * half.max(0.3 * inner)));
        self.solids.push(Solid { name: name.clone(), body: other.as_ref().map(|o| o.0.clone()), kind: "bearing", outline, at: [0.0; 2] });
    }

    pub fn json(&self) -> Json {
        let solids: Vec<Json> = self
            .solids
            .iter()
            .map(|s| json!({ "name": s.name, "body": s.body, "kind": s.kind, "outline": s.outline, "at": s.at }))
            .collect();
        json!({ "axis": if self.horizontal { "horizontal" } else { "vertical" }, "solids": solids })
    }
}

/// Places of the bodies: those of the machine, or one below the other where the file gives no distances.
fn places(system: &System, blocks: &[Block], to_scale: bool) -> Vec<(String, f64)> {
    let bodies = || {
        blocks.iter().filter_map(|b| match b {
            Block::Body { name, rotor, cavity, place, .. } => Some((name, *rotor, cavity, *place)),
            _ => None,
        })
    };
    if to_scale {
        return bodies().map(|b| (b.0.clone(), b.3)).collect();
    }
    let mut sorted: Vec<_> = bodies().collect();
    sorted.sort_by_key(|b| !b.1);
    let half = |name: &str, cavity: &Option<(f64, f64, f64)>| match cavity {
        Some((radius, _, height)) => (0.5 * height + WALL * radius, *radius),
        None => {
            let (radius, thick) = disc(system, name);
            (0.5 * thick, radius)
        }
    };
    let size = sorted.iter().filter(|b| b.1).map(|b| half(b.0, b.2).1).fold(0.0, f64::max).max(0.02);
    let (mut out, mut top) = (Vec::new(), 0.0);
    for (k, (name, rotor, cavity, _)) in sorted.into_iter().enumerate() {
        let own = if rotor { half(name, cavity).0 } else { 0.2 * size };
        let gap = if k == 0 {
            0.0
        } else if rotor {
            0.2 * size
        } else {
            0.45 * size
        };
        let z = if k == 0 { 0.0 } else { top - gap - own };
        top = z - own;
        out.push((name.clone(), z));
    }
    out
}
