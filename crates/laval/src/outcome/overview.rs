//! The answer in short: whether the machine may run at its speed, how far trouble is, what it does over the speed. All of it data; `report` words and draws it.

use super::message::{Arg, Message};

/// The first page of a report.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overview {
    /// Operating speed, rad/s.
    pub operating: Option<f64>,
    /// First and last operating speed, where there is a range of them, rad/s.
    pub operating_range: Option<(f64, f64)>,
    /// How the headline is to be taken.
    pub verdict: Verdict,
    /// One or two sentences: the answer.
    pub headline: Vec<Message>,
    /// Up to three remarks, each with a heading: at the operating speed, on the way to it, above it.
    pub remarks: Vec<(Message, Vec<Message>)>,
    /// Requirements and how they are met.
    pub checks: Vec<Check>,
    /// Behaviour over the spin speed.
    pub over_speed: Option<OverSpeed>,
    /// Modes at the operating speed.
    pub modes: Vec<Mode>,
    /// Bodies and what joins them.
    pub machine: Vec<Block>,
    /// The axis of the machine lies.
    pub horizontal: bool,
    /// What to do next.
    pub next: Vec<Message>,
    /// What the page does not take into account.
    pub left_out: Vec<Message>,
}

/// How a check ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// The requirement is met.
    Passed,
    /// Nothing is required.
    NoLimit,
    /// It needs a study that the file does not have, or that takes long.
    #[default]
    NotComputed,
    /// It needs attention, or is not proven.
    Attention,
    /// The requirement is not met.
    Failed,
}

impl Verdict {
    /// The machine-readable word.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Passed => "passed",
            Verdict::NoLimit => "no_limit",
            Verdict::NotComputed => "not_computed",
            Verdict::Attention => "attention",
            Verdict::Failed => "failed",
        }
    }
}

/// One requirement.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Its name in the catalogues: `check-stability`.
    pub what: Message,
    /// What was found.
    pub result: Message,
    /// What supports or explains it, in small print.
    pub detail: Option<Message>,
    /// The required value; none where no limit is set.
    pub required: Option<Arg>,
    /// How it ended.
    pub verdict: Verdict,
    /// A number in place of the word of the verdict: a margin.
    pub margin: Option<f64>,
}

impl Check {
    /// A check without detail, requirement or margin.
    pub fn new(what: &str, result: Message, verdict: Verdict) -> Self {
        Check { what: Message::new(what), result, detail: None, required: None, verdict, margin: None }
    }
}

/// Behaviour over the spin speed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OverSpeed {
    /// Range computed, rad/s.
    pub range: (f64, f64),
    /// Range shown: without the lowest speeds where nothing happens.
    pub shown: (f64, f64),
    /// Ranges in which the machine is unstable.
    pub unstable: Vec<Unstable>,
    /// Ranges in which a study of the nonlinear response found no stable motion, beside those, rad/s.
    pub unstable_response: Vec<(f64, f64)>,
    /// Resonances of the unbalance response, or lightly damped critical speeds where nothing forces the machine, rad/s.
    pub resonances: Vec<Resonance>,
    /// Those among them without a required margin: a forced response of the file assessed by API 684 has amplification factors below 2.5 there, rad/s.
    pub critically_damped: Vec<f64>,
    /// Speeds at which a slow sweep jumps, rad/s.
    pub jumps: Vec<f64>,
    /// Speeds at which the nonlinear response gains or loses its stability away from jumps, rad/s.
    pub bifurcations: Vec<f64>,
    /// Speeds of the growth rates, rad/s.
    pub growth_speed: Vec<f64>,
    /// Largest growth rate at each, 1/s.
    pub growth: Vec<f64>,
    /// First and last speed up to which stability was examined without a gap, rad/s.
    pub examined: Option<(f64, f64)>,
    /// Growth above which the machine counts as unstable, 1/s.
    pub threshold: f64,
    /// Speeds of the amplitudes, rad/s.
    pub response_speed: Vec<f64>,
    /// Amplitude of each body at each speed, m, where it moves most: its name or that of the point.
    pub amplitudes: Vec<(Arg, Vec<f64>)>,
}

/// A range of speeds in which the machine is unstable.
#[derive(Clone, Debug, PartialEq)]
pub struct Unstable {
    /// First speed, rad/s; where it is open below, the first speed examined.
    pub from: f64,
    /// Last speed, rad/s; where it is open above, the last speed examined.
    pub to: f64,
    /// The machine is still unstable at the first and at the last speed examined, so that the range has no known end there.
    pub open: (bool, bool),
    /// Largest growth rate in it, 1/s.
    pub growth: f64,
    /// Frequency of the whirl that grows, rad/s.
    pub frequency: f64,
}

impl Unstable {
    /// Some of these operating speeds lie in it, as far as it was examined.
    pub fn holds(&self, low: f64, high: f64) -> bool {
        self.from <= high && (low <= self.to || self.open.1)
    }

    /// It ends below this speed.
    pub fn ends_below(&self, speed: f64) -> bool {
        self.to < speed && !self.open.1
    }
}

/// A resonance.
#[derive(Clone, Debug, PartialEq)]
pub struct Resonance {
    /// Spin speed, rad/s.
    pub speed: f64,
    /// Body or point of a body that moves most there, and its amplitude, m; infinite without damping. None where nothing forces the machine.
    pub amplitude: Option<(Arg, f64)>,
}

/// A mode at the operating speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Growth rate, 1/s.
    pub growth: f64,
    /// It grows faster than the threshold of the study; slower growth is not resolved.
    pub grows: bool,
    /// Frequency, rad/s.
    pub frequency: f64,
    /// `forward`, `backward`, `mixed` or `none`.
    pub whirl: &'static str,
    /// Bodies with the semi-axes of their orbits, as shares of the largest, the minor one negative where the body goes round against the machine; of those that hardly
    /// move none.
    pub orbits: Vec<(String, f64, f64)>,
    /// The angle of each longer semi-axis from x, rad.
    pub angles: Vec<f64>,
}

/// A body of the drawing, or what joins two.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A body.
    Body {
        /// Its name.
        name: String,
        /// It turns.
        rotor: bool,
        /// It bends: a shaft that carries others.
        flexible: bool,
        /// Values of it that a reader looks for.
        labels: Vec<Arg>,
        /// It has a support of its own to the ground: a spring, a damper.
        grounded: Joint,
        /// Radius of a cavity, radius of the free surface, height, m.
        cavity: Option<(f64, f64, f64)>,
        /// Of a body that bends: first and last position of each piece and the outer diameters there, m.
        profile: Vec<[f64; 4]>,
        /// Place of its reference point along the axis, m; of a machine that gives no distances, in steps.
        place: f64,
        /// From the axis of the first body to its own, across, m.
        axis: [f64; 2],
    },
    /// Two wheels in mesh on parallel axes.
    Wheels {
        /// Name of the part.
        name: String,
        /// Bodies that carry them, and at which heights, m.
        ends: [(String, f64); 2],
        /// Pitch radii, m.
        radii: [f64; 2],
        /// Values of it.
        labels: Vec<Arg>,
    },
    /// A part between two bodies, or a body and the ground (`None`).
    Link {
        /// Its name.
        name: String,
        /// Its kind.
        kind: &'static str,
        /// What it joins, and at which heights, m.
        ends: [Option<(String, f64)>; 2],
        /// Values of it.
        labels: Vec<Arg>,
        /// What it is made of.
        joint: Joint,
    },
    /// The liquid in the cavity of a body.
    Liquid {
        /// Name of the part.
        name: String,
        /// Body that holds it.
        body: String,
        /// Share of the cavity that it fills.
        fill: f64,
        /// Density, kg/m^3.
        density: f64,
    },
    /// Masses that move in a body.
    Balls {
        /// Name of the part.
        name: String,
        /// Body that carries them.
        body: String,
        /// How many there are, in how many tracks.
        count: usize,
        /// Tracks.
        tracks: usize,
        /// Values of it.
        labels: Vec<Arg>,
    },
}

/// What joins two bodies, as it is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Joint {
    /// A spring.
    pub elastic: bool,
    /// A damper.
    pub damped: bool,
    /// A gap that is open.
    pub gap: bool,
}
