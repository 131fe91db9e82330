//! Blocks of a file beside parts and studies.

use super::centrifuge::cups;
use super::shared::{limits, operation, presentation};
use crate::diagnostic::Diagnostics;
use crate::model::field::{BlockInfo, Extra, Field, KindInfo};
use crate::model::part::Part;
use crate::model::system::{Machine, PartInput, System};
use crate::separation::carried::Cups;

/// A block of the file that studies read beside the parts, and what is wrong with one.
pub struct BlockKind {
    /// Word, kinds, fields.
    pub info: BlockInfo,
    /// Says what is wrong with a block of this machine.
    pub check: fn(&Extra, &System, &mut Diagnostics),
    /// The part of the machine that a sound block is.
    pub part: fn(&Extra, &System) -> Option<PartInput>,
    /// Points of bodies that it names, whose displacement counts: body and height above its reference point, m.
    pub points: fn(&Extra, &System) -> Vec<(String, f64)>,
}

/// All blocks beside parts and studies.
pub fn blocks() -> Vec<BlockKind> {
    let one = |word, doc, example, fields: &[Field]| BlockInfo {
        word,
        several: false,
        kinds: vec![KindInfo { kind: word, doc, example, fields: fields.to_vec(), lists: Vec::new() }],
    };
    let cups = BlockInfo { word: "cup", several: true, kinds: cups::cup_kinds() };
    let none = |_: &Extra, _: &System| None;
    let nowhere = |_: &Extra, _: &System| Vec::new();
    vec![
        BlockKind { info: cups, check: cups::check_cup, part: cups::cup_part, points: nowhere },
        BlockKind {
            info: one("suspension", cups::SUSPENSION_DOC, cups::SUSPENSION_EXAMPLE, cups::SUSPENSION),
            check: cups::check_suspension,
            part: none,
            points: nowhere,
        },
        BlockKind {
            info: one("limits", limits::DOC, limits::EXAMPLE, limits::FIELDS),
            check: limits::check,
            part: none,
            points: limits::points,
        },
        BlockKind {
            info: one("operation", operation::DOC, operation::EXAMPLE, operation::FIELDS),
            check: operation::check,
            part: none,
            points: nowhere,
        },
        BlockKind {
            info: one("report", presentation::DOC, presentation::EXAMPLE, presentation::FIELDS),
            check: presentation::check,
            part: none,
            points: nowhere,
        },
    ]
}

/// The machine with the parts that its blocks are and the points that they name, in place of what they were before.
///
/// # Errors
/// As [`System::assemble`].
pub fn with_blocks(system: System) -> Result<System, Diagnostics> {
    let (known, extras) = (blocks(), &system.machine.extras);
    let kind = |e: &Extra| known.iter().find(|k| k.info.word == e.word);
    let parts: Vec<PartInput> = extras.iter().filter_map(|e| (kind(e)?.part)(e, &system)).collect();
    let mut points: Vec<(String, f64)> = extras.iter().filter_map(|e| Some((kind(e)?.points)(e, &system))).flatten().collect();
    points.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    points.dedup();
    let mut inputs = system.inputs();
    let before = inputs.len();
    // a part of the file may have the name of a block
    inputs.retain(|i| i.part.kind() != <Cups as Part>::KIND);
    if parts.is_empty() && inputs.len() == before && points == system.machine.points {
        return Ok(system);
    }
    inputs.extend(parts);
    System::assemble(Machine { points, ..system.machine }, inputs)
}
