//! Studies over the parameters of a machine.

pub mod cases;
pub mod optimum;
pub mod sensitivity;
pub mod uncertainty;
