"""Models for the page of the editor: equal to the optimised kernel of a live page, bit for bit."""

from __future__ import annotations

import json
import random
from pathlib import Path

import numpy as np
import pytest

from circuits_of_exports import EXAMPLES, TEN, example
from javascript import needs_node
from page_model import run_payloads
from poppet import Chamber, CheckValve, Circuit, Orifice, ReliefValve, Reservoir, load, loads
from poppet.core.errors import InputError
from poppet.deploy.live.page_kernel import SHARED_STACK, run_in_node
from poppet.edit import build
from poppet.edit.build import build_payload, page_kernel
from poppet.engine.compiled import INTEGRATOR
from poppet.engine.kernel import KERNELS
from poppet.parts.part import Part

TANK = """
[parts.tank]
kind = "chamber"
volume = "2 l"
initial_pressure = "3 bar"
[parts.hole]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "2 dm^3/(s bar)"
critical_ratio = 0.3
[run]
duration = "1 s"
output_step = "20 ms"
"""
FIVE = ("regulator", "switched", "cylinder", "muscle joint", "32 chambers")


def header(payload: bytes) -> dict:
    assert payload[:8] == build.MARK
    return json.loads(payload[12 : 12 + int.from_bytes(payload[8:12], "little")])


def optimised(circuit: Circuit, folder: Path) -> tuple[dict, np.ndarray]:
    """Return outcome and outputs of the page kernel of a live page."""
    folder.mkdir()
    return run_in_node(circuit.problem(circuit.run), folder)


def assert_same_bits(circuit: Circuit, tmp_path_factory: pytest.TempPathFactory) -> None:
    """Compare a page of the editor with a live page: steps, times and all values."""
    expected, table = optimised(circuit, tmp_path_factory.mktemp("live") / "run")
    ((ended, columns),) = run_payloads([build_payload(circuit)], tmp_path_factory.mktemp("page"))
    assert [ended[name] for name in ("status", "accepted", "attempts", "rows")] == [
        expected[name] for name in ("status", "accepted", "attempts", "rows")
    ]
    assert np.array_equal(columns[0], circuit.run.grid())
    assert np.array_equal(columns[1:], table, equal_nan=True)


def random_circuit(seed: int) -> Circuit:
    """Return stores in a row with passages of random kinds between them, and some across; with random values."""
    chance = random.Random(seed)
    parts: dict[str, Part] = {"supply": Reservoir(pressure=f"{chance.uniform(4.0, 8.0)} bar")}
    stores = ["supply"]
    for k in range(chance.randint(1, 6)):
        law = {"thermal": "isothermal"} if chance.random() < 0.3 else {"wall_conductance": chance.uniform(0.0, 1.0)}
        parts[f"tank{k}"] = Chamber(volume=f"{chance.uniform(0.1, 3.0)} l", **law)
        stores.append(f"tank{k}")
    ends = [*zip(stores, [*stores[1:], "ambient"], strict=True)]
    ends += [tuple(chance.sample(stores, 2)) for _ in range(chance.randint(0, 3))]
    for k, (first, second) in enumerate(ends):
        size = {"sonic_conductance": chance.uniform(1e-9, 3e-8), "critical_ratio": chance.uniform(0.1, 0.5)}
        wired = {"from_": first, "to": second, **size}
        parts[f"passage{k}"] = chance.choice(
            [
                lambda wired=wired: Orifice(**wired),
                lambda wired=wired: CheckValve(cracking_pressure="0.2 bar", **wired),
                lambda wired=wired: ReliefValve(set_pressure="2 bar", **wired),
            ]
        )()
    return Circuit(parts).with_values({"run.duration": "2 s", "run.output_step": "10 ms"})


@needs_node
def test_the_staircase_has_the_bits_of_the_optimised_kernel(tmp_path_factory):
    assert_same_bits(TEN["staircase"](), tmp_path_factory)


@needs_node
@pytest.mark.parametrize("name", FIVE)
def test_the_page_computes_the_bits_of_the_optimised_kernel(name, tmp_path_factory):
    assert_same_bits(TEN[name](), tmp_path_factory)


@needs_node
def test_a_sequence_gives_the_same_bits(tmp_path_factory):
    assert_same_bits(example("two_cylinders", "2 s"), tmp_path_factory)


@needs_node
@pytest.mark.parametrize("seed", range(20))
def test_random_structures_give_the_same_bits(seed, tmp_path_factory):
    assert_same_bits(random_circuit(seed), tmp_path_factory)


def test_the_integrator_of_the_page_is_made_from_the_present_source():
    module = Path(build.__file__).with_name("www") / "integrator.wasm"
    mark = f"mark{INTEGRATOR.mark()}, stack {SHARED_STACK}".encode()
    assert module.read_bytes().endswith(mark), "run `make integrator` after a change of engine/integrator.py"


def test_a_known_structure_needs_no_module_and_compiles_nothing():
    circuit = loads(TANK)
    KERNELS.clear()
    first = header(build_payload(circuit))
    changed = loads(TANK.replace("2 l", "3 l"))
    kernel = page_kernel(changed)
    assert kernel is page_kernel(circuit)
    assert len(KERNELS) == 0, "kernels without machine code are kept apart"
    second = header(build_payload(changed, first["key"]))
    assert second["key"] == first["key"]
    assert "module" not in second["blobs"]
    assert "module" in first["blobs"]
    assert "module" in header(build_payload(changed, "another"))["blobs"]
    assert changed.simulate().time.size == 51


def test_the_header_names_columns_and_free_numbers():
    circuit = loads(TANK)
    content = header(build_payload(circuit))
    recording = circuit.simulate()
    assert [column["name"] for column in content["columns"]] == [name for name, _ in circuit.model.outputs]
    assert set(recording.names) >= {column["name"] for column in content["columns"]}
    numbers = content["numbers"]
    assert numbers["tank.volume"]["value"] == 2e-3
    assert list(circuit.parameters)[numbers["hole.critical_ratio"]["place"]] == "hole.critical_ratio"
    assert (content["duration"], content["output_step"]) == (1.0, 0.02)


@pytest.mark.parametrize(
    ("name", "fixed"),
    [
        ("cylinder_cushioned", {"cylinder.bore", "cylinder.rod_diameter"}),
        ("pressure_regulator", {"controller.sampling_time"}),
    ],
)
def test_numbers_that_others_depend_on_are_left_to_the_server(name, fixed):
    circuit = load(EXAMPLES / f"{name}.toml")
    numbers = header(build_payload(circuit))["numbers"]
    assert not fixed & numbers.keys()
    assert len(numbers) > 10


@needs_node
@pytest.mark.parametrize(
    ("name", "address", "value"),
    [
        ("fill_staircase", "tank.volume", 0.15),
        ("cylinder_meter_out", "supply.pressure", 5e5),
        ("pressure_regulator", "tank.volume", 3e-3),
    ],
)
def test_a_changed_number_is_the_run_of_the_changed_circuit(name, address, value, tmp_path_factory):
    circuit = example(name, "1 s")
    changed = circuit.with_values({address: value})
    ((_, expected),) = run_payloads([build_payload(changed)], tmp_path_factory.mktemp("changed"))
    runs = [{"numbers": [[address, value]]}, {}]
    (_, columns), (_, former) = run_payloads([build_payload(circuit)], tmp_path_factory.mktemp("page"), runs)
    assert np.array_equal(columns, expected, equal_nan=True)
    assert not np.array_equal(columns, former, equal_nan=True)


@needs_node
def test_a_short_run_has_the_first_rows(tmp_path):
    payload = build_payload(example("fill_staircase", "60 s"))
    (ended, short), (_, full) = run_payloads([payload], tmp_path, [{"until": 11.03}, {}])
    assert ended["status"] == "done"
    assert short[0, -1] <= 11.03 < full[0, short.shape[1]]
    assert np.array_equal(short[0], full[0, : short.shape[1]])
    # The last step ends at the end of the run.
    assert np.allclose(short, full[:, : short.shape[1]], rtol=1e-3, atol=1e-9)


@needs_node
def test_a_payload_without_module_continues_the_former_model(tmp_path):
    first = build_payload(loads(TANK))
    longer = loads(TANK.replace('"1 s"', '"3 s"').replace("2 l", "3 l"))
    second = build_payload(longer, header(first)["key"])
    (one,), (other,) = (run_payloads(payloads, tmp_path) for payloads in ([first, second], [build_payload(longer)]))
    assert one[1].shape == (other[1].shape)
    assert np.array_equal(one[1], other[1])


@needs_node
def test_a_run_that_stops_ends_at_the_condition(tmp_path):
    circuit = loads(TANK + 'stop_when = "tank.pressure < 2 bar"\n')
    ((ended, columns),) = run_payloads([build_payload(circuit)], tmp_path)
    recording = circuit.simulate()
    assert ended["status"] == "stopped"
    assert np.allclose(columns[0], recording.time, rtol=1e-9)
    assert columns[1, -1] == pytest.approx(2e5, rel=1e-6)


def test_a_circuit_without_duration_is_simulated_with_a_note():
    content = header(build_payload(loads(TANK.replace('duration = "1 s"', ""))))
    assert content["duration"] == 2.0
    assert any("2 s" in note and "run.duration" in note for note in content["notes"])


def test_a_run_with_too_many_rows_is_refused_before_the_compilation():
    build.PAGE_KERNELS.clear()
    with pytest.raises(InputError, match=r"run\.output_step"):
        build_payload(loads(TANK.replace('"20 ms"', '"1 ps"')))
    assert len(build.PAGE_KERNELS) == 0


def test_a_long_run_has_fewer_rows_on_the_page(monkeypatch):
    monkeypatch.setattr(build, "MAX_VALUES", 100)
    circuit = loads(TANK)
    content = header(build_payload(circuit))
    assert content["lengths"]["n_rows"] * content["lengths"]["n_outputs"] <= 100
    assert content["duration"] == 1.0
    assert any("51 rows" in note for note in content["notes"])
