//! Recovery of a powder over time, and the time for a required recovery, as smooth functions instead of
//! counts of particles.
//!
//! Equations: for N places of the fixed set, with `d_i(t)` the smallest diameter that leaves from the place i by the time t,
//!
//! ```text
//! eta(t) = (1/N) sum_i P(size >= d_i(t))          t_q: the smallest t with eta(t) >= q
//! ```
//!
//! The sum over sizes is exact; only the places are sampled. Without inertia `d_i^2 = const tau_i/t`, which is the first estimate; then the exits of particles
//! of just those diameters are computed, `ln T` is joined straight over `ln d`, and so on until t_q no longer changes. Of many places a part comes first, and what
//! inertia and run-up delay it by on the average is the first estimate of the rest. Powders of single sizes or classes are
//! counted: place by place, class by class. All of them (q = 1) are caught with the last one, wherever it starts ([`super::slowest`]): no set of places holds it.
//!
//! Validity: larger particles leave no later than smaller ones of the same start and density.
//!
//! Sources: `docs/theory/separation.md#ensembles-and-recovery`.

use super::batch::Spinning;
use super::exit::{Exit, Surface};
use super::law::Law;
use super::motion::Lost;
use super::particle::Particle;
use super::ramp::Ramp;
use super::slowest::Last;
use super::suspension::quantile;
use laval_model::text;
use laval_num::order::SortByNumber;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Time counted as the field works: during a run-up less than at full speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Clock {
    /// Times and counted times, s, joined straight; empty: both are equal.
    points: Vec<(f64, f64)>,
}

impl Clock {
    /// Every second counts.
    pub fn plain() -> Self {
        Clock { points: vec![] }
    }

    /// By the field (centrifugal and gravity) at a radius, over the field at the speed that is held.
    pub fn new(ramp: &Ramp, radius: f64, gravity: f64) -> Self {
        const CELLS: usize = 400;
        let field = |t: f64| (ramp.at(t).0.powi(2) * radius).hypot(gravity);
        let (duration, full) = (ramp.duration(), (ramp.final_speed().powi(2) * radius).hypot(gravity));
        let h = duration / CELLS as f64;
        let mut points = vec![(0.0, 0.0)];
        let mut sum = 0.0;
        for k in 0..CELLS {
            let t = h * k as f64;
            sum += h / 6.0 * (field(t) + 4.0 * field(t + 0.5 * h) + field(t + h)) / full;
            points.push((t + h, sum));
        }
        // a field that vanishes throughout counts nothing
        if points.windows(2).all(|w| w[1].1 > w[0].1 && w[1].0 > w[0].0) { Clock { points } } else { Clock::plain() }
    }

    /// Counted time at a time, s.
    pub fn counted(&self, t: f64) -> f64 {
        Self::map(&self.points, t, |p| p.0, |p| p.1)
    }
    /// Time of a counted time, s.
    pub fn time(&self, counted: f64) -> f64 {
        Self::map(&self.points, counted, |p| p.1, |p| p.0)
    }

    fn map(points: &[(f64, f64)], x: f64, from: impl Fn(&(f64, f64)) -> f64, to: impl Fn(&(f64, f64)) -> f64) -> f64 {
        let k = points.partition_point(|p| from(p) < x);
        match (k.checked_sub(1).and_then(|i| points.get(i)), points.get(k)) {
            (Some(a), Some(b)) => to(a) + (to(b) - to(a)) * (x - from(a)) / (from(b) - from(a)),
            (Some(last), None) => to(last) + (x - from(last)),
            _ => x,
        }
    }
}

/// Time of exit over size for one place and density, in logarithms.
#[derive(Clone, Debug)]
struct Curve {
    density: f64,
    /// ln of the product of sedimentation coefficient and counted time without inertia; `None`: never leaves.
    product: Option<f64>,
    /// ln of the sedimentation coefficient of a diameter of 1 m.
    unit: f64,
    /// (ln diameter, ln counted time), diameters increasing, times falling.
    nodes: Vec<(f64, f64)>,
    surface: Option<Surface>,
    /// Estimate of what is added to `product` before any node is known: from other places.
    delay: f64,
}

impl Curve {
    /// What inertia and run-up add to the logarithm of the time, at the largest diameter computed.
    fn delayed(&self) -> Option<f64> {
        let (d, time) = self.nodes.last()?;
        Some(self.unit + 2.0 * d + time - self.product?)
    }
    /// d ln T/d ln d between the two largest diameters computed.
    fn slope(&self) -> Option<f64> {
        let [.., a, b] = self.nodes.as_slice() else { return None };
        Some((b.1 - a.1) / (b.0 - a.0))
    }
    /// ln of the smallest diameter that leaves by a counted time (its ln).
    fn critical(&self, counted: f64) -> f64 {
        let Some(product) = self.product else { return f64::INFINITY };
        let k = self.nodes.partition_point(|n| n.1 > counted);
        let between = |a: (f64, f64), b: (f64, f64)| a.0 + (b.0 - a.0) * (counted - a.1) / (b.1 - a.1);
        match (k.checked_sub(1).map(|i| self.nodes[i]), self.nodes.get(k)) {
            (None, None) => 0.5 * (product + self.delay - self.unit - counted),
            // small particles: Stokes
            (None, Some(b)) => b.0 - 0.5 * (counted - b.1),
            (Some(a), Some(b)) => between(a, *b),
            (Some(b), None) => b.0 + (counted - b.1) / self.slope().map_or(-2.0, |slope| slope.clamp(-2.5, -0.2)),
        }
    }

    fn add(&mut self, diameter: f64, exit: Option<Exit>, clock: &Clock) {
        let Some(e) = exit else { return };
        let node = (diameter, clock.counted(e.time).max(f64::MIN_POSITIVE).ln());
        self.surface = Some(e.surface);
        let k = self.nodes.partition_point(|n| n.0 < node.0);
        // the curve falls: a larger particle is not later
        let fits =
            k.checked_sub(1).is_none_or(|i| self.nodes[i].1 > node.1) && self.nodes.get(k).is_none_or(|n| n.1 < node.1 && n.0 > node.0);
        if fits && node.1.is_finite() {
            self.nodes.insert(k, node);
        }
    }
}

/// What a share takes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Needed {
    /// Time, s; infinite when the share is never caught, NaN without particles.
    pub time: f64,
    /// Largest difference to the same with the first half and the first quarter of the places, s: an indication of what the sampling of places leaves open, not a bound.
    pub spread: f64,
    /// All particles are to be caught: the start of the last one, m.
    pub last: Option<[f64; 3]>,
}

/// Receives every path that is computed; what it answers says whether to go on.
pub type Watch<'a> = &'a (dyn Fn() -> bool + Sync);

/// The recovery of a batch at one speed.
pub struct Recovery<'a> {
    spinning: &'a Spinning<'a>,
    found: Kind,
    watch: Watch<'a>,
}

enum Kind {
    Smooth(Vec<Curve>),
    /// Exit time, surface, place and weight, in order of time.
    Counted(Vec<(f64, Option<Surface>, usize, f64)>),
}

/// Change of ln t that ends the search, where one more round is known to bring no more than that. Then the most rounds, the change of a share that
/// ends its search, and the share of the powder that is neglected.
const CONVERGED: f64 = 1e-6;
const ROUNDS: usize = 20;
const SETTLED: f64 = 1e-10;
const NOTHING: f64 = 1e-9;
/// How far (ln) on both sides of its first estimate a time is sought.
const FIRST: f64 = 0.01;
/// Places from which on a part of them is looked at first, that part, and how nearly its time is sought (ln).
const MANY: usize = 256;
const PART: usize = 8;
const NEARLY: f64 = 1e-3;

impl<'a> Recovery<'a> {
    /// Without exits known yet.
    ///
    /// # Errors
    /// When an integration fails.
    pub fn new(spinning: &'a Spinning<'a>) -> Result<Self, Lost> {
        Self::watched(spinning, None, &|| true)
    }

    /// The same, watched; `known` are the exits of the members with sizes of their own, where they are there already.
    ///
    /// # Errors
    /// When an integration fails, or the watch says stop.
    pub fn watched(spinning: &'a Spinning<'a>, known: Option<&[Option<Exit>]>, watch: Watch<'a>) -> Result<Self, Lost> {
        let b = spinning.batch;
        let least = b.from.unwrap_or(0.0);
        let classes: Option<Vec<(f64, f64)>> = match &b.powder.size {
            // a powder without particles as large as those that count: those
            Law::Single(d) => Some(vec![(d.max(least), 1.0)]),
            Law::Classes(all) => Some(all.iter().copied().filter(|c| c.0 >= least).collect()),
            law if b.from.is_some_and(|d| !(law.above(d) > 0.0)) => Some(vec![(least, 1.0)]),
            _ => None,
        };
        // the exits of a powder of one size are those of its members
        let known = known.filter(|k| matches!(b.powder.size, Law::Single(d) if d >= least) && k.len() == spinning.crowd.len());
        let found = match classes {
            Some(classes) => {
                let sum: f64 = classes.iter().map(|c| c.1).sum();
                let here = Here::now();
                let all: Result<Vec<_>, Lost> = (0..spinning.crowd.len() * classes.len())
                    .into_par_iter()
                    .map_init(
                        || here.enter(),
                        |_counted, k| {
                            let (i, (d, share)) = (k / classes.len(), classes[k % classes.len()]);
                            let m = &spinning.crowd[i];
                            let p = Particle { radius: 0.5 * d, density: b.powder.density.quantile(m.point.density) };
                            let exit = match known {
                                Some(known) => known[i],
                                None => seen(watch, spinning.exit(&p, m))?,
                            };
                            let time = exit.map_or(f64::INFINITY, |e| e.time);
                            Ok((time, exit.map(|e| e.surface), i, share / sum / spinning.crowd.len() as f64))
                        },
                    )
                    .collect();
                let mut all = all?;
                all.sort_by_number(|a| a.0);
                Kind::Counted(all)
            }
            None => {
                let here = Here::now();
                let curves = spinning
                    .crowd
                    .par_iter()
                    .map_init(
                        || here.enter(),
                        |_counted, m| {
                            let density = b.powder.density.quantile(m.point.density);
                            let unit = b.medium.rates(&Particle { radius: 0.5, density }).sedimentation;
                            let exit = spinning.turning.drift(unit.signum(), m.start).filter(|e| e.time > 0.0 && unit != 0.0);
                            Curve {
                                density,
                                product: exit.map(|e| e.time.ln()),
                                unit: unit.abs().ln(),
                                nodes: vec![],
                                surface: exit.map(|e| e.surface),
                                delay: 0.0,
                            }
                        },
                    )
                    .collect();
                Kind::Smooth(curves)
            }
        };
        Ok(Recovery { spinning, found, watch })
    }

    /// Share of the powder whose logarithms of diameters lie above `ln_d`.
    fn above(&self, ln_d: f64) -> f64 {
        let size = &self.spinning.batch.powder.size;
        match self.spinning.batch.from {
            Some(least) => size.above_ln(ln_d.max(least.ln())) / size.above(least),
            None => size.above_ln(ln_d),
        }
    }

    fn smooth(&self, curves: &[Curve], counted: f64) -> f64 {
        curves.iter().map(|c| self.above(c.critical(counted))).sum::<f64>() / curves.len() as f64
    }

    /// ln of the counted time in which the share is caught, from an estimate of it that may be off by so much; infinite when never.
    fn solve(&self, curves: &[Curve], share: f64, guess: f64, off: f64) -> f64 {
        let miss = |x: f64| self.smooth(curves, x) - share * (1.0 - 1e-13);
        let off = off.clamp(1e-9, FIRST);
        let (mut low, mut high) = (guess - off, guess + off);
        let (mut below, mut beyond) = (miss(low), miss(high));
        let mut width = 5.0 * off;
        // NaN ends at once
        while below >= 0.0 || beyond < 0.0 {
            if width > 2000.0 {
                return if beyond < 0.0 { f64::INFINITY } else { low };
            }
            if below >= 0.0 {
                (high, beyond) = (low, below);
                low -= width;
                below = miss(low);
            } else {
                (low, below) = (high, beyond);
                high += width;
                beyond = miss(high);
            }
            width *= 2.0;
        }
        // Illinois: the secant, with the value at an end that stays halved, so that both ends close in
        let mut stayed = 0;
        for k in 1..200 {
            if !(high - low > 1e-13) {
                break;
            }
            let share = if k % 12 == 0 { 0.5 } else { (below / (below - beyond)).clamp(1e-5, 1.0 - 1e-5) };
            let x = low + (high - low) * share;
            let f = miss(x);
            if f >= 0.0 {
                (high, beyond) = (x, f);
                below *= if stayed > 0 { 0.5 } else { 1.0 };
                stayed = 1;
            } else {
                (low, below) = (x, f);
                beyond *= if stayed < 0 { 0.5 } else { 1.0 };
                stayed = -1;
            }
        }
        high
    }

    /// Computes the exits of the particles from the first so many places that are just caught by a counted time; by how much (ln) they miss it, as root of the mean square.
    fn refine(&mut self, counted: f64, places: usize) -> Result<f64, Lost> {
        let (spinning, watch) = (self.spinning, self.watch);
        let Kind::Smooth(curves) = &self.found else { return Ok(0.0) };
        let here = Here::now();
        let exits: Vec<Option<(f64, Option<Exit>)>> = curves
            .par_iter()
            .take(places)
            .zip(&spinning.crowd)
            .map_init(
                || here.enter(),
                |_counted, (c, m)| {
                    let ln_d = c.critical(counted);
                    let share = self.above(ln_d);
                    let known = c.nodes.iter().any(|n| (n.0 - ln_d).abs() < 1e-13);
                    if c.product.is_none() || !(share > NOTHING && 1.0 - share > NOTHING) || known {
                        return Ok(None);
                    }
                    let particle = Particle { radius: 0.5 * ln_d.exp(), density: c.density };
                    Ok(Some((ln_d, seen(watch, spinning.exit(&particle, m))?)))
                },
            )
            .collect::<Result<_, Lost>>()?;
        let mut missed = MeanSquare::default();
        if let Kind::Smooth(curves) = &mut self.found {
            for (c, found) in curves.iter_mut().zip(exits) {
                if let Some((ln_d, exit)) = found {
                    missed.add(exit.map_or(f64::INFINITY, |e| spinning.clock.counted(e.time).ln() - counted));
                    c.add(ln_d, exit, &spinning.clock);
                }
            }
        }
        Ok(missed.root())
    }

    /// Takes along exits of the members with their own sizes.
    pub fn learn(&mut self, exits: &[Option<Exit>]) {
        let spinning = self.spinning;
        if let Kind::Smooth(curves) = &mut self.found {
            for ((c, m), e) in curves.iter_mut().zip(&spinning.crowd).zip(exits) {
                c.add(spinning.batch.powder.size.quantile(m.point.size).ln(), *e, &spinning.clock);
            }
        }
    }

    /// Time a share takes, and how well it is known.
    ///
    /// # Errors
    /// When an integration fails.
    pub fn needed(&mut self, share: f64) -> Result<Needed, Lost> {
        if let Some(last) = self.all(share)? {
            return Ok(Needed { time: last.time, spread: f64::NAN, last: Some(last.start) });
        }
        let time = self.time(share)?;
        let spinning = self.spinning;
        if !time.is_finite() {
            return Ok(Needed { time, spread: f64::NAN, last: None });
        }
        let other = [2, 4].map(|k| {
            let places = spinning.crowd.len().div_ceil(k);
            match &self.found {
                Kind::Counted(all) => counted(all, places, share),
                Kind::Smooth(curves) => {
                    spinning.clock.time(self.solve(&curves[..places], share, spinning.clock.counted(time).ln(), FIRST).exp())
                }
            }
        });
        // NaN stays
        let spread = other.map(|t| (t - time).abs()).into_iter().reduce(|a, b| if a >= b { a } else { b });
        Ok(Needed { time, spread: spread.unwrap_or(f64::NAN), last: None })
    }

    /// The last particle, when the share is all of them.
    fn all(&self, share: f64) -> Result<Option<Last>, Lost> {
        if share < 1.0 { Ok(None) } else { self.spinning.last() }
    }

    /// Time a share takes, s; infinite when the share is never caught, NaN without particles.
    ///
    /// # Errors
    /// When an integration fails.
    pub fn time(&mut self, share: f64) -> Result<f64, Lost> {
        let spinning = self.spinning;
        if spinning.crowd.is_empty() {
            return Ok(f64::NAN);
        }
        if let Some(last) = self.all(share)? {
            return Ok(last.time);
        }
        if let Kind::Counted(all) = &self.found {
            return Ok(counted(all, spinning.crowd.len(), share));
        }
        let places = spinning.crowd.len();
        let mut x = self.guess();
        // a part of the places, spread as evenly as all, says nearly where the answer lies
        if places >= MANY {
            let near = self.approach(share, places / PART, x, NEARLY)?;
            x = if near.is_finite() { near } else { x };
            self.expect();
        }
        Ok(spinning.clock.time(self.approach(share, places, x, CONVERGED)?.exp()))
    }

    /// Estimates the delay of places without a node by the mean of the others.
    fn expect(&mut self) {
        let Kind::Smooth(curves) = &mut self.found else { return };
        let (sum, count) = curves.iter().filter_map(Curve::delayed).fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
        let mean: f64 = sum / count;
        if mean.is_finite() {
            curves.iter_mut().for_each(|c| c.delay = mean);
        }
    }

    /// ln of the counted time that a share of so many places takes, from an estimate of it, until it is known to that; infinite when the share is never caught.
    fn approach(&mut self, share: f64, places: usize, guess: f64, within: f64) -> Result<f64, Lost> {
        let (mut x, mut missed, mut off) = (guess, f64::INFINITY, FIRST);
        for round in 0..ROUNDS {
            let Kind::Smooth(curves) = &self.found else { break };
            let next = self.solve(&curves[..places.min(curves.len())], share, x, off);
            if !next.is_finite() {
                return Ok(f64::INFINITY);
            }
            // one more round would change x by about the misses times the relative error of the slopes assumed
            let known = missed * slopes(curves) < within;
            let done = round > 0 && (known || (next - x).abs() < within);
            x = next;
            if done {
                break;
            }
            missed = self.refine(x, places)?;
            // the change is of second order in the misses
            off = missed * missed;
        }
        Ok(x)
    }

    /// A counted time (its ln) from which to search: of a particle of median size.
    fn guess(&self) -> f64 {
        let Kind::Smooth(curves) = &self.found else { return 0.0 };
        let d = self.spinning.batch.powder.size.quantile(0.5).ln();
        let times = curves.iter().filter_map(|c| Some(c.product? - c.unit - 2.0 * d)).filter(|x| x.is_finite());
        times.reduce(f64::max).unwrap_or(0.0)
    }

    /// Share caught by a time, with the exits of the particles just caught by then.
    ///
    /// # Errors
    /// When an integration fails.
    pub fn caught(&mut self, time: f64) -> Result<f64, Lost> {
        let counted = self.spinning.clock.counted(time).ln();
        let mut share = self.share(time);
        for _ in 0..ROUNDS {
            self.refine(counted, usize::MAX)?;
            let next = self.share(time);
            let done = (next - share).abs() < SETTLED;
            share = next;
            if done {
                break;
            }
        }
        Ok(share)
    }

    /// Share caught by a time, from the exits known.
    pub fn share(&self, time: f64) -> f64 {
        match &self.found {
            Kind::Counted(all) => all.iter().take_while(|x| x.0 <= time).map(|x| x.3).sum(),
            Kind::Smooth(curves) => self.smooth(curves, self.spinning.clock.counted(time).ln()),
        }
    }

    /// The part of it that leaves through a surface.
    pub fn share_at(&self, time: f64, surface: Surface) -> f64 {
        match &self.found {
            Kind::Counted(all) => all.iter().take_while(|x| x.0 <= time).filter(|x| x.1 == Some(surface)).map(|x| x.3).sum(),
            Kind::Smooth(curves) => {
                let counted = self.spinning.clock.counted(time).ln();
                let own = curves.iter().filter(|c| c.surface == Some(surface));
                own.map(|c| self.above(c.critical(counted))).sum::<f64>() / curves.len() as f64
            }
        }
    }
}

/// Root of the mean square of numbers.
#[derive(Default)]
struct MeanSquare {
    squares: f64,
    count: f64,
}

impl MeanSquare {
    fn add(&mut self, x: f64) {
        self.squares += x * x;
        self.count += 1.0;
    }
    /// Infinite without numbers.
    fn root(&self) -> f64 {
        if self.count > 0.0 { (self.squares / self.count).sqrt() } else { f64::INFINITY }
    }
}

/// Relative difference of the slopes d ln T/d ln d from -2, that of Stokes' law, over the curves with two nodes or more: root of the mean square.
fn slopes(curves: &[Curve]) -> f64 {
    let mut off = MeanSquare::default();
    curves.iter().filter_map(Curve::slope).for_each(|slope| off.add(1.0 + 0.5 * slope));
    off.root()
}

/// An exit that is computed, unless the watch says stop.
fn seen(watch: Watch, exit: Result<Option<Exit>, Lost>) -> Result<Option<Exit>, Lost> {
    if watch() { exit } else { Err(Lost(text!("stopped"))) }
}

/// Weighted order statistic of the first places.
fn counted(all: &[(f64, Option<Surface>, usize, f64)], places: usize, share: f64) -> f64 {
    order(&all.iter().filter(|x| x.2 < places).map(|x| (x.0, x.3)).collect::<Vec<_>>(), share)
}

/// Weighted order statistic: the first time by which the share has left.
fn order(all: &[(f64, f64)], share: f64) -> f64 {
    let Some(first) = all.first() else { return f64::NAN };
    // equal weights: the order statistic by its number
    if all.iter().all(|x| x.1 == first.1) {
        let times: Vec<f64> = all.iter().map(|x| x.0).collect();
        return quantile(&times, share);
    }
    let total: f64 = all.iter().map(|x| x.1).sum();
    let mut sum = 0.0;
    let found = all.iter().find(|x| {
        sum += x.1;
        sum >= (share - 1e-9 / all.len() as f64) * total
    });
    found.or(all.last()).map_or(f64::NAN, |x| x.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without inertia the time falls with the square of the diameter, T s1 d^2 = P: before any path is computed, and below the smallest one that was.
    #[test]
    fn small_particles_follow_stokes() {
        let (product, unit) = (2.5f64, 4e9f64);
        let mut curve = Curve { density: 2000.0, product: Some(product.ln()), unit: unit.ln(), nodes: vec![], surface: None, delay: 0.0 };
        let diameter = |time: f64| (product / (unit * time)).sqrt();
        for time in [1.0, 30.0, 1e4] {
            assert!((curve.critical(f64::ln(time)) - diameter(time).ln()).abs() < 1e-14, "{time}");
        }
        curve.nodes.push((diameter(10.0).ln(), f64::ln(10.0)));
        assert!((curve.critical(f64::ln(70.0)) - diameter(70.0).ln()).abs() < 1e-14);
        curve.product = None;
        assert!(curve.critical(0.0).is_infinite());
    }
}
