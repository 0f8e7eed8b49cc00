"""Survey of air leaks in a plant: leak flows by four methods, and their cost per year.

The formulas are those of the compressed air leak survey of the US Department of Energy and Oak Ridge National
Laboratory (AMO-Tools-Suite, `CompressedAirLeakSurvey`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from poppet.audit.tariff import Tariff
from poppet.core.errors import InputError, OutOfRangeError
from poppet.core.toml import ResultFileMixin

SURVEY_GAS_CONSTANT = 53.34 * 32.2 * 0.3048**2 * 1.8
"""Gas constant of air in the survey: 53.34 ft lbf/(lb °R) and 32.2 ft/s², converted to J/(kg K)."""
SURVEY_EXPONENT = 1.4
"""Isentropic exponent of air in the survey."""


def bag_flow(diameter: float, height: float, fill_time: float) -> float:
    r"""Return the leak flow that fills a cylindrical bag.

    .. math:: q = \frac{\pi d^2 h}{4 t}

    Parameters
    ----------
    diameter, height : float
        Size of the filled bag [m].
    fill_time : float
        Time until the bag is full [s].

    Returns
    -------
    float
        Volume flow of free air [m^3/s].

    Raises
    ------
    OutOfRangeError
        If an argument is not a finite number above 0.

    Examples
    --------
    >>> round(bag_flow(0.254, 0.381, 12.0) * 6e4, 2)
    96.53
    """
    _check_positive(diameter=diameter, height=height, fill_time=fill_time)
    return math.pi * diameter**2 * height / (4.0 * fill_time)


def decibel_flow(
    pressure: float,
    level: float,
    *,
    pressures: tuple[float, float],
    levels: tuple[float, float],
    flows: tuple[tuple[float, float], tuple[float, float]],
    pressure_unit: str = "",
) -> float:
    r"""Return the leak flow for an ultrasonic sound level, from the table of the detector.

    .. math::

        q = \sum_{i,j} w_i v_j\, q_{ij}, \qquad
        w_2 = \frac{L - L_1}{L_2 - L_1} = 1 - w_1, \qquad v_2 = \frac{p - p_1}{p_2 - p_1} = 1 - v_1

    Parameters
    ----------
    pressure : float
        Line pressure, in the unit of `pressures`.
    level : float
        Measured sound level [dB].
    pressures, levels : tuple of float
        Two pressures and two sound levels of the table that enclose the measurement.
    flows : tuple of tuple of float
        Flows of the table: for each level, the flows at both pressures.
    pressure_unit : str, optional
        Unit of the pressures, for errors.

    Returns
    -------
    float
        Volume flow in the unit of `flows`.

    Raises
    ------
    InputError
        If both pressures or both levels are equal.
    OutOfRangeError
        If the measurement is outside the values of the table.

    Examples
    --------
    >>> flows = (1.04, 1.2), (1.85, 1.65)
    >>> round(decibel_flow(130.0, 25.0, pressures=(150.0, 125.0), levels=(20.0, 30.0), flows=flows), 9)
    1.429
    """
    level_weight = _weight("level", level, levels, "dB")
    pressure_weight = _weight("pressure", pressure, pressures, pressure_unit)
    at_levels = [(1.0 - pressure_weight) * first + pressure_weight * second for first, second in flows]
    return (1.0 - level_weight) * at_levels[0] + level_weight * at_levels[1]


def _weight(name: str, value: float, ends: tuple[float, float], unit: str) -> float:
    """Return the position of a value between two values of a table, from 0 to 1."""
    if ends[0] == ends[1]:
        raise InputError("leaks.equal_values", f"{name}s", value=ends[0], unit=unit)
    if not min(ends) <= value <= max(ends):
        raise OutOfRangeError("leaks.outside_table", name, value=value, low=min(ends), high=max(ends), unit=unit)
    return (value - ends[0]) / (ends[1] - ends[0])


def orifice_flow(
    diameter: float,
    pressure: float,
    *,
    temperature: float,
    discharge_coefficient: float,
    ambient_pressure: float,
    gas_constant: float = SURVEY_GAS_CONSTANT,
) -> float:
    r"""Return the choked leak flow through a round hole.

    .. math::

        q = C_d\, \frac{\pi d^2}{4}\, \frac{p}{p_a} \left(\frac{2}{\kappa + 1}\right)^{1/(\kappa - 1)}
        \sqrt{\frac{2 \kappa}{\kappa + 1} R T}

    Parameters
    ----------
    diameter : float
        Diameter of the hole [m].
    pressure : float
        Absolute pressure in the line [Pa].
    temperature : float
        Temperature of the air in the line [K].
    discharge_coefficient : float
        Ratio of the flow to that of an ideal nozzle: about 0.6 for a hole with sharp edges, up to 1 for a round one.
    ambient_pressure : float
        Absolute pressure of the surroundings [Pa].
    gas_constant : float, optional
        Specific gas constant [J/(kg K)].

    Returns
    -------
    float
        Volume flow at ambient pressure and line temperature [m^3/s].

    Raises
    ------
    OutOfRangeError
        If an argument is not a finite number above 0, or the flow is not choked. The pressure must be at least 1.893
        times the ambient pressure.

    Notes
    -----
    AMO-Tools-Suite evaluates the formula at any pressure. At a lower line pressure, the flow is not choked and the
    formula is not valid; `poppet.iso6358` then gives the flow.

    Examples
    --------
    >>> flow = orifice_flow(1e-3, 7e5, temperature=293.15, discharge_coefficient=1.0, ambient_pressure=1e5)
    >>> round(flow * 6e4, 1)
    65.5
    """
    _check_positive(diameter=diameter, temperature=temperature, discharge_coefficient=discharge_coefficient,
                    ambient_pressure=ambient_pressure)  # fmt: skip
    exponent = SURVEY_EXPONENT
    critical_pressure: float = ambient_pressure * (0.5 * (exponent + 1.0)) ** (exponent / (exponent - 1.0))
    if not pressure >= critical_pressure:
        raise OutOfRangeError("leaks.not_choked", "pressure", value=pressure, least=critical_pressure)
    density_ratio: float = pressure / ambient_pressure * (2.0 / (exponent + 1.0)) ** (1.0 / (exponent - 1.0))
    speed = math.sqrt(2.0 * exponent / (exponent + 1.0) * gas_constant * temperature)
    return discharge_coefficient * 0.25 * math.pi * diameter**2 * density_ratio * speed


def _check_positive(**values: float) -> None:
    for name, value in values.items():
        if not 0.0 < value < math.inf:
            raise OutOfRangeError("leaks.not_positive", name, value=value)


@dataclass(frozen=True)
class PlantLeak:
    """Leak of a plant: name, flow of one leak, and number of equal leaks."""

    name: str
    flow: float  # of one leak [m^3/s ANR]
    count: int = 1
    method: str = "estimate"  # estimate, bag, decibel or orifice


@dataclass(frozen=True)
class LeakCost:
    """Flow of a leak, and its air, electricity, cost and CO2 per year.

    `cost` and `saved_cost` are NaN if the tariff has no price, and `co2` is NaN if it has no emission.
    """

    leak: PlantLeak | None  # None in the sum of all leaks
    flow: float  # of all equal leaks [m^3/s ANR]
    volume: float  # [m^3 ANR per year]
    electricity: float  # [J per year]
    cost: float  # [currency per year]
    co2: float  # [kg per year]
    saved_cost: float  # by a repair [currency per year]


@dataclass(frozen=True)
class LeakSurvey(ResultFileMixin):
    """Result of a leak survey: all leaks, with the largest flow first, and their sum."""

    title: str
    tariff: Tariff
    control_fraction: float  # fraction of the electricity for the leaking air that a repair saves, 0 to 1
    leaks: tuple[LeakCost, ...]
    total: LeakCost

    def content(self) -> dict[str, Any]:
        return {
            "title": self.title,
            "tariff": self.tariff.content(),
            "control_fraction": self.control_fraction,
            "total": _row(self.total),
            "leaks": [_row(row) for row in self.leaks],
        }


def _row(row: LeakCost) -> dict[str, Any]:
    leak = row.leak
    start = {} if leak is None else {"leak": leak.name, "method": leak.method, "count": leak.count}
    return start | {
        "air_l_anr_per_min": row.flow * 6e4,
        "air_m3_anr_per_year": row.volume,
        "electricity_kwh_per_year": row.electricity / 3.6e6,
        "cost_per_year": _known(row.cost),
        "co2_kg_per_year": _known(row.co2),
        "saved_cost_per_year": _known(row.saved_cost),
    }


def _known(value: float) -> float | None:
    """Return a value, or None for NaN, which a result file omits."""
    return None if math.isnan(value) else value


def survey_leaks(
    leaks: Sequence[PlantLeak], tariff: Tariff, *, title: str = "", control_fraction: float = 1.0
) -> LeakSurvey:
    """Return the cost of leaks per year.

    Parameters
    ----------
    leaks : sequence of PlantLeak
        The leaks of the plant.
    tariff : Tariff
        Prices, specific energy and operating time, see `read_tariff`.
    title : str, optional
        Title of the survey.
    control_fraction : float, optional
        Fraction of the electricity for the leaking air that a repair saves. It depends on the control of the
        compressor: 1 if the power is proportional to the flow, less if the compressor also needs power without flow.

    Returns
    -------
    LeakSurvey
        Leaks, with the largest flow first, and their sum.

    Raises
    ------
    OutOfRangeError
        If `control_fraction` is not from 0 to 1.

    Examples
    --------
    >>> from poppet.audit.tariff import read_tariff
    >>> tariff = read_tariff({"tariff": "0.20 EUR/kWh", "specific_energy": "0.12 kWh/m^3", "hours": "4000 h"})
    >>> survey = survey_leaks([PlantLeak("press 3", 60e-3 / 60.0)], tariff)
    >>> round(survey.total.volume, 6), round(survey.total.cost, 6)
    (14400.0, 345.6)
    """
    if not 0.0 <= control_fraction <= 1.0:
        raise OutOfRangeError("leaks.fraction", "control_fraction", value=control_fraction)
    rows = sorted((_cost_row(leak, leak.flow * leak.count, tariff, control_fraction) for leak in leaks),
                  key=lambda row: -row.flow)  # fmt: skip
    total = _cost_row(None, math.fsum(row.flow for row in rows), tariff, control_fraction)
    return LeakSurvey(title, tariff, control_fraction, tuple(rows), total)


def _cost_row(leak: PlantLeak | None, flow: float, tariff: Tariff, control_fraction: float) -> LeakCost:
    volume = flow * float(tariff.hours)
    cost = tariff.cost(volume)
    return LeakCost(leak, flow, volume, tariff.electricity(volume), cost, tariff.co2(volume), control_fraction * cost)
