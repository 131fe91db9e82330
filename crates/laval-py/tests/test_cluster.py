"""Cases on clusters of Dask: workers that are killed, schedulers that stop."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

import laval
from clusters import Cluster, Disturbance
from conftest import ROTOR
from test_cases import MODES, files, spread

distributed = pytest.importorskip("distributed")
STUDY = laval.studies.critical_speeds(speed=laval.span("100 rad/s", "600 rad/s"))


@pytest.fixture
def cluster() -> Iterator[Cluster]:
    made = Cluster(4)
    yield made
    made.close()


@pytest.fixture
def sweep(rotor: laval.Machine) -> laval.Sweep:
    return laval.Sweep(rotor, spread(4000), STUDY)


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_a_worker_is_killed_and_the_scheduler_started_anew(cluster: Cluster, sweep: laval.Sweep, tmp_path: Path) -> None:
    whole = sweep.run(tmp_path / "whole", client=False)
    with distributed.Client(cluster.address) as client:
        client.wait_for_workers(4)
        disturb = Disturbance(cluster, client)
        cases = sweep.run(tmp_path / "disturbed", client=client, progress=disturb)
    assert disturb.done == ["worker", "scheduler"]
    assert cases.complete and files(whole.folder) == files(cases.folder)


def test_a_local_cluster(rotor: laval.Machine, tmp_path: Path) -> None:
    sweep = laval.Sweep(rotor, spread(500), MODES)
    seen = []
    cases = sweep.run(tmp_path / "cluster", workers=2, progress=seen.append)
    assert files(sweep.run(tmp_path / "here", client=False).folder) == files(cases.folder)
    assert seen[0].done == 0 and seen[-1].done == 500
    # all is there: nothing is computed again
    before = files(cases.folder)
    sweep.run(tmp_path / "cluster", workers=1)
    assert files(cases.folder) == before


def test_a_task_that_fails_is_an_error(rotor: laval.Machine, tmp_path: Path) -> None:
    cases = laval.Sweep(rotor, spread(40), MODES).prepare(tmp_path / "a")
    with distributed.Client(n_workers=1, threads_per_worker=1, dashboard_address=None) as client:
        # a folder that another process changes under the hands of this one
        (tmp_path / "a" / "cases.json").write_text(ROTOR)
        with pytest.raises(ValueError):
            cases.run(client, retries=0)
        moved = tmp_path / "b"
        os.rename(tmp_path / "a", moved)
        with pytest.raises(FileNotFoundError, match="all workers must see it"):
            cases.run(client, retries=0)
