//! A small machine for every kind of part, from the typical block of the registry, and the same with one property changed.

use laval::file::{Catalog, catalog};
use laval::model::field::FieldKind;

/// A part in its machine.
pub struct Case {
    /// Name of the case, and of the part under test in its machine.
    pub name: &'static str,
    pub kind: &'static str,
    /// Lines beside or in place of those of the typical block; a value of `-` leaves a key out.
    pub lines: &'static str,
    /// Blocks beside it.
    pub beside: &'static str,
    /// Lines of `[machine]`.
    pub machine: &'static str,
}

const fn case(name: &'static str, kind: &'static str, lines: &'static str) -> Case {
    Case { name, kind, lines, beside: "", machine: "" }
}

/// Every kind of part; those with several forms in each of them. Keys that are zero in the typical block have a value, so that a changed one can act.
pub const CASES: &[Case] = &[
    case(
        "drum",
        "disc",
        "eccentricity_phase = 0.5\nunbalance = \"50 g mm\"\nskew = \"1 mrad\"\nskew_phase = 0.3\ncentre_of_mass = \"5 mm\"\n\
         unbalances = { unbalance = [\"40 g mm\"], phase = [1.0], at = [\"30 mm\"] }",
    ),
    Case {
        beside: "[[part]]\nkind = \"shaft_lumped\"\nname = \"link\"\nbetween = [\"drum\", \"block\"]\nstiffness = 4e6\n",
        ..case("block", "foundation", "stiffness = { x = \"2.4e7 N/m\", y = \"1.8e7 N/m\" }\nmass = \"20 kg\"")
    },
    case("damper", "damper", "tilt_damping = 0.5"),
    case("inner_damper", "damper", "axes = \"rotating\"\ntilt_damping = 0.5"),
    case(
        "seal",
        "bearing_linear",
        "kxx = \"2e6 N/m\"\nkxy = \"1e5 N/m\"\nkyx = \"-1e5 N/m\"\nkyy = \"3e6 N/m\"\ncxx = 200\ncxy = 20\ncyx = -20\ncyy = 300\nkzz = 1e6\nczz = 50",
    ),
    case("round_seal", "bearing_linear", "kxx = -\nkxy = -\nkyx = -\nkyy = -\ncxx = -\ncyy = -\nstiffness = 2e6\ndamping = 200"),
    case(
        "table_seal",
        "bearing_linear",
        "kxx = -\nkxy = -\nkyx = -\nkyy = -\ncxx = -\ncyy = -\nbeyond = \"hold\"\n\
         table = { speed = [0, 2000], kxx = [2e6, 3e6], kyy = [2e6, 3e6], cxx = [200, 200], cyy = [200, 200] }",
    ),
    case(
        "ball_bearing",
        "bearing_rolling",
        "count = 10\nsize = \"0.2 mm\"\nload = 2\ncontact_angle = 0.3\nratio = 0.7\ndamping_time = 1e-4",
    ),
    case(
        "roller_bearing",
        "bearing_rolling",
        "elements = \"rollers\"\nload_direction = \"x\"\nsize = \"0.2 mm\"\nload = 2\ncontact_angle = 0.3\ndamping_time = 1e-4",
    ),
    case("cubic", "bearing_cubic", "stiffness = 1e6\ncubic_stiffness = 1e14"),
    case("hertz", "bearing_hertz", "clearance = \"5 um\"\ncoefficient = 1e9"),
    case(
        "ball_contacts",
        "bearing_hertz",
        "clearance = \"5 um\"\ncoefficient = -\nballs = 3\nball_diameter = \"0.2 mm\"\ncontact_angle = 0.2",
    ),
    case("preloaded", "bearing_hertz", "law = \"per_axis\"\nclearance = \"-20 um\"\ncoefficient = 1e8"),
    case(
        "shaft",
        "shaft_lumped",
        "stiffness = { x = 1e6, y = 1.2e6 }\ncross_stiffness = 1e5\ncoupling = 5e4\ntilt_stiffness = 5e3\nmaterial_damping = -",
    ),
    case("lossy_shaft", "shaft_lumped", "stiffness = 1e6\ncoupling = 5e4\ntilt_stiffness = 5e3\nmaterial_damping = 1e-4"),
    case(
        "round_shaft",
        "shaft_lumped",
        "stiffness = -\ndiameter = \"30 mm\"\ninner_diameter = \"12 mm\"\nbelow = \"250 mm\"\nabove = \"300 mm\"\nmodulus = \"206 GPa\"",
    ),
    case(
        "span",
        "shaft_span",
        "inner_diameter = \"10 mm\"\nlower_support = \"1e6 N/m\"\nupper_support = { x = \"1e6 N/m\", y = \"0.8e6 N/m\" }",
    ),
    case("polymer", "shaft_viscoelastic", "decay = \"200 1/s\"\namplitude = 0.2\naccuracy = 1e-3\nband = 3000"),
    case(
        "polymer_support",
        "shaft_viscoelastic",
        "memory = \"fixed\"\nsupports = -\nmodulus = -\ndiameter = -\nlength = -\nposition = -\namplitude = -\nexponent = -\ndecay = -\nstiffness = 2e6\n\
         exponentials = { share = [0.3], rate = [2000] }",
    ),
    Case {
        beside: "[[part]]\nkind = \"bearing_linear\"\nname = \"link\"\nbetween = [{ body = \"elastic\", at = 0.3 }, \"drum\"]\nkxx = 3e6\nkyy = 3e6\ncxx = 100\ncyy = 100\n\
                 [[part]]\nkind = \"bearing_linear\"\nname = \"end\"\nbetween = [\"elastic\", \"ground\"]\nkxx = 2e6\nkyy = 2e6\ncxx = 100\ncyy = 100\n\
                 [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = { body = \"elastic\", at = 0.3 }\nmass = 1.5\ndiametral_inertia = 2e-3\npolar_inertia = 3e-3\n",
        ..case(
            "elastic",
            "shaft",
            "section = { length = [0.3], outer_diameter = [0.02] }\nelements = 1\nmodulus = 2e11\nshear_modulus = 8e10\ndensity = 7800\naxial_force = 5e4\ntorque = 400\n\
             rotating_damping = 2e-5\nmass_damping = 20\nstiffness_damping = 2e-5",
        )
    },
    Case {
        beside: "[[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = 1.5\ndiametral_inertia = 2e-3\npolar_inertia = 3e-3\naxial = true\ntorsional = true\n\
                 [[part]]\nkind = \"shaft_lumped\"\nname = \"link\"\nbetween = [\"wheel\", \"ground\"]\nstiffness = 3e6\ntilt_stiffness = 2e3\n",
        ..case(
            "joint",
            "coupling",
            "between = [\"drum\", \"wheel\"]\nstiffness = 1e6\ndamping = 50\ntilt_stiffness = 1e3\ntilt_damping = 0.1\naxial_stiffness = 1e6\naxial_damping = 20\n\
             torsional_stiffness = 1e3\ntorsional_damping = 0.1",
        )
    },
    Case {
        beside: "[[part]]\nkind = \"disc\"\nname = \"other_wheel\"\nspin = \"other\"\nmass = 1.5\ndiametral_inertia = 2e-3\npolar_inertia = 3e-3\neccentricity = 1e-5\n\
                 [[part]]\nkind = \"shaft_lumped\"\nname = \"link\"\nbetween = [\"other_wheel\", \"drum\"]\nstiffness = 3e6\ntilt_stiffness = 2e3\n",
        ..case("other", "speed_ratio", "ratio = -1.3")
    },
    Case {
        beside: "[[part]]\nkind = \"speed_ratio\"\nname = \"fast\"\nratio = -2\n\
                 [[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = 2\npolar_inertia = 4e-3\ntorsional = true\n\
                 [[part]]\nkind = \"bearing_linear\"\nname = \"seat\"\nbetween = [\"wheel\", \"drum\"]\nkxx = 3e6\nkyy = 5e6\ncxx = 100\ncyy = 100\n\
                 [[part]]\nkind = \"disc\"\nname = \"pinion\"\nspin = \"fast\"\nmass = 1.5\npolar_inertia = 3e-3\ntorsional = true\n\
                 [[part]]\nkind = \"bearing_linear\"\nname = \"link\"\nbetween = [\"pinion\", \"ground\"]\nkxx = 3e6\nkyy = 5e6\ncxx = 100\ncyy = 100\n",
        ..case(
            "mesh",
            "gear",
            "between = [\"wheel\", \"pinion\"]\nfirst_radius = 0.1\nsecond_radius = 0.05\nstiffness = 1e7\ndamping = 20\nazimuth = 0.4\npressure_angle = 0.35\ntorque = 20",
        )
    },
    case("pull", "constant_force", "on = \"drum\"\nforce_x = 90\nforce_y = 60\nmoment_about_x = 5\nmoment_about_y = 3"),
    Case {
        beside: "[[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = 1.5\naxial = true\n\
                 [[part]]\nkind = \"bearing_linear\"\nname = \"link\"\nbetween = [\"wheel\", \"drum\"]\nkxx = 3e6\nkyy = 3e6\nkzz = 2e6\ncxx = 100\ncyy = 100\n",
        ..case("thrust", "constant_force", "on = \"wheel\"\nforce_y = -\naxial_force = 300")
    },
    case("journal", "bearing_journal", "clearance = \"0.5 mm\"\nviscosity = \"5 mPa s\""),
    case("ring", "squeeze_film", "clearance = \"0.6 mm\"\nviscosity = \"2 mPa s\""),
    case("stop", "stop", "gap = \"15 um\"\nstiffness = 1e6"),
    case(
        "water",
        "liquid",
        "eccentricity = \"20 um\"\neccentricity_phase = 0.4\ncavity_radius = \"60 mm\"\ncavity_height = \"50 mm\"\nfill = { volume_fraction = 0.3 }",
    ),
    case(
        "strip",
        "liquid",
        "model = \"strip\"\nskew = \"1 mrad\"\nskew_phase = 0.4\ncavity_radius = \"60 mm\"\ncavity_height = \"50 mm\"\nfill = { volume_fraction = 0.3 }",
    ),
    case(
        "ice",
        "liquid",
        "model = \"frozen\"\neccentricity = \"20 um\"\nskew = \"1 mrad\"\ncavity_radius = \"60 mm\"\ncavity_height = \"50 mm\"\nfill = { mass = \"0.3 kg\" }\nwave_damping = -",
    ),
    case(
        "oil",
        "liquid",
        "viscosity = \"1e-4 m^2/s\"\nwave_damping = -\ncavity_radius = \"60 mm\"\ncavity_height = \"50 mm\"\nfill = { volume_fraction = 0.3 }",
    ),
    case(
        "balls",
        "balancer_ball",
        "balls = 1\nhousing_mass = \"1 kg\"\neccentricity_phase = 0.3\nrolling_inertia = 0.4\ndiametral_inertia = 1e-3\npolar_inertia = 2e-3\nbody_tilt = true",
    ),
    case(
        "rough_balls",
        "balancer_ball",
        "balls = 2\ntilt = 0.01\nnode_line = 0.5\ndry_torque = 1e-3\nrolling_resistance = 1e-3\nfriction_rate = 1\nball_radius = \"5 mm\"\n\
         contact_stiffness = 10\ncontact_damping = 0.1\nbody_tilt = true",
    ),
    case(
        "free_ring",
        "balancer_ball",
        "balls = 1\nrings = \"free\"\ntilt = 0.01\nnode_line = 0.5\ndiametral_inertia = 1e-3\npolar_inertia = 2e-3\ntilt_stiffness = 50\ntilt_damping = 0.1\n\
         body_tilt = true",
    ),
    Case { machine: "drive = \"free\"\n", ..case("engine", "motor", "drag = 1e-3") },
    Case { machine: "drive = \"free\"\n", ..case("induction", "motor", "curve = \"squirrel_cage\"\nbreakdown_slip = 0.3") },
    Case {
        machine: "drive = \"free\"\n",
        ..case("turbine", "motor", "curve = \"limited_power\"\nsynchronous_speed = -\npower = \"2 kW\"")
    },
    case("load", "spin_load", "windage = 1e-5"),
    Case { machine: "drive = \"free\"\n", ..case("free_load", "spin_load", "windage = 1e-5") },
];

/// Lines of a block by key.
type Lines = Vec<(String, String)>;

/// The lines of a block, comments left out.
fn lines(text: &str) -> Lines {
    let line = |l: &str| {
        let l = l.split('#').next().unwrap_or_default();
        l.split_once('=').map(|(k, v)| (k.trim().to_string(), v.trim().to_string()))
    };
    text.lines().filter_map(line).filter(|l| l.0 != "name").collect()
}

/// A machine as its blocks.
#[derive(Clone)]
pub struct Machine {
    pub machine: String,
    /// Kind, name, lines.
    pub parts: Vec<(&'static str, String, Lines)>,
    pub beside: String,
}

impl Case {
    /// The typical block with the lines of the case.
    pub fn block(&self, catalog: &Catalog) -> Lines {
        let mut out = lines(catalog.part(self.kind).expect("a kind of part").example);
        for (key, value) in lines(self.lines) {
            match out.iter_mut().find(|l| l.0 == key) {
                Some(l) => l.1 = value,
                None => out.push((key, value)),
            }
        }
        out.retain(|l| l.1 != "-");
        out
    }

    /// A rotor that tilts on a hardening mount, with losses outside and inside, and the part under test on it.
    pub fn machine(&self, horizontal: bool) -> Machine {
        let catalog = catalog();
        let fixed = |kind, name: &str, text: &str| (kind, name.to_string(), lines(text));
        let mut parts = vec![
            fixed("disc", "drum", catalog.part("disc").expect("discs").example),
            fixed("shaft_lumped", "shaft_below", "between = [\"drum\", \"ground\"]\nstiffness = 3e6\ntilt_stiffness = 3e4"),
            fixed(
                "bearing_cubic",
                "mount",
                "between = [{ body = \"drum\", at = \"30 mm\" }, \"ground\"]\nlaw = \"isotropic\"\nstiffness = 4e6\ncubic_stiffness = 1e14",
            ),
            fixed("damper", "losses", "between = [\"drum\", \"ground\"]\ndamping = 1000\ntilt_damping = 3"),
            fixed("damper", "inside", "between = [\"drum\", \"ground\"]\ndamping = 800\naxes = \"rotating\""),
        ];
        if self.kind == "disc" {
            parts[0].2 = self.block(catalog);
        } else {
            parts.push((self.kind, self.name.to_string(), self.block(catalog)));
        }
        let axis = if horizontal { "axis = \"horizontal\"\n" } else { "" };
        Machine { machine: format!("speed = \"900 rad/s\"\n{axis}{}", self.machine), parts, beside: self.beside.to_string() }
    }
}

impl Machine {
    pub fn text(&self) -> String {
        let part = |(kind, name, lines): &(&str, String, Vec<(String, String)>)| {
            let lines: String = lines.iter().map(|(k, v)| format!("{k} = {v}\n")).collect();
            format!("[[part]]\nkind = \"{kind}\"\nname = \"{name}\"\n{lines}")
        };
        format!("[machine]\n{}{}{}", self.machine, self.parts.iter().map(part).collect::<String>(), self.beside)
    }

    /// The lines of the part of this name.
    pub fn part(&mut self, name: &str) -> &mut Vec<(String, String)> {
        &mut self.parts.iter_mut().find(|p| p.1 == name).expect("a part").2
    }
}

/// A part's value as the file gives it, with every number in it multiplied.
fn scaled(value: &str, by: f64) -> String {
    let mut out = String::new();
    let mut rest = value;
    let mut before = ' ';
    let mut quoted = false;
    while let Some(c) = rest.chars().next() {
        let begins = (c.is_ascii_digit() || (c == '-' && rest[1..].starts_with(|d: char| d.is_ascii_digit())))
            && if quoted { before == '"' } else { matches!(before, ' ' | '[') };
        let length = rest.find(|d: char| !(d.is_ascii_digit() || matches!(d, '.' | 'e' | '-'))).unwrap_or(rest.len());
        match rest[..length].parse::<f64>() {
            Ok(x) if begins => {
                out += &format!("{}", x * by);
                before = '0';
                rest = &rest[length..];
            }
            _ => {
                quoted ^= c == '"';
                out.push(c);
                before = c;
                rest = &rest[c.len_utf8()..];
            }
        }
    }
    out
}

/// A changed property of the part of a case.
pub struct Change {
    /// The key, or what is changed.
    pub what: String,
    pub machine: Machine,
}

/// Factor by which a number is changed.
const FACTOR: f64 = 0.8;

/// Numeric keys that must not be changed alone, and why.
const FIXED: &[(&str, &str, &str)] = &[
    ("shaft_viscoelastic", "accuracy", "error of the time form, no property of the machine"),
    ("shaft_viscoelastic", "band", "range of the time form, no property of the machine"),
    ("liquid", "time_error", "error of the time form, no property of the machine"),
    ("bearing_cubic", "valid_to", "see the walk over validity"),
    ("balancer_ball", "gravity", "a constant of nature"),
];

/// Every number of the part of a case that the file gives, by itself, and the height at which it is attached.
pub fn changes(case: &Case) -> Vec<Change> {
    let catalog = catalog();
    let info = catalog.part(case.kind).expect("a kind of part");
    let plain = case.machine(false);
    let mut out = Vec::new();
    for (key, value) in case.block(catalog) {
        let Some(field) = info.fields.iter().find(|f| f.name == key) else { continue };
        let with = |value: String| {
            let mut machine = plain.clone();
            machine.part(case.name).iter_mut().find(|l| l.0 == key).expect("a line").1 = value;
            machine
        };
        match field.kind {
            _ if FIXED.iter().any(|f| f.0 == case.kind && f.1 == key) => {}
            FieldKind::Quantity { .. } | FieldKind::Lateral { .. } | FieldKind::OneOf(_) => {
                out.push(Change { what: key.clone(), machine: with(scaled(&value, FACTOR)) });
            }
            FieldKind::Attach { .. } | FieldKind::Between => {
                let raised = value.replace("\"drum\"", "{ body = \"drum\", at = \"25 mm\" }");
                out.push(Change { what: "height".into(), machine: with(raised) });
            }
            _ => {}
        }
    }
    out
}

/// Numeric keys of all parts that no case gives.
pub fn left_out() -> Vec<String> {
    let catalog = catalog();
    let given = |kind: &str, key: &str| {
        CASES.iter().any(|c| c.kind == kind && c.block(catalog).iter().any(|l| l.0 == key))
            || FIXED.iter().any(|f| f.0 == kind && f.1 == key)
    };
    let numeric = |kind: FieldKind| matches!(kind, FieldKind::Quantity { .. } | FieldKind::Lateral { .. } | FieldKind::OneOf(_));
    catalog
        .parts
        .iter()
        .flat_map(|k| k.fields.iter().filter(|f| numeric(f.kind) && !given(k.kind, f.name)).map(|f| format!("{}.{}", k.kind, f.name)))
        .collect()
}
