//! What is not carried over, and what ROSS does differently: one sentence for all elements that it holds for.

use crate::text;
use crate::text::{Arg, Joint, Text};

/// Elements named in a sentence; the others are counted.
const NAMED: usize = 3;

/// A remark on elements of the model.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Note {
    /// Keys without a place here.
    LeftOut(Vec<&'static str>),
    /// Keys that no element of this kind has.
    NotRead(Vec<String>),
    NoTeeth,
    MeanMass,
    /// A table over speed and frequency.
    Diagonal,
    OverFrequency,
    Computed,
    Seal,
    /// A layer of the shaft.
    Layer,
    /// A layer that is a disc.
    MassAlone,
    NoLateral,
}

/// Notes with the elements they hold for, in the order in which they came.
#[derive(Clone, Debug, Default)]
pub(super) struct Notes {
    of: Vec<(Note, Vec<String>)>,
    whole: Vec<Text>,
}

impl Notes {
    pub fn add(&mut self, note: Note, element: &str) {
        match self.of.iter_mut().find(|o| o.0 == note) {
            Some((_, elements)) => elements.push(element.to_string()),
            None => self.of.push((note, vec![element.to_string()])),
        }
    }
    /// Adds a remark on the whole model.
    pub fn say(&mut self, text: Text) {
        self.whole.push(text);
    }
    pub fn texts(self) -> Vec<Text> {
        let of = self.of.into_iter().map(|(note, elements)| said(&note, names(&elements)));
        of.chain(self.whole).collect()
    }
}

fn names(elements: &[String]) -> Arg {
    let some = |n: usize| text::list(elements[..n].iter().map(text::quoted), Joint::Comma);
    match elements.len() {
        n if n <= NAMED + 1 => some(n),
        n => Arg::Text(text!("{names} and {n} more", names = some(NAMED), n = n - NAMED)),
    }
}

fn said(note: &Note, elements: Arg) -> Text {
    match note {
        Note::LeftOut(keys) => {
            let keys = text::list(keys.iter().map(|k| Arg::Plain((*k).into())), Joint::Comma);
            text!("{elements}: {keys} left out", elements, keys)
        }
        Note::NotRead(keys) => {
            let keys = text::list(keys.iter().map(text::quoted), Joint::Comma);
            text!("{elements}: not read, as no element of this kind has such a key: {keys}", elements, keys)
        }
        Note::NoTeeth => text!("{elements}: a disc without teeth", elements),
        Note::MeanMass => text!("{elements}: the mean of mx and my is taken", elements),
        Note::Diagonal => text!("{elements}: of the coefficients over speed and frequency those at frequency = speed are taken", elements),
        Note::OverFrequency => text!("{elements}: coefficients over frequency are taken over speed", elements),
        Note::Computed => text!("{elements}: the coefficients are those in the file, the geometry is left out", elements),
        Note::Seal => text!("{elements}: in effect in all studies; ROSS leaves seals out of run_static", elements),
        Note::Layer => text!("{elements}: a layer of the shaft, with one shear angle; ROSS gives every layer its own", elements),
        Note::MassAlone => text!("{elements}: the mass is carried over as a disc, the stiffness is left out", elements),
        Note::NoLateral => text!("{elements}: left out, there are no lateral coefficients", elements),
    }
}
