//! What a machine at rest says.

use super::{Kind, Shown};
use crate::model::system::GRAVITY;
use crate::outcome::{Arg, Finding};
use crate::solve::characteristic::{Equilibrium, Frame};
use crate::study::shared::support::{largest, state_remarks};

impl Shown<'_> {
    /// In the order of interest.
    pub(super) fn findings(&self) -> Vec<Finding> {
        let mut out = Vec::new();
        let own = &self.result.own;
        if self.result.loaded() {
            out.extend(self.deflection(own, Finding::info("sag", "static-sag")));
            out.extend(self.result.rigid.iter().filter_map(|k| self.deflection(k, Finding::info("rigid_sag", "static-rigid-sag"))));
            out.extend(self.load());
            out.extend(self.moment());
        } else {
            let sentence = if self.result.horizontal { "static-weightless" } else { "static-vertical" };
            let finding = Finding::info("not_loaded", sentence);
            out.push(finding.arg("weight", Arg::quantity(self.result.weight(), "N")));
        }
        out.extend(self.alignment_findings());
        if self.result.not_held {
            out.push(Finding::warning("not_held", "static-not-held"));
        }
        out.extend(self.masses());
        let state = &own.state;
        let remarks = |q: Vec<f64>| {
            state_remarks(self.system, &Equilibrium { q, z: state.z.clone(), ..Equilibrium::zero(self.system, Frame::Fixed, state.speed) })
        };
        // a part that is raised has its own displacement
        let raised: Vec<String> = state.raised.iter().map(|r| self.name(r.slot)).collect();
        out.extend(remarks(state.q.clone()).into_iter().filter(|f| !raised.contains(&f.subject)));
        for (r, name) in state.raised.iter().zip(&raised) {
            out.extend(remarks(r.seen(&state.q)).into_iter().filter(|f| f.subject == *name));
        }
        out
    }

    /// The largest deflection: of all nodes of bodies that bend, and of the stations of others.
    fn deflection(&self, kind: &Kind, finding: Finding) -> Option<Finding> {
        let stations = self.system.stations().iter().map(|s| (s.name.clone(), s.slot, None, s.lateral.of(&kind.state.q)));
        let nodes = kind.beams.iter().flat_map(|b| b.cuts.iter().map(|c| (self.name(b.slot), b.slot, Some(c.position), c.deflection)));
        // what sits on a body that bends moves with it
        let bent = |slot: usize| self.system.slots()[slot].own.is_empty() || kind.beams.iter().any(|b| b.slot == slot);
        let all = nodes.chain(stations.filter(|s| !bent(s.1)));
        let (name, _, position, [x, y]) = all.max_by(|a, b| a.3[0].hypot(a.3[1]).total_cmp(&b.3[0].hypot(b.3[1])))?;
        let finding = finding
            .of(name.clone())
            .value(x.hypot(y), "m")
            .arg("body", Arg::name(name))
            .arg("place", Arg::word(if position.is_some() { "along" } else { "body" }))
            .arg("position", Arg::quantity(position.unwrap_or(0.0), "m"))
            .arg("speed", Arg::speed(kind.state.speed))
            .arg("load", Arg::word(self.load_word(kind)));
        Some(self.evidence(finding, kind).evidence("last Newton step over typical size", kind.state.last_step, ""))
    }

    /// What deflects the machine beside, or instead of, its weight.
    fn load_word(&self, kind: &Kind) -> &'static str {
        let raised = !kind.state.raised.is_empty();
        match (self.result.horizontal, raised) {
            (true, false) => "weight",
            (true, true) => "offsets",
            (false, false) => "force",
            (false, true) => "raised",
        }
    }

    /// What supports the forces of a kind.
    fn evidence(&self, finding: Finding, kind: &Kind) -> Finding {
        let defect = |f: fn(&crate::solve::statics::beam::Beam) -> f64| {
            if kind.beams.is_empty() { f64::NAN } else { largest(kind.beams.iter().map(f)) }
        };
        finding
            .evidence("weight that no reaction carries, over the weight", kind.defect, "")
            .evidence("shear force left over at the end of a shaft, over all forces", defect(|b| b.force_defect), "")
            .evidence("moment left over at the end of a shaft, over all forces times its length", defect(|b| b.moment_defect), "")
    }

    /// The most loaded support.
    fn load(&self) -> Option<Finding> {
        let supports = &self.result.supports;
        let size = |r: &&super::Reaction| r.force[0].hypot(r.force[1]);
        let own = &self.result.own;
        let most = own.reactions.iter().filter(|r| supports.contains(&r.slot)).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        let rigid = self.result.rigid.as_ref().and_then(|k| k.reactions.iter().find(|r| r.slot == most.slot));
        let name = self.name(most.slot);
        let finding = Finding::info("largest_load", "static-load")
            .of(name.clone())
            .value(size(&most), "N")
            .arg("part", Arg::name(name))
            .arg("weight", Arg::quantity(self.result.weight(), "N"));
        let finding = finding.evidence("the same on rigid supports", rigid.map_or(f64::NAN, |r| size(&r)), "N");
        Some(self.evidence(finding, own))
    }

    /// The largest bending moment.
    fn moment(&self) -> Option<Finding> {
        let kind = &self.result.own;
        let size = |m: [f64; 2]| m[0].hypot(m[1]);
        let all = kind.beams.iter().flat_map(|b| b.cuts.iter().flat_map(move |c| c.moment.map(|m| (b.slot, c.position, size(m)))));
        let (slot, position, moment) = all.max_by(|a, b| a.2.total_cmp(&b.2))?;
        let name = self.name(slot);
        let finding = Finding::info("largest_moment", "static-moment")
            .of(name.clone())
            .value(moment, "N m")
            .arg("body", Arg::name(name))
            .arg("position", Arg::quantity(position, "m"));
        let rigid = self.result.rigid.iter().flat_map(|k| &k.beams).flat_map(|b| &b.cuts).flat_map(|c| c.moment).map(size);
        let finding = match &self.result.rigid {
            Some(_) => finding.evidence("largest on rigid supports", largest(rigid), "N m"),
            None => finding,
        };
        Some(self.evidence(finding, kind))
    }

    /// Mass properties of every body with mass.
    fn masses(&self) -> Vec<Finding> {
        let whole = self.result.masses.iter().filter(|m| m.part.is_none() && m.mass > 0.0);
        let one = |m: &crate::solve::statics::masses::MassProperties| {
            let name = self.name(m.body);
            let finding = Finding::info("mass", "static-mass").of(name.clone()).value(m.mass, "kg").arg("body", Arg::name(name));
            let known = m.centre.is_finite();
            let finding = finding
                .arg("tilts", Arg::word(if known { "yes" } else { "no" }))
                .arg("centre", Arg::quantity(if known { m.centre } else { 0.0 }, "m"))
                .arg("polar", Arg::quantity(if known { m.polar } else { 0.0 }, "kg m^2"))
                .arg("diametral", Arg::quantity(if known { m.diametral } else { 0.0 }, "kg m^2"));
            finding.evidence("weight", GRAVITY * m.mass, "N")
        };
        whole.map(one).collect()
    }
}
