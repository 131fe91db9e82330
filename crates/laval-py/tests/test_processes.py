"""Threads, forked processes, Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

import laval
from conftest import ROTOR

# parallel loops in one study, seconds in the other
MAP = laval.studies.stability_map(
    speed=laval.span(10.0, 1000.0, points=40),
    parameter={"parameter": "air.damping", **laval.span("1 N s/m", "40 N s/m", points=10)},
)
LONG = laval.studies.transient(name="long", duration="100000 s", initial={"disc.x": "1 mm"})


def growth(machine: laval.Machine) -> np.ndarray:
    study = machine.run(MAP)[0]
    return np.concatenate([np.nan_to_num(table[name]) for table in study.tables.values() for name in table if table[name].dtype == float])


def test_threads(rotor: laval.Machine) -> None:
    alone = growth(rotor)
    with ThreadPoolExecutor(8) as pool:
        for found in pool.map(growth, [rotor] * 16):
            assert np.array_equal(found, alone)


def test_the_interpreter_goes_on_meanwhile(rotor: laval.Machine) -> None:
    counted, done = 0, threading.Event()

    def work() -> None:
        rotor.run(LONG, work_limit=200_000)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.wait(0.001):
        counted += 1
    thread.join()
    assert counted > 5


def _child(text: str, queue: object) -> None:
    queue.put(growth(laval.loads(text, "rotor")))  # type: ignore[attr-defined]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*:DeprecationWarning")
def test_a_forked_process_has_threads_of_its_own(rotor: laval.Machine) -> None:
    alone = growth(rotor)
    context = get_context("fork")
    # while another thread of the parent computes, too
    other = threading.Thread(target=lambda: rotor.run(LONG, work_limit=400_000))
    other.start()
    queue = context.Queue()
    children = [context.Process(target=_child, args=(ROTOR, queue)) for _ in range(3)]
    for child in children:
        child.start()
    for _ in children:
        assert np.array_equal(queue.get(timeout=60), alone)
    for child in children:
        child.join(60)
        assert child.exitcode == 0
    other.join()
    assert np.array_equal(growth(rotor), alone)


SCRIPT = f"""
import sys, laval
machine = laval.loads('''{ROTOR}''', "rotor")
long = laval.studies.transient(name="long", duration="100000 s", initial={{"disc.x": "1 mm"}})
machine = machine.with_(studies=[laval.studies.modes(), long, laval.studies.modes(name="later")])
print("begun", flush=True)
try:
    results = machine.run(interrupted=sys.argv[1])
except KeyboardInterrupt as stop:
    assert isinstance(stop, laval.Interrupted), stop
    results = stop.results
    print("raised", flush=True)
print(*(study.end for study in results), sep=" ", flush=True)
assert results["modes"].tables["modes"].rows == 2
assert results.verdict is None and results.report_html() and not results.complete
"""


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize(("way", "said"), [("raise", ["raised"]), ("return", [])])
def test_ctrl_c_stops_and_keeps_what_is_done(way: str, said: list[str]) -> None:
    process = subprocess.Popen([sys.executable, "-c", SCRIPT, way], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    time.sleep(1.0)
    begun = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=30)
    assert time.monotonic() - begun < 15, "it took long to stop"
    assert process.returncode == 0, errors
    assert out.split() == [*said, "reached", "cancelled", "cancelled"], errors


def test_a_handler_that_does_not_raise_stops_nothing(rotor: laval.Machine) -> None:
    seen = []
    before = signal.signal(signal.SIGINT, lambda *_: seen.append(1))
    try:
        timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        results = rotor.run(LONG, work_limit=300_000)
        timer.join()
    finally:
        signal.signal(signal.SIGINT, before)
    assert results[0].end == "work_limit"


def test_long_studies_go_on_in_their_folder(rotor: laval.Machine, tmp_path: object) -> None:
    sweep = laval.studies.sweep(speed=laval.span(100.0, 400.0, points=8))
    machine = rotor.with_(studies=[sweep])
    whole = machine.run(out=str(tmp_path))
    again = machine.run(out=str(tmp_path))
    assert again[0].tables["sweep"] == whole[0].tables["sweep"]
    assert machine.run()[0].tables["sweep"] == whole[0].tables["sweep"]
    with pytest.raises(OSError, match="folder|file"):
        machine.run(out=__file__)
