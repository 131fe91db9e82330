//! A reaction of a cavity as a rational function of the frequency: what it is in time.
//!
//! ```text
//! L(w) = w^2 M + w W G - w^2 sum_j r_j/(x - x_j),   x = (w - W)/W
//! reaction: -L theta = M theta'' + i W G theta' - W sum_j r_j z_j,   z_j' = i W (1 + x_j) z_j + i theta''
//! ```
//!
//! Symbols: M inertia; G turning share, of the unit of M; x_j frequency of wave j in rotor axes over the speed, Im x_j >= 0; r_j its strength, of the unit
//! of M.

use laval_num::complex::{C64, c};

/// A wave of the liquid that answers the motion of its cavity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// `x_j`.
    pub place: C64,
    /// `r_j`.
    pub strength: C64,
}

/// See the [module](self).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rational {
    /// M.
    pub inertia: f64,
    /// G.
    pub turning: f64,
    /// Waves.
    pub waves: Vec<Wave>,
}

impl Rational {
    /// L at a frequency and a speed, rad/s.
    pub fn at(&self, w: C64, speed: f64) -> C64 {
        let sigma = w - c(speed, 0.0);
        let waves = self.waves.iter().fold(C64::zero(), |s, wave| s + wave.strength.scale(speed) / (sigma - wave.place.scale(speed)));
        w * w * (c(self.inertia, 0.0) - waves) + w.scale(speed * self.turning)
    }
    /// The same times `factor`.
    pub fn scaled(mut self, factor: f64) -> Self {
        self.inertia *= factor;
        self.turning *= factor;
        self.waves.iter_mut().for_each(|w| w.strength = w.strength.scale(factor));
        self
    }
}
