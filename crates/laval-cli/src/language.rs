//! The language in which the program speaks: that of `--lang`, else that of `[report]` in the machine file, else that of the environment.

use laval::file::written_language;
use laval::report::Language;
use laval::text::Text;
use std::sync::RwLock;

static REQUESTED: RwLock<Option<Language>> = RwLock::new(None);
static WRITTEN: RwLock<Option<Language>> = RwLock::new(None);

/// What `--lang` says.
pub fn request(language: Option<Language>) {
    put(&REQUESTED, language);
}

/// What a machine file says.
pub fn of_file(text: &str) {
    put(&WRITTEN, written_language(text));
}

/// The language of `--lang` alone.
pub fn requested() -> Option<Language> {
    got(&REQUESTED)
}

/// The language of the program.
pub fn current() -> Language {
    got(&REQUESTED).or_else(|| got(&WRITTEN)).or_else(environment).unwrap_or_default()
}

/// A sentence in it.
pub fn said(text: &Text) -> String {
    current().said(text)
}

fn environment() -> Option<Language> {
    let set = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().filter_map(|name| std::env::var(name).ok()).find(|v| !v.is_empty());
    set?.parse().ok()
}

fn put(place: &RwLock<Option<Language>>, language: Option<Language>) {
    if let Ok(mut place) = place.write() {
        *place = language;
    }
}

fn got(place: &RwLock<Option<Language>>) -> Option<Language> {
    place.read().ok().and_then(|l| *l)
}
