//! Vibration, forces and validity at the operating speeds.

use super::super::studied::{self, Needed};
use super::super::{Facts, Known};
use super::{MOST_NAMED, against};
use crate::model::part::{At, Link};
use crate::model::probe::{Probe, Sight};
use crate::model::system::{Slot, System, Workspace};
use crate::outcome::{Arg, Check, Finding, Level, Message, Verdict};
use crate::solve::extrema::Curve;
use crate::solve::rest::rest;
use crate::study::linear::forced_response::{LINEARISED, Shows};
use crate::study::shared::limits::Limit;
use crate::study::shared::probes::{self, farthest};
use crate::study::shared::support::{larger, largest, probe_name};
use laval_num::complex::C64;
use laval_num::order::SortByNumber;
use std::f64::consts::TAU;

/// Share of a force from which on its part at rest is given beside it.
const STATIC: f64 = 0.01;

/// The response at the operating speeds.
fn response<'f>(facts: &'f Facts) -> Result<&'f Curve, Message> {
    let Some(known) = &facts.response else { return Err(Message::new("why-no-speed")) };
    let Some(result) = known.get() else { return Err(known.why()) };
    let curve = &result.curve;
    let bounded = curve.points.iter().all(|r| r.x.iter().all(|x| x.is_finite())) && curve.extrema.iter().all(|e| !e.unbounded);
    if bounded && !curve.points.is_empty() && curve.singular.is_empty() { Ok(curve) } else { Err(Message::new("vibration-unbounded")) }
}

/// Largest displacement of a point over the operating speeds, m, and largest velocity, m/s.
fn sizes(curve: &Curve, probes: &[Probe], probe: &Probe) -> (f64, f64) {
    let points = curve.points.iter().map(|r| (r.speed.abs(), r.size(probe)));
    let peaks = curve.extrema.iter().filter(|e| e.maximum && probes[e.probe] == *probe).map(|e| (e.speed.abs(), e.value));
    let all: Vec<(f64, f64)> = points.chain(peaks).collect();
    (largest(all.iter().map(|a| a.1)), largest(all.iter().map(|a| a.0 * a.1)))
}

/// Displacements of the bodies on the steady response at the highest operating speed, m; none where there is no such response.
pub(super) fn steady(facts: &Facts) -> Vec<(String, f64)> {
    if let Some(s) = facts.steady.as_ref().filter(|s| !s.sizes.is_empty()) {
        return s.sizes.clone();
    }
    let Ok(curve) = response(facts) else { return Vec::new() };
    // the linear response passes through a gap that would close
    if facts.response.as_ref().and_then(Known::get).is_some_and(|r| !r.observed.closed.is_empty()) {
        return Vec::new();
    }
    let Some(last) = curve.points.iter().max_by(|a, b| a.speed.abs().total_cmp(&b.speed.abs())) else { return Vec::new() };
    farthest(facts.system, |p| last.size(p)).into_iter().map(|(p, x)| (p.name.clone(), x)).collect()
}

/// Displacements of bodies against their limits.
pub(super) fn vibration(facts: &Facts) -> Vec<Check> {
    // what a nonlinear study found counts before the linear response
    let nonlinear = facts.steady.as_ref().filter(|s| !s.sizes.is_empty());
    let curve = match response(facts) {
        Ok(curve) => Some(curve),
        Err(why) if nonlinear.is_none() || why.key == "vibration-unbounded" => {
            let verdict = if why.key == "vibration-unbounded" { Verdict::Failed } else { Verdict::NotComputed };
            return vec![Check::new("check-vibration", why, verdict)];
        }
        Err(_) => None,
    };
    let all = facts.system.probes();
    let known = |p: &Probe| nonlinear.and_then(|s| s.sizes.iter().find(|x| !p.is_tilt() && x.0 == probe_name(p))).map(|x| x.1);
    let fastest = facts.operating.map_or(0.0, |o| o.high);
    let spins = &facts.spins;
    // at different frequencies the largest values meet at times
    let linear = |p: &Probe| {
        let own = curve.map_or((f64::NAN, f64::NAN), |c| sizes(c, all, p));
        spins.known.iter().map(|k| sizes(&k.1.curve, all, p)).fold(own, |a, b| (a.0 + b.0, a.1 + b.1))
    };
    let size = |p: &Probe| known(p).unwrap_or_else(|| linear(p).0);
    let velocity = |p: &Probe| known(p).map_or_else(|| linear(p).1, |x| x * fastest);
    // a shaft may move most where nothing is attached; a nonlinear study has its points alone
    let between = if nonlinear.is_some() { Vec::new() } else { nodes_between(facts.system) };
    let mut named: Vec<(&Probe, f64)> = farthest(facts.system, size);
    for p in &between {
        let (own, x) = (|a: &(&Probe, f64)| a.0.name == p.name, size(p));
        if named.iter().filter(|a| own(a)).all(|a| x > FARTHER * a.1) {
            named.retain(|a| !own(a) || all.contains(a.0));
            named.push((p, x));
        }
    }
    // what moves by loads alone that are left out is not known
    if !spins.left_out.is_empty() && named.iter().any(|a| a.1 != 0.0) {
        named.retain(|a| a.1 != 0.0);
    }
    named.sort_by_number_down(|a| a.1);
    named.truncate(MOST_NAMED);
    let item = |(p, x): &(&Probe, f64)| Arg::from(Message::new("item").arg("name", probes::named(p)).arg("value", Arg::quantity(*x, "m")));
    let result = Message::new("vibration-sizes").arg("sizes", Arg::List(named.iter().map(item).collect()));
    let detail = named
        .first()
        .map(|(p, _)| Message::new("vibration-velocity").arg("name", probes::named(p)).arg("peak", Arg::quantity(velocity(p), "m/s")));
    // the limit of a body holds at its reference point, wherever something is attached and along a shaft
    let held = |l: &Limit, p: &Probe| !p.is_tilt() && if l.at.is_some() { l.is_at(p) } else { p.name == l.body };
    let kept = |limits: &[Limit], size: &dyn Fn(&Probe) -> f64| {
        let one = |l: &Limit| Some((l.name.clone(), all.iter().chain(&between).filter(|p| held(l, p)).map(size).reduce(larger)?, l.value));
        used(limits.iter().filter_map(one).collect())
    };
    let limited = kept(&facts.limits.displacement, &size);
    let (required, verdict) = against(limited.first().map(|w| ((w.2, w.1), "m")));
    // what moves most may have no limit
    let free = named.first().is_some_and(|(p, _)| !limited.is_empty() && !facts.limits.displacement.iter().any(|l| held(l, p)));
    let (result, required) = match each(&limited, "m", free) {
        Some((sizes, each)) => (Message::new("vibration-sizes").arg("sizes", sizes), Some(each)),
        None => (result, required),
    };
    let closes: Vec<&str> =
        facts.response.as_ref().and_then(Known::get).map_or(Vec::new(), |r| r.observed.closed.iter().map(|c| c.part.as_str()).collect());
    let touching = touching(facts);
    let remark = spins.remark().filter(|_| touching.is_empty());
    let (detail, verdict) = if !touching.is_empty() {
        let rests = Message::new("vibration-touching").arg("parts", Arg::names(touching));
        (Some(rests), if verdict == Verdict::Failed { verdict } else { Verdict::Attention })
    } else if nonlinear.is_some() {
        (Some(Message::new("vibration-nonlinear")), verdict)
    } else if !closes.is_empty() {
        // the linear response passes through a part that would hold it
        (Some(Message::new("vibration-contact").arg("parts", Arg::names(closes.iter().copied()))), Verdict::Attention)
    } else {
        (facts.response.as_ref().and_then(Known::source).or(detail), verdict)
    };
    // also a nonlinear study has the loads of one spin alone
    let verdict = if nonlinear.is_some() && !spins.known.is_empty() && verdict == Verdict::Passed { Verdict::Attention } else { verdict };
    let (detail, verdict) = (remark.or(detail), spins.kept(verdict));
    let mut out = vec![Check { detail, required, ..Check::new("check-vibration", result, verdict) }];
    let limited = kept(&facts.limits.velocity, &velocity);
    if let Some((_, worst, limit)) = limited.first() {
        let (required, verdict) = against(Some(((*limit, *worst), "m/s")));
        let verdict = if closes.is_empty() || nonlinear.is_some() || verdict == Verdict::Failed { verdict } else { Verdict::Attention };
        let (result, required) = match each(&limited, "m/s", false) {
            Some((sizes, each)) => (Message::new("velocity-sizes").arg("sizes", sizes), Some(each)),
            None => (Message::new("velocity-is").arg("value", Arg::quantity(*worst, "m/s")), required),
        };
        out.push(Check { required, ..Check::new("check-velocity", result, spins.kept(verdict)) });
    }
    out
}

/// Parts with a gap that is closed at rest, as of a rotor that lies on a labyrinth. A bearing that holds nothing before its clearance is used up belongs closed.
fn touching<'f>(facts: &'f Facts) -> Vec<&'f str> {
    closed(facts, &[], |undisplaced, at_rest, _| undisplaced > 0.0 && at_rest < 0.0)
}

/// Parts with a gap that is open at rest and that the linear response closes on the way to the operating speeds.
pub(super) fn closed_on_the_way<'f>(facts: &'f Facts) -> Vec<&'f str> {
    let found = facts.criticals.get().and_then(|c| c.response.as_ref()).or_else(|| facts.forced.as_ref().map(|f| &f.curve));
    let (Some(curve), Some(o)) = (found, facts.operating) else { return Vec::new() };
    let below: Vec<&[C64]> = curve.points.iter().filter(|p| facts.sign * p.speed <= o.high).map(|p| p.x.as_slice()).collect();
    closed(facts, &below, |_, at_rest, least| at_rest > 0.0 && least < 0.0)
}

/// Instants of a turn at which a gap is looked at.
const INSTANTS: usize = 16;

/// Parts whose gaps fulfil a condition on their width undisplaced, at rest at the highest operating speed, and at the narrowest of these responses about it.
fn closed<'f>(facts: &'f Facts, responses: &[&[C64]], such: impl Fn(f64, f64, f64) -> bool) -> Vec<&'f str> {
    let (Some(o), system) = (facts.operating, facts.system) else { return Vec::new() };
    let speed = facts.sign * o.high;
    let Ok(rest) = rest(system, speed) else { return Vec::new() };
    let zero = vec![0.0; system.n()];
    let at = At { q: &rest.q, v: &zero, a: &zero, z: &rest.z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let mut scratch = Workspace::default();
    let mut fulfils = |s: &Slot| {
        let contacts = s.part.contacts()?;
        let p = &system.params()[s.params.clone()];
        if contacts.refuses_rest(p).is_some() {
            return None;
        }
        let mut gap = |q: &[f64]| system.with_local(s, &At { q, ..at }, &mut scratch, |l| contacts.clearance(p, l));
        let (undisplaced, at_rest) = (gap(&zero)?, gap(&rest.q)?);
        let mut least = at_rest;
        for x in responses {
            for k in 0..INSTANTS {
                let turn = C64::cis(TAU * k as f64 / INSTANTS as f64);
                let q: Vec<f64> = rest.q.iter().zip(x.iter()).map(|(q, x)| q + (*x * turn).re).collect();
                least = least.min(gap(&q)?);
            }
        }
        Some(such(undisplaced, at_rest, least))
    };
    system.slots().iter().filter(|s| fulfils(s) == Some(true)).map(|s| s.name.as_str()).collect()
}

/// Nodes of bodies that bend, where nothing is attached.
fn nodes_between(system: &System) -> Vec<Probe> {
    let mut out = Vec::new();
    for (k, slot) in system.slots().iter().enumerate() {
        let Some(nodes) = slot.part.body().and_then(|b| b.nodes()) else { continue };
        let attached = |z: f64| system.probes().iter().any(|p| p.name == slot.name && p.is_at(z));
        for z in nodes.into_iter().filter(|z| !attached(*z)) {
            let sight = Sight::Displacement(z);
            let probe = |rows| Probe { station: usize::MAX, name: slot.name.clone(), sight, digits: DIGITS, flexible: true, rows };
            out.extend(system.point(k, z).map(probe));
        }
    }
    out
}

/// Digits of the place of a node.
const DIGITS: usize = 4;
/// How much farther a node moves than all points of a body where something is attached, where it is named.
const FARTHER: f64 = 1.001;

/// Forces of the parts against their limits.
pub(super) fn forces(facts: &Facts) -> Option<Check> {
    let result = facts.response.as_ref().and_then(Known::get);
    let mut all: Vec<(&str, f64)> = Vec::new();
    for q in result.iter().flat_map(|r| &r.observed.quantities).filter(|q| q.unit == "N") {
        let x = largest(q.values.iter().copied());
        match all.iter_mut().find(|a| a.0 == q.part) {
            Some(a) => a.1 = larger(a.1, x),
            None => all.push((&q.part, x)),
        }
    }
    // what a turn of another spin adds to the force at rest
    let (spins, still) = (&facts.spins, at_rest(facts));
    for q in spins.known.iter().flat_map(|k| &k.1.observed.quantities).filter(|q| q.unit == "N") {
        let rest = still.iter().find(|r| r.0 == q.part).map_or(0.0, |r| r.1);
        let more = (largest(q.values.iter().copied()) - rest).max(0.0);
        match all.iter_mut().find(|a| a.0 == q.part) {
            Some(a) => a.1 += more,
            None => all.push((&q.part, rest + more)),
        }
    }
    // a linear response has no force of a nonlinear part
    if let Some(s) = &facts.steady {
        for (part, x) in &s.forces {
            match all.iter_mut().find(|a| a.0 == part) {
                Some(a) => a.1 = *x,
                None => all.push((part, *x)),
            }
        }
    }
    let most = all.iter().map(|a| a.1).fold(0.0, f64::max);
    // what is no number stays, and keeps no limit
    all.retain(|a| !(a.1 <= 1e-9 * most));
    let nonlinear =
        facts.system.slots().iter().filter(|s| !s.is_linear() && s.layout.ports.iter().any(|p| matches!(p.link, Link::Between(..))));
    let missing: Vec<&str> = nonlinear.map(|s| s.name.as_str()).filter(|n| !all.iter().any(|a| a.0 == *n)).collect();
    let doubtful = unlike_their_law(facts);
    if all.is_empty() && missing.is_empty() {
        return None;
    }
    let limit = |part: &str| facts.limits.force.iter().find(|l| l.body == part).map(|l| l.value);
    let limited = used(all.iter().filter_map(|(p, x)| Some((p.to_string(), *x, limit(p)?))).collect());
    let (required, verdict) = against(limited.first().map(|w| ((w.2, w.1), "N")));
    all.sort_by_number_down(|a| a.1);
    all.truncate(MOST_NAMED);
    // the force of a turn holds that at rest, of weight and preload; the displacement of the vibration is counted from rest
    let rest = at_rest(facts);
    let share = |name: &str, x: f64| rest.iter().find(|r| r.0 == name).map(|r| r.1).filter(|r| *r > STATIC * x);
    let item = |(name, x): &(&str, f64)| {
        let still = share(name, *x).map_or(Arg::word("none"), |r| Arg::quantity(r, "N"));
        Arg::from(Message::new("item-force").arg("name", Arg::name(*name)).arg("value", Arg::quantity(*x, "N")).arg("rest", still))
    };
    let loaded = all.iter().any(|(name, x)| share(name, *x).is_some());
    let result = match all.is_empty() {
        true => Message::new("forces-none"),
        false => Message::new("forces-sizes").arg("sizes", Arg::List(all.iter().map(item).collect())),
    };
    let free = all.first().is_some_and(|a| !limited.is_empty() && limit(a.0).is_none());
    let (result, required) = match each(&limited, "N", free) {
        Some((sizes, each)) => (Message::new("forces-sizes").arg("sizes", sizes), Some(each)),
        None => (result, required),
    };
    let limited = missing.iter().chain(&doubtful).any(|n| facts.limits.force.iter().any(|l| l.body == *n));
    let verdict = if limited && verdict != Verdict::Failed { Verdict::Attention } else { verdict };
    let without = (!missing.is_empty()).then(|| Message::new("forces-without").arg("parts", Arg::names(missing)));
    let still = loaded.then(|| Message::new("forces-with-rest"));
    let doubt = (!doubtful.is_empty()).then(|| Message::new("forces-not-linear").arg("parts", Arg::names(doubtful)));
    let both = |a: Message, b: Message| Message::new("both").arg("first", a).arg("second", b);
    let detail = [still, doubt, without].into_iter().flatten().reduce(both);
    Some(Check { detail: spins.remark().or(detail), required, ..Check::new("check-forces", result, spins.kept(verdict)) })
}

/// Difference of the force of a nonlinear part by its law from that by its tangent, over the latter, from which on the tangent does not decide.
const UNLIKE: f64 = 0.1;

/// Nonlinear parts whose forces at the operating speeds are known by their tangent alone, and differ by their law.
fn unlike_their_law<'f>(facts: &'f Facts) -> Vec<&'f str> {
    let Some(r) = facts.response.as_ref().and_then(Known::get) else { return Vec::new() };
    let steady = |part: &str| facts.steady.as_ref().is_some_and(|s| s.forces.iter().any(|f| f.0 == part));
    let tangent = |part: &str| r.observed.quantities.iter().find(|q| q.what == LINEARISED && q.part == part);
    let differs = |law: &&Shows| {
        let pairs = tangent(&law.part).into_iter().flat_map(|t| t.values.iter().zip(&law.values));
        !steady(&law.part) && pairs.into_iter().any(|(t, l)| !((l - t).abs() <= UNLIKE * t.abs()))
    };
    r.observed.laws.iter().filter(differs).map(|l| l.part.as_str()).collect()
}

/// Values with the limits of their own, the one that is used most first.
fn used(mut all: Vec<(String, f64, f64)>) -> Vec<(String, f64, f64)> {
    // what is no number keeps no limit, whatever its sign
    let share = |l: &(String, f64, f64)| if l.1.is_nan() { f64::INFINITY } else { l.1 / l.2 };
    all.sort_by(|a, b| share(b).total_cmp(&share(a)));
    all
}

/// Where limits differ, or are not on the values that would be shown (`free`): each value beside its own, and the requirement.
fn each(limited: &[(String, f64, f64)], unit: &'static str, free: bool) -> Option<(Arg, Arg)> {
    (free || limited.windows(2).any(|w| w[0].2 != w[1].2)).then_some(())?;
    let item = |(name, x, limit): &(String, f64, f64)| {
        let item = Message::new("item-of").arg("name", Arg::name(name)).arg("value", Arg::quantity(*x, unit));
        Arg::from(item.arg("limit", Arg::quantity(*limit, unit)))
    };
    Some((Arg::List(limited.iter().take(MOST_NAMED).map(item).collect()), Message::new("required-each").into()))
}

/// Largest force of each part at rest, N: of weight, preload and other constant loads.
fn at_rest(facts: &Facts) -> Vec<(String, f64)> {
    let Some(o) = facts.operating else { return Vec::new() };
    let (system, speed) = (facts.system, facts.sign * o.high);
    let Ok(rest) = rest(system, speed) else { return Vec::new() };
    let zero = vec![0.0; system.n()];
    let at = At { q: &rest.q, v: &zero, a: &zero, z: &rest.z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
    let mut out: Vec<(String, f64)> = Vec::new();
    for (slot, o) in system.observe(&at, &mut Workspace::default()) {
        let name = &system.slots()[slot].name;
        if o.unit != "N" {
            continue;
        }
        match out.iter_mut().find(|known| known.0 == *name) {
            Some(known) => known.1 = larger(known.1, o.value.abs()),
            None => out.push((name.clone(), o.value.abs())),
        }
    }
    out
}

/// A part and its statement of validity.
fn statement(part: &str, what: &'static str) -> Arg {
    Message::new("validity-statement").arg("part", Arg::name(part)).arg("what", Arg::term(what)).into()
}

/// What a finding outside the validity of its model names: the part with its statement, the part, or what it is about.
fn outside(f: &Finding) -> Arg {
    match (f.message.arg_named("part"), f.message.arg_named("what")) {
        (Some(part), Some(what)) => Message::new("validity-statement").arg("part", part.clone()).arg("what", what.clone()).into(),
        (Some(part), None) => part.clone(),
        _ if f.subject.is_empty() => Arg::name(&f.id),
        _ => Arg::name(&f.subject),
    }
}

/// Validity of the parts at the operating speed, and what the studies of the file found outside.
pub(super) fn validity(facts: &Facts) -> Check {
    let mut outside: Vec<Arg> = Vec::new();
    for f in facts.outcomes.iter().flat_map(|o| &o.findings).filter(|f| f.level == Level::Invalid) {
        let named = self::outside(f);
        if !outside.contains(&named) {
            outside.push(named);
        }
    }
    let observed = facts.response.as_ref().and_then(Known::get).map(|r| &r.observed).filter(|o| !o.validity.is_empty());
    let here = observed.map(|o| largest(o.validity.iter().copied()));
    // the statement whose limit is exceeded most, or is nearest
    let uses = observed.iter().flat_map(|o| &o.uses).map(|u| (u, largest(u.ratios.iter().copied())));
    let nearest = uses.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(Arg::word("none"), |(u, _)| statement(&u.part, u.what));
    let uses_any = nearest != Arg::word("none");
    let listed = || Arg::List(outside.iter().take(MOST_NAMED).cloned().collect());
    let required = Some(Arg::from(Message::new("required-validity")));
    let (result, verdict) = match here {
        // beside a resonance without damping, or where a use is infinite
        Some(x) if x.is_nan() && uses_any => (Message::new("validity-unbounded").arg("statement", nearest), Verdict::Failed),
        Some(x) if x.is_nan() => (Message::new("validity-nothing"), Verdict::NotComputed),
        Some(x) if !(x <= 1.0) => {
            (Message::new("validity-outside-here").arg("statement", nearest).arg("ratio", Arg::number(x)), Verdict::Failed)
        }
        Some(0.0) if outside.is_empty() => (Message::new("validity-none"), Verdict::NoLimit),
        Some(x) if outside.is_empty() => {
            (Message::new("validity-inside").arg("statement", nearest).arg("share", Arg::percent(x)), Verdict::Passed)
        }
        // modes at an operating speed with frequencies outside of a table
        Some(_) if facts.operating.is_some_and(|o| studied::modes_outside(facts.outcomes, Needed::of(o, facts.sign))) => {
            (Message::new("validity-studies").arg("outside", listed()), Verdict::Attention)
        }
        Some(_) => (Message::new("validity-elsewhere").arg("outside", listed()), Verdict::Passed),
        None if outside.is_empty() && facts.outcomes.iter().any(|o| o.end.is_complete()) => {
            (Message::new("validity-studies-inside"), Verdict::Passed)
        }
        None if outside.is_empty() => (Message::new("validity-nothing"), Verdict::NotComputed),
        None => (Message::new("validity-studies").arg("outside", listed()), Verdict::Attention),
    };
    // numbers beyond the limits of a model put its results in doubt, which is less than outside
    let doubts = facts.outcomes.iter().flat_map(|o| &o.findings).filter(|f| f.level == Level::Warning && f.id.starts_with("validity_"));
    let mut named: Vec<Arg> = doubts.filter_map(|f| f.message.arg_named("name").cloned()).collect();
    named.dedup();
    let (result, verdict) = match verdict {
        Verdict::Passed | Verdict::NoLimit if !named.is_empty() => {
            (Message::new("validity-doubt").arg("names", Arg::List(named)), Verdict::Attention)
        }
        _ => (result, verdict),
    };
    Check { required, ..Check::new("check-validity", result, verdict) }
}

#[cfg(test)]
mod tests {
    use super::used;

    #[test]
    fn what_is_no_number_comes_first() {
        for nan in [f64::NAN, -f64::NAN] {
            let all = used(vec![("a".into(), 2.0, 1.0), ("b".into(), nan, 1.0), ("c".into(), 3.0, 1.0)]);
            assert_eq!(all.iter().map(|l| l.0.as_str()).collect::<Vec<_>>(), ["b", "c", "a"]);
        }
    }
}
