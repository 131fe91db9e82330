//! Parts in the frequency domain: exact dynamic stiffness, and where it is analytic.

use super::super::blocks::Blocks;
use super::super::params::{Parametric, Params};
use super::scope::Tabulated;
use laval_num::complex::Complex;
use laval_num::scalar::Scalar;

/// A part given by its dynamic stiffness ([`Physics::Frequency`](super::super::part::Physics::Frequency)).
pub trait FrequencyDomain: Parametric {
    /// Adds the dynamic stiffness (N/m, row-major over local coordinates) at `s` (1/s) and spin `speed`. `Z(conj s) = conj Z(s)`.
    fn impedance<S: Scalar>(&self, p: &Params<Self, S>, s: Complex<S>, speed: S, out: &mut [Complex<S>]);
    /// Loads: forces, constant and turning with the rotor, as [`Part::linear`](super::super::part::Part::linear) has them, and in `mass` what weight acts on.
    fn load<S: Scalar>(&self, _p: &Params<Self, S>, _speed: S, _blocks: &mut Blocks<S>) {}
    /// Where the dynamic stiffness is analytic at a spin speed: the basis of a count of roots. Without it no roots are counted.
    fn domain(&self, _p: &Params<Self, f64>, _speed: f64) -> Option<Domain> {
        None
    }
    /// The same part with its dynamic stiffness to six digits only, where that costs less, above all at `Re s =` [`Domain::MARGIN`] times
    /// the speed; differentiated by s alone. Roots are counted with it and then solved for on the part itself.
    fn rough(&self) -> Option<Self> {
        None
    }
    /// An analytic function of s, up to a positive factor, with zeros at the poles that [`domain`](Self::domain) does not name, in the
    /// forward sector; 1 without such poles.
    fn regular<S: Scalar>(&self, _p: &Params<Self, S>, _s: Complex<S>, _speed: S) -> Complex<S> {
        Complex::one()
    }
    /// A form of the part with finitely many roots in place of infinitely many, and the parameters of that form, for comparison.
    fn approximation(&self, _p: &Params<Self, f64>) -> Option<(Self, Params<Self, f64>)> {
        None
    }
    /// The frequencies of vibration at which it is known, of a part whose coefficients are measured or computed at some of them: known at steady vibration alone,
    /// it is no analytic function of s, and a mode has the coefficients of its own frequency.
    fn frequencies(&self) -> Option<Tabulated> {
        None
    }
    /// Of such a part the linear one that has the coefficients of one frequency at all of them, with the same parameters.
    fn frozen(&self, _at: Frozen) -> Option<Self> {
        None
    }
}

/// The frequency of vibration whose coefficients a part has at every frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Frozen {
    /// This one, rad/s.
    At(f64),
    /// So many times the spin speed; 1 is that of the unbalance.
    Order(f64),
}

/// Where in the plane of s the dynamic stiffness of a part is analytic, and where it is large because the part has waves of its own.
/// Frequencies are those of the forward sector, in the stationary frame; the backward sector is the mirror image.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// Analytic for Re s < 0 as well as for Re s > 0.
    pub left: bool,
    /// Analytic on the imaginary axis, once multiplied by [`FrequencyDomain::regular`], except at the places in `except`.
    pub axis: bool,
    /// Frequencies, rad/s, at which singularities accumulate.
    pub except: Vec<f64>,
    /// Range of frequencies, rad/s, in which singularities are dense on the imaginary axis: there is no response to a steady load in it.
    pub dense: Option<[f64; 2]>,
    /// Range of frequencies, rad/s, in which the part has many waves with a decay rate of at least `gap`.
    pub crowded: Option<[f64; 2]>,
    /// Frequencies, rad/s, of single waves with a decay rate of at least `gap`.
    pub waves: Vec<f64>,
    /// Rate, 1/s: how far the nearest singularity is from the imaginary axis, roughly and not above it.
    pub gap: f64,
    /// Range of frequencies, rad/s, in which the part responds by the few waves of a truncated series where the whole series has no response.
    pub truncated: Option<[f64; 2]>,
    /// Terms of a series that one evaluation adds up, roughly; limits of work are counted in them.
    pub terms: usize,
    /// The same of the part that roots are counted with ([`FrequencyDomain::rough`]), at the margin.
    pub rough_terms: usize,
    /// Texts of the part for findings about all of this.
    pub words: Words,
}

/// Texts of a part for findings about singularities of its dynamic stiffness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// The part, with an article: `a part`.
    pub name: &'static str,
    /// Its waves in the dense range.
    pub waves: &'static str,
    /// What a range of frequencies is in which singularities are dense, after `frequencies from .. to ..`, and what follows for stability.
    pub dense: &'static str,
    /// Why the sign of a growth rate does not decide about stability where singularities are dense: a sentence with a leading space.
    pub slow: &'static str,
    /// What gives it a response at every order, as the beginning of a sentence without its stop.
    pub remedy: &'static str,
    /// Meaning of its response in a truncated range, as the end of a sentence without its stop.
    pub kept: &'static str,
    /// Losses inside it, where it has some.
    pub loss: &'static str,
    /// Their effect on its stability, a whole sentence with a leading space.
    pub verdict: &'static str,
    /// What decays at the rates of the branch cut left of the axis.
    pub layer: &'static str,
}

impl Words {
    /// Of a part without texts of its own.
    pub const PLAIN: Words = Words {
        name: "a part",
        waves: "waves",
        dense: "are the dense range of waves of a part: on the imaginary axis there are roots without number, and with damping outside it some of \
            them always grow, slowly. What counts is growth above a threshold; damping in the part decides about the rest.",
        slow: " With a part and damping outside it the sign of the growth says nothing: its slow waves always grow, most of them too slowly to be felt.",
        remedy: "Damping in the part gives it an answer",
        kept: "what is computed there are the few waves kept",
        loss: "damping in the parts",
        verdict: "",
        layer: "what it remembers",
    };
}

impl Domain {
    /// Least growth over the speed from which on roots are counted beside singularities that are dense on the axis.
    pub const MARGIN: f64 = 1e-3;

    /// A singularity may lie on the imaginary axis and is not removed by [`FrequencyDomain::regular`].
    pub fn touches_axis(&self) -> bool {
        !self.axis || (!self.left && !self.waves.is_empty() && !(self.gap > 0.0))
    }
    /// It has waves without internal damping: with any damping outside some of them always grow, slowly.
    pub fn undamped(&self) -> bool {
        self.left && (self.dense.is_some() || !self.except.is_empty())
    }
    /// Of a part that only dissipates: analytic for Re s >= 0.
    pub fn passive() -> Self {
        Domain {
            left: false,
            axis: true,
            except: Vec::new(),
            dense: None,
            crowded: None,
            waves: Vec::new(),
            gap: f64::INFINITY,
            truncated: None,
            terms: 1,
            rough_terms: 1,
            words: Words::PLAIN,
        }
    }
}
