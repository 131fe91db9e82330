//! A file with several mistakes shows all of them, each once and at its place, and nothing that only follows from them.

use laval::diagnostic::{Diagnostic, Diagnostics, Severity};
use laval::file::{Form, load, render};

/// A valid file with every sort of block.
const MACHINE: &str = r#"[machine]
name = "separator"
speed = "3000 rpm"

[[part]]
kind = "disc"
name = "drum"
mass = "2.4 kg"
eccentricity = "20 um"

[[part]]
kind = "foundation"
name = "base"
mass = "25 kg"
stiffness = "3.26e5 N/m"
damping = "6.59 N s/m"

[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "base"]
law = "per_axis"
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"

[[part]]
kind = "damper"
name = "losses"
between = ["drum", "ground"]
damping = "42 N s/m"

[[part]]
kind = "liquid"
name = "oil"
in = "drum"
cavity_radius = "70 mm"
cavity_height = "60 mm"
density = "880 kg/m^3"
fill = { free_surface_radius = "46.7 mm" }

[[part]]
kind = "disc"
name = "rotor"
mass = "28 kg"
polar_inertia = "1.1 kg m^2"
diametral_inertia = "0.8 kg m^2"

[[part]]
kind = "shaft_lumped"
name = "spindle"
between = ["rotor", "ground"]
stiffness = "1.6e6 N/m"
tilt_stiffness = "1e4 N m/rad"

[[part]]
kind = "disc"
name = "fan"
mass = "1 kg"
polar_inertia = "0.02 kg m^2"
diametral_inertia = "0.01 kg m^2"

[[part]]
kind = "shaft_lumped"
name = "overhang"
between = ["fan", "rotor"]
stiffness = "1e6 N/m"
tilt_stiffness = "1e3 N m/rad"

[[cup]]
kind = "swinging"
name = "buckets"
on = "rotor"
mass = "2.6 kg"
centre_of_mass = "170 mm"
hinge_radius = "200 mm"
cup_radius = "45 mm"
bottom = "300 mm"
surface = "20 mm"

[suspension]
liquid_density = "870 kg/m^3"
viscosity = "15 mPa s"
particle_density = "2650 kg/m^3"
diameter = "20 um"

[limits]
displacement = { drum = "0.5 mm" }
force = { spindle = "600 N" }

[[study]]
kind = "modes"
name = "small motions"

[[study]]
kind = "campbell"
speed = { from = "10 rpm", to = "6000 rpm" }

[[study]]
kind = "transient"
duration = "1 s"
initial = { "rotor.x" = "0.1 mm" }
kick = { "base.y'" = "0.1 m/s" }
kick_time = "0.5 s"

[[study]]
kind = "sweep"
speed = { from = "600 rpm", to = "6000 rpm" }
section = "fan.y"

[[study]]
kind = "stability_map"
speed = { from = "10 rpm", to = "5000 rpm" }
parameter = { parameter = "oil.free_surface_radius", from = "40 mm", to = "60 mm" }

[[study]]
kind = "separation"
time = "8 min"
particles = 64

[[study]]
kind = "operating_window"
speed = { from = "100 rpm", to = "2600 rpm" }
time = "30 min"
objective = "margin"

[[study]]
kind = "uncertainty"
study = "small motions"
parameters = [{ parameter = "drum.mass", distribution = "normal", deviation = "2 %" }]
samples = 16
"#;

/// A mistake: the text it replaces, what is written instead, the code, and a text inside the marked place.
struct Mistake {
    right: &'static str,
    wrong: &'static str,
    code: &'static str,
    marked: &'static str,
}

const fn mistake(right: &'static str, wrong: &'static str, code: &'static str, marked: &'static str) -> Mistake {
    Mistake { right, wrong, code, marked }
}

/// Mistakes that may be made in any combination.
const MISTAKES: &[Mistake] = &[
    // reading
    mistake("3000 rpm", "3000 rmp", "unit.unknown", "rmp"),
    mistake("\"2.4 kg\"", "\"2.4 m\"", "unit.dimension", "m"),
    mistake("stiffness = \"3.26e5 N/m\"", "stifness = \"3.26e5 N/m\"", "key.unknown", "stifness"),
    mistake("eccentricity = \"20 um\"", "excentricity = \"20 um\"", "key.unknown", "excentricity"),
    mistake("\"per_axis\"", "\"peraxis\"", "value.choice", "peraxis"),
    mistake("damping = \"42 N s/m\"\n", "\n", "key.missing", "[[part]]"),
    mistake("samples = 16", "samples = 1.5", "value.type", "1.5"),
    mistake("particles = 64", "particels = 64", "key.unknown", "particels"),
    mistake("kind = \"modes\"", "kind = \"mods\"", "kind.unknown", "mods"),
    mistake("kind = \"foundation\"", "kind = \"fundation\"", "kind.unknown", "fundation"),
    mistake("name = \"losses\"", "name = \"base\"", "name.twice", "base"),
    mistake("name = \"overhang\"", "name = \"over.hang\"", "name.invalid", "over.hang"),
    mistake("[suspension]", "[[suspension]]", "file.brackets", "suspension"),
    mistake("oil.free_surface_radius", "oil.free_surface", "parameter.unknown", "oil.free_surface"),
    mistake("\"normal\"", "\"norml\"", "value.choice", "norml"),
    // joints
    mistake("between = [\"drum\", \"base\"]", "between = [\"drum\", \"bass\"]", "body.missing", "bass"),
    mistake("in = \"drum\"", "in = \"spindle\"", "body.kind", "spindle"),
    mistake("on = \"rotor\"", "on = \"banana\"", "body.missing", "banana"),
    // parts
    mistake("46.7 mm", "76.7 mm", "liquid.fill", "76.7 mm"),
    mistake("\"0.02 kg m^2\"", "\"0.03 kg m^2\"", "part.check", "0.03"),
    // blocks beside the parts
    mistake("surface = \"20 mm\"", "surface = \"320 mm\"", "cup.empty", "320 mm"),
    mistake("diameter = \"20 um\"", "median_diameter = \"20 um\"", "suspension.size", "20 um"),
    mistake("{ spindle = \"600 N\" }", "{ spindel = \"600 N\" }", "limits.name", "spindel"),
    // studies
    mistake("from = \"10 rpm\", to = \"6000 rpm\"", "from = \"9000 rpm\", to = \"6000 rpm\"", "study.range", "9000"),
    mistake("\"rotor.x\"", "\"rotor.q\"", "coordinate.unknown", "rotor.q"),
    mistake("\"0.5 s\"", "\"2 s\"", "transient.kick_time", "2 s"),
    mistake("\"base.y'\"", "\"bace.y'\"", "coordinate.unknown", "bace"),
    mistake("from = \"600 rpm\"", "from = \"0 rpm\"", "sweep.speed", "0 rpm"),
    mistake("from = \"40 mm\"", "from = \"80 mm\"", "study.range", "80 mm"),
    mistake("from = \"100 rpm\"", "from = \"0 rpm\"", "operating_window.speed", "0 rpm"),
    mistake("objective = \"margin\"", "objective = \"profit\"", "value.choice", "profit"),
];

fn with(mistakes: &[&Mistake]) -> String {
    mistakes.iter().fold(MACHINE.to_string(), |text, m| {
        assert_eq!(text.matches(m.right).count(), 1, "{}", m.right);
        text.replacen(m.right, m.wrong, 1)
    })
}

fn errors(text: &str) -> Vec<Diagnostic> {
    load(text).err().unwrap_or_default().0.into_iter().filter(|d| d.severity == Severity::Error).collect()
}

/// Each of the mistakes once, and nothing else.
fn check(mistakes: &[&Mistake]) {
    let text = with(mistakes);
    let found = errors(&text);
    let shown = || render(&Diagnostics(found.clone()), &text, "machine.toml", Form::Lines);
    for m in mistakes {
        let own = found.iter().filter(|d| d.code == m.code && d.span.clone().is_some_and(|s| text[s].contains(m.marked)));
        assert_eq!(own.count(), 1, "{} -> {}\n{}", m.right, m.wrong, shown());
    }
    let planted: Vec<&str> = mistakes.iter().map(|m| m.wrong.trim()).collect();
    assert_eq!(found.len(), mistakes.len(), "{planted:?}\n{}", shown());
}

#[test]
fn the_file_without_mistakes_is_valid() {
    let l = load(MACHINE).unwrap_or_else(|d| panic!("{}", render(&d, MACHINE, "machine.toml", Form::Lines)));
    assert!(l.warnings.0.is_empty(), "{:?}", l.warnings);
}

#[test]
fn each_mistake_alone() {
    for m in MISTAKES {
        check(&[m]);
    }
}

#[test]
fn each_pair_of_mistakes() {
    for (i, a) in MISTAKES.iter().enumerate() {
        for b in &MISTAKES[..i] {
            if compatible(a, b) {
                check(&[a, b]);
            }
        }
    }
}

/// The keys of a block of unknown kind cannot be assessed, nor the values of a parameter that does not exist.
fn compatible(a: &Mistake, b: &Mistake) -> bool {
    let hides = |a: &Mistake, b: &Mistake| {
        (a.right == "kind = \"foundation\"" && b.wrong.starts_with("stifness"))
            || (a.right == "oil.free_surface_radius" && b.right == "from = \"40 mm\"")
    };
    !hides(a, b) && !hides(b, a)
}

#[test]
fn any_mistakes_together() {
    // SplitMix64
    let mut state = 20_240_229_u64;
    let mut next = |n: usize| {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as usize % n
    };
    for _ in 0..400 {
        let size = 2 + next(MISTAKES.len() - 2);
        let mut left: Vec<&Mistake> = MISTAKES.iter().collect();
        let mut chosen: Vec<&Mistake> = Vec::new();
        while chosen.len() < size && !left.is_empty() {
            let m = left.swap_remove(next(left.len()));
            if chosen.iter().all(|c| compatible(c, m)) {
                chosen.push(m);
            }
        }
        check(&chosen);
    }
}

/// Mistakes of all stages as they are printed.
#[test]
fn mistakes_of_all_stages() {
    let chosen = [
        "3000 rpm",
        "\"2.4 kg\"",
        "eccentricity = \"20 um\"",
        "\"per_axis\"",
        "between = [\"drum\", \"base\"]",
        "on = \"rotor\"",
        "46.7 mm",
        "\"0.02 kg m^2\"",
        "name = \"losses\"",
        "diameter = \"20 um\"",
        "{ spindle = \"600 N\" }",
        "from = \"10 rpm\", to = \"6000 rpm\"",
        "\"rotor.x\"",
        "\"0.5 s\"",
        "kind = \"modes\"",
    ];
    let mistakes: Vec<&Mistake> = MISTAKES.iter().filter(|m| chosen.contains(&m.right)).collect();
    assert_eq!(mistakes.len(), chosen.len());
    check(&mistakes);
    let text = with(&mistakes);
    insta::assert_snapshot!(render(&Diagnostics(errors(&text)), &text, "machine.toml", Form::Lines));
}

/// What is said of a changed file.
fn codes(edits: &[(&str, &str)]) -> Vec<&'static str> {
    let text = edits.iter().fold(MACHINE.to_string(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    errors(&text).into_iter().map(|d| d.code).collect()
}

#[test]
fn starts_have_the_unit_of_their_coordinate() {
    for (from, to) in [("\"0.1 mm\"", "\"0.1 kg\""), ("\"0.1 mm\"", "\"0.1 mm/s\""), ("\"0.1 m/s\"", "\"0.1 m\"")] {
        assert_eq!(codes(&[(from, to)]), ["unit.dimension"], "{to}");
    }
    assert!(codes(&[("\"0.1 m/s\"", "\"6 m/min\"")]).is_empty());
}

#[test]
fn what_refers_to_a_broken_block_is_not_blamed() {
    // a coordinate that only the right value would give, of a liquid that cannot be built, of a part of unknown kind, under a name that cannot be one
    assert_eq!(
        codes(&[("diametral_inertia = \"0.8 kg m^2\"", "diametral_inertai = 0.8"), ("\"rotor.x\"", "\"rotor.tilt_x\"")]),
        ["key.unknown"]
    );
    assert_eq!(codes(&[("kind = \"liquid\"", "kind = \"liqid\""), ("\"rotor.x\"", "\"oil.surface_x\"")]), ["kind.unknown"]);
    assert_eq!(codes(&[("name = \"rotor\"", "name = \"rotor.a\""), ("on = \"rotor\"", "on = \"rotor.a\"")]).first(), Some(&"name.invalid"));
    // a coordinate of a part that is joined to nothing is known
    assert_eq!(codes(&[("in = \"drum\"", "in = \"drun\""), ("\"rotor.x\"", "\"oil.surface_x\"")]), ["body.missing"]);
    assert_eq!(codes(&[("in = \"drum\"", "in = \"drun\""), ("\"rotor.x\"", "\"oil.surface\"")]), ["body.missing", "coordinate.unknown"]);
    // a bearing that cannot be built is no body, and what is attached to it is reported later
    let broken = [
        ("law = \"per_axis\"\nstiffness = \"1.1e7 N/m\"", "law = \"isotropic\"\nstiffness = { x = 1e7, y = 2e7 }"),
        ("in = \"drum\"", "in = \"bearing\""),
    ];
    assert_eq!(codes(&[broken[0]]), ["bearing_cubic.isotropic"]);
    assert_eq!(codes(&broken), ["bearing_cubic.isotropic", "body.kind"]);
    // headers
    assert_eq!(codes(&[("[[part]]\nkind = \"disc\"\nname = \"drum\"", "[[disc]]\nname = \"drum\"")]), ["file.unknown_table"]);
    assert_eq!(
        codes(&[("[[part]]\nkind = \"disc\"\nname = \"drum\"", "[[parts]]\nkind = \"disc\"\nname = \"drum\"")]),
        ["file.unknown_table"]
    );
    assert_eq!(codes(&[("[[part]]\nkind = \"disc\"\nname = \"drum\"", "[[gizmo]]\nname = \"drum\"")]), ["file.unknown_table"]);
    assert_eq!(codes(&[("[machine]", "[machin]")]), ["file.unknown_table"]);
    assert_eq!(codes(&[("[machine]", "[[machine]]")]), ["file.brackets"]);
    assert_eq!(codes(&[("[limits]", "[[limits]]")]), ["file.brackets"]);
    assert_eq!(codes(&[("[limits]", "[limit]")]), ["file.unknown_table"]);
    assert_eq!(codes(&[("[[cup]]", "[cup]")]), ["file.brackets"]);
    assert_eq!(codes(&[("[[cup]]\nkind = \"swinging\"", "[[cup]]\nkind = \"swining\"")]), ["kind.unknown"]);
    // the study inside a study
    assert_eq!(codes(&[("name = \"small motions\"", "speed = \"3 kg\"\nname = \"small motions\"")]), ["unit.dimension"]);
    assert_eq!(codes(&[("study = \"small motions\"", "study = \"big motions\"")]), ["study.unknown"]);
}

#[test]
fn a_block_that_does_not_exist_is_one_mistake() {
    // misnamed where it stands: two joints, a limit and a coordinate of a study use the name
    let found = |edits: &[(&str, &str)]| {
        let text = edits.iter().fold(MACHINE.to_string(), |text, (from, to)| text.replace(from, to));
        (errors(&text), text)
    };
    let (list, text) = found(&[("name = \"base\"", "name = \"bass\"")]);
    assert_eq!(list.len(), 1, "{list:?}");
    let shown = render(&Diagnostics(list), &text, "m.toml", Form::Lines);
    let line = |what: &str| text.lines().position(|l| l.contains(what)).unwrap() + 1;
    assert!(shown.starts_with(&format!("m.toml:{}:", line("between = [\"drum\", \"base\"]"))), "{shown}");
    assert!(
        shown.contains(&format!("does not exist (also named in line {})", line("base.y'"))) && shown.contains("did you mean \"bass\"?"),
        "{shown}"
    );
    let (list, text) = found(&[("name = \"drum\"", "name = \"drumm\"")]);
    assert_eq!(list.iter().map(|d| d.code).collect::<Vec<_>>(), ["body.missing"]);
    let lines: Vec<usize> = list[0].also().iter().map(|s| text[..s.start].matches('\n').count() + 1).collect();
    let drums = ["between = [\"drum\", \"ground\"]", "in = \"drum\"", "displacement = { drum", "drum.mass"];
    assert_eq!(lines, drums.map(line_of(&text)));
    // where only studies use it, the first of them
    let (list, _) = found(&[("drum.mass", "trommel.mass"), ("\"rotor.x\"", "\"trommel.x\"")]);
    assert_eq!(list.iter().map(|d| (d.code, d.also().len())).collect::<Vec<_>>(), [("coordinate.unknown", 1)]);
    // two names are two mistakes
    assert_eq!(found(&[("in = \"drum\"", "in = \"drun\""), ("[\"drum\", \"ground\"]", "[\"druum\", \"ground\"]")]).0.len(), 2);
}

fn line_of(text: &str) -> impl Fn(&str) -> usize + '_ {
    |what| text.lines().position(|l| l.contains(what)).unwrap() + 1
}

#[test]
fn a_body_named_like_the_ground_is_one_mistake() {
    // under its own name, and under the one that was meant
    let named = ("name = \"drum\"", "name = \"ground\"");
    for more in [("\"drum", "\"ground"), ("\"drum", "\"drum")] {
        let text = MACHINE.replace(named.0, named.1).replace(more.0, more.1);
        let text = if more.1 == "\"ground" { text.replace("{ drum =", "{ ground =") } else { text };
        let list = errors(&text);
        assert_eq!(
            list.iter().map(|d| d.code).collect::<Vec<_>>(),
            ["name.invalid"],
            "{}",
            render(&Diagnostics(list.clone()), &text, "m", Form::Lines)
        );
    }
    // what resembles another name is no name that was lost
    assert_eq!(codes(&[named, ("on = \"rotor\"", "on = \"rotr\"")]), ["name.invalid", "body.missing"]);
}

#[test]
fn a_part_given_twice_or_missing_or_joined_to_itself() {
    let disc = "[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = \"2.4 kg\"\neccentricity = \"20 um\"\n";
    assert_eq!(codes(&[(disc, &format!("{disc}{disc}"))]), ["name.twice"]);
    assert_eq!(codes(&[(disc, &format!("{disc}{disc}{disc}"))]), ["name.twice", "name.twice"]);
    // the second was meant to have the name that others use
    let base = ("name = \"base\"", "name = \"drum\"");
    assert_eq!(codes(&[base, ("\"rotor.x\"", "\"base.x\"")]), ["name.twice"]);
    assert_eq!(codes(&[base, ("between = [\"fan\", \"rotor\"]", "between = [\"fan\", \"rotro\"]")]), ["name.twice", "body.missing"]);
    assert_eq!(codes(&[("between = [\"fan\", \"rotor\"]", "between = [\"fan\", \"fan\"]")]), ["value.between"]);
    assert_eq!(codes(&[("between = [\"fan\", \"rotor\"]", "between = [\"fan\", \"overhang\"]")]), ["body.kind"]);
    assert_eq!(errors("[machine]\n[[study]]\nkind = \"campbell\"\nspeed = { from = 9, to = 3 }\n").len(), 2);
    assert_eq!(errors("[machine]\n[[part]]\nkind = \"damper\"\nbetween = [\"a\", \"ground\"]\ndamping = 1\n").len(), 1);
}

#[test]
fn values_of_no_machine_are_refused_or_reported() {
    // a body has a mass or none at all
    for (from, to) in [("\"2.4 kg\"", "\"1e-300 kg\""), ("\"25 kg\"", "\"1e-300 kg\"")] {
        assert_eq!(codes(&[(from, to)]), ["part.check"]);
    }
    assert!(codes(&[("\"25 kg\"", "0")]).is_empty());
    assert_eq!(codes(&[("\"880 kg/m^3\"", "\"1e-300 kg/m^3\"")]), ["value.bounds"]);
    let reported = |cubic: &str| {
        let text = MACHINE.replace("8.7e10 N/m^3", cubic);
        load(&text).unwrap_or_else(|d| panic!("{d:?}")).warnings.0.iter().map(|d| d.code).collect::<Vec<_>>()
    };
    assert_eq!(reported("-1e14 N/m^3"), ["bearing_cubic.reversal"]);
    assert!(reported("-1e10 N/m^3").is_empty());
}
