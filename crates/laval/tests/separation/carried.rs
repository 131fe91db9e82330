//! Cups that a body carries are in the machine of every study: the part keeps its promises, and every study answers as it does for the same masses written into the
//! disc.

use laval::file::load;
use laval::model::builder::Builder;
use laval::model::conformance::{Options, assert_none, check};
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::outcome::{Data, Finding, Outcome};
use laval::parts::{bearing_cubic::*, disc::*};
use laval::separation::carried::Cups;
use laval::separation::cup::{Hanging, SwingingCup};
use laval::separation::load::Ring;
use laval::solve::linear_response::response;
use laval::solve::rest::rest;
use laval::study::{Context, registry};
use laval_num::complex::{C64, c};
use std::f64::consts::TAU;

fn ring(held: Option<f64>) -> Ring {
    let body = Hanging { moment_across: 2e-4, product: 1e-5, across: 0.004, ..Hanging::point(0.4, 0.06) };
    let cup = SwingingCup { hinge: 0.09, body, damping: 0.0, gravity: 9.80665 };
    Ring { cup, held, count: 4, mass_differences: vec![0.03, 0.0, -0.01, 0.0], centre_differences: vec![0.0, 0.001, 0.0, -0.002] }
}

/// Tangents, power, isotropy, blocks; at speeds at which the cups are on their way out.
#[test]
fn the_part_keeps_its_promises() {
    let slow = Options { speed: 14.0, rate: 10.0, spin_accel: 40.0, ..Options::default() };
    for (held, options) in [(None, slow), (Some(0.7), Options::default())] {
        assert_none(&check(&Cups::new(Attach::at("rotor", 0.02), ring(held)), &(), &options));
    }
    let symmetric = Ring { cup: SwingingCup { body: Hanging::point(0.4, 0.06), ..ring(None).cup }, ..ring(None) };
    assert_none(&check(&Cups::new(Attach::on("rotor"), symmetric), &(), &slow));
}

/// Far above its critical speeds a rotor turns about its principal axis of inertia: that of a disc with one point mass m at the radius r leans by
/// P/(A' - C') to the mass (A' as the mean over all directions), P = m r times the height of the mass over the common centre, and passes through that centre.
#[test]
fn a_free_rotor_turns_about_its_principal_axis() {
    let (disc, diametral, polar, hinge_height) = (10.0, 0.5, 0.2, 0.3);
    let spring = |z: f64| BearingCubic::isotropic(Link::Between(Attach::at("disc", z), Attach::ground()));
    let soft = BearingCubicParams { stiffness: [1e-3; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 };
    let inertia = DiscParams { diametral_inertia: diametral, polar_inertia: polar, ..DiscParams::new(disc) };
    let (tilt, m, hinge, l, speed) = (0.9f64, 0.04, 0.15, 0.1, 1e3);
    let cup = SwingingCup { hinge, body: Hanging::point(m, l), damping: 0.0, gravity: 9.80665 };
    let ring = Ring { cup, held: Some(tilt), count: 1, mass_differences: vec![], centre_differences: vec![] };
    let system = Builder::new("free")
        .part("disc", Disc::tilting(), inertia)
        .part("upper", spring(0.1), soft)
        .part("lower", spring(-0.1), soft)
        .part("cup", Cups::new(Attach::at("disc", hinge_height), ring), ())
        .build()
        .unwrap_or_else(|d| panic!("{d:?}"));
    let (r, z) = (hinge + l * tilt.sin(), hinge_height - l * tilt.cos());
    let total = disc + m;
    let centre = m * z / total;
    let moment = diametral + disc * centre * centre + m * (z - centre).powi(2) + 0.5 * m * r * r - (polar + m * r * r);
    let lean = m * r * (z - centre) / moment;
    let found = response(&system, &|w| rest(&system, w), speed).unwrap_or_else(|d| panic!("{d:?}")).expect("no resonance");
    let (x, angle) = (found.circles(0).0, found.circles(2).0);
    for height in [0.0, 1.0] {
        let at = x - (angle * c(0.0, 1.0)).scale(height);
        let expected = -m * r / total - lean * (height - centre);
        assert!((at - c(expected, 0.0)).abs() < 1e-9 * expected.abs(), "{at:?} {expected}");
    }
}

/// What the walk asks of every kind of study.
const STUDIES: &[(&str, &str)] = &[
    ("modes", ""),
    ("campbell", "speed = { from = 10, to = 600, points = 12 }"),
    ("critical_speeds", "speed = { from = 10, to = 600, points = 12 }"),
    ("stability_map", "speed = { from = 10, to = 600, points = 6 }"),
    ("harmonic_force", "place = \"rotor\"\nspeed = { from = 50, to = 600, points = 20 }"),
    ("stability_threshold", "place = \"rotor\"\nspeed = 100\nup_to = 1e6"),
    ("forced_response", "speed = { from = 50, to = 600, points = 20 }"),
    ("nonlinear_response", "speed = { from = 50, to = 600 }"),
    (
        "bifurcation_loci",
        "speed = { from = 50, to = 600 }\nparameter = { parameter = \"inside.damping\", from = 0, to = 60, points = 3 }\nmax_points = 200",
    ),
    (
        "response_map",
        "x = { parameter = \"housing.mass\", from = 20, to = 24, points = 2 }\n\
         y = { parameter = \"losses.damping\", from = 60, to = 100, points = 2 }\nspeed = { from = 50, to = 600 }",
    ),
    ("stationary", "speed = { from = 50, to = 300 }\nstarts = 10\nmax_points = 200"),
    ("sensitivity", "speed = { from = 50, to = 600 }"),
    ("backbone", "max_points = 100"),
    ("limit_cycles", "speed = { from = 50, to = 600 }"),
    ("methods", "speed = { from = 100, to = 200 }"),
    ("transient", "duration = \"0.2 s\""),
    ("run_up", "to = \"400 rad/s\"\nduration = \"1 s\""),
    ("operating_window", "speed = { from = 50, to = 600, points = 20 }"),
    ("sweep", "speed = { from = 100, to = 200, points = 3 }"),
    (
        "motion_map",
        "y = { parameter = \"housing.mass\", from = 20, to = 24, points = 2 }\n\
         x = { parameter = \"losses.damping\", from = 60, to = 100, points = 2 }",
    ),
    (
        "basins",
        "from = { \"rotor.x\" = \"-0.1 mm\", \"rotor.y\" = \"-0.1 mm\" }\nto = { \"rotor.x\" = \"0.1 mm\", \"rotor.y\" = \"0.1 mm\" }\npoints = 8",
    ),
    (
        "uncertainty",
        "study = { kind = \"modes\" }\nparameters = [{ parameter = \"losses.damping\", distribution = \"normal\", deviation = \"2 %\" }]\nsamples = 4",
    ),
    (
        "optimum",
        "study = { kind = \"modes\" }\nvary = [{ parameter = \"losses.damping\", from = 1, to = 100 }]\nmaximise = \"least_damped_mode damping ratio\"\nruns = 20\n\
         starts = 1",
    ),
];
/// Studies in which nothing moves across the axis.
const WITHOUT_MOTION: &[&str] = &["separation"];
/// Studies of a machine at rest or without its loads: of cups they see the masses of their part.
const APART: &[&str] = &["static", "support_stiffness_map", "bearing_coefficients"];

/// A rotor that tilts on a foundation, on springs that harden; `rotor` says what the disc is, `more` what is beside it. Where a cycle is wanted the losses turn.
fn machine(rotor: &str, more: &str, axes: &str) -> String {
    let bearing = |name: &str, z: i32, k: &str| {
        format!(
            "[[part]]\nkind = \"bearing_cubic\"\nname = \"{name}\"\nbetween = [{{ body = \"rotor\", at = \"{z} mm\" }}, \"housing\"]\nlaw = \"isotropic\"\n\
             stiffness = {k}\ncubic_stiffness = 1e11\n"
        )
    };
    format!(
        "[machine]\nspeed = \"300 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\n{rotor}\n\
         [[part]]\nkind = \"foundation\"\nname = \"housing\"\nmass = 22\nstiffness = 3e5\ndamping = 300\n{}{}\
         [[part]]\nkind = \"damper\"\nname = \"losses\"\nbetween = [\"rotor\", \"ground\"]\ndamping = 60\ntilt_damping = 0.3\n\
         [[part]]\nkind = \"damper\"\nname = \"inside\"\nbetween = [\"rotor\", \"housing\"]\ndamping = 60\naxes = \"{axes}\"\n\
         [limits]\ndisplacement = {{ rotor = \"0.5 mm\" }}\n{more}\n",
        bearing("upper", 100, "2e5"),
        bearing("lower", -80, "1e5"),
    )
}

fn run(machine: &str, kind: &str, fields: &str) -> Outcome {
    let text = format!("{machine}[[study]]\nkind = \"{kind}\"\n{fields}\n");
    let loaded = load(&text).unwrap_or_else(|d| panic!("{kind}: {d:?}\n{text}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("walk")).unwrap_or_else(|d| panic!("{kind}: {d:?}"))
}

/// Ids, subjects and values of the findings, and the columns of speeds, rates, displacements and angles.
type Numbers = (Vec<(String, String, f64)>, Vec<(String, Vec<f64>)>);

/// Evidence, not answers; angles of what is nearly round or may turn by a whole turn; and what a disc shows of itself, which cups beside it are not.
const ASIDE: [&str; 11] =
    ["error", "residual", "uncertainty", "bracket", "remaining", "settled", "slope", "direction", "phase", "centre of mass", "swing"];
/// Largest value of a column that is rounding.
const ROUNDING: f64 = 1e-9;

fn numbers(o: &Outcome) -> Numbers {
    // cups have a validity of their own, and the point at which they hang is one more point of the rotor
    let theirs = |f: &Finding| (f.id.contains("validity") && f.subject == "buckets") || f.subject == "rotor at 30 mm";
    let answers = o.findings.iter().filter(|f| f.id != "energy_balance" && !theirs(f));
    let findings = answers.map(|f| (f.id.clone(), f.subject.clone(), f.value.unwrap_or(0.0))).collect();
    let columns = o.tables.iter().flat_map(|t| t.columns().iter().map(move |c| (format!("{}.{}", t.name(), c.name), c)));
    let motions =
        columns.filter(|(name, c)| ["m", "rad", "rad/s", "1/s"].contains(&c.unit.as_str()) && !ASIDE.iter().any(|a| name.contains(a)));
    let large = |v: &[f64]| v.iter().any(|x| x.abs() > ROUNDING);
    let floats = motions.filter_map(|(name, c)| if let Data::Float(v) = &c.data { large(v).then(|| (name, v.clone())) } else { None });
    (findings, floats.collect())
}

/// The largest difference of values of findings, and of columns of one length that both have, over the largest value in them. Infinite where other things are found.
fn difference(a: &Numbers, b: &Numbers) -> f64 {
    let of = |x: &[f64], y: &[f64]| {
        let size = x.iter().chain(y).filter(|v| v.is_finite()).fold(0.0f64, |m, v| m.max(v.abs()));
        let far = x.iter().zip(y).map(|(x, y)| if x.is_nan() && y.is_nan() { 0.0 } else { (x - y).abs() });
        let far = far.fold(0.0, |m, d| if d <= m { m } else { d });
        if far == 0.0 { 0.0 } else { far / size }
    };
    let names = |n: &Numbers| n.0.iter().map(|f| (f.0.clone(), f.1.clone())).collect::<Vec<_>>();
    if names(a) != names(b) {
        return f64::INFINITY;
    }
    let findings = a.0.iter().zip(&b.0).map(|(x, y)| of(&[x.2], &[y.2]));
    let columns = a.1.iter().filter_map(|(name, x)| {
        let y = &b.1.iter().find(|o| o.0 == *name)?.1;
        (x.len() == y.len()).then(|| of(x, y))
    });
    findings.chain(columns).fold(0.0, |m, d| if d <= m { m } else { d })
}

/// Masses of four cups held at a tilt, added up one by one into the disc.
fn lumped(tilt: f64, extra: f64) -> String {
    let (mass, diametral, polar, e) = (3.0, 0.02, 0.03, 1e-4);
    let (m, l, hinge, height) = (0.4, 0.06, 0.09, 0.03);
    let (r, z) = (hinge + l * tilt.sin(), height - l * tilt.cos());
    let cups: Vec<(f64, C64)> = (0..4).map(|k| (if k == 0 { m + extra } else { m }, C64::cis(TAU * f64::from(k) / 4.0).scale(r))).collect();
    let total = mass + cups.iter().map(|c| c.0).sum::<f64>();
    let centre = cups.iter().map(|c| c.0 * z).sum::<f64>() / total;
    let unbalance = cups.iter().fold(c(mass * e, 0.0), |u, p| u + p.1.scale(p.0));
    let polar = polar + cups.iter().map(|c| c.0 * r * r).sum::<f64>();
    let diametral = diametral + mass * centre * centre + cups.iter().map(|c| c.0 * ((z - centre).powi(2) + 0.5 * r * r)).sum::<f64>();
    let couple = cups.iter().fold(c(-mass * e * centre, 0.0), |s, p| s + p.1.scale(p.0 * (z - centre)));
    let skew = (couple * c(0.0, 1.0)).scale(1.0 / (diametral - polar));
    format!(
        "mass = {total}\npolar_inertia = {polar}\ndiametral_inertia = {diametral}\ncentre_of_mass = {centre}\neccentricity = {}\neccentricity_phase = {}\nskew = {}\nskew_phase = {}",
        unbalance.abs() / total,
        unbalance.arg(),
        skew.abs(),
        skew.arg()
    )
}

const BARE: &str = "mass = 3\npolar_inertia = 0.03\ndiametral_inertia = 0.02\neccentricity = \"100 um\"";

fn cups(tilt: &str, extra: f64) -> String {
    format!(
        "[[cup]]\nkind = \"swinging\"\nname = \"buckets\"\non = {{ body = \"rotor\", at = \"30 mm\" }}\ncount = 4\nmass = \"0.4 kg\"\ncentre_of_mass = \"60 mm\"\n\
         hinge_radius = \"90 mm\"\ncup_radius = \"15 mm\"\nbottom = \"75 mm\"\n{tilt}\nmass_differences = [{extra}, 0, 0, 0]"
    )
}

/// Every kind of study, against the machine with the same masses in its disc, and against the disc alone.
#[test]
fn every_study_sees_the_cups() {
    let known: Vec<&str> = STUDIES.iter().map(|s| s.0).chain(WITHOUT_MOTION.iter().chain(APART).copied()).collect();
    for kind in registry() {
        assert!(known.contains(&kind.info.kind), "say here how {} sees what cups weigh", kind.info.kind);
    }
    let mut wrong = Vec::new();
    for (kind, fields) in STUDIES {
        let axes = if *kind == "limit_cycles" { "rotating" } else { "fixed" };
        let answer = |rotor: &str, more: &str| numbers(&run(&machine(rotor, more, axes), kind, fields));
        let carried = answer(BARE, &cups("tilt = 0.8", 0.002));
        let (same, far) = (difference(&carried, &answer(&lumped(0.8, 0.002), "")), difference(&carried, &answer(BARE, "")));
        // while the speed changes a skew and a couple of unbalance differ in their moment by the acceleration, and windows of the envelope in the turns they hold
        let tolerance = match *kind {
            "run_up" => 5e-2,
            _ => 1e-4,
        };
        if !(same <= tolerance) || !(far > 1e-2) {
            wrong.push(format!("{kind}: {same:e} from the lumped disc, {far:e} from the disc alone"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Cups that swing: at every speed the machine is that of cups held at the tilt of that speed.
#[test]
fn swinging_cups_are_at_the_tilt_of_every_speed() {
    let cup = SwingingCup { hinge: 0.09, body: Hanging::point(0.4, 0.06), damping: 0.0, gravity: 9.80665 };
    for speed in [0.0, 6.0, 12.0, 40.0, 300.0] {
        let tilt = format!("tilt = {}", cup.equilibrium(speed));
        let fields = format!("speed = {speed}");
        let answer = |tilt: &str| numbers(&run(&machine(BARE, &cups(tilt, 0.002), "fixed"), "modes", &fields));
        let d = difference(&answer(""), &answer(&tilt));
        assert!(d <= 1e-9, "{speed}: {d:e}");
    }
}

/// The critical speed of a laboratory centrifuge with cups, of two planar bodies: det(K - W^2 M) = 0.
#[test]
fn the_critical_speed_of_a_centrifuge_with_cups() {
    let text = "[machine]\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 3\npolar_inertia = 0.03\neccentricity = \"300 um\"\n\
        [[part]]\nkind = \"foundation\"\nname = \"housing\"\nmass = 22\nstiffness = 3e4\n\
        [[part]]\nkind = \"shaft_lumped\"\nname = \"spindle\"\nbetween = [\"rotor\", \"housing\"]\nstiffness = 2e5\n\
        [[cup]]\nkind = \"swinging\"\nname = \"buckets\"\non = \"rotor\"\ncount = 4\nmass = \"0.4 kg\"\ncentre_of_mass = \"60 mm\"\nhinge_radius = \"90 mm\"\n\
        cup_radius = \"20 mm\"\nbottom = \"110 mm\"\n";
    let o = run(text, "critical_speeds", "speed = { from = 10, to = 470 }");
    let t = o.find_table("critical_speeds").expect("a table");
    let (k, f, m, h) = (2e5f64, 3e4, 3.0 + 4.0 * 0.4, 22.0);
    let (b, d) = (k * h + (k + f) * m, k * f);
    for (row, sign) in [(0, -1.0), (t.rows() - 1, 1.0)] {
        let w = ((b + sign * (b * b - 4.0 * m * h * d).sqrt()) / (2.0 * m * h)).sqrt();
        let found = t.column("speed").and_then(|c| c.number(row)).expect("a speed");
        assert!((found - w).abs() < 1e-8 * w, "{found} {w}");
    }
    assert!(t.rows() >= 2);
}

/// A part that has the name of a block beside the parts stays; cups that have the name of a part are refused.
#[test]
fn blocks_and_parts_of_one_name() {
    let text = |cup: &str| {
        format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"limits\"\nmass = 1\n[[part]]\nkind = \"shaft_lumped\"\nbetween = [\"limits\", \"ground\"]\n\
             stiffness = 1e5\n[limits]\ndisplacement = \"1 mm\"\n{cup}"
        )
    };
    let cups = |name: &str| cups("", 0.0).replace("\"buckets\"", &format!("{name:?}")).replace("\"rotor\"", "\"limits\"");
    assert_eq!(load(&text("")).unwrap_or_else(|d| panic!("{d:?}")).system.slots().len(), 2);
    assert_eq!(load(&text(&cups("buckets"))).unwrap_or_else(|d| panic!("{d:?}")).system.slots().len(), 3);
    assert_eq!(load(&text(&cups("limits"))).err().expect("refused").0[0].code, "part.duplicate");
}

/// A horizontal axis leaves cups nothing to swing out against.
#[test]
fn swinging_cups_on_a_horizontal_axis_are_refused() {
    let text = |tilt: &str| machine(BARE, &cups(tilt, 0.0), "fixed").replace("[machine]\n", "[machine]\naxis = \"horizontal\"\n");
    let d = load(&text("")).err().expect("refused");
    assert!(d.0.iter().any(|d| d.code == "part.axis" && d.span.is_some()), "{d:?}");
    assert!(load(&text("tilt = 0.8")).is_ok());
}
