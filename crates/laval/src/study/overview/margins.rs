//! Distances of the operating speed from instability and resonance.

use crate::outcome::{OverSpeed, Resonance, Unstable};

/// The nearest trouble on both sides of a speed.
pub(super) struct Nearest {
    /// The nearest below, rad/s.
    pub below: Option<f64>,
    /// The nearest above.
    pub above: Option<f64>,
}

impl Nearest {
    /// Of places along the speed.
    pub fn of(places: impl IntoIterator<Item = f64>, speed: f64) -> Nearest {
        let mut out = Nearest { below: None, above: None };
        for p in places {
            if p <= speed {
                out.below = Some(out.below.map_or(p, |b: f64| b.max(p)));
            } else {
                out.above = Some(out.above.map_or(p, |a: f64| a.min(p)));
            }
        }
        out
    }

    /// The smaller distance over the speed; none where there is nothing.
    pub fn margin(&self, speed: f64) -> Option<f64> {
        let one = |p: f64| (p - speed).abs() / speed.abs();
        let all = self.below.into_iter().chain(self.above).map(one);
        all.reduce(f64::min)
    }
}

/// Edges of the unstable ranges around a speed; the speed itself where it lies in one.
pub(super) fn instability(over: &OverSpeed, speed: f64) -> Nearest {
    let inside = over.unstable.iter().any(|u| (u.from..=u.to).contains(&speed));
    let place = |u: &Unstable| if u.to < speed { u.to } else { u.from };
    Nearest::of(over.unstable.iter().map(place).chain(inside.then_some(speed)), speed)
}

/// Resonances around a speed.
pub(super) fn resonance(over: &OverSpeed, speed: f64) -> Nearest {
    Nearest::of(over.resonances.iter().map(|r: &Resonance| r.speed), speed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_places_on_both_sides() {
        let unstable = |from, to| Unstable { from, to, open: (false, false), growth: 1.0, frequency: 10.0 };
        let over = OverSpeed { unstable: vec![unstable(10.0, 20.0), unstable(90.0, 100.0)], ..OverSpeed::default() };
        let n = instability(&over, 40.0);
        assert_eq!((n.below, n.above, n.margin(40.0)), (Some(20.0), Some(90.0), Some(0.5)));
        assert_eq!(instability(&over, 15.0).margin(15.0), Some(0.0));
        assert_eq!(instability(&OverSpeed::default(), 15.0).margin(15.0), None);
    }
}
