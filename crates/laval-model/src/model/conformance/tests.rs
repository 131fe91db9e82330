//! Deliberately wrong parts: each check must catch its error.

use super::*;
use crate::diagnostic::Diagnostics;
use crate::model::blocks::{Axes, Memory};
use crate::model::capability::{Extent, FrequencyDomain, VaryingInertia};
use crate::model::erased;
use crate::model::field::{Attach, Bounds, Field, FieldKind, ParamValues, Values};
use crate::model::part::Layout;
use crate::model::part::{Dof, Energy, Link, TimeForm, Uses, Validity};
use crate::params;
use laval_num::complex::Complex;

params! {
    /// A spring constant.
    pub struct ToyParams in ToyFamily {
        stiffness: scalar, "N/m", Bounds::positive(1e9), required, "stiffness";
    }
}

/// What is wrong with a toy.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Wrong {
    Nothing,
    Staircase,
    SquareOfAcceleration,
    ProductWithSpinAcceleration,
    UndeclaredVelocity,
    UndeclaredSpeed,
    Lopsided,
    FeedsNothing,
    StoredDependsOnAcceleration,
    NoAccount,
    InfiniteAtRest,
    HidesNan,
    PassesNan,
    HalfPair,
    HeavierThanSaid,
    OtherBesideMasses,
}

struct Toy(Wrong);

impl Part for Toy {
    const KIND: &'static str = "toy";
    const DOC: &'static str = "A spring to the ground, right or wrong in one way.";
    type Family = ToyFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        let mut layout = Layout::point(Link::On(Attach::on("body")));
        if self.0 == Wrong::HalfPair {
            layout.own = Dof::lateral()[..1].to_vec();
        }
        layout
    }
    fn physics(&self) -> Physics {
        Physics::Nonlinear
    }
    fn uses(&self) -> Uses {
        use Wrong::*;
        Uses {
            velocity: false,
            acceleration: matches!(self.0, SquareOfAcceleration | ProductWithSpinAcceleration),
            spin: self.0 == ProductWithSpinAcceleration,
        }
    }
    fn varying_inertia(&self) -> Option<&dyn erased::VaryingInertia> {
        matches!(self.0, Wrong::HeavierThanSaid | Wrong::OtherBesideMasses).then_some(self as _)
    }
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        let k = p.stiffness;
        for i in 0..2 {
            out.force[i] += k * at.q[i];
        }
        let tiny = S::cst(1e-9);
        out.force[0] += match self.0 {
            Wrong::Staircase => (-400..400)
                .fold(S::zero(), |f, step| f + (at.q[0] - S::cst(5e-6 * f64::from(step))).select_pos(k * S::cst(5e-6), S::zero())),
            Wrong::SquareOfAcceleration => tiny * at.a[0] * at.a[0],
            Wrong::ProductWithSpinAcceleration => tiny * at.a[0] * at.spin_accel,
            Wrong::UndeclaredVelocity => tiny * at.v[1],
            Wrong::UndeclaredSpeed => tiny * at.speed,
            Wrong::Lopsided => k * at.q[0].scale(1e-9),
            Wrong::FeedsNothing => k * at.q[1].scale(1e-9),
            Wrong::InfiniteAtRest => k * (at.q[0].square() + at.q[1].square()) / at.q[0].norm2(at.q[1]),
            Wrong::HidesNan => k * (-at.q[1]).select_pos(at.q[1], at.q[0]),
            _ => S::zero(),
        };
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let stored = (p.stiffness * (at.q[0].square() + at.q[1].square())).scale(0.5);
        match self.0 {
            Wrong::NoAccount => None,
            Wrong::StoredDependsOnAcceleration => Some(Energy { stored: stored + at.a[0].square().scale(1e-9), ..Energy::zero() }),
            _ => Some(Energy { stored, ..Energy::zero() }),
        }
    }
    fn validity(&self, _: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Validity>) {
        if self.0 == Wrong::PassesNan {
            out.push(Validity { what: "deflection over range", ratio: f64::max(0.0, at.q[0]) });
        }
    }
}

impl VaryingInertia for Toy {
    fn inertial<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>, mass: &mut [S]) {
        let tiny = S::cst(1e-9);
        if self.0 == Wrong::HeavierThanSaid {
            mass[3] += tiny;
        } else {
            out.force[1] += tiny * p.stiffness * at.q[1];
        }
        self.residual(p, at, out);
    }
}

fn broken(wrong: Wrong) -> Vec<Promise> {
    let options = Options { isotropic: true, ..Options::default() };
    check(&Toy(wrong), &ToyParams { stiffness: 1e5 }, &options).iter().map(|f| f.promise).collect()
}

#[test]
fn a_right_part_keeps_its_promises() {
    assert_eq!(broken(Wrong::Nothing), []);
    assert_none(&check_fields::<Toy>());
}

#[test]
fn every_wrong_part_is_caught_by_its_own_check() {
    for (wrong, promise) in [
        (Wrong::Staircase, Promise::Tangents),
        (Wrong::SquareOfAcceleration, Promise::Affine),
        (Wrong::ProductWithSpinAcceleration, Promise::Affine),
        (Wrong::HeavierThanSaid, Promise::Inertia),
        (Wrong::OtherBesideMasses, Promise::Inertia),
        (Wrong::UndeclaredVelocity, Promise::Uses),
        (Wrong::UndeclaredSpeed, Promise::Uses),
        (Wrong::Lopsided, Promise::Isotropy),
        (Wrong::FeedsNothing, Promise::Power),
        (Wrong::StoredDependsOnAcceleration, Promise::Power),
        (Wrong::NoAccount, Promise::Power),
        (Wrong::InfiniteAtRest, Promise::Rest),
        (Wrong::HidesNan, Promise::NotANumber),
        (Wrong::PassesNan, Promise::NotANumber),
        (Wrong::HalfPair, Promise::Layout),
    ] {
        let found = broken(wrong);
        assert!(found.contains(&promise), "{wrong:?}: {found:?}");
    }
}

#[test]
fn a_capability_that_is_implemented_must_be_declared() {
    let (plain, heavy) = (declared(&Toy(Wrong::Nothing)), declared(&Toy(Wrong::HeavierThanSaid)));
    assert_eq!(undeclared(crate::implemented!(Toy), std::slice::from_ref(&plain)), ["varying_inertia"]);
    assert!(undeclared(crate::implemented!(Toy), &[plain, heavy]).is_empty());
    assert_eq!(undeclared(crate::implemented!(Linear), &[declared(&Linear(Form::WithoutImpedance))]), ["extent", "frequency_domain"]);
    assert!(undeclared(crate::implemented!(Bad), &[declared(&Bad)]).is_empty());
}

#[test]
fn isotropy_must_be_claimed_when_it_is_there() {
    let failures = check(&Toy(Wrong::Nothing), &ToyParams { stiffness: 1e5 }, &Options::anisotropic());
    assert!(failures.iter().any(|f| f.promise == Promise::Isotropy));
}

#[test]
fn a_part_that_is_not_a_number_fails() {
    let failures = check(&Toy(Wrong::Nothing), &ToyParams { stiffness: f64::NAN }, &Options::default());
    assert!(
        [Promise::Tangents, Promise::Affine, Promise::Isotropy, Promise::Power, Promise::Rest]
            .iter()
            .all(|p| failures.iter().any(|f| f.promise == *p))
    );
}

/// Linear toys: a wrong residual beside the blocks, wrong symmetries; and toys in the frequency domain.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Form {
    Right,
    ResidualBeside,
    GyroscopicNotSkew,
    SteadyBySpeed,
    Memory,
    Frequency { conjugate: bool, stated: f64 },
    WithoutImpedance,
}

struct Linear(Form);

impl Part for Linear {
    const KIND: &'static str = "linear_toy";
    const DOC: &'static str = "A spring with blocks, right or wrong in one way.";
    type Family = ToyFamily;
    const FIELDS: &'static [Field] = &[];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        let mut layout = Layout::point(Link::On(Attach::on("body")));
        if self.0 == Form::Memory {
            layout.states = [Dof::lateral(), Dof::lateral()].concat();
        }
        layout
    }
    fn memory(&self) -> usize {
        if self.0 == Form::Memory { 4 } else { 0 }
    }
    fn physics(&self) -> Physics {
        match self.0 {
            Form::Frequency { stated, .. } => Physics::Frequency(TimeForm::Fit(stated)),
            Form::WithoutImpedance => Physics::Frequency(TimeForm::Fit(1.0)),
            _ => Physics::Linear,
        }
    }
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, speed: S, b: &mut Blocks<S>) {
        for i in 0..2 {
            b.stiffness[(i, i)] = p.stiffness;
            b.damping[(i, i)] = p.stiffness * (S::one() + speed.square().scale(1e-6)).scale(1e-3);
            if self.0 == Form::Memory {
                for axes in [[Axes::Fixed, Axes::Fixed], [Axes::RotorX, Axes::RotorY]] {
                    b.memory.push(Memory { rate: S::cst(40.0), gain: p.stiffness.scale(-10.0), input: i, output: i, axes: axes[i] });
                }
            }
        }
        b.memory.sort_by_key(|m| m.axes != Axes::Fixed);
        if self.0 == Form::GyroscopicNotSkew {
            b.gyroscopic[(0, 1)] = S::cst(1.0);
        }
    }
    fn residual<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>, out: &mut Rows<S>) {
        if self.0 == Form::ResidualBeside {
            out.force[0] += p.stiffness * at.q[0];
        }
    }
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        (self.0 != Form::WithoutImpedance).then_some(self as _)
    }
    fn extent(&self) -> Option<&dyn erased::Extent> {
        (self.0 == Form::SteadyBySpeed).then_some(self as _)
    }
}

impl Extent for Linear {
    fn is_steady(&self) -> bool {
        true
    }
}

impl FrequencyDomain for Linear {
    fn impedance<S: Scalar>(&self, p: &Params<Self, S>, s: Complex<S>, speed: S, out: &mut [Complex<S>]) {
        let Form::Frequency { conjugate, .. } = self.0 else { return };
        let damping = (S::one() + speed.square().scale(1e-6)).scale(1e-3);
        for i in 0..2 {
            out[3 * i] += Complex::real(p.stiffness) + s.scale(p.stiffness * damping);
            if !conjugate {
                out[3 * i] += Complex::i().scale(p.stiffness.scale(1e-6));
            }
        }
        // what the blocks do not have
        out[1] += Complex::real(p.stiffness.scale(0.1));
    }
}

#[test]
fn wrong_linear_and_frequency_parts_are_caught() {
    let exact = |stated| Form::Frequency { conjugate: true, stated };
    for (form, expected) in [
        (Form::Right, None),
        (Form::Memory, None),
        (exact(0.2), None),
        (Form::ResidualBeside, Some(Promise::Blocks)),
        (Form::GyroscopicNotSkew, Some(Promise::Blocks)),
        (Form::SteadyBySpeed, Some(Promise::Blocks)),
        (Form::Frequency { conjugate: false, stated: 0.2 }, Some(Promise::Impedance)),
        (exact(1e-4), Some(Promise::Impedance)),
        (Form::WithoutImpedance, Some(Promise::Impedance)),
    ] {
        let options = Options { energy: false, isotropic: form != Form::GyroscopicNotSkew, ..Options::default() };
        let found: Vec<Promise> = check(&Linear(form), &ToyParams { stiffness: 1e5 }, &options).iter().map(|f| f.promise).collect();
        assert!(expected.map_or(found.is_empty(), |p| found.contains(&p)), "{form:?}: {found:?}");
    }
}

/// Eliminating memory states by hand: k z(s) with z = q/(s + rate) in fixed axes and q/(s + rate - i W) in rotor axes.
#[test]
fn local_stiffness_eliminates_memory() {
    let (speed, s) = (70.0, laval_num::complex::c(3.0, 50.0));
    let mut b = Blocks::default();
    b.reset(2, 0, speed);
    Linear(Form::Memory).linear(&ToyParams { stiffness: 2.0 }, speed, &mut b);
    let z = local_stiffness(&b, s).unwrap();
    // a forward turning vector (1, -i) sees the scalar Z = Zxx - i Zxy
    let forward = z[(0, 0)] - z[(0, 1)].mul_i();
    let one = laval_num::complex::C64::one();
    let rotor = one / (s + laval_num::complex::c(40.0, -speed));
    let fixed = one / (s + laval_num::complex::c(40.0, 0.0));
    let expected = one.scale(2.0) + s.scale(2e-3 * (1.0 + 1e-6 * speed * speed)) - (rotor + fixed).scale(20.0);
    assert!((forward - expected).abs() < 1e-13, "{forward:?} {expected:?}");
}

params! {
    /// Badly declared.
    pub struct BadParams in BadFamily {
        mass: scalar, "kg", Bounds::positive(10.0), default 0.0, "mass";
        gap_width: scalar, "furlong", Bounds::up_to(1.0), required, "";
    }
}

struct Bad;
impl Part for Bad {
    const KIND: &'static str = "bad";
    const DOC: &'static str = "Badly declared in every way.";
    type Family = BadFamily;
    const FIELDS: &'static [Field] = &[
        Field::optional("Law", FieldKind::Choice(&[("a", "one")]), "b", "law"),
        Field::required("mass", FieldKind::Flag, "twice the same name"),
    ];
    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout::default()
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
}

#[test]
fn bad_declarations_are_caught() {
    let text: Vec<String> = check_fields::<Bad>().into_iter().map(|f| f.detail).collect();
    for phrase in [
        "\"mass\" is not a word of its own",
        "\"Law\" is not a word",
        "\"gap_width\" needs a meaning",
        "furlong",
        "\"b\" of \"Law\"",
        "default 0 of \"mass\"",
    ] {
        assert!(text.iter().any(|t| t.contains(phrase)), "{phrase}: {text:?}");
    }
}
