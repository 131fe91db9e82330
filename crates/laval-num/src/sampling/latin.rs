//! Latin hypercube (McKay, Beckman, Conover, Technometrics 21 (1979) 239): in every dimension one point in each of as many intervals as there are points.
//!
//! Points are addressable by index, as those of [`Points`](super::Points): the order of the intervals is a permutation that is computed at one place
//! alone, by a Feistel network over the next power of four, applied until its result is an index again (Black, Rogaway, CT-RSA 2002).

use super::{hash, unit};

const ROUNDS: u64 = 6;
/// Keeps the places within intervals apart from the random numbers of the permutation.
const WITHIN: u64 = 0x6c61_7469_6e00;

/// A Latin hypercube of `rows` points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latin {
    /// Another seed gives another hypercube.
    pub seed: u32,
    /// Number of points, at least 1.
    pub rows: u32,
}

impl Latin {
    /// Coordinate `dimension` of point `index`, strictly between 0 and 1; an index beyond the last is taken for the last.
    ///
    /// ```
    /// use laval_num::sampling::latin::Latin;
    /// let cube = Latin { seed: 1, rows: 5 };
    /// let mut cells: Vec<u32> = (0..5).map(|i| (cube.at(i, 3) * 5.0) as u32).collect();
    /// cells.sort();
    /// assert_eq!(cells, [0, 1, 2, 3, 4]);
    /// ```
    pub fn at(self, index: u32, dimension: u32) -> f64 {
        let rows = u64::from(self.rows.max(1));
        let index = u64::from(index).min(rows - 1);
        let key = hash(u64::from(self.seed), u64::from(dimension), rows);
        let within = unit(hash(key, index, WITHIN));
        ((permuted(key, index, rows) as f64 + within) / rows as f64).min(1.0 - f64::EPSILON / 2.0)
    }
}

/// The place of `index` in a permutation of `0..n`.
fn permuted(key: u64, index: u64, n: u64) -> u64 {
    if n < 2 {
        return 0;
    }
    let half = (64 - (n - 1).leading_zeros()).div_ceil(2);
    let mask = (1u64 << half) - 1;
    let mut x = index;
    loop {
        let (mut left, mut right) = (x >> half, x & mask);
        for round in 0..ROUNDS {
            (left, right) = (right, left ^ (hash(key, round, right) & mask));
        }
        x = left << half | right;
        if x < n {
            return x;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_interval_holds_one_point() {
        for rows in [1u32, 2, 3, 5, 64, 65, 1000, 4097] {
            for (seed, d) in [(0, 0), (1, 0), (1, 9), (77, 300)] {
                let mut hit = vec![0; rows as usize];
                for i in 0..rows {
                    let x = Latin { seed, rows }.at(i, d);
                    assert!(x > 0.0 && x < 1.0, "{x}");
                    hit[(x * f64::from(rows)) as usize] += 1;
                }
                assert!(hit.iter().all(|&h| h == 1), "{rows} points, seed {seed}, dimension {d}");
            }
        }
    }

    /// Pairs of dimensions, and of neighbouring points, fill their square evenly: chi-square of 64 cells, below 120 in 99.99 % of cases.
    #[test]
    fn dimensions_do_not_follow_from_each_other() {
        let cube = Latin { seed: 3, rows: 6400 };
        let cell = |i, d| (cube.at(i, d) * 8.0) as usize;
        for other in [|i: u32| (i, 1), |i: u32| ((i + 1) % 6400, 0), |i: u32| (i, 200)] {
            let mut count = [0u32; 64];
            for i in 0..6400 {
                let (j, d) = other(i);
                count[8 * cell(i, 0) + cell(j, d)] += 1;
            }
            let x: f64 = count.iter().map(|&c| (f64::from(c) - 100.0).powi(2) / 100.0).sum();
            assert!(x > 15.0 && x < 120.0, "{x}");
        }
        assert_ne!(Latin { seed: 4, rows: 6400 }.at(7, 0), cube.at(7, 0));
        // of one cube, not of another
        assert_eq!(cube.at(6400, 0), cube.at(6399, 0));
    }
}
