//! The identity of a build: all that settles numbers beside the machine file and the processor.

#[path = "src/hash.rs"]
mod hash;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Sources that settle numbers. A package from a registry has no siblings: its version stands for theirs.
const SOURCES: [&str; 5] = ["src", "../laval-model/src", "../laval-num/src", "../laval-solve/src", "../../Cargo.lock"];

fn main() {
    let mut all = Vec::new();
    for source in SOURCES.into_iter().filter(|s| Path::new(s).exists()) {
        println!("cargo:rerun-if-changed={source}");
        let mut files = files(source.into());
        files.sort();
        for file in files {
            let content = fs::read(&file).unwrap_or_else(|e| panic!("cannot read {}: {e}", file.display()));
            let name = file.to_string_lossy().replace('\\', "/");
            all.push(format!("{name} {}", hash::sha256(&content)));
        }
    }
    for name in ["CARGO_PKG_VERSION", "TARGET", "OPT_LEVEL", "CARGO_CFG_TARGET_FEATURE"] {
        all.push(format!("{name} {}", env::var(name).unwrap_or_default()));
    }
    let compiler = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into())).arg("-vV").output();
    all.push(compiler.map_or_else(|e| e.to_string(), |o| String::from_utf8_lossy(&o.stdout).into_owned()));
    println!("cargo:rustc-env=LAVAL_BUILD={}", &hash::sha256(all.join("\n").as_bytes())[..16]);
}

fn files(path: PathBuf) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path];
    }
    let inside = fs::read_dir(&path).unwrap_or_else(|e| panic!("cannot read {}: {e}", path.display()));
    inside.flat_map(|entry| files(entry.unwrap_or_else(|e| panic!("cannot read {}: {e}", path.display())).path())).collect()
}
