//! Approximate methods side by side: how far harmonic balance with few orders, averaging, elliptic balance and integration in time are from
//! the converged motion under unbalance.
//!
//! Equations: see [`crate::solve::harmonic::branches::methods`] and [`crate::solve::harmonic::balance::elliptic`].
//!
//! Symbols: k^2 parameter of the elliptic cosine.
//!
//! Validity: periodic motion at the spin speed. Elliptic balance applies to one deflection with a hardening cubic law in x and y apart.
//!
//! Sources: `000_a291f7ede1484e56` chapters 1 and 2; `docs/theory/approximate-methods.md#averaging`, `docs/theory/approximate-methods.md#elliptic-balance`.

use super::nonlinear_response::around;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, RangeValue, Values};
use crate::model::system::{Drive, System};
use crate::outcome::{Arg, Axis, End, Figure, Finding, Message, Outcome, OutcomeError, Panel, Points, Table};
use crate::solve::harmonic::balance::problem::Discretisation;
use crate::solve::harmonic::branches::methods::{Comparison, Method, Value, compare, component, orders};
use crate::solve::harmonic::branches::response::{Request, Response, respond, symmetry};
use crate::solve::symmetry::Symmetry;
use crate::study::nonlinear::progress::progress;
use crate::study::shared::probes;
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{one_or_range, probe_name};
use crate::study::shared::validity::Uses;
use crate::study::{Context, Study};
use crate::text;
use serde::{Deserialize, Serialize};

/// See the [module](self).
pub struct Methods {
    /// Speeds, rad/s.
    pub speed: RangeValue,
    /// Largest order of harmonic balance compared.
    pub harmonics: usize,
}

/// Relative deviation that is rounding.
const EXACT: f64 = 1e-12;

impl Study for Methods {
    type Result = MethodsResult;
    const KIND: &'static str = "methods";
    const EXAMPLE: &'static str = r#"speed = { from = "1000 rpm", to = "12000 rpm", points = 12 }
harmonics = 7
"#;
    const DOC: &'static str = "Approximate methods beside the converged motion under unbalance, at some speeds and for every state there: harmonic balance \
        with orders from 1, averaging (van der Pol; its states are those of one harmonic), elliptic balance in its period-consistent form where the law \
        allows it, and integration in time. Each with its deviation; folds too.";
    const FIELDS: &'static [Field] = &[
        Field::required(
            "speed",
            FieldKind::Range { unit: "rad/s", bounds: Bounds::closed(1e-3, 1e7) },
            "one spin speed, or a range; compared at 25 points unless given",
        ),
        Field::optional("harmonics", FieldKind::Integer { min: 1, max: 31 }, "7", "largest order of harmonic balance compared"),
    ];

    fn build(values: &Values, _: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = one_or_range("speed", values.range("speed")?, 2, values, diagnostics)?;
        let harmonics = values.integer("harmonics").and_then(|i| usize::try_from(i).ok()).unwrap_or(7);
        Some(Methods { speed, harmonics })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::between(self.speed.from, self.speed.to)]
    }

    fn size(&self, system: &System) -> Option<Size> {
        Some(Size::of_rows(self.speed.points.unwrap_or(25), 32 + 8 * system.stations().len()))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        if system.machine.drive == Drive::Free {
            return Err(Diagnostic::error(
                "methods.free_drive",
                text!("the methods are compared at constant speed, and the speed of this machine is free"),
            )
            .help(text!("prescribe the speed of the machine (leave out its free drive)")));
        }
        symmetry(system, &self.request()).map(drop)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<MethodsResult, Diagnostic> {
        self.admit(system)?;
        let most = usize::try_from(context.work_limit).unwrap_or(usize::MAX).clamp(2, 20_000);
        let request = Request { max_points: most, ..self.request() };
        let converged = respond(system, &request, context.cancel, &|step| progress(context, &step))?;
        let speeds = if self.speed.is_one() { vec![self.speed.from] } else { self.speed.linspace(25) };
        let within = usize::try_from(context.work_limit).unwrap_or(usize::MAX).min(speeds.len());
        let total = speeds.len() as u64;
        let mut lower: Vec<(usize, Response)> = Vec::new();
        for h in orders(&converged, self.harmonics) {
            if context.cancelled() {
                break;
            }
            lower.push((h, respond(system, &Request { harmonics: Some(h), ..request }, context.cancel, &|_| {})?));
        }
        let found = compare(system, &converged, request.speeds, &speeds[..within], &lower, context.cancel, &|done| {
            context.progress.report(done, total);
        })?;
        let mut folds: Vec<FoldBy> = Vec::new();
        let exact: Vec<f64> = speeds_of(&converged);
        for (h, by) in lower.iter().filter(|_| converged.discretisation.symmetry != Symmetry::Circular) {
            folds.extend(speeds_of(by).into_iter().map(|speed| {
                let nearest = exact.iter().copied().min_by(|a, b| (a - speed).abs().total_cmp(&(b - speed).abs()));
                FoldBy { method: Method::Harmonic(*h), speed, deviation: nearest.map_or(f64::NAN, |e| speed - e) }
            }));
        }
        folds.extend(exact.iter().map(|&speed| FoldBy { method: Method::Converged, speed, deviation: 0.0 }));
        let complete = within == speeds.len() && found.complete;
        let uses = Uses::of_response(system, &converged, request.speeds)?;
        Ok(MethodsResult { discretisation: converged.discretisation, found, folds, uses, end: context.end(complete) })
    }

    fn report(&self, system: &System, result: &MethodsResult, name: &str) -> Result<Outcome, Diagnostic> {
        let outcome = self.outcome(system, result, name).map_err(Diagnostic::from)?;
        Ok(result.uses.of_states(system).into_iter().fold(outcome, Outcome::finding))
    }
}

/// States and folds by all methods.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MethodsResult {
    /// Of the converged response.
    pub discretisation: Discretisation,
    /// Peaks of every state by every method.
    pub found: Comparison,
    /// Folds by harmonic balance with few orders, then the converged ones.
    pub folds: Vec<FoldBy>,
    /// Use of the parts' validity by the converged states.
    pub uses: Uses,
    /// How the study ended.
    pub end: End,
}

/// A fold by one method.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FoldBy {
    /// The method.
    pub method: Method,
    /// Spin speed, rad/s.
    pub speed: f64,
    /// From the nearest converged one, rad/s; NaN where there is none.
    pub deviation: f64,
}

fn speeds_of(r: &Response) -> Vec<f64> {
    r.branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect()
}

impl Methods {
    fn request(&self) -> Request {
        let (from, to) = if self.speed.is_one() { around(self.speed.from) } else { (self.speed.from, self.speed.to) };
        Request { truncation: 1e-9, stability: false, ..Request::over(from, to) }
    }

    fn outcome(&self, system: &System, result: &MethodsResult, name: &str) -> Result<Outcome, OutcomeError> {
        let MethodsResult { found, folds, .. } = result;
        let all: Vec<&Value> = found.values.iter().filter(|v| v.method != Method::Converged).collect();
        let converged_of =
            |v: &Value| found.values.iter().find(|c| c.method == Method::Converged && c.speed == v.speed && c.state == v.state);
        let column = |f: &dyn Fn(&Value) -> f64| all.iter().map(|v| f(v)).collect::<Vec<f64>>();
        let mut t = Table::new("methods", "Peaks of every state by every method, beside the converged ones")
            .float("speed", "rad/s", "spin speed", column(&|v| v.speed))
            .int("state", "", "number of the state at this speed, by amplitude", all.iter().map(|v| v.state as i64 + 1).collect())
            .text("method", "method", all.iter().map(|v| v.method.to_string()).collect());
        for k in probes::ordered(system) {
            let probe = &system.probes()[k];
            let peak = |v: &Value| v.peaks.get(k).copied().unwrap_or(f64::NAN);
            let component = if probe.is_tilt() { ["tilt_x", "tilt_y"] } else { ["x", "y"] }[component(probe)];
            let whose = if probe.is_tilt() { format!("{} tilt", probe.name) } else { probe_name(probe) };
            t = t
                .float(
                    format!("{} largest {component}", probes::owner(probe)),
                    probe.unit(),
                    Arg::noted("largest size over a period", "NaN when the method has no state near the converged one"),
                    column(&peak),
                )
                .float(
                    format!("{whose} converged"),
                    probe.unit(),
                    "the same, converged; NaN when there is none",
                    column(&|v| converged_of(v).map_or(f64::NAN, peak)),
                );
        }
        let t = t
            .float(
                "deviation",
                "",
                "largest change of a peak from the converged one, over the largest converged peak (10 mrad count as 1 mm); NaN where the method has no state, or nothing moves",
                column(&|v| v.deviation),
            )
            .float("growth of slow motion", "1/s", "largest growth rate by averaging; NaN for other methods", column(&|v| v.growth))
            .float(
                "growth converged",
                "1/s",
                "largest growth rate of any disturbance of the converged state; NaN when not assessed",
                column(&|v| converged_of(v).map_or(f64::NAN, |c| c.growth)),
            )
            .float("parameter", "", "k^2 of elliptic balance; NaN for other methods", column(&|v| v.parameter))
            .build()?;
        let mut out = Outcome::new(Self::KIND, name).over("speed", "rad/s").end(result.end);
        for f in findings(result) {
            out = out.finding(f);
        }
        if t.rows() > 0 {
            out = out.table(t);
            // one speed makes no curve
            if all.iter().any(|v| v.deviation > 0.0) && !self.speed.is_one() {
                let axis = Axis::log("deviation of the peak", "%").factor(100.0);
                let points = Points::new("methods", "speed", "deviation").classes("method", &["averaging", "harmonic balance to order 1"]);
                let alt = "methods-alt";
                out = out.figure(
                    Figure::new("methods", "Methods side by side", alt)
                        .x(Axis::new("spin speed", "rad/s"))
                        .panel(Panel::new(axis).mark(points)),
                );
            }
        }
        if !folds.is_empty() {
            out = out.table(
                Table::new("folds", "Folds of the response by method")
                    .text("method", "method", folds.iter().map(|f| f.method.to_string()).collect())
                    .float("speed", "rad/s", "spin speed", folds.iter().map(|f| f.speed).collect())
                    .float(
                        "deviation",
                        "rad/s",
                        "from the nearest converged fold; NaN without one",
                        folds.iter().map(|f| f.deviation).collect(),
                    )
                    .build()?,
            );
        }
        out.checked()
    }
}

/// A method, as a phrase inside a sentence.
fn phrase(method: Method) -> Message {
    let of = |word| Message::new("methods-method").arg("method", Arg::word(word));
    match method {
        Method::Harmonic(h) => of("harmonic").arg("order", Arg::count(h)),
        Method::Averaging => of("averaging"),
        Method::Elliptic => of("elliptic"),
        Method::Time => of("time"),
        Method::Converged => of("converged"),
    }
}

fn findings(result: &MethodsResult) -> Vec<Finding> {
    let MethodsResult { found, folds, .. } = result;
    let mut out = Vec::new();
    let states = || found.values.iter().filter(|v| v.method == Method::Converged && v.growth.is_finite());
    let (unstable, all) = (states().filter(|v| v.growth > v.growth_error).count(), states().count());
    if unstable > 0 {
        let finding = Finding::warning("unstable", "methods-unstable").value(unstable as f64, "");
        out.push(finding.arg("unstable", Arg::count(unstable)).arg("states", Arg::count(all)));
    }
    let mut methods: Vec<Method> = Vec::new();
    for v in &found.values {
        if v.method != Method::Converged && !methods.contains(&v.method) {
            methods.push(v.method);
        }
    }
    for method in methods {
        let own = || found.values.iter().filter(move |v| v.method == method);
        let worst = own().filter(|v| v.deviation.is_finite()).max_by(|a, b| a.deviation.total_cmp(&b.deviation));
        let (missing, count) = (own().filter(|v| !v.deviation.is_finite()).count(), own().count());
        let Some(v) = worst else {
            let none = Finding::warning("no_states", "methods-no-states").of(method.to_string());
            out.push(none.arg("method", phrase(method)));
            continue;
        };
        let mut finding = if v.deviation <= EXACT {
            Finding::info("deviation", "methods-exact")
        } else {
            Finding::info("deviation", "methods-deviation").arg("speed", Arg::speed(v.speed)).arg("state", Arg::count(v.state + 1))
        }
        .of(method.to_string())
        .value_as(Arg::percent(v.deviation))
        .arg("method", phrase(method))
        .evidence("speed", v.speed, "rad/s");
        if missing > 0 {
            let note = Message::new("methods-missing").arg("missing", Arg::count(missing));
            finding.notes.push(note.arg("states", Arg::count(count)));
        }
        out.push(finding);
    }
    let assessed = |m: Method| found.values.iter().filter(move |v| v.method == m && v.growth.is_finite());
    let (mut wrong, mut count) = (0, 0);
    for a in assessed(Method::Averaging) {
        // what neither grows nor decays beyond its error has no sign to compare
        let reported = |c: &&Value| c.speed == a.speed && c.state == a.state && c.growth.abs() > c.growth_error;
        if let Some(c) = assessed(Method::Converged).find(reported) {
            count += 1;
            wrong += usize::from((a.growth > 0.0) != (c.growth > 0.0));
        }
    }
    if count > 0 {
        let finding = Finding::info("averaging_stability", "methods-averaging-stability").value(wrong as f64, "");
        out.push(finding.arg("wrong", Arg::count(wrong)).arg("states", Arg::count(count)));
    }
    if let Some(f) = folds
        .iter()
        .filter(|f| f.method == Method::Harmonic(1) && f.deviation.is_finite())
        .max_by(|a, b| a.deviation.abs().total_cmp(&b.deviation.abs()))
    {
        let finding = Finding::info("fold_deviation", "methods-fold-deviation").value(f.deviation, "rad/s");
        out.push(finding.arg("speed", Arg::speed(f.speed - f.deviation)));
    }
    if let Some(why) = found.no_elliptic {
        out.push(Finding::info("no_elliptic_balance", "methods-no-elliptic-balance").arg("why", Arg::term(why)));
    }
    if let Some(why) = &found.no_time {
        out.push(Finding::warning("no_time_integration", "methods-no-time-integration").arg("why", Arg::term(why)));
    }
    if result.discretisation.symmetry == Symmetry::Circular {
        out.push(Finding::info("one_harmonic_exact", "methods-one-harmonic-exact"));
    }
    out
}
