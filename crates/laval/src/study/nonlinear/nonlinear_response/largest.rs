//! The largest displacement and force over all states that can be held.

use super::measuring::Measuring;
use super::shown::Shown;
use crate::solve::harmonic::branches::measure::Measure;
use crate::solve::harmonic::branches::peak::{Peak, Sense};
use crate::solve::harmonic::branches::response::{Request, Response};
use crate::study::shared::probes;
use laval_num::continuation::End;
use serde::{Deserialize, Serialize};

/// The largest displacement or tilt of a body.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Largest {
    /// Name of the body, or of a point of it.
    pub owner: String,
    /// At a computed point: size, m or rad.
    pub size: f64,
    /// Its speed, rad/s.
    pub speed: f64,
    /// Between computed points, where it falls on both sides.
    pub refined: Option<Peak>,
    /// It lies where a branch meets the end of the range of speeds.
    pub at_end: bool,
    /// Speed, rad/s, at which its branch was left inside the range: beyond it nothing is known.
    pub left: Option<f64>,
}

impl Largest {
    /// Size, m or rad, and speed, rad/s, as well as known.
    pub fn best(&self) -> (f64, f64) {
        self.refined.as_ref().map_or((self.size, self.speed), |p| (p.value, p.speed))
    }
}

/// A displacement or tilt that still rises where a branch was left, above all others of its kind: there is no largest one.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Rising {
    /// Index among the probes measured.
    pub probe: usize,
    /// Size, m or rad, at the last point.
    pub size: f64,
    /// Speed there, rad/s.
    pub speed: f64,
    /// Index of the branch.
    pub branch: usize,
}

/// The largest value at a computed point, and between points.
pub(super) struct Summit {
    pub(super) value: f64,
    /// Branch and point.
    pub(super) at: (usize, usize),
    pub(super) refined: Option<Peak>,
}

/// Of several peaks each that is as high as this share of the highest, at computed points, is refined: the highest may lie farther from a point.
const COMPETES: f64 = 0.9;

impl Measuring<'_> {
    /// The largest of values by branch and point; NaN where a state does not count. Its peak is refined, on request by corrections of its own.
    pub(super) fn summit(
        &mut self,
        response: &Response,
        request: &Request,
        measure: Measure,
        values: &[Vec<f64>],
        own: bool,
    ) -> Option<Summit> {
        let all = values.iter().enumerate().flat_map(|(b, v)| v.iter().enumerate().map(move |(i, v)| (*v, b, i)));
        let (value, b, i) = all.filter(|v| !v.0.is_nan()).max_by(|x, y| x.0.total_cmp(&y.0))?;
        let mut refined: Option<Peak> = None;
        if value > 0.0 {
            let first = (b, i);
            let mut tops = vec![first];
            for (b, v) in values.iter().enumerate() {
                let top = |i: &usize| v[*i] >= COMPETES * value && !(v[*i] < v[i - 1]) && !(v[*i] <= v[i + 1]);
                tops.extend((1..v.len().saturating_sub(1)).filter(top).map(|i| (b, i)).filter(|t| *t != first));
            }
            for top in tops {
                let found = if own {
                    self.confirmed(response, top, measure, Sense::Largest, request)
                } else {
                    self.refined(response, top, measure, Sense::Largest, request)
                };
                refined = [refined, found].into_iter().flatten().max_by(|x, y| x.value.total_cmp(&y.value));
            }
        }
        // a computed point, as at the end of the range, may lie above all peaks
        let refined = refined.filter(|p| p.value >= value * (1.0 - 1e-9));
        Some(Summit { value, at: (b, i), refined })
    }

    /// The largest value of a probe, of values by branch and point.
    fn largest_of(&mut self, response: &Response, request: &Request, k: usize, values: &[Vec<f64>], confirm: bool) -> Option<Largest> {
        let owner = probes::owner(&self.probes[k]);
        let s = self.summit(response, request, Measure::Probe(self.which[k]), values, confirm)?;
        let (branch, i) = (&response.branches[s.at.0], s.at.1);
        let left = (!matches!(branch.end, End::Reached | End::Closed)).then(|| branch.points.last().map(|p| p.speed)).flatten();
        let at_end = s.refined.is_none() && (i == 0 || i + 1 == branch.points.len() && left.is_none());
        Some(Largest { owner, size: s.value, speed: branch.points[i].speed, refined: s.refined, at_end, left })
    }

    /// Largest stable displacement of each point, or tilt of each body, and one that rises above all of them where a branch was left: what rises to such an end is
    /// no maximum.
    pub(super) fn peaks(&mut self, response: &Response, request: &Request, tilt: bool) -> (Vec<Largest>, Option<Rising>) {
        let mut rising: Option<Rising> = None;
        let own: Vec<usize> = (0..self.probes.len()).filter(|&k| self.probes[k].is_tilt() == tilt).collect();
        let mut values: Vec<Vec<Vec<f64>>> = vec![vec![]; own.len()];
        for (b, branch) in response.branches.iter().enumerate() {
            let left = !matches!(branch.end, End::Reached | End::Closed);
            for (&k, values) in own.iter().zip(&mut values) {
                let a = |i: usize| self.measured.sizes[b][i][k];
                let last = branch.points.len().saturating_sub(1);
                let foot = if left { (1..=last).rev().find(|&i| !(a(i) >= a(i - 1))).unwrap_or(0) } else { last };
                let mut own = vec![f64::NAN; branch.points.len()];
                for i in (0..branch.points.len()).filter(|&i| !branch.points[i].unstable()) {
                    if left && i >= foot && foot < last {
                        if rising.as_ref().is_none_or(|r| a(i) > r.size) {
                            rising = Some(Rising { probe: k, size: a(i), speed: branch.points[i].speed, branch: b });
                        }
                    } else {
                        own[i] = a(i);
                    }
                }
                values.push(own);
            }
        }
        let mut largest: Vec<Largest> = Vec::new();
        // index among these, and what it is the largest of
        let mut top: Option<(usize, usize)> = None;
        for (j, values) in values.iter().enumerate() {
            let Some(found) = self.largest_of(response, request, own[j], values, false) else { continue };
            if top.is_none_or(|t| found.best().0 > largest[t.0].best().0) {
                top = Some((largest.len(), j));
            }
            largest.push(found);
        }
        // the value that is reported first has evidence of its own
        if let Some((at, j)) = top.filter(|t| largest[t.0].refined.is_some())
            && let Some(confirmed) = self.largest_of(response, request, own[j], &values[j], true)
        {
            largest[at] = confirmed;
        }
        let most = largest.iter().map(|l| l.best().0).fold(f64::NEG_INFINITY, f64::max);
        let rising = rising.filter(|r| r.size > most);
        (largest, rising)
    }
}

impl Shown<'_> {
    /// It is the displacement of a body that only tilts.
    pub(super) fn only_tilts(&self, l: &Largest) -> bool {
        let own = self.measured.tilts.iter().find(|t| t.owner == l.owner);
        own.is_some_and(|t| l.best().0 <= probes::ROUNDING * t.best().0)
    }
}
