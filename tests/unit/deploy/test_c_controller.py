"""Tests of controllers in C: both precisions, on this machine and compiled for a Cortex-M."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from c_compiler import STRICT, compile_c
from circuits_of_exports import CONTROLLERS, EXAMPLES
from poppet import load
from poppet.cli.main import run
from poppet.deploy.c.controller import c_controller
from poppet.deploy.controller import controller_program
from refusals import refused

MOST_CODE = 12_000
"""Bytes of code on a Cortex-M4, of the largest of them."""


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize("name", CONTROLLERS)
def test_host_program_reports_success(name, precision, tmp_path):
    files = c_controller(load(EXAMPLES / f"{name}.toml"), CONTROLLERS[name], name="ctl", precision=precision)
    executable = compile_c(files, tmp_path, "-std=c99", "-O1", "-ffp-contract=off")
    host_run = subprocess.run([executable], capture_output=True, text=True, check=False)
    assert host_run.returncode == 0, host_run.stdout
    if precision == "double":  # CasADi does the same arithmetic
        assert "difference 0.00e+00" in host_run.stdout


@pytest.mark.parametrize("precision", ["double", "single"])
def test_parameters_change_between_calls(precision, tmp_path):
    """A gain is doubled after half of the calls; Python's program, begun with it, is the same where no memory is."""
    circuit = load(EXAMPLES / "pressure_control.toml").with_values({"regulator.integral_time": "1e9 s"})
    files = {n: t for n, t in c_controller(circuit, name="ctl", precision=precision).items() if "host" not in n}
    files["own.c"] = """
      #include "ctl.h"
      #include <stdio.h>
      static ctl_t r;
      int main(void) {
        int call;
        ctl_init(&r);
        for (call = 0; call < 40; call++) {
          if (call == 20) r.param.gain *= 2;
          r.in.setpoint = 400000;
          r.in.measurement = 396000;
          if (ctl_step(&r) & ~CTL_SATURATED) return 1;
          printf("%.9g ", (double)r.out.command);
        }
        return 0;
      }
    """
    executable = compile_c(files, tmp_path, "-std=c99", "-O2")
    out = subprocess.run([executable], capture_output=True, text=True, check=True).stdout
    outputs = [float(text) for text in out.split()]
    for gain, value in ((9.21e-5, outputs[19]), (2 * 9.21e-5, outputs[39])):
        program = controller_program(circuit.with_values({"regulator.gain": gain}))
        inputs = {"regulator.setpoint": 4e5, "regulator.measurement": 396000.0}
        rows = [[inputs.get(item.address, item.value) for item in program.inputs]] * 40
        assert value == pytest.approx(program.run(rows).outputs[-1, 0], rel=1e-5, abs=1e-7)
    assert outputs[39] != pytest.approx(outputs[19], rel=0.1)


def test_all_sample_instants_are_executed_after_hours(tmp_path):
    """A single-precision counter stops at 2^24 calls; a single-precision time would be coarse after half an hour."""
    files = c_controller(load(EXAMPLES / "pressure_control.toml"), name="ctl", precision="single")
    files = {name: text for name, text in files.items() if "host" not in name}
    files["own.c"] = """
      #include "ctl.h"
      #include <stdio.h>
      static ctl_t r;
      int main(void) {
        long call, count = (1L << 24) + 1000, acted = 0;
        ctl_init(&r);
        r.in.automatic = false;
        for (call = 0; call < count; call++) {
          float before = r.out.command;
          r.in.manual_command = (float)(call % 7) / 10.0f;
          ctl_step(&r);
          acted += r.out.command != before;
        }
        printf("%ld", count - acted);
        return 0;
      }
    """
    executable = compile_c(files, tmp_path, "-std=c99", "-O2")
    # The first two calls give zero: the manual command of zero acts in the second call.
    assert subprocess.run([executable], capture_output=True, text=True, check=True).stdout == "2"


def test_single_precision_code_contains_no_double(tmp_path):
    files = c_controller(
        load(EXAMPLES / "muscle_joint.toml"), CONTROLLERS["muscle_joint"], name="ctl", precision="single"
    )
    text = files["ctl.c"] + files["ctl.h"]
    assert "double" not in text
    assert not re.search(r"\d\.\d+(e[-+]?\d+)?(?![\d.f])", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL))


@pytest.mark.parametrize("precision", ["double", "single"])
def test_controller_compiles_for_a_microcontroller(precision, tmp_path):
    ziglang = pytest.importorskip("ziglang", reason="a compiler for other processors")
    library = Path(str(ziglang.__file__)).parent / "lib" / "libc" / "include"
    headers = [option for name in ("generic-musl", "arm-linux-musl") for option in ("-isystem", str(library / name))]
    target = ["-target", "thumb-freestanding-eabihf", "-mcpu=cortex_m4", "-Os", "-std=c99", *STRICT, *headers]
    files = c_controller(load(EXAMPLES / "pressure_regulator.toml"), name="ctl", precision=precision)
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    cache = {**os.environ, "ZIG_GLOBAL_CACHE_DIR": str(tmp_path / "zig")}
    command = [sys.executable, "-m", "ziglang", "cc", *target, "-c", "-o", "ctl.o", "ctl.c"]
    subprocess.run(command, cwd=tmp_path, check=True, env=cache)
    size = code_size((tmp_path / "ctl.o").read_bytes())
    print(f"{precision} precision: {size} bytes of code")
    assert 500 < size < MOST_CODE


def code_size(data: bytes) -> int:
    """Bytes of the sections of a 32-bit ELF that are code."""
    assert data[:5] == b"\x7fELF\x01"

    def number(offset: int, size: int = 4) -> int:
        return int.from_bytes(data[offset : offset + size], "little")

    first, length, count = number(32), number(46, 2), number(48, 2)
    sections = [first + k * length for k in range(count)]
    return sum(number(s + 20) for s in sections if number(s + 8) & 4)


def test_the_command(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    file = str(EXAMPLES / "pressure_control.toml")
    assert run(["export", "c", file, "--part", "controller", "--precision", "single", "-o", "ctl"]) == 0
    assert {p.name for p in (tmp_path / "ctl").iterdir()} >= {"regulator.h", "regulator.c", "regulator_host.c"}
    text = (tmp_path / "ctl" / "regulator.c").read_text()
    assert "regulator_status_t regulator_step_dt(regulator_t *r, float dt)" in text
    with refused("names.unknown", "nobody"):
        c_controller(load(file), ("nobody",))
