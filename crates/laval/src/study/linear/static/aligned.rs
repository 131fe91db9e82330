//! Offsets of supports and the alignment of couplings: settings, and what is computed of them.
//!
//! Equations: [`crate::solve::statics::offsets`], [`crate::solve::statics::influence`], [`crate::solve::statics::alignment`].

use super::{Kind, Place, Static};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, Values};
use crate::model::part::Link;
use crate::model::station::Row;
use crate::model::system::System;
use crate::solve::statics::alignment::{Section, Unaligned, aligned};
use crate::solve::statics::offsets::Offset;
use crate::solve::statics::supports::{Support, named};
use crate::solve::statics::{Statics, influence};
use crate::study::shared::supporting;
use crate::text;
use crate::units::read_quantity;
use laval_num::dense::Mat;
use serde::{Deserialize, Serialize};

const OFFSET: FieldKind = FieldKind::Named { unit: "m", bounds: Bounds::within(1.0) };

/// Fields of offsets and couplings.
pub(super) const OFFSET_X: Field = Field::optional(
    "offset_x",
    OFFSET,
    "",
    "offsets of supports in x against what they stand on, as { \"bearing 2\" = \"0.2 mm\" }; positive in the direction of x",
);
pub(super) const OFFSET_Y: Field = Field::optional(
    "offset_y",
    OFFSET,
    "",
    "heights of supports in y against what they stand on, as { \"bearing 2\" = \"0.2 mm\" }; positive where they are raised",
);
pub(super) const COUPLINGS: Field = Field::optional(
    "couplings",
    FieldKind::Text,
    "",
    "couplings whose faces coincide and are parallel once the shafts are aligned, separated by commas: parts that join two turning bodies, or nodes of a shaft as \"shaft at 1200 mm\"; \
     the heights of the supports that this takes are computed",
);
pub(super) const ALIGNED_FOR: Field = Field::optional(
    "aligned_for",
    FieldKind::Choice(&[
        ("moment_and_shear", "neither bending moment nor shear force at the couplings, as of a train with two bearings on each shaft"),
        ("moment", "no bending moment at the couplings, as where a shaft has one bearing and hangs on its coupling"),
    ]),
    "moment_and_shear",
    "loads of the couplings that vanish in the aligned train",
);
pub(super) const KEPT: Field = Field::optional(
    "kept",
    FieldKind::Text,
    "",
    "names of the supports that keep their offsets in the aligned train, separated by commas; the first two of the machine unless given",
);

/// Findings about the alignment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// Offsets that differ from zero.
    pub offsets: Vec<Offset>,
    /// Couplings, with their names.
    pub couplings: Vec<(String, Section)>,
    /// Moment and shear force vanish, else the moment alone.
    pub moment_only: bool,
    /// Slots of the supports that keep their offsets; the first two where it is empty.
    pub kept: Vec<usize>,
}

/// Slots of the parts that join a turning body to something.
fn candidates(system: &System) -> Vec<usize> {
    (0..system.slots().len()).filter(|&k| named(system, k).is_some()).collect()
}

/// Reads the fields; says all that is wrong.
pub(super) fn read(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Request> {
    let mut complete = true;
    let mut offsets: Vec<Offset> = Vec::new();
    for (p, field) in ["offset_x", "offset_y"].into_iter().enumerate() {
        for (name, by) in values.named(field) {
            let slots = match name {
                None => candidates(system),
                Some(name) => supporting::slot(name, field, values, system, diagnostics).into_iter().collect(),
            };
            complete &= !slots.is_empty();
            for slot in slots {
                match offsets.iter_mut().find(|o| o.slot == slot) {
                    Some(o) => o.by[p] = by,
                    None => offsets.push(Offset { slot, by: if p == 0 { [by, 0.0] } else { [0.0, by] } }),
                }
            }
        }
    }
    let mut couplings = Vec::new();
    for name in listed(values, "couplings") {
        match coupling(&name, values, system) {
            Ok(section) => couplings.push((name, section)),
            Err(wrong) => {
                diagnostics.push(wrong);
                complete = false;
            }
        }
    }
    let mut kept = Vec::new();
    for name in listed(values, "kept") {
        match supporting::slot(&name, "kept", values, system, diagnostics) {
            Some(slot) => kept.push(slot),
            None => complete = false,
        }
    }
    let alone = complete && couplings.is_empty();
    for field in ["kept", "aligned_for"].into_iter().filter(|f| alone && values.written(f)) {
        let message = text!("{field} says how couplings are aligned, and couplings names none", field);
        diagnostics.push(
            Diagnostic::error("static.couplings", message)
                .at(values.span_of(field))
                .help(text!("name couplings, or remove {field}", field)),
        );
        complete = false;
    }
    let moment_only = values.choice("aligned_for") == Some("moment");
    complete.then_some(Request { offsets, couplings, moment_only, kept })
}

fn listed(values: &Values, field: &str) -> Vec<String> {
    values.text(field).unwrap_or_default().split(',').map(str::trim).filter(|n| !n.is_empty()).map(str::to_string).collect()
}

/// The section of a coupling: of a part the end of a shaft that it joins, else a node of a shaft.
fn coupling(name: &str, values: &Values, system: &System) -> Result<Section, Diagnostic> {
    let bends = |k: usize| system.slots()[k].part.body().is_some_and(|b| b.nodes().is_some());
    let slot = |n: &str| system.slots().iter().position(|s| s.name == n);
    let wrong = |message| Diagnostic::error("static.couplings", message).at(values.span_of("couplings")).about(name);
    if let Some(part) = slot(name) {
        let ends = system.slots()[part].layout.ports.iter().filter_map(|p| match &p.link {
            Link::Between(a, b) => Some([a, b]),
            Link::On(_) => None,
        });
        let section = ends.flatten().find_map(|a| {
            let body = slot(a.body.as_ref()?).filter(|&k| bends(k))?;
            Section::at(system, body, a.position)
        });
        let message = text!("\"{name}\" joins no shaft that bends to another body", name);
        return section.ok_or_else(|| wrong(message).help(text!("name a coupling between two shafts, or a place as \"shaft at 1200 mm\"")));
    }
    let place = name.rsplit_once(" at ").and_then(|(body, at)| Some((slot(body).filter(|&k| bends(k))?, read_quantity(at, "m").ok()?)));
    let Some((body, position)) = place else {
        let message = text!("couplings names \"{name}\", which is neither a part nor a place of a shaft", name);
        return Err(wrong(message).help(text!("a place of a shaft is written as \"shaft at 1200 mm\"")));
    };
    Section::at(system, body, position).ok_or_else(|| {
        let nodes = system.slots()[body].part.body().and_then(|b| b.nodes()).unwrap_or_default();
        let near = nodes.iter().copied().min_by(|a, b| (a - position).abs().total_cmp(&(b - position).abs())).unwrap_or(0.0);
        let message = text!("{name} is no node of the shaft: the nearest is at {near}", name, near = text::quantity(near, "m"));
        wrong(message).help(text!("end a section of the shaft there"))
    })
}

/// Influence of one support on another.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Influence {
    /// Slot of the support whose load changes.
    pub load_of: usize,
    /// Slot of the one that is raised.
    pub raised: usize,
    /// Change of the load in x per offset in x and in y, then of that in y, N/m.
    pub own: [[f64; 2]; 2],
    /// The same on rigid supports; NaN of those that do not hold a body that bends.
    pub rigid: [[f64; 2]; 2],
}

/// Loads of a coupling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CouplingLoads {
    /// Name in the file.
    pub name: String,
    /// Slot of the body that is cut.
    pub slot: usize,
    /// Position along it, m.
    pub position: f64,
    /// Shear force, N, and bending moment, N m, with the offsets given.
    pub given: ([f64; 2], [f64; 2]),
    /// The same in the aligned train; NaN without one.
    pub aligned: ([f64; 2], [f64; 2]),
}

/// The train with couplings free of load.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Train {
    /// Offsets of all supports.
    pub offsets: Vec<Offset>,
    /// Supports that could move.
    pub movable: Vec<usize>,
    /// At rest on them.
    pub kind: Kind,
    /// What is left of the loads, over the largest moment along the shafts before.
    pub left: f64,
    /// Offsets that the couplings do not determine.
    pub spare: usize,
}

/// Of a machine whose supports have offsets, or more of them than it needs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Alignment {
    /// Offsets given.
    pub offsets: Vec<Offset>,
    /// Without offsets; none where none are given.
    pub level: Option<Kind>,
    /// Of every pair of supports; none where the machine is not held.
    pub influence: Vec<Influence>,
    /// Largest entry of it, and that by which it differs from its transpose, N/m.
    pub largest: f64,
    /// See above.
    pub skew: f64,
    /// Couplings.
    pub couplings: Vec<CouplingLoads>,
    /// The aligned train.
    pub train: Option<Train>,
    /// Offsets of the supports do not bring it about.
    pub unaligned: bool,
}

impl Static {
    /// Supports that may move.
    fn movable(&self, supports: &[Support]) -> Vec<usize> {
        let first: Vec<usize> = supports.iter().map(|s| s.slot).take(2).collect();
        let kept = if self.alignment.kept.is_empty() { &first } else { &self.alignment.kept };
        supports.iter().map(|s| s.slot).filter(|s| !kept.contains(s)).collect()
    }

    /// Refuses what these supports cannot answer.
    pub(super) fn admit_alignment(&self, supports: &[Support]) -> Result<(), Diagnostic> {
        let request = &self.alignment;
        if request.couplings.is_empty() {
            return Ok(());
        }
        let each = if request.moment_only { 1 } else { 2 };
        let (needed, free) = (each * request.couplings.len(), self.movable(supports).len());
        if needed <= free {
            return Ok(());
        }
        let message = text!(
            "{needed} loads of couplings vanish only with as many supports that may move, and there are {free}",
            needed = needed,
            free = free
        );
        let help = text!("name fewer couplings, keep fewer supports, or choose aligned_for = \"moment\"");
        Err(Diagnostic::error("static.alignment", message).help(help))
    }

    /// Offsets of the places that are held, x and y of each; an error where two parts at one place have different ones.
    pub(super) fn ties(&self, system: &System, supports: &[Support], places: &[Place]) -> Result<Vec<f64>, Diagnostic> {
        let offset = |slot: usize| self.alignment.offsets.iter().find(|o| o.slot == slot).map_or([0.0; 2], |o| o.by);
        let mut out = Vec::new();
        for place in places {
            let mut here = supports.iter().filter(|s| s.flexible && s.place.0 == place.rows).map(|s| s.slot);
            let by = offset(place.slot);
            if let Some(other) = here.find(|&s| offset(s) != by) {
                let name = |k: usize| system.slots()[k].name.clone();
                let message =
                    text!("\"{a}\" and \"{b}\" support the same place with different offsets", a = name(place.slot), b = name(other));
                return Err(Diagnostic::error("static.alignment", message)
                    .help(text!("give them the same offsets, or name one of them in supports")));
            }
            out.extend(by);
        }
        Ok(out)
    }

    /// Of the machine on its own stiffness, `at` without offsets and `own` with them, and on rigid supports.
    pub(super) fn alignment(
        &self,
        system: &System,
        (at, own): (&Statics, &Kind),
        supports: &[Support],
        rigid: Option<(&Kind, &[Place])>,
    ) -> Result<Option<Alignment>, Diagnostic> {
        let request = &self.alignment;
        if request.offsets.is_empty() && request.couplings.is_empty() && supports.len() < 3 {
            return Ok(None);
        }
        let slots: Vec<usize> = supports.iter().map(|s| s.slot).collect();
        let ties: Vec<Row> = rigid.iter().flat_map(|r| r.1).flat_map(|p| p.rows.clone()).collect();
        let held = rigid.and_then(|(kind, _)| influence::rigid(system, &kind.state, &ties));
        let place = |slot: usize| rigid.and_then(|(_, places)| places.iter().position(|p| p.slot == slot));
        let block = |m: &Mat, i: usize, j: usize| [0, 1].map(|p| [0, 1].map(|q| m[(2 * i + p, 2 * j + q)]));
        let unknown = [[f64::NAN; 2]; 2];
        let (mut pairs, mut largest, mut skew) = (Vec::new(), 0.0f64, 0.0f64);
        if let Some(m) = influence::own(system, &own.state, &slots) {
            for i in 0..2 * slots.len() {
                for j in 0..2 * slots.len() {
                    largest = largest.max(m[(i, j)].abs());
                    skew = skew.max((m[(i, j)] - m[(j, i)]).abs());
                }
            }
            for (i, &load_of) in slots.iter().enumerate() {
                for (j, &raised) in slots.iter().enumerate() {
                    let rigid = held.as_ref().and_then(|h| Some(block(h, place(load_of)?, place(raised)?))).unwrap_or(unknown);
                    pairs.push(Influence { load_of, raised, own: block(&m, i, j), rigid });
                }
            }
        }
        let sections: Vec<Section> = request.couplings.iter().map(|c| c.1).collect();
        let mut unaligned = false;
        let mut train = None;
        if !sections.is_empty() {
            let movable = self.movable(supports);
            match aligned(system, &own.state, &slots, &movable, &sections, !request.moment_only)? {
                Ok(a) => {
                    train =
                        Some(Train { offsets: a.offsets, movable, kind: Kind::new(system, a.state, &[]), left: a.left, spare: a.spare });
                }
                Err(Unaligned::Few(..) | Unaligned::Independent | Unaligned::Open(_)) => unaligned = true,
            }
        }
        let nothing = ([f64::NAN; 2], [f64::NAN; 2]);
        let loads = |s: &Section, kind: Option<&Kind>| kind.and_then(|k| s.loads(&k.beams)).unwrap_or(nothing);
        let couplings = request.couplings.iter().map(|(name, s)| CouplingLoads {
            name: name.clone(),
            slot: s.slot,
            position: s.position,
            given: loads(s, Some(own)),
            aligned: loads(s, train.as_ref().map(|t| &t.kind)),
        });
        Ok(Some(Alignment {
            offsets: request.offsets.clone(),
            level: (!request.offsets.is_empty()).then(|| Kind::new(system, at.clone(), &[])),
            influence: pairs,
            largest,
            skew,
            couplings: couplings.collect(),
            train,
            unaligned,
        }))
    }
}
