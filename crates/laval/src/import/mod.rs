//! Machine files from the models of other programs.

pub mod ross;

mod machine;
mod model;
mod notes;
mod shaft;

use crate::text::Text;

/// A machine file that was made from the model of another program.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The file.
    pub text: String,
    /// What is not carried over, and what the other program does differently.
    pub notes: Vec<Text>,
}
