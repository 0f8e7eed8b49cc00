"""Tests of paths that are no files, and of disks and folders that cannot be written."""

from __future__ import annotations

import csv
import errno
import io
import os
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

import poppet.core.files as core_files
from poppet.timeseries.recording import Recording

READERS = {
    "check": ("check", "IN.toml"),
    "simulate": ("simulate", "IN.toml"),
    "show": ("show", "IN.toml"),
    "draw": ("draw", "IN.toml", "-o", "out.svg"),
    "start": ("simulate", "tanks.toml", "--start-from", "IN.csv"),
    "with": ("simulate", "tanks.toml", "--with", "IN.json"),
    "plot csv": ("plot", "IN.csv"),
    "plot parquet": ("plot", "IN.parquet"),
    "plot mat": ("plot", "IN.mat"),
    "at": ("linearise", "tanks.toml", "--at", "IN.csv"),
    "ensemble": ("ensemble", "IN.toml"),
    "size": ("size", "IN.toml", "--free", "high.volume"),
    "fit": ("identify", "fit", "IN.toml"),
    "tank": ("identify", "tank", "IN.toml"),
    "flow": ("identify", "flow", "IN.toml"),
    "bench": ("bench", "iso10094", "IN.toml"),
    "recordings": ("bench", "iso10094", "--recording", "IN.toml"),
    "result": ("bench", "iso10094", "IN.json"),
    "limits": ("bench", "limits", "IN.toml"),
    "tune": ("control", "tune", "IN.toml"),
    "compare": ("control", "compare", "tanks.toml", "IN.toml"),
    "live": ("live", "IN.toml", "-o", "out.html"),
    "c": ("export", "c", "IN.toml", "-o", "out"),
    "circuit of fmu": ("export", "check", "IN.toml"),
    "fmu": ("export", "check", "IN.fmu"),
}
WRITERS = {
    "csv": ("simulate", "tanks.toml", "-o", "OUT.csv"),
    "mat": ("simulate", "tanks.toml", "-o", "OUT.mat"),
    "plot": ("simulate", "tanks.toml", "--plot", "OUT.svg"),
    "report": ("simulate", "tanks.toml", "--report", "OUT.html"),
    "draw": ("draw", "tanks.toml", "-o", "OUT.svg"),
    "linearise": ("linearise", "tanks.toml", "-o", "OUT.json"),
    "new": ("new", "two-tanks", "-o", "OUT.toml"),
    "schema": ("schema", "-o", "OUT.json"),
    "c": ("export", "c", "tanks.toml", "-o", "OUT"),
    "live": ("live", "tanks.toml", "-o", "OUT.html"),
}


def _make(path: Path, kind: str) -> None:
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "socket":
        with socket.socket(socket.AF_UNIX) as server:
            server.bind(path.name)
    elif kind == "folder":
        path.mkdir()
    else:
        path.symlink_to("/dev/zero")


@pytest.fixture(autouse=True)
def limit():
    """A command that waits for a pipe or reads a device without end fails after half a minute."""
    signal.signal(signal.SIGALRM, lambda *_: pytest.fail("the command waits"))
    signal.alarm(30)
    yield
    signal.alarm(0)


@pytest.mark.skipif(sys.platform == "win32", reason="no named pipes in folders")
@pytest.mark.parametrize("kind", ["pipe", "socket", "folder", "device"])
@pytest.mark.parametrize("name", READERS)
def test_what_is_no_file_is_rejected_at_once(poppet, tanks, tmp_path, name, kind):
    arguments = READERS[name]
    (path,) = (argument for argument in arguments if argument.startswith("IN"))
    _make(tmp_path / path, kind)
    answer = poppet(*arguments)
    assert (answer.code, answer.codes) == (2, ["files.no_file"])
    assert (answer.error.facts["path"], answer.error.facts["kind"]) == (path, kind)
    assert sorted(file.name for file in tmp_path.iterdir()) == sorted([path, "tanks.toml"])


@pytest.mark.parametrize("name", WRITERS)
def test_output_does_not_replace_a_device(poppet, tanks, tmp_path, name):
    *arguments, output = WRITERS[name]
    (tmp_path / output).symlink_to("/dev/full")
    answer = poppet(*arguments, output)
    assert answer.code == 2
    assert answer.codes == (["deploy.folder_taken"] if name == "c" else ["files.no_file"])
    assert Path("/dev/full").is_char_device()


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize("character", ["\n", "\t", "\x1b", "\x7f"])
def test_control_character_in_a_path(poppet, tanks, tmp_path, name, character):
    *arguments, output = WRITERS[name]
    answer = poppet(*arguments, output.replace("OUT", f"a{character}b"))
    assert (answer.code, answer.codes) == (2, ["files.control_character"])
    assert len(answer.err.splitlines()) == 2
    assert [file.name for file in tmp_path.iterdir()] == ["tanks.toml"]


@pytest.mark.parametrize("name", READERS)
def test_control_character_in_the_path_of_an_input(poppet, tanks, name):
    answer = poppet(*(argument.replace("IN.", "a\nb.") for argument in READERS[name]))
    assert (answer.code, answer.codes) == (2, ["files.control_character"])
    assert len(answer.err.splitlines()) == 2


@pytest.mark.parametrize("name", WRITERS)
def test_path_below_a_file(poppet, tanks, tmp_path, name):
    (tmp_path / "file").write_text("text", encoding="utf-8")
    *arguments, output = WRITERS[name]
    answer = poppet(*arguments, f"file/{output}")
    assert (answer.code, answer.codes) == (2, ["files.below_file"])
    assert (tmp_path / "file").read_text(encoding="utf-8") == "text"
    assert sorted(file.name for file in tmp_path.iterdir()) == ["file", "tanks.toml"]


class _FullDisk(io.BytesIO):
    """File that accepts some bytes and then fails."""

    def __init__(self, path: Path, number: int) -> None:
        super().__init__()
        path.touch()  # as a real file that is incomplete
        self.number = number

    def write(self, data: object) -> int:
        raise OSError(self.number, os.strerror(self.number))


@pytest.mark.parametrize(
    ("number", "code"),
    [(errno.ENOSPC, "files.full"), (errno.EACCES, "files.unwritable"), (errno.EROFS, "files.unwritable")],
)
@pytest.mark.parametrize("name", [name for name in WRITERS if name != "c"])
def test_full_disk_and_read_only_folder(poppet, tanks, tmp_path, monkeypatch, name, number, code):
    *arguments, output = WRITERS[name]
    (tmp_path / output).write_bytes(b"old")
    open_path = Path.open

    def opened(path, mode="r", *rest, **options):
        return _FullDisk(path, number) if mode == "xb" else open_path(path, mode, *rest, **options)

    monkeypatch.setattr(core_files.Path, "open", opened)
    answer = poppet(*arguments, output, *(["--force"] if name == "new" else []))
    assert (answer.code, answer.codes) == (2, [code])
    assert answer.error.facts["why"] == os.strerror(number)
    assert (tmp_path / output).read_bytes() == b"old"
    assert sorted(file.name for file in tmp_path.iterdir()) == sorted([output, "tanks.toml"])


@pytest.mark.parametrize(("number", "code"), [(errno.ENOSPC, "files.full"), (errno.EACCES, "files.unwritable")])
def test_export_to_a_full_disk_leaves_nothing(poppet, tanks, tmp_path, monkeypatch, number, code):
    write = Path.write_bytes

    def written(path, data):
        if path.suffix == ".h":
            raise OSError(number, os.strerror(number))
        return write(path, data)

    monkeypatch.setattr(Path, "write_bytes", written)
    answer = poppet("export", "c", "tanks.toml", "-o", "out")
    assert (answer.code, answer.codes) == (2, [code])
    assert [file.name for file in tmp_path.iterdir()] == ["tanks.toml"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no such device")
@pytest.mark.parametrize("arguments", [("library",), ("show", "tanks.toml"), ("schema",)])
def test_standard_output_on_a_full_disk(tanks, tmp_path, arguments):
    with open("/dev/full", "wb") as full:
        run = subprocess.run(
            [sys.executable, "-m", "poppet", *arguments], cwd=tmp_path, stdout=full, stderr=subprocess.PIPE, check=False
        )
    assert run.returncode == 2
    assert run.stderr.decode().splitlines() == [f"error: {os.strerror(errno.ENOSPC)}."]


HOSTILE = '=HYPERLINK("http://x", "y")'


def test_tables_of_control_compare_quote_names(poppet, tmp_path):
    source = Path(__file__).parents[2] / "examples" / "pressure_control.toml"
    for name in (f"{HOSTILE.replace('/', '_')}.toml", "a,b.toml"):
        (tmp_path / name).write_bytes(source.read_bytes())
    names = [f"{HOSTILE.replace('/', '_')}.toml", "a,b.toml"]
    answer = poppet("control", "compare", *names, "--draws", "1", "--vary", "tank.volume=5 %", "-o", "out.csv")
    assert answer.code == 0, answer.err
    rows = list(csv.reader(io.StringIO((tmp_path / "out.csv").read_text(encoding="utf-8"), newline="")))
    assert len({len(row) for row in rows}) == 1
    controllers = {row[0] for row in rows[1:]}
    assert len(controllers) == 2
    assert not any(name.startswith(("=", "+", "-", "@")) for name in controllers)
    assert any("," in name for name in controllers)


def test_recordings_with_hostile_names_are_plotted(poppet, tmp_path):
    recording = Recording.from_series([0.0, 1.0, 2.0], {HOSTILE: [1.0, 2.0, 3.0], "a\nb, c": [1.0, -2.0, 3.0]})
    recording.save(tmp_path / "out.csv")
    assert Recording.read(tmp_path / "out.csv").names == (HOSTILE, "a\nb, c")
    assert poppet("plot", "out.csv", "-o", "out.svg").code == 0
