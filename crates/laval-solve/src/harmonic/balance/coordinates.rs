//! The nonlinear coordinates of a machine: what its nonlinear parts see.

use crate::harmonic::balance::condense::Basis;
use crate::harmonic::balance::nonlinear::Member;
use crate::model::part::DofKind;
use crate::model::system::System;

/// The nonlinear coordinates of a machine: what its nonlinear parts see, without repetition.
#[derive(Clone, Debug)]
pub struct Nonlinear {
    /// Rows over global coordinates.
    pub basis: Basis,
    /// Kinds of these coordinates, then of the nonlinear parts' states.
    pub kinds: Vec<DofKind>,
    /// Typical sizes.
    pub typical: Vec<f64>,
    /// Global state of each state coordinate.
    pub states: Vec<usize>,
    /// The nonlinear parts.
    pub members: Vec<Member>,
    /// Vectors come with both components, so that a turn of the machine maps the coordinates onto themselves.
    pub paired: bool,
}

impl Nonlinear {
    /// Of a machine. A linear machine is seen through its first pair of coordinates.
    pub fn of(system: &System) -> Nonlinear {
        let n = system.n();
        let mut basis = Basis::default();
        let (mut kinds, mut typical) = (Vec::new(), Vec::new());
        let mut members = Vec::new();
        let mut note = |basis: &Basis, local_kind: DofKind, size: f64, kinds: &mut Vec<DofKind>| {
            if basis.rows.len() > kinds.len() {
                kinds.push(local_kind);
                typical.push(size);
            }
        };
        for (k, slot) in system.slots().iter().enumerate().filter(|(_, s)| !s.is_linear()) {
            let mut map = Vec::new();
            for (row, kind) in slot.map.iter().zip(slot.layout.kinds()) {
                map.push(basis.express(row, n));
                // the size of what the row combines: a tilt may be a difference of displacements over a length
                let size = row.iter().map(|&(g, c)| c.abs() * system.coordinates()[g].dof.typical).fold(0.0, f64::max);
                note(&basis, kind, if size > 0.0 { size } else { 1.0 }, &mut kinds);
            }
            members.push(Member { slot: k, map, states: 0..0, uses: slot.uses });
        }
        if basis.rows.is_empty() {
            let dofs = system.coordinates();
            let pair = (1..n).find(|&g| dofs[g - 1].dof.kind.leads_pair() && dofs[g].dof.kind.ends_pair());
            for (g, coordinate) in dofs.iter().enumerate().skip(pair.map_or(0, |g| g - 1)).take(2) {
                basis.express(&[(g, 1.0)], n);
                note(&basis, coordinate.dof.kind, coordinate.dof.typical, &mut kinds);
            }
        }
        // a vector's component without the other is expanded like a scalar
        let together = |kinds: &[DofKind], i: usize| {
            (kinds[i].leads_pair() && kinds.get(i + 1).is_some_and(|k| k.ends_pair()))
                || (i > 0 && kinds[i].ends_pair() && kinds[i - 1].leads_pair())
        };
        let kinds_before = kinds.clone();
        let mut paired = true;
        for (i, kind) in kinds.iter_mut().enumerate() {
            if (kind.leads_pair() || kind.ends_pair()) && !together(&kinds_before, i) {
                (*kind, paired) = (DofKind::Scalar, false);
            }
        }
        let mut states = Vec::new();
        for member in &mut members {
            let slot = &system.slots()[member.slot];
            let first = basis.rows.len() + states.len();
            for g in slot.states.clone() {
                states.push(g);
                kinds.push(system.states()[g].dof.kind);
                typical.push(system.states()[g].dof.typical);
            }
            member.states = first..basis.rows.len() + states.len();
        }
        Nonlinear { basis, kinds, typical, states, members, paired }
    }
}
