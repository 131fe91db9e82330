//! What some parts have beyond [`Part`](super::part::Part): one trait for each capability.
//!
//! An author implements the trait and returns `Some(self)` from the method of [`Part`](super::part::Part) that declares it. Analyses see the
//! object-safe face of the same name in [`erased`](super::erased), which one blanket implementation fills: parameters arrive there as a slice.

pub mod added_inertia;
pub mod body;
pub mod contact;
pub mod drive;
pub mod extent;
pub mod filling;
pub mod frequency;
pub mod mesh;
pub mod movable;
pub mod scope;
pub mod time_form;
pub mod varying;

pub use added_inertia::AddedInertia;
pub use body::BodyPart;
pub use contact::Contacts;
pub use drive::SpinDrive;
pub use extent::Extent;
pub use filling::Filling;
pub use frequency::FrequencyDomain;
pub use mesh::Mesh;
pub use movable::MovableMasses;
pub use scope::Scope;
pub use time_form::ReplacedInTime;
pub use varying::VaryingInertia;
