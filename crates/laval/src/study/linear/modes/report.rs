//! Table and figure of the modes at one speed.

use super::along::Along;
use super::shapes::across;
use super::{Modes, ModesResult, WHIRLS, amplitude};
use crate::diagnostic::Diagnostic;
use crate::model::part::{DofKind, Domain, Physics, Words};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Message, Outcome, Panel, Points, Rule, Table};
use crate::solve::pencil::{Linearised, MachineMode};
use crate::solve::roots::LEAST;
use crate::study::Study;
use crate::study::linear::over_frequency::{self, Searched};
use crate::study::shared::probes;
use crate::study::shared::region;
use crate::study::shared::support::{ROUNDING, growth_error, growth_rounding, hertz, inconsistent};
use laval_num::complex::C64;
use laval_num::dense::{Lu, Mat};

pub(super) struct Shown<'a> {
    pub study: &'a Modes,
    pub system: &'a System,
    pub result: &'a ModesResult,
    /// Growth that is rounding beside the largest eigenvalue.
    pub rounding: f64,
    /// Of a part with waves that nothing inside it damps: they grow slowly with any damping outside it.
    pub undamped: Option<Words>,
    /// Growth from which on a mode counts as unstable.
    pub threshold: f64,
}

impl<'a> Shown<'a> {
    pub fn new(study: &'a Modes, system: &'a System, result: &'a ModesResult) -> Self {
        // beside the largest eigenvalue, what is smaller than this is rounding
        let rounding = growth_rounding(&result.spectrum);
        let undamped = system.domains(study.speed).into_iter().find(Domain::undamped).map(|d| d.words);
        let undamped = undamped.filter(|_| result.roots.is_some());
        let threshold = if undamped.is_some() { study.threshold.max(LEAST * study.speed.abs()) } else { study.threshold };
        Shown { study, system, result, rounding, undamped, threshold }
    }

    /// The outcome; `whole` is the machine with all its coefficients.
    pub fn outcome(&self, name: &str, whole: &System) -> Result<Outcome, Diagnostic> {
        let along = self.along();
        let out = Outcome::new(Modes::KIND, name)
            .end(self.result.end)
            .table(self.table(along.as_ref())?)
            .work("eigenproblems", 1)
            .work("polished modes", self.result.spectrum.polished as u64);
        let mut findings = self.findings();
        if let Some(own) = &self.result.own {
            findings.extend(over_frequency::own_findings(whole, &Searched::at_one(own)));
            let frequencies: Vec<(usize, f64)> = self.modes().iter().map(MachineMode::frequency).enumerate().collect();
            over_frequency::mark(whole, &frequencies, &mut findings);
        }
        let mut out = findings.into_iter().fold(out, Outcome::finding);
        if let Some(roots) = &self.result.roots {
            out = out.table(region::areas(roots)?);
        }
        if let Some(shapes) = &self.result.shapes {
            let along = along.as_ref();
            let figure = shapes.figure(self.system, self.modes(), self.study.speed, along, |m| self.grows(m));
            out = out.table(shapes.table().build().map_err(inconsistent)?).figure(figure);
            let curves = along.and_then(|a| a.figure(self.system, &shapes.stations, self.modes(), self.study.speed, |m| self.grows(m)));
            if let Some((table, figure)) = curves {
                out = out.table(table.build().map_err(inconsistent)?).figure(figure);
            }
        }
        // a table tells few modes better
        out = if self.modes().len() < FEW { out } else { out.figure(self.figure()) };
        out.checked().map_err(inconsistent)
    }

    pub fn modes(&self) -> &'a [MachineMode] {
        &self.result.spectrum.modes
    }

    /// Growth below the rounding of the eigenvalue is no growth.
    fn above(&self, m: &MachineMode, limit: f64) -> bool {
        !(m.growth() <= limit + growth_error(m, self.rounding))
    }

    pub fn unstable(&self, m: &MachineMode) -> bool {
        self.above(m, self.threshold)
    }

    pub fn grows(&self, m: &MachineMode) -> bool {
        self.above(m, self.study.threshold)
    }

    /// Motion along and about the axis. Of parts without time form the masses are not known.
    fn along(&self) -> Option<Along> {
        let timed = self.system.slots().iter().all(|s| !matches!(s.physics, Physics::Frequency(_)));
        timed.then(|| Along::of(self.system, &self.result.about, self.modes()))?
    }

    fn table(&self, along: Option<&Along>) -> Result<Table, Diagnostic> {
        let (modes, speed) = (self.modes(), self.study.speed);
        let column = |f: fn(&MachineMode) -> f64| modes.iter().map(f).collect::<Vec<f64>>();
        let mut table = Table::new("modes", Message::new("modes-table").arg("state", Arg::term(self.study.about.word())))
            .int("mode", "", "number in order of frequency", (1..=modes.len() as i64).collect())
            .float("growth", "1/s", "growth rate; above 0 the mode grows", column(MachineMode::growth))
            .float("frequency", "rad/s", "whirl frequency", column(MachineMode::frequency))
            .float("frequency_hz", "Hz", "whirl frequency", column(|m| hertz(m.frequency())))
            .float("damping_ratio", "", "-growth over the modulus of the eigenvalue", column(MachineMode::damping_ratio))
            .float_if_any("log_decrement", "", "logarithmic decrement; NaN without oscillation", column(log_decrement))
            .text(
                "whirl",
                "direction of whirl with respect to the spin; axial, torsional: along or about the axis alone; none without oscillation, and across the axis at standstill",
                modes.iter().map(|m| m.whirl.at(speed).word().into()).collect(),
            )
            .flag("stable", "growth rate not above growth_threshold", modes.iter().map(|m| !self.grows(m)).collect())
            .float_if_any(
                "forward_share",
                "",
                "forward part of the squared amplitudes; NaN of a mode along or about the axis alone",
                column(|m| if across(m) { m.forward_share } else { f64::NAN }),
            )
            .float("error", "1/s", "estimated error of the eigenvalue; NaN when there is no estimate", column(|m| m.error))
            .float(
                "backward_error",
                "",
                "relative change of the matrices that makes the mode exact; NaN when it is unknown",
                column(|m| m.residual),
            )
            .flag("polished", "solved for on the exact characteristic function", modes.iter().map(|m| m.polished).collect());
        if let Some(own) = &self.result.own {
            let doc = "distance of its frequency from that of the coefficients, over the eigenvalue";
            table = table.float("frequency_residual", "", doc, own.modes.iter().map(|m| m.residual).collect());
        }
        if let Some(found) = &self.result.roots {
            table = table.flag("counted", "it lies in a rectangle whose count agrees", found.counted.clone());
        }
        let tilts: Vec<bool> = self.system.coordinates().iter().map(|c| matches!(c.dof.kind, DofKind::TiltX | DofKind::TiltY)).collect();
        if tilts.contains(&true) && self.result.roots.is_none() {
            let mass = Linearised::new(self.system, &self.result.about)?.mass;
            let share = |m: &MachineMode| tilt_share(&mass, &tilts, m);
            let doc = "share of the tilts in the kinetic energy over a period, taken about the point of each body at which a tilt does not move its centre of mass; NaN where \
                       nothing with mass moves";
            table = table.float("tilt_share", "", doc, modes.iter().map(share).collect());
        }
        if let Some(along) = along {
            table = along.columns(table);
        }
        let probes = probes::all(self.system);
        let shapes: Vec<(Vec<f64>, f64)> = modes.iter().map(|m| shape(m, &probes)).collect();
        for (k, probe) in probes.iter().enumerate() {
            let doc = if probe.is_tilt() {
                "amplitude of the tilt over that of the body that tilts most; 0 where nothing tilts"
            } else {
                "orbit amplitude over that of the point that moves most; 0 where nothing but tilts"
            };
            table = table.float(probes::column(probe), "", doc, shapes.iter().map(|s| s.0[k]).collect());
        }
        if probes.iter().any(Probe::is_tilt) {
            let doc =
                "tilt of the body that tilts most, rad, over the displacement of the point that moves most, m; NaN where nothing but tilts";
            table = table.float_if_any("tilt_over_displacement", "1/m", doc, shapes.iter().map(|s| s.1).collect());
        }
        table.build().map_err(inconsistent)
    }

    fn figure(&self) -> Figure {
        let (modes, threshold) = (self.modes(), self.study.threshold);
        let alt = Message::new("modes-alt").arg("modes", Arg::count(modes.len())).arg("speed", Arg::speed(self.study.speed));
        let mut panel = Panel::new(Axis::new("growth rate", "1/s"));
        panel = panel.mark(Rule::y(threshold, if threshold == 0.0 { "unstable above" } else { "threshold" }));
        panel = panel.mark(Points::new("modes", "frequency", "growth").classes("whirl", WHIRLS).filled_where("stable"));
        Figure::new("spectrum", "Natural modes", alt).x(Axis::new("frequency", "rad/s")).panel(panel)
    }
}

/// Sizes of a shape: of every probe over the largest of its kind, 0 of what is rounding beside the rest; and the largest tilt over the largest displacement, 1/m.
fn shape(mode: &MachineMode, probes: &[Probe]) -> (Vec<f64>, f64) {
    let own: Vec<f64> = probes.iter().map(|p| if across(mode) { amplitude(mode, p) } else { 0.0 }).collect();
    let loud = probes::loudest(probes.iter().zip(own.iter().copied()));
    let size = |(p, &a): (&Probe, &f64)| if probes::still(p, a, loud, SHAPE_ROUNDING) { 0.0 } else { a };
    let own: Vec<f64> = probes.iter().zip(&own).map(size).collect();
    let largest = |tilt: bool| probes.iter().zip(&own).filter(|p| p.0.is_tilt() == tilt).map(|p| *p.1).fold(0.0, f64::max);
    let [moved, tilted] = [false, true].map(largest);
    let over = |x: f64, most: f64| if most > 0.0 { x / most } else { 0.0 };
    let relative = probes.iter().zip(&own).map(|(p, &x)| over(x, if p.is_tilt() { tilted } else { moved })).collect();
    (relative, if moved > 0.0 { tilted / moved } else { f64::NAN })
}

/// Modes from which on they are drawn.
const FEW: usize = 8;

/// Share of the loudest that is rounding in the shape of a mode.
const SHAPE_ROUNDING: f64 = 1e-10;

/// Kinetic energy of the tilts over that of all coordinates. The tilts are taken about the points at which they do not move the rest: a body whose reference point is not its
/// centre of mass moves that centre when it tilts, and this is energy of a displacement.
fn tilt_share(mass: &Mat, tilts: &[bool], mode: &MachineMode) -> f64 {
    let energy = |m: &Mat, own: &[usize]| {
        let of = |(i, &a): (usize, &usize)| {
            let moved = own.iter().enumerate().fold(C64::zero(), |s, (j, &b)| s + mode.q[b].scale(m[(i, j)]));
            (mode.q[a].conj() * moved).re
        };
        own.iter().enumerate().map(of).sum::<f64>()
    };
    let part = |rows: &[usize], cols: &[usize]| Mat::from_fn(rows.len(), cols.len(), |i, j| mass[(rows[i], cols[j])]);
    let (tilt, rest): (Vec<usize>, Vec<usize>) = (0..tilts.len()).partition(|&i| tilts[i]);
    // coordinates without mass take no part
    let rest: Vec<usize> = rest.into_iter().filter(|&i| mass[(i, i)] > 0.0).collect();
    let all: Vec<usize> = tilt.iter().chain(&rest).copied().collect();
    let total = energy(&part(&all, &all), &all);
    let mut own = part(&tilt, &tilt);
    if !rest.is_empty() {
        let Ok(lu) = Lu::new(&part(&rest, &rest)) else { return f64::NAN };
        let mut carried = part(&rest, &tilt);
        lu.solve_mat(&mut carried);
        let taken = part(&tilt, &rest).matmul(&carried);
        own = Mat::from_fn(tilt.len(), tilt.len(), |i, j| own[(i, j)] - taken[(i, j)]);
    }
    let share = energy(&own, &tilt) / total;
    // of an inertia that is none there are no shares
    if total > 0.0 && (-ROUNDING.sqrt()..=1.0 + ROUNDING.sqrt()).contains(&share) { share.clamp(0.0, 1.0) } else { f64::NAN }
}

/// Logarithm of the ratio of amplitudes one period apart.
fn log_decrement(m: &MachineMode) -> f64 {
    if m.frequency() > 0.0 { -std::f64::consts::TAU * m.growth() / m.frequency() } else { f64::NAN }
}
