//! The liquid a particle moves in: cup, tube or ring.
//!
//! Validity: surfaces at rest in the axes of the vessel.
//!
//! Sources: `docs/theory/separation.md#first-exit`.

use super::exit::{Cylinder, Gap, MOST, Surface, Vessel};
use super::series::Reach;
use super::tube::Filled;

/// The space particles settle in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inside {
    /// A cup with flat surface and bottom.
    Cup(Cylinder),
    /// A tube at a fixed angle.
    Tube(Filled),
    /// A ring of liquid between two radii, m, in the axes of a tube at 90 degrees from the axis of spin.
    Ring(f64, f64),
}

impl From<Cylinder> for Inside {
    fn from(c: Cylinder) -> Self {
        Inside::Cup(c)
    }
}

impl Inside {
    /// Length of the longest way through it, m.
    pub fn length(&self) -> f64 {
        match self {
            Inside::Cup(c) => (c.bottom - c.top).max(c.radius),
            Inside::Tube(f) => f.tube().length,
            Inside::Ring(a, b) => b - a,
        }
    }
    /// Distances of a place to the surfaces, m: exact in a cup, 0 (not known) elsewhere.
    #[inline]
    pub(crate) fn clear(&self, [x, y, z]: [f64; 3]) -> Reach {
        match self {
            Inside::Cup(c) => Reach { side: c.radius - x.hypot(z), bottom: c.bottom - y, surface: y - c.top },
            Inside::Tube(_) | Inside::Ring(..) => Reach::default(),
        }
    }
    /// Length over which the distance to a surface changes, m.
    pub fn width(&self) -> f64 {
        match self {
            Inside::Cup(c) => (c.bottom - c.top).min(c.radius),
            Inside::Tube(f) => f.tube().radius,
            Inside::Ring(a, b) => b - a,
        }
    }
}

impl Vessel for Inside {
    #[inline]
    fn gaps(&self, r @ [_, y, z]: [f64; 3], v @ [_, vy, vz]: [f64; 3]) -> [Gap; MOST] {
        match self {
            Inside::Cup(c) => c.gaps(r, v),
            Inside::Tube(f) => f.gaps(r, v),
            Inside::Ring(inner, outer) => {
                let (r2, rate) = (y * y + z * z, 2.0 * (y * vy + z * vz));
                [
                    Gap { surface: Surface::Wall, value: outer * outer - r2, rate: -rate },
                    Gap { surface: Surface::Free, value: r2 - inner * inner, rate },
                    Gap::NONE,
                    Gap::NONE,
                ]
            }
        }
    }
}
