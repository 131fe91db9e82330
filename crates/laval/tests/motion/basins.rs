//! Basins of attraction against harmonic balance, a symmetry, and machines that never settle.

use crate::common;

use common::base::{request, states_at};
use laval::diagnostic::Diagnostics;
use laval::file::{Loaded, canonical, load};
use laval::model::builder::Builder;
use laval::model::system::System;
use laval::outcome::{Data, End, Finding, Outcome};
use laval::parts::disc::{Disc, DiscParams};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::response::respond;
use laval::store::Keep;
use laval::study::{Context, Progress};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// A rigid rotor in a cubic bearing of the same stiffness in all directions: two motions between 2600 and 3200 rad/s.
fn round(damping: f64) -> String {
    machine(damping, "0 deg").replace("per_axis", "isotropic")
}

/// The same with a law for each axis: x and y are two oscillators that know nothing of each other.
fn machine(damping: f64, phase: &str) -> String {
    format!(
        r#"
[machine]
name = "rigid rotor"
[[part]]
kind = "disc"
name = "drum"
mass = 2.4
eccentricity = 1e-3
eccentricity_phase = "{phase}"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "ground"]
law = "per_axis"
stiffness = 1.1e7
cubic_stiffness = 8.7e10
[[part]]
kind = "damper"
name = "air"
between = ["drum", "ground"]
damping = {damping}
"#
    )
}

const PLANE: &str =
    "from = { \"drum.x\" = \"-12 mm\", \"drum.y\" = \"-12 mm\" }\nto = { \"drum.x\" = \"12 mm\", \"drum.y\" = \"12 mm\" }\n";

fn with(machine: &str, study: &str) -> Result<Loaded, Diagnostics> {
    load(&format!("{machine}\n[[study]]\nkind = \"basins\"\n{study}"))
}

fn loaded(machine: &str, study: &str) -> Loaded {
    with(machine, study).unwrap_or_else(|d| panic!("{d:?}"))
}

fn run_in(l: &Loaded, context: &Context) -> Outcome {
    l.studies[0].study.run(&l.system, context).unwrap_or_else(|d| panic!("{d:?}"))
}

fn run(machine: &str, study: &str) -> Outcome {
    run_in(&loaded(machine, study), &Context::quiet("b"))
}

fn numbers(o: &Outcome, table: &str, column: &str) -> Vec<f64> {
    let t = o.find_table(table).unwrap();
    (0..t.rows()).map(|r| t.column(column).unwrap_or_else(|| panic!("no {column}")).number(r).unwrap()).collect()
}

fn texts(o: &Outcome, table: &str, column: &str) -> Vec<String> {
    match &o.find_table(table).unwrap().column(column).unwrap().data {
        Data::Text(v) => v.clone(),
        _ => panic!("{column} is no text"),
    }
}

fn finding<'a>(o: &'a Outcome, id: &str) -> &'a Finding {
    o.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("no {id} among {:?}", o.findings))
}

/// Largest displacements of the stable motions that harmonic balance finds at a speed, rising.
fn stable(system: &System, speed: f64) -> Vec<f64> {
    static NEVER: AtomicBool = AtomicBool::new(false);
    let range = (1500.0, 4500.0);
    let response = respond(system, &request(range.0, range.1), &NEVER, &|_| {}).unwrap();
    let mut balance = Balance::new(system, response.discretisation, range, None).unwrap();
    let states = states_at(system, &response, range, speed, true).into_iter().filter(|f| f.growth < 0.0);
    let mut peaks: Vec<f64> = states
        .map(|f| {
            let orbit = Orbit::of(&mut balance, &f.x, speed).unwrap();
            let (mut q, mut v, mut a) = (vec![0.0; 2], vec![0.0; 2], vec![0.0; 2]);
            let mut at = |i: u32| {
                orbit.at(f64::from(i) * std::f64::consts::TAU / 20_000.0, &mut q, &mut v, &mut a, &mut []);
                q[0].hypot(q[1])
            };
            (0..20_000).map(&mut at).fold(0.0, f64::max)
        })
        .collect();
    peaks.sort_by(f64::total_cmp);
    peaks
}

/// Between the folds there are two attractors, outside of them one; each is the motion of harmonic balance.
#[test]
fn attractors_are_the_stable_motions_of_harmonic_balance() {
    for (speed, count) in [(2200, 1), (2800, 2), (3600, 1)] {
        for settling in if count == 2 { &["decay", "shooting"][..] } else { &["decay"] } {
            let l = loaded(&round(600.0), &format!("speed = {speed}\npoints = 9\nsettling = \"{settling}\"\n{PLANE}"));
            let o = run_in(&l, &Context::quiet("b"));
            let known = stable(&l.system, f64::from(speed));
            let peaks = numbers(&o, "attractors", "amplitude.drum");
            assert_eq!((o.end, known.len(), peaks.len()), (End::Reached, count, count), "{speed} {settling}: {peaks:?} {known:?}");
            for (found, known) in peaks.iter().zip(&known) {
                assert!((found - known).abs() < 1e-5 * known, "{speed} {settling}: {found} {known}");
            }
            assert_eq!(finding(&o, "attractors").value, Some(count as f64));
            // every cell is counted once
            let (cells, shares) = (numbers(&o, "attractors", "cells"), numbers(&o, "attractors", "share"));
            assert_eq!(cells.iter().sum::<f64>(), 81.0);
            for ((n, p), error) in cells.iter().zip(&shares).zip(numbers(&o, "attractors", "share_error")) {
                assert!((p - n / 81.0).abs() < 1e-15 && (error - (p * (1.0 - p) / 81.0).sqrt()).abs() < 1e-15);
            }
            if *settling == "shooting" {
                let modulus = numbers(&o, "attractors", "multiplier");
                assert!(modulus.iter().all(|m| m.is_nan() || *m < 1.0), "{modulus:?}");
            }
        }
    }
}

/// The state of an attractor, given as the start of another grid, ends in it; and the smallest disturbance is that of the table.
#[test]
fn disturbances_are_measured_from_the_undisturbed_start() {
    let o = run(&round(600.0), &format!("speed = 2800\npoints = 9\n{PLANE}"));
    let (attractor, state, value) =
        (numbers(&o, "poincare", "attractor"), texts(&o, "poincare", "state"), numbers(&o, "poincare", "value"));
    let heights = numbers(&o, "attractors", "amplitude.drum");
    assert_eq!(heights.len(), 2);
    let mut left = 0;
    for (k, height) in [1.0, 2.0].into_iter().zip(heights) {
        let own: Vec<String> =
            (0..value.len()).filter(|&i| attractor[i] == k).map(|i| format!("\"{}\" = {:e}", state[i], value[i])).collect();
        assert_eq!(own.len(), 4);
        let o = run(&round(600.0), &format!("speed = 2800\npoints = 9\n{PLANE}initial = {{ {} }}", own.join(", ")));
        // numbers are those of this grid, which begins with other rates
        let end = texts(&o, "undisturbed", "end")[0].strip_prefix("attractor ").unwrap().parse::<usize>().unwrap();
        assert!((numbers(&o, "attractors", "amplitude.drum")[end - 1] - height).abs() < 1e-5 * height, "{k}");
        let start = (numbers(&o, "undisturbed", "x")[0], numbers(&o, "undisturbed", "y")[0]);
        let (x, y, ends) = (numbers(&o, "cells", "x"), numbers(&o, "cells", "y"), numbers(&o, "cells", "attractor"));
        let others = (0..x.len()).filter(|&i| ends[i] != end as f64).map(|i| (x[i] - start.0).hypot(y[i] - start.1));
        let nearest = others.fold(f64::INFINITY, f64::min);
        if nearest.is_finite() {
            left += 1;
            let reported = finding(&o, "smallest_disturbance");
            assert!((reported.value.unwrap() - nearest).abs() < 1e-12, "{reported:?} {nearest}");
            assert!(reported.evidence.iter().any(|e| e.what == "farthest nearer cell that does not" && e.value < nearest));
        } else {
            assert!(finding(&o, "undisturbed").sentence().contains("every cell of the grid"));
        }
    }
    assert!(left > 0);
}

/// A quarter turn of start and unbalance turns the map: (x, y) becomes (-y, x).
#[test]
fn the_map_turns_with_the_unbalance() {
    let study = format!("speed = 2800\npoints = 11\n{PLANE}");
    let (o, turned) = (run(&machine(600.0, "30 deg"), &study), run(&machine(600.0, "120 deg"), &study));
    let read = |o: &Outcome| (numbers(o, "cells", "attractor"), numbers(o, "cells", "amplitude.drum"));
    let ((a, peak), (b, other)) = (read(&o), read(&turned));
    assert!(a.contains(&1.0) && a.contains(&2.0));
    // attractors that are mirror images have one amplitude: which comes first says nothing
    let mut names = std::collections::BTreeMap::new();
    for i in 0..11 {
        for j in 0..11 {
            let (from, to) = (j * 11 + i, i * 11 + (10 - j));
            assert_eq!(*names.entry(a[from] as usize).or_insert(b[to]), b[to], "{i} {j}");
            assert!((peak[from] - other[to]).abs() < 1e-5 * peak[from], "{i} {j}");
        }
    }
    assert_eq!(names.len(), numbers(&turned, "attractors", "attractor").len());
    // and not by itself
    assert_ne!(a, b);
}

/// Oscillators that know nothing of each other, of two motions each, have four together, and the map is the product of theirs.
#[test]
fn basins_of_independent_axes_are_products() {
    let o = run(&machine(600.0, "0 deg"), &format!("speed = 2800\npoints = 11\n{PLANE}"));
    assert_eq!(numbers(&o, "attractors", "attractor").len(), 4);
    let a = numbers(&o, "cells", "attractor");
    let at = |i: usize, j: usize| a[j * 11 + i] as usize;
    for i in 0..11 {
        for k in 0..11 {
            // two columns agree everywhere or nowhere, and so do two rows
            let (column, row) = (|j: usize| at(i, j) == at(k, j), |j: usize| at(j, i) == at(j, k));
            assert!((0..11).all(|j| column(j) == column(0) && row(j) == row(0)), "{i} {k}");
        }
    }
}

struct Stop<'a>(u64, &'a AtomicBool);

impl Progress for Stop<'_> {
    fn report(&self, done: u64, _: u64) {
        if done >= self.0 {
            self.1.store(true, Ordering::Relaxed);
        }
    }
}

#[test]
fn neither_threads_nor_interruptions_change_anything() {
    let l = loaded(&machine(600.0, "0 deg"), &format!("speed = 2800\npoints = 14\ntolerance = 1e-4\n{PLANE}"));
    let threads = |n: usize| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
    let (one, two) = (threads(1).install(|| run_in(&l, &Context::quiet("s"))), threads(2).install(|| run_in(&l, &Context::quiet("s"))));
    // NaN is not equal to itself
    assert_eq!(format!("{one:?}"), format!("{two:?}"));
    let folder = std::env::temp_dir().join(format!("laval-basins-{}", std::process::id()));
    let keep = |fresh| Keep { folder: folder.clone(), input: canonical(&l.spec, "basins"), fresh, work: laval::store::Work::Missing };
    let until = |rows: u64, fresh: bool| {
        let (stop, keep) = (laval::study::Cancel::default(), keep(fresh));
        run_in(&l, &Context { cancel: &stop, progress: &Stop(rows, &stop), keep: Some(&keep), ..Context::quiet("s") })
    };
    let first = until(100, true);
    assert_eq!(first.end, End::Cancelled);
    let reported = finding(&first, "incomplete");
    assert!(reported.value.unwrap() >= 64.0 && first.find_table("cells").unwrap().rows() < 196);
    assert!(!first.findings.iter().any(|f| f.id == "smallest_disturbance"));
    assert_eq!(format!("{:?}", until(u64::MAX, false)), format!("{one:?}"));
    std::fs::remove_dir_all(folder).unwrap();
    let limit = one.work["steps"] / 2;
    let o = run_in(&l, &Context { work_limit: limit, ..Context::quiet("s") });
    assert!(o.end == End::WorkLimit && o.work["steps"] <= limit);
    let stop = laval::study::Cancel::new(true);
    let o = run_in(&l, &Context { cancel: &stop, ..Context::quiet("s") });
    assert_eq!((o.end, o.find_table("cells").unwrap().rows()), (End::Cancelled, 0));
}

/// What a study says while it runs.
#[derive(Default)]
struct Heard {
    jobs: Mutex<Vec<String>>,
    /// Largest share of rows under way, and rows done when it was said.
    parts: Mutex<Vec<f64>>,
}

impl Progress for Heard {
    fn report(&self, _: u64, _: u64) {}
    fn part(&self, rows: f64) {
        self.parts.lock().unwrap().push(rows);
    }
    fn job(&self, text: &laval::text::Text) {
        self.jobs.lock().unwrap().push(text.to_string());
    }
}

/// The instability of a machine is reported first; its motions are followed up to their bound, and reported as unbounded.
#[test]
fn an_unstable_machine_is_reported_at_once() {
    // cross-coupling against little damping: growth (sqrt(k/m) given) about kxy/(2 m w) - d/(2 m)
    let wild = format!(
        "{}[[part]]\nkind = \"bearing_linear\"\nname = \"seal\"\nbetween = [\"drum\", \"ground\"]\nkxy = 1e6\nkyx = -1e6\n",
        round(100.0).replace("cubic_stiffness = 8.7e10", "cubic_stiffness = 0")
    );
    let heard = Heard::default();
    let l = loaded(&wild, &format!("speed = 2800\npoints = 3\n{PLANE}"));
    let o = run_in(&l, &Context { progress: &heard, ..Context::quiet("b") });
    let jobs = heard.jobs.lock().unwrap();
    assert!(jobs.len() == 1 && jobs[0].contains("10 motions to follow (9 cells and the undisturbed start)"), "{jobs:?}");
    let (k, m): (f64, f64) = (1.1e7, 2.4);
    let growth = 1e6 / (2.0 * m * (k / m).sqrt()) - 100.0 / (2.0 * m);
    let reported: f64 = jobs[0].split("grows by ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((reported - growth).abs() < 0.02 * growth, "{reported} {growth}");
    assert_eq!(finding(&o, "failed_motions").value, Some(9.0));
    assert!(finding(&o, "failed_motions").sentence().contains("grows without bound"));
    assert!(finding(&o, "undisturbed").sentence().contains("the motion grows without bound."));
    let reported = finding(&o, "no_decay").number("growth").unwrap();
    assert!((reported - growth).abs() < 0.02 * growth, "{reported} {growth}");
    // 1 mm grows to 1 km in so many turns
    let turns = 1e6f64.ln() / growth * 2800.0 / std::f64::consts::TAU;
    assert!(numbers(&o, "cells", "periods").iter().all(|p| *p < 2.0 * turns + 40.0), "{turns}");
}

/// A leg of many periods says how far it is, and what is said changes nothing.
#[test]
fn progress_is_reported_within_a_leg() {
    let heard = Heard::default();
    let l = loaded(&round(2.0), &format!("speed = 3600\npoints = 2\nmost_periods = 900\n{PLANE}"));
    let o = run_in(&l, &Context { progress: &heard, ..Context::quiet("b") });
    assert_eq!(format!("{o:?}"), format!("{:?}", run_in(&l, &Context::quiet("b"))));
    let parts = heard.parts.lock().unwrap();
    // five motions; a word every twenty periods of some nine hundred
    let between = parts.iter().filter(|p| **p > 0.1 && **p < 4.9).count();
    assert!(between > 100, "{between} of {}", parts.len());
}

/// Without damping nothing settles, and nothing is called an attractor.
#[test]
fn what_does_not_settle_is_no_attractor() {
    let o = run(&machine(0.0, "0 deg"), &format!("speed = 2800\npoints = 4\nmost_periods = 200\n{PLANE}"));
    assert_eq!(finding(&o, "attractors").value, Some(0.0));
    assert_eq!(finding(&o, "not_settled").value, Some(16.0));
    finding(&o, "no_decay");
    assert!(numbers(&o, "cells", "attractor").iter().all(|a| *a == 0.0));
    assert_eq!(o.find_table("attractors").unwrap().rows(), 0);
}

/// A machine that flies apart is counted.
#[test]
fn failed_cells_are_values() {
    // softening: beyond sqrt(k/c) = 11 mm the bearing pushes outwards
    let soft = machine(600.0, "0 deg")
        .replace("cubic_stiffness = 8.7e10", "cubic_stiffness = -8.7e10")
        .replace("eccentricity = 1e-3", "eccentricity = 1e-6");
    let o = run(&soft, &format!("speed = 800\npoints = 6\ntolerance = 1e-3\n{}", PLANE.replace("12 mm", "20 mm")));
    let ends = texts(&o, "cells", "end");
    let failed = ends.iter().filter(|e| *e == "failed").count();
    let reported: f64 = o.findings.iter().filter(|f| f.id == "failed_motions").filter_map(|f| f.value).sum();
    assert!(failed > 0 && failed < 36 && reported == failed as f64, "{failed} {reported}");
    assert_eq!(numbers(&o, "attractors", "cells").iter().sum::<f64>() + failed as f64, 36.0);
}

#[test]
fn mistakes_are_reported_where_they_stand() {
    let both = |from: &str, to: &str| format!("speed = 2800\nfrom = {{ {from} }}\nto = {{ {to} }}\n");
    let fine = both("\"drum.x\" = 0, \"drum.y'\" = 0", "\"drum.x\" = \"1 mm\", \"drum.y'\" = \"2 m/s\"");
    for (study, code, place) in [
        (fine.replace("2800", "0"), "basins.speed", "0"),
        (fine.replace("speed = 2800", ""), "study.speed", "study"),
        (both("\"drum.x\" = 0", "\"drum.x\" = 1, \"drum.y\" = 1"), "basins.axes", "drum.x"),
        (both("\"drum.x\" = 0, \"drum.y\" = 0", "\"drum.x\" = 1, \"drum.x'\" = 1"), "basins.axes", "drum.x'"),
        (fine.replacen("drum.y'", "drum.w", 1), "coordinate.unknown", "drum.w"),
        (fine.replace("2 m/s", "2 mm"), "unit.dimension", "drum.y'"),
        (fine.replace("1 mm", "1 kg"), "unit.dimension", "drum.x"),
        (fine.replace("1 mm", "-1 mm"), "study.range", "drum.x"),
        (format!("{fine}points = 2.5"), "basins.points", "2.5"),
        (format!("{fine}points = 600"), "study.range", "600"),
        (format!("{fine}points = {{ \"drum.y\" = 5 }}"), "basins.points", "drum.y"),
        (format!("{fine}initial = {{ \"drum.x\" = \"1 s\" }}"), "unit.dimension", "drum.x"),
    ] {
        let text = format!("{}\n[[study]]\nkind = \"basins\"\n{study}", machine(600.0, "0 deg"));
        let reported = load(&text).map(drop).unwrap_err();
        let found = reported.0.iter().find(|d| d.code == code).unwrap_or_else(|| panic!("{study}: {reported:?}"));
        let span = found.span.clone().unwrap();
        assert!(text[span].contains(place), "{study}: {found:?}");
        assert_eq!(reported.0.len(), 1, "{study}: {reported:?}");
    }
    // the order in which the two are written does not matter
    let swapped = both("\"drum.y'\" = 0, \"drum.x\" = 0", "\"drum.x\" = \"1 mm\", \"drum.y'\" = \"2 m/s\"");
    let points = "points = { \"drum.y'\" = 3, \"drum.x\" = 2 }\ntolerance = 1e-2\n";
    let (a, b) = (run(&machine(600.0, "0 deg"), &format!("{fine}{points}")), run(&machine(600.0, "0 deg"), &format!("{swapped}{points}")));
    assert_eq!(format!("{a:?}"), format!("{b:?}"));
    assert_eq!(numbers(&a, "cells", "x"), [0.0, 1e-3, 0.0, 1e-3, 0.0, 1e-3]);
    let l = loaded(&machine(600.0, "0 deg"), &fine);
    let disc = DiscParams { polar_inertia: 0.1, ..DiscParams::new(2.4) };
    let free = Builder::new("free").part("drum", Disc::planar(), disc).free_spin().build().unwrap();
    assert_eq!(l.studies[0].study.admit(&free).unwrap_err().code, "basins.free_spin");
}
