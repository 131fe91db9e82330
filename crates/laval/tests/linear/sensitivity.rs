//! Derivatives of peaks and folds: against closed forms, against the invariance under a change of units, against differences of the whole study.

use crate::common;

use common::base::Base;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::outcome::{Arg, Data, Outcome, Table};
use laval::parts::{bearing_cubic::*, damper::*, disc::*, stop::*};
use laval::solve::harmonic::branches::response::Request;
use laval::study::sensitivity::Sensitivity;
use laval::study::{Context, ErasedStudy};

const RANGE: (f64, f64) = (25.0, 8e3);

fn study(system: &System, request: Request) -> Outcome {
    Sensitivity::new(request).run(system, &Context::quiet("sensitivity")).unwrap()
}

fn numbers(t: &Table, name: &str) -> Vec<f64> {
    match &t.column(name).unwrap().data {
        Data::Float(v) => v.clone(),
        Data::Int(v) => v.iter().map(|&i| i as f64).collect(),
        other => panic!("{other:?}"),
    }
}

fn words(t: &Table, name: &str) -> Vec<String> {
    match &t.column(name).unwrap().data {
        Data::Text(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

/// A place: kind and body, speed, displacement, and by parameter both derivatives.
#[derive(Debug)]
struct Place {
    kind: String,
    speed: f64,
    value: f64,
    slopes: Vec<(String, f64, [f64; 2])>,
}

impl Place {
    fn slope(&self, path: &str) -> [f64; 2] {
        self.slopes.iter().find(|s| s.0 == path).unwrap_or_else(|| panic!("no {path} in {self:?}")).2
    }
}

fn places(o: &Outcome) -> Vec<Place> {
    let (p, s) = (o.find_table("places").unwrap(), o.find_table("sensitivities").unwrap());
    let (kinds, bodies) = (words(p, "kind"), words(p, "body"));
    let (speed, value) = (numbers(p, "speed"), numbers(p, "displacement"));
    let (of, path, at) = (numbers(s, "place"), words(s, "parameter"), numbers(s, "value"));
    let (a, b) = (numbers(s, "speed slope"), numbers(s, "displacement slope"));
    let settled = numbers(p, "settled");
    assert!(settled.iter().all(|s| *s < 1e-7), "{settled:?}");
    (0..speed.len())
        .map(|i| Place {
            kind: format!("{} {}", kinds[i], bodies[i]),
            speed: speed[i],
            value: value[i],
            slopes: (0..of.len()).filter(|&r| of[r] == (i + 1) as f64).map(|r| (path[r].clone(), at[r], [a[r], b[r]])).collect(),
        })
        .collect()
}

#[track_caller]
fn near(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a:.15e} {b:.15e}");
}

fn disc(mass: f64, k: f64, cubic: f64, c: f64, e: f64) -> Builder {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    Builder::new("one disc")
        .part("disc", Disc::planar(), DiscParams { eccentricity: e, ..DiscParams::new(mass) })
        .part(
            "spring",
            BearingCubic::isotropic(link()),
            BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 },
        )
        .part("air", Damper::fixed(link()), DamperParams { damping: [c; 2], tilt_damping: 0.0 })
}

/// `a = e/(2 D sqrt(1 - D^2))`, `W = w0/sqrt(1 - 2 D^2)`, `D = c/(2 sqrt(k m))`, differentiated by hand.
#[test]
fn a_linear_peak_moves_like_the_closed_form() {
    let (m, k, e): (f64, f64, f64) = (2.0, 1e6, 1e-4);
    for c in [30.0, 400.0] {
        let found = places(&study(&disc(m, k, 0.0, c, e).build().unwrap(), Request::over(100.0, 3e3)));
        assert_eq!(found.len(), 1);
        let (w0, d) = ((k / m).sqrt(), c / (2.0 * (k * m).sqrt()));
        let (root, under) = ((1.0 - d * d).sqrt(), 1.0 - 2.0 * d * d);
        let (a, w) = (e / (2.0 * d * root), w0 / under.sqrt());
        near(found[0].value, a, 1e-12);
        near(found[0].speed, w, 1e-9);
        // d/dD
        let (a_d, w_d) = (-a * under / (d * root * root), 2.0 * d * w / under);
        let expected = [
            ("disc.mass", [-w / (2.0 * m) - w_d * d / (2.0 * m), -a_d * d / (2.0 * m)]),
            ("spring.stiffness", [w / (2.0 * k) - w_d * d / (2.0 * k), -a_d * d / (2.0 * k)]),
            ("air.damping", [w_d * d / c, a_d * d / c]),
            ("disc.eccentricity", [0.0, a / e]),
        ];
        for (path, [dw, da]) in expected {
            let [speed, value] = found[0].slope(path);
            near(value, da, 1e-9);
            if dw == 0.0 { assert!((speed * e / w).abs() < 1e-8, "{speed}") } else { near(speed, dw, 1e-7) }
        }
    }
}

/// Powers of kg, m and s in the unit of a parameter.
fn dimension(path: &str) -> [f64; 3] {
    match path.split_once('.').unwrap().1.trim_end_matches(".x").trim_end_matches(".y") {
        "mass" => [1.0, 0.0, 0.0],
        "eccentricity" | "cavity_radius" | "cavity_height" | "free_surface_radius" => [0.0, 1.0, 0.0],
        "eccentricity_phase" => [0.0; 3],
        "density" => [1.0, -3.0, 0.0],
        "stiffness" => [1.0, 0.0, -2.0],
        "cubic_stiffness" => [1.0, -2.0, -2.0],
        "damping" => [1.0, 0.0, -1.0],
        "wave_damping" => [0.0, 0.0, -1.0],
        "unbalance" => [1.0, 1.0, 0.0],
        other => panic!("{other}"),
    }
}

/// In other units of mass, length and time the same machine has the same motion: the sum of all relative influences, weighed with the power of a unit, is the
/// power of that unit in the speed (s^-1) and in the displacement (m).
#[test]
fn influences_add_up_to_the_dimensions() {
    let small = Base { chi: 600.0, ..Base::default() };
    let machines = [
        (small, 4),
        (Base { isotropic: true, ..small }, 4),
        (Base { fill: Some(0.8), wave_damping: 40.0, ..small }, 2),
        (Base { e: 5e-5, ..Base::default() }, 4),
    ];
    for (base, least) in machines {
        let found = places(&study(&base.builder().build().unwrap(), Request::over(RANGE.0, RANGE.1)));
        assert!(found.len() >= least, "{base:?}: {found:?}");
        for p in &found {
            for (unit, [in_speed, in_value]) in [[0.0, 0.0], [0.0, 1.0], [-1.0, 0.0]].into_iter().enumerate() {
                let sum = |which: usize, of: f64| p.slopes.iter().map(|s| dimension(&s.0)[unit] * s.2[which] * s.1 / of).sum::<f64>();
                let (speed, value) = (sum(0, p.speed), sum(1, p.value));
                assert!((speed - in_speed).abs() < 2e-7 && (value - in_value).abs() < 2e-8, "{base:?} {unit} {speed} {value} {p:?}");
            }
        }
    }
}

/// Central differences of the whole study come near like the square of their step, and their extrapolation agrees.
fn against_differences(base: Base, paths: &[&str], request: Request) {
    against_differences_of(&base.builder().build().unwrap(), paths, request);
}

fn against_differences_of(system: &System, paths: &[&str], request: Request) {
    let found = places(&study(system, request));
    for path in paths {
        let value = system.params()[system.param(path).unwrap()[0]];
        let at = |share: f64| places(&study(&system.with(&[(path, value * (1.0 + share))]).unwrap(), request));
        let differences: Vec<Vec<[f64; 2]>> = [4e-3, 2e-3]
            .into_iter()
            .map(|h| {
                let (up, down) = (at(h), at(-h));
                let nearest = |list: &[Place], p: &Place| {
                    let same = list.iter().enumerate().filter(|q| q.1.kind == p.kind);
                    same.min_by(|a, b| (a.1.speed - p.speed).abs().total_cmp(&(b.1.speed - p.speed).abs())).unwrap().0
                };
                found
                    .iter()
                    .map(|p| {
                        let (a, b) = (&up[nearest(&up, p)], &down[nearest(&down, p)]);
                        [(a.speed - b.speed) / (2.0 * h * value), (a.value - b.value) / (2.0 * h * value)]
                    })
                    .collect()
            })
            .collect();
        for (i, p) in found.iter().enumerate() {
            let exact = p.slope(path);
            for which in 0..2 {
                let unit = [p.speed, p.value][which] / value;
                let errors = [0, 1].map(|h| (differences[h][i][which] - exact[which]) / unit);
                let extrapolated = (4.0 * errors[1] - errors[0]) / 3.0;
                assert!(extrapolated.abs() < 2e-6, "{path} {which} {extrapolated:e} {errors:?} {p:?}");
                if errors[0].abs() > 3e-5 {
                    let order = (errors[0] / errors[1]).log2();
                    assert!((order - 2.0).abs() < 0.1, "{path} {which}: order {order} {errors:?} {p:?}");
                }
            }
        }
    }
}

#[test]
fn derivatives_are_those_of_the_whole_study() {
    let request = Request { stability: false, ..Request::over(RANGE.0, RANGE.1) };
    let base = Base { isotropic: true, chi: 600.0, ..Base::default() };
    against_differences(base, &["drum.mass", "bearing.stiffness", "bearing.cubic_stiffness", "air.damping", "base.damping"], request);
    // a law per axis keeps several orders; the same ones in every run, so that only the parameter differs
    let request = Request { harmonics: Some(7), ..request };
    against_differences(Base { isotropic: false, ..base }, &["bearing.cubic_stiffness", "air.damping", "drum.eccentricity"], request);
    let filled = Base { fill: Some(0.8), wave_damping: 40.0, ..base };
    against_differences(
        filled,
        &["liquid.free_surface_radius", "liquid.cavity_radius", "base.mass"],
        Request { harmonics: None, ..request },
    );
}

/// Axes that differ: halves of a lateral pair are parameters of their own. A Hertz bearing with clearance has a law that switches.
#[test]
fn unequal_axes_and_laws_that_switch() {
    let between = |cx: f64, gap: f64| {
        let link = || Link::Between(Attach::on("disc"), Attach::ground());
        disc(2.0, 1e6, 0.0, 200.0, 1e-4)
            .part(
                "side",
                BearingCubic::per_axis(link()),
                BearingCubicParams { stiffness: [cx, 4e5], cubic_stiffness: [1e11; 2], valid_to: 0.0 },
            )
            .part("stop", Stop::new(link()), StopParams { stiffness: 3e6, gap, damping: 0.0 })
            .build()
            .unwrap()
    };
    let request = Request { harmonics: Some(9), stability: false, ..Request::over(200.0, 3e3) };
    let found = places(&study(&between(1e5, 3e-4), request));
    let highest = |list: &[Place]| (0..list.len()).max_by(|a, b| list[*a].value.total_cmp(&list[*b].value)).unwrap();
    let p = &found[highest(&found)];
    assert!(p.value > 3.2e-4, "the stop is not reached: {}", p.value);
    assert!(p.slopes.iter().any(|s| s.0 == "side.stiffness.y"));
    let stiffer = |h: f64| places(&study(&between(1e5 * (1.0 + h), 3e-4), request));
    let wider = |h: f64| places(&study(&between(1e5, 3e-4 * (1.0 + h)), request));
    let check = |path: &str, value: f64, a: &[Place], b: &[Place], h: f64| {
        let (a, b) = (&a[highest(a)], &b[highest(b)]);
        let [speed, size] = p.slope(path);
        near((a.value - b.value) / (2.0 * h * value), size, 2e-4);
        near((a.speed - b.speed) / (2.0 * h * value), speed, 2e-3);
    };
    check("side.stiffness.x", 1e5, &stiffer(2e-3), &stiffer(-2e-3), 2e-3);
    check("stop.gap", 3e-4, &wider(1e-3), &wider(-1e-3), 1e-3);
    // a force that jumps has no derivatives, and it is said
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let jumping = disc(2.0, 1e6, 0.0, 200.0, 1e-4)
        .part(
            "side",
            BearingCubic::per_axis(link()),
            BearingCubicParams { stiffness: [1e5, 4e5], cubic_stiffness: [1e11; 2], valid_to: 0.0 },
        )
        .part("stop", Stop::new(link()), StopParams { stiffness: 3e6, gap: 3e-4, damping: 300.0 })
        .build()
        .unwrap();
    let o = study(&jumping, request);
    assert!(o.findings.iter().any(|f| f.id == "no_derivative" && f.sentence().contains("force of \"stop\" jumps")), "{:?}", o.findings);
}

/// A sagging disc moves otherwise in x than in y, but the halves of an isotropic law stay one parameter: every influence is a number, and that of the
/// stiffness the one of a machine with both halves changed.
#[test]
fn an_isotropic_law_is_one_parameter_in_a_machine_that_sags() {
    let machine = disc(2.0, 1e6, 3e12, 120.0, 2e-5).horizontal().build().unwrap();
    let request = Request { harmonics: Some(9), stability: false, ..Request::over(300.0, 1200.0) };
    let found = places(&study(&machine, request));
    assert!(!found.is_empty());
    for p in &found {
        assert!(p.slopes.iter().all(|s| s.2.iter().all(|s| s.is_finite())), "{p:?}");
        assert!(!p.slopes.iter().any(|s| s.0.starts_with("spring") && s.0.ends_with(".x")), "{p:?}");
    }
    against_differences_of(&machine, &["spring.stiffness", "spring.cubic_stiffness", "disc.mass"], request);
}

/// Tables are in order of influence, findings name the first, and what has no influence is said.
#[test]
fn what_is_reported() {
    let base = Base { isotropic: true, chi: 600.0, phase: 0.3, ..Base::default() };
    let o = study(&base.builder().build().unwrap(), Request::over(RANGE.0, RANGE.1));
    let t = o.find_table("sensitivities").unwrap();
    let (of, a, b) = (numbers(t, "place"), numbers(t, "influence on speed"), numbers(t, "influence on displacement"));
    for i in 1..of.len() {
        assert!(of[i] != of[i - 1] || a[i].abs().max(b[i].abs()) <= a[i - 1].abs().max(b[i - 1].abs()), "{i}");
    }
    assert!(o.findings.iter().any(|f| f.id == "without_influence" && f.sentence().contains("bearing.valid_to")));
    let up = o.findings.iter().find(|f| f.id == "jump_up").unwrap();
    assert!(up.sentence().matches("for 1 % more").count() == 2 && up.value.is_some(), "{up:?}");
    // the parameter of most influence on the speed comes with the influence of the table
    let first = words(o.find_table("places").unwrap(), "kind").iter().position(|k| k == "jump up").unwrap() + 1;
    let most_of = (0..of.len()).filter(|&i| of[i] == first as f64 && a[i].is_finite()).map(|i| a[i].abs()).fold(0.0, f64::max);
    let Some((_, Arg::Phrase(most))) = up.message.args.iter().find(|a| a.0 == "speed-influence") else { panic!("{up:?}") };
    let Some((_, Arg::Quantity(change))) = most.args.iter().find(|a| a.0 == "change") else { panic!("{most:?}") };
    assert_eq!(change.value, 0.01 * most_of);
    assert!(o.figures.iter().any(|f| f.name.starts_with("influence-")));
}
