//! Correction onto a branch, its tangent, and the acceptance of one step.

use super::branch::{Counters, Point, Refusal};
use super::event::Traced;
use super::problem::{Failure, Zero};
use super::settings::Settings;
use crate::dense::{Mat, dot, norm};
use crate::newton::{Cause, Converged, FixedParameter, NotConverged, Options, Solver, System};
use crate::refill::refill;

/// A corrected point in scaled variables `y = (x / scale, p / parameter scale)`.
#[derive(Clone, Debug, Default)]
pub(super) struct Node {
    pub y: Vec<f64>,
    /// Unit tangent.
    pub t: Vec<f64>,
    pub s: f64,
    /// The parameter itself: exact on the edge of the range.
    pub p: f64,
    pub determinant: f64,
    /// Lengths of the rows that the determinant was divided by.
    pub weight: Vec<f64>,
    /// Monitored quantities and their derivative in arclength.
    pub m: Vec<f64>,
    pub dm: Vec<f64>,
    pub evidence: Evidence,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Evidence {
    pub iterations: usize,
    pub residual: f64,
    pub step: f64,
    pub rate: f64,
}

impl From<Converged> for Evidence {
    fn from(c: Converged) -> Self {
        Evidence { iterations: c.iterations, residual: c.residual, step: c.step, rate: c.rate }
    }
}

impl Node {
    pub fn copy_from(&mut self, o: &Node) {
        self.y.clone_from(&o.y);
        self.t.clone_from(&o.t);
        self.m.clone_from(&o.m);
        self.dm.clone_from(&o.dm);
        self.weight.clone_from(&o.weight);
        (self.s, self.p, self.determinant, self.evidence) = (o.s, o.p, o.determinant, o.evidence);
    }
    /// Parameter's component of the unit tangent.
    pub fn slope(&self) -> f64 {
        self.t[self.t.len() - 1]
    }
    /// Determinant with the rows divided by their lengths at `o`: smooth where a row vanishes.
    pub fn determinant_as(&self, o: &Node) -> f64 {
        self.weight.iter().zip(&o.weight).fold(self.determinant, |d, (w, o)| d * (w / o))
    }
    /// Turns the tangent round.
    pub fn turn(&mut self) {
        self.t.iter_mut().chain(&mut self.dm).for_each(|v| *v = -*v);
        self.determinant = -self.determinant;
    }
}

pub(super) fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// Point of the cubic through two nodes with their tangents, at fraction `u` of the chord of length `h`.
pub(super) fn hermite(a: &Node, b: &Node, h: f64, u: f64, out: &mut Vec<f64>) {
    let (u2, v) = (u * u, 1.0 - u);
    let (ha, hb) = ((1.0 + 2.0 * u) * v * v, u2 * (3.0 - 2.0 * u));
    let (ga, gb) = (h * u * v * v, -h * u2 * v);
    out.clear();
    out.extend((0..a.y.len()).map(|i| ha * a.y[i] + hb * b.y[i] + ga * a.t[i] + gb * b.t[i]));
}

/// Direction of that cubic there.
pub(super) fn heading(a: &Node, b: &Node, h: f64, u: f64) -> Vec<f64> {
    let (chord, ga, gb) = (6.0 * u * (1.0 - u) / h, (1.0 - u) * (1.0 - 3.0 * u), u * (3.0 * u - 2.0));
    (0..a.y.len()).map(|i| chord * (b.y[i] - a.y[i]) + ga * a.t[i] + gb * b.t[i]).collect()
}

/// `r(x, p) = 0` with the hyperplane `row . (y - anchor) = 0`.
struct Bordered<'a> {
    problem: &'a mut dyn Zero,
    scale: &'a [f64],
    row: &'a [f64],
    anchor: &'a [f64],
    scratch: &'a mut Scratch,
}

#[derive(Default)]
pub(super) struct Scratch {
    pub x: Vec<f64>,
    pub jac: Mat,
    pub dr_dp: Vec<f64>,
}

/// Residual and, in scaled variables, the `n` by `n + 1` Jacobian in the first rows of `jac`.
pub(super) fn extended(
    problem: &mut dyn Zero,
    scale: &[f64],
    y: &[f64],
    w: &mut Scratch,
    r: &mut [f64],
    jac: Option<&mut Mat>,
) -> Result<(), Failure> {
    let n = scale.len() - 1;
    w.x.clear();
    w.x.extend(y[..n].iter().zip(scale).map(|(y, s)| y * s));
    let p = y[n] * scale[n];
    let Some(jac) = jac else {
        return problem.eval(&w.x, p, &mut r[..n], None, None);
    };
    w.jac.reset(n, n);
    refill(&mut w.dr_dp, n, 0.0);
    problem.eval(&w.x, p, &mut r[..n], Some(&mut w.jac), Some(&mut w.dr_dp))?;
    for i in 0..n {
        let row = jac.row_mut(i);
        for ((a, j), s) in row.iter_mut().zip(w.jac.row(i)).zip(scale) {
            *a = j * s;
        }
        row[n] = w.dr_dp[i] * scale[n];
    }
    Ok(())
}

impl System for Bordered<'_> {
    fn size(&self) -> usize {
        self.scale.len()
    }
    fn eval(&mut self, y: &[f64], r: &mut [f64], mut jac: Option<&mut Mat>) -> Result<(), Failure> {
        let n = self.scale.len() - 1;
        extended(self.problem, self.scale, y, self.scratch, r, jac.as_deref_mut())?;
        r[n] = self.row.iter().zip(y).zip(self.anchor).map(|((t, y), a)| t * (y - a)).sum();
        if let Some(jac) = jac {
            jac.row_mut(n).copy_from_slice(self.row);
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.problem.cancelled()
    }
}

/// The problem with everything needed to move along its branches; all storage lives here.
pub(super) struct Tracer<'a> {
    pub problem: &'a mut dyn Traced,
    pub settings: &'a Settings,
    /// Scales of the unknowns and, last, of the parameter.
    pub scale: Vec<f64>,
    pub counters: Counters,
    pub solver: Solver,
    pub scratch: Scratch,
    monitor_scale: Vec<f64>,
    anchor: Vec<f64>,
    shifted: Vec<f64>,
    measured: Vec<f64>,
}

impl<'a> Tracer<'a> {
    pub fn new(problem: &'a mut dyn Traced, settings: &'a Settings) -> Self {
        let n = problem.dim();
        let mut scale = vec![1.0; n + 1];
        problem.scale(&mut scale[..n]);
        scale[n] = problem.parameter_scale();
        let mut monitor_scale = vec![1.0; problem.monitors() / problem.monitor_width().max(1)];
        problem.monitor_scale(&mut monitor_scale);
        Tracer {
            problem,
            settings,
            scale,
            counters: Counters::default(),
            solver: Solver::default(),
            scratch: Scratch::default(),
            monitor_scale,
            anchor: Vec::new(),
            shifted: Vec::new(),
            measured: Vec::new(),
        }
    }

    pub fn n(&self) -> usize {
        self.scale.len() - 1
    }

    /// Corrects `node.y` within the hyperplane through it normal to `row`; the new tangent makes an acute angle with `row`.
    pub fn correct(&mut self, node: &mut Node, row: &[f64], o: &Options) -> Result<(), Cause> {
        let n = self.n();
        self.anchor.clone_from(&node.y);
        let mut system =
            Bordered { problem: &mut *self.problem, scale: &self.scale, row, anchor: &self.anchor, scratch: &mut self.scratch };
        let done = self.solver.solve(&mut system, &mut node.y, o).map_err(|e| e.cause)?;
        node.p = node.y[n] * self.scale[n];
        node.evidence = done.into();
        self.tangent(node, norm(row))
    }

    /// Tangent from the factors of the bordered Jacobian whose last row had length `row`.
    fn tangent(&mut self, node: &mut Node, row: f64) -> Result<(), Cause> {
        let n = self.n();
        refill(&mut node.t, n + 1, 0.0);
        node.t[n] = 1.0 / row;
        self.solver.lu.solve(&mut node.t);
        let length = norm(&node.t);
        if !length.is_finite() || length == 0.0 {
            return Err(Cause::Singular);
        }
        node.t.iter_mut().for_each(|t| *t /= length);
        // the determinant is linear in the border, and border . t = 1 before t was normed
        node.determinant = self.solver.lu.det() * length * row;
        node.weight.clone_from(&self.solver.weight);
        Ok(())
    }

    /// Solves at a fixed parameter from `node.y`, then finds the tangent with positive slope.
    pub fn correct_at(&mut self, node: &mut Node, p: f64, o: &Options) -> Result<(), NotConverged> {
        let n = self.n();
        let mut system = FixedParameter { problem: &mut *self.problem, scale: &self.scale[..n], p, x: resized(&mut self.scratch.x, n) };
        let done = self.solver.solve(&mut system, &mut node.y[..n], o)?;
        node.y[n] = p / self.scale[n];
        let mut row = vec![0.0; n + 1];
        row[n] = 1.0;
        let mut probe = Node { y: node.y.clone(), ..Node::default() };
        let lost = |cause| NotConverged { cause, iterations: done.iterations, residual: done.residual, step: done.step };
        self.correct(&mut probe, &row, &Options { step: f64::INFINITY, residual: f64::INFINITY, to_rounding: false, ..o.clone() })
            .map_err(lost)?;
        node.t = probe.t;
        node.determinant = probe.determinant;
        node.weight = probe.weight;
        node.p = p;
        node.evidence = done.into();
        Ok(())
    }

    /// Monitored quantities and their rates.
    pub fn monitor(&mut self, node: &mut Node) -> Result<(), Failure> {
        let (n, count) = (self.n(), self.problem.monitors());
        if count == 0 {
            return Ok(());
        }
        let h = 1e-6;
        resized(&mut node.m, count);
        resized(&mut node.dm, count);
        self.shifted.clear();
        self.shifted.extend((0..n).map(|i| node.y[i] * self.scale[i]));
        self.problem.measure(&self.shifted, node.p, &mut node.m)?;
        self.shifted.clear();
        self.shifted.extend((0..n).map(|i| (node.y[i] + h * node.t[i]) * self.scale[i]));
        resized(&mut self.measured, count);
        self.problem.measure(&self.shifted, node.p + h * node.t[n] * self.scale[n], &mut self.measured)?;
        for ((d, a), b) in node.dm.iter_mut().zip(&node.m).zip(&self.measured) {
            *d = (b - a) / h;
        }
        if node.m.iter().chain(&node.dm).all(|v| v.is_finite()) {
            Ok(())
        } else {
            Err(Failure::Undefined("a monitored quantity is not finite"))
        }
    }

    /// Largest over the monitored vectors of |v(i)| relative to the vector's length at `node`.
    pub fn relative(&self, node: &Node, v: impl Fn(usize) -> f64) -> f64 {
        let width = self.problem.monitor_width().max(1);
        let mut worst = 0.0;
        for (k, scale) in self.monitor_scale.iter().enumerate() {
            let i = k * width..(k + 1) * width;
            let change = i.clone().map(|i| v(i) * v(i)).sum::<f64>().sqrt();
            let length = node.m[i].iter().map(|m| m * m).sum::<f64>().sqrt();
            let ratio = change / length.max(*scale);
            if ratio > worst || ratio.is_nan() {
                worst = ratio;
            }
        }
        worst
    }

    /// Longest step that monitored quantities, the problem's cap and the settings allow at `node`.
    pub fn cap(&mut self, node: &Node) -> f64 {
        let (n, set) = (self.n(), self.settings);
        let mut cap = set.max_step * norm(&node.y[..n]).max(1.0);
        let slope = node.slope().abs() * self.scale[n];
        cap = cap.min(set.max_parameter_step / slope);
        let limit = self.parameter_cap(node) / slope;
        let rate = self.relative(node, |i| node.dm[i]);
        let by_monitor = set.monitor_change / rate;
        for c in [limit, by_monitor] {
            if c < cap || c.is_nan() {
                cap = c;
            }
        }
        cap
    }

    fn parameter_cap(&mut self, node: &Node) -> f64 {
        let n = self.n();
        self.shifted.clear();
        self.shifted.extend((0..n).map(|i| node.y[i] * self.scale[i]));
        self.problem.max_parameter_step(&self.shifted, node.p)
    }

    /// Whether the step from `a` to `b`, predicted at `predicted`, may stand; if so, by how much its measures would let it grow.
    pub fn assess(&mut self, a: &Node, b: &Node, predicted: &[f64], ds: f64) -> Result<f64, Refusal> {
        let set = self.settings;
        let h = distance(&a.y, &b.y);
        let turn = dot(&a.t, &b.t);
        let along = |t: &[f64]| t.iter().zip(&a.y).zip(&b.y).map(|((t, a), b)| t * (b - a)).sum::<f64>() / h;
        let least = turn.min(along(&a.t)).min(along(&b.t));
        if least.is_nan() || least < set.min_cosine {
            return Err(Refusal::Angle);
        }
        let strayed = distance(&b.y, predicted);
        if strayed.is_nan() || strayed > 0.25 * ds {
            return Err(Refusal::Strayed);
        }
        let change = self.relative(a, |i| b.m[i] - a.m[i]).min(self.relative(b, |i| b.m[i] - a.m[i]));
        let slope = h * self.relative(b, |i| b.dm[i]);
        let monitored = change.max(0.5 * slope);
        if monitored.is_nan() || change.is_nan() || slope.is_nan() || monitored > 1.5 * set.monitor_change {
            return Err(Refusal::Monitor);
        }
        let moved = (b.p - a.p).abs();
        let cap = self.parameter_cap(b);
        if cap.is_nan() || moved > 2.0 * cap {
            return Err(Refusal::Parameter);
        }
        let angle = turn.clamp(-1.0, 1.0).acos();
        let grow = [0.7 * set.min_cosine.acos() / angle, (set.target_rate / b.evidence.rate).sqrt(), set.monitor_change / change];
        Ok(grow.into_iter().fold(2.0, f64::min).max(0.3))
    }

    /// The node in the problem's own units.
    pub fn point(&self, node: &Node) -> Point {
        let n = self.n();
        let own = |v: &[f64]| v[..n].iter().zip(&self.scale).map(|(v, s)| v * s).collect::<Vec<_>>();
        Point {
            s: node.s,
            p: node.p,
            x: own(&node.y),
            dp_ds: node.t[n] * self.scale[n],
            dx_ds: own(&node.t),
            slope: node.t[n],
            determinant: node.determinant,
            residual: node.evidence.residual,
            error: node.evidence.step,
            iterations: node.evidence.iterations,
        }
    }
}

pub(super) fn resized(v: &mut Vec<f64>, n: usize) -> &mut Vec<f64> {
    refill(v, n, 0.0);
    v
}
