"""What cases cost on this computer: rates over the workers, kills, and memory for a million rows.

    python crates/laval-py/benches/cases.py            # all
    python crates/laval-py/benches/cases.py kills      # one of rate, kills, million
"""

from __future__ import annotations

import hashlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path

import laval
from laval import designs

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from conftest import ROTOR  # noqa: E402

ROTOR_MACHINE = laval.loads(ROTOR, "rotor")
CRITICAL = laval.studies.critical_speeds(speed=laval.span("100 rad/s", "600 rad/s"))


def spread(cases: int) -> designs.Design:
    parameters = {"disc.mass": {"distribution": "normal", "deviation": "5 %"}, "air.damping": laval.span(10.0, 30.0)}
    return designs.latin_hypercube(parameters, cases)


def sums(folder: Path) -> dict[str, str]:
    found = (p for p in sorted(folder.rglob("*")) if p.is_file() and p.name != ".lock")
    return {str(p.relative_to(folder)): hashlib.sha256(p.read_bytes()).hexdigest() for p in found}


def peak() -> float:
    """Largest memory of this process so far, MB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def rate(place: Path, cases: int = 10_000) -> None:
    """Cases per second of clusters of one and of two workers, without what it takes to start them; beside processes that share nothing at all."""
    from laval._engine import _here

    sweep = laval.Sweep(ROTOR_MACHINE, spread(cases), CRITICAL)
    found: dict[int, list[float]] = {}
    plain: dict[int, list[float]] = {}
    for workers in (1, 2, 1, 2, 1, 2):
        folder = place / f"plain-{workers}"
        shutil.rmtree(folder, ignore_errors=True)
        sweep.prepare(folder)
        begun = time.monotonic()
        parts = [[sys.executable, "-m", "laval", "part", str(folder), f"{k + 1}/{workers}", "--threads", "1"] for k in range(workers)]
        for process in [subprocess.Popen(part, stdout=subprocess.DEVNULL) for part in parts]:
            assert process.wait() == 0
        plain.setdefault(workers, []).append(cases / (time.monotonic() - begun))
        folder = place / f"rate-{workers}"
        shutil.rmtree(folder, ignore_errors=True)
        prepared = sweep.prepare(folder)
        with ExitStack() as stack:
            client = _here(workers, stack)
            # every worker has imported the package
            client.run(lambda: __import__("laval._engine"))
            begun = time.monotonic()
            prepared.run(client)
            found.setdefault(workers, []).append(cases / (time.monotonic() - begun))
    one, two = max(found[1]), max(found[2])
    print(f"rate: {one:.0f} cases/s with one worker, {two:.0f} with two: efficiency {two / (2 * one):.3f}")
    alone, both = max(plain[1]), max(plain[2])
    print(f"processes without a scheduler: {alone:.0f} cases/s by one, {both:.0f} by two: efficiency {both / (2 * alone):.3f}")
    print(f"1e6 cases of this study at that rate: {1e6 / two / 60:.1f} min with two workers, {1e6 / one / 64 / 60:.2f} min with 64")


def kills(place: Path, cases: int = 10_000) -> None:
    """Four workers; one is killed, the scheduler is killed and started again: the files are those of an undisturbed run."""
    from clusters import Cluster, Disturbance
    from distributed import Client

    sweep = laval.Sweep(ROTOR_MACHINE, spread(cases), CRITICAL)
    begun = time.monotonic()
    whole = sweep.run(place / "whole", client=False)
    alone = time.monotonic() - begun
    cluster = Cluster(4)
    try:
        with Client(cluster.address) as client:
            client.wait_for_workers(4)
            disturb = Disturbance(cluster, client)
            begun = time.monotonic()
            disturbed = sweep.run(place / "disturbed", client=client, progress=disturb)
            passed = time.monotonic() - begun
    finally:
        cluster.close()
    same = sums(whole.folder) == sums(disturbed.folder)
    print(f"kills: {cases} machines, {', '.join(disturb.done)} killed; {alone:.1f} s alone, {passed:.1f} s disturbed; files identical: {same}")
    assert same and disturb.done == ["worker", "scheduler"]


def million(place: Path, cases: int = 1_000_000) -> None:
    """A million rows: memory of the process that collects and reads them."""
    before = peak()
    begun = time.monotonic()
    sweep = laval.Sweep(ROTOR_MACHINE, spread(cases), laval.studies.modes())
    found = sweep.run(place / "million", workers=2)
    passed, collected = time.monotonic() - begun, peak()
    total = sum(float(batch["disc.mass"].sum()) for batch in found.batches(["disc.mass"]))
    bytes_of = sum(Path(file).stat().st_size for file in found.files)
    print(f"million: {found.done} rows in {passed:.1f} s, {len(found.files)} files of {bytes_of / 1e6:.0f} MB, mean mass {total / cases:.6f} kg")
    print(f"memory of this process: {before:.0f} MB before, {collected:.0f} MB after collecting, {peak():.0f} MB after reading in batches")
    assert peak() < 300


def main() -> None:
    wanted = sys.argv[1:] or ["rate", "kills", "million"]
    place = Path(tempfile.mkdtemp(prefix="laval-cases-"))
    try:
        for name in wanted:
            {"rate": rate, "kills": kills, "million": million}[name](place)
    finally:
        shutil.rmtree(place, ignore_errors=True)


if __name__ == "__main__":
    main()
