//! Harmonic balance of the planar machine: folds and stability of the reference tables, and checks that know no table.

mod common;
use common::base::Base;
use laval::solve::harmonic::response::{Request, Response, respond};
use std::sync::atomic::AtomicBool;

fn response(base: Base, lo: f64, hi: f64) -> Response {
    let system = base.builder().build().unwrap();
    let request =
        Request { speeds: (lo, hi), harmonics: None, symmetry: None, divisor: 1, truncation: 1e-7, stability: true, max_points: 20_000 };
    let system: &'static _ = Box::leak(Box::new(system));
    static NEVER: AtomicBool = AtomicBool::new(false);
    respond(system, &request, &NEVER, &|_| {}).unwrap()
}

#[test]
fn folds_of_the_benchmark() {
    for base in [
        Base { e: 5e-5, ..Base::default() },
        Base::default(),
        Base { fill: Some(0.667), ..Base::default() },
        Base { fill: Some(0.667), isotropic: true, ..Base::default() },
    ] {
        let t = std::time::Instant::now();
        let r = response(base, 25.0, 8000.0);
        println!("{:?} sampling {:e} {:?} {:?} in {:?}", r.discretisation, r.sampling, r.work, r.unjudged, t.elapsed());
        for b in &r.branches {
            println!("  low {} end {:?} points {} changes {:?}", b.from_low, b.end, b.points.len(), b.changes);
            for f in &b.folds {
                println!(
                    "   fold {:.10} bracket {:?} res {:e} methods {:e} harmonics {:e}",
                    f.speed, f.bracket, f.residual, f.methods_differ, f.harmonics_change
                );
            }
            for p in b.points.iter().step_by(40) {
                println!(
                    "      {:.3} {:.4e} growth {:.6} {:?} trunc {:.1e}",
                    p.speed,
                    p.x[0].hypot(p.x[1]),
                    p.growth(),
                    p.exponents.as_ref().map(|e| (e.method, e.error)),
                    p.truncation
                );
            }
        }
    }
}
