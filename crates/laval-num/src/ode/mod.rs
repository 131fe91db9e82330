//! Time integration of y' = f(t, y): an explicit method of order 8 for problems that are not stiff ([`Dop853`]), an implicit one of order 5 for
//! stiff problems ([`Radau`]), and one driver, [`integrate`], for both: error control state by state, outputs at given times, events, limits,
//! cancellation.
//!
//! ```
//! use laval_num::ode::{Control, Direction, Dop853, End, Event, Record, integrate, ode};
//!
//! // a ball thrown up at 10 m/s; when does it land?
//! let mut ball = ode(2, |_, y, dy| (dy[0], dy[1]) = (y[1], -9.81));
//! let height = |_: f64, y: &[f64]| y[0];
//! let landing = [Event::new(&height).direction(Direction::Falling).terminal()];
//! let control = Control { outputs: &[0.5, 1.0], events: &landing, ..Control::new(1e-10, 1e-12) };
//! let (mut y, mut record) = ([0.0, 10.0], Record::default());
//! let run = integrate(&mut Dop853::new(), &mut ball, 0.0, &mut y, 10.0, &control, &mut record);
//! assert_eq!(run.end, End::Event { index: 0, t: run.t });
//! assert!((run.t - 20.0 / 9.81).abs() < 1e-12 && record.times == [0.5, 1.0]);
//! ```

mod control;
mod dop853;
mod driver;
pub(crate) mod event;
pub mod nystrom;
mod radau;
mod step;
mod system;
pub mod tableau;
#[cfg(test)]
mod tests;
pub mod transition;

pub use control::{Attempt, Cause, Control, End, Run, Tolerance, Work};
pub use dop853::Dop853;
pub use driver::{Method, Observer, Record, integrate};
pub use event::{Crossing, Direction, Event};
pub use radau::Radau;
pub use step::Step;
pub use system::{DenseSolver, Failure, FnOde, Ode, StiffOde, ode};
