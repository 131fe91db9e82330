//! The program is linked without symbols. `strip` of the profile would also take them from the test programs, one of which reads its own.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        println!("cargo::rustc-link-arg-bins=-Wl,--strip-all");
    }
}
