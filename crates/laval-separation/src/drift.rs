//! Drag-dominated motion where no closed form exists: variable speed, and drag beyond Stokes' law.
//!
//! Equations, F the acceleration that drives a particle relative to the liquid:
//!
//! ```text
//! r' = s F/f(Re)          Re f(Re) = Re of Stokes' velocity |s F|          F = g - a_e with the tilt of equilibrium at the speed of the moment
//! disc stack: throughput that just lifts a particle across all gaps   N int 2 pi r v(r) dr/tan th,   v(r) its velocity in the field w^2 r
//! ```
//!
//! Runge-Kutta steps of order 4, each shorter than a fiftieth of the width of the vessel; the exit is solved
//! for within its step. At the jump of the drag law (Re = 1000) the velocity stays constant until the field
//! has grown by the 0.4 % of the jump.
//!
//! Symbols: s sedimentation coefficient; a_e acceleration of the frame ([`super::frame`]).
//!
//! Validity: drag rate n far above the spin speed: the time is off by about (w/n)^2, the place by w/n; the cup follows its equilibrium.
//!
//! Sources: `docs/theory/separation.md#drag-dominated-limit`, `docs/theory/separation.md#run-up`.

use super::closed::Steady;
use super::cup::SwingingCup;
use super::exit::{Cylinder, Exit, MOST, Vessel};
use super::particle::{Drag, Medium, Particle, TURBULENT, transitional, turbulent};
use super::ramp::Ramp;
use super::separator::Discs;
use super::series::{Affine, Reach, Series};
use super::vessel::Inside;
use laval_num::univariate::root_by_newton;
use std::f64::consts::PI;

/// How fast a particle settles in a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settling {
    sedimentation: f64,
    /// Reynolds number over the velocity, s/m; 0 with Stokes' law.
    per_speed: f64,
}

impl Settling {
    /// Of one particle.
    pub fn new(medium: &Medium, particle: &Particle) -> Self {
        let per_speed = match medium.drag {
            Drag::Stokes => 0.0,
            Drag::SchillerNaumann => medium.reynolds(particle, 1.0),
        };
        Settling { sedimentation: medium.rates(particle).sedimentation, per_speed }
    }

    /// Velocity over the driving acceleration of this size (m/s^2), s.
    pub fn mobility(&self, acceleration: f64) -> f64 {
        let stokes = self.per_speed * (self.sedimentation * acceleration).abs();
        if stokes > 0.0 { self.sedimentation * reynolds(stokes) / stokes } else { self.sedimentation }
    }

    fn velocity(&self, f: [f64; 3]) -> [f64; 3] {
        let m = if self.per_speed > 0.0 { self.mobility((f[0] * f[0] + f[1] * f[1] + f[2] * f[2]).sqrt()) } else { self.sedimentation };
        [m * f[0], m * f[1], m * f[2]]
    }
}

/// Reynolds number of a particle whose velocity by Stokes' law has the Reynolds number `stokes`: the root of Re f(Re) = stokes.
pub fn reynolds(stokes: f64) -> f64 {
    if stokes >= TURBULENT * turbulent::<f64>(TURBULENT) {
        return (stokes * 24.0 / 0.44).sqrt();
    }
    if stokes >= TURBULENT * transitional::<f64>(TURBULENT) {
        return TURBULENT;
    }
    // Re f(Re) is convex and rises: Newton from above converges from above
    let mut re = stokes;
    for _ in 0..50 {
        let power = 0.15 * re.powf(0.687);
        let step = (re * (1.0 + power) - stokes) / (1.0 + 1.687 * power);
        re -= step;
        // NaN ends here
        if !(step.abs() > 1e-15 * re) {
            break;
        }
    }
    re
}

/// The driving acceleration at one moment, linear in the place.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Field {
    w2: f64,
    accel: f64,
    sin: f64,
    cos: f64,
    hinge: f64,
    gravity: f64,
}

impl Field {
    fn new((speed, accel): (f64, f64), tilt: f64, hinge: f64, gravity: f64) -> Self {
        let (sin, cos) = tilt.sin_cos();
        Field { w2: speed * speed, accel, sin, cos, hinge, gravity }
    }

    #[inline]
    fn at(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let radius = self.hinge + self.cos * x + self.sin * y;
        let out = self.w2 * radius + self.accel * z;
        [self.cos * out - self.gravity * self.sin, self.sin * out + self.gravity * self.cos, self.w2 * z - self.accel * radius]
    }

    fn tilt(&self) -> f64 {
        self.sin.atan2(self.cos)
    }

    /// The largest of fields in a cup, towards each of its surfaces. Linear in the place, they are largest in a corner of the box around the liquid.
    fn most(fields: &Fields, vessel: &Cylinder) -> Reach {
        let mut most = Reach::default();
        for f in fields {
            for corner in 0..8 {
                let sign = |bit: usize| if corner >> bit & 1 == 1 { vessel.radius } else { -vessel.radius };
                let [x, y, z] = f.at([sign(0), if corner >> 2 == 1 { vessel.bottom } else { vessel.top }, sign(1)]);
                most.side = most.side.max(x.hypot(z));
                most.bottom = most.bottom.max(y);
                most.surface = most.surface.max(-y);
            }
        }
        Reach { side: ROOM * most.side, bottom: ROOM * most.bottom, surface: ROOM * most.surface }
    }

    /// The same as a matrix and what it adds.
    fn matrix(&self) -> Affine {
        let (s, c, w2, a) = (self.sin, self.cos, self.w2, self.accel);
        let out = [w2 * c, w2 * s, a, w2 * self.hinge];
        let (mut x, mut y) = (out.map(|o| c * o), out.map(|o| s * o));
        x[3] -= self.gravity * s;
        y[3] += self.gravity * c;
        [x, y, [-a * c, -a * s, w2, -a * self.hinge]]
    }
}

/// The fields at the begin, the middle and the end of a step.
type Fields = [Field; 3];

fn shifted(r: [f64; 3], v: [f64; 3], h: f64) -> [f64; 3] {
    [r[0] + h * v[0], r[1] + h * v[1], r[2] + h * v[2]]
}

fn step(s: &Settling, fields: &Fields, r: [f64; 3], h: f64) -> [f64; 3] {
    let k1 = s.velocity(fields[0].at(r));
    let k2 = s.velocity(fields[1].at(shifted(r, k1, 0.5 * h)));
    let k3 = s.velocity(fields[1].at(shifted(r, k2, 0.5 * h)));
    let k4 = s.velocity(fields[2].at(shifted(r, k3, h)));
    std::array::from_fn(|i| r[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
}

/// A particle under way, or its exit.
enum Way {
    Inside([f64; 3]),
    Left(Exit),
}

/// A step that stays in the liquid: the place at its end; `None` when a surface is passed.
#[inline]
fn free(s: &Settling, fields: &Fields, inside: &Inside, r: [f64; 3], h: f64) -> Option<[f64; 3]> {
    let next = step(s, fields, r, h);
    // NaN fails
    inside.gaps(next, [0.0; 3]).iter().all(|g| g.value >= 0.0).then_some(next)
}

/// One step of duration `h` from `t`; `fields(share)` are those of the part of the step up to `share`.
fn advance(s: &Settling, fields: &dyn Fn(f64) -> Fields, inside: &Inside, t: f64, r: [f64; 3], h: f64) -> Option<Way> {
    let whole = fields(1.0);
    let next = step(s, &whole, r, h);
    let v = s.velocity(whole[2].at(next));
    let gaps = inside.gaps(next, v);
    if gaps.iter().any(|g| g.value.is_nan()) {
        return None;
    }
    let part = |share: f64| {
        let f = fields(share);
        let x = step(s, &f, r, share * h);
        let v = s.velocity(f[2].at(x));
        (x, v)
    };
    let found = (0..MOST).filter(|&i| gaps[i].value < 0.0).filter_map(|i| {
        let gap = |share: f64| {
            let (x, v) = part(share);
            let g = inside.gaps(x, v)[i];
            (g.value, g.rate * h)
        };
        // a particle that is outside at the begin has left there
        let share = if gap(0.0).0 <= 0.0 { 0.0 } else { root_by_newton(gap, 0.0, 1.0)? };
        Some((share, i))
    });
    match found.min_by(|a, b| a.0.total_cmp(&b.0)) {
        None => Some(Way::Inside(next)),
        Some((share, i)) => {
            let (position, velocity) = part(share);
            Some(Way::Left(Exit { time: t + share * h, surface: gaps[i].surface, position, velocity }))
        }
    }
}

/// Largest way of a step over the width of the vessel.
const WAY: f64 = 0.02;
/// Most steps of one particle at a held speed.
const MOST_STEPS: usize = 20_000;

/// Who looks at the places on the way.
pub trait Seen {
    /// At a time, s, and a place, m.
    fn at(&mut self, t: f64, place: [f64; 3]);
}

impl Seen for () {
    fn at(&mut self, _: f64, _: [f64; 3]) {}
}

impl Seen for Vec<(f64, [f64; 3])> {
    fn at(&mut self, t: f64, place: [f64; 3]) {
        self.push((t, place));
    }
}

/// Settling at a held speed from `start` at the time `t`.
fn held(s: &Settling, steady: &Steady, inside: &Inside, start: [f64; 3], mut t: f64, seen: &mut impl Seen) -> Option<Exit> {
    let field = Field::new((steady.speed, 0.0), steady.tilt, steady.hinge, steady.gravity);
    let fields = |_: f64| [field; 3];
    let mut r = start;
    for _ in 0..MOST_STEPS {
        seen.at(t, r);
        let v = s.velocity(field.at(r));
        let h = WAY * inside.width() / (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        // nothing moves; NaN ends here
        if !(h < 1e15) {
            return None;
        }
        match advance(s, &fields, inside, t, r, h)? {
            Way::Inside(next) => (r, t) = (next, t + h),
            Way::Left(exit) => return Some(exit),
        }
    }
    None
}

/// First exit at constant speed by the drag law of the medium; with Stokes' law that of [`super::separator::Turning::drift`].
pub fn settle(medium: &Medium, particle: &Particle, steady: &Steady, inside: &Inside, start: [f64; 3]) -> Option<Exit> {
    follow(medium, particle, steady, inside, start, &mut ())
}

/// Velocity at a held speed where drag balances the field, m/s.
pub fn velocity(medium: &Medium, particle: &Particle, steady: &Steady, place: [f64; 3]) -> [f64; 3] {
    let field = Field::new((steady.speed, 0.0), steady.tilt, steady.hinge, steady.gravity);
    Settling::new(medium, particle).velocity(field.at(place))
}

/// As [`settle`], with a look at every step.
pub fn follow(
    medium: &Medium,
    particle: &Particle,
    steady: &Steady,
    inside: &Inside,
    start: [f64; 3],
    seen: &mut impl Seen,
) -> Option<Exit> {
    held(&Settling::new(medium, particle), steady, inside, start, 0.0, seen)
}

/// Residence time after which a particle that enters a disc stack at the share `entry` of a gap is caught, s.
pub fn lifted(medium: &Medium, particle: &Particle, discs: &Discs, speed: f64, entry: f64, volume: f64) -> Option<f64> {
    const CELLS: usize = 64;
    let s = Settling::new(medium, particle);
    let (from, width) = (discs.inner, (discs.outer - discs.inner) / CELLS as f64);
    // Gauss with two points in each cell
    let sum: f64 = (0..CELLS)
        .flat_map(|k| [-1.0, 1.0].map(|e| from + width * (k as f64 + 0.5 + 0.5 * e / 3f64.sqrt())))
        .map(|r| {
            let a = speed * speed * r;
            r * s.mobility(a) * a
        })
        .sum();
    let throughput = (discs.gaps * 2.0 * PI * sum * 0.5 * width / discs.angle.tan()).abs();
    let time = entry * volume / throughput;
    time.is_finite().then_some(time)
}

/// A run-up of swinging cups with the tilts of equilibrium on the way, for many particles.
#[derive(Clone, Debug)]
pub struct Climb {
    cells: Vec<Cell>,
    series: Series,
    ramp: Ramp,
    hinge: f64,
    gravity: f64,
    /// After the run-up.
    steady: Steady,
}

#[derive(Clone, Debug)]
struct Cell {
    from: f64,
    step: f64,
    /// At the begin, the middle and the end.
    tilts: [f64; 3],
    fields: Fields,
}

/// Cells of a run-up from rest, and between two knots of a table.
const CELLS: usize = 64;
const TABLE_CELLS: usize = 32;
/// Allowance for changes of the field between the begin, the middle and the end of a cell.
const ROOM: f64 = 1.1;

impl Climb {
    /// The way of a cup; `held` is a tilt it is held at.
    pub fn new(cup: &SwingingCup, held: Option<f64>, ramp: &Ramp, vessel: &Cylinder) -> Self {
        let tilt = |t: f64| held.unwrap_or_else(|| cup.equilibrium(ramp.at(t).0));
        let duration = ramp.duration();
        let mut edges = vec![0.0];
        match ramp {
            Ramp::Table(_) => {
                for knot in ramp.knots().filter(|k| *k > 0.0) {
                    let from = edges[edges.len() - 1];
                    edges.extend((1..=TABLE_CELLS).map(|k| from + (knot - from) * k as f64 / TABLE_CELLS as f64));
                }
            }
            // most of the tilt happens early
            _ => edges.extend((1..=CELLS).map(|k| duration * (k as f64 / CELLS as f64).powf(1.5))),
        }
        let mut cells: Vec<Cell> = Vec::new();
        for e in edges.windows(2).filter(|e| e[1] > e[0]) {
            let times = [e[0], 0.5 * (e[0] + e[1]), e[1]];
            let first = cells.last().map_or_else(|| tilt(times[0]), |c| c.tilts[2]);
            let tilts = [first, tilt(times[1]), tilt(times[2])];
            let fields = std::array::from_fn(|i| Field::new(ramp.at(times[i]), tilts[i], cup.hinge, cup.gravity));
            cells.push(Cell { from: e[0], step: e[1] - e[0], tilts, fields });
        }
        let speed = ramp.final_speed();
        let settled = held.unwrap_or_else(|| cup.equilibrium(speed));
        let steady = Steady { speed, tilt: settled, hinge: cup.hinge, gravity: cup.gravity };
        let series = Series::new(cells.iter().map(|c| {
            let norm = c.fields.iter().map(|f| f.w2 + f.accel.abs()).fold(0.0, f64::max);
            (c.step, c.fields.map(|f| f.matrix()), norm, Field::most(&c.fields, vessel))
        }));
        Climb { cells, series, ramp: ramp.clone(), hinge: cup.hinge, gravity: cup.gravity, steady }
    }

    /// The field within a cell, its tilt by the parabola through the three that are known.
    fn between(&self, c: &Cell, u: f64) -> Field {
        let [a, m, b] = c.tilts;
        let tilt = a + u * (4.0 * m - 3.0 * a - b + u * 2.0 * (a - 2.0 * m + b));
        Field::new(self.ramp.at(c.from + u * c.step), tilt, self.hinge, self.gravity)
    }

    /// Tilt at a time, rad.
    pub fn tilt(&self, t: f64) -> f64 {
        let k = self.cells.partition_point(|c| c.from + c.step < t);
        self.cells.get(k).map_or(self.steady.tilt, |c| self.between(c, ((t - c.from) / c.step).max(0.0)).tilt())
    }

    /// First exit of a particle released at rest at t = 0; `after` finds it at the held speed, from a place and a velocity.
    pub fn settle(
        &self,
        medium: &Medium,
        particle: &Particle,
        inside: &Inside,
        start: [f64; 3],
        after: impl FnOnce([f64; 3], [f64; 3]) -> Option<Exit>,
    ) -> Option<Exit> {
        let s = Settling::new(medium, particle);
        if medium.drag == Drag::Stokes
            && let Some(r) = self.series.end(s.sedimentation, start, &inside.clear(start))
        {
            return self.held(&s, inside, r, after, &mut ());
        }
        self.follow(medium, particle, inside, start, after, &mut ())
    }

    /// The same, step by step through the run-up (and beyond it where no closed form holds), with a look at each.
    pub fn follow(
        &self,
        medium: &Medium,
        particle: &Particle,
        inside: &Inside,
        start: [f64; 3],
        after: impl FnOnce([f64; 3], [f64; 3]) -> Option<Exit>,
        seen: &mut impl Seen,
    ) -> Option<Exit> {
        let s = Settling::new(medium, particle);
        let mut r = start;
        let way = WAY * inside.width();
        for c in &self.cells {
            seen.at(c.from, r);
            let v = s.velocity(c.fields[2].at(r));
            let parts = ((v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt() * c.step / way).ceil().clamp(1.0, 4096.0);
            if parts == 1.0
                && let Some(next) = free(&s, &c.fields, inside, r, c.step)
            {
                r = next;
                continue;
            }
            let mut k = 0.0;
            while k < parts {
                let (from, width) = (k / parts, 1.0 / parts);
                let fields = |share: f64| {
                    if parts == 1.0 && share == 1.0 { c.fields } else { [0.0, 0.5, 1.0].map(|u| self.between(c, from + u * share * width)) }
                };
                match advance(&s, &fields, inside, c.from + from * c.step, r, c.step * width)? {
                    Way::Inside(next) => r = next,
                    Way::Left(exit) => return Some(exit),
                }
                k += 1.0;
            }
        }
        self.held(&s, inside, r, after, seen)
    }

    /// After the run-up.
    fn held(
        &self,
        s: &Settling,
        inside: &Inside,
        r: [f64; 3],
        after: impl FnOnce([f64; 3], [f64; 3]) -> Option<Exit>,
        seen: &mut impl Seen,
    ) -> Option<Exit> {
        let t = self.ramp.duration();
        if s.per_speed > 0.0 {
            return held(s, &self.steady, inside, r, t, seen);
        }
        let f = Field::new((self.steady.speed, 0.0), self.steady.tilt, self.hinge, self.gravity).at(r);
        after(r, s.velocity(f)).map(|e| Exit { time: e.time + t, ..e })
    }

    /// Velocity at a time and a place, m/s.
    pub fn velocity(&self, medium: &Medium, particle: &Particle, t: f64, place: [f64; 3]) -> [f64; 3] {
        let field = Field::new(self.ramp.at(t), self.tilt(t), self.hinge, self.gravity);
        Settling::new(medium, particle).velocity(field.at(place))
    }

    /// The held state after the run-up.
    pub fn steady(&self) -> Steady {
        self.steady
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cup::Hanging;
    use crate::exit::Cylinder;
    use crate::separator::{Bowl, Cup, Separator};

    #[test]
    fn the_reynolds_number_is_inverted() {
        for re in [1e-9f64, 0.1, 5.0, 300.0, 999.0] {
            let back = reynolds(re * transitional::<f64>(re));
            assert!((back / re - 1.0).abs() < 1e-13, "{re} {back}");
        }
        for re in [1001.0f64, 1e5] {
            assert!((reynolds(re * turbulent::<f64>(re)) / re - 1.0).abs() < 1e-13);
        }
        let gap = 0.5 * TURBULENT * (transitional::<f64>(TURBULENT) + turbulent::<f64>(TURBULENT));
        assert_eq!(reynolds(gap), TURBULENT);
    }

    /// With Stokes' law the steps give the closed form without inertia, in every vessel.
    #[test]
    fn steps_meet_the_closed_form() {
        let cup = Cup {
            hanging: SwingingCup { hinge: 0.08, body: Hanging::point(1.0, 0.06), damping: 0.0, gravity: 9.80665 },
            vessel: Cylinder { radius: 0.014, bottom: 0.1, top: 0.0 },
            held: None,
        };
        let tube = super::super::tube::Tube { mouth: 0.045, angle: 0.5, radius: 0.012, length: 0.09, surface: 0.02 };
        let bowl = Bowl { length: 0.5, radius: 0.1, surface: 0.05 };
        let medium = Medium::new(998.2, 1e-3);
        for separator in [Separator::Cup(cup), Separator::Tube(tube, 9.80665), Separator::Bowl(bowl)] {
            let turning = separator.at(100.0);
            let (steady, inside) = (turning.steady().unwrap(), turning.inside().unwrap());
            for density in [2650.0, 900.0] {
                let p = Particle { radius: 5e-6, density };
                for point in (1..20).map(crate::halton::point) {
                    let Some(start) = turning.start(&point) else { continue };
                    let a = settle(&medium, &p, &steady, inside, start).unwrap();
                    let b = turning.drift(medium.rates(&p).sedimentation, start).unwrap();
                    assert!((a.time / b.time - 1.0).abs() < 1e-8 && a.surface == b.surface, "{} {a:?} {b:?}", separator.word());
                }
            }
        }
    }

    /// Horizontal, without gravity, on the axis: the run-up counts for its integral of w^2.
    #[test]
    fn the_run_up_counts_for_its_integral() {
        let cup = SwingingCup { hinge: 0.1, body: Hanging::point(1.0, 0.06), damping: 0.0, gravity: 0.0 };
        let inside = Inside::Cup(Cylinder { radius: 0.5, bottom: 0.2, top: 0.0 });
        let (medium, p) = (Medium { gravity: 0.0, ..Medium::new(1000.0, 1e-3) }, Particle { radius: 1e-6, density: 2000.0 });
        let s = medium.rates(&p).sedimentation;
        let w: f64 = 300.0;
        for ramp in [Ramp::Linear(w, 20.0), Ramp::Smooth(w, 20.0)] {
            let vessel = Cylinder { radius: 0.5, bottom: 0.2, top: 0.0 };
            let climb = Climb::new(&cup, Some(0.5 * PI), &ramp, &vessel);
            let steady = climb.steady();
            let exit = climb.settle(&medium, &p, &inside, [0.0, 0.05, 0.0], |r, _| settle(&medium, &p, &steady, &inside, r)).unwrap();
            let want = (0.3f64 / 0.15).ln() / (s * w * w) + 20.0 - ramp.equivalent();
            // Euler's acceleration turns the path out of the plane a little
            assert!((exit.time / want - 1.0).abs() < 1e-6, "{ramp:?} {} {want}", exit.time);
        }
    }

    /// The series in the sedimentation coefficient, taken for all but places near a surface, gives what the steps give: exactly where both take the
    /// same steps, else (fast particles divide theirs) to the error of a step, a few millionths of the way.
    #[test]
    fn the_series_is_the_steps() {
        let cup = SwingingCup { hinge: 0.2, body: Hanging::point(2.6, 0.17), damping: 0.0, gravity: 9.80665 };
        let vessel = Cylinder { radius: 0.045, bottom: 0.3, top: 0.02 };
        let (inside, medium) = (Inside::Cup(vessel), Medium::new(870.0, 15e-3));
        let mut taken = 0;
        for ramp in [Ramp::Linear(120.0, 27.0), Ramp::Smooth(-120.0, 27.0)] {
            let climb = Climb::new(&cup, None, &ramp, &vessel);
            let reached = |r: [f64; 3], _: [f64; 3]| {
                Some(Exit { time: 0.0, surface: super::super::exit::Surface::Bottom, position: r, velocity: [0.0; 3] })
            };
            for density in [2650.0, 400.0] {
                for (i, d) in [2e-6, 5e-6, 10e-6].into_iter().enumerate() {
                    let p = Particle { radius: 0.5 * d, density };
                    let s = medium.rates(&p).sedimentation;
                    for start in [[0.0, 0.15, 0.0], [0.01, 0.1, -0.02], [-0.02, 0.2, 0.015]] {
                        let Some(a) = climb.series.end(s, start, &inside.clear(start)) else { continue };
                        taken += 1;
                        let b = climb.follow(&medium, &p, &inside, start, reached, &mut ()).unwrap().position;
                        let way = (0..3).map(|k| (b[k] - start[k]).powi(2)).sum::<f64>().sqrt();
                        assert!(way > 1e-5 * (1 + i) as f64, "{way:e}");
                        for k in 0..3 {
                            let error = if i == 0 { 1e-8 } else { 1e-5 };
                            assert!((a[k] - b[k]).abs() < error * way, "{d:e} {start:?}: {a:?} {b:?}");
                        }
                    }
                }
            }
        }
        assert!(taken > 20, "{taken}");
    }
}
