//! Validation cases: documents that are also tests.
//!
//! A case is one Markdown page: what is required, where the expected numbers come from and what kind of evidence they are, how the
//! source's symbols map to the words of a machine file, the machine with its studies, the expected values with their tolerances, and
//! the verdict. `check` runs the machine the ordinary way, compares, and says whether the verdicts still hold; `gallery` writes
//! what was found as pages. `docs/validation.md` describes the format.
//!
//! ````
//! use laval::validation::{Case, Verdict, check};
//! let text = r#"
//! ## Mass on a spring
//!
//! |  |  |
//! | --- | --- |
//! | Requirement | The natural frequency of one mass on one spring is the root of k/m. |
//! | Source | Newton's second law. |
//! | Evidence | closed form |
//! | Verdict | agrees |
//!
//! ### Symbols
//! k is `stiffness`, m is `mass`.
//!
//! ### Machine
//! ```toml machine
//! [machine]
//! name = "mass on a spring"
//! [[part]]
//! kind = "disc"
//! name = "body"
//! mass = "4 kg"
//! [[part]]
//! kind = "shaft_lumped"
//! between = ["body", "ground"]
//! stiffness = "400 N/m"
//! [[study]]
//! kind = "modes"
//! speed = "0 rad/s"
//! ```
//!
//! ### Expected
//! | study | value | at | expected | unit | tolerance |
//! | --- | --- | --- | --- | --- | --- |
//! | modes | modes / frequency | first | 10 | rad/s | 1e-12 relative |
//!
//! ### Tolerance
//! Rounding of a small eigenproblem.
//! "#;
//! let case = Case::parse("linear/mass-on-a-spring", text).unwrap_or_else(|d| panic!("{d:?}"));
//! let checked = check(case);
//! assert_eq!(checked.verdict(), Some(Verdict::Agrees));
//! assert!(checked.holds());
//! ````

mod case;
mod check;
mod collect;

mod gallery;
mod markdown;
mod marks;
mod table;
mod value;

pub use case::{Case, EvidenceKind, MachineText, Verdict};
pub use check::{Checked, Compared, check};
pub use collect::{Document, documents, run};
pub use gallery::{Page, gallery};
pub use table::{Expectation, Expected, Row, Tolerance};
pub use value::{Measured, What};
