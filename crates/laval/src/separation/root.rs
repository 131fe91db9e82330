//! One bracketed root, by Newton steps that never leave the bracket.

/// Root of `f` (value and derivative) between `a` and `b`, where the values have opposite signs (one may be zero): to a few roundings of the
/// root. Newton steps that leave the bracket or do not halve it in two tries become bisections. `None` when a value is not a number or the
/// signs agree.
pub fn root(mut f: impl FnMut(f64) -> (f64, f64), a: f64, b: f64) -> Option<f64> {
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

#[cfg(test)]
mod tests {
    use super::root;

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
                let x = root(f, a, b).unwrap();
                assert!((x - want).abs() <= 4e-15 * want.abs(), "{x} {want}");
            }
        }
        assert_eq!(root(|_| (f64::NAN, 0.0), 0.0, 1.0), None);
        assert_eq!(root(|x| (x + 1.0, 1.0), 0.0, 1.0), None);
    }
}
