//! A computation that ends when nobody waits for its answer any more.

use laval::study::Cancel;
use std::sync::atomic::Ordering;

/// Requests the stop of a computation when it is dropped: it belongs to the answer, which the server drops when the page has closed the connection.
#[derive(Default)]
pub(crate) struct Abandon(Cancel);

impl Abandon {
    /// The stop, for the computation.
    pub fn cancel(&self) -> Cancel {
        self.0.clone()
    }
}

impl Drop for Abandon {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}
