//! Motions of points for small pictures: orbits, the line through them at one instant, and their projection from space.

use crate::outcome::{Arg, Data, Limit, Table, Tiles, View};
use crate::report::words::Style;
use std::f64::consts::TAU;

/// Pictures side by side.
pub(in crate::report) struct TilesView {
    pub view: View,
    pub tiles: Vec<TileView>,
    /// Names of the bodies, in the order of their colours.
    pub bodies: Vec<String>,
    /// What the point on every orbit means.
    pub mark: String,
    pub notes: Vec<String>,
    /// Unit of the heights.
    pub unit: String,
}

/// One picture.
pub(in crate::report) struct TileView {
    pub title: String,
    pub lines: Vec<String>,
    pub circle: Option<Limit>,
    pub unstable: bool,
    pub points: Vec<Point>,
}

/// A point of the machine.
pub(in crate::report) struct Point {
    pub body: usize,
    pub line: i64,
    pub place: f64,
    /// From the axis of the first body to its own, m.
    pub axis: [f64; 2],
    /// Its height in the unit of the reader.
    pub height: String,
    pub named: bool,
    pub motion: Whirl,
}

/// `x + i y = f exp(i a) + b exp(-i a)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::report) struct Whirl {
    pub f: [f64; 2],
    pub b: [f64; 2],
}

impl Whirl {
    /// From amplitudes and their angles.
    pub fn new(forward: (f64, f64), backward: (f64, f64)) -> Whirl {
        let polar = |(r, angle): (f64, f64)| [r * angle.cos(), r * angle.sin()];
        Whirl { f: polar(forward), b: polar(backward) }
    }

    /// Place at an angle of the motion.
    pub fn at(&self, a: f64) -> [f64; 2] {
        let (s, c) = a.sin_cos();
        [(self.f[0] + self.b[0]) * c + (self.b[1] - self.f[1]) * s, (self.f[1] + self.b[1]) * c + (self.f[0] - self.b[0]) * s]
    }

    /// Semi-major axis, and the semi-minor one: negative when the motion is backward.
    pub fn axes(&self) -> (f64, f64) {
        let (f, b) = (self.f[0].hypot(self.f[1]), self.b[0].hypot(self.b[1]));
        (f + b, f - b)
    }

    /// The whole orbit.
    pub fn orbit(&self, steps: usize) -> Vec<[f64; 2]> {
        (0..=steps).map(|k| self.at(TAU * k as f64 / steps as f64)).collect()
    }

    /// A point on the straight line between two.
    pub fn between(&self, other: &Whirl, t: f64) -> Whirl {
        let mix = |a: [f64; 2], b: [f64; 2]| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
        Whirl { f: mix(self.f, other.f), b: mix(self.b, other.b) }
    }
}

/// A view from far away: the directions in space that point to the right and upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::report) struct Camera {
    pub right: [f64; 3],
    pub up: [f64; 3],
}

impl Camera {
    /// The axis z stands upright; seen from above the horizon.
    pub fn upright(turned: f64, raised: f64) -> Camera {
        let ((sa, ca), (se, ce)) = (turned.sin_cos(), raised.sin_cos());
        Camera { right: [ca, sa, 0.0], up: [-se * sa, se * ca, ce] }
    }

    /// The axis z lies, from left to right, and y is upright.
    pub fn lying(turned: f64, raised: f64) -> Camera {
        let ((sa, ca), (se, ce)) = (turned.sin_cos(), raised.sin_cos());
        Camera { right: [sa, 0.0, ca], up: [se * ca, ce, -se * sa] }
    }

    /// To the right, and upwards.
    pub fn project(&self, p: [f64; 3]) -> (f64, f64) {
        let along = |d: &[f64; 3]| d.iter().zip(&p).map(|(a, b)| a * b).sum();
        (along(&self.right), along(&self.up))
    }
}

impl TilesView {
    /// The pictures in the words of a reader; none where their table does not exist.
    pub fn new(tiles: &Tiles, tables: &[Table], style: &Style) -> Option<TilesView> {
        let table = tables.iter().find(|t| t.name() == tiles.table)?;
        let numbers = |name: &str| -> Vec<f64> {
            let column = table.column(name);
            (0..table.rows()).map(|r| column.and_then(|c| c.number(r)).unwrap_or(f64::NAN)).collect()
        };
        let [height, place, line] = [Tiles::HEIGHT, Tiles::PLACE, Tiles::LINE].map(numbers);
        let [f, fp, b, bp] = [Tiles::FORWARD, Tiles::FORWARD_PHASE, Tiles::BACKWARD, Tiles::BACKWARD_PHASE].map(numbers);
        // no columns: one axis
        let axis = Tiles::AXIS.map(|name| numbers(name).into_iter().map(|a| if a.is_finite() { a } else { 0.0 }).collect::<Vec<f64>>());
        let picture = numbers(&tiles.picture);
        let named = match table.column(Tiles::NAMED).map(|c| &c.data) {
            Some(Data::Flag(v)) => v.clone(),
            _ => vec![true; table.rows()],
        };
        let names = match table.column(Tiles::BODY).map(|c| &c.data) {
            Some(Data::Text(v)) => v.clone(),
            _ => vec![String::new(); table.rows()],
        };
        let mut bodies: Vec<String> = Vec::new();
        for name in &names {
            if !bodies.contains(name) {
                bodies.push(name.clone());
            }
        }
        let rung = style.units.column(Tiles::HEIGHT, "m");
        let size = rung.as_ref().map_or(1.0, |r| r.size);
        let shown = |h: f64| style.language.number(&crate::outcome::significant(h / size, 4));
        let point = |r: usize| Point {
            body: bodies.iter().position(|n| *n == names[r]).unwrap_or_default(),
            line: line[r] as i64,
            place: place[r],
            axis: axis.each_ref().map(|a| a[r]),
            height: shown(height[r]),
            named: named[r],
            motion: Whirl::new((f[r], fp[r]), (b[r], bp[r])),
        };
        let tile = |p: &crate::outcome::Picture| TileView {
            title: style.arg(&p.title),
            lines: p.lines.iter().map(|l| style.arg(l)).collect(),
            circle: p.circle,
            unstable: p.unstable,
            points: (0..table.rows()).filter(|&r| picture[r] == p.number as f64 && (f[r] + b[r]).is_finite()).map(point).collect(),
        };
        let say = |all: &[Arg]| all.iter().map(|a| style.arg(a)).collect();
        Some(TilesView {
            view: tiles.view,
            tiles: tiles.pictures.iter().map(tile).collect(),
            mark: style.arg(&tiles.mark),
            notes: say(&tiles.notes),
            unit: style.language.unit(rung.as_ref().map_or("m", |r| r.name.as_str())),
            bodies,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    const VIEWS: [fn(f64, f64) -> Camera; 2] = [Camera::upright, Camera::lying];

    #[test]
    fn a_view_is_orthonormal() {
        for view in VIEWS {
            for (turned, raised) in [(0.0, 0.0), (0.5, 0.3), (-1.2, 1.0)] {
                let Camera { right, up } = view(turned, raised);
                let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(&b).map(|(x, y)| x * y).sum::<f64>();
                assert!((dot(right, right) - 1.0).abs() < 1e-14 && (dot(up, up) - 1.0).abs() < 1e-14 && dot(right, up).abs() < 1e-14);
            }
        }
        // from straight above, the view along the axis
        let above = Camera::upright(0.0, FRAC_PI_2);
        let (u, v) = above.project([0.3, -0.7, 5.0]);
        assert!((u - 0.3).abs() < 1e-14 && (v + 0.7).abs() < 1e-14);
        // level with it, the axis lies from left to right and y is upright
        assert_eq!(Camera::lying(0.0, 0.0).project([9.0, 2.0, 3.0]), (3.0, 2.0));
    }

    /// The sense of a whirl is seen as it is: from above, against the clock is from x to y.
    #[test]
    fn the_sense_of_a_whirl_is_kept() {
        let forward = Whirl::new((1.0, 0.3), (0.2, 1.0));
        let camera = Camera::upright(-0.4, 0.35);
        let seen: Vec<(f64, f64)> = forward.orbit(90).iter().map(|p| camera.project([p[0], p[1], 0.0])).collect();
        let area: f64 = seen.windows(2).map(|w| 0.5 * (w[0].0 * w[1].1 - w[1].0 * w[0].1)).sum();
        // pi (f^2 - b^2), foreshortened by the sine of the height of the eye
        let want = TAU / 2.0 * (1.0 - 0.04) * 0.35f64.sin();
        assert!((area / want - 1.0).abs() < 2e-3, "{area} {want}");
    }

    #[test]
    fn an_orbit_reaches_its_semi_axes() {
        let w = Whirl::new((3.0, 0.4), (1.0, -0.9));
        let sizes: Vec<f64> = w.orbit(3600).iter().map(|p| p[0].hypot(p[1])).collect();
        let (major, minor) = w.axes();
        let (low, high) = sizes.iter().fold((f64::INFINITY, 0.0f64), |(a, b), x| (a.min(*x), b.max(*x)));
        assert!((high - major).abs() < 1e-5 && (low - minor.abs()).abs() < 1e-5);
        // half way between two points of a rigid body
        let other = Whirl::new((1.0, 0.0), (2.0, 0.0));
        let (p, q, m) = (w.at(0.7), other.at(0.7), w.between(&other, 0.5).at(0.7));
        assert!((0..2).all(|k| (m[k] - 0.5 * (p[k] + q[k])).abs() < 1e-14));
    }
}
