"""Function `size` with a catalogue: component files of the folder, confinement, and rejected input."""

from __future__ import annotations

import json
import os
import tomllib

import pytest

from assistant_solutions import component_file, fill_requirement, filled_tank
from poppet.assist.folder import Folder
from poppet.assist.functions import FUNCTIONS, perform
from poppet.assist.replies import error_rows
from poppet.core.errors import InputError
from poppet.core.toml_file import LARGEST

CONDUCTANCES = (0.5, 0.2, 0.3)  # [dm^3/(s bar)]
MEASURED = 12.535574
"""Duration of the fill of 10 l from 1 to 2 bar through C = 0.1 dm^3/(s bar) from 8 bar [s]; see tasks.toml."""


def text(path: str = "acme.toml", limit: str = "5 s") -> str:
    return f'components = ["{path}"]\n' + fill_requirement(filled_tank(), limit)


@pytest.fixture
def catalogue(folder):
    (folder / "acme.toml").write_text(component_file(CONDUCTANCES), encoding="utf-8")
    return folder


def size(folder, **arguments):
    return perform(Folder.of(folder), FUNCTIONS["size"], arguments)


def refused(folder, **arguments) -> list[tuple[str, str]]:
    """Return codes and addresses of the errors of a call; each has a hint, and none shows the path of the folder."""
    with pytest.raises(InputError) as caught:
        size(folder, **arguments)
    rows = error_rows(caught.value, Folder.of(folder))
    assert all(row["hint"] for row in rows)
    assert str(folder) not in json.dumps(rows)
    return [(row["code"], row["address"]) for row in rows]


def test_the_smallest_component_and_its_neighbour(catalogue):
    result = size(catalogue, text=text(), catalogue="valve", find="Acme", output="result.toml")
    assert result["is_met"]
    assert (result["measure"], result["units"]) == ("sonic_conductance", {"fill": "s"})
    assert [row["component"] for row in result["trials"]] == ["Acme X2", "Acme X3", "Acme X1"]
    for row, conductance in zip(result["trials"], sorted(CONDUCTANCES), strict=True):
        assert row["value"] == pytest.approx(conductance * 1e-8)
        assert row["metrics"]["fill"] == pytest.approx(MEASURED * 0.1 / conductance, rel=1e-3)
        assert row["margins"]["fast"] == pytest.approx(5.0 - row["metrics"]["fill"])
        assert row["is_met"] == (row["metrics"]["fill"] < 5.0)
    assert result["selected"]["component"] == "Acme X3"
    assert result["selected"]["document"].startswith("Data sheet")
    assert result["next"] == result["trials"][0]
    assert "size.use_component" in [note["code"] for note in result["notes"]]
    written = tomllib.loads((catalogue / "result.toml").read_text(encoding="utf-8"))
    assert written["component"] == "Acme X3"


def test_the_largest_component_and_none(catalogue):
    slow = text().replace("fill < 5 s", "fill > 3 s")
    largest = size(catalogue, text=slow, catalogue="valve", find="Acme", largest=True)
    assert (largest["extreme"], largest["selected"]["component"]) == ("largest", "Acme X3")
    none = size(catalogue, text=text(limit="1 s"), catalogue="valve", find="Acme")
    assert (none["is_met"], none["selected"], none["next"]) == (False, None, None)
    assert len(none["trials"]) == 3


def test_the_component_of_the_result_is_valid_in_the_circuit(catalogue):
    selected = size(catalogue, text=text(), catalogue="valve", find="Acme")["selected"]["component"]
    stated = 'sonic_conductance = "0.1 dm^3/(s bar)"\ncritical_ratio = 0.3'
    assert stated in text()
    changed = text().replace(stated, f'model = "{selected}"')
    rows = perform(Folder.of(catalogue), FUNCTIONS["parameters"], {"text": changed, "part": "valve"})["parameters"]
    assert rows["valve.sonic_conductance"]["value"] == pytest.approx(0.3e-8)


@pytest.mark.parametrize("path", ["../acme.toml", "{parent}/acme.toml", "sub/../../acme.toml", "/etc/passwd"])
def test_component_files_outside_are_rejected(catalogue, path):
    (catalogue.parent / "acme.toml").write_text(component_file((0.3,)))
    (catalogue / "sub").mkdir()
    circuit = text(path.format(parent=catalogue.parent.as_posix()))
    assert refused(catalogue, text=circuit, catalogue="valve") == [("files.outside", "components")]


@pytest.mark.skipif(os.name != "posix", reason="links and pipes")
def test_component_files_behind_links_and_pipes_are_rejected(catalogue):
    (catalogue.parent / "outside.toml").write_text(component_file((0.3,)))
    (catalogue / "link.toml").symlink_to(catalogue.parent / "outside.toml")
    (catalogue / "folder").symlink_to(catalogue.parent, target_is_directory=True)
    os.mkfifo(catalogue / "pipe.toml")
    for path, code in (
        ("link.toml", "files.outside"),
        ("folder/outside.toml", "files.outside"),
        ("pipe.toml", "files.no_file"),
    ):
        assert refused(catalogue, text=text(path), catalogue="valve") == [(code, "components")], path


def test_large_and_invalid_component_files_are_rejected(catalogue):
    (catalogue / "large.toml").write_bytes(b"#" * (LARGEST + 1))
    (catalogue / "binary.toml").write_bytes(b"\xff\xfe\x00")
    (catalogue / "syntax.toml").write_text("[components\n")
    unit, unknown = (
        component_file((0.3,)).replace(*change) for change in (("(s bar)", "s"), ('"orifice"', '"orifce"'))
    )
    (catalogue / "unit.toml").write_text(unit)
    (catalogue / "unknown.toml").write_text(unknown)
    for name, *error in (
        ("large", "toml.too_large", "components"),
        ("binary", "toml.no_text", "components"),
        ("missing", "toml.no_file", "components"),
        ("syntax", "toml.invalid", "syntax.toml"),
        ("unit", "quantity.other_quantity", "components.X1.fields.sonic_conductance"),
        ("unknown", "fields.not_an_option", "components.X1.kinds"),
    ):
        assert refused(catalogue, text=text(f"{name}.toml"), catalogue="valve") == [tuple(error)], name


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ({"between": ["1 l", "2 l"]}, ("assist.excluded", "between")),
        ({"share": "95 %"}, ("assist.excluded", "share")),
        ({"sizes": ["1 l"]}, ("assist.excluded", "sizes")),
        ({"free": "tank.volume"}, ("assist.one_subject", "free")),
        ({"catalogue": "valv"}, ("names.unknown", "valv")),
        ({"catalogue": "supply"}, ("size.no_component", "supply")),
        ({"find": "C > 900 dm^3/(s bar)"}, ("size.no_candidate", "valve")),
        ({"find": "C >"}, ("components.no_condition", "find")),
        ({"find": "C > 3 bar"}, ("quantity.other_quantity", "C")),
        ({"find": "nothing"}, ("components.no_word", "find")),
        ({"meet": ["slow"]}, ("names.unknown", "slow")),
        ({"output": "../result.toml"}, ("assist.file_name", "output")),
        ({"output": "acme.toml"}, ("assist.exists", "output")),
    ],
)
def test_arguments_that_are_rejected(catalogue, arguments, error):
    assert refused(catalogue, **{"text": text(), "catalogue": "valve", **arguments}) == [error]


def test_python_metrics_are_not_executed(catalogue):
    (catalogue / "metrics.py").write_text("raise SystemExit('executed')\n")
    circuit = text().replace(
        'metric = "time_to", value = "2 bar", unit = "s"', 'metric = "metrics.py:fill", unit = "s"'
    )
    codes = [code for code, _ in refused(catalogue, text=circuit, catalogue="valve")]
    assert "ensemble.python_forbidden" in codes
