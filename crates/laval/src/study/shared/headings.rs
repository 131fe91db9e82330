//! Headings of columns that hold the name of a body or part: "largest tilt of drum" for `drum largest tilt`, `tilt.drum` and `drum.largest_tilt`. A language may
//! translate what it is, and leaves the name.

use super::probes;
use crate::model::system::System;
use crate::outcome::{Arg, Outcome};

/// Bodies, points of bodies and parts, as columns name them.
fn owners(system: &System) -> Vec<(String, Arg)> {
    let probes = system.probes().iter().map(|p| (probes::owner(p), probes::label(p)));
    let mut all: Vec<(String, Arg)> = probes.chain(system.slots().iter().map(|s| (s.name.clone(), Arg::name(&s.name)))).collect();
    // "drum at 100 mm" before "drum"
    all.sort_by_key(|o| std::cmp::Reverse(o.0.len()));
    all
}

/// What a column holds, apart from its owner.
fn apart<'c>(column: &'c str, owner: &str) -> Option<&'c str> {
    let behind = column.strip_prefix(owner).and_then(|rest| rest.strip_prefix([' ', '.']));
    behind.or_else(|| {
        let before = column.strip_suffix(owner)?;
        before.strip_suffix('.').or_else(|| before.strip_suffix(" of "))
    })
}

/// Gives such columns their headings.
pub fn name_owners(system: &System, outcome: &mut Outcome) {
    let owners = owners(system);
    let heading = |column: &str| {
        let found = owners.iter().find_map(|(name, label)| Some((apart(column, name)?, label)));
        found.map(|(what, owner)| Arg::of(Arg::term(what.replace(['_', '.'], " ")), owner.clone()))
    };
    outcome.tables.iter_mut().for_each(|t| t.head(heading));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_is_parted_from_its_owner() {
        for (column, what) in [
            ("drum largest tilt", "largest tilt"),
            ("tilt.drum", "tilt"),
            ("tilt of drum", "tilt"),
            ("drum.x", "x"),
            ("drum", ""),
            ("drums x", ""),
        ] {
            assert_eq!(apart(column, "drum").unwrap_or_default(), what);
        }
    }
}
