//! What studies of motions say is what was computed: where a motion starts, what a peak of its envelope is, what the energy balance misses, where a part is valid.

use super::spin_load::{column, find, run, value};
use laval::outcome::Level;

const GRAVITY: f64 = 9.80665;

/// Balls that go round in a horizontal drum leave no rest to start from; the drum hangs by the weight of all of it nevertheless, at any angles of the balls.
#[test]
fn a_horizontal_drum_with_balls_starts_where_it_hangs() {
    let (drum, balls, ball, kx, ky) = (35.0, 3.0, 0.03, 8e3, 1e4);
    let machine = |axis: &str, initial: &str| {
        format!(
            "[machine]\naxis = \"{axis}\"\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = {drum}\nunbalance = 0.06\npolar_inertia = 1.1\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"drum\", \"ground\"]\nkxx = {kx}\nkyy = {ky}\ncxx = 150\ncyy = 180\n\
             [[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"drum\"\nballs = {balls}\nball_mass = {ball}\ntrack_radius = 0.24\n\
             ball_radius = \"9.5 mm\"\ndrag = 5e-3\ngravity = 0\n\
             [[study]]\nkind = \"run_up\"\nfrom = 5\nto = 6\nduration = 1\npoints = 50\n{initial}"
        )
    };
    let sag = (drum + balls * ball) * GRAVITY / ky;
    for initial in ["", "initial = { \"ring.ball_1\" = 1.5, \"ring.ball_2\" = 2.5 }\n"] {
        let o = run(&machine("horizontal", initial));
        let (x, y) = (column(&o, "motion", "drum.x"), column(&o, "motion", "drum.y"));
        assert!(x[0].abs() < 1e-9 * sag && (y[0] / -sag - 1.0).abs() < 1e-9, "{} {} {sag}", x[0], y[0]);
        assert!(find(&o, "start").is_none(), "{:?}", o.findings);
        // the drum does not fall: what it does is what the unbalance at 5 rad/s makes of it
        assert!(value(&o, "largest_displacement") < 0.1 * sag, "{}", value(&o, "largest_displacement"));
    }
    let o = run(&machine("vertical", ""));
    assert_eq!(column(&o, "motion", "drum.y")[0], 0.0);
}

/// Cross-coupled stiffness q above c w drives a whirl between two speeds: what grows there is no resonance. Without it one resonance is left.
#[test]
fn growth_through_an_unstable_range_is_no_resonance() {
    let (m, k, c): (f64, f64, f64) = (10.0, 1e6, 300.0);
    let own = (k / m).sqrt();
    let machine = |factor: f64, study: &str| {
        let q = factor * c * own;
        format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = {m}\neccentricity = \"20 um\"\npolar_inertia = 0.1\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\n\
             table = {{ speed = [0, 400, 450, 500, 900], kxx = [{k}, {k}, {k}, {k}, {k}], kyy = [{k}, {k}, {k}, {k}, {k}], kxy = [0, 0, {q}, 0, 0], \
             kyx = [0, 0, {}, 0, 0], cxx = [{c}, {c}, {c}, {c}, {c}], cyy = [{c}, {c}, {c}, {c}, {c}] }}\n\
             [[study]]\nkind = \"run_up\"\nto = 800\npoints = 500\n{study}",
            -q
        )
    };
    let stable = run(&machine(0.9, "duration = 20\n"));
    let peaks: Vec<_> = stable.findings.iter().filter(|f| f.id == "peak").collect();
    assert!(peaks.iter().all(|f| f.message.key == "run-up-resonance") && peaks.len() == 1, "{:?}", stable.findings);
    assert!(peaks[0].sentence().contains("passing a resonance"), "{}", peaks[0].sentence());
    assert!((peaks[0].value.unwrap() - own).abs() < 0.1 * own);
    assert!(find(&stable, "unstable_range").is_none(), "{:?}", stable.findings);
    // above that resonance, from a small start
    let o = run(&machine(3.0, "from = 410\nduration = 2.4375\ninitial = { \"d.x\" = 1e-4 }\n"));
    let grown = find(&o, "unstable_range").unwrap_or_else(|| panic!("{:?}", o.findings));
    // nor is what the start leaves behind, far from any natural frequency
    assert!(o.findings.iter().all(|f| !f.sentence().contains("resonance")), "{:?}", o.findings);
    assert!(grown.level == Level::Warning && grown.sentence().contains("unstable"), "{}", grown.sentence());
    // s = (-c + sqrt(c^2 - 4 m (k - i q)))/2m: it grows most at 450 rad/s
    let rate = grown.evidence.iter().find(|e| e.what == "largest growth rate there").unwrap().value;
    let q = 3.0 * c * own;
    let root = laval_num::complex::C64 { re: c * c - 4.0 * m * k, im: 4.0 * m * q }.sqrt();
    let expected = (root.re.abs() - c) / (2.0 * m);
    assert!((rate / expected - 1.0).abs() < 0.01, "{rate} {expected}");
    assert!((460.0..510.0).contains(&grown.value.unwrap()), "{grown:?}");
}

/// 10 kg on 1e5 N/m, 0.5 % of the critical damping, to three times its critical speed of 100 rad/s in 2 s: after the resonance the envelope has a maximum in every beat.
/// One of them is the resonance, at an angle of up to 2.3 rad of the forced motion against the free one: `(W - 100)^2 = 2 * 150 * 2.3`.
#[test]
fn beats_after_a_quick_passage_are_no_resonances() {
    let text = "[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 10\neccentricity = \"20 um\"\npolar_inertia = 0.1\n\
                [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nkxx = 1e5\nkyy = 1e5\ncxx = 10\ncyy = 10\n\
                [[study]]\nkind = \"run_up\"\nto = 300\nduration = 2\npoints = 200\n";
    let o = run(text);
    let envelope = column(&o, "envelope", "d amplitude");
    let maxima = envelope.windows(3).filter(|w| w[1] >= w[0] && w[1] > w[2]).count();
    assert!(maxima > 3, "{maxima} maxima");
    let peaks: Vec<_> = o.findings.iter().filter(|f| f.id == "peak").collect();
    assert!(peaks.len() == 1 && peaks[0].message.key == "run-up-resonance", "{:?}", o.findings);
    let lag = (2.0f64 * 150.0 * 2.3).sqrt();
    assert!((peaks[0].value.unwrap() - 100.0 - lag).abs() < 0.2 * lag, "{:?}", peaks[0]);
    assert_eq!(o.special_points.iter().filter(|p| p.kind == "peak").count(), 1);
}

/// Two discs of 10 kg, each on 1e5 N/m and joined by 1e5 N/m: natural frequencies of 100 rad/s and 100 sqrt(3) = 173 rad/s. After both, their free motions beat with
/// one another more slowly than with the unbalance. Two resonances are passed, and no other peak is reported.
#[test]
fn beats_of_two_modes_are_no_resonances() {
    let disc = |name: &str, eccentricity: &str| {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"{name}\"\nmass = 10\neccentricity = \"{eccentricity}\"\npolar_inertia = 0.1\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"{name}\", \"ground\"]\nkxx = 1e5\nkyy = 1e5\ncxx = 4\ncyy = 4\n"
        )
    };
    let text = format!(
        "[machine]\n{}{}[[part]]\nkind = \"bearing_linear\"\nbetween = [\"a\", \"b\"]\nkxx = 1e5\nkyy = 1e5\n\
         [[study]]\nkind = \"run_up\"\nto = 300\nduration = 4\npoints = 100\n",
        disc("a", "20 um"),
        disc("b", "0 um")
    );
    let o = run(&text);
    for body in ["a", "b"] {
        let peaks: Vec<_> = o.findings.iter().filter(|f| f.id == "peak" && f.subject == body).collect();
        assert!(peaks.len() == 2 && peaks.iter().all(|f| f.message.key == "run-up-resonance"), "{:?}", o.findings);
        for (peak, own) in peaks.iter().zip([100.0, 173.2]) {
            let speed = peak.value.unwrap();
            assert!((own..1.25 * own).contains(&speed), "{body}: {speed}");
        }
        assert!(
            peaks.iter().any(|f| f.evidence.iter().any(|e| e.what == "beats of the same passage" && e.value > 0.0)),
            "{:?}",
            o.findings
        );
    }
}

/// A free disc: 500 J of spin, nothing exchanged, and what is missing is the rounding of 500 J. What is truly missing still warns.
#[test]
fn an_energy_balance_closes_to_rounding() {
    let text = "study = [{ kind = \"transient\", duration = \"0.1 s\", speed = \"100 rad/s\" }]\n[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\n\
                mass = 1.0\neccentricity = 1e-05\ndiametral_inertia = 0.1\npolar_inertia = 0.1\n";
    let o = run(text);
    let f = find(&o, "energy_balance").unwrap();
    assert!(f.level == Level::Info && f.message.key == "history-energy-closes-to-rounding" && f.value.unwrap() <= 500.0 * 1e-13, "{f:?}");
    let spring = format!("{text}[[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nkxx = 1e5\nkyy = 1e5\n");
    let rough = spring.replace("speed =", "relative_tolerance = 1e-2, absolute_tolerance = 1e-2, initial = { \"d.x\" = 1e-3 }, speed =");
    assert_eq!(find(&run(&rough), "energy_balance").unwrap().level, Level::Warning);
}

/// A kick of 20 mm/s brings `m v^2 / 2` = 10 mJ to 50 kg, at the start or later. The motion decays at `c / 2m` = 1 1/s; before a late kick nothing moves.
#[test]
fn a_kick_is_in_the_energy_balance_and_its_motion_is_assessed() {
    for late in ["", "kick_time = \"0.1 s\"\n"] {
        let text = format!(
            "[machine]\nspeed = \"100 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = \"50 kg\"\n[[part]]\nkind = \"bearing_linear\"\n\
             between = [\"d\", \"ground\"]\nstiffness = \"1e6 N/m\"\ndamping = \"100 N s/m\"\n[[study]]\nkind = \"transient\"\n\
             duration = \"1 s\"\nkick = {{ \"d.x'\" = \"20 mm/s\" }}\n{late}"
        );
        let o = run(&text);
        let f = find(&o, "energy_balance").unwrap();
        assert!(f.level == Level::Info && f.value.unwrap() < 1e-6, "{late}{f:?}");
        let supplied = *column(&o, "energy", "supplied").last().unwrap();
        assert!((supplied / 0.01 - 1.0).abs() < 1e-12, "{late}{supplied}");
        let lost = column(&o, "energy", "change").last().unwrap() + column(&o, "energy", "dissipated").last().unwrap();
        assert!((lost / 0.01 - 1.0).abs() < 1e-6, "{late}{lost}");
        let rate = value(&o, "growth_rate");
        assert!((rate + 1.0).abs() < 0.01, "{late}{rate}");
    }
}

/// An integration that stops after a small part of a long duration: 20 turns and more fall into one window of the envelope.
#[test]
fn a_duration_too_long_for_its_envelope_is_named() {
    let text = "[machine]\nspeed = \"100 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = \"10 kg\"\neccentricity = \"100 um\"\n[[part]]\n\
                kind = \"shaft_lumped\"\nbetween = [\"d\", \"ground\"]\nstiffness = \"1e5 N/m\"\n[[part]]\nkind = \"damper\"\n\
                between = [\"d\", \"ground\"]\ndamping = \"40 N s/m\"\n[[study]]\nkind = \"transient\"\nduration = \"1e9 s\"\npoints = 1000\n";
    let loaded = laval::file::load(text).unwrap();
    let context = laval::study::Context { work_limit: 2000, ..laval::study::Context::quiet("t") };
    let o = loaded.studies[0].study.run(&loaded.system, &context).unwrap();
    let f = find(&o, "no_growth_rate").unwrap();
    assert!(f.message.key == "transient-windows-too-long" && f.sentence().contains("shorter duration"), "{f:?}");
}

const WALL: &str = "wall acceleration over centrifugal acceleration of the layer";

/// A layer of liquid is not held on its wall at standstill: it is valid above a speed, which is no warning.
#[test]
fn a_liquid_is_valid_above_a_speed() {
    let machine = |from: f64| {
        format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = 18\npolar_inertia = 0.2\neccentricity = \"40 um\"\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"wheel\", \"ground\"]\nkxx = 9e6\nkyy = 9e6\ncxx = 900\ncyy = 900\n\
             [[part]]\nkind = \"liquid\"\nname = \"liquid\"\nin = \"wheel\"\ncavity_radius = 0.15\ncavity_height = 0.08\ndensity = 1000\n\
             fill = {{ volume_fraction = 0.1 }}\nwave_damping = 4\n\
             [[study]]\nkind = \"run_up\"\nfrom = {from}\nto = {}\nduration = 1\npoints = 200\n",
            if from == 200.0 { 0.0 } else { 200.0 }
        )
    };
    // from standstill, back to it, and through it
    for from in [0.0, 200.0, -200.0] {
        let o = run(&machine(from));
        let reported: Vec<_> = o.findings.iter().filter(|f| f.id == "validity").collect();
        assert!(reported.iter().all(|f| f.level == Level::Info && !f.sentence().contains("unbounded")), "{from}: {reported:?}");
        let wall = reported.iter().find(|f| f.sentence().contains(WALL)).unwrap();
        if wall.message.key != "history-valid" {
            assert!(wall.number("speed").unwrap() < 10.0, "{from}: {wall:?}");
        }
    }
    let moving = run(&machine(50.0));
    assert!(moving.findings.iter().filter(|f| f.id == "validity").all(|f| f.level == Level::Info && f.message.key == "history-valid"));
}

/// A balanced rotor does not vibrate: its layer of liquid is outside its validity at standstill alone. That is a warning only where the rotor never turns.
#[test]
fn validity_at_standstill_is_no_warning() {
    let machine = "[machine]\n[[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = 18\npolar_inertia = 0.2\n\
                   [[part]]\nkind = \"bearing_linear\"\nbetween = [\"wheel\", \"ground\"]\nkxx = 9e6\nkyy = 9e6\ncxx = 900\ncyy = 900\n\
                   [[part]]\nkind = \"liquid\"\nname = \"liquid\"\nin = \"wheel\"\ncavity_radius = 0.15\ncavity_height = 0.08\ndensity = 1000\n\
                   fill = { volume_fraction = 0.1 }\nwave_damping = 4\n[[study]]\npoints = 200\n";
    for (study, keys) in [
        ("kind = \"run_up\"\nfrom = 0\nto = 200\nduration = 0.2", vec!["history-valid", "history-valid-after-start"]),
        ("kind = \"run_up\"\nfrom = 200\nto = 0\nduration = 0.2", vec!["history-valid-while-turning"]),
        ("kind = \"run_up\"\nfrom = 200\nto = 0\nduration = 0.2\nhold = 0.1", vec!["history-valid-while-turning"]),
        ("kind = \"transient\"\nspeed = 200\nduration = 0.1", vec!["history-valid"]),
        ("kind = \"transient\"\nspeed = 0\nduration = 0.1", vec!["history-not-valid-unbounded"]),
    ] {
        let o = run(&format!("{machine}{study}\n"));
        let wall =
            o.findings.iter().find(|f| f.id == "validity" && f.sentence().contains(WALL)).unwrap_or_else(|| panic!("{:?}", o.findings));
        assert!(keys.contains(&wall.message.key.as_str()), "{study}: {}", wall.sentence());
        assert_eq!(wall.level == Level::Invalid, keys == ["history-not-valid-unbounded"], "{study}: {}", wall.sentence());
        assert!(wall.level != Level::Warning, "{study}: {}", wall.sentence());
    }
}
