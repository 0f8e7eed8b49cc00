"""MQTT adapter of `poppet serve`: publishes the values of a machine to a broker, and accepts commands.

The client of paho-mqtt has a thread of its own. A broker that is slow or absent delays neither the machine nor the
other protocols: values are then not sent.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import math
import os
import re
import socket
import ssl
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, needed
from poppet.monitoring.stream import object_of
from poppet.serve.adapters import AdapterSettings, HostPort, read_host_port
from poppet.serve.lines import error_rows, point_row, selected, status
from poppet.serve.machine import Machine
from poppet.serve.points import PointRole
from poppet.serve.secrets_file import read_secrets
from poppet.serve.snapshot import Snapshot

OPTION = "--mqtt"
PORT, TLS_PORT = 1883, 8883
USER, PASSWORD = "POPPET_MQTT_USER", "POPPET_MQTT_PASSWORD"
DEFAULT_INTERVAL = 1.0
LONGEST_MESSAGE = 2**20
"""Longest command [bytes]."""
RECONNECT = 1, 30
"""Shortest and longest time between two attempts to connect; it doubles after each failure [s]."""
PATIENCE = 1.0
"""Time in which the last messages are sent at the end [s]."""
ONLINE, OFFLINE = "online", "offline"
AT_MOST_ONCE, AT_LEAST_ONCE = 0, 1


@dataclass(frozen=True)
class BrokerSettings:
    """Connection to a broker.

    Parameters
    ----------
    address : HostPort
        Address of the broker.
    topic : str
        First levels of all topics.
    interval : float
        Time between two messages with the same topic [s].
    user, password : str, optional
        Credentials.
    tls : SSLContext, optional
        Encryption; without it, all messages and the password are readable in the network.
    """

    address: HostPort
    topic: str
    interval: float = DEFAULT_INTERVAL
    user: str = ""
    password: str = ""
    tls: ssl.SSLContext | None = None


class MqttAdapter:
    """MQTT client of `poppet serve`."""

    def __init__(self, settings: BrokerSettings) -> None:
        self.settings = settings
        self.n_published = self.n_commands = self.n_errors = self.n_connections = self.n_skipped = 0
        self._sent: dict[str, str] = {}
        self._is_new = threading.Event()  # after a connection, all values are sent

    async def run(self, machine: Machine, report: Callable[[Note], None]) -> None:
        """Publish values until the task is cancelled."""
        loop = asyncio.get_running_loop()

        def show(note: Note) -> None:
            with contextlib.suppress(RuntimeError):  # the loop has ended
                loop.call_soon_threadsafe(report, note)

        client = self._client(machine, show)
        client.connect_async(*self.settings.address)
        client.loop_start()
        last: Any = None
        try:
            while True:
                if not client.is_connected():
                    last = None
                elif last is None or last.rc or self._is_new.is_set() or last.is_published():
                    last = await asyncio.to_thread(self._publish_values, client, machine)
                else:  # the broker does not take the messages of the previous interval
                    self.n_skipped += 1
                await asyncio.sleep(self.settings.interval)
        finally:
            await asyncio.to_thread(self._end, client)

    def summary(self) -> Sequence[Note]:
        """Return a note on connections and messages."""
        return (Note(
            "mqtt.summary", OPTION, connections=self.n_connections, published=self.n_published,
            commands=self.n_commands, errors=self.n_errors or None, skipped=self.n_skipped or None,
        ),)  # fmt: skip

    # Connection --------------------------------------------------------------------------------------------------

    def _client(self, machine: Machine, report: Callable[[Note], None]) -> Any:
        """Return a client with its callbacks, which its own thread calls."""
        from paho.mqtt.client import Client
        from paho.mqtt.enums import CallbackAPIVersion

        settings = self.settings
        client = Client(CallbackAPIVersion.VERSION2)
        client.reconnect_delay_set(*RECONNECT)
        client.max_queued_messages_set(1000)
        if settings.user:
            client.username_pw_set(settings.user, settings.password)
        if settings.tls is not None:
            client.tls_set_context(settings.tls)
        client.will_set(f"{settings.topic}/status", OFFLINE, AT_LEAST_ONCE, retain=True)
        problem = ""  # that was reported

        def change(text: str, note: Note) -> None:
            nonlocal problem
            if text != problem:
                problem = text
                report(note)

        def connected(_client: Any, _data: Any, _flags: Any, reason: Any, _properties: Any) -> None:
            broker = str(settings.address)
            if reason.is_failure:
                change(str(reason), Note("mqtt.refused", OPTION, broker=broker, why=str(reason)))
                return
            self.n_connections += 1
            change("connected", Note("mqtt.connected", OPTION, broker=broker, topic=settings.topic))
            client.subscribe([(f"{settings.topic}/set", AT_LEAST_ONCE), (f"{settings.topic}/+/set", AT_LEAST_ONCE)])
            self._publish(client, "status", ONLINE, AT_LEAST_ONCE, retain=True)
            self._publish(client, "points", _points_text(machine), AT_LEAST_ONCE, retain=True)
            self._is_new.set()

        def disconnected(_client: Any, _data: Any, _flags: Any, reason: Any, _properties: Any) -> None:
            if reason.is_failure and problem == "connected":
                change("lost", Note("mqtt.lost", OPTION, broker=str(settings.address), why=str(reason)))

        def failed(_client: Any, _data: Any) -> None:
            try:
                socket.getaddrinfo(*settings.address, type=socket.SOCK_STREAM)
            except (OSError, UnicodeError) as error:
                why = getattr(error, "strerror", None) or str(error)
                change("unknown", Note("mqtt.unknown_host", OPTION, broker=str(settings.address), why=why))
            else:
                change("absent", Note("mqtt.absent", OPTION, broker=str(settings.address)))

        client.on_connect, client.on_disconnect, client.on_connect_fail = connected, disconnected, failed
        client.on_message = lambda _client, _data, message: self._execute(client, machine, message)
        return client

    def _end(self, client: Any) -> None:
        """Announce the end, and close the connection."""
        if client.is_connected():
            self._publish(client, "status", OFFLINE, AT_LEAST_ONCE, retain=True).wait_for_publish(PATIENCE)
        client.on_disconnect = client.on_connect_fail = None
        # Its thread ends then; it is not joined, because an attempt to connect can take seconds.
        client.disconnect()

    # Values ------------------------------------------------------------------------------------------------------

    def _publish(self, client: Any, topic: str, text: str, qos: int = AT_MOST_ONCE, *, retain: bool = False) -> Any:
        self.n_published += 1
        return client.publish(f"{self.settings.topic}/{topic}", text, qos, retain)

    def _publish_values(self, client: Any, machine: Machine) -> Any:
        """Publish each value that has changed, and the state with all values; return its message."""
        if self._is_new.is_set():
            self._is_new.clear()
            self._sent = {}
        snapshot = machine.snapshot()
        faults = {valve: machine.fault_of(valve) for valve in machine.faults}
        live = [point.address for point in machine.points if point.role is not PointRole.PARAMETER]
        texts = {address: json.dumps(value) for address, value in selected(snapshot, live).items()}
        texts |= {f"{valve}.fault": word for valve, word in faults.items()}
        for address, text in texts.items():
            if self._sent.get(address) != text:
                self._publish(client, address, text, retain=True)
        self._sent = texts
        return self._publish(client, "state", _state_text(snapshot, faults, live))

    # Commands ----------------------------------------------------------------------------------------------------

    def _execute(self, client: Any, machine: Machine, message: Any) -> None:
        """Execute a command; an error is published."""
        self.n_commands += 1
        try:
            self._command(machine, message)
        except InputError as error:
            self.n_errors += 1
            text = json.dumps({"topic": message.topic, "errors": error_rows(error)})
            self._publish(client, "errors", text, AT_LEAST_ONCE)

    def _command(self, machine: Machine, message: Any) -> None:
        local = message.topic.removeprefix(f"{self.settings.topic}/").removesuffix("/set")
        if message.retain:
            # The broker repeats it after each connection, long after it was meant.
            raise InputError("mqtt.retained", message.topic)
        if len(message.payload) > LONGEST_MESSAGE:
            raise InputError("mqtt.long_message", message.topic, most=LONGEST_MESSAGE // 2**20)
        try:
            text = message.payload.decode().strip()
        except UnicodeDecodeError:
            raise InputError("mqtt.no_text", message.topic) from None
        if local == "set":
            if not text.startswith("{"):
                raise InputError("mqtt.no_object", message.topic)
            content = object_of(text)
        else:
            content = {local: _value(text)}
        faults = {f"{valve}.fault": valve for valve in machine.faults}
        machine.command(
            {address: value for address, value in content.items() if address not in faults},
            {faults[address]: str(value) for address, value in content.items() if address in faults},
        )


def _value(text: str) -> Any:
    """Return a number or a truth value of JSON, or the text itself: "3 bar"."""
    try:
        value = json.loads(text, parse_int=float)
    except (ValueError, RecursionError):
        return text
    return float(value) if isinstance(value, int | float) else text


def _state_text(snapshot: Snapshot, faults: Mapping[str, str], addresses: Sequence[str]) -> str:
    content = {**status(snapshot), "late": snapshot.late, "faults": faults, "values": selected(snapshot, addresses)}
    return json.dumps(content, allow_nan=False)


def _points_text(machine: Machine) -> str:
    """Return the description of all values: units, roles, ranges, parameters, and the possible faults."""
    points = [point_row(point) for point in machine.points]
    return json.dumps({"points": points, "faults": {valve: [*words] for valve, words in machine.faults.items()}})


# Settings ------------------------------------------------------------------------------------------------------------


def make_adapter(settings: AdapterSettings) -> MqttAdapter:
    """Return the adapter for the value of the option `--mqtt`."""
    with needed("paho-mqtt", "an MQTT client", "serve"):
        import paho.mqtt.client  # noqa: F401
    options, report = settings.options, settings.report
    address, has_tls = read_broker(str(settings.value))
    user, password = _credentials(getattr(options, "mqtt_credentials", None), report)
    authority = getattr(options, "mqtt_ca", None)
    if authority is not None and not has_tls:
        raise InputError("mqtt.unused_ca", "--mqtt-ca", host=address.host)
    broker = BrokerSettings(
        address, _topic(getattr(options, "mqtt_topic", None), settings.served.circuit.title),
        _interval(getattr(options, "mqtt_interval", None)), user, password, _tls(authority) if has_tls else None,
    )  # fmt: skip
    if not address.is_local:
        report(Note("mqtt.remote", OPTION, broker=str(address), topic=broker.topic))
        if password and not has_tls:
            report(Note("mqtt.plain_password", OPTION, broker=str(address)))
    return MqttAdapter(broker)


def read_broker(text: str) -> tuple[HostPort, bool]:
    """Return the address of a broker, and True if the connection is encrypted.

    The text is HOST, HOST:PORT, or a URL with the scheme `mqtt` or `mqtts`. The port 8883 implies encryption.
    """
    if "@" in text:
        raise InputError("mqtt.credentials_in_address", OPTION, user=USER, password=PASSWORD)
    scheme, separator, rest = text.strip().partition("://")
    has_tls = bool(separator) and scheme == "mqtts"
    if separator and scheme not in ("mqtt", "mqtts"):
        rest = text
    address = read_host_port((rest if separator else text).removesuffix("/"), OPTION, TLS_PORT if has_tls else PORT)
    return address, has_tls or (address.port == TLS_PORT and scheme != "mqtt")


def _credentials(path: str | None, report: Callable[[Note], None]) -> tuple[str, str]:
    """Return user and password, of a file or of the environment."""
    if path is None:
        return os.environ.get(USER, ""), os.environ.get(PASSWORD, "")
    content = read_secrets(path, "--mqtt-credentials", report)
    for name in content:
        if name not in ("user", "password"):
            suggestion = NameSuggestion(name, ("user", "password"))
            raise InputError("fields.unknown", name, table="credentials file", suggestion=suggestion)
    if "user" not in content:
        raise InputError("mqtt.no_user", "--mqtt-credentials", path=path)
    return content["user"], content.get("password", "")


def _topic(topic: str | None, title: str) -> str:
    """Return the first levels of all topics."""
    if topic is None:
        return f"poppet/{re.sub(r'[^a-z0-9]+', '_', title.lower()).strip('_') or 'circuit'}"
    text = topic.strip("/")
    if not text or any(c in "+#$" or not c.isprintable() for c in text) or "//" in text:
        raise InputError("mqtt.topic", "--mqtt-topic", value=topic)
    return text


def _interval(seconds: float | None) -> float:
    interval = DEFAULT_INTERVAL if seconds is None else seconds
    if not 0.01 <= interval < math.inf:
        raise InputError("mqtt.interval", "--mqtt-interval", value=interval)
    return interval


def _tls(authority: str | None) -> ssl.SSLContext:
    try:
        return ssl.create_default_context(cafile=authority)
    except (OSError, ssl.SSLError):
        raise InputError("mqtt.authority", "--mqtt-ca", path=authority) from None
