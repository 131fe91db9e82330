//! A machine moves as it does beside other bodies that nothing joins to it, with which it is large enough to be integrated by entries of its matrices.

use laval::file::{Form, load, render};
use laval::study::Context;

const DISC: &str = "[machine]\nspeed = 150\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 3\neccentricity = 2e-4\n";
const SPRING: &str = "[[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 3e4\n\
                      [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 30\n";
/// The waves on its liquid are internal states.
const LIQUID: &str = "[[part]]\nkind = \"liquid\"\nname = \"oil\"\nin = \"disc\"\ncavity_radius = 0.15\ncavity_height = 0.08\ndensity = 1000\n\
                      fill = { volume_fraction = 0.2 }\nwave_damping = \"4 1/s\"\n";
/// What its shaft remembers is an internal state, in axes that turn.
const MEMORY: &str = "[[part]]\nkind = \"shaft_viscoelastic\"\nname = \"shaft\"\nbetween = [\"disc\", \"ground\"]\nmemory = \"rotor\"\nstiffness = 3e4\n\
                      exponentials = { share = [0.05, 0.1, 0.2], rate = [5, 60, 400] }\n\
                      [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 30\n";

/// Seven discs on springs of their own.
fn bystanders() -> String {
    (0..7)
        .map(|k| {
            format!(
                "[[part]]\nkind = \"disc\"\nname = \"other_{k}\"\nmass = 2\n[[part]]\nkind = \"shaft_lumped\"\nname = \"spring_{k}\"\n\
                 between = [\"other_{k}\", \"ground\"]\nstiffness = 2e4\n"
            )
        })
        .collect()
}

/// Displacements of the disc in time.
fn moves(parts: &str, study: &str) -> Vec<f64> {
    let text = format!("{DISC}{parts}{study}");
    let loaded = load(&text).unwrap_or_else(|d| panic!("{}", render(&d, &text, "m.toml", Form::Lines)));
    let done = loaded.studies[0].study.run(&loaded.system, &Context::quiet("motion")).unwrap();
    let t = done.find_table("motion").expect("a motion");
    ["disc.x", "disc.y"].iter().flat_map(|c| (0..t.rows()).map(|r| t.column(c).unwrap().number(r).unwrap())).collect()
}

#[test]
fn motions_beside_other_bodies_are_the_same() {
    let liquid = format!("{SPRING}{LIQUID}");
    for (name, parts, methods) in [("liquid", &*liquid, &["explicit", "stiff"][..]), ("memory", MEMORY, &["stiff"])] {
        for kind in ["kind = \"transient\"", "kind = \"run_up\"\nfrom = 50\nto = 200"] {
            for method in methods {
                let study = format!(
                    "[[study]]\n{kind}\nduration = 0.4\npoints = 50\nmethod = \"{method}\"\nrelative_tolerance = 1e-10\n\
                     initial = {{ \"disc.x\" = 1e-3, \"disc.y'\" = 0.05 }}\n"
                );
                let (alone, beside) = (moves(parts, &study), moves(&format!("{parts}{}", bystanders()), &study));
                let size = alone.iter().fold(0.0f64, |s, x| s.max(x.abs()));
                let off = alone.iter().zip(&beside).fold(0.0f64, |s, (a, b)| s.max((a - b).abs()));
                assert!(alone.len() == beside.len() && size > 1e-4 && off <= 1e-7 * size, "{name}: {off} of {size}\n{study}");
            }
        }
    }
}
