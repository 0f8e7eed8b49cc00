"""Tests of FMUs of other people: they are rejected before anything is written or executed."""

from __future__ import annotations

import stat
import tempfile
import zipfile
from pathlib import Path

import pytest

from poppet import load
from poppet.cosim.archive import check_archive
from poppet.deploy.fmu.package import build_fmu, zip_bytes

TEXT = """<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName="m" guid="g"><CoSimulation modelIdentifier="{}"/></fmiModelDescription>
"""
ENTITIES = '<!DOCTYPE x [<!ENTITY a "b"><!ENTITY c "&a;&a;">]><fmiModelDescription fmiVersion="2.0"/>'


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of temporary files."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


def write_fmu(path: Path, *entries: str | zipfile.ZipInfo, identifier: str = "m", description: str = TEXT) -> None:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("modelDescription.xml", description.format(identifier) if "{}" in description else description)
        for entry in entries:
            archive.writestr(entry, "content")


def rejected(poppet, tanks, temporary: Path) -> list[str]:
    """Codes of `export check`, which neither wrote nor removed a file."""
    before = sorted(tanks.parent.parent.rglob("*"))
    answer = poppet("export", "check", "m.fmu", "--circuit", "tanks.toml")
    assert answer.code == 2
    assert sorted(tanks.parent.parent.rglob("*")) == before
    assert list(temporary.iterdir()) == []
    return answer.codes


@pytest.mark.parametrize(
    "entry",
    [
        "../evil.txt",
        "resources/../../evil.txt",
        "/evil.txt",
        "//evil/x",
        "C:/evil.txt",
        "resources\\..\\evil.txt",
        "resources/a\nb",
        "resources/.. /x",
        "resources//x",
    ],
)
def test_path_out_of_the_archive(poppet, tanks, temporary, tmp_path, entry):
    write_fmu(tmp_path / "m.fmu", entry)
    assert rejected(poppet, tanks, temporary) == ["deploy.fmu.entry_path"]


@pytest.mark.parametrize("kind", [stat.S_IFLNK, stat.S_IFIFO, stat.S_IFCHR, stat.S_IFSOCK])
def test_link_in_the_archive(poppet, tanks, temporary, tmp_path, kind):
    link = zipfile.ZipInfo("binaries/linux64/m.so")
    link.external_attr = (kind | 0o777) << 16
    write_fmu(tmp_path / "m.fmu", link)
    assert rejected(poppet, tanks, temporary) == ["deploy.fmu.entry_link"]


@pytest.mark.parametrize("identifier", ["../../evil", "/evil/m", "a/b", "a.b", "a\\b", "", "ä", "a b", "m&#10;"])
def test_model_identifier_is_no_path(poppet, tanks, temporary, tmp_path, identifier):
    write_fmu(tmp_path / "m.fmu", identifier=identifier)
    assert rejected(poppet, tanks, temporary) == ["deploy.fmu.identifier"]


def test_decompression_bomb(poppet, tanks, temporary, tmp_path):
    with zipfile.ZipFile(tmp_path / "m.fmu", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("modelDescription.xml", TEXT.format("m"))
        zeros = bytes(2**24)
        with archive.open("resources/zeros", "w", force_zip64=True) as stream:
            for _ in range(128):
                stream.write(zeros)
    assert (tmp_path / "m.fmu").stat().st_size < 4 * 2**20
    assert rejected(poppet, tanks, temporary) == ["deploy.fmu.too_large"]


def test_bomb_with_a_false_size(poppet, tanks, temporary, tmp_path):
    """The declared size is small, but the content is not."""
    write_fmu(tmp_path / "m.fmu")
    with zipfile.ZipFile(tmp_path / "m.fmu", "a", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("resources/zeros", bytes(10**6))
    content = (tmp_path / "m.fmu").read_bytes()
    size = (10**6).to_bytes(4, "little")
    assert size in content
    (tmp_path / "m.fmu").write_bytes(content.replace(size, (10).to_bytes(4, "little")))
    assert rejected(poppet, tanks, temporary) == ["deploy.fmu.damaged"]


def test_too_many_entries(poppet, tanks, temporary, tmp_path):
    write_fmu(tmp_path / "m.fmu", *(f"resources/{k}" for k in range(10_000)))
    assert rejected(poppet, tanks, temporary) == ["deploy.fmu.too_large"]


def test_entry_that_occurs_twice(poppet, tanks, temporary, tmp_path):
    write_fmu(tmp_path / "m.fmu", "resources/a", "resources/A")
    assert rejected(poppet, tanks, temporary) == ["deploy.fmu.entry_twice"]


@pytest.mark.parametrize("description", [ENTITIES, "<", "", '<fmiModelDescription fmiVersion="9.0"/>'])
def test_invalid_description(poppet, tanks, temporary, tmp_path, description):
    write_fmu(tmp_path / "m.fmu", description=description)
    assert rejected(poppet, tanks, temporary) == ["deploy.fmu.no_fmu"]


@pytest.mark.parametrize(
    ("entry", "content", "code"),
    [
        ("resources/circuit.toml", b"\xff\xfe\x00", "toml.no_text"),
        ("resources/circuit.toml", bytes(17 * 2**20), "toml.too_large"),
        ("resources/circuit.toml", b"parts = 5", "circuit.no_table"),
        ("resources/changes.toml", b"= 5", "toml.invalid"),
    ],
)
def test_invalid_circuit_in_the_archive(poppet, tanks, temporary, tmp_path, entry, content, code):
    write_fmu(tmp_path / "m.fmu")
    with zipfile.ZipFile(tmp_path / "m.fmu", "a", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(entry, content)
        if entry != "resources/circuit.toml":
            archive.writestr("resources/circuit.toml", tanks.read_bytes())
    answer = poppet("export", "check", "m.fmu")
    assert answer.code == 2
    assert code in answer.codes
    assert list(temporary.iterdir()) == []


@pytest.mark.parametrize("fmi", [2, 3])
def test_own_fmus_are_valid(tanks, tmp_path, fmi):
    path = tmp_path / "own.fmu"
    path.write_bytes(zip_bytes(build_fmu(load(tanks), fmi=fmi).content))
    assert check_archive(path) == fmi
