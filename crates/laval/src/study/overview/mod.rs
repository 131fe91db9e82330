//! The first page of a report: whether the machine may run at its speed, how far trouble is, and what it does over the speed.
//!
//! Computed from the machine itself with the linear studies ([`Modes`], [`StabilityMap`], [`CriticalSpeeds`]), each within [`SECOND`], and from
//! what the studies of the file found. What would take longer is taken from a study of the file that computed it; without one the check is named and
//! not computed.
//!
//! Validity: small motions about the equilibrium; what a nonlinear study of the file found is stated beside it.

mod buckling;
mod checks;
mod forecast;
mod headline;
mod left_out;
mod machine;
mod margins;
mod nonlinear;
mod not_run;
mod operating;
mod over_frequency;
mod over_speed;
mod shapes;
mod slowest;
mod spins;
mod studied;
mod worst;

use crate::diagnostic::Diagnostic;
use crate::model::field::RangeValue;
use crate::model::part::Domain;
use crate::model::spins::same_ratio;
use crate::model::system::System;
use crate::outcome::{Arg, Block, Message, Outcome, OverSpeed, Overview};
use crate::solve::rest::{over_speed, rest};
use crate::solve::roots::{LEAST, Request, has_more_modes, in_region, roots, transcendental};
use crate::solve::stability::{Row, row};
use crate::study::linear::campbell::spin_orders;
use crate::study::linear::criterion::Criterion;
use crate::study::linear::critical_speeds::{CriticalSpeeds, CriticalSpeedsResult};
use crate::study::linear::forced_response::{ForcedResponse, ForcedResponseResult};
use crate::study::linear::modes::{Modes, ModesResult};
use crate::study::linear::stability_map::RESOLVED;
use crate::study::linear::stability_map::StabilityMap;
use crate::study::shared::limits::{self, Limits};
pub(super) use crate::study::shared::operation::MARGIN;
use crate::study::shared::operation::{self, Operation};
use crate::study::shared::speed_range::{self, SpinSpeeds, with_table_speeds};
use crate::study::shared::stations::Stations;
use crate::study::shared::support::About;
use crate::study::{Context, Study};
use laval_num::complex::C64;
use laval_num::order::ascending;
use laval_num::work::{Here, watched};
pub use not_run::with_studies_not_run;
use operating::Operating;
pub use shapes::mode;
use spins::Spins;
use studied::{Found, Needed};
use worst::Worst;

/// Most units of work of one check, about a second.
const SECOND: u64 = 1_000_000_000;
/// The same of what the margins of the operating speeds rest on, which no study of the file replaces.
const MARGINS: u64 = 4 * SECOND;
/// The same of the count of growing modes of any frequency: banded factorisations, which do ten units in a nanosecond.
const COUNT: u64 = 20 * SECOND;
/// Speeds of the range at which growth and response are computed.
const POINTS: usize = 120;
/// The lowest speed computed, over the highest of the page.
const SLOWEST: f64 = 1e-3;
/// The highest speed of the page over the highest operating speed, at most.
const FASTEST: f64 = 20.0;
/// Speeds computed about the operating speeds, where a narrow unstable range matters most.
const NEAR: usize = 60;
/// Width of that on both sides, over the speed, at least, and over the distance required.
const ABOUT: f64 = 0.2;
const BEYOND: f64 = 1.02;
/// Speeds at which critical ones are searched about the operating speeds.
const NARROW: usize = 24;
/// Speeds of a range of operating speeds, at least.
const OPERATING: usize = 40;

/// What a computation within a second gave.
pub(super) enum Known<R> {
    /// Its result.
    Yes(R),
    /// That of a study of the file, and the study's name.
    Studied(R, String),
    /// The machine cannot answer it, and why.
    Refused(Diagnostic),
    /// It takes longer.
    TooLong,
}

impl<R> Known<R> {
    fn get(&self) -> Option<&R> {
        match self {
            Known::Yes(r) | Known::Studied(r, _) => Some(r),
            _ => None,
        }
    }

    /// That of the file where the page has none of its own, or no time for the whole of it.
    fn or_studied(self, whole: impl FnOnce(&R) -> bool, found: impl FnOnce() -> Found<R>) -> Known<R> {
        let open = match &self {
            Known::TooLong | Known::Refused(_) => true,
            Known::Yes(r) => !whole(r),
            Known::Studied(..) => false,
        };
        match open.then(found).flatten() {
            Some((r, name)) => Known::Studied(r, name),
            None => self,
        }
    }

    /// With another form of its result.
    fn and_then<S>(self, form: impl FnOnce(R) -> Option<S>) -> Known<S> {
        match self {
            Known::Yes(r) => form(r).map_or(Known::TooLong, Known::Yes),
            Known::Studied(r, name) => form(r).map_or(Known::TooLong, |s| Known::Studied(s, name)),
            Known::Refused(d) => Known::Refused(d),
            Known::TooLong => Known::TooLong,
        }
    }

    /// Where it was taken from, unless the page computed it.
    fn source(&self) -> Option<Message> {
        match self {
            Known::Studied(_, name) => Some(Message::new("from-study").arg("study", Arg::name(name))),
            _ => None,
        }
    }

    /// Why it is not known.
    fn why(&self) -> Message {
        match self {
            Known::Refused(d) => Message::new("why-refused").arg("reason", d.message.clone()),
            _ => Message::new("why-too-long"),
        }
    }
}

/// Two results, each on a processor of its own where there are several.
fn both<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    let here = Here::now();
    // either may run on a thread that works for another computation
    rayon::join(
        || {
            let _counted = here.enter();
            a()
        },
        || {
            let _counted = here.enter();
            b()
        },
    )
}

/// The lowest and the highest of some speeds.
fn ends(speeds: &[f64]) -> Option<(f64, f64)> {
    let (low, high) = speeds.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), w| (a.min(*w), b.max(*w)));
    (low <= high).then_some((low, high))
}

fn within<T: Study>(study: &T, system: &System, context: &Context) -> Known<T::Result> {
    within_work(study, system, context, SECOND)
}

fn within_work<T: Study>(study: &T, system: &System, context: &Context, units: u64) -> Known<T::Result> {
    // under a bound on the work a study does one thing after the other, so that where it ends does not depend on the number of threads
    let context = &Context { work_limit: context.work_limit.min(u64::MAX - 1), ..*context };
    let run = || {
        // coefficients beyond a table that refuses them are not known
        speed_range::able(study, system)?;
        study.admit(system)?;
        study.compute(system, context)
    };
    limited(context, units, run)
}

/// A computation of so many units of work; none under a work limit of 0, with which the page rests on the studies of the file alone.
fn limited<R>(context: &Context, units: u64, run: impl FnOnce() -> Result<R, Diagnostic>) -> Known<R> {
    if context.work_limit == 0 {
        return Known::TooLong;
    }
    match watched(Some(context.cancel), units, run) {
        Ok(Ok(result)) => Known::Yes(result),
        Ok(Err(d)) => Known::Refused(d),
        Err(_) => Known::TooLong,
    }
}

/// All that the first page rests on.
pub(super) struct Facts<'a> {
    system: &'a System,
    /// Operating speeds, none at standstill.
    operating: Option<Operating>,
    operation: Operation,
    limits: Limits,
    /// Results of the studies of the file.
    outcomes: &'a [Outcome],
    modes: Option<(Modes, Known<ModesResult>)>,
    /// Response at the operating speeds.
    response: Option<Known<ForcedResponseResult>>,
    /// Range of the page, amounts of the speed.
    range: (f64, f64),
    /// Direction of the rotation, 1 or -1.
    sign: f64,
    stability: Known<Row>,
    /// The same about the operating speeds, in smaller steps.
    near: Option<Row>,
    /// The least stable of a range of operating speeds.
    worst: Option<Worst>,
    /// Modes of any frequency that grow at the operating speed of a machine with more modes than are computed: the one that grows most, none where all decay; not known where the
    /// count takes too long.
    growing: Option<Option<C64>>,
    /// Growth from which on a mode counts as unstable over the range, 1/s.
    threshold: f64,
    /// Unbalance of other spins.
    spins: Spins,
    /// Steady responses of the nonlinear machine at the operating speed.
    steady: Option<nonlinear::Steady>,
    criticals: Known<CriticalSpeedsResult>,
    /// Those about the operating speeds, where neither the page nor a study of the file knows them as far as the distance required.
    narrow: Option<CriticalSpeedsResult>,
    /// Where critical speeds are not known: the response over the range.
    forced: Option<ForcedResponseResult>,
    /// Study of the file whose response over the range is shown; none where the page computed it.
    response_study: Option<String>,
    /// The run-up in the time of `[operation]`.
    run_up: Option<Known<Outcome>>,
    /// The machine does not hold its position at rest.
    buckling: Option<buckling::Buckling>,
    /// Masses move in the rotor: no linear study answers, and a study of stationary states does.
    balls: bool,
}

impl Facts<'_> {
    /// The distance from resonances that the file requires.
    fn resonance_margin(&self) -> Option<f64> {
        operation::required_margin(self.system)
    }

    /// The speeds that the distance required reaches from the operating ones, amounts.
    fn reach(&self, operating: Operating, margin: Option<f64>) -> (f64, f64) {
        let margin = margin.unwrap_or(MARGIN);
        ((1.0 - margin) * operating.low, (1.0 + margin) * operating.high)
    }

    /// Multiples of the speed at which neither the page nor a study of the file searched for resonances.
    fn orders_open(&self) -> Vec<f64> {
        if self.criticals.get().is_some() || self.narrow.is_some() {
            return Vec::new();
        }
        let Some(o) = self.operating else { return Vec::new() };
        let reach = self.reach(o, self.resonance_margin());
        let open = |k: &&f64| !same_ratio(**k, 1.0) && !studied::spin_searched(self.system, self.outcomes, **k, reach);
        self.limits.orders.iter().filter(open).copied().collect()
    }

    /// Range of speeds searched for resonances; none where nothing was.
    fn searched(&self, over: &OverSpeed) -> Option<(f64, f64)> {
        let criticals = self.criticals.get();
        let own = if over.response_speed.is_empty() { criticals.and_then(|c| followed(c, self.sign)) } else { ends(&over.response_speed) };
        own.or_else(|| criticals.is_some_and(|c| c.end.is_complete()).then_some(over.range))
    }
}

/// Bodies and what joins them, for a drawing of the machine, and whether its axis lies.
pub fn blocks(system: &System) -> (Vec<Block>, bool) {
    (machine::blocks(system), Stations::horizontal(system))
}

/// Lowest and highest speed of the first page, rad/s, rising. `speeds`: what the studies of the file cover.
pub fn page_range(system: &System, speeds: &[SpinSpeeds]) -> (f64, f64) {
    let sign = system.machine.speed.filter(|w| *w != 0.0).map_or(1.0, f64::signum);
    let (low, high) = range(Operating::of(system, &operation::among(&system.machine.extras)), sign, speeds);
    let low = slowest::begin(system, low, sign, &orders(system, &limits::of(system)), &Context::quiet("page"));
    if sign < 0.0 { (-high, -low) } else { (low, high) }
}

/// What of the first page rests on the machine alone and takes longest: it can be computed while the studies run.
pub struct Beforehand {
    /// The run-up in the time of `[operation]`.
    run_up: Option<Known<Outcome>>,
    /// Modes of any frequency that grow at the operating speed; see [`Facts`].
    growing: Option<Option<C64>>,
}

impl Beforehand {
    /// Computes it.
    pub fn of(system: &System, context: &Context) -> Self {
        let rated = system.machine.speed.filter(|w| *w != 0.0);
        let operation = operation::among(&system.machine.extras);
        let of_run_up = || {
            let time = rated.and(operation.run_up_time)?;
            let sign = rated.map_or(1.0, f64::signum);
            let top = Operating::of(system, &operation).map_or(0.0, |o| sign * o.high);
            Some(checks::simulate(system, top, time, context))
        };
        let of_growing = || {
            rated.filter(|_| in_region(system) && !transcendental(system)).and_then(|speed| {
                let search = || {
                    roots(system, &rest(system, speed)?, &Request { growing: true, everywhere: true, alone: true, ..Request::default() })
                };
                match limited(context, COUNT, search) {
                    Known::Yes(found) => found.growing().map(|_| found.spectrum.least_stable().map(|m| m.value).filter(|v| v.re > 0.0)),
                    _ => None,
                }
            })
        };
        let (run_up, growing) = both(of_run_up, of_growing);
        Beforehand { run_up, growing }
    }
}

/// Multiples of the speed that excite, ascending: unbalance turns with every spin, whatever else does.
fn orders(system: &System, limits: &Limits) -> Vec<f64> {
    let other = |k: &f64| !limits.orders.iter().any(|own| same_ratio(*own, *k));
    let mut orders: Vec<f64> = limits.orders.iter().copied().chain(spin_orders(system).into_iter().filter(other)).collect();
    ascending(&mut orders);
    orders
}

/// The first page. `speeds`: what the studies of the file cover.
pub fn overview(system: &System, speeds: &[SpinSpeeds], outcomes: &[Outcome], context: &Context) -> Overview {
    overview_after(None, system, speeds, outcomes, context)
}

/// The same, with what was computed beforehand.
pub fn overview_after(
    beforehand: Option<Beforehand>,
    system: &System,
    speeds: &[SpinSpeeds],
    outcomes: &[Outcome],
    context: &Context,
) -> Overview {
    let rated = system.machine.speed.filter(|w| *w != 0.0);
    let operation = operation::among(&system.machine.extras);
    let operating = Operating::of(system, &operation);
    // of a rotor that turns the other way round the page shows the amounts of the speeds
    let sign = rated.map_or(1.0, f64::signum);
    let mut limits = limits::of(system);
    limits.orders = orders(system, &limits);
    let (low, high) = range(operating, sign, speeds);
    let range = (slowest::begin(system, low, sign, &limits.orders, context), high);
    let ends = [sign * range.0, sign * range.1];
    let speed = RangeValue { from: ends[0].min(ends[1]), to: ends[0].max(ends[1]), points: Some(POINTS) };
    let modes = rated.map(|speed| {
        let study = Modes { speed, about: About::Rest, threshold: 0.0, frequency: None };
        let known = within(&study, system, context).or_studied(|r| r.end.is_complete(), || studied::modes(outcomes, speed));
        (study, over_frequency::whole(system, known))
    });
    let ordered = |low: f64, high: f64, points: usize| {
        let ends = [sign * low, sign * high];
        RangeValue { from: ends[0].min(ends[1]), to: ends[0].max(ends[1]), points: Some(points) }
    };
    let response = operating.map(|o| {
        let speed = ordered(o.low, o.high, if o.is_one() { 1 } else { OPERATING });
        let known = within(&ForcedResponse::over(speed), system, context);
        known.or_studied(|r| r.end.is_complete(), || studied::response(outcomes, Needed::of(o, sign)))
    });
    let needed = operating.map(|o| Needed::of(o, sign));
    let map =
        |speed| StabilityMap { speed, parameter: None, about: About::Rest, criterion: Criterion::Growth, threshold: 0.0, frequency: None };
    let resonance_margin = operation::required_margin(system).unwrap_or(MARGIN);
    let wide = |margin: f64| (BEYOND * margin).clamp(ABOUT, 0.99);
    let of_whole = || {
        let stability = within(&map(speed), system, context).and_then(|r| r.rows.into_iter().next());
        stability.or_studied(|row| !row.stopped, || studied::growth(outcomes, needed?))
    };
    let of_worst = || {
        operating.and_then(|o| {
            speed_range::able(&map(ordered(o.low, o.high, 2)), system).ok()?;
            worst::worst(system, o, sign, context)
        })
    };
    let about = operating.map(|o| {
        let wide = wide(operation.instability_margin.unwrap_or(MARGIN));
        let ends = known(system, sign, ((1.0 - wide) * o.low, (1.0 + wide) * o.high));
        (ends, ordered(ends.0, ends.1, NEAR))
    });
    let covered = |row: &Row| about.as_ref().is_some_and(|(ends, _)| fine(row, *ends));
    // also beside a study of the file that has few speeds, or none as far as the distance required
    let of_near = |worst: &Option<Worst>| {
        let (_, about) = about.as_ref()?;
        let known = match worst {
            // the boundaries of what is unstable between two of the speeds as well
            Some(worst) if !in_region(system) => limited(context, MARGINS, || {
                speed_range::able(&map(*about), system)?;
                let mut speeds = with_table_speeds(about, NEAR, system);
                speeds.extend(&worst.peaks);
                ascending(&mut speeds);
                speeds.dedup();
                row(system, &over_speed(system), &speeds, 0.0, |done| context.goes_on(done))
            }),
            _ => within_work(&map(*about), system, context, MARGINS).and_then(|r| r.rows.into_iter().next()),
        };
        match known {
            Known::Yes(r) => Some(r),
            _ => None,
        }
    };
    let of_stability = || {
        // roots that are searched one by one take longest: the speeds about the operating ones beside the whole range
        let known = || needed.and_then(|n| studied::growth(outcomes, n)).is_some_and(|(row, _)| covered(&row));
        if in_region(system) && !known() {
            let (stability, (worst, near)) = both(of_whole, || {
                let worst = of_worst();
                let near = of_near(&worst);
                (worst, near)
            });
            return (stability, near, worst);
        }
        let (stability, worst) = (of_whole(), of_worst());
        let near = if matches!(&stability, Known::Studied(row, _) if covered(row)) { None } else { of_near(&worst) };
        (stability, near, worst)
    };
    let of_criticals = || {
        let criticals = within(&CriticalSpeeds { speed, orders: limits.orders.clone(), margin: MARGIN }, system, context);
        let criticals = criticals.or_studied(|r| r.end.is_complete(), || studied::criticals(outcomes, needed?, &limits.orders));
        // what ended early below the operating speeds tells nothing of them
        let reaches = |r: &CriticalSpeedsResult| {
            r.end.is_complete() || followed(r, sign).is_some_and(|e| operating.is_none_or(|o| e.1 >= o.high * (1.0 - 1e-9)))
        };
        let criticals = match criticals {
            Known::Yes(r) if !reaches(&r) => Known::TooLong,
            known => known,
        };
        let narrow = operating.filter(|o| !o.is_one() || o.high > 0.0).and_then(|o| {
            let reach = ((1.0 - resonance_margin) * o.low, (1.0 + resonance_margin) * o.high);
            let known = |r: &CriticalSpeedsResult| {
                let covers = |e: (f64, f64)| e.0 <= reach.0 * (1.0 + 1e-9) && reach.1 <= e.1 * (1.0 + 1e-9);
                r.end.is_complete() && followed(r, sign).is_none_or(covers)
            };
            if criticals.get().is_some_and(known) {
                return None;
            }
            let wide = wide(resonance_margin);
            let ends = self::known(system, sign, ((1.0 - wide) * o.low, (1.0 + wide) * o.high));
            let speed = ordered(ends.0, ends.1, NARROW);
            match within_work(&CriticalSpeeds { speed, orders: limits.orders.clone(), margin: MARGIN }, system, context, MARGINS) {
                Known::Yes(r) if r.end.is_complete() => Some(r),
                _ => None,
            }
        });
        let mut response_study = match &criticals {
            Known::Studied(_, name) => studied::response_beside(outcomes, needed, name),
            _ => None,
        };
        let forced = match criticals {
            Known::Yes(_) | Known::Studied(..) => None,
            _ => match within(&ForcedResponse::over(speed), system, context)
                .or_studied(|r| r.end.is_complete(), || studied::forced(outcomes, needed?))
            {
                Known::Yes(r) => Some(r),
                Known::Studied(r, name) => {
                    response_study = Some(name);
                    Some(r)
                }
                _ => None,
            },
        };
        (criticals, narrow, forced, response_study)
    };
    // none of them rests on another
    let (((stability, near, worst), (criticals, narrow, forced, response_study)), Beforehand { run_up, growing }) =
        both(|| both(of_stability, of_criticals), || beforehand.unwrap_or_else(|| Beforehand::of(system, context)));
    // slower waves of a liquid that nothing inside it damps are within rounding
    let fastest = range.1;
    let threshold = match system.domains(fastest).iter().any(Domain::undamped) {
        true => LEAST * fastest,
        false if has_more_modes(system) => RESOLVED * fastest,
        false => 0.0,
    };
    let balls = system.slots().iter().any(|s| s.part.movable_masses().is_some());
    let mut facts = Facts {
        system,
        operating,
        operation,
        limits,
        outcomes,
        modes,
        response,
        range,
        sign,
        stability,
        near,
        worst,
        growing,
        threshold,
        spins: operating.map_or_else(Spins::default, |o| Spins::of(system, outcomes, sign * o.low, sign * o.high)),
        steady: None,
        criticals,
        narrow,
        forced,
        response_study,
        run_up,
        buckling: if balls { None } else { buckling::buckling(system, context) },
        balls,
    };
    facts.steady = operating.and_then(|o| nonlinear::steady(&facts, o));
    let mut out = Overview {
        operating: rated.map(f64::abs),
        operating_range: operating.filter(|o| !o.is_one()).map(|o| (o.low, o.high)),
        over_speed: over_speed::over_speed(&facts),
        modes: shapes::modes(&facts),
        machine: machine::blocks(system),
        horizontal: Stations::horizontal(system),
        left_out: left_out::left_out(&facts),
        ..Overview::default()
    };
    out.checks = checks::checks(&facts, out.over_speed.as_ref());
    headline::headline(&facts, &mut out);
    out
}

/// First and last amount of the speed at which modes were followed; none of a search of another kind.
fn followed(found: &CriticalSpeedsResult, sign: f64) -> Option<(f64, f64)> {
    ends(&found.strongest.iter().map(|s| sign * s.speed).collect::<Vec<f64>>())
}

/// The part of a range of amounts of the speed in which all coefficients are known.
fn known(system: &System, sign: f64, (low, high): (f64, f64)) -> (f64, f64) {
    let (from, to) = speed_range::known_speeds(system);
    if sign < 0.0 { (low.max(-to), high.min(-from)) } else { (low.max(from), high.min(to)) }
}

/// The row has speeds as near to each other as those that the page computes itself, all over this range.
fn fine(row: &Row, (low, high): (f64, f64)) -> bool {
    let mut speeds: Vec<f64> = row.samples.iter().map(|s| s.speed.abs()).collect();
    ascending(&mut speeds);
    let step = (high - low) / (NEAR - 1) as f64;
    let covers = ends(&speeds).is_some_and(|(a, b)| a <= low && high <= b);
    covers && speeds.windows(2).filter(|w| w[1] > low && w[0] < high).all(|w| w[1] - w[0] <= step.max(0.01 * high))
}

/// The range shown: that of the studies of the file, with the operating speed well inside.
fn range(operating: Option<Operating>, sign: f64, speeds: &[SpinSpeeds]) -> (f64, f64) {
    let turned = speeds.iter().map(|s| SpinSpeeds::between(sign * s.from, sign * s.to));
    let wide = turned.filter(|s| s.to > s.from && s.from >= 0.0);
    let (mut from, mut to) = wide.fold((f64::INFINITY, 0.0f64), |(a, b), s| (a.min(s.from), b.max(s.to)));
    if let Some(o) = operating {
        // far above the operating speeds nothing concerns the page, and speeds far apart would pass over what lies between
        to = to.min(FASTEST * o.high).max(1.5 * o.high);
        // a run-up begins at rest; at standstill itself nothing turns
        let lowest = from.min(0.2 * o.low).min(SLOWEST * 1.5 * o.high);
        return (if lowest > 0.0 { lowest } else { SLOWEST * 0.2 * o.low }, to);
    }
    if !(from.is_finite() && to > 0.0) {
        (from, to) = (10.0, 1000.0);
    }
    (from.max(SLOWEST * to), to)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A computation that the page ended early gives way to that of the file, a whole one does not; without a study what there is stays.
    #[test]
    fn a_study_of_the_file_replaces_what_ended_early() {
        let own = |whole: bool| Known::Yes(1).or_studied(|_| whole, || Some((2, "map".to_string())));
        assert!(matches!(own(false), Known::Studied(2, _)) && matches!(own(true), Known::Yes(1)));
        assert!(matches!(Known::Yes(1).or_studied(|_| false, || None), Known::Yes(1)));
        assert!(matches!(Known::<i32>::TooLong.or_studied(|_| true, || Some((2, "map".to_string()))), Known::Studied(2, _)));
        assert!(matches!(Known::<i32>::TooLong.or_studied(|_| true, || None), Known::TooLong));
    }
}
