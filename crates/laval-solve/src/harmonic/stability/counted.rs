//! Stability of circular motions of machines of many states: about the state that turns with the rotor the roots up to a frequency, and a count of those that grow.

use super::floquet::{Exponents, Method, Stability, Unassessed};
use crate::characteristic::{Equilibrium, Frame};
use crate::harmonic::balance::orbit::Orbit;
use crate::harmonic::balance::problem::Balance;
use crate::large::usual_frequency;
use crate::roots::{Request, roots};
use laval_num::complex::C64;

/// Growth over the frequency that counts as none: at a fold an exponent is zero to rounding, and no count can be taken through it.
const STILL: f64 = 1e-6;
/// Largest frequency, in axes that turn, over the speed, at least.
const OF_SPEED: f64 = 3.0;

impl Stability {
    pub(super) fn counted(&mut self, balance: &mut Balance, x: &[f64], speed: f64) -> Result<Exponents, Unassessed> {
        let failed = |why: &str| Unassessed::Failed(why.into());
        let system = balance.system;
        if balance.pace(speed).frequency * balance.terms.divisor as f64 != speed {
            return Err(failed("the motion does not turn with the rotor"));
        }
        let orbit = Orbit::of(balance, x, speed).map_err(|_| failed("the motion could not be evaluated"))?;
        let mut about = Equilibrium::zero(system, Frame::Turning, speed);
        let (mut v, mut a) = (vec![0.0; system.n()], vec![0.0; system.n()]);
        orbit.at(0.0, &mut about.q, &mut v, &mut a, &mut about.z);
        balance.sample(x, speed);
        let frequency = self.frequency.get_or_insert_with(|| usual_frequency(system, &about)).max(OF_SPEED * speed.abs());
        let margin = STILL * frequency;
        let request = Request { margin, frequency: Some(frequency), growing: true, cancel: balance.cancel, ..Request::default() };
        let found = roots(system, &about, &request).map_err(|d| Unassessed::Failed(d.message.to_string()))?;
        if found.growing().is_none() {
            return Err(failed("the exponents that grow could not be counted"));
        }
        let modes: Vec<C64> = found.spectrum.modes.iter().map(|m| m.value).collect();
        let mut values: Vec<C64> = modes.iter().flat_map(|&s| [Some(s), (s.im != 0.0).then(|| s.conj())]).flatten().collect();
        values.sort_by(|a, b| b.re.total_cmp(&a.re));
        Ok(Exponents { values, error: margin, method: Method::Rotating, span: 0.0 })
    }
}
