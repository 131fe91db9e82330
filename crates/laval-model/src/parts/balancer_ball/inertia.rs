//! Inertia and weight of housing, rings and balls: the share `m J^T (J a + J' v)` of every mass.
//!
//! A mass moves in the rotor by closed forms in its own angles; rotor and body turn it, `p = z + R(theta) R_z(th) b`. A ring with inertias Jx, Jz on a body that
//! tilts moves like masses Jz/2, Jz/2, Jx - Jz/2 at the ends of unit vectors along its node line, across it in its plane, and normal to the plane.

use super::tilt::{Tilt, dot, sum};
use super::{BalancerBallParams, BallBalancer, Ring};
use crate::model::part::{At, Rows};
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;

/// Place of a mass in rotor axes (plane and height), its derivatives in the tilt of its track and in its own angle, and what is left of its acceleration
/// there when both angles move evenly.
struct Place<S> {
    at: (Complex<S>, S),
    tilt: (Complex<S>, S),
    angle: (Complex<S>, S),
    rest: (Complex<S>, S),
    /// It goes along with the carried point; a unit vector does not.
    carried: bool,
}

#[inline(always)]
fn nothing<S: Scalar>() -> (Complex<S>, S) {
    (Complex::zero(), S::zero())
}

impl<S: Scalar> Place<S> {
    /// The ring centre.
    #[inline(always)]
    fn centre(centre: Complex<S>) -> Self {
        Place { at: (centre, S::zero()), tilt: nothing(), angle: nothing(), rest: nothing(), carried: true }
    }
    /// A ball at an angle that moves at `rate`.
    #[inline(always)]
    fn ball(centre: Complex<S>, ring: &Ring<S>, angle: S, rate: S) -> Self {
        let (s, co) = angle.sin_cos();
        let (r, o) = (ring.radius, S::zero());
        let line = ring.line.scale(r);
        let (u, h) = (line * c(co, ring.cos * s), r * s * ring.sin);
        let (mixed, twice) = (line * c(o, -(ring.sin * co)), line * c(o, -(ring.cos * s)));
        let tilt = ring.tilt[1];
        let cross = (rate * tilt).scale(2.0);
        Place {
            at: (centre + u, h),
            tilt: (line * c(o, -(ring.sin * s)), r * s * ring.cos),
            angle: (line * c(-s, ring.cos * co), r * co * ring.sin),
            rest: (
                mixed.scale(cross) + twice.scale(tilt * tilt) - u.scale(rate * rate),
                r * co * ring.cos * cross - h * (rate * rate + tilt * tilt),
            ),
            carried: true,
        }
    }
    /// A unit vector of a ring: along the node line, or at an angle of this cosine and sine from the rotor's plane across it.
    #[inline(always)]
    fn along(ring: &Ring<S>) -> Self {
        Place { carried: false, ..Self::centre(ring.line) }
    }
    #[inline(always)]
    fn across(ring: &Ring<S>, cos: S, sin: S) -> Self {
        let over = ring.line.mul_i();
        let square = -(ring.tilt[1] * ring.tilt[1]);
        Place {
            at: (over.scale(cos), sin),
            tilt: (over.scale(-sin), cos),
            angle: nothing(),
            rest: (over.scale(cos * square), sin * square),
            carried: false,
        }
    }
}

/// Motion of what carries the masses.
struct Carrier<S> {
    turn: Complex<S>,
    speed: S,
    accel: S,
    tilt: Option<Tilt<S>>,
    /// Rows that the masses add to: x, y, tilts, spin.
    force: [S; 2],
    moment: [S; 2],
    spin: S,
}

#[inline(always)]
fn vector<S: Scalar>(turn: Complex<S>, x: (Complex<S>, S)) -> [S; 3] {
    let flat = turn * x.0;
    [flat.re, flat.im, x.1]
}

/// Share of a force in a direction.
#[inline(always)]
fn along<S: Scalar>(d: (Complex<S>, S), flat: Complex<S>, up: S) -> S {
    (d.0.conj() * flat).re + d.1 * up
}

impl<S: Scalar> Carrier<S> {
    #[inline(always)]
    fn new(at: &At<S>, body_tilt: bool) -> Self {
        let o = S::zero();
        Carrier {
            turn: Complex::cis(at.phase),
            speed: at.speed,
            accel: at.spin_accel,
            tilt: if body_tilt { Some(Tilt::new(&at.q[2..4], &at.v[2..4], &at.a[2..4])) } else { None },
            force: [o, o],
            moment: [o, o],
            spin: o,
        }
    }
    /// Rate of a place in axes that do not turn, before the tilt: `(R_z b)'`, with rates of tilt and own angle.
    #[inline(always)]
    fn moves(&self, b: &Place<S>, tilt: S, angle: S) -> (Complex<S>, S) {
        let flat = b.tilt.0.scale(tilt) + b.angle.0.scale(angle);
        (flat + b.at.0.mul_i().scale(self.speed), b.tilt.1 * tilt + b.angle.1 * angle)
    }
    /// Adds a mass with the acceleration of the port and the weight on it; the forces on the tilt of its ring and on its own angle.
    #[inline(always)]
    fn add(&mut self, mass: S, b: &Place<S>, at: &At<S>, gravity: S, tilt: [S; 2], angle: [S; 2]) -> [S; 2] {
        let flat = b.tilt.0.scale(tilt[0]) + b.angle.0.scale(angle[0]);
        let second = b.tilt.0.scale(tilt[1]) + b.angle.0.scale(angle[1]) + b.rest.0;
        let turned = second + flat.mul_i().scale(self.speed.scale(2.0)) + b.at.0 * c(-(self.speed * self.speed), self.accel);
        let mut a = vector(self.turn, (turned, b.tilt.1 * tilt[1] + b.angle.1 * angle[1] + b.rest.1));
        let place = vector(self.turn, b.at);
        if let Some(t) = &self.tilt {
            let rate = vector(self.turn, self.moves(b, tilt[0], angle[0]));
            let twice = t.rate.apply(rate);
            a = sum(sum(a, t.turn.apply(a)), sum(sum(twice, twice), t.accel.apply(place)));
        }
        if b.carried {
            a = [a[0] + at.a[0], a[1] + at.a[1], a[2] + gravity];
        }
        let force = [mass * a[0], mass * a[1], mass * a[2]];
        if b.carried {
            self.force = [self.force[0] + force[0], self.force[1] + force[1]];
        }
        let mut back = force;
        if let Some(t) = &self.tilt {
            self.moment[0] += dot(t.over[0].apply(place), force);
            self.moment[1] += dot(t.over[1].apply(place), force);
            back = sum(force, t.turn.transposed(force));
        }
        let (flat, up) = (self.turn.conj() * c(back[0], back[1]), back[2]);
        self.spin += (b.at.0.conj() * flat).im;
        [along(b.tilt, flat, up), along(b.angle, flat, up)]
    }
    /// Adds `m J^T J` of a mass; J its place's derivatives in x, y, the body's tilts, the tilt of its ring and its own angle (`rows`, where they are coordinates).
    #[inline(always)]
    fn weigh(&self, mass: S, b: &Place<S>, rows: [Option<usize>; 2], out: &mut Masses<S>) {
        let none = [S::zero(); 3];
        let mut columns = [(0, none); 4];
        let mut count = 0;
        if let Some(t) = &self.tilt {
            let place = vector(self.turn, b.at);
            columns[0] = (2, t.over[0].apply(place));
            columns[1] = (3, t.over[1].apply(place));
            count = 2;
        }
        for (row, d) in rows.into_iter().zip([b.tilt, b.angle]) {
            let Some(row) = row else { continue };
            let flat = vector(self.turn, d);
            columns[count] = (row, if let Some(t) = &self.tilt { sum(flat, t.turn.apply(flat)) } else { flat });
            count += 1;
        }
        if b.carried {
            out.add(0, 0, mass);
            out.add(1, 1, mass);
        }
        for i in 0..count {
            let (row, d) = columns[i];
            let heavy = [mass * d[0], mass * d[1], mass * d[2]];
            if b.carried {
                out.add(row, 0, heavy[0]);
                out.add(row, 1, heavy[1]);
            }
            for &(other, d) in &columns[..i + 1] {
                out.add(row, other, dot(heavy, d));
            }
        }
    }
    /// Velocity of a mass, and its height.
    #[inline(always)]
    fn velocity(&self, b: &Place<S>, at: &At<S>, tilt: S, angle: S) -> ([S; 3], S) {
        let (mut v, place) = (vector(self.turn, self.moves(b, tilt, angle)), vector(self.turn, b.at));
        let mut height = place[2];
        if let Some(t) = &self.tilt {
            v = sum(sum(v, t.turn.apply(v)), t.rate.apply(place));
            height += t.turn.apply(place)[2];
        }
        if b.carried { ([v[0] + at.v[0], v[1] + at.v[1], v[2]], height) } else { (v, height) }
    }
}

/// Masses over the local coordinates.
pub(super) struct Masses<'a, S> {
    pub n: usize,
    pub all: &'a mut [S],
}

impl<S: Scalar> Masses<'_, S> {
    /// Adds to an entry and to its mirror image.
    #[inline(always)]
    pub fn add(&mut self, i: usize, j: usize, x: S) {
        self.all[i * self.n + j] += x;
        if i != j {
            self.all[j * self.n + i] += x;
        }
    }
}

impl BallBalancer {
    /// Adds inertia and weight, and the masses where they are requested.
    #[inline(always)]
    pub(super) fn add_inertia<S: Scalar>(
        &self,
        p: &BalancerBallParams<S>,
        at: &At<S>,
        out: &mut Rows<S>,
        mut masses: Option<&mut Masses<S>>,
    ) {
        let mut carrier = Carrier::new(at, self.body_tilt);
        let centre = Self::centre(p);
        let still = [S::zero(); 2];
        if !p.housing_mass.is_nothing() {
            let housing = Place::centre(centre);
            carrier.add(p.housing_mass, &housing, at, p.gravity, still, still);
            if let Some(m) = &mut masses {
                carrier.weigh(p.housing_mass, &housing, [None; 2], m);
            }
        }
        for (k, track) in self.tracks.iter().enumerate() {
            let ring = self.ring(p, at, k);
            let tilt = [ring.tilt[1], ring.tilt[2]];
            let (jx, half) = (p.diametral_inertia, p.polar_inertia.scale(0.5));
            let mut moment = S::zero();
            if self.body_tilt {
                let ends = [
                    (half, Place::along(&ring)),
                    (half, Place::across(&ring, ring.cos, ring.sin)),
                    (jx - half, Place::across(&ring, -ring.sin, ring.cos)),
                ];
                for (mass, end) in &ends {
                    moment += carrier.add(*mass, end, at, p.gravity, tilt, still)[0];
                    if let Some(m) = &mut masses {
                        carrier.weigh(*mass, end, [ring.row, None], m);
                    }
                }
            } else {
                if let (Some(m), Some(row)) = (&mut masses, ring.row) {
                    m.add(row, row, jx);
                }
                let (w, unequal) = (at.speed, (jx - p.polar_inertia) * ring.sin * ring.cos);
                let polar = jx * ring.sin * ring.sin + p.polar_inertia * ring.cos * ring.cos;
                carrier.spin += polar * at.spin_accel + (unequal * tilt[0] * w).scale(2.0);
                moment += jx * tilt[1] - unequal * w * w;
            }
            for i in track.balls.clone() {
                let row = self.row(i);
                let mass = p.ball_mass.scale(self.masses[i]);
                let ball = Place::ball(centre, &ring, at.q[row], at.v[row]);
                let [over, along] = carrier.add(mass, &ball, at, p.gravity, tilt, [at.v[row], at.a[row]]);
                moment += over;
                out.force[row] += along;
                if let Some(m) = &mut masses {
                    carrier.weigh(mass, &ball, [ring.row, Some(row)], m);
                }
            }
            if let Some(row) = ring.row {
                out.force[row] += moment;
            }
        }
        out.force[0] += carrier.force[0];
        out.force[1] += carrier.force[1];
        if self.body_tilt {
            out.force[2] += carrier.moment[0];
            out.force[3] += carrier.moment[1];
        }
        *out.spin += carrier.spin;
    }

    /// Kinetic energy and that of the weight.
    #[inline(always)]
    pub(super) fn inertial_energy<S: Scalar>(&self, p: &BalancerBallParams<S>, at: &At<S>) -> S {
        let carrier = Carrier::new(at, self.body_tilt);
        let centre = Self::centre(p);
        let of = |mass: S, b: &Place<S>, tilt: S, angle: S| {
            let (v, height) = carrier.velocity(b, at, tilt, angle);
            let weight = if b.carried { p.gravity * height } else { S::zero() };
            mass * (dot(v, v).scale(0.5) + weight)
        };
        let mut energy = of(p.housing_mass, &Place::centre(centre), S::zero(), S::zero());
        for (k, track) in self.tracks.iter().enumerate() {
            let ring = self.ring(p, at, k);
            let tilt = ring.tilt[1];
            let (jx, half) = (p.diametral_inertia, p.polar_inertia.scale(0.5));
            energy += of(half, &Place::along(&ring), tilt, S::zero());
            energy += of(half, &Place::across(&ring, ring.cos, ring.sin), tilt, S::zero());
            energy += of(jx - half, &Place::across(&ring, -ring.sin, ring.cos), tilt, S::zero());
            for i in track.balls.clone() {
                let row = self.row(i);
                energy += of(p.ball_mass.scale(self.masses[i]), &Place::ball(centre, &ring, at.q[row], at.v[row]), tilt, at.v[row]);
            }
        }
        energy
    }
}
