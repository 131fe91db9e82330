//! Natural modes at one spin speed: growth, frequency, damping, direction of whirl and shape.
//!
//! Equations: `E x' = A x` over coordinates, rates and internal states, linearised about rest (fixed axes) or about a state that turns with the
//! rotor (rotating axes); every root s is then solved for again on the exact characteristic function, `det T(s) = 0`.
//!
//! Symbols: s = growth + i frequency, 1/s and rad/s; damping ratio = -growth/|s|; growth above 0 is unstable.
//!
//! Validity: small motions about the state; constant speed.
//!
//! Sources: standard linear theory; forward and backward parts in `docs/theory/linear-vibration.md#modes-and-whirl-direction`.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::part::{DofKind, Domain, Words};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{Axis, End, Figure, Finding, Outcome, Panel, Points, Rule, Table, quantity, significant};
use crate::solve::characteristic::{Characteristic, Equilibrium};
use crate::solve::exact::growing;
use crate::solve::pencil::{Linearised, MachineMode, Spectrum, Whirl, holds_fit, modes_about, wants_polish};
use crate::solve::roots::{LEAST, Request, Roots, roots, transcendental};
use crate::study::shared::probes;
use crate::study::shared::region;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{
    ABOUT, About, ROUNDING, SPEED, admit_roots, admit_threshold, decay_uncounted, hertz, inconsistent, remarks, speed,
};
use crate::study::{Context, Study};
use laval_num::complex::C64;
use laval_num::dense::{Lu, Mat};
use serde::{Deserialize, Serialize};

/// See the [module](self).
pub struct Modes {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// State linearised about.
    pub about: About,
    /// Growth above which a mode counts as unstable, 1/s.
    pub threshold: f64,
    /// Largest frequency at which roots of a machine with parts without time form are looked for, rad/s.
    pub frequency: Option<f64>,
}

/// Modes about a state.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ModesResult {
    /// State linearised about.
    pub about: Equilibrium,
    /// Modes by frequency, with their shapes.
    pub spectrum: Spectrum,
    /// Of a machine with parts that have no time form: its roots, and where they were counted.
    pub roots: Option<Roots>,
    /// Number of growing roots by the argument principle, of a machine that holds the fit of a part.
    pub growing: Option<usize>,
    /// How the study ended.
    pub end: End,
}

/// Terms of series that are worth a word beforehand: a count takes seconds.
const SERIES: f64 = 150.0;

/// Field: growth above which a mode counts as unstable.
pub(in crate::study) const THRESHOLD: Field = Field::optional(
    "growth_threshold",
    FieldKind::Quantity { unit: "1/s", bounds: Bounds::within(1e6) },
    "0 1/s",
    "growth rate above which a mode is called unstable",
);

/// What a probe measures of a mode: semi-major axis of its orbit.
pub(in crate::study) fn amplitude(mode: &MachineMode, probe: &Probe) -> f64 {
    let [x, y] = probe.amplitudes(&mode.q);
    let (f, b) = crate::solve::sectors::circular(x, y);
    f.abs() + b.abs()
}

/// Sizes of a shape: of every probe over the largest of its kind, 0 of what is rounding beside the rest; and the largest tilt over the largest displacement, 1/m.
fn shape(mode: &MachineMode, probes: &[Probe]) -> (Vec<f64>, f64) {
    let own: Vec<f64> = probes.iter().map(|p| amplitude(mode, p)).collect();
    let loud = probes::loudest(probes.iter().zip(own.iter().copied()));
    let size = |(p, &a): (&Probe, &f64)| if probes::still(p, a, loud, SHAPE_ROUNDING) { 0.0 } else { a };
    let own: Vec<f64> = probes.iter().zip(&own).map(size).collect();
    let largest = |tilt: bool| probes.iter().zip(&own).filter(|p| p.0.is_tilt() == tilt).map(|p| *p.1).fold(0.0, f64::max);
    let [moved, tilted] = [false, true].map(largest);
    let over = |x: f64, most: f64| if most > 0.0 { x / most } else { 0.0 };
    let relative = probes.iter().zip(&own).map(|(p, &x)| over(x, if p.is_tilt() { tilted } else { moved })).collect();
    (relative, if moved > 0.0 { tilted / moved } else { f64::NAN })
}

/// Share of the loudest that is rounding in the shape of a mode.
const SHAPE_ROUNDING: f64 = 1e-10;

impl Study for Modes {
    type Result = ModesResult;
    const KIND: &'static str = "modes";
    const EXAMPLE: &'static str = r#"speed = "3000 rpm"
"#;
    const DOC: &'static str = "Natural modes at one spin speed: growth rate, frequency, damping ratio, direction of whirl, and how much each body \
        takes part. about = \"turning\" linearises about the state that turns with the rotor.";
    const FIELDS: &'static [Field] =
        &[Field::optional("speed", SPEED, "", "spin speed; the machine's when left out"), ABOUT, THRESHOLD, region::FREQUENCY_LIMIT];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = speed(values, system, diagnostics)?;
        let threshold = values.number("growth_threshold").unwrap_or(0.0);
        Some(Modes { speed, about: About::read(values), threshold, frequency: values.number("frequency_limit") })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::one(self.speed)]
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        admit_roots(system, self.about, self.speed)?;
        admit_threshold(system, self.speed, self.threshold)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<ModesResult, Diagnostic> {
        admit_threshold(system, self.speed, self.threshold)?;
        let about = self.about.find(system, self.speed, None)?;
        let roots = if transcendental(system) {
            let terms: usize = system.domains(self.speed).iter().map(|d| d.terms).sum();
            context.announce(terms as f64, SERIES, "terms of series in every evaluation of the function whose roots are counted");
            let request = Request { margin: self.threshold, frequency: self.frequency, cancel: Some(context.cancel), ..Request::default() };
            Some(roots(system, &about, &request)?)
        } else {
            None
        };
        let spectrum = match &roots {
            Some(roots) => roots.spectrum.clone(),
            None => modes_about(system, &about, true)?,
        };
        let growing =
            if roots.is_none() && holds_fit(system) { growing(&mut Characteristic::new(system, &about), &spectrum) } else { None };
        Ok(ModesResult { about, spectrum, roots, growing, end: context.end(!context.cancelled()) })
    }

    fn report(&self, system: &System, result: &ModesResult, name: &str) -> Result<Outcome, Diagnostic> {
        let ModesResult { about, spectrum, roots: found, growing, end } = result;
        let endless = found.is_some();
        let modes = &spectrum.modes;
        // beside the largest eigenvalue, what is smaller than this is rounding
        let rounding = ROUNDING * modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
        let column = |f: fn(&MachineMode) -> f64| modes.iter().map(f).collect::<Vec<f64>>();
        // waves that nothing inside a part damps grow slowly with any damping outside it
        let undamped = system.domains(self.speed).into_iter().find(Domain::undamped).map(|d| d.words).filter(|_| endless);
        let (slow, undamped) = (undamped.is_some(), undamped.unwrap_or(Words::PLAIN));
        let threshold = if slow { self.threshold.max(LEAST * self.speed.abs()) } else { self.threshold };
        // growth below the rounding of the eigenvalue is no growth
        let above = |m: &MachineMode, limit: f64| !(m.growth() <= limit + rounding.max(if m.error.is_nan() { 0.0 } else { m.error }));
        let unstable = |m: &MachineMode| above(m, threshold);
        let grows = |m: &MachineMode| above(m, self.threshold);
        let mut table = Table::new("modes", format!("Natural modes at {}, about {}", quantity(self.speed, "rad/s"), self.about.word()))
            .int("mode", "", "number in order of frequency", (1..=modes.len() as i64).collect())
            .float("growth", "1/s", "growth rate; above 0 the mode grows", column(MachineMode::growth))
            .float("frequency", "rad/s", "whirl frequency", column(MachineMode::frequency))
            .float("frequency_hz", "Hz", "whirl frequency", column(|m| hertz(m.frequency())))
            .float("damping_ratio", "", "-growth over the modulus of the eigenvalue", column(MachineMode::damping_ratio))
            .text(
                "whirl",
                "direction of whirl with respect to the spin; none without oscillation across the axis, and at standstill",
                modes.iter().map(|m| m.whirl.at(self.speed).word().into()).collect(),
            )
            .flag("stable", "growth rate not above growth_threshold", modes.iter().map(|m| !grows(m)).collect())
            .float("forward_share", "", "forward part of the squared amplitudes", column(|m| m.forward_share))
            .float("error", "1/s", "estimated error of the eigenvalue; NaN when there is no estimate", column(|m| m.error))
            .float(
                "backward_error",
                "",
                "relative change of the matrices that makes the mode exact; NaN when it is unknown",
                column(|m| m.residual),
            )
            .flag("polished", "solved for on the exact characteristic function", modes.iter().map(|m| m.polished).collect());
        if let Some(found) = found {
            table = table.flag("counted", "it lies in a rectangle whose count agrees", found.counted.clone());
        }
        let tilts: Vec<bool> = system.coordinates().iter().map(|c| matches!(c.dof.kind, DofKind::TiltX | DofKind::TiltY)).collect();
        if tilts.contains(&true) && !endless {
            let mass = Linearised::new(system, about)?.mass;
            let share = |m: &MachineMode| tilt_share(&mass, &tilts, m);
            let doc = "share of the tilts in the kinetic energy over a period, taken about the point of each body at which a tilt does not move its centre of mass; NaN where \
                       nothing with mass moves";
            table = table.float("tilt_share", "", doc, modes.iter().map(share).collect());
        }
        let probes = probes::all(system);
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
        let mut outcome = Outcome::new(Self::KIND, name)
            .end(*end)
            .table(table.build().map_err(inconsistent)?)
            .work("eigenproblems", 1)
            .work("polished modes", spectrum.polished as u64);
        for (k, m) in modes.iter().enumerate().filter(|(_, m)| unstable(m)) {
            let what = if m.frequency() > 0.0 {
                format!("whirls{} at {}", direction(m.whirl.at(self.speed)), quantity(m.frequency(), "rad/s"))
            } else {
                "moves away without oscillation".into()
            };
            outcome = outcome.finding(
                Finding::warning("unstable_mode", format!("Mode {} is unstable: it {what} and grows at {{}}.", k + 1))
                    .value(m.growth(), "1/s")
                    .evidence("error of the eigenvalue", m.error, "1/s")
                    .evidence("backward error", m.residual, ""),
            );
        }
        let any_unstable = modes.iter().any(unstable);
        if any_unstable && threshold > self.threshold {
            let text =
                format!("Modes count as unstable from a growth rate of {{}} on: slower waves of {} are not all computed.", undamped.name);
            outcome = outcome.finding(Finding::info("threshold", text).value(threshold, "1/s"));
        }
        let open = decay_uncounted(system, self.speed).is_some();
        let slowly: Vec<usize> = (0..modes.len()).filter(|&k| grows(&modes[k]) && !unstable(&modes[k])).collect();
        let any_grows = !slowly.is_empty();
        let least = modes
            .iter()
            .enumerate()
            .filter(|(_, m)| !grows(m) && m.frequency() > 0.0 && !(slow && m.growth() > 0.0))
            .max_by(|a, b| b.1.damping_ratio().total_cmp(&a.1.damping_ratio()));
        let least = least.map(|(k, m)| {
            let undamped = m.growth().abs() <= rounding;
            let text = format!(
                "{} mode {} at {} ({}): {}.",
                match (open, any_unstable || any_grows) {
                    (true, _) => "Of the modes that decay and were found the least damped is",
                    (_, true) if self.threshold < 0.0 => "The least damped stable mode is",
                    (_, true) => "Of the modes that decay the least damped is",
                    _ => "The least damped mode is",
                },
                k + 1,
                quantity(m.frequency(), "rad/s"),
                m.whirl.at(self.speed).of("whirl", m.forward_share),
                if undamped { "its damping is zero to rounding" } else { "damping ratio {}" }
            );
            let ratio = if undamped { 0.0 } else { m.damping_ratio() };
            Finding::info("least_damped_mode", text).of("damping ratio").value(ratio, "").evidence("growth", m.growth(), "1/s").evidence(
                "rounding of the eigenvalues",
                rounding,
                "1/s",
            )
        });
        let verdict = (!any_unstable).then(|| {
            let last = spectrum.least_stable();
            let largest = last.map_or(f64::NEG_INFINITY, MachineMode::growth);
            let zero = largest.abs() <= rounding;
            let (at, limit) = (quantity(self.speed, "rad/s"), quantity(threshold, "1/s"));
            let proven = found.as_ref().is_none_or(|f| f.growing().is_some());
            let text = if !proven {
                format!(
                    "Whether the machine is stable at {at} is not known: no mode was found that grows faster than {limit}, but some may be missing."
                )
            } else if slow {
                let slower = match slowly.as_slice() {
                    [] => "none of the modes found grows more slowly".to_string(),
                    [k] => format!("one of the modes found grows more slowly, mode {}", k + 1),
                    all => format!("{} of the modes found grow more slowly", all.len()),
                };
                format!("At {at} no mode grows faster than {limit}; {slower}. Slow waves of {} are not all computed.", undamped.name)
            } else if zero {
                let why = if last.is_some_and(|m| m.value.abs() <= rounding) { "no stiffness holds it" } else { "nothing damps it" };
                format!("Neither stable nor unstable at {at}: the largest growth rate is zero to rounding; {why}.")
            } else if open {
                format!(
                    "Stable at {at}: no mode grows faster than {limit}; the largest growth rate that was found is {{}}, one that decays more slowly may be missing."
                )
            } else {
                format!("Stable at {at}: no mode grows faster than {limit}; the largest growth rate is {{}}.")
            };
            let finding = match (proven, slow) {
                (false, _) => Finding::warning("stability_unknown", text),
                (_, true) if !slowly.is_empty() => Finding::warning("slow_growth", text),
                (_, true) => Finding::info("stable", text),
                _ => Finding::info("stable", text).value(if zero { 0.0 } else { largest }, "1/s"),
            };
            finding.evidence("rounding of the eigenvalues", rounding, "1/s")
        });
        // what grows comes first
        let (first, second) = if any_grows { (verdict, least) } else { (least, verdict) };
        outcome = first.into_iter().chain(second).fold(outcome, Outcome::finding);
        if let Some(found) = found {
            for f in region::findings(system, self.speed, found) {
                outcome = outcome.finding(f);
            }
            outcome = outcome.table(region::areas(found)?);
        } else if holds_fit(system) {
            outcome = outcome.finding(counted(*growing, spectrum, any_unstable));
        } else if wants_polish(system) {
            let text = format!("{} of {} modes were solved for on the exact characteristic function.", spectrum.polished, modes.len());
            let finding =
                if spectrum.polished == modes.len() { Finding::info("polished", text) } else { Finding::warning("polished", text) };
            outcome = outcome.finding(finding.evidence("polished modes", spectrum.polished as f64, ""));
        }
        if spectrum.infinite > 0 {
            outcome = outcome.finding(Finding::info(
                "massless",
                format!("{} eigenvalues are infinite: some coordinates have no mass.", spectrum.infinite),
            ));
        }
        for f in remarks(system, about) {
            outcome = outcome.finding(f);
        }
        let alt = format!("{} modes at {}; {}.", modes.len(), quantity(self.speed, "rad/s"), worst_in_words(modes));
        let mut panel = Panel::new(Axis::new("growth rate", "1/s"));
        panel = panel.mark(Rule::y(self.threshold, if self.threshold == 0.0 { "unstable above" } else { "threshold" }));
        panel = panel.mark(Points::new("modes", "frequency", "growth").classes("whirl", WHIRLS).filled_where("stable"));
        let figure = Figure::new("spectrum", "Natural modes", alt).x(Axis::new("frequency", "rad/s")).panel(panel);
        outcome.figure(figure).checked().map_err(inconsistent)
    }
}

/// Whether the growing roots found are all there are.
fn counted(count: Option<usize>, spectrum: &Spectrum, unstable: bool) -> Finding {
    let found = spectrum.modes.iter().filter(|m| m.value.re > 0.0).count();
    let roots = |n: usize| match n {
        0 => "no growing root".to_string(),
        1 => "one growing root".to_string(),
        n => format!("{n} growing roots"),
    };
    let finding = match count {
        Some(n) if n == found => {
            let (all, text) = (spectrum.modes.len(), roots(n));
            Finding::info(
                "all_roots",
                format!(
                    "The {all} modes are roots of the exact characteristic function, which has {text} by the argument principle: of those that grow none is missed."
                ),
            )
        }
        Some(n) => Finding::warning(
            "roots_missed",
            format!(
                "The exact characteristic function has {} by the argument principle, but {} {} found{}.",
                roots(n),
                roots(found),
                if found > 1 { "were" } else { "was" },
                if n > 0 { ": the machine is unstable" } else { "" }
            ),
        ),
        None => Finding::warning(
            "roots_not_counted",
            format!(
                "The modes are roots of the exact characteristic function; whether others grow{} could not be counted.",
                if unstable { " too" } else { "" }
            ),
        ),
    };
    finding.evidence("eigenvalues of the fit that are no roots", spectrum.left_out as f64, "")
}

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

/// Directions of whirl as classes of figures.
pub(in crate::study) const WHIRLS: &[&str] = &["forward", "backward", "mixed", "none"];

fn direction(whirl: Whirl) -> &'static str {
    match whirl {
        Whirl::Forward => " forward",
        Whirl::Backward => " backward",
        Whirl::Mixed | Whirl::None => "",
    }
}

fn worst_in_words(modes: &[MachineMode]) -> String {
    match modes.iter().max_by(|a, b| a.growth().total_cmp(&b.growth())) {
        Some(m) => format!("the largest growth rate is {} 1/s at {} rad/s", significant(m.growth(), 4), significant(m.frequency(), 4)),
        None => "there is none".into(),
    }
}
