//! Sorting by numbers. A sort of the standard library is compiled for every type and every comparison, which is much code; here only the last step, moving
//! the values, depends on their type.

/// Sorts in ascending order, as [`f64::total_cmp`] has it.
pub fn ascending(values: &mut [f64]) {
    // numbers equal in this order are equal bit for bit: no order among them to keep, and no memory for it
    values.sort_unstable_by(f64::total_cmp);
}

/// Positions of the keys in ascending order; of equal keys the first one first.
fn positions(keys: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..keys.len()).collect();
    order.sort_by(|&a, &b| keys[a].total_cmp(&keys[b]));
    order
}

/// Sorting of slices by a number of each value. Values with equal numbers keep their order.
pub trait SortByNumber<T> {
    /// The smallest number first.
    fn sort_by_number(&mut self, number: impl FnMut(&T) -> f64);
    /// The largest number first.
    fn sort_by_number_down(&mut self, number: impl FnMut(&T) -> f64);
}

impl<T> SortByNumber<T> for [T] {
    fn sort_by_number(&mut self, number: impl FnMut(&T) -> f64) {
        let keys: Vec<f64> = self.iter().map(number).collect();
        rearrange(self, positions(&keys));
    }
    fn sort_by_number_down(&mut self, mut number: impl FnMut(&T) -> f64) {
        self.sort_by_number(|v| -number(v));
    }
}

/// Moves to place i what stands at `from[i]`, along each cycle of the permutation.
fn rearrange<T>(values: &mut [T], mut from: Vec<usize>) {
    for first in 0..from.len() {
        let mut at = first;
        while from[at] != first {
            let next = std::mem::replace(&mut from[at], at);
            values.swap(at, next);
            at = next;
        }
        from[at] = at;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the standard library sorts, for every order of values with repetitions, zeros of both signs and numbers that are none.
    #[test]
    fn as_the_stable_sort_of_the_standard_library() {
        let numbers = [2.0, -0.0, 0.0, f64::NAN, -1.0, 2.0, f64::NEG_INFINITY, 0.0, -f64::NAN, 3.5, 2.0];
        let mut state = 1_u64;
        for length in 0..40 {
            for _ in 0..50 {
                let mut next = || {
                    state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                    (state >> 33) as usize
                };
                let values: Vec<(f64, usize)> = (0..length).map(|k| (numbers[next() % numbers.len()], k)).collect();
                let same = |a: &[(f64, usize)], b: &[(f64, usize)]| a.iter().zip(b).all(|(a, b)| a.1 == b.1) && a.len() == b.len();
                let (mut ours, mut theirs) = (values.clone(), values.clone());
                ours.sort_by_number(|v| v.0);
                theirs.sort_by(|a, b| a.0.total_cmp(&b.0));
                assert!(same(&ours, &theirs), "{ours:?} {theirs:?}");
                let (mut ours, mut theirs) = (values.clone(), values);
                ours.sort_by_number_down(|v| v.0);
                theirs.sort_by(|a, b| b.0.total_cmp(&a.0));
                assert!(same(&ours, &theirs), "{ours:?} {theirs:?}");
            }
        }
    }
}
