//! What happens inside an accepted step of one lane: outputs and events.

use super::method::Method;
use super::{EnsembleProblem, Roster, Seat};
use crate::lanes::{LANES, LaneScalar};
use crate::univariate::bracket;

/// Probes of every event in a step.
const PROBES: usize = 4;

/// Scratch of one lane's view, and the values of the events of all lanes.
pub(super) struct Inside {
    n: usize,
    /// State, relative and absolute tolerances.
    seat: Vec<f64>,
    /// Interpolants of the step in all lanes, and that of the lane looked at.
    interpolants: Vec<[f64; LANES]>,
    interpolant: Vec<f64>,
    y: Vec<f64>,
    events: usize,
    /// Values at the last probe, lane after lane.
    values: Vec<f64>,
    probe: Vec<f64>,
    crossing: [usize; LANES],
    found: Vec<(usize, f64)>,
}

impl Inside {
    pub fn new(n: usize, events: usize) -> Self {
        Inside {
            n,
            seat: vec![0.0; 3 * n],
            interpolants: vec![],
            interpolant: vec![],
            y: vec![0.0; n],
            events,
            values: vec![0.0; events * LANES],
            probe: vec![0.0; events],
            crossing: [0; LANES],
            found: vec![],
        }
    }
    pub fn seat(&mut self) -> Seat<'_> {
        let (y, tolerances) = self.seat.split_at_mut(self.n);
        let (relative, absolute) = tolerances.split_at_mut(self.n);
        Seat { y, relative, absolute }
    }
    pub fn state(&self) -> &[f64] {
        &self.seat[..self.n]
    }
    pub fn state_mut(&mut self) -> &mut [f64] {
        &mut self.seat[..self.n]
    }
    pub fn relative(&self) -> &[f64] {
        &self.seat[self.n..2 * self.n]
    }
    pub fn absolute(&self) -> &[f64] {
        &self.seat[2 * self.n..]
    }
    /// The event that ended the leg of a lane.
    pub fn crossing(&self, lane: usize) -> usize {
        self.crossing[lane]
    }

    /// Outputs and events at the start of a leg; `false` if something is not a number.
    pub fn begin<S: LaneScalar, C: EnsembleProblem<S>, M: Method<S>>(
        &mut self,
        lane: usize,
        problem: &mut C,
        roster: &mut Roster<S>,
        method: &M,
        t0: f64,
    ) -> bool {
        method.ends().state(lane, &mut self.y);
        let mut fine = self.y.iter().all(|x| x.is_finite());
        while fine && roster.next_output[lane] <= t0 {
            roster.give(lane, problem, &self.y);
        }
        for i in 0..self.events {
            let g = problem.event(lane, i, t0, &self.y);
            fine &= !g.is_nan();
            self.values[lane * self.events + i] = g;
        }
        fine
    }

    /// Keeps the interpolants of the step, which [`Inside::look`] reads.
    #[inline(always)]
    pub fn keep<S: LaneScalar, M: Method<S>>(&mut self, method: &M) {
        method.interpolants(&mut self.interpolants);
    }

    /// Gives the outputs and events of the step in order. `Some` is the time of the crossing that ends the leg, its state then is
    /// [`Inside::state`].
    pub fn look<S: LaneScalar, C: EnsembleProblem<S>, M: Method<S>>(
        &mut self,
        lane: usize,
        problem: &mut C,
        roster: &mut Roster<S>,
        t0: f64,
        t1: f64,
    ) -> Option<f64> {
        let wants = roster.next_output[lane] <= t1;
        if !wants && self.events == 0 {
            return None;
        }
        self.interpolant.clear();
        self.interpolant.extend(self.interpolants.iter().map(|of_lanes| of_lanes[lane]));
        let span = (t0, t1);
        let mut a = t0;
        for p in 1..=PROBES {
            if self.events == 0 {
                break;
            }
            let b = if p == PROBES { t1 } else { t0 + (t1 - t0) * (p as f64 / PROBES as f64) };
            self.locate::<S, C, M>(lane, problem, span, a, b);
            for k in 0..self.found.len() {
                let (index, t) = self.found[k];
                self.outputs_until::<S, C, M>(lane, problem, roster, span, t);
                M::eval(&self.interpolant, span, t, &mut self.y);
                if problem.crossed(lane, index, t, &self.y) {
                    self.crossing[lane] = index;
                    self.seat[..self.n].copy_from_slice(&self.y);
                    return Some(t);
                }
            }
            a = b;
        }
        self.outputs_until::<S, C, M>(lane, problem, roster, span, t1);
        None
    }

    fn outputs_until<S: LaneScalar, C: EnsembleProblem<S>, M: Method<S>>(
        &mut self,
        lane: usize,
        problem: &mut C,
        roster: &mut Roster<S>,
        span: (f64, f64),
        until: f64,
    ) {
        while roster.next_output[lane] <= until {
            M::eval(&self.interpolant, span, roster.next_output[lane], &mut self.y);
            roster.give(lane, problem, &self.y);
        }
    }

    /// Collects the crossings between the probes `a` and `b` in order of time. An event that is not a number crosses nothing.
    fn locate<S: LaneScalar, C: EnsembleProblem<S>, M: Method<S>>(
        &mut self,
        lane: usize,
        problem: &mut C,
        span: (f64, f64),
        a: f64,
        b: f64,
    ) {
        self.found.clear();
        M::eval(&self.interpolant, span, b, &mut self.y);
        for i in 0..self.events {
            self.probe[i] = problem.event(lane, i, b, &self.y);
        }
        for i in 0..self.events {
            let (ga, gb) = (self.values[lane * self.events + i], self.probe[i]);
            self.values[lane * self.events + i] = gb;
            if !((ga < 0.0 && gb >= 0.0) || (ga > 0.0 && gb <= 0.0)) {
                continue;
            }
            let (interpolant, y) = (&self.interpolant, &mut self.y);
            let zero = bracket(a, ga, b, gb, |t| {
                M::eval(interpolant, span, t, y);
                problem.event(lane, i, t, y)
            });
            if let Some((_, t)) = zero {
                self.found.push((i, t));
            }
        }
        self.found.sort_unstable_by(|p, q| p.1.total_cmp(&q.1).then(p.0.cmp(&q.0)));
    }
}

impl<S: LaneScalar> Roster<S> {
    /// Gives the output that is due and notes the next.
    fn give<C: EnsembleProblem<S>>(&mut self, lane: usize, problem: &mut C, y: &[f64]) {
        let (index, grid) = (self.output[lane], self.legs[lane].outputs);
        problem.output(lane, index, self.next_output[lane], y);
        self.output[lane] = index + 1;
        self.next_output[lane] = if index + 1 < grid.count { grid.time(index + 1) } else { f64::INFINITY };
    }
}
