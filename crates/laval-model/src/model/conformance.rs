//! The conformance suite: what every part promises by being a [`Part`], tested on its own, away from any machine.
//!
//! A part's file ends with [`conformance!`](crate::conformance): one line per variant of the part. Each check can be failed, and is shown to be
//! by deliberately wrong parts in the tests of this module. A number that is not finite fails every comparison.

use super::blocks::Blocks;
use super::erased::{D1, D8, Erased, Evaluate};
use super::lanes::{Inertial, InertialArgs};
use super::params::{Family, Parametric as _};
use super::part::{At, DofKind, Params, Part, Physics, Rows};
use laval_num::lanes::Slots;
use laval_num::scalar::Scalar;

mod capabilities;
mod fields;
mod linear;
#[cfg(test)]
mod tests;

pub use capabilities::{Implements, Otherwise, declared, undeclared};
pub use fields::check_fields;
pub use linear::local_stiffness;

/// Sizes of the random states a part is tried at, and what it claims.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Displacements at ports, m.
    pub length: f64,
    /// Tilts at ports, rad.
    pub tilt: f64,
    /// Typical rate, 1/s: velocities are displacements times this, accelerations times its square.
    pub rate: f64,
    /// Spin speed, rad/s: states have between a fifth of it and all of it.
    pub speed: f64,
    /// Spin acceleration, rad/s^2.
    pub spin_accel: f64,
    /// The part is the same in all directions. Tested both ways: a part that is must say so.
    pub isotropic: bool,
    /// The part keeps an account of its energy.
    pub energy: bool,
    /// Number of random states.
    pub states: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options { length: 1e-3, tilt: 1e-2, rate: 300.0, speed: 500.0, spin_accel: 4e4, isotropic: true, energy: true, states: 12 }
    }
}

impl Options {
    /// For a part that knows its directions.
    pub fn anisotropic() -> Self {
        Options { isotropic: false, ..Self::default() }
    }
}

/// A promise of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Promise {
    /// Sizes of parameters, states and shape agree with the layout.
    Layout,
    /// Exact derivatives agree with central differences.
    Tangents,
    /// Affine in accelerations and spin acceleration together.
    Affine,
    /// The masses it gives are its derivatives in the accelerations, and the rows beside them its residual.
    Inertia,
    /// What is not declared in [`Part::uses`] is not read.
    Uses,
    /// A linear part is its blocks, superposes, has symmetric M and skew G and N.
    Blocks,
    /// Turning state and phase turns the forces, as claimed.
    Isotropy,
    /// Power at ports and spin = d(stored)/dt + dissipated - supplied.
    Power,
    /// Values and derivatives are finite at rest and at zero speed.
    Rest,
    /// What is not a number is not hidden.
    NotANumber,
    /// Z(conj s) = conj Z(s), derivative in speed, agreement with the time form.
    Impedance,
    /// Declarations of parameters and fields.
    Fields,
}

/// A broken promise.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// Which.
    pub promise: Promise,
    /// By how much, where.
    pub detail: String,
}

/// `|error| <= tolerance * size`, false for anything that is not a number.
fn within(error: f64, tolerance: f64, size: f64) -> bool {
    error.abs() <= tolerance * size && size.is_finite()
}

/// Random numbers in [-1, 1], the same in every run.
struct Pseudo(u64);
impl Pseudo {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// A part on the bench: every input (q, v, a, z, phase, speed, spin_accel, t, parameters) is one entry of a flat vector, every output (force
/// rows, rates, spin row) one entry of another.
struct Bench<'a, P: Part> {
    part: &'a P,
    options: &'a Options,
    n: usize,
    m: usize,
    params: Vec<f64>,
    kinds: Vec<DofKind>,
    state_kinds: Vec<DofKind>,
    scale: Vec<f64>,
    failures: Vec<Failure>,
}

/// Tries a part at random states; returns the promises it breaks.
pub fn check<P: Part>(part: &P, params: &Params<P, f64>, options: &Options) -> Vec<Failure> {
    let mut bench = Bench::new(part, P::Family::to_vec(params), options);
    bench.layout();
    if bench.failures.is_empty() {
        bench.tangents();
        bench.affine();
        bench.inertia();
        bench.blocks();
        bench.steady();
        bench.isotropy();
        bench.power();
        bench.rest();
        bench.not_a_number();
        bench.impedance();
    }
    bench.failures
}

fn turn(kinds: &[DofKind], x: &mut [f64], angle: f64) {
    let (s, co) = angle.sin_cos();
    for i in (0..x.len()).filter(|&i| kinds[i].leads_pair()) {
        (x[i], x[i + 1]) = (co * x[i] - s * x[i + 1], s * x[i] + co * x[i + 1]);
    }
}

impl<'a, P: Part> Bench<'a, P> {
    fn new(part: &'a P, params: Vec<f64>, options: &'a Options) -> Self {
        let layout = Part::layout(part);
        let kinds = layout.kinds();
        let port = kinds.len() - layout.own.len();
        let lengths = kinds[..port]
            .iter()
            .map(|k| if matches!(k, DofKind::TiltX | DofKind::TiltY | DofKind::Twist) { options.tilt } else { options.length });
        let q: Vec<f64> = lengths.chain(layout.own.iter().map(|d| d.typical)).collect();
        let mut scale = q.clone();
        scale.extend(q.iter().map(|x| x * options.rate));
        scale.extend(q.iter().map(|x| x * options.rate * options.rate));
        scale.extend(layout.states.iter().map(|d| d.typical));
        scale.extend([1.0, options.speed, options.spin_accel, 1.0]);
        scale.extend(params.iter().map(|x| x.abs()));
        let state_kinds: Vec<DofKind> = layout.states.iter().map(|d| d.kind).collect();
        Bench { part, options, n: kinds.len(), m: state_kinds.len(), params, kinds, state_kinds, scale, failures: Vec::new() }
    }

    fn fail(&mut self, promise: Promise, detail: String) {
        self.failures.push(Failure { promise, detail });
    }
    fn spin_at(&self) -> usize {
        3 * self.n + self.m
    }
    fn params_at(&self) -> usize {
        self.spin_at() + 4
    }
    fn input_name(&self, j: usize) -> String {
        let (n, spin) = (self.n, self.spin_at());
        match j {
            _ if j < 3 * n => format!("{}[{}]", ["q", "v", "a"][j / n], j % n),
            _ if j < spin => format!("z[{}]", j - 3 * n),
            _ if j < self.params_at() => ["phase", "speed", "spin_accel", "t"][j - spin].into(),
            _ => P::Family::all_slots(self.part.row_counts()).get(j - self.params_at()).map_or("parameter".into(), |s| s.name.clone()),
        }
    }
    fn output_name(&self, i: usize) -> String {
        if i < self.n {
            format!("force[{i}]")
        } else if i < self.n + self.m {
            format!("rate[{}]", i - self.n)
        } else {
            "spin row".into()
        }
    }
    fn at<'x, S: Scalar>(&self, x: &'x [S]) -> At<'x, S> {
        let (n, spin) = (self.n, self.spin_at());
        let [phase, speed, spin_accel, t] = [0, 1, 2, 3].map(|k| x[spin + k]);
        At { q: &x[..n], v: &x[n..2 * n], a: &x[2 * n..3 * n], z: &x[3 * n..spin], phase, speed, spin_accel, t }
    }
    fn eval<S: Evaluate>(&self, x: &[S]) -> Vec<S> {
        let mut out = vec![S::zero(); self.n + self.m + 1];
        let (force, rest) = out.split_at_mut(self.n);
        let (rate, spin) = rest.split_at_mut(self.m);
        let mut rows = Rows { force, rate, spin: &mut spin[0] };
        S::residual(self.part, &x[self.params_at()..], &self.at(x), &mut rows, &mut Blocks::default());
        out
    }
    /// Columns of derivatives, by forward mode.
    fn jacobian(&self, x: &[f64]) -> Vec<Vec<f64>> {
        let mut columns = Vec::with_capacity(x.len());
        let lifted: Vec<D8> = x.iter().map(|&x| D8::lift(x)).collect();
        for first in (0..x.len()).step_by(8) {
            let mut seeded = lifted.clone();
            let width = (x.len() - first).min(8);
            for k in 0..width {
                seeded[first + k].eps[k] = 1.0;
            }
            let out = self.eval(&seeded);
            columns.extend((0..width).map(|k| out.iter().map(|o| o.eps[k]).collect::<Vec<f64>>()));
        }
        columns
    }
    fn states(&self) -> Vec<Vec<f64>> {
        let mut random = Pseudo(17);
        let spin = self.spin_at();
        (0..self.options.states)
            .map(|_| {
                let mut x: Vec<f64> = self.scale.iter().map(|s| s * random.next()).collect();
                x[spin] *= std::f64::consts::PI;
                x[spin + 1] = self.options.speed * (0.6 + 0.4 * random.next());
                x[self.params_at()..].copy_from_slice(&self.params);
                x
            })
            .collect()
    }
    /// Size of each output: its value and the terms that cancel in it.
    fn sizes(&self, value: &[f64], jacobian: &[Vec<f64>]) -> Vec<f64> {
        let term = |i: usize| jacobian.iter().zip(&self.scale).map(|(col, s)| (col[i] * s).abs()).sum::<f64>();
        value.iter().enumerate().map(|(i, f)| f.abs() + term(i)).collect()
    }
    fn compare(&mut self, promise: Promise, what: &str, a: &[f64], b: &[f64], size: &[f64], tolerance: f64) {
        debug_assert_eq!(a.len(), b.len());
        for (i, ((x, y), size)) in a.iter().zip(b).zip(size).enumerate() {
            if !within(x - y, tolerance, *size) {
                let text = format!("{what}: {} is {x:e}, expected {y:e} (size {size:e})", self.output_name(i));
                return self.fail(promise, text);
            }
        }
    }

    fn layout(&mut self) {
        let layout = Part::layout(self.part);
        let slots = P::Family::all_slots(self.part.row_counts()).len();
        let lists = P::Family::lists();
        let scalars = P::Family::COUNT + lists.iter().zip(self.part.row_counts()).map(|(l, rows)| l.slots.len() * rows).sum::<usize>();
        if slots != scalars || slots != self.params.len() {
            self.fail(Promise::Layout, format!("{slots} slots, {scalars} scalars, {} values", self.params.len()));
        }
        for kinds in [self.kinds.clone(), self.state_kinds.clone()] {
            for (i, k) in kinds.iter().enumerate() {
                let paired = if k.leads_pair() {
                    kinds.get(i + 1).is_some_and(|k| k.ends_pair())
                } else {
                    !k.ends_pair() || i > 0 && kinds[i - 1].leads_pair()
                };
                if !paired {
                    self.fail(Promise::Layout, format!("coordinate {i} ({k:?}) has no partner that turns with it"));
                }
            }
        }
        if Part::memory(self.part) > self.m {
            self.fail(Promise::Layout, "more memory states than states".into());
        }
        let shape = Part::body(self.part).map_or_else(Vec::new, |b| b.shape(&self.params, 0.1));
        if shape.len() != if layout.body { self.n } else { 0 } {
            self.fail(Promise::Layout, format!("shape has {} rows for {} local coordinates", shape.len(), self.n));
        }
        let complaints = Erased::check(self.part, &self.params);
        if !complaints.is_empty() {
            self.fail(Promise::Layout, format!("the part refuses the parameters it is tried with: {complaints:?}"));
        }
    }

    fn switches(&self, x: &[f64]) -> Vec<bool> {
        let mut out = Vec::new();
        if let Some(contacts) = Part::contacts(self.part) {
            contacts.switches(&x[self.params_at()..], &self.at(x), &mut out);
        }
        out.iter().map(|s| *s > 0.0).collect()
    }

    fn tangents(&mut self) {
        let uses = Part::uses(self.part);
        let nonlinear = Part::physics(self.part) == Physics::Nonlinear;
        let mut tried = vec![false; self.scale.len()];
        for x in self.states() {
            let (value, jacobian) = (self.eval(&x), self.jacobian(&x));
            let size = self.sizes(&value, &jacobian);
            for j in 0..x.len() {
                let h = 1e-3 * self.scale[j];
                if h == 0.0 {
                    tried[j] = true;
                    continue;
                }
                let moved = |k: f64| {
                    let mut y = x.clone();
                    y[j] += k * h;
                    y
                };
                // differences are good only away from the declared switching surfaces, where higher derivatives may be large
                let side = self.switches(&moved(32.0));
                if [-32.0, -2.0, 0.0, 2.0].iter().any(|&k| self.switches(&moved(k)) != side) {
                    continue;
                }
                tried[j] = true;
                let f = [-2.0, -1.0, 1.0, 2.0].map(|k| self.eval(&moved(k)));
                let difference: Vec<f64> = (0..value.len()).map(|i| (8.0 * (f[2][i] - f[1][i]) - (f[3][i] - f[0][i])) / 12e-3).collect();
                let exact: Vec<f64> = jacobian[j].iter().map(|d| d * self.scale[j]).collect();
                let size: Vec<f64> = size.iter().zip(&difference).map(|(s, d)| s + d.abs()).collect();
                let what = format!("derivative over {}", self.input_name(j));
                self.compare(Promise::Tangents, &what, &exact, &difference, &size, 1e-7);
            }
            let spin = self.spin_at();
            for (used, range, what) in [
                (uses.velocity, self.n..2 * self.n, "velocity"),
                (uses.acceleration, 2 * self.n..3 * self.n, "acceleration"),
                (uses.spin, spin..spin + 4, "spin"),
            ] {
                if nonlinear && !used && jacobian[range].iter().flatten().any(|d| *d != 0.0) {
                    self.fail(Promise::Uses, format!("reads {what} without declaring it"));
                }
            }
        }
        if let Some(j) = tried.iter().position(|t| !t) {
            let text = format!("no state where {} can be varied without crossing a switching surface", self.input_name(j));
            self.fail(Promise::Tangents, text);
        }
    }

    fn affine(&mut self) {
        let states = self.states();
        for pair in states.windows(2) {
            let (x, mut y, mut middle) = (&pair[0], pair[0].clone(), pair[0].clone());
            for j in (2 * self.n..3 * self.n).chain([self.spin_at() + 2]) {
                y[j] = pair[1][j];
                middle[j] = 0.5 * (x[j] + y[j]);
            }
            let (f, g, h) = (self.eval(x), self.eval(&y), self.eval(&middle));
            let mean: Vec<f64> = f.iter().zip(&g).map(|(f, g)| 0.5 * (f + g)).collect();
            let size = self.sizes(&h, &self.jacobian(&middle));
            self.compare(Promise::Affine, "halfway between two accelerations", &h, &mean, &size, 1e-12);
        }
    }

    fn inertia(&mut self) {
        let Some(part) = Part::varying_inertia(self.part) else { return };
        for x in self.states() {
            let (n, value, jacobian) = (self.n, self.eval(&x), self.jacobian(&x));
            let (mut out, mut mass) = (vec![0.0; value.len()], vec![0.0; n * n]);
            let (force, rest) = out.split_at_mut(n);
            let (rate, spin) = rest.split_at_mut(self.m);
            let out_rows = Rows { force, rate, spin: &mut spin[0] };
            Slots::<Inertial>::scalar(part, &mut InertialArgs { p: &self.params, at: self.at(&x), out: out_rows, mass: &mut mass });
            let size = self.sizes(&value, &jacobian);
            self.compare(Promise::Inertia, "beside the masses", &out, &value, &size, 1e-12);
            for j in 0..n {
                let column: Vec<f64> = (0..n).map(|i| mass[i * n + j]).collect();
                let scale = self.scale[2 * n + j];
                let size: Vec<f64> = (0..n).map(|i| jacobian[2 * n + j][i].abs() + 1e-3 * size[i] / scale).collect();
                let what = format!("mass of {}", self.input_name(2 * n + j));
                self.compare(Promise::Inertia, &what, &column, &jacobian[2 * n + j][..n], &size, 1e-12);
            }
        }
    }

    fn isotropy(&mut self) {
        let mut turns = true;
        for (k, x) in self.states().into_iter().enumerate() {
            let angle = 0.3 + 0.9 * k as f64;
            let (n, spin) = (self.n, self.spin_at());
            let mut y = x.clone();
            for first in [0, n, 2 * n] {
                turn(&self.kinds, &mut y[first..first + n], angle);
            }
            turn(&self.state_kinds, &mut y[3 * n..spin], angle);
            y[spin] += angle;
            let (mut f, g) = (self.eval(&x), self.eval(&y));
            let size = self.sizes(&f, &self.jacobian(&x));
            turn(&self.kinds, &mut f[..n], angle);
            turn(&self.state_kinds, &mut f[n..n + self.m], angle);
            for i in 0..f.len() {
                let kind = self.kinds.iter().chain(&self.state_kinds).nth(i);
                let partner = match kind {
                    Some(k) if k.leads_pair() => i + 1,
                    Some(k) if k.ends_pair() => i - 1,
                    _ => i,
                };
                turns &= within(f[i] - g[i], 1e-11, size[i] + size[partner]);
            }
        }
        if turns != self.options.isotropic {
            let what = if turns { "is the same in all directions and does not say so" } else { "is not the same in all directions" };
            self.fail(Promise::Isotropy, what.into());
        }
    }

    fn power(&mut self) {
        let mut random = Pseudo(5);
        for x in self.states() {
            let f = self.eval(&x);
            let at = self.at(&x);
            let Some(e) = Part::energy(self.part, &self.part.given(&self.params), &at) else {
                if self.options.energy {
                    self.fail(Promise::Power, "keeps no account of its energy".into());
                }
                return;
            };
            // along the motion: q' = v, v' = a, z' = rate, phase' = speed, speed' = spin_accel; the jerk must not matter
            let (n, m, spin) = (self.n, self.m, self.spin_at());
            let mut moving: Vec<D1> = x.iter().map(|&x| D1::lift(x)).collect();
            for j in 0..2 * n {
                moving[j].eps[0] = x[n + j];
            }
            for (a, scale) in moving[2 * n..3 * n].iter_mut().zip(&self.scale[2 * n..]) {
                a.eps[0] = scale * self.options.rate * random.next();
            }
            for j in 0..m {
                moving[3 * n + j].eps[0] = f[n + j];
            }
            moving[spin].eps[0] = at.speed;
            moving[spin + 1].eps[0] = at.spin_accel;
            moving[spin + 2].eps[0] = self.options.spin_accel * self.options.rate * random.next();
            moving[spin + 3].eps[0] = 1.0;
            let p = self.part.given(&moving[self.params_at()..]);
            let rate = Part::energy(self.part, &p, &self.at(&moving)).map_or(f64::NAN, |e| e.stored.eps[0]);
            let terms: Vec<f64> = (0..n).map(|i| at.v[i] * f[i]).chain([at.speed * f[n + m], -rate, -e.dissipated, e.supplied]).collect();
            let (error, size) = (terms.iter().sum::<f64>(), terms.iter().map(|t| t.abs()).sum::<f64>());
            if !within(error, 1e-11, size) {
                let text = format!(
                    "ports and spin take {:e} W; stored rises by {rate:e}, dissipated {:e}, supplied {:e} W",
                    terms[..=n].iter().sum::<f64>(),
                    e.dissipated,
                    e.supplied
                );
                return self.fail(Promise::Power, text);
            }
        }
    }

    fn rest(&mut self) {
        for speed in [0.0, self.options.speed] {
            let mut x = vec![0.0; self.scale.len()];
            x[self.spin_at() + 1] = speed;
            x[self.params_at()..].copy_from_slice(&self.params);
            let (value, jacobian) = (self.eval(&x), self.jacobian(&x));
            for (j, column) in jacobian.iter().chain([&value]).enumerate() {
                if let Some(i) = column.iter().position(|d| !d.is_finite()) {
                    let what = if j < x.len() { format!("derivative over {}", self.input_name(j)) } else { "value".into() };
                    let text = format!("{what} of {} is not finite at rest, speed {speed}", self.output_name(i));
                    self.fail(Promise::Rest, text);
                }
            }
            let at = self.at(&x);
            let p = self.part.given(&self.params);
            let (mut observed, mut validity) = (Vec::new(), Vec::new());
            Part::observe(self.part, &p, &at, &mut observed);
            Part::validity(self.part, &p, &at, &mut validity);
            let energy =
                Part::energy(self.part, &p, &at).is_none_or(|e| e.stored.is_finite() && e.dissipated.is_finite() && e.supplied.is_finite());
            if !energy || observed.iter().any(|o| !o.value.is_finite()) || validity.iter().any(|v| v.ratio.is_nan()) {
                self.fail(Promise::Rest, format!("energy, an observed quantity or a validity is not a number at rest, speed {speed}"));
            }
        }
    }

    fn not_a_number(&mut self) {
        let states = self.states();
        // an output that reads an input at any of the states must not hide it at another
        let jacobians: Vec<Vec<Vec<f64>>> = states.iter().map(|x| self.jacobian(x)).collect();
        for (state, x) in states.iter().enumerate() {
            for j in 0..x.len() {
                let mut y = x.clone();
                y[j] = f64::NAN;
                let out = self.eval(&y);
                // a table reads the rows beside an argument alone
                let in_row = j >= self.params_at() + P::Family::COUNT;
                let read = |i: usize| jacobians.iter().enumerate().any(|(s, d)| d[j][i] != 0.0 && (s == state || !in_row));
                if let Some(i) = (0..out.len()).find(|&i| !out[i].is_nan() && read(i)) {
                    let text = format!("{} stays {:e} when {} is not a number", self.output_name(i), out[i], self.input_name(j));
                    self.fail(Promise::NotANumber, text);
                }
            }
            let mut lost = x.clone();
            lost[..self.params_at()].fill(f64::NAN);
            let mut validity = Vec::new();
            Part::validity(self.part, &self.part.given(&self.params), &self.at(&lost), &mut validity);
            if let Some(v) = validity.iter().find(|v| v.ratio <= 1.0) {
                self.fail(Promise::NotANumber, format!("a state that is not a number passes \"{}\"", v.what));
            }
        }
    }
}

/// Panics with everything that is broken.
pub fn assert_none(failures: &[Failure]) {
    let lines: Vec<String> = failures.iter().map(|f| format!("{:?}: {}", f.promise, f.detail)).collect();
    assert!(lines.is_empty(), "broken promises:\n{}", lines.join("\n"));
}

/// Runs the conformance suite at the foot of a part's file: the part's type, then one line `name: part, parameters, options;` per variant.
#[macro_export]
macro_rules! conformance {
    ($part:ty { $( $name:ident: $make:expr, $params:expr, $options:expr; )* }) => {
        #[cfg(test)]
        mod conformance {
            use super::*;
            use $crate::model::conformance::{Options, assert_none, check, check_fields, declared, undeclared};
            #[allow(unused_imports)]
            use $crate::model::params::Family as _;
            #[test]
            fn fields() {
                assert_none(&check_fields::<$part>());
            }
            #[test]
            fn capabilities() {
                let forgotten = undeclared($crate::implemented!($part), &[$( declared(&$make) ),*]);
                assert!(forgotten.is_empty(), "implemented, but declared by no variant: {forgotten:?}");
            }
            $(
                #[test]
                fn $name() {
                    assert_none(&check(&$make, &$params.into(), &$options));
                }
            )*
        }
    };
}
