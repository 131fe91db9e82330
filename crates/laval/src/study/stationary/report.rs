//! Tables, findings and figures of the states.

use super::classify::{Class, Seen, WORDS};
use super::least::Least;
use super::{Context, Row, Stabilise, Study};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{
    Axis, Figure, Finding, Line, Outcome, OutcomeError, Panel, Points, Rule, SpecialPoint, Status, Table, quantity, significant,
};
use crate::solve::stationary::{Change, Found, Located, Path, Search};
use laval_num::continuation::End;

/// What is to be told.
pub(super) struct Report<'a, 'b> {
    pub system: &'a System,
    pub search: &'a Search<'b>,
    pub range: (f64, f64),
    pub found: &'a Found,
    pub rows: Vec<Row>,
    pub stabilise: Option<&'a Stabilise>,
    pub least: Option<Least>,
}

/// A point of a branch with what it shows.
struct Shown {
    path: usize,
    speed: f64,
    seen: Seen,
    class: Class,
    growing: usize,
    growth: f64,
}

/// A range of speeds in which states of one class are stable along one branch.
struct Range {
    class: Class,
    path: usize,
    from: f64,
    to: f64,
}

impl Report<'_, '_> {
    pub fn outcome(&self, context: &Context) -> Result<Outcome, Diagnostic> {
        let found = self.found;
        let points = self.points();
        let complete = !found.stopped && found.paths.iter().all(|p| p.branch.end != End::Cancelled);
        let mut out = Outcome::new(super::Stationary::KIND, context.name)
            .over("speed", "rad/s")
            .end(context.end(complete))
            .work("starts", found.starts[0])
            .work("points", found.paths.iter().map(|p| p.points.len() as u64).sum());
        let ranges = self.ranges(&points);
        for f in self.findings(&ranges) {
            out = out.finding(f);
        }
        for (k, path) in found.paths.iter().enumerate() {
            for l in &path.special {
                out = out.special_point(self.special(k, l));
            }
        }
        let tables = || -> Result<Vec<Table>, OutcomeError> {
            let mut all = Vec::new();
            if !self.rows.is_empty() {
                all.extend([self.states()?, self.eigenvalues()?]);
            }
            if !points.is_empty() {
                all.push(self.branches(&points)?);
            }
            if found.paths.iter().any(|p| !p.special.is_empty()) {
                all.push(self.changes()?);
            }
            if let (Some(least), Some(asked)) = (&self.least, self.stabilise) {
                all.push(self.parameter(least, asked)?);
            }
            Ok(all)
        };
        for t in tables().map_err(Diagnostic::from)? {
            out = out.table(t);
        }
        if !points.is_empty() {
            out = out.figure(self.figure(&ranges));
        }
        out.checked().map_err(Diagnostic::from)
    }

    /// The points of all branches, classified among each other; points of other branches at nearly the same speed serve as measure.
    fn points(&self) -> Vec<Shown> {
        let mut out = Vec::new();
        for (k, path) in self.found.paths.iter().enumerate() {
            for p in &path.points {
                let seen = Seen::of(self.system, self.search, &p.state);
                let (growing, growth) = (p.stability.growing, p.stability.growth());
                out.push(Shown { path: k, speed: p.state.speed, seen, class: Class::Single, growing, growth });
            }
        }
        // the largest displacement at any speed nearby: amplitudes change by orders over the range
        let width = 0.02 * (self.range.1 - self.range.0);
        let mut order: Vec<usize> = (0..out.len()).collect();
        order.sort_by(|&a, &b| out[a].speed.total_cmp(&out[b].speed));
        for &i in &order {
            let first = order.partition_point(|&j| out[j].speed < out[i].speed - width);
            let last = order.partition_point(|&j| out[j].speed <= out[i].speed + width);
            let near: Vec<Seen> = order[first..last].iter().map(|&j| out[j].seen.clone()).collect();
            let scale = Seen::largest(&near);
            out[i].class = out[i].seen.class(&scale);
        }
        out
    }

    /// Where states of a class are stable: from located change to located change.
    fn ranges(&self, points: &[Shown]) -> Vec<Range> {
        let mut out: Vec<Range> = Vec::new();
        let mut first = 0;
        for (k, path) in self.found.paths.iter().enumerate() {
            let own = &points[first..first + path.points.len()];
            first += own.len();
            let edge = |i: usize| {
                let (a, b) = (own[i].speed.min(own[i + 1].speed), own[i].speed.max(own[i + 1].speed));
                let inside = |l: &&Located| l.state.speed >= a - 1e-9 * b.abs() && l.state.speed <= b + 1e-9 * b.abs();
                path.special.iter().find(inside).map_or(0.5 * (a + b), |l| l.state.speed)
            };
            let mut i = 0;
            while i < own.len() {
                if own[i].growing > 0 {
                    i += 1;
                    continue;
                }
                let (begin, class) = (i, own[i].class);
                while i + 1 < own.len() && own[i + 1].growing == 0 && own[i + 1].class == class {
                    i += 1;
                }
                let from = if begin == 0 { own[0].speed } else { edge(begin - 1) };
                let to = if i + 1 == own.len() { own[i].speed } else { edge(i) };
                out.push(Range { class, path: k, from: from.min(to), to: from.max(to) });
                i += 1;
            }
        }
        // images of one branch tell the same
        let tolerance = 1e-7 * self.range.1.abs();
        let mut kept: Vec<Range> = Vec::new();
        for r in out {
            let same = |o: &Range| o.class == r.class && (o.from - r.from).abs() < tolerance && (o.to - r.to).abs() < tolerance;
            if !kept.iter().any(same) {
                kept.push(r);
            }
        }
        kept.sort_by(|a, b| (a.class, a.path).cmp(&(b.class, b.path)).then(a.from.total_cmp(&b.from)));
        kept
    }

    fn findings(&self, ranges: &[Range]) -> Vec<Finding> {
        let mut out = Vec::new();
        let found = self.found;
        for (slot, text) in self.system.warnings() {
            let name = &self.system.slots()[slot].name;
            out.push(Finding::warning("hindered", format!("\"{name}\": {text}.")).of(name));
        }
        let (a, b) = (quantity(self.range.0, "rad/s"), quantity(self.range.1, "rad/s"));
        for r in ranges {
            let balances = r.class <= Class::PartlyBalanced;
            let id = if balances { "balanced_stable" } else { "stable_states" };
            let whole = r.from <= self.range.0 && r.to >= self.range.1;
            let place =
                if whole { "over the whole range, up to {}".to_string() } else { format!("from {} to {{}}", quantity(r.from, "rad/s")) };
            let text = format!("Branch {} ({}) is stable {place}.", r.path + 1, r.class.words());
            out.push(
                Finding::info(id, text)
                    .of(format!("branch {} from {}", r.path + 1, significant(r.from, 6)))
                    .value(r.to, "rad/s")
                    .evidence("from", r.from, "rad/s"),
            );
        }
        if ranges.is_empty() && !found.paths.is_empty() {
            let text = format!("No stable state was found between {a} and {b}: the movable masses slip, or the machine whirls.");
            out.push(Finding::warning("no_stable_state", text).evidence("states followed", found.paths.len() as f64, ""));
        }
        let [starts, led, known] = found.starts.map(|n| n as f64);
        let share = if led > 0.0 { known / led } else { 0.0 };
        let text =
            format!("{} branches of states were found; {{}} of the starts that led to a state led to one known before.", found.paths.len());
        let completeness = Finding::info("completeness", text).value(share, "").evidence("starts", starts, "").evidence(
            "starts that led to a state",
            led,
            "",
        );
        out.push(completeness.evidence("starts that led to states that are not isolated", found.singular as f64, ""));
        let unfinished: Vec<String> = found
            .paths
            .iter()
            .enumerate()
            .filter_map(|(k, p)| {
                let ends = [p.branch.first_end.as_ref(), Some(&p.branch.end)];
                let at = ends.into_iter().flatten().find_map(|e| match e {
                    End::StepTooSmall { at, .. } => Some(*at),
                    End::MaxPoints => p.branch.points.last().map(|q| q.p),
                    _ => None,
                })?;
                Some(format!("branch {} near {}", k + 1, quantity(at, "rad/s")))
            })
            .collect();
        if !unfinished.is_empty() {
            out.push(Finding::warning("unfinished", format!("Not followed to their ends: {}.", unfinished.join(", "))));
        }
        if let (Some(least), Some(asked)) = (&self.least, self.stabilise) {
            out.push(self.stabilised(least, asked));
        }
        out
    }

    fn unit(&self, path: &str) -> String {
        let i = self.system.param(path).and_then(|p| p.first().copied());
        i.map_or(String::new(), |i| self.system.param_slots()[i].unit.to_string())
    }

    fn stabilised(&self, least: &Least, asked: &Stabilise) -> Finding {
        let (unit, at) = (self.unit(&asked.path), quantity(asked.speed, "rad/s"));
        let (lo, hi) = (quantity(asked.range.from, &unit), quantity(asked.range.to, &unit));
        let Some(class) = least.class else {
            let text = format!("There is no state at {at} that balances, whatever {} between {lo} and {hi}.", asked.path);
            return Finding::warning("not_balanced", text);
        };
        let state = class.words();
        match least.edges.iter().find(|e| e.gains) {
            Some(e) => {
                let text = format!("At {at} the state that is {state} becomes stable when {} rises above {{}}.", asked.path);
                let finding = Finding::info("least", text).of(&asked.path).value(e.value, unit);
                if e.frequency.is_finite() {
                    finding.evidence("frequency of the root in turning axes", e.frequency, "rad/s")
                } else {
                    finding
                }
            }
            None => {
                let stable = least.growth.iter().all(|g| g.1 <= 0.0);
                let word = if stable { "stable" } else { "nowhere made stable" };
                let text = format!("At {at} the state that is {state} is {word} by {} between {lo} and {hi}.", asked.path);
                let worst = least.growth.iter().map(|g| g.1).filter(|g| g.is_finite()).reduce(f64::max);
                let finding = if stable { Finding::info("least", text) } else { Finding::warning("least", text) }.of(&asked.path);
                worst.into_iter().fold(finding, |f, worst| f.evidence("largest growth rate in the range", worst, "1/s"))
            }
        }
    }

    fn special(&self, path: usize, l: &Located) -> SpecialPoint {
        let status = if l.located { Status::Located } else { Status::Bracketed };
        let point = SpecialPoint::new(l.change.word(), l.state.speed, l.bracket).of(format!("branch {}", path + 1)).status(status);
        // a root that was not located has no frequency
        let point = if l.frequency.is_finite() { point.evidence("frequency in turning axes", l.frequency, "rad/s") } else { point };
        point.evidence("growing roots before", l.growing.0 as f64, "").evidence("growing roots behind", l.growing.1 as f64, "")
    }

    /// Columns for bodies and angles.
    fn columns(&self, mut t: crate::outcome::TableBuilder, seen: &[&Seen]) -> crate::outcome::TableBuilder {
        for (k, body) in self.system.bodies().iter().enumerate() {
            let of = |f: &dyn Fn(&[f64; 2]) -> f64| seen.iter().map(|s| f(&s.bodies[k])).collect::<Vec<f64>>();
            t = t
                .float(format!("{} radius", body.name), "m", "distance from the axis", of(&|b| b[0].hypot(b[1])))
                .float(format!("{} x", body.name), "m", "displacement in turning axes, along the key mark", of(&|b| b[0]))
                .float(format!("{} y", body.name), "m", "displacement in turning axes, a quarter turn ahead of it", of(&|b| b[1]));
        }
        let places: Vec<(usize, usize)> =
            self.search.images().groups.iter().enumerate().flat_map(|(g, list)| (0..list.len()).map(move |i| (g, i))).collect();
        for (g, i) in places {
            let name = &self.system.coordinates()[self.search.images().groups[g][i]].name;
            t = t.float(name.clone(), "rad", "angle, between -pi and pi", seen.iter().map(|s| s.groups[g][i]).collect());
        }
        let first = seen.first().map_or(&[][..], |s| &s.quantities[..]);
        for (k, (part, q)) in first.iter().enumerate() {
            if q.unit == "rad" || q.unit == "rad/s" {
                continue;
            }
            let values = seen.iter().map(|s| s.quantities.get(k).map_or(f64::NAN, |q| q.1.value)).collect();
            t = t.float(format!("{part} {}", q.name), q.unit, "shown by the part", values);
        }
        t
    }

    fn states(&self) -> Result<Table, OutcomeError> {
        let rows = &self.rows;
        let column = |f: &dyn Fn(&Row) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
        let t = Table::new("states", "States at each speed; of states that differ by the names of equal masses only one")
            .int("state", "", "number", (1..=rows.len() as i64).collect())
            .float("speed", "rad/s", "spin speed", column(&|r| r.state.speed))
            .int("branch", "", "branch it lies on", rows.iter().map(|r| r.state.branch as i64 + 1).collect())
            .text("kind", "what kind of state it is", rows.iter().map(|r| r.class.word().into()).collect())
            .flag("locked", "the tilt of the tracks holds the masses near the node line", rows.iter().map(|r| r.seen.locked).collect())
            .flag("stable", "no root grows", rows.iter().map(|r| r.stability.growing == 0).collect())
            .int("growing", "", "number of growing roots", rows.iter().map(|r| r.stability.growing as i64).collect())
            .float("growth", "1/s", "largest growth rate", column(&|r| r.stability.growth()));
        let seen: Vec<&Seen> = rows.iter().map(|r| &r.seen).collect();
        self.columns(t, &seen).float("error", "", "estimated error over the typical sizes", column(&|r| r.state.error)).leading().build()
    }

    fn eigenvalues(&self) -> Result<Table, OutcomeError> {
        let rows: Vec<(usize, f64, f64, f64)> = self
            .rows
            .iter()
            .enumerate()
            .flat_map(|(k, r)| r.stability.values.iter().map(move |v| (k, r.state.speed, v.0.re, v.0.im)))
            .collect();
        Table::new("eigenvalues", "Eigenvalues about the states, in turning axes; those with a frequency stand for a conjugate pair")
            .int("state", "", "number of the state", rows.iter().map(|r| r.0 as i64 + 1).collect())
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| r.1).collect())
            .float("growth", "1/s", "growth rate", rows.iter().map(|r| r.2).collect())
            .float("frequency", "rad/s", "frequency in turning axes", rows.iter().map(|r| r.3).collect())
            .build()
    }

    fn branches(&self, points: &[Shown]) -> Result<Table, OutcomeError> {
        let t = Table::new("branches", "Branches of states, point by point; a branch may turn back in speed")
            .int("branch", "", "number of the branch", points.iter().map(|p| p.path as i64 + 1).collect())
            .float("speed", "rad/s", "spin speed", points.iter().map(|p| p.speed).collect())
            .text("kind", "what kind of state it is", points.iter().map(|p| p.class.word().into()).collect())
            .flag("stable", "no root grows", points.iter().map(|p| p.growing == 0).collect())
            .int("growing", "", "number of growing roots", points.iter().map(|p| p.growing as i64).collect())
            .float("growth", "1/s", "largest growth rate", points.iter().map(|p| p.growth).collect());
        let seen: Vec<&Seen> = points.iter().map(|p| &p.seen).collect();
        self.columns(t, &seen).build()
    }

    fn changes(&self) -> Result<Table, OutcomeError> {
        let all: Vec<(usize, &Located)> =
            self.found.paths.iter().enumerate().flat_map(|(k, p): (usize, &Path)| p.special.iter().map(move |l| (k, l))).collect();
        let doc = "fold: two states meet and vanish; branch_point: another branch crosses; hopf: an oscillation begins or ends; real_root: a root crosses zero";
        let column = |f: &dyn Fn(&Located) -> f64| all.iter().map(|a| f(a.1)).collect::<Vec<f64>>();
        Table::new("changes", "Where states vanish, cross, or change their stability, along each branch")
            .int("branch", "", "number of the branch", all.iter().map(|a| a.0 as i64 + 1).collect())
            .text("change", doc, all.iter().map(|a| a.1.change.word().into()).collect())
            .float("speed", "rad/s", "spin speed", column(&|l| l.state.speed))
            .float(
                "frequency",
                "rad/s",
                "frequency of the root that crosses, in turning axes; NaN where it was not located",
                column(&|l| l.frequency),
            )
            .int("growing_before", "", "growing roots before it along the branch", all.iter().map(|a| a.1.growing.0 as i64).collect())
            .int("growing_behind", "", "growing roots behind it", all.iter().map(|a| a.1.growing.1 as i64).collect())
            .flag("located", "located to rounding, not bracketed only", all.iter().map(|a| a.1.located).collect())
            .build()
    }

    fn parameter(&self, least: &Least, asked: &Stabilise) -> Result<Table, OutcomeError> {
        let unit = self.unit(&asked.path);
        let mut rows: Vec<(f64, f64, bool)> = least.growth.iter().map(|g| (g.0, g.1, false)).collect();
        rows.extend(least.edges.iter().map(|e| (e.value, 0.0, true)));
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        Table::new(
            "stabilised",
            format!("Largest growth rate of the balanced state at {} over {}", quantity(asked.speed, "rad/s"), asked.path),
        )
        .float("value", unit, format!("value of {}", asked.path), rows.iter().map(|r| r.0).collect())
        .float("growth", "1/s", "largest growth rate; NaN where there is no such state", rows.iter().map(|r| r.1).collect())
        .flag("edge", "stability changes here", rows.iter().map(|r| r.2).collect())
        .build()
    }

    fn figure(&self, ranges: &[Range]) -> Figure {
        let mut panels = Vec::new();
        let largest = self.rows.iter().flat_map(|r| &r.seen.bodies).map(|b| b[0].hypot(b[1])).fold(0.0, f64::max);
        for body in self.system.bodies() {
            let line = Line::new("branches", "speed", format!("{} radius", body.name))
                .group("branch")
                .solid_where("stable")
                .meaning("stable", "unstable");
            let mut panel = Panel::new(Axis::new(format!("distance of {} from the axis", body.name), "m").metres(largest)).mark(line);
            if panels.is_empty() {
                for l in self.found.paths.iter().flat_map(|p| &p.special).filter(|l| l.change == Change::Hopf).take(12) {
                    panel = panel.mark(Rule::x(l.state.speed, ""));
                }
            }
            panels.push(panel);
        }
        if !self.rows.is_empty() && !self.search.images().angles.is_empty() {
            let mut panel = Panel::new(Axis::new("angles of the masses", "rad").range(-3.2, 3.2));
            for &i in &self.search.images().angles {
                let name = &self.system.coordinates()[i].name;
                panel = panel.mark(Points::new("states", "speed", name.clone()).classes("kind", WORDS).filled_where("stable"));
            }
            panels.push(panel);
        }
        let stable: Vec<String> = ranges
            .iter()
            .map(|r| format!("{} from {} to {} rad/s", r.class.words(), significant(r.from, 4), significant(r.to, 4)))
            .collect();
        let alt = if stable.is_empty() { "no state is stable.".to_string() } else { format!("stable: {}.", stable.join("; ")) };
        let alt = format!("{} branches of states at rest in turning axes over the spin speed; {alt}", self.found.paths.len());
        let figure = Figure::new("states", "States that turn with the rotor", alt).x(Axis::new("spin speed", "rad/s"));
        panels.into_iter().fold(figure, Figure::panel)
    }
}
