//! Where motions in time begin, when their growth can be determined, and what turning the other way means.

use laval::file::load;
use laval::outcome::{Data, Outcome};
use laval::study::Context;

fn run(machine: &str, study: &str) -> Outcome {
    let loaded = load(&format!("{machine}{study}")).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("motion")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn column(o: &Outcome, name: &str) -> Vec<f64> {
    match &o.find_table("motion").unwrap().column(name).unwrap().data {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

fn machine(axis: &str, disc: &str) -> String {
    format!(
        "[machine]\naxis = \"{axis}\"\nspeed = \"150 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 4\n{disc}\
         [[part]]\nkind = \"bearing_cubic\"\nbetween = [\"d\", \"ground\"]\nlaw = \"per_axis\"\nstiffness = \"2e5 N/m\"\ncubic_stiffness = \"5e12 N/m^3\"\n\
         [[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\ndamping = 60\n"
    )
}

/// m g = k s + c s^3 holds at the start, and nothing moves away from there; a vertical machine has no sag.
#[test]
fn a_horizontal_machine_starts_sagged_and_stays() {
    let study = "[[study]]\nkind = \"transient\"\nduration = \"0.5 s\"\n";
    let o = run(&machine("horizontal", ""), study);
    let y = column(&o, "d.y");
    let s = -y[0];
    assert!((2e5 * s + 5e12 * s.powi(3) - 4.0 * 9.80665).abs() < 1e-9 * 40.0, "{s}");
    // what moves is the error of the integration: it goes with the tolerance, down to rounding
    let off = |o: &Outcome| column(o, "d.y").iter().map(|v| (v + s).abs()).fold(0.0, f64::max);
    let fine = format!("{study}relative_tolerance = 1e-12\nabsolute_tolerance = 1e-12\n");
    let (usual, fine) = (off(&o), off(&run(&machine("horizontal", ""), &fine)));
    assert!(usual < 1e-6 * s && fine < 0.02 * usual, "{usual:e} {fine:e}");
    let f = o.findings.iter().find(|f| f.id == "largest_displacement").unwrap();
    assert_eq!(f.value, Some(0.0));
    assert!(f.message.key == "history-at-equilibrium");
    assert!(column(&run(&machine("vertical", ""), study), "d.y").iter().all(|v| *v == 0.0));
    // what the file says is counted from the undeflected place
    let o = run(&machine("horizontal", ""), "[[study]]\nkind = \"transient\"\nduration = \"0.1 s\"\ninitial = { \"d.y\" = 0 }\n");
    assert_eq!(column(&o, "d.y")[0], 0.0);
    let f = o.findings.iter().find(|f| f.id == "largest_displacement").unwrap();
    assert!((f.value.unwrap() - s).abs() < 1e-3 * s, "{f:?}");
}

/// A quarter of a turn says nothing about growth; twenty turns do.
#[test]
fn growth_takes_several_turns() {
    let disc = "eccentricity = \"20 um\"\n";
    let of = |duration: &str| run(&machine("vertical", disc), &format!("[[study]]\nkind = \"transient\"\nduration = \"{duration}\"\n"));
    let has = |o: &Outcome, id: &str| o.findings.iter().any(|f| f.id == id);
    let short = of("10 ms");
    assert!(has(&short, "no_growth_rate") && !has(&short, "growth_rate"));
    let long = of("1 s");
    assert!(has(&long, "growth_rate") && !has(&long, "no_growth_rate"));
}

/// A machine that turns the other way is the mirror image: x as before, y reversed, for tilts and liquid too.
#[test]
fn turning_the_other_way_is_the_mirror_image() {
    let disc = "eccentricity = \"50 um\"\ndiametral_inertia = 0.01\npolar_inertia = 0.018\ncentre_of_mass = \"20 mm\"\n";
    let more = "[[part]]\nkind = \"shaft_lumped\"\nbetween = [\"d\", \"ground\"]\nstiffness = \"1e5 N/m\"\ntilt_stiffness = \"400 N m/rad\"\n\
                [[part]]\nkind = \"liquid\"\nin = \"d\"\ncavity_radius = \"60 mm\"\ncavity_height = \"50 mm\"\ndensity = 900\n\
                fill = { volume_fraction = 0.4 }\nwave_damping = \"5 1/s\"\n";
    let of = |speed: f64, y: f64| {
        let study = format!(
            "{more}[[study]]\nkind = \"transient\"\nspeed = {speed}\nduration = \"0.2 s\"\nrelative_tolerance = 1e-11\nabsolute_tolerance = 1e-11\n\
             initial = {{ \"d.x\" = \"0.1 mm\", \"d.y\" = \"{y} mm\" }}\n"
        );
        run(&machine("vertical", disc), &study)
    };
    let (one, other) = (of(400.0, 0.05), of(-400.0, -0.05));
    let size = column(&one, "d.y").iter().fold(0.0f64, |m, v| m.max(v.abs()));
    assert!(size > 1e-5);
    for (name, sign) in [("d.x", 1.0), ("d.y", -1.0)] {
        for (a, b) in column(&one, name).iter().zip(column(&other, name)) {
            assert!((a - sign * b).abs() < 1e-6 * size, "{name}: {a} {b}");
        }
    }
}
