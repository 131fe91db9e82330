//! Relations between the parameters of a liquid.

use super::{Fill, Liquid, LiquidParams, Model};
use crate::model::field::Bounds;
use crate::text;
use crate::text::Text;

/// Ways to say how full the cavity is.
pub(super) const FILLS: &[(&str, &str, Bounds, &str)] = &[
    ("free_surface_radius", "m", Bounds::up_to(100.0), "radius of the undisturbed free surface"),
    ("volume_fraction", "", Bounds::closed(0.0, 1.0), "liquid volume over cavity volume"),
    ("volume", "m^3", Bounds::up_to(1e6), "liquid volume"),
    ("mass", "kg", Bounds::up_to(1e9), "liquid mass"),
];

/// The free surface, m, lies outside the cavity.
pub(super) fn outside(surface: f64, radius: f64) -> Text {
    let (value, radius) = (text::quantity(surface, "m"), text::quantity(radius, "m"));
    text!("the free surface (radius {value}) lies outside the cavity (radius {radius})", value, radius)
}

impl Liquid {
    /// What is wrong with its parameters, and which.
    pub(super) fn wrong(&self, p: &LiquidParams<f64>) -> Vec<(&'static str, Text)> {
        let fill = if p.free_surface_radius == 0.0 {
            Fill::Full
        } else if p.free_surface_radius < p.cavity_radius {
            Fill::Partial
        } else {
            Fill::Empty
        };
        if p.free_surface_radius > p.cavity_radius {
            return vec![("fill", outside(p.free_surface_radius, p.cavity_radius))];
        }
        if fill != self.fill {
            return vec![("fill", text!("an empty, a partly filled and a full cavity are different machines: build each by itself"))];
        }
        let mut wrong: Vec<(&'static str, Text)> = self.outdated(p).map(|text| ("fill", text)).into_iter().collect();
        if self.model == Model::Planar && p.skew != 0.0 {
            wrong.push((
                "skew",
                text!("planar knows no tilt of the cavity: give model = \"strip\" or \"spatial\" for a cavity that is skew"),
            ));
        }
        if (p.viscosity > 0.0) != self.viscous {
            wrong.push(("viscosity", text!("a liquid with viscosity and one without are different machines: build each by itself")));
        }
        if self.viscous {
            if matches!(self.model, Model::PlanarTilt | Model::Frozen) {
                wrong.push(("viscosity", text!("this model knows no viscosity: planar, strip and spatial do")));
            } else if self.fill == Fill::Full {
                wrong.push((
                    "viscosity",
                    text!("a full cavity with viscosity is not among the models: leave viscosity out, or a little air in"),
                ));
            }
            if p.wave_damping != 0.0 {
                wrong.push(("wave_damping", text!("the viscosity damps the wave by itself: give one of the two")));
            }
        } else if p.wave_damping != 0.0 && matches!(self.model, Model::Spatial | Model::Frozen) {
            wrong.push(("wave_damping", text!("this model knows no wave damping: spatial takes a viscosity")));
        }
        wrong
    }
}
