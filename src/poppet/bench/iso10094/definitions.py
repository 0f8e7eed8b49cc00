"""All tests of the bench and their characteristic values, for documents, results and reports."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from poppet.bench.iso10094.characteristic import CHARACTERISTIC
from poppet.bench.iso10094.evaluation import BenchTest, Definition
from poppet.bench.iso10094.flow import FLOW
from poppet.bench.iso10094.frequency import FREQUENCY
from poppet.bench.iso10094.resolution import RESOLUTION
from poppet.bench.iso10094.step import STEP
from poppet.bench.iso10094.supply import LEAKAGE, SUPPLY

_ALL = (CHARACTERISTIC, RESOLUTION, FLOW, SUPPLY, LEAKAGE, STEP, FREQUENCY)
TESTS: Mapping[str, BenchTest] = MappingProxyType({test.name: test for test in _ALL})
"""Tests by name, as in `--tests`."""
DEFINITIONS: Mapping[str, Definition] = MappingProxyType(
    {name: definition for test in _ALL for name, definition in test.definitions.items()}
)
"""All figures by name, in the order of the tests."""
