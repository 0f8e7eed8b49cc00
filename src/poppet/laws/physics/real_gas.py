"""Errors of the ideal gas law with constant heat capacities: density and choked flow of a real gas."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from poppet.laws.iso6358.nozzle import nozzle_choked_flux

_Terms = tuple[tuple[float, float], ...]
_Virial = tuple[tuple[float, float, float], ...]
# Exponents k and coefficients a of sums of a (T/Tc)^-k: simple fluid, and contribution of the acentric factor.
_B: tuple[_Terms, _Terms] = (
    ((0.0, 0.1445), (1.0, -0.330), (2.0, -0.1385), (3.0, -0.0121), (8.0, -0.000607)),
    ((0.0, 0.0637), (2.0, 0.331), (3.0, -0.423), (8.0, -0.008)),
)
_C: tuple[_Terms, _Terms] = (
    ((0.0, 0.01407), (2.8, 0.02432), (10.5, -0.00313)),
    ((0.0, -0.02676), (2.8, 0.0177), (3.0, 0.04), (6.0, -0.003), (10.5, -0.00228)),
)
_STEP = 0.055  # step of ln(density) up to the throat; smaller steps change the flow by at most 2e-4
_CLEARLY_IDEAL = 0.005  # limit of the upstream deviation; the error of the flow is then below 0.01


@dataclass(frozen=True)
class RealGas:
    """Parameters of a real gas for correlations of virial coefficients and heat capacity.

    Parameters
    ----------
    critical_temperature, critical_pressure : float
        Critical temperature Tc [K] and critical pressure pc [Pa]; for helium and hydrogen, effective values.
    acentric_factor : float
        Acentric factor omega [1].
    heat_capacity : tuple of float
        Coefficients a0, a1, ... of the heat capacity of the ideal gas c_p0/R = a0 + a1 T + a2 T^2 + ..., with T in K
        from 200 to 1000.
    """

    critical_temperature: float
    critical_pressure: float
    acentric_factor: float
    heat_capacity: tuple[float, ...]


@dataclass(frozen=True)
class Deviation:
    """Differences between an ideal gas and the real gas in one state.

    Parameters
    ----------
    compressibility : float
        Compressibility factor Z = p/(rho R T) [1].
    isentropic_exponent : float
        Logarithmic slope of pressure versus density on the isentrope in this state [1].
    mass : float
        Relative error of the mass in a volume by the ideal gas law: ideal value / real value - 1 [1].
    flow : float
        Relative error of the choked flow from this state through a nozzle by the ideal gas law [1].
    """

    compressibility: float
    isentropic_exponent: float
    mass: float
    flow: float


@lru_cache(maxsize=256)
def deviation(pressure: float, temperature: float, gas: RealGas, isentropic_exponent: float) -> Deviation | None:
    r"""Return the deviation of an ideal gas from the real gas in one state.

    The real gas obeys a virial equation with the coefficients B and C.

    .. math::

        \frac{p}{\varrho R T} = Z = 1 + B \varrho + C \varrho^2, \qquad
        \frac{B p_c}{R T_c} = f_0 + \omega f_1, \qquad \frac{C p_c^2}{R^2 T_c^2} = g_0 + \omega g_1

    .. math::

        \frac{c_v}{R} = \frac{c_{p0}}{R} - 1 - (2 T B' + T^2 B'') \varrho - (2 T C' + T^2 C'') \frac{\varrho^2}{2},
        \qquad q_m = \max_\varrho\, \varrho \sqrt{2 \int \frac{\mathrm{d}p}{\varrho}} \ \text{on the isentrope}

    Parameters
    ----------
    pressure, temperature : float
        Absolute pressure [Pa] and temperature [K].
    gas : RealGas
        Critical constants and heat capacity.
    isentropic_exponent : float
        Isentropic exponent kappa of the ideal gas [1].

    Returns
    -------
    Deviation or None
        Differences between both gases. None for a liquid, and for a state near a liquid, for which the virial equation
        has no solution.

    Notes
    -----
    Reference equations of state give the same errors of mass and flow within a fifth of the larger error
    (tests/published). This was tested for air, argon, nitrogen, oxygen, methane, helium and hydrogen from 230 to 450 K
    up to 200 bar, and for carbon dioxide above 350 K or as a gas up to 20 bar.

    If Z and the choked flow by the isentropic exponent of the upstream state deviate from the ideal gas by at most 0.5
    %, the integral along the isentrope is not computed. Below Tc the state counts as a liquid if ln(p/pc) exceeds 5.373
    (1 + omega) (1 - Tc/T), a vapour-pressure curve that follows from the definition of omega.

    References
    ----------
    Tsonopoulos, AIChE J. 20 (1974) 263, for B; Orbey & Vera, AIChE J. 29 (1983) 107, for C.

    Examples
    --------
    Nitrogen at 200 bar and 20 degC; the reference equation of state gives Z = 1.052 and a flow error of -5.7 %:

    >>> nitrogen = RealGas(126.192, 3.3958e6, 0.0372, (3.531, -1.2366e-4, -5.03e-7, 2.4353e-9, -1.4088e-12))
    >>> found = deviation(200e5, 293.15, nitrogen, 1.4)
    >>> round(found.compressibility, 3), round(100 * found.flow, 1)
    (1.042, -5.9)
    """
    virial = _virial_coefficients(temperature, gas)
    density = _reduced_density(pressure, temperature, gas, virial)
    if density is None:
        return None
    z, slope, thermal, heat = _state_properties(density, temperature, gas, virial)
    if heat <= 0.0:
        return None
    exponent = (slope + thermal**2 / heat) / z
    ideal = nozzle_choked_flux(isentropic_exponent, 1.0)
    # The flow by the upstream state alone is sufficient for small deviations.
    flow = ideal / nozzle_choked_flux(exponent, z) - 1.0 if exponent > 1.0 else math.inf
    if max(abs(flow), abs(z - 1.0)) > _CLEARLY_IDEAL:
        unit = gas.critical_pressure / gas.critical_temperature
        flow = ideal * pressure / (unit * math.sqrt(temperature) * _choked_flux(density, temperature, gas)) - 1.0
    return Deviation(z, exponent, z - 1.0, flow)


def _reduced_density(pressure: float, temperature: float, gas: RealGas, virial: _Virial) -> float | None:
    """Return the density of a real gas divided by pc/(R Tc).

    The result is None for a liquid. `virial` contains the coefficients B and C with their derivatives.
    """
    reduced = temperature / gas.critical_temperature
    share = pressure / gas.critical_pressure
    if reduced < 1.0 and math.log(max(share, 1e-300)) > 5.373 * (1.0 + gas.acentric_factor) * (1.0 - 1.0 / reduced):
        return None
    (b, _, _), (c, _, _) = virial
    density = target = share / reduced
    for _ in range(40):
        slope = 1.0 + 2.0 * b * density + 3.0 * c * density**2
        # Newton's method from the ideal gas reaches the spinodal if there is no solution for a gas.
        if slope <= 0.0:
            return None
        step = (density * (1.0 + b * density + c * density**2) - target) / slope
        density -= step
        if abs(step) <= 1e-12 * density:
            break
    return density


def _virial_coefficients(temperature: float, gas: RealGas) -> _Virial:
    """Return the virial coefficients B and C with their derivatives with respect to the temperature.

    The result contains B, T dB/dT and T^2 d2B/dT2 in units of R Tc/pc, and the same for C in units of (R Tc/pc)^2.
    """
    reduced = temperature / gas.critical_temperature

    def coefficient(simple: _Terms, acentric: _Terms) -> tuple[float, float, float]:
        terms = [(k, a * reduced**-k) for k, a in simple]
        terms += [(k, gas.acentric_factor * a * reduced**-k) for k, a in acentric]
        return sum(t for _, t in terms), -sum(k * t for k, t in terms), sum(k * (k + 1.0) * t for k, t in terms)

    return coefficient(*_B), coefficient(*_C)


def _state_properties(
    density: float, temperature: float, gas: RealGas, virial: _Virial
) -> tuple[float, float, float, float]:
    """Return Z, (dp/drho)/(R T), (dp/dT)/(rho R) and c_v/R of a real gas.

    `density` is relative to pc/(R Tc). `virial` contains the coefficients B and C with their derivatives.
    """
    (b, b1, b2), (c, c1, c2) = virial
    z = 1.0 + b * density + c * density**2
    slope = 1.0 + 2.0 * b * density + 3.0 * c * density**2
    thermal = 1.0 + (b + b1) * density + (c + c1) * density**2
    # The polynomials are valid above 200 K; below, the heat capacity is nearly constant.
    limited = min(max(temperature, 200.0), 1000.0)
    heat = sum(a * limited**i for i, a in enumerate(gas.heat_capacity)) - 1.0
    return z, slope, thermal, heat - (2.0 * b1 + b2) * density - (2.0 * c1 + c2) * density**2 / 2.0


def _choked_flux(density: float, temperature: float, gas: RealGas) -> float:
    """Return the choked mass flux of a real gas, divided by sqrt(R).

    It is the maximum of density times velocity on the isentrope from the given upstream state. `density` and the
    density in the result are relative to pc/(R Tc). The integration uses steps of ln(density) and the midpoint rule.
    """

    def rates(logarithm: float, temperature: float) -> tuple[float, float]:
        _, slope, thermal, heat = _state_properties(
            math.exp(logarithm), temperature, gas, _virial_coefficients(temperature, gas)
        )
        return temperature * thermal / heat, 2.0 * temperature * (slope + thermal**2 / heat)

    logarithm, square = math.log(density), 0.0
    fluxes = [0.0]
    while len(fluxes) < 2 or fluxes[-1] > fluxes[-2]:
        cooling, _ = rates(logarithm, temperature)
        cooling, gain = rates(logarithm - _STEP / 2.0, temperature - cooling * _STEP / 2.0)
        temperature, square, logarithm = temperature - cooling * _STEP, square + gain * _STEP, logarithm - _STEP
        fluxes.append(math.exp(logarithm) * math.sqrt(square))
    previous, largest, next_flux = fluxes[-3:]
    # Maximum of the parabola through the last three values.
    return largest + (previous - next_flux) ** 2 / (8.0 * (2.0 * largest - previous - next_flux))
