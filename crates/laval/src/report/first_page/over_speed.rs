//! Amplitudes over the speed, with the unstable ranges, the operating speed and the jumps.

use crate::outcome::{Arg, Axis, Band, Figure, Line, Message, OverSpeed, Overview, Panel, Resonance, Rule, Scale, Table};

/// Name of the figure and of its table.
const NAME: &str = "over_speed";
/// Decades of growth shown below the largest.
const RANGE: f64 = 50.0;
/// Resonances named, at most.
const NAMED: usize = 4;

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

pub(in super::super) fn over_speed(page: &Overview, over: &OverSpeed) -> Figure {
    let (from, to) = over.shown;
    // ratios of speeds are what margins speak of
    let wide = to > 20.0 * from;
    let label = Message::new("axis-speed-plain");
    let x = if wide { Axis::log(label, "rad/s") } else { Axis::new(label, "rad/s") };
    let mut figure = Figure::new(NAME, Message::new("page-over-speed"), describe(over)).x(x.range(from, to));
    // the highest are named; without an unbalance that forces the machine all are alike
    let mut resonances: Vec<_> = over.resonances.iter().filter(|r| (from..=to).contains(&r.speed)).collect();
    let height = |r: &Resonance| r.amplitude.as_ref().map_or(0.0, |a| a.1);
    resonances.sort_by(|a, b| height(b).total_cmp(&height(a)));
    resonances.truncate(NAMED);
    let marks = |mut panel: Panel| {
        for r in &resonances {
            panel = panel.mark(Rule::x(r.speed, Message::new("strip-resonance")));
        }
        for w in over.jumps.iter().filter(|w| (from..=to).contains(*w)) {
            panel = panel.mark(Rule::x(*w, Message::new("strip-jump")));
        }
        for (a, b) in &over.unstable_response {
            panel = panel.mark(Band::x(*a, *b).strip().pink().name(Message::new("strip-response")));
        }
        if let Some((low, high)) = over.examined {
            for (a, b) in [(from, low), (high, to)].into_iter().filter(|(a, b)| b - a > 1e-9 * b) {
                panel = panel.mark(Band::x(a, b).strip().unknown().name(Message::new("strip-not-examined")));
            }
        }
        for u in &over.unstable {
            panel = panel.mark(Band::x(u.from, u.to).strip().name(Message::new("strip-unstable")));
        }
        if let Some((a, b)) = page.operating_range {
            panel = panel.mark(Band::x(a, b).name(Message::new("axis-operating-range")).neutral());
        }
        if let Some(w) = page.operating.filter(|w| (from..=to).contains(w)) {
            panel = panel.mark(Rule::x(w, Message::new("axis-operating")));
        }
        panel
    };
    if !over.amplitudes.is_empty() {
        let most = over.amplitudes.iter().flat_map(|a| &a.1).copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
        let axis = Axis { scale: Scale::Log, ..Axis::new(Message::new("axis-amplitude"), "").metres(most.min(1e-3)) };
        let mut panel = Panel::new(axis);
        for (k, (name, _)) in over.amplitudes.iter().enumerate() {
            panel = panel.mark(Line::new(NAME, "speed", format!("amplitude_{k}")).name(name.clone()));
        }
        figure = figure.panel(marks(panel));
    }
    if !over.growth.is_empty() {
        let mut axis = Axis::new(Message::new("axis-growth"), "1/s");
        // a strong instability far away must not hide how close the rest is to its limit
        let (low, high) = over.growth.iter().fold((0.0f64, 0.0f64), |(a, b), x| (a.min(*x), b.max(*x)));
        let near = page.operating.map_or(f64::INFINITY, |w| nearest(over, w).abs());
        let room = (RANGE * near).max(0.02 * (high - low));
        if high - low > 4.0 * room {
            axis = axis.range((1.05 * low).max(-room), (1.05 * high).min(room));
        }
        let panel = Panel::new(axis).mark(Line::new("growth", "speed", "growth").name(Message::new("axis-growth"))).mark(Rule::y(
            over.threshold,
            if over.threshold == 0.0 { Message::new("strip-stable-limit").into() } else { Arg::term("threshold") },
        ));
        figure = figure.panel(marks(panel));
    }
    figure
}

/// Growth at the speed nearest to this one.
fn nearest(over: &OverSpeed, speed: f64) -> f64 {
    let pairs = over.growth_speed.iter().zip(&over.growth);
    pairs.min_by(|a, b| (a.0 - speed).abs().total_cmp(&(b.0 - speed).abs())).map_or(f64::INFINITY, |p| *p.1)
}

fn describe(over: &OverSpeed) -> Message {
    Message::new(match (over.amplitudes.is_empty(), over.growth.is_empty()) {
        (false, false) => "caption-both",
        (false, true) => "caption-amplitude",
        _ => "caption-growth",
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::draw;

    /// Speeds of 1 rad/s to 100 rad/s, of which stability was examined from 10 rad/s to 60 rad/s, and operating speeds of 40 rad/s to 50 rad/s: areas of unlike colours,
    /// each with its name in the legend.
    #[test]
    fn what_was_not_examined_is_unlike_the_operating_speeds() {
        let speeds: Vec<f64> = (10..=60).map(f64::from).collect();
        let over = OverSpeed {
            range: (1.0, 100.0),
            shown: (1.0, 100.0),
            growth: vec![-1.0; speeds.len()],
            growth_speed: speeds,
            examined: Some((10.0, 60.0)),
            ..OverSpeed::default()
        };
        let page = Overview { operating: Some(50.0), operating_range: Some((40.0, 50.0)), ..Overview::default() };
        let svg = draw(&over_speed(&page, &over), &tables(&over)).unwrap();
        for (name, class) in [("stability not examined", "b4"), ("operating speeds", "b2")] {
            assert!(svg.contains(name), "{name}: {svg}");
            // in the panel and in the legend
            assert!(svg.matches(&format!(r#"<path class="{class}""#)).count() >= 2, "{class}: {svg}");
        }
    }
}
