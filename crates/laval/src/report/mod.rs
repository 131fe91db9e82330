//! Output: figures as SVG, tables as CSV and Parquet, `results.json`, a one-file report, words for the terminal.
//!
//! Everything is a function of a [`Report`] and gives the same bytes for the same input.
//!
//! ```
//! use laval::outcome::{Finding, Outcome, Table};
//! use laval::report::{Format, Provenance, Report, write};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let table = Table::new("modes", "Natural modes").float("frequency", "rad/s", "whirl frequency", vec![210.0]).build()?;
//! let outcome = Outcome::new("modes", "at rest").finding(Finding::info("count", "There is one mode.")).table(table);
//! let provenance = Provenance { version: "0.1.0".into(), input_name: "pump.toml".into(), ..Provenance::default() };
//! let report = Report { machine: "pump".into(), provenance, outcomes: vec![outcome], ..Report::default() };
//! let dir = std::env::temp_dir().join(format!("laval-doc-{}", std::process::id()));
//! let files = write(&dir, &report, &[Format::Json, Format::Csv])?;
//! assert_eq!(files, [dir.join("at-rest/modes.csv"), dir.join("results.json")]);
//! # std::fs::remove_dir_all(&dir)?;
//! # Ok(()) }
//! ```

mod animation;
mod colour;
mod csv;
mod embed;
mod evidence;
mod first_page;
pub mod fragment;
mod heat;
mod html;
mod json;
mod layout;
mod page;
#[cfg(feature = "parquet")]
mod parquet;
mod payload;
mod renew;
mod scene;
mod summary;
mod svg;
mod terminal;
mod text;
mod thin;
mod ticks;
mod tiles;
mod units;
mod words;
mod write;

pub use crate::language::Language;
pub use csv::csv;
pub use html::{html, page_one};
pub use json::{RESULTS_SCHEMA, SCHEMA, json};
pub use page::{figure, page};
#[cfg(feature = "parquet")]
pub use parquet::parquet;
pub use renew::{outdated, prepare, renew, share};
pub use summary::summary;
pub use svg::{draw, draw_in};
pub use terminal::{Terminal, terminal};
pub use text::{escape, file_name};
pub use units::{Rung, Units};
pub use words::Style;
pub use write::{Format, WriteError, folders, write};

use crate::outcome::{Outcome, Overview};

/// Everything one run found out, ready to be written.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Name of the machine.
    pub machine: String,
    /// Where the results come from.
    pub provenance: Provenance,
    /// Text of the input file, shown at the end of the page.
    pub input: Option<String>,
    /// Names of all studies of the input file, run or not: the names of the files follow from all of them. Empty where only those count that were run.
    pub studies: Vec<String>,
    /// One outcome per study that was run, in the order of the file.
    pub outcomes: Vec<Outcome>,
    /// The first page.
    pub overview: Option<Overview>,
    /// Language and units of the reader.
    pub style: Style,
}

impl Report {
    /// Names of all studies, run or not.
    fn studies(&self) -> Vec<&str> {
        let mut all: Vec<&str> = self.studies.iter().map(String::as_str).collect();
        for o in &self.outcomes {
            if !all.contains(&o.name.as_str()) {
                all.push(&o.name);
            }
        }
        all
    }
}

/// What is needed to compute the results again.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Provenance {
    /// Version of the program.
    pub version: String,
    /// Its build: sources, libraries, compiler.
    pub build: String,
    /// Widest instructions of the processor: the last digits may depend on it.
    pub processor: String,
    /// Name of the input file.
    pub input_name: String,
    /// Hash of the input file.
    pub input_hash: String,
    /// Settings that change results, name and value.
    pub settings: Vec<(String, String)>,
    /// Seed of random numbers, where any were used.
    pub seed: Option<u64>,
}
