//! `laval parts`, `laval studies`, `laval units` and `laval schema`: what the registries declare.

use crate::{DONE, WRONG, input, terminal};
use laval::diagnostic::{Diagnostic, meant, nearest};
use laval::file::{catalog, docs, schema};
use laval::model::field::{BlockInfo, KindInfo};
use laval::report::RESULTS_SCHEMA;
use laval::text;

/// What may be said to `parts` and `studies`.
#[derive(clap::Args)]
pub struct Args {
    /// The kind to document
    kind: Option<String>,
}

/// `laval parts`.
pub fn parts(args: &Args) -> u8 {
    if args.kind.as_deref() == Some("machine") {
        terminal::print(&docs::text("machine", &docs::machine(), terminal::width()));
        return DONE;
    }
    let all = catalog();
    if let Some(word) = &args.kind {
        // blocks beside the parts: one kind of them, or all of a block
        let chosen = |b: &&BlockInfo| b.word == word || b.kinds.iter().any(|k| k.kind == word);
        if let Some(block) = all.blocks.iter().find(chosen).filter(|_| all.part(word).is_none()) {
            for kind in block.kinds.iter().filter(|k| block.word == word || k.kind == word) {
                terminal::print(&docs::text(block.word, kind, terminal::width()));
            }
            return DONE;
        }
    }
    let code = show("part", "parts", &all.parts, args);
    if args.kind.is_none() {
        let words = all.blocks.iter().map(|b| b.word).collect::<Vec<_>>().join(", ");
        terminal::print(&format!("laval parts machine documents the [machine] block; so do {words} for what stands beside the parts.\n"));
    }
    code
}

/// `laval studies`.
pub fn studies(args: &Args) -> u8 {
    show("study", "studies", &catalog().studies, args)
}

/// `laval units`.
pub fn units() -> u8 {
    terminal::print(&docs::units_page());
    DONE
}

/// What may be said to `schema`.
#[derive(clap::Args)]
pub struct SchemaArgs {
    /// The schema of results.json instead
    #[arg(long)]
    results: bool,
}

/// `laval schema`.
pub fn schema(args: &SchemaArgs) -> u8 {
    match args.results {
        true => terminal::print(RESULTS_SCHEMA),
        false => terminal::print(&format!("{:#}\n", schema::schema(catalog()))),
    };
    DONE
}

fn show(what: &str, many: &str, kinds: &[KindInfo], args: &Args) -> u8 {
    let Some(word) = &args.kind else {
        terminal::print(&list(kinds));
        terminal::print(&format!("\nlaval {many} KIND documents one.\n"));
        return DONE;
    };
    match kinds.iter().find(|k| k.kind == word) {
        Some(kind) => {
            terminal::print(&docs::text(what, kind, terminal::width()));
            DONE
        }
        None => {
            let all = kinds.iter().map(|k| k.kind).collect::<Vec<_>>().join(", ");
            let list = match what {
                "study" => text!("kinds of studies: {all}", all),
                _ => text!("kinds of {what}s: {all}", what, all),
            };
            let help = match nearest(word, kinds.iter().map(|k| k.kind)) {
                Some(near) => meant(text::quoted(&near), list),
                None => list,
            };
            input::complain(
                &Diagnostic::error("kind.unknown", text!("there is no kind of {what} called {word}", what, word = text::quoted(&word)))
                    .help(help),
            );
            WRONG
        }
    }
}

/// One line a kind: its word and the first sentence of its documentation.
fn list(kinds: &[KindInfo]) -> String {
    let column = kinds.iter().map(|k| k.kind.len()).max().unwrap_or(0);
    kinds.iter().map(|k| format!("{:column$}  {}\n", k.kind, first_sentence(k.doc))).collect()
}

fn first_sentence(doc: &str) -> &str {
    doc.split_once(". ").map_or(doc, |(first, _)| first).trim_end_matches('.')
}
