//! The first-order form of a machine at one state.

use crate::model::tangent::Tangent;
use laval_num::dense::{Lu, Mat};

/// Most first-order states a map over the period is computed for.
pub const MOST_STATES: usize = 64;

/// `[q v z]' = A [q v z]` from tangents; `None` where a coordinate has no mass.
pub(in crate::harmonic) fn first_order(t: &Tangent) -> Option<Mat> {
    let (n, m) = (t.a.rows(), t.rate_z.rows());
    let mut p = Mat::from_fn(n, 2 * n + m, |i, j| -match j {
        j if j < n => t.q[(i, j)],
        j if j < 2 * n => t.v[(i, j - n)],
        j => t.z[(i, j - 2 * n)],
    });
    Lu::new(&t.a).ok()?.solve_mat(&mut p);
    let coupled = t.rate_a.matmul(&p);
    Some(Mat::from_fn(2 * n + m, 2 * n + m, |i, j| match i {
        i if i < n => f64::from(u8::from(j == n + i)),
        i if i < 2 * n => p[(i - n, j)],
        i => {
            let i = i - 2 * n;
            coupled[(i, j)]
                + match j {
                    j if j < n => t.rate_q[(i, j)],
                    j if j < 2 * n => t.rate_v[(i, j - n)],
                    j => t.rate_z[(i, j - 2 * n)],
                }
        }
    }))
}
