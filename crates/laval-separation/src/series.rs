//! A run-up as a power series in the sedimentation coefficient: the same for particles of all sizes and starts.
//!
//! Equations: with Stokes' drag in balance with the field `r' = s (A(t) r + b(t))`, so that with `M = [A b; 0 0]`
//!
//! ```text
//! r(T) = sum_k s^k P_k(T) [r(0); 1],   P_0 = 1,  P_k' = M P_(k-1)
//! ```
//!
//! The P_k are integrated once, by the steps of [`super::drift`].
//!
//! Symbols: s sedimentation coefficient, s; `theta = |s| int |A| dt`.
//!
//! Validity: taken where theta is at most 1 (the remainder is below 1e-9 of the way; the steps themselves err by a few
//! millionths of it) and where no surface is within reach of the particle, whose way towards each is bounded
//! by `|s| int max (A r + b) dt` over the liquid. Elsewhere the particle is followed step by step.
//!
//! Sources: G. Peano, Math. Ann. 32 (1888) 450; `docs/theory/separation.md#drag-dominated-limit`.

/// Rows of `[A b]`.
pub(super) type Affine = [[f64; 4]; 3];

/// Powers kept, and the largest theta.
const POWERS: usize = 12;
const THETA: f64 = 1.0;

/// See the [module](self).
#[derive(Clone, Debug)]
pub(super) struct Series {
    terms: [Affine; POWERS],
    /// int |A| dt, 1/s.
    strength: f64,
    /// int max (A r + b) dt, m/s.
    reach: Reach,
}

/// Distances of a place to the surfaces of a cup, m; or the largest velocity towards each over the sedimentation coefficient, summed over a time, m/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Reach {
    /// To the side.
    pub side: f64,
    /// To the bottom, along y.
    pub bottom: f64,
    /// To the surface, against y.
    pub surface: f64,
}

impl Reach {
    /// A particle with this sedimentation coefficient stays closer than these distances to its start; false with NaN.
    fn inside(&self, sedimentation: f64, clear: &Reach) -> bool {
        // particles lighter than the liquid move the other way
        let (bottom, surface) = if sedimentation < 0.0 { (self.surface, self.bottom) } else { (self.bottom, self.surface) };
        let s = sedimentation.abs();
        s * self.side < clear.side && s * bottom < clear.bottom && s * surface < clear.surface
    }
}

/// A power before its integration: `M P` with the last row of P that of the unit matrix for P_0, zero otherwise.
fn product(m: &Affine, p: &Affine, first: bool) -> Affine {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let last = if first && j == 3 { m[i][3] } else { 0.0 };
            m[i][0] * p[0][j] + m[i][1] * p[1][j] + m[i][2] * p[2][j] + last
        })
    })
}

fn shifted(p: &Affine, by: f64, rate: &Affine) -> Affine {
    std::array::from_fn(|i| std::array::from_fn(|j| p[i][j] + by * rate[i][j]))
}

impl Series {
    /// `steps`: duration, `[A b]` at its begin, middle and end, and upper bounds of |A| and of A r + b over the liquid.
    pub fn new(steps: impl Iterator<Item = (f64, [Affine; 3], f64, Reach)>) -> Self {
        let unit: Affine = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
        let mut out = Series { terms: [[[0.0; 4]; 3]; POWERS], strength: 0.0, reach: Reach::default() };
        for (h, m, norm, most) in steps {
            out.strength += h * norm;
            out.reach.side += h * most.side;
            out.reach.bottom += h * most.bottom;
            out.reach.surface += h * most.surface;
            // the power below, at the begin, at the two estimates of the middle, and at the end
            let mut below = [unit; 4];
            for (k, term) in out.terms.iter_mut().enumerate() {
                let first = k == 0;
                let rates = [
                    product(&m[0], &below[0], first),
                    product(&m[1], &below[1], first),
                    product(&m[1], &below[2], first),
                    product(&m[2], &below[3], first),
                ];
                below = [*term, shifted(term, 0.5 * h, &rates[0]), shifted(term, 0.5 * h, &rates[1]), shifted(term, h, &rates[2])];
                for (r, weight) in rates.iter().zip([1.0, 2.0, 2.0, 1.0]) {
                    *term = shifted(term, h / 6.0 * weight, r);
                }
            }
        }
        out
    }

    /// Place at the end of a particle that has the surfaces at these distances at its start; `None` where the series does not hold.
    #[inline]
    pub fn end(&self, sedimentation: f64, start: [f64; 3], clear: &Reach) -> Option<[f64; 3]> {
        // NaN fails
        if !(sedimentation.abs() * self.strength <= THETA && self.reach.inside(sedimentation, clear)) {
            return None;
        }
        let mut way = [0.0; 3];
        for term in self.terms.iter().rev() {
            for (w, row) in way.iter_mut().zip(term) {
                *w = sedimentation * (*w + row[0] * start[0] + row[1] * start[1] + row[2] * start[2] + row[3]);
            }
        }
        Some([start[0] + way[0], start[1] + way[1], start[2] + way[2]])
    }
}
