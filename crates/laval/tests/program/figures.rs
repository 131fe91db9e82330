//! What figures and the page must show: narrow ranges, gaps, curves that coincide, modes beside a high one, sentences that studies share.

use crate::common;

use common::Planar;
use laval::model::builder::Builder;
use laval::model::field::{Attach, RangeValue};
use laval::model::part::Link;
use laval::outcome::{Axis, Band, Data, Figure, Finding, Line, Mark, Outcome, Panel, Points, Rule, Table};
use laval::parts::{disc::*, shaft_lumped::*};
use laval::report::{Report, draw, html};
use laval::study::{Context, ErasedStudy, campbell::Campbell, criterion::Criterion, stability_map::StabilityMap, support::About};

/// Path data of the elements of a class.
fn paths<'a>(svg: &'a str, class: &str) -> Vec<&'a str> {
    let of = |tag: &&str| tag.starts_with("path ") && tag.split('"').nth(1).is_some_and(|c| c.split(' ').any(|w| w == class));
    svg.split('<').filter(of).map(|tag| tag.rsplit(" d=\"").next().unwrap().split('"').next().unwrap()).collect()
}

fn map(system: &laval::model::system::System, from: f64, to: f64) -> Outcome {
    let speed = RangeValue { from, to, points: Some(150) };
    StabilityMap { speed, parameter: None, about: About::Rest, criterion: Criterion::Growth, threshold: 0.0, frequency: None }
        .run(system, &Context::quiet("map"))
        .unwrap()
}

/// The band of a foundation is 13 of 50000 rad/s wide: a fifth of a pixel.
#[test]
fn a_narrow_unstable_range_is_seen() {
    let system = Planar { fill: 0.99, chi: 0.0, chi0: 0.0, ..Planar::default() }.build();
    let o = map(&system, 20.0, 50_000.0);
    let svg = draw(&o.figures[0], &o.tables).unwrap();
    let strips = paths(&svg, "strip");
    assert_eq!(strips.len(), 2, "{strips:?}");
    for d in &strips {
        let width: f64 = d.split('h').nth(1).unwrap().split('v').next().unwrap().parse().unwrap();
        assert!(width >= 4.0, "{d}");
    }
    // instability_bands_undamped.csv
    for words in ["unstable 113 to 126.2", "unstable 1972 to 2848"] {
        assert!(svg.contains(words), "no {words}");
    }
}

#[test]
fn the_frequency_of_the_strongest_mode_has_gaps_where_the_mode_changes() {
    let o = map(&Planar { fill: 0.667, ..Planar::default() }.build(), 20.0, 6000.0);
    let t = o.find_table("map").unwrap();
    let (Data::Float(f), Data::Flag(other)) = (&t.column("frequency").unwrap().data, &t.column("other_mode").unwrap().data) else {
        panic!()
    };
    let jumps: Vec<f64> = f.windows(2).zip(&other[1..]).filter(|(_, o)| !**o).map(|(w, _)| (w[1] - w[0]).abs()).collect();
    let largest = jumps.iter().fold(0.0, |m: f64, x| m.max(*x));
    let changes = other.iter().filter(|o| **o).count();
    // 40 rad/s between two speeds
    assert!(changes > 0 && changes < 20 && largest < 120.0, "{changes} {largest}");
    let svg = draw(&o.figures[0], &o.tables).unwrap();
    let pieces = paths(&svg, "s").iter().map(|d| d.matches('M').count()).max().unwrap();
    assert_eq!(pieces, changes + 1);
}

#[test]
fn invalid_parts_are_grey_and_off_the_axis_angles_wrap_and_paths_are_smooth_with_start_and_direction() {
    let rows = 48;
    let turn = |i: usize| i as f64 / rows as f64 * std::f64::consts::TAU;
    let t = Table::new("t", "")
        .float("x", "", "", (0..rows).map(|i| i as f64).collect())
        .float("y", "m", "", (0..rows).map(|i| if i < 10 { 1.0 } else { 1000.0 }).collect())
        .flag("valid", "", (0..rows).map(|i| i < 10).collect())
        .float("angle", "rad", "", (0..rows).map(|i| 3.0 * turn(i)).collect())
        .float("cos", "m", "", (0..rows).map(|i| turn(i).cos()).collect())
        .float("sin", "m", "", (0..rows).map(|i| turn(i).sin()).collect())
        .build()
        .unwrap();
    let drawn = |y: Axis, line: Line| {
        draw(&Figure::new("f", "", "").x(Axis::new("x", "")).panel(Panel::new(y).mark(line)), std::slice::from_ref(&t)).unwrap()
    };
    let svg = drawn(Axis::new("y", "N"), Line::new("t", "x", "y").valid_where("valid"));
    assert!(svg.contains("outside validity") && !svg.contains(">1000<") && paths(&svg, "cm").len() == 2, "{svg}");
    let degrees = Axis::new("angle", "deg").factor(180.0 / std::f64::consts::PI);
    let svg = drawn(degrees, Line::new("t", "x", "angle").wrapped());
    // three turns are cut three times, and no stroke crosses the panel
    assert_eq!(paths(&svg, "s")[0].matches('M').count(), 4, "{svg}");
    let svg = drawn(Axis::new("y", ""), Line::new("t", "cos", "sin").path());
    let all = paths(&svg, "s");
    assert_eq!(all.len(), 3, "the curve, its start, its direction");
    assert!(all[0].matches('L').count() > 3 * (rows - 1), "{}", all[0]);
}

#[test]
fn curves_that_coincide_are_both_seen() {
    let t = Table::new("t", "").float("x", "", "", vec![0.0, 1.0, 0.0, 1.0]).float("y", "", "", vec![0.0, 1.0, 0.0, 1.0]).text(
        "way",
        "",
        ["up", "up", "down", "down"].map(String::from).to_vec(),
    );
    let line = Line::new("t", "x", "y").group("way").nested();
    let f = Figure::new("f", "", "").x(Axis::new("x", "")).panel(Panel::new(Axis::new("y", "")).mark(line));
    let svg = draw(&f, &[t.build().unwrap()]).unwrap();
    let widths: Vec<f64> = svg
        .split("<path class=\"s ")
        .skip(1)
        .map(|p| p.split("stroke-width=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap())
        .collect();
    assert!(widths.len() == 2 && widths[0] >= widths[1] + 2.0, "{widths:?}");
}

/// Two discs, one on a spring ten thousand times as stiff: its mode is a hundred times as high.
#[test]
fn a_high_mode_does_not_press_the_others_together() {
    let link = |body: &str| Link::Between(Attach::on(body), Attach::ground());
    let mut b = Builder::new("two");
    for (body, k) in [("low", 1e6), ("high", 1e10)] {
        let disc = DiscParams::new(1.0);
        let spring = ShaftLumpedParams { stiffness: [k; 2], ..ShaftLumpedParams::new() };
        b = b.part(body, Disc::planar(), disc).part(format!("{body} spring"), ShaftLumped::lateral(link(body)), spring);
    }
    let system = b.build().unwrap();
    let campbell = |to: f64| {
        let speed = RangeValue { from: 10.0, to, points: Some(20) };
        Campbell { speed, orders: vec![1.0], threshold: 0.0, frequency: None, compare: false }
            .run(&system, &Context::quiet("campbell"))
            .unwrap()
    };
    // excited up to 2000 rad/s; the high mode at 1e5 rad/s is said to be outside
    let o = campbell(2000.0);
    let f = &o.figures[0];
    let near = |range: Option<(f64, f64)>, top: f64| range.is_some_and(|(lo, hi)| lo == 0.0 && (hi / top - 1.0).abs() < 1e-9);
    assert!(near(f.panels[0].y.range, 2500.0), "{:?}", f.panels[0].y.range);
    assert!(f.alt.to_string().contains("Above the axis, beyond 2500 rad/s"), "{}", f.alt);
    // the table keeps it
    let Data::Float(all) = &o.find_table("modes").unwrap().column("frequency").unwrap().data else { panic!() };
    assert!(all.iter().any(|f| (f / 1e5 - 1.0).abs() < 1e-9));
    // a range of speeds that ends below every mode shows the lowest
    assert!(near(campbell(100.0).figures[0].panels[0].y.range, 1250.0));
    // and one that reaches the high mode shows all
    assert_eq!(campbell(2e5).figures[0].panels[0].y.range, None);
}

#[test]
fn what_studies_say_in_the_same_words_stands_once() {
    let said = |study: &str| Outcome::new("modes", study).finding(Finding::info("linearised", "Tangent <everywhere>."));
    let own = said("third").finding(Finding::info("own", "Of its own."));
    let report = Report { outcomes: vec![said("first"), said("second"), own], ..Report::default() };
    let page = html(&report).unwrap();
    let summary = page.split("<section class=\"summary\"").nth(1).unwrap().split("</section>").next().unwrap();
    assert_eq!(summary.matches("Tangent").count(), 1, "{summary}");
    let line = summary.lines().find(|l| l.contains("Tangent")).unwrap();
    for study in ["first", "second", "third"] {
        assert!(line.contains(study), "{line}");
    }
    assert!(summary.contains("Of its own."));
    // each study keeps its own
    assert_eq!(page.matches("Tangent").count(), 4);
}

#[test]
fn a_figure_without_anything_to_see_is_left_out() {
    let table = |y: Vec<f64>| Table::new("t", "").float("x", "", "", vec![1.0, 2.0]).float("y", "", "", y).build().unwrap();
    let figures = |y: Vec<f64>, axis: Axis, mark: fn() -> Mark| {
        let panel = Panel::new(axis).mark(mark()).mark(Rule::x(1.5, "operating speed"));
        Outcome::new("modes", "m").table(table(y)).figure(Figure::new("f", "F", "").panel(panel)).checked().unwrap().figures.len()
    };
    let points = || Mark::from(Points::new("t", "x", "y"));
    let line = || Mark::from(Line::new("t", "x", "y"));
    for mark in [points, line] {
        assert_eq!(figures(vec![f64::NAN, 3.0], Axis::new("y", ""), mark), 1);
        assert_eq!(figures(vec![f64::NAN, f64::NAN], Axis::new("y", ""), mark), 0);
        // a logarithmic axis has no place for it
        assert_eq!(figures(vec![0.0, -1.0], Axis::log("y", ""), mark), 0);
    }
    assert_eq!(figures(vec![1.0, 1.0], Axis::new("y", ""), || Line::new("t", "x", "y").reference().into()), 0);
    assert_eq!(figures(vec![1.0, 1.0], Axis::new("y", ""), || Line::new("t", "x", "y").group("y").reference().into()), 1);
    // a range of speeds is something to see
    assert_eq!(figures(vec![f64::NAN, f64::NAN], Axis::new("y", ""), || Band::x(1.0, 2.0).into()), 1);
}
