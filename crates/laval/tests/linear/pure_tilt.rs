//! Every study of a rotor that tilts and is not displaced: none calls it motionless. Beside a stop that stays open the machine is linear in fact, so that its tilt
//! has a closed form in the studies of nonlinear machines as well.
//!
//! `A theta'' - i C W theta' + c theta' + k theta = (A - C) W^2 tau exp(i W t)`: tilt `(A - C) W^2 tau/|k - (A - C) W^2 + i c W|`; a point at the height z goes z
//! times as far.

use laval::file::load;
use laval::outcome::{Data, Finding, Outcome, Table};
use laval::study::Context;

const A: f64 = 0.1;
const C: f64 = 0.09;
const TAU: f64 = 1e-4;
const K: f64 = 1e4;
const DAMPING: f64 = 0.3;
/// Height of the stop, m.
const HEIGHT: f64 = 0.1;

fn tilt(w: f64) -> f64 {
    let force = (A - C) * w * w;
    force * TAU / (K - force).hypot(DAMPING * w)
}

fn machine(more: &str) -> String {
    format!(
        "[machine]\nspeed = 900\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\ndiametral_inertia = {A}\npolar_inertia = {C}\nskew = {TAU}\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"d\", \"ground\"]\nstiffness = 1e6\ntilt_stiffness = {K}\n\
         [[part]]\nkind = \"damper\"\nname = \"losses\"\nbetween = [\"d\", \"ground\"]\ndamping = 100\ntilt_damping = {DAMPING}\n\
         [[part]]\nkind = \"stop\"\nname = \"stop\"\nbetween = [{{ body = \"d\", at = {HEIGHT} }}, \"ground\"]\nstiffness = \"1e6 N/m\"\ngap = \"20 mm\"\n{more}"
    )
}

fn run_on(machine: &str, study: &str) -> Outcome {
    let loaded = load(&format!("{machine}[[study]]\n{study}\n")).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("tilt")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn run(study: &str) -> Outcome {
    run_on(&machine(""), study)
}

fn finding<'o>(o: &'o Outcome, id: &str, of: &str) -> &'o Finding {
    o.findings.iter().find(|f| f.id == id && f.subject == of).unwrap_or_else(|| panic!("no {id} of {of}: {:?}", o.findings))
}

fn near(found: f64, known: f64, relative: f64) {
    assert!((found - known).abs() <= relative * known.abs(), "{found} {known}");
}

fn column(t: &Table, name: &str) -> Vec<f64> {
    let c = t.column(name).unwrap_or_else(|| panic!("no column {name}"));
    (0..t.rows()).map(|i| c.number(i)).map(|x| x.unwrap_or(f64::NAN)).collect()
}

const POINT: &str = "d at 100 mm";

/// No finding is about a displacement of the reference point, which is none.
fn says_no_displacement(o: &Outcome) {
    let of_body = |f: &&Finding| f.id.starts_with("largest_displacement") && f.subject == "d";
    assert!(!o.findings.iter().any(|f| of_body(&f)), "{:?}", o.findings);
}

#[test]
fn steady_motions() {
    let o = run("kind = \"nonlinear_response\"\nspeed = { from = 600, to = 1400 }");
    let t = o.find_table("response").expect("a response");
    let (speeds, tilts, points) = (column(t, "speed"), column(t, "d tilt"), column(t, &format!("{POINT} largest displacement")));
    for ((w, a), x) in speeds.iter().zip(&tilts).zip(&points) {
        near(*a, tilt(*w), 1e-9);
        near(*x, HEIGHT * tilt(*w), 1e-9);
    }
    let top = speeds.iter().map(|w| tilt(*w)).fold(0.0, f64::max);
    let found = finding(&o, "largest_tilt", "d").value.expect("a tilt");
    assert!(found >= top * (1.0 - 1e-9) && found <= top * 1.05, "{found} {top}");
    near(finding(&o, "largest_displacement", "").value.expect("a displacement"), HEIGHT * found, 1e-9);
    assert!(!o.findings.iter().any(|f| f.id == "largest_displacement_of" && f.subject == "d"), "{:?}", o.findings);

    let o = run("kind = \"nonlinear_response\"\nspeed = 900");
    near(finding(&o, "steady_tilt", "1 d").value.expect("a tilt"), tilt(900.0), 1e-9);
    near(finding(&o, "steady_motion", &format!("1 {POINT}")).value.expect("a displacement"), HEIGHT * tilt(900.0), 1e-9);
    assert!(!o.findings.iter().any(|f| f.id == "steady_motion" && f.subject == "1 d"), "{:?}", o.findings);
    let o = run(
        "kind = \"response_map\"\nspeed = { from = 600, to = 900 }\nx = { parameter = \"d.skew\", from = 1e-4, to = 2e-4, points = 2 }\n\
                 y = { parameter = \"losses.damping\", from = 100, to = 200, points = 2 }",
    );
    let t = o.find_table("map").expect("a map");
    for (a, skew) in column(t, "tilt").iter().zip(column(t, "d.skew")) {
        near(*a, tilt(900.0) * skew / TAU, 1e-9);
    }
}

#[test]
fn settled_motions() {
    let o = run("kind = \"sweep\"\nspeed = { from = 880, to = 920, points = 3 }\nsection = \"d.tilt_x\"");
    says_no_displacement(&o);
    let t = o.find_table("sweep").expect("a sweep");
    for (k, w) in column(t, "speed").into_iter().enumerate() {
        near(column(t, "tilt.d")[k], tilt(w), 1e-4);
        near(column(t, &format!("amplitude.{POINT}"))[k], HEIGHT * tilt(w), 1e-4);
    }
    near(finding(&o, "largest_tilt", "d").value.expect("a tilt"), tilt(920.0), 1e-4);
    // rounding of the displacement is no jump and no hysteresis
    assert!(!o.findings.iter().any(|f| f.id.starts_with("jump") || f.id == "hysteresis"), "{:?}", o.findings);
    assert!(o.find_table("poincare").is_some_and(|t| t.column("tilt").is_some()));

    let o = run("kind = \"motion_map\"\nspeed = 900\nx = { parameter = \"d.skew\", from = 1e-4, to = 2e-4, points = 2 }\n\
                 y = { parameter = \"losses.damping\", from = 100, to = 200, points = 2 }");
    says_no_displacement(&o);
    let t = o.find_table("map").expect("a map");
    for ((a, x), skew) in column(t, "tilt.d").iter().zip(column(t, &format!("amplitude.{POINT}"))).zip(column(t, "d.skew")) {
        near(*a, tilt(900.0) * skew / TAU, 1e-4);
        near(x, HEIGHT * tilt(900.0) * skew / TAU, 1e-4);
    }

    let o = run(
        "kind = \"basins\"\nfrom = { \"d.tilt_x\" = -1e-3, \"d.tilt_y\" = -1e-3 }\nto = { \"d.tilt_x\" = 1e-3, \"d.tilt_y\" = 1e-3 }\npoints = 2",
    );
    let f = o.findings.iter().find(|f| f.id == "share").expect("a share");
    assert!(f.sentence().contains("largest displacement of \"d\" at 100 mm"), "{}", f.sentence());
    near(column(o.find_table("attractors").expect("attractors"), "tilt.d")[0], tilt(900.0), 1e-4);
}

/// A conical mode has the shape of a tilt, and none of the rounding of its displacement; a lateral one the other way round.
#[test]
fn shapes_of_modes() {
    let o = run("kind = \"modes\"\nspeed = 0");
    let t = o.find_table("modes").expect("modes");
    let (frequency, tilts, moved) = (column(t, "frequency"), column(t, "tilt.d"), column(t, "amplitude.d"));
    let (point, ratio) = (column(t, &format!("amplitude.{POINT}")), column(t, "tilt_over_displacement"));
    for k in 0..frequency.len() {
        let conical = (frequency[k] - (K / A).sqrt()).abs() < 1.0;
        assert!(conical || (frequency[k] - (1e6f64 / 2.0).sqrt()).abs() < 1.0, "{}", frequency[k]);
        let known = if conical { [1.0, 0.0, 1.0] } else { [0.0, 1.0, 1.0] };
        assert_eq!([tilts[k], moved[k]], [known[0], known[1]]);
        near(point[k], known[2], 1e-12);
        // the point at the height z moves z times the tilt
        near(ratio[k], if conical { 1.0 / HEIGHT } else { 0.0 }, 1e-9);
    }
}

/// A limit names a point at which nothing is attached: its edges are where the tilt times the height reaches it.
#[test]
fn a_limit_on_a_point() {
    // tilt theta at W: theta^2 ((K - f)^2 + c^2 W^2) = f^2 tau^2 with f = (A - C) W^2
    let (limit, height) = (0.2e-3, 0.25);
    let edge = |mut low: f64, mut high: f64| {
        let above = |w: f64| height * tilt(w) > limit;
        let rising = above(high);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if above(middle) == rising { high = middle } else { low = middle }
        }
        0.5 * (low + high)
    };
    let [low, high] = [edge(100.0, 1000.0), edge(1000.0, 4000.0)];
    let text = machine("[limits]\ndisplacement = { \"d at 250 mm\" = \"0.2 mm\" }\n").replace("kind = \"stop\"", "kind = \"damper\"");
    let text = text.replace("stiffness = \"1e6 N/m\"\ngap = \"20 mm\"", "damping = 1e-9");
    let o = run_on(&text, "kind = \"operating_window\"\nspeed = { from = 100, to = 4000 }");
    let of = |kind: &str| o.special_points.iter().filter(|p| p.kind == kind).map(|p| p.at).collect::<Vec<f64>>();
    near(of("window_high")[0], low, 1e-4);
    near(of("window_low")[1], high, 1e-4);
    // a point below others is limited by what it does itself
    let nearer = text.replace("\"d at 250 mm\" = \"0.2 mm\"", "\"d at 50 mm\" = \"0.04 mm\"");
    let o = run_on(&nearer, "kind = \"operating_window\"\nspeed = { from = 100, to = 4000 }");
    near(o.special_points.iter().find(|p| p.kind == "window_high").expect("an edge").at, low, 1e-4);
    // nothing is said of a tilt that no limit sees
    assert!(!o.findings.iter().any(|f| f.id == "tilt_without_limit"));
    let wrong = |point: &str| {
        let text = machine(&format!("[limits]\ndisplacement = {{ \"{point}\" = \"0.2 mm\" }}\n"));
        load(&text).err().map(|d| d.0.into_iter().map(|d| (d.code, d.span.is_some())).collect::<Vec<_>>())
    };
    for point in ["e at 250 mm", "d at 250 rpm", "d at here"] {
        assert_eq!(wrong(point), Some(vec![("limits.name", true)]), "{point}");
    }
    assert_eq!(wrong("d at 100 mm"), None);
}

fn text(t: &Table, name: &str, i: usize) -> String {
    match &t.column(name).unwrap_or_else(|| panic!("no column {name}")).data {
        Data::Text(v) => v[i].clone(),
        other => panic!("{other:?}"),
    }
}

/// With `m = A - C` and `D = c/(2 sqrt(k m))` the tilt peaks at `W = sqrt(k/m)/sqrt(1 - 2 D^2)` with `tau/(2 D sqrt(1 - D^2))`; differentiated by hand. The machine
/// is once nonlinear, beside a stop that stays open, and once linear, where the unknowns of the balance are those of the displacement, which stands still.
#[test]
fn peaks_of_a_tilt_have_derivatives() {
    let m = A - C;
    let d = DAMPING / (2.0 * (K * m).sqrt());
    let (root, under) = ((1.0 - d * d).sqrt(), 1.0 - 2.0 * d * d);
    let (top, speed) = (TAU / (2.0 * d * root), (K / m).sqrt() / under.sqrt());
    near(top, tilt(speed), 1e-12);
    // d/dD
    let (top_d, speed_d) = (-top * under / (d * root * root), 2.0 * d * speed / under);
    let by_m = [-speed / (2.0 * m) - speed_d * d / (2.0 * m), -top_d * d / (2.0 * m)];
    let known = [
        ("d.diametral_inertia", by_m),
        ("d.polar_inertia", by_m.map(|x| -x)),
        ("shaft.tilt_stiffness", [speed / (2.0 * K) - speed_d * d / (2.0 * K), -top_d * d / (2.0 * K)]),
        ("losses.tilt_damping", [speed_d * d / DAMPING, top_d * d / DAMPING]),
        ("d.skew", [0.0, top / TAU]),
    ];
    let stop = machine("");
    let linear =
        stop.replace("kind = \"stop\"", "kind = \"damper\"").replace("stiffness = \"1e6 N/m\"\ngap = \"20 mm\"", "damping = 1e-12");
    for (machine, settled) in [(stop, 1e-9), (linear, 1e-9)] {
        let o = run_on(&machine, "kind = \"sensitivity\"\nspeed = { from = 600, to = 1400 }");
        let (t, s) = (o.find_table("places").expect("places"), o.find_table("sensitivities").expect("sensitivities"));
        let names: Vec<String> = (0..t.rows()).map(|i| text(t, "body", i)).collect();
        assert_eq!(names, [POINT, "tilt of d"], "{:?}", o.findings);
        assert!(column(t, "settled").iter().all(|x| *x < settled), "{:?}", column(t, "settled"));
        let tilts = [false, true].map(|tilt| column(t, if tilt { "tilt" } else { "displacement" }));
        assert!(tilts[0][1].is_nan() && tilts[1][0].is_nan(), "a size in two units: {tilts:?}");
        near(tilts[0][0], HEIGHT * top, 1e-9);
        near(tilts[1][1], top, 1e-9);
        let found = finding(&o, "peak", "tilt of d");
        assert_eq!(found.unit, "rad");
        assert!(found.sentence().contains("The peak of the tilt of \"d\""), "{}", found.sentence());
        for (place, height, column_of) in [(0, HEIGHT, "displacement"), (1, 1.0, "tilt")] {
            near(column(t, "speed")[place], speed, 1e-8);
            let (of, speeds, sizes) = (column(s, "place"), column(s, "speed slope"), column(s, &format!("{column_of} slope")));
            for (path, [by_speed, by_size]) in &known {
                let row = (0..s.rows()).find(|&r| of[r] == (place + 1) as f64 && text(s, "parameter", r) == *path);
                let row = row.unwrap_or_else(|| panic!("no {path} at {place}"));
                near(sizes[row], height * by_size, 1e-7);
                if *by_speed == 0.0 { assert!((speeds[row] * TAU / speed).abs() < 1e-7) } else { near(speeds[row], *by_speed, 1e-6) }
            }
        }
    }
}

/// Approximate methods are compared by the tilt as well: of a machine that only tilts there is nothing else.
#[test]
fn methods_are_compared_by_tilts() {
    let o = run("kind = \"methods\"\nspeed = { from = 800, to = 1200, points = 3 }");
    let t = o.find_table("methods").expect("methods");
    let speeds = column(t, "speed");
    assert!(t.rows() >= 9);
    for (k, w) in speeds.iter().enumerate() {
        // the last periods of an integration from the converged motion
        let by_time = text(t, "method", k) == "time integration";
        near(column(t, "d largest tilt_y")[k], tilt(*w), if by_time { 1e-6 } else { 1e-9 });
        near(column(t, "d tilt converged")[k], tilt(*w), 1e-9);
        near(column(t, &format!("{POINT} largest x"))[k], HEIGHT * tilt(*w), if by_time { 1e-6 } else { 1e-9 });
        assert!(column(t, "deviation")[k] < if by_time { 1e-6 } else { 1e-9 }, "{}", column(t, "deviation")[k]);
    }
}

#[test]
fn stationary_states_show_tilts_and_points() {
    let o = run("kind = \"stationary\"\nspeed = { from = 500, to = 900, points = 3 }\nstarts = 10");
    let states = o.find_table("states").unwrap();
    let [speeds, own, tilts, points] = ["speed", "d radius", "tilt of d", &format!("{POINT} radius")].map(|name| column(states, name));
    assert_eq!(speeds, [500.0, 700.0, 900.0]);
    for (k, &w) in speeds.iter().enumerate() {
        near(tilts[k], tilt(w), 1e-9);
        near(points[k], HEIGHT * tilt(w), 1e-9);
        assert!(own[k] < 1e-12);
    }
}
