//! How long every example takes: each of its studies, and the first page of its report, on all processors: the time on the wall clock and that of all processors together, of one run each.
//!
//! `cargo bench --workspace --bench examples [-- EXAMPLES... KINDS...]`, each by a part of its name; `page` is the first page

#[path = "common/allocator.rs"]
mod allocator;

#[path = "common/clock.rs"]
mod clock;

#[path = "common/processor.rs"]
mod processor;

#[path = "common/row.rs"]
mod row;

use clock::{all_threads, wall};
use laval::outcome::Outcome;
use laval::study::{Context, overview};
use processor::processor;
use row::row;

fn main() {
    println!("processor: {}", processor());
    let words: Vec<String> = std::env::args().skip(1).filter(|w| !w.starts_with("--")).collect();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut files: Vec<_> = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path().join("machine.toml")).collect();
    files.retain(|f| f.exists());
    files.sort();
    let names: Vec<String> = files.iter().filter_map(|f| Some(f.parent()?.file_name()?.to_string_lossy().into_owned())).collect();
    let of_file = |w: &String| names.iter().any(|n| n.contains(w.as_str()));
    let [of_files, of_studies]: [Vec<&String>; 2] = [true, false].map(|file| words.iter().filter(|w| of_file(w) == file).collect());
    let chosen = |w: &str, by: &[&String]| by.is_empty() || by.iter().any(|x| w.contains(x.as_str()));
    for (file, name) in files.iter().zip(&names).filter(|f| chosen(f.1, &of_files)) {
        let text = std::fs::read_to_string(file).unwrap_or_default();
        let loaded = match laval::file::load(&text) {
            Ok(loaded) => loaded,
            Err(d) => return println!("{name}: {d:?}"),
        };
        println!("{name}");
        let (mut outcomes, mut whole): (Vec<Outcome>, [f64; 2]) = (Vec::new(), [0.0; 2]);
        let shown = |what: &str, [wall, work]: [f64; 2]| {
            println!("    {what:36} {wall:8.3} s {work:8.3} s of processors");
            row(&format!("{name}, {what}"), wall, Some(("all processors together", work)));
        };
        let now = || [wall(), all_threads()];
        let since = |start: [f64; 2]| [wall() - start[0], all_threads() - start[1]];
        let mut timed = |what: &str, took: [f64; 2]| {
            shown(what, took);
            whole = [whole[0] + took[0], whole[1] + took[1]];
        };
        for s in &loaded.studies {
            if chosen(&s.name, &of_studies) {
                let start = now();
                outcomes.extend(s.study.run(&loaded.system, &Context::quiet("example")));
                timed(&s.name, since(start));
            }
        }
        if chosen("page", &of_studies) {
            let speeds: Vec<_> = loaded.studies.iter().flat_map(|s| s.study.speeds(&loaded.system)).collect();
            let start = now();
            overview(&loaded.system, &speeds, &outcomes, &Context::quiet("summary"));
            timed("page", since(start));
        }
        shown("all", whole);
    }
}
