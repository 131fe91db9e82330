//! Axes of panels: the ranges that data need, round values at their ends, and the decades of logarithmic ones.

use super::{Kind, PanelView, Series};
use crate::outcome::{Axis, Scale};
use crate::report::ticks::AxisView;
use crate::report::words::Style;

pub(super) fn extent(values: impl Iterator<Item = f64>, log: bool) -> Option<(f64, f64)> {
    values.filter(|v| v.is_finite() && (!log || *v > 0.0)).fold(None, |r: Option<(f64, f64)>, v| match r {
        None => Some((v, v)),
        Some((a, b)) => Some((a.min(v), b.max(v))),
    })
}

pub(super) fn join(a: Option<(f64, f64)>, b: Option<(f64, f64)>) -> Option<(f64, f64)> {
    match (a, b) {
        (Some(a), Some(b)) => Some((a.0.min(b.0), a.1.max(b.1))),
        _ => a.or(b),
    }
}

/// Widened to the outer borders of the cells.
pub(super) fn cells(centres: &[f64], log: bool) -> Option<(f64, f64)> {
    let (lo, hi) = extent(centres.iter().copied(), log)?;
    let n = centres.len();
    if n < 2 || lo == hi {
        return Some((lo, hi));
    }
    let view = AxisView::new("", "", log, lo, hi);
    let e = crate::report::heat::edges(centres, &view);
    let value = |t: f64| if log { lo * (hi / lo).powf(t) } else { lo + t * (hi - lo) };
    Some((value(e[0]), value(e[n])))
}

pub(super) fn x_axis(axis: &Axis, panels: &[PanelView], style: &Style) -> AxisView {
    let log = axis.scale == Scale::Log;
    let mut range = None;
    let mut markers_only = true;
    for p in panels {
        let own: Vec<&Series> = p.series.iter().filter(|s| !s.reference).collect();
        markers_only &= own.iter().all(|s| matches!(s.kind, Kind::Marker { .. })) && p.heat.is_none();
        range = join(range, extent(own.iter().flat_map(|s| &s.points).map(|q| q.0), log));
        range = join(range, p.heat.as_ref().and_then(|h| cells(&h.xs, log)));
    }
    if range.is_none() {
        let reference = panels.iter().flat_map(|p| &p.series).flat_map(|s| &s.points).map(|q| q.0);
        let marks = panels.iter().flat_map(|p| {
            let rules = p.rules.iter().filter(|r| r.vertical).map(|r| r.at);
            rules.chain(p.bands.iter().flat_map(|b| &b.outline).map(|q| q.0))
        });
        range = extent(reference.chain(marks), log);
        markers_only = true;
    }
    if let (true, Some((lo, hi))) = (markers_only, range) {
        range = Some(pad(lo, hi, 0.04, log));
    }
    axis_view(axis, range, style)
}

/// Decades of a logarithmic axis: at least, at most, and below the largest value of a curve that shall be seen. What lies deeper below the largest of
/// all values is rounding.
const DECADES: (f64, f64) = (1e3, 1e5);
const OWN_DECADE: f64 = 10.0;
const ROUNDING: f64 = 1e-10;

/// The lowest value that a logarithmic axis shows of curves between `lo` and `hi`: what nearly all of their points exceed.
pub(super) fn deepest(curves: &[Vec<f64>], lo: f64, hi: f64) -> f64 {
    let mut all: Vec<f64> = curves.iter().flatten().copied().filter(|v| *v > 0.0).collect();
    if all.is_empty() || hi / lo <= DECADES.0 {
        return lo;
    }
    all.sort_by(f64::total_cmp);
    let common = all[all.len() / 20];
    let floor = (0.5 * common).clamp(hi / DECADES.1, hi / DECADES.0);
    // every curve that is more than rounding has its largest values in sight
    let tops = curves.iter().map(|c| c.iter().copied().fold(0.0, f64::max)).filter(|t| *t > ROUNDING * hi);
    tops.map(|t| t / OWN_DECADE).fold(floor, f64::min).max(lo)
}

pub(super) fn y_axis(axis: &Axis, panel: &PanelView, x: &AxisView, style: &Style) -> AxisView {
    let log = axis.scale == Scale::Log;
    let shown = |q: &&(f64, f64)| x.place(q.0) >= -1e-9 && x.place(q.0) <= 1.0 + 1e-9;
    let of = |reference: bool| {
        extent(panel.series.iter().filter(|s| s.reference == reference).flat_map(|s| &s.points).filter(shown).map(|q| q.1), log)
    };
    let cells = panel.heat.as_ref().and_then(|h| cells(&h.ys, log));
    let mut range = join(of(false), extent(panel.bands.iter().flat_map(|b| &b.outline).map(|q| q.1), log));
    range = join(
        range.or_else(|| if cells.is_none() { of(true) } else { None }),
        extent(panel.rules.iter().filter(|r| !r.vertical).map(|r| r.at), log),
    );
    if let (true, Some((lo, hi))) = (log, range) {
        let own = panel.series.iter().filter(|s| !s.reference);
        let curves: Vec<Vec<f64>> = own.map(|s| s.points.iter().filter(shown).map(|q| q.1).collect()).collect();
        let bands = extent(panel.bands.iter().flat_map(|b| &b.outline).map(|q| q.1), true);
        let rules = extent(panel.rules.iter().filter(|r| !r.vertical).map(|r| r.at), true);
        let named = join(bands, rules).map_or(f64::INFINITY, |r| r.0);
        range = Some((deepest(&curves, lo, hi).min(named.max(lo)), hi));
    }
    if let Some((lo, hi)) = range {
        let zero = !log && lo >= 0.0 && lo < 0.4 * hi;
        let padded = match axis.knee {
            Some(k) => {
                let ends = pad((lo / k).asinh(), (hi / k).asinh(), 0.05, false);
                (k * ends.0.sinh(), k * ends.1.sinh())
            }
            None => pad(lo, hi, 0.05, log),
        };
        range = Some((if zero { 0.0 } else { padded.0 }, padded.1));
    }
    axis_view(axis, if panel.heat.is_some() { join(range, cells) } else { range }, style)
}

pub(super) fn pad(lo: f64, hi: f64, by: f64, log: bool) -> (f64, f64) {
    if log {
        let f = (hi / lo).powf(by);
        (lo / f, hi * f)
    } else {
        let d = by * (hi - lo);
        (lo - d, hi + d)
    }
}

/// Axis over a range from the data, or over the range that was requested; never degenerate.
pub(super) fn axis_view(axis: &Axis, data: Option<(f64, f64)>, style: &Style) -> AxisView {
    let log = axis.scale == Scale::Log;
    let wanted = axis.range.filter(|(a, b)| a.is_finite() && b.is_finite() && a < b && (!log || *a > 0.0));
    let (mut lo, mut hi) = wanted.or(data).unwrap_or(if log { (0.1, 10.0) } else { (0.0, 1.0) });
    if log {
        // more decades than this hide the data: the rest is rounding noise
        lo = lo.max(hi * 1e-15);
        if hi / lo < 1.0 + 1e-9 {
            (lo, hi) = (lo / 2.0, hi * 2.0);
        }
    } else if hi - lo <= 1e-12 * lo.abs().max(hi.abs()) {
        let d = if lo == 0.0 { 1.0 } else { 0.1 * lo.abs() };
        (lo, hi) = (lo - d, hi + d);
    }
    let view = AxisView::new(&style.arg(&axis.label), &axis.unit, log, lo, hi);
    let names = axis.names.iter().map(|(at, name)| (*at, style.arg(name))).collect();
    let knee = axis.knee.filter(|_| !log).unwrap_or(0.0);
    AxisView { bare: axis.bare, names, language: style.language, knee, exponent: if knee > 0.0 { 0 } else { view.exponent }, ..view }
}
