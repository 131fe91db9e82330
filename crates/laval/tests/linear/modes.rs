//! Modes: reference eigenvalues, closed forms, symmetries.

use crate::common;

use common::{Planar, number, rows};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, bearing_linear::*, damper::*, disc::*, foundation::*};
use laval::solve::pencil::{MachineMode, Spectrum, Whirl, modes_about};
use laval::solve::{co_rotating::turning, rest::rest};
use laval::study::{Context, ErasedStudy, modes::Modes, support::About};
use laval_num::complex::{C64, c};

fn at_rest(system: &System, speed: f64) -> Spectrum {
    modes_about(system, &rest(system, speed).unwrap(), true).unwrap()
}

/// Signed frequencies of the complex model: forward positive, backward negative.
fn signed(spectrum: &Spectrum) -> Vec<C64> {
    let mut v: Vec<C64> = spectrum.modes.iter().map(|m| if m.whirl == Whirl::Backward { m.value.conj() } else { m.value }).collect();
    v.sort_by(|a, b| a.im.total_cmp(&b.im));
    v
}

/// Largest distance from each value of `a` to the nearest of `b`.
fn distance(a: &[C64], b: &[C64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().map(|x| b.iter().map(|y| (*x - *y).abs()).fold(f64::INFINITY, f64::min)).fold(0.0, f64::max)
}

#[test]
fn reference_eigenvalues() {
    let mut worst = (0.0f64, 0.0f64);
    let table = rows(include_str!("../reference/planar/eigenvalues.csv"));
    assert_eq!(table.len(), 462);
    for row in &table {
        let undamped = row[0] == "undamped";
        let system = Planar {
            base: if row[0] == "damped_M250" { 250.0 } else { 25.0 },
            chi: if undamped { 0.0 } else { 42.0 },
            chi0: if undamped { 0.0 } else { 6.59 },
            fill: number(row[1]),
            ..Planar::default()
        }
        .build();
        let expected: Vec<C64> = (0..6).map(|k| c(number(row[3 + 2 * k]), number(row[4 + 2 * k]))).filter(|z| !z.re.is_nan()).collect();
        let found = signed(&at_rest(&system, number(row[2])));
        assert_eq!(found.len(), expected.len(), "{row:?}");
        let largest = expected.iter().map(|z| z.abs()).fold(0.0, f64::max);
        for e in &expected {
            let f = found.iter().min_by(|a, b| (**a - *e).abs().total_cmp(&(**b - *e).abs())).unwrap();
            // twelve digits are printed
            let printed = 1e-11 * e.abs();
            worst.0 = worst.0.max((*f - *e).abs() / largest);
            worst.1 = worst.1.max((f.re - e.re).abs());
            assert!((*f - *e).abs() <= 1e-10 * largest + printed, "{row:?}: {f:?} for {e:?}");
            assert!((f.re - e.re).abs() <= 1e-8 + 1e-11 * e.re.abs(), "{row:?}: growth {} for {}", f.re, e.re);
        }
    }
    println!("largest deviation {:.1e} of the largest modulus, growth {:.1e} 1/s", worst.0, worst.1);
}

#[test]
fn turning_modes_are_those_at_rest_seen_from_the_rotor() {
    for (fill, speed) in [(1.0, 700.0), (0.667, 3000.0), (0.667, -3000.0), (0.0, 1500.0)] {
        let mut p = Planar { fill, ..Planar::default() };
        p.metre = 1.0;
        // without the cubic part the turning state has the same tangent as rest
        let system = p.build().with(&[("bearing.cubic_stiffness", 0.0)]).unwrap();
        let fixed = at_rest(&system, speed);
        let state = turning(&system, speed, None).unwrap();
        assert!(state.q.iter().any(|q| q.abs() > 1e-6));
        let rotating = modes_about(&system, &state, true).unwrap();
        let shifted: Vec<C64> = fixed
            .modes
            .iter()
            .map(|m| {
                // s exp(i w t) in the forward sector is s - i W in the rotor; the backward one is its conjugate
                let z = if m.sector == Some(laval::solve::sectors::Sector::Backward) { m.value.conj() } else { m.value } - c(0.0, speed);
                if z.im < 0.0 { z.conj() } else { z }
            })
            .collect();
        let found: Vec<C64> = rotating.modes.iter().map(|m| m.value).collect();
        let largest = found.iter().map(|z| z.abs()).fold(0.0, f64::max);
        assert!(distance(&shifted, &found) < 1e-11 * largest, "{fill} {speed}: {:e}", distance(&shifted, &found));
    }
}

#[test]
fn reversed_rotation_exchanges_forward_and_backward() {
    let system = Planar { fill: 0.8, ..Planar::default() }.build();
    let (plus, minus) = (at_rest(&system, 2500.0), at_rest(&system, -2500.0));
    for (a, b) in plus.modes.iter().zip(&minus.modes) {
        assert!((a.value - b.value).abs() < 1e-9);
        assert!(
            matches!((a.whirl, b.whirl), (Whirl::Forward, Whirl::Backward) | (Whirl::Backward, Whirl::Forward)),
            "{:?} {:?}",
            a.whirl,
            b.whirl
        );
    }
}

fn orthotropic(swap: bool) -> System {
    let s = |x: f64, y: f64| if swap { [y, x] } else { [x, y] };
    Builder::new("orthotropic")
        .part("disc", Disc::planar(), DiscParams::new(3.0))
        .part("base", Foundation, FoundationParams { mass: 20.0, stiffness: s(4e5, 7e5), damping: s(30.0, 50.0) })
        .part(
            "bearing",
            BearingCubic::per_axis(Link::Between(Attach::on("disc"), Attach::on("base"))),
            BearingCubicParams { stiffness: s(1e7, 2e7), cubic_stiffness: [0.0; 2], valid_to: 0.0 },
        )
        .part(
            "inner",
            Damper::rotating(Link::Between(Attach::on("disc"), Attach::on("base"))),
            DamperParams { damping: [90.0; 2], tilt_damping: 0.0 },
        )
        .build()
        .unwrap()
}

#[test]
fn exchanging_x_and_y_reverses_the_rotation() {
    let (a, b) = (at_rest(&orthotropic(false), 400.0), at_rest(&orthotropic(true), -400.0));
    assert_eq!(a.modes.len(), b.modes.len());
    for (x, y) in a.modes.iter().zip(&b.modes) {
        assert!(x.sector.is_none());
        assert!((x.value - y.value).abs() < 1e-10 * x.value.abs());
        assert!((x.forward_share + y.forward_share - 1.0).abs() < 1e-8);
    }
}

#[test]
fn units_do_not_matter() {
    let one = at_rest(&Planar { fill: 0.667, ..Planar::default() }.build(), 3000.0);
    // the dimensions of stiffness and damping hold no length, so that decimetres change only lengths and the cubic coefficient
    let other = at_rest(&Planar { fill: 0.667, metre: 0.1, ..Planar::default() }.builder().build().unwrap(), 3000.0);
    for (a, b) in one.modes.iter().zip(&other.modes) {
        assert!((a.value - b.value).abs() < 1e-12 * 22000.0);
    }
}

#[test]
fn rotating_damping_destabilises_above_its_onset() {
    let (m, k, ce, ci): (f64, f64, f64, f64) = (5.0, 2e6, 120.0, 80.0);
    let system = Builder::new("Kimball")
        .part("disc", Disc::planar(), DiscParams::new(m))
        .part(
            "shaft",
            BearingCubic::isotropic(Link::Between(Attach::on("disc"), Attach::ground())),
            BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 },
        )
        .part(
            "air",
            Damper::fixed(Link::Between(Attach::on("disc"), Attach::ground())),
            DamperParams { damping: [ce; 2], tilt_damping: 0.0 },
        )
        .part(
            "inner",
            Damper::rotating(Link::Between(Attach::on("disc"), Attach::ground())),
            DamperParams { damping: [ci; 2], tilt_damping: 0.0 },
        )
        .build()
        .unwrap();
    let onset = (k / m).sqrt() * (1.0 + ce / ci);
    let growth = |w: f64| at_rest(&system, w).least_stable().map(MachineMode::growth).unwrap();
    assert!(growth(onset * (1.0 - 1e-6)) < 0.0 && growth(onset * (1.0 + 1e-6)) > 0.0);
    assert!(growth(onset).abs() < 1e-11 * onset);
    let worst = at_rest(&system, onset * 1.1);
    assert_eq!(worst.least_stable().map(|m| m.whirl), Some(Whirl::Forward));
}

#[test]
fn full_and_empty_cavities() {
    // a full cavity is a heavier rotor
    let full = at_rest(&Planar { fill: 0.0, ..Planar::default() }.build(), 2000.0);
    let liquid = std::f64::consts::PI * 0.07 * 0.07 * 0.06 * 1000.0;
    let heavy = at_rest(&Planar::default().build().with(&[("drum.mass", 2.4 + liquid)]).unwrap(), 2000.0);
    for (a, b) in full.modes.iter().zip(&heavy.modes) {
        assert!((a.value - b.value).abs() < 1e-10 * b.value.abs());
    }
    // undamped and empty: closed form
    let empty = at_rest(&Planar { chi: 0.0, chi0: 0.0, ..Planar::default() }.build(), 100.0);
    let (m, mm, c0, c2): (f64, f64, f64, f64) = (2.4, 25.0, 1.1e7, 3.26e5);
    let b = c0 * (m + mm) + c2 * m;
    let root = (b * b - 4.0 * m * mm * c0 * c2).sqrt();
    let high = (b + root) / (2.0 * m * mm);
    let low = c0 * c2 / (m * mm) / high;
    for (mode, w2) in empty.modes.iter().zip([low, low, high, high]) {
        assert!((mode.frequency() - w2.sqrt()).abs() < 1e-12 * mode.frequency() && mode.growth().abs() < 1e-10);
        assert!(matches!(mode.whirl, Whirl::Forward | Whirl::Backward));
    }
}

#[test]
fn tilting_disc_splits_gyroscopically() {
    // A theta'' - i C W theta' + k theta = 0
    let (a, cp, k): (f64, f64, f64) = (0.02, 0.03, 800.0);
    let disc = DiscParams { diametral_inertia: a, polar_inertia: cp, ..DiscParams::new(4.0) };
    let h = 0.1;
    // two springs at +-h hold the tilt: k = 2 kb h^2
    let kb = k / (2.0 * h * h);
    let spring = |z: f64| BearingCubic::isotropic(Link::Between(Attach::at("disc", z), Attach::ground()));
    let p = BearingCubicParams { stiffness: [kb; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 };
    let system =
        Builder::new("gyro").part("disc", Disc::tilting(), disc).part("upper", spring(h), p).part("lower", spring(-h), p).build().unwrap();
    for w in [0.0, 150.0, 900.0] {
        let s = at_rest(&system, w);
        let g = cp * w / (2.0 * a);
        let r = (g * g + k / a).sqrt();
        for (expected, whirl) in [(r + g, Whirl::Forward), (r - g, Whirl::Backward)] {
            let found = s.modes.iter().filter(|m| m.whirl == whirl).map(|m| (m.frequency() - expected).abs()).fold(f64::INFINITY, f64::min);
            assert!(found < 1e-11 * expected, "{w} {expected} {found:e}");
        }
    }
}

/// Forces g v across the velocity couple two unlike planes: `y/x = i r`, `r = (kxx - m w^2) / (g w)`. The ellipse has the radii `(1 + r)/2` and
/// `(1 - r)/2`: neither direction leads while they agree within a twentieth.
#[test]
fn flat_orbits_have_no_direction() {
    let (m, kx, ky): (f64, f64, f64) = (2.0, 1e6, 1.2e6);
    for (g, flat) in [(0.1f64, true), (3.0, true), (10.0, false), (30.0, false)] {
        let p = BearingLinearParams { kxx: kx, kyy: ky, cxy: g, cyx: -g, ..BearingLinearParams::new() };
        let link = Link::Between(Attach::on("disc"), Attach::ground());
        let system = Builder::new("flat")
            .part("disc", Disc::planar(), DiscParams::new(m))
            .part("bearing", BearingLinear::constant(link), p)
            .build()
            .unwrap();
        // (kx - m W)(ky - m W) = g^2 W, W = w^2
        let (b, c) = ((m * (kx + ky) + g * g) / (2.0 * m * m), kx * ky / (m * m));
        let squares = [b - (b * b - c).sqrt(), b + (b * b - c).sqrt()];
        let modes = at_rest(&system, 100.0).modes;
        assert_eq!(modes.len(), 2);
        for (mode, square) in modes.iter().zip(squares) {
            let w = square.sqrt();
            assert!((mode.frequency() / w - 1.0).abs() < 1e-12);
            let y = mode.q[1] / mode.q[0];
            let r = (kx - m * square) / (g * w);
            assert!(y.re.abs() < 1e-7 * (1.0 + y.im.abs()) && (y.im.abs() / r.abs() - 1.0).abs() < 1e-6, "{y:?} {r}");
            let narrow = r.abs().min(1.0 / r.abs());
            let larger = (1.0 + narrow).powi(2) / (2.0 * (1.0 + narrow * narrow));
            assert!(((mode.forward_share - 0.5).abs() - (larger - 0.5)).abs() < 1e-8, "{} {larger}", mode.forward_share);
            assert_eq!(mode.whirl == Whirl::Mixed, flat, "{g}: {mode:?}");
        }
        let out =
            Modes { speed: 100.0, about: About::Rest, threshold: 0.0, frequency: None }.run(&system, &Context::quiet("modes")).unwrap();
        let text = out.findings.iter().find(|f| f.id == "least_damped_mode").unwrap().sentence();
        assert_eq!(text.contains("mixed whirl on a straight line"), flat, "{text}");
    }
}

#[test]
fn anisotropy_is_named() {
    let e = turning(&orthotropic(false), 100.0, None).unwrap_err();
    assert!(e.message.contains("base") || e.message.contains("stiffness differs") || e.message.contains("damping differs"), "{e}");
    let horizontal = Planar::default().builder().horizontal().build().unwrap();
    let e = turning(&horizontal, 100.0, None).unwrap_err();
    assert!(e.message.contains("weight of \"drum\""), "{e}");
}

#[test]
fn a_loaded_nonlinear_bearing_sags_and_stiffens() {
    let system = Planar::default().builder().horizontal().build().unwrap().with(&[("bearing.cubic_stiffness", 8.7e17)]).unwrap();
    let e = rest(&system, 0.0).unwrap();
    let (g, d) = (9.80665, e.q[1] - e.q[3]);
    assert!((1.1e7 * d + 8.7e17 * d * d * d + 2.4 * g).abs() < 1e-9);
    assert!((3.26e5 * e.q[3] + 27.4 * g).abs() < 1e-9);
    let s = modes_about(&system, &e, true).unwrap();
    // sagging stiffens y only: two planes, no circular whirl
    assert!(s.modes.iter().all(|m| m.whirl == Whirl::Mixed && m.sector.is_none()));
}

#[test]
fn the_study_says_what_is_unstable() {
    let system = Planar { fill: 0.667, ..Planar::default() }.build();
    let study = Modes { speed: 3000.0, about: About::Rest, threshold: 0.0, frequency: None };
    let out = study.run(&system, &Context::quiet("modes")).unwrap();
    let worst = out.findings.iter().filter(|f| f.id == "unstable_mode").filter_map(|f| f.value).fold(0.0, f64::max);
    assert!((worst - 192.0108286).abs() < 1e-6);
    assert_eq!(out.find_table("modes").unwrap().rows(), 6);
}

#[test]
fn turning_state_of_an_isotropic_cubic_bearing() {
    let (m, e, k, k3, d, w): (f64, f64, f64, f64, f64, f64) = (3.0, 1e-3, 4e6, 5e11, 400.0, 900.0);
    let system = Builder::new("cubic")
        .part("disc", Disc::planar(), DiscParams { eccentricity: e, ..DiscParams::new(m) })
        .part(
            "bearing",
            BearingCubic::isotropic(Link::Between(Attach::on("disc"), Attach::ground())),
            BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [k3; 2], valid_to: 0.0 },
        )
        .part(
            "air",
            Damper::fixed(Link::Between(Attach::on("disc"), Attach::ground())),
            DamperParams { damping: [d; 2], tilt_damping: 0.0 },
        )
        .build()
        .unwrap();
    let s = turning(&system, w, None).unwrap();
    let a = s.q[0].hypot(s.q[1]);
    let force = (k - m * w * w + k3 * a * a).hypot(d * w) * a;
    assert!((force / (m * e * w * w) - 1.0).abs() < 1e-12);
    // constant coefficients: det of [K + c0 + 2 c1 a^2, c1 D^2; conj] in sectors, K = m (s + i W)^2 + d (s + i W)
    let modes = modes_about(&system, &s, true).unwrap();
    assert_eq!(modes.modes.iter().map(|m| if m.frequency() > 0.0 { 2 } else { 1 }).sum::<usize>(), 4);
    let big = c(s.q[0], s.q[1]);
    for mode in &modes.modes {
        let block = |z: C64| (z * z).scale(m) + z.scale(d) + c(k + 2.0 * k3 * a * a, 0.0);
        let (p, q) = (block(mode.value + c(0.0, w)), block(mode.value - c(0.0, w)));
        let off = (big * big).scale(k3);
        assert!((p * q - off * off.conj()).abs() < 1e-11 * (p.abs() * q.abs() + off.abs() * off.abs()), "{:?}", mode.value);
    }
}

#[test]
fn growth_agrees_with_time_integration() {
    for r in rows(include_str!("../reference/planar/growth_from_time.csv")) {
        let chi = number(r[0]);
        let system = Planar { chi, chi0: if chi == 0.0 { 0.0 } else { 6.59 }, fill: number(r[1]), ..Planar::default() }.build();
        let s = at_rest(&system, number(r[2]));
        let worst = s.least_stable().unwrap().value;
        // ten digits are printed
        assert!((worst.re / number(r[3]) - 1.0).abs() < 1e-9 && (worst.im / number(r[4]) - 1.0).abs() < 1e-9, "{r:?}: {worst:?}");
        // the integrations were fitted over a finite time
        assert!((worst.re / number(r[5]) - 1.0).abs() < 5e-5 && (worst.im / number(r[6]) - 1.0).abs() < 5e-5, "{r:?}: {worst:?}");
    }
}

/// Elements of a shaft that act at their middles, 12 E I/l^3 across and E I/l in tilt, bend as the shaft between its masses does: on stiff bearings at its ends
/// it whirls at (n pi/L)^2 sqrt(E I/m').
#[test]
fn a_shaft_of_elements_whirls_as_the_uniform_beam() {
    let (elements, length, bending, mass, tilt) = (12, 1.5, 6.4e4, 15.0, 1e-5);
    let l = length / f64::from(elements);
    let mut text = String::from("[machine]\nspeed = 0\n[[study]]\nkind = \"modes\"\n");
    for k in 0..=elements {
        let share = if k == 0 || k == elements { 0.5 } else { 1.0 };
        text += &format!("[[part]]\nkind = \"disc\"\nname = \"n{k}\"\nmass = {:e}\n", share * mass * l);
        text += &format!("diametral_inertia = {tilt:e}\npolar_inertia = {:e}\n", 2.0 * tilt);
    }
    for k in 1..=elements {
        let (above, below) = (format!("n{k}"), format!("n{}", k - 1));
        text += &format!(
            "[[part]]\nkind = \"shaft_lumped\"\nbetween = [{{ body = \"{above}\", at = {:e} }}, {{ body = \"{below}\", at = {:e} }}]\n",
            -0.5 * l,
            0.5 * l
        );
        text += &format!("stiffness = {:e}\ntilt_stiffness = {:e}\n", 12.0 * bending / l.powi(3), bending / l);
    }
    for k in [0, elements] {
        text += &format!("[[part]]\nkind = \"bearing_linear\"\nbetween = [\"n{k}\", \"ground\"]\nkxx = 1e12\nkyy = 1e12\n");
    }
    let loaded = laval::file::load(&text).unwrap_or_else(|d| panic!("{d:?}"));
    let o = loaded.studies[0].study.run(&loaded.system, &laval::study::Context::quiet("modes")).unwrap();
    let frequency = o.find_table("modes").unwrap().column("frequency").unwrap();
    for n in 1..=3 {
        let wave = f64::from(n) * std::f64::consts::PI / length;
        // inertia of the tilts beside that of the displacements
        let whirls = wave * wave * (bending / (mass + tilt / l * wave * wave)).sqrt();
        // forward and backward; masses in points leave out (n pi)^4/(720 N^4)
        let error = (f64::from(n) * std::f64::consts::PI / f64::from(elements)).powi(4) / 720.0;
        for k in [2 * n - 2, 2 * n - 1] {
            let found = frequency.number(k as usize).unwrap();
            assert!((found / whirls - 1.0).abs() < 2.0 * error + 1e-6, "{n}: {found} for {whirls}, {error:e}");
        }
    }
}
