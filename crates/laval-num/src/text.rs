//! Texts of a program that are read back from a stored result: each is kept once, for as long as the program runs.

use serde::{Deserialize, Deserializer};
use std::collections::BTreeSet;
use std::sync::{LazyLock, Mutex, PoisonError};

/// A text of the program. Under this name the derived readers do not borrow it.
pub type Text = &'static str;

static KNOWN: LazyLock<Mutex<BTreeSet<&'static str>>> = LazyLock::new(Mutex::default);

fn kept(text: String) -> &'static str {
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    match known.get(text.as_str()) {
        Some(k) => k,
        None => {
            let text = text.leak();
            known.insert(text);
            text
        }
    }
}

/// A text.
///
/// # Errors
/// As the format.
pub fn one<'de, D: Deserializer<'de>>(from: D) -> Result<&'static str, D::Error> {
    String::deserialize(from).map(kept)
}

/// A text that may be missing.
///
/// # Errors
/// As the format.
pub fn optional<'de, D: Deserializer<'de>>(from: D) -> Result<Option<&'static str>, D::Error> {
    Ok(Option::<String>::deserialize(from)?.map(kept))
}

/// Counts of things that texts name.
///
/// # Errors
/// As the format.
pub fn counts<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<(&'static str, u64)>, D::Error> {
    Ok(Vec::<(String, u64)>::deserialize(from)?.into_iter().map(|(text, n)| (kept(text), n)).collect())
}
