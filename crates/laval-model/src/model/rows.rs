//! The linear parts of a machine by diagonals of their matrices, for many evaluations at points of a motion; diagonals of zeros are left out.

use super::linear::{LinearModel, Loads};
use super::part::At;
use laval_num::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use laval_num::scalar::Scalar;

/// What multiplies places, places times speed, velocities and velocities times speed.
type Factors<T> = [T; 4];

/// A diagonal of the matrices: by rows, each kind of factor empty where all are zero.
#[derive(Clone, Debug)]
struct Diagonal {
    /// Column less row, and the padding before the first column.
    from: usize,
    factors: Factors<Vec<f64>>,
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
    /// Number of rows: of coordinates, then of states.
    held: usize,
    /// Zeros before the first column and behind the last.
    padding: usize,
    diagonals: Vec<Diagonal>,
    /// Row, column and factors of entries on diagonals that hold few.
    scattered: Vec<(usize, usize, Factors<f64>)>,
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
        let mut out = LinearRows { n, held, speed: model.speed, plain, ..LinearRows::default() };
        let (mut entries, mut counts) = (Vec::new(), vec![0; 2 * held]);
        for i in 0..held {
            for (e, column) in model.pattern().row(i).take_while(|x| x.1 < held) {
                let [place, turned, rate, whirled, accelerated] = model.entry(e);
                let w = model.speed;
                let factors = if plain { [place, turned, rate, whirled] } else { [place + w * turned, 0.0, rate + w * whirled, 0.0] };
                if factors.iter().any(|&x| x != 0.0) {
                    counts[held + column - i] += 1;
                    entries.push((i, column, factors));
                }
                if accelerated != 0.0 {
                    out.spin_accel.push((i, column, accelerated));
                }
            }
            let (force, spin_accel) = match i.checked_sub(n) {
                None => ([force[i], force_cos[i], force_sin[i]], [spin_accel_force[i], spin_accel_cos[i], spin_accel_sin[i]]),
                // rates stand on the other side
                Some(k) => ([-rate[k], 0.0, 0.0], [0.0, -spin_accel_rate_cos[k], -spin_accel_rate_sin[k]]),
            };
            if force.iter().chain(&spin_accel).any(|&x| x != 0.0) {
                out.loads.push(Load { row: i, force, spin_accel });
            }
        }
        out.arrange(&entries, &counts);
        Some(out)
    }

    /// Sorts entries into diagonals, whose numbers by column less row (plus `held`) are given, and the rest.
    fn arrange(&mut self, entries: &[(usize, usize, Factors<f64>)], counts: &[usize]) {
        let held = self.held;
        let full: Vec<usize> = (0..counts.len()).filter(|&d| counts[d] * LANES >= held.max(1)).collect();
        self.padding = full.iter().map(|d| d.abs_diff(held)).max().unwrap_or(0);
        let mut place = vec![None; counts.len()];
        for (k, &d) in full.iter().enumerate() {
            place[d] = Some(k);
            self.diagonals.push(Diagonal { from: self.padding + d - held, factors: Factors::default() });
        }
        for &(row, column, factors) in entries {
            let Some(k) = place[held + column - row] else {
                self.scattered.push((row, column, factors));
                continue;
            };
            for (values, x) in self.diagonals[k].factors.iter_mut().zip(factors) {
                if x != 0.0 {
                    values.resize(held.next_multiple_of(LANES), 0.0);
                    values[row] = x;
                }
            }
        }
    }

    /// The force rows and, behind them, the rates of the states of the blocks at zero accelerations; `at.z` holds these states alone.
    ///
    /// # Panics
    /// On an `out` shorter than its rows.
    pub fn residual(&self, at: &At<f64>, scratch: &mut Padded, out: &mut [f64]) {
        let (w, accel, held) = (at.speed, at.spin_accel, self.held);
        scratch.fill(self, at);
        dispatch(Level::best(), Sum { rows: self, w, scratch });
        out[..held].copy_from_slice(&scratch.sum[..held]);
        for &(row, column, [place, place_speed, rate, rate_speed]) in &self.scattered {
            let k = self.padding + column;
            out[row] += (place + w * place_speed) * scratch.places[k] + (rate + w * rate_speed) * scratch.velocities[k];
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

/// Places and velocities of coordinates, then of states (without velocities), between zeros; and sums over whole lanes.
#[derive(Clone, Debug, Default)]
pub struct Padded {
    places: Vec<f64>,
    velocities: Vec<f64>,
    sum: Vec<f64>,
}

impl Padded {
    fn fill(&mut self, rows: &LinearRows, at: &At<f64>) {
        let (n, padding, lanes) = (rows.n, rows.padding, rows.held.next_multiple_of(LANES));
        for (to, from, states) in [(&mut self.places, at.q, at.z), (&mut self.velocities, at.v, &[][..])] {
            to.clear();
            to.resize(lanes + 2 * padding, 0.0);
            to[padding..padding + n].copy_from_slice(&from[..n]);
            to[padding + n..][..states.len()].copy_from_slice(states);
        }
        self.sum.resize(lanes, 0.0);
    }
}

/// Sums over the diagonals, some rows at a time.
struct Sum<'a> {
    rows: &'a LinearRows,
    w: f64,
    scratch: &'a mut Padded,
}

impl Kernel for Sum<'_> {
    type Out = ();
    #[inline(always)]
    fn run<S: LaneScalar>(self) {
        let Padded { places, velocities, sum } = self.scratch;
        let w = S::cst(self.w);
        for (block, out) in sum.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
            let row = block * LANES;
            let mut sum = S::cst(0.0);
            for Diagonal { from, factors: [place, place_speed, rate, rate_speed] } in &self.rows.diagonals {
                if !(place.is_empty() && place_speed.is_empty()) {
                    sum += factor(place, place_speed, row, w) * load(places, from + row);
                }
                if !(rate.is_empty() && rate_speed.is_empty()) {
                    sum += factor(rate, rate_speed, row, w) * load(velocities, from + row);
                }
            }
            sum.store(out);
        }
    }
}

#[inline(always)]
fn load<S: LaneScalar>(x: &[f64], from: usize) -> S {
    S::load(&x[from..].as_chunks::<LANES>().0[0])
}

/// Constant factors and factors of the speed, some of which may be empty.
#[inline(always)]
fn factor<S: LaneScalar>(constant: &[f64], of_speed: &[f64], row: usize, w: S) -> S {
    match (constant.is_empty(), of_speed.is_empty()) {
        (false, true) => load(constant, row),
        (true, _) => w * load::<S>(of_speed, row),
        (false, false) => load::<S>(constant, row) + w * load::<S>(of_speed, row),
    }
}
