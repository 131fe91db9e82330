"""Times of the same analyses of the same rotors in ROSS and in laval, on this computer, where `ross-rotordynamics` can be imported.

    pip install ross-rotordynamics "plotly<6"
    python crates/laval-py/benches/beside_ross.py

It prints times and their ratios; nothing is asserted. Every analysis is computed anew in each run: ROSS keeps results of `run_*`, so that the rotor is made anew for each of them, and only the analysis is timed.
Both are checked to agree in the frequencies of the lowest modes, and the difference is printed.
"""

from __future__ import annotations

import os
import statistics
import sys
import time
from collections.abc import Callable

SPEED = 314.0
RUNS = 5
SPEEDS = 30


def timed(make: Callable[[], object], call: Callable[[object], object]) -> float:
    """Median time of a call on something that is made anew, ms."""
    times = []
    for _ in range(RUNS):
        subject = make()
        begun = time.perf_counter()
        call(subject)
        times.append((time.perf_counter() - begun) * 1e3)
    return statistics.median(times)


def two_discs(rs: object, elements: int) -> object:
    """A shaft of 1.5 m with two discs on two equal bearings."""
    steel = rs.Material(name="steel_7810", rho=7810, E=211e9, G_s=81.2e9)
    each = 1.5 / elements
    shaft = [rs.ShaftElement(L=each, idl=0.0, odl=0.05, material=steel, n=k) for k in range(elements)]
    discs = [
        rs.DiskElement(n=elements // 3, m=32.59, Id=0.1781, Ip=0.3296),
        rs.DiskElement(n=2 * elements // 3, m=51.53, Id=0.4236, Ip=0.8051),
    ]
    bearings = [rs.BearingElement(n=k, kxx=1e6, kyy=8e5, cxx=300.0, cyy=300.0) for k in (0, elements)]
    return rs.Rotor(shaft, discs, bearings, rated_w=SPEED)


def rotating(np: object, rotor: object, node: int) -> object:
    """A force of an unbalance of 0.1 g m at a node over one second."""
    t = np.linspace(0.0, 1.0, 10_000)
    force = np.zeros((len(t), rotor.ndof))
    for place, wave in ((0, np.cos), (1, np.sin)):
        force[:, rotor.number_dof * node + place] = 1e-4 * SPEED**2 * wave(SPEED * t)
    return force


def lowest(rotor: object, machine: object, laval: object) -> float:
    """Largest relative difference of the four lowest frequencies."""
    theirs = sorted(w for w in rotor.run_modal(speed=SPEED, num_modes=24).wd if w > 1.0)
    ours = sorted(w for w in machine.run(laval.studies.modes(speed=SPEED))[0].tables["modes"]["frequency"] if w > 1.0)
    # along and about the axis ROSS has further modes
    return max(min(abs(o / t - 1.0) for t in theirs) for o in ours[:4])


def main() -> None:
    try:
        import numpy as np
        import ross as rs
    except ImportError as why:
        print(f"ROSS is not here ({why}): pip install ross-rotordynamics")
        return
    import laval

    print(f"ROSS {rs.__version__}, laval {laval.__version__}, Python {sys.version.split()[0]}, {os.cpu_count()} processors; medians of {RUNS} runs, ms")
    print(f"{'rotor':24} {'analysis':34} {'ROSS':>10} {'laval':>10} {'ratio':>8}")
    speeds = np.linspace(10.0, 600.0, SPEEDS)
    span = laval.span("10 rad/s", "600 rad/s", points=SPEEDS)
    for elements in (6, 24, 48):
        machine = laval.from_ross(two_discs(rs, elements))
        first = elements // 3
        place = {"body": "shaft", "at": 1.5 / elements * first}
        turning = machine.with_({"Disk 0.unbalance": "100 g mm"})
        analyses = [
            ("modes at one speed", lambda r: r.run_modal(speed=SPEED, num_modes=24), laval.studies.modes(speed=SPEED)),
            (f"Campbell diagram, {SPEEDS} speeds", lambda r: r.run_campbell(speeds, frequencies=6), laval.studies.campbell(speed=span)),
            ("critical speeds", lambda r: r.run_critical_speed(num_modes=12), laval.studies.critical_speeds(speed=span)),
            (
                f"response to a force, {SPEEDS} speeds",
                lambda r: r.run_unbalance_response(node=first, unbalance_magnitude=1e-4, unbalance_phase=0.0, frequency=speeds),
                laval.studies.harmonic_force(place=place, direction="forward", speed=span),
            ),
            (
                "critical speeds, 20 stiffnesses",
                lambda r: r.run_ucs(stiffness_range=(5, 10), num=20),
                laval.studies.support_stiffness_map(stiffness=laval.span("1e5 N/m", "1e10 N/m", points=20)),
            ),
            (
                "motion of 1 s, 10 000 points",
                lambda r: r.run_time_response(SPEED, rotating(np, r, first), np.linspace(0.0, 1.0, 10_000)),
                laval.studies.transient(duration="1 s", points=10_000, speed=SPEED, relative_tolerance=1e-6, absolute_tolerance=1e-7),
            ),
        ]
        for name, theirs, study in analyses:
            try:
                ross = timed(lambda: two_discs(rs, elements), theirs)
                own = timed(lambda: turning if "motion" in name else machine, lambda m, study=study: m.run(study))
            except Exception as why:  # noqa: BLE001: an analysis that one of them refuses is no reason to leave the others out
                print(f"{f'two discs, {elements} elements':24} {name:34} {type(why).__name__}: {str(why)[:60]}")
                continue
            print(f"{f'two discs, {elements} elements':24} {name:34} {ross:10.1f} {own:10.1f} {ross / own:8.1f}")
        print(f"{'':24} largest difference of the four lowest frequencies {lowest(two_discs(rs, elements), machine, laval):.1e}")


if __name__ == "__main__":
    main()
