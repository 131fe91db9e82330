//! How long every example takes: each of its studies, and the first page of its report, on all processors; the time of one run each.
//!
//! `cargo bench -p laval --bench examples [-- EXAMPLES... KINDS...]`, each by a part of its name; `page` is the first page

#[path = "common/allocator.rs"]
mod allocator;

#[path = "common/processor.rs"]
mod processor;

use laval::outcome::Outcome;
use laval::study::{Context, overview};
use processor::processor;
use std::time::Instant;

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
        let (mut outcomes, mut whole): (Vec<Outcome>, f64) = (Vec::new(), 0.0);
        let mut timed = |what: &str, seconds: f64| {
            println!("    {what:36} {seconds:8.3} s");
            whole += seconds;
        };
        for s in &loaded.studies {
            if chosen(&s.name, &of_studies) {
                let start = Instant::now();
                outcomes.extend(s.study.run(&loaded.system, &Context::quiet("example")));
                timed(&s.name, start.elapsed().as_secs_f64());
            }
        }
        if chosen("page", &of_studies) {
            let speeds: Vec<_> = loaded.studies.iter().flat_map(|s| s.study.speeds(&loaded.system)).collect();
            let start = Instant::now();
            overview(&loaded.system, &speeds, &outcomes, &Context::quiet("summary"));
            timed("page", start.elapsed().as_secs_f64());
        }
        println!("    {:36} {whole:8.3} s", "all");
    }
}
