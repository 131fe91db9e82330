//! Tables and findings of offsets of supports, their influence and the alignment of couplings.

use super::aligned::{Alignment, Influence};
use super::{Kind, Shown};
use crate::diagnostic::Diagnostic;
use crate::outcome::{Arg, Finding, Table};
use crate::solve::statics::offsets::Offset;
use crate::study::shared::support::{beyond_rounding, inconsistent, largest};

/// Share of the largest influence below which an influence is rounding.
const DETERMINATE: f64 = 1e-7;

fn of(offsets: &[Offset], slot: usize) -> [f64; 2] {
    offsets.iter().find(|o| o.slot == slot).map_or([0.0; 2], |o| o.by)
}

fn force(kind: &Kind, slot: usize) -> [f64; 2] {
    kind.reactions.iter().find(|r| r.slot == slot).map_or([f64::NAN; 2], |r| r.force)
}

impl Shown<'_> {
    /// Offsets and loads, influence, couplings.
    pub(super) fn alignment_tables(&self) -> Result<Vec<Table>, Diagnostic> {
        let Some(a) = &self.result.alignment else { return Ok(Vec::new()) };
        let mut out = Vec::new();
        if a.level.is_some() || a.train.is_some() {
            out.push(self.offsets(a)?);
        }
        if !a.influence.is_empty() {
            out.push(self.influence(a)?);
        }
        if !a.couplings.is_empty() {
            out.push(self.couplings(a)?);
        }
        Ok(out)
    }

    fn offsets(&self, a: &Alignment) -> Result<Table, Diagnostic> {
        let slots = &self.result.supports;
        let column = |f: &dyn Fn(usize) -> f64| slots.iter().map(|&s| f(s)).collect::<Vec<f64>>();
        let mut table = Table::new("offsets", "Offsets of the supports, and the loads that they carry")
            .names("support", "part that supports the rotor", slots.iter().map(|&s| self.name(s)).collect())
            .float("offset_x", "m", "offset in x", column(&|s| of(&a.offsets, s)[0]))
            .float("offset_y", "m", "height in y", column(&|s| of(&a.offsets, s)[1]));
        let own = &self.result.own;
        let size = |k: &Kind| largest(slots.iter().flat_map(|&s| force(k, s)).map(f64::abs));
        if let Some(level) = &a.level {
            let at = |k: &Kind, s: usize, p: usize| beyond_rounding(force(k, s)[p], size(k));
            table = table
                .float("level_x", "N", "load in x without offsets", column(&|s| at(level, s, 0)))
                .float("level_y", "N", "load in y without offsets", column(&|s| at(level, s, 1)))
                .float("load_x", "N", "load in x with them", column(&|s| at(own, s, 0)))
                .float("load_y", "N", "load in y with them", column(&|s| at(own, s, 1)));
        }
        if let Some(t) = &a.train {
            let most = largest(t.offsets.iter().flat_map(|o| o.by).map(f64::abs));
            table = table
                .float(
                    "aligned_offset_x",
                    "m",
                    "offset in x that frees the couplings of load",
                    column(&|s| beyond_rounding(of(&t.offsets, s)[0], most)),
                )
                .float(
                    "aligned_offset_y",
                    "m",
                    "height in y that frees the couplings of load",
                    column(&|s| beyond_rounding(of(&t.offsets, s)[1], most)),
                );
        }
        table.build().map_err(inconsistent)
    }

    fn influence(&self, a: &Alignment) -> Result<Table, Diagnostic> {
        let rows = &a.influence;
        let column = |f: &dyn Fn(&Influence) -> f64| rows.iter().map(f).collect::<Vec<f64>>();
        let own = |p: usize, q: usize| column(&|i| beyond_rounding(i.own[p][q], a.largest));
        let table = Table::new("influence", "Change of the load of a support per offset of a support")
            .names("load_of", "support whose load changes", rows.iter().map(|r| self.name(r.load_of)).collect())
            .names("raised", "support that is displaced", rows.iter().map(|r| self.name(r.raised)).collect())
            .float("xx", "N/m", "load in x per offset in x", own(0, 0))
            .float("xy", "N/m", "load in x per height in y", own(0, 1))
            .float("yx", "N/m", "load in y per offset in x", own(1, 0))
            .float("yy", "N/m", "load in y per height in y", own(1, 1))
            .float_if_any("rigid_xx", "N/m", Arg::noted("load in x per offset in x", "on rigid supports"), column(&|i| i.rigid[0][0]))
            .float_if_any("rigid_yy", "N/m", Arg::noted("load in y per height in y", "on rigid supports"), column(&|i| i.rigid[1][1]));
        table.build().map_err(inconsistent)
    }

    fn couplings(&self, a: &Alignment) -> Result<Table, Diagnostic> {
        type Loads = ([f64; 2], [f64; 2]);
        let rows = &a.couplings;
        let kinds = self.kinds();
        let cuts = || kinds.iter().flat_map(|(_, k)| &k.beams).flat_map(|b| &b.cuts);
        let shear = largest(cuts().flat_map(|c| c.shear).flatten().map(f64::abs));
        let moment = largest(cuts().flat_map(|c| c.moment).flatten().map(f64::abs));
        let force = |l: Loads, p: usize| beyond_rounding(l.0[p], shear);
        let bending = |l: Loads, p: usize| beyond_rounding(l.1[p], moment);
        let given = |f: &dyn Fn(Loads) -> f64| rows.iter().map(|c| f(c.given)).collect::<Vec<f64>>();
        let freed = |f: &dyn Fn(Loads) -> f64| rows.iter().map(|c| f(c.aligned)).collect::<Vec<f64>>();
        let table = Table::new("couplings", "Shear forces and bending moments at the couplings")
            .names("place", "coupling, or place of a shaft", rows.iter().map(|c| c.name.clone()).collect())
            .float("position", "m", "position along the shaft", rows.iter().map(|c| c.position).collect())
            .float("shear_x", "N", "shear force in x", given(&|l| force(l, 0)))
            .float("shear_y", "N", "shear force in y", given(&|l| force(l, 1)))
            .float("moment_x", "N m", "bending moment in the plane of x", given(&|l| bending(l, 0)))
            .float("moment_y", "N m", "bending moment in the plane of y", given(&|l| bending(l, 1)));
        let noted = |what: &'static str| Arg::noted(what, "with the couplings free of load");
        let table = table
            .float_if_any("aligned_shear_x", "N", noted("shear force in x"), freed(&|l| force(l, 0)))
            .float_if_any("aligned_shear_y", "N", noted("shear force in y"), freed(&|l| force(l, 1)))
            .float_if_any("aligned_moment_x", "N m", noted("bending moment in the plane of x"), freed(&|l| bending(l, 0)))
            .float_if_any("aligned_moment_y", "N m", noted("bending moment in the plane of y"), freed(&|l| bending(l, 1)));
        table.build().map_err(inconsistent)
    }

    /// In the order of interest.
    pub(super) fn alignment_findings(&self) -> Vec<Finding> {
        let Some(a) = &self.result.alignment else { return Vec::new() };
        let mut out = self.unloaded(a);
        out.extend(self.changed(a));
        out.extend(self.most_sensitive(a));
        for c in &a.couplings {
            let size = |v: [f64; 2]| v[0].hypot(v[1]);
            let most = largest(self.result.own.beams.iter().flat_map(|b| &b.cuts).flat_map(|c| c.moment).map(size));
            let finding = Finding::info("coupling_moment", "static-coupling").of(c.name.clone());
            out.push(
                finding
                    .value(beyond_rounding(size(c.given.1), most), "N m")
                    .arg("place", Arg::name(&c.name))
                    .arg("shear", Arg::quantity(size(c.given.0), "N"))
                    .evidence("largest along the shafts", most, "N m"),
            );
        }
        out.extend(self.aligned(a));
        if a.unaligned {
            out.push(Finding::warning("not_aligned", "static-not-aligned"));
        }
        out
    }

    /// Supports whose load turns round: a bearing does not hold a shaft down.
    fn unloaded(&self, a: &Alignment) -> Vec<Finding> {
        let Some(level) = a.level.as_ref().filter(|_| self.result.horizontal) else { return Vec::new() };
        let one = |&slot: &usize| {
            let (before, now) = (force(level, slot)[1], force(&self.result.own, slot)[1]);
            (before > 0.0 && now < 0.0).then(|| {
                Finding::warning("unloaded", "static-unloaded")
                    .of(self.name(slot))
                    .value(-now, "N")
                    .arg("part", Arg::name(self.name(slot)))
                    .evidence("load without offsets", before, "N")
            })
        };
        self.result.supports.iter().filter_map(one).collect()
    }

    /// The support whose load the offsets change most.
    fn changed(&self, a: &Alignment) -> Option<Finding> {
        let level = a.level.as_ref()?;
        let own = &self.result.own;
        let change = |slot: usize| [0, 1].map(|p| force(own, slot)[p] - force(level, slot)[p]);
        let size = |v: [f64; 2]| v[0].hypot(v[1]);
        let slots = &self.result.supports;
        let most = *slots.iter().max_by(|a, b| size(change(**a)).total_cmp(&size(change(**b))))?;
        let sum = slots.iter().fold([0.0; 2], |s, &k| [s[0] + change(k)[0], s[1] + change(k)[1]]);
        let all = largest(slots.iter().map(|&k| size(force(own, k)).max(size(force(level, k)))));
        let relative = |x: f64| if all > 0.0 { x / all } else { x };
        if !(relative(size(change(most))) > DETERMINATE) {
            return Some(Finding::info("offsets_without_effect", "static-offsets-free").evidence(
                "largest change of a load over the largest load",
                relative(size(change(most))),
                "",
            ));
        }
        let (before, now) = (force(level, most), force(own, most));
        // negative where the load turns round
        let turned = if before[0] * now[0] + before[1] * now[1] < 0.0 { -1.0 } else { 1.0 };
        let finding = Finding::info("offset_load", "static-offset-load")
            .of(self.name(most))
            .value(turned * size(now), "N")
            .arg("part", Arg::name(self.name(most)))
            .arg("before", Arg::quantity(size(before), "N"));
        Some(finding.evidence("sum of all changes over the largest load", relative(size(sum)), ""))
    }

    /// The support whose own load grows most per height.
    fn most_sensitive(&self, a: &Alignment) -> Option<Finding> {
        let own = |i: &&Influence| i.load_of == i.raised;
        let most = a.influence.iter().filter(own).max_by(|a, b| a.own[1][1].total_cmp(&b.own[1][1]))?;
        // a free machine has what rounding leaves of the stiffness of its parts
        let scale = self.stiffest();
        if !(most.own[1][1] > DETERMINATE * scale) {
            return Some(Finding::info("determinate", "static-determinate").evidence(
                "largest influence over the stiffest support",
                a.largest / scale,
                "",
            ));
        }
        let sum: f64 = a.influence.iter().filter(|i| i.raised == most.raised).map(|i| i.own[1][1]).sum();
        let finding = Finding::info("influence", "static-influence")
            .of(self.name(most.raised))
            .value(most.own[1][1], "N/m")
            .arg("part", Arg::name(self.name(most.raised)));
        let rigid = most.rigid[1][1];
        Some(
            finding
                .evidence("on rigid supports", rigid, "N/m")
                .evidence("changes of all loads added up, over it", sum / most.own[1][1], "")
                .evidence("largest difference from the transpose (Maxwell), over the largest influence", a.skew / a.largest, ""),
        )
    }

    /// Load of the supports over what they give way by, N/m, the largest.
    fn stiffest(&self) -> f64 {
        let own = |&slot: &usize| {
            crate::solve::statics::supports::diagonal(self.system, slot, self.result.own.state.speed).map_or(0.0, |k| k[0].max(k[1]))
        };
        let found = largest(self.result.supports.iter().map(own));
        if found > 0.0 { found } else { 1.0 }
    }

    /// Heights of the aligned train.
    fn aligned(&self, a: &Alignment) -> Vec<Finding> {
        let Some(t) = &a.train else { return Vec::new() };
        let size = |v: [f64; 2]| v[0].hypot(v[1]);
        let most = largest(t.offsets.iter().flat_map(|o| o.by).map(f64::abs));
        let one = |&slot: &usize| {
            let [x, y] = of(&t.offsets, slot);
            Finding::info("aligned", "static-aligned")
                .of(self.name(slot))
                .value(beyond_rounding(y, most), "m")
                .arg("part", Arg::name(self.name(slot)))
                .arg("sideways", Arg::quantity(beyond_rounding(x, most), "m"))
                .arg("aside", Arg::word(if beyond_rounding(x, most) == 0.0 { "no" } else { "yes" }))
                .arg("load", Arg::quantity(size(force(&t.kind, slot)), "N"))
                .evidence("load left at the couplings, over the largest moment along the shafts", t.left, "")
        };
        let mut out: Vec<Finding> = t.movable.iter().map(one).collect();
        if t.spare > 0 {
            out.push(Finding::info("spare_heights", "static-spare").arg("spare", Arg::count(t.spare)));
        }
        out
    }
}
