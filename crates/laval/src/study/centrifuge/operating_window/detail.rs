//! What binds in a requirement at a speed.

use crate::outcome::{Arg, Message};
use laval_num::text::Text;
use serde::{Deserialize, Serialize};

/// What binds in a requirement.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Detail {
    /// Nothing beside the requirement itself.
    #[default]
    Itself,
    /// The time of the separation.
    Time,
    /// A path of a particle that cannot be computed, and why.
    Path(String),
    /// A quantity with a limit.
    Limited {
        /// `displacement`, `velocity`, `tilt`, `force` or `moment`.
        #[serde(deserialize_with = "laval_num::text::one")]
        quantity: Text,
        /// The body, the point of a body or the part, as the file names it.
        of: String,
    },
    /// Largest distance of a centre of mass from the axis: of this body.
    CentreOfMass(String),
    /// Growth rate of the machine.
    Growth {
        /// State of the contents that decides: `before`, `after`, or `always` where both weigh the same.
        #[serde(deserialize_with = "laval_num::text::one")]
        contents: Text,
    },
    /// A mode close to an excitation.
    Mode {
        /// Its frequency, rad/s.
        frequency: f64,
        /// Order of the excitation.
        order: f64,
    },
    /// The swing of the cups close to an excitation of this order.
    Swing(f64),
    /// The way up and down as a whole.
    Passage,
    /// A displacement on the way up or down.
    Moved {
        /// The body or point of a body, as the file names it.
        of: String,
        /// The speed at that moment, rad/s.
        speed: f64,
    },
    /// Torque of the drive on the way up or down.
    Torque,
    /// The speed.
    Speed,
    /// The validity of a part.
    Model {
        /// The part.
        part: String,
        /// Its statement.
        #[serde(deserialize_with = "laval_num::text::one")]
        statement: Text,
    },
    /// The amplitude of an undamped machine at resonance.
    WithoutBound,
    /// There is no steady state.
    NoState,
}

impl Detail {
    /// The margin is not defined.
    pub(super) fn undefined(&self) -> bool {
        matches!(self, Detail::Path(_) | Detail::WithoutBound | Detail::NoState)
    }

    /// A cell of a table.
    pub(super) fn cell(&self) -> String {
        match self {
            Detail::Itself => String::new(),
            Detail::Time => "time".into(),
            Detail::Path(why) => why.clone(),
            Detail::Limited { quantity, of } => format!("{quantity} of {of}"),
            Detail::CentreOfMass(body) => format!("centre of mass of {body}"),
            Detail::Growth { contents: "always" } => "growth rate".into(),
            Detail::Growth { contents } => format!("growth rate {contents} the separation"),
            Detail::Mode { frequency, order } => format!("mode at {frequency:.4} rad/s, order {order}"),
            Detail::Swing(order) => format!("swing of the cups, order {order}"),
            Detail::Passage => "passage".into(),
            Detail::Moved { of, speed } => format!("displacement of {of} at {speed:.4} rad/s"),
            Detail::Torque => "torque".into(),
            Detail::Speed => "speed".into(),
            Detail::Model { part, statement } => format!("the model of {part} ({statement})"),
            Detail::WithoutBound => "amplitude without bound at an undamped resonance".into(),
            Detail::NoState => "no steady state".into(),
        }
    }

    /// What readers see in the place of the cell.
    pub(super) fn shown(&self) -> Arg {
        self.phrase().map_or_else(|| Arg::term(self.cell()), Arg::from)
    }

    /// A phrase; none where the requirement says it all.
    pub(super) fn phrase(&self) -> Option<Message> {
        Some(match self {
            Detail::Itself | Detail::Time | Detail::Passage | Detail::Speed => return None,
            Detail::Path(why) => Message::new("operating-window-path").arg("why", Arg::term(why)),
            Detail::Limited { quantity, of } => {
                Message::new("operating-window-limited").arg("quantity", Arg::word(quantity)).arg("of", Arg::name(of))
            }
            Detail::CentreOfMass(body) => Message::new("operating-window-centre-of-mass").arg("body", Arg::name(body)),
            Detail::Growth { contents } => Message::new("operating-window-growth-rate").arg("contents", Arg::word(contents)),
            Detail::Mode { frequency, order } => {
                Message::new("operating-window-mode").arg("frequency", Arg::frequency(*frequency)).arg("order", Arg::number(*order))
            }
            Detail::Swing(order) => Message::new("operating-window-swing").arg("order", Arg::number(*order)),
            Detail::Moved { of, speed } => Message::new("operating-window-moved").arg("of", Arg::name(of)).arg("speed", Arg::speed(*speed)),
            Detail::Torque => Message::new("operating-window-torque"),
            Detail::Model { part, statement } => {
                Message::new("operating-window-model").arg("part", Arg::name(part)).arg("statement", Arg::term(*statement))
            }
            Detail::WithoutBound => Message::new("operating-window-without-bound"),
            Detail::NoState => Message::new("operating-window-no-state"),
        })
    }
}
