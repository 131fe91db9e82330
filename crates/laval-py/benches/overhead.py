"""What a call costs beside what it computes, and what a large table costs.

    python crates/laval-py/benches/overhead.py

It prints; nothing is asserted.
"""

from __future__ import annotations

import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable

ROTOR = """
machine = { name = "rotor", speed = "2000 rpm" }
part = [
    { kind = "disc", name = "disc", mass = "3 kg", eccentricity = "20 um" },
    { kind = "shaft_lumped", name = "shaft", between = ["disc", "ground"], stiffness = "3e5 N/m" },
    { kind = "damper", name = "air", between = ["disc", "ground"], damping = "20 N s/m" },
]
study = [{ kind = "modes" }]
"""


def timed(what: str, call: Callable[[], object], repeats: int = 200, inner: int = 20) -> None:
    """Median and least of the time of a call."""
    times = []
    for _ in range(repeats):
        begun = time.perf_counter()
        for _ in range(inner):
            call()
        times.append((time.perf_counter() - begun) / inner * 1e6)
    print(f"{what:58} {statistics.median(times):10.2f} us   least {min(times):10.2f} us")


def imported() -> None:
    """Time of the import in new processes, beside that of Python and of NumPy."""
    for code in ("pass", "import numpy", "import laval", "import numpy, laval"):
        times = []
        for _ in range(15):
            begun = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            times.append((time.perf_counter() - begun) * 1e3)
        print(f"process with {code!r:45} {statistics.median(times):10.1f} ms   least {min(times):10.1f} ms")


def main() -> None:
    imported()
    import numpy as np

    import laval
    from laval import _native

    machine = laval.loads(ROTOR)
    results = machine.run()
    study = results[0]
    table = study.tables["modes"]
    timed("machine.speed", lambda: machine.speed)
    timed("machine.parameters", lambda: machine.parameters)
    timed("machine.text == (canonical text, kept)", lambda: machine == machine)
    timed("machine.with_ (read and assembled anew)", lambda: machine.with_({"disc.mass": 3.1}))
    timed("table['frequency'] (NumPy view)", lambda: table["frequency"])
    timed("table.__arrow_c_stream__()", table.__arrow_c_stream__)
    timed("results['modes']", lambda: results["modes"])
    timed("finding.text", lambda: study.findings[0].text)
    timed("_native.si('3000 rpm')", lambda: _native.si("3000 rpm"))
    timed("waiting for a run of nothing", lambda: _native.idle(), inner=50)
    timed("machine.run() of modes", machine.run, inner=5)
    timed("results.studies of a new run (JSON read)", lambda: machine.run().studies, inner=5)
    f = machine.function(laval.Mode(1), ["shaft.stiffness"])
    timed("function of SciPy: a mode and its gradient", lambda: f([3e5]), inner=5)

    rows = 1_000_000
    values = np.random.default_rng(1).normal(size=rows).tolist()
    big = laval.Table(_native.Table("big", "", [(f"c{k}", "m", "", "float", values) for k in range(10)]))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    views = [big[name] for name in big]
    print(f"ten columns of 1e6 rows: NumPy views, peak memory {(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024:+.1f} MB")
    timed("ten NumPy views of 1e6 rows", lambda: [big[name] for name in big])
    for module in ("pyarrow", "polars", "pandas"):
        try:
            __import__(module)
        except ImportError:
            continue
        getattr(big, module)()
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        kept = getattr(big, module)()
        grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
        print(f"{module}: peak memory {grown:+.1f} MB for a table of 80 MB")
        timed(f"{module} of ten columns of 1e6 rows", getattr(big, module), repeats=20, inner=3)
        del kept
    del views


if __name__ == "__main__":
    main()
