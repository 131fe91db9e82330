//! What is done with every block by itself, whether the others are sound or not. Diagnostics say whose they are and where.

use super::{Block, names};
use crate::diagnostic::Diagnostics;
use crate::model::field::Extra;
use crate::model::system::{PartInput, System};
use crate::parts::PartKind;
use crate::study::{BlockKind, ErasedStudy, StudyKind};
use crate::text;

/// A part by itself; `None` where it could not be built. The flag says that nothing is wrong with it.
pub(super) fn part(registry: &[PartKind], block: &Block, diagnostics: &mut Diagnostics) -> (Option<PartInput>, bool) {
    let Some(kind) = registry.iter().find(|k| k.info.kind == block.kind) else { return (None, false) };
    let mut own = Diagnostics::default();
    let built = (kind.build)(&block.values, &mut own);
    let fine = built.is_some() && !own.has_errors();
    put(own, block, diagnostics);
    (built.map(|(part, params)| PartInput { name: block.name.clone(), part, params, span: block.span.clone() }), fine)
}

/// A block beside parts and studies; whether nothing is wrong with it.
pub(super) fn extra(known: &[BlockKind], extra: &Extra, block: &Block, system: &System, diagnostics: &mut Diagnostics) -> bool {
    let mut own = Diagnostics::default();
    if let Some(kind) = known.iter().find(|k| k.info.word == extra.word) {
        (kind.check)(extra, system, &mut own);
    }
    let fine = !own.has_errors();
    put(own, block, diagnostics);
    fine
}

/// A study of this machine; `None` where it could not be built.
pub(super) fn study(registry: &[StudyKind], block: &Block, system: &System, diagnostics: &mut Diagnostics) -> Option<Box<dyn ErasedStudy>> {
    let kind = registry.iter().find(|k| k.info.kind == block.kind)?;
    let (mut own, mut built) = (Diagnostics::default(), Diagnostics::default());
    names::check(kind.info.fields.as_slice(), &block.values, registry, system, &mut own);
    let study = (kind.build)(&block.values, system, &mut built);
    // a name that does not exist is said once
    built.0.retain(|d| !own.0.iter().any(|o| o.span.is_some() && o.span == d.span));
    own.0.append(&mut built.0);
    let fine = !own.has_errors();
    put(own, block, diagnostics);
    study.filter(|_| fine)
}

/// A diagnostic of a block says whose it is; without a place of its own it stands at the block.
pub(super) fn put(mut own: Diagnostics, block: &Block, diagnostics: &mut Diagnostics) {
    for d in &mut own.0 {
        if d.span.is_none() {
            d.span.clone_from(&block.span);
        }
        if !d.message.starts_with(block.kind) {
            let whose = if block.name == block.kind { block.kind.to_string() } else { format!("{} {:?}", block.kind, block.name) };
            d.message = text!("{whose}: {message}", whose, message = d.message);
        }
    }
    diagnostics.0.append(&mut own.0);
}
