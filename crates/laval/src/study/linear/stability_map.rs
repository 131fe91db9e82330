//! Growth rate over the spin speed, alone or together with one parameter of the machine, and the boundary of stability.
//!
//! Equations: largest Re s over all roots of `det T(s, W) = 0`; boundary where it crosses the threshold. An undamped machine is unstable between
//! double roots: there `det T = 0` and `d det T / ds = 0` are solved together for (s, W).
//!
//! Symbols: W spin speed, rad/s; s = growth + i frequency.
//!
//! Validity: small motions about the equilibrium at each speed; constant speed.
//!
//! Sources: `docs/theory/linear-vibration.md#stability-boundaries`, `docs/theory/liquid-plane-flow.md#instability`.

use super::criterion::{CRITERION, Criterion};
use super::modes::THRESHOLD;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, RangeValue, Values};
use crate::model::part::{Domain, Words};
use crate::model::system::System;
use crate::outcome::{
    Axis, Band, Figure, Finding, Heat, Line, Outcome, Panel, Points, Rule, SpecialPoint, Status, Table, quantity, significant,
};
use crate::solve::counted;
use crate::solve::roots::{LEAST, transcendental};
use crate::solve::stability::{Edge, Row, Sample, row};
use crate::study::shared::region;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{
    ABOUT, About, COUNTS, SPEED_RANGE, admit_roots, admit_threshold, beyond_rounding, inconsistent, one_or_range, range, remarks_between,
};
use crate::study::{Context, Study};
use laval_num::work::Here;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Most points of a map.
const MOST_CELLS: usize = 1_000_000;

/// See the [module](self).
pub struct StabilityMap {
    /// Speeds, rad/s.
    pub speed: RangeValue,
    /// Parameter path and its range.
    pub parameter: Option<(String, RangeValue)>,
    /// State linearised about.
    pub about: About,
    /// What counts as unstable.
    pub criterion: Criterion,
    /// Growth that counts as unstable, 1/s.
    pub threshold: f64,
    /// Largest frequency at which roots of a machine with parts without time form are looked for, rad/s.
    pub frequency: Option<f64>,
}

impl Study for StabilityMap {
    type Result = Outcome;
    const KIND: &'static str = "stability_map";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm", points = 120 }
parameter = { parameter = "drum.mass", from = "1.5 kg", to = "4 kg", points = 11 }
"#;
    const DOC: &'static str = "Where the machine is unstable: growth rate over the spin speed, alone or together with one parameter, with the \
        boundary and the peaks of the growth located. Nonlinear parts enter by their tangent in the state it is linearised about; nonlinear_response \
        judges the motion that unbalance drives, whose ranges differ where that motion is not small.";
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "one spin speed, or a range of 200 points unless given"),
        Field::optional(
            "parameter",
            FieldKind::ParameterRange,
            "",
            "a parameter to vary as well; 40 points unless given, at most 1000000 in all with those of the speed",
        ),
        ABOUT,
        CRITERION,
        THRESHOLD,
        region::FREQUENCY_LIMIT,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = one_or_range("speed", values.range("speed")?, 3, values, diagnostics);
        let mut parameter = None;
        if let Some((path, given)) = values.parameter_range("parameter") {
            let given = range("parameter", given, 2, values, diagnostics);
            if system.param(path).is_none() {
                diagnostics.push(system.unknown_param(path).at(values.span_of("parameter")));
                return None;
            }
            parameter = Some((path.to_string(), given?));
        }
        let count = |r: &RangeValue, default| r.points.unwrap_or(default);
        if let (Some(s), Some((_, p))) = (&speed, &parameter)
            && count(s, 200).saturating_mul(count(p, 40)) > MOST_CELLS
        {
            let message = format!("a map of {} by {} points is too large", count(s, 200), count(p, 40));
            let help = format!("at most {MOST_CELLS} points in all");
            diagnostics.push(Diagnostic::error("study.range", message).at(values.span_of("parameter")).help(help));
            return None;
        }
        Some(StabilityMap {
            speed: speed?,
            parameter,
            about: About::read(values),
            criterion: Criterion::read(values),
            threshold: values.number("growth_threshold").unwrap_or(0.0),
            frequency: values.number("frequency_limit"),
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        // lines of the map are computed side by side
        let lines = self.parameter.as_ref().map_or(1, |p| p.1.points.unwrap_or(40).min(8));
        Some(Size::of_spectra(self.speed.points.unwrap_or(200) * lines, system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit_roots(system, self.about, self.speed.from)?;
        admit_threshold(system, self.speed.from, self.threshold)?;
        self.criterion.admit(system, self.about, self.speed.from)?;
        let Some((path, range)) = &self.parameter else { return Ok(()) };
        for x in [range.from, range.to] {
            let changed = system.with(&[(path, x)]).map_err(|d| refused(system, path, x, d))?;
            admit_roots(&changed, self.about, self.speed.from)?;
        }
        Ok(())
    }

    fn report(&self, _: &System, result: &Outcome, _: &str) -> Result<Outcome, Diagnostic> {
        Ok(result.clone())
    }

    fn compute(&self, system: &System, context: &Context) -> Result<Outcome, Diagnostic> {
        self.admit(system)?;
        let speeds = self.speed.linspace(200);
        let values: Vec<Option<f64>> = match &self.parameter {
            Some((_, r)) => r.linspace(40).into_iter().map(Some).collect(),
            None => vec![None],
        };
        let total = (values.len() * speeds.len()) as u64;
        if transcendental(system) {
            context.announce(total as f64, COUNTS, "speeds at which roots are counted, one after another");
        } else {
            context.announce(total as f64, 10_000.0, "eigenvalue problems to solve");
        }
        let done = AtomicU64::new(0);
        // rows that the limit cannot reach are not begun
        let within = usize::try_from(context.work_limit.div_ceil(speeds.len() as u64)).unwrap_or(usize::MAX).clamp(1, values.len());
        let here = Here::now();
        let rows: Vec<Row> = values[..within]
            .par_iter()
            .enumerate()
            .map(|(k, value)| {
                let _counted = here.enter();
                // the limit counts rows before this one as done, so that the result does not depend on the number of threads
                let first = (k * speeds.len()) as u64;
                let mut each = |solved: u64| {
                    context.progress.report(done.fetch_add(1, Ordering::Relaxed).min(total), total);
                    context.goes_on(first + solved)
                };
                if context.cancelled() {
                    return Ok(Row { stopped: true, ..Row::default() });
                }
                let run = |s: &System, each: &mut dyn FnMut(u64) -> bool| {
                    let state = |w: f64| self.about.find(s, w, None);
                    if transcendental(s) {
                        return counted::row(s, &state, &speeds, self.least(s, &speeds), (self.frequency, context.cancel), each);
                    }
                    row(s, &state, &speeds, self.threshold, each)
                };
                match (value, &self.parameter) {
                    (Some(x), Some((path, _))) => {
                        let changed = system.with(&[(path, *x)]).map_err(|d| refused(system, path, *x, d))?;
                        run(&changed, &mut each)
                    }
                    _ => run(system, &mut each),
                }
            })
            .collect::<Result<_, Diagnostic>>()?;
        context.progress.report(total, total);
        let stopped = rows.len() < values.len() || rows.iter().any(|r| r.stopped);
        let mut outcome = self.report(system, context, &values, &rows, !stopped)?;
        let (first, last) = (self.about.find(system, speeds[0], None)?, self.about.find(system, speeds[speeds.len() - 1], None));
        for f in remarks_between(system, &first, last) {
            outcome = outcome.finding(f);
        }
        outcome.checked().map_err(inconsistent)
    }
}

fn refused(system: &System, path: &str, x: f64, d: Diagnostics) -> Diagnostic {
    let unit = system.param(path).and_then(|i| system.param_slots().get(*i.first()?)).map_or("", |s| s.unit);
    let x = quantity(x, unit);
    let why = d.0.into_iter().next().map(|d| d.message).unwrap_or_default();
    Diagnostic::error("stability_map.parameter", format!("the machine does not exist at {path} = {x}: {why}"))
        .help("narrow the range of the parameter")
}

/// The root that crosses a boundary, there.
fn at_boundary(e: &Edge) -> Sample {
    Sample { speed: e.speed, value: e.value, sector: None, size: 0.0, on_grid: false, other: false, growing: None, counted: false }
}

impl StabilityMap {
    /// The threshold, or, of a machine with waves that nothing inside it damps, the least growth that is distinguished from theirs at all these speeds.
    fn least(&self, system: &System, speeds: &[f64]) -> f64 {
        let fastest = speeds.iter().fold(0.0f64, |m, w| m.max(w.abs()));
        if system.domains(fastest).iter().any(Domain::undamped) { self.threshold.max(LEAST * fastest) } else { self.threshold }
    }

    fn report(
        &self,
        system: &System,
        context: &Context,
        values: &[Option<f64>],
        rows: &[Row],
        complete: bool,
    ) -> Result<Outcome, Diagnostic> {
        let endless = transcendental(system);
        let threshold = if endless { self.least(system, &self.speed.linspace(200)) } else { self.threshold };
        let (name, unit) = match &self.parameter {
            Some((path, _)) => {
                let unit = system.param(path).and_then(|i| system.param_slots().get(*i.first()?)).map_or("", |s| s.unit);
                (path.clone(), unit)
            }
            None => (String::new(), ""),
        };
        let two = self.parameter.is_some();
        let value = |k: usize| values[k].unwrap_or(f64::NAN);
        // the map keeps the grid; along one line the points between belong to it too
        let cells: Vec<(usize, &Sample)> =
            rows.iter().enumerate().flat_map(|(k, r)| r.samples.iter().filter(|s| s.on_grid || !two).map(move |s| (k, s))).collect();
        // the curve of what is known ends at its boundary, not at the last point before it
        let ends: Vec<Sample> =
            rows.iter().take(usize::from(endless && !two)).flat_map(|r| &r.edges).filter(|e| e.located).map(at_boundary).collect();
        let mut cells = cells;
        cells.extend(ends.iter().map(|e| (0, e)));
        if !two {
            cells.sort_by(|a, b| a.1.speed.total_cmp(&b.1.speed));
        }
        let crossing = |c: &(usize, &Sample)| ends.iter().any(|e| std::ptr::eq(e, c.1));
        // roots that grow no faster are not all known
        let unknown = |c: &(usize, &Sample)| endless && !(c.1.value.re > threshold) && !crossing(c);
        // where all growth is rounding no mode is the strongest
        let frequency = |c: &(usize, &Sample)| {
            let row = &rows[c.0];
            if unknown(c) || row.undamped && !row.unstable(c.1, 0.0) { f64::NAN } else { c.1.value.im }
        };
        let mut map =
            Table::new("map", "Largest growth rate").float("speed", "rad/s", "spin speed", cells.iter().map(|c| c.1.speed).collect());
        if two {
            map = map.float(name.clone(), unit, "parameter", cells.iter().map(|c| value(c.0)).collect());
        }
        let map = map
            .float_if_any(
                "growth",
                "1/s",
                if endless {
                    "largest growth rate of all modes; NaN where none grows faster than the threshold"
                } else {
                    "largest growth rate of all modes"
                },
                cells.iter().map(|c| if unknown(c) { f64::NAN } else { c.1.value.re }).collect(),
            )
            .float_if_any(
                "frequency",
                "rad/s",
                "frequency of that mode; NaN where nothing damps or drives any, or none grows",
                cells.iter().map(frequency).collect(),
            )
            .flag("other_mode", "it is another mode than at the speed before", cells.iter().map(|c| c.1.other).collect());
        let map = if endless {
            let number = |c: &(usize, &Sample)| c.1.growing.map_or(f64::NAN, |n| n as f64);
            let doc = "modes that grow faster than the threshold, by the argument principle; NaN where the count could not be brought to agree with the roots found, and \
                       at a boundary";
            map.float_if_any("growing", "", doc, cells.iter().map(number).collect())
        } else {
            map
        };
        let map = map.build().map_err(inconsistent)?;
        let edges: Vec<_> = rows.iter().enumerate().flat_map(|(k, r)| r.edges.iter().map(move |e| (k, e))).collect();
        let peaks: Vec<_> = rows.iter().enumerate().flat_map(|(k, r)| r.peaks.iter().map(move |p| (k, p))).collect();
        let mut boundary = Table::new("boundary", "Points where the growth rate crosses the threshold, located").float(
            "speed",
            "rad/s",
            "spin speed",
            edges.iter().map(|e| e.1.speed).collect(),
        );
        let mut tops = Table::new("peaks", "Maxima of the growth rate over the speed").float(
            "speed",
            "rad/s",
            "spin speed",
            peaks.iter().map(|p| p.1.speed).collect(),
        );
        if two {
            boundary = boundary.float(name.clone(), unit, "parameter", edges.iter().map(|e| value(e.0)).collect());
            tops = tops.float(name.clone(), unit, "parameter", peaks.iter().map(|p| value(p.0)).collect());
        }
        let boundary = boundary
            .text(
                "edge",
                "onset: unstable above this speed; end: stable above",
                edges.iter().map(|e| if e.1.onset { "onset" } else { "end" }.into()).collect(),
            )
            .float("growth", "1/s", "growth rate", edges.iter().map(|e| e.1.value.re).collect())
            .float("frequency", "rad/s", "frequency", edges.iter().map(|e| e.1.value.im).collect())
            .text("method", "how it was located", edges.iter().map(|e| if e.1.double { "double root" } else { "bracket" }.into()).collect())
            .float("uncertainty", "rad/s", "last step or bracket", edges.iter().map(|e| e.1.step).collect())
            .build()
            .map_err(inconsistent)?;
        let tops = tops
            .float("growth", "1/s", "growth rate", peaks.iter().map(|p| p.1.value.re).collect())
            .float("frequency", "rad/s", "frequency", peaks.iter().map(|p| p.1.value.im).collect())
            .build()
            .map_err(inconsistent)?;

        let solved: u64 = rows.iter().map(|r| r.solved).sum();
        let mut outcome =
            Outcome::new(Self::KIND, context.name).over("speed", "rad/s").end(context.end(complete)).work("eigenproblems", solved);
        for &(k, e) in &edges {
            let kind = if e.onset { "instability_onset" } else { "instability_end" };
            let status = if e.located { Status::Located } else { Status::Bracketed };
            let mut p = SpecialPoint::new(kind, e.speed, e.bracket).status(status).evidence("frequency", e.value.im, "rad/s").evidence(
                "uncertainty",
                e.step,
                "rad/s",
            );
            if two {
                p = p.evidence(name.clone(), value(k), unit);
            }
            outcome = outcome.special_point(p);
        }
        for &(k, p) in &peaks {
            let mut point = SpecialPoint::new("growth_peak", p.speed, p.bracket).evidence("growth", p.value.re, "1/s").evidence(
                "frequency",
                p.value.im,
                "rad/s",
            );
            if two {
                point = point.evidence(name.clone(), value(k), unit);
            }
            outcome = outcome.special_point(point);
        }
        let with = |k: usize| if two { format!(" at {name} = {}", quantity(value(k), unit)) } else { String::new() };
        let sizes = rows.iter().flat_map(|r| &r.samples).map(|s| s.size).fold(0.0, f64::max);
        let highest = peaks.iter().map(|&(k, p)| (k, p.speed, p.value)).chain(cells.iter().map(|c| (c.0, c.1.speed, c.1.value)));
        let highest = highest.max_by(|a, b| a.2.re.total_cmp(&b.2.re));
        let limit = quantity(threshold, "1/s");
        let unstable = rows.iter().any(|r| r.samples.iter().any(|s| r.unstable(s, threshold)));
        let open = cells.iter().filter(|c| endless && c.1.growing.is_none() && !crossing(c)).count();
        let points = cells.len() - ends.len();
        if let Some((k, speed, s)) = highest {
            let finding = if !unstable && endless {
                let computed = if complete { "" } else { " before the study stopped" };
                if open == 0 {
                    Finding::info("stable", format!("No mode grows faster than {limit} at any point computed{computed}."))
                } else {
                    let text =
                        format!("No mode was found that grows faster than {limit}, but at {open} of {points} points some may be missing.");
                    Finding::warning("stability_unknown", text)
                }
            } else if unstable {
                Finding::warning(
                    "largest_growth",
                    format!(
                        "{} strongest instability grows at {{}}, at {}{}, {}.",
                        if two { "Of the machines computed the" } else { "The" },
                        quantity(speed, "rad/s"),
                        with(k),
                        if s.im == 0.0 { "without oscillation".into() } else { format!("whirling at {}", quantity(s.im, "rad/s")) }
                    ),
                )
            } else {
                let computed = if complete { "" } else { " before the study stopped" };
                let largest = if beyond_rounding(s.re, sizes) == 0.0 { "zero to rounding" } else { "{}" };
                let text =
                    format!("No mode grows faster than {limit} at any point computed{computed}; the largest growth rate is {largest}.");
                Finding::info("stable", text)
            };
            let finding = if unstable {
                finding.value(s.re, "1/s")
            } else if endless {
                finding
            } else {
                finding.value(beyond_rounding(s.re, sizes), "1/s")
            };
            outcome = outcome.finding(finding.evidence("speed", speed, "rad/s"));
        }
        if !two && !self.speed.is_one() {
            let samples = rows.first().map_or(&[][..], |r| &r.samples);
            let (first, last) = (self.speed.from, samples.last().map_or(self.speed.from, |s| s.speed));
            let (whole, range_end) = if complete {
                ("", "the end of the range".to_string())
            } else {
                (", where the study stopped", format!("{}, where the study stopped", quantity(last, "rad/s")))
            };
            // an unstable start has no onset inside the range
            let start = match edges.first() {
                Some(e) if !e.1.onset => Some(quantity(e.1.speed, "rad/s")),
                None if unstable => Some(quantity(last, "rad/s") + whole),
                _ => None,
            };
            if let Some(until) = start {
                let text = format!("Growth exceeds {limit} from the start of the range, {{}}, to {until}.");
                outcome = outcome.finding(Finding::warning("unstable_range", text).value(first, "rad/s"));
            }
            for (w, e) in edges.iter().enumerate().filter(|(_, e)| e.1.onset) {
                let until =
                    edges.get(w + 1).map(|n| format!(" to {}", quantity(n.1.speed, "rad/s"))).unwrap_or_else(|| format!(" to {range_end}"));
                let finding = if e.1.located {
                    Finding::warning("unstable_range", format!("Unstable from {{}}{until}: growth above {limit}."))
                        .value(e.1.speed, "rad/s")
                } else {
                    let (a, b) = e.1.bracket;
                    let text = format!(
                        "Unstable from between {} and {}, where the boundary could not be located,{until}: growth above {limit}.",
                        quantity(a, "rad/s"),
                        quantity(b, "rad/s")
                    );
                    Finding::warning("unstable_range", text)
                };
                outcome = outcome.finding(finding.evidence("uncertainty of the onset", e.1.step, "rad/s"));
            }
        }
        // of other machines what grows is unstable and nothing is to be explained
        if endless || self.criterion != Criterion::Growth {
            outcome = outcome.finding(self.criterion.finding(system, self.speed.to, threshold));
        }
        if endless {
            let evaluations: u64 = rows.iter().map(|r| r.evaluations).sum();
            let text = if open == 0 {
                format!("At all {points} points the argument principle counts as many roots that grow faster than {limit} as were found.")
            } else {
                format!("At {{}} of {points} points it could not be proven that no root that grows faster than {limit} is missing.")
            };
            let finding = if open == 0 {
                Finding::info("all_counted", text)
            } else {
                Finding::warning("not_all_counted", text).value(open as f64, "")
            };
            outcome = outcome.finding(finding.evidence("evaluations of the characteristic function", evaluations as f64, ""));
            if threshold > self.threshold {
                let words = system.domains(self.speed.to).into_iter().find(Domain::undamped).map_or(Words::PLAIN, |d| d.words);
                let text = format!(
                    "Waves of {} grow slowly with any damping outside it: growth counts from {{}} on instead of {}, because slower waves are not all computed.",
                    words.name,
                    quantity(self.threshold, "1/s")
                );
                outcome = outcome.finding(Finding::warning("threshold_raised", text).value(threshold, "1/s"));
            }
            let from = self.speed.from;
            for f in region::limits(&system.domains(from), from) {
                outcome = outcome.finding(f);
            }
        }
        if rows.iter().any(|r| r.undamped) {
            let machine = if rows.iter().all(|r| r.undamped) { "The machine has no damping" } else { "Where the machine has no damping" };
            let own = || rows.iter().filter(|r| r.undamped).flat_map(|r| &r.edges);
            let (double, all) = (own().filter(|e| e.double).count(), own().count());
            let how = match (double, all) {
                (_, 0) => ": where no mode grows, none decays either".to_string(),
                (d, a) if d == a => ": its stability boundaries are double roots and were solved for as such".into(),
                (d, a) => format!(": its stability boundaries are double roots; {d} of {a} were solved for as such, the others bracketed"),
            };
            outcome = outcome.finding(Finding::info("undamped", format!("{machine}{how}.")));
        }
        let drawn = |name: &str| map.column(name).is_some();
        let (grows, whirls) = (drawn("growth"), drawn("frequency"));
        outcome = outcome.table(map);
        let one = self.speed.is_one();
        // along the speed there are no boundaries and peaks at one speed, and without a parameter no curve
        if !one {
            outcome = outcome.table(boundary).table(tops);
        }
        // where nothing is known to grow there is nothing to draw
        if one && !two || !grows {
            return Ok(outcome);
        }
        let speed_axis = Axis::new("spin speed", "rad/s");
        let figure = if one {
            let growth = Panel::new(Axis::new("growth rate", "1/s"))
                .mark(Line::new("map", name.clone(), "growth").name("largest growth rate"))
                .mark(Rule::y(threshold, "threshold"));
            let at = quantity(self.speed.from, "rad/s");
            Figure::new("stability", "Largest growth rate", format!("Largest growth rate over {name} at {at}."))
                .x(Axis::new(name.clone(), unit))
                .panel(growth)
        } else if two {
            let heat = Heat::new("map", "speed", name.clone(), "growth", Axis::new("growth rate", "1/s")).diverging().contour(threshold);
            let factor = if unit == "m" { 1e3 } else { 1.0 };
            let shown = if unit == "m" { "mm" } else { unit };
            Figure::new(
                "stability",
                "Stability map",
                format!("Largest growth rate over spin speed and {name}, with the boundary of stability."),
            )
            .x(speed_axis)
            .panel(
                Panel::new(Axis::new(name.clone(), shown).factor(factor))
                    .mark(heat)
                    .mark(Points::new("boundary", "speed", name).name("boundary")),
            )
        } else {
            let mut growth = Panel::new(Axis::new("growth rate", "1/s"));
            for (from, to) in rows[0].unstable_ranges(threshold) {
                growth = growth.mark(Band::x(from, to).name("unstable").strip());
                let ends = format!("unstable {} to {}", significant(from, 4), significant(to, 4));
                growth = growth.mark(Rule::x(from, ends));
            }
            growth = growth
                .mark(Line::new("map", "speed", "growth").name("largest growth rate"))
                .mark(Rule::y(threshold, "threshold"))
                .mark(Points::new("peaks", "speed", "growth").name("peak"))
                .mark(Points::new("boundary", "speed", "growth").name("boundary"));
            let frequency = Line::new("map", "speed", "frequency").name("its frequency").begins_where("other_mode");
            let figure = Figure::new(
                "stability",
                "Largest growth rate",
                "Largest growth rate over spin speed, with the ranges where it exceeds the threshold; below, the frequency of that mode, with a gap where \
                 another mode becomes the strongest.",
            )
            .x(speed_axis)
            .panel(growth);
            let below = Panel::new(Axis::new("frequency of the strongest mode", "rad/s")).mark(frequency);
            if whirls { figure.panel(below) } else { figure }
        };
        Ok(outcome.figure(figure))
    }
}
