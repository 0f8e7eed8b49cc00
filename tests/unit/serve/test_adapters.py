"""Addresses of servers, and the selection of adapters."""

from __future__ import annotations

import argparse
import errno
import socket

import pytest

from poppet.core.errors import InputError
from poppet.serve.adapters import KINDS, HostPort, make_adapters, no_server, open_address_notes, read_host_port


@pytest.mark.parametrize(
    ("text", "expected", "is_local"),
    [
        ("127.0.0.1:5020", "127.0.0.1:5020", True),
        ("5020", "127.0.0.1:5020", True),
        (":0", "127.0.0.1:0", True),
        ("localhost", "localhost:502", True),
        ("[::1]:5020", "[::1]:5020", True),
        ("[::1]", "[::1]:502", True),
        ("127.3.2.1", "127.3.2.1:502", True),
        ("0.0.0.0:5020", "0.0.0.0:5020", False),
        ("plant.example:1", "plant.example:1", False),
        ("192.168.0.1", "192.168.0.1:502", False),
    ],
)
def test_addresses(text, expected, is_local):
    address = read_host_port(text, "--modbus", 502)
    assert (str(address), address.is_local) == (expected, is_local)
    notes = open_address_notes(address, "--modbus")
    assert [note.code for note in notes] == ([] if is_local else ["serve.open_address"])


@pytest.mark.parametrize("text", ["127.0.0.1:x", "a b:1", "user:word@host:1", "host:65536", "host:-1", "tcp://host:1"])
def test_invalid_addresses(text):
    with pytest.raises(InputError) as caught:
        read_host_port(text, "--modbus", 502)
    assert (caught.value.code, caught.value.address) == ("serve.address", "--modbus")


@pytest.mark.parametrize("error", [socket.gaierror(-2, "Name or service not known"), UnicodeError("label too long")])
def test_an_unknown_host_is_not_a_port_in_use(error):
    problem = no_server(error, "modbus.no_server", "--modbus", HostPort("80a", 5020))
    assert (problem.code, problem.facts["host"]) == ("serve.no_host", "80a")
    in_use = OSError(errno.EADDRINUSE, "Address already in use")
    assert no_server(in_use, "modbus.no_server", "--modbus", HostPort("x", 1)).code == "modbus.no_server"


def test_without_options_there_are_no_adapters():
    assert make_adapters(None, argparse.Namespace(), lambda note: None) == []
    assert len({kind.option for kind in KINDS}) == len(KINDS)
