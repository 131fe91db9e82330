//! A folder of results: locked by one process at a time, its files whole or not there.

use crate::diagnostic::Diagnostic;
use crate::text;
use crate::text::Argument;
use std::fs::{self, File, Metadata, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// The file that is locked.
const LOCK: &str = ".lock";

/// A folder that no other process may hold until this value is dropped or the process ends, however it ends.
#[derive(Debug)]
pub struct Held {
    lock: File,
    /// The file names this process.
    number: bool,
}

impl Drop for Held {
    fn drop(&mut self) {
        // the number of a process that has ended misleads nobody, so a failure here may pass
        if self.number {
            let _ = self.lock.set_len(0);
        }
    }
}

impl Held {
    /// Makes the folder where it is missing and takes it beside others that share it; while anybody does, [`take`](Self::take) refuses.
    ///
    /// # Errors
    /// When it cannot be made or written, or another process holds it for itself.
    pub fn share(folder: &Path) -> Result<Held, Diagnostic> {
        make(folder)?;
        Ok(Held { lock: lock(folder, Holding::Shared)?, number: false })
    }

    /// Makes the folder where it is missing, takes it, removes unfinished files that a killed process has left in it, and makes sure that it can be
    /// written.
    ///
    /// # Errors
    /// When it cannot be made or written, or another process holds it.
    pub fn take(folder: &Path) -> Result<Held, Diagnostic> {
        make(folder)?;
        let held = Held { lock: lock(folder, Holding::Alone)?, number: true };
        tidy(folder)?;
        Ok(held)
    }
}

fn make(folder: &Path) -> Result<(), Diagnostic> {
    fs::create_dir_all(folder).map_err(|e| {
        let why = if folder.is_file() { text!("it is a file").argument() } else { e.argument() };
        let d = Diagnostic::error("folder.make", text!("cannot make the folder {folder}: {why}", folder = folder.display(), why));
        d.help(text!("name another one with --out"))
    })
}

/// Removes unfinished files that a killed process has left in a folder, and makes sure that it can be written.
///
/// # Errors
/// When it cannot.
pub fn tidy(folder: &Path) -> Result<(), Diagnostic> {
    let clean = || {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            if entry.file_name().to_str().is_some_and(is_part) && !entry.file_type()?.is_dir() {
                fs::remove_file(entry.path())?;
            }
        }
        let probe = part(folder);
        open_new(&probe)?;
        fs::remove_file(&probe)
    };
    clean().map_err(|e| unwritable(folder, &e))
}

fn unwritable(path: &Path, e: &io::Error) -> Diagnostic {
    Diagnostic::error("folder.write", text!("cannot write {path}: {e}", path = path.display(), e))
        .help(text!("mend the permissions of the folder, or name another one with --out"))
}

/// How a folder is held.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Holding {
    Alone,
    Shared,
}

/// Takes the folder for this process.
fn lock(folder: &Path, holding: Holding) -> Result<File, Diagnostic> {
    let path = folder.join(LOCK);
    let foreign = || {
        Diagnostic::error("folder.lock", text!("{path} was not made by this program and is left as it is", path = path.display()))
            .help(text!("move it elsewhere, or name another folder with --out"))
    };
    // a link would lead to a file of somebody else, which must not be written
    if fs::symlink_metadata(&path).is_ok_and(|m| !m.is_file()) {
        return Err(foreign());
    }
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        // also when it has become a link in between
        options.custom_flags(rustix::fs::OFlags::NOFOLLOW.bits() as i32);
    }
    let mut file = options.open(&path).map_err(|e| unwritable(&path, &e))?;
    if !file.metadata().is_ok_and(|m| m.is_file() && m.len() <= 20 && names(&m) == 1) {
        return Err(foreign());
    }
    let taken = match holding {
        Holding::Alone => file.try_lock(),
        Holding::Shared => file.try_lock_shared(),
    };
    let mut number = String::new();
    let read = file.read_to_string(&mut number);
    match taken {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => {
            // only a courtesy: without the number the message still says what is wrong
            let (number, folder) = (number.trim(), folder.display());
            let message = match number {
                "" => text!("another process is writing into {folder}", folder),
                _ => text!("another process (number {number}) is writing into {folder}", number, folder),
            };
            return Err(
                Diagnostic::error("folder.locked", message).help(text!("wait until it has ended, or name another folder with --out"))
            );
        }
        // a file system without locks: nothing can be held, and nothing is gained by refusing
        Err(TryLockError::Error(e)) if e.kind() == io::ErrorKind::Unsupported => {}
        Err(TryLockError::Error(e)) => return Err(unwritable(&path, &e)),
    }
    if read.is_err() || !number.bytes().all(|b| b.is_ascii_digit()) {
        return Err(foreign());
    }
    if holding == Holding::Shared {
        return Ok(file);
    }
    let number = std::process::id().to_string();
    file.set_len(0).and_then(|()| file.rewind()).and_then(|()| file.write_all(number.as_bytes())).map_err(|e| unwritable(&path, &e))?;
    Ok(file)
}

/// Under how many names a file stands.
fn names(_file: &Metadata) -> u64 {
    #[cfg(unix)]
    {
        std::os::unix::fs::MetadataExt::nlink(_file)
    }
    #[cfg(not(unix))]
    1
}

/// A new name for an unfinished file: of this process and this call alone.
fn part(folder: &Path) -> PathBuf {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    folder.join(format!(".laval-{}-{}.part", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed)))
}

fn is_part(name: &str) -> bool {
    let number = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
    let inner = name.strip_prefix(".laval-").and_then(|n| n.strip_suffix(".part"));
    inner.and_then(|n| n.split_once('-')).is_some_and(|(process, call)| number(process) && number(call))
}

/// Opens a file that is not there, under this very name: no link is followed.
fn open_new(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).create_new(true).open(path)
}

/// A new unfinished file. A process of another computer that writes into the same folder may have the same number: its files are passed over.
fn unfinished(folder: &Path) -> io::Result<(File, PathBuf)> {
    const MOST: usize = 10_000;
    let mut tries = 0;
    loop {
        let path = part(folder);
        match open_new(&path) {
            Ok(file) => return Ok((file, path)),
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists && tries < MOST => tries += 1,
            Err(e) => return Err(e),
        }
    }
}

/// How long a file must last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lasting {
    /// The process may be killed.
    Kill,
    /// The power may fail.
    PowerLoss,
}

/// Writes a file that is whole or as it was, also after a kill: under another name first, then renamed.
///
/// # Errors
/// Why it cannot be written.
pub fn write_whole(path: &Path, bytes: &[u8], lasting: Lasting) -> io::Result<()> {
    write_whole_by(path, lasting, |file| file.write_all(bytes))
}

/// The same of content that is made while it is written.
///
/// # Errors
/// Why it cannot be written, or made.
pub fn write_whole_by(path: &Path, lasting: Lasting, content: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let (mut file, part) = unfinished(folder)?;
    let write = || {
        content(&mut file)?;
        if lasting == Lasting::PowerLoss {
            file.sync_all()?;
        }
        drop(file);
        fs::rename(&part, path)
    };
    if let Err(e) = write() {
        // the reason of the failure matters, not that of the clean-up
        let _ = fs::remove_file(&part);
        return Err(e);
    }
    // the name itself; not every system can do this to a folder
    if lasting == Lasting::PowerLoss
        && let Ok(folder) = File::open(if folder.as_os_str().is_empty() { Path::new(".") } else { folder })
    {
        let _ = folder.sync_all();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_own_names_are_unfinished_files() {
        for own in [".laval-1-0.part", ".laval-4194304-12.part"] {
            assert!(is_part(own));
        }
        for other in
            [".laval-.part", ".laval-1.part", ".laval-1-x.part", "laval-1-0.part", ".laval-1-0.part2", "report.html.part12", ".lock"]
        {
            assert!(!is_part(other));
        }
        assert!(part(Path::new("x")).file_name().and_then(|n| n.to_str()).is_some_and(is_part));
        assert_ne!(part(Path::new("x")), part(Path::new("x")));
    }
}
