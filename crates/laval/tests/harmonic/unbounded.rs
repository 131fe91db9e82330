//! Motions without bound: what is said of them, against closed forms.

use crate::common;

use common::Planar;
use laval::model::builder::Builder;
use laval::model::field::{Attach, Value, Values};
use laval::model::part::Link;
use laval::model::system::System;
use laval::outcome::{Arg, End, Level, Outcome};
use laval::parts::{bearing_cubic::*, damper::*, disc::*, shaft_lumped::*};
use laval::solve::harmonic::branches::response::Request;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::run_up::RunUp;
use laval::study::transient::Transient;
use laval::study::{Context, ErasedStudy, Study};
use laval_num::complex::c;

const M: f64 = 2.0;
const E: f64 = 1e-4;
const K: f64 = 1e6;
/// External and rotating damping, N s/m.
const OUTER: f64 = 20.0;
const INNER: f64 = 400.0;

fn link() -> Link {
    Link::Between(Attach::on("disc"), Attach::ground())
}

fn disc() -> Builder {
    Builder::new("disc").part("disc", Disc::planar(), DiscParams { eccentricity: E, ..DiscParams::new(M) })
}

/// A Jeffcott rotor whose shaft material is damped.
fn jeffcott() -> System {
    let shaft = ShaftLumpedParams { stiffness: [K; 2], material_damping: INNER / K, ..ShaftLumpedParams::new() };
    let air = DamperParams { damping: [OUTER; 2], tilt_damping: 0.0 };
    disc().part("shaft", ShaftLumped::lateral(link()).damped(), shaft).part("air", Damper::fixed(link()), air).build().unwrap()
}

/// Larger real part of the roots of `M s^2 + (OUTER + INNER) s + K - i INNER W`.
fn growth(speed: f64) -> f64 {
    let b = OUTER + INNER;
    let root = (c(b * b - 4.0 * M * K, 4.0 * M * INNER * speed)).sqrt();
    (root.re.abs() - b) / (2.0 * M)
}

fn undamped(cubic: f64) -> System {
    let spring = BearingCubicParams { stiffness: [K; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 };
    disc().part("spring", BearingCubic::isotropic(link()), spring).build().unwrap()
}

fn run<S: Study>(system: &System, list: &[(&str, Value)]) -> Outcome {
    let mut values = Values::default();
    list.iter().for_each(|(name, value)| values.set(name, value.clone(), None));
    let mut d = Default::default();
    S::build(&values, system, &mut d).unwrap_or_else(|| panic!("{d:?}")).run(system, &Context::quiet("t")).unwrap()
}

fn has(o: &Outcome, id: &str) -> bool {
    o.findings.iter().any(|f| f.id == id)
}

#[test]
fn a_growing_transient_ends_at_its_bound() {
    for (speed, duration) in [(3000.0, 2.0), (3000.0, 50.0), (900.0, 30.0)] {
        let o = run::<Transient>(&jeffcott(), &[("duration", Value::Number(duration)), ("speed", Value::Number(speed))]);
        let f = o.findings.iter().find(|f| f.id == "unbounded").unwrap_or_else(|| panic!("{:?}", o.findings));
        let rate = f.value.unwrap();
        assert!((rate / growth(speed) - 1.0).abs() < 1e-3, "{rate} {}", growth(speed));
        let evidence = |what: &str| f.evidence.iter().find(|e| e.what == what).unwrap().value;
        let (at, there) = (evidence("left at"), evidence("displacement there"));
        assert_eq!(o.end, End::Unbounded { at });
        // a hundred thousand typical displacements of 1 mm, passed by less than a step
        assert!(there > 100.0 && there < 200.0 && at < duration, "{there} {at}");
        // nothing that an end left on the way would make wrong
        for id in ["largest_displacement", "end_state", "energy_balance", "growth_rate"] {
            assert!(!has(&o, id), "{id}");
        }
        // the motion shown fills its time
        assert_eq!(o.find_table("motion").unwrap().rows(), 2000);
    }
}

/// What grows without coming far is reported as before, but its last displacement is no largest one.
#[test]
fn a_growing_transient_within_its_bound_has_no_largest_displacement() {
    let o = run::<Transient>(&jeffcott(), &[("duration", Value::Number(0.4)), ("speed", Value::Number(900.0))]);
    assert_eq!(o.end, End::Reached);
    let f = o.findings.iter().find(|f| f.id == "largest_displacement").unwrap();
    assert!(f.message.key == "transient-still-growing", "{}", f.sentence());
    assert!(has(&o, "growth_rate") && has(&o, "energy_balance"));
}

/// `z'' + w^2 z = E w^2 exp(i w t)` from rest: the displacement grows like `E w t/2`, beside a part that stays below E. There is no rate.
#[test]
fn growth_at_an_undamped_resonance_is_linear_in_time() {
    let w = (K / M).sqrt();
    let o = run::<Transient>(&undamped(0.0), &[("duration", Value::Number(400.0 / w)), ("speed", Value::Number(w))]);
    assert!(!has(&o, "growth_rate"), "{:?}", o.findings);
    let f = o.findings.iter().find(|f| f.id == "no_growth_rate").unwrap_or_else(|| panic!("{:?}", o.findings));
    assert!(f.level == Level::Warning && f.message.key == "transient-grows-linearly" && f.unit == "m/s", "{f:?}");
    assert!((f.value.unwrap() / (0.5 * E * w) - 1.0).abs() < 0.02, "{f:?}");
    let f = o.findings.iter().find(|f| f.id == "largest_displacement").unwrap();
    assert!(f.message.key == "transient-still-growing", "{}", f.sentence());
}

#[test]
fn a_run_up_is_left_where_it_passes_its_bound() {
    let o = run::<RunUp>(&jeffcott(), &[("duration", Value::Number(5.0)), ("to", Value::Number(3000.0))]);
    assert!(has(&o, "unbounded") && !has(&o, "largest_displacement") && !has(&o, "energy_balance"), "{:?}", o.findings);
    assert!(!has(&o, "largest_torque") && o.findings.iter().any(|f| f.id == "unbounded" && f.value.is_some()), "{:?}", o.findings);
    let End::Unbounded { at } = o.end else { panic!("{:?}", o.end) };
    // above the onset w0 (1 + OUTER / INNER)
    assert!(at > (K / M).sqrt() * (1.0 + OUTER / INNER) && at < 3000.0, "{at}");
}

/// Without damping the response has a pole: the displacement where a branch was left is no maximum.
#[test]
fn an_undamped_response_has_no_largest_displacement() {
    let o = NonlinearResponse::new(Request::over(100.0, 3000.0)).run(&undamped(0.0), &Context::quiet("r")).unwrap();
    assert!(has(&o, "unbounded_displacement") && !has(&o, "largest_displacement"), "{:?}", o.findings);
    let f = o.findings.iter().find(|f| f.id == "unbounded_displacement").unwrap();
    let left = f.evidence.iter().find(|e| e.what == "speed").map(|e| e.value);
    assert!(f.sentence().contains("was left") && left.is_some() && f.number("speed") == left && f.value > Some(0.0), "{f:?}");
    assert!(o.figures.iter().all(|f| !f.alt.to_string().contains("the largest,")), "{:?}", o.figures[0].alt);
    // used up points are no bound either
    let request = Request { max_points: 20, ..Request::over(500.0, 3000.0) };
    let o = NonlinearResponse::new(request).run(&undamped(3e10), &Context::quiet("r")).unwrap();
    assert!(has(&o, "largest_displacement_not_reached") && !has(&o, "largest_displacement"), "{:?}", o.findings);
    // a branch that meets the end of the range has a largest displacement there
    let o = NonlinearResponse::new(Request::over(100.0, 3000.0)).run(&undamped(3e10), &Context::quiet("r")).unwrap();
    let f = o.findings.iter().find(|f| f.id == "largest_displacement").unwrap();
    // (K + k3 r^2 - M W^2) r = M E W^2 at the end of the range
    let (r, w) = (f.value.unwrap(), 3000.0);
    assert!(((K + 3e10 * r * r - M * w * w) * r / (M * E * w * w) - 1.0).abs() < 1e-6, "{r}");
    assert!(
        f.message.args.contains(&("place", Arg::word("end"))) && f.number("speed").is_some_and(|at| (at - w).abs() < 1e-9 * w),
        "{f:?}"
    );
}

/// The range of instability in words ends where it is located: the onset of a Jeffcott rotor with inner damping.
#[test]
fn the_range_of_instability_begins_at_the_closed_form() {
    let onset = (K / M).sqrt() * (1.0 + OUTER / INNER);
    let o = NonlinearResponse::new(Request::over(100.0, 3000.0)).run(&jeffcott(), &Context::quiet("r")).unwrap();
    let f = o.findings.iter().find(|f| f.id == "unstable_states").unwrap_or_else(|| panic!("{:?}", o.findings));
    let range = format!("from {} rad/s to 3000 rad/s", laval::outcome::significant(onset, 4));
    assert!(f.sentence().contains(&range), "{} {range}", f.sentence());
    assert!((f.value.unwrap() / growth(3000.0) - 1.0).abs() < 1e-9);
    let changes: Vec<f64> = o.special_points.iter().filter(|p| p.kind == "Neimark-Sacker").map(|p| p.at).collect();
    assert_eq!(changes.len(), 1);
    assert!((changes[0] / onset - 1.0).abs() < 1e-9, "{} {onset}", changes[0]);
}

/// The bands of a partly filled rotor without damping begin and end at double roots of its whirl polynomial.
#[test]
fn the_range_of_instability_is_the_band_of_the_liquid() {
    // instability_bands_undamped.csv: 25 kg, free surface at 0.99 of the cavity's radius
    let (open, close) = (1971.9262813223, 2847.9945816);
    let linear = [("bearing.cubic_stiffness", 0.0), ("drum.eccentricity", 1e-6)];
    let system = Planar { fill: 0.99, chi: 0.0, chi0: 0.0, ..Planar::default() }.build().with(&linear).unwrap();
    // above the synchronous resonance, which does not know the fill
    let o = NonlinearResponse::new(Request::over(1960.0, 2900.0)).run(&system, &Context::quiet("r")).unwrap();
    let f = o.findings.iter().find(|f| f.id == "unstable_states").unwrap_or_else(|| panic!("{:?}", o.findings));
    let range = format!("from {} rad/s to {} rad/s", laval::outcome::significant(open, 4), laval::outcome::significant(close, 4));
    assert!(f.sentence().contains(&range), "{} {range}", f.sentence());
    let changes: Vec<f64> = o.special_points.iter().filter(|p| p.kind == "Neimark-Sacker").map(|p| p.at).collect();
    assert_eq!(changes.len(), 2, "{changes:?}");
    // growth rises with the root of the distance from the edge and is seen once it exceeds the error of a double root
    for (found, edge) in changes.iter().zip([open, close]) {
        assert!((found / edge - 1.0).abs() < 1e-7, "{found} {edge}");
    }
}
