//! Blocks of the pages a user copies from: every one reads without mistakes where it stands.

use laval::file::{catalog, docs, load};
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A machine in which every point that an example may name exists.
pub const BESIDE: &str = "[machine]\nspeed = \"3000 rpm\"\n\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = \"2.4 kg\"\n\
    polar_inertia = \"0.01 kg m^2\"\neccentricity = \"20 um\"\n\n\
    [[part]]\nkind = \"foundation\"\nname = \"support\"\nmass = \"25 kg\"\nstiffness = \"3.26e5 N/m\"\ndamping = \"6.59 N s/m\"\n\n\
    [[part]]\nkind = \"bearing_cubic\"\nname = \"spring\"\nbetween = [\"drum\", \"support\"]\nlaw = \"isotropic\"\nstiffness = \"1e7 N/m\"\ncubic_stiffness = \"1e12 N/m^3\"\n\n";

/// What a block must have beside it to be complete.
pub fn beside(what: &str, kind: &str) -> String {
    let c = catalog();
    let example = |word: &str, kind: &str| {
        let block = c.blocks.iter().find(|b| b.word == word).unwrap();
        docs::example(word, block.kinds.iter().find(|k| k.kind == kind).unwrap())
    };
    match (what, kind) {
        ("part", "gear") => "[[part]]\nkind = \"speed_ratio\"\nname = \"fast\"\nratio = -2\n[[part]]\nkind = \"disc\"\nname = \"pinion\"\nspin = \"fast\"\nmass = \"3 kg\"\npolar_inertia = \"0.02 kg m^2\"\ntorsional = true\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"of_pinion\"\nbetween = [\"pinion\", \"ground\"]\nkxx = 1e7\nkyy = 1e7\n"
            .to_string(),
        ("study", "separation" | "operating_window") => {
            format!("{}\n{}\n", example("cup", "swinging"), example("suspension", "suspension"))
        }
        _ => String::new(),
    }
}

/// The text is a file without mistakes, and no study of it is refused.
fn reads(text: &str, whose: &str) {
    match load(text) {
        Err(failure) => {
            let messages: Vec<String> = failure.0.iter().map(|d| d.message.to_string()).collect();
            panic!("{whose}: {messages:#?}\n{text}");
        }
        Ok(machine) => {
            let refused: Vec<String> = machine.refusals().iter().map(|r| r.diagnostic.message.to_string()).collect();
            assert!(refused.is_empty(), "{whose}: {refused:#?}\n{text}");
        }
    }
}

#[test]
fn every_kind_has_a_typical_example_that_reads() {
    let c = catalog();
    let blocks = c.blocks.iter().flat_map(|b| b.kinds.iter().map(move |k| (b.word, k)));
    let kinds = c.parts.iter().map(|k| ("part", k)).chain(c.studies.iter().map(|k| ("study", k))).chain(blocks);
    let mut without = Vec::new();
    for (what, kind) in kinds {
        let block = docs::example(what, kind);
        let body = ["disc", "foundation"].contains(&kind.kind);
        // a gear joins bodies that twist
        let twisting = BESIDE.replace("eccentricity", "torsional = true\neccentricity");
        let machine = match kind.kind {
            _ if body => "[machine]\n",
            "gear" => &twisting,
            _ => BESIDE,
        };
        let what_else = if body { "" } else { &beside(what, kind.kind) };
        reads(&format!("{machine}{what_else}{block}"), kind.kind);
        if kind.example.is_empty() {
            without.push(kind.kind);
        }
        // keys that a message advises to add come from it
        for field in kind.fields.iter().filter(|f| f.required) {
            assert!(block.contains(&format!("\n{} = ", field.name)), "the example of {} lacks {}", kind.kind, field.name);
        }
    }
    assert!(without.is_empty(), "no typical example: {without:?}");
}

/// Blocks of a page between ```toml and ```.
fn blocks(page: &str) -> Vec<String> {
    let text = std::fs::read_to_string(root().join(page)).unwrap().replace('\r', "");
    text.split("```toml\n").skip(1).map(|b| b.split("```").next().unwrap_or_default().to_string()).collect()
}

/// The tutorial as it is followed: every block is pasted to the end of the file.
#[test]
fn the_tutorial_can_be_followed() {
    let mut file = String::new();
    let blocks = blocks("docs/tutorial.md");
    assert!(blocks.len() >= 8);
    for block in blocks {
        file.push_str(&block);
        file.push('\n');
        reads(&file, "docs/tutorial.md");
    }
    let machine = load(&file).unwrap();
    assert!(machine.studies.len() >= 8);
}

/// Values in the text of the page of the machine file.
#[test]
fn values_of_the_machine_file_read() {
    let mut seen = 0;
    for block in blocks("docs/machine-file.md").iter().filter(|b| !b.starts_with('[')) {
        reads(&format!("{BESIDE}[[study]]\nkind = \"transient\"\nduration = \"1 s\"\n{block}"), "docs/machine-file.md");
        seen += 1;
    }
    assert_eq!(seen, 1);
}

/// Other pages: a block that is a whole file reads by itself, another beside a machine.
#[test]
fn blocks_of_other_pages_read() {
    let mut pages = vec![PathBuf::from("README.md"), PathBuf::from("CONTRIBUTING.md")];
    for folder in ["docs", "examples"] {
        let mut folders = vec![PathBuf::from(folder)];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(root().join(&folder)).unwrap() {
                let name = folder.join(entry.unwrap().file_name());
                if root().join(&name).is_dir() {
                    folders.push(name);
                } else if name.extension().is_some_and(|e| e == "md") {
                    pages.push(name);
                }
            }
        }
    }
    let of_their_own = ["tutorial.md", "machine-file.md", "parts.md", "studies.md", "separation-blocks.md"];
    for page in pages.iter().filter(|p| !of_their_own.iter().any(|o| p.ends_with(o))) {
        for block in blocks(&page.to_string_lossy()) {
            let machine = if block.contains("[machine]") { "" } else { BESIDE };
            reads(&format!("{machine}{block}"), &page.to_string_lossy());
        }
    }
}
