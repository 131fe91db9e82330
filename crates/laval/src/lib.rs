//! Dynamics of rotating machines: one description of a machine, every analysis.
//!
//! A machine is composed of [`parts`] on the coordinates of bodies ([`model`]), from a text file ([`file`](mod@file)) or in Rust. The [`prelude`] holds the
//! names that are needed for that. All numbers are in SI units.
//!
//! A disc on a flexible shaft has its critical speed at `sqrt(k / m)`:
//!
//! ```
//! use laval::prelude::*;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let ground = || Link::Between(Attach::on("disc"), Attach::ground());
//! let machine = Builder::new("Laval rotor")
//!     .part("disc", Disc::planar(), DiscParams { eccentricity: 20e-6, ..DiscParams::new(3.0) })
//!     .part("shaft", ShaftLumped::lateral(ground()), ShaftLumpedParams { stiffness: [3e5; 2], ..ShaftLumpedParams::new() })
//!     .part("air", Damper::fixed(ground()), DamperParams::new([20.0; 2]))
//!     .build()?;
//! let speed = RangeValue { from: 100.0, to: 600.0, points: None };
//! let study = CriticalSpeeds { speed, orders: vec![1.0], margin: 0.15 };
//! let outcome = study.run(&machine, &Context::quiet("critical speeds"))?;
//! let table = outcome.find_table("critical_speeds").ok_or("no table")?;
//! let speed = table.column("speed").and_then(|c| c.number(0)).ok_or("no speed")?;
//! assert!((speed - (3e5_f64 / 3.0).sqrt()).abs() < 0.1);
//! # Ok(()) }
//! ```
//!
//! On a bearing that stiffens, a slow sweep jumps where the upper state ends:
//!
//! ```
//! use laval::prelude::*;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let joint = Link::Between(Attach::on("drum"), Attach::on("base"));
//! let air = Link::Between(Attach::on("drum"), Attach::ground());
//! let machine = Builder::new("empty separator")
//!     .part("drum", Disc::planar(), DiscParams { eccentricity: 50e-6, ..DiscParams::new(2.4) })
//!     .part("base", Foundation, FoundationParams { damping: [6.59; 2], ..FoundationParams::new(25.0, [3.26e5; 2]) })
//!     .part("bearing", BearingCubic::per_axis(joint), BearingCubicParams::new([1.1e7; 2], [8.7e10; 2]))
//!     .part("air", Damper::fixed(air), DamperParams::new([42.0; 2]))
//!     .build()?;
//! let study = NonlinearResponse::over(25.0, 8000.0);
//! let outcome = study.run(&machine, &Context::quiet("response"))?;
//! let folds = outcome.find_table("folds").ok_or("no folds")?;
//! let speed = folds.column("speed").and_then(|c| c.number(0)).ok_or("no speed")?;
//! assert!((speed - 2668.4586212391).abs() < 1e-6);
//! # Ok(()) }
//! ```
//!
//! Liquid in a cavity makes a rotor unstable in a range of speeds above a critical speed. Every study can be made from its fields:
//!
//! ```
//! use laval::prelude::*;
//! use serde_json::json;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let ground = || Link::Between(Attach::on("drum"), Attach::ground());
//! let liquid = LiquidParams { wave_damping: 2.0, ..LiquidParams::new(0.08, 0.1, 1000.0, 0.05) };
//! let machine = Builder::new("drum with liquid")
//!     .part("drum", Disc::planar(), DiscParams::new(3.0))
//!     .part("shaft", ShaftLumped::lateral(ground()), ShaftLumpedParams { stiffness: [3e5; 2], ..ShaftLumpedParams::new() })
//!     .part("air", Damper::fixed(ground()), DamperParams::new([20.0; 2]))
//!     .part("liquid", Liquid::new(Attach::on("drum"), Fill::Partial), liquid)
//!     .build()?;
//! let fields = json!({ "speed": { "from": 50.0, "to": 1500.0, "points": 100 } });
//! let study: StabilityMap = construct(&machine, &fields)?;
//! let outcome = study.run(&machine, &Context::quiet("stability"))?;
//! assert!(outcome.findings.iter().any(|f| f.id == "unstable_range"), "{:?}", outcome.findings);
//! # Ok(()) }
//! ```
//!
//! A machine file does the same:
//!
//! ```
//! use laval::prelude::*;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let loaded = load(r#"
//!     machine = { name = "ball balancer", speed = "900 rad/s" }
//!     part = [
//!         { kind = "disc", name = "disc", mass = "8.91 kg", eccentricity = "50 um" },
//!         { kind = "shaft_lumped", name = "shaft", between = ["disc", "ground"], stiffness = "2.92e6 N/m" },
//!         { kind = "damper", name = "losses", between = ["disc", "ground"], damping = "400 N s/m" },
//!         { kind = "balancer_ball", name = "balancer", on = "disc", ball_mass = "3.6 g", track_radius = "100 mm", drag = "2e-3 N m s" },
//!     ]
//!     study = [{ kind = "transient", duration = "1 s", initial = { "balancer.ball_1" = "20 deg", "balancer.ball_2" = "60 deg" } }]
//! "#)?;
//! let outcome = loaded.studies[0].study.run(&loaded.system, &Context::quiet("balancing"))?;
//! assert!(outcome.end == End::Reached && outcome.findings.iter().any(|f| f.id == "time_to_balance"), "{:?}", outcome.findings);
//! # Ok(()) }
//! ```
//!
//! A study returns tables, figures and findings ([`ErasedStudy::run`](study::ErasedStudy::run)) or its typed result
//! ([`TypedStudy::result`](study::TypedStudy::result)), which any format of serde that keeps NaN can store; a stored result is reported again, or begun from:
//!
//! ```
//! use laval::prelude::*;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let machine = Builder::new("rotor").part("disc", Disc::planar(), DiscParams::new(3.0));
//! let shaft = ShaftLumped::lateral(Link::Between(Attach::on("disc"), Attach::ground()));
//! let machine = machine.part("shaft", shaft, ShaftLumpedParams { stiffness: [3e5; 2], ..ShaftLumpedParams::new() }).build()?;
//! let study: Modes = construct(&machine, &serde_json::json!({ "speed": 100.0 }))?;
//! let result = study.result(&machine, &Context::quiet("modes"))?;
//! let mode = &result.spectrum.modes[0];
//! assert!((mode.frequency() - (3e5_f64 / 3.0).sqrt()).abs() < 1e-9 && mode.q.len() == 2);
//! assert_eq!(study.outcome(&machine, &result, "modes")?.kind, "modes");
//! # Ok(()) }
//! ```
//!
//! A part knows physics and no analysis; an analysis ([`study`], [`solve`]) knows the system and no concrete part; output ([`report`]) knows tables
//! ([`outcome`]) and neither.
#![warn(missing_docs)]
#![forbid(unsafe_code)]

pub use laval_model::{cavity, diagnostic, model, parts, text, units};
pub use laval_model::{conformance, params};
#[doc(hidden)]
pub use laval_num;
#[doc(hidden)]
pub use laval_separation as separation;
pub use laval_solve as solve;

#[doc(hidden)]
pub mod build;
pub mod cases;
#[cfg(feature = "parquet")]
mod columns;
pub mod file;
#[doc(hidden)]
pub mod hash;
pub mod import;
#[doc(hidden)]
pub mod language;
pub mod outcome;
#[doc(hidden)]
pub mod output_folder;
#[doc(hidden)]
pub mod plain;
pub mod prelude;
pub mod reach;
pub mod report;
#[doc(hidden)]
pub mod run;
#[doc(hidden)]
pub mod store;
pub mod study;
#[doc(hidden)]
pub mod validation;
