//! A cavity off the shaft and skew to it: section by section against the equations written out, and against the unbalance it amounts to.

use super::machine::{FILE, build, changed, model, without};
use laval::cavity::{Cavity, Truncation};
use laval::file::load;
use laval::model::part::{At, Rows};
use laval::model::system::{System, Workspace};
use laval::solve::linear_response::{Response, response};
use laval::solve::rest::rest;
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};
use std::f64::consts::PI;

/// S1 with lines added to its liquid.
fn with_liquid(text: &str, lines: &str) -> String {
    changed(text, &[("density = \"1000", &format!("{lines}\ndensity = \"1000"))])
}

fn at(system: &System, speed: f64) -> Response {
    response(system, &|w| rest(system, w), speed).unwrap().unwrap()
}

const CAVITY: Cavity<f64> = Cavity { radius: 0.15, free: 0.105, height: 0.3, density: 1000.0 };

/// The matrices of `docs/theory/linear-vibration.md#rotor-with-tilt-on-anisotropic-supports`, written out for a centre of mass off the reference point: S1 with a
/// cavity off the shaft and skew.
#[test]
fn against_the_equations_of_the_plane() {
    let (below, above, ei) = (0.25f64, 0.35, 2.06e11 * PI * 0.035f64.powi(4) / 64.0);
    let (m, a, cp, zg, z) = (40.0, 0.70, 0.55, -0.03, 0.04);
    let l = below + above;
    let plane = |k: f64| {
        let e = 1.0 / (3.0 * ei * l);
        let t = [[above / l, below / l], [-1.0 / l, 1.0 / l]];
        let compliance = |i: usize, j: usize| {
            let beam = [
                [below * below * above * above, below * above * (above - below)],
                [below * above * (above - below), below * below - below * above + above * above],
            ];
            e * beam[i][j] + (t[i][0] * t[j][0] + t[i][1] * t[j][1]) / k
        };
        let det = compliance(0, 0) * compliance(1, 1) - compliance(0, 1) * compliance(1, 0);
        [compliance(1, 1) / det, -compliance(0, 1) / det, compliance(0, 0) / det]
    };
    let (kx, ky) = (plane(2e7), plane(1.2e7));
    let half = |x: f64, y: f64| (0.5 * (x + y), 0.5 * (x - y));
    let [(k11, d11), (k12, d12), (k22, d22)] = [0, 1, 2].map(|i| half(kx[i], ky[i]));
    let (cm, cd) = half(3e6, 4e6);
    let (eps, tau) = (c(5e-5, 0.0), C64::cis(PI / 3.0).scale(2e-4));
    // of the cavity, at its middle
    let (e_cav, t_cav) = (C64::cis(0.7).scale(3e-4), C64::cis(-0.4).scale(1e-3));
    let text = changed(
        &with_liquid(FILE, "eccentricity = 3e-4\neccentricity_phase = 0.7\nskew = 1e-3\nskew_phase = -0.4"),
        &[("polar_inertia = \"0.55 kg m^2\"", "polar_inertia = \"0.55 kg m^2\"\ncentre_of_mass = -0.03")],
    );
    for (word, nu) in [("strip", 0.0), ("spatial", 0.0), ("planar_tilt", 0.0), ("strip", 1e-4), ("spatial", 1e-5)] {
        let own = if nu > 0.0 { with_liquid(&model(&text, word), &format!("viscosity = {nu}")) } else { model(&text, word) };
        let system = build(&own);
        for speed in [40.0, 230.0, 700.0] {
            let reaction = |w: f64| -> [C64; 2] {
                let at = c(w, 0.0);
                let planar = if nu > 0.0 { CAVITY.planar_viscous(at, speed, nu) } else { CAVITY.planar(at, speed) };
                let tilt = match (word, nu > 0.0) {
                    ("strip", _) => planar.scale(0.0075),
                    ("planar_tilt", _) => CAVITY.mean_tilt(at, speed),
                    (_, true) => CAVITY.tilt_viscous(at, speed, nu, Truncation::None).value,
                    _ => CAVITY.tilt(at, speed, Truncation::None).value,
                };
                [planar, tilt]
            };
            let rotor = |w: f64| -> [[C64; 3]; 3] {
                let [l0, lt] = reaction(w);
                let re = |x: f64| c(x, 0.0);
                let off = |x: C64| x.mul_i();
                [
                    [c(-w * w * m + k11, w * 100.0 - speed * 20.0) - l0, c(0.0, w * w * m * zg - k12) + off(l0).scale(z), re(-k11)],
                    [
                        c(0.0, -w * w * m * zg + k12) - off(l0).scale(z),
                        c(-w * w * (a + m * zg * zg) + cp * speed * w + k22, w * 0.6 - speed * 0.1) - l0.scale(z * z) - lt,
                        c(0.0, -k12),
                    ],
                    [re(-k11), c(0.0, k12), c(-w * w * 250.0 + k11 + cm, 3000.0 * w)],
                ]
            };
            let coupling: [[C64; 3]; 3] = [
                [c(d11, 0.0), c(0.0, d12), c(-d11, 0.0)],
                [c(0.0, d12), c(-d22, 0.0), c(0.0, -d12)],
                [c(-d11, 0.0), c(0.0, -d12), c(d11 + cd, 0.0)],
            ];
            let (forward, backward) = (rotor(speed), rotor(-speed));
            let mut d = Mat::from_fn(6, 6, |i, j| match (i < 3, j < 3) {
                (true, true) => forward[i][j],
                (true, false) => coupling[i][j - 3],
                (false, true) => coupling[i - 3][j].conj(),
                _ => backward[i - 3][j - 3].conj(),
            });
            let w2 = speed * speed;
            let [l0, lt] = reaction(speed);
            let force = l0 * e_cav;
            // the centre of mass off the reference point has its moment, as the liquid's force at the cavity's middle
            let mut x = vec![C64::zero(); 6];
            x[0] = eps.scale(m * w2) + force;
            x[1] = eps.mul_i().scale(zg * m * w2) + tau.scale((a - cp) * w2) + force.mul_i().scale(z) + lt * t_cav;
            Lu::new(&d).unwrap().solve(&mut x);
            d.reset(0, 0);
            let found = at(&system, speed);
            for i in 0..3 {
                let (f, b) = found.circles(2 * i);
                let off = (f - x[i]).abs() + (b.conj() - x[i + 3]).abs();
                let size = f.abs() + b.abs();
                assert!(off < 1e-10 * size, "{word} {nu} {speed} {i}: {f:?} {:?} {b:?} {:?}", x[i], x[i + 3]);
            }
        }
    }
}

/// At the speed of the rotor the surface stays round the axis of rotation: whatever the fill, the flow and the viscosity, liquid in an eccentric cavity is an unbalance
/// of the full cavity; a frozen ring one of its own mass.
#[test]
fn an_eccentric_cavity_is_an_unbalance() {
    let bare = changed(FILE, &[("eccentricity = \"50 um\"\nskew = 2e-4\nskew_phase = \"60 deg\"", "polar_inertia_marker = 0")]);
    let bare = bare.replace("polar_inertia_marker = 0", "");
    let full = CAVITY.full_mass();
    // as a body turned a quarter: the file's unbalance acts at the reference point, so the cavity is put there
    let bare = changed(&bare, &[("at = \"40 mm\"", "at = \"0 mm\"")]);
    let ring = full * (1.0 - 0.49);
    let e = 2e-4;
    for (word, lines, fill, mass) in [
        ("planar", "", "105 mm", full),
        ("planar", "wave_damping = 3", "105 mm", full),
        ("planar", "", "0 mm", full),
        ("strip", "", "105 mm", full),
        ("strip", "viscosity = 1e-4", "105 mm", full),
        ("strip", "", "0 mm", full),
        ("spatial", "", "105 mm", full),
        ("spatial", "", "0 mm", full),
        ("spatial", "viscosity = 1e-4", "105 mm", full),
        ("spatial", "", "140 mm", full),
        ("planar_tilt", "", "105 mm", full),
        ("frozen", "", "105 mm", ring),
    ] {
        let text = changed(&model(&bare, word), &[("free_surface_radius = \"105 mm\"", &format!("free_surface_radius = \"{fill}\""))]);
        let text = with_liquid(&text, lines);
        let cavity = build(&with_liquid(&text, &format!("eccentricity = {e}\neccentricity_phase = 1.1")));
        let rotor = build(&changed(
            &text,
            &[("mass = \"40 kg\"", &format!("mass = \"40 kg\"\nunbalance = {:e}\neccentricity_phase = 1.1", mass * e))],
        ));
        for speed in [60.0, 333.0] {
            let (a, b) = (at(&cavity, speed), at(&rotor, speed));
            for i in 0..6 {
                let (a, b) = (a.x[i], b.x[i]);
                assert!((a - b).abs() < 1e-11 * b.abs(), "{word} {lines} {fill} {speed} {i}: {a:?} {b:?}");
            }
        }
    }
}

/// A skew cavity, frozen or full and turning as one body with the rotor, is a skew of that body's inertia.
#[test]
fn a_skew_ring_is_a_skew_rotor() {
    let ring = CAVITY.full_mass() * (1.0 - 0.49);
    let square = 0.25 * (0.15f64 * 0.15 + 0.105 * 0.105);
    let (a, cp) = (ring * (square + 0.0075), 2.0 * ring * square);
    let bare = changed(FILE, &[("at = \"40 mm\"", "at = \"0 mm\""), ("skew = 2e-4\n", "")]);
    let frozen = model(&bare, "frozen");
    let cavity = build(&changed(&with_liquid(&frozen, "skew = 1e-3\nskew_phase = 0.3"), &[("skew_phase = \"60 deg\"", "")]));
    // (A - C) of the rotor is 0.15
    let skew = format!("skew = {:e}\nskew_phase = 0.3 #", 1e-3 * (a - cp) / 0.15);
    let rotor = build(&changed(&frozen, &[("skew_phase = \"60 deg\"", &skew)]));
    for speed in [60.0, 333.0] {
        let (a, b) = (at(&cavity, speed), at(&rotor, speed));
        for i in 0..6 {
            assert!((a.x[i] - b.x[i]).abs() < 1e-11 * b.x[i].abs(), "{speed} {i}: {:?} {:?}", a.x[i], b.x[i]);
        }
    }
}

/// In time: with the states of the synchronous response the residual of the machine vanishes all the way round.
#[test]
fn in_time() {
    let lines = "eccentricity = 3e-4\neccentricity_phase = 0.7\nskew = 1e-3\nskew_phase = -0.4\nwave_damping = 2";
    for word in ["strip", "planar_tilt"] {
        let system = build(&with_liquid(&model(FILE, word), lines));
        let speed = 260.0;
        let found = at(&system, speed);
        let n = system.n();
        for turn in 0..7 {
            let angle = 0.9 * f64::from(turn);
            let real = |z: C64, power: usize| {
                let rates = [C64::one(), c(0.0, speed), c(-speed * speed, 0.0)];
                (z * rates[power] * C64::cis(angle)).re
            };
            let [q, v, a] = [0, 1, 2].map(|p| (0..n).map(|i| real(found.x[i], p)).collect::<Vec<f64>>());
            let (z, zdot): (Vec<f64>, Vec<f64>) = found.x[n..].iter().map(|&x| (real(x, 0), real(x, 1))).unzip();
            let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; z.len()], 0.0);
            let point = At { q: &q, v: &v, a: &a, z: &z, phase: angle, speed, spin_accel: 0.0, t: 0.0 };
            let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
            system.residual(system.params(), &point, &mut rows, &mut Workspace::default(), |_| true);
            let size = 21.2 * 3e-4 * speed * speed;
            assert!(force.iter().all(|f| f.abs() < 1e-10 * size), "{word} {force:?}");
            let moved = zdot.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            assert!(rate.iter().zip(&zdot).all(|(r, d)| (r - d).abs() < 1e-10 * moved), "{word} {rate:?} {zdot:?}");
        }
    }
}

/// What a horizontal rotor with a liquid in the frequency domain rests on is the weight of rotor and liquid, and of the same machine with a liquid in time.
#[test]
fn weight_of_a_liquid_without_time_form() {
    let text = changed(FILE, &[("speed = \"400 rad/s\"", "speed = \"400 rad/s\"\naxis = \"horizontal\"")]);
    let still = |word: &str, lines: &str| rest(&build(&with_liquid(&model(&text, word), lines)), 400.0).unwrap().q;
    let time = still("strip", "");
    let empty = rest(&build(&without(&text, &["water"])), 400.0).unwrap().q;
    assert!((time[1] / empty[1] - 1.0).abs() > 0.05, "{time:?} {empty:?}");
    for (word, lines) in [("spatial", "axial_harmonics = 5"), ("strip", "viscosity = 1e-4"), ("spatial", "viscosity = 1e-4")] {
        let q = still(word, lines);
        for i in [0, 1, 4, 5] {
            // the viscous liquid is not the same in tilt
            assert!((q[i] - time[i]).abs() < 2e-2 * time[1].abs() + 1e-9, "{word} {lines} {i}: {q:?} {time:?}");
        }
    }
}

#[test]
fn refusals() {
    let wrong =
        |text: &str| load(text).err().map(|d| d.0.iter().map(|d| format!("{} {d}\n", d.code)).collect::<String>()).unwrap_or_default();
    let text = with_liquid(&model(FILE, "planar"), "skew = 1e-3");
    assert!(wrong(&text).contains("planar knows no tilt of the cavity"), "{}", wrong(&text));
    // the k = 0 term takes more than the rotor has
    let light = changed(&model(FILE, "planar_tilt"), &[("diametral_inertia = \"0.70 kg m^2\"", "diametral_inertia = \"0.30 kg m^2\"")]);
    let tall = changed(&light, &[("cavity_height = \"300 mm\"", "cavity_height = \"600 mm\"")]);
    let reported = wrong(&tall);
    assert!(reported.contains("part.inertia") && reported.contains("no inertia is left for rotor.tilt_x"), "{reported}");
    assert!(wrong(&light).is_empty(), "{}", wrong(&light));
    // and of the values of a parameter
    let system = build(&light);
    assert!(system.with(&[("water.cavity_height", 0.6)]).is_err() && system.with(&[("water.cavity_height", 0.2)]).is_ok());
}
