//! What reading yields: every block of the file, complete or as far as it could be read.

use super::stand_in::{self, Side};
use super::{Block, MachineBlock, Spec};
use crate::model::field::{Field, Values};

/// A block as far as it could be read.
#[derive(Clone, Debug)]
pub(super) struct Drafted {
    /// The word of its header: part, study, cup ...
    pub word: &'static str,
    /// The block with the values that could be read; its kind is empty when it is unknown.
    pub block: Block,
    /// Keys that were given, or are needed, and could not be read.
    pub unread: Vec<&'static str>,
    /// Nothing is wrong with it.
    pub sound: bool,
    /// The name it was given cannot be one; it bears another.
    pub misnamed: bool,
}

/// A file as far as it could be read.
#[derive(Clone, Debug)]
pub(super) struct Draft {
    /// `[machine]`.
    pub machine: MachineBlock,
    /// Its keys that could not be read.
    pub machine_unread: Vec<&'static str>,
    /// `[[part]]` in order.
    pub parts: Vec<Drafted>,
    /// Blocks beside parts and studies, in the order of the catalogue.
    pub extras: Vec<Drafted>,
    /// `[[study]]` in order.
    pub studies: Vec<Drafted>,
    /// Names of which nothing is known but that something in the file bears them.
    pub strange: Vec<String>,
}

impl Drafted {
    /// The block with values in place of those that could not be read.
    pub fn completed(&self, fields: &[Field], side: Side) -> Block {
        let mut block = self.block.clone();
        stand_in::complete(&mut block.values, fields.iter().filter(|f| self.unread.contains(&f.name)), side);
        block
    }
}

impl Draft {
    /// The blocks of known kinds.
    pub fn spec(self) -> Spec {
        let known = |list: Vec<Drafted>| list.into_iter().filter(|d| !d.block.kind.is_empty());
        Spec {
            machine: self.machine,
            parts: known(self.parts).map(|d| d.block).collect(),
            studies: known(self.studies).map(|d| d.block).collect(),
            extras: known(self.extras).map(|d| (d.word, d.block)).collect(),
        }
    }
}

impl From<&Spec> for Draft {
    fn from(spec: &Spec) -> Self {
        let sound = |word: &'static str, b: &Block| Drafted { word, block: b.clone(), unread: Vec::new(), sound: true, misnamed: false };
        Draft {
            machine: spec.machine.clone(),
            machine_unread: Vec::new(),
            parts: spec.parts.iter().map(|b| sound("part", b)).collect(),
            extras: spec.extras.iter().map(|(word, b)| sound(word, b)).collect(),
            studies: spec.studies.iter().map(|b| sound("study", b)).collect(),
            strange: Vec::new(),
        }
    }
}

/// Values that stand in for all fields.
pub(super) fn invented(fields: &[Field], side: Side) -> Values {
    let mut values = Values::default();
    stand_in::complete(&mut values, fields.iter(), side);
    values
}
