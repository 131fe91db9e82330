//! Sweeps against folds, harmonic balance, linear response and closed forms of exponents.

use crate::common;

use common::base::{request, run as respond, states_at};
use common::{Base, number, rows};
use laval::diagnostic::Diagnostics;
use laval::file::{Loaded, canonical, load};
use laval::model::builder::Builder;
use laval::outcome::{Data, End, Outcome, Table};
use laval::parts::disc::{Disc, DiscParams};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::store::Keep;
use laval::study::{Cancel, Context, Progress, forced_response};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// The base machine of the reference tables.
fn machine(chi: f64, cubic: f64) -> String {
    format!(
        r#"
[machine]
name = "base set"
[[part]]
kind = "disc"
name = "drum"
mass = 2.4
eccentricity = 1e-3
[[part]]
kind = "foundation"
name = "base"
mass = 25
stiffness = 3.26e5
damping = 6.59
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "base"]
law = "per_axis"
stiffness = 1.1e7
cubic_stiffness = {cubic}
[[part]]
kind = "damper"
name = "air"
between = ["drum", "ground"]
damping = {chi}
"#
    )
}

/// Two oscillators of Ueda, x and y a quarter turn apart: x'' + 0.05 x' + x^3 = 7.5 cos t.
const UEDA: &str = r#"
[machine]
name = "Ueda"
[[part]]
kind = "disc"
name = "disc"
mass = 1
eccentricity = 0.5
unbalance = 7
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["disc", "ground"]
law = "per_axis"
stiffness = 0
cubic_stiffness = 1
[[part]]
kind = "damper"
name = "air"
between = ["disc", "ground"]
damping = 0.05
"#;

/// A rotor on a linear shaft: every mode decays with c/(2 m) = 10 1/s.
const LINEAR: &str = r#"
[machine]
name = "Jeffcott rotor"
[[part]]
kind = "disc"
name = "disc"
mass = 2
eccentricity = "10 um"
[[part]]
kind = "shaft_lumped"
name = "shaft"
between = ["disc", "ground"]
stiffness = 2e5
[[part]]
kind = "damper"
name = "air"
between = ["disc", "ground"]
damping = 40
"#;

/// The same with a light ring on a strong damper: one of its modes dies out at 6e5 1/s.
const FAST: &str = r#"
[[part]]
kind = "disc"
name = "ring"
mass = 1e-3
[[part]]
kind = "damper"
name = "squeeze film"
between = ["ring", "disc"]
damping = 600
[[part]]
kind = "shaft_lumped"
name = "spring"
between = ["ring", "ground"]
stiffness = 1e4
"#;

fn with(machine: &str, study: &str) -> Result<Loaded, Diagnostics> {
    load(&format!("{machine}\n[[study]]\nkind = \"sweep\"\n{study}"))
}

fn loaded(machine: &str, study: &str) -> Loaded {
    with(machine, study).unwrap_or_else(|d| panic!("{d:?}"))
}

fn run(machine: &str, study: &str) -> Outcome {
    let l = loaded(machine, study);
    l.studies[0].study.run(&l.system, &Context::quiet("s")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn table<'a>(o: &'a Outcome, name: &str) -> &'a Table {
    o.find_table(name).unwrap()
}

fn numbers(o: &Outcome, t: &str, column: &str) -> Vec<f64> {
    let t = table(o, t);
    (0..t.rows()).map(|r| t.column(column).unwrap_or_else(|| panic!("no {column}")).number(r).unwrap_or(f64::NAN)).collect()
}

fn texts(o: &Outcome, t: &str, column: &str) -> Vec<String> {
    match &table(o, t).column(column).unwrap().data {
        Data::Text(v) => v.clone(),
        _ => panic!("{column} is no text"),
    }
}

/// State at the end of a way, for `initial`.
fn initial(o: &Outcome, way: &str) -> String {
    let (start, state, value) = (texts(o, "end_states", "start"), texts(o, "end_states", "state"), numbers(o, "end_states", "value"));
    let own: Vec<String> = (0..start.len()).filter(|&i| start[i] == way).map(|i| format!("\"{}\" = {:e}", state[i], value[i])).collect();
    format!("initial = {{ {} }}", own.join(", "))
}

/// Slow sweeps jump within one step of the reference's jumps and of the folds of harmonic balance, and not elsewhere.
#[test]
fn slow_sweeps_jump_at_the_folds() {
    let text = include_str!("../reference/planar/sweep_jumps.csv");
    let reference = |change: &str, direction: &str| {
        let row = rows(text).into_iter().find(|r| r[0] == "per_axis" && r[1] == change && r[2] == direction).unwrap();
        (number(row[3]), number(row[5]), number(row[6]))
    };
    let m = machine(600.0, 8.7e10);
    let coarse = run(&m, "speed = { from = 2540, to = 3560, points = 52 }\nsettling = \"shooting\"");
    let (up, down) = ((3469.868, reference("chi=600", "up")), (2652.911, reference("chi=600", "down")));
    let jumps = |o: &Outcome| {
        let (a, b) = (numbers(o, "jumps", "before"), numbers(o, "jumps", "after"));
        texts(o, "jumps", "start").into_iter().zip(a.into_iter().zip(b)).collect::<Vec<_>>()
    };
    assert_eq!(jumps(&coarse), [("up".to_string(), (3460.0, 3480.0)), ("down".to_string(), (2660.0, 2640.0))]);
    let hysteresis = coarse.findings.iter().find(|f| f.id == "hysteresis").unwrap();
    // from fold to fold, each to a 64th of a step
    let folds = up.0 - down.0;
    assert!((hysteresis.value.unwrap() - folds).abs() < 2.0 * 20.0 / 64.0, "{hysteresis:?} {folds}");
    // from the state before the jump, in the steps of the reference
    for (way, (fold, (step, before, after))) in [("up", up), ("down", down)] {
        let sign = (after - before).signum();
        let (a, b) = (before - sign * 2.0 * step, after + sign * step);
        let range = if way == "up" { format!("from = 2900, to = {a}, points = 40") } else { format!("from = {a}, to = 2900, points = 30") };
        let lead = run(&m, &format!("speed = {{ {range} }}\nstart = \"{way}\"\nsettling = \"shooting\"\n{}", initial_of(&m, way)));
        let fine = run(
            &m,
            &format!("speed = {{ from = {}, to = {}, points = 5 }}\nstart = \"{way}\"\n{}", a.min(b), a.max(b), initial(&lead, way)),
        );
        let found = jumps(&fine);
        assert_eq!(found.len(), 1);
        let (_, (low, high)) = &found[0];
        assert!((low - before).abs() <= step * 1.001 && (high - after).abs() <= step * 1.001, "{low} {high} {before} {after}");
        assert!((fold - low.min(*high)).abs() <= step * 1.001 && (fold - low.max(*high)).abs() <= step * 1.001);
    }
}

/// A state on the branch that a way follows, at 2900 rad/s.
fn initial_of(m: &str, way: &str) -> String {
    let (from, to) = if way == "up" { (2540, 2900) } else { (2900, 3540) };
    let o = run(m, &format!("speed = {{ from = {from}, to = {to}, points = 17 }}\nstart = \"{way}\"\nsettling = \"shooting\""));
    initial(&o, way)
}

/// Peak amplitudes are those of stable periodic motions by harmonic balance.
#[test]
fn peaks_are_those_of_harmonic_balance() {
    let m = machine(42.0, 8.7e10);
    let range = (1500.0, 4000.0);
    let response = respond(Base::default().builder(), request(range.0, range.1));
    for (settling, start) in [("decay", "rest"), ("shooting", "all")] {
        let study =
            format!("speed = {{ from = 1600, to = 3600, points = 5 }}\nstart = \"{start}\"\ntolerance = 1e-8\nsettling = \"{settling}\"");
        let l = loaded(&m, &study);
        let o = l.studies[0].study.run(&l.system, &Context::quiet("s")).unwrap();
        assert!(o.end == End::Reached && texts(&o, "sweep", "motion").iter().all(|m| m == "periodic"));
        let mut balance = Balance::new(&l.system, response.discretisation, range, None).unwrap();
        for (speed, peak) in numbers(&o, "sweep", "speed").into_iter().zip(numbers(&o, "sweep", "amplitude.drum")) {
            let stable = states_at(&l.system, &response, range, speed, true).into_iter().filter(|f| f.growth < 0.0);
            let peaks: Vec<f64> = stable.map(|f| farthest(&Orbit::of(&mut balance, &f.x, speed).unwrap(), &l.system)).collect();
            assert!(peaks.iter().any(|p| (p - peak).abs() < 1e-6 * peak), "{speed} {peak} {peaks:?}");
        }
    }
}

/// Largest displacement of the first body on an orbit.
fn farthest(orbit: &Orbit, system: &laval::model::system::System) -> f64 {
    let (n, m) = (system.n(), system.m());
    let at = |tau: f64| {
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
        q[0].hypot(q[1])
    };
    (0..40_000).map(|i| at(f64::from(i) * std::f64::consts::TAU / 40_000.0)).fold(0.0, f64::max)
}

/// A linear machine from rest, followed, and shot at: the response of the transfer function.
#[test]
fn linear_machines_settle_on_the_linear_response() {
    let m = machine(42.0, 0.0)
        .replace("bearing_cubic", "bearing_linear")
        .replace("law = \"per_axis\"\n", "")
        .replace("cubic_stiffness = 0\n", "");
    for settling in ["decay", "shooting"] {
        let study =
            format!("speed = {{ from = 300, to = 4300, points = 9 }}\nstart = \"all\"\ntolerance = 1e-8\nsettling = \"{settling}\"");
        let l = loaded(&m, &study);
        let o = l.studies[0].study.run(&l.system, &Context::quiet("s")).unwrap();
        let speeds = numbers(&o, "sweep", "speed");
        for (b, name) in [(0, "drum"), (2, "base")] {
            let (peak, order, rms) = (
                numbers(&o, "sweep", &format!("amplitude.{name}")),
                numbers(&o, "sweep", &format!("order_1.{name}")),
                numbers(&o, "sweep", &format!("rms.{name}")),
            );
            for (i, w) in speeds.iter().enumerate() {
                let known = forced_response::at_speed(&l.system, *w).unwrap().unwrap().major(b);
                for x in [peak[i], order[i], rms[i]] {
                    assert!((x - known).abs() < 1e-6 * known, "{settling} {name} {w} {x} {known}");
                }
            }
        }
        if settling == "shooting" {
            let shot = numbers(&o, "sweep", "multiplier");
            assert!(shot.iter().filter(|x| x.is_finite()).count() >= 9);
            for ((mu, rate), w) in shot.iter().zip(numbers(&o, "sweep", "decay")).zip(&speeds).filter(|x| x.0.0.is_finite()) {
                let known = (-rate * std::f64::consts::TAU / w).exp();
                assert!((mu - known).abs() < 1e-5, "{w} {mu} {known}");
            }
        }
    }
}

#[test]
fn exponents_of_linear_motion_and_of_chaos() {
    let o = run(LINEAR, "speed = { from = 200, to = 800, points = 4 }\nstart = \"rest\"\nlyapunov = true\nlyapunov_periods = 400");
    for (x, halves) in numbers(&o, "sweep", "lyapunov").into_iter().zip(numbers(&o, "sweep", "lyapunov_halves")) {
        assert!((x + 10.0).abs() < 1e-4 && halves < 0.01, "{x}");
    }
    assert!(o.findings.iter().any(|f| f.id == "no_chaos"));
    // 0.10 1/s is the largest exponent known of Ueda's attractor
    let o = run(
        UEDA,
        "speed = { from = 1, to = 1.0001, points = 2 }\nstart = \"rest\"\nlyapunov = true\nlyapunov_periods = 4000\nmost_periods = 300",
    );
    for x in numbers(&o, "sweep", "lyapunov") {
        assert!((0.07..0.13).contains(&x), "{x}");
    }
    assert!(texts(&o, "sweep", "motion").iter().all(|m| m == "not periodic"));
    assert!(o.findings.iter().any(|f| f.id == "chaos"));
    assert_eq!(table(&o, "poincare").rows(), 64);
}

/// A way without a jump is one whose motions are all periodic: of motions that do not repeat it is not
/// claimed, nor of a way that was not gone.
#[test]
fn only_periodic_motions_are_without_a_jump() {
    let has = |o: &Outcome, id: &str| o.findings.iter().any(|f| f.id == id);
    let o = run(LINEAR, "speed = { from = 200, to = 800, points = 4 }\nstart = \"up\"");
    assert!(has(&o, "no_jump_up") && !has(&o, "no_jump_down") && !has(&o, "jump_up"), "{:?}", o.findings);
    let o = run(UEDA, "speed = { from = 1, to = 1.0002, points = 3 }\nstart = \"up\"\nmost_periods = 300");
    assert!(texts(&o, "sweep", "motion").iter().all(|m| m == "not periodic"));
    assert!(!has(&o, "no_jump_up"), "{:?}", o.findings);
}

#[test]
fn bits_do_not_depend_on_threads() {
    let l = loaded(
        &machine(600.0, 8.7e10),
        "speed = { from = 2500, to = 3000, points = 20 }\nstart = \"all\"\ntolerance = 1e-3\nwaterfall = \"drum\"",
    );
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let o = pool.install(|| l.studies[0].study.run(&l.system, &Context::quiet("s")).unwrap());
        format!("{o:?}")
    };
    assert!(with(1) == with(2));
}

/// Stops after so many reports.
struct Stop<'a> {
    after: u64,
    seen: AtomicU64,
    stop: &'a AtomicBool,
}

impl Progress for Stop<'_> {
    fn report(&self, done: u64, _: u64) {
        self.seen.store(done, Ordering::Relaxed);
        if done >= self.after {
            self.stop.store(true, Ordering::Relaxed);
        }
    }
}

#[test]
fn a_stopped_sweep_goes_on_to_the_same_files() {
    let study = "speed = { from = 2500, to = 3000, points = 30 }\nstart = \"up_and_down\"\ntolerance = 1e-3";
    let l = loaded(&machine(600.0, 8.7e10), study);
    let folder = |name: &str| std::env::temp_dir().join(format!("laval-sweep-{}-{name}", std::process::id()));
    let keep =
        |name: &str| Keep { folder: folder(name), input: canonical(&l.spec, "sweep"), fresh: true, work: laval::store::Work::Missing };
    let run = |keep: &Keep, after: u64| {
        let stop = Cancel::default();
        let watch = Stop { after, seen: AtomicU64::new(0), stop: &stop };
        l.studies[0].study.run(&l.system, &Context { cancel: &stop, progress: &watch, keep: Some(keep), ..Context::quiet("s") }).unwrap()
    };
    let whole = run(&keep("whole"), u64::MAX);
    let first = run(&keep("parts"), 21);
    assert_eq!(first.end, End::Cancelled);
    assert!(first.findings.iter().any(|f| f.id == "incomplete"));
    let again = Keep { fresh: false, ..keep("parts") };
    assert_eq!(run(&again, 45).end, End::Cancelled);
    let second = run(&again, u64::MAX);
    assert_eq!(format!("{second:?}"), format!("{whole:?}"));
    let mut names: Vec<_> = std::fs::read_dir(folder("whole")).unwrap().map(|e| e.unwrap().file_name()).collect();
    names.sort();
    for name in names.iter().filter(|n| n.to_string_lossy().ends_with(".parquet")) {
        let read = |which: &str| std::fs::read(folder(which).join(name)).unwrap();
        assert!(read("whole") == read("parts"), "{name:?}");
    }
    for name in ["whole", "parts"] {
        std::fs::remove_dir_all(folder(name)).unwrap();
    }
}

#[test]
fn a_work_limit_leaves_what_was_done() {
    let l = loaded(LINEAR, "speed = { from = 200, to = 800, points = 100 }\nstart = \"up\"");
    let run = |work_limit: u64| l.studies[0].study.run(&l.system, &Context { work_limit, ..Context::quiet("s") }).unwrap();
    let whole = run(u64::MAX);
    for share in [2, 7, 100_000] {
        let limit = whole.work["steps"] / share;
        let o = run(limit);
        assert!(o.end == End::WorkLimit && o.work["steps"] <= limit);
        let (some, all) = (numbers(&o, "sweep", "amplitude.disc"), numbers(&whole, "sweep", "amplitude.disc"));
        assert!(some.len() < 100 && (share > 10 || !some.is_empty()) && some == all[..some.len()]);
    }
    let stop = Cancel::new(true);
    let o = l.studies[0].study.run(&l.system, &Context { cancel: &stop, ..Context::quiet("s") }).unwrap();
    assert_eq!((o.end, table(&o, "sweep").rows()), (End::Cancelled, 0));
}

/// A machine that flies apart is counted, its neighbours are not disturbed.
#[test]
fn failed_motions_are_values() {
    let m = LINEAR.replace(
        "kind = \"shaft_lumped\"\nname = \"shaft\"",
        "kind = \"bearing_cubic\"\nlaw = \"isotropic\"\nname = \"shaft\"\ncubic_stiffness = -1e14",
    );
    let o = run(&m, "speed = { from = 100, to = 1000, points = 10 }\nstart = \"rest\"");
    let motion = texts(&o, "sweep", "motion");
    let failed = motion.iter().filter(|m| *m == "failed").count();
    assert!(failed > 0 && motion.iter().filter(|m| *m == "periodic").count() > 0);
    let reported: f64 = o.findings.iter().filter(|f| f.id == "failed_motions").filter_map(|f| f.value).sum();
    assert_eq!(reported, failed as f64);
}

#[test]
fn mistakes_are_reported_where_they_stand() {
    for (study, code) in [
        ("speed = { from = 0, to = 10 }", "sweep.speed"),
        ("speed = { from = 10, to = 5 }", "study.range"),
        ("speed = { from = 1, to = 5 }\nwaterfall = \"drum\"", "sweep.waterfall"),
        ("speed = { from = 1, to = 5 }\ninitial = { \"disc.w\" = 1 }", "coordinate.unknown"),
    ] {
        let reported = with(LINEAR, study).map(drop).unwrap_err();
        assert!(reported.0.iter().any(|d| d.code == code), "{study}: {reported:?}");
    }
    let l = loaded(LINEAR, "speed = { from = 1, to = 5 }");
    let disc = DiscParams { polar_inertia: 0.1, ..DiscParams::new(2.0) };
    let free = Builder::new("free").part("disc", Disc::planar(), disc).free_spin().build().unwrap();
    assert_eq!(l.studies[0].study.admit(&free).unwrap_err().code, "sweep.free_spin");
}

/// A mode that dies out at 6e5 1/s: the method is chosen, finds the same motions, and takes a fifth of the steps.
#[test]
fn fast_modes_are_followed_by_the_stiff_method() {
    let machine = format!("{LINEAR}{FAST}");
    let study = |method: &str| {
        run(
            &machine,
            &format!(
                "{method}\nspeed = {{ from = 250, to = 400, points = 4 }}\nmost_periods = 100000\ntolerance = 1e-4\nsettling = \"shooting\""
            ),
        )
    };
    let (explicit, chosen) = (study("method = \"explicit\""), study(""));
    let steps = |o: &Outcome| o.work["steps"] as f64;
    let amplitudes = |o: &Outcome| numbers(o, "sweep", "amplitude.disc");
    for (a, b) in amplitudes(&explicit).iter().zip(amplitudes(&chosen)) {
        assert!((a - b).abs() < 1e-4 * a, "{a} {b}");
    }
    assert!(5.0 * steps(&chosen) < steps(&explicit), "{} {}", steps(&chosen), steps(&explicit));
}

/// A step of the speed so long that the motion at its beginning is thrown off the branch is no jump: smaller steps stay on it to its fold.
#[test]
fn coarse_steps_do_not_make_jumps() {
    let machine = r#"
[machine]
name = "d"
[[part]]
kind = "disc"
name = "d"
mass = 2.52863
eccentricity = 8.81435e-5
[[part]]
kind = "bearing_cubic"
name = "b"
between = ["d", "ground"]
law = "isotropic"
stiffness = 1710720
cubic_stiffness = 2.46479e12
[[part]]
kind = "damper"
name = "c"
between = ["d", "ground"]
damping = 234.348
"#;
    // of circular motion the fold is a double root in the amplitude of (k + k3 a^2 - m W^2)^2 + (c W)^2 = (m e W^2 / a)^2
    let (m, e, k, k3, c) = (2.52863, 8.81435e-5, 1_710_720.0, 2.46479e12, 234.348);
    let balance = |w: f64, a: f64| (k + k3 * a * a - m * w * w).hypot(c * w) * a - m * e * w * w;
    let roots =
        |w: f64| (1..40_000).filter(|&i| (balance(w, 1e-7 * f64::from(i)) > 0.0) != (balance(w, 1e-7 * f64::from(i - 1)) > 0.0)).count();
    let (mut lo, mut hi) = (2000.0, 2467.0);
    for _ in 0..30 {
        let middle = 0.5 * (lo + hi);
        if roots(middle) > 1 { lo = middle } else { hi = middle }
    }
    for points in [8, 12, 20, 40] {
        let study = format!("start = \"up\"\ntolerance = 1e-4\nperiods = 48\nspeed = {{ from = 411.26, to = 2467.56, points = {points} }}");
        let o = run(machine, &study);
        let reported: Vec<f64> = o.findings.iter().filter(|f| f.id == "jump_up").map(|f| f.value.unwrap()).collect();
        assert_eq!(reported.len(), 1, "{points}: {:?}", o.findings);
        let near = 2056.3 / f64::from(points - 1) / 16.0;
        assert!((reported[0] - lo).abs() < near, "{points}: {reported:?} {lo}");
        let at = numbers(&o, "jumps", "placed_before")[0];
        assert!(reported[0] - at <= near, "{at} {reported:?}");
        // up to the row before the fold the motion is that of the upper branch
        let (speed, amplitude) = (numbers(&o, "sweep", "speed"), numbers(&o, "sweep", "amplitude.d"));
        for (w, a) in speed.iter().zip(&amplitude).filter(|x| *x.0 < 0.999 * lo) {
            assert!(balance(*w, *a).abs() < 1e-2 * m * e * w * w, "{points} {w} {a}");
            assert!(*w < 1200.0 || *a > 7e-4, "{points} {w} {a}");
        }
    }
}

/// A horizontal rotor that hangs in the clearance of its bearing: the jumps of nonlinear_response at 833.6 and 841.4 rad/s, of which the sag hides a part.
#[test]
fn jumps_about_a_sag_are_found() {
    let machine = r#"
[machine]
axis = "horizontal"
[[part]]
kind = "disc"
name = "d"
mass = 6
eccentricity = 5e-6
[[part]]
kind = "bearing_hertz"
name = "b"
between = ["d", "ground"]
law = "radial"
coefficient = 3e9
clearance = 1e-5
[[part]]
kind = "damper"
name = "c"
between = ["d", "ground"]
damping = 300
"#;
    let o = run(machine, "speed = { from = 826, to = 846, points = 11 }\ninitial = { \"d.x\" = 0 }");
    for (id, fold) in [("jump_up", 841.38), ("jump_down", 833.62)] {
        let found: Vec<f64> = o.findings.iter().filter(|f| f.id == id).map(|f| f.value.unwrap()).collect();
        assert!(found.len() == 1 && (found[0] - fold).abs() < 0.3, "{id}: {found:?} {:#?}", o.findings);
    }
    let hysteresis: Vec<_> = o.findings.iter().filter(|f| f.id == "hysteresis").collect();
    assert_eq!(hysteresis.len(), 1, "{hysteresis:?}");
    assert!((hysteresis[0].value.unwrap() - (841.38 - 833.62)).abs() < 0.5, "{}", hysteresis[0].sentence());
}

/// Started anew, the response changes where the initial condition crosses a basin boundary: above the fold, and at another speed from another initial condition.
#[test]
fn a_change_of_basin_is_no_fold() {
    let machine = r#"
[machine]
[[part]]
kind = "disc"
name = "drum"
mass = 2.4
eccentricity = 1e-3
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "ground"]
law = "isotropic"
stiffness = 1.1e7
cubic_stiffness = 8.7e10
[[part]]
kind = "damper"
name = "air"
between = ["drum", "ground"]
damping = 600
"#;
    // the lower branch of circular motion ends where roots of the balance meet
    let (m, e, k, k3, c) = (2.4, 1e-3, 1.1e7, 8.7e10, 600.0);
    let balance = |w: f64, a: f64| (k + k3 * a * a - m * w * w).hypot(c * w) * a - m * e * w * w;
    let roots =
        |w: f64| (1..12_000).filter(|&i| (balance(w, 1e-6 * f64::from(i)) > 0.0) != (balance(w, 1e-6 * f64::from(i - 1)) > 0.0)).count();
    let (mut fold, mut above) = (2500.0, 2600.0);
    for _ in 0..20 {
        let middle = 0.5 * (fold + above);
        if roots(middle) > 1 { above = middle } else { fold = middle }
    }
    let study = |more: &str| run(machine, &format!("speed = {{ from = 2550, to = 2690, points = 8 }}\n{more}"));
    let o = study("start = \"all\"");
    let of = |o: &Outcome, id: &str| {
        let all: Vec<_> = o.findings.iter().filter(|f| f.id == id).cloned().collect();
        assert_eq!(all.len(), 1, "{id}: {:?}", o.findings);
        all[0].clone()
    };
    let (down, anew) = (of(&o, "jump_down"), of(&o, "start_jump"));
    assert!((down.value.unwrap() - fold).abs() < 5.0, "{down:?} {fold}");
    let (from, to) = (anew.number("from").unwrap(), anew.number("to").unwrap());
    assert!(from > fold + 10.0 && to - from < 20.0 + 1e-9 && anew.value == Some(to), "{anew:?} {fold}");
    let said = anew.sentence();
    assert!(said.contains("basin boundary") && said.contains("differs from the fold that nonlinear_response reports"), "{said}");
    assert!(!down.sentence().contains("basin"), "{}", down.sentence());
    let other = of(&study("start = \"rest\"\ninitial = { \"drum.x\" = \"2 mm\" }"), "start_jump");
    assert!(other.value.unwrap() > to + 10.0, "{other:?} {anew:?}");
}

/// Followed at many speeds together a motion goes where it goes when it is followed one by one, as it is beside an exponent.
#[test]
fn motions_followed_together_are_those_followed_one_by_one() {
    let study = |more: &str| {
        let l = loaded(
            &machine(600.0, 8.7e10),
            &format!("speed = {{ from = 2500, to = 3000, points = 20 }}\nstart = \"up_and_down\"\ntolerance = 1e-4\n{more}"),
        );
        l.studies[0].study.run(&l.system, &Context::quiet("s")).unwrap()
    };
    let (together, single) = (study(""), study("lyapunov = true\nlyapunov_periods = 16"));
    let column = |o: &Outcome, name: &str| -> Vec<f64> {
        let t = o.find_table("sweep").unwrap();
        let c = t.column(name).unwrap();
        (0..t.rows()).map(|r| c.number(r).unwrap_or(f64::NAN)).collect()
    };
    let size = together.find_table("sweep").unwrap().columns().iter().map(|c| c.name.to_string()).find(|n| n.contains("drum")).unwrap();
    let (a, b) = (column(&together, &size), column(&single, &size));
    assert_eq!(a.len(), 40);
    for (a, b) in a.iter().zip(&b) {
        assert!((a - b).abs() <= 1e-3 * b.abs(), "{size}: {a} beside {b}");
    }
    for name in ["jump_before", "jump_after"] {
        let [a, b] = [&together, &single].map(|o| column(o, name));
        assert!(a.iter().zip(&b).all(|(a, b)| a.is_nan() == b.is_nan() && !((a - b).abs() > 1e-9 * b.abs())), "{name}: {a:?} beside {b:?}");
    }
}
