//! What linear studies claim: instability comes first, shares are shares, one speed is one speed, no column without a value, advice that can be followed.

use crate::common::files::{finding, findings, load, run_all};
use laval::outcome::{Data, Level, Outcome};
use laval::study::Context;
use laval_num::complex::c;

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    let t = o.find_table(table).unwrap();
    (0..t.rows()).map(|k| t.column(name).unwrap_or_else(|| panic!("no {name}")).number(k).unwrap()).collect()
}

fn flags(o: &Outcome, table: &str, name: &str) -> Vec<bool> {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Flag(v) => v.clone(),
        _ => panic!("{name} is no flag"),
    }
}

/// A disc in one bearing.
fn planar(bearing: &str, studies: &str) -> String {
    format!(
        "{studies}\n[machine]\nspeed = 100\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 1\neccentricity = 1e-5\n\
         [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\n{bearing}\n"
    )
}

const ROUND: &str = "kxx = 1e5\nkyy = 1e5\ncxx = 5\ncyy = 5";
const ELLIPTIC: &str = "kxx = 1e5\nkyy = 2e5\ncxx = 5\ncyy = 5";

#[test]
fn a_machine_that_diverges_is_said_to_first() {
    let range = "speed = { from = 10, to = 2000 }";
    let studies = format!(
        "study = [{{ kind = \"forced_response\", {range} }}, {{ kind = \"critical_speeds\", {range} }}, {{ kind = \"campbell\", {range} }}, {{ kind = \"forced_response\", name = \"one\", speed = 100 }}]"
    );
    // x diverges: s^2 + s - 1 = 0
    let growth = 0.5 * (5f64.sqrt() - 1.0);
    for o in run_all(&planar("kxx = -1\nkyy = 1e5\ncxx = 1\ncyy = 1", &studies)) {
        let first = &o.findings[0];
        assert!(first.id == "unstable" && first.level == Level::Warning, "{}: {}", o.kind, first.sentence());
        assert!((first.value.unwrap() / growth - 1.0).abs() < 1e-9, "{}", first.sentence());
    }
    for o in run_all(&planar(ELLIPTIC, &studies)) {
        assert!(findings(&o, "unstable").is_empty(), "{}", o.kind);
    }
    // without damping rounding is no growth
    for o in run_all(&planar("kxx = 1e5\nkyy = 1e5", &studies)) {
        assert!(findings(&o, "unstable").is_empty(), "{}", o.kind);
    }
}

#[test]
fn a_window_of_a_machine_that_diverges_names_the_instability_first() {
    let o = &run_all(&planar(
        "kxx = -1\nkyy = 1e5\ncxx = 1\ncyy = 1",
        "study = [{ kind = \"operating_window\", speed = { from = 10, to = 2000 } }]",
    ))[0];
    let growth = 0.5 * (5f64.sqrt() - 1.0);
    assert!(o.findings[0].id == "unstable" && (o.findings[0].value.unwrap() / growth - 1.0).abs() < 1e-9, "{}", o.findings[0].sentence());
}

/// The same rotor described from two reference points has the same modes, and the same share of tilting in each.
#[test]
fn the_share_of_tilting_does_not_depend_on_the_reference_point() {
    let machine = |d: f64| {
        format!(
            "study = [{{ kind = \"modes\" }}]\n[machine]\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 8\ndiametral_inertia = 0.05\npolar_inertia = 0.03\n\
             centre_of_mass = {d}\n[[part]]\nkind = \"bearing_linear\"\nname = \"u\"\nbetween = [{{ body = \"d\", at = {} }}, \"ground\"]\nkxx = 4e5\nkyy = 5e5\ncxx = 20\ncyy = 20\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"l\"\nbetween = [{{ body = \"d\", at = {} }}, \"ground\"]\nkxx = 1e5\nkyy = 2e5\ncxx = 20\ncyy = 20\n",
            d + 0.1,
            d - 0.15
        )
    };
    let shares = |d: f64| column(&run_all(&machine(d))[0], "modes", "tilt_share");
    let reference = shares(0.0);
    assert!(reference.iter().any(|s| *s > 0.5) && reference.iter().any(|s| *s < 0.5), "{reference:?}");
    for d in [-0.6, 0.3, 2.0] {
        for (a, b) in shares(d).iter().zip(&reference) {
            assert!((a - b).abs() < 1e-9 && (0.0..=1.0).contains(a), "{d}: {a} for {b}");
        }
    }
}

/// A whirl whose growth does not depend on the speed, beside conical modes that do: what differs along it is rounding, and no peak.
#[test]
fn rounding_makes_no_peaks_of_growth() {
    let bearing = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"d\", at = {at} }}, \"ground\"]\nkxx = 4e5\nkyy = 4e5\nkxy = 9e3\nkyx = -9e3\ncxx = 20\ncyy = 20\n"
        )
    };
    let text = format!(
        "study = [{{ kind = \"stability_map\", speed = {{ from = 1, to = 900, points = 300 }} }}]\n[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 8\n\
         diametral_inertia = 0.05\npolar_inertia = 0.08\n{}{}",
        bearing("u", 0.1),
        bearing("l", -0.1)
    );
    let o = &run_all(&text)[0];
    let growth = column(o, "map", "growth");
    assert!(growth.iter().all(|g| *g > 1.0));
    let (speed, peaks) = (column(o, "map", "speed"), column(o, "peaks", "growth"));
    assert!(speed.windows(2).all(|w| w[1] - w[0] > 1e-9 * w[1]));
    let plateau = growth.iter().filter(|g| (**g / growth[0] - 1.0).abs() < 1e-9).count();
    assert!(plateau > 50 && peaks.iter().all(|p| (p / growth[0] - 1.0).abs() > 1e-9), "{plateau} {peaks:?}");
}

#[test]
fn one_speed_is_a_range_of_one() {
    let one = |speed: &str| {
        format!("study = [{{ kind = \"forced_response\", speed = {speed} }}, {{ kind = \"stability_map\", speed = {speed} }}]")
    };
    let three = [one("\"300 rad/s\""), one("300"), one("{ from = 300, to = 300 }"), one("{ from = 300, to = 300, points = 7 }")];
    let all: Vec<Vec<Outcome>> = three.iter().map(|s| run_all(&planar(ELLIPTIC, s))).collect();
    // X = e m w^2/(k - m w^2 + i c w), Y behind it by a quarter turn; the semi-major axis is |X + i Y|/2 + |X - i Y|/2
    let w: f64 = 300.0;
    let axis = |k: f64| c(1e-5 * w * w, 0.0) / c(k - w * w, 5.0 * w);
    let (x, y) = (axis(1e5), axis(2e5) * c(0.0, -1.0));
    let major = 0.5 * ((x + y * c(0.0, 1.0)).abs() + (x - y * c(0.0, 1.0)).abs());
    for outcomes in &all {
        let (response, map) = (&outcomes[0], &outcomes[1]);
        assert_eq!((column(response, "response", "speed"), column(map, "map", "speed")), (vec![w], vec![w]));
        assert!((column(response, "response", "amplitude.d")[0] / major - 1.0).abs() < 1e-9);
        assert!((finding(response, "amplitude").value.unwrap() / major - 1.0).abs() < 1e-9);
        assert!(findings(response, "no_resonance").is_empty() && findings(map, "unstable_range").is_empty());
        // one speed makes no curve: orbits alone are drawn
        assert!(response.figures.iter().all(|f| f.tiles.is_some()) && map.figures.is_empty());
        assert!((finding(map, "stable").value.unwrap() + 2.5).abs() < 1e-9);
    }
    // where one speed has no answer the refusal says how to write a range
    let refused = laval::file::load(&planar(ROUND, "study = [{ kind = \"campbell\", speed = 300 }]")).err().unwrap();
    assert!(refused.0[0].code == "study.range" && refused.0[0].help.as_deref().is_some_and(|h| h.contains("from")), "{refused:?}");
}

/// The orbit of a round machine is a circle, whose axis has no direction: then there is no column of directions.
#[test]
fn no_column_is_without_a_value() {
    let range = "speed = { from = 10, to = 2000, points = 30 }";
    let kinds = ["forced_response", "critical_speeds", "campbell", "stability_map"];
    let list: Vec<String> = kinds.iter().map(|k| format!("{{ kind = \"{k}\", {range} }}")).collect();
    let studies = format!("study = [{{ kind = \"modes\" }}, {}]", list.join(", "));
    for bearing in [ROUND, ELLIPTIC, "kxx = 1e5\nkyy = 1e5"] {
        for o in run_all(&planar(bearing, &studies)) {
            for (t, c) in o.tables.iter().flat_map(|t| t.columns().iter().map(move |c| (t.name(), c))) {
                let empty = matches!(&c.data, Data::Float(v) if !v.is_empty() && v.iter().all(|x| x.is_nan()));
                assert!(!empty || c.doc.to_string().contains("NaN where it has no bound"), "{} {t} {}: {bearing}", o.kind, c.name);
            }
        }
    }
    let direction = |bearing| run_all(&planar(bearing, &studies))[1].find_table("response").unwrap().column("direction.d").is_some();
    assert!(!direction(ROUND) && direction(ELLIPTIC));
}

/// A liquid whose waves grow slowly: such a mode is not called stable, and what is said of roots that were not computed is what follows for the machine.
#[test]
fn a_mode_that_grows_is_not_stable() {
    let text = include_str!("machines/pancake_of_oil.toml");
    let o = &run_all(text)[0];
    let (growth, frequency, error, stable) =
        (column(o, "modes", "growth"), column(o, "modes", "frequency"), column(o, "modes", "error"), flags(o, "modes", "stable"));
    let size = growth.iter().zip(&frequency).map(|(g, f)| g.hypot(*f)).fold(0.0, f64::max);
    for k in 0..growth.len() {
        let rounding = error[k].max(1e-13 * size);
        assert!(growth[k].abs() <= rounding || stable[k] == (growth[k] < 0.0), "{} {}", growth[k], stable[k]);
    }
    assert!(growth.iter().any(|g| *g > 1e-9), "{growth:?}");
    assert!(findings(o, "unstable_mode").is_empty() && findings(o, "stable").is_empty());
    let place = |id: &str| o.findings.iter().position(|f| f.id == id).unwrap_or_else(|| panic!("no {id}"));
    let slow = &o.findings[place("slow_growth")];
    let first = growth.iter().zip(&stable).position(|(_, s)| !s).expect("a mode that grows") + 1;
    assert!(slow.level == Level::Warning && slow.number("slower") == Some(1.0) && slow.number("mode") == Some(first as f64), "{slow:?}");
    assert!(slow.sentence().contains(&format!("mode {first} grows more slowly")), "{}", slow.sentence());
    // growth is said first, and no mode is the least damped of all
    assert_eq!(place("slow_growth"), 0);
    let least = finding(o, "least_damped_mode").sentence();
    assert!(least.starts_with("Least damped of the decaying modes"), "{least}");
    assert_eq!(finding(o, "roots_missed").level, Level::Info);
}

/// Balls on a rotor that lies in bearings with two stiffnesses: neither rest nor a state that turns exists, and no study sends to the other.
#[test]
fn advice_does_not_lead_in_circles() {
    let machine = |axis: &str, kyy: &str, study: &str| {
        format!(
            "study = [{{ {study} }}]\n[machine]\nspeed = \"1200 rpm\"\naxis = \"{axis}\"\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 35\nunbalance = 0.06\npolar_inertia = 1.1\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"drum\", \"ground\"]\nkxx = 8000\nkyy = {kyy}\ncxx = 150\ncyy = 150\n\
             [[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"drum\"\nballs = 3\nball_mass = 0.03\ntrack_radius = 0.24\nball_radius = 0.0095\ndrag = 5e-3\n\
             contact_stiffness = 1e6\ngravity = 0\n"
        )
    };
    let studies = ["kind = \"modes\"", "kind = \"modes\", about = \"turning\"", "kind = \"stationary\", speed = { from = 10, to = 100 }"];
    for study in studies {
        let refusals = load(&machine("horizontal", "10000", study)).refusals();
        let help = refusals[0].diagnostic.help.as_ref().map_or_else(String::new, |h| h.to_string());
        assert!(!help.contains("about") && !help.contains("stationary") && help.contains("transient"), "{study}: {help}");
    }
    assert!(load(&machine("horizontal", "10000", "kind = \"transient\", duration = 0.01")).refusals().is_empty());
    // where nothing has a preferred direction stationary states exist
    let refusals = load(&machine("vertical", "8000", studies[0])).refusals();
    assert!(refusals[0].diagnostic.help.as_deref().is_some_and(|h| h.contains("stationary")), "{:?}", refusals[0].diagnostic);
    assert!(load(&machine("vertical", "8000", studies[2])).refusals().is_empty());
    // the spin is free: neither a range of speeds nor a programme
    let free = |study: &str| machine("vertical", "8000", study).replace("[machine]\n", "[machine]\ndrive = \"free\"\n");
    let refusals = load(&free(studies[0])).refusals();
    let help = refusals[0].diagnostic.help.as_ref().map_or_else(String::new, |h| h.to_string());
    assert!(help.contains("transient") && !help.contains("stationary") && !help.contains("run_up"), "{help}");
    assert!(!load(&free(studies[2])).refusals().is_empty() && load(&free("kind = \"transient\", duration = 0.01")).refusals().is_empty());
}

/// `about = "turning"` is advised where it is admitted: never of balls that the unbalance pushes nowhere, or where Newton's method has no state.
#[test]
fn about_turning_is_advised_only_where_it_works() {
    let machine = |unbalance: &str, balls: usize, study: &str| {
        format!(
            "study = [{{ {study} }}]\n[machine]\nspeed = \"1200 rpm\"\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 35\n{unbalance}polar_inertia = 1.1\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"drum\", \"ground\"]\nkxx = 8000\nkyy = 8000\ncxx = 150\ncyy = 150\n\
             [[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"drum\"\nballs = {balls}\nball_mass = 0.03\ntrack_radius = 0.24\nball_radius = 0.0095\ndrag = 5e-3\n\
             contact_stiffness = 1e6\n"
        )
    };
    let ranged = ", speed = { from = 10, to = 100 }";
    let mut outcomes = [0, 0];
    for unbalance in ["", "unbalance = 0.06\n"] {
        for balls in [1, 2, 5] {
            for (kind, range) in [("modes", ""), ("stability_map", ranged)] {
                let study = format!("kind = \"{kind}\"{range}");
                let refusals = load(&machine(unbalance, balls, &study)).refusals();
                let help = refusals[0].diagnostic.help.as_ref().map_or_else(String::new, |h| h.to_string());
                let turning = load(&machine(unbalance, balls, &format!("{study}, about = \"turning\""))).refusals();
                assert_eq!(help.contains("about"), turning.is_empty(), "{balls} {study}: {help}, {turning:?}");
                outcomes[usize::from(turning.is_empty())] += 1;
                // and what is advised when it is refused works
                for r in &turning {
                    let help = r.diagnostic.help.as_ref().map_or_else(String::new, |h| h.to_string());
                    assert!(help.contains("stationary") && !help.contains("about"), "{help}");
                }
            }
        }
    }
    assert!(outcomes[0] > 0, "{outcomes:?}");
}

/// Many modes: colours and names by the direction of whirl, not one each.
#[test]
fn the_legend_of_a_campbell_diagram_stays_short() {
    let discs: String = (0..8)
        .map(|k| {
            let to = if k == 0 { "\"ground\"".to_string() } else { format!("\"d{}\"", k - 1) };
            format!(
                "[[part]]\nkind = \"disc\"\nname = \"d{k}\"\nmass = 1\n[[part]]\nkind = \"bearing_linear\"\nname = \"b{k}\"\nbetween = [\"d{k}\", {to}]\n\
                 kxx = 1e6\nkyy = 1e6\ncxx = 3\ncyy = 3\nkxy = {}\nkyx = {}\n",
                100 * k,
                -100 * k
            )
        })
        .collect();
    let o =
        &run_all(&format!("study = [{{ kind = \"campbell\", speed = {{ from = 10, to = 900, points = 12 }} }}]\n[machine]\n{discs}"))[0];
    let svg = laval::report::draw(&o.figures[0], &o.tables).unwrap();
    let legend = svg.matches("<g class=\"lg\"").count();
    assert!(o.find_table("modes").unwrap().rows() >= 16 * 12 && (3..=8).contains(&legend), "{legend}");
    for word in ["forward", "backward"] {
        assert!(svg.contains(&format!(">{word}<")), "no {word}");
    }
}

/// One speed in the studies that follow branches: a linear machine has one steady motion there, and the states of a balancer are those of a range about it.
#[test]
fn one_speed_of_branches() {
    let w: f64 = 200.0;
    let o = &run_all(&planar(ROUND, "study = [{ kind = \"nonlinear_response\", speed = 200 }]"))[0];
    let radius = 1e-5 * w * w / (1e5 - w * w).hypot(5.0 * w);
    assert_eq!(o.find_table("motions").unwrap().rows(), 1);
    assert!((finding(o, "steady_motion").value.unwrap() / radius - 1.0).abs() < 1e-9, "{}", finding(o, "steady_motion").sentence());
    assert!((column(o, "motions", "growth")[0] + 2.5).abs() < 1e-6 && o.figures.is_empty());
    let ring = "[[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"d\"\nballs = 2\nball_mass = 0.002\ntrack_radius = 0.05\nball_radius = 0.004\ndrag = 1e-5\n\
                contact_stiffness = 1e4\n";
    let balancer = |speed: &str| format!("{}{ring}", planar(ROUND, &format!("study = [{{ kind = \"stationary\", speed = {speed} }}]")));
    let (one, range) = (&run_all(&balancer("600"))[0], &run_all(&balancer("{ from = 500, to = 600, points = 2 }"))[0]);
    let at = |o: &Outcome| {
        let all = column(o, "states", "unbalance").into_iter().zip(column(o, "states", "speed"));
        let mut own: Vec<f64> = all.filter(|r| r.1 == 600.0).map(|r| r.0).collect();
        own.sort_by(f64::total_cmp);
        own
    };
    let (a, b) = (at(one), at(range));
    assert!(!a.is_empty() && a.len() == b.len() && a.iter().zip(&b).all(|(x, y)| (x - y).abs() < 1e-9 * 1e-4), "{a:?} {b:?}");
    assert_eq!(finding(one, "states").value, Some(a.len() as f64));
    assert!(findings(one, "balanced_stable").is_empty() && one.figures.iter().all(|f| f.name != "states"));
}

/// A range as narrow as the rounding of its ends is refused: no resonance without damping is reported in it.
#[test]
fn a_range_within_rounding_is_refused() {
    let text = "[machine]\nspeed = \"100 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = \"10 kg\"\neccentricity = \"100 um\"\n[[part]]\n\
                kind = \"shaft_lumped\"\nbetween = [\"d\", \"ground\"]\nstiffness = \"1e5 N/m\"\n[[part]]\nkind = \"damper\"\n\
                between = [\"d\", \"ground\"]\ndamping = \"40 N s/m\"\n[[study]]\nkind = \"nonlinear_response\"\n";
    let narrow = laval::file::load(&format!("{text}speed = {{ from = \"50 rad/s\", to = \"50.0000000001 rad/s\" }}\n")).err().unwrap();
    assert!(narrow.0.iter().any(|d| d.code == "study.range" && d.message.contains("too narrow")), "{narrow:?}");
    let one = run_all(&format!("{text}speed = \"50 rad/s\"\n"));
    assert!(!one[0].findings.is_empty());
}

/// A damped body that no stiffness holds has one mode that damping ends and one that nothing returns.
#[test]
fn a_body_without_stiffness_is_not_said_to_lack_damping() {
    let verdict = |joint: &str| {
        let text = format!(
            r#"
            machine = {{ name = "m", speed = "300 rad/s" }}
            part = [{{ kind = "disc", name = "disc", mass = "2 kg" }}, {joint}]
            study = [{{ kind = "modes" }}]
            "#
        );
        let loaded = load(&text);
        let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("modes")).unwrap();
        o.findings.iter().find(|f| f.id == "stable").unwrap().sentence()
    };
    let free = verdict(r#"{ kind = "damper", between = ["disc", "ground"], damping = "40 N s/m" }"#);
    assert!(free.contains("no stiffness holds the machine") && !free.contains("damp"), "{free}");
    let undamped = verdict(r#"{ kind = "shaft_lumped", between = ["disc", "ground"], stiffness = "1e5 N/m" }"#);
    assert!(undamped.contains("zero damping") && !undamped.contains("stiffness"), "{undamped}");
}

/// Balls without a stiffness of their own: linearising about the turning state from the undeflected machine is refused with studies that can.
#[test]
fn modes_about_the_turning_state_of_free_balls_name_a_study_that_finds_it() {
    let text = r#"
        machine = { name = "m", speed = "300 rad/s" }
        part = [
            { kind = "disc", name = "disc", mass = "2 kg", eccentricity = "20 um" },
            { kind = "shaft_lumped", between = ["disc", "ground"], stiffness = "1e5 N/m" },
            { kind = "damper", between = ["disc", "ground"], damping = "40 N s/m" },
            { kind = "balancer_ball", on = "disc", ball_mass = "3 g", track_radius = "80 mm", drag = "2e-3 N m s" },
        ]
        study = [{ kind = "modes", about = "turning" }]
        "#;
    let loaded = load(text);
    let d = loaded.studies[0].study.run(&loaded.system, &Context::quiet("modes")).unwrap_err();
    assert!(d.message.contains("state that turns with the rotor"), "{d}");
    assert!(!d.message.contains("stiffness") && d.help.as_deref().is_some_and(|h| h.contains("stationary")), "{d}");
}

/// A body on a damper alone: `|z| = e W / sqrt(W^2 + (c/m)^2)` goes to zero at standstill, where nothing acts.
#[test]
fn standstill_without_stiffness_is_no_resonance() {
    let (m, c, e) = (3.0, 900.0, 5e-5);
    let text = format!(
        "[machine]\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = {m}\neccentricity = {e:e}\n\
         [[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\ndamping = {c}\n\
         [[study]]\nkind = \"forced_response\"\nspeed = {{ from = 0, to = 1000 }}\n\
         [[study]]\nkind = \"sweep\"\nspeed = {{ from = 100, to = 1000, points = 3 }}\nmost_periods = 20\n"
    );
    let all = run_all(&text);
    assert!(findings(&all[0], "undamped_resonance").is_empty(), "{:?}", all[0].findings);
    let (speed, amplitude) = (column(&all[0], "response", "speed"), column(&all[0], "response", "amplitude.d"));
    assert_eq!(speed[0], 0.0);
    for (w, a) in speed.iter().zip(&amplitude) {
        let known = e * w / w.hypot(c / m);
        assert!((a - known).abs() <= 1e-12 * e, "{w}: {a} {known}");
    }
    // up and down pass the same three speeds
    let none = finding(&all[1], "no_decay");
    assert!(none.value == Some(3.0) && none.number("speeds") == Some(3.0), "{}", none.sentence());
}

/// `|z| = e r^2 / |1 - r^2 + 2 i D r|` beside a stop with a gap: the response that would close it is no small motion about an open gap.
#[test]
fn a_response_that_closes_an_open_gap_is_a_warning() {
    let (m, k, c, e) = (8.0f64, 1e6f64, 150.0, 1e-4);
    let of = |gap: f64, speed: &str| {
        let text = format!(
            "[machine]\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = {m}\neccentricity = {e:e}\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nstiffness = {k:e}\ndamping = {c}\n\
             [[part]]\nkind = \"stop\"\nname = \"st\"\nbetween = [\"d\", \"ground\"]\nstiffness = 1e7\ngap = {gap:e}\n\
             [[study]]\nkind = \"forced_response\"\nspeed = {speed}\n"
        );
        run_all(&text).remove(0)
    };
    let size = |w: f64| e * m * w * w / (k - m * w * w).hypot(c * w);
    let range = "{ from = 100, to = 900 }";
    let o = of(3e-4, range);
    let f = finding(&o, "gap_closes");
    assert!(f.level == Level::Warning && f.sentence().contains("\"st\""), "{}", f.sentence());
    assert!(f.number("gap").is_some_and(|gap| (gap - 3e-4).abs() < 1e-12), "{f:?}");
    // the first of the speeds computed at which the orbit is wider than the gap
    let speed = column(&o, "response", "speed");
    let first = speed.iter().copied().find(|w| size(*w) > 3e-4).unwrap();
    assert!((f.value.unwrap() - first).abs() < 1e-9, "{} {first}", f.sentence());
    assert!(findings(&of(0.1, range), "gap_closes").is_empty());
    assert!(findings(&of(3e-4, "100"), "gap_closes").is_empty());
    let one = of(3e-4, "350");
    let one = finding(&one, "gap_closes");
    assert!(one.value == Some(350.0) && one.sentence().contains("at equilibrium, at 350 rad/s."), "{}", one.sentence());
}

/// At a critical speed there is no distance to it, and no rounding is given as one.
#[test]
fn an_operating_speed_on_a_critical_speed_is_said_to_be_one() {
    let text = |speed: f64| {
        format!(
            "[machine]\nspeed = {speed:e}\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 4\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nstiffness = 4e4\ndamping = 0.4\n\
             [[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = 10, to = 400 }}\n"
        )
    };
    let o = run_all(&text(90.0)).remove(0);
    let critical = finding(&o, "critical_speed").value.unwrap();
    let margin = finding(&o, "margin");
    assert_eq!(margin.message.key, "critical-speeds-small-margin");
    // the nearest of the critical speed and the peak of the response beside it, which are equal to rounding
    assert!((margin.number("critical").unwrap() / critical - 1.0).abs() < 1e-12, "{margin:?}");
    assert!(margin.sentence().starts_with("Separation margin") && margin.sentence().contains('%'), "{}", margin.sentence());
    let o = run_all(&text(critical * (1.0 + 2e-16))).remove(0);
    let margin = finding(&o, "margin");
    assert!(margin.level == Level::Warning && margin.sentence().contains("is a lightly damped 1x critical speed"), "{}", margin.sentence());
    assert!(!margin.sentence().contains('%'), "{}", margin.sentence());
}
