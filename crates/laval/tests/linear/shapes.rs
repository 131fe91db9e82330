//! Shapes of modes, orbits, deflected shapes and the polar diagram against symmetries and closed forms.

use laval::file::{Form, load, render};
use laval::outcome::{Data, Outcome, Table};
use laval::report::draw;
use laval::study::Context;
use laval::study::forced_response::{ForcedResponse, Reason};
use laval::study::modes::{Modes, Shapes};
use laval::study::stations::Stations;
use laval::study::support::About;
use laval::study::{ErasedStudy, Study};
use laval_num::complex::{C64, c};

fn system(text: &str) -> laval::model::system::System {
    load(text).unwrap_or_else(|d| panic!("{}", render(&d, text, "m.toml", Form::Lines))).system
}

/// A rotor of 2 kg on two bearings 0.2 m to both sides of its middle.
fn symmetric(upper: f64, more: &str) -> String {
    format!(
        r#"
        [machine]
        speed = 300.0
        [[part]]
        kind = "disc"
        name = "rotor"
        mass = 2.0
        diametral_inertia = 0.03
        polar_inertia = 0.01
        [[part]]
        kind = "bearing_linear"
        name = "lower"
        between = [{{ body = "rotor", at = -0.2 }}, "ground"]
        stiffness = 1e6
        [[part]]
        kind = "bearing_linear"
        name = "upper"
        between = [{{ body = "rotor", at = {upper:?} }}, "ground"]
        stiffness = 1e6
        {more}
        "#
    )
}

fn modes(speed: f64) -> Modes {
    Modes { speed, about: About::Rest, threshold: 0.0, frequency: None }
}

fn shapes(text: &str) -> Shapes {
    let system = system(text);
    let study = modes(system.machine.speed.unwrap());
    study.compute(&system, &Context::quiet("modes")).unwrap().shapes.expect("several points move")
}

fn size(m: [C64; 2]) -> f64 {
    m[0].abs() + m[1].abs()
}

/// Two modes of a symmetric rotor on equal bearings move all points alike, two move the ends against each other and leave the middle at rest; all orbits are circles.
#[test]
fn a_symmetric_rotor_moves_in_parallel_or_about_its_middle() {
    let s = shapes(&symmetric(0.2, ""));
    let heights: Vec<f64> = s.stations.all.iter().map(|p| p.height).collect();
    assert_eq!((heights, s.stations.to_scale), (vec![-0.2, 0.0, 0.2], true));
    let (mut parallel, mut conical) = (0, 0);
    for m in &s.modes {
        let one_way = |k: usize| m.iter().all(|p| p[k].abs() < 1e-9);
        assert!(one_way(0) || one_way(1), "isotropic supports whirl in circles: {m:?}");
        let circle: Vec<C64> = m.iter().map(|p| p[0] + p[1]).collect();
        if (circle[0] - circle[2]).abs() < 1e-9 {
            assert!((circle[1] - circle[0]).abs() < 1e-9 && (circle[0] - c(1.0, 0.0)).abs() < 1e-9, "{circle:?}");
            parallel += 1;
        } else {
            assert!((circle[0] + circle[2]).abs() < 1e-9 && circle[1].abs() < 1e-9 && (circle[0].abs() - 1.0).abs() < 1e-9, "{circle:?}");
            conical += 1;
        }
    }
    assert_eq!((parallel, conical), (2, 2));
}

/// Turned over, the rotor has the shapes of before, turned over.
#[test]
fn a_rotor_upside_down_has_its_shapes_upside_down() {
    let (a, b) = (shapes(&symmetric(0.35, "")), shapes(&symmetric(0.35, "").replace("-0.2", "0.2").replace("0.35", "-0.35")));
    assert_eq!(a.modes.len(), b.modes.len());
    for (p, q) in a.modes.iter().zip(&b.modes) {
        let (p, q): (Vec<f64>, Vec<f64>) = (p.iter().map(|m| size(*m)).collect(), q.iter().rev().map(|m| size(*m)).collect());
        assert!(p.iter().zip(&q).all(|(x, y)| (x - y).abs() < 1e-7), "{p:?} {q:?}");
    }
}

/// Between its two bearings the axis of a rigid rotor stays straight.
#[test]
fn the_points_of_a_rigid_body_lie_on_a_line() {
    let s = shapes(&symmetric(0.35, "").replace("stiffness = 1e6", "kxx = 1e6\nkyy = 2e6\nkxy = 1e5\nkyx = -1e5\ncxx = 200.0"));
    for m in &s.modes {
        let places: Vec<f64> = s.stations.all.iter().map(|p| p.place).collect();
        let t = (places[1] - places[0]) / (places[2] - places[0]);
        for k in 0..2 {
            let middle = m[0][k] + (m[2][k] - m[0][k]).scale(t);
            assert!((middle - m[1][k]).abs() < 1e-9, "{m:?}");
        }
        // the largest orbit has the semi-major axis 1 and begins at its end
        let largest = *m.iter().max_by(|a, b| size(**a).total_cmp(&size(**b))).unwrap();
        let start = largest[0] + largest[1];
        assert!((size(largest) - 1.0).abs() < 1e-9 && (start.abs() - 1.0).abs() < 1e-9 && start.re > -1e-9, "{largest:?}");
    }
}

#[test]
fn places_follow_from_the_points_that_parts_join() {
    let more = r#"
        [[part]]
        kind = "foundation"
        name = "frame"
        mass = 10.0
        stiffness = 1e5
        "#;
    let text = symmetric(0.3, more).replacen("\"ground\"", "\"frame\"", 1);
    let stations = Stations::of(&system(&text));
    let frame = stations.all.iter().find(|s| s.body == "frame").unwrap();
    assert!(stations.to_scale && (frame.place + 0.2).abs() < 1e-15 && frame.line != stations.all[0].line);
    // a lumped shaft has no length: bodies stand one below the other, what turns above
    let two = |second: &str| {
        format!(
            "[machine]\nspeed = 10.0\n[[part]]\nkind = \"foundation\"\nname = \"frame\"\nmass = 10.0\nstiffness = 1e5\n\
             [[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 1.0\n{second}\
             [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"disc\", \"frame\"]\nstiffness = 1e6\n"
        )
    };
    let stations = Stations::of(&system(&two("")));
    let place = |s: &Stations, body: &str| s.all.iter().find(|s| s.body == body).unwrap().place;
    assert!(!stations.to_scale && place(&stations, "disc") > place(&stations, "frame"));
    let other = "[[part]]\nkind = \"disc\"\nname = \"other\"\nmass = 1.0\n[[part]]\nkind = \"shaft_lumped\"\nname = \"long\"\nbetween = [\"other\", \"disc\"]\nstiffness = 1e6\n";
    let stations = Stations::of(&system(&two(other)));
    let line = |body: &str| stations.all.iter().find(|s| s.body == body).unwrap().line;
    assert!(line("disc") == line("other") && line("disc") != line("frame"));
}

/// A disc that tilts on one spring has two ends, a radius of gyration from its middle, which show the tilt.
#[test]
fn a_tilt_is_seen_at_the_ends_of_a_body() {
    let text = "[machine]\nspeed = 10.0\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4.0\ndiametral_inertia = 0.09\n\
                [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1e6\ntilt_stiffness = 1e4\n";
    let s = shapes(text);
    let heights: Vec<(f64, bool)> = s.stations.all.iter().map(|p| (p.height, p.named)).collect();
    assert_eq!(heights, [(-0.15, false), (0.0, true), (0.15, false)]);
    // and a point mass has no shape
    let point = text.replace("diametral_inertia = 0.09\n", "").replace("tilt_stiffness = 1e4\n", "");
    let study = modes(10.0);
    assert!(study.compute(&system(&point), &Context::quiet("modes")).unwrap().shapes.is_none());
    let o = study.run(&system(&point), &Context::quiet("modes")).unwrap();
    assert!(o.figures.iter().all(|f| f.name != "shapes") && o.find_table("shapes").is_none());
}

fn numbers(t: &Table, column: &str) -> Vec<f64> {
    match &t.column(column).unwrap_or_else(|| panic!("{column}")).data {
        Data::Float(v) => v.clone(),
        Data::Int(v) => v.iter().map(|x| *x as f64).collect(),
        other => panic!("{other:?}"),
    }
}

/// 3 kg on 3e4 N/m and 30 N s/m: natural frequency 100 rad/s.
fn jeffcott(machine: &str, more: &str) -> String {
    format!(
        "[machine]\n{machine}\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 3.0\neccentricity = 2e-5\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 3e4\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 30.0\n{more}"
    )
}

fn respond(text: &str, from: f64, to: f64) -> (ForcedResponse, laval::model::system::System) {
    let speed = laval::model::field::RangeValue { from, to, points: Some(if from == to { 1 } else { 200 }) };
    (ForcedResponse::over(speed), system(text))
}

/// m e w^2/(k - m w^2 + i c w), a circle with the spin.
#[test]
fn orbits_at_the_operating_speed_and_at_the_resonance() {
    let (study, system) = respond(&jeffcott("speed = 150.0", ""), 20.0, 300.0);
    let found = study.compute(&system, &Context::quiet("r")).unwrap().orbits;
    let reasons: Vec<Reason> = found.at.iter().map(|a| a.reason).collect();
    assert_eq!(reasons, [Reason::Operating, Reason::Resonance]);
    // of viscous damping the amplitude is largest at w0/sqrt(1 - 2 D^2) with D = 0.05
    assert!((found.at[1].speed / (100.0 / (1.0f64 - 0.005).sqrt()) - 1.0).abs() < 1e-6, "{}", found.at[1].speed);
    for a in &found.at {
        let w = a.speed;
        let want = c(3.0 * 2e-5 * w * w, 0.0) / c(3e4 - 3.0 * w * w, 30.0 * w);
        assert!((a.motions[0][0] - want).abs() < 1e-12 * 1e-3 && a.motions[0][1].abs() < 1e-15, "{:?} {want:?}", a.motions);
    }
    let o = study.run(&system, &Context::quiet("r")).unwrap();
    let figure = o.figures.iter().find(|f| f.name == "orbits").expect("orbits");
    assert!(o.figures.iter().all(|f| f.name != "deflected"), "a point has no shape");
    let svg = draw(figure, &o.tables).unwrap();
    assert!(svg.contains("operating speed") && svg.contains(">forward<"), "{svg}");
}

/// The mobility i w x/F of one mode is a circle through 0 of diameter 1/c.
#[test]
fn the_polar_diagram_of_one_mode_is_a_circle() {
    let (study, system) = respond(&jeffcott("speed = 150.0", ""), 20.0, 300.0);
    let o = study.run(&system, &Context::quiet("r")).unwrap();
    let t = o.find_table("polar").expect("polar");
    let (w, x, y) = (numbers(t, "speed"), numbers(t, "in_phase.disc"), numbers(t, "quadrature.disc"));
    assert!(w.windows(2).all(|p| p[0] < p[1]) && w.contains(&150.0));
    for ((w, x), y) in w.iter().zip(&x).zip(&y) {
        let mobility = c(*x, *y).mul_i().scale(1.0 / (3.0 * 2e-5 * w));
        assert!(((mobility - c(1.0 / 60.0, 0.0)).abs() * 60.0 - 1.0).abs() < 1e-9, "{w}");
    }
    // marks are places of the curve, the operating speed among them
    let marked = numbers(t, "marked");
    let places: Vec<usize> = (0..w.len()).filter(|&i| marked[i].is_finite()).collect();
    assert!((3..=12).contains(&places.len()) && places.iter().all(|&i| marked[i] == y[i]) && places.iter().any(|&i| w[i] == 150.0));
    let figure = o.figures.iter().find(|f| f.name == "polar").expect("a figure");
    assert!(figure.equal);
}

/// A shaft that sags in a clearance: the circle is as wide as the gap and lies as far above the orbit's centre as the shaft hangs below.
#[test]
fn the_clearance_is_drawn_about_where_the_shaft_hangs() {
    let stop = "[[part]]\nkind = \"stop\"\nname = \"ring\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1e8\ngap = 2e-3\n";
    let (study, system) = respond(&jeffcott("speed = 150.0\naxis = \"horizontal\"", stop), 150.0, 150.0);
    let found = study.compute(&system, &Context::quiet("r")).unwrap().orbits;
    let gap = &found.at[0].gaps[0];
    assert!((gap.width - 2e-3).abs() < 1e-12 && (gap.motion[0] - found.at[0].motions[0][0]).abs() < 1e-15);
    assert!(gap.offset[0].abs() < 1e-12 && (gap.offset[1] / (-3.0 * 9.80665 / 3e4) - 1.0).abs() < 1e-6, "{:?}", gap.offset);
    let o: Outcome = study.run(&system, &Context::quiet("r")).unwrap();
    let tiles = o.figures.iter().find(|f| f.name == "orbits").and_then(|f| f.tiles.as_ref()).expect("orbits");
    let limit = tiles.pictures.iter().find_map(|p| p.circle).expect("a circle");
    assert!(limit.radius == gap.width && limit.centre[1] == -gap.offset[1]);
}
