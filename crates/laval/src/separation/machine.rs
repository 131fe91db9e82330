//! The machines that separate: swinging cups, fixed-angle tubes, tubular bowls, disc stacks, decanters, each with where particles start and when they are
//! caught.
//!
//! Equations: cups and tubes as in [`super::closed`]; a tubular bowl is the same motion in the field of the radius alone, between surface r1 and bowl r2, while
//! the liquid flows through in plug flow. In a disc stack a particle that enters at the share f of a gap is caught when the residence time reaches
//! `f Vol/(|s| g Sigma)`, whatever the profile of the flow. A decanter separates like a tubular bowl of the same Sigma (half capture).
//!
//! A machine that flows through takes the residence time `Vol/Q` for the time of a cup.
//!
//! Symbols: as in [`super::measures`].
//!
//! Validity: as those; in flow machines gravity, entrance and re-entrainment are left out.
//!
//! Sources: `theory/separation.md` sections 4 to 10.

use super::closed::{Closed, Drifting, Steady};
use super::cup::SwingingCup;
use super::exit::{Cylinder, Exit, Gap, MOST, Surface, Vessel, first_exit};
use super::halton::Point;
use super::measures::{self, Cone, Sigma};
use super::particle::Rates;
use super::tube::{Filled, Tube};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A swinging cup and the inside of it; the hinge is the origin of its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cup {
    /// How it hangs.
    pub hanging: SwingingCup,
    /// Its inside.
    pub vessel: Cylinder,
    /// A tilt it is held at, rad, instead of the one it swings out to.
    pub held: Option<f64>,
}

/// A tubular bowl.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bowl {
    /// Length of the liquid, m.
    pub length: f64,
    /// Radius of the bowl r2, m.
    pub radius: f64,
    /// Radius of the liquid's surface r1, m.
    pub surface: f64,
}

/// A stack of conical discs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Discs {
    /// Inner radius r1, m.
    pub inner: f64,
    /// Outer radius r2, m.
    pub outer: f64,
    /// Angle between disc and axis, rad.
    pub angle: f64,
    /// Number of gaps N.
    pub gaps: f64,
    /// Width of a gap across the discs, m.
    pub spacing: f64,
}

/// A decanter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decanter {
    /// Length of the cylinder L1, m.
    pub cylinder: f64,
    /// Length of the wetted cone L2, m.
    pub cone: f64,
    /// Radius of the bowl r2, m.
    pub radius: f64,
    /// Radius of the liquid's surface r1, m.
    pub surface: f64,
    /// How the cone counts.
    pub rule: Cone,
}

/// A machine that separates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Separator {
    /// Swinging cups.
    Cup(Cup),
    /// Fixed-angle tubes.
    Tube(Tube, f64),
    /// Tubular bowl.
    Bowl(Bowl),
    /// Disc stack.
    Discs(Discs),
    /// Decanter.
    Decanter(Decanter),
}

/// A separator at one speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning {
    /// Spin speed, rad/s.
    pub speed: f64,
    space: Space,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Space {
    Cup(Steady, Cylinder),
    Tube(Filled),
    /// Between the surface and the bowl; with the residence volume.
    Ring(f64, f64),
    Decanter(f64, f64),
    /// Volume of the gaps and w^2-free Sigma times g.
    Discs(Discs),
}

impl Vessel for (f64, f64) {
    #[inline]
    fn gaps(&self, [_, y, z]: [f64; 3], [_, vy, vz]: [f64; 3]) -> [Gap; MOST] {
        let (r2, rate) = (y * y + z * z, 2.0 * (y * vy + z * vz));
        [
            Gap { surface: Surface::Wall, value: self.1 * self.1 - r2, rate: -rate },
            Gap { surface: Surface::Free, value: r2 - self.0 * self.0, rate },
            Gap::NONE,
            Gap::NONE,
        ]
    }
}

/// A ring of liquid: its axes are those of a tube at 90 degrees from the axis of spin.
fn ring(speed: f64) -> Steady {
    Steady { speed, tilt: FRAC_PI_2, hinge: 0.0, gravity: 0.0 }
}

impl Separator {
    /// The separator at a speed (rad/s).
    pub fn at(&self, speed: f64) -> Turning {
        let space = match self {
            Separator::Cup(c) => {
                let tilt = c.held.unwrap_or_else(|| c.hanging.equilibrium(speed));
                Space::Cup(Steady { speed, tilt, hinge: c.hanging.hinge, gravity: c.hanging.gravity }, c.vessel)
            }
            Separator::Tube(t, gravity) => Space::Tube(t.at(speed, *gravity)),
            Separator::Bowl(b) => Space::Ring(b.surface, b.radius),
            Separator::Discs(d) => Space::Discs(*d),
            Separator::Decanter(d) => Space::Decanter(d.surface, d.radius),
        };
        Turning { speed, space }
    }

    /// Sigma of a machine that flows through.
    pub fn sigma(&self, speed: f64, gravity: f64) -> Option<Sigma> {
        match self {
            Separator::Bowl(b) => Some(measures::tubular_half(speed, b.length, b.surface, b.radius, gravity)),
            Separator::Discs(d) => Some(measures::disc_stack(speed, d.gaps, d.inner, d.outer, d.angle, gravity)),
            Separator::Decanter(d) => Some(measures::decanter(speed, d.cylinder, d.cone, d.surface, d.radius, d.rule, gravity)),
            Separator::Cup(_) | Separator::Tube(..) => None,
        }
    }

    /// Volume that flow passes through, m^3, for the residence time; of a decanter that of the tubular bowl of equal Sigma.
    pub fn flow_volume(&self) -> Option<f64> {
        let area = |r1: f64, r2: f64| PI * (r2 * r2 - r1 * r1);
        match self {
            Separator::Bowl(b) => Some(area(b.surface, b.radius) * b.length),
            Separator::Discs(d) => Some(area(d.inner, d.outer) / d.angle.sin() * d.spacing * d.gaps),
            Separator::Decanter(d) => {
                let own = measures::decanter(1.0, d.cylinder, d.cone, d.surface, d.radius, d.rule, 1.0).area;
                let per_length = measures::tubular_half(1.0, 1.0, d.surface, d.radius, 1.0).area;
                Some(area(d.surface, d.radius) * own / per_length)
            }
            Separator::Cup(_) | Separator::Tube(..) => None,
        }
    }

    /// The word in the file.
    pub fn word(&self) -> &'static str {
        match self {
            Separator::Cup(_) => "swinging",
            Separator::Tube(..) => "fixed_angle",
            Separator::Bowl(_) => "tubular_bowl",
            Separator::Discs(_) => "disc_stack",
            Separator::Decanter(_) => "decanter",
        }
    }
}

impl Turning {
    /// Where particles move, for machines with a path in space.
    pub fn steady(&self) -> Option<Steady> {
        match &self.space {
            Space::Cup(steady, _) => Some(*steady),
            Space::Tube(f) => Some(f.steady()),
            Space::Ring(..) => Some(ring(self.speed)),
            Space::Discs(_) | Space::Decanter(..) => None,
        }
    }

    /// Tilt of a cup or tube, rad.
    pub fn tilt(&self) -> Option<f64> {
        match &self.space {
            Space::Cup(steady, _) => Some(steady.tilt),
            Space::Tube(f) => Some(f.steady().tilt),
            _ => None,
        }
    }

    /// The liquid of a fixed-angle tube.
    pub fn filled(&self) -> Option<&Filled> {
        match &self.space {
            Space::Tube(f) => Some(f),
            _ => None,
        }
    }

    /// Radii between which the particles settle: surface and bottom on the axis of a cup, innermost and outermost liquid elsewhere, m.
    pub fn radii(&self) -> (f64, f64) {
        match &self.space {
            Space::Cup(s, v) => (s.radius([0.0, v.top, 0.0]), s.radius([0.0, v.bottom, 0.0])),
            Space::Tube(f) => f.radii(),
            Space::Ring(a, b) | Space::Decanter(a, b) => (*a, *b),
            Space::Discs(d) => (d.inner, d.outer),
        }
    }

    /// A start spread evenly over the liquid (over the flow, where it flows through); `None` for a point that falls outside.
    pub fn start(&self, p: &Point) -> Option<[f64; 3]> {
        let place = |radius: f64, from: f64, to: f64| {
            let (rho, turn) = (radius * p.area.sqrt(), TAU * p.turn);
            [rho * turn.cos(), from + (to - from) * p.along, rho * turn.sin()]
        };
        match &self.space {
            Space::Cup(_, v) => Some(place(v.radius, v.top, v.bottom)),
            Space::Tube(f) => {
                let t = f.tube();
                let r = place(t.radius, 0.0, t.length);
                f.holds(r).then_some(r)
            }
            Space::Ring(a, b) | Space::Decanter(a, b) => Some([0.0, (a * a + (b * b - a * a) * p.along).sqrt(), 0.0]),
            Space::Discs(_) => Some([0.0, p.along, 0.0]),
        }
    }

    /// The start of the particle that takes longest on the axis: at the surface for heavy ones, at the bottom for light ones.
    pub fn slowest(&self, heavy: bool) -> [f64; 3] {
        let pick = |inner: f64, outer: f64| if heavy { inner } else { outer };
        let y = match &self.space {
            Space::Cup(_, v) => pick(v.top, v.bottom),
            Space::Tube(f) => pick(f.axis_surface(), f.tube().length),
            Space::Ring(a, b) | Space::Decanter(a, b) => pick(*a, *b),
            Space::Discs(_) => 1.0,
        };
        [0.0, y, 0.0]
    }

    /// First exit of a particle released at rest, with its inertia where the machine has a path in space.
    pub fn settle(&self, rates: &Rates, start: [f64; 3]) -> Option<Exit> {
        let steady = match self.steady() {
            Some(s) if s.speed != 0.0 || s.gravity != 0.0 => s,
            _ => return self.drift(rates.sedimentation, start),
        };
        let path = Closed::new(rates, &steady, start, [0.0; 3]);
        self.first(&path, rates.sedimentation, &steady, start)
    }

    /// First exit of a particle without inertia; `sedimentation` in s (with 1 s the time is the product of both).
    pub fn drift(&self, sedimentation: f64, start: [f64; 3]) -> Option<Exit> {
        let rate = sedimentation * self.speed * self.speed;
        match &self.space {
            Space::Decanter(r1, r2) => {
                let r0 = start[1];
                let (to, surface) = if rate > 0.0 { (*r2, Surface::Wall) } else { (*r1, Surface::Free) };
                let time = (to / r0).ln() / rate;
                (time >= 0.0 && time.is_finite()).then_some(Exit {
                    time,
                    surface,
                    position: [0.0, to, 0.0],
                    velocity: [0.0, rate * to, 0.0],
                })
            }
            Space::Discs(d) => {
                let lifted = measures::disc_stack(self.speed, d.gaps, d.inner, d.outer, d.angle, 1.0).throughput(sedimentation, 1.0);
                let time = start[1] * Separator::Discs(*d).flow_volume()? / lifted;
                time.is_finite().then_some(Exit { time, surface: Surface::Wall, position: [0.0, d.inner, 0.0], velocity: [0.0; 3] })
            }
            _ => {
                let steady = self.steady()?;
                self.first(&Drifting::new(sedimentation, &steady, start), sedimentation, &steady, start)
            }
        }
    }

    fn first(&self, path: &impl super::closed::Path, sedimentation: f64, steady: &Steady, start: [f64; 3]) -> Option<Exit> {
        let field = (steady.speed * steady.speed * steady.radius(start)).hypot(steady.gravity);
        let settling = sedimentation.abs() * field;
        match &self.space {
            Space::Cup(_, v) => first_exit(path, v, 1.05 * (v.bottom - v.top).max(v.radius) / settling),
            Space::Tube(f) => first_exit(path, f, f.tube().radius / settling),
            Space::Ring(a, b) => first_exit(path, &(*a, *b), (b - a) / settling),
            Space::Discs(_) | Space::Decanter(..) => None,
        }
    }
}
