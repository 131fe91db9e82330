"""Figures drawn by matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from laval import _series

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Drawn

    from laval._figures import Figure

_GREY = "0.6"
_TINTS = {0: "tab:green", 1: "tab:red", 2: "tab:blue", 3: "tab:pink"}


def draw(figure: Figure) -> Drawn:
    """The whole figure."""
    from matplotlib.figure import Figure as New

    data = figure.data
    panels = data["panels"]
    if not panels:
        raise ValueError("this figure has no axes, it is made of small drawings; use its SVG text")
    drawn = New(figsize=(7.5, 1.2 + 3.2 * len(panels)), layout="constrained")
    ratios = [panel["height"] for panel in panels]
    rows = drawn.subplots(len(panels), 1, sharex=True, squeeze=False, gridspec_kw={"height_ratios": ratios})[:, 0]
    drawn.suptitle(figure.title)
    for axes, panel in zip(rows, panels):
        for mark in panel["marks"]:
            _mark(axes, mark, figure, data["x"]["factor"], panel["y"]["factor"])
        _axis(axes, panel["y"], "y")
        names = dict(zip(*reversed(axes.get_legend_handles_labels())))
        if names:
            axes.legend(names.values(), names.keys(), fontsize="small")
        if data["equal"]:
            axes.set_aspect("equal", adjustable="datalim")
    if len(rows):
        _axis(rows[-1], data["x"], "x")
    return drawn


def _axis(axes: Axes, axis: dict[str, Any], which: str) -> None:
    text, scale, limits, ticks = (getattr(axes, f"set_{which}{what}") for what in ("label", "scale", "lim", "ticks"))
    text(_series.label(axis))
    if axis["knee"]:
        scale("symlog", linthresh=axis["knee"])
    elif axis["log"]:
        scale("log")
    if axis["range"]:
        limits(*axis["range"])
    if axis["names"]:
        ticks([at for at, _ in axis["names"]], [name for _, name in axis["names"]])
    elif axis["bare"]:
        ticks([])


def _colour(number: int | None) -> str:
    return _GREY if number is None else f"C{number % 10}"


def _mark(axes: Axes, mark: dict[str, Any], figure: Figure, fx: float, fy: float) -> None:
    tables = figure.tables
    kind = mark["mark"]
    if kind == "line":
        for s in _series.lines(mark, tables, fx, fy):
            axes.plot(s.x, s.y, color=_colour(s.colour), linestyle="--" if s.dashed else "-", label=s.name or None)
    elif kind == "points":
        size = 8.0 if mark["small"] else 30.0
        for s in _series.points(mark, tables, fx, fy):
            colour = _colour(s.colour)
            axes.scatter(s.x, s.y, s=size, edgecolors=colour, facecolors="none" if s.dashed else colour, label=s.name or None)
    elif kind == "rule":
        line = axes.axvline if mark["vertical"] else axes.axhline
        line(mark["at"] * (fx if mark["vertical"] else fy), color=_GREY, linewidth=1, label=mark["label"] or None)
    elif kind == "band":
        place = mark["place"]
        style: dict[str, Any] = {"alpha": 0.25, "label": mark["name"] or None, "color": _TINTS.get(mark["tint"], "tab:orange")}
        if place["along"] == "x":
            axes.axvspan(place["from"] * fx, place["to"] * fx, **style)
        elif place["along"] == "y":
            axes.axhspan(place["from"] * fy, place["to"] * fy, **style)
        elif place["along"] == "sideways":
            table = tables[place["table"]]
            axes.fill_betweenx(table[place["y"]] * fy, table[place["left"]] * fx, table[place["right"]] * fx, **style)
        else:
            table = tables[place["table"]]
            axes.fill_between(table[place["x"]] * fx, table[place["low"]] * fy, table[place["high"]] * fy, **style)
    elif kind == "heat":
        heat = _series.grid(mark, tables, fx, fy)
        mesh = axes.pcolormesh(heat.x, heat.y, heat.z, shading="nearest", cmap="RdBu_r" if heat.diverging else "viridis")
        bar = axes.figure.colorbar(mesh, ax=axes, label=heat.label)
        if heat.classes:
            bar.set_ticks(range(len(heat.classes)), labels=list(heat.classes))
    elif kind == "text":
        axes.text(mark["x"] * fx, mark["y"] * fy, mark["text"], ha="center", va="center")
