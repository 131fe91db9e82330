//! All mistakes of a file that has some: every stage runs over what is there.
//!
//! A block that could not be read exists all the same: values stand in for those that are missing, and where there is nothing to go on a
//! body that has every coordinate stands in for the whole block. The file is examined twice, with different values: what both find is
//! wrong whatever was meant. What names coordinates or parameters of such a block says nothing.

use super::assemble::{extra, machine};
use super::draft::{Draft, Drafted, invented};
use super::stand_in::{NOWHERE, Side, number};
use super::{Block, joints, stages};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::model::field::{Bounds, Extra, KindInfo};
use crate::model::part::Link;
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
    found
}

/// The file with one choice of what stands in.
struct World<'a> {
    draft: &'a Draft,
    side: Side,
    /// Blocks whose coordinates and parameters are not known.
    doubtful: BTreeSet<&'a str>,
    out: Diagnostics,
}

impl<'a> World<'a> {
    fn new(draft: &'a Draft, side: Side) -> Self {
        let blocks = draft.parts.iter().chain(&draft.extras);
        let doubtful = blocks.filter(|d| !d.sound).map(|d| d.block.name.as_str()).chain(draft.strange.iter().map(String::as_str)).collect();
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
        match System::assemble(machine(&block, extras.iter().map(|e| e.0.clone()).collect()), inputs) {
            Ok(system) => {
                for (extra, block) in &extras {
                    let drafted = self.draft.extras.iter().find(|d| d.word == extra.word && d.block.name == extra.name);
                    if !stages::extra(&known, extra, block, &system, &mut self.out)
                        && let Some(d) = drafted
                    {
                        self.doubtful.insert(&d.block.name);
                    }
                }
                self.studies(&system);
            }
            Err(found) if !self.draft.parts.is_empty() => self.out.0.extend(found.0),
            Err(_) => {}
        }
        let nothing = self.draft.parts.is_empty();
        let doubtful = |name: &str| nothing || self.doubtful.contains(name.split('.').next().unwrap_or_default());
        self.out.0.retain(|d| d.severity == Severity::Error && !d.about.as_deref().is_some_and(doubtful));
        self.out
    }

    /// Every part under its name, or what stands in for it.
    fn parts(&mut self) -> Vec<PartInput> {
        let registry = parts::registry();
        let draft = self.draft;
        let infos: Vec<KindInfo> = registry.iter().map(|k| k.info.clone()).collect();
        let blocks: Vec<Block> = draft.parts.iter().map(|d| completed(d, &infos, self.side)).collect();
        let (built, fine): (Vec<Option<PartInput>>, Vec<bool>) =
            blocks.iter().map(|b| stages::part(&registry, b, &mut self.out)).map(|(input, fine)| (input.filter(admissible), fine)).unzip();
        joints::check(&blocks, &built, &draft.strange, &mut self.out);

        let is_body = |name: &str| {
            let known = blocks.iter().zip(&built).zip(&fine).filter(|((b, _), _)| b.name == name);
            let mut bodies = known.map(|((_, p), fine)| !fine || p.as_ref().is_none_or(|p| p.part.layout().body));
            draft.strange.iter().any(|s| s == name) || bodies.any(|b| b)
        };
        let joined = |p: &PartInput| {
            p.part.layout().ports.iter().all(|port| {
                let on: &[_] = match &port.link {
                    Link::On(a) => &[a],
                    Link::Between(a, b) => &[a, b],
                };
                on.iter().all(|a| a.body.as_deref().is_none_or(is_body))
            })
        };
        let stranger = stranger(&registry, self.side);
        let stand_in = |name: &str| {
            let (part, params) = stranger.clone()?;
            Some(PartInput { name: name.to_string(), part, params, span: None })
        };
        let mut inputs: Vec<PartInput> = Vec::new();
        for ((d, input), fine) in draft.parts.iter().zip(&built).zip(&fine) {
            let name = d.block.name.as_str();
            if inputs.iter().any(|i| i.name == name) {
                continue;
            }
            let sound = input.clone().filter(|p| *fine && joined(p));
            if sound.is_none() {
                self.doubtful.insert(name);
            }
            inputs.extend(sound.or_else(|| stand_in(name)));
        }
        for name in &draft.strange {
            if !inputs.iter().any(|i| &i.name == name) {
                inputs.extend(stand_in(name));
            }
        }
        // a file without parts says so; its studies have fields of their own
        if draft.parts.is_empty() {
            inputs.extend(stand_in("part"));
        }
        inputs
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

fn admissible(p: &PartInput) -> bool {
    let slots = p.part.slots();
    slots.len() == p.params.len() && slots.iter().zip(&p.params).all(|(s, x)| s.bounds.contains(*x))
}

/// A body of which everything is given, so that it has every coordinate a body can have.
fn stranger(registry: &[PartKind], side: Side) -> Option<Built> {
    registry.iter().find_map(|k| {
        let mut own = Diagnostics::default();
        let built = (k.build)(&invented(&k.info.fields, side), &mut own)?;
        (!own.has_errors() && built.0.layout().body).then_some(built)
    })
}
