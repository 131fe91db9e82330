//! The linear parts of a machine by rows, for many evaluations at points of a motion; zeros are left out.

use super::linear::{LinearModel, Loads};
use super::part::At;
use laval_num::scalar::Scalar;

/// One entry: its column, and what multiplies places, places times speed, velocities and velocities times speed.
#[derive(Clone, Copy, Debug)]
struct Entry {
    column: usize,
    place: f64,
    place_speed: f64,
    rate: f64,
    rate_speed: f64,
}

/// A row with loads: constant ones, those on cosine and sine of the phase, and the same per spin acceleration.
#[derive(Clone, Copy, Debug)]
struct Load {
    row: usize,
    force: [f64; 3],
    spin_accel: [f64; 3],
}

/// The rows of a [`LinearModel`] without memory states at one speed, or of one whose matrices are the same at any.
#[derive(Clone, Debug, Default)]
pub struct LinearRows {
    /// Number of coordinates.
    n: usize,
    /// Speed of the loads, rad/s.
    speed: f64,
    /// The matrices are those of any speed, and loads that turn grow with its square.
    plain: bool,
    /// Where each row ends: of coordinates, then of states.
    ends: Vec<usize>,
    entries: Vec<Entry>,
    /// Row, column and value of what multiplies the spin acceleration.
    spin_accel: Vec<(usize, usize, f64)>,
    loads: Vec<Load>,
}

impl LinearRows {
    /// `plain` says that the matrices are those of any speed, and that loads that turn grow with its square. `None` where loads turn with other spins or there are memory states.
    pub fn new(model: &LinearModel<f64>, plain: bool) -> Option<Self> {
        let Loads { others, force, force_cos, force_sin, spin_accel_force, spin_accel_cos, spin_accel_sin, .. } = &model.loads;
        let Loads { rate, spin_accel_rate_cos, spin_accel_rate_sin, .. } = &model.loads;
        if !(others.is_empty() && model.memory.is_empty()) || plain && model.speed == 0.0 {
            return None;
        }
        let (n, held) = (model.held() - model.states().len(), model.held());
        let mut out = LinearRows { n, speed: model.speed, plain, ..LinearRows::default() };
        for i in 0..held {
            for (e, column) in model.pattern().row(i).take_while(|x| x.1 < held) {
                let [place, turned, rate, whirled, accelerated] = model.entry(e);
                let entry = if plain {
                    Entry { column, place, place_speed: turned, rate, rate_speed: whirled }
                } else {
                    let w = model.speed;
                    Entry { column, place: place + w * turned, place_speed: 0.0, rate: rate + w * whirled, rate_speed: 0.0 }
                };
                if [place, turned, rate, whirled].iter().any(|&x| x != 0.0) {
                    out.entries.push(entry);
                }
                if accelerated != 0.0 {
                    out.spin_accel.push((i, column, accelerated));
                }
            }
            out.ends.push(out.entries.len());
            let (force, spin_accel) = match i.checked_sub(n) {
                None => ([force[i], force_cos[i], force_sin[i]], [spin_accel_force[i], spin_accel_cos[i], spin_accel_sin[i]]),
                // rates stand on the other side
                Some(k) => ([-rate[k], 0.0, 0.0], [0.0, -spin_accel_rate_cos[k], -spin_accel_rate_sin[k]]),
            };
            if force.iter().chain(&spin_accel).any(|&x| x != 0.0) {
                out.loads.push(Load { row: i, force, spin_accel });
            }
        }
        Some(out)
    }

    /// The force rows and, behind them, the rates of the states of the blocks at zero accelerations; `at.z` holds these states alone.
    ///
    /// # Panics
    /// On an `out` shorter than its rows.
    pub fn residual(&self, at: &At<f64>, out: &mut [f64]) {
        let (w, accel) = (at.speed, at.spin_accel);
        let mut from = 0;
        for (out, &end) in out.iter_mut().zip(&self.ends) {
            let mut sum = 0.0;
            for e in &self.entries[from..end] {
                let place = e.place + w * e.place_speed;
                sum += if e.column < self.n {
                    place * at.q[e.column] + (e.rate + w * e.rate_speed) * at.v[e.column]
                } else {
                    place * at.z[e.column - self.n]
                };
            }
            (*out, from) = (sum, end);
        }
        if accel != 0.0 {
            for &(i, j, x) in &self.spin_accel {
                out[i] += accel * x * if j < self.n { at.q[j] } else { at.z[j - self.n] };
            }
        }
        let (sin, cos) = Scalar::sin_cos(at.phase);
        let turning = if self.plain { (w / self.speed).powi(2) } else { 1.0 };
        for load in &self.loads {
            let ([f, c, s], [g, gc, gs]) = (load.force, load.spin_accel);
            out[load.row] -= f + turning * (c * cos + s * sin) + accel * (g + gc * cos + gs * sin);
        }
    }
}
