//! Physics of the parts through an assembled machine: closed forms and the reference table of the liquid's transfer function.

use laval::model::blocks::{Blocks, Grid};
use laval::model::builder::Builder;
use laval::model::erased::{D1, Evaluate};
use laval::model::field::Attach;
use laval::model::linear::{Form, LinearModel, LinearScratch};
use laval::model::params::Family;
use laval::model::part::{At, DofKind, Link, Rows};
use laval::model::system::{System, Workspace};
use laval::parts::{damper::*, disc::*, liquid::*, shaft_lumped::*};
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};
use std::f64::consts::PI;

fn to_ground(body: &str) -> Link {
    Link::Between(Attach::on(body), Attach::ground())
}

/// Dynamic stiffness over coordinates and internal states at `s` and spin speed.
fn stiffness(system: &System, s: C64, speed: f64) -> Mat<C64> {
    let (mut model, mut scratch, mut z) = (LinearModel::default(), LinearScratch::default(), Grid::empty());
    system.linear(system.params(), speed, Form::Frequency, &mut model, &mut scratch);
    system.dynamic_stiffness(system.params(), &model, Form::Frequency, s, &mut z, &mut scratch);
    Mat::from_fn(z.rows(), z.cols(), |i, j| z[(i, j)])
}

/// Forward whirl B e^(st) of the pair at `first` under a forward force 1: B.
fn forward(system: &System, first: usize, s: C64, speed: f64) -> C64 {
    let z = stiffness(system, s, speed);
    let mut x = vec![C64::zero(); z.rows()];
    (x[first], x[first + 1]) = (c(1.0, 0.0), c(0.0, -1.0));
    Lu::new(&z).unwrap().solve(&mut x);
    assert!((x[first + 1] - x[first].mul_i().scale(-1.0)).abs() <= 1e-12 * x[first].abs(), "the response is not a forward circle");
    x[first]
}

/// The stiffness a forward whirl meets where nothing but the pair moves.
fn forward_stiffness(system: &System, first: usize, s: C64, speed: f64) -> C64 {
    let z = stiffness(system, s, speed);
    z[(first, first)] - z[(first, first + 1)].mul_i()
}

const MASS: f64 = 0.01;

fn drum_with_liquid(ratio: f64, damping: f64) -> (System, f64) {
    let p = LiquidParams { wave_damping: damping, ..LiquidParams::new(0.07, 0.06, 1000.0, 0.07 * ratio) };
    let fill = match ratio {
        0.0 => Fill::Full,
        1.0 => Fill::Empty,
        _ => Fill::Partial,
    };
    let system = Builder::new("drum")
        .part("drum", Disc::planar(), DiscParams::new(MASS))
        .part("liquid", Liquid::new(Attach::on("drum"), fill), p)
        .build()
        .unwrap();
    (system, PI * 0.07 * 0.07 * 0.06 * 1000.0)
}

/// G from the assembled machine: the drum and its liquid meet a whirl with -(m + mL G) w^2.
fn transfer(ratio: f64, damping: f64, speed: f64, w: f64) -> C64 {
    let (system, full) = drum_with_liquid(ratio, damping);
    let z = forward(&system, 0, c(0.0, w), speed).recip();
    (z.scale(-1.0 / (w * w)) - c(MASS, 0.0)).scale(1.0 / full)
}

fn closed_form(ratio: f64, delta: f64, speed: f64, w: f64) -> C64 {
    let sig = w - speed;
    let g = (1.0 - ratio * ratio) / (1.0 + ratio * ratio);
    let slow = 2.0 * sig * speed + speed * speed;
    let loss = c(0.0, -2.0 * delta * sig);
    (c(sig * sig - slow, 0.0) + loss).scale(g) / (c(sig * sig - g * slow, 0.0) + loss)
}

#[test]
fn liquid_transfer_agrees_with_the_reference_table() {
    let text = include_str!("../reference/planar/liquid_transfer.csv");
    let mut rows = 0;
    for line in text.lines().filter(|l| l.starts_with(|c: char| c.is_ascii_digit())) {
        let v: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        let g = transfer(v[0], v[3], v[1], v[2]);
        let reference = c(v[4], v[5]);
        // the table has 12 printed digits
        assert!((g - reference).abs() <= 5e-12 * reference.abs() + 1e-12, "{line}: {g:?}");
        rows += 1;
    }
    assert!(rows > 200);
}

#[test]
fn liquid_transfer_agrees_with_its_closed_form() {
    for ratio in [0.99, 0.8, 0.5, 0.1] {
        for delta in [0.0, 3.0, 400.0] {
            for (speed, w) in [(500.0, 900.0), (3000.0, 1966.0), (3000.0, -400.0), (200.0, 2500.0), (200.0, 1.0)] {
                let (g, exact) = (transfer(ratio, delta, speed, w), closed_form(ratio, delta, speed, w));
                // m and mL G share w^2: the small G of a thin layer is left with the rounding of the drum's mass
                assert!((g - exact).abs() <= 1e-12 * (exact.abs() + MASS), "{ratio} {delta} {speed} {w}: {g:?} {exact:?}");
            }
        }
    }
}

#[test]
fn limits_of_the_liquid() {
    let one = c(1.0, 0.0);
    for ratio in [0.97, 0.8, 0.667, 0.3] {
        for delta in [0.0, 20.0] {
            // synchronous whirl: the full cavity's mass for any fill and damping
            assert!((transfer(ratio, delta, 700.0, 700.0) - one).abs() < 1e-12);
        }
        // no spin: added mass mL/gamma
        let g = (1.0 - ratio * ratio) / (1.0 + ratio * ratio);
        assert!((transfer(ratio, 0.0, 0.0, 300.0) - c(g, 0.0)).abs() < 1e-12);
    }
    for (speed, w) in [(700.0, 300.0), (700.0, -900.0), (0.0, 300.0), (700.0, 700.0)] {
        assert!((transfer(0.0, 0.0, speed, w) - one).abs() < 1e-12); // full: frozen
        assert!(transfer(1.0, 0.0, speed, w).abs() < 1e-15 / 0.07); // empty: nothing, at synchronous whirl too
    }
    // a thin layer still weighs the full cavity at synchronous whirl, and nothing elsewhere
    assert!((transfer(0.9999, 0.0, 700.0, 700.0) - one).abs() < 1e-9 && transfer(0.9999, 0.0, 700.0, 400.0).abs() < 1e-3);
}

/// Undamped free-surface waves with the drum held: w/W = 1 + (1 +- sqrt(1 + gamma))/gamma.
#[test]
fn waves_of_the_free_surface() {
    for ratio in [0.9, 0.667, 0.3, 1e-4] {
        let (system, _) = drum_with_liquid(ratio, 0.0);
        let gamma = (1.0 + ratio * ratio) / (1.0 - ratio * ratio);
        for sign in [1.0, -1.0] {
            let w = 700.0 * (1.0 + (1.0 + sign * (1.0 + gamma).sqrt()) / gamma);
            let det = |w: f64| {
                let z = stiffness(&system, c(0.0, w), 700.0);
                Lu::new(&Mat::from_fn(4, 4, |i, j| z[(2 + i, 2 + j)])).map_or(0.0, |lu| lu.det().abs())
            };
            assert!(det(w) < 1e-10 * det(1.01 * w), "{ratio} {w}");
        }
    }
    // the limit gamma = 1 has the printed 2 +- sqrt 2
    let limit = |sign: f64| 1.0 + (1.0 + sign * 2f64.sqrt());
    assert!((limit(1.0) - (2.0 + 2f64.sqrt())).abs() < 1e-15 && (limit(-1.0) - (2.0 - 2f64.sqrt())).abs() < 1e-15);
}

/// F = -ml z'' + mo eta'' at any state, speed and spin acceleration: what the liquid does to the wall is its momentum.
#[test]
fn liquid_keeps_its_momentum_at_varying_speed() {
    for ratio in [0.95, 0.667, 0.2] {
        let liquid = Liquid::new(Attach::on("drum"), Fill::Partial);
        let p = LiquidParams { wave_damping: 0.0, ..LiquidParams::new(0.07, 0.06, 1000.0, 0.07 * ratio) };
        let p: Vec<D1> = LiquidFamily::to_vec(&p).into_iter().map(D1::lift).collect();
        let full = PI * 0.07 * 0.07 * 0.06 * 1000.0;
        let (outer, real) = (full * ratio * ratio, full * (1.0 - ratio * ratio));
        for (speed, accel) in [(300.0, 0.0), (300.0, 5e4), (-120.0, -3e4), (0.0, 1e5)] {
            let (a, v, z) = ([130.0, -70.0], [0.4, 0.9], [0.31, -0.12, 2e-3, -7e-4]);
            let evaluate = |zdot: [f64; 4]| {
                let seed = |x: f64, d: f64| D1 { re: x, eps: [d] };
                let zs: Vec<D1> = z.iter().zip(zdot).map(|(&z, d)| seed(z, d)).collect();
                let (q, v, a) = ([seed(1e-3, v[0]), seed(-2e-3, v[1])], [seed(v[0], a[0]), seed(v[1], a[1])], a.map(|a| seed(a, 7e5)));
                let at = At {
                    q: &q,
                    v: &v,
                    a: &a,
                    z: &zs,
                    phase: seed(0.3, speed),
                    speed: seed(speed, accel),
                    spin_accel: seed(accel, 2e6),
                    t: seed(0.0, 1.0),
                };
                let (mut force, mut rate, mut spin) = ([D1::lift(0.0); 2], [D1::lift(0.0); 4], D1::lift(0.0));
                let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
                D1::residual(&liquid, &p, &at, &mut rows, &mut Blocks::default());
                (force.map(|f| -f.re), rate)
            };
            let first = evaluate([0.0; 4]).1.map(|r| r.re);
            let (force, rate) = evaluate(first);
            for i in 0..2 {
                let expected = -real * a[i] + outer * rate[2 + i].eps[0];
                let size = full * a[i].abs() + outer * rate[2 + i].eps[0].abs() + force[i].abs();
                assert!((force[i] - expected).abs() <= 1e-12 * size, "{ratio} {speed} {accel}: {} {expected}", force[i]);
            }
        }
    }
}

/// Turning steadily with the whirl, the surface stays centred on the axis of spin: beta = 0, eta = -z.
#[test]
fn synchronous_surface_is_centred_on_the_spin_axis() {
    let (system, full) = drum_with_liquid(0.667, 20.0);
    let (w, z) = (900.0, c(4e-4, -3e-4));
    let (v, a) = (z.mul_i().scale(w), z.scale(-w * w));
    let eta = [0.0, 0.0, -z.re, -z.im];
    let at = At { q: &[z.re, z.im], v: &[v.re, v.im], a: &[a.re, a.im], z: &eta, phase: 0.0, speed: w, spin_accel: 0.0, t: 0.0 };
    let (mut force, mut rate, mut spin) = ([0.0; 2], [0.0; 4], 0.0);
    let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
    system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |_| true);
    let expected = [0.0, 0.0, -v.re, -v.im];
    assert!(rate.iter().zip(expected).all(|(r, e)| (r - e).abs() < 1e-12), "{rate:?}");
    let liquid = -(MASS + full) * w * w;
    assert!((force[0] - liquid * z.re).abs() < 1e-12 * force[0].abs() && (force[1] - liquid * z.im).abs() < 1e-12 * force[1].abs());
}

fn tilting(speed_dependent: DiscParams, tilt_stiffness: f64) -> System {
    let p = ShaftLumpedParams { stiffness: [1e5; 2], tilt_stiffness, ..ShaftLumpedParams::new() };
    Builder::new("top")
        .part("disc", Disc::tilting(), speed_dependent)
        .part("shaft", ShaftLumped::with_tilt(to_ground("disc")), p)
        .build()
        .unwrap()
}

/// A theta'' - i C W theta' + kt theta = 0: w = [C W +- sqrt(C^2 W^2 + 4 A kt)]/(2 A), the forward one rising with speed.
#[test]
fn gyroscopic_split() {
    let (a, cp, kt) = (0.013, 0.021, 800.0);
    let system = tilting(DiscParams { polar_inertia: cp, diametral_inertia: a, ..DiscParams::new(2.0) }, kt);
    for speed in [0.0, 200.0, 900.0] {
        let root = ((cp * speed).powi(2) + 4.0 * a * kt).sqrt();
        for w in [(cp * speed + root) / (2.0 * a), (cp * speed - root) / (2.0 * a)] {
            let z = forward_stiffness(&system, 2, c(0.0, w), speed);
            assert!(z.abs() < 1e-12 * (kt + a * w * w), "{speed} {w} {z:?}");
        }
    }
}

/// A skewed disc turning steadily: (kt - (A - C) W^2) theta = (A - C) W^2 tau, and the spin row needs no torque.
#[test]
fn skewed_disc_turns_steadily() {
    let (a, cp, kt, tau, w, phase, at_angle) = (0.013, 0.021, 800.0, 0.01, 150.0, 0.8, 0.5);
    let p = DiscParams { polar_inertia: cp, diametral_inertia: a, skew: tau, skew_phase: at_angle, ..DiscParams::new(2.0) };
    let system = tilting(p, kt);
    let theta = C64::cis(phase + at_angle).scale((a - cp) * w * w * tau / (kt - (a - cp) * w * w));
    let (rate, accel) = (theta.mul_i().scale(w), theta.scale(-w * w));
    let q = [0.0, 0.0, theta.re, theta.im];
    let (v, acc) = ([0.0, 0.0, rate.re, rate.im], [0.0, 0.0, accel.re, accel.im]);
    let at = At { q: &q, v: &v, a: &acc, z: &[], phase, speed: w, spin_accel: 0.0, t: 0.0 };
    let (mut force, mut spin) = ([0.0; 4], 0.0);
    let mut rows = Rows { force: &mut force, rate: &mut [], spin: &mut spin };
    system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |_| true);
    let size = kt * theta.abs();
    assert!(force.iter().all(|f| f.abs() < 1e-13 * size) && spin.abs() < 1e-13 * size, "{force:?} {spin}");
}

/// A mass centre at height h: unbalance also tilts; static moment of the force at h, through the coupled mass matrix.
#[test]
fn offset_centre_of_mass_couples_translation_and_tilt() {
    let (m, h, a, cp, w) = (2.0, 0.06, 0.013, 0.021, 150.0);
    let p = DiscParams { polar_inertia: cp, diametral_inertia: a, centre_of_mass: h, eccentricity: 1e-4, ..DiscParams::new(m) };
    let z = stiffness(&tilting(p, 800.0), c(0.0, w), 0.0);
    // kinetic energy m |z + h (beta - i alpha)|^2/2 + A |theta|^2/2
    assert!((z[(0, 3)] - c(-m * h * w * w, 0.0)).abs() < 1e-9 && (z[(1, 2)] - c(m * h * w * w, 0.0)).abs() < 1e-9);
    assert!((z[(2, 2)] - c(800.0 - (a + m * h * h) * w * w, 0.0)).abs() < 1e-9);
}

/// Onset of whirl from damping in rotor axes: W* = w0 (1 + ce/ci), forward only; as a damper and as the material of the shaft.
#[test]
fn rotating_damping_destabilises_forward_whirl_above_its_onset() {
    let (m, k, ce, ci) = (2.4, 1e6, 30.0, 12.0);
    let w0 = f64::sqrt(k / m);
    let onset = w0 * (1.0 + ce / ci);
    let base = || {
        Builder::new("rotor").part("disc", Disc::planar(), DiscParams::new(m)).part(
            "air",
            Damper::fixed(to_ground("disc")),
            DamperParams { damping: [ce; 2], tilt_damping: 0.0 },
        )
    };
    let shaft = |b: f64| ShaftLumpedParams { stiffness: [k; 2], material_damping: b, ..ShaftLumpedParams::new() };
    let with_damper = base()
        .part("shaft", ShaftLumped::lateral(to_ground("disc")), shaft(0.0))
        .part("inner", Damper::rotating(to_ground("disc")), DamperParams { damping: [ci; 2], tilt_damping: 0.0 })
        .build()
        .unwrap();
    let with_material = base().part("shaft", ShaftLumped::lateral(to_ground("disc")).damped(), shaft(ci / k)).build().unwrap();
    for system in [with_damper, with_material] {
        let loss = |w: f64, speed: f64| forward_stiffness(&system, 0, c(0.0, w), speed).im;
        assert!(loss(w0, onset).abs() < 1e-10 * ce * w0);
        assert!(loss(w0, 0.99 * onset) > 0.0 && loss(w0, 1.01 * onset) < 0.0);
        // backward whirl (w < 0) is damped at any speed: the loss has the sign of w
        assert!(loss(-w0, 1.01 * onset) < 0.0 && loss(-w0, 5.0 * onset) < 0.0);
    }
}

/// What a part shows is what it puts on the machine at the same state: force on its point, moment, torque on
/// the spin. A foundation at constant velocity shows the force on the ground, a motor without inertia and
/// drag its torque and the power of it.
#[test]
fn what_parts_show_is_what_they_do() {
    let between = "between = [\"disc\", \"ground\"]";
    let parts = format!(
        "kind = \"foundation\"\nname = \"base\"\nmass = 3\nstiffness = {{ x = 2e5, y = 3e5 }}\ndamping = {{ x = 20, y = 30 }}\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\n{between}\ndamping = {{ x = 50, y = 80 }}\ntilt_damping = 0.3\n\
         [[part]]\nkind = \"damper\"\nname = \"fit\"\n{between}\ndamping = 60\ntilt_damping = 0.2\naxes = \"rotating\"\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"film\"\n{between}\nkxx = 1e5\nkxy = 2e4\nkyx = -3e4\nkyy = 2e5\ncxx = 100\ncxy = 7\ncyx = 9\ncyy = 200\n\
         [[part]]\nkind = \"bearing_cubic\"\nname = \"rubber\"\n{between}\nlaw = \"per_axis\"\nstiffness = {{ x = 1e5, y = 2e5 }}\ncubic_stiffness = 1e12\n\
         [[part]]\nkind = \"bearing_hertz\"\nname = \"roller\"\n{between}\ncoefficient = 1e9\nlaw = \"per_axis\"\nclearance = \"-20 um\"\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\n{between}\nstiffness = 1e6\ntilt_stiffness = 500\ncoupling = 4e3\nmaterial_damping = 1e-4\n\
         [[part]]\nkind = \"shaft_span\"\nname = \"span\"\n{between}\nbelow = 0.25\nabove = 0.35\ndiameter = 0.02\nlower_support = 2e7\nupper_support = 1e7\nmodulus = 2e11\n\
         [[part]]\nkind = \"stop\"\nname = \"ring\"\n{between}\nstiffness = 1e6\ngap = \"50 um\"\ndamping = 30\n\
         [[part]]\nkind = \"spin_load\"\nname = \"fan\"\ndrag = 2e-3\nwindage = 4e-6\n\
         [[part]]\nkind = \"motor\"\nname = \"motor\"\ntorque = 3\ncurve = \"linear\"\nsynchronous_speed = 800\n"
    );
    let disc = "kind = \"disc\"\nname = \"disc\"\nmass = 2\ndiametral_inertia = 0.01\npolar_inertia = 0.02\n";
    let system = crate::common::files::load(&format!("[machine]\n[[part]]\n{disc}[[part]]\n{parts}")).system;
    let (n, m) = (system.n(), system.m());
    let q: Vec<f64> = (0..n).map(|i| [7e-5, -4e-5, 3e-4, 5e-4][i % 4]).collect();
    let v: Vec<f64> = (0..n).map(|i| [0.02, 0.03, 0.5, -0.2][i % 4]).collect();
    let (zero, z, speed) = (vec![0.0; n], vec![0.0; m], 300.0);
    let at = At { q: &q, v: &v, a: &zero, z: &z, phase: 0.4, speed, spin_accel: 0.0, t: 0.0 };
    let mut ws = Workspace::default();
    let does = |name: &str| {
        let (mut force, mut rate, mut spin) = (vec![0.0; n], vec![0.0; m], 0.0);
        let mut rows = Rows { force: &mut force, rate: &mut rate, spin: &mut spin };
        system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |s| s.name == name);
        (force, spin)
    };
    let (mut seen, mut wrong) = (Vec::new(), Vec::new());
    for (slot, shown) in system.observe(&at, &mut ws) {
        let name = system.slots()[slot].name.as_str();
        let (force, spin) = does(name);
        let pair = |kind: DofKind| {
            let own = |i: &usize| system.coordinates()[*i].dof.kind == kind && (force[*i] != 0.0 || force[i + 1] != 0.0);
            (0..n).find(own).map_or(0.0, |i| force[i].hypot(force[i + 1]))
        };
        let want = match (shown.name, name) {
            ("force" | "ground force", _) => pair(DofKind::VectorX),
            ("moment", _) => pair(DofKind::TiltX),
            ("torque", "motor") => -spin,
            ("power", _) => -spin * speed,
            ("torque", _) => spin,
            _ => continue,
        };
        seen.push(format!("{name} {}", shown.name));
        if !(want.abs() > 1e-3 && (shown.value - want).abs() < 1e-12 * want.abs()) {
            wrong.push(format!("{name}: {} {} is {want}", shown.name, shown.value));
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
    assert_eq!(seen.len(), 16, "{seen:?}");
}

/// The surface of a spatial liquid is in no state: its excursion in a whirl with the speed and against it is
/// that of plane flow, whose states follow from its own equations.
#[test]
fn the_hidden_surface_moves_as_in_plane_flow() {
    let file = |disc: &str, liquid: &str| {
        format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\n{disc}[[part]]\nkind = \"liquid\"\nin = \"d\"\ncavity_radius = 0.07\n\
             cavity_height = 0.06\ndensity = 1000\nfill = {{ free_surface_radius = 0.0467 }}\n{liquid}"
        )
    };
    let system = |text: &str| crate::common::files::load(text).system;
    let plane = system(&file("", "wave_damping = 0\n"));
    let spatial = system(&file("diametral_inertia = 0.01\npolar_inertia = 0.02\n", "model = \"spatial\"\n"));
    let (speed, layer, far) = (300.0, 0.07 - 0.0467, 1e-4);
    let mut shares = Vec::new();
    for sense in [-1.0, 1.0] {
        // x = 1, y = -i with the speed and i against it
        let y = c(0.0, sense);
        let z = stiffness(&plane, c(0.0, speed), speed);
        assert_eq!((plane.n(), z.rows()), (2, 6));
        let mut states: Vec<C64> = (2..6).map(|i| -(z[(i, 0)] + z[(i, 1)] * y)).collect();
        Lu::new(&Mat::from_fn(4, 4, |i, j| z[(2 + i, 2 + j)])).unwrap().solve(&mut states);
        let (forward, backward) = ((states[2] + states[3].mul_i()).scale(0.5).abs(), (states[2] - states[3].mul_i()).scale(0.5).abs());
        let want = forward + backward;
        let (mut q, mut v) = (vec![0.0; 4], vec![0.0; 4]);
        (q[0], v[1]) = (far, -sense * far * speed);
        let states = vec![0.0; spatial.m()];
        let at = At { q: &q, v: &v, a: &[0.0; 4], z: &states, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let found: Vec<f64> = spatial
            .validity(&at, &mut Workspace::default())
            .into_iter()
            .filter(|u| u.1.what.contains("excursion"))
            .map(|u| u.1.ratio)
            .collect();
        assert!(found.len() == 1 && (found[0] * layer / far - want).abs() < 1e-9, "{sense}: {found:?} {want}");
        shares.push(want);
    }
    assert!((shares[0] - 1.0).abs() < 1e-9 && shares[1] < 0.2, "{shares:?}");
}

/// Outside its gap a stop pushes along the deflection with `k u + c u'`, never pulls, and does nothing
/// inside.
#[test]
fn a_stop_pushes_with_spring_and_damper() {
    let (k, c, gap) = (1e6, 300.0, 5e-5);
    let text = format!(
        "[machine]\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 2\n\
         [[part]]\nkind = \"stop\"\nname = \"ring\"\nbetween = [\"d\", \"ground\"]\nstiffness = {k}\ngap = {gap}\ndamping = {c}\n"
    );
    let system = crate::common::files::load(&text).system;
    for (q, v) in [([6e-5, -8e-5], [0.1, 0.2]), ([6e-5, -8e-5], [-0.03, 0.02]), ([6e-5, -8e-5], [-3.0, 4.0]), ([2e-5, 3e-5], [1.0, 1.0])] {
        let at = At { q: &q, v: &v, a: &[0.0; 2], z: &[], phase: 0.0, speed: 100.0, spin_accel: 0.0, t: 0.0 };
        let (mut force, mut spin) = ([0.0; 2], 0.0);
        let mut rows = Rows { force: &mut force, rate: &mut [], spin: &mut spin };
        system.residual(system.params(), &at, &mut rows, &mut Workspace::default(), |s| s.name == "ring");
        let r: f64 = f64::hypot(q[0], q[1]);
        let rate = (q[0] * v[0] + q[1] * v[1]) / r;
        let want = if r > gap { (k * (r - gap) + c * rate).max(0.0) } else { 0.0 };
        for i in 0..2 {
            assert!((force[i] - want * q[i] / r).abs() < 1e-12 * k * r, "{q:?} {v:?}: {force:?} {want}");
        }
    }
}
