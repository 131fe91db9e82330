"""Machines: read from files or built in Python, changed, run."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from laval import _changes, _native, _toml
from laval._errors import Diagnostic, Interrupted, MachineWarning, diagnostics
from laval._quantities import written
from laval._results import Results

if TYPE_CHECKING:
    from laval._blocks import Extra, Part, Study
    from laval._derivatives import Derivatives, Function, Mode, Peak
    from laval._progress import Progress
    from laval._quantities import Quantity


class Parameter(NamedTuple):
    """A number of a machine that may be varied."""

    value: float
    """In SI units."""
    unit: str
    """SI unit; empty for a pure number."""


class Machine:
    """A machine and its studies. It never changes; :meth:`with_` makes another one.

    Args:
        name: of the machine, for titles.
        speed: for studies that name none.
        axis: direction of the rotor axis; gravity acts across a horizontal one.
        drive: whether the spin speed is prescribed or free.
        parts: made by functions of :mod:`laval.parts`.
        studies: made by functions of :mod:`laval.studies`.
        blocks: made by functions of :mod:`laval.blocks`.

    Raises:
        MachineError: all mistakes, each at its place in the text of the machine (:attr:`source`).
    """

    __slots__ = ("_canonical", "_core", "_tree")

    _core: _native.Machine
    _canonical: str | None
    _tree: str | None

    def __init__(
        self,
        *,
        name: str | None = None,
        speed: Quantity | None = None,
        axis: Literal["vertical", "horizontal"] | None = None,
        drive: Literal["prescribed", "free"] | None = None,
        parts: Iterable[Part] = (),
        studies: Iterable[Study] = (),
        blocks: Iterable[Extra] = (),
    ) -> None:
        given = {"name": name, "speed": speed, "axis": axis, "drive": drive}
        tree: dict[str, Any] = {"machine": {key: written(value) for key, value in given.items() if value is not None}}
        _changes.add(tree, [*parts, *blocks, *studies])
        self._adopt(_native.read(_toml.document(tree).encode(), name or "machine"))

    def _adopt(self, native: _native.Machine) -> None:
        self._core = native
        self._canonical = self._tree = None

    @classmethod
    def _of(cls, content: bytes, origin: str) -> Machine:
        machine = cls.__new__(cls)
        machine._adopt(_native.read(content, origin))
        return machine

    @property
    def name(self) -> str:
        """Name for titles."""
        return self._core.name

    @property
    def speed(self) -> float | None:
        """Speed for studies that name none, rad/s."""
        return self._core.speed

    @property
    def source(self) -> str:
        """The machine as the text of a machine file, as it was given."""
        return self._core.source

    @property
    def text(self) -> str:
        """The machine as a file in canonical form: in the order of the registry, exact; what stands by default is left out."""
        if self._canonical is None:
            self._canonical = self._core.canonical()
        return self._canonical

    @property
    def values(self) -> dict[str, Any]:
        """All values in SI units, defaults filled in: lists ``part`` and ``study``, and the blocks beside them."""
        found: dict[str, Any] = json.loads(self._core.values())
        return found

    @property
    def parts(self) -> tuple[str, ...]:
        """Names of the parts."""
        return tuple(block["name"] for block in self.values["part"])

    @property
    def studies(self) -> dict[str, str]:
        """Names of the studies, and their kinds."""
        return dict(self._core.studies())

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates, such as ``drum.x``."""
        return tuple(self._core.coordinates()[0])

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the internal states of parts."""
        return tuple(self._core.coordinates()[1])

    @property
    def parameters(self) -> dict[str, Parameter]:
        """The numbers that may be varied, by path: ``bearing.stiffness.x``."""
        return {path: Parameter(value, unit) for path, unit, value in self._core.parameters()}

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        """Remarks on the machine that stop nothing."""
        return diagnostics(self._core.warnings())

    def with_(
        self,
        changes: Mapping[str, Any] | None = None,
        /,
        *,
        parts: Iterable[Part] = (),
        studies: Iterable[Study] | None = None,
        blocks: Iterable[Extra] = (),
    ) -> Machine:
        """The same machine with changes.

        Args:
            changes: values by path: ``{"bearing.stiffness": "2e7 N/m", "machine.speed": 300.0, "oil.fill.volume": "0.4 l"}``. The path begins with
                the name of a part or study, with ``machine``, or with the word of a block; ``None`` takes a key away.
            parts: added; one with the name of a part there is replaces it.
            studies: in place of those there are.
            blocks: added or replaced as parts are.

        Raises:
            KeyError: a path that begins with no name of this machine.
            MachineError: all mistakes of the changed machine.
        """
        if self._tree is None:
            self._tree = self._core.tree()
        tree = json.loads(self._tree)
        if studies is not None:
            tree["study"] = []
            _changes.add(tree, list(studies))
        _changes.add(tree, [*parts, *blocks])
        for path, value in (changes or {}).items():
            _changes.set_value(tree, path, None if value is None else written(value))
        return Machine._of(_toml.document(tree).encode(), self._core.origin)

    def run(
        self,
        *studies: Study,
        only: str | Iterable[str] = (),
        out: str | os.PathLike[str] | None = None,
        fresh: bool = False,
        work_limit: int | None = None,
        progress: Progress = None,
        interrupted: Literal["raise", "return"] = "raise",
    ) -> Results:
        """Runs studies, all of the machine unless some are given or named.

        Other threads of Python go on meanwhile. Ctrl-C stops the run at its next step.

        Args:
            studies: run instead of those of the machine.
            only: names or kinds of studies.
            out: folder for results. Long studies keep their rows there and go on from them when the same is run again.
            fresh: begin long studies anew.
            work_limit: end each study after this many steps.
            progress: ``True`` for a bar of tqdm, or a function of the name of the study, the steps done and all steps (0: unknown).
            interrupted: after Ctrl-C, ``"raise"`` :class:`Interrupted`, which holds the results so far, or ``"return"`` them.

        Raises:
            Interrupted: the run was stopped.
            ValueError: a study that the machine does not have.
        """
        from laval._progress import shown

        core = self.with_(studies=studies)._core if studies else self._core
        names = [only] if isinstance(only, str) else list(only)
        folder = None if out is None else os.fspath(out)
        with shown(progress) as follow:
            native, refusals, stopped = core.run(names, folder, fresh, work_limit, follow)
        results = Results(native)
        for refused in diagnostics(refusals):
            warnings.warn(str(refused), MachineWarning, stacklevel=2)
        for note in native.notes:
            warnings.warn(note, MachineWarning, stacklevel=2)
        if folder is not None:
            results.write(folder)
        if isinstance(stopped, KeyboardInterrupt):
            if interrupted == "return":
                return results
            raise Interrupted(results) from stopped
        if stopped is not None:
            raise stopped
        return results

    def derivatives(self, result: Mode | Peak, parameters: Iterable[str] | None = None) -> Derivatives:
        """A result and how it moves with parameters, exactly.

        Args:
            result: :class:`laval.Mode`, :class:`laval.Peak` or :class:`laval.Jump`.
            parameters: paths; all that may vary unless given, lateral pairs together.

        Raises:
            ValueError: the machine has no such result.
        """
        return result.evaluate(self, {}, None if parameters is None else list(parameters))

    def function(self, result: Mode | Peak, parameters: Sequence[str]) -> Function:
        """A result as a function of parameters, for ``scipy.optimize``: ``f(x)`` is its value and its exact gradient.

        >>> f = machine.function(laval.Mode(1), ["shaft.stiffness"])
        >>> scipy.optimize.minimize(f, f.x0, jac=True, bounds=f.bounds)
        """
        from laval._derivatives import Function

        return Function(self, result, parameters)

    def __reduce__(self) -> tuple[Any, ...]:
        return loads, (self.text, self._core.origin)

    def __copy__(self) -> Machine:
        return self

    def __deepcopy__(self, _: Any) -> Machine:
        return self

    def __eq__(self, other: object) -> bool:
        return self._core.values() == other._core.values() if isinstance(other, Machine) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._core.values())

    def __repr__(self) -> str:
        studies = ", ".join(self.studies) or "no studies"
        return f"<laval.Machine {self.name!r}: {', '.join(self.parts)}; {studies}>"


def load(file: str | os.PathLike[str]) -> Machine:
    """Reads a machine file.

    Raises:
        OSError: the file cannot be read.
        MachineError: all its mistakes, each at its place.
    """
    from pathlib import Path

    path = Path(file)
    # the folder and the name, which do not depend on where the folder lies
    origin = "/".join(part for part in path.parts[-2:] if part not in ("..", path.anchor))
    return Machine._of(path.read_bytes(), origin)


def loads(text: str, name: str = "machine") -> Machine:
    """Reads the text of a machine file; results refer to it by ``name``.

    Raises:
        MachineError: all its mistakes, each at its place.
    """
    return Machine._of(text.encode(), name)


def from_ross(rotor: Any, name: str | None = None) -> Machine:
    """Makes a machine of a rotor of the program ROSS 2 or 3.

    :attr:`Machine.source` is the machine file; what is not carried over stands at its top.

    Args:
        rotor: a ``ross.Rotor``, or the file in which ``rotor.save`` has written one.
        name: of the machine; that of the file unless given.

    Raises:
        OSError: the file cannot be read.
        MachineError: all that is wrong with the model.
    """
    from pathlib import Path
    from tempfile import TemporaryDirectory

    if hasattr(rotor, "save"):
        with TemporaryDirectory() as folder:
            path = Path(folder) / "rotor.json"
            rotor.save(path)
            content = path.read_bytes()
    else:
        path = Path(rotor)
        content = path.read_bytes()
    name = name or path.stem
    return loads(_native.from_ross(content, name), name)
