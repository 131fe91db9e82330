//! Spin-speed programmes: speed, spin acceleration and the exact phase as functions of time.

use laval_model::text;
use laval_model::text::Text;
use serde::{Deserialize, Serialize};

/// The spin at one moment.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spin {
    /// Angle since the start, the integral of the speed, rad.
    pub phase: f64,
    /// Speed, rad/s.
    pub speed: f64,
    /// Rate of the speed, rad/s^2.
    pub accel: f64,
}

/// How the speed goes from one value to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Constant acceleration; it jumps at both ends.
    Linear,
    /// A cubic whose acceleration is zero at both ends.
    Smooth,
    /// Constant rate relative to the speed, as a rotor slowed by viscous drag; both speeds of one sign.
    Exponential,
}

/// Why a programme makes no sense.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unusable(pub Text);

/// Highest degree of a polynomial of the speed.
pub const DEGREE: usize = 7;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Law {
    /// Speed as a cubic of the time since `origin`.
    Cubic([f64; 4]),
    /// The same of higher degree, not monotone.
    Polynomial([f64; DEGREE + 1]),
    /// `speed exp(rate (t - origin))`.
    Exponential { speed: f64, rate: f64 },
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    /// Holds from here to the next piece.
    from: f64,
    origin: f64,
    /// Phase at `origin`.
    phase: f64,
    law: Law,
}

impl Piece {
    fn at(&self, t: f64) -> Spin {
        let x = t - self.origin;
        match self.law {
            Law::Cubic([a, b, c, d]) => Spin {
                phase: self.phase + x * (a + x * (b / 2.0 + x * (c / 3.0 + x * (d / 4.0)))),
                speed: a + x * (b + x * (c + x * d)),
                accel: b + x * (2.0 * c + x * (3.0 * d)),
            },
            Law::Polynomial(c) => {
                let mut spin = Spin { phase: 0.0, speed: 0.0, accel: 0.0 };
                for (k, c) in c.iter().enumerate().rev() {
                    spin.phase = spin.phase * x + c / (k + 1) as f64;
                    spin.speed = spin.speed * x + c;
                    if k > 0 {
                        spin.accel = spin.accel * x + c * k as f64;
                    }
                }
                Spin { phase: self.phase + spin.phase * x, ..spin }
            }
            Law::Exponential { speed, rate } => {
                // expm1 keeps the phase exact for slow changes
                let grown = (rate * x).exp_m1();
                let angle = if rate == 0.0 { speed * x } else { speed * grown / rate };
                Spin { phase: self.phase + angle, speed: speed * (1.0 + grown), accel: rate * speed * (1.0 + grown) }
            }
        }
    }
}

/// A prescribed spin: pieces of closed form, so that the phase is the exact integral of the speed. Before the first and after the last given
/// time the speed is held.
#[derive(Clone, Debug, PartialEq)]
pub struct Programme {
    pieces: Vec<Piece>,
}

impl Programme {
    /// Constant speed (rad/s) with `phase` (rad) at t = 0.
    pub fn constant(speed: f64, phase: f64) -> Self {
        Programme { pieces: vec![Piece { from: f64::NEG_INFINITY, origin: 0.0, phase, law: Law::Cubic([speed, 0.0, 0.0, 0.0]) }] }
    }

    /// From one speed to another during `duration` (s), starting at t = 0 with `phase`.
    ///
    /// # Errors
    /// A duration that is not positive, values that are not finite, or an exponential through or to standstill.
    pub fn ramp(from: f64, to: f64, duration: f64, shape: Shape, phase: f64) -> Result<Self, Unusable> {
        let ok = duration > 0.0 && duration.is_finite() && from.is_finite() && to.is_finite() && phase.is_finite();
        if !ok {
            return Err(Unusable(text!("the speeds must be finite and the duration of the change positive")));
        }
        let d = to - from;
        let law = match shape {
            Shape::Linear => Law::Cubic([from, d / duration, 0.0, 0.0]),
            Shape::Smooth => Law::Cubic([from, 0.0, 3.0 * d / duration.powi(2), -2.0 * d / duration.powi(3)]),
            Shape::Exponential => {
                let ratio = to / from;
                if ratio.is_nan() || ratio <= 0.0 || ratio.is_infinite() {
                    return Err(Unusable(text!(
                        "an exponential change never reaches or leaves standstill: both speeds need the same sign"
                    )));
                }
                Law::Exponential { speed: from, rate: ratio.ln() / duration }
            }
        };
        let mut programme = Self::constant(from, phase);
        programme.push(0.0, law);
        programme.hold(duration, to);
        programme.finite()
    }

    /// Speed as a polynomial of the time, `c[0] + c[1] t + c[2] t^2 ...` (rad/s, rad/s^2, ...), for `duration` (s) from t = 0 with `phase`.
    ///
    /// # Errors
    /// No coefficient or more than [`DEGREE`] + 1, a duration that is not positive, values that are not finite.
    pub fn polynomial(coefficients: &[f64], duration: f64, phase: f64) -> Result<Self, Unusable> {
        if coefficients.is_empty() || coefficients.len() > DEGREE + 1 {
            return Err(Unusable(text!(
                "a polynomial of the speed has 1 to {most} coefficients, not {given}",
                most = DEGREE + 1,
                given = coefficients.len()
            )));
        }
        let finite = coefficients.iter().chain([&phase]).all(|x| x.is_finite());
        if !(finite && duration > 0.0 && duration.is_finite()) {
            return Err(Unusable(text!("the coefficients must be finite and the duration of the change positive")));
        }
        let mut all = [0.0; DEGREE + 1];
        all[..coefficients.len()].copy_from_slice(coefficients);
        let mut programme = Self::constant(all[0], phase);
        programme.push(0.0, Law::Polynomial(all));
        let last = programme.at(duration).speed;
        programme.hold(duration, last);
        programme.finite()
    }

    /// Through (time, speed) points by monotone cubics (Fritsch, Butland 1984): the acceleration is continuous and the speed never
    /// overshoots. `phase` is the angle at the first time.
    ///
    /// # Errors
    /// Fewer than two points, times that do not increase, values that are not finite.
    pub fn table(times: &[f64], speeds: &[f64], phase: f64) -> Result<Self, Unusable> {
        if times.len() != speeds.len() || times.len() < 2 {
            return Err(Unusable(text!("a table of speeds needs at least two points, and as many speeds as times")));
        }
        if !times.iter().chain(speeds).chain([&phase]).all(|x| x.is_finite()) {
            return Err(Unusable(text!("times and speeds must be finite")));
        }
        if let Some(w) = times.windows(2).find(|w| w[1] <= w[0]) {
            return Err(Unusable(text!(
                "the times must increase; {first} is followed by {second}",
                first = text::quantity(w[0], "s"),
                second = text::quantity(w[1], "s")
            )));
        }
        let h: Vec<f64> = times.windows(2).map(|w| w[1] - w[0]).collect();
        let slope: Vec<f64> = speeds.windows(2).zip(&h).map(|(w, h)| (w[1] - w[0]) / h).collect();
        let mut rate = vec![0.0; times.len()];
        for i in 1..times.len() - 1 {
            let (a, b) = (slope[i - 1], slope[i]);
            if a * b > 0.0 {
                let (u, v) = (2.0 * h[i] + h[i - 1], h[i] + 2.0 * h[i - 1]);
                rate[i] = (u + v) / (u / a + v / b);
            }
        }
        let mut programme = Self::constant(speeds[0], phase);
        programme.pieces[0].origin = times[0];
        for i in 0..h.len() {
            let (c, d) = ((3.0 * slope[i] - 2.0 * rate[i] - rate[i + 1]) / h[i], (rate[i] + rate[i + 1] - 2.0 * slope[i]) / (h[i] * h[i]));
            programme.push(times[i], Law::Cubic([speeds[i], rate[i], c, d]));
        }
        programme.hold(times[times.len() - 1], speeds[speeds.len() - 1]);
        programme.finite()
    }

    /// Itself when no coefficient left the range of numbers.
    fn finite(self) -> Result<Self, Unusable> {
        let fine = self.pieces.iter().all(|p| {
            p.phase.is_finite()
                && match p.law {
                    Law::Cubic(c) => c.iter().all(|x| x.is_finite()),
                    Law::Polynomial(c) => c.iter().all(|x| x.is_finite()),
                    Law::Exponential { speed, rate } => speed.is_finite() && rate.is_finite(),
                }
        });
        if fine { Ok(self) } else { Err(Unusable(text!("the speed changes faster than can be computed"))) }
    }

    fn push(&mut self, from: f64, law: Law) {
        let phase = self.at(from).phase;
        self.pieces.push(Piece { from, origin: from, phase, law });
    }

    fn hold(&mut self, from: f64, speed: f64) {
        self.push(from, Law::Cubic([speed, 0.0, 0.0, 0.0]));
    }

    /// The spin at `t` (s).
    pub fn at(&self, t: f64) -> Spin {
        let k = self.pieces.partition_point(|p| p.from <= t).max(1) - 1;
        self.pieces[k].at(t)
    }

    /// The speed when it never changes.
    pub fn constant_speed(&self) -> Option<f64> {
        match self.pieces.as_slice() {
            [Piece { law: Law::Cubic([speed, ..]), .. }] => Some(*speed),
            _ => None,
        }
    }

    /// Times where the law of the speed changes: an integration should not step over them.
    pub fn knots(&self) -> impl Iterator<Item = f64> + '_ {
        self.pieces[1..].iter().map(|p| p.from)
    }

    /// Lowest and highest speed up to the last knot.
    pub fn speed_range(&self) -> (f64, f64) {
        let ends = std::iter::once(self.pieces[0].origin).chain(self.knots()).map(|t| self.at(t).speed);
        // every other piece is monotone between its ends
        let curved = self.pieces.windows(2).filter(|w| matches!(w[0].law, Law::Polynomial(_)));
        let inside = curved.flat_map(|w| (0..1000).map(|k| w[0].at(w[0].from + (w[1].from - w[0].from) * 1e-3 * f64::from(k)).speed));
        ends.chain(inside).fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), w| (lo.min(w), hi.max(w)))
    }

    /// Largest speed, without its sign, up to the last knot.
    pub fn largest_speed(&self) -> f64 {
        let (lo, hi) = self.speed_range();
        lo.abs().max(hi.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn programmes() -> Vec<Programme> {
        vec![
            Programme::constant(300.0, 0.4),
            Programme::ramp(100.0, 400.0, 2.0, Shape::Linear, 0.3).unwrap(),
            Programme::ramp(400.0, 100.0, 2.0, Shape::Smooth, 0.3).unwrap(),
            Programme::ramp(400.0, 20.0, 1.5, Shape::Exponential, -1.0).unwrap(),
            Programme::table(&[0.0, 0.5, 1.0, 1.7, 2.0], &[0.0, 50.0, 60.0, 60.0, 10.0], 0.0).unwrap(),
            Programme::polynomial(&[10.0, 40.0, -30.0, 5.0, 7.0, -1.0], 1.5, 0.2).unwrap(),
        ]
    }

    /// Phase and acceleration are the integral and the derivative of the speed, across the knots too.
    #[test]
    fn phase_speed_and_acceleration_belong_together() {
        for p in programmes() {
            for i in 0..200 {
                let (a, b) = (-0.3 + 0.0137 * i as f64, -0.3 + 0.0137 * (i + 1) as f64);
                if p.knots().any(|k| k >= a && k <= b) {
                    continue;
                }
                let (u, m, v) = (p.at(a), p.at(0.5 * (a + b)), p.at(b));
                let simpson = (b - a) / 6.0 * (u.speed + 4.0 * m.speed + v.speed);
                assert!((v.phase - u.phase - simpson).abs() < 1e-8, "{a} {p:?}");
                let simpson = (b - a) / 6.0 * (u.accel + 4.0 * m.accel + v.accel);
                assert!((v.speed - u.speed - simpson).abs() < 1e-6, "{a} {p:?}");
            }
            for k in p.knots() {
                let (a, b) = (p.at(k - 1e-12), p.at(k));
                assert!((a.phase - b.phase).abs() < 1e-8 && (a.speed - b.speed).abs() < 1e-8, "{p:?}");
            }
        }
    }

    #[test]
    fn acceleration_is_continuous_where_promised() {
        for p in [&programmes()[2], &programmes()[4]] {
            for k in p.knots() {
                assert!((p.at(k - 1e-12).accel - p.at(k).accel).abs() < 1e-6, "{k} {p:?}");
            }
        }
    }

    #[test]
    fn ramp_turns_by_the_mean_speed() {
        let p = Programme::ramp(100.0, 400.0, 2.0, Shape::Linear, 0.0).unwrap();
        assert_eq!(p.at(2.0).phase, 500.0);
        let p = Programme::ramp(100.0, 400.0, 2.0, Shape::Smooth, 0.0).unwrap();
        assert!((p.at(2.0).phase - 500.0).abs() < 1e-10);
    }

    #[test]
    fn polynomial_has_its_coefficients() {
        let p = Programme::polynomial(&[10.0, 0.0, -30.0, 40.0], 2.0, 0.5).unwrap();
        let s = p.at(0.5);
        assert!((s.speed - 7.5).abs() < 1e-14 && s.accel.abs() < 1e-13 && (s.phase - (0.5 + 5.0 - 1.25 + 0.625)).abs() < 1e-14);
        assert_eq!((p.at(-1.0).speed, p.at(9.0).speed, p.largest_speed()), (10.0, 210.0, 210.0));
        // largest between its ends
        let hump = Programme::polynomial(&[0.0, 100.0, -50.0], 2.0, 0.0).unwrap();
        assert!((hump.largest_speed() - 50.0).abs() < 1e-9);
    }

    #[test]
    fn table_passes_through_its_points_without_overshoot() {
        let (t, w) = ([0.0, 1.0, 2.0, 4.0], [0.0, 10.0, 10.0, 300.0]);
        let p = Programme::table(&t, &w, 0.0).unwrap();
        for (t, w) in t.iter().zip(w) {
            assert!((p.at(*t).speed - w).abs() < 1e-11);
        }
        let mut last = 0.0;
        for i in 0..=4000 {
            let s = p.at(i as f64 * 1e-3).speed;
            assert!(s >= last - 1e-12);
            last = s;
        }
        assert_eq!(p.largest_speed(), 300.0);
    }

    #[test]
    fn nonsense_is_refused() {
        assert!(Programme::ramp(1.0, 2.0, 0.0, Shape::Linear, 0.0).is_err());
        assert!(Programme::ramp(f64::NAN, 2.0, 1.0, Shape::Linear, 0.0).is_err());
        for (a, b) in [(1.0, 0.0), (0.0, 1.0), (0.0, 0.0), (-1.0, 1.0)] {
            assert!(Programme::ramp(a, b, 1.0, Shape::Exponential, 0.0).is_err());
        }
        for (c, t) in [(&[][..], 1.0), (&[1.0; 9][..], 1.0), (&[1.0][..], 0.0), (&[f64::NAN][..], 1.0)] {
            assert!(Programme::polynomial(c, t, 0.0).is_err());
        }
        assert!(Programme::table(&[0.0, 0.0], &[1.0, 2.0], 0.0).is_err());
        assert!(Programme::table(&[0.0], &[1.0], 0.0).is_err());
        assert!(Programme::table(&[0.0, 1.0], &[1.0, f64::NAN], 0.0).is_err());
    }
}
