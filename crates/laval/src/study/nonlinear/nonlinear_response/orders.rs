//! Sub- and superharmonic parts of the response: which orders exceed an amplitude, from which speed on, in which sense they turn.
//!
//! Of order k of the base frequency a body moves on an ellipse of semi-major axis `|Z_k| + |Z_-k|`, forward where `|Z_k|` is the larger. Along a branch the speeds
//! at which the semi-major axis passes the threshold are solved for between neighbouring points, and the largest value between them likewise.

use super::measuring::Measuring;
use super::shown::{Shown, branch};
use super::tables::label;
use crate::model::system::Pair;
use crate::outcome::{Arg, Axis, Figure, Finding, Line, Message, Outcome, OutcomeError, Panel, Rule, SpecialPoint, Status, Table};
use crate::solve::harmonic::balance::orbit::Orbit;
use crate::solve::harmonic::balance::problem::Balance;
use crate::solve::harmonic::branches::response::{Response, State, Traced};
use laval_num::newton::{Options, newton};
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

/// Parts of the response listed one by one at most.
const MOST: usize = 6;
/// Forward and backward amplitudes this near to each other are a motion along a line.
const LINE: f64 = 1e-3;
/// Lowest amplitude drawn, over the threshold.
const DRAWN: f64 = 1e-2;
/// Bodies with a panel of their own at most.
const MOST_PANELS: usize = 4;

/// Forward and backward amplitude of a body at an order, m.
pub type Whirl = (f64, f64);

fn axis(w: Whirl) -> f64 {
    w.0 + w.1
}

/// In which sense an ellipse is run through: forward, backward, or along a line.
fn sense((forward, backward): Whirl) -> &'static str {
    if (forward - backward).abs() <= LINE * forward.max(backward) {
        "line"
    } else if forward > backward {
        "forward"
    } else {
        "backward"
    }
}

/// An order over the spin frequency, in lowest terms.
fn ratio(order: usize, turns: usize) -> (usize, usize) {
    let common = (1..=turns).rev().find(|d| order.is_multiple_of(*d) && turns.is_multiple_of(*d)).unwrap_or(1);
    (order / common, turns / common)
}

fn number(order: usize, turns: usize) -> String {
    match ratio(order, turns) {
        (p, 1) => p.to_string(),
        (p, q) => format!("{p}/{q}"),
    }
}

fn kind(order: usize, turns: usize) -> &'static str {
    match ratio(order, turns) {
        (_, 1) => "superharmonic",
        (1, _) => "subharmonic",
        _ => "component",
    }
}

/// An end of an interval in which an order exceeds the threshold.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Edge {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Speeds between which it lies, rad/s.
    pub bracket: (f64, f64),
    /// Scaled residual of the balance.
    pub residual: f64,
    /// It was solved for; otherwise only the bracket is known.
    pub located: bool,
    /// The branch begins or ends here, still above.
    pub cut: bool,
}

/// Where an order of a body exceeds the threshold, along a branch.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Stretch {
    /// Index of the body.
    pub body: usize,
    /// Order of the base frequency.
    pub order: usize,
    /// Index of the branch.
    pub branch: usize,
    /// Ends by speed.
    pub ends: [Edge; 2],
    /// Largest amplitude.
    pub largest: Whirl,
    /// Its speed, rad/s.
    pub at: f64,
}

/// The whirls of one branch: by point, order and body.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Whirls {
    /// Orders of the base frequency beside the synchronous one.
    pub orders: Vec<usize>,
    /// By point, order and body.
    pub values: Vec<Vec<Vec<Whirl>>>,
}

/// The orders of all branches, and where they exceed the threshold.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Orders {
    /// Where an order of a body exceeds the threshold, along a branch.
    pub stretches: Vec<Stretch>,
    /// By branch.
    pub whirls: Vec<Whirls>,
}

impl Whirls {
    fn of(balance: &mut Balance, branch: &Traced, bodies: &[(String, Pair)]) -> Whirls {
        let mut out = Whirls::default();
        for p in &branch.points {
            let orbit = Orbit::of(balance, &p.x, p.speed).unwrap_or_default();
            if out.orders.is_empty() {
                out.orders = orbit.orders.iter().copied().filter(|&k| k != 0 && k != branch.turns()).collect();
            }
            let whirl = |k: usize, x: &Pair| if orbit.orders.is_empty() { (f64::NAN, f64::NAN) } else { whirl(&orbit, x, k) };
            out.values.push(out.orders.iter().map(|&k| bodies.iter().map(|b| whirl(k, &b.1)).collect()).collect());
        }
        out
    }
}

fn whirl(orbit: &Orbit, x: &Pair, order: usize) -> Whirl {
    let (forward, backward) = orbit.whirl(x, order);
    (forward.abs(), backward.abs())
}

/// One order of one body between two neighbouring points of a branch.
struct Between<'b, 'a> {
    balance: &'b mut Balance<'a>,
    from: &'b State,
    to: &'b State,
    x: &'b Pair,
    order: usize,
}

impl Between<'_, '_> {
    /// Speed, amplitudes and residual at a share of the way; `None` where the state there is not one between the two.
    fn at(&mut self, t: f64) -> Option<(f64, Whirl, f64)> {
        let speed = self.from.speed + t * (self.to.speed - self.from.speed);
        let guess: Vec<f64> = self.from.x.iter().zip(&self.to.x).map(|(a, b)| a + t * (b - a)).collect();
        let mut x = guess.clone();
        let done = newton(self.balance, &mut x, speed, &Options { to_rounding: true, ..Options::default() }).ok()?;
        let far = |((x, g), (a, b)): ((&f64, &f64), (&f64, &f64))| (x - g).abs() / ((b - a).abs() + 1e-3 * a.abs().max(b.abs()));
        let strayed = x.iter().zip(&guess).zip(self.from.x.iter().zip(&self.to.x)).map(far);
        // an unknown that hardly moves has no say: the others hold it
        let strayed = strayed.zip(self.balance.scales()).zip(&x).filter(|((_, s), x)| x.abs() > 1e-6 * **s).any(|((f, _), _)| !(f <= 2.0));
        if strayed {
            return None;
        }
        let orbit = Orbit::of(self.balance, &x, speed).ok()?;
        Some((speed, whirl(&orbit, self.x, self.order), done.residual))
    }

    /// Where the semi-major axis equals the threshold, by the rule of false position (Illinois); `None` where the states between cannot be had.
    fn crossing(&mut self, threshold: f64, ends: [f64; 2]) -> Option<Edge> {
        let height = |a: f64| (a / threshold).ln();
        let (mut a, mut b) = ((0.0, height(ends[0])), (1.0, height(ends[1])));
        let place = |t: f64, s: &Self| s.from.speed + t * (s.to.speed - s.from.speed);
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..60 {
            let t = if a.1.is_finite() && b.1.is_finite() { (a.0 * b.1 - b.0 * a.1) / (b.1 - a.1) } else { 0.5 * (a.0 + b.0) };
            let (speed, whirl, residual) = self.at(t)?;
            let h = height(axis(whirl));
            if h.is_nan() {
                return None;
            }
            last = Some((speed, residual));
            if (h > 0.0) == (b.1 > 0.0) {
                (b, a.1) = ((t, h), 0.5 * a.1);
            } else {
                (a, b.1) = ((t, h), 0.5 * b.1);
            }
            if h.abs() < 1e-12 || (b.0 - a.0).abs() < 1e-14 {
                break;
            }
        }
        let (speed, residual) = last?;
        let ends = [place(a.0, self), place(b.0, self)];
        let bracket = (ends[0].min(ends[1]).min(speed), ends[0].max(ends[1]).max(speed));
        Some(Edge { speed, bracket, residual, located: true, cut: false })
    }

    /// The largest semi-major axis between both points (golden section).
    fn largest(&mut self) -> Option<(f64, Whirl)> {
        const GOLDEN: f64 = 0.618_033_988_749_894_8;
        let (mut a, mut b) = (0.0, 1.0);
        let (mut c, mut d) = (1.0 - GOLDEN, GOLDEN);
        let (mut at_c, mut at_d) = (self.at(c)?, self.at(d)?);
        for _ in 0..40 {
            if axis(at_c.1) > axis(at_d.1) {
                (b, d, at_d) = (d, c, at_c);
                c = b - GOLDEN * (b - a);
                at_c = self.at(c)?;
            } else {
                (a, c, at_c) = (c, d, at_d);
                d = a + GOLDEN * (b - a);
                at_d = self.at(d)?;
            }
        }
        let best = if axis(at_c.1) > axis(at_d.1) { at_c } else { at_d };
        Some((best.0, best.1))
    }
}

impl Measuring<'_> {
    /// The orders of all states, and where they exceed the threshold, m.
    pub(super) fn orders(&mut self, response: &Response, threshold: f64) -> Orders {
        let mut out = Orders::default();
        for (b, branch) in response.branches.iter().enumerate() {
            let bodies = self.bodies.clone();
            let balance = self.balance_mut(branch);
            let whirls = Whirls::of(balance, branch, &bodies);
            for (o, &order) in whirls.orders.iter().enumerate() {
                for (body, (_, x)) in bodies.iter().enumerate() {
                    let values: Vec<Whirl> = whirls.values.iter().map(|v| v[o][body]).collect();
                    let found = stretches_of(balance, branch, &values, (x, order), threshold);
                    out.stretches.extend(found.into_iter().map(|(ends, largest, at)| Stretch {
                        body,
                        order,
                        branch: b,
                        ends,
                        largest,
                        at,
                    }));
                }
            }
            out.whirls.push(whirls);
        }
        out
    }
}

impl Shown<'_> {
    /// The orders that exceed the threshold (m) anywhere: findings, special points, table and figure.
    pub(super) fn with_orders(&self, orders: &Orders, threshold: f64, mut out: Outcome) -> Result<Outcome, OutcomeError> {
        let (response, Orders { stretches, whirls }) = (self.response, orders);
        for f in self.order_findings(response, stretches, threshold) {
            out = out.finding(f);
        }
        for s in stretches {
            for (e, what) in s.ends.iter().zip(["onset", "end"]).filter(|(e, _)| !e.cut) {
                let turns = response.branches[s.branch].turns();
                let name = format!("{} {what}", kind(s.order, turns));
                let status = if e.located { Status::Located } else { Status::Bracketed };
                let point = SpecialPoint::new(name, e.speed, e.bracket).of(&self.bodies[s.body]).status(status);
                out = out.special_point(point.evidence("order", s.order as f64 / turns as f64, "").evidence(
                    "scaled residual",
                    e.residual,
                    "",
                ));
            }
        }
        if stretches.is_empty() {
            return Ok(out);
        }
        let table = self.order_table(response, whirls, stretches)?;
        out = out.table(table);
        Ok(out.figure(self.order_figure(stretches, threshold)))
    }

    fn order_findings(&self, response: &Response, stretches: &[Stretch], threshold: f64) -> Vec<Finding> {
        let limit = || Arg::quantity(threshold, "m");
        if stretches.is_empty() {
            return vec![Finding::info("no_orders", "nonlinear-response-no-orders").arg("limit", limit())];
        }
        let mut sorted: Vec<&Stretch> = stretches.iter().collect();
        sorted.sort_by_number_down(|a| axis(a.largest));
        let mut out: Vec<Finding> = Vec::new();
        for s in sorted.iter().take(MOST) {
            let traced = &response.branches[s.branch];
            let (name, turns) = (&self.bodies[s.body], traced.turns());
            let (order, divisor) = ratio(s.order, turns);
            let [first, last] = s.ends;
            let extent = match (first.cut, last.cut) {
                (true, true) => "all",
                (false, false) => "inside",
                (true, false) => "begins",
                (false, true) => "ends",
            };
            let f = Finding::info(format!("{}_range", kind(s.order, turns)), "nonlinear-response-order-range")
                .of(format!("{name} order {}", number(s.order, turns)))
                .arg("kind", Arg::word(kind(s.order, turns)))
                .arg("order", Arg::count(order))
                .arg("divisor", Arg::count(divisor))
                .arg("body", Arg::name(name))
                .arg("limit", limit())
                .arg("extent", Arg::word(extent))
                .arg("to", Arg::speed(last.speed))
                .arg("branch", branch(traced.origin))
                .arg("largest", Arg::quantity(axis(s.largest), "m"))
                .arg("speed", Arg::speed(s.at))
                .arg("sense", Arg::word(sense(s.largest)));
            let f = f.value(first.speed, "rad/s").evidence("end", last.speed, "rad/s");
            let f = f.evidence("largest amplitude", axis(s.largest), "m").evidence("its speed", s.at, "rad/s");
            let f = f.evidence("forward amplitude there", s.largest.0, "m").evidence("backward amplitude there", s.largest.1, "m");
            let f = f.evidence("width of the bracket", first.bracket.1 - first.bracket.0, "rad/s");
            out.push(f.evidence("scaled residual", first.residual, ""));
        }
        if sorted.len() > MOST {
            let more = Finding::info("more_orders", "nonlinear-response-more-orders");
            out.push(more.arg("more", Arg::count(sorted.len() - MOST)).arg("limit", limit()));
        }
        out
    }

    /// Rows for every order that exceeds the threshold anywhere.
    fn order_table(&self, response: &Response, all: &[Whirls], stretches: &[Stretch]) -> Result<Table, OutcomeError> {
        struct Row {
            branch: usize,
            point: usize,
            order: usize,
            index: usize,
        }
        let mut rows: Vec<Row> = Vec::new();
        for (branch, whirls) in all.iter().enumerate() {
            let turns = response.branches[branch].turns();
            let reported =
                |order: usize| stretches.iter().any(|s| ratio(s.order, response.branches[s.branch].turns()) == ratio(order, turns));
            for (index, &order) in whirls.orders.iter().enumerate().filter(|(_, o)| reported(**o)) {
                rows.extend((0..whirls.values.len()).map(|point| Row { branch, point, order, index }));
            }
        }
        let traced = |r: &Row| &response.branches[r.branch];
        let mut t =
            Table::new("orders", "Orders beside the synchronous one that exceed the threshold somewhere, order by order along each branch")
                .int("branch", "", "number of the branch", rows.iter().map(|r| r.branch as i64 + 1).collect())
                .text("states", "family of states", rows.iter().map(|r| label(traced(r)).to_string()).collect())
                .float("speed", "rad/s", "spin speed", rows.iter().map(|r| traced(r).points[r.point].speed).collect())
                .text("order", "frequency over the spin frequency", rows.iter().map(|r| number(r.order, traced(r).turns())).collect())
                .flag("begins", "first point of a branch", rows.iter().map(|r| r.point == 0).collect())
                .flag("not unstable", "stable, or not assessed", rows.iter().map(|r| !traced(r).points[r.point].unstable()).collect());
        for (k, name) in self.bodies.iter().enumerate() {
            let column = |f: &dyn Fn(Whirl) -> f64| rows.iter().map(|r| f(all[r.branch].values[r.point][r.index][k])).collect::<Vec<f64>>();
            let noted = |doc: &'static str| Arg::noted(doc, "NaN where the motion could not be had");
            t = t
                .float(format!("{name} forward"), "m", noted("modulus of the forward amplitude"), column(&|w| w.0))
                .float(format!("{name} backward"), "m", noted("modulus of the backward amplitude"), column(&|w| w.1))
                .float(format!("{name} amplitude"), "m", noted("semi-major axis, their sum"), column(&axis));
        }
        t.build()
    }

    fn order_figure(&self, stretches: &[Stretch], threshold: f64) -> Figure {
        let alt = Message::new("nonlinear-response-alt-orders").arg("bodies", Arg::names(self.bodies.iter().take(MOST_PANELS)));
        let mut figure = Figure::new("orders", "Sub- and superharmonics", alt).x(Axis::new("spin speed", "rad/s"));
        // what lies far below the threshold is no matter
        let largest = stretches.iter().map(|s| axis(s.largest)).fold(threshold, f64::max);
        let top = 2e6 * largest;
        for name in self.bodies.iter().take(MOST_PANELS) {
            let line =
                Line::new("orders", "speed", format!("{name} amplitude")).group("order").begins_where("begins").solid_where("not unstable");
            let panel = Panel::new(Axis::log(Arg::of("amplitude", Arg::name(name)), "µm").factor(1e6).range(1e6 * DRAWN * threshold, top))
                .mark(line)
                .mark(Rule::y(threshold, "threshold"));
            figure = figure.panel(panel);
        }
        figure
    }
}

/// Stretches of a branch in which the semi-major axis is above the threshold: ends by speed, largest amplitude, its speed.
fn stretches_of(
    balance: &mut Balance,
    branch: &Traced,
    values: &[Whirl],
    (x, order): (&Pair, usize),
    threshold: f64,
) -> Vec<([Edge; 2], Whirl, f64)> {
    let mut out = Vec::new();
    let points = &branch.points;
    let folded = |i: usize| branch.folds.iter().any(|f| f.after == i);
    let mut start = 0;
    for run in values.chunk_by(|a, b| (axis(*a) > threshold) == (axis(*b) > threshold)) {
        let (first, last) = (start, start + run.len() - 1);
        start += run.len();
        if !(axis(run[0]) > threshold) {
            continue;
        }
        // between points `below` and `above`; the branch ends where there is no point below
        let mut edge = |below: Option<usize>, above: usize| -> Edge {
            let cut = Edge {
                speed: points[above].speed,
                bracket: (points[above].speed, points[above].speed),
                residual: points[above].residual,
                located: true,
                cut: true,
            };
            let Some(below) = below.filter(|&b| b < points.len()) else { return cut };
            let (from, to) = (&points[below], &points[above]);
            let rough = (from.speed.min(to.speed), from.speed.max(to.speed));
            let bracket = Edge { bracket: rough, located: false, cut: false, ..cut };
            if folded(below.min(above)) || from.speed == to.speed {
                return bracket;
            }
            let ends = [axis(values[below]), axis(values[above])];
            Between { balance: &mut *balance, from, to, x, order }.crossing(threshold, ends).unwrap_or(bracket)
        };
        let mut ends = [edge(first.checked_sub(1), first), edge(Some(last + 1), last)];
        // a stretch that turns back at a fold has its lowest speed there
        let speeds = || points[first..=last].iter().map(|p| p.speed);
        let (least, most) = speeds().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), w| (a.min(w), b.max(w)));
        ends.sort_by_number(|a| a.speed);
        let turned = branch.folds.iter().filter(|f| first <= f.after && f.after < last.max(first + 1));
        for f in turned {
            let fold = Edge { speed: f.speed, bracket: f.bracket, residual: f.residual, located: f.confirmed, cut: false };
            if f.speed <= least.min(ends[0].speed) {
                ends[0] = fold;
            } else if f.speed >= most.max(ends[1].speed) {
                ends[1] = fold;
            }
        }
        // or where it turns without a fold, as at a pitchfork: the branch spans its points
        for (k, beyond) in [(0, least < ends[0].speed), (1, most > ends[1].speed)] {
            let speed = [least, most][k];
            if let Some(p) = points[first..=last].iter().find(|p| beyond && p.speed == speed) {
                ends[k] = Edge { speed, bracket: (speed, speed), residual: p.residual, located: true, cut: true };
            }
        }
        let Some(top) = (first..=last).max_by(|&a, &b| axis(values[a]).total_cmp(&axis(values[b]))) else { continue };
        let (mut at, mut largest) = (points[top].speed, values[top]);
        for (a, b) in [(top.checked_sub(1), Some(top)), (Some(top), Some(top + 1).filter(|&b| b < points.len()))] {
            let (Some(a), Some(b)) = (a, b) else { continue };
            if folded(a) {
                continue;
            }
            let found = Between { balance: &mut *balance, from: &points[a], to: &points[b], x, order }.largest();
            if let Some((speed, w)) = found.filter(|f| axis(f.1) > axis(largest)) {
                (at, largest) = (speed, w);
            }
        }
        out.push((ends, largest, at));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_have_their_names() {
        assert_eq!((number(3, 1), kind(3, 1)), ("3".into(), "superharmonic"));
        assert_eq!((number(1, 3), kind(1, 3)), ("1/3".into(), "subharmonic"));
        assert_eq!((number(6, 3), kind(6, 3)), ("2".into(), "superharmonic"));
        assert_eq!((number(5, 3), kind(5, 3)), ("5/3".into(), "component"));
        assert_eq!((number(2, 4), kind(2, 4)), ("1/2".into(), "subharmonic"));
        assert_eq!([sense((2.0, 1.0)), sense((1.0, 2.0)), sense((1.0, 1.0))], ["forward", "backward", "line"]);
    }
}
