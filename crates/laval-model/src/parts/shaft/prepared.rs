//! Matrices of the elements of a shaft, kept for the values of its parameters that its machine has: speed, motion and loads do not change them.

use super::Shaft;
use super::element::{Element, M4, Plane};
use super::line::Line;
use crate::model::erased::D1;
use crate::model::part::Params;
use laval_num::scalar::Scalar;
use std::sync::Arc;

/// Everything that an element adds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Matrices<S> {
    pub plane: Plane<S>,
    /// Moment of inertia about the axis, kg m^2.
    pub spin_inertia: S,
    /// Of a unit torque through it, where the shaft transmits one.
    pub torque: Option<M4<f64>>,
    /// As far as the shaft has these coordinates.
    pub axial: Option<Line<S>>,
    pub torsional: Option<Line<S>>,
}

impl<S: Scalar> Matrices<S> {
    #[inline(always)]
    pub fn new(element: &Element<S>, shaft: &Shaft, torque: S) -> Self {
        Matrices {
            plane: element.plane(),
            spin_inertia: element.inertia().1,
            torque: (!torque.is_nothing()).then(|| element.torque()),
            axial: shaft.axial.then(|| element.axial()),
            torsional: shaft.torsional.then(|| element.torsional()),
        }
    }
}

impl Matrices<f64> {
    #[inline(always)]
    fn lifted<S: Scalar>(&self) -> Matrices<S> {
        let line = |l: Line<f64>| Line { mass: lifted(&l.mass), stiffness: lifted(&l.stiffness) };
        let Plane { mass, gyroscopic, stiffness, axial } = &self.plane;
        Matrices {
            plane: Plane { mass: lifted(mass), gyroscopic: lifted(gyroscopic), stiffness: lifted(stiffness), axial: lifted(axial) },
            spin_inertia: S::cst(self.spin_inertia),
            torque: self.torque,
            axial: self.axial.map(line),
            torsional: self.torsional.map(line),
        }
    }
}

/// Loops instead of `map`, which is a call for every number where it is compiled in another unit.
#[inline(always)]
fn lifted<S: Scalar, const N: usize>(m: &[[f64; N]; N]) -> [[S; N]; N] {
    let mut out = [[S::zero(); N]; N];
    for i in 0..N {
        for j in 0..N {
            out[i][j] = S::cst(m[i][j]);
        }
    }
    out
}

/// The matrices of all elements for some values of the parameters.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Prepared {
    params: Params<Shaft, f64>,
    different: Vec<Matrices<f64>>,
    /// Which of them each element has.
    which: Vec<usize>,
}

impl Prepared {
    pub fn new(shaft: &Shaft, params: &Params<Shaft, f64>) -> Self {
        let (mut different, mut which) = (Vec::new(), Vec::new());
        shaft.computed(params, |k, matrices| {
            if k == 0 || different.last() != Some(matrices) {
                different.push(*matrices);
            }
            which.push(different.len() - 1);
        });
        Prepared { params: params.clone(), different, which }
    }

    /// The parameters have these values and no derivatives.
    #[inline(always)]
    fn holds<S: Scalar>(&self, p: &Params<Shaft, S>) -> bool {
        let known = &self.params;
        let mut all = same(p.modulus, known.modulus)
            && same(p.shear_modulus, known.shear_modulus)
            && same(p.density, known.density)
            && same(p.torque, known.torque);
        for (s, k) in p.own.rows.iter().zip(&known.own.rows) {
            all = all
                && same(s.outer_diameter, k.outer_diameter)
                && same(s.inner_diameter, k.inner_diameter)
                && same(s.end_outer_diameter, k.end_outer_diameter)
                && same(s.end_inner_diameter, k.end_inner_diameter);
        }
        for (l, k) in p.rows.iter().zip(&known.rows) {
            all = all
                && same(l.outer_diameter, k.outer_diameter)
                && same(l.inner_diameter, k.inner_diameter)
                && same(l.modulus, k.modulus)
                && same(l.shear_modulus, k.shear_modulus)
                && same(l.density, k.density)
                && same(l.stiffness, k.stiffness);
        }
        all
    }
}

#[inline(always)]
fn same<S: Scalar>(x: S, known: f64) -> bool {
    (x - S::cst(known)).is_nothing()
}

impl Shaft {
    /// The same shaft with the matrices of its elements for these parameters.
    pub(super) fn prepared_for(&self, p: &Params<Self, f64>) -> Self {
        Shaft { prepared: Some(Arc::new(Prepared::new(self, p))), ..self.clone() }
    }

    /// The matrices of all elements, by number.
    #[inline(always)]
    pub(super) fn each<S: Scalar>(&self, p: &Params<Self, S>, mut f: impl FnMut(usize, &Matrices<S>)) {
        // members side by side have parameters of their own
        let alone = size_of::<S>() <= size_of::<D1>();
        let known = match &self.prepared {
            Some(known) if alone && known.holds(p) => known,
            _ => return self.computed(p, f),
        };
        let Some(&first) = known.which.first() else { return };
        let mut last = (first, known.different[first].lifted());
        for (k, &which) in known.which.iter().enumerate() {
            if last.0 != which {
                last = (which, known.different[which].lifted());
            }
            f(k, &last.1);
        }
    }

    /// The same from the parameters; neighbours that are alike are computed once.
    #[inline(always)]
    fn computed<S: Scalar>(&self, p: &Params<Self, S>, mut f: impl FnMut(usize, &Matrices<S>)) {
        let mut last: Option<(usize, Matrices<S>)> = None;
        for (k, piece) in self.mesh.pieces.iter().enumerate() {
            let section = &p.own.rows[piece.section];
            let tapers = [section.end_outer_diameter, section.end_inner_diameter].iter().any(|d| d.value() != 0.0);
            let known = last.filter(|(j, _)| {
                let other = self.mesh.pieces[*j];
                let alike = self.layers.is_empty() || self.covering(*j).map(|l| l.0).eq(self.covering(k).map(|l| l.0));
                alike && !tapers && other.section == piece.section && (other.length - piece.length).abs() <= 1e-13 * piece.length
            });
            let matrices = known.map_or_else(|| Matrices::new(&self.element(p, k), self, p.torque), |k| k.1);
            f(k, &matrices);
            last = Some((k, matrices));
        }
    }
}
