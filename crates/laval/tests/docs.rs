//! `docs/parts.md` and `docs/studies.md` say what the registries say. `LAVAL_WRITE_DOCS=1 cargo test -p laval --test docs` writes them anew.

use laval::file::{catalog, docs};
use std::path::Path;

fn page(name: &str, title: &str, intro: &str, kinds: &[laval::model::field::KindInfo], what: &str) {
    let mut text = format!("# {title}\n\n{intro}\n\n");
    for k in kinds {
        text.push_str(&format!("- [{}](#{})\n", k.kind, k.kind));
    }
    for k in kinds {
        text.push('\n');
        text.push_str(docs::markdown(what, k).trim_end());
        text.push('\n');
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name);
    if std::env::var_os("LAVAL_WRITE_DOCS").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default().replace('\r', "");
    assert!(found == text, "docs/{name} is not what the registry says: run LAVAL_WRITE_DOCS=1 cargo test -p laval --test docs");
}

#[test]
fn pages_of_parts_and_studies_are_current() {
    let c = catalog();
    let intro = "Every key of every kind of part, as `laval parts KIND` prints it. Values with a unit are strings (`\"70 mm\"`); bare numbers are SI.";
    page("parts.md", "Parts", intro, &c.parts, "part");
    let intro = "Every key of every kind of study, as `laval studies KIND` prints it.";
    page("studies.md", "Studies", intro, &c.studies, "study");
}
