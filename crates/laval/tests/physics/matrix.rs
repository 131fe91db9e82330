//! Plain dense linear algebra, written for these tests: elimination, eigenvalues by the QR algorithm, the exponential of a matrix.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct C {
    pub re: f64,
    pub im: f64,
}

pub const fn c(re: f64, im: f64) -> C {
    C { re, im }
}

impl C {
    pub fn abs(self) -> f64 {
        self.re.hypot(self.im)
    }
    pub fn arg(self) -> f64 {
        self.im.atan2(self.re)
    }
    pub fn conj(self) -> C {
        c(self.re, -self.im)
    }
    pub fn cis(angle: f64) -> C {
        c(angle.cos(), angle.sin())
    }
    pub fn scale(self, x: f64) -> C {
        c(self.re * x, self.im * x)
    }
    pub fn sqrt(self) -> C {
        C::cis(0.5 * self.arg()).scale(self.abs().sqrt())
    }
}
impl Add for C {
    type Output = C;
    fn add(self, o: C) -> C {
        c(self.re + o.re, self.im + o.im)
    }
}
impl Sub for C {
    type Output = C;
    fn sub(self, o: C) -> C {
        c(self.re - o.re, self.im - o.im)
    }
}
impl Mul for C {
    type Output = C;
    fn mul(self, o: C) -> C {
        c(self.re * o.re - self.im * o.im, self.re * o.im + self.im * o.re)
    }
}
impl Div for C {
    type Output = C;
    fn div(self, o: C) -> C {
        (self * o.conj()).scale(1.0 / (o.re * o.re + o.im * o.im))
    }
}
impl Neg for C {
    type Output = C;
    fn neg(self) -> C {
        c(-self.re, -self.im)
    }
}

/// Rows of a matrix.
pub type Real = Vec<Vec<f64>>;
pub type Complex = Vec<Vec<C>>;

pub fn zeros(rows: usize, cols: usize) -> Real {
    vec![vec![0.0; cols]; rows]
}

pub fn product(a: &Real, b: &Real) -> Real {
    let mut out = zeros(a.len(), b[0].len());
    for (row, a) in out.iter_mut().zip(a) {
        for (&a, b) in a.iter().zip(b) {
            for (o, &b) in row.iter_mut().zip(b) {
                *o += a * b;
            }
        }
    }
    out
}

pub fn apply(a: &Real, x: &[f64]) -> Vec<f64> {
    a.iter().map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

/// `a = p l u` with the largest pivot of each column after its row is scaled to one.
pub struct Lu {
    rows: Complex,
    order: Vec<usize>,
    odd: bool,
}

impl Lu {
    pub fn new(mut a: Complex) -> Lu {
        let n = a.len();
        let (mut order, mut odd): (Vec<usize>, bool) = ((0..n).collect(), false);
        let size: Vec<f64> = a.iter().map(|r| r.iter().map(|x| x.abs()).fold(0.0, f64::max)).collect();
        for k in 0..n {
            let by = |i: &usize| a[*i][k].abs() / size[order[*i]];
            let pivot = (k..n).max_by(|i, j| by(i).total_cmp(&by(j))).unwrap();
            if pivot != k {
                a.swap(k, pivot);
                order.swap(k, pivot);
                odd = !odd;
            }
            let (done, rest) = a.split_at_mut(k + 1);
            let top = &done[k];
            for row in rest {
                let f = row[k] / top[k];
                row[k] = f;
                for (x, &t) in row[k + 1..].iter_mut().zip(&top[k + 1..]) {
                    *x = *x - f * t;
                }
            }
        }
        Lu { rows: a, order, odd }
    }
    pub fn solve(&self, b: &[C]) -> Vec<C> {
        let n = self.order.len();
        let mut x: Vec<C> = self.order.iter().map(|&i| b[i]).collect();
        for i in 0..n {
            for j in 0..i {
                x[i] = x[i] - self.rows[i][j] * x[j];
            }
        }
        for i in (0..n).rev() {
            for j in i + 1..n {
                x[i] = x[i] - self.rows[i][j] * x[j];
            }
            x[i] = x[i] / self.rows[i][i];
        }
        x
    }
    /// Logarithm of the modulus of the determinant, and its direction.
    pub fn determinant(&self) -> (f64, C) {
        let (mut size, mut direction) = (0.0, c(if self.odd { -1.0 } else { 1.0 }, 0.0));
        for (i, row) in self.rows.iter().enumerate() {
            size += row[i].abs().ln();
            direction = direction * row[i].scale(1.0 / row[i].abs());
        }
        (size, direction)
    }
    /// `tr(a^-1 b)`.
    pub fn trace_of_quotient(&self, b: &Complex) -> C {
        let n = b.len();
        (0..n).map(|j| self.solve(&b.iter().map(|row| row[j]).collect::<Vec<_>>())[j]).fold(c(0.0, 0.0), C::add)
    }
}

/// `a^-1 b` of real matrices.
pub fn quotient(a: &Real, b: &Real) -> Real {
    let lu = Lu::new(complex(a));
    let mut out = zeros(b.len(), b[0].len());
    for j in 0..b[0].len() {
        for (row, x) in out.iter_mut().zip(lu.solve(&b.iter().map(|row| c(row[j], 0.0)).collect::<Vec<_>>())) {
            row[j] = x.re;
        }
    }
    out
}

pub fn complex(a: &Real) -> Complex {
    a.iter().map(|row| row.iter().map(|&x| c(x, 0.0)).collect()).collect()
}

/// Scales rows and columns by powers of two until they are alike in size; eigenvalues stay.
fn balance(a: &mut Complex) {
    let n = a.len();
    for _ in 0..30 {
        let mut done = true;
        for i in 0..n {
            let row: f64 = (0..n).filter(|&j| j != i).map(|j| a[i][j].abs()).sum();
            let column: f64 = (0..n).filter(|&j| j != i).map(|j| a[j][i].abs()).sum();
            if row == 0.0 || column == 0.0 {
                continue;
            }
            let f = (0.5 * (row / column).log2()).round().exp2();
            if (row / f + column * f) < 0.95 * (row + column) {
                done = false;
                for j in 0..n {
                    a[i][j] = a[i][j].scale(1.0 / f);
                    a[j][i] = a[j][i].scale(f);
                }
            }
        }
        if done {
            return;
        }
    }
}

/// All eigenvalues: Hessenberg form by reflections, then the shifted QR algorithm with rotations.
pub fn eigenvalues(a: &Real) -> Vec<C> {
    let mut h = complex(a);
    balance(&mut h);
    let n = h.len();
    for k in 0..n.saturating_sub(2) {
        let mut v: Vec<C> = (0..n).map(|i| if i > k { h[i][k] } else { c(0.0, 0.0) }).collect();
        let norm = v.iter().map(|x| x.abs().powi(2)).sum::<f64>().sqrt();
        if norm == 0.0 {
            continue;
        }
        let direction = if v[k + 1].abs() == 0.0 { c(1.0, 0.0) } else { v[k + 1].scale(1.0 / v[k + 1].abs()) };
        v[k + 1] = v[k + 1] + direction.scale(norm);
        let size = v.iter().map(|x| x.abs().powi(2)).sum::<f64>();
        for j in 0..n {
            let s = (k + 1..n).map(|i| v[i].conj() * h[i][j]).fold(c(0.0, 0.0), C::add).scale(2.0 / size);
            (k + 1..n).for_each(|i| h[i][j] = h[i][j] - v[i] * s);
        }
        for row in &mut h {
            let s = (k + 1..n).map(|j| row[j] * v[j]).fold(c(0.0, 0.0), C::add).scale(2.0 / size);
            (k + 1..n).for_each(|j| row[j] = row[j] - s * v[j].conj());
        }
    }
    let mut out = Vec::new();
    let (mut high, mut turns) = (n, 0);
    while high > 0 {
        let m = high - 1;
        // the last row from which on nothing couples upwards
        let low = (1..high).rev().find(|&i| h[i][i - 1].abs() <= f64::EPSILON * (h[i][i].abs() + h[i - 1][i - 1].abs())).unwrap_or(0);
        if low == m {
            out.push(h[m][m]);
            (high, turns) = (m, 0);
            continue;
        }
        turns += 1;
        assert!(turns < 300, "the QR algorithm does not converge");
        let (p, q, r, s) = (h[m - 1][m - 1], h[m - 1][m], h[m][m - 1], h[m][m]);
        let half = (p - s).scale(0.5);
        let root = (half * half + q * r).sqrt();
        let middle = (p + s).scale(0.5);
        let (one, other) = (middle + root, middle - root);
        let mut shift = if (one - s).abs() < (other - s).abs() { one } else { other };
        if turns % 11 == 10 {
            shift = shift + c(h[m][m - 1].abs(), 0.0);
        }
        (low..high).for_each(|i| h[i][i] = h[i][i] - shift);
        let mut rotations = Vec::new();
        for k in low..m {
            let (a, b) = (h[k][k], h[k + 1][k]);
            let norm = a.abs().hypot(b.abs());
            let (cosine, sine) = if norm == 0.0 { (c(1.0, 0.0), c(0.0, 0.0)) } else { (a.scale(1.0 / norm), b.scale(1.0 / norm)) };
            for j in k..high {
                let (x, y) = (h[k][j], h[k + 1][j]);
                h[k][j] = cosine.conj() * x + sine.conj() * y;
                h[k + 1][j] = cosine * y - sine * x;
            }
            rotations.push((cosine, sine));
        }
        for (k, &(cosine, sine)) in rotations.iter().enumerate() {
            let k = low + k;
            for row in h.iter_mut().take((k + 2).min(high)).skip(low) {
                let (x, y) = (row[k], row[k + 1]);
                row[k] = x * cosine + y * sine;
                row[k + 1] = y * cosine.conj() - x * sine.conj();
            }
        }
        (low..high).for_each(|i| h[i][i] = h[i][i] + shift);
    }
    out
}

/// `exp(a)` by scaling and squaring of the Taylor series.
pub fn exponential(a: &Real) -> Real {
    let n = a.len();
    let norm = a.iter().map(|r| r.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    let squarings = (norm / 0.25).log2().ceil().max(0.0) as i32;
    let scaled: Real = a.iter().map(|r| r.iter().map(|x| x * (-f64::from(squarings)).exp2()).collect()).collect();
    let mut sum = zeros(n, n);
    (0..n).for_each(|i| sum[i][i] = 1.0);
    let mut term = sum.clone();
    for k in 1..=14 {
        term = product(&term, &scaled);
        for (s, t) in sum.iter_mut().flatten().zip(term.iter_mut().flatten()) {
            *t /= f64::from(k);
            *s += *t;
        }
    }
    (0..squarings).for_each(|_| sum = product(&sum, &sum));
    sum
}

/// The algebra itself: determinant against eigenvalues, the exponential of a rotation, a matrix that cannot be made diagonal.
#[test]
fn algebra() {
    let a: Real = vec![vec![1.0, 2.0, 0.5, -1.0], vec![-3.0, 0.2, 1e3, 0.0], vec![0.1, -0.7, 2.0, 5.0], vec![1.0, 1.0, -4.0, 0.3]];
    let roots = eigenvalues(&a);
    let (size, direction) = Lu::new(complex(&a)).determinant();
    let all = roots.iter().fold(c(1.0, 0.0), |p, &x| p * x);
    assert!((all - direction.scale(size.exp())).abs() < 1e-9 * all.abs());
    assert!((roots.iter().map(|x| x.re).sum::<f64>() - 3.5).abs() < 1e-11);
    let turned = exponential(&vec![vec![0.0, -7.0], vec![7.0, 0.0]]);
    assert!((turned[0][0] - 7.0f64.cos()).abs() < 1e-13 && (turned[1][0] - 7.0f64.sin()).abs() < 1e-13);
    let shear = exponential(&vec![vec![0.0, 3.0], vec![0.0, 0.0]]);
    assert!(shear == vec![vec![1.0, 3.0], vec![0.0, 1.0]]);
    let jordan = eigenvalues(&vec![vec![2.0, 1.0], vec![0.0, 2.0]]);
    assert!(jordan.iter().all(|x| (*x - c(2.0, 0.0)).abs() < 1e-14));
}
