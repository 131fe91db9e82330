//! The store of long studies: what is there after a kill, a full disk, a damaged file, a changed input, two processes.

use laval::diagnostic::Diagnostic;
use laval::outcome::End;
use laval::store::{self, Cells, Column, Keep, NO_RESULT, Piece, Plan, Results, Work};
use laval::study::{Cancel, Context, Progress};
use serde_json::json;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::Ordering;
use std::time::Duration;

const ROWS: usize = 1030;
const CHUNK: usize = 20;

struct Dir(PathBuf);

impl Dir {
    fn new(name: &str) -> Dir {
        let dir = std::env::temp_dir().join(format!("laval-store-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&dir);
        Dir(dir)
    }
    fn keep(&self) -> Keep {
        Keep {
            folder: self.0.clone(),
            input: json!({"part": [{"name": "drum", "mass": 2.4}], "study": {"points": 3}}),
            fresh: false,
            work: Work::Missing,
        }
    }
}

impl Drop for Dir {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[derive(Default)]
struct Reported {
    notes: Mutex<Vec<String>>,
    reports: Mutex<Vec<(u64, u64)>>,
    restored: Mutex<Vec<(u64, u64)>>,
}

impl Progress for Reported {
    fn report(&self, done: u64, total: u64) {
        self.reports.lock().unwrap().push((done, total));
    }
    fn restored(&self, done: u64, total: u64) {
        self.restored.lock().unwrap().push((done, total));
    }
    fn note(&self, text: &laval::text::Text) {
        self.notes.lock().unwrap().push(text.to_string());
    }
}

fn plan() -> Plan {
    let columns =
        vec![Column::float("x", "m", "end of an orbit"), Column::int("steps", "", "number of steps"), Column::text("why", "cause")];
    Plan { study: "orbits".into(), columns, rows: ROWS, chunk: CHUNK }
}

/// The logistic map, some rows without a number or a word.
fn rows(range: Range<usize>) -> Vec<Cells> {
    let (mut x, mut steps, mut why) = (vec![], vec![], vec![]);
    for i in range {
        let mut y = (i as f64 + 1.0) / (ROWS as f64 + 2.0);
        for _ in 0..10_000 {
            y = 3.99 * y * (1.0 - y);
        }
        x.push(if i % 7 == 3 { f64::NAN } else { y });
        steps.push((i % 5 != 0).then_some(i as i64));
        why.push((i % 3 == 0).then(|| format!("row {i}")));
    }
    vec![Cells::Float(x), Cells::Int(steps), Cells::Text(why)]
}

fn run(keep: &Keep, reported: &Reported, mut computed: impl FnMut(usize)) -> Result<Results, Diagnostic> {
    let context = Context { progress: reported, keep: Some(keep), ..Context::quiet("s") };
    store::run(plan(), &context, |range, counter| {
        computed(range.start / CHUNK);
        counter.add(range.len() as u64);
        Ok(Some(rows(range)))
    })
}

/// Names and bytes of all files.
fn files(dir: &Path) -> BTreeMap<String, Vec<u8>> {
    let all = fs::read_dir(dir).unwrap().map(|e| e.unwrap().path());
    all.map(|p| (p.file_name().unwrap().to_str().unwrap().to_string(), fs::read(&p).unwrap())).collect()
}

fn undisturbed() -> BTreeMap<String, Vec<u8>> {
    let dir = Dir::new(&format!("whole-{:?}", std::thread::current().id()));
    let results = run(&dir.keep(), &Reported::default(), |_| {}).unwrap();
    assert!(results.complete() && results.end() == End::Reached && results.remark().is_none());
    drop(results);
    files(&dir.0)
}

fn expected() -> Vec<Cells> {
    rows(0..ROWS)
}

fn assert_same_rows(results: &Results) {
    let whole = expected();
    let mut next = 0;
    for chunk in results.chunks() {
        let chunk = chunk.unwrap();
        assert_eq!(chunk.rows.start, next);
        next = chunk.rows.end;
        let Cells::Float(x) = &chunk.cells[0] else { panic!() };
        let Cells::Float(y) = &whole[0] else { panic!() };
        assert!(x.iter().zip(&y[chunk.rows.clone()]).all(|(a, b)| a.to_bits() == b.to_bits()));
        for i in 0..chunk.rows.len() {
            assert_eq!(chunk.cells[2].word(i), whole[2].word(chunk.rows.start + i));
            assert!(chunk.cells[1].number(i).to_bits() == whole[1].number(chunk.rows.start + i).to_bits());
        }
    }
    assert_eq!(next, ROWS);
}

/// The process that is killed; does nothing when it is not requested to be it.
#[test]
fn killed_process() {
    let Some(folder) = std::env::var_os("LAVAL_STORE_FOLDER") else { return };
    let dir = std::mem::ManuallyDrop::new(Dir(PathBuf::from(folder)));
    let log = PathBuf::from(std::env::var_os("LAVAL_STORE_LOG").unwrap());
    let mut log = fs::OpenOptions::new().append(true).create(true).open(log).unwrap();
    run(&dir.keep(), &Reported::default(), |chunk| writeln!(log, "{chunk}").unwrap()).unwrap();
}

#[test]
fn killed_at_twenty_random_moments_and_resumed_the_files_are_those_of_the_undisturbed_run() {
    let dir = Dir::new("kill");
    let log = std::env::temp_dir().join(format!("laval-store-{}.log", std::process::id()));
    let start = |log: &Path| {
        Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "store::killed_process"])
            .env("LAVAL_STORE_FOLDER", &dir.0)
            .env("LAVAL_STORE_LOG", log)
            .stdout(Stdio::null())
            .spawn()
            .unwrap()
    };
    let present = || (0..ROWS.div_ceil(CHUNK)).filter(|i| dir.0.join(format!("chunk-{i:06}.parquet")).is_file()).collect::<Vec<_>>();
    let mut seed = 0x2545_f491_4f6c_dd1d_u64;
    let mut kills = 0;
    while kills < 20 {
        let before = present();
        let _ = fs::remove_file(&log);
        let mut child = start(&log);
        // xorshift64
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        std::thread::sleep(Duration::from_micros(1000 + seed % 40_000));
        // SIGKILL on Unix
        child.kill().unwrap();
        let killed = !child.wait().unwrap().success();
        kills += usize::from(killed);
        let text = fs::read_to_string(&log).unwrap_or_default();
        for chunk in text.lines().map(|l| l.parse::<usize>().unwrap()) {
            assert!(!before.contains(&chunk), "chunk {chunk} was there and was computed again");
        }
        let after = present();
        assert!(before.iter().all(|c| after.contains(c)), "a chunk was lost");
        if !killed {
            // it was faster than the kills: once more from the start
            fs::remove_dir_all(&dir.0).unwrap();
        }
    }
    assert!(start(&log).wait().unwrap().success());
    let _ = fs::remove_file(&log);
    assert!(files(&dir.0) == undisturbed());
}

#[test]
fn between_chunk_and_manifest_nothing_is_lost_or_repeated() {
    let dir = Dir::new("between");
    let before = {
        run(&dir.keep(), &Reported::default(), |_| {}).unwrap();
        files(&dir.0)
    };
    // the manifest as it was before chunk 7, whose file stands; an unfinished chunk 8; nothing after
    let mut manifest: serde_json::Value = serde_json::from_slice(&before["manifest.json"]).unwrap();
    manifest["chunks"].as_array_mut().unwrap().truncate(7);
    fs::write(dir.0.join("manifest.json"), serde_json::to_string_pretty(&manifest).unwrap()).unwrap();
    for i in 8..ROWS.div_ceil(CHUNK) {
        fs::remove_file(dir.0.join(format!("chunk-{i:06}.parquet"))).unwrap();
    }
    fs::write(dir.0.join(".laval-1-0.part"), b"half").unwrap();
    let reported = Reported::default();
    let mut computed = Vec::new();
    let results = run(&dir.keep(), &reported, |c| computed.push(c)).unwrap();
    assert_same_rows(&results);
    drop(results);
    assert_eq!(computed, (8..ROWS.div_ceil(CHUNK)).collect::<Vec<_>>());
    assert_eq!(*reported.restored.lock().unwrap(), [(160, ROWS as u64)]);
    assert_eq!(reported.reports.lock().unwrap().first(), Some(&(180, ROWS as u64)));
    assert_eq!(reported.reports.lock().unwrap().last(), Some(&(ROWS as u64, ROWS as u64)));
    assert!(reported.notes.lock().unwrap().is_empty());
    assert!(files(&dir.0) == before);
}

#[test]
fn damaged_and_missing_chunks_are_computed_again_and_reported() {
    let dir = Dir::new("damaged");
    drop(run(&dir.keep(), &Reported::default(), |_| {}).unwrap());
    let before = files(&dir.0);
    let path = dir.0.join("chunk-000003.parquet");
    let mut bytes = fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&path, bytes).unwrap();
    fs::remove_file(dir.0.join("chunk-000005.parquet")).unwrap();
    // a whole file, of another chunk
    fs::copy(dir.0.join("chunk-000010.parquet"), dir.0.join("chunk-000009.parquet")).unwrap();
    let reported = Reported::default();
    let mut computed = Vec::new();
    drop(run(&dir.keep(), &reported, |c| computed.push(c)).unwrap());
    assert_eq!(computed, [3, 5, 9]);
    let notes = reported.notes.lock().unwrap();
    assert_eq!(notes.len(), 3);
    assert!(notes[0].contains("chunk-000003.parquet is damaged: rows 60 to 79 are computed again"), "{notes:?}");
    assert!(notes[1].contains("missing") && notes[2].contains("damaged"), "{notes:?}");
    assert!(files(&dir.0) == before);
}

#[test]
fn no_flipped_bit_of_a_chunk_that_no_manifest_names_is_believed() {
    let dir = Dir::new("flip");
    let small = || Plan { rows: 60, ..plan() };
    let keep = dir.keep();
    let notes = |computed: &mut Vec<usize>| {
        let reported = Reported::default();
        let context = Context { progress: &reported, keep: Some(&keep), ..Context::quiet("s") };
        let results = store::run(small(), &context, |range, _| {
            computed.push(range.start / CHUNK);
            Ok(Some(rows(range)))
        });
        assert!(results.unwrap().complete());
        reported.notes.into_inner().unwrap()
    };
    notes(&mut Vec::new());
    let before = files(&dir.0);
    let path = dir.0.join("chunk-000001.parquet");
    let bytes = before["chunk-000001.parquet"].clone();
    // sound as it is
    fs::remove_file(dir.0.join("manifest.json")).unwrap();
    let mut computed = Vec::new();
    assert!(notes(&mut computed).is_empty() && computed.is_empty());
    // every seventh byte, each time another bit
    for at in (0..bytes.len()).step_by(7) {
        let mut flipped = bytes.clone();
        flipped[at] ^= 1 << (at % 8);
        fs::write(&path, flipped).unwrap();
        fs::remove_file(dir.0.join("manifest.json")).unwrap();
        let mut computed = Vec::new();
        assert_eq!((notes(&mut computed).len(), computed), (1, vec![1]), "byte {at}");
        assert!(files(&dir.0) == before, "byte {at}");
    }
}

#[test]
fn rows_of_another_build_or_processor_are_not_continued() {
    let dir = Dir::new("build");
    drop(run(&dir.keep(), &Reported::default(), |_| {}).unwrap());
    let path = dir.0.join("manifest.json");
    let whole = fs::read_to_string(&path).unwrap();
    for (key, own) in [("build", laval::build::ID), ("processor", laval::build::processor())] {
        let mut manifest: serde_json::Value = serde_json::from_str(&whole).unwrap();
        assert_eq!(manifest[key], own);
        manifest[key] = "other".into();
        // what that build has written: its hash is another one
        manifest["input_hash"] = format!("sha256:{:064}", 0).into();
        fs::write(&path, manifest.to_string()).unwrap();
        let d = run(&dir.keep(), &Reported::default(), |_| panic!("computed")).err().unwrap();
        assert_eq!(d.code, "store.changed");
        assert!(d.message.contains("of another build of the program or another processor"), "{}", d.message);
        assert!(d.message.contains(&format!("{key} was \"other\", now \"{own}\"")), "{}", d.message);
    }
}

#[test]
fn changed_input_is_refused_with_what_changed_and_fresh_starts_anew() {
    let dir = Dir::new("changed");
    drop(run(&dir.keep(), &Reported::default(), |_| {}).unwrap());
    let before = files(&dir.0);
    let changed = Keep { input: json!({"part": [{"name": "drum", "mass": 2.5}], "study": {"points": 3}}), ..dir.keep() };
    let d = run(&changed, &Reported::default(), |_| panic!("computed")).err().unwrap();
    assert_eq!(d.code, "store.changed");
    assert!(d.message.contains("part.drum.mass was 2.4, now 2.5"), "{}", d.message);
    assert!(d.help.as_deref().unwrap().contains("--out") && d.help.as_deref().unwrap().contains("--fresh"));
    assert!(files(&dir.0) == before);
    let context = |keep| Context { keep: Some(keep), ..Context::quiet("s") };
    let keep = dir.keep();
    let d = store::run(Plan { rows: ROWS + 1, ..plan() }, &context(&keep), |_, _| panic!("computed")).err().unwrap();
    assert!(d.message.contains("number of rows was 1030, now 1031"), "{}", d.message);
    let fresh = Keep { fresh: true, ..changed.clone() };
    let mut computed = 0;
    drop(run(&fresh, &Reported::default(), |_| computed += 1).unwrap());
    assert_eq!(computed, ROWS.div_ceil(CHUNK));
    // and is now what the folder belongs to
    drop(run(&changed, &Reported::default(), |_| panic!("computed")).unwrap());
    fs::write(dir.0.join("manifest.json"), "{ \"format\": 99 }").unwrap();
    assert_eq!(run(&changed, &Reported::default(), |_| {}).err().unwrap().code, "store.manifest");
}

#[test]
fn starting_anew_removes_no_file_of_others() {
    let dir = Dir::new("foreign");
    let fresh = Keep { fresh: true, ..dir.keep() };
    for foreign in ["{ \"name\": \"a web page\" }", "{ \"format\": 2 }", "no JSON", "[1, 2]"] {
        fs::create_dir_all(&dir.0).unwrap();
        fs::write(dir.0.join("manifest.json"), foreign).unwrap();
        let d = run(&fresh, &Reported::default(), |_| panic!("computed")).err().unwrap();
        assert_eq!(d.code, "store.foreign", "{foreign}");
        assert_eq!(fs::read_to_string(dir.0.join("manifest.json")).unwrap(), foreign);
    }
    // one of an older layout is the program's own
    fs::write(dir.0.join("manifest.json"), "{ \"format\": 1, \"laval\": \"0.0.9\" }").unwrap();
    drop(run(&fresh, &Reported::default(), |_| {}).unwrap());
    drop(run(&fresh, &Reported::default(), |_| {}).unwrap());
}

#[test]
fn a_folder_in_use_is_refused_until_its_process_has_ended() {
    let dir = Dir::new("lock");
    let first = run(&dir.keep(), &Reported::default(), |_| {}).unwrap();
    let d = run(&dir.keep(), &Reported::default(), |_| {}).err().unwrap();
    assert_eq!(d.code, "folder.locked");
    assert!(d.message.contains(&format!("(number {})", std::process::id())), "{}", d.message);
    drop(first);
    // what a killed process leaves: its number in the file, and no lock
    fs::write(dir.0.join(".lock"), "4194304").unwrap();
    drop(run(&dir.keep(), &Reported::default(), |_| panic!("computed")).unwrap());
    assert_eq!(fs::read(dir.0.join(".lock")).unwrap(), b"");
}

#[test]
fn cancelled_drops_the_chunk_at_hand_and_goes_on_from_there() {
    let dir = Dir::new("cancel");
    let stop = Cancel::default();
    let keep = dir.keep();
    let context = Context { cancel: &stop, keep: Some(&keep), ..Context::quiet("s") };
    let results = store::run(plan(), &context, |range, _| {
        stop.store(range.start == 3 * CHUNK, Ordering::Relaxed);
        Ok((range.start < 3 * CHUNK).then(|| rows(range)))
    });
    let results = results.unwrap();
    assert_eq!((results.end(), results.done(), results.complete()), (End::Cancelled, 60, false));
    let remark = results.remark().unwrap();
    assert_eq!(remark.sentence(), "Only 60 of 1030 rows were computed. The same command continues from there.");
    assert_eq!(results.numbers("steps").unwrap().len(), 60);
    drop(results);
    let mut computed = Vec::new();
    drop(run(&keep, &Reported::default(), |c| computed.push(c)).unwrap());
    assert_eq!(computed.first(), Some(&3));
    assert!(files(&dir.0) == undisturbed());
}

#[test]
fn a_limit_ends_the_run_after_a_whole_chunk() {
    let keep = Dir::new("limit");
    let keep_in = keep.keep();
    let context = Context { work_limit: 50, keep: Some(&keep_in), ..Context::quiet("s") };
    let results = store::run(plan(), &context, |r, _| Ok(Some(rows(r)))).unwrap();
    assert_eq!((results.end(), results.done()), (End::MaxPoints, 60));
}

#[test]
fn without_a_folder_rows_stay_in_memory() {
    let results = store::run(plan(), &Context::quiet("s"), |r, _| Ok(Some(rows(r)))).unwrap();
    assert_same_rows(&results);
}

#[test]
fn an_error_of_the_computation_keeps_what_was_written() {
    let dir = Dir::new("error");
    let keep = dir.keep();
    let context = Context { keep: Some(&keep), ..Context::quiet("s") };
    let fail = |r: Range<usize>| if r.start < 40 { Ok(Some(rows(r))) } else { Err(Diagnostic::error("x", laval::text!("no"))) };
    assert_eq!(store::run(plan(), &context, |r, _| fail(r)).err().unwrap().code, "x");
    let wrong = store::run(plan(), &context, |_, _| Ok(Some(vec![Cells::Float(vec![1.0])]))).err().unwrap();
    assert_eq!(wrong.code, "store.columns");
    let mut computed = Vec::new();
    drop(run(&keep, &Reported::default(), |c| computed.push(c)).unwrap());
    assert_eq!(computed.first(), Some(&2));
    assert!(files(&dir.0) == undisturbed());
}

#[test]
fn folders_that_cannot_be_made_or_written_are_reported() {
    let dir = Dir::new("unwritable");
    fs::create_dir_all(&dir.0).unwrap();
    fs::write(dir.0.join("file"), "").unwrap();
    for folder in [dir.0.join("file"), dir.0.join("file/below")] {
        let keep = Keep { folder: folder.clone(), ..dir.keep() };
        let d = run(&keep, &Reported::default(), |_| panic!("computed")).err().unwrap();
        assert_eq!(d.code, "folder.make");
        assert!(d.message.contains(&folder.display().to_string()) && d.help.unwrap().contains("--out"), "{}", d.message);
    }
    // folders in place of files: nobody, not even root, may write them
    for name in [".lock", "manifest.json", "chunk-000000.parquet"] {
        let keep = Keep { folder: dir.0.join(format!("with-{name}")), ..dir.keep() };
        fs::create_dir_all(keep.folder.join(name)).unwrap();
        let d = run(&keep, &Reported::default(), |_| panic!("computed")).err().unwrap();
        assert!(d.message.contains(name), "{}", d.message);
    }
}

/// A folder in place of a file cannot be replaced: the write fails there, as on a full disk.
#[test]
fn a_disk_that_fails_keeps_what_was_written() {
    let dir = Dir::new("full");
    let blocked = dir.0.join("chunk-000004.parquet");
    let computed = |chunk| {
        if chunk == 4 {
            fs::create_dir(&blocked).unwrap();
        }
    };
    let d = run(&dir.keep(), &Reported::default(), computed).err().unwrap();
    assert_eq!(d.code, "store.write");
    assert!(d.message.contains("chunk-000004.parquet"), "{}", d.message);
    assert!(d.message.contains("4 of 52 chunks are complete and kept"), "{}", d.message);
    assert!(d.help.unwrap().contains("run the same command"));
    fs::remove_dir(&blocked).unwrap();
    assert!(files(&dir.0).keys().all(|name| !name.ends_with(".part")));
    let mut computed = Vec::new();
    drop(run(&dir.keep(), &Reported::default(), |c| computed.push(c)).unwrap());
    assert_eq!(computed.first(), Some(&4));
    assert!(files(&dir.0) == undisturbed());
}

/// Pieces in any order, one of them killed before its last chunks, leave what one run leaves.
#[test]
fn pieces_leave_the_files_of_one_run() {
    let dir = Dir::new("pieces");
    let piece = |number: usize, of: usize, most: u64| {
        let keep = Keep { work: Work::Piece(Piece::new(number, of).unwrap()), ..dir.keep() };
        let context = Context { keep: Some(&keep), work_limit: most, ..Context::quiet("s") };
        let mut computed = Vec::new();
        let end = store::run(plan(), &context, |range, _| {
            computed.push(range.start / CHUNK);
            Ok(Some(rows(range)))
        });
        assert_eq!(end.err().unwrap().code, NO_RESULT);
        computed
    };
    let collect = || run(&Keep { work: Work::Collect, ..dir.keep() }, &Reported::default(), |_| panic!("computed"));
    assert_eq!(piece(3, 4, u64::MAX), (2..52).step_by(4).collect::<Vec<_>>());
    assert_eq!(piece(3, 4, u64::MAX), [0; 0]);
    assert_eq!(piece(1, 4, 300), [0, 4, 8, 12]);
    assert!(!dir.0.join("manifest.json").exists());
    let d = collect().err().unwrap();
    assert_eq!(d.code, store::MISSING);
    // 17 chunks of the first three in four are there, the last of all chunks is shorter
    assert!(d.message.starts_with("690 of 1030 rows are missing, those of the chunks 2, 4, 6, 8, 10, 12, ... of 52"), "{}", d.message);
    // the rest in another division
    let rest: Vec<usize> = [2, 1].into_iter().flat_map(|k| piece(k, 2, u64::MAX)).collect();
    assert_eq!(rest.len(), 52 - 17);
    let results = collect().unwrap();
    assert_same_rows(&results);
    drop(results);
    assert!(files(&dir.0) == undisturbed());
}

/// A run needs the folder for itself; pieces share it.
#[test]
fn pieces_share_a_folder_that_a_run_does_not() {
    let dir = Dir::new("shared");
    let keep = |k| Keep { work: Work::Piece(Piece::new(k, 2).unwrap()), ..dir.keep() };
    let whole = run(&dir.keep(), &Reported::default(), |_| {}).unwrap();
    assert_eq!(run(&keep(1), &Reported::default(), |_| {}).err().unwrap().code, "folder.locked");
    drop(whole);
    fs::remove_dir_all(&dir.0).unwrap();
    let inner = run(&keep(1), &Reported::default(), |chunk| {
        if chunk == 2 {
            assert_eq!(run(&keep(2), &Reported::default(), |_| {}).err().unwrap().code, NO_RESULT);
            assert_eq!(run(&dir.keep(), &Reported::default(), |_| {}).err().unwrap().code, "folder.locked");
        }
    });
    assert_eq!(inner.err().unwrap().code, NO_RESULT);
    drop(run(&dir.keep(), &Reported::default(), |_| panic!("computed")).unwrap());
    assert!(files(&dir.0) == undisturbed());
}
