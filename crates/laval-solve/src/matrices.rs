//! Matrices of a machine linearised about a state, as plain arrays.
//!
//! ```text
//! M q'' + (C + W G) q' + (K + W N) q = f
//! ```

use crate::characteristic::Equilibrium;
use crate::diagnostic::Diagnostic;
use crate::model::blocks::{Blocks, Grid};
use crate::model::system::{Slot, System};
use crate::pencil::Linearised;
use laval_num::dense::Mat;

/// Matrices over the coordinates of a machine, row by row, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrices {
    /// Names of the coordinates, such as `drum.x`.
    pub coordinates: Vec<String>,
    /// Spin speed W, rad/s.
    pub speed: f64,
    /// M.
    pub mass: Vec<Vec<f64>>,
    /// C, without gyroscopic terms.
    pub damping: Vec<Vec<f64>>,
    /// G, to be multiplied by the spin speed.
    pub gyroscopic: Vec<Vec<f64>>,
    /// K, with the tangent of nonlinear parts, without circulatory terms.
    pub stiffness: Vec<Vec<f64>>,
    /// N, to be multiplied by the spin speed.
    pub circulatory: Vec<Vec<f64>>,
}

/// Matrices about a state at rest or in axes that turn with the rotor. Internal states of parts are left out.
///
/// ```
/// use laval_model::model::builder::Builder;
/// use laval_model::model::{field::Attach, part::Link};
/// use laval_model::parts::{disc::{Disc, DiscParams}, shaft_lumped::{ShaftLumped, ShaftLumpedParams}};
/// use laval_solve::{matrices::matrices, rest::rest};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let shaft = ShaftLumped::lateral(Link::Between(Attach::on("disc"), Attach::ground()));
/// let machine = Builder::new("Laval rotor")
///     .part("disc", Disc::planar(), DiscParams::new(3.0))
///     .part("shaft", shaft, ShaftLumpedParams { stiffness: [3e5; 2], ..ShaftLumpedParams::new() })
///     .build()?;
/// let m = matrices(&machine, &rest(&machine, 100.0)?)?;
/// assert_eq!(m.coordinates, ["disc.x", "disc.y"]);
/// assert_eq!((m.mass[0][0], m.stiffness[1][1]), (3.0, 3e5));
/// # Ok(()) }
/// ```
///
/// # Errors
/// A part that has no time form.
pub fn matrices(system: &System, about: &Equilibrium) -> Result<Matrices, Diagnostic> {
    let own = Linearised::new(system, about)?;
    let n = system.n();
    let (mut gyroscopic, mut circulatory) = (Mat::zeros(n, n), Mat::zeros(n, n));
    let mut blocks = Blocks::default();
    for slot in system.slots().iter().filter(|s| s.is_linear()) {
        let speed = slot.speed(system.params(), about.speed);
        blocks.reset_band(slot.map.len(), slot.states.len() - slot.memory, slot.reach, speed);
        slot.part.linear_f64(&system.params()[slot.params.clone()], speed, &mut blocks);
        if let Some(ratio) = slot.ratio {
            blocks.per_spin(ratio.value(system.params()));
        }
        spread(slot, &blocks.gyroscopic, &mut gyroscopic);
        spread(slot, &blocks.circulatory, &mut circulatory);
    }
    let list = |entry: &dyn Fn(usize, usize) -> f64| (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
    Ok(Matrices {
        coordinates: system.coordinates().iter().map(|c| c.name.clone()).collect(),
        speed: about.speed,
        mass: list(&|i, j| own.mass[(i, j)]),
        damping: list(&|i, j| own.damping[(i, j)] - about.speed * gyroscopic[(i, j)]),
        gyroscopic: list(&|i, j| gyroscopic[(i, j)]),
        stiffness: list(&|i, j| own.stiffness[(i, j)] - about.speed * circulatory[(i, j)]),
        circulatory: list(&|i, j| circulatory[(i, j)]),
    })
}

/// Adds `B^T block B` of a part.
fn spread(slot: &Slot, block: &Grid<f64>, out: &mut Mat) {
    for (i, rows) in slot.map.iter().enumerate() {
        for j in block.columns(i) {
            let cols = &slot.map[j];
            for &(gi, ci) in rows {
                for &(gj, cj) in cols {
                    out[(gi, gj)] += ci * block[(i, j)] * cj;
                }
            }
        }
    }
}
