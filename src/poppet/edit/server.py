"""HTTP server of the editor, for one user on this computer.

It listens on the loopback interface. The address that it prints contains a token that is valid once: the browser that
opens the address receives a cookie, without which all other requests are rejected. Requests of other pages are rejected
by their headers `Host` and `Origin`.
"""

from __future__ import annotations

import gzip
import json
import secrets
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from http import HTTPStatus
from http.cookies import CookieError, SimpleCookie
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import parse_qs, unquote, urlsplit

from poppet.core.errors import InputError, PoppetError

HOST = "127.0.0.1"
LARGEST_BODY = 2**20
"""Maximum size of the body of a request, unless its route has another limit [byte]."""
JSON = "application/json"
BYTES = "application/octet-stream"
POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; connect-src 'self'; "
    "worker-src 'self'; img-src 'self' data: blob:; form-action 'none'; frame-ancestors 'none'; base-uri 'none'"
)
"""Content security policy of all replies."""
HEADERS = {
    "Content-Security-Policy": POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}
"""Headers of all replies; a reply can replace them."""
_COMPRESSED = ("text/", JSON, "image/svg+xml", "application/wasm", BYTES)
_SMALLEST_COMPRESSED = 1000  # [byte]
_MOST_DIGITS = 9  # of the length of a body that is read to its end, although it is rejected


@dataclass(frozen=True)
class Request:
    """Request to a route: parts of the path, query and body."""

    names: Mapping[str, str]  # values of the names in braces in the path of the route
    query: Mapping[str, str]
    body: bytes = b""
    json: Mapping[str, Any] = field(default_factory=dict)  # of a body of the type JSON


@dataclass(frozen=True)
class Reply:
    """Reply to a request."""

    body: bytes
    media_type: str = JSON
    status: int = HTTPStatus.OK
    headers: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def json(cls, content: Any, status: int = HTTPStatus.OK) -> Reply:
        """Return a reply with values as JSON."""
        text = json.dumps(content, ensure_ascii=False, allow_nan=False)
        # Half of a surrogate pair, which only an escape sequence can represent.
        return cls(text.encode(errors="backslashreplace"), JSON, status)

    @classmethod
    def refusal(cls, status: int) -> Reply:
        """Return a reply without content except the name of its status."""
        return cls(f"{HTTPStatus(status).phrase}\n".encode(), "text/plain; charset=utf-8", status)


USED = (
    "This address is valid once, in one browser. "
    "Another browser has used it, or it belongs to an editor that has ended.\n"
    "To use this browser, end the editor with Ctrl-C, start poppet edit again, and open the new address here.\n"
)
"""Reply to a browser that opens an address that is not valid any more."""


@dataclass(frozen=True)
class Route:
    """Function that replies to the requests of one path.

    A request with a body has the media type `media_type` and at most `largest` bytes.
    """

    function: Callable[[Request], Reply]
    media_type: str = JSON
    largest: int = LARGEST_BODY


Routes = Mapping[tuple[str, str], Route]
"""Routes by method and path. A part of the path in braces, as in `/files/{name}`, matches any name."""


class EditServer(ThreadingHTTPServer):
    """Server of one editing session.

    Parameters
    ----------
    port : int
        Port; 0 for any free one.
    tables : iterable of mapping
        Tables of routes.
    """

    daemon_threads = True
    allow_reuse_address = False  # otherwise two servers could use the same port on some systems

    def __init__(self, port: int, tables: Iterable[Routes]) -> None:
        try:
            super().__init__((HOST, port), _Handler)
        except (OSError, OverflowError) as error:
            why = "ports are integers from 0 to 65535" if isinstance(error, OverflowError) else error.strerror
            raise InputError("edit.port", port=port, why=why) from None
        self.routes: dict[tuple[str, str], Route] = {key: route for table in tables for key, route in table.items()}
        self.token: str | None = secrets.token_urlsafe(24)
        self.secret = secrets.token_urlsafe(24)
        # Browsers send a cookie to all ports of a host: each server has a name of its own.
        self.cookie = f"poppet_edit_{self.server_port}"
        self.hosts = {f"{name}:{self.server_port}" for name in (HOST, "localhost")}
        self.address = f"http://{HOST}:{self.server_port}/?token={self.token}"

    def find(self, method: str, path: str) -> tuple[Route | None, dict[str, str]]:
        """Return the route of a path, and the values of the names in the path."""
        parts = path.split("/")
        for (route_method, pattern), route in self.routes.items():
            names = _match(pattern.split("/"), parts)
            if route_method == method and names is not None:
                return route, names
        return None, {}

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Print the trace of a defect, but nothing if the page has closed its connection."""
        if not isinstance(sys.exception(), ConnectionError | TimeoutError):
            super().handle_error(request, client_address)

    def take(self, token: str) -> bool:
        """Return True if a token is the one in the address, and make it invalid."""
        if self.token is None or not secrets.compare_digest(token.encode(), self.token.encode()):
            return False
        self.token = None
        return True


class _Handler(BaseHTTPRequestHandler):
    server: EditServer
    protocol_version = "HTTP/1.1"
    server_version = "poppet"
    sys_version = ""
    timeout = 120.0  # of idle connections [s]
    disable_nagle_algorithm = True  # otherwise the body of a reply waits 40 ms for the receipt of its headers

    def do_GET(self) -> None:
        self._answer()

    def do_POST(self) -> None:
        self._answer()

    def _answer(self) -> None:
        try:
            url = urlsplit(self.path)
            path = unquote(url.path, errors="strict")
        except ValueError:  # an invalid address or invalid UTF-8
            url, path = urlsplit(""), ""
        query = {key: values[-1] for key, values in parse_qs(url.query).items()}
        route, names = self.server.find(self.command, path)
        is_first = self.command == "GET" and path == "/" and "token" in query
        # The body is read even if the request is rejected: otherwise it would be the next request.
        body = self._body(route.largest if route else LARGEST_BODY)
        status = self._refusal(route, is_first=is_first, body=body)
        if status is not None:
            self._send(Reply.refusal(status))
        elif is_first:
            self._send_cookie(query["token"])
        elif route is not None and isinstance(body, bytes):
            self._send(self._reply(route, names, query, body))

    def _refusal(self, route: Route | None, *, is_first: bool, body: bytes | HTTPStatus) -> int | None:
        """Return the status of a request that is rejected by its headers."""
        if self.headers.get("Host", "") not in self.server.hosts:
            return HTTPStatus.FORBIDDEN
        origin = self.headers.get("Origin")
        if origin is not None and origin not in {f"http://{host}" for host in self.server.hosts}:
            return HTTPStatus.FORBIDDEN
        if not is_first and not self._has_cookie():
            return HTTPStatus.FORBIDDEN
        if route is None and not is_first:
            return HTTPStatus.NOT_FOUND
        if self.command == "POST" and route is not None:
            media_type = self.headers.get("Content-Type", "").partition(";")[0].strip().lower()
            # Browsers state the origin of each POST, and ask before they send these types to another origin.
            if origin is None or media_type != route.media_type:
                return HTTPStatus.UNSUPPORTED_MEDIA_TYPE
        return None if isinstance(body, bytes) else body

    def _body(self, largest: int) -> bytes | HTTPStatus:
        """Return the body of the request, or the status of a body that is rejected."""
        length = self.headers.get("Content-Length", "0")
        if "Transfer-Encoding" in self.headers or not (length.isascii() and length.isdigit()):
            self.close_connection = True  # the end of the request is not known
            return HTTPStatus.LENGTH_REQUIRED
        if len(length) > _MOST_DIGITS:
            self.close_connection = True
            return HTTPStatus.REQUEST_ENTITY_TOO_LARGE
        if int(length) <= largest:
            return self.rfile.read(int(length))
        rest = int(length)
        while rest and (block := self.rfile.read(min(rest, 2**16))):
            rest -= len(block)
        return HTTPStatus.REQUEST_ENTITY_TOO_LARGE

    def _has_cookie(self) -> bool:
        try:
            cookie = SimpleCookie(self.headers.get("Cookie", "")).get(self.server.cookie)
        except CookieError:
            return False
        return cookie is not None and secrets.compare_digest(cookie.value.encode(), self.server.secret.encode())

    def _send_cookie(self, token: str) -> None:
        """Redirect to the page without the token, which becomes a cookie."""
        if not self._has_cookie() and not self.server.take(token):
            self._send(Reply(USED.encode(), "text/plain; charset=utf-8", HTTPStatus.FORBIDDEN))
            return
        cookie = f"{self.server.cookie}={self.server.secret}; HttpOnly; SameSite=Strict; Path=/"
        headers = {"Location": "/", "Set-Cookie": cookie}
        self._send(Reply(b"", "text/plain; charset=utf-8", HTTPStatus.SEE_OTHER, headers))

    def _reply(self, route: Route, names: dict[str, str], query: dict[str, str], body: bytes) -> Reply:
        content: Any = {}
        if self.command == "POST" and route.media_type == JSON:
            try:
                content = json.loads(body)
            except (ValueError, RecursionError):
                content = None
            if not isinstance(content, dict):
                return Reply.refusal(HTTPStatus.BAD_REQUEST)
        try:
            return route.function(Request(names, query, body, content))
        except InputError as error:
            from poppet.edit.session import error_list

            return Reply.json({"errors": error_list(error)}, HTTPStatus.UNPROCESSABLE_ENTITY)
        except (PoppetError, OSError) as error:
            return Reply.json({"errors": [_problem(str(error))]}, HTTPStatus.UNPROCESSABLE_ENTITY)
        except Exception as error:
            text = f"internal error: {type(error).__name__}: {error}. Please report it."
            return Reply.json({"errors": [_problem(text)]}, HTTPStatus.INTERNAL_SERVER_ERROR)

    def _send(self, reply: Reply) -> None:
        body, headers = reply.body, {**HEADERS, "Content-Type": reply.media_type, **reply.headers}
        headers_of_request: Mapping[str, str] = getattr(self, "headers", {})  # missing if they are not valid
        accepts = "gzip" in headers_of_request.get("Accept-Encoding", "")
        if accepts and len(body) > _SMALLEST_COMPRESSED and reply.media_type.startswith(_COMPRESSED):
            body = gzip.compress(body, compresslevel=1, mtime=0)
            headers["Content-Encoding"] = "gzip"
        self.send_response(reply.status)
        for name, value in headers.items():
            self.send_header(name, value)
        self.send_header("Content-Length", str(len(body)))
        if self.close_connection:
            self.send_header("Connection", "close")
        self.end_headers()
        self.wfile.write(body)

    def send_error(self, code: int, message: str | None = None, explain: str | None = None) -> None:
        """Reply to a request with another method, or to one that is not valid HTTP."""
        self.close_connection = True
        self._send(Reply.refusal(code))

    def log_message(self, format: str, *args: Any) -> None:
        """Print nothing: the terminal shows the address only."""


def _problem(message: str) -> dict[str, Any]:
    """Return an error without a code for the page."""
    return {"code": "", "address": "", "line": None, "message": message, "hint": ""}


def _match(pattern: list[str], parts: list[str]) -> dict[str, str] | None:
    """Return the values of the names in a pattern, or None if a path does not match."""
    if len(pattern) != len(parts):
        return None
    names = {}
    for expected, part in zip(pattern, parts, strict=True):
        if expected.startswith("{"):
            names[expected[1:-1]] = part
        elif expected != part:
            return None
    return names
