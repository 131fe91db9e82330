//! Names that no block bears: each is one mistake, however many places use it.

use super::draft::{Draft, Drafted};
use crate::diagnostic::{Diagnostic, Diagnostics, nearest};

/// One diagnostic for every block that does not exist, at the first part attached to it (or else the first place that names it), with the other
/// places beside it. Where a block lost its name, because it cannot be one or another block has it, a name that resembles no other is taken for
/// the one that was meant, and nothing is said of it. `is_body` tells kinds that parts can be attached to.
pub(super) fn gather(draft: &Draft, found: Diagnostics, is_body: impl Fn(&str) -> bool) -> Diagnostics {
    let blocks = || draft.parts.iter().chain(&draft.extras);
    let borne = |name: &str| blocks().any(|d| d.block.name == name) || draft.strange.iter().any(|s| s == name);
    let earlier = |i: usize, d: &Drafted| draft.parts[..i].iter().any(|o| o.block.name == d.block.name);
    let lost: Vec<&Drafted> = draft.parts.iter().enumerate().filter(|(i, d)| d.misnamed || earlier(*i, d)).map(|(_, d)| d).collect();
    let meant = |d: &Diagnostic, name: &str| {
        let fitting = lost.iter().any(|l| d.code != MISSING || is_body(l.block.kind));
        fitting && nearest(name, blocks().filter(|d| !d.misnamed).map(|d| d.block.name.as_str())).is_none()
    };
    let (mut out, mut absent) = (Diagnostics::default(), Vec::new());
    for d in found.0 {
        match d.about.as_ref().map(|a| a.block().to_string()).filter(|name| !borne(name)) {
            None => out.push(d),
            Some(name) if meant(&d, &name) => {}
            Some(name) => absent.push((name, d)),
        }
    }
    // joints before what else names the block, in order of their places
    absent.sort_by_key(|(_, d)| (d.code != MISSING, d.span.as_ref().map(|s| s.start)));
    let mut names: Vec<String> = Vec::new();
    for (name, d) in absent {
        if let Some(k) = names.iter().position(|n| *n == name) {
            let first = out.0.len() - names.len() + k;
            let place = d.span.filter(|s| out.0[first].span.as_ref() != Some(s));
            if let Some(about) = &mut out.0[first].about {
                about.also.extend(place.filter(|s| !about.also.contains(s)));
            }
        } else {
            names.push(name);
            out.push(d);
        }
    }
    for about in out.0.iter_mut().filter_map(|d| d.about.as_mut()) {
        about.also.sort_by_key(|s| s.start);
    }
    out
}

/// The code of a joint to a body that does not exist.
const MISSING: &str = "body.missing";
