//! What the walk asks of every kind of study: as little as shows an influence; and where none is to be expected.

/// Kind, fields, and whether it is quick enough to be requested about every key.
pub const STUDIES: &[(&str, &str, bool)] = &[
    ("modes", "", true),
    ("modes", "about = \"turning\"\nspeed = 400", true),
    ("campbell", "speed = { from = 100, to = 1300, points = 4 }", true),
    ("critical_speeds", "speed = { from = 100, to = 1300, points = 6 }", true),
    ("stability_map", "speed = { from = 100, to = 2000, points = 4 }", true),
    ("harmonic_force", "place = \"drum\"\nspeed = { from = 100, to = 1300, points = 6 }", true),
    ("stability_threshold", "place = \"drum\"\nspeed = 400\nup_to = 1e5\npoints = 3", true),
    ("forced_response", "speed = { from = 100, to = 1300, points = 6 }", true),
    ("nonlinear_response", "speed = { from = 800, to = 900 }\nharmonics = 1\nstability = false", false),
    (
        "bifurcation_loci",
        "speed = { from = 500, to = 2500 }\nparameter = { parameter = \"drum.eccentricity\", from = \"20 um\", to = \"30 um\", points = 2 }\n\
         max_points = 100\nharmonics = 1\nkinds = \"folds\"",
        false,
    ),
    (
        "response_map",
        "x = { parameter = \"drum.eccentricity\", from = \"10 um\", to = \"20 um\", points = 2 }\n\
         y = { parameter = \"losses.damping\", from = 900, to = 1000, points = 2 }\nspeed = { from = 850, to = 900 }\nharmonics = 1\nstability = false",
        false,
    ),
    ("stationary", "speed = 900\nstarts = 4\nseeds = 1\nmax_points = 20", false),
    ("sensitivity", "speed = { from = 500, to = 2500 }\nharmonics = 1", false),
    ("backbone", "amplitude = { from = \"10 um\", to = \"20 um\" }\nmax_points = 10\nharmonics = 1", false),
    ("limit_cycles", "speed = { from = 900, to = 2500, points = 4 }\nmax_points = 10\nharmonics = 1", false),
    ("methods", "speed = { from = 850, to = 900, points = 2 }\nharmonics = 1", false),
    ("transient", "duration = \"10 ms\"\npoints = 10", true),
    ("run_up", "from = 850\nto = 900\nduration = \"10 ms\"\npoints = 10\nwindows = 10", true),
    ("operating_window", "speed = { from = 300, to = 900, points = 5 }\n[limits]\ndisplacement = \"2 mm\"", false),
    ("sweep", "speed = { from = 880, to = 900, points = 2 }\nstart = \"rest\"\nperiods = 48\ntolerance = 1e-4\nmost_periods = 40", false),
    (
        "motion_map",
        "speed = { from = 880, to = 900, points = 2 }\ny = { parameter = \"losses.damping\", from = 900, to = 1000, points = 2 }\nperiods = 48\n\
         tolerance = 1e-4\nmost_periods = 40",
        false,
    ),
    (
        "basins",
        "from = { \"drum.x\" = \"-0.1 mm\", \"drum.y\" = \"-0.1 mm\" }\nto = { \"drum.x\" = \"0.1 mm\", \"drum.y\" = \"0.1 mm\" }\npoints = 2\nperiods = 48\n\
         tolerance = 1e-4\nmost_periods = 40",
        false,
    ),
    (
        "uncertainty",
        "study = { kind = \"forced_response\", speed = { from = 400, to = 2500, points = 6 } }\n\
         parameters = [{ parameter = \"losses.damping\", distribution = \"normal\", deviation = \"2 %\" }]\nsamples = 2",
        false,
    ),
    (
        "optimum",
        "study = { kind = \"modes\" }\nvary = [{ parameter = \"losses.damping\", from = 900, to = 1000 }]\nmaximise = \"least_damped_mode damping ratio\"\nruns = 20\n\
         starts = 1",
        false,
    ),
];

/// Studies in which nothing moves across the axis, and which see blocks beside the parts only.
pub const WITHOUT_MOTION: &[&str] = &["separation"];

/// Studies of a machine at rest or without its loads, in which most properties change nothing: they have tests of their own.
pub const APART: &[&str] = &["static", "support_stiffness_map", "bearing_coefficients"];

/// Properties that are changed in studies that are not quick, too.
pub const MAIN: &[&str] = &[
    "mass",
    "stiffness",
    "kxx",
    "damping",
    "ball_mass",
    "density",
    "coefficient",
    "gap",
    "modulus",
    "amplitude",
    "cubic_stiffness",
    "lower_support",
    "unbalance",
    "tilt_damping",
];

/// Pairs that are left out because the study takes seconds: case, studies.
pub const LONG: &[(&str, &[&str])] = &[
    ("polymer", &["sweep", "motion_map", "basins", "stationary", "operating_window"]),
    ("polymer_support", &["sweep", "motion_map", "basins"]),
    ("oil", &["critical_speeds", "nonlinear_response", "sensitivity", "limit_cycles", "optimum", "basins"]),
    ("rough_balls", &["basins"]),
    ("free_ring", &["basins"]),
];

/// Studies of small motions about rest, and those that ask them.
const ROOTS: &[&str] = &["modes", "campbell", "stability_map", "stability_threshold", "harmonic_force", "optimum"];
const STEADY: &[&str] = &[
    "forced_response",
    "bifurcation_loci",
    "response_map",
    "sensitivity",
    "motion_map",
    "nonlinear_response",
    "uncertainty",
    "basins",
    "methods",
    "sweep",
];
const ABOUT_REST: &[&str] = &[
    "modes",
    "campbell",
    "critical_speeds",
    "stability_map",
    "stability_threshold",
    "harmonic_force",
    "forced_response",
    "uncertainty",
    "optimum",
];
const EVERY: &[&str] = &[];

/// Changed properties (`case.key`, `*` for every key) that change nothing in some studies (none named: in all), and why.
pub const NOTHING: &[(&[&str], &[&str], &str)] = &[
    (&["mesh.height", "thrust.height"], &[], "the wheels that it acts on do not tilt"),
    (&["thrust.axial_force"], &[], "it moves the wheel along the axis, which acts on nothing across it; it has a test of its own"),
    (
        &["joint.axial_stiffness", "joint.axial_damping", "joint.torsional_stiffness", "joint.torsional_damping", "seal.kzz", "seal.czz"],
        &[],
        "motion along and about the axis is driven by nothing in these machines; its modes have tests of their own",
    ),
    (
        &[
            "drum.eccentricity",
            "drum.eccentricity_phase",
            "drum.unbalance",
            "drum.skew",
            "drum.skew_phase",
            "water.eccentricity",
            "water.eccentricity_phase",
            "strip.skew",
            "strip.skew_phase",
            "ice.eccentricity",
            "ice.skew",
        ],
        &["modes", "campbell", "stability_map", "stability_threshold", "harmonic_force", "optimum", "backbone", "limit_cycles"],
        "unbalance forces the machine and moves no root; free whirls are without it; a state that turns moves by it less than its tangent shows",
    ),
    (&["drum.eccentricity"], &["bifurcation_loci", "response_map"], "the eccentricity is the parameter over which these go"),
    (
        &[
            "free_ring.tilt_damping",
            "inner_damper.*",
            "joint.damping",
            "joint.tilt_damping",
            "lossy_shaft.material_damping",
            "round_shaft.material_damping",
            "water.wave_damping",
            "strip.wave_damping",
            "oil.viscosity",
            "oil.fill",
        ],
        STEADY,
        "what moves on a circle with the rotor is at rest in it: nothing inside it is sheared, and the surface of the liquid is round about the axis",
    ),
    (
        &[
            "cubic.cubic_stiffness",
            "hertz.coefficient",
            "hertz.height",
            "ball_contacts.ball_diameter",
            "ball_contacts.contact_angle",
            "ball_contacts.height",
            "stop.*",
        ],
        ABOUT_REST,
        "the tangent at the undeflected state: the cubic force is none, the gap is open, and the study says so",
    ),
    (
        &["ball_bearing.height", "roller_bearing.height"],
        &["bifurcation_loci", "limit_cycles"],
        "beside the mounts they hardly hold the drum, and the jumps and cycles sought there hold no tilt",
    ),
    (
        &[
            "hertz.clearance",
            "hertz.coefficient",
            "ball_contacts.clearance",
            "ball_contacts.ball_diameter",
            "ball_contacts.contact_angle",
            "stop.gap",
        ],
        ROOTS,
        "a gap that stays open",
    ),
    (&["stop.*"], &["backbone", "limit_cycles"], "whirls smaller than the gap"),
    (&["stop.damping"], EVERY, "contact at a steady deflection has no rate"),
    (
        &["load.*", "engine.*", "induction.*", "turbine.*", "free_load.*"],
        &[
            "modes",
            "campbell",
            "critical_speeds",
            "stability_map",
            "stability_threshold",
            "harmonic_force",
            "forced_response",
            "uncertainty",
            "optimum",
            "operating_window",
            "bifurcation_loci",
            "response_map",
            "stationary",
            "sensitivity",
            "backbone",
            "limit_cycles",
            "methods",
            "sweep",
            "motion_map",
            "basins",
            "nonlinear_response",
        ],
        "at a given speed a torque about the axis moves nothing across it; only what reports a torque shows it",
    ),
    (&["turbine.torque"], &["transient"], "at this speed the power limits the torque"),
    (&["rough_balls.contact_damping", "rough_balls.contact_stiffness"], EVERY, "balls that do not meet, or that rest side by side"),
    (&["rough_balls.ball_mass", "rough_balls.height"], &["response_map"], "no periodic motion is found at these speeds"),
];
