//! The middle range by the trapezoidal rule, which converges geometrically for both integrals; all nodes side by side.
//!
//! ```text
//! I_n(z) exp(-z) = 1/pi int_0^pi exp(z (cos t - 1)) cos(n t) dt             32 nodes, error I_(64-n)
//! K_0(z) exp(z)  =   int exp(-s^2) (s^2 + 2 z)^(-1/2) ds over all s
//! K_1(z) exp(z)  = z^(-1) int exp(-s^2) s^2 (s^2 + 2 z)^(1/2) ds            (DLMF 10.32.8, with t = 1 + s^2/z)
//! ```
//!
//! The branch points `s^2 = -2 z` lie `d = sqrt(|z| + Re z)` from the real axis: with nodes at distances h the error of K is
//! `exp(d^2 - 2 pi d/h)`, at most `exp(-pi^2/h^2)`.

use crate::complex::{C64, Complex, c};
use crate::lanes::{Kernel, LANES, LaneScalar, Level, dispatch};
use crate::scalar::Scalar;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Square of the distance of the branch points from which on [`middle`] serves.
pub(super) const CLOSEST: f64 = 1.5;
/// The same from which on half of the nodes of K serve.
pub(super) const CLOSE: f64 = 8.3;

/// Squares of the nodes of K with their weights; the last node is near 6.5, where s^3 exp(-s^2) is below rounding.
struct Nodes {
    square: [[f64; LANES]; 2],
    weight: [[f64; LANES]; 2],
}

fn nodes(blocks: usize) -> Nodes {
    let h = 6.5 / (blocks * LANES) as f64;
    // both halves of the line
    let square = std::array::from_fn(|b| std::array::from_fn(|l| (((b * LANES + l) as f64 + 0.5) * h).powi(2)));
    Nodes { square, weight: square.map(|block: [f64; LANES]| block.map(|s| 2.0 * h * (-s).exp())) }
}

struct Tables {
    /// Cosines of the nodes of I below a quarter turn: those beyond it have the opposite sign.
    cosine: [f64; LANES],
    /// `cos(2 t)` there.
    twice: [f64; LANES],
    few: Nodes,
    many: Nodes,
}

impl Tables {
    /// Nodes of K, and their blocks.
    fn of(&self, close: bool) -> (&Nodes, usize) {
        if close { (&self.many, 2) } else { (&self.few, 1) }
    }
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let at = |l: usize| (l as f64 + 0.5) * PI / (2 * LANES) as f64;
    Tables {
        cosine: std::array::from_fn(|l| at(l).cos()),
        twice: std::array::from_fn(|l| (2.0 * at(l)).cos()),
        few: nodes(1),
        many: nodes(2),
    }
});

/// I of orders 0, 1, 2 and K of orders 0, 1, scaled, for Re z >= 0, |z| + Re z at least [`CLOSEST`] and |z| up to 25.
pub(super) fn middle(z: C64, size: f64) -> [C64; 5] {
    let distance = size + z.re;
    let tables = &*TABLES;
    let (nodes, blocks) = tables.of(distance < CLOSE);
    let [i0, i1, i2, k0, k1] = dispatch(Level::best(), Middle { z, down: z.scale(-2.0).exp(), tables, nodes, blocks });
    [i0, i1, i2, k0, k1 * z.recip()]
}

/// K of orders 0 and 1, scaled, for the same arguments, in lanes that hold an argument each; `close` where one of them lies closer than [`CLOSE`].
#[inline(always)]
pub(super) fn at_nodes<S: Scalar>(z: Complex<S>, close: bool) -> [Complex<S>; 2] {
    let (nodes, blocks) = TABLES.of(close);
    let (x0, y) = (z.re.scale(2.0), z.im.scale(2.0));
    let (square_y, half_y) = (y * y, z.im);
    let (mut k0, mut k1) = (Complex::zero(), Complex::zero());
    for b in 0..blocks {
        for l in 0..LANES {
            let (s, weight) = (nodes.square[b][l], nodes.weight[b][l]);
            let x = x0 + S::cst(s);
            let modulus = (x * x + square_y).sqrt();
            let re = ((modulus + x).scale(0.5)).sqrt();
            let root = c(re, half_y / re);
            k0 += root.conj().scale(S::cst(weight) / modulus);
            k1 += root.scale(S::cst(weight * s));
        }
    }
    [k0, k1 * z.recip()]
}

struct Middle<'a> {
    z: C64,
    /// `exp(-2 z)`.
    down: C64,
    tables: &'a Tables,
    nodes: &'a Nodes,
    blocks: usize,
}

impl Kernel for Middle<'_> {
    type Out = [C64; 5];
    #[inline(always)]
    fn run<S: LaneScalar>(self) -> [C64; 5] {
        let Middle { z, down, tables, nodes, blocks } = self;
        let (one, half) = (S::cst(1.0), S::cst(0.5));
        let (cosine, twice) = (S::load(&tables.cosine), S::load(&tables.twice));
        // exp(z (cos t - 1)), and exp(-z (cos t + 1)) of the node beyond the quarter turn
        let below = cosine - one;
        let size = (S::cst(z.re) * below).exp();
        let (sin, cos) = (S::cst(z.im) * below).sin_cos();
        let (re, im) = (size * cos, size * sin);
        let back = one / size;
        let (back_re, back_im) = (back * cos, -(back * sin));
        let (down_re, down_im) = (S::cst(down.re), S::cst(down.im));
        let beyond_re = down_re * back_re - down_im * back_im;
        let beyond_im = down_re * back_im + down_im * back_re;
        let (even_re, even_im, odd_re, odd_im) = (re + beyond_re, im + beyond_im, re - beyond_re, im - beyond_im);
        let i = [
            [total(even_re), total(even_im)],
            [total(odd_re * cosine), total(odd_im * cosine)],
            [total(even_re * twice), total(even_im * twice)],
        ];
        let (mut k0, mut k1) = ([S::cst(0.0); 2], [S::cst(0.0); 2]);
        let y = S::cst(2.0 * z.im);
        let square_y = y * y;
        for b in 0..blocks {
            let (s, weight) = (S::load(&nodes.square[b]), S::load(&nodes.weight[b]));
            let x = s + S::cst(2.0 * z.re);
            // square root of x + i y, Re > 0, and its reciprocal
            let modulus = (x * x + square_y).sqrt();
            let re = (half * (modulus + x)).sqrt();
            let im = half * y / re;
            let each = weight / modulus;
            k0[0] += each * re;
            k0[1] -= each * im;
            let each = weight * s;
            k1[0] += each * re;
            k1[1] += each * im;
        }
        let i = i.map(|[re, im]| c(re, im).scale(0.5 / LANES as f64));
        [i[0], i[1], i[2], c(total(k0[0]), total(k0[1])), c(total(k1[0]), total(k1[1]))]
    }
}

/// Sum over the lanes, by halves.
#[inline(always)]
fn total<S: LaneScalar>(x: S) -> f64 {
    let mut x = x.to_array();
    let mut half = LANES / 2;
    while half > 0 {
        for l in 0..half {
            x[l] += x[l + half];
        }
        half /= 2;
    }
    x[0]
}
