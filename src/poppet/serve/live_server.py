"""Server of the page of a served circuit: one page, and a WebSocket with values, inputs and faults.

The address that it prints contains a token, which a browser exchanges for a cookie. A page opened from a disk, and a
program without an origin, send the token instead. Requests of other pages are rejected by their headers `Host` and
`Origin`.
"""

from __future__ import annotations

import asyncio
import hashlib
import hmac
import ipaddress
import logging
import os
import secrets
import socket
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from http import HTTPStatus
from http.cookies import CookieError, SimpleCookie
from typing import TYPE_CHECKING, Any, cast
from urllib.parse import parse_qs, urlsplit

from poppet.core.codes import Note
from poppet.core.errors import InputError, needed
from poppet.serve.adapters import LOCAL_NAMES, AdapterSettings, HostPort, no_server, open_address_notes, read_host_port
from poppet.serve.connection_limit import ConnectionLimit
from poppet.serve.live_content import served_page
from poppet.serve.live_session import LARGEST_MESSAGE, LiveSession, PageStatistics
from poppet.serve.machine import Machine
from poppet.serve.served_watch import ServedWatch

if TYPE_CHECKING:
    from websockets.asyncio.server import ServerConnection
    from websockets.http11 import Request, Response

DEFAULT_PORT = 8030
"""Port of an address without one."""
TOKEN = "POPPET_LIVE_TOKEN"
"""Environment variable with a token that remains valid after a restart."""
SHORTEST_TOKEN = 16
MOST_CLIENTS = 16
MOST_CONNECTIONS = 64
"""Largest number of connections, including those without a request."""
REQUEST_TIME = 5.0
"""Time within which a client must send its request [s]."""
PATH = "/live"
"""Path of the WebSocket."""
NO_ORIGINS = "null", "file://"
"""Origins that browsers send for a page opened from a disk."""
UNSENT = 2**16
"""Bytes that a client has not read, above which further rows are omitted."""
HEADERS = {
    "Content-Security-Policy": "frame-ancestors 'none'",  # the page contains the other rules
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}
"""Headers of all replies."""
CLOSED = "Open the address that poppet serve prints; it contains a token.\n"


@dataclass(frozen=True)
class RequestCheck:
    """Check of the headers of a request.

    Parameters
    ----------
    host : str
        Host on which the server listens.
    port : int
        Port on which the server listens.
    token : str
        Token of the server.
    """

    host: str
    port: int
    token: str

    @property
    def cookie_name(self) -> str:
        """Name of the cookie. Browsers send a cookie to all ports of a host: each server has a name of its own."""
        return f"poppet_live_{self.port}"

    @property
    def cookie(self) -> str:
        """Value of the cookie, which does not reveal the token."""
        return hmac.new(self.token.encode(), b"cookie", hashlib.sha256).hexdigest()

    def accepts_host(self, host: str) -> bool:
        """Return True if a value of the header `Host` names this server.

        Numeric addresses are accepted if other computers can connect: unlike a name, another page cannot redirect them.
        """
        name, colon, port = host.rpartition(":")
        if not colon or port != str(self.port):
            return False
        name = name.removeprefix("[").removesuffix("]").lower()
        if name in (*LOCAL_NAMES, self.host.lower()):
            return True
        if HostPort(self.host, self.port).is_local:
            return False
        with suppress(ValueError):
            ipaddress.ip_address(name)
            return True
        return name == socket.gethostname().lower()

    def accepts_token(self, token: str | None) -> bool:
        """Return True if a token is that of the server."""
        return token is not None and hmac.compare_digest(token.encode(), self.token.encode())

    def accepts_cookie(self, header: str) -> bool:
        """Return True if a header `Cookie` contains the cookie of this server."""
        try:
            cookie = SimpleCookie(header).get(self.cookie_name)
        except CookieError:
            return False
        return cookie is not None and hmac.compare_digest(cookie.value.encode(), self.cookie.encode())

    def accepts_socket(self, host: str, origin: str | None, cookie: str, token: str | None) -> bool:
        """Return True if a WebSocket is that of the page of this server, or has its token.

        The cookie is sufficient for the page of this server only. Other clients need the token: pages opened from a
        disk, and programs, which state no origin. All other origins are rejected, even with the token.
        """
        if not self.accepts_host(host):
            return False
        if origin in (f"http://{host}", f"https://{host}"):
            return self.accepts_token(token) or self.accepts_cookie(cookie)
        return (origin is None or origin in NO_ORIGINS) and self.accepts_token(token)


@dataclass(eq=False)
class LiveServer:
    """Adapter that serves the page of a machine.

    Parameters
    ----------
    address : HostPort
        Address on which it listens.
    page : str
        Page.
    token : str
        Token.
    watch : ServedWatch, optional
        Condition monitoring of the machine.
    """

    address: HostPort
    page: str
    token: str
    watch: ServedWatch | None = None
    statistics: PageStatistics = field(default_factory=PageStatistics, init=False)

    async def run(self, machine: Machine, report: Callable[[Note], None]) -> None:
        from websockets.asyncio.server import ServerConnection, serve

        self._machine, self._start = machine, secrets.token_hex(8)
        # The library reports invalid requests with a trace, which is of no use to the user.
        logger = logging.getLogger("poppet.serve.live")
        logger.addHandler(logging.NullHandler())
        logger.propagate = False
        limit = ConnectionLimit(MOST_CONNECTIONS, self._count_rejected)

        def limited(*arguments: Any, **options: Any) -> Any:
            return limit.limited(ServerConnection(*arguments, **options))

        try:
            server = await serve(
                self._talk, *self.address, process_request=self._respond, compression=None, max_size=LARGEST_MESSAGE,
                max_queue=4, open_timeout=REQUEST_TIME, ping_interval=20, ping_timeout=20, close_timeout=1,
                write_limit=UNSENT, server_header="poppet", logger=logger,
                create_connection=cast(Any, limited),  # a function, in place of a class
            )  # fmt: skip
        except (OSError, UnicodeError) as error:
            raise no_server(error, "serve.no_page", "--live", self.address) from None
        self._server = server
        port = next(iter(server.sockets)).getsockname()[1]
        self._check = RequestCheck(self.address.host, port, self.token)
        shown = HostPort(socket.gethostname() if self.address.host in ("0.0.0.0", "::") else self.address.host, port)
        report(Note("serve.page", "--live", server=str(shown), token=self.token))
        watch = asyncio.create_task(self._watch_machine(report))
        try:
            await asyncio.Event().wait()
        finally:
            watch.cancel()
            limit.abort_waiting()
            server.close()
            with suppress(asyncio.CancelledError):
                await watch
            await server.wait_closed()

    async def _watch_machine(self, report: Callable[[Note], None]) -> None:
        """Run the watch; if it fails, the machine and the page go on."""
        if self.watch is None:
            return
        try:
            await self.watch.run(self._machine)
        except Exception as error:
            self.watch.error = Note("serve.watch_failed", "--watch", why=f"{type(error).__name__}: {error}")
            report(self.watch.error)

    def _respond(self, connection: ServerConnection, request: Request) -> Response | None:
        """Return the reply to a request, or None for a WebSocket that is accepted."""
        url = urlsplit(request.path)
        values = {name: request.headers.get_all(name) for name in ("Host", "Origin", "Cookie")}
        if any(len(found) > 1 for found in values.values()) or not values["Host"]:
            return self._reject(HTTPStatus.BAD_REQUEST)
        host, origin = values["Host"][0], next(iter(values["Origin"]), None)
        cookie, token = next(iter(values["Cookie"]), ""), next(iter(parse_qs(url.query).get("token", ())), None)
        if not self._check.accepts_host(host):
            return self._reject(HTTPStatus.FORBIDDEN)
        if url.path == PATH:
            if not self._check.accepts_socket(host, origin, cookie, token):
                return self._reject(HTTPStatus.FORBIDDEN)
            if self.statistics.clients >= MOST_CLIENTS:
                return self._reject(HTTPStatus.SERVICE_UNAVAILABLE)
            return None
        if url.path != "/":
            return self._reject(HTTPStatus.NOT_FOUND)
        if token is not None and self._check.accepts_token(token):
            # The address in the browser then has no token.
            text = f"{self._check.cookie_name}={self._check.cookie}; HttpOnly; SameSite=Strict; Path=/"
            return _reply(HTTPStatus.SEE_OTHER, "", {"Location": "/", "Set-Cookie": text})
        if not self._check.accepts_cookie(cookie):
            return self._reject(HTTPStatus.FORBIDDEN, CLOSED)
        return _reply(HTTPStatus.OK, self.page, {"Content-Type": "text/html; charset=utf-8"})

    def _count_rejected(self) -> None:
        self.statistics.rejected += 1

    def _reject(self, status: HTTPStatus, text: str = "") -> Response:
        self._count_rejected()
        return _reply(status, text or f"{status.phrase}\n")

    async def _talk(self, connection: ServerConnection) -> None:
        session = LiveSession(self._machine, connection, self.statistics, self._start, self.watch)
        await session.run()

    def summary(self) -> Sequence[Note]:
        """Return a note on the connections and messages."""
        s = self.statistics
        return [Note("serve.page_summary", pages=s.total, rejected=s.rejected, messages=s.messages, omitted=s.omitted)]


def _reply(status: HTTPStatus, text: str, headers: dict[str, str] | None = None) -> Response:
    from websockets.datastructures import Headers
    from websockets.http11 import Response

    body = text.encode()
    own: dict[str, Any] = {"Content-Type": "text/plain; charset=utf-8", "Content-Length": str(len(body))}
    fields = {**HEADERS, **own, **(headers or {}), "Connection": "close"}
    return Response(status.value, status.phrase, Headers(fields), body)


def make_adapter(settings: AdapterSettings) -> LiveServer:
    """Return the adapter of the option --live, with the watch of the option --watch."""
    with needed("websockets", "The page of a served circuit", "serve"):
        import websockets.asyncio.server  # noqa: F401
    address = read_host_port(settings.value, "--live", DEFAULT_PORT)
    for note in open_address_notes(address, "--live"):
        settings.report(note)
    token = os.environ.get(TOKEN) or secrets.token_urlsafe(24)
    if len(token) < SHORTEST_TOKEN:
        raise InputError("serve.short_token", TOKEN, least=SHORTEST_TOKEN)
    twin = getattr(settings.options, "watch", None)
    watch = None if twin is None else ServedWatch.of(str(twin), settings.served)
    page = served_page(settings.served, () if watch is None else watch.twin.plan.faults)
    return LiveServer(address, page, token, watch)
