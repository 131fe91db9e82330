//! Distances of the operating speeds from instability and resonance.

use super::operating::Operating;
use crate::outcome::OverSpeed;

/// The nearest trouble on both sides of the operating speeds.
pub(super) struct Nearest {
    /// The nearest below, rad/s.
    pub below: Option<f64>,
    /// The nearest above.
    pub above: Option<f64>,
    /// Places among the operating speeds.
    pub inside: Vec<f64>,
}

impl Nearest {
    /// Of places along the speed.
    pub fn of(places: impl IntoIterator<Item = f64>, operating: Operating) -> Nearest {
        let mut out = Nearest { below: None, above: None, inside: Vec::new() };
        for p in places {
            if operating.contains(p) {
                out.inside.push(p);
            } else if p < operating.low {
                out.below = Some(out.below.map_or(p, |b: f64| b.max(p)));
            } else {
                out.above = Some(out.above.map_or(p, |a: f64| a.min(p)));
            }
        }
        out
    }

    /// The smaller distance over the speed it is measured from; none where there is nothing.
    pub fn margin(&self, operating: Operating) -> Option<f64> {
        if !self.inside.is_empty() {
            return Some(0.0);
        }
        let below = self.below.map(|p| (operating.low - p) / operating.low);
        let above = self.above.map(|p| (p - operating.high) / operating.high);
        below.into_iter().chain(above).reduce(f64::min)
    }

    /// The place that the margin is measured to.
    pub fn place(&self, operating: Operating) -> Option<f64> {
        let near = |p: &f64| if *p < operating.low { operating.low - p } else { (p - operating.high).max(0.0) };
        let all = self.inside.first().copied().into_iter().chain(self.below).chain(self.above);
        all.min_by(|a, b| near(a).total_cmp(&near(b)))
    }
}

/// Edges of the unstable ranges around the operating speeds; the operating speed itself where it lies in such a range.
pub(super) fn instability(over: &OverSpeed, operating: Operating) -> Nearest {
    let place = |u: &crate::outcome::Unstable| match () {
        _ if u.to < operating.low => u.to,
        _ if u.from > operating.high => u.from,
        _ => u.from.max(operating.low),
    };
    Nearest::of(over.unstable.iter().map(place), operating)
}

/// Resonances around the operating speeds, but for critically damped ones.
pub(super) fn resonance(over: &OverSpeed, operating: Operating) -> Nearest {
    Nearest::of(over.resonances.iter().map(|r| r.speed).filter(|w| !over.critically_damped.contains(w)), operating)
}

/// Jumps and bifurcations of the nonlinear response around the operating speeds.
pub(super) fn jump(over: &OverSpeed, operating: Operating) -> Nearest {
    Nearest::of(over.jumps.iter().chain(&over.bifurcations).copied(), operating)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::Unstable;

    #[test]
    fn nearest_places_on_both_sides() {
        let unstable = |from, to| Unstable { from, to, open: (false, false), growth: 1.0, frequency: 10.0 };
        let over = OverSpeed { unstable: vec![unstable(10.0, 20.0), unstable(90.0, 100.0)], ..OverSpeed::default() };
        let of = |low, high| Operating { low, high };
        let n = instability(&over, of(40.0, 40.0));
        assert_eq!((n.below, n.above, n.margin(of(40.0, 40.0))), (Some(20.0), Some(90.0), Some(0.5)));
        assert_eq!(instability(&over, of(15.0, 15.0)).margin(of(15.0, 15.0)), Some(0.0));
        assert_eq!(instability(&OverSpeed::default(), of(15.0, 15.0)).margin(of(15.0, 15.0)), None);
        // of a range each side counts from its own end
        let n = instability(&over, of(25.0, 60.0));
        assert_eq!((n.margin(of(25.0, 60.0)), n.place(of(25.0, 60.0))), (Some(0.2), Some(20.0)));
        assert_eq!(instability(&over, of(25.0, 95.0)).margin(of(25.0, 95.0)), Some(0.0));
        assert_eq!(instability(&over, of(50.0, 75.0)).margin(of(50.0, 75.0)), Some(0.2));
    }
}
