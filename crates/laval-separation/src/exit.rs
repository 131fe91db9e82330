//! First exit of a particle: the time at which it reaches a surface of its vessel.
//!
//! Equations: the smallest root with outward crossing of the gaps (distances to the surfaces, positive inside). The gaps are sampled on a
//! grid that is geometric through the first transient and then even; a change of sign, or a minimum between two samples that dips below
//! zero, is bracketed and solved by Newton steps that stay inside.
//!
//! Validity: contact ends the motion; no sliding along a wall.
//!
//! Sources: `docs/theory/separation.md#first-exit`.

use super::closed::Path;
use laval_num::univariate::root_by_newton;
use serde::{Deserialize, Serialize};

/// Most surfaces of a vessel.
pub const MOST: usize = 4;

/// Where a particle left the liquid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Surface {
    /// The side of the cup, the wall of a bowl or the surface of a disc.
    Wall,
    /// The bottom of the cup.
    Bottom,
    /// The free surface of the liquid.
    Free,
}

impl Surface {
    /// The word in tables.
    pub fn word(self) -> &'static str {
        match self {
            Surface::Wall => "wall",
            Surface::Bottom => "bottom",
            Surface::Free => "surface",
        }
    }
}

/// A gap to a surface (any smooth measure of distance, positive inside) and its rate.
#[derive(Clone, Copy, Debug)]
pub struct Gap {
    /// Which surface.
    pub surface: Surface,
    /// The gap.
    pub value: f64,
    /// Its rate along the motion.
    pub rate: f64,
}

/// The surfaces around the liquid.
pub trait Vessel {
    /// Gaps at a position, with their rates at a velocity, in a fixed order.
    fn gaps(&self, position: [f64; 3], velocity: [f64; 3]) -> [Gap; MOST];
}

/// A cylinder along y with flat ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Inner radius r, m.
    pub radius: f64,
    /// Bottom y = L, m from the hinge.
    pub bottom: f64,
    /// Surface of the liquid, m from the hinge.
    pub top: f64,
}

impl Cylinder {
    /// The space open to the centre of a sphere of this radius.
    pub fn inset(&self, radius: f64) -> Self {
        Cylinder { radius: self.radius - radius, bottom: self.bottom - radius, top: self.top + radius }
    }
    /// Volume, m^3.
    pub fn volume(&self) -> f64 {
        std::f64::consts::PI * self.radius * self.radius * (self.bottom - self.top)
    }
}

impl Gap {
    /// In place of a surface that is not there.
    pub const NONE: Gap = Gap { surface: Surface::Free, value: 1.0, rate: 0.0 };
}

impl Vessel for Cylinder {
    #[inline]
    fn gaps(&self, [x, y, z]: [f64; 3], [vx, vy, vz]: [f64; 3]) -> [Gap; MOST] {
        [
            Gap { surface: Surface::Wall, value: self.radius * self.radius - x * x - z * z, rate: -2.0 * (x * vx + z * vz) },
            Gap { surface: Surface::Bottom, value: self.bottom - y, rate: -vy },
            Gap { surface: Surface::Free, value: y - self.top, rate: vy },
            Gap::NONE,
        ]
    }
}

/// The end of a particle's motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Exit {
    /// When, s.
    pub time: f64,
    /// Through which surface.
    pub surface: Surface,
    /// Where, in the cup's axes, m.
    pub position: [f64; 3],
    /// Velocity there, m/s.
    pub velocity: [f64; 3],
}

/// Even samples of one piece of the search.
const SAMPLES: f64 = 12.0;
/// Growth of the pieces of the search, and how many of them.
const GROWTH: f64 = 2.0;
const PIECES: usize = 60;
/// Most samples of one piece.
const MOST_SAMPLES: f64 = 20_000.0;

/// First exit along a path; `horizon` (s) is the length of the first piece searched, for instance the length of the vessel over the settling
/// velocity at the start. `None` when no surface is met within 2^60 times as long, or nothing moves.
pub fn first_exit(path: &impl Path, vessel: &impl Vessel, horizon: f64) -> Option<Exit> {
    // NaN and infinity: nothing moves
    if !(horizon > 0.0 && horizon < 1e300) {
        return None;
    }
    let pace = path.pace();
    let mut search = Search::start(path, vessel)?;
    let mut t = 0.1 / pace.transient;
    if t > 0.0 && t.is_finite() {
        while t < horizon / SAMPLES && t < 30.0 / pace.transient {
            if let Some(e) = search.to(t) {
                return Some(e);
            }
            t *= 3.0;
        }
    }
    let mut from = search.t;
    let mut to = horizon.max(2.0 * from);
    for _ in 0..PIECES {
        let samples = SAMPLES.max((to - from) * pace.lasting).min(MOST_SAMPLES);
        let step = (to - from) / samples;
        let mut k = 1.0;
        while k <= samples.ceil() {
            let t = if k >= samples { to } else { from + k * step };
            if let Some(e) = search.to(t) {
                return Some(e);
            }
            if search.lost {
                return None;
            }
            k += 1.0;
        }
        (from, to) = (to, GROWTH * to);
    }
    None
}

/// A gap below this share of the vessel is rounding: the particle is on the surface.
const ON_SURFACE: f64 = 1e-13;

struct Search<'a, P, V> {
    path: &'a P,
    vessel: &'a V,
    t: f64,
    gaps: [Gap; MOST],
    /// The particle was off this surface at the last sample. One that starts on a surface leaves it, or leaves through it.
    off: [bool; MOST],
    noise: f64,
    /// A gap left the range of numbers.
    lost: bool,
}

impl<'a, P: Path, V: Vessel> Search<'a, P, V> {
    fn start(path: &'a P, vessel: &'a V) -> Option<Self> {
        let (x, v) = path.at(0.0);
        let gaps = vessel.gaps(x, v);
        // NaN ends here
        if !gaps.iter().all(|g| g.value.is_finite()) {
            return None;
        }
        let real = gaps.iter().filter(|g| g.value != Gap::NONE.value || g.rate != 0.0);
        let noise = ON_SURFACE * real.map(|g| g.value.abs()).fold(0.0, f64::max);
        Some(Search { path, vessel, t: 0.0, gaps, off: gaps.map(|g| g.value > noise), noise, lost: false })
    }

    fn gap(&self, i: usize, t: f64) -> (f64, f64) {
        let (x, v) = self.path.at(t);
        let g = self.vessel.gaps(x, v)[i];
        (g.value, g.rate)
    }

    /// Goes on to `t`; the earliest exit on the way.
    fn to(&mut self, t: f64) -> Option<Exit> {
        let (x, v) = self.path.at(t);
        let next = self.vessel.gaps(x, v);
        let mut best: Option<(f64, usize)> = None;
        for (i, (a, b)) in self.gaps.iter().zip(&next).enumerate() {
            if b.value.is_nan() {
                self.lost = true;
                return None;
            }
            let found = if !self.off[i] {
                // started outside, or leaves through the surface it started on
                (b.value < -self.noise).then_some(self.t)
            } else if b.value < 0.0 {
                root_by_newton(|t| self.gap(i, t), self.t, t)
            } else if a.rate < 0.0 && b.rate > 0.0 {
                self.dip(i, t)
            } else {
                None
            };
            if let Some(found) = found
                && best.is_none_or(|b| found < b.0)
            {
                best = Some((found, i));
            }
        }
        let surface = best.map(|b| self.gaps[b.1].surface);
        for (off, g) in self.off.iter_mut().zip(&next) {
            *off |= g.value > self.noise;
        }
        (self.t, self.gaps) = (t, next);
        let (time, surface) = (best?.0, surface?);
        let (position, velocity) = self.path.at(time);
        Some(Exit { time, surface, position, velocity })
    }

    /// A gap that falls and rises between the samples: does it dip below zero?
    fn dip(&self, i: usize, t: f64) -> Option<f64> {
        let (mut a, mut b) = (self.t, t);
        for _ in 0..60 {
            let middle = 0.5 * (a + b);
            let (value, rate) = self.gap(i, middle);
            if value < 0.0 {
                return root_by_newton(|t| self.gap(i, t), self.t, middle);
            }
            if rate < 0.0 {
                a = middle
            } else {
                b = middle
            }
            if b - a < 1e-12 * b {
                break;
            }
        }
        None
    }
}
