//! Limit cycles: self-excited whirls of a damped machine over the spin speed, from the edges of linear instability.
//!
//! At an edge a pair of eigenvalues stands on the imaginary axis: a Hopf point, from which one family of cycles starts with vanishing amplitude a and
//! `W - W_h = k a^2 + ...`. Where the small cycles lie on the side on which rest is unstable the onset is soft (they are stable); on the other side it
//! is hard: rest is stable there, and an unstable cycle is the size of the disturbance that leads away from it. Families are followed in
//! the speed with the whirl frequency unknown. One Floquet exponent of a cycle is zero, that of a shift in time; it is recognised and set apart.
//!
//! Theory: `docs/theory/free-motions.md#limit-cycles`.

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::problem::{Balance, Discretisation};
use crate::harmonic::free::backbone::{backward, discretisation, linear_modes, next_order, polish, static_harmonics};
use crate::harmonic::free::whirl::{Free, Quantity, autonomous, natural_amplitude};
use crate::harmonic::stability::floquet::{Exponents, Stability, Unassessed};
use crate::model::system::{Slot, System};
use crate::pencil::{MachineMode, Whirl};
use crate::rest::rest;
use crate::stability::{Edge, Row, row};
use crate::symmetry::Symmetry;
use laval_model::text;
use laval_num::complex::C64;
use laval_num::continuation::{Direction, End, Kind, Point, Settings, Status, Zero, trace};
use laval_num::newton::{Options, newton};
use laval_num::work::piece;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, Ordering};

/// The request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// Range of the spin speed, rad/s.
    pub speeds: (f64, f64),
    /// Speeds at which rest is assessed.
    pub points: usize,
    /// Largest order; `None` chooses.
    pub harmonics: Option<usize>,
    /// Dropped over kept force harmonics that the choice accepts.
    pub truncation: f64,
    /// Most points of a family.
    pub max_points: usize,
    /// Most spectra and points in all.
    pub work: u64,
}

/// A limit cycle.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Cycle {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Whirl frequency, rad/s; negative backward where the machine has no preferred direction.
    pub frequency: f64,
    /// Amplitude of the leading harmonic of the nonlinear coordinates, m.
    pub amplitude: f64,
    /// Harmonics of the nonlinear coordinates.
    pub x: Vec<f64>,
    /// Exponents without the one of a shift in time.
    pub exponents: Option<Exponents>,
    /// That one's distance from zero, 1/s.
    pub trivial: f64,
    /// Largest growth rate of the machine at rest, 1/s.
    pub rest: f64,
    /// Dropped over kept force harmonics.
    pub truncation: f64,
    /// Scaled residual.
    pub residual: f64,
}

impl Cycle {
    /// Assessed stable.
    pub fn stable(&self) -> bool {
        self.exponents.as_ref().is_some_and(Exponents::stable)
    }
    /// Largest growth rate of a disturbance, 1/s; NaN when not assessed.
    pub fn growth(&self) -> f64 {
        self.exponents.as_ref().map_or(f64::NAN, Exponents::growth)
    }
}

/// An edge of linear instability and the cycles that start there.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Onset {
    /// The edge.
    pub edge: Edge,
    /// Signed whirl frequency there, rad/s.
    pub frequency: f64,
    /// Direction of the mode.
    pub whirl: Whirl,
    /// k of `W - W_h = k a^2`, rad/s/m^2; NaN when no cycle was found.
    pub curvature: f64,
    /// Relative change of k at half the amplitude.
    pub curvature_change: f64,
    /// Small cycles lie where rest is stable.
    pub hard: bool,
    /// Why no family starts here.
    #[serde(deserialize_with = "laval_num::text::optional")]
    pub left: Option<laval_num::text::Text>,
}

/// A fold of cycles.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Fold {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Bracket.
    pub bracket: (f64, f64),
    /// Scaled residual of the extended system, where it confirmed the fold.
    pub residual: f64,
    /// Found by the extended system as well.
    pub confirmed: bool,
    /// It lies between this cycle and the next.
    pub after: usize,
}

/// A change of stability away from folds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Change {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Bracket.
    pub bracket: (f64, f64),
    /// The exponent that crosses.
    pub exponent: C64,
}

/// A family of cycles.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Family {
    /// Index of the onset it starts at.
    pub onset: usize,
    /// Onset at which it ends, when its amplitude vanishes again.
    pub ends_at: Option<usize>,
    /// In order.
    pub cycles: Vec<Cycle>,
    /// Folds.
    pub folds: Vec<Fold>,
    /// Changes of stability between folds.
    pub changes: Vec<Change>,
    /// How it ended.
    pub end: End,
    /// Its amplitude grows beyond all that the nonlinear parts could bound, near this speed, rad/s.
    pub unbounded: Option<f64>,
    /// Leading unknown of the harmonics.
    pub lead: usize,
}

/// All families over a range of speeds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Cycles {
    /// Stability of rest.
    pub rest: Row,
    /// Edges.
    pub onsets: Vec<Onset>,
    /// Families.
    pub families: Vec<Family>,
    /// Discretisation used.
    pub discretisation: Discretisation,
    /// Amplitude at which the nonlinear parts show, m.
    pub natural: f64,
    /// Why stability was not assessed.
    pub unassessed: Option<Unassessed>,
    /// Newton iterations.
    pub iterations: u64,
    /// Families were left out: stopped on request, or the work allowed was used up.
    pub stopped: bool,
}

impl Cycles {
    /// Cycles of all families.
    pub fn points(&self) -> u64 {
        self.families.iter().map(|f| f.cycles.len() as u64).sum()
    }
}

/// A whirl that takes a body this many natural amplitudes away is not bounded by the nonlinear parts.
const FAR: f64 = 100.0;

/// First amplitude over the one at which nonlinear parts show.
const FIRST: f64 = 1e-2;

/// Whether limit cycles of this machine can be sought.
///
/// # Errors
/// No nonlinear part, a part that forces the motion, no damping at all.
pub fn admit(system: &System, (lo, hi): (f64, f64)) -> Result<(), Diagnostic> {
    if system.slots().iter().all(Slot::is_linear) {
        return Err(Diagnostic::error(
            "free.linear",
            text!("all parts of this machine are linear: where it is unstable its whirl grows without bound"),
        )
        .help(text!("use stability_map for the ranges of speed in which it does")));
    }
    autonomous(system, lo)?;
    let mirrored = |modes: &[MachineMode]| {
        let size = modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
        modes.iter().all(|m| modes.iter().any(|o| (o.value + m.value.conj()).abs() <= 1e-7 * size))
    };
    for speed in [lo, 0.5 * (lo + hi), hi] {
        if !mirrored(&linear_modes(system, speed)?) {
            return Ok(());
        }
    }
    Err(Diagnostic::error(
        "limit_cycles.undamped",
        text!("nothing damps this machine: its free whirls form families of every amplitude, and none of them is a limit cycle"),
    )
    .help(match system.damping_of_waves() {
        Some(by) => text!("use backbone for the families, or give the machine damping ({by})", by = text::term(by)),
        None => text!("use backbone for the families, or give the machine damping"),
    }))
}

/// Computes all families.
///
/// # Errors
/// As [`admit`], and eigenvalues that cannot be computed.
pub fn limit_cycles<'a>(system: &'a System, request: &Request, cancel: &'a AtomicBool, tick: &dyn Fn(u64)) -> Result<Cycles, Diagnostic> {
    let (lo, hi) = request.speeds;
    let count = request.points.max(3);
    let speeds: Vec<f64> = (0..count).map(|i| lo + (hi - lo) * i as f64 / (count - 1) as f64).collect();
    let goes_on = |done: u64| done < request.work && !cancel.load(Ordering::Relaxed);
    let at_rest = row(system, &|w| rest(system, w), &speeds, 0.0, |done| {
        tick(done);
        goes_on(done)
    })?;
    let mut left = request.work.saturating_sub(at_rest.solved);
    let mut harmonics = request.harmonics.unwrap_or(7);
    let mut settled = request.harmonics.is_some();
    loop {
        let d = discretisation(system, 0.5 * (lo + hi), harmonics);
        settled |= d.symmetry == Symmetry::Circular;
        // stability is assessed once the orders are chosen
        let mut found = attempt(system, &Request { work: left, ..*request }, at_rest.clone(), (d, settled), cancel, tick)?;
        found.stopped |= found.rest.stopped || cancel.load(Ordering::Relaxed);
        if settled || found.stopped {
            return Ok(found);
        }
        left = left.saturating_sub(found.points());
        let worst = found.families.iter().flat_map(|f| &f.cycles).fold(0.0, |m: f64, p| if p.truncation <= m { m } else { p.truncation });
        let more = next_order(harmonics);
        settled = worst <= request.truncation || more > crate::harmonic::free::backbone::MOST_HARMONICS;
        if !settled {
            harmonics = more;
        }
    }
}

fn attempt<'a>(
    system: &'a System,
    request: &Request,
    at_rest: Row,
    (d, stability): (Discretisation, bool),
    cancel: &'a AtomicBool,
    tick: &dyn Fn(u64),
) -> Result<Cycles, Diagnostic> {
    let (lo, hi) = request.speeds;
    let probe = Balance::new(system, d, (0.5 * hi, hi), Some(cancel))?;
    let natural = natural_amplitude(&probe).unwrap_or(1e-3);
    let mut out = Cycles {
        onsets: at_rest.edges.iter().map(|e| onset(system, e, d.symmetry)).collect::<Result<_, _>>()?,
        rest: at_rest,
        families: Vec::new(),
        discretisation: d,
        natural,
        unassessed: None,
        iterations: 0,
        stopped: false,
    };
    if out.rest.stopped {
        return Ok(out);
    }
    let mut assessor = match Stability::new(system) {
        Ok(s) => stability.then_some(s),
        Err(why) => {
            out.unassessed = Some(why);
            None
        }
    };
    for k in 0..out.onsets.len() {
        if out.families.iter().any(|f| f.ends_at == Some(k)) {
            out.onsets[k].left = Some("the family of another onset ends here");
        }
        let (edge, frequency) = (out.onsets[k].edge, out.onsets[k].frequency);
        if frequency == 0.0 {
            out.onsets[k].left = Some("the machine is pushed aside without whirling");
            continue;
        }
        let mut free = Free::new(system, d, (natural, frequency), edge.speed, Some(cancel))?;
        let Some(start) = small_cycle(system, &mut free, &mut out.onsets[k], natural)? else { continue };
        if out.onsets[k].left.is_some() {
            continue;
        }
        let (x, speed) = start;
        if !(lo..=hi).contains(&speed) {
            out.onsets[k].left = Some("its cycles lie outside the range of speeds");
            continue;
        }
        (free.unknown, free.parameter) = (vec![Quantity::Frequency], Quantity::Speed);
        let direction = if speed > edge.speed { Direction::Up } else { Direction::Down };
        let points = usize::try_from(request.work.saturating_sub(out.points())).unwrap_or(usize::MAX);
        if points < 2 {
            out.stopped = true;
            break;
        }
        let max_points = request.max_points.min(points);
        let settings = Settings { max_points, max_parameter_step: (hi - lo) / 50.0, ..Settings::new(lo, hi) };
        let branch = trace(&mut free, &x, speed, direction, &settings, &mut [])
            .map_err(|e| Diagnostic::error("limit_cycles.settings", text!("the cycles cannot be followed: {e}", e)))?;
        out.iterations += branch.counters.work.iterations as u64;
        out.stopped |= branch.end == End::MaxPoints && points < request.max_points;
        let lead = free.lead;
        // beyond a vanishing amplitude the family repeats itself half a period later
        let all = branch.points.len();
        let vanished = branch.points.iter().position(|p| !(p.x[lead] > 0.0)).unwrap_or(all);
        let far = branch.points.iter().position(|p| !(reach(&mut free, p) <= FAR * natural)).unwrap_or(all);
        let kept = vanished.min(far);
        let unbounded = branch.points.get(far).filter(|_| far < vanished).map(|p| p.p);
        let n = free.harmonics();
        let mut cycles = Vec::with_capacity(kept);
        let mut stopped = false;
        for p in &branch.points[..kept] {
            let assessed = piece(|| {
                let (x, residual) = polish(&mut free, &p.x, p.p).unwrap_or_else(|| (p.x.clone(), p.residual));
                cycle(&mut free, &mut assessor, &mut out.unassessed, &x, p.p, residual)
            });
            cycles.extend(assessed);
            tick(out.points() + cycles.len() as u64);
            stopped = free.cancelled();
            if stopped {
                break;
            }
        }
        let ends_at = (vanished < all && vanished < far && !stopped).then(|| {
            let p = &branch.points[kept];
            let distance = |o: &Onset| (o.edge.speed - p.p).abs() / hi + (o.frequency / p.x[n] - 1.0).abs();
            (0..out.onsets.len()).filter(|&j| j != k).min_by(|&a, &b| distance(&out.onsets[a]).total_cmp(&distance(&out.onsets[b])))
        });
        let folds: Vec<Fold> = branch.of(Kind::Fold).filter(|s| s.after + 1 < cycles.len()).map(fold_of).collect();
        let mut changes = Vec::new();
        for i in 1..cycles.len() {
            let (a, b): (&Cycle, &Cycle) = (&cycles[i - 1], &cycles[i]);
            let assessed = a.exponents.is_some() && b.exponents.is_some();
            if assessed && a.stable() != b.stable() && !folds.iter().any(|f| f.after + 1 == i) {
                changes.extend(locate_change(&mut free, &mut assessor, &mut out.unassessed, a, b));
            }
        }
        let end = match branch.end {
            _ if stopped => End::Cancelled,
            _ if kept < all => End::Reached,
            end => end,
        };
        out.families.push(Family { onset: k, ends_at: ends_at.flatten(), cycles, folds, changes, end, unbounded, lead });
    }
    Ok(out)
}

/// How far a cycle takes the bodies and the nonlinear coordinates, by first order, m.
fn reach(free: &mut Free, p: &Point) -> f64 {
    let mut bodies = vec![0.0; free.monitors()];
    match free.measure(&p.x, p.p, &mut bodies) {
        Ok(()) => bodies.chunks(2).map(|b| b[0].hypot(b[1])).fold(p.x[free.lead].abs(), |m, b| if b <= m { m } else { b }),
        Err(_) => f64::NAN,
    }
}

fn onset(system: &System, edge: &Edge, symmetry: Symmetry) -> Result<Onset, Diagnostic> {
    let mode = mode_at(system, edge)?;
    let turned = mode.as_ref().is_some_and(|m| backward(m, symmetry));
    let frequency = mode.as_ref().map_or(0.0, |m| m.value.im) * if turned { -1.0 } else { 1.0 };
    let whirl = mode.map_or(Whirl::None, |m| m.whirl);
    Ok(Onset { edge: *edge, frequency, whirl, curvature: f64::NAN, curvature_change: f64::NAN, hard: false, left: None })
}

/// The mode that crosses at an edge.
fn mode_at(system: &System, edge: &Edge) -> Result<Option<MachineMode>, Diagnostic> {
    let modes = linear_modes(system, edge.speed)?;
    Ok(modes.into_iter().min_by(|a, b| (a.value - edge.value).abs().total_cmp(&(b.value - edge.value).abs())))
}

/// A cycle of the first amplitude with its speed: harmonics and frequency.
fn small_cycle(system: &System, free: &mut Free, onset: &mut Onset, natural: f64) -> Result<Option<(Vec<f64>, f64)>, Diagnostic> {
    let (edge, frequency) = (onset.edge, onset.frequency);
    let Some(mode) = mode_at(system, &edge)? else { return Ok(None) };
    (free.unknown, free.parameter) = (vec![Quantity::Frequency, Quantity::Speed], Quantity::Amplitude);
    let a = FIRST * natural;
    let Some(mut x) = free.shape(&mode.q, frequency < 0.0, a) else {
        onset.left = Some("it does not deflect the nonlinear parts, and its growth has no bound");
        return Ok(None);
    };
    if let Some(still) = static_harmonics(free, system, edge.speed) {
        x.iter_mut().zip(&still).for_each(|(x, s)| *x += s);
    }
    x.extend([frequency, edge.speed]);
    let options = Options { to_rounding: true, ..Options::default() };
    let n = free.harmonics();
    let mut half = x.clone();
    half[..n].iter_mut().for_each(|x| *x *= 0.5);
    let found = newton(free, &mut x, a, &options).is_ok() && newton(free, &mut half, 0.5 * a, &options).is_ok();
    if !found || (x[n] / frequency - 1.0).abs() > 0.2 {
        onset.left = Some("no small cycle was found near it");
        return Ok(None);
    }
    let k = |x: &[f64], a: f64| (x[n + 1] - edge.speed) / (a * a);
    onset.curvature = k(&x, a);
    onset.curvature_change = k(&half, 0.5 * a) / onset.curvature - 1.0;
    onset.hard = (onset.curvature > 0.0) != edge.onset;
    let speed = x[n + 1];
    x.truncate(n + 1);
    Ok(Some((x, speed)))
}

fn cycle(
    free: &mut Free,
    assessor: &mut Option<Stability>,
    unassessed: &mut Option<Unassessed>,
    x: &[f64],
    speed: f64,
    residual: f64,
) -> Cycle {
    let n = free.harmonics();
    let [_, frequency, _] = free.quantities(x, speed);
    free.place(x, speed, None);
    free.balance.sample(&x[..n], speed);
    let truncation = free.balance.truncation();
    let (mut exponents, mut trivial) = (None, f64::NAN);
    if let Some(assessor) = assessor {
        match assessor.exponents(&mut free.balance, &x[..n], speed) {
            Ok(mut e) => {
                if let Some(at) = (0..e.values.len()).min_by(|&a, &b| e.values[a].abs().total_cmp(&e.values[b].abs())) {
                    trivial = e.values.swap_remove(at).abs();
                }
                exponents = Some(e);
            }
            Err(why) => *unassessed = Some(why),
        }
    }
    let modes = linear_modes(free.balance.system, speed).unwrap_or_default();
    let rest = modes.iter().map(|m| m.growth()).fold(f64::NEG_INFINITY, f64::max);
    let rest = if rest.is_finite() { rest } else { f64::NAN };
    Cycle { speed, frequency, amplitude: x[free.lead], x: x[..n].to_vec(), exponents, trivial, rest, truncation, residual }
}

fn fold_of(s: &laval_num::continuation::Special) -> Fold {
    let exact = s.fold.as_ref();
    Fold {
        speed: exact.map_or(s.point.p, |f| f.p),
        bracket: (s.bracket[0].p.min(s.bracket[1].p), s.bracket[0].p.max(s.bracket[1].p)),
        residual: exact.map_or(s.residual, |f| f.residual),
        confirmed: s.status == Status::Confirmed,
        after: s.after,
    }
}

/// The speed between two cycles at which the largest growth rate passes zero.
fn locate_change(
    free: &mut Free,
    assessor: &mut Option<Stability>,
    unassessed: &mut Option<Unassessed>,
    a: &Cycle,
    b: &Cycle,
) -> Option<Change> {
    let (mut a, mut b) = (a.clone(), b.clone());
    let mut best = None;
    for _ in 0..60 {
        if (b.speed - a.speed).abs() <= 1e-11 * b.speed.abs() {
            break;
        }
        let t = a.growth() / (a.growth() - b.growth());
        let t = if t.is_finite() { t.clamp(0.1, 0.9) } else { 0.5 };
        let speed = a.speed + t * (b.speed - a.speed);
        let mut x: Vec<f64> = a.x.iter().zip(&b.x).map(|(a, b)| a + t * (b - a)).collect();
        x.push(a.frequency + t * (b.frequency - a.frequency));
        let Ok(done) = newton(free, &mut x, speed, &Options::default()) else { break };
        let mid = cycle(free, assessor, unassessed, &x, speed, done.residual);
        let exponent = mid.exponents.as_ref()?.values.iter().copied().max_by(|x, y| x.re.total_cmp(&y.re))?;
        best = Some((speed, exponent));
        if mid.stable() == a.stable() { a = mid } else { b = mid }
    }
    best.map(|(speed, exponent)| Change { speed, bracket: (a.speed.min(b.speed), a.speed.max(b.speed)), exponent })
}

/// A cycle at a given speed, from a family: one for every piece that passes it.
pub fn at_speed(system: &System, found: &Cycles, family: &Family, speed: f64) -> Result<Vec<Cycle>, Diagnostic> {
    let mut out = Vec::new();
    let (mut assessor, mut unassessed) = (Stability::new(system).ok(), None);
    for w in family.cycles.windows(2) {
        let (a, b) = (&w[0], &w[1]);
        if (a.speed - speed) * (b.speed - speed) > 0.0
            || a.speed == b.speed
            || b.speed == speed && !std::ptr::eq(b, &family.cycles[family.cycles.len() - 1])
        {
            continue;
        }
        let t = (speed - a.speed) / (b.speed - a.speed);
        let mut free = Free::new(system, found.discretisation, (found.natural, a.frequency), speed, None)?;
        (free.unknown, free.parameter, free.lead) = (vec![Quantity::Frequency], Quantity::Speed, family.lead);
        let mut x: Vec<f64> = a.x.iter().zip(&b.x).map(|(a, b)| a + t * (b - a)).collect();
        x.push(a.frequency + t * (b.frequency - a.frequency));
        if let Ok(done) = newton(&mut free, &mut x, speed, &Options { to_rounding: true, ..Options::default() }) {
            out.push(cycle(&mut free, &mut assessor, &mut unassessed, &x, speed, done.residual));
        }
    }
    Ok(out)
}
