//! Machines of several spins: coaxial shafts, geared shafts, and what does not go together.

use crate::common::files::load;
use laval::model::erased::D1;
use laval::model::linear::{Form, LinearModel, LinearScratch};
use laval::model::part::{At, DofKind, Rows};
use laval::model::system::Drive;
use laval::model::system::{System, Workspace};
use laval::solve::machine_mode::Whirl;
use laval::solve::motion::trajectory::{Choice, Plan, simulate};
use laval::solve::motion::{Motion, SpinLaw};
use laval::solve::pencil::{Linearised, MachineMode};
use laval::solve::rest::rest;
use laval::solve::roots::{Request, has_more_modes, roots};
use laval_num::complex::C64;

const RATIO: f64 = -1.4;

/// An outer disc at the speed of the machine and an inner one at another, on bearings of their own and one between them.
fn coaxial(speed: f64, between: &str) -> String {
    format!(
        r#"
[machine]
name = "coaxial"
speed = {speed}
[[part]]
kind = "speed_ratio"
name = "inner"
ratio = {RATIO}
[[part]]
kind = "disc"
name = "case"
mass = 12.0
polar_inertia = 0.3
diametral_inertia = 0.2
eccentricity = 2e-5
[[part]]
kind = "disc"
name = "core"
spin = "inner"
mass = 7.0
polar_inertia = 0.11
diametral_inertia = 0.08
eccentricity = 3e-5
eccentricity_phase = 0.4
{own}{between}"#,
        own = ["case", "core"]
            .iter()
            .enumerate()
            .flat_map(|(k, body)| [("lower", -0.2), ("upper", 0.3)].map(|at| (k, *body, at)))
            .map(|(k, body, (name, at))| format!(
                "[[part]]\nkind = \"bearing_linear\"\nname = \"{body}_{name}\"\nbetween = [{{ body = \"{body}\", at = {at} }}, \"ground\"]\nkxx = {0}\nkyy = {1}\ncxx = 200.0\ncyy = 260.0\n",
                2e6 + 4e5 * k as f64,
                2.6e6
            ))
            .collect::<String>(),
    )
}

/// The core alone, at the speed of its own spin.
fn core(speed: f64) -> String {
    let all = coaxial((RATIO * speed).abs(), "");
    let blocks: Vec<&str> = all.split("[[part]]").collect();
    let own = |b: &&&str| b.contains("\"core") || b.contains("[machine]");
    blocks.iter().filter(own).map(|b| b.replace("spin = \"inner\"\n", "")).collect::<Vec<_>>().join("[[part]]")
}

const BETWEEN: &str = "[[part]]\nkind = \"bearing_linear\"\nname = \"between\"\nbetween = [{ body = \"core\", at = 0.1 }, { body = \"case\", at = 0.1 }]\nkxx = 3e6\nkyy = 3e6\ncxx = 150.0\ncyy = 150.0\n";

fn modes(system: &System, speed: f64) -> Vec<MachineMode> {
    Linearised::new(system, &rest(system, speed).unwrap()).unwrap().spectrum().unwrap().modes
}

/// What turns with another spin and touches nothing else behaves as a machine of that speed.
#[test]
fn a_shaft_of_its_own_spin_is_a_machine_of_that_speed() {
    let (speed, both) = (700.0, load(&coaxial(700.0, "")).system);
    let alone = load(&core(speed)).system;
    let (all, own) = (modes(&both, speed), modes(&alone, RATIO * speed));
    assert_eq!((own.len(), all.len()), (4, 8));
    for m in &own {
        let near = all.iter().map(|o| (o.value - m.value).abs() / m.value.abs()).fold(f64::INFINITY, f64::min);
        assert!(near < 1e-12, "{:?}", m.value);
    }
    // at the speed of the machine it would have other modes
    let wrong = modes(&alone, speed);
    assert!(wrong.iter().all(|m| all.iter().all(|o| (o.value - m.value).abs() / m.value.abs() > 1e-4)));
}

/// The state after 0.2 s.
fn end_of(motion: &mut Motion, y: &[f64]) -> Vec<f64> {
    let plan = Plan {
        t_end: 0.2,
        choice: Choice::Explicit,
        relative: 1e-11,
        absolute: 1e-12,
        outputs: &[],
        windows: 1,
        rest: &[],
        bound: f64::INFINITY,
        kick: None,
        max_steps: 10_000_000,
        cancel: &|| false,
        progress: &|_| {},
    };
    simulate(motion, y, &plan).unwrap().state
}

/// A spin that is free carries the energy of all that it turns: it changes by what is dissipated, and by the square of the ratio for a drag on the other spin.
#[test]
fn a_free_spin_keeps_the_account_of_its_energy() {
    let drag = "[[part]]\nkind = \"spin_load\"\nspin = \"inner\"\ndrag = 0.3\n";
    let mut system = load(&coaxial(300.0, &format!("{BETWEEN}{drag}"))).system;
    system.machine.drive = Drive::Free;
    let mut motion = Motion::new(&system, SpinLaw::Free).unwrap();
    motion.keep_account().unwrap();
    let mut y = vec![0.0; 2 * system.n() + 2 + 4];
    y[2 * system.n() + 1] = 300.0;
    y[system.coordinate("core.x").unwrap()] = 3e-4;
    let end = end_of(&mut motion, &y);
    let (from, to) = (motion.stored_energy(0.0, &y).unwrap(), motion.stored_energy(0.2, &end).unwrap());
    let account = &end[2 * system.n() + 2..];
    let lost = account[0] - account[1] - account[2] - account[3];
    assert!(from - to > 1000.0 && (from - to - lost).abs() < 1e-8 * from, "{from} {to} {lost}");
    // the drag alone, on rigid rotors
    let inertia = 0.3 + RATIO * RATIO * 0.11;
    let expected = 300.0 * (-RATIO * RATIO * 0.3 / inertia * 0.2f64).exp();
    let speed = end[2 * system.n() + 1];
    assert!((speed / expected - 1.0).abs() < 2e-3, "{speed} {expected}");
}

/// In time as well: loads, gyroscopic moments and their signs, at constant speed and while the speed changes.
#[test]
fn its_motion_is_that_of_the_machine_of_that_speed() {
    use laval::solve::programme::{Programme, Shape};
    for changing in [false, true] {
        let programme = |ratio: f64| {
            let (a, b) = (300.0 * ratio, if changing { 900.0 * ratio } else { 300.0 * ratio });
            if changing { Programme::ramp(a, b, 0.2, Shape::Linear, 0.3 * ratio).unwrap() } else { Programme::constant(a, 0.3 * ratio) }
        };
        let end = |text: &str, ratio: f64| {
            let system = load(text).system;
            let y = end_of(&mut Motion::new(&system, SpinLaw::Programme(programme(ratio))).unwrap(), &vec![0.0; 2 * system.n()]);
            let first = system.coordinate("core.x").unwrap();
            y[first..first + 4].to_vec()
        };
        let (both, alone) = (end(&coaxial(300.0, ""), 1.0), end(&core(300.0), RATIO));
        let size = alone.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(size > 1e-7);
        for (a, b) in both.iter().zip(&alone) {
            assert!((a - b).abs() < 1e-8 * size, "{changing}: {both:?} {alone:?}");
        }
    }
}

/// A machine seen in a mirror has its spins reversed and the same frequencies.
#[test]
fn mirrored_spins_have_the_same_frequencies() {
    let system = load(&coaxial(700.0, BETWEEN)).system;
    let (there, back) = (modes(&system, 700.0), modes(&system, -700.0));
    for (a, b) in there.iter().zip(&back) {
        assert!((a.value.im.abs() - b.value.im.abs()).abs() < 1e-9 * a.value.abs());
    }
    let own = modes(&load(&coaxial(700.0, "")).system, 700.0);
    assert!(there.iter().any(|m| own.iter().all(|o| (o.value - m.value).abs() > 1e-3 * m.value.abs())), "the bearing between them couples");
}

/// The model holds exact derivatives in the ratio.
#[test]
fn the_ratio_is_a_parameter() {
    let system = load(&coaxial(700.0, BETWEEN)).system;
    let index = system.param("inner.ratio").unwrap()[0];
    let (speed, step) = (700.0, 1e-5);
    let plain = |ratio: f64| {
        let mut params = system.params().to_vec();
        params[index] = ratio;
        let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
        system.linear(&params, speed, Form::Time, &mut model, &mut scratch);
        (model.polynomial()[1].clone(), model.loads.others[0].force[0].clone())
    };
    let mut params: Vec<D1> = system.params().iter().map(|&x| D1::lift(x)).collect();
    params[index].eps[0] = 1.0;
    let (mut model, mut scratch) = (LinearModel::default(), LinearScratch::default());
    system.linear(&params, D1::lift(speed), Form::Time, &mut model, &mut scratch);
    let ((up, load_up), (down, load_down)) = (plain(RATIO + step), plain(RATIO - step));
    let mut seen = 0;
    let exact: Vec<f64> = model.polynomial()[1].iter().chain(&model.loads.others[0].force[0]).map(|x| x.eps[0]).collect();
    for (d, (a, b)) in exact.iter().zip(up.iter().chain(&load_up).zip(down.iter().chain(&load_down))) {
        let difference = (a - b) / (2.0 * step);
        assert!((d - difference).abs() < 1e-7 * (1.0 + difference.abs()), "{d} {difference}");
        seen += usize::from(difference != 0.0);
    }
    assert!(seen >= 3, "gyroscopic moments and the load depend on it");
}

/// Inertia about the axis counts in the spin row with the square of the ratio, and the torque of gyroscopic and unbalanced forces is a power over the speed.
#[test]
fn the_spin_row_is_that_of_the_geared_train() {
    let system = load(&coaxial(700.0, "").replace("eccentricity = 2e-5", "").replace("eccentricity = 3e-5", "")).system;
    let zero = vec![0.0; system.n()];
    let at = At { q: &zero, v: &zero, a: &zero, z: &[], phase: 0.2, speed: 700.0, spin_accel: 3.0, t: 0.0 };
    let (mut force, mut spin) = (zero.clone(), 0.0);
    let mut rows = Rows { force: &mut force, rate: &mut [], spin: &mut spin };
    system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |_| true);
    assert!((spin - 3.0 * (0.3 + RATIO * RATIO * 0.11)).abs() < 1e-13, "{spin}");
}

/// Two wheels in mesh: pitch radii, stiffness of the mesh and pressure angle; masses, moments of inertia and springs of the wheels.
pub(super) const RADII: [f64; 2] = [0.12, 0.06];
const MESH: f64 = 3e7;
pub(super) const PRESSURE: f64 = 0.35;
pub(super) const MASSES: [f64; 2] = [20.0, 6.0];
const INERTIAS: [f64; 2] = [0.15, 0.012];
pub(super) const SPRINGS: [f64; 2] = [4e6, 7e6];

pub(super) fn geared() -> String {
    let wheel = |name: &str, i: usize, spin: &str| {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"{name}\"\nmass = {}\npolar_inertia = {}\ntorsional = true\n{spin}[[part]]\nkind = \"bearing_linear\"\nname = \"of_{name}\"\nbetween = [\"{name}\", \"ground\"]\nkxx = {}\nkyy = {2}\n",
            MASSES[i], INERTIAS[i], SPRINGS[i]
        )
    };
    format!(
        "[machine]\nname = \"geared\"\nspeed = 300.0\n[[part]]\nkind = \"speed_ratio\"\nname = \"fast\"\nratio = -2.0\n{}{}[[part]]\nkind = \"gear\"\nbetween = [\"wheel\", \"pinion\"]\nfirst_radius = {}\nsecond_radius = {}\nstiffness = {MESH}\npressure_angle = {PRESSURE}\nazimuth = 0.6\n",
        wheel("wheel", 0, ""),
        wheel("pinion", 1, "spin = \"fast\"\n"),
        RADII[0],
        RADII[1]
    )
}

/// Two wheels on isotropic springs and free to turn: the mesh is one spring between them, so that the squares of the frequencies are the roots of a sum.
#[test]
fn geared_wheels_have_the_frequencies_of_the_secular_equation() {
    let (r, k, phi, m, j, own) = (RADII, MESH, PRESSURE, MASSES, INERTIAS, SPRINGS);
    let text = geared();
    let system = load(&text).system;
    // two uncoupled motions across the line of action, rolling, and three of the equation
    let sum = |w: f64| -> f64 {
        let at = |i: usize| 1.0 / (own[i] - m[i] * w * w) - (phi.cos() * r[i]).powi(2) / (j[i] * w * w);
        1.0 + k * (at(0) + at(1))
    };
    let mut counts = [0; 3];
    for mode in modes(&system, 300.0) {
        let w = mode.value.im;
        if mode.value.abs() < 1.0 {
            assert!(mode.is_free(), "{:?}", mode.value);
            counts[0] += 1;
            continue;
        }
        let across = [0, 1].into_iter().any(|i| (w - (own[i] / m[i]).sqrt()).abs() < 1e-8 * w);
        // near a root the sum changes its sign
        let root = sum(w * (1.0 - 1e-9)) * sum(w * (1.0 + 1e-9)) < 0.0 && sum(w).abs() < 1.0;
        assert!(across != root, "{w}: {}", sum(w));
        counts[if root { 2 } else { 1 }] += 1;
    }
    assert_eq!(counts[1..], [2, 3], "{counts:?}");
    assert!(counts[0] >= 1, "the wheels roll");
}

/// Two long shafts in mesh that turn freely: the two roots at zero are counted at once, without a search that divides the plane about them, and the other modes are those of shafts that a soft
/// spring holds.
#[test]
fn shafts_that_turn_freely_are_counted_at_once() {
    let shaft = |name: &str, spin: &str, diameter: f64| {
        let bearing = |side: &str, at: f64| {
            format!(
                "[[part]]\nkind = \"bearing_linear\"\nname = \"{side} of {name}\"\nbetween = [{{ body = \"{name}\", at = {at:?} }}, \"ground\"]\nkxx = 1.5e8\nkyy = 2e8\ncxx = 8e4\ncyy = 1e5\n"
            )
        };
        format!(
            "[[part]]\nkind = \"shaft\"\nname = \"{name}\"\nmaterial = \"steel\"\ntorsional = true\nelements = 9\n{spin}section = [{{ length = 0.9, outer_diameter = {diameter:?} }}]\n\
             [[part]]\nkind = \"disc\"\nname = \"wheel of {name}\"\non = {{ body = \"{name}\", at = 0.4 }}\nmass = 30.0\npolar_inertia = 0.3\ndiametral_inertia = 0.2\n{}{}",
            bearing("left", 0.1),
            bearing("right", 0.8)
        )
    };
    let text = format!(
        "[machine]\nname = \"geared\"\nspeed = 300.0\n[[part]]\nkind = \"speed_ratio\"\nname = \"fast\"\nratio = -3.5\n{}{}\
         [[part]]\nkind = \"gear\"\nbetween = [{{ body = \"slow\", at = 0.4 }}, {{ body = \"quick\", at = 0.4 }}]\nfirst_radius = 0.245\nsecond_radius = 0.07\nstiffness = 4e8\ndamping = 5e3\n{}\
         [[part]]\nkind = \"coupling\"\nname = \"coupling\"\nbetween = [{{ body = \"motor\", at = 0.9 }}, \"slow\"]\nstiffness = 2e6\ntilt_stiffness = 5e4\n\
         torsional_stiffness = 3e6\ntorsional_damping = 300.0\n",
        shaft("slow", "", 0.12),
        shaft("quick", "spin = \"fast\"\n", 0.07),
        shaft("motor", "", 0.15)
    );
    let [train, held] =
        ["", "[[part]]\nkind = \"coupling\"\nname = \"soft\"\nbetween = [\"slow\", \"ground\"]\ntorsional_stiffness = 1.0\n"]
            .map(|more| load(&format!("{text}{more}")).system);
    assert!(has_more_modes(&train));
    for speed in [40.0, 300.0, 480.0] {
        let found = |system: &System, starts: &[C64]| {
            roots(system, &rest(system, speed).unwrap(), &Request { frequency: Some(3000.0), starts, ..Request::default() }).unwrap()
        };
        let held = found(&held, &[]);
        let others: Vec<_> = held.spectrum.modes.iter().map(|m| m.value).filter(|s| s.im > 10.0).collect();
        // as from the speed before, which hands on no roots at zero
        let free = found(&train, &others);
        // exact, and among the modes: all shafts turn as their ratios
        assert!(free.at_zero.is_none(), "{speed}: {:?}", free.at_zero);
        let turns: Vec<&MachineMode> = free.spectrum.modes.iter().filter(|m| m.is_free()).collect();
        assert_eq!(turns.len(), 1, "{speed}");
        let slowly = turns[0].q.iter().fold(0.0f64, |m, q| m.max(q.abs())) / 3.5;
        for (c, q) in train.coordinates().iter().zip(&turns[0].q) {
            let ratio = match c.dof.kind {
                DofKind::Twist if train.slots()[c.slot].name == "quick" => 3.5,
                DofKind::Twist => 1.0,
                _ => 0.0,
            };
            assert!((q.abs() - ratio * slowly).abs() < 1e-12 * slowly, "{}: {q:?}", c.name);
        }
        assert!(free.areas.iter().all(|a| a.complete()) && free.evaluations < 3000, "{speed}: {}", free.evaluations);
        assert!(
            others.len() > 4 && others.len() == free.spectrum.modes.iter().filter(|m| m.value.im > 10.0).count(),
            "{speed}: {others:?}"
        );
        for s in others {
            assert!(free.spectrum.modes.iter().any(|m| (m.value - s).abs() < 1e-5 * s.abs()), "{speed}: {s:?}");
        }
    }
}

/// On stiff bearings one mode is nearly rolling against the teeth: `w^2 = k cos(phi)^2 (r1^2/J1 + r2^2/J2)`, less what the bearings give way. It is torsional although the wheels whirl a little,
/// and no resonance of whirl.
#[test]
fn a_mode_of_the_teeth_is_torsional() {
    let stiff = geared().replace(&format!("{}", SPRINGS[0]), "4e9").replace(&format!("{}", SPRINGS[1]), "7e9");
    let system = load(&stiff).system;
    let turning = |i: usize| (PRESSURE.cos() * RADII[i]).powi(2) / INERTIAS[i];
    let w = (MESH * (turning(0) + turning(1))).sqrt();
    let found: Vec<MachineMode> = modes(&system, 300.0).into_iter().filter(|m| m.value.im > 1.0).collect();
    let near: Vec<&MachineMode> = found.iter().filter(|m| (m.value.im / w - 1.0).abs() < 0.02).collect();
    assert_eq!(near.len(), 1, "{w} {:?}", found.iter().map(|m| m.value).collect::<Vec<_>>());
    assert_eq!(near[0].whirl, Whirl::Torsional);
    let across = system.coordinates().iter().zip(&near[0].q).filter(|(c, _)| c.dof.kind != DofKind::Twist).map(|(_, q)| q.abs());
    assert!(across.fold(0.0, f64::max) > 0.0, "{:?}", near[0].q);
    assert!(found.iter().filter(|m| m.whirl.is_lateral()).count() >= 4);
}

/// No unbalance drives torsion, that of the pinion as little as that of the wheel: on the lines of both spins only whirl has critical speeds.
#[test]
fn torsion_has_no_critical_speed_of_any_spin() {
    let stiff = geared().replace(&format!("{}", SPRINGS[0]), "4e9").replace(&format!("{}", SPRINGS[1]), "7e9");
    let system = load(&stiff).system;
    let turning = |i: usize| (PRESSURE.cos() * RADII[i]).powi(2) / INERTIAS[i];
    let torsional = (MESH * (turning(0) + turning(1))).sqrt();
    let state = |w: f64| rest(&system, w);
    let speeds: Vec<f64> = (0..60).map(|k| 50.0 + 100.0 * f64::from(k)).collect();
    let sweep = laval::solve::sweep::sweep(&system, &state, &speeds, f64::INFINITY, |_, _| true).unwrap();
    let at = |order: f64| laval::solve::criticals::criticals(&system, &state, &sweep, &[order]);
    let crosses = |order: f64| at(order).iter().any(|c| (c.order * c.speed / torsional - 1.0).abs() < 0.02);
    assert!(!crosses(1.0) && !crosses(2.0) && crosses(3.0), "{torsional}");
}

/// A force F of the teeth moves the wheels by F/(k - m w^2) along the line of action and turns them by F r cos(phi)/(J w^2): the share of the twist in the kinetic
/// energy follows. It is a column of the table, a curve beside the shapes and a sentence below them.
#[test]
fn modes_of_geared_wheels_show_their_twist() {
    let o = &crate::common::files::run_all(&format!("{}[[study]]\nkind = \"modes\"\n", geared()))[0];
    let table = o.find_table("modes").unwrap();
    let column = |name: &str| -> Vec<f64> {
        let c = table.column(name).unwrap_or_else(|| panic!("no {name}"));
        (0..c.data.len()).map(|i| c.number(i).unwrap()).collect()
    };
    let expected = |w: f64| {
        let across = |i: usize| MASSES[i] / (SPRINGS[i] - MASSES[i] * w * w).powi(2);
        let about = |i: usize| (PRESSURE.cos() * RADII[i] / (w * w)).powi(2) / INERTIAS[i];
        let twist = about(0) + about(1);
        twist / (twist + across(0) + across(1))
    };
    let (frequencies, shares) = (column("frequency"), column("torsional_share"));
    let mut coupled = Vec::new();
    for (k, (w, share)) in frequencies.iter().zip(&shares).enumerate().filter(|(_, (w, _))| **w > 1.0) {
        if (0..2).any(|i| (w - (SPRINGS[i] / MASSES[i]).sqrt()).abs() < 1e-8 * w) {
            assert!(*share < 1e-9, "{w}: {share}");
            continue;
        }
        assert!((share - expected(*w)).abs() < 1e-6, "{w}: {share} {}", expected(*w));
        if *share >= 0.05 {
            coupled.push(k + 1);
        }
    }
    assert!(!coupled.is_empty() && shares.iter().all(|s| (0.0..=1.0).contains(s)), "{shares:?}");
    // no wheel moves along the axis
    assert!(table.column("axial_share").is_none_or(|c| (0..c.data.len()).all(|i| c.number(i) == Some(0.0))));
    let along = o.find_table("along").unwrap();
    let drawn = along.column("mode").unwrap();
    let numbers: Vec<usize> = (0..along.rows()).step_by(2).map(|i| drawn.number(i).unwrap() as usize).collect();
    assert_eq!(numbers, coupled);
    assert!(
        o.figures.iter().any(|f| f.name == "along" && f.panels.len() == 1),
        "{:?}",
        o.figures.iter().map(|f| &f.name).collect::<Vec<_>>()
    );
    let shapes = o.figures.iter().find(|f| f.name == "shapes").and_then(|f| f.tiles.as_ref()).unwrap();
    let notes: Vec<String> = shapes.notes.iter().map(|n| laval::report::Style::default().arg(n)).collect();
    for k in &coupled {
        assert!(notes.iter().any(|n| n.contains(&format!("Mode {k} also twists, with"))), "{notes:?}");
    }
}

/// The unbalance of either spin acts at its own frequency: what the core does by itself is what the machine says of its spin, in the direction in which it turns.
#[test]
fn responses_are_those_of_a_spin() {
    use crate::common::files::run_all;
    let study = |spin: &str| format!("[[study]]\nkind = \"forced_response\"\nspeed = {{ from = 100.0, to = 1500.0, points = 60 }}\n{spin}");
    let of = |text: &str, column: &str| -> (Vec<f64>, Vec<f64>) {
        let outcome = run_all(text).swap_remove(0);
        let table = outcome.find_table("response").unwrap();
        let all = |name: &str| -> Vec<f64> {
            let c =
                table.column(name).unwrap_or_else(|| panic!("{name}: {:?}", table.columns().iter().map(|c| &c.name).collect::<Vec<_>>()));
            (0..c.data.len()).map(|i| c.number(i).unwrap()).collect()
        };
        (all("speed"), all(column))
    };
    let at = |(speeds, values): &(Vec<f64>, Vec<f64>), w: f64| {
        let k = (0..speeds.len()).min_by(|&a, &b| (speeds[a].abs() - w).abs().total_cmp(&(speeds[b].abs() - w).abs())).unwrap();
        assert!((speeds[k].abs() - w).abs() < 1e-6 * w, "{w}: {}", speeds[k]);
        values[k]
    };
    let column = "amplitude.core";
    let own = of(&(coaxial(300.0, "") + &study("spin = \"inner\"\n")), column);
    let alone = of(&(core(300.0) + &study("")), column);
    let outer = of(&(coaxial(300.0, "") + &study("")), column);
    // the ends are speeds of every table
    for w in [100.0, 1500.0] {
        let (a, b) = (at(&own, w), at(&alone, w));
        assert!(b > 1e-9 && (a / b - 1.0).abs() < 1e-9, "{w}: {a} {b}");
        assert!(at(&outer, w).abs() < 1e-3 * b, "the core does not move with the case");
    }
    assert!(own.0.iter().all(|w| *w < 0.0), "it turns the other way");
    let warned = run_all(&(coaxial(300.0, "") + &study(""))).swap_remove(0);
    assert!(crate::common::files::finding(&warned, "spin").message.to_string().contains("inner"));
}

/// Critical speeds are sought of the unbalance of every spin, unless orders are named.
#[test]
fn critical_speeds_are_those_of_every_spin() {
    use crate::common::files::run_all;
    let orders = |lines: &str| -> Vec<f64> {
        let text = coaxial(300.0, BETWEEN) + "[[study]]\nkind = \"critical_speeds\"\nspeed = { from = 50.0, to = 2000.0 }\n" + lines;
        let outcome = run_all(&text).swap_remove(0);
        let c = outcome.find_table("critical_speeds").unwrap().column("order").unwrap();
        let mut all: Vec<f64> = (0..c.data.len()).map(|i| c.number(i).unwrap()).collect();
        all.dedup();
        all
    };
    assert_eq!(orders(""), [1.0, RATIO.abs()]);
    assert_eq!(orders("orders = [1]\n"), [1.0]);
}

/// The spin that a machine is seen at is kept where it is assembled anew.
#[test]
fn another_spin_is_kept_with_other_parameters() {
    let system = load(&coaxial(300.0, BETWEEN)).system;
    let other = system.at_spin("inner").unwrap();
    let again = other.with(&[("core.mass", 7.0)]).unwrap();
    assert_eq!(again.machine.speed, Some(RATIO * 300.0));
    let ratios = |s: &System| s.slots().iter().map(|slot| slot.speed(s.params(), 1.0)).collect::<Vec<f64>>();
    assert_eq!(ratios(&other), ratios(&again));
    assert!(ratios(&other).contains(&(1.0 / RATIO)) && ratios(&other).contains(&1.0));
    // seen at either spin the same machine has the same modes
    for (a, b) in modes(&system, 300.0).iter().zip(modes(&other, RATIO * 300.0)) {
        assert!((a.value - b.value).abs() < 1e-9 * a.value.abs());
    }
    assert!(other.at_spin("inner").is_err(), "it is the spin of the machine already");
}

/// The motion in time is the sum of the responses of both spins.
#[test]
fn motions_in_time_are_the_sum_of_both_responses() {
    use laval::solve::linear_response::response;
    use laval::solve::programme::Programme;
    let system = load(&coaxial(300.0, BETWEEN)).system;
    let other = system.at_spin("inner").unwrap();
    let amplitudes = |s: &System, w: f64| response(s, &|w| rest(s, w), w).unwrap().unwrap().x;
    let (a, b) = (amplitudes(&system, 300.0), amplitudes(&other, RATIO * 300.0));
    let mut motion = Motion::new(&system, SpinLaw::Programme(Programme::constant(300.0, 0.0))).unwrap();
    let (n, t) = (system.n(), 0.2);
    let turn = |phase: f64| laval_num::complex::C64::cis(phase);
    // begun on it the motion stays on it
    let mut y = vec![0.0; 2 * n];
    for i in 0..n {
        y[i] = a[i].re + b[i].re;
        y[n + i] = -300.0 * a[i].im - RATIO * 300.0 * b[i].im;
    }
    let end = end_of(&mut motion, &y);
    for i in 0..n {
        let expected = (a[i] * turn(300.0 * t)).re + (b[i] * turn(RATIO * 300.0 * t)).re;
        let size = a[i].abs() + b[i].abs();
        assert!((end[i] - expected).abs() < 1e-7 * size, "{i}: {} {expected}", end[i]);
    }
}

/// A run-up of both spins: the core, which touches nothing else, moves as in the run-up of its own machine, seen in a mirror as it turns the other way, and its
/// passage is at the speed of the machine that brings its own spin there.
#[test]
fn run_ups_take_several_spins() {
    use crate::common::files::{findings, run_all};
    let study = |from: f64, to: f64| {
        format!("[[study]]\nkind = \"run_up\"\nfrom = {from}\nto = {to}\nduration = 2.0\npoints = 300\nrelative_tolerance = 1e-9\n")
    };
    let (from, to) = (100.0, 700.0);
    let both = run_all(&(coaxial(300.0, "") + &study(from, to))).swap_remove(0);
    let mirrored = core(300.0).replace("eccentricity_phase = 0.4", "eccentricity_phase = -0.4");
    let alone = run_all(&(mirrored + &study(-RATIO * from, -RATIO * to))).swap_remove(0);
    let column = |o: &laval::outcome::Outcome, table: &str, name: &str| -> Vec<f64> {
        let c = o.find_table(table).unwrap().column(name).unwrap_or_else(|| panic!("{name}"));
        (0..c.data.len()).map(|i| c.number(i).unwrap()).collect()
    };
    let near = |a: &[f64], b: &[f64], sign: f64, tolerance: f64| {
        let size = b.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(size > 1e-6 && a.len() == b.len());
        a.iter().zip(b).all(|(a, b)| (a - sign * b).abs() < tolerance * size)
    };
    for (name, sign) in [("core.x", 1.0), ("core.y", -1.0)] {
        assert!(near(&column(&both, "motion", name), &column(&alone, "motion", name), sign, 1e-5), "{name}");
    }
    // the linear response beside the envelope is that of the core's own spin
    assert!(near(&column(&both, "envelope", "core linear"), &column(&alone, "envelope", "core linear"), 1.0, 1e-9));
    assert!(near(&column(&both, "envelope", "inner speed"), &column(&alone, "envelope", "speed"), -1.0, 1e-12));
    let speeds = |o: &laval::outcome::Outcome| -> Vec<f64> {
        findings(o, "peak").into_iter().filter(|f| f.subject == "core").filter_map(|f| f.value).collect()
    };
    let (a, b) = (speeds(&both), speeds(&alone));
    assert!(!a.is_empty() && a.len() == b.len() && near(&a, &b, -1.0 / RATIO, 1e-2), "{a:?} {b:?}");
}

/// With a bearing between them: the motion is that of an integration of the same programme by the implicit method.
#[test]
fn run_ups_of_several_spins_are_motions_of_the_programme() {
    use crate::common::files::run_all;
    use laval::solve::programme::{Programme, Shape};
    let text = coaxial(300.0, BETWEEN);
    let outcome = run_all(
        &(text.clone() + "[[study]]\nkind = \"run_up\"\nfrom = 100\nto = 600\nduration = 0.5\npoints = 100\nrelative_tolerance = 1e-9\n"),
    )
    .swap_remove(0);
    let table = outcome.find_table("motion").unwrap();
    let column = |name: &str| -> Vec<f64> {
        let c = table.column(name).unwrap();
        (0..c.data.len()).map(|i| c.number(i).unwrap()).collect()
    };
    let (times, found) = (column("t"), ["case.x", "core.x"].map(column));
    let system = load(&text).system;
    let law = SpinLaw::Programme(Programme::ramp(100.0, 600.0, 0.5, Shape::Linear, 0.0).unwrap());
    let mut motion = Motion::new(&system, law).unwrap();
    let plan = Plan {
        t_end: 0.5,
        choice: Choice::Stiff,
        relative: 1e-9,
        absolute: 1e-10,
        outputs: &times,
        windows: 1,
        rest: &[],
        bound: 1.0,
        kick: None,
        max_steps: 1_000_000,
        cancel: &|| false,
        progress: &|_| (),
    };
    let y = vec![0.0; laval_num::ode::Ode::dim(&motion)];
    let own = simulate(&mut motion, &y, &plan).unwrap();
    for (name, found) in ["case.x", "core.x"].into_iter().zip(&found) {
        let k = system.coordinates().iter().position(|c| c.name == name).unwrap();
        let expected: Vec<f64> = own.states.chunks_exact(y.len()).map(|y| y[k]).collect();
        let size = expected.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(size > 1e-6 && expected.len() == found.len());
        assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-5 * size), "{name}");
    }
}

fn mistake(text: &str) -> String {
    let found = laval::file::load(text).err().unwrap_or_else(|| panic!("accepted:\n{text}"));
    assert!(found.0.iter().all(|d| d.span.is_some()), "{found:?}");
    found.0.iter().map(|d| format!("{}: {}", d.code, d.message)).collect::<Vec<_>>().join("\n")
}

#[test]
fn mistakes_are_found_at_their_place() {
    let both = coaxial(700.0, "");
    assert!(mistake(&both.replace("spin = \"inner\"", "spin = \"iner\"")).contains("spin.missing"));
    let coupling = "[[part]]\nkind = \"coupling\"\nbetween = [\"case\", \"core\"]\nstiffness = 1e5\n";
    assert!(mistake(&coaxial(700.0, coupling)).contains("part.spins"));
    let gear = "[[part]]\nkind = \"gear\"\nbetween = [\"case\", \"core\"]\nfirst_radius = 0.1\nsecond_radius = 0.2\nstiffness = 1e5\n";
    let message = mistake(&coaxial(700.0, gear));
    assert!(message.contains("part.spins") && message.contains("-0.5"), "{message}");
    assert!(mistake(&both.replace("ratio = -1.4", "ratio = 0")).contains("stands still"));
    let ring = "[[part]]\nkind = \"disc\"\nname = \"ring\"\non = \"case\"\nspin = \"inner\"\nmass = 1.0\n";
    assert!(mistake(&coaxial(700.0, ring)).contains("spin.fixed"));
    let study = "[[study]]\nkind = \"basins\"\nx = { coordinate = \"case.x\", from = -1e-3, to = 1e-3 }\n";
    let loaded = laval::file::load(&format!("{both}[[study]]\nkind = \"nonlinear_response\"\nspeed = {{ from = 100, to = 400 }}\n"));
    let refusals = loaded.unwrap_or_else(|d| panic!("{d:?}")).refusals();
    assert!(refusals[0].diagnostic.code == "study.spins" && refusals[0].diagnostic.message.contains("inner"), "{study}");
}
