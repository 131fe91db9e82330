//! Machines composed in Rust, without a file.

use super::erased::Erased;
use super::params::Family;
use super::part::{Params, Part};
use super::system::{Axis, Drive, Machine, PartInput, System};
use crate::diagnostic::Diagnostics;
use std::sync::Arc;

/// Composes a [`System`].
#[derive(Clone, Default)]
pub struct Builder {
    machine: Machine,
    parts: Vec<PartInput>,
}

impl Builder {
    /// A machine with a name.
    pub fn new(name: impl Into<String>) -> Self {
        Builder { machine: Machine { name: name.into(), ..Machine::default() }, parts: Vec::new() }
    }
    /// Spin speed for studies that name none, rad/s.
    pub fn speed(mut self, speed: f64) -> Self {
        self.machine.speed = Some(speed);
        self
    }
    /// A horizontal shaft: weight acts along -y.
    pub fn horizontal(mut self) -> Self {
        self.machine.axis = Axis::Horizontal;
        self
    }
    /// The spin angle is a coordinate of its own.
    pub fn free_spin(mut self) -> Self {
        self.machine.drive = Drive::Free;
        self
    }
    /// Adds a part.
    pub fn part<P: Part>(self, name: impl Into<String>, part: P, params: impl Into<Params<P, f64>>) -> Self {
        self.input(name, part.erased(), P::Family::to_vec(&params.into()))
    }
    /// Adds a part whose type is forgotten, with its parameters in slot order.
    pub fn input(mut self, name: impl Into<String>, part: Arc<dyn Erased>, params: Vec<f64>) -> Self {
        self.parts.push(PartInput { name: name.into(), part, params, span: None });
        self
    }
    /// Assembles.
    pub fn build(self) -> Result<System, Diagnostics> {
        System::assemble(self.machine, self.parts)
    }
}
