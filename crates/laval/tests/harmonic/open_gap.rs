//! Rolling bearings with clearance in linear studies: open inside a held machine, pressed by weight, refused where nothing holds the rotor.

use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::outcome::Outcome;
use laval::parts::{bearing_hertz::*, disc::*, liquid::*, shaft_lumped::*, stop::*};
use laval::solve::{pencil::modes_about, rest::rest};
use laval::study::{Context, ErasedStudy, modes::Modes, support::About};

const M: f64 = 2.0;
const K: f64 = 1e6;
const CB: f64 = 3e9;
const G: f64 = 9.80665;

fn link() -> Link {
    Link::Between(Attach::on("disc"), Attach::ground())
}

fn machine(shaft: f64, bearing: impl FnOnce(Builder) -> Builder, horizontal: bool) -> System {
    let disc = DiscParams::new(M);
    let shaft = ShaftLumpedParams { stiffness: [shaft; 2], ..ShaftLumpedParams::new() };
    let b = bearing(Builder::new("m").part("disc", Disc::planar(), disc).part("shaft", ShaftLumped::lateral(link()), shaft));
    (if horizontal { b.horizontal() } else { b }).build().unwrap()
}

fn hertz(radial: bool, clearance: f64) -> impl FnOnce(Builder) -> Builder {
    let law = if radial { BearingHertz::radial(link()) } else { BearingHertz::per_axis(link()) };
    move |b| b.part("bearing", law, BearingHertzParams { coefficient: CB, clearance })
}

fn stop(gap: f64) -> impl FnOnce(Builder) -> Builder {
    move |b| b.part("bearing", Stop::new(link()), StopParams { stiffness: 1e7, gap, damping: 0.0 })
}

fn study(system: &System) -> Outcome {
    Modes { speed: 100.0, about: About::Rest, threshold: 0.0, frequency: None }.run(system, &Context::quiet("modes")).unwrap()
}

fn refused(system: &System) -> String {
    rest(system, 100.0).unwrap_err().message.to_string()
}

fn frequencies(system: &System) -> Vec<f64> {
    let mut f: Vec<f64> = modes_about(system, &rest(system, 0.0).unwrap(), true).unwrap().modes.iter().map(|m| m.frequency()).collect();
    f.sort_by(f64::total_cmp);
    f
}

#[test]
fn an_open_bearing_adds_nothing_and_says_where_it_begins() {
    let gap = 1e-4;
    for (horizontal, sag) in [(false, 0.0), (true, M * G / K)] {
        let machines =
            [machine(K, hertz(true, gap), horizontal), machine(K, hertz(false, gap), horizontal), machine(K, stop(gap), horizontal)];
        for system in machines {
            for f in frequencies(&system) {
                assert!((f / (K / M).sqrt() - 1.0).abs() < 1e-12, "{f}");
            }
            let o = study(&system);
            let f = o.findings.iter().find(|f| f.id == "open_gap").unwrap_or_else(|| panic!("{:?}", o.findings));
            assert!((f.value.unwrap() / (gap - sag) - 1.0).abs() < 1e-9 && f.sentence().contains("\"bearing\""), "{f:?}");
        }
    }
}

/// Weight presses the rotor into the bearing: `K d + Cb (d - d0)^1.5 = m g`; the tangent is `1.5 Cb (d - d0)^0.5` along the load and the secant across it.
#[test]
fn a_pressed_bearing_is_linearised_about_its_contact() {
    let d0 = 1e-5;
    let system = machine(K, hertz(true, d0), true);
    let (mut lo, mut hi) = (d0, M * G / K);
    for _ in 0..200 {
        let d = 0.5 * (lo + hi);
        if K * d + CB * (d - d0).powf(1.5) < M * G { lo = d } else { hi = d }
    }
    let (along, across) = (K + 1.5 * CB * (lo - d0).sqrt(), K + CB * (lo - d0).powf(1.5) / lo);
    let f = frequencies(&system);
    for (f, k) in f.iter().zip([across, along]) {
        assert!((f / (k / M).sqrt() - 1.0).abs() < 1e-9, "{f} {}", (k / M).sqrt());
    }
    assert!(study(&system).findings.iter().all(|f| f.id != "open_gap"));
}

#[test]
fn a_bearing_that_alone_holds_the_rotor_is_refused() {
    // under weight the bearing of each axis still holds nothing across
    for (horizontal, radial) in [(false, false), (false, true), (true, false)] {
        let why = refused(&machine(0.0, hertz(radial, 1e-4), horizontal));
        assert!(why.contains("\"bearing\"") && why.contains("no stiffness at rest") && why.contains("preload"), "{why}");
    }
    // at the edge of contact: no clearance and no load, or a sag that just closes it
    assert!(refused(&machine(K, hertz(true, 0.0), false)).contains("preload"));
    assert!(refused(&machine(K, hertz(true, M * G / K), true)).contains("preload"));
    // held, but in one direction only
    let one = |b: Builder| {
        let side = ShaftLumpedParams { stiffness: [K, 0.0], ..ShaftLumpedParams::new() };
        hertz(true, 1e-4)(b).part("side", ShaftLumped::lateral(link()), side)
    };
    assert!(refused(&machine(0.0, one, false)).contains("preload"));
}

/// Nothing but a radial bearing, into which the weight presses the rotor: f = C s^(3/2) = m g at the contact s, 3/2 C sqrt(s) along the load and
/// m g / (gap + s) across it. So with a support that is too soft to carry the rotor, and beneath a second body.
#[test]
fn weight_alone_closes_a_bearing() {
    let gap = 2e-5;
    let contact = |load: f64| (load / CB).powf(2.0 / 3.0);
    for soft in [0.0, 1.0] {
        let system = machine(soft, hertz(true, gap), true);
        let s = contact(M * G);
        let sag = rest(&system, 100.0).unwrap_or_else(|d| panic!("{}", d.message)).q[1];
        assert!((sag / -(gap + s) - 1.0).abs() < 1e-4 * soft + 1e-12, "{sag}");
        let [across, along] = [M * G / (gap + s), 1.5 * CB * s.sqrt()].map(|k| (k / M).sqrt());
        let f = frequencies(&system);
        assert!((f[0] / across - 1.0).abs() < 1e-4 * soft + 1e-10 && (f[f.len() - 1] / along - 1.0).abs() < 1e-4 * soft + 1e-10, "{f:?}");
    }
    let disc = |mass: f64| DiscParams::new(mass);
    let upper = BearingHertz::radial(Link::Between(Attach::on("upper"), Attach::on("disc")));
    let law = BearingHertzParams { coefficient: CB, clearance: gap };
    let stacked = hertz(true, gap)(Builder::new("stacked").part("disc", Disc::planar(), disc(M)))
        .part("upper", Disc::planar(), disc(0.5 * M))
        .part("upper bearing", upper, law)
        .horizontal()
        .build()
        .unwrap_or_else(|d| panic!("{d:?}"));
    let q = rest(&stacked, 100.0).unwrap_or_else(|d| panic!("{}", d.message)).q;
    let lower = -(gap + contact(1.5 * M * G));
    assert!((q[1] / lower - 1.0).abs() < 1e-12 && (q[3] / (lower - gap - contact(0.5 * M * G)) - 1.0).abs() < 1e-12, "{q:?}");
}

/// Coordinates and states elsewhere that nothing holds do not matter: a free disc beside the machine, a liquid.
#[test]
fn only_what_the_bearing_joins_must_be_held() {
    let beside = |b: Builder| {
        let liquid = LiquidParams { wave_damping: 0.0, ..LiquidParams::new(0.07, 0.06, 1000.0, 0.05) };
        hertz(true, 1e-4)(b).part("other", Disc::planar(), DiscParams::new(M)).part(
            "liquid",
            Liquid::new(Attach::on("disc"), Fill::Partial),
            liquid,
        )
    };
    let system = machine(K, beside, false);
    assert!(rest(&system, 100.0).is_ok(), "{}", refused(&system));
}
