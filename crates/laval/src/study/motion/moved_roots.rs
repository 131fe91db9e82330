//! How far rational time forms move the roots of a machine: what motions with them are worth.

use crate::model::system::System;
use crate::model::timed::Timed;
use crate::outcome::{Arg, Finding, Message};
use crate::solve::characteristic::Characteristic;
use crate::solve::pencil::Linearised;
use crate::solve::rest::rest;
use crate::study::Context;
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

/// Most roots that are compared: those that grow or decay fastest.
const MOST: usize = 24;

/// How far rational time forms move the roots of a machine.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MovedRoots {
    /// Growth or decay from which on the error of the forms holds, 1/s; at 0 it holds for all that grows.
    pub margin: f64,
    /// Roots compared.
    pub compared: usize,
    /// Roots beside which the exact machine has none.
    pub lost: usize,
    /// Largest distance of a root from that of the exact machine, 1/s.
    pub moved: f64,
    /// Its frequency, rad/s.
    pub frequency: f64,
    /// Growing roots of the forms.
    pub growing: usize,
}

/// Roots of the form compared with those of the exact characteristic function beside them, where the error of the form holds.
pub(in crate::study) fn moved_roots(exact: &System, timed: &Timed, speed: f64, context: &Context) -> Option<MovedRoots> {
    let Timed::Fitted(form) = timed else { return None };
    let margin =
        form.slots().iter().filter_map(|s| s.part.replaced_in_time()?.fitted()).map(|f| f.margin * speed.abs()).fold(0.0, f64::max);
    let spectrum = Linearised::new(form, &rest(form, speed).ok()?).ok()?.spectrum().ok()?;
    // a form may have a ladder of decaying roots in place of a branch cut
    let holds = |growth: f64| if margin > 0.0 { growth.abs() >= margin } else { growth > 0.0 };
    let mut modes: Vec<_> = spectrum.modes.iter().filter(|m| holds(m.value.re) && m.value.im.abs() <= 5.0 * speed.abs()).collect();
    // the fastest growing first: they are what a motion shows
    modes.sort_by_number_down(|a| a.value.re);
    let about = rest(exact, speed).ok()?;
    let mut t = Characteristic::new(exact, &about);
    let (mut compared, mut worst, mut lost) = (0, (0.0, 0.0), 0);
    for mode in modes.iter().take(MOST) {
        if context.cancelled() {
            return None;
        }
        match t.polish(mode.value, mode.sector) {
            Some(p) if (p.value - mode.value).abs() <= 0.1 * mode.value.re.abs().max(0.01 * speed.abs()) => {
                compared += 1;
                let moved = (p.value - mode.value).abs();
                if !(moved <= worst.0) {
                    worst = (moved, p.value.im.abs());
                }
            }
            _ => lost += 1,
        }
    }
    let growing = modes.iter().filter(|m| m.value.re > 0.0).count();
    Some(MovedRoots { margin, compared, lost, moved: worst.0, frequency: worst.1, growing })
}

impl MovedRoots {
    pub(in crate::study) fn finding(&self) -> Finding {
        let MovedRoots { margin, compared, lost, growing, .. } = *self;
        let which = match margin > 0.0 {
            true => Message::new("moved-roots-beyond").arg("margin", Arg::quantity(margin, "1/s")),
            false => Message::new("moved-roots-growing"),
        };
        if compared == 0 && lost == 0 {
            return Finding::info("time_form_roots", "moved-roots-none").arg("roots", which);
        }
        let finding = match (compared, lost) {
            (_, 0) => Finding::info("time_form_roots", "moved-roots"),
            (0, _) => Finding::warning("time_form_roots", "moved-roots-all-lost"),
            _ => Finding::warning("time_form_roots", "moved-roots-lost"),
        };
        let finding = finding.arg("lost", Arg::count(lost)).arg("roots", which).value(self.moved, "1/s").evidence(
            "at frequency",
            self.frequency,
            "rad/s",
        );
        finding.evidence("roots compared", compared as f64, "").evidence("of the form, growing", growing as f64, "")
    }
}
