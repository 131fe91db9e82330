//! From cells to findings and tables.

use super::border::{Crossing, Grid};
use super::cells::{APART, BOTH, DOWN, FAILED, NO_JUMP, SWEEPS, TILT, UP};
use super::{ParameterAxis, ResponseMap, ResponseMapResult, figures};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::outcome::{Arg, Finding, Message, Outcome, Table, parameter_name};
use crate::store::{Collected, Kind};
use crate::study::Study;
use crate::study::shared::probes;
use crate::study::shared::support::inconsistent;
use std::collections::BTreeMap;

/// All cells that are there.
pub(super) struct Map<'a> {
    pub study: &'a ResponseMap,
    /// Values of the parameters along x and y.
    pub values: &'a [Vec<f64>; 2],
    /// Numbers, column by column.
    pub numbers: BTreeMap<String, Vec<f64>>,
    /// What slow sweeps do.
    pub sweeps: Vec<String>,
    pub border: Vec<Crossing>,
}

impl Map<'_> {
    /// Number of cells.
    pub fn len(&self) -> usize {
        self.sweeps.len()
    }
    pub fn column(&self, name: &str) -> &[f64] {
        self.numbers.get(name).map_or(&[], Vec::as_slice)
    }
    fn count(&self, of: impl Fn(&str) -> bool) -> usize {
        self.sweeps.iter().filter(|s| of(s)).count()
    }
    /// The cell of the largest number (of the smallest with `sign` -1); NaN is none.
    fn best(&self, name: &str, sign: f64) -> Option<(usize, f64)> {
        let known = self.column(name).iter().copied().enumerate().filter(|c| c.1.is_finite());
        known.reduce(|a, b| if sign * b.1 > sign * a.1 { b } else { a })
    }
    fn place(&self, cell: usize) -> [f64; 2] {
        let width = self.values[0].len();
        [self.values[0][cell % width], self.values[1][cell / width]]
    }
    /// With the number of all machines.
    fn of_all(&self, f: Finding) -> Finding {
        f.arg("machines", Arg::count(self.len()))
    }
    /// With the values of both parameters: the argument `at`, and evidence.
    fn with_place(&self, f: Finding, cell: usize) -> Finding {
        let (place, axes) = (self.place(cell), &self.study.axes);
        let value = |k: usize| Arg::quantity(place[k], axes[k].unit);
        let both = Message::new("response-map-place").arg("first", Arg::name(&axes[0].path)).arg("x", value(0));
        let f = f.arg("at", both.arg("second", Arg::name(&axes[1].path)).arg("y", value(1)));
        (0..2).fold(f, |f, k| f.evidence(parameter_name(&axes[k].path), place[k], axes[k].unit))
    }
}

/// Whether a cell jumps; `None` where that is not known.
fn jumps(word: &str) -> Option<bool> {
    match word {
        NO_JUMP => Some(false),
        BOTH | DOWN | UP | APART => Some(true),
        _ => None,
    }
}

pub(super) fn report(study: &ResponseMap, system: &System, result: &ResponseMapResult, name: &str) -> Result<Outcome, Diagnostic> {
    let results = &result.cells;
    let values = &study.axes.each_ref().map(ParameterAxis::values);
    let floats = results.columns.iter().filter(|c| c.0.kind == Kind::Float);
    let numbers = floats.map(|c| (c.0.name.clone(), results.numbers(&c.0.name))).collect();
    let sweeps: Vec<String> = results.words("sweeps").into_iter().map(|w| if w.is_empty() { FAILED.to_string() } else { w }).collect();
    let known: Vec<Option<bool>> = sweeps.iter().map(|w| jumps(w)).collect();
    let mut map = Map { study, values, numbers, border: Vec::new(), sweeps };
    let open = map.column("open");
    let width: Vec<f64> =
        map.column("hysteresis").iter().enumerate().map(|(k, w)| if open.get(k) == Some(&0.0) { *w } else { f64::NAN }).collect();
    map.border = Grid { axes: &study.axes, values, jumps: &known, width: &width }.border();
    let mut outcome = Outcome::new(ResponseMap::KIND, name).end(result.end);
    if let Some(f) = results.remark() {
        outcome = outcome.finding(f);
    }
    for f in failures(&map, results) {
        outcome = outcome.finding(f);
    }
    for f in jumping(&map).into_iter().chain(peaks(&map, system)).chain(instability(&map, results)).chain(validity(&map, results)) {
        outcome = outcome.finding(f);
    }
    let points = map.column("points").iter().filter(|p| p.is_finite()).sum::<f64>();
    outcome = outcome.work("responses", results.done).work("points", points as u64);
    outcome = outcome.table(cell_table(&map, results)?).table(border_table(&map)?);
    figures::add(&map, outcome).checked().map_err(inconsistent)
}

/// Cells without a response, by cause; branches that were left.
fn failures(map: &Map, results: &Collected) -> Vec<Finding> {
    let mut out = Vec::new();
    let mut causes: BTreeMap<String, (usize, usize, String)> = BTreeMap::new();
    for (i, why) in results.words("failure").into_iter().enumerate().filter(|w| !w.1.is_empty()) {
        causes.entry(crate::study::parameters::uncertainty::cause(&why)).or_insert((0, i, why)).0 += 1;
    }
    for (cause, (count, first, example)) in causes {
        let f = Finding::warning("failed_machines", "response-map-failed").of(cause).value(count as f64, "");
        let f = map.of_all(f).arg("count", Arg::count(count)).arg("why", Arg::term(example.trim_end_matches('.')));
        out.push(map.with_place(f, first));
    }
    let left = results.words("end").iter().filter(|w| !w.is_empty()).count();
    if left > 0 {
        let f = Finding::warning("branches_left", "response-map-branches-left").value(left as f64, "");
        out.push(map.of_all(f).arg("count", Arg::count(left)));
    }
    let rising = map.column("rising").iter().filter(|x| **x == 1.0).count();
    if rising > 0 {
        let f = Finding::warning("peaks_not_reached", "response-map-peaks-not-reached").value(rising as f64, "");
        out.push(map.of_all(f).arg("count", Arg::count(rising)));
    }
    out
}

/// How many machines jump, and how wide the hysteresis is.
fn jumping(map: &Map) -> Vec<Finding> {
    let known = map.count(|w| jumps(w).is_some());
    if known == 0 {
        return Vec::new();
    }
    let count = map.count(|w| jumps(w) == Some(true));
    let jumping = match count {
        0 => "none",
        n if n == known => "all",
        _ => "some",
    };
    let mut out = vec![
        Finding::info("jumping_machines", "response-map-jumping")
            .value(count as f64, "")
            .arg("jumping", Arg::word(jumping))
            .arg("count", Arg::count(count))
            .arg("known", Arg::count(known))
            .arg("down", Arg::count(map.count(|w| w == DOWN)))
            .evidence("machines whose sweeps are known", known as f64, ""),
    ];
    if let Some((cell, width)) = map.best("hysteresis", 1.0).filter(|b| b.1 > 0.0) {
        let open = map.column("open").get(cell) == Some(&1.0);
        let f = Finding::info("widest_hysteresis", "response-map-widest-hysteresis").value(width, "rad/s");
        out.push(map.with_place(f.arg("open", Arg::word(if open { "yes" } else { "no" })), cell));
    }
    out
}

/// Columns of the largest displacement and of its speed, and its unit.
const PEAK: (&str, &str, &str) = ("peak", "peak_speed", "m");

/// The largest and the smallest peak of the map, and the largest tilt.
fn peaks(map: &Map, system: &System) -> Vec<Finding> {
    let all = probes::all(system);
    let sizes = all.iter().flat_map(|p| map.column(if p.is_tilt() { TILT } else { PEAK.0 }).iter().map(move |a| (p, *a)));
    if probes::unforced(system, &map.study.spin_speeds(system), sizes) {
        return vec![Finding::info("largest_peak", probes::UNFORCED).value(0.0, "m")];
    }
    let one = |id: &str, key: &str, (column, at, unit): (&str, &str, &str), sign: f64| {
        let (cell, peak) = map.best(column, sign)?;
        let of = |name: &str| map.column(name).get(cell).copied().unwrap_or(f64::NAN);
        let end = column == PEAK.0 && of("peak_at_end") == 1.0;
        let f = Finding::info(id, key).value(peak, unit).arg("speed", Arg::speed(of(at))).evidence("speed", of(at), "rad/s");
        let f = f.arg("end", Arg::word(if end { "yes" } else { "no" }));
        Some(map.with_place(f.evidence("dropped over kept force harmonics, worst point", of("truncation"), ""), cell))
    };
    let several = map.column("peak").iter().filter(|p| p.is_finite()).count() > 1;
    let mut out: Vec<Finding> = one("largest_peak", "response-map-largest-peak", PEAK, 1.0).into_iter().collect();
    out.extend(several.then(|| one("smallest_peak", "response-map-smallest-peak", PEAK, -1.0)).flatten());
    out.extend(one("largest_tilt", "response-map-largest-tilt", (TILT, "tilt_speed", "rad"), 1.0));
    out
}

/// Machines with unstable states away from the middle of folded curves, and machines whose stability is not known.
fn instability(map: &Map, results: &Collected) -> Vec<Finding> {
    let mut out = Vec::new();
    if !map.study.request.stability {
        out.push(Finding::warning("stability_unknown", "response-map-stability-not-requested"));
    }
    let unknown: Vec<String> = results.words("unassessed").into_iter().filter(|w| !w.is_empty()).collect();
    if let Some(why) = unknown.first() {
        let f = Finding::warning("stability_unknown", "response-map-stability-unknown").value(unknown.len() as f64, "");
        out.push(map.of_all(f).arg("count", Arg::count(unknown.len())).arg("why", Arg::term(why)));
    }
    let unstable = map.column("unstable_from").iter().filter(|x| x.is_finite()).count();
    if let Some((cell, growth)) = map.best("growth", 1.0).filter(|b| b.1 > 0.0) {
        let f = Finding::warning("unstable_machines", "response-map-unstable").value(growth, "1/s").arg("count", Arg::count(unstable));
        out.push(map.with_place(map.of_all(f).evidence("machines", unstable as f64, ""), cell));
    }
    let events = [
        ("neimark_sacker", "neimark_sacker_machines", "response-map-neimark-sacker"),
        ("symmetry_breakings", "symmetry_breaking_machines", "response-map-symmetry-breaking"),
        ("period_doublings", "period_doubling_machines", "response-map-period-doubling"),
    ];
    for (column, id, key) in events {
        let count = map.column(column).iter().filter(|x| **x > 0.0).count();
        if count > 0 {
            out.push(map.of_all(Finding::warning(id, key).value(count as f64, "")).arg("count", Arg::count(count)));
        }
    }
    out
}

fn validity(map: &Map, results: &Collected) -> Vec<Finding> {
    let mut worst: BTreeMap<String, (f64, usize, usize)> = BTreeMap::new();
    for (cell, what) in results.words("limit").into_iter().enumerate() {
        let ratio = map.column("validity")[cell];
        if ratio.is_nan() || ratio <= 1.0 {
            continue;
        }
        let entry = worst.entry(what).or_insert((ratio, cell, 0));
        entry.2 += 1;
        if ratio > entry.0 {
            (entry.0, entry.1) = (ratio, cell);
        }
    }
    let one = |(what, (ratio, cell, count)): (String, (f64, usize, usize))| {
        let f = if ratio.is_finite() {
            Finding::invalid("outside_validity", "response-map-outside-validity").value(ratio, "")
        } else {
            Finding::invalid("outside_validity", "response-map-outside-validity-unbounded")
        };
        let f = map.of_all(f).arg("count", Arg::count(count)).arg("what", Arg::term(&what));
        map.with_place(f.of(what), cell)
    };
    worst.into_iter().map(one).collect()
}

fn cell_table(map: &Map, results: &Collected) -> Result<Table, Diagnostic> {
    let mut t = Table::new("map", "Machines, along x and then along y, with their response").leading();
    let finite = |x: &f64| if x.is_finite() { *x } else { f64::NAN };
    for (i, (c, _)) in results.columns.iter().enumerate() {
        if c.kind == Kind::Float {
            // both parameters always have a value
            let doc = Arg::term(&c.doc);
            let doc = if i < 2 || c.doc.contains("NaN") { doc } else { Arg::noted(doc, "NaN where there is none") };
            t = t.float(&c.name, &c.unit, doc, map.column(&c.name).iter().map(finite).collect());
        } else if c.name == "sweeps" {
            t = t.text(&c.name, Arg::term(&c.doc), map.sweeps.clone());
        } else {
            t = t.text(&c.name, Arg::term(&c.doc), results.words(&c.name));
        }
    }
    debug_assert!(map.sweeps.iter().all(|s| SWEEPS.contains(&s.as_str())));
    t.build().map_err(inconsistent)
}

/// The points of the border, curve by curve.
fn border_table(map: &Map) -> Result<Table, Diagnostic> {
    let (axes, all) = (&map.study.axes, &map.border);
    let column = |f: &dyn Fn(&Crossing) -> f64| all.iter().map(f).collect::<Vec<f64>>();
    Table::new(
        "border",
        "Border between machines that jump and machines that do not, where it crosses the lines between two of them: where the widths of their hysteresis lead to zero, else half way",
    )
    .float("x", axes[0].unit, parameter_name(&axes[0].path), column(&|c| c.at[0]))
    .float("y", axes[1].unit, parameter_name(&axes[1].path), column(&|c| c.at[1]))
    .flag("begins", "first point of a curve", all.iter().map(|c| c.begins).collect())
    .names("across", "the parameter that differs on both sides", all.iter().map(|c| axes[c.across].path.clone()).collect())
    .float("side_below", "", "its value on one side, SI units: the border lies between", column(&|c| c.between[0]))
    .float("side_above", "", "its value on the other side, SI units", column(&|c| c.between[1]))
    .build()
    .map_err(inconsistent)
}
