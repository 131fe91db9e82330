//! Structural sparsity of a square matrix.

use std::ops::Range;

/// Which entries of a square matrix may differ from zero, in rows. The set is symmetric and holds the diagonal.
///
/// ```
/// use laval_num::factor::Pattern;
/// let p = Pattern::new(3, [(0, 2)]);
/// assert_eq!(p.entries(), 5);
/// assert!(p.index(2, 0).is_some() && p.index(1, 0).is_none());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pattern {
    /// First entry of each row, and their number at the end.
    starts: Vec<usize>,
    columns: Vec<usize>,
}

impl Pattern {
    /// The pattern of these places (row, column), of their mirror images and of the diagonal.
    ///
    /// # Panics
    /// A place outside of `n` rows and columns.
    pub fn new(n: usize, places: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut rows: Vec<Vec<usize>> = (0..n).map(|i| vec![i]).collect();
        for (i, j) in places {
            rows[i].push(j);
            rows[j].push(i);
        }
        let mut out = Pattern { starts: vec![0], columns: Vec::new() };
        for mut row in rows {
            row.sort_unstable();
            row.dedup();
            out.columns.extend(row);
            out.starts.push(out.columns.len());
        }
        out
    }
    /// Rows.
    pub fn n(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }
    /// Number of entries.
    pub fn entries(&self) -> usize {
        self.columns.len()
    }
    fn range(&self, i: usize) -> Range<usize> {
        self.starts[i]..self.starts[i + 1]
    }
    /// Number of an entry, by which values are stored; `None` outside of the pattern.
    pub fn index(&self, i: usize, j: usize) -> Option<usize> {
        let range = self.range(i);
        let place = self.columns[range.clone()].binary_search(&j).ok()?;
        Some(range.start + place)
    }
    /// The pattern over some unknowns (in rising order) and, where requested, one more row and column that hold everything; for each entry the number it has here,
    /// `None` in the row and the column that are added.
    pub fn of(&self, members: &[usize], bordered: bool) -> (Pattern, Vec<Option<usize>>) {
        let mut place = vec![usize::MAX; self.n()];
        members.iter().enumerate().for_each(|(k, &i)| place[i] = k);
        let (mut out, mut from) = (Pattern { starts: vec![0], columns: Vec::new() }, Vec::new());
        for &i in members {
            for (e, j) in self.row(i).filter(|x| place[x.1] != usize::MAX) {
                out.columns.push(place[j]);
                from.push(Some(e));
            }
            if bordered {
                out.columns.push(members.len());
                from.push(None);
            }
            out.starts.push(out.columns.len());
        }
        if bordered {
            out.columns.extend(0..=members.len());
            from.resize(out.columns.len(), None);
            out.starts.push(out.columns.len());
        }
        (out, from)
    }
    /// Entries of a row, from left to right: number and column.
    #[inline]
    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, usize)> {
        let range = self.range(i);
        range.clone().zip(self.columns[range].iter().copied())
    }
}
