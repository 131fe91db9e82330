//! The border between cells that jump and cells that do not: pieces along the sides where two such cells meet.

use super::ParameterAxis;

/// A piece of the border, from one corner of a cell to another.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    /// Both ends: x, y.
    pub ends: [[f64; 2]; 2],
    /// The parameter that changes across it: 0 is x, 1 is y.
    pub across: usize,
    /// Its values on both sides.
    pub between: [f64; 2],
}

/// Sides of the cells: half way between the centres, the outer ones as far outside.
fn sides(axis: &ParameterAxis, centres: &[f64]) -> Vec<f64> {
    let there = |x: f64| if axis.logarithmic { x.ln() } else { x };
    let back = |t: f64| if axis.logarithmic { t.exp() } else { t };
    let t: Vec<f64> = centres.iter().map(|&x| there(x)).collect();
    let n = t.len();
    let outer = |a: usize, b: usize| 1.5 * t[a] - 0.5 * t[b];
    let inner = t.windows(2).map(|w| 0.5 * (w[0] + w[1]));
    [outer(0, 1)].into_iter().chain(inner).chain([outer(n - 1, n - 2)]).map(back).collect()
}

/// All pieces. `jumps` says row by row (y outer) whether a cell jumps; `None` where that is not known.
pub(super) fn pieces(axes: &[ParameterAxis; 2], values: &[Vec<f64>; 2], jumps: &[Option<bool>]) -> Vec<Piece> {
    let [xs, ys] = values;
    let (xe, ye) = (sides(&axes[0], xs), sides(&axes[1], ys));
    let at = |i: usize, j: usize| jumps.get(j * xs.len() + i).copied().flatten();
    let differ = |a: Option<bool>, b: Option<bool>| a.zip(b).is_some_and(|(a, b)| a != b);
    let mut out = Vec::new();
    for j in 0..ys.len() {
        for i in 0..xs.len() {
            if i + 1 < xs.len() && differ(at(i, j), at(i + 1, j)) {
                let ends = [[xe[i + 1], ye[j]], [xe[i + 1], ye[j + 1]]];
                out.push(Piece { ends, across: 0, between: [xs[i], xs[i + 1]] });
            }
            if j + 1 < ys.len() && differ(at(i, j), at(i, j + 1)) {
                let ends = [[xe[i], ye[j + 1]], [xe[i + 1], ye[j + 1]]];
                out.push(Piece { ends, across: 1, between: [ys[j], ys[j + 1]] });
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::RangeValue;

    fn axis(logarithmic: bool) -> ParameterAxis {
        let range = RangeValue { from: 1.0, to: 100.0, points: Some(3) };
        ParameterAxis { path: "a.b".into(), unit: "", range, logarithmic }
    }

    #[test]
    fn sides_lie_half_way_on_the_scale_of_the_axis() {
        assert_eq!(sides(&axis(false), &[1.0, 3.0, 5.0]), [0.0, 2.0, 4.0, 6.0]);
        let s = sides(&axis(true), &axis(true).values());
        for (a, b) in s.iter().zip([10f64.powf(-0.5), 10f64.powf(0.5), 10f64.powf(1.5), 10f64.powf(2.5)]) {
            assert!((a / b - 1.0).abs() < 1e-14, "{a} {b}");
        }
    }

    /// One cell that jumps among others has a border of four pieces; beside a cell of which nothing is known there is none.
    #[test]
    fn the_border_goes_round_the_cells_that_jump() {
        let values = [vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 2.0]];
        let axes = [axis(false), axis(false)];
        let mut jumps = vec![Some(false); 9];
        jumps[4] = Some(true);
        let round = pieces(&axes, &values, &jumps);
        assert_eq!(round.len(), 4);
        assert!(round.iter().flat_map(|p| p.ends).flatten().all(|c| c == 0.5 || c == 1.5));
        assert_eq!(round.iter().filter(|p| p.across == 0).map(|p| p.between).collect::<Vec<_>>(), [[0.0, 1.0], [1.0, 2.0]]);
        jumps[5] = None;
        assert_eq!(pieces(&axes, &values, &jumps).len(), 3);
    }
}
