//! Amplitudes over the speed, with the unstable ranges, the operating speed and the jumps.

use super::super::words::Style;
use crate::outcome::{Axis, Band, Figure, Line, Message, OverSpeed, Overview, Panel, Rule, Scale, Table};

/// Name of the figure and of its table.
const NAME: &str = "over_speed";
/// Decades of growth shown below the largest.
const RANGE: f64 = 50.0;

/// The tables that the figure draws.
pub(in super::super) fn tables(over: &OverSpeed) -> Vec<Table> {
    let mut response = Table::new(NAME, "").float("speed", "rad/s", "spin speed", over.response_speed.clone());
    for (k, (name, values)) in over.amplitudes.iter().enumerate() {
        response = response.float(format!("amplitude_{k}"), "m", name.clone(), values.clone());
    }
    let growth = Table::new("growth", "").float("speed", "rad/s", "spin speed", over.growth_speed.clone());
    let growth = growth.float("growth", "1/s", "largest growth rate", over.growth.clone());
    [response.build(), growth.build()].into_iter().filter_map(Result::ok).collect()
}

pub(in super::super) fn over_speed(page: &Overview, over: &OverSpeed, style: &Style) -> Figure {
    let say = |key: &str| style.message(&Message::new(key));
    let speed = style.units.speed();
    let (from, to) = over.shown;
    // ratios of speeds are what margins speak of
    let wide = to > 20.0 * from;
    let label = style.message(&Message::new("axis-speed-plain"));
    let unit = style.language.unit(&speed.name);
    let x = if wide { Axis::log(label, unit) } else { Axis::new(label, unit) };
    let x = x.factor(1.0 / speed.size).range(from / speed.size, to / speed.size);
    let mut figure = Figure::new(NAME, say("page-over-speed"), describe(page, over, style)).x(x);
    let marks = |mut panel: Panel| {
        for u in &over.unstable {
            panel = panel.mark(Band::x(u.from, u.to).strip().name(say("strip-unstable")));
        }
        if let Some((a, b)) = page.operating_range {
            panel = panel.mark(Band::x(a, b).name(say("axis-operating-range")).neutral());
        }
        if let Some(w) = page.operating.filter(|w| (from..=to).contains(w)) {
            panel = panel.mark(Rule::x(w, say("axis-operating")));
        }
        panel
    };
    if !over.amplitudes.is_empty() {
        let most = over.amplitudes.iter().flat_map(|a| &a.1).copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
        let axis = Axis { scale: Scale::Log, ..Axis::new(say("axis-amplitude"), "").metres(most.min(1e-3)) };
        let mut panel = Panel::new(axis);
        for (k, (name, _)) in over.amplitudes.iter().enumerate() {
            panel = panel.mark(Line::new(NAME, "speed", format!("amplitude_{k}")).name(name));
        }
        figure = figure.panel(marks(panel));
    }
    if !over.growth.is_empty() {
        let mut axis = Axis::new(say("axis-growth"), "1/s");
        // a strong instability far away must not hide how close the rest is to its limit
        let (low, high) = over.growth.iter().fold((0.0f64, 0.0f64), |(a, b), x| (a.min(*x), b.max(*x)));
        let near = page.operating.map_or(f64::INFINITY, |w| nearest(over, w).abs());
        let room = (RANGE * near).max(0.02 * (high - low));
        if high - low > 4.0 * room {
            axis = axis.range((1.05 * low).max(-room), (1.05 * high).min(room));
        }
        let panel = Panel::new(axis)
            .mark(Line::new("growth", "speed", "growth").name(say("axis-growth")))
            .mark(Rule::y(0.0, say("strip-stable-limit")));
        figure = figure.panel(marks(panel));
    }
    figure
}

/// Growth at the speed nearest to this one.
fn nearest(over: &OverSpeed, speed: f64) -> f64 {
    let pairs = over.growth_speed.iter().zip(&over.growth);
    pairs.min_by(|a, b| (a.0 - speed).abs().total_cmp(&(b.0 - speed).abs())).map_or(f64::INFINITY, |p| *p.1)
}

fn describe(page: &Overview, over: &OverSpeed, style: &Style) -> String {
    let key = match (over.amplitudes.is_empty(), over.growth.is_empty()) {
        (false, false) => "caption-both",
        (false, true) => "caption-amplitude",
        _ => "caption-growth",
    };
    let _ = page;
    style.message(&Message::new(key))
}
