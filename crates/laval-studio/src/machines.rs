//! Machine files that were read lately: answers of several kinds, and drags that go to and fro, read each once.

use laval::diagnostic::Diagnostics;
use laval::file::{self, Catalog, Loaded};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

/// Files that are kept.
const KEPT: usize = 12;

/// What a file is.
pub(crate) type Read = Result<Arc<Loaded>, Arc<Diagnostics>>;

/// The files read last, newest first.
#[derive(Default)]
pub(crate) struct Machines(Mutex<Vec<(Arc<str>, Read)>>);

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

    fn held<R>(&self, f: impl FnOnce(&mut Vec<(Arc<str>, Read)>) -> R) -> R {
        f(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}
