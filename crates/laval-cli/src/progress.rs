//! How far a study is, shown when it takes longer than a second and somebody watches.

use crate::terminal;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use laval::study::Progress;
use std::io::{self, IsTerminal};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// Time before anything is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// A progress bar on standard error.
pub struct Bar {
    name: String,
    start: Instant,
    watched: bool,
    bar: OnceLock<ProgressBar>,
}

impl Bar {
    /// For the study `name`; `quiet` shows nothing.
    pub fn new(name: &str, quiet: bool) -> Bar {
        Bar { name: name.to_string(), start: Instant::now(), watched: !quiet && io::stderr().is_terminal(), bar: OnceLock::new() }
    }

    fn begin(&self, done: u64, total: u64) -> ProgressBar {
        let bar = if total > 0 { ProgressBar::new(total) } else { ProgressBar::new_spinner() };
        let template = if total > 0 {
            "{prefix}  {wide_bar} {pos}/{len}  {per_sec}  {eta} left"
        } else {
            "{prefix}  {spinner} {pos}  {per_sec}  {elapsed}"
        };
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.set_prefix(self.name.clone());
        bar.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
        // the rate counts from here: what is done already took another time, or another run
        bar.set_position(done);
        bar.tick();
        bar.reset_eta();
        bar.with_elapsed(self.start.elapsed())
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
    }
}

impl Progress for Bar {
    fn report(&self, done: u64, total: u64) {
        if self.watched && self.start.elapsed() > PATIENCE {
            let bar = self.bar.get_or_init(|| self.begin(done, total));
            if total > 0 {
                bar.set_length(total);
            }
            bar.set_position(done);
        }
    }

    fn restored(&self, done: u64, total: u64) {
        self.report(done, total);
        if let Some(bar) = self.bar.get() {
            bar.tick();
            bar.reset_eta();
        }
    }

    fn note(&self, text: &str) {
        let say = || terminal::complain(&format!("{}: {text}\n", self.name));
        match self.bar.get() {
            Some(bar) => bar.suspend(say),
            None => say(),
        }
    }
}
