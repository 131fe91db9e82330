//! Languages of people: the catalogues of sentences, and sentences of diagnostics in them.

mod catalogue;
mod said;

pub use catalogue::Language;
pub use said::has_words;
