//! Findings of loci: where jumps begin, how far hysteresis reaches, where stability changes, and how far everything could be followed.

use super::report::{Shown, corner_name};
use crate::outcome::{Arg, Finding, Message, significant};
use crate::solve::harmonic::branches::bifurcation::Event;
use crate::solve::harmonic::loci::follow::PathEnd;
use crate::solve::harmonic::loci::search::{Corner, Locus, LocusKind, LocusPoint, MOST_LOCI};
use crate::study::nonlinear::nonlinear_response::unassessed;
use crate::study::shared::validity::Uses;

/// Largest difference, relative to the range of the parameter, of values that are the same.
const SAME: f64 = 1e-9;

fn span(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
}

impl Shown<'_> {
    fn of(&self, value: f64) -> Arg {
        Arg::quantity(value, self.unit)
    }
    fn path(&self) -> Arg {
        Arg::name(&self.request.parameter)
    }
    fn stopped(&self) -> Arg {
        Arg::word(if self.found.stopped { "yes" } else { "no" })
    }
    fn loci(&self) -> impl Iterator<Item = (usize, &Locus)> {
        self.found.loci.iter().enumerate().map(|(k, l)| (k + 1, l))
    }

    pub(super) fn findings(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        for (number, locus) in self.loci() {
            out.extend(locus.corners.iter().map(|c| self.corner(number, locus, c)));
        }
        out.extend(self.jumps());
        out.extend(self.hysteresis());
        for (number, locus) in self.loci() {
            out.extend(self.locus(number, locus));
            out.extend(self.unfinished(number, locus));
        }
        if self.found.loci.is_empty() {
            out.push(self.nothing());
        }
        out.extend(self.existence());
        if self.found.lost > 0 {
            out.push(Finding::warning("starts_lost", "bifurcation-loci-starts-lost").arg("count", Arg::count(self.found.lost)));
        }
        if let Some((value, why)) = self.found.failed.first() {
            out.push(
                Finding::warning("no_response", "bifurcation-loci-no-response")
                    .arg("count", Arg::count(self.found.failed.len()))
                    .arg("parameter", self.path())
                    .arg("first", self.of(*value))
                    .arg("why", Arg::term(why)),
            );
        }
        if self.found.corners > 0 && self.request.folds {
            out.push(Finding::warning("corners", "bifurcation-loci-corners").arg("count", Arg::count(self.found.corners)));
        }
        if self.found.more {
            out.push(Finding::warning("more_loci", "bifurcation-loci-more").arg("most", Arg::count(MOST_LOCI)));
        }
        if let Some(why) = &self.found.unassessed {
            out.push(Finding::warning("stability_unknown", "bifurcation-loci-stability-unknown").arg("why", unassessed(why)));
        }
        let dropped =
            self.found.loci.iter().flat_map(|l| &l.points).fold(0.0, |m: f64, p| if p.truncation <= m { m } else { p.truncation });
        if self.request.harmonics.is_none() && dropped > self.request.truncation {
            out.push(Finding::warning("harmonics_short", "bifurcation-loci-harmonics-short").value_as(Arg::percent(dropped)).evidence(
                "orders kept",
                self.found.discretisation.harmonics as f64,
                "",
            ));
        }
        out.extend(self.invalid());
        out
    }

    fn corner(&self, number: usize, locus: &Locus, c: &Corner) -> Finding {
        let t = &c.turn;
        let finding = match corner_name(locus, c) {
            "cusp" => Finding::info("cusp", "bifurcation-loci-cusp"),
            "folds meet" => Finding::info("folds_meet", "bifurcation-loci-folds-meet"),
            _ => Finding::info("stability_extremum", "bifurcation-loci-extremum").arg("kind", kind(locus)),
        };
        finding
            .of(subject(number))
            .arg("locus", Arg::count(number))
            .arg("parameter", self.path())
            .arg("speed", Arg::speed(c.speed))
            .arg("side", Arg::word(if t.opens_up { "above" } else { "below" }))
            .value(t.value, self.unit)
            .evidence("speed", c.speed, "rad/s")
            .evidence("scaled residual of the extended equations", t.residual, "")
            .evidence("difference of two methods", t.methods_differ.abs(), self.unit)
            .evidence("slope of the speed along the locus, scaled", t.slopes[0].abs(), "")
            .evidence("slope of the parameter along the locus, scaled", t.slopes[1].abs(), "")
            .evidence("change of the parameter with four more orders", c.harmonics_change[1].abs(), self.unit)
            .evidence("change of the speed with four more orders", c.harmonics_change[0].abs(), "rad/s")
    }

    /// Least and largest value of the parameter with folds, over all loci, and speeds over which they spread there.
    fn jumps(&self) -> Option<Finding> {
        let folds = || self.found.loci.iter().filter(|l| l.kind == LocusKind::Fold);
        let values = |l: &Locus| span(l.points.iter().map(|p| p.value).chain(l.corners.iter().map(|c| c.turn.value)));
        let (lo, hi) = span(folds().flat_map(|l| [values(l).0, values(l).1]));
        if !(lo <= hi) {
            return None;
        }
        let same = |a: f64, b: f64| (a - b).abs() <= SAME * (self.found.exists.1 - self.found.exists.0);
        let limit = |end: f64, edge: f64| {
            let corners = folds().flat_map(|l| l.corners.iter().map(move |c| (corner_name(l, c), c.turn.value)));
            let here = match corners.into_iter().find(|c| same(c.1, end)) {
                Some(("cusp", _)) => "cusp",
                Some(_) => "folds-meet",
                None if same(end, edge) => "range",
                None => "left",
            };
            Message::new("bifurcation-loci-limit").arg("limit", Arg::word(here)).arg("stopped", self.stopped())
        };
        let (below, above) = (limit(lo, self.found.exists.0), limit(hi, self.found.exists.1));
        let speeds = span(folds().flat_map(|l| l.points.iter().map(|p| p.speed).chain(l.corners.iter().map(|c| c.speed))));
        Some(
            Finding::info("folds_from", "bifurcation-loci-folds")
                .value(lo, self.unit)
                .arg("parameter", self.path())
                .arg("largest", self.of(hi))
                .arg("below", below)
                .arg("above", above)
                .arg("place", place(speeds))
                .arg("stopped", self.stopped())
                .evidence("largest value", hi, self.unit)
                .evidence("lowest speed", speeds.0, "rad/s")
                .evidence("highest speed", speeds.1, "rad/s"),
        )
    }

    /// Arms of folds that belong together, and the sign of the difference of their speeds: beside a cusp, and between the folds of a sampled response.
    fn arms(&self) -> Vec<([&[LocusPoint]; 2], Option<f64>)> {
        let loci = &self.found.loci;
        let mut out = Vec::new();
        for locus in loci.iter().filter(|l| l.kind == LocusKind::Fold) {
            let arms = arms(locus);
            let cusps = locus.corners.iter().enumerate().filter(|(_, c)| c.turn.speed_turns);
            out.extend(cusps.filter_map(|(k, _)| Some(([*arms.get(k)?, *arms.get(k + 1)?], None))));
        }
        for pair in &self.found.pairs {
            let arm = |(locus, after): (usize, usize)| arm_of(loci.get(locus)?, after, pair.value);
            if let [Some(a), Some(b)] = pair.on.map(arm) {
                out.push(([a, b], Some((pair.speeds[0] - pair.speeds[1]).signum())));
            }
        }
        out
    }

    /// Where two folds that belong together lie farthest apart: the widest range of speeds in which the state depends on how it was reached.
    fn hysteresis(&self) -> Option<Finding> {
        let mut widest: Option<(f64, f64, f64)> = None;
        for ([a, b], sign) in self.arms() {
            // compared at the values of points of either
            for (points, others, turned) in [(a, b, 1.0), (b, a, -1.0)] {
                for p in points {
                    let Some(speed) = speed_at(others, p.value) else { continue };
                    let (lo, hi) = (p.speed.min(speed), p.speed.max(speed));
                    let ordered = sign.is_none_or(|s| s * turned * (p.speed - speed) > 0.0);
                    if ordered && widest.is_none_or(|w| hi - lo > w.2 - w.1) {
                        widest = Some((p.value, lo, hi));
                    }
                }
            }
        }
        let (value, lo, hi) = widest?;
        let (from, to) = self.request.speeds;
        let at_edge = |speed: f64, edge: f64| (speed - edge).abs() <= SAME * (to - from);
        let cut = at_edge(lo, from) || at_edge(hi, to);
        Some(
            Finding::info("widest_hysteresis", "bifurcation-loci-widest-hysteresis")
                .value(hi - lo, "rad/s")
                .arg("parameter", self.path())
                .arg("at", self.of(value))
                .arg("lower", Arg::speed(lo))
                .arg("cut", Arg::word(if cut { "yes" } else { "no" }))
                .arg("stopped", self.stopped())
                .evidence("parameter", value, self.unit)
                .evidence("lower fold", lo, "rad/s")
                .evidence("upper fold", hi, "rad/s"),
        )
    }

    fn locus(&self, number: usize, locus: &Locus) -> Option<Finding> {
        let (first, last) = (locus.points.first()?, locus.points.last()?);
        let residual = locus.points.iter().fold(0.0, |m: f64, p| if p.residual <= m { m } else { p.residual });
        let end = |p: &LocusPoint, end: &PathEnd| {
            let at = Message::new("bifurcation-loci-end").arg("value", self.of(p.value)).arg("speed", Arg::speed(p.speed));
            at.arg("end", Arg::word(word(end)))
        };
        let course = if locus.ends[0] == PathEnd::Closed {
            Message::new("bifurcation-loci-closed")
        } else {
            Message::new("bifurcation-loci-from-to").arg("from", end(first, &locus.ends[0])).arg("to", end(last, &locus.ends[1]))
        };
        let common = |f: Finding| {
            f.of(subject(number))
                .arg("locus", Arg::count(number))
                .arg("course", course)
                .evidence("largest scaled residual", residual, "")
                .evidence("points", locus.points.len() as f64, "")
        };
        Some(match locus.kind {
            LocusKind::Fold => common(Finding::info("fold_locus", "bifurcation-loci-fold-locus")),
            LocusKind::Change(event) => {
                let (lo, hi) = span(locus.points.iter().filter_map(|p| Some(p.crossing?.1)).filter(|f| f.is_finite()));
                let beside = locus.points.iter().filter(|p| p.crossing.is_some_and(|c| c.2 > 0)).count();
                let growth =
                    locus.points.iter().filter_map(|p| Some(p.crossing?.0.abs())).fold(0.0, |m: f64, g| if g <= m { m } else { g });
                let others = match beside {
                    0 => "none",
                    n if n == locus.points.len() => "all",
                    _ => "part",
                };
                let f = common(Finding::info("stability_locus", "bifurcation-loci-stability-locus"))
                    .arg("kind", kind(locus))
                    .arg("others", Arg::word(others))
                    .evidence("largest growth rate left", growth, "1/s");
                let whirl = event == Event::NeimarkSacker && lo <= hi;
                let f = f.arg("whirl", Arg::word(if whirl { "yes" } else { "no" }));
                let f = if whirl { f.arg("lowest", Arg::frequency(lo)).arg("highest", Arg::frequency(hi)) } else { f };
                let (difference, assessed) = locus.assessed_again;
                if assessed == 0 {
                    f
                } else {
                    f.evidence("points assessed again by Hill's method", assessed as f64, "").evidence(
                        "its largest difference of the growth rate",
                        difference,
                        "1/s",
                    )
                }
            }
        })
    }

    fn unfinished(&self, number: usize, locus: &Locus) -> Vec<Finding> {
        let places = [locus.points.first(), locus.points.last()];
        let ends = locus.ends.iter().zip(places).filter_map(|(e, p)| match e {
            PathEnd::Stuck(why) => Some((why, p?)),
            _ => None,
        });
        ends.map(|(why, p)| {
            Finding::warning("locus_unfinished", "bifurcation-loci-unfinished")
                .of(subject(number))
                .value(p.value, self.unit)
                .arg("locus", Arg::count(number))
                .arg("parameter", self.path())
                .arg("speed", Arg::speed(p.speed))
                .arg("why", Arg::term(*why))
        })
        .collect()
    }

    fn nothing(&self) -> Finding {
        let (folds, changes) = self.found.samples.iter().fold((0, 0), |(f, c), s| (f + s.folds, c + s.changes));
        let sought = match (self.request.folds, self.request.stability) {
            (true, true) => "both",
            (true, false) => "folds",
            _ => "stability",
        };
        let beside = match () {
            () if !self.request.folds && folds > 0 => "folds",
            () if self.found.lost > 0 || changes > 0 => "lost",
            () => "none",
        };
        Finding::info("no_locus", "bifurcation-loci-none")
            .arg("sought", Arg::word(sought))
            .arg("beside", Arg::word(beside))
            .arg("folds", Arg::count(folds))
            .arg("values", Arg::count(self.found.samples.len()))
            .arg("parameter", self.path())
            .arg("stopped", self.stopped())
    }

    /// That the machine does not exist in a part of the range.
    fn existence(&self) -> Vec<Finding> {
        let (lo, hi) = self.found.exists;
        let [below, above] = &self.found.refused;
        let beyond =
            [(below, lo, "below"), (above, hi, "above")].into_iter().filter_map(|(why, edge, side)| Some((why.as_ref()?, edge, side)));
        let one = |(why, edge, side): (&String, f64, &'static str)| {
            Finding::warning("parameter_range", "bifurcation-loci-parameter-range")
                .value(edge, self.unit)
                .arg("parameter", self.path())
                .arg("side", Arg::word(side))
                .arg("why", Arg::term(why))
        };
        beyond.map(one).collect()
    }

    fn invalid(&self) -> Vec<Finding> {
        let mut uses = Uses::default();
        self.points.iter().chain(self.corners).flatten().filter_map(|s| s.uses.as_ref()).for_each(|u| uses.join(u));
        uses.of_motions(self.system, "motions on the loci")
    }
}

/// Points of a locus between the places where it turns back in the parameter.
fn arms(locus: &Locus) -> Vec<&[LocusPoint]> {
    let count = locus.points.len();
    let turns = locus.corners.iter().map(|c| (c.turn.after + 1).min(count));
    let edges: Vec<usize> = [0].into_iter().chain(turns).chain([count]).collect();
    edges.windows(2).map(|w| locus.points.get(w[0]..w[1]).unwrap_or(&[])).collect()
}

/// The arm on which a fold at a value of the parameter lies, after a point of the locus.
fn arm_of(locus: &Locus, after: usize, value: f64) -> Option<&[LocusPoint]> {
    let arms = arms(locus);
    let turned = locus.corners.iter().position(|c| c.turn.after >= after).unwrap_or(locus.corners.len());
    // where it turns back after the same point the fold lies on the arm that reaches its value
    let beyond = locus.corners.get(turned).is_some_and(|c| {
        let off = |p: Option<&LocusPoint>| p.map_or(0.0, |p| (p.value - c.turn.value).abs());
        let far = (value - c.turn.value).abs();
        c.turn.after == after && off(locus.points.get(after)) < far && off(locus.points.get(after + 1)) >= far
    });
    arms.get(turned + usize::from(beyond)).copied()
}

/// Speed at a value of the parameter on an arm of a locus, between its points; its own where the value is that of a point.
fn speed_at(arm: &[LocusPoint], value: f64) -> Option<f64> {
    arm.windows(2).find(|w| (w[0].value - value) * (w[1].value - value) <= 0.0 && w[0].value != w[1].value).map(|w| {
        let t = (value - w[0].value) / (w[1].value - w[0].value);
        w[0].speed + t * (w[1].speed - w[0].speed)
    })
}

/// One speed or a range of them.
fn place((lo, hi): (f64, f64)) -> Message {
    let [a, b] = [lo, hi].map(|w| significant(w, 4));
    if a == b {
        Message::new("at").arg("at", Arg::speed(lo))
    } else {
        Message::new("range").arg("from", Arg::speed(lo)).arg("to", Arg::speed(hi))
    }
}

/// By which other programs find a locus.
fn subject(number: usize) -> String {
    format!("locus {number}")
}

/// What happens on a locus.
fn kind(locus: &Locus) -> Message {
    let word = match locus.kind {
        LocusKind::Fold => "fold",
        LocusKind::Change(Event::BranchPoint) => "branch-point",
        LocusKind::Change(Event::SymmetryBreaking) => "symmetry-breaking",
        LocusKind::Change(Event::PeriodDoubling) => "period-doubling",
        LocusKind::Change(Event::NeimarkSacker) => "neimark-sacker",
    };
    Message::new("bifurcation-loci-kind").arg("kind", Arg::word(word))
}

fn word(end: &PathEnd) -> &'static str {
    match end {
        PathEnd::Value => "value",
        PathEnd::Speed => "speed",
        PathEnd::Closed => "closed",
        PathEnd::Stuck(_) => "stuck",
        PathEnd::MaxPoints => "points",
        PathEnd::Cancelled => "stopped",
    }
}
