//! The coefficients against all order conditions: every rooted tree up to the order, generated here.

use super::super::{radau, tableau as t8};
use super::{Mat, distance};

/// A rooted tree: its number of vertices, its density gamma, and the trees left when the root is cut off.
struct Tree {
    order: usize,
    gamma: f64,
    children: Vec<usize>,
}

fn trees(max: usize) -> Vec<Tree> {
    fn forests(all: &[Tree], from: usize, left: usize, chosen: &mut Vec<usize>, out: &mut Vec<Vec<usize>>) {
        if left == 0 {
            out.push(chosen.clone());
        }
        for i in from..all.len() {
            if all[i].order <= left {
                chosen.push(i);
                forests(all, i, left - all[i].order, chosen, out);
                chosen.pop();
            }
        }
    }
    let mut all: Vec<Tree> = Vec::new();
    for order in 1..=max {
        let mut out = Vec::new();
        forests(&all, 0, order - 1, &mut Vec::new(), &mut out);
        for children in out {
            let gamma = children.iter().fold(order as f64, |g, &c| g * all[c].gamma);
            all.push(Tree { order, gamma, children });
        }
    }
    all
}

/// Elementary weights of the stages: product over the children of A phi.
fn weights(trees: &[Tree], a: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut phi: Vec<Vec<f64>> = Vec::new();
    for t in trees {
        let of = |i: usize| t.children.iter().map(|&c| dot(&a[i], &phi[c])).product();
        phi.push((0..a.len()).map(of).collect());
    }
    phi
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn expand(row: &[(usize, f64)]) -> Vec<f64> {
    let mut out = vec![0.0; 16];
    for &(i, a) in row {
        out[i] = a;
    }
    out
}

fn dop853() -> Vec<Vec<f64>> {
    let rows: [&[(usize, f64)]; 16] = [
        &[],
        &t8::A1,
        &t8::A2,
        &t8::A3,
        &t8::A4,
        &t8::A5,
        &t8::A6,
        &t8::A7,
        &t8::A8,
        &t8::A9,
        &t8::A10,
        &t8::A11,
        &t8::B,
        &t8::A13,
        &t8::A14,
        &t8::A15,
    ];
    rows.iter().map(|r| expand(r)).collect()
}

/// Largest error of the order conditions of exactly `order` at the point `x` of the step.
fn defect(trees: &[Tree], phi: &[Vec<f64>], b: &[f64], order: usize, x: f64) -> f64 {
    let of = trees.iter().zip(phi).filter(|(t, _)| t.order == order);
    of.map(|(t, phi)| (dot(b, phi) - x.powi(order as i32) / t.gamma).abs()).fold(0.0, |m, d| if d <= m { m } else { d })
}

#[test]
fn there_are_as_many_trees_as_known() {
    let all = trees(9);
    let counts: Vec<usize> = (1..10).map(|n| all.iter().filter(|t| t.order == n).count()).collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115, 286]);
}

#[test]
fn nodes_are_row_sums_and_weights_integrate_powers() {
    for (i, row) in dop853().iter().enumerate() {
        assert!((row.iter().sum::<f64>() - t8::C[i]).abs() < 1e-14, "stage {i}");
    }
    let b = expand(&t8::B);
    for k in 0..8 {
        let sum: f64 = b.iter().zip(t8::C).map(|(b, c)| b * c.powi(k)).sum();
        assert!((sum - 1.0 / (k + 1) as f64).abs() < 1e-14, "power {k}: {sum}");
    }
}

#[test]
fn dop853_meets_all_order_conditions() {
    let (trees, a) = (trees(9), dop853());
    let phi = weights(&trees, &a);
    let b = expand(&t8::B);
    for order in 1..=8 {
        assert!(defect(&trees, &phi, &b, order, 1.0) < 1e-13, "order {order}");
    }
    assert!(defect(&trees, &phi, &b, 9, 1.0) > 1e-8);
    // embedded formulas: b - e5 of order 5, the other of order 3
    let b5: Vec<f64> = b.iter().zip(expand(&t8::E5)).map(|(b, e)| b - e).collect();
    let b3 = expand(&t8::BHH);
    for (weights, exact) in [(b5, 5), (b3, 3)] {
        for order in 1..=exact {
            assert!(defect(&trees, &phi, &weights, order, 1.0) < 1e-13, "order {order} of {exact}");
        }
        assert!(defect(&trees, &phi, &weights, exact + 1, 1.0) > 1e-6);
    }
}

#[test]
fn dop853_dense_output_is_of_order_seven() {
    let (trees, a) = (trees(8), dop853());
    let phi = weights(&trees, &a);
    let unit = |k: usize| (0..16).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
    let f0 = expand(&t8::B);
    let f1: Vec<f64> = unit(0).iter().zip(&f0).map(|(k, f)| k - f).collect();
    let f2: Vec<f64> = (0..16).map(|i| f0[i] - unit(12)[i] - f1[i]).collect();
    let rows = [f0, f1, f2, expand(&t8::D3), expand(&t8::D4), expand(&t8::D5), expand(&t8::D6)];
    for x in [0.1, 0.35, 0.5, 0.8, 0.95] {
        let b: Vec<f64> = (0..16)
            .map(|j| rows.iter().enumerate().rev().fold(0.0, |s, (i, f)| (s + f[j]) * if i % 2 == 0 { x } else { 1.0 - x }))
            .collect();
        for order in 1..=7 {
            assert!(defect(&trees, &phi, &b, order, x) < 1e-13, "order {order} at {x}");
        }
    }
}

#[test]
fn radau_is_collocation_of_order_five() {
    let c = radau::C;
    // A integrates quadratics exactly from 0 to the nodes, which determines it
    let lagrange = |j: usize, x: f64| -> f64 {
        // antiderivative of the j-th Lagrange polynomial
        let (p, q) = (c[(j + 1) % 3], c[(j + 2) % 3]);
        let d = (c[j] - p) * (c[j] - q);
        (x * x * x / 3.0 - (p + q) * x * x / 2.0 + p * q * x) / d
    };
    let a: Vec<Vec<f64>> = (0..3).map(|i| (0..3).map(|j| lagrange(j, c[i])).collect()).collect();
    let trees = trees(6);
    let phi = weights(&trees, &a);
    for order in 1..=5 {
        assert!(defect(&trees, &phi, &a[2], order, 1.0) < 1e-14, "order {order}");
    }
    assert!(defect(&trees, &phi, &a[2], 6, 1.0) > 1e-5);
    // T^-1 A^-1 T is the real eigenvalue and the block of the complex pair: A T D = T
    let z = radau::COMPLEX;
    let d = [[radau::REAL, 0.0, 0.0], [0.0, z.re, -z.im], [0.0, z.im, z.re]];
    let mat = |rows: [[f64; 3]; 3]| Mat::from_fn(3, 3, |i, j| rows[i][j]);
    let (t, a) = (mat(radau::T), Mat::from_fn(3, 3, |i, j| a[i][j]));
    assert!(distance(a.matmul(&t).matmul(&mat(d)).data(), t.data()) < 1e-14);
    assert!(distance(mat(radau::TI).matmul(&t).data(), Mat::identity(3).data()) < 1e-14);
}
