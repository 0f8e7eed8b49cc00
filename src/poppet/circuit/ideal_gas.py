"""Notes on gas nodes whose gas deviates from an ideal gas."""

from __future__ import annotations

from collections.abc import Iterator

from poppet.circuit.instance import Array
from poppet.core.codes import Note
from poppet.laws.physics.real_gas import deviation
from poppet.library import Gas

TOLERANCE = 0.01
"""Largest relative error of mass and choked flow that needs no note."""
MAX_PRESSURES = {
    "air": 10e5,
    "argon": 7e5,
    "helium": 17e5,
    "hydrogen": 15e5,
    "methane": 2.7e5,
    "nitrogen": 12e5,
    "oxygen": 7e5,
}
"""Absolute pressures up to which the error of each gas is below `TOLERANCE` at `TEMPERATURES` [Pa].

Most runs remain below these pressures. They do not need the real-gas equations, which take a third of the run time."""
TEMPERATURES = (250.0, 400.0)
"""Temperature range of `MAX_PRESSURES` [K]."""
STATE_CODES = ("gas.not_ideal", "gas.no_gas")
"""Codes of notes on gas states, at the start or during a run."""


def real_gas_notes(name: str, pressures: Array, temperatures: Array, gas: Gas) -> Iterator[Note]:
    """Yield a note if the gas in a node deviates considerably from an ideal gas.

    `name` is the address of the gas node. `pressures` and `temperatures` are its states over time, (n_times,). The note
    reports the largest deviation.
    """
    low, high = TEMPERATURES
    if pressures.max() <= MAX_PRESSURES.get(gas.name, 0.0) and low <= temperatures.min() and temperatures.max() <= high:
        return
    kappa, worst, note = float(gas.isentropic_exponent), TOLERANCE, None
    # The largest deviation is at or near the highest pressure or an extreme temperature.
    for row in {int(pressures.argmax()), int(temperatures.argmax()), int(temperatures.argmin())}:
        pressure, temperature = float(pressures[row]), float(temperatures[row])
        if pressure <= 0.0:
            continue
        facts = {"gas": gas.name, "pressure_bar": pressure / 1e5, "temperature": temperature}
        errors = deviation(pressure, temperature, gas.as_real, kappa)
        if errors is None:
            note = Note("gas.no_gas", name, **facts)
            break
        error = max(abs(errors.mass), abs(errors.flow))
        if error > worst:
            percent = {"mass_percent": 100.0 * errors.mass, "flow_percent": 100.0 * errors.flow}
            worst, note = error, Note("gas.not_ideal", name, **facts, compressibility=errors.compressibility, **percent)
    if note:
        yield note
