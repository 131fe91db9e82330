//! Special points between two accepted points, located on corrected points in between.

use super::branch::{Kind, Point, Refusal, Side, Special, Status};
use super::branch_point::BranchPoint;
use super::fold::fold;
use super::problem::{Failure, Zero};
use super::step::{Node, Tracer, distance, hermite};
use crate::dense::Mat;
use crate::newton::{Cause, Options};

/// A user's test function of a point: a zero of it along the branch is a special point. NaN where it has no value.
pub type Test<'t, P> = Box<dyn FnMut(&mut P, &Point) -> f64 + 't>;

/// A problem with the test functions that are watched along its branches. Everything that follows branches sees problems as this, so that it is compiled once.
pub(super) trait Traced: Zero {
    fn tests(&self) -> usize;
    /// Value of a test function at a point.
    fn test(&mut self, k: usize, at: &Point) -> f64;
}

/// A problem beside its test functions.
pub(super) struct Tested<'a, 't, P> {
    pub problem: &'a mut P,
    pub tests: &'a mut [Test<'t, P>],
}

impl<P: Zero> Traced for Tested<'_, '_, P> {
    fn tests(&self) -> usize {
        self.tests.len()
    }
    fn test(&mut self, k: usize, at: &Point) -> f64 {
        self.tests[k](self.problem, at)
    }
}

impl<P: Zero> Zero for Tested<'_, '_, P> {
    fn dim(&self) -> usize {
        self.problem.dim()
    }
    fn scale(&self, out: &mut [f64]) {
        self.problem.scale(out);
    }
    fn parameter_scale(&self) -> f64 {
        self.problem.parameter_scale()
    }
    fn eval(&mut self, x: &[f64], p: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dp: Option<&mut [f64]>) -> Result<(), Failure> {
        self.problem.eval(x, p, r, jac, dr_dp)
    }
    fn monitors(&self) -> usize {
        self.problem.monitors()
    }
    fn monitor_width(&self) -> usize {
        self.problem.monitor_width()
    }
    fn monitor_scale(&self, out: &mut [f64]) {
        self.problem.monitor_scale(out);
    }
    fn measure(&mut self, x: &[f64], p: f64, out: &mut [f64]) -> Result<(), Failure> {
        self.problem.measure(x, p, out)
    }
    fn max_parameter_step(&mut self, x: &[f64], p: f64) -> f64 {
        self.problem.max_parameter_step(x, p)
    }
    fn cancelled(&self) -> bool {
        self.problem.cancelled()
    }
}

/// A special point with its node.
pub(super) struct Found {
    pub special: Special,
    pub node: Node,
}

/// Where a test function vanishes between two nodes.
pub(super) struct Zeroed {
    node: Node,
    value: f64,
    bracket: [Side; 2],
    narrow: bool,
}

/// Share of a step within which a zero of the slope lies on a branch point: as the determinant has it, and as its extended system does.
const BESIDE: (f64, f64) = (1e-5, 5e-2);

/// Roundings of the equations that may bend the branch beside a branch point.
const ROUNDINGS: f64 = 10.0;

/// Without the word of a fold's extended system.
fn narrowed(status: Status) -> Status {
    if status == Status::Confirmed { Status::Located } else { status }
}

/// Sign with zero on the positive side.
pub(super) fn differ(a: f64, b: f64) -> bool {
    (a < 0.0) != (b < 0.0) && !a.is_nan() && !b.is_nan()
}

/// Fraction of the way from `a` to `b` at which the cubic of the parameter through both has its slope closest to zero, if the slope
/// dips there to less than a quarter of its smaller end value.
fn dip(a: &Node, b: &Node) -> Option<f64> {
    let (sa, sb, h) = (a.slope(), b.slope(), distance(&a.y, &b.y));
    let p = a.y[a.y.len() - 1].abs().max(b.y[b.y.len() - 1].abs());
    // where the parameter hardly moves (the flank of an undamped resonance) slopes are rounding
    if differ(sa, sb) || h * sa.abs().max(sb.abs()) <= 1e3 * f64::EPSILON * p {
        return None;
    }
    let sign = if sa < 0.0 || sb < 0.0 { -1.0 } else { 1.0 };
    let mean = (b.y[b.y.len() - 1] - a.y[a.y.len() - 1]) / h;
    let (c0, c1, c2) = (sa * sign, (6.0 * mean - 4.0 * sa - 2.0 * sb) * sign, 3.0 * (sa + sb - 2.0 * mean) * sign);
    let u = -c1 / (2.0 * c2);
    (c2 > 0.0 && u > 0.0 && u < 1.0 && c0 + u * (c1 + u * c2) < 0.25 * sa.abs().min(sb.abs())).then_some(u.clamp(0.05, 0.95))
}

/// Beside an exact zero, over the bracket.
const NEAR: [f64; 3] = [1e-6, 1e-4, 1e-2];

impl Tracer<'_> {
    /// The point of the branch in the plane normal to the chord at fraction `u` of it, to rounding.
    pub fn between(&mut self, a: &Node, b: &Node, u: f64, node: &mut Node) -> Result<(), Cause> {
        let h = distance(&a.y, &b.y);
        let chord: Vec<f64> = a.y.iter().zip(&b.y).map(|(a, b)| (b - a) / h).collect();
        hermite(a, b, h, u, &mut node.y);
        let guess = node.y.clone();
        let o = Options { max_iterations: 15, damped: false, to_rounding: true, noise: 1e-13, ..self.settings.corrector.clone() };
        self.counters.located += 1;
        self.correct(node, &chord, &o)?;
        node.s = a.s + u * h;
        if distance(&guess, &node.y) <= 0.25 * h { Ok(()) } else { Err(Cause::Diverged) }
    }

    /// Zero of `g` between `a` and `b` by Chandrupatla's method (inverse quadratic steps within a bracket).
    pub(super) fn locate(&mut self, a: &Node, b: &Node, ends: [f64; 2], g: &mut dyn FnMut(&mut Self, &Node) -> f64) -> Zeroed {
        let scale = self.scale[self.n()];
        let side = |node: &Node, value| Side { s: node.s, p: node.p, dp_ds: node.slope() * scale, value };
        let [mut f1, mut f2] = ends;
        let (mut x1, mut x2) = (0.0, 1.0);
        let (mut s1, mut s2) = (side(a, f1), side(b, f2));
        let mut best = Zeroed {
            node: if f1.abs() <= f2.abs() { a } else { b }.clone(),
            value: f1.abs().min(f2.abs()),
            bracket: [s1, s2],
            narrow: true,
        };
        best.value = if f1.abs() <= f2.abs() { f1 } else { f2 };
        let (mut trial, width) = (Node::default(), 1e-12);
        let mut t: f64 = (f1 / (f1 - f2)).clamp(0.05, 0.95);
        for _ in 0..80 {
            let mut x = x1 + t * (x2 - x1);
            let mut end = self.between(a, b, x, &mut trial);
            if end == Err(Cause::Singular) {
                // exactly on a branch point: beside it will do
                x += 1e-6 * (x2 - x);
                end = self.between(a, b, x, &mut trial);
            }
            let f = end.map_or(f64::NAN, |()| g(self, &trial));
            if f.is_nan() {
                best.narrow = (x2 - x1).abs() <= 1e-6;
                break;
            }
            if f.abs() < best.value.abs() {
                best.value = f;
                best.node.copy_from(&trial);
            }
            let (x3, f3) = if differ(f, f1) { (x2, f2) } else { (x1, f1) };
            if differ(f, f1) {
                (x2, f2, s2) = (x1, f1, s1);
            }
            (x1, f1, s1) = (x, f, side(&trial, f));
            let least = 0.5 * width / (x2 - x1).abs();
            if f == 0.0 {
                // the other end of the bracket follows: what is exactly zero may be rounding
                for near in NEAR.map(|n| x1 + n * (x2 - x1)) {
                    let f = self.between(a, b, near, &mut trial).map_or(f64::NAN, |()| g(self, &trial));
                    if f != 0.0 && !f.is_nan() && !differ(f, f2) {
                        (x2, s2) = (near, side(&trial, f));
                        break;
                    }
                }
            }
            if least > 0.5 || f == 0.0 {
                break;
            }
            let (xi, phi) = ((x1 - x2) / (x3 - x2), (f1 - f2) / (f3 - f2));
            t = if 1.0 - (1.0 - xi).sqrt() < phi && phi < xi.sqrt() {
                f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
            } else {
                0.5
            };
            t = t.clamp(least, 1.0 - least);
        }
        best.bracket = if x1 <= x2 { [s1, s2] } else { [s2, s1] };
        best
    }

    pub(super) fn found(&self, zero: Zeroed, kind: Kind, ends: [f64; 2], after: usize) -> Found {
        let sharp = zero.value.abs() <= 1e-6 * ends[0].abs().max(ends[1].abs());
        let status = if zero.narrow && sharp { Status::Located } else { Status::Bracketed };
        let point = self.point(&zero.node);
        let special = Special { kind, point, after, bracket: zero.bracket, residual: zero.value, status, fold: None, crossing: None };
        Found { special, node: zero.node }
    }

    /// Nodes between `a` and `b` where the slope dips, so that two folds in one step are separated: two paths of halving at most.
    fn resolve(&mut self, a: &Node, b: &Node, depth: usize, out: &mut Vec<Node>) {
        let Some(u) = dip(a, b).filter(|_| depth < 25 && out.len() < 50) else { return };
        let mut node = Node::default();
        if self.between(a, b, u, &mut node).is_ok() {
            self.resolve(a, &node, depth + 1, out);
            out.push(node.clone());
            self.resolve(&node, b, depth + 1, out);
        }
    }

    /// Special points between `a` and `b`, in order. Refuses the step when the bordered determinant jumps through zero.
    pub fn scan(&mut self, a: &Node, b: &Node, after: usize, values: &[Vec<f64>; 2]) -> Result<Vec<Found>, Refusal> {
        let mut all = Vec::new();
        let mut crossing = None;
        if differ(a.determinant, b.determinant) {
            let ends = [a.determinant, b.determinant_as(a)];
            let zero = self.locate(a, b, ends, &mut |_, node| node.determinant_as(a));
            let (small, large) = (ends[0].abs().min(ends[1].abs()), ends[0].abs().max(ends[1].abs()));
            if zero.value.abs() > (0.1 * small).max(1e-9 * large) {
                return Err(Refusal::Reversal);
            }
            let mut found = self.found(zero, Kind::BranchPoint, ends, after);
            if let Some((exact, node)) = self.branch_point(a, b, &found.node) {
                self.place(&mut found, exact, node);
            }
            crossing = Some((found.node.clone(), found.special.crossing.clone()));
            all.push(found);
        }
        let mut inner = Vec::new();
        self.resolve(a, b, 0, &mut inner);
        let mut left = a;
        for right in inner.iter().chain([b]) {
            let ends = [left.slope(), right.slope()];
            if differ(ends[0], ends[1]) {
                let zero = self.locate(left, right, ends, &mut |_, node| node.slope());
                let mut found = self.found(zero, Kind::Fold, ends, after);
                self.confirm(&mut found.special);
                let (size, scale) = (b.s - a.s, self.scale[self.n()]);
                // a fold beside the branch point has a place of its own by its equations, which are solved at it too: not where their rounding reaches that far
                let own = |exact: &BranchPoint| {
                    let place = found.special.fold.as_ref().filter(|_| found.special.status == Status::Confirmed);
                    place.is_some_and(|f| (f.p - exact.p).abs() > (1e-9 * exact.p.abs().max(scale)).max(ROUNDINGS * f.p_error))
                };
                let near = |exact: &Option<BranchPoint>| match exact {
                    Some(exact) if !own(exact) => BESIDE.1,
                    _ => BESIDE.0,
                };
                let apart = |node: &Node| (node.s - found.node.s).abs() / size;
                if let Some((node, exact)) = crossing.as_ref().filter(|c| apart(&c.0) <= near(&c.1)) {
                    (found.special.kind, found.special.status) = (Kind::ParameterExtremum, narrowed(found.special.status));
                    found.special.fold = None;
                    if let Some(exact) = exact {
                        self.place(&mut found, exact.clone(), node.clone());
                    }
                }
                all.push(found);
            }
            left = right;
        }
        for k in 0..self.problem.tests() {
            let ends = [values[0][k], values[1][k]];
            if differ(ends[0], ends[1]) {
                let zero = self.locate(a, b, ends, &mut |tracer, node| {
                    let point = tracer.point(node);
                    tracer.problem.test(k, &point)
                });
                all.push(self.found(zero, Kind::User(k), ends, after));
            }
        }
        all.sort_by(|a, b| a.node.s.total_cmp(&b.node.s));
        Ok(all)
    }

    /// Puts a point where its extended system has it.
    fn place(&self, found: &mut Found, exact: BranchPoint, node: Node) {
        found.special.point = self.point(&node);
        (found.special.point.residual, found.special.point.error) = (exact.residual, exact.error);
        found.special.status = Status::Confirmed;
        found.special.crossing = Some(exact);
        found.node = node;
    }

    /// Solves the extended system of a fold from its located point and compares.
    fn confirm(&mut self, special: &mut Special) {
        let n = self.n();
        let point = &special.point;
        let Ok(exact) = fold(self.problem, &point.x, point.p, &point.dx_ds) else { return };
        let size = point.x.iter().zip(&self.scale).map(|(x, s)| (x / s).abs()).fold(1.0, f64::max);
        let close = exact.p_difference.abs() <= 1e-10 * point.p.abs().max(self.scale[n]) && exact.x_difference <= 1e-6 * size;
        if close && special.status == Status::Located {
            special.status = Status::Confirmed;
        }
        special.fold = Some(exact);
    }
}
