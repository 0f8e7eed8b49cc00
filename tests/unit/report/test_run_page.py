"""The page of a run: what was simulated, with which numbers, what came out, and whether the balances hold."""

from __future__ import annotations

import html
import re

import numpy as np
import pytest

from pages import lines, needs_nothing_else, plots
from poppet import Chamber, Circuit, Orifice, Reservoir, Run
from poppet.report.run_report import run_page, write_run
from poppet.timeseries.recording import Recording
from refusals import refused

FILL = Orifice(from_="supply", to="tank", sonic_conductance="2 dm^3/(s bar)", critical_ratio=0.3)
CIRCUIT = Circuit(
    {"supply": Reservoir(pressure="7 bar"), "fill": FILL, "tank": Chamber(volume="10 l", wall_conductance="5 W/K")},
    run=Run(duration="20 s", output_step="0.1 s"),
    title="A <tank> is filled",
)


@pytest.fixture(scope="module")
def recording() -> Recording:
    return CIRCUIT.simulate()


@pytest.fixture(scope="module")
def text(recording) -> str:
    return run_page(CIRCUIT, recording)


def words(text: str) -> str:
    body = re.sub(r"<(style|script|svg)\b.*?</\1>", " ", text, flags=re.DOTALL)
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", body)).split())


def test_the_page_needs_nothing_and_says_what_was_run(text, recording):
    needs_nothing_else(text)
    found = words(text)
    assert "A <tank> is filled" in found
    assert recording.outcome in found
    assert "rosenbrock" in found
    assert f"{recording.statistics['accepted_steps']:.0f} accepted" in found


def test_the_plot_holds_the_recording(text, recording):
    (plot,) = plots(text)
    time, pressure = lines(plot)["pressure [bar, absolute]: tank"]
    assert np.allclose(time, recording.time, atol=1e-9)
    assert np.allclose(pressure, recording["tank.pressure"] / 1e5, atol=1e-4)
    assert text.count("<svg") == 2  # the run and the circuit


def test_every_number_stands_with_its_source_the_assumed_ones_first(text):
    found = words(text)
    for address, number in CIRCUIT.numbers().items():
        assert f"{address} {number.display()}" in found
        assert number.source.note in found
    assert found.index("assumed (") < found.index("given (")


def test_values_have_their_times(recording, text):
    highest = int(np.argmax(recording["tank.temperature"]))
    assert f"{recording['tank.temperature'][highest] - 273.15:.5g} {recording.time[highest]:.5g}" in words(text)


def test_balances_are_judged(text, recording):
    assert all(balance.is_kept for balance in recording.residuals)
    found = words(text)
    assert all(balance.name in found for balance in recording.residuals)
    broken = Recording(**(recording.fields() | {"residuals": (recording.residuals[0]._replace(error=1.0),)}))
    assert "NOT kept" in words(run_page(CIRCUIT, broken))


def test_what_is_drawn_can_be_chosen(recording):
    (plot,) = plots(run_page(CIRCUIT, recording, select="tank.pressure", units=["kPa"]))
    assert list(lines(plot)) == ["pressure [kPa, absolute]: tank"]
    (whole,) = plots(run_page(CIRCUIT, recording, inner=True))
    (first,) = plots(run_page(CIRCUIT, recording))
    assert len(whole["panels"]) > len(first["panels"])


def test_a_run_without_a_row_has_a_page(recording):
    empty = Recording(**(recording.fields() | {"time": np.zeros(0), "values": np.zeros((len(recording), 0))}))
    assert plots(run_page(CIRCUIT, empty)) == []


def test_another_suffix_is_refused(recording, tmp_path):
    with refused("files.suffix"):
        write_run(CIRCUIT, recording, tmp_path / "run.txt")
