//! The planar rotor of the reference tables as the text of a machine file.

/// Rotor `drum` and foundation `base` on the bearing of a law, with the damping of both to ground, N s/m.
pub fn planar_file(law: &str, eccentricity: &str, [rotor, base]: [&str; 2]) -> String {
    format!(
        r#"[machine]
name = "rotor"

[[part]]
kind = "disc"
name = "drum"
mass = "2.4 kg"
eccentricity = "{eccentricity}"

[[part]]
kind = "foundation"
name = "base"
mass = "25 kg"
stiffness = "3.26e5 N/m"
damping = "{base} N s/m"

[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "base"]
law = "{law}"
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"

[[part]]
kind = "damper"
name = "air"
between = ["drum", "ground"]
damping = "{rotor} N s/m"
"#
    )
}

/// The liquid `oil` in the rotor, with its free surface and the damping of its waves, 1/s.
pub fn oil(free_surface_radius: &str, wave_damping: &str) -> String {
    format!(
        r#"
[[part]]
kind = "liquid"
name = "oil"
in = "drum"
cavity_radius = "70 mm"
cavity_height = "60 mm"
density = "1000 kg/m^3"
fill = {{ free_surface_radius = "{free_surface_radius}" }}
wave_damping = "{wave_damping} 1/s"
"#
    )
}
