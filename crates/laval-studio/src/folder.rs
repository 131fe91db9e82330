//! Machine files of the folder that the server was started in, and no others.

use laval::diagnostic::Diagnostic;
use laval::text;
use std::fs::{self, File};
use std::io::{Read, Write};
use std::path::{Component, Path, PathBuf};

/// Largest machine file, bytes.
pub(crate) const LARGEST: u64 = 2 << 20;
/// Files that are listed.
const MOST: usize = 200;
/// Folders within folders that are listed.
const DEEPEST: usize = 2;

fn wrong(message: text::Text) -> Diagnostic {
    Diagnostic::error("studio.file", message)
}

/// The path of a machine file by its name in the folder: plain names joined by `/`, of a file that lies there and is reached through no link that leads out.
pub(crate) fn path(folder: &Path, name: &str) -> Result<PathBuf, Diagnostic> {
    let outside = || wrong(text!("{name} is no machine file (.toml) in the folder of the studio", name = text::quoted(&name)));
    let path = Path::new(name);
    let plain = path.components().all(|c| matches!(c, Component::Normal(_)));
    if name.is_empty() || !plain || name.contains(['\0', '\\', ':']) || path.extension().is_none_or(|e| e != "toml") {
        return Err(outside());
    }
    let full = folder.join(path);
    let home = full.parent().and_then(|p| p.canonicalize().ok()).ok_or_else(outside)?;
    // of a file that exists the end of its links counts
    let there = match full.symlink_metadata() {
        Ok(_) => full.canonicalize().map_err(|_| outside())?,
        Err(_) => home.join(full.file_name().ok_or_else(outside)?),
    };
    if there.starts_with(folder) && home.starts_with(folder) { Ok(there) } else { Err(outside()) }
}

/// Reads a machine file.
pub(crate) fn read(folder: &Path, name: &str) -> Result<String, Diagnostic> {
    let path = self::path(folder, name)?;
    if !path.is_file() {
        return Err(wrong(text!("there is no file {path}", path = name)));
    }
    let mut text = String::new();
    match File::open(&path).and_then(|f| f.take(LARGEST + 1).read_to_string(&mut text)) {
        Ok(n) if n as u64 > LARGEST => Err(wrong(text!("{path} is larger than {size} MB", path = name, size = LARGEST >> 20))),
        Ok(_) => Ok(text),
        Err(e) => Err(wrong(text!("cannot read {path}: {e}", path = name, e = e.to_string()))),
    }
}

/// Why a file was not saved.
pub(crate) enum Unsaved {
    /// It is another than the page knows.
    Changed(Diagnostic),
    /// It cannot be written.
    Wrong(Diagnostic),
}

/// Writes a machine file, unless it is another than `base`, the text that was read or written last; `force` writes it all the same.
pub(crate) fn save(folder: &Path, name: &str, text: &str, base: Option<&str>, force: bool) -> Result<(), Unsaved> {
    let path = self::path(folder, name).map_err(Unsaved::Wrong)?;
    if path.is_dir() {
        return Err(Unsaved::Wrong(wrong(text!("{path} is a folder", path = name))));
    }
    if path.exists() && !force {
        let now = read(folder, name).map_err(Unsaved::Wrong)?;
        if base != Some(now.as_str()) && now != text {
            let d = wrong(text!("{path} has changed on the disk since it was opened", path = name));
            return Err(Unsaved::Changed(d));
        }
    }
    write(&path, text).map_err(|e| Unsaved::Wrong(wrong(text!("cannot write {path}: {e}", path = name, e = e.to_string()))))
}

/// Whole or not at all.
fn write(path: &Path, text: &str) -> std::io::Result<()> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(format!(".{}.part", std::process::id()));
    let beside = path.with_file_name(name);
    let written = File::create(&beside).and_then(|mut f| f.write_all(text.as_bytes()).and_then(|()| f.sync_all()));
    let done = written.and_then(|()| fs::rename(&beside, path));
    if done.is_err() {
        // the reason of the failure matters, not that of the clean-up
        let _ = fs::remove_file(&beside);
    }
    done
}

/// Names of the machine files.
pub(crate) fn list(folder: &Path) -> Vec<String> {
    let mut out = Vec::new();
    collect(folder, "", 0, &mut out);
    out.sort();
    out.truncate(MOST);
    out
}

fn collect(folder: &Path, before: &str, depth: usize, out: &mut Vec<String>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let (Ok(kind), Ok(name)) = (entry.file_type(), entry.file_name().into_string()) else { continue };
        if name.starts_with('.') || out.len() >= 10 * MOST {
            continue;
        }
        if kind.is_dir() && depth < DEEPEST && name != "target" && name != "out" {
            collect(&entry.path(), &format!("{before}{name}/"), depth + 1, out);
        } else if kind.is_file() && name.ends_with(".toml") && machine(&entry.path()) {
            out.push(format!("{before}{name}"));
        }
    }
}

/// A file that has parts of a machine, by its first lines.
fn machine(path: &Path) -> bool {
    let mut text = Vec::new();
    let read = File::open(path).and_then(|f| f.take(16 << 10).read_to_end(&mut text));
    read.is_ok() && String::from_utf8_lossy(&text).contains("part")
}

/// The name of a file in the folder.
pub(crate) fn name_of(folder: &Path, file: &Path) -> Option<String> {
    let full = if file.is_absolute() { file.to_path_buf() } else { folder.join(file) };
    let full = full.canonicalize().ok()?;
    let names: Option<Vec<&str>> = full.strip_prefix(folder).ok()?.components().map(|c| c.as_os_str().to_str()).collect();
    Some(names?.join("/"))
}
