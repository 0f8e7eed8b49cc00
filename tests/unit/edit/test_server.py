"""Server of the editor by `http.client`: refusals, files of the page, replies, and two pages with one file."""

from __future__ import annotations

import gzip
import http.client
import json
import socket
import struct
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from threading import Thread
from typing import Any, ClassVar, NamedTuple

import numpy as np
import pytest

from poppet.cli.circuit_files import TEMPLATES
from poppet.edit.routes import PAGE, page_routes, session_routes
from poppet.edit.server import BYTES, LARGEST_BODY, EditServer, Reply, Request, Route
from poppet.edit.session import Session
from poppet.engine.solve import solve

TANKS = TEMPLATES["two-tanks"].read_text(encoding="utf-8")


class Answer(NamedTuple):
    """Status, headers and body of a reply."""

    status: int
    headers: http.client.HTTPMessage
    body: bytes

    @property
    def json(self) -> Any:
        return json.loads(self.body)


class Page:
    """Requests of a page, on one connection."""

    opened: ClassVar[list[Page]] = []

    def __init__(self, server: EditServer) -> None:
        self.opened.append(self)
        self.origin = f"http://127.0.0.1:{server.server_port}"
        self.connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=20)
        self.cookie = ""

    def request(self, method: str, path: str, body: Any = None, **headers: str | None) -> Answer:
        """Send a request with the headers of a browser; headers with the value None are omitted."""
        fields = {"Cookie": self.cookie, "Origin": self.origin, "Content-Type": "application/json"}
        if method == "GET":
            fields = {"Cookie": self.cookie}
        named = {name.replace("_", "-"): value for name, value in headers.items()}
        data = body if isinstance(body, bytes | None) else json.dumps(body).encode()
        sent = {name: value for name, value in {**fields, **named}.items() if value}
        self.connection.request(method, path, data, sent)
        reply = self.connection.getresponse()
        return Answer(reply.status, reply.headers, reply.read())

    def get(self, path: str, **headers: str | None) -> Answer:
        return self.request("GET", path, **headers)

    def post(self, path: str, body: Any = None, **headers: str | None) -> Answer:
        return self.request("POST", path, {} if body is None else body, **headers)

    def log_in(self, server: EditServer) -> Page:
        answer = self.get(server.address.removeprefix(self.origin))
        assert answer.status == 303
        self.cookie = answer.headers["Set-Cookie"].partition(";")[0]
        return self


@pytest.fixture
def session(tmp_path: Path) -> Session:
    (tmp_path / "folder").mkdir()
    path = tmp_path / "folder" / "plant.toml"
    path.write_text(TANKS, encoding="utf-8")
    return Session(path, TEMPLATES)


@pytest.fixture
def server(session: Session) -> Iterator[EditServer]:
    def fail(_: Request) -> Reply:
        raise ZeroDivisionError("defect")

    more = {
        ("POST", "/upload"): Route(lambda r: Reply.json(len(r.body)), media_type=BYTES, largest=2 * LARGEST_BODY),
        ("GET", "/things/{name}/{part}"): Route(lambda r: Reply.json([dict(r.names), dict(r.query)])),
        ("GET", "/defect"): Route(fail),
    }
    with EditServer(0, [page_routes(), session_routes(session), more]) as server:
        thread = Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield server
        while Page.opened:
            Page.opened.pop().connection.close()
        server.shutdown()
        thread.join()


@pytest.fixture
def page(server: EditServer) -> Page:
    return Page(server).log_in(server)


# --- Refusals ---


@pytest.mark.parametrize(
    ("status", "method", "path", "headers"),
    [
        (403, "GET", "/", {"Cookie": None}),
        (403, "GET", "/document", {"Cookie": None}),
        (403, "GET", "/www/editor.js", {"Cookie": None}),
        (403, "GET", "/missing", {"Cookie": None}),
        (403, "GET", "/document", {"Cookie": "poppet_edit=x"}),
        (403, "GET", "/document", {"Cookie": "\x7f;=;;"}),
        (403, "GET", "/document", {"Host": "evil.example"}),
        (403, "GET", "/document", {"Host": "127.0.0.1"}),
        (403, "GET", "/document", {"Host": "127.0.0.1.evil.example:80"}),
        (403, "GET", "/document", {"Origin": "http://evil.example"}),
        (403, "GET", "/document", {"Origin": "null"}),
        (403, "POST", "/save", {"Cookie": None}),
        (403, "POST", "/save", {"Host": "evil.example"}),
        (403, "POST", "/save", {"Origin": "http://evil.example"}),
        (403, "POST", "/save", {"Origin": "null"}),
        (415, "POST", "/save", {"Origin": None}),
        (415, "POST", "/save", {"Content_Type": None}),
        (415, "POST", "/save", {"Content_Type": "text/plain"}),
        (415, "POST", "/save", {"Content_Type": "application/x-www-form-urlencoded"}),
        (415, "POST", "/save", {"Content_Type": BYTES}),
        (415, "POST", "/upload", {}),
        (404, "GET", "/../", {}),
        (404, "GET", "/%2e%2e/", {}),
        (404, "GET", "/www/../session.py", {}),
        (404, "GET", "/www/%2e%2e/session.py", {}),
        (404, "GET", "/www/..%2fsession.py", {}),
        (404, "GET", "/www/%2fetc%2fpasswd", {}),
        (404, "GET", "//etc/passwd", {}),
        (404, "GET", "/www/", {}),
        (404, "GET", "/www/editor.js%00", {}),
        (404, "GET", "/%ff", {}),
        (404, "GET", "/missing", {}),
        (404, "GET", "/save", {}),
        (404, "POST", "/document", {}),
    ],
)
def test_refusals(page, session, status, method, path, headers):
    body = {"revision": session.history.revision, "name": "stolen.toml"} if method == "POST" else None
    answer = page.request(method, path, body, **headers)
    assert answer.status == status
    assert [file.name for file in session.folder.iterdir()] == ["plant.toml"]
    assert b"passwd" not in answer.body
    # The connection is still usable: the body of the request is not the next request.
    assert page.get("/status").status == 200


def test_an_invalid_address_is_refused(server, capfd):
    with socket.create_connection(("127.0.0.1", server.server_port), timeout=20) as connection:
        connection.sendall(b"GET http://[ HTTP/1.1\r\nHost: evil.example\r\n\r\n")
        assert connection.recv(12) == b"HTTP/1.1 403"
    assert capfd.readouterr().err == ""


def test_the_token_is_valid_once(server, page):
    path = server.address.removeprefix(page.origin)
    assert page.get(path).status == 303  # the browser that has the cookie can open the address again
    other = Page(server)
    reply = other.get(path)
    assert (reply.status, b"start poppet edit again" in reply.body) == (403, True)
    assert other.get("/?token=").status == 403
    assert other.get("/?token=%ff").status == 403
    assert other.get("/document").status == 403


def test_a_wrong_token_does_not_use_up_the_right_one(server):
    page = Page(server)
    assert page.get("/?token=wrong").status == 403
    assert page.get(server.address.removeprefix(page.origin), Host="evil.example").status == 403
    assert page.log_in(server).get("/document").status == 200


def test_the_cookie(server):
    page = Page(server)
    answer = page.get(server.address.removeprefix(page.origin))
    assert (answer.status, answer.headers["Location"]) == (303, "/")
    cookie, *attributes = answer.headers["Set-Cookie"].split("; ")
    assert {*attributes} == {"HttpOnly", "SameSite=Strict", "Path=/"}
    # Cookies are not separate for ports: servers of one computer need different names.
    assert str(server.server_port) in cookie.partition("=")[0]
    token = server.address.partition("token=")[2]
    assert len(token) == 32  # 192 bits
    assert token not in cookie


@pytest.mark.parametrize("path", ["/", "/www/uPlot.js", "/palette", "/document", "/missing"])
def test_headers_of_all_replies(page, path):
    headers = page.get(path).headers
    policy = dict(item.split(" ", 1) for item in headers["Content-Security-Policy"].split("; "))
    assert policy["default-src"] == policy["frame-ancestors"] == policy["base-uri"] == "'none'"
    assert policy["script-src"] == "'self' 'wasm-unsafe-eval'"
    assert policy["style-src"] == policy["connect-src"] == "'self'"
    assert headers["X-Content-Type-Options"] == "nosniff"
    assert headers["Cache-Control"] == "no-store"
    assert "Access-Control-Allow-Origin" not in headers


def test_bodies_that_are_too_large(page):
    assert page.post("/text", {"revision": 0, "text": "x" * LARGEST_BODY}).status == 413
    assert page.post("/text", b"x" * (8 * LARGEST_BODY), Cookie=None).status == 403
    assert page.get("/status").status == 200
    assert page.post("/upload", b"x" * (LARGEST_BODY + 1), Content_Type=BYTES).json == LARGEST_BODY + 1


@pytest.mark.parametrize(
    ("status", "header"),
    [
        (413, {"Content-Length": "99999999999999999999"}),
        (411, {"Content-Length": "-1"}),
        (411, {"Content-Length": "1e3"}),
        (411, {"Content-Length": "\xb2"}),
        (411, {"Transfer-Encoding": "chunked"}),
    ],
)
def test_bodies_without_a_valid_length(page, status, header):
    page.connection.putrequest("POST", "/text")
    headers = {"Origin": page.origin, "Cookie": page.cookie, "Content-Type": "application/json"}
    for name, value in (headers | header).items():
        page.connection.putheader(name, value)
    page.connection.endheaders()
    reply = page.connection.getresponse()
    assert (reply.status, reply.headers["Connection"]) == (status, "close")


@pytest.mark.parametrize("body", [b"", b"{", b"[]", b"1", b"\xff", b"[" * 100000])
def test_bodies_that_are_no_objects(page, body):
    assert page.post("/text", body).status == 400
    assert page.get("/status").status == 200


@pytest.mark.parametrize("method", ["PUT", "DELETE", "OPTIONS", "PATCH", "TRACE", "HEAD"])
def test_other_methods(page, method):
    answer = page.request(method, "/document")
    assert answer.status == 501
    assert "Access-Control-Allow-Origin" not in answer.headers
    assert "default-src 'none'" in answer.headers["Content-Security-Policy"]


@pytest.mark.parametrize("line", [b"GET /", b"GET / HTTP/9", b"\x16\x03\x01", b"GET /" + b"a" * 70000, b"GET / HTTP/x"])
def test_requests_that_are_no_http(server, page, line, capfd):
    with (
        socket.create_connection(("127.0.0.1", server.server_port), timeout=10) as connection,
        suppress(ConnectionError),
    ):
        connection.sendall(line + b"\r\n\r\n")
        while connection.recv(1000):
            pass
    assert page.get("/status").status == 200
    assert capfd.readouterr().err == ""


# --- Files of the page ---


def test_files_of_the_page(page):
    for path in PAGE.iterdir():
        if path.suffix in (".html", ".js", ".css", ".svg", ".wasm"):
            answer = page.get(f"/www/{path.name}")
            assert (answer.status, answer.body) == (200, path.read_bytes())
            assert "Content-Encoding" not in answer.headers
    assert page.get("/").body == (PAGE / "index.html").read_bytes()
    for name in ("uPlot.js", "uPlot.css", "kernel.js"):
        assert page.get(f"/www/{name}").status == 200


def test_compression(page):
    plain, packed = page.get("/palette"), page.get("/palette", Accept_Encoding="gzip, br")
    assert packed.headers["Content-Encoding"] == "gzip"
    assert gzip.decompress(packed.body) == plain.body
    assert len(packed.body) < len(plain.body) / 4


def test_the_transfer_of_the_page_is_small(page):
    names = [path.name for path in PAGE.iterdir()] + ["uPlot.js", "uPlot.css", "kernel.js"]
    paths = ["/", "/palette", "/document", *(f"/www/{name}" for name in names if name != "index.html")]
    assert sum(len(page.get(path, Accept_Encoding="gzip").body) for path in paths) < 600_000


# --- Requests ---


def test_routes_with_names(page):
    assert page.get("/things/a%20b/c?x=1&x=2").json == [{"name": "a b", "part": "c"}, {"x": "2"}]
    assert page.get("/things/a").status == 404


def test_a_defect_is_an_error_of_the_page(page):
    answer = page.get("/defect")
    assert answer.status == 500
    assert "ZeroDivisionError: defect" in answer.json["errors"][0]["message"]
    assert page.get("/status").status == 200


def test_changes(page, session):
    revision = page.get("/document").json["revision"]
    state = page.post("/apply", {"revision": revision, "operations": [{"op": "add", "kind": "orifice"}]}).json
    assert state["created"] == ["orifice"]
    undone = page.post("/undo", {"revision": state["revision"]}).json
    assert undone["text"] == TANKS
    redone = page.post("/redo", {"revision": undone["revision"]}).json
    assert redone["text"] == state["text"]
    typed = page.post("/text", {"revision": redone["revision"], "text": "title = 'x'"}).json
    assert typed["view"]["title"] == "x"
    saved = page.post("/save", {"revision": typed["revision"]}).json
    assert not saved["dirty"]
    assert (session.folder / "plant.toml").read_text() == "title = 'x'"
    start = page.get("/start").json
    assert {template["name"] for template in start["templates"]} == {*TEMPLATES}
    opened = page.post("/open", {"template": "vacuum"}).json
    assert (opened["name"], opened["errors"]) == (None, [])


@pytest.mark.parametrize(
    ("path", "body", "codes"),
    [
        ("/apply", {"revision": 1}, ["edit.no_request"]),
        ("/apply", {"revision": True, "operations": []}, ["edit.no_request"]),
        ("/apply", {"revision": 1, "operations": [1]}, ["edit.no_operation"]),
        ("/apply", {"revision": 1, "operations": [{"op": "add", "kind": "orifise"}]}, ["fields.not_an_option"]),
        ("/apply", {"revision": 1, "operations": [{"op": "rename", "part": "x", "name": "y"}]}, ["names.unknown"]),
        ("/apply", {"revision": 1, "operations": [{"op": "add", "kind": "\ud800"}]}, ["fields.not_an_option"]),
        (
            "/apply",
            {"revision": 1, "operations": [{"op": "set", "address": "title", "value": "\ud800"}]},
            ["edit.not_valid"],
        ),
        ("/text", {"revision": 1, "text": 1}, ["edit.no_request"]),
        ("/text", {"revision": 1, "text": "\ud800"}, ["edit.no_text"]),
        ("/save", {"revision": 1, "name": "../x"}, ["edit.no_file_name"]),
        ("/save", {"revision": 1, "name": "/etc/x.toml"}, ["edit.no_file_name"]),
        ("/open", {"file": "../plant.toml"}, ["edit.no_file_name"]),
        ("/open", {"template": "../../secret"}, ["fields.not_an_option"]),
        ("/undo", {"revision": 1}, ["edit.no_undo"]),
    ],
)
def test_impossible_changes(page, session, path, body, codes):
    assert session.history.revision == 1
    answer = page.post(path, body)
    assert (answer.status, [error["code"] for error in answer.json["errors"]]) == (422, codes)
    assert session.document.text == TANKS
    assert session.history.revision == 1


def test_two_pages_with_one_file(server, page, session):
    other = Page(server)
    other.cookie = page.cookie
    revision = page.get("/document").json["revision"]
    assert other.get("/document").json["revision"] == revision
    first = page.post("/apply", {"revision": revision, "operations": [{"op": "add", "kind": "orifice"}]}).json
    move = [{"op": "place", "part": "high", "x": 1, "y": 1}]
    for path, body in (("/apply", {"operations": move}), ("/text", {"text": ""}), ("/save", {}), ("/undo", {})):
        answer = other.post(path, {"revision": revision, **body})
        assert (answer.status, answer.json["code"]) == (409, "edit.stale")
        assert answer.json["state"]["text"] == first["text"]
    assert other.get(f"/model?revision={revision}").status == 204
    assert other.get("/status").json["revision"] == first["revision"]
    second = other.post("/apply", {"revision": first["revision"], "operations": move}).json
    assert "[parts.orifice]" in second["text"]
    assert "high = { x = 1, y = 1 }" in second["text"]


def test_many_changes_at_once_lose_nothing(server, page, session):
    """Pages that repeat a change after a conflict."""

    def change(number: int) -> None:
        other = Page(server)
        other.cookie = page.cookie
        revision = 1
        while True:
            add = [{"op": "add", "kind": "chamber", "name": f"tank_{number}"}]
            answer = other.post("/apply", {"revision": revision, "operations": add})
            if answer.status == 200:
                return
            revision = answer.json["state"]["revision"]

    threads = [Thread(target=change, args=(number,)) for number in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert {f"tank_{number}" for number in range(8)} <= {*session.document.view()["parts"]}
    assert session.history.revision == 9


def test_conflicts_with_the_disk(page, session):
    plant = session.folder / "plant.toml"
    move = [{"op": "place", "part": "high", "x": 1, "y": 1}]
    state = page.post("/apply", {"revision": 1, "operations": move}).json
    plant.write_text("other")
    assert page.get("/status").json == {"revision": state["revision"], "changed_on_disk": True}
    answer = page.post("/save", {"revision": state["revision"]})
    assert (answer.status, answer.json["code"]) == (409, "edit.changed_on_disk")
    assert answer.json["state"]["changed_on_disk"]
    (session.folder / "taken.toml").write_text("mine")
    answer = page.post("/save", {"revision": state["revision"], "name": "taken.toml"})
    assert (answer.status, answer.json["code"]) == (409, "edit.file_exists")
    answer = page.post("/open", {"empty": True})
    assert (answer.status, answer.json["code"]) == (409, "edit.unsaved")
    assert page.post("/save", {"revision": state["revision"], "overwrite": True}).status == 200
    assert plant.read_text() == state["text"]


def test_the_model_of_a_revision(page):
    answer = page.get("/model?revision=1")
    assert answer.status == 200
    assert answer.headers["Content-Type"] == BYTES
    assert answer.body[:8] == b"POPPETM1"
    (length,) = struct.unpack("<I", answer.body[8:12])
    header = json.loads(answer.body[12 : 12 + length])
    again = page.get(f"/model?revision=1&key={header['key']}")
    assert len(again.body) < len(answer.body)
    for query in ("", "?revision=x", "?revision=7", "?revision=%ff", f"?revision={'1' * 9999}"):
        assert page.get(f"/model{query}").status == 204
    state = page.post("/text", {"revision": 1, "text": TANKS + "\n[parts.x]\nkind = 1\n"}).json
    answer = page.get(f"/model?revision={state['revision']}")
    assert (answer.status, answer.json["errors"]) == (422, state["errors"])


def test_the_notes_on_a_run(page, session):
    circuit = session.circuit()
    raw = solve(circuit.problem(circuit.run))
    body = np.concatenate([[raw.stop], raw.extremes.ravel(), raw.time, raw.values.ravel()]).tobytes()
    answer = page.post("/notes?revision=1", body, Content_Type=BYTES)
    assert (answer.status, answer.json) == (200, {"notes": list(circuit.simulate().notes)})
    answer = page.post("/notes?revision=1", body[8:], Content_Type=BYTES)
    assert (answer.status, answer.json["errors"][0]["code"]) == (422, "edit.no_request")
    for query in ("", "?revision=0", "?revision=x"):
        answer = page.post(f"/notes{query}", body, Content_Type=BYTES)
        assert (answer.status, answer.body) == (204, b"")
    assert page.post("/notes?revision=1", {}).status == 415


def test_errors_of_the_run_have_lines(page):
    text = TANKS.replace("[run]\n", '[run]\nstop_when = ["tnk.pressure > 2 bar"]\n')
    revision = page.post("/text", {"revision": 1, "text": text}).json["revision"]
    answer = page.get(f"/model?revision={revision}")
    (error,) = answer.json["errors"]
    assert (answer.status, error["line"]) == (422, text.splitlines().index("[run]") + 2)


HOSTILE = [
    "</script><script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "\u202e\u2028\u2029",
    "__proto__",
    "constructor",
    "javascript:alert(1)",
    "a\nb",
    '"; fetch("http://evil.example")',
]


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_and_titles_are_data(page, name):
    """They are replied as JSON, never as a page, and a name that is not permitted is an error."""
    text = f"title = {json.dumps(name)}\n[parts.{json.dumps(name)}]\nkind = {json.dumps(name)}\n"
    answer = page.post("/text", {"revision": 1, "text": text})
    assert answer.headers["Content-Type"] == "application/json"
    assert answer.json["errors"]
    assert answer.json["text"] == text
    revision = answer.json["revision"]
    assert page.post("/save", {"revision": revision, "name": f"{name}/x"}).status == 422
    assert page.post("/undo", {"revision": revision}).json["text"] == TANKS
