//! Roots and maxima of functions of one variable.

/// Root of `f` in a bracket with a change of sign, by Brent's method; `None` where `f` cannot be evaluated or does not change sign.
pub fn root<F: FnMut(f64) -> Option<f64>>(mut f: F, a: (f64, f64), b: (f64, f64), tolerance: f64) -> Option<f64> {
    let ((mut a, mut fa), (mut b, mut fb)) = (a, b);
    if fa == 0.0 {
        return Some(a);
    }
    if fa * fb > 0.0 || (fa * fb).is_nan() {
        return None;
    }
    let (mut c, mut fc) = (a, fa);
    let (mut d, mut e) = (b - a, b - a);
    for _ in 0..200 {
        if fb * fc > 0.0 {
            (c, fc) = (a, fa);
            d = b - a;
            e = d;
        }
        if fc.abs() < fb.abs() {
            (a, b, c) = (b, c, b);
            (fa, fb, fc) = (fb, fc, fb);
        }
        let tol = 2.0 * f64::EPSILON * b.abs() + 0.5 * tolerance;
        let m = 0.5 * (c - b);
        if m.abs() <= tol || fb == 0.0 {
            return Some(b);
        }
        if e.abs() >= tol && fa.abs() > fb.abs() {
            let s = fb / fa;
            let (mut p, mut q) = if a == c {
                (2.0 * m * s, 1.0 - s)
            } else {
                let (q, r) = (fa / fc, fb / fc);
                (s * (2.0 * m * q * (q - r) - (b - a) * (r - 1.0)), (q - 1.0) * (r - 1.0) * (s - 1.0))
            };
            if p > 0.0 {
                q = -q
            } else {
                p = -p
            }
            if 2.0 * p < (3.0 * m * q - (tol * q).abs()).min((e * q).abs()) {
                (e, d) = (d, p / q);
            } else {
                (d, e) = (m, m);
            }
        } else {
            (d, e) = (m, m);
        }
        (a, fa) = (b, fb);
        b += if d.abs() > tol { d } else { tol.copysign(m) };
        fb = f(b)?;
        if fb.is_nan() {
            return None;
        }
    }
    None
}

/// Maximum of `f` between `a` and `b` (one maximum inside), by golden section and parabolas (Brent); the place and the value.
pub fn maximum<F: FnMut(f64) -> Option<f64>>(mut f: F, a: f64, b: f64, tolerance: f64) -> Option<(f64, f64)> {
    const GOLD: f64 = 0.381966011250105;
    let (mut a, mut b) = (a, b);
    let mut x = a + GOLD * (b - a);
    let (mut w, mut v) = (x, x);
    let mut fx = -f(x)?;
    let (mut fw, mut fv) = (fx, fx);
    let (mut d, mut e) = (0.0f64, 0.0f64);
    for _ in 0..200 {
        let m = 0.5 * (a + b);
        let tol = f64::EPSILON.sqrt() * x.abs() * 1e-2 + tolerance;
        if (x - m).abs() <= 2.0 * tol - 0.5 * (b - a) {
            return Some((x, -fx));
        }
        let mut golden = true;
        if e.abs() > tol {
            let r = (x - w) * (fx - fv);
            let q0 = (x - v) * (fx - fw);
            let mut p = (x - v) * q0 - (x - w) * r;
            let mut q = 2.0 * (q0 - r);
            if q > 0.0 {
                p = -p
            } else {
                q = -q
            }
            if p.abs() < (0.5 * q * e).abs() && p > q * (a - x) && p < q * (b - x) {
                (e, d) = (d, p / q);
                let u = x + d;
                if u - a < 2.0 * tol || b - u < 2.0 * tol {
                    d = tol.copysign(m - x);
                }
                golden = false;
            }
        }
        if golden {
            e = if x < m { b - x } else { a - x };
            d = GOLD * e;
        }
        let u = if d.abs() >= tol { x + d } else { x + tol.copysign(d) };
        let fu = -f(u)?;
        if fu <= fx {
            if u < x {
                b = x
            } else {
                a = x
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                a = u
            } else {
                b = u
            }
            if fu <= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu <= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    Some((x, -fx))
}

/// Root of `f` (value and derivative) between `a` and `b`, where the values have opposite signs (one may be zero): to a few roundings of the
/// root. Newton steps that leave the bracket or do not halve it in two tries become bisections. `None` when a value is not a number or the
/// signs agree.
pub fn root_by_newton(mut f: impl FnMut(f64) -> (f64, f64), a: f64, b: f64) -> Option<f64> {
    let (mut lo, mut hi) = (a, b);
    let (fl, fh) = (f(lo).0, f(hi).0);
    if fl == 0.0 {
        return Some(lo);
    }
    if fh == 0.0 {
        return Some(hi);
    }
    // NaN fails
    if !(fl * fh < 0.0) {
        return None;
    }
    if fl > 0.0 {
        std::mem::swap(&mut lo, &mut hi);
    }
    let mut x = 0.5 * (lo + hi);
    let (mut last, mut before) = ((hi - lo).abs(), (hi - lo).abs());
    for _ in 0..200 {
        let (v, d) = f(x);
        if v.is_nan() {
            return None;
        }
        if v == 0.0 {
            return Some(x);
        }
        if v < 0.0 {
            lo = x
        } else {
            hi = x
        }
        let tolerance = 2.0 * f64::EPSILON * x.abs().max(f64::MIN_POSITIVE);
        let step = v / d;
        let inside = (x - step - lo) * (x - step - hi) < 0.0;
        let next = if inside && step.abs() < 0.5 * before { x - step } else { 0.5 * (lo + hi) };
        (before, last) = (last, (next - x).abs());
        if last <= tolerance || (hi - lo).abs() <= tolerance {
            return Some(next);
        }
        x = next;
    }
    Some(x)
}

/// Narrows a bracket of a zero of `g` to a few roundings of t, `ga` and `gb` having opposite signs (`gb` may be zero). `None` if g is NaN.
///
/// Interpolation, truncation, projection (Oliveira, Takahashi 2021): superlinear, and never more evaluations than bisection plus one.
pub fn bracket(mut a: f64, mut ga: f64, mut b: f64, mut gb: f64, mut g: impl FnMut(f64) -> f64) -> Option<(f64, f64)> {
    let tol = 2.0 * f64::EPSILON * a.abs().max(b.abs());
    let width = (b - a).abs();
    let mut r = tol * 2f64.powf((width / (2.0 * tol)).log2().ceil().max(0.0) + 1.0);
    let k = 0.2 / width;
    while (b - a).abs() > 2.0 * tol {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a).abs());
        let reach = r - half;
        r *= 0.5;
        let secant = (gb * a - ga * b) / (gb - ga);
        let toward = (middle - secant).signum();
        let shift = k * (b - a) * (b - a);
        let t = if shift <= (middle - secant).abs() { secant + toward * shift } else { middle };
        let x = if (t - middle).abs() <= reach { t } else { middle - toward * reach };
        // also when the values are infinite and the secant is not a number
        let x = if (x - a) * (x - b) < 0.0 { x } else { middle };
        if x == a || x == b {
            break;
        }
        let gx = g(x);
        if gx.is_nan() {
            return None;
        }
        if gx != 0.0 && (gx > 0.0) == (ga > 0.0) {
            (a, ga) = (x, gx);
        } else {
            (b, gb) = (x, gx);
        }
    }
    Some((a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_root_and_maximum() {
        let r = root(|x| Some(x.cos() - x), (0.0, 1.0), (1.0, 1.0f64.cos() - 1.0), 1e-15).unwrap();
        assert!((r - 0.739_085_133_215_160_6).abs() < 1e-15);
        assert!(root(|x| Some(1.0 + x * x), (-1.0, 2.0), (1.0, 2.0), 1e-12).is_none());
        let (x, y) = maximum(|x| Some(3.0 - (x - 0.7).powi(2)), 0.0, 2.0, 1e-12).unwrap();
        assert!((x - 0.7).abs() < 1e-7 && (y - 3.0).abs() < 1e-14);
    }

    #[test]
    fn roots_of_awkward_functions() {
        type Function = fn(f64) -> (f64, f64);
        let cases: [(Function, f64, f64, f64); 4] = [
            (|x| (x * x - 2.0, 2.0 * x), 0.0, 2.0, 2f64.sqrt()),
            (|x| (x.powi(9) - 1e-9, 9.0 * x.powi(8)), -1.0, 2.0, 0.1),
            (|x| (if x < 1.7 { -1.0 } else { 1.0 }, 0.0), 1.0, 2.0, 1.7),
            (|x| ((x - 100.0).exp() - 2.0, (x - 100.0).exp()), 100.0, 104.0, 100.0 + 2f64.ln()),
        ];
        for (f, a, b, want) in cases {
            for (a, b) in [(a, b), (b, a)] {
                let x = root_by_newton(f, a, b).unwrap();
                assert!((x - want).abs() <= 4e-15 * want.abs(), "{x} {want}");
            }
        }
        assert_eq!(root_by_newton(|_| (f64::NAN, 0.0), 0.0, 1.0), None);
        assert_eq!(root_by_newton(|x| (x + 1.0, 1.0), 0.0, 1.0), None);
    }

    #[test]
    fn brackets_are_narrow_and_hold_the_zero() {
        let mut calls = 0;
        for (a, b, f) in [
            (0.0, 1.0, &(|x: f64| x - 0.3) as &dyn Fn(f64) -> f64),
            (2.0, -1.0, &|x: f64| x.powi(9) - 1e-9),
            (-1.0, 4.0, &|x: f64| (x - 0.1).cbrt()),
            (1.0, 2.0, &|x: f64| if x < 1.7 { -1.0 } else { f64::INFINITY }),
            (100.0, 101.0, &|x: f64| (x - 100.0).exp() - 2.0),
            (0.0, 1.0, &|x: f64| if x <= 0.5 { -1.0 } else { 0.0 }),
        ] {
            let (x, y) = bracket(a, f(a), b, f(b), |x| {
                calls += 1;
                f(x)
            })
            .unwrap();
            assert!((y - x).abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs()));
            assert!(f(x) * f(a) > 0.0 && f(y) * f(a) <= 0.0, "{x} {y}");
        }
        assert!(calls <= 6 * 54);
        assert_eq!(bracket(0.0, -1.0, 1.0, 1.0, |_| f64::NAN), None);
    }
}
