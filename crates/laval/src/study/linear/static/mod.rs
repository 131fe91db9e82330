//! The machine at rest under its weight and constant forces: deflection, slope, shear force and bending moment along its shafts, loads of its bearings, mass properties.
//!
//! Equations: `K q + n(q) = f0` with the bearings' coefficients at a speed; `B' q = d` in their places on rigid supports. Shear and moment from cuts. A support that is raised by d
//! sees its turning end lower by d; `dR/dd` is the influence of offsets on loads; in the aligned train moment and shear force vanish at the couplings.
//!
//! Symbols: K stiffness without circulatory terms, n nonlinear parts, f0 weight and constant forces, B places of the supports, d their offsets, R their loads.
//!
//! Validity: small deflections; nothing turns; circulatory terms of the rotor are left out, cross stiffness of bearings is not.
//!
//! Theory: `docs/theory/shafts.md#sag`.
//!
//! Sources: S. P. Timoshenko, Strength of Materials, Van Nostrand 1955 (beams, three moments, supports at different levels, reciprocal theorem).

mod aligned;
mod findings;
mod heights;
mod tables;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::capability::scope::Axis;
use crate::model::field::{Field, Values};
use crate::model::part::{DofKind, Link};
use crate::model::slot::gather;
use crate::model::station::Row;
use crate::model::system::{GRAVITY, System};
use crate::outcome::{End, Kept, Outcome};
use crate::solve::statics::beam::{Beam, beams};
use crate::solve::statics::forces::share;
use crate::solve::statics::masses::{MassProperties, mass_properties};
use crate::solve::statics::supports::{Support, turning_first};
use crate::solve::statics::{Statics, held, own, raised};
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::{SPEED, inconsistent};
use crate::study::shared::supporting;
use crate::study::{Context, Study};
use serde::{Deserialize, Serialize};

pub use aligned::{Alignment, CouplingLoads, Influence, Request, Train};

/// See the [module](self).
#[derive(Clone, Debug, Default)]
pub struct Static {
    /// Speed whose coefficients the bearings have, rad/s.
    pub speed: f64,
    /// Slots of the supports; all of the machine where it is empty.
    pub supports: Vec<usize>,
    /// Offsets of supports, and couplings to align.
    pub alignment: Request,
}

impl Study for Static {
    type Result = StaticResult;
    const KIND: &'static str = "static";
    const EXAMPLE: &'static str = r#"speed = "3000 rpm"
"#;
    const DOC: &'static str = "The machine at rest under its weight (axis = \"horizontal\" in [machine]) and constant forces: deflection, slope, shear force and \
        bending moment along its shafts, loads of its bearings, mass and moments of inertia. Twice: with the stiffness that the bearings have at a speed, and on \
        rigid supports in their places. With offsets of its supports, their influence on the loads, and the heights at which couplings carry nothing.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::optional("speed", SPEED, "", "speed whose coefficients the bearings have; the machine's when left out, or 0 without one"),
        supporting::SUPPORTS,
        aligned::OFFSET_X,
        aligned::OFFSET_Y,
        aligned::COUPLINGS,
        aligned::ALIGNED_FOR,
        aligned::KEPT,
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let speed = values.number("speed").or(system.machine.speed).unwrap_or(0.0);
        let supports = supporting::read(values, system, diagnostics);
        let alignment = aligned::read(values, system, diagnostics);
        Some(Static { speed, supports: supports?, alignment: alignment? })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        vec![SpinSpeeds::one(self.speed)]
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        let at = own(system, self.speed)?;
        let supports = supporting::of(system, &self.supports, &at);
        self.ties(system, &supports, &held_places(&supports))?;
        self.admit_alignment(&supports)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<StaticResult, Diagnostic> {
        let at = own(system, self.speed)?;
        let supports = supporting::of(system, &self.supports, &at);
        self.admit_alignment(&supports)?;
        let places = held_places(&supports);
        let offsets = self.ties(system, &supports, &places)?;
        let state = if self.alignment.offsets.is_empty() { at.clone() } else { raised(system, &at, &self.alignment.offsets)? };
        let rigid = (!places.is_empty()).then(|| {
            let mut left_out = vec![false; system.slots().len()];
            supports.iter().filter(|s| s.flexible).for_each(|s| left_out[s.slot] = true);
            let ties: Vec<Row> = places.iter().flat_map(|p| p.rows.clone()).collect();
            held(system, &state, &ties, &offsets, &left_out).ok().map(|state| Kind::new(system, state, &places))
        });
        let own = Kind::new(system, state, &[]);
        let not_held = rigid.as_ref().is_some_and(Option::is_none);
        let rigid = rigid.flatten();
        Ok(StaticResult {
            horizontal: system.machine.axis == Axis::Horizontal,
            masses: mass_properties(system),
            supports: supports.iter().map(|s| s.slot).collect(),
            not_held,
            alignment: self.alignment(system, (&at, &own), &supports, rigid.as_ref().map(|k| (k, &places[..])))?,
            own,
            rigid,
            end: context.end(true),
        })
    }

    fn report(&self, system: &System, result: &StaticResult, name: &str) -> Result<Outcome, Diagnostic> {
        let shown = Shown { system, result };
        let mut outcome = Outcome::new(Self::KIND, name).end(result.end);
        outcome = shown.findings().into_iter().fold(outcome, Outcome::finding);
        let first = [shown.reactions()?, shown.stations()?];
        let last = [shown.shafts()?, shown.mass_properties()?];
        for table in first.into_iter().chain(shown.alignment_tables()?).chain(last) {
            if table.rows() > 0 {
                outcome = outcome.table(table);
            }
        }
        if result.loaded() && !result.own.beams.is_empty() {
            outcome = outcome.figure(shown.figure());
        }
        outcome.checked().map_err(inconsistent)
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

/// Places of a body that bends that are held on rigid supports.
fn held_places(supports: &[Support]) -> Vec<Place> {
    Place::of(supports.iter().filter(|s| s.flexible).map(|s| (s.slot, &s.place.0)))
}

/// A place that is held, x and y, and the part in whose place it is.
struct Place {
    slot: usize,
    rows: [Row; 2],
}

impl Place {
    /// Each place once.
    fn of<'a>(all: impl Iterator<Item = (usize, &'a [Row; 2])>) -> Vec<Place> {
        let mut out: Vec<Place> = Vec::new();
        for (slot, rows) in all {
            if !out.iter().any(|p| p.rows == *rows) {
                out.push(Place { slot, rows: rows.clone() });
            }
        }
        out
    }
}

/// Force with which a part carries a body, N.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Reaction {
    /// Slot of the part.
    pub slot: usize,
    /// In x and y.
    pub force: [f64; 2],
    /// About x and y, N m; of a part that joins tilts.
    pub moment: Option<[f64; 2]>,
}

/// The machine at rest on one kind of supports.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Kind {
    /// Deflections.
    pub state: Statics,
    /// Bodies that bend.
    pub beams: Vec<Beam>,
    /// Forces on the first bodies of parts that join two, on turning bodies where others do not turn, and on bodies with springs of their own.
    pub reactions: Vec<Reaction>,
    /// Weight and constant forces that nothing carries, over all of them.
    pub defect: f64,
}

impl Kind {
    fn new(system: &System, state: Statics, places: &[Place]) -> Kind {
        let ties: Vec<Row> = places.iter().flat_map(|p| p.rows.clone()).collect();
        let mut reactions = Vec::new();
        let (mut left, mut all) = ([0.0; 2], 0.0);
        let along =
            |first: DofKind| -> Vec<f64> { system.coordinates().iter().map(|c| if c.dof.kind == first { 1.0 } else { 0.0 }).collect() };
        let fields = [along(DofKind::VectorX), along(DofKind::VectorY)];
        for (k, slot) in system.slots().iter().enumerate().filter(|x| !state.left_out[x.0]) {
            let share = share(system, slot, state.speed, &state.seen_by(k), &state.z);
            let bends = slot.part.body().is_some_and(|b| b.nodes().is_some());
            for (p, field) in fields.iter().enumerate() {
                let mut local = Vec::new();
                gather(&slot.map, field, &mut local);
                let sum = |f: &[f64]| f.iter().zip(&local).map(|(f, t)| f * t).sum::<f64>();
                // springs inside a body that bends carry it nowhere
                left[p] += sum(&share.weight) + if bends { 0.0 } else { sum(&share.elastic) };
                all += sum(&share.weight).abs();
            }
            reactions.extend(reaction(system, k, &share.elastic));
        }
        for (p, holding) in state.holding.iter().enumerate() {
            left[p % 2] -= holding;
        }
        reactions.extend(places.iter().enumerate().map(|(i, p)| Reaction {
            slot: p.slot,
            force: [state.holding[2 * i], state.holding[2 * i + 1]],
            moment: None,
        }));
        let defect = if all > 0.0 { left[0].hypot(left[1]) / all } else { 0.0 };
        Kind { beams: beams(system, &state, &ties), state, reactions, defect }
    }
}

/// Of a part between two points, and of a rigid body on springs of its own.
fn reaction(system: &System, k: usize, elastic: &[f64]) -> Option<Reaction> {
    let slot = &system.slots()[k];
    if elastic.iter().all(|f| *f == 0.0) {
        return None;
    }
    if let Some(body) = slot.part.body() {
        let own = slot.map.len() - slot.own.len();
        let kinds = slot.layout.kinds();
        let of = |kind: DofKind| -(own..elastic.len()).filter(|&i| kinds[i] == kind).map(|i| elastic[i]).sum::<f64>();
        return body.nodes().is_none().then(|| Reaction { slot: k, force: [of(DofKind::VectorX), of(DofKind::VectorY)], moment: None });
    }
    let port = slot.layout.ports.first()?;
    let Link::Between(..) = &port.link else { return None };
    let sign = if turning_first(system, k) { -1.0 } else { 1.0 };
    let of = |i: usize| sign * elastic[i];
    Some(Reaction { slot: k, force: [of(0), of(1)], moment: (elastic.len() >= 4 && port.kind.size() == 4).then(|| [of(2), of(3)]) })
}

/// See the [module](self).
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct StaticResult {
    /// The axis lies, and weight bends it.
    pub horizontal: bool,
    /// Bodies and their parts.
    pub masses: Vec<MassProperties>,
    /// Slots of the parts that support the rotor.
    pub supports: Vec<usize>,
    /// On the stiffness of the parts.
    pub own: Kind,
    /// With the places of the supports on a body that bends held; none without such a body.
    pub rigid: Option<Kind>,
    /// Offsets of supports, their influence, couplings; none where the loads do not depend on offsets and none is given.
    #[serde(default)]
    pub alignment: Option<Alignment>,
    /// Rigid supports in these places do not hold the machine.
    pub not_held: bool,
    /// How the study ended.
    pub end: End,
}

impl StaticResult {
    /// Something is deflected.
    fn loaded(&self) -> bool {
        self.own.state.q.iter().any(|q| *q != 0.0)
    }
    /// Mass of all bodies, kg.
    fn mass(&self) -> f64 {
        self.masses.iter().filter(|m| m.part.is_none()).map(|m| m.mass).sum()
    }
    /// Weight, N.
    fn weight(&self) -> f64 {
        GRAVITY * self.mass()
    }
}

/// On which supports, or at which heights, the machine rests.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Basis {
    /// On the stiffness of the supports, at the offsets given.
    Own,
    /// On rigid ones.
    Rigid,
    /// On their stiffness, at the offsets that free the couplings.
    Aligned,
}

struct Shown<'a> {
    system: &'a System,
    result: &'a StaticResult,
}
