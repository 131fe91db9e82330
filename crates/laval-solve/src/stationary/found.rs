//! Request and result of a search for stationary states.

use super::images::Images;
use crate::exact::multiplicity;
use crate::pencil::{MachineMode, Spectrum};
use laval_num::complex::C64;
use laval_num::continuation::Branch;
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};

/// Estimated errors of a root by which its growth must stand out.
const ERRORS: f64 = 4.0;

/// What is sought.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Speeds, rad/s.
    pub range: (f64, f64),
    /// Starts at every one of the seed speeds.
    pub starts: usize,
    /// Speeds at which states are sought from scratch.
    pub seeds: Vec<f64>,
    /// Most points of one branch.
    pub max_points: usize,
    /// Most Newton runs and points of branches together.
    pub work: u64,
}

/// A state at a speed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Branch it lies on.
    pub branch: usize,
    /// Speed, rad/s.
    pub speed: f64,
    /// Coordinates at spin angle 0, then states that are not eliminated.
    pub x: Vec<f64>,
    /// Estimated error over the typical sizes.
    pub error: f64,
}

/// What small disturbances of a state do.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stability {
    /// Eigenvalues in turning axes with Im >= 0 and how many roots each stands for, in falling order of growth.
    pub values: Vec<(C64, usize)>,
    /// Number of growing roots.
    pub growing: usize,
    /// Growth that is rounding, 1/s.
    pub noise: f64,
}

impl Stability {
    pub(super) fn of(spectrum: &Spectrum) -> Self {
        let mut values: Vec<(C64, usize)> = spectrum.modes.iter().map(|m| (m.value, multiplicity(m))).collect();
        values.sort_by_number_down(|a| a.0.re);
        let noise = 1e-11 * values.iter().map(|v| v.0.abs()).fold(0.0, f64::max);
        // a growth that is not a number grows; one that its own condition drowns does not
        let grows = |m: &&MachineMode| !(m.value.re <= noise.max(ERRORS * m.error));
        let growing = spectrum.modes.iter().filter(grows).map(multiplicity).sum();
        Stability { values, growing, noise }
    }
    /// Without the roots at zero of a state that is free in so many directions.
    pub fn without(mut self, free: usize) -> Self {
        for _ in 0..free {
            let size = |v: &(C64, usize)| v.0.abs();
            let Some(k) = (0..self.values.len()).min_by(|&a, &b| size(&self.values[a]).total_cmp(&size(&self.values[b]))) else { break };
            let (root, count) = self.values[k];
            self.growing -= usize::from(!(root.re <= self.noise));
            if count > 1 {
                self.values[k].1 -= 1;
            } else {
                self.values.remove(k);
            }
        }
        self
    }
    /// Largest growth rate, 1/s.
    pub fn growth(&self) -> f64 {
        self.values.first().map_or(f64::NAN, |v| v.0.re)
    }
    /// The root of this rank, counted from the one that grows most.
    pub(super) fn ranked(&self, rank: usize) -> Option<C64> {
        let mut seen = 0;
        self.values
            .iter()
            .find(|v| {
                seen += v.1;
                seen > rank
            })
            .map(|v| v.0)
    }
}

/// What happens at a special point of a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Change {
    /// The branch turns back: two states meet and vanish.
    Fold,
    /// Another branch crosses.
    BranchPoint,
    /// A pair of complex roots crosses the imaginary axis: the state begins or ceases to oscillate by itself.
    Hopf,
    /// A real root crosses zero.
    Real,
}

impl Change {
    /// The word in tables.
    pub fn word(self) -> &'static str {
        match self {
            Change::Fold => "fold",
            Change::BranchPoint => "branch_point",
            Change::Hopf => "hopf",
            Change::Real => "real_root",
        }
    }
}

/// A located special point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Located {
    /// Arclength along the branch.
    pub s: f64,
    /// What it is.
    pub change: Change,
    /// The state there.
    pub state: State,
    /// Frequency of the root that crosses, rad/s, in turning axes.
    pub frequency: f64,
    /// Speeds around it.
    pub bracket: (f64, f64),
    /// Growing roots before and behind it along the branch.
    pub growing: (usize, usize),
    /// Both sides were distinguished to rounding.
    pub located: bool,
}

/// A point of a branch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sample {
    /// Arclength, in typical sizes.
    pub s: f64,
    /// The state.
    pub state: State,
    /// What small disturbances do.
    pub stability: Stability,
}

/// A branch of states.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Path {
    /// As followed.
    pub branch: Branch,
    /// Its points, and others between them where the growth rate bends.
    pub points: Vec<Sample>,
    /// Special points in order along the branch.
    pub special: Vec<Located>,
}

/// A state that is not isolated: one of a continuum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Loose {
    /// Speed, rad/s.
    pub speed: f64,
    /// Coordinates at spin angle 0, then states that are not eliminated.
    pub x: Vec<f64>,
    /// In how many directions it is free.
    pub free: usize,
}

/// How far a search is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    /// Newton runs and points of branches together.
    pub work: u64,
    /// Of the whole.
    pub done: u64,
    /// The whole.
    pub total: u64,
}

/// All that was found.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Found {
    /// Branches.
    pub paths: Vec<Path>,
    /// What counts as the same state.
    pub images: Images,
    /// Newton runs from scratch, those that led to a state, and those that led to a state known before.
    pub starts: [u64; 3],
    /// States that are not isolated, as they were come upon.
    pub loose: Vec<Loose>,
    /// More branches were there than are followed.
    pub crowded: bool,
    /// Stopped before the end.
    pub stopped: bool,
    /// Work: Newton runs and points.
    pub work: u64,
}
