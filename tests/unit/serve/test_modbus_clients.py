"""Modbus clients that share no code with the server: `mbpoll` and a C program with libmodbus."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("pymodbus", reason="the extra serve is not installed")

from controller_targets import C_COMPILER
from modbus_stub import StubMachine, map_of, serving
from poppet.serve.modbus import ModbusServer

MBPOLL = shutil.which("mbpoll")
NUMBER = r"([-+.\w]+)"


@pytest.fixture
def machine() -> StubMachine:
    return StubMachine()


@pytest.fixture
def server(machine: StubMachine) -> Iterator[ModbusServer]:
    with serving(machine, map_of()) as running:
        yield running


def mbpoll(server: ModbusServer, table: str, first: int, *values: str, count: int = 1) -> list[float]:
    """Return the values that mbpoll reads, or write values."""
    if MBPOLL is None:
        pytest.skip("mbpoll is not installed")
    written = ["--", *values] if values else []
    command = [MBPOLL, "-0", "-1", "-B", "-p", str(server.port), "-t", table, "-r", str(first)]
    command += [] if values else ["-c", str(count)]
    result = subprocess.run([*command, "127.0.0.1", *written], capture_output=True, text=True, timeout=30)
    assert result.returncode == 0, result.stdout + result.stderr
    return [float(value) for value in re.findall(rf"^\[\d+\]:\s+{NUMBER}", result.stdout, re.MULTILINE)]


def test_mbpoll_reads_and_writes_every_address(server: ModbusServer, machine: StubMachine) -> None:
    # All outputs at once, then each on its own.
    values = [350_000.0, 293.15, 0.1]
    assert mbpoll(server, "3:float", 4, count=3) == pytest.approx(values, rel=1e-5)
    for k, value in enumerate(values):
        assert mbpoll(server, "3:float", 4 + 2 * k) == pytest.approx([value], rel=1e-5)
    assert mbpoll(server, "3", 0, count=4) == [0x4029, 0, 0, 0]  # 12.5 as float64
    assert mbpoll(server, "1", 0) == [1.0]
    for first, address, value in ((0, "valve.opening", 0.75), (2, "valve.setpoint", 250_000.0)):
        mbpoll(server, "4:float", first, str(value))
        assert machine.values[address] == value
        assert mbpoll(server, "4:float", first) == [value]
    for state in (1.0, 0.0):
        mbpoll(server, "0", 0, f"{state:.0f}")
        assert machine.values["plc.run"] == state
        assert mbpoll(server, "0", 0) == [state]
    for first, valve in ((10_000, "valve"), (10_001, "check")):
        mbpoll(server, "4", first, "1")
        assert machine.present[valve] == "stuck_open"
        assert mbpoll(server, "4", first) == [1.0]
        mbpoll(server, "4", first, "0")
        assert machine.present[valve] == "none"
    assert server.statistics.exceptions == 0


LIBMODBUS_CLIENT = r"""
#include <errno.h>
#include <modbus.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static modbus_t *m;
static void words(const char *name, int n, const uint16_t *w) {
  printf("%s:", name);
  for (int k = 0; k < n; k++) printf(" %d", w[k]);
  printf("\n");
}
/* Some versions of modbus_set_float_abcd swap the bytes. */
static void put(float value, uint16_t *w) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  w[0] = bits >> 16;
  w[1] = bits & 0xFFFF;
}
int main(int count, char **arguments) {
  uint16_t w[16];
  uint8_t b[16];
  m = modbus_new_tcp("127.0.0.1", atoi(arguments[count - 1]));
  modbus_set_slave(m, 42);
  if (modbus_connect(m) != 0) return 1;
  if (modbus_read_input_registers(m, 0, 10, w) != 10) return 2;
  words("all inputs", 10, w);
  for (int k = 0; k < 10; k++) {
    if (modbus_read_input_registers(m, k, 1, w) != 1) return 3;
    words("input", 1, w);
  }
  printf("pressure: %.1f\n", (modbus_read_input_registers(m, 4, 2, w), modbus_get_float_abcd(w)));
  if (modbus_read_input_bits(m, 0, 1, b) != 1) return 4;
  printf("discrete: %d\n", b[0]);
  put(0.25f, w);
  put(300000.0f, w + 2);
  if (modbus_write_registers(m, 0, 4, w) != 4) return 5;
  if (modbus_read_registers(m, 0, 4, w) != 4) return 6;
  printf("holding: %.2f %.0f\n", modbus_get_float_abcd(w), modbus_get_float_abcd(w + 2));
  for (int k = 0; k < 2; k++) {
    if (modbus_write_register(m, 10000 + k, 5) != 1) return 7;
    if (modbus_read_registers(m, 10000 + k, 1, w) != 1) return 8;
    words("fault", 1, w);
  }
  for (int k = 1; k >= 0; k--) {
    if (modbus_write_bit(m, 0, k) != 1) return 9;
    if (modbus_read_bits(m, 0, 1, b) != 1 || b[0] != k) return 10;
  }
  b[0] = 1;
  if (modbus_write_bits(m, 0, 1, b) != 1) return 11;
  put(0.5f, w);
  if (modbus_write_and_read_registers(m, 0, 2, w, 0, 2, w + 4) != 2) return 12;
  printf("written and read: %.2f\n", modbus_get_float_abcd(w + 4));
  /* Exceptions: an address without an entry, a value out of range, half of a number. */
  if (modbus_read_input_registers(m, 10, 1, w) != -1 || errno != EMBXILADD) return 13;
  put(2.0f, w);
  if (modbus_write_registers(m, 0, 2, w) != -1 || errno != EMBXILVAL) return 14;
  if (modbus_write_register(m, 0, 0) != -1 || errno != EMBXILVAL) return 15;
  modbus_close(m);
  return 0;
}
"""


def test_libmodbus_reads_and_writes_every_address(server: ModbusServer, machine: StubMachine, tmp_path: Path) -> None:
    if C_COMPILER is None:
        pytest.skip("no C compiler")
    (tmp_path / "client.c").write_text(LIBMODBUS_CLIENT)
    compiler: Sequence[Any] = [C_COMPILER, "-I/usr/include/modbus", "-o", tmp_path / "client", tmp_path / "client.c"]
    if subprocess.run([*compiler, "-lmodbus"], capture_output=True).returncode:
        pytest.skip("libmodbus is not installed")
    result = subprocess.run([tmp_path / "client", str(server.port)], capture_output=True, text=True, timeout=30)
    assert result.returncode == 0, result.stdout
    lines = result.stdout.splitlines()
    (everything,) = (line.split(": ")[1].split() for line in lines if line.startswith("all inputs"))
    assert [line.split(": ")[1] for line in lines if line.startswith("input")] == everything
    assert lines[-6:] == [
        "pressure: 350000.0", "discrete: 1", "holding: 0.25 300000", "fault: 5", "fault: 5", "written and read: 0.50",
    ]  # fmt: skip
    assert machine.present == {"valve": "leak", "check": "leak"}
    assert machine.values["plc.run"] == 1.0
    assert machine.values["valve.opening"] == 0.5
    assert machine.values["valve.setpoint"] == 300_000.0
