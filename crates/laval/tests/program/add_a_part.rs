//! `docs/add-a-part.md`: its part is compiled as it stands there, keeps every promise of a part, and works in a machine.

mod rubber_ring;

use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::GRAVITY;
use laval::parts::disc::{Disc, DiscParams};
use laval::parts::kind;
use laval::solve::rest::rest;
use rubber_ring::{RubberRing, RubberRingParams};
use std::path::Path;

fn repository(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)).unwrap().replace('\r', "")
}

/// The page shows the file as it is compiled.
#[test]
fn the_part_of_the_page_is_this_one() {
    let (page, part) = (repository("docs/add-a-part.md"), repository("crates/laval/tests/program/add_a_part/rubber_ring.rs"));
    assert!(page.contains(&format!("```rust\n{part}```\n")), "the page does not show the part as it is compiled");
    assert!(part.lines().count() < 60, "{} lines", part.lines().count());
}

/// Every method of the trait, and every method of a capability, is named on the page.
#[test]
fn the_page_names_every_method() {
    let page = repository("docs/add-a-part.md");
    let methods = |source: &str| {
        let text = repository(source);
        let body: Vec<&str> =
            text.lines().skip_while(|l| !(l.starts_with("pub trait ") && l.contains(": "))).take_while(|l| *l != "}").collect();
        let names = body.iter().filter_map(|l| l.strip_prefix("    fn "));
        names.map(|l| l.split(['(', '<']).next().unwrap_or_default().to_string()).collect::<Vec<_>>()
    };
    let own = methods("crates/laval-model/src/model/part.rs");
    assert!(own.len() >= 20, "{own:?}");
    let mut all = own;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../laval-model/src/model/capability");
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        if name != "mod.rs" {
            let found = methods(&format!("crates/laval-model/src/model/capability/{name}"));
            assert!(!found.is_empty(), "{name}");
            all.extend(found);
        }
    }
    let missing: Vec<&String> = all.iter().filter(|m| !page.contains(&format!("`{m}`"))).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// Twelve or so methods that every author meets; what fewer parts need is a capability.
#[test]
fn a_part_has_few_methods() {
    let text = repository("crates/laval-model/src/model/part.rs");
    let body: Vec<&str> = text.lines().skip_while(|l| !l.starts_with("pub trait Part")).take_while(|l| *l != "}").collect();
    let methods = body.iter().filter(|l| l.starts_with("    fn ") && !l.contains("erased")).count();
    assert!((10..=13).contains(&methods), "{methods}");
}

/// Otherwise every crate that builds a machine would compile their arithmetic once more.
#[test]
fn registered_parts_are_erased_where_they_stand() {
    let registry = repository("crates/laval-model/src/parts/mod.rs");
    for line in registry.lines().filter_map(|l| l.trim().strip_prefix("kind::<")) {
        let module = line.split("::").next().unwrap();
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../laval-model/src/parts");
        let file = [folder.join(format!("{module}.rs")), folder.join(module).join("mod.rs")].into_iter().find(|f| f.exists()).unwrap();
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(text.contains("    #[inline(never)]\n    fn erased(self) -> ErasedPart {"), "{}", file.display());
    }
}

/// In a horizontal machine the ring sags until `m g = k (1 + d^2/a^2) d`.
#[test]
fn the_part_carries_a_rotor() {
    let (mass, k, a) = (80.0, 2e5, 1e-3);
    let ring = RubberRingParams { stiffness: k, doubling: a, damping: 50.0 };
    let system = Builder::new("ring")
        .horizontal()
        .part("drum", Disc::planar(), DiscParams::new(mass))
        .part("ring", RubberRing(Link::Between(Attach::on("drum"), Attach::ground())), ring)
        .build()
        .unwrap();
    let at = rest(&system, 0.0).unwrap();
    let d = -at.q[1];
    assert!(d > a, "the load must reach the nonlinear range: {d}");
    let defect = k * (1.0 + (d / a).powi(2)) * d - mass * GRAVITY;
    assert!(defect.abs() <= 1e-9 * mass * GRAVITY, "{d} {defect}");
    // what the file may say follows from the declarations
    let names: Vec<&str> = kind::<RubberRing>().info.fields.iter().map(|f| f.name).collect();
    assert_eq!(names, ["between", "stiffness", "doubling", "damping"]);
}
