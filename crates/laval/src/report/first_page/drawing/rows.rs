//! Parallel shafts of a machine that lies: one row each, as far apart as their axes are, with the wheels that join them.

use super::Parts;

/// Room between two shafts that do not mesh where they are thickest.
const CLEAR: f64 = 8.0;
/// Largest distance of two rows.
const FARTHEST: f64 = 150.0;
/// Distance of two axes, over the largest of the machine, within which they are one.
const SAME: f64 = 1e-9;

pub(super) struct Rows {
    /// Row of each body.
    pub of: Vec<usize>,
    /// How far each row is drawn above the first.
    pub up: Vec<f64>,
    /// Radii of each pair of wheels as drawn: they touch.
    pub wheels: Vec<[f64; 2]>,
}

impl Rows {
    /// `scale`: of the drawing over the machine, 1/m. `half`: half height of each body.
    pub fn of(parts: &Parts, scale: f64, half: &[f64]) -> Rows {
        let (of, axes) = rows(parts);
        let need = |row: usize| {
            let own = (0..of.len()).filter(|&k| of[k] == row && parts.bodies[k].rotor && !carries_only_a_wheel(parts, k));
            own.map(|k| half[k]).fold(0.0, f64::max)
        };
        let distance = |w: &super::Wheels| {
            let least = need(of[w.ends[0].0]) + need(of[w.ends[1].0]) + CLEAR;
            (scale * (w.radii[0] + w.radii[1])).min(FARTHEST).max(least)
        };
        let mut up: Vec<Option<f64>> = vec![None; axes.len()];
        up[0] = Some(0.0);
        // each pass reaches one shaft farther
        for _ in 1..axes.len() {
            for w in &parts.wheels {
                let [a, b] = w.ends.map(|e| of[e.0]);
                let (known, other) = match (up[a], up[b]) {
                    (Some(_), None) => (a, b),
                    (None, Some(_)) => (b, a),
                    _ => continue,
                };
                let (Some(from), way) = (up[known], distance(w)) else { continue };
                let free = |y: &f64| up.iter().flatten().all(|other| (other - y).abs() > 0.5 * way);
                let above = axes[other][1] - axes[known][1] >= -SAME * (w.radii[0] + w.radii[1]);
                let sides = if above { [from + way, from - way] } else { [from - way, from + way] };
                let beyond = up.iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max) + way;
                up[other] = Some(sides.into_iter().find(free).unwrap_or(beyond));
            }
        }
        let up: Vec<f64> = up.into_iter().map(Option::unwrap_or_default).collect();
        let drawn = |w: &super::Wheels| {
            let apart = (up[of[w.ends[0].0]] - up[of[w.ends[1].0]]).abs();
            w.radii.map(|r| apart * r / (w.radii[0] + w.radii[1]))
        };
        let wheels = parts.wheels.iter().map(drawn).collect();
        Rows { of, up, wheels }
    }

    /// The radius with which a body is drawn that is a wheel itself.
    pub fn wheel(&self, parts: &Parts, body: usize) -> Option<f64> {
        if !carries_only_a_wheel(parts, body) {
            return None;
        }
        let all = parts.wheels.iter().zip(&self.wheels);
        all.flat_map(|(w, radii)| [0, 1].map(|k| (w.ends[k].0, radii[k]))).filter(|w| w.0 == body).map(|w| w.1).reduce(f64::max)
    }
}

/// A rigid body with a wheel at its reference point.
fn carries_only_a_wheel(parts: &Parts, body: usize) -> bool {
    !parts.bodies[body].flexible && parts.wheels.iter().any(|w| w.ends.contains(&(body, 0.0)))
}

/// Row of each body, and the axis of each row, m.
fn rows(parts: &Parts) -> (Vec<usize>, Vec<[f64; 2]>) {
    let size = parts.bodies.iter().flat_map(|b| b.axis).fold(0.0f64, |m, x| m.max(x.abs()));
    let mut axes: Vec<[f64; 2]> = Vec::new();
    let mut of = Vec::new();
    for b in &parts.bodies {
        let near = |a: &[f64; 2]| (a[0] - b.axis[0]).hypot(a[1] - b.axis[1]) <= SAME * size;
        of.push(axes.iter().position(near).unwrap_or_else(|| {
            axes.push(b.axis);
            axes.len() - 1
        }));
    }
    if axes.is_empty() {
        axes.push([0.0; 2]);
    }
    (of, axes)
}
