//! Offsets of supports: three moments, reciprocity, statically determinate machines, trains whose couplings carry nothing.

use super::statics::{AREA, BENDING, LINE, balanced, beam, bearing, near};
use crate::common::files::{finding, findings, load, run_all};
use laval::model::system::{GRAVITY, System};
use laval::outcome::{Level, Outcome, Table};
use laval::solve::statics::alignment::Section;
use laval::solve::statics::offsets::Offset;
use laval::study::TypedStudy;
use laval::study::statics::{Request, Static, StaticResult};
use laval::study::{Context, Study};

fn slot(system: &System, name: &str) -> usize {
    system.slots().iter().position(|s| s.name == name).unwrap()
}

fn with(system: &System, offsets: &[(&str, [f64; 2])]) -> StaticResult {
    let offsets = offsets.iter().map(|(n, by)| Offset { slot: slot(system, n), by: *by }).collect();
    let study = Static { alignment: Request { offsets, ..Request::default() }, ..Static::default() };
    study.compute(system, &Context::quiet("static")).unwrap()
}

fn force(system: &System, kind: &laval::study::statics::Kind, name: &str) -> [f64; 2] {
    kind.reactions.iter().find(|r| r.slot == slot(system, name)).unwrap().force
}

fn three(k: f64) -> System {
    beam(&[0.7, 1.2], "none", &(bearing("a", 0.0, k) + &bearing("b", 0.7, k) + &bearing("c", 1.9, k)))
}

/// Clapeyron with a settlement: `2 M (a + b) = -w (a^3 + b^3)/4 + 6 E I (d_b - d_a)/a + 6 E I (d_b - d_c)/b`, with M positive where the curvature is.
#[test]
fn three_moments_with_settlement() {
    let system = three(1e8);
    let (a, b) = (0.7f64, 1.2f64);
    for d in [[0.0, -3e-4, 0.0], [1e-4, 5e-4, -2e-4]] {
        let result = with(&system, &[("a", [0.0, d[0]]), ("b", [0.0, d[1]]), ("c", [0.0, d[2]])]);
        balanced(&result, 1e-10, "settled");
        let kind = result.rigid.as_ref().unwrap();
        let bent = -6.0 * BENDING * ((d[1] - d[0]) / a + (d[1] - d[2]) / b);
        let expected = (-LINE * (a.powi(3) + b.powi(3)) / 4.0 + bent) / (2.0 * (a + b));
        let cut = kind.beams[0].cuts.iter().find(|c| (c.position - a).abs() < 1e-12).unwrap();
        near(cut.moment[0][1], expected, 1e-9, expected, "moment");
        near(cut.deflection[1], d[1], 1e-12, 1e-3, "place");
        near(force(&system, kind, "a")[1], LINE * a / 2.0 + expected / a, 1e-9, LINE, "first reaction");
        near(force(&system, kind, "c")[1], LINE * b / 2.0 + expected / b, 1e-9, LINE, "last reaction");
        // on springs: the same with the places where the springs let them be
        let own = &result.own;
        let place = |name: &str, offset: f64| offset - force(&system, own, name)[1] / 1e8;
        let at = [place("a", d[0]), place("b", d[1]), place("c", d[2])];
        let bent = -6.0 * BENDING * ((at[1] - at[0]) / a + (at[1] - at[2]) / b);
        let expected = (-LINE * (a.powi(3) + b.powi(3)) / 4.0 + bent) / (2.0 * (a + b));
        let cut = own.beams[0].cuts.iter().find(|c| (c.position - a).abs() < 1e-12).unwrap();
        near(cut.moment[0][1], expected, 1e-9, expected, "moment on springs");
        for kind in [own, kind] {
            let sum: f64 = ["a", "b", "c"].iter().map(|n| force(&system, kind, n)[1]).sum();
            near(sum, LINE * 1.9, 1e-9, LINE, "sum");
            let about: f64 = [("a", 0.0), ("b", a), ("c", a + b)].iter().map(|(n, z)| force(&system, kind, n)[1] * z).sum();
            near(about, LINE * 1.9 * 0.95, 1e-9, LINE, "moments balance");
        }
    }
}

/// Influence: symmetric, no resultant force or moment, and equal to the difference of two machines; `12 E I ...` on rigid supports.
#[test]
fn influence_is_reciprocal() {
    let system = three(1e8);
    let result = with(&system, &[("b", [1e-4, 2e-4])]);
    let a = result.alignment.as_ref().unwrap();
    assert!(a.skew < 1e-9 * a.largest, "{:e} {:e}", a.skew, a.largest);
    let of = |x: &str, y: &str| a.influence.iter().find(|i| i.load_of == slot(&system, x) && i.raised == slot(&system, y)).unwrap();
    for raised in ["a", "b", "c"] {
        let column: Vec<f64> = ["a", "b", "c"].iter().map(|x| of(x, raised).own[1][1]).collect();
        assert!(column.iter().sum::<f64>().abs() < 1e-8 * a.largest);
        assert!((0.7 * column[1] + 1.9 * column[2]).abs() < 1e-8 * a.largest);
        let (h, level) = (1e-3, with(&system, &[]));
        let moved = with(&system, &[(raised, [0.0, h])]);
        for x in ["a", "b", "c"] {
            let change = (force(&system, &moved.own, x)[1] - force(&system, &level.own, x)[1]) / h;
            near(change, of(x, raised).own[1][1], 1e-7, a.largest, "difference");
            let rigid = [&moved, &level].map(|r| force(&system, r.rigid.as_ref().unwrap(), x)[1]);
            near((rigid[0] - rigid[1]) / h, of(x, raised).rigid[1][1], 1e-7, a.largest, "rigid difference");
        }
    }
    // a beam over a and a + b lifted in between: 3 E I (a + b)/(a b)^2
    let lifted = 3.0 * BENDING * 1.9 / (0.7f64 * 1.2).powi(2);
    near(of("b", "b").rigid[1][1], lifted, 1e-8, lifted, "rigid");
    near(of("b", "b").rigid[0][0], lifted, 1e-8, lifted, "rigid in x");
    // springs in series with the beam: 1/k = 1/lifted + 1/k_b + (share of the ends)
    let ends = (1.2f64 / 1.9).powi(2) + (0.7f64 / 1.9).powi(2);
    let series = 1.0 / (1.0 / lifted + (1.0 + ends) / 1e8);
    near(of("b", "b").own[1][1], series, 1e-8, series, "on springs");
}

/// Two bearings, a bending or a rigid rotor: offsets tilt it, and no load changes.
#[test]
fn determinate_machines() {
    let shaft = beam(&[1.2], "none", &(bearing("a", 0.1, 1e7) + &bearing("b", 1.2, 2e7)));
    let drum = "[[part]]\nkind = \"disc\"\nname = \"shaft\"\nmass = 12.0\npolar_inertia = 0.4\ndiametral_inertia = 0.3\n";
    let text = format!("[machine]\nname = \"t\"\naxis = \"horizontal\"\n{drum}{}{}", bearing("a", -0.2, 1e7), bearing("b", 0.3, 3e7));
    for system in [shaft, load(&text).system] {
        let (level, moved) = (with(&system, &[]), with(&system, &[("a", [2e-4, -1e-4]), ("b", [0.0, 3e-4])]));
        balanced(&moved, 1e-10, "determinate");
        for name in ["a", "b"] {
            let (before, now) = (force(&system, &level.own, name), force(&system, &moved.own, name));
            (0..2).for_each(|p| near(before[p], now[p], 1e-9, 12.0 * GRAVITY, "load"));
        }
        let a = moved.alignment.as_ref().unwrap();
        assert!(a.largest < 1e-7 * 1e7, "{:e}", a.largest);
        let study = Static { alignment: Request { offsets: a.offsets.clone(), ..Request::default() }, ..Static::default() };
        let outcome = study.outcome(&system, &moved, "static").unwrap();
        assert_eq!((findings(&outcome, "determinate").len(), findings(&outcome, "offsets_without_effect").len()), (1, 1));
    }
}

/// Two uniform rotors on two bearings each: at the heights found they are what they are alone, turned and raised as rigid bodies so that their ends meet.
#[test]
fn train_of_two_rotors() {
    let (l, k) = (1.5f64, 2e8);
    let stand = [0.2, 1.3, l + 0.3, l + 1.35];
    let names = ["a", "b", "c", "d"];
    let bearings: String = names.iter().zip(stand).map(|(n, z)| bearing(n, z, k)).collect();
    let train = beam(&[l, l], "none", &bearings);
    let section = Section::at(&train, slot(&train, "shaft"), l).unwrap();
    let request = Request { couplings: vec![("joint".into(), section)], ..Request::default() };
    let study = Static { alignment: request, ..Static::default() };
    let result = study.compute(&train, &Context::quiet("static")).unwrap();
    let a = result.alignment.as_ref().unwrap();
    let t = a.train.as_ref().unwrap();
    assert!(t.left < 1e-9 && t.spare == 0 && !a.unaligned, "{:e}", t.left);
    assert!(a.couplings[0].given.1[1].abs() > 1.0);
    let (v, m) = a.couplings[0].aligned;
    assert!(v[1].abs() < 1e-8 * LINE && m[1].abs() < 1e-8 * LINE, "{v:?} {m:?}");
    // each rotor alone
    let alone = |first: usize, from: f64| {
        let own = bearing("p", stand[first] - from, k) + &bearing("q", stand[first + 1] - from, k);
        let system = beam(&[l], "none", &own);
        let result = with(&system, &[]);
        let loads = ["p", "q"].map(|n| force(&system, &result.own, n)[1]);
        (result.own.beams[0].cuts.clone(), loads)
    };
    let ((left, first), (right, second)) = (alone(0, 0.0), alone(2, l));
    for (name, load) in names.iter().zip(first.into_iter().chain(second)) {
        near(force(&train, &t.kind, name)[1], load, 1e-7, load, "load of a rotor alone");
    }
    // deflection and slope of the left rotor at its end, those of the right at its beginning
    let (end, begin) = (left.last().unwrap(), right.first().unwrap());
    let turn = end.slope[1] - begin.slope[1];
    let rise = end.deflection[1] - begin.deflection[1];
    let height = |z: f64| rise + turn * (z - l);
    let of = |name: &str| t.offsets.iter().find(|o| o.slot == slot(&train, name)).unwrap().by;
    let size = height(stand[3]).abs();
    assert_eq!((of("a"), of("b")), ([0.0; 2], [0.0; 2]));
    near(of("c")[1], height(stand[2]), 1e-7, size, "height of c");
    near(of("d")[1], height(stand[3]), 1e-7, size, "height of d");
    near(of("d")[0], 0.0, 1e-9, size, "sideways");
    let weight = 8000.0 * AREA * 2.0 * l * GRAVITY;
    near(names.iter().map(|n| force(&train, &t.kind, n)[1]).sum::<f64>(), weight, 1e-9, weight, "weight");
}

/// Journal bearings: the influence is that about the equilibrium, and the aligned train closes.
#[test]
fn journal_bearings() {
    let journal = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_journal\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\ndiameter = 0.05\nlength = 0.02\nclearance = 1e-4\nviscosity = 0.02\n"
        )
    };
    let system = beam(&[0.7, 0.7], "none", &(journal("a", 0.1) + &journal("b", 0.6) + &journal("c", 0.8) + &journal("d", 1.3)));
    let at = |offsets: &[(&str, f64)], couplings: Vec<(String, Section)>| {
        let offsets = offsets.iter().map(|(n, y)| Offset { slot: slot(&system, n), by: [0.0, *y] }).collect();
        let study = Static { speed: 300.0, alignment: Request { offsets, couplings, ..Request::default() }, ..Static::default() };
        study.compute(&system, &Context::quiet("static")).unwrap()
    };
    let (h, base) = (1e-8, at(&[("c", 2e-5)], Vec::new()));
    balanced(&base, 1e-8, "journals");
    let a = base.alignment.as_ref().unwrap();
    let (more, less) = (at(&[("c", 2e-5 + h)], Vec::new()), at(&[("c", 2e-5 - h)], Vec::new()));
    for name in ["a", "b", "c", "d"] {
        let i = a.influence.iter().find(|i| i.load_of == slot(&system, name) && i.raised == slot(&system, "c")).unwrap();
        for p in 0..2 {
            let change = (force(&system, &more.own, name)[p] - force(&system, &less.own, name)[p]) / (2.0 * h);
            near(change, i.own[p][1], 1e-4, a.largest, name);
        }
    }
    // cross stiffness of the films
    assert!(a.skew > 1e-3 * a.largest);
    let section = Section::at(&system, slot(&system, "shaft"), 0.7).unwrap();
    let train = at(&[], vec![("joint".into(), section)]).alignment.unwrap().train.unwrap();
    assert!(train.left < 1e-9);
    // one film is like the other: heights and loads mirror each other
    let load = |n: &str| force(&system, &train.kind, n)[1];
    near(load("a"), load("d"), 1e-6, load("a"), "mirrored");
    near(load("b"), load("c"), 1e-6, load("b"), "mirrored");
}

fn table<'o>(outcome: &'o Outcome, name: &str) -> &'o Table {
    outcome.tables.iter().find(|t| t.name() == name).unwrap()
}

fn text(study: &str) -> String {
    let shaft = "section = { length = [1.5, 1.5], outer_diameter = [0.05, 0.05] }\n";
    let bearings: String = [("a", 0.2), ("b", 1.3), ("c", 1.8), ("d", 2.85)].iter().map(|(n, z)| bearing(n, *z, 2e8)).collect();
    format!(
        "[machine]\nname = \"t\"\naxis = \"horizontal\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\n{shaft}{bearings}[[study]]\nkind = \"static\"\n{study}"
    )
}

/// From the file: findings, tables, a figure with the aligned train; a load that turns round is a warning.
#[test]
fn from_the_file() {
    let study = "offset_y = { c = \"2 mm\" }\noffset_x = { b = \"0.1 mm\" }\ncouplings = \"shaft at 1500 mm\"\n";
    let outcome = &run_all(&text(study))[0];
    for id in ["offset_load", "influence", "coupling_moment"] {
        finding(outcome, id);
    }
    assert_eq!(findings(outcome, "aligned").len(), 2);
    let pulled = findings(outcome, "unloaded");
    assert!(!pulled.is_empty() && pulled.iter().all(|f| f.level == Level::Warning));
    assert_eq!(table(outcome, "offsets").rows(), 4);
    assert_eq!(table(outcome, "influence").rows(), 16);
    assert_eq!(table(outcome, "couplings").rows(), 1);
    assert!(table(outcome, "shafts").column("aligned_moment_y").is_some());
    // kept supports keep the offsets that are given
    let kept = table(outcome, "offsets").column("aligned_offset_x").unwrap();
    assert_eq!(kept.number(1), Some(1e-4));
    // three supports may move for two loads
    let outcome = &run_all(&text("couplings = \"shaft at 1500 mm\"\nkept = \"a\"\n"))[0];
    assert_eq!((findings(outcome, "aligned").len(), finding(outcome, "spare_heights").number("spare")), (3, Some(1.0)));
    let moment = &run_all(&text("couplings = \"shaft at 1500 mm\"\naligned_for = \"moment\"\nkept = \"a, b, d\"\n"))[0];
    let freed = table(moment, "couplings");
    let row = |name: &str| freed.column(name).unwrap().number(0).unwrap();
    assert_eq!(row("aligned_moment_y"), 0.0);
    assert!(row("aligned_shear_y").abs() > 1.0);
    // without a request two tables are as before
    assert!(run_all(&text(""))[0].tables.iter().all(|t| t.name() != "offsets"));
}

/// Mistakes are reported at their place.
#[test]
fn mistakes() {
    let of = |study: &str| laval::file::load(&text(study)).err().unwrap().0;
    for (study, message) in [
        ("offset_y = { e = \"1 mm\" }\n", "static: there is no part \"e\""),
        ("offset_y = { shaft = \"1 mm\" }\n", "static: \"shaft\" does not join a turning body to anything"),
        ("couplings = \"shaft at 1234 mm\"\n", "static: shaft at 1234 mm is no node of the shaft: the nearest is at 1.25 m"),
        ("couplings = \"flange\"\n", "static: couplings names \"flange\", which is neither a part nor a place of a shaft"),
        ("kept = \"a\"\n", "static: kept says how couplings are aligned, and couplings names none"),
    ] {
        let wrong = of(study);
        let said: Vec<String> = wrong.iter().map(|d| d.message.to_string()).collect();
        assert_eq!(said, [message]);
        assert!(wrong.iter().all(|d| d.span.is_some() && d.help.is_some()));
    }
    let loaded = load(&text("couplings = \"shaft at 1500 mm\"\nkept = \"a, b, c\"\n"));
    let refused = loaded.studies[0].study.admit(&loaded.system).err().unwrap();
    assert_eq!(refused.message.to_string(), "2 loads of couplings vanish only with as many supports that may move, and there are 1");
}

/// A stored result says the same.
#[test]
fn stored_alignment() {
    let loaded = load(&text(""));
    let section = Section::at(&loaded.system, slot(&loaded.system, "shaft"), 1.5).unwrap();
    let offsets = vec![Offset { slot: slot(&loaded.system, "c"), by: [0.0, 1e-4] }];
    let request = Request { couplings: vec![("joint".into(), section)], offsets, ..Request::default() };
    let study = Static { alignment: request, ..Static::default() };
    let result = study.compute(&loaded.system, &Context::quiet("static")).unwrap();
    let again: StaticResult = serde_json::from_str(&serde_json::to_string(&result).unwrap()).unwrap();
    assert_eq!(study.outcome(&loaded.system, &result, "static").unwrap(), study.outcome(&loaded.system, &again, "static").unwrap());
}
