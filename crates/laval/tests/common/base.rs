//! The base set of the planar reference tables, with what they vary.

use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::{Pair, System};
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*, liquid::*};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::response::{Request, Response, respond};
use laval::solve::harmonic::stability::floquet::Stability;
use laval_num::continuation::Zero;
use laval_num::dense::Mat;
use laval_num::newton::{Options, newton};
use std::sync::atomic::AtomicBool;

/// A rotor on a cubic bearing on a foundation.
#[derive(Clone, Copy, Debug)]
pub struct Base {
    /// Damping rotor to ground, N s/m.
    pub chi: f64,
    /// Eccentricity, m.
    pub e: f64,
    /// Direction of the eccentricity, rad.
    pub phase: f64,
    /// Same law in all directions.
    pub isotropic: bool,
    /// Free-surface radius over cavity radius; `None` is empty.
    pub fill: Option<f64>,
    /// Damping of the surface wave, 1/s.
    pub wave_damping: f64,
    /// Foundation damping, N s/m.
    pub chi0: f64,
    /// Foundation mass, kg.
    pub foundation: f64,
    /// Linear bearing stiffness, N/m.
    pub c0: f64,
    /// Cubic bearing stiffness, N/m^3.
    pub c1: f64,
    /// Foundation stiffness, N/m.
    pub c2: f64,
    /// Unit of length: lengths are divided by it, masses and times stay.
    pub metre: f64,
}

impl Default for Base {
    fn default() -> Self {
        Base {
            chi: 42.0,
            e: 1e-3,
            phase: 0.0,
            isotropic: false,
            fill: None,
            wave_damping: 0.0,
            chi0: 6.59,
            foundation: 25.0,
            c0: 1.1e7,
            c1: 8.7e10,
            c2: 3.26e5,
            metre: 1.0,
        }
    }
}

impl Base {
    /// The machine, before assembly.
    pub fn builder(self) -> Builder {
        let l = 1.0 / self.metre;
        let link = Link::Between(Attach::on("drum"), Attach::on("base"));
        let bearing = if self.isotropic { BearingCubic::isotropic(link) } else { BearingCubic::per_axis(link) };
        let ground = Link::Between(Attach::on("drum"), Attach::ground());
        let disc = DiscParams { eccentricity: self.e * l, eccentricity_phase: self.phase, ..DiscParams::new(2.4) };
        let base = FoundationParams { mass: self.foundation, stiffness: [self.c2; 2], damping: [self.chi0; 2] };
        let law = BearingCubicParams { stiffness: [self.c0; 2], cubic_stiffness: [self.c1 / (l * l); 2], valid_to: 0.0 };
        let mut b = Builder::new("base set")
            .part("drum", Disc::planar(), disc)
            .part("base", Foundation, base)
            .part("bearing", bearing, law)
            .part("air", Damper::fixed(ground), DamperParams { damping: [self.chi; 2], tilt_damping: 0.0 });
        if let Some(r) = self.fill {
            let p = LiquidParams {
                wave_damping: self.wave_damping,
                ..LiquidParams::new(0.07 * l, 0.06 * l, 1000.0 / (l * l * l), 0.07 * r * l)
            };
            b = b.part("liquid", Liquid::new(Attach::on("drum"), Fill::Partial), p);
        }
        b
    }
}

/// What nearly every test requires.
pub fn request(lo: f64, hi: f64) -> Request {
    Request { truncation: 1e-9, max_points: 20_000, ..Request::over(lo, hi) }
}

/// Runs to the end.
pub fn run(builder: Builder, request: Request) -> Response {
    static NEVER: AtomicBool = AtomicBool::new(false);
    let system = builder.build().unwrap_or_else(|d| panic!("{:?}", d.0));
    respond(&system, &request, &NEVER, &|_| {}).unwrap()
}

/// States of all branches at one speed, corrected there: unknowns of the response's discretisation, with the moduli the tables give.
pub struct Found {
    /// Unknowns.
    pub x: Vec<f64>,
    /// |Z_1| of drum and base.
    pub z: [f64; 2],
    /// |Z_1| of the deflection.
    pub deflection: f64,
    /// Backward third order of the drum.
    pub minus3: f64,
    /// Largest growth rate.
    pub growth: f64,
}

/// Moduli of a motion.
pub fn moduli(orbit: &Orbit) -> ([f64; 2], f64, f64) {
    let (a, b) = (orbit.whirl(&Pair::coordinates(0), 1).0, orbit.whirl(&Pair::coordinates(2), 1).0);
    ([a.abs(), b.abs()], (a - b).abs(), orbit.whirl(&Pair::coordinates(0), 3).1.abs())
}

/// All states of the response at a speed.
pub fn states_at(system: &System, response: &Response, range: (f64, f64), speed: f64, stability: bool) -> Vec<Found> {
    let mut balance = Balance::new(system, response.discretisation, range, None).unwrap();
    let mut assess = Stability::new(system).unwrap();
    let mut out: Vec<Found> = Vec::new();
    let n = balance.dim();
    let (mut r, mut jac) = (vec![0.0; n], Mat::zeros(n, n));
    for w in response.branches.iter().flat_map(|b| b.points.windows(2)) {
        let (a, b) = (w[0].speed, w[1].speed);
        if (a - speed) * (b - speed) > 0.0 || a == b {
            continue;
        }
        let t = (speed - a) / (b - a);
        let mut x: Vec<f64> = w[0].x.iter().zip(&w[1].x).map(|(p, q)| p + t * (q - p)).collect();
        let options = Options { to_rounding: true, ..Options::default() };
        newton(&mut balance, &mut x, speed, &options).unwrap();
        balance.eval(&x, speed, &mut r, Some(&mut jac), None).unwrap();
        let growth = if stability { assess.exponents(&mut balance, &x, speed).unwrap().growth() } else { f64::NAN };
        let orbit = Orbit::of(&mut balance, &x, speed).unwrap();
        let alone = || (orbit.whirl(&Pair::coordinates(0), 1).0.abs(), orbit.whirl(&Pair::coordinates(0), 3).1.abs());
        let (z, deflection, minus3) = if system.n() > 2 { moduli(&orbit) } else { ([alone().0, 0.0], alone().0, alone().1) };
        if !out.iter().any(|f| (f.z[0] - z[0]).abs() < 1e-9 * z[0]) {
            out.push(Found { x, z, deflection, minus3, growth });
        }
    }
    out
}

/// The machine of a table row.
pub fn table_base(fill: &str, law: &str, chi: &str) -> Base {
    let r: f64 = fill.parse().unwrap();
    Base { fill: (r < 1.0).then_some(r), isotropic: law == "isotropic", chi: chi.parse().unwrap_or(42.0), ..Base::default() }
}

/// Largest row of the assembled residual along a motion, over the largest force of a single part: forces, then rates of states.
pub fn defect(system: &System, orbit: &Orbit, divisor: usize) -> f64 {
    use laval::model::part::{At, Rows};
    use laval::model::system::Workspace;
    let (n, m) = (system.n(), system.m());
    let mut worst = 0.0f64;
    for k in 0..7 {
        let tau = 0.1 + 0.9 * f64::from(k);
        let (mut q, mut v, mut a, mut z) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; m]);
        orbit.at(tau, &mut q, &mut v, &mut a, &mut z);
        let at =
            At { q: &q, v: &v, a: &a, z: &z, phase: divisor as f64 * tau, speed: orbit.speed, spin_accel: 0.0, t: tau / orbit.frequency };
        let force = |which: &dyn Fn(&str) -> bool| {
            let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
            let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
            system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |s| which(&s.name));
            force
        };
        let size = |x: Vec<f64>| x.iter().fold(0.0f64, |m, x| if x.abs() > m || x.is_nan() { x.abs() } else { m });
        let largest = system.slots().iter().map(|s| size(force(&|name| name == s.name))).fold(0.0, f64::max);
        let rest = size(force(&|_| true)) / largest;
        if rest > worst || rest.is_nan() {
            worst = rest;
        }
    }
    worst
}
