"""Tests of `poppet check`: errors of circuit files with their lines, without a run."""

from __future__ import annotations

import os

import pytest

CHECK_VALVE = """
[parts.flap]
kind = "check_valve"
from = "high"
to = "low"
sonic_conductance = 1e-8
cracking_pressure = "1 bar g"
"""


def test_a_valid_file_has_a_summary(poppet, tanks):
    assert poppet("check", "tanks.toml") == (
        0, "tanks.toml: no errors; 3 parts, 4 states, 1 input, 11 outputs, 4 assumed parameters.\n", ""
    )  # fmt: skip


def test_check_does_not_compile(poppet, tanks, monkeypatch):
    def never(*_):
        raise AssertionError("compiled")

    monkeypatch.setattr("poppet.engine.kernel.compile_kernel", never)
    assert poppet("check", "tanks.toml").code == 0


def test_assumptions_of_the_circuit_are_noted(poppet, tanks):
    tanks.write_text(tanks.read_text().replace("critical_ratio = 0.3\n", ""))
    code, _, err = poppet("check", "tanks.toml")
    assert code == 0
    assert err == (
        "note: The critical back-pressure ratio hole.critical_ratio = 0.3 is assumed, "
        "because the flow capacity sonic_conductance alone does not determine this ratio.\n"
    )


def test_one_note_reports_an_assumption_of_many_parts(poppet, tanks):
    text = tanks.read_text().replace("critical_ratio = 0.3\n", "")
    start = text.index("[parts.hole]")
    end = text.find("\n[", start + 1)
    further_parts = "\n".join(text[start:end].replace("parts.hole", f"parts.hole_{k}") for k in range(3))
    tanks.write_text(text + further_parts)
    code, _, err = poppet("check", "tanks.toml")
    assert (code, err.count("note: ")) == (0, 1)
    assert [f"hole_{k}" in err for k in range(3)] == [True] * 3


def test_check_reports_all_errors_of_several_files(poppet, tanks, tmp_path):
    (tmp_path / "bad.toml").write_text(tanks.read_text().replace('"10 l"', '"10 bar"'))
    answer = poppet("check", "bad.toml", "missing.toml", "tanks.toml")
    assert answer.code == 2
    assert answer.out.startswith("tanks.toml: no errors")
    assert answer.codes == ["quantity.other_quantity", "toml.no_file"]
    error_lines = [line for line in answer.err.splitlines() if line.startswith("error: ")]
    assert [line.split(": ")[1].split(" ")[0] for line in error_lines] == ["bad.toml:6", "missing.toml"]


# What stands in the file, what is written instead, the line, the code, the address, the name that is offered.
BAD = [
    ('kind = "orifice"', 'kind = "orifcie"', 10, "fields.not_an_option", "parts.hole.kind", "orifice"),
    ('volume = "10 l"', 'volmue = "10 l"', 6, "fields.unknown", "parts.high.volmue", "volume"),
    ('"10 l"', '"10"', 6, "quantity.no_unit", "parts.high.volume", ""),
    ('"10 l"', '"10 bar"', 6, "quantity.other_quantity", "parts.high.volume", ""),
    ('"10 l"', '"10 litters"', 6, "quantity.unreadable_unit", "parts.high.volume", ""),
    ('"10 l"', "0,2", 6, "toml.comma", "", ""),
    ('"10 l"', "10 l", 6, "toml.invalid", "", ""),
    ('"10 l"', '"1,5 l"', 6, "quantity.decimal_comma", "parts.high.volume", ""),
    ('"10 l"', '"-10 l"', 6, "fields.out_of_range", "parts.high.volume", ""),
    ('"10 l"', "nan", 6, "quantity.not_finite", "parts.high.volume", ""),
    ('"10 l"', "1e10", 6, "quantity.too_large", "parts.high.volume", ""),
    ('"10 l"', "1e-300", 6, "fields.out_of_range", "parts.high.volume", ""),
    ('"0.5 dm^3/(s bar)"', "9.2e18", 13, "quantity.too_large", "parts.hole.sonic_conductance", ""),
    (
        'sonic_conductance = "0.5 dm^3/(s bar)"',
        "flow_coefficient_cv = 9.2e18",
        13,
        "fields.out_of_range",
        "parts.hole.flow_coefficient_cv",
        "",
    ),
    ('title = "Two tanks"', r'title = "Two\u001b[2J tanks"', 2, "toml.no_character", "title", ""),
    ("[parts.high]", r'[parts."hi\u0007gh"]', 4, "toml.no_character", "parts", ""),
    ('"10 l"', "inf", 6, "quantity.not_finite", "parts.high.volume", ""),
    ('"10 l"', "true", 6, "quantity.not_a_number", "parts.high.volume", ""),
    ('"10 l"', "[1]", 6, "quantity.not_a_number", "parts.high.volume", ""),
    ('"10 l"', '{ value = "10 l", source = "guess" }', 6, "fields.not_an_option", "parts.high.volume.source", ""),
    ('"6 bar g"', '"-6 bar"', 7, "quantity.pressure_below_zero", "parts.high.initial_pressure", ""),
    ('"6 bar g"', '"-6 bar g"', 7, "numbers.below_vacuum", "parts.high.initial_pressure", ""),
    ('"6 bar g"', '"20 degC"', 7, "quantity.other_quantity", "parts.high.initial_pressure", ""),
    ('from = "high"', 'from = "hihg"', 11, "fields.not_an_option", "parts.hole.from", "high"),
    ('"0.5 dm^3/(s bar)"', '"0.5 dm^3/s"', 13, "quantity.other_quantity", "parts.hole.sonic_conductance", ""),
    ("critical_ratio = 0.3", "critical_ratio = 1.0", 14, "fields.out_of_range", "parts.hole.critical_ratio", ""),
    (
        "critical_ratio = 0.3",
        'nominal_flow = "380 l/min ANR"',
        14,
        "parts.several_sizes",
        "parts.hole.nominal_flow",
        "",
    ),
    (
        "critical_ratio = 0.3",
        'characteristic = "varga2021"',
        14,
        "parts.several_sizes",
        "parts.hole.characteristic",
        "",
    ),
    ("[parts.low]", "[parts.high]", 16, "toml.table_twice", "parts.high", ""),
    ('volume = "20 l"', 'volume = "20 l"\nvolume = "30 l"', 19, "toml.key_twice", "parts.low.volume", ""),
    ('"hole.opening"', '"hole.openning"', 20, "names.unknown", "signals.hole.openning", "hole.opening"),
    ('"hole.opening"', '"high.volume"', 20, "names.unknown", "signals.high.volume", ""),
    ('kind = "steps"', 'kind = "stpes"', 21, "fields.not_an_option", "signals.hole.opening.kind", "steps"),
    ('kind = "steps"', 'kind = ["steps"]', 21, "fields.not_an_option", "signals.hole.opening.kind", "steps"),
    (
        'times = ["0 s", "1 s"]',
        'times = ["0 s", "0 s"]',
        22,
        "series.time.not_increasing",
        "signals.hole.opening.times",
        "",
    ),
    ('times = ["0 s", "1 s"]', 'times = ["1 s", "2 s"]', 22, "signals.no_first_step", "signals.hole.opening.times", ""),
    ('times = ["0 s", "1 s"]', 'times = ["0 s"]', 22, "signals.lengths", "signals.hole.opening.times", ""),
    (
        'times = ["0 s", "1 s"]',
        'time = ["0 s", "1 s"]',
        22,
        "fields.unknown",
        "signals.hole.opening.time",
        "times",
    ),
    ("values = [0, 1]", "values = [0, 1.5]", 20, "wiring.signal_outside", "signals.hole.opening", ""),
    ("values = [0, 1]", 'values = [0, "1 bar"]', 23, "quantity.other_quantity", "signals.hole.opening.values[1]", ""),
    ("[run]", "[runn]", 25, "fields.unknown", "runn", "run"),
    ('duration = "5 s"', 'duraton = "5 s"', 26, "fields.unknown", "run.duraton", "duration"),
    ('duration = "5 s"', 'duration = "0 s"', 26, "fields.out_of_range", "run.duration", ""),
    ('duration = "5 s"', 'duration = "5 s"\nstop_when = 3', 27, "options.no_condition", "run.stop_when", ""),
    (
        'duration = "5 s"',
        'duration = "5 s"\nstop_when = "low.presure > 5 bar"',
        27,
        "stop.unknown_output",
        "run.stop_when",
        "low.pressure",
    ),
    ('duration = "5 s"', "duration = 5 s", 26, "toml.invalid", "", ""),
    ("[run]", '[ambient]\npressure = "0 bar g"\n[run]', 26, "options.gauge_ambient", "ambient.pressure", ""),
    ("[run]", '[gas]\nname = "nitrogn"\n[run]', 26, "library.unknown", "gas.name", "nitrogen"),
    ("[run]", '[parts.spare]\nkind = "chamber"\nvolume = "1 l"\n[run]', 25, "wiring.alone", "parts.spare", ""),
    ("[run]", f"{CHECK_VALVE}[run]", 31, "quantity.gauge_difference", "parts.flap.cracking_pressure", ""),
]


@pytest.mark.parametrize(
    ("good", "bad", "line", "code", "address", "nearest"),
    BAD,
    ids=[f"{k}-{case[1][:30]}" for k, case in enumerate(BAD)],
)
def test_an_error_is_reported_once_with_its_line(poppet, tanks, good, bad, line, code, address, nearest):
    text = tanks.read_text()
    assert good in text
    tanks.write_text(text.replace(good, bad, 1))
    answer = poppet("check", "tanks.toml")
    assert (answer.code, answer.out) == (2, "")
    assert answer.errors == [(code, address, line, nearest)]
    assert answer.err.startswith(f"error: tanks.toml:{line}: ")


@pytest.mark.parametrize("bad", ["volume = 3 bar", "critical_ratio = 3", 'stop_when = "low.presure > 5 bar"'])
def test_a_run_reports_the_same_error(poppet, tanks, bad):
    tanks.write_text(f"{tanks.read_text()}\n{bad}\n")
    assert poppet("simulate", "tanks.toml", "-o", "out.csv").err == poppet("check", "tanks.toml").err != ""


@pytest.mark.parametrize(
    ("good", "bad", "line", "code"),
    [
        ('to = "low"', 'to = "high"', 9, "wiring.joined_twice"),
        ('to = "low"', "to = 3", 12, "fields.not_a_name"),
        ("[parts.low]", '[parts."the low"]', 16, "wiring.no_name"),
    ],
)
def test_the_cause_of_further_errors_is_reported(poppet, tanks, good, bad, line, code):
    tanks.write_text(tanks.read_text().replace(good, bad, 1))
    answer = poppet("check", "tanks.toml")
    assert answer.code == 2
    assert (code, line) in [(error.code, error.line) for error in answer.errors]


def test_six_errors_have_their_line_numbers(poppet, tanks):
    text = tanks.read_text()
    for old, new in (
        ('"10 l"', '"10 bar"'),
        ('from = "high"', 'from = "hihg"'),
        ("critical_ratio = 0.3", "critical_ratio = 1.3"),
        ('volume = "20 l"', 'volmue = "20 l"'),
        ('kind = "steps"', 'kind = "stpes"'),
        ("duration", "duratoin"),
    ):
        assert old in text
        text = text.replace(old, new, 1)
    tanks.write_text(text)
    answer = poppet("check", "tanks.toml")
    assert answer.code == 2
    assert [error.line for error in answer.errors] == [6, 11, 14, 18, 21, 26]


def test_an_unknown_kind_is_one_error(poppet, tanks):
    tanks.write_text(tanks.read_text().replace('kind = "chamber"', 'kind = "chambre"', 1))
    errors = poppet("check", "tanks.toml").errors
    assert errors == [("fields.not_an_option", "parts.high.kind", 5, "chamber")]


def test_a_misspelt_mode_is_one_error(poppet, tmp_path):
    poppet("new", "valve-fill")
    path = tmp_path / "valve-fill.toml"
    path.write_text(path.read_text(encoding="utf-8").replace('mode = "paper"', 'mode = "papre"'), encoding="utf-8")
    assert poppet("check", "valve-fill.toml").errors == [("fields.not_an_option", "parts.valve.mode", 16, "paper")]


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"", "toml.empty"),
        (b" \n\t\n", "toml.empty"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "toml.no_text"),
        (b"title = \xff\xfe", "toml.no_text"),
        (b'title = "no parts"', "wiring.empty"),
        (b"parts = 3", "circuit.no_table"),
        (b"[parts]\ntank = 3", "circuit.no_part"),
        (b"a = " + b"[" * 5000, "toml.too_deep"),
    ],
)
@pytest.mark.parametrize("command", ["check", "simulate", "show"])
def test_a_file_without_a_circuit_is_refused(poppet, tmp_path, command, content, code):
    (tmp_path / "odd.toml").write_bytes(content)
    answer = poppet(command, "odd.toml")
    assert (answer.code, answer.out) == (2, "")
    assert code in answer.codes


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b".".join([b"a"] * 50_000) + b" = 1", "toml.too_deep"),
        (b"[" + b" . ".join([b'"a"'] * 100) + b"]", "toml.too_deep"),
        (b"title = '" + b"x" * 17_000_000 + b"'", "toml.too_large"),
        (b"\n".join(b"k%d = 1" % k for k in range(20_000)), "input.enough"),
        (b"".join(b"[parts.p%d]\n" % k for k in range(6000)), "wiring.too_many"),
        (b"[parts." + b"p" * 101 + b"]\nkind = 'chamber'", "wiring.no_name"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_nested_or_binary_files_are_refused_quickly(poppet, tmp_path, content, code):
    (tmp_path / "odd.toml").write_bytes(content)
    answer = poppet("check", "odd.toml")
    assert (answer.code, answer.out) == (2, "")
    assert code in answer.codes


def test_a_device_without_an_end_is_refused(poppet):
    if not os.path.exists("/dev/zero"):
        pytest.skip("no such device")
    answer = poppet("check", "/dev/zero")
    assert answer.codes == ["files.no_file"]
    assert answer.error.facts["kind"] == "device"


@pytest.mark.parametrize("command", ["check", "simulate", "show"])
def test_a_missing_file_is_refused(poppet, tanks, tmp_path, command):
    assert poppet(command, "tank.toml").errors == [("toml.no_file", "", None, "tanks.toml")]
    (tmp_path / "folder.toml").mkdir()
    assert poppet(command, "folder.toml").codes == ["files.no_file"]


ODD = (
    "3",
    "-1",
    '""',
    "true",
    "[]",
    "[[1]]",
    "{}",
    "{ a = 1 }",
    "nan",
    '"1 bar g"',
    "1979-05-27",
    '"high"',
    '"\\u0000"',
)


@pytest.mark.parametrize("odd", ODD)
def test_odd_values_give_no_internal_error(poppet, tanks, odd):
    lines = tanks.read_text().splitlines()
    keys = [k for k, line in enumerate(lines) if " = " in line]
    for k in keys:
        name = lines[k].partition(" = ")[0]
        tanks.write_text("\n".join([*lines[:k], f"{name} = {odd}", *lines[k + 1 :]]))
        code, _, err = poppet("show", "tanks.toml")
        assert code in (0, 2), (lines[k], err)
        assert (err == "") == (code == 0)


STRETCHED = """
[parts.flexor]
kind = "muscle"
data = "dmsp_20_300"
body = "slide"
direction = -1
[parts.slide]
kind = "mass"
mass = 1.0
initial_position = "2 mm"
"""


def test_a_muscle_longer_than_nominal_at_the_start_gives_a_note(poppet, tmp_path):
    (tmp_path / "stretched.toml").write_text(STRETCHED)
    for command in ("check", "simulate"):
        answer = poppet(command, "stretched.toml")
        assert (answer.code, answer.codes) == (2, ["muscle.stretched"])


def test_the_table_modbus_is_checked_as_by_serve(poppet, tanks):
    tanks.write_text(
        tanks.read_text() + '\n[modbus.registers]\n"high.presure" = { input = 0 }\n"high.pressure" = { holding = 1 }\n',
        encoding="utf-8",
    )
    checked, served = poppet("check", "tanks.toml"), poppet("serve", "tanks.toml", "--map")
    assert checked.code == served.code == 2
    assert checked.codes == served.codes == ["modbus.unknown", "modbus.not_writable"]
    assert [error.address for error in checked.errors] == [error.address for error in served.errors]
    assert "Did you mean high.pressure" in checked.err
    lines = [line for line in checked.err.splitlines() if line.startswith("error: ")]
    assert lines == [line for line in served.err.splitlines() if line.startswith("error: ")]
    assert all("tanks.toml:" in line for line in lines)


def test_errors_of_the_table_modbus_and_of_others_are_reported_together(poppet, tanks):
    tanks.write_text(
        tanks.read_text() + '\n[ensemble]\nruns = 0\n\n[modbus]\nword_order = "middle"\n', encoding="utf-8"
    )
    codes = poppet("check", "tanks.toml").codes
    assert "fields.not_an_option" in codes
    assert len(codes) > 1
