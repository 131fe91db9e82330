//! Unit tests of the liquid part.

use super::*;
use crate::model::field::Value;

pub(super) fn cavity(free: f64, wave_damping: f64) -> LiquidParams {
    LiquidParams { wave_damping, ..LiquidParams::new(0.07, 0.06, 1000.0, 0.07 * free) }
}

/// A cavity off its shaft.
pub(super) fn offset(skew: f64) -> LiquidParams {
    LiquidParams { eccentricity: 2e-3, eccentricity_phase: 0.7, skew, skew_phase: -0.4, ..cavity(0.667, 0.0) }
}

pub(super) fn partial() -> Liquid {
    Liquid::new(Attach::on("drum"), Fill::Partial)
}

/// A spatial liquid in time.
impl Liquid {
    fn in_time(&self, p: &LiquidParams<f64>, speeds: Speeds) -> Result<Self, String> {
        self.for_motions(p, speeds, &|| false).map_err(|e| format!("{e:?}"))
    }
}

pub(super) fn timed(liquid: Liquid, p: &LiquidParams<f64>) -> Liquid {
    liquid.flowing(Model::Spatial).accurate(1e-2).in_time(p, Speeds::Several).unwrap()
}

pub(super) fn viscous() -> LiquidParams {
    LiquidParams { viscosity: 2e-5, ..cavity(0.667, 0.0) }
}

/// A viscous liquid in time, at 500 rad/s.
pub(super) fn in_time(liquid: Liquid) -> Liquid {
    liquid.in_time(&viscous(), Speeds::One(500.0)).unwrap()
}

pub(super) fn thick() -> LiquidParams {
    LiquidParams { viscosity: 2e-3, ..viscous() }
}

pub(super) fn in_time_spatial() -> Liquid {
    partial().flowing(Model::Spatial).viscous().accurate(0.05).in_time(&thick(), Speeds::One(500.0)).unwrap()
}

fn build(kind: &'static str, value: f64) -> (Option<Liquid>, f64, Vec<String>) {
    let (mut values, mut params, mut d) = (Values::default(), ParamValues::default(), Diagnostics::default());
    values.set("in", Value::Attach(Attach::on("drum")), None);
    values.set("fill", Value::OneOf(kind, value), None);
    for (name, x) in [("cavity_radius", 0.07), ("cavity_height", 0.06), ("density", 1000.0)] {
        params.set(name, x);
    }
    let part = Liquid::build(&values, &mut params, &mut d);
    (part, params.get("free_surface_radius").unwrap_or(f64::NAN), d.0.iter().map(|d| d.to_string()).collect())
}

#[test]
fn four_ways_of_saying_the_fill_agree() {
    let (radius, volume) = (0.667 * 0.07, PI * 0.07 * 0.07 * 0.06);
    let fraction = 1.0 - 0.667f64 * 0.667;
    for (kind, value) in [
        ("free_surface_radius", radius),
        ("volume_fraction", fraction),
        ("volume", fraction * volume),
        ("mass", fraction * volume * 1000.0),
    ] {
        let (part, free, text) = build(kind, value);
        assert!(part.is_some_and(|l| l.fill == Fill::Partial) && text.is_empty());
        assert!((free - radius).abs() < 1e-15, "{kind}");
    }
    // 55.5 % of the volume, not a third
    assert!((fraction - 0.555).abs() < 5e-4);
}

#[test]
fn empty_and_full_are_cases_of_their_own() {
    for (kind, value, fill) in [
        ("volume_fraction", 1.0, Fill::Full),
        ("free_surface_radius", 0.0, Fill::Full),
        ("volume_fraction", 0.0, Fill::Empty),
        ("free_surface_radius", 0.07, Fill::Empty),
        ("mass", 0.0, Fill::Empty),
    ] {
        assert!(build(kind, value).0.is_some_and(|l| l.fill == fill), "{kind} {value}");
    }
    let empty = Liquid::new(Attach::on("drum"), Fill::Empty);
    assert!(empty.check(&cavity(1.0, 0.0)).is_empty());
    assert!(empty.check(&cavity(0.9, 0.0))[0].1.contains("different machines"));
}

#[test]
fn impossible_fills_are_reported() {
    let (part, _, text) = build("free_surface_radius", 0.08);
    assert!(part.is_none() && text[0].starts_with("the free surface (radius 80 mm) lies outside the cavity (radius 70 mm)"), "{text:?}");
    let (part, _, text) = build("volume_fraction", 1.2);
    assert!(part.is_none() && text[0].starts_with("this is 1.2 times what the cavity holds"), "{text:?}");
    let (part, _, text) = build("mass", 2.0);
    assert!(part.is_none() && text[0].contains("923.6 g of this liquid"), "{text:?}");
    assert!(build("volume", f64::NAN).0.is_none());
    assert!(Liquid::new(Attach::on("drum"), Fill::Partial).check(&cavity(1.1, 0.0))[0].1.contains("outside the cavity"));
}

#[test]
fn without_spin_the_layer_is_outside_its_validity() {
    let liquid = Liquid::new(Attach::on("drum"), Fill::Partial);
    let ratio = |speed: f64| {
        let at = At { q: &[0.0; 2], v: &[0.0; 2], a: &[9.81, 0.0], z: &[0.0; 4], phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let mut out = Vec::new();
        liquid.validity(&cavity(0.667, 0.0), &at, &mut out);
        out[1].ratio
    };
    assert!(ratio(0.0) > 1.0 && ratio(5.0) > 1.0 && ratio(300.0) < 0.01);
}

/// The force on the rotor is `-ml (z + E)'' + mo eta''` at any speed and spin acceleration, eta measured from the middle of the cavity, that middle off the shaft or not.
#[test]
fn momentum_of_the_liquid_at_changing_speed() {
    let p = offset(0.03);
    let (z, a) = ([0.3, -0.2, 1.1e-3, 0.4e-3, 5.0, 3.0, 0.02, -0.01], [13.0, -7.0, 200.0, 90.0]);
    let (phase, speed, spin_accel) = (0.8, 310.0, 5e3);
    for (model, n, m) in [(Model::Planar, 2, 4), (Model::PlanarTilt, 4, 4), (Model::Strip, 4, 8)] {
        let liquid = partial().flowing(model);
        let p = if model == Model::Planar { LiquidParams { skew: 0.0, ..p } } else { p };
        let mut b = Blocks::default();
        b.reset(n, m, speed);
        liquid.linear(&p, speed, &mut b);
        let zero = [0.0; 4];
        let at = At { q: &zero[..n], v: &zero[..n], a: &a[..n], z: &z[..m], phase, speed, spin_accel, t: 0.0 };
        let (mut force, mut rate) = (vec![0.0; n], vec![0.0; m]);
        b.residual(&at, &mut force, &mut rate);
        let full = PI * 0.07 * 0.07 * 0.06 * 1000.0;
        let void = full * 0.667 * 0.667;
        for i in 0..m / 4 {
            let slices = if i == 0 { 1.0 } else { 0.06f64.powi(2) / 12.0 };
            let (e, angle) = [(p.eccentricity, p.eccentricity_phase), (p.skew, p.skew_phase)][i];
            let e = Complex::cis(phase + angle).scale(e);
            let pair = |x: &[f64], k: usize| c(x[k], x[k + 1]);
            let turning = |z: Complex<f64>| z.mul_i().scale(speed);
            // surface' = i W surface - beta once more, W changing
            let (rise, flow) = (pair(&rate, 4 * i + 2), pair(&rate, 4 * i));
            let bend = pair(&z, 4 * i + 2).mul_i().scale(spin_accel) + turning(rise) - flow;
            let push = e.mul_i().scale(spin_accel) + turning(turning(e));
            let eta = bend - push;
            let should = ((pair(&a, 2 * i) + push).scale(full - void) - eta.scale(void)).scale(slices);
            assert!((pair(&force, 2 * i) - should).abs() < 1e-12 * should.abs(), "{model:?} {i}: {force:?} {should:?}");
        }
    }
}

/// Without states the surface follows from the whirl: round the axis with the speed, hardly displaced against it; as the liquid with states has it.
#[test]
fn surface_of_a_liquid_without_states() {
    let (speed, p) = (310.0, LiquidParams { skew: 0.0, eccentricity: 0.0, ..offset(0.0) });
    let gamma = (1.0 + 0.667f64.powi(2)) / (1.0 - 0.667f64.powi(2));
    for (rate, share) in [(speed, 1.0), (-speed, 1.0 / (4.0 * gamma + 3.0))] {
        let (z, theta) = (c(3e-4, 1e-4), c(-2e-3, 1e-3));
        let turn = |x: Complex<f64>| x.mul_i().scale(rate);
        let pairs = |x: [Complex<f64>; 2]| [x[0].re, x[0].im, x[1].re, x[1].im];
        let (q, v, a) = (pairs([z, theta]), pairs([turn(z), turn(theta)]), pairs([turn(turn(z)), turn(turn(theta))]));
        let at = At { q: &q, v: &v, a: &a, z: &[], phase: 0.4, speed, spin_accel: 0.0, t: 0.0 };
        let mut out = Vec::new();
        partial().flowing(Model::Spatial).validity(&p, &at, &mut out);
        let should = share * (z.abs() + 0.03 * theta.abs()) / (0.07 * 0.333);
        assert!((out[0].ratio / should - 1.0).abs() < 1e-12, "{rate}: {:?} {should}", out[0]);
        // an eccentric cavity moves under a surface that stays
        let still = At { q: &[0.0; 4], v: &[0.0; 4], a: &[0.0; 4], ..at };
        out.clear();
        partial().flowing(Model::Spatial).validity(&LiquidParams { eccentricity: 2e-3, ..p }, &still, &mut out);
        assert!((out[0].ratio - 2e-3 / (0.07 * 0.333)).abs() < 1e-12, "{:?}", out[0]);
    }
}

/// One with viscosity also to its speed: another is another form, and blocks at a third speed are called outside their model.
#[test]
fn a_viscous_form_belongs_to_its_speed() {
    let (p, liquid) = (viscous(), partial().viscous());
    let made = |speed: f64| liquid.in_time(&p, Speeds::One(speed)).unwrap();
    let (first, other) = (made(300.0), made(310.0));
    assert!(std::sync::Arc::ptr_eq(first.time.as_ref().unwrap(), made(300.0).time.as_ref().unwrap()));
    assert!(!std::sync::Arc::ptr_eq(first.time.as_ref().unwrap(), other.time.as_ref().unwrap()));
    let reported = |speed: f64| {
        let z = vec![0.0; first.layout().states.len()];
        let at = At { q: &[1e-4, 0.0], v: &[0.0; 2], a: &[0.0; 2], z: &z, phase: 0.0, speed, spin_accel: 0.0, t: 0.0 };
        let mut out = Vec::new();
        first.validity(&p, &at, &mut out);
        out.iter().filter(|v| v.what.contains("form in time") && v.ratio > 1.0).count()
    };
    assert_eq!((reported(300.0), reported(310.0)), (0, 1));
    for (speeds, why) in [(Speeds::Several, "made for one"), (Speeds::Changing, "constant speed only"), (Speeds::One(0.0), "without spin")]
    {
        assert!(liquid.in_time(&p, speeds).err().unwrap().contains(why));
    }
    assert!(first.check(&LiquidParams { viscosity: 3e-5, ..p })[0].1.contains("made for another cavity"));
    // copies remember together, each its own
    let strip = liquid.clone().flowing(Model::Strip).in_time(&p, Speeds::One(300.0)).unwrap();
    assert!(strip.layout().states.len() == 2 * first.layout().states.len());
    let rough = liquid.clone().accurate(1e-2).in_time(&p, Speeds::One(300.0)).unwrap();
    assert!(rough.layout().states.len() < first.layout().states.len());
    let thick = LiquidParams { viscosity: 2e-3, ..p };
    let states = |last: usize| {
        let spatial = liquid.clone().flowing(Model::Spatial).accurate(1e-3).truncated(last);
        spatial.in_time(&thick, Speeds::One(300.0)).unwrap().layout().states.len()
    };
    assert!(states(1) < states(5));
}

/// The blocks in time, solved for a motion as exp(s t), are the exact reaction to the stated error; at any speed, with the plane flow among them, and with viscosity at
/// the speed of the form.
#[test]
fn blocks_in_time_are_the_reaction() {
    let thick = partial().viscous();
    for exact in
        [partial(), partial().truncated(5), Liquid::new(Attach::on("drum"), Fill::Full), thick.clone().flowing(Model::Strip), thick]
    {
        let exact = if exact.model == Model::Strip { exact } else { exact.flowing(Model::Spatial) }.accurate(1e-2);
        let p = if exact.fill == Fill::Full { cavity(0.0, 0.0) } else { cavity(0.667, 0.0) };
        let p = if exact.viscous { LiquidParams { viscosity: 2e-4, ..p } } else { p };
        let motions = if exact.viscous {
            [(120.0, c(9.0, 310.0)), (120.0, c(2.0, -140.0)), (-120.0, c(6.0, 20.0))]
        } else {
            [(120.0, c(9.0, 310.0)), (300.0, c(-25.0, -140.0)), (55.0, c(6.0, 20.0))]
        };
        for (speed, s) in motions {
            let liquid = exact.in_time(&p, if exact.viscous { Speeds::One(speed) } else { Speeds::Changing }).unwrap();
            let stated = liquid.fit().unwrap().error;
            let m = liquid.layout().states.len();
            assert_eq!(m, liquid.fit().unwrap().states + liquid.plane_states());
            let mut b = Blocks::default();
            b.reset(4, m, speed);
            liquid.linear(&p, speed, &mut b);
            let entry = |i: usize, j: usize| c(f64::from(i == j), 0.0) * s - c(b.state[(i, j)], 0.0);
            let lu = laval_num::dense::Lu::new(&laval_num::dense::Mat::from_fn(m, m, entry)).unwrap();
            let mut whole = vec![Complex::zero(); 16];
            exact.impedance(&p, s, speed, &mut whole);
            let size = |i: usize| whole[4 * i..4 * i + 4].iter().map(|z| z.abs()).fold(0.0, f64::max);
            for j in 0..4 {
                let mut z: Vec<Complex<f64>> =
                    (0..m).map(|i| c(b.state_q[(i, j)], 0.0) + s.scale(b.state_v[(i, j)]) + (s * s).scale(b.state_a[(i, j)])).collect();
                lu.solve(&mut z);
                for i in 0..4 {
                    let damping = b.damping[(i, j)] + speed * b.gyroscopic[(i, j)];
                    let own = (s * s).scale(b.mass[(i, j)]) + s.scale(damping) + c(b.stiffness[(i, j)], 0.0);
                    let is = (0..m).fold(own, |sum, k| sum + z[k].scale(b.state_force[(i, k)]));
                    let limit = if i < 2 && !exact.viscous { 1e-12 } else { 4.0 * stated } * size(i);
                    assert!((is - whole[4 * i + j]).abs() <= limit, "{speed} {s:?} {i} {j}: {is:?} {:?}", whole[4 * i + j]);
                }
            }
        }
    }
}

/// A form made for one cavity does not serve another, and says so; one already made is not made again.
#[test]
fn a_form_belongs_to_its_cavity() {
    let (p, liquid) = (cavity(0.667, 0.0), partial().flowing(Model::Spatial).accurate(1e-2));
    let first = liquid.in_time(&p, Speeds::Several).unwrap();
    assert!(first.check(&p).is_empty());
    let other = LiquidParams { cavity_height: 0.061, ..p };
    assert!(first.check(&other)[0].1.contains("made for another cavity"));
    let again = liquid.in_time(&p, Speeds::One(3.0)).unwrap();
    assert!(std::sync::Arc::ptr_eq(first.time.as_ref().unwrap(), again.time.as_ref().unwrap()));
    assert!(liquid.in_time(&other, Speeds::Several).unwrap().check(&other).is_empty());
    assert!(liquid.in_time(&offset(0.03), Speeds::Changing).err().unwrap().contains("skew"));
}
