"""Which law the force of a muscle follows, and with which numbers: of the muscle itself and of who reckons with it."""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from typing import Any

from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.laws.physics.muscle import ChouHannaford, ForceLaw, Sarosi, TonduLopez
from poppet.parts.fields import NumberLike, group, number, option, reference
from poppet.parts.force_rows import ForceRows
from poppet.parts.part import Part, Surroundings

NEEDED = {"sarosi": "sarosi", "chou_hannaford": "braid_angle", "tondu_lopez": "braid_angle", "table": "force_table"}
"""Laws of the force, and the field that each cannot do without."""


@dataclass(frozen=True)
class SarosiNumbers:
    """The six numbers of Sarosi's law."""

    a1: NumberLike = number("N/Pa", doc="Sarosi's a1")
    a2: NumberLike = number("N", doc="Sarosi's a2")
    a3: NumberLike = number("1", doc="Sarosi's a3, of contraction as a fraction", below=0.0)
    a4: NumberLike = number("N/Pa", doc="Sarosi's a4, of contraction as a fraction")
    a5: NumberLike = number("N/Pa", doc="Sarosi's a5")
    a6: NumberLike = number("N", doc="Sarosi's a6")


@dataclass(frozen=True)
class MuscleLawPart(Part):
    """A part with the law of a muscle's force."""

    nominal_length: NumberLike = number("m", doc="nominal length", above=0.0)
    nominal_diameter: NumberLike = number("m", doc="nominal diameter", above=0.0)
    law: str = option(*NEEDED, doc="law of the force")
    sarosi: Any = group(SarosiNumbers, doc="Sarosi's numbers", optional=True)
    braid_angle: NumberLike = number("rad", optional=True, doc="braid angle", above=0.0, below=math.pi / 2)
    end_factor: NumberLike = number("1", 1.0, doc="factor k of the ends", above=0.0, note="cylindrical ends")
    force_table: Any = reference(doc="measured force: table of lists")

    def check(self) -> None:
        if self.force_table is not None:
            object.__setattr__(self, "force_table", ForceRows.read(self.force_table))
        if getattr(self, NEEDED[self.law]) is None:
            raise InputError("muscle.law_needs", NEEDED[self.law], choice="law", value=self.law)

    def structure(self) -> Hashable:
        return super().structure(), None if self.force_table is None else self.force_table.structure()

    def numbers(self) -> dict[str, Number]:
        table = {} if self.force_table is None else self.force_table.numbers()
        return super().numbers() | {f"force_table.{name}": value for name, value in table.items()}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        table = {} if self.force_table is None else self.force_table.parameters(ambient.pressure)
        return super().parameters(ambient) | {f"force_table.{name}": value for name, value in table.items()}

    def force_law(self, numbers: Mapping[str, Any] | None = None) -> ForceLaw:
        """Force over gauge pressure and contraction.

        Parameters
        ----------
        numbers : mapping, optional
            Floats or symbols by local name; default the muscle's own.

        Returns
        -------
        ForceLaw
            With `force`, `pressure_for`, `slope`, `passive` and `swept`.
        """
        known = {name: each.value for name, each in self.numbers().items()} if numbers is None else numbers
        match self.law:
            case "sarosi":
                return Sarosi(*(known[f"sarosi.a{k}"] for k in range(1, 7)))
            case "table":
                names = self.force_table.numbers()
                return self.force_table.law({name: known[f"force_table.{name}"] for name in names})  # type: ignore[no-any-return]
            case "tondu_lopez":
                return TonduLopez(known["nominal_diameter"], known["braid_angle"], known["end_factor"])
            case _:
                return braid_of(known)

    def pressure_for(self, force: Any, contraction: Any) -> Any:
        """The pressure at which it pulls with a force, hysteresis and damping left out.

        Parameters
        ----------
        force : float or array
            Pull [N].
        contraction : float or array
            [1].

        Returns
        -------
        float or array
            Gauge pressure [Pa].
        """
        return self.force_law().pressure_for(force, contraction)


def braid_of(numbers: Mapping[str, Any]) -> ChouHannaford:
    """The braid of a nominal size."""
    return ChouHannaford(numbers["nominal_diameter"], numbers["nominal_length"], numbers["braid_angle"])
