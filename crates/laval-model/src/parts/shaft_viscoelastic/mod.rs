//! A massless shaft of viscoelastic material between two points: its force remembers the deflection (Boltzmann, Volterra).
//!
//! Equations, on the deflection `u` of the first point relative to the second, in axes that turn with the rotor or in fixed ones:
//!
//! ```text
//! f(t) = k ( u(t) - int_-inf^t G(t - t') u(t') dt' ),   Z(s) = k (1 - K(s)),   K(s) = int_0^inf G(t) exp(-s t) dt
//!
//! weakly singular (Koltunov, Rzhanitsyn)   G = sum A t^(a-1) exp(-b t)            K = sum A Gamma(a) (b + s)^-a
//! exponentials                             G = sum c exp(-lambda t), c = g lambda K = sum g lambda/(lambda + s)
//!
//! memory in rotor axes:  forward Z(s - i W), backward Z(s + i W);  spin row: -Im(conj(u) f)
//! ```
//!
//! Weakly singular kernels are exact in frequency. In time they are the sum of exponentials
//! `f = k ((1 - delta) u - sum c_k z_k)`, `z_k' = -lambda_k z_k + u` of [`kernel`], with the error measured over the stated band. Its energy:
//!
//! ```text
//! stored = k/2 (1 - delta - sum c_k/lambda_k) |u|^2 + k/2 sum (c_k/lambda_k) |u - lambda_k z_k|^2,   dissipated = k sum c_k |u - lambda_k z_k|^2
//! ```
//!
//! Stiffness k from the geometry, round shaft of diameter d, `J = pi d^4/64`, disc at x from the left support, `y = L - x`:
//!
//! ```text
//! simply supported 3 E J L/(x^2 y^2)    clamped at both ends 3 E J L^3/(x^3 y^3)    overhung by x beyond bearings at a distance L 3 E J/(x^2 (L + x))
//! cantilever 3 E J/x^3                  first bending mode between simple supports pi^4 E J/(2 L^3), on half the mass of the shaft
//! ```
//!
//! Symbols: k instantaneous stiffness, N/m; E instantaneous modulus, Pa; A amplitude, 1/s^a; a exponent; b decay, 1/s; g share of the stiffness that an
//! exponential relaxes; lambda rate, 1/s; W spin speed.
//!
//! Validity: small strain; slender shaft (no shear), mass small against what it carries; `K(0) < 1`, else the material creeps without bound. The
//! material turns with a rotor and so does its memory: memory in fixed axes belongs to supports and shafts that do not turn.
//!
//! Theory: `docs/theory/viscoelastic-shafts.md#force-and-kernel`.
//!
//! Sources: `004_a7f947693ee2e358` equations (1)-(12a), corrected; M. A. Koltunov (1976) for the kernel; A. L. Kimball (1924) for the rotor axes.

pub mod kernel;
#[cfg(test)]
mod tests;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::blocks::{Axes, Blocks, Memory};
use crate::model::capability::{Extent, FrequencyDomain};
use crate::model::erased;
use crate::model::field::{Bounds, Field, FieldKind, ParamValues, Values, Word};
use crate::model::params::{RowCounts, RowFamily, WithRows};
use crate::model::part::{At, Dof, DofKind, Domain, Energy, ErasedPart, Layout, Link, Observed, Params, Part, Physics, TimeForm};
use crate::params;
use crate::text;
use crate::text::{Joint, Text};
use kernel::{Exponential, Ladder, Term};
use laval_num::complex::{Complex, c};
use laval_num::scalar::Scalar;
use std::f64::consts::PI;
use std::sync::Arc;

params! {
    /// Parameters of a [`ShaftViscoelastic`]; those of the stiffness or of the kernel that are not used stay zero.
    pub struct ShaftViscoelasticParams in ShaftViscoelasticFamily {
        stiffness: scalar, "N/m", Bounds::up_to(1e15), default 0.0, "instantaneous stiffness k at the disc, where supports = \"given\"";
        modulus: scalar, "Pa", Bounds::up_to(1e13), default 0.0, "instantaneous modulus E of a round shaft";
        diameter: scalar, "m", Bounds::up_to(10.0), default 0.0, "diameter d of a round shaft";
        length: scalar, "m", Bounds::up_to(1e3), default 0.0, "distance L of the supports";
        position: scalar, "m", Bounds::up_to(1e3), default 0.0, "place x of the disc: distance from the left support, from the clamp of a cantilever, or overhang beyond the second bearing";
        amplitude: scalar, "", Bounds::up_to(1e9), default 0.0, "amplitude A of the kernel A t^(a-1) exp(-b t), a bare number in 1/s^a; to be given with exponent and decay unless terms or exponentials are";
        exponent: scalar, "", Bounds::up_to(0.99), default 0.0, "exponent a of the kernel, above 0";
        decay: scalar, "1/s", Bounds::up_to(1e9), default 0.0, "decay b of the kernel, above 0";
    }
}

params! {
    /// One of several terms of the kernel of a [`ShaftViscoelastic`].
    pub struct TermParams in TermFamily {
        amplitude: scalar, "", Bounds::up_to(1e9), required, "A of the term, a bare number in 1/s^a";
        exponent: scalar, "", Bounds::positive(0.99), required, "a of the term";
        decay: scalar, "1/s", Bounds::positive(1e9), required, "b of the term";
    }
}

params! {
    /// One exponential of the law of a [`ShaftViscoelastic`].
    pub struct ExponentialParams in ExponentialFamily {
        share: scalar, "", Bounds::up_to(1.0), required, "share of the stiffness that relaxes";
        rate: scalar, "1/s", Bounds::positive(1e12), required, "rate at which it relaxes, the inverse of the relaxation time";
    }
}

impl RowFamily for TermFamily {
    const LIST: &'static str = "terms";
}
impl RowFamily for ExponentialFamily {
    const LIST: &'static str = "exponentials";
}

/// Axes in which the material remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// The shaft turns with the rotor.
    Rotor,
    /// The shaft or support does not turn.
    Fixed,
}

/// How the stiffness is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Supports {
    /// As a number.
    Given,
    /// Round shaft on simple supports.
    Simple,
    /// Round shaft clamped at both ends.
    Clamped,
    /// Round shaft on two simple bearings, disc beyond the second.
    Overhung,
    /// Round shaft clamped at one end.
    Cantilever,
    /// First bending mode of a round shaft on simple supports.
    FirstMode,
}

const SUPPORTS: &[Word] = &[
    ("given", "no geometry: the stiffness is given"),
    ("simply_supported", "round shaft on simple supports"),
    ("clamped", "round shaft clamped at both ends"),
    ("overhung", "round shaft on two simple bearings, the disc beyond the second"),
    ("cantilever", "round shaft clamped at one end"),
    ("first_mode", "first bending mode of a round shaft on simple supports; the disc then has half the mass of the shaft"),
];

impl Supports {
    fn word(self) -> &'static str {
        SUPPORTS[self as usize].0
    }
    /// The dimensions it needs.
    fn needs(self) -> &'static [&'static str] {
        match self {
            Supports::Given => &["stiffness"],
            Supports::Cantilever => &["modulus", "diameter", "position"],
            Supports::FirstMode => &["modulus", "diameter", "length"],
            _ => &["modulus", "diameter", "length", "position"],
        }
    }
}

/// Weakly singular terms with their exponentials.
#[derive(Clone, Debug, PartialEq)]
pub struct Weak {
    /// The terms it was built for.
    terms: Vec<Term>,
    /// The one term is that of the parameters.
    own: bool,
    ladders: Vec<Ladder>,
    accuracy: f64,
    band: f64,
    error: f64,
}

impl Weak {
    /// The term of the parameters amplitude, exponent and decay, with exponentials that keep the relative error of the dynamic stiffness below
    /// `accuracy` for motions up to `band` (rad/s). `None` where there are no such parameters, or too many exponentials would be needed.
    pub fn single(p: &ShaftViscoelasticParams, accuracy: f64, band: f64) -> Option<Self> {
        let term = Term { amplitude: p.amplitude, exponent: p.exponent, decay: p.decay };
        let (ladders, error) = kernel::choose(&[term], accuracy, band)?;
        Some(Weak { terms: vec![term], own: true, ladders, accuracy, band, error })
    }
    /// Several terms; they are rows of the parameters.
    pub fn several(terms: Vec<Term>, accuracy: f64, band: f64) -> Option<Self> {
        let (ladders, error) = kernel::choose(&terms, accuracy, band).filter(|_| !terms.is_empty())?;
        Some(Weak { terms, own: false, ladders, accuracy, band, error })
    }
    #[inline(always)]
    fn term<S: Scalar>(&self, j: usize, p: &Params<ShaftViscoelastic, S>) -> Term<S> {
        if self.own {
            return Term { amplitude: p.amplitude, exponent: p.exponent, decay: p.decay };
        }
        let TermParams { amplitude, exponent, decay } = p.own.rows[j];
        Term { amplitude, exponent, decay }
    }
}

/// What the material remembers.
#[derive(Clone, Debug, PartialEq)]
pub enum Law {
    /// Weakly singular kernels.
    Weak(Weak),
    /// Exponentials with these rates, 1/s; share and rate of each are rows of the parameters.
    Exponentials(Vec<f64>),
}

/// See the [module](self).
pub struct ShaftViscoelastic {
    link: Link,
    frame: Frame,
    supports: Supports,
    law: Law,
}

impl ShaftViscoelastic {
    /// With a given stiffness.
    pub fn new(link: Link, frame: Frame, law: Law) -> Self {
        ShaftViscoelastic { link, frame, supports: Supports::Given, law }
    }
    /// With its stiffness from the geometry.
    pub fn on(self, supports: Supports) -> Self {
        ShaftViscoelastic { supports, ..self }
    }
    /// Instantaneous stiffness k, N/m.
    #[inline(always)]
    pub fn stiffness<S: Scalar>(&self, p: &ShaftViscoelasticParams<S>) -> S {
        let bending = p.modulus * p.diameter.square().square().scale(PI / 64.0);
        let (x, l) = (p.position, p.length);
        let y = l - x;
        match self.supports {
            Supports::Given => p.stiffness,
            Supports::Simple => bending.scale(3.0) * l / (x * y).square(),
            Supports::Clamped => bending.scale(3.0) * l * l * l / ((x * y).square() * x * y),
            Supports::Overhung => bending.scale(3.0) / (x * x * (l + x)),
            Supports::Cantilever => bending.scale(3.0) / (x * x * x),
            Supports::FirstMode => bending.scale(0.5 * PI.powi(4)) / (l * l * l),
        }
    }
    /// Number of exponentials of the time form.
    pub fn exponentials(&self) -> usize {
        match &self.law {
            Law::Weak(w) => w.ladders.iter().map(Ladder::count).sum(),
            Law::Exponentials(list) => list.len(),
        }
    }
    /// Rates of the exponentials it was built with, 1/s.
    fn built(&self) -> Vec<f64> {
        match &self.law {
            Law::Weak(w) => {
                let rates = |(l, term): (&Ladder, &Term)| (0..l.count()).map(|k| l.exponential(term, k).rate).collect::<Vec<_>>();
                w.ladders.iter().zip(&w.terms).flat_map(rates).collect()
            }
            Law::Exponentials(rates) => rates.clone(),
        }
    }
    /// delta: the part of the stiffness that is lost at once in the time form, over k.
    #[inline(always)]
    fn constant<S: Scalar>(&self, p: &Params<Self, S>) -> S {
        let mut constant = S::zero();
        if let Law::Weak(w) = &self.law {
            for (j, ladder) in w.ladders.iter().enumerate() {
                constant += ladder.constant(&w.term(j, p));
            }
        }
        constant
    }
    /// Exponential `k` of the time form.
    #[inline(always)]
    fn exponential<S: Scalar>(&self, p: &Params<Self, S>, k: usize) -> Exponential<S> {
        match &self.law {
            Law::Weak(w) => {
                let (mut j, mut k) = (0, k);
                while k >= w.ladders[j].count() {
                    k -= w.ladders[j].count();
                    j += 1;
                }
                w.ladders[j].exponential(&w.term(j, p), k)
            }
            Law::Exponentials(_) => Exponential { strength: p.rows[k].share * p.rows[k].rate, rate: p.rows[k].rate },
        }
    }
    /// K(s).
    #[inline(always)]
    fn transform<S: Scalar>(&self, p: &Params<Self, S>, s: Complex<S>) -> Complex<S> {
        let mut sum = Complex::zero();
        match &self.law {
            Law::Weak(w) => {
                for j in 0..w.ladders.len() {
                    sum += w.term(j, p).transform(s);
                }
            }
            Law::Exponentials(_) => {
                for e in &p.rows {
                    sum += (s + Complex::real(e.rate)).recip().scale(e.share * e.rate);
                }
            }
        }
        sum
    }
    /// Force of the time form on the first point, its opposite: what the rows get.
    #[inline(always)]
    fn force<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> [S; 2] {
        let k = self.stiffness(p);
        let mut past = [S::zero(); 2];
        for i in 0..self.exponentials() {
            let e = self.exponential(p, i);
            past[0] += e.strength * at.z[2 * i];
            past[1] += e.strength * at.z[2 * i + 1];
        }
        let now = S::one() - self.constant(p);
        [k * (now * at.q[0] - past[0]), k * (now * at.q[1] - past[1])]
    }
    /// K(0): the share of the stiffness that relaxes, and the field that says it.
    fn relaxed(&self, p: &Params<Self, f64>) -> (f64, &'static str) {
        match &self.law {
            Law::Weak(w) if w.own => (w.term(0, p).relaxed(), "amplitude"),
            Law::Weak(w) => ((0..w.terms.len()).map(|j| w.term(j, p).relaxed()).sum(), "terms"),
            Law::Exponentials(_) => (p.rows.iter().map(|e| e.share).sum(), "exponentials"),
        }
    }
}

/// What is said of a material that creeps without bound; how much of the kernel would do.
fn creeps(relaxed: f64) -> Text {
    text!(
        "the material creeps without bound: in the long run it would keep 1 - K(0) = {kept} of its stiffness, which must stay above 0; this kernel is \
         admissible below {share} of its amplitude",
        kept = text::number(1.0 - relaxed, 4),
        share = text::number(1.0 / relaxed, 4)
    )
}

/// Parameters that say one term.
fn parameters(term: &Term) -> ShaftViscoelasticParams {
    let &Term { amplitude, exponent, decay } = term;
    ShaftViscoelasticParams { amplitude, exponent, decay, ..ShaftViscoelasticParams::new() }
}

const KERNEL: [&str; 3] = ["amplitude", "exponent", "decay"];

/// The law a block describes; says what is wrong. Without numbers a kernel can be made of there is none.
fn law(values: &Values, params: &ParamValues, diagnostics: &mut Diagnostics) -> Option<Law> {
    let given: Vec<&str> = KERNEL.into_iter().filter(|name| params.get(name).is_some_and(|x| x != 0.0)).collect();
    let lists: Vec<&str> = ["terms", "exponentials"].into_iter().filter(|name| values.columns(name).is_some()).collect();
    let help = text!("give amplitude, exponent and decay of one weakly singular term, or several terms, or exponentials");
    if lists.len() + usize::from(!given.is_empty()) > 1 {
        let second = if lists.len() == 2 { lists[1] } else { given[0] };
        let message = text!("the memory of the material is given twice: {second} beside {first}", second, first = lists[0]);
        diagnostics.push(Diagnostic::error("shaft_viscoelastic.twice", message).at(values.span_of(second)).help(help.clone()));
        return None;
    }
    let refuse = |diagnostics: &mut Diagnostics, field: &str, message: Text| {
        diagnostics.push(Diagnostic::error("shaft_viscoelastic.kernel", message).at(values.span_of(field)).help(help.clone()));
        None
    };
    let column = |list: &str, name: &str| values.columns(list).and_then(|c| c.get(name).cloned()).unwrap_or_default();
    if lists.first() == Some(&"exponentials") {
        let (share, rate) = (column("exponentials", "share"), column("exponentials", "rate"));
        if share.len() != rate.len() || share.is_empty() {
            return refuse(diagnostics, "exponentials", text!("columns share and rate need equally many rows, at least one"));
        }
        for (k, (g, r)) in share.iter().zip(&rate).enumerate() {
            if !(*g >= 0.0 && *r > 0.0 && g.is_finite() && *r <= 1e12) {
                let row = k + 1;
                return refuse(
                    diagnostics,
                    "exponentials",
                    text!("row {row}: a share is not negative, and a rate lies between 0 and 1e12 1/s", row),
                );
            }
        }
        return Some(Law::Exponentials(rate));
    }
    let (accuracy, band) = (values.number("accuracy").unwrap_or(1e-5), values.number("band").unwrap_or(1e4));
    let terms: Vec<Term> = if lists.is_empty() {
        if given.is_empty() {
            return refuse(diagnostics, "amplitude", text!("the memory of the material is not given"));
        }
        if let Some(missing) = KERNEL[1..].iter().find(|name| !given.contains(name)) {
            return refuse(
                diagnostics,
                given[0],
                text!(
                    "the kernel A t^(a-1) exp(-b t) needs its {missing} beside {given}",
                    missing,
                    given = text::list(&given, Joint::Ands)
                ),
            );
        }
        let number = |name: &str| params.get(name).unwrap_or(f64::NAN);
        vec![Term { amplitude: number(KERNEL[0]), exponent: number(KERNEL[1]), decay: number(KERNEL[2]) }]
    } else {
        let [amplitude, exponent, decay] = KERNEL.map(|name| column("terms", name));
        if amplitude.is_empty() || exponent.len() != amplitude.len() || decay.len() != amplitude.len() {
            return refuse(diagnostics, "terms", text!("columns amplitude, exponent and decay need equally many rows, at least one"));
        }
        let rows = amplitude.into_iter().zip(exponent).zip(decay);
        let terms: Vec<Term> = rows.map(|((amplitude, exponent), decay)| Term { amplitude, exponent, decay }).collect();
        if let Some(k) = terms.iter().position(|t| !(t.is_sound() && t.exponent <= 0.99)) {
            let message = text!(
                "row {number} of the terms is no kernel: amplitude 0 or more, exponent above 0 and at most 0.99, decay above 0",
                number = k + 1
            );
            return refuse(diagnostics, "terms", message);
        }
        terms
    };
    let field = lists.first().copied().unwrap_or("amplitude");
    let relaxed: f64 = terms.iter().map(Term::relaxed).sum();
    if relaxed >= 1.0 {
        let help = text!("lower the amplitude, or raise the decay: a kernel that decays slowly relaxes more");
        diagnostics.push(Diagnostic::error("shaft_viscoelastic.creep", creeps(relaxed)).at(values.span_of(field)).help(help));
        return None;
    }
    let numbers = terms.iter().all(Term::is_sound);
    let found = if lists.is_empty() { Weak::single(&parameters(&terms[0]), accuracy, band) } else { Weak::several(terms, accuracy, band) };
    if found.is_none() && numbers {
        let message =
            text!("more than {most} exponentials would be needed for this kernel, accuracy and band in time", most = kernel::MOST);
        let help = text!("request less accuracy, a narrower band, or give a faster decay");
        diagnostics.push(Diagnostic::error("shaft_viscoelastic.terms", message).at(values.span_of("accuracy")).help(help));
    }
    found.map(Law::Weak)
}

impl Part for ShaftViscoelastic {
    const KIND: &'static str = "shaft_viscoelastic";
    const EXAMPLE: &'static str = r#"between = ["drum", "ground"]
memory = "rotor"
supports = "simply_supported"       # or give stiffness itself
modulus = "20 GPa"
diameter = "40 mm"
length = "0.6 m"
position = "0.3 m"
amplitude = 0.008                   # kernel A t^(a-1) exp(-b t): A in 1/s^a
exponent = 0.15                     # a
decay = "0.05 1/s"                  # b
"#;
    const DOC: &'static str = "A massless shaft of viscoelastic material, whose force remembers the deflection: weakly singular kernels of Koltunov and \
        Rzhanitsyn, exact in frequency and as a sum of exponentials in time, or given exponentials. The memory of a shaft turns with the rotor and \
        destabilises it above the critical speed of the long-term stiffness; memory in fixed axes, as of a support, always damps.";
    type Family = WithRows<WithRows<ShaftViscoelasticFamily, TermFamily>, ExponentialFamily>;
    const FIELDS: &'static [Field] = &[
        Field::required("between", FieldKind::Between, "the two points it joins, the carried one first"),
        Field::optional(
            "memory",
            FieldKind::Choice(&[
                ("rotor", "the material turns with the rotor and remembers in its axes"),
                ("fixed", "a support or a shaft that does not turn"),
            ]),
            "rotor",
            "axes in which the material remembers",
        ),
        Field::optional("supports", FieldKind::Choice(SUPPORTS), "given", "how the stiffness follows from the geometry"),
        Field::optional(
            "terms",
            FieldKind::Columns(&[
                ("amplitude", "", true, "A of each term, bare numbers in 1/s^a"),
                ("exponent", "", true, "a of each term"),
                ("decay", "1/s", true, "b of each term"),
            ]),
            "",
            "several weakly singular terms, instead of one amplitude, exponent and decay",
        ),
        Field::optional(
            "exponentials",
            FieldKind::Columns(&[
                ("share", "", true, "share of the stiffness that relaxes"),
                ("rate", "1/s", true, "rate at which it relaxes, the inverse of the relaxation time"),
            ]),
            "",
            "a sum of exponentials as the law itself (Prony series), instead of weakly singular terms",
        ),
        Field::optional(
            "accuracy",
            FieldKind::Quantity { unit: "", bounds: Bounds::closed(1e-10, 1e-2) },
            "1e-5",
            "relative error of the dynamic stiffness that the exponentials of weakly singular terms may make in time",
        ),
        Field::optional(
            "band",
            FieldKind::Quantity { unit: "rad/s", bounds: Bounds::closed(1e-2, 1e7) },
            "10000 rad/s",
            "highest frequency of motion, seen from the axes of the memory, at which they are that accurate",
        ),
    ];

    fn build(values: &Values, params: &mut ParamValues, diagnostics: &mut Diagnostics) -> Option<Self> {
        let link = values.between("between").map(|(a, b)| Link::Between(a, b));
        let word = values.choice("supports").unwrap_or("given");
        let all = [Supports::Given, Supports::Simple, Supports::Clamped, Supports::Overhung, Supports::Cantilever, Supports::FirstMode];
        let supports = all.into_iter().find(|s| s.word() == word)?;
        let law = law(values, params, diagnostics)?;
        let frame = if values.choice("memory") == Some("fixed") { Frame::Fixed } else { Frame::Rotor };
        Some(ShaftViscoelastic { link: link?, frame, supports, law })
    }
    #[inline(never)]
    fn erased(self) -> ErasedPart {
        Arc::new(self)
    }
    fn layout(&self) -> Layout {
        let mut layout = Layout::point(self.link.clone());
        for rate in self.built() {
            let k = layout.states.len() / 2;
            layout.states.extend(Dof::pair(&format!("memory_{}_", k + 1), DofKind::VectorX, "m s", 1e-3 / rate));
        }
        layout
    }
    fn physics(&self) -> Physics {
        match &self.law {
            Law::Weak(w) => Physics::Frequency(TimeForm::Fit(w.error)),
            Law::Exponentials(_) => Physics::Linear,
        }
    }
    fn memory(&self) -> usize {
        2 * self.exponentials()
    }
    #[inline(always)]
    fn linear<S: Scalar>(&self, p: &Params<Self, S>, _: S, b: &mut Blocks<S>) {
        let k = self.stiffness(p);
        for j in 0..self.exponentials() {
            let e = self.exponential(p, j);
            for (i, axes) in [Axes::RotorX, Axes::RotorY].into_iter().enumerate() {
                let axes = if self.frame == Frame::Rotor { axes } else { Axes::Fixed };
                b.memory.push(Memory { rate: e.rate, gain: -(k * e.strength), input: i, output: i, axes });
            }
        }
        for i in 0..2 {
            b.stiffness[(i, i)] = k * (S::one() - self.constant(p));
        }
    }
    #[inline(always)]
    fn spin_row<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> S {
        if self.frame == Frame::Fixed {
            return S::zero();
        }
        let f = self.force(p, at);
        at.q[1] * f[0] - at.q[0] * f[1]
    }
    fn energy<S: Scalar>(&self, p: &Params<Self, S>, at: &At<S>) -> Option<Energy<S>> {
        let k = self.stiffness(p);
        let (mut lost, mut kept, mut heat) = (self.constant(p), S::zero(), S::zero());
        for i in 0..self.exponentials() {
            let e = self.exponential(p, i);
            let share = e.strength / e.rate;
            let behind = (at.q[0] - e.rate * at.z[2 * i]).square() + (at.q[1] - e.rate * at.z[2 * i + 1]).square();
            lost += share;
            kept += share * behind;
            heat += e.strength * behind;
        }
        let lasting = (S::one() - lost) * (at.q[0].square() + at.q[1].square());
        Some(Energy { stored: (k * (lasting + kept)).scale(0.5), dissipated: k * heat, ..Energy::zero() })
    }
    fn observe(&self, p: &Params<Self, f64>, at: &At<f64>, out: &mut Vec<Observed>) {
        let f = self.force(p, at);
        out.push(Observed { name: "deflection", unit: "m", value: at.q[0].hypot(at.q[1]) });
        out.push(Observed { name: "force", unit: "N", value: f[0].hypot(f[1]) });
    }
    fn check(&self, p: &Params<Self, f64>) -> Vec<(&'static str, Text)> {
        let mut wrong = Vec::new();
        let (word, needs) = (self.supports.word(), self.supports.needs());
        let sizes =
            [("stiffness", p.stiffness), ("modulus", p.modulus), ("diameter", p.diameter), ("length", p.length), ("position", p.position)];
        for (name, x) in sizes {
            if needs.contains(&name) && x == 0.0 {
                let why = if self.supports == Supports::Given {
                    text!("the shaft has no stiffness: give it, or say with supports how a round shaft is held")
                } else {
                    text!("supports = \"{word}\" needs the {name} of the shaft", word, name)
                };
                wrong.push((name, why));
            } else if !needs.contains(&name) && x != 0.0 {
                wrong.push((name, text!("{name} has no effect with supports = \"{word}\"", name, word)));
            }
        }
        let between = matches!(self.supports, Supports::Simple | Supports::Clamped);
        if between && p.position >= p.length && p.length > 0.0 {
            let (x, l) = (text::quantity(p.position, "m"), text::quantity(p.length, "m"));
            wrong.push(("position", text!("the disc at {x} is not between supports at a distance of {l}", x, l)));
        }
        let (relaxed, field) = self.relaxed(p);
        // what is not a number is not admissible
        if !(relaxed < 1.0) {
            wrong.push((field, creeps(relaxed)));
            return wrong;
        }
        if let Law::Weak(w) = &self.law {
            let terms: Vec<Term> = (0..w.ladders.len()).map(|j| w.term(j, p)).collect();
            let error = if terms.iter().all(Term::is_sound) { kernel::error(&terms, &w.ladders, w.band) } else { f64::NAN };
            if !(error <= w.accuracy) {
                wrong.push((
                    field,
                    text!("the exponentials were chosen for another kernel and miss this one by more than their accuracy: build the machine with it, \
                     or widen band"),
                ));
            }
            if !w.own && [p.amplitude, p.exponent, p.decay].iter().any(|x| *x != 0.0) {
                wrong.push(("terms", text!("amplitude, exponent and decay have no effect beside several terms")));
            }
        } else if [p.amplitude, p.exponent, p.decay].iter().any(|x| *x != 0.0) {
            wrong.push(("exponentials", text!("amplitude, exponent and decay have no effect beside exponentials")));
        }
        wrong
    }
    fn frequency_domain(&self) -> Option<&dyn erased::FrequencyDomain> {
        Some(self)
    }
    #[inline(always)]
    fn extent(&self) -> Option<&dyn erased::Extent> {
        Some(self)
    }
}

impl Extent for ShaftViscoelastic {
    #[inline(always)]
    fn rows(&self) -> RowCounts {
        match &self.law {
            Law::Weak(w) if w.own => [0, 0],
            Law::Weak(w) => [w.terms.len(), 0],
            Law::Exponentials(rates) => [0, rates.len()],
        }
    }
}

impl FrequencyDomain for ShaftViscoelastic {
    #[inline(always)]
    fn impedance<S: Scalar>(&self, p: &Params<Self, S>, s: Complex<S>, speed: S, out: &mut [Complex<S>]) {
        let turn = if self.frame == Frame::Rotor { speed } else { S::zero() };
        let k = self.stiffness(p);
        let forward = (Complex::one() - self.transform(p, c(s.re, s.im - turn))).scale(k);
        let backward = (Complex::one() - self.transform(p, c(s.re, s.im + turn))).scale(k);
        let (mean, skew) = ((forward + backward).scale(S::cst(0.5)), (forward - backward).mul_i().scale(S::cst(0.5)));
        out[0] += mean;
        out[1] += skew;
        out[2] += -skew;
        out[3] += mean;
    }
    /// A branch of `(s - i W + decay)^-exponent`, cut to the left, for each term.
    fn domain(&self, p: &Params<Self, f64>, speed: f64) -> Option<Domain> {
        let Law::Weak(w) = &self.law else { return None };
        let gap = (0..w.terms.len()).map(|j| w.term(j, p).decay).fold(f64::INFINITY, f64::min);
        let place = if self.frame == Frame::Rotor { speed } else { 0.0 };
        Some(Domain { waves: vec![place], gap, terms: w.terms.len(), ..Domain::passive() })
    }
}

crate::conformance! {
    ShaftViscoelastic {
        rotor: tests::weak(Frame::Rotor), tests::params(), Options { states: 6, ..Options::default() };
        fixed: tests::weak(Frame::Fixed), tests::params(), Options { states: 6, ..Options::default() };
        several: tests::several(), tests::terms(), Options { states: 4, ..Options::default() };
        exponentials: tests::prony(Frame::Rotor), tests::shares(), Options::default();
        prony_fixed: tests::prony(Frame::Fixed), tests::shares(), Options::default();
        geometry: tests::weak(Frame::Rotor).on(Supports::Clamped), tests::round(), Options { states: 4, ..Options::default() };
    }
}
