//! Answers that come at once: the first page, modes, and what the machine does over the speed.

use crate::check::changed;
use crate::edit::{self, Set};
use crate::machines::{Machines, Response};
use crate::motion;
use crate::scene::Section;
use crate::share::first_page;
use crate::targets;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{self, Loaded, construct, construct_kind};
use laval::outcome::{Outcome, Overview};
use laval::report::{Language, Style, fragment};
use laval::run;
use laval::study::modes::Modes;
use laval::study::nonlinear_response::{NonlinearResponse, NonlinearResponseResult};
use laval::study::stations::Stations;
use laval::study::{self, Cancel, Context, Silent, TypedStudy};
use laval::text;
use serde::Deserialize;
use serde_json::{Value as Json, json};
use std::sync::Arc;
use std::time::Instant;

/// `POST api/answer`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    #[serde(default)]
    pub serial: i64,
    text: String,
    #[serde(default)]
    set: Vec<Set>,
    want: Vec<Want>,
    /// Speed of the modes, rad/s.
    #[serde(default)]
    speed: Option<f64>,
    /// Speeds of the figures over the speed.
    #[serde(default)]
    points: Option<usize>,
    /// Which motion, where one is wanted.
    #[serde(default)]
    pub motion: Option<motion::Request>,
}

/// What is wanted.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Want {
    Page,
    Modes,
    Campbell,
    Stability,
    Forced,
    Nonlinear,
    Motion,
}

impl Want {
    fn word(self) -> &'static str {
        ["page", "modes", "campbell", "stability", "forced", "nonlinear", "motion"][self as usize]
    }

    /// The kind of study that answers it.
    fn kind(self) -> &'static str {
        ["", "modes", "campbell", "stability_map", "forced_response", "nonlinear_response", ""][self as usize]
    }
}

impl Request {
    /// Nothing but what answers within a frame.
    pub fn quick(&self) -> bool {
        self.want.iter().all(|w| *w == Want::Modes)
    }

    /// The same after a change of numbers alone, so that it takes about as long as the last one.
    pub fn follows(&self) -> bool {
        self.quick() && !self.set.is_empty()
    }
}

/// Speeds of figures unless the page says how many.
const POINTS: usize = 60;
const MOST_POINTS: usize = 2000;

/// Sends each answer as soon as it is known.
pub(crate) fn answer(machines: &Machines, request: &Request, language: Language, cancel: &Cancel, send: &dyn Fn(Json)) {
    let refuse = |want: Want, found: &Diagnostics, send: &dyn Fn(Json)| {
        let first = found.0.iter().find(|d| d.severity == laval::diagnostic::Severity::Error).or(found.0.first());
        let sentence = first.map_or_else(String::new, |d| language.said(&d.sentence()));
        send(json!({ "want": want.word(), "serial": request.serial, "error": sentence }));
    };
    let read = changed(machines, &request.text, &request.set)
        .and_then(|(text, edits)| Ok((machines.load(&text).map_err(|found| (*found).clone())?, text, edits)));
    let (loaded, text, edits) = match read {
        Ok(read) => read,
        Err(found) => return request.want.iter().for_each(|w| refuse(*w, &found, send)),
    };
    if !request.set.is_empty() {
        send(json!({ "want": "edit", "serial": request.serial, "edits": edit::shown(&request.text, &edits) }));
    }
    let style = run::style(&text, &loaded, language);
    let answers = Answers { machines, text: &text, loaded: &loaded, style, request, cancel };
    for want in &request.want {
        let begun = Instant::now();
        let found = answers.of(*want);
        // the page has closed the connection
        if cancel.load(std::sync::atomic::Ordering::Relaxed) {
            return;
        }
        match found {
            Ok(mut value) => {
                value["want"] = want.word().into();
                value["serial"] = request.serial.into();
                value["ms"] = json!((1e6 * begun.elapsed().as_secs_f64()).round() / 1e3);
                send(value);
            }
            Err(found) => refuse(*want, &found, send),
        }
    }
}

/// What answers are computed from.
pub(crate) struct Answers<'a> {
    machines: &'a Machines,
    text: &'a str,
    pub loaded: &'a Loaded,
    pub style: Style,
    pub request: &'a Request,
    pub cancel: &'a Cancel,
}

impl Answers<'_> {
    fn of(&self, want: Want) -> Result<Json, Diagnostics> {
        match want {
            Want::Page => Ok(self.page()),
            Want::Modes => self.modes(),
            Want::Nonlinear => self.nonlinear(),
            Want::Motion => self.motion(),
            _ => self.over_speed(want),
        }
    }

    pub fn context<'c>(&'c self, name: &'c str) -> Context<'c> {
        Context { name, cancel: self.cancel, progress: &Silent, work_limit: u64::MAX, keep: None }
    }

    fn page(&self) -> Json {
        let report = first_page(self.text, self.loaded, self.style.language, self.cancel);
        let page = report.overview.unwrap_or_default();
        json!({ "html": fragment::first_page(&page, &self.style) })
    }

    /// The speed that the page has chosen, or that of the machine.
    pub fn speed(&self) -> Result<f64, Diagnostics> {
        let speed = self.request.speed.or(self.loaded.system.machine.speed).filter(|s| s.is_finite());
        speed.ok_or_else(|| Diagnostics(vec![Diagnostic::error("studio.speed", text!("the machine file gives no speed"))]))
    }

    fn modes(&self) -> Result<Json, Diagnostics> {
        let system = &self.loaded.system;
        let one = |d| Diagnostics(vec![d]);
        let speed = self.speed()?;
        let study: Modes = construct(system, &json!({ "speed": speed }))?;
        let result = study.result(system, &self.context("modes")).map_err(one)?;
        let mut modes: Vec<_> = result.spectrum.modes.iter().collect();
        modes.sort_by(|a, b| a.frequency().total_cmp(&b.frequency()));
        let growing = modes.iter().filter(|m| m.growth() > 0.0).count();
        let shown: Vec<_> = modes.iter().filter(|m| m.frequency() > 0.0 || m.growth() > 0.0).take(MOST_MODES.max(growing)).collect();
        let cards = Overview { modes: shown.iter().map(|m| study::mode_of_page(system, m, speed)).collect(), ..Overview::default() };
        let (blocks, horizontal) = study::machine_blocks(system);
        let section = Section::of(system, &blocks, horizontal);
        let stations = Stations::of(system);
        let shapes: Vec<Json> = shown
            .iter()
            .zip(&cards.modes)
            .enumerate()
            .map(|(k, (m, card))| {
                let size = stations.all.iter().flat_map(|s| s.rows.amplitudes(&m.q)).map(|x| x.abs()).fold(0.0, f64::max);
                let scale = if size > 0.0 { 1.0 / size } else { 0.0 };
                let at: Vec<Json> = stations
                    .all
                    .iter()
                    .map(|s| {
                        let [x, y] = s.rows.amplitudes(&m.q).map(|x| x.scale(scale));
                        json!({ "body": s.body, "z": section.place(&s.body, s.height), "x": [x.re, x.im], "y": [y.re, y.im] })
                    })
                    .collect();
                json!({ "name": (k + 1).to_string(), "frequency": m.frequency(), "growth": m.growth(), "whirl": card.whirl, "stations": at })
            })
            .collect();
        Ok(json!({ "html": fragment::modes(&cards, &self.style), "shapes": shapes, "speed": speed }))
    }

    /// A study of the file of this kind, without what makes it a map; else one over the range of the first page.
    fn fields(&self, want: Want) -> Json {
        let own = self.loaded.spec.studies.iter().find(|b| b.kind == want.kind() && b.values.get("parameter").is_none());
        let points = self.request.points.unwrap_or(POINTS).clamp(2, MOST_POINTS);
        let points = (want != Want::Nonlinear).then_some(points);
        let written = own.map(|b| file::canonical(&self.loaded.spec, &b.name)["study"].take());
        if let Some(Json::Object(mut fields)) = written {
            fields.shift_remove("kind");
            if let (Some(speed), Some(n)) = (fields.get_mut("speed").and_then(Json::as_object_mut), points)
                && speed.get("from") != speed.get("to")
            {
                speed.insert("points".into(), json!(n));
            }
            return fields.into();
        }
        let system = &self.loaded.system;
        let speeds: Vec<_> = self.loaded.studies.iter().flat_map(|s| s.study.speeds(system)).collect();
        let (from, to) = study::page_range(system, &speeds);
        match points {
            Some(n) => json!({ "speed": { "from": from, "to": to, "points": n } }),
            None => json!({ "speed": { "from": from, "to": to } }),
        }
    }

    fn over_speed(&self, want: Want) -> Result<Json, Diagnostics> {
        let system = &self.loaded.system;
        let study = construct_kind(want.kind(), system, &self.fields(want))?;
        let outcome = study.run(system, &self.context(want.word())).map_err(|d| Diagnostics(vec![d]))?;
        self.shown(want, &outcome)
    }

    fn nonlinear(&self) -> Result<Json, Diagnostics> {
        let response = self.response()?;
        let (study, result) = &*response;
        let outcome = study.outcome(&self.loaded.system, result, Want::Nonlinear.word()).map_err(|d| Diagnostics(vec![d]))?;
        self.shown(Want::Nonlinear, &outcome)
    }

    /// The response over the range of speeds, computed once for a text.
    pub fn response(&self) -> Result<Response, Diagnostics> {
        if let Some(known) = self.machines.response(self.text) {
            return Ok(known);
        }
        let response = Arc::new(self.computed_response()?);
        if response.1.end.is_complete() {
            self.machines.keep(self.text, &response);
        }
        Ok(response)
    }

    /// With as many orders as sufficed for a machine of the same parts: finding their number anew would follow all branches twice.
    fn computed_response(&self) -> Result<(NonlinearResponse, NonlinearResponseResult), Diagnostics> {
        let system = &self.loaded.system;
        let one = |d| Diagnostics(vec![d]);
        let mut fields = self.fields(Want::Nonlinear);
        let context = self.context(Want::Nonlinear.word());
        let automatic = fields.get("harmonics").is_none_or(|h| h == "auto");
        let parts: String = system.slots().iter().map(|s| format!("{} {}\n", s.part.kind(), s.name)).collect();
        if let Some(orders) = self.machines.orders(&parts).filter(|_| automatic) {
            fields["harmonics"] = orders.into();
            let study = construct::<NonlinearResponse>(system, &fields)?.sketch();
            let result = study.result(system, &context).map_err(one)?;
            let dropped = result.response.branches.iter().flat_map(|b| &b.points).map(|p| p.truncation).fold(0.0, f64::max);
            if dropped <= study.request().truncation {
                return Ok((study, result));
            }
            fields["harmonics"] = "auto".into();
        }
        let study = construct::<NonlinearResponse>(system, &fields)?.sketch();
        let result = study.result(system, &context).map_err(one)?;
        if automatic && result.end.is_complete() {
            self.machines.remember(parts, result.response.discretisation.harmonics);
        }
        Ok((study, result))
    }

    fn shown(&self, want: Want, outcome: &Outcome) -> Result<Json, Diagnostics> {
        let findings: Vec<String> = outcome.findings.iter().map(|f| self.style.sentence(f)).collect();
        let Some(figure) = outcome.figures.first() else { return Ok(json!({ "html": "", "findings": findings, "targets": [] })) };
        let drawn = fragment::figure(figure, &outcome.tables, &self.style, &format!("{}-0", want.word()));
        let drawn = drawn.map_err(|e| {
            let message = text!("the figure cannot be drawn: {e}", e = e.to_string());
            Diagnostics(vec![Diagnostic::error("studio.figure", message)])
        })?;
        let targets = targets::targets(want, outcome, &drawn, &self.style);
        Ok(json!({ "html": drawn.html, "findings": findings, "targets": targets }))
    }
}

/// Modes shown; those that grow are always shown.
const MOST_MODES: usize = 12;
