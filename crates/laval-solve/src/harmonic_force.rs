//! Linear response to a harmonic force at a point: `T(i w, W) X = b F`, at any frequency w and spin speed W.

use crate::characteristic::Characteristic;
use crate::cross_coupling::placed;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::linear_response::Response;
use crate::locate::State;
use crate::model::field::Attach;
use crate::model::station::Row;
use crate::model::system::System;
use crate::sectors::imaginary;
use laval_num::complex::{C64, c};
use laval_num::dense::Field;
use laval_num::factor::Factors;
use laval_num::work::spend;

/// How the force moves, with an amplitude of 1 N.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Turning as the point does: from x towards y where its spin is positive.
    Forward,
    /// Turning against it.
    Backward,
}

impl Direction {
    /// Complex amplitudes in x and y at a point whose spin is positive.
    pub fn amplitudes(self) -> [C64; 2] {
        match self {
            Direction::X => [C64::ONE, C64::ZERO],
            Direction::Y => [C64::ZERO, C64::ONE],
            Direction::Forward => [C64::ONE, c(0.0, -1.0)],
            Direction::Backward => [C64::ONE, c(0.0, 1.0)],
        }
    }
}

/// A machine with a point on which a force acts.
pub struct Forced {
    /// The machine; a body that bends has a node at the point.
    pub system: System,
    rows: [Row; 2],
    /// Ratio of the spin of the point to that of the machine.
    ratio: f64,
}

impl Forced {
    /// Places the force.
    ///
    /// # Errors
    /// A point that the machine does not have.
    pub fn new(system: &System, at: &Attach) -> Result<Self, Diagnostics> {
        let (system, rows, ratio) = placed(system, at)?;
        Ok(Forced { system, rows, ratio })
    }

    /// Whether the point moves across the axis.
    pub fn moves(&self) -> bool {
        self.rows.iter().any(|r| !r.is_empty())
    }

    /// Response at a frequency and spin speed (rad/s) to a force of this amplitude, N; its `speed` is the frequency. `None` where T is singular.
    ///
    /// # Errors
    /// As the state.
    pub fn response(
        &self,
        state: State,
        (frequency, speed): (f64, f64),
        force: f64,
        direction: Direction,
    ) -> Result<Option<Response>, Diagnostic> {
        let about = state(speed)?;
        let mut t = Characteristic::new(&self.system, &about);
        let [entries, _] = t.entries(imaginary(frequency));
        let mut load = vec![C64::ZERO; t.size()];
        // a negative frequency turns the force the other way by itself
        let turned = self.ratio * speed * frequency < 0.0;
        let amplitudes = direction.amplitudes().map(|z| if turned { z.conj() } else { z });
        for (row, amplitude) in self.rows.iter().zip(amplitudes) {
            row.iter().for_each(|&(i, x)| load[i] += amplitude.scale(x * force));
        }
        t.sectors().polarise(&mut load);
        spend(4 * entries.len() as u64);
        let Ok(factors) = Factors::new(t.plan(), &entries) else { return Ok(None) };
        let rest = |x: &[C64]| -> Vec<C64> { load.iter().zip(t.times(&entries, x)).map(|(f, y)| *f - y).collect() };
        let mut x = load.clone();
        factors.solve(&mut x);
        let mut r = rest(&x);
        factors.solve(&mut r);
        x.iter_mut().zip(&r).for_each(|(x, r)| *x += *r);
        if !x.iter().all(|z| z.is_finite()) {
            return Ok(None);
        }
        let size = load.iter().map(|z| z.abs()).fold(0.0, f64::max);
        let residual = rest(&x).iter().map(|r| r.abs()).fold(0.0, f64::max) / size;
        t.sectors().restore(&mut x);
        Ok(Some(Response { speed: frequency, x, residual }))
    }
}
