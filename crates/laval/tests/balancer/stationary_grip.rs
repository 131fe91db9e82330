//! States that dry friction widens to ranges, and states with balls that touch: against closed forms, and against motions in time.

use laval::file::load;
use laval::outcome::{Data, End, Outcome};
use laval::study::Context;
use laval_num::complex::{C64, c};

const MASS: f64 = 0.05;
const UNBALANCE: f64 = 0.01;
const DRAG: f64 = 0.02;

fn machine(speed: f64, balls: usize, ring: &str, study: &str) -> String {
    format!(
        "[machine]\nname = \"planar\"\nspeed = {speed}\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 1\neccentricity = {UNBALANCE}\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = {DRAG}\n\
         [[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"disc\"\nballs = {balls}\nbody_tilt = false\ngravity = 0\nball_mass = {MASS}\n\
         track_radius = 1\ndrag = 0.0005\n{ring}\n[[study]]\n{study}\n"
    )
}

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}\n{text}"));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("t")).unwrap_or_else(|d| panic!("{d}"));
    assert_eq!(o.end, End::Reached);
    o
}

fn stationary(from: f64, to: f64) -> String {
    format!("kind = \"stationary\"\nspeed = {{ from = {from}, to = {to}, points = 3 }}")
}

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    match &o.find_table(table).unwrap_or_else(|| panic!("no {table}")).column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v.clone(),
        Data::Int(v) => v.iter().map(|x| *x as f64).collect(),
        Data::Flag(v) => v.iter().map(|x| f64::from(u8::from(*x))).collect(),
        Data::Text(_) => panic!("{name} is text"),
    }
}

fn words(o: &Outcome, table: &str, name: &str) -> Vec<String> {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Text(v) => v.clone(),
        _ => panic!("{name} is no text"),
    }
}

/// k/W^2 - M + i c/W.
fn stiffness(speed: f64, balls: usize) -> C64 {
    c(1.0 / (speed * speed) - 1.0 - MASS * balls as f64, DRAG / speed)
}

/// Displacement in turning axes with balls held at these angles, and the torque that holds each.
fn held(speed: f64, angles: &[f64]) -> (C64, Vec<f64>) {
    let moment = angles.iter().fold(c(UNBALANCE, 0.0), |u, a| u + C64::cis(*a).scale(MASS));
    let zeta = moment / stiffness(speed, angles.len());
    let torque = |a: &f64| MASS * speed * speed * (zeta.conj() * C64::cis(*a).mul_i()).re;
    (zeta, angles.iter().map(torque).collect())
}

/// One ball: the torque that holds it is -(m r W^2/|D|) (m_r s sin(phi + a) + m r sin a), D = |D| e^{ia}.
#[test]
fn a_ball_stays_where_the_track_pulls_less_than_friction_holds() {
    let friction = 1e-3;
    let o = run(&machine(2.0, 1, &format!("dry_torque = {friction}"), &stationary(1.9, 2.1)));
    let (from, to, speeds) = (column(&o, "dead_zone", "from"), column(&o, "dead_zone", "to"), column(&o, "dead_zone", "speed"));
    let (rests, torque) = (column(&o, "dead_zone", "angle"), column(&o, "dead_zone", "friction"));
    let (growth, left) = (column(&o, "dead_zone", "growth_held"), column(&o, "dead_zone", "unbalance"));
    assert_eq!(from.len(), 6, "two states at each of three speeds");
    assert!(column(&o, "dead_zone", "closed").iter().all(|x| *x == 1.0) && torque.iter().all(|t| *t == friction));
    for k in 0..from.len() {
        let w = speeds[k];
        let d = stiffness(w, 1);
        let (size, a) = (d.abs(), d.arg());
        // the closed form: the sine of both ends
        let pull = MASS * w * w / size;
        let end = |s: f64| ((s * friction / pull - MASS * a.sin()) / UNBALANCE).asin();
        let (low, high) = (end(-1.0), end(1.0));
        let turn = |x: f64| x.sin().atan2(x.cos());
        let first = (rests[k] + a).cos() > 0.0;
        let (low, high) = if first { (low - a, high - a) } else { (std::f64::consts::PI - high - a, std::f64::consts::PI - low - a) };
        assert!(turn(from[k] - low).abs() < 1e-9 && turn(to[k] - high).abs() < 1e-9, "{w}: {} {low}, {} {high}", from[k], to[k]);
        assert!(from[k] < rests[k] && rests[k] < to[k]);
        // at the ends friction is used up, between them it is not
        for angle in [from[k], to[k]] {
            assert!((held(w, &[angle]).1[0].abs() / friction - 1.0).abs() < 1e-9);
        }
        assert!(held(w, &[0.7 * from[k] + 0.3 * to[k]]).1[0].abs() < 0.9 * friction);
        // with the ball held the rotor is an oscillator of mass 1.05
        assert!((growth[k] + DRAG / (2.0 * (1.0 + MASS))).abs() < 1e-9, "{}", growth[k]);
        let most = [from[k], to[k], rests[k]].map(|a| (c(UNBALANCE, 0.0) + C64::cis(a).scale(MASS)).abs()).into_iter().fold(0.0, f64::max);
        assert!((left[k] - most).abs() < 1e-9 * most);
    }
    // rolling resistance holds in proportion to the centrifugal load
    let o = run(&machine(2.0, 1, "rolling_resistance = 4e-3", &stationary(1.9, 2.1)));
    let (torque, speeds, ends) = (column(&o, "dead_zone", "friction"), column(&o, "dead_zone", "speed"), column(&o, "dead_zone", "to"));
    assert_eq!(torque.len(), 6);
    for k in 0..torque.len() {
        assert!((torque[k] - 4e-3 * MASS * speeds[k] * speeds[k]).abs() < 1e-15);
        assert!((held(speeds[k], &[ends[k]]).1[0].abs() / torque[k] - 1.0).abs() < 1e-9);
    }
    // friction above the largest pull holds the ball anywhere
    let o = run(&machine(2.0, 1, "dry_torque = 3e-3", &stationary(1.9, 2.1)));
    assert!(column(&o, "dead_zone", "closed").iter().all(|x| *x == 0.0));
    // and without dry friction nothing is held
    assert!(run(&machine(2.0, 1, "", &stationary(1.9, 2.1))).find_table("dead_zone").is_none());
}

/// Two balls that balance: at every corner friction is used up on both, and the report names what is left.
#[test]
fn two_balls_balance_as_well_as_friction_lets_them() {
    let friction = 2e-5;
    let o = run(&machine(3.0, 2, &format!("dry_torque = {friction}"), &stationary(2.9, 3.1)));
    let finding = o.findings.iter().find(|f| f.id == "dead_zone").expect("a finding");
    let kinds = words(&o, "dead_zone", "kind");
    let (from, to, speeds) = (column(&o, "dead_zone", "from"), column(&o, "dead_zone", "to"), column(&o, "dead_zone", "speed"));
    let k = (0..kinds.len()).find(|&k| kinds[k] == "balanced" && speeds[k] == 3.0).expect("a balanced state");
    assert!(kinds[k + 1] == "balanced" && from[k] < to[k]);
    // the corners of the range: among all pairs of angles at which friction is just used up on both, the extremes are those of the table
    let rest: [f64; 2] = [k, k + 1].map(|i| column(&o, "dead_zone", "angle")[i]);
    let mut extremes = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let mut most = 0.0f64;
    for signs in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
        let mut x = rest;
        for _ in 0..50 {
            let f = |x: [f64; 2]| {
                let t = held(3.0, &x).1;
                [t[0] - signs[0] * friction, t[1] - signs[1] * friction]
            };
            let (r, h) = (f(x), 1e-6);
            let (a, b) = (f([x[0] + h, x[1]]), f([x[0], x[1] + h]));
            let (p, q, u, v) = ((a[0] - r[0]) / h, (b[0] - r[0]) / h, (a[1] - r[1]) / h, (b[1] - r[1]) / h);
            let det = p * v - q * u;
            x = [x[0] - (v * r[0] - q * r[1]) / det, x[1] - (p * r[1] - u * r[0]) / det];
        }
        for i in 0..2 {
            extremes[i] = [extremes[i][0].min(x[i]), extremes[i][1].max(x[i])];
        }
        most = most.max((c(UNBALANCE, 0.0) + C64::cis(x[0]).scale(MASS) + C64::cis(x[1]).scale(MASS)).abs());
    }
    for i in 0..2 {
        assert!((from[k + i] - extremes[i][0]).abs() < 1e-7 && (to[k + i] - extremes[i][1]).abs() < 1e-7, "{extremes:?} {from:?} {to:?}");
    }
    assert!((finding.value.unwrap() / most - 1.0).abs() < 1e-6, "{} {most}", finding.sentence());
}

/// In time: inside the range the ball creeps only, from outside it moves in.
#[test]
fn motions_agree_with_the_range() {
    let (w, friction) = (2.0, 1e-3);
    let o = run(&machine(w, 1, &format!("dry_torque = {friction}"), &stationary(1.9, 2.1)));
    let speeds = column(&o, "dead_zone", "speed");
    let state = column(&o, "dead_zone", "state");
    let stable = column(&o, "states", "stable");
    let k = (0..speeds.len()).find(|&k| speeds[k] == w && stable[state[k] as usize - 1] == 1.0).expect("a stable state");
    let (from, to) = (column(&o, "dead_zone", "from")[k], column(&o, "dead_zone", "to")[k]);
    let end = |angle: f64| {
        let z = held(w, &[angle]).0;
        let v = z.mul_i().scale(w);
        let study = format!(
            "kind = \"transient\"\nduration = 30\nrelative_tolerance = 1e-8\n\
             initial = {{ \"disc.x\" = {:e}, \"disc.y\" = {:e}, \"disc.x'\" = {:e}, \"disc.y'\" = {:e}, \"ring.ball_1\" = {angle:.12} }}",
            z.re, z.im, v.re, v.im
        );
        let o = run(&machine(w, 1, &format!("dry_torque = {friction}\nfriction_rate = 1e-4"), &study));
        *column(&o, "motion", "ring.ball_1").last().unwrap()
    };
    let width = to - from;
    for share in [0.05, 0.5, 0.95] {
        let angle = from + share * width;
        assert!((end(angle) - angle).abs() < 0.02 * width, "{share}: {} {angle}", end(angle));
    }
    for (angle, edge) in [(to + 0.3 * width, to), (from - 0.3 * width, from)] {
        let reached = end(angle);
        assert!((reached - angle) * (edge - angle) > 0.0 && (reached - angle).abs() > 0.25 * width, "{angle} {edge} {reached}");
    }
}

/// Below the critical speed balls gather on the heavy side until they touch: k d^{3/2} is the torque that pulls them together.
#[test]
fn balls_that_touch_are_a_state_of_their_own() {
    let (k, radius) = (0.5, 0.1f64);
    let ring = format!("ball_radius = {radius}\ncontact_stiffness = {k}");
    let o = run(&machine(0.5, 2, &ring, &stationary(0.4, 0.6)));
    let (kinds, speeds, contact) = (words(&o, "states", "kind"), column(&o, "states", "speed"), column(&o, "states", "contact"));
    let (first, second) = (column(&o, "states", "ring.ball_1"), column(&o, "states", "ring.ball_2"));
    let (stable, displaced) = (column(&o, "states", "stable"), column(&o, "states", "disc radius"));
    let touching: Vec<usize> = (0..kinds.len()).filter(|&i| kinds[i] == "touching").collect();
    assert!(speeds.iter().all(|w| touching.iter().any(|&i| speeds[i] == *w && stable[i] == 1.0)), "{kinds:?} {stable:?}");
    assert!(!kinds.iter().any(|k| k == "together"));
    for &i in &touching {
        let (zeta, torque) = held(speeds[i], &[first[i], second[i]]);
        let apart = (second[i] - first[i]).sin().atan2((second[i] - first[i]).cos()).abs();
        let pushes = k * (2.0 * radius.asin() - apart).powf(1.5);
        assert!(pushes > 0.0 && (pushes - torque[0].abs()).abs() < 1e-9 * pushes && (torque[0] + torque[1]).abs() < 1e-9 * pushes);
        assert!((contact[i] - pushes).abs() < 1e-9 * pushes && (displaced[i] - zeta.abs()).abs() < 1e-9 * zeta.abs());
    }
    // it is a branch: touching at every point, over all speeds
    let (branch, kind) = (column(&o, "branches", "branch"), words(&o, "branches", "kind"));
    let own: Vec<usize> = (0..kind.len()).filter(|&i| kind[i] == "touching").collect();
    let speed = column(&o, "branches", "speed");
    assert!(own.iter().any(|&i| speed[i] <= 0.4 + 1e-9 && own.iter().any(|&j| branch[j] == branch[i] && speed[j] >= 0.6 - 1e-9)));
    // where they lie apart nothing pushes
    for i in (0..kinds.len()).filter(|&i| kinds[i] == "opposed") {
        assert_eq!(contact[i], 0.0);
    }
}

/// Of three balls that touch in a row the outer contacts carry what pulls the outer balls inwards.
#[test]
fn three_balls_touch_in_a_row() {
    let (k, radius) = (0.5, 0.05f64);
    let ring = format!("ball_radius = {radius}\ncontact_stiffness = {k}");
    let o = run(&machine(0.5, 3, &ring, &stationary(0.4, 0.6)));
    let (kinds, speeds, contact) = (words(&o, "states", "kind"), column(&o, "states", "speed"), column(&o, "states", "contact"));
    let angles: Vec<Vec<f64>> = (1..=3).map(|i| column(&o, "states", &format!("ring.ball_{i}"))).collect();
    let (stable, displaced) = (column(&o, "states", "stable"), column(&o, "states", "disc radius"));
    let mut rows = 0;
    for i in (0..kinds.len()).filter(|&i| kinds[i] == "touching") {
        let mut balls = [angles[0][i], angles[1][i], angles[2][i]];
        let (zeta, torque) = held(speeds[i], &balls);
        // what each ball is pushed by the others must carry its torque; all together they carry nothing
        let push = |a: f64, b: f64| {
            let apart = (b - a).sin().atan2((b - a).cos());
            let overlap = 2.0 * radius.asin() - apart.abs();
            if overlap > 0.0 { k * overlap.powf(1.5) * apart.signum() } else { 0.0 }
        };
        let mut most = 0.0f64;
        for a in 0..3 {
            let from: Vec<f64> = (0..3).filter(|b| *b != a).map(|b| push(balls[a], balls[b])).collect();
            // pushed back by a ball ahead, forth by one behind; torque is what the track must be given
            let pushed: f64 = from.iter().sum();
            assert!((pushed.abs() - torque[a].abs()).abs() < 1e-9 * contact[i], "{pushed} {}", torque[a]);
            most = from.iter().fold(most, |m, f| m.max(f.abs()));
        }
        assert!(torque.iter().sum::<f64>().abs() < 1e-9 * most);
        assert!((contact[i] - most).abs() < 1e-9 * most && (displaced[i] - zeta.abs()).abs() < 1e-9 * zeta.abs());
        balls.sort_by(f64::total_cmp);
        rows += usize::from(stable[i] == 1.0 && balls[2] - balls[0] < 4.0 * radius && balls[2] - balls[0] > 3.5 * radius);
    }
    assert_eq!(rows, 3, "three in a row at each of the speeds: {kinds:?} {stable:?}");
}

/// Three balls balance in a continuum: of all angles at which friction holds them, none within reach leaves much more than was met.
#[test]
fn friction_leaves_an_unbalance_about_a_continuum() {
    let (w, friction) = (3.0, 2e-3);
    let o = run(&machine(w, 3, &format!("dry_torque = {friction}"), &stationary(2.9, 3.1)));
    let finding = o.findings.iter().find(|f| f.id == "dead_zone" && f.subject == "continuum").expect("a finding");
    let met = finding.value.unwrap();
    let (kinds, speeds) = (words(&o, "dead_zone_continua", "kind"), column(&o, "dead_zone_continua", "speed"));
    let (angle, left) = (column(&o, "dead_zone_continua", "angle"), column(&o, "dead_zone_continua", "unbalance"));
    let k = (0..kinds.len()).find(|&k| kinds[k] == "balanced" && speeds[k] == w).expect("the continuum");
    assert!(left[k] == met && column(&o, "dead_zone_continua", "closed")[k] == 1.0);
    // friction is just used up there
    let moment = |x: &[f64]| x.iter().fold(c(UNBALANCE, 0.0), |u, a| u + C64::cis(*a).scale(MASS)).abs();
    let worst = [angle[k], angle[k + 1], angle[k + 2]];
    let share = held(w, &worst).1.iter().fold(0.0f64, |m, t| m.max(t.abs())) / friction;
    assert!((share - 1.0).abs() < 1e-6 && (moment(&worst) / met - 1.0).abs() < 1e-9, "{share} {} {met}", moment(&worst));
    // all angles on a grid that are joined to balanced ones by others that friction holds
    const N: usize = 144;
    let place = |i: usize| std::f64::consts::TAU * i as f64 / N as f64;
    let at = |i: usize| [place(i / (N * N)), place(i / N % N), place(i % N)];
    let holds: Vec<bool> = (0..N * N * N).map(|i| held(w, &at(i)).1.iter().all(|t| t.abs() <= friction)).collect();
    let mut seen: Vec<bool> = (0..N * N * N).map(|i| holds[i] && moment(&at(i)) < 0.2 * met).collect();
    let mut waiting: Vec<usize> = (0..N * N * N).filter(|&i| seen[i]).collect();
    assert!(waiting.len() > 100);
    let mut most = 0.0f64;
    while let Some(i) = waiting.pop() {
        most = most.max(moment(&at(i)));
        let own = [i / (N * N), i / N % N, i % N];
        for step in 0..27 {
            let to: Vec<usize> = (0..3).map(|d| (own[d] + N + step / 3usize.pow(d as u32) % 3 - 1) % N).collect();
            let j = (to[0] * N + to[1]) * N + to[2];
            if holds[j] && !seen[j] {
                seen[j] = true;
                waiting.push(j);
            }
        }
    }
    assert!(met < 1.3 * most && met > 0.5 * most, "met {met}, on the grid {most}");
    // without friction there is nothing to tell
    assert!(run(&machine(w, 3, "", &stationary(2.9, 3.1))).find_table("dead_zone_continua").is_none());
}
