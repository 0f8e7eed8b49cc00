"""Modules of the page of the editor that need no browser, in node."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import pytest

from javascript import needs_node
from poppet import edit
from poppet.core.errors import InputError
from poppet.timeseries.tables.reading import read_table

pytestmark = needs_node
WWW = Path(edit.__file__).parent / "www"


def in_node(module, body, data, folder):
    """Run statements with the functions of a module (`page`); they read `data` and return a value for JSON."""
    script = folder / "script.mjs"
    script.write_text(
        f"import {{ readFileSync }} from 'node:fs';\nimport * as page from {json.dumps((WWW / module).as_uri())};\n"
        f"const data = JSON.parse(readFileSync(0));\nconst run = () => {{ {body} }};\n"
        f"console.log(JSON.stringify(run()));\n",
        encoding="utf-8",
    )
    done = subprocess.run(["node", script], input=json.dumps(data), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


TABLE = "const columns = page.readTable(data); return columns.map(c => ({ ...c, values: Array.from(c.values) }));"


@pytest.mark.parametrize(
    "content",
    [
        "time [s],tank.pressure [bar]\n0,1.5\n1,2\n2,\n",
        "\ufeff# measured\ntime (s);tank.pressure (bar)\r\n0;1,5\r\n1;2\r\n2;\r\n",
        "time [s]\ttank.pressure [bar]\n0\t1,5\n1\t2\n\n2\t\n",
        '"time [s]","tank.pressure [bar]"\n"0","1.5"\n"1","2"\n"2",""\n',
    ],
)
def test_tables_of_spreadsheets(tmp_path, content):
    time, pressure = in_node("csv.js", TABLE, content, tmp_path)
    assert time == {"name": "time", "unit": "s", "values": [0, 1, 2]}
    assert pressure == {"name": "tank.pressure", "unit": "bar", "values": [1.5, 2, None]}


AS_PYTHON = {
    "quoted decimal commas": 't (s),"p (bar)"\n"0,10","6,01"\n"0,20","5,98"\n"0,30",\n',
    "quoted numbers without decimals": 't (s),p (bar)\n"0","6"\n"1","5,5"\n"2","5"\n',
    "decimal points": "t;p\n0.1;6.013\n0.2;5.993\n0.3;5.5\n",
    "exponents": "t,p\n1E0,1.5d3\n2e0,-1D-3\n3.,.5\n",
    "a small jump": "t;p\n100;1.013\n200;93\n300;87\n",
    "three decimals beside other ones": "t;p\n100;1.02\n200;1.013\n300;993\n",
    "zero": "t;p\n100;1.013\n200;0\n300;1.011\n",
    "infinite values and words for none": "t;p;word\n1;inf;a\n2;-;b\n3;n/a;c\n4;-inf;d\n",
    "thousands": "t;p\n100;6.013\n200;1.013\n300;993\n400;987\n",
    "thousands, rising": "t;p\n100;987\n200;993\n300;-1.013\n",
    "thousands and decimal commas": "t;p\n0,1;6.013\n0,2;987,5\n0,3;993,5\n",
    "a cell that is no number": "t;p\n1;6,1\n2;6,2\n3;error\n",
}


def read_in_python(file):
    """Return the columns of a file with their values as texts, or the code and the facts of the error."""
    try:
        table = read_table(file)
    except InputError as problem:
        return [problem.code.partition(".")[2], {name: fact for name, fact in problem.facts.items() if name != "line"}]
    columns = zip(table.names, table.units, table.columns, strict=True)
    return [[name, unit, [str(float(value)) for value in values]] for name, unit, values in columns]


def test_tables_are_read_as_in_python(tmp_path):
    body = (
        "const read = content => { try { return page.readTable(content).map(c => "
        "[c.name, c.unit, Array.from(c.values, String)]); } "
        "catch (problem) { return [problem.message.split('.')[1], problem.facts]; } }; return data.map(read);"
    )
    found = dict(zip(AS_PYTHON, in_node("csv.js", body, list(AS_PYTHON.values()), tmp_path), strict=True))
    file = tmp_path / "measured.csv"
    for case, content in AS_PYTHON.items():
        file.write_text(content, encoding="utf-8")
        expected = read_in_python(file)
        if isinstance(expected[0], list):
            for column in found[case]:
                column[2] = [str(float(value)) for value in column[2]]
        assert found[case] == expected, case


def test_names_that_spreadsheets_take_for_formulas(tmp_path):
    names = in_node("csv.js", TABLE, 'time,"\'=a ""b"", c [l/min (ANR)]"\n0,1\n1,2\n', tmp_path)
    assert (names[1]["name"], names[1]["unit"]) == ('=a "b", c', "l/min (ANR)")


def test_a_table_of_one_row_is_rejected(tmp_path):
    body = "try { page.readTable(data); } catch (problem) { return problem.message; }"
    assert in_node("csv.js", body, "time,p\n0,1\n", tmp_path) == "measured.rows"


@pytest.mark.parametrize(
    ("typed", "present", "expected"),
    [
        ("a = 2\nb = 1\nc = 1\n", "a = 1\nb = 1\nc = 3\n", "a = 2\nb = 1\nc = 3\n"),
        ("a = 1\nb = 1\nc = 2\n", "# note\na = 1\nb = 1\nc = 1\n", "# note\na = 1\nb = 1\nc = 2\n"),
        ("a = 1\nc = 1\n", "a = 1\nb = 1\nc = 1\nd = 1\n", "a = 1\nc = 1\nd = 1\n"),
        ("a = 2\nb = 1\nc = 1\n", "a = 1\nb = 1\nc = 1\n", "a = 2\nb = 1\nc = 1\n"),
        ("a = 2\nb = 1\nc = 1\n", "a = 2\nb = 1\nc = 1\n", "a = 2\nb = 1\nc = 1\n"),
        ("a = 2\nb = 1\nc = 1\n", "a = 3\nb = 1\nc = 1\n", None),
        ("a = 1\nb = 1\nc = 1\n", "a = 1\nc = 1\n", "a = 1\nc = 1\n"),
        ("", "a = 1\nb = 2\nc = 1\n", None),
    ],
)
def test_two_changes_of_one_text(tmp_path, typed, present, expected):
    body = "return [page.merged(...data), page.merged(data[0], data[2], data[1])];"
    assert in_node("text_merge.js", body, ["a = 1\nb = 1\nc = 1\n", typed, present], tmp_path) == [expected] * 2


def test_a_quantity_has_the_same_unit_in_two_runs(tmp_path):
    body = "return data.map(unit => page.hasColumn({ columns: [{ name: 'x', unit: 'm' }] }, { name: 'x', unit }));"
    assert in_node("compare.js", body, ["m", "rad"], tmp_path) == [True, False]


def test_the_drawing_is_no_part_of_the_simulated_text(tmp_path):
    drawing = "[drawing]\ntank = { x = 1, y = 2 }\n[drawing.vent]\nx = 4\n"
    circuit = f'[parts.tank]\nkind = "chamber"\n\n{drawing}[run]\nduration = "2 s"\n'
    moved = circuit.replace("x = 1", "x = 7").replace("x = 4", "x = 5")
    longer = circuit.replace("2 s", "3 s")
    body = "return data.map(text => page.physicsOf(text));"
    first, second, third = in_node("simulation.js", body, [circuit, moved, longer], tmp_path)
    assert first == second != third
    assert "duration" in first
    assert "drawing" not in first
    # A line of a text can look like the header of a table.
    note = ["note = '''\n[drawing]\n'''\nvolume = 1\n", "note = '''\n[drawing]\n'''\nvolume = 2\n"]
    first, second = in_node("simulation.js", body, note, tmp_path)
    assert first != second


def test_differences_of_two_variants(tmp_path):
    def view(volume, **others):
        fields = {"volume": volume}
        return {
            "parts": {"tank": {"kind": "chamber", "fields": fields, "ports": {}}},
            "run": {"duration": "2 s"},
            **others,
        }

    body = "return page.differences(data[0], data[1]);"
    assert in_node("compare.js", body, [view("1 l"), view("1 l")], tmp_path) == []
    # The source of a number is no difference.
    assert in_node("compare.js", body, [view("1 l"), view({"value": "1 l", "source": "assumed"})], tmp_path) == []
    changed = in_node("compare.js", body, [view("1 l"), view("2 l", signals={"valve.command": 1.0})], tmp_path)
    assert changed == [
        {"address": "tank.volume", "before": "1 l", "now": "2 l"},
        {"address": "valve.command", "now": "1"},
    ]


def test_values_between_two_rows(tmp_path):
    body = "return data.map(([at, isStep]) => page.valueAt([0, 1, 3], [10, 20, 40], at, isStep));"
    rows = [[0, False], [0.5, False], [2, False], [3, False], [2.9, True], [3.1, False]]
    assert in_node("quantities.js", body, rows, tmp_path) == [10, 15, 30, 40, 20, None]


def catalogue(tmp_path):
    return in_node("strings.js", "return page.CATALOGUE;", None, tmp_path)


def test_all_texts_are_in_the_catalogue(tmp_path):
    """Keys in the modules are literals, or templates whose fixed start is the name of a section."""
    sections = catalogue(tmp_path)
    keys = {f"{section}.{name}" for section, texts in sections.items() for name in texts}
    for path in sorted(WWW.glob("*.js")):
        content = path.read_text(encoding="utf-8")
        for key in re.findall(r'\btext\("([^"]+)"', content):
            assert key in keys, (path.name, key)
        for start in re.findall(r"\btext\(`(\w+)[.$]", content):
            assert start in sections, (path.name, start)
    html = (WWW / "index.html").read_text(encoding="utf-8")
    for key in re.findall(r'data-(?:text|label|title)="([^"]+)"', html):
        assert key in keys, key


def test_the_catalogue_is_sorted(tmp_path):
    for section, texts in catalogue(tmp_path).items():
        names = [name for name in texts if not name.isdigit()]
        assert names == sorted(names), section


def test_another_language(tmp_path):
    german = tmp_path / "strings.de.mjs"
    german.write_text('export const CATALOGUE = { toolbar: { save: "Sichern" } };', encoding="utf-8")
    body = (
        "page.LANGUAGES.de = data; return page.loadLanguage(['fr-FR', 'de-CH', 'en']).then("
        "name => console.log(JSON.stringify([name, page.text('toolbar.save'), page.text('toolbar.undo')])));"
    )
    script = tmp_path / "script.mjs"
    script.write_text(
        f"import * as page from {json.dumps((WWW / 'strings.js').as_uri())};\n"
        f"const data = {json.dumps(german.as_uri())};\n(() => {{ {body} }})();\n",
        encoding="utf-8",
    )
    done = subprocess.run(["node", script], capture_output=True, text=True, check=True)
    # A text that is not translated yet stays English.
    assert json.loads(done.stdout) == ["de", "Sichern", "Undo"]
