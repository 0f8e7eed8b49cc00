"""Circuits of the editor name files of their folder only."""

from __future__ import annotations

import pytest

from poppet.edit.circuit_reader import read_text
from refusals import refused

TANK = """
[parts.tank]
kind = "chamber"
volume = "1 l"
[parts.leak]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 1e-9
critical_ratio = 0.3
"""
FILES = {
    "signals.leak.opening.path": '[signals."leak.opening"]\nkind = "file"\npath = "{}"\n',
    "components": "components = [{!r}]\n",
    "ensemble.file": '[ensemble]\nfile = "{}"\n',
    "ensemble.parameters.from_fit": '[ensemble.parameters]\nfrom_fit = "{}"\n',
    "parts.leak.characteristic": (
        '[parts.leak]\nkind = "orifice"\nfrom = "tank"\nto = "ambient"\ncharacteristic = "{}"\n'
    ),
}


def with_file(address, path):
    table = FILES[address].format(path)
    parts = TANK.partition("[parts.leak]")[0] if address.startswith("parts") else TANK
    return table + TANK if address == "components" else parts + table


@pytest.mark.parametrize("address", FILES)
@pytest.mark.parametrize(
    "path", ["/etc/passwd", "../secret.toml", "sub/../../secret.toml", "link.toml", "linked/x.csv"]
)
def test_files_outside_the_folder_are_refused(tmp_path, address, path):
    folder = tmp_path / "work"
    (folder / "sub").mkdir(parents=True)
    (tmp_path / "secret.toml").write_text("a = 1", encoding="utf-8")
    (folder / "link.toml").symlink_to(tmp_path / "secret.toml")
    (folder / "linked").symlink_to(tmp_path)
    with refused("edit.outside", address, path=path):
        read_text(with_file(address, path), folder)


@pytest.mark.parametrize("path", ["x.csv", "sub/x.csv", "sub/../x.csv", "inner.csv"])
def test_files_of_the_folder_are_read(tmp_path, path):
    (tmp_path / "sub").mkdir()
    for name in ("x.csv", "sub/x.csv"):
        (tmp_path / name).write_text("time [s],value\n0,0\n1,1\n", encoding="utf-8")
    (tmp_path / "inner.csv").symlink_to(tmp_path / "x.csv")
    text = with_file("signals.leak.opening.path", path) + 'column = "value"\nunit = "1"\n'
    assert read_text(text, tmp_path).signals.keys() == {"leak.opening"}


def test_errors_have_lines_and_all_are_reported(tmp_path):
    text = with_file("ensemble.file", "/a") + 'path = "/b"\n'
    with refused("edit.outside", "ensemble.path") as caught:
        read_text("\ufeff" + text, tmp_path)
    assert [problem.line for problem in caught.value.problems] == [text.count("\n") - 1, text.count("\n")]
