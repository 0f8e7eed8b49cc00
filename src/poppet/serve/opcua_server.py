"""OPC UA server of a served circuit, with limits for its clients.

This module requires asyncua; `poppet.serve.opcua` imports it if its option is used.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import logging
from collections.abc import Mapping
from datetime import UTC, datetime
from typing import Any

from asyncua import Server, ua
from asyncua.crypto.permission_rules import User, UserRole
from asyncua.server.binary_server_asyncio import BinaryServer, OPCUAProtocol
from asyncua.server.internal_server import InternalServer
from asyncua.server.monitored_item_service import MonitoredItemService
from asyncua.server.subscription_service import SubscriptionService

from poppet.core.version import __version__
from poppet.serve.adapters import HostPort, no_server
from poppet.serve.connection_limit import ConnectionLimit
from poppet.serve.machine import Machine
from poppet.serve.opcua_nodes import MachineAttributes, MachineValues, NodeBuilder

APPLICATION_URI = "urn:poppet:serve"
NAMESPACE_URI = "urn:poppet:circuit"
LARGEST_MESSAGE = 2**20
"""Largest request [bytes]."""
MAX_CHUNKS = 64
MAX_CLIENTS, MAX_SUBSCRIPTIONS, MAX_QUEUE = 32, 64, 100

# Errors of clients have status codes; without this handler, the logging module would print them as well.
logging.getLogger("asyncua").addHandler(logging.NullHandler())


class OpcUsers:
    """Users who may connect, with their passwords; without users, clients are anonymous."""

    def __init__(self, passwords: Mapping[str, str]) -> None:
        self.passwords, self.n_sessions, self.n_refused = passwords, 0, 0

    def get_user(self, server: Any, username: Any = None, password: Any = None, certificate: Any = None) -> User | None:
        """Return a user with the rights to read and to write, or None."""
        expected, given = self.passwords.get(username or "", ""), password or ""
        is_equal = hmac.compare_digest(expected.encode(), given.encode())
        if self.passwords and not (username in self.passwords and is_equal):
            self.n_refused += 1
            return None
        self.n_sessions += 1
        return User(UserRole.User, username)


class _LimitedSessions(InternalServer):  # type: ignore[misc]
    """Sessions of a server; those that clients create without activating them are forgotten."""

    def create_session(self, *arguments: Any, **keywords: Any) -> Any:
        if len(self._external_sessions) > 2 * MAX_CLIENTS:
            for session in [*self._external_sessions.values()]:
                if not session.is_activated():
                    self.unregister_external_session(session)
        return super().create_session(*arguments, **keywords)


class _LimitedProtocol(OPCUAProtocol):  # type: ignore[misc]
    """Connection that ends if a request is too long."""

    def data_received(self, data: bytes) -> None:
        if self.transport is not None and len(self._buffer) + len(data) > LARGEST_MESSAGE:
            self.transport.abort()
        else:
            super().data_received(data)


class _LimitedServer(BinaryServer):  # type: ignore[misc]
    """Server with a limit of its connections."""

    n_rejected = 0

    async def start(self) -> None:
        self._limit = ConnectionLimit(MAX_CLIENTS, self._count_rejected)
        await super().start()

    async def stop(self) -> None:
        self._limit.abort_waiting()
        await super().stop()

    def _make_protocol(self) -> asyncio.Protocol:
        protocol = _LimitedProtocol(self.iserver, self._policies, self.clients, self.closing_tasks, self.limits)
        return self._limit.limited(protocol)

    def _count_rejected(self) -> None:
        self.n_rejected += 1


class _MonitoredItems(MonitoredItemService):  # type: ignore[misc]
    """Items of a subscription whose deadband refers to the last value that was sent, as OPC UA part 4 requires."""

    async def datachange_callback(self, handle: int, value: Any, error: Any = None) -> None:
        identifier = self._monitored_datachange[handle]
        values, queued = self._monitored_items[identifier].mvalue, self.isub._triggered_datachanges
        sent, last = values.current_dvalue, queued.get(identifier, [None])[-1]
        try:
            await super().datachange_callback(handle, value, error)
        finally:
            if queued.get(identifier, [None])[-1] is last:
                values.current_dvalue = sent

    def _is_deadband_exceeded(self, values: Any, change_filter: Any) -> bool:
        old, new = values.old_dvalue, values.current_dvalue
        # A value with a bad status is not a number.
        if old is not None and old.StatusCode != new.StatusCode:
            return True
        return bool(super()._is_deadband_exceeded(values, change_filter))


class _LimitedSubscriptions(SubscriptionService):  # type: ignore[misc]
    """Subscriptions that publish at most once per interval."""

    has_new_items = False  # since the last comparison of the values

    def __init__(self, aspace: Any, inner: Any, values: MachineValues, shortest: float) -> None:
        super().__init__(aspace, inner)
        self.values, self.shortest = values, shortest  # shortest interval [ms]

    async def create_subscription(self, params: Any, *arguments: Any, **keywords: Any) -> Any:
        # In this order, a value that is not a number becomes the shortest interval.
        params.RequestedPublishingInterval = max(self.shortest, params.RequestedPublishingInterval)
        result = await super().create_subscription(params, *arguments, **keywords)
        subscription = self.subscriptions[result.SubscriptionId]
        subscription.monitored_item_srv = _MonitoredItems(subscription, self.aspace)
        return result

    async def create_monitored_items(self, params: Any) -> Any:
        # The first value of an item is the present one.
        self.values.refresh()
        self.has_new_items = True
        return await super().create_monitored_items(params)

    async def set_monitoring_mode(self, params: Any) -> Any:
        self.values.refresh()
        self.has_new_items = True
        return await super().set_monitoring_mode(params)


class OpcServer:
    """OPC UA server, which runs in the event loop of its caller.

    Parameters
    ----------
    machine : Machine
        Served circuit.
    passwords : mapping, optional
        Passwords of the users; without users, clients are anonymous.
    certificate, key : objects of cryptography, optional
        Certificate and RSA key. The server then requires signed and encrypted connections.
    application_uri : str, optional
        URI of the application, as in the certificate.

    Attributes
    ----------
    interval : float
        Time between two comparisons of all values, and shortest publishing interval of a subscription [s].
    """

    interval = 0.1

    def __init__(
        self, machine: Machine, passwords: Mapping[str, str] | None = None, certificate: Any = None, key: Any = None,
        application_uri: str = APPLICATION_URI,
    ) -> None:  # fmt: skip
        self.machine, self.users = machine, OpcUsers(passwords or {})
        self.certificate, self.key, self.application_uri = certificate, key, application_uri
        self.attributes: MachineAttributes
        self.port = 0
        self._server: Any = None
        self._task: asyncio.Task[None] | None = None

    async def start(self, address: HostPort) -> None:
        """Listen for clients; the port 0 selects a free one."""
        server = Server(_LimitedSessions(self.users))
        inner = server.iserver
        inner.max_connections, inner.max_subscriptions = MAX_CLIENTS, MAX_SUBSCRIPTIONS
        inner.max_monitored_item_queue_size = inner.max_unacked_messages_per_subscription = MAX_QUEUE
        server.limits.max_message_size, server.limits.max_chunk_count = LARGEST_MESSAGE, MAX_CHUNKS
        server.set_server_name("poppet")
        server.product_uri, server.manufacturer_name = APPLICATION_URI, "poppet"
        server.application_type = ua.ApplicationType.Server
        await server.init()
        await server.set_build_info(APPLICATION_URI, "poppet", "poppet", __version__, "", datetime.now(UTC))
        await server.set_application_uri(self.application_uri)
        server.set_endpoint(f"opc.tcp://{address}")
        server.socket_address = tuple(address)
        await self._secure(server)
        namespace = await server.register_namespace(NAMESPACE_URI)
        await asyncio.to_thread(self._add_nodes, inner, namespace)
        await self._listen(server, address)
        self._server = server
        self._task = asyncio.create_task(self._publish())

    async def _secure(self, server: Any) -> None:
        """Set the certificate, the security policy and the ways in which clients identify themselves."""
        if self.certificate is None:
            server.set_security_policy([ua.SecurityPolicyType.NoSecurity])
        else:
            server.iserver.certificate, server.iserver.private_key = self.certificate, self.key
            server.set_security_policy([ua.SecurityPolicyType.Basic256Sha256_SignAndEncrypt])
        is_anonymous = not self.users.passwords
        server.set_identity_tokens([ua.AnonymousIdentityToken if is_anonymous else ua.UserNameIdentityToken])

    def _add_nodes(self, inner: Any, namespace: int) -> None:
        values = MachineValues(self.machine)
        NodeBuilder(inner.node_mgt_service, inner.aspace, values, namespace).build()
        inner.attribute_service = self.attributes = MachineAttributes(inner.aspace, values)
        self._subscriptions = _LimitedSubscriptions(inner.aspace, inner, values, 1e3 * self.interval)
        inner.subscription_service = inner.isession.subscription_service = self._subscriptions

    async def _listen(self, server: Any, address: HostPort) -> None:
        """Start a server as its own method `start` does, with limited connections."""
        await server._setup_server_nodes()
        await server.iserver.start()
        server.bserver = _LimitedServer(server.iserver, address.host, address.port, server.limits)
        server.bserver.set_policies(server._policies)
        try:
            await server.bserver.start()
        except (OSError, UnicodeError) as error:
            await server.iserver.stop()
            raise no_server(error, "opcua.no_server", "--opcua", address) from None
        self.port = server.bserver.port

    async def _publish(self) -> None:
        """Compare all values once per interval, and inform the subscriptions of those that have changed."""
        values, nodes = self.attributes.values, self._server.iserver.aspace
        value = ua.AttributeIds.Value
        sent, sent_code = values.vector, object()
        while True:
            await asyncio.sleep(self.interval)
            values.refresh()
            # The first value of a new item can differ from both the previous value and the present one.
            if self._subscriptions.has_new_items:
                self._subscriptions.has_new_items, sent_code = False, object()
            changed = values.changed(sent, sent_code)
            # Before the callbacks, during which a client can read newer values.
            sent, sent_code = values.vector, values.code
            for node_id in changed:
                if callbacks := nodes[node_id].attributes[value].datachange_callbacks:
                    data = values.data_value(node_id)
                    for handle, callback in [*callbacks.items()]:
                        # A filter of a client can fail for a value: that concerns its own item only.
                        with contextlib.suppress(Exception):
                            if handle in callbacks:
                                await callback(handle, data)

    @property
    def n_rejected(self) -> int:
        """Number of connections above the limit."""
        return self._server.bserver.n_rejected if self._server is not None else 0

    async def wait(self) -> None:
        """Wait without end; an error of the server is raised."""
        assert self._task is not None
        await self._task

    async def stop(self) -> None:
        """Close all connections and the server."""
        if self._task is not None:
            self._task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._task
        if self._server is not None:
            await self._server.stop()
