//! The border between cells that jump and cells that do not: curves through the places where it crosses the lines between neighbouring cells.

use super::ParameterAxis;

/// A point of the border, on the line between two neighbouring cells.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Crossing {
    /// Its place: x, y.
    pub at: [f64; 2],
    /// The parameter that changes across the border there: 0 is x, 1 is y.
    pub across: usize,
    /// Its values in the two cells.
    pub between: [f64; 2],
    /// A curve begins here.
    pub begins: bool,
}

/// A cell by its column and row.
type Place = (usize, usize);

/// What is known of the cells, row by row (y outer).
pub(super) struct Grid<'a> {
    pub axes: &'a [ParameterAxis; 2],
    pub values: &'a [Vec<f64>; 2],
    /// Whether a cell jumps; `None` where that is not known.
    pub jumps: &'a [Option<bool>],
    /// Width of the hysteresis; not finite or 0 where there is none or it goes on beyond the range.
    pub width: &'a [f64],
}

impl Grid<'_> {
    fn index(&self, (i, j): Place) -> usize {
        j * self.values[0].len() + i
    }

    fn jumps(&self, at: Place) -> Option<bool> {
        self.jumps.get(self.index(at)).copied().flatten()
    }

    /// Where the border crosses from a cell that jumps to its neighbour, as a share of the way: two folds that meet in a cusp are apart by a distance whose
    /// power 2/3 grows evenly, so the widths of the last two cells say where it is zero; half way where that is not known.
    fn share(&self, inside: Place, outside: Place) -> f64 {
        let beyond = |a: usize, b: usize| (2 * a).checked_sub(b);
        let before = beyond(inside.0, outside.0).zip(beyond(inside.1, outside.1));
        let size = |at: Place| {
            let w = self.width.get(self.index(at)).copied().unwrap_or(f64::NAN);
            (w > 0.0 && w.is_finite()).then(|| w.powf(2.0 / 3.0))
        };
        let before = before.filter(|b| b.0 < self.values[0].len() && b.1 < self.values[1].len() && self.jumps(*b) == Some(true));
        match (size(inside), before.and_then(size)) {
            (Some(here), Some(further)) if further > here => (here / (further - here)).clamp(0.02, 0.98),
            _ => 0.5,
        }
    }

    /// The crossing between two neighbours, if there is one.
    fn crossing(&self, a: Place, b: Place) -> Option<Crossing> {
        let (ja, jb) = (self.jumps(a)?, self.jumps(b)?);
        if ja == jb {
            return None;
        }
        let (inside, outside) = if ja { (a, b) } else { (b, a) };
        let f = self.share(inside, outside);
        let across = usize::from(a.0 == b.0);
        let value = |k: usize, p: Place| self.values[k][if k == 0 { p.0 } else { p.1 }];
        let along = |k: usize| {
            let (p, q) = (value(k, inside), value(k, outside));
            if self.axes[k].logarithmic { (p.ln() + f * (q.ln() - p.ln())).exp() } else { p + f * (q - p) }
        };
        let at = if across == 0 { [along(0), value(1, a)] } else { [value(0, a), along(1)] };
        let [low, high] = [value(across, a), value(across, b)];
        Some(Crossing { at, across, between: [low.min(high), low.max(high)], begins: false })
    }

    /// All curves of the border, one after the other.
    pub fn border(&self) -> Vec<Crossing> {
        let (nx, ny) = (self.values[0].len(), self.values[1].len());
        // pieces from one line between neighbours to another, each line named by its first cell and its direction
        let mut pieces: Vec<[(Place, usize); 2]> = Vec::new();
        for j in 0..ny.saturating_sub(1) {
            for i in 0..nx.saturating_sub(1) {
                let lines = [((i, j), 0), ((i + 1, j), 1), ((i, j + 1), 0), ((i, j), 1)];
                let cut: Vec<(Place, usize)> = lines.into_iter().filter(|l| self.on(*l).is_some()).collect();
                let known = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].iter().all(|p| self.jumps(*p).is_some());
                if known {
                    pieces.extend(cut.chunks_exact(2).map(|c| [c[0], c[1]]));
                }
            }
        }
        let mut out = Vec::new();
        while let Some(start) = self.next(&mut pieces) {
            let mut begins = true;
            let mut chain = vec![start[0], start[1]];
            while let Some(k) = pieces.iter().position(|p| p.contains(&chain[chain.len() - 1])) {
                let p = pieces.swap_remove(k);
                let tip = chain[chain.len() - 1];
                chain.push(if p[0] == tip { p[1] } else { p[0] });
            }
            for mut crossing in chain.into_iter().filter_map(|l| self.on(l)) {
                crossing.begins = std::mem::take(&mut begins);
                out.push(crossing);
            }
        }
        out
    }

    fn on(&self, (from, direction): (Place, usize)) -> Option<Crossing> {
        let to = if direction == 0 { (from.0 + 1, from.1) } else { (from.0, from.1 + 1) };
        self.crossing(from, to)
    }

    /// Takes a piece to begin a curve with: one whose first end no other shares, so that open curves are followed from an end.
    fn next(&self, pieces: &mut Vec<[(Place, usize); 2]>) -> Option<[(Place, usize); 2]> {
        let alone = |end: &(Place, usize)| pieces.iter().filter(|p| p.contains(end)).count() == 1;
        let open = pieces.iter().position(|p| p.iter().any(alone));
        let k = open.or_else(|| (!pieces.is_empty()).then_some(0))?;
        let turn = alone(&pieces[k][1]) && !alone(&pieces[k][0]);
        let p = pieces.swap_remove(k);
        Some(if turn { [p[1], p[0]] } else { p })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::RangeValue;

    fn axis(logarithmic: bool) -> ParameterAxis {
        let range = RangeValue { from: 1.0, to: 100.0, points: Some(3) };
        ParameterAxis { path: "a.b".into(), unit: "", range, logarithmic }
    }

    /// Widths of the cusp x = 1 + c y beyond which there is hysteresis: the border is found within a small share of a cell although no cell lies on it.
    #[test]
    fn the_border_lies_where_the_hysteresis_vanishes() {
        let axes = [axis(false), axis(false)];
        let values = [(0..9).map(|i| f64::from(i) / 4.0).collect::<Vec<_>>(), (0..7).map(|j| f64::from(j) / 6.0).collect()];
        let edge = |y: f64| 1.1 + 0.37 * y;
        let cells = || values[1].iter().flat_map(|y| values[0].iter().map(move |x| (*x, *y)));
        let width: Vec<f64> = cells().map(|(x, y)| (x - edge(y)).max(0.0).powf(1.5)).collect();
        let jumps: Vec<Option<bool>> = width.iter().map(|w| Some(*w > 0.0)).collect();
        let border = Grid { axes: &axes, values: &values, jumps: &jumps, width: &width }.border();
        assert_eq!(border.iter().filter(|c| c.begins).count(), 1, "one curve");
        assert!(border.len() >= 7);
        for c in border.iter().filter(|c| c.across == 0) {
            assert!((c.at[0] - edge(c.at[1])).abs() < 1e-9, "{c:?} {}", edge(c.at[1]));
            assert!(c.between[0] <= c.at[0] && c.at[0] <= c.between[1]);
        }
        // without widths it lies half way
        let none = vec![f64::NAN; width.len()];
        let half = Grid { width: &none, axes: &axes, values: &values, jumps: &jumps }.border();
        assert!(half.iter().filter(|c| c.across == 0).all(|c| (c.at[0] - 0.5 * (c.between[0] + c.between[1])).abs() < 1e-12));
    }

    /// One cell that jumps among others has a closed border; beside a cell of which nothing is known there is none.
    #[test]
    fn the_border_goes_round_the_cells_that_jump() {
        let values = [vec![1.0, 10.0, 100.0], vec![0.0, 1.0, 2.0]];
        let axes = [axis(true), axis(false)];
        let mut jumps = vec![Some(false); 9];
        jumps[4] = Some(true);
        let width = vec![f64::NAN; 9];
        let round = Grid { axes: &axes, values: &values, jumps: &jumps, width: &width }.border();
        // back to where it began
        assert_eq!(round.len(), 5);
        assert_eq!(round[0].at, round[4].at);
        let xs: Vec<f64> = round.iter().filter(|c| c.across == 0).map(|c| c.at[0].log10()).collect();
        assert!(xs.iter().all(|x| (x - 0.5).abs() < 1e-12 || (x - 1.5).abs() < 1e-12), "{xs:?}");
        jumps[5] = None;
        let open = Grid { axes: &axes, values: &values, jumps: &jumps, width: &width }.border();
        assert_eq!((open.len(), open.iter().filter(|c| c.begins).count()), (3, 1));
    }
}
