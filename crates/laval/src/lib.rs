//! Dynamics of rotating machines: one description of a machine, every analysis.
//!
//! A machine is composed of [`parts`] on the coordinates of bodies ([`model`]), from a text file ([`file`]) or in Rust:
//!
//! ```
//! use laval::model::{builder::Builder, field::Attach, params::Family, part::Link};
//! use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*};
//! use laval::solve::harmonic::branches::response::Request;
//! use laval::study::{Context, Study, nonlinear_response::NonlinearResponse};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let joint = Link::Between(Attach::on("drum"), Attach::on("base"));
//! let air = Link::Between(Attach::on("drum"), Attach::ground());
//! let machine = Builder::new("empty separator")
//!     .part("drum", Disc::planar(), DiscParams { mass: 2.4, eccentricity: 50e-6, ..DiscFamily::defaults() })
//!     .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: [3.26e5; 2], damping: [6.59; 2] })
//!     .part(
//!         "bearing",
//!         BearingCubic::per_axis(joint),
//!         BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10; 2], ..BearingCubicFamily::defaults() },
//!     )
//!     .part("air", Damper::fixed(air), DamperParams { damping: [42.0; 2], tilt_damping: 0.0 })
//!     .build()
//!     .map_err(|d| format!("{d:?}"))?;
//!
//! let study = NonlinearResponse::new(Request::over(25.0, 8000.0));
//! let outcome = study.run(&machine, &Context::quiet("response"))?;
//!
//! // a slow sweep up jumps where the upper state ends
//! let folds = outcome.find_table("folds").ok_or("no folds")?;
//! let speed = folds.column("speed").and_then(|c| c.number(0)).ok_or("no speed")?;
//! assert!((speed - 2668.4586212391).abs() < 1e-6);
//! # Ok(()) }
//! ```
//!
//! A part knows physics and no analysis; an analysis ([`study`], [`solve`]) knows the system and no concrete part; output ([`report`]) knows tables
//! ([`outcome`]) and neither.
#![warn(missing_docs)]
#![forbid(unsafe_code)]

pub use laval_model::{cavity, diagnostic, model, parts, units};
pub use laval_model::{conformance, params};
pub use laval_num;
pub use laval_solve as solve;

pub mod build;
#[cfg(feature = "parquet")]
mod columns;
pub mod file;
pub mod folder;
pub mod hash;
pub mod outcome;
pub mod plain;
pub mod report;
pub mod separation;
pub mod store;
pub mod study;
pub mod validation;
