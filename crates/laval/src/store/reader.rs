//! Rows of a folder, read chunk by chunk beside whoever writes it.

use super::folder::{mark, name_of};
use super::manifest::Manifest;
use super::{Chunk, Keep, Plan, parquet};
use crate::diagnostic::Diagnostic;
use crate::text;
use std::fs;
use std::io;
use std::path::PathBuf;

/// Reads chunks that are there. Files are written whole, so that neither a lock nor a manifest is needed.
pub struct Reader {
    folder: PathBuf,
    plan: Plan,
    input_hash: String,
}

impl Reader {
    /// Of the study that is kept there.
    pub fn new(plan: Plan, keep: &Keep) -> Reader {
        let input_hash = Manifest::new(&plan, &keep.input).input_hash;
        Reader { folder: keep.folder.clone(), plan, input_hash }
    }

    /// What is kept.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The file of a chunk.
    pub fn file(&self, index: usize) -> PathBuf {
        self.folder.join(name_of(index))
    }

    /// A chunk; `None` where its file is not there.
    ///
    /// # Errors
    /// A file that is damaged or belongs to another study.
    pub fn chunk(&self, index: usize) -> Result<Option<Chunk>, Diagnostic> {
        let path = self.file(index);
        let wrong = |message| Diagnostic::error("store.read", message);
        match fs::read(&path) {
            Ok(bytes) if parquet::sealed(&bytes) => {}
            Ok(_) => return Err(wrong(text!("{path} is damaged", path = path.display()))),
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(e) => return Err(wrong(text!("cannot read {path}: {e}", path = path.display(), e))),
        }
        let (cells, found) =
            parquet::decode(&path, &self.plan.columns).map_err(|e| wrong(text!("cannot read {path}: {e}", path = path.display(), e)))?;
        let rows = self.plan.range(index);
        if found != mark(&self.input_hash, index) || cells.iter().any(|c| c.len() != rows.len()) {
            return Err(wrong(text!("{path} belongs to another study, another build or another processor", path = path.display())));
        }
        Ok(Some(Chunk { rows, cells }))
    }
}
