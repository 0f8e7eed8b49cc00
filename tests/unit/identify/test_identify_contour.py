"""The misfit over conductance and wall heat: of one answer, and of a charge that has two."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.identify import Result, TankTest, identify_tank
from poppet.identify.fit.contour import COLUMNS, LEVELS, ROWS
from poppet.report.identification.landscape import contour_figure
from poppet.series.drawing.figures import style
from refusals import refused

CONDUCTANCE, NOISE = 1e-8, 500.0
LIMIT = LEVELS["95 %"]


def a_test(wall: float, direction: str, **more: Any) -> TankTest:
    is_charge = direction == "charge"
    tank = Chamber(volume="20 l", initial_pressure="1 bar" if is_charge else "7 bar", wall_conductance=wall)
    ports = ("supply", "tank") if is_charge else ("tank", "ambient")
    valve = Orifice(from_=ports[0], to=ports[1], sonic_conductance=CONDUCTANCE, critical_ratio=0.35)
    parts = {"tank": tank, "valve": valve} | ({"supply": Reservoir(pressure="7 bar")} if is_charge else {})
    run = Circuit(parts).simulate(30.0, 0.15)
    pressure = run["tank.pressure"] + np.random.default_rng(1).normal(0.0, NOISE, run.time.size)
    recording = {"time": run.time, "tank.pressure": {"values": pressure, "noise": NOISE}}
    supply = {"supply_pressure": "7 bar"} if is_charge else {}
    return TankTest(recordings={"a": recording}, volume="20 l", direction=direction, **supply, **more)


@cache
def found(wall: float, direction: str) -> Result:
    return identify_tank(a_test(wall, direction), contour=True)


def test_its_minimum_is_the_estimate_and_its_width_that_of_the_intervals() -> None:
    result = found(6.0, "discharge")
    table, parameters = result.series["contour"], result.parameters
    assert table["rise"].shape == table["x"].shape == (ROWS, COLUMNS)
    row, column = np.unravel_index(np.argmin(table["rise"]), table["rise"].shape)
    c, wall = (parameters[name] for name in ("valve.sonic_conductance", "tank.wall_conductance"))
    assert table["x"][row, column] == pytest.approx(c.value, abs=0.02 * c.standard_error)
    assert table["y"][row] == pytest.approx(wall.value, abs=0.02 * wall.standard_error)
    assert np.min(table["rise"]) == pytest.approx(0.0, abs=1e-3)
    # Along the wall heat the rise of the valley is the square of its sigmas.
    sigmas = (table["y"] - wall.value) / wall.standard_error
    assert table["rise"].min(axis=1) == pytest.approx(sigmas**2, rel=0.25, abs=0.05)
    (region,) = [note for note in result.remarks if note.code.startswith("finding.contour")]
    assert region.code == "finding.contour.one"
    assert region.facts["low"] < CONDUCTANCE < region.facts["high"]
    assert region.facts["wall_low"] < 6.0 < region.facts["wall_high"]


def test_a_charge_without_wall_heat_has_two_regions_that_differ_by_kappa() -> None:
    """Exact twins: adiabatic with C, isothermal with 1.4 C, and nothing between them."""
    result = found(0.0, "charge")
    regions = [note.facts for note in result.remarks if note.code == "finding.contour.several"]
    assert [facts["place"] for facts in regions] == [1, 2]
    for facts, factor in zip(regions, (1.0, 1.4), strict=True):
        assert facts["low"] < 1.003 * factor * CONDUCTANCE
        assert facts["high"] > 0.997 * factor * CONDUCTANCE
        assert facts["high"] - facts["low"] < 0.02 * CONDUCTANCE
    assert regions[0]["wall_high"] < 0.01 * regions[1]["wall_low"]
    table = result.series["contour"]
    between = (table["y"] > 1.0) & (table["y"] < 300.0)
    assert between.sum() >= 4
    assert np.min(table["rise"][between]) > 10.0 * LIMIT


@pytest.mark.parametrize(("wall", "direction", "regions"), [(6.0, "discharge", 1), (0.0, "charge", 2)])
def test_its_figure_shows_every_region(wall: float, direction: str, regions: int) -> None:
    pytest.importorskip("matplotlib")
    with style("a test"):
        (axes,) = contour_figure(found(wall, direction).series["contour"]).axes
    outlines = axes.collections[1]  # lines at the two levels
    assert len(outlines.get_paths()) == len(LEVELS)
    assert all(len(path.to_polygons(closed_only=False)) == regions for path in outlines.get_paths())
    assert {text.get_text() for text in axes.get_legend().get_texts()} >= {"68 %", "95 %", "the estimate"}


def test_without_a_free_wall_heat_it_is_refused() -> None:
    with refused("fit.contour", "contour", wanted="wall_conductance"):
        identify_tank(a_test(6.0, "discharge", wall_conductance=6.0), contour=True)
