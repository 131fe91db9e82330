//! Modes of a machine over a cross-coupled stiffness at one of its places, and the stiffness at which each becomes unstable.
//!
//! ```text
//! T(s; q) x = 0,  T(s; q) = T(s) + q (b_x b_y^T - b_y b_x^T),   ds/dq = -(y^H dT/dq x)/(y^H dT/ds x),   threshold: Re s(q) = 0
//! ```
//!
//! A mode is followed by its exact derivative and Newton's method on T; a step that ends far from the tangent is halved.
//!
//! Symbols: q cross-coupled stiffness kxy = -kyx, N/m, of the opposite sign where the place turns from y towards x; b_x, b_y displacements of the place; s = growth + i frequency; x, y null vectors of T.
//!
//! Validity: small motions about the equilibrium without q, at one spin speed.
//!
//! Sources: the derivative as in [`mode_slopes`](crate::mode_slopes).

mod part;

use crate::characteristic::{Characteristic, Equilibrium, Polished};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::follow::{same, signed};
use crate::large::usual_frequency;
use crate::machine_mode::{MachineMode, Unknowns, Whirl};
use crate::model::field::Attach;
use crate::model::station::Row;
use crate::model::system::{PartInput, System};
use crate::pencil::modes_about;
use crate::rest::rest;
use crate::roots::{Request, has_more_modes, in_region, mode, roots, transcendental};
use crate::sectors::Sector;
use laval_model::model::params::Family;
use laval_model::model::part::Part;
use laval_num::complex::C64;
use laval_num::univariate::root;
use part::{CrossCoupling, CrossCouplingFamily, CrossCouplingParams};
use serde::{Deserialize, Serialize};

/// A machine with a cross-coupled stiffness at a place.
pub struct Coupled {
    /// Without stiffness at the place.
    base: System,
    /// Displacements of the place in x and y over the coordinates.
    rows: [Row; 2],
    /// Path of the stiffness.
    path: String,
    about: Equilibrium,
}

/// A mode at a value of the stiffness.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Point {
    /// Cross-coupled stiffness q, N/m.
    pub stiffness: f64,
    /// s = growth + i frequency.
    pub value: C64,
    /// ds/dq, exact.
    pub slope: C64,
}

/// Where the growth rate of a mode changes its sign.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Crossing {
    /// The mode there; its growth rate is 0 to rounding.
    pub at: Point,
    /// It becomes unstable; otherwise stable.
    pub onset: bool,
    /// Growth rate left over, over its derivative, N/m.
    pub uncertainty: f64,
    /// Direction of whirl there.
    pub whirl: Whirl,
    /// Share of the forward part in the squared amplitudes there.
    pub forward_share: f64,
    /// Number of growing modes just below and just above; `None` where a count is not complete.
    pub growing: [Option<usize>; 2],
}

/// A mode over the stiffness.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Line {
    /// Direction of whirl at the first value.
    pub whirl: Whirl,
    /// Share of the forward part in the squared amplitudes at the first value.
    pub forward_share: f64,
    /// In rising order of the stiffness.
    pub points: Vec<Point>,
    /// Changes of sign of the growth rate, rising.
    pub crossings: Vec<Crossing>,
}

/// Modes over the stiffness.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Lines {
    /// The modes followed.
    pub lines: Vec<Line>,
    /// Lateral modes that oscillate without the stiffness.
    pub modes: usize,
    /// Growing modes at the largest value by all of its spectrum, and among those followed; `None` where the count is not complete.
    pub growing: Option<[usize; 2]>,
    /// Frequency up to which modes that grow are known, rad/s; `None` where all of them are.
    pub below: Option<f64>,
    /// Modes that could not be followed to the largest value.
    pub lost: usize,
    /// Values between which two modes meet in a double root: which of them goes on as which is a convention.
    pub meetings: Vec<(f64, f64)>,
}

impl Lines {
    /// Least stiffness at which a mode becomes unstable, N/m.
    pub fn first_onset(&self) -> Option<f64> {
        let all = self.lines.iter().flat_map(|l| &l.crossings).filter(|c| c.onset);
        all.map(|c| c.at.stiffness).min_by(f64::total_cmp)
    }
}

/// A root that is followed.
#[derive(Clone)]
struct Followed {
    sector: Option<Sector>,
    at: Point,
}

/// Distance of a root from its tangent, over the step along the tangent, and over the root, at which the step is halved.
const BEND: f64 = 0.3;
const STILL: f64 = 1e-7;
/// Shortest step, over the distance, and most steps.
const SHORTEST: f64 = 1e-10;
const MOST: usize = 300;
/// Distance of two modes that have met, of their values over one of them, and of the stiffness over the step between two values.
const MET: f64 = 0.02;
const GAP: f64 = 1e-3;
/// Amplitude of the place over the largest of a mode in which it does not move.
const STAYS: f64 = 1e-6;
/// How often the range of frequencies is doubled until a mode moves the place.
const DOUBLINGS: usize = 6;
/// Steps in which roots that lead to one are followed again.
const PIECES: [usize; 3] = [4, 16, 64];
/// Distance from a threshold, over it, at which growing modes are counted on both sides.
const BESIDE: f64 = 1e-4;
/// Growth over the largest eigenvalue that is rounding.
const ROUNDING: f64 = 1e-13;
/// Growth over the eigenvalue that is none: of a mode without damping.
pub const NEUTRAL: f64 = 1e-10;

/// The machine with a part at a place, which has no stiffness yet and drives whirls of this sense, and the name of the part.
fn with_point(system: &System, at: &Attach, sense: f64) -> Result<(System, String), Diagnostics> {
    let mut name = "cross_coupling".to_string();
    while system.slot(&name).is_some() {
        name.push('_');
    }
    let mut inputs = system.inputs();
    inputs.push(PartInput {
        name: name.clone(),
        part: CrossCoupling { at: at.clone(), sense }.erased(),
        params: CrossCouplingFamily::to_vec(&CrossCouplingParams { cross_coupled: 0.0 }),
        span: None,
    });
    Ok((System::assemble(system.machine.clone(), inputs)?, name))
}

/// The machine with a node at a place, the displacements of the place in x and y over its coordinates, and the ratio of its spin to that of the machine.
pub(crate) fn placed(system: &System, at: &Attach) -> Result<(System, [Row; 2], f64), Diagnostics> {
    let (system, name) = with_point(system, at, 1.0)?;
    let slot = system.slot(&name);
    let map = slot.map(|s| s.map.clone()).unwrap_or_default();
    let row = |k: usize| map.get(k).cloned().unwrap_or_default();
    let (rows, ratio) = ([row(0), row(1)], slot.map_or(1.0, |s| s.speed(system.params(), 1.0)));
    Ok((system, rows, ratio))
}

impl Coupled {
    /// Places the stiffness, which drives whirls in the sense in which the place turns; the state is that of the machine without it.
    ///
    /// # Errors
    /// A place that the machine does not have; no equilibrium at the speed (rad/s).
    pub fn new(system: &System, at: &Attach, speed: f64) -> Result<Self, Diagnostics> {
        let (_, rows, ratio) = placed(system, at)?;
        let (base, name) = with_point(system, at, if ratio * speed < 0.0 { -1.0 } else { 1.0 })?;
        let about = rest(&base, speed).map_err(|d| Diagnostics(vec![d]))?;
        Ok(Coupled { rows, path: format!("{name}.cross_coupled"), base, about })
    }

    fn system(&self, stiffness: f64) -> Result<System, Diagnostic> {
        self.base.with(&[(&self.path, stiffness)]).map_err(Diagnostics::into_error)
    }

    /// A root with its derivative.
    fn point(&self, t: &mut Characteristic, p: &Polished, stiffness: f64) -> Option<Point> {
        let by_q = t.linear_by_parameters(p.value, &self.base.param(&self.path)?);
        let slope = -t.product(p, &by_q) / p.by_s;
        (p.value.is_finite() && slope.is_finite()).then_some(Point { stiffness, value: p.value, slope })
    }

    /// Amplitude of the place over the largest of all coordinates.
    fn share(&self, mode: &MachineMode) -> f64 {
        let at = |row: &Row| row.iter().fold(C64::zero(), |sum, &(i, a)| sum + mode.q.get(i).map_or(C64::zero(), |q| q.scale(a))).abs();
        let largest = mode.q.iter().map(|q| q.abs()).fold(0.0, f64::max);
        if largest > 0.0 { at(&self.rows[0]).hypot(at(&self.rows[1])) / largest } else { 0.0 }
    }

    /// The root that a start leads to.
    fn at(&self, stiffness: f64, start: C64, sector: Option<Sector>) -> Result<Option<(Point, MachineMode)>, Diagnostic> {
        let system = self.system(stiffness)?;
        let mut t = Characteristic::new(&system, &self.about);
        let Some(p) = t.polish(start, sector) else { return Ok(None) };
        let shape = mode(&Unknowns::of(&system), &p, sector);
        Ok(self.point(&mut t, &p, stiffness).map(|point| (point, shape)))
    }

    /// A root along its tangents to another value, in steps halved where it bends: as far as it goes.
    fn path(&self, from: &Followed, to: f64) -> Result<Vec<Followed>, Diagnostic> {
        let mut out: Vec<Followed> = Vec::new();
        let (mut here, whole) = (from.clone(), to - from.at.stiffness);
        let mut share = 1.0f64;
        for _ in 0..MOST {
            let left = to - here.at.stiffness;
            if left == 0.0 || share < SHORTEST {
                break;
            }
            let step = whole * share;
            let next = if step.abs() >= left.abs() { to } else { here.at.stiffness + step };
            let along = here.at.slope.scale(next - here.at.stiffness);
            let found = self.at(next, here.at.value + along, here.sector)?.map(|f| f.0).filter(|at| {
                let off = (at.value - here.at.value - along).abs();
                off <= BEND * along.abs() + STILL * here.at.value.abs() * share
            });
            match found {
                Some(at) => {
                    here = Followed { at, ..here };
                    out.push(here.clone());
                    share = (2.0 * share).min(1.0);
                }
                None => share *= 0.5,
            }
        }
        Ok(out)
    }

    /// Where a root is at another value; `None` where it does not go so far.
    fn lead(&self, from: &Followed, to: f64) -> Result<Option<Followed>, Diagnostic> {
        if from.at.stiffness == to {
            return Ok(Some(from.clone()));
        }
        Ok(self.path(from, to)?.pop().filter(|f| f.at.stiffness == to))
    }

    fn lead_in(&self, from: &Followed, to: f64, pieces: usize) -> Result<Option<Followed>, Diagnostic> {
        let mut here = from.clone();
        for k in 1..=pieces {
            let next = from.at.stiffness + (to - from.at.stiffness) * k as f64 / pieces as f64;
            match self.lead(&here, next)? {
                Some(there) => here = there,
                None => return Ok(None),
            }
        }
        Ok(Some(here))
    }

    /// All lateral modes that oscillate without the stiffness, those that it makes unstable first by their derivative first.
    ///
    /// # Errors
    /// As [`modes_about`].
    pub fn modes(&self) -> Result<Vec<Start>, Diagnostic> {
        let mut found = modes_about(&self.base, &self.about, true)?.modes;
        if has_more_modes(&self.base) {
            // the lowest modes of a large machine may be of other bodies
            let mut frequency = usual_frequency(&self.base, &self.about);
            for _ in 0..DOUBLINGS {
                if found.iter().any(|m| m.whirl.is_lateral() && m.value.im > 0.0 && self.share(m) >= STAYS) {
                    break;
                }
                frequency *= 2.0;
                found = roots(&self.base, &self.about, &Request { frequency: Some(frequency), ..Request::default() })?.spectrum.modes;
            }
        }
        let mut t = Characteristic::new(&self.base, &self.about);
        let mut out: Vec<Start> = Vec::new();
        for m in found.into_iter().filter(|m| m.whirl.is_lateral() && m.value.im > 0.0) {
            let Some(p) = t.polish(m.value, m.sector) else { continue };
            let share = self.share(&m);
            out.extend(self.point(&mut t, &p, 0.0).map(|at| Start { at, mode: m, share }));
        }
        out.sort_by(|a, b| a.estimate().total_cmp(&b.estimate()).then(b.at.value.re.total_cmp(&a.at.value.re)));
        Ok(out)
    }

    /// Modes that grow at a value, `None` where the count is not complete, and the frequency up to which they were counted, `None` where it is any.
    fn growing(&self, stiffness: f64, starts: &[C64]) -> Result<(Option<Vec<MachineMode>>, Option<f64>), Diagnostic> {
        let system = self.system(stiffness)?;
        if in_region(&system) {
            let found = roots(&system, &self.about, &Request { growing: true, everywhere: true, starts, ..Request::default() })?;
            let count = found.growing();
            let modes: Vec<MachineMode> = found.spectrum.modes.into_iter().filter(|m| m.value.re > 0.0).collect();
            return Ok((count.filter(|n| *n == modes.len()).map(|_| modes), transcendental(&system).then_some(found.frequency)));
        }
        let mut modes = modes_about(&system, &self.about, true)?.modes;
        let largest = modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
        modes.retain(|m| {
            let error = if m.error.is_nan() { 0.0 } else { m.error };
            !(m.value.re <= error + ROUNDING * largest)
        });
        Ok((Some(modes), None))
    }

    /// Follows modes over rising values, the first of which is 0; `each` receives the number of values done and stops the work by saying false. Modes that grow at the last value and
    /// were not among them are followed back.
    ///
    /// # Errors
    /// As [`Coupled::modes`].
    pub fn follow(&self, starts: &[Start], values: &[f64], mut each: impl FnMut(u64) -> bool) -> Result<(Lines, bool), Diagnostic> {
        let line = |s: &Start| Line { whirl: s.mode.whirl, forward_share: s.mode.forward_share, points: vec![s.at], crossings: vec![] };
        let mut lines: Vec<Line> = starts.iter().map(line).collect();
        let sector = |k: usize| starts[k].mode.sector;
        let mut here: Vec<Option<Followed>> = starts.iter().map(|s| Some(Followed { sector: s.mode.sector, at: s.at })).collect();
        let (mut complete, mut meetings) = (true, Vec::new());
        for (done, &to) in values.iter().enumerate().skip(1) {
            if !each(done as u64) {
                complete = false;
                break;
            }
            let before = here.clone();
            for f in here.iter_mut() {
                if let Some(from) = f.take() {
                    *f = self.lead(&from, to)?;
                }
            }
            // two that lead to one are followed again in shorter steps; if that does not part them both end
            for pieces in PIECES {
                for k in twice(&here) {
                    if let Some(from) = &before[k] {
                        here[k] = self.lead_in(from, to, pieces)?;
                    }
                }
            }
            for k in twice(&here) {
                here[k] = None;
            }
            let ended: Vec<usize> = (0..here.len()).filter(|&k| before[k].is_some() && here[k].is_none()).collect();
            if !ended.is_empty() {
                meetings.extend(self.beyond(&ended, &before, &mut here, &mut lines, to)?);
            }
            for (line, f) in lines.iter_mut().zip(&here) {
                line.points.extend(f.as_ref().map(|f| f.at));
            }
        }
        let lost = here.iter().filter(|f| f.is_none()).count();
        let mut sectors: Vec<Option<Sector>> = (0..starts.len()).map(sector).collect();
        let (mut growing, mut below) = (None, None);
        if let (true, Some(&last)) = (complete, values.last()) {
            let known: Vec<C64> = here.iter().flatten().map(|f| signed(f.at.value, f.sector)).collect();
            let found = self.growing(last, &known)?;
            below = found.1;
            if let Some(all) = found.0 {
                let mut among = 0;
                for m in &all {
                    if here.iter().flatten().any(|f| f.sector == m.sector && same(f.at.value, m.value)) {
                        among += 1;
                    } else if let Some(line) = self.back(m, values)? {
                        lines.push(line);
                        sectors.push(m.sector);
                        among += 1;
                    }
                }
                growing = Some([all.len(), among]);
            }
        }
        for (line, sector) in lines.iter_mut().zip(&sectors) {
            line.crossings = self.crossings(line, *sector)?;
        }
        Ok((Lines { lines, modes: starts.len(), growing, below, lost, meetings }, complete))
    }

    /// Of roots that end before a value, because they meet others in double roots: continues them by those at the value that lead back to the same place.
    fn beyond(
        &self,
        ended: &[usize],
        before: &[Option<Followed>],
        here: &mut [Option<Followed>],
        lines: &mut [Line],
        to: f64,
    ) -> Result<Vec<(f64, f64)>, Diagnostic> {
        let system = self.system(to)?;
        let known: Vec<C64> = here.iter().flatten().map(|f| signed(f.at.value, f.sector)).collect();
        let all = match in_region(&system) {
            true => roots(&system, &self.about, &Request { starts: &known, ..Request::default() })?.spectrum.modes,
            false => modes_about(&system, &self.about, true)?.modes,
        };
        let mut free: Vec<MachineMode> = all.into_iter().filter(|m| m.whirl.is_lateral() && m.value.im > 0.0).collect();
        free.retain(|m| !here.iter().flatten().any(|f| f.sector == m.sector && same(m.value, f.at.value)));
        let mut meetings = Vec::new();
        for &k in ended {
            let Some(from) = &before[k] else { continue };
            let path = self.path(from, to)?;
            let end = path.last().unwrap_or(from).clone();
            lines[k].points.extend(path.iter().map(|f| f.at).filter(|p| p.stiffness < to));
            free.sort_by(|a, b| (b.value - end.at.value).abs().total_cmp(&(a.value - end.at.value).abs()));
            let step = to - from.at.stiffness;
            let mut left = Vec::new();
            while let Some(m) = free.pop() {
                let other = match self.at(to, m.value, m.sector)? {
                    Some((at, _)) => Followed { sector: m.sector, at },
                    None => continue,
                };
                let back = self.path(&other, from.at.stiffness)?;
                let first = back.last().unwrap_or(&other).at;
                let gap = first.stiffness - end.at.stiffness;
                if gap.abs() <= GAP * step && (first.value - end.at.value).abs() <= MET * first.value.abs() {
                    meetings.push((end.at.stiffness.min(first.stiffness), end.at.stiffness.max(first.stiffness)));
                    lines[k].points.extend(back.iter().rev().map(|f| f.at).filter(|p| p.stiffness > end.at.stiffness));
                    here[k] = Some(other);
                    break;
                }
                left.push(m);
            }
            free.extend(left);
        }
        Ok(meetings)
    }

    /// A mode at the last value followed back to the first, as far as it goes.
    fn back(&self, m: &MachineMode, values: &[f64]) -> Result<Option<Line>, Diagnostic> {
        let Some(&last) = values.last() else { return Ok(None) };
        let Some((at, shape)) = self.at(last, m.value, m.sector)? else { return Ok(None) };
        let mut here = Followed { sector: m.sector, at };
        let mut line = Line { whirl: shape.whirl, forward_share: shape.forward_share, points: vec![at], crossings: vec![] };
        for &to in values.iter().rev().skip(1) {
            let Some(there) = self.lead(&here, to)? else { break };
            line.points.insert(0, there.at);
            here = there;
        }
        Ok(Some(line))
    }

    /// Changes of sign of the growth rate along a line, solved for.
    fn crossings(&self, line: &Line, sector: Option<Sector>) -> Result<Vec<Crossing>, Diagnostic> {
        let mut out = Vec::new();
        for pair in line.points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let (below, above) = (a.value.re, b.value.re);
            if a.stiffness == 0.0 && below.abs() <= NEUTRAL * a.value.abs() {
                // without damping it is unstable with any stiffness
                if above > NEUTRAL * b.value.abs() {
                    let (whirl, forward_share, uncertainty) = (line.whirl, line.forward_share, left_over(below, a.slope.re));
                    out.push(Crossing { at: a, onset: true, uncertainty, whirl, forward_share, growing: [None; 2] });
                }
                continue;
            }
            if (below < 0.0) == (above < 0.0) {
                continue;
            }
            let mut failed: Option<Diagnostic> = None;
            let growth = |q: f64| -> Option<f64> {
                let near = if (q - a.stiffness).abs() <= (q - b.stiffness).abs() { a } else { b };
                match self.lead(&Followed { sector, at: near }, q) {
                    Ok(f) => f.map(|f| f.at.value.re),
                    Err(d) => {
                        failed = Some(d);
                        None
                    }
                }
            };
            let found = root(growth, (a.stiffness, below), (b.stiffness, above), 0.0);
            if let Some(d) = failed {
                return Err(d);
            }
            let Some(q) = found else { continue };
            let near = if (q - a.stiffness).abs() <= (q - b.stiffness).abs() { a } else { b };
            let Some(there) = self.lead(&Followed { sector, at: near }, q)? else { continue };
            let Some((at, shape)) = self.at(q, there.at.value, sector)? else { continue };
            let uncertainty = left_over(at.value.re, at.slope.re);
            let beside = |side: f64| -> Result<Option<usize>, Diagnostic> {
                let q = q * (1.0 + side * BESIDE);
                Ok(self.growing(q, &[signed(at.value, sector)])?.0.map(|all| all.len()))
            };
            let growing = [beside(-1.0)?, beside(1.0)?];
            let (whirl, forward_share) = (shape.whirl, shape.forward_share);
            out.push(Crossing { at, onset: below < 0.0, uncertainty, whirl, forward_share, growing });
        }
        Ok(out)
    }
}

/// A mode without the stiffness.
#[derive(Clone, Debug)]
pub struct Start {
    /// The mode and its derivative.
    pub at: Point,
    /// Its shape and direction.
    pub mode: MachineMode,
    /// Amplitude of the place over the largest of all coordinates.
    pub share: f64,
}

impl Start {
    /// The place moves in this mode; what is driven in another is rounding.
    pub fn moves(&self) -> bool {
        self.share >= STAYS
    }

    /// Stiffness at which it becomes unstable by its derivative, N/m; infinite where that decreases the growth.
    pub fn estimate(&self) -> f64 {
        let (growth, rate) = (self.at.value.re, self.at.slope.re);
        if growth >= 0.0 {
            0.0
        } else if rate > 0.0 {
            -growth / rate
        } else {
            f64::INFINITY
        }
    }
}

/// Indices of roots that are those of another.
fn twice(all: &[Option<Followed>]) -> Vec<usize> {
    let alike = |a: &Followed, b: &Followed| a.sector == b.sector && same(a.at.value, b.at.value);
    let again = |k: &usize| {
        let own = &all[*k];
        all.iter().enumerate().any(|(j, other)| j != *k && matches!((own, other), (Some(a), Some(b)) if alike(a, b)))
    };
    (0..all.len()).filter(again).collect()
}

/// What a growth rate that should be 0 makes of the stiffness, by its derivative.
fn left_over(growth: f64, slope: f64) -> f64 {
    if growth == 0.0 { 0.0 } else { (growth / slope).abs() }
}
