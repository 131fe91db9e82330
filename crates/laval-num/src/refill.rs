//! Scratch that keeps its memory.

/// `n` times one value. Of a vector that has this length already only the values are written: it takes part in every evaluation of a machine.
#[inline]
pub fn refill<T: Clone>(v: &mut Vec<T>, n: usize, value: T) {
    if v.len() == n {
        v.fill(value);
    } else {
        v.clear();
        v.resize(n, value);
    }
}
