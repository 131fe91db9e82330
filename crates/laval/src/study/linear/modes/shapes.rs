//! Shapes of modes: how every station of the machine moves in each, scaled so that the largest orbit has the semi-major axis 1 and the instant 0 is the one at
//! which its point is farthest from the axis.

use super::along::Along;
use crate::model::system::System;
use crate::outcome::{Arg, Figure, Message, Picture, Table, Tiles, View};
use crate::solve::pencil::{MachineMode, Whirl};
use crate::study::linear::whirl::lowest;
use crate::study::shared::stations::Stations;
use laval_num::complex::C64;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Shapes of all modes of a spectrum.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Shapes {
    /// What moves.
    pub stations: Stations,
    /// Forward and backward circular amplitudes of every station, by mode; zero where no body moves.
    pub modes: Vec<Vec<[C64; 2]>>,
}

/// Modes drawn: of more those that grow and those of the lowest frequencies.
const DRAWN: usize = 12;
/// Share of the largest displacement that is rounding.
const ROUNDING: f64 = 1e-10;

impl Shapes {
    /// Of a machine with more than a single point.
    pub fn of(system: &System, modes: &[MachineMode]) -> Option<Shapes> {
        let stations = Stations::of(system);
        if !stations.have_shape() {
            return None;
        }
        let still = || vec![[C64::zero(); 2]; stations.all.len()];
        let modes = modes.iter().map(|m| if across(m) { scaled(stations.motion(&m.q)) } else { still() }).collect();
        Some(Shapes { stations, modes })
    }

    /// The table of all shapes; `Tiles::PLACE` and the like are columns of it.
    pub(super) fn table(&self) -> crate::outcome::TableBuilder {
        let motions: Vec<&[[C64; 2]]> = self.modes.iter().map(Vec::as_slice).collect();
        let rows = self.stations.all.len();
        let number = (0..motions.len()).flat_map(|k| std::iter::repeat_n(k as i64 + 1, rows)).collect();
        let doc = Message::new("shapes-table");
        self.stations.columns(Table::new("shapes", doc).int("mode", "", "number in order of frequency", number), &motions, "")
    }

    /// The figure of the lowest modes, by frequency. `along`: what they move along and about the axis. `grows`: modes that are unstable.
    pub(super) fn figure(
        &self,
        system: &System,
        modes: &[MachineMode],
        speed: f64,
        along: Option<&Along>,
        grows: impl Fn(&MachineMode) -> bool,
    ) -> Figure {
        let moves = |k: &usize| self.modes[*k].iter().any(|m| m[0] != C64::zero() || m[1] != C64::zero());
        let oscillates = |k: &usize| modes[*k].frequency() > 0.0 || grows(&modes[*k]);
        let all: Vec<usize> = (0..modes.len()).filter(oscillates).filter(moves).collect();
        let shown = lowest(modes, all.iter().copied(), speed, DRAWN, &grows);
        let pictures = shown.iter().map(|&k| picture(&modes[k], k, speed, grows(&modes[k]), along)).collect();
        let view = View::Shapes { horizontal: Stations::horizontal(system), to_scale: self.stations.to_scale };
        let mut notes = along.map_or_else(Vec::new, |a| a.notes(&shown));
        if all.len() > shown.len() {
            notes.push(Message::new("shapes-more").arg("modes", Arg::count(all.len() - shown.len())).into());
        }
        let mark = Message::new("tiles-instant").into();
        let tiles = Tiles { table: "shapes".into(), picture: "mode".into(), view, pictures, mark, notes };
        let alt = Message::new("shapes-alt").arg("modes", Arg::count(shown.len())).arg("speed", Arg::speed(speed));
        Figure::new("shapes", "Mode shapes", alt).tiles(tiles)
    }
}

/// The mode is none along or about the axis alone, whose motion across it is rounding.
pub(super) fn across(m: &MachineMode) -> bool {
    !matches!(m.whirl, Whirl::Axial | Whirl::Torsional)
}

fn picture(m: &MachineMode, k: usize, speed: f64, grows: bool, along: Option<&Along>) -> Picture {
    let mut lines = vec![Arg::frequency(m.frequency())];
    lines.push(Message::new("page-whirl").arg("whirl", Arg::word(m.whirl.at(speed).word())).into());
    lines.push(if grows {
        Message::new("page-grows").into()
    } else {
        Message::new("page-decrement").arg("decrement", Arg::number(-TAU * m.growth() / m.frequency())).into()
    });
    lines.extend(along.into_iter().flat_map(|a| a.lines(k)));
    let title = Message::new("page-mode").arg("number", Arg::count(k + 1)).into();
    Picture { number: k as i64 + 1, title, lines, circle: None, unstable: grows }
}

/// Motions over the largest semi-major axis, from the instant at which its point is farthest out, on the side of x above 0.
fn scaled(mut motion: Vec<[C64; 2]>) -> Vec<[C64; 2]> {
    let size = |m: &[C64; 2]| m[0].abs() + m[1].abs();
    let Some(largest) = motion.iter().copied().max_by(|a, b| size(a).total_cmp(&size(b))) else { return motion };
    let most = size(&largest);
    if !(most > 0.0 && most.is_finite()) {
        return vec![[C64::zero(); 2]; motion.len()];
    }
    let [f, b] = largest;
    // a circle is as far out at every instant: its point then starts on x
    let circle = f.abs().min(b.abs()) <= ROUNDING * most;
    let mut angle = match (circle, f.abs() > b.abs()) {
        (true, true) => -f.arg(),
        (true, false) => b.arg(),
        (false, _) => 0.5 * (b.arg() - f.arg()),
    };
    let out = f * C64::cis(angle) + b * C64::cis(-angle);
    if out.arg() > FRAC_PI_2 * (1.0 + ROUNDING) || out.arg() <= -FRAC_PI_2 * (1.0 - ROUNDING) {
        angle += PI;
    }
    for m in &mut motion {
        let [f, b] = [(m[0] * C64::cis(angle)).scale(1.0 / most), (m[1] * C64::cis(-angle)).scale(1.0 / most)];
        let still = |z: C64| if z.abs() <= ROUNDING { C64::zero() } else { z };
        *m = [still(f), still(b)];
    }
    motion
}
