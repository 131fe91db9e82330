//! Tables and the figure of a machine at rest.

use super::{Basis, Kind, Shown};
use crate::diagnostic::Diagnostic;
use crate::model::station::Station;
use crate::model::system::GRAVITY;
use crate::outcome::{Arg, Axis, Figure, Line, Message, Panel, Rule, Table, TableBuilder};
use crate::solve::statics::beam::{Beam, Cut};
use crate::study::shared::support::{beyond_rounding, inconsistent, largest};

/// Columns along a shaft, and the same on rigid supports, with units and meanings.
const NAMES: [&str; 8] = ["x", "y", "slope_x", "slope_y", "shear_x", "shear_y", "moment_x", "moment_y"];
const RIGID: [&str; 8] =
    ["rigid_x", "rigid_y", "rigid_slope_x", "rigid_slope_y", "rigid_shear_x", "rigid_shear_y", "rigid_moment_x", "rigid_moment_y"];
const ALIGNED: [&str; 8] = [
    "aligned_x",
    "aligned_y",
    "aligned_slope_x",
    "aligned_slope_y",
    "aligned_shear_x",
    "aligned_shear_y",
    "aligned_moment_x",
    "aligned_moment_y",
];
const UNITS: [&str; 8] = ["m", "m", "rad", "rad", "N", "N", "N m", "N m"];
const MEANINGS: [&str; 8] = [
    "deflection in x",
    "deflection in y",
    "slope of the section in the plane of x; NaN of a body that does not tilt",
    "slope of the section in the plane of y; NaN of a body that does not tilt",
    "shear force in x: of what is below on what is above",
    "shear force in y: of what is below on what is above",
    "bending moment in the plane of x, positive where the curvature is",
    "bending moment in the plane of y, positive where the curvature is",
];
/// Columns of reactions, likewise.
const FORCES: [&str; 4] = ["x", "y", "about_x", "about_y"];
const RIGID_FORCES: [&str; 4] = ["rigid_x", "rigid_y", "rigid_about_x", "rigid_about_y"];
const ALIGNED_FORCES: [&str; 4] = ["aligned_x", "aligned_y", "aligned_about_x", "aligned_about_y"];
const FORCE_MEANINGS: [&str; 4] = [
    "force on the turning body, else on the first, in x; NaN of a part that is left out",
    "force on the turning body, else on the first, in y; NaN of a part that is left out",
    "moment about x; NaN of a part that does not act on tilt",
    "moment about y; NaN of a part that does not act on tilt",
];

/// A quantity of a cut by its column, on one of its sides.
fn value(c: &Cut, column: usize, side: usize) -> f64 {
    let p = column % 2;
    match column / 2 {
        0 => c.deflection[p],
        1 => c.slope[p],
        2 => c.shear[side][p],
        _ => c.moment[side][p],
    }
}

impl Basis {
    /// What a column means.
    fn meaning(self, what: &'static str) -> Arg {
        match self {
            Basis::Own => what.into(),
            Basis::Rigid => Arg::noted(what, "on rigid supports"),
            Basis::Aligned => Arg::noted(what, "with the couplings free of load"),
        }
    }

    /// Columns along a shaft.
    fn names(self) -> [&'static str; 8] {
        match self {
            Basis::Own => NAMES,
            Basis::Rigid => RIGID,
            Basis::Aligned => ALIGNED,
        }
    }

    /// Columns of reactions.
    fn forces(self) -> [&'static str; 4] {
        match self {
            Basis::Own => FORCES,
            Basis::Rigid => RIGID_FORCES,
            Basis::Aligned => ALIGNED_FORCES,
        }
    }

    fn word(self) -> &'static str {
        match self {
            Basis::Own => "own",
            Basis::Rigid => "rigid",
            Basis::Aligned => "aligned",
        }
    }
}

impl Shown<'_> {
    /// Body and stations: index of the beam, of the node, and of the side.
    fn rows(&self) -> Vec<(usize, usize, usize)> {
        let jumps = |kind: Option<&Kind>, b: usize, i: usize| {
            kind.is_some_and(|k| {
                let c = &k.beams[b].cuts[i];
                c.shear[0] != c.shear[1] || c.moment[0] != c.moment[1]
            })
        };
        let mut out = Vec::new();
        for (b, beam) in self.result.own.beams.iter().enumerate() {
            for i in 0..beam.cuts.len() {
                out.push((b, i, 0));
                if self.kinds().into_iter().any(|(_, k)| jumps(Some(k), b, i)) {
                    out.push((b, i, 1));
                }
            }
        }
        out
    }

    /// The largest in both planes of what a column holds: beside it less is rounding.
    fn size(&self, kind: &Kind, column: usize) -> f64 {
        let both = [column - column % 2, column - column % 2 + 1];
        let cuts = || kind.beams.iter().flat_map(|b| &b.cuts);
        largest(both.into_iter().flat_map(|k| cuts().map(move |c| value(c, k, 0).abs().max(value(c, k, 1).abs()))))
    }

    /// Along every body that bends: two rows where a force or a moment acts.
    pub(super) fn shafts(&self) -> Result<Table, Diagnostic> {
        let rows = self.rows();
        let beam = |b: usize| &self.result.own.beams[b];
        let mut table = Table::new("shafts", "Along the shafts, just below and just above every node where a force acts")
            .names("body", "body that bends", rows.iter().map(|r| self.name(beam(r.0).slot)).collect())
            .float("position", "m", "position along the shaft", rows.iter().map(|r| beam(r.0).cuts[r.1].position).collect());
        for (basis, kind) in self.kinds() {
            for (k, unit) in UNITS.into_iter().enumerate() {
                let size = self.size(kind, k);
                let values = rows.iter().map(|r| beyond_rounding(value(&kind.beams[r.0].cuts[r.1], k, r.2), size)).collect();
                table = table.float(basis.names()[k], unit, basis.meaning(MEANINGS[k]), values);
            }
        }
        table.build().map_err(inconsistent)
    }

    /// On own stiffness, on rigid supports, and at the heights that free the couplings.
    pub(super) fn kinds(&self) -> Vec<(Basis, &Kind)> {
        let train = self.result.alignment.as_ref().and_then(|a| a.train.as_ref());
        let rigid = self.result.rigid.iter().map(|k| (Basis::Rigid, k));
        std::iter::once((Basis::Own, &self.result.own)).chain(rigid).chain(train.map(|t| (Basis::Aligned, &t.kind))).collect()
    }

    pub(super) fn name(&self, slot: usize) -> String {
        self.system.slots()[slot].name.clone()
    }

    /// Slope of a station: of a rigid body its tilt, of one that bends that of the section.
    fn slope(&self, station: &Station, kind: &Kind) -> [f64; 2] {
        if let Some(tilt) = &station.tilt {
            let [about_x, about_y] = tilt.of(&kind.state.q);
            return [about_y, -about_x];
        }
        let beam = kind.beams.iter().find(|b| b.slot == station.slot);
        let near = |c: &&Cut| (c.position - station.position).abs();
        let cut = beam.and_then(|b| b.cuts.iter().min_by(|a, b| near(a).total_cmp(&near(b))));
        cut.map_or([f64::NAN; 2], |c| c.slope)
    }

    /// Deflection of every station.
    pub(super) fn stations(&self) -> Result<Table, Diagnostic> {
        let all = self.system.stations();
        let column = |f: &dyn Fn(&Station) -> f64| all.iter().map(f).collect::<Vec<f64>>();
        let mut table = Table::new("stations", "Deflection at rest of every station").leading().names(
            "station",
            "body, or place of a shaft",
            all.iter().map(|s| s.name.clone()).collect(),
        );
        for (basis, kind) in self.kinds() {
            let size = largest(all.iter().map(|s| s.lateral.length(&kind.state.q)));
            let at = |s: &Station, k: usize| match k {
                0 | 1 => beyond_rounding(s.lateral.of(&kind.state.q)[k], size),
                _ => self.slope(s, kind)[k - 2],
            };
            for k in 0..4 {
                let name = basis.names()[k];
                table = table.float_if_any(name, UNITS[k], basis.meaning(MEANINGS[k]), column(&|s| at(s, k)));
            }
        }
        table.build().map_err(inconsistent)
    }

    /// Loads of all parts between two points and of bodies on springs.
    pub(super) fn reactions(&self) -> Result<Table, Diagnostic> {
        let mut slots: Vec<usize> = self.kinds().iter().flat_map(|(_, k)| &k.reactions).map(|r| r.slot).collect();
        slots.sort_unstable();
        slots.dedup();
        let mut table: TableBuilder = Table::new("reactions", "Forces with which parts carry the machine at rest").leading().names(
            "part",
            "part",
            slots.iter().map(|&s| self.name(s)).collect(),
        );
        for (basis, kind) in self.kinds() {
            let size = largest(kind.reactions.iter().flat_map(|r| r.force).map(f64::abs));
            let of = |s: usize, k: usize| {
                let reaction = kind.reactions.iter().find(|r| r.slot == s);
                match k {
                    0 | 1 => reaction.map_or(f64::NAN, |r| beyond_rounding(r.force[k], size)),
                    _ => reaction.and_then(|r| r.moment).map_or(f64::NAN, |m| m[k - 2]),
                }
            };
            for k in 0..4 {
                let name = basis.forces()[k];
                let values = slots.iter().map(|&s| of(s, k)).collect();
                table = table.float_if_any(name, if k < 2 { "N" } else { "N m" }, basis.meaning(FORCE_MEANINGS[k]), values);
            }
        }
        table.build().map_err(inconsistent)
    }

    /// Mass, centre of mass, moments of inertia.
    pub(super) fn mass_properties(&self) -> Result<Table, Diagnostic> {
        let all = &self.result.masses;
        let column = |f: fn(&crate::solve::statics::masses::MassProperties) -> f64| all.iter().map(f).collect::<Vec<f64>>();
        Table::new("mass_properties", "Mass, centre of mass and moments of inertia, of every part and of every body with all it carries")
            .names("body", "body that gives the coordinates", all.iter().map(|m| self.name(m.body)).collect())
            .names("part", "part; of the whole the body itself", all.iter().map(|m| self.name(m.part.unwrap_or(m.body))).collect())
            .flag("whole", "the body with all it carries", all.iter().map(|m| m.part.is_none()).collect())
            .float("mass", "kg", "mass", column(|m| m.mass))
            .float("weight", "N", "weight", column(|m| GRAVITY * m.mass))
            .float(
                "centre",
                "m",
                "centre of mass along the axis, from the reference point or the lower end of the body; NaN of a body that does not tilt",
                column(|m| m.centre),
            )
            .float("polar", "kg m^2", "moment of inertia about the axis; NaN of a body that does not tilt", column(|m| m.polar))
            .float(
                "diametral",
                "kg m^2",
                "moment of inertia about an axis across it through the centre of mass; NaN of a body that does not tilt",
                column(|m| m.diametral),
            )
            .build()
            .map_err(inconsistent)
    }

    /// Deflection, shear and moment along the shafts.
    pub(super) fn figure(&self) -> Figure {
        let several = self.result.own.beams.len() > 1;
        let cuts = |f: &dyn Fn(&Cut) -> f64| largest(self.kinds().iter().flat_map(|(_, k)| &k.beams).flat_map(|b: &Beam| &b.cuts).map(f));
        let moved = cuts(&|c| c.deflection[0].hypot(c.deflection[1]));
        let lines = |mut panel: Panel, first: usize| {
            for (plane, p) in [("y", 1), ("x", 0)] {
                for (basis, kind) in self.kinds() {
                    let k = first + p;
                    // a direction in which nothing pushes is left out
                    let own = largest(kind.beams.iter().flat_map(|b| &b.cuts).map(|c| value(c, k, 0).abs().max(value(c, k, 1).abs())));
                    if p == 0 && !(own > 1e-9 * self.size(kind, k)) {
                        continue;
                    }
                    let label = Message::new("static-line").arg("plane", Arg::word(plane)).arg("supports", Arg::word(basis.word()));
                    let line = Line::new("shafts", "position", basis.names()[k]).name(label);
                    panel = panel.mark(if several { line.group("body") } else { line });
                }
            }
            panel
        };
        let length = Axis::new("position along the shaft", "m").metres(cuts(&|c| c.position));
        let mut deflection = lines(Panel::new(Axis::new("deflection", "m").metres(moved)).height(1.2), 0);
        for s in self.result.supports.iter().filter_map(|&s| crate::solve::statics::supports::named(self.system, s)) {
            if let Some(position) = self.result.own.beams.iter().find(|b| b.slot == s.body).map(|_| s.position).filter(|_| !several) {
                deflection = deflection.mark(Rule::x(position, Arg::name(self.name(s.slot))));
            }
        }
        let couplings = self.result.alignment.iter().flat_map(|a| &a.couplings).filter(|_| !several);
        deflection = couplings.fold(deflection, |panel, c| panel.mark(Rule::x(c.position, Arg::name(&c.name))));
        let shear = lines(Panel::new(Axis::new("shear force", "N")), 4);
        let moment = lines(Panel::new(Axis::new("bending moment", "N m")), 6);
        let alt = Message::new("static-alt").arg("shafts", Arg::count(self.result.own.beams.len()));
        Figure::new("static", "Deflection, shear force and bending moment at rest", alt)
            .x(length)
            .panel(deflection)
            .panel(shear)
            .panel(moment)
    }
}
