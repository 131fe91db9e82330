"""A scheduler of Dask and its workers as processes, to be killed."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from typing import Any


def port() -> int:
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return int(s.getsockname()[1])


class Cluster:
    """A scheduler and workers, each a process of its own."""

    def __init__(self, workers: int) -> None:
        self.address = f"tcp://127.0.0.1:{port()}"
        self._count = workers
        self.workers: list[subprocess.Popen[bytes]] = []
        self.start()

    def start(self) -> None:
        """Starts the scheduler and the workers, for these end with their scheduler."""
        port = self.address.rsplit(":", 1)[1]
        self.scheduler = self._start("dask_scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard")
        one = ("dask_worker", self.address, "--nworkers", "1", "--nthreads", "1", "--no-dashboard")
        self.workers += [self._start(*one) for _ in range(self._count)]

    def _start(self, program: str, *arguments: str) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-m", f"distributed.cli.{program}", *arguments]
        return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)

    def close(self) -> None:
        for process in [*self.workers, self.scheduler]:
            if process.poll() is None:
                # the session that was started for it: a worker has a child
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()


class Disturbance:
    """Kills a worker after a fifth of the cases and the scheduler after the half; all is started again after a second."""

    def __init__(self, cluster: Cluster, client: Any) -> None:
        self.cluster, self.client = cluster, client
        self.done: list[str] = []

    def __call__(self, extent: Any) -> None:
        share = extent.done / extent.total
        if share > 0.2 and "worker" not in self.done:
            self.done.append("worker")
            # the process that computes; what guards it stays
            os.kill(next(iter(self.client.run(os.getpid).values())), signal.SIGKILL)
        elif share > 0.5 and "scheduler" not in self.done:
            self.done.append("scheduler")
            os.killpg(self.cluster.scheduler.pid, signal.SIGKILL)
            self.cluster.scheduler.wait()
            time.sleep(1.0)
            self.cluster.start()
