//! Engineering measures: relative centrifugal force, k-factor, Sigma.
//!
//! Equations:
//!
//! ```text
//! RCF = w^2 R/g           k = 1e13 ln(r_max/r_min)/(3600 w^2)  [S h]          clearing time [h] = k / s[S],  1 S = 1e-13 s
//! Sigma tubular, half capture   pi L w^2 (r2^2 - r1^2)/(g ln[2 r2^2/(r2^2 + r1^2)]),  approximation 2 pi L w^2 (3 r2^2 + r1^2)/(4 g)
//! Sigma tubular, full capture   pi L w^2 (r2^2 - r1^2)/(g ln(r2/r1))
//! Sigma disc stack              2 pi N w^2 (r2^3 - r1^3)/(3 g tan th)                                        (full capture)
//! Sigma decanter                (2 pi w^2/g) {L1 (3 r2^2 + r1^2)/4 + L2 C}                                  (half capture)
//!                               C = (r2^2 + 3 r1 r2 + 4 r1^2)/8 (text-book)  or  (r2^2 + r1 r2 + 2 r1^2)/4 (tubular slices)
//! Sigma bottle                  w^2 Vol/(2 g ln[2 r2/(r2 + r1)])                                              (half capture)
//! throughput                    Q = 2 |s| g Sigma (half capture),   Q = |s| g Sigma (full capture)
//! ```
//!
//! Symbols: w spin speed, rad/s; r1 radius of the liquid surface (inner edge of discs), r2 of the bowl (outer edge), m; th angle between disc and axis; N gaps.
//!
//! Validity: drag-dominated motion along the radius, plug flow; the capture convention is part of the type [`Sigma`].
//!
//! Sources: `docs/theory/separation.md#engineering-measures`; C. M. Ambler, J. Biochem. Microbiol. Technol. Eng. 1 (1959) 185; Livshts et al., Scientific Reports
//! 5 (2015) 17319 (pelleted shares).

use std::f64::consts::PI;

/// One svedberg, s.
pub const SVEDBERG: f64 = 1e-13;

/// Centrifugal acceleration over gravity.
pub fn rcf(speed: f64, radius: f64, gravity: f64) -> f64 {
    speed * speed * radius / gravity
}

/// Speed (rad/s) for a relative centrifugal force at a radius.
pub fn speed_for_rcf(rcf: f64, radius: f64, gravity: f64) -> f64 {
    (rcf * gravity / radius).sqrt()
}

/// k-factor in svedberg hours: hours to clear a tube of particles of 1 S.
pub fn k_factor(speed: f64, r_min: f64, r_max: f64) -> f64 {
    (r_max / r_min).ln() / (3600.0 * SVEDBERG * speed * speed)
}

/// Time (s) to settle from one radius to another along the radius.
pub fn settling_time(sedimentation: f64, speed: f64, from: f64, to: f64) -> f64 {
    (to / from).ln() / (sedimentation * speed * speed)
}

/// Time (s) in a second rotor that clears as much as `time` in the first.
pub fn transfer(time: f64, k_first: f64, k_second: f64) -> f64 {
    time * k_second / k_first
}

/// Highest speed with contents of this density when the rotor is rated for another (the common rule of makers).
pub fn derated(speed: f64, rated_density: f64, density: f64) -> f64 {
    if density > rated_density { speed * (rated_density / density).sqrt() } else { speed }
}

/// What a throughput by Sigma means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Capture {
    /// Half of the particles of the cut size are caught.
    Half,
    /// All of them.
    Full,
}

/// Area of a settling basin that does as much, m^2, with its convention.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sigma {
    /// Area, m^2.
    pub area: f64,
    /// Which share is caught.
    pub capture: Capture,
}

impl Sigma {
    /// Throughput (m^3/s) at which particles of this sedimentation coefficient (s) are just caught.
    pub fn throughput(&self, sedimentation: f64, gravity: f64) -> f64 {
        let factor = match self.capture {
            Capture::Half => 2.0,
            Capture::Full => 1.0,
        };
        factor * sedimentation.abs() * gravity * self.area
    }
    /// Sedimentation coefficient (s) just caught at a throughput (m^3/s).
    pub fn sedimentation(&self, throughput: f64, gravity: f64) -> f64 {
        throughput / self.throughput(1.0, gravity)
    }
}

/// Tubular bowl: half capture, exact for plug flow.
pub fn tubular_half(speed: f64, length: f64, r1: f64, r2: f64, gravity: f64) -> Sigma {
    let logarithm = (2.0 * r2 * r2 / (r2 * r2 + r1 * r1)).ln();
    Sigma { area: PI * length * speed * speed * (r2 * r2 - r1 * r1) / (gravity * logarithm), capture: Capture::Half }
}

/// Tubular bowl: half capture, common approximation.
pub fn tubular_half_approximate(speed: f64, length: f64, r1: f64, r2: f64, gravity: f64) -> Sigma {
    Sigma { area: 2.0 * PI * length * speed * speed * (3.0 * r2 * r2 + r1 * r1) / (4.0 * gravity), capture: Capture::Half }
}

/// Tubular bowl: full capture.
pub fn tubular_full(speed: f64, length: f64, r1: f64, r2: f64, gravity: f64) -> Sigma {
    Sigma { area: PI * length * speed * speed * (r2 * r2 - r1 * r1) / (gravity * (r2 / r1).ln()), capture: Capture::Full }
}

/// Disc stack of `gaps` channels; `angle` between disc and axis, rad.
pub fn disc_stack(speed: f64, gaps: f64, r1: f64, r2: f64, angle: f64, gravity: f64) -> Sigma {
    let area = 2.0 * PI * gaps * speed * speed * (r2.powi(3) - r1.powi(3)) / (3.0 * gravity * angle.tan());
    Sigma { area, capture: Capture::Full }
}

/// How the cone of a decanter counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cone {
    /// `(r2^2 + 3 r1 r2 + 4 r1^2)/8`.
    #[default]
    TextBook,
    /// `(r2^2 + r1 r2 + 2 r1^2)/4`: tubular slices averaged over the cone.
    Slices,
}

/// Decanter with a cylinder of length `l1` and a cone of length `l2`.
pub fn decanter(speed: f64, l1: f64, l2: f64, r1: f64, r2: f64, cone: Cone, gravity: f64) -> Sigma {
    let c = match cone {
        Cone::TextBook => (r2 * r2 + 3.0 * r1 * r2 + 4.0 * r1 * r1) / 8.0,
        Cone::Slices => (r2 * r2 + r1 * r2 + 2.0 * r1 * r1) / 4.0,
    };
    let area = 2.0 * PI * speed * speed / gravity * (l1 * (3.0 * r2 * r2 + r1 * r1) / 4.0 + l2 * c);
    Sigma { area, capture: Capture::Half }
}

/// Bottle centrifuge of a volume (m^3).
pub fn bottle(speed: f64, volume: f64, r1: f64, r2: f64, gravity: f64) -> Sigma {
    Sigma { area: speed * speed * volume / (2.0 * gravity * (2.0 * r2 / (r2 + r1)).ln()), capture: Capture::Half }
}

/// Share pelleted in a swinging tube between two radii after `time` (s), particles spread evenly along it, walls left out.
pub fn pelleted_swinging(sedimentation: f64, speed: f64, r_min: f64, r_max: f64, time: f64) -> f64 {
    let reached = r_max * (-sedimentation * speed * speed * time).exp();
    ((r_max - reached) / (r_max - r_min)).min(1.0)
}

/// Share pelleted in a fixed-angle tube after `time` (s) by the rule of the literature: all particles move straight across the tube in the field of the
/// mean radius, so that the share is what two circles shifted against each other do not have in common.
pub fn pelleted_fixed_angle(sedimentation: f64, speed: f64, mean_radius: f64, tube_diameter: f64, tilt: f64, time: f64) -> f64 {
    let shift = sedimentation * speed * speed * mean_radius * time * tilt.cos() / tube_diameter;
    if shift >= 1.0 {
        return 1.0;
    }
    1.0 - 2.0 / PI * (shift.acos() - shift * (1.0 - shift * shift).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    const G: f64 = 9.80665;

    /// Half of the particles that enter evenly over the ring are caught at Q = 2 v_g Sigma, all of them at Q = v_g Sigma of full capture.
    #[test]
    fn capture_conventions() {
        let (w, l, r1, r2, s) = (300.0, 0.5, 0.05, 0.1, 3e-9);
        let caught = |sigma: Sigma| {
            let residence = PI * l * (r2 * r2 - r1 * r1) / sigma.throughput(s, G);
            let reached = r2 * (-s * w * w * residence).exp();
            (r2 * r2 - reached * reached) / (r2 * r2 - r1 * r1)
        };
        assert!((caught(tubular_half(w, l, r1, r2, G)) - 0.5).abs() < 1e-14);
        assert!((caught(tubular_full(w, l, r1, r2, G)) - 1.0).abs() < 1e-14);
        // a thin layer: the approximation is the limit
        let (a, b) = (tubular_half(w, l, 0.0999, 0.1, G).area, tubular_half_approximate(w, l, 0.0999, 0.1, G).area);
        assert!((a / b - 1.0).abs() < 1e-6);
    }

    /// A particle that starts at one disc reaches the other at the inner edge: path through one gap, by steps.
    #[test]
    fn disc_stack_by_its_limiting_path() {
        let (w, r1, r2, th, s, q, gaps) = (500.0, 0.08, 0.25, 0.96f64, 2e-9, 1e-4, 200.0);
        let h = 0.5e-3;
        let steps = 200_000;
        let mut y = 0.0;
        for i in 0..steps {
            let r = r2 - (r2 - r1) * (i as f64 + 0.5) / steps as f64;
            let along = q / (2.0 * PI * r * h * gaps);
            y += s * w * w * r * th.cos() / along * (r2 - r1) / steps as f64 / th.sin();
        }
        let just = q * y / h; // throughput at which it just crosses the gap
        assert!((disc_stack(w, gaps, r1, r2, th, G).throughput(s, G) / just - 1.0).abs() < 1e-9);
    }

    #[test]
    fn the_cone_of_slices_is_their_mean() {
        let (r1, r2, n) = (0.1, 0.18, 100_000);
        let mean: f64 = (0..n)
            .map(|i| {
                let r = r1 + (r2 - r1) * (i as f64 + 0.5) / n as f64;
                (3.0 * r * r + r1 * r1) / 4.0
            })
            .sum::<f64>()
            / n as f64;
        assert!((mean - (r2 * r2 + r1 * r2 + 2.0 * r1 * r1) / 4.0).abs() < 1e-9);
        let d = |cone| decanter(300.0, 0.5, 0.3, r1, r2, cone, G).area;
        assert!(d(Cone::Slices) > d(Cone::TextBook));
    }

    #[test]
    fn settling_and_k_factor_agree() {
        let (w, s) = (3141.6, 70.0 * SVEDBERG);
        let hours = k_factor(w, 0.04, 0.09) / 70.0;
        assert!((settling_time(s, w, 0.04, 0.09) / 3600.0 / hours - 1.0).abs() < 1e-14);
        assert_eq!(transfer(10.0, 200.0, 100.0), 5.0);
        assert_eq!((derated(400.0, 1.2, 1.0), derated(400.0, 1000.0, 4000.0)), (400.0, 200.0));
    }
}
