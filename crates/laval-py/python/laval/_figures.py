"""Figures of results: as SVG, as data, with matplotlib or plotly."""

from __future__ import annotations

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import matplotlib.figure
    import plotly.graph_objects

    from laval import _native
    from laval._results import StudyResults
    from laval._tables import Table


class Figure:
    """A figure: panels, one below the other, with marks over columns of the tables of its study."""

    def __init__(self, native: _native.Results, study: int, number: int, owner: StudyResults) -> None:
        self._core = native
        self._place = (study, number)
        self._owner = owner

    @cached_property
    def data(self) -> dict[str, Any]:
        """Axes, panels and marks. Columns are in SI units; an axis multiplies them by its ``factor``."""
        found: dict[str, Any] = json.loads(self._core.figure(*self._place, None))
        return found

    @property
    def tables(self) -> dict[str, Table]:
        """The tables that it draws from."""
        return self._owner.tables

    @property
    def name(self) -> str:
        """Name of the figure."""
        return str(self.data["name"])

    @property
    def title(self) -> str:
        """Title for reading."""
        return str(self.data["title"])

    @property
    def alt(self) -> str:
        """What a reader who cannot see it should know."""
        return str(self.data["alt"])

    def svg(self, language: str | None = None) -> str:
        """The figure as the report draws it."""
        return self._core.svg(*self._place, language)

    def matplotlib(self) -> matplotlib.figure.Figure:
        """The figure drawn by matplotlib."""
        from laval._matplotlib import draw

        return draw(self)

    def plotly(self) -> plotly.graph_objects.Figure:
        """The figure drawn by plotly."""
        from laval._plotly import draw

        return draw(self)

    def __repr__(self) -> str:
        return f"<laval.Figure {self.name!r}: {self.title}>"

    def _repr_svg_(self) -> str:
        return self.svg()
