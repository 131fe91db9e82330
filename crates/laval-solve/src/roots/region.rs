//! The rectangles in which roots are counted, and how short steps around them must be, by where the parts are analytic.

use super::LEAST;
use crate::model::part::Domain;
use crate::sectors::Sector;
use laval_num::complex::C64;
use laval_num::order::SortByNumber;

/// Half width, over the speed, of the band about a frequency where singularities accumulate in which roots close to the imaginary axis are not counted.
pub const ACCUMULATION: f64 = 0.08;
/// Width, over the speed, of what is added to the range of waves of a truncated series.
const ASIDE: f64 = 0.05;
/// Longest step over the distance of the poles beside the path: a zero on the other side of the path and a pole at that distance show in `f'/f` at the ends of any
/// step up to 2.6 times that distance.
pub const PAIR: f64 = 1.8;

/// A rectangle: range of growth and range of frequency.
pub(super) struct Piece {
    pub growth: (f64, f64),
    pub band: (f64, f64),
    /// Beside waves of a truncated series, at no less than the margin: their poles are not taken away, the steps see them.
    pub bare: bool,
}

/// Rectangles inside the domain.
pub(super) fn rectangles(
    domains: &[Domain],
    speed: f64,
    margin: f64,
    reach: f64,
    growing: bool,
    sector: Option<Sector>,
) -> (Vec<Piece>, f64) {
    let axial = sector == Some(Sector::Axial);
    let domains = if axial { &[] } else { domains };
    let (left, axis) = (domains.iter().all(|d| d.left), !domains.iter().any(Domain::touches_axis));
    let mirrored = sector != Some(Sector::Forward);
    let low = if mirrored { 0.0 } else { -reach };
    let least = LEAST * speed.abs();
    let margin = if axis { margin.max(if left { f64::NEG_INFINITY } else { 0.0 }) } else { margin.max(least) };
    let bottom = if axis && left && !growing { -reach } else { margin };
    let (waves, places) = (bands(domains, speed, true, mirrored), bands(domains, speed, false, mirrored));
    let mut out = Vec::new();
    if places.is_empty() {
        out.push(Piece { growth: (bottom, reach), band: (low, reach), bare: false });
    } else {
        // what grows or decays beside the waves does not depend on whether those on the axis can be distinguished
        for growth in [(bottom.max(least), reach), (bottom, -least)] {
            out.extend(pieces(&waves, (low, reach)).map(|(band, bare)| Piece { growth, band, bare }));
        }
        let slow = pieces(&places, (low, reach)).filter(|p| !p.1);
        out.extend(slow.map(|(band, bare)| Piece { growth: (bottom.max(-least), least), band, bare }));
    }
    if !axis && left && !growing {
        out.push(Piece { growth: (-reach, -margin), band: (low, reach), bare: false });
    }
    out.retain(|p| p.growth.1 > p.growth.0 && p.band.1 > p.band.0);
    (out, if places.is_empty() { margin } else { margin.max(least) })
}

/// A range of frequencies in pieces, with whether they lie in one of the bands.
fn pieces(bands: &[(f64, f64)], (low, high): (f64, f64)) -> impl Iterator<Item = ((f64, f64), bool)> {
    let mut ends = vec![low];
    ends.extend(bands.iter().flat_map(|b| [b.0, b.1]).map(|x| x.clamp(low, high)));
    ends.push(high);
    (1..ends.len()).map(move |k| ((ends[k - 1], ends[k]), k % 2 == 0))
}

/// Bands of frequencies beside the waves of truncated series: all of theirs (`beside`), where roots are counted at some distance from the axis and the poles need not be
/// taken away, which turns by half a circle for every wave; or those about the places where they accumulate, where slow roots are not counted.
fn bands(domains: &[Domain], speed: f64, beside: bool, mirrored: bool) -> Vec<(f64, f64)> {
    let (half, aside) = (ACCUMULATION * speed.abs(), ASIDE * speed.abs());
    let ranges = domains.iter().flat_map(|d| {
        let all = d.truncated.filter(|_| beside).map(|[a, b]| [a - aside, b + aside]);
        d.except.iter().map(move |e| all.unwrap_or([e - half, e + half]))
    });
    let ranges = ranges.map(|[a, b]| match mirrored {
        true if a < 0.0 && b > 0.0 => (0.0, b.max(-a)),
        true if b <= 0.0 => (-b, -a),
        _ => (a, b),
    });
    let mut ranges: Vec<(f64, f64)> = ranges.filter(|(a, b)| b > a).collect();
    ranges.sort_by_number(|a| a.0);
    let mut out: Vec<(f64, f64)> = Vec::new();
    for (a, b) in ranges {
        match out.last_mut() {
            Some(last) if a <= last.1 => last.1 = last.1.max(b),
            _ => out.push((a, b)),
        }
    }
    out
}

/// Longest step at a place: so short that no root hides beside a wave of a part on the other side of the path.
pub(super) fn step_limit(domains: &[Domain], speed: f64, s: C64, mirrored: bool, bare: bool) -> f64 {
    let mut limit = f64::INFINITY;
    // what takes the poles of waves away has one itself where they accumulate
    for e in domains.iter().flat_map(|d| &d.except).filter(|_| !bare) {
        let beside = if mirrored { (s.im - e).abs().min((s.im + e).abs()) } else { (s.im - e).abs() };
        limit = limit.min(0.5 * s.re.hypot(beside));
    }
    // with `regular` waves are no poles
    for d in domains.iter().filter(|d| bare || !(d.left && d.axis)) {
        let away = if d.left { s.re.abs() } else { (s.re + d.gap).abs() };
        let heights = [s.im, -s.im];
        let all = [f64::NEG_INFINITY, f64::INFINITY];
        let crowded = if bare && !d.except.is_empty() { Some(all) } else { d.crowded };
        for h in &heights[..if mirrored { 2 } else { 1 }] {
            if let Some([a, b]) = crowded {
                let outside = (a - h).max(h - b).max(0.0);
                limit = limit.min(PAIR * away.max(LEAST * speed.abs()).hypot(outside));
            }
            for w in &d.waves {
                limit = limit.min(0.5 * away.hypot(h - w));
            }
        }
    }
    limit
}
