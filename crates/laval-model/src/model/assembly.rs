//! Where the entries of parts stand in the matrices of the machine: computed once, at the first assembly.

use super::part::{DofKind, Physics};
use super::slot::{GlobalDof, Slot};
use laval_num::factor::{Pattern, Plan, Selection};
use std::ops::Range;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Which parts enter a linear model through blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// For time integration and eigenvalue pencils: frequency-domain parts by their fitted time form.
    Time,
    /// For harmonics: frequency-domain parts enter [`System::dynamic_stiffness`](super::system::System::dynamic_stiffness) by their exact impedance.
    Frequency,
}

/// Sparsity of the machine in one form, and the places of each part in it.
///
/// Unknowns are the coordinates, the states of the blocks, then those of parts that are not linear, so that their tangents have room. What couples one
/// component of a pair couples both: in circular coordinates the same entries are enough.
#[derive(Debug, Default)]
pub struct Assembly {
    /// Entries of all parts.
    pub pattern: Arc<Pattern>,
    /// Global indices of the states of the blocks.
    pub states: Vec<usize>,
    /// Places of the parts that enter through blocks, in the order of the slots.
    pub stamps: Vec<Stamp>,
    plan: OnceLock<Plan>,
    selections: Mutex<Vec<Arc<Selection>>>,
}

/// Most selections that are kept: those of the sectors of a machine are three.
const KEPT: usize = 8;

/// Places of one part: of each local entry the entries of the machine it adds to, with their factors.
#[derive(Debug)]
pub struct Stamp {
    /// Slot of the part.
    pub slot: usize,
    /// First row of its states among the unknowns.
    pub first_state: usize,
    /// Number of its states in the blocks.
    pub states: usize,
    /// By local row and column, as far as its coordinates are coupled.
    pub coordinates: Places,
    /// By local coordinate and state: the column of a state in the force rows.
    pub state_columns: Places,
    /// By state and local coordinate: the row of a state.
    pub state_rows: Places,
    /// By state and state.
    pub state_block: Places,
}

/// Lists of entries with factors, one list for each place of a local matrix, row by row.
#[derive(Debug, Default)]
pub struct Places {
    starts: Vec<usize>,
    entries: Vec<(usize, f64)>,
}

impl Places {
    fn collect(lists: impl Iterator<Item = Vec<(usize, f64)>>) -> Self {
        let mut out = Places { starts: vec![0], entries: Vec::new() };
        for list in lists {
            out.entries.extend(list);
            out.starts.push(out.entries.len());
        }
        out
    }
    /// The list of a place, by its number row by row.
    #[inline]
    pub fn list(&self, place: usize) -> &[(usize, f64)] {
        &self.entries[self.starts[place]..self.starts[place + 1]]
    }
}

/// The part enters through blocks in a form.
pub(super) fn in_blocks(slot: &Slot, form: Form) -> bool {
    match slot.physics {
        Physics::Nonlinear => false,
        Physics::Linear => true,
        Physics::Frequency(_) => form == Form::Time,
    }
}

/// Ranges of local coordinates all of which are coupled, that hold every coupled pair.
fn groups(slot: &Slot) -> impl Iterator<Item = Range<usize>> {
    let (n, width) = (slot.map.len(), slot.reach.saturating_add(1));
    (0..=n.saturating_sub(width)).map(move |first| first..n.min(first.saturating_add(width)))
}

impl Assembly {
    pub(super) fn new(slots: &[Slot], coordinates: &[GlobalDof], own_states: &[GlobalDof], form: Form) -> Self {
        let n = coordinates.len();
        let own = |s: &Slot| s.states.start..s.states.end - s.memory;
        let states: Vec<usize> = slots.iter().filter(|s| in_blocks(s, form)).flat_map(own).collect();
        let nonlinear: Vec<usize> = slots.iter().filter(|s| !s.is_linear()).flat_map(|s| s.states.clone()).collect();
        let kind = |i: usize| match i.checked_sub(n) {
            None => coordinates[i].dof.kind,
            Some(z) => own_states[if z < states.len() { states[z] } else { nonlinear[z - states.len()] }].dof.kind,
        };
        let size = n + states.len() + nonlinear.len();
        let mut first = vec![None; size];
        for i in (0..size.saturating_sub(1)).filter(|&i| DofKind::leads_pair(kind(i))) {
            (first[i], first[i + 1]) = (Some(i), Some(i));
        }
        let mut pairs = Vec::new();
        let (mut row, mut behind) = (n, n + states.len());
        for slot in slots {
            let rows = if in_blocks(slot, form) {
                row += own(slot).len();
                row - own(slot).len()..row
            } else if !slot.is_linear() {
                behind += slot.states.len();
                behind - slot.states.len()..behind
            } else {
                row..row
            };
            for local in groups(slot) {
                let mut members: Vec<usize> = slot.map[local].iter().flatten().map(|x| x.0).chain(rows.clone()).collect();
                members.extend(members.clone().into_iter().filter_map(|i| first[i]).flat_map(|i| [i, i + 1]));
                members.sort_unstable();
                members.dedup();
                pairs.extend(members.iter().flat_map(|&i| members.iter().map(move |&j| (i, j))));
            }
        }
        // a pair by itself, which no part touches
        pairs.extend(first.iter().flatten().map(|&i| (i, i + 1)));
        let pattern = Pattern::new(size, pairs);
        let mut row = n;
        let mut stamps = Vec::new();
        for (k, slot) in slots.iter().enumerate().filter(|(_, s)| in_blocks(s, form)) {
            let (first_state, m) = (row, own(slot).len());
            row += m;
            // every pair of a part is in the pattern
            let entry = |i: usize, j: usize| pattern.index(i, j).unwrap_or(usize::MAX);
            let map = &slot.map;
            let pair = |rows: &[(usize, f64)], cols: &[(usize, f64)]| -> Vec<(usize, f64)> {
                rows.iter().flat_map(|&(i, a)| cols.iter().map(move |&(j, b)| (i, j, a * b))).map(|(i, j, x)| (entry(i, j), x)).collect()
            };
            let state = |i: usize| [(first_state + i, 1.0)];
            stamps.push(Stamp {
                slot: k,
                first_state,
                states: m,
                coordinates: Places::collect(map.iter().enumerate().flat_map(|(i, r)| slot.neighbours(i).map(move |j| pair(r, &map[j])))),
                state_columns: Places::collect(map.iter().flat_map(|r| (0..m).map(|j| pair(r, &state(j))))),
                state_rows: Places::collect((0..m).flat_map(|i| map.iter().map(move |c| pair(&state(i), c)))),
                state_block: Places::collect((0..m).flat_map(|i| (0..m).map(move |j| pair(&state(i), &state(j))))),
            });
        }
        Assembly { pattern: Arc::new(pattern), states, stamps, plan: OnceLock::new(), selections: Mutex::default() }
    }
    /// How matrices over all unknowns are factored.
    pub fn plan(&self) -> &Plan {
        self.plan.get_or_init(|| Plan::new(&self.pattern))
    }
    /// Some of the unknowns (in rising order) by themselves.
    pub fn selection(&self, members: &[usize]) -> Arc<Selection> {
        let mut known = self.selections.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(s) = known.iter().find(|s| s.members == members) {
            return s.clone();
        }
        let new = Arc::new(Selection::new(&self.pattern, members));
        known.truncate(KEPT - 1);
        known.push(new.clone());
        new
    }
}
