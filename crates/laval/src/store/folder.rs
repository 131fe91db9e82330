//! The folder of a study: chunk files and manifest.

use super::cells::{Cells, Column};
use super::manifest::{Entry, FORMAT, Manifest};
use super::{Host, Keep, Plan, Work, parquet};
use crate::diagnostic::Diagnostic;
use crate::hash::sha256;
use crate::output_folder::{Held, Lasting, write_whole};
use crate::text;
use crate::text::{Arg, Argument, Joint, Text};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

const MANIFEST: &str = "manifest.json";

/// An open, locked folder.
pub struct Folder {
    path: PathBuf,
    manifest: Manifest,
    /// Of a piece, other processes write other chunks meanwhile, and none of them the manifest.
    work: Work,
    /// No process may write what this one writes.
    _held: Held,
}

impl Folder {
    /// Opens or makes the folder, checks that it belongs to this input, and keeps those chunks of `mine` that are sound.
    pub fn open(keep: &Keep, plan: &Plan, host: &dyn Host, mine: &[usize]) -> Result<Folder, Diagnostic> {
        let path = keep.folder.clone();
        let held = if matches!(keep.work, Work::Piece(_)) { Held::share(&path)? } else { Held::take(&path)? };
        let mut folder = Folder { manifest: Manifest::new(plan, &keep.input), path, work: keep.work, _held: held };
        folder.clean(keep.fresh)?;
        if let Some(old) = folder.read_manifest()? {
            folder.belongs(&old)?;
            folder.manifest.chunks = old.chunks;
        }
        folder.verify(plan, host, mine)?;
        folder.write_manifest()?;
        Ok(folder)
    }

    fn file(&self, index: usize) -> PathBuf {
        self.path.join(name_of(index))
    }

    /// With `fresh`, removes everything this store has written.
    fn clean(&self, fresh: bool) -> Result<(), Diagnostic> {
        if !fresh {
            return Ok(());
        }
        // the manifest last: killed in between, it names chunks that are missing, and those are computed again
        let mut names = Vec::new();
        for entry in fs::read_dir(&self.path).map_err(|e| self.unreadable(&self.path, &e))? {
            let name = entry.map_err(|e| self.unreadable(&self.path, &e))?.file_name();
            if let Some(name) = name.to_str().filter(|n| index_of(n).is_some()) {
                names.push(name.to_string());
            }
        }
        if self.path.join(MANIFEST).exists() {
            self.own_manifest()?;
            names.push(MANIFEST.into());
        }
        for name in names {
            let path = self.path.join(name);
            fs::remove_file(&path)
                .map_err(|e| Diagnostic::error("store.write", text!("cannot remove {path}: {e}", path = path.display(), e)))?;
        }
        Ok(())
    }

    /// A file of this name that this program has not written is not removed.
    fn own_manifest(&self) -> Result<(), Diagnostic> {
        let path = self.path.join(MANIFEST);
        let text = fs::read(&path).map_err(|e| self.unreadable(&path, &e))?;
        let value: Option<serde_json::Value> = serde_json::from_slice(&text).ok();
        // of any version
        let own = |v: &serde_json::Value| v["format"].is_u64() && v["laval"].is_string();
        if value.as_ref().is_some_and(own) {
            return Ok(());
        }
        Err(Diagnostic::error("store.foreign", text!("{path} was not written by this program", path = path.display()))
            .help(text!("move it elsewhere, or give the results another folder with --out")))
    }

    fn read_manifest(&self) -> Result<Option<Manifest>, Diagnostic> {
        let path = self.path.join(MANIFEST);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(e) => return Err(self.unreadable(&path, &e)),
        };
        let wrong = |why: Arg| {
            Diagnostic::error("store.manifest", text!("{path} is no manifest of this program: {why}", path = path.display(), why))
                .help(text!("give the results another folder with --out, or start anew with --fresh (which removes what the folder holds)"))
        };
        let value: serde_json::Value = serde_json::from_str(&text).map_err(|e| wrong(e.to_string().argument()))?;
        let format = value.get("format").and_then(serde_json::Value::as_u64);
        if format != Some(u64::from(FORMAT)) {
            let said = match format {
                Some(found) => {
                    text!("its format is {found}, this program writes format {own}", found = found.to_string(), own = u64::from(FORMAT))
                }
                None => text!("its format is none, this program writes format {own}", own = u64::from(FORMAT)),
            };
            return Err(wrong(said.argument()));
        }
        serde_json::from_value(value).map(Some).map_err(|e| wrong(e.to_string().argument()))
    }

    fn belongs(&self, old: &Manifest) -> Result<(), Diagnostic> {
        const SHOWN: usize = 4;
        if old.input_hash == self.manifest.input_hash {
            return Ok(());
        }
        let mut all = old.differences(&self.manifest);
        let more = all.len().saturating_sub(SHOWN);
        all.truncate(SHOWN);
        if all.is_empty() {
            all.push(text!("the order of its blocks"));
        }
        if more > 0 {
            all.push(text!("and {more} more", more));
        }
        let (path, all) = (self.path.display(), text::list(&all, Joint::Semicolon));
        let message = if old.input == self.manifest.input {
            text!("{path} holds results of another build of the program or another processor: {all}", path, all)
        } else {
            text!("{path} holds results of another input: {all}", path, all)
        };
        Err(Diagnostic::error("store.changed", message)
            .help(text!("give the new results another folder with --out, or start anew with --fresh (which removes the old ones)")))
    }

    /// Keeps the chunks whose files are sound: those of the manifest by its checksums, and those written just before a kill by the checksum they hold and
    /// their mark.
    fn verify(&mut self, plan: &Plan, host: &dyn Host, mine: &[usize]) -> Result<(), Diagnostic> {
        let listed = std::mem::take(&mut self.manifest.chunks);
        for &index in mine {
            let path = self.file(index);
            let entry = listed.iter().find(|e| e.chunk == index);
            let bytes = match fs::read(&path) {
                Ok(bytes) => Some(bytes),
                Err(e) if e.kind() == io::ErrorKind::NotFound => None,
                Err(e) => return Err(self.unreadable(&path, &e)),
            };
            let sum = bytes.as_ref().map(|b| sha256(b));
            let sound = match (&sum, entry) {
                (None, None) => continue,
                (None, Some(_)) => Err(text!("missing")),
                (Some(sum), Some(e)) if *sum == e.sha256 => Ok(()),
                (Some(_), Some(_)) => Err(text!("damaged")),
                (Some(_), None) => self.unlisted(index, plan, bytes.as_deref().unwrap_or_default()),
            };
            match (sound, sum) {
                (Ok(()), Some(sha256)) => self.manifest.chunks.push(Entry { chunk: index, file: name_of(index), sha256 }),
                (Ok(()), None) => {}
                (Err(why), _) => {
                    let rows = plan.range(index);
                    let (path, first, last) = (path.display(), rows.start, rows.end - 1);
                    host.note(&match self.work {
                        Work::Collect => text!("{path} is {why}: rows {first} to {last} are missing", path, why, first, last),
                        _ => text!("{path} is {why}: rows {first} to {last} are computed again", path, why, first, last),
                    });
                }
            }
        }
        Ok(())
    }

    pub fn has(&self, index: usize) -> bool {
        self.manifest.chunks.binary_search_by_key(&index, |e| e.chunk).is_ok()
    }

    /// Whether a chunk that no manifest names is sound, else why not.
    fn unlisted(&self, index: usize, plan: &Plan, bytes: &[u8]) -> Result<(), Text> {
        if !parquet::sealed(bytes) {
            return Err(text!("damaged"));
        }
        match self.read(index, &plan.columns) {
            Ok((cells, mark)) if mark == self.mark(index) && cells.iter().all(|c| c.len() == plan.range(index).len()) => Ok(()),
            _ => Err(text!("not of this study")),
        }
    }

    fn mark(&self, index: usize) -> String {
        mark(&self.manifest.input_hash, index)
    }

    /// Writes a chunk, then the manifest that names it.
    pub fn put(&mut self, index: usize, columns: &[Column], cells: &[Cells]) -> Result<(), Diagnostic> {
        let bytes = parquet::encode(columns, cells, &self.mark(index))
            .map_err(|e| Diagnostic::error("store.write", text!("chunk {index} cannot be written as Parquet: {e}", index, e)))?;
        let path = self.file(index);
        write_whole(&path, &bytes, Lasting::PowerLoss).map_err(|e| self.unwritable(&path, &e))?;
        let at = self.manifest.chunks.partition_point(|e| e.chunk < index);
        self.manifest.chunks.insert(at, Entry { chunk: index, file: name_of(index), sha256: sha256(&bytes) });
        self.write_manifest()
    }

    pub fn read(&self, index: usize, columns: &[Column]) -> Result<(Vec<Cells>, String), Diagnostic> {
        let path = self.file(index);
        parquet::decode(&path, columns)
            .map_err(|e| Diagnostic::error("store.read", text!("cannot read {path}: {e}", path = path.display(), e)))
    }

    fn write_manifest(&self) -> Result<(), Diagnostic> {
        if matches!(self.work, Work::Piece(_)) {
            return Ok(());
        }
        let path = self.path.join(MANIFEST);
        let text = self.manifest.text().map_err(|e| Diagnostic::error("store.write", text!("the manifest cannot be written: {e}", e)))?;
        // a chunk that no manifest names yet is found by its mark: it is kept too
        write_whole(&path, text.as_bytes(), Lasting::PowerLoss).map_err(|e| self.unwritable(&path, &e))
    }

    fn unwritable(&self, path: &Path, e: &io::Error) -> Diagnostic {
        let kept = self.manifest.chunks.len();
        let all = self.manifest.rows.div_ceil(self.manifest.chunk_rows);
        let message = text!("cannot write {path}: {e}; {kept} of {all} chunks are complete and kept", path = path.display(), e, kept, all);
        Diagnostic::error("store.write", message)
            .help(text!("make room or mend the folder, then run the same command: it continues from there"))
    }

    fn unreadable(&self, path: &Path, e: &io::Error) -> Diagnostic {
        Diagnostic::error("store.read", text!("cannot read {path}: {e}", path = path.display(), e))
            .help(text!("name another folder with --out"))
    }
}

/// What a chunk says of itself: the study it belongs to, and its place in it.
pub fn mark(input_hash: &str, index: usize) -> String {
    format!("{input_hash} chunk {index}")
}

pub fn name_of(index: usize) -> String {
    format!("chunk-{index:06}.parquet")
}

fn index_of(name: &str) -> Option<usize> {
    let digits = name.strip_prefix("chunk-")?.strip_suffix(".parquet")?;
    if digits.len() >= 6 && digits.bytes().all(|b| b.is_ascii_digit()) { digits.parse().ok() } else { None }
}
