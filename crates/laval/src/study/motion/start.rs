//! Where a motion in time starts: at rest, sagged under weight where the axis lies, and what the file says otherwise.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Field, FieldKind, Values};
use crate::model::part::{At, Rows};
use crate::model::system::{System, Workspace};
use crate::outcome::{Arg, Finding};
use crate::solve::reduced_machine::ReducedMachine;
use crate::solve::rest::{hanging, rest};
use crate::text;
use crate::text::Text;
use crate::units::check_dimension;
use laval_num::dense::{Lu, Mat};

/// `initial`.
pub(in crate::study) const INITIAL: Field = Field::optional(
    "initial",
    FieldKind::StateMap,
    "",
    "start, by name: displacements (\"drum.x\", counted from the undeflected place), rates (\"drum.x'\") and internal states; balls that touch lie side by \
     side from the node line on when nothing is said of them, everything else starts at rest, sagged under its weight when the axis is horizontal",
);

/// The start of a motion.
pub(in crate::study) struct Start {
    /// Coordinates at rest: the place displacements are measured from.
    pub rest: Vec<f64>,
    /// Internal states at rest.
    states: Vec<f64>,
    /// Coordinates that begin elsewhere, by the word of their parts.
    places: Vec<(usize, f64)>,
    /// Why it begins undeflected although it is loaded.
    pub undeflected: Option<String>,
}

impl Start {
    /// At the static equilibrium at a spin speed, with masses that move round in the rotor held where they begin; undeflected where there is none.
    pub fn new(system: &System, speed: f64) -> Self {
        let places = system.places();
        let loaded = system.is_loaded();
        match rest(system, speed).or_else(|d| if loaded { hanging(system, speed, &places) } else { Err(d) }) {
            Ok(found) => Start { states: settled(system, &found.q, found.z, speed), rest: found.q, places, undeflected: None },
            Err(d) => Start {
                rest: vec![0.0; system.n()],
                states: vec![0.0; system.m()],
                places,
                undeflected: loaded.then(|| d.message.to_string()),
            },
        }
    }

    /// The start of a motion that is followed on a reduced machine, and its state, from what the file says of the whole machine.
    pub fn on(self, reduced: Option<&ReducedMachine>, entries: &[(Entry, f64)], y: &mut [f64]) -> Self {
        let Some(reduced) = reduced else {
            self.write(entries, y);
            return self;
        };
        let mut whole = vec![0.0; 2 * self.rest.len() + self.states.len()];
        self.write(entries, &mut whole);
        let own = reduced.state(&whole);
        y[..own.len()].copy_from_slice(&own);
        Start { rest: reduced.coordinates(&self.rest), places: Vec::new(), ..self }
    }

    /// Writes the start and what the file says into a state.
    pub fn write(&self, entries: &[(Entry, f64)], y: &mut [f64]) {
        let n = self.rest.len();
        y[..n].copy_from_slice(&self.rest);
        self.places.iter().for_each(|&(i, x)| y[i] = x);
        y[2 * n..2 * n + self.states.len()].copy_from_slice(&self.states);
        for &(e, x) in entries {
            match e {
                Entry::Coordinate(i) => y[i] = x,
                Entry::Rate(i) => y[n + i] = x,
                Entry::State(i) => y[2 * n + i] = x,
            }
        }
    }
}

/// That a motion starts undeflected, and why.
pub(in crate::study) fn undeflected(why: &Option<String>) -> Option<Finding> {
    let why = why.as_ref()?;
    Some(Finding::warning("start", "start-undeflected").arg("why", Arg::term(why)))
}

/// Internal states of linear parts solve `z' = 0`, which is affine in them; where nothing drives them they stay.
fn settled(system: &System, q: &[f64], mut z: Vec<f64>, speed: f64) -> Vec<f64> {
    let own: Vec<usize> = system.slots().iter().filter(|s| s.is_linear()).flat_map(|s| s.states.clone()).collect();
    let zero = vec![0.0; system.n()];
    let mut ws = Workspace::default();
    let mut rates = |z: &[f64]| {
        let (mut force, mut rate, mut spin) = (vec![0.0; system.n()], vec![0.0; system.m()], 0.0);
        let at = At { q, v: &zero, a: &zero, z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        system.residual(system.params(), &at, &mut rows, &mut ws, |s| s.is_linear() && !s.states.is_empty());
        own.iter().map(|&i| rate[i]).collect::<Vec<f64>>()
    };
    let first = rates(&z);
    if first.iter().all(|r| *r == 0.0) {
        return z;
    }
    let mut jacobian = Mat::zeros(own.len(), own.len());
    for (j, &s) in own.iter().enumerate() {
        let unit = system.states()[s].dof.typical;
        let before = z[s];
        z[s] += unit;
        for (i, r) in rates(&z).into_iter().enumerate() {
            jacobian[(i, j)] = (r - first[i]) / unit;
        }
        z[s] = before;
    }
    let Ok(lu) = Lu::new(&jacobian) else { return z };
    let mut step = first;
    lu.solve(&mut step);
    if step.iter().all(|x| x.is_finite()) {
        own.iter().zip(&step).for_each(|(&s, x)| z[s] -= x);
    }
    z
}

/// What a name in a state map means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::study) enum Entry {
    Coordinate(usize),
    Rate(usize),
    State(usize),
}

/// Entries of a machine in the numbers of its form in time, which has more internal states.
pub(in crate::study) fn renumbered(entries: &[(Entry, f64)], system: &System, timed: &System) -> Vec<(Entry, f64)> {
    let same = |e: Entry| match e {
        Entry::State(i) => timed.states().iter().position(|s| s.name == system.states()[i].name).map(Entry::State),
        other => Some(other),
    };
    entries.iter().filter_map(|&(e, x)| Some((same(e)?, x))).collect()
}

impl Entry {
    /// Place in the state (q, v, z).
    pub fn index(self, system: &System) -> usize {
        match self {
            Entry::Coordinate(i) => i,
            Entry::Rate(i) => system.n() + i,
            Entry::State(i) => 2 * system.n() + i,
        }
    }
    /// SI unit of its values.
    fn unit(self, system: &System) -> String {
        match self {
            Entry::Coordinate(i) => system.coordinates()[i].dof.unit.to_string(),
            Entry::Rate(i) => per_second(system.coordinates()[i].dof.unit),
            Entry::State(i) => system.states()[i].dof.unit.to_string(),
        }
    }
}

/// SI unit of a rate.
fn per_second(unit: &str) -> String {
    if unit.is_empty() { "1/s".to_string() } else { format!("{unit}/s") }
}

/// Names and units of the state (q, v, z): `drum.x`, `drum.x'`, `liquid.surface_x`.
pub(in crate::study) fn state_names(system: &System) -> Vec<(String, String)> {
    let coordinates = system.coordinates().iter().map(|c| (c.name.clone(), c.dof.unit.to_string()));
    let rates = system.coordinates().iter().map(|c| (format!("{}'", c.name), per_second(c.dof.unit)));
    coordinates.chain(rates).chain(system.states().iter().map(|c| (c.name.clone(), c.dof.unit.to_string()))).collect()
}

/// Finds coordinates (`drum.x`), rates (`drum.x'`) and internal states (`liquid.surface_x`).
fn entry(system: &System, name: &str) -> Option<Entry> {
    if let Some(coordinate) = name.strip_suffix('\'') {
        return system.coordinate(coordinate).map(Entry::Rate);
    }
    system.coordinate(name).map(Entry::Coordinate).or_else(|| system.states().iter().position(|s| s.name == name).map(Entry::State))
}

/// Largest displacement, rate or internal state a motion may start with, in SI units: beyond it energies leave the range of numbers.
const LARGEST_START: f64 = 1e9;

/// Reads a state map; says all that is wrong.
pub(in crate::study) fn state_map(values: &Values, field: &str, system: &System, diagnostics: &mut Diagnostics) -> Vec<(Entry, f64)> {
    let mut out: Vec<(Entry, f64)> = Vec::new();
    let units = values.units_of(field);
    for (k, (name, value, span)) in values.state_map(field).unwrap_or_default().iter().enumerate() {
        let Some(found) = entry(system, name) else {
            diagnostics.push(
                Diagnostic::error("coordinate.unknown", text!("there is no coordinate or state \"{name}\"", name))
                    .at(span.clone())
                    .label(text!("unknown coordinate"))
                    .about(name)
                    .help(nearest(system, name)),
            );
            continue;
        };
        if let Some(Some(given)) = units.get(k)
            && let Err(e) = check_dimension(given, &found.unit(system))
        {
            diagnostics
                .push(Diagnostic { help: e.help.map(Box::new), ..Diagnostic::error(e.code, e.message).at(span.clone()).about(name) });
            continue;
        }
        if !(value.abs() <= LARGEST_START) {
            let message = text!(
                "\"{name}\" is {value}; it must lie between {least} and {most} in SI units",
                name,
                value = text::number(*value, 4),
                least = text::number(-LARGEST_START, 4),
                most = text::number(LARGEST_START, 4)
            );
            diagnostics.push(Diagnostic::error("state.bounds", message).at(span.clone()));
        }
        if out.iter().any(|(e, _)| *e == found) {
            diagnostics.push(Diagnostic::error("state.twice", text!("\"{name}\" is given twice", name)).at(span.clone()));
        }
        out.push((found, *value));
    }
    out
}

fn nearest(system: &System, name: &str) -> Text {
    let all = system.coordinates().iter().chain(system.states()).map(|c| c.name.as_str());
    let (part, rate) = (name.split('.').next().unwrap_or_default(), if name.ends_with('\'') { "'" } else { "" });
    let own: Vec<&str> = all.clone().filter(|n| n.split('.').next() == Some(part)).collect();
    if !own.is_empty() {
        let own = own.iter().take(12).map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ");
        return text!("\"{part}\" has {own}", part, own);
    }
    let plain = name.trim_end_matches('\'');
    match all.map(|n| (distance(n, plain), n)).min() {
        Some((d, best)) if d <= 3 => text!("did you mean {near}?", near = format!("\"{best}{rate}\"")),
        _ => {
            let list: Vec<String> =
                system.coordinates().iter().chain(system.states()).take(12).map(|c| format!("\"{}\"", c.name)).collect();
            text!("this machine has {names}", names = list.join(", "))
        }
    }
}

/// Number of edits between two words.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut corner = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let change = corner + usize::from(x != *y);
            corner = row[j + 1];
            row[j + 1] = change.min(corner + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
