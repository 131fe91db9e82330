//! Solving: equilibria, spectra, responses, motions. An analysis knows the system and no concrete part.
#![warn(missing_docs)]

use laval_model::{diagnostic, model};

mod border;
pub mod centring;
pub mod characteristic;
pub mod co_rotating;
pub mod counted;
pub mod criticals;
pub mod cross_coupling;
pub mod ensemble;
mod equilibrium;
pub mod exact;
pub mod extrema;
pub mod extremum;
mod follow;
mod free_motions;
pub mod harmonic;
pub mod harmonic_force;
pub mod kinetic;
pub mod large;
pub mod linear_response;
pub mod locate;
pub mod machine_mode;
pub mod matrices;
pub mod mode_slopes;
pub mod motion;
mod orders;
pub mod own_frequency;
pub mod pencil;
pub mod programme;
pub mod reduced_machine;
pub mod reduction;
mod resonances;
pub mod rest;
pub mod roots;
pub mod sectors;
mod side_by_side;
pub mod stability;
pub mod statics;
pub mod stationary;
pub mod support_map;
pub mod sweep;
pub mod symmetry;
pub mod ties;
mod turned_freely;
pub mod unbalance;
