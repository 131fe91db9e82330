//! The physics of random machines against an assembly of its own: modes, response, critical speeds, stability and motion in time, to eight digits.
//!
//! `LAVAL_FUZZ=1` is the long form, four times as many machines, `LAVAL_FUZZ=10` ten times that; `LAVAL_FUZZ_CASE=123` runs one and prints its file.

mod assembly;
mod compare;
mod machine;
mod matrix;
mod random;
mod tables;
mod walk;

use machine::Machine;
use random::Random;
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

const MACHINES: u64 = 400;
/// Machines beyond those in which something was wrong once: a memory beside its pole, an equilibrium in its rounding, a matrix singular to the last digit,
/// two points of one body whose heights agree in four digits.
const ALSO: [u64; 4] = [792, 1296, 1608, 1815];

type Check = fn(&Machine, &mut Random) -> Result<(), String>;
/// Name, one in how many machines, whether it needs a machine in which everything is damped.
const CHECKS: [(&str, u64, bool, Check); 6] = [
    ("modes", 1, false, compare::modes),
    ("modes and response of a machine that turns the other way", 9, true, compare::backwards),
    ("forced_response", 4, true, |m, _| compare::response(m)),
    ("critical_speeds", 12, true, |m, _| compare::critical_speeds(m)),
    ("stability_map", 10, true, |m, _| compare::stability_map(m)),
    ("transient", 7, false, compare::transient),
];

fn variable<T: std::str::FromStr>(name: &str) -> Option<T> {
    std::env::var(name).ok()?.parse().ok()
}

/// Everything that is wrong with a machine.
fn wrong(case: u64, all: bool) -> Vec<(&'static str, String)> {
    let mut r = Random::new(case);
    let m = Machine::random(&mut r);
    let due = CHECKS.iter().filter(|c| (all || case.is_multiple_of(c.1)) && (m.damped || !c.2));
    due.filter_map(|c| Some((c.0, (c.3)(&m, &mut r).err()?))).collect()
}

#[test]
fn random_machines_obey_their_matrices() {
    if let Some(case) = variable("LAVAL_FUZZ_CASE") {
        println!("{}\n{:#?}", Machine::random(&mut Random::new(case)).file(), wrong(case, true));
        return;
    }
    let count = (MACHINES as f64 * variable::<f64>("LAVAL_FUZZ").unwrap_or(0.25)) as u64;
    let also: Vec<u64> = ALSO.into_iter().filter(|case| *case >= count).collect();
    let (next, found) = (AtomicU64::new(0), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(2, |n| n.get()) {
            scope.spawn(|| {
                loop {
                    let turn = next.fetch_add(1, Ordering::Relaxed);
                    let beyond = turn.checked_sub(count).map(|k| also.get(k as usize).copied());
                    let Some(case) = beyond.unwrap_or(Some(turn)) else { return };
                    let w = wrong(case, false);
                    found.lock().unwrap_or_else(|e| e.into_inner()).extend(w.into_iter().map(|(check, why)| (case, check, why)));
                }
            });
        }
    });
    let mut found = found.into_inner().unwrap_or_else(|e| e.into_inner());
    found.sort();
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    for (case, check, why) in &found {
        let seen = kinds.entry(check).or_default();
        *seen += 1;
        if *seen <= 5 {
            eprintln!("machine {case}, {check}: {why}");
        }
    }
    assert!(found.is_empty(), "wrong of {count} machines: {kinds:?}");
}
