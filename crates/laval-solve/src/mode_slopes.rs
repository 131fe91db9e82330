//! How an eigenvalue moves with the parameters of the machine.
//!
//! ```text
//! T(s; p) x = 0,  y^H T = 0:   ds/dp = -(y^H dT/dp x) / (y^H dT/ds x)
//! ```
//!
//! `dT/dp` is exact for linear and frequency-domain parts: dual numbers through their blocks and impedances. Tangents of nonlinear parts, with the equilibrium that
//! moves with the parameter, are differentiated by differences of fourth order.
//!
//! Symbols: T characteristic matrix; s = growth + i frequency; x, y its null vectors; p a parameter, or both halves of a lateral pair together.
//!
//! Validity: simple eigenvalues. Where two coincide, as those of both directions of whirl at standstill, each direction of p has slopes of its own.
//!
//! Sources: Lancaster, On eigenvalues of matrices dependent on a parameter, Numer. Math. 6 (1964).

use crate::characteristic::{Characteristic, Equilibrium};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::sectors::Sector;
use laval_num::complex::C64;
use laval_num::dense::Field;

/// An eigenvalue and its slopes.
#[derive(Clone, Debug)]
pub struct ModeSlopes {
    /// s, on the exact characteristic function.
    pub value: C64,
    /// ds/dp of each parameter; NaN where the machine cannot be had on both sides of the parameter.
    pub slopes: Vec<C64>,
}

/// The state that a machine is linearised about.
pub type Find<'a> = &'a dyn Fn(&System) -> Result<Equilibrium, Diagnostic>;

/// Step of the differences over the parameter.
const STEP: f64 = 1e-3;

/// Slopes of the eigenvalue near `near`; each parameter is a list of indices that move together. `None` where no eigenvalue is found there.
///
/// # Errors
/// As `find`.
pub fn mode_slopes(
    system: &System,
    find: Find,
    near: C64,
    sector: Option<Sector>,
    parameters: &[Vec<usize>],
) -> Result<Option<ModeSlopes>, Diagnostic> {
    let about = find(system)?;
    let mut here = Characteristic::new(system, &about);
    let Some(root) = here.polish(near, sector) else { return Ok(None) };
    let nonlinear = here.tangents_at(root.value).is_some();
    let moves = about.q.iter().chain(&about.z).any(|x| *x != 0.0);
    let mut slopes = Vec::with_capacity(parameters.len());
    for moving in parameters {
        let mut by_p = here.linear_by_parameters(root.value, moving);
        let own = |i: usize| system.slots().iter().any(|s| s.params.contains(&i) && !s.is_linear());
        if nonlinear && (moves || moving.iter().any(|&i| own(i))) {
            match tangents_by_parameter(system, find, root.value, moving) {
                Some(more) => by_p.iter_mut().zip(more).for_each(|(o, x)| *o += x),
                None => by_p.fill(C64 { re: f64::NAN, im: f64::NAN }),
            }
        }
        slopes.push(-here.product(&root, &by_p) / root.by_s);
    }
    Ok(Some(ModeSlopes { value: root.value, slopes }))
}

/// Derivative of the tangents of nonlinear parts with their equilibrium; `None` where the parameter is zero or a machine beside cannot be had.
fn tangents_by_parameter(system: &System, find: Find, s: C64, moving: &[usize]) -> Option<Vec<C64>> {
    let (slots, values) = (system.param_slots(), system.params());
    let h = STEP * values[*moving.first()?].abs();
    if !(h > 0.0) {
        return None;
    }
    let mut out: Option<Vec<C64>> = None;
    for (k, weight) in [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)] {
        let changes: Vec<(&str, f64)> = moving.iter().map(|&i| (slots[i].name.as_str(), values[i] + k * h)).collect();
        let beside = system.with(&changes).ok()?;
        let t = Characteristic::new(&beside, &find(&beside).ok()?).tangents_at(s)?;
        let sum = out.get_or_insert_with(|| vec![C64::ZERO; t.len()]);
        sum.iter_mut().zip(t).for_each(|(o, x)| *o += x.scale(weight / (12.0 * h)));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pencil::modes_about;
    use crate::rest::rest;
    use laval_model::model::builder::Builder;
    use laval_model::model::field::Attach;
    use laval_model::model::part::Link;
    use laval_model::parts::bearing_cubic::{BearingCubic, BearingCubicParams};
    use laval_model::parts::damper::{Damper, DamperParams};
    use laval_model::parts::disc::{Disc, DiscParams};
    use laval_model::parts::foundation::{Foundation, FoundationParams};

    fn machine(mass: f64, k: f64) -> System {
        let to = |body: &str| Link::Between(Attach::on("disc"), if body.is_empty() { Attach::ground() } else { Attach::on(body) });
        Builder::new("rotor")
            .part("disc", Disc::planar(), DiscParams::new(mass))
            .part("base", Foundation, FoundationParams { damping: [6.0; 2], ..FoundationParams::new(25.0, [3e5, 4e5]) })
            .part("bearing", BearingCubic::per_axis(to("base")), BearingCubicParams::new([k, 1.2 * k], [8e10; 2]))
            .part("air", Damper::fixed(to("")), DamperParams::new([40.0; 2]))
            .build()
            .unwrap()
    }

    #[test]
    fn slopes_agree_with_differences_of_the_eigenvalues() {
        let (mass, k) = (2.4, 1e7);
        let find = |s: &System| rest(s, 200.0);
        let system = machine(mass, k);
        let modes = modes_about(&system, &find(&system).unwrap(), true).unwrap().modes;
        let value = |near: C64, mass: f64, k: f64| {
            let s = machine(mass, k);
            Characteristic::new(&s, &find(&s).unwrap()).polish(near, None).unwrap().value
        };
        let path = |p: &str| system.param(p).unwrap();
        for m in &modes {
            let parameters = [path("disc.mass"), path("bearing.stiffness.x"), path("bearing.cubic_stiffness")];
            let found = mode_slopes(&system, &find, m.value, None, &parameters).unwrap().unwrap();
            let h = 1e-4 * mass;
            let by_mass = (value(m.value, mass + h, k) - value(m.value, mass - h, k)).scale(0.5 / h);
            assert!((found.slopes[0] - by_mass).abs() <= 1e-6 * by_mass.abs().max(1e-3), "{:?} {by_mass:?}", found.slopes[0]);
            // at rest the cubic term does not act
            assert!(found.slopes[2].abs() <= 1e-12 * m.value.abs() / 8e10);
        }
    }
}
