//! One speed where a range is usual: the same numbers as of a range at that speed, or the study that answers at one speed.

use laval::file::load;
use laval::outcome::{Outcome, Table};
use laval::study::Context;

const MACHINE: &str = "[machine]\nSPEED\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\neccentricity = \"20 um\"\n\
    [[part]]\nkind = \"bearing_cubic\"\nname = \"b\"\nbetween = [\"d\", \"ground\"]\nstiffness = \"2e5 N/m\"\ncubic_stiffness = \"1e13 N/m^3\"\nlaw = \"per_axis\"\n\
    [[part]]\nkind = \"damper\"\nname = \"losses\"\nbetween = [\"d\", \"ground\"]\ndamping = 60\n";

fn run(speed: &str, study: &str) -> Outcome {
    let loaded = load(&format!("{}[[study]]\n{study}\n", MACHINE.replace("SPEED", speed))).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("speed")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn column(t: &Table, name: &str) -> Vec<f64> {
    let c = t.column(name).unwrap_or_else(|| panic!("no column {name}"));
    (0..t.rows()).map(|i| c.number(i).unwrap_or(f64::NAN)).collect()
}

fn near(found: &[f64], known: &[f64], relative: f64) {
    assert!(!known.is_empty() && found.len() == known.len(), "{found:?} {known:?}");
    for (a, b) in found.iter().zip(known) {
        assert!((a - b).abs() <= relative * b.abs() || (a.is_nan() && b.is_nan()), "{found:?} {known:?}");
    }
}

#[test]
fn methods_and_maps_at_one_speed() {
    let range = run("", "kind = \"methods\"\nspeed = { from = 240, to = 360, points = 3 }\nharmonics = 3");
    let one = run("", "kind = \"methods\"\nspeed = 300\nharmonics = 3");
    let (all, own) = (range.find_table("methods").expect("methods"), one.find_table("methods").expect("methods"));
    let rows: Vec<usize> = (0..all.rows()).filter(|&k| (column(all, "speed")[k] - 300.0).abs() < 1e-9).collect();
    for name in ["d largest x", "d converged"] {
        let whole = column(all, name);
        near(&column(own, name), &rows.iter().map(|&k| whole[k]).collect::<Vec<f64>>(), 1e-5);
    }
    assert!(one.figures.is_empty());
    let map = "kind = \"motion_map\"\nx = { parameter = \"d.eccentricity\", from = \"10 um\", to = \"20 um\", points = 2 }\n\
               y = { parameter = \"losses.damping\", from = 60, to = 90, points = 2 }";
    let [own, of_machine] = [run("", &format!("{map}\nspeed = 300")), run("speed = 300", map)];
    let amplitude = |o: &Outcome| column(o.find_table("map").expect("a map"), "amplitude.d");
    near(&amplitude(&own), &amplitude(&of_machine), 0.0);
}

/// What a range of speeds is for has no answer at one: the message names the study that has.
#[test]
fn a_range_that_is_one_speed_is_refused_with_a_way_out() {
    for (kind, way) in [("campbell", "modes"), ("sweep", "nonlinear_response"), ("critical_speeds", "forced_response")] {
        let text = format!("{}[[study]]\nkind = \"{kind}\"\nspeed = \"3000 rpm\"\n", MACHINE.replace("SPEED", ""));
        let wrong = load(&text).err().unwrap_or_else(|| panic!("{kind} takes one speed"));
        let d = &wrong.0[0];
        assert!(d.code == "study.range" && d.span.is_some() && d.help.as_deref().is_some_and(|h| h.contains(way)), "{d:?}");
    }
}
