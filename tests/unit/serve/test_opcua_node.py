"""OPC UA server with a client that shares no code with it: node-opcua.

The folder that contains the package must be named by NODE_PATH: `npm install node-opcua-client`.
"""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("asyncua", reason="the extra opcua is not installed")

import poppet
from poppet.serve.opcua_nodes import MACHINE_NODE
from poppet.serve.points import PointRole
from serve_opcua import serving, url_of

ROOT = Path(__file__).parents[3]
CIRCUIT = ROOT / "examples" / "serve" / "two_cylinders_machine.toml"
CLIENT = ROOT / "tests" / "opcua_client.js"
NODE = shutil.which("node")


def has_client() -> bool:
    if NODE is None:
        return False
    test = [NODE, "-e", "require.resolve('node-opcua-client')"]
    return subprocess.run(test, capture_output=True, check=False).returncode == 0


pytestmark = pytest.mark.skipif(not has_client(), reason="node-opcua-client is not installed in NODE_PATH")


def run_client(url: str, writes: list[tuple[str, str, Any]]) -> dict[str, Any]:
    result = subprocess.run(
        [str(NODE), str(CLIENT), url, json.dumps(writes)], capture_output=True, text=True, timeout=60
    )
    assert result.returncode == 0, result.stderr
    content: dict[str, Any] = json.loads(result.stdout.strip().splitlines()[-1])
    return content


def test_another_client_reads_and_writes_every_address() -> None:
    with poppet.load(CIRCUIT).serve(clock=False) as machine:
        snapshot = machine.advance(0.5)
        inputs = [point for point in machine.points if point.role is PointRole.INPUT]
        values = {point.address: 0.5 * (max(point.low, 0.0) + min(point.high, 1000.0)) for point in inputs}
        writes: list[tuple[str, str, Any]] = [
            (f"ns=2;s={address}", "Double", value) for address, value in values.items()
        ]
        writes += [("ns=2;s=valveA.fault", "UInt32", 1), ("ns=2;s=valveB.command", "Double", 5.0),
                   ("ns=2;s=valveB.command", "Int32", 1), ("ns=2;s=slideA.position", "Double", 1.0)]  # fmt: skip
        with serving(machine) as server:
            content = run_client(url_of(server), writes)
        read = {name.removeprefix("ns=2;s="): data for name, data in content["read"].items()}
        assert {data["status"] for data in read.values()} == {"Good"}
        for point in machine.points:
            data = read[point.address]
            expected = ("Boolean" if point.is_flag else "Double", snapshot[point.address])
            assert (data["type"], data["value"]) == expected, point.address
            if not point.is_flag:
                assert read[f"{point.address}/EngineeringUnits"]["value"]["unit"] == point.unit
            assert data["time"] is not None
        assert read["valveA.command/EURange"]["value"] == ["0", "1"]
        assert read["supply.pressure/EURange"]["value"] == ["0", "Infinity"]
        assert read["valveA.fault/EnumValues"]["value"] == ["none", *machine.faults["valveA"]]
        assert read["valveA.fault/ValueAsText"]["value"] == "none"
        assert read[f"{MACHINE_NODE}.time"]["value"] == snapshot.time
        assert read[f"{MACHINE_NODE}.state/ValueAsText"]["value"] == "running"
        assert content["written"] == ["Good"] * (len(inputs) + 1) + [
            "BadOutOfRange",
            "BadTypeMismatch",
            "BadNotWritable",
        ]
        assert {address: machine.snapshot()[address] for address in values} == values
        assert machine.fault_of("valveA") == machine.faults["valveA"][0]
