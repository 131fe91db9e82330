//! Motion of modes along and about the axis, beside the shapes across it: its share of the kinetic energy, and its curves along the machine.

use crate::model::part::DofKind;
use crate::model::system::System;
use crate::outcome::{Arg, Axis, Figure, Line, Message, Panel, Points, Table, TableBuilder};
use crate::solve::characteristic::Equilibrium;
use crate::solve::kinetic::Kinetic;
use crate::solve::pencil::MachineMode;
use crate::study::linear::whirl::lowest;
use crate::study::shared::stations::{Point, Stations};
use laval_num::complex::C64;

/// Share of the kinetic energy from which on a motion is shown.
const LEAST: f64 = 0.05;
/// Modes drawn, at most.
const DRAWN: usize = 6;
/// Words of the two motions.
const KINDS: [&str; 2] = ["axial", "torsional"];

/// Shares of the kinetic energy along the axis and about it.
pub(super) struct Along {
    /// By mode; NaN where nothing with mass moves.
    pub shares: Vec<[f64; 2]>,
}

/// A station with its rows along and about the axis.
struct Place<'s> {
    point: &'s Point,
    rows: [Vec<(usize, f64)>; 2],
}

impl Along {
    /// `None` of a machine without such coordinates.
    pub fn of(system: &System, about: &Equilibrium, modes: &[MachineMode]) -> Option<Along> {
        let of = |kind| (0..system.n()).filter(|&i| system.coordinates()[i].dof.kind == kind).collect();
        let kinds: [Vec<usize>; 2] = [DofKind::Axial, DofKind::Twist].map(of);
        let kinetic = kinds.iter().any(|k| !k.is_empty()).then(|| Kinetic::of(system, Some(about)))?;
        Some(Along { shares: modes.iter().map(|m| kinetic.shares(&kinds, &m.q).unwrap_or([f64::NAN; 2])).collect() })
    }

    /// Columns of the table of modes.
    pub fn columns(&self, table: TableBuilder) -> TableBuilder {
        let of = |kind: usize| self.shares.iter().map(|s| s[kind]).collect();
        let doc = "share of the motion along the axis in the kinetic energy over a period; NaN where nothing with mass moves";
        let table = table.float_if_any("axial_share", "", doc, of(0));
        let doc = "share of the rotation about the axis in the kinetic energy over a period; NaN where nothing with mass moves";
        table.float_if_any("torsional_share", "", doc, of(1))
    }

    /// The share of one of the two motions in a mode, where it is shown.
    fn shown(&self, mode: usize, kind: usize) -> Option<f64> {
        self.shares.get(mode).map(|s| s[kind]).filter(|s| *s >= LEAST)
    }

    /// Lines of the picture of a mode.
    pub fn lines(&self, mode: usize) -> Vec<Arg> {
        let line = |kind: usize| {
            let share = self.shown(mode, kind)?;
            let m = Message::new("shapes-share").arg("kind", Arg::word(KINDS[kind]));
            Some(m.arg("share", Arg::percent(share).digits(2)).into())
        };
        (0..2).filter_map(line).collect()
    }

    /// Sentences below the pictures of these modes, which show the motion across the axis alone.
    pub fn notes(&self, modes: &[usize]) -> Vec<Arg> {
        let note = |&(mode, kind): &(usize, usize)| {
            let share = self.shown(mode, kind)?;
            let m = Message::new("shapes-along").arg("kind", Arg::word(KINDS[kind])).arg("mode", Arg::count(mode + 1));
            Some(m.arg("share", Arg::percent(share).digits(2)).into())
        };
        let all: Vec<(usize, usize)> = modes.iter().flat_map(|&m| [(m, 0), (m, 1)]).collect();
        all.iter().filter_map(note).collect()
    }

    /// The curves along the machine, each over its largest value: those of modes that grow and of the lowest frequencies.
    pub fn figure(
        &self,
        system: &System,
        stations: &Stations,
        modes: &[MachineMode],
        speed: f64,
        grows: impl Fn(&MachineMode) -> bool,
    ) -> Option<(TableBuilder, Figure)> {
        let moves = |k: &usize| modes[*k].frequency() > 0.0 && (0..2).any(|kind| self.shown(*k, kind).is_some());
        let drawn = lowest(modes, (0..modes.len()).filter(moves), speed, DRAWN, grows);
        let places = places(system, stations);
        if drawn.is_empty() || places.len() < 2 {
            return None;
        }
        let curves: Vec<[Vec<f64>; 2]> = drawn.iter().map(|&k| [0, 1].map(|kind| self.curve(&places, &modes[k], k, kind))).collect();
        let rows = || drawn.iter().flat_map(|k| places.iter().enumerate().map(move |(i, p)| (k, i, p)));
        let begins = |i: usize| i == 0 || places[i - 1].point.line != places[i].point.line;
        let values = |kind: usize| curves.iter().flat_map(|c| c[kind].iter().copied()).collect::<Vec<f64>>();
        let table = Table::new("along", Message::new("along-table"))
            .int("mode", "", "number in order of frequency", rows().map(|r| *r.0 as i64 + 1).collect())
            .names("body", "body", rows().map(|r| r.2.point.body.clone()).collect())
            .float("place", if stations.to_scale { "m" } else { "" }, "place along the axis", rows().map(|r| r.2.point.place).collect())
            .flag("begins", "a line of joined stations begins", rows().map(|r| begins(r.1)).collect())
            .float(KINDS[0], "", "displacement along the axis over the largest of the mode, as that one is largest", values(0))
            .float(KINDS[1], "", "rotation about the axis over the largest of the mode, as that one is largest", values(1));
        // a station that is joined to no other is no curve
        let alone = |p: &Place| places.iter().filter(|o| o.point.line == p.point.line).count() == 1;
        let single = places.iter().any(alone);
        let called: Vec<(String, Arg)> =
            drawn.iter().map(|k| ((k + 1).to_string(), Message::new("page-mode").arg("number", Arg::count(k + 1)).into())).collect();
        let alt = Message::new("along-alt").arg("modes", Arg::count(drawn.len())).arg("speed", Arg::speed(speed));
        let x = Axis::new("place along the axis", if stations.to_scale { "m" } else { "" });
        let mut figure = Figure::new("along", "Motion along and about the axis", alt).x(x);
        for (kind, axis) in
            [Axis::new("axial displacement over the largest", ""), Axis::new("twist over the largest", "")].into_iter().enumerate()
        {
            if curves.iter().all(|c| c[kind].iter().all(|x| x.is_nan())) {
                continue;
            }
            let panel = Panel::new(axis);
            figure = figure.panel(match single {
                true => panel.mark(Points::new("along", "place", KINDS[kind]).group("mode").called(called.clone())),
                false => panel.mark(Line::new("along", "place", KINDS[kind]).group("mode").begins_where("begins").called(called.clone())),
            });
        }
        Some((table, figure))
    }

    /// One of the two motions of a mode at all places over the largest, at the instant of that; NaN where it is not shown, or a place has no such coordinate.
    fn curve(&self, places: &[Place], mode: &MachineMode, number: usize, kind: usize) -> Vec<f64> {
        let value = |p: &Place| {
            let sum = p.rows[kind].iter().fold(C64::zero(), |s, (i, c)| s + mode.q[*i].scale(*c));
            (!p.rows[kind].is_empty()).then_some(sum)
        };
        let all: Vec<Option<C64>> = places.iter().map(value).collect();
        let largest = all.iter().flatten().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).filter(|a| a.abs() > 0.0);
        let Some(largest) = largest.filter(|_| self.shown(number, kind).is_some()) else { return vec![f64::NAN; places.len()] };
        all.iter().map(|a| a.map_or(f64::NAN, |a| (a / largest).re)).collect()
    }
}

/// Stations that move along or about the axis.
fn places<'s>(system: &System, stations: &'s Stations) -> Vec<Place<'s>> {
    let one = |point: &'s Point| {
        let slot = system.slots().iter().position(|s| s.name == point.body)?;
        let rows = system.point_along(slot, point.height)?;
        rows.iter().any(|r| !r.is_empty()).then_some(Place { point, rows })
    };
    stations.all.iter().filter_map(one).collect()
}
