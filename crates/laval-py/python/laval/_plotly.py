"""Figures drawn by plotly."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from laval import _series

if TYPE_CHECKING:
    import plotly.graph_objects as go

    from laval._figures import Figure

_GREY = "#999999"
_COLOURS = ["#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd", "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22", "#17becf"]
_TINTS = {0: "#2ca02c", 1: "#d62728", 2: "#1f77b4", 3: "#e377c2"}


def draw(figure: Figure) -> go.Figure:
    """The whole figure."""
    from plotly.subplots import make_subplots

    data = figure.data
    panels = data["panels"]
    if not panels:
        raise ValueError("this figure has no axes, it is made of small drawings; use its SVG text")
    heights = [panel["height"] for panel in panels]
    drawn = make_subplots(rows=len(panels), cols=1, shared_xaxes=True, row_heights=heights, vertical_spacing=0.06)
    seen: set[str] = set()
    for row, panel in enumerate(panels, 1):
        for mark in panel["marks"]:
            _mark(drawn, row, mark, figure, data["x"]["factor"], panel["y"]["factor"], seen)
        drawn.update_yaxes(**_axis(panel["y"]), row=row, col=1)
    drawn.update_xaxes(**{**_axis(data["x"]), "title": None})
    drawn.update_xaxes(title=_series.label(data["x"]), row=len(panels), col=1)
    if data["equal"]:
        drawn.update_yaxes(scaleanchor="x", scaleratio=1)
    drawn.update_layout(title=figure.title, template="plotly_white")
    return drawn


def _axis(axis: dict[str, Any]) -> dict[str, Any]:
    from math import log10

    out: dict[str, Any] = {"title": _series.label(axis)}
    if axis["log"]:
        out["type"] = "log"
    if axis["range"]:
        out["range"] = [log10(end) if axis["log"] else end for end in axis["range"]]
    if axis["names"]:
        out.update(tickvals=[at for at, _ in axis["names"]], ticktext=[name for _, name in axis["names"]])
    elif axis["bare"]:
        out["showticklabels"] = False
    return out


def _colour(number: int | None) -> str:
    return _GREY if number is None else _COLOURS[number % len(_COLOURS)]


def _mark(drawn: Any, row: int, mark: dict[str, Any], figure: Figure, fx: float, fy: float, seen: set[str]) -> None:
    tables = figure.tables
    kind = mark["mark"]

    def legend(name: str) -> dict[str, Any]:
        first = bool(name) and name not in seen
        seen.add(name)
        return {"name": name, "legendgroup": name, "showlegend": first}

    if kind == "line":
        for s in _series.lines(mark, tables, fx, fy):
            line = {"color": _colour(s.colour), "dash": "dash" if s.dashed else "solid"}
            drawn.add_scatter(x=s.x, y=s.y, mode="lines", line=line, row=row, col=1, **legend(s.name))
    elif kind == "points":
        for s in _series.points(mark, tables, fx, fy):
            marker = {"color": _colour(s.colour), "symbol": "circle-open" if s.dashed else "circle", "size": 4 if mark["small"] else 8}
            drawn.add_scatter(x=s.x, y=s.y, mode="markers", marker=marker, row=row, col=1, **legend(s.name))
    elif kind == "rule":
        style: dict[str, Any] = {"line": {"color": _GREY, "width": 1}, "annotation_text": mark["label"], "row": row, "col": 1}
        if mark["vertical"]:
            drawn.add_vline(x=mark["at"] * fx, **style)
        else:
            drawn.add_hline(y=mark["at"] * fy, **style)
    elif kind == "band":
        place = mark["place"]
        colour = _TINTS.get(mark["tint"], "#ff7f0e")
        style = {"fillcolor": colour, "opacity": 0.25, "line_width": 0, "row": row, "col": 1, "layer": "below"}
        if place["along"] == "x":
            drawn.add_vrect(x0=place["from"] * fx, x1=place["to"] * fx, **style)
        elif place["along"] == "y":
            drawn.add_hrect(y0=place["from"] * fy, y1=place["to"] * fy, **style)
        else:
            table, edge = tables[place["table"]], {"width": 0}
            if place["along"] == "sideways":
                y = table[place["y"]] * fy
                (x, low), (right, high) = (table[place["left"]] * fx, y), (table[place["right"]] * fx, y)
            else:
                x = right = table[place["x"]] * fx
                low, high = table[place["low"]] * fy, table[place["high"]] * fy
            drawn.add_scatter(x=x, y=low, mode="lines", line=edge, showlegend=False, row=row, col=1)
            fill: dict[str, Any] = {"fill": "tonexty", "fillcolor": colour, "opacity": 0.25}
            drawn.add_scatter(x=right, y=high, mode="lines", line=edge, row=row, col=1, **fill, **legend(mark["name"]))
    elif kind == "heat":
        heat = _series.grid(mark, tables, fx, fy)
        bar: dict[str, Any] = {"title": heat.label}
        if heat.classes:
            bar.update(tickvals=list(range(len(heat.classes))), ticktext=list(heat.classes))
        scale = {"colorscale": "RdBu_r", "zmid": 0} if heat.diverging else {"colorscale": "Viridis"}
        drawn.add_heatmap(x=heat.x, y=heat.y, z=heat.z, colorbar=bar, row=row, col=1, **scale)
    elif kind == "text":
        drawn.add_annotation(x=mark["x"] * fx, y=mark["y"] * fy, text=mark["text"], showarrow=False, row=row, col=1)
