//! What an operating window tells: findings, tables, figures.

use super::borders::stable;
use super::evaluate::Evaluated;
use super::margins::{NAMES, Point, VALID};
use super::vary::{Map, Robust};
use super::window::{End, Interval, excluding, relaxations};
use super::{MAP_PLACES, Objective, OperatingWindow, Policy};
use crate::diagnostic::Diagnostic;
use crate::outcome::{
    Axis, Band, Figure, Finding, Heat, Line, Outcome, OutcomeError, Panel, Points, Rule, SpecialPoint, Status, Table, quantity, significant,
};
use crate::separation::machine::Separator;
use crate::separation::measures::rcf;
use crate::separation::validity::{FIELD, gravity_felt};
use crate::study::shared::support::RPM;
use crate::study::{Context, Study};

pub(super) struct WindowResult<'a> {
    pub study: &'a OperatingWindow,
    pub main: Evaluated,
    pub robust: Option<Robust>,
    pub map: Option<Map>,
    /// What the file separates in and leaves out of the machine.
    pub uncarried: Vec<Finding>,
}

type Built<T> = Result<T, OutcomeError>;

/// Least end of the colour scale of a map.
const LEAST_ROOM: f64 = 0.05;

fn rpm(w: f64) -> String {
    format!("{} rpm", significant(w * RPM, 5))
}

/// A requirement in words; `flow`: of a machine that liquid flows through.
fn words(name: &str, flow: bool) -> &'static str {
    match name {
        "separation" if flow => "the residence time that the separation takes",
        "separation" => "the time that the separation takes",
        "vibration" => "a vibration limit",
        "self_centred" => "the self-centring of the rotor",
        "stable" => "stability",
        "clear" => "the clearance of a natural frequency",
        "passage" => "the passage of the resonances",
        "strength" => "the highest speed",
        "valid" => "the validity of the model of a part",
        _ => "the range looked at",
    }
}

impl WindowResult<'_> {
    pub fn outcome(&self, context: &Context) -> Result<Outcome, Diagnostic> {
        let m = &self.main;
        let mut out = Outcome::new(OperatingWindow::KIND, context.name).over("speed", "rad/s").work("speeds", m.points.len() as u64);
        if let Some(p) = &m.passage {
            out = out.work("steps of the passage", p.steps);
        }
        out = if m.intervals.is_empty() { self.conflict(out) } else { self.windows(out) };
        out = self.recommended(out);
        out = self.shortest(out);
        out = self.remarks(out);
        for (k, i) in m.intervals.iter().enumerate() {
            for (e, side) in [(&i.low, "low"), (&i.high, "high")] {
                let other = e.speed + if side == "low" { -e.bracket } else { e.bracket };
                out = out.special_point(
                    SpecialPoint::new(format!("window_{side}"), e.speed, (e.speed.min(other), e.speed.max(other)))
                        .status(if e.event == "domain limit" { Status::Bracketed } else { Status::Located })
                        .evidence("interval", (k + 1) as f64, ""),
                );
            }
        }
        let mut build = || -> Built<()> {
            let mut made = out.clone().table(self.margins_table()?).table(self.points_table()?).table(self.intervals_table()?);
            if let Some(t) = self.trade_table()? {
                made = made.table(t);
            }
            if let Some(t) = self.map_table()? {
                made = made.table(t);
            }
            out = made;
            Ok(())
        };
        build().map_err(Diagnostic::from)?;
        self.figures(out).checked().map_err(Diagnostic::from)
    }

    /// The throughput, m^3/s, and the volume, m^3, of a machine that liquid flows through.
    fn flow(&self) -> Option<(f64, f64)> {
        let task = self.main.required.task.as_ref()?;
        task.throughput.zip(task.vessel.separator.flow_volume())
    }

    fn windows(&self, mut out: Outcome) -> Outcome {
        let flow = self.flow().is_some();
        let ended = |e: &End, side: &str| match e.event {
            "domain limit" => format!("{side}, by the range looked at"),
            event if e.binding == "stable" => format!("{side}, by stability ({}, {event})", e.detail),
            event => format!("{side}, by {} ({event})", words(&e.binding, flow)),
        };
        for i in &self.main.intervals {
            let text = format!(
                "The machine may run from {} to {{}}: bounded {}, and {}.",
                rpm(i.low.speed),
                ended(&i.low, "below"),
                ended(&i.high, "above")
            );
            out = out.finding(
                Finding::info("window", text)
                    .value(i.high.speed, "rad/s")
                    .shown_as(i.high.speed * RPM, "rpm")
                    .evidence("from", i.low.speed, "rad/s")
                    .evidence("width of the lower bracket", i.low.bracket, "rad/s")
                    .evidence("width of the upper bracket", i.high.bracket, "rad/s")
                    .evidence("width over mean speed", 2.0 * (i.high.speed - i.low.speed) / (i.high.speed + i.low.speed), ""),
            );
        }
        out = self.edges(out);
        if let Some(r) = &self.robust {
            let given = match r.corners {
                0 => String::new(),
                n => format!("at all {n} corners of the uncertain parameters, "),
            };
            let tolerance = significant(100.0 * self.study.tolerance, 3);
            if r.intervals.is_empty() {
                out = out.finding(Finding::warning(
                    "robust_window",
                    format!("No speed is safe {given}with {tolerance} % tolerance of the speed."),
                ));
            }
            for (low, high) in &r.intervals {
                let text = format!("Robust ({given}{tolerance} % tolerance of the speed): from {} to {{}}.", rpm(*low));
                out = out.finding(
                    Finding::info("robust_window", text).value(*high, "rad/s").shown_as(high * RPM, "rpm").evidence("from", *low, "rad/s"),
                );
            }
        }
        out
    }

    /// Why each end of a window is an end, and how wide the widest window is.
    fn edges(&self, mut out: Outcome) -> Outcome {
        for i in &self.main.intervals {
            for (e, side) in [(&i.low, "begins"), (&i.high, "ends")].into_iter().filter(|e| e.0.event != "domain limit") {
                let (reason, fold) = self.reason(e);
                let text = format!("Why the window {side} at {{}}: {reason}.");
                out = out.finding(
                    Finding::info("edge", text)
                        .of(side)
                        .value(e.speed, "rad/s")
                        .shown_as(e.speed * RPM, "rpm")
                        .evidence("width of the bracket", e.bracket, "rad/s")
                        .evidence(
                            "difference from the fold by its extended system",
                            fold.map_or(f64::NAN, |w| (w - e.speed).abs()),
                            "rad/s",
                        ),
                );
            }
        }
        let width = |i: &Interval| i.high.speed - i.low.speed;
        if let Some(w) = self.main.intervals.iter().max_by(|a, b| width(a).total_cmp(&width(b))) {
            let text = format!("The widest window, from {} to {}, spans {{}}.", rpm(w.low.speed), rpm(w.high.speed));
            out = out.finding(Finding::info("widest_window", text).value(width(w), "rad/s").shown_as(width(w) * RPM, "rpm"));
        }
        out
    }

    /// Why the window ends there, and the speed of the fold it ends at.
    fn reason(&self, e: &End) -> (String, Option<f64>) {
        let l = &self.main.required.limits;
        let lists = [
            ("displacement", &l.displacement, "m"),
            ("velocity", &l.velocity, "m/s"),
            ("tilt", &l.tilt, "rad"),
            ("force", &l.force, "N"),
            ("moment", &l.moment, "N m"),
        ];
        let limit = lists.iter().find_map(|(what, list, unit)| {
            let own = list.iter().find(|x| format!("{what} of {}", x.name) == e.detail)?;
            Some((own.value, *unit))
        });
        let what = if e.detail.is_empty() { words(&e.binding, self.flow().is_some()) } else { e.detail.as_str() };
        match (e.event, limit) {
            ("jump", _) => {
                let fold = self.main.folds.iter().copied().min_by(|a, b| (a - e.speed).abs().total_cmp(&(b - e.speed).abs()));
                let fold = fold.filter(|w| (w - e.speed).abs() <= 1e-6 * e.speed);
                let at = if fold.is_some() { "; the edge is a fold" } else { "" };
                let many = if e.states[1] > 1 { " (a slow sweep can reach each of them, so that all count)" } else { "" };
                let excess = match limit {
                    Some(_) if e.beyond.is_finite() => format!("has {} times its limit", significant(1.0 - e.beyond, 4)),
                    _ => "breaks its limit".into(),
                };
                (format!("beyond it the {what} {excess} in one of {} stable states{many}{at}", e.states[1]), fold)
            }
            (_, Some((value, unit))) => (format!("the {what} reaches its limit, {}", quantity(value, unit)), None),
            ("eigenvalue crossing", None) => (format!("the {what} passes the limit of {} 1/s", significant(-l.growth, 4)), None),
            _ => (format!("the limit of {what} is reached"), None),
        }
    }

    /// Why there is no window, and what would open one.
    fn conflict(&self, mut out: Outcome) -> Outcome {
        let points = &self.main.points;
        if !points.is_empty() && points.iter().all(|p| !stable(p) && p.growth.is_finite()) {
            let least = points.iter().map(|p| p.growth).fold(f64::INFINITY, f64::min);
            let text = "The machine is unstable at every speed computed: its growth rate is {} or more. Remove the instability before any other limit counts.";
            out = out.finding(Finding::warning("unstable", text).value(least, "1/s"));
        }
        out = out.finding(Finding::warning("no_window", "No speed computed in the range keeps all requirements."));
        for (a, b) in excluding(points) {
            let text = format!("\"{}\" and \"{}\" exclude each other: no speed computed keeps both.", NAMES[a], NAMES[b]);
            out = out.finding(Finding::warning("excluding", text));
        }
        for (name, margin, speed) in relaxations(points) {
            let what = match NAMES[name] {
                "separation" if self.flow().is_some() => {
                    let text = format!("Lowering the throughput to {{}} of its value would open a window at {}.", rpm(speed));
                    let share = 1.0 / (1.0 - margin);
                    out = out.finding(
                        Finding::info("relaxation", text)
                            .value(1.0 - margin, "")
                            .shown_as(100.0 * share, "%")
                            .evidence("speed", speed, "rad/s"),
                    );
                    continue;
                }
                "separation" => "the time at hand (or a shorter separation)",
                "vibration" => "the vibration limit that binds",
                "self_centred" => "the self-centring ratio",
                "passage" => "the limit on the passage that binds",
                "strength" => "the highest speed",
                _ => continue,
            };
            let text = format!("Relaxing {what} to {{}} times its value would open a window at {}.", rpm(speed));
            out = out.finding(Finding::info("relaxation", text).value(1.0 - margin, "").evidence("speed", speed, "rad/s"));
        }
        if relaxations(points).is_empty() {
            out = out.finding(Finding::info(
                "relaxation",
                "Relaxing a single requirement does not open a window: at every speed computed two or more are broken.",
            ));
        }
        out
    }

    fn recommended(&self, mut out: Outcome) -> Outcome {
        let (s, m) = (self.study, &self.main);
        let Some(best) = &m.best else { return out };
        let why = match s.objective {
            Objective::Margin => "the least margin is largest",
            Objective::Time if self.flow().is_some() => "the throughput could be largest",
            Objective::Time => "the separation is shortest",
            Objective::Energy => "the energy is least",
            Objective::Amplitude => "the vibration is smallest",
        };
        let mut text = format!("Recommended: {{}}, where {why}");
        if best.needed.is_finite() {
            text += &match self.flow() {
                Some((_, volume)) => format!("; the throughput may then be up to {}", litres(volume / best.needed)),
                None => format!("; the separation then takes {}", in_words(best.needed)),
            };
        }
        let mut f = Finding::info("best_speed", text + ".").value(best.speed, "rad/s").shown_as(best.speed * RPM, "rpm");
        for margin in &best.margins {
            f = f.evidence(format!("margin of {}", NAMES[margin.name]), margin.value, "");
        }
        f = f.evidence("largest growth rate", best.growth, "1/s");
        out = out.finding(f.evidence("tilt", best.tilt, "rad").evidence("unbalance of the cups", best.unbalance, "kg m"));
        if let Some(b) = best.binding() {
            let text = format!("There the requirement \"{}\" is nearest to its limit ({}): margin {{}}.", NAMES[b.name], b.detail);
            out = out.finding(Finding::info("binding", text).value(b.value, "").shown_as(100.0 * b.value, "%"));
        }
        // why not faster: the requirement at the end of the interval above
        if let Some(i) = m.intervals.iter().find(|i| i.low.speed <= best.speed && best.speed <= i.high.speed)
            && i.high.event != "domain limit"
        {
            let text = format!("Why not faster: at {{}} the window ends, by {}.", words(&i.high.binding, self.flow().is_some()));
            out = out.finding(Finding::info("not_faster", text).value(i.high.speed, "rad/s").shown_as(i.high.speed * RPM, "rpm"));
        }
        if let Some(task) = &m.required.task {
            let (r1, r2) = task.vessel.separator.at(best.speed).radii();
            let g = task.suspension.medium.gravity;
            let text = format!("The field there grows from {} g to {{}} g.", significant(rcf(best.speed, r1, g), 4));
            out = out.finding(Finding::info("rcf", text).value(rcf(best.speed, r2, g), ""));
        }
        out
    }

    /// Time needed at a speed of the scan with the run-up, where everything but the separation is kept.
    fn shortest(&self, out: Outcome) -> Outcome {
        let m = &self.main;
        let Some(task) = &m.required.task else { return out };
        let kept = m.points.iter().filter(|p| p.feasible_without(0) && p.needed.is_finite());
        match kept.min_by(|a, b| a.needed.total_cmp(&b.needed)) {
            Some(p) => {
                let text = match self.flow() {
                    Some((_, volume)) => {
                        let most = litres(volume / p.needed);
                        format!("The shortest residence time the machine allows is {{}}, a throughput of {most}, at {}.", rpm(p.speed))
                    }
                    None => format!("The shortest time the machine allows is {{}}, at {}.", rpm(p.speed)),
                };
                out.finding(
                    Finding::info("shortest_time", text)
                        .value(p.needed, "s")
                        .evidence(if self.flow().is_some() { "residence time" } else { "time at hand" }, task.time, "s")
                        .evidence("speed", p.speed, "rad/s"),
                )
            }
            None => out,
        }
    }

    /// Bodies whose tilt no limit sees.
    fn leaning(&self, mut out: Outcome) -> Outcome {
        let m = &self.main;
        for body in &m.unseen {
            let inside = m.points.iter().filter(|p| p.feasible()).filter_map(|p| Some((*p.leans.get(body.index)?, p.speed)));
            let Some((tilt, speed)) = inside.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|x| x.0 > 0.0) else { continue };
            let text = format!(
                "\"{}\" tilts by up to {{}} inside the windows, at {}, and no limit applies to its tilt: its displacement counts at the reference point alone. Add tilt to \
                 [limits].",
                body.name,
                rpm(speed)
            );
            out = out
                .finding(Finding::warning("tilt_without_limit", text).of(&body.name).value(tilt, "rad").evidence("speed", speed, "rad/s"));
        }
        out
    }

    fn remarks(&self, mut out: Outcome) -> Outcome {
        let m = &self.main;
        out = self.uncarried.iter().cloned().fold(out, Outcome::finding);
        out = self.doubts(out);
        out = self.leaning(out);
        let required = |name: usize| m.points.iter().any(|p| p.margin(name).is_some());
        let absent: Vec<&str> = (0..NAMES.len()).filter(|&n| n != VALID && !required(n)).map(|n| NAMES[n]).collect();
        if !absent.is_empty() {
            let text = format!("Not checked, because nothing in the file requires it: {}.", absent.join(", "));
            out = out.finding(Finding::info("not_checked", text));
        }
        if !required(0) && !required(1) && !required(5) && !required(6) {
            out = out.finding(Finding::warning(
                "few_requirements",
                "Only stability bounds this window: give [limits], and [[cup]] with [suspension], to make it one to run by.",
            ));
        }
        if let Some(h) = m.harmonics {
            let judged = match m.required.policy {
                Policy::All => "a speed where any stable one breaks a limit is outside",
                Policy::Reached => {
                    "of several stable ones that is judged which the run-up of this file leads to; the window holds for this run-up only"
                }
                Policy::Highest => "of several stable ones that with the largest vibration is judged",
            };
            let text = format!("Steady states of the nonlinear machine are those of all its branches; {judged}.");
            out = out.finding(Finding::info("nonlinear", text).evidence("orders kept", h as f64, ""));
        }
        for w in &m.folds {
            out = out.special_point(SpecialPoint::new("fold", *w, (*w, *w)).status(Status::Bracketed));
        }
        if let Some(p) = &m.passage {
            let top = m.required.top;
            for peak in p.peaks(top) {
                let way = if peak.up { "up" } else { "down" };
                let text = format!("On the way {way} \"{}\" moves by up to {{}}, at {}.", peak.body, rpm(peak.speed));
                let f = Finding::info("passage_peak", text).value(peak.displacement, "m").evidence("speed", peak.speed, "rad/s");
                out = out.finding(f.of(peak.body));
            }
            out = out.finding(Finding::info("passage_torque", "The run-up takes a torque of up to {}.").value(p.torque(top), "N m"));
            out = p.lacks.clone().into_iter().fold(out, Outcome::finding);
        }
        if let (Some(t), Some(task), Some(best)) = (m.required.ramp, &m.required.task, &m.best) {
            let (_, r2) = task.vessel.separator.at(best.speed).radii();
            let share = m.required.top / t * r2 / (best.speed * best.speed * r2);
            let text = "Braking as fast as the run-up, the pellet is pulled sideways with {} of the field that holds it.";
            out = out.finding(Finding::info("braking", text).value(share, "").shown_as(100.0 * share, "%"));
        }
        out
    }

    /// Where the model of the separation is doubtful.
    fn doubts(&self, mut out: Outcome) -> Outcome {
        let m = &self.main;
        let Some(task) = &m.required.task else { return out };
        let (separator, g) = (&task.vessel.separator, task.suspension.medium.gravity);
        let lowest = m.intervals.first().map(|i| i.low.speed);
        if let Some((w, field)) = lowest.and_then(|w| Some((w, gravity_felt(separator, w, g)?))) {
            let text = format!(
                "At the lower end of the window, {}, the field is {{}} g at the innermost liquid; the model of a machine that liquid flows through leaves gravity out, which \
                 holds from {} g on.",
                rpm(w),
                significant(FIELD, 2)
            );
            out = out.finding(Finding::warning("gravity", text).value(field, "").evidence("least field over gravity", FIELD, ""));
        }
        if let (Separator::Tube(..), Some(best)) = (separator, &m.best)
            && let Some(ramp) = task.batch.run_up.to(best.speed)
        {
            let counted = task.batch.at(best.speed).clock.counted(ramp.duration());
            let text = "The liquid of fixed-angle tubes shifts while the speed changes: the run-up counts by an estimate, the field at mean radius, as {} at full speed.";
            out = out.finding(
                Finding::info("run_up_estimate", text)
                    .value(counted, "s")
                    .evidence("duration of the run-up", ramp.duration(), "s")
                    .evidence("by the square of the speed alone", ramp.equivalent(), "s"),
            );
        }
        out
    }

    /// The reason for a table.
    fn reported(&self, e: &End) -> String {
        if e.event == "domain limit" { "the range looked at ends".into() } else { self.reason(e).0 }
    }

    fn margins_table(&self) -> Built<Table> {
        let rows: Vec<(&Point, &super::margins::Margin)> =
            self.main.points.iter().flat_map(|p| p.margins.iter().map(move |m| (p, m))).collect();
        Table::new("margins", "Every requirement over the speed; kept where the margin is 0 or more")
            .float("speed", "rad/s", "spin speed", rows.iter().map(|r| r.0.speed).collect())
            .text("requirement", "name of the requirement", rows.iter().map(|r| NAMES[r.1.name].into()).collect())
            .float(
                "margin",
                "",
                "margin, for stable and clear a distance in speed; NaN where it is not defined, which counts as not kept",
                rows.iter().map(|r| finite(r.1.value)).collect(),
            )
            .flag("kept", "the requirement is kept", rows.iter().map(|r| r.1.value >= 0.0).collect())
            .float(
                "shown",
                "",
                "margin between -1 and 1, for the figure; NaN where it is not defined",
                rows.iter().map(|r| finite(r.1.value).clamp(-1.0, 1.0)).collect(),
            )
            .text("by", "what binds in it", rows.iter().map(|r| r.1.detail.clone()).collect())
            .build()
    }

    fn points_table(&self) -> Built<Table> {
        let p = &self.main.points;
        let column = |f: &dyn Fn(&Point) -> f64| p.iter().map(|x| finite(f(x))).collect::<Vec<f64>>();
        Table::new("speeds", "The machine at every speed looked at")
            .float("speed", "rad/s", "spin speed", column(&|x| x.speed))
            .flag("inside", "all requirements are kept", p.iter().map(Point::feasible).collect())
            .float("least margin", "", "least margin; NaN where a requirement is not defined", column(&|x| x.least()))
            .text(
                "binding",
                "requirement with the least margin",
                p.iter().map(|x| x.binding().map_or("", |m| NAMES[m.name]).into()).collect(),
            )
            .float(
                "time",
                "s",
                "time to reach the recovery, run-up as requested; NaN where nothing is to be separated or it is never reached",
                column(&|x| x.needed),
            )
            .float("tilt", "rad", "tilt of the cups; NaN without cups", column(&|x| x.tilt))
            .float("unbalance", "kg m", "unbalance of the cups; NaN where it cannot be computed", column(&|x| x.unbalance))
            .float(
                "growth",
                "1/s",
                "largest growth rate, before and after the separation; NaN where there is none to tell",
                column(&|x| x.growth),
            )
            .int("states", "", "number of steady states met", p.iter().map(|x| x.states as i64).collect())
            .float(
                "energy",
                "J",
                "kinetic energy of the spin and work of the drive in the time at hand; NaN where it cannot be computed",
                column(&|x| x.energy),
            )
            .build()
    }

    fn intervals_table(&self) -> Built<Table> {
        let i = &self.main.intervals;
        Table::new("window", "Intervals in which all requirements are kept")
            .float("low", "rad/s", "lowest speed", i.iter().map(|x| x.low.speed).collect())
            .float("high", "rad/s", "highest speed", i.iter().map(|x| x.high.speed).collect())
            .text("low binding", "requirement that ends it below", i.iter().map(|x| x.low.binding.clone()).collect())
            .text("high binding", "requirement that ends it above", i.iter().map(|x| x.high.binding.clone()).collect())
            .text("low event", "crossing, jump, eigenvalue crossing or domain limit", i.iter().map(|x| x.low.event.into()).collect())
            .text("high event", "crossing, jump, eigenvalue crossing or domain limit", i.iter().map(|x| x.high.event.into()).collect())
            .text("low reason", "why it ends below", i.iter().map(|x| self.reported(&x.low)).collect())
            .text("high reason", "why it ends above", i.iter().map(|x| self.reported(&x.high)).collect())
            .float("low bracket", "rad/s", "width of the bracket", i.iter().map(|x| x.low.bracket).collect())
            .float("high bracket", "rad/s", "width of the bracket", i.iter().map(|x| x.high.bracket).collect())
            .float(
                "relative width",
                "",
                "width over the mean speed",
                i.iter().map(|x| 2.0 * (x.high.speed - x.low.speed) / (x.high.speed + x.low.speed)).collect(),
            )
            .build()
    }

    /// Window over the time at hand: in each mechanical interval, from the speed at which the time needed falls below it.
    fn trade_table(&self) -> Built<Option<Table>> {
        let m = &self.main;
        let Some(task) = &m.required.task else { return Ok(None) };
        let (mut time, mut low, mut high) = (vec![], vec![], vec![]);
        for k in 0..=40 {
            let t = task.time * 10f64.powf(-1.0 + 2.0 * k as f64 / 40.0);
            for i in &m.mechanical {
                let inside: Vec<&Point> =
                    m.points.iter().filter(|p| p.speed >= i.low.speed && p.speed <= i.high.speed && p.needed.is_finite()).collect();
                let Some(first) = inside.iter().position(|p| p.needed <= t) else { continue };
                let at = inside[first];
                // straight in the logarithms between the points of the scan
                let start = match first.checked_sub(1).map(|b| inside[b]) {
                    Some(b) if b.needed > at.needed => {
                        let share = ((b.needed / t).ln() / (b.needed / at.needed).ln()).clamp(0.0, 1.0);
                        b.speed * (at.speed / b.speed).powf(share)
                    }
                    _ => at.speed,
                };
                time.push(t);
                low.push(start);
                high.push(i.high.speed);
            }
        }
        Table::new("trade", "Window over the time at hand (lower end interpolated in the scan)")
            .float("time", "s", "time at hand", time)
            .float("low", "rad/s", "lowest speed", low)
            .float("high", "rad/s", "highest speed", high)
            .build()
            .map(Some)
    }

    fn map_table(&self) -> Built<Option<Table>> {
        let Some(map) = &self.map else { return Ok(None) };
        let c = &map.cells;
        let mut table =
            Table::new("map", format!("Least margin over spin speed and {} (separation from at most {MAP_PLACES} places)", map.path))
                .float("speed", "rad/s", "spin speed", c.iter().map(|c| c.0).collect())
                .float(map.path.clone(), map.unit, "parameter", c.iter().map(|c| c.1).collect())
                .float("margin", "", "least margin, not below -1", c.iter().map(|c| c.2).collect())
                .text("binding", "requirement with the least margin", c.iter().map(|c| c.3.into()).collect());
        if map.unit == "K" {
            table = table.float("celsius", "degC", "parameter in degrees Celsius", c.iter().map(|c| c.1 - 273.15).collect());
        }
        table.build().map(Some)
    }

    fn figures(&self, mut out: Outcome) -> Outcome {
        let m = &self.main;
        let speed = || Axis::new("spin speed", "rpm").factor(RPM);
        let mut panel = Panel::new(Axis::new("margin", "").range(-1.02, 1.02));
        for (k, i) in m.intervals.iter().enumerate() {
            let band = Band::x(i.low.speed, i.high.speed);
            panel = panel.mark(if k == 0 { band.name("window") } else { band });
        }
        panel = panel.mark(Line::new("margins", "speed", "shown").group("requirement")).mark(Rule::y(0.0, ""));
        if let Some(best) = &m.best {
            panel = panel.mark(Rule::x(best.speed, "recommended"));
        }
        let spans: Vec<String> = m.intervals.iter().map(|i| format!("{} to {}", rpm(i.low.speed), rpm(i.high.speed))).collect();
        let alt = if spans.is_empty() {
            "Margins of all requirements over the spin speed; nowhere are all of them above zero.".to_string()
        } else {
            format!("Margins of all requirements over the spin speed; all are above zero from {}.", spans.join(" and from "))
        };
        out = out.figure(Figure::new("window", "Operating window", alt).x(speed()).panel(panel));
        let at_hand = if self.flow().is_some() { "residence time" } else { "time at hand" };
        if m.required.task.is_some() && m.points.iter().any(|p| p.needed.is_finite()) {
            let (unit, factor) = if m.required.task.as_ref().is_some_and(|d| d.time >= 600.0) { ("min", 1.0 / 60.0) } else { ("s", 1.0) };
            let mut panel = Panel::new(Axis::log("time needed", unit).factor(factor));
            for i in &m.intervals {
                panel = panel.mark(Band::x(i.low.speed, i.high.speed).name("window"));
            }
            panel = panel.mark(Line::new("speeds", "speed", "time").name("time to the recovery"));
            panel = panel.mark(Rule::y(m.required.task.as_ref().map_or(f64::NAN, |d| d.time), at_hand));
            if let Some(best) = &m.best {
                panel = panel.mark(Rule::x(best.speed, "recommended"));
            }
            let alt = "Time that the recovery takes over the spin speed, with the time there is for it.";
            out = out.figure(Figure::new("time", "Time of the separation", alt).x(speed()).panel(panel));
        }
        if out.find_table("trade").is_some_and(|t| t.rows() > 0) {
            let panel = Panel::new(Axis::log(at_hand, "min").factor(1.0 / 60.0))
                .mark(Points::new("trade", "low", "time").name("lowest speed"))
                .mark(Points::new("trade", "high", "time").name("highest speed"));
            let alt = format!("Lowest and highest speed of the window over the {at_hand}.");
            out = out.figure(Figure::new("trade", format!("Window over the {at_hand}"), alt).x(speed()).panel(panel));
        }
        if let Some(map) = &self.map {
            let (unit, factor) = match map.unit {
                "m" => ("mm", 1e3),
                "Pa s" => ("mPa s", 1e3),
                u => (u, 1.0),
            };
            let (unit, column) = if unit == "K" { ("°C", "celsius".to_string()) } else { (unit, map.path.clone()) };
            // one scale for both sides of the edge, as wide as the room inside it
            let room = map.cells.iter().map(|c| c.2).fold(0.0, f64::max);
            let room = if room > 0.0 { room.max(LEAST_ROOM) } else { 1.0 };
            let heat =
                Heat::new("map", "speed", column, "margin", Axis::new("least margin", "").range(-room, room)).diverging().contour(0.0);
            let panel = Panel::new(Axis::new(map.path.clone(), unit).factor(factor)).mark(heat);
            let alt = format!("Least margin over spin speed and {}; the curve is the edge of the window.", map.path);
            out = out.figure(Figure::new("map", "Window over speed and parameter", alt).x(speed()).panel(panel));
        }
        out
    }
}

fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { f64::NAN }
}

/// A throughput for people.
fn litres(q: f64) -> String {
    format!("{} l/h", significant(q * 3.6e6, 4))
}

/// A time for people: minutes beyond ten of them.
fn in_words(t: f64) -> String {
    if t >= 600.0 { format!("{} min", significant(t / 60.0, 4)) } else { quantity(t, "s") }
}
