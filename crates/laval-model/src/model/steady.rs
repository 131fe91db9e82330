//! The sum of the linear parts that are the same at every speed ([`is_steady`](super::capability::Extent::is_steady)), kept for the parameters of the machine: a shaft of many elements is
//! assembled once, not at every speed of a study. Loads that turn are those at 1 rad/s times the square of the speed.

use super::linear::{Form, LinearModel, LinearScratch};
use super::slot::Slot;
use super::system::System;
use laval_num::scalar::Scalar;

impl Slot {
    /// It adds the same at every speed. What turns with another spin is left out: its ratio is a parameter of another part.
    pub fn is_steady(&self) -> bool {
        self.part.is_steady() && self.is_linear() && self.ratio.is_none() && self.states.is_empty()
    }
}

impl System {
    /// The sum of the steady parts, where there are some and their parameters have the values of the machine and no derivatives.
    pub(super) fn steady<S: Scalar>(&self, params: &[S], form: Form) -> Option<&LinearModel<f64>> {
        let kept = self.steady[form as usize].get_or_init(|| {
            let any = self.slots().iter().any(Slot::is_steady);
            any.then(|| {
                let mut out = LinearModel::default();
                out.reset(self.assembly(form), self.n(), 1.0, None);
                self.add_linear(self.params(), form, Slot::is_steady, &mut out, &mut LinearScratch::default());
                out
            })
        });
        let same = |s: &Slot| s.params.clone().all(|i| (params[i] - S::cst(self.params()[i])).is_nothing());
        kept.as_ref().filter(|_| self.slots().iter().filter(|s| s.is_steady()).all(same))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::builder::Builder;
    use crate::model::erased::{D1, Evaluate};
    use crate::model::field::Attach;
    use crate::model::params::Listed;
    use crate::model::part::Link;
    use crate::parts::bearing_linear::{BearingLinear, BearingLinearParams};
    use crate::parts::disc::{Disc, DiscParams};
    use crate::parts::shaft::{SectionParams, Shaft, ShaftParams};
    use laval_num::dual::Dual;

    fn linear<S: Evaluate>(system: &System, params: &[S], speed: S, form: Form) -> LinearModel<S> {
        let mut out = LinearModel::default();
        system.linear(params, speed, form, &mut out, &mut LinearScratch::default());
        out
    }

    /// All numbers of a model: three matrices, and loads.
    fn numbers<S: Evaluate>(model: &LinearModel<S>) -> Vec<S> {
        let l = &model.loads;
        let loads = [&l.force, &l.force_cos, &l.force_sin, &l.spin_accel_force, &l.spin_accel_cos, &l.spin_accel_sin];
        let entries = (0..model.pattern().entries()).flat_map(|e| model.entry(e));
        entries.chain(model.mass_values().iter().copied()).chain(loads.into_iter().flatten().copied()).collect()
    }

    fn machine() -> System {
        let disc = DiscParams { polar_inertia: 0.02, diametral_inertia: 0.015, eccentricity: 1e-5, skew: 1e-3, ..DiscParams::new(3.0) };
        let bearing = || BearingLinearParams { kxx: 1e6, kyy: 2e6, cyy: 20.0, ..BearingLinearParams::new() };
        let own = ShaftParams { rotating_damping: 1e-5, ..ShaftParams::new() };
        let rows = vec![SectionParams::new(0.04), SectionParams { inner_diameter: 0.02, ..SectionParams::new(0.05) }];
        Builder::new("shaft")
            .horizontal()
            .part("a", BearingLinear::constant(Link::Between(Attach::at("shaft", 0.0), Attach::ground())), bearing())
            .part("shaft", Shaft::new(&[0.3, 0.5], &[0.04, 0.05]).coordinates(true, true), Listed { own, rows })
            .part("disc", Disc::tilting().on(Attach::at("shaft", 0.3)), disc)
            .part("b", BearingLinear::constant(Link::Between(Attach::at("shaft", 0.8), Attach::ground())), bearing())
            .build()
            .unwrap()
    }

    /// What is kept is what would be assembled, at every speed, with the derivative over the speed; nothing is kept for other values of parameters or derivatives over them.
    #[test]
    fn what_is_kept_is_what_would_be_assembled() {
        let system = machine();
        assert!(system.slots().iter().all(Slot::is_steady));
        for form in [Form::Time, Form::Frequency] {
            let plain: Vec<D1> = system.params().iter().map(|&x| Dual::lift(x)).collect();
            for speed in [0.0, 314.0] {
                let kept = numbers(&linear(&system, &plain, Dual::seed(speed, 0), form));
                let alone = numbers(&linear(&system, system.params(), speed, form));
                let anew = |at: f64| {
                    // a derivative over a parameter, whatever it is
                    let mut seeded = plain.clone();
                    seeded[0].eps = [1.0];
                    assert!(system.steady(&seeded, form).is_none() && system.steady(&plain, form).is_some());
                    numbers(&linear(&system, &seeded, Dual::lift(at), form))
                };
                let (here, beside) = (anew(speed), [anew(speed - 1.0), anew(speed + 1.0)]);
                let size = here.iter().fold(0.0f64, |m, x| m.max(x.re.abs()));
                assert!(here.len() == kept.len() && size > 1e6);
                let turned = linear(&system, system.params(), speed, form).loads.spin_accel_force;
                assert!(turned.iter().any(|x| *x != 0.0));
                for (k, (x, y)) in kept.iter().zip(&here).enumerate() {
                    let same = |a: f64, b: f64| (a - b).abs() <= 1e-14 * b.abs();
                    assert!(same(x.re, y.re) && same(alone[k], y.re), "{k}: {x:?} {y:?}");
                    // all is a quadratic in the speed
                    let slope = 0.5 * (beside[1][k].re - beside[0][k].re);
                    assert!((x.eps[0] - slope).abs() <= 1e-9 * (x.re.abs() + slope.abs()) + 1e-300, "{k}: {x:?} {slope}");
                }
            }
            for changed in 0..plain.len() {
                let mut other = system.params().to_vec();
                other[changed] += 0.01 + 0.01 * other[changed];
                assert!(system.steady(&other, form).is_none(), "{changed}");
            }
        }
    }
}
