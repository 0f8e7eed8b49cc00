"""`poppet edit`: its output, its end, a second server, and the packages that it does not need."""

from __future__ import annotations

import http.client
import re
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import pytest

ADDRESS = re.compile(r"http://127\.0\.0\.1:(\d+)/\?token=([\w-]{32})\n")
WITHOUT_PLOTS = (
    "import sys; sys.modules.update(matplotlib=None, pandas=None); from poppet.cli.main import run; sys.exit(run())"
)


@contextmanager
def started(
    folder: Path, *arguments: str, command: Sequence[str] = ()
) -> Iterator[tuple[subprocess.Popen[str], int, str]]:
    """Process, port and token of a server."""
    command = command or [sys.executable, "-W", "error", "-c", WITHOUT_PLOTS, "edit", "--no-browser", *arguments]
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, cwd=folder, stdout=pipe, stderr=pipe, text=True)
    assert process.stdout is not None
    try:
        match = ADDRESS.fullmatch(process.stdout.readline())
        assert match, process.communicate()
        yield process, int(match[1]), match[2]
    finally:
        process.kill()
        process.communicate()


def read(port: int, token: str, *paths: str) -> list[bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
    connection.request("GET", f"/?token={token}")
    reply = connection.getresponse()
    reply.read()
    bodies = []
    for path in paths:
        connection.request("GET", path, headers={"Cookie": reply.headers["Set-Cookie"]})
        answer = connection.getresponse()
        bodies.append(answer.read())
        assert answer.status == 200, bodies
    connection.close()
    return bodies


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_server_without_matplotlib_and_pandas_ends_by_a_signal(poppet, tmp_path, number):
    assert poppet("new", "cylinder").code == 0
    with started(tmp_path, "cylinder.toml") as (process, port, token):
        document, model, *_ = read(port, token, "/document", "/model?revision=1", "/", "/palette", "/start")
        assert b'"errors": []' in document
        assert model[:8] == b"POPPETM1"
        process.send_signal(number)
        assert process.communicate(timeout=30) == ("", "")
        assert process.returncode == 0


def test_python_files_beside_a_circuit_are_not_executed(poppet, tmp_path):
    poppet("new", "two-tanks")
    mark = tmp_path / "executed"
    for name in ("numpy", "casadi", "llvmlite", "tomlkit", "gzip", "sitecustomize"):
        (tmp_path / f"{name}.py").write_text(f"open({str(mark)!r}, 'w')\n")
    command = [sys.executable, "-m", "poppet", "edit", "two-tanks.toml", "--no-browser"]
    with started(tmp_path, command=command) as (_, port, token):
        assert read(port, token, "/document", "/model?revision=1")[1][:8] == b"POPPETM1"
    assert not mark.exists()


def test_a_second_server_needs_another_port(poppet, tmp_path):
    with started(tmp_path) as (_, port, token):
        answer = poppet("edit", "--no-browser", "--port", str(port))
        assert (answer.code, answer.out, answer.codes) == (2, "", ["edit.port"])
        with started(tmp_path) as (_, other_port, other_token):
            assert (other_port, other_token) != (port, token)
            assert b'"revision"' in read(other_port, other_token, "/document")[0]
        assert b'"revision"' in read(port, token, "/document")[0]


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["--port", "70000"], "edit.port"),
        (["--port", "-1"], "edit.port"),
        (["--port", "x"], "cli.usage"),
        (["plant.csv"], "files.suffix"),
        (["missing/plant.toml"], "files.no_folder"),
        (["latin.toml"], "toml.no_text"),
    ],
)
def test_wrong_arguments(poppet, tmp_path, arguments, code):
    (tmp_path / "latin.toml").write_bytes("title = 'Prüfstand'".encode("latin-1"))
    answer = poppet("edit", "--no-browser", *arguments)
    assert (answer.code, answer.codes, answer.out) == (2, [code], "")
