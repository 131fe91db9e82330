//! Linear form of a part, or of a whole machine, at one spin speed.

use laval_num::refill::refill;
use laval_num::scalar::Scalar;
use std::ops::{Index, IndexMut, Range};

/// Row-major table of scalars, of which a band about the diagonal may be all there is.
///
/// Entry `(i, j)` stands at `i step + j + shift`: in a full table of n columns step = n and shift = 0, in one of entries with |i - j| <= r step = 2 r and shift = r.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid<S> {
    rows: usize,
    cols: usize,
    reach: usize,
    step: usize,
    shift: usize,
    data: Vec<S>,
}

impl<S: Scalar> Grid<S> {
    /// Zeros.
    pub fn new(rows: usize, cols: usize) -> Self {
        let mut out = Grid::empty();
        out.reset(rows, cols);
        out
    }
    /// Sets the shape and all entries to zero, keeping the allocation.
    pub fn reset(&mut self, rows: usize, cols: usize) {
        (self.rows, self.cols, self.reach, self.step, self.shift) = (rows, cols, usize::MAX, cols, 0);
        refill(&mut self.data, rows * cols, S::zero());
    }
    /// Square with entries at most `reach` beside the diagonal, all zero, keeping the allocation.
    pub fn reset_band(&mut self, n: usize, reach: usize) {
        if reach.saturating_add(1) >= n {
            return self.reset(n, n);
        }
        (self.rows, self.cols, self.reach, self.step, self.shift) = (n, n, reach, 2 * reach, reach);
        refill(&mut self.data, n * (2 * reach + 1), S::zero());
    }
    /// `sum_j self[i][j] x[j]`.
    #[inline(always)]
    pub fn row_dot(&self, i: usize, x: &[S]) -> S {
        let mut s = S::zero();
        for (&a, &x) in self.row(i).iter().zip(&x[self.first(i)..]) {
            s += a * x;
        }
        s
    }
    /// Adds `[[re, -im], [im, re]]` at rows `i, i+1` and columns `j, j+1`: multiplication of `x + i y` by the complex number `re + i im`.
    #[inline(always)]
    pub fn add_complex(&mut self, i: usize, j: usize, re: S, im: S) {
        self[(i, j)] += re;
        self[(i, j + 1)] += -im;
        self[(i + 1, j)] += im;
        self[(i + 1, j + 1)] += re;
    }
}

impl<S: Scalar> Grid<laval_num::complex::Complex<S>> {
    /// Square, all zero, keeping the allocation.
    pub fn reset_complex(&mut self, n: usize) {
        (self.rows, self.cols, self.reach, self.step, self.shift) = (n, n, usize::MAX, n, 0);
        refill(&mut self.data, n * n, laval_num::complex::Complex::zero());
    }
}

impl<S> Grid<S> {
    /// No rows, no columns.
    pub fn empty() -> Self {
        Grid { rows: 0, cols: 0, reach: usize::MAX, step: 0, shift: 0, data: Vec::new() }
    }
    /// Rows.
    pub fn rows(&self) -> usize {
        self.rows
    }
    /// Columns.
    pub fn cols(&self) -> usize {
        self.cols
    }
    #[inline(always)]
    fn first(&self, i: usize) -> usize {
        i.saturating_sub(self.reach)
    }
    /// Columns in which a row has entries.
    #[inline(always)]
    pub fn columns(&self, i: usize) -> Range<usize> {
        self.first(i)..self.cols.min(i.saturating_add(self.reach).saturating_add(1))
    }
    /// The entries of a row in its [`columns`](Self::columns).
    #[inline(always)]
    pub fn row(&self, i: usize) -> &[S] {
        let columns = self.columns(i);
        let start = i * self.step + columns.start + self.shift;
        &self.data[start..start + columns.len()]
    }
    /// An entry; zero where the row has none.
    #[inline(always)]
    pub fn get(&self, i: usize, j: usize) -> S
    where
        S: Scalar,
    {
        if i.abs_diff(j) <= self.reach { self[(i, j)] } else { S::zero() }
    }
    /// All entries are zero and constant.
    pub fn is_nothing(&self) -> bool
    where
        S: Scalar,
    {
        self.data.iter().all(|x| x.is_nothing())
    }
    #[inline(always)]
    fn place(&self, i: usize, j: usize) -> usize {
        assert!(i.abs_diff(j) <= self.reach, "the layout of the part says that its coordinates {i} and {j} are not coupled");
        debug_assert!(j < self.cols);
        i * self.step + j + self.shift
    }
}

impl<S> Index<(usize, usize)> for Grid<S> {
    type Output = S;
    #[inline(always)]
    fn index(&self, (i, j): (usize, usize)) -> &S {
        &self.data[self.place(i, j)]
    }
}
impl<S> IndexMut<(usize, usize)> for Grid<S> {
    #[inline(always)]
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut S {
        let at = self.place(i, j);
        &mut self.data[at]
    }
}

/// Axes a memory state lives in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Fixed: `z' = -rate z + q[input]`.
    Fixed,
    /// Turning with the rotor, first of a pair `z = z_x + i z_y` (in fixed components): `z' = (i speed - rate) z + u`.
    RotorX,
    /// Second of the pair.
    RotorY,
}

/// A memory state: `z' = -rate z + q[input]`, adding `gain z` to the force row `output`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory<S> {
    /// Rate of decay, 1/s, positive.
    pub rate: S,
    /// Force per state.
    pub gain: S,
    /// Local coordinate it remembers.
    pub input: usize,
    /// Local row it acts on.
    pub output: usize,
    /// Axes.
    pub axes: Axes,
}

/// Linear form at spin speed W, for `n` coordinates and `m` internal states:
///
/// ```text
/// rows:  M a + (C + W G) v + (K + W N + W' K') q + (H + W' H') z = f0 + fc cos(phase) + fs sin(phase) + W' (g0 + gc cos(phase) + gs sin(phase))
/// z' = A z + Aq q + Av v + Aa a + z0 + W' (hc cos(phase) + hs sin(phase))     (memory states, listed apart, come last in z)
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Blocks<S> {
    /// Spin speed W the blocks were evaluated at, rad/s.
    pub speed: S,
    /// M, kg.
    pub mass: Grid<S>,
    /// C, N s/m.
    pub damping: Grid<S>,
    /// G, skew: gyroscopic.
    pub gyroscopic: Grid<S>,
    /// K, N/m.
    pub stiffness: Grid<S>,
    /// N, skew: circulatory (per spin speed).
    pub circulatory: Grid<S>,
    /// K', multiplied by the spin acceleration.
    pub spin_accel_stiffness: Grid<S>,
    /// H: force rows per state.
    pub state_force: Grid<S>,
    /// H', multiplied by the spin acceleration.
    pub spin_accel_state_force: Grid<S>,
    /// A.
    pub state: Grid<S>,
    /// Aq.
    pub state_q: Grid<S>,
    /// Av.
    pub state_v: Grid<S>,
    /// Aa.
    pub state_a: Grid<S>,
    /// z0: constant rate.
    pub rate: Vec<S>,
    /// Memory states.
    pub memory: Vec<Memory<S>>,
    /// f0: constant force, N.
    pub force: Vec<S>,
    /// fc: force on cos(phase), N (at the speed of evaluation: the factor W^2 of an unbalance is inside).
    pub force_cos: Vec<S>,
    /// fs: force on sin(phase).
    pub force_sin: Vec<S>,
    /// g0: force per spin acceleration.
    pub spin_accel_force: Vec<S>,
    /// gc: force per spin acceleration on cos(phase).
    pub spin_accel_cos: Vec<S>,
    /// gs: force per spin acceleration on sin(phase).
    pub spin_accel_sin: Vec<S>,
    /// hc: rate per spin acceleration on cos(phase).
    pub spin_accel_rate_cos: Vec<S>,
    /// hs: rate per spin acceleration on sin(phase).
    pub spin_accel_rate_sin: Vec<S>,
}

/// The rotating vector `amplitude exp(i (phase + offset))` as its factors on cos and sin of the phase, in x and in y.
#[inline(always)]
pub fn rotating<S: Scalar>(amplitude: S, offset: S) -> [[S; 2]; 2] {
    let (s, co) = offset.sin_cos();
    [[amplitude * co, -(amplitude * s)], [amplitude * s, amplitude * co]]
}

impl<S: Scalar> Default for Blocks<S> {
    fn default() -> Self {
        let g = || Grid::new(0, 0);
        Blocks {
            speed: S::zero(),
            mass: g(),
            damping: g(),
            gyroscopic: g(),
            stiffness: g(),
            circulatory: g(),
            spin_accel_stiffness: g(),
            state_force: g(),
            spin_accel_state_force: g(),
            state: g(),
            state_q: g(),
            state_v: g(),
            state_a: g(),
            rate: Vec::new(),
            memory: Vec::new(),
            force: Vec::new(),
            force_cos: Vec::new(),
            force_sin: Vec::new(),
            spin_accel_force: Vec::new(),
            spin_accel_cos: Vec::new(),
            spin_accel_sin: Vec::new(),
            spin_accel_rate_cos: Vec::new(),
            spin_accel_rate_sin: Vec::new(),
        }
    }
}

impl<S: Scalar> Blocks<S> {
    /// All zero for `n` coordinates and `m` internal states other than memory, at `speed`; keeps its allocations.
    #[inline(always)]
    pub fn reset(&mut self, n: usize, m: usize, speed: S) {
        self.reset_band(n, m, usize::MAX, speed);
    }
    /// The same of a part whose coordinates are coupled over this distance in their order ([`Extent::reach`](super::capability::Extent::reach)).
    #[inline(always)]
    pub fn reset_band(&mut self, n: usize, m: usize, reach: usize, speed: S) {
        self.speed = speed;
        for g in [
            &mut self.mass,
            &mut self.damping,
            &mut self.gyroscopic,
            &mut self.stiffness,
            &mut self.circulatory,
            &mut self.spin_accel_stiffness,
        ] {
            g.reset_band(n, reach);
        }
        self.state_force.reset(n, m);
        self.spin_accel_state_force.reset(n, m);
        self.state.reset(m, m);
        for g in [&mut self.state_q, &mut self.state_v, &mut self.state_a] {
            g.reset(m, n);
        }
        self.memory.clear();
        for f in [&mut self.rate, &mut self.spin_accel_rate_cos, &mut self.spin_accel_rate_sin] {
            refill(f, m, S::zero());
        }
        for f in [
            &mut self.force,
            &mut self.force_cos,
            &mut self.force_sin,
            &mut self.spin_accel_force,
            &mut self.spin_accel_cos,
            &mut self.spin_accel_sin,
        ] {
            refill(f, n, S::zero());
        }
    }

    /// Adds a force that turns with the rotor, `(k W^2 - i kappa W') r exp(i phase)`, on two rows with lever arms; `r` as [`rotating`] gives it.
    #[inline(always)]
    pub fn add_rotating(&mut self, rows: [(usize, S); 2], r: [[S; 2]; 2], k: S, kappa: S) {
        let w2 = self.speed * self.speed;
        for (axis, &(row, lever)) in rows.iter().enumerate() {
            self.force_cos[row] += lever * k * w2 * r[axis][0];
            self.force_sin[row] += lever * k * w2 * r[axis][1];
            // -i times the vector: x takes +y, y takes -x
            let (other, sign) = if axis == 0 { (1, 1.0) } else { (0, -1.0) };
            self.spin_accel_cos[row] += (lever * kappa * r[other][0]).scale(sign);
            self.spin_accel_sin[row] += (lever * kappa * r[other][1]).scale(sign);
        }
    }

    /// Adds `-i g W' r exp(i phase)` to the rates of the pair of states that starts at `state`.
    #[inline(always)]
    pub fn add_rotating_rate(&mut self, state: usize, r: [[S; 2]; 2], g: S) {
        for (axis, other, sign) in [(0, 1, 1.0), (1, 0, -1.0)] {
            self.spin_accel_rate_cos[state + axis] += (g * r[other][0]).scale(sign);
            self.spin_accel_rate_sin[state + axis] += (g * r[other][1]).scale(sign);
        }
    }

    /// What is multiplied by the speed and acceleration of the part's own spin, for those of a spin that it turns `ratio` times as fast as.
    pub fn per_spin(&mut self, ratio: S) {
        for g in [&mut self.gyroscopic, &mut self.circulatory, &mut self.spin_accel_stiffness, &mut self.spin_accel_state_force] {
            g.data.iter_mut().for_each(|x| *x = ratio * *x);
        }
        for f in [
            &mut self.spin_accel_force,
            &mut self.spin_accel_cos,
            &mut self.spin_accel_sin,
            &mut self.spin_accel_rate_cos,
            &mut self.spin_accel_rate_sin,
        ] {
            f.iter_mut().for_each(|x| *x = ratio * *x);
        }
    }

    /// Derivative of force row `i` with respect to the spin acceleration, at a point.
    #[inline(always)]
    pub fn spin_accel_row(&self, i: usize, at: &super::context::At<S>, (sin, cos): (S, S)) -> S {
        let mut r = -(self.spin_accel_force[i] + self.spin_accel_cos[i] * cos + self.spin_accel_sin[i] * sin);
        r += self.spin_accel_stiffness.row_dot(i, at.q);
        for j in 0..self.state.rows() {
            r += self.spin_accel_state_force[(i, j)] * at.z[j];
        }
        r
    }

    /// The force rows and state rates at a point, added to `force` and `rate`.
    #[inline(always)]
    pub fn residual(&self, at: &super::context::At<S>, force: &mut [S], rate: &mut [S]) {
        let (n, m) = (self.mass.rows(), self.state.rows());
        let (sin, cos) = at.phase.sin_cos();
        for i in 0..n {
            let mut r = S::zero();
            for j in self.mass.columns(i) {
                let damping = self.damping[(i, j)] + self.speed * self.gyroscopic[(i, j)];
                let stiffness =
                    self.stiffness[(i, j)] + self.speed * self.circulatory[(i, j)] + at.spin_accel * self.spin_accel_stiffness[(i, j)];
                r += self.mass[(i, j)] * at.a[j] + damping * at.v[j] + stiffness * at.q[j];
            }
            for j in 0..m {
                r += (self.state_force[(i, j)] + at.spin_accel * self.spin_accel_state_force[(i, j)]) * at.z[j];
            }
            r -= self.force[i] + self.force_cos[i] * cos + self.force_sin[i] * sin;
            r -= at.spin_accel * (self.spin_accel_force[i] + self.spin_accel_cos[i] * cos + self.spin_accel_sin[i] * sin);
            force[i] += r;
        }
        for i in 0..m {
            rate[i] += self.state.row_dot(i, &at.z[..m])
                + self.state_q.row_dot(i, at.q)
                + self.state_v.row_dot(i, at.v)
                + self.state_a.row_dot(i, at.a)
                + self.rate[i]
                + at.spin_accel * (self.spin_accel_rate_cos[i] * cos + self.spin_accel_rate_sin[i] * sin);
        }
        for (k, mem) in self.memory.iter().enumerate() {
            let z = at.z[m + k];
            let turning = match mem.axes {
                Axes::Fixed => S::zero(),
                Axes::RotorX => -self.speed * at.z[m + k + 1],
                Axes::RotorY => self.speed * at.z[m + k - 1],
            };
            rate[m + k] += at.q[mem.input] - mem.rate * z + turning;
            force[mem.output] += mem.gain * z;
        }
    }
}
