//! Fourier series by sampling: the alternating frequency-time step of harmonic balance, small transforms, order amplitudes, windows.
//!
//! Conventions: `z(t) = sum c_k e^(i k t)` over signed orders k, `x(t) = a_0 + sum (a_k cos k t + b_k sin k t)` over k > 0, with t the phase in
//! radians; coefficients of a transform carry the factor 1/N, so that they are amplitudes.
//!
//! Angles are reduced in integers before a sine is taken, and one octant supplies the whole circle, so that symmetries of the
//! samples are exact.

use crate::complex::{C64, c};
use crate::dense::{Field, Mat};
use std::f64::consts::PI;

/// `e^(2 pi i k/n)` with exact symmetry in all eight octants; exact at multiples of a quarter turn. n must not be zero.
pub fn unit_root(k: i64, n: u64) -> C64 {
    assert!(n > 0, "a circle has at least one sample");
    let n = i128::from(n);
    let k = i128::from(k).rem_euclid(n);
    // 8 k/n counts octants; `part` is the distance to the nearest multiple of a quarter turn, in units of turn/(4 n).
    let quarter = (8 * k + n) / (2 * n) % 4;
    let part = 4 * k - (8 * k + n) / (2 * n) * n;
    let angle = 0.5 * PI * (part.abs() as f64 / n as f64);
    // At an odd octant the sine and cosine of pi/4 must be the same number.
    let (s, co) = if 2 * part.abs() == n { (std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2) } else { angle.sin_cos() };
    let s = if part < 0 { -s } else { s };
    match quarter {
        0 => c(co, s),
        1 => c(-s, co),
        2 => c(-co, -s),
        _ => c(s, -co),
    }
}

/// The roots of unity of a circle, each computed once.
///
/// ```
/// let roots = laval_num::fourier::Roots::new(12);
/// assert!((roots.at(5, 7) - laval_num::complex::C64::cis(35.0 * std::f64::consts::TAU / 12.0)).abs() < 1e-14);
/// ```
#[derive(Clone, Debug)]
pub struct Roots(Vec<C64>);

impl Roots {
    /// Of n samples of a period, at least one.
    pub fn new(n: usize) -> Self {
        Roots((0..n as i64).map(|j| unit_root(j, n as u64)).collect())
    }

    /// Number of samples.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// `e^(2 pi i k j/n)`: order k at sample j.
    pub fn at(&self, k: usize, j: usize) -> C64 {
        self.0[k * j % self.0.len()]
    }

    /// The phase of sample j, rad.
    pub fn phase(&self, j: usize) -> f64 {
        2.0 * PI * (j as f64 / self.0.len() as f64)
    }
}

/// Largest value over the period of the trigonometric polynomial through equidistant samples: of a signal whose harmonics are fewer than half of the samples,
/// its own largest value. At least the largest sample; NaN where one is.
///
/// ```
/// let samples: Vec<f64> = (0..12).map(|j| 2.0 + (j as f64 * std::f64::consts::TAU / 12.0 - 0.2).cos()).collect();
/// assert!((laval_num::fourier::largest(&samples) - 3.0).abs() < 1e-14);
/// ```
pub fn largest(samples: &[f64]) -> f64 {
    let n = samples.len() as u64;
    let Some(top) = (0..samples.len()).max_by(|&a, &b| samples[a].total_cmp(&samples[b])) else { return f64::NAN };
    if samples.iter().any(|x| !x.is_finite()) {
        return if samples.iter().any(|x| x.is_nan()) { f64::NAN } else { samples[top] };
    }
    let roots = Roots::new(samples.len());
    let amplitude = |k: i64| {
        let sum = samples.iter().enumerate().fold(C64::ZERO, |sum, (j, &x)| sum + roots.at(k as usize, j).conj().scale(x));
        // the cosine of half as many periods as samples stands for both directions
        sum.scale(if 2 * k == n as i64 { 1.0 } else { 2.0 } / n as f64)
    };
    let amplitudes: Vec<C64> = (1..=n as i64 / 2).map(amplitude).collect();
    let mean = samples.iter().sum::<f64>() / n as f64;
    let at = |phase: f64| {
        amplitudes.iter().zip(1..).fold([mean, 0.0, 0.0], |[x, dx, ddx], (a, k)| {
            let (z, k) = (*a * C64::cis(f64::from(k) * phase), f64::from(k));
            [x + z.re, dx - k * z.im, ddx - k * k * z.re]
        })
    };
    let step = 2.0 * PI / n as f64;
    let (mut phase, mut best) = (top as f64 * step, samples[top]);
    for _ in 0..8 {
        let [x, dx, ddx] = at(phase);
        best = best.max(x);
        if !(ddx < 0.0) {
            break;
        }
        phase -= (dx / ddx).clamp(-step, step);
    }
    best
}

/// Samples per period with which the harmonics 0..=H of a polynomial of degree p in signals with harmonics 0..=H are free of aliasing:
/// `(p + 1) H + 1`. One less is not enough: harmonic p H then falls on harmonic -H.
pub fn samples_for(degree: usize, harmonics: usize) -> usize {
    (degree + 1) * harmonics + 1
}

/// Orders and samples that do not fit each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SamplingError {
    /// No samples, or a fraction of zero.
    Empty,
    /// Two orders give the same samples.
    Aliased(i32, i32),
    /// Over part of a period the orders must leave the same remainder when divided by the fraction; these do not.
    Fraction(i32, i32),
}

impl std::fmt::Display for SamplingError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            SamplingError::Empty => f.write_str("sampling needs at least one sample and a fraction of at least one"),
            SamplingError::Aliased(a, b) => write!(f, "too few samples: orders {a} and {b} cannot be distinguished"),
            SamplingError::Fraction(a, b) => write!(f, "orders {a} and {b} do not share the symmetry that a part of a period needs"),
        }
    }
}
impl std::error::Error for SamplingError {}

/// Phases `2 pi j/(N m)`, j = 0..N: N samples over the m-th part of a period.
///
/// A part of the period suffices when all orders leave the same remainder r modulo m: then `z(t + T/m) = e^(2 pi i r/m) z(t)`. For real
/// signals this means m = 1, or m = 2 with odd (or even) orders only, or any m with multiples of m. The nonlinearity must keep the symmetry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    samples: usize,
    fraction: usize,
}

/// Matrices between coefficients and samples. `analysis * synthesis` is the identity.
#[derive(Clone, Debug, PartialEq)]
pub struct Transform<T> {
    /// Samples from coefficients (samples x coefficients).
    pub synthesis: Mat<T>,
    /// Coefficients from samples (coefficients x samples).
    pub analysis: Mat<T>,
}

impl Sampling {
    /// `samples` over the whole period.
    pub fn period(samples: usize) -> Self {
        Sampling { samples, fraction: 1 }
    }
    /// `samples` over the `fraction`-th part of the period.
    pub fn part(samples: usize, fraction: usize) -> Self {
        Sampling { samples, fraction }
    }
    /// Number of samples.
    pub fn samples(&self) -> usize {
        self.samples
    }
    /// Phase of sample j, radians.
    pub fn phase(&self, j: usize) -> f64 {
        2.0 * PI * (j as f64 / self.turn() as f64)
    }

    fn turn(&self) -> u64 {
        self.samples as u64 * self.fraction as u64
    }
    fn root(&self, order: i32, j: usize) -> C64 {
        let n = self.turn();
        unit_root((i128::from(order) * j as i128).rem_euclid(i128::from(n)) as i64, n)
    }
    fn check(&self, orders: &[i32]) -> Result<(), SamplingError> {
        if self.turn() == 0 {
            return Err(SamplingError::Empty);
        }
        for (i, &a) in orders.iter().enumerate() {
            for &b in &orders[..i] {
                let d = (i64::from(a) - i64::from(b)).unsigned_abs();
                if !d.is_multiple_of(self.fraction as u64) {
                    return Err(SamplingError::Fraction(b, a));
                }
                if d.is_multiple_of(self.turn()) {
                    return Err(SamplingError::Aliased(b, a));
                }
            }
        }
        Ok(())
    }

    /// Signed orders of a complex signal; coefficient i belongs to `orders[i]`.
    pub fn signed(&self, orders: &[i32]) -> Result<Transform<C64>, SamplingError> {
        self.check(orders)?;
        let (n, m) = (self.samples, orders.len());
        let k = 1.0 / n as f64;
        Ok(Transform {
            synthesis: Mat::from_fn(n, m, |j, i| self.root(orders[i], j)),
            analysis: Mat::from_fn(m, n, |i, j| self.root(orders[i], j).conj().scale(k)),
        })
    }

    /// Harmonics of a real signal (distinct, not negative). Coefficients in the order given: one for harmonic 0, (cosine, sine) for others.
    pub fn real(&self, harmonics: &[u32]) -> Result<Transform<f64>, SamplingError> {
        let signed: Vec<i32> = harmonics.iter().flat_map(|&h| if h == 0 { vec![0] } else { vec![h as i32, -(h as i32)] }).collect();
        self.check(&signed)?;
        let columns: Vec<(u32, bool)> =
            harmonics.iter().flat_map(|&h| if h == 0 { vec![(0, false)] } else { vec![(h, false), (h, true)] }).collect();
        let value = |i: usize, j: usize| {
            let z = self.root(columns[i].0 as i32, j);
            if columns[i].1 { z.im } else { z.re }
        };
        let (n, m) = (self.samples, columns.len());
        let weight = |i: usize| if columns[i].0 == 0 { 1.0 } else { 2.0 } / n as f64;
        Ok(Transform { synthesis: Mat::from_fn(n, m, |j, i| value(i, j)), analysis: Mat::from_fn(m, n, |i, j| weight(i) * value(i, j)) })
    }

    /// Harmonics 0..=H of a real signal.
    pub fn harmonics(&self, h: u32) -> Result<Transform<f64>, SamplingError> {
        self.real(&(0..=h).collect::<Vec<_>>())
    }
}

/// Discrete Fourier transform of fixed length by its definition (N^2 operations), from one exact table.
#[derive(Clone, Debug)]
pub struct Dft {
    table: Vec<C64>,
}

impl Dft {
    /// Transform of length n > 0.
    pub fn new(n: usize) -> Self {
        Dft { table: (0..n).map(|k| unit_root(k as i64, n as u64)).collect() }
    }
    fn sum(&self, k: usize, x: impl Iterator<Item = C64>, conj: bool) -> C64 {
        let n = self.table.len();
        let (mut s, mut index) = (C64::ZERO, 0);
        for x in x {
            let w = self.table[index];
            s += x * if conj { w.conj() } else { w };
            index += k;
            if index >= n {
                index -= n;
            }
        }
        s
    }
    /// `c_k = 1/N sum_j x_j e^(-2 pi i j k/N)`, k = 0..N; order -k is at N - k.
    pub fn forward(&self, x: &[C64]) -> Vec<C64> {
        let n = self.table.len();
        assert_eq!(x.len(), n, "length of the sequence differs from the transform");
        (0..n).map(|k| self.sum(k, x.iter().copied(), true).scale(1.0 / n as f64)).collect()
    }
    /// `x_j = sum_k c_k e^(2 pi i j k/N)`.
    pub fn inverse(&self, coefficients: &[C64]) -> Vec<C64> {
        let n = self.table.len();
        assert_eq!(coefficients.len(), n, "length of the sequence differs from the transform");
        (0..n).map(|k| self.sum(k, coefficients.iter().copied(), false)).collect()
    }
    /// The coefficients c_k, k = 0..=N/2, of a real sequence; the others are their conjugates.
    pub fn forward_real(&self, x: &[f64]) -> Vec<C64> {
        let n = self.table.len();
        assert_eq!(x.len(), n, "length of the sequence differs from the transform");
        (0..n / 2 + 1).map(|k| self.sum(k, x.iter().map(|&x| c(x, 0.0)), true).scale(1.0 / n as f64)).collect()
    }
}

/// Discrete Fourier transform of a length that is a power of two, in N log N operations (Cooley and Tukey, radix 2, in place), from one exact table.
#[derive(Clone, Debug)]
pub struct Fft {
    /// `e^(-2 pi i k/N)` for the first half of the circle.
    table: Vec<C64>,
    n: usize,
}

impl Fft {
    /// Transform of the smallest power of two that is not below `n`.
    pub fn at_least(n: usize) -> Self {
        let n = n.max(1).next_power_of_two();
        Fft { table: (0..n / 2).map(|k| unit_root(-(k as i64), n as u64)).collect(), n }
    }
    /// Its length.
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.n
    }
    /// `c_k = 1/N sum_j x_j e^(-2 pi i j k/N)` in place of x, k = 0..N; order -k is at N - k.
    pub fn forward(&self, x: &mut [C64]) {
        let n = self.n;
        assert_eq!(x.len(), n, "length of the sequence differs from the transform");
        for (i, j) in (0..n).map(|i| (i, if n > 1 { i.reverse_bits() >> (usize::BITS - n.trailing_zeros()) } else { i })) {
            if i < j {
                x.swap(i, j);
            }
        }
        let mut half = 1;
        while half < n {
            let stride = n / (2 * half);
            for block in x.chunks_exact_mut(2 * half) {
                let (low, high) = block.split_at_mut(half);
                for (k, (a, b)) in low.iter_mut().zip(high).enumerate() {
                    let t = *b * self.table[k * stride];
                    (*a, *b) = (*a + t, *a - t);
                }
            }
            half *= 2;
        }
        let gain = 1.0 / n as f64;
        x.iter_mut().for_each(|x| *x = x.scale(gain));
    }
}

/// Coefficient of a signed order from equally spaced samples over a whole number of periods (the end point not repeated):
/// `1/N sum z_j e^(-i order phase_j)`. A real signal has amplitude `2 |c|` at order > 0. Zero for an empty signal.
pub fn order_coefficient<T: Copy + Into<C64>>(signal: &[T], periods: u32, order: i32) -> C64 {
    let n = signal.len() as u64;
    if n == 0 {
        return C64::ZERO;
    }
    let step = (i128::from(order) * i128::from(periods)).rem_euclid(i128::from(n));
    let sum = signal.iter().enumerate().fold(C64::ZERO, |s, (j, &z)| {
        let k = (step * j as i128).rem_euclid(i128::from(n)) as i64;
        s + z.into() * unit_root(k, n).conj()
    });
    sum.scale(1.0 / n as f64)
}

/// Hann window of length n, periodic: `(1 - cos(2 pi j/n))/2`. Its mean is 1/2 for n > 1.
pub fn hann(n: usize) -> Vec<f64> {
    (0..n).map(|j| 0.5 * (1.0 - unit_root(j as i64, n as u64).re)).collect()
}

/// One-sided amplitude spectrum of a real signal with a Hann window: a sine of amplitude a whose frequency is one of the lines has
/// height a there (and a/2 on both neighbours); between two lines the height falls by at most 15 %. Line k is at frequency
/// k/(N dt). The mean is removed before the window is applied and reported as line 0.
pub fn hann_spectrum(signal: &[f64]) -> Vec<f64> {
    let n = signal.len();
    if n == 0 {
        return vec![];
    }
    let mean = signal.iter().sum::<f64>() / n as f64;
    let windowed: Vec<f64> = signal.iter().zip(hann(n)).map(|(&x, w)| (x - mean) * w).collect();
    let lines = Dft::new(n).forward_real(&windowed);
    // Two-sided to one-sided (2, except at the Nyquist line) times one over the mean of the window (2).
    let gain = |k: usize| if 2 * k == n { 2.0 } else { 4.0 };
    let spectrum = lines.iter().enumerate().map(|(k, z)| if k == 0 { mean.abs() } else { gain(k) * z.abs() });
    spectrum.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn identity_error<T: Field>(t: &Transform<T>) -> f64 {
        let mut p = t.analysis.matmul(&t.synthesis);
        for i in 0..p.rows() {
            p[(i, i)] -= T::ONE;
        }
        p.max_size()
    }

    #[test]
    fn roots_of_unity_are_exactly_symmetric() {
        for n in [1u64, 2, 3, 4, 5, 8, 12, 37, 360, 1000] {
            for k in 0..n as i64 {
                let z = unit_root(k, n);
                let (s, co) = (2.0 * PI * k as f64 / n as f64).sin_cos();
                assert!((z - c(co, s)).abs() < 2e-15);
                assert_eq!(unit_root(-k, n), z.conj());
                assert_eq!(unit_root(k + 7 * n as i64, n), z);
                if n.is_multiple_of(4) {
                    assert_eq!(unit_root(k + n as i64 / 4, n), z.mul_i());
                    let mirror = unit_root(n as i64 / 4 - k, n);
                    assert_eq!((mirror.re, mirror.im), (z.im, z.re));
                }
            }
        }
    }

    #[test]
    fn round_trips() {
        for (n, h) in [(1, 0), (3, 1), (16, 7), (33, 16), (64, 20)] {
            assert!(identity_error(&Sampling::period(n).harmonics(h).unwrap()) < 1e-14);
        }
        assert!(identity_error(&Sampling::period(9).signed(&[-4, -1, 0, 1, 3, 4]).unwrap()) < 1e-14);
        // Half a period with odd orders; a third with orders 1 modulo 3.
        assert!(identity_error(&Sampling::part(8, 2).real(&[1, 3, 5, 7]).unwrap()) < 1e-14);
        assert!(identity_error(&Sampling::part(5, 3).signed(&[-5, -2, 1, 4, 7]).unwrap()) < 1e-14);
        let x: Vec<C64> = (0..30).map(|j| c((j * j % 7) as f64, (j % 5) as f64 - 2.0)).collect();
        let d = Dft::new(30);
        let back = d.inverse(&d.forward(&x));
        assert!(x.iter().zip(&back).all(|(a, b)| (*a - *b).abs() < 1e-14 * 8.0));
        let real: Vec<f64> = x.iter().map(|z| z.re).collect();
        let full = d.forward(&real.iter().map(|&x| c(x, 0.0)).collect::<Vec<_>>());
        assert!(d.forward_real(&real).iter().zip(&full).all(|(a, b)| a == b));
    }

    #[test]
    fn fast_transforms_are_those_by_definition() {
        for n in [1usize, 2, 4, 8, 64, 512] {
            let fft = Fft::at_least(n);
            assert_eq!((fft.len(), Fft::at_least(n.max(3) - 1).len() >= n.max(3) - 1), (n, true));
            let x: Vec<C64> = (0..n).map(|j| c((j * j % 7) as f64 - 3.0, (j % 5) as f64 - 2.0)).collect();
            let mut fast = x.clone();
            fft.forward(&mut fast);
            let slow = Dft::new(n).forward(&x);
            assert!(fast.iter().zip(&slow).all(|(a, b)| (*a - *b).abs() < 1e-14), "{n}");
            // Parseval
            let (time, lines): (f64, f64) = (x.iter().map(|x| x.norm_sqr()).sum(), fast.iter().map(|x| x.norm_sqr()).sum());
            assert!((time / n as f64 - lines).abs() < 1e-12 * lines.max(1.0), "{n}");
        }
    }

    #[test]
    fn impossible_samplings_are_refused() {
        assert_eq!(Sampling::period(6).harmonics(3), Err(SamplingError::Aliased(3, -3)));
        assert_eq!(Sampling::period(0).harmonics(0), Err(SamplingError::Empty));
        assert_eq!(Sampling::part(8, 2).real(&[1, 2]), Err(SamplingError::Fraction(1, 2)));
        assert_eq!(Sampling::period(8).signed(&[1, 9]), Err(SamplingError::Aliased(1, 9)));
    }

    /// Worst error of harmonics 0..=h of x^p against the product of series, x with harmonics up to h.
    fn aliasing(p: usize, h: usize, n: usize) -> f64 {
        let coefficient = |k: i64| c(1.0 / (1.0 + k.abs() as f64), if k == 0 { 0.0 } else { 0.5 * k.signum() as f64 });
        let h = h as i64;
        // Exact power by convolution over signed orders.
        let mut power = std::collections::BTreeMap::from([(0i64, C64::ONE)]);
        for _ in 0..p {
            let mut next = std::collections::BTreeMap::new();
            for (k, a) in &power {
                for l in -h..=h {
                    *next.entry(k + l).or_insert(C64::ZERO) += *a * coefficient(l);
                }
            }
            power = next;
        }
        let orders: Vec<i32> = (-h as i32..=h as i32).collect();
        let t = Sampling::period(n).signed(&orders).unwrap();
        let x = t.synthesis.mul_vec(&orders.iter().map(|&k| coefficient(i64::from(k))).collect::<Vec<_>>());
        let y: Vec<C64> = x.iter().map(|&x| (0..p).fold(C64::ONE, |y, _| y * x)).collect();
        let found = t.analysis.mul_vec(&y);
        let size = power.values().map(|z| z.abs()).fold(0.0, f64::max);
        orders.iter().zip(found).map(|(&k, z)| (z - power[&i64::from(k)]).abs() / size).fold(0.0, f64::max)
    }

    #[test]
    fn sample_count_is_sharp() {
        for (p, h) in [(2, 1), (2, 5), (3, 1), (3, 4), (5, 3)] {
            let n = samples_for(p, h);
            assert!(aliasing(p, h, n) < 1e-14);
            assert!(aliasing(p, h, n - 1) > 1e-6, "{p} {h}");
        }
    }

    #[test]
    fn cubic_over_half_a_period() {
        // cos^3 = (3 cos t + cos 3t)/4; odd orders 1, 3: half the samples suffice.
        let t = Sampling::part(7, 2).real(&[1, 3]).unwrap();
        let x = t.synthesis.mul_vec(&[1.0, 0.0, 0.0, 0.0]);
        let y = t.analysis.mul_vec(&x.iter().map(|x| x * x * x).collect::<Vec<_>>());
        for (y, e) in y.iter().zip([0.75, 0.0, 0.25, 0.0]) {
            assert!((y - e).abs() < 1e-15);
        }
    }

    #[test]
    fn orders_of_a_signal() {
        let (n, periods) = (96usize, 3u32);
        let phase = |j: usize| 2.0 * PI * periods as f64 * j as f64 / n as f64;
        let real: Vec<f64> = (0..n).map(|j| 0.5 + 2.0 * (phase(j) - 0.3).cos() + 0.1 * (4.0 * phase(j)).sin()).collect();
        assert!((order_coefficient(&real, periods, 0) - c(0.5, 0.0)).abs() < 1e-14);
        assert!((order_coefficient(&real, periods, 1) - C64::cis(-0.3)).abs() < 1e-14);
        assert!((order_coefficient(&real, periods, 4) - c(0.0, -0.05)).abs() < 1e-14);
        assert!(order_coefficient(&real, periods, 2).abs() < 1e-14);
        let whirl: Vec<C64> = (0..n).map(|j| C64::cis(-2.0 * phase(j)).scale(3.0)).collect();
        assert!((order_coefficient(&whirl, periods, -2) - c(3.0, 0.0)).abs() < 1e-14);
        assert!(order_coefficient(&whirl, periods, 2).abs() < 1e-14);
        assert_eq!(order_coefficient::<f64>(&[], 1, 1), C64::ZERO);
    }

    #[test]
    fn hann_keeps_amplitudes() {
        let n = 64;
        let tone = |f: f64| (0..n).map(|j| 1.0 + 3.0 * (2.0 * PI * f * j as f64 / n as f64 + 0.4).cos()).collect::<Vec<_>>();
        let s = hann_spectrum(&tone(10.0));
        assert!((s[10] - 3.0).abs() < 1e-13 && (s[9] - 1.5).abs() < 1e-13 && (s[11] - 1.5).abs() < 1e-13);
        assert!((s[0] - 1.0).abs() < 1e-13 && s[20] < 1e-13);
        let between = hann_spectrum(&tone(10.5));
        assert!((between[10] / 3.0 - 8.0 / (3.0 * PI)).abs() < 1e-3);
        // Side lobes fall as the third power of the distance: without a window 1/(pi 15) would be seen here.
        assert!(between[25] < 1e-3);
        assert!((hann(n).iter().sum::<f64>() / n as f64 - 0.5).abs() < 1e-15);
    }
}
