//! A machine over few coordinates: linear parts by a structure in their place, all parts seen through a basis.

use super::blocks::{Blocks, Grid};
use super::erased::*;
use super::lanes::{Linear, LinearArgs, Residual, ResidualArgs};
use super::params::{List, NoParams, ParamSlot};
use super::part::{At, Dof, Energy, ErasedPart, Layout, Observed, Part, Physics, Rows, Uses, Validity};
use super::slot::{GlobalDof, Slot};
use super::station::{Pair, Row};
use super::system::System;
use crate::diagnostic::Diagnostics;
use crate::model::field::{Field, ParamValues, Values};
use crate::text::Text;
use laval_num::dense::Mat;
use laval_num::lanes::Apply;
use laval_num::scalar::Scalar;
use std::sync::{Arc, OnceLock};

/// A linear structure by its matrices over coordinates of its own, at any spin speed W and acceleration W':
///
/// ```text
/// M a + (C + W G) v + (K + W N + W' K') q = f0 + W' g0 + (W^2 fc + W' gc) cos(phase) + (W^2 fs + W' gs) sin(phase)
/// ```
#[derive(Clone, Debug, Default)]
pub struct Structure {
    /// M.
    pub mass: Mat,
    /// C.
    pub damping: Mat,
    /// G.
    pub gyroscopic: Mat,
    /// K.
    pub stiffness: Mat,
    /// N.
    pub circulatory: Mat,
    /// K'.
    pub spin_accel_stiffness: Mat,
    /// f0, N.
    pub force: Vec<f64>,
    /// fc and fs, N s^2.
    pub turning: [Vec<f64>; 2],
    /// g0, gc and gs.
    pub spin_accel: [Vec<f64>; 3],
}

impl Part for Structure {
    const KIND: &'static str = "structure";
    const DOC: &'static str = "Linear parts of a machine that was reduced to few coordinates.";
    type Family = NoParams;
    const FIELDS: &'static [Field] = &[];

    fn build(_: &Values, _: &mut ParamValues, _: &mut Diagnostics) -> Option<Self> {
        None
    }
    fn layout(&self) -> Layout {
        Layout { own: (1..=self.force.len()).map(|k| Dof::scalar(format!("coordinate_{k}"), "m", 1e-3)).collect(), ..Layout::default() }
    }
    fn physics(&self) -> Physics {
        Physics::Linear
    }
    fn linear<S: Scalar>(&self, (): &(), speed: S, b: &mut Blocks<S>) {
        let n = self.force.len();
        let fill = |from: &Mat, to: &mut Grid<S>| {
            for i in 0..n {
                for (j, &x) in from.row(i).iter().enumerate() {
                    to[(i, j)] = S::cst(x);
                }
            }
        };
        fill(&self.mass, &mut b.mass);
        fill(&self.damping, &mut b.damping);
        fill(&self.gyroscopic, &mut b.gyroscopic);
        fill(&self.stiffness, &mut b.stiffness);
        fill(&self.circulatory, &mut b.circulatory);
        fill(&self.spin_accel_stiffness, &mut b.spin_accel_stiffness);
        let w2 = speed * speed;
        for i in 0..n {
            b.force[i] = S::cst(self.force[i]);
            (b.force_cos[i], b.force_sin[i]) = (w2.scale(self.turning[0][i]), w2.scale(self.turning[1][i]));
            let [constant, cos, sin] = &self.spin_accel;
            b.spin_accel_force[i] = S::cst(constant[i]);
            (b.spin_accel_cos[i], b.spin_accel_sin[i]) = (S::cst(cos[i]), S::cst(sin[i]));
        }
    }
    fn energy<S: Scalar>(&self, (): &(), _: &At<S>) -> Option<Energy<S>> {
        // that of the parts in whose place it stands
        Some(Energy::zero())
    }
}

/// Coordinates of a machine over those of a projected one.
#[derive(Clone, Debug)]
pub struct Projection {
    /// One row for each coordinate.
    pub basis: Mat,
    /// The coordinates.
    pub coordinates: Vec<GlobalDof>,
}

impl Projection {
    /// All coordinates, or their rates.
    pub fn all(&self, x: &[f64]) -> Vec<f64> {
        (0..self.basis.rows()).map(|i| self.one(i, x)).collect()
    }
    /// One of them.
    pub fn one(&self, i: usize, x: &[f64]) -> f64 {
        self.basis.row(i).iter().zip(x).map(|(b, x)| b * x).sum()
    }
}

/// A part whose forces are in a structure: it shows what it showed, and keeps its energy.
struct Absorbed(ErasedPart);

macro_rules! absorbed {
    ($( $scalar:ty: $residual:ident $linear:ident $load:ident $impedance:ident $regular:ident $energy:ident; )*) => {
        impl Erased for Absorbed {
            fn kind(&self) -> &'static str {
                self.0.kind()
            }
            fn layout(&self) -> Layout {
                self.0.layout()
            }
            fn physics(&self) -> Physics {
                Physics::Linear
            }
            fn uses(&self) -> Uses {
                self.0.uses()
            }
            fn reach(&self) -> usize {
                self.0.reach()
            }
            fn is_steady(&self) -> bool {
                self.0.is_steady()
            }
            fn memory(&self) -> usize {
                0
            }
            fn slots(&self) -> Vec<ParamSlot> {
                self.0.slots()
            }
            fn lists(&self) -> Vec<List> {
                self.0.lists()
            }
            fn fields(&self) -> &'static [Field] {
                self.0.fields()
            }
            fn observe(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Observed>) {
                self.0.observe(p, at, out)
            }
            fn validity(&self, p: &[f64], at: &At<f64>, out: &mut Vec<Validity>) {
                self.0.validity(p, at, out)
            }
            fn check(&self, p: &[f64]) -> Vec<(&'static str, Text)> {
                self.0.check(p)
            }
            fn warnings(&self, p: &[f64]) -> Vec<Text> {
                self.0.warnings(p)
            }
            fn spin_row_f64(&self, p: &[f64], at: &At<f64>) -> f64 {
                self.0.spin_row_f64(p, at)
            }
            fn prepared(&self, _: &[f64]) -> Option<ErasedPart> {
                None
            }
            fn spin_row_d8(&self, p: &[D8], at: &At<D8>) -> D8 {
                self.0.spin_row_d8(p, at)
            }
            fn body(&self) -> Option<&dyn BodyPart> {
                self.0.body()
            }
            fn contacts(&self) -> Option<&dyn Contacts> {
                None
            }
            fn movable_masses(&self) -> Option<&dyn MovableMasses> {
                None
            }
            fn varying_inertia(&self) -> Option<&dyn VaryingInertia> {
                None
            }
            fn added_inertia(&self) -> Option<&dyn AddedInertia> {
                None
            }
            fn frequency_domain(&self) -> Option<&dyn FrequencyDomain> {
                None
            }
            fn replaced_in_time(&self) -> Option<&dyn ReplacedInTime> {
                None
            }
            fn spin_drive(&self) -> Option<&dyn SpinDrive> {
                self.0.spin_drive()
            }
            fn filling(&self) -> Option<&dyn Filling> {
                None
            }
            fn mesh(&self) -> Option<&dyn Mesh> {
                self.0.mesh()
            }
            fn scope(&self) -> Option<&dyn Scope> {
                None
            }
            $(
                fn $residual(&self, p: &[$scalar], at: &At<$scalar>, out: &mut Rows<$scalar>, blocks: &mut Blocks<$scalar>) {
                    // the torque alone
                    let mut force = vec![<$scalar as Scalar>::zero(); at.q.len()];
                    self.0.$residual(p, at, &mut Rows { force: &mut force, rate: &mut [], spin: &mut *out.spin }, blocks);
                }
                fn $linear(&self, _: &[$scalar], _: $scalar, _: &mut Blocks<$scalar>) {}
                fn $energy(&self, p: &[$scalar], at: &At<$scalar>) -> Option<Energy<$scalar>> {
                    self.0.$energy(p, at)
                }
            )*
        }
    };
}
with_scalars!(absorbed);

impl Apply<Absorbed> for Residual {
    #[inline(always)]
    fn apply<S: Scalar>(_: &Absorbed, _: &mut ResidualArgs<'_, S>) {}
}
impl Apply<Absorbed> for Linear {
    #[inline(always)]
    fn apply<S: Scalar>(_: &Absorbed, _: &mut LinearArgs<'_, S>) {}
}

impl System {
    /// The machine with its coordinates as combinations of few, `q = basis x`, and the parts that `absorbed` names by slot replaced by a structure over them.
    /// Stations, probes and the names of parts stay; coordinates do not turn in pairs; parameters cannot be changed.
    pub fn projected(&self, basis: &Mat, absorbed: &[bool], structure: Structure) -> System {
        let n = basis.cols();
        let over = |row: &Row| -> Row {
            let mut sum = vec![0.0; n];
            for &(g, x) in row {
                sum.iter_mut().zip(basis.row(g)).for_each(|(s, b)| *s += x * b);
            }
            // what is rounding of a whole is none
            let largest = sum.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            sum.into_iter().enumerate().filter(|(_, x)| x.abs() > 1e-14 * largest).collect()
        };
        let pair = |p: &Pair| Pair([over(&p.0[0]), over(&p.0[1])]);
        let mut slots: Vec<Slot> = self
            .slots
            .iter()
            .zip(absorbed)
            .map(|(s, &inside)| Slot {
                name: s.name.clone(),
                part: if inside { Arc::new(Absorbed(s.part.clone())) } else { s.part.clone() },
                layout: s.layout.clone(),
                physics: s.physics,
                uses: s.uses,
                params: s.params.clone(),
                spin: s.spin,
                ratio: s.ratio,
                map: s.map.iter().map(over).collect(),
                weight: s.weight.clone(),
                own: 0..0,
                states: s.states.clone(),
                memory: s.memory,
                reach: s.reach,
                span: s.span.clone(),
            })
            .collect();
        let k = slots.len();
        let layout = Part::layout(&structure);
        let name = "structure".to_string();
        let coordinates = layout.own.iter().map(|d| GlobalDof { name: format!("{name}.{}", d.name), slot: k, dof: d.clone() }).collect();
        let end = self.params.len();
        slots.push(Slot {
            part: structure.erased(),
            physics: Physics::Linear,
            uses: Uses { velocity: true, acceleration: true, spin: true },
            params: end..end,
            spin: None,
            ratio: None,
            map: (0..n).map(|g| vec![(g, 1.0)]).collect(),
            weight: Vec::new(),
            own: 0..n,
            states: self.states.len()..self.states.len(),
            memory: 0,
            reach: usize::MAX,
            span: None,
            layout,
            name,
        });
        let stations = self.stations().iter().map(|s| super::station::Station {
            lateral: pair(&s.lateral),
            tilt: s.tilt.as_ref().map(pair),
            ..s.clone()
        });
        let probes = self.probes().iter().map(|p| super::probe::Probe { rows: pair(&p.rows), ..p.clone() });
        System {
            machine: self.machine.clone(),
            slots,
            coordinates,
            states: self.states.clone(),
            params: self.params.clone(),
            param_slots: self.param_slots.clone(),
            stations: OnceLock::from(stations.collect::<Vec<_>>()),
            probes: OnceLock::from(probes.collect::<Vec<_>>()),
            assemblies: Default::default(),
            steady: Default::default(),
            projection: Some(Arc::new(Projection { basis: basis.clone(), coordinates: self.coordinates.clone() })),
        }
    }

    /// Of a machine that was [`projected`](Self::projected): the coordinates it had, and how they follow from its own.
    pub fn projection(&self) -> Option<&Projection> {
        self.projection.as_deref()
    }
}
