//! Time form of the plane flow of a viscous liquid at one speed.
//!
//! ```text
//! L = w^2 [M - sum r_j/(x - x_j)],   x = (w - W)/W
//!   = w^2 [L(W)/W^2 + sum b_j x/(x - x_j)],   r_j = -b_j x_j,   M = L(W)/W^2 + sum b_j real
//! ```
//!
//! On the real axis the reaction is smooth, but on scales from the width of a wave down to the time in which viscosity stops the whole layer. Poles come from the AAA
//! algorithm on samples spaced by these scales, and must die out, all of them. The `b_j` are fitted by least squares; written as above the form is exact at `w = W`
//! whatever they are. Seen from the rotor the liquid takes energy at every frequency, `Im L (w - W) <= 0` on the real axis. It takes least at `w = 0`, where almost any
//! fit gives a little: one more wave, `x_j = i`, then takes that back, and a form that still gives some is none.
//!
//! The error is measured on places of their own, closer than the narrowest pole, climbed to its tops between them, and on lines where motions grow.
//!
//! At speed -W the reaction is that at W with x and r conjugate: forms are made for `W > 0`, with `nu/|W|` as their only speed.
//!
//! Symbols as in [cavity](super).
//!
//! Theory: `docs/theory/liquid-in-three-dimensions.md#time-forms`.

use super::Cavity;
use super::damped::attainable;
use super::rational::{Rational, Wave};
use super::waves::BAND;
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;
use laval_num::order::ascending;
use laval_num::rational::{least_squares, poles};
use std::cell::Cell;

/// Most poles.
pub const MOST_POLES: usize = 48;
/// Poles are found for half the accuracy, then for a third of that, and so on so many times.
const FINER: i32 = 14;
/// The fit reaches so far beyond the band.
const BEYOND: f64 = 8.0;
/// Distance from the reaction at rest in fixed axes, where what is fitted is 0/0.
const STILL: f64 = 1e-3;
/// What the tops of the error that were found are multiplied by.
pub(super) const TOPS: f64 = 1.1;
/// What is taken back over what was given at the places looked at.
const TAKEN: f64 = 2.0;
/// Reactions that may be computed for one form.
const WORK: usize = 240_000;
/// Where the accuracy requested cannot be had: how much larger one is tried.
const LARGER: f64 = 1.5;
/// Steps to a top.
const CLIMB: usize = 24;
/// Rates of growth over the speed at which the error is measured.
pub(super) const GROWTHS: [f64; 6] = [1e-3, 0.01, 0.05, 0.2, 0.6, 2.0];

/// A time form with what is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// The form.
    pub form: Rational,
    /// Largest error over `|L| + |L of the liquid as a rigid ring|`, of tilt `|L| + |L of k = 0|`, of motions that do not decay.
    pub error: f64,
}

/// Why there is no form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refused {
    /// Speed 0 or no layer.
    Speed,
    /// So many poles do not reach the accuracy, or feed motions.
    Accuracy {
        /// A larger one for which there is a form; infinite where none is known.
        reached: f64,
    },
    /// More axial harmonics than are computed.
    Harmonics,
    /// The reaction could not be computed.
    Reaction,
    /// It would have to be computed too often.
    Work,
    /// The search was requested to stop.
    Stopped,
}

/// A reaction at speed 1.
struct Reaction<'a> {
    /// `L` of w.
    exact: &'a dyn Fn(C64) -> Option<C64>,
    /// What errors of it are compared with.
    size: &'a dyn Fn(C64, C64) -> f64,
    /// `L(W)/W^2`.
    rest: f64,
    /// Where it changes fast, and how fast.
    centres: Vec<(f64, f64)>,
    /// Samples a decade, of the fit and of the check.
    density: [f64; 2],
    left: Cell<usize>,
    stop: &'a dyn Fn() -> bool,
}

impl Cavity<f64> {
    /// The reaction on displacement at this speed. `stop` is polled now and then.
    ///
    /// # Errors
    /// As [`tilt_viscous_in_time`](Self::tilt_viscous_in_time).
    pub fn planar_in_time(&self, speed: f64, nu: f64, accuracy: f64, stop: &dyn Fn() -> bool) -> Result<Layer, Refused> {
        let nu = self.at_unit_speed(speed, nu)?;
        let unit = nu / (self.radius * self.radius);
        let ring = self.full_mass() * (1.0 - (self.free / self.radius).powi(2));
        let at = |w: C64| Some(self.planar_viscous(w, 1.0, nu));
        let size = |w: C64, l: C64| l.abs() + ring * w.norm_sqr();
        let mut centres = vec![(0.0, (0.01 * unit).min(0.1))];
        centres.extend(self.plane_waves(1.0).into_iter().map(|w| (w - 1.0, (0.03 * unit.sqrt()).min(0.1))));
        let (rest, density) = (self.full_mass(), [12.0, 23.0]);
        let reaction = Reaction { exact: &at, size: &size, rest, centres, density, left: Cell::new(WORK), stop };
        match reaction.fit(accuracy) {
            Ok(layer) => Ok(layer.at_speed(speed)),
            Err(Refused::Accuracy { .. }) => {
                let again = |accuracy: f64| {
                    reaction.left.set(WORK);
                    reaction.fit(accuracy)
                };
                Err(Refused::Accuracy { reached: attainable(LARGER * accuracy, LARGER, again)? })
            }
            Err(refused) => Err(refused),
        }
    }

    /// Viscosity at speed 1 that is this one at `speed`.
    pub(super) fn at_unit_speed(&self, speed: f64, nu: f64) -> Result<f64, Refused> {
        let nu = nu / speed.abs();
        if nu > 0.0 && nu.is_finite() && self.free > 0.0 && self.free < self.radius { Ok(nu) } else { Err(Refused::Speed) }
    }
}

impl Layer {
    /// Of speed 1, at `speed`.
    pub(super) fn at_speed(mut self, speed: f64) -> Self {
        if speed < 0.0 {
            self.form.waves.iter_mut().for_each(|w| (w.place, w.strength) = (w.place.conj(), w.strength.conj()));
        }
        self
    }
}

impl Reaction<'_> {
    /// Places along the band, `per` of them a decade of distance from the centres.
    fn places(&self, centres: &[(f64, f64)], per: f64, far: f64) -> Vec<f64> {
        let mut out = Vec::new();
        for &(centre, least) in centres {
            let count = ((2.0 * far / least).log10() * per).ceil() as i32;
            for k in 0..=count {
                let off = least * (2.0 * far / least).powf(f64::from(k) / f64::from(count.max(1)));
                out.extend([centre - off, centre + off].into_iter().filter(|x| x.abs() <= far));
            }
        }
        ascending(&mut out);
        out.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * b.abs());
        out
    }

    fn at(&self, w: C64) -> Result<C64, Refused> {
        let left = self.left.get().checked_sub(1).ok_or(Refused::Work)?;
        self.left.set(left);
        if left.is_multiple_of(256) && (self.stop)() {
            return Err(Refused::Stopped);
        }
        (self.exact)(w).filter(|l| l.is_finite()).ok_or(Refused::Reaction)
    }

    /// What is fitted, and the weight of its error.
    fn sample(&self, x: f64) -> Result<(f64, C64, f64), Refused> {
        let w = c(x + 1.0, 0.0);
        let l = self.at(w)?;
        Ok((x, l / (w * w), w.norm_sqr() / (self.size)(w, l)))
    }

    fn error(&self, form: &Rational, w: C64) -> Result<f64, Refused> {
        let l = self.at(w)?;
        let error = (form.at(w, 1.0) - l).abs() / (self.size)(w, l);
        if error.is_finite() { Ok(error) } else { Err(Refused::Reaction) }
    }

    fn fit(&self, accuracy: f64) -> Result<Layer, Refused> {
        let places = self.places(&self.centres, self.density[0], BEYOND * BAND).into_iter().filter(|x| (x + 1.0).abs() > STILL);
        let samples = places.map(|x| self.sample(x)).collect::<Result<Vec<_>, _>>()?;
        let x: Vec<C64> = samples.iter().map(|s| c(s.0, 0.0)).collect();
        let f: Vec<C64> = samples.iter().map(|s| s.1).collect();
        let weights: Vec<f64> = samples.iter().map(|s| s.2).collect();
        let mut before = 0;
        for finer in 0..FINER {
            // more of them there are not
            if before >= MOST_POLES {
                break;
            }
            if (self.stop)() {
                return Err(Refused::Stopped);
            }
            let target = 0.5 * 3f64.powi(-finer);
            let found = poles(&x, &f, &weights, target * accuracy, MOST_POLES).ok_or(Refused::Accuracy { reached: f64::INFINITY })?;
            let same = std::mem::replace(&mut before, found.len()) == found.len();
            let dying: Vec<C64> = found.into_iter().filter(|p| p.im > 0.0).collect();
            if same || dying.is_empty() {
                continue;
            }
            let mut form = self.with_strengths(&dying, &samples);
            // where the samples say it already there is no need to look closely
            if !samples.iter().all(|s| self.off(&form, s) <= accuracy) {
                continue;
            }
            let given = self.given(&form);
            if given > 0.0 {
                let back = TAKEN * given;
                form.inertia -= back;
                form.waves.push(Wave { place: C64::i(), strength: c(0.0, back) });
            }
            if self.given(&form) > 0.0 {
                continue;
            }
            let error = self.largest_error(&form, accuracy)?;
            if error <= accuracy {
                return Ok(Layer { form, error });
            }
        }
        Err(Refused::Accuracy { reached: f64::INFINITY })
    }

    fn off(&self, form: &Rational, &(x, f, weight): &(f64, C64, f64)) -> f64 {
        let w = c(x + 1.0, 0.0);
        (form.at(w, 1.0) / (w * w) - f).abs() * weight
    }

    fn with_strengths(&self, poles: &[C64], samples: &[(f64, C64, f64)]) -> Rational {
        let n = poles.len();
        // real parts of all b_j, imaginary ones of all but the last, which makes their sum 0
        let shape = |x: f64, j: usize| c(x, 0.0) / (c(x, 0.0) - poles[j]);
        let entry = |x: f64, j: usize| if j < n { shape(x, j) } else { (shape(x, j - n) - shape(x, n - 1)).mul_i() };
        let a = Mat::from_fn(2 * samples.len(), 2 * n - 1, |i, j| {
            let (x, _, weight) = samples[i / 2];
            let z = entry(x, j).scale(weight);
            if i % 2 == 0 { z.re } else { z.im }
        });
        let right = samples.iter().flat_map(|&(_, f, weight)| {
            let z = (f - c(self.rest, 0.0)).scale(weight);
            [z.re, z.im]
        });
        let found = least_squares(&a, &right.collect::<Vec<f64>>());
        let last = -found[n..].iter().sum::<f64>();
        let b = |j: usize| c(found[j], if j + 1 < n { found[n + j] } else { last });
        let inertia = self.rest + found[..n].iter().sum::<f64>();
        let waves = poles.iter().enumerate().map(|(j, p)| Wave { place: *p, strength: -(b(j) * *p) }).collect();
        Rational { inertia, turning: 0.0, waves }
    }

    /// How much of `-x/(x - i)` takes back what the form gives to motions: `Im sum b_j/(x - x_j) <= 0` holds on the real axis and far out with that; 0 where it does anyway.
    fn given(&self, form: &Rational) -> f64 {
        let mut centres = self.centres.clone();
        centres.push((-1.0, 1e-4));
        centres.extend(form.waves.iter().map(|w| (w.place.re, 0.03 * w.place.im)));
        let reach = 1e3 * form.waves.iter().map(|w| w.place.abs()).fold(BEYOND * BAND, f64::max);
        let mut places = self.places(&centres, 24.0, reach);
        places.push(-1.0);
        let excess = places.into_iter().map(|x| {
            let terms = form.waves.iter().map(|w| -(w.strength / w.place) / (c(x, 0.0) - w.place));
            let (sum, size) = terms.fold((C64::zero(), 0.0), |(s, size), t| (s + t, size + t.abs()));
            if sum.im <= 64.0 * f64::EPSILON * size { 0.0 } else { sum.im * (1.0 + x * x) }
        });
        let far: f64 = form.waves.iter().map(|w| -w.strength.im).sum();
        excess.fold(far.max(0.0), |a, b| if b.is_nan() { f64::NAN } else { a.max(b) })
    }

    /// The largest error in the band, on the real axis and where motions grow; some error above the limit where it is above that.
    fn largest_error(&self, form: &Rational, limit: f64) -> Result<f64, Refused> {
        let mut centres = self.centres.clone();
        centres.extend(form.waves.iter().filter(|w| w.place.re.abs() < 1.1 * BAND).map(|w| (w.place.re, 0.1 * w.place.im)));
        let places = self.places(&centres, if form.waves.len() > 20 { 0.5 } else { 1.0 } * self.density[1], BAND);
        let mut worst = 0.0f64;
        for growth in [0.0].into_iter().chain(GROWTHS) {
            let error = |x: f64| self.error(form, c(x + 1.0, -growth));
            // where motions grow fast nothing changes fast
            let mut line: Vec<f64> = Vec::new();
            for &x in &places {
                if line.last().is_none_or(|last| x - last >= 0.1 * growth) {
                    line.push(x);
                }
            }
            let errors = line.iter().map(|&x| error(x)).collect::<Result<Vec<f64>, Refused>>()?;
            worst = errors.iter().copied().fold(worst, f64::max);
            if TOPS * worst > limit {
                return Ok(TOPS * worst);
            }
            let tall = 0.5 * errors.iter().copied().fold(0.0, f64::max);
            for i in 1..line.len().max(2) - 1 {
                if errors[i] >= errors[i - 1] && errors[i] >= errors[i + 1] && errors[i] >= tall {
                    worst = worst.max(top(&error, line[i - 1], line[i + 1])?);
                }
            }
        }
        Ok(TOPS * worst)
    }
}

/// The highest value met on the way to a top between two places, by golden section.
fn top(f: &dyn Fn(f64) -> Result<f64, Refused>, mut a: f64, mut b: f64) -> Result<f64, Refused> {
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    let (mut left, mut right) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut low, mut high) = (f(left)?, f(right)?);
    let mut best = low.max(high);
    for _ in 0..CLIMB {
        if low > high {
            (b, right, high) = (right, left, low);
            left = b - ratio * (b - a);
            low = f(left)?;
        } else {
            (a, left, low) = (left, right, high);
            right = a + ratio * (b - a);
            high = f(right)?;
        }
        best = best.max(low).max(high);
    }
    Ok(best)
}
