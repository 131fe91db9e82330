//! Free whirls at fixed spin: closed forms, energy, limits, and the reference tables of the planar machine.

use crate::common;

use common::base::{Base, defect};
use common::{number, rows};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::{At, Link};
use laval::model::system::{System, Workspace};
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::pace::Pace;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::measure::Measure;
use laval::solve::harmonic::free::backbone::{Backbone, Origin, Request, at_amplitude, backbone};
use laval::solve::symmetry::Symmetry;
use laval_num::continuation::End;
use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

/// sqrt(c0/m) and sqrt(c0/c1) of the base set.
const W0: f64 = 2140.872096444188;
const LENGTH: f64 = 0.0112444;

fn undamped() -> Base {
    Base { chi: 0.0, chi0: 0.0, ..Base::default() }
}

fn request(speed: f64) -> Request {
    Request { speed, amplitudes: None, harmonics: None, truncation: 1e-9, max_points: 5_000, work: u64::MAX }
}

fn found(base: Base, request: Request) -> (System, Backbone) {
    let system = base.builder().build().unwrap();
    let found = backbone(&system, &request, &NEVER, &|_| {}).unwrap();
    (system, found)
}

/// G of `docs/theory/liquid-plane-flow.md#frequency-form` at delta = 0.
fn liquid(w: f64, speed: f64, fill: f64) -> f64 {
    let q = 1.0 / (fill * fill);
    let g = (q - 1.0) / (q + 1.0);
    let s = w - speed;
    let top = s * s - 2.0 * s * speed - speed * speed;
    top / (s * s / g - 2.0 * s * speed - speed * speed)
}

/// Condensed stiffness K of an undamped machine at whirl frequency w.
fn condensed(b: &Base, w: f64, speed: f64) -> f64 {
    let full = std::f64::consts::PI * 0.07 * 0.07 * 0.06 * 1000.0;
    let m = 2.4 + b.fill.map_or(0.0, |f| full * liquid(w, speed, f));
    let (k1, k2) = (-m * w * w, b.c2 - b.foundation * w * w);
    k1 * k2 / (k1 + k2)
}

/// Isotropic law: every free whirl obeys `a^2 = -(K(w) + c0)/c1`, with and without liquid, from both ends.
#[test]
fn isotropic_families_are_the_closed_form() {
    for fill in [None, Some(0.93), Some(0.667)] {
        for s in [0.3, 0.85, 1.0, 1.4, 2.5] {
            let base = Base { isotropic: true, fill, ..undamped() };
            let (_, f) = found(base, request(s * W0));
            assert_eq!(f.discretisation.symmetry, Symmetry::Circular);
            assert!(!f.families.is_empty());
            for family in &f.families {
                assert!(matches!(family.end, End::Reached), "{fill:?} {s}: {:?}", family.end);
                for m in &family.motions {
                    let k = condensed(&base, m.frequency, s * W0);
                    // relative to the elastic force, which nearly cancels the rest where the amplitude is small
                    let rest = (k + base.c0 + base.c1 * m.amplitude * m.amplitude).abs();
                    let slope = (condensed(&base, m.frequency * (1.0 + 1e-7), s * W0) - k).abs() / 1e-7;
                    assert!(rest < 1e-9 * (base.c0 + k.abs()) + 1e-11 * slope, "{fill:?} {s} {:?}: {rest:e} at {m:?}", family.origin);
                    assert!(m.drive.abs() < 1e-9 * m.frequency.abs(), "{}", m.drive);
                }
            }
        }
    }
}

/// Equal to a number printed with nine significant digits.
fn printed(got: f64, want: f64) -> bool {
    (got - want).abs() <= 0.501 * 10f64.powi(want.abs().log10().floor() as i32 - 8)
}

/// Asymptotes and linear modes of the table, and asymptotes obey (M + m + mL G) w^2 = c2.
#[test]
fn asymptotes_and_linear_modes_of_the_table() {
    let mut count = 0;
    for r in rows(include_str!("../reference/planar/free_whirl_critical.csv")) {
        let (mass, fill, s) = (number(r[0]), number(r[1]), number(r[3]));
        let base = Base { foundation: mass, fill: (fill < 1.0).then_some(fill), isotropic: true, ..undamped() };
        // families are not followed here
        let (_, f) = found(base, Request { max_points: 2, ..request(s * W0) });
        let list = |cell: &str| cell.split('|').filter(|c| !c.is_empty()).map(number).collect::<Vec<f64>>();
        let wanted = list(r[4]);
        let got: Vec<f64> = f.asymptotes.iter().map(|a| a.value.im / W0).filter(|w| *w > 0.0).collect();
        assert_eq!(got.len(), wanted.len(), "{r:?}: {got:?}");
        for (g, w) in got.iter().zip(&wanted) {
            assert!(printed(*g, *w), "{r:?}: {g} {w}");
            let full = std::f64::consts::PI * 0.07 * 0.07 * 0.06 * 1000.0;
            let liquid = if fill < 1.0 { full * liquid(g * W0, s * W0, fill) } else { 0.0 };
            let inertia = (mass + 2.4) * (g * W0).powi(2);
            let rest = inertia + liquid * (g * W0).powi(2) - base.c2;
            assert!(rest.abs() < 1e-6 * base.c2.max(inertia), "{r:?}: {rest:e}");
        }
        let mut got: Vec<f64> = f.modes.iter().filter(|m| m.value.im > 0.0 && m.left.is_none()).map(|m| m.value.im / W0).collect();
        got.sort_by(f64::total_cmp);
        let wanted = list(r[5]);
        assert_eq!(got.len(), wanted.len(), "{r:?}: {got:?} {:?}", f.modes);
        for (g, w) in got.iter().zip(&wanted) {
            assert!(printed(*g, *w), "{r:?}: {g} {w}");
        }
        count += 1;
    }
    assert!(count > 20);
}

/// One plane of the empty machine, at the table's peak amplitudes: one harmonic and eleven.
#[test]
fn backbone_of_the_table() {
    let to = 6.0 * LENGTH;
    for (harmonics, column) in [(1, 1), (21, 3)] {
        let (system, f) = found(undamped(), Request { harmonics: Some(harmonics), amplitudes: Some((1e-4, to)), ..request(1000.0) });
        assert_eq!(f.discretisation.symmetry, Symmetry::Quarter);
        let bearing = f.families.iter().find(|f| f.motions[0].frequency > 1000.0).unwrap();
        let length = (1.1e7f64 / 8.7e10).sqrt();
        for r in rows(include_str!("../reference/planar/backbone_empty.csv")) {
            let wanted = number(r[0]) * length;
            // the first order whose motion peaks at the wanted amplitude
            let at = |a: f64| at_amplitude(&system, &f, bearing, 1000.0, a).unwrap();
            let mut a = wanted;
            for _ in 0..40 {
                // the peak lies where the leading harmonic has it: at the start
                let peak: f64 = at(a).x.iter().step_by(2).sum();
                a *= wanted / peak;
            }
            let w = at(a).frequency / W0;
            assert!((w - number(r[column])).abs() < 2e-9 * w, "{harmonics} {r:?}: {w}");
        }
    }
}

/// A rotor on a Duffing bearing to ground: w = pi sqrt(c0 (1 + A^2) / m) / (2 K), k^2 = A^2/(2 (1 + A^2)).
#[test]
fn duffing_frequency_is_elliptic() {
    let link = Link::Between(Attach::on("disc"), Attach::ground());
    let law = BearingCubicParams { stiffness: [2e6; 2], cubic_stiffness: [3e12; 2], valid_to: 0.0 };
    let system = Builder::new("one body")
        .part("disc", Disc::planar(), DiscParams { eccentricity: 1e-4, ..DiscParams::new(3.0) })
        .part("spring", BearingCubic::per_axis(link), law)
        .build()
        .unwrap();
    let f = backbone(&system, &Request { truncation: 1e-12, ..request(100.0) }, &NEVER, &|_| {}).unwrap();
    assert_eq!((f.families.len(), f.asymptotes.len()), (1, 0));
    assert!(f.families[0].motions.len() > 10);
    for m in &f.families[0].motions {
        let peak: f64 = m.x.iter().step_by(2).sum();
        let a2 = peak * peak * 3e12 / 2e6;
        let k = laval_num::elliptic::complete_first(a2 / (2.0 * (1.0 + a2)));
        let w = std::f64::consts::PI * (2e6 / 3.0 * (1.0 + a2)).sqrt() / (2.0 * k);
        assert!((m.frequency - w).abs() < 1e-10 * w, "{} {w}", m.frequency);
    }
}

/// Damped machine: the drive feeds in over a period what the machine dissipates, and the motion balances all forces.
#[test]
fn drive_makes_up_for_the_losses() {
    for isotropic in [true, false] {
        let (system, f) = found(Base { isotropic, ..Base::default() }, request(500.0));
        let masses = [2.4, 25.0];
        let mut seen = 0;
        for family in &f.families {
            for m in family.motions.iter().step_by(5) {
                let mut balance = Balance::new(&system, f.discretisation, (900.0, 1000.0), None).unwrap();
                balance.set_free(Pace { speed: 500.0, frequency: m.frequency, drive: m.drive, rate: [0.0; 3], parameter: None });
                let orbit = Orbit::of(&mut balance, &m.x, 500.0).unwrap();
                let (mut fed, mut lost, count) = (0.0, 0.0, 64);
                for j in 0..count {
                    let (mut q, mut v, mut a, mut z) = (vec![0.0; 4], vec![0.0; 4], vec![0.0; 4], vec![]);
                    orbit.at(TAU * f64::from(j) / f64::from(count), &mut q, &mut v, &mut a, &mut z);
                    let at = At { q: &q, v: &v, a: &a, z: &z, phase: 0.0, speed: 500.0, spin_accel: 0.0, t: 0.0 };
                    lost += system.energy(system.params(), &at, &mut Workspace::default()).unwrap().dissipated;
                    fed += m.drive * (0..4).map(|i| masses[i / 2] * v[i] * v[i]).sum::<f64>();
                }
                assert!(lost > 0.0 && (fed - lost).abs() < 1e-7 * lost, "{fed} {lost}");
                seen += 1;
            }
        }
        assert!(seen > 10);
    }
    // without damping the whole machine is in balance by itself, unbalance apart
    let (system, f) = found(Base { e: 0.0, fill: Some(0.8), ..undamped() }, request(0.5 * W0));
    for m in f.families.iter().flat_map(|f| &f.motions).step_by(7) {
        let mut balance = Balance::new(&system, f.discretisation, (900.0, 1000.0), None).unwrap();
        balance.set_free(Pace { speed: 0.5 * W0, frequency: m.frequency, drive: 0.0, rate: [0.0; 3], parameter: None });
        let orbit = Orbit::of(&mut balance, &m.x, 0.5 * W0).unwrap();
        let d = defect(&system, &orbit, 1);
        // what the orders leave out is what is missing
        assert!(d < 1e-8 + 10.0 * m.truncation, "{d:e} {:e}", m.truncation);
    }
}

/// Inside an instability band two linear modes have merged and none starts there; the families come from infinity.
#[test]
fn families_of_a_merged_band_come_from_infinity() {
    let (_, f) = found(Base { isotropic: true, fill: Some(0.667), ..undamped() }, request(W0 * 1.4));
    assert!(f.modes.iter().any(|m| m.left.is_some_and(|w| w.contains("merged"))));
    assert!(f.families.iter().any(|f| matches!(f.origin, Origin::Asymptote(_)) && f.motions.len() > 5));
}

/// Supports that differ in x and y: families of both planes, each the elliptic one when nothing couples them.
#[test]
fn unequal_planes_whirl_apart() {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let system = Builder::new("two planes")
        .part("disc", Disc::planar(), DiscParams::new(3.0))
        .part(
            "spring",
            BearingCubic::per_axis(link()),
            BearingCubicParams { stiffness: [2e6, 5e6], cubic_stiffness: [3e12, 1e12], valid_to: 0.0 },
        )
        .build()
        .unwrap();
    let f = backbone(&system, &Request { truncation: 1e-12, ..request(100.0) }, &NEVER, &|_| {}).unwrap();
    assert_eq!((f.discretisation.symmetry, f.families.len()), (Symmetry::Half, 2));
    for (family, (c0, c1)) in f.families.iter().zip([(2e6, 3e12), (5e6, 1e12)]) {
        assert!(matches!(family.end, End::Reached), "{:?}", family.end);
        for m in &family.motions {
            // forward and backward harmonics of one size: their sum is the plane's amplitude
            let orders = 2.0 * m.x.iter().step_by(4).zip(m.x.iter().skip(1).step_by(4)).map(|(x, y)| x.hypot(*y)).next().unwrap();
            assert!((orders - 2.0 * m.amplitude).abs() < 1e-9 * orders);
            let mut balance = Balance::new(&system, f.discretisation, (900.0, 1000.0), None).unwrap();
            balance.set_free(Pace { speed: 100.0, frequency: m.frequency, drive: 0.0, rate: [0.0; 3], parameter: None });
            let orbit = Orbit::of(&mut balance, &m.x, 100.0).unwrap();
            let (peak, _) = Measure::Probe(0).largest(&system, &orbit, 1);
            let a2 = peak * peak * c1 / c0;
            let k = laval_num::elliptic::complete_first(a2 / (2.0 * (1.0 + a2)));
            let w = std::f64::consts::PI * (c0 / 3.0 * (1.0 + a2)).sqrt() / (2.0 * k);
            assert!((m.frequency - w).abs() < 1e-9 * w, "{} {w}", m.frequency);
        }
    }
}

/// What cannot be requested is refused by name.
#[test]
fn unfit_machines_are_refused() {
    let linear = Builder::new("linear")
        .part("disc", Disc::planar(), DiscParams::new(3.0))
        .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: [1e6; 2], damping: [1.0; 2] })
        .part(
            "air",
            Damper::fixed(Link::Between(Attach::on("disc"), Attach::on("base"))),
            DamperParams { damping: [1.0; 2], tilt_damping: 0.0 },
        )
        .build()
        .unwrap();
    let e = backbone(&linear, &request(100.0), &NEVER, &|_| {}).err().unwrap();
    assert!(e.message.contains("all parts of this machine are linear"), "{}", e.message);
}
