//! `laval plan` and `laval run --part`: long studies divided among processes.

use crate::input::{self, Input};
use crate::progress::Bar;
use crate::run::{self, CANCEL, Request};
use crate::{DONE, FAILED, STOPPED, WRONG, guarded, language, terminal};
use laval::build;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{Loaded, NamedStudy};
use laval::hash::sha256;
use laval::plain;
use laval::report;
use laval::run::keep;
use laval::store::{Keep, NO_RESULT, Piece, Plan, Work};
use laval::study::{Context, Progress};
use laval::text;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::Path;
use std::sync::atomic::Ordering;
use std::sync::{Mutex, PoisonError};

/// What may be said to `plan`.
#[derive(clap::Args)]
pub struct PlanArgs {
    #[command(flatten)]
    request: Request,
    /// Print the plan as JSON: for each long study its rows, chunks and input
    #[arg(long)]
    json: bool,
}

/// Remembers what a study is going to compute.
#[derive(Default)]
struct Planned(Mutex<Option<(Plan, bool)>>);

impl Progress for Planned {
    fn report(&self, _: u64, _: u64) {}
    fn planned(&self, plan: &Plan, chained: bool) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some((plan.clone(), chained));
    }
}

/// A long study as planned.
struct Long<'a> {
    study: &'a NamedStudy,
    keep: Keep,
    plan: Plan,
    chained: bool,
}

/// Whether a study divides, and how.
enum Divided<'a> {
    /// It is short.
    Not,
    Long(Long<'a>),
    Refused(Diagnostic),
    /// It has no rows.
    Nothing,
    /// A fault of the program, which has been reported.
    Failed,
}

fn divided<'a>(study: &'a NamedStudy, loaded: &Loaded, dir: &Path) -> Divided<'a> {
    let Some(keep) = keep(loaded, dir, &study.name, Work::Plan).filter(|_| study.study.in_chunks()) else {
        return Divided::Not;
    };
    let planned = Planned::default();
    let context = Context { name: &study.name, cancel: &CANCEL, progress: &planned, work_limit: u64::MAX, keep: Some(&keep) };
    match guarded(|| study.study.run(&loaded.system, &context)) {
        None => return Divided::Failed,
        Some(Err(d)) if d.code != NO_RESULT => return Divided::Refused(d),
        Some(_) => {}
    }
    match planned.0.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some((plan, chained)) => Divided::Long(Long { study, keep, plan, chained }),
        None => Divided::Nothing,
    }
}

/// Says how the long studies of a file divide.
pub fn plan(args: &PlanArgs) -> u8 {
    let (input, loaded) = match run::prepare_studies(&args.request) {
        Ok(read) => read,
        Err(code) => return code,
    };
    run::listen();
    let dir = args.request.dir(&input);
    let (mut long, mut short, mut code) = (Vec::new(), Vec::new(), DONE);
    for study in &loaded.studies {
        match divided(study, &loaded, &dir) {
            Divided::Not => short.push(plain::line(&study.name).into_owned()),
            Divided::Long(l) => long.push(l),
            Divided::Refused(d) => {
                input.complain(&Diagnostics(vec![d]));
                code = WRONG;
            }
            Divided::Nothing => {}
            Divided::Failed => return FAILED,
        }
        if CANCEL.load(Ordering::Relaxed) {
            return STOPPED;
        }
    }
    let text = if args.json { format!("{:#}\n", as_json(&input, &long)) } else { as_text(&args.request, &long, &short) };
    terminal::print(&text);
    code
}

fn as_json(input: &Input, long: &[Long]) -> Value {
    let one = |l: &Long| {
        json!({
            "name": l.study.name,
            "kind": l.study.study.kind(),
            "folder": l.keep.folder,
            "rows": l.plan.rows,
            "rows_of_a_chunk": l.plan.chunk,
            "chunks": l.plan.chunks(),
            "parts_at_most": parts(l),
            "input": l.keep.input,
        })
    };
    json!({
        "laval": env!("CARGO_PKG_VERSION"),
        "build": build::ID,
        "processor": build::processor(),
        "input_hash": format!("sha256:{}", sha256(&input.bytes)),
        "studies": long.iter().map(one).collect::<Vec<_>>(),
    })
}

/// Parts that have anything to do.
fn parts(l: &Long) -> usize {
    if l.chained { 1 } else { l.plan.chunks() }
}

fn as_text(request: &Request, long: &[Long], short: &[String]) -> String {
    let mut s = String::new();
    let file = plain::line(&request.file.to_string_lossy()).into_owned();
    if long.is_empty() {
        let _ = writeln!(s, "No study of {file} divides into parts; laval run computes all of them.");
        return s;
    }
    let name = |l: &Long| plain::line(&l.study.name).into_owned();
    let column = long.iter().map(|l| name(l).chars().count()).max().unwrap_or(0).max(5);
    let _ = writeln!(s, "{:column$}  {:>10}  {:>15}  {:>13}", "study", "rows", "rows of a chunk", "parts at most");
    for l in long {
        let _ = writeln!(s, "{:column$}  {:>10}  {:>15}  {:>13}", name(l), l.plan.rows, l.plan.chunk, parts(l));
    }
    if long.iter().any(|l| l.chained) {
        s.push_str("\nRows of a study with one part follow from the rows before; part 1 computes it.\n");
    }
    let _ = writeln!(s, "\nlaval run {file} --part I/N   computes part I of N; parts may run anywhere, in any order, more than once");
    let _ = writeln!(
        s,
        "laval collect {file}         joins them{}",
        match short {
            [] => String::new(),
            names => format!(" and computes {}", names.join(", ")),
        }
    );
    s
}

/// Into how many parts a file divides at most.
enum Most {
    /// It has no long studies.
    None,
    Parts(usize),
    /// A study could not be planned, or the user has stopped it.
    Unknown,
    /// A fault of the program, which has been reported.
    Failed,
}

fn most(loaded: &Loaded, dir: &Path) -> Most {
    let mut most = Most::None;
    for study in loaded.studies.iter().filter(|s| s.study.in_chunks()) {
        most = match (divided(study, loaded, dir), most) {
            (Divided::Failed, _) => return Most::Failed,
            (Divided::Refused(_), _) => return Most::Unknown,
            (Divided::Long(l), Most::Parts(n)) => Most::Parts(n.max(parts(&l))),
            (Divided::Long(l), _) => Most::Parts(parts(&l)),
            (Divided::Not | Divided::Nothing, most) => most,
        };
        if CANCEL.load(Ordering::Relaxed) {
            return Most::Unknown;
        }
    }
    most
}

/// Computes one part of the long studies.
pub fn compute(request: &Request, input: &Input, loaded: &Loaded, piece: Piece) -> u8 {
    run::listen();
    let dir = request.dir(input);
    // shared with other parts; a run and a collection need the folder for themselves
    let _held = match report::share(&dir) {
        Ok(held) => held,
        Err(d) => {
            input::complain(&d);
            return WRONG;
        }
    };
    match most(loaded, &dir) {
        Most::None => {
            let d = Diagnostic::error(
                "part.none",
                text!("no study of {file} divides into parts", file = plain::line(&request.file.to_string_lossy())),
            );
            input::complain(&d.help(text!("leave out --part: laval run computes all of them")));
            return WRONG;
        }
        Most::Parts(most) if piece.of() > most => {
            let message = text!(
                "{of} parts are requested, and no study of {file} divides into more than {most}",
                of = piece.of(),
                most,
                file = plain::line(&request.file.to_string_lossy())
            );
            let help =
                text!("number the parts from 1/{most} to {most}/{most}, or take fewer; laval plan says how each study divides", most);
            input::complain(&Diagnostic::error("part.many", message).help(help));
            return WRONG;
        }
        // a study that cannot be planned is refused where it is computed
        Most::Parts(_) | Most::Unknown => {}
        Most::Failed => return FAILED,
    }
    let mut code = DONE;
    for study in loaded.studies.iter().filter(|s| s.study.in_chunks()) {
        if CANCEL.load(Ordering::Relaxed) {
            break;
        }
        let keep = keep(loaded, &dir, &study.name, Work::Piece(piece));
        let bar = Bar::new(&study.name, request.quiet);
        let context = Context { name: &study.name, cancel: &CANCEL, progress: &bar, work_limit: u64::MAX, keep: keep.as_ref() };
        let result = guarded(|| study.study.run(&loaded.system, &context));
        bar.finish();
        match result {
            Some(Err(d)) if d.code == NO_RESULT => {
                if !request.quiet {
                    terminal::print(&format!("{}: {}\n", plain::line(&study.name), language::said(&d.message)));
                }
            }
            Some(Err(mut d)) => {
                d.span = d.span.or_else(|| loaded.spec.study(&study.name).and_then(|b| b.span.clone()));
                d.message = text!("study \"{name}\": {message}", name = study.name, message = d.message);
                input.complain(&Diagnostics(vec![d]));
                code = code.max(WRONG);
            }
            // it ended before its first row; the collection says why
            Some(Ok(_)) => {}
            None => code = FAILED,
        }
    }
    if code != FAILED && CANCEL.load(Ordering::Relaxed) { STOPPED } else { code }
}
