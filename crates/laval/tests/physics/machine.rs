//! Random machines, and the files that describe them.

use super::random::Random;
use std::fmt::Write;

/// A body or the ground, and the place on it.
#[derive(Clone, Copy, Debug)]
pub struct End {
    pub body: Option<usize>,
    pub at: f64,
}

#[derive(Clone, Copy, Debug)]
pub struct Tilt {
    pub diametral: f64,
    pub height: f64,
    pub skew: f64,
    pub skew_phase: f64,
}

#[derive(Clone, Copy, Debug)]
pub enum Body {
    Disc { mass: f64, eccentricity: f64, phase: f64, unbalance: f64, polar: f64, tilt: Option<Tilt> },
    Base { mass: f64, stiffness: [f64; 2], damping: [f64; 2] },
}

/// Coefficients kxx kxy kyx kyy cxx cxy cyx cyy.
pub const NAMES: [&str; 8] = ["kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"];

#[derive(Clone, Debug)]
pub enum Law {
    Bearing {
        coefficients: [f64; 8],
        short: bool,
    },
    Table {
        speed: Vec<f64>,
        columns: [Vec<f64>; 8],
        straight: bool,
    },
    Damper {
        rotating: bool,
        damping: [f64; 2],
        tilt: f64,
    },
    Lumped {
        stiffness: [f64; 2],
        cross: f64,
        coupling: f64,
        tilt: f64,
        material: f64,
    },
    Span {
        below: f64,
        above: f64,
        diameter: f64,
        inner: f64,
        modulus: f64,
        lower: [f64; 2],
        upper: [f64; 2],
    },
    /// Ends: clamped.
    Round {
        below: f64,
        above: f64,
        clamped: [bool; 2],
        diameter: f64,
        inner: f64,
        modulus: f64,
        moment: bool,
        material: f64,
    },
    /// A shaft that remembers: shares of its stiffness relax at these rates.
    Memory {
        stiffness: f64,
        shares: Vec<f64>,
        rates: Vec<f64>,
        rotor: bool,
    },
    Liquid {
        radius: f64,
        height: f64,
        density: f64,
        surface: f64,
        wave_damping: f64,
    },
}

#[derive(Clone, Debug)]
pub struct Joint {
    pub ends: [End; 2],
    pub law: Law,
}

#[derive(Clone, Debug)]
pub struct Machine {
    pub horizontal: bool,
    pub speed: f64,
    /// Largest natural frequency of a body on its own, roughly, rad/s.
    pub fast: f64,
    pub damped: bool,
    pub bodies: Vec<Body>,
    pub joints: Vec<Joint>,
}

impl Machine {
    pub fn tilts(&self, body: usize) -> bool {
        matches!(self.bodies[body], Body::Disc { tilt: Some(_), .. })
    }
    /// Something turns with the rotor that loads it.
    pub fn forced(&self) -> bool {
        let loads = |b: &Body| match b {
            Body::Disc { eccentricity, unbalance, tilt, .. } => {
                *eccentricity != 0.0 || *unbalance != 0.0 || tilt.is_some_and(|t| t.skew != 0.0)
            }
            Body::Base { .. } => false,
        };
        self.bodies.iter().any(loads)
    }
    /// Internal states.
    pub fn states(&self) -> usize {
        let of = |j: &Joint| match &j.law {
            Law::Liquid { .. } => 4,
            Law::Memory { rates, .. } => 2 * rates.len(),
            _ => 0,
        };
        self.joints.iter().map(of).sum()
    }
    pub fn remembers(&self) -> bool {
        self.joints.iter().any(|j| matches!(j.law, Law::Memory { .. }))
    }

    pub fn random(r: &mut Random) -> Machine {
        let damped = !r.chance(15);
        let slow = 10f64.powf(r.between(1.5, 3.0));
        let mut m = Machine { horizontal: r.chance(50), speed: 0.0, fast: slow, damped, bodies: vec![], joints: vec![] };
        let bases = r.below(3);
        for _ in 0..bases {
            let mass = r.size(2.0, 200.0);
            let k = mass * (slow * r.size(0.1, 2.0)).powi(2);
            let stiffness = if r.chance(50) { [k, k] } else { [k, k * r.size(0.4, 2.5)] };
            let damping = stiffness.map(|k| if damped { 2.0 * r.size(1e-3, 0.1) * (k * mass).sqrt() } else { 0.0 });
            m.bodies.push(Body::Base { mass, stiffness, damping });
        }
        for k in 0..1 + r.below(4) {
            m.disc(r, slow, bases, k);
        }
        m.speed = slow * r.size(0.2, 4.0);
        let reach = m.speed;
        for j in &mut m.joints {
            if let Law::Table { speed, .. } = &mut j.law {
                speed.iter_mut().for_each(|w| *w *= reach);
            }
        }
        m
    }

    /// A disc, what holds it, and what joins it to the one before.
    fn disc(&mut self, r: &mut Random, slow: f64, bases: usize, count: usize) {
        let (mass, radius) = (r.size(0.5, 50.0), r.size(0.05, 0.3));
        let own = slow * r.size(0.5, 5.0);
        self.fast = self.fast.max(own);
        let diametral = mass * radius * radius * r.between(0.3, 1.5);
        let unbalanced = !r.chance(15);
        let tilt = r.chance(60).then(|| Tilt {
            diametral,
            height: if r.chance(40) { r.between(-0.1, 0.1) } else { 0.0 },
            skew: if r.chance(50) { r.between(-0.01, 0.01) } else { 0.0 },
            skew_phase: r.between(-4.0, 4.0),
        });
        let me = self.bodies.len();
        self.bodies.push(Body::Disc {
            mass,
            eccentricity: if unbalanced { r.size(1e-6, 1e-3) } else { 0.0 },
            phase: r.between(-4.0, 4.0),
            unbalance: if r.chance(30) { mass * r.size(1e-6, 1e-4) } else { 0.0 },
            polar: if tilt.is_some() { diametral * r.between(0.0, 2.0) } else { mass * radius * radius },
            tilt,
        });
        let ground = |r: &mut Random| {
            let body = (bases > 0 && r.chance(60)).then(|| r.below(bases));
            End { body, at: if body.is_some() && r.chance(30) { r.between(-0.2, 0.2) } else { 0.0 } }
        };
        let k = mass * own * own;
        let (tilting, isotropic, damped) = (tilt.is_some(), r.chance(40), self.damped);
        let end = |at: f64| End { body: Some(me), at };
        match r.below(5) {
            // two bearings
            0 | 1 => {
                let places = if tilting { vec![-r.between(0.05, 0.4), r.between(0.05, 0.4)] } else { vec![r.between(-0.2, 0.2)] };
                for at in places {
                    let other = ground(r);
                    let law = bearing(r, k, mass, isotropic, damped);
                    self.joints.push(Joint { ends: [end(at), other], law });
                }
            }
            2 => {
                let unequal = if isotropic { 1.0 } else { r.size(0.5, 2.0) };
                let stiffness = [k, k * unequal];
                let cross = if isotropic { 0.0 } else { r.between(-0.5, 0.5) * k * unequal.sqrt() };
                let least = 0.5 * (stiffness[0] + stiffness[1]) - (0.5 * (stiffness[0] - stiffness[1])).hypot(cross);
                let kt = if tilting { diametral * own * own * r.size(0.3, 3.0) } else { 0.0 };
                let coupling = r.between(-0.9, 0.9) * (kt * least).sqrt();
                let material = if isotropic && damped && r.chance(60) { r.size(1e-3, 0.1) / own } else { 0.0 };
                let law = Law::Lumped { stiffness, cross, coupling, tilt: kt, material };
                let other = ground(r);
                self.joints.push(Joint { ends: [end(r.between(-0.1, 0.1)), other], law });
                self.rotating_or_fixed(r, me, own);
            }
            3 => {
                let (modulus, clamped) = (r.size(5e10, 3e11), [r.chance(60), r.chance(60)]);
                let lengths = [r.size(0.1, 1.0), r.size(0.1, 1.0)];
                let [mut below, mut above] = lengths;
                match r.below(3) {
                    0 if clamped[0] => above = 0.0,
                    1 if clamped[1] => below = 0.0,
                    _ => {}
                }
                let bending = k * lengths[0].min(lengths[1]).powi(3) / 12.0;
                let outer = (64.0 * bending / (std::f64::consts::PI * modulus)).powf(0.25);
                let inner = if r.chance(50) { outer * r.between(0.1, 0.6) } else { 0.0 };
                let material = if damped && r.chance(60) { r.size(1e-3, 0.1) / own } else { 0.0 };
                let moment = tilting || r.chance(20);
                let law = Law::Round { below, above, clamped, diameter: outer, inner, modulus, moment, material };
                let other = ground(r);
                self.joints.push(Joint { ends: [end(r.between(-0.1, 0.1)), other], law });
            }
            _ => {
                let length = r.size(0.2, 2.0);
                let share = r.between(0.2, 0.8);
                let modulus = r.size(5e10, 3e11);
                // as stiff at the middle as the disc needs
                let bending = k * length.powi(3) / 48.0;
                let diameter = (64.0 * bending / (std::f64::consts::PI * modulus)).powf(0.25);
                let support = |r: &mut Random| {
                    let s = k * r.size(0.5, 50.0);
                    [s, if isotropic { s } else { s * r.size(0.5, 2.0) }]
                };
                let (lower, upper) = (support(r), support(r));
                let inner = if r.chance(30) { diameter * r.between(0.1, 0.8) } else { 0.0 };
                let law = Law::Span { below: share * length, above: (1.0 - share) * length, diameter, inner, modulus, lower, upper };
                let other = ground(r);
                self.joints.push(Joint { ends: [end(r.between(-0.1, 0.1)), other], law });
                self.rotating_or_fixed(r, me, own);
            }
        }
        if self.damped {
            let fixed = 2.0 * r.size(1e-3, 0.1) * mass * own;
            let damping = [fixed, if r.chance(50) { fixed } else { fixed * r.size(0.5, 2.0) }];
            let tilt = if tilting { fixed * radius * radius } else { 0.0 };
            self.joints.push(Joint { ends: [end(0.0), End { body: None, at: 0.0 }], law: Law::Damper { rotating: false, damping, tilt } });
        }
        if count > 0 {
            let before = bases + r.below(count);
            let stiffness = [k * r.size(0.05, 2.0); 2];
            let both = tilting && self.tilts(before);
            let tilt = if both { stiffness[0] * radius * radius * r.size(0.2, 2.0) } else { 0.0 };
            let coupling = r.between(-0.8, 0.8) * (tilt * stiffness[0]).sqrt();
            let law = Law::Lumped { stiffness, cross: 0.0, coupling, tilt, material: 0.0 };
            let other = End { body: Some(before), at: r.between(-0.3, 0.3) };
            self.joints.push(Joint { ends: [end(r.between(-0.3, 0.3)), other], law });
        }
        if damped && r.chance(3) {
            let terms = 1 + r.below(2);
            let shares = (0..terms).map(|_| r.size(0.01, 0.25)).collect();
            let rates = (0..terms).map(|_| own * r.size(0.01, 10.0)).collect();
            let law = Law::Memory { stiffness: k * r.size(0.05, 1.0), shares, rates, rotor: r.chance(60) };
            let other = ground(r);
            self.joints.push(Joint { ends: [end(r.between(-0.1, 0.1)), other], law });
        }
        if r.chance(15) {
            let radius = r.size(0.03, 0.2);
            let density = r.size(600.0, 3000.0);
            let height = 0.3 * mass / (density * std::f64::consts::PI * radius * radius);
            let surface = radius * r.between(0.3, 0.95);
            let wave_damping = if damped { r.size(0.1, 50.0) } else { 0.0 };
            let at = r.between(-0.05, 0.05);
            self.joints.push(Joint { ends: [end(at), end(at)], law: Law::Liquid { radius, height, density, surface, wave_damping } });
        }
    }

    fn rotating_or_fixed(&mut self, r: &mut Random, body: usize, own: f64) {
        let Body::Disc { mass, .. } = self.bodies[body] else { return };
        if self.damped && r.chance(50) {
            let c = 2.0 * r.size(1e-4, 1e-2) * mass * own;
            let tilt = if self.tilts(body) && r.chance(50) { 0.01 * c } else { 0.0 };
            let ends = [End { body: Some(body), at: r.between(-0.1, 0.1) }, End { body: None, at: 0.0 }];
            self.joints.push(Joint { ends, law: Law::Damper { rotating: true, damping: [c; 2], tilt } });
        }
    }

    /// The machine as a file, without studies.
    pub fn file(&self) -> String {
        let mut out = String::new();
        let axis = if self.horizontal { "horizontal" } else { "vertical" };
        let _ = writeln!(out, "[machine]\nname = \"random\"\nspeed = {:?}\naxis = \"{axis}\"", self.speed);
        for (i, b) in self.bodies.iter().enumerate() {
            match *b {
                Body::Disc { mass, eccentricity, phase, unbalance, polar, tilt } => {
                    let _ = writeln!(
                        out,
                        "[[part]]\nkind = \"disc\"\nname = \"b{i}\"\nmass = {mass:?}\neccentricity = {eccentricity:?}\neccentricity_phase = {phase:?}\n\
                         unbalance = {unbalance:?}\npolar_inertia = {polar:?}"
                    );
                    if let Some(t) = tilt {
                        let _ = writeln!(
                            out,
                            "diametral_inertia = {:?}\nskew = {:?}\nskew_phase = {:?}\ncentre_of_mass = {:?}",
                            t.diametral, t.skew, t.skew_phase, t.height
                        );
                    }
                }
                Body::Base { mass, stiffness: [kx, ky], damping: [cx, cy] } => {
                    let _ = writeln!(
                        out,
                        "[[part]]\nkind = \"foundation\"\nname = \"b{i}\"\nmass = {mass:?}\nstiffness = {{ x = {kx:?}, y = {ky:?} }}\n\
                         damping = {{ x = {cx:?}, y = {cy:?} }}"
                    );
                }
            }
        }
        for (i, j) in self.joints.iter().enumerate() {
            let end = |e: &End| match e.body {
                None => "\"ground\"".to_string(),
                Some(b) if e.at == 0.0 => format!("\"b{b}\""),
                Some(b) => format!("{{ body = \"b{b}\", at = {:?} }}", e.at),
            };
            let (a, b) = (end(&j.ends[0]), end(&j.ends[1]));
            let kind = match j.law {
                Law::Bearing { .. } | Law::Table { .. } => "bearing_linear",
                Law::Damper { .. } => "damper",
                Law::Lumped { .. } | Law::Round { .. } => "shaft_lumped",
                Law::Span { .. } => "shaft_span",
                Law::Memory { .. } => "shaft_viscoelastic",
                Law::Liquid { .. } => "liquid",
            };
            let _ = writeln!(out, "[[part]]\nkind = \"{kind}\"\nname = \"j{i}\"");
            let _ = if kind == "liquid" { writeln!(out, "in = {a}") } else { writeln!(out, "between = [{a}, {b}]") };
            let _ = match &j.law {
                Law::Bearing { coefficients: k, short: true } => writeln!(out, "stiffness = {:?}\ndamping = {:?}", k[0], k[4]),
                Law::Bearing { coefficients, .. } => NAMES.iter().zip(coefficients).try_for_each(|(n, x)| writeln!(out, "{n} = {x:?}")),
                Law::Table { speed, columns, straight } => {
                    let list = |x: &[f64]| x.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ");
                    let rows: Vec<String> = NAMES.iter().zip(columns).map(|(n, x)| format!("{n} = [{}]", list(x))).collect();
                    let beyond = if *straight { "linear" } else { "hold" };
                    writeln!(out, "table = {{ speed = [{}], {} }}\nbeyond = \"{beyond}\"", list(speed), rows.join(", "))
                }
                Law::Damper { rotating, damping: [x, y], tilt } => {
                    let axes = if *rotating { "rotating" } else { "fixed" };
                    writeln!(out, "axes = \"{axes}\"\ndamping = {{ x = {x:?}, y = {y:?} }}\ntilt_damping = {tilt:?}")
                }
                Law::Lumped { stiffness: [x, y], cross, coupling, tilt, material } => writeln!(
                    out,
                    "stiffness = {{ x = {x:?}, y = {y:?} }}\ncross_stiffness = {cross:?}\ncoupling = {coupling:?}\ntilt_stiffness = {tilt:?}\n\
                     material_damping = {material:?}"
                ),
                Law::Span { below, above, diameter, inner, modulus, lower, upper } => writeln!(
                    out,
                    "below = {below:?}\nabove = {above:?}\ndiameter = {diameter:?}\ninner_diameter = {inner:?}\nmodulus = {modulus:?}\n\
                     lower_support = {{ x = {:?}, y = {:?} }}\nupper_support = {{ x = {:?}, y = {:?} }}",
                    lower[0], lower[1], upper[0], upper[1]
                ),
                Law::Round { below, above, clamped, diameter, inner, modulus, moment, material } => {
                    for (name, end, length, clamped) in
                        [("below", "lower_end", below, clamped[0]), ("above", "upper_end", above, clamped[1])]
                    {
                        if *length > 0.0 {
                            let word = if clamped { "clamped" } else { "pinned" };
                            let _ = writeln!(out, "{name} = {length:?}\n{end} = \"{word}\"");
                        }
                    }
                    writeln!(
                        out,
                        "diameter = {diameter:?}\ninner_diameter = {inner:?}\nmodulus = {modulus:?}\nmoment = {moment}\nmaterial_damping = {material:?}"
                    )
                }
                Law::Memory { stiffness, shares, rates, rotor } => {
                    let axes = if *rotor { "rotor" } else { "fixed" };
                    writeln!(
                        out,
                        "stiffness = {stiffness:?}\nmemory = \"{axes}\"\nexponentials = {{ share = {shares:?}, rate = {rates:?} }}"
                    )
                }
                Law::Liquid { radius, height, density, surface, wave_damping } => writeln!(
                    out,
                    "model = \"planar\"\ncavity_radius = {radius:?}\ncavity_height = {height:?}\ndensity = {density:?}\n\
                     fill = {{ free_surface_radius = {surface:?} }}\nwave_damping = {wave_damping:?}"
                ),
            };
        }
        out
    }
}

/// A bearing with constant coefficients or a table over the speed, whose speeds are shares of that of the machine.
fn bearing(r: &mut Random, k: f64, mass: f64, isotropic: bool, damped: bool) -> Law {
    let c = if damped { 2.0 * r.size(1e-3, 0.2) * (k * mass).sqrt() } else { 0.0 };
    if isotropic && r.chance(50) {
        return Law::Bearing { coefficients: [k, 0.0, 0.0, k, c, 0.0, 0.0, c], short: true };
    }
    let mut one = || {
        let cross = r.between(0.0, 0.2) * c * (k / mass).sqrt();
        if isotropic {
            [k, cross, -cross, k, c, 0.1 * c, -0.1 * c, c]
        } else {
            let (x, y) = (r.size(0.5, 2.0), r.size(0.5, 2.0));
            let skew = r.between(-0.2, 0.2);
            [k * x, cross + skew * k, skew * k - cross, k * y, c * x, r.between(-0.2, 0.2) * c, r.between(-0.2, 0.2) * c, c * y]
        }
    };
    let first = one();
    let rows = [first, one(), one(), one()];
    if r.chance(60) {
        return Law::Bearing { coefficients: first, short: false };
    }
    let count = 2 + r.below(3);
    let mut speed = vec![r.between(0.05, 0.5)];
    (1..count).for_each(|i| speed.push(speed[i - 1] + r.between(0.2, 1.0)));
    let columns = std::array::from_fn(|j| rows[..count].iter().map(|row| row[j]).collect());
    Law::Table { speed, columns, straight: r.chance(30) }
}
