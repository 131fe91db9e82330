//! A mode of the machine as results show it.

use super::characteristic::{coordinate_sectors, state_sectors};
use super::kinetic::Kinetic;
use super::sectors::{Sector, Sectors, circular};
use crate::model::part::DofKind;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::eig;
use serde::{Deserialize, Serialize};

/// An orbit is straight when the radii of its forward and backward parts agree within this share: neither direction leads. Its narrow axis is then
/// below a fortieth of its long one.
pub const FLAT: f64 = 0.05;

/// Direction a mode whirls in, or that it moves along or about the axis. Every body is compared with its own spin: on a shaft that turns against the machine forward
/// is against the machine. Where shafts of both directions move together, all are compared with the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Whirl {
    /// With the spin of what moves.
    Forward,
    /// Against it.
    Backward,
    /// Both, at different places or in a line that is straight within [`FLAT`].
    Mixed,
    /// Along the axis, but for a hundredth of its kinetic energy.
    Axial,
    /// About the axis, but for a hundredth of its kinetic energy.
    Torsional,
    /// No oscillation, or none of bodies.
    None,
}

impl Whirl {
    /// The word in tables.
    pub fn word(self) -> &'static str {
        match self {
            Whirl::Forward => "forward",
            Whirl::Backward => "backward",
            Whirl::Mixed => "mixed",
            Whirl::Axial => "axial",
            Whirl::Torsional => "torsional",
            Whirl::None => "none",
        }
    }
    /// It moves points across the axis.
    pub fn is_lateral(self) -> bool {
        matches!(self, Whirl::Forward | Whirl::Backward | Whirl::Mixed)
    }
    /// At a spin speed: at standstill there is nothing to whirl with or against.
    pub fn at(self, speed: f64) -> Whirl {
        if speed == 0.0 && self.is_lateral() { Whirl::None } else { self }
    }
    /// In a sentence, before or behind a noun: `forward whirl`; where neither direction leads with the forward share of the squared amplitudes.
    pub fn of(self, noun: &str, forward_share: f64) -> String {
        let straight = (1.0 + FLAT).powi(2) / (1.0 + (1.0 + FLAT).powi(2)) - 0.5;
        match self {
            Whirl::Mixed if (forward_share - 0.5).abs() <= straight => {
                format!("straight (mixed) {noun} with forward share {forward_share:.3}")
            }
            Whirl::Mixed => format!("mixed {noun} with forward share {forward_share:.3}"),
            Whirl::None => format!("{noun} of no direction"),
            Whirl::Axial | Whirl::Torsional => format!("{} vibration", self.word()),
            _ => format!("{} {noun}", self.word()),
        }
    }
}

/// A mode of the machine, with Im s >= 0; of a conjugate pair, this member stands for both.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MachineMode {
    /// s = growth + i frequency.
    pub value: C64,
    /// Coordinates, scaled so that the largest (over its typical size) is one and real.
    pub q: Vec<C64>,
    /// Internal states on the same scale.
    pub z: Vec<C64>,
    /// Sector, for a machine without preferred direction.
    pub sector: Option<Sector>,
    /// Direction of whirl.
    pub whirl: Whirl,
    /// Share of the forward part in the squared amplitudes.
    pub forward_share: f64,
    /// Backward error of the eigenvalue problem.
    pub residual: f64,
    /// Estimate of the error of the value, 1/s.
    pub error: f64,
    /// The value was solved for on the exact characteristic function.
    pub polished: bool,
    /// Where it stands among the families of its spectrum: family, mode.
    pub place: (usize, usize),
}

impl MachineMode {
    /// Of a rotor that nothing holds along or about the axis: it moves there as a whole, without force.
    pub fn is_free(&self) -> bool {
        matches!(self.whirl, Whirl::Axial | Whirl::Torsional) && self.value == C64::zero()
    }
    /// The same without its vectors, where many are kept.
    pub fn without_vectors(&self) -> Self {
        MachineMode { q: Vec::new(), z: Vec::new(), ..*self }
    }
    /// Growth rate, 1/s.
    pub fn growth(&self) -> f64 {
        self.value.re
    }
    /// Frequency, rad/s, not negative.
    pub fn frequency(&self) -> f64 {
        self.value.im
    }
    /// `-growth / |s|`.
    pub fn damping_ratio(&self) -> f64 {
        let size = self.value.abs();
        if size > 0.0 { -self.value.re / size } else { 0.0 }
    }
}

/// Coordinates and internal states that modes are made of.
#[derive(Clone, Debug)]
pub(super) struct Unknowns {
    pub coordinates: Sectors,
    pub states: Sectors,
    /// Typical sizes of the coordinates.
    typical: Vec<f64>,
    /// Those along the axis and those about it.
    pub along: [Vec<usize>; 2],
    /// Of each coordinate the speed of its part over that of the machine.
    pub ratios: Vec<f64>,
    /// Of a machine that moves along or about its axis.
    kinetic: Option<Kinetic>,
}

/// Share of the largest coordinate of a mode without mass, each over its typical size, below which the others do not count beside it.
const HARDLY: f64 = 1e-6;
/// Share of the kinetic energy from which on a mode is one along or about the axis: teeth in mesh couple torsion to a little whirl.
const ALONG: f64 = 0.99;

impl Unknowns {
    pub fn of(system: &System) -> Self {
        let along: [Vec<usize>; 2] =
            [DofKind::Axial, DofKind::Twist].map(|kind| (0..system.n()).filter(|&i| system.coordinates()[i].dof.kind == kind).collect());
        Unknowns {
            kinetic: along.iter().any(|k| !k.is_empty()).then(|| Kinetic::of(system, None)),
            coordinates: coordinate_sectors(system),
            states: state_sectors(system, &(0..system.m()).collect::<Vec<_>>()),
            typical: system.coordinates().iter().map(|c| c.dof.typical).collect(),
            ratios: system.coordinates().iter().map(|c| system.slots()[c.slot].speed(system.params(), 1.0)).collect(),
            along,
        }
    }

    /// Gives a mode the value and the null vector (over the unknowns of the characteristic matrix, in sector coordinates) of an exact root; memory states
    /// keep those of the pencil.
    pub fn reshape(&self, mode: &mut MachineMode, value: C64, right: &[C64]) {
        let mut q = right[..self.coordinates.len()].to_vec();
        self.coordinates.restore(&mut q);
        mode.value = value;
        if value.im < 0.0 {
            mode.value = value.conj();
            q.iter_mut().for_each(|x| *x = x.conj());
            mode.sector = match mode.sector {
                Some(Sector::Forward) => Some(Sector::Backward),
                Some(Sector::Backward) => Some(Sector::Forward),
                other => other,
            };
        }
        if let Some(lead) = self.lead(&q) {
            q.iter_mut().for_each(|x| *x = *x / lead);
        }
        (mode.whirl, mode.forward_share) = self.whirl(mode.value, &q);
        mode.q = q;
    }

    /// What the largest coordinate over its typical size is divided by to become one and real.
    fn lead(&self, q: &[C64]) -> Option<C64> {
        let size = |(x, t): (&C64, &f64)| x.abs() / t;
        let lead = q.iter().zip(&self.typical).map(size).fold(0.0, f64::max);
        let lead = q.iter().zip(&self.typical).find(|&p| size(p) >= lead * (1.0 - 1e-8)).map(|(x, t)| x.scale(1.0 / t));
        lead.filter(|l| l.abs() > 0.0)
    }

    /// A mode in x and y with Im s >= 0 from the vector (q, v, z) of a block.
    pub fn mode(&self, m: &eig::Mode, sector: Option<Sector>, q: &[usize], z: &[usize]) -> MachineMode {
        let (mut qs, mut zs) = (vec![C64::zero(); self.coordinates.len()], vec![C64::zero(); self.states.len()]);
        q.iter().zip(&m.right).for_each(|(&i, &x)| qs[i] = x);
        z.iter().zip(&m.right[2 * q.len()..]).for_each(|(&i, &x)| zs[i] = x);
        if sector.is_some() {
            self.coordinates.restore(&mut qs);
            self.states.restore(&mut zs);
        }
        let (mut value, mut sector) = (m.value, sector);
        if value.im < 0.0 {
            value = value.conj();
            qs.iter_mut().chain(&mut zs).for_each(|x| *x = x.conj());
            if sector == Some(Sector::Forward) {
                sector = Some(Sector::Backward);
            }
        }
        if let Some(lead) = self.lead(&qs) {
            qs.iter_mut().chain(&mut zs).for_each(|x| *x = *x / lead);
        }
        let (whirl, forward_share) = self.whirl(value, &qs);
        MachineMode {
            value,
            q: qs,
            z: zs,
            sector,
            whirl,
            forward_share,
            residual: m.residual,
            error: m.error(),
            polished: false,
            place: (0, 0),
        }
    }

    /// Forward and backward radii of every pair over its typical size: of its own spin, or of that of the machine.
    fn circles(&self, q: &[C64], own: bool) -> Vec<(f64, f64)> {
        let one = |i: usize| {
            let (f, b) = circular(q[i], q[i + 1]);
            let [f, b] = [f, b].map(|x| x.abs() / self.typical[i]);
            if own && self.ratios[i] < 0.0 { (b, f) } else { (f, b) }
        };
        self.coordinates.pairs().into_iter().map(one).collect()
    }

    fn whirl(&self, value: C64, q: &[C64]) -> (Whirl, f64) {
        let own = self.circles(q, true);
        let largest = own.iter().map(|c| c.0 + c.1).fold(0.0, f64::max);
        let [axial, torsional] = [0, 1].map(|k| self.along[k].iter().map(|&i| q[i].abs() / self.typical[i]).fold(0.0, f64::max));
        if axial.max(torsional) > 0.0 {
            let shares = self.kinetic.as_ref().and_then(|k| k.shares(&self.along, q));
            let (is_along, [axial, torsional]) = match shares {
                Some(shares) => (shares[0] + shares[1] >= ALONG, shares),
                None => (largest <= HARDLY * axial.max(torsional), [axial, torsional]),
            };
            if is_along {
                return (if axial > torsional { Whirl::Axial } else { Whirl::Torsional }, 0.5);
            }
        }
        if value.im == 0.0 || largest < 1e-12 {
            return (Whirl::None, 0.5);
        }
        // shafts of both directions that move together: the direction is that of the machine
        match named(&own) {
            (Whirl::Mixed, share) if self.ratios.iter().any(|r| *r < 0.0) => {
                let machine = named(&self.circles(q, false));
                if machine.0 == Whirl::Mixed { (Whirl::Mixed, share) } else { machine }
            }
            found => found,
        }
    }
}

/// The direction of circles, and the share of the forward part in their squared radii.
fn named(circles: &[(f64, f64)]) -> (Whirl, f64) {
    let (f2, b2) = circles.iter().fold((0.0, 0.0), |(f, b), c| (f + c.0 * c.0, b + c.1 * c.1));
    let largest = circles.iter().map(|c| c.0 + c.1).fold(0.0, f64::max);
    // bodies that hardly move do not decide
    let mut moving = circles.iter().filter(|c| c.0 + c.1 > 1e-3 * largest);
    let whirl = if moving.clone().all(|c| c.0 > c.1 * (1.0 + FLAT)) {
        Whirl::Forward
    } else if moving.all(|c| c.1 > c.0 * (1.0 + FLAT)) {
        Whirl::Backward
    } else {
        Whirl::Mixed
    };
    (whirl, f2 / (f2 + b2))
}
