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
    catalogues();
}

/// The sentences of reports, `text/LANGUAGE/NAME.ftl`, as a table of language, name and text.
fn catalogues() {
    println!("cargo:rerun-if-changed=text");
    let mut all = files("text".into());
    all.sort();
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let word = |p: Option<&std::ffi::OsStr>| p.unwrap_or_default().to_string_lossy().into_owned();
    let line = |path: &PathBuf| {
        let language = word(path.parent().and_then(Path::file_name));
        format!("    ({language:?}, {:?}, include_str!({:?})),\n", word(path.file_stem()), root.join(path).to_string_lossy())
    };
    let lines: String = all.iter().filter(|p| p.extension().is_some_and(|e| e == "ftl")).map(line).collect();
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default()).join("catalogues.rs");
    let text = format!("const CATALOGUES: &[(&str, &str, &str)] = &[\n{lines}];\n");
    fs::write(&out, text).unwrap_or_else(|e| panic!("cannot write {}: {e}", out.display()));
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
