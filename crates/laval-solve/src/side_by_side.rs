//! Roots of a large machine side by side: as many as there are lanes are polished together, and the characteristic function is evaluated at as many places together.
//!
//! Theory: `docs/theory/linear-vibration.md#machines-with-many-coordinates`.

use crate::border::Border;
use crate::characteristic::{Characteristic, Polished};
use crate::sectors::Sector;
use crate::spectra_ahead::together;
use laval_num::complex::C64;
use laval_num::contour::Sample;
use laval_num::eig::{self, Quadratic, Start};
use laval_num::factor::{Directed, LaneFactors, ScaledQuadratic, Selection};
use laval_num::lanes::LANES;
use std::sync::Arc;

/// T as a polynomial over the unknowns of a sector.
pub struct Block {
    /// The unknowns.
    pub of: Arc<Selection>,
    terms: [Vec<C64>; 3],
}

impl Block {
    /// Of a machine whose T is a polynomial that suits lanes.
    pub fn new(t: &Characteristic, sector: Option<Sector>) -> Option<Self> {
        let terms = t.as_polynomial()?;
        let of = t.selection(&t.members(sector));
        of.inner.suits_lanes().then(|| Block { terms: terms.each_ref().map(|all| of.taken(all)), of })
    }

    fn scaled(&self, size: f64) -> Option<ScaledQuadratic> {
        Quadratic { plan: &self.of.inner, terms: self.terms.each_ref().map(Vec::as_slice) }.scaled(size)
    }
}

/// A place near a root, with both null vectors over all unknowns where they are known.
pub struct Near<'a> {
    /// s.
    pub value: C64,
    /// A root of the same unknowns, at this speed or at one beside.
    pub root: Option<&'a Polished>,
}

/// The roots that starts lead to. Where the iteration side by side does not settle, or T is no polynomial, each by itself, on all processors.
pub fn polish_all(t: &mut Characteristic, starts: &[Near], sector: Option<Sector>) -> Vec<Option<Polished>> {
    let mut out: Vec<Option<Polished>> = starts.iter().map(|_| None).collect();
    if starts.is_empty() {
        return out;
    }
    if let Some(block) = Block::new(t, sector) {
        polish_block(t, &block, starts, &mut out);
    }
    let left: Vec<usize> = (0..starts.len()).filter(|&k| out[k].is_none()).collect();
    let alone = |&k: &usize| {
        let (mut t, s) = (t.clone(), &starts[k]);
        match s.root {
            Some(root) => t.polish_with(s.value, root.border.clone()),
            None => t.polish(s.value, sector),
        }
    };
    for (&k, root) in left.iter().zip(together(&left, alone)) {
        out[k] = root;
    }
    out
}

fn polish_block(t: &Characteristic, block: &Block, starts: &[Near], out: &mut [Option<Polished>]) {
    let mut order: Vec<usize> = (0..starts.len()).collect();
    order.sort_by(|&a, &b| starts[a].value.abs().total_cmp(&starts[b].value.abs()));
    let mut factors = LaneFactors::default();
    for some in order.chunks(LANES) {
        let size = some.iter().map(|&k| starts[k].value.abs()).fold(0.0, f64::max);
        let Some(scaled) = block.scaled(size) else { continue };
        let vectors: Vec<Option<(Vec<C64>, Vec<C64>)>> =
            some.iter().map(|&k| starts[k].root.map(|r| (taken(&block.of, &r.right), taken(&block.of, &r.left)))).collect();
        let own: Vec<Start> = some
            .iter()
            .zip(&vectors)
            .map(|(&k, v)| Start { value: starts[k].value, vectors: v.as_ref().map(|(x, y)| (&x[..], &y[..])) })
            .collect();
        for (&k, root) in some.iter().zip(eig::polish(&scaled, &own, &mut factors)) {
            out[k] = root.and_then(|r| of_all(t, block, &scaled, r));
        }
    }
}

fn taken(of: &Selection, x: &[C64]) -> Vec<C64> {
    of.members.iter().map(|&i| x[i]).collect()
}

/// A root of a block over all unknowns.
fn of_all(t: &Characteristic, block: &Block, scaled: &ScaledQuadratic, root: eig::Root) -> Option<Polished> {
    let spread = |x: &[C64]| {
        let mut out = vec![C64::default(); t.size()];
        block.of.members.iter().zip(x).for_each(|(&i, &x)| out[i] = x);
        out
    };
    let border = Border::of(&block.of, (scaled.rows(), scaled.columns()), (&root.left, &root.right))?;
    Some(Polished {
        value: root.value,
        right: spread(&root.right),
        left: spread(&root.left),
        defect: root.defect,
        step: root.step,
        iterations: root.shifts,
        by_s: root.by_s,
        border,
    })
}

/// The determinant of a block at many places together.
pub struct Determinants {
    scaled: ScaledQuadratic,
    factors: LaneFactors<Directed>,
}

impl Determinants {
    /// For places of some size.
    pub fn new(block: &Block, size: f64) -> Option<Self> {
        Some(Determinants { scaled: block.scaled(size)?, factors: LaneFactors::default() })
    }

    /// At up to as many places as there are lanes; `None` where digits were lost.
    pub fn at(&mut self, places: &[C64]) -> [Option<Sample>; LANES] {
        self.factors.factor(&self.scaled, places);
        self.factors.turns()
    }
}
