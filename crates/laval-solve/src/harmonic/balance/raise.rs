//! A motion at one speed reached by raising the load from nothing, where Newton's method finds none at full load.
//!
//! `r(x) + (1 - u) F = 0` with the residual r of the balance and the load F in it, followed in u from rest (u = 0) to the machine as it is (u = 1), through
//! folds if need be. From an equilibrium under constant loads F is the rotating load alone.

use crate::harmonic::balance::problem::Balance;
use laval_num::continuation::{Direction, End, Failure, Settings, Zero, trace};
use laval_num::dense::Mat;
use laval_num::newton::{Options, newton};

/// Points that may be spent on the way.
const MOST_POINTS: usize = 2000;

struct Raised<'b, 'a> {
    balance: &'b mut Balance<'a>,
    speed: f64,
    /// Constant loads act in full from the beginning.
    loaded: bool,
    load: Vec<f64>,
}

impl Zero for Raised<'_, '_> {
    fn dim(&self) -> usize {
        self.balance.dim()
    }
    fn scale(&self, out: &mut [f64]) {
        self.balance.scale(out);
    }
    fn parameter_scale(&self) -> f64 {
        1.0
    }
    fn eval(&mut self, x: &[f64], u: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_du: Option<&mut [f64]>) -> Result<(), Failure> {
        self.balance.eval(x, self.speed, r, jac, None)?;
        self.load.clone_from(&self.balance.load);
        if self.loaded {
            for &(term, at) in self.balance.terms.list.iter().filter(|(t, _)| t.order() == 0) {
                self.load[at..at + term.size()].fill(0.0);
            }
        }
        for (r, f) in r.iter_mut().zip(&self.load) {
            *r += (1.0 - u) * f;
        }
        if let Some(d) = dr_du {
            for (d, f) in d.iter_mut().zip(&self.load) {
                *d = -f;
            }
        }
        Ok(())
    }
    fn cancelled(&self) -> bool {
        self.balance.cancelled()
    }
}

/// The motion at this speed at the end of the way from rest, or from the unknowns of an equilibrium.
pub(in crate::harmonic) fn raised(balance: &mut Balance, speed: f64, equilibrium: Option<&Vec<f64>>) -> Option<Vec<f64>> {
    let start = equilibrium.cloned().unwrap_or_else(|| vec![0.0; balance.dim()]);
    let settings = Settings { max_points: MOST_POINTS, ..Settings::new(0.0, 1.0) };
    let mut problem = Raised { balance, speed, loaded: equilibrium.is_some(), load: Vec::new() };
    let way = trace(&mut problem, &start, 0.0, Direction::Up, &settings, &mut []).ok()?;
    let last = way.points.last().filter(|p| way.end == End::Reached && p.p == 1.0)?;
    let mut x = last.x.clone();
    newton(balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).ok()?;
    Some(x)
}
