"""Stores in which the gas is not ideal: where, and what that means."""

from __future__ import annotations

from collections.abc import Iterator

from poppet.circuit.instance import Array
from poppet.core.codes import Note
from poppet.laws.physics.real_gas import deviation
from poppet.library import Gas

TRUSTED = 0.01
"""Error of mass and of choked flow up to which nothing is said."""
EVERYDAY = {
    "air": 10e5,
    "argon": 7e5,
    "helium": 17e5,
    "hydrogen": 15e5,
    "methane": 2.7e5,
    "nitrogen": 12e5,
    "oxygen": 7e5,
}
"""Absolute pressures up to which a gas is that close to ideal anywhere in `MILD` [Pa]: of most runs nothing need be
reckoned, which takes as long as a third of a run."""
MILD = (250.0, 400.0)
"""[K]"""
OF_STATES = ("gas.not_ideal", "gas.no_gas")
"""Codes of what is said of states, those at the start or those of a run."""


def far_from_ideal(name: str, pressures: Array, temperatures: Array, gas: Gas) -> Iterator[Note]:
    """The note on a store, from (n_times,) states, where it is furthest from the library's ideal gas."""
    is_everyday = pressures.max() <= EVERYDAY.get(gas.name, 0.0)
    if is_everyday and MILD[0] <= temperatures.min() and temperatures.max() <= MILD[1]:
        return
    known, kappa, worst, note = gas.as_real, float(gas.isentropic_exponent), TRUSTED, None
    # Not every row: the worst lies at the highest pressure or at an extreme of temperature, or near it.
    for row in {int(pressures.argmax()), int(temperatures.argmax()), int(temperatures.argmin())}:
        pressure, temperature = float(pressures[row]), float(temperatures[row])
        if pressure <= 0.0:
            continue
        facts = {"gas": gas.name, "pressure_bar": pressure / 1e5, "temperature": temperature}
        found = deviation(pressure, temperature, known, kappa)
        if found is None:
            note = Note("gas.no_gas", name, **facts)
            break
        error = max(abs(found.mass), abs(found.flow))
        if error > worst:
            errors = {"mass_percent": 100.0 * found.mass, "flow_percent": 100.0 * found.flow}
            worst, note = error, Note("gas.not_ideal", name, **facts, compressibility=found.compressibility, **errors)
    if note:
        yield note
