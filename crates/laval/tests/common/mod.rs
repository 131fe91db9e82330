//! Machines and tables the linear tests share.
#![allow(dead_code)]

pub mod base;
pub mod files;
pub mod planar_file;
pub mod shaft;
#[allow(unused_imports)]
pub use base::Base;

use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*, liquid::*};

/// The planar rotor of the reference tables.
#[derive(Clone, Copy)]
pub struct Planar {
    /// Foundation mass, kg.
    pub base: f64,
    /// Rotor to ground, N s/m.
    pub chi: f64,
    /// Foundation to ground, N s/m.
    pub chi0: f64,
    /// Free surface over cavity radius; 1 is empty, 0 full.
    pub fill: f64,
    /// Wave damping, 1/s.
    pub delta: f64,
    /// Unit of length: lengths are divided by it, masses and times stay.
    pub metre: f64,
}

impl Default for Planar {
    fn default() -> Self {
        Planar { base: 25.0, chi: 42.0, chi0: 6.59, fill: 1.0, delta: 0.0, metre: 1.0 }
    }
}

impl Planar {
    pub fn builder(self) -> Builder {
        let l = 1.0 / self.metre;
        let joint = || Link::Between(Attach::on("drum"), Attach::on("base"));
        let mut b = Builder::new("planar")
            .part("drum", Disc::planar(), DiscParams { eccentricity: 1e-3 * l, ..DiscParams::new(2.4) })
            .part("base", Foundation, FoundationParams { mass: self.base, stiffness: [3.26e5; 2], damping: [self.chi0; 2] })
            .part(
                "bearing",
                BearingCubic::per_axis(joint()),
                BearingCubicParams { stiffness: [1.1e7; 2], cubic_stiffness: [8.7e10 / (l * l); 2], valid_to: 0.0 },
            )
            .part(
                "air",
                Damper::fixed(Link::Between(Attach::on("drum"), Attach::ground())),
                DamperParams { damping: [self.chi; 2], tilt_damping: 0.0 },
            );
        if self.fill < 1.0 {
            let p = LiquidParams {
                wave_damping: self.delta,
                ..LiquidParams::new(0.07 * l, 0.06 * l, 1000.0 / (l * l * l), 0.07 * self.fill * l)
            };
            let fill = if self.fill > 0.0 { Fill::Partial } else { Fill::Full };
            b = b.part("liquid", Liquid::new(Attach::on("drum"), fill), p);
        }
        b
    }
    pub fn build(self) -> System {
        self.builder().build().unwrap()
    }
}

/// Rows of a reference table as words, comments and heading dropped.
pub fn rows(text: &str) -> Vec<Vec<&str>> {
    text.lines().filter(|l| !l.starts_with('#')).skip(1).map(|l| l.split(',').collect()).collect()
}

/// A number of a reference table; NaN when the cell is blank.
pub fn number(cell: &str) -> f64 {
    cell.parse().unwrap_or(f64::NAN)
}
