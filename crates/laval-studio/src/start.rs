//! What the page begins with: a text, words, and what can be opened.

use crate::completion::completion;
use crate::folder;
use crate::server::State;
use laval::diagnostic::Diagnostic;
use laval::report::{Language, Style, Units, fragment};
use laval::text;
use serde::Deserialize;
use serde_json::{Value as Json, json};

/// `POST api/save`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Save {
    pub file: String,
    pub text: String,
    #[serde(default)]
    pub base: Option<String>,
    #[serde(default)]
    pub force: bool,
}

/// Names of languages in themselves.
const LANGUAGES: [(Language, &str); 4] =
    [(Language::English, "English"), (Language::Russian, "Русский"), (Language::Kazakh, "Қазақша"), (Language::Uzbek, "O‘zbekcha")];

pub(crate) fn start(state: &State, language: Language) -> Json {
    let options = &state.options;
    let style = Style { language, units: Units::everyday() };
    let own = options.file.as_ref().and_then(|f| folder::name_of(&options.folder, f));
    let opened = own.as_ref().and_then(|name| folder::read(&options.folder, name).ok());
    let first = || options.examples.first().map_or(String::new(), |e| e.text.to_string());
    // a file that is not there yet is the one that the first example is saved as
    let wanted = options.file.as_ref().and_then(|f| f.file_name()).map(|n| n.to_string_lossy().into_owned());
    let file = own.or(wanted).unwrap_or_default();
    let (decimal, lengths) = fragment::head(&style);
    let words = language.words("studio-", &["page-reset"], &["name", "value", "from", "to", "count"]);
    json!({
        "file": file,
        "text": options.text.clone().or(opened).unwrap_or_else(first),
        "folder_files": folder::list(&options.folder),
        "version": env!("CARGO_PKG_VERSION"),
        "language": language.code(),
        "languages": LANGUAGES.iter().map(|l| json!({ "code": l.0.code(), "name": l.1 })).collect::<Vec<_>>(),
        "words": words,
        "decimal": decimal,
        "lengths": lengths,
        "examples": options.examples.iter().map(|e| json!({ "name": e.name, "title": e.title })).collect::<Vec<_>>(),
        "completion": completion(&style),
    })
}

pub(crate) fn open(state: &State, file: Option<&str>, example: Option<&str>) -> Result<Json, Diagnostic> {
    let wrong = |message| Diagnostic::error("studio.file", message);
    match (file, example) {
        (Some(name), None) => Ok(json!({ "file": name, "text": folder::read(&state.options.folder, name)? })),
        (None, Some(name)) => {
            let found = state.options.examples.iter().find(|e| e.name == name);
            let found = found.ok_or_else(|| wrong(text!("there is no example {name}", name = text::quoted(&name))))?;
            Ok(json!({ "file": format!("{name}.toml"), "text": found.text }))
        }
        _ => Err(wrong(text!("name a file or an example"))),
    }
}
