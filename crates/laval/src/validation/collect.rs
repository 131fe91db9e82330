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

/// The documents `*.md` in a folder and the folders below it, in order of their ids, numbers in them by value; `README.md` is not a case.
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
    out.sort_by(|a, b| natural(&a.id).cmp(&natural(&b.id)).then_with(|| a.path.cmp(&b.path)));
    Ok(out)
}

/// A key that puts `figure-9` before `figure-10`.
fn natural(id: &str) -> Vec<(u64, &[u8])> {
    let number = |digits: &[u8]| digits.iter().fold(0u64, |n, d| n.saturating_mul(10).saturating_add(u64::from(d - b'0')));
    let pieces = id.as_bytes().chunk_by(|a, b| a.is_ascii_digit() == b.is_ascii_digit());
    pieces.map(|p| if p[0].is_ascii_digit() { (number(p), &p[..0]) } else { (u64::MAX, p) }).collect()
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

#[cfg(test)]
mod tests {
    use super::natural;

    #[test]
    fn numbers_are_ordered_by_value() {
        let mut ids = ["figures-14/9-12", "figures-14/13-26", "figures-2/10", "figures-2/x", "figures-2/9-1", "a"];
        ids.sort_by_key(|id| natural(id).into_iter().map(|(n, t)| (n, t.to_vec())).collect::<Vec<_>>());
        assert_eq!(ids, ["a", "figures-2/9-1", "figures-2/10", "figures-2/x", "figures-14/9-12", "figures-14/13-26"]);
    }
}
