"""Tests of an exported watch on an emulated Cortex-M7: no warnings, expected results, bounded sizes."""

from __future__ import annotations

import pytest

from cortex_m_watch import COMPILER, EMULATOR, measure
from exported_watch_example import tank_watch
from poppet.deploy.c.watch_project import watch_project

if COMPILER is None or EMULATOR is None:
    pytest.skip("arm-none-eabi-gcc or qemu-system-arm is not installed", allow_module_level=True)


def test_the_samples_of_the_host_program_pass_on_the_core(tmp_path):
    """`measure` compares the results with the expected ones."""
    counts = measure(watch_project(tank_watch(), "tank"), tmp_path)
    assert 20_000 < counts.code < 100_000
    assert counts.struct < 50_000
    assert counts.stack < 8_000
    assert 10_000 < counts.mean <= counts.largest < 1_000_000
