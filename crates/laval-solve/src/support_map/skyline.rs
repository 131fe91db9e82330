//! Hermitian matrices by the envelopes of their rows: factors `L D L^H` without pivoting, whose signs count eigenvalues.

use laval_num::complex::C64;
use laval_num::dense::Field;

/// First column of every row, and where its entries begin.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    first: Vec<usize>,
    start: Vec<usize>,
}

impl Envelope {
    /// That holds these places of a matrix of `n` rows.
    pub fn new(n: usize, places: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut first: Vec<usize> = (0..n).collect();
        for (i, j) in places {
            let (low, high) = (i.min(j), i.max(j));
            first[high] = first[high].min(low);
        }
        let mut start = Vec::with_capacity(n + 1);
        let mut total = 0;
        for (i, f) in first.iter().enumerate() {
            start.push(total);
            total += i + 1 - f;
        }
        start.push(total);
        Envelope { first, start }
    }
    /// Number of rows.
    pub fn n(&self) -> usize {
        self.first.len()
    }
    /// Number of entries.
    pub fn entries(&self) -> usize {
        self.start[self.n()]
    }
    /// Index of an entry of the lower triangle.
    pub fn index(&self, i: usize, j: usize) -> usize {
        self.start[i] + j - self.first[i]
    }
    /// `x^H A y`.
    pub fn form(&self, a: &[C64], x: &[C64], y: &[C64]) -> C64 {
        self.times(a, y).iter().zip(x).fold(C64::ZERO, |sum, (ay, x)| sum + x.conj() * *ay)
    }
    /// Size of `x^H A x` before its terms cancel.
    pub fn size(&self, a: &[C64], x: &[C64]) -> f64 {
        let row = |i: usize| {
            let row = self.first[i]..;
            let terms = row.zip(&a[self.start[i]..self.start[i + 1]]);
            terms.map(|(j, v)| if j < i { 2.0 } else { 1.0 } * (v.abs() * x[i].abs() * x[j].abs())).sum::<f64>()
        };
        (0..self.n()).map(row).sum()
    }
    /// `A x`.
    pub fn times(&self, a: &[C64], x: &[C64]) -> Vec<C64> {
        let mut out = vec![C64::ZERO; self.n()];
        for i in 0..self.n() {
            let row = &a[self.start[i]..self.start[i + 1]];
            for (j, &v) in (self.first[i]..).zip(row) {
                out[i] += v * x[j];
                if j < i {
                    out[j] += v.conj() * x[i];
                }
            }
        }
        out
    }
}

/// `L D L^H` of a matrix on an envelope.
#[derive(Default)]
pub struct Factors {
    lower: Vec<C64>,
    diagonal: Vec<f64>,
}

impl Factors {
    /// Factors a matrix, and counts its negative eigenvalues. A pivot below the rounding of the matrix is taken for that: a smaller one would overflow in what
    /// is divided by it.
    pub fn factor(&mut self, at: &Envelope, a: &[C64]) -> usize {
        self.lower.clear();
        self.lower.extend_from_slice(a);
        self.diagonal.clear();
        self.diagonal.resize(at.n(), 0.0);
        let least = f64::EPSILON * a.iter().map(|z| z.re.abs().max(z.im.abs())).fold(0.0, f64::max).max(f64::MIN_POSITIVE / f64::EPSILON);
        let mut negative = 0;
        for i in 0..at.n() {
            let (begin, end, first) = (at.start[i], at.start[i + 1], at.first[i]);
            let (done, row) = self.lower.split_at_mut(begin);
            let row = &mut row[..end - begin];
            for j in first..i {
                let (from, own) = (at.first[j], &done[at.start[j]..at.start[j + 1]]);
                let low = first.max(from);
                let sum = row[low - first..j - first].iter().zip(&own[low - from..]).fold(C64::ZERO, |s, (g, l)| s + *g * l.conj());
                row[j - first] -= sum;
            }
            let mut pivot = row[i - first].re;
            for j in first..i {
                let g = row[j - first];
                let l = g.scale(1.0 / self.diagonal[j]);
                pivot -= (g * l.conj()).re;
                row[j - first] = l;
            }
            if !(pivot.abs() >= least) {
                pivot = least;
            }
            self.diagonal[i] = pivot;
            negative += usize::from(pivot < 0.0);
        }
        negative
    }
    /// Solves in place.
    pub fn solve(&self, at: &Envelope, x: &mut [C64]) {
        for i in 0..at.n() {
            let row = &self.lower[at.start[i]..at.start[i + 1]];
            let sum = (at.first[i]..i).zip(row).fold(C64::ZERO, |s, (j, l)| s + *l * x[j]);
            x[i] -= sum;
        }
        x.iter_mut().zip(&self.diagonal).for_each(|(x, d)| *x = x.scale(1.0 / d));
        for i in (0..at.n()).rev() {
            let (row, xi) = (&self.lower[at.start[i]..at.start[i + 1]], x[i]);
            for (j, l) in (at.first[i]..i).zip(row) {
                x[j] -= l.conj() * xi;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use laval_num::complex::c;

    /// A chain with complex couplings against products, and the count of its eigenvalues below shifts.
    #[test]
    fn factors_solve_and_count() {
        let n = 7;
        let at = Envelope::new(n, (1..n).map(|i| (i, i - 1)).chain([(6, 0), (3, 1)]));
        let mut a = vec![C64::ZERO; at.entries()];
        for i in 0..n {
            a[at.index(i, i)] = c(2.0 + 0.1 * i as f64, 0.0);
            if i > 0 {
                a[at.index(i, i - 1)] = c(-1.0, 0.3);
            }
        }
        a[at.index(6, 0)] = c(0.2, -0.1);
        a[at.index(3, 1)] = c(0.0, 0.4);
        let x: Vec<C64> = (0..n).map(|i| c(1.0 + i as f64, -0.5 * i as f64)).collect();
        let mut b = at.times(&a, &x);
        let mut f = Factors::default();
        let below = f.factor(&at, &a);
        f.solve(&at, &mut b);
        assert!(b.iter().zip(&x).all(|(b, x)| (*b - *x).abs() < 1e-12));
        // the count rises with the shift from none to all
        let mut last = 0;
        for k in 0..=40 {
            let shift = -2.0 + 0.2 * f64::from(k);
            let mut moved = a.clone();
            (0..n).for_each(|i| moved[at.index(i, i)].re -= shift);
            let count = f.factor(&at, &moved);
            assert!(count >= last, "{shift}: {count} {last}");
            last = count;
        }
        assert_eq!((last, below), (n, 0));
    }
}
