//! The kinds of parts. This file is the registry: the only place that names them all.

pub mod balancer_ball;
pub mod bearing_cubic;
pub mod bearing_hertz;
pub mod bearing_journal;
pub mod bearing_linear;
pub mod bearing_rolling;
pub mod constant_force;
pub mod coupling;
pub mod damper;
pub mod disc;
pub mod film;
pub mod foundation;
pub mod gear;
pub mod liquid;
pub mod motor;
pub mod shaft;
pub mod shaft_lumped;
pub mod shaft_span;
pub mod shaft_viscoelastic;
pub mod speed_ratio;
pub mod spin_load;
pub mod squeeze_film;
pub mod stop;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::erased::Erased;
use crate::model::field::{FieldKind, KindInfo, ParamValues, Value, Values};
use crate::model::params::{Family, Parametric as _};
use crate::model::part::Part;
use std::sync::Arc;

/// A part built from its fields, with its parameters in slot order.
pub type Built = (Arc<dyn Erased>, Vec<f64>);

/// A kind of part: what may be said of it, and how it is built.
#[derive(Clone)]
pub struct PartKind {
    /// Fields and documentation.
    pub info: KindInfo,
    /// Builds one from its fields; says all that is wrong.
    pub build: fn(&Values, &mut Diagnostics) -> Option<Built>,
}

/// All kinds of parts.
pub fn registry() -> Vec<PartKind> {
    vec![
        kind::<disc::Disc>(),
        kind::<foundation::Foundation>(),
        kind::<damper::Damper>(),
        kind::<bearing_linear::BearingLinear>(),
        kind::<bearing_cubic::BearingCubic>(),
        kind::<bearing_hertz::BearingHertz>(),
        kind::<bearing_rolling::BearingRolling>(),
        kind::<bearing_journal::BearingJournal>(),
        kind::<squeeze_film::SqueezeFilm>(),
        kind::<shaft::Shaft>(),
        kind::<shaft_lumped::ShaftLumped>(),
        kind::<shaft_span::ShaftSpan>(),
        kind::<shaft_viscoelastic::ShaftViscoelastic>(),
        kind::<stop::Stop>(),
        kind::<liquid::Liquid>(),
        kind::<balancer_ball::BallBalancer>(),
        kind::<constant_force::ConstantForce>(),
        kind::<coupling::Coupling>(),
        kind::<speed_ratio::SpeedRatio>(),
        kind::<gear::Gear>(),
        kind::<motor::Motor>(),
        kind::<spin_load::SpinLoad>(),
    ]
}

/// The registry entry of a part.
pub fn kind<P: Part>() -> PartKind {
    let derived = |name: &str| P::FIELDS.iter().any(|f| matches!(f.kind, FieldKind::OneOf(options) if options.iter().any(|o| o.0 == name)));
    let fields = P::FIELDS.iter().chain(P::Family::FIELDS.iter().filter(|f| !derived(f.name))).copied().collect();
    let lists = P::Family::lists();
    PartKind { info: KindInfo { kind: P::KIND, doc: P::DOC, example: P::EXAMPLE, fields, lists }, build: build::<P> }
}

fn build<P: Part>(values: &Values, diagnostics: &mut Diagnostics) -> Option<Built> {
    let mut params = ParamValues::default();
    for slot in P::Family::slots() {
        if let Some(default) = slot.default {
            params.set(&slot.name, default);
        }
    }
    for field in P::Family::FIELDS {
        match values.get(field.name) {
            Some(Value::Number(x)) if matches!(field.kind, FieldKind::Quantity { .. }) => params.set(field.name, *x),
            Some(Value::Number(_) | Value::Lateral(_)) => {
                if let Some([x, y]) = values.lateral(field.name) {
                    params.set(&format!("{}.x", field.name), x);
                    params.set(&format!("{}.y", field.name), y);
                }
            }
            _ => {}
        }
    }
    let mut own = Diagnostics::default();
    let built = P::build(values, &mut params, &mut own);
    let sound = !own.has_errors();
    diagnostics.0.append(&mut own.0);
    let part = built?;
    let rows = part.row_counts();
    for (list, count) in P::Family::lists().iter().zip(rows) {
        let columns = values.columns(list.name);
        for (k, slot) in (0..count).flat_map(|k| list.slots.iter().map(move |s| (k, s))) {
            let name = list.path(k, &slot.name);
            let column =
                if list.bare { values.list(list.name) } else { columns.and_then(|c| c.get(slot.name.as_str())).map(Vec::as_slice) };
            let given = column.and_then(|c| c.get(k)).copied();
            if let (None, Some(x)) = (params.get(&name), given.or(slot.default)) {
                params.set(&name, x);
            }
        }
    }
    let vector: Vec<f64> = P::Family::all_slots(rows).iter().map(|s| params.get(&s.name).unwrap_or(f64::NAN)).collect();
    if sound && vector.iter().all(|x| x.is_finite()) {
        for (field, message) in part.check(&part.given(&vector)) {
            diagnostics.push(Diagnostic::error("part.check", message).at(values.span_of(field)));
        }
    }
    Some((part.erased(), vector))
}
