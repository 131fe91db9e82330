use super::*;
use std::sync::Arc;

struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }
    fn below(&mut self, n: usize) -> usize {
        ((self.next() + 0.5) * n as f64) as usize
    }
}

/// Stations of four unknowns in a row, each coupled with the next, numbered at random; `feet` more unknowns are coupled with every station.
fn chain(stations: usize, feet: usize, random: &mut Random) -> Arc<Pattern> {
    standing(stations, feet, |_| true, random)
}

/// The same with feet below some stations.
fn standing(stations: usize, feet: usize, foot: impl Fn(usize) -> bool, random: &mut Random) -> Arc<Pattern> {
    let n = 4 * stations + feet;
    let mut number: Vec<usize> = (0..n).collect();
    for i in (1..n).rev() {
        number.swap(i, random.below(i + 1));
    }
    let mut places = Vec::new();
    for s in 0..stations {
        for a in 0..4 {
            for b in 0..4 {
                places.push((4 * s + a, 4 * s + b));
                if s > 0 {
                    places.push((4 * s + a, 4 * (s - 1) + b));
                }
            }
            places.extend((0..feet).filter(|_| foot(s)).map(|f| (4 * s + a, 4 * stations + f)));
        }
    }
    Arc::new(Pattern::new(n, places.into_iter().map(|(i, j)| (number[i], number[j]))))
}

fn full<T: Field>(pattern: &Pattern, values: &[T]) -> Mat<T> {
    let mut m = Mat::zeros(pattern.n(), pattern.n());
    for i in 0..pattern.n() {
        pattern.row(i).for_each(|(e, j)| m[(i, j)] = values[e]);
    }
    m
}

/// Largest residual over the size of matrix, solution and right side.
fn defect<T: Number>(a: &Mat<T>, x: &[T], b: &[T]) -> f64 {
    let size = |v: &[T]| v.iter().map(|x| x.size()).fold(0.0, f64::max);
    let image = a.mul_vec(x);
    let worst = image.iter().zip(b).map(|(&i, &b)| (i - b).size()).fold(0.0, |m: f64, x| if x > m || x.is_nan() { x } else { m });
    worst / (a.max_size() * size(x) + size(b))
}

fn transposed<T: Field>(a: &Mat<T>) -> Mat<T> {
    Mat::from_fn(a.cols(), a.rows(), |i, j| a[(j, i)])
}

fn checked<T: Number>(pattern: &Arc<Pattern>, mut value: impl FnMut() -> T) {
    let plan = Plan::new(pattern);
    let values: Vec<T> = (0..pattern.entries()).map(|_| value()).collect();
    let (factors, a) = (Factors::new(&plan, &values).unwrap(), full(pattern, &values));
    let b: Vec<T> = (0..pattern.n()).map(|_| value()).collect();
    let mut x = b.clone();
    factors.solve(&mut x);
    assert!(
        defect(&a, &x, &b) < 1e-13,
        "{} unknowns, border {}: {:e}",
        pattern.n(),
        plan.band.as_ref().map_or(0, |b| b.order.len() - b.inner),
        defect(&a, &x, &b)
    );
    let mut y = b.clone();
    factors.solve_transposed(&mut y);
    assert!(defect(&transposed(&a), &y, &b) < 1e-13);
    let mut both = Mat::from_fn(pattern.n(), 2, |i, j| if j == 0 { b[i] } else { x[i] });
    factors.solve_mat(&mut both);
    assert!((0..pattern.n()).all(|i| (both[(i, 0)] - x[i]).size() <= 1e-12 * x[i].size().max(1e-3)));
}

#[test]
fn random_chains_are_solved() {
    let mut r = Random(7);
    for (stations, feet) in [(2, 0), (7, 0), (40, 0), (12, 2), (40, 2), (60, 5)] {
        let pattern = chain(stations, feet, &mut r);
        // the diagonal is as small as anything: rows must be exchanged
        checked(&pattern, || r.next());
        checked(&pattern, || c(r.next(), r.next()));
        checked(&pattern, || c(Dual { re: r.next(), eps: [r.next()] }, Dual { re: r.next(), eps: [r.next()] }));
    }
    for n in [0, 1, 2, 30] {
        let places: Vec<(usize, usize)> = (0..4 * n).map(|_| (r.below(n), r.below(n))).collect();
        let pattern = Arc::new(Pattern::new(n, places));
        let plan = Plan::new(&pattern);
        let values: Vec<f64> = (0..pattern.entries()).map(|_| r.next()).collect();
        let det = full(&pattern, &values);
        let own = Factors::new(&plan, &values).unwrap().log_det();
        let should = Lu::new(&det).unwrap().det();
        assert!((own.log_size.exp() * own.phase.cos() - should).abs() <= 1e-11 * should.abs(), "{n}");
    }
}

#[test]
fn numbering_finds_the_chain_and_its_feet() {
    let mut r = Random(3);
    for stations in [30, 120] {
        let plain = Plan::new(&chain(stations, 0, &mut r));
        let band = plain.band.as_ref().unwrap();
        assert!(band.inner == 4 * stations && band.half <= 9, "{}", band.half);
        let footed = Plan::new(&chain(stations, 2, &mut r));
        let band = footed.band.as_ref().unwrap();
        assert!(band.inner == 4 * stations && band.half <= 9);
    }
}

/// A chain whose ends stand on one foundation is a ring, which the foundation opens when it stands in the border.
#[test]
fn a_ring_is_opened_at_its_foundation() {
    let mut r = Random(5);
    for (stations, feet) in [(30, 2), (30, 4), (120, 2)] {
        let plan = Plan::new(&standing(stations, feet, |s| s == 0 || s + 1 == stations, &mut r));
        let band = plan.band.as_ref().unwrap();
        assert!(band.half <= 9 && band.inner + 4 >= 4 * stations, "{} {}", band.half, band.inner);
        let chain = Plan::new(&chain(stations, 0, &mut r));
        assert!((plan.multiplications() as f64) < 2.5 * chain.multiplications() as f64);
    }
}

#[test]
fn cost_grows_with_the_length() {
    let mut r = Random(11);
    let mut plan = |stations| Plan::new(&chain(stations, 2, &mut r));
    let (short, long) = (plan(250), plan(500));
    assert!(long.multiplications() as f64 <= 2.1 * short.multiplications() as f64);
    assert!(long.stored() as f64 <= 2.1 * short.stored() as f64);
    assert!(long.pattern().entries() as f64 <= 2.1 * short.pattern().entries() as f64);
}

/// det of the n x n matrix with 2 on the diagonal and -1 beside it is n + 1; of the matrix minus t it is `sin((n + 1) a)/sin a`, 2 cos a = 2 - t.
#[test]
fn determinant_of_a_string() {
    for n in [10, 200] {
        let pattern = Arc::new(Pattern::new(n, (1..n).map(|i| (i - 1, i))));
        let plan = Plan::new(&pattern);
        let at = |t: f64| {
            let mut values = vec![-1.0; pattern.entries()];
            (0..n).for_each(|i| values[pattern.index(i, i).unwrap()] = 2.0 - t);
            Factors::new(&plan, &values).unwrap().log_det()
        };
        assert!((at(0.0).log_size - ((n + 1) as f64).ln()).abs() < 1e-12);
        for t in [0.3, 1.1, 2.7] {
            let a = (1.0 - t / 2.0f64).acos();
            let should = (a * (n + 1) as f64).sin() / a.sin();
            let d = at(t);
            assert!((d.log_size.exp() * d.phase.cos() - should).abs() < 1e-11 * (1.0 + should.abs()), "{n} {t}");
        }
    }
}

/// The derivative of `ln det (A - s)` is minus the trace of the inverse, and the phase is that of the product over eigenvalues.
#[test]
fn rate_of_the_determinant() {
    let mut r = Random(5);
    for (stations, feet) in [(4, 0), (15, 0), (15, 2)] {
        let pattern = chain(stations, feet, &mut r);
        let plan = Plan::new(&pattern);
        let a: Vec<f64> = (0..pattern.entries()).map(|_| r.next()).collect();
        let s = c(0.3, 0.8);
        let n = pattern.n();
        let values: Vec<Directed> = {
            let mut v: Vec<Directed> = a.iter().map(|&x| directed(x)).collect();
            for i in 0..n {
                let e = pattern.index(i, i).unwrap();
                v[e] -= c(Dual { re: s.re, eps: [1.0] }, Dual { re: s.im, eps: [0.0] });
            }
            v
        };
        let d = Factors::new(&plan, &values).unwrap().log_det();
        let mut shifted = full(&pattern, &a).to_complex();
        (0..n).for_each(|i| shifted[(i, i)] -= s);
        let mut inverse = Mat::identity(n);
        let lu = Lu::new(&shifted).unwrap();
        lu.solve_mat(&mut inverse);
        let trace = (0..n).fold(C64::zero(), |t, i| t + inverse[(i, i)]);
        assert!((d.rate + trace).abs() < 1e-10 * trace.abs(), "{:?} {trace:?}", d.rate);
        let det = lu.det();
        let turn = d.phase - det.arg();
        assert!(
            (d.log_size - det.abs().ln()).abs() < 1e-11
                && (turn / std::f64::consts::TAU).fract().abs().min(1.0 - (turn / std::f64::consts::TAU).fract().abs()) < 1e-11
        );
    }
}

/// A chain that is singular without its foot: two free ends that only the foot holds.
#[test]
fn a_band_that_is_singular_by_itself() {
    let stations = 60;
    let n = stations + 1;
    let places = (1..stations).map(|i| (i - 1, i)).chain((0..stations).map(|i| (i, stations)));
    let pattern = Arc::new(Pattern::new(n, places));
    let plan = Plan::new(&pattern);
    assert!(plan.band.as_ref().is_some_and(|b| b.inner == stations));
    for spread in [1.0, 1e6] {
        let mut values = vec![0.0; pattern.entries()];
        let mut add = |i: usize, j: usize, x: f64| values[pattern.index(i, j).unwrap()] += x;
        for i in 1..stations {
            let k = if i % 2 == 0 { 1.0 } else { spread };
            for (a, b, s) in [(i, i, 1.0), (i - 1, i - 1, 1.0), (i, i - 1, -1.0), (i - 1, i, -1.0)] {
                add(a, b, s * k);
            }
        }
        (0..stations).for_each(|i| {
            add(i, stations, 0.3 + 0.01 * i as f64);
            add(stations, i, 0.5 - 0.004 * i as f64);
        });
        let a = full(&pattern, &values);
        let factors = Factors::new(&plan, &values).unwrap();
        assert!(!factors.band.replaced.is_empty());
        let b: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let (mut x, mut y) = (b.clone(), b.clone());
        factors.solve(&mut x);
        factors.solve_transposed(&mut y);
        assert!(defect(&a, &x, &b) < 1e-14 && defect(&transposed(&a), &y, &b) < 1e-14);
        let (det, own) = (Lu::new(&a).unwrap().det(), factors.log_det());
        assert!((own.log_size.exp() * own.phase.cos() / det - 1.0).abs() < 1e-4, "{own:?} {det:e}");
    }
}

#[test]
fn singular_and_nan_are_errors_at_their_place() {
    let mut r = Random(9);
    for stations in [3, 30] {
        let pattern = chain(stations, 0, &mut r);
        let plan = Plan::new(&pattern);
        let mut values: Vec<f64> = (0..pattern.entries()).map(|_| r.next()).collect();
        let place = 5;
        for i in 0..pattern.n() {
            if let Some(e) = pattern.index(i, place) {
                values[e] = 0.0;
            }
        }
        assert_eq!(Factors::new(&plan, &values).map(|_| ()).unwrap_err().column, place);
        values[0] = f64::NAN;
        assert!(Factors::new(&plan, &values).is_err());
    }
}

/// Rows and columns of very different sizes: as accurate as the dense factorisation.
#[test]
fn badly_scaled_rows() {
    let mut r = Random(21);
    let pattern = chain(30, 0, &mut r);
    let plan = Plan::new(&pattern);
    let scale: Vec<f64> = (0..pattern.n()).map(|i| 10f64.powi((i % 13) as i32 - 6)).collect();
    let mut values = vec![0.0; pattern.entries()];
    for i in 0..pattern.n() {
        for (e, j) in pattern.row(i) {
            values[e] = scale[i] * scale[j] * (r.next() + if i == j { 4.0 } else { 0.0 });
        }
    }
    let a = full(&pattern, &values);
    let should: Vec<f64> = (0..pattern.n()).map(|i| (1.0 + i as f64).sqrt() / scale[i]).collect();
    let b = a.mul_vec(&should);
    let error = |x: &[f64]| x.iter().zip(&should).map(|(x, s)| (x - s).abs() / s.abs()).fold(0.0, f64::max);
    let (mut x, mut y) = (b.clone(), b);
    Factors::new(&plan, &values).unwrap().solve(&mut x);
    Lu::new(&a).unwrap().solve(&mut y);
    assert!(error(&x) <= 100.0 * error(&y).max(1e-14), "{:e} {:e}", error(&x), error(&y));
}

/// Powers of two bring any size between a quarter and four.
#[test]
fn powers_of_two_for_scaling() {
    for x in [1.0, 1.99, 2.0, 3.0, 4.0, 7.9, 8.0, 0.5, 0.24, 1e-300, 1e300, f64::MIN_POSITIVE] {
        let p = inverse_root(x);
        assert!(p.to_bits() << 12 == 0 && (0.25..4.0).contains(&(x * p * p)), "{x:e} {p:e}");
    }
    assert!([0.0, -1.0, f64::NAN, f64::INFINITY].iter().all(|x| inverse_root(*x) == 1.0));
}
