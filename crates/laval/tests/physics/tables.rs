//! Coefficients in a table over the speed are known at its speeds only: a study beyond is refused, or, when the file says how the table continues, marked.

use laval::file::{self, Loaded};
use laval::model::field::RangeValue;
use laval::outcome::{Finding, Level, Outcome};
use laval::study::campbell::Campbell;
use laval::study::critical_speeds::CriticalSpeeds;
use laval::study::forced_response::ForcedResponse;
use laval::study::{Context, ErasedStudy, registry};

/// A rigid rotor on two journal bearings whose table ends at 12000 rpm.
fn rotor(beyond: &str, studies: &str) -> String {
    let table = "table = { speed = [\"1000 rpm\", \"3000 rpm\", \"6000 rpm\", \"9000 rpm\", \"12000 rpm\"], \
         kxx = [\"8 MN/m\", \"10 MN/m\", \"12 MN/m\", \"13 MN/m\", \"14 MN/m\"], kxy = [\"2 MN/m\", \"6 MN/m\", \"12 MN/m\", \"17 MN/m\", \"22 MN/m\"], \
         kyx = [\"-10 MN/m\", \"-12 MN/m\", \"-16 MN/m\", \"-20 MN/m\", \"-25 MN/m\"], kyy = [\"25 MN/m\", \"18 MN/m\", \"15 MN/m\", \"14 MN/m\", \"14 MN/m\"], \
         cxx = [\"60 kN s/m\", \"30 kN s/m\", \"22 kN s/m\", \"19 kN s/m\", \"18 kN s/m\"], cyy = [\"200 kN s/m\", \"70 kN s/m\", \"35 kN s/m\", \"28 kN s/m\", \"24 kN s/m\"] }";
    let bearing = |name: &str, at: &str| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"rotor\", at = \"{at}\" }}, \"ground\"]\n{table}\n{beyond}\n"
        )
    };
    format!(
        "[machine]\nspeed = \"6000 rpm\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = \"50 kg\"\ndiametral_inertia = \"2.5 kg m^2\"\n\
         polar_inertia = \"0.4 kg m^2\"\nunbalance = \"500 g mm\"\n{}{}{studies}",
        bearing("front", "300 mm"),
        bearing("rear", "-300 mm")
    )
}

fn load(text: &str) -> Loaded {
    file::load(text).unwrap_or_else(|d| panic!("{d:?}"))
}

fn run(text: &str) -> Outcome {
    let l = load(text);
    l.studies[0].study.run(&l.system, &Context::quiet("study")).unwrap()
}

/// What leaves the table from 1000 to 12000 rpm.
const BEYOND: [&str; 29] = [
    "kind = \"modes\"\nspeed = \"12001 rpm\"",
    "kind = \"campbell\"\nspeed = { from = \"1000 rpm\", to = \"13000 rpm\", points = 5 }",
    "kind = \"critical_speeds\"\nspeed = { from = \"900 rpm\", to = \"12000 rpm\", points = 5 }",
    "kind = \"stability_map\"\nspeed = { from = \"1000 rpm\", to = \"20000 rpm\", points = 40 }",
    "kind = \"forced_response\"\nspeed = { from = \"0 rpm\", to = \"6000 rpm\", points = 5 }",
    "kind = \"nonlinear_response\"\nspeed = { from = \"11000 rpm\", to = \"13000 rpm\" }",
    "kind = \"transient\"\nspeed = \"500 rpm\"\nduration = \"10 ms\"\npoints = 5",
    "kind = \"run_up\"\nduration = \"10 ms\"\npoints = 5",
    "kind = \"run_up\"\nfrom = \"2000 rpm\"\nto = \"15000 rpm\"\nduration = \"10 ms\"\npoints = 5",
    "kind = \"run_up\"\nprogramme = { time = [\"0 s\", \"5 ms\", \"10 ms\"], speed = [\"2000 rpm\", \"14000 rpm\", \"3000 rpm\"] }\npoints = 5",
    "kind = \"sweep\"\nspeed = { from = \"11000 rpm\", to = \"12500 rpm\", points = 2 }",
    "kind = \"uncertainty\"\nstudy = { kind = \"modes\", speed = \"13000 rpm\" }\nsamples = 4\n\
     parameters = [{ parameter = \"rotor.mass\", distribution = \"normal\", deviation = \"1 %\" }]",
    "kind = \"operating_window\"\nspeed = { from = \"1000 rpm\", to = \"13000 rpm\", points = 5 }",
    // the speeds that follow from other fields, or from none
    "kind = \"operating_window\"\nspeed = { from = \"1000 rpm\", to = \"2000 rpm\", points = 5 }\nramp = \"1 s\"",
    "kind = \"run_up\"\npolynomial = [150, 0, 2e7]\nduration = \"10 ms\"\npoints = 5",
    "kind = \"run_up\"\npolynomial = [150, 1.2e6, -1.2e8]\nduration = \"10 ms\"\npoints = 5",
    "kind = \"motion_map\"\nspeed = { from = \"900 rpm\", to = \"2000 rpm\", points = 2 }\n\
     y = { parameter = \"rotor.mass\", from = \"40 kg\", to = \"50 kg\", points = 2 }",
    "kind = \"bifurcation_loci\"\nspeed = { from = \"11000 rpm\", to = \"13000 rpm\" }\n\
     parameter = { parameter = \"rotor.mass\", from = \"40 kg\", to = \"50 kg\", points = 2 }",
    "kind = \"response_map\"\nspeed = { from = \"11000 rpm\", to = \"13000 rpm\" }\n\
     x = { parameter = \"rotor.mass\", from = \"40 kg\", to = \"50 kg\", points = 2 }\n\
     y = { parameter = \"rotor.unbalance\", from = \"400 g mm\", to = \"500 g mm\", points = 2 }",
    "kind = \"stationary\"\nspeed = \"13000 rpm\"",
    "kind = \"sensitivity\"\nspeed = { from = \"11000 rpm\", to = \"13000 rpm\" }",
    "kind = \"backbone\"\nspeed = \"13000 rpm\"",
    "kind = \"limit_cycles\"\nspeed = { from = \"11000 rpm\", to = \"13000 rpm\", points = 3 }",
    "kind = \"methods\"\nspeed = { from = \"11000 rpm\", to = \"13000 rpm\", points = 2 }",
    "kind = \"basins\"\nspeed = \"13000 rpm\"\nfrom = { \"rotor.x\" = \"-1 mm\", \"rotor.y\" = \"-1 mm\" }\nto = { \"rotor.x\" = \"1 mm\", \"rotor.y\" = \"1 mm\" }",
    "kind = \"static\"\nspeed = \"13000 rpm\"",
    "kind = \"harmonic_force\"\nplace = \"rotor\"\nspeed = \"13000 rpm\"",
    "kind = \"stability_threshold\"\nplace = \"rotor\"\nspeed = \"13000 rpm\"",
    "kind = \"bearing_coefficients\"\nspeed = { from = \"500 rpm\", to = \"6000 rpm\", points = 3 }",
];

#[test]
fn studies_beyond_a_table_are_refused() {
    for study in BEYOND {
        let l = load(&rotor("", &format!("[[study]]\n{study}\n")));
        let refusals = l.refusals();
        assert_eq!(refusals.len(), 1, "{study}");
        let d = &refusals[0].diagnostic;
        assert_eq!(d.code, "study.beyond_table", "{study}: {d}");
        assert!(d.span.is_some() && d.help.as_deref().is_some_and(|h| h.contains("beyond = \"hold\"")), "{study}");
        assert_eq!(l.studies[0].study.run(&l.system, &Context::quiet("study")).err().unwrap().code, "study.beyond_table", "{study}");
        // a table that continues
        let held = load(&rotor("beyond = \"hold\"", &format!("[[study]]\n{study}\n"))).refusals();
        assert!(held.iter().all(|r| r.diagnostic.code != "study.beyond_table"), "{study}");
    }
    let inside = "[[study]]\nkind = \"campbell\"\nspeed = { from = \"1000 rpm\", to = \"12000 rpm\" }\n[[study]]\nkind = \"modes\"\n";
    assert!(load(&rotor("", inside)).refusals().is_empty());
    // a polynomial that stays inside, and a map over two parameters at the speed of the machine
    let inside = "[[study]]\nkind = \"run_up\"\npolynomial = [150, 0, 1e7]\nduration = \"10 ms\"\npoints = 5\n\
        [[study]]\nkind = \"motion_map\"\nx = { parameter = \"rotor.unbalance\", from = \"400 g mm\", to = \"500 g mm\", points = 2 }\n\
        y = { parameter = \"rotor.mass\", from = \"40 kg\", to = \"50 kg\", points = 2 }\n";
    assert!(load(&rotor("", inside)).refusals().is_empty());
    // without a range a map goes over half to one and a half times the speed of the machine
    let fast =
        rotor("", "[[study]]\nkind = \"motion_map\"\ny = { parameter = \"rotor.mass\", from = \"40 kg\", to = \"50 kg\", points = 2 }\n");
    let fast = fast.replace("speed = \"6000 rpm\"\n[[part]]", "speed = \"9000 rpm\"\n[[part]]");
    assert_eq!(load(&fast).refusals()[0].diagnostic.code, "study.beyond_table");
    // what rests on no motion of the machine needs no coefficient
    let kinds = registry();
    assert!(kinds.iter().any(|k| k.info.kind == "separation"));
}

fn find<'a>(o: &'a Outcome, id: &str) -> Vec<&'a Finding> {
    o.findings.iter().filter(|f| f.id == id).collect()
}

/// Beyond the table nothing is said without its mark, and inside nothing is marked.
#[test]
fn findings_beyond_a_table_are_marked() {
    for (study, farthest) in [(BEYOND[0], 12001.0), (BEYOND[3], 20000.0), (BEYOND[4], 0.0), (BEYOND[8], 15000.0), (BEYOND[9], 14000.0)] {
        for (beyond, word) in [("hold", "held at its ends"), ("linear", "continued along its slope")] {
            let o = run(&rotor(&format!("beyond = \"{beyond}\""), &format!("[[study]]\n{study}\n")));
            for (k, name) in ["rear", "front"].into_iter().enumerate() {
                let first = &o.findings[k];
                assert_eq!((first.id.as_str(), first.subject.as_str(), first.level), ("beyond_table", name, Level::Invalid), "{study}");
                assert!(
                    (first.value.unwrap() - farthest * std::f64::consts::PI / 30.0).abs() < 1e-9 && first.sentence().contains(word),
                    "{first:?}"
                );
            }
            // one fact, one place
            assert!(
                !o.findings.iter().any(|f| f.sentence().contains("middle of the bearing table") && f.level == Level::Invalid),
                "{study}"
            );
        }
    }
    let modes = run(&rotor("beyond = \"hold\"", &format!("[[study]]\n{}\n", BEYOND[0])));
    assert!(
        modes
            .findings
            .iter()
            .all(|f| f.level == Level::Invalid && (f.id == "beyond_table" || f.sentence().contains("Outside the table of \"front\"")))
    );
    let map = run(&rotor("beyond = \"hold\"", &format!("[[study]]\n{}\n", BEYOND[3])));
    let limit = 12000.0 * std::f64::consts::PI / 30.0 * (1.0 + 1e-9);
    let mut marked = 0;
    for f in &map.findings {
        let speed = f.evidence.iter().find(|e| e.what == "speed").map(|e| e.value);
        let speed = speed.or(f.value.filter(|_| f.unit == "rad/s" && f.id.starts_with("instability")));
        if let Some(w) = speed {
            assert_eq!(f.level == Level::Invalid, w > limit, "{}", f.sentence());
            marked += usize::from(w > limit);
        }
    }
    assert!(marked > 0 || find(&map, "largest_growth").is_empty(), "{:#?}", map.findings);
    let inside =
        run(&rotor("beyond = \"hold\"", "[[study]]\nkind = \"stability_map\"\nspeed = { from = \"1000 rpm\", to = \"12000 rpm\" }\n"));
    assert!(inside.findings.iter().all(|f| f.level != Level::Invalid), "{:#?}", inside.findings);
}

/// On the plateau beyond a table that is held nothing changes with the speed but the gyroscopic moment: no peak of growth stands on rounding.
#[test]
fn a_plateau_has_no_peaks() {
    let gyroscopic = run(&rotor("beyond = \"hold\"", &format!("[[study]]\n{}\n", BEYOND[3])));
    let plane = rotor("beyond = \"hold\"", &format!("[[study]]\n{}\n", BEYOND[3])).replace("polar_inertia = \"0.4 kg m^2\"", "");
    let limit = 12000.0 * std::f64::consts::PI / 30.0;
    for o in [gyroscopic, run(&plane)] {
        let beyond = o.special_points.iter().filter(|p| p.kind == "growth_peak" && p.at > limit * (1.0 + 1e-6)).count();
        assert_eq!(beyond, 0, "{:#?}", o.special_points);
    }
}

/// The torque of a motor beyond its table is a guess of its own: a motion that uses it says so, one inside the table does not.
#[test]
fn a_motor_beyond_its_torque_table_is_marked() {
    let file = |last: &str| {
        format!(
            "[machine]\nspeed = \"100 rad/s\"\ndrive = \"free\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = \"2 kg\"\npolar_inertia = \"0.01 kg m^2\"\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = \"1e5 N/m\"\ndamping = \"100 N s/m\"\n\
             [[part]]\nkind = \"motor\"\nname = \"motor\"\ntorque = \"1 N m\"\ncurve = \"table\"\ntable = {{ speed = [\"0 rad/s\", \"{last}\"], share = [1, 1] }}\n\
             [[study]]\nkind = \"transient\"\nduration = \"3 s\"\npoints = 10\n"
        )
    };
    for (last, inside) in [("500 rad/s", true), ("200 rad/s", false)] {
        let o = run(&file(last));
        let table = |f: &&Finding| f.sentence().contains("torque table") && f.level == Level::Invalid;
        assert_eq!(o.findings.iter().filter(table).count(), usize::from(!inside), "{last}: {:#?}", o.findings);
    }
}

/// Every kind of study that needs coefficients is held against the tables by a case above.
#[test]
fn every_study_is_held_against_tables() {
    // separation rests on no motion of the machine, optimum on another study, and a map over the stiffness of supports replaces what has tables
    let without = ["separation", "optimum", "support_stiffness_map"];
    for k in registry() {
        let word = format!("kind = \"{}\"", k.info.kind);
        assert!(BEYOND.iter().any(|b| b.starts_with(&word)) != without.contains(&k.info.kind), "{}", k.info.kind);
    }
}

/// A study that is constructed in Rust is held against the tables as well as one of a file.
#[test]
fn constructed_studies_beyond_a_table_are_refused_or_marked() {
    let speed = RangeValue { from: 1300.0, to: 1400.0, points: Some(3) };
    let studies: [Box<dyn ErasedStudy>; 3] = [
        Box::new(Campbell { speed, orders: vec![1.0], threshold: 0.0, frequency: None, compare: false }),
        Box::new(CriticalSpeeds { speed, orders: vec![1.0], margin: 0.15 }),
        Box::new(ForcedResponse::over(speed)),
    ];
    let (refusing, held) = (load(&rotor("", "")).system, load(&rotor("beyond = \"hold\"", "")).system);
    for study in studies {
        let context = Context::quiet("study");
        assert_eq!(study.admit(&refusing).unwrap_err().code, "study.beyond_table", "{}", study.kind());
        assert_eq!(study.run(&refusing, &context).err().unwrap().code, "study.beyond_table", "{}", study.kind());
        let outcome = study.run(&held, &context).unwrap();
        assert!(outcome.findings.iter().all(|f| f.level == Level::Invalid), "{}: {:?}", study.kind(), outcome.findings);
    }
}

/// A disc in a bearing whose table goes from 100 to 500 rad/s and whose cross coupling grows, in studies from 50 to 1000 rad/s.
fn journal(beyond: &str, study: &str) -> Outcome {
    run(&format!(
        "[machine]\nspeed = \"300 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 10\neccentricity = \"20 um\"\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"d\", \"ground\"]\nbeyond = \"{beyond}\"\n\
         table = {{ speed = [100, 300, 500], kxx = [1e6, 2e6, 4e6], kyy = [1e6, 2e6, 4e6], kxy = [0, 2e5, 6e5], kyx = [0, -2e5, -6e5], \
         cxx = [1000, 1000, 1000], cyy = [1000, 1000, 1000] }}\n[[study]]\nkind = \"{study}\"\nspeed = {{ from = 50, to = 1000 }}\n"
    ))
}

/// A finding about all speeds of a study that leaves the table rests on it, and so does one that names a speed beyond it, be it the last of a range.
#[test]
fn findings_about_a_range_beyond_a_table_are_marked() {
    for (beyond, study, ids) in [
        ("hold", "critical_speeds", &["critical_speed", "margin"][..]),
        ("hold", "nonlinear_response", &["no_jump_up", "no_jump_down", "self_centring", "largest_displacement"]),
        ("linear", "critical_speeds", &["unstable"]),
        ("linear", "forced_response", &["unstable"]),
        ("linear", "nonlinear_response", &["unstable_states"]),
    ] {
        let o = journal(beyond, study);
        for id in ids {
            let found = find(&o, id);
            assert!(!found.is_empty(), "{study}: no {id}");
            for f in found {
                assert!(f.level == Level::Invalid && f.sentence().contains("Outside the table of \"b\""), "{study}: {}", f.sentence());
            }
        }
        // both sides
        let text = o.findings[0].sentence();
        assert!(o.findings[0].id == "beyond_table" && text.contains("down to 50 rad/s") && text.contains("up to 1000 rad/s"), "{text}");
    }
}
