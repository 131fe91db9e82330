use super::number::{apply, apply_adjoint, frobenius, inner, norm2};
use super::*;
use crate::complex::{C64, c};
use crate::dense::{Field, Mat};

pub(super) struct Rng(u64);
impl Rng {
    pub(super) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }
    pub(super) fn mat(&mut self, n: usize) -> Mat {
        Mat::from_fn(n, n, |_, _| self.next())
    }
    pub(super) fn cmat(&mut self, n: usize) -> Mat<C64> {
        Mat::from_fn(n, n, |_, _| c(self.next(), self.next()))
    }
}

fn diag(d: &[f64]) -> Mat {
    Mat::from_fn(d.len(), d.len(), |i, j| if i == j { d[i] } else { 0.0 })
}

/// Largest distance of the values to their partners in an optimal assignment.
fn distance(a: &[C64], b: &[C64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let cost = Mat::from_fn(a.len(), b.len(), |i, j| (a[i] - b[j]).abs());
    assign(&cost).iter().enumerate().map(|(i, j)| cost[(i, j.unwrap())]).fold(0.0, f64::max)
}

fn values(m: &[Mode]) -> Vec<C64> {
    m.iter().map(|m| m.value).collect()
}

#[test]
fn compact_iteration_agrees_with_faer() {
    let mut r = Rng(1);
    let mut s = Spectrum::default();
    for n in 1..=24 {
        for _ in 0..40 {
            let a = r.mat(n);
            let theirs = f64::values(&a).unwrap();
            // Random matrices have sensitivities up to some hundreds.
            assert!(distance(s.of(&a).unwrap(), &theirs) < 1e-11, "n = {n}");
        }
    }
}

#[test]
fn spectrum_is_backward_stable_on_nasty_matrices() {
    // The smallest singular value of A - s I over the norm of A: the true backward error of an eigenvalue.
    let backward = |a: &Mat, s: C64| {
        let n = a.rows();
        let z = Mat::from_fn(n, n, |i, j| c(a[(i, j)], 0.0) - if i == j { s } else { C64::ZERO });
        C64::svd(&z).unwrap().s[n - 1] / frobenius(a)
    };
    let mut r = Rng(7);
    let mut cases = vec![];
    for n in [3, 8, 12] {
        // Jordan block; the same in random coordinates; nilpotent; zero; clustered; circulant shift (stalls without exceptional shifts).
        let jordan = Mat::from_fn(n, n, |i, j| if i == j { 2.0 } else { f64::from(j == i + 1) });
        let t = r.mat(n);
        let lu = crate::dense::Lu::new(&t).unwrap();
        let mut inner = jordan.matmul(&t);
        lu.solve_mat(&mut inner);
        cases.extend([jordan.clone(), jordan.transpose(), inner, Mat::zeros(n, n)]);
        cases.push(Mat::from_fn(n, n, |i, j| f64::from(j == i + 1)));
        cases.push(Mat::from_fn(n, n, |i, j| if i == j { 1.0 } else { 1e-9 * r.next() }));
        cases.push(Mat::from_fn(n, n, |i, j| f64::from(j == (i + 1) % n)));
        cases.push(Mat::from_fn(n, n, |i, j| f64::from(i == (j + 1) % n)));
        cases.push(Mat::from_fn(n, n, |_, _| 1.0));
        cases.push(Mat::from_fn(n, n, |i, j| if i == j { 0.0 } else { (j as f64 - i as f64).signum() * (1 + i + j) as f64 }));
    }
    for a in cases {
        for s in eigenvalues(&a).unwrap() {
            assert!(a.max_size() == 0.0 || backward(&a, s) < 1e-14, "{s:?} of {a:?}");
        }
    }
}

#[test]
fn known_spectra() {
    // Circulant shift: roots of unity.
    let a = Mat::from_fn(8, 8, |i, j| f64::from(j == (i + 1) % 8));
    let exact: Vec<C64> = (0..8).map(|k| C64::cis(std::f64::consts::FRAC_PI_4 * k as f64)).collect();
    assert!(distance(&eigenvalues(&a).unwrap(), &exact) < 1e-14);
    // Second difference: 2 - 2 cos(k pi/(n+1)).
    for n in [10, 60] {
        let a = Mat::from_fn(n, n, |i, j| if i == j { 2.0 } else { -f64::from(i.abs_diff(j) == 1) });
        let exact: Vec<C64> =
            (1..=n).map(|k| c(4.0 * (0.5 * std::f64::consts::PI * k as f64 / (n + 1) as f64).sin().powi(2), 0.0)).collect();
        assert!(distance(&eigenvalues(&a).unwrap(), &exact) < 1e-14 * n as f64);
        assert!(distance(&values(&modes(&a).unwrap()), &exact) < 1e-14 * n as f64);
    }
    // Frank matrix: eigenvalues in reciprocal pairs, the small ones ill-conditioned; each error stays within its estimate.
    let n = 12;
    let frank = Mat::from_fn(n, n, |i, j| if j + 1 < i { 0.0 } else { (n - i.max(j)) as f64 });
    let m = modes(&frank).unwrap();
    assert!(m[0].sensitivity > 1e6);
    for (p, q) in m.iter().zip(m.iter().rev()) {
        let bound = p.error() * q.value.abs() + q.error() * p.value.abs();
        assert!((p.value * q.value - C64::ONE).abs() < 2.0 * bound, "{:?} {:?}", p.value, q.value);
    }
    // Wilkinson W21+: the two largest agree to 14 digits.
    let w = Mat::from_fn(21, 21, |i, j| if i == j { (i as f64 - 10.0).abs() } else { f64::from(i.abs_diff(j) == 1) });
    let v = eigenvalues(&w).unwrap();
    assert!((v[20].re - 10.746194182903393).abs() < 1e-13 && (v[19].re - 10.746194182903322).abs() < 1e-13);
    // Wilkinson's bidiagonal matrix of order 20 with weak coupling has its diagonal as spectrum.
    let a = Mat::from_fn(20, 20, |i, j| if i == j { i as f64 + 1.0 } else { 20.0 * f64::from(j == i + 1) });
    let exact: Vec<C64> = (1..=20).map(|k| c(k as f64, 0.0)).collect();
    assert!(distance(&eigenvalues(&a).unwrap(), &exact) < 1e-12);
}

#[test]
fn graded_matrices_keep_small_eigenvalues() {
    // D^-1 T D with D over 80 decades has the spectrum of T.
    let t = Rng(3).mat(9);
    let exact = eigenvalues(&t).unwrap();
    let d = |i: usize| 10f64.powi(10 * (i as i32 - 4));
    let a = Mat::from_fn(9, 9, |i, j| t[(i, j)] * d(j) / d(i));
    assert!(distance(&eigenvalues(&a).unwrap(), &exact) < 1e-12);
    let m = modes(&a).unwrap();
    assert!(distance(&values(&m), &exact) < 1e-12 && m.iter().all(|m| m.residual < 1e-14));
    let z = a.to_complex();
    assert!(distance(&eigenvalues(&z).unwrap(), &exact) < 1e-12);
}

fn check_vectors<T: Number>(a: &Mat<T>, tol: f64) {
    let m = modes(a).unwrap();
    assert_eq!(m.len(), a.rows());
    let size = frobenius(a);
    for p in &m {
        let (ax, ay) = (apply(a, &p.right), apply_adjoint(a, &p.left));
        let r: Vec<C64> = ax.iter().zip(&p.right).map(|(&a, &x)| a - p.value * x).collect();
        let l: Vec<C64> = ay.iter().zip(&p.left).map(|(&a, &y)| a - p.value.conj() * y).collect();
        assert!(norm2(&r) <= tol * size && norm2(&l) <= tol * size, "{} {}", norm2(&r), norm2(&l));
        assert!((norm2(&p.right) - 1.0).abs() < 1e-14 && (norm2(&p.left) - 1.0).abs() < 1e-14);
        let yx = inner(&p.left, &p.right);
        assert!(yx.im.abs() < 1e-15 && yx.re >= 0.0);
        assert!(p.residual < tol);
        for q in &m {
            if (q.value - p.value).abs() > 1e-3 * size {
                assert!(inner(&p.left, &q.right).abs() < 1e-11);
            }
        }
    }
    for w in m.windows(2) {
        assert!(w[0].value.im.abs() <= w[1].value.im.abs());
    }
    if T::REAL {
        let mut i = 0;
        while i < m.len() {
            if m[i].value.im != 0.0 {
                assert!(m[i].value.im > 0.0);
                assert_eq!(m[i].conj(), m[i + 1]);
                i += 1;
            }
            i += 1;
        }
    }
}

#[test]
fn vectors_of_real_and_complex_matrices() {
    let mut r = Rng(11);
    for n in [1, 2, 3, 7, 16, 40, 90] {
        check_vectors(&r.mat(n), 1e-13);
        check_vectors(&r.cmat(n), 1e-13);
    }
    // Repeated semisimple eigenvalues.
    check_vectors(&diag(&[1.0, 1.0, 3.0]), 1e-14);
    assert_eq!(modes(&Mat::<f64>::zeros(0, 0)).unwrap(), vec![]);
    assert_eq!(modes(&Mat::<f64>::zeros(2, 2)).unwrap()[0].residual, 0.0);
}

#[test]
fn not_finite_is_an_error() {
    let a = Mat::from_fn(3, 3, |i, j| if i == j { f64::NAN } else { 1.0 });
    assert_eq!(eigenvalues(&a), Err(EigError::NotFinite));
    assert_eq!(modes(&a), Err(EigError::NotFinite));
    assert_eq!(eigenvalues(&a.to_complex()), Err(EigError::NotFinite));
    assert_eq!(Pencil::new(Mat::identity(3), a).modes(), Err(EigError::NotFinite));
}

#[test]
fn defective_block_errs_by_the_root_of_rounding_and_says_so() {
    let t = Rng(5).mat(2);
    let jordan = Mat::from_fn(2, 2, |i, j| if i == j { 3.0 } else { f64::from(j > i) });
    let mut a = t.matmul(&jordan).transpose();
    crate::dense::Lu::new(&t.transpose()).unwrap().solve_mat(&mut a);
    let m = modes(&a.transpose()).unwrap();
    for p in &m {
        let error = (p.value - c(3.0, 0.0)).abs();
        assert!(error < 1e-6, "{error}");
        assert!(p.residual < 1e-14);
        assert!(p.sensitivity > 1e6, "{}", p.sensitivity);
        assert!(error <= p.error());
    }
}

#[test]
fn pencil_with_infinite_eigenvalues_of_every_index() {
    // Weierstrass form: finite 1, -2, +-3i; nilpotent blocks of sizes 1, 2, 3 at infinity; random equivalence and bad units.
    let mut a = Mat::identity(10);
    let mut e = Mat::zeros(10, 10);
    a[(0, 0)] = 1.0;
    a[(1, 1)] = -2.0;
    a[(2, 2)] = 0.0;
    a[(3, 3)] = 0.0;
    a[(2, 3)] = 3.0;
    a[(3, 2)] = -3.0;
    for i in 0..4 {
        e[(i, i)] = 1.0;
    }
    e[(5, 6)] = 1.0;
    e[(7, 8)] = 1.0;
    e[(8, 9)] = 1.0;
    let mut r = Rng(2);
    let (p, q) = (r.mat(10), r.mat(10));
    let exact = [c(1.0, 0.0), c(-2.0, 0.0), c(0.0, 3.0), c(0.0, -3.0)];
    let (a, e) = (p.matmul(&a).matmul(&q), p.matmul(&e).matmul(&q));
    let unit = |i: usize| if i.is_multiple_of(2) { 1e5 } else { 1e-4 };
    let (a, e) =
        (Mat::from_fn(10, 10, |i, j| 1e9 * a[(i, j)] * unit(i) * unit(j)), Mat::from_fn(10, 10, |i, j| e[(i, j)] * unit(i) * unit(j)));
    let scaled: Vec<C64> = exact.iter().map(|z| z.scale(1e9)).collect();
    fn check<T: Number>(p: &Pencil<T>, exact: &[C64]) {
        let m = p.modes().unwrap();
        assert_eq!(m.infinite, 6);
        assert!(distance(&values(&m.finite), exact) < 1e-8 * exact[0].abs());
        for p in &m.finite {
            assert!(p.residual < 1e-13, "{}", p.residual);
        }
    }
    check(&Pencil::new(a.clone(), e.clone()), &scaled);
    check(&Pencil::new(a.to_complex(), e.to_complex()), &scaled);
    // A common null vector makes the pencil singular.
    assert_eq!(Pencil::new(diag(&[1.0, 0.0]), diag(&[2.0, 0.0])).modes(), Err(EigError::SingularPencil));
}

#[test]
fn pencil_vectors_are_biorthogonal() {
    let mut r = Rng(21);
    let (a, e) = (r.mat(7), r.mat(7));
    let p = Pencil::new(a.clone(), e.clone());
    let m = p.modes().unwrap();
    assert_eq!((m.finite.len(), m.infinite), (7, 0));
    for (i, x) in m.finite.iter().enumerate() {
        assert!(x.residual < 1e-14);
        let left = p.biorthogonal(x).left;
        for (j, y) in m.finite.iter().enumerate() {
            assert!((inner(&left, &y.right).abs() < 1e-11) == (i != j));
        }
        // Derivative against a central difference.
        let (da, de) = (r.mat(7), r.mat(7));
        let h = 1e-6;
        let at = |h: f64| {
            let shift = |a: &Mat, d: &Mat| Mat::from_fn(7, 7, |i, j| a[(i, j)] + h * d[(i, j)]);
            let v = values(&Pencil::new(shift(&a, &da), shift(&e, &de)).modes().unwrap().finite);
            *v.iter().min_by(|p, q| (**p - x.value).abs().total_cmp(&(**q - x.value).abs())).unwrap()
        };
        let numeric = (at(h) - at(-h)).scale(0.5 / h);
        let exact = p.derivative(x, &da, &de);
        assert!((numeric - exact).abs() < 1e-6 * (1.0 + exact.abs() * x.sensitivity), "{numeric:?} {exact:?}");
    }
}

/// `(s^2 M + s C + K) x = 0` as a pencil of the first order in `x` and `s x/w`, `w` the size of the fastest values.
fn companion(m: Mat, d: Mat, k: Mat) -> Pencil<f64> {
    let n = m.rows();
    let largest = |a: &Mat| (0..n * n).map(|i| a[(i / n, i % n)].abs()).fold(0.0, f64::max);
    let w = (largest(&k) / largest(&m)).sqrt().max(largest(&d) / largest(&m));
    let one = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
    let a = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
        (true, true) => 0.0,
        (true, false) => w * one(i, j - n),
        (false, true) => -k[(i - n, j)] / w,
        (false, false) => -d[(i - n, j - n)],
    });
    let e = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
        (true, true) => one(i, j),
        (false, false) => m[(i - n, j - n)],
        _ => 0.0,
    });
    Pencil::new(a, e)
}

/// Isotropic gyroscopic pair: s^2 - i w s + k = 0 and its conjugate, s = i (w +- sqrt(w^2 + 4 k))/2.
#[test]
fn gyroscopic_pencil_has_its_closed_form() {
    for (w, k) in [(0.0, 1.0), (3.0, 2.0), (1e4, 1.0), (1e3, 1e7)] {
        // Rows in different units: the second coordinate scaled by 1e-6, equations by 1e6.
        let (m, g, st) = (diag(&[1.0, 1.0]), Mat::from_fn(2, 2, |i, j| (j as f64 - i as f64) * w), diag(&[k, k]));
        let unit = |a: Mat| Mat::from_fn(2, 2, |i, j| a[(i, j)] * if i == 1 { 1e6 } else { 1.0 } * if j == 1 { 1e-3 } else { 1.0 });
        let found = companion(unit(m), unit(g), unit(st)).modes().unwrap();
        assert_eq!(found.infinite, 0);
        let root = (w * w + 4.0 * k).sqrt();
        let (fast, slow) = (0.5 * (w + root), 2.0 * k / (w + root));
        let exact = [c(0.0, slow), c(0.0, -slow), c(0.0, fast), c(0.0, -fast)];
        let error = distance(&values(&found.finite), &exact) / fast;
        assert!(error < 1e-13, "{w} {k}: {error}");
    }
}

#[test]
fn values_of_second_order_multiply_to_the_ratio_of_determinants() {
    let mut r = Rng(9);
    for n in [1, 2, 6, 20] {
        let (m, d, k) = (r.mat(n), r.mat(n), r.mat(n));
        let all = companion(m.clone(), d, k.clone()).modes().unwrap();
        assert_eq!(all.finite.len(), 2 * n);
        assert!(all.finite.iter().all(|p| p.residual < 2e-13));
        let product = all.finite.iter().fold(C64::ONE, |z, p| z * p.value);
        let det = |a: &Mat| crate::dense::Lu::new(a).unwrap().det();
        let exact = det(&k) / det(&m);
        assert!((product - c(exact, 0.0)).abs() < 1e-10 * exact.abs());
    }
}

#[test]
fn singular_mass_gives_infinite_eigenvalues() {
    // Massless second coordinate in series: m s^2 x + k1 (x - z) = 0, d s z + k2 z + k1 (z - x) = 0, with a dashpot d or without.
    let (mass, k1, k2) = (2.0, 8e7, 3e7);
    for d in [0.0, 4e4] {
        let m = diag(&[mass, 0.0]);
        let k = Mat::from_fn(2, 2, |i, j| [[k1, -k1], [-k1, k1 + k2]][i][j]);
        let found = companion(m, diag(&[0.0, d]), k).modes().unwrap();
        if d == 0.0 {
            assert_eq!((found.finite.len(), found.infinite), (2, 2));
            let w = (k1 * k2 / (k1 + k2) / mass).sqrt();
            assert!(distance(&values(&found.finite), &[c(0.0, w), c(0.0, -w)]) < 1e-13 * w);
        } else {
            assert_eq!((found.finite.len(), found.infinite), (3, 1));
            for p in &found.finite {
                let s = p.value;
                let dynamic = (s * s).scale(mass) + c(k1, 0.0);
                let zero = dynamic * (s.scale(d) + c(k1 + k2, 0.0)) - c(k1 * k1, 0.0);
                assert!(zero.abs() < 1e-13 * k1 * k1);
            }
        }
        assert!(found.finite.iter().all(|p| p.residual < 1e-14));
    }
}

#[test]
fn free_body_keeps_its_double_zero() {
    // Two masses and a spring: s = 0 twice (defective), +-i sqrt(2).
    let k = Mat::from_fn(2, 2, |i, j| if i == j { 1.0 } else { -1.0 });
    let found = companion(Mat::identity(2), Mat::zeros(2, 2), k).modes().unwrap();
    let w = 2f64.sqrt();
    let v = values(&found.finite);
    assert!(distance(&v, &[C64::ZERO, C64::ZERO, c(0.0, w), c(0.0, -w)]) < 1e-7);
    let double = found.finite.iter().find(|m| m.value.abs() < 1.0).unwrap();
    assert!(double.sensitivity > 1e6);
}

/// Two oscillators, stiffness 1 + l and 2 - l, coupled by e: values of the symmetric 2 x 2 matrix cross (e = 0) or veer at l = 1/2.
fn coupled(l: f64, e: f64) -> Vec<Mode> {
    modes(&Mat::from_fn(2, 2, |i, j| [[1.0 + l, e], [e, 2.0 - l]][i][j])).unwrap()
}

#[test]
fn tracks_through_a_crossing() {
    let mut t = Track::new(&coupled(0.0, 0.0));
    let mut index = [0usize, 1];
    for step in 1..=10 {
        let l = 0.1 * step as f64;
        let m = coupled(l, 0.0);
        let found = t.next(&m);
        // At l = 1/2 the values are equal and any vectors will do: the subspace is compared.
        assert!(!found.ambiguous && found.worst_mac > 1.0 - 1e-12, "{l} {found:?}");
        index = [found.permutation[0].unwrap(), found.permutation[1].unwrap()];
        // Before the crossing mode 0 is the one with value 1 + l.
        assert!(step >= 5 || (m[index[0]].value.re - (1.0 + l)).abs() < 1e-14);
    }
    assert_ne!(index[0], index[1]);
    // Stepping over the crossing is seen as one and reported.
    let mut t = Track::new(&coupled(0.4, 0.0));
    let found = t.next(&coupled(0.65, 0.0));
    assert_eq!(found.permutation, vec![Some(1), Some(0)]);
    assert_eq!(found.crossings, vec![(0, 1)]);
}

#[test]
fn veering_asks_for_intermediate_points() {
    let e = 0.05;
    let mut t = Track::new(&coupled(0.0, e));
    let wanted = t.next(&coupled(0.5, e));
    assert!(wanted.ambiguous && (wanted.worst_mac - 0.5).abs() < 0.1);
    // Bisect as requested: branches never cross, so in order of value the identity must result, at every point.
    let (mut l, mut h) = (0.0, 0.5);
    let mut points = 0;
    while l < 1.0 {
        let found = t.next(&coupled(l + h, e));
        if found.ambiguous {
            h *= 0.5;
            assert!(h > 1e-3);
            continue;
        }
        assert_eq!(found.permutation, vec![Some(0), Some(1)]);
        assert!(found.worst_mac >= 0.8);
        l += h;
        h = (2.0 * h).min(0.1).min(1.0 - l).max(1e-6);
        points += 1;
    }
    assert!(points > 5);
}

#[test]
fn tracks_gyroscopic_modes_from_rest() {
    // Isotropic gyroscopic rotor from rest: the double value at speed 0 splits into forward and backward.
    let at = |w: f64| {
        let g = Mat::from_fn(2, 2, |i, j| (j as f64 - i as f64) * w);
        let q = companion(Mat::identity(2), g, Mat::identity(2));
        upper_half(&q.modes().unwrap().finite).iter().map(|m| q.biorthogonal(m)).collect::<Vec<_>>()
    };
    let mut t = Track::new(&at(0.0));
    for step in 1..=20 {
        let found = t.next(&at(0.05 * step as f64));
        assert!(!found.ambiguous && found.worst_mac > 0.99, "{step} {found:?}");
    }
}

#[test]
fn modes_are_born_and_lost() {
    let mut t = Track::new(&modes(&diag(&[1.0, 2.0, 3.0])).unwrap());
    let found = t.next(&modes(&diag(&[1.0, 2.0, 3.0])).unwrap()[..2]);
    assert_eq!(found.permutation, vec![Some(0), Some(1), None]);
    let found = t.next(&modes(&diag(&[1.0, 2.0, 3.0])).unwrap());
    assert_eq!((found.permutation, found.born), (vec![Some(0), Some(1)], vec![2]));
}

#[test]
fn assignment_is_optimal() {
    let mut r = Rng(4);
    for n in 1..=5usize {
        for m in n..=5 {
            let cost = Mat::from_fn(n, m, |_, _| r.next());
            let total: f64 = assign(&cost).iter().enumerate().map(|(i, j)| cost[(i, j.unwrap())]).sum();
            fn best(cost: &Mat, i: usize, used: u32) -> f64 {
                if i == cost.rows() {
                    return 0.0;
                }
                let free = (0..cost.cols()).filter(|j| used & (1 << j) == 0);
                free.map(|j| cost[(i, j)] + best(cost, i + 1, used | 1 << j)).fold(f64::INFINITY, f64::min)
            }
            assert!((total - best(&cost, 0, 0)).abs() < 1e-14);
        }
    }
}

#[test]
fn derivative_of_a_standard_eigenvalue() {
    let mut r = Rng(31);
    let (a, da) = (r.mat(6), r.mat(6));
    let h = 1e-6;
    let at = |h: f64| modes(&Mat::from_fn(6, 6, |i, j| a[(i, j)] + h * da[(i, j)])).unwrap();
    for ((m, p), q) in at(0.0).iter().zip(at(h)).zip(at(-h)) {
        let numeric = (p.value - q.value).scale(0.5 / h);
        assert!((numeric - derivative(m, &da)).abs() < 1e-8);
    }
}

/// Entries next to the smallest number, as of a body that hardly anything holds beside very stiff ones: the iteration ends, and gives no value that is not a number.
#[test]
fn entries_of_extreme_size_come_to_an_end() {
    let (m, base) = (5.798_678_748_387_765, 1.985_589_735_334_183);
    let mut a = Mat::zeros(8, 8);
    for i in 0..4 {
        a[(i, 4 + i)] = 1.0;
    }
    for (i, j, x) in [(4, 0, -1e15), (5, 0, -1e15), (5, 1, -1e-100), (4, 5, -1e6), (5, 4, -1e12), (5, 5, -16.8)] {
        a[(i, j)] = x / m;
    }
    (a[(6, 2)], a[(7, 3)]) = (-1e-308 / base, -1e-308 / base);
    let mut r = Rng(11);
    let mut s = Spectrum::default();
    let mut found = 0;
    for k in 0..2000 {
        // the same in any order of its states, and random matrices as wide
        let mut order: Vec<usize> = (0..8).collect();
        (1..8).rev().for_each(|i| order.swap(i, ((r.next() + 0.5) * (i + 1) as f64) as usize));
        let a = if k % 2 == 0 {
            Mat::from_fn(8, 8, |i, j| a[(order[i], order[j])])
        } else {
            Mat::from_fn(8, 8, |_, _| if r.next() < 0.2 { 0.0 } else { r.next() * 10f64.powf(616.0 * r.next()) })
        };
        if let Ok(values) = s.of(&a) {
            assert!(values.iter().all(|z| z.re.is_finite() && z.im.is_finite()), "{a:?}");
            found += 1;
        }
        if let Ok(modes) = modes(&a) {
            assert!(modes.iter().all(|m| m.value.re.is_finite() && m.value.im.is_finite()), "{a:?}");
        }
    }
    assert!(found > 1000, "{found}");
}

/// What a decomposition leaves in the upper halves of wide registers would slow down all arithmetic after it.
#[test]
fn decompositions_leave_no_wide_registers_in_use() {
    let clean = || crate::lanes::cleared(|| ());
    clean();
    if crate::lanes::upper_halves_in_use() != Some(false) {
        // the processor does not say
        return;
    }
    let mut r = Rng(3);
    let (a, z, e) = (r.mat(40), r.cmat(40), r.cmat(40));
    let both = Mat::from_fn(40, 40, |i, j| a[(i, j)] + a[(j, i)]);
    let all: [(&str, &dyn Fn() -> bool); 7] = [
        ("symmetric", &|| super::number::symmetric(&both).is_ok()),
        ("real values", &|| f64::values(&a).is_ok()),
        ("real vectors", &|| f64::evd(&a).is_ok()),
        ("real singular values", &|| f64::svd(&a).is_ok()),
        ("complex values", &|| C64::values(&z).is_ok()),
        ("complex vectors", &|| C64::evd(&z).is_ok()),
        ("pencil", &|| super::number::qz(&z, &e).is_ok()),
    ];
    for (name, run) in all {
        clean();
        assert!(run(), "{name}");
        assert_eq!(crate::lanes::upper_halves_in_use(), Some(false), "{name}");
    }
}
