//! Matrices of single elements.

use super::definition::{file, list, number, numbers};
use laval::model::builder::Builder;
use laval::model::params::Listed;
use laval::parts::shaft::{
    SectionParams, Shaft, ShaftParams,
    element::{Cone, Shear},
};
use laval::solve::characteristic::{Equilibrium, Frame};
use laval::solve::matrices::matrices;
use serde_json::Value;

/// The lateral coordinates x, y, alpha, beta of two nodes among six each.
const LATERAL: [usize; 8] = [0, 1, 3, 4, 6, 7, 9, 10];

fn lateral(m: &Value) -> Vec<Vec<f64>> {
    let all: Vec<Vec<f64>> = list(m).iter().map(numbers).collect();
    LATERAL.iter().map(|&i| LATERAL.iter().map(|&j| all[i][j]).collect()).collect()
}

fn far(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let size = b.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    a.iter().flatten().zip(b.iter().flatten()).map(|(x, y)| (x - y).abs() / size).fold(0.0, |m: f64, x| if x <= m { m } else { x })
}

/// Mass, stiffness with axial force and torque, and gyroscopic matrix of every element of the file.
#[test]
fn matrices_of_elements() {
    for (name, e) in file("element_matrices")["elements"].as_object().unwrap() {
        let of = |key: &str| number(&e[key]);
        let shear = match (e["shear"].as_bool().unwrap(), e["shear_method"].as_str().unwrap()) {
            (false, _) => Shear::None,
            (true, "cowper") => Shear::Cowper,
            (true, _) => Shear::Hutchinson,
        };
        let own = ShaftParams {
            modulus: of("E"),
            shear_modulus: of("G_shear"),
            density: of("rho"),
            axial_force: of("axial_force"),
            torque: of("torque"),
            ..ShaftParams::new()
        };
        let end = |a: &str, b: &str| if of(a) == of(b) { 0.0 } else { of(b) };
        let section = SectionParams {
            inner_diameter: of("idl"),
            end_outer_diameter: end("odl", "odr"),
            end_inner_diameter: end("idl", "idr"),
            ..SectionParams::new(of("odl"))
        };
        let shaft = Shaft::new(&[of("L")], &[of("odl")]).elements(1).shear(shear).cone(Cone::MidSection);
        let system = Builder::new("element").part("shaft", shaft, Listed { own, rows: vec![section] }).build().unwrap();
        let about = Equilibrium::zero(&system, Frame::Fixed, 1.0);
        let found = matrices(&system, &about).unwrap();
        assert!(far(&found.stiffness, &lateral(&e["K"])) < 1e-11, "{name}: stiffness {:e}", far(&found.stiffness, &lateral(&e["K"])));
        // the reference without shear is without rotary inertia too
        if e["rotary_inertia"].as_bool().unwrap() {
            assert!(far(&found.mass, &lateral(&e["M"])) < 1e-11, "{name}: mass {:e}", far(&found.mass, &lateral(&e["M"])));
            assert!(
                far(&found.gyroscopic, &lateral(&e["G"])) < 1e-11,
                "{name}: gyroscopic {:e}",
                far(&found.gyroscopic, &lateral(&e["G"]))
            );
        }
    }
}
