//! Orbits and deflected shapes of a linear response at the operating speed and at the largest resonances.

use super::ForcedResponse;
use crate::diagnostic::Diagnostic;
use crate::model::system::{Slot, System};
use crate::outcome::{Arg, Figure, Limit, Message, Picture, Table, TableBuilder, Tiles, View};
use crate::solve::characteristic::Equilibrium;
use crate::solve::extrema::Curve;
use crate::solve::linear_response::{Response, response};
use crate::solve::locate::State;
use crate::solve::pencil::FLAT;
use crate::solve::rest::clearance;
use crate::solve::sectors::circular;
use crate::study::shared::stations::{Point, Stations};
use laval_num::complex::C64;
use serde::{Deserialize, Serialize};

/// Motions of all stations at some speeds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Orbits {
    /// What moves.
    pub stations: Stations,
    /// At each speed.
    pub at: Vec<AtSpeed>,
    /// Responses between those of the curve, where their vectors lie far apart.
    pub between: Vec<Response>,
}

/// Motions at one speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct AtSpeed {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Why this speed.
    pub reason: Reason,
    /// Forward and backward circular amplitudes of every station, m.
    pub motions: Vec<[C64; 2]>,
    /// Motions in the gaps that are open at rest.
    pub gaps: Vec<Gap>,
}

/// Why the motion at a speed is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reason {
    /// The operating speed.
    Operating,
    /// A resonance.
    Resonance,
    /// The speed of the study.
    Chosen,
}

impl Reason {
    fn word(self) -> &'static str {
        match self {
            Reason::Operating => "operating",
            Reason::Resonance => "resonance",
            Reason::Chosen => "chosen",
        }
    }
}

/// Motion in a gap.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Gap {
    /// Name of the part.
    pub part: String,
    /// Forward and backward circular amplitudes of what moves in it, m.
    pub motion: [C64; 2],
    /// Its width where nothing is displaced, m.
    pub width: f64,
    /// Displacement at equilibrium, m.
    pub offset: [f64; 2],
}

/// Resonances shown, at most; two that are nearer than this share are one; points of a machine shown at each speed, at most.
const RESONANCES: usize = 2;
const ONE: f64 = 0.02;
const POINTS: usize = 8;
/// Largest step of a vector over its largest size, least step of the speed over it, and speeds added at most.
const STEP: f64 = 0.09;
const FINEST: f64 = 1e-9;
const MORE: usize = 200;
/// Orbits whose axes differ by less are called circles.
const ROUND: f64 = 5e-3;
/// Share of the largest orbit below which a point does not move.
const STILL: f64 = 1e-9;

/// At the operating speed, where the range holds it, and at the largest resonances.
///
/// # Errors
/// As the state.
pub(super) fn orbits(study: &ForcedResponse, system: &System, state: State, curve: &Curve) -> Result<Orbits, Diagnostic> {
    let (from, to) = (study.speed.from, study.speed.to);
    let operating = system.machine.speed.filter(|w| *w != 0.0 && (from..=to).contains(w));
    let mut speeds: Vec<(f64, Reason)> = operating.map(|w| (w, Reason::Operating)).into_iter().collect();
    if study.speed.is_one() && speeds.is_empty() {
        speeds.push((from, Reason::Chosen));
    }
    let probes = system.probes();
    let mut peaks: Vec<_> = curve.extrema.iter().filter(|e| e.maximum && !e.unbounded && !probes[e.probe].is_tilt()).collect();
    peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
    let most = speeds.len() + RESONANCES;
    for e in peaks {
        let known = speeds.iter().any(|s| s.1 == Reason::Resonance && (s.0 / e.speed - 1.0).abs() <= ONE);
        if !known && speeds.len() < most {
            speeds.push((e.speed, Reason::Resonance));
        }
    }
    speeds.sort_by(|a, b| (a.1 == Reason::Resonance).cmp(&(b.1 == Reason::Resonance)).then(a.0.total_cmp(&b.0)));
    let stations = Stations::of(system);
    let mut at = Vec::new();
    for (speed, reason) in speeds {
        let Some(r) = response(system, state, speed)? else { continue };
        let rest = state(speed)?;
        let gaps = system.slots().iter().filter_map(|s| gap(system, s, &rest, &r.x)).collect();
        at.push(AtSpeed { speed, reason, motions: stations.motion(&r.x), gaps });
    }
    let between = between(system, state, curve)?;
    Ok(Orbits { stations, at, between })
}

/// Halves the steps of a curve until the vectors of all bodies are near those before, so that a loop of a polar diagram is round.
fn between(system: &System, state: State, curve: &Curve) -> Result<Vec<Response>, Diagnostic> {
    let bodies: Vec<_> = system.probes().iter().filter(|p| p.is_reference()).collect();
    let vectors = |r: &Response| bodies.iter().map(|p| r.circles_of(p).0).collect::<Vec<C64>>();
    let mut known: Vec<(f64, Vec<C64>)> = curve.points.iter().map(|r| (r.speed, vectors(r))).collect();
    known.retain(|k| k.1.iter().all(|z| z.is_finite()));
    let sizes: Vec<f64> = (0..bodies.len()).map(|b| known.iter().map(|k| k.1[b].abs()).fold(0.0, f64::max)).collect();
    let far = |a: &[C64], b: &[C64]| (0..bodies.len()).any(|k| (a[k] - b[k]).abs() > STEP * sizes[k]);
    let mut out: Vec<Response> = Vec::new();
    if known.len() < 3 || !curve.poles().is_empty() {
        return Ok(out);
    }
    let mut k = 0;
    while k + 1 < known.len() && out.len() < MORE {
        let (a, b) = (known[k].0, known[k + 1].0);
        let middle = 0.5 * (a + b);
        if !far(&known[k].1, &known[k + 1].1) || (b - a) <= FINEST * b.abs() {
            k += 1;
            continue;
        }
        let Some(r) = response(system, state, middle)? else {
            k += 1;
            continue;
        };
        known.insert(k + 1, (middle, vectors(&r)));
        out.push(r);
    }
    Ok(out)
}

/// The motion in the gap of a part, where that is open at rest.
fn gap(system: &System, slot: &Slot, rest: &Equilibrium, x: &[C64]) -> Option<Gap> {
    clearance(system, slot, rest).filter(|gap| *gap > 0.0)?;
    let centred = Equilibrium { q: vec![0.0; rest.q.len()], ..rest.clone() };
    let width = clearance(system, slot, &centred).filter(|gap| *gap > 0.0)?;
    let [across, up] = [slot.map.first()?, slot.map.get(1)?];
    let along = |rows: &[(usize, f64)]| rows.iter().fold(C64::zero(), |s, &(g, f)| s + x[g].scale(f));
    let held = |rows: &[(usize, f64)]| rows.iter().map(|&(g, f)| f * rest.q[g]).sum::<f64>();
    let (f, b) = circular(along(across), along(up));
    Some(Gap { part: slot.name.clone(), motion: [f, b], width, offset: [held(across), held(up)] })
}

impl Orbits {
    /// Stations with an orbit of their own.
    fn shown(&self) -> Vec<usize> {
        let moves = |k: &usize| {
            let size = |m: &[C64; 2]| m[0].abs() + m[1].abs();
            self.at.iter().any(|a| size(&a.motions[*k]) > STILL * a.motions.iter().map(size).fold(0.0, f64::max))
        };
        (0..self.stations.all.len()).filter(|&k| self.stations.all[k].named).filter(moves).collect()
    }

    /// All motions: pictures of orbits count points, those of shapes count speeds. Motions in gaps belong to no shape.
    pub(super) fn table(&self) -> TableBuilder {
        let n = self.stations.all.len();
        let mut all = self.stations.clone();
        // gaps as stations of their own, behind the others
        let gaps = self.at.first().map_or(0, |a| a.gaps.len());
        let named = self.at.iter().flat_map(|a| &a.gaps).take(gaps);
        all.all.extend(named.map(|g| Point {
            body: g.part.clone(),
            height: 0.0,
            place: 0.0,
            axis: [0.0; 2],
            mark: 0.0,
            line: n,
            named: true,
            rows: Default::default(),
        }));
        let whole: Vec<Vec<[C64; 2]>> = self
            .at
            .iter()
            .map(|a| {
                let open = |k: usize| a.gaps.get(k).map_or([C64::zero(); 2], |g| g.motion);
                a.motions.iter().copied().chain((0..gaps).map(open)).collect()
            })
            .collect();
        let motions: Vec<&[[C64; 2]]> = whole.iter().map(Vec::as_slice).collect();
        let rows = n + gaps;
        let numbers =
            |f: &dyn Fn(usize, usize) -> i64| (0..self.at.len()).flat_map(|i| (0..rows).map(move |k| f(i, k))).collect::<Vec<i64>>();
        let speeds = self.at.iter().flat_map(|a| std::iter::repeat_n(a.speed, rows)).collect();
        let table = Table::new("orbits", "Motion of all points at the speeds of the figures")
            .float("speed", "rad/s", "spin speed", speeds)
            .int("orbit", "", "number of the orbit", numbers(&|i, k| (i * rows + k) as i64 + 1))
            .int("shape", "", "number of the shape; 0 of a motion in a gap", numbers(&|i, k| if k < n { i as i64 + 1 } else { 0 }));
        all.columns(table, &motions, "m")
    }

    /// Orbits side by side, by speed.
    pub(super) fn orbit_figure(&self, system: &System) -> Figure {
        let (rows, shown) = (self.stations.all.len() + self.at.first().map_or(0, |a| a.gaps.len()), self.shown());
        let mut pictures = Vec::new();
        for (i, a) in self.at.iter().enumerate() {
            let picture = |k: usize, title: Arg, motion: &[C64; 2], circle: Option<Limit>| {
                let [f, b] = [motion[0].abs(), motion[1].abs()];
                let straight = (f - b).abs() <= FLAT * f.max(b);
                let whirl = match (straight, (f > b) != self.stations.reversed(system, k)) {
                    (true, _) => Message::new("tiles-straight"),
                    (false, true) => Message::new("page-whirl").arg("whirl", Arg::word("forward")),
                    (false, false) => Message::new("page-whirl").arg("whirl", Arg::word("backward")),
                };
                let size = |x: f64| Arg::quantity(x, "m");
                let axes = if f.min(b) <= ROUND * f.max(b) {
                    Message::new("tiles-circle").arg("radius", size(f + b))
                } else {
                    Message::new("tiles-axes").arg("major", size(f + b)).arg("minor", size((f - b).abs()))
                };
                let number = (i * rows + k) as i64 + 1;
                Picture { number, title, lines: vec![at(a).into(), axes.into(), whirl.into()], circle, unstable: false }
            };
            for &k in shown.iter().take(POINTS) {
                pictures.push(picture(k, label(system, &self.stations.all[k]), &a.motions[k], None));
            }
            for (g, gap) in a.gaps.iter().enumerate() {
                let circle = Limit { radius: gap.width, centre: gap.offset.map(|x| -x) };
                pictures.push(picture(self.stations.all.len() + g, Arg::name(&gap.part), &gap.motion, Some(circle)));
            }
        }
        let mut notes = vec![Message::new("tiles-own-scale").into()];
        if shown.len() > POINTS {
            notes.push(Message::new("tiles-more-points").arg("points", Arg::count(shown.len() - POINTS)).into());
        }
        let mark = Message::new("tiles-mark").into();
        let tiles = Tiles { table: "orbits".into(), picture: "orbit".into(), view: View::Orbits, pictures, mark, notes };
        let alt = Message::new("orbits-alt").arg("orbits", Arg::count(tiles.pictures.len())).arg("speeds", Arg::count(self.at.len()));
        Figure::new("orbits", "Orbits", alt).tiles(tiles)
    }

    /// The shape of the deflected machine at every speed; of a single point there is none.
    pub(super) fn shape_figure(&self, system: &System) -> Option<Figure> {
        if !self.stations.have_shape() {
            return None;
        }
        let size = |m: &[C64; 2]| m[0].abs() + m[1].abs();
        let picture = |(i, a): (usize, &AtSpeed)| {
            let named = self.stations.all.iter().zip(&a.motions).filter(|s| s.0.named);
            let most = named.max_by(|x, y| size(x.1).total_cmp(&size(y.1)));
            let largest = most.map(|(s, m)| {
                let message = Message::new("tiles-largest").arg("point", label(system, s));
                message.arg("amplitude", Arg::quantity(size(m), "m")).into()
            });
            let title = Arg::speed(a.speed);
            let reason = Message::new("tiles-reason").arg("reason", Arg::word(a.reason.word()));
            let lines = std::iter::once(reason.into()).chain(largest).collect();
            Picture { number: i as i64 + 1, title, lines, circle: None, unstable: false }
        };
        let pictures: Vec<Picture> = self.at.iter().enumerate().map(picture).collect();
        let view = View::Shapes { horizontal: Stations::horizontal(system), to_scale: self.stations.to_scale };
        let alt = Message::new("deflected-alt").arg("speeds", Arg::count(pictures.len()));
        let notes = vec![Message::new("tiles-own-scale").into()];
        let mark = Message::new("tiles-mark").into();
        let tiles = Tiles { table: "orbits".into(), picture: "shape".into(), view, pictures, mark, notes };
        Some(Figure::new("deflected", "Deflected shapes", alt).tiles(tiles))
    }
}

/// The speed with what is special about it.
fn at(a: &AtSpeed) -> Message {
    Message::new("tiles-at").arg("speed", Arg::speed(a.speed)).arg("reason", Arg::word(a.reason.word()))
}

/// The body, or the point of it.
fn label(system: &System, station: &Point) -> Arg {
    let probe = system.probes().iter().find(|p| p.name == station.body && p.is_at(station.height));
    probe.map_or_else(|| Arg::name(&station.body), crate::study::shared::probes::label)
}
