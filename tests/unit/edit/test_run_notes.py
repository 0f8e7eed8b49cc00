"""Notes on the results of a run of the page: those of `Circuit.simulate`, found without machine code."""

from __future__ import annotations

import numpy as np
import pytest

from circuits_of_exports import EXAMPLES
from javascript import needs_node
from page_model import run_payloads
from poppet import Circuit, load, loads
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.edit.build import DURATION, build_payload, page_notes
from poppet.engine.kernel import KERNELS
from poppet.engine.problem import RawRun
from poppet.engine.solve import solve

SATURATED = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar"
[parts.tank]
kind = "chamber"
volume = "1 l"
initial_pressure = "5 bar"
[parts.valve]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3
[parts.regulator]
kind = "pid"
gain = "5 1/bar"
setpoint = "3 bar"
sample_time = "2 ms"
[connections]
"regulator.measurement" = "tank.pressure"
"valve.opening" = "regulator.command"
[run]
duration = "0.2 s"
output_step = "2 ms"
"""


def results_of(raw: RawRun) -> bytes:
    """Return the body that the page sends after a run."""
    return np.concatenate([[raw.stop], raw.extremes.ravel(), raw.time, raw.values.ravel()]).tobytes()


def cushioned() -> Circuit:
    return load(EXAMPLES / "cylinder_cushioned.toml")


CASES = {
    "end stop": (cushioned, "bodies.met_stop"),
    "saturated": (lambda: loads(SATURATED), "circuit.saturated"),
    "left range": (
        lambda: load(EXAMPLES / "regulator_parts.toml").with_values({"main.upper_stop.stiffness": 1e8}),
        "curves.left_domain",
    ),
    "stopped at once": (
        lambda: loads(SATURATED).with_values({"run.stop_when": "tank.pressure > 3 bar"}),
        "run.nothing_ran",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_notes_are_those_of_a_simulation(name):
    make, code = CASES[name]
    circuit = make()
    recording = circuit.simulate()
    assert code in {note.code for note in recording.remarks}
    results = results_of(solve(circuit.problem(circuit.run)))
    KERNELS.clear()
    assert page_notes(make(), results) == list(recording.notes)
    assert len(KERNELS) == 0, "the server compiles no machine code"


def test_a_default_duration_remains_a_note():
    circuit = loads(SATURATED.replace('duration = "0.2 s"', ""))
    completed = circuit.with_values({"run.duration": DURATION})
    *notes, last = page_notes(circuit, results_of(solve(completed.problem(completed.run))))
    assert notes == list(completed.simulate().notes)
    assert last == str(Note("edit.default_run", "run.duration", duration=DURATION))


@needs_node
@pytest.mark.parametrize("name", ["saturated", "left range", "stopped at once"])
def test_the_page_sends_what_the_notes_need(name, tmp_path):
    circuit = CASES[name][0]()
    ((ended, table),) = run_payloads([build_payload(circuit)], tmp_path)
    results = np.concatenate([[ended["stop"]], [*ended["extremes"].values()], table.ravel()]).tobytes()
    assert page_notes(circuit, results) == list(circuit.simulate().notes)


@pytest.mark.parametrize("change", [lambda b: b[:-8], lambda b: b + b"x", lambda b: b"", lambda b: b[:8]])
def test_results_of_a_wrong_length(change):
    circuit = loads(SATURATED)
    results = results_of(solve(circuit.problem(circuit.run)))
    with pytest.raises(InputError) as caught:
        page_notes(circuit, change(results))
    assert caught.value.code == "edit.no_request"


@pytest.mark.parametrize("stop", [np.nan, np.inf, -2.0, 0.0, 0.5])
def test_results_with_an_unknown_stop_condition(stop):
    circuit = loads(SATURATED)
    results = np.frombuffer(results_of(solve(circuit.problem(circuit.run)))).copy()
    results[0] = stop
    with pytest.raises(InputError) as caught:
        page_notes(circuit, results.tobytes())
    assert caught.value.code == "edit.no_request"
