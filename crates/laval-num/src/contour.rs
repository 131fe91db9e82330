//! Zeros of an analytic function in a rectangle, all of them: counted by the argument principle, found by Newton's method.
//!
//! The function is known by its phase and its logarithmic derivative `f'/f`, so that values may be scaled by any positive factor. Zeros already known are
//! divided out, which makes the rest turn slowly; what the phase still turns by around the rectangle is the number of zeros that are missing,
//!
//! ```text
//! 1/(2 pi i) closed integral of ( f'/f - sum 1/(s - known) ) ds = zeros inside - known inside.
//! ```
//!
//! A step from a to b is taken only when `|b - a| |f'/f|` is small at both ends and the change of the phase agrees with the integral of `f'/f`: a zero closer
//! to the path than two thirds of the step spoils the first. A zero beside a pole on the other side of the path hides from afar: `Region::reach` must keep steps below the
//! distance of such poles.
//!
//! Source: L. M. Delves, J. N. Lyness, A numerical method for locating the zeros of an analytic function, Math. Comp. 21 (1967) 543-560.

use crate::complex::{C64, c};
use crate::dense::Field;
use crate::work::spend;
use std::f64::consts::{PI, TAU};

/// A function at one place.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Phase of f.
    pub phase: f64,
    /// `f'/f`.
    pub rate: C64,
}

/// A function that zeros are counted of. Every closure of a place is one.
pub trait Function {
    /// At so many places together it costs about as much as at one.
    fn together(&self) -> usize {
        1
    }
    /// Appends the function at every place; `None` where it is not known.
    fn at(&mut self, places: &[C64], out: &mut Vec<Option<Sample>>);
}

impl<F: FnMut(C64) -> Option<Sample>> Function for F {
    fn at(&mut self, places: &[C64], out: &mut Vec<Option<Sample>>) {
        out.extend(places.iter().map(|&s| self(s)));
    }
}

/// Where zeros are looked for.
pub struct Region<'a> {
    /// Range of the real part.
    pub re: (f64, f64),
    /// Range of the imaginary part.
    pub im: (f64, f64),
    /// `f(conj s) = conj f(s)`, and the region is this rectangle together with its mirror image below the real axis; `im` begins at 0.
    pub mirrored: bool,
    /// Longest step at a place.
    pub reach: &'a dyn Fn(C64) -> f64,
    /// Relative error of the places of zeros that the error of f makes, at most.
    pub noise: f64,
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// Zeros in the region, those given included; of a mirrored region the lower half is left out.
    pub zeros: Vec<C64>,
    /// Zeros that the count says are missing: 0 is proof that there are no others. `None` where the phase could not be followed.
    pub missing: Option<i64>,
    /// Evaluations of the function.
    pub evaluations: u64,
}

/// Largest `|step| |f'/f|` at the ends of a step.
const TURN: f64 = 1.2;
/// Largest difference between the change of the phase and the integral of `f'/f` over a step.
const AGREE: f64 = 0.25;
/// The count must be a whole number to this.
const WHOLE: f64 = 1e-3;
/// Noise of a function that is computed to rounding.
pub const NOISE: f64 = 1e-10;
/// Factors between 0.7 and 1 in size whose product is computed without scaling.
const PRODUCT: usize = 32;
/// Places on the edge of a cell that zeros are looked for from, at most.
const BESIDE: usize = 12;
/// Shortest step over the size of the path.
const SHORTEST: f64 = 1e-14;
/// Most pieces of a step that is divided.
const PIECES: f64 = 16.0;
/// Deepest subdivision.
const DEPTH: usize = 40;
/// Where a rectangle may be cut: not in the middle, which of a rectangle about the imaginary axis is that axis with the roots that nothing damps.
const CUTS: [f64; 6] = [0.4370, 0.5630, 0.3810, 0.6190, 0.4720, 0.5310];

struct Search<'a, F> {
    f: F,
    mirrored: bool,
    reach: &'a dyn Fn(C64) -> f64,
    noise: f64,
    known: Vec<C64>,
    evaluations: u64,
    budget: u64,
    /// Places on the path followed last, with the size of `f'/f` there.
    path: Vec<(C64, f64)>,
    /// Evaluated last, in order.
    samples: Vec<Option<Sample>>,
}

/// A rectangle; `half` when it stands for itself and its mirror image.
#[derive(Clone, Copy, Debug)]
struct Cell {
    re: (f64, f64),
    im: (f64, f64),
    half: bool,
}

impl Cell {
    fn holds(&self, s: C64) -> bool {
        let im = if self.half { s.im.abs() } else { s.im };
        s.re > self.re.0 && s.re < self.re.1 && (im > self.im.0 || self.half) && im < self.im.1
    }
    fn place(&self, u: f64, v: f64) -> C64 {
        c(self.re.0 + u * (self.re.1 - self.re.0), self.im.0 + v * (self.im.1 - self.im.0))
    }
    fn cut(&self, at: f64) -> [Cell; 2] {
        let (width, height) = (self.re.1 - self.re.0, self.im.1 - self.im.0);
        if width > height {
            let x = self.re.0 + at * width;
            [Cell { re: (self.re.0, x), ..*self }, Cell { re: (x, self.re.1), ..*self }]
        } else {
            let y = self.im.0 + at * height;
            [Cell { im: (self.im.0, y), ..*self }, Cell { im: (y, self.im.1), half: false, ..*self }]
        }
    }
}

/// All zeros of `f` in a region, beginning with some that are known (exactly, to rounding); at most `budget` evaluations.
pub fn zeros<F: Function>(f: F, region: &Region, known: &[C64], budget: u64) -> Found {
    let whole = Cell { re: region.re, im: region.im, half: region.mirrored };
    let mut search = Search::over(f, region, known, budget);
    let mut missing = search.missing(&whole);
    if let Some(n) = missing
        && n > 0
    {
        search.find(&whole, n, 0);
        missing = search.missing(&whole);
    }
    let own = |z: &&C64| whole.holds(**z) && (!region.mirrored || z.im >= 0.0);
    let zeros = search.known.iter().filter(own).copied().collect();
    Found { zeros, missing, evaluations: search.evaluations }
}

/// The number of zeros in a region that are not among the known ones, and the evaluations it took.
pub fn missing<F: Function>(f: F, region: &Region, known: &[C64], budget: u64) -> (Option<i64>, u64) {
    let whole = Cell { re: region.re, im: region.im, half: region.mirrored };
    let mut search = Search::over(f, region, known, budget);
    let missing = search.missing(&whole);
    (missing, search.evaluations)
}

/// By how much the phase of a function turns along a path, its steps limited as those around a [`Region`]; `None` where it could not be followed.
pub fn turned<F: Function>(f: F, path: &[C64], reach: &dyn Fn(C64) -> f64, budget: u64) -> Option<f64> {
    Search::new(f, reach, budget).turned(path)
}

/// A zero by Newton's method from a start, steps no longer than half of `size`, with zeros already known divided out.
pub fn newton<F: Function>(f: F, start: C64, size: f64, known: &[C64]) -> Option<C64> {
    let mut search = Search { known: known.to_vec(), ..Search::new(f, &|_| f64::INFINITY, 1000) };
    search.newton(start, size)
}

/// Places between two others that divide the way into so many pieces.
fn divide((a, b): (C64, C64), pieces: usize, nodes: &mut Vec<(C64, Option<Sample>)>) {
    nodes.extend((1..pieces).map(|k| (a + (b - a).scale(k as f64 / pieces as f64), None)));
}

/// A number of moderate size and the same angle.
fn direction(z: C64) -> C64 {
    z.scale(1.0 / z.size())
}

impl<'a, F: Function> Search<'a, F> {
    fn new(f: F, reach: &'a dyn Fn(C64) -> f64, budget: u64) -> Self {
        Search { f, mirrored: false, reach, noise: NOISE, known: Vec::new(), evaluations: 0, budget, path: Vec::new(), samples: Vec::new() }
    }

    fn over(f: F, region: &Region<'a>, known: &[C64], budget: u64) -> Self {
        let mut search = Search { mirrored: region.mirrored, noise: region.noise, ..Search::new(f, region.reach, budget) };
        known.iter().for_each(|&z| search.add(z));
        search
    }

    fn add(&mut self, z: C64) {
        self.known.push(z);
        if self.mirrored && z.im != 0.0 {
            self.known.push(z.conj());
        }
    }

    /// f with the known zeros divided out: phase as it is, rate without them.
    fn at(&mut self, s: C64) -> Option<Sample> {
        self.evaluate(&[s]);
        self.samples.first().copied().flatten()
    }

    /// The same at some places, into `samples`; `None` beyond the budget.
    fn evaluate(&mut self, places: &[C64]) {
        self.samples.clear();
        let left = usize::try_from(self.budget.saturating_sub(self.evaluations)).unwrap_or(usize::MAX);
        let places = &places[..places.len().min(left)];
        self.evaluations += places.len() as u64;
        spend((100 + 30 * self.known.len() as u64) * places.len() as u64);
        self.f.at(places, &mut self.samples);
        for (s, sample) in places.iter().zip(&mut self.samples) {
            if let Some(known) = sample {
                for z in &self.known {
                    known.rate -= (*s - *z).recip();
                }
                if !(known.rate.is_finite() && known.phase.is_finite()) {
                    *sample = None;
                }
            }
        }
    }

    /// Zeros of a cell that are not known.
    fn missing(&mut self, cell: &Cell) -> Option<i64> {
        let ((a, b), (low, high)) = (cell.re, cell.im);
        let path = if cell.half {
            vec![c(b, 0.0), c(b, high), c(a, high), c(a, 0.0)]
        } else {
            vec![c(b, low), c(b, high), c(a, high), c(a, low), c(b, low)]
        };
        let turns = self.turned(&path)? / if cell.half { PI } else { TAU };
        ((turns - turns.round()).abs() < WHOLE * if cell.half { 2.0 } else { 1.0 }).then(|| turns.round() as i64)
    }

    /// Change of the phase along a path.
    fn turned(&mut self, path: &[C64]) -> Option<f64> {
        if self.f.together() > 1 {
            return self.turned_together(path);
        }
        let mut here = self.at(*path.first()?)?;
        self.path.clear();
        let mut total = 0.0;
        for side in path.windows(2) {
            let (mut s, end) = (side[0], side[1]);
            let mut step = f64::INFINITY;
            while s != end {
                let rest = (end - s).abs();
                let length = step.min((self.reach)(s)).min(0.9 * TURN / here.rate.abs()).min(rest);
                if !(length > SHORTEST * s.abs().max(rest)) {
                    return None;
                }
                let next = if length >= rest { end } else { s + (end - s).scale(length / rest) };
                let there = self.at(next)?;
                match self.turn((s, here), (next, there)) {
                    Some(turn) => {
                        total += turn;
                        self.path.push((next, there.rate.abs()));
                        (s, here) = (next, there);
                        step = 2.0 * length;
                    }
                    None => step = 0.4 * length,
                }
            }
        }
        Some(total)
    }

    /// The same of a function that costs little more at many places than at one: steps that are too long are divided, all of them together.
    fn turned_together(&mut self, path: &[C64]) -> Option<f64> {
        let whole: f64 = path.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
        let share = whole / self.f.together() as f64;
        let mut nodes: Vec<(C64, Option<Sample>)> = vec![(*path.first()?, None)];
        for side in path.windows(2) {
            divide((side[0], side[1]), (((side[1] - side[0]).abs() / share).round() as usize).max(1), &mut nodes);
            nodes.push((side[1], None));
        }
        loop {
            let open: Vec<C64> = nodes.iter().filter(|n| n.1.is_none()).map(|n| n.0).collect();
            self.evaluate(&open);
            let mut samples = self.samples.drain(..);
            for node in nodes.iter_mut().filter(|n| n.1.is_none()) {
                node.1 = Some(samples.next().flatten()?);
            }
            drop(samples);
            let mut next = vec![nodes[0]];
            let mut total = 0.0;
            for pair in nodes.windows(2) {
                let ((a, Some(here)), (b, Some(there))) = (pair[0], pair[1]) else { return None };
                let length = (b - a).abs();
                let reach = (self.reach)(a).min((self.reach)(b));
                let turn = if length <= reach { self.turn((a, here), (b, there)) } else { None };
                match turn {
                    Some(turn) => total += turn,
                    None => {
                        if !(length > SHORTEST * a.abs().max(whole)) {
                            return None;
                        }
                        let rate = here.rate.abs().max(there.rate.abs());
                        let pieces = (length * rate / (0.9 * TURN)).max(length / reach).ceil().clamp(2.0, PIECES) as usize;
                        divide((a, b), pieces, &mut next);
                    }
                }
                next.push(pair[1]);
            }
            if next.len() == nodes.len() {
                self.path = nodes.iter().filter_map(|n| Some((n.0, n.1?.rate.abs()))).collect();
                return Some(total);
            }
            nodes = next;
        }
    }

    /// By how much the phase turns over a step, zeros already known divided out; `None` where the step is too long to tell.
    fn turn(&self, (s, here): (C64, Sample), (next, there): (C64, Sample)) -> Option<f64> {
        let way = next - s;
        // of the sum of their angles only the rest after whole turns is needed: that of the product
        let angle = |some: &[C64]| some.iter().fold(C64::ONE, |all, z| all * direction((next - *z) * (s - *z).conj()));
        let known = self.known.chunks(PRODUCT).fold(C64::ONE, |all, some| direction(all * angle(some))).arg();
        let turn = there.phase - here.phase - known;
        let turn = turn - TAU * (turn / TAU).round();
        let expected = (way * (here.rate + there.rate)).im * 0.5;
        let short = way.abs() * here.rate.abs().max(there.rate.abs()) <= TURN;
        (short && (turn - expected).abs() <= AGREE).then_some(turn)
    }

    /// Newton's method with the known zeros divided out.
    fn newton(&mut self, start: C64, size: f64) -> Option<C64> {
        let (mut s, mut last) = (start, f64::INFINITY);
        for _ in 0..40 {
            // exactly on a zero nothing can be divided by the value
            let Some(here) = self.at(s) else { return (last <= self.noise * s.abs()).then_some(s) };
            let step = here.rate.recip();
            let length = step.abs();
            // far from a zero the quotient points anywhere
            let step = if length > 0.5 * size { step.scale(0.5 * size / length) } else { step };
            if !step.is_finite() {
                return None;
            }
            s -= step;
            if length <= 1e-13 * s.abs().max(1e-3 * size) || (length >= 0.5 * last && length <= self.noise * s.abs()) {
                return Some(s);
            }
            last = length;
        }
        None
    }

    /// Places on the path followed last that a zero may be near: where `f'/f` is larger than before and after, the largest first.
    fn beside_the_path(&self) -> Vec<C64> {
        let mut peaks: Vec<(C64, f64)> = self.path.windows(3).filter(|w| w[1].1 > w[0].1 && w[1].1 >= w[2].1).map(|w| w[1]).collect();
        peaks.sort_by(|a, b| b.1.total_cmp(&a.1));
        peaks.truncate(BESIDE);
        peaks.into_iter().map(|p| p.0).collect()
    }

    /// Looks for the zeros that are missing in a cell whose edge was followed last.
    fn find(&mut self, cell: &Cell, missing: i64, depth: usize) {
        let mut left = missing;
        let size = (cell.re.1 - cell.re.0).hypot(cell.im.1 - cell.im.0);
        let inside = [(0.5, 0.5), (0.2, 0.3), (0.2, 0.8), (0.8, 0.3), (0.8, 0.7), (0.05, 0.5)].map(|(u, v)| cell.place(u, v));
        for start in self.beside_the_path().into_iter().chain(inside) {
            while left > 0 {
                let Some(mut z) = self.newton(start, size) else { break };
                if self.mirrored && z.im.abs() <= self.noise.max(1e-10) * z.re.abs() {
                    z.im = 0.0;
                }
                if self.mirrored && cell.half && z.im < 0.0 {
                    z = z.conj();
                }
                let inside = cell.holds(z);
                self.add(z);
                if !inside {
                    break;
                }
                left -= if cell.half && z.im != 0.0 { 2 } else { 1 };
            }
        }
        if left <= 0 || depth >= DEPTH {
            return;
        }
        for at in CUTS {
            let pieces = cell.cut(at);
            let f = self.missing(&pieces[0]);
            let Some(first) = f else { continue };
            let f = self.missing(&pieces[1]);
            let Some(second) = f else { continue };
            for (piece, n) in pieces.iter().zip([first, second]) {
                if n > 0 {
                    // zeros found meanwhile may lie here
                    match self.missing(piece) {
                        Some(n) if n > 0 => self.find(piece, n, depth + 1),
                        _ => {}
                    }
                }
            }
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rational function by its zeros and poles.
    fn rational(zeros: Vec<C64>, poles: Vec<C64>) -> impl FnMut(C64) -> Option<Sample> {
        move |s| {
            let mut out = Sample { phase: 0.0, rate: C64::zero() };
            for (list, sign) in [(&zeros, 1.0), (&poles, -1.0)] {
                for z in list {
                    out.phase += sign * (s - *z).arg();
                    out.rate += (s - *z).recip().scale(sign);
                }
            }
            Some(out)
        }
    }

    fn free(_: C64) -> f64 {
        f64::INFINITY
    }

    fn matches(mut found: Vec<C64>, should: &[C64], tolerance: f64) {
        assert_eq!(found.len(), should.len(), "{found:?} {should:?}");
        for z in should {
            let near = (0..found.len()).min_by(|&a, &b| (found[a] - *z).abs().total_cmp(&(found[b] - *z).abs())).unwrap();
            assert!((found[near] - *z).abs() < tolerance, "{:?} {z:?}", found[near]);
            found.remove(near);
        }
    }

    #[test]
    fn finds_all_zeros_of_a_rectangle() {
        let inside = vec![c(0.3, 0.2), c(0.3, 0.2002), c(0.01, -0.8), c(0.9, 0.95), c(0.5, -0.5), c(1e-4, 0.1)];
        let outside = [c(-1e-4, 0.3), c(1.5, 0.0), c(-0.4, 0.2)];
        let all = inside.iter().chain(&outside).copied().collect();
        let poles = vec![c(-1e-3, 0.25), c(-0.2, -0.4)];
        let region = Region { re: (0.0, 1.0), im: (-1.0, 1.0), mirrored: false, reach: &free, noise: NOISE };
        let found = zeros(rational(all, poles), &region, &[], 1_000_000);
        assert_eq!(found.missing, Some(0));
        matches(found.zeros, &inside, 1e-9);
    }

    /// `sinh(s) + s/2 - 1`, which has no poles and infinitely many zeros; by its conjugate symmetry half the path is enough.
    #[test]
    fn half_the_path_of_a_real_function() {
        let f = |s: C64| {
            let (up, down) = (s.exp(), (-s).exp());
            let value = (up - down).scale(0.5) + s.scale(0.5) - C64::one();
            Some(Sample { phase: value.arg(), rate: ((up + down).scale(0.5) + c(0.5, 0.0)) / value })
        };
        let region = Region { re: (-4.0, 4.0), im: (0.0, 30.0), mirrored: true, reach: &free, noise: NOISE };
        let half = zeros(f, &region, &[], 1_000_000);
        assert_eq!(half.missing, Some(0));
        let whole = zeros(f, &Region { im: (-30.0, 30.0), mirrored: false, ..region }, &[], 1_000_000);
        assert_eq!(whole.missing, Some(0));
        let upper: Vec<C64> = whole.zeros.iter().filter(|z| z.im > -1e-9).copied().collect();
        assert!(upper.len() > 5 && whole.zeros.len() == 2 * upper.len() - 1);
        matches(half.zeros, &upper, 1e-8);
        for z in upper {
            let value = (z.exp() - (-z).exp()).scale(0.5) + z.scale(0.5) - C64::one();
            assert!(value.abs() < 1e-10 * z.exp().abs().max(1.0), "{z:?} {value:?}");
        }
    }

    /// A cut above the axis leaves a mirrored piece and one that stands for itself; a cut across it two mirrored ones.
    #[test]
    fn pieces_hold_what_the_whole_holds() {
        let all = [c(0.3, 0.2), c(0.6, 0.9), c(0.8, 0.0), c(0.1, 1.7)];
        let f = rational(all.iter().flat_map(|z| if z.im == 0.0 { vec![*z] } else { vec![*z, z.conj()] }).collect(), vec![]);
        let mut search = Search { mirrored: true, ..Search::new(f, &free, 100_000) };
        let tall = Cell { re: (0.0, 1.0), im: (0.0, 2.0), half: true };
        let flat = Cell { re: (0.0, 1.0), im: (0.0, 0.95), half: true };
        let [low, high] = tall.cut(0.5);
        let [left, right] = flat.cut(0.5);
        let counts = [tall, low, high, flat, left, right].map(|c| search.missing(&c));
        assert_eq!(counts, [7, 5, 1, 5, 2, 3].map(Some));
    }

    #[test]
    fn a_false_zero_is_reported() {
        let f = || rational(vec![c(0.5, 0.5)], vec![]);
        let region = Region { re: (0.0, 1.0), im: (0.0, 1.0), mirrored: false, reach: &free, noise: NOISE };
        assert_eq!(missing(f(), &region, &[c(0.5, 0.5)], 1000).0, Some(0));
        assert_eq!(missing(f(), &region, &[c(0.5, 0.5), c(0.2, 0.2)], 1000).0, Some(-1));
        assert_eq!(missing(f(), &region, &[], 1000).0, Some(1));
        // on the path there is no count
        assert_eq!(missing(rational(vec![c(0.0, 0.5)], vec![]), &region, &[], 10_000).0, None);
        assert_eq!(missing(|_: C64| None, &region, &[], 1000).0, None);
        assert_eq!(missing(f(), &region, &[], 3).0, None);
    }

    struct Together<F>(F);

    impl<F: FnMut(C64) -> Option<Sample>> Function for Together<F> {
        fn together(&self) -> usize {
            8
        }
        fn at(&mut self, places: &[C64], out: &mut Vec<Option<Sample>>) {
            assert!(!places.is_empty());
            out.extend(places.iter().map(|&s| (self.0)(s)));
        }
    }

    /// Steps that are divided together count what steps one after the other count, also close to the path, and where steps are limited.
    #[test]
    fn many_places_together() {
        let mut seed = 9u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        for mirrored in [false, true] {
            for _ in 0..300 {
                // some of them close to an edge, on either side
                let mut all: Vec<C64> = (0..12).map(|_| c(2.0 * random() - 0.5, 4.0 * random() - 2.0)).collect();
                all.extend((0..3).map(|_| c(1.0 + 1e-4 * (random() - 0.5), 1.8 * random())));
                if mirrored {
                    let upper: Vec<C64> = all.iter().filter(|z| z.im > 0.0).copied().collect();
                    all = upper.iter().flat_map(|&z| [z, z.conj()]).collect();
                }
                let known: Vec<C64> = all.iter().filter(|z| !mirrored || z.im > 0.0).take(4).copied().collect();
                let im = if mirrored { (0.0, 1.5) } else { (-1.5, 1.5) };
                let region = Region { re: (0.0, 1.0), im, mirrored, reach: &|s| 0.2 + 0.1 * s.abs(), noise: NOISE };
                let (count, _) = missing(rational(all.clone(), vec![]), &region, &known, 100_000);
                let (other, evaluations) = missing(Together(rational(all.clone(), vec![])), &region, &known, 100_000);
                assert!(count.is_some() && count == other, "{count:?} {other:?} {evaluations}");
            }
        }
        let f = rational(vec![c(0.5, 0.5)], vec![]);
        let region = Region { re: (0.0, 1.0), im: (0.0, 1.0), mirrored: false, reach: &free, noise: NOISE };
        assert_eq!(missing(Together(f), &region, &[], 3).0, None);
        assert_eq!(missing(Together(|_: C64| None), &region, &[], 1000).0, None);
        // on the path there is no count
        assert_eq!(missing(Together(rational(vec![c(0.0, 0.5)], vec![])), &region, &[], 100_000).0, None);
    }

    /// Zeros just inside beside poles just outside: with steps of the distance of the poles none hides, wherever the two lie.
    #[test]
    fn zeros_beside_poles() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let margin = 1e-3;
        let reach = move |s: C64| if s.re < 2.0 * margin { 1.8 * margin } else { f64::INFINITY };
        for _ in 0..2000 {
            let place = random();
            let zero = c(margin * (1.0 + 3.0 * random().powi(2)), place);
            let pole = c(0.0, place + 10f64.powf(3.0 * random()) * margin * (random() - 0.5));
            let region = Region { re: (margin, 1.0), im: (-1.0, 2.0), mirrored: false, reach: &reach, noise: NOISE };
            let (count, _) = missing(rational(vec![zero], vec![pole]), &region, &[], 100_000);
            assert_eq!(count, Some(1), "{zero:?} {pole:?}");
            // a single pole whose place is known: steps that shrink towards it
            let (near, place) = (1e-6, pole.im);
            let region = Region { re: (near, 1.0), reach: &|s| 0.5 * s.re.abs().hypot(s.im - place), ..region };
            let (count, _) = missing(rational(vec![zero], vec![pole]), &region, &[], 100_000);
            assert_eq!(count, Some(1), "{zero:?} {pole:?}");
        }
    }
}
