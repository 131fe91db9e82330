//! Numbering that keeps the entries of a sparse matrix near its diagonal.

use super::Pattern;
use std::collections::VecDeque;

/// Reverse Cuthill-McKee numbering of the unknowns that `inside` admits: place by place the unknown that stands there.
///
/// Source: A. George, J. W. H. Liu, Computer Solution of Large Sparse Positive Definite Systems, Prentice-Hall 1981, chapter 4.
pub(super) fn reverse_cuthill_mckee(pattern: &Pattern, inside: &[bool]) -> Vec<usize> {
    let n = pattern.n();
    let neighbours = |i: usize| pattern.row(i).map(|e| e.1).filter(move |&j| j != i && inside[j]);
    let degree: Vec<usize> = (0..n).map(|i| neighbours(i).count()).collect();
    let mut placed: Vec<bool> = inside.iter().map(|x| !x).collect();
    let mut order = Vec::with_capacity(n);
    // levels from a start over what is not placed
    let levels = |start: usize, placed: &[bool]| -> Vec<(usize, usize)> {
        let mut seen = placed.to_vec();
        seen[start] = true;
        let (mut queue, mut out) = (VecDeque::from([(start, 0)]), Vec::new());
        while let Some((i, level)) = queue.pop_front() {
            out.push((i, level));
            let mut next: Vec<usize> = neighbours(i).filter(|&j| !seen[j]).collect();
            next.sort_by_key(|&j| (degree[j], j));
            for j in next {
                seen[j] = true;
                queue.push_back((j, level + 1));
            }
        }
        out
    };
    while let Some(first) = (0..n).filter(|&i| !placed[i]).min_by_key(|&i| (degree[i], i)) {
        // an end of the graph: the farthest unknown of least degree, as long as that is farther
        let mut found = levels(first, &placed);
        loop {
            let depth = found.last().map_or(0, |x| x.1);
            let ends = found.iter().filter(|x| x.1 == depth).map(|x| x.0);
            let Some(end) = ends.min_by_key(|&i| (degree[i], i)) else { break };
            let other = levels(end, &placed);
            if other.last().map_or(0, |x| x.1) <= depth {
                break;
            }
            found = other;
        }
        for (i, _) in found {
            placed[i] = true;
            order.push(i);
        }
    }
    order.reverse();
    order
}

/// Largest distance of an entry from the diagonal in a numbering; unknowns without a place are left out.
pub(super) fn half_width(pattern: &Pattern, order: &[usize]) -> usize {
    let mut place = vec![usize::MAX; pattern.n()];
    order.iter().enumerate().for_each(|(k, &i)| place[i] = k);
    let distance = |i: usize| pattern.row(i).filter(|e| place[e.1] != usize::MAX).map(|e| place[e.1].abs_diff(place[i])).max();
    order.iter().filter_map(|&i| distance(i)).max().unwrap_or(0)
}
