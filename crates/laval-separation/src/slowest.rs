//! Particle of a suspension that leaves last: the time in which all are captured.
//!
//! Equations: the remaining time decreases along a path, so that the longest one belongs to a point where
//! paths begin, on the border of the liquid. In bowls, disc stacks and decanters that is the surface (for
//! light particles the wall). In cups and tubes exit times on a grid over surface, bottom and side are
//! compared, and the largest ones are increased by a search with halved steps, which gives the time to about
//! a millionth.
//!
//! Validity: particles released at rest; inertia moves the place of the longest time by w/n, the time by less.
//!
//! Sources: `docs/theory/separation.md#ensembles-and-recovery`.

use super::batch::Spinning;
use super::exit::Cylinder;
use super::halton::Point;
use super::law::Law;
use super::motion::Lost;
use super::particle::Particle;
use super::suspension::Member;
use super::tube::Filled;
use super::vessel::Inside;
use laval_model::text;
use laval_num::order::SortByNumber;
use laval_num::work::Here;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// The last particle to leave.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Last {
    /// When, s; infinite when it never leaves.
    pub time: f64,
    /// Where it starts, in the axes of the cup, m.
    pub start: [f64; 3],
}

/// Share of the vessel by which starts lie inside its surfaces, so that none counts as outside by rounding.
const INSIDE: f64 = 1e-9;
/// Places along and around each sheet of the border, sheets, and how many of the largest times are followed.
const ALONG: usize = 7;
const AROUND: usize = 16;
const SHEETS: usize = 3;
const FOLLOWED: usize = 4;
/// Halvings of the steps.
const HALVINGS: usize = 26;

/// A place of the border: sheet (surface, bottom, side), share along it and around the axis.
type Site = (usize, f64, f64);

fn in_cup(v: &Cylinder, (sheet, along, around): Site) -> [f64; 3] {
    let (sin, cos) = (TAU * around).sin_cos();
    let length = v.bottom - v.top;
    let (share, y) = match sheet {
        0 => (along, v.top + INSIDE * length),
        1 => (along, v.bottom - INSIDE * length),
        _ => (1.0, v.top + length * along.clamp(INSIDE, 1.0 - INSIDE)),
    };
    let rho = v.radius * share.min(1.0 - INSIDE);
    [rho * cos, y, rho * sin]
}

fn in_tube(f: &Filled, (sheet, along, around): Site) -> Option<[f64; 3]> {
    let t = f.tube();
    let (sin, cos) = (TAU * around).sin_cos();
    let rho = t.radius * if sheet == 2 { 1.0 } else { along }.min(1.0 - INSIDE);
    let (x, z) = (rho * cos, rho * sin);
    let top = f.surface_at(x, z).clamp(0.0, t.length);
    let y = match sheet {
        0 => top + INSIDE * t.length,
        1 => t.length * (1.0 - INSIDE),
        _ => top + (t.length - top) * along.clamp(INSIDE, 1.0 - INSIDE),
    };
    f.holds([x, y, z]).then_some([x, y, z])
}

impl Spinning<'_> {
    /// When the last of the particles that count leaves, from wherever in the liquid; infinite when some never do. `None` where all start at one place: that is an order
    /// statistic like any other.
    ///
    /// # Errors
    /// When an integration fails.
    pub fn last(&self) -> Result<Option<Last>, Lost> {
        let b = self.batch;
        if b.slowest || self.crowd.is_empty() {
            return Ok(None);
        }
        let least = smallest(&b.powder.size, b.from);
        let mut found = Last { time: 0.0, start: self.crowd[0].start };
        for density in nearest(&b.powder.density, b.medium.density) {
            let p = Particle { radius: 0.5 * least, density };
            let last =
                if p.radius > 0.0 && density != b.medium.density { self.last_of(&p)? } else { Last { time: f64::INFINITY, ..found } };
            if !(last.time <= found.time) {
                found = last;
            }
        }
        Ok(Some(found))
    }

    /// The longest time of one particle, over its starts.
    fn last_of(&self, particle: &Particle) -> Result<Last, Lost> {
        let heavy = particle.density > self.batch.medium.density;
        let time = |start: [f64; 3]| -> Result<f64, Lost> {
            let point = Point { along: 0.0, area: 0.0, turn: 0.0, size: 0.0, density: 0.0 };
            Ok(self.exit(particle, &Member { point, start })?.map_or(f64::INFINITY, |e| e.time))
        };
        let place = |site: Site| match self.turning.inside() {
            Some(Inside::Cup(v)) => Some(in_cup(v, site)),
            Some(Inside::Tube(f)) => in_tube(f, site),
            _ => None,
        };
        if matches!(self.turning.inside(), None | Some(Inside::Ring(..))) {
            let start = self.turning.slowest(heavy);
            return Ok(Last { time: time(start)?, start });
        }
        // NaN never is the largest
        let at = |site: Site| place(site).map_or(Ok(f64::NEG_INFINITY), &time);
        let grid: Vec<Site> = (0..SHEETS)
            .flat_map(|s| (0..ALONG).flat_map(move |i| (0..AROUND).map(move |k| (s, i, k))))
            .map(|(s, i, k)| (s, i as f64 / (ALONG - 1) as f64, k as f64 / AROUND as f64))
            .collect();
        let here = Here::now();
        let counted = |s| {
            let _counted = here.enter();
            at(s)
        };
        let times: Vec<f64> = grid.par_iter().map(|&s| counted(s)).collect::<Result<_, _>>()?;
        let mut best: Vec<(f64, Site)> = times.into_iter().zip(grid).collect();
        best.sort_by_number_down(|a| a.0);
        best.truncate(FOLLOWED);
        let climbed: Vec<(f64, Site)> = best.into_par_iter().map(|from| climb(from, &counted)).collect::<Result<_, _>>()?;
        let top = climbed.into_iter().reduce(|a, b| if b.0 > a.0 { b } else { a });
        match top.and_then(|(time, site)| Some(Last { time, start: place(site)? })) {
            Some(last) => Ok(last),
            None => Err(Lost(text!("no place of the liquid is found where a path begins"))),
        }
    }
}

/// Uphill on one sheet: the best of four neighbours, or half the step.
fn climb((mut time, mut site): (f64, Site), at: &impl Fn(Site) -> Result<f64, Lost>) -> Result<(f64, Site), Lost> {
    let (mut along, mut around) = (0.5 / (ALONG - 1) as f64, 0.5 / AROUND as f64);
    for _ in 0..HALVINGS {
        let mut better = true;
        // a hill is no longer than the sheet
        for _ in 0..8 {
            if !better || time == f64::INFINITY {
                break;
            }
            better = false;
            let (sheet, u, v) = site;
            for (du, dv) in [(along, 0.0), (-along, 0.0), (0.0, around), (0.0, -around)] {
                let next = (sheet, (u + du).clamp(0.0, 1.0), v + dv);
                let t = at(next)?;
                if t > time {
                    (time, site, better) = (t, next, true);
                }
            }
        }
        along *= 0.5;
        around *= 0.5;
    }
    Ok((time, site))
}

/// Diameter of the smallest particle that counts, m; 0 where a law has no smallest.
fn smallest(size: &Law, from: Option<f64>) -> f64 {
    let from = from.unwrap_or(0.0);
    let own = match size {
        Law::Single(d) => *d,
        // classes that are too small do not count
        Law::Classes(all) => all.iter().filter(|c| c.1 > 0.0 && c.0 >= from).map(|c| c.0).next().unwrap_or(from),
        Law::Cumulative(points) => points.iter().rev().find(|p| p.1 <= 0.0).or(points.first()).map_or(0.0, |p| p.0),
        Law::LogNormal { .. } | Law::RosinRammler { .. } => 0.0,
    };
    own.max(from)
}

/// Densities among which the last particle has one, kg/m^3: that of the liquid where the law passes it.
fn nearest(density: &Law, liquid: f64) -> Vec<f64> {
    match density {
        Law::Single(rho) => vec![*rho],
        Law::Classes(all) => all.iter().filter(|c| c.1 > 0.0).map(|c| c.0).collect(),
        Law::Cumulative(points) => match (points.first(), points.last()) {
            (Some(a), Some(b)) if a.0 <= liquid && liquid <= b.0 => vec![liquid],
            (Some(a), Some(b)) => vec![if a.0 > liquid { a.0 } else { b.0 }],
            _ => vec![],
        },
        Law::LogNormal { .. } | Law::RosinRammler { .. } => vec![liquid],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_that_counts() {
        let classes = Law::classes(&[1.0, 2.0, 5.0], &[0.0, 2.0, 1.0]).unwrap();
        let table = Law::cumulative(&[1.0, 3.0, 10.0], &[0.0, 0.2, 1.0]).unwrap();
        let above = Law::cumulative(&[2.0, 3.0], &[0.1, 1.0]).unwrap();
        for (law, from, want) in [
            (&Law::Single(4.0), None, 4.0),
            (&Law::Single(4.0), Some(5.0), 5.0),
            (&classes, None, 2.0),
            (&classes, Some(3.0), 5.0),
            (&table, None, 1.0),
            (&table, Some(2.5), 2.5),
            (&above, None, 2.0),
            (&Law::RosinRammler { characteristic: 3.0, spread: 1.0 }, None, 0.0),
            (&Law::LogNormal { median: 3.0, gsd: 2.0 }, Some(0.5), 0.5),
        ] {
            assert_eq!(smallest(law, from), want, "{law:?} {from:?}");
        }
    }

    #[test]
    fn densities_that_pass_the_liquid_never_all_leave() {
        assert_eq!(nearest(&Law::Single(2650.0), 1000.0), [2650.0]);
        assert_eq!(nearest(&Law::classes(&[900.0, 1100.0], &[1.0, 1.0]).unwrap(), 1000.0), [900.0, 1100.0]);
        assert_eq!(nearest(&Law::cumulative(&[900.0, 1100.0], &[0.0, 1.0]).unwrap(), 1000.0), [1000.0]);
        assert_eq!(nearest(&Law::cumulative(&[1200.0, 1300.0], &[0.0, 1.0]).unwrap(), 1000.0), [1200.0]);
        assert_eq!(nearest(&Law::LogNormal { median: 2650.0, gsd: 1.1 }, 1000.0), [1000.0]);
    }
}
