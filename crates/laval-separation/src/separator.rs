//! Separating machines: swinging cups, fixed-angle tubes, tubular bowls, disc stacks, decanters, with the
//! initial positions of particles and the condition of their capture.
//!
//! Equations: cups and tubes as in [`super::closed`]; a tubular bowl is the same motion in the field of the radius alone, between surface r1 and bowl r2, while
//! the liquid flows through in plug flow. In a disc stack a particle that enters at the share f of a gap is caught when the residence time reaches
//! `f Vol/(|s| g Sigma)`, whatever the profile of the flow. A decanter separates like a tubular bowl of the same Sigma (half capture).
//!
//! In machines with throughput the residence time `Vol/Q` takes the place of the time of a cup.
//!
//! Symbols: as in [`super::measures`].
//!
//! Validity: as those; in flow machines gravity, entrance and re-entrainment are left out.
//!
//! Sources: `docs/theory/separation.md#machines`, `docs/theory/separation.md#engineering-measures`.

use super::closed::{Closed, Drifting, Steady};
use super::cup::SwingingCup;
use super::exit::{Cylinder, Exit, Surface, first_exit};
use super::halton::Point;
use super::measures::{self, Cone, Sigma};
use super::particle::Rates;
use super::tube::{Filled, Tube};
use super::vessel::Inside;
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
    /// Where particles move along a path.
    Path(Steady, Inside),
    Decanter(f64, f64),
    Discs(Discs),
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
                Space::Path(Steady { speed, tilt, hinge: c.hanging.hinge, gravity: c.hanging.gravity }, c.vessel.into())
            }
            Separator::Tube(t, gravity) => {
                let filled = t.at(speed, *gravity);
                Space::Path(filled.steady(), Inside::Tube(filled))
            }
            Separator::Bowl(b) => Space::Path(ring(speed), Inside::Ring(b.surface, b.radius)),
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

    /// Width of the space that particles settle across, m.
    pub fn width(&self) -> f64 {
        match self {
            Separator::Cup(c) => 2.0 * c.vessel.radius,
            Separator::Tube(t, _) => 2.0 * t.radius,
            Separator::Bowl(b) => b.radius - b.surface,
            Separator::Discs(d) => d.spacing,
            Separator::Decanter(d) => d.radius - d.surface,
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
            Space::Path(steady, _) => Some(*steady),
            Space::Discs(_) | Space::Decanter(..) => None,
        }
    }

    /// The liquid particles move in, for machines with a path in space.
    pub fn inside(&self) -> Option<&Inside> {
        match &self.space {
            Space::Path(_, inside) => Some(inside),
            Space::Discs(_) | Space::Decanter(..) => None,
        }
    }

    /// Tilt of a cup or tube, rad.
    pub fn tilt(&self) -> Option<f64> {
        match &self.space {
            Space::Path(_, Inside::Ring(..)) => None,
            Space::Path(steady, _) => Some(steady.tilt),
            _ => None,
        }
    }

    /// The liquid of a fixed-angle tube.
    pub fn filled(&self) -> Option<&Filled> {
        match &self.space {
            Space::Path(_, Inside::Tube(f)) => Some(f),
            _ => None,
        }
    }

    /// Radii between which the particles settle: surface and bottom on the axis of a cup, innermost and outermost liquid elsewhere, m.
    pub fn radii(&self) -> (f64, f64) {
        match &self.space {
            Space::Path(s, Inside::Cup(v)) => (s.radius([0.0, v.top, 0.0]), s.radius([0.0, v.bottom, 0.0])),
            Space::Path(_, Inside::Tube(f)) => f.radii(),
            Space::Path(_, Inside::Ring(a, b)) | Space::Decanter(a, b) => (*a, *b),
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
            Space::Path(_, Inside::Cup(v)) => Some(place(v.radius, v.top, v.bottom)),
            Space::Path(_, Inside::Tube(f)) => {
                let t = f.tube();
                let r = place(t.radius, 0.0, t.length);
                f.holds(r).then_some(r)
            }
            Space::Path(_, Inside::Ring(a, b)) | Space::Decanter(a, b) => Some([0.0, (a * a + (b * b - a * a) * p.along).sqrt(), 0.0]),
            Space::Discs(_) => Some([0.0, p.along, 0.0]),
        }
    }

    /// The start of the particle that takes longest on the axis: at the surface for heavy ones, at the bottom for light ones.
    pub fn slowest(&self, heavy: bool) -> [f64; 3] {
        let pick = |inner: f64, outer: f64| if heavy { inner } else { outer };
        let y = match &self.space {
            Space::Path(_, Inside::Cup(v)) => pick(v.top, v.bottom),
            Space::Path(_, Inside::Tube(f)) => pick(f.axis_surface(), f.tube().length),
            Space::Path(_, Inside::Ring(a, b)) | Space::Decanter(a, b) => pick(*a, *b),
            Space::Discs(_) => 1.0,
        };
        [0.0, y, 0.0]
    }

    /// First exit of a particle released at rest, with its inertia where the machine has a path in space.
    pub fn settle(&self, rates: &Rates, start: [f64; 3]) -> Option<Exit> {
        self.settle_from(rates, start, [0.0; 3])
    }

    /// The same released at a velocity relative to the cup, m/s.
    pub fn settle_from(&self, rates: &Rates, start: [f64; 3], velocity: [f64; 3]) -> Option<Exit> {
        let steady = match self.steady() {
            Some(s) if s.speed != 0.0 || s.gravity != 0.0 => s,
            _ => return self.drift(rates.sedimentation, start),
        };
        let path = Closed::new(rates, &steady, start, velocity);
        let thrown = velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
        self.first(&path, rates.sedimentation, thrown, &steady, start)
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
                self.first(&Drifting::new(sedimentation, &steady, start), sedimentation, 0.0, &steady, start)
            }
        }
    }

    /// `thrown` is the size of the velocity at the start, m/s.
    fn first(&self, path: &impl super::closed::Path, sedimentation: f64, thrown: f64, steady: &Steady, start: [f64; 3]) -> Option<Exit> {
        let field = (steady.speed * steady.speed * steady.radius(start)).hypot(steady.gravity);
        let settling = (sedimentation.abs() * field).max(thrown);
        match &self.space {
            Space::Path(_, inside) => {
                let way = match inside {
                    Inside::Cup(v) => 1.05 * (v.bottom - v.top).max(v.radius),
                    other => other.width(),
                };
                first_exit(path, inside, way / settling)
            }
            Space::Discs(_) | Space::Decanter(..) => None,
        }
    }
}
