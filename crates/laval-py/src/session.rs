//! The studies of a machine, one after another, as `laval run` runs them.

use crate::attend::Watch;
use laval::diagnostic::Diagnostic;
use laval::file::{self, Loaded, NamedStudy};
use laval::outcome::{Arg, End, Finding, Outcome, Overview};
use laval::report;
use laval::store::{Keep, Work};
use laval::study::{self, Cancel, Context, Silent};
use laval::text;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// What is to be run.
pub struct Session<'a> {
    pub loaded: &'a Loaded,
    /// Numbers of the studies.
    pub chosen: &'a [usize],
    /// Where long studies keep their rows.
    pub folder: Option<PathBuf>,
    pub fresh: bool,
    pub work_limit: u64,
}

/// What came of it.
pub struct Ran {
    pub outcomes: Vec<Outcome>,
    /// Why studies were refused, each reason once.
    pub refusals: Vec<Diagnostic>,
    /// Studies without a result, by a defect of the library.
    pub defects: Vec<String>,
}

impl Session<'_> {
    /// Runs them; after a stop, what is done.
    pub fn run(&self, cancel: &Cancel, watch: &Watch) -> Ran {
        let mut ran = Ran { outcomes: Vec::new(), refusals: Vec::new(), defects: Vec::new() };
        watch.begin("preparing");
        let before = Context { name: "preparing", cancel, progress: watch, work_limit: u64::MAX, keep: None };
        let refusals = self.loaded.refusals_in(&before);
        for &i in self.chosen {
            let named = &self.loaded.studies[i];
            if cancel.load(Ordering::Relaxed) {
                ran.outcomes.push(Outcome::new(named.study.kind(), &named.name).end(End::Cancelled));
                continue;
            }
            match refusals.iter().find(|r| r.studies.contains(&i)) {
                // the reason names all studies and stands once
                Some(r) if ran.refusals.contains(&r.diagnostic) => {
                    let first = r.studies.iter().find(|k| self.chosen.contains(*k)).map_or("", |&k| self.loaded.studies[k].name.as_str());
                    ran.refused(named, Finding::info("refused_alike", "run-refused-alike").arg("study", Arg::name(first)));
                }
                Some(r) => ran.refuse(named, r.diagnostic.clone()),
                None => self.study(named, cancel, watch, &mut ran),
            }
        }
        ran
    }

    fn study(&self, named: &NamedStudy, cancel: &Cancel, watch: &Watch, ran: &mut Ran) {
        watch.begin(&named.name);
        let keep = self.keep(named);
        let context = Context { name: &named.name, cancel, progress: watch, work_limit: self.work_limit, keep: keep.as_ref() };
        match catch_unwind(AssertUnwindSafe(|| named.study.run(&self.loaded.system, &context))) {
            Ok(Ok(outcome)) => ran.outcomes.push(outcome),
            Ok(Err(mut d)) => {
                d.span = d.span.or_else(|| self.loaded.spec.study(&named.name).and_then(|b| b.span.clone()));
                d.message = text!("study \"{name}\": {message}", name = named.name, message = d.message);
                ran.refuse(named, d);
            }
            Err(_) => ran.defects.push(named.name.clone()),
        }
    }

    fn keep(&self, named: &NamedStudy) -> Option<Keep> {
        let folder = self.folder.as_ref()?;
        let names: Vec<&str> = self.loaded.spec.studies.iter().map(|b| b.name.as_str()).collect();
        let at = names.iter().position(|n| *n == named.name)?;
        let own = report::folders(names).swap_remove(at);
        Some(Keep {
            folder: folder.join(own),
            input: file::canonical(&self.loaded.spec, &named.name),
            fresh: self.fresh,
            work: Work::Missing,
        })
    }
}

impl Ran {
    /// A study that the machine cannot answer.
    fn refuse(&mut self, named: &NamedStudy, why: Diagnostic) {
        self.refused(named, Finding::warning("refused", "run-refused").arg("reason", Arg::term(why.to_string())));
        self.refusals.push(why);
    }

    fn refused(&mut self, named: &NamedStudy, why: Finding) {
        self.outcomes.push(Outcome::new(named.study.kind(), &named.name).end(End::Refused).finding(why));
    }
}

/// The first page of these outcomes.
pub fn overview(loaded: &Loaded, chosen: &[usize], outcomes: &[Outcome], cancel: &Cancel) -> Overview {
    let context = Context { name: "summary", cancel, progress: &Silent, work_limit: u64::MAX, keep: None };
    let speeds: Vec<_> = chosen.iter().flat_map(|&i| loaded.studies[i].study.speeds(&loaded.system)).collect();
    study::overview(&loaded.system, &speeds, outcomes, &context)
}
