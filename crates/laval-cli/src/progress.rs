//! How far a study is: a bar where somebody watches, a calm line now and then where standard error is a file or a pipe.

use crate::language;
use crate::terminal;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use laval::plain;
use laval::study::Progress;
use laval::text;
use laval::text::Text;
use std::io::{self, IsTerminal};
use std::sync::{Arc, Condvar, Mutex, OnceLock, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Time before a bar is shown.
const PATIENCE: Duration = Duration::from_secs(1);
/// Time between two lines.
const CALM: Duration = Duration::from_secs(10);
/// Time between two looks at a study that says nothing of itself.
const LOOK: Duration = Duration::from_millis(500);
/// Steps of a bar.
const STEPS: u64 = 10_000;

/// Work done, and since when.
#[derive(Clone, Copy, Debug)]
struct Pace {
    /// Units done, those of an earlier run among them.
    done: u64,
    /// Units of passes before this one: a computation of unknown length may begin anew.
    before: u64,
    /// Units in all; 0 when unknown.
    total: u64,
    /// Of units under way, the share that is done.
    part: f64,
    /// Units done where the clock began.
    from: f64,
    since: Instant,
}

impl Pace {
    fn new(now: Instant) -> Pace {
        Pace { done: 0, before: 0, total: 0, part: 0.0, from: 0.0, since: now }
    }

    /// Never runs backwards: threads report out of order, and what is counted without end may be counted once more.
    fn report(&mut self, done: u64, total: u64, now: Instant) {
        if total != self.total {
            // another stretch of work has a rate of its own
            let first = self.before + self.done == 0;
            let (since, from) = if first { (self.since, 0.0) } else { (now, done as f64) };
            *self = Pace { done, total, since, from, ..Pace::new(now) };
        } else if total > 0 {
            self.done = self.done.max(done);
        } else {
            if done < self.done {
                self.before += self.done;
            }
            self.done = done;
        }
    }

    fn at(&self) -> f64 {
        self.done as f64 + self.part
    }

    /// Share of the work that is done, when its total is known.
    fn share(&self) -> Option<f64> {
        (self.total > 0).then(|| (self.at() / self.total as f64).clamp(0.0, 1.0))
    }

    /// Time left at the rate so far; unknown before anything is done.
    fn left(&self, now: Instant) -> Option<Duration> {
        let (fresh, open) = (self.at() - self.from, self.total as f64 - self.at());
        if self.total == 0 || !(fresh > 0.0) {
            return None;
        }
        Duration::try_from_secs_f64(now.duration_since(self.since).as_secs_f64() * open.max(0.0) / fresh).ok()
    }

    /// `12 % done, about 40 s left`.
    fn words(&self, now: Instant) -> Text {
        let done = self.done();
        match self.left(now) {
            Some(left) => text!("{done}, about {left} left", done, left = words(left)),
            None => done,
        }
    }

    fn done(&self) -> Text {
        match self.share() {
            Some(share) => text!("{percent} % done", percent = format_args!("{:.0}", (100.0 * share).floor())),
            None => match self.before + self.done {
                1 => text!("1 step done"),
                steps => text!("{steps} steps done", steps),
            },
        }
    }

    /// The same of a study of which nothing new is known after some time.
    fn waiting(&self, begun: Duration) -> Text {
        let time = words(begun);
        match self.total == 0 && self.before + self.done == 0 {
            true => text!("computing for {time}", time),
            false => text!("{done} after {time}", done = self.done(), time),
        }
    }
}

/// A time for people, to the unit that matters.
fn words(t: Duration) -> Text {
    let s = t.as_secs_f64();
    let whole = |x: f64| format!("{:.0}", x.ceil());
    match s {
        s if s < 90.0 => text!("{n} s", n = whole(s)),
        s if s < 5400.0 => text!("{n} min", n = whole(s / 60.0)),
        s if s < 172_800.0 => text!("{n} h", n = whole(s / 3600.0)),
        s => text!("{n} days", n = whole(s / 86_400.0)),
    }
}

/// Shows the progress of one study on standard error, and that it still computes where it says nothing itself.
pub struct Bar {
    shown: Arc<Shown>,
    clock: Mutex<Option<JoinHandle<()>>>,
}

struct Shown {
    name: String,
    quiet: bool,
    watched: bool,
    begun: Instant,
    pace: Mutex<Pace>,
    /// What the study is doing, in its own words.
    doing: Mutex<Option<Text>>,
    /// When a line was written last, and which.
    said: Mutex<(Instant, String)>,
    bar: OnceLock<ProgressBar>,
    finished: Mutex<bool>,
    end: Condvar,
}

impl Bar {
    /// For the study `name`; `quiet` shows nothing.
    pub fn new(name: &str, quiet: bool) -> Bar {
        let now = Instant::now();
        let shown = Arc::new(Shown {
            name: plain::line(name).into_owned(),
            quiet,
            watched: io::stderr().is_terminal(),
            begun: now,
            pace: Mutex::new(Pace::new(now)),
            doing: Mutex::new(None),
            said: Mutex::new((now, String::new())),
            bar: OnceLock::new(),
            finished: Mutex::new(false),
            end: Condvar::new(),
        });
        let clock = shown.clone();
        // without the thread progress is shown where the study reports it
        let clock = if quiet { None } else { thread::Builder::new().name("progress".into()).spawn(move || clock.look()).ok() };
        Bar { shown, clock: Mutex::new(clock) }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        *self.shown.finished.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.shown.end.notify_all();
        if let Some(clock) = self.clock.lock().unwrap_or_else(PoisonError::into_inner).take() {
            let _ = clock.join();
        }
        if let Some(bar) = self.shown.bar.get() {
            bar.finish_and_clear();
        }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.finish();
    }
}

impl Shown {
    /// Shows from time to time that a study computes, until it has ended.
    fn look(&self) {
        let mut finished = self.finished.lock().unwrap_or_else(PoisonError::into_inner);
        while !*finished {
            finished = self.end.wait_timeout(finished, LOOK).unwrap_or_else(PoisonError::into_inner).0;
            if !*finished {
                self.update(|_| {});
            }
        }
    }

    fn bar(&self) -> ProgressBar {
        let bar = ProgressBar::new(STEPS);
        if let Ok(style) = ProgressStyle::with_template("{prefix}  {wide_bar} {msg}") {
            bar.set_style(style);
        }
        bar.set_prefix(self.name.clone());
        bar.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
        bar
    }

    /// Remembers how far it is and shows it when it is time to.
    fn update(&self, change: impl FnOnce(&mut Pace)) {
        if self.quiet {
            return;
        }
        let pace = {
            let mut pace = self.pace.lock().unwrap_or_else(PoisonError::into_inner);
            change(&mut pace);
            *pace
        };
        let now = Instant::now();
        if self.watched {
            if now.duration_since(self.begun) > PATIENCE {
                let bar = self.bar.get_or_init(|| self.bar());
                bar.set_position((pace.share().unwrap_or(0.0) * STEPS as f64) as u64);
                let known = pace.total > 0 || pace.before + pace.done > 0;
                let words = if known { pace.words(now) } else { pace.waiting(now.duration_since(self.begun)) };
                bar.set_message(self.with_stage(language::said(&words)));
            }
            return;
        }
        // whoever finds it locked knows that a line is being written
        let Ok(mut said) = self.said.try_lock() else { return };
        if now.duration_since(said.0) < CALM {
            return;
        }
        let mut words = self.with_stage(language::said(&pace.words(now)));
        if words == said.1 || pace.total == 0 && pace.before + pace.done == 0 {
            words = language::said(&pace.waiting(now.duration_since(self.begun)));
        }
        terminal::complain(&format!("{}: {words}\n", self.name));
        *said = (now, words);
    }

    /// With what the study is doing behind it.
    fn with_stage(&self, words: String) -> String {
        match &*self.doing.lock().unwrap_or_else(PoisonError::into_inner) {
            Some(doing) => format!("{words}; {}", plain::line(&language::said(doing))),
            None => words,
        }
    }

    fn say(&self, text: &Text) {
        let say = || terminal::complain(&format!("{}: {}\n", self.name, plain::line(&language::said(text))));
        match self.bar.get() {
            Some(bar) => bar.suspend(say),
            None => say(),
        }
    }
}

impl Progress for Bar {
    fn report(&self, done: u64, total: u64) {
        self.shown.update(|p| p.report(done, total, Instant::now()));
    }

    fn part(&self, share: f64) {
        self.shown.update(|p| p.part = share);
    }

    fn restored(&self, done: u64, total: u64) {
        // the rate counts from here: what is done already took another run
        self.shown.update(|p| *p = Pace { done, total, from: done as f64, ..Pace::new(Instant::now()) });
    }

    fn doing(&self, text: &Text) {
        if !self.shown.quiet {
            *self.shown.doing.lock().unwrap_or_else(PoisonError::into_inner) = Some(text.clone());
        }
    }

    fn job(&self, text: &Text) {
        if !self.shown.quiet {
            self.shown.say(text);
        }
    }

    fn note(&self, text: &Text) {
        self.shown.say(text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_left_follows_from_the_rate_of_this_run() {
        let start = Instant::now();
        let after = |s: u64| start + Duration::from_secs(s);
        let mut p = Pace { total: 400, ..Pace::new(start) };
        assert_eq!((p.words(after(5)).to_string().as_str(), p.left(after(5))), ("0 % done", None));
        // one member of 400 half done
        p.part = 0.5;
        assert_eq!(p.left(after(5)), Some(Duration::from_secs(3995)));
        (p.done, p.part) = (100, 0.0);
        assert_eq!(p.words(after(20)), "25 % done, about 60 s left");
        // of 200 there already, nothing is known of the rate
        let mut p = Pace { done: 200, from: 200.0, ..p };
        assert_eq!(p.words(after(20)), "50 % done");
        p.done = 300;
        assert_eq!(p.words(after(300)), "75 % done, about 5 min left");
        let unknown = Pace { total: 0, done: 1234, ..p };
        assert_eq!(unknown.words(after(300)), "1234 steps done");
    }

    /// A study that reports nothing, or nothing new, is shown with the time since its beginning.
    #[test]
    fn what_says_nothing_is_shown_with_its_time() {
        let mut p = Pace::new(Instant::now());
        assert_eq!(p.waiting(Duration::from_secs(30)), "computing for 30 s");
        (p.done, p.total) = (1, 4);
        assert_eq!(p.waiting(Duration::from_secs(120)), "25 % done after 2 min");
        p.total = 0;
        assert_eq!(p.waiting(Duration::from_secs(20)), "1 step done after 20 s");
    }

    #[test]
    fn progress_never_runs_backwards() {
        let start = Instant::now();
        let mut p = Pace::new(start);
        let mut steps = |done| {
            p.report(done, 0, start);
            p.words(start).to_string()
        };
        assert_eq!([steps(0), steps(1), steps(7)], ["0 steps done", "1 step done", "7 steps done"]);
        // the same once more with more harmonics
        assert_eq!([steps(1), steps(3), steps(3)], ["8 steps done", "10 steps done", "10 steps done"]);
        let mut share = |done| {
            p.report(done, 10, start);
            p.words(start).to_string()
        };
        assert_eq!([share(2), share(5), share(4)], ["20 % done", "50 % done, about 0 s left", "50 % done, about 0 s left"]);
    }

    #[test]
    fn times_for_people() {
        let shown = |s: f64| words(Duration::from_secs_f64(s)).to_string();
        assert_eq!([shown(0.2), shown(89.0), shown(100.0), shown(7200.0), shown(1e6)], ["1 s", "89 s", "2 min", "2 h", "12 days"]);
    }
}
