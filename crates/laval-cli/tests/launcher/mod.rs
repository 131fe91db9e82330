//! The program in a folder of its own.

// every test file is a crate of its own and uses some of these
#![allow(dead_code)]

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A folder that is removed in the end.
pub struct Dir(pub PathBuf);

impl Dir {
    pub fn new(name: &str) -> Dir {
        let dir = std::env::temp_dir().join(format!("laval-cli-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&dir);
        fs::create_dir_all(&dir).unwrap();
        Dir(dir)
    }

    pub fn file(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, content).unwrap();
        path
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap()
    }

    pub fn command<S: AsRef<OsStr>>(&self, args: impl IntoIterator<Item = S>) -> Command {
        let mut c = Command::new(env!("CARGO_BIN_EXE_laval"));
        c.args(args).current_dir(&self.0).env("LC_ALL", "C");
        c
    }

    pub fn laval<S: AsRef<OsStr>>(&self, args: impl IntoIterator<Item = S>) -> Said {
        Said::of(&self.command(args).output().unwrap())
    }
}

impl Drop for Dir {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// What the program said, and its exit code.
pub struct Said {
    pub code: i32,
    pub out: String,
    pub err: String,
}

impl Said {
    pub fn of(o: &Output) -> Said {
        Said {
            code: o.status.code().unwrap(),
            out: String::from_utf8(o.stdout.clone()).unwrap(),
            err: String::from_utf8(o.stderr.clone()).unwrap(),
        }
    }

    /// Refused with these words on standard error, and nothing on standard output.
    pub fn refused(&self, words: &[&str]) {
        assert_eq!((self.code, self.out.as_str()), (1, ""), "{}", self.err);
        for w in words {
            assert!(self.err.contains(w), "{w:?} in\n{}", self.err);
        }
    }

    pub fn done(&self) -> &str {
        assert_eq!((self.code, self.err.as_str()), (0, ""));
        &self.out
    }
}

/// A machine with one mode pair.
pub const ROTOR: &str = r#"
[machine]
name = "rotor"
speed = "300 rad/s"
[[part]]
kind = "disc"
name = "d"
mass = "1 kg"
eccentricity = "10 um"
[[part]]
kind = "shaft_lumped"
between = ["d", "ground"]
stiffness = "1e5 N/m"
[[part]]
kind = "damper"
between = ["d", "ground"]
damping = "10 N s/m"
"#;

/// Every file below `dir` with its content.
pub fn tree(dir: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut out = BTreeMap::new();
    let mut open = vec![dir.to_path_buf()];
    while let Some(d) = open.pop() {
        for path in fs::read_dir(d).unwrap().map(|e| e.unwrap().path()) {
            if path.is_dir() {
                open.push(path);
            } else {
                out.insert(path.strip_prefix(dir).unwrap().to_path_buf(), fs::read(&path).unwrap_or_default());
            }
        }
    }
    out
}
