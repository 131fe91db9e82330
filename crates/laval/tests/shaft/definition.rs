//! Rotors of the reference files as machine files.

use crate::common::files::load;
use laval::model::system::System;
use serde_json::Value;
use std::fmt::Write as _;

/// A reference file.
pub fn file(name: &str) -> Value {
    let path = format!("{}/tests/reference/fe/{name}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))).unwrap()
}

pub fn number(v: &Value) -> f64 {
    v.as_f64().unwrap_or_else(|| panic!("{v} is no number"))
}

pub fn list(v: &Value) -> &[Value] {
    v.as_array().unwrap_or_else(|| panic!("{v} is no list"))
}

pub fn numbers(v: &Value) -> Vec<f64> {
    list(v).iter().map(number).collect()
}

/// A rotor with its shaft, discs, pedestals and bearings; `more` parts and lines of `[machine]` besides.
pub fn rotor(definition: &Value, machine: &str, more: &str) -> System {
    load(&(text(definition, machine, "") + more)).system
}

/// Its file; `shaft` lines of the shaft besides.
pub fn text(definition: &Value, machine: &str, shaft: &str) -> String {
    let nodes = numbers(&definition["nodes_pos_m"]);
    let mut text = format!("[machine]\nname = \"rotor\"\n{machine}\n");
    let elements = list(&definition["shaft"]);
    let column = |name: &str| elements.iter().map(|e| format!("{:?}", number(&e[name]))).collect::<Vec<_>>().join(", ");
    let first = &elements[0];
    // damping of elements, and of the whole rotor
    let of_all = |own: &str, all: &str| number(&first[own]) + number(&definition[all]);
    let (mass, stiffness) = (of_all("alpha", "rotor_alpha"), of_all("beta", "rotor_beta"));
    let turning = definition.get("shaft_beta_rot").map_or(0.0, number);
    let shear = if first["shear_effects"].as_bool().unwrap() { first["shear_method"].as_str().unwrap() } else { "none" };
    writeln!(
        text,
        "[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 1\ncone = \"mid_section\"\nshear = \"{shear}\"\nmodulus = {:?}\nshear_modulus = {:?}\n\
         density = {:?}\naxial_force = {:?}\nmass_damping = {mass:?}\nstiffness_damping = {stiffness:?}\nrotating_damping = {turning:?}\n\
         section = {{ length = [{}], outer_diameter = [{}], inner_diameter = [{}] }}\n{shaft}",
        number(&first["E"]),
        number(&first["G"]),
        number(&first["rho"]),
        number(&first["axial_force"]),
        column("L"),
        column("odl"),
        column("idl"),
    )
    .unwrap();
    for (k, d) in list(&definition["disks"]).iter().enumerate() {
        let node = d["n"].as_u64().unwrap() as usize;
        let (m, id, ip) = (number(&d["m"]), number(&d["Id"]), number(&d["Ip"]));
        writeln!(
            text,
            "[[part]]\nkind = \"disc\"\nname = \"disc {k}\"\non = {{ body = \"shaft\", at = {:?} }}\nmass = {m:?}\ndiametral_inertia = {id:?}\npolar_inertia = {ip:?}",
            nodes[node],
        )
        .unwrap();
        if mass > 0.0 {
            writeln!(
                text,
                "[[part]]\nkind = \"damper\"\nname = \"damping {k}\"\nbetween = [\"disc {k}\", \"ground\"]\ndamping = {:?}\ntilt_damping = {:?}",
                mass * m,
                mass * id,
            )
            .unwrap();
        }
    }
    for p in list(&definition["point_masses"]) {
        writeln!(text, "[[part]]\nkind = \"disc\"\nname = \"support {}\"\nmass = {:?}", p["n"], number(&p["mx"])).unwrap();
    }
    let place = |n: u64| match nodes.get(n as usize) {
        Some(z) => format!("{{ body = \"shaft\", at = {z:?} }}"),
        None => format!("\"support {n}\""),
    };
    for (k, b) in list(&definition["bearings"]).iter().enumerate() {
        let below = b["n_link"].as_u64().map_or("\"ground\"".to_string(), place);
        write!(
            text,
            "[[part]]\nkind = \"bearing_linear\"\nname = \"bearing {k}\"\nbetween = [{}, {below}]\n",
            place(b["n"].as_u64().unwrap())
        )
        .unwrap();
        for c in ["kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"] {
            if let Some(x) = b.get(c).and_then(Value::as_f64).filter(|x| *x != 0.0) {
                writeln!(text, "{c} = {x:?}").unwrap();
            }
        }
    }
    text
}
