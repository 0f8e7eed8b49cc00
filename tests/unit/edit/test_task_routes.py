"""Requests of the page to the tasks, over HTTP."""

from __future__ import annotations

import http.client
import json
import re
import signal
import threading
import time
from contextlib import suppress
from pathlib import Path

import pytest

from editor_page import Server
from poppet.edit.server import EditServer
from poppet.edit.session import Session
from poppet.edit.tasks.manager import Tasks
from poppet.edit.tasks.routes import task_routes

TANK = """
[parts.tank]
kind = "chamber"
volume = "1 l"
initial_pressure = "6 bar g"
[parts.leak]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 1e-9
critical_ratio = 0.3
[run]
duration = "1 s"
"""


@pytest.fixture
def ask(tmp_path):
    """Return a function that sends a request as the page does."""
    (tmp_path / "plant.toml").write_text(TANK, encoding="utf-8")
    session = Session(tmp_path / "plant.toml")
    with Tasks() as tasks, EditServer(0, [task_routes(session, tasks)]) as server:
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        host = f"127.0.0.1:{server.server_port}"
        headers = {"Cookie": f"{server.cookie}={server.secret}", "Origin": f"http://{host}"}

        def send(method, path, content=None, media_type="application/json"):
            connection = http.client.HTTPConnection(host, timeout=60)
            body = json.dumps(content) if media_type == "application/json" and content is not None else content
            connection.request(method, path, body, headers | {"Content-Type": media_type})
            reply = connection.getresponse()
            data = reply.read()
            connection.close()
            is_json = reply.getheader("Content-Type") == "application/json"
            return reply.status, json.loads(data) if is_json else data, reply

        send.folder, send.session = tmp_path, session
        yield send
        server.shutdown()
        thread.join()


def children_of(pid):
    """Return the processes that a process has started."""
    lists = Path(f"/proc/{pid}/task").glob("*/children")
    return [int(child) for path in lists for child in path.read_text().split()]


def is_alive(pid):
    with suppress(OSError):
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    return False


def finish(ask, identifier):
    while (content := ask("GET", f"/tasks/{identifier}")[1])["state"] == "running":
        time.sleep(0.02)
    return content


def test_a_result_is_shown_without_rights_and_kept_in_the_folder(ask):
    status, content, _ = ask("POST", "/tasks", {"task": "export", "options": {"target": "live"}})
    assert status == 200
    content = finish(ask, content["id"])
    assert (content["state"], content["files"]) == ("done", ["1-plant.html"])
    status, page, reply = ask("GET", "/files/1-plant.html?view=1")
    policy = reply.getheader("Content-Security-Policy")
    assert (status, page[:15]) == (200, b"<!DOCTYPE html>")
    assert policy.startswith("sandbox allow-scripts allow-downloads; default-src 'none'")
    assert "allow-same-origin" not in policy
    assert reply.getheader("Content-Disposition") is None
    *_, reply = ask("GET", "/files/1-plant.html")
    assert reply.getheader("Content-Disposition") == 'attachment; filename="plant.html"'
    assert ask("POST", "/tasks/keep", {"file": "1-plant.html"})[:2] == (200, {"name": "plant.html"})
    status, content, _ = ask("POST", "/tasks/keep", {"file": "1-plant.html"})
    assert (status, content["errors"][0]["code"]) == (422, "edit.file_exists")
    assert (ask.folder / "plant.html").read_bytes() == page
    assert [task["id"] for task in ask("GET", "/tasks")[1]["tasks"]] == ["1"]
    assert ask("POST", "/tasks/1/cancel", {})[1]["state"] == "done"


@pytest.mark.parametrize(
    ("path", "content", "code"),
    [
        ("/tasks", {}, "fields.not_an_option"),
        ("/tasks", {"task": "report", "options": "x"}, "fields.no_table"),
        ("/tasks", {"task": "report", "options": {"file": "/etc/passwd"}}, "fields.unknown"),
        ("/tasks/keep", {"file": "plant.toml"}, "names.unknown"),
        ("/tasks/keep", {"file": 3}, "edit.no_request"),
        ("/tasks/9/cancel", {}, "names.unknown"),
    ],
)
def test_invalid_requests(ask, path, content, code):
    status, reply, _ = ask("POST", path, content)
    assert (status, reply["errors"][0]["code"]) == (422, code)


@pytest.mark.parametrize("name", ["plant.toml", "..%2fplant.toml", "1-plant.html", "%2e%2e/plant.toml"])
def test_only_results_are_sent(ask, name):
    assert ask("GET", f"/files/{name}")[0] == 404


def test_uploads(ask):
    kind = "application/octet-stream"
    assert ask("POST", "/upload?name=run%201.csv", b"t,p\n", kind)[:2] == (200, {"name": "run_1.csv"})
    assert ask("POST", "/upload?name=run.csv", b"t,p\n", "text/plain")[0] == 415
    assert ask("POST", "/upload", b"t,p\n", kind)[1]["errors"][0]["code"] == "edit.file_name"
    assert not (ask.folder / "run_1.csv").exists()
    assert ask("POST", "/upload?name=empty.csv", b"", kind)[0] == 200


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="needs the list of processes of Linux")
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_a_task_ends_with_the_server(tmp_path, number):
    folder = tmp_path / "work"
    folder.mkdir()
    long = TANK.replace('"1 s"', '"1 h"\noutput_step = "1 ms"')
    (folder / "plant.toml").write_text(long, encoding="utf-8")
    server = Server(folder, "plant.toml")
    try:
        host, token = re.fullmatch(r"http://([\d.:]+)(/\S+)", server.address).groups()
        connection = http.client.HTTPConnection(host, timeout=60)
        connection.request("GET", token)
        reply = connection.getresponse()
        reply.read()
        headers = {"Cookie": reply.getheader("Set-Cookie").partition(";")[0], "Content-Type": "application/json"}
        connection.request("POST", "/tasks", json.dumps({"task": "report"}), headers | {"Origin": f"http://{host}"})
        assert connection.getresponse().read() == b'{"id": "1"}'
        connection.close()
        children = children_of(server.process.pid)
        assert children
        server.process.send_signal(number)
        limit = time.monotonic() + 60.0
        while any(is_alive(pid) for pid in children):
            assert time.monotonic() < limit
            time.sleep(0.02)
    finally:
        server.stop()


def test_facts_and_their_errors(ask):
    status, facts, _ = ask("GET", "/tasks/facts")
    assert status == 200
    assert facts["outputs"]["tank.pressure"] == "Pa"
    assert facts["parameters"]["tank.initial_pressure"]["text"] == "6 bar g"
    ask.session.apply(ask.session.history.revision, [{"op": "disconnect", "port": "leak.to"}])
    status, content, _ = ask("GET", "/tasks/facts")
    assert (status, content["errors"][0]["code"]) == (422, "fields.missing_port")
