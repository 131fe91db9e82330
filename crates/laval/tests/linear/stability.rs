//! Stability: band edges of the undamped machine, peaks and thresholds of the damped one.

use crate::common;

use common::{Planar, number, rows};
use laval::model::field::RangeValue;
use laval::outcome::Outcome;
use laval::solve::rest::rest;
use laval::solve::stability::row;
use laval::study::{Context, ErasedStudy, TypedStudy, criterion::Criterion, stability_map::StabilityMap, support::About};

fn grid(from: f64, to: f64, points: usize) -> Vec<f64> {
    RangeValue { from, to, points: Some(points) }.linspace(points)
}

#[test]
fn undamped_band_edges() {
    let table = rows(include_str!("../reference/planar/instability_bands_undamped.csv"));
    let (mut checked, mut worst) = (0, 0.0f64);
    for four in table.chunks(4) {
        let (base, fill) = (number(four[0][0]), number(four[0][1]));
        assert!(four.iter().all(|r| r[0] == four[0][0] && r[1] == four[0][1]), "{four:?}");
        let system = Planar { base, fill, chi: 0.0, chi0: 0.0, ..Planar::default() }.build();
        let found = row(&system, &|w| rest(&system, w), &grid(20.0, 12000.0, 600), 0.0, |_| true).unwrap();
        assert!(found.undamped);
        assert_eq!(found.edges.len(), four.len(), "{base} {fill}: {:?}", found.edges.iter().map(|e| e.speed).collect::<Vec<_>>());
        for (edge, r) in found.edges.iter().zip(four) {
            let (speed, frequency) = (number(r[4]), number(r[5]));
            assert_eq!(edge.onset, r[3] == "open");
            assert!(edge.double && edge.located, "{r:?}: {edge:?}");
            worst = worst.max((edge.speed / speed - 1.0).abs());
            assert!((edge.speed / speed - 1.0).abs() < 1e-9, "{r:?}: {}", edge.speed);
            assert!((edge.value.im / frequency - 1.0).abs() < 1e-9, "{r:?}: {}", edge.value.im);
            checked += 1;
        }
    }
    println!("{checked} edges, largest relative deviation {worst:.1e}");
    assert_eq!(checked, table.len());
}

#[test]
fn damped_peaks_and_thresholds() {
    for r in rows(include_str!("../reference/planar/peak_growth.csv")) {
        let system = Planar { fill: number(r[0]), ..Planar::default() }.build();
        let (from, to) = if r[2] == "foundation" { (90.0, 300.0) } else { (1500.0, 6000.0) };
        // 20 points: the search between them must find the peak
        let found = row(&system, &|w| rest(&system, w), &grid(from, to, 20), 1.0, |_| true).unwrap();
        let peak_speed = number(r[3]);
        // below the threshold nothing is said
        if number(r[4]) < 1.0 {
            assert!(found.peaks.is_empty() && found.edges.is_empty());
            continue;
        }
        let peak = found.peaks.iter().min_by(|a, b| (a.speed - peak_speed).abs().total_cmp(&(b.speed - peak_speed).abs())).unwrap();
        assert!((peak.value.re / number(r[4]) - 1.0).abs() < 1e-10, "{r:?} {peak:?}");
        // a maximum found by comparing values is known to the root of their rounding
        assert!((peak.speed / peak_speed - 1.0).abs() < 1e-7, "{r:?} {peak:?}");
        let edges: Vec<f64> = found.edges.iter().map(|e| e.speed).collect();
        assert_eq!(edges.len(), 2, "{r:?} {edges:?}");
        for (e, cell) in edges.iter().zip([r[6], r[7]]) {
            assert!((e / number(cell) - 1.0).abs() < 1e-10, "{r:?} {e}");
        }
    }
}

#[test]
fn critical_wave_damping_is_neutral() {
    for r in rows(include_str!("../reference/planar/liquid_damping_threshold.csv")) {
        let delta = number(r[3]);
        if !delta.is_finite() {
            continue;
        }
        let growth = |factor: f64| {
            let system = Planar { fill: number(r[0]), delta: delta * factor, ..Planar::default() }.build();
            let found = row(&system, &|w| rest(&system, w), &[number(r[1])], 0.0, |_| true).unwrap();
            found.samples[0].value.re
        };
        assert!(growth(1.0 - 1e-6) > 0.0 && growth(1.0 + 1e-6) < 0.0, "{r:?}");
    }
}

fn map(threads: usize) -> Outcome {
    let system = Planar { fill: 0.8, ..Planar::default() }.build();
    let study = StabilityMap {
        speed: RangeValue { from: 1500.0, to: 6000.0, points: Some(30) },
        parameter: Some(("liquid.free_surface_radius".into(), RangeValue { from: 0.03, to: 0.068, points: Some(6) })),
        about: About::Rest,
        criterion: Criterion::Growth,
        threshold: 1.0,
        frequency: None,
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| study.run(&system, &Context::quiet("map")).unwrap())
}

#[test]
fn map_does_not_depend_on_threads_and_locates_its_boundary() {
    let (one, two) = (map(1), map(2));
    assert_eq!(one, two);
    assert_eq!(one.find_table("map").unwrap().rows(), 180);
    assert_eq!(one.find_table("boundary").unwrap().rows(), 12);
}

/// Rotating damping c_i beside a fixed one c_a: unstable above w (1 + c_a/c_i). Over c_a the region lies beyond a straight line, which its figure fills.
#[test]
fn the_unstable_region_over_a_parameter_is_filled_between_located_speeds() {
    let text = "[machine]\nspeed = 150.0\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 3.0\n\
                [[part]]\nkind = \"shaft_lumped\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 3e4\n\
                [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 30.0\n\
                [[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 20.0\naxes = \"rotating\"\n\
                [[study]]\nkind = \"stability_map\"\nspeed = { from = 10.0, to = 400.0, points = 40 }\n\
                parameter = { parameter = \"air.damping\", from = 10.0, to = 50.0, points = 9 }\n";
    let loaded = laval::file::load(text).unwrap_or_else(|d| panic!("{d:?}"));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("map")).unwrap();
    let t = o.find_table("regions").expect("a region");
    let number = |column: &str, row: usize| t.column(column).unwrap().number(row).unwrap();
    let known: Vec<usize> = (0..t.rows()).filter(|&r| number("from", r).is_finite()).collect();
    assert_eq!(known.len(), 9);
    for r in known {
        let want = 100.0 * (1.0 + number("air.damping", r) / 20.0);
        assert!((number("from", r) / want - 1.0).abs() < 1e-6 && (number("to", r) - 400.0).abs() < 1e-9, "row {r}");
    }
    let figure = o.figures.iter().find(|f| f.name == "stability").unwrap();
    let svg = laval::report::draw(figure, &o.tables).unwrap();
    // no cells, one area, curves of equal growth named in the legend
    assert!(
        !svg.contains("shape-rendering=\"auto\"")
            && svg.contains("class=\"b1\"")
            && svg.contains("growth rate ")
            && svg.contains("machine")
    );
    let heat = svg.split("<g class=\"heat\"").nth(1).unwrap().split("</g>").next().unwrap();
    assert!(!heat.contains("<path"), "{heat}");
}

/// Modes of a chain that pass each other without any coupling need no eigenproblems between the speeds, and a narrow range in which two of them interact is found all the same.
#[test]
fn passings_cost_eigenproblems_only_where_modes_may_interact() {
    let chain = |more: &str| {
        let mut text = String::from("[machine]\nspeed = 300.0\n");
        for k in 0..8 {
            text += &format!(
                "[[part]]\nkind = \"disc\"\nname = \"d{k}\"\nmass = {:?}\npolar_inertia = 0.02\ndiametral_inertia = 0.011\n",
                2.0 + 0.01 * f64::from(k)
            );
        }
        for k in 1..8 {
            text += &format!(
                "[[part]]\nkind = \"shaft_lumped\"\nname = \"j{k}\"\nbetween = [\"d{}\", \"d{k}\"]\nstiffness = 1e7\ntilt_stiffness = 1e5\ncoupling = 0\n",
                k - 1
            );
        }
        for k in [0, 7] {
            text += &format!(
                "[[part]]\nkind = \"shaft_lumped\"\nname = \"b{k}\"\nbetween = [\"d{k}\", \"ground\"]\nstiffness = 2e6\ntilt_stiffness = 1e5\ncoupling = 0\n"
            );
        }
        crate::common::files::load(&(text + more)).system
    };
    let speeds: Vec<f64> = (0..40).map(|k| 10.0 + 15.0 * f64::from(k)).collect();
    let apart = chain("");
    let found = row(&apart, &|w| rest(&apart, w), &speeds, 0.0, |_| true).unwrap();
    assert!(found.edges.is_empty() && found.undamped);
    assert!(found.solved <= 2 * speeds.len() as u64, "{} eigenproblems at {} speeds", found.solved, speeds.len());
}

/// Between two speeds far apart lies a steep rise: the growth at the operating speed is that of the modes there, of a machine of finitely many modes and of one whose roots are counted.
#[test]
fn the_growth_at_the_operating_speed_is_that_of_the_modes() {
    let rotor = r#"
        machine = { speed = "1330 rad/s" }
        part = [
            { kind = "disc", name = "drum", mass = "2.4 kg", eccentricity = "20 um" },
            { kind = "foundation", name = "base", mass = "25 kg", stiffness = "3e5 N/m", damping = "60 N s/m" },
            { kind = "shaft_lumped", name = "shaft", between = ["drum", "base"], stiffness = "1.1e7 N/m" },
            { kind = "damper", name = "losses", between = ["drum", "ground"], damping = "42 N s/m" },
            { kind = "liquid", name = "oil", in = "drum", cavity_radius = "70 mm", cavity_height = "60 mm", density = "880 kg/m^3",
              fill = { free_surface_radius = "46.7 mm" }, wave_damping = "2 1/s" },
        ]"#;
    let viscous = rotor.replace("wave_damping = \"2 1/s\"", "viscosity = \"1e-4 m^2/s\"");
    for (text, speed) in [(rotor, 1330.0), (rotor, 3000.0), (&viscous, 3000.0)] {
        let loaded = common::files::load(&text.replace("1330 rad/s", &format!("{speed} rad/s")));
        let system = &loaded.system;
        let study = StabilityMap {
            speed: RangeValue { from: 500.0, to: 5000.0, points: Some(4) },
            parameter: None,
            about: About::Rest,
            criterion: Criterion::Growth,
            threshold: 0.0,
            frequency: None,
        };
        let found = study.result(system, &Context::quiet("map")).unwrap_or_else(|d| panic!("{d}"));
        let there = row(system, &|w| rest(system, w), &[speed], 0.0, |_| true);
        let own = found.operating.expect("the range holds the operating speed").value;
        match there {
            Ok(there) => {
                let modes = there.samples[0].value;
                assert!((own - modes).abs() < 1e-9 * modes.abs(), "{speed}: {own:?} instead of {modes:?}");
            }
            // roots that are counted: those that grow are solved for
            Err(_) => assert!(own.re.is_finite(), "{own:?}"),
        }
        let figure = study.outcome(system, &found, "map").unwrap().figures.remove(0);
        assert!(format!("{figure:?}").contains("stability-map-operating"), "{speed}");
    }
}
