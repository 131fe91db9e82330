//! The keys of `[[cup]]` and `[suspension]`.

use crate::model::field::{Bounds, Field, FieldKind, KindInfo};
use std::f64::consts::FRAC_PI_2;

const fn length(bounds: Bounds) -> FieldKind {
    FieldKind::Quantity { unit: "m", bounds }
}
/// Largest dimension of a cup or bowl, m; the largest centrifuges have a fifth of it.
const LARGEST: f64 = 10.0;
const POSITIVE: FieldKind = length(Bounds::positive(LARGEST));
const ON: Field = Field::optional(
    "on",
    FieldKind::Attach { ground: false },
    "",
    "the body that carries it, and the height of the hinges on it; in every study their mass, inertia and unbalance at the tilt of the speed are then those of the body. Without it \
     the mass of the cups is not in the dynamics",
);
const COUNT: Field = Field::optional("count", FieldKind::Integer { min: 1, max: 1000 }, "2", "how many, at equal pitch");
const MASS: Field = Field::optional(
    "mass",
    FieldKind::Quantity { unit: "kg", bounds: Bounds::positive(1e4) },
    "",
    "mass of one with its contents, m; needed when it loads a body",
);
const DIFFERENCES: Field = Field::optional(
    "mass_differences",
    FieldKind::List { unit: "kg", bounds: Bounds::within(1e4) },
    "",
    "what each weighs more than mass, one after the other in the sense of rotation from the key mark; a missing one is - mass",
);

const SWINGING: &[Field] = &[
    ON,
    COUNT,
    Field::required("hinge_radius", length(Bounds::up_to(LARGEST)), "radius of the hinge from the spin axis, L_st"),
    Field::required("cup_radius", POSITIVE, "inner radius, r"),
    Field::required("bottom", POSITIVE, "distance from the hinge to the bottom along the cup, L"),
    Field::optional(
        "surface",
        length(Bounds::within(LARGEST)),
        "0 m",
        "distance from the hinge to the surface of the liquid along the cup, y_top",
    ),
    Field::optional(
        "centre_of_mass",
        POSITIVE,
        "",
        "distance from the hinge to the centre of mass of the cup with its contents, l; needed unless tilt is given",
    ),
    Field::optional(
        "tilt",
        FieldKind::Quantity { unit: "rad", bounds: Bounds::closed(0.0, FRAC_PI_2) },
        "",
        "a tilt from the vertical the cup is held at, instead of the one it swings out to",
    ),
    MASS,
    Field::optional(
        "centre_of_mass_across",
        length(Bounds::within(LARGEST)),
        "0 m",
        "centre of mass across the cup, outwards when it hangs",
    ),
    Field::optional(
        "moment_along",
        FieldKind::Quantity { unit: "kg m^2", bounds: Bounds::positive(1e4) },
        "",
        "second moment about the hinge along the cup, Jy = int y^2 dm; that of a point mass when absent",
    ),
    Field::optional(
        "moment_across",
        FieldKind::Quantity { unit: "kg m^2", bounds: Bounds::up_to(1e4) },
        "0 kg m^2",
        "second moment across the cup, Jx = int x^2 dm",
    ),
    Field::optional("moment_product", FieldKind::Quantity { unit: "kg m^2", bounds: Bounds::within(1e4) }, "0 kg m^2", "Jxy = int x y dm"),
    Field::optional(
        "hinge_damping",
        FieldKind::Quantity { unit: "1/s", bounds: Bounds::up_to(1e6) },
        "0 1/s",
        "rate at which the hinge damps the swing, cd",
    ),
    DIFFERENCES,
    Field::optional(
        "centre_differences",
        FieldKind::List { unit: "m", bounds: Bounds::within(1.0) },
        "",
        "how much farther from the hinge each one's centre of mass lies: pellets of different height in cups that weigh the same",
    ),
];

const FIXED_ANGLE: &[Field] = &[
    ON,
    COUNT,
    Field::required("mouth_radius", length(Bounds::up_to(LARGEST)), "radius of the centre of the mouth from the spin axis"),
    Field::required(
        "angle",
        FieldKind::Quantity { unit: "rad", bounds: Bounds { min: 0.0, max: FRAC_PI_2, min_open: true } },
        "angle between tube and spin axis",
    ),
    Field::required("tube_radius", POSITIVE, "inner radius, r"),
    Field::required("length", POSITIVE, "from the mouth to the bottom"),
    Field::optional(
        "surface",
        length(Bounds::up_to(LARGEST)),
        "0 m",
        "from the mouth to the surface of the liquid when the tube stands upright",
    ),
    Field::optional("centre_of_mass", POSITIVE, "", "distance from the mouth to the centre of mass of the tube with its contents"),
    MASS,
    DIFFERENCES,
];

const TUBULAR: &[Field] = &[
    Field::required("length", POSITIVE, "length of the liquid, Lb"),
    Field::required("bowl_radius", POSITIVE, "inner radius of the bowl, r2"),
    Field::required("surface_radius", POSITIVE, "radius of the liquid's surface, r1"),
];
const DISCS: &[Field] = &[
    Field::required("inner_radius", POSITIVE, "inner edge of the discs, r1"),
    Field::required("outer_radius", POSITIVE, "outer edge of the discs, r2"),
    Field::required(
        "angle",
        FieldKind::Quantity { unit: "rad", bounds: Bounds { min: 0.0, max: 1.57, min_open: true } },
        "angle between disc and spin axis, th",
    ),
    Field::required("gaps", FieldKind::Integer { min: 1, max: 100_000 }, "number of gaps, N"),
    Field::optional("spacing", POSITIVE, "0.5 mm", "width of a gap across the discs; it sets the residence time, not the throughput"),
];
const DECANTER: &[Field] = &[
    Field::required("cylinder_length", POSITIVE, "length of the cylinder, L1"),
    Field::required("cone_length", length(Bounds::up_to(LARGEST)), "wetted length of the cone, L2"),
    Field::required("bowl_radius", POSITIVE, "inner radius of the bowl, r2"),
    Field::required("surface_radius", POSITIVE, "radius of the liquid's surface, r1"),
    Field::optional(
        "cone",
        FieldKind::Choice(&[
            ("textbook", "C = (r2^2 + 3 r1 r2 + 4 r1^2)/8"),
            ("slices", "C = (r2^2 + r1 r2 + 2 r1^2)/4: tubular slices averaged over the cone"),
        ]),
        "textbook",
        "how the cone counts in Sigma",
    ),
];

/// Kinds of `[[cup]]`.
pub fn cup_kinds() -> Vec<KindInfo> {
    let k = |kind, doc, example, fields: &[Field]| KindInfo { kind, doc, example, fields: fields.to_vec(), lists: Vec::new() };
    vec![
        k(
            "swinging",
            "Cups that hang on hinges and swing out as the rotor turns: their tilt follows from the speed, and what they weigh loads the rotor at the radius they reach.",
            r#"on = "drum"
count = 4
mass = "2.6 kg"                     # each, filled
centre_of_mass = "170 mm"           # from the hinge, filled
hinge_radius = "200 mm"
cup_radius = "45 mm"
bottom = "300 mm"                   # from the hinge
surface = "20 mm"                   # from the hinge
"#,
            SWINGING,
        ),
        k(
            "fixed_angle",
            "Tubes held at an angle; the surface of their liquid follows the field.",
            r#"on = "drum"
count = 6
mass = "80 g"                       # each, filled
centre_of_mass = "50 mm"            # from the mouth, along the tube
mouth_radius = "50 mm"
angle = "34 deg"
tube_radius = "14 mm"
length = "100 mm"
"#,
            FIXED_ANGLE,
        ),
        k(
            "tubular_bowl",
            "A bowl that liquid flows through along the axis. The bowl itself is a body of the machine, and its liquid a [[part]] of kind \"liquid\" in that body: without it the \
             liquid is not in the dynamics.",
            r#"length = "750 mm"
bowl_radius = "52 mm"
surface_radius = "20 mm"
"#,
            TUBULAR,
        ),
        k(
            "disc_stack",
            "A stack of conical discs that liquid flows through from the outside in. Its liquid is in the dynamics as a [[part]] of kind \"liquid\" in the body that is the bowl.",
            r#"inner_radius = "50 mm"
outer_radius = "120 mm"
angle = "40 deg"                    # between the discs and the axis
gaps = 100
spacing = "0.5 mm"
"#,
            DISCS,
        ),
        k(
            "decanter",
            "A bowl with a cone and a screw; it separates like a tubular bowl of the same Sigma. Its liquid is in the dynamics as a [[part]] of kind \"liquid\" in the body \
             that is the bowl.",
            r#"cylinder_length = "800 mm"
cone_length = "250 mm"
bowl_radius = "180 mm"
surface_radius = "120 mm"
"#,
            DECANTER,
        ),
    ]
}

/// What `[suspension]` is.
pub const SUSPENSION_DOC: &str = "What is separated: the liquid, and the size and density of the particles in it.";

const VISCOSITY: FieldKind = FieldKind::Quantity { unit: "Pa s", bounds: Bounds::positive(1e7) };
const SIZE: FieldKind = FieldKind::Quantity { unit: "m", bounds: Bounds { min: 1e-9, max: 0.1, min_open: false } };
const DENSITY: FieldKind = FieldKind::Quantity { unit: "kg/m^3", bounds: Bounds { min: 0.01, max: 3e4, min_open: false } };
const TEMPERATURE: FieldKind = FieldKind::Quantity { unit: "K", bounds: Bounds::closed(50.0, 3000.0) };

/// A typical `[suspension]`.
pub const SUSPENSION_EXAMPLE: &str = r#"liquid_density = "998 kg/m^3"
viscosity = "1 mPa s"
particle_density = "2650 kg/m^3"
characteristic_diameter = "25 um"   # Rosin and Rammler: 63 % are smaller
spread = 1.3
volume_fraction = "2 %"
"#;

/// Fields of `[suspension]`.
pub const SUSPENSION: &[Field] = &[
    Field::required("liquid_density", DENSITY, "density of the liquid, rho_f"),
    Field::optional("viscosity", VISCOSITY, "", "dynamic viscosity of the liquid, mu; this or viscosity_table"),
    Field::optional(
        "viscosity_table",
        FieldKind::Columns(&[("temperature", "K", true, "temperatures, increasing"), ("viscosity", "Pa s", true, "viscosity at each")]),
        "",
        "viscosity over temperature; between the rows ln mu is a monotone cubic (PCHIP, slopes of Fritsch and Butland)",
    ),
    Field::optional("temperature", TEMPERATURE, "", "temperature of the liquid; needed with viscosity_table"),
    Field::required("particle_density", DENSITY, "density of the particles, rho_p; the median where they differ"),
    Field::optional(
        "density_deviation",
        FieldKind::Quantity { unit: "", bounds: Bounds { min: 1.0, max: 10.0, min_open: true } },
        "",
        "geometric standard deviation of the densities (log-normal)",
    ),
    Field::optional(
        "densities",
        FieldKind::Columns(&[("density", "kg/m^3", true, "densities, increasing"), ("share", "", true, "share of each class")]),
        "",
        "classes of density, instead of one",
    ),
    Field::optional("diameter", SIZE, "", "diameter of the particles, when all are equal"),
    Field::optional("median_diameter", SIZE, "", "median diameter of a log-normal powder, by mass"),
    Field::optional(
        "geometric_deviation",
        FieldKind::Quantity { unit: "", bounds: Bounds { min: 1.0, max: 100.0, min_open: true } },
        "",
        "geometric standard deviation of that powder",
    ),
    Field::optional("characteristic_diameter", SIZE, "", "diameter with 63.2 % below, of a powder after Rosin and Rammler"),
    Field::optional("spread", FieldKind::Quantity { unit: "", bounds: Bounds::positive(100.0) }, "", "exponent of that powder, n"),
    Field::optional(
        "sizes",
        FieldKind::Columns(&[
            ("diameter", "m", true, "diameters, increasing"),
            ("undersize", "", false, "share below each, up to 1"),
            ("share", "", false, "share of each class, instead of undersize"),
        ]),
        "",
        "a measured powder",
    ),
    Field::optional(
        "drag",
        FieldKind::Choice(&[
            ("stokes", "proportional to the velocity: Re below 1"),
            ("schiller_naumann", "up to turbulent flow around the particle"),
        ]),
        "stokes",
        "law of the drag",
    ),
    Field::optional(
        "added_mass",
        FieldKind::Quantity { unit: "", bounds: Bounds::up_to(10.0) },
        "0",
        "added-mass coefficient Ca; 0.5 for spheres that are not much denser than the liquid",
    ),
    Field::optional("lift", FieldKind::Quantity { unit: "", bounds: Bounds::within(10.0) }, "0", "lift coefficient CL"),
    Field::optional(
        "volume_fraction",
        FieldKind::Quantity { unit: "", bounds: Bounds { min: 0.0, max: 0.6, min_open: false } },
        "0",
        "volume fraction of the particles, phi",
    ),
    Field::optional(
        "hindered_exponent",
        FieldKind::Quantity { unit: "", bounds: Bounds::up_to(20.0) },
        "4.65",
        "exponent of Richardson and Zaki",
    ),
    Field::optional("drop_viscosity", VISCOSITY, "", "viscosity inside clean drops, whose surface moves and lowers the drag"),
    Field::optional(
        "shape_factor",
        FieldKind::Quantity { unit: "", bounds: Bounds::closed(0.1, 100.0) },
        "1",
        "drag over that of a sphere of the same volume",
    ),
];
