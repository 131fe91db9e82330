//! Every study can be made from its fields in Rust, and is then the one of a file.

use super::pages::{BESIDE, beside};
use laval::file::docs;
use laval::prelude::*;
use laval::study::{Study, registry};
use serde_json::{Value, json};

/// The fields of the typical example of a kind, and a machine for it.
fn example(kind: &str) -> (Loaded, Value) {
    let catalog = laval::file::catalog();
    let info = catalog.studies.iter().find(|k| k.kind == kind).unwrap();
    let block = docs::example("study", info);
    let loaded = load(&format!("{BESIDE}{}{block}", beside("study", kind))).unwrap_or_else(|d| panic!("{kind}: {d}"));
    let read: Value = toml::from_str(&block).unwrap();
    let mut fields = read["study"][0].clone();
    fields.as_object_mut().unwrap().remove("name");
    (loaded, fields)
}

/// Steps after which a study of the test below ends.
const STEPS: u64 = 3000;

macro_rules! studies {
    ($($study:ident)*) => {
        /// Constructs the study of this kind by its type, and says whether the machine can answer it.
        fn by_type(kind: &str, system: &System, fields: &Value) -> bool {
            $(if kind == <$study as Study>::KIND {
                let study: $study = construct(system, fields).unwrap_or_else(|d| panic!("{kind}: {d}"));
                return ErasedStudy::admit(&study, system).is_ok();
            })*
            panic!("{kind} is not in the prelude")
        }

        /// Outcomes of the study of this kind: of its result, and of the same after a stay in bytes.
        fn stored(kind: &str, system: &System, fields: &Value) -> [Outcome; 2] {
            $(if kind == <$study as Study>::KIND {
                let study: $study = construct(system, fields).unwrap_or_else(|d| panic!("{kind}: {d}"));
                // a study that has no partial result is given more
                let limited = |work_limit: u64| study.result(system, &Context { work_limit, ..Context::quiet("stored") });
                let result = limited(STEPS).or_else(|_| limited(u64::MAX)).unwrap_or_else(|d| panic!("{kind}: {d}"));
                let bytes = postcard::to_stdvec(&result).unwrap_or_else(|e| panic!("{kind}: {e}"));
                let again = postcard::from_bytes(&bytes).unwrap_or_else(|e| panic!("{kind}: {e}"));
                return [&result, &again].map(|r| study.outcome(system, r, "stored").unwrap_or_else(|d| panic!("{kind}: {d}")));
            })*
            panic!("{kind} is not in the prelude")
        }
    };
}
studies! {
    Backbone Basins BearingCoefficients BifurcationLoci Campbell CriticalSpeeds ForcedResponse HarmonicForce LimitCycles Methods Modes MotionMap NonlinearResponse OperatingWindow
    Optimum ResponseMap RunUp Sensitivity Separation StabilityMap StabilityThreshold Static Stationary SupportStiffnessMap Sweep Transient Uncertainty
}

#[test]
fn every_study_is_made_from_its_fields() {
    for kind in registry() {
        let kind = kind.info.kind;
        let (loaded, fields) = example(kind);
        let admitted = loaded.studies[0].study.admit(&loaded.system).is_ok();
        assert_eq!(by_type(kind, &loaded.system, &fields), admitted, "{kind}");
        let by_word = construct_kind(kind, &loaded.system, &fields).unwrap_or_else(|d| panic!("{kind}: {d}"));
        assert_eq!((by_word.kind(), by_word.admit(&loaded.system).is_ok()), (kind, admitted));
    }
}

#[test]
fn a_constructed_study_finds_what_that_of_a_file_finds() {
    for kind in ["modes", "critical_speeds", "forced_response", "stability_map", "transient"] {
        let (loaded, fields) = example(kind);
        let context = Context::quiet("same");
        let study = construct_kind(kind, &loaded.system, &fields).unwrap();
        let [file, rust] = [&loaded.studies[0].study, &study].map(|s| s.run(&loaded.system, &context).unwrap());
        // columns may hold NaN, which is not equal to itself
        assert_eq!(format!("{file:?}"), format!("{rust:?}"), "{kind}");
    }
}

#[test]
fn mistakes_in_fields_are_said_together() {
    let system = example("sweep").0.system;
    let wrong = |fields: Value| construct::<Sweep>(&system, &fields).err().unwrap();
    let codes = |d: &Diagnostics| d.0.iter().map(|d| d.code).collect::<Vec<_>>();
    let d = wrong(json!({ "sped": { "from": 10.0, "to": 20.0 }, "lyapunov": 3.0 }));
    assert_eq!(codes(&d), ["key.unknown", "value.type"], "{d}");
    assert!(d.to_string().contains("did you mean \"speed\"?"), "{d}");
    let d = wrong(json!({ "lyapunov": true }));
    assert_eq!(codes(&d), ["key.missing"], "{d}");
    let d = wrong(json!({ "speed": { "from": 10.0, "to": 20.0, "points": 3 }, "initial": { "drum.q": 1.0 } }));
    assert!(d.has_errors() && d.to_string().contains("drum.q"), "{d}");
    let d = wrong(json!([1.0]));
    assert_eq!(codes(&d), ["value.type"], "{d}");
    let d = construct_kind("swep", &system, &json!({})).err().unwrap();
    assert!(codes(&d) == ["kind.unknown"] && d.to_string().contains("did you mean \"sweep\"?"), "{d}");
    // what is given beside a default counts as given
    let both = json!({ "duration": 1.0, "points": 50, "output_step": 0.1 });
    assert!(construct::<Transient>(&system, &both).is_err());
    assert!(construct::<Transient>(&system, &json!({ "duration": 1.0, "output_step": 0.1 })).is_ok());
}

/// A result that was stored gives the tables, figures and findings of the run, whatever study it is of.
#[test]
fn a_stored_result_is_reported_like_a_new_one() {
    for kind in registry() {
        let kind = kind.info.kind;
        let (loaded, mut fields) = example(kind);
        if loaded.studies[0].study.admit(&loaded.system).is_err() {
            continue;
        }
        if matches!(kind, "separation" | "operating_window") {
            fields["particles"] = json!(64);
        }
        let begun = std::time::Instant::now();
        let [run, again] = stored(kind, &loaded.system, &fields);
        println!("{kind}: {:.2} s, {}", begun.elapsed().as_secs_f64(), run.end.word());
        // columns may hold NaN, which is not equal to itself
        assert_eq!(format!("{run:?}"), format!("{again:?}"), "{kind}");
    }
}
