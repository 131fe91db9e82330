//! The linear parts of a machine by diagonals of their matrices, for many evaluations at points of a motion; diagonals of zeros are left out.

use super::linear::{Form, LinearModel, LinearScratch, Loads};
use super::part::At;
use super::system::System;
use laval_num::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use laval_num::scalar::Scalar;

/// A polynomial of second degree in the speed.
type Quadratic = [f64; 3];

/// What multiplies places and velocities, by powers of the speed.
type Factors<T> = [[T; 3]; 2];

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
    force: [Quadratic; 3],
    spin_accel: [Quadratic; 3],
}

/// The rows of a [`LinearModel`] without memory states at one speed, or of one whose entries are polynomials in it.
#[derive(Clone, Debug, Default)]
pub struct LinearRows {
    /// Number of coordinates.
    n: usize,
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

/// Numbers of a model: what multiplies places and velocities, the mass and what multiplies the spin acceleration, entry by entry; and the loads, row by row.
struct Numbers {
    entries: Vec<[f64; 4]>,
    loads: Vec<[f64; 6]>,
}

impl Numbers {
    /// `None` where loads turn with other spins or there are memory states.
    fn of(model: &LinearModel<f64>) -> Option<Self> {
        let Loads { others, force, force_cos, force_sin, spin_accel_force, spin_accel_cos, spin_accel_sin, .. } = &model.loads;
        let Loads { rate, spin_accel_rate_cos, spin_accel_rate_sin, .. } = &model.loads;
        if !(others.is_empty() && model.memory.is_empty()) {
            return None;
        }
        let (n, held, w) = (model.held() - model.states().len(), model.held(), model.speed);
        let entries = (0..held).flat_map(|i| model.pattern().row(i).take_while(|x| x.1 < held)).map(|(e, _)| {
            let [place, turned, rate, whirled, accelerated] = model.entry(e);
            [place + w * turned, rate + w * whirled, model.mass_values()[e], accelerated]
        });
        let loads = (0..held).map(|i| match i.checked_sub(n) {
            None => [force[i], force_cos[i], force_sin[i], spin_accel_force[i], spin_accel_cos[i], spin_accel_sin[i]],
            // rates stand on the other side
            Some(k) => [-rate[k], 0.0, 0.0, 0.0, -spin_accel_rate_cos[k], -spin_accel_rate_sin[k]],
        });
        Some(Numbers { entries: entries.collect(), loads: loads.collect() })
    }

    fn all(&self) -> impl Iterator<Item = f64> {
        self.entries.as_flattened().iter().chain(self.loads.as_flattened()).copied()
    }
}

/// Speeds over the highest at which polynomials are fitted, and number of those at which they are compared, from one end of the range to the other.
const FITTED: [f64; 3] = [0.2, 0.6, 1.0];
const COMPARED: u32 = 64;
/// A term that is smaller than this, over the largest value, is rounding; and by so much the polynomials may differ.
const ROUNDING: f64 = 1e-14;
const SAME: f64 = 1e-12;

/// Through three values at [`FITTED`] times `top`.
fn through(values: [f64; 3], top: f64) -> Quadratic {
    let [w0, w1, w2] = FITTED.map(|w| w * top);
    let [v0, v1, v2] = values;
    let (first, second) = ((v1 - v0) / (w1 - w0), (v2 - v1) / (w2 - w1));
    let c2 = (second - first) / (w2 - w0);
    let c1 = first - c2 * (w0 + w1);
    let c0 = v0 - w0 * (c1 + w0 * c2);
    let size = ROUNDING * values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let kept = |c: f64, scale: f64| if (c * scale).abs() > size { c } else { 0.0 };
    [kept(c0, 1.0), kept(c1, top), kept(c2, top * top)]
}

#[inline(always)]
fn at_speed([c0, c1, c2]: Quadratic, w: f64) -> f64 {
    c0 + w * (c1 + w * c2)
}

impl LinearRows {
    /// At the speed of the model. `None` where loads turn with other spins or there are memory states.
    pub fn new(model: &LinearModel<f64>) -> Option<Self> {
        let numbers = Numbers::of(model)?;
        Some(Self::filled(model, &numbers.all().map(|x| [x, 0.0, 0.0]).collect::<Vec<_>>()))
    }

    /// At any speed up to `top`, rad/s, of either sign: of a machine whose matrices and loads are polynomials of second degree in the speed and whose mass is the same
    /// at all. That is tested at many speeds, those of tables among them. `None` of other machines.
    pub fn of_any_speed(system: &System, top: f64) -> Option<Self> {
        let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
        let mut numbers_at = |w: f64| {
            system.linear(system.params(), w, Form::Time, &mut model, &mut scratch);
            Numbers::of(&model)
        };
        let [a, b, c] = [numbers_at(FITTED[0] * top)?, numbers_at(FITTED[1] * top)?, numbers_at(FITTED[2] * top)?];
        let polynomials: Vec<Quadratic> = a.all().zip(b.all()).zip(c.all()).map(|((a, b), c)| through([a, b, c], top)).collect();
        let sizes: Vec<f64> = a.all().zip(b.all()).zip(c.all()).map(|((a, b), c)| SAME * a.abs().max(b.abs()).max(c.abs())).collect();
        // masses, and what multiplies the spin acceleration
        let fixed = a.entries.len();
        if polynomials.as_chunks::<4>().0.iter().take(fixed).any(|p| p[2..].iter().any(|q| q[1] != 0.0 || q[2] != 0.0)) {
            return None;
        }
        let even = (0..COMPARED).map(|k| top * (-1.0 + (2.0 * f64::from(k) + 0.5) / f64::from(COMPARED)));
        for w in even.chain(system.table_speeds(-top.abs(), top.abs())) {
            let now = numbers_at(w)?;
            // NaN fails
            if !now.all().zip(&polynomials).zip(&sizes).all(|((x, p), size)| (x - at_speed(*p, w)).abs() <= *size) {
                return None;
            }
        }
        Some(Self::filled(&model, &polynomials))
    }

    /// From the numbers of a model in the order of [`Numbers::all`].
    fn filled(model: &LinearModel<f64>, numbers: &[Quadratic]) -> Self {
        let (n, held) = (model.held() - model.states().len(), model.held());
        let mut out = LinearRows { n, held, ..LinearRows::default() };
        let (mut entries, mut counts) = (Vec::new(), vec![0; 2 * held]);
        let zero = |q: &Quadratic| *q == [0.0; 3];
        let mut next = 0;
        for i in 0..held {
            for (_, column) in model.pattern().row(i).take_while(|x| x.1 < held) {
                let [place, rate, _, accelerated] = [0, 1, 2, 3].map(|k| numbers[next + k]);
                next += 4;
                if !(zero(&place) && zero(&rate)) {
                    counts[held + column - i] += 1;
                    entries.push((i, column, [place, rate]));
                }
                if accelerated[0] != 0.0 {
                    out.spin_accel.push((i, column, accelerated[0]));
                }
            }
        }
        for (row, load) in numbers[next..].as_chunks::<6>().0.iter().enumerate() {
            if !load.iter().all(zero) {
                let [f, c, s, g, gc, gs] = *load;
                out.loads.push(Load { row, force: [f, c, s], spin_accel: [g, gc, gs] });
            }
        }
        out.arrange(&entries, &counts);
        out
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
            for (values, x) in self.diagonals[k].factors.iter_mut().flatten().zip(factors.into_iter().flatten()) {
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
        for &(row, column, [place, rate]) in &self.scattered {
            let k = self.padding + column;
            out[row] += at_speed(place, w) * scratch.places[k] + at_speed(rate, w) * scratch.velocities[k];
        }
        if accel != 0.0 {
            for &(i, j, x) in &self.spin_accel {
                out[i] += accel * x * if j < self.n { at.q[j] } else { at.z[j - self.n] };
            }
        }
        let (sin, cos) = Scalar::sin_cos(at.phase);
        for load in &self.loads {
            let ([f, c, s], [g, gc, gs]) = (load.force, load.spin_accel);
            let turning = |c, s| at_speed(c, w) * cos + at_speed(s, w) * sin;
            out[load.row] -= at_speed(f, w) + turning(c, s) + accel * (at_speed(g, w) + turning(gc, gs));
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
            for Diagonal { from, factors: [place, rate] } in &self.rows.diagonals {
                if let Some(factor) = factor(place, row, w) {
                    sum += factor * load(places, from + row);
                }
                if let Some(factor) = factor(rate, row, w) {
                    sum += factor * load(velocities, from + row);
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

/// By powers of the speed, some of which may be empty; `None` where all are.
#[inline(always)]
fn factor<S: LaneScalar>([constant, linear, square]: &[Vec<f64>; 3], row: usize, w: S) -> Option<S> {
    let mut out = if constant.is_empty() { None } else { Some(load::<S>(constant, row)) };
    for (values, power) in [(linear, w), (square, w * w)] {
        if !values.is_empty() {
            let term = power * load::<S>(values, row);
            out = Some(match out {
                Some(sum) => sum + term,
                None => term,
            });
        }
    }
    out
}
