"""Gases as ideal gases at room temperature.

The specific gas constant is R = 8.314462618 J/(mol K) / M with standard atomic weights. The isentropic
exponent is that of the ideal gas at 20 degC, from the heat capacity of the NASA polynomials.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from poppet.ground.provenance import Number, Source
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT
from poppet.laws.physics.heat_transfer import AIR_CONDUCTIVITY, AIR_VISCOSITY, Sutherland

MOLAR_GAS_CONSTANT = 8.314462618
"""CODATA 2018, exact to the digits shown [J/(mol K)]."""

NASA = "NASA polynomials, McBride, Gordon & Reno 1993, NASA TM-4513, at 293.15 K"
WEIGHTS = "CODATA 2018 R and IUPAC standard atomic weights (abridged, 2021)"
ATMOSPHERE = "ISO 2533:1975, constants of the standard atmosphere"
FOR_AIR = "natural convection and vessel charging are calculated with the transport properties of air"
NOT_FOR_THIS = "the heat-transfer correlations take the transport properties of air and do not hold for this gas"
NEAR_AIR = "the heat-transfer correlations take the transport properties of air, within a few per cent of this gas"


@dataclass(frozen=True)
class Gas:
    """An ideal gas with constant heat capacities.

    Parameters
    ----------
    name : str
        Name, lower case.
    gas_constant : Number
        Specific gas constant [J/(kg K)].
    isentropic_exponent : Number
        Ratio of the heat capacities at 20 degC [1].
    note : str
        For which laws of the house the gas may be used.
    transport : mapping of str to Number
        Coefficients of Sutherland's law, empty where none is given.

    Notes
    -----
    Ideal: for air to about 20 bar at room temperature within 1 %; carbon dioxide is 3 % off at 6 bar.

    Examples
    --------
    >>> float(GASES["air"].gas_constant), float(GASES["air"].isentropic_exponent)
    (287.05, 1.4)
    """

    name: str
    gas_constant: Number
    isentropic_exponent: Number
    note: str
    transport: Mapping[str, Number] = field(default_factory=dict)

    def numbers(self) -> dict[str, Number]:
        """All numbers of the gas.

        Returns
        -------
        dict of str to Number
            `gas_constant`, `isentropic_exponent` and the coefficients of transport.
        """
        return {
            "gas_constant": self.gas_constant,
            "isentropic_exponent": self.isentropic_exponent,
            **self.transport,
        }


def _from_molar_mass(name: str, molar_mass: float, isentropic_exponent: float, note: str) -> Gas:
    """A gas from its molar mass [kg/mol]."""
    weight = Source("standard", WEIGHTS, f"M = {1e3 * molar_mass:.6g} g/mol")
    return Gas(
        name,
        Number(MOLAR_GAS_CONSTANT / molar_mass, "J/(kg K)", weight),
        Number(isentropic_exponent, "1", Source("paper", NASA)),
        note,
    )


def _sutherland(name: str, law: Sutherland, unit: str) -> dict[str, Number]:
    source = Source("paper", law.source)
    return {
        f"{name}.reference_value": Number(law.reference_value, unit, source),
        f"{name}.reference_temperature": Number(law.reference_temperature, "K", source),
        f"{name}.sutherland_temperature": Number(law.sutherland_temperature, "K", source),
    }


AIR = Gas(
    "air",
    Number(AIR_GAS_CONSTANT, "J/(kg K)", Source("standard", ATMOSPHERE, "dry air; rounded from 287.05287")),
    Number(AIR_ISENTROPIC_EXPONENT, "1", Source("standard", ATMOSPHERE)),
    FOR_AIR,
    {
        **_sutherland("dynamic_viscosity", AIR_VISCOSITY, "Pa s"),
        **_sutherland("thermal_conductivity", AIR_CONDUCTIVITY, "W/(m K)"),
    },
)

GASES: Mapping[str, Gas] = {
    gas.name: gas
    for gas in (
        AIR,
        _from_molar_mass("argon", 39.95e-3, 5 / 3, NOT_FOR_THIS),
        _from_molar_mass("carbon dioxide", 44.009e-3, 1.2908, NOT_FOR_THIS),
        _from_molar_mass("helium", 4.0026e-3, 5 / 3, NOT_FOR_THIS),
        _from_molar_mass("hydrogen", 2.016e-3, 1.4060, NOT_FOR_THIS),
        _from_molar_mass("methane", 16.043e-3, 1.3058, NOT_FOR_THIS),
        _from_molar_mass("nitrogen", 28.014e-3, 1.3996, NEAR_AIR),
        _from_molar_mass("oxygen", 31.998e-3, 1.3952, NEAR_AIR),
    )
}
ALIASES: Mapping[str, str] = {"dry air": "air"}
