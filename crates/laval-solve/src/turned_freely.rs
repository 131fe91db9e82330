//! Which coordinates along and about the axis a state of rest leaves where they are.
//!
//! Without a load along the axis, or a torque, a rotor stays where it is in that direction, whether something holds it there or nothing does. Teeth in mesh join the rotation of
//! shafts to their displacements: there the shafts roll on each other until the teeth carry no more than the transmitted torque, and one rotation of them all is free.

use crate::model::part::DofKind;
use crate::model::system::System;
use laval_num::factor::{Factors, Pattern, Selection};

/// Smallest pivot over the largest below which nothing holds a group.
const FREE: f64 = 1e-11;

/// Coordinates that stay where they are, by the stiffness (entries of the pattern, coordinates first): of every group that stiffness joins and that no load acts on all, where it
/// is joined to no other motion, and one, where it is and nothing holds it. Groups that nonlinear parts act on are none of these.
pub(crate) fn kept(system: &System, pattern: &Pattern, stiffness: &[f64], loaded: impl Fn(usize) -> bool) -> Vec<usize> {
    let n = system.n();
    let mut out = Vec::new();
    let mut nonlinear = vec![false; n];
    system.slots().iter().filter(|s| !s.is_linear()).flat_map(|s| s.coordinates()).for_each(|i| nonlinear[i] = true);
    for kind in [DofKind::Axial, DofKind::Twist] {
        let of = |i: usize| i < n && system.coordinates()[i].dof.kind == kind;
        let mut seen = vec![false; n];
        for first in (0..n).filter(|&i| of(i)) {
            if seen[first] {
                continue;
            }
            let (mut group, mut joined) = (vec![first], false);
            seen[first] = true;
            let mut next = 0;
            while let Some(&i) = group.get(next) {
                next += 1;
                for j in pattern.row(i).filter(|x| stiffness[x.0] != 0.0).map(|x| x.1) {
                    if !of(j) {
                        joined = true;
                    } else if !std::mem::replace(&mut seen[j], true) {
                        group.push(j);
                    }
                }
            }
            if group.iter().any(|&i| nonlinear[i] || loaded(i)) {
                continue;
            }
            if !joined {
                out.append(&mut group);
            } else if is_free(pattern, stiffness, group) {
                out.push(first);
            }
        }
    }
    out
}

/// The stiffness that joins a group is singular.
fn is_free(pattern: &Pattern, stiffness: &[f64], mut group: Vec<usize>) -> bool {
    group.sort_unstable();
    let own = Selection::new(pattern, &group);
    !Factors::new(&own.inner, &own.taken(stiffness)).is_ok_and(|f| f.pivot_ratio() > FREE)
}
