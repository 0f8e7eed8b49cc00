"""Contours, profiles and searches of fits with one optimum and with two equivalent optima."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.identify import Result, TankTest, identify_tank
from poppet.identify.fit.contour import COLUMNS, LEVELS, ROWS
from poppet.report.identification.cost_figures import contour_figure, profile_figure, search_figure
from poppet.report.identification.identification_report import identification_page
from poppet.timeseries.plotting.figures import style
from refusals import refused
from result_keys import undocumented

CONDUCTANCE, NOISE = 1e-8, 500.0
LIMIT = LEVELS["95 %"]


def make_test(wall: float, direction: str, **arguments: Any) -> TankTest:
    is_charge = direction == "charge"
    tank = Chamber(volume="20 l", initial_pressure="1 bar" if is_charge else "7 bar", wall_conductance=wall)
    ports = ("supply", "tank") if is_charge else ("tank", "ambient")
    valve = Orifice(from_=ports[0], to=ports[1], sonic_conductance=CONDUCTANCE, critical_ratio=0.35)
    parts = {"tank": tank, "valve": valve} | ({"supply": Reservoir(pressure="7 bar")} if is_charge else {})
    run = Circuit(parts).simulate(30.0, 0.15)
    pressure = run["tank.pressure"] + np.random.default_rng(1).normal(0.0, NOISE, run.time.size)
    recording = {"time": run.time, "tank.pressure": {"values": pressure, "noise": NOISE}}
    supply = {"supply_pressure": "7 bar"} if is_charge else {}
    return TankTest(
        recordings={"a": recording},
        volume="20 l",
        ambient_temperature="20 degC",
        uncertainties=0,
        direction=direction,
        **supply,
        **arguments,
    )


@cache
def fit(wall: float, direction: str) -> Result:
    return identify_tank(make_test(wall, direction), contour=True, profile=["tank.wall_conductance"])


def test_contour_agrees_with_estimate_and_intervals() -> None:
    result = fit(6.0, "discharge")
    table, parameters = result.series["contour"], result.parameters
    assert table["rise"].shape == table["x"].shape == (ROWS, COLUMNS)
    row, column = np.unravel_index(np.argmin(table["rise"]), table["rise"].shape)
    c, wall = (parameters[name] for name in ("valve.sonic_conductance", "tank.wall_conductance"))
    assert table["x"][row, column] == pytest.approx(c.value, abs=0.02 * c.standard_error)
    assert table["y"][row] == pytest.approx(wall.value, abs=0.02 * wall.standard_error)
    assert np.min(table["rise"]) == pytest.approx(0.0, abs=1e-3)
    # Along the wall conductance, chi-square is the square of the deviation in standard errors.
    sigmas = (table["y"] - wall.value) / wall.standard_error
    assert table["rise"].min(axis=1) == pytest.approx(sigmas**2, rel=0.25, abs=0.05)
    (region,) = [note for note in result.remarks if note.code.startswith("finding.contour")]
    assert region.code == "finding.contour.one"
    assert region.facts["low"] < CONDUCTANCE < region.facts["high"]
    assert region.facts["wall_low"] < 6.0 < region.facts["wall_high"]


def test_adiabatic_charge_has_two_regions_that_differ_by_kappa() -> None:
    """The fit is equally good for an adiabatic tank with C and an isothermal one with 1.4 C, but not between."""
    result = fit(0.0, "charge")
    regions = [note.facts for note in result.remarks if note.code == "finding.contour.several"]
    assert [facts["place"] for facts in regions] == [1, 2]
    for facts, factor in zip(regions, (1.0, 1.4), strict=True):
        assert facts["low"] < 1.003 * factor * CONDUCTANCE
        assert facts["high"] > 0.997 * factor * CONDUCTANCE
        assert facts["high"] - facts["low"] < 0.02 * CONDUCTANCE
    assert regions[0]["wall_high"] < 0.01 * regions[1]["wall_low"]
    table = result.series["contour"]
    is_between = (table["y"] > 1.0) & (table["y"] < 300.0)
    assert is_between.sum() >= 4
    assert np.min(table["rise"][is_between]) > 10.0 * LIMIT


@pytest.mark.parametrize(("wall", "direction", "regions"), [(6.0, "discharge", 1), (0.0, "charge", 2)])
def test_figure_shows_all_regions(wall: float, direction: str, regions: int) -> None:
    pytest.importorskip("matplotlib")
    with style("test"):
        (axes,) = contour_figure(fit(wall, direction).series["contour"]).axes
    outlines = axes.collections[1]  # lines at the two levels
    assert len(outlines.get_paths()) == len(LEVELS)
    assert all(len(path.to_polygons(closed_only=False)) == regions for path in outlines.get_paths())
    assert {text.get_text() for text in axes.get_legend().get_texts()} >= {"68 %", "95 %", "the estimate"}


def test_contour_without_free_wall_conductance_is_rejected() -> None:
    with refused("fit.contour", "contour", wanted="wall_conductance"):
        identify_tank(make_test(6.0, "discharge", wall_conductance=6.0), contour=True)


# Profiles and searches --------------------------------------------------------------------------------------------


def test_profile_crosses_its_limit_at_the_ends_of_the_interval() -> None:
    result, name = fit(6.0, "discharge"), "tank.wall_conductance"
    curve, estimate = result.series[f"profile.{name}"], result.parameters[name]
    assert curve["limit"] == pytest.approx(3.841, abs=1e-3)
    assert np.interp([estimate.low, estimate.high], curve["x"], curve["rise"]) == pytest.approx(
        curve["limit"], rel=0.02
    )
    assert curve["x"][np.argmin(curve["rise"])] == pytest.approx(estimate.value, abs=0.05 * estimate.standard_error)
    is_near = np.abs(curve["x"] - estimate.value) < 2.0 * estimate.standard_error
    assert is_near.sum() >= 6
    sigmas = (curve["x"] - estimate.value)[is_near] / estimate.standard_error
    assert curve["rise"][is_near] == pytest.approx(sigmas**2, rel=0.15, abs=0.05)


def test_profile_of_two_equivalent_optima_is_high_between_them() -> None:
    curve = fit(0.0, "charge").series["profile.tank.wall_conductance"]
    assert len(curve["answers"]) >= 2
    assert np.interp(curve["answers"], curve["x"], curve["rise"]) == pytest.approx(0.0, abs=1.0)
    assert np.max(curve["rise"][(curve["x"] > 0.2) & (curve["x"] < 1e3)]) > curve["limit"]
    pytest.importorskip("matplotlib")
    with style("test"):
        (axes,) = profile_figure(curve, "wall").axes
    line = axes.get_lines()[-1]
    assert np.max(line.get_ydata()) == pytest.approx(np.max(curve["rise"][curve["x"] <= 100 * max(curve["answers"])]))
    assert "0" in [label.get_text() for label in axes.get_xticklabels()]


def test_result_lists_all_searches() -> None:
    result = fit(0.0, "charge")
    searches = result.conditions["searches"]
    assert {search["name"] for search in searches} >= {"given", "adiabatic", "isothermal"}
    assert min(search["cost"] for search in searches) == pytest.approx(result.optima[0]["cost"], rel=1e-3)
    ends = [search["end"]["valve.sonic_conductance"] / CONDUCTANCE for search in searches]
    assert [end for end in ends if not (abs(end - 1.0) < 0.01 or abs(end - 1.4) < 0.014)] == []
    pytest.importorskip("matplotlib")
    units = {"valve.sonic_conductance": "m^3/(s Pa)", "tank.wall_conductance": "W/K"}
    with style("test"):
        waterfall, paths = search_figure(searches, list(units.items())).axes
    rise = 2.0 * (np.sort([search["cost"] for search in searches]) - min(search["cost"] for search in searches))
    assert waterfall.get_lines()[1].get_ydata() == pytest.approx(rise)
    assert paths.get_lines()[-1].get_xdata() == pytest.approx(ends, rel=1e-6)  # in dm^3/(s bar), 1 where C is 1e-8
    page = identification_page(result)
    table = page[page.index("<h2>Searches") :]
    assert table[: table.index("</table>")].count("<tr>") == 1 + len(searches)
    answers = page[page.index("<h2>Equivalent optima") :]
    assert answers[: answers.index("</table>")].count("<tr>") == 1 + len(result.optima)
    assert " or " in page[page.index('class="summary') : page.index("</p>", page.index('class="summary'))]


# Thermal laws -----------------------------------------------------------------------------------------------------


def test_charge_does_not_distinguish_two_laws_that_differ_by_kappa() -> None:
    result = identify_tank(make_test(0.0, "charge", compare=["isothermal", "adiabatic"]))
    laws = result.comparison["thermal_laws"]
    assert undocumented(result) == []
    assert list(laws) == ["energy", "isothermal", "adiabatic"]
    c = {name: law["numbers"]["valve.sonic_conductance"]["value"] for name, law in laws.items()}
    assert c["adiabatic"] == pytest.approx(CONDUCTANCE, rel=0.005)
    assert c["isothermal"] / c["adiabatic"] == pytest.approx(1.4, rel=0.005)
    assert laws["isothermal"]["aicc"] == pytest.approx(laws["adiabatic"]["aicc"], abs=2.0)
    (note,) = [note for note in result.remarks if note.code.startswith("finding.laws")]
    assert note.code == "finding.laws.several"
    assert {"isothermal", "adiabatic"} <= set(note.facts["left"])
    pytest.importorskip("matplotlib")
    page = identification_page(result)
    table = page[page.index("<h2>Thermal laws") :]
    assert table[: table.index("</table>")].count("<tr>") == 4


def test_discharge_distinguishes_two_laws() -> None:
    result = identify_tank(make_test(6.0, "discharge", compare=["isothermal", "adiabatic"]))
    (note,) = [note for note in result.remarks if note.code.startswith("finding.laws")]
    assert (note.code, note.facts["left"]) == ("finding.laws.one", ("energy",))
    laws = result.comparison["thermal_laws"]
    assert laws["energy"]["aicc"] == pytest.approx(result.comparison["aicc"])
    assert min(laws["isothermal"]["aicc"], laws["adiabatic"]["aicc"]) > laws["energy"]["aicc"] + 100.0
    assert laws["energy"]["rms"] == {"a.tank.pressure": pytest.approx(result.residuals["a.tank.pressure"].rms)}


def test_unknown_law_is_rejected() -> None:
    with refused("fields.not_an_option", "compare", value="isotherm"):
        TankTest(recordings={"a": {}}, volume="20 l", compare=["isotherm"])
    assert TankTest(recordings={"a": {}}, volume="20 l", compare="isothermal").compare == ("isothermal",)
