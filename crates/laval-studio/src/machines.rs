//! Machine files that were read lately: answers of several kinds, and drags that go to and fro, read each once.

use laval::diagnostic::Diagnostics;
use laval::file::{self, Catalog, Loaded};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

/// Files that are kept.
const KEPT: usize = 12;

/// What a file is.
pub(crate) type Read = Result<Arc<Loaded>, Arc<Diagnostics>>;

/// The files read last, newest first, and the orders of the last nonlinear response with the parts of its machine.
#[derive(Default)]
pub(crate) struct Machines {
    files: Mutex<Vec<(Arc<str>, Read)>>,
    orders: Mutex<Option<(String, usize)>>,
}

/// All kinds of parts and studies.
pub(crate) static CATALOG: LazyLock<Catalog> = LazyLock::new(file::catalog);

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

    fn held<R>(&self, f: impl FnOnce(&mut Vec<(Arc<str>, Read)>) -> R) -> R {
        f(&mut self.files.lock().unwrap_or_else(PoisonError::into_inner))
    }
}
