//! Leaves out points that cannot be seen.

/// Indices to keep of a path in pixels. Consecutive points in the same pixel column (of width `column`) are replaced by the first,
/// the lowest, the highest and the last of them, which paint the same pixels. NaN breaks the path and is kept once; a gap of
/// less than a pixel is none.
pub(super) fn path(points: &[(f64, f64)], column: f64) -> Vec<usize> {
    let mut keep = Vec::new();
    let mut i = 0;
    while i < points.len() {
        let (x, y) = points[i];
        if broken((x, y)) {
            if i > 0 && !broken(points[i - 1]) {
                keep.push(i);
            }
            i += 1;
            continue;
        }
        let cell = (x / column).floor();
        let (mut low, mut high, mut last) = (i, i, i);
        let after = |k: usize| (k + 1..points.len()).find(|j| !broken(points[*j]));
        let joined = |k: usize, j: &usize| j - k == 1 || (points[*j].1 - points[k].1).abs() <= column;
        while let Some(next) = after(last).filter(|j| (points[*j].0 / column).floor() == cell && joined(last, j)) {
            last = next;
            if points[last].1 < points[low].1 {
                low = last;
            }
            if points[last].1 > points[high].1 {
                high = last;
            }
        }
        let mut four = [i, low, high, last];
        four.sort_unstable();
        keep.push(four[0]);
        for w in four.windows(2) {
            if w[1] != w[0] {
                keep.push(w[1]);
            }
        }
        i = last + 1;
    }
    keep
}

fn broken(p: (f64, f64)) -> bool {
    p.0.is_nan() || p.1.is_nan()
}

/// Indices to keep of a cloud of points: the first in each cell of `cell` pixels.
pub(super) fn cloud(points: &[(f64, f64)], cell: f64) -> Vec<usize> {
    let mut seen = std::collections::HashSet::new();
    (0..points.len())
        .filter(|i| !broken(points[*i]) && seen.insert(((points[*i].0 / cell).floor() as i64, (points[*i].1 / cell).floor() as i64)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_keeps_its_extremes() {
        let n = 20_000;
        let p: Vec<(f64, f64)> = (0..n).map(|i| (i as f64 * 700.0 / n as f64, (i as f64 * 0.37).sin() * (i as f64 * 1e-3).cos())).collect();
        let kept: Vec<_> = path(&p, 1.0).into_iter().map(|i| p[i]).collect();
        assert!(kept.len() <= 4 * 700);
        let range = |points: &[(f64, f64)], column: usize| {
            let inside = points.iter().filter(|q| q.0.floor() as usize == column).map(|q| q.1);
            inside.fold((f64::INFINITY, f64::NEG_INFINITY), |r, y| (r.0.min(y), r.1.max(y)))
        };
        for column in 0..700 {
            assert_eq!(range(&p, column), range(&kept, column));
        }
        assert_eq!((kept[0], kept[kept.len() - 1]), (p[0], p[n - 1]));
    }

    #[test]
    fn gaps_and_folds_stay() {
        let nan = (f64::NAN, f64::NAN);
        let p = [nan, (0.0, 0.0), (5.0, 1.0), nan, nan, (6.0, 1.0), (2.0, 3.0)];
        assert_eq!(path(&p, 1.0), [1, 2, 3, 5, 6]);
    }

    #[test]
    fn gaps_smaller_than_a_pixel_are_none() {
        let p: Vec<(f64, f64)> = (0..20_000).map(|i| (i as f64 * 0.01, if i % 2 == 0 { 0.3 } else { f64::NAN })).collect();
        assert!(path(&p, 1.0).len() <= 4 * 200);
        // a gap that is seen
        let nan = (f64::NAN, f64::NAN);
        assert_eq!(path(&[(0.1, 0.0), nan, (0.2, 9.0)], 1.0), [0, 1, 2]);
    }

    #[test]
    fn clouds_keep_one_per_cell() {
        assert_eq!(cloud(&[(0.1, 0.1), (0.2, 0.3), (1.5, 0.0), (f64::NAN, 0.0)], 1.0), [0, 2]);
    }
}
