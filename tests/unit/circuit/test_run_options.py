"""Ambient, gas and run: defaults with sources, output times, limits."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from poppet import library
from poppet.circuit.options import MOST_ROWS, Ambient, GasChoice, Run
from poppet.core.codes import Note
from poppet.core.errors import InputError, InputErrors, OutOfRangeError


def test_ambient_defaults_to_anr():
    numbers = Ambient().numbers()
    assert {name: float(number) for name, number in numbers.items()} == {"pressure": 1e5, "temperature": 293.15}
    assert {number.source.kind for number in numbers.values()} == {"standard"}


@pytest.mark.parametrize(
    ("fields", "code"),
    [
        ({"pressure": "0 bar g"}, "options.gauge_ambient"),
        ({"pressure": 0.0}, "fields.out_of_range"),
        ({"temperature": "-280 degC"}, "quantity.temperature_below_zero"),
    ],
)
def test_invalid_ambient_is_rejected(fields, code):
    with pytest.raises(InputError) as caught:
        Ambient(**fields)
    assert (caught.value.code, caught.value.address) == (code, next(iter(fields)))


class TestGas:
    def test_air_is_the_default_and_needs_no_note(self):
        gas = GasChoice()
        assert gas.values() == (287.05, 1.4, 1.0, 0.0)
        assert gas.notes() == ()

    @pytest.mark.parametrize("name", library.gas_names())
    def test_gases_of_the_library(self, name):
        gas, library_gas = GasChoice(name=name), library.gas(name)
        assert gas.values()[:2] == (float(library_gas.gas_constant), float(library_gas.isentropic_exponent))
        assert gas.numbers()["gas_constant"].source == library_gas.gas_constant.source

    def test_given_values_override_the_library(self):
        assert GasChoice(name="helium", isentropic_exponent=1.6).values()[1] == 1.6

    def test_other_name_selects_other_values(self):
        helium = dataclasses.replace(GasChoice(), name="helium")
        assert helium.values() == GasChoice(name="helium").values()
        assert dataclasses.replace(helium, name="argon").values() == GasChoice(name="argon").values()
        renamed = dataclasses.replace(GasChoice(name="helium", isentropic_exponent=1.6), name="argon")
        assert renamed.values()[1] == 1.6

    def test_meaning_of_conductances_gives_a_note(self):
        assert GasChoice(name="helium").notes() == (Note("options.conductances_as_given", "gas"),)
        (scaled,) = GasChoice(name="helium", conductances="from air").notes()
        assert (scaled.code, scaled.address) == ("options.conductances_from_air", "gas")
        assert GasChoice(conductances="from air").values()[2] == pytest.approx(1.0, rel=1e-15)

    @pytest.mark.parametrize(
        ("fields", "code"),
        [
            ({"name": "heliumm"}, "library.unknown"),
            ({"gas_constant": 0.0}, "fields.out_of_range"),
            ({"isentropic_exponent": 1.0}, "fields.out_of_range"),
            ({"conductances": "of air"}, "fields.not_an_option"),
        ],
    )
    def test_invalid_gases_are_rejected(self, fields, code):
        with pytest.raises(InputError) as caught:
            GasChoice(**fields)
        assert (caught.value.code, caught.value.address) == (code, next(iter(fields)))


class TestGrid:
    def test_output_times_are_rounded_decimals(self):
        assert Run(duration="120 s", output_step="0.1 s").grid().tolist() == [k / 10 for k in range(1201)]

    @pytest.mark.parametrize(
        ("duration", "step", "decimals"), [(30.0, 1e-4, 4), (1.0, 0.0025, 4), (0.3, 1e-3, 3), (7.0, 0.7, 1)]
    )
    def test_fine_output_times_are_rounded_decimals(self, duration, step, decimals):
        grid = Run(duration=duration, output_step=step).grid()
        assert grid.tolist() == [round(k * step, decimals) for k in range(grid.size)]

    def test_duration_is_the_last_output_time(self):
        assert Run(duration=1.0, output_step=0.3).grid().tolist() == [0.0, 0.3, 0.6, 0.9, 1.0]
        assert Run(duration=1.0, output_step=5.0).grid().tolist() == [0.0, 1.0]
        third = Run(duration=1.0, output_step=1.0 / 3.0).grid()
        assert (third.size, third[-1]) == (4, 1.0)

    def test_default_is_a_thousand_rows(self):
        grid = Run(duration="2 s").grid()
        assert (grid.size, grid[1], grid[-1]) == (1001, 0.002, 2.0)

    def test_strictly_increasing(self):
        for duration, step in ((1.0, 0.1), (math.pi, 0.01), (1e-6, 1e-9), (3600.0, 0.7), (0.3, 0.1)):
            grid = Run(duration=duration, output_step=step).grid()
            assert np.all(np.diff(grid) > 0.0)
            assert grid[-1] == duration

    def test_output_times_are_read_only(self):
        with pytest.raises(ValueError, match="read-only"):
            Run(duration=1.0).grid()[0] = 5.0

    def test_missing_duration(self):
        with pytest.raises(InputError) as caught:
            Run().grid()
        assert (caught.value.code, caught.value.address) == ("fields.missing", "run.duration")

    def test_too_many_rows_are_rejected(self):
        with pytest.raises(OutOfRangeError) as caught:
            Run(duration=1.0, output_step=0.5 / MOST_ROWS).grid()
        assert (caught.value.code, caught.value.facts["rows"]) == (
            "options.too_many_rows",
            pytest.approx(2 * MOST_ROWS),
        )


def test_changed_keeps_omitted_options():
    run = Run(duration="5 s", stop_when="tank.pressure > 5 bar", solver="lsoda")
    changed = run.changed(duration="2 s", output_step=None, relative_tolerance=1e-8)
    assert (float(changed.duration), changed.tolerance, changed.stop_texts, changed.solver) == (
        2.0,
        1e-8,
        ("tank.pressure > 5 bar",),
        "lsoda",
    )
    assert run.changed(duration=None, solver=None) is run
    assert run.changed(stop_when=["a.b > 1", "a.b < 0"], solver="radau").stop_texts == ("a.b > 1", "a.b < 0")


def test_longest_step():
    assert Run().longest_step == math.inf
    assert Run(maximum_step="10 ms").longest_step == 0.01


def test_all_errors_are_reported_together():
    with pytest.raises(InputErrors) as caught:
        Run(duration=-1.0, output_step="1 m", relative_tolerance=0.5, maximum_step=0.0, solver="rosenbrok")
    assert [problem.address for problem in caught.value.problems] == [
        "duration",
        "output_step",
        "relative_tolerance",
        "maximum_step",
        "solver",
    ]


@pytest.mark.parametrize("given", [5.0, ["a.b > 1", 3]])
def test_stop_conditions_are_texts(given):
    with pytest.raises(InputError) as caught:
        Run(stop_when=given)
    assert (caught.value.code, caught.value.address) == ("options.no_condition", "stop_when")


def test_values_that_override_a_named_gas_give_a_note():
    (note,) = GasChoice(name="nitrogen", gas_constant=287.05).notes()
    assert (note.code, note.address) == ("options.own_gas_numbers", "gas")
    assert (note.facts["numbers"], note.facts["name"]) == (("gas_constant",), "nitrogen")
    assert [note.code for note in GasChoice(name="nitrogen").notes()] == ["options.conductances_as_given"]
