"""Ideal gases with constant heat capacities at 20 degC.

The specific gas constant is R = 8.314462618 J/(mol K) / M with standard atomic weights. The isentropic
exponent is that of the ideal gas at 20 degC, from the heat capacity of the NASA polynomials.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from poppet.core.provenance import Number, Source
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT
from poppet.laws.physics.heat_transfer import AIR_CONDUCTIVITY, AIR_VISCOSITY, Sutherland
from poppet.laws.physics.real_gas import RealGas

MOLAR_GAS_CONSTANT = 8.314462618
"""CODATA 2018, exact to the digits shown [J/(mol K)]."""

NASA = "NASA polynomials, McBride, Gordon & Reno 1993, NASA TM-4513, at 293.15 K"
WEIGHTS = "CODATA 2018 R and IUPAC standard atomic weights (abridged, 2021)"
POLYNOMIALS = "NASA polynomials, McBride, Gordon & Reno 1993, NASA TM-4513, 200 to 1000 K"
EFFECTIVE = "effective, for the second virial coefficient at 293.15 K of"
ATMOSPHERE = "ISO 2533:1975, constants of the standard atmosphere"
FOR_AIR = "natural convection and vessel charging are calculated with the transport properties of air"
NOT_FOR_THIS = "the heat-transfer correlations take the transport properties of air and do not hold for this gas"
NEAR_AIR = "the heat-transfer correlations take the transport properties of air, within a few per cent of this gas"


@dataclass(frozen=True)
class Gas:
    """Ideal gas with constant heat capacities.

    Parameters
    ----------
    name : str
        Name, lower case.
    gas_constant : Number
        Specific gas constant [J/(kg K)].
    isentropic_exponent : Number
        Ratio of the heat capacities at 20 degC [1].
    note : str
        Note on the validity of the heat-transfer correlations for the gas.
    transport : mapping of str to Number
        Coefficients of Sutherland's law for viscosity and thermal conductivity; empty if they are not available.
    real : mapping of str to Number
        Properties of the real gas: critical temperature [K], critical pressure [Pa], acentric factor [1], and the
        coefficients of the polynomial c_p0/R in the temperature [K].

    Notes
    -----
    At room temperature, the error of the ideal gas law is within 1 % for air up to about 20 bar, and 3 % for carbon
    dioxide at 6 bar. The module `poppet.laws.physics.real_gas` computes such errors from `real`.

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
    real: Mapping[str, Number] = field(default_factory=dict)

    @property
    def is_like_air(self) -> bool:
        """True if the heat-transfer correlations, which use the viscosity and conductivity of air, are valid."""
        return self.note != NOT_FOR_THIS

    @property
    def as_real(self) -> RealGas:
        """Critical constants and heat capacity of the real gas.

        They determine the errors of the ideal gas law.
        """
        heat = tuple(float(value) for name, value in self.real.items() if name.startswith("heat_capacity."))
        critical, pressure, factor = (float(self.real[name]) for name in _CRITICAL)
        return RealGas(critical, pressure, factor, heat)

    def numbers(self) -> dict[str, Number]:
        """Return all parameters of the gas by name.

        Returns
        -------
        dict of str to Number
            `gas_constant`, `isentropic_exponent`, and all parameters in the attributes `transport` and `real`.
        """
        return {
            "gas_constant": self.gas_constant,
            "isentropic_exponent": self.isentropic_exponent,
            **self.transport,
            **self.real,
        }


_CRITICAL = ("critical_temperature", "critical_pressure", "acentric_factor")
# c_p0/R = a0 + a1 T + ... [K].
_N2 = (3.53100528, -1.23660987e-4, -5.02999437e-7, 2.43530612e-9, -1.40881235e-12)
_O2 = (3.78245636, -2.99673415e-3, 9.84730200e-6, -9.68129508e-9, 3.24372836e-12)
_H2 = (2.34433112, 7.98052075e-3, -1.94781510e-5, 2.01572094e-8, -7.37611761e-12)
_CO2 = (2.35677352, 8.98459677e-3, -7.12356269e-6, 2.45919022e-9, -1.43699548e-13)
_CH4 = (5.14987613, -1.36709788e-2, 4.91800599e-5, -4.84743026e-8, 1.66693956e-11)
_MONATOMIC = (2.5,)
_DRY_AIR = tuple(
    0.7812 * n + 0.2096 * o + 0.0092 * a for n, o, a in zip(_N2, _O2, (2.5, 0.0, 0.0, 0.0, 0.0), strict=True)
)


def _real_gas(
    critical: tuple[float, float, float], source: Source, heat_capacity: tuple[float, ...], mixture: str = ""
) -> dict[str, Number]:
    """Return the parameters of a real gas as numbers with sources.

    `critical` contains the critical temperature [K], the critical pressure [Pa] and the acentric factor [1], and
    `source` is their source. `heat_capacity` contains the coefficients of the polynomial c_p0/R in the temperature [K].
    `mixture` is a note on the composition.
    """
    units = dict(zip(_CRITICAL, ("K", "Pa", "1"), strict=True))
    numbers = {name: Number(x, unit, source) for x, (name, unit) in zip(critical, units.items(), strict=True)}
    nasa = Source("paper", POLYNOMIALS, mixture)
    powers = ("1", "1/K", "1/K^2", "1/K^3", "1/K^4")
    return numbers | {f"heat_capacity.{i}": Number(a, powers[i], nasa) for i, a in enumerate(heat_capacity)}


def _from_molar_mass(
    name: str, molar_mass: float, isentropic_exponent: float, note: str, real: Mapping[str, Number]
) -> Gas:
    """Return a gas whose specific gas constant follows from its molar mass [kg/mol].

    `real` contains the properties of the real gas, see `Gas`.
    """
    weight = Source("standard", WEIGHTS, f"M = {1e3 * molar_mass:.6g} g/mol")
    return Gas(
        name,
        Number(MOLAR_GAS_CONSTANT / molar_mass, "J/(kg K)", weight),
        Number(isentropic_exponent, "1", Source("paper", NASA)),
        note,
        real=real,
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
    _real_gas(
        (132.53, 3.786e6, 0.0335),
        Source("paper", "Lemmon et al., J. Phys. Chem. Ref. Data 29 (2000) 331"),
        _DRY_AIR,
        "0.7812 nitrogen, 0.2096 oxygen, 0.0092 argon",
    ),
)
_ARGON = _real_gas(
    (150.687, 4.863e6, -0.0022), Source("paper", "Tegeler et al., J. Phys. Chem. Ref. Data 28 (1999) 779"), _MONATOMIC
)
_CARBON_DIOXIDE = _real_gas(
    (304.128, 7.3773e6, 0.2239), Source("paper", "Span & Wagner, J. Phys. Chem. Ref. Data 25 (1996) 1509"), _CO2
)
_METHANE = _real_gas(
    (190.564, 4.5992e6, 0.0114), Source("paper", "Setzmann & Wagner, J. Phys. Chem. Ref. Data 20 (1991) 1061"), _CH4
)
_NITROGEN = _real_gas(
    (126.192, 3.3958e6, 0.0372), Source("paper", "Span et al., J. Phys. Chem. Ref. Data 29 (2000) 1361"), _N2
)
_OXYGEN = _real_gas(
    (154.581, 5.043e6, 0.0222), Source("paper", "Schmidt & Wagner, Fluid Phase Equilib. 19 (1985) 175"), _O2
)
# Quantum effects dominate the critical points of these two gases: Tc after Gunn, Chueh & Prausnitz, AIChE J. 12 (1966)
# 937.
_HELIUM = _real_gas(
    (10.47, 0.972e6, 0.0), Source("assumed", note=f"{EFFECTIVE} Ortiz Vega et al. 2020, 11.87 cm3/mol"), _MONATOMIC
)
_HYDROGEN = _real_gas(
    (43.6, 2.318e6, 0.0), Source("assumed", note=f"{EFFECTIVE} Leachman et al. 2009, 14.44 cm3/mol"), _H2
)

GASES: Mapping[str, Gas] = {
    gas.name: gas
    for gas in (
        AIR,
        _from_molar_mass("argon", 39.95e-3, 5 / 3, NOT_FOR_THIS, _ARGON),
        _from_molar_mass("carbon dioxide", 44.009e-3, 1.2908, NOT_FOR_THIS, _CARBON_DIOXIDE),
        _from_molar_mass("helium", 4.0026e-3, 5 / 3, NOT_FOR_THIS, _HELIUM),
        _from_molar_mass("hydrogen", 2.016e-3, 1.4060, NOT_FOR_THIS, _HYDROGEN),
        _from_molar_mass("methane", 16.043e-3, 1.3058, NOT_FOR_THIS, _METHANE),
        _from_molar_mass("nitrogen", 28.014e-3, 1.3996, NEAR_AIR, _NITROGEN),
        _from_molar_mass("oxygen", 31.998e-3, 1.3952, NEAR_AIR, _OXYGEN),
    )
}
ALIASES: Mapping[str, str] = {"dry air": "air"}
