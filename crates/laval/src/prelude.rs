//! What a Rust user meets: machines, parts, studies and their outcomes.
//!
//! A machine comes from a file ([`load`]) or from [`Builder`]; a study from a file, from its struct, or from its fields ([`construct`]); a run
//! returns an [`Outcome`] of tables, figures and findings, or the typed result of the study ([`TypedStudy`]).

pub use crate::diagnostic::{Diagnostic, Diagnostics};
pub use crate::file::{Loaded, construct, construct_kind, load};
pub use crate::model::builder::Builder;
pub use crate::model::field::{Attach, RangeValue};
pub use crate::model::part::Link;
pub use crate::model::system::System;
pub use crate::outcome::{End, Finding, Outcome, Table};
pub use crate::parts::balancer_ball::{BalancerBallParams, BallBalancer};
pub use crate::parts::bearing_cubic::{BearingCubic, BearingCubicParams};
pub use crate::parts::bearing_hertz::{BearingHertz, BearingHertzParams};
pub use crate::parts::bearing_linear::{BearingLinear, BearingLinearParams};
pub use crate::parts::damper::{Damper, DamperParams};
pub use crate::parts::disc::{Disc, DiscParams};
pub use crate::parts::foundation::{Foundation, FoundationParams};
pub use crate::parts::liquid::{Fill, Liquid, LiquidParams};
pub use crate::parts::motor::{Motor, MotorParams};
pub use crate::parts::shaft_lumped::{ShaftLumped, ShaftLumpedParams};
pub use crate::parts::shaft_span::{ShaftSpan, ShaftSpanParams};
pub use crate::parts::shaft_viscoelastic::{ShaftViscoelastic, ShaftViscoelasticParams};
pub use crate::parts::spin_load::{SpinLoad, SpinLoadParams};
pub use crate::parts::stop::{Stop, StopParams};
pub use crate::study::{Context, ErasedStudy, TypedStudy};
pub use crate::study::{
    backbone::Backbone, basins::Basins, bearing_coefficients::BearingCoefficients, bifurcation_loci::BifurcationLoci, campbell::Campbell,
    critical_speeds::CriticalSpeeds, forced_response::ForcedResponse, harmonic_force::HarmonicForce, limit_cycles::LimitCycles,
    methods::Methods, modes::Modes, motion_map::MotionMap, nonlinear_response::NonlinearResponse, operating_window::OperatingWindow,
    optimum::Optimum, response_map::ResponseMap, run_up::RunUp, sensitivity::Sensitivity, separation::Separation,
    stability_map::StabilityMap, stability_threshold::StabilityThreshold, statics::Static, stationary::Stationary,
    support_stiffness_map::SupportStiffnessMap, sweep::Sweep, transient::Transient, uncertainty::Uncertainty,
};
