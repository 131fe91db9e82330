//! Machines on oil films: onset of oil whirl of a rigid rotor by the printed coefficients of the short bearing, circles of a rotor in a squeeze-film damper.

use super::overview::{check, page};
use crate::common::files::{load, run_all};
use laval::outcome::Verdict;
use laval::prelude::construct;
use laval::solve::pencil::Linearised;
use laval::solve::rest::rest;
use laval::study::forced_response::{ForcedResponse, LINEARISED};
use laval::study::{Context, Study};
use laval_num::complex::{C64, c};
use serde_json::json;
use std::f64::consts::PI;

const LOAD: f64 = 525.0;
const D: f64 = 0.1;
const L: f64 = 0.03;
const C: f64 = 1e-4;
const MU: f64 = 0.1;

/// Load over `mu W R L^3/(4 c^2)` at an eccentricity.
fn capacity(e: f64) -> f64 {
    let m = 1.0 - e * e;
    e / (m * m) * (PI * PI * m + 16.0 * e * e).sqrt()
}

/// The eccentricity at a spin speed.
fn eccentricity(speed: f64) -> f64 {
    let unit = MU * speed * D / 2.0 * L.powi(3) / (4.0 * C * C);
    let (mut low, mut high) = (0.0, 0.999_999);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if unit * capacity(middle) < LOAD { low = middle } else { high = middle }
    }
    low
}

/// A rigid mass on one bearing is stable: Routh's criterion with the eight coefficients as printed by Friswell et al. 2010, section 5.5.
fn stable(speed: f64) -> bool {
    let e = eccentricity(speed);
    let (m, root) = (1.0 - e * e, (1.0 - e * e).sqrt());
    let p2 = PI * PI;
    let h = (p2 * m + 16.0 * e * e).powf(-1.5) * LOAD / C;
    let kuu = h * 4.0 * (p2 * (2.0 - e * e) + 16.0 * e * e);
    let kuv = h * PI * (p2 * m * m - 16.0 * e.powi(4)) / (e * root);
    let kvu = -h * PI * (p2 * m * (1.0 + 2.0 * e * e) + 32.0 * e * e * (1.0 + e * e)) / (e * root);
    let kvv = h * 4.0 * (p2 * (1.0 + 2.0 * e * e) + 32.0 * e * e * (1.0 + e * e) / m);
    let cuu = h / speed * 2.0 * PI * root * (p2 * (1.0 + 2.0 * e * e) - 16.0 * e * e) / e;
    let cuv = -h / speed * 8.0 * (p2 * (1.0 + 2.0 * e * e) - 16.0 * e * e);
    let cvv = h / speed * 2.0 * PI * (p2 * m * m + 48.0 * e * e) / (e * root);
    // at the onset (k - w^2 m) of the whirl w satisfies both parts of the determinant
    let k = (kuu * cvv + kvv * cuu - (kuv + kvu) * cuv) / (cuu + cvv);
    let w2 = ((kuu - k) * (kvv - k) - kuv * kvu) / (cuu * cvv - cuv * cuv);
    k > w2 * LOAD / 9.80665
}

/// The speed at which a property of rising speeds ends.
fn end(holds: impl Fn(f64) -> bool, mut low: f64, mut high: f64) -> f64 {
    assert!(holds(low) && !holds(high));
    for _ in 0..45 {
        let middle = 0.5 * (low + high);
        if holds(middle) { low = middle } else { high = middle }
    }
    low
}

#[test]
fn onset_of_oil_whirl() {
    let system = load(&format!(
        "[machine]\nname = \"rigid\"\naxis = \"horizontal\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = {:?}\n\
         [[part]]\nkind = \"bearing_journal\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\ndiameter = {D:?}\nlength = {L:?}\nclearance = {C:?}\nviscosity = {MU:?}\n",
        LOAD / 9.80665
    ))
    .system;
    // where the film carries the load
    for speed in [50.0, 157.0, 400.0] {
        let q = rest(&system, speed).unwrap().q;
        assert!((q[0].hypot(q[1]) / C / eccentricity(speed) - 1.0).abs() < 1e-9, "{speed}");
        // turning from x to y, the journal moves to the side of +x under a weight along -y
        assert!(q[0] > 0.0 && q[1] < 0.0, "{q:?}");
    }
    let decays = |speed: f64| {
        let modes = Linearised::new(&system, &rest(&system, speed).unwrap()).unwrap().spectrum().unwrap().modes;
        modes.iter().all(|m| m.growth() < 0.0)
    };
    let (found, expected) = (end(decays, 50.0, 2000.0), end(stable, 50.0, 2000.0));
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
}

fn rigid(unbalance: f64, more: &str) -> String {
    format!(
        "[machine]\nname = \"rigid\"\naxis = \"horizontal\"\nspeed = 150.0\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = {:?}\nunbalance = {unbalance:?}\n\
         [[part]]\nkind = \"bearing_journal\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\ndiameter = {D:?}\nlength = {L:?}\nclearance = {C:?}\nviscosity = {MU:?}\n{more}",
        LOAD / 9.80665
    )
}

/// What the film puts on a mass is `m a - f - m g` of the same motion, f the force of the unbalance; by the tangent that is exact, by the law while the motion is small.
#[test]
fn linearised_forces_are_what_the_mass_needs() {
    let (m, speed) = (LOAD / 9.80665, 150.0);
    for (unbalance, small) in [(1e-4, true), (4e-2, false)] {
        let system = load(&rigid(unbalance, "")).system;
        let study: ForcedResponse = construct(&system, &json!({ "speed": { "from": speed, "to": 170.0, "points": 3 } })).unwrap();
        let found = study.compute(&system, &Context::quiet("forces")).unwrap();
        let (r, observed) = (&found.curve.points[0], &found.observed);
        assert_eq!(r.speed, speed);
        let force = unbalance * speed * speed;
        let mut largest = 0.0f64;
        for k in 0..100_000 {
            let turning = C64::cis(2.0 * PI * f64::from(k) / 1e5);
            let of = |x: C64, f: C64| ((-x.scale(m * speed * speed) - f) * turning).re;
            let x = of(r.x[0], c(force, 0.0));
            let y = of(r.x[1], c(0.0, -force)) + LOAD;
            largest = largest.max(x.hypot(y));
        }
        let tangent = &observed.quantities.iter().find(|q| q.what == LINEARISED).unwrap().values;
        let law = &observed.laws[0].values;
        assert!((tangent[0] / largest - 1.0).abs() < 2e-9, "{} {largest}", tangent[0]);
        let away = (law[0] / tangent[0] - 1.0).abs();
        assert!(if small { away < 1e-4 } else { away > 0.1 }, "{away}");
    }
}

/// A limit of the force of a film decides, but where its law is far from the tangent.
#[test]
fn limits_of_the_forces_of_films() {
    for (unbalance, limit, verdict) in [(1e-4, 600.0, Verdict::Passed), (1e-4, 500.0, Verdict::Failed), (4e-2, 1e9, Verdict::Attention)] {
        let p = page(&rigid(unbalance, &format!("[limits]\nforce = {{ bearing = {limit:?} }}\n")));
        let found = check(&p, "check-forces");
        assert_eq!(found.verdict, verdict, "{found:?}");
        let doubts = found.detail.as_ref().is_some_and(|d| format!("{d:?}").contains("forces-not-linear"));
        assert_eq!(doubts, verdict == Verdict::Attention, "{found:?}");
    }
}

/// A full film damps a circle of the radius e c by `pi mu R L^3/(c^3 (1 - e^2)^1.5)`: the amplitude solves one equation.
#[test]
fn circles_in_a_squeeze_film() {
    let (mass, k, u, mu) = (10.0, 1e6, 4e-3, 0.002);
    let text = format!(
        "[machine]\nname = \"damped\"\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = {mass:?}\nunbalance = {u:?}\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"cage\"\nbetween = [\"drum\", \"ground\"]\nstiffness = {k:?}\n\
         [[part]]\nkind = \"squeeze_film\"\nname = \"film\"\nbetween = [\"drum\", \"ground\"]\ndiameter = {D:?}\nlength = {L:?}\nclearance = {C:?}\nviscosity = {mu:?}\nfilm = \"full\"\n\
         [[study]]\nkind = \"nonlinear_response\"\nspeed = {{ from = 150, to = 600 }}\n"
    );
    let out = run_all(&text);
    let table = out[0].tables.iter().find(|t| t.name() == "response").unwrap();
    let (speed, size) = (table.column("speed").unwrap(), table.columns().iter().find(|c| c.name.starts_with("drum")).unwrap());
    let mut largest = 0.0f64;
    for row in 0..table.rows() {
        let (w, r) = (speed.number(row).unwrap(), size.number(row).unwrap());
        let e = r / C;
        let c = PI * mu * D / 2.0 * L.powi(3) / (C.powi(3) * (1.0 - e * e).powf(1.5));
        let expected = u * w * w / (k - mass * w * w).hypot(c * w);
        assert!((r / expected - 1.0).abs() < 1e-6, "{} at {w}: {r} {expected}", size.name);
        largest = largest.max(e);
    }
    assert!(largest > 0.3, "{largest}");
}

/// A shaft on oil films: the forces of the films are listed, and the modes shown are those near the speeds of the machine, not the
/// overtones of its elements.
#[test]
fn first_page_of_a_shaft_on_oil_films() {
    let bearing = |name: &str, at: &str| {
        format!(
            "[[part]]\nkind = \"bearing_journal\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = \"{at}\" }}, \"ground\"]\n\
             diameter = \"60 mm\"\nlength = \"25 mm\"\nclearance = \"60 um\"\nviscosity = \"20 mPa s\"\n"
        )
    };
    let p = page(&format!(
        "[machine]\nname = \"pump\"\naxis = \"horizontal\"\nspeed = \"6000 rpm\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 6\n\
         section = {{ length = [\"600 mm\"], outer_diameter = [\"60 mm\"] }}\n\
         [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = \"300 mm\" }}\nmass = \"30 kg\"\nunbalance = \"200 g mm\"\n{}{}\
         [[study]]\nkind = \"forced_response\"\nspeed = {{ from = \"3000 rpm\", to = \"7000 rpm\" }}\n",
        bearing("left", "50 mm"),
        bearing("right", "550 mm")
    ));
    assert_eq!(check(&p, "check-forces").result.key.as_str(), "forces-sizes");
    let fastest = 6000.0 * PI / 30.0;
    assert!(!p.modes.is_empty() && p.modes.iter().filter(|m| m.frequency < 10.0 * fastest).count() >= 3, "{:?}", p.modes);
    let (near, far): (Vec<f64>, Vec<f64>) = p.modes.iter().map(|m| m.frequency).partition(|w| *w < 10.0 * fastest);
    // of what is far away, the lowest ones
    assert!(near.len() == 8 || far.iter().all(|w| *w < 100.0 * fastest), "{near:?} {far:?}");
}
