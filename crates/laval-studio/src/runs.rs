//! Long studies beside the page: with progress, pause, resume and cancel, and the same files as `laval run FILE --only STUDY`.
//!
//! A study whose rows are kept in chunks is paused by ending it: what it has is on the disk, and it goes on from there, here or with `laval run`. Others are held where they
//! report how far they are. Studies run on threads of their own, so that answers do not wait for them.

use crate::machines::Machines;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{Loaded, NamedStudy};
use laval::outcome::{End, Outcome};
use laval::report::{self, Format, Language, Report};
use laval::run;
use laval::store::Work;
use laval::study::{self, Cancel, Context, Progress, Silent};
use laval::text;
use serde::Deserialize;
use serde_json::{Value as Json, json};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};

/// `POST api/runs`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    text: String,
    study: String,
    /// The machine file in the folder, which names the folder of results.
    #[serde(default)]
    file: Option<String>,
}

/// Runs that are remembered.
const MOST: usize = 64;

/// State that the page requests of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wanted {
    Going,
    Paused,
    Ended,
}

#[derive(Clone, Debug, PartialEq)]
enum Ending {
    /// With its report.
    Done(Arc<str>),
    /// With the report of what was computed, if anything was.
    Cancelled(Option<Arc<str>>),
    Failed(Diagnostic),
}

struct Status {
    wanted: Wanted,
    /// It rests: nothing is computed.
    resting: bool,
    ending: Option<Ending>,
    done: u64,
    total: u64,
    cancel: Cancel,
}

/// One run of one study.
pub(crate) struct Run {
    id: String,
    study: String,
    chunks: bool,
    status: Mutex<Status>,
    changed: Condvar,
}

/// A run and its thread.
type Started = (Arc<Run>, Option<JoinHandle<()>>);

/// All runs of a server.
pub(crate) struct Runs {
    folder: PathBuf,
    file: Option<PathBuf>,
    next: AtomicU64,
    all: Mutex<Vec<Started>>,
    machines: Machines,
}

fn held<T>(lock: &Mutex<T>) -> MutexGuard<'_, T> {
    lock.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Runs {
    pub fn new(folder: PathBuf, file: Option<PathBuf>) -> Runs {
        Runs { folder, file, next: AtomicU64::new(1), all: Mutex::default(), machines: Machines::default() }
    }

    pub fn find(&self, id: &str) -> Option<Arc<Run>> {
        held(&self.all).iter().find(|r| r.0.id == id).map(|r| r.0.clone())
    }

    /// All that are remembered, the newest first.
    pub fn list(&self, language: Language) -> Json {
        let one = |r: &Started| {
            let mut run = r.0.progress(language);
            run["id"] = r.0.id.as_str().into();
            run["study"] = r.0.study.as_str().into();
            run
        };
        json!({ "runs": held(&self.all).iter().rev().map(one).collect::<Vec<_>>() })
    }

    /// Starts a study.
    pub fn begin(&self, request: &Request, language: Language) -> Result<Json, Diagnostics> {
        let loaded = self.machines.load(&request.text).map_err(|found| (*found).clone())?;
        let one = |d| Diagnostics(vec![d]);
        let chosen = loaded.chosen(std::slice::from_ref(&request.study)).map_err(one)?;
        let study = chosen.first().and_then(|&k| loaded.studies.get(k)).map(|s| (s.name.clone(), s.study.in_chunks()));
        let Some((study, chunks)) = study else { return Err(one(Diagnostic::error("studio.run", text!("the machine has no such study")))) };
        let file = match &request.file {
            Some(name) if !name.is_empty() => crate::folder::path(&self.folder, name).map_err(one)?,
            _ => self.file.clone().unwrap_or_else(|| self.folder.join(format!("{}.toml", loaded.system.machine.name))),
        };
        let status = Status { wanted: Wanted::Going, resting: false, ending: None, done: 0, total: 0, cancel: Cancel::default() };
        let id = self.next.fetch_add(1, Ordering::Relaxed).to_string();
        let run = Arc::new(Run { id: id.clone(), study: study.clone(), chunks, status: Mutex::new(status), changed: Condvar::new() });
        let inside = file.strip_prefix(&self.folder).unwrap_or(&file).to_path_buf();
        let job = Job {
            dir: self.folder.join("out").join(run::stem(&file)),
            name: run::name(&inside),
            text: request.text.clone(),
            loaded,
            study,
            language,
            run: run.clone(),
        };
        let thread = thread::Builder::new().spawn(move || job.work());
        let thread =
            thread.map_err(|e| one(Diagnostic::error("studio.run", text!("the study cannot be started: {e}", e = e.to_string()))))?;
        let mut all = held(&self.all);
        if all.len() >= MOST
            && let Some(at) = all.iter().position(|r| r.0.over())
        {
            all.remove(at);
        }
        all.push((run, Some(thread)));
        Ok(json!({ "id": id }))
    }

    /// Ends all of them.
    pub fn stop(&self) {
        held(&self.all).iter().for_each(|r| r.0.cancel());
    }

    /// Waits until all have ended.
    pub fn finish(&self) {
        self.stop();
        let threads: Vec<_> = held(&self.all).iter_mut().filter_map(|r| r.1.take()).collect();
        threads.into_iter().for_each(|t| drop(t.join()));
    }
}

impl Run {
    fn over(&self) -> bool {
        held(&self.status).ending.is_some()
    }

    fn want(&self, wanted: Wanted) {
        let mut s = held(&self.status);
        if s.ending.is_some() || s.wanted == Wanted::Ended {
            return;
        }
        s.wanted = wanted;
        if wanted == Wanted::Ended || wanted == Wanted::Paused && self.chunks {
            s.cancel.store(true, Ordering::Relaxed);
        }
        drop(s);
        self.changed.notify_all();
    }

    pub fn pause(&self) {
        self.want(Wanted::Paused);
    }

    pub fn resume(&self) {
        self.want(Wanted::Going);
    }

    pub fn cancel(&self) {
        self.want(Wanted::Ended);
    }

    /// How far it is.
    fn progress(&self, language: Language) -> Json {
        let s = held(&self.status);
        let state = match (&s.ending, s.wanted) {
            (Some(Ending::Done(_)), _) => "done",
            (Some(Ending::Cancelled(_)), _) => "cancelled",
            (Some(Ending::Failed(_)), _) => "failed",
            (None, Wanted::Paused) if s.resting => "paused",
            (None, _) => "running",
        };
        let mut out = json!({ "state": state, "done": s.done, "total": s.total });
        if let Some(Ending::Failed(d)) = &s.ending {
            out["error"] = language.said(&d.sentence()).into();
        }
        if matches!(s.ending, Some(Ending::Done(_) | Ending::Cancelled(Some(_)))) {
            out["report"] = true.into();
        }
        out
    }

    /// The report, when it is over.
    pub fn page(&self) -> Option<String> {
        match &held(&self.status).ending {
            Some(Ending::Done(page) | Ending::Cancelled(Some(page))) => Some(page.to_string()),
            _ => None,
        }
    }

    /// Waits while a pause is wanted.
    fn rest(&self) {
        let mut s = held(&self.status);
        while s.wanted == Wanted::Paused {
            s.resting = true;
            s = self.changed.wait(s).unwrap_or_else(PoisonError::into_inner);
        }
        s.resting = false;
    }

    /// A stop for the computation that begins; requested already where the run shall end.
    fn begin(&self) -> Cancel {
        let mut s = held(&self.status);
        s.cancel = Cancel::new(s.wanted == Wanted::Ended);
        s.cancel.clone()
    }

    fn wanted(&self) -> Wanted {
        held(&self.status).wanted
    }
}

impl Progress for Run {
    fn report(&self, done: u64, total: u64) {
        {
            let mut s = held(&self.status);
            // how far it was when it was cancelled stays
            if s.wanted == Wanted::Ended {
                return;
            }
            // threads report out of order
            s.done = if total == s.total { s.done.max(done) } else { done };
            s.total = total;
        }
        if !self.chunks {
            self.rest();
        }
    }
}

/// A run at work.
struct Job {
    dir: PathBuf,
    name: String,
    text: String,
    loaded: Arc<Loaded>,
    study: String,
    language: Language,
    run: Arc<Run>,
}

impl Job {
    fn work(self) {
        let ending = catch_unwind(AssertUnwindSafe(|| self.ending()));
        let ending = ending.unwrap_or_else(|_| {
            Err(Diagnostic::error("studio.defect", text!("this is a defect of the program, not of your file: the computation failed")))
        });
        held(&self.run.status).ending = Some(ending.unwrap_or_else(Ending::Failed));
    }

    fn ending(&self) -> Result<Ending, Diagnostic> {
        let Some(study) = self.loaded.studies.iter().find(|s| s.name == self.study) else { return Ok(Ending::Cancelled(None)) };
        let threads = thread::available_parallelism().map_or(1, std::num::NonZeroUsize::get);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.map_err(|e| Diagnostic::error("studio.run", text!("the study cannot be started: {e}", e = e.to_string())))?;
        let names: Vec<&str> = self.loaded.spec.studies.iter().map(|b| b.name.as_str()).collect();
        loop {
            let cancel = self.run.begin();
            let folder = report::prepare(&self.dir, &names)?;
            let outcome = pool.install(|| self.compute(study, &cancel))?;
            let paused = self.run.chunks && outcome.end == End::Cancelled && self.run.wanted() != Wanted::Ended;
            if paused {
                // the folder is free for others meanwhile
                drop(folder);
                self.run.rest();
                continue;
            }
            let complete = outcome.end.is_complete();
            let page: Arc<str> = self.write(study, outcome, &cancel)?.into();
            drop(folder);
            // what was complete before the request to cancel it came is done
            return Ok(if complete || self.run.wanted() != Wanted::Ended { Ending::Done(page) } else { Ending::Cancelled(Some(page)) });
        }
    }

    fn compute(&self, study: &NamedStudy, cancel: &Cancel) -> Result<Outcome, Diagnostic> {
        let keep = run::keep(&self.loaded, &self.dir, &study.name, Work::Missing);
        let context = Context { name: &study.name, cancel, progress: &*self.run, work_limit: u64::MAX, keep: keep.as_ref() };
        study.study.prepare(&self.loaded.system, &context)?;
        study.study.run(&self.loaded.system, &context)
    }

    /// Writes what `laval run` writes.
    fn write(&self, study: &NamedStudy, outcome: Outcome, cancel: &Cancel) -> Result<String, Diagnostic> {
        let system = &self.loaded.system;
        let mut report: Report = run::begun(&self.name, (&self.text, self.text.as_bytes()), &self.loaded, Vec::new(), self.language);
        report.outcomes.push(outcome);
        if !cancel.load(Ordering::Relaxed) {
            let context = Context { name: "summary", cancel, progress: &Silent, work_limit: u64::MAX, keep: None };
            report.overview = Some(study::overview(system, &study.study.speeds(system), &report.outcomes, &context));
        }
        let wrong = |message| Diagnostic::error("studio.write", message);
        report::renew(&self.dir, &report, Format::ALL).map_err(|e| wrong(e.sentence()))?;
        report::html(&report).map_err(|e| wrong(text!("the report cannot be drawn: {e}", e = e.to_string())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_that_is_over_stays_so() {
        let status = Status { wanted: Wanted::Going, resting: false, ending: None, done: 0, total: 0, cancel: Cancel::default() };
        let run = Run { id: "1".into(), study: "sweep".into(), chunks: true, status: Mutex::new(status), changed: Condvar::new() };
        run.pause();
        assert!(held(&run.status).cancel.load(Ordering::Relaxed));
        run.resume();
        assert!(!run.begin().load(Ordering::Relaxed));
        run.report(3, 9);
        run.report(2, 9);
        assert_eq!(run.progress(Language::English), json!({ "state": "running", "done": 3, "total": 9 }));
        run.cancel();
        run.resume();
        assert_eq!(run.wanted(), Wanted::Ended);
        assert!(run.begin().load(Ordering::Relaxed));
        // what a study reports at its end does not say that all of it was done
        run.report(9, 9);
        assert_eq!(run.progress(Language::English)["done"], 3);
    }
}
