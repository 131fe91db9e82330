//! Orders of a motion at which a part has no steady answer, or that of a few of its waves.

use crate::diagnostic::Diagnostic;
use crate::harmonic::balance::terms::Terms;
use crate::model::part::Words;
use crate::model::system::System;
use laval_model::text;
use laval_num::dense::Singular;
use laval_num::order::ascending;

/// Orders among the waves of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct Among {
    /// Orders, multiples of the speed with their direction of whirl, ascending.
    pub orders: Vec<f64>,
    /// The range of frequencies, rad/s.
    pub range: [f64; 2],
    /// The part has no answer there; else the one of the waves that are kept.
    pub dense: bool,
    /// The part's words.
    pub words: Words,
}

impl Among {
    /// The orders in words.
    pub fn list(&self) -> String {
        let list: Vec<String> = self.orders.iter().take(6).map(|n| format!("{}", (1e4 * n).round() / 1e4)).collect();
        format!("{}{}", list.join(", "), if self.orders.len() > 6 { ", ..." } else { "" })
    }
}

/// Those of some orders of a motion at a speed that lie among the waves of a part, where the whole part has no steady answer.
pub fn among_waves(system: &System, speed: f64, orders: impl IntoIterator<Item = f64>) -> Option<Among> {
    let domains = system.domains(speed);
    let dense = domains.iter().find_map(|d| Some((d.dense?, true, d.words)));
    let (range, dense, words) = dense.or_else(|| domains.iter().find_map(|d| Some((d.truncated?, false, d.words))))?;
    // at standstill nothing moves, with the speed the part moves like a rigid one, and the ends of the range have closed forms
    let room = 1e-9 * speed.abs();
    let inside = |w: f64| w > range[0] + room && w < range[1] - room && w.abs() > room && (w - speed).abs() > room;
    let mut orders: Vec<f64> = orders.into_iter().filter(|n| inside(n * speed)).collect();
    ascending(&mut orders);
    orders.dedup();
    (!orders.is_empty()).then_some(Among { orders, range, dense, words })
}

/// Why the linear parts have no motion at some order of a speed.
pub(super) fn refused(system: &System, terms: &Terms, speed: f64, why: &Singular) -> Diagnostic {
    let orders = terms.orders.iter().map(|&k| k as f64 / terms.divisor as f64);
    if let Some(among) = among_waves(system, speed, orders.flat_map(|n| [n, -n])).filter(|a| a.dense) {
        let [a, b] = among.range.map(|w| text::quantity(w, "rad/s"));
        let speed = text::quantity(speed, "rad/s");
        let (orders, waves, name) = (among.list(), text::term(among.words.waves), text::term(among.words.name));
        let message = match among.orders.len() {
            1 => text!(
                "order {orders} of the motion would lie inside the dense range of {waves} of {name}, from {a} to {b} at {speed}, where it has no steady response",
                orders,
                waves,
                name,
                a,
                b,
                speed
            ),
            _ => text!(
                "orders {orders} of the motion would lie inside the dense range of {waves} of {name}, from {a} to {b} at {speed}, where it has no steady response",
                orders,
                waves,
                name,
                a,
                b,
                speed
            ),
        };
        let help = text!(
            "{remedy}; with symmetry = \"half\", where the law has it, only odd orders move",
            remedy = text::term(among.words.remedy)
        );
        return Diagnostic::error("harmonic.dense", message).help(help);
    }
    Diagnostic::error("harmonic.singular", text!("the machine has no periodic motion at some order: {why}", why))
        .help(text!("a body without any spring drifts; a coordinate without mass, damping and stiffness is undetermined"))
}
