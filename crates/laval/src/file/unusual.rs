//! Values far outside what machines have: most often a slip of the pen or of a unit.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::field::{FieldKind, KindInfo, Values};
use crate::text;

/// What machines have, from the smallest to the largest: SI unit, keys it holds for (all where none is named), bounds of the size of a value that is not 0.
/// They are wide: what lies outside is wrong in all likelihood.
const USUAL: &[(&str, &[&str], f64, f64)] = &[
    // of a centre of mass, and of balancer rings; cavities may lie far off the shaft
    ("m", &["eccentricity"], 1e-10, 0.02),
    ("m", &[], 1e-9, 100.0),
    ("kg", &[], 1e-7, 1e7),
    ("kg m", &[], 1e-13, 100.0),
    ("kg m^2", &[], 1e-14, 1e9),
    ("kg/m^3", &[], 1e-3, 3e4),
    ("N/m", &[], 1e-4, 1e13),
    ("N m/rad", &[], 1e-7, 1e13),
    ("N s/m", &[], 1e-8, 1e10),
    ("N m s/rad", &[], 1e-10, 1e10),
    ("N m", &[], 1e-9, 1e9),
    ("Pa s", &[], 1e-7, 1e6),
    ("m^2/s", &[], 1e-10, 100.0),
    ("rad/s", &[], 1e-7, 1e5),
    ("Pa", &[], 1e-6, 1e13),
];

/// A key that admits more than this, m, places something off the shaft: no error of a centre of mass.
const OFF_SHAFT: f64 = 0.5;

fn usual(key: &str, unit: &str, admitted: f64) -> Option<(f64, f64)> {
    let holds = |keys: &[&str]| keys.is_empty() || keys.contains(&key) && !(admitted > OFF_SHAFT);
    USUAL.iter().find(|u| u.0 == unit && holds(u.1)).map(|u| (u.2, u.3))
}

/// Warns of values that a block of the machine was given and no machine has.
pub(super) fn check(info: &KindInfo, values: &Values, who: &str, out: &mut Diagnostics) {
    for field in &info.fields {
        if !values.written(field.name) {
            continue;
        }
        let admitted = match &field.kind {
            FieldKind::Quantity { bounds, .. } => bounds.max,
            _ => f64::INFINITY,
        };
        let given: Vec<(&str, f64)> = match field.kind {
            FieldKind::Quantity { unit, .. } => values.number(field.name).map(|x| (unit, x)).into_iter().collect(),
            FieldKind::Lateral { unit, .. } => values.lateral(field.name).into_iter().flatten().map(|x| (unit, x)).collect(),
            FieldKind::OneOf(list) => {
                let chosen = values.one_of(field.name).and_then(|(name, x)| Some((list.iter().find(|o| o.0 == name)?.1, x)));
                chosen.into_iter().collect()
            }
            _ => continue,
        };
        let wrong = given.into_iter().find_map(|(unit, x)| {
            let (least, most) = usual(field.name, unit, admitted)?;
            (x != 0.0 && !(least..=most).contains(&x.abs())).then_some((unit, x, if x.abs() > most { Err(most) } else { Ok(least) }))
        });
        let Some((unit, x, bound)) = wrong else { continue };
        let (name, value) = (field.name, text::quantity(x, unit.to_string()));
        let message = match bound {
            Ok(least) => text!(
                "{who}: {name} is {value}; no machine has less than {least}",
                who,
                name,
                value,
                least = text::quantity(least, unit.to_string())
            ),
            Err(most) => text!(
                "{who}: {name} is {value}; no machine has more than {most}",
                who,
                name,
                value,
                most = text::quantity(most, unit.to_string())
            ),
        };
        out.push(
            Diagnostic::warning("value.unusual", message)
                .at(values.span_of(field.name))
                .label(text!("far outside"))
                .help(text!("check the number and its unit; it is computed as it stands")),
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::file::load;
    use crate::language::Language;

    fn warnings(part: &str) -> Vec<String> {
        let file = format!(
            "[machine]\nname = \"m\"\nspeed = \"3000 rpm\"\n[[part]]\nkind = \"disc\"\nname = \"wheel\"\n{part}\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"wheel\", \"ground\"]\nstiffness = \"1e6 N/m\"\n[[study]]\nkind = \"modes\"\n"
        );
        let found = load(&file).unwrap_or_else(|d| panic!("{d}")).warnings;
        let shown = crate::file::render_in(Language::English, &found, &file, "f", crate::file::Form::Lines);
        shown.lines().filter(|l| l.contains("value.unusual")).map(str::to_string).collect()
    }

    #[test]
    fn values_that_no_machine_has_are_warned_of() {
        let far = warnings("mass = \"2 kg\"\neccentricity = \"400 mm\"");
        assert!(far.len() == 1 && far[0].contains("eccentricity is 400 mm; no machine has more than 20 mm"), "{far:?}");
        let light = warnings("mass = \"1e-9 kg\"");
        assert!(light.len() == 1 && light[0].contains("mass is 1e-9 kg; no machine has less than 1e-7 kg"), "{light:?}");
        assert_eq!(warnings("mass = \"2 kg\"\neccentricity = \"10 um\""), [""; 0]);
        // 0 means absent
        assert_eq!(warnings("mass = \"2 kg\"\neccentricity = 0"), [""; 0]);
    }

    /// What machines have lies inside what the program admits, or the warning could never be seen.
    #[test]
    fn every_bound_belongs_to_a_quantity() {
        for (unit, keys, least, most) in super::USUAL {
            assert!(crate::units::parse_unit(unit).is_ok() && 0.0 < *least && least < most, "{unit} {keys:?}");
        }
    }
}
