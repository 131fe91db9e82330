//! One sample: what a machine's study says in numbers, under names that are the same in every sample.

use crate::diagnostic::Diagnostic;
use crate::outcome::{End, Level, Outcome};
use crate::study::{Context, ErasedStudy};
use crate::units::parse_unit;
use laval_num::order::SortByNumber;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value as Json, json};

/// A number of an outcome.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantity {
    /// Id and subject of the finding, or kind of the special point, and which of several of that name in rising order.
    pub label: String,
    /// The number, SI.
    pub value: f64,
    /// Its unit.
    pub unit: String,
}

/// What one sample gave.
#[derive(Clone, Debug, PartialEq)]
pub enum Sample {
    /// Numbers, and whether one of them lies outside the validity of a model.
    Found(Vec<Quantity>, bool),
    /// No machine or no result, and why.
    Failed(String),
    /// Stopped by the user.
    Stopped,
}

fn label(id: &str, subject: &str) -> String {
    if subject.is_empty() { id.to_string() } else { format!("{id} {subject}") }
}

/// The numbers of an outcome. Several of one name are distinguished by their order: numbers of findings by value, special points by place.
pub fn quantities(outcome: &Outcome) -> Vec<Quantity> {
    let mut all: Vec<Quantity> = Vec::new();
    for f in &outcome.findings {
        let Some(value) = f.value else { continue };
        all.push(Quantity { label: label(&f.id, &f.subject), value, unit: f.unit.clone() });
    }
    let unit = outcome.parameter.as_ref().map_or(String::new(), |p| p.unit.clone());
    // points that a finding speaks of are there already
    for p in outcome.special_points.iter().filter(|p| !outcome.findings.iter().any(|f| f.id == p.kind)) {
        all.push(Quantity { label: label(&p.kind, &p.subject), value: p.at, unit: unit.clone() });
    }
    let labels: Vec<String> = all.iter().map(|q| q.label.clone()).collect();
    let mut out = all.clone();
    for (i, label) in labels.iter().enumerate() {
        let mut same: Vec<usize> = (0..all.len()).filter(|&j| labels[j] == *label).collect();
        let place = same.iter().position(|&j| j == i).unwrap_or(0);
        same.sort_by_number(|&a| all[a].value);
        let q = &all[same[place]];
        out[i] = Quantity { label: if place == 0 { label.clone() } else { format!("{label} #{}", place + 1) }, ..q.clone() };
    }
    out
}

/// Units of numbers that a place, such as a speed, is the place of.
const SIZES: [&str; 6] = ["m", "m/s", "rad", "N", "N m", "W"];

/// The numbers of an outcome, and of findings whose value is a speed or frequency what they have there, such as `largest_resonance.amplitude`.
pub fn with_sizes(outcome: &Outcome) -> Vec<Quantity> {
    let mut all = quantities(outcome);
    for f in outcome.findings.iter().filter(|f| f.value.is_some() && f.unit == "rad/s") {
        for e in f.evidence.iter().filter(|e| SIZES.contains(&e.unit.as_str())) {
            all.push(Quantity { label: format!("{}.{}", label(&f.id, &f.subject), e.what), value: e.value, unit: e.unit.clone() });
        }
    }
    all
}

/// Runs the study on one machine; `numbers` are those of its outcome that are wanted.
pub fn sample(
    study: &dyn ErasedStudy,
    machine: Result<crate::model::system::System, Diagnostic>,
    context: &Context,
    numbers: fn(&Outcome) -> Vec<Quantity>,
) -> Sample {
    let said = |d: Diagnostic| Sample::Failed(format!("{}: {}", d.code, d.message));
    let machine = match machine {
        Ok(machine) => machine,
        Err(d) => return said(d),
    };
    match study.run(&machine, context) {
        Err(d) => said(d),
        Ok(o) if o.end == End::Cancelled => Sample::Stopped,
        // what it has found is not what it would have found
        Ok(o) if !o.end.is_complete() => Sample::Failed(format!("{}: {}", o.end.word(), o.end_in_words())),
        Ok(o) => Sample::Found(numbers(&o), o.findings.iter().any(|f| f.level == Level::Invalid)),
    }
}

/// Quantities as a text that reads back to the same numbers.
pub fn encode(list: &[Quantity]) -> String {
    let object: Map<String, Json> = list.iter().map(|q| (q.label.clone(), json!([q.value, q.unit]))).collect();
    Json::Object(object).to_string()
}

/// See [`encode`].
pub fn decode(text: &str) -> Vec<Quantity> {
    let Ok(Json::Object(object)) = serde_json::from_str(text) else { return Vec::new() };
    let one = |(label, v): (String, Json)| Some(Quantity { value: v.get(0)?.as_f64()?, unit: v.get(1)?.as_str()?.to_string(), label });
    object.into_iter().filter_map(one).collect()
}

/// A message without its numbers, and with the SI units of the quantities it names, so that the same cause at different values is one cause.
pub fn cause(message: &str) -> String {
    let mut after_number = false;
    let word = |word: &str| {
        let core = word.trim_matches(|c: char| c.is_whitespace() || matches!(c, '(' | ')' | ',' | ';' | ':' | '"' | '.'));
        let number = core.parse::<f64>().is_ok() && core.contains(|c: char| c.is_ascii_digit());
        let unit = parse_unit(core).ok().filter(|_| after_number && !WORDS.contains(&core));
        after_number = number;
        match unit {
            _ if number => word.replacen(core, "..", 1),
            Some(unit) => word.replacen(core, &unit.dimension.si_text(), 1),
            None => word.to_string(),
        }
    };
    message.split_inclusive(char::is_whitespace).map(word).collect()
}

/// Words of a sentence that are units, too.
const WORDS: [&str; 2] = ["in", "at"];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Finding, SpecialPoint};

    #[test]
    fn names_do_not_depend_on_the_order_of_findings() {
        let f = |value, of: &str| Finding::info("peak", "").of(of).value(value, "m");
        let fold = |at| SpecialPoint::new("fold", at, (at, at));
        let outcome = |findings: Vec<Finding>, folds: [f64; 2]| {
            let mut o = Outcome::new("k", "n").over("speed", "rad/s").special_point(SpecialPoint::new("peak", 1.0, (1.0, 1.0)));
            o.findings = findings;
            o.special_points.extend(folds.map(fold));
            let mut q: Vec<(String, f64, String)> = quantities(&o).into_iter().map(|q| (q.label, q.value, q.unit)).collect();
            q.sort_by(|a, b| a.0.cmp(&b.0));
            q
        };
        let a = outcome(vec![f(2.0, "drum"), f(5.0, "base"), f(1.0, "drum")], [7.0, 6.0]);
        let b = outcome(vec![f(1.0, "drum"), f(2.0, "drum"), f(5.0, "base"), Finding::info("x", "")], [6.0, 7.0]);
        assert_eq!(a, b);
        let names: Vec<(&str, f64)> = a.iter().map(|q| (q.0.as_str(), q.1)).collect();
        assert_eq!(names, [("fold", 6.0), ("fold #2", 7.0), ("peak base", 5.0), ("peak drum", 1.0), ("peak drum #2", 2.0)]);
        // points say whose they are
        let peaks = [SpecialPoint::new("maximum", 3.0, (3.0, 3.0)).of("base"), SpecialPoint::new("maximum", 1.0, (1.0, 1.0)).of("drum")];
        let o = peaks.into_iter().fold(Outcome::new("k", "n").over("speed", "rad/s"), Outcome::special_point);
        assert_eq!(quantities(&o).iter().map(|q| q.label.as_str()).collect::<Vec<_>>(), ["maximum base", "maximum drum"]);
    }

    /// A speed is named as one, and its amplitude can be.
    #[test]
    fn the_amplitude_of_a_speed() {
        let peak =
            Finding::info("largest_resonance", "").value(400.0, "rad/s").evidence("amplitude", 2e-4, "m").evidence("residual", 1e-12, "");
        let mut o = Outcome::new("k", "n").over("speed", "rad/s");
        o.findings = vec![peak, Finding::info("force", "").value(3.0, "N").evidence("error", 1e-3, "N")];
        let names: Vec<(String, f64)> = with_sizes(&o).into_iter().map(|q| (q.label, q.value)).collect();
        let want = [("largest_resonance", 400.0), ("force", 3.0), ("largest_resonance.amplitude", 2e-4)];
        assert_eq!(names, want.map(|(n, v)| (n.to_string(), v)));
    }

    #[test]
    fn text_and_back_to_the_last_bit() {
        let q = vec![
            Quantity { label: "a \"b\"".into(), value: 0.1 + 0.2, unit: "N/m".into() },
            Quantity { label: "c".into(), value: -5e-324, unit: String::new() },
        ];
        assert_eq!(decode(&encode(&q)), q);
    }

    #[test]
    fn one_cause_whatever_the_number() {
        assert_eq!(cause("\"drum\": mass = -0.25 kg is not admissible"), "\"drum\": mass = .. kg is not admissible");
        assert_eq!(cause("no rest at 1e3 rad/s (3, 4)."), "no rest at .. rad/s (.., ..).");
        assert_eq!(cause("mass is -25 g; it must be above 0"), cause("mass is -2 kg; it must be above 0"));
        assert_eq!(cause("stopped at 3\nof 7 mm"), "stopped at ..\nof .. m");
        assert_eq!(cause("order-2 of \"disc-2\""), "order-2 of \"disc-2\"");
    }
}
