"""Modbus adapter of `poppet serve`."""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import struct
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("pymodbus", reason="the extra serve is not installed")

import poppet
from modbus_client import connect, exchange
from poppet.core.errors import InputError
from poppet.serve.adapters import AdapterSettings
from poppet.serve.modbus import make_adapter
from poppet.serve.modbus_map import map_of_circuit

MACHINE = Path(__file__).parents[3] / "examples" / "serve" / "two_cylinders_machine.toml"


def settings_of(machine: Any, address: str, notes: list[Any]) -> AdapterSettings:
    return AdapterSettings(address, machine.served, argparse.Namespace(), notes.append)


def test_the_adapter_reports_its_address_and_its_requests() -> None:
    notes: list[Any] = []
    with poppet.load(MACHINE).serve(clock=False) as machine:
        machine.advance(0.1)
        adapter = make_adapter(settings_of(machine, "127.0.0.1:0", notes))
        assert notes == []

        async def run() -> None:
            task = asyncio.create_task(adapter.run(machine, notes.append))
            while not notes:
                await asyncio.sleep(0.01)
            port = int(notes[0].facts["server"].rpartition(":")[2])
            answers = await asyncio.to_thread(requests, port)
            task.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await task
            assert answers[0] == b"\x02\x01\x05"  # both cylinders are at their back ends
            assert struct.unpack(">d", answers[1][2:]) == pytest.approx((0.1,))
            assert answers[2] == b"\x83\x02"

        asyncio.run(run())
    assert [note.code for note in notes] == ["modbus.listening"]
    (summary,) = adapter.summary()
    facts = summary.facts
    assert (facts["connections"], facts["transactions"], facts["exceptions"]) == (1, 3, 1)


def requests(port: int) -> list[bytes]:
    with connect(port) as stream:
        cases = ((2, 0, 5), (4, 0, 4), (3, 100, 1))
        return [exchange(stream, function, struct.pack(">HH", first, count)) for function, first, count in cases]


def test_an_address_of_other_computers_causes_a_warning() -> None:
    notes: list[Any] = []
    with poppet.load(MACHINE).serve(clock=False) as machine:
        make_adapter(settings_of(machine, "0.0.0.0:0", notes))
        with pytest.raises(InputError) as caught:
            make_adapter(settings_of(machine, "127.0.0.1:70000", notes))
    assert [note.code for note in notes] == ["serve.open_address"]
    assert caught.value.code == "serve.address"


def test_errors_of_a_map_have_file_and_line(tmp_path: Path) -> None:
    text = MACHINE.read_text(encoding="utf-8").replace('"valveB.command" = {', '"valveB.comand" = {')
    file = tmp_path / "machine.toml"
    file.write_text(text, encoding="utf-8")
    with poppet.load(file).serve(clock=False) as machine, pytest.raises(InputError) as caught:
        map_of_circuit(machine.served, str(file))
    line = next(k for k, row in enumerate(text.splitlines(), 1) if "comand" in row)
    assert (caught.value.code, caught.value.file, caught.value.line) == ("modbus.unknown", str(file), line)
