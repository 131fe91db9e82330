"""One study of many machines: computed by any number of processes, kept in a folder, read lazily."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from laval import _native
from laval._machine import Machine, loads
from laval._tables import Table

if TYPE_CHECKING:
    from collections.abc import Callable

    import distributed
    import numpy as np
    import pandas
    import polars
    import pyarrow.dataset

    from laval._blocks import Study
    from laval._engine import Extent
    from laval.designs import Design

FORMAT = 1
REQUEST = "cases.json"
LIST = "list.f64"


class Sweep:
    """One study of many machines.

    Args:
        machine: whose parameters vary.
        parameters: a design of :mod:`laval.designs`; a dictionary is a grid, a table or data frame is a list of cases.
        study: made by a function of :mod:`laval.studies`, or the name of a study of the machine.
        numbers: names and units of the numbers that get a column. Unless given: those that the study finds for the machine itself, the first case, one
            in the middle and the last. Other numbers stand in the column ``others``.
        chunk: cases in a file. It follows from the number of cases unless given.

    Raises:
        MachineError: what is wrong with the study or the parameters.
    """

    def __init__(
        self,
        machine: Machine,
        parameters: Design | Mapping[str, Any] | Any,
        study: Study | str,
        *,
        numbers: Mapping[str, str] | None = None,
        chunk: int | None = None,
    ) -> None:
        from laval import designs

        if isinstance(parameters, designs.Design):
            design = parameters
        elif isinstance(parameters, Mapping) and not isinstance(parameters, Table):
            design = designs.grid(parameters)
        else:
            design = designs.table(parameters)
        if isinstance(study, str):
            name = study
        else:
            machine = machine.with_(studies=[study])
            (name,) = machine.studies
        design._check({path: parameter.unit for path, parameter in machine.parameters.items()})
        self.machine = machine
        """The machine, with the study."""
        self.design = design
        """Which cases."""
        self.study = name
        """Name of the study."""
        self._numbers = None if numbers is None else [{"name": str(key), "unit": str(unit)} for key, unit in numbers.items()]
        if design.cases < 1 or not design.parameters:
            raise ValueError("the design has no case")
        if chunk is not None and (isinstance(chunk, bool) or not isinstance(chunk, int) or chunk < 1):
            raise ValueError(f"a file holds a whole number of cases from 1 on, not {chunk!r}")
        self._chunk = chunk
        # mistakes are reported before anything is written; of a list, its parameters are enough
        request = self._request(chunk)
        if design._values is not None:
            request["design"] = {"kind": "grid", "axes": [[path, [0.0]] for path in design.parameters]}
        _native.Cases(machine._core, json.dumps(request), None)

    def _request(self, chunk: int | None) -> dict[str, Any]:
        written = self.design._data if chunk is None else self.design._written(chunk)
        return {"study": self.study, "design": written, "chunk": chunk}

    def prepare(self, folder: str | os.PathLike[str]) -> Cases:
        """Writes the request into a folder, where any process finds it, and computes nothing but which numbers get a column.

        Raises:
            ValueError: the folder holds other cases.
        """
        path = Path(folder)
        path.mkdir(parents=True, exist_ok=True)
        chunk = self._chunk or _native.chunk_of(self.design.cases)
        whole = {"format": FORMAT, "machine": self.machine.text, "origin": self.machine._core.origin, **self._request(chunk)}
        file = path / REQUEST
        if file.exists():
            there = json.loads(file.read_text(encoding="utf-8"))
            different = [key for key in whole if there.get(key) != whole[key]]
            if self._numbers is not None and there.get("numbers") != self._numbers:
                different.append("numbers")
            if different:
                raise ValueError(f"{folder} holds other cases: {', '.join(different)} differ; name another folder")
            return Cases(path)
        if self.design._values is not None:
            _native.put(str(path / LIST), self.design._values.tobytes())
        numbers = self._numbers
        if numbers is None:
            found = _native.Cases(loads(whole["machine"], whole["origin"])._core, _request_of(whole), str(path)).numbers()
            numbers = [{"name": name, "unit": unit} for name, unit in found]
        text = json.dumps({**whole, "numbers": numbers}, indent=1, ensure_ascii=False) + "\n"
        _native.put(str(file), text.encode())
        return Cases(path)

    def run(
        self,
        folder: str | os.PathLike[str],
        client: distributed.Client | Literal[False] | None = None,
        *,
        workers: int | None = None,
        retries: int = 3,
        progress: bool | Callable[[Extent], Any] = False,
    ) -> Cases:
        """Computes the cases that the folder does not hold yet. The arguments are those of :meth:`laval.Cases.run`."""
        return self.prepare(folder).run(client, workers=workers, retries=retries, progress=progress)

    def __repr__(self) -> str:
        return f"<laval.Sweep of {self.machine.name!r}: {self.study!r} for {self.design.cases} cases over {', '.join(self.design.parameters)}>"


def _request_of(whole: Mapping[str, Any]) -> str:
    return json.dumps({key: whole[key] for key in ("study", "design", "chunk", "numbers") if key in whole})


class Cases:
    """The cases in a folder, made by :class:`laval.Sweep`: computed here or anywhere, read chunk by chunk.

    The files under ``cases`` are one data set of Parquet. Each is written under another name, flushed to the disk and renamed; it depends neither on
    who computed it, nor when, nor how often.

    Args:
        folder: in which :meth:`laval.Sweep.prepare` or :meth:`laval.Sweep.run` has written.

    Raises:
        OSError: there are no cases in the folder.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = Path(folder)
        """The folder."""
        content = (self.folder / REQUEST).read_bytes()
        whole = json.loads(content)
        if whole.get("format") != FORMAT:
            raise ValueError(f"{self.folder / REQUEST} is of format {whole.get('format')}; this version reads {FORMAT}")
        self.machine = loads(whole["machine"], whole["origin"])
        """The machine whose parameters vary."""
        self.study: str = whole["study"]
        """Name of the study."""
        self._mark = hashlib.sha256(content).hexdigest()
        self._core = _native.Cases(self.machine._core, _request_of(whole), str(self.folder))

    # what is there

    @property
    def rows(self) -> int:
        """Number of cases requested."""
        return self._core.rows

    @property
    def chunks(self) -> int:
        """Number of files requested."""
        return self._core.chunks

    @property
    def done(self) -> int:
        """Number of cases whose file is there."""
        present = self._core.present()
        size, last = self._core.chunk, self.rows - (self.chunks - 1) * self._core.chunk
        return sum(last if k == self.chunks - 1 else size for k, there in enumerate(present) if there)

    @property
    def complete(self) -> bool:
        """Whether all files are there."""
        return all(self._core.present())

    @cached_property
    def columns(self) -> tuple[str, ...]:
        """``case``, the parameters, the numbers found, ``others`` (further numbers as JSON), ``invalid`` (1 outside the validity of a model) and ``failure``."""
        return tuple(name for name, _, _ in self._core.columns)

    @cached_property
    def units(self) -> dict[str, str]:
        """SI units of the columns; empty for pure numbers and texts."""
        return {name: unit for name, unit, _ in self._core.columns}

    @property
    def files(self) -> list[str]:
        """The files that are there, in order."""
        return [os.fspath(self._core.file(k)) for k, there in enumerate(self._core.present()) if there]

    def batches(self, columns: Iterable[str] | None = None) -> Iterator[Table]:
        """The cases that are there, file by file: one is in memory at a time."""
        names = None if columns is None else list(columns)
        for k in range(self.chunks):
            found = self._core.read(k, names)
            if found is not None:
                yield Table(found)

    def __getitem__(self, column: str) -> np.ndarray[Any, Any]:
        """A column over all cases that are there."""
        import numpy as np

        if column not in self.columns:
            raise KeyError(f"no column {column!r}; there are {', '.join(self.columns)}")
        parts = [batch[column].copy() for batch in self.batches([column])]
        return np.concatenate(parts) if parts else np.empty(0)

    def stream(self, columns: Iterable[str] | None = None) -> Stream:
        """Some columns as a stream of Arrow, for polars, DuckDB and others: files are read while it is consumed."""
        return Stream(self._core, None if columns is None else list(columns))

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self.stream().__arrow_c_stream__(requested_schema)

    def __arrow_c_schema__(self) -> object:
        return self.stream().__arrow_c_schema__()

    def polars(self) -> polars.LazyFrame:
        """The files as a lazy frame of polars."""
        import polars

        return polars.scan_parquet(self.files)

    def pyarrow(self) -> pyarrow.dataset.Dataset:
        """The files as a data set of pyarrow."""
        import pyarrow.dataset

        return pyarrow.dataset.dataset(self.files, format="parquet")

    def pandas(self, columns: Iterable[str] | None = None) -> pandas.DataFrame:
        """Some columns as a data frame of pandas, in memory."""
        import pandas

        return pandas.DataFrame({name: self[name] for name in (self.columns if columns is None else columns)})

    def failures(self) -> dict[str, int]:
        """Why cases have no numbers: each reason, as it is written in the column ``failure``, and how often it occurs."""
        from collections import Counter

        found = Counter(reason for batch in self.batches(["failure"]) for reason in batch["failure"] if reason)
        return dict(found.most_common())

    # how it comes to be there

    def part(self, number: int, of: int, *, threads: int | None = None) -> None:
        """Computes part ``number`` (from 1) of ``of``: its files that are not there. Parts may run anywhere, in any order, more than once.

        Args:
            number: which part.
            of: how many parts there are; more than :attr:`chunks` would leave some without work.
            threads: all of the computer unless given.

        Raises:
            OSError: the folder cannot be written, or holds cases of another build or another kind of processor.
        """
        self._warn(self._core.run((number, of), threads, None))

    def collect(self) -> Cases:
        """Checks all files and writes down that they are complete.

        Raises:
            LookupError: cases are missing.
            BlockingIOError: parts are being computed.
        """
        notes, missing = self._core.collect()
        self._warn(notes)
        if missing is not None:
            raise LookupError(missing)
        return self

    def run(
        self,
        client: distributed.Client | Literal[False] | None = None,
        *,
        workers: int | None = None,
        retries: int = 3,
        progress: bool | Callable[[Extent], Any] = False,
    ) -> Cases:
        """Computes the missing cases, then :meth:`collect`.

        Args:
            client: of Dask; its workers must see the folder under the same path. ``None`` starts a cluster on this computer where Dask is installed, ``False``
                computes in this process, on all its threads.
            workers: processes of the cluster that is started; as many as the computer has processors unless given.
            retries: how often a part is repeated that failed, or whose worker or scheduler was lost.
            progress: ``True`` for a bar of tqdm, or a function of what is done, with rate and remaining time.
        """
        from laval._engine import run

        run(self, client, workers, retries, progress)
        return self

    @staticmethod
    def _warn(notes: Iterable[str]) -> None:
        import warnings

        from laval._errors import MachineWarning

        for note in notes:
            warnings.warn(note, MachineWarning, stacklevel=3)

    def __reduce__(self) -> tuple[Any, ...]:
        return Cases, (os.fspath(self.folder),)

    def __repr__(self) -> str:
        return f"<laval.Cases in {os.fspath(self.folder)!r}: {self.done} of {self.rows} cases; {', '.join(self.columns)}>"


class Stream:
    """Columns of cases as a stream of the Arrow C interface; each consumer begins anew."""

    def __init__(self, core: _native.Cases, columns: list[str] | None) -> None:
        self._core, self._columns = core, columns

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self._core.stream(self._columns)

    def __arrow_c_schema__(self) -> object:
        return self._core.schema(self._columns)
