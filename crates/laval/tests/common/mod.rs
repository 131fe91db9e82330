//! Machines that several tests share.
#![allow(dead_code)]

use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::params::Family;
use laval::model::part::Link;
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*, liquid::*};

/// Base set of the planar reference tables, with what they vary.
#[derive(Clone, Copy)]
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
}

impl Default for Base {
    fn default() -> Self {
        Base { chi: 42.0, e: 1e-3, phase: 0.0, isotropic: false, fill: None, wave_damping: 0.0, chi0: 6.59, foundation: 25.0 }
    }
}

impl Base {
    /// The machine, before assembly.
    pub fn builder(self) -> Builder {
        let link = Link::Between(Attach::on("drum"), Attach::on("base"));
        let bearing = if self.isotropic { BearingCubic::isotropic(link) } else { BearingCubic::per_axis(link) };
        let ground = Link::Between(Attach::on("drum"), Attach::ground());
        let disc = DiscParams { mass: 2.4, eccentricity: self.e, eccentricity_phase: self.phase, ..DiscFamily::defaults() };
        let base = FoundationParams { mass: self.foundation, stiffness: [3.26e5; 2], damping: [self.chi0; 2] };
        let law = BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10; 2], valid_to: 0.0 };
        let mut b = Builder::new("base set")
            .part("drum", Disc::planar(), disc)
            .part("base", Foundation, base)
            .part("bearing", bearing, law)
            .part("air", Damper::fixed(ground), DamperParams { damping: [self.chi; 2] });
        if let Some(r) = self.fill {
            let p = LiquidParams {
                cavity_radius: 0.07,
                cavity_height: 0.06,
                density: 1000.0,
                free_surface_radius: 0.07 * r,
                wave_damping: self.wave_damping,
            };
            b = b.part("liquid", Liquid::new(Attach::on("drum"), Fill::Partial), p);
        }
        b
    }
}
