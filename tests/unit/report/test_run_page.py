"""Report of a run: parameters, results, balances and selected outputs."""

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


def text_without_markup(text: str) -> str:
    body = re.sub(r"<(style|script|svg)\b.*?</\1>", " ", text, flags=re.DOTALL)
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", body)).split())


def test_page_is_self_contained_and_describes_the_run(text, recording):
    needs_nothing_else(text)
    visible_text = text_without_markup(text)
    assert "A <tank> is filled" in visible_text
    assert recording.outcome in visible_text
    assert "rosenbrock" in visible_text
    assert f"{recording.statistics['accepted_steps']:.0f} accepted" in visible_text


def test_plot_contains_the_recorded_values(text, recording):
    (plot,) = plots(text)
    time, pressure = lines(plot)["pressure [bar, absolute]: tank"]
    assert np.allclose(time, recording.time, atol=1e-9)
    assert np.allclose(pressure, recording["tank.pressure"] / 1e5, atol=1e-4)
    assert text.count("<svg") == 2  # the run and the circuit


def test_parameters_have_sources_and_assumed_ones_come_first(text):
    visible_text = text_without_markup(text)
    for address, number in CIRCUIT.numbers().items():
        assert f"{address} {number.display()}" in visible_text
        assert number.source.note in visible_text
    assert visible_text.index("assumed (") < visible_text.index("given (")


def test_extreme_values_have_their_times(recording, text):
    highest = int(np.argmax(recording["tank.temperature"]))
    temperature, time = recording["tank.temperature"][highest] - 273.15, recording.time[highest]
    assert f"{temperature:.5g} {time:.5g}" in text_without_markup(text)


def test_violated_balance_is_marked(text, recording):
    assert all(balance.is_kept for balance in recording.residuals)
    visible_text = text_without_markup(text)
    assert all(balance.name in visible_text for balance in recording.residuals)
    violated = Recording(**(recording.fields() | {"residuals": (recording.residuals[0]._replace(error=1.0),)}))
    assert "NOT kept" in text_without_markup(run_page(CIRCUIT, violated))


def test_outputs_and_units_of_the_plot_can_be_selected(recording):
    (plot,) = plots(run_page(CIRCUIT, recording, select="tank.pressure", units=["kPa"]))
    assert list(lines(plot)) == ["pressure [kPa, absolute]: tank"]
    (plot_with_inner,) = plots(run_page(CIRCUIT, recording, inner=True))
    (plot_without_inner,) = plots(run_page(CIRCUIT, recording))
    assert len(plot_with_inner["panels"]) > len(plot_without_inner["panels"])


def test_run_without_samples_has_a_page_without_plots(recording):
    empty = Recording(**(recording.fields() | {"time": np.zeros(0), "values": np.zeros((len(recording), 0))}))
    assert plots(run_page(CIRCUIT, empty)) == []


def test_unsupported_suffix_is_refused(recording, tmp_path):
    with refused("files.suffix"):
        write_run(CIRCUIT, recording, tmp_path / "run.txt")
