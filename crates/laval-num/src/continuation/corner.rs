//! Corners of a branch: where the equations change their law (a contact closes) the Jacobian jumps, and the tangent with it.
//!
//! A corner shows itself by a tangent that turns by as much however short the step. The branch is followed up to the surface where the
//! law changes; the tangent beyond is the null vector of the Jacobian found there. Which way along it is known too: across the surface a
//! continuous residual changes its Jacobian by one dyad `d n'`, n the normal of the surface, so that `det [J; t'] n't` is the same on both
//! sides. The branch crosses (n't keeps its sign) when the determinant keeps its sign.

use super::branch::{Kind, Side, Special, Status};
use super::step::{Node, Tracer, distance, extended};
use crate::dense::{Lu, Mat, dot, norm};
use crate::newton::Options;
use crate::refill::refill;

/// Cosine of the least turn that counts as a corner, about 3 degrees: a step may turn by 10.
const SMOOTH: f64 = 0.9985;

/// Halvings of the way to a corner before the next approach.
const PROBES: usize = 6;

impl Tracer<'_> {
    /// Unit tangent and determinant of the law that holds at `y`, on the branch or beside it, in the direction that goes on from `a`.
    fn direction(&mut self, a: &Node, y: &[f64], out: &mut Node) -> Option<()> {
        let n = self.n();
        let (mut jac, mut r) = (Mat::zeros(n + 1, n + 1), vec![0.0; n + 1]);
        extended(self.problem, &self.scale, y, &mut self.scratch, &mut r, Some(&mut jac)).ok()?;
        out.weight.clear();
        for i in 0..n {
            let weight = norm(jac.row(i));
            jac.row_mut(i).iter_mut().for_each(|x| *x /= weight);
            out.weight.push(weight);
        }
        jac.row_mut(n).copy_from_slice(&a.t);
        out.weight.push(1.0);
        let lu = Lu::new(&jac).ok()?;
        refill(&mut out.t, n + 1, 0.0);
        out.t[n] = 1.0;
        lu.solve(&mut out.t);
        let length = norm(&out.t);
        out.determinant = lu.det() * length;
        // the border's tangent has an acute angle with that of `a`; the branch may go on at an obtuse one
        let along = if (out.determinant < 0.0) == (a.determinant < 0.0) { 1.0 } else { -1.0 };
        out.t.iter_mut().for_each(|t| *t *= along / length);
        out.determinant *= along;
        (length.is_finite() && out.determinant.is_finite() && out.determinant != 0.0).then_some(())
    }

    /// The corner within `reach` ahead of `a`, when there is one: the point of the branch there with the tangent before it, and the same
    /// point with the tangent beyond.
    pub fn corner(&mut self, a: &Node, reach: f64) -> Option<[Node; 2]> {
        let o = Options { max_iterations: 15, damped: false, to_rounding: true, noise: 1e-13, ..self.settings.corrector.clone() };
        let line = |a: &Node, at: f64| a.y.iter().zip(&a.t).map(|(y, t)| y + at * t).collect::<Vec<f64>>();
        let (mut beyond, mut probe) = (Node::default(), Node::default());
        self.direction(a, &line(a, reach), &mut beyond)?;
        if !(dot(&a.t, &beyond.t) < SMOOTH) {
            return None;
        }
        // from the branch itself, to rounding: straight on it is left by the square of the way only
        let mut before = a.clone();
        self.correct(&mut before, &a.t, &o).ok()?;
        let (mut reach, width) = (reach, 1e-12 * norm(&a.y).max(1.0));
        while reach > width {
            let (mut near, mut far, mut nearest) = (0.0, reach, before.t.clone());
            self.direction(&before, &line(&before, reach), &mut beyond)?;
            for _ in 0..PROBES {
                // the turn must not shrink with the way
                if !(dot(&nearest, &beyond.t) < SMOOTH) {
                    return None;
                }
                let middle = 0.5 * (near + far);
                self.direction(&before, &line(&before, middle), &mut probe)?;
                if dot(&before.t, &probe.t) > dot(&beyond.t, &probe.t) {
                    near = middle;
                    nearest.clone_from(&probe.t);
                } else {
                    far = middle;
                    beyond.copy_from(&probe);
                }
            }
            // closer along the branch, not so close that the line is beyond where the branch is not
            let at = 0.9 * near;
            if at > 0.0 {
                let mut closer = Node { y: line(&before, at), ..Node::default() };
                self.counters.located += 1;
                self.correct(&mut closer, &before.t, &o).ok()?;
                if !(dot(&before.t, &closer.t) > dot(&beyond.t, &closer.t).abs()) {
                    return None;
                }
                before = closer;
            }
            reach = 2.0 * (far - at);
        }
        let mut after = before.clone();
        (after.t, after.determinant, after.weight) = (beyond.t, beyond.determinant, beyond.weight);
        before.s = a.s + distance(&a.y, &before.y);
        after.s = before.s;
        self.monitor(&mut before).ok()?;
        self.monitor(&mut after).ok()?;
        Some([before, after])
    }

    /// What there is to say of a corner: itself, and a fold where the parameter turns back at it.
    pub fn corner_specials(&self, [before, after]: &[Node; 2], index: usize) -> Vec<Special> {
        let scale = self.scale[self.n()];
        let side = |node: &Node| Side { s: node.s, p: node.p, dp_ds: node.slope() * scale, value: node.slope() };
        let special = |kind| Special {
            kind,
            point: self.point(after),
            after: index,
            bracket: [side(before), side(after)],
            residual: before.evidence.residual,
            status: Status::Located,
            fold: None,
            crossing: None,
        };
        let turns = (before.slope() < 0.0) != (after.slope() < 0.0);
        [Kind::Corner].into_iter().chain(turns.then_some(Kind::Fold)).map(special).collect()
    }
}
