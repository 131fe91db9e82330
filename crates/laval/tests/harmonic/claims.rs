//! Findings of the studies of nonlinear machines, each beside a machine for which it must not appear.

use crate::common;

use common::files::{finding, findings, run_all};
use common::planar_file::planar_file;
use laval::outcome::{Arg, Data, Level, Outcome};

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    let t = o.find_table(table).unwrap_or_else(|| panic!("no table {table}"));
    (0..t.rows()).map(|k| t.column(name).unwrap_or_else(|| panic!("no {name}")).number(k).unwrap()).collect()
}

/// States of the planar rotor by few methods.
fn methods(damping: [&str; 2], speed: &str) -> Outcome {
    let rotor = planar_file("per_axis", "1 mm", damping);
    let study = format!("[[study]]\nkind = \"methods\"\nspeed = {speed}\nharmonics = 1\n");
    run_all(&format!("{rotor}\n{study}")).remove(0)
}

/// One value of a column for each state, in the rows of averaging.
fn of_states(o: &Outcome, name: &str) -> Vec<f64> {
    let Data::Text(method) = &o.find_table("methods").unwrap().column("method").unwrap().data else { panic!("no text") };
    column(o, "methods", name).into_iter().zip(method).filter(|r| r.1 == "averaging").map(|r| r.0).collect()
}

const UNDAMPED: [&str; 2] = ["0", "0"];
const DAMPED: [&str; 2] = ["42", "6.59"];
/// From below the fold at 2686 rad/s, above which there are three states, to above it.
const THREE: &str = "{ from = 2600, to = 3000, points = 2 }";

/// Without damping the exponents are zero to their error, on either side of it: no state is reported as
/// unstable. With damping the middle one of three grows.
#[test]
fn growth_within_its_error_is_no_instability() {
    let mut above = 0;
    for speed in ["700", "1100", "1500"] {
        let o = methods(UNDAMPED, speed);
        let exact = of_states(&o, "growth converged");
        assert!(!exact.is_empty() && exact.iter().all(|g| g.abs() < 1e-3), "{exact:?}");
        above += exact.iter().filter(|g| **g > 0.0).count();
        assert!(findings(&o, "unstable").is_empty(), "{exact:?}");
    }
    assert!(above > 0);
    let o = methods(DAMPED, THREE);
    let exact = of_states(&o, "growth converged");
    let unstable = exact.iter().filter(|g| **g > 0.0).count();
    assert!(unstable > 0 && unstable < exact.len(), "{exact:?}");
    let reported = finding(&o, "unstable");
    assert!(reported.level == Level::Warning && reported.value == Some(unstable as f64), "{reported:?} {exact:?}");
}

/// Growth that is zero to its error has no sign that averaging could miss; beyond the error the signs of all
/// states are compared.
#[test]
fn averaging_is_compared_where_growth_has_a_sign() {
    let o = methods(UNDAMPED, "1100");
    assert!(of_states(&o, "growth converged").iter().any(|g| *g != 0.0));
    assert!(findings(&o, "averaging_stability").is_empty(), "{:?}", o.findings);
    let o = methods(DAMPED, THREE);
    let (exact, slow) = (of_states(&o, "growth converged"), of_states(&o, "growth of slow motion"));
    let wrong = exact.iter().zip(&slow).filter(|(e, s)| (**e > 0.0) != (**s > 0.0)).count();
    let reported = finding(&o, "averaging_stability");
    assert_eq!((reported.value, reported.number("wrong")), (Some(wrong as f64), Some(wrong as f64)), "{reported:?}");
    assert_eq!(reported.number("states"), Some(exact.len() as f64), "{reported:?}");
}

/// A disc on a bearing `k + c a^2`, 1000 rad/s at small amplitudes.
fn backbone(cubic: f64, speed: f64) -> Outcome {
    let text = format!(
        "[machine]\nspeed = \"{speed} rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\n\
         [[part]]\nkind = \"bearing_cubic\"\nbetween = [\"d\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 2e6\ncubic_stiffness = {cubic:e}\n\
         [[study]]\nkind = \"backbone\"\namplitude = {{ from = \"20 um\", to = \"100 um\" }}\n"
    );
    run_all(&text).remove(0)
}

/// `w^2 = (k + c a^2)/m` changes by the share `c (a2^2 - a1^2)/2k` between two amplitudes: below 1e-7 the
/// frequency is kept, above it rises or falls.
#[test]
fn a_whirl_keeps_its_frequency_within_rounding_only() {
    for change in [4e-8, -4e-8, 3e-7, -3e-7] {
        let o = backbone(change * 2.0 * 2e6 / (1e-8 - 4e-10), 100.0);
        let families = findings(&o, "family");
        assert!(!families.is_empty());
        let w = column(&o, "backbone", "frequency");
        assert!((w[w.len() - 1].abs() / w[0].abs() - 1.0 - change).abs() < 1e-10, "{change}: {w:?}");
        let words = [change > 1e-7, change < -1e-7];
        for f in families {
            let trend = |word| f.message.args.contains(&("trend", Arg::word(word)));
            assert_eq!(["hardens", "softens"].map(trend), words, "{change}: {}", f.sentence());
            assert_eq!(f.message.key == "backbone-family-constant", change.abs() < 1e-7, "{change}: {}", f.sentence());
        }
    }
}

/// The drive that keeps a damped whirl up makes up for all of its damping: the family begins at `sqrt(k/m)` = 1000 rad/s and is named by it, not by the damped
/// frequency, 995 rad/s at a damping ratio of 0.1. Without damping both are the same.
#[test]
fn a_damped_family_is_named_by_the_frequency_at_which_it_begins() {
    for damping in [400.0f64, 0.0] {
        let text = format!(
            "[machine]\nspeed = \"100 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\n\
             [[part]]\nkind = \"bearing_cubic\"\nbetween = [\"d\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 2e6\ncubic_stiffness = 4e13\n\
             [[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\ndamping = {damping}\n\
             [[study]]\nkind = \"backbone\"\namplitude = {{ from = \"20 um\", to = \"100 um\" }}\n"
        );
        let o = run_all(&text).remove(0);
        let damped = (1e6 - (damping / 4.0).powi(2)).sqrt();
        let modes = column(&o, "modes", "frequency");
        assert!(!modes.is_empty() && modes.iter().all(|w| (w.abs() / damped - 1.0).abs() < 1e-6), "{modes:?}");
        let families = findings(&o, "family");
        assert!(!families.is_empty());
        for f in families {
            assert!((f.value.unwrap().abs() / 1000.0 - 1.0).abs() < 1e-6, "{}", f.sentence());
        }
        // at 20 um the bearing has added to its stiffness already
        let first = column(&o, "backbone", "frequency")[0].abs();
        assert!((first / (1e6 + 0.5 * 4e13 * 4e-10f64).sqrt() - 1.0).abs() < 1e-6, "{first}");
    }
}

/// A whirl has the frequency of the spin at the amplitude at which `k + c a^2 = m W^2`, if that lies among
/// those computed.
#[test]
fn a_whirl_meets_the_spin_where_their_frequencies_are_equal() {
    let cubic = 4e13;
    for (speed, met) in [(1040.0, true), (2000.0, false), (900.0, false)] {
        let o = backbone(cubic, speed);
        let amplitude = ((2.0 * speed * speed - 2e6) / cubic).sqrt();
        assert_eq!((2e-5..1e-4).contains(&amplitude), met, "{amplitude}");
        let reported = findings(&o, "synchronous");
        assert_eq!(!reported.is_empty(), met, "{reported:?}");
        assert!(reported.iter().all(|f| (f.value.unwrap() / amplitude - 1.0).abs() < 1e-6), "{reported:?} {amplitude}");
        assert_eq!(o.special_points.iter().filter(|p| p.kind == "synchronous").count(), reported.len());
    }
}

/// `w^2 = (k + c a^2)/m` of a softening bearing vanishes at `a^2 = -k/c`: the family ends there, and is not that of the mirror image as well.
#[test]
fn a_softening_whirl_ends_where_its_frequency_vanishes() {
    let (k, cubic, m) = (8e5f64, -6e12, 2.0);
    let text = format!(
        "[machine]\nspeed = \"500 rad/s\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = {m}\n\
         [[part]]\nkind = \"bearing_cubic\"\nbetween = [\"d\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = {k:e}\ncubic_stiffness = {cubic:e}\n\
         [[study]]\nkind = \"backbone\"\n"
    );
    let o = run_all(&text).remove(0);
    let w = column(&o, "backbone", "frequency");
    assert!((w[0] / (k / m).sqrt() - 1.0).abs() < 1e-5 && w.iter().all(|w| *w > 0.0) && w.windows(2).all(|w| w[1] < w[0]), "{w:?}");
    let end = finding(&o, "whirl_ends");
    let vanishes = (k / -cubic).sqrt();
    assert!((end.value.unwrap() / vanishes - 1.0).abs() < 1e-3 && end.value.unwrap() < vanishes, "{}", end.sentence());
    let family = finding(&o, "family");
    let softens = family.message.args.contains(&("trend", Arg::word("softens")));
    assert!(softens && family.message.key == "backbone-family", "{}", family.sentence());
    assert_eq!(o.end, laval::outcome::End::Reached);
}

/// What the work limit ended is not laid on max_points, which was never reached.
#[test]
fn a_branch_that_the_work_limit_ends_is_said_to_be() {
    let text = "[machine]\nspeed = 1000\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\neccentricity = \"40 um\"\n\
         [[part]]\nkind = \"bearing_cubic\"\nbetween = [\"d\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 8e5\ncubic_stiffness = 6e12\n\
         [[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\ndamping = 120\n\
         [[study]]\nkind = \"nonlinear_response\"\nspeed = { from = 50, to = 4000 }\n\
         [[study]]\nkind = \"nonlinear_response\"\nname = \"few\"\nspeed = { from = 50, to = 4000 }\nmax_points = 10\n";
    let l = common::files::load(text);
    for (study, limit, why) in [(0, 1, "work limit"), (0, 20, "work limit"), (1, u64::MAX, "largest number of points")] {
        let context = laval::study::Context { work_limit: limit, ..laval::study::Context::quiet("study") };
        let o = l.studies[study].study.run(&l.system, &context).unwrap();
        let unfinished = [findings(&o, "sweep_up_unfinished"), findings(&o, "branch_unfinished")].concat();
        assert!(!unfinished.is_empty() && unfinished.iter().all(|f| f.sentence().contains(why)), "{limit}: {:?}", o.findings);
    }
}

/// Two rotors that know nothing of each other: between two speeds the oil whips one of them, above them the other jumps. The jump is named with what
/// lies before it.
#[test]
fn a_jump_names_the_instability_on_its_way() {
    let speeds = "speed = [100, 400, 500, 600, 700, 2000]";
    let (flat, cross) = ("[1e6, 1e6, 1e6, 1e6, 1e6, 1e6]", |sign: &str| format!("[0, 0, {sign}1e5, {sign}1e5, 0, 0]"));
    let text = |kxy: &str, kyx: &str| {
        format!(
            "[machine]\nspeed = 1000\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\neccentricity = \"100 um\"\n\
             [[part]]\nkind = \"bearing_cubic\"\nbetween = [\"d\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 1e6\ncubic_stiffness = 1e12\n\
             [[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\ndamping = 170\n\
             [[part]]\nkind = \"disc\"\nname = \"other\"\nmass = 1\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"other\", \"ground\"]\n\
             table = {{ {speeds}, kxx = {flat}, kyy = {flat}, kxy = {kxy}, kyx = {kyx}, cxx = [50, 50, 50, 50, 50, 50], cyy = [50, 50, 50, 50, 50, 50] }}\n\
             [[study]]\nkind = \"nonlinear_response\"\nspeed = {{ from = 300, to = 1500 }}\n"
        )
    };
    let none = "[0, 0, 0, 0, 0, 0]";
    let calm = run_all(&text(none, none)).remove(0);
    let whipped = run_all(&text(&cross(""), &cross("-"))).remove(0);
    let (calm, whipped) = (finding(&calm, "jump_up"), finding(&whipped, "jump_up"));
    assert!(!calm.sentence().contains("unstable"), "{}", calm.sentence());
    assert!(whipped.sentence().contains("before this jump is unstable from 4"), "{}", whipped.sentence());
    assert!((whipped.value.unwrap() / calm.value.unwrap() - 1.0).abs() < 1e-6);
}

/// A machine that nothing forces has no resonance: this is stated, and no speed is named. An eccentricity is one, and so is a tilt of a disc.
#[test]
fn nothing_is_called_a_resonance_where_nothing_forces_the_machine() {
    let machine = |disc: &str, axis: &str| {
        format!(
            "[machine]\nspeed = 500\naxis = \"{axis}\"\n[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 2\n{disc}\n\
             [[part]]\nkind = \"bearing_cubic\"\nname = \"bearing\"\nbetween = [\"drum\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 2e6\n\
             cubic_stiffness = 1e12\n[[part]]\nkind = \"damper\"\nbetween = [\"drum\", \"ground\"]\ndamping = 400\n"
        )
    };
    let grid = "x = { parameter = \"drum.mass\", from = 2, to = 3, points = 2 }\ny = { parameter = \"bearing.stiffness\", from = 2e6, to = 3e6, points = 2 }";
    let range = "speed = { from = 500, to = 1500, points = 3 }";
    let studies = [
        ("largest_displacement", "kind = \"nonlinear_response\"\nspeed = { from = 500, to = 1500 }".to_string()),
        ("largest_peak", format!("kind = \"response_map\"\nspeed = {{ from = 500, to = 1500 }}\n{grid}")),
        ("largest_displacement", format!("kind = \"sweep\"\n{range}")),
        ("largest_displacement", format!("kind = \"motion_map\"\nspeed = 500\n{grid}")),
    ];
    let outcome = |disc: &str, axis: &str, study: &str| run_all(&format!("{}[[study]]\n{study}\n", machine(disc, axis))).remove(0);
    for (id, study) in &studies {
        for axis in ["vertical", "horizontal"] {
            let o = outcome("", axis, study);
            let [f] = findings(&o, id)[..] else { panic!("{study} {axis}: {:?}", o.findings) };
            assert!(f.message.key == "unforced" && f.sentence().contains("no resonance"), "{study} {axis}: {f:?}");
            assert_eq!(f.value, Some(0.0));
            assert!(findings(&o, "smallest_peak").is_empty() && findings(&o, "largest_displacement_of").is_empty());
        }
        let o = outcome("eccentricity = 1e-9", "vertical", study);
        let f = finding(&o, id);
        assert!(f.message.key != "unforced" && f.value > Some(0.0), "{study}: {f:?}");
    }
    let one = "kind = \"nonlinear_response\"\nspeed = 500";
    let unforced = |disc: &str| {
        let o = outcome(disc, "vertical", one);
        finding(&o, "steady_motion").notes.iter().any(|n| n.key == "nonlinear-response-no-excitation")
    };
    assert!(unforced("") && !unforced("eccentricity = 1e-6"));
}
