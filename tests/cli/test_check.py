"""`poppet check`: what a wrong circuit file is told, line by line, without a run and without a compiler."""

from __future__ import annotations

import pytest

CHECK_VALVE = """
[parts.flap]
kind = "check_valve"
from = "high"
to = "low"
sonic_conductance = 1e-8
cracking_pressure = "1 bar g"
"""


def test_a_good_file_is_summed_up(poppet, tanks):
    assert poppet("check", "tanks.toml") == (
        0, "tanks.toml: no mistakes; 3 parts, 4 states, 1 input, 11 outputs, 4 assumed numbers.\n", ""
    )  # fmt: skip


def test_nothing_is_compiled(poppet, tanks, monkeypatch):
    def never(*_):
        raise AssertionError("compiled")

    monkeypatch.setattr("poppet.engine.kernel.compile_kernel", never)
    assert poppet("check", "tanks.toml").code == 0


def test_assumptions_of_the_circuit_are_noted(poppet, tanks):
    tanks.write_text(tanks.read_text().replace("critical_ratio = 0.3\n", ""))
    code, _, err = poppet("check", "tanks.toml")
    assert code == 0
    assert err == "note: hole.critical_ratio: sonic_conductance alone does not determine b: 0.3 assumed.\n"


def test_several_files_and_all_their_mistakes(poppet, tanks, tmp_path):
    (tmp_path / "bad.toml").write_text(tanks.read_text().replace('"10 l"', '"10 bar"'))
    code, out, err = poppet("check", "bad.toml", "missing.toml", "tanks.toml")
    assert code == 2
    assert out.startswith("tanks.toml: no mistakes")
    assert [line.split(": ")[1].split(" ")[0] for line in err.splitlines()] == ["bad.toml:6", "missing.toml"]


BAD = [
    (
        'kind = "orifice"',
        'kind = "orifcie"',
        10,
        "parts.hole.kind = 'orifcie' is unknown. Did you mean orifice?",
    ),
    (
        'volume = "10 l"',
        'volmue = "10 l"',
        6,
        "parts.high.volmue is not a field of this part. Did you mean volume?",
    ),
    ('"10 l"', '"10"', 6, 'parts.high.volume = "10" has no unit.'),
    ('"10 l"', '"10 bar"', 6, 'parts.high.volume = "10 bar" has a unit that does not lead to "m^3".'),
    ('"10 l"', '"10 litters"', 6, '"litters", which is unknown.'),
    ('"10 l"', "0,2", 6, "Write a decimal point instead of the comma."),
    ('"10 l"', "10 l", 6, "Mend it; text values need quotes."),
    ('"10 l"', '"1,5 l"', 6, 'has a decimal comma. Write a decimal point: "1.5 l".'),
    ('"10 l"', '"-10 l"', 6, "parts.high.volume = -10 l is out of range"),
    ('"10 l"', "nan", 6, "parts.high.volume = nan is not finite."),
    ('"10 l"', "inf", 6, "parts.high.volume = inf is not finite."),
    ('"10 l"', "true", 6, "parts.high.volume = True is not a number."),
    ('"10 l"', "[1]", 6, "parts.high.volume = [1] is not a number."),
    ('"10 l"', '{ value = "10 l", source = "guess" }', 6, "source = 'guess' is not a kind of source."),
    ('"6 bar g"', '"-6 bar"', 7, "is an absolute pressure below zero."),
    ('"6 bar g"', '"-6 bar g"', 7, "parts.high.initial_pressure = -6 bar g lies below vacuum"),
    ('"6 bar g"', '"20 degC"', 7, "has a unit that does not lead to"),
    (
        'from = "high"',
        'from = "hihg"',
        11,
        'parts.hole.from = "hihg" names no part of this circuit. Did you mean high?',
    ),
    ('"0.5 dm^3/(s bar)"', '"0.5 dm^3/s"', 13, "parts.hole.sonic_conductance"),
    (
        "critical_ratio = 0.3",
        "critical_ratio = 1.0",
        14,
        "the critical ratio b must be at least 0 and less than 1.",
    ),
    ("critical_ratio = 0.3", 'nominal_flow = "380 l/min ANR"', 14, "are given together: exactly one of them"),
    ("critical_ratio = 0.3", 'characteristic = "varga2021"', 14, "exactly one of them"),
    ("[parts.low]", "[parts.high]", 16, "[parts.high] stands twice: two tables of one name."),
    ('volume = "20 l"', 'volume = "20 l"\nvolume = "30 l"', 19, "volume stands twice in its table."),
    (
        '"hole.opening"',
        '"hole.openning"',
        20,
        "signals.hole.openning drives no input of this circuit. Did you mean hole.opening?",
    ),
    ('"hole.opening"', '"high.volume"', 20, "drives no input of this circuit."),
    ('kind = "steps"', 'kind = "stpes"', 21, "kind = 'stpes' is unknown. Did you mean steps?"),
    ('kind = "steps"', 'kind = ["steps"]', 21, "kind = ['steps'] is unknown."),
    ('times = ["0 s", "1 s"]', 'times = ["0 s", "0 s"]', 22, "do not increase"),
    ('times = ["0 s", "1 s"]', 'times = ["1 s", "2 s"]', 22, "Begin with time 0 s."),
    ('times = ["0 s", "1 s"]', 'times = ["0 s"]', 22, "1 times and 2 values do not belong together."),
    (
        'times = ["0 s", "1 s"]',
        'time = ["0 s", "1 s"]',
        22,
        "time is not a field of a steps signal. Did you mean times",
    ),
    ("values = [0, 1]", "values = [0, 1.5]", 20, "signals.hole.opening reaches 1.5"),
    ("values = [0, 1]", 'values = [0, "1 bar"]', 23, "signals.hole.opening.values[1]"),
    ("[run]", "[runn]", 25, "[runn] is not a part of a circuit file. Did you mean run?"),
    (
        'duration = "5 s"',
        'duraton = "5 s"',
        26,
        "run.duraton is not a field of this part. Did you mean duration?",
    ),
    ('duration = "5 s"', 'duration = "0 s"', 26, "run.duration = 0 s is out of range"),
    ('duration = "5 s"', 'duration = "5 s"\nstop_when = 3', 27, "run.stop_when = 3 is not a condition."),
    (
        'duration = "5 s"',
        'duration = "5 s"\nstop_when = "low.presure > 5 bar"',
        27,
        "Did you mean low.pressure",
    ),
    ('duration = "5 s"', "duration = 5 s", 26, "is not valid TOML"),
    ("[run]", '[ambient]\npressure = "0 bar g"\n[run]', 26, "ambient.pressure = 0 bar g is gauge"),
    ("[run]", '[gas]\nname = "nitrogn"\n[run]', 26, "Did you mean nitrogen?"),
    ("[run]", '[parts.spare]\nkind = "chamber"\nvolume = "1 l"\n[run]', 25, "parts.spare is not connected"),
    ("[run]", f"{CHECK_VALVE}[run]", 31, "is a gauge pressure where a difference is meant."),
]


@pytest.mark.parametrize(
    ("good", "bad", "line", "sentence"), BAD, ids=[f"{k}-{case[1][:30]}" for k, case in enumerate(BAD)]
)
def test_a_mistake_is_told_once_with_its_line(poppet, tanks, good, bad, line, sentence):
    text = tanks.read_text()
    assert good in text
    tanks.write_text(text.replace(good, bad, 1))
    code, out, err = poppet("check", "tanks.toml")
    assert (code, out) == (2, "")
    assert sentence in err
    assert err.startswith(f"error: tanks.toml:{line}: ")
    assert err.count("\n") == 1
    assert poppet("simulate", "tanks.toml", "-o", "out.csv").err == err


@pytest.mark.parametrize(
    ("good", "bad", "line", "sentence"),
    [
        ('to = "low"', 'to = "high"', 9, "parts.hole joins high with itself"),
        ('to = "low"', "to = 3", 12, "parts.hole.to = 3 is not the name of a part."),
        ("[parts.low]", '[parts."the low"]', 16, "is not a name of a part."),
    ],
)
def test_a_mistake_that_leads_to_others_is_among_them(poppet, tanks, good, bad, line, sentence):
    tanks.write_text(tanks.read_text().replace(good, bad, 1))
    code, _, err = poppet("check", "tanks.toml")
    assert code == 2
    assert any(row.startswith(f"error: tanks.toml:{line}: ") and sentence in row for row in err.splitlines())


def test_six_mistakes_in_six_lines_with_their_lines(poppet, tanks):
    text = tanks.read_text()
    for good, bad in (
        ('"10 l"', '"10 bar"'),
        ('from = "high"', 'from = "hihg"'),
        ("critical_ratio = 0.3", "critical_ratio = 1.3"),
        ('volume = "20 l"', 'volmue = "20 l"'),
        ('kind = "steps"', 'kind = "stpes"'),
        ("duration", "duratoin"),
    ):
        assert good in text
        text = text.replace(good, bad, 1)
    tanks.write_text(text)
    code, _, err = poppet("check", "tanks.toml")
    assert code == 2
    assert [line.partition(": ")[2].partition(": ")[0] for line in err.splitlines()] == [
        f"tanks.toml:{line}" for line in (6, 11, 14, 18, 21, 26)
    ]


def test_an_unknown_kind_is_one_mistake_whoever_is_joined_to_it(poppet, tanks):
    tanks.write_text(tanks.read_text().replace('kind = "chamber"', 'kind = "chambre"', 1))
    _, _, err = poppet("check", "tanks.toml")
    assert err == "error: tanks.toml:5: parts.high.kind = 'chambre' is unknown. Did you mean chamber?\n"


def test_a_misspelt_mode_is_one_mistake(poppet, tmp_path):
    poppet("new", "valve-fill")
    path = tmp_path / "valve-fill.toml"
    path.write_text(path.read_text(encoding="utf-8").replace('mode = "paper"', 'mode = "papre"'), encoding="utf-8")
    code, _, err = poppet("check", "valve-fill.toml")
    assert code == 2
    assert err == "error: valve-fill.toml:16: parts.valve.mode = 'papre' is not a mode. Did you mean paper?\n"


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"", "is empty."),
        (b" \n\t\n", "is empty."),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "is not text in UTF-8."),
        (b"title = \xff\xfe", "is not text in UTF-8."),
        (b'title = "no parts"', "The circuit has no parts."),
        (b"parts = 3", "parts = 3 is not a table."),
        (b"[parts]\ntank = 3", "parts.tank = 3 is not a table."),
        (b"a = " + b"[" * 5000, "nests its brackets too deep"),
    ],
)
@pytest.mark.parametrize("command", ["check", "simulate", "show"])
def test_a_file_that_is_no_circuit(poppet, tmp_path, command, content, sentence):
    (tmp_path / "odd.toml").write_bytes(content)
    code, out, err = poppet(command, "odd.toml")
    assert (code, out) == (2, "")
    assert sentence in err
    assert "internal error" not in err


@pytest.mark.parametrize("command", ["check", "simulate", "show"])
def test_a_file_that_is_not_there(poppet, tanks, tmp_path, command):
    code, _, err = poppet(command, "tank.toml")
    assert (code, err) == (2, "error: tank.toml does not exist. Did you mean tanks.toml?\n")
    (tmp_path / "folder.toml").mkdir()
    assert "cannot be read" in poppet(command, "folder.toml").err


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
def test_whatever_stands_behind_a_key_there_is_no_internal_error(poppet, tanks, odd):
    lines = tanks.read_text().splitlines()
    keys = [k for k, line in enumerate(lines) if " = " in line]
    for k in keys:
        name = lines[k].partition(" = ")[0]
        tanks.write_text("\n".join([*lines[:k], f"{name} = {odd}", *lines[k + 1 :]]))
        code, _, err = poppet("show", "tanks.toml")
        assert code in (0, 2), (lines[k], err)
        assert (err == "") == (code == 0)
