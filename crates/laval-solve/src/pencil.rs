//! Linearisation about an equilibrium, its first-order pencil `E x' = A x` over (q, v, z), and its modes.
//!
//! ```text
//! M q'' + C q' + K q + Z z = 0,    z' = Rq q + Rv q' + Ra q'' + Rz z
//! ```
//!
//! in fixed axes at rest, in rotating axes about a turning state (`v -> R (v + W J q)`, coefficients constant for a machine without preferred
//! direction). Such a machine is solved sector by sector, so that forward and backward whirls of one frequency never mix.

use super::characteristic::{Characteristic, Equilibrium, Frame};
use super::machine_mode::Unknowns;
pub use super::machine_mode::{FLAT, MachineMode, Whirl};
use super::roots::{Request, in_region, roots};
use super::sectors::{Sector, Sectors, block};
use super::ties::settle_modes;
use crate::diagnostic::Diagnostic;
use crate::model::part::{At, Physics, TimeForm};
use crate::model::system::System;
use crate::model::tangent::{Tangent, TangentScratch};
use laval_model::text;
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};
use laval_num::eig::{self, EigError, Number};
use serde::{Deserialize, Serialize};

/// Matrices of the linearised machine.
#[derive(Clone, Debug)]
pub struct Linearised {
    /// M, C, K: n x n.
    pub mass: Mat,
    /// C with gyroscopic terms.
    pub damping: Mat,
    /// K with circulatory terms.
    pub stiffness: Mat,
    /// Z: n x m.
    pub state_force: Mat,
    /// Rq, Rv, Ra: m x n; Rz: m x m.
    pub rates: [Mat; 4],
    unknowns: Unknowns,
    isotropic: bool,
}

/// Modes of one block of the problem that is solved by itself, with vectors for following them.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Family {
    /// Sector; `None` when the machine is solved as a whole.
    pub sector: Option<Sector>,
    /// Eigenvalues and biorthogonal vectors; signed frequencies in the forward sector, Im >= 0 elsewhere.
    pub modes: Vec<eig::Mode>,
}

/// All modes at one speed.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Spectrum {
    /// By frequency.
    pub modes: Vec<MachineMode>,
    /// As solved.
    pub families: Vec<Family>,
    /// Infinite eigenvalues (coordinates without mass).
    pub infinite: usize,
    /// Number of modes polished on the exact characteristic function.
    pub polished: usize,
    /// Eigenvalues of the pencil that are no roots of the machine: they stand for the branch cut of a part given in the frequency domain.
    pub left_out: usize,
}

impl Spectrum {
    /// Drops the vectors: of many speeds they would take most of the memory.
    pub fn forget_vectors(&mut self) {
        self.families.clear();
        self.modes.iter_mut().for_each(|m| *m = m.without_vectors());
    }
    /// Drops the vectors and keeps the values of all families.
    pub fn keep_values(&mut self) {
        self.modes.iter_mut().for_each(|m| *m = m.without_vectors());
        for m in self.families.iter_mut().flat_map(|f| &mut f.modes) {
            (m.right, m.left) = (Vec::new(), Vec::new());
        }
    }
    /// All but free motions along and about the axis.
    pub fn held(&self) -> impl Iterator<Item = &MachineMode> {
        self.modes.iter().filter(|m| !m.is_free())
    }
    /// Largest growth rate and its mode; free motions are not among them.
    pub fn least_stable(&self) -> Option<&MachineMode> {
        self.held().max_by(|a, b| a.value.re.total_cmp(&b.value.re))
    }
}

/// Parts that have no time form, so that no eigenvalue problem of finite size holds them; `Err` names the first.
pub fn time_forms(system: &System) -> Result<Vec<(String, f64)>, Diagnostic> {
    let mut fits = Vec::new();
    for slot in system.slots() {
        match slot.physics {
            Physics::Frequency(TimeForm::None(why)) => {
                return Err(Diagnostic::error(
                    "modes.frequency_only",
                    text!("\"{name}\" is given in the frequency domain only: {why}", name = slot.name, why = text::term(why)),
                )
                .at(slot.span.clone())
                .help(text!("forced_response works with it, and modes about rest where the part says where it is analytic")));
            }
            Physics::Frequency(TimeForm::Fit(error)) => fits.push((slot.name.clone(), error)),
            _ => {}
        }
    }
    Ok(fits)
}

/// Eigenvalues want polishing: the pencil holds a fit, or memory states whose rates spoil its scale.
pub fn wants_polish(system: &System) -> bool {
    system.slots().iter().any(|s| s.memory > 0 || matches!(s.physics, Physics::Frequency(_)))
}

/// A part given in the frequency domain enters the pencil by a fit.
pub fn holds_fit(system: &System) -> bool {
    system.slots().iter().any(|s| matches!(s.physics, Physics::Frequency(_)))
}

/// Largest coupling of sectors, relative, that counts as rounding.
pub(super) const ISOTROPIC: f64 = 1e-11;

impl Linearised {
    /// About an equilibrium.
    ///
    /// # Errors
    /// A part without time form.
    pub fn new(system: &System, about: &Equilibrium) -> Result<Self, Diagnostic> {
        time_forms(system)?;
        Ok(Self::of_time_forms(system, about))
    }

    /// The same with some coordinates held: each by itself, with roots at minus once and twice `rate` (1/s).
    pub fn holding(mut self, coordinates: &[usize], rate: f64) -> Self {
        for &i in coordinates {
            for m in [&mut self.mass, &mut self.damping, &mut self.stiffness] {
                for j in 0..m.rows() {
                    (m[(i, j)], m[(j, i)]) = (0.0, 0.0);
                }
            }
            for j in 0..self.state_force.cols() {
                self.state_force[(i, j)] = 0.0;
            }
            for m in &mut self.rates[..3] {
                for j in 0..m.rows() {
                    m[(j, i)] = 0.0;
                }
            }
            (self.mass[(i, i)], self.damping[(i, i)], self.stiffness[(i, i)]) = (1.0, 3.0 * rate, 2.0 * rate * rate);
        }
        self
    }

    /// About an equilibrium; parts that have no time form are left out.
    pub(super) fn of_time_forms(system: &System, about: &Equilibrium) -> Self {
        let unknowns = Unknowns::of(system);
        let Unknowns { coordinates, states, .. } = &unknowns;
        let (v, a) = (about.velocity(coordinates), about.acceleration(coordinates));
        let w = about.speed;
        let at = At { q: &about.q, v: &v, a: &a, z: &about.z, phase: 0.0, speed: w, spin_accel: 0.0, t: 0.0 };
        let (mut t, mut ts) = (Tangent::default(), TangentScratch::default());
        let timed = |s: &crate::model::system::Slot| !matches!(s.physics, Physics::Frequency(TimeForm::None(_)));
        system.tangent(&at, false, &mut t, &mut ts, timed);
        if about.frame == Frame::Turning {
            for (m, d, k) in [(&t.a, &mut t.v, &mut t.q), (&t.rate_a, &mut t.rate_v, &mut t.rate_q)] {
                let (mj, dj) = (coordinates.times_quarter_turn(m), coordinates.times_quarter_turn(d));
                let mjj = coordinates.times_quarter_turn(&mj);
                add(k, w, &dj);
                add(k, w * w, &mjj);
                add(d, 2.0 * w, &mj);
            }
            add(&mut t.rate_z, -w, &states.times_quarter_turn(&Mat::identity(system.m())));
        }
        let rates = [t.rate_q, t.rate_v, t.rate_a, t.rate_z];
        let mut out = Linearised { mass: t.a, damping: t.v, stiffness: t.q, state_force: t.z, rates, unknowns, isotropic: false };
        out.isotropic = out.couplings().iter().all(|x| *x <= ISOTROPIC);
        out
    }

    fn couplings(&self) -> [f64; 8] {
        let (q, z) = (&self.unknowns.coordinates, &self.unknowns.states);
        let one = |cols: &Sectors, rows: &Sectors, m: &Mat| cols.coupling(rows, &cols.polarised(rows, m));
        let [rq, rv, ra, rz] = &self.rates;
        [one(q, q, &self.mass), one(q, q, &self.damping), one(q, q, &self.stiffness), one(z, q, &self.state_force)]
            .into_iter()
            .chain([one(q, z, rq), one(q, z, rv), one(q, z, ra), one(z, z, rz)])
            .collect::<Vec<_>>()
            .try_into()
            .unwrap_or([f64::NAN; 8])
    }

    /// What a mode is made of.
    pub(super) fn unknowns(&self) -> &Unknowns {
        &self.unknowns
    }
    /// Turning the machine about its axis changes nothing.
    pub fn is_isotropic(&self) -> bool {
        self.isotropic
    }

    /// All modes, with Im s >= 0.
    ///
    /// # Errors
    /// When the matrices hold numbers that are not finite or leave some coordinate undetermined.
    pub fn spectrum(&self) -> Result<Spectrum, EigError> {
        let mut out = Spectrum::default();
        if self.isotropic {
            for sector in [Sector::Forward, Sector::Axial] {
                let (co, st) = (&self.unknowns.coordinates, &self.unknowns.states);
                let (q, z) = (co.members(sector), st.members(sector));
                if q.len() + z.len() == 0 {
                    continue;
                }
                let one = |cols: &Sectors, rows: &Sectors, m: &Mat, r: &[usize], k: &[usize]| block(&cols.polarised(rows, m), r, k);
                let [rq, rv, ra, rz] = &self.rates;
                let parts = [
                    one(co, co, &self.mass, &q, &q),
                    one(co, co, &self.damping, &q, &q),
                    one(co, co, &self.stiffness, &q, &q),
                    one(st, co, &self.state_force, &q, &z),
                    one(co, st, rq, &z, &q),
                    one(co, st, rv, &z, &q),
                    one(co, st, ra, &z, &q),
                    one(st, st, rz, &z, &z),
                ];
                let (modes, infinite) = if sector == Sector::Axial {
                    let real = parts.map(|m| Mat::from_fn(m.rows(), m.cols(), |i, j| m[(i, j)].re));
                    let (modes, infinite) = first_order(&real)?;
                    (eig::upper_half(&modes), infinite)
                } else {
                    first_order(&parts)?
                };
                // the backward sector is the conjugate of the forward one
                out.infinite += if sector == Sector::Forward { 2 * infinite } else { infinite };
                for (k, m) in modes.iter().enumerate() {
                    out.modes.push(MachineMode { place: (out.families.len(), k), ..self.unknowns.mode(m, Some(sector), &q, &z) });
                }
                out.families.push(Family { sector: Some(sector), modes });
            }
        } else {
            let [rq, rv, ra, rz] = self.rates.clone();
            let parts = [self.mass.clone(), self.damping.clone(), self.stiffness.clone(), self.state_force.clone(), rq, rv, ra, rz];
            let (modes, infinite) = first_order(&parts)?;
            out.infinite = infinite;
            let modes = eig::upper_half(&modes);
            let (q, z): (Vec<usize>, Vec<usize>) = ((0..self.mass.rows()).collect(), (0..self.rates[3].rows()).collect());
            for (k, m) in modes.iter().enumerate() {
                out.modes.push(MachineMode { place: (0, k), ..self.unknowns.mode(m, None, &q, &z) });
            }
            out.families.push(Family { sector: None, modes });
        }
        self.free_along(&mut out.modes);
        settle_modes(&mut out.modes);
        Ok(out)
    }

    /// The double roots of a rotor that nothing holds along or about the axis are 0; the eigenvalue problem gives them to half of the digits.
    fn free_along(&self, modes: &mut [MachineMode]) {
        const HALF: f64 = 1e-6;
        for (whirl, of) in [(Whirl::Axial, &self.unknowns.along[0]), (Whirl::Torsional, &self.unknowns.along[1])] {
            let rows = |i: usize| {
                // shafts in mesh turn as their ratios
                let factor = |j: usize| if whirl == Whirl::Torsional { self.unknowns.ratios[j] } else { 1.0 };
                let each = of.iter().map(|&j| self.stiffness[(i, j)] * factor(j));
                each.fold((0.0, 0.0), |(sum, size): (f64, f64), x| (sum + x, size + x.abs()))
            };
            let free = (0..self.stiffness.rows()).all(|i| {
                let (sum, size) = rows(i);
                sum.abs() <= 1e-12 * size
            });
            if of.is_empty() || !free {
                continue;
            }
            let own = modes.iter().filter(|m| m.whirl == whirl).count();
            // of wheels that move across the axis as well all other motions are mixed
            let known = modes.iter().filter(|m| own <= 2 || m.whirl == whirl);
            let highest = known.map(|m| m.value.abs()).fold(0.0, f64::max);
            modes.iter_mut().filter(|m| m.whirl == whirl && m.value.abs() <= HALF * highest).for_each(|m| m.value = C64::zero());
        }
    }
}

fn add(m: &mut Mat, k: f64, other: &Mat) {
    for (x, y) in m.data_mut().iter_mut().zip(other.data()) {
        *x += k * y;
    }
}

/// Modes of `M q'' + C q' + K q + Z z = 0, z' = Rq q + Rv q' + Ra q'' + Rz z` over (q, q', z), and the number of infinite ones.
fn first_order<T: Number>(parts: &[Mat<T>; 8]) -> Result<(Vec<eig::Mode>, usize), EigError> {
    let [m, d, k, f, rq, rv, ra, rz] = parts;
    let (n, states) = (m.rows(), rz.rows());
    let size = 2 * n + states;
    // scaled to a unit diagonal where there is one, so that kg and kg m^2 do not look singular
    let scale: Vec<f64> = (0..n)
        .map(|i| {
            let x = m[(i, i)].size();
            if x > 0.0 { x.sqrt().recip() } else { 1.0 }
        })
        .collect();
    let lu = Lu::new(&Mat::from_fn(n, n, |i, j| m[(i, j)].times(scale[i] * scale[j]))).ok().filter(|lu| lu.pivot_ratio() > 1e-11);
    if let Some(lu) = lu {
        // M^-1 [K C Z]
        let mut right = Mat::from_fn(n, size, |i, j| {
            let x = if j < n {
                k[(i, j)]
            } else if j < 2 * n {
                d[(i, j - n)]
            } else {
                f[(i, j - 2 * n)]
            };
            x.times(scale[i])
        });
        lu.solve_mat(&mut right);
        let accel = Mat::from_fn(n, size, |i, j| -right[(i, j)].times(scale[i]));
        let coupled = ra.matmul(&accel);
        let a = Mat::from_fn(size, size, |i, j| {
            if i < n {
                if j == i + n { T::ONE } else { T::ZERO }
            } else if i < 2 * n {
                accel[(i - n, j)]
            } else {
                let i = i - 2 * n;
                let own = if j < n {
                    rq[(i, j)]
                } else if j < 2 * n {
                    rv[(i, j - n)]
                } else {
                    rz[(i, j - 2 * n)]
                };
                own + coupled[(i, j)]
            }
        });
        return Ok((eig::modes(&a)?, 0));
    }
    let a = Mat::from_fn(size, size, |i, j| {
        if i < n {
            if j == i + n { T::ONE } else { T::ZERO }
        } else if i < 2 * n {
            let i = i - n;
            -(if j < n {
                k[(i, j)]
            } else if j < 2 * n {
                d[(i, j - n)]
            } else {
                f[(i, j - 2 * n)]
            })
        } else {
            let i = i - 2 * n;
            if j < n {
                rq[(i, j)]
            } else if j < 2 * n {
                rv[(i, j - n)]
            } else {
                rz[(i, j - 2 * n)]
            }
        }
    });
    let e = Mat::from_fn(size, size, |i, j| {
        let inside = (n..2 * n).contains(&j);
        if (n..2 * n).contains(&i) && inside {
            m[(i - n, j - n)]
        } else if i >= 2 * n && inside {
            -ra[(i - 2 * n, j - n)]
        } else if i == j {
            T::ONE
        } else {
            T::ZERO
        }
    });
    let pencil = eig::Pencil::new(a, e);
    let modes = pencil.modes()?;
    Ok((modes.finite.iter().map(|m| pencil.biorthogonal(m)).collect(), modes.infinite))
}

/// Polishes the modes on the exact characteristic function. A mode that does not converge nearby keeps its value.
pub fn polish(t: &mut Characteristic, spectrum: &mut Spectrum) {
    let size = spectrum.modes.iter().map(|m| m.value.abs()).fold(0.0, f64::max);
    let values: Vec<C64> = spectrum.modes.iter().map(|m| m.value).collect();
    for (k, mode) in spectrum.modes.iter_mut().enumerate() {
        let gap = values.iter().enumerate().filter(|&(j, _)| j != k).map(|(_, v)| (*v - mode.value).abs()).fold(size, f64::min);
        let Some(p) = t.polish(mode.value, mode.sector) else { continue };
        let moved = (p.value - mode.value).abs();
        // a root that moved towards a neighbour may be that neighbour
        if moved <= 0.3 * gap || (mode.sector.is_some() && moved <= 1e-6 * mode.value.abs()) {
            let im = if mode.value.im == 0.0 { 0.0 } else { p.value.im };
            mode.value = c(p.value.re, im);
            (mode.error, mode.polished) = (p.step, true);
            spectrum.polished += 1;
        }
    }
}

/// Modes about an equilibrium: of a machine with parts that have no time form, and of a [large](super::large) one, those of its [`roots`] in the region it chooses by itself; else polished where the pencil holds memory states, or everywhere on demand; roots of the exact function where it holds a fit.
///
/// # Errors
/// As [`Linearised::new`]; a spectrum that cannot be computed.
pub fn modes_about(system: &System, about: &Equilibrium, always: bool) -> Result<Spectrum, Diagnostic> {
    if in_region(system) {
        return Ok(roots(system, about, &Request::default())?.spectrum);
    }
    let linear = Linearised::new(system, about)?;
    let mut spectrum = linear.spectrum().map_err(|e| {
        Diagnostic::error(
            "modes.eigenvalues",
            text!("the modes at {speed} could not be computed: {e}", speed = text::quantity(about.speed, "rad/s"), e),
        )
        .help(text!("a coordinate with neither mass, damping nor stiffness leaves the modes undetermined"))
    })?;
    if holds_fit(system) {
        super::exact::settle(&mut Characteristic::new(system, about), &linear, &mut spectrum);
    } else if always || wants_polish(system) {
        polish(&mut Characteristic::new(system, about), &mut spectrum);
    }
    Ok(spectrum)
}
