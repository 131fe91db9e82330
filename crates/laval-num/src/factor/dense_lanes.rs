//! Dense systems of one size side by side in lanes, for use inside a [`Kernel`](crate::lanes::Kernel).
//!
//! Matrices are stored row by row, a [`Pair`] for each entry. Each lane exchanges rows by its own pivots.

use super::Pair;
use crate::complex::{Complex, c};
use crate::lanes::LaneScalar;

/// An entry of the diagonal is the pivot unless another of its column is larger than it by one over this.
const THRESHOLD: f64 = 0.125;

/// The number of all lanes.
#[inline(always)]
pub fn load<S: LaneScalar>(from: &Pair) -> Complex<S> {
    c(S::load(&from[0]), S::load(&from[1]))
}

/// Writes the number of all lanes.
#[inline(always)]
pub fn store<S: LaneScalar>(x: Complex<S>, to: &mut Pair) {
    x.re.store(&mut to[0]);
    x.im.store(&mut to[1]);
}

#[inline(always)]
fn size<S: LaneScalar>(z: Complex<S>) -> S {
    z.re.abs() + z.im.abs()
}

/// Exchanges two entries in the lanes of a mask.
#[inline(always)]
fn exchange<S: LaneScalar>(mask: S::Mask, data: &mut [Pair], one: usize, other: usize) {
    let (a, b) = (load::<S>(&data[one]), load::<S>(&data[other]));
    store(c(S::select(mask, b.re, a.re), S::select(mask, b.im, a.im)), &mut data[one]);
    store(c(S::select(mask, a.re, b.re), S::select(mask, a.im, b.im)), &mut data[other]);
}

/// Lanes whose offset is `i`.
#[inline(always)]
fn is<S: LaneScalar>(offset: S, i: usize) -> S::Mask {
    (offset - S::cst(i as f64)).abs().lt(S::cst(0.5))
}

/// Factors n by n matrices in place: the diagonal becomes its inverse, `exchanged` receives how far below each row the one stood that it was exchanged
/// with. Gives the first column whose pivot is zero or not finite in one of the lanes, if there is one.
#[inline(always)]
pub fn factor<S: LaneScalar>(a: &mut [Pair], n: usize, exchanged: &mut [[f64; crate::lanes::LANES]]) -> Option<usize> {
    let mut wrong = None;
    for k in 0..n {
        let own = size(load::<S>(&a[k * n + k]));
        let (mut best, mut offset) = (own, S::zero());
        for i in k + 1..n {
            let other = size(load::<S>(&a[i * n + k]));
            let larger = best.lt(other);
            best = S::select(larger, other, best);
            offset = S::select(larger, S::cst((i - k) as f64), offset);
        }
        let stays = best.scale(THRESHOLD).le(own);
        offset = S::select(stays, S::zero(), offset);
        offset.store(&mut exchanged[k]);
        if !S::bits(stays).all() {
            for i in k + 1..n {
                let mask = is(offset, i - k);
                if S::bits(mask).any() {
                    for j in 0..n {
                        exchange::<S>(mask, a, k * n + j, i * n + j);
                    }
                }
            }
        }
        let pivot = load::<S>(&a[k * n + k]);
        if wrong.is_none() && !S::bits(S::zero().lt(size(pivot))).all() | !size(pivot).finite().all() {
            wrong = Some(k);
        }
        let inverse = pivot.recip();
        store(inverse, &mut a[k * n + k]);
        for i in k + 1..n {
            let l = load::<S>(&a[i * n + k]) * inverse;
            store(l, &mut a[i * n + k]);
            for j in k + 1..n {
                let x = load::<S>(&a[i * n + j]) - l * load::<S>(&a[k * n + j]);
                store(x, &mut a[i * n + j]);
            }
        }
    }
    wrong
}

/// Solves for `columns` right-hand sides, n by `columns`, in place, with what [`factor`] has left.
#[inline(always)]
pub fn solve<S: LaneScalar>(a: &[Pair], n: usize, exchanged: &[[f64; crate::lanes::LANES]], b: &mut [Pair], columns: usize) {
    for k in 0..n {
        let offset = S::load(&exchanged[k]);
        if S::bits(is(offset, 0)).all() {
            continue;
        }
        for i in k + 1..n {
            let mask = is(offset, i - k);
            if S::bits(mask).any() {
                for j in 0..columns {
                    exchange::<S>(mask, b, k * columns + j, i * columns + j);
                }
            }
        }
    }
    for i in 0..n {
        for j in 0..columns {
            let mut x = load::<S>(&b[i * columns + j]);
            for k in 0..i {
                x -= load::<S>(&a[i * n + k]) * load::<S>(&b[k * columns + j]);
            }
            store(x, &mut b[i * columns + j]);
        }
    }
    for i in (0..n).rev() {
        let inverse = load::<S>(&a[i * n + i]);
        for j in 0..columns {
            let mut x = load::<S>(&b[i * columns + j]);
            for k in i + 1..n {
                x -= load::<S>(&a[i * n + k]) * load::<S>(&b[k * columns + j]);
            }
            store(x * inverse, &mut b[i * columns + j]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::complex::C64;
    use crate::dense::{Lu, Mat};
    use crate::lanes::{Kernel, LANES, Level, dispatch};

    struct Solve<'a>(&'a mut [Pair], &'a mut [Pair], usize, usize);
    impl Kernel for Solve<'_> {
        type Out = Option<usize>;
        #[inline(always)]
        fn run<S: LaneScalar>(self) -> Option<usize> {
            let mut exchanged = vec![[0.0; LANES]; self.2];
            let wrong = factor::<S>(self.0, self.2, &mut exchanged);
            solve::<S>(self.0, self.2, &exchanged, self.1, self.3);
            wrong
        }
    }

    /// Each lane is the solution of its own system, at every level of the processor; some lanes exchange rows and others do not.
    #[test]
    fn lanes_are_solutions_of_their_systems() {
        for n in 1..7 {
            let columns = 3;
            let entry = |i: usize, j: usize, lane: usize| {
                let x = ((17 * i + 29 * j + 41 * lane + 13 * i * j) as f64).sin();
                // a small diagonal in every other lane
                let scale = if i == j && lane.is_multiple_of(2) { 1e-3 } else { 1.0 };
                c(x * scale, scale * ((7 * i + 3 * j + lane + 5 * i * j) as f64).cos())
            };
            let right = |i: usize, j: usize, lane: usize| c((i + 2 * j + lane) as f64, 1.0 - (i * j) as f64);
            for level in Level::supported() {
                let pairs = |rows: usize, cols: usize, f: &dyn Fn(usize, usize, usize) -> C64| -> Vec<Pair> {
                    (0..rows * cols)
                        .map(|at| {
                            let all: [C64; LANES] = std::array::from_fn(|lane| f(at / cols, at % cols, lane));
                            [all.map(|z| z.re), all.map(|z| z.im)]
                        })
                        .collect()
                };
                let (mut a, mut b) = (pairs(n, n, &entry), pairs(n, columns, &right));
                assert_eq!(dispatch(level, Solve(&mut a, &mut b, n, columns)), None);
                for lane in 0..LANES {
                    let matrix = Mat::from_fn(n, n, |i, j| entry(i, j, lane));
                    let mut x = Mat::from_fn(n, columns, |i, j| right(i, j, lane));
                    Lu::new(&matrix).unwrap().solve_mat(&mut x);
                    for (at, found) in b.iter().enumerate() {
                        let exact = x[(at / columns, at % columns)];
                        let found = c(found[0][lane], found[1][lane]);
                        assert!((found - exact).abs() < 1e-11 * x.max_size(), "{level:?} {n} {lane}: {found:?} {exact:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_singular_lane_is_found() {
        let mut a = vec![[[1.0; LANES], [0.0; LANES]]; 4];
        for (at, x) in [4.0, 1.0, 1.0, 2.0].into_iter().enumerate() {
            a[at][0] = [x; LANES];
        }
        a[3][0][5] = 0.25;
        let mut b = vec![[[1.0; LANES], [0.0; LANES]]; 2];
        assert_eq!(dispatch(Level::best(), Solve(&mut a, &mut b, 2, 1)), Some(1));
    }
}
