//! Machines at rest under their weight: published rotors, beams of textbooks, balance of forces, mistakes.

use super::definition::{file, list, number, numbers, rotor};
use super::rotors::ROTORS;
use crate::common::files::{finding, findings, load, run_all};
use laval::model::system::{GRAVITY, System};
use laval::outcome::{Level, Outcome};
use laval::study::TypedStudy;
use laval::study::statics::{Static, StaticResult};
use laval::study::{Context, Study};

fn solved(system: &System, speed: f64) -> StaticResult {
    Static { speed, ..Static::default() }.compute(system, &Context::quiet("static")).unwrap()
}

pub(super) fn near(a: f64, b: f64, tolerance: f64, size: f64, what: &str) {
    assert!((a - b).abs() <= tolerance * size.abs(), "{what}: {a} {b}");
}

/// Nothing is left over of forces and moments.
pub(super) fn balanced(result: &StaticResult, tolerance: f64, what: &str) {
    for kind in std::iter::once(&result.own).chain(&result.rigid) {
        assert!(kind.defect < tolerance, "{what}: {:e}", kind.defect);
        for b in &kind.beams {
            assert!(b.force_defect < tolerance && b.moment_defect < tolerance, "{what}: {:e} {:e}", b.force_defect, b.moment_defect);
        }
    }
}

/// Sag on own stiffness and on rigid supports, reactions, mass, centre and moment of inertia of the reference rotors.
#[test]
fn published_rotors() {
    for name in ROTORS {
        let file = file(name);
        let definition = &file["definition"];
        let system = rotor(definition, "axis = \"horizontal\"", "");
        let result = solved(&system, 0.0);
        balanced(&result, 1e-9, name);
        let nodes = numbers(&definition["nodes_pos_m"]);
        // the reference leaves out the weight of pedestals
        let pedestal = list(&definition["point_masses"]).first().map_or(0.0, |p| number(&p["my"]) * GRAVITY / 1e8);
        let cut = |kind: &laval::study::statics::Kind, z: f64| {
            kind.beams[0].cuts.iter().find(|c| (c.position - z).abs() < 1e-9).unwrap().deflection
        };
        let own = &file["static_bearing_stiffness"];
        let (xs, ys) = (numbers(&own["x_m"]), numbers(&own["y_m"]));
        let size = ys.iter().fold(0.0f64, |m, y| m.max(y.abs()));
        for (k, &z) in nodes.iter().enumerate() {
            let [x, y] = cut(&result.own, z);
            near(x, xs[k], 1e-8, size, name);
            near(y, ys[k] - pedestal, 1e-8, size, name);
        }
        let rigid = &file["static_rigid_supports"];
        let kind = result.rigid.as_ref().unwrap_or_else(|| panic!("{name}"));
        let g = GRAVITY / number(&rigid["g"]);
        let ys = numbers(&rigid["y_m"]);
        let size = ys.iter().fold(0.0f64, |m, y| m.max(y.abs()));
        for (k, &z) in nodes.iter().enumerate() {
            // the reference holds the nodes by a finite stiffness
            near(cut(kind, z)[1], g * ys[k], 1e-8, size, name);
        }
        let held = rigid["reactions_N"].as_object().unwrap();
        for (key, expected) in held {
            let node: usize = key.trim_start_matches("node_").parse().unwrap();
            let joint = list(&definition["bearings"]).iter().position(|b| b["n"].as_u64() == Some(node as u64)).unwrap();
            let slot = system.slots().iter().position(|s| s.name == format!("bearing {joint}")).unwrap();
            let own = kind.reactions.iter().filter(|r| r.slot == slot).map(|r| r.force[1]).sum::<f64>();
            near(own, g * number(expected), 1e-8, number(&rigid["mass_kg"]) * GRAVITY, name);
        }
        let whole = result.masses.iter().find(|m| m.part.is_none() && system.slots()[m.body].name == "shaft").unwrap();
        near(whole.mass, number(&rigid["mass_kg"]), 1e-10, whole.mass, name);
        near(whole.centre, number(&rigid["centre_of_gravity_m"]), 1e-10, 1.0, name);
        near(whole.polar, number(&rigid["polar_inertia_kg_m2"]), 1e-10, whole.polar, name);
    }
}

const MATERIAL: &str = "modulus = 2e11\nshear_modulus = 8e10\ndensity = 8000.0\n";

pub(super) fn bearing(name: &str, at: f64, k: f64) -> String {
    format!(
        "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\nkxx = {k:?}\nkyy = {k:?}\n"
    )
}

/// A lying shaft of these lengths and diameter 50 mm on bearings.
pub(super) fn beam(lengths: &[f64], shear: &str, more: &str) -> System {
    let diameters = vec!["0.05"; lengths.len()].join(", ");
    let lengths = lengths.iter().map(|l| format!("{l:?}")).collect::<Vec<_>>().join(", ");
    let text = format!(
        "[machine]\nname = \"beam\"\naxis = \"horizontal\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\n{MATERIAL}shear = \"{shear}\"\nelements = 4\nsection = {{ length = [{lengths}], outer_diameter = [{diameters}] }}\n{more}"
    );
    load(&text).system
}

pub(super) const AREA: f64 = std::f64::consts::PI * 0.05 * 0.05 / 4.0;
pub(super) const BENDING: f64 = 2e11 * std::f64::consts::PI * 0.05 * 0.05 * 0.05 * 0.05 / 64.0;
pub(super) const LINE: f64 = 8000.0 * AREA * GRAVITY;

/// `5 w L^4/(384 E I) + w L^2/(8 kappa G A)`, `w L^2/8`, `w L/2`.
#[test]
fn simply_supported_beam() {
    let system = beam(&[1.2], "cowper", &(bearing("a", 0.0, 1e7) + &bearing("b", 1.2, 1e7)));
    let result = solved(&system, 0.0);
    balanced(&result, 1e-11, "beam");
    let nu = 0.25;
    let shear = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu) * 8e10 * AREA;
    let sag = 5.0 * LINE * 1.2f64.powi(4) / (384.0 * BENDING) + LINE * 1.44 / (8.0 * shear);
    let kind = result.rigid.as_ref().unwrap();
    let cuts = &kind.beams[0].cuts;
    let middle = cuts.iter().find(|c| (c.position - 0.6).abs() < 1e-12).unwrap();
    near(middle.deflection[1], -sag, 1e-11, sag, "sag");
    for side in 0..2 {
        near(middle.moment[side][1], LINE * 1.44 / 8.0, 1e-11, LINE, "moment");
        near(middle.shear[side][1], 0.0, 1e-11, LINE, "shear");
    }
    near(cuts[0].shear[1][1], LINE * 0.6, 1e-11, LINE, "shear at the end");
    near(cuts[0].slope[1], -LINE * 1.2f64.powi(3) / (24.0 * BENDING), 1e-11, sag, "slope at the end");
    assert_eq!(cuts[0].moment[1][1], 0.0);
    // the bearings add what they give way by
    let own = result.own.beams[0].cuts.iter().find(|c| (c.position - 0.6).abs() < 1e-12).unwrap();
    near(own.deflection[1], -sag - LINE * 0.6 / 1e7, 1e-11, sag, "sag on springs");
}

/// A disc outside the bearings.
#[test]
fn overhung_disc() {
    let disc = "[[part]]\nkind = \"disc\"\nname = \"disc\"\non = { body = \"shaft\", at = 1.5 }\nmass = 30.0\npolar_inertia = 0.4\ndiametral_inertia = 0.3\ncentre_of_mass = 0.02\n";
    let system = beam(&[1.0, 0.5], "none", &(bearing("a", 0.0, 1e8) + &bearing("b", 1.0, 1e8) + disc));
    let result = solved(&system, 0.0);
    balanced(&result, 1e-11, "overhung");
    let weight = 30.0 * GRAVITY;
    let moment = -(weight * 0.52 + LINE * 0.125);
    for kind in [&result.own, result.rigid.as_ref().unwrap()] {
        let cut = kind.beams[0].cuts.iter().find(|c| (c.position - 1.0).abs() < 1e-12).unwrap();
        near(cut.moment[0][1], moment, 1e-11, moment, "moment over the bearing");
        let upper = kind.reactions.iter().find(|r| system.slots()[r.slot].name == "b").unwrap().force[1];
        near(upper, weight * 1.52 + LINE * 1.5 * 0.75, 1e-9, weight, "load");
    }
    let whole = result.masses.iter().find(|m| m.part.is_none()).unwrap();
    let (shaft, disc) = (8000.0 * AREA * 1.5, 30.0);
    let centre = (shaft * 0.75 + disc * 1.52) / (shaft + disc);
    near(whole.centre, centre, 1e-12, 1.0, "centre");
    let own = shaft * (0.05f64.powi(2) / 16.0 + 1.5f64.powi(2) / 12.0) + 0.3;
    let apart = shaft * (centre - 0.75).powi(2) + disc * (1.52 - centre).powi(2);
    near(whole.diametral, own + apart, 1e-11, own, "moment of inertia");
    near(whole.polar, shaft * 0.05f64.powi(2) / 8.0 + 0.4, 1e-12, 1.0, "polar");
}

/// The equation of three moments: `M = -w (a^3 + b^3)/(8 (a + b))` over the middle bearing.
#[test]
fn three_bearings() {
    let bearings = bearing("a", 0.0, 1e8) + &bearing("b", 0.7, 1e8) + &bearing("c", 1.9, 1e8);
    let system = beam(&[0.7, 1.2], "none", &bearings);
    let result = solved(&system, 0.0);
    balanced(&result, 1e-11, "three bearings");
    let kind = result.rigid.as_ref().unwrap();
    let expected = -LINE * (0.7f64.powi(3) + 1.2f64.powi(3)) / (8.0 * 1.9);
    let cut = kind.beams[0].cuts.iter().find(|c| (c.position - 0.7).abs() < 1e-12).unwrap();
    near(cut.moment[0][1], expected, 1e-9, expected, "moment");
    let force = |name: &str| kind.reactions.iter().find(|r| system.slots()[r.slot].name == name).unwrap().force[1];
    near(force("a"), LINE * 0.35 + expected / 0.7, 1e-9, LINE, "first reaction");
    near(force("c"), LINE * 0.6 + expected / 1.2, 1e-9, LINE, "last reaction");
    near(force("a") + force("b") + force("c"), LINE * 1.9, 1e-11, LINE, "sum");
}

/// Cones: mass and centre of a frustum, and forces and moments that close.
#[test]
fn cones() {
    for cone in ["flexibility", "mid_section"] {
        let text = format!(
            "[machine]\nname = \"cone\"\naxis = \"horizontal\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\n{MATERIAL}cone = \"{cone}\"\nelements = 3\nsection = {{ length = [0.9, 0.3], outer_diameter = [0.03, 0.09], end_outer_diameter = [0.09, 0.02], inner_diameter = [0.01, 0.01], end_inner_diameter = [0.02, 0.0] }}\n{}{}",
            bearing("a", 0.1, 1e7),
            bearing("b", 1.0, 2e7),
        );
        let system = load(&text).system;
        let result = solved(&system, 0.0);
        balanced(&result, 1e-10, cone);
        let frustum = |l: f64, a: f64, b: f64| {
            let scale = 8000.0 * std::f64::consts::PI / 12.0 * l;
            let mass = scale * (a * a + a * b + b * b);
            (mass, scale * l / 4.0 * (a * a + 2.0 * a * b + 3.0 * b * b))
        };
        let (outer, inner) = ([frustum(0.9, 0.03, 0.09), frustum(0.3, 0.09, 0.02)], [frustum(0.9, 0.01, 0.02), frustum(0.3, 0.01, 0.01)]);
        let mass: f64 = outer.iter().map(|m| m.0).sum::<f64>() - inner.iter().map(|m| m.0).sum::<f64>();
        let first = outer[0].1 - inner[0].1 + outer[1].1 + 0.9 * outer[1].0 - inner[1].1 - 0.9 * inner[1].0;
        let whole = result.masses.iter().find(|m| m.part.is_none()).unwrap();
        near(whole.mass, mass, 1e-12, mass, cone);
        near(whole.centre, first / mass, 1e-12, 1.0, cone);
    }
}

/// Tension enters the moments by the deflection; cross stiffness moves the journals sideways; rotating damping does not deflect a rotor at rest.
#[test]
fn tension_cross_stiffness_and_what_turns() {
    let cross = bearing("a", 0.0, 1e6) + "kxy = 4e5\nkyx = -4e5\n" + &bearing("b", 1.0, 1e6) + "kxy = 4e5\nkyx = -4e5\n";
    let system = beam(&[1.0], "cowper", &cross);
    let result = solved(&system, 300.0);
    balanced(&result, 1e-11, "cross");
    // k (x, y) + q (y, -x) = (0, -w L/2)
    let half = 0.5 * LINE;
    let [x, y] = result.own.beams[0].cuts[0].deflection;
    near(x, half * 4e5 / (1e12 + 16e10), 1e-11, y, "sideways");
    near(y, -half * 1e6 / (1e12 + 16e10), 1e-11, y, "down");
    let text = |more: &str| bearing("a", 0.0, 1e6) + &bearing("b", 1.0, 1e6) + more;
    let pulled = beam(&[1.0], "none", &text("")).with(&[("shaft.axial_force", 2e5)]).unwrap();
    let result = solved(&pulled, 0.0);
    balanced(&result, 1e-9, "tension");
    // w (L/2)^2/2 times 2 (1 - sech u)/u^2 with u^2 = P L^2/(4 E I)
    let u = (2e5 / (4.0 * BENDING)).sqrt();
    let expected = LINE / 8.0 * 2.0 * (1.0 - 1.0 / u.cosh()) / (u * u);
    let cut = &result.rigid.as_ref().unwrap().beams[0].cuts[2];
    near(cut.moment[0][1], expected, 2e-4, expected, "moment under tension");
    let damped = beam(&[1.0], "none", &text("")).with(&[("shaft.rotating_damping", 1e-3)]).unwrap();
    assert!(solved(&damped, 500.0).own.beams[0].cuts.iter().all(|c| c.deflection[0].abs() < 1e-12 * c.deflection[1].abs()));
}

const RIGID: &str = "[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 12.0\n";

/// A nonlinear bearing: `k d + k3 d^3 = m g`; a reduced answer of a machine without shaft has no rigid supports.
#[test]
fn nonlinear_bearing() {
    let text = format!(
        "[machine]\nname = \"t\"\naxis = \"horizontal\"\nspeed = \"3000 rpm\"\n{RIGID}[[part]]\nkind = \"bearing_cubic\"\nname = \"bearing\"\nbetween = [\"drum\", \"ground\"]\nlaw = \"per_axis\"\nstiffness = 1e5\ncubic_stiffness = 1e14\n[[study]]\nkind = \"static\"\n"
    );
    let outcome = &run_all(&text)[0];
    let d = finding(outcome, "sag").value.unwrap();
    near(1e5 * d + 1e14 * d.powi(3), 12.0 * GRAVITY, 1e-11, 100.0, "equilibrium");
    near(finding(outcome, "largest_load").value.unwrap(), 12.0 * GRAVITY, 1e-11, 100.0, "load");
    assert!(findings(outcome, "rigid_sag").is_empty() && findings(outcome, "largest_moment").is_empty() && outcome.figures.is_empty());
}

/// Weight along the axis deflects nothing, and the study says so.
#[test]
fn vertical_machine() {
    let text = format!("[machine]\nname = \"t\"\n{RIGID}{}[[study]]\nkind = \"static\"\n", bearing("a", 0.0, 1e6).replace("shaft", "drum"));
    let outcome = &run_all(&text)[0];
    let said = finding(outcome, "not_loaded");
    assert_eq!(said.level, Level::Info);
    near(said.number("weight").unwrap(), 12.0 * GRAVITY, 1e-14, 100.0, "weight");
    assert!(said.sentence().contains("along the axis"), "{}", said.sentence());
}

/// A single rigid support does not hold a shaft: the study says so and gives the other kind; what names no support is refused at its place.
#[test]
fn supports_named() {
    let of = |supports: &str| {
        format!(
            "[machine]\nname = \"t\"\naxis = \"horizontal\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nsection = {{ length = [1.0], outer_diameter = [0.05] }}\n{}{}{}[[study]]\nkind = \"static\"\nsupports = \"{supports}\"\n",
            bearing("a", 0.0, 1e6),
            bearing("b", 1.0, 1e6),
            bearing("seal", 0.5, 1e4),
        )
    };
    let outcome: &Outcome = &run_all(&of("a, b"))[0];
    assert!(findings(outcome, "not_held").is_empty());
    let table = outcome.tables.iter().find(|t| t.name() == "reactions").unwrap();
    let load = |row: usize| table.column("rigid_y").unwrap().number(row).unwrap();
    assert!(load(0) > load(2) && load(2) > 0.0);
    // the seal alone is held rigidly beside the springs of the bearings
    assert!(findings(&run_all(&of("seal"))[0], "not_held").is_empty());
    let wrong = laval::file::load(&of("a, bee, shaft")).err().unwrap();
    let said: Vec<String> = wrong.0.iter().map(|d| d.message.to_string()).collect();
    assert_eq!(said, ["static: \"shaft\" does not join a turning body to anything", "static: there is no part \"bee\""]);
    assert!(wrong.0.iter().all(|d| d.span.is_some()));
}

/// A stored result says the same.
#[test]
fn stored() {
    let system = beam(&[1.0], "cowper", &(bearing("a", 0.0, 1e6) + &bearing("b", 1.0, 1e6)));
    let study = Static::default();
    let result = study.compute(&system, &Context::quiet("static")).unwrap();
    let again: StaticResult = serde_json::from_str(&serde_json::to_string(&result).unwrap()).unwrap();
    assert_eq!(study.outcome(&system, &result, "static").unwrap(), study.outcome(&system, &again, "static").unwrap());
}

/// A coupling to a drive is no bearing: it stays where rigid supports take the place of bearings, and a rotor that it alone holds has none.
#[test]
fn couplings_support_nothing() {
    let shaft = "[machine]\nname = \"t\"\naxis = \"horizontal\"\n[[part]]\nkind = \"shaft\"\nname = \"s\"\nelements = 8\nsection = [{ length = 0.5, outer_diameter = 0.04 }]\n\
                 [[part]]\nkind = \"coupling\"\nname = \"head\"\nbetween = [\"s\", \"ground\"]\nstiffness = 1e13\ntilt_stiffness = 1e13\n";
    let clamped = load(shaft).system;
    let result = solved(&clamped, 0.0);
    assert!(result.rigid.is_none() && result.supports.is_empty(), "{:?}", result.supports);
    // clamped beam under its weight: rho A g L^4 / (8 E I), and what its shear adds
    let (e, density, l, d) = (2.1e11, 7850.0, 0.5f64, 0.04f64);
    let sag = density * GRAVITY * l.powi(4) * 16.0 / (8.0 * e * d * d);
    let end = result.own.beams[0].cuts.iter().map(|c| c.deflection[1].abs()).fold(0.0, f64::max);
    assert!((end / sag - 1.0).abs() < 0.02, "{end:e} {sag:e}");
    let held = "[[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [{ body = \"s\", at = 0.5 }, \"ground\"]\nstiffness = 1e7\n";
    let system = load(&format!("{shaft}{held}")).system;
    let slot = |name: &str| system.slots().iter().position(|s| s.name == name).unwrap();
    let result = solved(&system, 0.0);
    assert_eq!(result.supports, [slot("b")]);
    let left_out = &result.rigid.expect("a bearing is a support").state.left_out;
    assert!(left_out[slot("b")] && !left_out[slot("head")]);
}

/// A cylindrical layer of liquid weighs what it holds, whatever part of it moves with the body: closed forms of a hollow cylinder, and the weight that the bearing carries.
#[test]
fn liquids_count_in_full() {
    let (density, radius, height, mass) = (920.0, 0.21, 0.18, 6.0);
    let free = (radius * radius - mass / (density * std::f64::consts::PI * height)).sqrt();
    const STIFFNESS: f64 = 1e7;
    for (model, tilts) in [("planar", false), ("planar_tilt", true), ("frozen", true)] {
        let (tilt, hold) = if tilts { ("diametral_inertia = 0.4\n", "tilt_stiffness = 1e4\n") } else { ("", "") };
        let system = load(&format!(
            "[machine]\nname = \"drum\"\nspeed = 300.0\naxis = \"horizontal\"\n\
             [[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 10.0\npolar_inertia = 0.5\n{tilt}\
             [[part]]\nkind = \"liquid\"\nname = \"oil\"\nin = \"drum\"\nmodel = \"{model}\"\ncavity_radius = {radius}\ncavity_height = {height}\n\
             density = {density}\nfill = {{ mass = {mass} }}\n\
             [[part]]\nkind = \"shaft_lumped\"\nname = \"support\"\nbetween = [\"drum\", \"ground\"]\nstiffness = {STIFFNESS}\n{hold}"
        ))
        .system;
        let result = solved(&system, 300.0);
        let of = |part: Option<usize>| result.masses.iter().find(|m| m.part == part).unwrap();
        let (oil, whole) = (of(system.slots().iter().position(|s| s.name == "oil")), of(None));
        near(oil.mass, mass, 1e-9, mass, model);
        near(whole.mass, 10.0 + mass, 1e-9, mass, model);
        if !tilt.is_empty() {
            let squares = radius * radius + free * free;
            near(oil.polar, 0.5 * mass * squares, 1e-9, mass, model);
            near(oil.diametral, mass * (0.25 * squares + height * height / 12.0), 1e-9, mass, model);
        }
        near(-result.own.state.q[1] * STIFFNESS, whole.mass * GRAVITY, 1e-6, mass * GRAVITY, model);
    }
}
