//! What a study computed, beside what it reports.

use std::any::Any;
use std::fmt;
use std::sync::Arc;

/// A study and its result, as computed: the first page uses them where its own computation would take too long. Neither written nor compared.
#[derive(Clone, Default)]
pub struct Kept(Option<Arc<dyn Any + Send + Sync>>);

impl Kept {
    /// Keeps a study and its result.
    pub fn of<S: Send + Sync + 'static, R: Send + Sync + 'static>(study: S, result: R) -> Kept {
        Kept(Some(Arc::new((study, result))))
    }

    /// The study and its result, where they are of these types.
    pub fn get<S: 'static, R: 'static>(&self) -> Option<(&S, &R)> {
        self.0.as_ref()?.downcast_ref::<(S, R)>().map(|(study, result)| (study, result))
    }
}

impl PartialEq for Kept {
    fn eq(&self, _: &Kept) -> bool {
        true
    }
}

impl fmt::Debug for Kept {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "Kept" } else { "Nothing" })
    }
}
