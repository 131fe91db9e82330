//! Centrifugal separation: particles in cups, tubes, bowls and disc stacks, from the equations of motion to engineering measures.
//!
//! [`particle`] and [`frame`] state the equations; [`closed`] solves them at constant speed, [`motion`] integrates them otherwise, [`drift`] does so for drag in balance
//! with the field, [`exit`] finds when and where a particle leaves the liquid of a [`vessel`]. [`cup`] says how a cup hangs. [`suspension`] follows a suspension ([`law`], [`halton`]) through a [`separator`]; a [`batch`] with its run-up and the [`recovery`] it reaches are what
//! studies require, with the [`slowest`] particle of all;
//! [`load`] is what cups do to the rotor, [`carried`] the part of the machine that does it; [`measures`] are what engineers compare centrifuges by, [`validity`] tells where the model ends.
#![warn(missing_docs)]
#![forbid(unsafe_code)]

use laval_model::{diagnostic, model};

pub mod batch;
pub mod carried;
pub mod closed;
pub mod cup;
pub mod drift;
pub mod exit;
pub mod frame;
pub mod halton;
pub mod law;
pub mod load;
pub mod measures;
pub mod motion;
pub mod particle;
pub mod places;
pub mod ramp;
pub mod recovery;
pub mod release;
pub mod separator;
mod series;
pub mod slowest;
pub mod suspension;
pub mod tube;
pub mod validity;
pub mod vessel;
