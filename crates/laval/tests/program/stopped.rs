//! A study that was stopped before its end claims nothing of what it did not reach: no absence, no margin, no end that was not its own.

use crate::common::files::{finding, findings, load};
use laval::outcome::{Arg, End, Level, Message, Outcome};
use laval::study::{Cancel, Context};

/// A disc on a stiffening bearing, whose response peaks and folds between 300 and 600 rad/s.
pub const ROTOR: &str = r#"
[machine]
speed = "300 rad/s"
[[part]]
kind = "disc"
name = "drum"
mass = "2 kg"
eccentricity = "50 um"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "ground"]
law = "isotropic"
stiffness = "2e5 N/m"
cubic_stiffness = "1e11 N/m^3"
[[part]]
kind = "damper"
name = "losses"
between = ["drum", "ground"]
damping = "55 N s/m"
"#;

fn run(machine: &str, study: &str, cancel: &Cancel, work_limit: u64) -> Outcome {
    let l = load(&format!("{machine}\n[[study]]\n{study}"));
    let context = Context { cancel, work_limit, ..Context::quiet("study") };
    l.studies[0].study.run(&l.system, &context).unwrap_or_else(|d| panic!("{d:?}"))
}

fn spent(machine: &str, study: &str) -> u64 {
    let whole = Cancel::default();
    let o = run(machine, study, &whole, u64::MAX);
    assert_eq!(o.end, End::Reached);
    whole.spent()
}

/// All findings as one text.
fn text(o: &Outcome) -> String {
    o.findings.iter().map(|f| f.sentence() + "\n").collect()
}

#[test]
fn a_search_for_further_states_that_was_stopped_shows_no_absence() {
    let main = "kind = \"nonlinear_response\"\nspeed = { from = \"100 rad/s\", to = \"600 rad/s\" }\nharmonics = 3\nstability = false\n";
    let all = format!("{main}states = \"all\"\nstarts = 900\ntime_starts = 100\n");
    let stopped = run(ROTOR, &all, &Cancel::after(spent(ROTOR, main) * 3 / 2), u64::MAX);
    assert_eq!(stopped.end, End::Cancelled, "{}", text(&stopped));
    let limited = run(ROTOR, &all, &Cancel::default(), 2);
    assert_eq!(limited.end, End::WorkLimit, "{}", text(&limited));
    for o in [&stopped, &limited] {
        assert!(findings(o, "further_states").is_empty(), "{}", text(o));
    }
    let f = finding(&stopped, "further_states_unknown");
    let whole = |m: &Message| m.args.iter().any(|a| a.0 == "all-starts" && matches!(a.1, Arg::Count(n) if n > 0 && n % 100 == 0));
    assert!(whole(&f.message) && f.notes.len() == 1 && f.notes.iter().all(whole), "{f:?}");
    assert!(f.sentence().contains("random initial conditions") && f.sentence().contains("in time"), "{}", f.sentence());
    // how many speeds are searched follows from the folds of branches that were not completed
    let f = finding(&limited, "further_states_unknown").sentence();
    assert!(f.contains("was not begun") && !f.contains(|c: char| c.is_ascii_digit()), "{f}");
}

#[test]
fn critical_speeds_that_were_stopped_give_no_verdict_on_the_margin() {
    let machine = |speed: f64| {
        format!(
            r#"
[machine]
speed = {speed}
[[part]]
kind = "disc"
name = "a"
mass = "10 kg"
eccentricity = "10 um"
[[part]]
kind = "disc"
name = "b"
mass = "10 kg"
[[part]]
kind = "bearing_linear"
between = ["a", "ground"]
stiffness = "1e5 N/m"
damping = "10 N s/m"
[[part]]
kind = "bearing_linear"
between = ["b", "ground"]
stiffness = "2.3e7 N/m"
damping = "10 N s/m"
[[part]]
kind = "bearing_linear"
between = ["a", "b"]
stiffness = "1e5 N/m"
damping = "10 N s/m"
"#
        )
    };
    let study = "kind = \"critical_speeds\"\nspeed = { from = 10, to = 3000, points = 40 }\n";
    for speed in [140.0, 1500.0] {
        let whole = run(&machine(speed), study, &Cancel::default(), u64::MAX);
        assert_eq!((whole.end, finding(&whole, "margin").level), (End::Reached, Level::Warning), "{}", text(&whole));
        let part = run(&machine(speed), study, &Cancel::default(), 6);
        let f = finding(&part, "margin");
        assert_eq!((part.end, f.level), (End::WorkLimit, Level::Info), "{}", text(&part));
        assert!(f.sentence().contains("found before the study stopped"), "{}", f.sentence());
        assert!(!finding(&whole, "margin").sentence().contains("stopped"));
    }
}

#[test]
fn sensitivities_that_were_stopped_show_no_absence_of_peaks() {
    let study = "kind = \"sensitivity\"\nspeed = { from = \"100 rad/s\", to = \"600 rad/s\" }\n";
    let limited = run(ROTOR, study, &Cancel::default(), 2);
    let stopped = run(ROTOR, study, &Cancel::after(0), u64::MAX);
    for (o, end) in [(limited, End::WorkLimit), (stopped, End::Cancelled)] {
        assert_eq!(o.end, end, "{}", text(&o));
        assert!(!text(&o).contains("in the speed range"), "{}", text(&o));
    }
}

#[test]
fn a_window_whose_passage_the_work_limit_ends_is_no_mistake() {
    let machine = format!("{ROTOR}[limits]\npassage_displacement = {{ drum = \"1 mm\" }}\n");
    let study = "kind = \"operating_window\"\nspeed = { from = 50, to = 90, points = 5 }\nramp = \"1 s\"\n";
    assert_eq!(run(&machine, study, &Cancel::default(), 2).end, End::WorkLimit);
}

/// The window of the machine itself is complete when its robust window and its map are stopped: it is shown, and they are named.
#[test]
fn a_window_stopped_in_its_later_parts_names_them() {
    let linear = ROTOR
        .replace("bearing_cubic", "bearing_linear")
        .replace("law = \"isotropic\"\n", "")
        .replace("cubic_stiffness = \"1e11 N/m^3\"\n", "");
    let machine = &format!("{linear}[limits]\ndisplacement = \"0.2 mm\"\n");
    let main = "kind = \"operating_window\"\nspeed = { from = 50, to = 900, points = 20 }\n";
    let all = format!(
        "{main}uncertain = {{ drum.mass = 0.1, losses.damping = 0.1 }}\n\
         map = {{ parameter = \"losses.damping\", from = \"40 N s/m\", to = \"80 N s/m\" }}\n"
    );
    let alone = run(machine, main, &Cancel::default(), u64::MAX);
    assert!(findings(&alone, "incomplete").is_empty() && alone.find_table("speeds").is_some(), "{}", text(&alone));
    let whole = run(machine, &all, &Cancel::default(), u64::MAX);
    assert!(whole.end == End::Reached && findings(&whole, "incomplete").is_empty(), "{}", text(&whole));
    let (own, both) = (spent(machine, main), spent(machine, &all));
    let within = |share: f64| Cancel::after(own + ((both - own) as f64 * share) as u64);
    let speeds = alone.work["speeds"];
    for (o, end, robust) in [
        (run(machine, &all, &within(0.03), u64::MAX), End::Cancelled, false),
        (run(machine, &all, &within(0.9), u64::MAX), End::Cancelled, true),
        (run(machine, &all, &Cancel::default(), speeds + 2), End::WorkLimit, false),
    ] {
        assert_eq!(o.end, end, "{}", text(&o));
        let f = finding(&o, "incomplete").sentence();
        assert!(f.contains("the map") && f.contains("the robust window") != robust, "{f}");
        assert_eq!(findings(&o, "robust_window").is_empty(), !robust, "{}", text(&o));
        assert!(o.find_table("map").is_none() && findings(&o, "window").len() == findings(&whole, "window").len(), "{}", text(&o));
    }
}

#[test]
fn an_optimum_that_was_stopped_is_the_best_so_far() {
    let study = r#"kind = "optimum"
study = { kind = "nonlinear_response", speed = { from = "100 rad/s", to = "200 rad/s" }, stability = false }
vary = [{ parameter = "losses.damping", from = "20 N s/m", to = "60 N s/m" }]
minimise = "largest_displacement"
starts = 1
runs = 20
"#;
    let none = run(ROTOR, study, &Cancel::default(), 0);
    assert_eq!(none.end, End::WorkLimit);
    let f = finding(&none, "no_optimum");
    assert!(f.sentence().contains("before the study stopped") && f.number("runs") == Some(0.0), "{f:?}");
    let some = run(ROTOR, study, &Cancel::default(), 2);
    assert_eq!(some.end, End::WorkLimit);
    assert!(!text(&some).contains("Recommended"), "{}", text(&some));
    for id in ["optimum", "recommended"] {
        let f = finding(&some, id).sentence();
        assert!(f.contains("before the study stopped"), "{f}");
    }
}

#[test]
fn states_at_rest_are_counted_up_to_the_stop() {
    let study = "kind = \"stationary\"\nspeed = { from = 300, to = 600 }\nstarts = 20\nseeds = 2\n";
    let o = run(ROTOR, study, &Cancel::default(), 0);
    assert_eq!(o.end, End::WorkLimit);
    let f = finding(&o, "completeness").sentence();
    assert!(f.contains("found before the study stopped"), "{f}");
}

#[test]
fn loci_that_were_stopped_show_no_absence() {
    let study = r#"kind = "bifurcation_loci"
speed = { from = "100 rad/s", to = "600 rad/s" }
parameter = { parameter = "drum.eccentricity", from = "20 um", to = "80 um", points = 2 }
harmonics = 3
"#;
    let o = run(ROTOR, study, &Cancel::default(), 0);
    assert_eq!(o.end, End::WorkLimit);
    let f = finding(&o, "no_locus").sentence();
    assert!(f.contains("before the study stopped") && !f.contains("raise points"), "{f}");
    for after in [0, 20_000, 200_000] {
        let o = run(ROTOR, study, &Cancel::after(after), u64::MAX);
        assert_eq!(o.end, End::Cancelled);
        assert!(findings(&o, "no_response").is_empty() && !text(&o).contains("raise points"), "{}", text(&o));
        for f in ["folds_from", "widest_hysteresis"].iter().flat_map(|id| findings(&o, id)) {
            assert!(f.sentence().contains("The study was stopped"), "{}", f.sentence());
        }
    }
}
