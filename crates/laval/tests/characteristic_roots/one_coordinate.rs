//! Bands of the rotor with one coordinate, against roots of the discriminant of its quartic.

use super::build;
use super::viscous::machine;
use crate::common::{number, rows};
use laval::model::field::RangeValue;
use laval::solve::rest::rest;
use laval::solve::stability::row;
use rayon::prelude::*;

#[test]
fn bands_of_one_coordinate() {
    let text = include_str!("../reference/spatial/band_edges_1dof.csv");
    let table = rows(text);
    assert_eq!(table.len(), 36);
    let wrong: Vec<String> = table
        .par_iter()
        .flat_map(|r| {
            let (mu, free) = (number(r[0]), number(r[1]));
            let filled = number(r[2]);
            let mut wrong = Vec::new();
            if !((filled * (1.0 + mu).sqrt() - 1.0).abs() < 1e-11) {
                wrong.push(format!("{r:?}: filled critical speed"));
            }
            for (zeta, column) in [(0.0, 3), (0.01, 4), (0.05, 7)] {
                let system = build(&machine(zeta, 0.0, mu, free));
                let speeds = RangeValue { from: 30.0, to: 400.0, points: Some(371) }.linspace(371);
                let threshold = if zeta > 0.0 { 1.0 } else { 0.0 };
                let found = row(&system, &|w| rest(&system, w), &speeds, threshold, |_| true).unwrap();
                let should: Vec<f64> = r[column].split_whitespace().map(|x| 100.0 * number(x)).collect();
                let edges: Vec<f64> = found.edges.iter().map(|e| e.speed).collect();
                // 16 digits of double roots, 10 of crossings
                let room = if zeta > 0.0 { 3e-10 } else { 1e-11 };
                if edges.len() != should.len() || edges.iter().zip(&should).any(|(a, b)| !((a - b).abs() <= room * b)) {
                    wrong.push(format!("mu {mu}, r0/R {free}, zeta {zeta}: {edges:?} {should:?}"));
                }
                if zeta == 0.0 {
                    // they lie above the filled critical speed
                    if !(found.undamped && found.edges.iter().all(|e| e.double && e.speed > 100.0 * filled)) {
                        wrong.push(format!("mu {mu}, r0/R {free}: {edges:?} below the filled critical speed {filled}"));
                    }
                    continue;
                }
                let best = found.samples.iter().map(|s| s.value.re).chain(found.peaks.iter().map(|p| p.value.re)).fold(0.0, f64::max);
                let largest = 100.0 * number(r[column + 1]);
                // of the table on speeds 0.25 rad/s apart
                if !((best / largest - 1.0).abs() < 2e-3) {
                    wrong.push(format!("mu {mu}, r0/R {free}, zeta {zeta}: largest growth {best} {largest}"));
                }
            }
            wrong
        })
        .collect();
    assert!(wrong.is_empty(), "{} wrong\n{:#?}", wrong.len(), &wrong[..wrong.len().min(10)]);
}
