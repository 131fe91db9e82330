//! The studies of free and self-excited whirls and of methods, from a machine file: what they say, draw and refuse.

use crate::common;

use common::planar_file::{oil, planar_file};
use laval::file::{Form, load, render};
use laval::outcome::{Data, End, Level, Outcome};
use laval::report::draw;
use laval::study::{Cancel, Context, Silent};

fn machine(law: &str, damping: [&str; 2], liquid: &str, study: &str) -> String {
    let rotor = planar_file(law, "1 mm", damping).replace("[machine]\n", "[machine]\nspeed = \"1820 rad/s\"\n");
    format!("{rotor}{liquid}\n[[study]]\n{study}\n")
}

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{}", render(&d, text, "m.toml", Form::Lines)));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{d:?}"));
    for f in &o.figures {
        assert!(!f.alt.key.is_empty() && draw(f, &o.tables).unwrap().contains("<path"));
    }
    o
}

fn refused(text: &str) -> String {
    let loaded = load(text).unwrap_or_else(|d| panic!("{}", render(&d, text, "m.toml", Form::Lines)));
    loaded.refusals().into_iter().map(|r| r.diagnostic.message.to_string()).collect::<Vec<_>>().join("; ")
}

fn ids(o: &Outcome) -> Vec<&str> {
    o.findings.iter().map(|f| f.id.as_str()).collect()
}

#[test]
fn backbone_says_what_keeps_it_going() {
    let free = run(&machine("isotropic", ["0", "0"], &oil("65.1 mm", "0"), "kind = \"backbone\""));
    assert_eq!(free.end, End::Reached);
    assert!(ids(&free).contains(&"undamped") && ids(&free).contains(&"asymptotes"), "{:?}", ids(&free));
    // forward and backward whirls of foundation and bearing, and two of the liquid's waves
    assert_eq!(ids(&free).iter().filter(|i| **i == "family").count(), 6);
    assert!(free.find_table("backbone").is_some_and(|t| t.rows() > 60) && free.find_table("asymptotes").is_some_and(|t| t.rows() == 4));
    // a whirl passes the frequency of the spin where the fourth family crosses it
    let met = free.special_points.iter().find(|p| p.kind == "synchronous");
    assert!(met.is_none_or(|p| p.at > 0.0));
    let damped = run(&machine("per_axis", ["42", "6.59"], "", "kind = \"backbone\"\nharmonics = 7"));
    let drive = damped.findings.iter().find(|f| f.id == "driven").unwrap().value.unwrap();
    // between the decay rates of rotor and foundation, damping over mass
    assert!(drive > 6.59 / 25.0 && drive < 42.0 / 2.4, "{drive}");
}

#[test]
fn limit_cycles_tell_soft_from_hard() {
    let speed =
        |from: &str, to: &str| format!("kind = \"limit_cycles\"\nspeed = {{ from = \"{from} rad/s\", to = \"{to} rad/s\", points = 120 }}");
    let o = run(&machine("isotropic", ["42", "6.59"], &oil("65.1 mm", "20"), &speed("1500", "6000")));
    assert_eq!(o.end, End::Reached);
    for id in ["soft_onset", "hard_onset", "whirl_beside_rest", "largest_whirl", "unstable_family"] {
        assert!(ids(&o).contains(&id), "{id}: {:?}", ids(&o));
    }
    assert_eq!(o.special_points.iter().filter(|p| p.kind == "Hopf").count(), 2);
    // the foundation's whirl deflects the bearing too little to be held by it
    let low = run(&machine("isotropic", ["42", "6.59"], &oil("65.1 mm", "20"), &speed("60", "400")));
    assert!(ids(&low).contains(&"unbounded_whirl"), "{:?}", ids(&low));
    assert!(low.find_table("cycles").unwrap().rows() < 400);
    // stable throughout, and unstable throughout
    let still = run(&machine("isotropic", ["42", "6.59"], &oil("65.1 mm", "20"), &speed("4000", "6000")));
    assert!(ids(&still).contains(&"no_edge") && still.find_table("cycles").is_none());
    let grows = run(&machine("isotropic", ["42", "6.59"], &oil("65.1 mm", "0"), &speed("4000", "6000")));
    assert!(ids(&grows).contains(&"no_edge_unstable"));
}

/// The size of a whirl that a part's law does not reach is no result, and its curve is grey.
#[test]
fn sizes_outside_validity_are_invalid() {
    let study = "kind = \"limit_cycles\"\nspeed = { from = \"1500 rad/s\", to = \"6000 rad/s\", points = 120 }";
    let text = machine("isotropic", ["42", "6.59"], &oil("65.1 mm", "20"), study);
    let law = "cubic_stiffness = \"8.7e10 N/m^3\"\n";
    // a hundred times the cubic stiffness makes all whirls ten times smaller: the thin layer of oil is inside its validity
    let within = |reach: &str| run(&text.replace(law, &format!("cubic_stiffness = \"8.7e12 N/m^3\"\nvalid_to = \"{reach}\"\n")));
    let level = |o: &Outcome, id: &str| o.findings.iter().find(|f| f.id == id).map(|f| f.level);
    let (wide, short) = (within("1 m"), within("0.1 mm"));
    assert!(wide.findings.iter().all(|f| f.level != Level::Invalid));
    assert_eq!((level(&wide, "largest_whirl"), level(&wide, "whirl_beside_rest")), (Some(Level::Info), Some(Level::Warning)));
    assert_eq!((level(&short, "largest_whirl"), level(&short, "whirl_beside_rest")), (Some(Level::Invalid), Some(Level::Invalid)));
    let of = |o: &Outcome, id: &str| o.findings.iter().find(|f| f.id == id).unwrap().clone();
    assert_eq!(of(&wide, "largest_whirl").value, of(&short, "largest_whirl").value);
    assert!(of(&short, "largest_whirl").sentence().contains("Not valid"), "{}", of(&short, "largest_whirl").sentence());
    // the flag is that of the use of validity, and the axis does not reach for what is outside
    let t = short.find_table("cycles").unwrap();
    let column = |name: &str| t.column(name).unwrap();
    let Data::Flag(valid) = &column("valid").data else { panic!() };
    assert!((0..t.rows()).all(|i| valid[i] == (column("validity").number(i).unwrap() <= 1.0)));
    assert!(valid.contains(&true) && valid.contains(&false));
    let svg = |o: &Outcome| draw(&o.figures[0], &o.tables).unwrap();
    assert!(svg(&short).contains("outside validity") && !svg(&wide).contains("outside validity"));
}

#[test]
fn methods_name_what_is_left_out() {
    let study = "kind = \"methods\"\nspeed = { from = \"1500 rad/s\", to = \"3000 rad/s\", points = 5 }";
    let o = run(&machine("per_axis", ["42", "6.59"], "", study));
    assert_eq!(o.end, End::Reached);
    let of = |whose: &str| o.findings.iter().find(|f| f.id == "deviation" && f.subject == whose).and_then(|f| f.value).unwrap();
    assert!(of("harmonic balance to order 1") > 10.0 * of("harmonic balance to order 3"));
    assert!(of("elliptic balance") < 0.1 * of("averaging") && of("time integration") < 1e-6);
    assert!(o.find_table("folds").is_some_and(|t| t.rows() == 5));
    let round = run(&machine("isotropic", ["42", "6.59"], "", study));
    assert!(ids(&round).contains(&"no_elliptic_balance") && ids(&round).contains(&"one_harmonic_exact"));
}

#[test]
fn unfit_machines_are_refused_before_the_run() {
    let cycles = "kind = \"limit_cycles\"\nspeed = { from = \"1500 rad/s\", to = \"6000 rad/s\" }";
    let undamped = refused(&machine("isotropic", ["0", "0"], &oil("65.1 mm", "0"), cycles));
    assert!(undamped.contains("nothing damps this machine"), "{undamped}");
    let linear = |study: &str| {
        let text = machine("isotropic", ["42", "6.59"], "", study);
        let from = text.find("[[part]]\nkind = \"bearing_cubic\"").unwrap();
        let to = text.find("[[part]]\nkind = \"damper\"").unwrap();
        refused(
            &(text[..from].to_string()
                + "[[part]]\nkind = \"shaft_lumped\"\nname = \"spindle\"\nbetween = [\"drum\", \"base\"]\nstiffness = \"1e7 N/m\"\n\n"
                + &text[to..]),
        )
    };
    for study in [cycles, "kind = \"backbone\""] {
        assert!(linear(study).contains("all parts of this machine are linear"), "{study}: {}", linear(study));
    }
}

/// A stop on request and the limit on work end every study early, with what was found.
#[test]
fn studies_stop_when_requested() {
    let stop = Cancel::new(true);
    for study in [
        "kind = \"backbone\"",
        "kind = \"limit_cycles\"\nspeed = { from = \"1500 rad/s\", to = \"6000 rad/s\" }",
        "kind = \"methods\"\nspeed = { from = \"1500 rad/s\", to = \"3000 rad/s\" }",
    ] {
        let text = machine("per_axis", ["42", "6.59"], &oil("65.1 mm", "20"), study);
        let loaded = load(&text).unwrap();
        let context = Context { name: "study", cancel: &stop, progress: &Silent, work_limit: u64::MAX, keep: None };
        if let Ok(o) = loaded.studies[0].study.run(&loaded.system, &context) {
            assert_ne!(o.end, End::Reached, "{study}");
        }
        let limited = Context { work_limit: 3, ..Context::quiet("study") };
        let o = loaded.studies[0].study.run(&loaded.system, &limited).unwrap();
        assert_ne!(o.end, End::Reached, "{study}");
    }
}

/// At rest every whirl of a round machine goes round either way: one family for each pair, whatever rounding a stiff mode leaves in the frequency of a soft
/// one. A wheel that turns, however slowly, has different families both ways, all of them kept; and a family
/// has the frequency at which it begins, that of vanishing amplitude, not of its first amplitude.
#[test]
fn families_of_both_directions() {
    let study = "kind = \"backbone\"\namplitude = { from = \"20 um\", to = \"100 um\" }\nharmonics = 3\nspeed";
    let machine = |stiffness: f64, speed: f64| {
        format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 2\ndiametral_inertia = 0.01\npolar_inertia = 0.016\n\
             [[part]]\nkind = \"foundation\"\nname = \"base\"\nmass = 20\nstiffness = {stiffness}\n\
             [[part]]\nkind = \"bearing_cubic\"\nname = \"upper\"\nbetween = [{{ body = \"rotor\", at = 0.1 }}, \"base\"]\nlaw = \"isotropic\"\nstiffness = 2e5\ncubic_stiffness = 1e13\n\
             [[part]]\nkind = \"bearing_cubic\"\nname = \"lower\"\nbetween = [{{ body = \"rotor\", at = -0.06 }}, \"base\"]\nlaw = \"isotropic\"\nstiffness = 3e5\ncubic_stiffness = 1e13\n\
             [[study]]\n{study} = {speed}\n"
        )
    };
    let families = |o: &Outcome| o.findings.iter().filter(|f| f.id == "family").map(|f| f.value.unwrap()).collect::<Vec<_>>();
    for stiffness in [1e5, 1e12] {
        let o = run(&machine(stiffness, 0.0));
        let own = families(&o);
        assert!(own.len() == 3 && own.iter().all(|w| *w > 0.0), "{stiffness}: {own:?}");
        let modes = o.find_table("modes").unwrap();
        for (k, w) in own.iter().enumerate() {
            let near = (0..modes.rows()).filter(|&i| (modes.column("frequency").unwrap().number(i).unwrap().abs() / w - 1.0).abs() < 1e-6);
            assert!(near.count() == 2, "{stiffness}: {k} of {own:?}");
        }
        // the first amplitude has a frequency of its own
        let first = o.find_table("backbone").unwrap().column("frequency").unwrap().number(0).unwrap();
        assert!((first / own[0] - 1.0).abs() > 3e-6, "{first} {own:?}");
        // both senses of the stiff whirl of the base are one to rounding
        let soft = |w: &&f64| w.abs() < 1e5;
        let each = own.iter().filter(soft).count();
        for speed in [10.0, 300.0] {
            let turning: Vec<f64> = families(&run(&machine(stiffness, speed))).iter().filter(soft).copied().collect();
            assert_eq!((turning.iter().filter(|w| **w > 0.0).count(), turning.len()), (each, 2 * each), "{speed}: {turning:?}");
        }
    }
}
