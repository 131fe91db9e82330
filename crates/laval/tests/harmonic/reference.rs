//! Harmonic balance against the reference tables of the planar machine, every row to its stated digits.

use crate::common;

use common::base::{Base, moduli, request, run, states_at, table_base};
use common::{number, rows};
use laval::model::system::System;
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::response::{Request, Response};
use std::collections::BTreeMap;

const RANGE: (f64, f64) = (25.0, 8000.0);

macro_rules! table {
    ($name:literal) => {
        rows(include_str!(concat!("../reference/planar/", $name, ".csv")))
    };
}

fn computed(base: Base, harmonics: Option<usize>, range: (f64, f64)) -> (System, Response) {
    let request = Request { harmonics, stability: false, ..request(range.0, range.1) };
    (base.builder().build().unwrap(), run(base.builder(), request))
}

/// Folds as (speed, |Z1|, |Z2|, |D|).
fn folds(base: Base, harmonics: Option<usize>) -> Vec<[f64; 4]> {
    let (system, response) = computed(base, harmonics, RANGE);
    let mut balance = Balance::new(&system, response.discretisation, RANGE, None).unwrap();
    response
        .branches
        .iter()
        .flat_map(|b| &b.folds)
        .map(|f| {
            assert!(f.confirmed, "{base:?}: fold at {} not confirmed", f.speed);
            let (z, d, _) = moduli(&Orbit::of(&mut balance, &f.x, f.speed).unwrap());
            [f.speed, z[0], z[1], d]
        })
        .collect()
}

fn close(got: f64, want: f64, tolerance: f64) -> bool {
    (got - want).abs() <= tolerance * want.abs()
}

/// Equal to a number printed with this many significant digits.
fn printed(got: f64, want: f64, digits: i32) -> bool {
    (got - want).abs() <= 0.501 * 10f64.powi(want.abs().log10().floor() as i32 + 1 - digits)
}

/// The fold nearest to a speed, which must be there to `speed` relative.
#[track_caller]
fn fold_at(found: &[[f64; 4]], speed: f64, tolerance: f64) -> [f64; 4] {
    let nearest = found.iter().copied().min_by(|a, b| (a[0] - speed).abs().total_cmp(&(b[0] - speed).abs()));
    let nearest = nearest.unwrap_or_else(|| panic!("no fold at all, one wanted at {speed}"));
    assert!(close(nearest[0], speed, tolerance), "fold at {} wanted at {speed}", nearest[0]);
    nearest
}

#[test]
fn folds_table() {
    let mut seen: BTreeMap<String, Vec<[f64; 4]>> = BTreeMap::new();
    let mut count = 0;
    for r in rows_with_quotes(include_str!("../reference/planar/folds.csv")) {
        count += 1;
        let base = table_base(&r[0], &r[1], "");
        let base = match r[2].as_str() {
            "" => base,
            "M=250" => Base { foundation: 250.0, ..base },
            "chi=600" => Base { chi: 600.0, ..base },
            "c0,c1,c2 doubled" => Base { c0: 2.0 * base.c0, c1: 2.0 * base.c1, c2: 2.0 * base.c2, ..base },
            "c1=8.7e6" => Base { c1: 8.7e6, ..base },
            other => panic!("unknown change {other}"),
        };
        let terms: usize = r[3].parse().unwrap();
        let key = format!("{} {} {} {terms}", r[0], r[1], r[2]);
        let found = seen.entry(key.clone()).or_insert_with(|| folds(base, Some(2 * terms - 1)));
        let fold = fold_at(found, number(&r[4]), 1e-10);
        for (got, cell) in fold[1..].iter().zip(&r[5..]) {
            assert!(close(*got, number(cell), 1e-7), "{key} at {}: {got} wanted {cell}", r[4]);
        }
    }
    assert_eq!(count, 24);
}

/// Cells may be quoted.
fn rows_with_quotes(text: &str) -> Vec<Vec<String>> {
    let line = |l: &str| {
        let (mut cells, mut quoted) = (vec![String::new()], false);
        for ch in l.chars() {
            match ch {
                '"' => quoted = !quoted,
                ',' if !quoted => cells.push(String::new()),
                _ => {
                    if let Some(last) = cells.last_mut() {
                        last.push(ch);
                    }
                }
            }
        }
        cells
    };
    text.lines().filter(|l| !l.starts_with('#')).skip(1).map(line).collect()
}

#[test]
fn folds_converge_with_the_harmonics() {
    let mut seen: BTreeMap<String, Vec<[f64; 4]>> = BTreeMap::new();
    for r in table!("fold_convergence") {
        let terms: usize = r[3].parse().unwrap();
        let found = seen
            .entry(format!("{} {} {terms}", r[0], r[2]))
            .or_insert_with(|| folds(table_base(r[0], "per_axis", r[2]), Some(2 * terms - 1)));
        let fold = fold_at(found, number(r[5]), 1e-10);
        assert!(close(fold[3], number(r[6]), 1e-7), "{r:?}: {}", fold[3]);
    }
}

#[test]
fn folds_of_another_program() {
    for r in table!("folds_cross_checked") {
        let base = Base { e: number(r[1]), ..table_base("1", "per_axis", r[0]) };
        for (harmonics, cell) in [(Some(1), r[3]), (Some(3), r[4]), (Some(13), r[5]), (None, r[7])] {
            // the other program's column ends at 1e-8 rad/s
            let tolerance = if harmonics == Some(13) || harmonics.is_none() { 3e-11 } else { 1e-10 };
            let fold = fold_at(&folds(base, harmonics), number(cell), tolerance);
            if harmonics == Some(13) {
                assert!(close(fold[1], number(r[6]), 1e-7), "{r:?}: {}", fold[1]);
            }
        }
    }
}

#[test]
fn states_of_the_response_table() {
    let mut groups: BTreeMap<[&str; 3], Vec<Vec<&str>>> = BTreeMap::new();
    let text = table!("response");
    for r in text {
        groups.entry([r[0], r[1], r[2]]).or_default().push(r);
    }
    let mut wrong = Vec::new();
    for ([fill, law, chi], rows) in groups {
        // the table's per-axis rows have six harmonics: orders 1 to 11
        let (system, response) = computed(table_base(fill, law, chi), Some(if law == "isotropic" { 1 } else { 11 }), RANGE);
        let mut at: BTreeMap<u64, Vec<_>> = BTreeMap::new();
        for r in rows {
            let speed = number(r[3]);
            let states = at.entry(speed.to_bits()).or_insert_with(|| states_at(&system, &response, RANGE, speed, true));
            let Some(s) = states.iter().find(|s| close(s.z[0], number(r[6]), 1e-8) && close(s.z[1], number(r[7]), 1e-8)) else {
                let have: Vec<_> = states.iter().map(|s| s.z).collect();
                wrong.push(format!("{r:?} has no match in {have:?}"));
                continue;
            };
            if !close(s.deflection, number(r[8]), 1e-8) {
                wrong.push(format!("{r:?} deflection {}", s.deflection));
            }
            let minus3 = number(r[9]);
            if !(minus3.is_nan() || minus3 < 1e-12 || printed(s.minus3, minus3, 6)) {
                wrong.push(format!("{r:?} order -3 {}", s.minus3));
            }
            let growth = number(r[11]);
            // the per-axis column comes from a fixed-step map good to 1e-4 1/s
            let (digits, absolute) = if law == "isotropic" { (5, 1e-9) } else { (4, 1e-4) };
            if !(growth.is_nan() || printed(s.growth, growth, digits) || (s.growth - growth).abs() <= absolute) {
                wrong.push(format!("{r:?} growth {}", s.growth));
            }
            if !growth.is_nan() && (r[10] == "1") != (s.growth < 0.0) {
                wrong.push(format!("{r:?} stability, growth {}", s.growth));
            }
        }
    }
    assert!(wrong.is_empty(), "{} rows:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn filled_orbits_grow_as_tabulated() {
    let (system, response) = computed(table_base("0.667", "isotropic", "42"), None, RANGE);
    for r in table!("filled_stability") {
        let states = states_at(&system, &response, RANGE, number(r[0]), true);
        let s = states.iter().find(|s| close(s.z[0], number(r[2]), 1e-7)).unwrap_or_else(|| panic!("{r:?}"));
        assert!(close(s.growth, number(r[3]), 1e-5), "{r:?}: {}", s.growth);
    }
}

#[test]
fn orbits_of_two_integrators() {
    for r in table!("harmonic_balance_vs_time") {
        let base = table_base(r[0], r[1], if r[2] == "chi=600" { "600" } else { "42" });
        let (system, response) = computed(base, None, RANGE);
        let states = states_at(&system, &response, RANGE, number(r[3]), false);
        let s = states.iter().find(|s| close(s.z[0], number(r[4]), 1e-7)).unwrap_or_else(|| panic!("{r:?}"));
        // trust of the integrations, and the digits they are printed with
        for (k, tolerance, digits) in [(4, 0.0, 10), (6, 2e-9, 10), (8, 1e-8, 8)] {
            for i in 0..2 {
                let want = number(r[k + i]);
                let near = (s.z[i] - want).abs() <= tolerance * want + 0.501 * 10f64.powi(want.log10().floor() as i32 + 1 - digits);
                assert!(near, "{r:?} column {}: {}", k + i, s.z[i]);
            }
        }
    }
}

#[test]
fn superharmonic_of_order_three() {
    let mut groups: BTreeMap<&str, Vec<Vec<&str>>> = BTreeMap::new();
    for r in table!("superharmonic_third") {
        groups.entry(r[0]).or_default().push(r);
    }
    assert_eq!(groups.len(), 3);
    let mut wrong = Vec::new();
    for (factor, rows) in groups {
        let range = (400.0, 2000.0);
        let (system, response) = computed(Base { e: 1e-3 * number(factor), ..Base::default() }, Some(11), range);
        for r in rows {
            let states = states_at(&system, &response, range, number(r[1]), false);
            if !states.iter().any(|s| close(s.z[0], number(r[3]), 1e-6) && close(s.minus3, number(r[4]), 1e-6)) {
                let have: Vec<_> = states.iter().map(|s| (s.z[0], s.minus3)).collect();
                wrong.push(format!("{r:?} has no match in {have:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{} rows:\n{}", wrong.len(), wrong.join("\n"));
}

/// The other way round the machines fold at the same speeds: folds of the tables with the sign of the speed changed.
#[test]
fn folds_under_reversed_rotation() {
    for (e, wanted) in [(5e-5, &[2668.4586212391, 2293.6295156510][..]), (1e-3, &[2685.9163967127][..])] {
        let base = Base { e, ..Base::default() };
        let response = run(base.builder(), request(-RANGE.1, -RANGE.0));
        let folds: Vec<_> = response.branches.iter().flat_map(|b| &b.folds).collect();
        assert_eq!(folds.len(), wanted.len());
        for want in wanted {
            let near = folds.iter().min_by(|a, b| (a.speed + want).abs().total_cmp(&(b.speed + want).abs())).unwrap();
            assert!(close(near.speed, -want, 1e-10), "{} wanted {}", near.speed, -want);
            assert!(near.confirmed);
        }
        let ahead = run(base.builder(), request(RANGE.0, RANGE.1));
        assert!(folds.iter().filter(|f| f.upper).count() == ahead.branches.iter().flat_map(|b| &b.folds).filter(|f| f.upper).count());
        let unstable = |r: &Response| r.branches.iter().flat_map(|b| &b.points).filter(|p| !p.stable()).count() > 0;
        assert_eq!(unstable(&response), unstable(&ahead));
    }
}
