//! The points that parts are attached to.

use super::Block;
use crate::diagnostic::{Diagnostic, Diagnostics, meant, nearest};
use crate::model::assemble::outside;
use crate::model::field::{Attach, Value};
use crate::model::system::PartInput;
use crate::text;

/// Every point exists, lies on a body, and has the position. Of parts that are `None` in `built` nothing is known; `strange` are further names
/// of which that is so.
pub(super) fn check(parts: &[Block], built: &[Option<PartInput>], strange: &[String], diagnostics: &mut Diagnostics) {
    let is_body = |i: usize| built[i].as_ref().is_none_or(|p| p.part.layout().body);
    let shown = |i: usize| built[i].as_ref().map_or(parts[i].kind.is_empty(), |p| p.part.layout().body);
    let bodies: Vec<&str> = (0..built.len()).filter(|&i| shown(i)).map(|i| parts[i].name.as_str()).collect();
    let one = |block: &Block, field: &str, attach: &Attach, ground: bool, out: &mut Diagnostics| {
        let Some(name) = attach.body.as_ref().filter(|n| !strange.contains(n)) else { return };
        let known = || {
            let mut all: Vec<String> = bodies.iter().map(|b| format!("\"{b}\"")).collect();
            all.extend(ground.then(|| "\"ground\"".to_string()));
            if all.is_empty() {
                text!("this machine has no body: add a part such as a disc")
            } else {
                text!("bodies of this machine: {all}", all = all.join(", "))
            }
        };
        let span = block.values.span_of(field);
        let Some(i) = parts.iter().position(|p| &p.name == name) else {
            let near = nearest(name, bodies.iter().copied().chain(ground.then_some("ground")));
            let help = near.map_or_else(known, |n| meant(text::quoted(&n), known()));
            let message =
                text!("{kind} \"{block}\" is attached to \"{name}\", which does not exist", kind = block.kind, block = block.name, name);
            out.push(Diagnostic::error("body.missing", message).at(span).label(text!("no such body")).about(name).help(help));
            return;
        };
        if !is_body(i) {
            let message = text!(
                "{kind} \"{block}\" is attached to \"{name}\", which is a {other} and not a body",
                kind = block.kind,
                block = block.name,
                name,
                other = parts[i].kind
            );
            out.push(Diagnostic::error("body.kind", message).at(span).label(text!("not a body")).help(known()));
            return;
        }
        let Some(body) = &built[i] else { return };
        let ends = body.part.body().and_then(|b| b.nodes()).and_then(|n| Some([*n.first()?, *n.last()?]));
        if let Some(beyond) = ends.and_then(|ends| outside(attach.position, ends)) {
            let message =
                text!("{kind} \"{block}\" is attached to \"{name}\": {beyond}", kind = block.kind, block = block.name, name, beyond);
            out.push(Diagnostic::error("body.position", message).at(span).label(text!("not on the body")));
            return;
        }
        let shape = |position: f64| body.part.body().map(|b| b.shape(&body.params, position));
        if attach.position != 0.0 && shape(attach.position) == shape(0.0) {
            let message = text!("the position on \"{name}\" has no effect: that {kind} does not tilt", name, kind = parts[i].kind);
            out.push(
                Diagnostic::warning("body.position", message)
                    .at(span)
                    .label(text!("no effect"))
                    .help(text!("give a disc its diametral_inertia to let it tilt")),
            );
        }
    };
    for block in parts {
        for field in block.values.names() {
            match block.values.get(field) {
                Some(Value::Attach(a)) => one(block, field, a, false, diagnostics),
                Some(Value::Between(a, b)) => {
                    one(block, field, a, true, diagnostics);
                    one(block, field, b, true, diagnostics);
                }
                _ => {}
            }
        }
    }
}
