//! The base set of the planar reference tables, with what they vary.

use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::params::Family;
use laval::model::part::Link;
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*, liquid::*};
use laval::solve::harmonic::response::{Request, Response, respond};
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
        let disc = DiscParams { mass: 2.4, eccentricity: self.e * l, eccentricity_phase: self.phase, ..DiscFamily::defaults() };
        let base = FoundationParams { mass: self.foundation, stiffness: [self.c2; 2], damping: [self.chi0; 2] };
        let law = BearingCubicParams { stiffness: [self.c0; 2], cubic_stiffness: [self.c1 / (l * l); 2], valid_to: 0.0 };
        let mut b = Builder::new("base set")
            .part("drum", Disc::planar(), disc)
            .part("base", Foundation, base)
            .part("bearing", bearing, law)
            .part("air", Damper::fixed(ground), DamperParams { damping: [self.chi; 2] });
        if let Some(r) = self.fill {
            let p = LiquidParams {
                cavity_radius: 0.07 * l,
                cavity_height: 0.06 * l,
                density: 1000.0 / (l * l * l),
                free_surface_radius: 0.07 * r * l,
                wave_damping: self.wave_damping,
            };
            b = b.part("liquid", Liquid::new(Attach::on("drum"), Fill::Partial), p);
        }
        b
    }
}

/// What nearly every test asks for.
pub fn request(lo: f64, hi: f64) -> Request {
    Request { speeds: (lo, hi), harmonics: None, symmetry: None, divisor: 1, truncation: 1e-9, stability: true, max_points: 20_000 }
}

/// Runs to the end.
pub fn run(builder: Builder, request: Request) -> Response {
    static NEVER: AtomicBool = AtomicBool::new(false);
    let system = builder.build().unwrap_or_else(|d| panic!("{:?}", d.0));
    respond(&system, &request, &NEVER, &|_| {}).unwrap()
}
