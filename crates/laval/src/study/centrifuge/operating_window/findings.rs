//! The windows, what ends them, and why there is none.

use super::borders::stable;
use super::margins::{NAMES, Point};
use super::report::{Shown, rpm, words};
use super::window::{End, Interval, excluding, relaxations};
use crate::outcome::{Finding, Outcome, quantity, significant};
use crate::study::shared::support::RPM;

/// Least factor of a relaxation, and largest share in percent of a throughput, that the four digits shown distinguish from no change.
const LEAST: f64 = 1.001;
const MOST: f64 = 99.9;

/// Growth over the spin speed that is rounding: pairs of modes of an undamped machine that meet lose half the digits.
const ROUNDING: f64 = 1e-7;

/// A factor to show, large enough to be seen.
fn enough(factor: f64) -> f64 {
    factor.max(LEAST)
}

/// Why no speed keeps the requirement on stability: the machine grows, or decays less than required.
fn grows(points: &[Point], required: f64) -> Finding {
    let least = points.iter().map(|p| p.growth).fold(f64::INFINITY, f64::min);
    // what does not keep a margin of 0 grows by more than its error
    if !(required > 0.0) || points.iter().all(|p| p.growth > ROUNDING * p.speed.abs()) {
        let text = "The machine is unstable at every speed computed: its growth rate is {} or more. Remove the instability before any other limit counts.";
        return Finding::warning("unstable", text).value(least, "1/s");
    }
    let neutral = points.iter().all(|p| p.growth >= -ROUNDING * p.speed.abs());
    let why = if neutral { " Nothing dissipates in at least one motion at every speed computed." } else { "" };
    let text = format!(
        "No speed computed keeps the growth_margin of {}: the least growth rate is {{}}.{why} Add damping, or lower growth_margin.",
        quantity(required, "1/s")
    );
    Finding::warning("growth_margin", text).value(least, "1/s").evidence("growth rate that is rounding, over the speed", ROUNDING, "")
}

impl Shown<'_> {
    pub fn windows(&self, mut out: Outcome) -> Outcome {
        let flow = self.flow().is_some();
        let ended = |e: &End, side: &str| match e.event {
            "domain limit" => format!("{side}, by the range looked at"),
            event if e.binding == "stable" => format!("{side}, by stability ({}, {event})", e.detail),
            event => format!("{side}, by {} ({event})", words(&e.binding, flow)),
        };
        for i in &self.found.main.intervals {
            let text = format!(
                "The machine may run from {} to {{}}: bounded {}, and {}.",
                rpm(i.low.speed),
                ended(&i.low, "below"),
                ended(&i.high, "above")
            );
            out = out.finding(
                Finding::info("window", text)
                    .value(i.high.speed, "rad/s")
                    .shown_as(i.high.speed * RPM, "rpm")
                    .evidence("from", i.low.speed, "rad/s")
                    .evidence("width of the lower bracket", i.low.bracket, "rad/s")
                    .evidence("width of the upper bracket", i.high.bracket, "rad/s")
                    .evidence("width over mean speed", 2.0 * (i.high.speed - i.low.speed) / (i.high.speed + i.low.speed), ""),
            );
        }
        out = self.edges(out);
        if let Some(r) = &self.found.robust {
            let given = match r.corners {
                0 => String::new(),
                n => format!("at all {n} corners of the uncertain parameters, "),
            };
            let tolerance = significant(100.0 * self.study.tolerance, 3);
            if r.intervals.is_empty() {
                out = out.finding(Finding::warning(
                    "robust_window",
                    format!("No speed is safe {given}with {tolerance} % tolerance of the speed."),
                ));
            }
            for (low, high) in &r.intervals {
                let text = format!("Robust ({given}{tolerance} % tolerance of the speed): from {} to {{}}.", rpm(*low));
                out = out.finding(
                    Finding::info("robust_window", text).value(*high, "rad/s").shown_as(high * RPM, "rpm").evidence("from", *low, "rad/s"),
                );
            }
        }
        out
    }

    /// Why each end of a window is an end, and how wide the widest window is.
    fn edges(&self, mut out: Outcome) -> Outcome {
        for i in &self.found.main.intervals {
            for (e, side) in [(&i.low, "begins"), (&i.high, "ends")].into_iter().filter(|e| e.0.event != "domain limit") {
                let (reason, fold) = self.reason(e);
                let text = format!("Why the window {side} at {{}}: {reason}.");
                out = out.finding(
                    Finding::info("edge", text)
                        .of(side)
                        .value(e.speed, "rad/s")
                        .shown_as(e.speed * RPM, "rpm")
                        .evidence("width of the bracket", e.bracket, "rad/s")
                        .evidence(
                            "difference from the fold by its extended system",
                            fold.map_or(f64::NAN, |w| (w - e.speed).abs()),
                            "rad/s",
                        ),
                );
            }
        }
        let width = |i: &Interval| i.high.speed - i.low.speed;
        if let Some(w) = self.found.main.intervals.iter().max_by(|a, b| width(a).total_cmp(&width(b))) {
            let text = format!("The widest window, from {} to {}, spans {{}}.", rpm(w.low.speed), rpm(w.high.speed));
            out = out.finding(Finding::info("widest_window", text).value(width(w), "rad/s").shown_as(width(w) * RPM, "rpm"));
        }
        out
    }

    /// Why the window ends there, and the speed of the fold it ends at.
    pub fn reason(&self, e: &End) -> (String, Option<f64>) {
        let l = &self.limits;
        let lists = [
            ("displacement", &l.displacement, "m"),
            ("velocity", &l.velocity, "m/s"),
            ("tilt", &l.tilt, "rad"),
            ("force", &l.force, "N"),
            ("moment", &l.moment, "N m"),
        ];
        let limit = lists.iter().find_map(|(what, list, unit)| {
            let own = list.iter().find(|x| format!("{what} of {}", x.name) == e.detail)?;
            Some((own.value, *unit))
        });
        let what = if e.detail.is_empty() { words(&e.binding, self.flow().is_some()) } else { e.detail.as_str() };
        match (e.event, limit) {
            ("jump", _) => {
                let fold = self.found.main.folds.iter().copied().min_by(|a, b| (a - e.speed).abs().total_cmp(&(b - e.speed).abs()));
                let fold = fold.filter(|w| (w - e.speed).abs() <= 1e-6 * e.speed);
                let at = if fold.is_some() { "; the edge is a fold" } else { "" };
                let many = if e.states[1] > 1 { " (a slow sweep can reach each of them, so that all count)" } else { "" };
                let excess = match limit {
                    Some(_) if e.beyond.is_finite() => format!("has {} times its limit", significant(1.0 - e.beyond, 4)),
                    _ => "breaks its limit".into(),
                };
                (format!("beyond it the {what} {excess} in one of {} stable states{many}{at}", e.states[1]), fold)
            }
            (_, Some((value, unit))) => (format!("the {what} reaches its limit, {}", quantity(value, unit)), None),
            ("eigenvalue crossing", None) => (format!("the {what} passes the limit of {} 1/s", significant(-l.growth, 4)), None),
            _ => (format!("the limit of {what} is reached"), None),
        }
    }

    /// Why there is no window, and what would open one.
    pub fn conflict(&self, mut out: Outcome) -> Outcome {
        let points = &self.found.main.points;
        if !points.is_empty() && points.iter().all(|p| !stable(p) && p.growth.is_finite()) {
            out = out.finding(grows(points, self.limits.growth));
        }
        out = out.finding(Finding::warning("no_window", "No speed computed in the range keeps all requirements."));
        for (a, b) in excluding(points) {
            let text = format!("\"{}\" and \"{}\" exclude each other: no speed computed keeps both.", NAMES[a], NAMES[b]);
            out = out.finding(Finding::warning("excluding", text));
        }
        for (name, margin, speed) in relaxations(points) {
            let what = match NAMES[name] {
                "separation" if self.flow().is_some() => {
                    let text = format!("Lowering the throughput to {{}} of its value would open a window at {}.", rpm(speed));
                    let share = 1.0 / (1.0 - margin);
                    out = out.finding(
                        Finding::info("relaxation", text)
                            .value(1.0 - margin, "")
                            .shown_as((100.0 * share).min(MOST), "%")
                            .evidence("speed", speed, "rad/s"),
                    );
                    continue;
                }
                "separation" => "the time at hand (or a shorter separation)",
                "vibration" => "the vibration limit that binds",
                "self_centred" => "the self-centring ratio",
                "passage" => "the limit on the passage that binds",
                "strength" => "the highest speed",
                _ => continue,
            };
            let text = format!("Relaxing {what} to {{}} times its value would open a window at {}.", rpm(speed));
            let f = Finding::info("relaxation", text).value(1.0 - margin, "").shown_as(enough(1.0 - margin), "");
            out = out.finding(f.evidence("speed", speed, "rad/s"));
        }
        if relaxations(points).is_empty() {
            out = out.finding(Finding::info(
                "relaxation",
                "Relaxing a single requirement does not open a window: at every speed computed two or more are broken.",
            ));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(growth: &[f64]) -> Vec<Point> {
        let one = |growth: f64| Point {
            speed: 100.0,
            margins: vec![],
            needed: 0.0,
            tilt: 0.0,
            unbalance: 0.0,
            states: 1,
            energy: 0.0,
            growth,
            leans: vec![],
        };
        growth.iter().map(|g| one(*g)).collect()
    }

    /// An undamped machine is neutral; growth beyond rounding is an instability; slow decay lacks a margin.
    #[test]
    fn neutral_is_not_unstable() {
        for (growth, id, says) in [
            ([0.0, 1e-9], "growth_margin", "Nothing dissipates"),
            ([-0.3, -0.2], "growth_margin", "the least growth rate"),
            ([-0.3, 0.2], "growth_margin", "the least growth rate"),
            ([0.1, 0.2], "unstable", "unstable at every speed"),
        ] {
            let f = grows(&points(&growth), 1.0);
            assert!(f.id == id && f.text.contains(says), "{f:?}");
        }
        assert!(!grows(&points(&[-0.3]), 1.0).text.contains("dissipates"));
        // of a margin of 0 that is not kept: the growth is more than its error, however slow
        assert_eq!(grows(&points(&[1e-9, 0.2]), 0.0).id, "unstable");
    }

    #[test]
    fn factors_shown_relax() {
        assert_eq!(enough(1.0 + 1e-9), LEAST);
        assert_eq!(enough(1.2), 1.2);
    }
}
