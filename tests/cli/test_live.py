"""Tests of the command `poppet live`: the default output file."""

from __future__ import annotations

from pathlib import Path

import pytest


def write_page(poppet, *arguments):
    return poppet("live", *arguments, "--parameter", "low.volume")


def test_the_page_has_the_name_of_the_circuit_file(poppet, tanks, tmp_path, monkeypatch):
    """It is in the current folder, also for a circuit file in another one."""
    (tmp_path / "pages").mkdir()
    monkeypatch.chdir(tmp_path / "pages")
    answer = write_page(poppet, str(tanks.absolute()))
    assert (answer.code, answer.err) == (0, "")
    assert "tanks.html: written." in answer.out
    assert [path.name for path in Path().iterdir()] == ["tanks.html"]
    assert not tanks.with_suffix(".html").exists()


def test_a_live_page_is_overwritten(poppet, tanks):
    write_page(poppet, str(tanks))
    page = Path("tanks.html")
    first = page.read_bytes()
    assert write_page(poppet, str(tanks), "--set", "low.volume=11 l").code == 0
    assert page.read_bytes() != first


@pytest.mark.parametrize("content", ["", "mine", "report"])
def test_another_file_is_kept(poppet, tanks, content):
    page = Path("tanks.html")
    if content == "report":
        assert poppet("simulate", str(tanks), "--report", "tanks.html").code == 0
    else:
        page.write_text(content)
    before = page.read_bytes()
    answer = write_page(poppet, str(tanks))
    assert (answer.code, answer.codes) == (2, ["deploy.file_taken"])
    assert page.read_bytes() == before
    assert write_page(poppet, str(tanks), "-o", "tanks.html").code == 0
    assert page.read_bytes() != before


def test_a_folder_is_no_page(poppet, tanks):
    Path("tanks.html").mkdir()
    answer = write_page(poppet, str(tanks))
    assert (answer.code, answer.codes) == (2, ["cli.output.is_folder"])
