//! Constant forces: beams of textbooks, thrust and moment, the force of teeth that pass a torque on.

use super::spins::{MASSES, PRESSURE, RADII, SPRINGS, geared};
use super::statics::{AREA, BENDING, balanced, bearing, near};
use crate::common::files::load;
use laval::model::system::{GRAVITY, System};
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::solve::statics::own;
use laval::study::statics::{Static, StaticResult};
use laval::study::{Context, Study};

fn solved(system: &System) -> StaticResult {
    Static { speed: 300.0, ..Static::default() }.compute(system, &Context::quiet("static")).unwrap()
}

/// A shaft of 50 mm that stands on two bearings, with a force in its middle.
fn loaded(force: Option<[f64; 2]>) -> System {
    let belt = |[x, y]: [f64; 2]| {
        format!(
            "[[part]]\nkind = \"constant_force\"\nname = \"belt\"\non = {{ body = \"shaft\", at = 0.6 }}\nforce_x = {x:?}\nforce_y = {y:?}\n"
        )
    };
    let text = format!(
        "[machine]\nname = \"beam\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nmodulus = 2e11\nshear_modulus = 8e10\ndensity = 8000.0\nelements = 4\n\
         section = {{ length = [0.6, 0.6], outer_diameter = [0.05, 0.05] }}\n{}{}{}",
        bearing("a", 0.0, 1e7),
        bearing("b", 1.2, 1e7),
        force.map_or(String::new(), belt)
    );
    load(&text).system
}

/// `F L^3/(48 E I) + F L/(4 kappa G A)`, `F L/4`, `F/2`; the bearings give way by F/(2 k). Without a force nothing moves.
#[test]
fn a_force_in_the_middle_of_a_beam() {
    let force = [300.0, -400.0];
    let (system, plain) = (loaded(Some(force)), loaded(None));
    assert!(system.is_loaded() && !plain.is_loaded());
    let result = solved(&system);
    balanced(&result, 1e-11, "force");
    let nu = 0.25;
    let shear = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu) * 8e10 * AREA;
    let gives = 1.2f64.powi(3) / (48.0 * BENDING) + 1.2 / (4.0 * shear);
    for (kind, more) in [(&result.own, 0.5e-7), (result.rigid.as_ref().unwrap(), 0.0)] {
        let middle = kind.beams[0].cuts.iter().find(|c| (c.position - 0.6).abs() < 1e-12).unwrap();
        for p in 0..2 {
            near(middle.deflection[p], force[p] * (gives + more), 1e-9, 500.0 * gives, "deflection");
            near(middle.moment[0][p].abs(), force[p].abs() * 0.3, 1e-9, 150.0, "moment");
            let carried: f64 = kind.reactions.iter().map(|r| r.force[p]).sum();
            near(carried, -force[p], 1e-9, 500.0, "reactions");
            assert!(kind.reactions.iter().all(|r| (r.force[p] + 0.5 * force[p]).abs() < 1e-6));
        }
    }
    // motions begin there, and linear studies are about it
    let q = rest(&system, 300.0).unwrap().q;
    let middle = system.probes().iter().find(|p| p.is_at(0.6)).unwrap().of(&q);
    near(middle[0], force[0] * (gives + 0.5e-7), 1e-9, middle[1], "rest");
    near(middle[1], force[1] * (gives + 0.5e-7), 1e-9, middle[1], "rest");
    // a linear machine has the modes that it has without it
    let values = |s: &System| modes_about(s, &rest(s, 300.0).unwrap(), true).unwrap().modes.iter().map(|m| m.value).collect::<Vec<_>>();
    let (with, without) = (values(&system), values(&plain));
    assert!(with.len() == without.len() && with.iter().zip(&without).all(|(a, b)| (*a - *b).abs() <= 1e-9 * b.abs()));
}

/// Thrust over the stiffness along the axis, moments over that against tilt.
#[test]
fn thrust_and_moments() {
    let text = "[machine]\nname = \"pump\"\n[[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = 4.0\ndiametral_inertia = 0.02\npolar_inertia = 0.03\naxial = true\n\
                [[part]]\nkind = \"bearing_linear\"\nname = \"seat\"\nbetween = [\"wheel\", \"ground\"]\nkxx = 2e6\nkyy = 2e6\nkzz = 5e6\n\
                [[part]]\nkind = \"shaft_lumped\"\nname = \"stub\"\nbetween = [\"wheel\", \"ground\"]\nstiffness = 1e6\ntilt_stiffness = 3e4\n\
                [[part]]\nkind = \"constant_force\"\nname = \"thrust\"\non = \"wheel\"\nforce_x = 90.0\naxial_force = -250.0\nmoment_about_x = 6.0\nmoment_about_y = -3.0\n";
    let system = load(text).system;
    let weight = 4.0 * GRAVITY;
    for q in [own(&system, 300.0).unwrap().q, rest(&system, 300.0).unwrap().q] {
        let at = |name: &str| q[system.coordinates().iter().position(|c| c.name == format!("wheel.{name}")).unwrap()];
        let names: Vec<&str> = system.coordinates().iter().map(|c| c.name.as_str()).collect();
        assert_eq!(q.len(), 5, "{names:?}");
        near(at("x"), 90.0 / 3e6, 1e-12, 3e-5, "x");
        near(at("y"), 0.0, 1e-12, 3e-5, "y");
        let tilts: Vec<f64> =
            (0..5).filter(|&i| names[i].contains("tilt") || names[i].ends_with("_x") || names[i].ends_with("_y")).map(|i| q[i]).collect();
        assert_eq!(tilts.len(), 2, "{names:?}");
        near(tilts[0], 6.0 / 3e4, 1e-12, 2e-4, "about x");
        near(tilts[1], -3.0 / 3e4, 1e-12, 2e-4, "about y");
        let along = (0..5).find(|&i| system.coordinates()[i].dof.kind == laval::model::part::DofKind::Axial).unwrap();
        near(q[along], (-250.0 - weight) / 5e6, 1e-12, 5e-5, "along");
    }
}

/// Wheels whose bearings sag by different amounts roll on each other: teeth without a torque carry nothing of the weight. With one the bearings carry `T/(r cos phi)` along the line of
/// action beside the weight.
#[test]
fn teeth_carry_the_transmitted_torque_alone() {
    let lying = geared().replace("speed = 300.0\n", "speed = 300.0\naxis = \"horizontal\"\n");
    for (torque, angle) in [(0.0, PRESSURE), (240.0, PRESSURE), (240.0, -PRESSURE)] {
        let text = lying.replace("kind = \"gear\"\n", &format!("kind = \"gear\"\nname = \"mesh\"\ntorque = {torque:?}\n"));
        let text = text.replace(&format!("pressure_angle = {PRESSURE}"), &format!("pressure_angle = {angle}"));
        let system = load(&text).system;
        let force = torque / (RADII[0] * PRESSURE.cos()) * angle.signum();
        let (sin, cos) = angle.sin_cos();
        let along = [-0.6f64.sin() * cos + 0.6f64.cos() * sin, 0.6f64.cos() * cos + 0.6f64.sin() * sin];
        for q in [own(&system, 300.0).unwrap().q, rest(&system, 300.0).unwrap().q] {
            for (body, name) in ["wheel", "pinion"].into_iter().enumerate() {
                let [x, y] = system.probes().iter().find(|p| p.name == name).unwrap().of(&q);
                let sign = if body == 0 { -1.0 } else { 1.0 };
                let expected = [sign * force * along[0], sign * force * along[1] - MASSES[body] * GRAVITY];
                for (moved, load) in [x, y].into_iter().zip(expected) {
                    near(SPRINGS[body] * moved, load, 1e-9, 2000.0, name);
                }
            }
        }
    }
}

/// Without twist the teeth would carry the weight of the wheels, and of a torque what their stiffness leaves of it: refused, whichever wheel does not twist.
#[test]
fn a_gear_needs_wheels_that_twist() {
    let loaded = geared().replace("kind = \"gear\"\n", "kind = \"gear\"\nname = \"mesh\"\ntorque = 240.0\n");
    let messages = |text: &str| laval::file::load(text).err().map_or_else(String::new, |d| d.0.iter().map(ToString::to_string).collect());
    assert_eq!(messages(&loaded), "");
    let needs = "a gear joins the rotations of two bodies";
    assert!(messages(&loaded.replace("torsional = true\n", "")).contains(needs));
    assert!(messages(&loaded.replacen("torsional = true\n", "", 1)).contains(needs));
    assert!(messages(&geared().replace("torsional = true\n", "")).contains(needs));
}

/// What no machine has is refused: a bearing between two points of one shaft, layers in the same space.
#[test]
fn one_body_and_one_space() {
    let shaft = "[machine]\nname = \"m\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 4\nsection = { length = [1.2], outer_diameter = [0.05] }\n";
    let layers = |second: f64| {
        format!("layer = {{ from = [0.1, 0.2], to = [0.3, 0.4], outer_diameter = [0.09, 0.12], inner_diameter = [0.05, {second:?}] }}\n")
    };
    let messages =
        |text: String| laval::file::load(&text).err().map_or_else(String::new, |d| d.0.iter().map(ToString::to_string).collect());
    let held = bearing("a", 0.0, 1e7) + &bearing("b", 1.2, 1e7);
    assert_eq!(messages(format!("{shaft}{}{held}", layers(0.09))), "");
    assert!(messages(format!("{shaft}{}{held}", layers(0.05))).contains("layers 1 and 2 are in the same space"));
    let own = bearing("c", 0.3, 1e7).replace("\"ground\"", "{ body = \"shaft\", at = 0.6 }");
    assert!(messages(format!("{shaft}{held}{own}")).contains("\"c\" joins two points of one body"));
}

/// A shaft that twists and that nothing holds against turning rests on nonlinear bearings, too.
#[test]
fn a_free_twist_beside_nonlinear_bearings() {
    let cubic = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_cubic\"\nname = \"{name}\"\nlaw = \"isotropic\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\nstiffness = 2e6\ncubic_stiffness = 1e12\n"
        )
    };
    let text = format!(
        "[machine]\nname = \"beam\"\naxis = \"horizontal\"\nspeed = 300.0\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nmaterial = \"steel\"\ntorsional = true\nelements = 4\n\
         section = {{ length = [1.2], outer_diameter = [0.05] }}\n{}{}",
        cubic("a", 0.0),
        cubic("b", 1.2)
    );
    let system = load(&text).system;
    let found = rest(&system, 300.0).unwrap();
    for (i, c) in system.coordinates().iter().enumerate() {
        assert!(c.dof.kind != laval::model::part::DofKind::Twist || found.q[i] == 0.0);
    }
    let result = solved(&system);
    let carried: f64 = result.own.reactions.iter().map(|r| r.force[1]).sum();
    near(carried, result.masses[0].mass * GRAVITY, 1e-9, carried, "weight");
}
