"""Figures: SVG, data, matplotlib, plotly."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import laval
from conftest import ROOT


@pytest.fixture(scope="module")
def results() -> laval.Results:
    rigid = laval.load(ROOT / "examples" / "02-rigid-rotor" / "machine.toml")
    heat = laval.studies.stability_map(
        speed=laval.span("100 rpm", "9000 rpm", points=12),
        parameter={"parameter": "losses.damping", **laval.span("1 N s/m", "80 N s/m", points=6)},
    )
    campbell = laval.studies.campbell(speed=laval.span("100 rpm", "9000 rpm", points=20))
    machine = rigid.with_(studies=[campbell, heat, laval.studies.nonlinear_response(speed=laval.span(25.0, 4000.0)), laval.studies.modes()])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", laval.MachineWarning)
        return machine.run()


def test_svg_and_data(results: laval.Results) -> None:
    assert results.figures
    for name, figure in results.figures.items():
        svg = figure.svg()
        assert svg.startswith("<svg") and figure._repr_svg_() == svg, name
        assert figure.title and figure.alt and figure.name in name
        for panel in figure.data["panels"]:
            for mark in panel["marks"]:
                if "table" in mark:
                    assert mark["x"] in figure.tables[mark["table"]], name
    kinds = {mark["mark"] for f in results.figures.values() for panel in f.data["panels"] for mark in panel["marks"]}
    assert {"line", "rule"} <= kinds
    some = next(iter(results.figures.values()))
    assert some.svg("ru") != some.svg()


def test_matplotlib(results: laval.Results, tmp_path: object) -> None:
    pytest.importorskip("matplotlib")
    for name, figure in results.figures.items():
        if not figure.data["panels"]:
            with pytest.raises(ValueError, match="SVG"):
                figure.matplotlib()
            continue
        drawn = figure.matplotlib()
        drawn.savefig(f"{tmp_path}/{name.replace('/', '-')}.png", dpi=40)
        assert len(drawn.axes) >= len(figure.data["panels"]), name


def test_plotly(results: laval.Results) -> None:
    pytest.importorskip("plotly")
    for name, figure in results.figures.items():
        if not figure.data["panels"]:
            with pytest.raises(ValueError, match="SVG"):
                figure.plotly()
            continue
        drawn = figure.plotly()
        assert drawn.to_json() and (drawn.data or drawn.layout.shapes), name


def test_curves_are_solid_where_both_ends_are() -> None:
    from laval._series import _joined, _pieces

    flags = np.array([True, True, False, True, True, True])
    begins = np.array([False, False, False, False, True, False])
    pieces = _pieces(flags, begins)
    assert pieces == [(0, 1, True), (1, 3, False), (4, 5, True)]
    x, _ = _joined(np.arange(6.0), np.zeros(6), pieces, True)
    assert np.array_equal(x, [0, 1, np.nan, 4, 5, np.nan], equal_nan=True)
