//! Forces, self-centring and tuned foundations as the study of the nonlinear response tells them: against the reference tables and closed forms.

use crate::common;
use laval::model::system::Pair;

use common::base::Base;
use common::{number, rows};
use laval::outcome::{Arg, Data, Finding, Level, Message, Outcome};
use laval::solve::centring::limit;
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::measure::Measure;
use laval::solve::harmonic::branches::response::Request;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::{Context, ErasedStudy};
use std::f64::consts::TAU;

fn reported(base: Base, speed: Option<f64>, request: Request) -> Outcome {
    let builder = match speed {
        Some(w) => base.builder().speed(w),
        None => base.builder(),
    };
    let system = builder.build().unwrap_or_else(|d| panic!("{:?}", d.0));
    NonlinearResponse::new(request).run(&system, &Context::quiet("response")).unwrap()
}

fn all<'a>(o: &'a Outcome, id: &str, subject: &str) -> Vec<&'a Finding> {
    o.findings.iter().filter(|f| f.id == id && f.subject == subject).collect()
}

fn said<'a>(o: &'a Outcome, id: &str, subject: &str) -> &'a Finding {
    all(o, id, subject).first().copied().unwrap_or_else(|| panic!("no {id} of {subject} in {:?}", o.findings))
}

fn evidence(f: &Finding, what: &str) -> f64 {
    f.evidence.iter().find(|e| e.what == what).unwrap_or_else(|| panic!("no {what} in {f:?}")).value
}

fn column(o: &Outcome, name: &str) -> Vec<f64> {
    match &o.find_table("response").unwrap().column(name).unwrap().data {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn near(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a:.15e} {b:.15e}");
}

fn one_harmonic(lo: f64, hi: f64) -> Request {
    Request { harmonics: Some(1), stability: false, ..Request::over(lo, hi) }
}

/// Names of the columns of a table.
fn heads(text: &str) -> Vec<&str> {
    text.lines().find(|l| !l.starts_with('#')).unwrap().split(',').collect()
}

fn filled(r: &str) -> Option<f64> {
    let r: f64 = r.parse().unwrap();
    (r < 1.0).then_some(r)
}

/// Every row: motion and forces at the top of the range on the branch of small motions, and the limits, which do not depend on the fill.
#[test]
fn self_centring_agrees_with_the_table() {
    let (c0, c1, c2, chi0) = (1.1e7, 8.7e10, 3.26e5f64, 6.59);
    let text = include_str!("../reference/planar/self_centring.csv");
    let heads = heads(text);
    for row in rows(text) {
        let n = |k: &str| number(row[heads.iter().position(|h| *h == k).unwrap()]);
        let base = Base { fill: filled(row[0]), ..Base::default() };
        let top = n("speed_rad_per_s");
        let o = reported(base, None, one_harmonic(0.9 * top, top));
        let speeds = column(&o, "speed");
        // where several states exist at the top, that of the smallest motion
        let at: Vec<usize> = (0..speeds.len()).filter(|&i| speeds[i] == top).collect();
        let z1 = column(&o, "drum first order");
        let i = at.into_iter().min_by(|a, b| z1[*a].total_cmp(&z1[*b])).unwrap();
        near(z1[i], n("z1_m"), 1e-8);
        let z2 = column(&o, "base first order")[i];
        near(z2, n("z2_m"), 1e-8);
        near(column(&o, "base ground force")[i], c2.hypot(chi0 * top) * z2, 1e-9);
        // circular motion: the largest force of a law per axis is reached on the axes, its first harmonic has 3/4 of the cubic term
        let d = column(&o, "bearing deflection")[i];
        near(column(&o, "bearing force")[i], c0 * d + c1 * d.powi(3), 1e-9);
        near(c0 * d + 0.75 * c1 * d.powi(3), n("bearing_force_N"), 1e-8);
        let system = base.builder().build().unwrap();
        let found = limit(&system, top).unwrap();
        near(found.orbit.whirl(&Pair::coordinates(0), 1).0.abs(), n("limit_z1_m"), 1e-9);
        assert!(found.orbit.whirl(&Pair::coordinates(2), 1).0.abs() < 1e-9 * n("limit_z1_m"));
        let a = n("limit_z1_m");
        near(Measure::Force(2).largest(&system, &found.orbit, 1).0, c0 * a + c1 * a.powi(3), 1e-9);
        near(c0 * a + 0.75 * c1 * a.powi(3), n("limit_bearing_force_N"), 1e-9);
    }
}

/// The displacement tends to -m e/(m + mL), the difference falls like the inverse square of the speed, and what is reported of the speed of 1 % is so.
#[test]
fn the_way_to_self_centring_is_reported() {
    for (fill, mass) in [(None, 2.4), (Some(0.667), 2.4 + 0.92362824)] {
        let base = Base { fill, isotropic: true, phase: 0.7, ..Base::default() };
        let o = reported(base, None, Request { stability: false, ..Request::over(5e3, 4e4) });
        let f = said(&o, "self_centring", "drum");
        let goal = 2.4e-3 / mass;
        near(f.value.unwrap(), goal, 1e-8);
        let (w, z) = (column(&o, "speed"), column(&o, "drum first order"));
        // the upper branch of the hysteresis goes on beyond the range
        let top = (0..w.len()).filter(|&i| w[i] == 4e4).min_by(|a, b| z[*a].total_cmp(&z[*b])).unwrap();
        near(evidence(f, "displacement at the top of the range, first order"), z[top], 1e-12);
        // the damping turns the motion by c/(m W) against the limit
        let turned = 42.0 / (mass * 4e4);
        near(evidence(f, "relative difference there"), (z[top] / goal - 1.0).hypot(turned), 1e-3);
        assert!((evidence(f, "d ln difference / d ln speed") + 2.0).abs() < 0.03, "{f:?}");
        let (c0, c1) = (1.1e7, 8.7e10);
        near(said(&o, "force_limit", "bearing").value.unwrap(), c0 * goal + c1 * goal.powi(3), 1e-8);
        assert!(all(&o, "self_centring", "base").is_empty() && all(&o, "force_limit", "air").is_empty());
    }
    // below the resonances nothing is reported of a limit far away
    let o = reported(Base::default(), None, Request { stability: false, ..Request::over(300.0, 1500.0) });
    assert!(o.findings.iter().all(|f| f.id != "self_centring" && f.id != "force_limit"));
}

/// Jeffcott rotor: `|1 + z/e| = sqrt((1 + (2 zeta r)^2) / ((1 - r^2)^2 + (2 zeta r)^2))`. The speed of 1 % is stated where it lies in the range; a range
/// that ends near the resonance gives no law to continue.
#[test]
fn the_speed_of_self_centring_is_not_continued_from_near_a_resonance() {
    let machine = "[machine]\nname = \"jeffcott\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = \"10 kg\"\neccentricity = \"100 um\"\n[[part]]\n\
        kind = \"shaft_lumped\"\nbetween = [\"d\", \"ground\"]\nstiffness = \"1e5 N/m\"\n[[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\n\
        damping = \"40 N s/m\"\n";
    let exact = |speed: f64| {
        let (r, z) = (speed / 100.0, 2.0 * 0.02 * speed / 100.0);
        ((1.0 + z * z) / ((1.0 - r * r).powi(2) + z * z)).sqrt()
    };
    let (mut lo, mut hi) = (150.0, 3000.0);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if exact(middle) > 0.01 { lo = middle } else { hi = middle }
    }
    assert!((lo - 1045.0).abs() < 1.0, "{lo}");
    let found = |top: f64| {
        let study = format!("[[study]]\nkind = \"nonlinear_response\"\nspeed = {{ from = \"50 rad/s\", to = \"{top} rad/s\" }}\n");
        let o = common::files::run_all(&format!("{machine}{study}")).remove(0);
        let f = said(&o, "self_centring", "d");
        // a difference of displacements, which balance knows to 1e-7 of their size
        assert!((evidence(f, "relative difference there") - exact(top)).abs() < 1e-7, "{top}");
        let local = (exact(top) / exact(0.97 * top)).ln() / (1.0f64 / 0.97).ln();
        (f.notes.clone(), evidence(f, "d ln difference / d ln speed"), local)
    };
    // that the difference is below 1 %, and from which speed on
    let speed = |notes: &[Message], key: &str| {
        let [note] = notes else { panic!("{notes:?}") };
        assert!(note.key == key && note.args.contains(&("close", Arg::percent(0.01))), "{note:?}");
        match note.args.iter().find(|a| a.0 == "from").map(|a| &a.1) {
            Some(Arg::Quantity(q)) => q.value,
            _ => panic!("{note:?}"),
        }
    };
    let (notes, power, local) = found(150.0);
    assert!(notes.is_empty(), "{notes:?}");
    assert!((power / local - 1.0).abs() < 0.2, "{power} {local}");
    let (notes, ..) = found(1100.0);
    near(speed(&notes, "nonlinear-response-centred"), lo, 0.005);
    let (notes, ..) = found(800.0);
    near(speed(&notes, "nonlinear-response-centred-beyond"), lo, 0.02);
}

/// Forces on both bodies balance in every state: what the bearing transmits moves the foundation.
#[test]
fn forces_balance_in_every_state() {
    let base = Base { isotropic: true, chi: 600.0, ..Base::default() };
    let o = reported(base, None, Request { stability: false, ..Request::over(25.0, 8e3) });
    let (w, z2) = (column(&o, "speed"), column(&o, "base first order"));
    let (bearing, ground) = (column(&o, "bearing force"), column(&o, "base ground force"));
    assert!(w.len() > 100);
    for i in 0..w.len() {
        near(bearing[i], (3.26e5 - 25.0 * w[i] * w[i]).hypot(6.59 * w[i]) * z2[i], 1e-8);
        near(ground[i], 3.26e5f64.hypot(6.59 * w[i]) * z2[i], 1e-9);
    }
}

/// Largest values over the period are those of a fine search, also of motions that are not circular; findings tell the largest of all.
#[test]
fn largest_forces_over_the_period() {
    let base = Base { chi: 600.0, ..Base::default() };
    let request = Request { stability: false, ..Request::over(25.0, 8e3) };
    let o = reported(base, None, request);
    let system = base.builder().build().unwrap();
    let response = common::base::run(base.builder(), request);
    let mut balance = Balance::new(&system, response.discretisation.whole(), request.speeds, None).unwrap();
    let (force, speed) = (column(&o, "bearing force"), column(&o, "speed"));
    let states: Vec<_> = response.branches.iter().flat_map(|b| &b.points).collect();
    let mut noncircular = 0;
    for i in (0..states.len()).step_by(7) {
        let orbit = Orbit::of(&mut balance, &states[i].x, states[i].speed).unwrap();
        let at = |tau: f64| Measure::Force(2).square_at(&system, &orbit, 1, tau).sqrt();
        let fine = (0..20_000).map(|j| at(TAU * f64::from(j) / 20_000.0)).fold(0.0, f64::max);
        let (largest, tau) = Measure::Force(2).largest(&system, &orbit, 1);
        near(largest, fine, 1e-7);
        near(at(tau), largest, 1e-13);
        near(force[i], fine, 1e-7);
        noncircular += usize::from(at(0.4) < 0.99 * fine);
    }
    assert!(noncircular > 3, "{noncircular}");
    let f = said(&o, "largest_force", "bearing");
    let (value, at) = (f.value.unwrap(), evidence(f, "speed"));
    let most = (0..force.len()).max_by(|a, b| force[*a].total_cmp(&force[*b])).unwrap();
    assert!(value >= force[most] * (1.0 - 1e-6) && value < 1.01 * force[most], "{value} {}", force[most]);
    assert!((at - speed[most]).abs() < 5.0 && evidence(f, "scaled residual") < 1e-10, "{f:?}");
}

/// `K2 = c2 - M W^2 + i chi0 W` is the force of the bearing over the displacement of the foundation: without damping the force vanishes at `W^2 = c2/M`, with
/// damping about `chi0 W m e/(m + mL)` is left.
#[test]
fn the_force_of_the_bearing_vanishes_where_the_foundation_is_in_tune() {
    let tuned = (3.26e5f64 / 25.0).sqrt();
    for (chi0, fill) in [(0.0, None), (6.59, None), (6.59, Some(0.8))] {
        let base = Base { chi0, fill, ..Base::default() };
        let o = reported(base, None, Request { stability: false, ..Request::over(60.0, 600.0) });
        let f = said(&o, "vanishing_force", "bearing");
        near(f.value.unwrap(), tuned, 1e-3);
        let left = evidence(f, "force there");
        if chi0 == 0.0 {
            near(f.value.unwrap(), tuned, 1e-7);
            // beside 10 N on both sides
            assert!(left < 1e-5, "{left}");
        } else {
            let mass = if fill.is_some() { 2.4 + 0.92362824 } else { 2.4 };
            near(left, chi0 * tuned * 2.4e-3 / mass, 0.02);
        }
        assert!(evidence(f, "width of the bracket") < 1e-6);
    }
}

/// Every row of the table: the stiffness, the force that is left, and that the state of the filled rotor at 3000 rad/s does not last.
#[test]
fn tuned_foundations_agree_with_the_table() {
    let text = include_str!("../reference/planar/foundation_tuning.csv");
    let heads = heads(text);
    for row in rows(text) {
        let n = |k: &str| number(row[heads.iter().position(|h| *h == k).unwrap()]);
        let (speed, fill) = (n("speed_rad_per_s"), filled(row[0]));
        let base = Base { chi: n("chi_kg_per_s"), chi0: n("chi0_kg_per_s"), fill, ..Base::default() };
        let o = reported(base, Some(speed), Request { stability: true, ..one_harmonic(0.9 * speed, 1.1 * speed) });
        let f = said(&o, "foundation_tuning", "bearing");
        near(f.value.unwrap(), n("c2_N_per_m"), 1e-12);
        let left = evidence(f, "force when tuned");
        if base.chi0 == 0.0 {
            assert!(left < 1e-6, "{left}");
        } else {
            near(left, n("bearing_force_N"), 3e-6);
            if fill.is_some() && speed == 3000.0 {
                near(evidence(f, "growth rate when tuned"), 185.6, 1e-3);
                assert!(f.level == Level::Warning && f.sentence().contains("The tuned response is unstable"), "{}", f.sentence());
            }
        }
    }
    // nothing is said of a speed outside the range, and of machines without one
    for speed in [None, Some(9e3)] {
        let o = reported(Base::default(), speed, one_harmonic(300.0, 2000.0));
        assert!(o.findings.iter().all(|f| f.id != "foundation_tuning"));
    }
}
