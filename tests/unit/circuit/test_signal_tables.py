"""Signals of circuit files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet.circuit.signal_tables import KINDS, fields_of, read_signal
from poppet.core.errors import InputError, InputErrors
from poppet.parts.part import Input
from poppet.signals import Chirp, Constant, Points, Prbs, Pwm, SampledSignal, Sine, Square
from poppet.timeseries.recording import Recording
from refusals import refused

PRESSURE = Input("pilot_pressure", "Pa", 1e5, kind="pressure", low=0.0)
TEMPERATURE = Input("temperature", "K", 293.15, kind="temperature")
FLOW = Input("mass_flow_rate", "kg/s", 0.0, kind="mass_flow")
STROKE = Input("stroke", "m", 0.0)
OPENING = Input("opening", "1", 1.0, low=0.0, high=1.0)


def read(table: Any, item: Input = PRESSURE, folder: Path = Path()) -> Any:
    return read_signal(table, item, 0.95e5, folder)


def problems_of(table: Any, item: Input = PRESSURE, folder: Path = Path()) -> tuple[InputError, ...]:
    with pytest.raises(InputError) as caught:
        read(table, item, folder)
    return caught.value.problems


def test_constant_with_gauge_and_absolute():
    assert read({"kind": "constant", "value": "1 bar g"}) == Constant(1.95e5)
    assert read("2 bar") == Constant(2e5)
    assert read(2e5) == Constant(2e5)


def test_steps_mix_references():
    signal = read({"kind": "steps", "times": [0, "20 s", "1 min"], "values": ["1 bar g", "2 bar", 0.0]})
    assert signal.evaluate([0.0, 20.0, 60.0]).tolist() == [1.95e5, 2e5, 0.0]


def test_points():
    signal = read({"kind": "points", "times": ["0 s", "2 s"], "values": ["0 mm", "1 mm"]}, STROKE)
    assert signal.evaluate([1.0, 5.0]).tolist() == [0.5e-3, 1e-3]


def test_amplitudes_are_differences():
    table = {"kind": "sine", "mean": "3 bar g", "amplitude": "0.5 bar", "frequency": "2 Hz", "phase": "90 deg"}
    assert read(table) == Sine(3.95e5, 0.5e5, 2.0, np.pi / 2)
    (problem,) = problems_of(table | {"amplitude": "0.5 bar g"})
    assert (problem.code, problem.address) == ("quantity.gauge_difference", "amplitude")


def test_temperature_amplitude_is_in_kelvin():
    table = {"kind": "sine", "mean": "20 degC", "amplitude": "5 K", "frequency": 1.0}
    assert read(table, TEMPERATURE) == Sine(293.15, 5.0, 1.0)
    assert problems_of(table | {"amplitude": "5 degC"}, TEMPERATURE)


def test_chirp():
    table = {"kind": "chirp", "mean": 0.0, "amplitude": "1 mm", "frequency": "1 Hz", "end_frequency": "10 Hz"}
    assert read(table, STROKE) == Chirp(0.0, 1e-3, 1.0, 10.0)
    assert read(table | {"duration": "5 s"}, STROKE) == Chirp(0.0, 1e-3, 1.0, 10.0, 5.0)


def test_prbs():
    table = {"kind": "prbs", "low": "1 bar g", "high": "2 bar g", "bit_time": "100 ms", "seed": 7}
    assert read(table) == Prbs(1.95e5, 2.95e5, 0.1, 7)
    for seed in (1.5, True, "7", -1):
        assert problems_of(table | {"seed": seed})


def test_square():
    table = {"kind": "square", "low": "1 bar g", "high": "2 bar g", "frequency": "0.5 Hz"}
    assert read(table) == Square(1.95e5, 2.95e5, 0.5)
    assert read(table | {"duty": "30 %"}) == Square(1.95e5, 2.95e5, 0.5, 0.3)
    assert problems_of(table | {"high": "1 bar g"})[0].code == "signals.order"


def test_pwm_with_constant_and_variable_duty():
    table = {"kind": "pwm", "frequency": "0.1 kHz", "duty": 0.3}
    assert read(table, OPENING) == Pwm(100.0, 0.3)
    signal = read(table | {"duty": {"kind": "points", "times": ["0 s", "2 s"], "values": [0.0, "50 %"]}}, OPENING)
    assert isinstance(signal.duty, Points)
    assert signal.duty.evaluate([1.0, 3.0]).tolist() == [0.25, 0.5]
    assert read(table | {"low": "1 bar", "high": "2 bar"}) == Pwm(100.0, 0.3, 1e5, 2e5)


def test_pwm_without_levels_is_rejected():
    table = {"kind": "pwm", "frequency": "100 Hz", "duty": 0.3}
    errors = [(problem.code, problem.address) for problem in problems_of(table)]
    assert errors == [("fields.missing", "low"), ("fields.missing", "high")]
    assert problems_of(table | {"duty": 3}, OPENING)[0].code == "signals.duty"
    (problem,) = problems_of(table | {"duty": {"kind": "steps", "times": [0.0], "value": [0.1]}}, OPENING)
    assert (problem.code, problem.address) == ("fields.unknown", "duty.value")


def test_mass_flow_as_a_volume_at_its_reference():
    assert read("60 l/min ANR", FLOW).value == pytest.approx(1.185e-3)
    signal = read("60 l/min", FLOW)
    assert signal.value == pytest.approx(1.185e-3)
    assert [(note.code, note.facts["shown"]) for note in signal.remarks] == [("doubt.open_flow", "60 l/min")]
    steps = read({"kind": "steps", "times": [0, 1, 2], "values": ["1 slpm", "2 slpm", "3 l/min"]}, FLOW)
    assert [note.facts["shown"] for note in steps.remarks] == ["1 slpm", "3 l/min"]
    assert read("60 Nl/min", FLOW).remarks == ()


class TestFile:
    @pytest.fixture
    def folder(self, tmp_path):
        (tmp_path / "plain.csv").write_text(
            "time [s],p [bar],t,x [mm]\n0,1,20,0\n1,2,30,1\n2,1.5,25,2\n", encoding="utf-8"
        )
        (tmp_path / "ms.csv").write_text("t [ms],p\n0,1\n500,2\n", encoding="utf-8")
        (tmp_path / "early.csv").write_text("time [s],p [bar]\n-1,1\n1,2\n", encoding="utf-8")
        Recording.from_series([0.0, 1.0], {"p [Pa]": [1e5, 2e5]}).save(tmp_path / "p.parquet")
        return tmp_path

    def signal(self, folder: Path, item: Input = PRESSURE, **fields: Any) -> Any:
        return read({"kind": "file", "path": "plain.csv", "column": "p", **fields}, item, folder)

    def test_unit_of_the_heading(self, folder):
        signal = self.signal(folder)
        assert isinstance(signal, SampledSignal)
        assert signal.evaluate([0.0, 0.5, 2.0]).tolist() == [1e5, 1.5e5, 1.5e5]

    def test_gauge_unit_of_the_table(self, folder):
        assert self.signal(folder, unit="bar g").evaluate([0.0, 1.0]).tolist() == pytest.approx([1.95e5, 2.95e5])

    def test_column_without_a_unit(self, folder):
        with pytest.raises(InputError) as caught:
            self.signal(folder, TEMPERATURE, column="t")
        assert (caught.value.code, caught.value.facts["column"]) == ("inputs.no_unit", "t")
        assert self.signal(folder, TEMPERATURE, column="t", unit="degC").evaluate(0.0) == pytest.approx(293.15)

    def test_another_quantity(self, folder):
        with pytest.raises(InputError) as caught:
            self.signal(folder, column="x")
        assert caught.value.code == "quantity.other_quantity"

    @pytest.mark.parametrize("time", ["t", {"column": "t"}, {"column": "t", "unit": "ms"}])
    def test_time_column_of_another_name(self, folder, time):
        signal = self.signal(folder, path="ms.csv", unit="bar", time=time)
        assert signal.times.tolist() == [0.0, 0.5]

    def test_unit_of_the_time(self, folder):
        assert self.signal(folder, time={"unit": "min"}).times.tolist() == [0.0, 60.0, 120.0]

    def test_parquet(self, folder):
        assert self.signal(folder, path="p.parquet").evaluate([0.0, 1.0]).tolist() == [1e5, 2e5]
        with refused("files.time_is_fixed"):
            self.signal(folder, path="p.parquet", time="t")

    @pytest.mark.parametrize(
        ("fields", "code"),
        [
            ({"path": "none.csv"}, "files.unreadable"),
            ({"path": "none.xyz"}, "files.suffix"),
            ({"column": "q"}, "names.unknown"),
            ({"time": 3}, "inputs.no_column"),
            ({"time": {"colum": "t"}}, "inputs.no_column"),
            ({"time": "tm"}, "series.no_column"),
            ({"time": {"unit": "m"}}, "unit.other_quantity"),
            ({"path": "early.csv"}, "signals.before_run"),
            ({"unit": 5}, "quantity.unreadable_unit"),
        ],
    )
    def test_invalid_arguments_are_rejected(self, folder, fields, code):
        with pytest.raises(InputError) as caught:
            self.signal(folder, **fields)
        assert caught.value.code == code


@pytest.mark.parametrize("kind", KINDS)
def test_missing_and_unknown_fields_are_reported_together(kind):
    required, optional = fields_of(kind)
    problems = problems_of({"kind": kind, "qqq": "red", "zzz": 3})
    assert [problem.address for problem in problems] == [*required, "qqq", "zzz"]
    assert all(problem.hint for problem in problems)
    assert not set(required) & set(optional)


@pytest.mark.parametrize(
    ("table", "code", "address"),
    [
        ({"kind": "stps"}, "fields.not_an_option", "kind"),
        ({"times": [0.0]}, "inputs.no_kind", "kind"),
        ({"kind": "steps", "times": "0 s", "values": [1.0]}, "inputs.no_list", "times"),
        ({"kind": "steps", "times": [], "values": []}, "inputs.no_list", "times"),
        (
            {"kind": "steps", "times": [0.0, 2.0, 1.0], "values": [1.0, 1.0, 1.0]},
            "series.time.not_increasing",
            "times",
        ),
        ({"kind": "points", "times": [0.0, 1.0], "values": [1.0]}, "signals.lengths", "times"),
        ({"kind": "steps", "times": [1.0], "values": [1.0]}, "signals.no_first_step", "times"),
        ({"kind": "points", "times": [-1.0, 1.0], "values": [1.0, 2.0]}, "signals.before_run", "times"),
        ({"kind": "sine", "mean": 1.0, "amplitude": 1.0, "frequency": 0.0}, "numbers.not_positive", "frequency"),
        ({"kind": "prbs", "low": 2.0, "high": 1.0, "bit_time": 1.0, "seed": 1}, "signals.order", None),
        ({"kind": "constant", "value": float("nan")}, "quantity.not_finite", "value"),
        ({"kind": "constant", "value": "1 mm"}, "quantity.other_quantity", "value"),
        ({"kind": "constant", "value": [1.0]}, "quantity.not_a_number", "value"),
    ],
)
def test_invalid_arguments_are_rejected(table, code, address):
    with pytest.raises(InputError) as caught:
        read(table)
    assert (caught.value.code, caught.value.address) == (code, address)


def test_all_invalid_elements_of_a_list_are_reported():
    with pytest.raises(InputErrors) as caught:
        read({"kind": "steps", "times": ["0 s", "1 s", "2 s"], "values": ["1 mm", "1 bar", "x bar"]})
    assert [problem.address for problem in caught.value.problems] == ["values[0]", "values[2]"]
