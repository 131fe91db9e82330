//! Ensembles of the fixed set and engineering measures against the reference tables.

use crate::common;

use common::{number, rows};
use laval::separation::cup::{Hanging, SwingingCup};
use laval::separation::exit::{Cylinder, Surface};
use laval::separation::halton;
use laval::separation::law::Law;
use laval::separation::measures::{self, Cone};
use laval::separation::particle::{Medium, Particle};
use laval::separation::separator::{Bowl, Cup, Decanter, Discs, Separator, Turning};
use laval::separation::suspension::{
    self, Member, Model, Powder, cut_size, efficiency, members, powder_efficiency, products, quantile, sorted,
};
use std::f64::consts::{FRAC_PI_2, PI};

macro_rules! table {
    ($name:literal) => {
        rows(include_str!(concat!("../reference/separation/", $name, ".csv")))
    };
}

const G: f64 = 9.80665;
const N: usize = 4096;

fn close(got: f64, want: f64, tolerance: f64, what: &str) {
    assert!((got - want).abs() <= tolerance * want.abs(), "{what}: {got} wanted {want}, relative {:e}", (got / want - 1.0).abs());
}

/// A share of the table (over `whole`) as the count of the fixed set that it is.
fn counts(share: &str, whole: f64) -> usize {
    let count = number(share) / whole * N as f64;
    assert!((count - count.round()).abs() < 1e-3, "{share} is no count");
    count.round() as usize
}

struct Conf {
    turning: Turning,
    medium: Medium,
    particle: Particle,
    members: Vec<Member>,
    /// Exit products without inertia, in the order of the members.
    products: Vec<(f64, Surface)>,
}

impl Conf {
    fn named(name: &str) -> Conf {
        let row = table!("ensemble_cases").into_iter().find(|r| r[0] == name).unwrap();
        let n = |i: usize| number(row[i]);
        let cup = Cup {
            hanging: SwingingCup { hinge: n(1), body: Hanging::point(1.0, 0.1), damping: 0.0, gravity: n(9) },
            vessel: Cylinder { radius: n(2), bottom: n(3), top: n(4) },
            held: Some(n(11)),
        };
        let turning = Separator::Cup(cup).at(n(10));
        let (medium, particle) = (Medium::new(n(7), n(8)), Particle { radius: n(5), density: n(6) });
        let members = members(&turning, N);
        let sign = (particle.density - medium.density).signum();
        let products = products(&turning, &members, sign).into_iter().map(|p| p.unwrap()).collect();
        Conf { turning, medium, particle, members, products }
    }

    fn sorted(&self) -> Vec<f64> {
        sorted(self.products.iter().map(|p| Some(p.0)))
    }

    fn sedimentation(&self, diameter: f64) -> f64 {
        self.medium.rates(&Particle { radius: 0.5 * diameter, ..self.particle }).sedimentation.abs()
    }
}

#[test]
fn the_fixed_set() {
    let e1 = Conf::named("E1_lab_3000rpm");
    for row in table!("halton_points") {
        let p = halton::point(number(row[0]) as u64);
        for (got, k) in [(p.along, 1), (p.area, 2), (p.turn, 3), (p.size, 4)] {
            close(got, number(row[k]), 1e-14, "share");
        }
        let m = &e1.members[number(row[0]) as usize - 1];
        for (k, c) in [(5, 0), (6, 1), (7, 2)] {
            close(m.start[c], number(row[k]), 1e-13, "start");
        }
    }
}

#[test]
fn mean_times_and_surfaces() {
    for row in table!("ensemble_cases") {
        let c = Conf::named(row[0]);
        let s = c.medium.rates(&c.particle).sedimentation.abs();
        let mean = c.products.iter().map(|p| p.0 / s).sum::<f64>() / N as f64;
        close(mean, number(row[12]), 1e-12, row[0]);
        let powder = Powder { size: Law::Single(2.0 * c.particle.radius), density: Law::Single(c.particle.density) };
        let exits = suspension::settle(&c.turning, &c.medium, &powder, &c.members, Model::Inertial);
        let exact = exits.iter().map(|e| e.unwrap().time).sum::<f64>() / N as f64;
        close(exact, number(row[13]), 1e-9, row[0]);
        for (surface, k) in [(Surface::Wall, 15), (Surface::Bottom, 16), (Surface::Free, 17)] {
            assert_eq!(c.products.iter().filter(|p| p.1 == surface).count(), counts(row[k], 1.0), "{} {surface:?}", row[0]);
        }
        let changed = exits.iter().zip(&c.products).filter(|(e, p)| e.unwrap().surface != p.1).count();
        assert_eq!(changed as f64, number(row[18]), "{}", row[0]);
    }
}

#[test]
fn master_curves() {
    for name in ["E1_lab_3000rpm", "E2_heavyoil_45deg_463rpm", "E3_heavyoil_88deg_1640rpm", "E4_milk_4000rpm", "E5_equilibrium_45deg"] {
        let c = Conf::named(name);
        let drifting = c.sorted();
        let powder = Powder { size: Law::Single(2.0 * c.particle.radius), density: Law::Single(c.particle.density) };
        let inertial =
            sorted(suspension::settle(&c.turning, &c.medium, &powder, &c.members, Model::Inertial).iter().map(|e| e.map(|e| e.time)));
        for row in table!("ensemble_master_curve").into_iter().filter(|r| r[0] == name) {
            let q = number(row[1]);
            close(quantile(&drifting, q), number(row[2]), 1e-10, &format!("{name} {q}"));
            close(quantile(&inertial, q), number(row[3]), 1e-9, &format!("{name} {q} with inertia"));
        }
    }
}

#[test]
fn grade_efficiency_and_cut_size() {
    let mut conf: Option<(&str, Conf, Vec<f64>)> = None;
    let find = |name: &'static str| -> (&'static str, Conf, Vec<f64>) {
        let c = Conf::named(name);
        let s = c.sorted();
        (name, c, s)
    };
    for row in table!("ensemble_grade_efficiency") {
        if conf.as_ref().is_none_or(|c| c.0 != row[0]) {
            conf = Some(find(row[0]));
        }
        let (_, c, times) = conf.as_ref().unwrap();
        let tau = c.sedimentation(number(row[1]) * 1e-6) * number(row[2]);
        let caught = |s: Surface| c.products.iter().filter(|p| p.0 <= tau && p.1 == s).count();
        let all = (efficiency(times, tau) * N as f64).round() as usize;
        let found = [all, caught(Surface::Wall), caught(Surface::Bottom), caught(Surface::Free)];
        let wanted = [3, 4, 5, 6].map(|k| counts(row[k], 1.0));
        assert_eq!(found, wanted, "{row:?}");
    }
    for row in table!("ensemble_cut_size") {
        if conf.as_ref().is_none_or(|c| c.0 != row[0]) {
            conf = Some(find(row[0]));
        }
        let (_, c, times) = conf.as_ref().unwrap();
        let d = cut_size(times, &c.medium, c.particle.density, number(row[2]), number(row[1]));
        close(d * 1e6, number(row[3]), 1e-10, row[0]);
    }
}

#[test]
fn powders() {
    for row in table!("ensemble_polydisperse") {
        let c = Conf::named(row[0]);
        let law = Law::LogNormal { median: number(row[1]) * 1e-6, gsd: number(row[2]) };
        let t = number(row[3]);
        let caught = c.members.iter().zip(&c.products).filter(|(m, p)| p.0 <= c.sedimentation(law.quantile(m.point.size)) * t).count();
        assert_eq!(caught, counts(row[4], 1.0), "{row:?}");
        let taus: Vec<f64> = c.products.iter().map(|p| p.0).collect();
        let exact = powder_efficiency(&taus, &c.medium, &law, c.particle.density, t);
        // the table sums over the curve of quantiles
        assert!((exact - number(row[5])).abs() < 2e-4, "{row:?}: {exact}");
    }
}

/// Drag-dominated, no gravity, horizontal, wide: eta = 1 - [(L_st + L) exp(-s w^2 t) - L_st]/L.
#[test]
fn a_wide_cup_has_a_closed_form() {
    let (hinge, length, w) = (0.1, 0.2, 100.0);
    let cup = Cup {
        hanging: SwingingCup { hinge, body: Hanging::point(1.0, 0.1), damping: 0.0, gravity: 0.0 },
        vessel: Cylinder { radius: 1e3, bottom: length, top: 0.0 },
        held: Some(FRAC_PI_2),
    };
    let turning = Separator::Cup(cup).at(w);
    // on the axis: the field of a wide cup has components across it
    let n = 4096;
    let times = sorted((1..=n).map(|i| turning.drift(1.0, [0.0, length * halton::point(i).along, 0.0]).map(|e| e.time)));
    for share in [0.1, 0.5, 0.9] {
        let tau = quantile(&times, share);
        let eta = 1.0 - ((hinge + length) * (-tau * w * w).exp() - hinge) / length;
        assert!((eta - share).abs() < 1.5 / n as f64, "{share} {eta}");
    }
}

/// Ensemble of a bowl, a stack and a decanter against their Sigma: the share caught at the throughput of the convention.
#[test]
fn flow_machines_meet_their_sigma() {
    let w = 400.0;
    let bowl = Separator::Bowl(Bowl { length: 0.5, radius: 0.1, surface: 0.05 });
    let discs = Separator::Discs(Discs { inner: 0.08, outer: 0.25, angle: 0.96, gaps: 100.0, spacing: 0.5e-3 });
    let decanter = Separator::Decanter(Decanter { cylinder: 0.5, cone: 0.3, radius: 0.18, surface: 0.1, rule: Cone::TextBook });
    let s = 2e-9;
    for (machine, share) in [(bowl, 0.5), (discs, 1.0), (decanter, 0.5)] {
        let turning = machine.at(w);
        let members = members(&turning, 4096);
        let times = sorted(members.iter().map(|m| turning.drift(s, m.start).map(|e| e.time)));
        let throughput = machine.sigma(w, G).unwrap().throughput(s, G);
        let residence = machine.flow_volume().unwrap() / throughput;
        assert!((efficiency(&times, residence) - share).abs() < 3e-4, "{}: {}", machine.word(), efficiency(&times, residence));
        // light particles are caught too, on the other side
        let light = sorted(members.iter().map(|m| turning.drift(-s, m.start).map(|e| e.time)));
        assert!(light.iter().all(|t| t.is_finite()));
    }
    // inertia in a bowl: small for small particles
    let (medium, p) = (Medium::new(1000.0, 1e-3), Particle { radius: 1e-6, density: 1500.0 });
    let turning = bowl.at(w);
    let rates = medium.rates(&p);
    let (a, b) = (turning.settle(&rates, [0.0, 0.06, 0.0]).unwrap(), turning.drift(rates.sedimentation, [0.0, 0.06, 0.0]).unwrap());
    close(a.time, b.time, 1e-5, "bowl");
    close(b.time, measures::settling_time(rates.sedimentation, w, 0.06, 0.1), 1e-12, "bowl");
}

#[test]
fn engineering_measures() {
    let values: Vec<(String, f64)> = include_str!("../reference/separation/engineering_measures.csv")
        .lines()
        .filter(|l| !l.starts_with('#'))
        .skip(1)
        .map(|l| {
            let (name, rest) = l.split_once(',').unwrap();
            let rest = match rest.strip_prefix('"') {
                Some(r) => r.split_once("\",").unwrap().1,
                None => rest.split_once(',').unwrap().1,
            };
            (name.to_string(), number(rest.split(',').next().unwrap()))
        })
        .collect();
    let rpm = PI / 30.0;
    let w = 3000.0 * rpm;
    let inch = 0.0254;
    let got = [
        measures::rcf(w, 0.1, G),
        measures::rcf(60000.0 * rpm, 0.072, G),
        measures::rcf(50000.0 * rpm, 0.072, G),
        measures::rcf(rpm, 0.01, G),
        measures::k_factor(rpm, 1.0, std::f64::consts::E),
        measures::k_factor(30000.0 * rpm, 0.04, 0.09),
        measures::k_factor(30000.0 * rpm, 0.04, 0.09) / 70.0,
        measures::tubular_half(w, 0.5, 0.05, 0.1, G).area,
        measures::tubular_half_approximate(w, 0.5, 0.05, 0.1, G).area,
        measures::tubular_full(w, 0.5, 0.05, 0.1, G).area,
        measures::tubular_full(800.0 * 2.0 * PI, 4.5 * inch, 0.65 * inch, 0.875 * inch, G).area,
        measures::disc_stack(5000.0 * rpm, 200.0, 0.08, 0.25, 55f64.to_radians(), G).area,
        measures::decanter(w, 0.5, 0.3, 0.1, 0.18, Cone::TextBook, G).area,
        measures::decanter(w, 0.5, 0.3, 0.1, 0.18, Cone::Slices, G).area,
        measures::bottle(w, 1e-3, 0.1, 0.2, G).area,
        // Q/(2 v_g), the published 110.11 m^2
        0.5 / 3600.0 / (2.0 * (2.5e-6f64).powi(2) * 2.0 * 63.0 / (9.0 * 1.36e-3) * G),
        measures::speed_for_rcf(600.0, 0.2, G) / rpm,
    ];
    assert_eq!(got.len(), values.len());
    for (g, (name, want)) in got.iter().zip(&values) {
        close(*g, *want, 1e-12, name);
    }
}

/// Eight commercial rotors at 10000 g for half an hour: k, cut size and shares of vesicles pelleted by the formulas of the literature, against the published
/// numbers, and the same by an ensemble in the tube. The radii follow from speed and k, the path across a fixed-angle tube from its diameter and angle.
#[test]
fn published_rotors() {
    let (medium, time) = (Medium::new(1000.0, 1.55e-3), 1800.0);
    let rates = |nm: f64| medium.rates(&Particle { radius: 0.5e-9 * nm, density: 1150.0 });
    // path across the tube (mm), angle (degrees), its diameter (mm): the path is the diameter over the cosine
    let tubes: [(&str, f64, f64, f64); 5] = [
        ("Type 45 Ti", 41.6, 24.0, 38.0),
        ("Type 60 Ti", 27.3, 23.5, 25.0),
        ("Type 70 Ti", 27.2, 23.0, 25.0),
        ("F-45-24-15", 15.6, 45.0, 11.0),
        ("TLA 110", 14.7, 28.0, 13.0),
    ];
    for row in table!("published_rotors") {
        let n = |i: usize| number(row[i]);
        let w = n(2) * PI / 30.0;
        let mean = 1e4 * G / (w * w);
        let ratio = (n(3) * 3600.0 * measures::SVEDBERG * w * w).exp();
        let (r_min, r_max) = (2.0 * mean / (1.0 + ratio), 2.0 * mean * ratio / (1.0 + ratio));
        close(measures::k_factor(w, r_min, r_max), n(3), 1e-12, row[1]);
        // one published k contradicts its own formula
        close(measures::k_factor(w, r_min, r_max), n(4), if row[1] == "F-45-24-15" { 0.06 } else { 2e-3 }, row[1]);
        let tube = tubes.iter().find(|t| t.0 == row[1]);
        let share = |nm: f64| match tube {
            None => measures::pelleted_swinging(rates(nm).sedimentation, w, r_min, r_max, time),
            Some((_, path, ..)) => measures::pelleted_fixed_angle(rates(nm).sedimentation, w, mean, path * 1e-3, 0.0, time),
        };
        for (nm, k) in [(150.0, 7), (120.0, 9), (100.0, 11), (70.0, 13)] {
            close(100.0 * share(nm), n(k), 2e-6, &format!("{} {nm} nm", row[1]));
            assert!((100.0 * share(nm) - n(k + 1)).abs() <= 1.0, "{} {nm} nm: {}", row[1], share(nm));
        }
        // cut size: all are pelleted just above it
        close(share(n(5) * (1.0 + 1e-6)), 1.0, 1e-12, row[1]);
        assert!(share(n(5) * (1.0 - 1e-3)) < 1.0 && (n(5) - n(6)).abs() < 1.0, "{}", row[1]);
        // a swinging tube is followed along its axis, as the formulas do; of a fixed-angle tube the circle across it at the mean radius, in the growing field
        let (radius, hinge, ends, tilt) = match tube {
            None => (10.0, r_min, (0.0, r_max - r_min), FRAC_PI_2),
            Some((_, _, angle, diameter)) => (0.5e-3 * diameter, mean, (-1.0, 1.0), angle.to_radians()),
        };
        let cup = Cup {
            hanging: SwingingCup { hinge, body: Hanging::point(1.0, 0.1), damping: 0.0, gravity: 0.0 },
            vessel: Cylinder { radius, bottom: ends.1, top: ends.0 },
            held: Some(tilt),
        };
        let turning = Separator::Cup(cup).at(w);
        let members = members(&turning, N);
        for (nm, k) in [(150.0, 15), (100.0, 16)] {
            let s = rates(nm).sedimentation;
            let starts = members.iter().map(|m| if tube.is_some() { [m.start[0], 0.0, m.start[2]] } else { [0.0, m.start[1], 0.0] });
            let caught = starts.filter(|start| turning.drift(s, *start).is_some_and(|e| e.time <= time)).count();
            assert_eq!(caught, counts(row[k], 100.0), "{} {nm} nm", row[1]);
            if tube.is_some() {
                // the field grows on the way, which the formula leaves out
                assert!(caught as f64 / N as f64 >= share(nm) - 1.0 / N as f64, "{} {nm} nm: {caught}", row[1]);
            }
        }
    }
}
