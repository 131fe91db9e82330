//! The identity of a build: all that settles numbers beside the machine file and the processor.

use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Sources that settle numbers. A package from a registry has no siblings: its version stands for theirs.
const SOURCES: [&str; 6] =
    ["src", "../laval-model/src", "../laval-num/src", "../laval-separation/src", "../laval-solve/src", "../../Cargo.lock"];

fn main() {
    // the compiler is part of the identity, so that its hash function may change with it
    let mut all = DefaultHasher::new();
    for source in SOURCES.into_iter().filter(|s| Path::new(s).exists()) {
        println!("cargo:rerun-if-changed={source}");
        let mut files = files(source.into());
        files.sort();
        for file in files {
            let content = fs::read(&file).unwrap_or_else(|e| panic!("cannot read {}: {e}", file.display()));
            let name = file.to_string_lossy().replace('\\', "/");
            add(&mut all, name.as_bytes());
            add(&mut all, &content);
        }
    }
    for name in ["CARGO_PKG_VERSION", "TARGET", "OPT_LEVEL", "CARGO_CFG_TARGET_FEATURE"] {
        add(&mut all, name.as_bytes());
        add(&mut all, env::var(name).unwrap_or_default().as_bytes());
    }
    let compiler = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into())).arg("-vV").output();
    add(&mut all, &compiler.map_or_else(|e| e.to_string().into_bytes(), |o| o.stdout));
    println!("cargo:rustc-env=LAVAL_BUILD={:016x}", all.finish());
}

/// The length keeps neighbours apart.
fn add(all: &mut DefaultHasher, bytes: &[u8]) {
    all.write_usize(bytes.len());
    all.write(bytes);
}

fn files(path: PathBuf) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path];
    }
    let inside = fs::read_dir(&path).unwrap_or_else(|e| panic!("cannot read {}: {e}", path.display()));
    inside.flat_map(|entry| files(entry.unwrap_or_else(|e| panic!("cannot read {}: {e}", path.display())).path())).collect()
}
