//! A fixed set of evenly spread points, so that counts can be compared exactly between runs and programs.
//!
//! Equations: radical inverses of i = 1 .. N in prime bases, without scrambling or skipping. Places take the bases 2, 3, 5, sizes 7,
//! densities 11.
//!
//! Sources: J. H. Halton, Numer. Math. 2 (1960) 84; `docs/theory/separation.md#ensembles-and-recovery`.

/// Radical inverse of `i` in a base: its digits mirrored at the point.
pub fn radical_inverse(mut i: u64, base: u64) -> f64 {
    // the digits are gathered as an integer, so that the quotient is rounded once
    let (mut digits, mut power) = (0u64, 1u64);
    while i > 0 {
        digits = digits * base + i % base;
        power *= base;
        i /= base;
    }
    digits as f64 / power as f64
}

/// Shares of the volume that place a particle: along the cup, squared radius, angle; then of its size and of its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Base 2.
    pub along: f64,
    /// Base 3.
    pub area: f64,
    /// Base 5.
    pub turn: f64,
    /// Base 7.
    pub size: f64,
    /// Base 11.
    pub density: f64,
}

/// Point `i` of the set, counted from 1.
pub fn point(i: u64) -> Point {
    let h = |base| radical_inverse(i, base);
    Point { along: h(2), area: h(3), turn: h(5), size: h(7), density: h(11) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each stretch of b^k consecutive indices has exactly one point in each of b^k equal cells.
    #[test]
    fn every_cell_has_its_point() {
        for base in [2u64, 3, 5, 7, 11] {
            let cells = base.pow(3);
            let mut seen = vec![0; cells as usize];
            for i in 1..=cells {
                seen[(radical_inverse(i, base) * cells as f64 + 1e-9) as usize % cells as usize] += 1;
            }
            assert!(seen.iter().all(|&n| n == 1));
        }
    }
}
