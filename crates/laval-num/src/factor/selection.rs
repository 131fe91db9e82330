//! Some of the unknowns of a matrix by themselves.

use super::{Pattern, Plan};
use std::sync::Arc;

/// Some unknowns of a matrix, and how what couples them is factored: by itself, and with one more row and column that hold everything.
#[derive(Clone, Debug)]
pub struct Selection {
    /// The unknowns, in rising order.
    pub members: Vec<usize>,
    /// By itself.
    pub inner: Plan,
    /// Number in the whole of each entry.
    pub inner_from: Vec<Option<usize>>,
    /// With one more row and column.
    pub bordered: Plan,
    /// Number in the whole of each entry; `None` in the row and the column that are added.
    pub bordered_from: Vec<Option<usize>>,
}

impl Selection {
    /// Of the matrices of a pattern.
    pub fn new(whole: &Pattern, members: &[usize]) -> Self {
        let (inner, inner_from) = whole.of(members, false);
        let (bordered, bordered_from) = whole.of(members, true);
        Selection {
            members: members.to_vec(),
            inner: Plan::new(&Arc::new(inner)),
            inner_from,
            bordered: Plan::new(&Arc::new(bordered)),
            bordered_from,
        }
    }
    /// Entries of what couples the members.
    pub fn taken<T: Copy>(&self, whole: &[T]) -> Vec<T> {
        self.inner_from.iter().flatten().map(|&e| whole[e]).collect()
    }
}
