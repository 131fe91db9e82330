//! What is said of loci: where jumps begin, how far hysteresis reaches, where stability changes, and how far everything could be followed.

use super::report::{Shown, corner_name};
use crate::outcome::{Finding, quantity, significant};
use crate::solve::harmonic::loci::follow::PathEnd;
use crate::solve::harmonic::loci::search::{Corner, Locus, LocusKind, LocusPoint, MOST_LOCI};
use crate::study::shared::validity::Uses;

/// Largest difference, relative to the range of the parameter, of values that are the same.
const SAME: f64 = 1e-9;

fn span(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
}

impl Shown<'_> {
    fn of(&self, value: f64) -> String {
        quantity(value, self.unit)
    }
    fn path(&self) -> &str {
        &self.request.parameter
    }
    fn loci(&self) -> impl Iterator<Item = (String, &Locus)> {
        self.found.loci.iter().enumerate().map(|(k, l)| (format!("locus {}", k + 1), l))
    }

    pub(super) fn findings(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        for (name, locus) in self.loci() {
            out.extend(locus.corners.iter().map(|c| self.corner(&name, locus, c)));
        }
        out.extend(self.jumps());
        out.extend(self.hysteresis());
        for (name, locus) in self.loci() {
            out.extend(self.locus(&name, locus));
            out.extend(self.unfinished(&name, locus));
        }
        if self.found.loci.is_empty() {
            out.push(self.nothing());
        }
        out.extend(self.existence());
        if self.found.lost > 0 {
            let n = self.found.lost;
            let text = format!("From {n} of the bifurcations of the sampled responses no locus could be followed.");
            out.push(Finding::warning("starts_lost", text));
        }
        if let Some((value, why)) = self.found.failed.first() {
            let n = self.found.failed.len();
            let text = format!("No response was computed at {n} of the values of {}; at {}: {why}.", self.path(), self.of(*value));
            out.push(Finding::warning("no_response", text));
        }
        if self.found.corners > 0 && self.request.folds {
            let n = self.found.corners;
            let text = format!(
                "{n} of the folds met lie where the law of a part changes along the motion (as where a contact closes): such corners are not followed."
            );
            out.push(Finding::warning("corners", text));
        }
        if self.found.more {
            let text = format!("There are more than {MOST_LOCI} loci; the others were not followed. Narrow the range of speeds.");
            out.push(Finding::warning("more_loci", text));
        }
        if let Some(why) = &self.found.unassessed {
            out.push(Finding::warning(
                "stability_unknown",
                format!("Stability of some or all states was not assessed, and loci of changes of stability may be missing: {why}."),
            ));
        }
        let dropped =
            self.found.loci.iter().flat_map(|l| &l.points).fold(0.0, |m: f64, p| if p.truncation <= m { m } else { p.truncation });
        if self.request.harmonics.is_none() && dropped > self.request.truncation {
            out.push(
                Finding::warning(
                    "harmonics_short",
                    "The harmonics kept leave out {} of the nonlinear force at the worst point of the loci.",
                )
                .value(dropped, "")
                .shown_as(100.0 * dropped, "%")
                .evidence("orders kept", self.found.discretisation.harmonics as f64, ""),
            );
        }
        out.extend(self.invalid());
        out
    }

    fn corner(&self, name: &str, locus: &Locus, c: &Corner) -> Finding {
        let (path, speed, t) = (self.path(), significant(c.speed, 7), &c.turn);
        let here = if t.opens_up { "larger" } else { "smaller" };
        let finding = match corner_name(locus, c) {
            "cusp" => Finding::info(
                "cusp",
                format!("Two folds vanish in a cusp at {path} = {{}} and {speed} rad/s: they exist at {here} values only."),
            ),
            "folds meet" => Finding::info(
                "folds_meet",
                format!(
                    "Two folds meet at {path} = {{}} and {speed} rad/s and exist at {here} values only: there a detached branch begins, or branches exchange their parts."
                ),
            ),
            _ => Finding::info(
                "stability_extremum",
                format!("{} turns back at {path} = {{}} and {speed} rad/s: it lies at {here} values only.", capital(locus.kind.name())),
            ),
        };
        finding
            .of(name)
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
        let why = |end: f64, edge: f64| {
            let corner = folds()
                .flat_map(|l| l.corners.iter().map(move |c| corner_name(l, c)).zip(&l.corners))
                .find(|(_, c)| same(c.turn.value, end));
            match corner {
                Some((name, _)) => name,
                None if same(end, edge) => "the end of the range",
                None if self.found.stopped => "where a locus leaves the range of speeds, was left or stopped",
                None => "where a locus leaves the range of speeds or was left",
            }
        };
        let (below, above) = (why(lo, self.found.exists.0), why(hi, self.found.exists.1));
        let speeds = span(folds().flat_map(|l| l.points.iter().map(|p| p.speed).chain(l.corners.iter().map(|c| c.speed))));
        let text = format!(
            "Folds were found at values of {} from {{}} ({below}) to {} ({above}), {}.{}",
            self.path(),
            self.of(hi),
            spread(speeds),
            self.so_far()
        );
        Some(
            Finding::info("folds_from", text)
                .value(lo, self.unit)
                .evidence("largest value", hi, self.unit)
                .evidence("lowest speed", speeds.0, "rad/s")
                .evidence("highest speed", speeds.1, "rad/s"),
        )
    }

    /// What of a study that was stopped is not known.
    fn so_far(&self) -> &'static str {
        if self.found.stopped { " The study was stopped: there may be others." } else { "" }
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
        let cut = if at_edge(lo, from) || at_edge(hi, to) {
            " One of them leaves the range of speeds there: beyond it they lie farther apart."
        } else {
            ""
        };
        let text = format!(
            "Two folds that belong together lie farthest apart at {} = {}: between {} and {} rad/s, over {{}}, there are several states.{cut}{}",
            self.path(),
            self.of(value),
            significant(lo, 6),
            significant(hi, 6),
            self.so_far()
        );
        Some(
            Finding::info("widest_hysteresis", text)
                .value(hi - lo, "rad/s")
                .evidence("parameter", value, self.unit)
                .evidence("lower fold", lo, "rad/s")
                .evidence("upper fold", hi, "rad/s"),
        )
    }

    fn locus(&self, name: &str, locus: &Locus) -> Option<Finding> {
        let (first, last) = (locus.points.first()?, locus.points.last()?);
        let at = |speed: f64, value: f64| format!("{} rad/s, {}", significant(speed, 6), self.of(value));
        let residual = locus.points.iter().fold(0.0, |m: f64, p| if p.residual <= m { m } else { p.residual });
        let ends = if locus.ends[0] == PathEnd::Closed {
            "closed on itself".to_string()
        } else {
            format!(
                "from {} ({}) to {} ({})",
                at(first.speed, first.value),
                words(&locus.ends[0]),
                at(last.speed, last.value),
                words(&locus.ends[1])
            )
        };
        let common =
            |f: Finding| f.of(name).evidence("largest scaled residual", residual, "").evidence("points", locus.points.len() as f64, "");
        Some(match locus.kind {
            LocusKind::Fold => common(Finding::info("fold_locus", format!("{}: folds {ends}.", capital(name)))),
            LocusKind::Change(event) => {
                let (lo, hi) = span(locus.points.iter().filter_map(|p| Some(p.crossing?.1)).filter(|f| f.is_finite()));
                let beside = locus.points.iter().filter(|p| p.crossing.is_some_and(|c| c.2 > 0)).count();
                let growth =
                    locus.points.iter().filter_map(|p| Some(p.crossing?.0.abs())).fold(0.0, |m: f64, g| if g <= m { m } else { g });
                let frequency = match event.name() {
                    "Neimark-Sacker" if lo <= hi => {
                        format!(", of disturbances between {} and {} rad/s", significant(lo, 4), significant(hi, 4))
                    }
                    _ => String::new(),
                };
                let other = match beside {
                    0 => String::new(),
                    n if n == locus.points.len() => " Other disturbances grow all along it.".into(),
                    _ => " On a part of it other disturbances grow as well: there it bounds no stable states.".into(),
                };
                let text = format!("{}: {} {ends}{frequency}.{other}", capital(name), event.name());
                let f = common(Finding::info("stability_locus", text)).evidence("largest growth rate left", growth, "1/s");
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

    fn unfinished(&self, name: &str, locus: &Locus) -> Vec<Finding> {
        let places = [locus.points.first(), locus.points.last()];
        let ends = locus.ends.iter().zip(places).filter_map(|(e, p)| match e {
            PathEnd::Stuck(why) => Some((why, p?)),
            _ => None,
        });
        ends.map(|(why, p)| {
            let head = format!("{} could be followed to {{}} at {} rad/s only: {why}.", capital(name), significant(p.speed, 6));
            Finding::warning("locus_unfinished", head).of(name).value(p.value, self.unit)
        })
        .collect()
    }

    fn nothing(&self) -> Finding {
        let n = self.found.samples.len();
        let (folds, changes) = self.found.samples.iter().fold((0, 0), |(f, c), s| (f + s.folds, c + s.changes));
        let what = match (self.request.folds, self.request.stability) {
            (true, true) => "No fold and no other change of stability",
            (true, false) => "No fold",
            _ => "No change of stability away from folds",
        };
        let beside = match () {
            () if !self.request.folds && folds > 0 => format!(" ({folds} folds were not requested)"),
            () if self.found.lost > 0 || changes > 0 => " that could be followed".into(),
            () => String::new(),
        };
        let at = format!("at {n} {} of {}", if n == 1 { "value" } else { "values" }, self.path());
        let text = match self.found.stopped {
            true => format!("{what} was found{beside} before the study stopped, with responses {at}."),
            false => {
                format!("{what} was found{beside} in the response {at}. Loci that lie between these values are not excluded: raise points.")
            }
        };
        Finding::info("no_locus", text)
    }

    /// That the machine does not exist in a part of the range.
    fn existence(&self) -> Vec<Finding> {
        let (lo, hi) = self.found.exists;
        let say = |(why, edge, word): (&Option<String>, f64, &str)| {
            let why = why.as_ref()?;
            let text =
                format!("The machine exists at values of {} {word} {{}} only, and the rest of the range was left out: {why}.", self.path());
            Some(Finding::warning("parameter_range", text).value(edge, self.unit))
        };
        let [below, above] = &self.found.refused;
        [(below, lo, "from"), (above, hi, "up to")].into_iter().filter_map(say).collect()
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

/// A range of speeds in words.
fn spread((lo, hi): (f64, f64)) -> String {
    let [a, b] = [lo, hi].map(|w| significant(w, 6));
    if a == b { format!("all at {a} rad/s") } else { format!("at speeds from {a} to {b} rad/s") }
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |c| c.to_uppercase().chain(letters).collect())
}

fn words(end: &PathEnd) -> &'static str {
    match end {
        PathEnd::Value => "the end of the parameter's range",
        PathEnd::Speed => "where it leaves the range of speeds",
        PathEnd::Closed => "closed on itself",
        PathEnd::Stuck(_) => "where it was left",
        PathEnd::MaxPoints => "as many points as allowed",
        PathEnd::Cancelled => "where it was stopped",
    }
}
