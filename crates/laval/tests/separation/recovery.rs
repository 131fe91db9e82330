//! The one account of time of all studies: it converges with the number of places, meets second methods, and is the same in the window and in the separation.

use laval::file::load;
use laval::outcome::Outcome;
use laval::separation::batch::{Batch, RunUp};
use laval::separation::cup::{Hanging, SwingingCup};
use laval::separation::drift::Climb;
use laval::separation::exit::{Cylinder, Exit, Surface, Vessel};
use laval::separation::halton::point;
use laval::separation::law::Law;
use laval::separation::particle::{Drag, Medium, Particle};
use laval::separation::recovery::{Needed, Recovery};
use laval::separation::separator::{Bowl, Cup, Discs, Separator};
use laval::separation::suspension::{Member, Model, Powder, leave, members, paired_members, quantile, sorted};
use laval::separation::tube::Tube;
use laval::separation::vessel::Inside;
use laval::study::Context;
use rayon::prelude::*;
use std::f64::consts::PI;

const RPM: f64 = PI / 30.0;

fn cups(damping: f64) -> Separator {
    Separator::Cup(Cup {
        hanging: SwingingCup { hinge: 0.2, body: Hanging::point(2.6, 0.17), damping, gravity: 9.80665 },
        vessel: Cylinder { radius: 0.045, bottom: 0.3, top: 0.02 },
        held: None,
    })
}

/// Sand in hot crude oil.
fn sand(places: usize) -> Batch {
    Batch {
        separator: cups(2.0),
        medium: Medium { volume_fraction: 0.02, ..Medium::new(870.0, 15e-3) },
        powder: Powder { size: Law::RosinRammler { characteristic: 25e-6, spread: 1.3 }, density: Law::Single(2650.0) },
        from: None,
        places,
        slowest: false,
        model: Model::Adaptive,
        run_up: RunUp::None,
    }
}

fn needed(batch: &Batch, speed: f64, share: f64) -> Needed {
    let spinning = batch.at(speed);
    Recovery::new(&spinning).unwrap().needed(share).unwrap()
}

/// Doubling the places closes in on one value, with and without the run-up; the difference to half and a quarter of the places tells what is left.
#[test]
fn times_converge_with_the_places() {
    let w = 1174.0 * RPM;
    for run_up in [RunUp::None, RunUp::Linear(60.0 / (2600.0 * RPM))] {
        let at = |places: usize| needed(&Batch { run_up: run_up.clone(), ..sand(places) }, w, 0.95);
        let limit = at(1 << 17);
        for k in 8..=15 {
            let n = at(1 << k);
            let error = (n.time - limit.time).abs();
            // faster than random places, whose error falls like N^-1/2
            assert!(error < limit.time * f64::from(1 << k).powf(-0.75), "{k}: {error:e}");
            // the differences between parts of the set tell how much is left open
            assert!(error < 2.0 * n.spread, "{k}: {error:e} {n:?}");
        }
        // any number of places, not only powers of two
        for places in [1000, 3000, 5000] {
            let n = at(places);
            assert!((n.time - limit.time).abs() < limit.time * (places as f64).powf(-0.75), "{places}");
        }
    }
}

/// A second method: sizes sampled as well, a million particles counted one by one.
#[test]
fn counted_particles_meet_the_sum() {
    let (batch, w) = (sand(1 << 13), 1174.0 * RPM);
    let turning = batch.separator.at(w);
    let crowd = members(&turning, 1 << 20);
    let times: Vec<Option<f64>> = crowd
        .par_iter()
        .map(|m| leave(&turning, &batch.medium, &batch.powder.particle(&m.point), m, Model::Inertial).map(|e| e.time))
        .collect();
    let times = sorted(times.into_iter());
    let spinning = batch.at(w);
    let mut recovery = Recovery::new(&spinning).unwrap();
    for share in [0.5, 0.9, 0.95] {
        let n = recovery.needed(share).unwrap();
        let counted = quantile(&times, share);
        assert!((n.time / counted - 1.0).abs() < 2e-3, "{share}: {} {counted}", n.time);
        // and back
        assert!((recovery.caught(n.time).unwrap() - share).abs() < 1e-8);
    }
}

/// The share caught by the time for a share is that share, for as many places as are looked at in part first, and where particles are slower than by Stokes' law, so that
/// one round over all places does not suffice.
#[test]
fn the_time_for_a_share_catches_it() {
    let coarse = Powder { size: Law::RosinRammler { characteristic: 400e-6, spread: 1.3 }, density: Law::Single(2650.0) };
    let drag = Medium { drag: Drag::SchillerNaumann, ..Medium::new(998.2, 1e-3) };
    let fast = Batch { powder: coarse, medium: drag, model: Model::Drifting, ..sand(0) };
    let run_up = RunUp::Linear(60.0 / (2600.0 * RPM));
    for (batch, speeds) in [(Batch { run_up, ..sand(0) }, [700.0, 1449.0]), (fast, [60.0, 300.0])] {
        for (places, w) in [200, 256, 1000].into_iter().flat_map(|n| speeds.map(|w| (n, w * RPM))) {
            let batch = Batch { places, ..batch.clone() };
            let spinning = batch.at(w);
            let time = Recovery::new(&spinning).unwrap().needed(0.9).unwrap().time;
            let caught = Recovery::new(&spinning).unwrap().caught(time).unwrap();
            assert!((caught - 0.9).abs() < 1e-6, "{places} places at {w}: {caught}");
        }
    }
}

/// During a run-up particles far from all surfaces are carried on by a series, others in steps: both leave the same way.
#[test]
fn the_run_up_by_series_is_that_in_steps() {
    let (batch, w) = (sand(0), 1449.0 * RPM);
    let Separator::Cup(cup) = batch.separator else { unreachable!() };
    let ramp = RunUp::Linear(60.0 / (2600.0 * RPM)).to(w).unwrap();
    let climb = Climb::new(&cup.hanging, None, &ramp, &cup.vessel);
    let (turning, inside) = (batch.separator.at(w), Inside::Cup(cup.vessel));
    let end = ramp.duration();
    let stays = |r: [f64; 3], _: [f64; 3]| Some(Exit { time: 0.0, surface: Surface::Bottom, position: r, velocity: [0.0; 3] });
    let mut within = 0;
    for start in (1..400).filter_map(|k| turning.start(&point(k))) {
        for (diameter, density) in [5e-6, 15e-6, 30e-6, 60e-6].into_iter().flat_map(|d| [(d, 2650.0), (d, 400.0)]) {
            let p = Particle { radius: 0.5 * diameter, density };
            let a = climb.settle(&batch.medium, &p, &inside, start, stays).unwrap();
            let b = climb.follow(&batch.medium, &p, &inside, start, stays, &mut ()).unwrap();
            assert!((a.time - b.time).abs() < 1e-5 * end && a.surface == b.surface, "{diameter} {start:?}: {a:?} {b:?}");
            let way = |from: [f64; 3], to: [f64; 3]| (0..3).map(|k| (to[k] - from[k]).powi(2)).sum::<f64>().sqrt();
            assert!(way(a.position, b.position) < 2e-5 * way(start, b.position) + 1e-12, "{diameter} {start:?}: {a:?} {b:?}");
            within += usize::from(b.time == end);
        }
    }
    assert!((1000..2800).contains(&within), "{within}");
}

/// A powder of one size and one of classes: the order statistics of the members.
#[test]
fn single_sizes_are_counted() {
    let batch = Batch { powder: Powder { size: Law::Single(8e-6), density: Law::Single(2650.0) }, ..sand(999) };
    let w = 1000.0 * RPM;
    let turning = batch.separator.at(w);
    let time = |d: f64| {
        let p = Particle { radius: 0.5 * d, density: 2650.0 };
        paired_members(&turning, 999)
            .iter()
            .map(|m| leave(&turning, &batch.medium, &p, m, Model::Inertial).map(|e| e.time))
            .collect::<Vec<_>>()
    };
    let single = sorted(time(8e-6).into_iter());
    for share in [0.1, 0.5, 0.95] {
        assert_eq!(needed(&batch, w, share).time, quantile(&single, share));
    }
    let classes = Law::classes(&[4e-6, 8e-6], &[1.0, 1.0]).unwrap();
    let both = sorted(time(8e-6).into_iter().chain(time(4e-6)));
    let batch = Batch { powder: Powder { size: classes, ..batch.powder.clone() }, ..batch };
    assert_eq!(needed(&batch, w, 0.7).time, quantile(&both, 0.7));
    // only the larger class counts
    let larger = Batch { from: Some(5e-6), ..batch };
    assert_eq!(needed(&larger, w, 0.7).time, quantile(&single, 0.7));
}

/// A place moved onto the border of its vessel: to the side, along the axis to the surface and to the bottom, and to the edges between them.
fn onto(inside: &Inside, r: [f64; 3]) -> Vec<[f64; 3]> {
    let (radius, bottom, lowest) = match inside {
        Inside::Cup(c) => (c.radius, c.bottom, c.top),
        Inside::Tube(f) => (f.tube().radius, f.tube().length, 0.0),
        Inside::Ring(..) => unreachable!(),
    };
    let within = |r: [f64; 3]| inside.gaps(r, [0.0; 3]).iter().all(|g| g.value > 0.0);
    let out = (1.0 - 1e-9) * radius / r[0].hypot(r[2]);
    let side = [out * r[0], r[1], out * r[2]];
    let mut all = vec![side];
    for [x, y, z] in [r, side] {
        all.push([x, bottom * (1.0 - 1e-9), z]);
        // the surface lies between a place in the liquid and one above it
        let (mut low, mut high) = (lowest, if within([x, y, z]) { y } else { bottom * (1.0 - 1e-9) });
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if within([x, middle, z]) { high = middle } else { low = middle }
        }
        all.push([x, high, z]);
    }
    all.retain(|r| within(*r));
    all
}

/// All particles are caught with the slowest of them, not with the last of the set: in a bowl the closed form from its surface, in cups and tubes the last of many places on
/// the border.
#[test]
fn all_are_caught_with_the_slowest() {
    let bowl = Separator::Bowl(Bowl { length: 0.5, radius: 0.1, surface: 0.05 });
    let tube = Separator::Tube(Tube { mouth: 0.045, angle: 0.5, radius: 0.012, length: 0.09, surface: 0.02 }, 9.80665);
    let powder = |rho: f64| Powder { size: Law::Single(3e-6), density: Law::Single(rho) };
    let w = 300.0;
    for rho in [2650.0, 600.0] {
        let batch = Batch { separator: bowl, powder: powder(rho), model: Model::Drifting, ..sand(16) };
        let s = batch.medium.rates(&Particle { radius: 1.5e-6, density: rho }).sedimentation.abs();
        let all = needed(&batch, w, 1.0).time;
        assert!((all * s * w * w / 2f64.ln() - 1.0).abs() < 1e-12, "{rho}: {all}");
        for (separator, w) in [(cups(0.0), 120.0), (cups(0.0), 12.0), (tube, 300.0)] {
            let at = |places: usize| Batch { separator, powder: powder(rho), ..sand(places) };
            let exact = needed(&at(16), w, 1.0);
            let batch = at(1 << 12);
            let spinning = batch.at(w);
            let p = Particle { radius: 1.5e-6, density: rho };
            let latest = |starts: Vec<[f64; 3]>| {
                let time =
                    |start: [f64; 3]| spinning.exit(&p, &Member { start, ..spinning.crowd[0] }).unwrap().map_or(f64::INFINITY, |e| e.time);
                starts.into_par_iter().map(time).reduce(|| 0.0, f64::max)
            };
            let inside = spinning.turning.inside().unwrap();
            let starts: Vec<[f64; 3]> = spinning.crowd.iter().map(|m| m.start).collect();
            // never later than the slowest, which the search finds to a millionth; on the border nearer by the distance of places there
            let distance = 1.0 / f64::from(1 << 12).sqrt();
            let left = 1.0 - latest(starts.clone()) / exact.time;
            let near = 1.0 - latest(starts.iter().flat_map(|r| onto(inside, *r)).collect()) / exact.time;
            assert!(left > near && near > -1e-6 && near < distance, "{} {rho} {w}: {left:e} {near:e}", separator.word());
            assert!(exact.last.is_some());
        }
    }
    // a run-up delays the last one as well; a powder without a smallest size is never caught
    let climbing = Batch { powder: powder(2650.0), run_up: RunUp::Linear(0.2), ..sand(16) };
    let still = needed(&Batch { run_up: RunUp::None, ..climbing.clone() }, 120.0, 1.0).time;
    let delayed = needed(&climbing, 120.0, 1.0).time - still;
    assert!(delayed > 0.6 * 24.0 && delayed < 0.7 * 24.0, "{delayed}");
    assert_eq!(needed(&sand(16), 120.0, 1.0).time, f64::INFINITY);
    let coarse = needed(&Batch { from: Some(3e-6), ..sand(16) }, 120.0, 1.0).time;
    assert!((coarse / still - 1.0).abs() < 1e-2, "{coarse} {still}");
}

/// Inertia in the run-up, and the swing of the cups: what the adaptive account leaves out.
#[test]
fn run_up_with_and_without_inertia() {
    let w = 1174.0 * RPM;
    let batch = Batch { run_up: RunUp::Linear(60.0 / (2600.0 * RPM)), ..sand(24) };
    let exact = needed(&Batch { model: Model::Inertial, ..batch.clone() }, w, 0.95).time;
    let adaptive = needed(&batch, w, 0.95).time;
    assert!((adaptive / exact - 1.0).abs() < 2e-5, "{exact} {adaptive}");
    // a run-up that is most of the time: the cups swing while particles settle
    let slow = Batch { run_up: RunUp::Smooth(400.0 / w), ..batch };
    let (a, b) = (needed(&Batch { model: Model::Inertial, ..slow.clone() }, w, 0.6).time, needed(&slow, w, 0.6).time);
    assert!((a / b - 1.0).abs() < 1e-3, "{a} {b}");
}

/// The drag law of Schiller and Naumann in every vessel that has a path: drifting against the full integration.
#[test]
fn nonlinear_drag_in_every_vessel() {
    let tube = Separator::Tube(Tube { mouth: 0.045, angle: 0.5, radius: 0.012, length: 0.09, surface: 0.02 }, 9.80665);
    let bowl = Separator::Bowl(Bowl { length: 0.5, radius: 0.1, surface: 0.05 });
    for (separator, w, viscosity) in [(cups(0.0), 100.0, 0.03), (tube, 300.0, 0.1), (bowl, 300.0, 0.1)] {
        let medium = Medium { drag: Drag::SchillerNaumann, ..Medium::new(900.0, viscosity) };
        let powder = Powder { size: Law::LogNormal { median: 200e-6, gsd: 1.5 }, density: Law::Single(2650.0) };
        let batch = Batch { separator, medium, powder, model: Model::Drifting, ..sand(24) };
        let drifting = needed(&batch, w, 0.9).time;
        let exact = needed(&Batch { model: Model::Inertial, ..batch.clone() }, w, 0.9).time;
        let stokes = needed(&Batch { medium: Medium { drag: Drag::Stokes, ..medium }, ..batch.clone() }, w, 0.9).time;
        assert!((drifting / exact - 1.0).abs() < 2e-2, "{}: {drifting} {exact}", separator.word());
        assert!(exact > 1.04 * stokes, "{}: the law makes a difference", separator.word());
    }
    // a disc stack: small particles as by Stokes' law, large ones later
    let discs = Separator::Discs(Discs { inner: 0.08, outer: 0.25, angle: 0.96, gaps: 100.0, spacing: 0.5e-3 });
    let time = |d: f64, drag: Drag| {
        let powder = Powder { size: Law::Single(d), density: Law::Single(2650.0) };
        needed(&Batch { separator: discs, medium: Medium { drag, ..Medium::new(900.0, 1e-3) }, powder, ..sand(64) }, 400.0, 1.0).time
    };
    assert!((time(1e-9, Drag::SchillerNaumann) / time(1e-9, Drag::Stokes) - 1.0).abs() < 1e-6);
    assert!(time(1e-4, Drag::SchillerNaumann) > 2.0 * time(1e-4, Drag::Stokes));
}

fn run(text: &str, study: usize) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[study].study.run(&loaded.system, &Context::quiet("recovery")).unwrap_or_else(|d| panic!("{d:?}"))
}

/// The example asks both studies: at the recommended speed both say the same, and the lower end of the window just separates.
#[test]
fn the_window_and_the_separation_agree() {
    let text = include_str!("../../../../examples/05-oil-desludging/machine.toml");
    // fewer particles, and no map
    let window = &text[..text.find("# The separation at the recommended speed").unwrap()];
    let text =
        window.lines().filter(|l| !l.starts_with("map =")).collect::<Vec<_>>().join("\n").replace("particles = 2048", "particles = 512");
    let window = run(&text, 0);
    let speeds = window.find_table("speeds").unwrap();
    let at = |name: &str, i: usize| speeds.column(name).unwrap().number(i).unwrap();
    let low = window.find_table("window").unwrap().column("low").unwrap().number(0).unwrap();
    let rows: Vec<usize> = (0..speeds.rows()).filter(|&i| at("speed", i) >= low * (1.0 - 1e-12)).step_by(40).collect();
    assert!(rows.len() >= 3);
    for i in rows {
        let (w, t) = (at("speed", i), at("time", i));
        let ramp = 60.0 * w / (2600.0 * RPM);
        let study = format!(
            "[[study]]\nkind = \"separation\"\nspeed = {w:e}\ntime = \"8 min\"\nparticles = 512\nramp = {ramp:e}\nramp_shape = \"linear\"\n"
        );
        let separation = run(&format!("{text}\n{study}"), 1);
        let found = separation.findings.iter().find(|f| f.id == "time_needed").unwrap().value.unwrap();
        assert!((found / t - 1.0).abs() < 1e-9, "{w}: {found} {t}");
        if (w / low - 1.0).abs() < 1e-9 {
            let caught = separation.findings.iter().find(|f| f.id == "caught").unwrap().value.unwrap();
            assert!((caught - 0.95).abs() < 1e-8, "{caught}");
        }
    }
}

/// No start leaves much earlier or later with inertia than without: small particles in every place of the set, on the surfaces too.
#[test]
fn inertia_of_small_particles_is_small() {
    let (batch, w) = (sand(1 << 15), 1174.0 * RPM);
    let spinning = batch.at(w);
    for d in [1e-6, 3e-6] {
        let p = Particle { radius: 0.5 * d, density: 2650.0 };
        let s = batch.medium.rates(&p).sedimentation;
        let mut worst = (0.0, 0);
        for (i, m) in spinning.crowd.iter().enumerate() {
            let (a, b) = (spinning.exit(&p, m).unwrap().unwrap(), spinning.turning.drift(s, m.start).unwrap());
            let off = (a.time / b.time - 1.0).abs();
            if off > worst.0 {
                worst = (off, i);
            }
        }
        assert!(worst.0 < 1e-2, "{d}: {worst:?}");
    }
}

/// Paths begin where particles start and end where and when they leave, in every vessel and by every way of computing; two of these ways meet in between.
#[test]
fn paths_end_at_the_exits() {
    let (w, run_up) = (1174.0 * RPM, RunUp::Linear(60.0 / (2600.0 * RPM)));
    let tube = Separator::Tube(Tube { mouth: 0.045, angle: 0.5, radius: 0.012, length: 0.09, surface: 0.02 }, 9.80665);
    let bowl = Separator::Bowl(Bowl { length: 0.5, radius: 0.1, surface: 0.05 });
    let nonlinear = Medium { drag: Drag::SchillerNaumann, ..sand(16).medium };
    let climbing = Batch { run_up: run_up.clone(), ..sand(16) };
    let batches = [
        sand(16),
        climbing.clone(),
        Batch { model: Model::Inertial, ..climbing.clone() },
        Batch { model: Model::Drifting, ..climbing.clone() },
        Batch { medium: nonlinear, ..climbing.clone() },
        Batch { medium: nonlinear, ..sand(16) },
        Batch { separator: tube, run_up: run_up.clone(), ..sand(16) },
        Batch { separator: tube, medium: nonlinear, run_up, ..sand(16) },
        Batch { separator: bowl, ..sand(16) },
    ];
    let particle = |d: f64| Particle { radius: 0.5 * d, density: 2650.0 };
    for (i, batch) in batches.iter().enumerate() {
        let spinning = batch.at(w);
        for m in &spinning.crowd {
            let p = particle(12e-6);
            let exit = spinning.exit(&p, m).unwrap().unwrap();
            let path = spinning.places(&p, m, f64::INFINITY, 40).unwrap();
            let far = (0..3).map(|k| (exit.position[k] - m.start[k]).powi(2)).sum::<f64>().sqrt() > 2e-3;
            assert!(path.len() > if far { 5 } else { 1 } && path.windows(2).all(|p| p[1].time > p[0].time), "{i}");
            let (first, last) = (path[0], path[path.len() - 1]);
            assert!((0..3).all(|k| (first.at[k] - m.start[k]).abs() < 1e-12), "{i} {first:?} {m:?}");
            assert_eq!((last.time, last.at), (exit.time, exit.position), "{i}");
            // no jump on the way, and none at the end
            let step = |p: &[laval::separation::places::Place]| (0..3).map(|k| (p[1].at[k] - p[0].at[k]).powi(2)).sum::<f64>().sqrt();
            assert!(path.windows(2).all(|p| step(p) < 0.05), "{i} {path:?}");
            // cut off at a time
            let half = 0.5 * exit.time;
            let part = spinning.places(&p, m, half, 40).unwrap();
            assert!(part.last().is_some_and(|p| p.time <= half * (1.0 + 1e-12)), "{i}");
        }
    }
    // with and without inertia: the same way at the same time
    let (a, b) = (batches[1].at(w), batches[2].at(w));
    for m in &a.crowd {
        let p = particle(3e-6);
        let (x, y) = (a.places(&p, m, 200.0, 40).unwrap(), b.places(&p, m, 200.0, 40).unwrap());
        let (x, y) = (x[x.len() - 1], y[y.len() - 1]);
        assert!((x.time / y.time - 1.0).abs() < 1e-3 && (x.radius - y.radius).abs() < 1e-4, "{x:?} {y:?}");
    }
}

/// The rotor of a laboratory centrifuge on a shaft.
const ROTOR: &str = r#"
[machine]
name = "centrifuge"
[[part]]
kind = "disc"
name = "rotor"
mass = 10
[[part]]
kind = "shaft_lumped"
name = "shaft"
between = ["rotor", "ground"]
stiffness = 4e5
"#;

/// Its cups and what is in them.
const CUPS: &str = r#"
[[cup]]
kind = "swinging"
centre_of_mass = "170 mm"
hinge_radius = "200 mm"
cup_radius = "45 mm"
bottom = "300 mm"
[suspension]
liquid_density = 870
viscosity = "15 mPa s"
particle_density = 2650
"#;

/// The speed a recovery needs with a programme: the same programme with all its speeds in proportion takes just the time at hand; so with nonlinear drag.
#[test]
fn speeds_are_found_with_programmes() {
    let file = |last: f64, drag: &str| {
        let speeds = [0.0, 0.4 * last, last].map(|w| format!("{w:e}")).join(", ");
        format!(
            r#"{ROTOR}{CUPS}characteristic_diameter = "25 um"
spread = 1.3
drag = "{drag}"
[[study]]
kind = "separation"
time = "5 min"
particles = 16
programme = {{ time = [0, 30, 90], speed = [{speeds}] }}
"#
        )
    };
    for drag in ["stokes", "schiller_naumann"] {
        let value = |o: &Outcome, id: &str| o.findings.iter().find(|f| f.id == id).and_then(|f| f.value).unwrap();
        let found = value(&run(&file(150.0, drag), 0), "speed_needed");
        let again = run(&file(found, drag), 0);
        assert!((value(&again, "time_needed") / 300.0 - 1.0).abs() < 1e-6, "{drag}: {}", value(&again, "time_needed"));
        assert!(again.find_table("demand").is_some() && again.find_table("sensitivity").is_some());
    }
    // with the inertia of every particle the speed is not searched for, and that is said
    let o = run(&file(150.0, "stokes").replace("particles = 16", "particles = 16\nmodel = \"exact\""), 0);
    let reported = o.findings.iter().find(|f| f.id == "speed_needed").unwrap();
    assert!(reported.value.is_none() && reported.sentence().contains("drifting"), "{}", reported.sentence());
}

/// What a study tells of its progress.
#[derive(Default)]
struct Reported(std::sync::Mutex<Vec<(u64, u64)>>);

impl laval::study::Progress for Reported {
    fn report(&self, done: u64, total: u64) {
        self.0.lock().unwrap().push((done, total));
    }
}

/// Particles that are integrated one by one tell how far they are, to the end, and stop when requested to.
#[test]
fn integrations_tell_how_far_they_are() {
    let text = format!(
        r#"{ROTOR}{CUPS}characteristic_diameter = "400 um"
spread = 1.3
drag = "schiller_naumann"
[[study]]
kind = "separation"
speed = "600 rpm"
time = "5 min"
particles = 64
"#
    );
    let loaded = load(&text).unwrap_or_else(|d| panic!("{d:?}"));
    let reported = Reported::default();
    let cancel = laval::study::Cancel::default();
    let context = Context { name: "coarse", cancel: &cancel, progress: &reported, work_limit: u64::MAX, keep: None };
    let o = loaded.studies[0].study.run(&loaded.system, &context).unwrap();
    let seen = reported.0.lock().unwrap().clone();
    assert!(o.end == laval::outcome::End::Reached && seen.len() > 8, "{seen:?}");
    assert!(seen.iter().all(|s| s.0 <= s.1 && s.1 == seen[0].1) && seen.last().is_some_and(|s| s.0 == s.1), "{seen:?}");
    cancel.store(true, std::sync::atomic::Ordering::Relaxed);
    let quiet = Context { progress: &laval::study::Silent, ..context };
    let stopped = loaded.studies[0].study.run(&loaded.system, &quiet).unwrap();
    assert!(stopped.end == laval::outcome::End::Cancelled && stopped.findings.is_empty());
}

/// The limit counts paths, wherever it falls: in the first exits, in the time needed, in the search for a speed. Nothing is then shown.
#[test]
fn the_work_limit_counts_paths() {
    let text = format!(
        "{ROTOR}{CUPS}characteristic_diameter = \"25 um\"\nspread = 1.3\n[[study]]\nkind = \"separation\"\nspeed = \"1430 rpm\"\ntime = \"8 min\"\nparticles = 256\n"
    );
    let loaded = load(&text).unwrap_or_else(|d| panic!("{d:?}"));
    let limited = |work_limit| {
        let reported = Reported::default();
        let context = Context { progress: &reported, work_limit, ..Context::quiet("limited") };
        let o = loaded.studies[0].study.run(&loaded.system, &context).unwrap();
        (o, reported.0.lock().unwrap().clone())
    };
    for limit in [2, 300, 2000] {
        let (o, seen) = limited(limit);
        assert!(o.end == laval::outcome::End::WorkLimit && o.tables.is_empty(), "{limit}");
        assert_eq!(o.findings.iter().map(|f| f.id.as_str()).collect::<Vec<_>>(), ["nothing_shown"], "{limit}");
        assert!(seen.iter().all(|s| s.0 <= limit + 1024), "{limit} {seen:?}");
    }
    assert!(limited(1_000_000).0.end == laval::outcome::End::Reached);
}

/// The speed a bowl needs may be one at which gravity, which its model leaves out, counts: that is said.
#[test]
fn speeds_at_which_gravity_counts_are_doubted() {
    let file = |throughput: f64| {
        format!(
            r#"{ROTOR}[[cup]]
kind = "tubular_bowl"
length = "500 mm"
bowl_radius = "100 mm"
surface_radius = "50 mm"
[suspension]
liquid_density = 1000
viscosity = "1 mPa s"
particle_density = 2650
diameter = "10 um"
[[study]]
kind = "separation"
speed = "1000 rpm"
throughput = "{throughput} l/h"
start = "slowest"
recovery = 1
"#
        )
    };
    for (throughput, doubted) in [(30.0, true), (3000.0, false)] {
        let o = run(&file(throughput), 0);
        let w = o.findings.iter().find(|f| f.id == "speed_needed").and_then(|f| f.value).unwrap();
        // from surface to wall in the residence time
        let (s, volume) = (25e-12 * 2.0 * 1650.0 / 9e-3, PI * (0.01 - 0.0025) * 0.5);
        assert!((w / (2f64.ln() / (s * volume / throughput * 3.6e6)).sqrt() - 1.0).abs() < 1e-3, "{w}");
        let doubt = o.findings.iter().find(|f| f.id == "speed_needed_gravity");
        assert_eq!((doubt.is_some(), w * w * 0.05 / 9.80665 < 10.0), (doubted, doubted), "{w}");
    }
}
