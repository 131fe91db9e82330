//! From a folder of documents to the pages of a gallery.

use super::case::Case;
use super::check::check;
use super::gallery::Page;
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// A document of a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    /// `topic/case`: its folder and its name without extension.
    pub id: String,
    /// Where it lies.
    pub path: PathBuf,
    /// What it says.
    pub text: String,
}

/// The documents `*.md` in a folder and the folders below it, in order of their ids; `README.md` is not a case.
///
/// # Errors
/// When a folder or document cannot be read, with its path.
pub fn documents(folder: &Path) -> Result<Vec<Document>, (PathBuf, io::Error)> {
    let mut out = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        let at = |e: io::Error| (folder.clone(), e);
        for entry in fs::read_dir(&folder).map_err(at)? {
            let path = entry.map_err(at)?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "md") && path.file_name().is_some_and(|n| n != "README.md") {
                let text = fs::read_to_string(&path).map_err(|e| (path.clone(), e))?;
                let words = |p: Option<&std::ffi::OsStr>| p.map_or(String::new(), |w| w.to_string_lossy().into_owned());
                let topic = fs::canonicalize(&folder).map_err(at)?;
                let id = format!("{}/{}", words(topic.file_name()), words(path.file_stem()));
                out.push(Document { id, path, text });
            }
        }
    }
    out.sort_by(|a, b| a.id.cmp(&b.id).then_with(|| a.path.cmp(&b.path)));
    Ok(out)
}

/// Reads and runs documents, several at a time; the pages come in the order of the documents. `each` is called as pages are done.
pub fn run(documents: &[Document], each: impl Fn(&Page) + Sync) -> Vec<Page> {
    let one = |d: &Document| {
        let page = match Case::parse(&d.id, &d.text) {
            Ok(case) => Page::Checked(Box::new(check(case))),
            Err(found) => Page::Unreadable { id: d.id.clone(), text: d.text.clone(), found },
        };
        each(&page);
        page
    };
    documents.par_iter().map(one).collect()
}
