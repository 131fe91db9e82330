//! Steady responses at the operating speed that a `nonlinear_response` of the file found.

use super::Facts;
use super::operating::Operating;
use crate::outcome::{Data, Outcome, Table};
use crate::study::Study;
use crate::study::nonlinear::nonlinear_response::NonlinearResponse;
use crate::study::shared::support::{larger, largest};

/// What is known at the operating speed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Steady {
    /// Steady responses there.
    pub states: usize,
    /// Those that are stable; none where stability was not assessed.
    pub stable: Option<usize>,
    /// Largest displacement of each body over the responses that a machine may be on, m.
    pub sizes: Vec<(String, f64)>,
    /// The same of the forces of parts, N.
    pub forces: Vec<(String, f64)>,
}

const LARGEST: &str = " largest displacement";

/// The steady responses at the operating speeds, the worst of each; none where no study covers them.
pub(super) fn steady(facts: &Facts, operating: Operating) -> Option<Steady> {
    let studies = facts.outcomes.iter().filter(|o| o.kind == NonlinearResponse::KIND);
    let of = |o: &Outcome| {
        let t = o.find_table("response")?;
        let ends = [operating.low, operating.high].map(|w| facts.sign * w);
        let between = floats(t, "speed")?.iter().copied().filter(|w| operating.contains(facts.sign * w));
        let all = ends.into_iter().map(|w| at(t, w)).collect::<Option<Vec<Steady>>>()?;
        let more = between.filter(|_| !operating.is_one()).filter_map(|w| at(t, w));
        all.into_iter().chain(more).reduce(Steady::worse)
    };
    studies.filter_map(of).max_by_key(|s| s.states)
}

impl Steady {
    /// The worse of two speeds in everything: a speed without stable response before one with several.
    fn worse(self, other: Steady) -> Steady {
        let stable = match (self.stable, other.stable) {
            (Some(0), _) | (_, Some(0)) => Some(0),
            (Some(a), Some(b)) => Some(a.max(b)),
            _ => None,
        };
        let larger_of = |mut a: Vec<(String, f64)>, b: Vec<(String, f64)>| {
            a.iter_mut().zip(b).for_each(|(a, b)| a.1 = larger(a.1, b.1));
            a
        };
        Steady {
            states: self.states.max(other.states),
            stable,
            sizes: larger_of(self.sizes, other.sizes),
            forces: larger_of(self.forces, other.forces),
        }
    }
}

fn floats<'t>(t: &'t Table, name: &str) -> Option<&'t [f64]> {
    match &t.column(name)?.data {
        Data::Float(v) => Some(v),
        _ => None,
    }
}

fn flags<'t>(t: &'t Table, name: &str) -> Option<&'t [bool]> {
    match &t.column(name)?.data {
        Data::Flag(v) => Some(v),
        _ => None,
    }
}

fn at(t: &Table, speed: f64) -> Option<Steady> {
    let speeds = floats(t, "speed")?;
    let Data::Int(branch) = &t.column("branch")?.data else { return None };
    let (stable, open) = (flags(t, "stable")?, flags(t, "not unstable")?);
    let mut out = Steady::default();
    // pieces of branches that pass the speed: first row, and the share of the second
    let pieces: Vec<(usize, f64)> = (1..speeds.len())
        .filter(|&k| branch[k] == branch[k - 1] && speeds[k] != speeds[k - 1])
        .map(|k| (k - 1, (speed - speeds[k - 1]) / (speeds[k] - speeds[k - 1])))
        .filter(|(k, x)| (0.0..1.0).contains(x) || *x == 1.0 && (k + 2 == speeds.len() || branch[k + 2] != branch[*k]))
        .collect();
    out.states = pieces.len();
    if pieces.is_empty() {
        return None;
    }
    let both = |flags: &[bool], k: usize| flags[k] && flags[k + 1];
    let known = pieces.iter().all(|(k, _)| both(stable, *k) || !open[*k] || !open[k + 1]);
    out.stable = known.then(|| pieces.iter().filter(|(k, _)| both(stable, *k)).count());
    // where no response is stable the amplitudes are those of motions that do not last
    let kept: Vec<(usize, f64)> = pieces.into_iter().filter(|(k, _)| both(open, *k)).collect();
    // a size that is no number stays none, and keeps no limit
    let size = |v: &[f64]| largest(kept.iter().map(|&(k, x)| v[k] + x * (v[k + 1] - v[k])));
    for c in t.columns() {
        let Data::Float(v) = &c.data else { continue };
        if let Some(body) = c.name.strip_suffix(LARGEST) {
            out.sizes.push((body.to_string(), size(v)));
        } else if c.unit == "N" && c.doc == "largest value over a period" {
            let part = c.name.strip_suffix(" force").unwrap_or(&c.name);
            out.forces.push((part.to_string(), size(v)));
        }
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(amplitude: Vec<f64>, stable: Vec<bool>) -> Table {
        let rows = amplitude.len();
        Table::new("response", "")
            .int("branch", "", "", vec![1; rows])
            .float("speed", "rad/s", "", (0..rows).map(|k| 10.0 * k as f64).collect())
            .float("disc largest displacement", "m", "", amplitude)
            .flag("stable", "", stable.clone())
            .flag("not unstable", "", stable)
            .build()
            .unwrap()
    }

    #[test]
    fn the_worse_of_two_speeds_counts() {
        let of = |stable: Option<usize>, size: f64| Steady {
            states: 1,
            stable,
            sizes: vec![("disc".into(), size)],
            forces: vec![("spring".into(), 2.0 * size)],
        };
        let both = |a: Option<usize>, b: Option<usize>| of(a, 1.0).worse(of(b, 3.0));
        assert_eq!((both(Some(0), Some(2)).stable, both(Some(2), Some(0)).stable, both(None, Some(0)).stable), (Some(0), Some(0), Some(0)));
        assert_eq!((both(Some(1), Some(2)).stable, both(None, Some(1)).stable), (Some(2), None));
        assert_eq!((both(None, None).sizes[0].1, both(None, None).forces[0].1), (3.0, 6.0));
        assert!(of(None, f64::NAN).worse(of(None, 1.0)).sizes[0].1.is_nan());
    }

    #[test]
    fn sizes_are_interpolated_and_what_is_no_number_stays_none() {
        let known = at(&table(vec![1.0, 2.0, 4.0], vec![true; 3]), 15.0).unwrap();
        assert_eq!((known.states, known.stable, known.sizes[0].1), (1, Some(1), 3.0));
        let unknown = at(&table(vec![1.0, 2.0, f64::NAN], vec![true; 3]), 15.0).unwrap();
        assert!(unknown.sizes[0].1.is_nan());
        assert_eq!(at(&table(vec![1.0, 2.0], vec![false; 2]), 5.0).unwrap().stable, Some(0));
        assert_eq!(at(&table(vec![1.0, 2.0], vec![true; 2]), 15.0), None);
    }
}
