"""Analyses of machines: one function for each kind of study, with the keys of the machine file.

Written by crates/laval-py/stubs.py from the registry of the library.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from laval._blocks import Extra, Part, Study
from laval._types import Lateral, Named, ParameterRange, Point, Quantities, Quantity, Range, Tolerance

__all__ = ['modes', 'static', 'bearing_coefficients', 'campbell', 'critical_speeds', 'support_stiffness_map', 'stability_map', 'stability_threshold', 'forced_response', 'harmonic_force', 'nonlinear_response', 'bifurcation_loci', 'response_map', 'stationary', 'sensitivity', 'backbone', 'limit_cycles', 'methods', 'transient', 'run_up', 'separation', 'operating_window', 'sweep', 'motion_map', 'basins', 'uncertainty', 'optimum']

def __getattr__(name: str) -> Any: ...
def __dir__() -> list[str]: ...

def modes(
    *,
    name: str | None = None,
    speed: Quantity | None = None,
    about: Literal["rest", "turning"] | None = None,
    growth_threshold: Quantity | None = None,
    frequency_limit: Quantity | None = None,
) -> Study:
    """Natural modes at one spin speed: growth rate, frequency, damping ratio, direction of whirl, how much each body takes part, and the shape along the axis of a machine with several points. about = "turning" linearises about the state that turns with the rotor. Of a bearing in a table over the frequency of vibration every mode has the coefficients of its own frequency.

    Args:
        name: by which others refer to it.
        speed: spin speed; the machine's when left out (optional).
            a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        about: state the machine is linearised about (default rest).
            "rest" (the static equilibrium, seen in fixed axes) or "turning" (the state that turns with the rotor, seen in axes that turn with it (frequencies are counted from the spin))
        growth_threshold: growth rate above which a mode is called unstable (default 0 1/s).
            a rate (1/s, 1/min), between -1e6 1/s and 1e6 1/s
        frequency_limit: largest frequency of the modes, of machines with parts that have no time form and of those with more than 160 states; when left out, 1.2 times the larger of three times the speed and the highest frequency of the machine without those parts, or so high that twelve modes lie below, and three times the speed (optional).
            a speed (rad/s, rpm, Hz), above 0 and at most 1e7 rad/s (9.549e7 rpm)

    In a machine file::

        [[study]]
        kind = "modes"
        speed = "3000 rpm"
    """

def static(
    *,
    name: str | None = None,
    speed: Quantity | None = None,
    supports: str | None = None,
    offset_x: Named | None = None,
    offset_y: Named | None = None,
    couplings: str | None = None,
    aligned_for: Literal["moment_and_shear", "moment"] | None = None,
    kept: str | None = None,
) -> Study:
    """The machine at rest under its weight (axis = "horizontal" in [machine]) and constant forces: deflection, slope, shear force and bending moment along its shafts, loads of its bearings, mass and moments of inertia. Twice: with the stiffness that the bearings have at a speed, and on rigid supports in their places. With offsets of its supports, their influence on the loads, and the heights at which couplings carry nothing.

    Args:
        name: by which others refer to it.
        speed: speed whose coefficients the bearings have; the machine's when left out, or 0 without one (optional).
            a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        supports: names of the parts that support the rotor, separated by commas; every part with stiffness between what turns and what does not, unless given (optional).
            a text
        offset_x: offsets of supports in x against what they stand on, as { "bearing 2" = "0.2 mm" }; positive in the direction of x (optional).
            a length (mm, m, µm), between -1 m and 1 m; one value, or { name = .., name = .. }
        offset_y: heights of supports in y against what they stand on, as { "bearing 2" = "0.2 mm" }; positive where they are raised (optional).
            a length (mm, m, µm), between -1 m and 1 m; one value, or { name = .., name = .. }
        couplings: couplings whose faces coincide and are parallel once the shafts are aligned, separated by commas: parts that join two turning bodies, or nodes of a shaft as "shaft at 1200 mm"; the heights of the supports that this takes are computed (optional).
            a text
        aligned_for: loads of the couplings that vanish in the aligned train (default moment_and_shear).
            "moment_and_shear" (neither bending moment nor shear force at the couplings, as of a train with two bearings on each shaft) or "moment" (no bending moment at the couplings, as where a shaft has one bearing and hangs on its coupling)
        kept: names of the supports that keep their offsets in the aligned train, separated by commas; the first two of the machine unless given (optional).
            a text

    In a machine file::

        [[study]]
        kind = "static"
        speed = "3000 rpm"
    """

def bearing_coefficients(
    *,
    name: str | None = None,
    speed: Range,
    supports: str | None = None,
) -> Study:
    """The supports of the machine at rest over the speed: the load that each carries, where its journal lies, eccentricity, attitude, least film and power of oil films, the eight stiffness and damping coefficients about that state, and the rigid mass that begins to whirl on them.

    Args:
        name: by which others refer to it.
        speed: spin speeds, 60 unless their number is given, or one (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        supports: names of the parts that support the rotor, separated by commas; every part with stiffness between what turns and what does not, unless given (optional).
            a text

    In a machine file::

        [[study]]
        kind = "bearing_coefficients"
        speed = { from = "600 rpm", to = "6000 rpm" }
    """

def campbell(
    *,
    name: str | None = None,
    speed: Range,
    orders: Quantities | None = None,
    growth_threshold: Quantity | None = None,
    frequency_limit: Quantity | None = None,
    compare: Literal["nothing", "approximation"] | None = None,
) -> Study:
    """Frequencies and growth rates of all modes over the spin speed, each mode followed by its shape, with excitation lines and the critical speeds where they cross. Of a bearing in a table over the frequency of vibration every mode has the coefficients of its own frequency.

    Args:
        name: by which others refer to it.
        speed: spin speeds; 120 points unless given (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        orders: multiples of the spin speed that excite: 1 is unbalance (default [1]).
            a list; a pure number, above 0 and at most 1000
        growth_threshold: growth rate above which a mode is called unstable (default 0 1/s).
            a rate (1/s, 1/min), between -1e6 1/s and 1e6 1/s
        frequency_limit: largest frequency of the modes, of machines with parts that have no time form and of those with more than 160 states; when left out, 1.2 times the larger of three times the speed and the highest frequency of the machine without those parts, or so high that twelve modes lie below, and three times the speed (optional).
            a speed (rad/s, rpm, Hz), above 0 and at most 1e7 rad/s (9.549e7 rpm)
        compare: what the roots are drawn beside (default nothing).
            "nothing" (only the machine as it is) or "approximation" (the machine with few waves in place of waves without number, of parts that have such a form: of a liquid in three dimensions planar_tilt)

    In a machine file::

        [[study]]
        kind = "campbell"
        speed = { from = "100 rpm", to = "12000 rpm", points = 60 }
        orders = [1, 2]
    """

def critical_speeds(
    *,
    name: str | None = None,
    speed: Range,
    orders: Quantities | None = None,
    margin: Quantity | None = None,
) -> Study:
    """Critical speeds, solved for on the dynamic stiffness of the machine, with the peaks of the unbalance response beside them and the distance to the operating speed.

    Args:
        name: by which others refer to it.
        speed: spin speeds to search; 120 points unless given (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        orders: multiples of the spin speed that excite: 1 is unbalance (default [1]).
            a list; a pure number, above 0 and at most 1000
        margin: distance from lightly damped critical speeds, relative to the operating speed, that it should keep; resonance_margin of [operation], clearance of [limits], or 15 %, where absent (optional).
            a pure number, between 0 and 1

    In a machine file::

        [[study]]
        kind = "critical_speeds"
        speed = { from = "100 rpm", to = "12000 rpm" }
        margin = "20 %"
    """

def support_stiffness_map(
    *,
    name: str | None = None,
    stiffness: Range | None = None,
    modes: int | None = None,
    supports: str | None = None,
    rest_frequencies: bool | None = None,
    spin: str | None = None,
) -> Study:
    """Undamped critical speeds over the stiffness of the supports: every bearing is replaced by the same stiffness in x and y, without damping and cross terms; pedestals and masses stay. The stiffness of the linear bearings is laid over it, and where it meets the curves the share of the strain energy in the supports says whether other bearings or another shaft would move the critical speed.

    Args:
        name: by which others refer to it.
        stiffness: stiffness of every support, in logarithmic steps; 40 points unless given; three powers of ten on both sides of that of the rotor when left out (optional).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a stiffness (N/m, N/mm, MN/m), above 0 and at most 1e15 N/m
        modes: critical speeds at each stiffness (default 4).
            a whole number from 1 to 20
        supports: names of the parts that support the rotor, separated by commas; every part with stiffness between what turns and what does not, unless given (optional).
            a text
        rest_frequencies: natural frequencies of the rotor at rest as well (default false).
            true or false
        spin: of a machine of several spins: the part of kind "speed_ratio" whose unbalance drives the whirls; speeds are then those of this spin. Without it, they are those of the machine, or where no body turns at its speed of the first of its spins (optional).
            a text

    In a machine file::

        [[study]]
        kind = "support_stiffness_map"
        stiffness = { from = "1e5 N/m", to = "1e10 N/m" }
        modes = 4
    """

def stability_map(
    *,
    name: str | None = None,
    speed: Range,
    parameter: ParameterRange | None = None,
    about: Literal["rest", "turning"] | None = None,
    criterion: Literal["growth", "flutter", "viscous"] | None = None,
    growth_threshold: Quantity | None = None,
    frequency_limit: Quantity | None = None,
) -> Study:
    """Where the machine is unstable: growth rate over the spin speed, alone or together with one parameter, with the boundary and the peaks of the growth located. Nonlinear parts enter by their tangent in the state it is linearised about; nonlinear_response assesses the motion that unbalance drives, whose ranges differ where that motion is not small.

    Args:
        name: by which others refer to it.
        speed: one spin speed, or a range of 200 points unless given (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        parameter: a parameter to vary as well; 40 points unless given, at most 1000000 in all with those of the speed (optional).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000
        about: state the machine is linearised about (default rest).
            "rest" (the static equilibrium, seen in fixed axes) or "turning" (the state that turns with the rotor, seen in axes that turn with it (frequencies are counted from the spin))
        criterion: what counts as unstable (default growth).
            "growth" (growth above growth_threshold) or "flutter" (two frequencies of a machine without damping meet; refused where something damps or drives) or "viscous" (any growth, with what takes up energy inside the parts that turn; refused where no part has a layer that does)
        growth_threshold: growth rate above which a mode is called unstable (default 0 1/s).
            a rate (1/s, 1/min), between -1e6 1/s and 1e6 1/s
        frequency_limit: largest frequency of the modes, of machines with parts that have no time form and of those with more than 160 states; when left out, 1.2 times the larger of three times the speed and the highest frequency of the machine without those parts, or so high that twelve modes lie below, and three times the speed (optional).
            a speed (rad/s, rpm, Hz), above 0 and at most 1e7 rad/s (9.549e7 rpm)

    In a machine file::

        [[study]]
        kind = "stability_map"
        speed = { from = "100 rpm", to = "12000 rpm", points = 120 }
        parameter = { parameter = "drum.mass", from = "1.5 kg", to = "4 kg", points = 11 }
    """

def stability_threshold(
    *,
    name: str | None = None,
    place: Point,
    speed: Quantity | None = None,
    up_to: Quantity | None = None,
    points: int | None = None,
    spacing: Literal["linear", "logarithmic"] | None = None,
    anticipated: Quantity | None = None,
    gas_density: Quantity | None = None,
    supports: str | None = None,
    modes: int | None = None,
) -> Study:
    """How much cross-coupled stiffness (kxy = -kyx, of seals or impellers) at a place of the machine it bears before a lateral mode becomes unstable: the level 1 stability analysis of API 684 and API 617. The logarithmic decrement of the modes over the stiffness, each mode followed by its derivative, with the threshold solved for; on request the criteria of level 1 at the stiffness that is anticipated. Pedestals and masses stay.

    Args:
        name: by which others refer to it.
        place: point of a body on which the stiffness acts; level 1 takes the middle between the bearings (required).
            a point: "drum" or { body = "drum", at = "40 mm" }
        speed: spin speed; the machine's when left out (optional).
            a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        up_to: largest cross-coupled stiffness; when left out, 1.5 times the larger of the anticipated one and the threshold (optional).
            a stiffness (N/m, N/mm, MN/m), above 0 and at most 1e14 N/m
        points: values of the stiffness, 0 among them (default 40).
            a whole number from 2 to 10000
        spacing: how the values of the stiffness are spaced (default linear).
            "linear" (equal steps) or "logarithmic" (0, and equal ratios over three powers of ten)
        anticipated: cross-coupled stiffness that is anticipated, for the criteria of level 1 (optional).
            a stiffness (N/m, N/mm, MN/m), above 0 and at most 1e14 N/m
        gas_density: average of the gas densities at suction and discharge, for the criterion of level 1 on gas density and critical speed ratio; with anticipated (optional).
            a density (kg/m^3, g/cm^3), above 0 and at most 10000 kg/m^3
        supports: names of the parts that support the rotor, separated by commas; every part with stiffness between what turns and what does not, unless given (optional).
            a text
        modes: modes followed: those that the stiffness makes unstable first, by their derivatives at 0; the first forward mode is followed as well (default 4).
            a whole number from 1 to 100

    In a machine file::

        [[study]]
        kind = "stability_threshold"
        place = "drum"
        up_to = "1e7 N/m"
        anticipated = "1e6 N/m"
    """

def forced_response(
    *,
    name: str | None = None,
    speed: Range,
    standard: Literal["none", "api_684"] | None = None,
    spin: str | None = None,
) -> Study:
    """Linear unbalance response over the spin speed: amplitude and phase of every body, at its reference point and wherever something is attached to it, of its tilt; forces and moments of linear parts and linearised forces of nonlinear ones, with resonances and antiresonances located; orbits and deflected shapes at the operating speed and at the largest resonances. Nonlinear parts enter by their tangent at rest; nonlinear_response keeps them whole.

    Args:
        name: by which others refer to it.
        speed: one spin speed, or a range: points (400 unless given) are added where the response bends (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        standard: standard whose separation margins are assessed (default none).
            "none" (peaks and their factors of amplification alone) or "api_684" (separation margins of API 684 (SP6.8.2.10) and API 617 against the operating speeds)
        spin: of a machine of several spins: the part of kind "speed_ratio" whose unbalance acts; speeds are then those of this spin. Without it, the unbalance of what turns at the speed of the machine acts (optional).
            a text

    In a machine file::

        [[study]]
        kind = "forced_response"
        speed = { from = "100 rpm", to = "12000 rpm", points = 400 }
    """

def harmonic_force(
    *,
    name: str | None = None,
    place: Point,
    speed: Range,
    force: Quantity | None = None,
    direction: Literal["x", "y", "forward", "backward"] | None = None,
    order: Quantity | None = None,
    frequency: Range | None = None,
    standard: Literal["none", "api_684"] | None = None,
) -> Study:
    """Linear response to a harmonic force at a point of the machine, along x or y or turning with or against the rotor: of an order of the spin speed over a range of speeds, or over a range of frequencies at one speed. Peaks are located, with their factors of amplification by the half-power points; unbalance is left out.

    Args:
        name: by which others refer to it.
        place: point of a body on which the force acts (required).
            a point: "drum" or { body = "drum", at = "40 mm" }
        speed: spin speeds, 400 points unless given; with frequency one speed (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        force: amplitude of the force (default 1 N).
            a force (N, kN), above 0 and at most 1e12 N
        direction: how the force moves (default x).
            "x" (along x) or "y" (along y) or "forward" (turning with the rotor) or "backward" (turning against the rotor)
        order: frequency of the force over the spin speed (default 1).
            a pure number, above 0 and at most 1000
        frequency: frequencies of the force at one spin speed, in place of order; 400 points unless given (optional).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e7 rad/s (9.549e7 rpm)
        standard: standard whose separation margins are assessed (default none).
            "none" (peaks and their factors of amplification alone) or "api_684" (separation margins of API 684 (SP6.8.2.10) and API 617 against the operating speeds)

    In a machine file::

        [[study]]
        kind = "harmonic_force"
        place = "drum"
        force = "10 N"
        direction = "x"
        speed = "3000 rpm"
        frequency = { from = "5 Hz", to = "200 Hz" }
    """

def nonlinear_response(
    *,
    name: str | None = None,
    speed: Range,
    harmonics: int | Literal["auto"] | None = None,
    truncation: Quantity | None = None,
    symmetry: Literal["auto", "quarter", "half", "none"] | None = None,
    subharmonic: int | None = None,
    stability: bool | None = None,
    check_stability: bool | None = None,
    states: Literal["main", "all"] | None = None,
    starts: int | None = None,
    time_starts: int | None = None,
    order_threshold: Quantity | None = None,
    max_points: int | None = None,
) -> Study:
    """Steady response to unbalance over a range of speeds, with the states the machine can settle in: branches followed from both ends, folds (where a slow sweep jumps) and other bifurcations located, stability of every point; on request also mixed, less symmetric and subharmonic states.

    Args:
        name: by which others refer to it.
        speed: range of the spin speed; negative speeds turn clockwise (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between -1e7 rad/s (-9.549e7 rpm) and 1e7 rad/s (9.549e7 rpm)
        harmonics: largest order of the spin frequency kept; auto raises it until the dropped force is below truncation (default auto).
            a whole number from 1 to 63, or "auto"
        truncation: dropped over kept force harmonics that auto accepts (default 1e-7).
            a pure number, between 1e-15 and 1
        symmetry: symmetry imposed on the motion; less symmetry admits more states (default auto).
            "auto" (the largest symmetry the machine has) or "quarter" (z(t + T/4) = i z(t): orders 1, -3, 5, -7) or "half" (z(t + T/2) = -z(t): odd orders) or "none" (all orders)
        subharmonic: period sought, in turns n of the rotor; of the orders in steps of speed / n symmetry by a quarter turn keeps every fourth (for 3: -1/3, 1, -5/3), by half a turn every second; even n has no symmetry (default 1).
            a whole number from 1 to 9
        stability: assess the stability of every point (default true).
            true or false
        check_stability: assess some states again by Hill's method and by a second map over the period (default false).
            true or false
        states: which states are looked for (default main).
            "main" (those of the branches from both ends of the range) or "all" (also mixed, less symmetric and subharmonic states, and those apart from the others)
        starts: with states = "all": starts of any size and phase, the same in every run (default 64).
            a whole number from 0 to 100000
        time_starts: with states = "all": starts integrated in time at each speed searched; what they settle on, of periods up to 9 turns, is solved for and followed (default 0).
            a whole number from 0 to 1000
        order_threshold: amplitude from which sub- and superharmonic orders are reported, with the speeds at which they pass it; none unless given (optional).
            a length (mm, m, µm), above 0 and at most 1 m
        max_points: most points of a branch (default 2000).
            a whole number from 10 to 1000000

    In a machine file::

        [[study]]
        kind = "nonlinear_response"
        speed = { from = "100 rpm", to = "12000 rpm" }
        harmonics = "auto"
    """

def bifurcation_loci(
    *,
    name: str | None = None,
    speed: Range,
    parameter: ParameterRange,
    kinds: Literal["all", "folds", "stability"] | None = None,
    harmonics: int | Literal["auto"] | None = None,
    truncation: Quantity | None = None,
    max_points: int | None = None,
) -> Study:
    """Where jumps and other bifurcations of the steady response lie when one parameter changes: loci of folds in the plane of spin speed and parameter, with the cusps in which jumps begin, and loci on which states lose or regain their stability (Neimark-Sacker, period doubling, symmetry breaking). They are followed from the bifurcations of the response at some values of the parameter.

    Args:
        name: by which others refer to it.
        speed: range of the spin speed; negative speeds turn clockwise (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between -1e7 rad/s (-9.549e7 rpm) and 1e7 rad/s (9.549e7 rpm)
        parameter: the parameter, and its range; points is the number of values at which the response is computed to find starts, 5 unless given (required).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000
        kinds: which bifurcations are followed (default all).
            "all" (folds and changes of stability) or "folds" (folds alone) or "stability" (changes of stability away from folds alone)
        harmonics: largest order of the spin frequency kept; auto raises it until the dropped force is below truncation (default auto).
            a whole number from 1 to 63, or "auto"
        truncation: dropped over kept force harmonics that auto accepts (default 1e-7).
            a pure number, between 1e-15 and 1
        max_points: most points of a locus, and of a branch (default 2000).
            a whole number from 10 to 1000000

    In a machine file::

        [[study]]
        kind = "bifurcation_loci"
        speed = { from = "100 rpm", to = "12000 rpm" }
        parameter = { parameter = "drum.eccentricity", from = "1 um", to = "100 um", points = 5 }
    """

def response_map(
    *,
    name: str | None = None,
    x: ParameterRange,
    y: ParameterRange,
    speed: Range,
    x_spacing: Literal["linear", "logarithmic"] | None = None,
    y_spacing: Literal["linear", "logarithmic"] | None = None,
    harmonics: int | Literal["auto"] | None = None,
    truncation: Quantity | None = None,
    symmetry: Literal["auto", "quarter", "half", "none"] | None = None,
    stability: bool | None = None,
    max_points: int | None = None,
) -> Study:
    """The nonlinear response over a grid of two parameters of the machine, a complete one in every cell: largest peak and its speed, folds, jump speeds of slow sweeps up and down, width of the hysteresis, unstable ranges; and the border between machines that jump and machines that do not. A cell has the numbers that nonlinear_response finds for its machine.

    Args:
        name: by which others refer to it.
        x: the parameter along x; 20 points unless given (required).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000
        y: the parameter along y; 20 points unless given (required).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000
        speed: range of the spin speed; negative speeds turn clockwise (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between -1e7 rad/s (-9.549e7 rpm) and 1e7 rad/s (9.549e7 rpm)
        x_spacing: how the points along x are spaced (default linear).
            "linear" (equal steps) or "logarithmic" (equal ratios)
        y_spacing: how the points along y are spaced (default linear).
            "linear" (equal steps) or "logarithmic" (equal ratios)
        harmonics: largest order of the spin frequency kept; auto raises it until the dropped force is below truncation (default auto).
            a whole number from 1 to 63, or "auto"
        truncation: dropped over kept force harmonics that auto accepts (default 1e-7).
            a pure number, between 1e-15 and 1
        symmetry: symmetry imposed on the motion; less symmetry admits more states (default auto).
            "auto" (the largest symmetry the machine has) or "quarter" (z(t + T/4) = i z(t): orders 1, -3, 5, -7) or "half" (z(t + T/2) = -z(t): odd orders) or "none" (all orders)
        stability: assess the stability of every point (default true).
            true or false
        max_points: most points of a branch (default 2000).
            a whole number from 10 to 1000000

    In a machine file::

        [[study]]
        kind = "response_map"
        x = { parameter = "drum.mass", from = "2 kg", to = "4 kg", points = 9 }
        y = { parameter = "drum.eccentricity", from = "10 um", to = "100 um", points = 9 }
        speed = { from = "100 rpm", to = "12000 rpm" }
    """

def stationary(
    *,
    name: str | None = None,
    speed: Range,
    starts: int | None = None,
    seeds: int | None = None,
    max_points: int | None = None,
    stabilise: ParameterRange | None = None,
    stabilise_at: Quantity | None = None,
    chart: ParameterRange | None = None,
    errors: Sequence[ParameterRange] | None = None,
) -> Study:
    """Where a machine with movable masses, such as the balls of a balancer, balances itself: its states at rest in axes that turn with the rotor, all that are found from many starts, followed over the speed and classified (balanced, partly balanced, unbalance reduced, masses touching, together, opposed, locked by a tilt), with eigenvalues, limits of existence and the speeds where stability changes. It says where states balance, where they make the unbalance larger, where none is stable, and in which ranges dry friction holds the masses; on request the least value of a parameter, such as external damping, that makes the balanced state stable, a chart of its stability over speed and one parameter, and what errors of tilt or eccentricity cost.

    Args:
        name: by which others refer to it.
        speed: speeds over which states are followed, from a ten-thousandth of the highest on (at standstill nothing holds the masses); points: number of speeds in the table of states, 21 unless given (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        starts: starts at each of the speeds at which states are sought (default 100).
            a whole number from 1 to 10000
        seeds: number of these speeds: both ends of the range and others between them; 1 is the middle. Where no state is stable there are more (default 7).
            a whole number from 1 to 100
        max_points: most points of one branch (default 2000).
            a whole number from 10 to 1000000
        stabilise: parameter and range in which the values are sought that make the balanced state stable, for instance an external damping (optional).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000
        stabilise_at: speed at which it is to be stable and at which errors are assessed; the machine's when left out (optional).
            a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        chart: a parameter, such as the mass of the balls, for a chart of the balanced state and the number of stable states over it and the speed; 21 values unless given (optional).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000
        errors: parameters and how far they may be off, such as the tilt of a track from 0 to 0.5 deg: what that costs (optional).
            a list of { parameter = .., from = .., to = .. }, the ends in the unit of the parameter

    In a machine file::

        [[study]]
        kind = "stationary"
        speed = { from = "3000 rpm", to = "12000 rpm", points = 31 }
        chart = { parameter = "drum.eccentricity", from = "5 um", to = "100 um", points = 9 }
    """

def sensitivity(
    *,
    name: str | None = None,
    speed: Range,
    harmonics: int | Literal["auto"] | None = None,
    bars: int | None = None,
) -> Study:
    """How every peak and every fold (jump) of the steady response moves with every parameter of the machine: exact derivatives of its speed and of its displacement or tilt, in order of their relative influence. Peaks are those of every point that a part, a limit or a probe names, and of tilts. Values in lists and tables of a part are no parameters.

    Args:
        name: by which others refer to it.
        speed: range of the spin speed; negative speeds turn clockwise (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between -1e7 rad/s (-9.549e7 rpm) and 1e7 rad/s (9.549e7 rpm)
        harmonics: largest order of the spin frequency kept; auto raises it until the dropped force is negligible (default auto).
            a whole number from 1 to 63, or "auto"
        bars: parameters drawn for each place, those of most influence (default 10).
            a whole number from 1 to 100

    In a machine file::

        [[study]]
        kind = "sensitivity"
        speed = { from = "100 rpm", to = "12000 rpm" }
    """

def backbone(
    *,
    name: str | None = None,
    speed: Quantity | None = None,
    amplitude: Range | None = None,
    harmonics: int | Literal["auto"] | None = None,
    truncation: Quantity | None = None,
    max_points: int | None = None,
) -> Study:
    """Free whirls at one spin speed, mode by mode: how the whirl frequency depends on the amplitude, from the linear mode upwards, and the frequencies at which the amplitude has no bound. Unbalance is left out. A damped machine is kept whirling by a drive proportional to mass, whose size is reported; without damping it is zero.

    Args:
        name: by which others refer to it.
        speed: spin speed; the machine's when left out (optional).
            a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        amplitude: amplitudes of the deflection of the nonlinear parts, first order; from a thousandth to four times the one at which their force is half as much again as its tangent when left out (optional).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a length (mm, m, µm), between 0.001 nm and 1 m
        harmonics: largest order of the whirl frequency kept; auto raises it until the dropped force is below truncation (default auto).
            a whole number from 1 to 31, or "auto"
        truncation: dropped over kept force harmonics that auto accepts (default 1e-7).
            a pure number, between 1e-15 and 1
        max_points: most points of a family (default 2000).
            a whole number from 10 to 1000000

    In a machine file::

        [[study]]
        kind = "backbone"
        speed = "3000 rpm"
        amplitude = { from = "1 um", to = "1 mm" }
    """

def limit_cycles(
    *,
    name: str | None = None,
    speed: Range,
    harmonics: int | Literal["auto"] | None = None,
    truncation: Quantity | None = None,
    max_points: int | None = None,
) -> Study:
    """Self-excited whirls of a damped machine over the spin speed, without unbalance: from every edge of linear instability the cycles that begin there, with amplitude, frequency and stability; whether the onset is soft (a small whirl grows with the speed) or hard (rest is stable, but a disturbance beyond an unstable cycle leads to a large whirl); folds of cycles.

    Args:
        name: by which others refer to it.
        speed: spin speeds; rest is assessed at 200 unless points are given (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        harmonics: largest order of the whirl frequency kept; auto raises it until the dropped force is below truncation (default auto).
            a whole number from 1 to 31, or "auto"
        truncation: dropped over kept force harmonics that auto accepts (default 1e-7).
            a pure number, between 1e-15 and 1
        max_points: most points of a family (default 2000).
            a whole number from 10 to 1000000

    In a machine file::

        [[study]]
        kind = "limit_cycles"
        speed = { from = "500 rpm", to = "12000 rpm" }
    """

def methods(
    *,
    name: str | None = None,
    speed: Range,
    harmonics: int | None = None,
) -> Study:
    """Approximate methods beside the converged motion under unbalance, at some speeds and for every state there: harmonic balance with orders from 1, averaging (van der Pol; its states are those of one harmonic), elliptic balance in its period-consistent form where the law allows it, and integration in time. Each with its deviation; folds too.

    Args:
        name: by which others refer to it.
        speed: one spin speed, or a range; compared at 25 points unless given (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0.001 rad/s (0.009549 rpm) and 1e7 rad/s (9.549e7 rpm)
        harmonics: largest order of harmonic balance compared (default 7).
            a whole number from 1 to 31

    In a machine file::

        [[study]]
        kind = "methods"
        speed = { from = "1000 rpm", to = "12000 rpm", points = 12 }
        harmonics = 7
    """

def transient(
    *,
    name: str | None = None,
    duration: Quantity,
    speed: Quantity | None = None,
    phase: Quantity | None = None,
    initial: Mapping[str, Quantity] | None = None,
    kick: Mapping[str, Quantity] | None = None,
    kick_time: Quantity | None = None,
    method: Literal["auto", "explicit", "stiff"] | None = None,
    relative_tolerance: Quantity | None = None,
    absolute_tolerance: Quantity | None = None,
    points: int | None = None,
    output_step: Quantity | None = None,
    velocities: bool | None = None,
    observables: bool | None = None,
    waterfall: str | None = None,
    spectra: int | None = None,
    highest_order: Quantity | None = None,
    component_threshold: Quantity | None = None,
) -> Study:
    """Motion in time from a given start at constant speed, or with the spin free to move by itself when the machine's drive is free. Reports the motion, the energy balance, the largest displacements and whether the motion grows. A spatial liquid is a sum over waves in time: its error is stated, and how far it moves the roots; so is a viscous liquid at constant speed.

    Args:
        name: by which others refer to it.
        duration: time to compute (required).
            a time (s, ms, min), above 0 and at most 1e9 s
        speed: spin speed; that of the machine when absent (optional).
            a speed (rad/s, rpm, Hz), between -1e7 rad/s (-9.549e7 rpm) and 1e7 rad/s (9.549e7 rpm)
        phase: spin angle at the start (default 0 rad).
            an angle (deg, rad), between -1e6 rad (-5.73e7 deg) and 1e6 rad (5.73e7 deg)
        initial: start, by name: displacements ("drum.x", counted from the undeflected place), rates ("drum.x'") and internal states; balls that touch lie side by side from the node line on when nothing is said of them, everything else starts at rest, sagged under its weight when the axis is horizontal (optional).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        kick: sudden changes of rates, as { "drum.x'" = "0.1 m/s" } (optional).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        kick_time: when the kick comes (default 0 s).
            a time (s, ms, min), between 0 and 1e9 s
        method: method of integration (default auto).
            "auto" (explicit unless memory states or stability make it slow) or "explicit" (order 8, for motions that are not stiff) or "stiff" (implicit, order 5)
        relative_tolerance: tolerated error of a step over the size of each state (default 1e-8).
            a pure number, between 1e-14 and 0.01
        absolute_tolerance: tolerated error of a step over a typical size of each kind of state (1 mm, 10 mrad; velocities: times the spin speed); a tenth of the relative one unless given, but at most 1e-9 (optional).
            a pure number, between 1e-18 and 0.01
        points: number of output times, equally spaced (default 2000).
            a whole number from 2 to 1000000
        output_step: time between outputs, instead of their number (optional).
            a time (s, ms, min), above 0 and at most 1e9 s
        velocities: list the rates too (default false).
            true or false
        observables: list the quantities the parts show, such as bearing forces (default true).
            true or false
        waterfall: body whose spectra are wanted, over frequency and over orders of the spin, forward and backward parts apart (optional).
            a text
        spectra: with a waterfall: number of spectra, from windows that overlap by half (default 60).
            a whole number from 2 to 1000
        highest_order: with a waterfall: highest order; its frequency at the largest speed is the highest frequency (default 4).
            a pure number, between 0.5 and 64
        component_threshold: with a waterfall: amplitude from which parts other than the synchronous one are reported; a hundredth of the largest line unless given (optional).
            a length (mm, m, µm), above 0 and at most 1 m

    In a machine file::

        [[study]]
        kind = "transient"
        speed = "3000 rpm"
        duration = "2 s"
        kick = { "drum.x'" = "20 mm/s" }
    """

def run_up(
    *,
    name: str | None = None,
    from_: Quantity | None = None,
    to: Quantity | None = None,
    duration: Quantity | None = None,
    shape: Literal["linear", "smooth", "exponential"] | None = None,
    programme: Mapping[Literal["time", "speed"], Quantities] | None = None,
    polynomial: Quantities | None = None,
    hold: Quantity | None = None,
    windows: int | None = None,
    phase: Quantity | None = None,
    initial: Mapping[str, Quantity] | None = None,
    method: Literal["auto", "explicit", "stiff"] | None = None,
    relative_tolerance: Quantity | None = None,
    absolute_tolerance: Quantity | None = None,
    points: int | None = None,
    velocities: bool | None = None,
    observables: bool | None = None,
    waterfall: str | None = None,
    spectra: int | None = None,
    highest_order: Quantity | None = None,
    component_threshold: Quantity | None = None,
) -> Study:
    """Motion while the spin speed follows a programme: from one speed to another, coasting down, or through a table of speeds. Reports the envelope against speed beside the quasi-static linear response, the peaks, and the torque and power of the drive. A spatial liquid has at every moment the waves of its speed, with an error that is stated; viscous liquids are refused.

    Args:
        name: by which others refer to it.
        from_: speed at the start (default 0 rad/s).
            a speed (rad/s, rpm, Hz), between -1e7 rad/s (-9.549e7 rpm) and 1e7 rad/s (9.549e7 rpm)
        to: speed at the end; that of the machine when absent (optional).
            a speed (rad/s, rpm, Hz), between -1e7 rad/s (-9.549e7 rpm) and 1e7 rad/s (9.549e7 rpm)
        duration: time from one speed to the other (optional).
            a time (s, ms, min), above 0 and at most 1e9 s
        shape: how the speed changes (default linear).
            "linear" (constant acceleration) or "smooth" (acceleration that begins and ends at zero) or "exponential" (constant rate relative to the speed: coasting down against viscous drag)
        programme: speeds at given times, joined smoothly, instead of from, to and duration (optional).
            columns of equal length { time: times, increasing, from 0 [a time]; speed: spin speed at these times [a speed] }, or a list of rows { time = .., .. }
        polynomial: speed as a polynomial of the time during duration, instead of from and to: coefficients of 1, t, t^2 ... in rad/s, rad/s^2, rad/s^3 ... (optional).
            a list; a pure number, between -1e12 and 1e12
        hold: time at the last speed (default 0 s).
            a time (s, ms, min), between 0 and 1e9 s
        windows: pieces of equal time the envelope is taken over (default 400).
            a whole number from 10 to 100000
        phase: spin angle at the start (default 0 rad).
            an angle (deg, rad), between -1e6 rad (-5.73e7 deg) and 1e6 rad (5.73e7 deg)
        initial: start, by name: displacements ("drum.x", counted from the undeflected place), rates ("drum.x'") and internal states; balls that touch lie side by side from the node line on when nothing is said of them, everything else starts at rest, sagged under its weight when the axis is horizontal (optional).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        method: method of integration (default auto).
            "auto" (explicit unless memory states or stability make it slow) or "explicit" (order 8, for motions that are not stiff) or "stiff" (implicit, order 5)
        relative_tolerance: tolerated error of a step over the size of each state (default 1e-8).
            a pure number, between 1e-14 and 0.01
        absolute_tolerance: tolerated error of a step over a typical size of each kind of state (1 mm, 10 mrad; velocities: times the spin speed); a tenth of the relative one unless given, but at most 1e-9 (optional).
            a pure number, between 1e-18 and 0.01
        points: number of output times, equally spaced (default 2000).
            a whole number from 2 to 1000000
        velocities: list the rates too (default false).
            true or false
        observables: list the quantities the parts show, such as bearing forces (default false).
            true or false
        waterfall: body whose spectra are wanted, over frequency and over orders of the spin, forward and backward parts apart (optional).
            a text
        spectra: with a waterfall: number of spectra, from windows that overlap by half (default 60).
            a whole number from 2 to 1000
        highest_order: with a waterfall: highest order; its frequency at the largest speed is the highest frequency (default 4).
            a pure number, between 0.5 and 64
        component_threshold: with a waterfall: amplitude from which parts other than the synchronous one are reported; a hundredth of the largest line unless given (optional).
            a length (mm, m, µm), above 0 and at most 1 m

    In a machine file::

        [[study]]
        kind = "run_up"
        from = "0 rpm"
        to = "12000 rpm"
        duration = "20 s"
        hold = "2 s"
    """

def separation(
    *,
    name: str | None = None,
    cup: str | None = None,
    speed: Quantity | None = None,
    time: Quantity | None = None,
    throughput: Quantity | None = None,
    recovery: Quantity | None = None,
    diameter: Quantity | None = None,
    particles: int | None = None,
    model: Literal["adaptive", "exact", "drifting"] | None = None,
    start: Literal["even", "slowest"] | None = None,
    release: Quantities | None = None,
    release_velocity: Quantities | None = None,
    paths: int | None = None,
    ramp: Quantity | None = None,
    ramp_shape: Literal["linear", "smooth"] | None = None,
    programme: Mapping[Literal["time", "speed"], Quantities] | None = None,
    transfer_k: Quantity | None = None,
) -> Study:
    """Particles of the suspension followed through a cup, tube, bowl or disc stack at one speed: share caught over time, cut size, grade efficiency, where the pellet lies, the time and speed a recovery needs with their sensitivities, and engineering measures (RCF, k-factor, Sigma). Speeds are searched on the same account of time as everything else, with the run-up at the same acceleration; not where every particle must be integrated with its inertia (model = "exact" with a run-up or nonlinear drag). Needs the blocks [[cup]] and [suspension].

    Args:
        name: by which others refer to it.
        cup: name of the [[cup]]; the only one when left out (optional).
            a text
        speed: spin speed; the machine's when left out (optional).
            a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        time: time at hand in cups and tubes; an hour when left out (optional).
            a time (s, ms, min), above 0 and at most 1e9 s
        throughput: flow through a bowl, disc stack or decanter; it gives the residence time (optional).
            a volume flow (l/min, l/h, m^3/h), above 0 and at most 1000 m^3/s
        recovery: share to be caught, q (default 0.95).
            a pure number, above 0 and at most 1
        diameter: the share counts among the particles of this size and larger, instead of the whole powder (optional).
            a length (mm, m, µm), above 0 and at most 100 mm
        particles: places of the fixed set at which particles start (default 1024).
            a whole number from 16 to 10000000
        model: motion of the particles (default adaptive).
            "adaptive" (exact at a held speed with Stokes' drag; otherwise with inertia for particles whose drag rate is below 100 times the spin speed, drifting for the rest) or "exact" (inertia of every particle, the swing of the cups in a run-up) or "drifting" (drag and field in balance)
        start: where particles start (default even).
            "even" (spread evenly over the liquid) or "slowest" (all on the axis where it takes longest: full clearing, as k-factor and Sigma count)
        release: place [x, y, z] in the cup of one particle of median size, released and followed by the model of the study: with its inertia unless model = "drifting" (optional).
            a list; a length (mm, m, µm), between -100 m and 100 m
        release_velocity: velocity [x', y', z'] relative to the cup with which that particle is released; at rest when left out (optional).
            a list; a velocity (m/s, mm/s), between -1000 m/s and 1000 m/s
        paths: particles whose paths are shown, the first of the set, until they leave or the time at hand ends (default 12).
            a whole number from 0 to 200
        ramp: time of the run-up from rest, counted in the time at hand; particles settle on the way, cups swing out; of fixed-angle tubes an estimate by the field at mean radius (optional).
            a time (s, ms, min), above 0 and at most 1e7 s
        ramp_shape: how the speed rises (default smooth).
            "linear" (constant acceleration) or "smooth" (10 u^3 - 15 u^4 + 6 u^5)
        programme: speeds at given times, joined by a monotone cubic (PCHIP, slopes of Fritsch and Butland), instead of speed and ramp; the speed a recovery needs and the sensitivities scale all of them (optional).
            columns of equal length { time: times, increasing, from 0 [a time]; speed: spin speed at these times [a speed] }, or a list of rows { time = .., .. }
        transfer_k: k-factor (in S h) of another rotor: the time that clears as much there (optional).
            a pure number, above 0 and at most 1e12

    In a machine file::

        [[study]]
        kind = "separation"
        speed = "3000 rpm"
        time = "8 min"
        particles = 2048
        ramp = "30 s"
    """

def operating_window(
    *,
    name: str | None = None,
    speed: Range,
    cup: str | None = None,
    time: Quantity | None = None,
    throughput: Quantity | None = None,
    recovery: Quantity | None = None,
    diameter: Quantity | None = None,
    particles: int | None = None,
    model: Literal["adaptive", "exact", "drifting"] | None = None,
    start: Literal["even", "slowest"] | None = None,
    ramp: Quantity | None = None,
    count_ramp: bool | None = None,
    objective: Literal["margin", "time", "energy", "amplitude"] | None = None,
    branch_policy: Literal["all", "reached", "highest"] | None = None,
    speed_tolerance: Quantity | None = None,
    uncertain: Named | None = None,
    map: ParameterRange | None = None,
) -> Study:
    """At which speeds the machine may run: stable, its limits kept, the way up survived, and the suspension separated in the time at hand; what binds at each end, the recommended speed, the shortest time, and what to relax when nothing fits. Uses the blocks [limits], [[cup]] and [suspension]; a requirement that is not given is not checked. Stability is assessed with the contents as they are before and after the separation: particles spread over the cups and all at their bottoms, bowls full of suspension and of clear liquid.

    Args:
        name: by which others refer to it.
        speed: spin speeds looked at; points (120 unless given) are added where something happens (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        cup: name of the [[cup]]; the only one when left out (optional).
            a text
        time: time in which cups and tubes must have separated; where liquid flows through, throughput says it (optional).
            a time (s, ms, min), above 0 and at most 1e9 s
        throughput: flow through a bowl, disc stack or decanter; it gives the residence time (optional).
            a volume flow (l/min, l/h, m^3/h), above 0 and at most 1000 m^3/s
        recovery: share to be caught, q (default 0.95).
            a pure number, above 0 and at most 1
        diameter: the share counts among the particles of this size and larger, instead of the whole powder (optional).
            a length (mm, m, µm), above 0 and at most 100 mm
        particles: places of the fixed set at which particles start (default 1024).
            a whole number from 16 to 10000000
        model: motion of the particles (default adaptive).
            "adaptive" (exact at a held speed with Stokes' drag; otherwise with inertia for particles whose drag rate is below 100 times the spin speed, drifting for the rest) or "exact" (inertia of every particle, the swing of the cups in a run-up) or "drifting" (drag and field in balance)
        start: where particles start (default even).
            "even" (spread evenly over the liquid) or "slowest" (all on the axis where it takes longest: full clearing, as k-factor and Sigma count)
        ramp: time of the run-up to the top of the range, at constant acceleration; it is then simulated (optional).
            a time (s, ms, min), above 0 and at most 1e7 s
        count_ramp: the run-up takes its time from the time at hand, and is no longer than it; cups separate on the way, the liquid of fixed-angle tubes by an estimate (field at mean radius), and machines that liquid flows through are fed at speed (default true).
            true or false
        objective: what the recommended speed is best for (default margin).
            "margin" (largest least margin; where it is nearly the same, the largest next one) or "time" (shortest separation, or largest throughput) or "energy" (least kinetic energy and work of the drive) or "amplitude" (smallest vibration against its limits)
        branch_policy: which of several steady states of a nonlinear machine is assessed (default all).
            "all" (every stable steady state must keep the limits) or "reached" (the one that the run-up of the file leads to, and valid for that run-up only) or "highest" (the one with the largest vibration against its limits)
        speed_tolerance: relative error of the speed that the robust window leaves room for (default 0).
            a pure number, between 0 and 0.5
        uncertain: relative uncertainty of parameters by path, as { suspension.viscosity = "20 %" }; the robust window holds at every corner (optional).
            a pure number, above 0 and at most 0.9; one value, or { name = .., name = .. }
        map: a parameter (of a part, a cup or the suspension) to vary against the speed; 12 points unless given (optional).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000

    In a machine file::

        [[study]]
        kind = "operating_window"
        speed = { from = "100 rpm", to = "3000 rpm" }
        time = "10 min"
        recovery = "95 %"
        ramp = "60 s"
    """

def sweep(
    *,
    name: str | None = None,
    speed: Range,
    start: Literal["rest", "up", "down", "up_and_down", "all"] | None = None,
    initial: Mapping[str, Quantity] | None = None,
    method: Literal["auto", "explicit", "stiff"] | None = None,
    settling: Literal["decay", "shooting"] | None = None,
    tolerance: Quantity | None = None,
    most_periods: int | None = None,
    periods: int | None = None,
    section: str | None = None,
    waterfall: str | None = None,
    lyapunov: bool | None = None,
    lyapunov_periods: int | None = None,
    relative_tolerance: Quantity | None = None,
    absolute_tolerance: Quantity | None = None,
) -> Study:
    """Settled motion over the spin speed by integration in time, from the same start at every speed or followed up and down: amplitudes, orders, jumps and hysteresis, period doubling and motions that do not repeat, bifurcation diagram, order spectra, largest Lyapunov exponent. nonlinear_response follows branches of periodic motions, unstable ones too; a sweep shows which of them a machine reaches.

    Args:
        name: by which others refer to it.
        speed: spin speeds, above zero; 200 points unless given (required).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        start: how the motion begins at each speed (default up_and_down).
            "rest" (from the same state at every speed: which motion is reached depends on it) or "up" (from each speed to the next higher one) or "down" (from each speed to the next lower one) or "up_and_down" (both, side by side) or "all" (all three)
        initial: start, by name: displacements ("drum.x", counted from the undeflected place), rates ("drum.x'") and internal states; balls that touch lie side by side from the node line on when nothing is said of them, everything else starts at rest, sagged under its weight when the axis is horizontal (optional).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        method: method of integration (default auto).
            "auto" (explicit unless memory states or stability make it slow) or "explicit" (order 8, for motions that are not stiff) or "stiff" (implicit, order 5)
        settling: how the settled motion is reached (default decay).
            "decay" (as many e-folds of the slowest mode as the tolerance requires) or "shooting" (five e-folds, then Newton's method on the Poincare map; the long way where it fails)
        tolerance: distance from the settled motion over its size, by which it counts as settled and as repeating (default 1e-6).
            a pure number, between 1e-9 and 0.01
        most_periods: most forcing periods of settling of one motion (default 50000).
            a whole number from 1 to 100000000
        periods: forcing periods recorded of every motion, with 64 samples each (default 64).
            a whole number from 48 to 4096
        section: coordinate of the bifurcation diagram, such as "drum.x"; x of the first body unless given (optional).
            the name of a coordinate: "drum.x"
        waterfall: body whose order spectra are wanted, orders -4 (backward) to 4 in steps of 1/16 (optional).
            a text
        lyapunov: compute the largest Lyapunov exponent (default false).
            true or false
        lyapunov_periods: forcing periods over which the exponent is taken; a quarter as many before them (default 2000).
            a whole number from 16 to 10000000
        relative_tolerance: tolerated error of a step over the size of each state; 1e-4 of the tolerance unless given, but at most 1e-10 (optional).
            a pure number, between 1e-14 and 0.0001
        absolute_tolerance: tolerated error of a step over a typical size of each kind of state (1 mm, 10 mrad; velocities: times the spin speed); a tenth of the relative one unless given (optional).
            a pure number, between 1e-18 and 0.0001

    In a machine file::

        [[study]]
        kind = "sweep"
        speed = { from = "1000 rpm", to = "9000 rpm", points = 200 }
        start = "up_and_down"
    """

def motion_map(
    *,
    name: str | None = None,
    y: ParameterRange,
    speed: Range | None = None,
    x: ParameterRange | None = None,
    initial: Mapping[str, Quantity] | None = None,
    method: Literal["auto", "explicit", "stiff"] | None = None,
    settling: Literal["decay", "shooting"] | None = None,
    tolerance: Quantity | None = None,
    most_periods: int | None = None,
    periods: int | None = None,
    relative_tolerance: Quantity | None = None,
    absolute_tolerance: Quantity | None = None,
) -> Study:
    """Settled motion over the spin speed and a parameter, or over two parameters, by integration in time from the same start at every point: largest displacements, and where the motion repeats every turn, after several turns, or not at all. response_map follows all states of every machine; a motion map shows what a start leads to.

    Args:
        name: by which others refer to it.
        y: the parameter along y; 50 points unless given (required).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000
        speed: spin speeds along x, above zero, 50 points unless given; half to one and a half times that of the machine when left out. One speed beside x: that of all motions (optional).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        x: a second parameter along x in place of the speed, which is then one: speed, or that of the machine (optional).
            { parameter = "drum.mass", from = .., to = .., points = .. }, in the unit of the parameter; points optional, at most 100000
        initial: start, by name: displacements ("drum.x", counted from the undeflected place), rates ("drum.x'") and internal states; balls that touch lie side by side from the node line on when nothing is said of them, everything else starts at rest, sagged under its weight when the axis is horizontal (optional).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        method: method of integration (default auto).
            "auto" (explicit unless memory states or stability make it slow) or "explicit" (order 8, for motions that are not stiff) or "stiff" (implicit, order 5)
        settling: how the settled motion is reached (default decay).
            "decay" (as many e-folds of the slowest mode as the tolerance requires) or "shooting" (five e-folds, then Newton's method on the Poincare map; the long way where it fails)
        tolerance: distance from the settled motion over its size, by which it counts as settled and as repeating (default 1e-6).
            a pure number, between 1e-9 and 0.01
        most_periods: most forcing periods of settling of one motion (default 10000).
            a whole number from 1 to 100000000
        periods: forcing periods recorded of every motion, with 64 samples each (default 64).
            a whole number from 48 to 4096
        relative_tolerance: tolerated error of a step over the size of each state; 1e-4 of the tolerance unless given, but at most 1e-10 (optional).
            a pure number, between 1e-14 and 0.0001
        absolute_tolerance: tolerated error of a step over a typical size of each kind of state (1 mm, 10 mrad; velocities: times the spin speed); a tenth of the relative one unless given (optional).
            a pure number, between 1e-18 and 0.0001

    In a machine file::

        [[study]]
        kind = "motion_map"
        speed = { from = "1000 rpm", to = "9000 rpm", points = 60 }
        y = { parameter = "drum.eccentricity", from = "10 um", to = "100 um", points = 20 }
    """

def basins(
    *,
    name: str | None = None,
    from_: Mapping[str, Quantity],
    to: Mapping[str, Quantity],
    speed: Quantity | None = None,
    points: Named | None = None,
    run_up: Range | None = None,
    initial: Mapping[str, Quantity] | None = None,
    method: Literal["auto", "explicit", "stiff"] | None = None,
    settling: Literal["decay", "shooting"] | None = None,
    tolerance: Quantity | None = None,
    most_periods: int | None = None,
    periods: int | None = None,
    relative_tolerance: Quantity | None = None,
    absolute_tolerance: Quantity | None = None,
    recognise: Literal["early", "never"] | None = None,
    check: int | None = None,
) -> Study:
    """Basins of attraction at one speed: which motion the machine settles on from every pair of two initial values on a grid, how many motions there are, which share of the grid leads to each, and the smallest disturbance that leads to another. nonlinear_response follows branches of periodic motions; basins show which of them a disturbance reaches. For a machine with movable masses they show from which places the balls of a balancer reach the balanced state, and from which they stay elsewhere or go round for ever.

    Args:
        name: by which others refer to it.
        from_: lower ends of two initial values: displacements ("drum.x"), rates ("drum.x'") or internal states. The map shows coordinates before rates before internal states: the first along x (required).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        to: upper ends of the same two (required).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        speed: spin speed, above zero; the machine's when left out (optional).
            a speed (rad/s, rpm, Hz), between 0 and 1e6 rad/s (9.549e6 rpm)
        points: whole numbers of points from end to end, as 100 or { "drum.x" = 100, "drum.x'" = 80 } (default 50).
            a pure number, between 2 and 10000; one value, or { name = .., name = .. }
        run_up: machines with movable masses: durations of a run-up from standstill at constant acceleration, along y; from and to then name one initial value (optional).
            one value, or { from = .., to = .., points = .. }, points optional, at most 100000; a time (s, ms, min), above 0 and at most 1e6 s
        initial: start, by name: displacements ("drum.x", counted from the undeflected place), rates ("drum.x'") and internal states; balls that touch lie side by side from the node line on when nothing is said of them, everything else starts at rest, sagged under its weight when the axis is horizontal (optional).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        method: method of integration (default auto).
            "auto" (explicit unless memory states or stability make it slow) or "explicit" (order 8, for motions that are not stiff) or "stiff" (implicit, order 5)
        settling: how the settled motion is reached (default decay).
            "decay" (as many e-folds of the slowest mode as the tolerance requires) or "shooting" (five e-folds, then Newton's method on the Poincare map; the long way where it fails)
        tolerance: distance from the settled motion over its size, by which it counts as settled and as repeating (default 1e-6).
            a pure number, between 1e-9 and 0.01
        most_periods: most forcing periods of settling of one motion (default 10000).
            a whole number from 1 to 100000000
        periods: forcing periods recorded of every motion, with 64 samples each (default 64).
            a whole number from 48 to 4096
        relative_tolerance: tolerated error of a step over the size of each state; 1e-4 of the tolerance unless given, but at most 1e-10 (optional).
            a pure number, between 1e-14 and 0.0001
        absolute_tolerance: tolerated error of a step over a typical size of each kind of state (1 mm, 10 mrad; velocities: times the spin speed); a tenth of the relative one unless given (optional).
            a pure number, between 1e-18 and 0.0001
        recognise: machines with movable masses, such as the balls of a balancer: whether the end of a motion may be recognised before it is reached (default early).
            "early" (on large maps a motion ends as soon as it is known where it goes: it came half as near to an attractor as any motion followed beforehand that went elsewhere) or "never" (every motion is followed to its end)
        check: where ends are recognised early: so many cells, chosen by chance, are followed to their ends as well, to see whether they end there (default 0).
            a whole number from 0 to 100000

    In a machine file::

        [[study]]
        kind = "basins"
        speed = "3000 rpm"
        from = { "drum.x" = "-1 mm", "drum.y" = "-1 mm" }
        to = { "drum.x" = "1 mm", "drum.y" = "1 mm" }
        points = 50
    """

def uncertainty(
    *,
    name: str | None = None,
    study: str | Study,
    parameters: Sequence[Tolerance],
    samples: int | None = None,
    method: Literal["sobol", "monte_carlo"] | None = None,
    indices: Literal["none", "sobol", "morris"] | None = None,
    quantiles: Quantities | None = None,
    seed: int | None = None,
    show: str | None = None,
) -> Study:
    """Runs another study for many values of uncertain parameters: mean, deviation and quantiles of every number it finds, how often it finds it at all, and, where requested, which parameter matters how much.

    Args:
        name: by which others refer to it.
        study: what is computed for every sample (required).
            the name of another study of the file, or a whole one: { kind = "modes", .. }
        parameters: the uncertain parameters, independent of each other (required).
            a list of { parameter = .., distribution = .., .. }; distributions "normal" (deviation: standard deviation; mean unless it is the value of the machine), "log_normal" (the same, for what cannot be negative: its logarithm is normal), "uniform" (from and to, or tolerance: half the width about the value of the machine), "triangular" (the same, most probable at mode, the value of the machine unless given); numbers in the unit of the parameter, or in % of its value in the machine
        samples: number of samples; with indices the number of base points or trajectories (default 256).
            a whole number from 2 to 1000000
        method: how points are chosen; those of Morris are random (default sobol).
            "sobol" (points of a scrambled Sobol sequence, which fill the space evenly) or "monte_carlo" (independent random points)
        indices: which parameter matters (default none).
            "none" (distributions alone) or "sobol" (first-order and total indices of Sobol: samples times (number of parameters + 2) runs) or "morris" (elementary effects of Morris instead of distributions: samples times (number of parameters + 1) runs)
        quantiles: shares of the samples below the values reported (default [0.05, 0.5, 0.95]).
            a list; a pure number, between 1e-6 and 1
        seed: another seed gives other points (default 1).
            a whole number from 0 to 4294967295
        show: beginning of the names of the numbers drawn, as critical_speed; the first four unless given (optional).
            a text

    In a machine file::

        [[study]]
        kind = "uncertainty"
        study = { kind = "modes", speed = "3000 rpm" }
        parameters = [{ parameter = "drum.mass", distribution = "normal", deviation = "2 %" }]
        samples = 256
    """

def optimum(
    *,
    name: str | None = None,
    study: str | Study,
    vary: Sequence[ParameterRange],
    minimise: str | None = None,
    maximise: str | None = None,
    at_most: Mapping[str, Quantity] | None = None,
    at_least: Mapping[str, Quantity] | None = None,
    starts: int | None = None,
    runs: int | None = None,
    tolerance: Quantity | None = None,
) -> Study:
    """Recommended parameters within bounds: makes a number that another study finds as small or as large as possible (least peak, least force, widest window, highest speed of instability), keeps limits on others, and says how far each parameter may stray.

    Args:
        name: by which others refer to it.
        study: what is computed for every machine (required).
            the name of another study of the file, or a whole one: { kind = "modes", .. }
        vary: the parameters and their bounds; a range over a decade and more is searched in the logarithm (required).
            a list of { parameter = .., from = .., to = .. }, the ends in the unit of the parameter
        minimise: name of the number to make small, as results.json and uncertainty call it: the finding and what it speaks of; the largest where there are several; of a finding whose number is a speed, what it has there, as largest_resonance.amplitude (default largest_displacement).
            a text
        maximise: the number to make large instead; the least where there are several (optional).
            a text
        at_most: upper limits on numbers: { "largest_force bearing" = "5 kN" } (optional).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        at_least: lower limits on numbers (optional).
            values by coordinate or rate: { "drum.x" = "1 mm", "drum.x'" = "0.1 m/s" }
        starts: searches: from the machine as it is, and from elsewhere in the bounds (default 3).
            a whole number from 1 to 32
        runs: most runs of the study in each search (default 600).
            a whole number from 20 to 100000
        tolerance: by how much the number may be worse in the recommended range of a parameter (default 5 %).
            a pure number, between 0.0001 and 10

    In a machine file::

        [[study]]
        kind = "optimum"
        study = { kind = "modes", speed = "3000 rpm" }
        vary = [{ parameter = "drum.mass", from = "2 kg", to = "4 kg" }]
        maximise = "least_damped_mode damping ratio"
    """
