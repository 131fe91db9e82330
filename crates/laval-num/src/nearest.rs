//! The point of a box on a plane that lies nearest to another: bounded least squares with one equation.
//!
//! ```text
//! minimise sum_i ((p_i - a_i)/s_i)^2   with  g . p = c,  low_i <= p_i <= high_i
//! p_i = clamp(a_i + l s_i^2 g_i)       with the l at which g . p = c
//! ```
//!
//! `g . p` does not fall with the multiplier l and is linear between the values of l at which a coordinate reaches a bound, so that l is found by going through these.
//!
//! Sources: Nocedal, Wright, Numerical Optimization (2006) section 16.7.

/// One coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Where distance is measured from, within the bounds.
    pub from: f64,
    /// Unit of the distance, above 0.
    pub scale: f64,
    /// Bounds.
    pub low: f64,
    /// See [`Axis::low`].
    pub high: f64,
    /// Of the plane.
    pub gradient: f64,
}

impl Axis {
    fn at(&self, l: f64) -> f64 {
        let moved = l * self.scale * self.scale * self.gradient;
        // a coordinate that the plane does not hold stays, also at the ends of all multipliers
        if self.gradient == 0.0 { self.from } else { (self.from + moved).clamp(self.low, self.high) }
    }
}

/// The nearest point on the plane `g . p = c`, and whether the box has one; else the point of the box that comes nearest to the plane.
pub fn nearest(axes: &[Axis], c: f64) -> (Vec<f64>, bool) {
    let sum = |l: f64| axes.iter().map(|a| a.gradient * a.at(l)).sum::<f64>();
    let mut kinks: Vec<f64> = axes
        .iter()
        .filter(|a| a.gradient != 0.0)
        .flat_map(|a| [a.low, a.high].map(|b| (b - a.from) / (a.scale * a.scale * a.gradient)))
        .filter(|l| l.is_finite())
        .collect();
    kinks.sort_by(f64::total_cmp);
    let point = |l: f64| axes.iter().map(|a| a.at(l)).collect::<Vec<f64>>();
    let (Some(&first), Some(&last)) = (kinks.first(), kinks.last()) else { return (point(0.0), sum(0.0) == c) };
    if !(sum(first) <= c) {
        return (point(first), false);
    }
    if !(sum(last) >= c) {
        return (point(last), false);
    }
    let k = kinks.partition_point(|l| sum(*l) < c);
    let (b, a) = (kinks.get(k).copied().unwrap_or(last), k.checked_sub(1).and_then(|k| kinks.get(k)).copied().unwrap_or(first));
    let (at_a, at_b) = (sum(a), sum(b));
    let l = if at_b > at_a { a + (b - a) * ((c - at_a) / (at_b - at_a)) } else { b };
    (point(l), true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn axis(from: f64, scale: f64, gradient: f64) -> Axis {
        Axis { from, scale, low: -1.0, high: 2.0, gradient }
    }

    #[test]
    fn inside_the_box_it_is_the_foot_of_the_perpendicular() {
        let (p, on) = nearest(&[axis(0.0, 1.0, 3.0), axis(0.0, 1.0, 4.0)], 5.0);
        assert!(on && (p[0] - 0.6).abs() < 1e-15 && (p[1] - 0.8).abs() < 1e-15, "{p:?}");
        // beside a bound the other coordinate makes up for it
        let (p, on) = nearest(&[axis(1.5, 1.0, 1.0), axis(0.0, 0.1, 1.0)], 3.0);
        assert!(on && p[0] == 2.0 && (p[1] - 1.0).abs() < 1e-14, "{p:?}");
        let (p, on) = nearest(&[axis(0.0, 1.0, 1.0), axis(0.5, 1.0, -1.0)], 3.5);
        assert!(!on && p == [2.0, -1.0], "{p:?}");
        assert_eq!(nearest(&[axis(0.3, 1.0, 0.0)], 1.0), (vec![0.3], false));
    }

    proptest! {
        /// No other point of the box on the plane is nearer.
        #[test]
        fn no_other_point_is_nearer(
            from in prop::array::uniform3(-1.0f64..2.0), scale in prop::array::uniform3(0.1f64..10.0), g in prop::array::uniform3(-5.0f64..5.0),
            other in prop::array::uniform3(-1.0f64..2.0),
        ) {
            let axes: Vec<Axis> = (0..3).map(|i| axis(from[i], scale[i], g[i])).collect();
            let c: f64 = (0..3).map(|i| g[i] * other[i]).sum();
            let (p, on) = nearest(&axes, c);
            let far = |p: &[f64]| (0..3).map(|i| ((p[i] - from[i]) / scale[i]).powi(2)).sum::<f64>();
            let sum: f64 = (0..3).map(|i| g[i] * p[i]).sum();
            prop_assert!(on && (sum - c).abs() < 1e-9);
            prop_assert!(far(&p) <= far(&other) * (1.0 + 1e-9) + 1e-12);
        }
    }
}
