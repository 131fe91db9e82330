//! Rotors under weight in bearings with clearance: states begin at the sag, and what is said of them is what integration in time shows.

use crate::common;

use common::base::run;
use laval::file::load;
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::outcome::{Arg, End, Outcome};
use laval::parts::{bearing_cubic::*, bearing_hertz::*, damper::*, disc::*};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::branch::Origin;
use laval::solve::harmonic::branches::response::Request;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::{Context, ErasedStudy};
use std::f64::consts::TAU;

const M: f64 = 6.0;
const E: f64 = 5e-6;
const HERTZ: f64 = 1.33e10;
const C: f64 = 400.0;
const G: f64 = 9.80665;

fn rotor(gap: f64, horizontal: bool) -> Builder {
    let link = || Link::Between(Attach::on("rotor"), Attach::ground());
    let b = Builder::new("clearance")
        .part("rotor", Disc::planar(), DiscParams { eccentricity: E, ..DiscParams::new(M) })
        .part("bearing", BearingHertz::radial(link()), BearingHertzParams { coefficient: HERTZ, clearance: gap })
        .part("loss", Damper::fixed(link()), DamperParams { damping: [C; 2], tilt_damping: 0.0 });
    if horizontal { b.horizontal() } else { b }
}

const STEPS: u32 = 4000;

/// Positions over one turn from a state at phase zero, and the state at its end (Runge-Kutta).
fn turn(gap: f64, horizontal: bool, w: f64, mut y: [f64; 4]) -> (Vec<[f64; 2]>, [f64; 4]) {
    let rates = |t: f64, y: [f64; 4]| {
        let r = y[0].hypot(y[1]);
        let f = if r > gap { HERTZ * (r - gap).powf(1.5) / r } else { 0.0 };
        let (s, c) = (w * t).sin_cos();
        let unbalance = M * E * w * w;
        let weight = if horizontal { M * G } else { 0.0 };
        [y[2], y[3], (unbalance * c - f * y[0] - C * y[2]) / M, (unbalance * s - weight - f * y[1] - C * y[3]) / M]
    };
    let h = TAU / w / f64::from(STEPS);
    let add = |y: [f64; 4], k: [f64; 4], s: f64| std::array::from_fn(|i| y[i] + s * k[i]);
    let mut out = Vec::new();
    for i in 0..STEPS {
        let t = h * f64::from(i);
        out.push([y[0], y[1]]);
        let k1 = rates(t, y);
        let k2 = rates(t + 0.5 * h, add(y, k1, 0.5 * h));
        let k3 = rates(t + 0.5 * h, add(y, k2, 0.5 * h));
        let k4 = rates(t + h, add(y, k3, h));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    (out, y)
}

/// The machine released where it rests, followed over 20 times its decay time: the last turn, where the motion repeats after one.
fn in_time(gap: f64, horizontal: bool, w: f64) -> Option<Vec<[f64; 2]>> {
    let sag = if horizontal { gap + (M * G / HERTZ).powf(2.0 / 3.0) } else { 0.0 };
    let mut y = [0.0, -sag, 0.0, 0.0];
    let turns = (20.0 * 2.0 * M / C * w / TAU).ceil() as usize;
    for _ in 0..turns {
        y = turn(gap, horizontal, w, y).1;
    }
    let (path, end) = turn(gap, horizontal, w, y);
    let size = size(&path);
    ((end[0] - y[0]).hypot(end[1] - y[1]) < 1e-5 * size).then_some(path)
}

fn mean(path: &[[f64; 2]]) -> [f64; 2] {
    let n = path.len() as f64;
    path.iter().fold([0.0; 2], |m, p| [m[0] + p[0] / n, m[1] + p[1] / n])
}

/// Largest distance from the mean.
fn size(path: &[[f64; 2]]) -> f64 {
    let mean = mean(path);
    path.iter().map(|p| (p[0] - mean[0]).hypot(p[1] - mean[1])).fold(0.0, f64::max)
}

/// Clearances of 1, 10 and 50 um, lying and upright: the branch from low speed holds the motion on which the machine settles from its rest.
#[test]
fn the_motion_about_the_sag_is_found() {
    let mut compared = 0;
    for gap in [1e-6, 1e-5, 5e-5] {
        for horizontal in [true, false] {
            let system = rotor(gap, horizontal).build().unwrap();
            for w in [52.0, 100.0, 200.0, 400.0, 600.0] {
                let range = (w, 1.01 * w);
                let wanted = Request { stability: false, harmonics: Some(15), ..Request::over(range.0, range.1) };
                let r = run(rotor(gap, horizontal), wanted);
                assert!(r.unstarted.is_empty(), "{gap} {horizontal} {w}: {:?}", r.unstarted);
                let low = r.branches.iter().find(|b| b.origin == Origin::Low).unwrap();
                let mut balance = Balance::new(&system, r.discretisation, range, None).unwrap();
                let orbit = Orbit::of(&mut balance, &low.points[0].x, w).unwrap();
                let (mut q, mut v, mut a) = ([0.0; 2], [0.0; 2], [0.0; 2]);
                let path = if horizontal {
                    let settled = in_time(gap, horizontal, w);
                    // with 10 um this machine repeats after one turn at all of these
                    assert!(settled.is_some() || gap != 1e-5, "{w}");
                    let Some(path) = settled else { continue };
                    path
                } else {
                    // upright it may whirl freely about any place inside the clearance, or along it: the motion itself is followed over a turn
                    orbit.at(0.0, &mut q, &mut v, &mut a, &mut []);
                    turn(gap, horizontal, w, [q[0], q[1], v[0], v[1]]).0
                };
                let mut worst = 0.0f64;
                for (i, p) in path.iter().enumerate() {
                    orbit.at(TAU * i as f64 / path.len() as f64, &mut q, &mut v, &mut a, &mut []);
                    worst = worst.max((q[0] - p[0]).hypot(q[1] - p[1]));
                }
                let size = size(&path);
                assert!(worst < 2e-3 * size, "{gap} {horizontal} {w}: {worst:e} of {size:e}");
                compared += 1;
            }
        }
    }
    assert!(compared >= 20, "{compared}");
}

/// A hardening rotor with a wide hysteresis.
fn hardening() -> Builder {
    let link = || Link::Between(Attach::on("rotor"), Attach::ground());
    Builder::new("hardening")
        .part("rotor", Disc::planar(), DiscParams { eccentricity: 1e-4, ..DiscParams::new(2.0) })
        .part(
            "spring",
            BearingCubic::isotropic(link()),
            BearingCubicParams { stiffness: [1e6; 2], cubic_stiffness: [1e12; 2], valid_to: 0.0 },
        )
        .part("air", Damper::fixed(link()), DamperParams { damping: [170.0; 2], tilt_damping: 0.0 })
}

fn study(builder: Builder, from: f64, to: f64) -> Outcome {
    let system = builder.build().unwrap_or_else(|d| panic!("{:?}", d.0));
    NonlinearResponse::new(Request::over(from, to)).run(&system, &Context::quiet("response")).unwrap()
}

fn value(o: &Outcome, id: &str) -> f64 {
    o.findings.iter().find(|f| f.id == id).unwrap_or_else(|| panic!("no {id} in {:?}", o.findings)).value.unwrap()
}

/// A range that begins, ends, or both, inside a hysteresis: the sweeps go on with the states reached from outside it.
#[test]
fn a_range_inside_a_hysteresis_knows_both_of_its_branches() {
    let whole = study(hardening(), 300.0, 3000.0);
    let (up, down, peak) = (value(&whole, "jump_up"), value(&whole, "jump_down"), value(&whole, "largest_displacement"));
    assert!(up > 1.2 * down, "{up} {down}");
    let inside = |part: f64| down + part * (up - down);
    let near = |a: f64, b: f64| (a - b).abs() < 1e-7 * b;
    let upper = study(hardening(), inside(0.3), 3000.0);
    assert!(near(value(&upper, "jump_up"), up) && near(value(&upper, "largest_displacement"), peak), "{:?}", upper.findings);
    let lower = study(hardening(), 300.0, inside(0.7));
    assert!(near(value(&lower, "jump_down"), down), "{:?}", lower.findings);
    let both = study(hardening(), inside(0.3), inside(0.7));
    assert!(both.findings.iter().any(|f| f.id == "two_branches"), "{:?}", both.findings);
    assert!(both.findings.iter().all(|f| f.id != "start_not_followed"), "{:?}", both.findings);
}

fn inner_damping(mass: f64, stiffness: f64, cubic: f64, [outer, inner]: [f64; 2], eccentricity: f64, study: &str) -> Outcome {
    let damper = |name: &str, c: f64, axes: &str| {
        format!("[[part]]\nkind = \"damper\"\nname = \"{name}\"\nbetween = [\"d\", \"ground\"]\ndamping = {c}\n{axes}\n")
    };
    let text = format!(
        "[machine]\nname = \"d\"\nspeed = 500\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = {mass}\neccentricity = {eccentricity}\n\
         [[part]]\nkind = \"bearing_cubic\"\nname = \"b\"\nbetween = [\"d\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = {stiffness}\n\
         cubic_stiffness = {cubic}\n{}{}\n[[study]]\n{study}\n",
        damper("c", outer, ""),
        damper("ci", inner, "axes = \"rotating\""),
    );
    let loaded = load(&text).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("s")).unwrap()
}

/// The sweep up is stable to its jump; the stability lost at a lower speed is that of the stretch beyond the lower fold. The onset of inner damping has a closed
/// form for a centred rotor, `W = w (1 + c/ci)` with the stiffness at the amplitude of the state, here that of small motions.
#[test]
fn stability_is_reported_of_the_stretch_that_loses_it() {
    let wanted = "kind = \"nonlinear_response\"\nspeed = { from = 113.358, to = 1700.37 }";
    let o = inner_damping(17.2538, 5_542_780.0, 5.32324e14, [412.597, 5287.68], 2.85263e-6, wanted);
    let (up, down) = (value(&o, "jump_up"), value(&o, "jump_down"));
    let lost = o.findings.iter().find(|f| f.id == "stability_lost").unwrap();
    let reported = o.findings.iter().find(|f| f.id == "unstable_states").unwrap();
    let fold = format!("beyond its fold at {} rad/s", laval::outcome::significant(down, 4));
    assert!(lost.sentence().contains(&fold) && reported.sentence().contains(&fold), "{} {}", lost.sentence(), reported.sentence());
    assert!(down < lost.value.unwrap() && lost.value.unwrap() < up, "{lost:?}");
    let onset = (5_542_780.0f64 / 17.2538).sqrt() * (1.0 + 412.597 / 5287.68);
    assert!((lost.value.unwrap() / onset - 1.0).abs() < 0.03, "{lost:?} {onset}");
    // just beyond the jump up the lower states are unstable
    let jump = o.findings.iter().find(|f| f.id == "jump_up").unwrap();
    let landing = jump.notes.iter().find(|n| n.key == "nonlinear-response-jump-landing");
    assert!(landing.is_some_and(|n| n.args == [("stable", Arg::count(0))]), "{}", jump.sentence());
    // the size of the motion at the fold is that of the table
    let t = o.find_table("folds").unwrap();
    let size = t.column("d largest displacement").unwrap().number(0).unwrap();
    let seen = jump.evidence.iter().find(|e| e.what.to_string().contains("at the fold")).unwrap().value;
    assert!(size == seen && size < value(&o, "largest_displacement") * (1.0 + 1e-9), "{size} {seen}");
}

/// Amplitudes of x and y and the force at the spin frequency of a linear rotor in an anisotropic spring: closed forms.
#[test]
fn amplitudes_of_both_axes_and_first_order_forces_are_those_of_the_closed_form() {
    let link = || Link::Between(Attach::on("rotor"), Attach::ground());
    let (m, e, k, c) = (2.0, 1e-5, [1e6, 2e6], 150.0);
    let builder = Builder::new("two stiffnesses")
        .part("rotor", Disc::planar(), DiscParams { eccentricity: e, ..DiscParams::new(m) })
        .part("spring", BearingCubic::per_axis(link()), BearingCubicParams { stiffness: k, cubic_stiffness: [0.0; 2], valid_to: 0.0 })
        .part("air", Damper::fixed(link()), DamperParams { damping: [c; 2], tilt_damping: 0.0 });
    let o = study(builder, 200.0, 1500.0);
    let t = o.find_table("response").unwrap();
    let number = |name: &str, row: usize| t.column(name).unwrap_or_else(|| panic!("no {name}")).number(row).unwrap();
    for row in 0..t.rows() {
        let w = number("speed", row);
        for (axis, k) in ["x", "y"].into_iter().zip(k) {
            let want = m * e * w * w / (k - m * w * w).hypot(c * w);
            for (name, want) in [
                (format!("rotor first order {axis}"), want),
                (format!("rotor largest {axis}"), want),
                (format!("spring first-order force {axis}"), k * want),
            ] {
                let found = number(&name, row);
                assert!((found - want).abs() < 1e-6 * want, "{name} at {w}: {found} {want}");
            }
        }
        // the semi-major axis lies between the larger component and both together
        let [f, x, y] = ["spring first-order force", "spring first-order force x", "spring first-order force y"].map(|n| number(n, row));
        assert!(f >= x.max(y) * (1.0 - 1e-9) && f <= x.hypot(y) * (1.0 + 1e-9), "{f} {x} {y}");
    }
}

/// A rotor on two oil films: its equations are measured by the films where they carry the weight, so that branches run from end to end, from wherever they start.
/// Of a small unbalance the states are those of the machine linearised at rest.
#[test]
fn films_are_measured_where_they_carry_the_weight() {
    let film = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_journal\"\nname = \"{name}\"\nbetween = [{{ body = \"s\", at = {at} }}, \"ground\"]\n\
             diameter = \"60 mm\"\nlength = \"25 mm\"\nclearance = \"60 um\"\nviscosity = \"15 mPa s\"\n"
        )
    };
    let machine = |unbalance: &str, study: &str| {
        let text = format!(
            "[machine]\nname = \"compressor\"\nspeed = \"6000 rpm\"\naxis = \"horizontal\"\n\
             [[part]]\nkind = \"shaft\"\nname = \"s\"\nmaterial = \"steel\"\nelements = 12\n[[part.section]]\nlength = 1.0\nouter_diameter = 0.06\n\
             [[part]]\nkind = \"disc\"\nname = \"d\"\non = {{ body = \"s\", at = 0.5 }}\nmass = 20.0\npolar_inertia = 0.2\n\
             diametral_inertia = 0.1\nunbalance = \"{unbalance}\"\n{}{}[[study]]\n{study}\n",
            film("j1", 0.1),
            film("j2", 0.9)
        );
        let loaded = load(&text).unwrap_or_else(|d| panic!("{d:?}"));
        loaded.studies[0].study.run(&loaded.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{d:?}"))
    };
    for from in [5000, 5100] {
        let study = format!("kind = \"nonlinear_response\"\nspeed = {{ from = \"{from} rpm\", to = \"6000 rpm\" }}\nstability = false");
        let o = machine("100 g mm", &study);
        assert_eq!(o.end, End::Reached, "{from} rpm: {:?}", o.findings.iter().map(|f| f.sentence()).collect::<Vec<_>>());
        let t = o.find_table("response").unwrap();
        let speed = t.column("speed").unwrap();
        let ends = [speed.number(0).unwrap(), speed.number(t.rows() - 1).unwrap()];
        assert!((ends[0] - f64::from(from) * TAU / 60.0).abs() < 1e-9 && (ends[1] - 200.0 * TAU / 2.0).abs() < 1e-9, "{ends:?}");
    }
    let small = machine("0.1 g mm", "kind = \"nonlinear_response\"\nspeed = \"6000 rpm\"\nstability = false");
    let linear = machine("0.1 g mm", "kind = \"forced_response\"\nspeed = \"6000 rpm\"");
    let first = |o: &Outcome, name: &str| {
        let t = o.tables.iter().find(|t| t.column(name).is_some()).unwrap_or_else(|| panic!("no {name} in {:?}", o.tables));
        t.column(name).unwrap().number(0).unwrap()
    };
    let (found, expected) = (first(&small, "amplitude.d"), first(&linear, "amplitude.d"));
    assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected}");
}

/// Masses that move in the rotor: a disturbance whose order beside the spin is open has no number in the sentence.
#[test]
fn no_sentence_holds_what_is_no_number() {
    let machine = r#"
[machine]
name = "balls"
speed = 34.56
[[part]]
kind = "disc"
name = "d"
mass = 3.0173
eccentricity = "100.6 um"
polar_inertia = 0.03017
[[part]]
kind = "shaft_lumped"
name = "s"
between = ["d", "ground"]
stiffness = 1.152e5
[[part]]
kind = "damper"
name = "c"
between = ["d", "ground"]
damping = 221.1
[[part]]
kind = "balancer_ball"
name = "bal"
on = "d"
balls = 2
ball_mass = "24 g"
track_radius = "103 mm"
drag = "0.00656 N m s"
body_tilt = false
[[study]]
kind = "nonlinear_response"
max_points = 300
harmonics = 3
speed = { from = 20, to = 670 }
"#;
    let loaded = load(machine).unwrap_or_else(|d| panic!("{d:?}"));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("s")).unwrap();
    for f in &o.findings {
        assert!(!f.sentence().contains("not a number"), "{}", f.sentence());
        assert!(f.evidence.iter().all(|e| !(e.what.to_string().contains("frequency") && e.value.is_nan())), "{f:?}");
    }
}
