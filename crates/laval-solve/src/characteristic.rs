//! The characteristic matrix T(s) of a machine about an equilibrium: singular exactly at the eigenvalues.
//!
//! Unknowns are the coordinates and those internal states that are not eliminated: memory states and frequency-domain parts enter exactly.
//! T is given in the coordinates of [`Sectors`]. About a state that turns with the rotor, column j is evaluated at `s + i k_j W` with the winding
//! k_j of its coordinate; for a machine without preferred direction that is exact and constant in time.
//!
//! Theory: `docs/theory/linear-vibration.md#characteristic-matrix`.

pub use super::border::{Border, Test};
use super::border::{equilibrate, singular_directions};
pub use super::equilibrium::{Equilibrium, Frame, coordinate_sectors, nonlinear_states, state_sectors};
use super::sectors::{Sector, Sectors, imaginary};
use crate::model::erased::D1;
use crate::model::linear::{Form, LinearModel, LinearScratch};
use crate::model::part::{At, Physics};
use crate::model::system::System;
use crate::model::tangent::{SparseTangent, TangentScratch};
use laval_num::complex::{C64, Complex, c};
use laval_num::dense::{Field, Mat};
use laval_num::dual::Dual;
use laval_num::factor::{Directed, Factors, LogDet, Pattern, Plan, Selection, Terms};
use laval_num::work::spend;
use std::sync::Arc;

/// Most steps of Newton's method to a root.
const MOST_STEPS: usize = 25;
/// Step over the step before from which on the vectors of a test are exact enough for the root that it leads to.
const SHRUNK: f64 = 1e-4;
/// Relative step by the form of exact vectors that confirms a root.
const CONFIRMED: f64 = 1e-12;
/// Relative step below which Newton's method has converged when its steps stop decreasing.
const NEAR: f64 = 1e-9;
/// Steps are rounding at this multiple of what rounding of T moves a root by.
const MOVES: f64 = 4.0;

/// T(s) about one equilibrium.
#[derive(Clone)]
pub struct Characteristic<'a> {
    system: &'a System,
    params: Vec<D1>,
    model: LinearModel<D1>,
    scratch: LinearScratch<D1>,
    stiffness: Vec<Complex<D1>>,
    pattern: Arc<Pattern>,
    /// Tangents of nonlinear parts in sector coordinates, as entries: multiplied by 1, s, s^2; none where all parts are linear.
    nonlinear: Option<[Vec<C64>; 3]>,
    /// T as a polynomial, of a machine that holds neither memory nor parts given in the frequency domain.
    polynomial: Option<[Vec<C64>; 3]>,
    /// The derivative of the polynomial of linear parts over the speed.
    by_speed: Option<[Vec<C64>; 3]>,
    states: Vec<usize>,
    sectors: Sectors,
    frame: Frame,
    speed: f64,
    n: usize,
}

/// T is a polynomial in s: the machine holds neither memory nor parts given in the frequency domain.
pub fn is_polynomial(system: &System) -> bool {
    system.slots().iter().all(|s| s.memory == 0 && !matches!(s.physics, Physics::Frequency(_)))
}

impl<'a> Characteristic<'a> {
    /// About an equilibrium.
    pub fn new(system: &'a System, about: &Equilibrium) -> Self {
        let params: Vec<D1> = system.params().iter().map(|&x| Dual::lift(x)).collect();
        let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
        system.linear(&params, Dual::lift(about.speed), Form::Frequency, &mut model, &mut scratch);
        let own = nonlinear_states(system);
        let states: Vec<usize> = model.states().iter().chain(&own).copied().collect();
        let coordinates = coordinate_sectors(system);
        let sectors = Sectors::chain(&[&coordinates, &state_sectors(system, &states)]);
        let n = system.n();
        let nonlinear =
            system.slots().iter().any(|s| !s.is_linear()).then(|| tangents(system, about, &coordinates, &sectors, &states, &model));
        let (frame, speed, pattern) = (about.frame, about.speed, model.pattern().clone());
        let (stiffness, polynomial, by_speed) = (Vec::new(), None, None);
        let mut out = Characteristic {
            system,
            params,
            model,
            scratch,
            stiffness,
            pattern,
            nonlinear,
            polynomial,
            by_speed,
            states,
            sectors,
            frame,
            speed,
            n,
        };
        out.polynomial = is_polynomial(system).then(|| out.polynomial());
        out
    }

    /// The same about another state in the same axes at the same speed: linear parts stay as they are.
    pub fn move_to(&mut self, about: &Equilibrium) {
        if self.nonlinear.is_some() {
            let coordinates = coordinate_sectors(self.system);
            self.nonlinear = Some(tangents(self.system, about, &coordinates, &self.sectors, &self.states, &self.model));
            self.polynomial = is_polynomial(self.system).then(|| self.polynomial());
        }
    }

    /// `A0, A1, A2` of `T(s) = A0 + s A1 + s^2 A2`, without memory and parts given in the frequency domain.
    pub fn polynomial(&self) -> [Vec<C64>; 3] {
        let mut out = self.polarised(self.model.polynomial().map(|all| all.iter().map(|x| c(x.re, 0.0)).collect()));
        for (all, more) in out.iter_mut().zip(self.nonlinear.iter().flatten()) {
            all.iter_mut().zip(more).for_each(|(a, &b)| *a += b);
        }
        if self.frame == Frame::Turning {
            self.each_entry(|e, sector| {
                let h = self.shift(sector);
                let [a0, a1, a2] = out.each_ref().map(|all| all[e]);
                (out[0][e], out[1][e]) = (a0 + h * (a1 + h * a2), a1 + (h * a2).scale(2.0));
            });
        }
        out
    }

    /// The same in x and y, about a state in fixed axes.
    pub fn real_polynomial(&self) -> Option<[Vec<f64>; 3]> {
        let mut out =
            (self.frame == Frame::Fixed).then(|| self.model.polynomial().map(|all| all.iter().map(|x| x.re).collect::<Vec<f64>>()))?;
        for (all, more) in out.iter_mut().zip(self.nonlinear.iter().flatten()) {
            let mut more = more.clone();
            self.sectors.restore_entries(&self.pattern, &mut more);
            all.iter_mut().zip(more).for_each(|(a, b)| *a += b.re);
        }
        Some(out)
    }

    fn polarised(&self, mut terms: [Vec<C64>; 3]) -> [Vec<C64>; 3] {
        terms.iter_mut().for_each(|all| self.sectors.polarise_entries(&self.pattern, all));
        terms
    }

    /// Calls `f` with every entry and the sector of its column.
    fn each_entry(&self, mut f: impl FnMut(usize, Sector)) {
        for i in 0..self.sectors.len() {
            self.pattern.row(i).for_each(|(e, j)| f(e, self.sectors.of(j)));
        }
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.sectors.len()
    }
    /// Sectors of the unknowns: coordinates, then states.
    pub fn sectors(&self) -> &Sectors {
        &self.sectors
    }
    /// Global indices of the states among the unknowns.
    pub fn states(&self) -> &[usize] {
        &self.states
    }
    /// Speed, rad/s.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    fn shift(&self, k: Sector) -> C64 {
        match self.frame {
            Frame::Fixed => C64::ZERO,
            Frame::Turning => imaginary(k.winding() * self.speed),
        }
    }

    /// T(s) and dT/ds.
    pub fn at(&mut self, s: C64, value: &mut Mat<C64>, slope: &mut Mat<C64>) {
        let [v, d] = self.entries(s);
        self.fill(&v, value);
        self.fill(&d, slope);
    }

    /// T(s) and dT/ds as entries of the [pattern](Self::pattern).
    pub fn entries(&mut self, s: C64) -> [Vec<C64>; 2] {
        if let Some(terms) = &self.polynomial {
            spend(4 * self.pattern.entries() as u64);
            return evaluated(terms, s);
        }
        let [mut value, mut slope] = self.differentiated(s, (1.0, 0.0));
        self.add_tangents(s, &mut value, &mut slope);
        [value, slope]
    }

    /// Phase and logarithmic derivative of `det T(s)` over some unknowns. Rows may be divided by their largest entries, so that its size says nothing. `None` where T is singular
    /// or not finite.
    pub fn determinant(&mut self, s: C64, of: &Selection, factors: &mut Factors<Directed>) -> Option<LogDet> {
        let [value, slope] = self.entries(s).map(|all| of.taken(&all));
        let pattern = of.inner.pattern();
        let both = |v: C64, d: C64| c(Dual { re: v.re, eps: [d.re] }, Dual { re: v.im, eps: [d.im] });
        let mut entries: Vec<Directed> = value.iter().zip(&slope).map(|(&v, &d)| both(v, d)).collect();
        // bands are scaled where they are factored
        for i in (0..pattern.n()).filter(|_| of.inner.is_dense()) {
            let size = pattern.row(i).map(|(e, _)| value[e].size()).fold(0.0, f64::max);
            let scale = if size > 0.0 { size.recip() } else { 1.0 };
            pattern.row(i).for_each(|(e, _)| entries[e] = both(value[e].scale(scale), slope[e].scale(scale)));
        }
        factors.factor(&of.inner, &entries).ok()?;
        Some(factors.log_det())
    }

    /// Which entries of T may differ from zero.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// How matrices over all unknowns are factored.
    pub fn plan(&self) -> &Plan {
        self.model.plan()
    }

    /// Some of the unknowns (in rising order) by themselves.
    pub fn selection(&self, members: &[usize]) -> Arc<Selection> {
        self.model.selection(members)
    }

    /// `m x` of the entries of a matrix.
    pub fn times(&self, m: &[C64], x: &[C64]) -> Vec<C64> {
        let row = |i: usize| self.pattern.row(i).fold(C64::ZERO, |sum, (e, j)| sum + m[e] * x[j]);
        (0..self.sectors.len()).map(row).collect()
    }

    /// `y^H m x` of the null vectors of a root and the entries of a matrix.
    pub fn product(&self, root: &Polished, m: &[C64]) -> C64 {
        self.times(m, &root.right).into_iter().zip(&root.left).fold(C64::ZERO, |sum, (x, y)| sum + y.conj() * x)
    }

    /// The matrix of entries.
    fn fill(&self, entries: &[C64], out: &mut Mat<C64>) {
        out.reset(self.sectors.len(), self.sectors.len());
        for i in 0..self.sectors.len() {
            self.pattern.row(i).for_each(|(e, j)| out[(i, j)] = entries[e]);
        }
    }

    /// Adds the share of nonlinear parts, which is of second order in s.
    fn add_tangents(&self, s: C64, value: &mut [C64], slope: &mut [C64]) {
        let Some([k, d, m]) = &self.nonlinear else { return };
        for i in 0..self.sectors.len() {
            for (e, j) in self.pattern.row(i) {
                let s = s + self.shift(self.sectors.of(j));
                value[e] += k[e] + s * (d[e] + s * m[e]);
                slope[e] += d[e] + (s * m[e]).scale(2.0);
            }
        }
    }

    /// Entries of T(s) of nonlinear parts alone; `None` where all parts are linear.
    pub fn tangents_at(&self, s: C64) -> Option<Vec<C64>> {
        self.nonlinear.as_ref()?;
        let mut value = vec![C64::ZERO; self.pattern.entries()];
        let mut slope = value.clone();
        self.add_tangents(s, &mut value, &mut slope);
        Some(value)
    }

    /// The share of linear and frequency-domain parts, as entries.
    pub fn linear_entries(&mut self, s: C64) -> Vec<C64> {
        let [value, _] = self.differentiated(s, (1.0, 0.0));
        value
    }

    /// The stiffness against displacements at rest, as real entries in x and y.
    pub fn stiffness_entries(&mut self) -> Vec<f64> {
        let [mut value, _] = self.entries(C64::ZERO);
        self.sectors.restore_entries(&self.pattern, &mut value);
        value.iter().map(|k| k.re).collect()
    }

    /// Derivative over the speed of the share of linear and frequency-domain parts as entries, exact also beside their poles, which may turn with the rotor.
    pub fn linear_by_speed(&mut self, s: C64) -> Vec<C64> {
        if let Some(terms) = &self.by_speed {
            let [value, _] = evaluated(terms, s);
            return value;
        }
        if self.polynomial.is_some() {
            self.find_slope_by_speed();
            return self.linear_by_speed(s);
        }
        let mut seeded = self.seeded_by_speed();
        std::mem::swap(&mut self.model, &mut seeded);
        let [_, slope] = self.differentiated(s, (0.0, 1.0));
        self.model = seeded;
        slope
    }

    /// `y^H dT/dW x` of a root, of the share of linear parts, where T is a polynomial.
    pub fn product_by_speed(&mut self, root: &Polished) -> Option<C64> {
        self.polynomial.as_ref()?;
        if self.by_speed.is_none() {
            self.find_slope_by_speed();
        }
        let ([b0, b1, b2], s) = (self.by_speed.as_ref()?, root.value);
        let mut out = C64::ZERO;
        for (i, y) in root.left.iter().enumerate() {
            let mut row = C64::ZERO;
            for (e, j) in self.pattern.row(i) {
                // gyroscopic terms alone, mostly
                let zero = |x: &C64| x.re == 0.0 && x.im == 0.0;
                if !(zero(&b0[e]) && zero(&b1[e]) && zero(&b2[e])) {
                    row += (b0[e] + s * (b1[e] + s * b2[e])) * root.right[j];
                }
            }
            out += y.conj() * row;
        }
        Some(out)
    }

    fn seeded_by_speed(&mut self) -> LinearModel<D1> {
        let mut seeded = LinearModel::default();
        self.system.linear(&self.params, Dual::seed(self.speed, 0), Form::Frequency, &mut seeded, &mut self.scratch);
        seeded
    }

    fn find_slope_by_speed(&mut self) {
        let seeded = self.seeded_by_speed();
        self.by_speed = Some(self.polynomial_by_speed(&seeded));
    }

    /// Of a model whose speed is seeded.
    fn polynomial_by_speed(&self, seeded: &LinearModel<D1>) -> [Vec<C64>; 3] {
        let terms = seeded.polynomial();
        let of = |f: fn(&D1) -> f64| self.polarised(terms.each_ref().map(|all| all.iter().map(|x| c(f(x), 0.0)).collect()));
        let (mut out, own) = (of(|x| x.eps[0]), of(|x| x.re));
        if self.frame == Frame::Turning {
            // with the speed the shift of a column changes, too
            self.each_entry(|e, sector| {
                let (h, turn) = (self.shift(sector), imaginary(sector.winding()));
                let ([b0, b1, b2], a1, a2) = (out.each_ref().map(|all| all[e]), own[1][e], own[2][e]);
                out[0][e] = b0 + h * (b1 + h * b2) + turn * (a1 + (h * a2).scale(2.0));
                out[1][e] = b1 + (h * b2).scale(2.0) + (turn * a2).scale(2.0);
            });
        }
        out
    }

    /// Derivative of the share of linear and frequency-domain parts over parameters (by index) that move together as entries, exact.
    pub fn linear_by_parameters(&mut self, s: C64, moving: &[usize]) -> Vec<C64> {
        let seed = |params: &mut [D1], rate: f64| moving.iter().for_each(|&i| params[i].eps = [rate]);
        seed(&mut self.params, 1.0);
        let mut seeded = LinearModel::default();
        self.system.linear(&self.params, Dual::lift(self.speed), Form::Frequency, &mut seeded, &mut self.scratch);
        std::mem::swap(&mut self.model, &mut seeded);
        let [_, slope] = self.differentiated(s, (0.0, 0.0));
        self.model = seeded;
        seed(&mut self.params, 0.0);
        slope
    }

    /// The share of linear and frequency-domain parts and its derivative in a direction (of s, of the speed), which the model knows of the speed.
    fn differentiated(&mut self, s: C64, (along, speed): (f64, f64)) -> [Vec<C64>; 2] {
        let turning = self.frame == Frame::Turning;
        let kinds: &[Sector] = if turning { &[Sector::Axial, Sector::Forward, Sector::Backward] } else { &[Sector::Axial] };
        let mut out = [vec![C64::ZERO; self.pattern.entries()], vec![C64::ZERO; self.pattern.entries()]];
        for &kind in kinds {
            let s = s + self.shift(kind);
            let wound = if turning { speed * kind.winding() } else { 0.0 };
            let s = c(Dual { re: s.re, eps: [along] }, Dual { re: s.im, eps: [wound] });
            let z = &mut self.stiffness;
            self.system.dynamic_stiffness_entries(&self.params, &self.model, Form::Frequency, s, z, &mut self.scratch);
            let mut v: Vec<C64> = z.iter().map(|x| c(x.re.re, x.im.re)).collect();
            let mut d: Vec<C64> = z.iter().map(|x| c(x.re.eps[0], x.im.eps[0])).collect();
            self.sectors.polarise_entries(&self.pattern, &mut v);
            self.sectors.polarise_entries(&self.pattern, &mut d);
            if !turning {
                return [v, d];
            }
            for i in 0..self.sectors.len() {
                for (e, _) in self.pattern.row(i).filter(|x| self.sectors.of(x.1) == kind) {
                    (out[0][e], out[1][e]) = (v[e], d[e]);
                }
            }
        }
        out
    }

    /// The function whose zeros take the poles of T in the forward sector away ([`System::regular`]), about a state at rest, and its logarithmic derivative.
    pub fn regular(&self, s: C64) -> (C64, C64) {
        let at = c(Dual { re: s.re, eps: [1.0] }, Dual { re: s.im, eps: [0.0] });
        let r = self.system.regular(&self.params, at, Dual::lift(self.speed));
        let value = c(r.re.re, r.im.re);
        (value, c(r.re.eps[0], r.im.eps[0]) / value)
    }

    /// Constant forces and those that turn with the rotor (complex amplitudes `c - i s` of `c cos(phase) + s sin(phase)`), in x and y, over all
    /// unknowns.
    pub fn loads(&self) -> (Vec<f64>, Vec<C64>) {
        let b = &self.model.loads;
        let (mut constant, mut turning) = (vec![0.0; self.size()], vec![C64::ZERO; self.size()]);
        for i in 0..self.n {
            constant[i] = b.force[i].re;
            turning[i] = c(b.force_cos[i].re, -b.force_sin[i].re);
        }
        for (i, r) in b.rate.iter().enumerate() {
            constant[self.n + i] = r.re;
        }
        (constant, turning)
    }

    /// Scales T at `s` over the members so that its rows and columns are of size one, and finds its smallest singular directions.
    pub fn border(&mut self, s: C64, members: &[usize]) -> Option<Border> {
        let of = self.selection(members);
        let [t, d] = self.entries(s);
        let (t, d) = (of.taken(&t), of.taken(&d));
        let (rows, cols) = equilibrate(&of, &t, &d, s.abs());
        let pattern = of.inner.pattern();
        let mut scaled = t;
        for (i, &r) in rows.iter().enumerate() {
            pattern.row(i).for_each(|(e, j)| scaled[e] = scaled[e].scale(r * cols[j]));
        }
        let (b, a) = singular_directions(&of, &scaled)?;
        Some(Border { of, rows, cols, b, c: a })
    }

    /// The bordered test function `g` (zero exactly where T is singular), dg/ds, and the null vectors that belong to it.
    pub fn test(&mut self, s: C64, border: &Border) -> Option<Test> {
        let [t, d] = self.entries(s);
        let mut test = border.test(&t, &d)?;
        if let Some(g) = self.form(s, border, &test) {
            test.g = g;
        }
        test.g.is_finite().then_some(test)
    }

    /// `g = -y^H T(s) x` of the vectors of a test, where T is a polynomial with many unknowns: small errors of x and y do not change it, and the entries of T are not rounded.
    fn form(&self, s: C64, border: &Border, test: &Test) -> Option<C64> {
        let [a0, a1, a2] = self.polynomial.as_ref().filter(|_| !border.of.bordered.is_dense())?;
        let (x, y) = (border.spread(&test.right, &border.cols, self.size()), border.spread(&test.left, &border.rows, self.size()));
        let terms = [(C64::ONE, &a0[..]), (s, &a1[..]), (s * s, &a2[..])];
        Some(-Terms { pattern: &self.pattern, terms: &terms }.form(&y, &x))
    }

    /// Newton's method on `g(s) = 0` from a nearby start, over the members of a sector or all unknowns (`None`).
    pub fn polish(&mut self, start: C64, sector: Option<Sector>) -> Option<Polished> {
        self.polish_within(start, sector, f64::INFINITY)
    }

    /// The same, given up where an iterate is farther than `reach` from the start.
    pub fn polish_within(&mut self, start: C64, sector: Option<Sector>, reach: f64) -> Option<Polished> {
        let border = self.border_at(start, sector)?;
        self.polished(start, border, reach, |_, test| test.g / test.slope)
    }

    /// The same with the border of a root of the same unknowns nearby, at this speed or at one beside.
    pub fn polish_with(&mut self, start: C64, border: Border) -> Option<Polished> {
        self.polished(start, border, f64::INFINITY, |_, test| test.g / test.slope)
    }

    /// By how much rounding of the entries of T can move a root, to first order, 1/s.
    pub fn rounding(&mut self, root: &Polished) -> f64 {
        self.moved_by_rounding(root.value, &root.right, &root.left, root.by_s)
    }

    fn moved_by_rounding(&mut self, s: C64, right: &[C64], left: &[C64], by_s: C64) -> f64 {
        let [value, _] = self.entries(s);
        let row = |i: usize| self.pattern.row(i).map(|(e, j)| value[e].abs() * right[j].abs()).sum::<f64>();
        let size: f64 = left.iter().enumerate().map(|(i, y)| y.abs() * row(i)).sum();
        f64::EPSILON * size / by_s.abs()
    }

    fn border_at(&mut self, s: C64, sector: Option<Sector>) -> Option<Border> {
        self.border(s, &self.members(sector))
    }

    /// The unknowns of a sector, or all.
    pub fn members(&self, sector: Option<Sector>) -> Vec<usize> {
        (0..self.size()).filter(|&i| sector.is_none_or(|k| self.sectors.of(i) == k)).collect()
    }

    /// `A0, A1, A2` of T where it is a polynomial.
    pub fn as_polynomial(&self) -> Option<&[Vec<C64>; 3]> {
        self.polynomial.as_ref()
    }

    /// The same beside a pole so close that Newton's method does not see the root from the start: steps to the zero of `a (s - z)/(s - p)` with the value and the slope here and the
    /// value at the place before.
    pub fn polish_beside_pole(&mut self, start: C64, sector: Option<Sector>) -> Option<Polished> {
        let mut before: Option<(C64, C64)> = None;
        let border = self.border_at(start, sector)?;
        self.polished(start, border, f64::INFINITY, |s, test| {
            let rate = test.slope / test.g;
            let pole = before.map_or(C64::ZERO, |(place, g)| {
                let (way, ratio) = (place - s, g / test.g);
                (C64::ONE + rate * way - ratio) / (way * (ratio - C64::ONE))
            });
            before = Some((s, test.g));
            (rate + pole).recip()
        })
    }

    /// A root by steps, which are subtracted, no farther than `reach` from the start. The last one says what the root may be off by; it is so small that the vectors before it serve.
    fn polished(&mut self, start: C64, border: Border, reach: f64, mut step: impl FnMut(C64, &Test) -> C64) -> Option<Polished> {
        let (mut s, mut last) = (start, f64::INFINITY);
        for iterations in 1..=MOST_STEPS {
            let size = s.abs();
            let mut test = self.test(s, &border)?;
            let mut change = step(s, &test);
            let mut length = change.abs();
            let mut confirmed = false;
            // Errors of the vectors are about the square of how steps shrink, those of g the square of that: where it is rounding the vectors serve once more.
            if length <= SHRUNK * last
                && length <= NEAR * size
                && let Some(g) = self.form(s - change, &border, &test)
            {
                (s, last, test.g) = (s - change, length, g);
                change = step(s, &test);
                length = change.abs();
                // the last step left this much, and this one leaves less by the factor that the vectors are wrong by
                confirmed = length <= CONFIRMED * size;
            }
            if !change.is_finite() {
                return None;
            }
            // in turning axes T is evaluated at s + i W, and its rounding is that of the sum
            let resolved = 1e-14 * (size + self.shift(Sector::Forward).abs());
            let rounding = |t: &mut Self| {
                let (right, left) = (border.spread(&test.right, &border.cols, t.size()), border.spread(&test.left, &border.rows, t.size()));
                MOVES * t.moved_by_rounding(s, &right, &left, test.slope)
            };
            let small = confirmed
                || length <= 1e-15 * size
                || (length >= 0.5 * last && (length <= NEAR * size || length <= resolved || length <= rounding(self)));
            if small {
                let right = border.spread(&test.right, &border.cols, self.size());
                let left = border.spread(&test.left, &border.rows, self.size());
                let (defect, by_s) = (test.g.abs(), -test.slope);
                return Some(Polished {
                    value: s - change,
                    right,
                    left,
                    defect,
                    step: length,
                    iterations,
                    by_s,
                    border: border.towards(test)?,
                });
            }
            s -= change;
            if (s - start).abs() > reach {
                return None;
            }
            last = length;
        }
        None
    }
}

/// Tangents of the nonlinear parts at the equilibrium over the unknowns, in sector coordinates, as entries: in the unknowns, their first and second rates.
/// States behind those of the linear model are those of nonlinear parts.
fn tangents(
    system: &System,
    about: &Equilibrium,
    coordinates: &Sectors,
    sectors: &Sectors,
    states: &[usize],
    model: &LinearModel<D1>,
) -> [Vec<C64>; 3] {
    let (n, first, pattern) = (system.n(), model.held(), model.pattern());
    let (v, a) = (about.velocity(coordinates), about.acceleration(coordinates));
    let at = At { q: &about.q, v: &v, a: &a, z: &about.z, phase: 0.0, speed: about.speed, spin_accel: 0.0, t: 0.0 };
    let (mut t, mut ts) = (SparseTangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut t, &mut ts, |s| !s.is_linear());
    let mut out = [(); 3].map(|()| vec![C64::ZERO; pattern.entries()]);
    each_tangent_entry(&t, pattern, (n, first), states, |power, e, x| out[power][e].re += x);
    out.iter_mut().for_each(|all| sectors.polarise_entries(pattern, all));
    out
}

/// Calls `add` with the power of s, the entry of the pattern and the value of all that nonlinear parts add to T(s): over n coordinates and `states`, of which those from unknown `first` on are theirs.
pub(crate) fn each_tangent_entry(
    t: &SparseTangent,
    pattern: &Pattern,
    (n, first): (usize, usize),
    states: &[usize],
    mut add: impl FnMut(usize, usize, f64),
) {
    let mut unknown = vec![usize::MAX; states.iter().max().map_or(0, |z| z + 1)];
    states.iter().enumerate().for_each(|(k, &z)| unknown[z] = n + k);
    let mut place = |power: usize, i: usize, j: usize, x: f64| {
        if let Some(e) = pattern.index(i, j) {
            add(power, e, x);
        }
    };
    for (power, (top, bottom)) in [(&t.q, &t.rate_q), (&t.v, &t.rate_v), (&t.a, &t.rate_a)].into_iter().enumerate() {
        top.0.iter().for_each(|&(i, j, x)| place(power, i, j, x));
        bottom.0.iter().for_each(|&(i, j, x)| place(power, unknown[i], j, -x));
    }
    t.z.0.iter().for_each(|&(i, j, x)| place(0, i, unknown[j], x));
    t.rate_z.0.iter().for_each(|&(i, j, x)| place(0, unknown[i], unknown[j], -x));
    (first..pattern.n()).for_each(|i| place(1, i, i, 1.0));
}

/// `A0 + s A1 + s^2 A2`, and its derivative.
fn evaluated([a0, a1, a2]: &[Vec<C64>; 3], s: C64) -> [Vec<C64>; 2] {
    let mut out = [Vec::with_capacity(a0.len()), Vec::with_capacity(a0.len())];
    for ((&a0, &a1), &a2) in a0.iter().zip(a1).zip(a2) {
        let square = s * a2;
        out[0].push(a0 + s * (a1 + square));
        out[1].push(a1 + square.scale(2.0));
    }
    out
}

/// A root of the characteristic function.
#[derive(Clone, Debug)]
pub struct Polished {
    /// s.
    pub value: C64,
    /// Right null vector over all unknowns, in sector coordinates.
    pub right: Vec<C64>,
    /// Left null vector (`y^H T = 0`).
    pub left: Vec<C64>,
    /// Size of the relative change of T that makes it exactly singular.
    pub defect: f64,
    /// Last Newton step, 1/s.
    pub step: f64,
    /// Newton steps.
    pub iterations: usize,
    /// `y^H dT/ds x` of the null vectors.
    pub by_s: C64,
    /// For roots nearby.
    pub border: Border,
}
