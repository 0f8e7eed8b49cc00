"""Circuit files: the published contract, all fields, and all errors with their lines."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

from poppet import load, loads
from poppet.core.errors import InputError, InputErrors
from poppet.core.toml_file import TomlFile, read_text
from poppet.parts import KINDS
from poppet.parts.fields import specs
from poppet.signals import Chirp, Constant, Points, Prbs, SampledSignal, Sine, Steps

CONTRACT = """\
title = "VPPM-6L main stage fills a 0.2 m3 tank"

[parts.supply]
kind = "reservoir"
pressure = "7 bar"                # absolute; gauge is written "6 bar g" (or "bar(g)", "barg")
temperature = "20 degC"           # default

[parts.room]
kind = "reservoir"
pressure = "1 bar"

[parts.valve]
kind = "main_stage"
data = "varga2012"                # a set of the library; any field given here overrides it
mode = "paper"                    # or "regulator"
supply = "supply"
outlet = "tank"
exhaust = "room"

[parts.tank]
kind = "chamber"
volume = "0.2 m^3"
thermal = "energy"                # isothermal | polytropic | isentrope (the paper's) | energy
wall_conductance = "45 W/K"       # h A; 0 = adiabatic (default)
wall_temperature = "20 degC"      # of the wall; with wall_heat_capacity = "20 kJ/K" it becomes a state
initial_pressure = "1 bar"
initial_temperature = "20 degC"

[parts.bleed]                     # a plain ISO 6358 passage
kind = "orifice"
from = "tank"
to = "room"
sonic_conductance = "1.2e-8 m^3/(s Pa)"
critical_ratio = 0.3
subsonic_index = 0.5              # default
laminar_ratio = 0.999             # default; where the regularisation near equal pressure begins

[ambient]                         # optional; every gauge value, every plate open to the air and every open wall refers to it
pressure = "1 bar"                # default, ANR (ISO 8778)
temperature = "20 degC"

[gas]                             # optional; default is air
gas_constant = 287.05
isentropic_exponent = 1.4

[signals."valve.pilot_pressure"]  # inputs are addressed like numbers
kind = "steps"                    # constant | steps | points (piecewise linear) | sine | chirp | prbs | file
times = ["0 s", "20 s", "40 s"]
values = ["1 bar g", "2 bar g", "0 bar g"]

[run]
duration = "120 s"
output_step = "0.1 s"             # rows at 0, 0.1, ..., 120 s
relative_tolerance = 1e-6
"""  # noqa: E501 - as published

SMALL = """\
[parts.supply]
kind = "reservoir"
pressure = "7 bar"

[parts.fill]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = 1e-8
critical_ratio = 0.3

[parts.tank]
kind = "chamber"
volume = "10 l"

[run]
duration = "2 s"
"""


def line_of(text: str, piece: str) -> int:
    return next(number for number, line in enumerate(text.splitlines(), 1) if piece in line)


def problems_of(text: str, **options: Any) -> tuple[InputError, ...]:
    with pytest.raises(InputError) as caught:
        loads(text, name="circuit.toml", **options)
    return caught.value.problems


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    path = tmp_path_factory.mktemp("contract") / "circuit.toml"
    path.write_text(CONTRACT, encoding="utf-8")
    return load(path).simulate()


class TestContract:
    def test_run_is_complete_without_notes(self, recording):
        assert recording.ending.code == "run.done"
        assert recording.notes == ()
        assert recording.title == "VPPM-6L main stage fills a 0.2 m3 tank"

    def test_rows(self, recording):
        assert recording.time.tolist() == [k / 10 for k in range(1201)]

    def test_columns_are_parts_in_file_order_inputs_included(self, recording):
        order = [name.partition(".")[0] for name in recording.names]
        assert list(dict.fromkeys(order)) == ["supply", "room", "valve", "tank", "bleed"]
        assert {
            "valve.pilot_pressure",
            "valve.stroke",
            "valve.velocity",
            "valve.supply_mass_flow_rate",
            "valve.exhaust_mass_flow_rate",
            "tank.pressure",
            "tank.temperature",
            "tank.mass",
            "bleed.opening",
            "bleed.mass_flow_rate",
        } <= set(recording.names)

    def test_units_are_si(self, recording):
        assert [recording.unit(f"tank.{name}") for name in ("pressure", "temperature", "mass")] == ["Pa", "K", "kg"]
        assert recording.unit("valve.stroke") == "m"
        assert recording.unit("bleed.mass_flow_rate") == "kg/s"

    def test_inputs_are_absolute_and_a_row_on_a_jump_shows_the_value_after_it(self, recording):
        pilot = recording["valve.pilot_pressure"]
        assert pilot[[0, 199, 200, 399, 400, 1200]].tolist() == [2e5, 2e5, 3e5, 3e5, 1e5, 1e5]

    def test_the_plate_follows_the_static_map(self, recording):
        assert recording["valve.stroke"][150] == pytest.approx(0.138e-3, abs=0.6e-6)
        assert recording["valve.stroke"][350] == pytest.approx(0.310e-3, abs=0.6e-6)

    def test_csv_header(self, recording, tmp_path):
        head = recording.save(tmp_path / "out.csv").read_text(encoding="utf-8").splitlines()[0]
        assert head.startswith("time [s],supply.pressure [Pa],supply.temperature [K],room.pressure [Pa]")
        assert "tank.pressure [Pa],tank.temperature [K],tank.mass [kg]" in head


@pytest.mark.parametrize("written", ["6 bar g", "6 bar(g)", "6 barg", "6 bar gauge"])
def test_gauge_spellings(written):
    assert loads(SMALL.replace("7 bar", written)).parameters["supply.pressure"] == pytest.approx(7e5, rel=1e-14)


def test_gauge_refers_to_the_ambient():
    text = SMALL.replace("7 bar", "6 bar g") + '[ambient]\npressure = "950 mbar"\n'
    assert loads(text).parameters["supply.pressure"] == pytest.approx(6.95e5, rel=1e-14)


@pytest.mark.parametrize(
    "size",
    [
        'effective_area = "16 mm^2"',
        "flow_coefficient_kv = 0.3",
        "flow_coefficient_cv = 0.3",
        'nominal_flow = "380 l/min ANR"',
        'characteristic = "varga2012"',
        'characteristic = "varga2012.closed"',
        'characteristic = "varga2012.monotone"',
        'sonic_conductance = "1 dm^3/(s bar)"',
    ],
)
def test_sizes_of_an_orifice(size):
    text = SMALL.replace("sonic_conductance = 1e-8\ncritical_ratio = 0.3", size)
    signal = '[signals."fill.stroke"]\nkind = "constant"\nvalue = "0.5 mm"\n' if "characteristic" in size else ""
    assert loads(text + signal).simulate().last()["tank.pressure"] > 1.5e5


@pytest.mark.parametrize(
    ("fields", "address"),
    [
        ('thermal = "polytropic"\npolytropic_exponent = 1.04', "tank.polytropic_exponent"),
        ('thermal = "isothermal"', "tank.volume"),
        ('thermal = "isentrope"', "tank.volume"),
        (
            'wall_conductance = "4 W/K"\nwall_heat_capacity = "20 kJ/K"\n'
            'outer_conductance = "2 W/K"\nambient_temperature = "10 degC"',
            "tank.outer_conductance",
        ),
        (
            'heat_transfer = "natural"\nnusselt_prefactor = 0.14\nwall_area = "0.3 m^2"\nheight = "0.5 m"',
            "tank.nusselt_prefactor",
        ),
        (
            'heat_transfer = "woodfield"\nwall_area = "0.3 m^2"\nheight = "0.5 m"\ninlet_diameter = "8 mm"',
            "tank.inlet_diameter",
        ),
    ],
)
def test_fields_of_a_chamber(fields, address):
    circuit = loads(SMALL.replace('volume = "10 l"', f'volume = "10 l"\n{fields}'))
    assert address in circuit.parameters
    assert all(residual.is_kept for residual in circuit.simulate().residuals)


def test_flow_source():
    text = '[parts.meter]\nkind = "flow_source"\nto = "tank"\ntemperature = "30 degC"\n'
    text += '[parts.tank]\nkind = "chamber"\nvolume = "1 l"\n'
    text += '[signals."meter.mass_flow_rate"]\nkind = "constant"\nvalue = "60 l/min ANR"\n[run]\nduration = "1 s"\n'
    recording = loads(text).simulate()
    assert recording["tank.mass"][-1] - recording["tank.mass"][0] == pytest.approx(1.185e-3, rel=1e-9)


PRESSURE = '[signals."supply.pressure"]\n'


@pytest.mark.parametrize(
    ("table", "kind"),
    [
        ('kind = "constant"\nvalue = "3 bar g"', Constant),
        ('kind = "steps"\ntimes = ["0 s", "500 ms"]\nvalues = ["3 bar g", "5 bar"]', Steps),
        ('kind = "points"\ntimes = [0, 1]\nvalues = ["3 bar", "5 bar"]', Points),
        ('kind = "sine"\nmean = "5 bar"\namplitude = "0.5 bar"\nfrequency = "2 Hz"\nphase = "90 deg"', Sine),
        ('kind = "chirp"\nmean = "5 bar g"\namplitude = "0.5 bar"\nfrequency = "1 Hz"\nend_frequency = "5 Hz"', Chirp),
        ('kind = "prbs"\nlow = "3 bar g"\nhigh = "5 bar g"\nbit_time = "100 ms"\nseed = 3', Prbs),
    ],
)
def test_kinds_of_signals(table, kind):
    circuit = loads(f"{SMALL}{PRESSURE}{table}\n")
    assert type(circuit.signals["supply.pressure"]) is kind
    assert np.ptp(circuit.simulate()["supply.pressure"]) > 0.0 or kind is Constant


def test_signal_of_a_file(tmp_path):
    (tmp_path / "p.csv").write_text("t [ms],p [bar]\n0,3\n1000,5\n", encoding="utf-8")
    table = 'kind = "file"\npath = "p.csv"\ncolumn = "p"\nunit = "bar g"\ntime = { column = "t", unit = "ms" }\n'
    (tmp_path / "c.toml").write_text(f"{SMALL}{PRESSURE}{table}", encoding="utf-8")
    circuit = load(tmp_path / "c.toml")
    assert type(circuit.signals["supply.pressure"]) is SampledSignal
    assert circuit.signals["supply.pressure"].evaluate([0.0, 0.5, 1.0]).tolist() == pytest.approx([4e5, 5e5, 6e5])


def test_value_is_a_constant_signal_and_quotes_are_optional():
    text = f'{SMALL}[signals]\nfill.opening = 0.5\n"supply.pressure" = "5 bar g"\n'
    assert loads(text).simulate().last()["supply.pressure"] == 6e5
    nested = f'{SMALL}[signals.supply.pressure]\nkind = "constant"\nvalue = "5 bar"\n'
    assert loads(nested).simulate().last()["supply.pressure"] == 5e5


def test_numbers_can_have_a_source():
    text = SMALL.replace('"10 l"', '{ value = "10 l", source = "measured", locator = "bench 3" }')
    assert str(loads(text).numbers()["tank.volume"].source) == "measured: bench 3"


def test_gas_by_name():
    assert loads('gas = "helium"\n' + SMALL).parameters["gas.gas_constant"] == pytest.approx(2077.3, rel=1e-4)


def test_windows_line_ends_and_byte_order_mark(tmp_path):
    path = tmp_path / "c.toml"
    path.write_bytes(b"\xef\xbb\xbf" + SMALL.replace("\n", "\r\n").encode())
    assert list(load(path).parts) == ["supply", "fill", "tank"]


def test_all_kinds_have_a_summary_and_fields():
    for name, kind in KINDS.items():
        assert kind.kind == name
        assert kind.summary
        assert specs(kind)


def replaced(old: str, new: str) -> str:
    assert CONTRACT.count(old) == 1, old
    return CONTRACT.replace(old, new)


MISTAKES = [
    ("unknown kind", replaced('kind = "chamber"', 'kind = "chambr"'), "chambr", "Did you mean chamber"),
    ("misspelt field", replaced("volume = ", "volum = "), "volum =", "Did you mean volume"),
    ("missing unit", replaced('"0.2 m^3"', '"0.2"'), 'volume = "0.2"', 'Write "0.2 m^3"'),
    ("wrong unit", replaced('"0.2 m^3"', '"0.2 bar"'), "0.2 bar", "the value in the form"),
    ("unknown unit", replaced('"0.2 m^3"', '"0.2 furlong"'), "0.2 furlong", "Use SI units"),
    ("gauge where a difference is meant", replaced('"45 W/K"', '"45 bar g"'), "45 bar g", "the value in the form"),
    ("absolute below zero", replaced('pressure = "7 bar" ', 'pressure = "-2 bar" '), "-2 bar", 'with "g"'),
    ("gauge below vacuum", replaced('pressure = "7 bar" ', 'pressure = "-2 bar g" '), "-2 bar g", "Correct this"),
    (
        "gauge ambient",
        replaced('pressure = "1 bar"                # default', 'pressure = "1 bar g" #'),
        '1 bar g" #',
        "barometric",
    ),
    ("pilot below vacuum", replaced('"0 bar g"', '"-2 bar g"'), "[signals", "Correct the signal"),
    ("negative volume", replaced('"0.2 m^3"', '"-0.2 m^3"'), "-0.2 m^3", "Correct the value"),
    ("b = 1", replaced("critical_ratio = 0.3", "critical_ratio = 1.0"), "critical_ratio", "Correct the value"),
    ("b > 1", replaced("critical_ratio = 0.3", "critical_ratio = 1.2"), "critical_ratio", "Correct the value"),
    ("NaN", replaced("critical_ratio = 0.3", "critical_ratio = nan"), "critical_ratio", "Specify a finite value"),
    ("NaN with a unit", replaced('"0.2 m^3"', '"nan m^3"'), "nan m^3", "the value in the form"),
    ("infinite", replaced('"0.2 m^3"', "inf"), "volume = inf", "Specify a finite value"),
    ("boolean", replaced('"0.2 m^3"', "true"), "volume = true", "Write a number"),
    ("list", replaced('"0.2 m^3"', "[1]"), "volume = [1]", "Write a number"),
    ("decimal comma", replaced('"0.2 m^3"', '"0,2 m^3"'), "0,2 m^3", "decimal point"),
    ("unknown part", replaced('from = "tank"', 'from = "tonk"'), "tonk", "Did you mean tank"),
    ("joined with itself", replaced('to = "room"', 'to = "tank"'), "[parts.bleed]", "Connect two different"),
    ("joined to a passage", replaced('to = "room"', 'to = "valve"'), 'to = "valve"', "Insert a chamber"),
    (
        "part of no passage",
        CONTRACT + '[parts.spare]\nkind = "chamber"\nvolume = 1.0\n',
        "[parts.spare]",
        "Connect a flow path",
    ),
    ("two parts of one name", CONTRACT + '[parts.tank]\nkind = "chamber"\n', None, "Rename or remove"),
    (
        "field twice",
        replaced('thermal = "energy" ', 'volume = "1 l"\nthermal = "energy" '),
        'volume = "1 l"',
        "Remove one",
    ),
    ("no kind", replaced('kind = "chamber"\n', ""), "[parts.tank]", "Use one of: reservoir"),
    ("no volume", replaced('volume = "0.2 m^3"\n', ""), "[parts.tank]", "Specify the value in m"),
    ("unknown set", replaced('data = "varga2012" ', 'data = "varga2021" '), "varga2021", "Did you mean varga2012"),
    ("unknown mode", replaced('mode = "paper" ', 'mode = "papr" '), "papr", "Did you mean paper"),
    (
        "unknown input",
        CONTRACT.replace("valve.pilot_pressure", "valve.pilot"),
        "valve.pilot",
        "Did you mean valve.pilot_pressure",
    ),
    ("unknown kind of signal", replaced('kind = "steps" ', 'kind = "stps" '), "stps", "Did you mean steps"),
    ("field of another signal", replaced("times = [", "tims = ["), "tims", "times"),
    ("times not increasing", replaced('"20 s", "40 s"', '"40 s", "20 s"'), "times =", "keep only one sample"),
    ("times twice", replaced('"20 s", "40 s"', '"20 s", "20 s"'), "times =", "keep only one sample"),
    ("times not from zero", replaced('"0 s", "20 s"', '"1 s", "20 s"'), "times =", "Add a step at time 0"),
    ("times and values", replaced('"0 s", "20 s", "40 s"', '"0 s", "20 s"'), "times =", "one value for each time"),
    ("unit of a value", replaced('"0 bar g"', '"0 mm"'), "values =", "the value in the form"),
    ("times are no list", replaced('["0 s", "20 s", "40 s"]', '"0 s"'), "times =", "Write, for example, ["),
    (
        "polytropic without exponent",
        replaced('thermal = "energy" ', 'thermal = "polytropic" '),
        "[parts.tank]",
        "polytropic_exponent = 1.04",
    ),
    ("duration", replaced('"120 s"', '"-120 s"'), "-120 s", "Correct the value"),
    ("unit of the duration", replaced('"120 s"', '"120 m"'), "120 m", "the value in the form"),
    (
        "tolerance",
        replaced("relative_tolerance = 1e-6", "relative_tolerance = 0"),
        "relative_tolerance",
        "Correct the value",
    ),
    ("unknown table", replaced("[run]", "[rn]"), "[rn]", "Did you mean run"),
    ("gas constant", replaced("gas_constant = 287.05", "gas_constant = 0"), "gas_constant", "Correct the value"),
    ("unknown gas", replaced("gas_constant = 287.05", 'name = "heliumm"'), "heliumm", "Did you mean helium"),
    ("no TOML", replaced('kind = "chamber"', "kind = chamber"), "kind = chamber", "Text values require quotes"),
]


@pytest.mark.parametrize(
    ("text", "piece", "hint"), [mistake[1:] for mistake in MISTAKES], ids=[mistake[0] for mistake in MISTAKES]
)
def test_one_error_is_one_message_with_line_and_hint(text, piece, hint):
    (problem,) = problems_of(text)
    line = line_of(text, piece) if piece else len(text.splitlines()) - 1
    assert str(problem).startswith(f"circuit.toml:{line}: ")
    assert hint in problem.hint
    assert problem.given
    assert problem.reason


def test_all_errors_are_reported_in_file_order():
    text = CONTRACT
    for old, new in (
        ('"0.2 m^3"', '"-0.2 m^3"'),
        ('"45 W/K"', '"45 W"'),
        ('from = "tank"', 'from = "tonk"'),
        ("critical_ratio = 0.3", "critical_ratio = 1.2"),
        ('kind = "steps" ', 'kind = "stps" '),
        ('"120 s"', '"120 m"'),
        ("subsonic_index", "subsonic_indx"),
    ):
        assert text.count(old) == 1
        text = text.replace(old, new)
    problems = problems_of(text)
    assert len(problems) == 7
    assert [problem.line for problem in problems] == sorted(problem.line or 0 for problem in problems)
    assert [problem.address for problem in problems] == [
        "parts.tank.volume",
        "parts.tank.wall_conductance",
        "parts.bleed.from",
        "parts.bleed.critical_ratio",
        "parts.bleed.subsonic_indx",
        "signals.valve.pilot_pressure.kind",
        "run.duration",
    ]


def test_misspelt_required_field_is_one_error():
    (problem,) = problems_of(replaced("volume = ", "volum = "))
    assert "missing" not in str(problem)


class TestFiles:
    def test_missing(self, tmp_path):
        (tmp_path / "circuit.toml").write_text(SMALL, encoding="utf-8")
        with pytest.raises(InputError) as caught:
            load(tmp_path / "circut.toml")
        assert caught.value.code == "toml.no_file"
        assert caught.value.facts["suggestion"].names == ["circuit.toml"]
        assert not caught.value.facts["new"]

    def test_missing_file_suggests_circuit_files(self, tmp_path):
        (tmp_path / "tank.toml").write_text(SMALL, encoding="utf-8")
        (tmp_path / "tank_2.toml").write_text("[recordings.one]\n", encoding="utf-8")
        for table, suggestions in (("parts", ["tank.toml"]), ("recordings", ["tank_2.toml"])):
            with pytest.raises(InputError) as caught:
                TomlFile.read(tmp_path / "tank_1.toml", table)
            assert caught.value.facts["suggestion"].names == suggestions

    def test_missing_file_without_a_suggestion(self, tmp_path):
        (tmp_path / "pyproject.toml").write_text("[project]\n", encoding="utf-8")
        (tmp_path / "latin.toml").write_bytes(b"\xff")
        (tmp_path / "circuit.toml").write_text(SMALL, encoding="utf-8")
        for name in ("project.toml", "nothing.toml", "latins.toml"):
            with pytest.raises(InputError) as caught:
                load(tmp_path / name)
            assert caught.value.facts | {"path": ""} == {"path": "", "suggestion": "", "lost": True, "new": True}

    @pytest.mark.parametrize("content", [b"", b"  \n\n"])
    def test_empty(self, tmp_path, content):
        (tmp_path / "c.toml").write_bytes(content)
        with pytest.raises(InputError) as caught:
            load(tmp_path / "c.toml")
        assert caught.value.code == "toml.empty"

    def test_only_a_comment(self, tmp_path):
        (tmp_path / "c.toml").write_text("# nothing\n", encoding="utf-8")
        with pytest.raises(InputError) as caught:
            load(tmp_path / "c.toml")
        assert caught.value.code == "wiring.empty"

    @pytest.mark.parametrize(
        "content", [b"\x89PNG\r\n\x1a\n\x00\x00", b"title = 'a'\x00", b"\xff\xfe\x00a", bytes(range(256))]
    )
    def test_binary(self, tmp_path, content):
        (tmp_path / "c.toml").write_bytes(content)
        with pytest.raises(InputError) as caught:
            load(tmp_path / "c.toml")
        assert caught.value.code == "toml.no_text"

    def test_text_in_place_of_a_path(self):
        with pytest.raises(InputError) as caught:
            load("[parts.tank]\nkind = 'chamber'\n")
        assert caught.value.code == "toml.no_path"

    def test_folder(self, tmp_path):
        with pytest.raises(InputError) as caught:
            read_text(tmp_path)
        assert caught.value.code == "files.no_file"


@pytest.mark.parametrize(
    ("text", "code", "address"),
    [
        ("parts = 5\n", "circuit.no_table", "parts"),
        ("[parts]\ntank = 5\n", "circuit.no_part", "parts.tank"),
        ("signals = 3\n" + SMALL, "circuit.no_table", "signals"),
        ("run = 3\n" + SMALL.replace('[run]\nduration = "2 s"', ""), "circuit.no_table", "run"),
    ],
)
def test_values_in_place_of_tables_are_rejected(text, code, address):
    assert (code, address) in [(problem.code, problem.address) for problem in problems_of(text)]


class TestTwice:
    """Duplicate keys and tables are reported with their line."""

    def test_a_table(self):
        (problem,) = problems_of(SMALL + '[parts.tank]\nkind = "chamber"\n')
        assert (problem.code, problem.address, problem.line) == ("toml.table_twice", "parts.tank", 18)

    def test_a_key(self):
        (problem,) = problems_of(SMALL.replace('"10 l"', '"10 l"\nvolume = "1 l"'))
        assert (problem.code, problem.address, problem.line) == ("toml.key_twice", "parts.tank.volume", 15)

    def test_equal_keys_in_two_tables_of_a_list_are_valid(self):
        file = TomlFile("[[tests]]\na = 1\n[[tests]]\na = 2\nb = \n", "list")
        with pytest.raises(InputError) as caught:
            _ = file.content
        assert (caught.value.code, caught.value.line) == ("toml.invalid", 5)


def test_dotted_keys_have_lines():
    problems = problems_of('parts.a.kind = "reservoir"\nparts.a.pressure = "-1 bar"\n')
    assert {problem.line for problem in problems} == {1, 2}


def test_lines_of_tables_keys_and_long_values():
    text = (
        'title = """\n[not.a.table]\nkey = 1\n"""\n[a."b.c"]\nx = [\n  1, # ]\n  2,\n]\ny = { z = 1 }\n\'q r\'.s = 1\n'
    )
    lines = TomlFile(text, "lines").lines
    assert (lines["a.b.c"], lines["a.b.c.x"], lines["a.b.c.y"], lines["a.b.c.q r.s"]) == (5, 6, 10, 11)
    assert not any(name.startswith("not") for name in lines)


def test_errors_contain_no_traceback():
    for _, text, _, _ in MISTAKES:
        for problem in problems_of(text):
            assert not re.search(r"Traceback|Error\(|object at 0x", str(problem))


def test_errors_are_one_family():
    with pytest.raises(InputErrors) as caught:
        loads(CONTRACT.replace('"0.2 m^3"', "nan").replace('"120 s"', "nan"))
    assert caught.value.exit_code == 2
    assert len(str(caught.value).splitlines()) == 2


TANK_WITH_INVALID_CONTROLLER = """
[parts.tank]
kind = "chamber"
volume = "1 l"

[parts.hole]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 1e-9
critical_ratio = 0.3

[parts.regulator]
kind = "pid"
gain = "1 1/bar"
sample_time = true

[connections]
"regulator.measurement" = "tank.pressure"
"""


@pytest.mark.parametrize(
    "line",
    [
        '"hole.opening" = ["regulator.fill_command"]', '"nothing.opening" = "tank.pressure"',
        '"hole.command" = "tank.pressure"', '"hole.opening" = "nothing.fill_command"', '"hole.opening" = 3',
    ],
)  # fmt: skip
def test_connections_beside_an_invalid_controller_do_not_hide_its_error(line):
    with pytest.raises((InputError, InputErrors)) as caught:
        loads(TANK_WITH_INVALID_CONTROLLER + line)
    assert "parts.regulator.sample_time" in str(caught.value)


def test_missing_gas_node_beside_an_invalid_controller_is_reported():
    with pytest.raises(InputErrors) as caught:
        loads(TANK_WITH_INVALID_CONTROLLER.replace('from = "tank"', 'from = "supply"'))
    assert {problem.address for problem in caught.value.problems} >= {"parts.hole.from", "parts.regulator.sample_time"}


def test_positions_in_a_drawing_change_nothing():
    drawn = CONTRACT + '\n[drawing]\ntank = { x = 12, y = 4, rotation = 90 }\n"tank.x" = { points = [[1, 2.5]] }\n'
    plain, placed = loads(CONTRACT), loads(drawn)
    assert (placed.numbers(), placed.run) == (plain.numbers(), plain.run)
    with pytest.raises(InputError) as caught:
        loads(CONTRACT + "\n[drawin]\n")
    assert "drawing" in str(caught.value)
