"""A third-party package of the tests: one plugin of each group."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np

from poppet.core.provenance import Number, Source
from poppet.library import ParameterSet
from poppet.parts.fields import NumberLike, number, port
from poppet.parts.part import Flow, GasState, Passage, PassageFlows, Scope
from poppet.timeseries.tables.table import Table

POPPET_API = 1


@dataclass(frozen=True)
class Membrane(Passage):
    """A membrane between two gas nodes."""

    kind: ClassVar[str] = "toy_membrane"
    summary: ClassVar[str] = "a membrane with a flow in proportion to the pressure difference"

    from_: str | None = port("gas node at the first port")
    to: str | None = port("gas node at the second port")
    permeance: NumberLike = number("kg/(s Pa)", 1e-9, doc="permeance", low=0.0, note="a toy")

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        flow = scope["permeance"] * (gas["from"].pressure - gas["to"].pressure)
        enthalpy = scope.surroundings.heat_capacity_pressure * gas["from"].temperature * flow
        return PassageFlows((Flow("flow", "from", "to", flow, enthalpy),), {"mass_flow_rate": (flow, "kg/s")})


_SOURCE = Source("datasheet", "toy catalogue")
SET = ParameterSet("toy catalogue", {"muscle": {"": {"nominal_length": Number(0.2, "m", _SOURCE)}}})
COMPONENTS = Path(__file__).with_name("toy_components.toml")


def read(path: Path) -> Table:
    """Read rows of numbers between vertical bars."""
    rows = np.array([[float(cell) for cell in line.split("|")] for line in path.read_text().splitlines()])
    return Table(("t", "p"), tuple(rows.T), ("s", "bar"))


class WrongKind(Membrane):
    """A part whose kind is not the name of its entry point."""
