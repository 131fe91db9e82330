//! The windows, what ends them, and why there is none.

use super::borders::stable;
use super::detail::Detail;
use super::margins::{NAMES, Point};
use super::report::{Shown, requirement};
use super::window::{End, Interval, excluding, relaxations};
use crate::outcome::{Arg, Finding, Message, Outcome};

/// Least factor of a relaxation, and largest share of a throughput, that the digits shown distinguish from no change.
const LEAST: f64 = 1.001;
const MOST: f64 = 0.999;

/// Growth over the spin speed that is rounding: pairs of modes of an undamped machine that meet lose half the digits.
const ROUNDING: f64 = 1e-7;

/// Why no speed keeps the requirement on stability: the machine grows, or decays less than required.
fn grows(points: &[Point], required: f64) -> Finding {
    let least = points.iter().map(|p| p.growth).fold(f64::INFINITY, f64::min);
    // what does not keep a margin of 0 grows by more than its error
    if !(required > 0.0) || points.iter().all(|p| p.growth > ROUNDING * p.speed.abs()) {
        return Finding::warning("unstable", "operating-window-unstable").value(least, "1/s");
    }
    let neutral = points.iter().all(|p| p.growth >= -ROUNDING * p.speed.abs());
    Finding::warning("growth_margin", "operating-window-growth-margin")
        .value(least, "1/s")
        .arg("required", Arg::quantity(required, "1/s"))
        .arg("damping", Arg::word(if neutral { "none" } else { "some" }))
        .evidence("growth rate that is rounding, over the speed", ROUNDING, "")
}

/// What is lost beyond the end of a window.
fn end_phrase(e: &End, flow: bool) -> Message {
    match e.event {
        "domain limit" => requirement("range", flow),
        "jump" => Message::new("operating-window-at-jump").arg("requirement", requirement(&e.binding, flow)),
        _ => requirement(&e.binding, flow),
    }
}

impl Shown<'_> {
    pub fn windows(&self, mut out: Outcome) -> Outcome {
        let flow = self.flow().is_some();
        for i in &self.found.main.intervals {
            out = out.finding(
                Finding::info("window", "operating-window-window")
                    .value(i.high.speed, "rad/s")
                    .arg("from", Arg::speed(i.low.speed))
                    .arg("below", end_phrase(&i.low, flow))
                    .arg("above", end_phrase(&i.high, flow))
                    .evidence("from", i.low.speed, "rad/s")
                    .evidence("width of the lower bracket", i.low.bracket, "rad/s")
                    .evidence("width of the upper bracket", i.high.bracket, "rad/s")
                    .evidence("width over mean speed", 2.0 * (i.high.speed - i.low.speed) / (i.high.speed + i.low.speed), ""),
            );
        }
        out = self.edges(out);
        if let Some(r) = &self.found.robust {
            let given = |f: Finding| f.arg("corners", Arg::count(r.corners)).arg("tolerance", Arg::percent(self.study.tolerance));
            if r.intervals.is_empty() {
                out = out.finding(given(Finding::warning("robust_window", "operating-window-no-robust-window")));
            }
            for (low, high) in &r.intervals {
                let finding = given(Finding::info("robust_window", "operating-window-robust-window").value(*high, "rad/s"));
                out = out.finding(finding.arg("from", Arg::speed(*low)).evidence("from", *low, "rad/s"));
            }
        }
        out
    }

    /// Why each end of a window is an end, and how wide the widest window is.
    fn edges(&self, mut out: Outcome) -> Outcome {
        for i in &self.found.main.intervals {
            for (e, side) in [(&i.low, "begins"), (&i.high, "ends")].into_iter().filter(|e| e.0.event != "domain limit") {
                let fold = self.fold(e);
                let difference = fold.map_or(f64::NAN, |w| (w - e.speed).abs());
                out = out.finding(
                    Finding::info("edge", "operating-window-edge")
                        .of(side)
                        .value(e.speed, "rad/s")
                        .arg("side", Arg::word(side))
                        .arg("reason", self.reason(e, fold.is_some()))
                        .evidence("width of the bracket", e.bracket, "rad/s")
                        .evidence("difference from the fold by its extended system", difference, "rad/s"),
                );
            }
        }
        let width = |i: &Interval| i.high.speed - i.low.speed;
        if let Some(w) = self.found.main.intervals.iter().max_by(|a, b| width(a).total_cmp(&width(b))) {
            let finding = Finding::info("widest_window", "operating-window-widest-window").value(width(w), "rad/s");
            out = out.finding(finding.arg("from", Arg::speed(w.low.speed)).arg("to", Arg::speed(w.high.speed)));
        }
        out
    }

    /// The limit of the quantity that ends the window.
    fn limit(&self, e: &End) -> Option<Arg> {
        let l = &self.limits;
        let Detail::Limited { quantity, of } = &e.detail else {
            let growth = e.event == "eigenvalue crossing";
            return growth.then(|| Arg::quantity(if l.growth == 0.0 { 0.0 } else { -l.growth }, "1/s"));
        };
        let (list, unit) = match *quantity {
            "displacement" => (&l.displacement, "m"),
            "velocity" => (&l.velocity, "m/s"),
            "tilt" => (&l.tilt, "rad"),
            "force" => (&l.force, "N"),
            _ => (&l.moment, "N m"),
        };
        list.iter().find(|x| x.name == *of).map(|x| Arg::quantity(x.value, unit))
    }

    /// The speed of the fold at which the window ends.
    pub fn fold(&self, e: &End) -> Option<f64> {
        let folds = self.found.main.folds.iter().copied().filter(|_| e.event == "jump");
        let fold = folds.min_by(|a, b| (a - e.speed).abs().total_cmp(&(b - e.speed).abs()));
        fold.filter(|w| (w - e.speed).abs() <= 1e-6 * e.speed)
    }

    /// Why the window ends there.
    pub fn reason(&self, e: &End, fold: bool) -> Message {
        let what = e.detail.phrase().unwrap_or_else(|| requirement(&e.binding, self.flow().is_some()));
        let limit = self.limit(e);
        if e.detail.undefined() {
            return Message::new("operating-window-reason-undefined").arg("what", what);
        }
        if e.event == "jump" {
            // of what has no limit of its own, the margin is no share of one
            let message = match e.beyond.is_finite() && matches!(e.detail, Detail::Limited { .. }) {
                true => Message::new("operating-window-reason-jump").arg("factor", Arg::number(1.0 - e.beyond).digits(4)),
                false => Message::new("operating-window-reason-jump-undefined"),
            };
            let fold = Arg::word(if fold { "yes" } else { "no" });
            return message.arg("what", what).arg("states", Arg::count(e.states[1])).arg("fold", fold);
        }
        match limit {
            Some(limit) => Message::new("operating-window-reason-limit").arg("what", what).arg("limit", limit),
            None => Message::new("operating-window-reason").arg("what", what),
        }
    }

    /// Why there is no window, and what would open one.
    pub fn conflict(&self, mut out: Outcome) -> Outcome {
        let (points, flow) = (&self.found.main.points, self.flow().is_some());
        if !points.is_empty() && points.iter().all(|p| !stable(p) && p.growth.is_finite()) {
            out = out.finding(grows(points, self.limits.growth));
        }
        out = out.finding(Finding::warning("no_window", "operating-window-no-window"));
        for (a, b) in excluding(points) {
            let finding = Finding::warning("excluding", "operating-window-excluding").arg("first", requirement(NAMES[a], flow));
            out = out.finding(finding.arg("second", requirement(NAMES[b], flow)));
        }
        let relaxed = relaxations(points);
        for &(name, margin, speed) in &relaxed {
            let finding = match NAMES[name] {
                "separation" if flow => {
                    let share = (1.0 / (1.0 - margin)).min(MOST);
                    Finding::info("relaxation", "operating-window-lower-throughput").arg("share", Arg::percent(share))
                }
                "separation" | "vibration" | "self_centred" | "passage" | "strength" => {
                    let factor = Arg::number((1.0 - margin).max(LEAST)).digits(4);
                    Finding::info("relaxation", "operating-window-relaxation").arg("factor", factor)
                }
                _ => continue,
            };
            let finding = finding.value(1.0 - margin, "").arg("requirement", Arg::word(NAMES[name])).arg("speed", Arg::speed(speed));
            out = out.finding(finding.evidence("speed", speed, "rad/s"));
        }
        if relaxed.is_empty() {
            out = out.finding(Finding::info("relaxation", "operating-window-no-relaxation"));
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
        let undamped = |f: &Finding| f.message.args.iter().any(|a| a.0 == "damping" && a.1 == Arg::word("none"));
        for (growth, id, without, says) in [
            ([0.0, 1e-9], "growth_margin", true, "nothing damps"),
            ([-0.3, -0.2], "growth_margin", false, "lowest growth rate"),
            ([-0.3, 0.2], "growth_margin", false, "lowest growth rate"),
            ([0.1, 0.2], "unstable", false, "unstable at every computed speed"),
        ] {
            let f = grows(&points(&growth), 1.0);
            assert!(f.id == id && f.number("value") == Some(growth[0]) && undamped(&f) == without, "{f:?}");
            assert!(f.sentence().contains(says), "{}", f.sentence());
        }
        assert!(!undamped(&grows(&points(&[-0.3]), 1.0)));
        // of a margin of 0 that is not kept: the growth is more than its error, however slow
        assert_eq!(grows(&points(&[1e-9, 0.2]), 0.0).id, "unstable");
    }

    #[test]
    fn a_factor_and_a_share_shown_are_a_change() {
        let f = Finding::info("relaxation", "operating-window-relaxation").arg("factor", Arg::number(LEAST).digits(4));
        assert!(f.arg("requirement", Arg::word("strength")).arg("speed", Arg::speed(1.0)).sentence().contains(" 1.001 times"));
        let f = Finding::info("relaxation", "operating-window-lower-throughput").arg("share", Arg::percent(MOST));
        assert!(f.arg("speed", Arg::speed(1.0)).sentence().contains(" 99.9 %"));
    }
}
