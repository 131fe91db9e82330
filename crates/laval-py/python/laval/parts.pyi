"""Elements of machines: one function for each kind of part, with the keys of the machine file.

Written by crates/laval-py/stubs.py from the registry of the library.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from laval._blocks import Extra, Part, Study
from laval._types import Lateral, Named, ParameterRange, Point, Quantities, Quantity, Range, Tolerance

__all__ = ['disc', 'foundation', 'damper', 'bearing_linear', 'bearing_cubic', 'bearing_hertz', 'bearing_rolling', 'bearing_journal', 'squeeze_film', 'shaft', 'shaft_lumped', 'shaft_span', 'shaft_viscoelastic', 'stop', 'liquid', 'balancer_ball', 'constant_force', 'coupling', 'speed_ratio', 'gear', 'motor', 'spin_load']

def __getattr__(name: str) -> Any: ...
def __dir__() -> list[str]: ...

def disc(
    *,
    name: str | None = None,
    mass: Quantity,
    on: Point | None = None,
    spin: str | None = None,
    axial: bool | None = None,
    torsional: bool | None = None,
    unbalances: Mapping[Literal["unbalance", "phase", "at"], Quantities] | None = None,
    eccentricity: Quantity | None = None,
    eccentricity_phase: Quantity | None = None,
    unbalance: Quantity | None = None,
    polar_inertia: Quantity | None = None,
    diametral_inertia: Quantity | None = None,
    skew: Quantity | None = None,
    skew_phase: Quantity | None = None,
    centre_of_mass: Quantity | None = None,
) -> Part:
    """A rigid disc on the shaft: mass, static unbalance, and with diametral_inertia also tilt, gyroscopic coupling and dynamic unbalance. Other parts attach to it. With mass = 0 it is a point without inertia, as between two springs in series.

    Args:
        name: by which others refer to it.
        mass: mass m (required).
            a mass (kg, g, t), between 0 and 1e7 kg
        on: the point of a shaft or of another body that it is fixed to and moves with; without it the disc has coordinates of its own (optional).
            a point: "drum" or { body = "drum", at = "40 mm" }
        spin: the part of kind "speed_ratio" with which it turns; without it, it turns with the body that carries it or else at the speed of the machine (optional).
            a text
        axial: a disc with coordinates of its own also moves along its axis (default false).
            true or false
        torsional: a disc with coordinates of its own also twists: twist is its rotation relative to the spin (default false).
            true or false
        unbalances: several unbalances, in addition to eccentricity and unbalance: sizes, directions and heights (optional).
            columns of equal length { unbalance: size [an unbalance]; phase: direction from the key mark [an angle], optional; at: height of its plane above the reference point, for a disc that tilts [a length], optional }, or a list of rows { unbalance = .., .. }
        eccentricity: distance e of the centre of mass from the shaft centre (default 0.0 m).
            a length (mm, m, µm), between 0 and 500 mm
        eccentricity_phase: direction of the eccentricity from the key mark (default 0.0 rad).
            an angle (deg, rad), between -1000 rad (-57300 deg) and 1000 rad (57300 deg)
        unbalance: additional unbalance in the direction of the eccentricity (default 0.0 kg m).
            an unbalance (g mm, kg mm, kg m), between 0 and 10000 kg m
        polar_inertia: polar moment of inertia C; left out it is 0, and neither a torque nor a run-up with drive = "free" counts this disc (default 0.0 kg m^2).
            a moment of inertia (kg m^2, kg mm^2), between 0 and 1e8 kg m^2
        diametral_inertia: diametral moment of inertia A; when given, the disc tilts (default 0.0 kg m^2).
            a moment of inertia (kg m^2, kg mm^2), between 0 and 1e8 kg m^2
        skew: angle tau by which the principal axis is turned out of the shaft (dynamic unbalance) (default 0.0 rad).
            an angle (deg, rad), between -0.5 rad (-28.65 deg) and 0.5 rad (28.65 deg)
        skew_phase: angle phi_t from the key mark to the axis about which the skew turns; the upper end of the principal axis then leans a quarter turn behind it (default 0.0 rad).
            an angle (deg, rad), between -1000 rad (-57300 deg) and 1000 rad (57300 deg)
        centre_of_mass: height h of the centre of mass above the reference point (default 0.0 m).
            a length (mm, m, µm), between -100 m and 100 m

    In a machine file::

        [[part]]
        kind = "disc"
        name = "drum"
        mass = "12 kg"
        eccentricity = "20 um"
        polar_inertia = "0.08 kg m^2"
        diametral_inertia = "0.06 kg m^2"   # with it the disc tilts
        skew = "0.1 mrad"                   # dynamic unbalance
    """

def foundation(
    *,
    name: str | None = None,
    mass: Quantity,
    stiffness: Lateral,
    damping: Lateral | None = None,
) -> Part:
    """A foundation block on elastic supports to the ground, movable in x and y. Other parts attach to it. With mass = 0 it is a point without inertia on its supports.

    Args:
        name: by which others refer to it.
        mass: mass M (required).
            a mass (kg, g, t), between 0 and 1e9 kg
        stiffness: stiffness c2 of all supports together (required).
            a stiffness (N/m, N/mm, MN/m), between 0 and 1e15 N/m; one value, or { x = .., y = .. }
        damping: damping chi0 of all supports together (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between 0 and 1e12 N s/m; one value, or { x = .., y = .. }

    In a machine file::

        [[part]]
        kind = "foundation"
        name = "base"
        mass = "60 kg"
        stiffness = { x = "2.4e6 N/m", y = "1.8e6 N/m" }
        damping = "900 N s/m"
    """

def damper(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    damping: Lateral,
    axes: Literal["fixed", "rotating"] | None = None,
    tilt_damping: Quantity | None = None,
) -> Part:
    """A viscous damper between two points or to the ground. axes = "rotating" is damping inside the rotor, which destabilises above the critical speed. tilt_damping adds the same on tilt.

    Args:
        name: by which others refer to it.
        between: the two points it joins (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        damping: damping c (required).
            a damping constant (N s/m, kN s/m), between 0 and 1e12 N s/m; one value, or { x = .., y = .. }
        axes: axes the damping acts in (default fixed).
            "fixed" (axes at rest) or "rotating" (axes that turn with the rotor)
        tilt_damping: tilt damping ct; when given, the damper acts on tilt (default 0.0 N m s).
            an angular momentum (N m s), between 0 and 1e12 N m s

    In a machine file::

        [[part]]
        kind = "damper"
        between = ["drum", "ground"]
        damping = "250 N s/m"
        axes = "fixed"                      # "rotating" is damping inside the rotor
    """

def bearing_linear(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    table: Mapping[Literal["speed", "frequency", "kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"], Quantities] | None = None,
    beyond: Literal["refuse", "hold", "linear"] | None = None,
    stiffness: Quantity | None = None,
    damping: Quantity | None = None,
    kxx: Quantity | None = None,
    kxy: Quantity | None = None,
    kyx: Quantity | None = None,
    kyy: Quantity | None = None,
    cxx: Quantity | None = None,
    cxy: Quantity | None = None,
    cyx: Quantity | None = None,
    cyy: Quantity | None = None,
    kzz: Quantity | None = None,
    czz: Quantity | None = None,
) -> Part:
    """A bearing or seal given by its eight linear coefficients kxx kxy kyx kyy cxx cxy cyx cyy, constant, in a table over speed, or in one over speed and frequency of vibration. The force on the first point is -K d - C d'; kxy > 0 > kyx drives forward whirl.

    Args:
        name: by which others refer to it.
        between: the two points it joins (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        table: coefficients over speed, or over speed and frequency of vibration, instead of constant ones; between the rows each column is a monotone cubic (PCHIP, slopes of Fritsch and Butland), which stays between the values of neighbouring rows; two rows are joined by a straight line; with frequencies first over the frequency at each speed, then over the speed (optional).
            columns of equal length { speed: spin speed, increasing from row to row where no frequency is given [a speed]; frequency: frequency of vibration; the rows are then all pairs of the speeds and frequencies, in any order [a speed], optional; kxx: stiffness in x against x [a stiffness]; kxy: force in -x per displacement in y [a stiffness], optional; kyx: force in -y per displacement in x [a stiffness], optional; kyy: stiffness in y against y [a stiffness]; cxx: damping in x against x [a damping constant], optional; cxy: force in -x per velocity in y [a damping constant], optional; cyx: force in -y per velocity in x [a damping constant], optional; cyy: damping in y against y [a damping constant], optional }, or a list of rows { speed = .., .. }
        beyond: coefficients at speeds and frequencies outside the table (default refuse).
            "refuse" (a study beyond the speeds or frequencies of the table is refused) or "hold" (the first and last row hold beyond; results there are marked as outside the table) or "linear" (straight on along the slope at the ends; results there are marked as outside the table)
        stiffness: one stiffness in all directions, instead of kxx and kyy (optional).
            a stiffness (N/m, N/mm, MN/m), between -1e15 N/m and 1e15 N/m
        damping: one damping in all directions, instead of cxx and cyy (optional).
            a damping constant (N s/m, kN s/m), between -1e12 N s/m and 1e12 N s/m
        kxx: stiffness in x against x (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between -1e15 N/m and 1e15 N/m
        kxy: force in -x per displacement in y (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between -1e15 N/m and 1e15 N/m
        kyx: force in -y per displacement in x (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between -1e15 N/m and 1e15 N/m
        kyy: stiffness in y against y (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between -1e15 N/m and 1e15 N/m
        cxx: damping in x against x (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between -1e12 N s/m and 1e12 N s/m
        cxy: force in -x per velocity in y (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between -1e12 N s/m and 1e12 N s/m
        cyx: force in -y per velocity in x (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between -1e12 N s/m and 1e12 N s/m
        cyy: damping in y against y (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between -1e12 N s/m and 1e12 N s/m
        kzz: stiffness along the axis, at every speed; when given, the bearing acts on axial motion (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between 0 and 1e15 N/m
        czz: damping along the axis, with kzz (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between 0 and 1e12 N s/m

    In a machine file::

        [[part]]
        kind = "bearing_linear"
        between = ["drum", "ground"]
        kxx = "2e7 N/m"
        kxy = "5e6 N/m"
        kyx = "-5e6 N/m"
        kyy = "3e7 N/m"
        cxx = "2e4 N s/m"
        cyy = "3e4 N s/m"
    """

def bearing_cubic(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    law: Literal["per_axis", "isotropic"],
    stiffness: Lateral,
    cubic_stiffness: Lateral,
    valid_to: Quantity | None = None,
) -> Part:
    """A bearing whose force grows with the deflection and its cube. law = "per_axis" treats x and y apart, law = "isotropic" is the same in all directions; the two have different jumps, so the law is always named.

    Args:
        name: by which others refer to it.
        between: the two points it joins (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        law: how the cubic force depends on direction (required).
            "per_axis" (c0 dx + c1 dx^3 and c0 dy + c1 dy^3) or "isotropic" (c0 d + c1 |d|^2 d)
        stiffness: linear coefficient c0 of the total force (required).
            a stiffness (N/m, N/mm, MN/m), between 0 and 1e15 N/m; one value, or { x = .., y = .. }
        cubic_stiffness: cubic coefficient c1 of the total force (required).
            a cubic stiffness (N/m^3, N/mm^3), between -1e24 N/m^3 and 1e24 N/m^3; one value, or { x = .., y = .. }
        valid_to: largest deflection the coefficients were fitted for; 0 states none (default 0.0 m).
            a length (mm, m, µm), between 0 and 1 m

    In a machine file::

        [[part]]
        kind = "bearing_cubic"
        between = ["drum", "ground"]
        law = "isotropic"
        stiffness = "1.1e7 N/m"
        cubic_stiffness = "8.7e10 N/m^3"
        valid_to = "2 mm"
    """

def bearing_hertz(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    law: Literal["radial", "per_axis"],
    balls: int | None = None,
    ball_diameter: Quantity | None = None,
    contact_angle: Quantity | None = None,
    coefficient: Quantity | None = None,
    clearance: Quantity | None = None,
) -> Part:
    """A rolling bearing with the force of Hertz contacts, growing with the deflection to the power 3/2, with clearance or preload. Without preload it has no stiffness at rest; a linear study of a machine that other parts hold inside the clearance leaves it open.

    Args:
        name: by which others refer to it.
        between: the two points it joins (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        law: how the force depends on direction (required).
            "radial" (Cb [|d| - d0]^(3/2) along d: the same in all directions) or "per_axis" (opposed contacts on each axis; a negative clearance is a preloaded pair)
        balls: number of steel balls, from which the coefficient follows, in place of coefficient: (2/3 13e6)^(3/2) n D^(1/2) cos(a)^(5/2) (optional).
            a whole number from 3 to 200
        ball_diameter: diameter D of a ball, with balls (optional).
            a length (mm, m, µm), between 100 µm and 1 m
        contact_angle: contact angle a of the balls; 0 unless given (optional).
            an angle (deg, rad), between 0 and 1.4 rad (80.21 deg)
        coefficient: contact coefficient Cb of the whole bearing; or give balls and ball_diameter (default 0.0 N/m^1.5).
            a Hertz contact stiffness (N/m^1.5, N/mm^1.5), between 0 and 1e20 N/m^1.5
        clearance: radial clearance d0; negative is interference (preload), per axis only (default 0.0 m).
            a length (mm, m, µm), between -100 mm and 100 mm

    In a machine file::

        [[part]]
        kind = "bearing_hertz"
        between = ["drum", "ground"]
        law = "radial"
        coefficient = "3e9 N/m^1.5"
        clearance = "10 um"
    """

def bearing_rolling(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    elements: Literal["balls", "rollers"],
    count: int,
    size: Quantity,
    load: Quantity,
    load_direction: Literal["x", "y"] | None = None,
    contact_angle: Quantity | None = None,
    ratio: Quantity | None = None,
    damping_time: Quantity | None = None,
) -> Part:
    """A ball or roller bearing from its geometry and load: stiffness along the load and across it, linear about the deflection under the load. bearing_hertz keeps the force law of balls for large motion.

    Args:
        name: by which others refer to it.
        between: the two points it joins (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        elements: rolling elements (required).
            "balls" (steel balls) or "rollers" (steel rollers)
        count: number of rolling elements (required).
            a whole number from 3 to 200
        size: diameter D of a ball, or length l of a roller (required).
            a length (mm, m, µm), between 100 µm and 1 m
        load: static load F on the bearing (required).
            a force (N, kN), above 0 and at most 1 GN
        load_direction: direction of the static load (default y).
            "x" (along x) or "y" (along y)
        contact_angle: contact angle a (default 0.0 rad).
            an angle (deg, rad), between 0 and 1.4 rad (80.21 deg)
        ratio: stiffness across the load over that along it; 0 takes the value for the number of rolling elements, from 8 to 16 (default 0.0 ).
            a pure number, between 0 and 10
        damping_time: damping over stiffness t; measured values are 0.25e-5 s to 2.5e-5 s (default 1.25e-5 s).
            a time (s, ms, min), between 0 and 1 s

    In a machine file::

        [[part]]
        kind = "bearing_rolling"
        between = ["drum", "ground"]
        elements = "balls"
        count = 12
        size = "10 mm"
        load = "250 N"
    """

def bearing_journal(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    diameter: Quantity,
    length: Quantity,
    clearance: Quantity,
    viscosity: Quantity,
    film: Literal["ruptured", "full"] | None = None,
) -> Part:
    """A plain journal bearing from its geometry, load, speed and oil by the closed form of the short bearing: nonlinear film forces, with the eight coefficients at the state where it carries the load. It drives whirl (oil whirl) where it carries little.

    Args:
        name: by which others refer to it.
        between: the journal and what the bearing is fixed to (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        diameter: diameter 2 R of the journal (required).
            a length (mm, m, µm), between 100 µm and 10 m
        length: length L of the bearing along the axis (required).
            a length (mm, m, µm), between 10 µm and 10 m
        clearance: radial clearance c: half of the difference of the diameters (required).
            a length (mm, m, µm), between 100 nm and 100 mm
        viscosity: dynamic viscosity mu of the oil at its temperature in the film (required).
            a dynamic viscosity (mPa s, Pa s, cP), between 1 µPa s and 1 kPa s
        film: where the film carries pressure (default ruptured).
            "ruptured" (pressure only where it is positive, as in a bearing with free ends) or "full" (pressure all around, as in a film under high supply pressure)

    In a machine file::

        [[part]]
        kind = "bearing_journal"
        between = ["drum", "ground"]
        diameter = "60 mm"
        length = "25 mm"
        clearance = "60 um"
        viscosity = "20 mPa s"
    """

def squeeze_film(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    diameter: Quantity,
    length: Quantity,
    clearance: Quantity,
    viscosity: Quantity,
    film: Literal["ruptured", "full"] | None = None,
) -> Part:
    """A squeeze-film damper from its geometry and oil by the closed form of the short film: it damps without stiffness, with forces that grow with the eccentricity. What centres its ring is another part.

    Args:
        name: by which others refer to it.
        between: the ring and its housing (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        diameter: diameter 2 R of the film (required).
            a length (mm, m, µm), between 100 µm and 10 m
        length: length L of the film along the axis (required).
            a length (mm, m, µm), between 10 µm and 10 m
        clearance: radial clearance c: half of the difference of the diameters (required).
            a length (mm, m, µm), between 100 nm and 100 mm
        viscosity: dynamic viscosity mu of the oil at its temperature in the film (required).
            a dynamic viscosity (mPa s, Pa s, cP), between 1 µPa s and 1 kPa s
        film: where the film carries pressure (default ruptured).
            "ruptured" (pressure only where it is positive, as in a bearing with free ends) or "full" (pressure all around, as in a film under high supply pressure)

    In a machine file::

        [[part]]
        kind = "squeeze_film"
        between = ["drum", "ground"]
        diameter = "120 mm"
        length = "30 mm"
        clearance = "0.15 mm"
        viscosity = "10 mPa s"
        film = "full"
    """

def shaft(
    *,
    name: str | None = None,
    section: Mapping[Literal["length", "outer_diameter", "inner_diameter", "end_outer_diameter", "end_inner_diameter"], Quantities],
    spin: str | None = None,
    layer: Mapping[Literal["from", "to", "outer_diameter", "inner_diameter", "modulus", "shear_modulus", "density", "stiffness"], Quantities] | None = None,
    material: Literal["steel", "stainless_steel", "aluminium", "titanium", "cast_iron"] | None = None,
    elements: int | Literal["auto"] | None = None,
    shear: Literal["cowper", "hutchinson", "none"] | None = None,
    cone: Literal["flexibility", "mid_section"] | None = None,
    axial: bool | None = None,
    torsional: bool | None = None,
    modulus: Quantity | None = None,
    shear_modulus: Quantity | None = None,
    density: Quantity | None = None,
    axial_force: Quantity | None = None,
    torque: Quantity | None = None,
    rotating_damping: Quantity | None = None,
    mass_damping: Quantity | None = None,
    stiffness_damping: Quantity | None = None,
) -> Part:
    """An elastic shaft of sections: finite elements with bending, shear, rotary inertia and gyroscopic coupling. Other parts attach anywhere along it, at = "120 mm" from its lower end, and each gets a node; discs that give on = { body = .., at = .. } sit on it. It holds itself nowhere: bearings do.

    Args:
        name: by which others refer to it.
        section: the sections from the lower end to the upper: as many entries in each list (required).
            columns of equal length { length: length of the section [a length]; outer_diameter: outer diameter, of a conical section at its lower end [a length]; inner_diameter: inner diameter of a hollow section, of a conical one at its lower end [a length], optional; end_outer_diameter: outer diameter at the upper end of a conical section; 0 where it stays the same [a length], optional; end_inner_diameter: inner diameter at the upper end; 0 where it stays the same [a length], optional }, or a list of rows { length = .., .. }
        spin: the part of kind "speed_ratio" with which it turns; without it, it turns with the body that carries it or else at the speed of the machine (optional).
            a text
        layer: cylindrical layers on the shaft or in its bore, such as sleeves: as many entries in each list; stiffnesses and masses of layers and shaft add up, with one slope and one shear angle (optional).
            columns of equal length { from: position of its lower end [a length]; to: position of its upper end [a length]; outer_diameter: outer diameter [a length]; inner_diameter: inner diameter: of a sleeve that of the shaft under it [a length]; modulus: Young's modulus; 0 where it is that of the shaft [a pressure], optional; shear_modulus: shear modulus; 0 where it is that of the shaft [a pressure], optional; density: density; 0 where it is that of the shaft [a density], optional; stiffness: share of its stiffness that counts, 1 unless given; 0 is a layer with mass alone [a pure number], optional }, or a list of rows { from = .., .. }
        material: material; modulus, shear_modulus and density are its values unless given (default steel).
            "steel" (E 210 GPa, G 80.8 GPa, 7850 kg/m^3) or "stainless_steel" (austenitic: E 193 GPa, G 75 GPa, 7950 kg/m^3) or "aluminium" (wrought alloys: E 70 GPa, G 26.3 GPa, 2700 kg/m^3) or "titanium" (Ti-6Al-4V: E 114 GPa, G 43 GPa, 4430 kg/m^3) or "cast_iron" (with spheroidal graphite: E 169 GPa, G 66 GPa, 7100 kg/m^3)
        elements: number of elements of every section; auto makes them half as long as thick, 60 for the whole shaft at most (default auto).
            a whole number from 1 to 500, or "auto"
        shear: shear deflection (default cowper).
            "cowper" (with Cowper's coefficient) or "hutchinson" (with Hutchinson's coefficient) or "none" (left out: a slender beam of Euler and Bernoulli)
        cone: elements of conical sections (default flexibility).
            "flexibility" (from the flexibility of the cone: it converges fast) or "mid_section" (with the shape functions of the section in the middle, as other programs have it)
        axial: it also moves along its axis; something must hold it there, such as kzz of a bearing (default false).
            true or false
        torsional: it also twists: twist is the rotation relative to the spin; a coupling to "ground" joins it to a drive that turns at the spin speed (default false).
            true or false
        modulus: Young's modulus E; left out it is that of the material (default 2.1e11 Pa).
            a pressure (bar, MPa, Pa), between 100 kPa and 1e13 Pa
        shear_modulus: shear modulus G; left out it is that of the material (default 8.08e10 Pa).
            a pressure (bar, MPa, Pa), between 100 kPa and 1e13 Pa
        density: density rho; left out it is that of the material (default 7850.0 kg/m^3).
            a density (kg/m^3, g/cm^3), between 0.001 kg/m^3 and 100000 kg/m^3
        axial_force: axial force P along the whole shaft, tension positive (default 0.0 N).
            a force (N, kN), between -1e12 N and 1e12 N
        torque: torque T through the whole shaft: the upper part acts on the lower with +T about z (default 0.0 N m).
            a torque (N m, kN m), between -1e12 N m and 1e12 N m
        rotating_damping: viscous damping c of the material over its stiffness, in axes that turn: it destabilises above the critical speed (default 0.0 s).
            a time (s, ms, min), between 0 and 1 s
        mass_damping: damping a over mass, in fixed axes (default 0.0 1/s).
            a rate (1/s, 1/min), between 0 and 1e6 1/s
        stiffness_damping: damping b over stiffness, in fixed axes (default 0.0 s).
            a time (s, ms, min), between 0 and 1 s

    In a machine file::

        [[part]]
        kind = "shaft"
        section = { length = ["120 mm", "400 mm", "80 mm"], outer_diameter = ["40 mm", "60 mm", "40 mm"] }
        material = "steel"
    """

def shaft_lumped(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    lower_end: Literal["clamped", "pinned"] | None = None,
    upper_end: Literal["clamped", "pinned"] | None = None,
    moment: bool | None = None,
    stiffness: Lateral | None = None,
    cross_stiffness: Quantity | None = None,
    coupling: Quantity | None = None,
    tilt_stiffness: Quantity | None = None,
    material_damping: Quantity | None = None,
    diameter: Quantity | None = None,
    inner_diameter: Quantity | None = None,
    below: Quantity | None = None,
    above: Quantity | None = None,
    modulus: Quantity | None = None,
) -> Part:
    """A massless elastic shaft or support between two points: stiffness in x and y, optionally coupled to the tilt of a disc, and optionally with damping of the shaft's material, which turns with the rotor and destabilises above the critical speed. A round shaft gives its stiffness by its diameter, its lengths below and above the point and how its ends are held.

    Args:
        name: by which others refer to it.
        between: the two points it joins, the carried one first (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        lower_end: how the lower end of a round shaft is held by the second point's body (default clamped).
            "clamped" (against deflection and slope) or "pinned" (against deflection only)
        upper_end: how the upper end of a round shaft is held by the second point's body (default clamped).
            "clamped" (against deflection and slope) or "pinned" (against deflection only)
        moment: a round shaft acts on the tilt of what it carries; false for a body without tilt, which leaves the slope of the shaft free (default true).
            true or false
        stiffness: stiffness k (kx, ky), unless the geometry is given (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between 0 and 1e15 N/m; one value, or { x = .., y = .. }
        cross_stiffness: stiffness kxy = kyx of a support whose main axes are not x and y (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between -1e15 N/m and 1e15 N/m
        coupling: coupling kc of deflection and tilt: the moment about y per deflection along x. Negative where the first point lies above what holds the shaft (towards larger z), positive where it hangs below; a shaft of length L and bending stiffness EI clamped at its other end has -6 EI/L^2 or +6 EI/L^2, with stiffness 12 EI/L^3 and tilt_stiffness 4 EI/L (default 0.0 N/rad).
            a quantity in N/rad (N/rad), between -1e15 N/rad and 1e15 N/rad
        tilt_stiffness: tilt stiffness kt; when given, the shaft acts on tilt (default 0.0 N m/rad).
            a rotational stiffness (N m/rad, N m/deg), between 0 and 1e15 N m/rad
        material_damping: damping of the material b = c/k, in axes that turn with the rotor (default 0.0 s).
            a time (s, ms, min), between 0 and 1000 s
        diameter: diameter d of a round shaft, instead of its stiffness (default 0.0 m).
            a length (mm, m, µm), between 0 and 10 m
        inner_diameter: inner diameter di of a hollow shaft (default 0.0 m).
            a length (mm, m, µm), between 0 and 10 m
        below: length a of a round shaft from its lower end to the point; 0 when it has no lower end (default 0.0 m).
            a length (mm, m, µm), between 0 and 100 m
        above: length b of a round shaft from the point to its upper end; 0 when it has no upper end (default 0.0 m).
            a length (mm, m, µm), between 0 and 100 m
        modulus: Young's modulus E of a round shaft (default 2.06e11 Pa).
            a pressure (bar, MPa, Pa), between 100 kPa and 1e13 Pa

    In a machine file::

        [[part]]
        kind = "shaft_lumped"
        between = ["drum", "ground"]
        stiffness = "2.9e6 N/m"
        material_damping = "2e-5 s"         # loss of the material, turning with the shaft
    """

def shaft_span(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    below: Quantity,
    above: Quantity,
    diameter: Quantity,
    lower_support: Lateral,
    upper_support: Lateral,
    inner_diameter: Quantity | None = None,
    modulus: Quantity | None = None,
) -> Part:
    """A massless shaft of constant section on two elastic supports, from its geometry: stiffness of deflection and tilt at the point of the rotor it carries, in the planes of x and y. For its internal friction put a damper with rotating axes beside it.

    Args:
        name: by which others refer to it.
        between: the point of the rotor at which the lengths meet, and what the supports stand on (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        below: length a of the shaft from the lower support to the point (required).
            a length (mm, m, µm), between 100 µm and 100 m
        above: length b of the shaft from the point to the upper support (required).
            a length (mm, m, µm), between 100 µm and 100 m
        diameter: diameter d of the shaft (required).
            a length (mm, m, µm), between 10 µm and 10 m
        lower_support: stiffness k1 of the lower support (required).
            a stiffness (N/m, N/mm, MN/m), between 1 N/m and 1e15 N/m; one value, or { x = .., y = .. }
        upper_support: stiffness k2 of the upper support (required).
            a stiffness (N/m, N/mm, MN/m), between 1 N/m and 1e15 N/m; one value, or { x = .., y = .. }
        inner_diameter: inner diameter di of a hollow shaft (default 0.0 m).
            a length (mm, m, µm), between 0 and 10 m
        modulus: Young's modulus E of the shaft (default 2.06e11 Pa).
            a pressure (bar, MPa, Pa), between 100 kPa and 1e13 Pa

    In a machine file::

        [[part]]
        kind = "shaft_span"
        between = ["drum", "ground"]
        below = "250 mm"
        above = "350 mm"
        diameter = "35 mm"
        lower_support = "2e7 N/m"
        upper_support = { x = "2e7 N/m", y = "1.2e7 N/m" }
        modulus = "206 GPa"
    """

def shaft_viscoelastic(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    memory: Literal["rotor", "fixed"] | None = None,
    supports: Literal["given", "simply_supported", "clamped", "overhung", "cantilever", "first_mode"] | None = None,
    terms: Mapping[Literal["amplitude", "exponent", "decay"], Quantities] | None = None,
    exponentials: Mapping[Literal["share", "rate"], Quantities] | None = None,
    accuracy: Quantity | None = None,
    band: Quantity | None = None,
    stiffness: Quantity | None = None,
    modulus: Quantity | None = None,
    diameter: Quantity | None = None,
    length: Quantity | None = None,
    position: Quantity | None = None,
    amplitude: Quantity | None = None,
    exponent: Quantity | None = None,
    decay: Quantity | None = None,
) -> Part:
    """A massless shaft of viscoelastic material, whose force remembers the deflection: weakly singular kernels of Koltunov and Rzhanitsyn, exact in frequency and as a sum of exponentials in time, or given exponentials. The memory of a shaft turns with the rotor and destabilises it above the critical speed of the long-term stiffness; memory in fixed axes, as of a support, always damps.

    Args:
        name: by which others refer to it.
        between: the two points it joins, the carried one first (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        memory: axes in which the material remembers (default rotor).
            "rotor" (the material turns with the rotor and remembers in its axes) or "fixed" (a support or a shaft that does not turn)
        supports: how the stiffness follows from the geometry (default given).
            "given" (no geometry: the stiffness is given) or "simply_supported" (round shaft on simple supports) or "clamped" (round shaft clamped at both ends) or "overhung" (round shaft on two simple bearings, the disc beyond the second) or "cantilever" (round shaft clamped at one end) or "first_mode" (first bending mode of a round shaft on simple supports; the disc then has half the mass of the shaft)
        terms: several weakly singular terms, instead of one amplitude, exponent and decay (optional).
            columns of equal length { amplitude: A of each term, bare numbers in 1/s^a [a pure number]; exponent: a of each term [a pure number]; decay: b of each term [a rate] }, or a list of rows { amplitude = .., .. }
        exponentials: a sum of exponentials as the law itself (Prony series), instead of weakly singular terms (optional).
            columns of equal length { share: share of the stiffness that relaxes [a pure number]; rate: rate at which it relaxes, the inverse of the relaxation time [a rate] }, or a list of rows { share = .., .. }
        accuracy: relative error of the dynamic stiffness that the exponentials of weakly singular terms may make in time (default 1e-5).
            a pure number, between 1e-10 and 0.01
        band: highest frequency of motion, seen from the axes of the memory, at which they are that accurate (default 10000 rad/s).
            a speed (rad/s, rpm, Hz), between 0.01 rad/s (0.09549 rpm) and 1e7 rad/s (9.549e7 rpm)
        stiffness: instantaneous stiffness k at the disc, where supports = "given" (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between 0 and 1e15 N/m
        modulus: instantaneous modulus E of a round shaft (default 0.0 Pa).
            a pressure (bar, MPa, Pa), between 0 and 1e13 Pa
        diameter: diameter d of a round shaft (default 0.0 m).
            a length (mm, m, µm), between 0 and 10 m
        length: distance L of the supports (default 0.0 m).
            a length (mm, m, µm), between 0 and 1000 m
        position: place x of the disc: distance from the left support, from the clamp of a cantilever, or overhang beyond the second bearing (default 0.0 m).
            a length (mm, m, µm), between 0 and 1000 m
        amplitude: amplitude A of the kernel A t^(a-1) exp(-b t), a bare number in 1/s^a; to be given with exponent and decay unless terms or exponentials are (default 0.0 ).
            a pure number, between 0 and 1e9
        exponent: exponent a of the kernel, above 0 (default 0.0 ).
            a pure number, between 0 and 0.99
        decay: decay b of the kernel, above 0 (default 0.0 1/s).
            a rate (1/s, 1/min), between 0 and 1e9 1/s

    In a machine file::

        [[part]]
        kind = "shaft_viscoelastic"
        between = ["drum", "ground"]
        memory = "rotor"
        supports = "simply_supported"       # or give stiffness itself
        modulus = "20 GPa"
        diameter = "40 mm"
        length = "0.6 m"
        position = "0.3 m"
        amplitude = 0.008                   # kernel A t^(a-1) exp(-b t): A in 1/s^a
        exponent = 0.15                     # a
        decay = "0.05 1/s"                  # b
    """

def stop(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    stiffness: Quantity,
    gap: Quantity,
    damping: Quantity | None = None,
) -> Part:
    """A stop that is free inside a radial gap and pushes back outside, with stiffness and optional damping while in contact. It never pulls and has no friction.

    Args:
        name: by which others refer to it.
        between: the two points it keeps together (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        stiffness: contact stiffness k (required).
            a stiffness (N/m, N/mm, MN/m), above 0 and at most 1e15 N/m
        gap: radial gap g (required).
            a length (mm, m, µm), above 0 and at most 1 m
        damping: contact damping c (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between 0 and 1e12 N s/m

    In a machine file::

        [[part]]
        kind = "stop"
        between = ["drum", "ground"]
        stiffness = "5e7 N/m"
        gap = "0.5 mm"
        damping = "200 N s/m"
    """

def liquid(
    *,
    name: str | None = None,
    in_: Point,
    fill: Mapping[Literal["free_surface_radius", "volume_fraction", "volume", "mass"], Quantity],
    cavity_radius: Quantity,
    cavity_height: Quantity,
    density: Quantity,
    model: Literal["planar", "planar_tilt", "strip", "spatial", "frozen"] | None = None,
    axial_harmonics: int | Literal["auto"] | None = None,
    time_error: Quantity | None = None,
    wave_damping: Quantity | None = None,
    viscosity: Quantity | None = None,
    eccentricity: Quantity | None = None,
    eccentricity_phase: Quantity | None = None,
    skew: Quantity | None = None,
    skew_phase: Quantity | None = None,
) -> Part:
    """Liquid in a cylindrical cavity that turns with a body. Partly filled cavities carry waves that can make the rotor whirl by itself; the fill is given by the radius of the free surface, a volume fraction, a volume or a mass. On a disc that tilts, strip lets every slice flow by itself, without the pressure on the end caps (were the liquid solid, 3 (R^2 + r^2)/H^2 of the inertia against tilt that it keeps, with the radii R of the wall and r of the surface and the height H), and spatial adds both that and flow along the axis: exact in the frequency domain, in time by a sum over waves with a stated error. Of a viscous liquid motions in time have a rational form, with a stated error, at one constant speed.

    Args:
        name: by which others refer to it.
        in_: the body whose cavity it fills, at the middle of the cavity's height (required).
            a point: "drum" or { body = "drum", at = "40 mm" }
        fill: how much liquid (required).
            exactly one of { free_surface_radius: radius of the undisturbed free surface [a length (mm, m, µm), between 0 and 100 m]; volume_fraction: liquid volume over cavity volume [a pure number, between 0 and 1]; volume: liquid volume [a volume (l, ml, m^3), between 0 and 1e6 m^3]; mass: liquid mass [a mass (kg, g, t), between 0 and 1e9 kg] }
        cavity_radius: cavity radius R (required).
            a length (mm, m, µm), between 1 µm and 100 m
        cavity_height: cavity height h (required).
            a length (mm, m, µm), between 1 µm and 1000 m
        density: liquid density rho (required).
            a density (kg/m^3, g/cm^3), between 0.001 kg/m^3 and 30000 kg/m^3
        model: flow model (default planar).
            "planar" (plane flow, driven by the motion of the cavity centre; no reaction on tilt) or "planar_tilt" (plane flow, and of the reaction on tilt what needs no axial flow: an approximation) or "strip" (plane flow in every slice, driven by the motion of that slice) or "spatial" (flow in three dimensions; exact in the frequency domain, in time a sum over waves) or "frozen" (a rigid ring: for bounds only)
        axial_harmonics: with spatial: highest axial harmonic k of the series that is taken (1, 3, 5, ...); auto takes all (default auto).
            a whole number from 1 to 999, or "auto"
        time_error: with spatial or a viscosity: relative error that the form of the reaction in time may have; 1e-4 when absent; thin liquids in three dimensions need about 1e-2 (optional).
            a pure number, between 1e-6 and 0.1
        wave_damping: damping delta of the surface wave in rotor axes (default 0.0 1/s).
            a rate (1/s, 1/min), between 0 and 1e6 1/s
        viscosity: kinematic viscosity nu; above 0 the force is exact in the frequency domain; in time it has a form at constant speed (default 0.0 m^2/s).
            a kinematic viscosity (cSt, mm^2/s, m^2/s), between 0 and 10 m^2/s
        eccentricity: distance e of the middle of the cavity from the shaft (default 0.0 m).
            a length (mm, m, µm), between 0 and 1 m
        eccentricity_phase: direction of the eccentricity from the key mark (default 0.0 rad).
            an angle (deg, rad), between -1000 rad (-57300 deg) and 1000 rad (57300 deg)
        skew: angle tau by which the cavity's axis is turned out of the shaft; of a rotor that sits askew on its shaft the same as the disc's (default 0.0 rad).
            an angle (deg, rad), between -0.5 rad (-28.65 deg) and 0.5 rad (28.65 deg)
        skew_phase: angle phi_t from the key mark to the axis about which the skew turns (default 0.0 rad).
            an angle (deg, rad), between -1000 rad (-57300 deg) and 1000 rad (57300 deg)

    In a machine file::

        [[part]]
        kind = "liquid"
        in = "drum"
        cavity_radius = "150 mm"
        cavity_height = "80 mm"
        density = "1000 kg/m^3"
        fill = { volume_fraction = 0.1 }    # or free_surface_radius, volume, mass
        wave_damping = "4 1/s"
    """

def balancer_ball(
    *,
    name: str | None = None,
    on: Point,
    ball_mass: Quantity,
    track_radius: Quantity,
    balls: int | None = None,
    tracks: Mapping[Literal["balls", "radius", "tilt", "node_line"], Quantities] | None = None,
    mass_ratios: Quantities | None = None,
    rings: Literal["fixed", "free"] | None = None,
    body_tilt: bool | None = None,
    eccentricity: Quantity | None = None,
    eccentricity_phase: Quantity | None = None,
    tilt: Quantity | None = None,
    node_line: Quantity | None = None,
    housing_mass: Quantity | None = None,
    diametral_inertia: Quantity | None = None,
    polar_inertia: Quantity | None = None,
    tilt_stiffness: Quantity | None = None,
    tilt_damping: Quantity | None = None,
    drag: Quantity | None = None,
    dry_torque: Quantity | None = None,
    rolling_resistance: Quantity | None = None,
    friction_rate: Quantity | None = None,
    rolling_inertia: Quantity | None = None,
    ball_radius: Quantity | None = None,
    contact_stiffness: Quantity | None = None,
    contact_damping: Quantity | None = None,
    gravity: Quantity | None = None,
) -> Part:
    """An automatic ball balancer: rings with balls that run freely in circular tracks, eccentric or tilted, the tilt fixed or free. Above the critical speed the balls settle opposite the unbalance, if drag, external damping and tilt let them.

    Args:
        name: by which others refer to it.
        on: the body that carries it (required).
            a point: "drum" or { body = "drum", at = "40 mm" }
        ball_mass: mass m of a ball (required).
            a mass (kg, g, t), above 0 and at most 10000 kg
        track_radius: radius r of the circle the centres of the balls run on (required).
            a length (mm, m, µm), above 0 and at most 100 m
        balls: number of balls on the one track; with tracks, which say how many each has, leave it out or give their sum (default 2).
            a whole number from 1 to 64
        tracks: several tracks about one centre, one entry of each column for each track; { balls = [3, 2] } is three balls on the first and two on the second, numbered through: ball_1 to ball_3 run on the first, ball_4 and ball_5 on the second (optional).
            columns of equal length { balls: number of balls on each track [a pure number]; radius: radius over track_radius [a pure number], optional; tilt: tilt in addition to tilt [an angle], optional; node_line: node line in addition to node_line [an angle], optional }, or a list of rows { balls = .., .. }
        mass_ratios: mass of each ball over ball_mass in the order of their numbers, track by track, when they are unequal (optional).
            a list; a pure number, above 0 and at most 1e6
        rings: how the rings are mounted (default fixed).
            "fixed" (the tilt stays as it is) or "free" (each ring turns about its node line: its tilt is a coordinate)
        body_tilt: balls follow the tilt of the body; false for a body that does not tilt saves half the work (default true).
            true or false
        eccentricity: distance s of the ring centre from the shaft centre (default 0.0 m).
            a length (mm, m, µm), between 0 and 1 m
        eccentricity_phase: direction gamma of the ring centre from the key mark (default 0.0 rad).
            an angle (deg, rad), between -1000 rad (-57300 deg) and 1000 rad (57300 deg)
        tilt: tilt alpha of the tracks; of free rings, where their springs are relaxed (default 0.0 rad).
            an angle (deg, rad), between -1.5 rad (-85.94 deg) and 1.5 rad (85.94 deg)
        node_line: direction B of the node line, about which the tracks are tilted, from the key mark (not from the eccentricity of the ring) (default 0.0 rad).
            an angle (deg, rad), between -1000 rad (-57300 deg) and 1000 rad (57300 deg)
        housing_mass: mass m_b of the housing, at the ring centre (default 0.0 kg).
            a mass (kg, g, t), between 0 and 1e6 kg
        diametral_inertia: diametral moment of inertia Jx of one ring (default 0.0 kg m^2).
            a moment of inertia (kg m^2, kg mm^2), between 0 and 1e6 kg m^2
        polar_inertia: polar moment of inertia Jz of one ring (default 0.0 kg m^2).
            a moment of inertia (kg m^2, kg mm^2), between 0 and 1e6 kg m^2
        tilt_stiffness: spring k_a that holds a free ring (default 0.0 N m/rad).
            a rotational stiffness (N m/rad, N m/deg), between 0 and 1e15 N m/rad
        tilt_damping: damping c_a of a free ring (default 0.0 N m s).
            an angular momentum (N m s), between 0 and 1 GN m s
        drag: viscous drag torque c of a ball per rate of its angle (default 0.0 N m s).
            an angular momentum (N m s), between 0 and 1 MN m s
        dry_torque: dry friction torque T_d of a ball: where the track pulls less, the ball stays (default 0.0 N m).
            a torque (N m, kN m), between 0 and 1 MN m
        rolling_resistance: rolling resistance f: friction force over the centrifugal load of a ball (default 0.0 ).
            a pure number, between 0 and 10
        friction_rate: rate e of a ball below which dry friction fades: it creeps that slowly where it should stay (default 1e-3 rad/s).
            a speed (rad/s, rpm, Hz), between 1e-9 rad/s (9.549e-9 rpm) and 1e6 rad/s (9.549e6 rpm)
        rolling_inertia: added inertia along the track over that of the ball's mass: 2/5 (r_b/r_c)^2 for a ball that rolls with rolling radius r_c, 0 for one that slides (default 0.0 ).
            a pure number, between 0 and 10
        ball_radius: radius r_b of a ball, for contact and for how many fit (default 0.0 m).
            a length (mm, m, µm), between 0 and 10 m
        contact_stiffness: stiffness k of the contact of two balls; they pass through each other without (default 0.0 N m/rad^1.5).
            a quantity in N m/rad^1.5 (N m/rad^1.5), between 0 and 1e15 N m/rad^1.5
        contact_damping: damping chi of the contact: balls that meet at rate v part at about (1 - 2/3 chi v) v (default 0.0 s/rad).
            a quantity in s/rad (s/rad), between 0 and 1e6 s/rad
        gravity: acceleration of gravity along the axis, towards the foot (default 9.80665 m/s^2).
            an acceleration (m/s^2, gn), between -10000 m/s^2 and 10000 m/s^2

    In a machine file::

        [[part]]
        kind = "balancer_ball"
        on = "drum"
        balls = 2
        ball_mass = "3.6 g"
        track_radius = "100 mm"
        drag = "2e-3 N m s"
        eccentricity = "2 um"
        body_tilt = false                   # the drum moves in its plane
    """

def constant_force(
    *,
    name: str | None = None,
    on: Point,
    force_x: Quantity | None = None,
    force_y: Quantity | None = None,
    axial_force: Quantity | None = None,
    moment_about_x: Quantity | None = None,
    moment_about_y: Quantity | None = None,
) -> Part:
    """A force, and a moment, of constant size and direction on a point of a body: the pull of a belt, the radial or axial thrust of a pump. It bends the shaft and loads the bearings, in every study that starts from the state of rest.

    Args:
        name: by which others refer to it.
        on: point of a body on which it acts (required).
            a point: "drum" or { body = "drum", at = "40 mm" }
        force_x: force along x (default 0.0 N).
            a force (N, kN), between -1e12 N and 1e12 N
        force_y: force along y; up where the axis is horizontal (default 0.0 N).
            a force (N, kN), between -1e12 N and 1e12 N
        axial_force: force along the axis; of a body that moves along the axis (default 0.0 N).
            a force (N, kN), between -1e12 N and 1e12 N
        moment_about_x: moment about the x axis; of a body that tilts (default 0.0 N m).
            a torque (N m, kN m), between -1e12 N m and 1e12 N m
        moment_about_y: moment about the y axis; of a body that tilts (default 0.0 N m).
            a torque (N m, kN m), between -1e12 N m and 1e12 N m

    In a machine file::

        [[part]]
        kind = "constant_force"
        on = { body = "drum", at = "120 mm" }   # a belt that pulls up
        force_y = "800 N"
    """

def coupling(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    stiffness: Quantity | None = None,
    damping: Quantity | None = None,
    tilt_stiffness: Quantity | None = None,
    tilt_damping: Quantity | None = None,
    axial_stiffness: Quantity | None = None,
    axial_damping: Quantity | None = None,
    torsional_stiffness: Quantity | None = None,
    torsional_damping: Quantity | None = None,
) -> Part:
    """An elastic coupling between two shafts, or from a shaft to a drive that turns at the spin speed ("ground"): stiffness and damping of displacement, tilt, motion along the axis and rotation about it. Its damping turns with the rotor.

    Args:
        name: by which others refer to it.
        between: the two points it joins (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        stiffness: lateral stiffness k (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between 0 and 1e15 N/m
        damping: lateral damping c, in axes that turn with the rotor (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between 0 and 1e12 N s/m
        tilt_stiffness: stiffness against tilt (default 0.0 N m/rad).
            a rotational stiffness (N m/rad, N m/deg), between 0 and 1e15 N m/rad
        tilt_damping: damping of tilt, in axes that turn with the rotor (default 0.0 N m s).
            an angular momentum (N m s), between 0 and 1e12 N m s
        axial_stiffness: stiffness ka along the axis (default 0.0 N/m).
            a stiffness (N/m, N/mm, MN/m), between 0 and 1e15 N/m
        axial_damping: damping ca along the axis (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between 0 and 1e12 N s/m
        torsional_stiffness: stiffness kt about the axis (default 0.0 N m/rad).
            a rotational stiffness (N m/rad, N m/deg), between 0 and 1e15 N m/rad
        torsional_damping: damping ct about the axis (default 0.0 N m s).
            an angular momentum (N m s), between 0 and 1e12 N m s

    In a machine file::

        [[part]]
        kind = "coupling"
        between = ["drum", "ground"]
        torsional_stiffness = "2e5 N m/rad"
        torsional_damping = "20 N m s"
    """

def speed_ratio(
    *,
    name: str | None = None,
    ratio: Quantity,
) -> Part:
    """Another spin of the machine, at a fixed ratio to its speed: the inner shaft of two coaxial ones, or the driven shaft of a gear. A shaft or disc that names it turns with it, and so does all that is attached to that body.

    Args:
        name: by which others refer to it.
        ratio: speed over that of the machine; negative where it turns the other way (required).
            a pure number, between -10000 and 10000

    In a machine file::

        [[part]]
        kind = "speed_ratio"
        name = "inner"
        ratio = -1.4
    """

def gear(
    *,
    name: str | None = None,
    between: tuple[Point, Point] | list[Point],
    first_radius: Quantity,
    second_radius: Quantity,
    stiffness: Quantity,
    damping: Quantity | None = None,
    pressure_angle: Quantity | None = None,
    azimuth: Quantity | None = None,
    torque: Quantity | None = None,
) -> Part:
    """Two spur wheels in mesh on parallel shafts: stiffness and damping along the line of action join their displacements and their rotations. The ratio of the spins of the two bodies is that of the radii.

    Args:
        name: by which others refer to it.
        between: the points of the two shafts that carry the wheels (required).
            two points: ["drum", "base"]; one of them may be "ground", each may be { body = .., at = .. }
        first_radius: pitch radius r1 of the wheel on the first body (required).
            a length (mm, m, µm), between 100 µm and 100 m
        second_radius: pitch radius r2 of the wheel on the second body (required).
            a length (mm, m, µm), between 100 µm and 100 m
        stiffness: mean stiffness k of the mesh along the line of action (required).
            a stiffness (N/m, N/mm, MN/m), between 1 mN/m and 1e15 N/m
        damping: damping c of the mesh (default 0.0 N s/m).
            a damping constant (N s/m, kN s/m), between 0 and 1e12 N s/m
        pressure_angle: pressure angle phi (20 deg); negative where the other flanks carry: where the first wheel drives in the negative direction of rotation, or is driven in the positive one (default 0.3490658503988659 rad).
            an angle (deg, rad), between -0.8 rad (-45.84 deg) and 0.8 rad (45.84 deg)
        azimuth: direction a from the first wheel to the second, from the x axis (default 0.0 rad).
            an angle (deg, rad), between -1000 rad (-57300 deg) and 1000 rad (57300 deg)
        torque: torque T at the first wheel, its size: the force of the teeth that it takes bends the shafts and loads the bearings (default 0.0 N m).
            a torque (N m, kN m), between 0 and 1e12 N m

    In a machine file::

        [[part]]
        kind = "gear"
        between = ["drum", "pinion"]
        first_radius = "120 mm"
        second_radius = "60 mm"                # the pinion has a spin of ratio -2
        stiffness = "2e8 N/m"
    """

def motor(
    *,
    name: str | None = None,
    torque: Quantity,
    curve: Literal["constant", "linear", "squirrel_cage", "limited_power", "table"] | None = None,
    table: Mapping[Literal["speed", "share"], Quantities] | None = None,
    synchronous_speed: Quantity | None = None,
    breakdown_slip: Quantity | None = None,
    power: Quantity | None = None,
    drag: Quantity | None = None,
    inertia: Quantity | None = None,
) -> Part:
    """A motor with a torque curve: constant, linear, squirrel cage, limited power or a table. With drive = "free" in the machine the speed follows from its torque and what the vibration takes, so that it may be caught at a resonance.

    Args:
        name: by which others refer to it.
        torque: torque T: at standstill, at breakdown for a squirrel cage, the largest for limited power, what the shares of a table are multiplied with (required).
            a torque (N m, kN m), between -1 GN m and 1 GN m
        curve: torque against speed (default constant).
            "constant" (torque at every speed) or "linear" (torque at standstill falls in a straight line to zero at synchronous_speed) or "squirrel_cage" (Kloss's curve: torque at breakdown, synchronous_speed, breakdown_slip) or "limited_power" (torque up to the speed where it takes the power, less above) or "table" (through the points of the table)
        table: torque at given speeds as shares of torque; between the rows a monotone cubic (PCHIP, slopes of Fritsch and Butland), constant outside (optional).
            columns of equal length { speed: spin speed, increasing [a speed]; share: torque there over torque [a pure number] }, or a list of rows { speed = .., .. }
        synchronous_speed: speed W_s at which the torque is zero (default 0.0 rad/s).
            a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        breakdown_slip: slip s_k of the largest torque of a squirrel cage (default 0.2 ).
            a pure number, above 0 and at most 100
        power: limit P of the power (default 0.0 W).
            a power (kW, W), between 0 and 1e12 W
        drag: drag c of bearings and windage: torque over speed (default 0.0 N m s).
            an angular momentum (N m s), between 0 and 1 GN m s
        inertia: moment of inertia J of the motor's rotor (default 0.0 kg m^2).
            a moment of inertia (kg m^2, kg mm^2), between 0 and 1e9 kg m^2

    In a machine file::

        [[part]]
        kind = "motor"
        torque = "12 N m"
        curve = "linear"
        synchronous_speed = "3000 rpm"
        inertia = "0.02 kg m^2"
    """

def spin_load(
    *,
    name: str | None = None,
    spin: str | None = None,
    inertia: Quantity | None = None,
    drag: Quantity | None = None,
    windage: Quantity | None = None,
) -> Part:
    """Inertia about the axis and torques that resist the spin: a coupling or gear on the shaft, drag of bearings, windage. It counts in the torque and power of the drive, and with drive = "free" in how the speed changes, as in a run-down.

    Args:
        name: by which others refer to it.
        spin: the part of kind "speed_ratio" with which it turns; without it, it turns with the body that carries it or else at the speed of the machine (optional).
            a text
        inertia: moment of inertia J about the axis (default 0.0 kg m^2).
            a moment of inertia (kg m^2, kg mm^2), between 0 and 1e9 kg m^2
        drag: drag c of bearings and seals: torque over speed (default 0.0 N m s/rad).
            a rotational damping constant (N m s/rad), between 0 and 1 GN m s/rad
        windage: windage k: torque over the square of the speed (default 0.0 N m s^2/rad^2).
            a torque over the square of a speed (N m s^2/rad^2, N m/rpm^2), between 0 and 1 GN m s^2/rad^2

    In a machine file::

        [[part]]
        kind = "spin_load"
        inertia = "0.05 kg m^2"
        drag = "2e-3 N m s"
    """
