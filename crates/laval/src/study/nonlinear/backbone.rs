//! Free whirls of a machine at fixed spin speed: frequency against amplitude.
//!
//! Equations: harmonic balance with unknown frequency, linear parts condensed at `s = i k w` and the spin speed W; see
//! [`crate::solve::harmonic::free::whirl`]. Amplitudes become infinite where the machine can whirl without deflecting its nonlinear parts
//! (`det(B Z(i w)^-1 B^T) = 0`; for a rotor with liquid on a foundation `(M + m + mL G) w^2 = c2`).
//!
//! Symbols: w whirl frequency, rad/s; W spin speed, rad/s; xi drive, 1/s, a force `xi M q'` that makes up for the losses.
//!
//! Validity: constant speed, no unbalance. Of a damped machine these are motions with exactly that much excitation; without damping xi is zero.
//!
//! Sources: `docs/theory/free-motions.md#backbone-curves`; R. M. Rosenberg, Adv. Appl. Mech. 9 (1966) 155; M. Krack, Comput. Struct. 154 (2015) 59.

use super::free_motion::{
    FREQUENCY, HARMONICS, MAX_POINTS, Measure, Measured, TRUNCATION, VALID, body_columns, constant_speed, end, in_order, invalid, read,
    short, trust_columns, unfinished, valid,
};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::probe::Probe;
use crate::model::system::System;
use crate::outcome::{self, Arg, Axis, Figure, Finding, Line, Message, Outcome, OutcomeError, Panel, Rule, SpecialPoint, Table, quantity};
use crate::solve::harmonic::free::backbone::{Family, Motion, Origin, Request, admit, backbone};
use crate::solve::symmetry::Symmetry;
use crate::study::shared::probes;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED, largest, speed};
use crate::study::{Context, Study};
use crate::text;
use laval_num::continuation::End;
use serde::{Deserialize, Serialize};

/// See the [module](self).
pub struct Backbone {
    request: Request,
}

impl Backbone {
    /// The study that answers this request.
    pub fn new(request: Request) -> Self {
        Backbone { request }
    }
}

/// A whirl whose frequency falls below this share of its first one has no restoring force left.
const VANISHED: f64 = 0.05;

/// Where a frequency turns back before its last value, by more than this share, that is said.
const TURNS: f64 = 1e-3;

/// The motion at which the frequency is farthest from that at both ends of a family, where it is not monotonic.
fn turning(motions: &[Motion]) -> Option<&Motion> {
    let (first, last) = (motions.first()?.frequency.abs(), motions.last()?.frequency.abs());
    let (low, high) = (first.min(last), first.max(last));
    let outside = |m: &Motion| (low - m.frequency.abs()).max(m.frequency.abs() - high) / high;
    motions.iter().max_by(|a, b| outside(a).total_cmp(&outside(b))).filter(|m| outside(m) > TURNS)
}

/// Relative change of a frequency that is none.
const STEADY: f64 = 1e-7;

/// Relative change of a frequency that four digits may not show.
const ALIKE: f64 = 1e-3;

/// Drive over frequency that is rounding: the machine is undamped.
const ROUNDING: f64 = 1e-10;

impl Study for Backbone {
    type Result = BackboneResult;
    const KIND: &'static str = "backbone";
    const EXAMPLE: &'static str = r#"speed = "3000 rpm"
amplitude = { from = "1 um", to = "1 mm" }
"#;
    const DOC: &'static str = "Free whirls at one spin speed, mode by mode: how the whirl frequency depends on the amplitude, from the linear mode \
        upwards, and the frequencies at which the amplitude has no bound. Unbalance is left out. A damped machine is kept whirling by a drive \
        proportional to mass, whose size is reported; without damping it is zero.";
    const FIELDS: &'static [Field] = &[
        Field::optional("speed", SPEED, "", "spin speed; the machine's when left out"),
        Field::optional(
            "amplitude",
            FieldKind::Range { unit: "m", bounds: Bounds::closed(1e-12, 1.0) },
            "",
            "amplitudes of the deflection of the nonlinear parts, first order; from a thousandth to four times the one at which their force is half as \
             much again as its tangent when left out",
        ),
        HARMONICS,
        TRUNCATION,
        MAX_POINTS,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = speed(values, system, diagnostics);
        let mut amplitudes = None;
        if let Some(range) = values.range("amplitude") {
            if !(range.from < range.to) {
                diagnostics.push(
                    Diagnostic::error("backbone.amplitude", text!("amplitude must go from a lower to a higher value"))
                        .at(values.span_of("amplitude"))
                        .help(text!("exchange from and to")),
                );
                return None;
            }
            amplitudes = Some((range.from, range.to));
        }
        let (harmonics, truncation, max_points) = read(values);
        Some(Backbone { request: Request { speed: speed?, amplitudes, harmonics, truncation, max_points, work: u64::MAX } })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::one(self.request.speed)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        Some(Size::of_branch(self.request.max_points, system))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        constant_speed(system)?;
        admit(system, self.request.speed)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<BackboneResult, Diagnostic> {
        self.admit(system)?;
        let request = Request { work: context.work_limit, ..self.request };
        let found = backbone(system, &request, context.cancel, &|done| context.progress.report(done, 0))?;
        let fastest = found.modes.iter().map(|m| m.value.im.abs()).fold(1.0, f64::max);
        let mut measure = Measure::new(system, found.discretisation, fastest)?;
        let of = |m: &Motion, measure: &mut Measure| measure.of([request.speed, m.frequency, m.drive], &m.x);
        let measured = found.families.iter().map(|f| f.motions.iter().map(|m| of(m, &mut measure)).collect()).collect();
        let end = if found.stopped { context.end(false) } else { end(found.families.iter().map(|f| &f.end)) };
        Ok(BackboneResult { found, measured, end })
    }

    fn report(&self, system: &System, result: &BackboneResult, name: &str) -> Result<Outcome, Diagnostic> {
        let BackboneResult { found, measured, end } = result;
        let shown = Shown { system, request: &self.request, found, measured, probes: probes::all(system), end: *end };
        shown.outcome(name).map_err(Diagnostic::from)
    }
}

/// Families of free whirls, and how far their motions go.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct BackboneResult {
    /// Linear modes, asymptotes and families.
    pub found: crate::solve::harmonic::free::backbone::Backbone,
    /// Of every family, of every motion.
    pub measured: Vec<Vec<Measured>>,
    /// How the study ended.
    pub end: outcome::End,
}

struct Shown<'a> {
    system: &'a System,
    request: &'a Request,
    found: &'a crate::solve::harmonic::free::backbone::Backbone,
    measured: &'a [Vec<Measured>],
    probes: Vec<Probe>,
    end: outcome::End,
}

impl Shown<'_> {
    fn outcome(&self, name: &str) -> Result<Outcome, OutcomeError> {
        let found = self.found;
        let mut out = Outcome::new(Backbone::KIND, name)
            .over("amplitude", "m")
            .end(self.end)
            .work("Newton iterations", found.iterations)
            .work("points", found.families.iter().map(|f| f.motions.len() as u64).sum());
        for f in self.findings() {
            out = out.finding(f);
        }
        let points: usize = found.families.iter().map(|f| f.motions.len()).sum();
        if points > 0 {
            out = out.table(self.table()?).figure(self.figure());
        }
        for t in [self.modes()?, self.asymptotes()?] {
            if t.rows() > 0 {
                out = out.table(t);
            }
        }
        for (k, f) in found.families.iter().enumerate() {
            for &a in &f.folds {
                out = out.special_point(SpecialPoint::new("fold", a, (a, a)).of(format!("family {}", k + 1)));
            }
            for &(a, bracket) in &f.synchronous {
                out = out.special_point(SpecialPoint::new("synchronous", a, bracket).of(format!("family {}", k + 1)).evidence(
                    "frequency",
                    self.request.speed,
                    "rad/s",
                ));
            }
        }
        out.checked()
    }

    fn findings(&self) -> Vec<Finding> {
        let found = self.found;
        let mut out = Vec::new();
        for (k, f) in found.families.iter().enumerate() {
            out.extend(self.family(k, f));
        }
        if found.families.is_empty() {
            out.push(Finding::warning("no_family", "backbone-no-family"));
        }
        let motions = || found.families.iter().flat_map(|f| &f.motions);
        let driven = motions().map(|m| (m.drive.abs(), m.frequency.abs())).max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)));
        if let Some((drive, w)) = driven {
            out.push(if drive <= ROUNDING * w {
                Finding::info("undamped", "backbone-undamped").evidence("largest drive over frequency", drive / w, "")
            } else {
                Finding::info("driven", "backbone-driven").value(drive, "1/s").evidence("frequency", w, "rad/s")
            });
        }
        for m in &found.modes {
            if m.left.is_some_and(|why| why.starts_with("inside")) {
                let finding = Finding::warning("merged_modes", "backbone-merged-modes").value_as(Arg::frequency(m.value.im));
                out.push(finding.arg("growth", Arg::quantity(m.value.re, "1/s")));
            }
        }
        let asymptotes: Vec<Arg> = found.asymptotes.iter().map(|a| Arg::frequency(a.value.im)).collect();
        if !asymptotes.is_empty() {
            let finding = Finding::info("asymptotes", "backbone-asymptotes").value(asymptotes.len() as f64, "");
            out.push(finding.arg("n", Arg::count(asymptotes.len())).arg("frequencies", Arg::List(asymptotes)));
        }
        let kept = found.discretisation.harmonics;
        out.extend(short(self.request.harmonics, self.request.truncation, motions().map(|m| m.truncation), kept));
        out.extend(invalid(self.system, &self.measured.iter().flatten().collect::<Vec<_>>(), "free whirls"));
        out
    }

    fn family(&self, k: usize, f: &Family) -> Vec<Finding> {
        let mut out = Vec::new();
        let (Some(first), Some(last)) = (f.motions.first(), f.motions.last()) else { return out };
        let name = format!("family {}", k + 1);
        let named = self.named(f);
        let whirl = match self.directed() {
            true if named < 0.0 => "backward",
            true => "forward",
            false => "none",
        };
        let change = last.frequency.abs() / first.frequency.abs() - 1.0;
        // more digits where the change is small
        let frequency = |w: f64| if change.abs() < ALIKE { Arg::frequency(w).digits(6) } else { Arg::frequency(w) };
        let trend = |hardens: bool| Arg::word(if hardens { "hardens" } else { "softens" });
        let mut finding = match f.origin {
            Origin::Mode(_) if change.abs() <= STEADY => Finding::info("family", "backbone-family-constant"),
            Origin::Mode(_) => {
                let finding = Finding::info("family", "backbone-family").arg("trend", trend(change > 0.0));
                finding.arg("first", frequency(first.frequency)).arg("last", frequency(last.frequency))
            }
            Origin::Asymptote(a) => {
                let least = f.motions.iter().map(|m| m.amplitude).fold(f64::INFINITY, f64::min);
                Finding::info("family", "backbone-family-beside-asymptote")
                    .arg("asymptote", Arg::frequency(self.found.asymptotes.get(a).map_or(f64::NAN, |a| a.value.im)))
                    .arg("least", Arg::quantity(least, "m"))
                    .arg("last", Arg::frequency(last.frequency))
            }
        };
        if let (Origin::Mode(_), Some(m)) = (f.origin, turning(&f.motions)) {
            let note = Message::new("backbone-turning").arg("trend", trend(m.frequency.abs() > first.frequency.abs()));
            finding.notes.push(note.arg("frequency", frequency(m.frequency)).arg("amplitude", Arg::quantity(m.amplitude, "m")));
        }
        let residual = largest(f.motions.iter().map(|m| m.residual));
        out.push(
            finding
                .of(&name)
                .value_as(Arg::frequency(named))
                .arg("whirl", Arg::word(whirl))
                .arg("first-amplitude", Arg::quantity(first.amplitude, "m"))
                .arg("last-amplitude", Arg::quantity(last.amplitude, "m"))
                .evidence("scaled residual, worst point", residual, "")
                .evidence("orders kept", self.found.discretisation.harmonics as f64, ""),
        );
        for (a, bracket) in &f.synchronous {
            out.push(Finding::info("synchronous", "backbone-synchronous").of(&name).value(*a, "m").evidence(
                "width of the bracket",
                (bracket.0 - bracket.1).abs(),
                "m",
            ));
        }
        if f.vanishes || last.frequency.abs() < VANISHED * first.frequency.abs() && f.end != End::Reached {
            out.push(
                Finding::warning("whirl_ends", "backbone-whirl-ends")
                    .of(&name)
                    .value(last.amplitude, "m")
                    .arg("mode", Arg::frequency(named))
                    .arg("frequency", Arg::frequency(last.frequency))
                    .evidence("frequency", last.frequency, "rad/s"),
            );
        } else if let Some(why) = unfinished(&f.end, self.end) {
            let finding = Finding::warning("family_unfinished", "backbone-family-unfinished").of(&name).value(last.amplitude, "m");
            out.push(finding.arg("mode", Arg::frequency(named)).arg("why", why));
        }
        out
    }

    /// The frequency that names a family: that at which it begins. From a linear mode of a damped machine it is not the damped one, because the drive makes up for
    /// the damping.
    fn named(&self, f: &Family) -> f64 {
        match f.origin {
            Origin::Mode(_) => f.begins,
            Origin::Asymptote(_) => f.motions.first().map_or(f64::NAN, |m| m.frequency),
        }
    }

    /// Where a family begins, in words.
    fn begins(&self, k: usize) -> String {
        let f = &self.found.families[k];
        match f.origin {
            Origin::Mode(_) => format!("from {}", quantity(self.named(f), "rad/s")),
            Origin::Asymptote(a) => {
                format!("beside {}", self.found.asymptotes.get(a).map_or(String::new(), |a| quantity(a.value.im, "rad/s")))
            }
        }
    }

    /// The same for the legend, by what the table has.
    fn called(&self) -> Vec<(String, Arg)> {
        let one = |(k, f): (usize, &Family)| {
            let (word, frequency) = match f.origin {
                Origin::Mode(_) => ("mode", self.named(f)),
                Origin::Asymptote(a) => ("asymptote", self.found.asymptotes.get(a).map_or(f64::NAN, |a| a.value.im)),
            };
            let name = Message::new("backbone-begins").arg("origin", Arg::word(word)).arg("frequency", Arg::frequency(frequency));
            (self.begins(k), name.into())
        };
        self.found.families.iter().enumerate().map(one).collect()
    }

    /// Frequencies have a sign.
    fn directed(&self) -> bool {
        matches!(self.found.discretisation.symmetry, Symmetry::Circular | Symmetry::Quarter)
    }

    fn table(&self) -> Result<Table, OutcomeError> {
        let all = in_order(self.found.families.iter().map(|f| &f.motions[..]), self.measured);
        let column = |f: &dyn Fn(&Motion) -> f64| all.iter().map(|a| f(a.1)).collect::<Vec<f64>>();
        let measured: Vec<&Measured> = all.iter().map(|a| a.2).collect();
        let called = self.called();
        let t = Table::new("backbone", "Free whirls, family by family in order along each")
            .int("family", "", "number of the family", all.iter().map(|a| a.0 as i64 + 1).collect())
            .phrases("begins", "where the family begins", all.iter().map(|a| called[a.0].clone()).collect())
            .float("amplitude", "m", "first-order amplitude of the deflection of the nonlinear parts", column(&|m| m.amplitude))
            .float("frequency", "rad/s", FREQUENCY, column(&|m| m.frequency))
            .float("drive", "1/s", "excitation per mass and velocity that makes up for the losses", column(&|m| m.drive));
        let t = body_columns(t, &self.probes, &measured);
        trust_columns(t, self.system, column(&|m| m.truncation), column(&|m| m.residual), &measured).build()
    }

    fn modes(&self) -> Result<Table, OutcomeError> {
        let modes = &self.found.modes;
        let family = |k: usize| self.found.families.iter().position(|f| f.origin == Origin::Mode(k)).map_or(0, |f| f as i64 + 1);
        Table::new("modes", "Linear modes: free whirls of vanishing amplitude")
            .float("frequency", "rad/s", FREQUENCY, modes.iter().map(|m| m.value.im).collect())
            .float("growth", "1/s", "growth rate", modes.iter().map(|m| m.value.re).collect())
            .text("whirl", "direction", modes.iter().map(|m| m.whirl.word().to_string()).collect())
            .int("family", "", "number of the family that begins here; 0: none", (0..modes.len()).map(family).collect())
            .text("why none", "why no family begins here", modes.iter().map(|m| m.left.unwrap_or("").to_string()).collect())
            .build()
    }

    fn asymptotes(&self) -> Result<Table, OutcomeError> {
        let all = &self.found.asymptotes;
        Table::new("asymptotes", "Modes with the nonlinear parts rigid: free whirls of unbounded amplitude of a hardening machine")
            .float("frequency", "rad/s", FREQUENCY, all.iter().map(|m| m.value.im).collect())
            .float("growth", "1/s", "growth rate", all.iter().map(|m| m.value.re).collect())
            .build()
    }

    fn figure(&self) -> Figure {
        // what is outside the validity of a part is grey, and the axes show little of it
        let motions = || self.found.families.iter().flat_map(|f| &f.motions).zip(self.measured.iter().flatten());
        let inside: Vec<_> = motions().filter(|m| valid(self.system, m.1)).map(|m| m.0).collect();
        let cut = !inside.is_empty() && inside.len() < motions().count();
        let most = if cut { BEYOND * inside.iter().map(|m| m.amplitude).fold(0.0, f64::max) } else { self.found.amplitudes.1 };
        let axis = Axis::new("amplitude of the deflection", "m").metres(most);
        let top = most * axis.factor;
        let mut panel = Panel::new(if cut { axis.range(0.0, top) } else { axis })
            .mark(Line::new("backbone", "frequency", "amplitude").group("begins").called(self.called()).valid_where(VALID));
        let w = self.request.speed;
        let shown = self.found.families.iter().flat_map(|f| &f.motions).map(|m| m.frequency);
        let (least, highest) = shown.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), f| (l.min(f), h.max(f)));
        let mut last = f64::NEG_INFINITY;
        for a in &self.found.asymptotes {
            // one line for those that cannot be distinguished
            if a.value.im - last > 1e-3 * (highest - least) {
                panel = panel.mark(Rule::x(a.value.im, "asymptote"));
                last = a.value.im;
            }
        }
        if (least..=highest).contains(&w) {
            panel = panel.mark(Rule::x(w, "spin"));
        }
        let alt = Message::new("backbone-alt").arg("speed", Arg::speed(w)).arg("families", Arg::count(self.found.families.len()));
        let x = Axis::new("whirl frequency", "rad/s");
        let (from, to) = inside.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), m| (l.min(m.frequency), h.max(m.frequency)));
        let margin = 0.1 * (to - from);
        let x = if cut { x.range(from - margin, to + margin) } else { x };
        Figure::new("backbone", "Nonlinear normal modes", alt).x(x).panel(panel)
    }
}

/// How far beyond the largest valid amplitude the axis goes.
const BEYOND: f64 = 1.5;
