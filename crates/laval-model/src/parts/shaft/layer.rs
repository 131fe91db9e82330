//! Cylindrical layers of a shaft: sleeves on it, linings in its bore.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::Values;
use crate::text;
use crate::text::Text;

/// Columns of a layer in a file.
pub(super) const LAYER: &[(&str, &str, bool, &str)] = &[
    ("from", "m", true, "position of its lower end"),
    ("to", "m", true, "position of its upper end"),
    ("outer_diameter", "m", true, "outer diameter"),
    ("inner_diameter", "m", true, "inner diameter: of a sleeve that of the shaft under it"),
    ("modulus", "Pa", false, "Young's modulus; that of the shaft unless given"),
    ("shear_modulus", "Pa", false, "shear modulus; that of the shaft unless given"),
    ("density", "kg/m^3", false, "density; that of the shaft unless given"),
    ("stiffness", "", false, "share of its stiffness that counts, 1 unless given; 0 is a layer with mass alone"),
];

/// A cylindrical layer on a shaft or in its bore.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Positions of its ends, m.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// Inner diameter, m.
    pub inner: f64,
    /// Outer diameter, m.
    pub outer: f64,
    /// E, Pa; that of the shaft where it is not given.
    pub modulus: Option<f64>,
    /// G, Pa; that of the shaft where it is not given.
    pub shear_modulus: Option<f64>,
    /// rho, kg/m^3; that of the shaft where it is not given.
    pub density: Option<f64>,
    /// Share of its stiffness that counts; 0 is a layer that has mass alone.
    pub stiffness: f64,
}

impl Layer {
    pub(super) fn covers(&self, position: f64) -> bool {
        (self.from..=self.to).contains(&position)
    }

    /// From the columns of a file; says what is wrong with them.
    pub(super) fn read(values: &Values, length: f64, diagnostics: &mut Diagnostics) -> Option<Vec<Self>> {
        let Some(columns) = values.columns("layer") else { return Some(Vec::new()) };
        let column = |name: &str| columns.get(name);
        let rows = column("from").map_or(0, Vec::len);
        let at = |name: &str, k: usize| column(name).and_then(|c| c.get(k)).copied();
        let mut wrong = |message: Text, help: Text| {
            diagnostics.push(Diagnostic::error("shaft.layer", message).at(values.span_of("layer")).help(help));
        };
        let mut out = Vec::new();
        for k in 0..rows {
            let layer = Layer {
                from: at("from", k)?,
                to: at("to", k)?,
                inner: at("inner_diameter", k)?,
                outer: at("outer_diameter", k)?,
                modulus: at("modulus", k),
                shear_modulus: at("shear_modulus", k),
                density: at("density", k),
                stiffness: at("stiffness", k).unwrap_or(1.0),
            };
            let (number, rounding) = (k + 1, 1e-9 * length);
            let end = |z: f64| text::quantity(z, "m");
            if !(layer.from >= -rounding && layer.to <= length + rounding && layer.from < layer.to) {
                wrong(
                    text!("layer {number} goes from {from} to {to}", number, from = end(layer.from), to = end(layer.to)),
                    text!("it lies on the shaft, from its lower to its upper end: between 0 and {length}", length = end(length)),
                );
                return None;
            }
            if !(layer.inner >= 0.0 && layer.inner < layer.outer && layer.outer <= 100.0) {
                wrong(
                    text!("layer {number}: the inner diameter must be less than the outer one", number),
                    text!("inner_diameter is that of the shaft under a sleeve"),
                );
                return None;
            }
            let bounds = [(layer.modulus, 1e5, 1e13), (layer.shear_modulus, 1e5, 1e13), (layer.density, 1e-3, 1e5)];
            if bounds.iter().any(|&(x, low, high)| x.is_some_and(|x| !(low..=high).contains(&x))) || !(0.0..=1.0).contains(&layer.stiffness)
            {
                wrong(
                    text!(
                        "layer {number} has no material: modulus, shear_modulus and density are those of a solid, and stiffness is a share from 0 to 1",
                        number
                    ),
                    text!("leave out what it has in common with the shaft; stiffness = 0 is a layer with mass alone"),
                );
                return None;
            }
            out.push(layer);
        }
        Some(out)
    }
}
