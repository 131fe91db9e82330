//! What the studies say of a random machine, against its matrices.

use super::assembly::Assembly;
use super::machine::Machine;
use super::matrix::{C, Complex, Lu, Real, apply, c, eigenvalues, exponential, quotient, zeros};
use super::random::Random;
use laval::file;
use laval::model::field::RangeValue;
use laval::outcome::{Data, Outcome};
use laval::study::{Context, ErasedStudy, forced_response, modes, support};

/// Tolerated relative difference.
pub const TOLERANCE: f64 = 1e-8;
/// Rounding of an eigenvalue over the largest: two that lie close share it as its root.
const ROUNDING: f64 = 1e-12;
/// Distance from a root over the speed from which a step is taken.
const BESIDE: f64 = 1e-9;

type Verdict = Result<(), String>;

fn near(what: &str, is: f64, should: f64, allowed: f64) -> Verdict {
    let difference = (is - should).abs();
    // NaN fails
    if difference <= allowed {
        Ok(())
    } else {
        Err(format!("{what} is {is:e}, not {should:e} (allowed {allowed:.1e}, off by {difference:.1e})"))
    }
}

/// Runs one study block on the machine.
pub fn run(m: &Machine, study: &str) -> Result<Outcome, String> {
    let loaded = file::load(&(m.file() + "\n[[study]]\n" + study)).map_err(|d| format!("the file is refused: {d:?}"))?;
    let outcome =
        loaded.studies[0].study.run(&loaded.system, &Context::quiet("study")).map_err(|d| format!("the study is refused: {d}"))?;
    if outcome.end.is_complete() { Ok(outcome) } else { Err(format!("the study ended {:?}", outcome.end)) }
}

fn column(o: &Outcome, table: &str, name: &str) -> Result<Vec<f64>, String> {
    let t = o.find_table(table).ok_or(format!("no table {table}"))?;
    let column = t.column(name).ok_or(format!("no column {name} in {table}"))?;
    Ok((0..t.rows()).map(|i| column.number(i).unwrap_or(f64::NAN)).collect())
}

fn flags(o: &Outcome, table: &str, name: &str) -> Vec<bool> {
    match o.find_table(table).and_then(|t| t.column(name)).map(|c| &c.data) {
        Some(Data::Flag(x)) => x.clone(),
        _ => Vec::new(),
    }
}

/// The eigenvalues and how far each may be off: by rounding, and by more where others are close.
fn spectrum(a: &Assembly) -> Vec<(C, f64)> {
    let all = eigenvalues(&quotient(&a.e, &a.a));
    let largest = all.iter().map(|s| s.abs()).fold(0.0, f64::max);
    let gap = |i: usize| (0..all.len()).filter(|&j| j != i).map(|j| (all[j] - all[i]).abs()).fold(f64::INFINITY, f64::min);
    let rounding = ROUNDING * largest;
    (0..all.len()).map(|i| (all[i], (TOLERANCE * all[i].abs()).max(rounding * (largest / gap(i)).min(1.0 / ROUNDING.sqrt())))).collect()
}

/// Every eigenvalue, once: each beside one of the matrices', and their product over the whole plane that of the determinant.
pub fn same_modes(m: &Machine, o: &Outcome, w: f64, r: &mut Random) -> Verdict {
    let (growth, frequency) = (column(o, "modes", "growth")?, column(o, "modes", "frequency")?);
    let a = Assembly::new(m, w);
    let mut left = spectrum(&a);
    let largest = left.iter().map(|s| s.0.abs()).fold(0.0, f64::max);
    let mut found: Vec<C> = Vec::new();
    for (&g, &f) in growth.iter().zip(&frequency) {
        found.push(c(g, f));
        if f > 0.0 {
            found.push(c(g, -f));
        }
    }
    if found.len() != left.len() {
        return Err(format!("{} eigenvalues, not {}", found.len(), left.len()));
    }
    for s in &found {
        let by = |i: &usize| (left[*i].0 - *s).abs();
        let i = (0..left.len()).min_by(|i, j| by(i).total_cmp(&by(j))).ok_or("no eigenvalue")?;
        let (is, allowed) = left.swap_remove(i);
        if !((is - *s).abs() <= allowed) {
            return Err(format!("an eigenvalue is {s:?}, not {is:?} (allowed {allowed:.1e})"));
        }
    }
    let (size, direction) = Lu::new(a.complex_e()).determinant();
    let least = found.iter().map(|s| s.abs()).filter(|x| *x > 1e-9 * largest).fold(largest, f64::min);
    for _ in 0..4 {
        let s = C::cis(r.between(-1.2, 1.2)).scale(r.size(least, 2.0 * largest));
        let (is, turned) = Lu::new(a.at(s)).determinant();
        let (mut should, mut angle) = (size, direction);
        for &k in &found {
            should += (s - k).abs().ln();
            angle = angle * (s - k).scale(1.0 / (s - k).abs());
        }
        let near_root = found.iter().map(|k| (s - *k).abs()).fold(f64::INFINITY, f64::min);
        let allowed = TOLERANCE * found.len() as f64 + ROUNDING * largest / near_root;
        near("the logarithm of the determinant", should, is, allowed)?;
        near("its angle", (angle / turned).arg(), 0.0, allowed)?;
    }
    Ok(())
}

pub fn modes(m: &Machine, r: &mut Random) -> Verdict {
    same_modes(m, &run(m, "kind = \"modes\"")?, m.speed, r)
}

/// A machine that turns the other way, which files do not admit.
pub fn backwards(m: &Machine, r: &mut Random) -> Verdict {
    let loaded = file::load(&m.file()).map_err(|d| format!("the file is refused: {d:?}"))?;
    let study = modes::Modes { speed: -m.speed, about: support::About::Rest, threshold: 0.0, frequency: None };
    same_modes(m, &study.run(&loaded.system, &Context::quiet("modes")).map_err(|d| d.to_string())?, -m.speed, r)?;
    if !m.forced() {
        return Ok(());
    }
    let study = forced_response::ForcedResponse::over(RangeValue { from: -m.speed, to: -0.3 * m.speed, points: Some(5) });
    same_response(m, &study.run(&loaded.system, &Context::quiet("response")).map_err(|d| d.to_string())?)
}

fn same_response(m: &Machine, o: &Outcome) -> Verdict {
    let speeds = column(o, "response", "speed")?;
    let names = |what: &str| (0..m.bodies.len()).map(|i| column(o, "response", &format!("{what}.b{i}"))).collect::<Result<Vec<_>, _>>();
    let (forward, backward, phase) = (names("forward")?, names("backward")?, names("phase")?);
    let (major, minor) = (names("amplitude")?, names("minor")?);
    for (row, &w) in speeds.iter().enumerate() {
        let a = Assembly::new(m, w);
        let x = a.response(w);
        let i = c(0.0, 1.0);
        let circles: Vec<(C, C)> =
            a.first.iter().map(|&k| ((x[k] + i * x[k + 1]).scale(0.5), (x[k] - i * x[k + 1]).conj().scale(0.5))).collect();
        let largest = circles.iter().map(|(f, b)| f.abs() + b.abs()).fold(0.0, f64::max);
        let allowed = TOLERANCE * largest;
        for (k, (f, b)) in circles.iter().enumerate() {
            let what = |name: &str| format!("{name} of b{k} at {w} rad/s");
            near(&what("forward"), forward[k][row], f.abs(), allowed)?;
            near(&what("backward"), backward[k][row], b.abs(), allowed)?;
            near(&what("amplitude"), major[k][row], f.abs() + b.abs(), allowed)?;
            near(&what("minor"), minor[k][row], f.abs() - b.abs(), allowed)?;
            let turned = (C::cis(phase[k][row]) - f.scale(1.0 / f.abs())).abs() * f.abs();
            if largest > 0.0 && f.abs() > 1e-6 * largest {
                near(&what("phase"), turned, 0.0, allowed)?;
            }
        }
    }
    Ok(())
}

pub fn response(m: &Machine) -> Verdict {
    if !m.forced() {
        return Ok(());
    }
    same_response(
        m,
        &run(m, &format!("kind = \"forced_response\"\nspeed = {{ from = {:?}, to = {:?}, points = 9 }}", 0.2 * m.speed, 1.5 * m.speed))?,
    )
}

/// One step of Newton's method on `det(s E - A(W)) = 0` for two real unknowns, of which s and W are functions with these slopes.
fn step(m: &Machine, s: C, w: f64, slopes: [(C, f64); 2]) -> [f64; 2] {
    let a = Assembly::new(m, w);
    // from beside the root, where the matrix may be singular to the last digit
    let aside = BESIDE * w;
    let s = s + slopes[0].0.scale(aside);
    let h = 1e-4 * w;
    // by a rule of fourth order: tables are cubic in the speed
    let at = |f: f64| Assembly::new(m, w + f * h);
    let (p1, m1, p2, m2) = (at(1.0), at(-1.0), at(2.0), at(-2.0));
    let rows = (0..a.a.len()).map(|i| {
        let slope = |j: usize| (8.0 * (p1.a[i][j] - m1.a[i][j]) - (p2.a[i][j] - m2.a[i][j])) / (12.0 * h);
        (0..a.a.len()).map(|j| c(-slope(j), 0.0)).collect()
    });
    let by_speed: Complex = rows.collect();
    let lu = Lu::new(a.at(s));
    let (by_s, by_speed) = (lu.trace_of_quotient(&a.complex_e()), lu.trace_of_quotient(&by_speed));
    let slope = |(ds, dw): (C, f64)| by_s * ds + by_speed.scale(dw);
    let (p, q) = (slope(slopes[0]), slope(slopes[1]));
    let det = p.re * q.im - p.im * q.re;
    // 1 + p x + q y = 0
    [aside - q.im / det, p.im / det]
}

/// How often each multiple of the speed is met between own speeds: the count of frequencies above it changes by as many, or by two fewer.
pub fn critical_speeds(m: &Machine) -> Verdict {
    let (from, to) = (0.3 * m.speed, 1.5 * m.speed);
    let o = run(m, &format!("kind = \"critical_speeds\"\nspeed = {{ from = {from:?}, to = {to:?}, points = 60 }}"))?;
    let (speeds, growth) = (column(&o, "critical_speeds", "speed")?, column(&o, "critical_speeds", "growth")?);
    let located = flags(&o, "critical_speeds", "located");
    for (k, (&w, &g)) in speeds.iter().zip(&growth).enumerate() {
        if !located[k] {
            return Err(format!("the critical speed at {w} rad/s is not located"));
        }
        let all = spectrum(&Assembly::new(m, w));
        let largest = all.iter().map(|s| s.0.abs()).fold(0.0, f64::max);
        let s = c(g, w);
        // a root beside another is known to the root of the rounding only
        let (nearest, allowed) = all.iter().map(|x| ((x.0 - s).abs(), x.1)).min_by(|x, y| x.0.total_cmp(&y.0)).ok_or("no eigenvalue")?;
        if !(nearest <= allowed.max(TOLERANCE * largest)) {
            return Err(format!("at {w} rad/s no eigenvalue is near {s:?}: {nearest:e} away"));
        }
        if allowed <= TOLERANCE * largest {
            let [dg, dw] = step(m, s, w, [(c(1.0, 0.0), 0.0), (c(0.0, 1.0), 1.0)]);
            near(&format!("the step of the critical speed {w} rad/s"), dw.abs().max(dg.abs()), 0.0, TOLERANCE * w + ROUNDING * largest)?;
        }
    }
    let above = |w: f64| spectrum(&Assembly::new(m, w)).iter().filter(|s| s.0.im > w).count() as i64;
    let count = 24;
    let edge = |k: usize| {
        if k == 0 {
            from
        } else if k == count {
            to
        } else {
            from + (to - from) * (k as f64 + 0.123) / count as f64
        }
    };
    let mut before = above(from);
    for k in 1..=count {
        let (low, high) = (edge(k - 1), edge(k));
        let now = above(high);
        let here = speeds.iter().filter(|w| **w > low && **w <= high).count() as i64;
        let edge_case = speeds.iter().any(|w| (w - low).abs().min((w - high).abs()) < 1e-6 * high);
        if !edge_case && (here < (now - before).abs() || (here - (now - before)) % 2 != 0) {
            return Err(format!(
                "{here} critical speeds from {low} to {high} rad/s, where the count of frequencies above changes by {}",
                now - before
            ));
        }
        before = now;
    }
    Ok(())
}

pub fn stability_map(m: &Machine) -> Verdict {
    let (from, to) = (0.2 * m.speed, 1.5 * m.speed);
    let o = run(m, &format!("kind = \"stability_map\"\nspeed = {{ from = {from:?}, to = {to:?}, points = 12 }}"))?;
    let (speeds, growth) = (column(&o, "map", "speed")?, column(&o, "map", "growth")?);
    let mut unstable: Vec<(f64, bool)> = Vec::new();
    for (&w, &g) in speeds.iter().zip(&growth) {
        let all = spectrum(&Assembly::new(m, w));
        let largest = all.iter().map(|s| s.0.abs()).fold(0.0, f64::max);
        let top = all.iter().max_by(|x, y| x.0.re.total_cmp(&y.0.re)).ok_or("no eigenvalue")?;
        // any of a cluster may lead
        let allowed = all.iter().filter(|s| s.0.re >= top.0.re - s.1).map(|s| s.1).fold(ROUNDING * largest, f64::max);
        near(&format!("the largest growth at {w} rad/s"), g, top.0.re, allowed)?;
        if top.0.re.abs() > 10.0 * allowed {
            unstable.push((w, top.0.re > 0.0));
        }
    }
    let (edges, frequency) = (column(&o, "boundary", "speed")?, column(&o, "boundary", "frequency")?);
    let (at_edge, uncertain) = (column(&o, "boundary", "growth")?, column(&o, "boundary", "uncertainty")?);
    for k in 0..edges.len() {
        let (w, s) = (edges[k], c(at_edge[k], frequency[k]));
        let a = Assembly::new(m, w);
        let all = spectrum(&a);
        let largest = all.iter().map(|x| x.0.abs()).fold(0.0, f64::max);
        let sharp = all.iter().min_by(|x, y| (x.0 - s).abs().total_cmp(&(y.0 - s).abs())).is_some_and(|x| x.1 <= TOLERANCE * largest);
        if !sharp || uncertain[k] > TOLERANCE * w {
            continue;
        }
        let [_, dw] = step(m, c(0.0, frequency[k]), w, [(c(0.0, 1.0), 0.0), (c(0.0, 0.0), 1.0)]);
        let dw = if frequency[k] == 0.0 { real_step(m, w) } else { dw };
        near(&format!("the step of the boundary at {w} rad/s"), dw, 0.0, TOLERANCE * w)?;
    }
    for pair in unstable.windows(2) {
        let here = edges.iter().filter(|w| **w >= pair[0].0 && **w <= pair[1].0).count();
        if (here % 2 == 1) != (pair[0].1 != pair[1].1) {
            return Err(format!("{here} boundaries from {} to {} rad/s, between {} and {}", pair[0].0, pair[1].0, pair[0].1, pair[1].1));
        }
    }
    Ok(())
}

/// The same for a real root.
fn real_step(m: &Machine, w: f64) -> f64 {
    let h = 1e-5 * w;
    let value = |w: f64| Lu::new(Assembly::new(m, w).at(c(0.0, 0.0))).determinant();
    let (here, low, high) = (value(w), value(w - h), value(w + h));
    let rel = |x: (f64, C)| (x.0 - here.0).exp() * (x.1 / here.1).re;
    -2.0 * h / (rel(high) - rel(low))
}

/// The motion from a given start, against the exponential of the matrix.
pub fn transient(m: &Machine, r: &mut Random) -> Verdict {
    // what a memory holds at the start is not for the file to say
    if m.remembers() {
        return Ok(());
    }
    let w = m.speed;
    let a = Assembly::new(m, w);
    let size = a.e.len();
    let b = quotient(&a.e, &a.a);
    let growth = eigenvalues(&b).iter().map(|s| s.re).fold(0.0, f64::max);
    let duration = (r.between(1.0, 4.0) * std::f64::consts::TAU / w).min(3.0 / growth.max(1e-9));
    let points = 9;
    let amplitude = 1e-4;
    let mut names = Vec::new();
    for (i, _) in m.bodies.iter().enumerate() {
        let own: &[&str] = if m.tilts(i) { &["x", "y", "tilt_x", "tilt_y"] } else { &["x", "y"] };
        names.extend(own.iter().map(|d| format!("b{i}.{d}")));
    }
    let mut states = names.clone();
    states.extend(names.iter().map(|n| format!("{n}'")));
    for (i, j) in m.joints.iter().enumerate() {
        if matches!(j.law, super::machine::Law::Liquid { .. }) {
            states.extend(["flow_x", "flow_y", "surface_x", "surface_y"].map(|s| format!("j{i}.{s}")));
        }
    }
    let rate = |k: usize| {
        if (names.len()..2 * names.len()).contains(&k) || (k >= 2 * names.len() && (k - 2 * names.len()) % 4 < 2) { w } else { 1.0 }
    };
    let start: Vec<f64> = (0..size).map(|k| amplitude * rate(k) * r.between(-1.0, 1.0)).collect();
    let initial: Vec<String> = states.iter().zip(&start).map(|(n, x)| format!("\"{n}\" = {x:?}")).collect();
    let o = run(
        m,
        &format!(
            "kind = \"transient\"\nduration = {duration:?}\npoints = {points}\nrelative_tolerance = 1e-12\nabsolute_tolerance = 1e-14\nobservables = false\n\
             initial = {{ {} }}",
            initial.join(", ")
        ),
    )?;
    // x' = b x + c1 cos + c2 sin + c3, with the load's harmonics and one as states of their own; times count in turns of the fastest part
    let mut big = zeros(size + 3, size + 3);
    let load = |f: &dyn Fn(usize) -> f64| quotient(&a.e, &(0..size).map(|i| vec![f(i)]).collect::<Real>());
    let parts = [load(&|i| a.turning[i].re), load(&|i| -a.turning[i].im), load(&|i| a.steady[i])];
    let h = duration / (points - 1) as f64;
    for i in 0..size {
        (0..size).for_each(|j| big[i][j] = h * b[i][j] * rate(j) / rate(i));
        (0..3).for_each(|k| big[i][size + k] = h * parts[k][i][0] / rate(i) / amplitude);
    }
    (big[size][size + 1], big[size + 1][size]) = (-h * w, h * w);
    let advance = exponential(&big);
    let mut x: Vec<f64> = start.iter().enumerate().map(|(k, x)| x / rate(k) / amplitude).chain([1.0, 0.0, 1.0]).collect();
    let mut path = vec![x.clone()];
    for _ in 1..points {
        x = apply(&advance, &x);
        path.push(x.clone());
    }
    let kinds = |n: &str| n.contains("tilt");
    for (k, n) in names.iter().enumerate() {
        let found = column(&o, "motion", n)?;
        // among the coordinates of its kind
        let alike = (0..names.len()).filter(|&j| kinds(&names[j]) == kinds(n));
        let largest = alike.flat_map(|j| path.iter().map(move |x| x[j].abs())).fold(0.0, f64::max) * amplitude;
        for (i, x) in path.iter().enumerate() {
            near(&format!("{n} at output {i}"), found[i], x[k] * amplitude, TOLERANCE * largest)?;
        }
    }
    Ok(())
}
