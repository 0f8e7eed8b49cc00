"""Adapters: servers and clients of the protocols that connect a machine to other programs.

Each protocol has one module with one function, which `KINDS` names. It is imported only if its option is used, so the
packages of the other protocols need not be installed.
"""

from __future__ import annotations

import argparse
import ipaddress
import os
import socket
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any, NamedTuple, Protocol

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.serve.machine import Machine
from poppet.serve.points import ServedCircuit

LOCAL_NAMES = ("localhost", "127.0.0.1", "::1")


class Adapter(Protocol):
    """Connection of a machine to one protocol. It is made before the machine starts, and checks its settings then."""

    async def run(self, machine: Machine, report: Callable[[Note], None]) -> None:
        """Serve the machine until the task is cancelled.

        Call `report` with a note that contains the address when clients can connect, and with later notes for the
        user. An exception ends the program: an `InputError` for an address that is in use, for example. A machine that
        has failed or stopped is served further, with a status that shows this.
        """

    def summary(self) -> Sequence[Note]:
        """Return notes on the clients and their requests, for the summary at the end."""


@dataclass(frozen=True)
class AdapterSettings:
    """Settings from which an adapter is made.

    Parameters
    ----------
    value : str or float
        Value of the option of the adapter, for example an address.
    served : ServedCircuit
        Circuit. `served.circuit.origin` contains the tables of its file.
    options : argparse.Namespace
        Options of `poppet serve`.
    report : callable
        Function that prints a note, such as a warning of the settings.
    """

    value: Any
    served: ServedCircuit
    options: argparse.Namespace
    report: Callable[[Note], None]


class AdapterKind(NamedTuple):
    """Kind of adapters.

    `module` is a module of `poppet.serve`, whose function `make_adapter` takes `AdapterSettings` and returns an
    `Adapter`. `option` is the name of the attribute of the options of `poppet serve` that selects it.
    """

    option: str
    module: str


KINDS = (
    AdapterKind("modbus", "modbus"),
    AdapterKind("opcua", "opcua"),
    AdapterKind("mqtt", "mqtt"),
    AdapterKind("live", "live_server"),
    AdapterKind("lines", "lines"),
    AdapterKind("record", "recorder"),
)
"""All kinds of adapters, in the order in which they start."""


def make_adapters(served: ServedCircuit, options: argparse.Namespace, report: Callable[[Note], None]) -> list[Adapter]:
    """Return the adapters that the options select."""
    adapters = []
    for kind in KINDS:
        value = getattr(options, kind.option, None)
        if value is not None:
            module = import_module(f"poppet.serve.{kind.module}")
            adapters.append(module.make_adapter(AdapterSettings(value, served, options, report)))
    return adapters


class HostPort(NamedTuple):
    """Address of a server."""

    host: str
    port: int

    @property
    def is_local(self) -> bool:
        """True if only programs of this computer can connect."""
        try:
            return self.host in LOCAL_NAMES or ipaddress.ip_address(self.host).is_loopback
        except ValueError:
            return False

    def __str__(self) -> str:
        host = f"[{self.host}]" if ":" in self.host else self.host
        return f"{host}:{self.port}"


def read_host_port(text: str, option: str, port: int) -> HostPort:
    """Return the host and the port of a text such as `127.0.0.1:5020`, `5020`, `[::1]:5020` or `localhost`.

    Parameters
    ----------
    text : str
        Value of the option. A missing host is 127.0.0.1.
    option : str
        Name of the option, for messages.
    port : int
        Port if the text has none.
    """
    host, colon, last = text.strip().rpartition(":")
    if not colon:
        host, last = ("", last) if last.isdecimal() else (last, "")
    elif last.endswith("]"):
        host, last = text.strip(), ""
    if not last:
        last = str(port)
    host = host.removeprefix("[").removesuffix("]") or LOCAL_NAMES[1]
    if not (last.isascii() and last.isdecimal() and int(last) < 2**16) or any(c.isspace() or c in "/@" for c in host):
        raise InputError("serve.address", option, value=text, port=port)
    return HostPort(host, int(last))


def no_server(error: Exception, code: str, option: str, address: HostPort) -> InputError:
    """Return the error of a server that cannot listen: `serve.no_host` if its host is unknown, otherwise `code`."""
    number = getattr(error, "errno", None)
    why = os.strerror(number) if number and number > 0 else getattr(error, "strerror", None) or str(error)
    if isinstance(error, (socket.gaierror, UnicodeError)):
        return InputError("serve.no_host", option, host=address.host, why=why)
    return InputError(code, option, host=address.host, port=address.port, why=why)


def open_address_notes(address: HostPort, option: str) -> list[Note]:
    """Return a warning if programs of other computers can connect to an address."""
    return [] if address.is_local else [Note("serve.open_address", option, host=address.host)]
