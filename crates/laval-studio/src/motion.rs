//! Motions of the machine to be played: the response to unbalance at one speed, and the beginning of a transient.

use crate::answer::Answers;
use crate::scene::Section;
use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{self, construct};
use laval::laval_num::complex::C64;
use laval::laval_num::continuation::Zero;
use laval::laval_num::newton::{Options, newton};
use laval::outcome::Arg;
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::branch::State;
use laval::study::forced_response::ForcedResponse;
use laval::study::modes::Modes;
use laval::study::stations::Stations;
use laval::study::transient::Transient;
use laval::study::{self, Study, TypedStudy};
use laval::text;
use serde::Deserialize;
use serde_json::{Value as Json, json};
use std::f64::consts::TAU;

/// Which motion.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    kind: Kind,
    /// The transient of the file; without one the machine starts from equilibrium.
    #[serde(default)]
    study: Option<String>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Forced,
    Nonlinear,
    Transient,
}

/// Frames of one turn, and most frames.
const PER_TURN: f64 = 16.0;
const MOST_FRAMES: f64 = 2400.0;
const LEAST_FRAMES: f64 = 240.0;
/// Periods of the slowest mode in a transient; turns of the rotor at least and at most.
const PERIODS: f64 = 5.0;
const LEAST_TURNS: f64 = 10.0;
const MOST_TURNS: f64 = MOST_FRAMES / PER_TURN;
/// Steps of the integration, at most.
const STEPS: u64 = 400_000;
/// Frames of a periodic motion in one turn.
const OF_PERIOD: usize = 48;
/// Amplitudes of other orders below this share of the largest are not drawn.
const SMALL: f64 = 1e-4;
/// Relative difference of two states that are one.
const SAME: f64 = 1e-6;

fn one(d: Diagnostic) -> Diagnostics {
    Diagnostics(vec![d])
}

/// Complex amplitudes of x and y from the circular ones: `x + i y = f exp(i phase) + b exp(-i phase)`.
fn of_circles([f, b]: [C64; 2]) -> [C64; 2] {
    let b = C64 { re: b.re, im: -b.im };
    let (sum, difference) = (f + b, f - b);
    [sum, C64 { re: difference.im, im: -difference.re }]
}

/// Semi-major axis of the orbit of two amplitudes.
fn major([x, y]: &[C64; 2]) -> f64 {
    let f = C64 { re: x.re - y.im, im: x.im + y.re };
    let b = C64 { re: x.re + y.im, im: x.im - y.re };
    0.5 * (f.abs() + b.abs())
}

/// Less text than double precision takes; the screen shows no more.
fn short(x: f64) -> Json {
    json!(x as f32)
}

impl Answers<'_> {
    pub(crate) fn motion(&self) -> Result<Json, Diagnostics> {
        let wanted = self.request.motion.as_ref();
        let unnamed = || one(Diagnostic::error("studio.motion", text!("the request names no motion")));
        let wanted = wanted.ok_or_else(unnamed)?;
        let speed = self.speed()?;
        let motions = match wanted.kind {
            Kind::Forced => vec![self.forced_motion(speed)?],
            Kind::Nonlinear => self.nonlinear_motions(speed)?,
            Kind::Transient => vec![self.transient(wanted.study.as_deref(), speed)?],
        };
        Ok(json!({ "motions": motions, "speed": speed }))
    }

    fn section(&self) -> Section {
        let (blocks, horizontal) = study::machine_blocks(&self.loaded.system);
        Section::of(&self.loaded.system, &blocks, horizontal)
    }

    /// The largest displacement, in words.
    fn largest(&self, sizes: impl Iterator<Item = f64>, stations: &Stations) -> (f64, String) {
        let (at, most) = sizes.enumerate().fold((0, 0.0f64), |a, (k, x)| if x > a.1 { (k % stations.all.len().max(1), x) } else { a });
        let body = stations.all.get(at).map_or(String::new(), |s| s.body.clone());
        (most, format!("{}, {body}", self.style.arg(&Arg::quantity(most, "m"))))
    }

    fn harmonic(&self, speed: f64, stations: &Stations, amplitudes: &[[C64; 2]]) -> Json {
        let section = self.section();
        let (most, largest) = self.largest(amplitudes.iter().map(major), stations);
        let place = |(s, [x, y]): (&study::stations::Point, &[C64; 2])| json!({ "body": s.body, "z": section.place(&s.body, s.height), "x": [x.re, x.im], "y": [y.re, y.im] });
        let stations: Vec<Json> = stations.all.iter().zip(amplitudes).map(place).collect();
        json!({ "name": "", "frequency": speed, "growth": 0.0, "whirl": "none", "stations": stations, "largest": largest, "size": most })
    }

    /// `points` holds, for each station, its displacements at the times.
    fn frames(&self, times: &[f64], closed: bool, stations: &Stations, points: &[Vec<[f64; 2]>]) -> Json {
        let section = self.section();
        let sizes = (0..times.len()).flat_map(|i| points.iter().map(move |p| p.get(i).map_or(0.0, |[x, y]| x.hypot(*y))));
        let (most, largest) = self.largest(sizes, stations);
        let column = |p: &[[f64; 2]], k: usize| p.iter().map(|at| short(at[k])).collect::<Vec<_>>();
        let paths: Vec<Json> = stations
            .all
            .iter()
            .zip(points)
            .map(|(s, p)| json!({ "body": s.body, "z": section.place(&s.body, s.height), "x": column(p, 0), "y": column(p, 1) }))
            .collect();
        json!({
            "name": "", "frequency": 0.0, "growth": 0.0, "whirl": "none", "stations": [], "largest": largest, "size": most,
            "frames": { "times": times.iter().map(|t| short(*t)).collect::<Vec<_>>(), "closed": closed, "paths": paths },
        })
    }

    fn forced_motion(&self, speed: f64) -> Result<Json, Diagnostics> {
        let system = &self.loaded.system;
        let study: ForcedResponse = construct(system, &json!({ "speed": speed }))?;
        let result = study.result(system, &self.context("motion")).map_err(one)?;
        let undamped = || one(Diagnostic::error("studio.motion", text!("the response has no bound at this speed: an undamped resonance")));
        let at = result.orbits.at.first().ok_or_else(undamped)?;
        let amplitudes: Vec<_> = at.motions.iter().map(|m| of_circles(*m)).collect();
        Ok(self.harmonic(speed, &result.orbits.stations, &amplitudes))
    }

    /// States on the branches of the response at a speed: the stable ones, or all where none is stable.
    fn nonlinear_motions(&self, speed: f64) -> Result<Vec<Json>, Diagnostics> {
        let system = &self.loaded.system;
        let response = self.response()?;
        let (study, result) = &*response;
        let stations = Stations::of(system);
        let mut found: Vec<(f64, &'static str, Json)> = Vec::new();
        for branch in &result.response.branches {
            let mut balance =
                Balance::new(system, branch.discretisation.whole(), study.request().speeds, Some(self.cancel)).map_err(one)?;
            for pair in branch.points.windows(2) {
                let [a, b] = pair else { continue };
                if (a.speed - speed) * (b.speed - speed) > 0.0
                    || a.speed == b.speed
                    || a.x.len() != balance.dim()
                    || b.x.len() != balance.dim()
                {
                    continue;
                }
                let t = (speed - a.speed) / (b.speed - a.speed);
                let mut x: Vec<f64> = a.x.iter().zip(&b.x).map(|(p, q)| p + t * (q - p)).collect();
                if newton(&mut balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).is_err() {
                    continue;
                }
                let Ok(orbit) = Orbit::of(&mut balance, &x, speed) else { continue };
                let stable = stability(if t < 0.5 { a } else { b });
                let motion = self.periodic(&orbit, branch.turns(), &stations);
                let size = motion["size"].as_f64().unwrap_or(0.0);
                if found.iter().all(|f| (f.0 - size).abs() > SAME * f.0.max(size)) {
                    found.push((size, stable, motion));
                }
            }
        }
        if found.iter().any(|f| f.1 == "stable") {
            found.retain(|f| f.1 == "stable");
        }
        if found.is_empty() {
            return Err(one(Diagnostic::error("studio.motion", text!("no state of the nonlinear response was found at this speed"))));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let with = |(_, stable, mut motion): (f64, &'static str, Json)| {
            motion["stability"] = stable.into();
            motion
        };
        Ok(found.into_iter().map(with).collect())
    }

    fn periodic(&self, orbit: &Orbit, turns: usize, stations: &Stations) -> Json {
        let of = |k: usize| -> Vec<[C64; 2]> { stations.all.iter().map(|s| s.rows.amplitudes(&orbit.coordinates[k])).collect() };
        let sizes: Vec<f64> =
            (0..orbit.orders.len().min(orbit.coordinates.len())).map(|k| of(k).iter().map(major).fold(0.0, f64::max)).collect();
        let most = sizes.iter().copied().fold(0.0, f64::max);
        let first = orbit.orders.iter().position(|o| *o == turns);
        let lone = orbit.orders.iter().zip(&sizes).all(|(o, x)| *o == turns || *x <= SMALL * most);
        if let Some(k) = first.filter(|k| lone && *k < sizes.len()) {
            return self.harmonic(orbit.speed, stations, &of(k));
        }
        let n = OF_PERIOD * turns.max(1);
        let phase = |i: usize| TAU * i as f64 / n as f64;
        let times: Vec<f64> = (0..=n).map(|i| phase(i) / orbit.frequency).collect();
        let points: Vec<Vec<[f64; 2]>> = stations.all.iter().map(|s| (0..=n).map(|i| orbit.pair_at(&s.rows, phase(i))).collect()).collect();
        self.frames(&times, true, stations, &points)
    }

    /// The beginning of a transient: some periods of the slowest mode.
    fn transient(&self, name: Option<&str>, operating: f64) -> Result<Json, Diagnostics> {
        let system = &self.loaded.system;
        let mut fields = match name {
            None => json!({ "speed": operating }),
            Some(name) => {
                let own = self.loaded.spec.studies.iter().any(|b| b.name == name && b.kind == Transient::KIND);
                if !own {
                    let message = text!("the file has no transient {name}", name = text::quoted(&name));
                    return Err(one(Diagnostic::error("studio.motion", message)));
                }
                file::canonical(&self.loaded.spec, name)["study"].take()
            }
        };
        let number = |fields: &Json, name: &str| fields.get(name).and_then(Json::as_f64);
        let speed = number(&fields, "speed").unwrap_or(operating);
        let turn = TAU / speed.abs().max(1e-9);
        let modes: Result<Modes, _> = construct(system, &json!({ "speed": speed }));
        let modes = modes.ok().and_then(|m| m.result(system, &self.context("motion")).ok());
        let slowest =
            modes.iter().flat_map(|r| &r.spectrum.modes).map(|m| m.frequency()).filter(|w| *w > 0.0).fold(f64::INFINITY, f64::min);
        let horizon = (PERIODS * TAU / slowest).clamp(LEAST_TURNS * turn, MOST_TURNS * turn) + number(&fields, "kick_time").unwrap_or(0.0);
        let duration = number(&fields, "duration").map_or(horizon, |d| d.min(horizon));
        if let Some(fields) = fields.as_object_mut() {
            for other in ["kind", "output_step", "waterfall", "spectra", "highest_order", "component_threshold"] {
                fields.shift_remove(other);
            }
        }
        fields["duration"] = json!(duration);
        fields["points"] = json!((PER_TURN * duration / turn).clamp(LEAST_FRAMES, MOST_FRAMES).round() as u64);
        fields["observables"] = json!(false);
        fields["velocities"] = json!(false);
        let study: Transient = construct(system, &fields)?;
        let result = study.result(system, &study::Context { work_limit: STEPS, ..self.context("motion") }).map_err(one)?;
        let record = &result.motion;
        let series: Vec<Option<&[f64]>> = system
            .coordinates()
            .iter()
            .map(|c| record.coordinates.iter().find(|s| s.name == c.name).map(|s| s.values.as_slice()))
            .collect();
        let rest =
            |name: &str| record.coordinates.iter().position(|s| s.name == name).and_then(|k| record.rest.get(k)).copied().unwrap_or(0.0);
        let rests: Vec<f64> = system.coordinates().iter().map(|c| rest(&c.name)).collect();
        let stations = Stations::of(system);
        let mut points = vec![Vec::with_capacity(record.times.len()); stations.all.len()];
        let mut q = vec![0.0; series.len()];
        for i in 0..record.times.len() {
            for ((q, s), rest) in q.iter_mut().zip(&series).zip(&rests) {
                *q = s.and_then(|s| s.get(i)).map_or(0.0, |x| x - rest);
            }
            for (out, s) in points.iter_mut().zip(&stations.all) {
                out.push(s.rows.of(&q));
            }
        }
        let mut motion = self.frames(&record.times, false, &stations, &points);
        motion["turns"] = json!(record.times.last().unwrap_or(&0.0) / turn);
        Ok(motion)
    }
}

fn stability(state: &State) -> &'static str {
    match () {
        () if state.stable() => "stable",
        () if state.unstable() => "unstable",
        () => "unknown",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A motion around an ellipse, from its circles and from its components.
    #[test]
    fn circles_and_components_are_one_motion() {
        let c = |re, im| C64 { re, im };
        let (f, b) = (c(0.3, -0.2), c(-0.1, 0.05));
        let [x, y] = of_circles([f, b]);
        for k in 0..7 {
            let (s, c) = f64::from(k).sin_cos();
            let at = |z: C64| z.re * c - z.im * s;
            let expected = [(f.re + b.re) * c - (f.im - b.im) * s, (f.im + b.im) * c + (f.re - b.re) * s];
            assert!((at(x) - expected[0]).abs() < 1e-15 && (at(y) - expected[1]).abs() < 1e-15);
        }
        assert!((major(&[x, y]) - f.abs() - b.abs()).abs() < 1e-15);
    }
}
