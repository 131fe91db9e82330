//! The machine code of the ensemble's equations, read in this program.

#![cfg(all(target_os = "linux", target_arch = "x86_64"))]

use laval_model::model::builder::Builder;
use laval_model::model::system::System;
use laval_model::parts::{self, disc};
use laval_solve::ensemble::{self, Ended, EnsembleTask, Form, Leg, LegEnd, Next, Settings, Start};
use laval_solve::motion::SpinLaw;
use laval_solve::programme::Programme;
use object::{Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};
use std::collections::BTreeMap;
use std::sync::Arc;

struct One(Arc<System>);

impl EnsembleTask for One {
    type Log = ();
    type Row = LegEnd;
    fn start(&self, _: usize) -> Result<Start<()>, LegEnd> {
        let y = vec![0.0; 2 * self.0.coordinates().len()];
        let absolute = vec![1e-9; y.len()];
        Ok(Start {
            system: self.0.clone(),
            law: SpinLaw::Programme(Programme::constant(10.0, 0.0)),
            y,
            relative: 1e-6,
            absolute,
            leg: Leg::new(0.0, 1e-3),
            log: (),
        })
    }
    fn output(&self, (): &mut (), _: u64, _: f64, _: &[f64]) {}
    fn ended(&self, _: usize, (): &mut (), ended: &Ended, _: &mut [f64]) -> Next<LegEnd> {
        Next::Done(ended.end)
    }
}

/// Functions that call an operation of the processor as a function, with the operation. Calls are found by their distance to the function called.
fn callers(is_operation: impl Fn(&str) -> bool) -> Vec<(String, String)> {
    let program = std::fs::read(std::env::current_exe().unwrap()).unwrap();
    let file = object::File::parse(&*program).unwrap();
    let functions: BTreeMap<u64, &str> =
        file.symbols().filter(|s| s.kind() == SymbolKind::Text).map(|s| (s.address(), s.name().unwrap())).collect();
    assert!(functions.len() > 1000, "this test program has no symbols to read");
    let mut found = Vec::new();
    for section in file.sections().filter(|s| s.kind() == SectionKind::Text) {
        let (code, start) = (section.data().unwrap(), section.address());
        for (k, call) in code.windows(5).enumerate() {
            if !matches!(call[0], 0xe8 | 0xe9) {
                continue;
            }
            let at = start + k as u64;
            let distance = i32::from_le_bytes([call[1], call[2], call[3], call[4]]);
            if let Some(&name) = functions.get(&(at + 5).wrapping_add_signed(i64::from(distance))).filter(|name| is_operation(name)) {
                let caller = functions.range(..=at).next_back().map_or("", |f| f.1);
                found.push((caller.to_string(), name.to_string()));
            }
        }
    }
    found
}

/// Matrices of shafts are long and are made once for each machine and speed where masses are constant; inlined at every level they would fill the program.
const SHAFT: [&str; 3] = ["5parts5shaft7element", "5parts5shaft4line", "parts..shaft..Shaft$"];

/// A function that is called instead of inlined lacks the instructions of the level, and so does every operation in it: each becomes a call. In lanes no
/// arithmetic may be called. The linear algebra library calls its own.
#[test]
fn arithmetic_in_lanes_is_inlined() {
    if cfg!(debug_assertions) {
        return;
    }
    // all parts and all forms of the equations become a part of this program
    assert!(parts::registry().len() > 10);
    let system = Arc::new(Builder::new("one").part("disc", disc::Disc::planar(), disc::DiscParams::new(1.0)).build().unwrap());
    let ends = ensemble::run(&One(system.clone()), &system, Form::Constant, 0..1, Settings::default()).unwrap();
    assert!(matches!(ends[..], [LegEnd::Reached]));

    let arithmetic =
        |name: &str| ["mul", "add", "sub", "div"].iter().any(|o| ["256", "512"].iter().any(|w| name.contains(&format!("_mm{w}_{o}_pd"))));
    let ours = callers(arithmetic)
        .into_iter()
        .filter(|(caller, _)| !["pulp", "gemm", "faer"].iter().chain(&SHAFT).any(|library| caller.contains(library)));
    let listed: Vec<String> = ours.map(|(caller, operation)| format!("{caller} calls {operation}")).collect();
    assert!(listed.is_empty(), "a part or a helper lacks #[inline(always)], or a closure stays a call:\n{}", listed.join("\n"));
    // the names are found where they stand: operations outside loops, such as those that fill the lanes, are called
    assert!(!callers(|name| name.contains("_mm256_set1_pd")).is_empty());
}
