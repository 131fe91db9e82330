//! Bearings in a table over speed and frequency of vibration, against what knows no table.

use crate::common::files::{finding, findings, load, run_all};
use laval::outcome::{Arg, Level, Outcome, Verdict};
use laval::report::Style;
use laval::solve::rest::rest;
use laval::study::Context;
use laval::study::forced_response::at_speed;
use laval_num::complex::{C64, c};
use laval_num::interpolate::Interpolant;

/// A column of the table: its name, and its values over speed and frequency.
type Coefficient<'a> = (&'a str, &'a dyn Fn(f64, f64) -> f64);
/// The same of a plain function.
type Law = (&'static str, fn(f64, f64) -> f64);

/// Columns of a table by name, for all pairs of speeds and frequencies.
fn grid(speeds: &[f64], frequencies: &[f64], columns: &[Coefficient]) -> String {
    let pairs: Vec<(f64, f64)> = speeds.iter().flat_map(|w| frequencies.iter().map(move |f| (*w, *f))).collect();
    of_pairs(&pairs, columns)
}

fn of_pairs(pairs: &[(f64, f64)], columns: &[Coefficient]) -> String {
    let list = |f: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|p| format!("{:e}", f(p.0, p.1))).collect::<Vec<_>>().join(", ");
    let mut all = vec![format!("speed = [{}]", list(&|w, _| w)), format!("frequency = [{}]", list(&|_, f| f))];
    all.extend(columns.iter().map(|(name, f)| format!("{name} = [{}]", list(f))));
    format!("table = {{ {} }}", all.join(", "))
}

/// A point mass of 12 kg on a bearing.
fn rotor(bearing: &str, studies: &str) -> String {
    format!(
        "[machine]\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 12\neccentricity = 2e-5\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\n{bearing}\n{studies}"
    )
}

fn study(kind: &str, rest: &str) -> String {
    format!("[[study]]\nkind = \"{kind}\"\n{rest}\n")
}

/// A column of a table of numbers.
fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    let t = o.find_table(table).unwrap_or_else(|| panic!("no table {table}"));
    let of = t.column(name).unwrap_or_else(|| panic!("{table} has {:?}", t.columns().iter().map(|c| &c.name).collect::<Vec<_>>()));
    (0..t.rows()).map(|k| of.number(k).unwrap()).collect()
}

fn near(a: &[f64], b: &[f64], tolerance: f64, what: &str) {
    assert_eq!(a.len(), b.len(), "{what}");
    let size = b.iter().map(|x| x.abs()).fold(0.0, f64::max);
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() <= tolerance * size || x.is_nan() && y.is_nan(), "{what}: {x} {y}");
    }
}

const SPEEDS: [f64; 4] = [50.0, 200.0, 400.0, 700.0];

/// Coefficients over the speed alone.
fn over_speed() -> Vec<Law> {
    vec![
        ("kxx", |w, _| 1e6 + 2e3 * w),
        ("kxy", |w, _| 1e5 + 300.0 * w),
        ("kyx", |w, _| -1e5 - 200.0 * w),
        ("kyy", |w, _| 2e6 + 1e3 * w + w * w),
        ("cxx", |w, _| 900.0 - 0.5 * w),
        ("cyy", |w, _| 1200.0 - 0.7 * w),
    ]
}

/// Every study that takes such a table gives with one that is constant over the frequency what the table over the speed gives.
#[test]
fn constant_over_frequency_is_the_table_over_speed() {
    let studies = [
        study("forced_response", "speed = { from = 60, to = 690, points = 40 }"),
        study("critical_speeds", "speed = { from = 60, to = 690, points = 40 }"),
        study("critical_speeds", "speed = { from = 60, to = 690, points = 40 }\norders = [1, 2]"),
        study("harmonic_force", "place = \"rotor\"\nspeed = { from = 60, to = 690, points = 40 }\norder = 2"),
        study("harmonic_force", "place = \"rotor\"\nspeed = 300\nfrequency = { from = 20, to = 1200, points = 40 }"),
        study("modes", ""),
        study("campbell", "speed = { from = 60, to = 690, points = 30 }\norders = [1, 2]"),
    ]
    .concat();
    let columns = over_speed();
    let of: Vec<Coefficient> = columns.iter().map(|c| (c.0, &c.1 as &dyn Fn(f64, f64) -> f64)).collect();
    let with = run_all(&rotor(&grid(&SPEEDS, &[0.0, 100.0, 1500.0], &of), &studies));
    let plain = grid(&SPEEDS, &[0.0], &of);
    let plain = format!("{}{}", &plain[..plain.find("frequency").unwrap()], &plain[plain.find("kxx").unwrap()..]);
    let without = run_all(&rotor(&plain, &studies));
    for (name, table, columns, tolerance) in [
        (0, "response", &["speed", "amplitude.rotor"][..], 1e-12),
        (0, "extrema", &["speed"][..], 1e-9),
        (1, "critical_speeds", &["speed", "growth"][..], 1e-12),
        (1, "response_peaks", &["speed", "amplitude"][..], 1e-9),
        (2, "critical_speeds", &["speed", "growth", "order"][..], 1e-12),
        (3, "peaks", &["amplitude"][..], 1e-9),
        (4, "peaks", &["amplitude"][..], 1e-9),
        (5, "modes", &["growth", "frequency", "forward_share"][..], 1e-12),
        (6, "critical_speeds", &["speed", "growth", "mode"][..], 1e-12),
        (6, "modes", &["speed", "growth", "frequency"][..], 1e-11),
    ] {
        let (a, b) = (&with[name], &without[name]);
        for col in columns {
            near(&column(a, table, col), &column(b, table, col), tolerance, &format!("{} {table} {col}", a.kind));
        }
    }
    // no mode is missing, and studies that know the stability report it
    assert_eq!(finding(&with[5], "own_frequency").level, Level::Info);
    assert_eq!(finding(&with[6], "own_frequency").level, Level::Info);
    assert!(with[..5].iter().all(|o| findings(o, "growth_unassessed").len() == 1));
    assert!(findings(&with[5], "stable").len() == 1 && findings(&with[5], "growth_unassessed").is_empty());
}

/// One mass, K = k + a W + b nu and C = c: the frequency of the mode solves `m nu^2 = k + a W + b nu - c^2/(4 m)`, its growth is -c/(2 m); the critical speed the same with
/// W = nu, and the response to unbalance is that of a spring k + (a + b) W. Lines are interpolated exactly.
#[test]
fn one_mass_has_the_frequency_of_its_own_equation() {
    let (m, k, a, b, d) = (12.0, 1e6, 500.0, 1500.0, 700.0);
    let table = grid(
        &[10.0, 200.0, 450.0, 900.0],
        &[0.0, 250.0, 300.0, 900.0],
        &[("kxx", &|w, f| k + a * w + b * f), ("kyy", &|w, f| k + a * w + b * f), ("cxx", &|_, _| d), ("cyy", &|_, _| d)],
    );
    let studies = [
        study("modes", ""),
        study("critical_speeds", "speed = { from = 20, to = 890 }"),
        study("campbell", "speed = { from = 20, to = 890, points = 25 }"),
    ]
    .concat();
    let all = run_all(&rotor(&table, &studies));
    let own = |b: f64, k: f64| (b + (b * b + 4.0 * m * (k - d * d / (4.0 * m))).sqrt()) / (2.0 * m);
    let at = |w: f64| own(b, k + a * w);
    near(&column(&all[0], "modes", "frequency"), &[at(300.0); 2], 1e-12, "frequency");
    near(&column(&all[0], "modes", "growth"), &[-d / (2.0 * m); 2], 1e-12, "growth");
    let residuals = column(&all[0], "modes", "frequency_residual");
    assert!(residuals.iter().all(|r| *r < 1e-12), "{residuals:?}");
    let critical = own(a + b, k);
    let found = column(&all[1], "critical_speeds", "speed");
    assert!(!found.is_empty());
    near(&found, &vec![critical; found.len()], 1e-11, "critical speed");
    near(&column(&all[2], "critical_speeds", "speed"), &vec![critical; found.len()], 1e-11, "critical speed of the diagram");
    let (speeds, frequencies) = (column(&all[2], "modes", "speed"), column(&all[2], "modes", "frequency"));
    // two modes at 25 speeds and at two rows of the table
    assert_eq!(speeds.len(), 54);
    speeds.iter().zip(&frequencies).for_each(|(w, f)| assert!((f / at(*w) - 1.0).abs() < 1e-12, "{w}: {f}"));
    // the peak of the response, found without any mode
    let size = |w: f64| w * w / c(k + (a + b) * w - m * w * w, w * d).abs();
    let peak = laval_num::univariate::maximum(|w| Some(size(w)), 20.0, 890.0, 1e-9).unwrap();
    near(&column(&all[1], "response_peaks", "speed")[..1], &[peak.0], 1e-6, "peak");
    near(&column(&all[1], "response_peaks", "amplitude")[..1], &[2e-5 * m * peak.1], 1e-10, "its amplitude");
}

/// Where the stiffness rises faster than `m nu^2` there are three frequencies: the middle one is passed from below, and the count knows all.
#[test]
fn a_stiffness_that_rises_steeply_has_three_modes() {
    let frequencies = [0.0, 100.0, 200.0, 400.0];
    let stiffness = [50.0f64, 60.0, 230.0, 300.0].map(|w| 12.0 * w * w);
    let k = |f: f64| stiffness[frequencies.iter().position(|x| *x == f).unwrap()];
    let table = grid(&[10.0, 900.0], &frequencies, &[("kxx", &|_, f| k(f)), ("kyy", &|_, f| 4.0 * k(f))]);
    let all = run_all(&rotor(&format!("{table}\nbeyond = \"hold\""), &study("modes", "")));
    let curve = Interpolant::new(&frequencies, &stiffness).unwrap();
    let mut wanted = Vec::new();
    for factor in [1.0, 4.0] {
        let gap = |f: f64| factor * curve.value(f) - 12.0 * f * f;
        for i in 0..7000 {
            let (x, y) = (0.05 + 0.1 * f64::from(i), 0.15 + 0.1 * f64::from(i));
            if gap(x) * gap(y) < 0.0 {
                wanted.push(laval_num::univariate::root(|f| Some(gap(f)), (x, gap(x)), (y, gap(y)), 1e-13).unwrap());
            }
        }
    }
    wanted.sort_by(f64::total_cmp);
    assert!(wanted.len() >= 4, "{wanted:?}");
    near(&column(&all[0], "modes", "frequency"), &wanted, 1e-11, "frequencies");
    assert_eq!(finding(&all[0], "own_frequency").level, Level::Info);
    // the faster ones lie beyond the table, and the findings report it
    let beyond = findings(&all[0], "beyond_frequencies");
    assert_eq!(beyond.len(), usize::from(wanted.iter().any(|f| *f > 400.0)));
}

/// A spring of stiffness k and, beside it, one of stiffness k1 in series with a damper d: a Maxwell element has `Z(i nu) = i nu d k1/(k1 + i nu d)`.
fn maxwell(d: f64, frequencies: usize) -> [String; 2] {
    let (k, k1) = (1.2e6, 8e5);
    let stiffness = move |f: f64| k + k1 * (f * d).powi(2) / (k1 * k1 + (f * d).powi(2));
    let damping = move |f: f64| d * k1 * k1 / (k1 * k1 + (f * d).powi(2));
    let all: Vec<f64> = (0..=frequencies).map(|i| 900.0 * i as f64 / frequencies as f64).collect();
    let table = grid(
        &[10.0, 900.0],
        &all,
        &[("kxx", &|_, f| stiffness(f)), ("kyy", &|_, f| stiffness(f)), ("cxx", &|_, f| damping(f)), ("cyy", &|_, f| damping(f))],
    );
    let exact = format!(
        "[machine]\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 12\neccentricity = 2e-5\n[[part]]\nkind = \"disc\"\nname = \"node\"\nmass = 0\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"a\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = {k}\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"rotor\", \"node\"]\nstiffness = {k1}\n\
         [[part]]\nkind = \"damper\"\nname = \"c\"\nbetween = [\"node\", \"ground\"]\ndamping = {d}\n"
    );
    [rotor(&table, ""), exact]
}

/// In steady vibration the table is the element, to the error of interpolation.
#[test]
fn a_maxwell_element_in_a_table_responds_as_itself() {
    let error = |frequencies: usize| {
        let [table, exact] = maxwell(3000.0, frequencies).map(|t| load(&t).system);
        let size = |s: &laval::model::system::System, w: f64| at_speed(s, w).unwrap().unwrap().circles(0).0;
        (1..40)
            .map(|k| 20.0 * f64::from(k) + 3.3)
            .map(|w| ((size(&table, w) - size(&exact, w)) / size(&exact, w)).abs())
            .fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(50), error(400));
    assert!(fine < 2e-5 && fine < coarse / 40.0, "{coarse:e} {fine:e}");
    // the study is the response by the impedance at the frequency of the unbalance
    let [table, _] = maxwell(3000.0, 50);
    let system = load(&table).system;
    let o = &run_all(&format!("{table}{}", study("forced_response", "speed = { from = 50, to = 800, points = 20 }")))[0];
    for (w, x) in column(o, "response", "speed").iter().zip(column(o, "response", "amplitude.rotor")) {
        let direct = at_speed(&system, *w).unwrap().unwrap().major(0);
        assert!((x / direct - 1.0).abs() < 1e-12, "{w}: {x} {direct}");
    }
}

fn least_damped(text: &str) -> C64 {
    let o = &run_all(&format!("{text}{}", study("modes", "")))[0];
    let (growth, frequency) = (column(o, "modes", "growth"), column(o, "modes", "frequency"));
    // heavily damped ones are those of the convention alone
    let at = (0..growth.len()).max_by(|&a, &b| (frequency[a] / growth[a].abs()).total_cmp(&(frequency[b] / growth[b].abs()))).unwrap();
    c(growth[at], frequency[at])
}

/// Off the axis the element is `Z(s)`, the table `K(nu) + s C(nu)` with nu = Im s: they differ by `g (nu C' - i K')` for a growth g. By the relations of Kramers and Kronig K' and C' are of the order of the
/// damping or less, so that the roots differ by its square.
#[test]
fn modes_of_a_maxwell_element_agree_to_second_order_in_the_damping() {
    let difference = |d: f64| {
        let [table, exact] = maxwell(d, 1500).map(|t| least_damped(&t));
        let (k1, nu) = (8e5f64, table.im);
        let q = k1 * k1 + (nu * d).powi(2);
        let (by_k, by_c) = (k1 * 2.0 * nu * d * d * k1 * k1 / (q * q), -d * k1 * k1 * 2.0 * nu * d * d / (q * q));
        let estimate = c(nu * by_c, -by_k).scale(table.re) / (table.scale(24.0) + c(d * k1 * k1 / q, 0.0));
        assert!((table - exact - estimate).abs() < 0.2 * estimate.abs(), "{d}: {table:?} {exact:?} {estimate:?}");
        (table - exact).abs() / exact.abs()
    };
    let [strong, weak] = [40_000.0, 80_000.0].map(difference);
    assert!((strong / weak - 4.0).abs() < 0.3 && strong < 1e-3, "{strong:e} {weak:e}");
}

/// So much damping that nothing oscillates: such roots have the coefficients of the frequency 0.
#[test]
fn aperiodic_roots_have_the_coefficients_at_rest() {
    let table = grid(
        &[10.0, 900.0],
        &[0.0, 100.0, 900.0],
        &[("kxx", &|_, f| 1e6 + 10.0 * f), ("kyy", &|_, f| 1e6 + 10.0 * f), ("cxx", &|_, f| 2e4 + f), ("cyy", &|_, f| 2e4 + f)],
    );
    let o = &run_all(&rotor(&table, &study("modes", "")))[0];
    let root = |sign: f64| (-2e4 + sign * (4e8f64 - 48e6).sqrt()) / 24.0;
    let mut growth = column(o, "modes", "growth");
    growth.sort_by(f64::total_cmp);
    // one for both directions
    near(&growth, &[root(-1.0), root(1.0)], 1e-10, "roots");
    assert_eq!(finding(o, "own_frequency").level, Level::Info);
}

/// A shaft of so many elements on two such bearings with rows at these pairs of speed and frequency.
fn shaft(elements: usize, pairs: &[(f64, f64)], studies: &str) -> String {
    let columns: [Coefficient; 6] = [
        ("kxx", &|w, f| 2e7 + 2e3 * w + 4e3 * f),
        ("kxy", &|w, _| 1e6 + 1e3 * w),
        ("kyx", &|w, _| -1e6 - 1e3 * w),
        ("kyy", &|w, f| 3e7 + 1e3 * w + 2e3 * f),
        ("cxx", &|w, f| 1e4 - w - 0.5 * f),
        ("cyy", &|w, f| 1.5e4 - w - 0.7 * f),
    ];
    let table = of_pairs(pairs, &columns);
    let bearing = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at} }}, \"ground\"]\n{table}\n"
        )
    };
    format!(
        "[machine]\nspeed = 500\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = {elements}\nsection = {{ length = [0.5, 0.5], outer_diameter = [0.06, 0.06] }}\n\
         [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.5 }}\nmass = 30\npolar_inertia = 0.4\ndiametral_inertia = 0.2\neccentricity = 1e-5\n{}{}{studies}",
        bearing("left", 0.1),
        bearing("right", 0.9),
    )
}

fn pairs() -> Vec<(f64, f64)> {
    [100.0, 400.0, 900.0].iter().flat_map(|w| [0.0, 300.0, 600.0, 2500.0].map(|f| (*w, f))).collect()
}

/// Rows in the order of speeds and in that of frequencies; every mode is a root of the machine frozen at its frequency.
#[test]
fn rows_in_either_order_are_one_machine() {
    let studies = [
        study("modes", ""),
        study("forced_response", "speed = { from = 110, to = 890, points = 30 }"),
        study("critical_speeds", "speed = { from = 110, to = 890, points = 30 }"),
        study("campbell", "speed = { from = 110, to = 890, points = 12 }"),
    ]
    .concat();
    let by_speed = pairs();
    let mut by_frequency = pairs();
    by_frequency.sort_by(|a, b| b.1.total_cmp(&a.1));
    let (a, b) = (run_all(&shaft(6, &by_speed, &studies)), run_all(&shaft(6, &by_frequency, &studies)));
    for (k, table, col) in [
        (0, "modes", "frequency"),
        (0, "modes", "growth"),
        (1, "response", "speed"),
        (2, "critical_speeds", "speed"),
        (3, "modes", "frequency"),
    ] {
        near(&column(&a[k], table, col), &column(&b[k], table, col), 1e-12, col);
    }
    let system = load(&shaft(6, &by_speed, "")).system;
    let (growth, frequency) = (column(&a[0], "modes", "growth"), column(&a[0], "modes", "frequency"));
    assert!(frequency.len() > 3);
    for (g, f) in growth.iter().zip(&frequency).filter(|x| *x.1 > 0.0) {
        let held = system.frozen(laval::model::part::Frozen::At(*f)).unwrap().unwrap();
        let modes = laval::solve::pencil::modes_about(&held, &rest(&system, 500.0).unwrap(), true).unwrap().modes;
        let nearest = modes.iter().map(|m| (m.value - c(*g, *f)).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-9 * f, "{g} {f}: {nearest}");
    }
    // the table ends below some modes
    assert_eq!(findings(&a[0], "outside_frequencies").len(), 1);
    assert!(finding(&a[0], "stable").sentence().contains("as far as modes from"), "{}", finding(&a[0], "stable").sentence());
}

/// Of a machine too large for all its modes those of the frozen machines are counted roots: the same modes as with few elements, to
/// the error of these (1.3e-4 of the highest bending mode with elements of 83 mm).
#[test]
fn a_large_machine_has_the_modes_of_a_small_one() {
    let modes = |elements: usize| {
        let o = run_all(&shaft(elements, &pairs(), &study("modes", ""))).remove(0);
        assert_eq!(finding(&o, "own_frequency").level, Level::Info, "{}", finding(&o, "own_frequency").sentence());
        let (growth, frequency) = (column(&o, "modes", "growth"), column(&o, "modes", "frequency"));
        growth.into_iter().zip(frequency).map(|(g, f)| c(g, f)).filter(|s| s.im > 1.0).collect::<Vec<C64>>()
    };
    let (small, large) = (modes(6), modes(20));
    assert!(small.len() == large.len() && small.len() > 3, "{small:?} {large:?}");
    for (a, b) in small.iter().zip(&large) {
        assert!((*a - *b).abs() < 5e-4 * b.abs(), "{a:?} {b:?}");
    }
}

fn refusal(text: &str) -> laval::diagnostic::Diagnostic {
    let loaded = laval::file::load(text).unwrap_or_else(|d| panic!("{d:?}"));
    let study = &loaded.studies[0].study;
    let admitted = study.admit(&loaded.system).unwrap_err();
    let run = study.run(&loaded.system, &Context::quiet("study")).unwrap_err();
    assert_eq!((admitted.code, admitted.message.to_string()), (run.code, run.message.to_string()));
    admitted
}

fn plain(beyond: &str) -> String {
    let columns: [Coefficient; 4] = [("kxx", &|_, f| 1e6 + f), ("kyy", &|_, f| 2e6 + f), ("cxx", &|_, _| 500.0), ("cyy", &|_, _| 500.0)];
    format!("{}\n{beyond}", grid(&[50.0, 500.0], &[100.0, 350.0], &columns))
}

/// What a study cannot answer for such a part it says, with its name and what to do: every study, by the example of its documentation.
#[test]
fn other_studies_refuse_by_name() {
    let takes = ["forced_response", "harmonic_force", "critical_speeds", "modes", "campbell"];
    let mut refused = Vec::new();
    for kind in laval::file::catalog().studies.iter().filter(|k| !takes.contains(&k.kind)) {
        let text = rotor(&plain(""), &study(kind.kind, kind.example)).replace("\"rotor\"", "\"drum\"");
        // one that needs another machine says so first
        let Ok(loaded) = laval::file::load(&text) else { continue };
        let Err(d) = loaded.studies[0].study.admit(&loaded.system) else { continue };
        if d.code == "study.over_frequency" {
            assert!(d.to_string().contains("\"bearing\" depend on the frequency of vibration"), "{d}");
            refused.push(kind.kind);
        }
        let run = loaded.studies[0].study.run(&loaded.system, &Context::quiet("study"));
        assert!(run.is_err(), "{} runs", kind.kind);
    }
    for kind in [
        "stability_map",
        "stability_threshold",
        "support_stiffness_map",
        "static",
        "bearing_coefficients",
        "nonlinear_response",
        "backbone",
        "limit_cycles",
        "transient",
        "run_up",
        "stationary",
        "sensitivity",
    ] {
        assert!(refused.contains(&kind), "{kind} is not among {refused:?}");
    }
    let turning = refusal(&rotor(&plain(""), &study("modes", "about = \"turning\"")));
    assert_eq!(turning.code, "modes.frequency_only");
}

/// The first page of a machine whose table ends between its natural frequencies, sqrt(1e6/12) = 289 rad/s and sqrt(2e6/12) = 408 rad/s: its first sentence names the part, the
/// frequencies of the table and the study that gives the modes there.
#[test]
fn the_first_page_says_why_stability_is_not_known() {
    let loaded = load(&rotor(&plain(""), ""));
    let p = laval::study::overview(&loaded.system, &[], &[], &Context::quiet("summary"));
    assert_eq!(p.verdict, Verdict::NotComputed);
    let first = &p.headline[0];
    assert!(first.key == "headline-unknown-table" && first.arg_named("part") == Some(&Arg::name("bearing")), "{first:?}");
    let Some(Arg::Quantity(from)) = first.arg_named("from") else { panic!("{first:?}") };
    let Some(Arg::Quantity(to)) = first.arg_named("to") else { panic!("{first:?}") };
    assert_eq!([from.value, to.value], [100.0, 350.0]);
    let shown = Style::default().message(first);
    for word in ["\"bearing\"", "100 rad/s", "350 rad/s", "\"modes\"", "rows"] {
        assert!(shown.contains(word), "{word}: {shown}");
    }
    assert_eq!(shown.matches('.').count(), 1, "one sentence: {shown}");
    // that study answers
    let o = &run_all(&rotor(&plain(""), &study("modes", "")))[0];
    assert!(!column(o, "modes", "frequency").is_empty(), "{:?}", o.findings);
}

/// A table that ends below both natural frequencies, 289 rad/s and 408 rad/s: no mode is found, nothing is stated of the stability, and a finding names the modes outside.
#[test]
fn a_table_without_modes_has_no_growth_rate() {
    let columns: [Coefficient; 4] = [("kxx", &|_, f| 1e6 + f), ("kyy", &|_, f| 2e6 + f), ("cxx", &|_, _| 500.0), ("cyy", &|_, _| 500.0)];
    let o = &run_all(&rotor(&grid(&[50.0, 500.0], &[100.0, 250.0], &columns), &study("modes", "")))[0];
    assert!(column(o, "modes", "frequency").is_empty(), "{:?}", o.findings);
    assert!(findings(o, "stable").is_empty() && findings(o, "stability_unknown").is_empty(), "{:?}", o.findings);
    assert_eq!(findings(o, "outside_frequencies").len(), 1);
}

/// Outside the frequencies of the table a study is refused, or its findings are marked.
#[test]
fn extrapolation_is_never_silent() {
    let response = study("forced_response", "speed = { from = 60, to = 400, points = 30 }");
    let d = refusal(&rotor(&plain(""), &response));
    assert_eq!(d.code, "study.beyond_frequencies");
    assert!(
        d.to_string()
            .contains("\"bearing\" at frequencies of vibration from 9.549 Hz to 63.66 Hz; its table goes from 15.92 Hz to 55.7 Hz"),
        "{d}"
    );
    let force = study("harmonic_force", "place = \"rotor\"\nspeed = 200\nfrequency = { from = 110, to = 360 }");
    assert_eq!(refusal(&rotor(&plain(""), &force)).code, "study.beyond_frequencies");
    let second = study("critical_speeds", "speed = { from = 110, to = 200 }\norders = [2]");
    assert_eq!(refusal(&rotor(&plain(""), &second)).code, "study.beyond_frequencies");
    // inside it is answered
    let inside = study("forced_response", "speed = { from = 110, to = 340, points = 30 }");
    assert!(findings(&run_all(&rotor(&plain(""), &inside))[0], "beyond_table").is_empty());
    for rule in ["hold", "linear"] {
        let beyond = plain(&format!("beyond = \"{rule}\""));
        let o = &run_all(&rotor(&beyond, &response))[0];
        let f = finding(o, "beyond_table");
        assert!(f.level == Level::Invalid && f.sentence().contains("frequencies of vibration"), "{}", f.sentence());
        let resonances = findings(o, "largest_resonance");
        assert!(!resonances.is_empty());
        for r in resonances {
            let w = r.value.unwrap();
            assert_eq!(r.level == Level::Invalid, !(100.0..=350.0).contains(&w), "{w} {}", r.sentence());
        }
        let o = &run_all(&rotor(&beyond, &study("modes", "")))[0];
        let outside = column(o, "modes", "frequency").iter().filter(|f| !(100.0..=350.0).contains(*f)).count();
        assert_eq!(findings(o, "beyond_frequencies").len(), usize::from(outside > 0));
    }
}

/// A bearing of a body that turns 2.5 times as fast as the machine: the frequency of the unbalance is that of the machine, the speed of the table that of the body.
#[test]
fn of_another_spin_the_frequency_is_that_of_the_load() {
    let table = grid(
        &[100.0, 600.0, 1500.0],
        &[0.0, 250.0, 600.0],
        &[
            ("kxx", &|w, f| 1e6 + 300.0 * w + 2e3 * f),
            ("kyy", &|w, f| 1e6 + 200.0 * w + 3e3 * f),
            ("cxx", &|_, f| 900.0 - f),
            ("cyy", &|_, f| 900.0 - f),
        ],
    );
    let text = format!(
        "[machine]\nspeed = 300\n[[part]]\nkind = \"speed_ratio\"\nname = \"fast\"\nratio = 2.5\n\
         [[part]]\nkind = \"disc\"\nname = \"inner\"\nmass = 12\neccentricity = 2e-5\n[[part]]\nkind = \"disc\"\nname = \"outer\"\nmass = 8\nspin = \"fast\"\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"between\"\nbetween = [\"inner\", \"outer\"]\nstiffness = 4e6\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"outer\", \"ground\"]\n{table}\n{}",
        study("forced_response", "speed = { from = 60, to = 590, points = 10 }")
    );
    let (system, o) = (load(&text).system, &run_all(&text)[0]);
    assert!((system.slot("bearing").unwrap().speed(system.params(), 1.0) - 2.5).abs() < 1e-14);
    for (w, x) in column(o, "response", "speed").iter().zip(column(o, "response", "amplitude.outer")) {
        let direct = at_speed(&system, *w).unwrap().unwrap();
        let outer = system.coordinate("outer.x").unwrap();
        assert!((x / direct.major(outer) - 1.0).abs() < 1e-12, "{w}: {x}");
    }
}

/// Uncertainties run the study that takes the table, with its rows as parameters.
#[test]
fn rows_of_a_grid_are_uncertain() {
    let table = grid(
        &[100.0, 600.0],
        &[0.0, 250.0, 900.0],
        &[
            ("kxx", &|w, f| 1e6 + 300.0 * w + 2e3 * f),
            ("kyy", &|w, f| 2e6 + 200.0 * w + 3e3 * f),
            ("cxx", &|_, f| 900.0 - 0.5 * f),
            ("cyy", &|_, f| 900.0 - 0.5 * f),
        ],
    );
    let request = "study = { kind = \"modes\" }\nsamples = 16\nparameters = [{ parameter = \"bearing.table[2].kxx\", distribution = \"normal\", deviation = \"5 %\" }]";
    let o = &run_all(&rotor(&table, &study("uncertainty", request)))[0];
    assert!(!o.findings.is_empty());
}

/// A stiff rotor on heavily damped pads without preferred direction: modes near critical damping, whose frequency rises steeply with that of the coefficients where two
/// aperiodic roots become a pair. None is missing at any speed.
#[test]
fn modes_near_critical_damping_are_counted() {
    let of = |f: f64, all: [f64; 3]| all[[0.0, 300.0, 1200.0].iter().position(|x| *x == f).unwrap()];
    let pads = grid(
        &[50.0, 900.0],
        &[0.0, 300.0, 1200.0],
        &[
            ("kxx", &|w, f| of(f, [2e7, 2.4e7, 3e7]) + 6e3 * w),
            ("kyy", &|w, f| of(f, [2e7, 2.4e7, 3e7]) + 6e3 * w),
            ("cxx", &|w, f| of(f, [3e4, 2.5e4, 2e4]) - 11.0 * w),
            ("cyy", &|w, f| of(f, [3e4, 2.5e4, 2e4]) - 11.0 * w),
        ],
    );
    let text = format!(
        "[machine]\nspeed = 314\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 4\nsection = {{ length = [0.5, 0.5], outer_diameter = [0.06, 0.06] }}\n\
         [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.5 }}\nmass = 30\npolar_inertia = 0.4\ndiametral_inertia = 0.2\neccentricity = 1e-5\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"left\"\nbetween = [{{ body = \"shaft\", at = 0.1 }}, \"ground\"]\n{pads}\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"right\"\nbetween = [{{ body = \"shaft\", at = 0.9 }}, \"ground\"]\nstiffness = 3e7\ndamping = 2e4\n{}{}",
        study("modes", ""),
        study("campbell", "speed = { from = 60, to = 840, points = 40 }"),
    );
    let all = run_all(&text);
    for o in &all {
        assert_eq!(finding(o, "own_frequency").level, Level::Info);
    }
    assert!(column(&all[0], "modes", "damping_ratio").iter().any(|d| *d > 0.9));
}
