//! Shafts of finite elements: matrices, modes, critical speeds, responses and sag against published rotors and closed forms.

mod alignment;
mod axis;
mod bearing_coefficients;
mod by_entries;
mod closed_forms;
mod constant_force;
mod definition;
mod elements;
mod flexible_hub;
mod imported;
mod machines;
mod mirrored;
mod reduced;
mod rotors;
mod spins;
mod statics;
mod support_map;
