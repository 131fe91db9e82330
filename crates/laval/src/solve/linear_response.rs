//! Linear synchronous response: `T(i W) X = F` with the forces that turn with the rotor.

use super::characteristic::Characteristic;
use super::locate::State;
use super::sectors::{circular, imaginary};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use laval_num::complex::C64;
use laval_num::dense::{Lu, Mat, Singular};

/// Complex amplitudes `X` of the motion `Re(X exp(i phase))` over the unknowns of the characteristic matrix, in x and y.
#[derive(Clone, Debug)]
pub struct Response {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Amplitudes: coordinates, then states.
    pub x: Vec<C64>,
    /// Residual of the linear system over the size of its right side.
    pub residual: f64,
}

impl Response {
    /// Forward and backward circular amplitudes of the pair that starts at coordinate `i`.
    pub fn circles(&self, i: usize) -> (C64, C64) {
        circular(self.x[i], self.x[i + 1])
    }
    /// Semi-major axis of the orbit.
    pub fn major(&self, i: usize) -> f64 {
        let (f, b) = self.circles(i);
        f.abs() + b.abs()
    }
}

/// Response at a speed; `None` where T is singular (an undamped resonance).
///
/// # Errors
/// As the state.
pub fn response(system: &System, state: State, speed: f64) -> Result<Option<Response>, Diagnostic> {
    let mut t = Characteristic::new(system, &state(speed)?);
    let (mut m, mut d) = (Mat::default(), Mat::default());
    t.at(imaginary(speed), &mut m, &mut d);
    let (_, mut load) = t.loads();
    t.sectors().polarise(&mut load);
    let size = load.iter().map(|z| z.abs()).fold(0.0, f64::max);
    let solved: Result<Vec<C64>, Singular> = Lu::new(&m).map(|lu| {
        let mut x = load.clone();
        lu.solve(&mut x);
        // one refinement
        let mut r: Vec<C64> = m.mul_vec(&x).iter().zip(&load).map(|(a, b)| *b - *a).collect();
        lu.solve(&mut r);
        x.iter().zip(&r).map(|(x, r)| *x + *r).collect()
    });
    let Ok(mut x) = solved else { return Ok(None) };
    if !x.iter().all(|z| z.is_finite()) {
        return Ok(None);
    }
    let residual = m.mul_vec(&x).iter().zip(&load).map(|(a, b)| (*a - *b).abs()).fold(0.0, f64::max);
    t.sectors().restore(&mut x);
    Ok(Some(Response { speed, x, residual: if size > 0.0 { residual / size } else { residual } }))
}
