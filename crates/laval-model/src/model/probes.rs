//! The probes of a machine.

use super::field::Attach;
use super::probe::{Probe, Sight, distinct_digits, same_height};
use super::station::{Pair, attached};
use super::system::System;
use laval_num::order::ascending;

impl System {
    /// All that is measured of the bodies' motion, by [station](super::station::Station): its displacement; of a rigid body also the points where parts are
    /// attached or that a block names, where their displacement differs from it, and the tilt.
    pub fn probes(&self) -> &[Probe] {
        self.probes.get_or_init(|| all(self))
    }
}

fn all(system: &System) -> Vec<Probe> {
    let mut out = Vec::new();
    for (k, station) in system.stations().iter().enumerate() {
        let name = &system.slots()[station.slot].name;
        let probe = |sight, digits, rows| Probe { station: k, name: name.clone(), sight, digits, flexible: station.flexible, rows };
        if station.flexible {
            out.push(probe(Sight::Displacement(station.position), station.digits, station.lateral.clone()));
            continue;
        }
        let named = system.machine.points.iter().filter(|p| &p.0 == name).map(|p| p.1);
        let mut heights: Vec<f64> = attached(system, name, true).chain(named).filter(|z| *z != 0.0).collect();
        ascending(&mut heights);
        heights.dedup_by(|a, b| same_height(*a, *b));
        let digits = distinct_digits(&heights);
        out.push(probe(Sight::Displacement(0.0), digits, station.lateral.clone()));
        for z in heights {
            if let Ok([x, y, ..]) = system.point_rows(station.slot, &Attach::at(name.clone(), z))
                && [&x, &y] != [&station.lateral.0[0], &station.lateral.0[1]]
            {
                out.push(probe(Sight::Displacement(z), digits, Pair([x, y])));
            }
        }
        if let Some(tilt) = &station.tilt {
            out.push(probe(Sight::Tilt, digits, tilt.clone()));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::builder::Builder;
    use crate::model::part::Link;
    use crate::parts::{bearing_cubic::*, disc::*};

    /// A tilt moves the points above and below the reference point to opposite sides, and not the point itself.
    #[test]
    fn points_tilt_and_reference() {
        let spring = |z: f64| BearingCubic::isotropic(Link::Between(Attach::at("d", z), Attach::ground()));
        let law = BearingCubicParams { stiffness: [1e3; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 };
        let disc = |diametral: f64| DiscParams { diametral_inertia: diametral, polar_inertia: 0.01, ..DiscParams::new(1.0) };
        let build = |b: Builder| {
            let b = b.part("upper", spring(0.1), law).part("other", spring(0.1), law).part("lower", spring(-0.2), law);
            b.part("middle", spring(0.0), law).build().unwrap_or_else(|d| panic!("{d:?}"))
        };
        let tilting = build(Builder::new("t").part("d", Disc::tilting(), disc(0.01)));
        let sights: Vec<Sight> = tilting.probes().iter().map(|p| p.sight).collect();
        let at = Sight::Displacement;
        assert_eq!(sights, [at(0.0), at(-0.2), at(0.1), Sight::Tilt]);
        let q = [0.5, 0.25, 2.0, 3.0];
        let seen: Vec<[f64; 2]> = tilting.probes().iter().map(|p| p.of(&q)).collect();
        // x + z beta, y - z alpha
        assert_eq!(seen, [[0.5, 0.25], [0.5 - 0.2 * 3.0, 0.25 + 0.2 * 2.0], [0.5 + 0.1 * 3.0, 0.25 - 0.1 * 2.0], [2.0, 3.0]]);
        // of a planar disc all points move alike
        assert_eq!(build(Builder::new("p").part("d", Disc::planar(), disc(0.0))).probes().len(), 1);
    }
}
