//! Undamped critical speeds over the stiffness of the supports: each support replaced by kxx = kyy = k, pedestals and masses kept.
//!
//! Equations: `[K + k sum b b^H - W^2 (M - i G)] u = 0`, positive W^2 alone; a bearing meets a curve where `W_j(k(W)) = W`.
//!
//! Symbols: K, M, G stiffness, mass, gyroscopic matrix without the supports; b place of a support; k its stiffness; W speed of the spin whose unbalance drives the whirl,
//! which is forward along that spin; G of a body is that of its own speed over W.
//!
//! Validity: without damping and cross stiffness; small motions.
//!
//! Theory: `docs/theory/linear-vibration.md#supports`.
//!
//! Sources: J. W. Lund, as in every text on critical-speed maps; API 684.

mod report;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{Bounds, Field, FieldKind, RangeValue, Values};
use crate::model::spins::{OtherSpin, same_ratio};
use crate::model::system::System;
use crate::outcome::{End, Kept, Outcome};
use crate::solve::statics::supports::{Support, diagonal};
use crate::solve::support_map::{Root, Spin, SupportMap};
use crate::study::shared::size::Size;
use crate::study::shared::speed_range::SpinSpeeds;
use crate::study::shared::support::range_or;
use crate::study::shared::supporting;
use crate::study::shared::vibration::Vibration;
use crate::study::{Context, Study};
use crate::text;
use laval_num::univariate::root;
use serde::{Deserialize, Serialize};

/// See the [module](self).
#[derive(Clone)]
pub struct SupportStiffnessMap {
    /// Stiffness, N/m; about that of the rotor where it is not given.
    pub stiffness: Option<RangeValue>,
    /// Curves drawn.
    pub modes: usize,
    /// Slots of the supports; all of the machine where it is empty.
    pub supports: Vec<usize>,
    /// Natural frequencies at rest as well.
    pub rest: bool,
    /// The spin that speeds are those of, and along which whirl is forward.
    pub spin: Option<String>,
}

/// Values of the stiffness, and modes, unless given.
const POINTS: usize = 40;
const MODES: i64 = 4;
/// Range over the stiffness of the rotor, both ways, where it is not given.
const DECADES: f64 = 1e3;
/// Speeds at which a table is read.
const READ: usize = 60;
/// Relative uncertainty of an intersection.
const TOLERANCE: f64 = 1e-13;

impl Study for SupportStiffnessMap {
    type Result = MapResult;
    const KIND: &'static str = "support_stiffness_map";
    const EXAMPLE: &'static str = r#"stiffness = { from = "1e5 N/m", to = "1e10 N/m" }
modes = 4
"#;
    const DOC: &'static str = "Undamped critical speeds over the stiffness of the supports: every bearing is replaced by the same stiffness in x and y, without damping and cross \
        terms; pedestals and masses stay. The stiffness of the linear bearings is laid over it, and where it meets the curves the share of the strain energy in the \
        supports says whether other bearings or another shaft would move the critical speed.";
    const SEVERAL_SPINS: bool = true;
    const FIELDS: &'static [Field] = &[
        Field::optional(
            "stiffness",
            FieldKind::Range { unit: "N/m", bounds: Bounds::positive(1e15) },
            "",
            "stiffness of every support, in logarithmic steps; 40 points unless given; three powers of ten on both sides of that of the rotor when left out",
        ),
        Field::optional("modes", FieldKind::Integer { min: 1, max: 20 }, "4", "critical speeds at each stiffness"),
        supporting::SUPPORTS,
        Field::optional("rest_frequencies", FieldKind::Flag, "false", "natural frequencies of the rotor at rest as well"),
        Field::optional(
            "spin",
            FieldKind::Text,
            "",
            "of a machine of several spins: the part of kind \"speed_ratio\" whose unbalance drives the whirls; speeds are then those of this spin. Without it, they are those of the machine, or where no body turns at its speed of the first of its spins",
        ),
    ];

    fn build(values: &Values, system: &System, diagnostics: &mut Diagnostics) -> Option<Self> {
        let given = match values.range("stiffness") {
            Some(range) => Some(range_or("stiffness", (range, |help| help), 2, values, diagnostics)?),
            None => None,
        };
        let spin = values.text("spin").map(str::to_string);
        if let Some(Err(found)) = spin.as_ref().map(|name| system.at_spin(name)) {
            diagnostics.0.extend(found.0.into_iter().map(|d| d.at(values.span_of("spin"))));
            return None;
        }
        Some(SupportStiffnessMap {
            stiffness: given,
            modes: values.integer("modes").unwrap_or(MODES).clamp(1, 20) as usize,
            supports: supporting::read(values, system, diagnostics)?,
            rest: values.flag("rest_frequencies").unwrap_or(false),
            spin,
        })
    }

    fn spin_speeds(&self, _: &System) -> Vec<SpinSpeeds> {
        // tables are read where they are known
        Vec::new()
    }

    fn vibration(&self, _: &System) -> Vibration {
        Vibration::Refused
    }

    fn size(&self, system: &System) -> Option<Size> {
        let points = self.stiffness.and_then(|r| r.points).unwrap_or(POINTS);
        Some(Size::of_rows(points, 4 * self.modes + 2 * system.slots().len()))
    }

    fn admit(&self, system: &System) -> Result<(), Diagnostic> {
        let turned = self.turned(system)?;
        self.problem(turned.system(system)).map(drop)
    }

    fn compute(&self, system: &System, context: &Context) -> Result<MapResult, Diagnostic> {
        let turned = self.turned(system)?;
        let system = turned.system(system);
        let (map, supports) = self.problem(system)?;
        let rigid = map.rigid(Spin::Synchronous, self.modes);
        let (free, still) = map.free(Spin::Synchronous, self.modes);
        let bearings = bearings(system, &supports, (turned.sense, highest(&rigid)));
        let stiffness = self.values(&map, &rigid, &bearings);
        let spins = if self.rest { vec![Spin::Synchronous, Spin::Rest] } else { vec![Spin::Synchronous] };
        let mut curves = Vec::new();
        let mut complete = true;
        'all: for &spin in &spins {
            for &k in &stiffness {
                if !context.goes_on(curves.len() as u64) {
                    complete = false;
                    break 'all;
                }
                curves.push(Row { spin, stiffness: k, roots: map.roots(k, spin, (0, self.modes)) });
            }
        }
        let mut intersections = Vec::new();
        for (index, bearing) in bearings.iter().enumerate().filter(|_| complete) {
            for curve in 0..self.modes {
                intersections.extend(meetings(system, turned.sense, &map, (index, bearing), curve));
            }
        }
        Ok(MapResult {
            curves,
            free,
            still,
            rigid,
            bearings,
            intersections,
            forward_alone: map.forward_alone(),
            supports: supports.iter().map(|s| s.slot).collect(),
            end: context.end(complete),
        })
    }

    fn report(&self, system: &System, result: &MapResult, name: &str) -> Result<Outcome, Diagnostic> {
        let turned = self.turned(system)?;
        report::Shown { study: self, system: turned.system(system), turned: &turned, result }.outcome(name)
    }

    fn keep(&self, result: Self::Result) -> Kept {
        Kept::of(self.clone(), result)
    }
}

fn highest(roots: &[Root]) -> f64 {
    roots.iter().map(|r| r.speed).fold(0.0, f64::max)
}

/// The machine at the spin whose unbalance drives the whirls.
struct Turned {
    /// The spin, where it is not that of the machine.
    spin: Option<OtherSpin>,
    /// The machine at it.
    system: Option<System>,
    /// 1, or -1 of a spin that turns the other way.
    sense: f64,
}

impl Turned {
    fn system<'a>(&'a self, own: &'a System) -> &'a System {
        self.system.as_ref().unwrap_or(own)
    }
}

/// Spins of bodies besides that of the machine.
fn others(system: &System) -> Vec<OtherSpin> {
    let spins = system.spins().into_iter().filter(|s| !same_ratio(s.ratio, 1.0));
    spins.filter(|s| turns_at(system, s.ratio)).collect()
}

/// A body turns with this ratio to the speed of the machine.
fn turns_at(system: &System, ratio: f64) -> bool {
    let mut turning = system.slots().iter().filter(|s| s.part.body().is_some_and(|b| b.turns()));
    turning.any(|s| same_ratio(s.speed(system.params(), 1.0), ratio))
}

impl SupportStiffnessMap {
    /// Unbalance drives whirls at the speeds of bodies alone: where none turns with the machine its speed is that of no critical speed.
    fn turned(&self, system: &System) -> Result<Turned, Diagnostic> {
        let named = |s: &OtherSpin| s.name.is_some() && (self.spin.is_none() || s.name == self.spin);
        let spin = match &self.spin {
            Some(_) => system.spins().into_iter().find(named),
            None if turns_at(system, 1.0) => None,
            None => others(system).into_iter().find(named),
        };
        let name = spin.as_ref().and_then(|s| s.name.as_deref()).or(self.spin.as_deref());
        let turned = name.map(|name| system.at_spin(name).map_err(Diagnostics::into_error)).transpose()?;
        let sense = spin.as_ref().map_or(1.0, |s| s.ratio.signum());
        Ok(Turned { spin, system: turned, sense })
    }

    fn problem(&self, system: &System) -> Result<(SupportMap, Vec<Support>), Diagnostic> {
        let at = supporting::state(system, system.machine.speed.unwrap_or(0.0))?;
        let supports = supporting::of(system, &self.supports, &at);
        if supports.is_empty() {
            return Err(Diagnostic::error("support_map.none", text!("the machine has no support that could be replaced"))
                .help(text!("a support is a part with stiffness between what turns and what does not; supports names others")));
        }
        Ok((SupportMap::new(system, &supports, &at)?, supports))
    }

    /// Equal steps of the logarithm.
    fn values(&self, map: &SupportMap, rigid: &[Root], bearings: &[Bearing]) -> Vec<f64> {
        let (from, to, points) = match self.stiffness {
            Some(r) => (r.from, r.to, r.points.unwrap_or(POINTS)),
            None => {
                // where half the energy of the lowest critical speed is in the supports
                let half = |k: f64| map.roots(k.exp(), Spin::Synchronous, (0, 1)).first().map(|r| r.share - 0.5);
                let (low, high) = (1e2f64.ln(), 1e14f64.ln());
                let ends = half(low).zip(half(high)).filter(|(a, b)| a * b < 0.0);
                let middle = ends.and_then(|(a, b)| root(half, (low, a), (high, b), 1e-2)).map_or(1e7, f64::exp);
                let middle = if rigid.is_empty() { 1e7 } else { middle };
                let own = bearings.iter().flat_map(|b| &b.points).map(|p| p.1).filter(|k| *k > 0.0);
                let (least, most) = own.fold((f64::INFINITY, 0.0f64), |(a, b), k| (a.min(k), b.max(k)));
                ((middle / DECADES).min(0.3 * least), (middle * DECADES).max(3.0 * most), POINTS)
            }
        };
        let step = (to / from).ln() / (points.max(2) - 1) as f64;
        (0..points.max(2)).map(|i| if i + 1 == points.max(2) { to } else { from * (step * i as f64).exp() }).collect()
    }
}

/// Curves at one stiffness.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// Turning with the whirl, or at rest.
    pub spin: Spin,
    /// Of every support, N/m.
    pub stiffness: f64,
    /// The lowest roots.
    pub roots: Vec<Root>,
}

/// Stiffness of bearings over the speed, in a direction, that are alike.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Bearing {
    /// Slots, each in x (0) or y (1).
    pub of: Vec<(usize, usize)>,
    /// It does not depend on the speed.
    pub constant: bool,
    /// Speed, rad/s, and stiffness, N/m.
    pub points: Vec<(f64, f64)>,
}

/// A bearing as stiff as all supports at one of the critical speeds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Intersection {
    /// Index of the bearing.
    pub bearing: usize,
    /// Index of the curve.
    pub curve: usize,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// The critical speed.
    pub root: Root,
    /// Critical speed at that stiffness less the speed of the stiffness, over it.
    pub defect: f64,
}

/// See the [module](self).
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MapResult {
    /// By kind, then stiffness.
    pub curves: Vec<Row>,
    /// Critical speeds without supports; the number of motions of the rigid machine at zero speed.
    pub free: Vec<Root>,
    /// See `free`.
    pub still: usize,
    /// On rigid supports.
    pub rigid: Vec<Root>,
    /// Bearings of the machine that are linear.
    pub bearings: Vec<Bearing>,
    /// Where they meet the curves.
    pub intersections: Vec<Intersection>,
    /// No part prefers a direction, and only forward whirls were computed.
    pub forward_alone: bool,
    /// Slots of the parts replaced.
    pub supports: Vec<usize>,
    /// How the study ended.
    pub end: End,
}

/// The linear supports over the speed in one sense, up to one; those alike together.
fn bearings(system: &System, supports: &[Support], (sense, top): (f64, f64)) -> Vec<Bearing> {
    let mut out: Vec<Bearing> = Vec::new();
    for s in supports {
        let slot = &system.slots()[s.slot];
        let table = slot.part.scope().and_then(|scope| scope.tabulated());
        // a table is over the speed of its own spin
        let ratio = sense * slot.speed(system.params(), 1.0);
        let ends = table.map_or([0.0, top], |t| [t.from / ratio, t.to / ratio]);
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        for axis in 0..2 {
            let at = |w: f64| diagonal(system, s.slot, sense * w).map(|k| (w, k[axis]));
            let points: Option<Vec<(f64, f64)>> = (0..READ).map(|i| at(from + (to - from) * i as f64 / (READ - 1) as f64)).collect();
            let Some(points) = points.filter(|p| p.iter().any(|x| x.1 > 0.0)) else { continue };
            match out.iter_mut().find(|b| b.points == points) {
                Some(same) => same.of.push((s.slot, axis)),
                None => out.push(Bearing { of: vec![(s.slot, axis)], constant: points.iter().all(|p| p.1 == points[0].1), points }),
            }
        }
    }
    out
}

/// Where one bearing meets one curve.
fn meetings(system: &System, sense: f64, map: &SupportMap, (index, bearing): (usize, &Bearing), curve: usize) -> Vec<Intersection> {
    let Some(&(slot, axis)) = bearing.of.first() else { return Vec::new() };
    let of = |k: f64| map.roots(k, Spin::Synchronous, (curve, 1)).into_iter().next();
    let one = |w: Option<f64>, k: f64| {
        let root = of(k)?;
        let defect = w.map_or(0.0, |w| (root.speed / w - 1.0).abs());
        Some(Intersection { bearing: index, curve, stiffness: k, root, defect })
    };
    if bearing.constant {
        return one(None, bearing.points[0].1).into_iter().collect();
    }
    let mut out = Vec::new();
    let stiffness = |w: f64| diagonal(system, slot, sense * w).map(|k| k[axis]).filter(|k| *k > 0.0);
    let gap = |w: f64| stiffness(w).and_then(of).map(|r| r.speed - w);
    let gaps: Vec<(f64, Option<f64>)> = bearing.points.iter().map(|p| (p.0, gap(p.0))).collect();
    for pair in gaps.windows(2) {
        let ((a, Some(fa)), (b, Some(fb))) = (pair[0], pair[1]) else { continue };
        if fa * fb < 0.0 || fa == 0.0 {
            let w = if fa == 0.0 { Some(a) } else { root(gap, (a, fa), (b, fb), TOLERANCE * b) };
            out.extend(w.and_then(|w| one(Some(w), stiffness(w)?)));
        }
    }
    out
}
