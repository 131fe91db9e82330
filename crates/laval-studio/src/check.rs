//! What is wrong with a text, and the machine that it describes.

use crate::edit::{self, Set};
use crate::machines::Machines;
use crate::offsets::Offsets;
use crate::{drawing, parameters, scene};
use laval::diagnostic::Diagnostics;
use laval::file::{self, Loaded};
use laval::report::Language;
use laval::run;
use laval::study;
use serde::Deserialize;
use serde_json::{Value as Json, json};
use std::borrow::Cow;

/// `POST api/check`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    #[serde(default)]
    pub serial: i64,
    pub text: String,
    #[serde(default)]
    pub set: Vec<Set>,
}

/// Kinds of studies whose answers come at once.
const QUICK: [&str; 6] = ["modes", "campbell", "critical_speeds", "stability_map", "forced_response", "nonlinear_response"];

/// A text after changes.
pub(crate) fn changed<'a>(machines: &Machines, text: &'a str, set: &[Set]) -> Result<(Cow<'a, str>, Vec<file::Edit>), Diagnostics> {
    let edits = edit::changes(machines, text, set)?;
    let text = if edits.is_empty() { Cow::Borrowed(text) } else { Cow::Owned(file::edited(text, &edits)) };
    Ok((text, edits))
}

/// The text after the changes, its diagnostics and its machine.
pub(crate) fn check(machines: &Machines, request: &Request, language: Language) -> Result<(String, Json), Diagnostics> {
    let (text, _) = changed(machines, &request.text, &request.set)?;
    let offsets = Offsets::new(&text);
    let (found, machine) = match machines.load(&text) {
        Ok(loaded) => {
            let mut found = loaded.warnings.clone();
            // a study that the machine cannot answer stops none of the others
            found.0.extend(loaded.refusals().into_iter().map(|r| r.diagnostic));
            (found, machine(&text, &loaded, language, &offsets))
        }
        Err(found) => ((*found).clone(), Json::Null),
    };
    let answer = json!({ "serial": request.serial, "diagnostics": diagnostics(&text, &found, language, &offsets), "machine": machine });
    Ok((text.into_owned(), answer))
}

fn diagnostics(text: &str, found: &Diagnostics, language: Language, offsets: &Offsets) -> Json {
    let Json::Array(mut all) = file::diagnostics_json_in(language, found, text) else { return json!([]) };
    let place = |p: &Json, end: &str| p[end].as_u64().map_or(0, |b| offsets.units(usize::try_from(b).unwrap_or(0)));
    for d in &mut all {
        let p = d["place"].take();
        (d["from"], d["to"]) = (place(&p, "start").into(), place(&p, "end").into());
        if let Some(d) = d.as_object_mut() {
            d.remove("place");
            d.remove("also");
        }
    }
    all.into()
}

fn machine(text: &str, loaded: &Loaded, language: Language, offsets: &Offsets) -> Json {
    let style = run::style(text, loaded, language);
    let system = &loaded.system;
    let (blocks, horizontal) = study::machine_blocks(system);
    let numbers = parameters::numbers(text, loaded);
    let section = scene::Section::of(system, &blocks, horizontal);
    let studies: Vec<Json> = loaded
        .studies
        .iter()
        .map(|s| json!({ "name": s.name, "kind": s.study.kind(), "quick": !s.study.in_chunks() && QUICK.contains(&s.study.kind()) }))
        .collect();
    json!({
        "name": system.machine.name,
        "speed": system.machine.speed,
        "parameters": parameters::shown(text, &numbers, &style, offsets),
        "studies": studies,
        "drawing": drawing::drawing(system, &blocks, horizontal, &section, &numbers, &style),
        "scene": section.json(),
    })
}
