//! Free periodic motions: a whirl that no unbalance forces, at a frequency of its own.
//!
//! ```text
//! r(x; w, W, xi) = 0,   Im x_lead = 0,   (Re x_lead = a where the amplitude a is prescribed)
//! ```
//!
//! x are the harmonics of the nonlinear coordinates, w the whirl frequency, W the spin speed, and xi the drive: a force `xi M q'` on the masses of the
//! linear parts. A motion without forcing may begin at any instant; the phase condition picks the one where the leading harmonic is real. One of w, W
//! and xi is unknown beside the harmonics (two where the amplitude is prescribed), one is followed, the others stay. The linear parts are condensed at
//! `s = i k w` with their coefficients at W.
//!
//! Without damping whole families of motions exist, and xi comes out as zero to rounding: it only makes the equations as many as the unknowns. In a
//! damped machine xi is the excitation that makes up for the losses, proportional to mass as in the extended periodic motion concept (M. Krack,
//! Comput. Struct. 154, 2015, 59).
//!
//! Theory: `docs/theory/free-motions.md#equations`.

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::nonlinear::Sampled;
use crate::harmonic::balance::pace::Pace;
use crate::harmonic::balance::problem::{Balance, Discretisation};
use crate::harmonic::balance::terms::Term;
use crate::model::part::DofKind;
use crate::model::system::System;
use laval_model::text;
use laval_num::complex::{C64, c};
use laval_num::continuation::{Failure, Zero};
use laval_num::dense::{Mat, max_abs};
use std::sync::atomic::AtomicBool;

/// What a free motion depends on beside its harmonics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Spin speed W, rad/s.
    Speed,
    /// Whirl frequency w, rad/s; negative backward.
    Frequency,
    /// Drive xi, 1/s.
    Drive,
    /// Amplitude of the leading harmonic, m.
    Amplitude,
}

/// The equations of free motions of one machine.
pub struct Free<'a> {
    /// The balance of forces.
    pub balance: Balance<'a>,
    /// Unknown beside the harmonics: one, or two where the parameter is the amplitude.
    pub unknown: Vec<Quantity>,
    /// What is followed.
    pub parameter: Quantity,
    /// Speed, frequency and drive where they are neither unknown nor followed.
    pub fixed: [f64; 3],
    /// First unknown of the leading harmonic.
    pub lead: usize,
    size: f64,
    scale: [f64; 3],
    jac: Mat,
    column: Vec<f64>,
}

impl<'a> Free<'a> {
    /// With amplitudes of the order of `size` (m) at frequencies of the order of `frequency` (rad/s).
    ///
    /// # Errors
    /// A body that drifts.
    pub fn new(
        system: &'a System,
        d: Discretisation,
        (size, frequency): (f64, f64),
        speed: f64,
        cancel: Option<&'a AtomicBool>,
    ) -> Result<Self, Diagnostic> {
        let w = frequency.abs();
        let mut balance = Balance::new(system, d, (0.9 * w, 1.1 * w), cancel)?;
        balance.set_free(Pace { speed, frequency, drive: 0.0, rate: [0.0; 3], parameter: None });
        Ok(Free {
            unknown: vec![Quantity::Frequency, Quantity::Drive],
            parameter: Quantity::Amplitude,
            fixed: [speed, frequency, 0.0],
            lead: 0,
            size,
            scale: [speed.abs().max(w), w, w],
            jac: Mat::default(),
            column: vec![0.0; balance.dim()],
            balance,
        })
    }

    /// Number of harmonics' unknowns.
    pub fn harmonics(&self) -> usize {
        self.balance.dim()
    }

    /// Speed, frequency and drive at unknowns `x` and parameter `p`.
    pub fn quantities(&self, x: &[f64], p: f64) -> [f64; 3] {
        let mut values = self.fixed;
        let beside = self.unknown.iter().zip(&x[self.harmonics()..]).chain([(&self.parameter, &p)]);
        for (&quantity, &value) in beside {
            if quantity != Quantity::Amplitude {
                values[quantity as usize] = value;
            }
        }
        values
    }

    /// Puts the balance at this motion, with derivatives along one quantity; the speed.
    pub fn place(&mut self, x: &[f64], p: f64, along: Option<Quantity>) -> f64 {
        let [speed, frequency, drive] = self.quantities(x, p);
        let mut rate = [0.0; 3];
        if let Some(q) = along.filter(|q| *q != Quantity::Amplitude) {
            rate[q as usize] = 1.0;
        }
        self.balance.set_free(Pace { speed, frequency, drive, rate, parameter: None });
        speed
    }

    /// The unknowns' size where the largest is `size`.
    fn harmonic_scale(&self, out: &mut [f64]) {
        let typical = &self.balance.nonlinear.typical;
        let lead = self.balance.terms.list.iter().find(|(_, at)| *at == self.lead).map_or(0, |(t, _)| coordinate(*t));
        for &(term, at) in &self.balance.terms.list {
            out[at..at + term.size()].fill(self.size * typical[coordinate(term)] / typical[lead]);
        }
    }

    /// Unknown harmonics of coordinates moving as `amplitude exp(i w t)`, turned in time so that the leading harmonic is real and is `a`; chooses it.
    /// `backward` motion has a negative frequency.
    pub fn shape(&mut self, amplitude: &[C64], backward: bool, a: f64) -> Option<Vec<f64>> {
        let n = self.balance.system.n();
        let project = |q: &[C64]| -> Vec<C64> {
            let rows = &self.balance.nonlinear.basis.rows;
            let mut u: Vec<C64> = rows.iter().map(|r| r.iter().fold(C64::zero(), |s, &(g, x)| s + q[g].scale(x))).collect();
            u.resize(self.balance.terms.coordinates, C64::zero());
            u
        };
        if amplitude.len() != n {
            return None;
        }
        let mut u = project(amplitude);
        if backward {
            u.iter_mut().for_each(|z| *z = z.conj());
        }
        let mut x = vec![0.0; self.harmonics()];
        self.balance.terms.add_amplitudes(1, &u, &mut x);
        let (lead, term) = self.leading(&x)?;
        self.lead = lead;
        let own = c(x[lead], x[lead + 1]);
        let size = own.abs();
        // a shift in time turns the amplitude of a harmonic of order n by n times the angle; that of a scalar has its imaginary part negated
        let turn = match term {
            Term::Pair { order, .. } if order < 0 => own,
            Term::Pair { .. } => own.conj(),
            Term::Scalar { .. } => own,
        };
        u.iter_mut().for_each(|z| *z = *z * turn.scale(a / (size * size)));
        x.fill(0.0);
        self.balance.terms.add_amplitudes(1, &u, &mut x);
        (x.iter().all(|v| v.is_finite())).then_some(x)
    }

    /// The largest harmonic of first order among displacements.
    fn leading(&self, x: &[f64]) -> Option<(usize, Term)> {
        let kinds = &self.balance.nonlinear.kinds;
        let moves = |k: DofKind| !matches!(k, DofKind::TiltX | DofKind::TiltY);
        let of = |at: usize| x[at].hypot(x[at + 1]);
        let first = self.balance.terms.list.iter().filter(|(t, _)| t.order().unsigned_abs() == 1 && moves(kinds[coordinate(*t)]));
        let (term, at) = first.max_by(|a, b| of(a.1).total_cmp(&of(b.1)))?;
        (of(*at) > 0.0).then_some((*at, *term))
    }

    /// Chooses the leading harmonic of unknowns that are not turned; their phase is.
    pub fn lead_with(&mut self, x: &mut [f64], a: f64) -> Option<()> {
        let (lead, _) = self.leading(x)?;
        self.lead = lead;
        let own = c(x[lead], x[lead + 1]);
        // only harmonics of first order: each is turned by its own
        for &(term, at) in &self.balance.terms.list {
            if term.order().unsigned_abs() == 1 {
                let z = c(x[at], x[at + 1]) * own.conj().scale(a / own.abs().powi(2));
                (x[at], x[at + 1]) = (z.re, z.im);
            }
        }
        Some(())
    }
}

/// The coordinate a term belongs to.
pub(super) fn coordinate(term: Term) -> usize {
    match term {
        Term::Pair { coordinate, .. } | Term::Scalar { coordinate, .. } => coordinate,
    }
}

impl Zero for Free<'_> {
    fn dim(&self) -> usize {
        self.harmonics() + self.unknown.len()
    }
    fn scale(&self, out: &mut [f64]) {
        let n = self.harmonics();
        self.harmonic_scale(&mut out[..n]);
        for (o, &q) in out[n..].iter_mut().zip(&self.unknown) {
            *o = self.scale[q as usize];
        }
    }
    fn parameter_scale(&self) -> f64 {
        match self.parameter {
            Quantity::Amplitude => self.size,
            q => self.scale[q as usize],
        }
    }
    fn eval(&mut self, x: &[f64], p: f64, r: &mut [f64], mut jac: Option<&mut Mat>, mut dr_dp: Option<&mut [f64]>) -> Result<(), Failure> {
        let n = self.harmonics();
        let prescribed = self.parameter == Quantity::Amplitude;
        // columns beside the harmonics: where in the Jacobian, or the parameter's own
        let mut columns: Vec<(Quantity, Option<usize>)> = Vec::new();
        if jac.is_some() {
            columns.extend(self.unknown.iter().enumerate().map(|(i, &q)| (q, Some(n + i))));
        }
        if dr_dp.is_some() && !prescribed {
            columns.push((self.parameter, None));
        }
        if columns.is_empty() {
            let speed = self.place(x, p, None);
            self.balance.eval(&x[..n], speed, &mut r[..n], None, None)?;
        }
        let mut square = std::mem::take(&mut self.jac);
        let mut column = std::mem::take(&mut self.column);
        for (k, &(quantity, to)) in columns.iter().enumerate() {
            let speed = self.place(x, p, Some(quantity));
            square.reset(n, n);
            column.fill(0.0);
            r[..n].fill(0.0);
            let harmonics = (k == 0 && jac.is_some()).then_some(&mut square);
            let with = harmonics.is_some();
            self.balance.eval(&x[..n], speed, &mut r[..n], harmonics, Some(&mut column))?;
            if let Some(jac) = jac.as_deref_mut() {
                for i in 0..n {
                    if with {
                        jac.row_mut(i)[..n].copy_from_slice(square.row(i));
                    }
                    if let Some(to) = to {
                        jac[(i, to)] = column[i];
                    }
                }
            }
            if let (None, Some(d)) = (to, dr_dp.as_deref_mut()) {
                d[..n].copy_from_slice(&column);
            }
        }
        (self.jac, self.column) = (square, column);
        r[n] = x[self.lead + 1];
        if prescribed {
            r[n + 1] = x[self.lead] - p;
        }
        if let Some(jac) = jac {
            jac[(n, self.lead + 1)] = 1.0;
            if prescribed {
                jac[(n + 1, self.lead)] = 1.0;
            }
        }
        if let Some(d) = dr_dp.filter(|_| prescribed) {
            d[n + 1] = -1.0;
        }
        Ok(())
    }
    fn monitors(&self) -> usize {
        self.balance.monitors()
    }
    fn monitor_width(&self) -> usize {
        self.balance.monitor_width()
    }
    fn monitor_scale(&self, out: &mut [f64]) {
        out.fill(1e-2 * self.size);
    }
    fn measure(&mut self, x: &[f64], p: f64, out: &mut [f64]) -> Result<(), Failure> {
        let n = self.harmonics();
        let speed = self.place(x, p, None);
        self.balance.measure(&x[..n], speed, out)
    }
    fn cancelled(&self) -> bool {
        self.balance.cancelled()
    }
}

/// The amplitude (m) at which nonlinear parts, moved alike in a circle or line, answer by half as much again as their tangent does; `None` where
/// they stay linear.
pub fn natural_amplitude(balance: &Balance) -> Option<f64> {
    let system = balance.system;
    let terms = &balance.terms;
    let kinds = &balance.nonlinear.kinds;
    let mut sampled = Sampled::default();
    let mut force = |a: f64| -> f64 {
        let mut x = vec![0.0; terms.unknowns];
        for &(term, at) in &terms.list {
            let displaces = !matches!(kinds[coordinate(term)], DofKind::TiltX | DofKind::TiltY);
            if term.order() == 1 && displaces {
                x[at] = a;
            }
        }
        sampled.eval(system, &balance.nonlinear.members, terms, &x, Pace::forced(0.0, 1), false);
        max_abs(&sampled.rows)
    };
    let typical = balance.nonlinear.typical.iter().copied().fold(0.0, f64::max);
    let least = 1e-9 * typical;
    let slope = force(least) / least;
    // a gap that is open answers with nothing until it closes
    let departs = |f: f64, a: f64| if slope == 0.0 { f != 0.0 } else { !((f / (slope * a) - 1.0).abs() < 0.5) };
    let mut a = least;
    while a < 1e6 * typical {
        if departs(force(2.0 * a), 2.0 * a) {
            // closer by halving
            let (mut lo, mut hi) = (a, 2.0 * a);
            for _ in 0..20 {
                let mid = 0.5 * (lo + hi);
                if departs(force(mid), mid) { hi = mid } else { lo = mid }
            }
            return Some(hi);
        }
        a *= 2.0;
    }
    None
}

/// Nothing in the machine acts at a given phase or time but the unbalance, which a free motion leaves out.
///
/// # Errors
/// The part that does, by name.
pub fn autonomous(system: &System, speed: f64) -> Result<(), Diagnostic> {
    use crate::model::part::{At, Rows};
    use crate::model::system::Workspace;
    let (n, m) = (system.n(), system.m());
    let size = |k: usize| if k.is_multiple_of(2) { 0.31 } else { -0.23 };
    let q: Vec<f64> = system.coordinates().iter().enumerate().map(|(k, d)| size(k) * d.dof.typical).collect();
    let v: Vec<f64> = q.iter().map(|x| x * (1.0 + speed.abs())).collect();
    let z: Vec<f64> = system.states().iter().enumerate().map(|(k, d)| size(k) * d.dof.typical).collect();
    for slot in system.slots().iter().filter(|s| !s.is_linear() && s.uses.spin) {
        let rows = |phase: f64, t: f64| {
            let at = At { q: &q, v: &v, a: &q, z: &z, phase, speed, spin_accel: 0.0, t };
            let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
            let mut out = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
            system.residual(system.params(), &at, &mut out, &mut Workspace::default(), |s| s.name == slot.name);
            force.extend(rate);
            force
        };
        let reference = rows(0.0, 0.0);
        let most = max_abs(&reference);
        for (phase, t) in [(1.1, 0.3), (2.9, 7.1)] {
            let change = rows(phase, t).iter().zip(&reference).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            if !(change <= 1e-9 * most) {
                return Err(Diagnostic::error(
                    "free.turning",
                    text!(
                        "the force of \"{name}\" depends on the angle of the rotor or on time: this machine has no free motion",
                        name = slot.name
                    ),
                )
                .at(slot.span.clone())
                .help(text!("use nonlinear_response for the motion that is forced, or a transient")));
            }
        }
    }
    Ok(())
}
