//! Tests of the program from outside, by subject.

mod cli;
mod folder;
mod import;
mod languages;
mod launcher;
mod names;
mod notices;
mod pieces;
mod results_schema;
mod shown;
mod studio;
mod validate;
