"""Search in the catalogue: trials equal single runs, order and neighbours, rejected arguments."""

from __future__ import annotations

import math
import tomllib

import pytest

from poppet import loads
from poppet.ensemble import CatalogueSizing, size_from_catalogue
from poppet.library.components import components
from poppet.parts.component_search import value_of
from refusals import refused

FILL = """
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"
[parts.check]
kind = "check_valve"
from = "supply"
to = "tank"
SIZE
[parts.tank]
kind = "chamber"
volume = "100 l"
[run]
duration = "20 s"
output_step = "5 ms"
[ensemble.metrics]
fill = { of = "tank.pressure", metric = "time_to", value = "4 bar g", unit = "s" }
[requirements]
fast = "fill <= 4 s"
"""
OWN = 'sonic_conductance = "0.1 dm^3/(s bar)"\ncritical_ratio = 0.2\ncracking_pressure = "0.05 bar"'


@pytest.fixture(scope="module")
def sizing() -> CatalogueSizing:
    return size_from_catalogue(loads(FILL.replace("SIZE", OWN)), "check")


def test_trials_equal_runs_of_files_with_the_component(sizing: CatalogueSizing) -> None:
    assert len(sizing.trials) >= 3
    for trial in (sizing.trials[0], sizing.trials[-1]):
        size = f'model = "{trial.component.name}"\ncracking_pressure = "0.05 bar"'
        recording = loads(FILL.replace("SIZE", size)).simulate()
        pressure = recording["tank.pressure"]
        k = int((pressure >= 5e5).argmax())
        step = pressure[k] - pressure[k - 1]
        filled = recording.time[k] - (pressure[k] - 5e5) / step * (recording.time[k] - recording.time[k - 1])
        assert trial.metrics["fill"] == pytest.approx(filled, rel=1e-6)
        assert trial.margins["fast"] == pytest.approx(4.0 - filled, rel=1e-6)


def test_selected_component_and_its_neighbour(sizing: CatalogueSizing) -> None:
    sizes = [trial.size for trial in sizing.trials]
    assert sizes == sorted(sizes)
    stated = [value_of(c, "sonic_conductance") for c in components() if "check_valve" in c.kinds]
    assert sizes == sorted(size for size in stated if size is not None)
    selected, neighbour = sizing.selected, sizing.neighbour
    assert selected is not None
    assert selected.size == min(trial.size for trial in sizing.trials if trial.metrics["fill"] <= 4.0)
    assert selected.margins["fast"] >= 0.0
    assert neighbour is not None
    assert neighbour.size == max(size for size in sizes if size < selected.size)
    assert not neighbour.is_met
    assert neighbour.margins["fast"] < 0.0


def test_fields_of_the_circuit_that_components_state_are_reported(sizing: CatalogueSizing) -> None:
    has_cracking_pressure = any("cracking_pressure" in trial.component.fields for trial in sizing.trials)
    codes = {note.code: note for note in sizing.remarks}
    assert ("size.fields_of_circuit" in codes) == has_cracking_pressure


def test_conditions_and_largest_component() -> None:
    circuit = loads(FILL.replace("SIZE", OWN).replace("fill <= 4 s", "fill >= 2 s"))
    largest = size_from_catalogue(circuit, "check", largest=True)
    assert largest.selected is not None
    assert largest.selected.size == max(trial.size for trial in largest.trials if trial.metrics["fill"] >= 2.0)
    assert largest.neighbour is not None
    assert largest.neighbour.metrics["fill"] < 2.0
    limit = largest.selected.size * 1e8
    small = size_from_catalogue(circuit, "check", find=f"C < {limit:.6g} dm^3/(s bar)")
    assert {trial.component for trial in small.trials} < {trial.component for trial in largest.trials}


def test_no_component_meets_the_requirement() -> None:
    circuit = loads(FILL.replace("SIZE", OWN).replace("fill <= 4 s", "fill <= 1 ms"))
    none = size_from_catalogue(circuit, "check")
    assert not none.is_met
    (note,) = [note for note in none.remarks if note.code == "size.no_component_meets"]
    fastest = min(none.trials, key=lambda trial: trial.metrics["fill"])
    assert note.facts["best"] == fastest.component.name
    assert all(math.isfinite(trial.margins["fast"]) for trial in none.trials)


def test_the_closest_component_does_not_depend_on_the_units_of_the_metrics() -> None:
    text = FILL.replace("SIZE", OWN).replace("fill <= 4 s", "fill <= 1 ms")
    text = text.replace(
        "[requirements]", 'end = { of = "tank.pressure", metric = "final", unit = "Pa" }\n[requirements]'
    )
    none = size_from_catalogue(loads(text + 'filled = "end >= 9e5"\n'), "check")
    (note,) = [note for note in none.remarks if note.code == "size.no_component_meets"]
    fastest = min(
        none.trials, key=lambda trial: trial.metrics["fill"]
    )  # fails by 1000 times the bound, `filled` by 0.3
    assert note.facts["best"] == fastest.component.name


def test_no_component_is_the_closest_if_the_event_never_occurs() -> None:
    circuit = loads(FILL.replace("SIZE", OWN).replace('value = "4 bar g"', 'value = "8 bar g"'))
    none = size_from_catalogue(circuit, "check")
    (note,) = [note for note in none.remarks if note.code == "size.no_component_meets"]
    assert note.facts["best"] == ""
    assert "closest" not in str(note)


def test_component_file_of_the_circuit_is_searched(tmp_path) -> None:
    (tmp_path / "own.toml").write_text(
        'manufacturer = "Acme"\n[documents.d]\ntitle = "sheet"\n[components.X1]\nkinds = ["check_valve"]\n'
        'document = "d"\nfields = { sonic_conductance = "0.2 dm^3/(s bar)", critical_ratio = 0.3 }\n',
        encoding="utf-8",
    )
    text = 'components = ["own.toml"]\n' + FILL.replace("SIZE", OWN)
    sizing = size_from_catalogue(loads(text, folder=tmp_path), "check", find="Acme")
    assert [trial.component.name for trial in sizing.trials] == ["Acme X1"]


def test_components_with_different_delays_are_run_apart(tmp_path) -> None:
    components = "".join(
        f'[components.X{k}]\nkinds = ["directional_valve"]\ndocument = "d"\nfields = {{ sonic_conductance = '
        f'"{k} dm^3/(s bar)", critical_ratio = 0.3, delay = "{delay}" }}\n'
        for k, delay in ((20, "500 ms"), (30, "0 s"))
    )
    (tmp_path / "own.toml").write_text(f'manufacturer = "Acme"\n[documents.d]\ntitle = "sheet"\n{components}')
    text = FILL.replace('kind = "check_valve"', 'kind = "directional_valve"').replace(
        'from = "supply"', 'supply = "supply"'
    )
    text = text.replace('to = "tank"', 'outlet = "tank"')
    text += '[signals."check.command"]\nkind = "steps"\ntimes = ["0 s", "1 s"]\nvalues = [0, 1]\n'
    size = 'sonic_conductance = "1 dm^3/(s bar)"\ncritical_ratio = 0.3'
    circuit = loads('components = ["own.toml"]\n' + text.replace("SIZE", size), folder=tmp_path)
    sizing = size_from_catalogue(circuit, "check", find="Acme")
    for trial in sizing.trials:
        single = text.replace("SIZE", f'model = "{trial.component.name}"')
        recording = loads('components = ["own.toml"]\n' + single, folder=tmp_path).simulate()
        passed = recording.time[int((recording["tank.pressure"] >= 5e5).argmax())]
        assert trial.metrics["fill"] == pytest.approx(passed, abs=6e-3)  # the output step is 5 ms


def test_result_file(sizing: CatalogueSizing, tmp_path) -> None:
    sizing.save(tmp_path / "result.toml")
    written = tomllib.loads((tmp_path / "result.toml").read_text(encoding="utf-8"))
    assert sizing.selected is not None
    assert written["component"] == sizing.selected.component.name
    assert [trial["size"] for trial in written["trials"]] == [trial.size for trial in sizing.trials]


def test_rejected_arguments() -> None:
    circuit = loads(FILL.replace("SIZE", OWN))
    with refused("names.unknown", "chek"):
        size_from_catalogue(circuit, "chek")
    with refused("size.no_component", "supply"):
        size_from_catalogue(circuit, "supply")
    with refused("size.no_candidate", "check"):
        size_from_catalogue(circuit, "check", find="C > 900 dm^3/(s bar)")
    with refused("components.no_word"):
        size_from_catalogue(circuit, "check", find="nothing")
