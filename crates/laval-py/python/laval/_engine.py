"""Who computes cases: this process, or the workers of Dask.

A task of Dask is one part of the cases, named by its number and the number of all parts, so that a task says nothing but where to work. What is done is
what the folder holds: tasks may be repeated, lost or run twice.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import lru_cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

if TYPE_CHECKING:
    import distributed

    from laval._cases import Cases

SECONDS = 1.25
"""What a task should take: long beside what the scheduler needs for it, short beside a run."""
PATIENCE = 120.0
"""For a folder that parts of an earlier scheduler still write into, and for a scheduler that is started anew."""


class Extent(NamedTuple):
    """How far a run of cases is."""

    done: int
    """Cases that are there."""
    total: int
    """Cases requested."""
    rate: float
    """Cases per second of this run; NaN before the first."""
    remaining: float
    """Seconds that the others take at this rate; NaN before the first."""


class Meter:
    """Counts what a run adds to what was there."""

    def __init__(self, done: int, total: int, follow: Callable[[Extent], Any]) -> None:
        self._before, self._total, self._follow = done, total, follow
        self._begun = self._said = time.monotonic()
        self.at(done)

    def now(self, done: Callable[[], int]) -> None:
        """Says how far the run is, unless it has done so just now: looking at many files takes time."""
        if time.monotonic() - self._said > 0.25:
            self.at(done())

    def at(self, done: int) -> None:
        self._said = time.monotonic()
        passed = self._said - self._begun
        rate = (done - self._before) / passed if passed > 0 and done > self._before else math.nan
        self._follow(Extent(done, self._total, rate, (self._total - done) / rate))


@contextmanager
def _shown(progress: bool | Callable[[Extent], Any]) -> Iterator[Callable[[Extent], Any]]:
    if progress is False or progress is None:
        yield lambda extent: None
    elif progress is not True:
        yield progress
    else:
        from tqdm.auto import tqdm

        bar: Any = None

        def follow(extent: Extent) -> None:
            nonlocal bar
            if bar is None:
                # what was there from an earlier run says nothing of the rate
                bar = tqdm(total=extent.total, initial=extent.done, unit="case")
            bar.update(extent.done - bar.n)

        try:
            yield follow
        finally:
            if bar is not None:
                bar.close()


def run(
    cases: Cases,
    client: distributed.Client | Literal[False] | None,
    workers: int | None,
    retries: int,
    progress: bool | Callable[[Extent], Any],
) -> None:
    """Computes the missing cases and collects all."""
    with _shown(progress) as follow:
        meter = Meter(cases.done, cases.rows, follow)
        # the files that a collection rejects are those that parts compute again
        for _ in range(retries + 1):
            if client is False or (client is None and not _dask()):
                # as one part: the list of files is written once, by the collection
                there = cases.done
                notes = cases._core.run((1, 1), None, lambda _, done, __: meter.at(max(there, int(done))))
                cases._warn(notes)
            else:
                _on_dask(cases, client, workers, retries, meter)
            meter.at(cases.done)
            try:
                _collected(cases)
            except LookupError as error:
                missing = error
            else:
                return
        raise missing


def _dask() -> bool:
    from importlib.util import find_spec

    return find_spec("distributed") is not None


def _distributed() -> Any:
    return import_module("distributed")


def _collected(cases: Cases) -> None:
    begun = time.monotonic()
    while True:
        try:
            cases.collect()
        except BlockingIOError:
            if time.monotonic() - begun > PATIENCE:
                raise
            time.sleep(0.2)
        else:
            return


@lru_cache(maxsize=8)
def _opened(folder: str, mark: str) -> Cases:
    from laval._cases import Cases

    try:
        cases = Cases(folder)
    except FileNotFoundError as error:
        raise FileNotFoundError(f"{folder} is not there for this worker: all workers must see it under the same path") from error
    if cases._mark != mark:
        raise ValueError(f"{folder} holds other cases for this worker than for the client")
    return cases


def part(folder: str, mark: str, number: int, of: int) -> None:
    """A task: one part, on one thread, for Dask gives a worker as many tasks at once as it has threads."""
    _opened(folder, mark).part(number, of, threads=1)


def trial(folder: str, mark: str, chunks: list[int]) -> tuple[int, float]:
    """The first task of a worker: some files, until a second has passed. How many, and how many seconds each took but the first."""
    cases = _opened(folder, mark)
    begun = ends = time.monotonic()
    done = 0
    for done, chunk in enumerate(chunks, 1):
        cases.part(chunk + 1, cases.chunks, threads=1)
        now = time.monotonic()
        if done == 1:
            # it holds what is done once in a process
            first, ends = now - begun, now
        if now - begun > SECONDS / 2:
            break
    return done, first if done < 2 else (now - ends) / (done - 1)


def _here(workers: int | None, stack: ExitStack) -> Any:
    """A client of a cluster on this computer."""
    dask = _distributed()
    if workers is None:
        workers = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    # nobody sees the samples of what workers do, which they take a hundred times a second
    with import_module("dask").config.set({"distributed.worker.profile.enabled": False}):
        cluster = dask.LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None)
    return stack.enter_context(dask.Client(stack.enter_context(cluster)))


def _missing(cases: Cases) -> list[int]:
    return [k for k, there in enumerate(cases._core.present()) if not there]


def _parts(cases: Cases, seconds: float, slots: int) -> list[tuple[int, int]]:
    """Parts of about :data:`SECONDS`, as many for each slot; those of them that have anything to do."""
    missing = _missing(cases)
    rounds = max(1, round(len(missing) * seconds / (slots * SECONDS)))
    of = min(slots * rounds, cases.chunks)
    return [(number + 1, of) for number in sorted({k % of for k in missing})]


def _on_dask(cases: Cases, client: Any, workers: int | None, retries: int, meter: Meter) -> None:
    with ExitStack() as stack:
        if client is None:
            client = _here(workers, stack)
        where = (os.path.abspath(cases.folder), cases._mark)
        missing = _missing(cases)
        if not missing:
            # all are there by name; one that is damaged is found by the part that it belongs to
            _each(cases, client, [(part, (*where, 1, 1))], retries, meter)
            return
        slots = max(1, sum(client.nthreads().values()))
        trials = [(trial, (*where, missing[k::slots])) for k in range(min(slots, len(missing)))]
        measured = _each(cases, client, trials, retries, meter)
        seconds = [each for done, each in measured if done]
        parts = _parts(cases, sum(seconds) / len(seconds) if seconds else SECONDS, slots)
        _each(cases, client, [(part, (*where, *numbers)) for numbers in parts], retries, meter)


def _each(cases: Cases, client: Any, tasks: list[tuple[Any, tuple[Any, ...]]], retries: int, meter: Meter) -> list[Any]:
    """The results of tasks, whatever happens to workers and scheduler, as often as is allowed."""
    as_completed = _distributed().as_completed
    left, results, losses = list(range(len(tasks))), {}, 0
    while left:
        futures = {}
        try:
            for k in left:
                call, arguments = tasks[k]
                futures[client.submit(call, *arguments, pure=False, retries=retries)] = k
            for future in as_completed(futures):
                if future.status == "finished":
                    results[futures[future]] = future.result()
                    meter.now(lambda: cases.done)
                elif future.status == "error":
                    future.result()
        except BaseException as error:
            if not _lost(error):
                # parts that no one waits for would go on writing
                _forget(client, list(futures))
                raise
        left = [k for k in left if k not in results]
        if left:
            losses += 1
            if losses > retries or not _back(client):
                raise ConnectionError(f"the scheduler was lost; {cases.done} of {cases.rows} cases are there, and the same run goes on with them")
    return [results[k] for k in range(len(tasks))]


def _forget(client: Any, futures: list[Any]) -> None:
    from contextlib import suppress

    with suppress(Exception):
        client.cancel(futures)


def _lost(error: BaseException) -> bool:
    """Whether the scheduler has gone, not the task failed."""
    from concurrent.futures import CancelledError

    # some of them are of Dask, under names that depend on its version
    return isinstance(error, CancelledError) or type(error).__name__ in ("CommClosedError", "FutureCancelledError", "FuturesCancelledError")


def _back(client: Any) -> bool:
    """Waits until a scheduler answers that has workers."""
    begun = time.monotonic()
    while time.monotonic() - begun < PATIENCE:
        if client.status in ("closed", "closing"):
            return False
        try:
            if client.status == "running" and client.scheduler_info()["workers"]:
                return True
        except Exception:
            pass
        time.sleep(0.2)
    return False
