//! Continua of states, assessed by samples: three and more equal masses balance in infinitely many ways, of which some may be stable.
//!
//! A continuum ends where it shrinks to one state, as that of three balls where their moments just suffice and all stand together. That state is isolated on the other
//! side, and the branch it lies on has as many roots at zero there as the continuum has directions and more: the end is located on the branch, not among the samples,
//! which grow scarce beside it.

use super::classify::{Class, Scale, Seen};
use crate::diagnostic::Diagnostic;
use crate::model::system::System;
use crate::solve::stationary::{Change, Found, Located, Loose, Search, Stability, State};
use crate::solve::unbalance::Unbalance;
use crate::study::shared::support::larger;
use crate::study::shared::validity::Uses;
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

/// Samples of one continuum at a speed.
const SAMPLES: usize = 24;
/// Halvings of the interval in which a continuum begins or ends, or becomes stable.
const HALVINGS: usize = 30;

/// One kind of continuum at a speed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Sheet {
    pub speed: f64,
    pub class: Class,
    /// Directions in which its states are free.
    pub free: usize,
    pub samples: usize,
    pub stable: usize,
    /// Largest growth rate of the sample that grows least, and of the one that grows most, 1/s; the roots at zero left out.
    pub growth: (f64, f64),
    /// Unbalance over that without the masses, of the sample with most; NaN where nothing is out of balance without.
    pub share: f64,
    /// Largest distance of a body from the axis, m.
    pub radius: f64,
    /// Unbalance of the sample with most.
    pub unbalance: Option<Unbalance>,
    /// Unknowns of the stable samples.
    pub places: Vec<Vec<f64>>,
    /// Use of the parts' validity by the samples.
    pub uses: Uses,
}

/// What holds of a continuum over a range of speeds.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Span {
    pub class: Class,
    pub free: usize,
    pub from: f64,
    pub to: f64,
    /// Some of its states are stable.
    pub stable: bool,
}

/// All continua.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Continua {
    pub sheets: Vec<Sheet>,
    /// Where they exist, and where some of their states are stable.
    pub spans: Vec<Span>,
    /// Starts that led to one.
    pub starts: usize,
}

/// Distance over the speed, on either side of where a branch changes, at which a continuum is sought beside it, and the angles by which masses are moved for that, rad.
const BESIDE: f64 = 1e-3;
const MOVED: [f64; 3] = [0.3, 0.1, 0.03];

/// A kind of continuum: class, directions in which its states are free, and whether only stable states count.
#[derive(Clone, Copy)]
struct Wanted {
    class: Class,
    free: usize,
    stable: bool,
}

impl Wanted {
    fn among(&self, list: &[Sheet], speed: f64) -> bool {
        list.iter().any(|s| s.speed == speed && (s.class, s.free) == (self.class, self.free) && (!self.stable || s.stable > 0))
    }

    /// Whether a state of it lies beside an isolated one at another speed.
    fn beside(&self, system: &System, search: &mut Search, state: &State, speed: f64) -> Result<bool, Diagnostic> {
        let angles = search.images().angles.clone();
        for (moved, side) in MOVED.iter().flat_map(|m| [(m, 1.0), (m, -1.0)]) {
            let mut x = state.x.clone();
            angles.iter().enumerate().for_each(|(k, &i)| x[i] += side * moved * (1.0 + 2.4 * k as f64).sin());
            let loose = Loose { speed, x, free: self.free };
            if self.among(&sheets(system, search, &[loose], speed)?, speed) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The end of it between a speed at which it is not and one at which it is, where that lies on a branch of isolated states.
    fn end(&self, system: &System, search: &mut Search, found: &Found, no: f64, yes: f64) -> Result<Option<f64>, Diagnostic> {
        let ends = |l: &&Located| l.located && !matches!(l.change, Change::Fold | Change::Hopf);
        let between = |l: &&Located| (l.state.speed - no) * (l.state.speed - yes) <= 0.0;
        let mut places: Vec<&Located> = found.paths.iter().flat_map(|p| &p.special).filter(ends).filter(between).collect();
        // where several roots vanish at once their product is flat: a root by itself is known better than the branch point
        places.sort_by_key(|l| l.change != Change::Real);
        for l in places {
            let w = l.state.speed;
            let aside = |to: f64| w + (to - w).signum() * (BESIDE * w.abs()).min(0.5 * (to - w).abs());
            if self.beside(system, search, &l.state, aside(yes))? && !self.beside(system, search, &l.state, aside(no))? {
                return Ok(Some(w));
            }
        }
        Ok(None)
    }
}

/// The continua at a speed, from the samples found at others.
fn sheets(system: &System, search: &mut Search, loose: &[Loose], speed: f64) -> Result<Vec<Sheet>, Diagnostic> {
    let scale = Scale::at(system, search, speed);
    let mut near: Vec<&Loose> = loose.iter().collect();
    near.sort_by_number(|a| (a.speed - speed).abs());
    let mut out: Vec<Sheet> = Vec::new();
    for start in near.into_iter().take(2 * SAMPLES) {
        let mut x = start.x.clone();
        let Some(free) = search.settle_freely(&mut x, speed).filter(|f| *f > 0) else { continue };
        let seen = Seen::of(system, search, &State { branch: 0, speed, x: x.clone(), error: 0.0 });
        let class = seen.class(&scale);
        let place = out.iter().position(|s| (s.class, s.free) == (class, free));
        if place.is_some_and(|k| out[k].samples >= SAMPLES) {
            continue;
        }
        let stability: Stability = search.stability(&x, speed)?.without(free);
        let (growth, stable) = (stability.growth(), usize::from(stability.growing == 0));
        let (share, radius, unbalance) = (seen.share().unwrap_or(f64::NAN), seen.radius(), seen.unbalance);
        match place {
            None => {
                let places = if stable > 0 { vec![x] } else { Vec::new() };
                let (growth, uses) = ((growth, growth), seen.uses);
                out.push(Sheet { speed, class, free, samples: 1, stable, growth, share, radius, unbalance, places, uses });
            }
            Some(k) => {
                let s = &mut out[k];
                s.samples += 1;
                s.stable += stable;
                s.growth = (if growth < s.growth.0 { growth } else { s.growth.0 }, larger(s.growth.1, growth));
                s.radius = larger(s.radius, radius);
                s.uses.join(&seen.uses);
                if stable > 0 {
                    s.places.push(x);
                }
                if share > s.share {
                    (s.share, s.unbalance) = (share, unbalance);
                }
            }
        }
    }
    out.sort_by_key(|s| (s.class, s.free));
    Ok(out)
}

/// Of the states that a search came upon, at these speeds.
///
/// # Errors
/// Eigenvalues that cannot be computed.
pub fn continua(
    system: &System,
    search: &mut Search,
    found: &Found,
    speeds: &[f64],
    goes_on: &mut dyn FnMut(u64) -> bool,
) -> Result<Continua, Diagnostic> {
    let loose = &found.loose;
    let mut out = Continua { starts: loose.len(), ..Continua::default() };
    if loose.is_empty() {
        return Ok(out);
    }
    let mut kinds: Vec<(Class, usize)> = Vec::new();
    let mut reached = Vec::new();
    for &speed in speeds {
        if !goes_on(SAMPLES as u64) {
            break;
        }
        let here = sheets(system, search, loose, speed)?;
        for s in &here {
            if !kinds.contains(&(s.class, s.free)) {
                kinds.push((s.class, s.free));
            }
        }
        reached.push(speed);
        out.sheets.extend(here);
    }
    kinds.sort();
    for (class, free) in kinds {
        for stable in [false, true] {
            let wanted = Wanted { class, free, stable };
            let mut from = None;
            for (k, &w) in reached.iter().enumerate() {
                let now = wanted.among(&out.sheets, w);
                let mut edge = |mut no: f64, mut yes: f64| -> Result<f64, Diagnostic> {
                    if let Some(end) = wanted.end(system, search, found, no, yes)? {
                        return Ok(end);
                    }
                    for _ in 0..HALVINGS {
                        let middle = 0.5 * (no + yes);
                        if !goes_on(SAMPLES as u64) {
                            break;
                        }
                        if wanted.among(&sheets(system, search, loose, middle)?, middle) { yes = middle } else { no = middle }
                    }
                    Ok(yes)
                };
                if now && from.is_none() {
                    from = Some(if k == 0 { w } else { edge(reached[k - 1], w)? });
                }
                if let Some(begin) = from
                    && (!now || k + 1 == reached.len())
                {
                    let to = if now { w } else { edge(w, reached[k - 1])? };
                    out.spans.push(Span { class, free, from: begin, to, stable });
                    from = None;
                }
            }
        }
    }
    Ok(out)
}
