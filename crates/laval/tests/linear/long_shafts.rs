//! Shafts of many stations: sparse results against dense ones and closed forms, and how the work grows with the number of stations.

use crate::common::files::load;
use laval::model::blocks::Grid;
use laval::model::linear::{Form, LinearModel, LinearScratch};
use laval::model::system::System;
use laval::solve::characteristic::{Characteristic, Equilibrium, Frame};
use laval::solve::linear_response::response;
use laval::solve::rest::rest;
use laval::study::Cancel;
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};
use laval_num::work::watched;
use std::f64::consts::PI;

const LENGTH: f64 = 1.5;
const RADIUS: f64 = 0.025;
const MODULUS: f64 = 2.1e11;
const DENSITY: f64 = 7800.0;
const SUPPORT: f64 = 2e6;

/// A round shaft of equal beam elements without shear, its mass at the stations, on two damped bearings; with an unbalance in the middle and, on request, a foundation
/// below both bearings. `plain` leaves out what a slender beam on springs does not have: rotary inertia and damping.
fn shaft(stations: usize, founded: bool, plain: bool) -> System {
    let (area, second) = (PI * RADIUS.powi(2), 0.25 * PI * RADIUS.powi(4));
    let step = LENGTH / (stations - 1) as f64;
    let mut text = String::from("[machine]\nname = \"shaft\"\nspeed = \"3000 rpm\"\naxis = \"vertical\"\n");
    for k in 0..stations {
        let share = if k == 0 || k + 1 == stations { 0.5 } else { 1.0 };
        let mass = share * DENSITY * area * step;
        let unbalance = if k == stations / 2 { "unbalance = \"20 g mm\"\n" } else { "" };
        text += &format!(
            "[[part]]\nkind = \"disc\"\nname = \"n{k}\"\nmass = {mass}\ndiametral_inertia = {}\npolar_inertia = {}\n{unbalance}",
            0.25 * mass * RADIUS.powi(2) * if plain { 1e-6 } else { 1.0 },
            if plain { 0.0 } else { 0.5 * mass * RADIUS.powi(2) }
        );
    }
    let bending = MODULUS * second;
    for k in 1..stations {
        text += &format!(
            "[[part]]\nkind = \"shaft_lumped\"\nname = \"e{k}\"\nbetween = [{{ body = \"n{k}\", at = {} }}, {{ body = \"n{}\", at = {} }}]\n\
             stiffness = {}\ntilt_stiffness = {}\n",
            -0.5 * step,
            k - 1,
            0.5 * step,
            12.0 * bending / step.powi(3),
            bending / step
        );
    }
    let foot = if founded { "base" } else { "ground" };
    for k in [0, stations - 1] {
        text += &format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"b{k}\"\nbetween = [\"n{k}\", \"{foot}\"]\nkxx = {SUPPORT}\nkyy = {}\ncxx = {}\ncyy = 400.0\n",
            1.2 * SUPPORT,
            if plain { 0.0 } else { 300.0 }
        );
    }
    if founded {
        text += "[[part]]\nkind = \"disc\"\nname = \"base\"\nmass = 80.0\n[[part]]\nkind = \"bearing_linear\"\nname = \"soil\"\nbetween = [\"base\", \"ground\"]\nkxx = 5e7\nkyy = 6e7\ncxx = 2e4\ncyy = 2e4\n";
    }
    load(&text).system
}

/// Forced responses by the sparse factorisation are those of the dense matrix.
#[test]
fn responses_are_those_of_the_dense_matrix() {
    for (stations, founded) in [(3, false), (11, true), (51, false), (51, true)] {
        let system = shaft(stations, founded, false);
        let (mut model, mut scratch, mut grid) = (LinearModel::default(), LinearScratch::default(), Grid::empty());
        for speed in [40.0, 150.0, 400.0, 900.0, 2500.0] {
            let found = response(&system, &|w| rest(&system, w), speed).unwrap().unwrap();
            system.linear(system.params(), speed, Form::Frequency, &mut model, &mut scratch);
            system.dynamic_stiffness(system.params(), &model, Form::Frequency, c(0.0, speed), &mut grid, &mut scratch);
            let n = system.n();
            let z = Mat::from_fn(n, n, |i, j| grid[(i, j)]);
            let mut x: Vec<C64> = (0..n).map(|i| c(model.loads.force_cos[i], -model.loads.force_sin[i])).collect();
            Lu::new(&z).unwrap().solve(&mut x);
            let size = x.iter().map(|x| x.abs()).fold(0.0, f64::max);
            // the stiffness of one element over that of the supports is lost to rounding
            let lost = 1e-15 * 12.0 * MODULUS * 0.25 * PI * RADIUS.powi(4) / (LENGTH / (stations - 1) as f64).powi(3) / SUPPORT;
            let worst = x.iter().zip(&found.x).map(|(a, b)| (*a - *b).abs()).fold(0.0, |m: f64, x| if x > m || x.is_nan() { x } else { m });
            assert!(worst <= (1e-11 + 100.0 * lost) * size, "{stations} stations at {speed}: {:e}", worst / size);
            assert!(found.residual < 1e-9, "{:e}", found.residual);
        }
    }
}

fn units(f: impl FnOnce()) -> u64 {
    let stop = Cancel::default();
    watched(Some(&stop), u64::MAX, f).unwrap();
    stop.spent()
}

/// Twice the stations are twice the work, of responses and of the test function whose zeros are roots.
#[test]
fn work_grows_with_the_number_of_stations() {
    let spent = |stations: usize| {
        let system = shaft(stations, true, false);
        let responses = units(|| {
            for k in 0..40 {
                response(&system, &|w| rest(&system, w), 100.0 + 20.0 * f64::from(k)).unwrap().unwrap();
            }
        });
        let about = Equilibrium::zero(&system, Frame::Fixed, 300.0);
        let roots = units(|| {
            let mut t = Characteristic::new(&system, &about);
            let all: Vec<usize> = (0..t.size()).collect();
            let border = t.border(c(-2.0, 430.0), &all).unwrap();
            for k in 0..10 {
                assert!(t.test(c(-2.0, 430.0 + f64::from(k)), &border).is_some());
            }
        });
        let system = shaft(stations, false, false);
        let n = system.n();
        assert!(system.assembly(Form::Frequency).pattern.entries() <= 12 * n, "{}", system.assembly(Form::Frequency).pattern.entries());
        [responses, roots]
    };
    let (short, long) = (spent(60), spent(120));
    for (s, l) in short.iter().zip(&long) {
        assert!(*s > 0 && *l as f64 <= 2.3 * *s as f64, "{short:?} {long:?}");
    }
}

/// Bending frequencies of a beam on two springs: zeros of the determinant over `cos, sin, cosh, sinh` of its closed form, without rotary inertia.
#[test]
fn roots_converge_to_the_beam() {
    let (area, second) = (PI * RADIUS.powi(2), 0.25 * PI * RADIUS.powi(4));
    let bending = MODULUS * second;
    // y = A cos + B sin + C cosh + D sinh of b z: no moment at the ends, shear force -k y below, k y above
    let determinant = |w: f64| {
        let b = (DENSITY * area * w * w / bending).powf(0.25);
        let (x, k) = (b * LENGTH, SUPPORT / (bending * b.powi(3)));
        let (co, s, ch, sh) = (x.cos(), x.sin(), x.cosh(), x.sinh());
        let rows = [[-1.0, 0.0, 1.0, 0.0], [-co, -s, ch, sh], [k, -1.0, k, 1.0], [s - k * co, -co - k * s, sh - k * ch, ch - k * sh]];
        Lu::new(&Mat::from_fn(4, 4, |i, j| rows[i][j])).map_or(0.0, |lu| lu.det())
    };
    let mut exact = Vec::new();
    let grid = |k: usize| 20.0 + 2.0 * k as f64;
    for k in 0..1200 {
        let (mut a, mut b) = (grid(k), grid(k + 1));
        if determinant(a) * determinant(b) > 0.0 {
            continue;
        }
        for _ in 0..60 {
            let m = 0.5 * (a + b);
            if determinant(a) * determinant(m) > 0.0 { a = m } else { b = m }
        }
        exact.push(a);
    }
    assert!(exact.len() >= 3, "{exact:?}");
    let errors = |stations: usize| -> Vec<f64> {
        let system = shaft(stations, false, true);
        let about = Equilibrium::zero(&system, Frame::Fixed, 0.0);
        let root = |w: f64| Characteristic::new(&system, &about).polish(c(0.0, w), None).unwrap().value.im;
        exact.iter().take(3).map(|&w| (root(w) / w - 1.0).abs()).collect()
    };
    let (coarse, middle, fine) = (errors(25), errors(49), errors(97));
    for k in 0..3 {
        // masses at the stations: the error falls with the square of their distance
        for ratio in [coarse[k] / middle[k], middle[k] / fine[k]] {
            assert!((3.5..4.5).contains(&ratio), "mode {k}: {coarse:?} {middle:?} {fine:?}");
        }
    }
}
