//! Loci of folds and of changes of stability: against single responses, closed forms, tables; symmetries, units, ranges that end, texts.

use crate::common;

use common::base::{Base, request, run};
use common::planar_file::{oil, planar_file};
use laval::file::{Form, load, render};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::outcome::{Arg, Data, End, Outcome};
use laval::parts::{bearing_cubic::*, damper::*, disc::*, foundation::*};
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::bifurcation::Event;
use laval::solve::harmonic::branches::response;
use laval::solve::harmonic::loci::crossings::plane;
use laval::solve::harmonic::loci::folds::FoldLocus;
use laval::solve::harmonic::loci::follow::{Path, PathEnd, follow, passes};
use laval::solve::harmonic::loci::search::{Corner, Loci, Locus, LocusKind, Request, loci};
use laval::solve::harmonic::loci::varied::Varied;
use laval::solve::symmetry::Symmetry;
use laval::study::bifurcation_loci::{BifurcationLoci, BifurcationLociResult};
use laval::study::{Context, TypedStudy};
use laval_num::continuation::{Failure, Settings, Zero};
use laval_num::dense::{Mat, dot, norm};
use std::sync::atomic::{AtomicBool, Ordering};

fn ask(speeds: (f64, f64), parameter: &str, range: (f64, f64), values: usize) -> Request {
    let step = (range.1 - range.0) / (values - 1) as f64;
    Request {
        speeds,
        parameter: parameter.into(),
        range,
        values: (0..values).map(|i| if i + 1 == values { range.1 } else { range.0 + step * i as f64 }).collect(),
        folds: true,
        stability: false,
        harmonics: None,
        truncation: 1e-9,
        max_points: 2_000,
        work: u64::MAX,
    }
}

fn found(builder: Builder, request: &Request) -> Loci {
    let system = builder.build().unwrap_or_else(|d| panic!("{:?}", d.0));
    let never = AtomicBool::new(false);
    let found = loci(&system, request, &never, &|_| {}).unwrap_or_else(|d| panic!("{d:?}"));
    assert!(!found.stopped && found.lost == 0 && !found.more);
    found
}

fn cusps(found: &Loci) -> Vec<&Corner> {
    found.loci.iter().filter(|l| l.kind == LocusKind::Fold).flat_map(|l| &l.corners).filter(|c| c.turn.speed_turns).collect()
}

#[track_caller]
fn near(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a:.15e} {b:.15e}");
}

/// The curve `q = b s^2, W = 2 + c s + s^2 + s^3` in unknowns (s, W).
struct Curve {
    b: f64,
    c: f64,
}

impl Curve {
    fn speed(&self, s: f64) -> f64 {
        2.0 + self.c * s + s * s + s * s * s
    }
}

impl Zero for Curve {
    fn dim(&self) -> usize {
        2
    }
    fn scale(&self, out: &mut [f64]) {
        out.fill(1.0);
    }
    fn parameter_scale(&self) -> f64 {
        1.0
    }
    fn eval(&mut self, y: &[f64], q: f64, r: &mut [f64], jac: Option<&mut Mat>, dr_dq: Option<&mut [f64]>) -> Result<(), Failure> {
        let s = y[0];
        r[0] = self.b * s * s - q;
        r[1] = y[1] - self.speed(s);
        if let Some(jac) = jac {
            (jac[(0, 0)], jac[(1, 0)], jac[(1, 1)]) = (2.0 * self.b * s, -self.c - 2.0 * s - 3.0 * s * s, 1.0);
        }
        if let Some(d) = dr_dq {
            d[0] = -1.0;
        }
        Ok(())
    }
}

fn followed(b: f64, c: f64, s: f64, speeds: (f64, f64)) -> (Curve, Path) {
    let mut curve = Curve { b, c };
    let y = [s, curve.speed(s)];
    let path = follow(&mut curve, &y, b * s * s, 1, speeds, &Settings::new(-1.0, 1.0)).unwrap();
    (curve, path)
}

/// Wherever it was started from: far away, or so near that the first step crosses it.
#[test]
fn a_cusp_is_where_both_turn_back() {
    for b in [1.0, -1.0] {
        for (c, s) in [(0.0, -0.4), (0.0, 0.4), (0.0, 0.004), (0.0, -0.004), (1.0, -0.4), (-0.3, 0.4), (0.02, 0.4), (0.3, 0.004)] {
            let (mut curve, path) = followed(b, c, s, (-10.0, 10.0));
            assert_eq!(path.ends, [PathEnd::Value, PathEnd::Value]);
            let [turn] = &path.turns[..] else { panic!("{:?}", path.turns) };
            assert_eq!(turn.speed_turns, c == 0.0, "{b} {c} {s} {turn:?}");
            assert!(turn.opens_up == (b > 0.0) && turn.confirmed, "{turn:?}");
            assert!(turn.value.abs() < 1e-14 && (turn.y[1] - 2.0).abs() < 1e-9, "{turn:?}");
            assert!(path.points[turn.after].x[0] * path.points[turn.after + 1].x[0] <= 0.0);
            // both ends of the range are reached, on either side
            let [first, last] = [&path.points[0], &path.points[path.points.len() - 1]];
            assert!(first.p == b && last.p == b && (first.x[0] * last.x[0] + 1.0).abs() < 1e-9);
            for s in [0.7f64, -0.7] {
                assert!(passes(&mut curve, &path, 0.49 * b, Curve { b, c }.speed(s), 1, 1e-6));
                assert!(!passes(&mut curve, &path, 0.49 * b, Curve { b, c }.speed(s) + 0.01, 1, 1e-6));
            }
        }
    }
}

#[test]
fn a_locus_is_cut_off_at_the_range_of_speeds() {
    let (_, path) = followed(1.0, 1.0, 0.1, (1.7, 2.6));
    assert_eq!(path.ends, [PathEnd::Speed, PathEnd::Speed]);
    let speeds: Vec<f64> = path.points.iter().map(|p| p.x[1]).collect();
    let (lo, hi) = speeds.iter().fold((9.0f64, 0.0f64), |(a, b), s| (a.min(*s), b.max(*s)));
    assert!((lo - 1.7).abs() < 1e-9 && (hi - 2.6).abs() < 1e-9, "{lo} {hi}");
    assert_eq!(path.turns.len(), 1);
}

#[test]
fn a_plane_is_normal_to_all_rows() {
    let rows = Mat::from_fn(5, 7, |i, j| ((3 * i + 5 * j * j + 2 * i * j) as f64 * 0.7).sin() * 10f64.powi(i as i32));
    let r = [1.0, -2.0, 30.0, 400.0, -5e3];
    let ([s, t], back) = plane(&rows, &r).unwrap();
    assert!(dot(&s, &t).abs() < 1e-14 && (norm(&s) - 1.0).abs() < 1e-14 && (norm(&t) - 1.0).abs() < 1e-14);
    for (i, r) in r.iter().enumerate() {
        for v in [&s, &t] {
            assert!(dot(rows.row(i), v).abs() < 1e-13 * norm(rows.row(i)));
        }
        assert!((dot(rows.row(i), &back) + r).abs() < 1e-12 * r.abs());
    }
    assert!(dot(&s, &back).abs() < 1e-12 * norm(&back) && dot(&t, &back).abs() < 1e-12 * norm(&back));
    assert!(plane(&Mat::from_fn(2, 4, |_, j| j as f64), &[0.0; 2]).is_none());
}

/// All derivatives of the equations of folds against differences of their residual, within the range and at its end, where the machine ceases to exist.
#[test]
fn derivatives_agree_with_differences() {
    let base = Base { fill: Some(0.667), wave_damping: 5.0, ..Base::default() };
    let cases = [
        ("drum.eccentricity", 1e-3, (1e-4, 2e-3)),
        ("air.damping", 0.0, (0.0, 100.0)),
        ("liquid.free_surface_radius", 0.0467, (0.03, 0.06)),
        ("liquid.wave_damping", 0.0, (0.0, 50.0)),
        ("bearing.cubic_stiffness", 8.7e10, (1e10, 1e11)),
    ];
    for (path, q, range) in cases {
        let system = base.builder().build().unwrap();
        let speeds = (2000.0, 2600.0);
        let d =
            laval::solve::harmonic::balance::problem::Discretisation { harmonics: 5, divisor: 1, samples: 32, symmetry: Symmetry::Quarter };
        let balance = Balance::new(&system, d, speeds, None).unwrap();
        let mut locus = FoldLocus { varied: Varied::new(&system, balance, path, range, speeds) };
        let m = locus.dim();
        let mut scale = vec![1.0; m];
        locus.scale(&mut scale);
        let mut y: Vec<f64> = scale.iter().enumerate().map(|(i, s)| s * (0.4 + (1.3 * i as f64).sin())).collect();
        y[m - 1] = 2300.0;
        let (mut r, mut jac, mut by_value) = (vec![0.0; m], Mat::zeros(m, m), vec![0.0; m]);
        locus.eval(&y, q, &mut r, Some(&mut jac), Some(&mut by_value)).unwrap();
        let mut residual = |y: &[f64], q: f64| {
            let mut r = vec![0.0; m];
            locus.eval(y, q, &mut r, None, None).unwrap();
            r
        };
        let size: Vec<f64> = (0..m).map(|i| (0..m).map(|j| (jac[(i, j)] * scale[j]).abs()).fold(0.0, f64::max)).collect();
        for j in 0..m {
            let h = 1e-5 * scale[j];
            let [plus, minus] = [h, -h].map(|h| {
                let mut y = y.clone();
                y[j] += h;
                residual(&y, q)
            });
            for i in 0..m {
                let want = (plus[i] - minus[i]) / 2e-5;
                assert!((jac[(i, j)] * scale[j] - want).abs() < 1e-6 * size[i], "{path} {i} {j}: {} {want}", jac[(i, j)] * scale[j]);
            }
        }
        // forwards only, as the machine may end at q: twice the order by extrapolation
        let wide = range.1 - range.0;
        let mut step = |h: f64| -> Vec<f64> { residual(&y, q + h).iter().zip(&r).map(|(a, b)| (a - b) / h * wide).collect() };
        let (one, two) = (step(1e-4 * wide), step(5e-5 * wide));
        for i in 0..m {
            let want = 2.0 * two[i] - one[i];
            assert!((by_value[i] * wide - want).abs() < 1e-5 * size[i], "{path} {i}: {} {want}", by_value[i] * wide);
        }
    }
}

const M: f64 = 2.0;
const K: f64 = 1e6;

fn jeffcott(isotropic: bool, k3: f64, c: f64, e: f64) -> Builder {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let bearing = if isotropic { BearingCubic::isotropic(link()) } else { BearingCubic::per_axis(link()) };
    Builder::new("one disc")
        .part("disc", Disc::planar(), DiscParams { eccentricity: e, ..DiscParams::new(M) })
        .part("spring", bearing, BearingCubicParams { stiffness: [K; 2], cubic_stiffness: [k3; 2], valid_to: 0.0 })
        .part("air", Damper::fixed(link()), DamperParams { damping: [c; 2], tilt_damping: 0.0 })
}

/// With `A = a^2`, `d = c W` and `k = K - m W^2` one harmonic gives `A ((k + k3 A)^2 + d^2) = (m e W^2)^2`. First and second derivative in A vanish together at
/// `k = -sqrt(3) d`: `m W^2 - sqrt(3) c W - K = 0`, `A = 2 d / (sqrt(3) k3)`, `(m e W^2)^2 = 4/3 A d^2`. Per axis k3 counts 3/4.
fn cusp(k3: f64, c: f64) -> [f64; 3] {
    let w = (3f64.sqrt() * c + (3.0 * c * c + 4.0 * M * K).sqrt()) / (2.0 * M);
    let d = c * w;
    let a = 2.0 * d / (3f64.sqrt() * k3);
    [w, (4.0 / 3.0 * a).sqrt() * d / (M * w * w), a.sqrt()]
}

#[test]
fn cusp_of_a_duffing_rotor() {
    for (isotropic, share) in [(true, 1.0), (false, 0.75)] {
        for (k3, c) in [(3e10, 100.0), (3e10, 20.0), (5e12, 300.0)] {
            let [w, e, a] = cusp(share * k3, c);
            let ranges = [
                ("disc.eccentricity", e, 0.31 * e, 4.0 * e),
                ("air.damping", c, 0.4 * c, 1.7 * c),
                ("spring.cubic_stiffness", k3, 0.3 * k3, 2.3 * k3),
            ];
            for (path, value, lo, hi) in ranges {
                let ask = Request { harmonics: Some(1), ..ask((0.5 * w, 2.5 * w), path, (lo, hi), 4) };
                let l = found(jeffcott(isotropic, k3, c, e), &ask);
                let [at] = &cusps(&l)[..] else { panic!("{path}: {:?}", l.loci.iter().map(|l| &l.corners).collect::<Vec<_>>()) };
                near(at.turn.value, value, 1e-10);
                near(at.speed, w, 1e-10);
                // the harmonic is (x + i y) of the only coordinates
                near(at.x[0].hypot(at.x[1]), a, 1e-6);
                assert!(at.turn.confirmed && at.turn.residual < 1e-10, "{:?}", at.turn);
                // less damping, more excitation or more stiffness brings the jumps
                assert_eq!(at.turn.opens_up, path != "air.damping", "{path}");
            }
        }
    }
}

/// Folds where `d/dA A ((k + k3 A)^2 + d^2) = 0`: `3 k3^2 A^2 + 4 k k3 A + k^2 + d^2 = 0`, at the speed for which `(m e W^2)^2` has its value there.
fn closed_folds(k3: f64, c: f64, e: f64, cusp: f64) -> [f64; 2] {
    [1.0, -1.0].map(|sign| {
        let excess = |w: f64| {
            let (k, d) = (K - M * w * w, c * w);
            let a = (-2.0 * k + sign * (k * k - 3.0 * d * d).max(0.0).sqrt()) / (3.0 * k3);
            (a * ((k + k3 * a).powi(2) + d * d)).sqrt() / (M * w * w) - e
        };
        let (mut below, mut above) = (cusp, 2.0 * cusp);
        assert!(excess(below) < 0.0 && excess(above) > 0.0);
        for _ in 0..100 {
            let middle = 0.5 * (below + above);
            if excess(middle) < 0.0 { below = middle } else { above = middle }
        }
        below
    })
}

fn report(builder: Builder, request: Request) -> (BifurcationLociResult, Outcome) {
    let system = builder.build().unwrap_or_else(|d| panic!("{:?}", d.0));
    let study = BifurcationLoci::new(request);
    let result = study.result(&system, &Context::quiet("loci")).unwrap_or_else(|d| panic!("{d:?}"));
    let outcome = study.outcome(&system, &result, "loci").unwrap_or_else(|d| panic!("{d:?}"));
    (result, outcome)
}

/// The cusp of a hardening rotor has the lowest speed of all folds: the speeds over which they spread begin with it.
#[test]
fn the_extent_of_folds_includes_the_cusp() {
    let (k3, c) = (3e10, 100.0);
    let [w, e, _] = cusp(k3, c);
    let ask = Request { harmonics: Some(1), ..ask((0.5 * w, 2.5 * w), "disc.eccentricity", (0.31 * e, 4.0 * e), 4) };
    let (_, outcome) = report(jeffcott(true, k3, c, e), ask);
    let f = outcome.findings.iter().find(|f| f.id == "folds_from").unwrap();
    let lowest = f.evidence.iter().find(|e| e.what == "lowest speed").unwrap().value;
    assert!(lowest <= w * (1.0 + 1e-9), "{lowest} {w}");
}

/// Above the cusp both folds are on loci of their own; what belongs together follows from the responses.
#[test]
fn folds_on_two_loci_belong_together() {
    let (k3, c) = (3e10, 100.0);
    for (isotropic, share) in [(true, 1.0), (false, 0.75)] {
        let [w, e, _] = cusp(share * k3, c);
        let ask = Request { harmonics: Some(1), ..ask((0.5 * w, 2.5 * w), "disc.eccentricity", (1.2 * e, 1.5 * e), 3) };
        let (result, outcome) = report(jeffcott(isotropic, k3, c, e), ask);
        assert_eq!(result.found.loci.len(), 2);
        assert!(result.found.loci.iter().all(|l| l.corners.is_empty()));
        assert_eq!(result.found.pairs.len(), 3);
        for p in &result.found.pairs {
            assert_ne!(p.on[0].0, p.on[1].0);
            let mut folds = closed_folds(share * k3, c, p.value, w);
            folds.sort_by(|a, b| b.total_cmp(a));
            near(p.speeds[0], folds[0], 1e-9);
            near(p.speeds[1], folds[1], 1e-9);
        }
        let folds = closed_folds(share * k3, c, 1.5 * e, w);
        let f = outcome.findings.iter().find(|f| f.id == "widest_hysteresis").unwrap();
        near(f.value.unwrap(), (folds[0] - folds[1]).abs(), 1e-8);
        for word in ["cut", "stopped"] {
            assert!(f.message.args.contains(&(word, Arg::word("no"))), "{}", f.sentence());
        }
    }
}

/// The fan of the tutorial with liquid in its wheel: small folds of the wave with a cusp of their own, and the large ones of the bearing on two loci.
#[test]
fn large_folds_without_a_cusp_are_not_passed_over() {
    let machine = |study: &str| {
        format!(
            r#"
[machine]
speed = "1480 rpm"
[[part]]
kind = "disc"
name = "wheel"
mass = "18 kg"
eccentricity = "1 um"
[[part]]
kind = "foundation"
name = "casing"
mass = "60 kg"
stiffness = {{ x = "2.4e6 N/m", y = "1.8e6 N/m" }}
damping = "900 N s/m"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["wheel", "casing"]
law = "isotropic"
stiffness = "9e6 N/m"
cubic_stiffness = "4e15 N/m^3"
valid_to = "0.1 mm"
[[part]]
kind = "damper"
name = "losses"
between = ["wheel", "casing"]
damping = "250 N s/m"
[[part]]
kind = "liquid"
in = "wheel"
cavity_radius = "150 mm"
cavity_height = "80 mm"
density = "1000 kg/m^3"
fill = {{ volume_fraction = 0.1 }}
wave_damping = "4 1/s"
[[study]]
speed = {{ from = "100 rpm", to = "12000 rpm" }}
harmonics = 3
{study}
"#
        )
    };
    let o = study(&machine(
        "kind = \"bifurcation_loci\"\nkinds = \"folds\"\nparameter = { parameter = \"wheel.eccentricity\", from = \"1 um\", to = \"20 um\", points = 2 }",
    ));
    let single = study(&machine("kind = \"nonlinear_response\"\nstability = false"));
    let folds: Vec<f64> = single.special_points.iter().filter(|p| p.kind == "fold").map(|p| p.at).collect();
    let apart = folds.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b)) - folds.iter().fold(f64::INFINITY, |a, b| a.min(*b));
    assert!(apart > 100.0, "{folds:?}");
    let f = o.findings.iter().find(|f| f.id == "widest_hysteresis").unwrap();
    assert!(f.value.unwrap() >= apart * (1.0 - 1e-6), "{} {folds:?}", f.sentence());
}

/// The folds of the response of the machine at the value of a locus point, with the same harmonics.
fn folds_at(builder: Builder, found: &Loci, speeds: (f64, f64)) -> Vec<f64> {
    let d = found.discretisation;
    let request =
        response::Request { harmonics: Some(d.harmonics), symmetry: Some(d.symmetry), stability: false, ..request(speeds.0, speeds.1) };
    run(builder, request).branches.iter().flat_map(|b| &b.folds).map(|f| f.speed).collect()
}

/// Points of loci, some on each, as (speed, value).
fn some_points(found: &Loci, kind: LocusKind, count: usize) -> Vec<(f64, f64)> {
    let some = |l: &Locus| (0..count).map(|i| l.points[(2 * i + 1) * l.points.len() / (2 * count)].clone()).collect::<Vec<_>>();
    found.loci.iter().filter(|l| l.kind == kind).flat_map(some).map(|p| (p.speed, p.value)).collect()
}

#[test]
fn loci_agree_with_single_responses() {
    let speeds = (1500.0, 4000.0);
    let base = Base { e: 5e-5, ..Base::default() };
    let filled = Base { fill: Some(0.667), chi: 600.0, ..Base::default() };
    type Vary = fn(Base, f64) -> Base;
    let cases: [(Base, &str, (f64, f64), Vary); 6] = [
        (base, "drum.eccentricity", (1e-5, 1e-4), |b, e| Base { e, ..b }),
        (base, "air.damping", (20.0, 300.0), |b, chi| Base { chi, ..b }),
        (base, "bearing.cubic_stiffness", (1e10, 2e11), |b, c1| Base { c1, ..b }),
        (base, "base.mass", (10.0, 100.0), |b, foundation| Base { foundation, ..b }),
        (filled, "liquid.free_surface_radius", (0.02, 0.065), |b, r| Base { fill: Some(r / 0.07), ..b }),
        (Base { isotropic: true, wave_damping: 20.0, ..filled }, "liquid.wave_damping", (0.0, 200.0), |b, wave_damping| Base {
            wave_damping,
            ..b
        }),
    ];
    for (base, path, range, vary) in cases {
        let l = found(base.builder(), &ask(speeds, path, range, 3));
        assert!(!l.loci.is_empty(), "{path}");
        let points = some_points(&l, LocusKind::Fold, 3);
        for (speed, value) in points {
            let folds = folds_at(vary(base, value).builder(), &l, speeds);
            let nearest = folds.iter().copied().min_by(|a, b| (a - speed).abs().total_cmp(&(b - speed).abs())).unwrap();
            near(speed, nearest, 1e-9);
        }
        // and no fold of a response lies beside the loci
        for s in &l.samples {
            let on = |speed: f64| {
                l.loci.iter().any(|l| {
                    let close = |p: &[laval::solve::harmonic::loci::search::LocusPoint]| {
                        (p[0].value - s.value) * (p[1].value - s.value) <= 0.0
                            && (p[0].speed.min(p[1].speed) - 30.0..=p[0].speed.max(p[1].speed) + 30.0).contains(&speed)
                    };
                    l.points.windows(2).any(close)
                })
            };
            for f in folds_at(vary(base, s.value).builder(), &l, speeds) {
                assert!(on(f), "{path}: fold at {f} of {}", s.value);
            }
        }
    }
}

/// folds_cross_checked.csv: harmonic balance and collocation by other programs.
#[test]
fn ends_of_a_locus_are_the_tabulated_folds() {
    let table = include_str!("../reference/planar/folds_cross_checked.csv");
    let folds = |chi: &str, e: &str| -> Vec<f64> {
        let rows = common::rows(table).into_iter().filter(|r| r[0] == chi && r[1] == e).map(|r| common::number(r[5]));
        rows.collect()
    };
    let l = found(Base { e: 5e-5, ..Base::default() }.builder(), &ask((1500.0, 4000.0), "drum.eccentricity", (8e-6, 5e-5), 3));
    let [locus] = &l.loci[..] else { panic!() };
    assert_eq!(locus.ends, [PathEnd::Value, PathEnd::Value]);
    let mut ends = [&locus.points[0], &locus.points[locus.points.len() - 1]].map(|p| p.speed);
    ends.sort_by(|a, b| b.total_cmp(a));
    for (got, want) in ends.iter().zip(folds("42", "5e-5")) {
        near(*got, want, 1e-10);
    }
    let [at] = &cusps(&l)[..] else { panic!() };
    assert!(at.harmonics_change[0].abs() < 1e-8 && at.harmonics_change[1].abs() < 1e-10 * at.turn.value);
    // cut off just above the cusp both folds are on loci of their own
    let l = found(Base { e: 2e-5, ..Base::default() }.builder(), &ask((1500.0, 4000.0), "drum.eccentricity", (1e-5, 2e-5), 2));
    assert_eq!(l.loci.len(), 2);
    let mut ends: Vec<f64> = l.loci.iter().flat_map(|l| &l.points).filter(|p| p.value == 1e-5).map(|p| p.speed).collect();
    ends.sort_by(|a, b| b.total_cmp(a));
    for (got, want) in ends.iter().zip(folds("42", "1e-5")) {
        near(*got, want, 1e-10);
    }
    // 1.005 of the only fold of the base set, whose damping does not close the upper branch
    let l = found(Base::default().builder(), &ask((1500.0, 4000.0), "air.damping", (42.0, 420.0), 2));
    for (chi, speed) in [("42", 42.0), ("420", 420.0)].map(|(text, x)| (x, folds(text, "1e-3")[0])) {
        assert!(l.loci.iter().flat_map(|l| &l.points).any(|p| p.value == chi && (p.speed / speed - 1.0).abs() < 1e-10), "{chi} {speed}");
    }
}

fn two_axes(swap: bool) -> Builder {
    let two = |a: f64, b: f64| if swap { [b, a] } else { [a, b] };
    let link = || Link::Between(Attach::on("drum"), Attach::on("base"));
    Builder::new("two axes")
        .part("drum", Disc::planar(), DiscParams { eccentricity: 5e-5, ..DiscParams::new(2.4) })
        .part("base", Foundation, FoundationParams { mass: 25.0, stiffness: two(3e5, 5e5), damping: two(7.0, 9.0) })
        .part(
            "bearing",
            BearingCubic::per_axis(link()),
            BearingCubicParams { stiffness: two(1.1e7, 1.5e7), cubic_stiffness: two(8.7e10, 5e10), valid_to: 0.0 },
        )
        .part(
            "air",
            Damper::fixed(Link::Between(Attach::on("drum"), Attach::ground())),
            DamperParams { damping: two(60.0, 80.0), tilt_damping: 0.0 },
        )
}

#[test]
fn exchange_of_the_axes_changes_nothing() {
    let [a, b] = [false, true].map(|swap| found(two_axes(swap), &ask((1500.0, 3500.0), "drum.eccentricity", (5e-6, 5e-5), 3)));
    assert_eq!(a.discretisation.symmetry, Symmetry::Half);
    let sorted = |l: &Loci| {
        let mut all: Vec<[f64; 2]> = cusps(l).iter().map(|c| [c.speed, c.turn.value]).collect();
        all.sort_by(|a, b| a[0].total_cmp(&b[0]));
        all
    };
    let (a, b) = (sorted(&a), sorted(&b));
    // one for each plane
    assert!(a.len() == 2 && b.len() == 2, "{a:?} {b:?}");
    for (x, y) in a.iter().flatten().zip(b.iter().flatten()) {
        near(*x, *y, 1e-10);
    }
}

/// A parameter of one axis breaks the symmetry that the machine has at its own value.
#[test]
fn one_axis_alone() {
    let base = Base { e: 5e-5, chi: 100.0, ..Base::default() };
    let l = found(base.builder(), &ask((1500.0, 4000.0), "bearing.cubic_stiffness.x", (5e10, 8e10), 2));
    assert_eq!(l.discretisation.symmetry, Symmetry::Half);
    let both = found(base.builder(), &ask((1500.0, 4000.0), "bearing.cubic_stiffness", (5e10, 8e10), 2));
    assert_eq!(both.discretisation.symmetry, Symmetry::Quarter);
    // the planes of an empty rotor share nothing but the force: x folds as in the machine that has its stiffness in both, y where it always does
    let at = |l: &Loci, value: f64| {
        let mut v: Vec<f64> = l.loci.iter().flat_map(|l| &l.points).filter(|p| p.value == value).map(|p| p.speed).collect();
        v.sort_by(f64::total_cmp);
        v
    };
    for value in [5e10, 8e10] {
        for speed in at(&both, value) {
            assert!(at(&l, value).iter().any(|s| (s / speed - 1.0).abs() < 1e-10), "{value} {speed} {:?}", at(&l, value));
        }
    }
}

#[test]
fn unit_of_length_is_free() {
    let of = |metre: f64| {
        let base = Base { e: 5e-5, metre, fill: Some(0.667), wave_damping: 5.0, isotropic: true, ..Base::default() };
        let l = found(base.builder(), &ask((1500.0, 3500.0), "drum.eccentricity", (5e-6 / metre, 5e-5 / metre), 3));
        let [at] = &cusps(&l)[..] else { panic!("{metre}: {}", l.loci.len()) };
        [at.speed, at.turn.value * metre]
    };
    let one = of(1.0);
    for metre in [0.1, 2.0] {
        for (a, b) in of(metre).into_iter().zip(one) {
            near(a, b, 1e-9);
        }
    }
}

#[test]
fn rotation_the_other_way_round() {
    let [a, b] = [(1500.0, 4000.0), (-4000.0, -1500.0)].map(|speeds| {
        let l = found(Base { e: 5e-5, ..Base::default() }.builder(), &ask(speeds, "drum.eccentricity", (8e-6, 5e-5), 2));
        let [at] = &cusps(&l)[..] else { panic!() };
        [at.speed.abs(), at.turn.value]
    });
    near(a[0], b[0], 1e-11);
    near(a[1], b[1], 1e-11);
}

/// A Neimark-Sacker locus of the filled rotor over the damping, against direct location at some of its points and the tabulated place.
#[test]
fn neimark_sacker_agrees_with_single_responses() {
    let speeds = (1500.0, 3000.0);
    for (isotropic, reference) in [(true, Some(0.964_900_591_55)), (false, None)] {
        let base = Base { isotropic, fill: Some(0.667), ..Base::default() };
        let ask = Request { stability: true, truncation: 1e-7, ..ask(speeds, "air.damping", (42.0, 200.0), 2) };
        let l = found(base.builder(), &ask);
        let kind = LocusKind::Change(Event::NeimarkSacker);
        let ns: Vec<&Locus> = l.loci.iter().filter(|l| l.kind == kind).collect();
        assert!(!ns.is_empty(), "{isotropic}");
        for locus in &ns {
            assert!(locus.points.iter().all(|p| p.crossing.is_some_and(|c| c.0.abs() < 1e-9 && c.1 > 100.0)), "{isotropic}");
            assert!(locus.assessed_again.1 >= 2 && locus.assessed_again.0 < 1e-9, "{:?}", locus.assessed_again);
        }
        // no locus twice: of two that cover a value, the speeds differ
        for (i, a) in ns.iter().enumerate() {
            for b in &ns[i + 1..] {
                let [a, b] = [a, b].map(|l| l.points.iter().find(|p| p.value == 42.0 || p.value == 200.0).unwrap());
                assert!((a.value != b.value) || (a.speed - b.speed).abs() > 1.0, "{} {}", a.speed, b.speed);
            }
        }
        let d = l.discretisation;
        for (speed, value) in some_points(&l, kind, 2) {
            let request = response::Request { harmonics: Some(d.harmonics), ..request(speeds.0, speeds.1) };
            let r = run(Base { chi: value, ..base }.builder(), request);
            let changes: Vec<f64> =
                r.branches.iter().flat_map(|b| &b.changes).filter(|c| c.event == Event::NeimarkSacker).map(|c| c.speed).collect();
            let nearest = changes.iter().copied().min_by(|a, b| (a - speed).abs().total_cmp(&(b - speed).abs())).unwrap_or(f64::NAN);
            // a response places a change where the growth rate equals the error of the map, not at zero
            let beside: Vec<_> = r
                .branches
                .iter()
                .flat_map(|b| b.points.windows(2))
                .filter(|w| (w[0].speed - nearest) * (w[1].speed - nearest) <= 0.0)
                .collect();
            let slope =
                beside.iter().map(|w| ((w[0].growth() - w[1].growth()) / (w[0].speed - w[1].speed)).abs()).fold(f64::INFINITY, f64::min);
            let error = beside.iter().map(|w| w[0].exponents.as_ref().unwrap().error).fold(0.0, f64::max);
            assert!((speed - nearest).abs() <= 1.5 * error / slope + 1e-9 * speed, "{speed} {nearest} {slope} {error}");
        }
        if let Some(s) = reference {
            let unit = (1.1e7f64 / 2.4).sqrt();
            let at: Vec<f64> = ns.iter().flat_map(|l| &l.points).filter(|p| p.value == 42.0).map(|p| p.speed / unit).collect();
            assert!(at.iter().any(|x| (x - s).abs() < 1e-8), "{at:?}");
        }
    }
}

#[test]
fn work_limit_and_cancelling_keep_what_was_done() {
    let system = Base { e: 5e-5, ..Base::default() }.builder().build().unwrap();
    let whole = ask((1500.0, 4000.0), "drum.eccentricity", (8e-6, 1e-4), 3);
    let never = AtomicBool::new(false);
    for work in [1, 7, 60, 250] {
        let l = loci(&system, &Request { work, ..whole.clone() }, &never, &|_| {}).unwrap();
        let done: u64 = l.work.iter().map(|w| w.1).sum();
        assert!(l.stopped || l.loci.iter().any(|l| l.ends.contains(&PathEnd::MaxPoints)), "{work}");
        assert!(l.work[0].1 <= work + 3 && done > 0, "{work} {:?}", l.work);
    }
    let cancel = AtomicBool::new(false);
    let l = loci(&system, &whole, &cancel, &|done| cancel.store(done > 150, Ordering::Relaxed)).unwrap();
    assert!(l.stopped);
}

fn file(parameter: &str, more: &str) -> String {
    let (rotor, oil) = (planar_file("isotropic", "1 mm", ["42", "6.59"]), oil("46.69 mm", "0"));
    format!(
        r#"{rotor}{oil}
[[study]]
kind = "bifurcation_loci"
speed = {{ from = "1500 rad/s", to = "4000 rad/s" }}
parameter = {parameter}
{more}
"#
    )
}

fn study(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{}", render(&d, text, "m.toml", Form::Lines)));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("loci")).unwrap_or_else(|d| panic!("{d:?}"))
}

/// The fill does not move the folds of an undamped liquid; the range ends where the cavity is empty.
#[test]
fn a_range_beyond_the_machine_is_reported() {
    let o = study(&file(r#"{ parameter = "oil.free_surface_radius", from = "20 mm", to = "80 mm", points = 4 }"#, r#"kinds = "folds""#));
    assert_eq!(o.end, End::Reached);
    let ids: Vec<&str> = o.findings.iter().map(|f| f.id.as_str()).collect();
    assert!(ids.contains(&"parameter_range") && ids.contains(&"fold_locus"), "{ids:?}");
    let t = o.find_table("loci").unwrap();
    let Data::Float(speeds) = &t.column("speed").unwrap().data else { panic!() };
    let want = common::number(common::rows(include_str!("../reference/planar/folds.csv")).iter().find(|r| r[0] == "0.8").unwrap()[4]);
    for s in speeds {
        near(*s, want, 1e-9);
    }
    let Data::Float(radii) = &t.column("oil.free_surface_radius").unwrap().data else { panic!() };
    let (lo, hi) = radii.iter().fold((1.0f64, 0.0f64), |(a, b), r| (a.min(*r), b.max(*r)));
    let samples = o.find_table("starts").unwrap().rows();
    assert_eq!(samples, 3);
    assert!(lo == 0.02 && hi < 0.07 && hi > 0.0699, "{lo} {hi}");
}

#[test]
fn texts() {
    let sentences = |o: &Outcome| o.findings.iter().map(|f| format!("{}: {}", f.id, f.sentence())).collect::<Vec<_>>().join("\n");
    let e = study(&file(r#"{ parameter = "drum.eccentricity", from = "2 um", to = "60 um", points = 3 }"#, ""));
    let none = study(&file(r#"{ parameter = "drum.eccentricity", from = "1 um", to = "3 um", points = 3 }"#, r#"kinds = "folds""#));
    let fill = study(&file(r#"{ parameter = "oil.free_surface_radius", from = "40 mm", to = "75 mm", points = 3 }"#, ""));
    let refused = |text: &str| {
        let loaded = match load(text) {
            Ok(loaded) => loaded,
            Err(d) => return render(&d, text, "m.toml", Form::Lines),
        };
        loaded.refusals().into_iter().map(|r| r.diagnostic.to_string()).collect::<Vec<_>>().join("; ")
    };
    let refusals = [
        file(r#"{ parameter = "drum.excentricity", from = "1 um", to = "3 um" }"#, ""),
        file(r#"{ parameter = "drum.mass", from = "3 kg", to = "2 kg", points = 1000 }"#, ""),
        file(r#"{ parameter = "oil.free_surface_radius", from = "80 mm", to = "90 mm" }"#, ""),
    ];
    let refusals = refusals.map(|text| refused(&text)).join("\n");
    insta::assert_snapshot!(format!(
        "over the eccentricity\n{}\n\nbelow the cusp\n{}\n\nover the fill\n{}\n\nrefused\n{refusals}",
        sentences(&e),
        sentences(&none),
        sentences(&fill)
    ));
}
