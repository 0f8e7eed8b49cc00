"""Work of the compression of an ideal gas."""

from __future__ import annotations

from typing import Any

from poppet.core.symbolic import maximum


def isentropic_compression_work(
    inlet_pressure: Any, outlet_pressure: Any, inlet_temperature: Any, gas_constant: Any, isentropic_exponent: Any
) -> Any:
    r"""Return the specific work of a steady isentropic compression.

    .. math:: w = \frac{\kappa}{\kappa - 1} R T_1 \left[\left(\frac{p_2}{p_1}\right)^{(\kappa - 1)/\kappa} - 1\right]

    Parameters
    ----------
    inlet_pressure, outlet_pressure : float, array or symbol
        Absolute pressures p1 and p2 [Pa].
    inlet_temperature : float, array or symbol
        Temperature T1 of the gas at the inlet [K].
    gas_constant, isentropic_exponent : float, array or symbol
        Specific gas constant R [J/(kg K)] and ratio of the heat capacities [1].

    Returns
    -------
    float, array or symbol
        Work per mass of gas; 0 for an outlet pressure below the inlet pressure [J/kg].

    Notes
    -----
    Kinetic energy is neglected. No adiabatic compressor needs less work, which is a consequence of the second law.

    Examples
    --------
    >>> print(f"{isentropic_compression_work(1e5, 8e5, 293.15, 287.05, 1.4) / 1e3:.1f} kJ/kg")
    239.0 kJ/kg
    """
    exponent = (isentropic_exponent - 1.0) / isentropic_exponent
    ratio = maximum(outlet_pressure / inlet_pressure, 1.0)
    return gas_constant * inlet_temperature / exponent * (ratio**exponent - 1.0)
