//! Bad input: whatever a machine file holds, it ends with a diagnostic or a result, never with a panic, a hang or a NaN reported as a number.
//!
//! 10 000 files go through what `laval check` does (parse, assemble, one residual of every part), and 150 of the valid ones through their
//! studies and the writers under a work limit counted in steps. `LAVAL_FUZZ=1` is the long form: ten times as many, and every kind of study
//! must reach its end; `LAVAL_FUZZ=10` ten times that. `LAVAL_FUZZ_CASE=123` runs one and prints it.

mod generate;
mod sound;
mod words;

use generate::{Random, Sources};
use laval::diagnostic::Diagnostics;
use laval::file::{self, Form, Loaded};
use laval::study::{Cancel, Context, Progress};
use std::collections::BTreeMap;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

const CHECKED: u64 = 100_000;
const STUDIED: u64 = 1500;
/// A case that takes longer than this hangs; usual ones take milliseconds.
const HANGS_AFTER: Duration = Duration::from_secs(120);
/// Most kinds of failures printed.
const SHOWN: usize = 20;

/// The factor of the long form, where it is wanted.
fn long() -> Option<u64> {
    std::env::var("LAVAL_FUZZ").ok().and_then(|s| s.parse().ok())
}

/// As many of this number as are wanted: a tenth in the short form.
fn many(number: u64) -> u64 {
    long().map_or(number / 10, |factor| number * factor)
}

fn lock<T>(m: &Mutex<T>) -> MutexGuard<'_, T> {
    m.lock().unwrap_or_else(PoisonError::into_inner)
}

static LAST_PANIC: Mutex<String> = Mutex::new(String::new());

/// What is wrong with how this case ended, if anything.
fn guarded<T>(work: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(result) => result,
        Err(_) => Err(format!("panic: {}", lock(&LAST_PANIC))),
    }
}

/// `laval check`: read, assemble, one residual of every part; the diagnostics as they are printed.
fn check(bytes: &[u8], shown: bool) -> Result<Option<Loaded>, String> {
    let result = file::load_bytes(bytes);
    let (diagnostics, refused) = match &result {
        Ok(l) => (&l.warnings, false),
        Err(d) => (d, true),
    };
    if refused != diagnostics.has_errors() {
        return Err("refused without an error, or accepted with one".into());
    }
    places(diagnostics, bytes.len())?;
    if shown {
        let text = String::from_utf8_lossy(bytes);
        let words = file::render(diagnostics, &text, "machine.toml", Form::Lines);
        file::render(diagnostics, &text, "machine.toml", Form::Excerpts { width: 100, colour: false });
        file::diagnostics_json(diagnostics, &text);
        if refused && words.trim().is_empty() {
            return Err("refused without a word".into());
        }
    }
    if shown && let Ok(l) = &result {
        let catalog = file::catalog();
        let written = file::write(&l.spec, catalog);
        let (back, d) = file::read(&written, catalog);
        if back.is_none_or(|b| b.without_spans() != l.spec.clone().without_spans()) {
            return Err(format!("written and read again it is another machine: {d:?}\n{written}"));
        }
        if let Err(d) = file::load(&written) {
            return Err(format!("written and read again it is refused: {d:?}\n{written}"));
        }
    }
    if let Ok(l) = &result {
        for (slot, value) in l.system.param_slots().iter().zip(l.system.params()) {
            if !value.is_finite() {
                return Err(format!("parameter {} is {value}", slot.name));
            }
        }
    }
    Ok(result.ok())
}

fn places(d: &Diagnostics, length: usize) -> Result<(), String> {
    // text that is not UTF-8 is marked where it stands in its printed form, which may be longer
    match d.0.iter().find(|d| d.message.to_string().is_empty() || d.span.as_ref().is_some_and(|s| s.start > s.end || s.end > 3 * length)) {
        Some(bad) => Err(format!("a diagnostic without words or with a wrong place: {bad:?}")),
        None => Ok(()),
    }
}

/// Sets the flag of cancellation after some reports of progress.
struct CancelAfter<'a> {
    left: AtomicU64,
    cancel: &'a AtomicBool,
}

impl Progress for CancelAfter<'_> {
    fn report(&self, _: u64, _: u64) {
        if self.left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |n| n.checked_sub(1)).is_err() {
            self.cancel.store(true, Ordering::Relaxed);
        }
    }
}

/// Runs the studies of a file; what they give is sound and can be written.
fn study(bytes: &[u8], number: u64) -> Result<Vec<String>, String> {
    let Some(loaded) = check(bytes, false)? else { return Ok(vec![]) };
    let mut r = Random::new(number ^ 0xABCD);
    let mut ends = Vec::new();
    for named in &loaded.studies {
        let cancel = Cancel::default();
        let unit = match named.study.kind() {
            // steps in time, of which one settled motion takes hundreds
            "sweep" | "basins" | "motion_map" => 100,
            // starts and points, of which one search takes hundreds
            "stationary" => 40,
            // runs of another study, of which one search takes at least twenty
            "optimum" => 10,
            // points along branches, of which one response takes tens
            "response_map" => 2,
            _ => 1,
        };
        let work_limit = unit * [1, 2, 7, 60, 300][r.below(5)];
        let left = if r.below(8) == 0 { r.below(20) as u64 } else { u64::MAX };
        let progress = CancelAfter { left: AtomicU64::new(left), cancel: &cancel };
        let context = Context { name: &named.name, cancel: &cancel, progress: &progress, work_limit, keep: None };
        let what = |e: String| format!("study {} under the limit {work_limit}: {e}", named.study.kind());
        match guarded(|| Ok(named.study.run(&loaded.system, &context))).map_err(what)? {
            Ok(outcome) => {
                sound::check(&outcome).map_err(what)?;
                sound::within(&outcome, work_limit).map_err(what)?;
                ends.push(format!("{} {}", named.study.kind(), outcome.end.word()));
                guarded(|| sound::written(outcome)).map_err(what)?;
            }
            Err(d) if d.message.to_string().is_empty() => return Err(what("refused without a word".into())),
            Err(d) => {
                sound::words(&d.to_string()).map_err(what)?;
                ends.push(format!("{} refused ({})", named.study.kind(), d.code));
            }
        }
    }
    Ok(ends)
}

/// Runs every case on all processors; prints those that fail, made shorter, and those that hang.
fn all<T: Send>(what: &str, cases: &[u64], sources: &Sources, one: impl Fn(&[u8], u64) -> Result<T, String> + Sync) -> Vec<(u64, T)> {
    let threads = std::thread::available_parallelism().map_or(2, |n| n.get());
    let next = AtomicUsize::new(0);
    let running: Vec<Mutex<Option<(u64, Instant)>>> = (0..threads).map(|_| Mutex::new(None)).collect();
    let (done, failed, busy) = (Mutex::new(Vec::with_capacity(cases.len())), Mutex::new(Vec::new()), AtomicUsize::new(threads));
    std::thread::scope(|scope| {
        for slot in &running {
            let (next, done, failed, busy, one) = (&next, &done, &failed, &busy, &one);
            scope.spawn(move || {
                let mut own = Vec::new();
                while let Some(&case) = cases.get(next.fetch_add(1, Ordering::Relaxed)) {
                    *lock(slot) = Some((case, Instant::now()));
                    match guarded(|| one(&sources.case(case), case)) {
                        Ok(x) => own.push((case, x)),
                        Err(e) => lock(failed).push((case, e)),
                    }
                    *lock(slot) = None;
                }
                lock(done).append(&mut own);
                busy.fetch_sub(1, Ordering::Relaxed);
            });
        }
        // a hang cannot be unwound: say which case it is and end the program
        while busy.load(Ordering::Relaxed) > 0 {
            std::thread::sleep(Duration::from_millis(20));
            for slot in &running {
                if let Some((case, since)) = *lock(slot)
                    && since.elapsed() > HANGS_AFTER
                {
                    let text = format!("{what}: case {case} hangs\n----\n{}\n----\n", String::from_utf8_lossy(&sources.case(case)));
                    // past the test harness, which keeps what it captures until the end
                    let _ = std::io::stderr().write_all(text.as_bytes());
                    std::process::exit(101);
                }
            }
        }
    });
    let mut failed = failed.into_inner().unwrap_or_else(PoisonError::into_inner);
    failed.sort_by_key(|f| f.0);
    // one of each kind
    let mut kinds: BTreeMap<String, (usize, &(u64, String))> = BTreeMap::new();
    for f in &failed {
        kinds.entry(head(&f.1)).or_insert((0, f)).0 += 1;
    }
    for (count, (case, why)) in kinds.values().take(SHOWN) {
        eprintln!("{what}: {count} like case {case}: {why}");
        let short = shorter(sources.case(*case), why, |b| guarded(|| one(b, *case)).err());
        eprintln!("made shorter:\n----\n{}\n----", String::from_utf8_lossy(&short));
    }
    assert!(failed.is_empty(), "{what}: {} of {} cases failed", failed.len(), cases.len());
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_by_key(|d| d.0);
    done
}

/// What two failures of one kind have in common.
fn head(why: &str) -> String {
    why.split(": ").skip(1).collect::<Vec<_>>().join(": ").chars().filter(|c| !c.is_ascii_digit()).take(60).collect()
}

/// Leaves out lines as long as the same thing goes wrong.
fn shorter(bytes: Vec<u8>, why: &str, fails: impl Fn(&[u8]) -> Option<String>) -> Vec<u8> {
    let mut lines: Vec<Vec<u8>> = bytes.split(|&b| b == b'\n').map(<[u8]>::to_vec).collect();
    for width in [8, 3, 1] {
        let mut at = 0;
        while at < lines.len() {
            let mut fewer = lines.clone();
            fewer.drain(at..(at + width).min(lines.len()));
            if fails(&fewer.join(&b'\n')).is_some_and(|e| head(&e) == head(why)) {
                lines = fewer;
            } else {
                at += 1;
            }
        }
    }
    lines.join(&b'\n')
}

fn quiet_panics() {
    std::panic::set_hook(Box::new(|info| {
        let text =
            info.payload().downcast_ref::<String>().cloned().or_else(|| info.payload().downcast_ref::<&str>().map(|s| s.to_string()));
        let place = info.location().map(ToString::to_string).unwrap_or_default();
        *lock(&LAST_PANIC) = format!("{} at {place}", text.unwrap_or_default());
        // failures of the test itself are seen
        if place.contains("tests/fuzz") {
            eprintln!("{}", lock(&LAST_PANIC));
        }
    }));
}

#[test]
fn no_file_makes_the_program_fall_over() {
    quiet_panics();
    let sources = Sources::new(file::catalog());
    if let Some(case) = std::env::var("LAVAL_FUZZ_CASE").ok().and_then(|s| s.parse().ok()) {
        let bytes = sources.case(case);
        println!("{}\n----\n{:?}\n{:?}", String::from_utf8_lossy(&bytes), check(&bytes, true).map(|l| l.is_some()), study(&bytes, case));
        return;
    }
    let cases: Vec<u64> = (0..many(CHECKED)).collect();
    let checked = all("check", &cases, &sources, |bytes, number| {
        Ok(check(bytes, number % 8 < 2)?.map(|l| l.studies.iter().map(|s| s.study.kind()).collect::<Vec<_>>()))
    });
    let valid: Vec<(u64, Vec<&str>)> = checked.into_iter().filter_map(|(case, kinds)| Some((case, kinds?))).collect();
    // both ways are walked
    let share = valid.len() as f64 / cases.len() as f64;
    let walked = if long().is_some() { 0.05..0.6 } else { f64::MIN_POSITIVE..1.0 };
    assert!(walked.contains(&share), "{share} of the files are valid");

    // the small files hold every kind of part and of study, and all but their extras are valid
    let of_seeds = sources.files().iter().filter(|f| file::load(f).is_ok()).count();
    assert!(of_seeds * 3 > sources.files().len(), "{of_seeds} of {}", sources.files().len());

    // as many of each kind of study, most of them composed of the registries: they differ most
    let wanted = many(STUDIED) as usize;
    let mut chosen: Vec<u64> = Vec::new();
    let kinds: Vec<&str> = file::catalog().studies.iter().map(|k| k.kind).collect();
    for kind in &kinds {
        let own = valid.iter().filter(|v| v.1.contains(kind)).map(|v| v.0);
        let (composed, edited): (Vec<u64>, Vec<u64>) = own.partition(|case| case % 10 >= 5 || case % 30 == 1);
        let share = wanted.div_ceil(kinds.len());
        let few = edited.into_iter().take(share / 4);
        chosen.extend(few.chain(composed).take(share));
    }
    chosen.sort_unstable();
    chosen.dedup();
    assert!(chosen.len() * 10 > wanted * 7, "only {} valid files have studies", chosen.len());
    let mut more = valid
        .iter()
        .filter(|v| !v.1.is_empty())
        .map(|v| v.0)
        .filter(|c| chosen.binary_search(c).is_err())
        .take(wanted - chosen.len().min(wanted))
        .collect();
    chosen.append(&mut more);
    let ended = all("studies", &chosen, &sources, study);
    let mut count: BTreeMap<String, usize> = BTreeMap::new();
    ended.into_iter().flat_map(|e| e.1).for_each(|end| *count.entry(end).or_default() += 1);
    println!("{:.1} % of the files are valid; {} of them were studied: {count:#?}", 100.0 * share, chosen.len());
    // every kind of study gave results
    for kind in kinds.iter().filter(|_| long().is_some()) {
        assert!(count.contains_key(&format!("{kind} reached")), "{kind} never reached its end: {count:?}");
    }
}
