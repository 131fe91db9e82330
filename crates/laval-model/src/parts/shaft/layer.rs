//! Cylindrical layers of a shaft: sleeves on it, linings in its bore.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Values};
use crate::model::params::RowFamily;
use crate::params;
use crate::text;
use crate::text::Text;

/// Columns of a layer in a file.
pub(super) const LAYER: &[(&str, &str, bool, &str)] = &[
    ("from", "m", true, "position of its lower end"),
    ("to", "m", true, "position of its upper end"),
    ("outer_diameter", "m", true, "outer diameter"),
    ("inner_diameter", "m", true, "inner diameter: of a sleeve that of the shaft under it"),
    ("modulus", "Pa", false, "Young's modulus; 0 where it is that of the shaft"),
    ("shear_modulus", "Pa", false, "shear modulus; 0 where it is that of the shaft"),
    ("density", "kg/m^3", false, "density; 0 where it is that of the shaft"),
    ("stiffness", "", false, "share of its stiffness that counts, 1 unless given; 0 is a layer with mass alone"),
];

params! {
    /// Parameters of a layer of a shaft.
    pub struct LayerParams in LayerFamily {
        outer_diameter: scalar, "m", Bounds::positive(100.0), required, "outer diameter";
        inner_diameter: scalar, "m", Bounds::up_to(100.0), required, "inner diameter: of a sleeve that of the shaft under it";
        modulus: scalar, "Pa", Bounds::up_to(1e13), default 0.0, "Young's modulus; 0 where it is that of the shaft";
        shear_modulus: scalar, "Pa", Bounds::up_to(1e13), default 0.0, "shear modulus; 0 where it is that of the shaft";
        density: scalar, "kg/m^3", Bounds::up_to(1e5), default 0.0, "density; 0 where it is that of the shaft";
        stiffness: scalar, "", Bounds::up_to(1.0), default 1.0, "share of its stiffness that counts; 0 is a layer with mass alone";
    }
}

impl RowFamily for LayerFamily {
    const LIST: &'static str = "layer";
}

impl LayerParams {
    /// What no bounds of one parameter say.
    pub(super) fn wrong(&self, number: usize) -> Option<(Text, Text)> {
        if !(self.inner_diameter < self.outer_diameter) {
            let message = text!("layer {number}: the inner diameter must be less than the outer one", number);
            return Some((message, text!("inner_diameter is that of the shaft under a sleeve")));
        }
        let solid = [(self.modulus, 1e5), (self.shear_modulus, 1e5), (self.density, 1e-3)];
        if solid.iter().any(|&(x, low)| x != 0.0 && !(x >= low)) || !(0.0..=1.0).contains(&self.stiffness) {
            let message = text!(
                "layer {number} has no material: modulus, shear_modulus and density are those of a solid, and stiffness is a share from 0 to 1",
                number
            );
            return Some((message, text!("leave out what it has in common with the shaft; stiffness = 0 is a layer with mass alone")));
        }
        None
    }
}

/// Where a cylindrical layer lies on a shaft or in its bore: positions of its ends, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
}

impl Layer {
    pub(super) fn covers(&self, position: f64) -> bool {
        (self.from..=self.to).contains(&position)
    }

    /// From the columns of a file; says what is wrong with them.
    pub(super) fn read(values: &Values, length: f64, diagnostics: &mut Diagnostics) -> Option<Vec<Self>> {
        let Some(columns) = values.columns("layer") else { return Some(Vec::new()) };
        let rows = columns.get("from").map_or(0, Vec::len);
        let at = |name: &str, k: usize| columns.get(name).and_then(|c| c.get(k)).copied();
        let mut wrong = |message: Text, help: Text| {
            diagnostics.push(Diagnostic::error("shaft.layer", message).at(values.span_of("layer")).help(help));
        };
        let mut out = Vec::new();
        for k in 0..rows {
            let layer = Layer { from: at("from", k)?, to: at("to", k)? };
            let (number, rounding) = (k + 1, 1e-9 * length);
            let end = |z: f64| text::quantity(z, "m");
            if !(layer.from >= -rounding && layer.to <= length + rounding && layer.from < layer.to) {
                wrong(
                    text!("layer {number} goes from {from} to {to}", number, from = end(layer.from), to = end(layer.to)),
                    text!("it lies on the shaft, from its lower to its upper end: between 0 and {length}", length = end(length)),
                );
                return None;
            }
            let or = |name: &str, absent: f64| at(name, k).unwrap_or(absent);
            let given = LayerParams {
                outer_diameter: at("outer_diameter", k)?,
                inner_diameter: at("inner_diameter", k)?,
                modulus: or("modulus", 0.0),
                shear_modulus: or("shear_modulus", 0.0),
                density: or("density", 0.0),
                stiffness: or("stiffness", 1.0),
            };
            if let Some((message, help)) = given.wrong(number) {
                wrong(message, help);
                return None;
            }
            out.push(layer);
        }
        Some(out)
    }
}
