use super::super::{Factors, Pattern, Plan};
use super::*;
use std::sync::Arc;

/// Entries of a chain of blocks of four, a few of which couple with one unknown of a foundation.
fn chain(stations: usize, foundation: bool) -> (Plan, [Vec<C64>; 3]) {
    let n = 4 * stations + usize::from(foundation);
    let mut pairs = Vec::new();
    for i in 0..4 * stations {
        pairs.extend((i..(4 * (i / 4) + 8).min(4 * stations)).map(|j| (i, j)));
        if foundation {
            pairs.push((i, n - 1));
        }
    }
    let pattern = Arc::new(Pattern::new(n, pairs));
    let mut seed = 11u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let terms = [1e6, 40.0, 2.0].map(|size| (0..pattern.entries()).map(|_| c(size * random(), 0.1 * size * random())).collect());
    (Plan::new(&pattern), terms)
}

fn places() -> Vec<C64> {
    (0..LANES).map(|k| c(-3.0 + k as f64, 200.0 + 35.0 * k as f64)).collect()
}

#[test]
fn every_lane_is_the_factorisation_of_its_matrix() {
    for (stations, foundation) in [(9, false), (30, false), (30, true)] {
        let (plan, terms) = chain(stations, foundation);
        let quadratic = ScaledQuadratic::new(&plan, terms.each_ref().map(Vec::as_slice), 500.0).unwrap();
        let n = plan.n();
        let (mut values, mut directed) = (LaneFactors::<C64>::default(), LaneFactors::<Directed>::default());
        // the second time over what exchanges have left
        for _ in 0..2 {
            values.factor(&quadratic, &places());
            directed.factor(&quadratic, &places());
        }
        let (turns, plain) = (directed.turns(), values.turns());
        let b: Vec<C64> = (0..n).map(|i| C64::cis(0.7 * i as f64)).collect();
        let mut solved = [false, true].map(|transposed| {
            // of the scaled matrix
            let scale = if transposed { quadratic.columns() } else { quadratic.rows() };
            let mut all: Vec<Pair> = b.iter().zip(scale).map(|(b, k)| [[b.re * k; LANES], [b.im * k; LANES]]).collect();
            values.solve(&mut all, transposed);
            all
        });
        for (l, s) in places().into_iter().enumerate() {
            let at = |e: usize| {
                let [a0, a1, a2] = terms.each_ref().map(|all| all[e]);
                (a0 + s * (a1 + s * a2), a1 + (s * a2).scale(2.0))
            };
            let both = |(v, d): (C64, C64)| c(Dual { re: v.re, eps: [d.re] }, Dual { re: v.im, eps: [d.im] });
            let single: Factors<Directed> = Factors::new(&plan, &(0..terms[0].len()).map(|e| both(at(e))).collect::<Vec<_>>()).unwrap();
            let (det, turn) = (single.log_det(), turns[l].unwrap());
            for phase in [turn.phase, plain[l].unwrap().phase] {
                assert!((C64::cis(phase) - C64::cis(det.phase)).abs() < 1e-10, "{phase} {}", det.phase);
            }
            assert!((turn.rate - det.rate).abs() <= 1e-9 * det.rate.abs(), "{:?} {:?}", turn.rate, det.rate);
            let own = Factors::new(&plan, &(0..terms[0].len()).map(|e| at(e).0).collect::<Vec<_>>()).unwrap();
            for (transposed, all) in solved.iter_mut().enumerate() {
                let mut x = b.clone();
                if transposed == 1 {
                    own.solve_transposed(&mut x)
                } else {
                    own.solve(&mut x)
                }
                let scale = if transposed == 1 { quadratic.rows() } else { quadratic.columns() };
                let size = x.iter().map(|x| x.abs()).fold(0.0, f64::max);
                for i in 0..n {
                    let lane = c(all[i][0][l], all[i][1][l]).scale(scale[i]);
                    assert!((lane - x[i]).abs() <= 1e-9 * size, "{i} {l}: {lane:?} {:?}", x[i]);
                }
            }
        }
    }
}

/// A lane without a determinant leaves the others alone.
#[test]
fn a_singular_lane() {
    let pattern = Arc::new(Pattern::new(40, (1..40).map(|i| (i - 1, i))));
    let [mut k, mut m] = [vec![C64::ZERO; pattern.entries()], vec![C64::ZERO; pattern.entries()]];
    for i in 0..40 {
        // det = 0 exactly at s = 2 i
        (k[pattern.index(i, i).unwrap()], m[pattern.index(i, i).unwrap()]) = (c(4.0, 0.0), C64::ONE);
    }
    use crate::dense::Field;
    let zero = vec![C64::ZERO; pattern.entries()];
    let plan = Plan::new(&pattern);
    let quadratic = ScaledQuadratic::new(&plan, [&k, &zero, &m], 2.0).unwrap();
    let mut factors = LaneFactors::<Directed>::default();
    factors.factor(&quadratic, &[c(0.0, 2.0), c(0.0, 1.0), c(0.0, 3.0)]);
    let turns = factors.turns();
    assert!(turns[0].is_none() && turns[1].is_some());
    // (4 + s^2)^40: rate 80 s / (4 + s^2)
    assert!((turns[2].unwrap().rate - c(0.0, 240.0).scale(-0.2)).abs() < 1e-10);
}
