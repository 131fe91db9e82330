//! A sweep drawn.

use super::Shown;
use super::report::Path;
use crate::outcome::{Arg, Axis, Figure, Heat, Line, Message, Outcome, Panel, Points, Rule};
use crate::study::shared::probes;

/// Classes of figures.
const WAYS: &[&str] = &["rest", "up", "down"];
/// Panels of a figure.
const MOST_BODIES: usize = 4;
/// Lowest amplitude of a waterfall over its highest.
const DEPTH: f64 = 1e-3;

pub(super) fn figures(shown: &Shown, paths: &[Path], any: bool, mut outcome: Outcome) -> Outcome {
    if !any {
        return outcome;
    }
    let speed = || Axis::new("spin speed", "rad/s");
    let described = |key: &str| Message::new(key).arg("ways", Arg::List(paths.iter().map(|p| Arg::term(p.way.word())).collect()));
    let largest = |k: usize| paths.iter().flat_map(|p| &p.amplitude[k]).fold(0.0f64, |m, a| if *a > m { *a } else { m });
    let mut figure = Figure::new("amplitude", "Amplitude", described("sweep-alt")).x(speed());
    let resolved = |k: &usize| !shown.tilts(&shown.probes[*k]) || paths.iter().any(|p| largest(*k) > p.unresolved[*k]);
    let drawn: Vec<usize> = (0..shown.probes.len()).filter(resolved).collect();
    for tilt in [false, true] {
        for &k in drawn.iter().filter(|&&k| shown.probes[k].is_tilt() == tilt).take(MOST_BODIES) {
            let probe = &shown.probes[k];
            let axis = probes::axis(probes::size_of(probe), probe, largest(k));
            figure = figure.panel(Panel::new(axis).mark(Line::new("sweep", "speed", probes::column(probe)).group("start").nested()));
        }
    }
    outcome = outcome.figure(figure);
    let study = shown.study;
    let probe = &shown.probes[study.section.0];
    let name = probe.rows.0[study.section.1].first().map_or(probe.name.as_str(), |r| shown.system.coordinates()[r.0].name.as_str());
    let axis = probes::axis(Arg::name(name), probe, largest(study.section.0));
    let alt = described("sweep-alt-bifurcation").arg("state", Arg::name(name));
    let panel = Panel::new(axis).mark(Points::new("poincare", "speed", probes::quality(probe)).classes("start", WAYS));
    outcome = outcome.figure(Figure::new("bifurcation", "Bifurcation diagram", alt).x(speed()).panel(panel));
    if let Some(b) = study.waterfall {
        let tallest = outcome
            .find_table("waterfall")
            .and_then(|t| t.column("amplitude"))
            .map_or(0.0, |c| (0..c.data.len()).filter_map(|i| c.number(i)).filter(|x| x.is_finite()).fold(0.0, f64::max));
        let top = 1e6 * if tallest > 0.0 { tallest } else { 1e-6 };
        let colours = Axis::log("amplitude", "µm").factor(1e6).range(DEPTH * top, top);
        let heat = Heat::new("waterfall", "speed", "order", "amplitude", colours);
        let alt = Message::new("sweep-alt-waterfall").arg("body", Arg::name(&shown.stations[b].name));
        let alt = alt.arg("way", Arg::term(study.ways[0].word()));
        let panel =
            Panel::new(Axis::new("order", "")).mark(heat).mark(Rule::y(1.0, Message::new("label-order").arg("order", Arg::number(1.0))));
        outcome = outcome.figure(Figure::new("waterfall", "Order spectra", alt).x(speed()).panel(panel));
    }
    if study.lyapunov.is_some() {
        let alt = described("sweep-alt-lyapunov");
        let panel = Panel::new(Axis::new("Lyapunov exponent", "1/s"))
            .mark(Line::new("sweep", "speed", "lyapunov").group("start").nested())
            .mark(Rule::y(0.0, ""));
        outcome = outcome.figure(Figure::new("lyapunov", "Largest Lyapunov exponent", alt).x(speed()).panel(panel));
    }
    outcome
}
