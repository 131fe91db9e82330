//! No input whatever makes the reader fall over, and what is written reads back. Edited files are the matter of `tests/fuzz`.

use super::*;
use proptest::prelude::*;

#[test]
fn extremes() {
    let c = catalog();
    let deep = |open: &str, n: usize| format!("[machine]\nname = {}", open.repeat(n));
    let dotted = |n: usize| vec!["a"; n].join(".");
    let inline = |n: usize| format!("{{ {} = ", dotted(60)).repeat(n);
    for text in [
        deep("[", 100_000),
        deep("{ a = ", 100_000),
        format!("[machine]\n{} = 1", dotted(100_000)),
        format!("[{}]\nx = 1", dotted(100_000)),
        format!("[{}]\n{} = {}", dotted(60), dotted(60), inline(1000)),
        format!("[machine]\nname = \"{}\"\nspeed = \"{}\"\n", "x".repeat(1_000_000), "9".repeat(1_000_000)),
        format!("[machine]\nspeed = \"1 {}\"\n", "m ".repeat(500_000)),
        format!("[machine]\nspeed = {}\n", "9".repeat(100_000)),
        format!("[machine]\nspeed = \"1 {}\"\n", "(".repeat(150)),
        format!("[machine]\n{} = 1\n", "k".repeat(1_000_000)),
        format!("[machine]\n# {}\n", ".".repeat(10_000)),
        "[[part]]\n".repeat(20_000),
        format!("[machine]\n{}", "[[part]]\nkind = \"disc\"\nmass = 1\n".repeat(20_000)),
        "\u{feff}".repeat(1000),
        "=\n".repeat(50_000),
    ] {
        let (spec, d) = read(&text, &c);
        assert_eq!(spec.is_none(), d.has_errors());
        render(&d, &text, "f", Form::Excerpts { width: 80, colour: false });
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let (spec, d) = read_bytes(&bytes, &catalog());
        prop_assert!(spec.is_none() && d.has_errors());
    }

    #[test]
    fn random_text(text in "\\PC{0,80}") {
        let _ = read(&text, &catalog());
    }

    #[test]
    fn random_json(text in r#"(\{|\[|"(machine|part|study|kind|disc|mass)"|:|,|\}|\]|1|null|true){0,30}"#) {
        if let Ok(v) = serde_json::from_str::<serde_json::Value>(&text) {
            let _ = read_json(&v, &catalog());
        }
    }
}

fn number(b: Bounds) -> impl Strategy<Value = f64> {
    let (lo, hi) = (b.min.max(-1e300), b.max.min(1e300));
    prop_oneof![Just(hi), any::<f64>().prop_map(move |x| x.abs() % hi), (-12.0..6.0).prop_map(|e: f64| 10f64.powf(e)), Just(lo)]
        .prop_filter("inside", move |x| b.contains(*x))
}

fn value_of(kind: FieldKind) -> BoxedStrategy<Value> {
    let point = || {
        (prop::sample::select(vec!["drum", "base", "some body"]), prop_oneof![Just(0.0), -1e3..1e3])
            .prop_map(|(b, z)| if z == 0.0 { Attach::on(b) } else { Attach::at(b, z) })
    };
    let range = |b: Bounds| {
        (number(b), number(b), prop::option::of(2usize..=crate::model::field::MOST_POINTS))
            .prop_filter("differ", |(a, b, _)| a != b)
            .prop_map(|(from, to, points)| RangeValue { from, to, points })
    };
    match kind {
        FieldKind::Quantity { bounds, .. } => number(bounds).prop_map(Value::Number).boxed(),
        FieldKind::Lateral { bounds, .. } => (number(bounds), number(bounds)).prop_map(|(x, y)| Value::Lateral([x, y])).boxed(),
        FieldKind::OneOf(list) => {
            prop::sample::select(list.to_vec()).prop_flat_map(|o| number(o.2).prop_map(move |x| Value::OneOf(o.0, x))).boxed()
        }
        FieldKind::Choice(words) => prop::sample::select(words.to_vec()).prop_map(|w| Value::Choice(w.0)).boxed(),
        FieldKind::Integer { min, max } => (min..=max).prop_map(Value::Integer).boxed(),
        FieldKind::IntegerOrAuto { min, max } => prop_oneof![Just(Value::Auto), (min..=max).prop_map(Value::Integer)].boxed(),
        FieldKind::Flag => any::<bool>().prop_map(Value::Flag).boxed(),
        FieldKind::Text => any::<String>().prop_map(Value::Text).boxed(),
        FieldKind::Coordinate => Just(Value::Text("drum.x".into())).boxed(),
        FieldKind::Attach { .. } => point().prop_map(Value::Attach).boxed(),
        FieldKind::Between => point().prop_map(|a| Value::Between(a, Attach::ground())).boxed(),
        FieldKind::Range { bounds, .. } => range(bounds).prop_map(Value::Range).boxed(),
        FieldKind::List { bounds, .. } => prop::collection::vec(number(bounds), 1..5).prop_map(Value::List).boxed(),
        FieldKind::ParameterPath => Just(Value::Text("drum.mass".into())).boxed(),
        FieldKind::ParameterRange => range(Bounds::positive(1e6)).prop_map(|r| Value::ParameterRange("drum.mass".into(), r)).boxed(),
        FieldKind::ParameterRanges => {
            range(Bounds::positive(1e6)).prop_map(|r| Value::ParameterRanges(vec![("drum.mass".into(), r, None)])).boxed()
        }
        FieldKind::Columns(list) => (1usize..4)
            .prop_flat_map(move |n| prop::collection::vec(prop::collection::vec(number(Bounds::within(1e12)), n..=n), list.len()))
            .prop_map(move |v| Value::Columns(list.iter().map(|c| c.0).zip(v).collect()))
            .boxed(),
        FieldKind::StateMap => prop::collection::vec(number(Bounds::within(1e6)), 0..4)
            .prop_map(|v| Value::StateMap(v.into_iter().enumerate().map(|(i, x)| (format!("drum.x{i}"), x, 0..0)).collect()))
            .boxed(),
        FieldKind::Named { bounds, .. } => prop_oneof![
            number(bounds).prop_map(Value::Number),
            number(bounds).prop_map(|x| Value::StateMap(vec![("drum".into(), x, 0..0)])),
        ]
        .boxed(),
        FieldKind::Study => (1i64..1000)
            .prop_map(|n| {
                let mut values = Values::default();
                values.set("count", Value::Integer(n), None);
                Value::Study(Box::new(InnerStudy { name: None, kind: "modes", values }))
            })
            .boxed(),
        FieldKind::Tolerances => (number(Bounds::within(1e6)), number(Bounds::within(10.0)))
            .prop_map(|(a, b)| {
                let amounts = vec![("mean", Amount::Absolute(a)), ("deviation", Amount::Percent(b))];
                Value::Tolerances(vec![Tolerance { parameter: "drum.mass".into(), distribution: "normal", amounts, span: None }])
            })
            .boxed(),
    }
}

fn block(k: KindInfo, name: String) -> impl Strategy<Value = Block> {
    let each: Vec<BoxedStrategy<(&'static str, Value)>> = k
        .fields
        .iter()
        .map(|f| {
            let n = f.name;
            value_of(f.kind).prop_map(move |v| (n, v)).boxed()
        })
        .collect();
    each.prop_map(move |list| {
        let mut values = Values::default();
        for (name, v) in list {
            if let Value::StateMap(m) = &v {
                values.set_units(name, m.iter().enumerate().map(|(i, _)| (i % 2 == 0).then(|| "m/s".to_string())).collect());
            }
            values.set(name, v, None);
        }
        Block { kind: k.kind, name: name.clone(), values, span: None, kind_span: None, name_span: None }
    })
}

fn spec() -> impl Strategy<Value = Spec> {
    let c = catalog();
    let parts: Vec<_> =
        c.parts.into_iter().enumerate().map(|(i, k)| block(k, if i == 0 { "drum".into() } else { format!("part {i}") })).collect();
    let studies: Vec<_> = c.studies.into_iter().enumerate().map(|(i, k)| block(k, format!("study-{i}"))).collect();
    (any::<String>(), prop::option::of(number(Bounds::up_to(1e6))), any::<bool>(), any::<bool>(), parts, studies).prop_map(
        |(name, speed, horizontal, free, parts, studies)| Spec {
            machine: MachineBlock {
                name,
                speed,
                axis: if horizontal { RotorAxis::Horizontal } else { RotorAxis::Vertical },
                drive: if free { Drive::Free } else { Drive::Prescribed },
                span: None,
                speed_span: None,
            },
            parts,
            studies,
            extras: vec![],
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn written_specs_read_back_exactly(s in spec()) {
        let written = write(&s, &catalog());
        let (back, d) = read(&written, &catalog());
        prop_assert!(back.is_some(), "{}\n{}", render(&d, &written, "f", Form::Lines), written);
        prop_assert_eq!(back.unwrap().without_spans(), s.clone());
        let json: serde_json::Value = serde_json::from_str(&write_json(&s).to_string()).unwrap();
        let (back, d) = read_json(&json, &catalog());
        prop_assert!(back.is_some(), "{:?}", d);
        prop_assert_eq!(back.unwrap().without_spans(), s);
    }
}
