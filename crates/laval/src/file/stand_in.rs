//! Values in place of those that could not be read. A file with mistakes is examined twice, with low and with high values: what is
//! wrong both times is wrong whatever the right values are.

use crate::diagnostic::Span;
use crate::model::field::{Attach, Bounds, Field, FieldKind, RangeValue, Value, Values};

/// Which of two values stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Low,
    High,
}

/// The place of a value that stands in: no mistake is reported there.
pub(super) const NOWHERE: Span = usize::MAX..usize::MAX;

/// Sets a value for each of the fields.
pub(super) fn complete<'a>(values: &mut Values, fields: impl Iterator<Item = &'a Field>, side: Side) {
    for f in fields {
        if let Some(v) = value(f.kind, side) {
            values.set(f.name, v, Some(NOWHERE));
        }
    }
}

/// An admissible number, small or large. A quantity whose least value is large itself, such as a modulus, has a large one above what is usual.
pub(super) fn number(b: &Bounds, side: Side) -> f64 {
    let x: f64 = match side {
        Side::Low => 1e-6,
        Side::High => (1e12 * b.min).max(1e6),
    };
    let x = x.min(b.max).max(b.min);
    if b.contains(x) { x } else { b.min + 1e-3 * (b.max - b.min).min(1.0) }
}

/// `None` for what refers to something else: there is nothing of which it could be said.
fn value(kind: FieldKind, side: Side) -> Option<Value> {
    let low = side == Side::Low;
    Some(match kind {
        FieldKind::Quantity { bounds, .. } => Value::Number(number(&bounds, side)),
        FieldKind::Lateral { bounds, .. } => Value::Lateral([number(&bounds, side); 2]),
        FieldKind::OneOf(list) => {
            let o = if low { list.first()? } else { list.last()? };
            Value::OneOf(o.0, number(&o.2, side))
        }
        FieldKind::Choice(words) => Value::Choice(if low { words.first()?.0 } else { words.last()?.0 }),
        FieldKind::Integer { min, max } => Value::Integer(if low { min } else { max }),
        FieldKind::IntegerOrAuto { max, .. } => {
            if low {
                Value::Auto
            } else {
                Value::Integer(max)
            }
        }
        FieldKind::Flag => Value::Flag(!low),
        FieldKind::Attach { .. } => Value::Attach(Attach::ground()),
        FieldKind::Between => Value::Between(Attach::ground(), Attach { body: None, position: 1.0 }),
        FieldKind::Range { bounds, .. } => {
            Value::Range(RangeValue { from: number(&bounds, Side::Low), to: number(&bounds, Side::High), points: None })
        }
        FieldKind::List { bounds, .. } => Value::List(vec![number(&bounds, side)]),
        FieldKind::Columns(list) => {
            Value::Columns(list.iter().filter(|c| c.2).map(|c| (c.0, if low { vec![0.0, 1e-3] } else { vec![1.0, 2.0] })).collect())
        }
        FieldKind::Named { bounds, .. } => Value::Number(number(&bounds, side)),
        FieldKind::StateMap => Value::StateMap(Vec::new()),
        FieldKind::Text
        | FieldKind::ParameterPath
        | FieldKind::ParameterRange
        | FieldKind::ParameterRanges
        | FieldKind::Coordinate
        | FieldKind::Study
        | FieldKind::Tolerances => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_in_is_admissible_and_differs() {
        for b in [Bounds::positive(1e15), Bounds::up_to(0.5), Bounds::within(1e24), Bounds::closed(50.0, 3000.0), Bounds::positive(1e-9)] {
            let (low, high) = (number(&b, Side::Low), number(&b, Side::High));
            assert!(b.contains(low) && b.contains(high), "{b:?}: {low}, {high}");
        }
        let modulus = Bounds::closed(1e5, 1e13);
        assert!(number(&modulus, Side::Low) < 1e9 && number(&modulus, Side::High) > 1e12);
        let open = Bounds { min: 1.0, max: 10.0, min_open: true };
        assert!(open.contains(number(&open, Side::Low)) && number(&open, Side::Low) < number(&open, Side::High));
    }
}
