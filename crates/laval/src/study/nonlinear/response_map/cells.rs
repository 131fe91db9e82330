//! Cells of the map and their columns.

use super::ParameterAxis;
use crate::outcome::End;
use crate::solve::harmonic::branches::bifurcation::Event;
use crate::store::{Cells, Column};
use crate::study::nonlinear::nonlinear_response::summary::{Summary, Sweep, Top};

/// One machine.
pub(super) struct Cell {
    /// Values of the two parameters.
    pub at: [f64; 2],
    /// Its response, or why there is none.
    pub found: Result<Box<Summary>, String>,
    /// The user stopped it.
    pub stopped: bool,
}

/// What slow sweeps do, in words.
pub(super) const NO_JUMP: &str = "no jump";
pub(super) const BOTH: &str = "jumps up and down";
pub(super) const DOWN: &str = "jumps down only";
pub(super) const UP: &str = "jumps up only";
pub(super) const APART: &str = "no jump between two families";
pub(super) const UNFINISHED: &str = "unfinished";
pub(super) const UNSTABLE: &str = "unstable before a jump";
pub(super) const FAILED: &str = "failed";
/// All of them, in the order of the legend.
pub(super) const SWEEPS: [&str; 8] = [NO_JUMP, BOTH, DOWN, UP, APART, UNSTABLE, UNFINISHED, FAILED];

fn sweeps(s: &Summary) -> &'static str {
    match s.sweeps {
        [Sweep::Unfinished, _] | [_, Sweep::Unfinished] => UNFINISHED,
        [Sweep::Unstable, _] | [_, Sweep::Unstable] => UNSTABLE,
        [Sweep::Jumps(_), Sweep::Jumps(_)] => BOTH,
        [Sweep::Jumps(_), Sweep::Passes] => UP,
        [Sweep::Passes, Sweep::Jumps(_)] => DOWN,
        [Sweep::Passes, Sweep::Passes] if s.hysteresis > 0.0 => APART,
        [Sweep::Passes, Sweep::Passes] => NO_JUMP,
    }
}

/// Column of the largest tilt.
pub(super) const TILT: &str = "tilt";

/// A column and where its values come from.
pub(super) struct CellColumn {
    pub column: Column,
    get: Get,
}

enum Get {
    Place(usize),
    Number(fn(&Summary) -> f64),
    Word(fn(&Summary) -> Option<String>),
    Failure,
}

fn count(s: &Summary, event: Event) -> f64 {
    s.changes.iter().filter(|c| c.0 == event).count() as f64
}

fn flag(x: bool) -> f64 {
    f64::from(u8::from(x))
}

/// The columns.
pub(super) fn columns(axes: &[ParameterAxis; 2], tilts: bool) -> Vec<CellColumn> {
    let mut out: Vec<CellColumn> = Vec::new();
    for (k, a) in axes.iter().enumerate() {
        out.push(CellColumn { column: Column::float(&a.path, a.unit, "value of the parameter"), get: Get::Place(k) });
    }
    let mut number = |name: &str, unit: &str, doc: &str, get: fn(&Summary) -> f64| {
        out.push(CellColumn { column: Column::float(name, unit, doc), get: Get::Number(get) });
    };
    number("folds", "", "folds of the branches; NaN where the response failed", |s| s.folds as f64);
    number("jump_up", "rad/s", "speed at which a slow sweep up jumps; NaN where there is none", |s| s.sweeps[0].speed());
    number("jump_down", "rad/s", "speed at which a slow sweep down jumps; NaN where there is none", |s| s.sweeps[1].speed());
    number(
        "hysteresis",
        "rad/s",
        "width of the speeds at which there are several states, stable or not; NaN where the response failed or a branch was left",
        |s| s.hysteresis,
    );
    number("open", "", "1 where such speeds reach an end of the range, so that the width goes on beyond it; NaN where it failed", |s| {
        flag(s.open)
    });
    number("peak", "m", "largest stable displacement of any body, at the points that count; NaN where it failed or was not reached", |s| {
        s.top.as_ref().map_or(f64::NAN, |t| t.size)
    });
    number("peak_speed", "rad/s", "its speed; NaN where it failed or was not reached", |s| s.top.as_ref().map_or(f64::NAN, |t| t.speed));
    number("peak_at_end", "", "1 where it lies at an end of the range of speeds; NaN where there is none", |s| {
        s.top.as_ref().map_or(f64::NAN, |t| flag(t.at_end))
    });
    if tilts {
        fn of(s: &Summary, f: fn(&Top) -> f64) -> f64 {
            s.tilt.as_ref().map_or(f64::NAN, f)
        }
        number(TILT, "rad", "largest stable tilt of any body; NaN where it failed or was not reached", |s| of(s, |t| t.size));
        number("tilt_speed", "rad/s", "its speed; NaN where it failed or was not reached", |s| of(s, |t| t.speed));
    }
    number("rising", "", "1 where the displacement or tilt still rose where a branch was left; NaN where it failed", |s| flag(s.rising));
    number("unstable_from", "rad/s", "lowest speed of unstable states that are not between two folds; NaN where there is none", |s| {
        s.unstable.iter().map(|r| r.0).fold(f64::NAN, f64::min)
    });
    number("unstable_to", "rad/s", "highest such speed; NaN where there is none", |s| {
        s.unstable.iter().map(|r| r.1).fold(f64::NAN, f64::max)
    });
    number("growth", "1/s", "fastest growth of these states; 0 where there are none, NaN where it failed or is not known", |s| s.growth);
    number("neimark_sacker", "", "Neimark-Sacker points; NaN where it failed", |s| count(s, Event::NeimarkSacker));
    number("neimark_sacker_from", "rad/s", "the lowest of them; NaN where there is none", |s| {
        s.neimark_sacker().first().copied().unwrap_or(f64::NAN)
    });
    number("neimark_sacker_to", "rad/s", "the highest of them; NaN where there is none", |s| {
        s.neimark_sacker().last().copied().unwrap_or(f64::NAN)
    });
    number("symmetry_breakings", "", "places where states lose their symmetry; NaN where it failed", |s| count(s, Event::SymmetryBreaking));
    number("period_doublings", "", "places where the period doubles; NaN where it failed", |s| count(s, Event::PeriodDoubling));
    number("branch_points", "", "places where states of one symmetry cross; NaN where it failed", |s| count(s, Event::BranchPoint));
    number("validity", "", "largest use of a part's validity, above 1 is outside; NaN where it failed", |s| s.validity.0);
    number("orders", "", "orders kept; NaN where it failed", |s| s.orders as f64);
    number("truncation", "", "dropped over kept force harmonics, worst point; NaN where it failed", |s| s.truncation);
    number("points", "", "points computed; NaN where it failed", |s| s.points as f64);
    let mut word = |name: &str, doc: &str, get: fn(&Summary) -> Option<String>| {
        out.push(CellColumn { column: Column::text(name, doc), get: Get::Word(get) });
    };
    word("sweeps", "what slow sweeps up and down do", |s| Some(sweeps(s).into()));
    word("body", "the body, or point of a body, that moves farthest", |s| s.top.as_ref().map(|t| t.body.clone()));
    if tilts {
        word("tilting_body", "the body that tilts most", |s| s.tilt.as_ref().map(|t| t.body.clone()));
    }
    word("unstable", "ranges of speed of unstable states, rad/s", |s| {
        let each: Vec<String> = s.unstable.iter().map(|r| format!("{} to {}", r.0, r.1)).collect();
        (!each.is_empty()).then(|| each.join("; "))
    });
    word("limit", "the statement of validity that is used most", |s| Some(s.validity.1.clone()));
    word("unassessed", "why stability is not known", |s| s.unassessed.clone());
    word("end", "how a branch was left", |s| (s.end != End::Reached).then(|| s.end.word().to_string()));
    out.push(CellColumn { column: Column::text("failure", "why there is no response"), get: Get::Failure });
    out
}

/// A chunk for the store.
pub(super) fn write(columns: &[CellColumn], all: &[Cell]) -> Vec<Cells> {
    let one = |c: &CellColumn| match c.get {
        Get::Place(k) => Cells::Float(all.iter().map(|cell| cell.at[k]).collect()),
        Get::Number(get) => Cells::Float(all.iter().map(|cell| cell.found.as_ref().map_or(f64::NAN, |s| get(s))).collect()),
        Get::Word(get) => Cells::Text(all.iter().map(|cell| cell.found.as_ref().ok().and_then(|s| get(s))).collect()),
        Get::Failure => Cells::Text(all.iter().map(|cell| cell.found.as_ref().err().cloned()).collect()),
    };
    columns.iter().map(one).collect()
}
