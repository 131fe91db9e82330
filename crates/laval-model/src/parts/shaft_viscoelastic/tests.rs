//! The law on its own: in time, its stiffness, what is refused.

use super::*;
use crate::model::conformance::local_stiffness;
use crate::model::field::{Attach, Value};
use crate::model::params::Listed;
use laval_num::complex::C64;
use std::collections::BTreeMap;

pub(super) fn link() -> Link {
    Link::Between(Attach::on("drum"), Attach::ground())
}
pub(super) fn params() -> ShaftViscoelasticParams {
    ShaftViscoelasticParams { stiffness: 2e6, amplitude: 0.008, exponent: 0.15, decay: 0.05, ..ShaftViscoelasticParams::new() }
}
pub(super) fn round() -> ShaftViscoelasticParams {
    ShaftViscoelasticParams { stiffness: 0.0, modulus: 2e11, diameter: 0.02, length: 1.0, position: 0.3, ..params() }
}
pub(super) fn weak(frame: Frame) -> ShaftViscoelastic {
    ShaftViscoelastic::new(link(), frame, Law::Weak(Weak::single(&params(), 1e-5, 1e4).unwrap()))
}
pub(super) fn several() -> ShaftViscoelastic {
    let term = |amplitude, exponent, decay| Term { amplitude, exponent, decay };
    ShaftViscoelastic::new(
        link(),
        Frame::Rotor,
        Law::Weak(Weak::several(vec![term(0.008, 0.15, 0.05), term(0.5, 0.6, 20.0)], 1e-4, 1e4).unwrap()),
    )
}
/// Parameters of [`several`].
pub(super) fn terms() -> Params<ShaftViscoelastic, f64> {
    let own = ShaftViscoelasticParams { stiffness: 2e6, ..ShaftViscoelasticParams::new() };
    let rows = vec![TermParams::new(0.008, 0.15, 0.05), TermParams::new(0.5, 0.6, 20.0)];
    Listed { own: Listed { own, rows }, rows: Vec::new() }
}
pub(super) fn prony(frame: Frame) -> ShaftViscoelastic {
    ShaftViscoelastic::new(link(), frame, Law::Exponentials(vec![3.0, 200.0, 1e5]))
}
/// Parameters of [`prony`].
pub(super) fn shares() -> Params<ShaftViscoelastic, f64> {
    let own = ShaftViscoelasticParams { stiffness: 2e6, ..ShaftViscoelasticParams::new() };
    let rows = [[0.1, 3.0], [0.05, 200.0], [0.2, 1e5]].map(|[share, rate]| ExponentialParams { share, rate }).to_vec();
    Listed { rows, ..own.into() }
}

/// Rotating a fixed-frame law seen from the rotor is the rotor-frame law, and at standstill they are one.
#[test]
fn memory_in_rotor_axes_is_shifted_by_the_spin() {
    let z = |part: &ShaftViscoelastic, s: C64, w: f64| {
        let mut z = [C64::zero(); 4];
        part.impedance(&params().into(), s, w, &mut z);
        z
    };
    let (rotor, fixed) = (weak(Frame::Rotor), weak(Frame::Fixed));
    for s in [c(0.0, 300.0), c(-20.0, 40.0), c(5.0, -700.0)] {
        let (a, b) = (z(&rotor, s, 0.0), z(&fixed, s, 130.0));
        assert!(a.iter().zip(&b).all(|(a, b)| (*a - *b).abs() < 1e-9));
        // forward: x + i y, driven by (1, -i)
        let r = z(&rotor, s, 130.0);
        let forward = r[0] - r[1].mul_i();
        assert!((forward - z(&fixed, s - c(0.0, 130.0), 0.0)[0]).abs() < 1e-8);
        let backward = r[0] + r[1].mul_i();
        assert!((backward - z(&fixed, s + c(0.0, 130.0), 0.0)[0]).abs() < 1e-8);
    }
    // a shaft turning with a constant deflection has relaxed to its long-term stiffness
    let synchronous = z(&rotor, c(0.0, 500.0), 500.0);
    let lasting = 2e6 * (1.0 - Term { amplitude: 0.008, exponent: 0.15, decay: 0.05 }.relaxed());
    assert!((synchronous[0] - synchronous[1].mul_i() - c(lasting, 0.0)).abs() < 1e-8 * lasting);
}

/// Exponentials are exact in their blocks.
#[test]
fn exponentials_are_their_own_time_form() {
    for frame in [Frame::Rotor, Frame::Fixed] {
        let (part, p) = (prony(frame), shares());
        let mut b = Blocks::default();
        b.reset(2, 0, 80.0);
        part.linear(&p, 80.0, &mut b);
        for s in [c(0.0, 55.0), c(-3.0, 400.0)] {
            let mut z = [C64::zero(); 4];
            part.impedance(&p, s, 80.0, &mut z);
            let blocks = local_stiffness(&b, s).unwrap();
            assert!(z.iter().zip(blocks.data()).all(|(a, b)| (*a - *b).abs() < 1e-9 * 2e6));
        }
    }
}

/// What the stated error promises, beyond the frequencies it was measured at.
#[test]
fn the_stated_error_holds_between_its_points() {
    for accuracy in [1e-3, 1e-5, 1e-8] {
        let part = ShaftViscoelastic::new(link(), Frame::Fixed, Law::Weak(Weak::single(&params(), accuracy, 1e3).unwrap()));
        let Physics::Frequency(TimeForm::Fit(stated)) = Part::physics(&part) else { panic!() };
        assert!(stated <= accuracy && stated > 0.01 * accuracy);
        let mut b = Blocks::default();
        b.reset(2, 0, 0.0);
        part.linear(&params().into(), 0.0, &mut b);
        let mut worst = 0.0f64;
        for k in 0..400 {
            let s = c(0.0, 1e-4 * 10f64.powf(7.0 * f64::from(k) / 399.0));
            let mut z = [C64::zero(); 4];
            part.impedance(&params().into(), s, 0.0, &mut z);
            worst = worst.max((local_stiffness(&b, s).unwrap()[(0, 0)] - z[0]).abs() / z[0].abs());
        }
        assert!(worst < 1.1 * stated && worst > 0.01 * stated, "{worst:e} {stated:e}");
    }
}

fn build(set: &[(&str, f64)], fields: &[(&str, Value)]) -> (Option<ShaftViscoelastic>, Vec<String>) {
    let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
    values.set("between", Value::Between(Attach::on("drum"), Attach::ground()), None);
    values.set("supports", Value::Choice("given"), None);
    for (name, x) in set {
        params.set(name, *x);
    }
    for (name, v) in fields {
        values.set(name, v.clone(), None);
    }
    let part = ShaftViscoelastic::build(&values, &mut params, &mut d);
    (part, d.0.iter().map(|d| d.to_string()).collect())
}

fn columns(list: &[(&'static str, Vec<f64>)]) -> Value {
    Value::Columns(BTreeMap::from_iter(list.iter().cloned()))
}

#[test]
fn mistakes_are_reported() {
    let kernel = [("amplitude", 0.008), ("exponent", 0.15), ("decay", 0.05)];
    assert!(build(&kernel, &[]).0.is_some());
    let said = |set: &[(&str, f64)], fields: &[(&str, Value)], text: &str| {
        let (part, found) = build(set, fields);
        assert!(part.is_none() && found.len() == 1 && found[0].contains(text), "{found:?}");
    };
    said(&[], &[], "the memory of the material is not given");
    said(&kernel[..2], &[], "needs its decay beside amplitude and exponent");
    said(&[("amplitude", 0.08), ("exponent", 0.1), ("decay", 0.05)], &[], "keep 1 - K(0) = -0.02691 of its stiffness");
    let prony = columns(&[("share", vec![0.1, 0.2]), ("rate", vec![1.0, 10.0])]);
    said(&kernel, &[("exponentials", prony.clone())], "given twice: amplitude beside exponentials");
    assert!(build(&[], &[("exponentials", prony)]).0.is_some());
    said(&[], &[("exponentials", columns(&[("share", vec![0.1]), ("rate", vec![1.0, 10.0])]))], "equally many rows");
    said(&[], &[("exponentials", columns(&[("share", vec![0.1]), ("rate", vec![0.0])]))], "row 1");
    let terms = |a: f64| columns(&[("amplitude", vec![0.008, 0.01]), ("exponent", vec![0.15, a]), ("decay", vec![0.05, 3.0])]);
    assert!(build(&[], &[("terms", terms(0.5))]).0.is_some());
    said(&[], &[("terms", terms(1.0))], "row 2 of the terms is no kernel");
    let slow = columns(&[("amplitude", vec![1e-17; 20]), ("exponent", vec![0.5; 20]), ("decay", vec![1e-30; 20])]);
    said(&[], &[("terms", slow), ("accuracy", Value::Number(1e-10)), ("band", Value::Number(1e7))], "exponentials would be needed");
}

#[test]
fn parameters_are_held_together() {
    let refused = |part: &ShaftViscoelastic, p: &ShaftViscoelasticParams, field: &str, text: &str| {
        let found = part.check(&(*p).into());
        assert!(found.len() == 1 && found[0].0 == field && found[0].1.contains(text), "{found:?}");
    };
    let part = weak(Frame::Rotor);
    assert!(part.check(&params().into()).is_empty());
    // a little is within what the exponentials were chosen for, much is not
    for p in [ShaftViscoelasticParams { amplitude: 0.0085, ..params() }, ShaftViscoelasticParams { decay: 0.051, ..params() }] {
        assert_eq!(part.check(&p.into()), []);
    }
    refused(&part, &ShaftViscoelasticParams { decay: 1e-9, ..params() }, "amplitude", "creeps without bound");
    refused(&part, &ShaftViscoelasticParams { amplitude: 1e-5, decay: 1e-20, ..params() }, "amplitude", "chosen for another kernel");
    refused(&part, &ShaftViscoelasticParams { amplitude: 0.11, ..params() }, "amplitude", "creeps without bound");
    refused(&part, &ShaftViscoelasticParams { stiffness: 0.0, ..params() }, "stiffness", "has no stiffness");
    refused(&part, &ShaftViscoelasticParams { diameter: 0.01, ..params() }, "diameter", "no effect with supports = \"given\"");
    let simple = weak(Frame::Rotor).on(Supports::Simple);
    assert!(simple.check(&round().into()).is_empty());
    refused(&simple, &ShaftViscoelasticParams { position: 1.0, ..round() }, "position", "not between supports at a distance of 1 m");
    refused(&simple, &ShaftViscoelasticParams { diameter: 0.0, ..round() }, "diameter", "needs the diameter");
    let found = prony(Frame::Rotor).check(&Listed { rows: shares().rows, ..params().into() });
    assert!(found.len() == 1 && found[0].0 == "exponentials" && found[0].1.contains("no effect beside exponentials"), "{found:?}");
    // the rows are held together as the one term is
    let mut p = shares();
    p.rows[0].share = 0.9;
    assert!(prony(Frame::Rotor).check(&p)[0].1.contains("creeps without bound"));
    let mut p = terms();
    assert!(several().check(&p).is_empty());
    p.own.rows[1].decay = 1e-9;
    assert!(several().check(&p)[0].1.contains("creeps without bound"));
}
