//! Balance quality (ISO 21940-11), vibration of the shaft in its bearings (ISO 7919-3, API 617) and of what these stand on (ISO 20816-3).

use super::super::operating::Operating;
use super::super::{Facts, Known};
use super::MOST_NAMED;
use crate::model::system::System;
use crate::outcome::{Arg, Check, Message, Verdict};
use crate::solve::statics::supports::supports;
use crate::solve::statics::unbalance::{Rotor, rotors};
use crate::study::shared::journals::{Journal, JournalVibration, housings, journals, vibrations};
use crate::study::shared::standards::{VibrationStandard, Zone, allocated, grade_word, permissible, rms_velocity};
use crate::study::shared::support::probe_name;
use crate::study::shared::supporting;
use laval_num::order::SortByNumber;

/// Unbalance of every rotor, and of its bearing planes, against the grade of `[operation]`.
pub(super) fn balance(facts: &Facts, speed: Operating) -> Vec<Check> {
    let Some(grade) = facts.operation.balance_grade else { return Vec::new() };
    let at = facts.sign * speed.high;
    let found = match supporting::state(facts.system, at) {
        Ok(state) => supports(facts.system, &state),
        Err(_) => Vec::new(),
    };
    rotors(facts.system, at, &found).iter().map(|r| one(facts, r, grade)).collect()
}

fn one(facts: &Facts, rotor: &Rotor, grade: f64) -> Check {
    let name = |slot: usize| Arg::name(&facts.system.slots()[slot].name);
    let total = permissible(grade, rotor.mass.mass, rotor.speed);
    let size = |x: f64| Arg::quantity(x, "kg m");
    // each plane with its share; without two planes the resultant
    let planes: Vec<(usize, f64, f64)> = match &rotor.planes {
        Some(planes) => {
            let shares = allocated(total, rotor.mass.centre, [planes[0].position, planes[1].position]);
            planes.iter().zip(shares).map(|(p, share)| (p.slot, p.unbalance.abs(), share)).collect()
        }
        None => vec![(rotor.mass.body, rotor.resultant.abs(), total)],
    };
    let items = planes.iter().map(|&(slot, x, share)| {
        Arg::from(Message::new("item-balance").arg("name", name(slot)).arg("value", size(x)).arg("share", size(share)))
    });
    let kept = planes.iter().all(|p| p.1 <= p.2);
    let result = Message::new("balance-planes").arg("rotor", name(rotor.mass.body)).arg("sizes", Arg::List(items.collect()));
    let detail = Message::new("balance-detail")
        .arg("planes", Arg::word(if rotor.planes.is_some() { "two" } else { "one" }))
        .arg("resultant", size(rotor.resultant.abs()))
        .arg("tilts", Arg::word(if rotor.couple.abs().is_finite() { "yes" } else { "no" }))
        .arg("couple", Arg::quantity(if rotor.couple.abs().is_finite() { rotor.couple.abs() } else { 0.0 }, "kg m^2"));
    let required = Message::new("required-balance").arg("grade", Arg::term(grade_word(grade))).arg("limit", size(total));
    let verdict = if kept { Verdict::Passed } else { Verdict::Failed };
    Check { detail: Some(detail), required: Some(required.into()), ..Check::new("check-balance", result, verdict) }
}

/// Vibration of the journals and of what their bearings stand on, over the operating speeds, against the standards of `[operation]`.
pub(super) fn vibration(facts: &Facts, speed: Operating) -> impl Iterator<Item = Check> {
    assessed(facts).map(move |(what, standard)| one_standard(facts, speed, what, standard))
}

/// The same where no response is assessed, for this reason.
pub(super) fn vibration_without(facts: &Facts, why: &str) -> impl Iterator<Item = Check> {
    assessed(facts).map(move |(what, _)| Check::new(what, Message::new(why), Verdict::NotComputed))
}

fn assessed(facts: &Facts) -> impl Iterator<Item = (&'static str, VibrationStandard)> {
    let o = &facts.operation;
    let all = [("check-shaft-vibration", o.shaft_vibration), ("check-housing-vibration", o.housing_vibration)];
    all.into_iter().filter_map(|(what, standard)| Some((what, standard?)))
}

/// Speed of the shaft of a journal over that of the machine.
fn ratio(system: &System, journal: &Journal) -> f64 {
    let turning = journal.relative.0.iter().flatten().map(|(i, _)| &system.slots()[system.coordinates()[*i].slot]);
    let mut turning = turning.filter(|s| s.part.body().is_some_and(|b| b.turns()));
    turning.next().map_or(1.0, |s| s.speed(system.params(), 1.0).abs())
}

fn one_standard(facts: &Facts, speed: Operating, what: &str, standard: VibrationStandard) -> Check {
    let refused = |why: Message| Check::new(what, why, Verdict::NotComputed);
    let of_housings = standard.is_of_housings();
    let at = facts.sign * speed.high;
    let all = match if of_housings { housings(facts.system, at) } else { journals(facts.system, at) } {
        Ok(all) if !all.is_empty() => all,
        Ok(_) => return refused(Message::new(if of_housings { "housing-vibration-none" } else { "shaft-vibration-no-bearing" })),
        Err(d) => return refused(Message::new("why-refused").arg("reason", d.message)),
    };
    // what a nonlinear study found counts before the linear response
    let steady = facts.steady.as_ref().filter(|s| !s.sizes.is_empty());
    let mut found: Vec<JournalVibration> = match (steady, &facts.response) {
        (Some(s), _) => {
            let probes = facts.system.probes();
            let known = |name: &str| s.sizes.iter().find(|x| x.0 == name).map(|x| x.1);
            let one = |j: &Journal| {
                let peak_to_peak = 2.0 * known(&probe_name(&probes[j.probe?]))?;
                Some(JournalVibration { slot: j.slot, speed: at, peak_to_peak })
            };
            all.iter().filter_map(one).collect()
        }
        (None, Some(known)) => match known.get() {
            Some(r) => vibrations(&all, &r.curve, standard, (speed.low, speed.high)),
            None => return refused(known.why()),
        },
        (None, None) => return refused(Message::new("why-no-speed")),
    };
    if found.is_empty() {
        return refused(Message::new("shaft-vibration-unknown"));
    }
    // the unbalance of other spins adds to it, and every shaft is assessed at its own speed
    let spins = &facts.spins;
    for (_, r, range) in &spins.known {
        for more in vibrations(&all, &r.curve, standard, *range) {
            found.iter_mut().filter(|v| v.slot == more.slot).for_each(|v| v.peak_to_peak += more.peak_to_peak);
        }
    }
    for v in &mut found {
        v.speed *= all.iter().find(|j| j.slot == v.slot).map_or(1.0, |j| ratio(facts.system, j));
    }
    let used = |v: &JournalVibration| v.peak_to_peak / standard.limit(v.speed);
    found.sort_by_number_down(used);
    let worst = found[0];
    let covers = |w: f64| found.iter().all(|v| standard.covers(w * v.speed.abs() / speed.high));
    if !covers(speed.low) || !covers(speed.high) {
        return refused(Message::new("shaft-vibration-speed"));
    }
    let name = |slot: usize| Arg::name(&facts.system.slots()[slot].name);
    let zone = |v: &JournalVibration| standard.zone(v.speed, v.peak_to_peak);
    // housings are assessed by their velocity
    let size = |speed: f64, peak_to_peak: f64| match of_housings {
        true => Arg::quantity(rms_velocity(speed, peak_to_peak), "m/s"),
        false => Arg::quantity(peak_to_peak, "m"),
    };
    let item = |v: &JournalVibration| {
        let key = if of_housings { "item-housing-vibration" } else { "item-shaft-vibration" };
        let m = Message::new(key).arg("name", name(v.slot)).arg("value", size(v.speed, v.peak_to_peak));
        Arg::from(m.arg("zone", Arg::word(if standard.has_zones() { zone(v).word() } else { "none" })))
    };
    let sizes = Arg::List(found.iter().take(MOST_NAMED).map(item).collect());
    let verdict = match found.iter().map(zone).max() {
        Some(Zone::A | Zone::B) => Verdict::Passed,
        Some(Zone::C) => Verdict::Attention,
        _ => Verdict::Failed,
    };
    // the linear response passes through a part that would hold it
    let closes = steady.is_none() && facts.response.as_ref().and_then(Known::get).is_some_and(|r| !r.observed.closed.is_empty());
    let verdict = if closes && verdict == Verdict::Passed { Verdict::Attention } else { verdict };
    let verdict = spins.kept(verdict);
    let detail = Message::new(if of_housings { "housing-vibration-detail" } else { "shaft-vibration-detail" })
        .arg("standard", Arg::word(standard.word()))
        .arg("speed", Arg::speed(worst.speed))
        .arg("nonlinear", Arg::word(if steady.is_some() { "yes" } else { "no" }));
    let required = Some(Arg::from(Message::new("required-below").arg("limit", size(worst.speed, standard.limit(worst.speed)))));
    let detail = spins.remark().unwrap_or(detail);
    Check { detail: Some(detail), required, ..Check::new(what, Message::new("shaft-vibration-sizes").arg("sizes", sizes), verdict) }
}
