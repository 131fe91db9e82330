//! Findings about the modes at one speed.

use super::report::Shown;
use crate::model::part::Words;
use crate::outcome::{Arg, Finding};
use crate::solve::pencil::{MachineMode, Spectrum, holds_fit, wants_polish};
use crate::solve::roots::has_more_modes;
use crate::study::linear::growing::limit;
use crate::study::linear::whirl;
use crate::study::shared::region;
use crate::study::shared::support::{decay_uncounted, remarks};

impl Shown<'_> {
    pub fn findings(&self) -> Vec<Finding> {
        let mut out = self.unstable_modes();
        let any_unstable = !out.is_empty();
        if any_unstable && self.threshold > self.study.threshold {
            let name = self.undamped.unwrap_or(Words::PLAIN).name;
            out.push(Finding::info("threshold", "modes-threshold").value(self.threshold, "1/s").arg("part", Arg::term(name)));
        }
        let modes = self.modes();
        let slowly: Vec<usize> = (0..modes.len()).filter(|&k| self.grows(&modes[k]) && !self.unstable(&modes[k])).collect();
        let least = self.least_damped(any_unstable, !slowly.is_empty());
        // below a low frequency_limit and within the frequencies of a table there may be no mode
        let none = modes.is_empty() && (self.result.own.is_some() || self.result.roots.as_ref().is_some_and(|r| r.growing().is_some()));
        let verdict = (!any_unstable && !none).then(|| self.verdict(&slowly));
        // what grows comes first
        let (first, second) = if slowly.is_empty() { (least, verdict) } else { (verdict, least) };
        out.extend(first.into_iter().chain(second));
        out.extend(self.counts(any_unstable));
        let infinite = self.result.spectrum.infinite;
        if infinite > 0 {
            out.push(Finding::info("massless", "modes-massless").arg("infinite", Arg::count(infinite)));
        }
        out.extend(remarks(self.system, &self.result.about));
        out
    }

    fn unstable_modes(&self) -> Vec<Finding> {
        let one = |(k, m): (usize, &MachineMode)| {
            let finding = Finding::warning("unstable_mode", "modes-unstable-mode").value(m.growth(), "1/s").arg("mode", Arg::count(k + 1));
            let finding = whirl::growing(finding, m, self.study.speed).evidence("error of the eigenvalue", m.error, "1/s");
            finding.evidence("backward error", m.residual, "")
        };
        self.modes().iter().enumerate().filter(|(_, m)| self.unstable(m)).map(one).collect()
    }

    /// The least damped of the modes that do not grow.
    fn least_damped(&self, any_unstable: bool, any_grows: bool) -> Option<Finding> {
        let (slow, open) = (self.undamped.is_some(), decay_uncounted(self.system, self.study.speed).is_some());
        let decays = |(_, m): &(usize, &MachineMode)| !self.grows(m) && m.frequency() > 0.0 && !(slow && m.growth() > 0.0);
        let least = |far: bool| {
            let modes = self.modes().iter().enumerate().filter(decays);
            modes.filter(|(_, m)| whirl::far(m, self.study.speed) == far).max_by(|a, b| b.1.damping_ratio().total_cmp(&a.1.damping_ratio()))
        };
        // those that something may drive come first
        let (k, m) = least(false).or_else(|| least(true))?;
        let near = !whirl::far(m, self.study.speed) && self.modes().iter().any(|m| whirl::far(m, self.study.speed));
        let undamped = m.growth().abs() <= self.rounding;
        let among = match (open, any_unstable || any_grows) {
            (true, _) => "found",
            (_, true) if self.study.threshold < 0.0 => "stable",
            (_, true) => "decaying",
            _ => "all",
        };
        let (ratio, decrement) = match undamped {
            true => (0.0, 0.0),
            false => (m.damping_ratio(), -std::f64::consts::TAU * m.growth() / m.frequency()),
        };
        Some(
            Finding::info("least_damped_mode", "modes-least-damped")
                .of("damping ratio")
                .value(ratio, "")
                .arg("among", Arg::word(among))
                .arg("near", Arg::word(if near { "yes" } else { "no" }))
                .arg("mode", Arg::count(k + 1))
                .arg("whirl", whirl::direction(m.whirl.at(self.study.speed), m.forward_share))
                .arg("frequency", Arg::frequency(m.frequency()))
                .arg("damped", Arg::word(if undamped { "no" } else { "yes" }))
                .arg("decrement", Arg::number(decrement))
                .evidence("growth", m.growth(), "1/s")
                .evidence("rounding of the eigenvalues", self.rounding, "1/s"),
        )
    }

    /// Where no mode is unstable: whether the machine is stable. `slowly`: modes that grow, but less than counts.
    fn verdict(&self, slowly: &[usize]) -> Finding {
        let open = decay_uncounted(self.system, self.study.speed).is_some();
        let (slow, undamped) = (self.undamped.is_some(), self.undamped.unwrap_or(Words::PLAIN));
        let last = self.result.spectrum.least_stable();
        // roots at zero are no modes of the list
        let unheld = self.result.roots.as_ref().is_some_and(|r| r.at_zero.is_some());
        let largest = last.map_or(f64::NEG_INFINITY, MachineMode::growth).max(if unheld { 0.0 } else { f64::NEG_INFINITY });
        let zero = largest.abs() <= self.rounding;
        let searched = self.result.own.as_ref();
        let proven = self.result.roots.as_ref().is_none_or(|f| f.growing().is_some()) && searched.is_none_or(|o| o.counted());
        let part = searched.filter(|o| o.below + o.above > 0 || o.range.0 > 0.0);
        let free = unheld || last.is_some_and(|m| m.value.abs() <= self.rounding);
        let finding = if !proven {
            Finding::warning("stability_unknown", "modes-stability-unknown")
        } else if slow {
            let finding = match slowly {
                [] => Finding::info("stable", "modes-slow-growth-open"),
                [k, ..] => Finding::warning("slow_growth", "modes-slow-growth").arg("mode", Arg::count(k + 1)),
            };
            finding.arg("slower", Arg::count(slowly.len())).arg("part", Arg::term(undamped.name))
        } else if zero {
            Finding::info("stable", "modes-marginal").value(0.0, "1/s").arg("lacks", Arg::word(if free { "stiffness" } else { "damping" }))
        } else {
            // below a threshold above 0 modes may grow; where decaying roots are not counted, one that is not known may
            let may_grow = if open { self.threshold > 0.0 } else { largest > 0.0 };
            let finding = match (open, may_grow) {
                (true, false) => Finding::info("stable", "modes-stable-found"),
                (true, true) => Finding::info("stable", "modes-below-threshold-found"),
                (false, true) => Finding::info("stable", "modes-below-threshold"),
                (false, false) if part.is_some() => {
                    let (from, to) = part.map_or((f64::NAN, f64::NAN), |o| o.range);
                    let finding = Finding::info("stable", "modes-stable-between").arg("from", Arg::frequency(from));
                    finding.arg("to", Arg::frequency(to))
                }
                (false, false) if has_more_modes(self.system) => {
                    let frequency = self.result.roots.as_ref().map_or(f64::NAN, |r| r.frequency);
                    Finding::info("stable", "modes-stable-below").arg("frequency", Arg::frequency(frequency))
                }
                (false, false) => Finding::info("stable", "modes-stable"),
            };
            finding.value(largest, "1/s")
        };
        let finding = limit(finding.arg("speed", Arg::speed(self.study.speed)), self.threshold);
        finding.evidence("rounding of the eigenvalues", self.rounding, "1/s")
    }

    /// Whether roots may be missing, or were solved for.
    fn counts(&self, any_unstable: bool) -> Vec<Finding> {
        let spectrum = &self.result.spectrum;
        if let Some(roots) = &self.result.roots {
            return region::findings(self.system, self.study.speed, roots);
        }
        if holds_fit(self.system) {
            return vec![counted(self.result.growing, spectrum, any_unstable)];
        }
        if !wants_polish(self.system) {
            return Vec::new();
        }
        let (polished, all) = (spectrum.polished, spectrum.modes.len());
        let finding = if polished == all {
            Finding::info("polished", "modes-polished")
        } else {
            Finding::warning("polished", "modes-not-all-polished")
        };
        let finding = finding.arg("polished", Arg::count(polished)).arg("modes", Arg::count(all));
        vec![finding.evidence("polished modes", polished as f64, "")]
    }
}

/// Whether the growing roots found are all there are.
fn counted(count: Option<usize>, spectrum: &Spectrum, unstable: bool) -> Finding {
    let found = spectrum.modes.iter().filter(|m| m.value.re > 0.0).count();
    let finding = match count {
        Some(n) if n == found => Finding::info("all_roots", "modes-all-roots").arg("growing", Arg::count(n)),
        Some(n) => {
            let outcome = match (n, n > found) {
                (0, _) => "stable",
                (_, true) => "incomplete",
                _ => "doubtful",
            };
            let finding = Finding::warning("roots_missed", "modes-roots-missed").arg("growing", Arg::count(n));
            finding.arg("found", Arg::count(found)).arg("outcome", Arg::word(outcome))
        }
        None => {
            let word = if unstable { "yes" } else { "no" };
            Finding::warning("roots_not_counted", "modes-roots-not-counted").arg("unstable", Arg::word(word))
        }
    };
    finding.evidence("eigenvalues of the fit that are no roots", spectrum.left_out as f64, "")
}
