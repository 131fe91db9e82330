//! A map of basins of the planar balancer with two balls on one core: starts per second, what a map of 1000 by 1000 takes, and how many of 1000 random starts
//! end elsewhere when they are followed to their ends by the same steps: beside a border balls move without order first, and other steps lead elsewhere.
//!
//! `cargo bench --workspace --bench basins -- 200` computes 200 by 200 starts (the default); 1000 computes the whole map. A speed behind it computes that alone.

#[path = "common/allocator.rs"]
mod allocator;

#[path = "common/clock.rs"]
mod clock;
#[path = "common/processor.rs"]
mod processor;
#[path = "common/row.rs"]
mod row;

use clock::clock;
use laval::file::load;
use laval::outcome::Outcome;
use laval::study::{Context, Progress};
use processor::processor;
use row::row;
use std::sync::{Mutex, PoisonError};

/// Half the width of the map, rad.
const SIDE: f64 = 3.1;
/// Turns after which a motion counts as not settled.
const MOST: usize = 2000;
/// Starts followed to their ends for comparison.
const RANDOM: usize = 1000;

fn machine(speed: f64, points: usize) -> String {
    let ends = |x: f64| format!("{{ \"ring.ball_1\" = \"{x} rad\", \"ring.ball_2\" = \"{x} rad\" }}");
    format!(
        "[machine]\nname = \"planar\"\nspeed = {speed}\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 1\neccentricity = 0.01\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 0.02\n\
         [[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"disc\"\nballs = 2\nbody_tilt = false\ngravity = 0\nball_mass = 0.05\n\
         track_radius = 1\ndrag = 0.0005\n[[study]]\nkind = \"basins\"\nfrom = {}\nto = {}\npoints = {points}\ncheck = {RANDOM}\nmost_periods = {MOST}\n",
        ends(-SIDE),
        ends(SIDE)
    )
}

fn run(text: &str, progress: &dyn Progress) -> Option<Outcome> {
    let loaded = load(text).map_err(|d| println!("{d:?}")).ok()?;
    let context = Context { progress, ..Context::quiet("basins") };
    loaded.studies.first()?.study.run(&loaded.system, &context).map_err(|d| println!("{d:?}")).ok()
}

/// Notes when the last cell of a map was done.
struct Notes {
    cells: u64,
    at: Mutex<Option<f64>>,
}

impl Progress for Notes {
    fn report(&self, done: u64, total: u64) {
        if done == total && total == self.cells {
            self.at.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert_with(clock);
        }
    }
}

fn bench(side: usize, speed: f64) -> Option<()> {
    let cells = side * side;
    let notes = Notes { cells: cells as u64, at: Mutex::new(None) };
    let begin = clock();
    let map = run(&machine(speed, side), &notes)?;
    let spent = (*notes.at.lock().ok()?)? - begin;
    let steps = map.work.get("steps").map_or(f64::NAN, |n| *n as f64);
    row(&format!("basins, {cells} starts, speed {speed}"), spent, None);
    println!(
        "speed {speed}: {cells} starts in {spent:.1} s of one core, {:.0} starts/s: 1000 by 1000 in {:.1} min; {:.0} steps a start ({:.0} s for the comparison)",
        cells as f64 / spent,
        1e6 / cells as f64 * spent / 60.0,
        steps / cells as f64,
        clock() - begin - spent
    );
    map.findings.iter().for_each(|f| println!("    {}", f.sentence()));
    Some(())
}

fn main() {
    let side: usize = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(200).max(3);
    let requested: Vec<f64> = std::env::args().filter_map(|a| a.parse().ok()).skip(1).collect();
    let speeds = if requested.is_empty() { vec![2.0, 2.5, 3.0] } else { requested };
    println!("processor: {}", processor());
    let Ok(one) = rayon::ThreadPoolBuilder::new().num_threads(1).build() else { return println!("no thread") };
    one.install(|| {
        for speed in speeds {
            if bench(side, speed).is_none() {
                return println!("no map at speed {speed}");
            }
        }
    });
}
