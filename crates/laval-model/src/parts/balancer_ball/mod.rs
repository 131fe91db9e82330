//! An automatic ball balancer: rings with balls that run freely in circular tracks about the shaft, where above the critical speed they settle opposite
//! the unbalance.
//!
//! Equations, in axes that turn with the rotor (horizontal plane complex, height `h` along the axis, away from the foot), for the carried point
//! `z = x + i y` and spin angle `th`, speed `W`:
//!
//! ```text
//! ring centre (all tracks)  O  = z + s e^{i(th + gamma)}
//! ball on a track           p  = O + r u e^{i(th + B)},   h = r sin(phi) sin(alpha),   u = cos(phi) + i cos(alpha) sin(phi)
//! inertia of a ring         T  = (Jx (alpha'^2 + W^2 sin^2 alpha) + Jz W^2 cos^2 alpha)/2
//! housing                   m_b at O
//! each mass                 adds m J^T (J a + J' v) and its weight to the rows of x, y (body tilt), spin, alpha, phi
//! drag on a ball            Q  = c phi' + (T_d + f m r^2 (W + phi')^2) phi'/sqrt(phi'^2 + e^2)      N m
//! contact of two balls      N  = k d^{3/2} (1 + chi d') >= 0,   d = 2 asin(r_b/r) - |angle between them|
//! free ring                 adds k_a (alpha - alpha_0) + c_a alpha' to its row
//! ```
//!
//! Symbols: s eccentricity of the ring centre, m; gamma its direction, B the **node line** (the diameter a track is tilted about), both from the key
//! mark, rad; alpha tilt of a track, rad; phi angle of a ball in its track from the node line, rad; r track radius, m; m ball mass, kg; Jx diametral
//! and Jz polar inertia of one ring, kg m^2; c drag, T_d dry torque, N m s and N m; f rolling resistance; e rate at which dry friction has 71 % of its full value, rad/s;
//! r_b ball radius, m; k contact stiffness, N m/rad^1.5; chi contact damping, s/rad.
//!
//! Angles: B is measured from the key mark, not from the eccentricity of the ring. That is convention A of the source's equations of motion (`B = beta`,
//! with the unbalance of the disc at phase 0); where the source counts from the eccentricity (convention B, its stationary equations), `B = beta + gamma`.
//! Coordinates: the ball angles phi, and the tilts alpha of free rings; they do not turn with the machine. Ball angles are never wrapped.
//!
//! Body that tilts: positions are taken in three dimensions, `p = z + R(theta) R_z(th) b` with the rotation vector theta of the body, whose derivatives come from
//! exact differentiation. A body that does not tilt needs half the work: say `body_tilt = false`.
//!
//! Validity: balls roll or slide without spin about other axes (rolling adds inertia along the track only); dry friction below e is a creep, not a stop; a ring has no gap
//! in its bearing. Balls pass through each other unless contact is given.
//!
//! Theory: `docs/theory/ball-balancers.md#equations-of-motion`.
//!
//! Sources: `004_a7f947693ee2e358` chapters 1 to 4, with its errata; E. L. Thearle, Trans. ASME 54 (1932) 131; K. Green, A. R. Champneys, N. J. Lieven,
//! J. Sound Vib. 291 (2006) 861.

mod inertia;
mod laws;
mod moment;
#[cfg(test)]
mod tests;
mod tilt;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::capability::{Contacts, MovableMasses, Scope, VaryingInertia};
use crate::model::erased;
use crate::model::field::{Attach, Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Correction, Dof, Energy, ErasedPart, Layout, Link, Observed, Outline, Params, Part, Physics, Rows, Validity};
use crate::model::system::Axis;
use crate::params;
use crate::text;
use crate::text::Text;
use inertia::Masses;
use laval_num::complex::Complex;
use laval_num::scalar::Scalar;
use std::ops::Range;
use std::sync::Arc;
use std::sync::OnceLock;

params! {
    /// Parameters of a [`BallBalancer`].
    pub struct BalancerBallParams in BalancerBallFamily {
        ball_mass: scalar, "kg", Bounds::positive(1e4), required, "mass m of a ball";
        track_radius: scalar, "m", Bounds::positive(100.0), required, "radius r of the circle the centres of the balls run on";
        eccentricity: scalar, "m", Bounds::up_to(1.0), default 0.0, "distance s of the ring centre from the shaft centre";
        eccentricity_phase: scalar, "rad", Bounds::within(1e3), default 0.0, "direction gamma of the ring centre from the key mark";
        tilt: scalar, "rad", Bounds::within(1.5), default 0.0, "tilt alpha of the tracks; of free rings, where their springs are relaxed";
        node_line: scalar, "rad", Bounds::within(1e3), default 0.0, "direction B of the node line, about which the tracks are tilted, from the key mark (not from the eccentricity of the ring)";
        housing_mass: scalar, "kg", Bounds::up_to(1e6), default 0.0, "mass m_b of the housing, at the ring centre";
        diametral_inertia: scalar, "kg m^2", Bounds::up_to(1e6), default 0.0, "diametral moment of inertia Jx of one ring";
        polar_inertia: scalar, "kg m^2", Bounds::up_to(1e6), default 0.0, "polar moment of inertia Jz of one ring";
        tilt_stiffness: scalar, "N m/rad", Bounds::up_to(1e15), default 0.0, "spring k_a that holds a free ring";
        tilt_damping: scalar, "N m s", Bounds::up_to(1e9), default 0.0, "damping c_a of a free ring";
        drag: scalar, "N m s", Bounds::up_to(1e6), default 0.0, "viscous drag torque c of a ball per rate of its angle";
        dry_torque: scalar, "N m", Bounds::up_to(1e6), default 0.0, "dry friction torque T_d of a ball: where the track pulls less, the ball stays";
        rolling_resistance: scalar, "", Bounds::up_to(10.0), default 0.0, "rolling resistance f: friction force over the centrifugal load of a ball";
        friction_rate: scalar, "rad/s", Bounds::closed(1e-9, 1e6), default 1e-3, "rate e of a ball below which dry friction fades: it creeps that slowly where it should stay";
        rolling_inertia: scalar, "", Bounds::up_to(10.0), default 0.0, "added inertia along the track over that of the ball's mass: 2/5 (r_b/r_c)^2 for a ball that rolls with rolling radius r_c, 0 for one that slides";
        ball_radius: scalar, "m", Bounds::up_to(10.0), default 0.0, "radius r_b of a ball, for contact and for how many fit";
        contact_stiffness: scalar, "N m/rad^1.5", Bounds::up_to(1e15), default 0.0, "stiffness k of the contact of two balls; they pass through each other without";
        contact_damping: scalar, "s/rad", Bounds::up_to(1e6), default 0.0, "damping chi of the contact: balls that meet at rate v part at about (1 - 2/3 chi v) v";
        gravity: scalar, "m/s^2", Bounds::within(1e4), default 9.80665, "acceleration of gravity along the axis, towards the foot";
    }
}

/// Radius over that of its track by which a ball without size is drawn.
const DRAWN: f64 = 0.06;
/// Most tracks and balls of one balancer.
const MOST: usize = 64;

/// A circular track: what it has of its own.
#[derive(Clone, Debug, PartialEq)]
struct Track {
    balls: Range<usize>,
    /// Over the radius of the balancer.
    radius: f64,
    /// In addition to the tilt of the balancer, rad.
    tilt: f64,
    /// In addition to its node line, rad.
    node_line: f64,
}

/// See the [module](self).
#[derive(Clone, Debug, PartialEq)]
pub struct BallBalancer {
    attach: Attach,
    body_tilt: bool,
    free: bool,
    contact: bool,
    tracks: Vec<Track>,
    /// Of each ball over the ball mass.
    masses: Vec<f64>,
}

/// A track at a state.
struct Ring<S> {
    /// Its row when it is free.
    row: Option<usize>,
    /// Tilt, its rate and acceleration.
    tilt: [S; 3],
    sin: S,
    cos: S,
    /// Unit vector along the node line, in rotor axes.
    line: Complex<S>,
    radius: S,
}

impl BallBalancer {
    /// One track on a body that may tilt, with this many equal balls; the ring does not tilt by itself.
    pub fn new(attach: Attach, balls: usize) -> Self {
        BallBalancer { attach, body_tilt: true, free: false, contact: false, tracks: Vec::new(), masses: Vec::new() }
            .track(balls, 1.0, 0.0, 0.0)
    }
    /// One more track: balls, radius over the track radius, tilt and node line (rad) in addition to those of the balancer.
    pub fn track(mut self, balls: usize, radius: f64, tilt: f64, node_line: f64) -> Self {
        let first = self.masses.len();
        self.masses.resize(first + balls, 1.0);
        self.tracks.push(Track { balls: first..first + balls, radius, tilt, node_line });
        self
    }
    /// Masses of the balls over the ball mass, track by track; balls without one keep theirs.
    pub fn masses(mut self, ratios: &[f64]) -> Self {
        for (m, x) in self.masses.iter_mut().zip(ratios) {
            *m = *x;
        }
        self
    }
    /// On a body that does not tilt, or whose tilt is left out.
    pub fn planar(self) -> Self {
        BallBalancer { body_tilt: false, ..self }
    }
    /// Each ring tilts freely about its node line.
    pub fn free(self) -> Self {
        BallBalancer { free: true, ..self }
    }
    /// The balls of a track push each other.
    pub fn touching(self) -> Self {
        BallBalancer { contact: true, ..self }
    }

    /// Coordinates of the port.
    fn port(&self) -> usize {
        if self.body_tilt { 4 } else { 2 }
    }
    /// Local coordinate of a ball.
    fn row(&self, ball: usize) -> usize {
        self.port() + if self.free { self.tracks.len() } else { 0 } + ball
    }
    #[inline(always)]
    fn ring<S: Scalar>(&self, p: &BalancerBallParams<S>, at: &At<S>, k: usize) -> Ring<S> {
        let track = &self.tracks[k];
        let row = self.port() + k;
        let tilt = if self.free { [at.q[row], at.v[row], at.a[row]] } else { [p.tilt + S::cst(track.tilt), S::zero(), S::zero()] };
        // most tracks are level and have no node line of their own
        let (sin, cos) = if tilt[0].is_nothing() { (S::zero(), S::one()) } else { tilt[0].sin_cos() };
        Ring {
            row: self.free.then_some(row),
            tilt,
            sin,
            cos,
            line: direction(p.node_line + S::cst(track.node_line)),
            radius: p.track_radius.scale(track.radius),
        }
    }
    /// Spring and damper of a free ring, N m.
    #[inline(always)]
    fn held<S: Scalar>(&self, p: &BalancerBallParams<S>, k: usize, ring: &Ring<S>) -> S {
        p.tilt_stiffness * (ring.tilt[0] - p.tilt - S::cst(self.tracks[k].tilt)) + p.tilt_damping * ring.tilt[1]
    }
    /// Ring centre from the shaft centre in rotor axes, m.
    #[inline(always)]
    fn centre<S: Scalar>(p: &BalancerBallParams<S>) -> Complex<S> {
        if p.eccentricity.is_nothing() { Complex::zero() } else { direction(p.eccentricity_phase).scale(p.eccentricity) }
    }
    /// All rows, and the masses where they are requested.
    #[inline(always)]
    fn rows<S: Scalar>(&self, p: &BalancerBallParams<S>, at: &At<S>, out: &mut Rows<S>, mut masses: Option<&mut Masses<S>>) {
        self.add_inertia(p, at, out, masses.as_deref_mut());
        for (k, track) in self.tracks.iter().enumerate() {
            let ring = self.ring(p, at, k);
            if let Some(row) = ring.row {
                out.force[row] += self.held(p, k, &ring);
            }
            for i in track.balls.clone() {
                let row = self.row(i);
                let inertia = p.ball_mass.scale(self.masses[i]) * ring.radius * ring.radius;
                let rolling = inertia * p.rolling_inertia;
                out.force[row] += rolling * at.a[row] + laws::drag(p, inertia, at.speed, at.v[row]);
                if let Some(m) = &mut masses {
                    m.add(row, row, rolling);
                }
            }
            if self.contact {
                for i in track.balls.clone() {
                    for j in i + 1..track.balls.end {
                        let c = laws::Contact::between(p, &ring, at, self.row(i), self.row(j));
                        out.force[self.row(j)] -= c.side * c.force;
                        out.force[self.row(i)] += c.side * c.force;
                    }
                }
            }
        }
    }
}

/// The unit vector in a direction, rad.
#[inline(always)]
fn direction<S: Scalar>(angle: S) -> Complex<S> {
    if angle.is_nothing() { Complex::one() } else { Complex::cis(angle) }
}

/// Names of what is shown of ball or ring `k`.
fn named(what: usize, k: usize) -> &'static str {
    static NAMES: OnceLock<Vec<[&'static str; 4]>> = OnceLock::new();
    let make = |k: usize| {
        let moment = format!("moment of the balls on track {k}");
        [format!("ball {k} angle, wrapped"), format!("ball {k} slip"), format!("tilt {k}"), moment].map(|s| &*s.leak())
    };
    NAMES.get_or_init(|| (1..=MOST).map(make).collect())[k.min(MOST - 1)][what]
}

/// An angle in (-pi, pi].
fn wrapped(angle: f64) -> f64 {
    angle.sin().atan2(angle.cos())
}

const TRACKS: &[(&str, &str, bool, &str)] = &[
    ("balls", "", true, "number of balls on each track"),
    ("radius", "", false, "radius over track_radius"),
    ("tilt", "rad", false, "tilt in addition to tilt"),
    ("node_line", "rad", false, "node line in addition to node_line"),
];

impl Part for BallBalancer {
    const KIND: &'static str = "balancer_ball";
    const EXAMPLE: &'static str = r#"on = "drum"
balls = 2
ball_mass = "3.6 g"
track_radius = "100 mm"
drag = "2e-3 N m s"
eccentricity = "2 um"
body_tilt = false                   # the drum moves in its plane
"#;
    const DOC: &'static str = "An automatic ball balancer: rings with balls that run freely in circular tracks, eccentric or tilted, the tilt fixed or \
        free. Above the critical speed the balls settle opposite the unbalance, if drag, external damping and tilt let them.";
    type Family = BalancerBallFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("on", FieldKind::Attach { ground: false }, "the body that carries it"),
        Field::optional(
            "balls",
            FieldKind::Integer { min: 1, max: MOST as i64 },
            "2",
            "number of balls on the one track; with tracks, which say how many each has, leave it out or give their sum",
        ),
        Field::optional(
            "tracks",
            FieldKind::Columns(TRACKS),
            "",
            "several tracks about one centre, one entry of each column for each track; { balls = [3, 2] } is three balls on the first and two on the second, \
                numbered through: ball_1 to ball_3 run on the first, ball_4 and ball_5 on the second",
        ),
        Field::optional(
            "mass_ratios",
            FieldKind::List { unit: "", bounds: Bounds::positive(1e6) },
            "",
            "mass of each ball over ball_mass in the order of their numbers, track by track, when they are unequal",
        ),
        Field::optional(
            "rings",
            FieldKind::Choice(&[
                ("fixed", "the tilt stays as it is"),
                ("free", "each ring turns about its node line: its tilt is a coordinate"),
            ]),
            "fixed",
            "how the rings are mounted",
        ),
        Field::optional(
            "body_tilt",
            FieldKind::Flag,
            "true",
            "balls follow the tilt of the body; false for a body that does not tilt saves half the work",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let attach = values.attach("on")?;
        let one = BallBalancer { attach, body_tilt: true, free: false, contact: false, tracks: Vec::new(), masses: Vec::new() };
        let before = diagnostics.0.len();
        let mut refuse = |field: &str, message: Text, help: Text| {
            diagnostics.push(Diagnostic::error("balancer_ball.tracks", message).at(values.span_of(field)).help(help));
        };
        let mut part = match values.columns("tracks") {
            None => one.track(values.integer("balls").unwrap_or(2).clamp(1, MOST as i64) as usize, 1.0, 0.0, 0.0),
            Some(columns) => {
                let counts = columns.get("balls")?;
                let entry = |name: &str, k: usize, absent: f64| columns.get(name).and_then(|c| c.get(k)).copied().unwrap_or(absent);
                if let Some(n) = counts.iter().find(|n| !(**n >= 1.0 && n.fract() == 0.0)) {
                    refuse("tracks", text!("a track has {n} balls", n), text!("give a whole number of balls, at least 1, for each track"));
                    return None;
                }
                if !(counts.iter().sum::<f64>() <= MOST as f64) {
                    refuse("tracks", text!("the tracks have more than {most} balls together", most = MOST), text!("give fewer balls"));
                    return None;
                }
                if let Some(r) = (0..counts.len()).map(|k| entry("radius", k, 1.0)).find(|r| !(*r > 0.0 && *r <= 1e3)) {
                    refuse("tracks", text!("a track has {r} times the radius", r), text!("radius is a positive ratio to track_radius"));
                }
                if (0..counts.len()).any(|k| !(entry("tilt", k, 0.0).abs() <= 1.5 && entry("node_line", k, 0.0).abs() <= 1e3)) {
                    refuse("tracks", text!("a track is tilted by more than 1.5 rad"), text!("tilt is in addition to that of the balancer"));
                }
                let all = counts.iter().sum::<f64>();
                if let Some(n) = values.integer("balls").filter(|n| values.written("balls") && *n as f64 != all) {
                    let each = counts.iter().map(|n| format!("{n}")).collect::<Vec<_>>().join(" + ");
                    let help = text!("balls is the number on all tracks together; leave it out, the tracks say how many each has");
                    refuse("balls", text!("balls = {n}, and the tracks have {each} = {all}", n, each, all), help);
                }
                (0..counts.len()).fold(one, |part, k| {
                    part.track(counts[k] as usize, entry("radius", k, 1.0), entry("tilt", k, 0.0), entry("node_line", k, 0.0))
                })
            }
        };
        if let Some(ratios) = values.list("mass_ratios") {
            if ratios.len() != part.masses.len() {
                let (tracks, given, balls) = (part.tracks.len(), ratios.len(), part.masses.len());
                let message = match tracks {
                    0 | 1 => text!("{given} mass ratios are given for {balls} balls", given, balls),
                    _ => text!("{given} mass ratios are given for {balls} balls on {tracks} tracks", given, balls, tracks),
                };
                refuse("mass_ratios", message, text!("one ratio for each ball, track by track"));
            }
            part = part.masses(ratios);
        }
        part.free = values.choice("rings") == Some("free");
        part.body_tilt = values.flag("body_tilt").unwrap_or(true);
        part.contact = params.get("contact_stiffness").is_some_and(|k| k > 0.0);
        (diagnostics.0.len() == before).then_some(part)
    }

    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        let link = Link::On(self.attach.clone());
        let mut layout = if self.body_tilt { Layout::point_and_tilt(link) } else { Layout::point(link) };
        let several = self.tracks.len() > 1;
        if self.free {
            let name = |k: usize| if several { format!("tilt_{}", k + 1) } else { "tilt".to_string() };
            layout.own.extend((0..self.tracks.len()).map(|k| Dof::scalar(name(k), "rad", 0.1)));
        }
        layout.own.extend((0..self.masses.len()).map(|i| Dof::scalar(format!("ball_{}", i + 1), "rad", 1.0)));
        layout
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }

    #[inline(always)]
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        self.rows(p, at, out, None);
    }

    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let mut e = Energy { stored: self.inertial_energy(p, at), ..Energy::zero() };
        for (k, track) in self.tracks.iter().enumerate() {
            let ring = self.ring(p, at, k);
            if self.free {
                let away = ring.tilt[0] - p.tilt - S::cst(self.tracks[k].tilt);
                e.stored += (p.tilt_stiffness * away * away).scale(0.5);
                e.dissipated += p.tilt_damping * ring.tilt[1] * ring.tilt[1];
            }
            for i in track.balls.clone() {
                let rate = at.v[self.row(i)];
                let inertia = p.ball_mass.scale(self.masses[i]) * ring.radius * ring.radius;
                e.stored += (inertia * p.rolling_inertia * rate * rate).scale(0.5);
                e.dissipated += laws::drag(p, inertia, at.speed, rate) * rate;
                if self.contact {
                    for j in i + 1..track.balls.end {
                        let c = laws::Contact::between(p, &ring, at, self.row(i), self.row(j));
                        e.stored += (c.spring * c.overlap.pos()).scale(0.4);
                        e.dissipated += (c.force - c.spring) * c.rate;
                    }
                }
            }
        }
        Some(e)
    }

    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        for (k, track) in self.tracks.iter().enumerate() {
            if self.free {
                out.push(Observed { name: named(2, k), unit: "rad", value: at.q[self.port() + k] });
            }
            for i in track.balls.clone() {
                out.push(Observed { name: named(0, i), unit: "rad", value: wrapped(at.q[self.row(i)]) });
                out.push(Observed { name: named(1, i), unit: "rad/s", value: at.v[self.row(i)] });
            }
        }
        let centre = Complex::cis(at.phase) * Self::centre(p);
        out.push(Observed { name: "ring centre", unit: "m", value: (at.q[0] + centre.re).hypot(at.q[1] + centre.im) });
        out.push(Observed { name: "moment of the balls", unit: "kg m", value: self.moment(p, at).abs() });
        for k in (0..self.tracks.len()).filter(|_| self.tracks.len() > 1) {
            out.push(Observed { name: named(3, k), unit: "kg m", value: self.moment_of(p, at, k).abs() });
        }
    }

    fn validity(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        if p.ball_radius == 0.0 {
            return;
        }
        let mut ratio = 0.0;
        for (k, track) in self.tracks.iter().enumerate() {
            let ring = self.ring(p, at, k);
            for i in track.balls.clone() {
                for j in i + 1..track.balls.end {
                    let c = laws::Contact::between(p, &ring, at, self.row(i), self.row(j));
                    let angle = c.angle;
                    let used = if self.contact { c.overlap / (0.1 * angle) } else { angle / (angle - c.overlap) };
                    // not f64::max: a state that is not a number must show
                    if !(used <= ratio) {
                        ratio = used;
                    }
                }
            }
        }
        let what = if self.contact {
            "overlap of balls in contact over a tenth of their size"
        } else {
            "size of a ball over the distance to the next"
        };
        out.push(Validity { what, ratio });
    }

    fn warnings(&self, p: &Params<Self, f64>) -> Vec<Text> {
        let steepest = |t: &Track| p.track_radius * t.radius * (p.tilt + t.tilt).sin().powi(2);
        let locking = self.tracks.iter().map(steepest).fold(0.0, f64::max);
        if self.free || !(locking > 0.1 * p.eccentricity) {
            return Vec::new();
        }
        vec![text!(
            "the tilt of the tracks locks the balls to the node line: r sin^2(tilt) = {locking} should stay below a tenth of the eccentricity of the ring, {tenth}",
            locking = text::quantity(locking, "m"),
            tenth = text::quantity(0.1 * p.eccentricity, "m")
        )]
    }

    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let mut wrong = Vec::new();
        if self.free && p.diametral_inertia == 0.0 {
            wrong.push(("diametral_inertia", text!("a free ring needs inertia about its node line: give diametral_inertia")));
        }
        if p.polar_inertia > 2.0 * p.diametral_inertia * (1.0 + 1e-12) {
            wrong.push((
                "polar_inertia",
                text!("no ring has a polar inertia ({polar_inertia}) above twice its diametral inertia ({diametral_inertia}); a thin ring has just twice", polar_inertia = text::quantity(p.polar_inertia, "kg m^2"), diametral_inertia = text::quantity(p.diametral_inertia, "kg m^2")),
            ));
        }
        if !self.free && (p.tilt_stiffness != 0.0 || p.tilt_damping != 0.0) {
            let field = if p.tilt_stiffness != 0.0 { "tilt_stiffness" } else { "tilt_damping" };
            wrong.push((field, text!("{field} acts on free rings, and these are fixed: give rings = \"free\" as well", field)));
        }
        let smallest = self.tracks.iter().map(|t| p.track_radius * t.radius).fold(f64::INFINITY, f64::min);
        if p.eccentricity >= smallest {
            let (s, r) = (text::quantity(p.eccentricity, "m"), text::quantity(smallest, "m"));
            wrong.push(("eccentricity", text!("the ring centre ({s} from the shaft) lies outside the track (radius {r})", s, r)));
        }
        for (k, track) in self.tracks.iter().enumerate() {
            let (r, n) = (p.track_radius * track.radius, track.balls.len());
            let fits = if p.ball_radius < r { (std::f64::consts::PI / (p.ball_radius / r).asin()).floor() } else { 0.0 };
            if p.ball_radius > 0.0 && (n as f64) > fits {
                wrong.push((
                    "ball_radius",
                    text!("{n} balls do not fit on track {number}: there is room for {fits}", n, number = k + 1, fits),
                ));
            }
        }
        if self.contact != (p.contact_stiffness > 0.0) {
            wrong.push(("contact_stiffness", text!("balls that touch and balls that do not are different machines: build each by itself")));
        } else if self.contact && p.ball_radius == 0.0 {
            wrong.push(("ball_radius", text!("balls that touch need their size: give ball_radius")));
        }
        wrong
    }
    fn contacts(&self) -> Option<&dyn erased::Contacts> {
        Some(self)
    }
    fn varying_inertia(&self) -> Option<&dyn erased::VaryingInertia> {
        Some(self)
    }
    fn movable_masses(&self) -> Option<&dyn erased::MovableMasses> {
        Some(self)
    }
    fn scope(&self) -> Option<&dyn erased::Scope> {
        Some(self)
    }
}

impl Contacts for BallBalancer {
    fn switches(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<f64>) {
        if !self.contact {
            return;
        }
        for (k, track) in self.tracks.iter().enumerate() {
            let ring = self.ring(p, at, k);
            for i in track.balls.clone() {
                for j in i + 1..track.balls.end {
                    let c = laws::Contact::between(p, &ring, at, self.row(i), self.row(j));
                    out.push(c.overlap);
                    out.push(1.0 + p.contact_damping * c.rate);
                }
            }
        }
    }
}

impl VaryingInertia for BallBalancer {
    #[inline(always)]
    fn inertial<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>, mass: &mut [S]) {
        self.rows(p, at, out, Some(&mut Masses { n: at.q.len(), all: mass }));
    }
}

impl MovableMasses for BallBalancer {
    fn correction(&self, p: &Params<Self, f64>, at: &At<f64>) -> Option<Correction> {
        let m = self.moment(p, at);
        let mut contact = 0.0;
        for (k, track) in self.tracks.iter().enumerate().filter(|_| self.contact) {
            let ring = self.ring(p, at, k);
            for i in track.balls.clone() {
                for j in i + 1..track.balls.end {
                    let force = laws::Contact::between(p, &ring, at, self.row(i), self.row(j)).force;
                    // not f64::max: what is not a number must show
                    if !(force <= contact) {
                        contact = force;
                    }
                }
            }
        }
        Some(Correction { moment: [m.re, m.im], capacity: self.capacity(p), contact })
    }
    fn places(&self, p: &Params<Self, f64>) -> Vec<(usize, f64)> {
        let beside = |track: &Track| {
            let angle = 2.0 * (p.ball_radius / (p.track_radius * track.radius)).asin();
            let first = track.balls.start;
            track.balls.clone().map(move |i| (self.row(i), (i - first) as f64 * angle)).collect::<Vec<_>>()
        };
        if self.contact { self.tracks.iter().flat_map(beside).collect() } else { Vec::new() }
    }
    fn grip(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<(usize, f64)>) {
        for (k, track) in self.tracks.iter().enumerate() {
            let ring = self.ring(p, at, k);
            for i in track.balls.clone() {
                let inertia = p.ball_mass * self.masses[i] * ring.radius * ring.radius;
                out.push((self.row(i), laws::grip(p, inertia, at.speed)));
            }
        }
    }
    fn outlines(&self, p: &Params<Self, f64>, at: &At<f64>) -> Vec<Outline> {
        let flat = |z: Complex<f64>| [z.re, z.im];
        let turn = Complex::cis(at.phase);
        let centre = turn * Self::centre(p);
        let displacement = [at.q[0] + centre.re, at.q[1] + centre.im];
        let mut out = Vec::new();
        for (k, track) in self.tracks.iter().enumerate() {
            let ring = self.ring(p, at, k);
            out.push(Outline { name: format!("track {}", k + 1), displacement, place: [0.0; 2], radius: ring.radius, movable: false });
            for i in track.balls.clone() {
                let (s, co) = at.q[self.row(i)].sin_cos();
                let u = turn * ring.line * Complex { re: co, im: ring.cos * s };
                let radius = if p.ball_radius > 0.0 { p.ball_radius } else { DRAWN * ring.radius };
                out.push(Outline {
                    name: format!("ball {}", i + 1),
                    displacement,
                    place: flat(u.scale(ring.radius)),
                    radius,
                    movable: true,
                });
            }
        }
        out
    }
}

impl Scope for BallBalancer {
    fn refuses_axis(&self, p: &Params<Self, f64>, axis: Axis) -> Option<Text> {
        let level = !self.body_tilt && !self.free && self.tracks.iter().all(|t| p.tilt + t.tilt == 0.0);
        (axis == Axis::Horizontal && p.gravity != 0.0 && !level)
            .then(|| text!("weight acts across a horizontal axis, not along it: give gravity = 0 (the weight across the axis is known from the machine)"))
    }
}

crate::conformance! {
    BallBalancer {
        planar: tests::balancer().planar(), tests::ring(), Options::default();
        planar_free: tests::two_tracks().planar().free(), tests::sprung(), Options::default();
        planar_rough: tests::balancer().planar(), tests::rough(), Options::default();
        planar_touching: tests::balancer().planar().touching(), tests::touching(), Options { states: 40, ..Options::default() };
        spatial: tests::balancer(), tests::ring(), Options::default();
        spatial_free: tests::two_tracks().free(), tests::sprung(), Options::default();
        spatial_rough_touching: tests::balancer().touching(), BalancerBallParams { dry_torque: 0.01, friction_rate: 80.0, ..tests::touching() },
            Options { states: 40, ..Options::default() };
    }
}
