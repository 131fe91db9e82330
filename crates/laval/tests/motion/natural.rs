//! Natural frequencies beside the spectra of a motion.

use laval::file::{Form, load, render};
use laval::outcome::Data;
use laval::study::Context;

/// A disc on a shaft: sqrt(k/m - (c/2m)^2) at every speed, forward and backward.
#[test]
fn waterfalls_have_the_natural_frequencies_of_the_machine() {
    let text = "[machine]\nspeed = 150.0\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 3.0\neccentricity = 2e-5\n\
                [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 3e4\n\
                [[part]]\nkind = \"damper\"\nbetween = [\"disc\", \"ground\"]\ndamping = 30.0\n\
                [[study]]\nkind = \"run_up\"\nfrom = 50.0\nto = 250.0\nduration = 4.0\nwaterfall = \"disc\"\nspectra = 12\n";
    let loaded = load(text).unwrap_or_else(|d| panic!("{}", render(&d, text, "m.toml", Form::Lines)));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("run-up")).unwrap();
    let t = o.find_table("natural_frequencies").expect("lines");
    let number = |column: &str, row: usize| t.column(column).unwrap().number(row).unwrap();
    let want = (3e4 / 3.0 - 25.0f64).sqrt();
    assert_eq!(t.rows(), 24);
    for r in 0..t.rows() {
        assert!((number("frequency", r).abs() / want - 1.0).abs() < 1e-9 && number("frequency", r) * number("line", r) > 0.0);
        assert!((number("order", r) * number("speed", r) - number("frequency", r)).abs() < 1e-9);
    }
    let Data::Flag(observed) = &t.column("observed").unwrap().data else { panic!("a flag") };
    assert!(observed.iter().all(|o| !o));
    let svg = laval::report::draw(o.figures.iter().find(|f| f.name == "waterfall").expect("a figure"), &o.tables).unwrap();
    assert!(svg.contains("natural frequency") && !svg.contains("line 1") && svg.matches("stroke-dasharray=\"6 4\"").count() >= 3);
}
