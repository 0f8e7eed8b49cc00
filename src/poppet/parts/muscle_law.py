"""Force law of a muscle with parameters, for the parts `muscle` and `inverse_muscle`."""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from typing import Any

from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.laws.physics.muscle import ChouHannaford, ForceLaw, Sarosi, TonduLopez
from poppet.parts.fields import NumberLike, group, number, option, reference
from poppet.parts.part import Part, Surroundings
from poppet.parts.rows import ForceRows

REQUIRED = {"sarosi": "sarosi", "chou_hannaford": "braid_angle", "tondu_lopez": "braid_angle", "table": "force_table"}
"""Force laws and the field that each law requires."""


@dataclass(frozen=True)
class SarosiNumbers:
    """Parameters a1 to a6 of Sarosi's force law of a muscle."""

    a1: NumberLike = number("N/Pa", doc="Sarosi's a1")
    a2: NumberLike = number("N", doc="Sarosi's a2")
    a3: NumberLike = number("1", doc="Sarosi's a3, of contraction as a fraction", below=0.0)
    a4: NumberLike = number("N/Pa", doc="Sarosi's a4, of contraction as a fraction")
    a5: NumberLike = number("N/Pa", doc="Sarosi's a5")
    a6: NumberLike = number("N", doc="Sarosi's a6")


@dataclass(frozen=True)
class MuscleLawPart(Part):
    """Base class of parts that use the force law of a muscle."""

    nominal_length: NumberLike = number("m", doc="nominal length; without pressure and load", above=0.0)
    nominal_diameter: NumberLike = number("m", doc="nominal inner diameter; without pressure and load", above=0.0)
    law: str = option(*REQUIRED, doc="force law")
    sarosi: Any = group(SarosiNumbers, doc="parameters of Sarosi's law", optional=True)
    braid_angle: NumberLike = number("rad", optional=True, doc="braid angle to the axis", above=0.0, below=math.pi / 2)
    end_factor: NumberLike = number(
        "1", 1.0, doc="factor k of the ends; above 1 for tapered ends", above=0.0, note="cylindrical ends"
    )
    force_table: Any = reference(doc="measured force; mapping of lists contraction, force_per_pressure, passive_force")

    def check(self) -> None:
        if self.force_table is not None:
            object.__setattr__(self, "force_table", ForceRows.read(self.force_table))
        if getattr(self, REQUIRED[self.law]) is None:
            raise InputError("muscle.law_needs", REQUIRED[self.law], choice="law", value=self.law)

    def structure(self) -> Hashable:
        return super().structure(), None if self.force_table is None else self.force_table.structure()

    def numbers(self) -> dict[str, Number]:
        table = {} if self.force_table is None else self.force_table.numbers()
        return super().numbers() | {f"force_table.{name}": value for name, value in table.items()}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        table = {} if self.force_table is None else self.force_table.parameters(ambient.pressure)
        return super().parameters(ambient) | {f"force_table.{name}": value for name, value in table.items()}

    def force_law(self, numbers: Mapping[str, Any] | None = None) -> ForceLaw:
        """Return the force of the muscle as a function of gauge pressure and contraction.

        Parameters
        ----------
        numbers : mapping, optional
            Parameters of the law in SI units by name; default those of the part.

        Returns
        -------
        ForceLaw
            Object whose method `force` returns the force [N] for a gauge pressure [Pa] and a contraction [1].
        """
        values = {name: number.value for name, number in self.numbers().items()} if numbers is None else numbers
        match self.law:
            case "sarosi":
                return Sarosi(*(values[f"sarosi.a{k}"] for k in range(1, 7)))
            case "table":
                names = self.force_table.numbers()
                return self.force_table.law({name: values[f"force_table.{name}"] for name in names})  # type: ignore[no-any-return]
            case "tondu_lopez":
                return TonduLopez(values["nominal_diameter"], values["braid_angle"], values["end_factor"])
            case _:
                return braid_of(values)

    def pressure_for(self, force: Any, contraction: Any) -> Any:
        """Return the gauge pressure at which the muscle exerts a given force.

        Hysteresis and damping are not included.

        Parameters
        ----------
        force : float or array
            Pulling force [N].
        contraction : float or array
            Contraction [1].

        Returns
        -------
        float or array
            Gauge pressure [Pa].
        """
        return self.force_law().pressure_for(force, contraction)


def braid_of(numbers: Mapping[str, Any]) -> ChouHannaford:
    """Return the force law of a braided muscle from its nominal size.

    `numbers` contains `nominal_diameter` [m], `nominal_length` [m] and `braid_angle` [rad].
    """
    return ChouHannaford(numbers["nominal_diameter"], numbers["nominal_length"], numbers["braid_angle"])
