"""What a run found out: findings, tables, figures, verdict and checks."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, overload

from laval import _native
from laval._tables import Table

if TYPE_CHECKING:
    import os

    from laval._figures import Figure


class Value(NamedTuple):
    """A number with its unit."""

    value: float
    """In SI units; NaN where there is none."""
    unit: str
    """SI unit; empty for a pure number."""


class Evidence(NamedTuple):
    """A number that supports a finding."""

    what: str
    """What the number is."""
    value: float
    """In SI units."""
    unit: str
    """SI unit; empty for a pure number."""


class SpecialPoint(NamedTuple):
    """A fold, bifurcation, crossing or resonance on the path of a study."""

    kind: str
    subject: str
    """What it belongs to among others of its kind; empty when the kind says it."""
    at: float
    """Value of the parameter of the study, SI."""
    bracket: tuple[float, float]
    """Interval of the parameter that holds the point."""
    status: str
    """``located``, ``bracketed`` or ``doubtful``."""
    evidence: tuple[Evidence, ...]


class Check(NamedTuple):
    """A requirement of the first page, and how it is met."""

    name: str
    """Stable name, such as ``check-stability``."""
    verdict: str
    """``passed``, ``attention``, ``failed``, ``not_computed`` or ``no_limit``."""
    title: str
    """What is checked, in words."""
    result: str
    """What was found, in words."""
    required: str | None
    """The required value, in words."""
    margin: float | None
    """The margin as a share, where the check has one."""


class Finding:
    """One fact, with its numbers and what supports them."""

    __slots__ = ("_sentence", "evidence", "id", "message", "severity", "study", "subject", "unit", "value", "values")

    study: str
    """Name of the study."""
    id: str
    """Stable name, such as ``unstable_range``."""
    severity: str
    """``info``, ``warning``, or ``invalid`` for a result outside the validity of its model."""
    subject: str
    """What it speaks of among others of the same id: a body, a direction of whirl."""
    value: float | None
    """The number that stands for it where one number is wanted, in SI units."""
    unit: str
    """SI unit of that number."""
    values: dict[str, Any]
    """All values by name: :class:`Value` for numbers with units, int for counts, str for names."""
    evidence: tuple[Evidence, ...]
    """Residuals, brackets, differences from second methods."""
    message: str
    """Name of its sentence in the catalogues."""

    def __init__(self, study: str, data: Mapping[str, Any], sentence: Callable[[str | None], str]) -> None:
        self.study = study
        self.id = data["id"]
        self.severity = data["level"]
        self.subject = data["subject"]
        self.value = data["value"]
        self.unit = data["unit"]
        self.values = {name: _value(value) for name, value in data["args"].items()}
        self.evidence = _evidence(data["evidence"])
        self.message = data["message"]
        self._sentence = sentence

    @property
    def text(self) -> str:
        """The finding as sentences, in the language and the units of the machine file."""
        return self._sentence(None)

    def in_language(self, language: str) -> str:
        """The finding as sentences in another language: ``en``, ``ru``, ``kk`` or ``uz``."""
        return self._sentence(language)

    def __reduce__(self) -> tuple[Any, ...]:
        texts = {language: self._sentence(language) for language in (None, *_native.LANGUAGES)}
        state = {slot: getattr(self, slot) for slot in self.__slots__ if slot != "_sentence"}
        return _finding, (state, texts)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Finding):
            return NotImplemented
        return all(getattr(self, slot) == getattr(other, slot) for slot in self.__slots__ if slot != "_sentence")

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        mark = {"info": "", "warning": "! ", "invalid": "!! "}[self.severity]
        return f"<{mark}{self.id}: {self.text}>"


def _finding(state: dict[str, Any], texts: dict[str | None, str]) -> Finding:
    out = Finding.__new__(Finding)
    for slot, value in state.items():
        setattr(out, slot, value)
    out._sentence = texts.__getitem__
    return out


def _number(x: float | None) -> float:
    return math.nan if x is None else x


def _value(data: Any) -> Any:
    """An argument of a sentence."""
    if isinstance(data, list):
        return tuple(_value(entry) for entry in data)
    if "value" in data:
        return Value(_number(data["value"]), data["unit"])
    if "message" in data:
        return {"message": data["message"], **{name: _value(value) for name, value in data["args"].items()}}
    return next(iter(data.values()))


def _evidence(data: list[dict[str, Any]]) -> tuple[Evidence, ...]:
    return tuple(Evidence(entry["what"], _number(entry["value"]), entry["unit"]) for entry in data)


class StudyResults:
    """What one study found out."""

    def __init__(self, native: _native.Results, number: int, data: dict[str, Any]) -> None:
        self._core = native
        self._number = number
        self._data = data
        self.name: str = data["name"]
        """Its name."""
        self.kind: str = data["kind"]
        """The word of its kind."""
        self.end: str = data["end"]["kind"]
        """How it ended: ``reached``, ``cancelled``, ``refused``, ``work_limit``, ``max_points``, ``step_too_small``, ``newton_failed``, ``unbounded``."""
        self.work: dict[str, int] = data["work"]
        """Work counters: steps, factorisations."""

    @property
    def complete(self) -> bool:
        """Whether all that was requested is done. What is there is right in any case, as far as it goes."""
        return self.end == "reached"

    @property
    def end_text(self) -> str:
        """How it ended, as a sentence."""
        return self._core.ending(self._number, None)

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        """What was found out, most important first."""

        def sentence(k: int) -> Callable[[str | None], str]:
            return lambda language: self._core.sentence(self._number, k, language)

        return tuple(Finding(self.name, data, sentence(k)) for k, data in enumerate(self._data["findings"]))

    @cached_property
    def tables(self) -> dict[str, Table]:
        """The numbers, by name of the table."""
        return {data["name"]: Table(self._core.table(self._number, k)) for k, data in enumerate(self._data["tables"])}

    @cached_property
    def figures(self) -> dict[str, Figure]:
        """The pictures, by name."""
        from laval._figures import Figure

        return {data["name"]: Figure(self._core, self._number, k, self) for k, data in enumerate(self._data["figures"])}

    @cached_property
    def special_points(self) -> tuple[SpecialPoint, ...]:
        """Folds, bifurcations, crossings."""

        def one(p: dict[str, Any]) -> SpecialPoint:
            low, high = (_number(end) for end in p["bracket"])
            return SpecialPoint(p["kind"], p.get("subject", ""), _number(p["at"]), (low, high), p["status"], _evidence(p["evidence"]))

        return tuple(one(p) for p in self._data["special_points"])

    def __reduce__(self) -> tuple[Any, ...]:
        return _study_again, (Results(self._core), self._number)

    def __repr__(self) -> str:
        return f"<laval.StudyResults {self.name!r}: {len(self.findings)} findings, tables {', '.join(self.tables) or 'none'}>"


def _study_again(results: Results, number: int) -> StudyResults:
    return results[number]


def _again(text: str, origin: str, build: str, content: bytes) -> Results:
    return Results(_native.again(_native.read(text.encode(), origin), build, content))


class Results(Sequence[StudyResults]):
    """What a run found out: a sequence of the results of its studies, which are also found by name: ``results["modes"]``."""

    def __init__(self, native: _native.Results) -> None:
        self._core = native

    @cached_property
    def studies(self) -> tuple[StudyResults, ...]:
        """The studies that were run, in the order of the file."""
        data = json.loads(self._core.json(False))
        return tuple(StudyResults(self._core, k, study) for k, study in enumerate(data["studies"]))

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Findings of all studies."""
        return tuple(finding for study in self.studies for finding in study.findings)

    @property
    def tables(self) -> dict[str, Table]:
        """Tables of all studies, by ``study/table``."""
        return {f"{study.name}/{name}": table for study in self.studies for name, table in study.tables.items()}

    @property
    def figures(self) -> dict[str, Figure]:
        """Figures of all studies, by ``study/figure``."""
        return {f"{study.name}/{name}": figure for study in self.studies for name, figure in study.figures.items()}

    @property
    def complete(self) -> bool:
        """Whether every study did all that was requested."""
        return all(study.complete for study in self.studies)

    def overview(self, language: str | None = None) -> dict[str, Any]:
        """The first page as data: verdict, headline, checks and suggestions in words. It is computed when it is first needed; empty after a stop."""
        found: dict[str, Any] | None = json.loads(self._core.overview(language))
        return found or {}

    @property
    def verdict(self) -> str | None:
        """``passed``, ``attention``, ``failed``, ``not_computed`` or ``no_limit``; ``None`` after a stop."""
        return self.overview().get("verdict")

    @property
    def headline(self) -> str:
        """The answer in one or two sentences."""
        text: str = self.overview().get("headline", "")
        return text

    @property
    def checks(self) -> tuple[Check, ...]:
        """Requirements and how they are met."""
        entries = self.overview().get("checks", [])
        return tuple(Check(c["check"], c["verdict"], c["title"], c["result"], c["required"], c["margin"]) for c in entries)

    def data(self) -> dict[str, Any]:
        """The content of ``results.json``: all but the numbers of the tables, with the provenance."""
        found: dict[str, Any] = json.loads(self._core.json(True))
        return found

    def report_html(self, language: str | None = None) -> str:
        """The report as one page of HTML that opens offline."""
        return self._core.html(language)

    def summary(self, language: str | None = None, width: int = 80) -> str:
        """Verdict, checks and remarks as the terminal shows them."""
        return self._core.summary(language, width)

    def write(
        self, folder: str | os.PathLike[str], formats: Iterable[str] | None = None, language: str | None = None
    ) -> list[str]:
        """Writes the files of ``laval run`` into a folder and returns their paths.

        Args:
            folder: made where it is missing.
            formats: some of ``json``, ``csv``, ``parquet``, ``svg``, ``html``; all unless given.
            language: of the report and the figures.

        Raises:
            OSError: the folder cannot be written, or holds files of another program.
        """
        from os import fspath

        return [fspath(path) for path in self._core.write(fspath(folder), None if formats is None else list(formats), language)]

    @overload
    def __getitem__(self, study: str | int) -> StudyResults: ...
    @overload
    def __getitem__(self, study: slice) -> Sequence[StudyResults]: ...
    def __getitem__(self, study: str | int | slice) -> StudyResults | Sequence[StudyResults]:
        if not isinstance(study, str):
            return self.studies[study]
        for found in self.studies:
            if found.name == study:
                return found
        raise KeyError(f"no study {study!r} was run; there are {', '.join(s.name for s in self.studies)}")

    def __len__(self) -> int:
        return len(self.studies)

    def __iter__(self) -> Iterator[StudyResults]:
        return iter(self.studies)

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, self._core.kept()

    def __str__(self) -> str:
        return self.summary() or "\n".join(finding.text for finding in self.findings)

    def __repr__(self) -> str:
        return f"<laval.Results: {', '.join(study.name for study in self.studies)}>"

    def _repr_html_(self) -> str:
        """Page one of the report, for notebooks."""
        from html import escape

        page = escape(self._core.first_page(None), quote=True)
        # a frame of its own: neither style sheet changes the other page
        return f'<iframe srcdoc="{page}" style="width:100%;height:70em;border:0" sandbox="allow-scripts"></iframe>'
