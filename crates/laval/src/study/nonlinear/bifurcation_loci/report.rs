//! What a reader sees of loci: displacements and validity of their motions, tables, the figure.

use super::{BifurcationLoci, BifurcationLociResult, Measured};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{
    self, Arg, Axis, Figure, Line, Message, Outcome, OutcomeError, Panel, Points, SpecialPoint, Status, Table, parameter_name,
};
use crate::solve::harmonic::loci::search::{Corner, Loci, Locus, LocusKind, LocusPoint, Request};
use crate::study::Study;
use crate::study::shared::probes;

/// Everything that is shown.
pub(super) struct Shown<'a> {
    pub(super) system: &'a System,
    pub(super) request: &'a Request,
    pub(super) found: &'a Loci,
    pub(super) unit: &'static str,
    /// Probes that are measured, the reference points of the bodies first.
    pub(super) probes: Vec<Probe>,
    /// By locus and point.
    pub(super) points: &'a [Vec<Measured>],
    /// By locus and corner.
    pub(super) corners: &'a [Vec<Measured>],
}

/// What to call a place where a locus turns back in the parameter.
pub(super) fn corner_name(locus: &Locus, corner: &Corner) -> &'static str {
    match (locus.kind, corner.turn.speed_turns) {
        (LocusKind::Fold, true) => "cusp",
        (LocusKind::Fold, false) => "folds meet",
        _ => "extremum",
    }
}

impl<'a> Shown<'a> {
    pub(super) fn new(system: &'a System, request: &'a Request, result: &'a BifurcationLociResult) -> Self {
        let unit = super::unit(system, &request.parameter);
        let BifurcationLociResult { found, points, corners, .. } = result;
        Shown { system, request, found, unit, probes: probes::all(system), points, corners }
    }

    pub(super) fn outcome(&self, name: &str, end: outcome::End) -> Result<Outcome, OutcomeError> {
        let (found, path) = (self.found, self.request.parameter.as_str());
        let mut out = Outcome::new(BifurcationLoci::KIND, name).over(path, self.unit).end(end);
        for f in self.findings() {
            out = out.finding(f);
        }
        if found.loci.iter().any(|l| !l.points.is_empty()) {
            out = out.table(self.table()?);
            let corners = self.corner_table()?;
            let marked = corners.rows() > 0;
            if marked {
                out = out.table(corners);
            }
            out = out.figure(self.figure(marked));
        }
        if !found.samples.is_empty() {
            out = out.table(self.sample_table()?);
        }
        for (k, locus) in found.loci.iter().enumerate() {
            for c in &locus.corners {
                let t = &c.turn;
                let ends = [t.value, t.bracket.0, t.bracket.1];
                let bracket = ends.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
                let point = SpecialPoint::new(corner_name(locus, c), t.value, bracket)
                    .of(format!("locus {}", k + 1))
                    .status(if t.confirmed { Status::Located } else { Status::Bracketed })
                    .evidence("speed", c.speed, "rad/s")
                    .evidence("scaled residual", t.residual, "")
                    .evidence("difference of two methods", t.methods_differ.abs(), self.unit)
                    .evidence("change with four more orders", c.harmonics_change[1].abs(), self.unit);
                out = out.special_point(point);
            }
        }
        for &(name, count) in &found.work {
            out = out.work(name, count);
        }
        out.checked()
    }

    /// All points, with the number of their locus and whether they begin it.
    fn rows(&self) -> Vec<(usize, bool, &Locus, &LocusPoint, &Measured)> {
        let of = |(k, l): (usize, &'a Locus)| {
            l.points.iter().zip(&self.points[k]).enumerate().map(move |(i, (p, s))| (k + 1, i == 0, l, p, s)).collect::<Vec<_>>()
        };
        self.found.loci.iter().enumerate().flat_map(of).collect()
    }

    fn table(&self) -> Result<Table, OutcomeError> {
        let rows = self.rows();
        let crossing = |f: &dyn Fn((f64, f64, usize)) -> f64| rows.iter().map(|r| r.3.crossing.map_or(f64::NAN, f)).collect::<Vec<f64>>();
        let mut t = Table::new("loci", "Bifurcations in the plane of speed and parameter, locus by locus in order along each")
            .int("locus", "", "number of the locus", rows.iter().map(|r| r.0 as i64).collect())
            .text("kind", "what happens there", rows.iter().map(|r| r.2.kind.name().to_string()).collect())
            .flag("begins", "first point of its locus", rows.iter().map(|r| r.1).collect())
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| r.3.speed).collect())
            .float(self.request.parameter.clone(), self.unit, "parameter", rows.iter().map(|r| r.3.value).collect());
        for (k, p) in self.probes.iter().enumerate() {
            t = t.float(probes::largest_column(p), p.unit(), probes::largest_doc(p), rows.iter().map(|r| r.4.sizes[k]).collect());
        }
        if self.request.stability {
            let bounds = |r: &(usize, bool, &Locus, &LocusPoint, &Measured)| r.3.crossing.is_none_or(|c| c.2 == 0);
            t = t
                .float("frequency", "rad/s", "frequency of the disturbance that starts or ceases to grow; NaN at folds", crossing(&|c| c.1))
                .float("growth rate", "1/s", "growth rate left there: how well it is located; NaN at folds", crossing(&|c| c.0))
                .float("growing beside", "", "other exponents that grow there; NaN at folds", crossing(&|c| c.2 as f64))
                .flag("bounds stability", "stable states end here; of folds not assessed", rows.iter().map(bounds).collect());
        }
        t.float("truncation", "", "dropped over kept force harmonics", rows.iter().map(|r| r.3.truncation).collect())
            .float("residual", "", "scaled residual of the extended equations", rows.iter().map(|r| r.3.residual).collect())
            .float(
                "validity",
                "",
                "largest use of a part's validity; above 1 is outside",
                rows.iter().map(|r| r.4.uses.as_ref().map_or(f64::NAN, |u| finite(u.worst(self.system).0))).collect(),
            )
            .build()
    }

    fn corner_table(&self) -> Result<Table, OutcomeError> {
        let loci = self.found.loci.iter().enumerate();
        let rows: Vec<(usize, &Locus, &Corner, &Measured)> =
            loci.flat_map(|(k, l)| l.corners.iter().zip(&self.corners[k]).map(move |(c, s)| (k + 1, l, c, s))).collect();
        let float = |f: &dyn Fn(&Corner) -> f64| rows.iter().map(|r| f(r.2)).collect::<Vec<f64>>();
        let mut t = Table::new("turns", "Places where a locus turns back in the parameter")
            .int("locus", "", "number of the locus", rows.iter().map(|r| r.0 as i64).collect())
            .text(
                "kind",
                "cusp: the speed turns back as well, two folds vanish; folds meet: branches exchange their parts, or a detached one begins",
                rows.iter().map(|r| corner_name(r.1, r.2).to_string()).collect(),
            )
            .float("speed", "rad/s", "spin speed", float(&|c| c.speed))
            .float(self.request.parameter.clone(), self.unit, "parameter", float(&|c| c.turn.value));
        for (k, p) in self.probes.iter().enumerate() {
            t = t.float(probes::largest_column(p), p.unit(), probes::largest_doc(p), rows.iter().map(|r| r.3.sizes[k]).collect());
        }
        t.float("residual", "", "scaled residual of the extended equations", float(&|c| c.turn.residual))
            .float(
                "methods differ",
                self.unit,
                "parameter by the extended equations minus parameter located along the locus; NaN when the first found none",
                float(&|c| c.turn.methods_differ),
            )
            .float(
                "speed change",
                "rad/s",
                "change of the speed when four more orders are kept; NaN when not found",
                float(&|c| c.harmonics_change[0]),
            )
            .float(
                "parameter change",
                self.unit,
                "change of the parameter when four more orders are kept",
                float(&|c| c.harmonics_change[1]),
            )
            .build()
    }

    fn sample_table(&self) -> Result<Table, OutcomeError> {
        let samples = &self.found.samples;
        Table::new("starts", "Values of the parameter at which the response was computed to find starts")
            .float(self.request.parameter.clone(), self.unit, "parameter", samples.iter().map(|s| s.value).collect())
            .int("folds", "", "folds of the response", samples.iter().map(|s| s.folds as i64).collect())
            .int("changes", "", "other places where stable states begin or end", samples.iter().map(|s| s.changes as i64).collect())
            .build()
    }

    /// Loci in the plane, folds apart from changes of stability, corners marked.
    fn figure(&self, corners: bool) -> Figure {
        let path = self.request.parameter.as_str();
        let values = self.found.loci.iter().flat_map(|l| &l.points).map(|p| p.value.abs());
        let largest = values.fold(0.0, f64::max);
        let (unit, factor) = match self.unit {
            "m" if largest < 1e-3 => ("µm", 1e6),
            "m" => ("mm", 1e3),
            unit => (unit, 1.0),
        };
        let line = Line::new("loci", "speed", path).group("kind").begins_where("begins");
        let line = if self.request.stability {
            line.solid_where("bounds stability").meaning("folds and bounds of stability", "other growth beside")
        } else {
            line
        };
        let mut panel = Panel::new(Axis::new(parameter_name(path), unit).factor(factor)).mark(line);
        if corners {
            panel = panel.mark(Points::new("turns", "speed", path).group("kind"));
        }
        Figure::new("loci", "Loci of bifurcations", self.alt()).x(self.speeds()).panel(panel)
    }

    /// The axis of the speed, a little wider than the loci.
    fn speeds(&self) -> Axis {
        let speeds = || self.found.loci.iter().flat_map(|l| &l.points).map(|p| p.speed);
        let (lo, hi) = speeds().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), w| (a.min(w), b.max(w)));
        let margin = (0.04 * (hi - lo)).max(2e-3 * lo.abs().max(hi.abs()));
        let axis = Axis::new("spin speed", "rad/s");
        if lo <= hi { axis.range(lo - margin, hi + margin) } else { axis }
    }

    fn alt(&self) -> Message {
        let loci = &self.found.loci;
        let folds = loci.iter().filter(|l| l.kind == LocusKind::Fold).count();
        let cusps = loci.iter().map(|l| l.corners.iter().filter(|c| corner_name(l, c) == "cusp").count()).sum();
        Message::new("bifurcation-loci-alt")
            .arg("parameter", parameter_name(&self.request.parameter))
            .arg("folds", Arg::count(folds))
            .arg("others", Arg::count(loci.len() - folds))
            .arg("cusps", Arg::count(cusps))
    }
}

/// A number, or none where it is without bound.
fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { f64::NAN }
}
