//! Campbell diagram: frequencies and growth rates of all modes over the spin speed, with excitation lines and the speeds where they meet.
//!
//! Equations: `det T(s, W) = 0` followed over W by modal assurance; a critical speed of order k solves `det T(growth + i k W, W) = 0`.
//!
//! Symbols: W spin speed, rad/s; s = growth + i frequency.
//!
//! Validity: small motions about the equilibrium at each speed; constant speed.
//!
//! Theory: `docs/theory/linear-vibration.md#critical-speeds`.
//!
//! Sources: W. Campbell (1924), as in every rotor-dynamics text; assurance of biorthogonal vectors as in `laval_num::eig::Track`.

use super::approximation::{self, Approximation};
use super::modes::{THRESHOLD, WHIRLS};
use super::numbering;
use super::operating::operating;
use super::over_frequency::{self, Searched, crossings, over_frequency, own_findings};
use super::whirl;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, RangeValue, Values};
use crate::model::part::{Domain, Frozen};
use crate::model::system::System;
use crate::outcome::{Arg, Axis, End, Figure, Finding, Kept, Line, Message, Outcome, Panel, Points, Rule, SpecialPoint, Status, Table};
use crate::solve::criticals::{Critical, criticals};
use crate::solve::large::usual_frequency;
use crate::solve::own_frequency::follow::follow as own_follow;
use crate::solve::pencil::{MachineMode, Whirl};
use crate::solve::rest::{over_speed, rest};
use crate::solve::roots::{LEAST, has_more_modes, in_region, transcendental};
use crate::solve::sweep::{Branch, Count, Strongest, Sweep, sweep};
use crate::study::shared::region;
use crate::study::shared::size;
use crate::study::shared::speed_range::{SpinSpeeds, with_table_speeds};
use crate::study::shared::support::{About, COUNTS, EndStates, ROUNDING, SPEED_RANGE, admit_roots, held, inconsistent, range_or};
use crate::study::shared::vibration::Vibration;
use crate::study::{Context, Study};
use crate::text;
use crate::text::Text;
use laval_num::order::ascending;
use laval_num::work::piece;
use serde::{Deserialize, Serialize};

/// Field: multiples of the spin speed.
pub(in crate::study) const ORDERS: Field = Field::optional(
    "orders",
    FieldKind::List { unit: "", bounds: Bounds::positive(1e3) },
    "[1]",
    "multiples of the spin speed that excite: 1 is unbalance",
);

/// The orders requested, ascending and different; where none are, those of the spins.
pub(in crate::study) fn orders(values: &Values, system: &System) -> Vec<f64> {
    let mut orders = values.list("orders").filter(|_| values.written("orders")).map_or_else(Vec::new, <[f64]>::to_vec);
    if orders.is_empty() {
        orders = spin_orders(system);
    }
    ascending(&mut orders);
    orders.dedup();
    orders
}

/// Orders at which unbalance acts: 1, and the ratios of other spins.
pub(in crate::study) fn spin_orders(system: &System) -> Vec<f64> {
    let mut all = vec![1.0];
    all.extend(system.spins().iter().map(|s| s.ratio.abs()));
    all
}

/// A crossing as a special point.
pub(in crate::study) fn special(c: &Critical) -> SpecialPoint {
    let status = if c.located() { Status::Located } else { Status::Bracketed };
    SpecialPoint::new("critical_speed", c.speed, c.bracket)
        .status(status)
        .evidence("order", c.order, "")
        .evidence("growth", c.growth, "1/s")
        .evidence("relative defect of the dynamic stiffness", c.defect, "")
        .evidence(if c.located() { "last Newton step" } else { "width of the bracket" }, c.step, "rad/s")
}

/// An order of the spin speed.
pub(in crate::study) fn order(k: f64) -> Arg {
    Arg::number(k).digits(6)
}

/// A speed of a narrow interval.
fn narrow(w: f64) -> Arg {
    Arg::speed(w).digits(6)
}

/// A critical speed: as the sentence says it, or that it lies between two speeds and was not located.
pub(in crate::study) fn critical(c: &Critical, sentence: &'static str) -> Finding {
    if !c.located() {
        return Finding::warning("critical_speed_not_located", "campbell-critical-speed-not-located")
            .of(format!("order {}", c.order))
            .value_as(narrow(c.bracket.0))
            .arg("to", narrow(c.bracket.1))
            .arg("order", order(c.order));
    }
    let damping = damping(c);
    Finding::info("critical_speed", sentence)
        .of(format!("order {} {}", c.order, c.whirl.word()))
        .value(c.speed, "rad/s")
        .arg("order", order(c.order))
        .arg("whirl", whirl::direction(c.whirl, c.forward_share))
        .arg("damped", Arg::word(if damping == 0.0 { "no" } else { "yes" }))
        .arg("damping", Arg::number(damping))
}

/// Damping ratio of a mode at its critical speed.
pub(in crate::study) fn damping(c: &Critical) -> f64 {
    let size = c.growth.hypot(c.order * c.speed);
    // what Newton's method leaves of a mode without damping is no damping
    if c.growth.abs() > 1e-10 * size { -c.growth / size } else { 0.0 }
}

/// Table of critical speeds.
pub(in crate::study) fn critical_table(found: &[Critical]) -> Result<Table, Diagnostic> {
    let column = |f: fn(&Critical) -> f64| found.iter().map(f).collect::<Vec<f64>>();
    Table::new("critical_speeds", "Speeds at which a frequency is a multiple of the spin speed")
        .float("speed", "rad/s", "spin speed", column(|c| c.speed))
        .float("speed_rpm", "rpm", "spin speed", column(|c| c.speed * crate::study::shared::support::RPM))
        .float("order", "", "frequency over spin speed", column(|c| c.order))
        .float("frequency", "rad/s", "frequency", column(|c| c.order * c.speed.abs()))
        .float("growth", "1/s", "growth rate of the mode", column(|c| c.growth))
        .float("damping_ratio", "", "damping ratio of the mode", column(damping))
        .text("whirl", "direction of whirl", found.iter().map(|c| c.whirl.word().into()).collect())
        .int("mode", "", "number of the mode in the Campbell diagram", found.iter().map(|c| c.branch as i64 + 1).collect())
        .float("uncertainty", "rad/s", "last Newton step; the width of the bracket where it is not located", column(|c| c.step))
        .flag(
            "located",
            "solved for on the characteristic function; otherwise read between two speeds",
            found.iter().map(Critical::located).collect(),
        )
        .build()
        .map_err(inconsistent)
}

/// See the [module](self).
#[derive(Clone)]
pub struct Campbell {
    /// Speeds, rad/s.
    pub speed: RangeValue,
    /// Multiples of the spin speed.
    pub orders: Vec<f64>,
    /// Growth above which a mode counts as unstable, 1/s.
    pub threshold: f64,
    /// Largest frequency at which roots of a machine with parts without time form are looked for, rad/s.
    pub frequency: Option<f64>,
    /// Draw the machine beside its approximation with few waves.
    pub compare: bool,
}

impl Campbell {
    /// Largest frequency followed, rad/s: all modes but of machines whose roots are counted in a region.
    fn limit(&self, system: &System) -> Result<f64, Diagnostic> {
        if !in_region(system) {
            return Ok(f64::INFINITY);
        }
        if self.frequency.is_some() || !has_more_modes(system) {
            return Ok(self.frequency.unwrap_or(f64::INFINITY));
        }
        let fastest = if self.speed.from.abs() > self.speed.to.abs() { self.speed.from } else { self.speed.to };
        let excited = self.orders.iter().fold(0.0, |m: f64, &k| m.max(k)) * fastest.abs();
        Ok(usual_frequency(system, &rest(system, fastest)?).max(BEYOND * excited))
    }
}

impl Campbell {
    /// Modes with the coefficients of their own frequency, and critical speeds with those of the order.
    fn own(&self, system: &System, context: &Context) -> Result<CampbellResult, Diagnostic> {
        let state = over_speed(system);
        let speeds = with_table_speeds(&self.speed, 120, system);
        let total = speeds.len() as u64;
        context.announce(total as f64, COUNTS, text!("speeds at which modes are counted, one after another"));
        let mut found = own_follow(system, &state, &speeds, self.frequency, |k, solved| {
            context.progress.report(k as u64, total);
            context.goes_on(solved)
        })?;
        let mut end = context.end(found.sweep.points.len() == speeds.len());
        let searched = Searched::along(&found);
        let branches = &mut found.sweep.branches;
        numbering::in_order(branches, numbering::reference(system, &self.speed));
        let mut all = Vec::new();
        if end == End::Reached {
            let more = crossings(system, context, &self.speed, &self.orders)?;
            (all, end) = (more.crossings, more.end);
            over_frequency::number(&mut all, branches);
        }
        let sweep = found.sweep;
        Ok(CampbellResult {
            speeds: sweep.points.iter().map(|p| p.0).collect(),
            branches: sweep.branches,
            strongest: sweep.strongest,
            ambiguous: sweep.ambiguous,
            worst_assurance: sweep.worst_assurance,
            counts: Vec::new(),
            crossings: all,
            approximation: None,
            own: Some(searched),
            states: EndStates::find(state, self.speed.from, self.speed.to)?,
            end,
        })
    }
}

/// Largest frequency that is followed, over the largest that is excited, at least.
const BEYOND: f64 = 1.1;

/// Modes with frequencies up to `limit` followed over the speeds of a range, and how the work ended.
pub(in crate::study) fn follow(system: &System, context: &Context, speeds: &[f64], limit: f64) -> Result<(Sweep, End), Diagnostic> {
    let total = speeds.len() as u64;
    if in_region(system) {
        context.announce(total as f64, COUNTS, text!("speeds at which roots are counted, one after another"));
    } else {
        context.announce(total as f64, 10_000.0, text!("eigenvalue problems to solve"));
    }
    let found = sweep(system, &over_speed(system), speeds, limit, |k, solved| {
        context.progress.report(k as u64, total);
        context.goes_on(solved)
    })?;
    let whole = found.points.last().map(|p| p.0) == speeds.last().copied();
    Ok((found, context.end(whole)))
}

/// Modes that the figure names at the ends of their curves, and the text beside it, at most.
const MOST_NAMED: usize = 14;

/// How the figure draws a mode: by its direction of whirl, or grey where it does not show as a resonance or is one of many waves.
const MOTIONS: &[&str] = &[WHIRLS[0], WHIRLS[1], WHIRLS[2], WHIRLS[3], WHIRLS[4], WHIRLS[5], DAMPED, WAVES];
const GREY: &[&str] = &[DAMPED, WAVES];
/// Beyond [`HEAVY`].
const DAMPED: &str = "damping ratio above 0.2";
/// Amplification 2.5: API 684 counts such a mode as critically damped.
const HEAVY: f64 = 0.2;
const WAVES: &str = "waves of the liquid";
/// Spread of frequency over speed, and of the speeds, up to which, and from which on, a mode follows the speed as a wave does.
const FOLLOWS: f64 = 0.05;
const SPREAD: f64 = 1.3;
/// Orders that are drawn where the file names none.
const GUIDES: [f64; 2] = [1.0, 2.0];

impl Study for Campbell {
    type Result = CampbellResult;
    const KIND: &'static str = "campbell";
    const EXAMPLE: &'static str = r#"speed = { from = "100 rpm", to = "12000 rpm", points = 60 }
orders = [1, 2]
"#;
    const DOC: &'static str = "Frequencies and growth rates of all modes over the spin speed, each mode followed by its shape, with excitation lines \
        and the critical speeds where they cross. Of a bearing in a table over the frequency of vibration every mode has the coefficients of its own frequency.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::required("speed", SPEED_RANGE, "spin speeds; 120 points unless given"),
        ORDERS,
        THRESHOLD,
        region::FREQUENCY_LIMIT,
        approximation::COMPARE,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let one: fn(Text) -> Text = |help| text!("{help}; modes shows the modes at one speed", help);
        let speed = range_or("speed", (values.range("speed")?, one), 2, values, diagnostics)?;
        let threshold = values.number("growth_threshold").unwrap_or(0.0);
        Some(Campbell {
            speed,
            orders: orders(values, system),
            threshold,
            frequency: values.number("frequency_limit"),
            compare: approximation::wanted(values),
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn vibration(&self, _: &System) -> Vibration {
        Vibration::Own
    }

    fn size(&self, system: &System) -> Option<size::Size> {
        Some(size::Size::of_spectra(self.speed.points.unwrap_or(120), system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if self.compare {
            approximation::admit(system)?;
        }
        admit_roots(system, About::Rest, self.speed.from)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<CampbellResult, Diagnostic> {
        if over_frequency(system) {
            return self.own(system, context);
        }
        let limit = self.limit(system)?;
        let (mut found, end) = follow(system, context, &with_table_speeds(&self.speed, 120, system), limit)?;
        numbering::in_order(&mut found.branches, numbering::reference(system, &self.speed));
        let locate = || criticals(system, &over_speed(system), &found, &self.orders);
        // of a study that has to end those that there is no time for are left out
        let crossings = if end == End::Reached { locate() } else { piece(locate).unwrap_or_default() };
        let states = EndStates::find(|w| rest(system, w), self.speed.from, self.speed.to)?;
        let approximation = if self.compare { Some(approximation::compare(system, &found, context)?) } else { None };
        Ok(CampbellResult {
            speeds: found.points.iter().map(|p| p.0).collect(),
            branches: found.branches,
            strongest: found.strongest,
            ambiguous: found.ambiguous,
            worst_assurance: found.worst_assurance,
            counts: found.counts,
            crossings,
            approximation,
            own: None,
            states,
            end,
        })
    }

    fn report(&self, system: &System, result: &CampbellResult, name: &str) -> Result<Outcome, Diagnostic> {
        // findings about other parts do not depend on the frequency
        let held = held(system, Frozen::At(0.0))?;
        let shown = Shown::new(self, held.as_ref().unwrap_or(system), result);
        let mut outcome =
            Outcome::new(Self::KIND, name).over("speed", "rad/s").end(result.end).work("eigenproblems", result.speeds.len() as u64);
        outcome = shown.critical_speeds(shown.growth().into_iter().fold(outcome, Outcome::finding));
        outcome = shown.doubts().into_iter().chain(result.states.remarks(system)).fold(outcome, Outcome::finding);
        if let Some(own) = &result.own {
            outcome = own_findings(system, own).into_iter().fold(outcome, Outcome::finding);
            let highest = |b: &Branch| b.points.iter().map(|p| p.1.frequency()).fold(0.0, f64::max);
            let lowest = |b: &Branch| b.points.iter().map(|p| p.1.frequency()).fold(f64::INFINITY, f64::min);
            let ends = result.branches.iter().enumerate().flat_map(|(k, b)| [(k, lowest(b)), (k, highest(b))]);
            over_frequency::mark(system, &ends.collect::<Vec<_>>(), &mut outcome.findings);
        }
        outcome = outcome.table(shown.modes_table()?).table(shown.lines_table()?).table(critical_table(&result.crossings)?);
        outcome = outcome.figure(shown.figure());
        if let Some(approximation) = &result.approximation {
            outcome = approximation.add(outcome)?;
        }
        outcome.checked().map_err(inconsistent)
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

/// Modes followed over the spin speed, and the speeds where they meet the excitation lines.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CampbellResult {
    /// Speeds computed, rad/s.
    pub speeds: Vec<f64>,
    /// The modes, each over the speeds at which it was followed.
    pub branches: Vec<Branch>,
    /// The mode that grows most at every speed computed.
    pub strongest: Vec<Strongest>,
    /// Steps, from speed to speed, that were accepted although shapes had mixed.
    pub ambiguous: Vec<(f64, f64)>,
    /// Smallest assurance with which a step was accepted.
    pub worst_assurance: f64,
    /// Of a machine too large for all its modes the speeds at which they were counted.
    pub counts: Vec<Count>,
    /// Critical speeds, by order, then speed.
    pub crossings: Vec<Critical>,
    /// The approximation with few waves, where requested.
    pub approximation: Option<Approximation>,
    /// Of a machine with coefficients over the frequency of vibration: what was searched for its modes, each with the coefficients of its own frequency.
    pub own: Option<Searched>,
    /// States at the ends of the range.
    pub states: EndStates,
    /// How the study ended.
    pub end: End,
}

/// Branch, speed and mode.
type Row<'a> = (usize, f64, &'a MachineMode);

struct Shown<'a> {
    study: &'a Campbell,
    system: &'a System,
    result: &'a CampbellResult,
    rows: Vec<Row<'a>>,
    /// Growth above which a mode counts as unstable.
    threshold: f64,
    /// Growth that is rounding.
    rounding: f64,
}

impl<'a> Shown<'a> {
    fn new(study: &'a Campbell, system: &'a System, result: &'a CampbellResult) -> Self {
        let rows: Vec<Row> = result.branches.iter().enumerate().flat_map(|(k, b)| b.points.iter().map(move |(w, m)| (k, *w, m))).collect();
        // waves that nothing inside a part damps grow slowly with any damping outside it: one limit for all speeds
        let fastest = study.speed.from.abs().max(study.speed.to.abs());
        let slow = transcendental(system) && system.domains(fastest).iter().any(Domain::undamped);
        let threshold = if slow { study.threshold.max(LEAST * fastest) } else { study.threshold };
        // beside the largest eigenvalue, what is smaller than this is rounding
        let rounding = ROUNDING * rows.iter().map(|r| r.2.value.abs()).fold(0.0, f64::max);
        Shown { study, system, result, rows, threshold, rounding }
    }

    fn label(&self, k: usize) -> String {
        // a mode may change its direction on the way
        let points = self.result.branches[k].points.iter();
        let mut words: Vec<&str> = points.map(|p| p.1.whirl.at(p.0)).filter(|w| *w != Whirl::None).map(Whirl::word).collect();
        words.dedup();
        let word = match words.as_slice() {
            [] => "aperiodic",
            [one] => *one,
            [first, .., last] => change(first, last),
        };
        format!("{} {word}", k + 1)
    }

    /// Its frequency is a fixed multiple of the speed: a wave of a liquid that turns with the rotor, which hardly moves the machine.
    fn wave(&self, k: usize) -> bool {
        let points = self.result.branches[k].points.iter().filter(|p| p.0 != 0.0);
        let range =
            |f: &dyn Fn(&(f64, MachineMode)) -> f64| points.clone().map(f).fold((f64::INFINITY, 0.0f64), |(a, b), v| (a.min(v), b.max(v)));
        let (ratios, speeds) = (range(&|p| p.1.frequency() / p.0.abs()), range(&|p| p.0.abs()));
        transcendental(self.system) && speeds.1 > SPREAD * speeds.0 && ratios.1 - ratios.0 < FOLLOWS * ratios.1
    }

    fn motion(&self, row: &Row, waves: &[bool]) -> &'static str {
        let (k, w, m) = row;
        match m.whirl.at(*w).word() {
            _ if waves[*k] && self.within(m, self.study.threshold) => WAVES,
            _ if m.frequency() > 0.0 && m.damping_ratio() > HEAVY => DAMPED,
            whirl => whirl,
        }
    }

    fn within(&self, m: &MachineMode, limit: f64) -> bool {
        m.growth() <= limit + self.rounding.max(if m.error.is_nan() { 0.0 } else { m.error })
    }

    /// The mode that grows most.
    fn growth(&self) -> Option<Finding> {
        let unstable = self.rows.iter().filter(|r| !self.within(r.2, self.threshold));
        let &(k, w, m) = unstable.max_by(|a, b| a.2.growth().total_cmp(&b.2.growth()))?;
        let finding = Finding::warning("unstable", "campbell-unstable").value(m.growth(), "1/s").arg("mode", Arg::count(k + 1));
        Some(whirl::growing(finding, m, w).arg("speed", Arg::speed(w)).evidence("speed", w, "rad/s"))
    }

    fn critical_speeds(&self, mut outcome: Outcome) -> Outcome {
        for c in &self.result.crossings {
            let finding = critical(c, "campbell-critical-speed");
            outcome = outcome
                .finding(finding.evidence("relative defect of the dynamic stiffness", c.defect, "").evidence("growth", c.growth, "1/s"))
                .special_point(special(c));
        }
        if self.result.crossings.is_empty() {
            let key = if self.result.end == End::Reached { "campbell-no-critical-speed" } else { "campbell-no-critical-speed-yet" };
            outcome = outcome.finding(Finding::info("no_critical_speed", key));
        }
        outcome
    }

    /// What was not followed, and what cannot be counted.
    fn doubts(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        if let Some(&(a, b)) = self.result.ambiguous.first() {
            let finding = Finding::warning("ambiguous", "campbell-ambiguous").value_as(narrow(a)).arg("to", narrow(b));
            let finding = finding.arg("steps", Arg::count(self.result.ambiguous.len()));
            out.push(finding.evidence("smallest assurance", self.result.worst_assurance, ""));
        }
        out.extend(region::modes_followed(&self.result.counts, self.result.speeds.len()));
        if transcendental(self.system) {
            let from = self.study.speed.from;
            let domains = self.system.domains(from);
            out.extend(region::limits(&domains, from).into_iter().chain(region::accumulation(&domains, from)));
            if domains.iter().any(|d| d.dense.is_some()) {
                out.push(Finding::warning("slow_roots", "campbell-slow-roots"));
            }
        }
        out
    }

    fn modes_table(&self) -> Result<Table, Diagnostic> {
        let rows = &self.rows;
        let waves: Vec<bool> = (0..self.result.branches.len()).map(|k| self.wave(k)).collect();
        let column = |f: fn(&MachineMode) -> f64| rows.iter().map(|r| f(r.2)).collect::<Vec<f64>>();
        Table::new("modes", "Modes followed over the spin speed")
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| r.1).collect())
            .text(
                "mode",
                "number by rising frequency at the speed of the machine, or at the first speed where the range does not hold it, and direction of whirl",
 rows.iter().map(|r| self.label(r.0)).collect())
            .float("frequency", "rad/s", "frequency", column(MachineMode::frequency))
            .float("growth", "1/s", "growth rate", column(MachineMode::growth))
            .float("damping_ratio", "", "damping ratio", column(MachineMode::damping_ratio))
            .text(
                "whirl",
                "direction of whirl; axial, torsional: along or about the axis alone; none without oscillation, and across the axis at standstill",
                rows.iter().map(|r| r.2.whirl.at(r.1).word().into()).collect(),
            )
            .text(
                "motion",
                "direction of whirl, or that the mode is damped heavily or follows the speed as a wave",
                rows.iter().map(|r| self.motion(r, &waves).into()).collect(),
            )
            .flag("stable", "growth rate not above growth_threshold", rows.iter().map(|r| self.within(r.2, self.study.threshold)).collect())
            .build()
            .map_err(inconsistent)
    }

    fn lines_table(&self) -> Result<Table, Diagnostic> {
        let (from, to) = (self.study.speed.from, self.study.speed.to);
        let speeds = [from, 0f64.clamp(from, to), to];
        let mut lines = Table::new("excitation", "Excitation lines").float("speed", "rad/s", "spin speed", speeds.to_vec());
        for k in &self.drawn_orders() {
            lines = lines.float(format!("{k}x"), "rad/s", "frequency of this order", speeds.map(|w| k * w.abs()).to_vec());
        }
        lines.build().map_err(inconsistent)
    }

    /// Those on which critical speeds are sought; of a file that names none, once and twice the speed beside them.
    fn drawn_orders(&self) -> Vec<f64> {
        let mut orders = self.study.orders.clone();
        if orders != spin_orders(self.system) {
            return orders;
        }
        orders.extend(GUIDES.into_iter().filter(|g| !self.study.orders.contains(g)));
        ascending(&mut orders);
        orders
    }

    fn figure(&self) -> Figure {
        let (branches, range) = (&self.result.branches, &self.study.speed);
        let highest = self.study.orders.iter().fold(0.0, |m: f64, k| m.max(k.abs()));
        let (top, outside) = shown(branches, highest * range.from.abs().max(range.to.abs()));
        let axis = Axis::new("frequency", "rad/s");
        let axis = if outside.is_empty() { axis } else { axis.range(0.0, top) };
        let line = |y: &str| Line::new("modes", "speed", y).group("mode").solid_where("stable").classes("motion", MOTIONS).muted(GREY);
        let named = (0..branches.len()).filter(|k| !branches[*k].points.is_empty() && !outside.contains(k) && !self.wave(*k));
        let named: Vec<(String, Arg)> = named.map(|k| (self.label(k), numbered(k))).collect();
        let named = if named.len() > MOST_NAMED { Vec::new() } else { named };
        let operating = operating(self.system, range.from, range.to);
        let mut frequency = Panel::new(axis).height(1.5);
        frequency = operating.iter().fold(frequency, |p, o| p.mark(o.margin()).mark(o.rule()));
        frequency = frequency.mark(line("frequency").ends(named));
        for k in &self.drawn_orders() {
            frequency = frequency.mark(Line::new("excitation", "speed", format!("{k}x")).name(times(*k)).reference());
        }
        frequency = frequency.mark(Points::new("critical_speeds", "speed", "frequency").name("critical speed"));
        let growth = Axis::new("growth rate", "1/s");
        // modes that the panel above leaves out do not set the scale here, nor do motions that hardly oscillate beside others that do
        let drawn: Vec<&MachineMode> =
            (0..branches.len()).filter(|k| !outside.contains(k)).flat_map(|k| &branches[k].points).map(|p| &p.1).collect();
        let oscillates = |m: &&MachineMode| m.growth() >= -m.frequency();
        let some = drawn.iter().copied().any(|m| oscillates(&m) && m.frequency() > 0.0);
        let seen = drawn.iter().copied().filter(|m| !some || oscillates(m)).map(MachineMode::growth);
        let (low, high) = seen.chain([self.threshold]).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), g| (a.min(g), b.max(g)));
        let space = 0.08 * (high - low);
        let whole = outside.is_empty() && (!some || drawn.iter().all(oscillates));
        let growth = if whole || !(space > 0.0) { growth } else { growth.range(low - space, high + space) };
        let growth = Panel::new(growth);
        let growth = operating.iter().fold(growth, |p, o| p.mark(o.margin()).mark(o.rule()));
        let growth =
            growth.mark(line("growth")).mark(Rule::y(self.threshold, if self.threshold == 0.0 { "unstable above" } else { "threshold" }));
        let alt = Message::new("campbell-alt")
            .arg("modes", Arg::count(branches.len()))
            .arg("criticals", Arg::count(self.result.crossings.len()))
            .arg("above", Arg::count(outside.len()))
            .arg("top", Arg::frequency(top));
        let speeds = Axis::new("spin speed", "rad/s");
        Figure::new("campbell", "Campbell diagram", alt).x(speeds).panel(frequency).panel(growth)
    }
}

/// Top of the frequency axis, rad/s, and the branches that lie above it: the excitation lines end at `excited`, and what lies far above them is met by none
/// but would press the others together. The lowest mode is always shown.
fn shown(branches: &[Branch], excited: f64) -> (f64, Vec<usize>) {
    let over = |pick: fn(f64, f64) -> f64, from: f64, b: &Branch| b.points.iter().map(|p| p.1.frequency()).fold(from, pick);
    let lowest = branches.iter().map(|b| over(f64::max, 0.0, b)).filter(|f| *f > 0.0).fold(f64::INFINITY, f64::min);
    let top = 1.25 * if lowest.is_finite() { excited.max(lowest) } else { excited };
    let above = |k: &usize| over(f64::min, f64::INFINITY, &branches[*k]) > top && !branches[*k].points.is_empty();
    (top, (0..branches.len()).filter(above).collect())
}

/// A mode whose direction of whirl changes on the way, once or several times.
fn change(first: &str, last: &str) -> &'static str {
    match (first, last) {
        ("forward", "backward") => "forward to backward",
        ("forward", "mixed") => "forward to mixed",
        ("backward", "forward") => "backward to forward",
        ("backward", "mixed") => "backward to mixed",
        ("mixed", "forward") => "mixed to forward",
        ("mixed", "backward") => "mixed to backward",
        ("forward", _) => "mostly forward",
        ("backward", _) => "mostly backward",
        _ => "mostly mixed",
    }
}

/// An order of the spin speed, as a label.
fn times(k: f64) -> Message {
    Message::new("label-order").arg("order", order(k))
}

/// The mode of a branch, as a label.
fn numbered(k: usize) -> Arg {
    Message::new("label-mode").arg("number", Arg::count(k + 1)).into()
}
