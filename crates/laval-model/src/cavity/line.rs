//! Lt of an ideal liquid along one line beside the imaginary axis, from polynomials in pieces.
//!
//! ```text
//! Lt(s, W) = rho R^5 W^2 l(s/W; r0/R, H/R),   on Re s = m W:   l = sum_j c_j T_j(t),   t in [-1, 1] over a piece of the line
//! ```
//!
//! The line is where roots that grow are counted from, over and over, at all speeds alike. There the sum of all harmonics is smooth on the scale m. A piece is made when
//! it is first requested, and halved until its last coefficients say that it is exact to `SHARE`; before many places were requested the sum is taken as it is, so
//! that what is requested once costs no more.

use super::{Cavity, Tilt, Truncation};
use laval_num::analytic::value;
use laval_num::complex::{C64, Complex, c};
use laval_num::scalar::Scalar;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::{Arc, Mutex, PoisonError};

/// Relative error of a piece, above that of the sum, which would be cut finer and finer.
const SHARE: f64 = 1e-6;
/// Places of a piece.
const PLACES: usize = 18;
/// Width of the widest pieces over the speed, and how often they are halved.
const WIDEST: f64 = 0.5;
const HALVINGS: u32 = 13;
/// Places requested before the first piece is made.
const FIRST: u64 = 20_000;
/// Cavities that are remembered.
const REMEMBERED: usize = 64;

/// A piece: coefficients over its width; `None` where the sum is too rough for one so wide.
type Piece = Option<Arc<[C64; PLACES]>>;

/// Pieces of the line of a cavity of radius 1 filled with density 1, by halvings and place.
struct Known {
    /// r0/R and H/R.
    cavity: [u64; 2],
    requested: u64,
    pieces: HashMap<(u32, i64), Piece>,
}

/// Lines made so far, shared by copies of a part.
#[derive(Clone, Default)]
pub struct Lines(Arc<Mutex<Vec<Known>>>);

/// The line, `Re s` over the speed.
#[derive(Clone, Copy, Debug)]
pub struct Line(pub f64);

impl Lines {
    /// Moment per tilt as of [`Cavity::tilt`] with all harmonics, to six digits; s anywhere. It is to be differentiated by s alone.
    pub fn tilt<S: Scalar>(&self, line: Line, cavity: Cavity<S>, s: Complex<S>, speed: S) -> Tilt<S> {
        let w = Complex { re: s.im, im: -s.re };
        let at = value(s).scale(1.0 / speed.value());
        if speed.value() > 0.0
            && (at.re - line.0).abs() <= 1e-9 * line.0
            && let Some([l, slope]) = self.read(line, cavity, at.im)
        {
            let x = s.scale(S::one() / speed);
            let l = Complex::cst(l) + Complex::cst(slope) * (x - Complex::cst(value(x)));
            let r = cavity.radius;
            let scale = cavity.density * r * (r * r * speed).square();
            return Tilt { value: l.scale(scale), harmonics: 0, error: SHARE * scale.value() * value(l).abs() };
        }
        cavity.tilt(w, speed, Truncation::Rough)
    }

    /// l and its derivative in s/W at a height.
    fn read<S: Scalar>(&self, line: Line, cavity: Cavity<S>, height: f64) -> Option<[C64; 2]> {
        let radius = cavity.radius.value();
        let unit = Cavity { radius: 1.0, free: cavity.free.value() / radius, height: cavity.height.value() / radius, density: 1.0 };
        let key = [unit.free.to_bits(), unit.height.to_bits()];
        for halvings in 0..=HALVINGS {
            let width = WIDEST * 0.5f64.powi(halvings as i32);
            let place = (height / width).floor();
            let name = (halvings, place as i64);
            let t = 2.0 * (height / width - place) - 1.0;
            let known = self.known(key, name)?;
            let piece = known.unwrap_or_else(|| {
                // others may go on meanwhile
                let made = piece(&unit, line, (place * width, width));
                self.keep(key, name, made.clone());
                made
            });
            if let Some(piece) = piece {
                let [l, slope] = clenshaw(&*piece, t);
                // along the line s/W = m + i height
                return Some([l, slope.scale(2.0 / width) * c(0.0, -1.0)]);
            }
        }
        None
    }

    /// A piece, where it is known; `None` before pieces are worth their while.
    fn known(&self, key: [u64; 2], name: (u32, i64)) -> Option<Option<Piece>> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let at = all.iter().position(|k| k.cavity == key).unwrap_or_else(|| {
            if all.len() == REMEMBERED {
                drop(all.remove(0));
            }
            all.push(Known { cavity: key, requested: 0, pieces: HashMap::new() });
            all.len() - 1
        });
        let known = &mut all[at];
        known.requested += 1;
        (known.requested > FIRST).then(|| known.pieces.get(&name).cloned())
    }

    fn keep(&self, key: [u64; 2], name: (u32, i64), piece: Piece) {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = all.iter_mut().find(|k| k.cavity == key) {
            known.pieces.insert(name, piece);
        }
    }
}

/// The polynomial over a width of the line, where it is exact enough.
fn piece(cavity: &Cavity<f64>, Line(m): Line, (from, width): (f64, f64)) -> Piece {
    let angle = |j: usize| PI * (j as f64 + 0.5) / PLACES as f64;
    let mut values = [C64::zero(); PLACES];
    let mut size = 0.0f64;
    for (j, l) in values.iter_mut().enumerate() {
        // w = -i s
        let w = c(from + 0.5 * width * (1.0 + angle(j).cos()), -m);
        let found = cavity.tilt(w, 1.0, Truncation::Rough);
        size = size.max(found.value.abs());
        *l = found.value;
        if !(found.error <= SHARE * found.value.abs()) {
            return None;
        }
    }
    let coefficient = |k: usize| {
        let sum = values.iter().enumerate().fold(C64::zero(), |s, (j, l)| s + l.scale((k as f64 * angle(j)).cos()));
        sum.scale(if k == 0 { 1.0 } else { 2.0 } / PLACES as f64)
    };
    let coefficients: [C64; PLACES] = std::array::from_fn(coefficient);
    let last = coefficients[PLACES - 3..].iter().map(|x| x.abs()).fold(0.0, f64::max);
    // a wave of width m that falls between the places shows in the last coefficients by so much less than it is high
    (last * (0.5 * width / m).max(1.0) <= SHARE * size).then(|| Arc::new(coefficients))
}

/// A sum of Chebyshev polynomials and its derivative.
fn clenshaw(coefficients: &[C64], t: f64) -> [C64; 2] {
    let [mut b1, mut b2, mut d1, mut d2] = [C64::zero(); 4];
    for &a in coefficients[1..].iter().rev() {
        let d = b1.scale(2.0) + d1.scale(2.0 * t) - d2;
        let b = a + b1.scale(2.0 * t) - b2;
        (b2, b1, d2, d1) = (b1, b, d1, d);
    }
    [coefficients[0] + b1.scale(t) - b2, b1 + d1.scale(t) - d2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use laval_num::dual::Dual;

    type D1 = Dual<f64, 1>;

    /// After as many places as it takes, values and derivatives are those of the sum; what is not on the line never comes from a piece.
    #[test]
    fn pieces_are_the_sum() {
        let line = Line(1e-3);
        let cavity = Cavity { radius: 0.13, free: 0.09, height: 0.31, density: 900.0 };
        let lifted = Cavity { radius: Dual::lift(0.13), free: Dual::lift(0.09), height: Dual::lift(0.31), density: Dual::lift(900.0) };
        let lines = Lines::default();
        lines.known([(0.09f64 / 0.13).to_bits(), (0.31f64 / 0.13).to_bits()], (0, 0));
        lines.0.lock().unwrap()[0].requested = FIRST;
        let mut read = 0;
        for speed in [40.0, 333.0] {
            for k in 0..400 {
                let height = -9.0 + 0.0473 * f64::from(k);
                let s = c(line.0 * speed, height * speed);
                let dual: Complex<D1> = c(Dual { re: s.re, eps: [1.0] }, Dual { re: s.im, eps: [0.0] });
                let found = lines.tilt(line, lifted, dual, Dual::lift(speed));
                read += usize::from(found.harmonics == 0);
                let exact = lifted.tilt(c(dual.im, -dual.re), Dual::lift(speed), Truncation::None).value;
                let (size, rate) = (value(exact).abs(), c(exact.re.eps[0], exact.im.eps[0]));
                assert!((value(found.value) - value(exact)).abs() <= 1e-6 * size, "{height}");
                let slope = c(found.value.re.eps[0], found.value.im.eps[0]);
                assert!((slope - rate).abs() <= 1e-4 * (rate.abs() + size / (line.0 * speed)), "{height} {slope:?} {rate:?}");
                let beside = lines.tilt(line, cavity, s + c(1e-6 * speed, 0.0), speed);
                assert!(beside.harmonics > 0);
            }
        }
        assert_eq!(read, 800);
    }

    /// What is requested a few times is the sum itself.
    #[test]
    fn nothing_is_made_for_few() {
        let lines = Lines::default();
        let cavity = Cavity { radius: 0.13, free: 0.09, height: 0.31, density: 900.0 };
        let found = lines.tilt(Line(1e-3), cavity, c(0.1, 150.0), 100.0);
        assert_eq!(found, cavity.tilt(c(150.0, -0.1), 100.0, Truncation::Rough));
        assert!(lines.0.lock().unwrap()[0].pieces.is_empty());
    }
}
