//! All mistakes of a file that has some: every stage runs over what is there.
//!
//! A block that could not be read exists all the same: values stand in for those that are missing, and where there is nothing to go on a
//! body that has every coordinate stands in for the whole block. The file is examined twice, with different values: what both find is
//! wrong whatever was meant. What names coordinates or parameters of such a block says nothing.

use super::assemble::{assembled, extra, machine};
use super::draft::{Draft, Drafted, invented};
use super::stand_in::{NOWHERE, Side, number};
use super::{Block, absent, joints, stages};
use crate::diagnostic::{Absent, Diagnostic, Diagnostics, Severity};
use crate::model::field::{Attach, Bounds, Extra, KindInfo, Value};
use crate::model::params::ParamSlot;
use crate::model::system::{PartInput, System};
use crate::parts::{self, Built, PartKind};
use crate::study;
use std::collections::BTreeSet;

/// `found` and what else is wrong.
pub(super) fn all(draft: &Draft, mut found: Diagnostics) -> Diagnostics {
    let (low, high) = (World::new(draft, Side::Low).examine(), World::new(draft, Side::High).examine());
    let same = |a: &Diagnostic, b: &Diagnostic| (a.code, &a.span, &a.message) == (b.code, &b.span, &b.message);
    for mut d in low.0 {
        let Some(twin) = high.0.iter().find(|o| same(o, &d)) else { continue };
        if d.span == Some(NOWHERE) || found.0.iter().any(|o| same(o, &d)) {
            continue;
        }
        if twin.help != d.help {
            d.help = None;
        }
        found.push(d);
    }
    let registry = parts::registry();
    absent::gather(draft, found, |kind| kind.is_empty() || invented_part(&registry, kind, Side::Low).is_some_and(|p| p.0.layout().body))
}

/// The file with one choice of what stands in.
struct World<'a> {
    draft: &'a Draft,
    side: Side,
    /// Blocks whose coordinates and parameters are not known.
    doubtful: BTreeSet<String>,
    out: Diagnostics,
}

impl<'a> World<'a> {
    fn new(draft: &'a Draft, side: Side) -> Self {
        let blocks = draft.parts.iter().chain(&draft.extras);
        let doubtful = blocks.filter(|d| !d.sound).map(|d| d.block.name.clone()).chain(draft.strange.iter().cloned()).collect();
        World { draft, side, doubtful, out: Diagnostics::default() }
    }

    fn examine(mut self) -> Diagnostics {
        let inputs = self.parts();
        let known = study::blocks();
        let extras: Vec<(Extra, Block)> = self.draft.extras.iter().filter_map(|d| self.extra(d, &known)).collect();
        let mut block = self.draft.machine.clone();
        if self.draft.machine_unread.contains(&"speed") {
            block.speed = Some(number(&Bounds::up_to(1e4), self.side));
        }
        match assembled(machine(&block, extras.iter().map(|e| e.0.clone()).collect()), inputs) {
            Ok(system) => {
                for (extra, block) in &extras {
                    if !stages::extra(&known, extra, block, &system, &mut self.out) {
                        self.doubtful.insert(block.name.clone());
                    }
                }
                self.studies(&system);
            }
            // a place that is not on its body is reported where it is written
            Err(found) => {
                let known = |d: &Diagnostic| d.code == "body.position" && self.out.0.iter().any(|o| o.code == d.code);
                let new: Vec<Diagnostic> = found.0.into_iter().filter(|d| !known(d)).collect();
                self.out.0.extend(new);
            }
        }
        let doubtful = |a: &Absent| self.draft.parts.is_empty() || self.doubtful.contains(a.block());
        self.out.0.retain(|d| d.severity == Severity::Error && !d.about.as_deref().is_some_and(doubtful));
        self.out
    }

    /// Every part under its name, or what stands in for it.
    fn parts(&mut self) -> Vec<PartInput> {
        let registry = parts::registry();
        let draft = self.draft;
        let infos: Vec<KindInfo> = registry.iter().map(|k| k.info.clone()).collect();
        let blocks: Vec<Block> = draft.parts.iter().map(|d| completed(d, &infos, self.side)).collect();
        let (built, fine): (Vec<Option<PartInput>>, Vec<bool>) = blocks
            .iter()
            .map(|b| stages::part(&registry, b, &mut self.out))
            .map(|(input, fine)| (input.filter(|p| admissible(&p.part.slots(), &p.params)), fine))
            .unzip();
        joints::check(&blocks, &built, &draft.strange, &mut self.out);

        let stranger = stranger(&registry, self.side);
        let stand_in = |name: &str, kind: &str| {
            let (part, params) = invented_part(&registry, kind, self.side).or_else(|| stranger.clone())?;
            Some(PartInput { name: name.to_string(), part, params, span: None })
        };
        let mut inputs: Vec<(PartInput, Option<&Block>)> = Vec::new();
        for ((block, input), fine) in blocks.iter().zip(&built).zip(&fine) {
            if inputs.iter().any(|i| i.0.name == block.name) {
                continue;
            }
            let own = input.clone().filter(|_| *fine);
            if own.is_none() {
                self.doubtful.insert(block.name.clone());
            }
            inputs.extend(own.map(|p| (p, Some(block))).or_else(|| Some((stand_in(&block.name, block.kind)?, None))));
        }
        for name in &draft.strange {
            if !inputs.iter().any(|i| &i.0.name == name) {
                inputs.extend(stand_in(name, "").map(|p| (p, None)));
            }
        }
        // where it is said already that there are no parts, or that a body is missing, studies have fields of their own
        if (draft.parts.is_empty() || self.out.0.iter().any(|d| d.code == "body.missing")) && !inputs.iter().any(|i| i.0.part.layout().body)
        {
            inputs.extend(stand_in("body", "").map(|p| (p, None)));
        }
        // what joins points that are none is joined to the ground instead
        let bodies: BTreeSet<String> = inputs.iter().filter(|i| i.0.part.layout().body).map(|i| i.0.name.clone()).collect();
        let one = |(input, block): (PartInput, Option<&Block>)| match block.and_then(|b| grounded(b, &bodies)) {
            Some(b) => stages::part(&registry, &b, &mut Diagnostics::default()).0.or_else(|| stand_in(&b.name, b.kind)),
            None => Some(input),
        };
        inputs.into_iter().filter_map(one).collect()
    }

    fn extra(&self, d: &Drafted, known: &[study::BlockKind]) -> Option<(Extra, Block)> {
        let kinds = &known.iter().find(|k| k.info.word == d.word)?.info.kinds;
        let mut block = completed(d, kinds, self.side);
        if block.kind.is_empty() {
            let kind = if self.side == Side::Low { kinds.first() } else { kinds.last() }?;
            (block.kind, block.values) = (kind.kind, invented(&kind.fields, self.side));
        }
        Some((extra(d.word, &block), block))
    }

    fn studies(&mut self, system: &System) {
        let registry = study::registry();
        let infos: Vec<KindInfo> = registry.iter().map(|k| k.info.clone()).collect();
        for d in &self.draft.studies {
            stages::study(&registry, &completed(d, &infos, self.side), system, &mut self.out);
        }
    }
}

fn completed(d: &Drafted, kinds: &[KindInfo], side: Side) -> Block {
    match kinds.iter().find(|k| k.kind == d.block.kind) {
        Some(kind) => d.completed(&kind.fields, side),
        None => d.block.clone(),
    }
}

fn admissible(slots: &[ParamSlot], params: &[f64]) -> bool {
    slots.len() == params.len() && slots.iter().zip(params).all(|(s, x)| s.bounds.contains(*x))
}

/// A block with the ground in place of points that are none, when it names such.
fn grounded(block: &Block, bodies: &BTreeSet<String>) -> Option<Block> {
    let wrong = |a: &Attach| a.body.as_ref().is_some_and(|name| !bodies.contains(name));
    let mut out = None;
    for name in block.values.names() {
        let ground = match block.values.get(name) {
            Some(Value::Attach(a)) if wrong(a) => Value::Attach(Attach::ground()),
            Some(Value::Between(a, b)) if wrong(a) || wrong(b) => Value::Between(Attach::ground(), Attach { body: None, position: 1.0 }),
            _ => continue,
        };
        out.get_or_insert_with(|| block.clone()).values.set(name, ground, Some(NOWHERE));
    }
    out
}

/// A part of a kind, of which everything stands in.
fn invented_part(registry: &[PartKind], kind: &str, side: Side) -> Option<Built> {
    let k = registry.iter().find(|k| k.info.kind == kind)?;
    let mut own = Diagnostics::default();
    let (part, params) = (k.build)(&invented(&k.info.fields, side), &mut own)?;
    let fine = !own.has_errors() && admissible(&part.slots(), &params);
    fine.then_some((part, params))
}

/// A body of which everything is given, so that it has every coordinate a body can have.
fn stranger(registry: &[PartKind], side: Side) -> Option<Built> {
    registry.iter().find_map(|k| invented_part(registry, k.info.kind, side).filter(|p| p.0.layout().body))
}
