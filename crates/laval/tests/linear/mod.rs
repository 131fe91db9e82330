//! Linear machines: modes, responses, stability, sensitivities; the physics of parts.

mod claims;
mod criticals;
mod first_page;
mod first_page_dangers;
mod liquid_force;
mod long_shafts;
mod matrices;
mod memory;
mod model_planar;
mod modes;
mod nonlinear_forces;
mod oil_films;
mod one_speed;
mod operation;
mod optimum;
mod overview;
mod parts_physics;
mod pure_tilt;
mod response;
mod sensitivity;
mod several_unbalances;
mod shapes;
mod stability;
mod tilt;
mod uncertainty;
mod viscoelastic;
