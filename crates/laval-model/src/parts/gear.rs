//! Two spur wheels in mesh on parallel shafts of different spins.
//!
//! Equations, with e = (cos a, sin a) from the centre of the first wheel to that of the second, t = (-sin a, cos a):
//!
//! ```text
//! L = t cos(phi) + e sin(phi)                                             line of action, the direction in which the first wheel pushes the second
//! d = L . (u1 - u2) + cos(phi) (r1 theta1 + r2 theta2)                    approach of the teeth
//! F = k d + c d'                                                          force of the teeth: -F L on the first wheel, F L on the second
//! torques on the wheels about their axes: -cos(phi) r1 F,  -cos(phi) r2 F
//! F0 = T / (r1 cos(phi)), of the sign of phi: -F0 L on the first wheel, F0 L on the second     force of the transmitted torque, across the axes
//! ```
//!
//! Symbols: u displacement of a wheel, m; theta its rotation relative to its spin, rad; r pitch radius, m; phi pressure angle, rad; k, c stiffness, N/m, and
//! damping, N s/m, of the mesh; T torque, N m, that the first wheel passes on or receives. The spins fit the radii, `r1 W1 + r2 W2 = 0`, so that the teeth do no work on them.
//!
//! Validity: the mean stiffness of the mesh; teeth stay in contact; no error of transmission. The transmitted torque is constant and in equilibrium with those of drive and
//! load: it loads the bearings, and does not twist the shafts. Both bodies twist: at rest they roll on each other until the teeth carry that force alone. Springs that hold the
//! rotation of both shafts take a part of it.
//!
//! Theory: `docs/theory/shafts.md#several-spins`.
//!
//! Sources: H. D. Nelson, W. L. Meacham, D. P. Fleming, A. F. Kascak, ASME J. Eng. Power 105 (1983) 606; R. Rao, T. N. Shiau, J. R. Chang, J. Sound Vib. 212 (1998) 211.

use crate::diagnostic::Diagnostics;
use crate::model::blocks::Blocks;
use crate::model::capability::Scope;
use crate::model::capability::mesh::{Mesh, Wheels};
use crate::model::erased;
use crate::model::field::{Attach, Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::{At, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, Port, PortKind};
use crate::model::spins::same_ratio;
use crate::params;
use crate::text;
use crate::text::Text;
use laval_num::scalar::Scalar;
use std::sync::Arc;

params! {
    /// Parameters of a [`Gear`].
    pub struct GearParams in GearFamily {
        first_radius: scalar, "m", Bounds::closed(1e-4, 100.0), required, "pitch radius r1 of the wheel on the first body";
        second_radius: scalar, "m", Bounds::closed(1e-4, 100.0), required, "pitch radius r2 of the wheel on the second body";
        stiffness: scalar, "N/m", Bounds::closed(1e-3, 1e15), required, "mean stiffness k of the mesh along the line of action";
        damping: scalar, "N s/m", Bounds::up_to(1e12), default 0.0, "damping c of the mesh";
        pressure_angle: scalar, "rad", Bounds::within(0.8), default 0.3490658503988659, "pressure angle phi (20 deg); negative where the other flanks carry: where the first wheel drives in the negative direction of rotation, or is driven in the positive one";
        azimuth: scalar, "rad", Bounds::within(1e3), default 0.0, "direction a from the first wheel to the second, from the x axis";
        torque: scalar, "N m", Bounds::up_to(1e12), default 0.0, "torque T at the first wheel, its size: the force of the teeth that it takes bends the shafts and loads the bearings";
    }
}

/// See the [module](self).
pub struct Gear {
    ends: [Attach; 2],
}

/// Local coordinates: x, y and twist of each wheel.
const N: usize = 6;
/// Those across the axes.
const LATERAL: [usize; 4] = [0, 1, 3, 4];

impl Gear {
    /// Between two points of bodies of different spins.
    pub fn new(first: Attach, second: Attach) -> Self {
        Gear { ends: [first, second] }
    }
    /// Derivatives of the approach of the teeth in the local coordinates.
    #[inline(always)]
    fn approach<S: Scalar>(p: &GearParams<S>) -> [S; N] {
        let ((sin, cos), (sa, ca)) = (p.pressure_angle.sin_cos(), p.azimuth.sin_cos());
        let [x, y] = [ca * sin - sa * cos, sa * sin + ca * cos];
        [x, y, p.first_radius * cos, -x, -y, p.second_radius * cos]
    }
    /// Force of the teeth that carries the transmitted torque, along the line of action.
    #[inline(always)]
    fn carried<S: Scalar>(p: &GearParams<S>) -> S {
        let size = p.torque / (p.first_radius * p.pressure_angle.cos());
        (-p.pressure_angle).select_pos(-size, size)
    }
    /// Approach and its rate.
    #[inline(always)]
    fn motion<S: Scalar>(p: &GearParams<S>, at: &At<S>) -> [S; 2] {
        let g = Self::approach(p);
        let mut d = [S::zero(); 2];
        for (i, &g) in g.iter().enumerate() {
            d[0] += g * at.q[i];
            d[1] += g * at.v[i];
        }
        d
    }
}

impl Part for Gear {
    const KIND: &'static str = "gear";
    const EXAMPLE: &'static str = r#"between = ["drum", "pinion"]
first_radius = "120 mm"
second_radius = "60 mm"                # the pinion has a spin of ratio -2
stiffness = "2e8 N/m"
"#;
    const DOC: &'static str = "Two spur wheels in mesh on parallel shafts: stiffness and damping along the line of action join their displacements and their rotations. \
        The ratio of the spins of the two bodies is that of the radii.";
    type Family = GearFamily;
    const FIELDS: &'static [Field] =
        &[Field::required("between", FieldKind::Between, "the points of the two shafts that carry the wheels")];

    fn build(values: &Values, _: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let (a, b) = values.between("between")?;
        if a.body.is_none() || b.body.is_none() {
            diagnostics.push(
                crate::diagnostic::Diagnostic::error("gear.ground", text!("a wheel sits on a turning body, not on the ground"))
                    .at(values.span_of("between"))
                    .help(text!("name the two shafts or discs that carry the wheels")),
            );
            return None;
        }
        Some(Gear::new(a, b))
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        let kind = PortKind { twist: true, ..PortKind::POINT };
        Layout { ports: self.ends.iter().map(|a| Port { kind, link: Link::On(a.clone()) }).collect(), ..Layout::default() }
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let g = Self::approach(p);
        for i in 0..N {
            for j in 0..N {
                b.stiffness[(i, j)] = p.stiffness * g[i] * g[j];
                b.damping[(i, j)] = p.damping * g[i] * g[j];
            }
        }
        let carried = Self::carried(p);
        for i in LATERAL {
            b.force[i] = -(carried * g[i]);
        }
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let ([d, rate], g, carried) = (Self::motion(p, at), Self::approach(p), Self::carried(p));
        let mut supplied = S::zero();
        for i in LATERAL {
            supplied += -(carried * g[i]) * at.v[i];
        }
        Some(Energy { stored: (p.stiffness * d * d).scale(0.5), dissipated: p.damping * rate * rate, supplied })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let [d, rate] = Self::motion(p, at);
        out.push(Observed { name: "force", unit: "N", value: p.stiffness * d + p.damping * rate + Self::carried(p) });
    }
    fn mesh(&self) -> Option<&dyn erased::Mesh> {
        Some(self)
    }
    fn scope(&self) -> Option<&dyn erased::Scope> {
        Some(self)
    }
}

impl Mesh for Gear {
    fn wheels(&self, p: &Params<Self, f64>) -> Wheels {
        Wheels { radii: [p.first_radius, p.second_radius], azimuth: p.azimuth }
    }
}

impl Scope for Gear {
    fn refuses_untwisted(&self, _: &Params<Self, f64>) -> Option<Text> {
        // with a rotation prescribed the stiffness of the teeth would hold the wheels up and carry their weight
        Some(text!("a gear joins the rotations of two bodies: say torsional = true of both"))
    }
    fn refuses_ratio(&self, p: &Params<Self, f64>, ratio: f64) -> Option<Text> {
        let needed = -p.first_radius / p.second_radius;
        (!same_ratio(ratio, needed)).then(|| {
            text!(
                "the second body turns {ratio} times as fast as the first, and by the radii {needed} times; give it a spin of that ratio",
                ratio = text::number(ratio, 6),
                needed = text::number(needed, 6)
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn gear() -> Gear {
        Gear::new(Attach::on("wheel"), Attach::on("pinion"))
    }

    pub(super) fn params() -> GearParams {
        GearParams {
            first_radius: 0.12,
            second_radius: 0.06,
            stiffness: 2e6,
            damping: 30.0,
            pressure_angle: 0.35,
            azimuth: 0.7,
            torque: 0.0,
        }
    }

    /// Wheels that turn as the ratio says, and both shafts displaced alike, do not load the teeth; the first one turned ahead pushes the second along the tangent
    /// and away.
    #[test]
    fn rolling_is_free_and_a_driving_wheel_pushes_along_and_away() {
        let p = GearParams { azimuth: 0.0, ..params() };
        let d = |q: [f64; 6]| {
            let zero = [0.0; 6];
            Gear::motion(&p, &At { q: &q, v: &zero, a: &zero, z: &[], phase: 0.0, speed: 0.0, spin_accel: 0.0, t: 0.0 })[0]
        };
        assert!(d([1e-3, 2e-3, 0.0, 1e-3, 2e-3, 0.0]).abs() < 1e-18);
        assert!(d([0.0, 0.0, 1e-3, 0.0, 0.0, -2e-3]).abs() < 1e-18);
        // turned ahead by 1 mrad: the approach is the way of its base circle
        assert!((d([0.0, 0.0, 1e-3, 0.0, 0.0, 0.0]) - 1e-3 * 0.12 * 0.35f64.cos()).abs() < 1e-18);
        let g = Gear::approach(&p);
        // the force on the second wheel is along -g: tangent and outwards
        assert!(-g[4] > 0.9 && -g[3] > 0.3 && (g[3].hypot(g[4]) - 1.0).abs() < 1e-15);
    }

    /// The torque of the force on each wheel about its axis is the transmitted one over the radius; the wheels are pushed apart on either flank.
    #[test]
    fn the_transmitted_torque_pushes_the_wheels_apart() {
        for angle in [0.35, -0.35, 0.0] {
            let p = GearParams { azimuth: 0.0, torque: 50.0, pressure_angle: angle, ..params() };
            let mut b = Blocks::default();
            b.reset(N, 0, 0.0);
            Part::linear(&gear(), &p, 0.0, &mut b);
            let size = 50.0 / (0.12 * angle.cos());
            let along = if angle < 0.0 { -50.0 / 0.12 } else { 50.0 / 0.12 };
            assert!((b.force[4] - along).abs() < 1e-10 && (b.force[1] + along).abs() < 1e-10, "{:?}", b.force);
            assert!((b.force[3] - size * angle.abs().sin()).abs() < 1e-10 && (b.force[0] + b.force[3]).abs() < 1e-10, "{:?}", b.force);
            assert!(b.force[2] == 0.0 && b.force[5] == 0.0);
        }
    }

    #[test]
    fn the_spins_fit_the_radii() {
        assert!(gear().refuses_ratio(&params(), -2.0).is_none());
        assert!(gear().refuses_ratio(&params(), 2.0).is_some_and(|t| t.contains("-2")));
    }
}

crate::conformance! {
    Gear {
        spur: tests::gear(), tests::params(), Options::anisotropic();
        loaded: tests::gear(), GearParams { torque: 40.0, pressure_angle: -0.3, ..tests::params() }, Options::anisotropic();
    }
}
