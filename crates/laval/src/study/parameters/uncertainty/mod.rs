//! What another study says when parameters of the machine are uncertain: distribution of every number it finds, and which parameter matters.
//!
//! Equations: inputs `x_i = Q_i(u_i)` with the quantile functions Q_i and points u of the unit cube, random or of Sobol's sequence; quantiles with
//! intervals between order statistics; indices of Sobol by the estimators of Saltelli and Jansen; elementary effects of Morris
//! (see [`laval_num::sampling`]).
//!
//! Symbols: x uncertain parameters; u points of the unit cube; S first-order, T total index.
//!
//! Validity: parameters that do not depend on each other. A sample whose machine does not exist or whose study ends early has no numbers; such samples
//! are counted and their causes listed.
//!
//! Sources: Saltelli et al., Comput. Phys. Commun. 181 (2010) 259; Jansen, Comput. Phys. Commun. 117 (1999) 35; Morris, Technometrics 33 (1991) 161;
//! Campolongo et al., Environ. Model. Softw. 22 (2007) 1509.

pub(crate) mod collect;
mod figures;
mod report;
mod result;
mod tolerance;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, InnerStudy, Values, Word};
use crate::model::system::System;
use crate::outcome::{End, Outcome};
use crate::store::{self, Cells, Column};
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::{Context, ErasedStudy, Study};
use crate::text;
pub use collect::Quantity;
pub(in crate::study) use collect::cause;
use collect::{Sample, encode, quantities, sample};
use laval_num::sampling::quantile::Interval;
use laval_num::sampling::{MOST_DIMENSIONS, Points, morris, sobol_indices};
use laval_num::work::Here;
use rayon::prelude::*;
pub use result::{Failure, Found, Samples, Shares, Spread, Statistics, UncertaintyResult};
pub use tolerance::Uncertain;

const METHODS: &[Word] =
    &[("sobol", "points of a scrambled Sobol sequence, which fill the space evenly"), ("monte_carlo", "independent random points")];
const INDICES: &[Word] = &[
    ("none", "distributions alone"),
    ("sobol", "first-order and total indices of Sobol: samples times (number of parameters + 2) runs"),
    ("morris", "elementary effects of Morris instead of distributions: samples times (number of parameters + 1) runs"),
];
/// Most runs of the inner study.
const MOST_RUNS: usize = 1_000_000;
const CONFIDENCE: f64 = 0.95;

/// Which runs are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Design {
    /// Independent points.
    Plain(Points),
    /// For the indices of Sobol.
    Sobol(Points),
    /// For elementary effects.
    Morris,
}

/// See the [module](self).
pub struct Uncertainty {
    /// What is computed for every sample.
    pub study: Box<dyn ErasedStudy>,
    /// The uncertain parameters.
    pub parameters: Vec<Uncertain>,
    /// Number of samples: points, base points of the indices, or trajectories.
    pub samples: usize,
    /// Which runs are made.
    pub design: Design,
    /// Seed of the points.
    pub seed: u32,
    /// Quantiles reported, between 0 and 1.
    pub quantiles: Vec<f64>,
    /// Beginning of the names of the numbers that are drawn; the first four when empty.
    pub show: String,
}

impl Study for Uncertainty {
    type Result = UncertaintyResult;
    const KIND: &'static str = "uncertainty";
    const IN_CHUNKS: bool = true;
    const EXAMPLE: &'static str = r#"study = { kind = "modes", speed = "3000 rpm" }
parameters = [{ parameter = "drum.mass", distribution = "normal", deviation = "2 %" }]
samples = 256
"#;
    const DOC: &'static str = "Runs another study for many values of uncertain parameters: mean, deviation and quantiles of every number it finds, how often \
        it finds it at all, and, where requested, which parameter matters how much.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::required("study", FieldKind::Study, "what is computed for every sample"),
        Field::required("parameters", FieldKind::Tolerances, "the uncertain parameters, independent of each other"),
        Field::optional(
            "samples",
            FieldKind::Integer { min: 2, max: MOST_RUNS as i64 },
            "256",
            "number of samples; with indices the number of base points or trajectories",
        ),
        Field::optional("method", FieldKind::Choice(METHODS), "sobol", "how points are chosen; those of Morris are random"),
        Field::optional("indices", FieldKind::Choice(INDICES), "none", "which parameter matters"),
        Field::optional(
            "quantiles",
            FieldKind::List { unit: "", bounds: Bounds::closed(1e-6, 1.0 - 1e-6) },
            "[0.05, 0.5, 0.95]",
            "shares of the samples below the values reported",
        ),
        Field::optional("seed", FieldKind::Integer { min: 0, max: u32::MAX as i64 }, "1", "another seed gives other points"),
        Field::optional(
            "show",
            FieldKind::Text,
            "",
            "beginning of the names of the numbers drawn, as critical_speed; the first four unless given",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let study = build_inner(values.study("study")?, system, diagnostics);
        let parameters = tolerance::read(values.tolerances("parameters")?, system, diagnostics);
        let points = if values.choice("method") == Some("monte_carlo") { Points::Random } else { Points::Sobol };
        let design = match values.choice("indices") {
            Some("sobol") => Design::Sobol(points),
            Some("morris") => Design::Morris,
            _ => Design::Plain(points),
        };
        let (study, parameters) = (study?, parameters?);
        let out = Uncertainty {
            study,
            parameters,
            samples: usize::try_from(values.integer("samples").unwrap_or(256)).ok()?,
            design,
            seed: u32::try_from(values.integer("seed").unwrap_or(1)).ok()?,
            quantiles: values.list("quantiles").map_or_else(|| vec![0.05, 0.5, 0.95], <[f64]>::to_vec),
            show: values.text("show").unwrap_or_default().to_string(),
        };
        out.within_limits(values, diagnostics).then_some(out)
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        Vec::new()
    }

    fn size(&self, system: &System) -> Option<Size> {
        // numbers that the other study finds are known after the first run alone
        let runs = self.samples.saturating_mul(self.runs());
        Some(Size::of_rows(runs, self.parameters.len() + system.stations().len().max(8)))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        self.study.admit(system)
    }

    fn prepare(&self, system: &System, context: &Context) -> Result<(), Diagnostic> {
        self.study.prepare(system, context)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<UncertaintyResult, Diagnostic> {
        let inner = Context { progress: &crate::study::Silent, work_limit: u64::MAX, keep: None, ..*context };
        let nominal = self.study.run(system, &inner)?;
        if context.cancelled() || nominal.end == End::Cancelled {
            return Ok(UncertaintyResult { found: None, end: End::Cancelled });
        }
        let rows = self.samples * self.runs();
        let plan = store::Plan {
            study: Self::KIND.into(),
            columns: self.columns(),
            rows,
            // settled by the request alone, so that a resumed study finds its chunks
            chunk: rows.div_ceil(50).clamp(16, 4096),
        };
        context.announce(rows as f64, 1000.0, text!("runs of the study {kind}", kind = self.study.kind()));
        let results = store::run(plan, context, |range, counter| {
            let here = Here::now();
            let one = |row: usize| {
                let _counted = here.enter();
                if counter.cancelled() {
                    return (Vec::new(), Sample::Stopped);
                }
                let values = self.values(row);
                let found = sample(&*self.study, self.machine(system, &values), &inner, quantities);
                // a run that was stopped may end with an error of its own
                let found = if counter.cancelled() { Sample::Stopped } else { found };
                counter.add(1);
                (values, found)
            };
            let first = range.start;
            let all: Vec<(Vec<f64>, Sample)> = range.into_par_iter().map(one).collect();
            Ok(self.cells(first, &all))
        })?;
        Ok(UncertaintyResult { found: Some(Found::new(self, quantities(&nominal), &results)?), end: results.end() })
    }

    fn report(&self, system: &System, result: &UncertaintyResult, name: &str) -> Result<Outcome, Diagnostic> {
        self.conclude(system, result.clone(), name)
    }

    fn conclude(&self, _: &System, result: UncertaintyResult, name: &str) -> Result<Outcome, Diagnostic> {
        match result.found {
            Some(found) => report::report(self, found, result.end, name),
            None => Ok(Outcome::new(Self::KIND, name).end(result.end)),
        }
    }
}

pub(in crate::study) fn build_inner(inner: &InnerStudy, system: &System, diagnostics: &mut Diagnostics) -> Option<Box<dyn ErasedStudy>> {
    let kind = crate::study::registry().into_iter().find(|k| k.info.kind == inner.kind)?;
    let mut own = Diagnostics::default();
    let built = (kind.build)(&inner.values, system, &mut own);
    // the mistakes of one that has a name are reported where it stands
    if inner.name.is_none() {
        diagnostics.0.append(&mut own.0);
    }
    built
}

impl Uncertainty {
    fn within_limits(&self, values: &Values, diagnostics: &mut Diagnostics) -> bool {
        let before = diagnostics.0.len();
        let runs = self.samples.saturating_mul(self.runs());
        let k = self.parameters.len();
        let dimensions = if matches!(self.design, Design::Sobol(_)) { 2 * k } else { k };
        if runs > MOST_RUNS {
            let message =
                text!("{samples} samples of {k} parameters require {runs} runs, which are too many", samples = self.samples, k, runs);
            let help = text!("at most {most} runs in all", most = MOST_RUNS);
            diagnostics.push(Diagnostic::error("uncertainty.runs", message).at(values.span_of("samples")).help(help));
        }
        if dimensions > MOST_DIMENSIONS as usize && matches!(self.design, Design::Plain(Points::Sobol) | Design::Sobol(Points::Sobol)) {
            let message =
                text!("{k} parameters need {dimensions} dimensions; the Sobol sequence has {most}", k, dimensions, most = MOST_DIMENSIONS);
            let help = text!("use method = \"monte_carlo\"");
            diagnostics.push(Diagnostic::error("uncertainty.dimensions", message).at(values.span_of("parameters")).help(help));
        }
        diagnostics.0.len() == before
    }

    /// Runs per sample.
    fn runs(&self) -> usize {
        match self.design {
            Design::Plain(_) => 1,
            Design::Sobol(_) => self.parameters.len() + 2,
            Design::Morris => self.parameters.len() + 1,
        }
    }

    /// Values of the parameters in a row.
    fn values(&self, row: usize) -> Vec<f64> {
        let (seed, inputs) = (self.seed, self.parameters.len());
        let u = match self.design {
            Design::Plain(points) => (0..inputs as u32).map(|d| points.at(seed, row as u32, d)).collect(),
            Design::Sobol(points) => sobol_indices::Plan { points, seed, inputs }.point(row),
            Design::Morris => morris::Plan { seed, inputs }.point(row),
        };
        u.iter().zip(&self.parameters).map(|(u, p)| p.distribution.quantile(*u)).collect()
    }

    fn machine(&self, system: &System, values: &[f64]) -> Result<System, Diagnostic> {
        let changes: Vec<(&str, f64)> = self.parameters.iter().zip(values).map(|(p, x)| (p.path.as_str(), *x)).collect();
        system.with(&changes).map_err(Diagnostics::into_error)
    }

    fn columns(&self) -> Vec<Column> {
        let mut out = vec![Column::int("sample", "", "number of the run")];
        out.extend(self.parameters.iter().map(|p| Column::float(&p.path, p.unit, "value of the parameter")));
        out.extend([
            Column::text("findings", "numbers found: name, value in SI units, unit"),
            Column::int("invalid", "", "1 where a result lies outside the validity of a model"),
            Column::text("failure", "why there are no numbers"),
        ]);
        out
    }

    /// A chunk for the store; `None` when it was stopped in between.
    fn cells(&self, first: usize, all: &[(Vec<f64>, Sample)]) -> Option<Vec<Cells>> {
        if all.iter().any(|s| s.1 == Sample::Stopped) {
            return None;
        }
        let mut out = vec![Cells::Int((0..all.len()).map(|i| Some((first + i) as i64)).collect())];
        out.extend((0..self.parameters.len()).map(|p| Cells::Float(all.iter().map(|s| s.0[p]).collect())));
        let text = |f: &dyn Fn(&Sample) -> Option<String>| Cells::Text(all.iter().map(|s| f(&s.1)).collect());
        out.push(text(&|s| if let Sample::Found(q, _) = s { Some(encode(q)) } else { None }));
        let invalid = |s: &(Vec<f64>, Sample)| if let Sample::Found(_, x) = &s.1 { Some(i64::from(*x)) } else { None };
        out.push(Cells::Int(all.iter().map(invalid).collect()));
        out.push(text(&|s| if let Sample::Failed(why) = s { Some(why.clone()) } else { None }));
        Some(out)
    }
}
