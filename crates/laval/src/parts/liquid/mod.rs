//! A cylindrical cavity partly filled with liquid that turns with the rotor: plane flow of an ideal liquid, exact.
//!
//! Equations, with `z` the cavity centre, `beta` and `eta` (surface displacement) in fixed axes:
//!
//! ```text
//! beta' = i W beta + g (2 i W beta + W^2 eta - z'') - 2 delta beta
//! eta'  = i W eta - beta
//! F     = -mL [g z'' + (1 - g)(2 i W beta + W^2 eta)] + i W' mo eta          on the rotor
//! spin row: (ml/2)(R^2 + r0^2) W'
//! ```
//!
//! Symbols: R cavity radius, r0 radius of the undisturbed free surface, h height, m; rho density, kg/m^3; mL = pi R^2 h rho the full cavity,
//! mo = mL (r0/R)^2, ml = mL - mo the real liquid, kg; g = (R^2 - r0^2)/(R^2 + r0^2); delta damping of the surface wave in rotor axes, 1/s; W spin
//! speed. Empty, full and partly filled are separate cases: a full cavity is frozen liquid, an empty one is nothing.
//!
//! Validity: surface displacement well below the layer thickness, cavity always wetted (W^2 r0 above the local acceleration), no viscosity but
//! delta, motion without tilt, spin-up slow against r0^2/(14.7 nu).
//!
//! Sources: `000_a291f7ede1484e56` equations (12)-(24), corrected; state form derived from the same flow.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::Blocks;
use crate::model::field::{Attach, Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Dof, DofKind, Energy, Layout, Link, Observed, Params, Part, Physics, Validity};
use crate::params;
use crate::units::{format_number, format_si};
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;
use std::f64::consts::PI;

params! {
    /// Parameters of a [`Liquid`].
    pub struct LiquidParams in LiquidFamily {
        cavity_radius: scalar, "m", Bounds::closed(1e-6, 100.0), required, "cavity radius R";
        cavity_height: scalar, "m", Bounds::closed(1e-6, 1000.0), required, "cavity height h";
        density: scalar, "kg/m^3", Bounds::closed(1e-3, 3e4), required, "liquid density rho";
        free_surface_radius: scalar, "m", Bounds::up_to(100.0), required, "radius r0 of the undisturbed free surface";
        wave_damping: scalar, "1/s", Bounds::up_to(1e6), default 0.0, "damping delta of the surface wave in rotor axes";
    }
}

/// How full the cavity is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// No liquid.
    Empty,
    /// A free surface.
    Partial,
    /// No free surface.
    Full,
}

/// See the [module](self).
pub struct Liquid {
    attach: Attach,
    fill: Fill,
}

struct Coefficients<S> {
    full: S,
    void: S,
    g: S,
}

impl Liquid {
    /// In the cavity of a body; the case must agree with the free-surface radius.
    pub fn new(attach: Attach, fill: Fill) -> Self {
        Liquid { attach, fill }
    }
    #[inline(always)]
    fn coefficients<S: Scalar>(p: &LiquidParams<S>) -> Coefficients<S> {
        let (r2, s2) = (p.cavity_radius.square(), p.free_surface_radius.square());
        let column = p.cavity_height * p.density;
        Coefficients { full: (r2 * column).scale(PI), void: (s2 * column).scale(PI), g: (r2 - s2) / (r2 + s2) }
    }
    /// Surface displacement and its rate.
    #[inline(always)]
    fn surface<S: Scalar>(at: &At<S>) -> (Complex<S>, Complex<S>) {
        let (beta, eta) = (c(at.z[0], at.z[1]), c(at.z[2], at.z[3]));
        (eta, eta.mul_i().scale(at.speed) - beta)
    }
}

const FILLS: &[(&str, &str, Bounds, &str)] = &[
    ("free_surface_radius", "m", Bounds::up_to(100.0), "radius of the undisturbed free surface"),
    ("volume_fraction", "", Bounds::closed(0.0, 1.0), "liquid volume over cavity volume"),
    ("volume", "m^3", Bounds::up_to(1e6), "liquid volume"),
    ("mass", "kg", Bounds::up_to(1e9), "liquid mass"),
];

impl Part for Liquid {
    const KIND: &'static str = "liquid";
    const DOC: &'static str = "Liquid in a cylindrical cavity that turns with a body. Partly filled cavities carry waves that can make the \
        rotor whirl by itself; the fill is given by the radius of the free surface, a volume fraction, a volume or a mass.";
    type Family = LiquidFamily;
    const FIELDS: &'static [Field] = &[
        Field::required("in", FieldKind::Attach { ground: false }, "the body whose cavity it fills"),
        Field::optional("model", FieldKind::Choice(&[("planar", "plane flow of an ideal liquid")]), "planar", "flow model"),
        Field::required("fill", FieldKind::OneOf(FILLS), "how much liquid"),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let attach = values.attach("in")?;
        let (kind, value) = values.one_of("fill")?;
        let (radius, height, density) = (params.get("cavity_radius")?, params.get("cavity_height")?, params.get("density")?);
        let cavity = PI * radius * radius * height;
        let fraction = match kind {
            "volume_fraction" => value,
            "volume" => value / cavity,
            "mass" => value / (cavity * density),
            _ => 1.0 - (value / radius) * (value / radius),
        };
        if !(0.0..=1.0 + 1e-12).contains(&fraction) {
            let (message, help) = if kind == "free_surface_radius" {
                (
                    format!(
                        "the free surface (radius {}) lies outside the cavity (radius {})",
                        format_si(value, "m"),
                        format_si(radius, "m")
                    ),
                    "the free surface is the inner face of the layer on the wall: 0 is full, the cavity radius is empty".to_string(),
                )
            } else {
                (
                    format!("this is {} times what the cavity holds", format_number(fraction, 4)),
                    format!("the cavity holds {} l, {} of this liquid", format_number(1e3 * cavity, 4), format_si(cavity * density, "kg")),
                )
            };
            diagnostics.push(Diagnostic::error("liquid.fill", message).at(values.span_of("fill")).help(help));
            return None;
        }
        let free = if kind == "free_surface_radius" { value } else { radius * (1.0 - fraction).max(0.0).sqrt() };
        params.set("free_surface_radius", free);
        let fill = if free == 0.0 {
            Fill::Full
        } else if free >= radius {
            Fill::Empty
        } else {
            Fill::Partial
        };
        Some(Liquid { attach, fill })
    }

    fn layout(&self) -> Layout {
        let mut layout = Layout::point(Link::On(self.attach.clone()));
        if self.fill == Fill::Partial {
            layout.states = Dof::pair("flow_", DofKind::VectorX, "m/s", 1.0);
            layout.states.extend(Dof::pair("surface_", DofKind::VectorX, "m", 1e-3));
        }
        layout
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }

    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, w: S, b: &mut Blocks<S>) {
        let Coefficients { full, void, g } = Self::coefficients(p);
        let (zero, one) = (S::zero(), S::one());
        match self.fill {
            Fill::Empty => {}
            Fill::Full => {
                for i in 0..2 {
                    b.mass[(i, i)] = full;
                }
            }
            Fill::Partial => {
                for i in 0..2 {
                    b.mass[(i, i)] = full * g;
                }
                let outer = full * (one - g);
                b.state_force.add_complex(0, 0, zero, (outer * w).scale(2.0));
                b.state_force.add_complex(0, 2, outer * w * w, zero);
                b.spin_accel_state_force.add_complex(0, 2, zero, -void);
                b.state.add_complex(0, 0, p.wave_damping.scale(-2.0), w + (g * w).scale(2.0));
                b.state.add_complex(0, 2, g * w * w, zero);
                b.state.add_complex(2, 0, -one, zero);
                b.state.add_complex(2, 2, zero, w);
                b.state_a.add_complex(0, 0, -g, zero);
            }
        }
    }

    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        self.polar_inertia(p) * at.spin_accel
    }

    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let Coefficients { full, void, g } = Self::coefficients(p);
        let v = c(at.v[0], at.v[1]);
        let w = at.speed;
        let spin = (self.polar_inertia(p) * w * w).scale(0.5);
        Some(match self.fill {
            Fill::Empty => Energy::zero(),
            Fill::Full => Energy { stored: (full * v.norm_sqr()).scale(0.5) + spin, ..Energy::zero() },
            Fill::Partial => {
                let (eta, rate) = Self::surface(at);
                let gamma = S::one() / g;
                let wave = (gamma * rate.norm_sqr() - (gamma + S::one()) * w * w * eta.norm_sqr()).scale(0.5) - (v * rate.conj()).re;
                let slip = rate - eta.mul_i().scale(w);
                let loss = (rate.scale(gamma) - v) * slip.conj();
                let spin_up = gamma * (rate.conj() * eta.mul_i()).re - (gamma + S::one()) * w * eta.norm_sqr();
                Energy {
                    stored: ((full - void) * v.norm_sqr()).scale(0.5) + void * wave + spin,
                    dissipated: (p.wave_damping * void * loss.re).scale(2.0),
                    supplied: void * at.spin_accel * spin_up,
                }
            }
        })
    }

    fn observe(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        if self.fill == Fill::Partial {
            out.push(Observed { name: "surface displacement", unit: "m", value: at.z[2].hypot(at.z[3]) });
        }
    }
    fn validity(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        if self.fill == Fill::Partial {
            let layer = p.cavity_radius - p.free_surface_radius;
            // the surface is measured from the cavity centre
            out.push(Validity { what: "surface excursion over layer thickness", ratio: at.z[2].hypot(at.z[3]) / layer });
            let field = at.speed * at.speed * p.free_surface_radius;
            // without spin nothing holds the layer on the wall
            let ratio = if field == 0.0 { f64::INFINITY } else { at.a[0].hypot(at.a[1]) / field };
            out.push(Validity { what: "wall acceleration over centrifugal acceleration of the layer", ratio });
        }
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, String)> {
        let fill = if p.free_surface_radius == 0.0 {
            Fill::Full
        } else if p.free_surface_radius < p.cavity_radius {
            Fill::Partial
        } else {
            Fill::Empty
        };
        if p.free_surface_radius > p.cavity_radius {
            let text = format!(
                "the free surface (radius {}) lies outside the cavity (radius {})",
                format_si(p.free_surface_radius, "m"),
                format_si(p.cavity_radius, "m")
            );
            return vec![("fill", text)];
        }
        if fill != self.fill {
            return vec![("fill", "an empty, a partly filled and a full cavity are different machines: build each by itself".into())];
        }
        Vec::new()
    }
}

impl Liquid {
    #[inline(always)]
    fn polar_inertia<S: Scalar>(&self, p: &LiquidParams<S>) -> S {
        let Coefficients { full, void, .. } = Self::coefficients(p);
        let (r2, s2) = (p.cavity_radius.square(), p.free_surface_radius.square());
        match self.fill {
            Fill::Empty => S::zero(),
            _ => ((full - void) * (r2 + s2)).scale(0.5),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::field::Value;

    pub(super) fn cavity(free: f64, wave_damping: f64) -> LiquidParams {
        LiquidParams { cavity_radius: 0.07, cavity_height: 0.06, density: 1000.0, free_surface_radius: 0.07 * free, wave_damping }
    }

    fn build(kind: &'static str, value: f64) -> (Option<Liquid>, f64, Vec<String>) {
        let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
        values.set("in", Value::Attach(Attach::on("drum")), None);
        values.set("fill", Value::OneOf(kind, value), None);
        for (name, x) in [("cavity_radius", 0.07), ("cavity_height", 0.06), ("density", 1000.0)] {
            params.set(name, x);
        }
        let part = Liquid::build(&values, &mut params, &mut d);
        (part, params.get("free_surface_radius").unwrap_or(f64::NAN), d.0.iter().map(|d| d.to_string()).collect())
    }

    #[test]
    fn four_ways_of_saying_the_fill_agree() {
        let (radius, volume) = (0.667 * 0.07, PI * 0.07 * 0.07 * 0.06);
        let fraction = 1.0 - 0.667f64 * 0.667;
        for (kind, value) in [
            ("free_surface_radius", radius),
            ("volume_fraction", fraction),
            ("volume", fraction * volume),
            ("mass", fraction * volume * 1000.0),
        ] {
            let (part, free, text) = build(kind, value);
            assert!(part.is_some_and(|l| l.fill == Fill::Partial) && text.is_empty());
            assert!((free - radius).abs() < 1e-15, "{kind}");
        }
        // 55.5 % of the volume, not a third
        assert!((fraction - 0.555).abs() < 5e-4);
    }

    #[test]
    fn empty_and_full_are_cases_of_their_own() {
        for (kind, value, fill) in [
            ("volume_fraction", 1.0, Fill::Full),
            ("free_surface_radius", 0.0, Fill::Full),
            ("volume_fraction", 0.0, Fill::Empty),
            ("free_surface_radius", 0.07, Fill::Empty),
            ("mass", 0.0, Fill::Empty),
        ] {
            assert!(build(kind, value).0.is_some_and(|l| l.fill == fill), "{kind} {value}");
        }
        let empty = Liquid::new(Attach::on("drum"), Fill::Empty);
        assert!(empty.check(&cavity(1.0, 0.0)).is_empty());
        assert!(empty.check(&cavity(0.9, 0.0))[0].1.contains("different machines"));
    }

    #[test]
    fn impossible_fills_are_told() {
        let (part, _, text) = build("free_surface_radius", 0.08);
        assert!(
            part.is_none() && text[0].starts_with("the free surface (radius 80 mm) lies outside the cavity (radius 70 mm)"),
            "{text:?}"
        );
        let (part, _, text) = build("volume_fraction", 1.2);
        assert!(part.is_none() && text[0].starts_with("this is 1.2 times what the cavity holds"), "{text:?}");
        let (part, _, text) = build("mass", 2.0);
        assert!(part.is_none() && text[0].contains("923.6 g of this liquid"), "{text:?}");
        assert!(build("volume", f64::NAN).0.is_none());
        assert!(Liquid::new(Attach::on("drum"), Fill::Partial).check(&cavity(1.1, 0.0))[0].1.contains("outside the cavity"));
    }

    #[test]
    fn without_spin_the_layer_is_outside_its_validity() {
        let liquid = Liquid::new(Attach::on("drum"), Fill::Partial);
        let ratio = |speed: f64| {
            let at = At { q: &[0.0; 2], v: &[0.0; 2], a: &[9.81, 0.0], z: &[0.0; 4], phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
            let mut out = Vec::new();
            liquid.validity(&cavity(0.667, 0.0), &at, &mut out);
            out[1].ratio
        };
        assert!(ratio(0.0) > 1.0 && ratio(5.0) > 1.0 && ratio(300.0) < 0.01);
    }
}

crate::conformance! {
    Liquid {
        partial: Liquid::new(Attach::on("drum"), Fill::Partial), tests::cavity(0.667, 0.0), Options::default();
        thin_damped: Liquid::new(Attach::on("drum"), Fill::Partial), tests::cavity(0.97, 20.0), Options::default();
        full: Liquid::new(Attach::on("drum"), Fill::Full), tests::cavity(0.0, 0.0), Options::default();
        empty: Liquid::new(Attach::on("drum"), Fill::Empty), tests::cavity(1.0, 0.0), Options::default();
    }
}
