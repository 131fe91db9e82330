//! Places near roots of a machine: the poles of its response.
//!
//! ```text
//! g(i w) = l^T T(i w)^-1 r      is approximated by a rational function of i w; its poles are near the roots of det T that show in the response
//! ```
//!
//! Roots that decay slowly make the peaks of the response, so that of these none is likely to be overlooked, narrower than
//! the grid or not; what decays fast beside them may be.
//!
//! Source of the approximation: as of [`laval_num::rational`].

use super::characteristic::Characteristic;
use super::spectra_ahead::together;
use laval_num::complex::{C64, c};
use laval_num::dense::{Lu, Mat};
use laval_num::rational::poles;

/// Frequencies of the grid: at even distances, and at even ratios.
const EVEN: usize = 160;
const RATIOS: usize = 60;
/// Least frequency over the largest.
const LEAST: f64 = 1e-4;
/// Relative error allowed, and most poles.
const ERROR: f64 = 1e-7;
const MOST: usize = 28;
/// Frequencies that one thread evaluates together.
const PIECE: usize = 16;
/// Poles farther than this from the axis, over the largest frequency, are of no use.
const FAR: f64 = 0.5;

/// Poles of responses between some of the unknowns (`members`) up to a frequency; `usual` is where most of the machine's modes lie below.
pub(super) fn resonances(t: &mut Characteristic, members: &[usize], mirrored: bool, (usual, frequency): (f64, f64)) -> Vec<C64> {
    let usual = usual.min(frequency);
    let even = (0..EVEN).map(|k| (k as f64 + 0.5) / EVEN as f64 * usual);
    let ratios = (0..RATIOS).map(|k| frequency * LEAST.powf(k as f64 / RATIOS as f64));
    let upper: Vec<f64> = even.chain(ratios).collect();
    let grid: Vec<f64> = if mirrored { upper } else { upper.iter().flat_map(|&w| [w, -w]).collect() };
    let probes = Probes::new(t, members, usual);
    let pieces: Vec<&[f64]> = grid.chunks(PIECE).collect();
    let of_piece = |piece: &&[f64]| {
        let (mut t, mut value, mut slope) = (t.clone(), Mat::default(), Mat::default());
        piece.iter().filter_map(|&w| probes.at(&mut t, w, &mut value, &mut slope)).collect::<Vec<_>>()
    };
    let known: Vec<(C64, [C64; 2])> = together(&pieces, of_piece).concat();
    let x: Vec<C64> = known.iter().map(|k| k.0).collect();
    let of = |which: usize| {
        let f: Vec<C64> = known.iter().map(|k| k.1[which]).collect();
        let weights: Vec<f64> = f.iter().map(|f| f.abs().recip()).collect();
        poles(&x, &f, &weights, ERROR, MOST).unwrap_or_default()
    };
    let mut all = of(0);
    all.extend(of(1));
    all.retain(|z| z.is_finite() && z.re.abs() <= FAR * frequency && z.im.abs() <= frequency);
    all
}

/// The responses that are looked at.
struct Probes<'a> {
    members: &'a [usize],
    /// Loads, and weights of what they move, of each of two.
    loads: [Vec<C64>; 2],
    weights: [Vec<C64>; 2],
}

impl<'a> Probes<'a> {
    fn new(t: &mut Characteristic, members: &'a [usize], usual: f64) -> Self {
        let (mut value, mut slope) = (Mat::default(), Mat::default());
        t.at(c(0.0, 0.317 * usual), &mut value, &mut slope);
        // displacements and tilts alike
        let size = |i: usize| Some(value[(i, i)].abs().sqrt()).filter(|x| *x > 0.0 && x.is_finite()).unwrap_or(1.0);
        let mixed = |turn: f64| members.iter().enumerate().map(|(k, &i)| C64::cis(turn * (k as f64 + 0.4)).scale(size(i))).collect();
        Probes { loads: [mixed(0.7), mixed(2.3)], weights: [mixed(1.9), mixed(-1.1)], members }
    }

    fn at(&self, t: &mut Characteristic, w: f64, value: &mut Mat<C64>, slope: &mut Mat<C64>) -> Option<(C64, [C64; 2])> {
        let s = c(0.0, w);
        t.at(s, value, slope);
        let k = self.members.len();
        let own = Mat::from_fn(k, k, |i, j| value[(self.members[i], self.members[j])]);
        let lu = Lu::new(&own).ok()?;
        let out = [0, 1].map(|which| {
            let mut x = self.loads[which].clone();
            lu.solve(&mut x);
            x.iter().zip(&self.weights[which]).fold(C64::zero(), |sum, (x, l)| sum + *x * *l)
        });
        out.iter().all(|z| z.is_finite() && z.abs() > 0.0).then_some((s, out))
    }
}
