//! The `laval` program: from a machine file to results.
//!
//! Exit codes: 0 done; 1 the file or the request is wrong; 2 the program failed; 130 stopped by Ctrl-C.

#![warn(missing_docs)]
#![forbid(unsafe_code)]

mod check;
mod import;
mod input;
mod interrupt;
mod language;
mod new;
mod pdf;
mod pieces;
mod progress;
mod run;
mod show;
mod studio;
mod terminal;
mod validate;

use clap::error::ErrorKind;
use clap::{Parser, Subcommand};
use laval::text;
use std::backtrace::{Backtrace, BacktraceStatus};
use std::ffi::OsString;
use std::io;
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, mpsc};
use std::thread;

/// Done.
pub const DONE: u8 = 0;
/// The file or the request is wrong.
pub const WRONG: u8 = 1;
/// The program failed.
pub const FAILED: u8 = 2;
/// Stopped by Ctrl-C.
pub const STOPPED: u8 = 130;

/// Dynamics of rotating machines, from a text file to a report.
#[derive(Parser)]
#[command(name = "laval", version, arg_required_else_help = true, after_help = AFTER)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const AFTER: &str = "\
To begin:
  laval new rigid-rotor            write a first machine file
  laval run rigid-rotor.toml       compute, write out/rigid-rotor/report.html

Exit codes: 0 done, 1 the file or the request is wrong, 2 the program failed, 130 stopped by Ctrl-C.";

#[derive(Subcommand)]
enum Command {
    /// Run the studies of a machine file and write results and a report
    Run(run::Args),
    /// Say how the long studies of a machine file divide into parts for several processes or computers
    Plan(pieces::PlanArgs),
    /// Join the parts that `laval run --part` has computed, run the other studies, and write results and a report
    Collect(run::CollectArgs),
    /// Show a machine in the browser and answer while it is changed
    Studio(studio::Args),
    /// Read and assemble a machine file and say all that is wrong with it
    Check(check::Args),
    /// Write a machine file to start from; without a template, list them
    New(new::Args),
    /// Write a machine file from the model of another program
    Import(import::Args),
    /// List the kinds of parts, or document one
    Parts(show::Args),
    /// List the kinds of studies, or document one
    Studies(show::Args),
    /// List the units a value may have
    Units,
    /// Print the JSON Schema of machine files, for editors that complete and check
    Schema(show::SchemaArgs),
    /// Run the validation cases, write their gallery, fail when a verdict has changed
    Validate(validate::Args),
}

/// Runs the program with these arguments (the first is its name) and returns its exit code.
pub fn program(args: impl IntoIterator<Item = OsString>) -> u8 {
    std::panic::set_hook(Box::new(|what| {
        let trace = Backtrace::capture();
        let trace = if trace.status() == BacktraceStatus::Captured { format!("{trace}\n") } else { String::new() };
        terminal::complain(&format!("{what}\n{trace}"));
    }));
    let command = match Cli::try_parse_from(args) {
        Ok(cli) => cli.command,
        Err(e) => return usage(&e),
    };
    start_threads();
    let code = guarded(|| match &command {
        Command::Run(args) => run::run(args),
        Command::Plan(args) => pieces::plan(args),
        Command::Collect(args) => run::collect(args),
        Command::Studio(args) => studio::studio(args),
        Command::Check(args) => check::check(args),
        Command::New(args) => new::new(args),
        Command::Import(args) => import::import(args),
        Command::Parts(args) => show::parts(args),
        Command::Studies(args) => show::studies(args),
        Command::Units => show::units(),
        Command::Schema(args) => show::schema(args),
        Command::Validate(args) => validate::validate(args),
    })
    .unwrap_or(FAILED);
    if code == DONE && terminal::lost() { WRONG } else { code }
}

/// One thread computes where the system does not allow as many as RAYON_NUM_THREADS says, or one for each processor. They are tried first: the pool of parallel
/// loops is built once, and cannot be built again after it has failed.
fn start_threads() {
    let said = std::env::var("RAYON_NUM_THREADS").ok().and_then(|n| n.parse().ok()).filter(|n| *n > 0);
    let wanted = said.unwrap_or_else(|| thread::available_parallelism().map_or(1, NonZeroUsize::get));
    if let Err(e) = try_threads(wanted) {
        terminal::say(&text!(
            "note: {wanted} threads cannot be started ({e}): one computes. RAYON_NUM_THREADS says how many are wanted.",
            wanted,
            e
        ));
        // fails where threads run already
        let _ = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
    }
}

/// Starts `wanted` threads that are alive together, and ends them. A thread takes memory of its own once it runs, and one that gets none ends the program: each
/// is started when the one before it runs, and all have given their memory back at the end.
fn try_threads(wanted: usize) -> io::Result<()> {
    let gate = Arc::new(Mutex::new(()));
    let (runs, running) = mpsc::channel();
    let mut started = Vec::new();
    let mut start = || {
        let (gate, runs) = (gate.clone(), runs.clone());
        started.push(thread::Builder::new().spawn(move || {
            let _ = runs.send(());
            drop(gate.lock());
        })?);
        let _ = running.recv();
        Ok(())
    };
    let held = gate.lock();
    let tried = (0..wanted).try_for_each(|_| start());
    drop(held);
    for thread in started {
        let _ = thread.join();
    }
    tried
}

/// Help and version are answers; anything else is a wrong request.
fn usage(e: &clap::Error) -> u8 {
    let text = e.render().to_string();
    if e.use_stderr() {
        terminal::complain(&text)
    } else {
        terminal::print(&text)
    }
    match e.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion if !terminal::lost() => DONE,
        _ => WRONG,
    }
}

/// Calls `f`; a panic inside becomes a message that it is a defect of the program, and `None`.
fn guarded<T>(f: impl FnOnce() -> T) -> Option<T> {
    let result = catch_unwind(AssertUnwindSafe(f)).ok();
    if result.is_none() {
        terminal::say(&text!(
            "laval: this is a defect of the program, not of your file. Please report it with the machine file and the message above"
        ));
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_declared_consistently() {
        Cli::command().debug_assert();
    }

    #[test]
    fn a_panic_is_caught() {
        assert_eq!(guarded(|| -> u8 { panic!("on purpose") }), None);
        assert_eq!(guarded(|| 3), Some(3));
    }
}
