"""Tests of exported controllers on Cortex-M cores: library functions, values and instruction counts."""

from __future__ import annotations

import re

import pytest

from circuits_of_exports import CONTROLLERS, EXAMPLES
from cortex_m import COLUMNS, COMPILER, EMULATOR, M4F, compile_controller, count_instructions, sizes_of, symbols_of
from poppet import load
from poppet.deploy.c.controller import c_controller

DOUBLE_ROUTINE = re.compile(r"__aeabi_(d|cd|[fil]2d|ui2d)\w*$")

if COMPILER is None:
    pytest.skip("arm-none-eabi-gcc is not installed", allow_module_level=True)


def files_of(name, precision):
    return c_controller(load(EXAMPLES / f"{name}.toml"), CONTROLLERS[name], name="ctl", precision=precision)


def test_double_precision_calls_double_routines(tmp_path):
    """The pattern finds the routines if there are any."""
    symbols = symbols_of(compile_controller(files_of("pressure_control", "double"), M4F, tmp_path))
    assert {"__aeabi_dmul", "__aeabi_dcmplt"} <= {name for name in symbols if DOUBLE_ROUTINE.match(name)}


@pytest.mark.parametrize("name", CONTROLLERS)
def test_single_precision_calls_no_double_routine(name, tmp_path):
    """Neither the controller nor the functions of `math.h` that it calls."""
    sizes = sizes_of(files_of(name, "single"), M4F, tmp_path)
    assert not {symbol for symbol in symbols_of(tmp_path / "linked.elf") if DOUBLE_ROUTINE.match(symbol)}
    assert 1_000 < sizes.controller <= sizes.linked < 20_000


@pytest.mark.parametrize(("core", "precision"), COLUMNS, ids=[f"{core.name}-{kind}" for core, kind in COLUMNS])
def test_example_program_passes_on_the_core(core, precision, tmp_path):
    if EMULATOR is None:
        pytest.skip("qemu-system-arm is not installed")
    counts = count_instructions(files_of("muscle_joint", precision), core, tmp_path)
    assert 1_000 < counts.mean <= counts.largest < 100_000
