//! Families of free whirls of a machine at fixed spin: frequency against amplitude, from the linear modes and from infinity.
//!
//! Every linear mode that deflects the nonlinear parts continues to a family of nonlinear free motions. At infinite amplitude a hardening part is
//! rigid: the families end at frequencies where the machine can whirl without deflecting it, the zeros of the condensed compliance
//! `B Z(i w)^-1 B^T`. A family may come from there without reaching a linear mode.
//!
//! Theory: `docs/theory/free-motions.md#backbone-curves`.

use crate::characteristic::{coordinate_sectors, state_sectors};
use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::condense::Basis;
use crate::harmonic::balance::first_order::first_order;
use crate::harmonic::balance::pace::Pace;
use crate::harmonic::balance::problem::{Balance, Discretisation, Nonlinear};
use crate::harmonic::balance::terms::Terms;
use crate::harmonic::free::whirl::{Free, autonomous, natural_amplitude};
use crate::harmonic::stability::floquet::Unassessed;
use crate::model::part::At;
use crate::model::system::{Slot, System};
use crate::model::tangent::{Tangent, TangentScratch};
use crate::pencil::{MachineMode, Whirl, modes_about};
use crate::rest::rest;
use crate::sectors::Sector;
use crate::symmetry::{Symmetry, probe};
use laval_model::text;
use laval_model::text::{Arg, Argument};
use laval_num::complex::C64;
use laval_num::continuation::{Direction, End, Kind, Point, Settings, Test, Zero, trace};
use laval_num::dense::{Mat, dot, max_abs, norm};
use laval_num::newton::{Cause, Options, newton};
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, Ordering};

/// The request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Amplitudes of the leading deflection, m; `None` goes from a thousandth to four times the one at which the nonlinear parts show.
    pub amplitudes: Option<(f64, f64)>,
    /// Largest order; `None` chooses.
    pub harmonics: Option<usize>,
    /// Dropped over kept force harmonics that the choice accepts.
    pub truncation: f64,
    /// Most points of a family.
    pub max_points: usize,
    /// Most points in all.
    pub work: u64,
}

/// Where a family was begun.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Origin {
    /// At the linear mode of this number.
    Mode(usize),
    /// At the largest amplitude, beside the asymptote of this number.
    Asymptote(usize),
}

/// A free motion.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Motion {
    /// Amplitude of the leading harmonic, m.
    pub amplitude: f64,
    /// Whirl frequency, rad/s; negative backward where the machine has no preferred direction.
    pub frequency: f64,
    /// Drive that makes up for the losses, 1/s.
    pub drive: f64,
    /// Harmonics of the nonlinear coordinates.
    pub x: Vec<f64>,
    /// Dropped over kept force harmonics.
    pub truncation: f64,
    /// Scaled residual.
    pub residual: f64,
    /// Forces that do not balance, over the largest force of the nonlinear parts.
    pub defect: f64,
}

/// A family of free motions.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Family {
    /// Where it was begun.
    pub origin: Origin,
    /// Frequency at which it begins, rad/s: from a linear mode that at vanishing amplitude, where the drive makes up for the damping; else of its first motion.
    pub begins: f64,
    /// In order.
    pub motions: Vec<Motion>,
    /// Amplitudes at which it turns back.
    pub folds: Vec<f64>,
    /// Frequency (with the sign of the spin) equal to the spin speed: amplitudes with their brackets.
    pub synchronous: Vec<(f64, (f64, f64))>,
    /// How it ended.
    pub end: End,
    /// Its frequency vanishes beyond the last motion: no restoring force is left there, and no whirl.
    pub vanishes: bool,
    /// Leading unknown of the harmonics.
    pub lead: usize,
}

/// A linear mode and what became of it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct LinearMode {
    /// growth + i frequency; negative frequency backward where the machine has no preferred direction.
    pub value: C64,
    /// Its direction.
    pub whirl: Whirl,
    /// Why no family begins here.
    #[serde(deserialize_with = "laval_num::text::optional")]
    pub left: Option<laval_num::text::Text>,
}

/// A frequency at which the amplitude of a hardening machine is infinite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Asymptote {
    /// growth + i frequency, as for modes.
    pub value: C64,
}

/// All families at one speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Backbone {
    /// Linear modes, by frequency.
    pub modes: Vec<LinearMode>,
    /// Asymptotes, by frequency.
    pub asymptotes: Vec<Asymptote>,
    /// Families.
    pub families: Vec<Family>,
    /// Discretisation used.
    pub discretisation: Discretisation,
    /// Range of amplitudes, m.
    pub amplitudes: (f64, f64),
    /// Newton iterations.
    pub iterations: u64,
    /// Families were left out: stopped on request, or the points allowed were used up.
    pub stopped: bool,
}

impl Backbone {
    /// Points of all families.
    pub fn points(&self) -> u64 {
        self.families.iter().map(|f| f.motions.len() as u64).sum()
    }
}

/// Largest order the automatic choice goes to.
pub const MOST_HARMONICS: usize = 31;

/// A backward and a forward mode this near to each other, relative to their value or to the largest of all, are one motion and its mirror image: so exact
/// are eigenvalues.
const MIRRORED: (f64, f64) = (1e-9, 1e-12);

/// Share of its first frequency at which a family ends: through frequency zero the equations go on to its mirror image.
const VANISHED: f64 = 0.01;

/// Modes that decay faster than this part of their frequency do not whirl freely.
const LIGHT: f64 = 0.3;

/// Share of the least amplitude at which the nonlinear parts add nothing to the frequency.
const VANISHING: f64 = 1e-3;

/// Whether free motions of this machine can be sought.
///
/// # Errors
/// No nonlinear part; a part that forces the motion; a part without rest.
pub fn admit(system: &System, speed: f64) -> Result<(), Diagnostic> {
    if system.slots().iter().all(Slot::is_linear) {
        return Err(Diagnostic::error(
            "free.linear",
            text!("all parts of this machine are linear: its free whirls have the same frequency at any amplitude"),
        )
        .help(text!("use modes or campbell for these frequencies")));
    }
    autonomous(system, speed)?;
    rest(system, speed).map(drop)
}

/// The discretisation of free motions with orders up to `harmonics`, in the largest symmetry of the machine.
pub fn discretisation(system: &System, speed: f64, harmonics: usize) -> Discretisation {
    let (found, _) = probe(system, &[speed]);
    let symmetry = if Nonlinear::of(system).paired { found } else { Symmetry::None };
    let harmonics = if symmetry == Symmetry::Circular { 1 } else { harmonics };
    Discretisation { harmonics, divisor: 1, samples: Terms::samples(harmonics, 1), symmetry }
}

/// Orders tried one after the other.
pub(super) fn next_order(h: usize) -> usize {
    if h < 15 { h + 4 } else { h + 8 }
}

/// Computes all families.
///
/// # Errors
/// As [`admit`], and modes that cannot be computed.
pub fn backbone<'a>(system: &'a System, request: &Request, cancel: &'a AtomicBool, tick: &dyn Fn(u64)) -> Result<Backbone, Diagnostic> {
    admit(system, request.speed)?;
    let mut harmonics = request.harmonics.unwrap_or(7);
    let mut left = request.work;
    loop {
        let d = discretisation(system, request.speed, harmonics);
        let mut found = attempt(system, &Request { work: left, ..*request }, d, cancel, tick)?;
        left = left.saturating_sub(found.points());
        found.stopped |= cancel.load(Ordering::Relaxed);
        let worst = found.families.iter().flat_map(|f| &f.motions).fold(0.0, |m: f64, p| if p.truncation <= m { m } else { p.truncation });
        let more = next_order(harmonics);
        let stopped = found.stopped || left == 0;
        if request.harmonics.is_some()
            || d.symmetry == Symmetry::Circular
            || worst <= request.truncation
            || more > MOST_HARMONICS
            || stopped
        {
            return Ok(found);
        }
        harmonics = more;
    }
}

/// Modes of a machine at rest that a free motion of this symmetry can begin with: signed frequencies where it has no preferred direction.
pub(super) fn linear_modes(system: &System, speed: f64) -> Result<Vec<MachineMode>, Diagnostic> {
    let about = rest(system, speed)?;
    Ok(modes_about(system, &about, true)?.modes)
}

/// A mode runs against the axes' sense, in a machine without preferred direction.
pub(super) fn backward(mode: &MachineMode, symmetry: Symmetry) -> bool {
    matches!(symmetry, Symmetry::Circular | Symmetry::Quarter) && mode.sector == Some(Sector::Backward)
}

fn attempt<'a>(
    system: &'a System,
    request: &Request,
    d: Discretisation,
    cancel: &'a AtomicBool,
    tick: &dyn Fn(u64),
) -> Result<Backbone, Diagnostic> {
    let speed = request.speed;
    let modes = linear_modes(system, speed)?;
    let fastest = modes.iter().map(|m| m.frequency()).fold(1.0, f64::max);
    let probe = Balance::new(system, d, (0.5 * fastest, fastest), Some(cancel))?;
    let natural = natural_amplitude(&probe).unwrap_or(1e-3);
    let (from, to) = request.amplitudes.unwrap_or((1e-3 * natural, 4.0 * natural));
    let mut out = Backbone {
        modes: Vec::new(),
        asymptotes: Vec::new(),
        families: Vec::new(),
        discretisation: d,
        amplitudes: (from, to),
        iterations: 0,
        stopped: false,
    };
    let forward = |m: &MachineMode| m.sector == Some(Sector::Forward);
    let largest = modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
    let mirrored = |m: &MachineMode| (MIRRORED.0 * m.value.abs()).max(MIRRORED.1 * largest);
    for mode in &modes {
        let turned = backward(mode, d.symmetry);
        let value = if turned { mode.value.conj() } else { mode.value };
        let paired = modes.iter().any(|m| (m.value + mode.value.conj()).abs() <= 1e-7 * mode.value.abs());
        // a band of an undamped machine has pairs that grow and decay alike
        let band = paired && mode.growth().abs() > 1e-6 * mode.value.abs();
        let mut left = match () {
            () if !(mode.frequency() > 1e-9 * fastest) => Some("does not oscillate"),
            () if !matches!(d.symmetry, Symmetry::None) && mode.sector == Some(Sector::Axial) => Some("moves along or about the axis"),
            () if band => Some("inside an instability band, where two linear modes have merged"),
            () if mode.growth().abs() > LIGHT * mode.frequency() => Some("decays or grows too fast to whirl"),
            () if turned && modes.iter().any(|m| forward(m) && (m.value - mode.value).abs() <= mirrored(mode)) => {
                Some("the mirror image of the forward one")
            }
            () => None,
        };
        if left.is_none() {
            let mut free = Free::new(system, d, (0.25 * to, mode.frequency()), speed, Some(cancel))?;
            match free.shape(&mode.q, turned, from) {
                None => left = Some("does not deflect the nonlinear parts"),
                Some(mut x) => {
                    let still = static_harmonics(&free, system, speed);
                    x.iter_mut().zip(still.iter().flatten()).for_each(|(x, s)| *x += s);
                    x.extend([value.im, -2.0 * value.re]);
                    let options = Options { to_rounding: true, ..Options::default() };
                    let near = newton(&mut free, &mut x, from, &options).is_ok()
                        && defect(&mut free, &x, from) <= BALANCED
                        && (free.quantities(&x, from)[1] - value.im).abs() < 0.2 * value.im.abs();
                    if near {
                        let origin = Origin::Mode(out.modes.len());
                        let small = free.shape(&mode.q, turned, VANISHING * from.min(natural));
                        let begins = small.and_then(|mut small| {
                            small.iter_mut().zip(still.iter().flatten()).for_each(|(x, s)| *x += s);
                            small.extend(&x[free.harmonics()..]);
                            vanishing(&mut free, small, VANISHING * from.min(natural), value.im)
                        });
                        let before = out.families.len();
                        follow(&mut free, &x, (from, Direction::Up), request, origin, &mut out)?;
                        if let (Some(f), Some(begins)) = (out.families.get_mut(before), begins) {
                            f.begins = begins;
                        }
                        tick(out.points());
                    } else {
                        left = Some("has no free motion of the smallest amplitude near it");
                    }
                }
            }
        }
        out.modes.push(LinearMode { value, whirl: mode.whirl, left });
    }
    out.asymptotes = asymptotes(system, d, speed, fastest)?;
    for k in 0..out.asymptotes.len() {
        from_infinity(system, d, request, k, &mut out, cancel)?;
        tick(out.points());
    }
    Ok(out)
}

/// Order-zero harmonics of the equilibrium, where the symmetry admits any.
pub(super) fn static_harmonics(free: &Free, system: &System, speed: f64) -> Option<Vec<f64>> {
    let about = rest(system, speed).ok()?;
    let rows = &free.balance.nonlinear.basis.rows;
    let mut u: Vec<C64> = rows.iter().map(|r| laval_num::complex::c(r.iter().map(|&(g, x)| about.q[g] * x).sum(), 0.0)).collect();
    u.extend(free.balance.nonlinear.states.iter().map(|&s| laval_num::complex::c(about.z[s], 0.0)));
    let mut x = vec![0.0; free.harmonics()];
    free.balance.terms.add_amplitudes(0, &u, &mut x);
    Some(x)
}

/// Frequency of the free motion at a vanishing amplitude, from an estimate of it; none where Newton's method leads away from the mode.
fn vanishing(free: &mut Free, mut x: Vec<f64>, amplitude: f64, mode: f64) -> Option<f64> {
    newton(free, &mut x, amplitude, &Options { to_rounding: true, ..Options::default() }).ok()?;
    let found = free.quantities(&x, amplitude)[1];
    (defect(free, &x, amplitude) <= BALANCED && (found - mode).abs() < 0.2 * mode.abs()).then_some(found)
}

/// Follows a family from a motion at an amplitude, as far as the points allowed in all reach.
fn follow(
    free: &mut Free,
    start: &[f64],
    (at, direction): (f64, Direction),
    request: &Request,
    origin: Origin,
    out: &mut Backbone,
) -> Result<(), Diagnostic> {
    let (from, to) = out.amplitudes;
    let left = usize::try_from(request.work.saturating_sub(out.points())).unwrap_or(usize::MAX);
    if left < 2 {
        out.stopped = true;
        return Ok(());
    }
    let max_points = request.max_points.min(left);
    let settings = Settings { max_points, max_parameter_step: (to - from) / 25.0, ..Settings::new(from, to) };
    let speed = request.speed;
    let first = free.quantities(start, at)[1];
    let mut tests: [Test<'_, Free>; 2] = [
        Box::new(move |free: &mut Free, p: &Point| free.quantities(&p.x, p.p)[1] - speed),
        Box::new(move |free: &mut Free, p: &Point| free.quantities(&p.x, p.p)[1] / first - VANISHED),
    ];
    let branch = trace(free, start, at, direction, &settings, &mut tests)
        .map_err(|e| Diagnostic::error("backbone.settings", text!("the family cannot be followed: {e}", e)))?;
    out.iterations += branch.counters.work.iterations as u64;
    let cut = branch.of(Kind::User(1)).next().is_none() && branch.end == End::MaxPoints;
    out.stopped |= cut && left < request.max_points;
    let last = branch.of(Kind::User(1)).min_by(|a, b| a.point.s.total_cmp(&b.point.s));
    let within = |s: f64| last.is_none_or(|l| s <= l.point.s);
    let folds = branch.of(Kind::Fold).filter(|s| within(s.point.s)).map(|s| s.fold.as_ref().map_or(s.point.p, |f| f.p)).collect();
    let met = branch.of(Kind::User(0)).filter(|s| within(s.point.s));
    let synchronous = met.map(|s| (s.point.p, (s.bracket[0].p, s.bracket[1].p))).collect();
    let (mut motions, mut end) = (Vec::with_capacity(branch.points.len()), branch.end);
    if last.is_some() {
        end = End::Reached;
    }
    for p in branch.points.iter().take_while(|p| last.is_none_or(|l| p.s < l.point.s)).chain(last.map(|l| &l.point)) {
        let (x, residual) = polish(free, &p.x, p.p).unwrap_or_else(|| (p.x.clone(), p.residual));
        let m = motion(free, &x, p.p, residual);
        if !(m.defect <= BALANCED) {
            end = End::NewtonFailed { at: p.p, residual: m.defect, cause: Cause::Stalled };
            break;
        }
        motions.push(m);
    }
    let vanishes = last.is_some() && end == End::Reached;
    out.families.push(Family { origin, begins: first, motions, folds, synchronous, end, vanishes, lead: free.lead });
    Ok(())
}

/// Largest defect of forces, relative, of a motion. At a pole of the condensed stiffness its slope is infinite as well, and a residual measured in
/// steps of Newton's method vanishes without any balance.
const BALANCED: f64 = 1e-5;

/// Forces that do not balance, over the largest force of the nonlinear parts at unknowns `x`.
fn defect(free: &mut Free, x: &[f64], p: f64) -> f64 {
    let n = free.harmonics();
    let speed = free.place(x, p, None);
    let mut r = vec![0.0; n];
    match free.balance.eval(&x[..n], speed, &mut r, None, None) {
        Ok(()) => max_abs(&r) / free.balance.largest_force(),
        Err(_) => f64::NAN,
    }
}

fn motion(free: &mut Free, x: &[f64], amplitude: f64, residual: f64) -> Motion {
    let n = free.harmonics();
    let [_, frequency, drive] = free.quantities(x, amplitude);
    let speed = free.place(x, amplitude, None);
    free.balance.sample(&x[..n], speed);
    let truncation = free.balance.truncation();
    Motion { amplitude, frequency, drive, x: x[..n].to_vec(), truncation, residual, defect: defect(free, x, amplitude) }
}

/// A point solved to rounding at its parameter, unless that leads away.
pub(super) fn polish(free: &mut Free, x: &[f64], p: f64) -> Option<(Vec<f64>, f64)> {
    let mut y = x.to_vec();
    let done = newton(free, &mut y, p, &Options { to_rounding: true, ..Options::default() }).ok()?;
    let mut scale = vec![1.0; y.len()];
    free.scale(&mut scale);
    let near = x.iter().zip(&y).zip(&scale).all(|((a, b), s)| (a - b).abs() <= 1e-3 * s.max(a.abs()));
    near.then_some((y, done.residual))
}

/// A free motion at a given amplitude, from one nearby.
pub fn at_amplitude(system: &System, found: &Backbone, family: &Family, speed: f64, amplitude: f64) -> Option<Motion> {
    let near = family.motions.iter().min_by(|a, b| (a.amplitude - amplitude).abs().total_cmp(&(b.amplitude - amplitude).abs()))?;
    let mut free = Free::new(system, found.discretisation, (0.25 * found.amplitudes.1, near.frequency), speed, None).ok()?;
    free.lead = family.lead;
    let mut x = near.x.clone();
    x.extend([near.frequency, near.drive]);
    let done = newton(&mut free, &mut x, amplitude, &Options { to_rounding: true, ..Options::default() }).ok()?;
    Some(motion(&mut free, &x, amplitude, done.residual))
}

/// Modes of the machine with its nonlinear coordinates held, those of nonlinear parts without force.
///
/// # Errors
/// Eigenvalues that cannot be computed.
fn asymptotes(system: &System, d: Discretisation, speed: f64, fastest: f64) -> Result<Vec<Asymptote>, Diagnostic> {
    let lost = |why: Arg| Diagnostic::error("backbone.asymptotes", text!("the asymptotes could not be computed: {why}", why));
    let (q, z) = (vec![0.0; system.n()], vec![0.0; system.m()]);
    let at = At { q: &q, v: &q, a: &q, z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let (mut t, mut scratch) = (Tangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut t, &mut scratch, Slot::is_linear);
    let nonlinear = Nonlinear::of(system);
    let typical: Vec<f64> = system.coordinates().iter().map(|c| c.dof.typical).collect();
    let free = complement(&nonlinear.basis, &typical);
    if free.cols() == 0 {
        return Ok(Vec::new());
    }
    let left = free.transpose();
    for m in [&mut t.a, &mut t.v, &mut t.q] {
        *m = left.matmul(m).matmul(&free);
    }
    t.z = left.matmul(&t.z);
    for m in [&mut t.rate_q, &mut t.rate_v, &mut t.rate_a] {
        *m = m.matmul(&free);
    }
    let mut a = first_order(&t).ok_or_else(|| lost(Unassessed::Massless.argument()))?;
    let directed = matches!(d.symmetry, Symmetry::Circular | Symmetry::Quarter);
    let mut turn = 0.0;
    if directed {
        // seen from axes that turn faster than anything, all that turns at w in fixed axes has the frequency w - turn below zero
        turn = 2.0 * a.max_size().sqrt().max(2.0 * fastest);
        let quarter = coordinate_sectors(system)
            .times_quarter_turn(&Mat::from_fn(typical.len(), typical.len(), |i, j| if i == j { 1.0 } else { 0.0 }));
        let back = Mat::from_fn(free.cols(), free.rows(), |i, j| free[(j, i)] / (typical[j] * typical[j]));
        let own = back.matmul(&quarter.matmul(&free));
        let states = state_sectors(system, &(0..system.m()).collect::<Vec<_>>()).times_quarter_turn(&Mat::identity(system.m()));
        let k = free.cols();
        for (first, block) in [(0, &own), (k, &own), (2 * k, &states)] {
            for i in 0..block.rows() {
                for j in 0..block.cols() {
                    a[(first + i, first + j)] -= turn * block[(i, j)];
                }
            }
        }
    }
    // a spring of 1e-300 N/m is none, and the iteration for eigenvalues does not end on such numbers
    let none = 1e-60 * a.max_size();
    a.data_mut().iter_mut().filter(|x| x.abs() < none).for_each(|x| *x = 0.0);
    let values = laval_num::eig::eigenvalues(&a).map_err(|e| lost(e.argument()))?;
    let signed = values.into_iter().filter(|v| if directed { v.im < 0.0 } else { v.im > 0.0 });
    let mut out: Vec<Asymptote> = signed.map(|v| Asymptote { value: laval_num::complex::c(v.re, v.im + turn) }).collect();
    out.retain(|a| a.value.im.abs() > 1e-6 * fastest && a.value.re.abs() <= LIGHT * a.value.im.abs());
    out.sort_by_number(|a| a.value.im);
    out.dedup_by(|a, b| (a.value - b.value).abs() <= 1e-9 * b.value.abs());
    Ok(out)
}

/// Columns that span what the basis does not see, orthogonal in coordinates over their typical sizes.
fn complement(basis: &Basis, typical: &[f64]) -> Mat {
    let n = typical.len();
    let mut seen: Vec<Vec<f64>> = Vec::new();
    let project = |seen: &[Vec<f64>], v: &mut Vec<f64>| {
        for _ in 0..2 {
            for s in seen {
                let along = dot(s, v);
                v.iter_mut().zip(s).for_each(|(v, s)| *v -= along * s);
            }
        }
    };
    let keep = |seen: &mut Vec<Vec<f64>>, mut v: Vec<f64>, least: f64| {
        project(seen, &mut v);
        let length = norm(&v);
        if length > least {
            v.iter_mut().for_each(|v| *v /= length);
            seen.push(v);
        }
    };
    for row in &basis.rows {
        let mut v = vec![0.0; n];
        row.iter().for_each(|&(g, x)| v[g] += x * typical[g]);
        let length = norm(&v);
        v.iter_mut().for_each(|v| *v /= length);
        keep(&mut seen, v, 1e-12);
    }
    let held = seen.len();
    // the unit vector that is seen least, until all directions are there
    while seen.len() < n {
        let rest = |g: usize| {
            let mut v = vec![0.0; n];
            v[g] = 1.0;
            project(&seen, &mut v);
            norm(&v)
        };
        let Some(best) = (0..n).max_by(|&a, &b| rest(a).total_cmp(&rest(b))) else { break };
        let mut v = vec![0.0; n];
        v[best] = 1.0;
        keep(&mut seen, v, 0.0);
    }
    Mat::from_fn(n, n - held, |i, j| seen[held + j][i] * typical[i])
}

/// The family that has the largest amplitude requested near an asymptote, unless it is known.
fn from_infinity(
    system: &System,
    d: Discretisation,
    request: &Request,
    k: usize,
    out: &mut Backbone,
    cancel: &AtomicBool,
) -> Result<(), Diagnostic> {
    let (speed, (_, to)) = (request.speed, out.amplitudes);
    let value = out.asymptotes[k].value;
    let drive = -2.0 * value.re;
    let mut free = Free::new(system, d, (0.25 * to, value.im), speed, Some(cancel))?;
    let n = free.harmonics();
    // near the pole the stiffness is the product of one vector with itself: the deflection lies along it
    let mut jac = Mat::zeros(n, n);
    let mut r = vec![0.0; n];
    free.balance.set_free(Pace { speed, frequency: value.im * (1.0 + 1e-7), drive, rate: [0.0; 3], parameter: None });
    if free.balance.eval(&vec![0.0; n], speed, &mut r, Some(&mut jac), None).is_err() {
        return Ok(());
    }
    let mut shape: Vec<f64> = vec![0.0; n];
    for &(term, at) in &free.balance.terms.list {
        if term.order().unsigned_abs() == 1 {
            shape[at] = 1.0 + 0.1 * at as f64;
        }
    }
    for _ in 0..3 {
        shape = jac.mul_vec(&shape);
        let length = norm(&shape);
        shape.iter_mut().for_each(|s| *s /= length);
    }
    if !shape.iter().all(|s| s.is_finite()) || free.lead_with(&mut shape, to).is_none() {
        return Ok(());
    }
    let mut along = |w: f64| -> f64 {
        free.balance.set_free(Pace { speed, frequency: w, drive, rate: [0.0; 3], parameter: None });
        let mut r = vec![0.0; n];
        match free.balance.eval(&shape, speed, &mut r, None, None) {
            Ok(()) => dot(&r, &shape),
            Err(_) => f64::NAN,
        }
    };
    let mut starts = Vec::new();
    for side in [1.0, -1.0] {
        let place = |e: f64| value.im * (1.0 + side * e);
        let mut last: Option<(f64, f64)> = None;
        for step in 0..80 {
            let e = 10f64.powf(-8.0 + 0.1 * f64::from(step));
            if e > 0.5 {
                break;
            }
            let g = along(place(e));
            if let Some((e0, g0)) = last
                && (g0 < 0.0) != (g < 0.0)
            {
                let (mut a, mut b, sign) = (e0, e, g0 < 0.0);
                for _ in 0..50 {
                    let mid = 0.5 * (a + b);
                    if (along(place(mid)) < 0.0) == sign { a = mid } else { b = mid }
                }
                starts.push(place(0.5 * (a + b)));
                break;
            }
            last = Some((e, g));
        }
    }
    for w in starts {
        let mut x = shape.clone();
        x.extend([w, drive]);
        let options = Options { to_rounding: true, ..Options::default() };
        if newton(&mut free, &mut x, to, &options).is_err() || !(defect(&mut free, &x, to) <= BALANCED) {
            continue;
        }
        let frequency = x[n];
        let ends = out.families.iter().flat_map(|f| [f.motions.first(), f.motions.last()]).flatten();
        let same =
            |m: &Motion| (m.amplitude - to).abs() <= 1e-9 * to && (m.frequency.abs() - frequency.abs()).abs() <= 1e-6 * frequency.abs();
        let met = { ends }.any(same);
        if met || (frequency - value.im).abs() > 0.5 * value.im.abs() {
            continue;
        }
        follow(&mut free, &x, (to, Direction::Down), request, Origin::Asymptote(k), out)?;
    }
    Ok(())
}
