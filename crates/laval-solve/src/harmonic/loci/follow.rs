//! A locus followed both ways from one point, cut off where it leaves the range of speeds.

use laval_num::continuation::{Direction, End, Invalid, Kind, Point, Refusal, Settings, Special, Test, Zero, trace};
use laval_num::newton::{Cause, Options, newton};
use serde::{Deserialize, Serialize};

/// How a locus ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum PathEnd {
    /// At an end of the parameter's range.
    Value,
    /// It leaves the range of speeds.
    Speed,
    /// Closed on itself.
    Closed,
    /// No further point was found.
    Stuck(#[serde(deserialize_with = "laval_num::text::one")] laval_num::text::Text),
    /// As many points as allowed.
    MaxPoints,
    /// Stopped by the user.
    Cancelled,
}

/// A place where the parameter turns back along a locus.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Turn {
    /// The place, by the extended system where that converged.
    pub y: Vec<f64>,
    /// The parameter there.
    pub value: f64,
    /// Tangent of the unknowns.
    pub tangent: Vec<f64>,
    /// Parameter of corrected points on both sides.
    pub bracket: (f64, f64),
    /// Scaled residual.
    pub residual: f64,
    /// Difference of the parameter between location along the locus and the extended system; NaN when the second found nothing.
    pub methods_differ: f64,
    /// Both agree.
    pub confirmed: bool,
    /// The speed turns back as well: a cusp.
    pub speed_turns: bool,
    /// Parts of the scaled tangent at the place located: speed, parameter.
    pub slopes: [f64; 2],
    /// The locus lies at larger values of the parameter.
    pub opens_up: bool,
    /// It lies between this point and the next.
    pub after: usize,
}

/// A followed locus.
#[derive(Clone, Debug)]
pub struct Path {
    /// Points in order; the parameter is `p`.
    pub points: Vec<Point>,
    /// Places where the parameter turns back.
    pub turns: Vec<Turn>,
    /// How it ends at the first and at the last point.
    pub ends: [PathEnd; 2],
    /// Index of the point it was started from.
    pub start: usize,
    /// Points computed.
    pub work: u64,
}

/// One way from the start.
struct Leg {
    points: Vec<Point>,
    specials: Vec<Special>,
    end: PathEnd,
}

fn leg<P: Zero>(
    problem: &mut P,
    y: &[f64],
    value: f64,
    direction: Direction,
    speed: usize,
    (lo, hi): (f64, f64),
    settings: &Settings,
) -> Result<Leg, Invalid> {
    let wide = hi - lo;
    let mut tests: Vec<Test<'_, P>> =
        vec![Box::new(move |_, p: &Point| (p.x[speed] - lo) / wide), Box::new(move |_, p: &Point| (hi - p.x[speed]) / wide)];
    let mut branch = trace(problem, y, value, direction, settings, &mut tests)?;
    let out = branch.specials.iter().find(|s| matches!(s.kind, Kind::User(_))).cloned();
    if let Some(out) = out {
        branch.points.truncate(out.after + 1);
        branch.points.push(out.point);
        branch.specials.retain(|s| s.point.s < branch.points[out.after + 1].s && s.kind == Kind::Fold);
        return Ok(Leg { points: branch.points, specials: branch.specials, end: PathEnd::Speed });
    }
    let end = match branch.end {
        End::Reached => PathEnd::Value,
        End::Closed => PathEnd::Closed,
        End::MaxPoints => PathEnd::MaxPoints,
        End::Cancelled => PathEnd::Cancelled,
        End::NewtonFailed { cause: Cause::Undefined(why), .. } => PathEnd::Stuck(why),
        End::NewtonFailed { .. } => PathEnd::Stuck("its start did not converge"),
        End::StepTooSmall { why: Refusal::Corrector(Cause::Undefined(why)), .. } => PathEnd::Stuck(why),
        End::StepTooSmall { .. } => PathEnd::Stuck("no further point was found, as where it meets another locus"),
    };
    branch.specials.retain(|s| s.kind == Kind::Fold);
    Ok(Leg { points: branch.points, specials: branch.specials, end })
}

/// Follows the locus through the unknowns `y` at a value of the parameter both ways; `speed` is the index of the spin speed among the unknowns.
///
/// # Errors
/// A range that is none.
pub fn follow<P: Zero>(
    problem: &mut P,
    y: &[f64],
    value: f64,
    speed: usize,
    speeds: (f64, f64),
    settings: &Settings,
) -> Result<Path, Invalid> {
    let down = leg(problem, y, value, Direction::Down, speed, speeds, settings)?;
    let mut work = down.points.len() as u64;
    let (last, mut ends) = (down.points.len().saturating_sub(1), [down.end.clone(), down.end.clone()]);
    let (mut points, mut specials) = (down.points, down.specials);
    points.reverse();
    specials.reverse();
    specials.iter_mut().for_each(|s| s.after = last - 1 - s.after);
    if !points.is_empty() && !matches!(down.end, PathEnd::Closed | PathEnd::Cancelled) {
        let left = Settings { max_points: settings.max_points.saturating_sub(last).max(1), ..settings.clone() };
        let up = leg(problem, y, value, Direction::Up, speed, speeds, &left)?;
        work += up.points.len() as u64;
        ends[1] = up.end;
        points.extend(up.points.into_iter().skip(1));
        specials.extend(up.specials.into_iter().map(|s| Special { after: s.after + last, ..s }));
    }
    let mut scale = vec![1.0; problem.dim()];
    problem.scale(&mut scale);
    let turns = specials.iter().map(|s| turn(s, &points, speed, &scale)).collect();
    Ok(Path { points, turns, ends, start: last, work })
}

fn turn(s: &Special, points: &[Point], speed: usize, scale: &[f64]) -> Turn {
    let exact = s.fold.as_ref();
    let value = exact.map_or(s.point.p, |f| f.p);
    // along the locus, whichever way it was followed
    let way = |p: &Point| {
        let [a, b] = [&points[s.after].x, &points[s.after + 1].x];
        let chord: f64 = (0..scale.len()).map(|i| (b[i] - a[i]) * p.dx_ds[i] / (scale[i] * scale[i])).sum();
        p.dx_ds[speed] / scale[speed] * if chord < 0.0 { -1.0 } else { 1.0 }
    };
    let sides = [way(&points[s.after]), way(&points[s.after + 1])];
    let here = s.point.dx_ds[speed] / scale[speed];
    let speed_turns = sides[0] * sides[1] < 0.0 && here.abs() <= 1e-2 * sides[0].abs().max(sides[1].abs());
    let [a, b] = [points[s.after].p, points[s.after + 1].p];
    Turn {
        y: exact.map_or_else(|| s.point.x.clone(), |f| f.x.clone()),
        value,
        tangent: s.point.dx_ds.clone(),
        bracket: (s.bracket[0].p, s.bracket[1].p),
        residual: exact.map_or(s.residual.abs(), |f| f.residual),
        methods_differ: exact.map_or(f64::NAN, |f| f.p_difference),
        confirmed: s.status == laval_num::continuation::Status::Confirmed,
        speed_turns,
        slopes: [here, s.point.slope],
        opens_up: a.max(b) - value > value - a.min(b),
        after: s.after,
    }
}

/// Whether a path passes this speed at this value of the parameter, to a relative tolerance.
pub fn passes<P: Zero>(problem: &mut P, path: &Path, value: f64, at: f64, speed: usize, tolerance: f64) -> bool {
    passes_after(problem, path, value, at, speed, tolerance).is_some()
}

/// The same: the point of the path after which it does.
pub fn passes_after<P: Zero>(problem: &mut P, path: &Path, value: f64, at: f64, speed: usize, tolerance: f64) -> Option<usize> {
    let options = Options { step: 1e-7, residual: 1e-7, noise: 1e-7, loose_step: 1e-5, damped: false, ..Options::default() };
    let near = |found: f64, tolerance: f64| (found - at).abs() <= tolerance * at.abs();
    path.points.windows(2).position(|w| {
        let (a, b) = (&w[0], &w[1]);
        if (a.p - value) * (b.p - value) > 0.0 || a.p == b.p {
            return false;
        }
        let t = (value - a.p) / (b.p - a.p);
        let mut y: Vec<f64> = a.x.iter().zip(&b.x).map(|(a, b)| a + t * (b - a)).collect();
        near(y[speed], 0.05) && newton(problem, &mut y, value, &options).is_ok() && near(y[speed], tolerance)
    })
}
