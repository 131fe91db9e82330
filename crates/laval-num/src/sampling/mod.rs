//! Sampling of uncertain inputs and what can be distinguished from it: points of the unit cube addressable by index, distributions by their
//! quantile functions, quantiles with confidence intervals, sensitivity indices of Sobol and Morris.

pub mod distribution;
pub mod latin;
pub mod morris;
pub mod quantile;
pub mod sobol_indices;

/// Points of one scrambling of the low-discrepancy sequence.
pub const MOST_POINTS: u32 = 1 << 16;
/// Most dimensions of the low-discrepancy sequence.
pub const MOST_DIMENSIONS: u32 = sobol_burley::NUM_DIMENSIONS;

/// Points of the unit cube, each coordinate strictly between 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Points {
    /// Independent and uniform.
    Random,
    /// Sobol sequence with Owen's scrambling, as hashed by Burley (2020); 65536 points of 256 dimensions, after which another scrambling of the same points
    /// follows.
    Sobol,
}

impl Points {
    /// Coordinate `dimension` of point `index`: a function of its arguments alone, whatever was requested before.
    ///
    /// ```
    /// use laval_num::sampling::Points;
    /// let x = Points::Sobol.at(1, 17, 3);
    /// assert!(x > 0.0 && x < 1.0 && x == Points::Sobol.at(1, 17, 3));
    /// ```
    pub fn at(self, seed: u32, index: u32, dimension: u32) -> f64 {
        match self {
            Points::Random => unit(hash(u64::from(seed), u64::from(index), u64::from(dimension))),
            // 24 bits, moved to the middles of their cells so that 0 does not occur
            Points::Sobol => {
                let (block, index, dimension) = (index / MOST_POINTS, index % MOST_POINTS, dimension.min(MOST_DIMENSIONS - 1));
                let seed = if block == 0 { seed } else { hash(u64::from(seed), u64::from(block), u64::MAX) as u32 };
                f64::from(sobol_burley::sample(index, dimension, seed)) + 0.5f64.powi(25)
            }
        }
    }
}

/// 64 random bits at (seed, index, dimension): the finaliser of SplitMix64 (Steele, Lea, Flood 2014) over each in turn.
pub fn hash(seed: u64, index: u64, dimension: u64) -> u64 {
    const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
    let mix = |x: u64| {
        let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    };
    let step = |state: u64, word: u64| mix(state ^ mix(word.wrapping_mul(GOLDEN).wrapping_add(GOLDEN)));
    step(step(step(GOLDEN, seed), index), dimension)
}

/// A number strictly between 0 and 1 from 64 bits: the middle of one of 2^53 cells.
fn unit(bits: u64) -> f64 {
    // one cell at the upper end would round to 1
    (((bits >> 11) as f64 + 0.5) * 0.5f64.powi(53)).min(1.0 - f64::EPSILON / 2.0)
}

/// A whole number below `n` from 64 bits.
fn below(bits: u64, n: usize) -> usize {
    ((u128::from(bits) * n as u128) >> 64) as usize
}

/// Mean and standard deviation of a sample; NaN where it is too small.
pub fn moments(x: &[f64]) -> (f64, f64) {
    let n = x.len() as f64;
    let mean = x.iter().sum::<f64>() / n;
    let square: f64 = x.iter().map(|x| (x - mean).powi(2)).sum();
    (mean, if x.len() > 1 { (square / (n - 1.0)).sqrt() } else { f64::NAN })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Chi-square of 64 cells, 63 degrees of freedom: 99.99 % lies below 120.
    fn chi_square(cells: &[u32]) -> f64 {
        let mean = f64::from(cells.iter().sum::<u32>()) / cells.len() as f64;
        cells.iter().map(|&c| (f64::from(c) - mean).powi(2) / mean).sum()
    }

    #[test]
    fn random_points_fill_cells_and_pairs_of_cells_evenly() {
        for (seed, d) in [(0, 0), (1, 0), (1, 7), (12345, 100)] {
            let mut one = [0u32; 64];
            let mut next = [0u32; 64];
            let mut other = [0u32; 64];
            for i in 0..64_000 {
                let cell = |i, d, n: usize| (Points::Random.at(seed, i, d) * n as f64) as usize;
                one[cell(i, d, 64)] += 1;
                next[8 * cell(i, d, 8) + cell(i + 1, d, 8)] += 1;
                other[8 * cell(i, d, 8) + cell(i, d + 1, 8)] += 1;
            }
            for cells in [one, next, other] {
                let x = chi_square(&cells);
                assert!(x > 20.0 && x < 120.0, "{x}");
            }
        }
    }

    #[test]
    fn every_power_of_two_of_sobol_points_has_one_in_each_interval() {
        for (seed, d) in [(0, 0), (3, 1), (9, 30)] {
            let mut hit = [0; 256];
            (0..256).for_each(|i| hit[(Points::Sobol.at(seed, i, d) * 256.0) as usize] += 1);
            assert!(hit.iter().all(|&h| h == 1), "{hit:?}");
        }
        assert_ne!(Points::Sobol.at(1, 5, 2), Points::Sobol.at(2, 5, 2));
    }

    /// Behind the last point of a scrambling the next one begins, as even and with other points.
    #[test]
    fn more_points_than_one_scrambling_has() {
        for block in [1, 2, 5] {
            let first = block * MOST_POINTS;
            let mut hit = [0; 256];
            (first..first + 256).for_each(|i| hit[(Points::Sobol.at(3, i, 1) * 256.0) as usize] += 1);
            assert!(hit.iter().all(|&h| h == 1), "{hit:?}");
            let same = (0..256).filter(|i| Points::Sobol.at(3, first + i, 1) == Points::Sobol.at(3, *i, 1)).count();
            assert!(same < 4, "{same}");
        }
    }

    #[test]
    fn the_ends_never_occur() {
        assert!(unit(0) > 0.0 && unit(u64::MAX) < 1.0);
        assert!((0..MOST_POINTS).all(|i| (1e-9..1.0).contains(&Points::Sobol.at(7, i, 0))));
        assert_eq!((below(0, 5), below(u64::MAX, 5)), (0, 4));
    }
}
