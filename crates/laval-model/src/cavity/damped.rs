//! Time form of the tilt reaction of a viscous liquid at one speed: a finite sum over waves that die out.
//!
//! As for the [ideal liquid](super::waves), with what viscosity takes from a flow, `N = nu/W`:
//!
//! ```text
//! Lt = pi rho { -w (w - 2 W) [R^2 H^3/12 - H (R^4 - r0^4)/4] + 2 R^2 w (w - W) sum c_k - w^2 x sum c_k b^T (x E - A - i N D)^-1 b },   b = (2 d + r0^2 e, -r0^2)
//! D = int { 2 [u' u' + (u + v)^2/r^2 + kappa^2 z z] + (v' - (u + v)/r)^2 + (z' - kappa u)^2 + (kappa v + z/r)^2 } r dr
//! ```
//!
//! over flows that rest at the wall, u, v and z, with free slip at the ends and at the surface. They are polynomials in t, `R - r = (R - r0) sinh(a t)/sinh(a)`, which is
//! fine where the layer at the wall is. Of the thousands of waves that come of it a few are made: the flows are taken from the real span of what the liquid does at some
//! frequencies, all harmonics at once, and there the reaction of the few is that of all, with its slope. Frequencies are added where the error is largest.
//!
//! E and D are positive and stay so in every real span, hence whatever was left out all waves die out, the liquid takes energy at every frequency, and at `w = W` the form is
//! exact.
//!
//! The error is that of the few against all, on a grid closer than the narrowest wave and on lines where motions grow, and that of all against the exact reaction, at
//! even places and at the tops of waves, those of the first harmonic left out among them.
//!
//! Symbols as in [cavity](super) and [waves](super::waves).
//!
//! Theory: `docs/theory/liquid-in-three-dimensions.md#time-forms`.

use super::layer::{GROWTHS, Layer, Refused, TOPS};
use super::rational::{Rational, Wave};
use super::waves::{BAND, BETWEEN, MOST_HARMONICS, MOST_WAVES, largest, legendre};
use super::{Cavity, Truncation};
use laval_num::complex::{C64, c};
use laval_num::dense::Mat;
use laval_num::eig::{definite, modes};
use laval_num::order::{SortByNumber, ascending};
use laval_num::quadrature::gauss;
use std::f64::consts::PI;

/// Harmonics and polynomials that are tried, and the most of both together.
const HARMONICS: [usize; 3] = [21, 41, 81];
const TERMS: [usize; 4] = [32, 48, 64, 96];
const WORK: usize = 5200;
/// Width of the layer at the wall at the spin frequency, `sqrt(2 nu/W)`, over the scale of the polynomials there.
const LAYER: f64 = 25.0;
/// Even places along the band, and tops of waves, at which all waves are compared with the exact reaction.
const EVEN: usize = 161;
const STRONGEST: usize = 80;
/// Places at a wave, in its widths, where the few are compared with all; on the way, and in the end.
const COARSE: [f64; 4] = [0.0, 0.3, 1.0, 3.0];
const FINE: [f64; 8] = [0.0, 0.25, 0.5, 0.8, 1.2, 1.8, 3.0, 6.0];
/// Height over the accuracy below which a wave is not looked at by itself.
const LOW: f64 = 0.03;
/// Share of a new direction that is none.
const NOTHING: f64 = 1e-9;
/// Times that the few are made better where the fine grid finds more than the coarse one.
const AGAIN: usize = 6;

/// Share of the accuracy that the harmonics and polynomials left out may take, and the most of it where no more of them can be had.
const LEFT_OUT: [f64; 2] = [0.5, 0.8];
/// What is tried where the accuracy requested cannot be had: each so much larger than the one before, so many, up to the last.
const STEP: f64 = 1.25;
const TRIED: usize = 24;
const LOOSEST: f64 = 0.1;

/// Waves of one harmonic.
struct Harmonic {
    /// `c_k`.
    factor: f64,
    /// Frequencies without viscosity: A in coordinates in which E is one.
    places: Vec<f64>,
    /// D and b in these.
    drag: Mat,
    drive: Vec<f64>,
    waves: Vec<Damped>,
}

/// A wave `x_j` with its share `a_j` of the reaction and its flow, driven by b.
struct Damped {
    place: C64,
    share: C64,
    flow: Vec<C64>,
}

/// Places with the reaction of all waves and the size of errors there.
type Known = Vec<(C64, C64, f64)>;

impl Cavity<f64> {
    /// The reaction on tilt at this speed as a sum over waves, of which there are as many as the `accuracy` requires. `stop` is polled now and then.
    ///
    /// # Errors
    /// What it cannot be had for; of an accuracy out of reach a larger one, for which it can be had: that was tried.
    pub fn tilt_viscous_in_time(
        &self,
        speed: f64,
        nu: f64,
        truncation: Truncation,
        accuracy: f64,
        stop: &dyn Fn() -> bool,
    ) -> Result<Layer, Refused> {
        let nu = self.at_unit_speed(speed, nu)?;
        let mut search = Search { cavity: self, nu, truncation, stop, seen: Vec::new() };
        match search.at(accuracy) {
            Ok(layer) => Ok(layer.at_speed(speed)),
            Err(Refused::Accuracy { reached }) => {
                let enough = attainable(reached.max(STEP * accuracy), STEP, |a| search.at(a))?;
                Err(Refused::Accuracy { reached: enough })
            }
            Err(refused) => Err(refused),
        }
    }
    /// What an error at w is compared with, at speed 1.
    fn tilt_size(&self, w: C64, tilt: C64) -> f64 {
        tilt.abs() + self.mean_tilt(w, 1.0).abs()
    }

    /// Height of a wave on the real axis over the size of the reaction there.
    fn height(&self, wave: Wave, whole: &Rational) -> f64 {
        let w = c(1.0 + wave.place.re.clamp(-BAND, BAND), 0.0);
        wave.strength.abs() / wave.place.im * w.norm_sqr() / self.tilt_size(w, whole.at(w, 1.0))
    }

    /// The error of all waves, that against the same harmonics alone, and that of the exact reaction, at places that see where they are narrow.
    fn left_out(&self, whole: &Rational, next: &Harmonic, search: &Search, last: usize) -> Result<[f64; 3], Refused> {
        let Search { nu, truncation, stop, .. } = *search;
        let tops = |waves: &mut dyn Iterator<Item = Wave>, count: usize| {
            let inside = waves.filter(|w| w.place.re.abs() < BAND);
            let mut list: Vec<(f64, f64)> = inside.map(|w| (w.place.re, self.height(w, whole))).collect();
            list.sort_by_number_down(|a| a.1);
            list.truncate(count);
            list
        };
        let mut places: Vec<f64> = (0..EVEN).map(|i| BAND * (2.0 * i as f64 / (EVEN - 1) as f64 - 1.0) + 1e-4).collect();
        places.extend(tops(&mut whole.waves.iter().copied(), STRONGEST).iter().map(|x| x.0));
        if truncation == Truncation::None {
            let waves = next.waves.iter().map(|w| Wave { place: w.place, strength: w.share * w.place });
            places.extend(tops(&mut waves.into_iter(), STRONGEST / 4).iter().map(|x| x.0));
        }
        let axis = places.iter().map(|x| c(*x, 0.0));
        let growing = places.iter().step_by(4).zip(GROWTHS.iter().cycle()).map(|(x, g)| c(*x, -g));
        let mut worst = [0.0; 3];
        for x in axis.chain(growing).filter(|x| x.re.abs() <= BAND) {
            if stop() {
                return Err(Refused::Stopped);
            }
            let w = x + C64::one();
            let exact = self.tilt_viscous(w, 1.0, nu, truncation);
            let size = self.tilt_size(w, exact.value);
            worst[2] = largest(worst[2], exact.error / size);
            let is = whole.at(w, 1.0);
            let same = if truncation == Truncation::None { self.tilt_viscous(w, 1.0, nu, Truncation::At(last)).value } else { exact.value };
            for (worst, l) in worst.iter_mut().zip([exact.value, same]) {
                *worst = largest(*worst, (is - l).abs() / size);
            }
        }
        Ok(worst)
    }

    /// The reaction with these waves for those of the harmonics.
    fn summed_up(&self, all: &[Harmonic], waves: impl Iterator<Item = (C64, C64)>) -> Rational {
        let (mean, shell) = (self.mean(), 2.0 * self.radius * self.radius * all.iter().map(|h| h.factor).sum::<f64>());
        let mut total = 0.0;
        let waves = waves.map(|(place, share)| {
            total += share.re;
            Wave { place, strength: share * place }
        });
        let waves = waves.collect();
        Rational { inertia: shell - mean - total, turning: 2.0 * mean - shell, waves }.scaled(PI * self.density)
    }

    /// Waves of one harmonic with polynomials of so many terms, at speed 1.
    fn damped(&self, k: usize, terms: usize, nu: f64) -> Option<Harmonic> {
        let Cavity { radius, free, height, .. } = *self;
        let (depth, kappa, square) = (radius - free, PI * k as f64 / height, free * free);
        let n = 2 * terms;
        let steep = steepness(LAYER * (2.0 * nu).sqrt() / depth);
        let (mut inertia, mut turning, mut drag) = (Mat::zeros(n + 1, n + 1), Mat::zeros(n + 1, n + 1), Mat::zeros(n + 1, n + 1));
        let mut drive = vec![0.0; n];
        // y = R - r and its derivatives
        let across = |t: f64| {
            if steep == 0.0 {
                return [depth * t, depth, 0.0];
            }
            let (s, b) = (depth / steep.sinh(), steep);
            [s * (b * t).sinh(), s * b * (b * t).cosh(), s * b * b * (b * t).sinh()]
        };
        // u, u', v, v', z, z' of the flows at t
        let fields = |t: f64| -> Vec<[f64; 6]> {
            let [y, y1, y2] = across(t);
            let r = radius - y;
            let [p, first, second] = bent(terms, 2.0 * t - 1.0);
            let flow = |i: usize| {
                if i < terms {
                    let (p, p1, p2) = (p[i], 2.0 * first[i], 4.0 * second[i]);
                    let (f, f1, f2) = (t * t * p, 2.0 * t * p + t * t * p1, 2.0 * p + 4.0 * t * p1 + t * t * p2);
                    let (u, du, ddu) = (f, -f1 / y1, (f2 - f1 * y2 / y1) / (y1 * y1));
                    [u, du, -(u + r * du), -(2.0 * du + r * ddu), 0.0, 0.0]
                } else {
                    let (p, p1) = (p[i - terms], 2.0 * first[i - terms]);
                    let (f, df) = (t * p, -(p + t * p1) / y1);
                    [0.0, 0.0, r / radius * f, (f + r * df) / radius, -f / (kappa * radius), -df / (kappa * radius)]
                }
            };
            (0..n).map(flow).collect()
        };
        // strains that viscosity works against, of the flow and of its change along the axis
        let strains = |[u, du, v, dv, z, dz]: [f64; 6], r: f64| {
            let twice = 2f64.sqrt();
            [twice * du, twice * (u + v) / r, twice * kappa * z, dv - (u + v) / r, dz - kappa * u, kappa * v + z / r]
        };
        for (t, weight) in gauss(2 * terms + 8) {
            let [y, y1, _] = across(t);
            let r = radius - y;
            let weight = weight * y1 * r;
            let fields = fields(t);
            let strained: Vec<[f64; 6]> = fields.iter().map(|f| strains(*f, r)).collect();
            for i in 0..n {
                let [u, _, v, _, z, _] = fields[i];
                drive[i] += weight * (u - v);
                for j in 0..=i {
                    let [u2, _, v2, _, z2, _] = fields[j];
                    inertia[(i, j)] += weight * (u * u2 + v * v2 + z * z2);
                    turning[(i, j)] += 2.0 * weight * (u * v2 + v * u2);
                    drag[(i, j)] += weight * strained[i].iter().zip(&strained[j]).map(|(a, b)| a * b).sum::<f64>();
                }
            }
        }
        let end = fields(1.0);
        inertia[(n, n)] = square;
        for i in 0..n {
            turning[(n, i)] = square * end[i][0];
        }
        let (places, flows) = definite(&turning, &inertia).ok()?;
        let drag = Mat::from_fn(n + 1, n + 1, |i, j| if i < j { drag[(j, i)] } else { drag[(i, j)] });
        let drag = flows.transpose().matmul(&drag.matmul(&flows));
        let pushed = |j: usize| (0..n).map(|i| flows[(i, j)] * (2.0 * drive[i] + square * end[i][0])).sum::<f64>() - square * flows[(n, j)];
        let drive: Vec<f64> = (0..=n).map(pushed).collect();
        let matrix = Mat::from_fn(n + 1, n + 1, |i, j| c(if i == j { places[i] } else { 0.0 }, nu * drag[(i, j)]));
        let waves = driven(&matrix, &drive)?;
        Some(Harmonic { factor: 8.0 * height.powi(3) / (PI * k as f64).powi(4), places, drag, drive, waves })
    }
}

/// The search for a few waves in place of all.
struct Few<'a> {
    cavity: &'a Cavity<f64>,
    all: Vec<Harmonic>,
    nu: f64,
    /// With all waves.
    whole: Rational,
    /// Error of that, and what of it is that of the polynomials.
    series: f64,
    rough: f64,
    /// Error of the exact reaction it was compared with.
    unsure: f64,
    stop: &'a dyn Fn() -> bool,
}

/// The search for a form: harmonics and polynomials that were looked at, so many of each.
struct Search<'a> {
    cavity: &'a Cavity<f64>,
    nu: f64,
    truncation: Truncation,
    stop: &'a dyn Fn() -> bool,
    seen: Vec<(usize, usize, Few<'a>)>,
}

impl<'a> Search<'a> {
    /// The form of an accuracy; in its place what seems to be in reach.
    fn at(&mut self, accuracy: f64) -> Result<Layer, Refused> {
        let harmonics = match self.truncation {
            Truncation::At(last) if last > MOST_HARMONICS => return Err(Refused::Harmonics),
            Truncation::At(last) => vec![last],
            _ => HARMONICS.to_vec(),
        };
        // what so many waves reach says nothing of other accuracies, which begin with other harmonics
        let unreached =
            |refused: Refused| if let Refused::Accuracy { .. } = refused { Refused::Accuracy { reached: accuracy } } else { refused };
        let fits = |last: usize, terms: usize| last * terms <= WORK.max(last * TERMS[1]);
        let mut best: Option<usize> = None;
        let (mut first, mut fine) = (0, 0);
        // by what is missing of the accuracy; where that does not lead there, all that may be had
        let mut most = harmonics.iter().filter_map(|&last| Some((last, *TERMS.iter().rev().find(|t| fits(last, **t))?)));
        loop {
            let next = match (harmonics.get(first), TERMS.get(fine)) {
                (Some(&last), Some(&terms)) if fits(last, terms) => Some((last, terms)),
                _ => {
                    first = harmonics.len();
                    most.next()
                }
            };
            let Some((last, terms)) = next else { break };
            let Some(now) = self.of(last, terms)? else { break };
            let few = &self.seen[now].2;
            if !(few.unsure <= 0.1 * accuracy) {
                return Err(Refused::Reaction);
            }
            if few.series <= LEFT_OUT[0] * accuracy {
                return few.find(accuracy).map_err(unreached);
            }
            // whichever of the two says more of the error
            let polynomials = few.rough > 0.25 * accuracy && fine + 1 < TERMS.len();
            if best.is_none_or(|b| few.series < self.seen[b].2.series) {
                best = Some(now);
            }
            if polynomials { fine += 1 } else { first += 1 }
        }
        match best.map(|b| &self.seen[b].2) {
            Some(few) if few.series <= LEFT_OUT[1] * accuracy => few.find(accuracy).map_err(unreached),
            Some(few) => Err(Refused::Accuracy { reached: few.series / LEFT_OUT[1] }),
            None => Err(Refused::Accuracy { reached: f64::INFINITY }),
        }
    }

    /// All waves of so many harmonics and polynomials.
    fn of(&mut self, last: usize, terms: usize) -> Result<Option<usize>, Refused> {
        if let Some(known) = self.seen.iter().position(|s| (s.0, s.1) == (last, terms)) {
            return Ok(Some(known));
        }
        let Search { cavity, nu, stop, .. } = *self;
        let mut all = Vec::new();
        for k in (1..=last + 2).step_by(2) {
            if stop() {
                return Err(Refused::Stopped);
            }
            let Some(harmonic) = cavity.damped(k, terms, nu) else { return Ok(None) };
            all.push(harmonic);
        }
        let Some(next) = all.pop() else { return Ok(None) };
        let whole = cavity.summed_up(&all, all.iter().flat_map(|h| h.waves.iter().map(|w| (w.place, w.share.scale(h.factor)))));
        let [series, rough, unsure] = cavity.left_out(&whole, &next, self, last)?;
        let few = Few { cavity, all, nu, whole, series: BETWEEN * series, rough: BETWEEN * rough, unsure, stop };
        self.seen.push((last, terms, few));
        Ok(Some(self.seen.len() - 1))
    }
}

/// The first accuracy from `from` on, each so many times the one before and rounded up to two digits, for which there is a form; infinite where there is none up to the loosest.
pub(super) fn attainable(from: f64, step: f64, mut form: impl FnMut(f64) -> Result<Layer, Refused>) -> Result<f64, Refused> {
    let mut next = from;
    for _ in 0..TRIED {
        let wish = rounded_up(next);
        if !(wish <= LOOSEST) {
            break;
        }
        match form(wish) {
            Ok(_) => return Ok(wish),
            Err(Refused::Stopped) => return Err(Refused::Stopped),
            Err(_) => next = step * wish,
        }
    }
    Ok(f64::INFINITY)
}

/// The least number of two digits that is not below x; as it is read from its decimals.
fn rounded_up(x: f64) -> f64 {
    let read = |x: f64| format!("{x:.1e}").parse().unwrap_or(f64::INFINITY);
    let near = read(x);
    if near >= x { near } else { read(near + 0.06 * 10f64.powf(x.log10().floor())) }
}

impl Few<'_> {
    fn find(&self, accuracy: f64) -> Result<Layer, Refused> {
        let grid = self.grid(&[&self.whole], &COARSE, accuracy);
        let known = self.known(&grid, 0.0);
        let total: Vec<f64> = self.all.iter().flat_map(|h| h.drive.iter().map(|b| b * h.factor.sqrt())).collect();
        let (mut span, mut images): (Vec<Vec<f64>>, Vec<Vec<C64>>) = (Vec::new(), Vec::new());
        let mut form = self.cavity.summed_up(&self.all, std::iter::empty());
        let mut goal = (accuracy - self.series) / TOPS;
        let (mut reached, mut again) = (f64::INFINITY, 0);
        loop {
            if (self.stop)() {
                return Err(Refused::Stopped);
            }
            let errors: Vec<f64> = known.iter().map(|k| apart(&form, k)).collect();
            let worst = errors.iter().copied().fold(0.0, largest);
            if worst <= goal {
                let error = self.series + TOPS * self.closely(&form, accuracy);
                if error <= accuracy && form.waves.iter().all(|w| w.place.im > 0.0) {
                    return Ok(Layer { form, error });
                }
                again += 1;
                goal = 0.8 * worst;
            }
            reached = reached.min(self.series + TOPS * worst);
            let before = span.len();
            let mut tops: Vec<usize> = (0..grid.len()).filter(|&i| errors[i] > goal && is_top(&errors, i)).collect();
            tops.sort_by_number_down(|&i| errors[i]);
            for i in tops.into_iter().take(1 + before / 8) {
                self.widen(&mut span, &mut images, grid[i]);
            }
            if span.len() == before || span.len() > MOST_WAVES || again > AGAIN {
                return Err(Refused::Accuracy { reached });
            }
            let m = span.len();
            let matrix = Mat::from_fn(m, m, |i, j| span[i].iter().zip(&images[j]).fold(C64::zero(), |s, (v, z)| s + z.scale(*v)));
            let drive: Vec<f64> = span.iter().map(|v| v.iter().zip(&total).map(|(v, b)| v * b).sum()).collect();
            let waves = driven(&matrix, &drive).ok_or(Refused::Accuracy { reached })?;
            form = self.cavity.summed_up(&self.all, waves.into_iter().map(|w| (w.place, w.share)));
        }
    }

    /// Adds what the liquid does at x.
    fn widen(&self, span: &mut Vec<Vec<f64>>, images: &mut Vec<Vec<C64>>, x: f64) {
        let answer: Vec<C64> = self.all.iter().flat_map(|h| h.answer(x)).collect();
        for part in [C64::one(), C64::i()] {
            let mut new: Vec<f64> = answer.iter().map(|q| (part.conj() * *q).re).collect();
            let size = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
            let before = size(&new);
            for _ in 0..2 {
                for v in span.iter() {
                    let along: f64 = v.iter().zip(&new).map(|(a, b)| a * b).sum();
                    new.iter_mut().zip(v).for_each(|(n, v)| *n -= along * v);
                }
            }
            let left = size(&new);
            if !(left > NOTHING * before) {
                continue;
            }
            new.iter_mut().for_each(|x| *x /= left);
            let mut image = Vec::with_capacity(new.len());
            let mut rest = new.as_slice();
            for h in &self.all {
                let (own, others) = rest.split_at(h.places.len());
                let drag = h.drag.mul_vec(own);
                image.extend(own.iter().zip(&h.places).zip(drag).map(|((v, x), d)| c(x * v, self.nu * d)));
                rest = others;
            }
            span.push(new);
            images.push(image);
        }
    }

    /// Places along the band, close where the waves of these forms are.
    fn grid(&self, forms: &[&Rational], widths: &[f64], accuracy: f64) -> Vec<f64> {
        let mut out: Vec<f64> = (0..801).map(|i| BAND * (f64::from(i) / 400.0 - 1.0)).collect();
        // a wave that is lower makes no error that matters
        let tall = |w: &&Wave| self.cavity.height(**w, &self.whole) >= LOW * accuracy;
        for wave in forms.iter().flat_map(|f| &f.waves).filter(tall) {
            out.extend(widths.iter().flat_map(|s| [wave.place.re + s * wave.place.im, wave.place.re - s * wave.place.im]));
        }
        for i in 0..60 {
            let off = 10f64.powf(-6.0 + 0.1 * f64::from(i));
            out.extend([off, -off, -1.0 + off, -1.0 - off]);
        }
        out.retain(|x| x.abs() <= BAND && (x + 1.0).abs() > 1e-6);
        ascending(&mut out);
        out.dedup();
        out
    }

    fn known(&self, grid: &[f64], growth: f64) -> Known {
        let at = |x: &f64| {
            let w = c(1.0 + x, -growth);
            let l = self.whole.at(w, 1.0);
            (w, l, self.cavity.tilt_size(w, l))
        };
        grid.iter().map(at).collect()
    }

    /// The largest error against all waves, on the real axis and where motions grow.
    fn closely(&self, form: &Rational, accuracy: f64) -> f64 {
        let grid = self.grid(&[&self.whole, form], &FINE, accuracy);
        let mut worst = 0.0;
        for growth in [0.0].into_iter().chain(GROWTHS) {
            // where motions grow fast nothing changes fast
            let mut line: Vec<f64> = Vec::new();
            for &x in &grid {
                if line.last().is_none_or(|last| x - last >= 0.1 * growth) {
                    line.push(x);
                }
            }
            worst = self.known(&line, growth).iter().map(|k| apart(form, k)).fold(worst, largest);
        }
        worst
    }
}

impl Harmonic {
    /// What it does at x, times `sqrt(c_k)`.
    fn answer(&self, x: f64) -> Vec<C64> {
        let mut out = vec![C64::zero(); self.drive.len()];
        for wave in &self.waves {
            let by = (c(x, 0.0) - wave.place).recip().scale(self.factor.sqrt());
            out.iter_mut().zip(&wave.flow).for_each(|(q, y)| *q += *y * by);
        }
        out
    }
}

fn apart(form: &Rational, &(w, should, size): &(C64, C64, f64)) -> f64 {
    (form.at(w, 1.0) - should).abs() / size
}

fn is_top(errors: &[f64], i: usize) -> bool {
    (i == 0 || errors[i] >= errors[i - 1]) && (i + 1 == errors.len() || errors[i] > errors[i + 1])
}

/// `b^T (x - K)^-1 b` of a symmetric K as a sum over its eigenvectors.
fn driven(matrix: &Mat<C64>, drive: &[f64]) -> Option<Vec<Damped>> {
    let waves = modes(matrix).ok()?.into_iter().map(|mode| {
        let own = mode.right.iter().fold(C64::zero(), |s, y| s + *y * *y);
        let along = mode.right.iter().zip(drive).fold(C64::zero(), |s, (y, b)| s + y.scale(*b));
        let by = along / own;
        Damped { place: mode.value, share: along * by, flow: mode.right.into_iter().map(|y| y * by).collect() }
    });
    Some(waves.collect())
}

/// a of `a/sinh(a) = scale`; 0 where that is 1 or more.
fn steepness(scale: f64) -> f64 {
    let (mut low, mut high) = (0.0, 40.0f64);
    if !(scale < 1.0) {
        return 0.0;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if middle > scale * middle.sinh() { low = middle } else { high = middle }
    }
    low
}

/// Legendre polynomials with their first and second derivatives.
fn bent(count: usize, x: f64) -> [Vec<f64>; 3] {
    let (p, first) = legendre(count, x);
    let mut second = vec![0.0; count];
    for n in 2..count {
        second[n] = second[n - 2] + (2.0 * n as f64 - 1.0) * first[n - 1];
    }
    [p, first, second]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_up_by_less_than_a_tenth() {
        for x in [1e-5, 1.04e-4, 0.0123, 0.0100001, 9.94e-3, 9.96e-3, 0.05, 3.3e-4] {
            let up = rounded_up(x);
            assert!(up >= x && up <= 1.1 * x * (1.0 + 1e-12), "{x} {up}");
            assert_eq!(format!("{up:.1e}").parse(), Ok(up));
        }
    }
}
