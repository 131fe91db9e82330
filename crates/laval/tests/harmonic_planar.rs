//! Harmonic balance of the planar machine: folds of the reference tables, and checks that know no table.

mod common;
use common::Base;
use laval::solve::harmonic::problem::{Balance, Discretisation};
use laval::solve::symmetry::Symmetry;
use laval_num::continuation::{Direction, Settings, Zero, trace};
use laval_num::newton;

#[test]
fn folds_of_the_benchmark() {
    let system = Base { e: 5e-5, ..Base::default() }.builder().build().unwrap();
    let d = Discretisation { harmonics: 7, divisor: 1, samples: 32, symmetry: Symmetry::Quarter };
    let mut b = Balance::new(&system, d, (25.0, 8000.0), None).unwrap();
    println!("unknowns {} scales {:?}", b.dim(), b.scales());
    let mut x = vec![0.0; b.dim()];
    let t = std::time::Instant::now();
    let c = newton::newton(&mut b, &mut x, 25.0, &newton::Options::default());
    println!("{c:?}");
    let branch = trace(&mut b, &x, 25.0, Direction::Up, &Settings::new(25.0, 8000.0), &mut []);
    let branch = branch.unwrap();
    println!("{:?} {:?} in {:?}", branch.end, branch.counters, t.elapsed());
    let mut st = laval::solve::harmonic::floquet::Stability::new(&system).unwrap();
    let t = std::time::Instant::now();
    let mut kinds = [0; 3];
    let mut r = vec![0.0; b.dim()];
    let mut j = laval_num::dense::Mat::zeros(b.dim(), b.dim());
    let mut prev = true;
    for p in &branch.points {
        b.eval(&p.x, p.p, &mut r, Some(&mut j), None).unwrap();
        let e = st.exponents(&mut b, &p.x, p.p).unwrap();
        kinds[e.method as usize] += 1;
        if e.stable() != prev {
            println!("change at {} {:?}", p.p, e);
        }
        prev = e.stable();
    }
    println!("stability {kinds:?} in {:?}", t.elapsed());
    for s in &branch.specials {
        println!("{:?} {:.10} {:?} {:?}", s.kind, s.point.p, s.status, s.fold);
    }
}
