//! A map of basins of the planar balancer with two balls on one core: starts per second, what a map of 1000 by 1000 takes, and how many of 1000 random starts
//! end elsewhere when every motion is followed to its end by the same steps: beside a border balls move without order first, and other steps lead elsewhere.
//!
//! `cargo bench -p laval --bench basins -- 200` computes 200 by 200 starts (the default); 1000 computes the whole map.

#[path = "common/clock.rs"]
mod clock;
#[path = "common/processor.rs"]
mod processor;

use clock::clock;
use laval::file::load;
use laval::outcome::{Data, Outcome};
use laval::study::Context;
use laval_num::sampling::Points;
use processor::processor;

/// Half the width of the map, rad.
const SIDE: f64 = 3.1;
/// Starts followed to their ends for comparison.
const RANDOM: usize = 1000;

fn machine(speed: f64, from: [f64; 2], to: [f64; 2], points: usize, more: &str) -> String {
    let ends = |x: [f64; 2]| format!("{{ \"ring.ball_1\" = \"{:.12} rad\", \"ring.ball_2\" = \"{:.12} rad\" }}", x[0], x[1]);
    format!(
        "[machine]\nname = \"planar\"\nspeed = {speed}\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 1\neccentricity = 0.01\n\
         [[part]]\nkind = \"shaft_lumped\"\nname = \"shaft\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1\n\
         [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 0.02\n\
         [[part]]\nkind = \"balancer_ball\"\nname = \"ring\"\non = \"disc\"\nballs = 2\nbody_tilt = false\ngravity = 0\nball_mass = 0.05\n\
         track_radius = 1\ndrag = 0.0005\n[[study]]\nkind = \"basins\"\nfrom = {}\nto = {}\npoints = {points}\n{more}\n",
        ends(from),
        ends(to)
    )
}

fn run(text: &str) -> Option<Outcome> {
    let loaded = load(text).map_err(|d| println!("{d:?}")).ok()?;
    loaded.studies.first()?.study.run(&loaded.system, &Context::quiet("basins")).map_err(|d| println!("{d:?}")).ok()
}

/// What every cell ends in, without the numbers that tell ends of one kind apart.
fn kinds(o: &Outcome) -> Vec<String> {
    let column = o.find_table("cells").and_then(|t| t.column("end"));
    let Some(Data::Text(words)) = column.map(|c| &c.data) else { return vec![] };
    words.iter().map(|w| w.split(" (").next().unwrap_or_default().to_string()).collect()
}

fn bench(side: usize, speed: f64) -> Option<()> {
    let begin = clock();
    let map = run(&machine(speed, [-SIDE; 2], [SIDE; 2], side, ""))?;
    let spent = clock() - begin;
    let cells = side * side;
    println!(
        "speed {speed}: {cells} starts in {spent:.1} s of one core, {:.0} starts/s: 1000 by 1000 in {:.1} min",
        cells as f64 / spent,
        1e6 / cells as f64 * spent / 60.0
    );
    map.findings.iter().for_each(|f| println!("    {}", f.sentence()));
    let ends = kinds(&map);
    if ends.len() != cells {
        return None;
    }
    // cells at random, each followed to its end beside the cell to its right and above
    let (mut wrong, mut unlike) = (0, 0);
    let mut followed = 0.0;
    for k in 0..RANDOM as u32 {
        let at = |d| ((Points::Random.at(5, k, d) * (side - 1) as f64) as usize).min(side - 2);
        let (i, j) = (at(0), at(1));
        let x = |i: usize| -SIDE + 2.0 * SIDE * i as f64 / (side - 1) as f64;
        let begin = clock();
        let o = run(&machine(speed, [x(i), x(j)], [x(i + 1), x(j + 1)], 2, "recognise = \"never\""))?;
        followed += clock() - begin;
        let full = kinds(&o);
        if full.first()? != &ends[j * side + i] {
            wrong += 1;
            let around = (0..9).map(|n| ((i + n % 3).saturating_sub(1), (j + n / 3).saturating_sub(1)));
            let border = around.into_iter().any(|(a, b)| ends[b * side + a] != ends[j * side + i]);
            unlike += usize::from(!border);
            println!("    {:.4} {:.4}: {} in the map, {} followed", x(i), x(j), ends[j * side + i], full[0]);
        }
    }
    println!(
        "    of {RANDOM} random starts followed to their ends {wrong} end elsewhere, {unlike} of them with no neighbour that does ({followed:.0} s)"
    );
    Some(())
}

fn main() {
    let side: usize = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(200).max(3);
    println!("processor: {}", processor());
    let Ok(one) = rayon::ThreadPoolBuilder::new().num_threads(1).build() else { return println!("no thread") };
    one.install(|| {
        for speed in [2.0, 2.5, 3.0] {
            if bench(side, speed).is_none() {
                return println!("no map at speed {speed}");
            }
        }
    });
}
