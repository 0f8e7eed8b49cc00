"""Files are written whole or not at all, and what a kill leaves does not stay."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from poppet import library
from poppet.core.files import check_path, confined_to, write_whole
from poppet.library import components
from refusals import refused

KILLED = """
import os, sys
from pathlib import Path
from poppet.core.files import write_whole
write_whole(Path(sys.argv[1]), lambda stream: (stream.write(b"half"), stream.flush(), os._exit(9)))
"""


def written(path, text=b"whole"):
    return write_whole(path, lambda stream: stream.write(text))


@pytest.mark.skipif(os.name != "posix", reason="where processes can be asked for")
@pytest.mark.parametrize("name", ["o.csv", "[o]*.csv"])
def test_next_write_removes_files_of_a_killed_process(tmp_path, name):
    path = tmp_path / name
    assert subprocess.run([sys.executable, "-c", KILLED, path], check=False).returncode == 9
    (half,) = tmp_path.iterdir()
    assert half.name.startswith(f".{name}.")
    written(path)
    assert [each.name for each in tmp_path.iterdir()] == [name]
    assert path.read_bytes() == b"whole"


def test_temporary_files_of_running_processes_remain(tmp_path):
    path = tmp_path / "o.csv"

    def fill(stream):
        (own,) = tmp_path.glob(".o.csv.*")
        elsewhere = own.with_name(own.name.replace(".o.csv.", ".o.csv.0", 1))
        other_file = own.with_name(own.name.replace("o.csv", "o.csv.csv"))
        elsewhere.touch()
        other_file.touch()
        written(path, b"inner")
        assert own.exists()
        assert elsewhere.exists()
        assert other_file.exists()
        stream.write(b"outer")

    write_whole(path, fill)
    assert path.read_bytes() == b"outer"


def test_failure_does_not_change_the_file(tmp_path):
    path = written(tmp_path / "o.csv")

    def fails(stream):
        stream.write(b"half")
        raise ValueError("no more")

    with pytest.raises(ValueError, match="no more"):
        write_whole(path, fails)
    assert [(each.name, each.read_bytes()) for each in tmp_path.iterdir()] == [("o.csv", b"whole")]


def test_files_are_confined_to_folders(tmp_path):
    inner, other = tmp_path / "inner", tmp_path / "other"
    for folder in (inner, other, inner / "deep"):
        folder.mkdir()
    (inner / "link").symlink_to(tmp_path)
    outside = (tmp_path / "x.csv", inner / ".." / "x.csv", inner / "link" / "x.csv", tmp_path / "inner2" / "x.csv")
    with confined_to(inner, other):
        for path in (inner / "x.csv", inner / "deep" / "x.csv", other / "x.csv", inner / "link" / "other" / "x.csv"):
            check_path(path)
        for path in outside:
            with refused("files.outside", path=str(path), folder=str(inner.resolve())):
                check_path(path)
        with refused("files.outside"):
            write_whole(tmp_path / "x.csv", lambda stream: stream.write(b"1"))
        with confined_to(other), refused("files.outside"):
            check_path(inner / "x.csv")
        with confined_to():
            check_path(tmp_path / "x.csv")
        check_path(inner / "x.csv")
    for path in outside:
        check_path(path)
    assert not (tmp_path / "x.csv").exists()


def test_the_library_is_not_confined(tmp_path):
    components._components.cache_clear()
    components._by_name.cache_clear()
    with confined_to(tmp_path):
        assert components.components()
        assert library.sets()
