//! Motion of a particle by integration: drag that depends on the Reynolds number, variable speed, a swinging
//! cup.
//!
//! Equations: those of [`super::particle`] with the accelerations of [`super::frame`], together with the cup's own motion ([`super::cup`]), whose second
//! rate enters the particle's at the same instant.
//!
//! Integration stops at the jump of the law of Schiller and Naumann (0.4 % at Re = 1000) and continues with
//! the other piece.
//!
//! Validity: as there; the liquid co-rotates with the cup without delay.
//!
//! Sources: `docs/theory/separation.md#equation-of-motion`, `docs/theory/separation.md#run-up`.

use super::cup::SwingingCup;
use super::exit::{Exit, MOST, Vessel};
use super::frame::{Pose, coriolis, gravity, transport};
use super::particle::{Drag, Medium, Particle, TURBULENT, transitional, turbulent};
use super::ramp::Ramp;
use super::vessel::Inside;
use laval_model::text;
use laval_model::text::Text;
use laval_num::dense::Mat;
use laval_num::dual::Dual;
use laval_num::ode::{Control, Direction, Dop853, End, Event, Failure, Method, Ode, Radau, Run, Step, StiffOde, Tolerance, integrate};
use laval_num::scalar::Scalar;

/// How the cup is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tilt {
    /// At this tilt, rad, with its mouth (the origin of the cup's axes) at this radius, m.
    Fixed {
        /// Tilt, rad.
        tilt: f64,
        /// Radius, m.
        hinge: f64,
    },
    /// On its hinge.
    Swinging(SwingingCup),
}

/// One particle in one vessel.
#[derive(Clone, Debug)]
pub struct Journey {
    /// The liquid.
    pub medium: Medium,
    /// The particle.
    pub particle: Particle,
    /// The spin speed.
    pub ramp: Ramp,
    /// How the cup is held.
    pub tilt: Tilt,
    /// The liquid it moves in.
    pub vessel: Inside,
}

/// Position, velocity, and tilt with its rate.
pub const STATES: usize = 8;
type D = Dual<f64, STATES>;

/// The equations, with the piece of the drag law that holds.
struct Equations<'a> {
    j: &'a Journey,
    /// Coefficient of the drag without its dependence on Re, acceleration per velocity.
    two_n: f64,
    kappa: f64,
    coriolis: f64,
    /// Beyond the jump of the drag law.
    turbulent: bool,
    /// Reynolds number at which the piece ends.
    threshold: f64,
}

impl Equations<'_> {
    /// Goes on with the other piece of the drag law. Where the larger drag beyond the jump brings the particle back below it and the
    /// smaller one drives it up again, it stays at the jump: the piece beyond then holds a little below as well.
    fn change(&mut self, t: f64, y: &[f64; STATES], per_speed: f64) {
        let growth = |e: &Self| {
            let mut dy = [0.0; STATES];
            e.rates(t, y, &mut dy);
            per_speed * (y[3] * dy[3] + y[4] * dy[4] + y[5] * dy[5])
        };
        self.turbulent = !self.turbulent;
        let caught = self.turbulent && growth(self) < 0.0;
        self.threshold = if caught { CAUGHT * TURBULENT } else { TURBULENT };
    }

    fn rates<S: Scalar>(&self, t: f64, y: &[S], dy: &mut [S]) {
        let (speed, accel) = self.j.ramp.at(t);
        let (speed, accel) = (S::cst(speed), S::cst(accel));
        let (tilt, rate) = (y[6], y[7]);
        let rate_accel = match &self.j.tilt {
            Tilt::Fixed { .. } => S::zero(),
            Tilt::Swinging(cup) => cup.acceleration(speed, tilt, rate),
        };
        let pose = Pose { speed, accel, tilt, rate, rate_accel };
        let (r, v) = ([y[0], y[1], y[2]], [y[3], y[4], y[5]]);
        let (ae, ac, g) = (transport(&pose, self.j.hinge(), r), coriolis(&pose, v), gravity(&pose, self.j.medium.gravity));
        let drag = match self.j.medium.drag {
            Drag::Stokes => S::cst(self.two_n),
            Drag::SchillerNaumann => {
                let re = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt().scale(self.j.medium.reynolds(&self.j.particle, 1.0));
                let f = if self.turbulent { turbulent(re) } else { transitional(re) };
                f.scale(self.two_n)
            }
        };
        for i in 0..3 {
            dy[i] = v[i];
            dy[3 + i] = (g[i] - ae[i]).scale(self.kappa) - ac[i].scale(self.coriolis) - drag * v[i];
        }
        dy[6] = rate;
        dy[7] = rate_accel;
    }
}

impl Ode for Equations<'_> {
    fn dim(&self) -> usize {
        STATES
    }
    fn rhs(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Failure> {
        self.rates(t, y, dy);
        Ok(())
    }
}

impl StiffOde for Equations<'_> {
    fn jacobian(&mut self, t: f64, y: &[f64], jac: &mut Mat) -> Result<(), Failure> {
        let seeded: [D; STATES] = std::array::from_fn(|i| D::seed(y[i], i));
        let mut dy = [D::zero(); STATES];
        self.rates(t, &seeded, &mut dy);
        for (i, d) in dy.iter().enumerate() {
            for k in 0..STATES {
                jac[(i, k)] = d.eps[k];
            }
        }
        Ok(())
    }
}

/// State of a journey at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Time, s.
    pub t: f64,
    /// x, y, z, m; velocities, m/s; tilt, rad; its rate, rad/s.
    pub state: [f64; STATES],
}

/// How a journey ended, and the moments requested.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrival {
    /// The exit, unless the time ran out first.
    pub exit: Option<Exit>,
    /// At the times requested that were reached.
    pub moments: Vec<Moment>,
    /// At the end.
    pub last: Moment,
    /// Largest Reynolds number at the steps.
    pub reynolds: f64,
    /// Steps of the integration.
    pub steps: u64,
    /// An implicit method was used.
    pub stiff: bool,
}

/// Why a journey could not be computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lost(pub Text);

/// Changes of the piece of the drag law before the journey counts as caught at the jump.
const MOST_PIECES: usize = 200;
/// Share of the Reynolds number of the jump down to which the piece beyond holds for a particle caught there.
const CAUGHT: f64 = 0.99;
/// Product of drag rate and duration above which the implicit method works.
const STIFF: f64 = 2e4;

impl Journey {
    /// Radius of the hinge (of the mouth of a fixed tube), m.
    pub fn hinge(&self) -> f64 {
        match &self.tilt {
            Tilt::Fixed { hinge, .. } => *hinge,
            Tilt::Swinging(cup) => cup.hinge,
        }
    }

    /// State at the start: at rest relative to the cup; a swinging cup hangs as it does at the first speed.
    pub fn start(&self, position: [f64; 3]) -> [f64; STATES] {
        self.start_from(position, [0.0; 3])
    }

    /// The same at a velocity relative to the cup, m/s.
    pub fn start_from(&self, position: [f64; 3], velocity: [f64; 3]) -> [f64; STATES] {
        let tilt = match &self.tilt {
            Tilt::Fixed { tilt, .. } => *tilt,
            Tilt::Swinging(cup) => cup.equilibrium(self.ramp.at(0.0).0),
        };
        let ([x, y, z], [vx, vy, vz]) = (position, velocity);
        [x, y, z, vx, vy, vz, tilt, 0.0]
    }

    /// Follows the particle from `start` until it leaves the liquid, at most to `t_end`, with the local error `tolerance` (relative); `outputs` are
    /// times in increasing order.
    ///
    /// # Errors
    /// When the integration fails.
    pub fn follow(&self, start: [f64; STATES], t_end: f64, tolerance: f64, outputs: &[f64]) -> Result<Arrival, Lost> {
        let rates = self.medium.rates(&self.particle);
        let stiff = rates.two_n * t_end > STIFF;
        let mut equations =
            Equations { j: self, two_n: rates.two_n, kappa: rates.kappa, coriolis: rates.coriolis, turbulent: false, threshold: TURBULENT };
        let per_speed = self.medium.reynolds(&self.particle, 1.0);
        let reynolds = |y: &[f64]| per_speed * (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]).sqrt();
        let mut out = Arrival { exit: None, moments: vec![], last: Moment { t: 0.0, state: start }, reynolds: 0.0, steps: 0, stiff };
        let (mut t, mut y) = (0.0, start);
        let knots: Vec<f64> = self.ramp.knots().filter(|&k| k > 0.0 && k < t_end).chain([t_end]).collect();
        let mut pieces = 0;
        for until in knots {
            while t < until {
                let mut leg = Leg { t, y, until, tolerance, outputs, reynolds: &reynolds, out: &mut out };
                let end = if stiff { leg.run(&mut Radau::new(), &mut equations)? } else { leg.run(&mut Dop853::new(), &mut equations)? };
                (t, y) = (leg.t, leg.y);
                match end {
                    Leaves::Vessel => {
                        out.last = Moment { t, state: y };
                        return Ok(out);
                    }
                    Leaves::Piece => {
                        pieces += 1;
                        if pieces > MOST_PIECES {
                            return Err(Lost(text!("the drag law changes its piece again and again at {t}", t = text::quantity(t, "s"))));
                        }
                        equations.change(t, &y, per_speed);
                    }
                    Leaves::Nothing => {}
                }
            }
        }
        out.last = Moment { t, state: y };
        Ok(out)
    }
}

/// What a leg of the integration ended with.
enum Leaves {
    Vessel,
    Piece,
    Nothing,
}

/// What an event watches.
type Gauge<'a> = dyn Fn(f64, &[f64]) -> f64 + 'a;

struct Leg<'a> {
    t: f64,
    y: [f64; STATES],
    until: f64,
    tolerance: f64,
    outputs: &'a [f64],
    reynolds: &'a dyn Fn(&[f64]) -> f64,
    out: &'a mut Arrival,
}

impl Leg<'_> {
    fn control<'c>(&self, vessel: &Inside) -> Control<'c> {
        let (length, speed) = (vessel.length(), vessel.length() / self.until.max(1e-300));
        let a = 1e-2 * self.tolerance;
        let absolute = [length, length, length, speed, speed, speed, 1.0, 1.0].map(|x: f64| a * x.max(1e-3));
        Control::new(Tolerance::All(self.tolerance), Tolerance::Each(absolute.to_vec()))
    }

    fn run<'e, M: Method<Equations<'e>>>(&mut self, method: &mut M, equations: &mut Equations<'e>) -> Result<Leaves, Lost> {
        let vessel = equations.j.vessel;
        let gap = |i: usize| move |_: f64, y: &[f64]| vessel.gaps([y[0], y[1], y[2]], [y[3], y[4], y[5]])[i].value;
        let watched: [_; MOST] = std::array::from_fn(gap);
        let (reynolds, threshold) = (self.reynolds, equations.threshold);
        let re = move |_: f64, y: &[f64]| reynolds(y) - threshold;
        let falling = |g| Event::new(g).direction(Direction::Falling).terminal();
        let mut events: Vec<_> = watched.iter().map(|g| falling(g as &Gauge)).collect();
        if equations.j.medium.drag == Drag::SchillerNaumann {
            let way = if equations.turbulent { Direction::Falling } else { Direction::Rising };
            events.push(Event::new(&re).direction(way).terminal());
        }
        // a particle that starts outside, or on a surface and on its way out, leaves at once
        let mut dy = [0.0; STATES];
        equations.rates(self.t, &self.y, &mut dy);
        let start = vessel.gaps([self.y[0], self.y[1], self.y[2]], [self.y[3], self.y[4], self.y[5]]);
        let push = vessel.gaps([self.y[0], self.y[1], self.y[2]], [dy[3], dy[4], dy[5]]);
        if let Some(i) = (0..MOST).find(|&i| start[i].value < 0.0 || (start[i].value == 0.0 && start[i].rate + 1e-3 * push[i].rate < 0.0)) {
            self.arrive(&vessel, i);
            return Ok(Leaves::Vessel);
        }
        let outputs: Vec<f64> = self.outputs.iter().copied().filter(|&o| o >= self.t && o <= self.until).collect();
        let outputs: Vec<f64> = outputs.into_iter().filter(|o| self.out.moments.last().is_none_or(|m| m.t < *o)).collect();
        let mut control = self.control(&vessel);
        (control.events, control.outputs) = (&events, &outputs);
        let mut watch = Watch { last: (self.t, self.y), moments: vec![], reynolds: 0.0, re: self.reynolds };
        let mut y = self.y;
        let run = integrate(method, equations, self.t, &mut y, self.until, &control, &mut watch);
        self.out.steps += run.work.steps;
        self.out.reynolds = self.out.reynolds.max(watch.reynolds);
        self.out.moments.extend(watch.moments);
        let start = watch.last;
        (self.t, self.y) = (run.t, y);
        match run.end {
            End::Reached => Ok(Leaves::Nothing),
            End::Event { index, t } => {
                let gauge: &Gauge = watched.get(index).map_or(&re, |g| g);
                let g = |y: &[f64; STATES]| gauge(0.0, y);
                let (t, y) = polish(method, equations, &self.control(&vessel), start, t, g)?;
                (self.t, self.y) = (t, y);
                if index < MOST {
                    self.arrive(&vessel, index);
                    Ok(Leaves::Vessel)
                } else {
                    Ok(Leaves::Piece)
                }
            }
            _ => Err(lost(&run)),
        }
    }

    fn arrive(&mut self, vessel: &Inside, index: usize) {
        let y = &self.y;
        let (position, velocity) = ([y[0], y[1], y[2]], [y[3], y[4], y[5]]);
        let surface = vessel.gaps(position, velocity)[index].surface;
        self.out.exit = Some(Exit { time: self.t, surface, position, velocity });
    }
}

fn lost(run: &Run) -> Lost {
    match &run.end {
        End::Failed { what, .. } => Lost(text!("{what}", what)),
        End::StepTooSmall { t, .. } => Lost(text!("the step became too small at {t}", t = text::quantity(*t, "s"))),
        _ => Lost(text!("stopped at {t} after {steps} steps", t = text::quantity(run.t, "s"), steps = run.work.steps)),
    }
}

/// The interpolant of a step is less exact than the step: integrates to the event itself and corrects by Newton steps.
fn polish<'e, M: Method<Equations<'e>>>(
    method: &mut M,
    equations: &mut Equations<'e>,
    control: &Control,
    (t0, y0): (f64, [f64; STATES]),
    t: f64,
    g: impl Fn(&[f64; STATES]) -> f64,
) -> Result<(f64, [f64; STATES]), Lost> {
    let (mut at, mut y) = (t0, y0);
    let mut target = t;
    for _ in 0..4 {
        if target != at {
            let run = integrate(method, equations, at, &mut y, target, control, &mut ());
            if run.end != End::Reached {
                return Err(lost(&run));
            }
            at = target;
        }
        let mut dy = [0.0; STATES];
        equations.rates(at, &y, &mut dy);
        // rate of the gap by a difference along the motion that is exact for quadratics
        let h = 1e-6 * (t - t0).abs().max(1e-9 * t.abs());
        let moved = |k: f64| std::array::from_fn::<f64, STATES, _>(|i| y[i] + k * h * dy[i]);
        let rate = (g(&moved(1.0)) - g(&moved(-1.0))) / (2.0 * h);
        let step = g(&y) / rate;
        // NaN ends here
        if !(step.abs() > 4.0 * f64::EPSILON * at.abs() && step.abs() < (t - t0).abs()) {
            break;
        }
        target = at - step;
    }
    Ok((at, y))
}

struct Watch<'a> {
    last: (f64, [f64; STATES]),
    moments: Vec<Moment>,
    reynolds: f64,
    re: &'a dyn Fn(&[f64]) -> f64,
}

impl laval_num::ode::Observer for Watch<'_> {
    fn dense(&self) -> bool {
        false
    }
    fn step(&mut self, step: &Step<'_>) {
        self.last.0 = step.t0;
        self.last.1.copy_from_slice(step.y0);
        self.reynolds = self.reynolds.max((self.re)(step.y1));
    }
    fn output(&mut self, _: usize, t: f64, y: &[f64]) {
        let mut state = [0.0; STATES];
        state.copy_from_slice(y);
        self.moments.push(Moment { t, state });
    }
}
