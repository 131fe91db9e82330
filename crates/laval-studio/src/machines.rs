//! Machine files that were read lately: answers of several kinds, and drags that go to and fro, read each once.

use laval::diagnostic::Diagnostics;
use laval::file::{self, Loaded};
use laval::study::nonlinear_response::{NonlinearResponse, NonlinearResponseResult};
use std::sync::{Arc, Mutex, PoisonError};

/// Files that are kept.
const KEPT: usize = 12;

/// What a file is.
pub(crate) type Read = Result<Arc<Loaded>, Arc<Diagnostics>>;

/// The files read last, newest first, and the orders of the last nonlinear response with the parts of its machine.
#[derive(Default)]
pub(crate) struct Machines {
    files: Mutex<Vec<(Arc<str>, Read)>>,
    orders: Mutex<Option<(String, usize)>>,
    /// The last response: the figure and the motion of a text are of one computation.
    response: Mutex<Option<(String, Response)>>,
}

/// A nonlinear response with its study.
pub(crate) type Response = Arc<(NonlinearResponse, NonlinearResponseResult)>;

impl Machines {
    /// Reads a file, or remembers it.
    pub fn load(&self, text: &str) -> Read {
        let known = self.held(|all| {
            let at = all.iter().position(|m| &*m.0 == text)?;
            all[..=at].rotate_right(1);
            all.first().map(|m| m.1.clone())
        });
        if let Some(read) = known {
            return read;
        }
        let read = file::load(text).map(Arc::new).map_err(Arc::new);
        self.held(|all| {
            all.insert(0, (text.into(), read.clone()));
            all.truncate(KEPT);
        });
        read
    }

    /// The orders that sufficed for a machine of these parts.
    pub fn orders(&self, parts: &str) -> Option<usize> {
        let last = self.orders.lock().unwrap_or_else(PoisonError::into_inner);
        last.as_ref().filter(|l| l.0 == parts).map(|l| l.1)
    }

    pub fn remember(&self, parts: String, orders: usize) {
        *self.orders.lock().unwrap_or_else(PoisonError::into_inner) = Some((parts, orders));
    }

    /// The response computed last, if it is that of this text.
    pub fn response(&self, text: &str) -> Option<Response> {
        let last = self.response.lock().unwrap_or_else(PoisonError::into_inner);
        last.as_ref().filter(|l| l.0 == text).map(|l| l.1.clone())
    }

    pub fn keep(&self, text: &str, response: &Response) {
        *self.response.lock().unwrap_or_else(PoisonError::into_inner) = Some((text.into(), response.clone()));
    }

    fn held<R>(&self, f: impl FnOnce(&mut Vec<(Arc<str>, Read)>) -> R) -> R {
        f(&mut self.files.lock().unwrap_or_else(PoisonError::into_inner))
    }
}
