//! What the modes at one speed say.

use super::report::Shown;
use crate::model::part::Words;
use crate::outcome::{Finding, quantity};
use crate::solve::pencil::{MachineMode, Spectrum, Whirl, holds_fit, wants_polish};
use crate::study::shared::region;
use crate::study::shared::support::{decay_uncounted, remarks};

impl Shown<'_> {
    pub fn findings(&self) -> Vec<Finding> {
        let mut out = self.unstable_modes();
        let any_unstable = !out.is_empty();
        if any_unstable && self.threshold > self.study.threshold {
            let name = self.undamped.unwrap_or(Words::PLAIN).name;
            let text = format!("Modes count as unstable from a growth rate of {{}} on: slower waves of {name} are not all computed.");
            out.push(Finding::info("threshold", text).value(self.threshold, "1/s"));
        }
        let modes = self.modes();
        let slowly: Vec<usize> = (0..modes.len()).filter(|&k| self.grows(&modes[k]) && !self.unstable(&modes[k])).collect();
        let least = self.least_damped(any_unstable, !slowly.is_empty());
        let verdict = (!any_unstable).then(|| self.verdict(&slowly));
        // what grows comes first
        let (first, second) = if slowly.is_empty() { (least, verdict) } else { (verdict, least) };
        out.extend(first.into_iter().chain(second));
        out.extend(self.counts(any_unstable));
        let infinite = self.result.spectrum.infinite;
        if infinite > 0 {
            let text = format!("{infinite} eigenvalues are infinite: some coordinates have no mass.");
            out.push(Finding::info("massless", text));
        }
        out.extend(remarks(self.system, &self.result.about));
        out
    }

    fn unstable_modes(&self) -> Vec<Finding> {
        let one = |(k, m): (usize, &MachineMode)| {
            let what = if m.frequency() > 0.0 {
                format!("whirls{} at {}", direction(m.whirl.at(self.study.speed)), quantity(m.frequency(), "rad/s"))
            } else {
                "moves away without oscillation".into()
            };
            Finding::warning("unstable_mode", format!("Mode {} is unstable: it {what} and grows at {{}}.", k + 1))
                .value(m.growth(), "1/s")
                .evidence("error of the eigenvalue", m.error, "1/s")
                .evidence("backward error", m.residual, "")
        };
        self.modes().iter().enumerate().filter(|(_, m)| self.unstable(m)).map(one).collect()
    }

    /// The least damped of the modes that do not grow.
    fn least_damped(&self, any_unstable: bool, any_grows: bool) -> Option<Finding> {
        let (slow, open) = (self.undamped.is_some(), decay_uncounted(self.system, self.study.speed).is_some());
        let modes = self.modes().iter().enumerate();
        let (k, m) = modes
            .filter(|(_, m)| !self.grows(m) && m.frequency() > 0.0 && !(slow && m.growth() > 0.0))
            .max_by(|a, b| b.1.damping_ratio().total_cmp(&a.1.damping_ratio()))?;
        let undamped = m.growth().abs() <= self.rounding;
        let text = format!(
            "{} mode {} at {} ({}): {}.",
            match (open, any_unstable || any_grows) {
                (true, _) => "Of the modes that decay and were found the least damped is",
                (_, true) if self.study.threshold < 0.0 => "The least damped stable mode is",
                (_, true) => "Of the modes that decay the least damped is",
                _ => "The least damped mode is",
            },
            k + 1,
            quantity(m.frequency(), "rad/s"),
            m.whirl.at(self.study.speed).of("whirl", m.forward_share),
            if undamped { "its damping is zero to rounding" } else { "damping ratio {}" }
        );
        let ratio = if undamped { 0.0 } else { m.damping_ratio() };
        let finding = Finding::info("least_damped_mode", text).of("damping ratio").value(ratio, "").evidence("growth", m.growth(), "1/s");
        Some(finding.evidence("rounding of the eigenvalues", self.rounding, "1/s"))
    }

    /// Where no mode is unstable: whether the machine is stable. `slowly`: modes that grow, but less than counts.
    fn verdict(&self, slowly: &[usize]) -> Finding {
        let open = decay_uncounted(self.system, self.study.speed).is_some();
        let (slow, undamped) = (self.undamped.is_some(), self.undamped.unwrap_or(Words::PLAIN));
        let last = self.result.spectrum.least_stable();
        let largest = last.map_or(f64::NEG_INFINITY, MachineMode::growth);
        let zero = largest.abs() <= self.rounding;
        let (at, limit) = (quantity(self.study.speed, "rad/s"), quantity(self.threshold, "1/s"));
        let proven = self.result.roots.as_ref().is_none_or(|f| f.growing().is_some());
        let text = if !proven {
            format!(
                "Whether the machine is stable at {at} is not known: no mode was found that grows faster than {limit}, but some may be missing."
            )
        } else if slow {
            let slower = match slowly {
                [] => "none of the modes found grows more slowly".to_string(),
                [k] => format!("one of the modes found grows more slowly, mode {}", k + 1),
                all => format!("{} of the modes found grow more slowly", all.len()),
            };
            format!("At {at} no mode grows faster than {limit}; {slower}. Slow waves of {} are not all computed.", undamped.name)
        } else if zero {
            let why = if last.is_some_and(|m| m.value.abs() <= self.rounding) { "no stiffness holds it" } else { "nothing damps it" };
            format!("Neither stable nor unstable at {at}: the largest growth rate is zero to rounding; {why}.")
        } else if open {
            format!(
                "Stable at {at}: no mode grows faster than {limit}; the largest growth rate that was found is {{}}, one that decays more slowly may be missing."
            )
        } else {
            format!("Stable at {at}: no mode grows faster than {limit}; the largest growth rate is {{}}.")
        };
        let finding = match (proven, slow) {
            (false, _) => Finding::warning("stability_unknown", text),
            (_, true) if !slowly.is_empty() => Finding::warning("slow_growth", text),
            (_, true) => Finding::info("stable", text),
            _ => Finding::info("stable", text).value(if zero { 0.0 } else { largest }, "1/s"),
        };
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
        let text = format!("{polished} of {all} modes were solved for on the exact characteristic function.");
        let finding = if polished == all { Finding::info("polished", text) } else { Finding::warning("polished", text) };
        vec![finding.evidence("polished modes", polished as f64, "")]
    }
}

/// Whether the growing roots found are all there are.
fn counted(count: Option<usize>, spectrum: &Spectrum, unstable: bool) -> Finding {
    let found = spectrum.modes.iter().filter(|m| m.value.re > 0.0).count();
    let roots = |n: usize| match n {
        0 => "no growing root".to_string(),
        1 => "one growing root".to_string(),
        n => format!("{n} growing roots"),
    };
    let finding = match count {
        Some(n) if n == found => {
            let (all, text) = (spectrum.modes.len(), roots(n));
            Finding::info(
                "all_roots",
                format!(
                    "The {all} modes are roots of the exact characteristic function, which has {text} by the argument principle: of those that grow none is missed."
                ),
            )
        }
        Some(n) => Finding::warning(
            "roots_missed",
            format!(
                "The exact characteristic function has {} by the argument principle, but {} {} found{}.",
                roots(n),
                roots(found),
                if found > 1 { "were" } else { "was" },
                if n > 0 { ": the machine is unstable" } else { "" }
            ),
        ),
        None => Finding::warning(
            "roots_not_counted",
            format!(
                "The modes are roots of the exact characteristic function; whether others grow{} could not be counted.",
                if unstable { " too" } else { "" }
            ),
        ),
    };
    finding.evidence("eigenvalues of the fit that are no roots", spectrum.left_out as f64, "")
}

fn direction(whirl: Whirl) -> &'static str {
    match whirl {
        Whirl::Forward => " forward",
        Whirl::Backward => " backward",
        Whirl::Mixed | Whirl::None => "",
    }
}
