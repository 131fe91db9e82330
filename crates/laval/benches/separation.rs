//! A powder of one million particles with distributed sizes through a swinging cup at constant speed, on one core: exact motion with inertia, first exit
//! of each by bracketing. Prints the time on the processor and checks the share caught against the exact sum over sizes.
//!
//! `nice -n -19 taskset -c 0 cargo bench --workspace --bench separation`

#[path = "common/allocator.rs"]
mod allocator;

#[path = "common/clock.rs"]
mod clock;
#[path = "common/processor.rs"]
mod processor;
#[path = "common/row.rs"]
mod row;

// studies may work on threads of their own
use clock::all_threads as clock;
use laval::separation::cup::{Hanging, SwingingCup};
use laval::separation::exit::Cylinder;
use laval::separation::law::Law;
use laval::separation::particle::Medium;
use laval::separation::separator::{Cup, Separator};
use laval::separation::suspension::{Model, Powder, leave, members, powder_efficiency, products};
use processor::processor;
use row::row;

fn main() {
    let n = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(1_000_000);
    let cup = Cup {
        hanging: SwingingCup { hinge: 0.08, body: Hanging::point(1.0, 0.06), damping: 0.0, gravity: 9.80665 },
        vessel: Cylinder { radius: 0.014, bottom: 0.1, top: 0.0 },
        held: None,
    };
    let turning = Separator::Cup(cup).at(3000.0 * std::f64::consts::PI / 30.0);
    let medium = Medium::new(998.2, 1.002e-3);
    let size = Law::LogNormal { median: 5e-6, gsd: 2.0 };
    let powder = Powder { size: size.clone(), density: Law::Single(2650.0) };
    println!("processor: {}", processor());
    let crowd = members(&turning, n);
    for (name, model) in [("with inertia", Model::Inertial), ("without inertia", Model::Drifting)] {
        let start = clock();
        let mut caught = 0usize;
        for m in &crowd {
            let exit = leave(&turning, &medium, &powder.particle(&m.point), m, model);
            caught += usize::from(exit.is_some_and(|e| e.time <= 10.0));
        }
        let seconds = clock() - start;
        row(&format!("{n} particles {name}"), seconds, None);
        println!(
            "{n} particles {name}, one core: {seconds:.2} s of processor, {:.2} us each; caught in 10 s: {}",
            1e6 * seconds / n as f64,
            caught as f64 / n as f64
        );
    }
    let few = members(&turning, 4096.min(n));
    let taus: Vec<f64> = products(&turning, &few, 1.0).into_iter().flatten().map(|p| p.0).collect();
    println!("exact sum over sizes, {} places: {}", taus.len(), powder_efficiency(&taus, &medium, &size, 2650.0, 10.0));
}
