//! Basins of the planar balancer with two balls: against a table, and motions recognised before their end against motions followed to it.

use crate::common;

use common::{number, rows};
use laval::file::load;
use laval::outcome::{Data, End, Outcome};
use laval::study::Context;

fn planar(speed: f64, study: &str) -> String {
    format!(
        "[machine]\nname = \"planar\"\nspeed = {speed}\n\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 1\neccentricity = 0.01\n\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1\n\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 0.02\n\n\
         [[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"disc\"\nballs = 2\nbody_tilt = false\ngravity = 0\nball_mass = 0.05\n\
         track_radius = 1\ndrag = 0.0005\n\n[[study]]\nkind = \"basins\"\n{study}\n"
    )
}

fn plane(from: [f64; 2], to: [f64; 2], points: usize, more: &str) -> String {
    let ends = |x: [f64; 2]| format!("{{ \"ring.ball_1\" = \"{:.8} rad\", \"ring.ball_2\" = \"{:.8} rad\" }}", x[0], x[1]);
    format!("from = {}\nto = {}\npoints = {points}\n{more}", ends(from), ends(to))
}

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("b")).unwrap_or_else(|d| panic!("{d:?}"));
    assert_eq!(o.end, End::Reached);
    o
}

fn words(o: &Outcome, table: &str, column: &str) -> Vec<String> {
    match &o.find_table(table).unwrap().column(column).unwrap().data {
        Data::Text(v) => v.clone(),
        _ => panic!("{column} is no text"),
    }
}

fn reported(o: &Outcome) {
    o.findings.iter().for_each(|f| println!("    {}", f.sentence()));
    println!("    {:?}", o.work);
}

/// A cell one of whose neighbours on a square grid ends elsewhere; the grid closes on itself where it spans the turn.
fn at_a_border(ends: &[String], width: usize, k: usize, closed: bool) -> bool {
    let (i, j) = (k % width, k / width);
    let step = |x: usize, d: isize| {
        let y = x as isize + d;
        if closed { Some(y.rem_euclid(width as isize) as usize) } else { usize::try_from(y).ok().filter(|y| *y < width) }
    };
    let around = (-1..=1).flat_map(|a| (-1..=1).map(move |b| (a, b)));
    around.filter_map(|(a, b)| Some((step(i, a)?, step(j, b)?))).any(|(a, b)| ends[b * width + a] != ends[k])
}

/// 144 starts at three speeds. Starts with both balls at one angle stay together by symmetry, but for rounding: they are left out.
#[test]
fn starts_of_the_table_end_where_it_says() {
    let table = rows(include_str!("../reference/balancer/planar_basin.csv"));
    assert_eq!(table.len(), 432);
    for speed in [2.0, 2.5, 3.0] {
        let own: Vec<&Vec<&str>> = table.iter().filter(|r| number(r[0]) == speed).collect();
        let ends = [number(own[0][1]), number(own[143][1])];
        let o = run(&planar(speed, &plane([ends[0]; 2], [ends[1]; 2], 12, "relative_tolerance = 1e-11")));
        reported(&o);
        let found = words(&o, "cells", "end");
        // the first angle of the table runs slowest
        let at = |k: usize| found[(k % 12) * 12 + k / 12].clone();
        let (mut differ, mut balanced, mut compared, mut theirs) = (0, 0, 0, 0);
        for (k, row) in own.iter().enumerate().filter(|(k, _)| k % 12 != k / 12) {
            compared += 1;
            let ours = at(k) == "balanced";
            balanced += usize::from(ours);
            theirs += usize::from(row[4] == "balanced");
            if ours != (row[4] == "balanced") {
                differ += 1;
                let (i, j) = (k / 12, k % 12);
                assert!(at_a_border(&found, 12, j * 12 + i, true), "{row:?}: {}", at(k));
            }
        }
        println!("{speed}: {differ} of {compared} differ, {balanced} balanced, {theirs} in the table");
        // starts near borders depend on the integrator: the table says so of itself
        assert!(balanced.abs_diff(theirs) <= 5, "{speed}: {balanced} {theirs}");
        assert!(!found.iter().any(|f| f == "not settled" || f == "failed"), "{found:?}");
        // exchanging the balls changes nothing where they do not move chaotically first
        let unlike = (0..144).filter(|k| found[*k] != found[(k % 12) * 12 + k / 12]).count();
        assert!(speed != 2.0 || unlike <= 4, "{speed}: {unlike}");
    }
}

/// Of 4356 starts recognised before their end, 196 on a grid that lies in theirs are followed to the end by the same steps: they agree but for starts at borders. (Where the
/// balls first move chaotically, as at a speed of 2.5, other tolerances lead a sixth of the starts elsewhere: that is not what is requested here.)
#[test]
fn motions_reported_early_end_there() {
    let ends = |points: usize, more: &str| {
        let o = run(&planar(2.0, &plane([-3.1, -3.0], [3.1, 3.05], points, more)));
        reported(&o);
        (words(&o, "cells", "end"), o)
    };
    let (early, o) = ends(66, "check = 300");
    let (full, _) = ends(14, "recognise = \"never\"");
    // ends of one kind are numbered as they were met
    // and motions that few starts show beforehand have no name in a small map
    let kind = |w: &String| if w.contains("balanced") || w.contains("Balanced") { "balanced" } else { "elsewhere" };
    let same = |k: usize| (k / 14) * 5 * 66 + (k % 14) * 5;
    let wrong: Vec<usize> = (0..196).filter(|&k| kind(&early[same(k)]) != kind(&full[k])).collect();
    let finding = o.findings.iter().find(|f| f.id == "recognition").unwrap();
    println!("{} of 196 differ: {wrong:?}", wrong.len());
    assert!(finding.value.unwrap() > 0.9 * early.len() as f64, "{}", finding.sentence());
    assert!(finding.evidence.iter().any(|e| e.what == "concluded wrongly" && e.value <= 2.0), "{finding:?}");
    assert!(wrong.len() <= 2, "{wrong:?}");
    for k in wrong {
        assert!(at_a_border(&early, 66, same(k), false), "{k}: {} {}", early[same(k)], full[k]);
    }
    // cells that the study itself follows to their ends agree as well
    let agreement = o.findings.iter().find(|f| f.id == "agreement").unwrap();
    let of = |what: &str| agreement.evidence.iter().find(|e| e.what == what).unwrap().value;
    let followed = of("cells followed");
    assert!(followed > 250.0 && followed <= 300.0, "{followed}");
    assert!(of("end elsewhere") <= 3.0 && of("of them with no neighbour that does") == 0.0, "{}", agreement.sentence());
    assert_eq!(agreement.value.unwrap() + of("end elsewhere"), followed);
    assert_eq!(o.find_table("disagreements").unwrap().rows() as f64, of("end elsewhere"));
    // what does not settle is counted
    let unsettled = early.iter().filter(|e| *e == "not settled").count() as f64;
    assert_eq!(o.findings.iter().find(|f| f.id == "not_settled").map_or(0.0, |f| f.value.unwrap()), unsettled);
    assert!(unsettled < 0.02 * early.len() as f64 && !early.iter().any(|e| e == "failed"));
}

/// Slow and fast run-ups end in different states; a run-up needs masses that move.
#[test]
fn run_ups_lead_to_states_too() {
    let study = "from = { \"ring.ball_1\" = -2.0 }\nto = { \"ring.ball_1\" = 2.0 }\npoints = 3\nrun_up = { from = 5, to = 400, points = 3 }\ninitial = { \"ring.ball_2\" = 0.4 }";
    let o = run(&planar(3.0, study));
    reported(&o);
    let table = o.find_table("cells").unwrap();
    let durations: Vec<f64> = (0..9).map(|r| table.column("y").unwrap().number(r).unwrap()).collect();
    assert_eq!(durations, [5.0, 5.0, 5.0, 202.5, 202.5, 202.5, 400.0, 400.0, 400.0]);
    assert!(words(&o, "cells", "end").iter().all(|e| e != "failed" && e != "not settled"));
    let free = planar(3.0, study);
    let balls = free.find("[[part]]\nkind = \"balancer_ball\"").unwrap();
    let rest = free.find("[[study]]").unwrap();
    let bare = format!("{}{}", &free[..balls], &free[rest..]).replace("ring.ball_1", "disc.x").replace("ring.ball_2", "disc.y");
    let said = load(&bare).err().unwrap();
    assert!(said.0.iter().any(|d| d.code == "basins.run_up"), "{said:?}");
}

/// A machine that prefers a direction has no state at rest in turning axes: it is settled as any other.
#[test]
fn a_preferred_direction_is_left_to_the_ordinary_way() {
    let study = plane([-1.0, 0.5], [1.0, 1.5], 2, "most_periods = 100");
    let o = run(&planar(2.5, &study).replace("stiffness = 1\n", "stiffness = { x = 1, y = 1.5 }\n"));
    assert!(o.find_table("poincare").is_some());
}
