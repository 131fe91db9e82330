//! Studies over the parameters of a machine.

pub mod optimum;
pub mod sensitivity;
pub mod uncertainty;
