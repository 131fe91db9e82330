//! `laval run`.

use crate::input::{self, Input};
use crate::pdf;
use crate::pieces;
use crate::progress::Bar;
use crate::{DONE, FAILED, STOPPED, WRONG, guarded, interrupt, language, terminal};
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{Loaded, NamedStudy, Refusal};
use laval::outcome::{Arg, End, Finding, Outcome};
use laval::plain;
use laval::report::{self, Format, Language, Report, WriteError};
use laval::run;
use laval::store::{Keep, Piece, Work};
use laval::study::{self, Cancel, Context, Silent};
use laval::text;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::sync::atomic::Ordering;
use std::thread::{self, ScopedJoinHandle};
use std::time::{Duration, Instant};

/// Which studies of which file, and where their results go.
#[derive(clap::Args)]
pub struct Request {
    /// The machine file
    pub file: PathBuf,
    /// The folder for results [default: out/NAME, NAME being that of the file, or of its folder for a machine.toml]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Run only this study (its name or its kind); may be given several times
    #[arg(long, value_name = "STUDY", value_delimiter = ',')]
    only: Vec<String>,
    /// Print nothing but what is wrong
    #[arg(long, short)]
    pub quiet: bool,
}

impl Request {
    /// The folder of results.
    pub fn dir(&self, input: &Input) -> PathBuf {
        self.out.clone().unwrap_or_else(|| Path::new("out").join(input.stem()))
    }
}

/// What is written and printed.
#[derive(clap::Args)]
pub struct Shown {
    /// What to write [default: all of csv, parquet, json, svg, html]
    #[arg(long, value_name = "FORMATS", value_delimiter = ',', value_parser = str::parse::<Format>)]
    format: Vec<Format>,
    /// Print all findings of every study, not the summary alone
    #[arg(long)]
    all: bool,
    /// Language of the report, the summary and what is wrong: en, ru, kk, uz [default: that of LANG where it is one of them]
    #[arg(long, value_name = "LANGUAGE", value_parser = str::parse::<Language>)]
    lang: Option<Language>,
    /// Print the report to report.pdf too, with a Chromium that is found on this computer
    #[arg(long)]
    pdf: bool,
}

/// What may be said to `run`.
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    request: Request,
    #[command(flatten)]
    shown: Shown,
    /// End each study after this many steps, or after the work of 0.1 s for each of them
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = steps)]
    work_limit: Option<u64>,
    /// Remove what the folder holds of long studies and start them anew, instead of going on with them
    #[arg(long)]
    fresh: bool,
    /// Compute part I of N of the long studies and nothing else; `laval collect` joins the parts
    #[arg(long, value_name = "I/N", value_parser = str::parse::<Piece>, conflicts_with_all = ["fresh", "work_limit", "format", "all", "lang", "pdf"])]
    part: Option<Piece>,
}

/// What may be said to `collect`.
#[derive(clap::Args)]
pub struct CollectArgs {
    #[command(flatten)]
    request: Request,
    #[command(flatten)]
    shown: Shown,
}

fn steps(text: &str) -> Result<u64, String> {
    // 2^64 as a plain number: one below it is the largest value
    let beyond = || text.parse::<f64>().is_ok_and(|x| x >= u64::MAX as f64);
    match text.parse() {
        Ok(0) => Err("give a whole number from 1 on".into()),
        Ok(n) => Ok(n),
        Err(_) if beyond() => Err(format!("the largest value is {}; without the option there is no limit", u64::MAX)),
        Err(_) => Err("give a whole number from 1 on, in digits alone".into()),
    }
}

pub static CANCEL: LazyLock<Cancel> = LazyLock::new(Cancel::default);

/// Results of finished studies are on disk at least this often.
const KEEP_EVERY: Duration = Duration::from_secs(2);

/// Runs the studies of a file.
pub fn run(args: &Args) -> u8 {
    language::request(args.shown.lang);
    let read = if args.part.is_some() { prepare_studies(&args.request) } else { prepare(&args.request) };
    let (input, loaded) = match read {
        Ok(read) => read,
        Err(code) => return code,
    };
    match args.part {
        Some(piece) => pieces::compute(&args.request, &input, &loaded, piece),
        None => {
            let how = How { work: Work::Missing, fresh: args.fresh, work_limit: args.work_limit };
            Run::new(&args.request, &args.shown, how, &input, &loaded).run()
        }
    }
}

/// Joins the parts of long studies and runs the others.
pub fn collect(args: &CollectArgs) -> u8 {
    let how = How { work: Work::Collect, fresh: false, work_limit: None };
    language::request(args.shown.lang);
    match prepare(&args.request) {
        Ok((input, loaded)) => Run::new(&args.request, &args.shown, how, &input, &loaded).run(),
        Err(code) => code,
    }
}

/// The same of a file that must have a study.
pub fn prepare_studies(args: &Request) -> Result<(Input, Loaded), u8> {
    let (input, loaded) = prepare(args)?;
    if loaded.studies.is_empty() {
        let d = Diagnostic::error("request.studies", text!("{file} contains no study", file = args.file.display()));
        input::complain(&d.help(text!("add a [[study]] block; laval studies lists the kinds")));
        return Err(WRONG);
    }
    Ok((input, loaded))
}

/// The file, and those of its studies that are requested; what is wrong is printed. Without a study the first page alone is computed.
pub fn prepare(args: &Request) -> Result<(Input, Loaded), u8> {
    let wrong = |d: Diagnostic| {
        input::complain(&d);
        WRONG
    };
    let input = Input::read(&args.file).map_err(wrong)?;
    let mut loaded = input.load().map_err(|found| {
        input.complain(&found);
        WRONG
    })?;
    if !args.quiet {
        input.complain(&loaded.warnings);
    }
    let chosen = loaded.chosen(&args.only).map_err(wrong)?;
    let mut number = 0..;
    loaded.studies.retain(|_| number.next().is_some_and(|k| chosen.contains(&k)));
    Ok((input, loaded))
}

/// First Ctrl-C: stop at the next step. Second: at once.
pub fn listen() {
    interrupt::listen(|| {
        CANCEL.store(true, Ordering::Relaxed);
        terminal::complain("\n");
        terminal::say(&text!("stopping; Ctrl-C again stops at once"));
    });
}

/// The reason of a refusal, as a finding.
fn refusal(why: &Diagnostic) -> Finding {
    Finding::warning("refused", "run-refused").arg("reason", why.sentence())
}

/// Which rows of long studies are computed, and when a study ends.
#[derive(Clone, Copy)]
struct How {
    work: Work,
    fresh: bool,
    work_limit: Option<u64>,
}

struct Run<'a> {
    args: &'a Request,
    shown: &'a Shown,
    how: How,
    input: &'a Input,
    loaded: &'a Loaded,
    dir: PathBuf,
    formats: Vec<Format>,
    report: Report,
    /// Something stands on standard output: the next paragraph needs an empty line.
    printed: bool,
    /// Rows that should be collected are missing.
    missing: bool,
    code: u8,
}

impl<'a> Run<'a> {
    fn new(args: &'a Request, shown: &'a Shown, how: How, input: &'a Input, loaded: &'a Loaded) -> Self {
        let mut settings = Vec::new();
        if let Some(n) = how.work_limit {
            settings.push(("work limit".to_string(), n.to_string()));
        }
        let text = input.text();
        let report = run::begun(&input.name(), (&text, &input.bytes), loaded, settings, language::current());
        Run {
            args,
            shown,
            how,
            input,
            loaded,
            dir: args.dir(input),
            formats: if shown.format.is_empty() { Format::ALL.to_vec() } else { shown.format.clone() },
            report,
            printed: false,
            missing: false,
            code: DONE,
        }
    }

    fn run(self) -> u8 {
        listen();
        let studies: Vec<&str> = self.report.studies.iter().map(String::as_str).collect();
        // held until the end: the files of two runs at once would be mixed
        let _held = match report::prepare(&self.dir, &studies) {
            Ok(held) => held,
            Err(d) => {
                input::complain(&d);
                return WRONG;
            }
        };
        // all that is refused is said at once, before anything long begins
        let bar = Bar::new("preparing", self.args.quiet);
        let before = Context { name: "preparing", cancel: &CANCEL, progress: &bar, work_limit: u64::MAX, keep: None };
        let refusals = self.loaded.refusals_in(&before);
        bar.finish();
        self.input.complain(&Diagnostics(refusals.iter().map(|r| r.diagnostic.clone()).collect()));
        let loaded = self.loaded;
        let summary = Context { name: "summary", cancel: &CANCEL, progress: &Silent, work_limit: u64::MAX, keep: None };
        // where no further processor or thread is free it is computed with the rest of the first page
        let beside = self.shows_overview() && loaded.studies.len() > 1 && rayon::current_num_threads() > 1;
        thread::scope(|scope| {
            let compute = || guarded(|| study::Beforehand::of(&loaded.system, &summary));
            let ahead = beside.then(|| thread::Builder::new().spawn_scoped(scope, compute).ok()).flatten();
            self.studies(&refusals, ahead)
        })
    }

    /// Runs the studies, then writes the report.
    fn studies(mut self, refusals: &[Refusal], ahead: Option<ScopedJoinHandle<Option<study::Beforehand>>>) -> u8 {
        let mut written = Instant::now();
        let count = self.loaded.studies.len();
        for (i, study) in self.loaded.studies.iter().enumerate() {
            if CANCEL.load(Ordering::Relaxed) {
                let left: Vec<&str> = self.loaded.studies[i..].iter().map(|s| s.name.as_str()).collect();
                terminal::say(&text!("not run: {left}", left = left.join(", ")));
                break;
            }
            match refusals.iter().find(|r| r.studies.contains(&i)) {
                Some(r) if r.studies[0] == i => self.refused(study, refusal(&r.diagnostic)),
                // the reason names all studies and stands once
                Some(r) => {
                    let first = &self.loaded.studies[r.studies[0]].name;
                    self.refused(study, Finding::info("refused_alike", "run-refused-alike").arg("study", Arg::name(first)));
                }
                None => self.study(study),
            }
            if i + 1 < count && written.elapsed() > KEEP_EVERY && self.how.work == Work::Missing {
                if let Err(code) = self.write() {
                    return code;
                }
                written = Instant::now();
            }
        }
        // an incomplete collection replaces no earlier results
        if self.missing {
            return self.code;
        }
        self.overview(ahead);
        let files = match self.write() {
            Ok(files) => files,
            Err(code) => return code,
        };
        let outdated = report::outdated(&self.dir, &self.report);
        if !outdated.is_empty() && !self.args.quiet {
            let names = outdated.iter().map(|n| format!("\"{}\"", plain::line(n))).collect::<Vec<_>>().join(", ");
            let out = plain::line(&self.dir.to_string_lossy()).into_owned();
            terminal::say(&match outdated.len() {
                1 => text!("warning: {out} also holds results of study {names}, which is of an earlier machine file", out, names),
                _ => text!("warning: {out} also holds results of studies {names}, which are of an earlier machine file", out, names),
            });
        }
        let page = files.into_iter().find(|f| f.ends_with("report.html"));
        if self.shown.pdf {
            let printed = page.as_deref().map_or_else(
                || Err(Diagnostic::error("pdf.page", text!("--pdf prints report.html, which --format leaves out"))),
                pdf::print,
            );
            if let Err(d) = printed {
                input::complain(&d);
                self.code = self.code.max(WRONG);
            }
        }
        let place = page.unwrap_or_else(|| self.dir.clone()).display().to_string();
        self.paragraph(&format!("{}\n", plain::line(&place)));
        if self.code != FAILED && CANCEL.load(Ordering::Relaxed) { STOPPED } else { self.code }
    }

    fn study(&mut self, named: &NamedStudy) {
        let bar = Bar::new(&named.name, self.args.quiet);
        let keep = run::keep(self.loaded, &self.dir, &named.name, self.how.work).map(|k| Keep { fresh: self.how.fresh, ..k });
        let context = Context {
            name: &named.name,
            cancel: &CANCEL,
            progress: &bar,
            work_limit: self.how.work_limit.unwrap_or(u64::MAX),
            keep: keep.as_ref(),
        };
        let result = guarded(|| named.study.run(&self.loaded.system, &context));
        bar.finish();
        let outcome = match result {
            Some(Ok(outcome)) => outcome,
            Some(Err(d)) => {
                self.missing |= self.how.work == Work::Collect && named.study.in_chunks();
                let d = self.complain(named, d);
                return self.refused(named, refusal(&d));
            }
            None => {
                terminal::say(&text!("laval: study \"{name}\" has no result", name = named.name));
                self.code = FAILED;
                return;
            }
        };
        // shown as soon as known: the next study may take long
        let mut one = Report { outcomes: vec![outcome], style: self.report.style.clone(), ..Report::default() };
        if self.shown.all {
            self.paragraph(&report::terminal(&one, terminal::findings()));
        }
        self.report.outcomes.append(&mut one.outcomes);
    }

    /// The first page, from the machine and what its studies found.
    fn overview(&mut self, ahead: Option<ScopedJoinHandle<Option<study::Beforehand>>>) {
        if !self.shows_overview() || CANCEL.load(Ordering::Relaxed) {
            return;
        }
        let context = Context { name: "summary", cancel: &CANCEL, progress: &Silent, work_limit: u64::MAX, keep: None };
        let system = &self.loaded.system;
        let speeds: Vec<_> = self.loaded.studies.iter().flat_map(|s| s.study.speeds(system)).collect();
        // its computations are short, and only how long they take is shown
        let bar = Bar::new("summary", self.args.quiet);
        let beforehand = ahead.and_then(|a| a.join().ok()).flatten();
        self.report.overview = guarded(|| study::overview_after(beforehand, system, &speeds, &self.report.outcomes, &context));
        if self.report.overview.is_none() {
            self.code = FAILED;
        }
        bar.finish();
        self.paragraph(&report::summary(&self.report, terminal::findings()));
    }

    /// Tables and figures hold nothing of the first page.
    fn shows_overview(&self) -> bool {
        !self.args.quiet || self.formats.iter().any(|f| matches!(f, Format::Json | Format::Html))
    }

    fn paragraph(&mut self, text: &str) {
        if !self.args.quiet {
            terminal::print_painted(&format!("{}{text}", if self.printed { "\n" } else { "" }));
            self.printed = true;
        }
    }

    /// A refusal as it stands in the report.
    fn refused(&mut self, named: &NamedStudy, why: Finding) {
        let outcome = Outcome::new(named.study.kind(), &named.name).end(End::Refused);
        self.report.outcomes.push(outcome.finding(why));
        self.code = self.code.max(WRONG);
    }

    /// Says why a study was refused on the way, at its place in the file.
    fn complain(&self, named: &NamedStudy, mut d: Diagnostic) -> Diagnostic {
        if d.span.is_none() {
            d.span = self.loaded.spec.study(&named.name).and_then(|b| b.span.clone());
        }
        d.message = text!("study \"{name}\": {message}", name = named.name, message = d.message);
        self.input.complain(&Diagnostics(vec![d.clone()]));
        d
    }

    fn write(&self) -> Result<Vec<PathBuf>, u8> {
        report::renew(&self.dir, &self.report, &self.formats).map_err(|e| {
            terminal::say(&text!("laval: {why}", why = e.sentence()));
            match e {
                WriteError::Io { .. } => WRONG,
                WriteError::Outcome { .. } => FAILED,
            }
        })
    }
}
