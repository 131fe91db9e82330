//! The length of a step is that of the forces: a finer shaft, whose highest mode is faster, needs no more of them.

use laval::file::{Form, load, render};
use laval::study::Context;

/// A run-up through the first critical speed on two bearings that stiffen: coordinates, and steps of the implicit method.
fn steps(elements: usize) -> (usize, u64) {
    let bearing = |k: usize, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_cubic\"\nname = \"bearing_{k}\"\nlaw = \"isotropic\"\nbetween = [{{ body = \"shaft\", at = {at} }}, \"ground\"]\n\
             stiffness = 1e7\ncubic_stiffness = 1e15\n[[part]]\nkind = \"damper\"\nname = \"film_{k}\"\n\
             between = [{{ body = \"shaft\", at = {at} }}, \"ground\"]\ndamping = 500\n"
        )
    };
    let text = format!(
        "[machine]\nname = \"m\"\nspeed = 300\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nsection = [{{ length = 1.0, outer_diameter = 0.05 }}]\n\
         elements = {elements}\nmodulus = \"200 GPa\"\nshear_modulus = \"77 GPa\"\ndensity = 7800\n\
         [[part]]\nkind = \"disc\"\nname = \"disc\"\non = {{ body = \"shaft\", at = 0.4 }}\nmass = 20\ndiametral_inertia = 0.1\npolar_inertia = 0.2\n\
         unbalance = \"100 g mm\"\n{}{}[[study]]\nkind = \"run_up\"\nfrom = 100\nto = 400\nduration = 0.3\npoints = 100\nrelative_tolerance = 1e-4\n\
         observables = false\n",
        bearing(1, 0.0),
        bearing(2, 1.0)
    );
    let loaded = load(&text).unwrap_or_else(|d| panic!("{}", render(&d, &text, "m.toml", Form::Lines)));
    let done = loaded.studies[0].study.run(&loaded.system, &Context::quiet("run-up")).unwrap();
    assert!(done.work.contains_key("stiff"), "{:?}", done.work);
    (loaded.system.n(), done.work["steps"])
}

#[test]
fn a_finer_shaft_needs_no_more_steps() {
    let [coarse, fine] = [10, 40].map(steps);
    // the highest frequency grows with the square of the number of elements
    assert!(fine.0 > 3 * coarse.0 && fine.1 < 2 * coarse.1 && fine.1 > 200, "{coarse:?} {fine:?}");
}
