//! How modes move, as arguments of findings.

use crate::outcome::{Arg, Finding, Message};
use crate::solve::pencil::{FLAT, MachineMode, Whirl};
use laval_num::complex::C64;

/// The phrase `forward whirl`; where neither direction leads, with the forward share of the squared amplitudes.
pub(in crate::study) fn direction(whirl: Whirl, forward_share: f64) -> Message {
    // the forward share of an orbit whose circles differ by FLAT, less that of a line
    let flat = (1.0 + FLAT).powi(2) / (1.0 + (1.0 + FLAT).powi(2)) - 0.5;
    let phrase = Message::new("whirl-direction");
    match whirl {
        Whirl::Mixed if (forward_share - 0.5).abs() <= flat => phrase.arg("whirl", Arg::word("straight")),
        Whirl::Mixed => phrase.arg("whirl", Arg::word("mixed")).arg("forward_share", Arg::percent(forward_share)),
        _ => phrase.arg("whirl", Arg::word(whirl.word())),
    }
}

/// A root that is real but for rounding: Newton's method on the characteristic function leaves a trace of a frequency.
pub(in crate::study) fn aperiodic(root: C64) -> bool {
    root.im.abs() <= 1e-9 * root.re.abs()
}

/// Frequency over the fastest speed above which nothing drives a mode: of a shaft it is one of its division.
const FAR: f64 = 10.0;

/// The modes that a reader looks for: those that grow, then those of the lowest frequencies, `most` at most, by number. Modes far above the fastest speed (rad/s) only
/// where too few are below.
pub(in crate::study) fn lowest(
    modes: &[MachineMode],
    among: impl IntoIterator<Item = usize>,
    fastest: f64,
    most: usize,
    grows: impl Fn(&MachineMode) -> bool,
) -> Vec<usize> {
    let mut all: Vec<usize> = among.into_iter().collect();
    // aperiodic roots that decay tell least
    let rank = |k: &usize| (!grows(&modes[*k]), far(&modes[*k], fastest), aperiodic(modes[*k].value));
    all.sort_by(|a, b| rank(a).cmp(&rank(b)).then(modes[*a].frequency().total_cmp(&modes[*b].frequency())));
    all.truncate(most);
    all.sort_unstable();
    all
}

/// The frequency of a mode is far above what drives it.
pub(in crate::study) fn far(m: &MachineMode, fastest: f64) -> bool {
    m.frequency() > FAR * fastest.abs()
}

/// Adds how an unstable mode moves at a spin speed: the word `whirl`, and the frequency where it oscillates.
pub(in crate::study) fn growing(finding: Finding, m: &MachineMode, speed: f64) -> Finding {
    let word = match m.whirl.at(speed) {
        _ if aperiodic(m.value) => "none",
        w @ (Whirl::Forward | Whirl::Backward) => w.word(),
        Whirl::Mixed | Whirl::Axial | Whirl::Torsional | Whirl::None => "vibration",
    };
    let finding = finding.arg("whirl", Arg::word(word));
    if word == "none" { finding } else { finding.arg("frequency", Arg::frequency(m.frequency())) }
}
