use super::*;
use crate::outcome::{Axis, Heat, Line, Points, Rule};

fn scene_of(f: &Figure, tables: &[Table]) -> Result<Scene, OutcomeError> {
    Scene::new(f, tables, &Style::default())
}

fn scene(y: Axis, ys: Vec<f64>) -> Scene {
    let n = ys.len();
    let t = Table::new("t", "").float("x", "", "", (0..n).map(|i| i as f64).collect()).float("y", "m", "", ys).build().unwrap();
    let f = Figure::new("f", "", "").x(Axis::new("x", "")).panel(Panel::new(y).mark(Line::new("t", "x", "y")).mark(Rule::x(99.0, "far")));
    scene_of(&f, &[t]).unwrap()
}

#[test]
fn factor_scales_and_rules_do_not_stretch_x() {
    let s = scene(Axis::new("y", "mm").factor(1e3), vec![0.001, 0.002, 0.003]);
    assert!((s.panels[0].y.hi - 3.1).abs() < 1e-9 && s.panels[0].y.lo == 0.0);
    assert_eq!((s.x.lo, s.x.hi), (0.0, 2.0));
}

#[test]
fn ranges_are_never_degenerate() {
    for ys in [vec![], vec![f64::NAN; 3], vec![5.0; 3], vec![0.0; 3], vec![-1.0, f64::INFINITY, 2.0]] {
        for y in [Axis::new("y", ""), Axis::log("y", "")] {
            let s = scene(y, ys.clone());
            assert!(s.panels[0].y.hi > s.panels[0].y.lo && s.x.hi > s.x.lo);
            assert!(s.panels[0].y.lo.is_finite() && s.panels[0].y.hi.is_finite());
        }
    }
}

#[test]
fn unstable_pieces_are_dashed_and_share_their_end_points() {
    let rows = [0, 1, 2, 3, 4];
    let (full, dashed) = split(&rows, |i| (i as f64, 0.0), &[true, true, false, true, true], None);
    assert_eq!(full.iter().filter(|p| p.0.is_finite()).map(|p| p.0).collect::<Vec<_>>(), [0.0, 1.0, 3.0, 4.0]);
    assert_eq!(dashed.iter().map(|p| p.0).collect::<Vec<_>>(), [1.0, 2.0, 3.0]);
}

/// Words of a map have the colours of their places in its list, whatever stands beside it and whichever occur; the legend names those that occur.
#[test]
fn words_keep_their_colours() {
    let list: Vec<String> = ["a", "b", "c"].map(String::from).to_vec();
    let colours = |words: [&str; 2], beside: bool| {
        let text = words.map(String::from).to_vec();
        let t = Table::new("t", "")
            .float("x", "", "", vec![0.0, 1.0])
            .float("y", "", "", vec![0.0, 1.0])
            .text("word", "", text)
            .build()
            .unwrap();
        let first = Panel::new(Axis::new("y", "")).mark(Points::new("t", "x", "y").group("word"));
        let map = Panel::new(Axis::new("y", "")).mark(Heat::new("t", "x", "y", "word", Axis::new("", "")).of_classes(list.clone()));
        let f = Figure::new("f", "", "").x(Axis::new("x", ""));
        let f = if beside { f.panel(first).panel(map) } else { f.panel(map) };
        let s = scene_of(&f, &[t]).unwrap();
        let heat = s.panels.last().unwrap().heat.clone().unwrap();
        let named: Vec<String> =
            s.legend.iter().filter(|e| matches!(e.glyph, Glyph::Marker { shape: 1, .. })).map(|e| e.label.clone()).collect();
        (heat.classes, named)
    };
    let (both, named) = colours(["a", "c"], false);
    assert_eq!(both.iter().map(|c| c.1).collect::<Vec<_>>(), [0, 1, 2].map(Colour::Slot));
    assert_eq!(named, ["a", "c"]);
    assert_eq!(colours(["c", "b"], true).0, both);
    // of many words the later share the ramp, each with a tone of its own
    let many: Vec<String> = (0..12).map(|k| format!("w{k}")).collect();
    let mut build =
        Build { figure: &Figure::new("f", "", ""), tables: &[], style: &Style::default(), legend: vec![], names: vec![], tints: 0 };
    let seen: Vec<bool> = (0..12).map(|k| k != 7).collect();
    let found = build.classes(&many, &seen);
    assert_eq!(found[5].1, Colour::Slot(5));
    let tones: Vec<Colour> = found.iter().zip(&seen).skip(6).filter(|f| *f.1).map(|f| f.0.1).collect();
    assert!(tones.len() == 5 && tones.windows(2).all(|w| w[0] != w[1]), "{tones:?}");
}

/// A phase that falls through a resonance goes on; one that jumps by half a turn stays near the lag of a resonance.
#[test]
fn angles_go_on_without_jumps() {
    let mut v = vec![-10.0, -90.0, -170.0, 110.0, f64::NAN, 20.0, 10.0];
    let rows: Vec<usize> = (0..v.len()).collect();
    unwrap(&mut v, &rows, 360.0);
    assert_eq!([v[3], v[5], v[6]], [-250.0, -340.0, -350.0]);
    let mut v = vec![0.0, 180.0, 0.0, -180.0];
    unwrap(&mut v, &[0, 1, 2, 3], 360.0);
    assert_eq!(v, [0.0, -180.0, 0.0, -180.0]);
}

#[test]
fn names_stand_at_the_places_of_an_axis() {
    let names = vec![(1.0, "a <b>".into()), (2.0, "c".into()), (9.0, "outside".into())];
    let s = scene(Axis::new("y", "").range(0.4, 2.6).names(names), vec![1.0, 2.0]);
    assert_eq!(s.panels[0].y.ticks(5).major, [(1.0, "a <b>".to_string()), (2.0, "c".to_string())]);
}

/// A reserve of 0.9 beside a growth of 200 has its own part of the axis, and of its ticks.
#[test]
fn a_knee_shows_what_is_small() {
    let y = scene(Axis::new("y", "").knee(0.1), vec![-0.9, 2.7, 200.0]).panels.remove(0).y;
    assert!(y.place(0.0) - y.place(-0.9) > 0.2, "{}", y.place(0.0) - y.place(-0.9));
    assert!(y.place(y.lo).abs() < 1e-12 && (y.place(y.hi) - 1.0).abs() < 1e-12 && y.lo > -2.0);
    let ticks: Vec<f64> = y.ticks(6).major.iter().map(|t| t.0).collect();
    assert!(ticks.contains(&0.0) && ticks.contains(&100.0) && ticks.iter().any(|t| *t < 0.0), "{ticks:?}");
    assert!(ticks.windows(2).all(|w| y.place(w[1]) - y.place(w[0]) > 0.08), "{ticks:?}");
}

#[test]
fn labels_of_rules_have_the_unit_of_the_axis() {
    let t = Table::new("t", "").float("x", "", "", vec![0.0, 1.0]).float("y", "", "", vec![0.0, 1.0]).build().unwrap();
    let panel = Panel::new(Axis::new("y", "")).mark(Line::new("t", "x", "y")).mark(Rule::x(0.25, "unstable").between(0.25, 0.5));
    let f = Figure::new("f", "", "").x(Axis::new("x", "").factor(100.0)).panel(panel);
    assert_eq!(scene_of(&f, &[t]).unwrap().panels[0].rules[0].label, "unstable 25 to 50");
}

/// What is forbidden is hatched, and does not differ from what is allowed by its colour alone.
#[test]
fn forbidden_cells_are_hatched() {
    let t = Table::new("t", "")
        .float("x", "", "", vec![0.0, 1.0, 0.0, 1.0])
        .float("y", "", "", vec![0.0, 0.0, 1.0, 1.0])
        .float("v", "", "", vec![-1.0, 1.0, -1.0, f64::NAN])
        .build()
        .unwrap();
    let heat = Heat::new("t", "x", "y", "v", Axis::new("", "")).allowed();
    let f = Figure::new("f", "", "").x(Axis::new("x", "")).panel(Panel::new(Axis::new("y", "")).mark(heat));
    let s = scene_of(&f, std::slice::from_ref(&t)).unwrap();
    let heat = s.panels[0].heat.as_ref().unwrap();
    assert_eq!(heat.forbidden(&s.x, &s.panels[0].y, 100.0, 100.0).matches('M').count(), 2);
    assert_eq!((heat.colour(0.0), heat.colour(1.0)), ("#e08a5c".into(), "#00805e".into()));
    assert!(crate::report::draw(&f, &[t]).unwrap().contains("class=\"hatch\""));
}

/// A reader of another language sees the words that its catalogue has, its decimal comma and its units; names of the machine file stay as they are.
#[test]
fn a_figure_is_in_the_words_of_the_reader() {
    let t = Table::new("t", "")
        .float("x", "rad/s", "", vec![0.0, 1.0])
        .float("y", "m", "", vec![0.5, 2.0])
        .names("body", "", vec!["forward".into(); 2])
        .build()
        .unwrap();
    let russian = Style { language: crate::report::Language::Russian, ..Style::default() };
    let panel =
        Panel::new(Axis::new("y", "m")).mark(Points::new("t", "x", "y").group("body")).mark(Rule::x(0.5, "balanced").between(0.25, 0.5));
    let f = Figure::new("f", "", "").x(Axis::new("x", "rad/s")).panel(panel);
    let s = Scene::new(&f, &[t], &russian).unwrap();
    assert_eq!((s.x.title(), s.panels[0].y.title()), ("x [рад/с]".into(), "y [м]".into()));
    assert!(s.x.ticks(5).major.iter().any(|t| t.1 == "0,5"));
    assert_eq!(s.legend[0].label, "forward");
    assert!(s.panels[0].rules[0].label.starts_with("уравновешено") && s.panels[0].rules[0].label.contains("0,25"));
}

/// A logarithmic axis shows the decades in which a curve is: not a single minimum far below, and every other curve with its largest values.
#[test]
fn logarithmic_axes_show_the_decades_that_matter() {
    let deep = |floor: f64| {
        (0..101).map(|k| if k == 50 { floor } else { 10f64.powf(-2.0 * f64::from((k - 50i32).abs()) / 50.0) }).collect::<Vec<f64>>()
    };
    let decades = |s: &Scene| (s.panels[0].y.hi / s.panels[0].y.lo).log10();
    for floor in [1e-6, 1e-9, 1e-14] {
        let d = decades(&scene(Axis::log("y", "N"), deep(floor)));
        assert!((2.9..=3.6).contains(&d), "{floor}: {d}");
    }
    // twelve decades that are all there
    let d = decades(&scene(Axis::log("y", "N"), (0..120).map(|k| 10f64.powf(-0.1 * f64::from(k))).collect()));
    assert!((4.9..=5.6).contains(&d), "{d}");
    // nothing is cut where there is little
    let d = decades(&scene(Axis::log("y", "N"), (0..50).map(|k| 10f64.powf(-0.04 * f64::from(k))).collect()));
    assert!((1.9..=2.3).contains(&d), "{d}");
    let both = |other: f64| {
        let n = 40;
        let t = Table::new("t", "")
            .float("x", "", "", (0..n).map(f64::from).collect())
            .float("y", "N", "", vec![1.0; n as usize])
            .float("z", "N", "", vec![other; n as usize])
            .build()
            .unwrap();
        let panel = Panel::new(Axis::log("y", "N")).mark(Line::new("t", "x", "y")).mark(Line::new("t", "x", "z"));
        scene_of(&Figure::new("f", "", "").x(Axis::new("x", "")).panel(panel), &[t]).unwrap()
    };
    assert!(both(1e-7).panels[0].y.lo <= 1e-7 && both(1e-13).panels[0].y.lo > 1e-6);
}
