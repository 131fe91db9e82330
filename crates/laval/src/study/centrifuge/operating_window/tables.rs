//! Tables of an operating window.

use super::MAP_PLACES;
use super::margins::{Margin, NAMES, Point};
use super::report::{Built, Shown};
use super::window::End;
use crate::outcome::{Arg, Message, Table, parameter_name};

impl Shown<'_> {
    pub fn margins_table(&self) -> Built<Table> {
        let rows: Vec<(&Point, &Margin)> = self.found.main.points.iter().flat_map(|p| p.margins.iter().map(move |m| (p, m))).collect();
        Table::new("margins", "Every requirement over the speed; kept where the margin is 0 or more")
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| r.0.speed).collect())
            .text("requirement", "name of the requirement", rows.iter().map(|r| NAMES[r.1.name].into()).collect())
            .float(
                "margin",
                "",
                "margin, for stable and clear a distance in speed; NaN where it is not defined, which counts as not kept",
                rows.iter().map(|r| finite(r.1.value)).collect(),
            )
            .flag("kept", "the requirement is kept", rows.iter().map(|r| r.1.value >= 0.0).collect())
            .float(
                "shown",
                "",
                "margin between -1 and 1, for the figure; NaN where it is not defined",
                rows.iter().map(|r| finite(r.1.value).clamp(-1.0, 1.0)).collect(),
            )
            .phrases("by", "what binds in it", rows.iter().map(|r| (r.1.detail.cell(), r.1.detail.shown())).collect())
            .build()
    }

    /// Requirements evaluated, in the order they are shown.
    pub fn required(&self) -> Vec<usize> {
        let points = &self.found.main.points;
        (0..NAMES.len()).filter(|k| points.iter().any(|p| p.margins.iter().any(|m| m.name == *k))).collect()
    }

    /// Ranges of speed in which each requirement is kept, and in which it is not: bars of the figure.
    pub fn bars_table(&self) -> Built<Table> {
        let required = self.required();
        let (mut speed, mut names) = (Vec::new(), Vec::new());
        let mut sides: [Vec<f64>; 4] = Default::default();
        for (k, &name) in required.iter().enumerate() {
            let value = |p: &Point| p.margins.iter().find(|m| m.name == name).map_or(f64::NAN, |m| m.value);
            let points: Vec<(f64, f64)> = self.found.main.points.iter().map(|p| (p.speed, value(p))).collect();
            let place = (required.len() - k) as f64;
            let mut from = points.first().map_or(f64::NAN, |p| p.0);
            let mut rest = &points[..];
            while let Some(first) = rest.first() {
                let kept = first.1 >= 0.0;
                let run = rest.iter().take_while(|p| (p.1 >= 0.0) == kept).count();
                let to = match (rest[run - 1], rest.get(run)) {
                    (a, None) => a.0,
                    // where the margin is zero between two speeds, or half way to one without a margin
                    (a, Some(b)) if a.1.is_finite() && b.1.is_finite() => a.0 + (b.0 - a.0) * a.1 / (a.1 - b.1),
                    (a, Some(b)) => 0.5 * (a.0 + b.0),
                };
                let half = if kept { 0.34 } else { 0.2 };
                for w in [from, to, f64::NAN] {
                    speed.push(w);
                    names.push(NAMES[name].to_string());
                    let own = [place - half, place + half];
                    let none = [f64::NAN; 2];
                    let [good, bad] = if kept { [own, none] } else { [none, own] };
                    sides.iter_mut().zip([good[0], good[1], bad[0], bad[1]]).for_each(|(s, v)| s.push(v));
                }
                (from, rest) = (to, &rest[run..]);
            }
        }
        let [good_low, good_high, bad_low, bad_high] = sides;
        Table::new("requirements", "Ranges of speed in which each requirement is kept: bars of the figure")
            .float("speed", "rad/s", "ends of a range; NaN between ranges", speed)
            .text("requirement", "name of the requirement", names)
            .float("kept low", "", "lower side of the bar where it is kept; NaN where it is not", good_low)
            .float("kept high", "", "upper side; NaN where it is not kept", good_high)
            .float("broken low", "", "lower side of the bar where it is not kept; NaN where it is", bad_low)
            .float("broken high", "", "upper side; NaN where it is kept", bad_high)
            .build()
    }

    pub fn points_table(&self) -> Built<Table> {
        let p = &self.found.main.points;
        let column = |f: &dyn Fn(&Point) -> f64| p.iter().map(|x| finite(f(x))).collect::<Vec<f64>>();
        Table::new("speeds", "The machine at every speed computed")
            .float("speed", "rad/s", "spin speed", column(&|x| x.speed))
            .flag("inside", "all requirements are kept", p.iter().map(Point::feasible).collect())
            .float("least margin", "", "least margin; NaN where a requirement is not defined", column(&|x| x.least()))
            .text(
                "binding",
                "requirement with the least margin",
                p.iter().map(|x| x.binding().map_or("", |m| NAMES[m.name]).into()).collect(),
            )
            .float(
                "time",
                "s",
                "time to reach the recovery, run-up as requested; NaN where nothing is to be separated or it is never reached",
                column(&|x| x.needed),
            )
            .float("tilt", "rad", "tilt of the cups; NaN without cups", column(&|x| x.tilt))
            .float("unbalance", "kg m", "unbalance of the cups; NaN where it cannot be computed", column(&|x| x.unbalance))
            .float(
                "growth",
                "1/s",
                "largest growth rate, before and after the separation; NaN where there is none to tell",
                column(&|x| x.growth),
            )
            .int("states", "", "number of steady states met", p.iter().map(|x| x.states as i64).collect())
            .float(
                "energy",
                "J",
                "kinetic energy of the spin and work of the drive in the available time; NaN where it cannot be computed",
                column(&|x| x.energy),
            )
            .build()
    }

    pub fn intervals_table(&self) -> Built<Table> {
        let i = &self.found.main.intervals;
        Table::new("window", "Intervals in which all requirements are kept")
            .float("low", "rad/s", "lowest speed", i.iter().map(|x| x.low.speed).collect())
            .float("high", "rad/s", "highest speed", i.iter().map(|x| x.high.speed).collect())
            .text("low binding", "requirement that ends it below", i.iter().map(|x| x.low.binding.clone()).collect())
            .text("high binding", "requirement that ends it above", i.iter().map(|x| x.high.binding.clone()).collect())
            .text("low event", "crossing, jump, eigenvalue crossing or domain limit", i.iter().map(|x| x.low.event.into()).collect())
            .text("high event", "crossing, jump, eigenvalue crossing or domain limit", i.iter().map(|x| x.high.event.into()).collect())
            .phrases("low reason", "why it ends below", i.iter().map(|x| self.reason_cell(&x.low)).collect())
            .phrases("high reason", "why it ends above", i.iter().map(|x| self.reason_cell(&x.high)).collect())
            .float("low bracket", "rad/s", "width of the bracket", i.iter().map(|x| x.low.bracket).collect())
            .float("high bracket", "rad/s", "width of the bracket", i.iter().map(|x| x.high.bracket).collect())
            .float(
                "relative width",
                "",
                "width over the mean speed",
                i.iter().map(|x| 2.0 * (x.high.speed - x.low.speed) / (x.high.speed + x.low.speed)).collect(),
            )
            .build()
    }

    /// Window over the available time: in each mechanical interval, from the speed at which the time needed falls below it.
    pub fn trade_table(&self) -> Built<Option<Table>> {
        let m = &self.found.main;
        let Some(task) = &self.task else { return Ok(None) };
        let (mut time, mut low, mut high) = (vec![], vec![], vec![]);
        for k in 0..=40 {
            let t = task.time * 10f64.powf(-1.0 + 2.0 * k as f64 / 40.0);
            for i in &m.mechanical {
                let inside: Vec<&Point> =
                    m.points.iter().filter(|p| p.speed >= i.low.speed && p.speed <= i.high.speed && p.needed.is_finite()).collect();
                let Some(first) = inside.iter().position(|p| p.needed <= t) else { continue };
                let at = inside[first];
                // straight in the logarithms between the points of the scan
                let start = match first.checked_sub(1).map(|b| inside[b]) {
                    Some(b) if b.needed > at.needed => {
                        let share = ((b.needed / t).ln() / (b.needed / at.needed).ln()).clamp(0.0, 1.0);
                        b.speed * (at.speed / b.speed).powf(share)
                    }
                    _ => at.speed,
                };
                time.push(t);
                low.push(start);
                high.push(i.high.speed);
            }
        }
        Table::new("trade", "Window over the available time (lower end interpolated in the scan)")
            .float("time", "s", "available time", time)
            .float("low", "rad/s", "lowest speed", low)
            .float("high", "rad/s", "highest speed", high)
            .build()
            .map(Some)
    }

    pub fn map_table(&self) -> Built<Option<Table>> {
        let Some(map) = &self.found.map else { return Ok(None) };
        let c = &map.cells;
        let doc =
            Message::new("operating-window-table-map").arg("parameter", parameter_name(&map.path)).arg("places", Arg::count(MAP_PLACES));
        let mut table = Table::new("map", doc)
            .float("speed", "rad/s", "spin speed", c.iter().map(|c| c.speed).collect())
            .float(&map.path, map.unit, "parameter", c.iter().map(|c| c.value).collect())
            .float("margin", "", "least margin, not below -1", c.iter().map(|c| c.margin).collect())
            .text("binding", "requirement with the least margin", c.iter().map(|c| c.binding.into()).collect());
        if map.unit == "K" {
            table = table.float("celsius", "degC", "parameter in degrees Celsius", c.iter().map(|c| c.value - 273.15).collect());
        }
        table.build().map(Some)
    }

    /// The reason of an end.
    /// In words, and as the finding says it.
    fn reason_cell(&self, e: &End) -> (String, Arg) {
        let what = e.detail.cell();
        let what = if what.is_empty() { &e.binding } else { &what };
        let words = match e.event {
            "domain limit" => "the range of speeds ends".into(),
            _ if e.detail.undefined() => what.clone(),
            "jump" if e.states[1] > 1 => format!("{what} exceeds its limit in one of {} stable states", e.states[1]),
            "jump" => format!("{what} exceeds its limit"),
            _ => format!("{what} reaches its limit"),
        };
        let shown = if e.event == "domain limit" { Arg::term(&words) } else { self.reason(e, self.fold(e).is_some()).into() };
        (words, shown)
    }
}

fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { f64::NAN }
}
