"""Tests of `poppet new`: templates are listed, written and run; existing files are kept."""

from __future__ import annotations

import numpy as np
import pytest

import poppet as house
from poppet.cli.circuit_files import TEMPLATES

NAMES = (
    "bleed-regulator", "cylinder", "datasheet-valve", "drive-sizing", "emptying", "machine", "muscle-joint",
    "pressure-control", "pressure-regulator", "two-tanks", "vacuum", "valve-fill",
)  # fmt: skip


def test_lists_the_templates(poppet):
    code, out, _ = poppet("new")
    assert code == 0
    assert [line.split()[0] for line in out.splitlines()] == list(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_a_template_is_written_checked_and_run(poppet, tmp_path, name):
    assert poppet("new", name).code == 0
    assert (tmp_path / f"{name}.toml").read_bytes() == TEMPLATES[name].read_bytes()
    assert poppet("check", f"{name}.toml").code == 0
    code, out, _ = poppet("simulate", f"{name}.toml", "-o", "out.csv")
    assert code == 0
    assert "The run is complete" in out.partition("\n")[0] or name == "emptying"
    recording = house.Recording.read("out.csv")
    assert np.all(np.isfinite(recording.values))
    assert not any("balance of" in note for note in recording.notes)


def test_the_regulator_template_regulates(poppet):
    poppet("new", "bleed-regulator")
    poppet("simulate", "bleed-regulator.toml", "-o", "out.csv")
    pressure = house.Recording.read("out.csv").interpolate("volume.pressure", [29.0, 44.0, 59.0])
    # 5 bar absolute are asked for; the springs of the printed valve keep the outlet 0.2 bar below.
    assert np.max(np.abs(pressure - 4.8e5)) < 500.0


def test_the_emptying_template_ends_when_the_tank_is_empty(poppet):
    poppet("new", "emptying")
    _, out, _ = poppet("simulate", "emptying.toml")
    assert "A stop condition was met: tank.pressure < 0.02 bar g" in out


def test_an_existing_file_is_kept_unless_forced(poppet, tmp_path):
    target = tmp_path / "rig.toml"
    target.write_text("mine")
    answer = poppet("new", "two-tanks", "-o", "rig.toml")
    assert (answer.code, answer.codes) == (2, ["cli.template.exists"])
    assert target.read_text() == "mine"
    assert poppet("new", "two-tanks", "-o", "rig.toml", "--force").code == 0
    assert "Two tanks" in target.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("arguments", "code", "address", "nearest"),
    [
        (("two-tank",), "fields.not_an_option", "template", "two-tanks"),
        (("two-tanks", "-o", "rig.tml"), "files.suffix", "", ".toml"),
        (("two-tanks", "-o", "no/rig.toml"), "files.no_folder", "", ""),
    ],
)
def test_refusals(poppet, tmp_path, arguments, code, address, nearest):
    answer = poppet("new", *arguments)
    assert (answer.code, answer.errors) == (2, [(code, address, None, nearest)])
    assert list(tmp_path.iterdir()) == []
