"""What stands beside the parts of a machine: limits, operation, suspension, cups, report.

Written by crates/laval-py/stubs.py from the registry of the library.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from laval._blocks import Extra, Part, Study
from laval._types import Lateral, Named, ParameterRange, Point, Quantities, Quantity, Range, Tolerance

__all__ = ['swinging', 'fixed_angle', 'tubular_bowl', 'disc_stack', 'decanter', 'suspension', 'limits', 'operation', 'report']

def __getattr__(name: str) -> Any: ...
def __dir__() -> list[str]: ...

def swinging(
    *,
    name: str | None = None,
    hinge_radius: Quantity,
    cup_radius: Quantity,
    bottom: Quantity,
    on: Point | None = None,
    count: int | None = None,
    surface: Quantity | None = None,
    centre_of_mass: Quantity | None = None,
    tilt: Quantity | None = None,
    mass: Quantity | None = None,
    centre_of_mass_across: Quantity | None = None,
    moment_along: Quantity | None = None,
    moment_across: Quantity | None = None,
    moment_product: Quantity | None = None,
    hinge_damping: Quantity | None = None,
    mass_differences: Quantities | None = None,
    centre_differences: Quantities | None = None,
) -> Extra:
    """Cups that hang on hinges and swing out as the rotor turns: their tilt follows from the speed, and what they weigh loads the rotor at the radius they reach.

    Args:
        name: by which others refer to it.
        hinge_radius: radius of the hinge from the spin axis, L_st (required).
            a length (mm, m, µm), between 0 and 10 m
        cup_radius: inner radius, r (required).
            a length (mm, m, µm), above 0 and at most 10 m
        bottom: distance from the hinge to the bottom along the cup, L (required).
            a length (mm, m, µm), above 0 and at most 10 m
        on: the body that carries it, and the height of the hinges on it; in every study their mass, inertia and unbalance at the tilt of the speed are then those of the body. Without it the mass of the cups is not in the dynamics (optional).
            a point: "drum" or { body = "drum", at = "40 mm" }
        count: how many, at equal pitch (default 2).
            a whole number from 1 to 1000
        surface: distance from the hinge to the surface of the liquid along the cup, y_top (default 0 m).
            a length (mm, m, µm), between -10 m and 10 m
        centre_of_mass: distance from the hinge to the centre of mass of the cup with its contents, l; needed unless tilt is given (optional).
            a length (mm, m, µm), above 0 and at most 10 m
        tilt: a tilt from the vertical the cup is held at, instead of the one it swings out to (optional).
            an angle (deg, rad), between 0 and 1.571 rad (90 deg)
        mass: mass of one with its contents, m; needed when it loads a body (optional).
            a mass (kg, g, t), above 0 and at most 10000 kg
        centre_of_mass_across: centre of mass across the cup, outwards when it hangs (default 0 m).
            a length (mm, m, µm), between -10 m and 10 m
        moment_along: second moment about the hinge along the cup, Jy = int y^2 dm; that of a point mass when absent (optional).
            a moment of inertia (kg m^2, kg mm^2), above 0 and at most 10000 kg m^2
        moment_across: second moment across the cup, Jx = int x^2 dm (default 0 kg m^2).
            a moment of inertia (kg m^2, kg mm^2), between 0 and 10000 kg m^2
        moment_product: Jxy = int x y dm (default 0 kg m^2).
            a moment of inertia (kg m^2, kg mm^2), between -10000 kg m^2 and 10000 kg m^2
        hinge_damping: rate at which the hinge damps the swing, cd (default 0 1/s).
            a rate (1/s, 1/min), between 0 and 1e6 1/s
        mass_differences: what each weighs more than mass, one after the other in the sense of rotation from the key mark; a missing one is - mass (optional).
            a list; a mass (kg, g, t), between -10000 kg and 10000 kg
        centre_differences: how much farther from the hinge each one's centre of mass lies: pellets of different height in cups that weigh the same (optional).
            a list; a length (mm, m, µm), between -1 m and 1 m

    In a machine file::

        [[cup]]
        kind = "swinging"
        on = "drum"
        count = 4
        mass = "2.6 kg"                     # each, filled
        centre_of_mass = "170 mm"           # from the hinge, filled
        hinge_radius = "200 mm"
        cup_radius = "45 mm"
        bottom = "300 mm"                   # from the hinge
        surface = "20 mm"                   # from the hinge
    """

def fixed_angle(
    *,
    name: str | None = None,
    mouth_radius: Quantity,
    angle: Quantity,
    tube_radius: Quantity,
    length: Quantity,
    on: Point | None = None,
    count: int | None = None,
    surface: Quantity | None = None,
    centre_of_mass: Quantity | None = None,
    mass: Quantity | None = None,
    mass_differences: Quantities | None = None,
) -> Extra:
    """Tubes held at an angle; the surface of their liquid follows the field.

    Args:
        name: by which others refer to it.
        mouth_radius: radius of the centre of the mouth from the spin axis (required).
            a length (mm, m, µm), between 0 and 10 m
        angle: angle between tube and spin axis (required).
            an angle (deg, rad), above 0 and at most 1.571 rad (90 deg)
        tube_radius: inner radius, r (required).
            a length (mm, m, µm), above 0 and at most 10 m
        length: from the mouth to the bottom (required).
            a length (mm, m, µm), above 0 and at most 10 m
        on: the body that carries it, and the height of the hinges on it; in every study their mass, inertia and unbalance at the tilt of the speed are then those of the body. Without it the mass of the cups is not in the dynamics (optional).
            a point: "drum" or { body = "drum", at = "40 mm" }
        count: how many, at equal pitch (default 2).
            a whole number from 1 to 1000
        surface: from the mouth to the surface of the liquid when the tube stands upright (default 0 m).
            a length (mm, m, µm), between 0 and 10 m
        centre_of_mass: distance from the mouth to the centre of mass of the tube with its contents (optional).
            a length (mm, m, µm), above 0 and at most 10 m
        mass: mass of one with its contents, m; needed when it loads a body (optional).
            a mass (kg, g, t), above 0 and at most 10000 kg
        mass_differences: what each weighs more than mass, one after the other in the sense of rotation from the key mark; a missing one is - mass (optional).
            a list; a mass (kg, g, t), between -10000 kg and 10000 kg

    In a machine file::

        [[cup]]
        kind = "fixed_angle"
        on = "drum"
        count = 6
        mass = "80 g"                       # each, filled
        centre_of_mass = "50 mm"            # from the mouth, along the tube
        mouth_radius = "50 mm"
        angle = "34 deg"
        tube_radius = "14 mm"
        length = "100 mm"
    """

def tubular_bowl(
    *,
    name: str | None = None,
    length: Quantity,
    bowl_radius: Quantity,
    surface_radius: Quantity,
) -> Extra:
    """A bowl that liquid flows through along the axis. The bowl itself is a body of the machine, and its liquid a [[part]] of kind "liquid" in that body: without it the liquid is not in the dynamics.

    Args:
        name: by which others refer to it.
        length: length of the liquid, Lb (required).
            a length (mm, m, µm), above 0 and at most 10 m
        bowl_radius: inner radius of the bowl, r2 (required).
            a length (mm, m, µm), above 0 and at most 10 m
        surface_radius: radius of the liquid's surface, r1 (required).
            a length (mm, m, µm), above 0 and at most 10 m

    In a machine file::

        [[cup]]
        kind = "tubular_bowl"
        length = "750 mm"
        bowl_radius = "52 mm"
        surface_radius = "20 mm"
    """

def disc_stack(
    *,
    name: str | None = None,
    inner_radius: Quantity,
    outer_radius: Quantity,
    angle: Quantity,
    gaps: int,
    spacing: Quantity | None = None,
) -> Extra:
    """A stack of conical discs that liquid flows through from the outside in. Its liquid is in the dynamics as a [[part]] of kind "liquid" in the body that is the bowl.

    Args:
        name: by which others refer to it.
        inner_radius: inner edge of the discs, r1 (required).
            a length (mm, m, µm), above 0 and at most 10 m
        outer_radius: outer edge of the discs, r2 (required).
            a length (mm, m, µm), above 0 and at most 10 m
        angle: angle between disc and spin axis, th (required).
            an angle (deg, rad), above 0 and at most 1.57 rad (89.95 deg)
        gaps: number of gaps, N (required).
            a whole number from 1 to 100000
        spacing: width of a gap across the discs; it sets the residence time, not the throughput (default 0.5 mm).
            a length (mm, m, µm), above 0 and at most 10 m

    In a machine file::

        [[cup]]
        kind = "disc_stack"
        inner_radius = "50 mm"
        outer_radius = "120 mm"
        angle = "40 deg"                    # between the discs and the axis
        gaps = 100
        spacing = "0.5 mm"
    """

def decanter(
    *,
    name: str | None = None,
    cylinder_length: Quantity,
    cone_length: Quantity,
    bowl_radius: Quantity,
    surface_radius: Quantity,
    cone: Literal["textbook", "slices"] | None = None,
) -> Extra:
    """A bowl with a cone and a screw; it separates like a tubular bowl of the same Sigma. Its liquid is in the dynamics as a [[part]] of kind "liquid" in the body that is the bowl.

    Args:
        name: by which others refer to it.
        cylinder_length: length of the cylinder, L1 (required).
            a length (mm, m, µm), above 0 and at most 10 m
        cone_length: wetted length of the cone, L2 (required).
            a length (mm, m, µm), between 0 and 10 m
        bowl_radius: inner radius of the bowl, r2 (required).
            a length (mm, m, µm), above 0 and at most 10 m
        surface_radius: radius of the liquid's surface, r1 (required).
            a length (mm, m, µm), above 0 and at most 10 m
        cone: how the cone counts in Sigma (default textbook).
            "textbook" (C = (r2^2 + 3 r1 r2 + 4 r1^2)/8) or "slices" (C = (r2^2 + r1 r2 + 2 r1^2)/4: tubular slices averaged over the cone)

    In a machine file::

        [[cup]]
        kind = "decanter"
        cylinder_length = "800 mm"
        cone_length = "250 mm"
        bowl_radius = "180 mm"
        surface_radius = "120 mm"
    """

def suspension(
    *,
    liquid_density: Quantity,
    particle_density: Quantity,
    viscosity: Quantity | None = None,
    viscosity_table: Mapping[Literal["temperature", "viscosity"], Quantities] | None = None,
    temperature: Quantity | None = None,
    density_deviation: Quantity | None = None,
    densities: Mapping[Literal["density", "share"], Quantities] | None = None,
    diameter: Quantity | None = None,
    median_diameter: Quantity | None = None,
    geometric_deviation: Quantity | None = None,
    characteristic_diameter: Quantity | None = None,
    spread: Quantity | None = None,
    sizes: Mapping[Literal["diameter", "undersize", "share"], Quantities] | None = None,
    drag: Literal["stokes", "schiller_naumann"] | None = None,
    added_mass: Quantity | None = None,
    lift: Quantity | None = None,
    volume_fraction: Quantity | None = None,
    hindered_exponent: Quantity | None = None,
    drop_viscosity: Quantity | None = None,
    shape_factor: Quantity | None = None,
) -> Extra:
    """What is separated: the liquid, and the size and density of the particles in it.

    Args:
        liquid_density: density of the liquid, rho_f (required).
            a density (kg/m^3, g/cm^3), between 0.01 kg/m^3 and 30000 kg/m^3
        particle_density: density of the particles, rho_p; the median where they differ (required).
            a density (kg/m^3, g/cm^3), between 0.01 kg/m^3 and 30000 kg/m^3
        viscosity: dynamic viscosity of the liquid, mu; this or viscosity_table (optional).
            a dynamic viscosity (mPa s, Pa s, cP), above 0 and at most 10 MPa s
        viscosity_table: viscosity over temperature; between the rows ln mu is a monotone cubic (PCHIP, slopes of Fritsch and Butland) (optional).
            columns of equal length { temperature: temperatures, increasing [a temperature]; viscosity: viscosity at each [a dynamic viscosity] }, or a list of rows { temperature = .., .. }
        temperature: temperature of the liquid; needed with viscosity_table (optional).
            a temperature (degC, K), between 50 K (-223.1 degC) and 3000 K (2727 degC)
        density_deviation: geometric standard deviation of the densities (log-normal) (optional).
            a pure number, above 1 and at most 10
        densities: classes of density, instead of one (optional).
            columns of equal length { density: densities, increasing [a density]; share: share of each class [a pure number] }, or a list of rows { density = .., .. }
        diameter: diameter of the particles, when all are equal (optional).
            a length (mm, m, µm), between 1 nm and 100 mm
        median_diameter: median diameter of a log-normal powder, by mass (optional).
            a length (mm, m, µm), between 1 nm and 100 mm
        geometric_deviation: geometric standard deviation of that powder (optional).
            a pure number, above 1 and at most 100
        characteristic_diameter: diameter with 63.2 % below, of a powder after Rosin and Rammler (optional).
            a length (mm, m, µm), between 1 nm and 100 mm
        spread: exponent of that powder, n (optional).
            a pure number, above 0 and at most 100
        sizes: a measured powder (optional).
            columns of equal length { diameter: diameters, increasing [a length]; undersize: share below each, up to 1 [a pure number], optional; share: share of each class, instead of undersize [a pure number], optional }, or a list of rows { diameter = .., .. }
        drag: law of the drag (default stokes).
            "stokes" (proportional to the velocity: Re below 1) or "schiller_naumann" (up to turbulent flow around the particle)
        added_mass: added-mass coefficient Ca; 0.5 for spheres that are not much denser than the liquid (default 0).
            a pure number, between 0 and 10
        lift: lift coefficient CL (default 0).
            a pure number, between -10 and 10
        volume_fraction: volume fraction of the particles, phi (default 0).
            a pure number, between 0 and 0.6
        hindered_exponent: exponent of Richardson and Zaki (default 4.65).
            a pure number, between 0 and 20
        drop_viscosity: viscosity inside clean drops, whose surface moves and lowers the drag (optional).
            a dynamic viscosity (mPa s, Pa s, cP), above 0 and at most 10 MPa s
        shape_factor: drag over that of a sphere of the same volume (default 1).
            a pure number, between 0.1 and 100

    In a machine file::

        [suspension]
        liquid_density = "998 kg/m^3"
        viscosity = "1 mPa s"
        particle_density = "2650 kg/m^3"
        characteristic_diameter = "25 um"   # Rosin and Rammler: 63 % are smaller
        spread = 1.3
        volume_fraction = "2 %"
    """

def limits(
    *,
    displacement: Named | None = None,
    velocity: Named | None = None,
    tilt: Named | None = None,
    force: Named | None = None,
    moment: Named | None = None,
    passage_displacement: Named | None = None,
    drive_torque: Quantity | None = None,
    growth_margin: Quantity | None = None,
    clearance: Quantity | None = None,
    orders: Quantities | None = None,
    self_centring: Quantity | None = None,
    speed: Quantity | None = None,
    rated_density: Quantity | None = None,
) -> Extra:
    """What the machine must keep to: each limit that is given becomes a requirement of an operating_window. Limits on bodies and parts are one value for all, or one for each of some names.

    Args:
        displacement: largest steady displacement of bodies, the foundation among them, at the reference point, wherever something is attached and, of a linear response, at the nodes of a shaft; of one point alone as { "drum at 100 mm" = "0.2 mm" } (optional).
            a length (mm, m, µm), above 0 and at most 1e12 m; one value, or { name = .., name = .. }
        velocity: largest steady vibration velocity of bodies, at the same points: its peak, which is sqrt(2) times the r.m.s. value of a harmonic vibration (optional).
            a velocity (m/s, mm/s), above 0 and at most 1e12 m/s; one value, or { name = .., name = .. }
        tilt: largest steady tilt of bodies (optional).
            an angle (deg, rad), above 0 and at most 1e12 rad (5.73e13 deg); one value, or { name = .., name = .. }
        force: largest steady force of parts, such as bearings (optional).
            a force (N, kN), above 0 and at most 1e12 N; one value, or { name = .., name = .. }
        moment: largest steady moment of parts, such as shafts (optional).
            a torque (N m, kN m), above 0 and at most 1e12 N m; one value, or { name = .., name = .. }
        passage_displacement: largest displacement of bodies, at the same points, while the speed changes (optional).
            a length (mm, m, µm), above 0 and at most 1e12 m; one value, or { name = .., name = .. }
        drive_torque: torque of the drive, at hand while the speed changes (optional).
            a torque (N m, kN m), above 0 and at most 1 GN m
        growth_margin: least rate at which every disturbance must die out, sig0 (default 0 1/s).
            a rate (1/s, 1/min), between 0 and 1e6 1/s
        clearance: least distance of every natural whirl frequency from the excitation, over the speed, dlt (optional).
            a pure number, between 0 and 1
        orders: multiples of the spin speed that excite, for clearance (default [1]).
            a list; a pure number, above 0 and at most 1000
        self_centring: largest distance of a rotor's centre of mass from the spin axis over its eccentricity, c0: 0.5 is usual above the critical speed (optional).
            a pure number, above 0 and at most 1000
        speed: highest speed of any shaft, for strength (optional).
            a speed (rad/s, rpm, Hz), above 0 and at most 1e6 rad/s (9.549e6 rpm)
        rated_density: density of the contents that speed is rated for; denser contents lower it (optional).
            a density (kg/m^3, g/cm^3), above 0 and at most 100000 kg/m^3

    In a machine file::

        [limits]
        displacement = { drum = "0.3 mm" }
        passage_displacement = "2 mm"
        growth_margin = "1 1/s"
        clearance = "12 %"
        speed = "6000 rpm"
    """

def operation(
    *,
    speed: Range | None = None,
    run_up_time: Quantity | None = None,
    resonance_margin: Quantity | None = None,
    instability_margin: Quantity | None = None,
    decrement: Quantity | None = None,
    balance_grade: Literal["G0.4", "G1", "G2.5", "G6.3", "G16", "G40", "G100", "G250", "G630", "G1600", "G4000"] | None = None,
    shaft_vibration: Literal["iso_7919_3", "api_617"] | None = None,
    housing_vibration: Literal["group_1_rigid", "group_1_flexible", "group_2_rigid", "group_2_flexible"] | None = None,
) -> Extra:
    """At which speeds the machine runs, how it gets there, and which margins it must keep: the first page of the report assesses them. Limits on vibration and forces are in [limits].

    Args:
        speed: operating speed, or the range of operating speeds as { from = "2700 rpm", to = "3000 rpm" }; its upper end is the speed of [machine] where that gives none (optional).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        run_up_time: time from standstill to the operating speed at constant acceleration; the run-up is then simulated for the first page (optional).
            a time (s, ms, min), above 0 and at most 1e7 s
        resonance_margin: least distance of resonances from the operating speeds, over the speed; the larger one of this and the clearance of [limits] counts, 15 % where both are absent (optional).
            a pure number, between 0 and 1
        instability_margin: least distance of unstable ranges from the operating speeds, over the speed; 15 % where absent (optional).
            a pure number, between 0 and 1
        decrement: least logarithmic decrement of every natural mode at the operating speed, of frequencies up to ten times that speed (optional).
            a pure number, above 0 and at most 100
        balance_grade: balance quality grade of ISO 21940-11: the unbalance of every rotor, and its share in the planes of two bearings, is assessed at the highest operating speed (optional).
            "G0.4" (0.4 mm/s: gyroscopes, spindles of high-precision systems) or "G1" (1 mm/s: grinding-machine drives, tape drives) or "G2.5" (2.5 mm/s: compressors, gas and steam turbines, machine-tool drives, fast electric motors) or "G6.3" (6.3 mm/s: centrifuges and separators, fans, pumps, gears, general machinery) or "G16" (16 mm/s: drive shafts, crushers, agricultural machinery) or "G40" (40 mm/s: car wheels, wheel rims, crankshaft drives balanced in themselves) or "G100" (100 mm/s: complete reciprocating engines of cars and locomotives) or "G250" (250 mm/s: crankshaft drives not balanced in themselves, rigidly mounted) or "G630" (630 mm/s: crankshaft drives of large four-stroke engines) or "G1600" (1600 mm/s: crankshaft drives of large slow engines, elastically mounted) or "G4000" (4000 mm/s: crankshaft drives of large slow engines, rigidly mounted)
        shaft_vibration: standard whose limits on the vibration of the shaft relative to its bearings, peak to peak, are assessed over the operating speeds (optional).
            "iso_7919_3" (zones A to D of ISO 7919-3 (coupled industrial machines with fluid-film bearings, 1000 to 30 000 rpm)) or "api_617" (API 617: 25.4 µm times the square root of 12 000 rpm over the speed, at most 25.4 µm)
        housing_vibration: group of ISO 20816-3 whose zones A to D for the vibration of bearing housings are assessed over the operating speeds: of bodies that bearings stand on (optional).
            "group_1_rigid" (above 300 kW, or electrical with a shaft height of 315 mm and more; rigid supports) or "group_1_flexible" (the same on flexible supports) or "group_2_rigid" (15 to 300 kW, or electrical with a shaft height of 160 to 315 mm; rigid supports) or "group_2_flexible" (the same on flexible supports)

    In a machine file::

        [operation]
        speed = { from = "2700 rpm", to = "3000 rpm" }
        run_up_time = "20 s"
        resonance_margin = "15 %"
        instability_margin = "20 %"
    """

def report(
    *,
    language: Literal["en", "ru", "kk", "uz"] | None = None,
    units: str | None = None,
) -> Extra:
    """Language and units of the report, its figures and the summary in the terminal. Tables, results.json and figures of other programs that read them keep SI units and English names.

    Args:
        language: language of the report; --lang comes before it, the language of the environment after it (optional).
            "en" (English) or "ru" (Russian) or "kk" (Kazakh) or "uz" (Uzbek, Latin letters)
        units: file: the units that this file writes; si: SI units with prefixes; or the units to use, such as "rpm, mm, kN", before those of the file (default file).
            a text

    In a machine file::

        [report]
        language = "ru"
        units = "rpm, mm, N/mm, kN"
    """
