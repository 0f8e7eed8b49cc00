"""Savings of air: each measure is simulated again, and compared with the audited cycle."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

from poppet.audit.energy_result import EXHAUSTED, HEAT, MIXING, REPEATED, EnergyAudit, SavingRow
from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.parts import Cylinder, PressureRegulator, Reservoir, Tube
from poppet.parts.part import AMBIENT

STANDARD_BORES = tuple(
    1e-3 * bore for bore in (8, 10, 12, 16, 20, 25, 32, 40, 50, 63, 80, 100, 125, 160, 200, 250, 320)
)
"""Bores of cylinders in ISO 6432 (to 25 mm) and ISO 15552 (from 32 mm) [m]."""
PRESSURE_STEP, LEAST_PRESSURE = 1e5, 2e5
"""Reduction of a supply pressure, and smallest reduced gauge pressure [Pa]."""
COMPLETE = 0.98
"""Fraction of the range of motion in the audited cycle that a body must reach with a measure."""
REUSE = "reuse of exhaust air"
"""Name of the upper bound for the reuse of exhaust air."""
_Circuit = TypeVar("_Circuit", bound=BaseCircuit)


@dataclass(frozen=True)
class Measure:
    """Change of a circuit that can save air: its name, and the changed values by address."""

    name: str
    values: Mapping[str, Any]


def default_measures(circuit: BaseCircuit, audit: EnergyAudit) -> list[Measure]:
    """Return the measures that suit a circuit: lower pressures, smaller bores and shorter tubes.

    The pressure of each supply and of each pressure regulator is lower by 1 bar, if at least 2 bar (gauge) remain. Each
    cylinder has the next smaller standard bore. All tubes together have half of their length. Pressures that a signal
    or a connection determines are not changed.
    """
    return [*_lower_pressures(circuit, audit), *_smaller_bores(circuit), *_shorter_tubes(circuit)]


def _lower_pressures(circuit: BaseCircuit, audit: EnergyAudit) -> Iterator[Measure]:
    for name, part in circuit.parts.items():
        if isinstance(part, Reservoir) and audit.air.get(name, 0.0) > 0.0:
            address = f"{name}.pressure"
        elif isinstance(part, PressureRegulator):
            address = f"{name}.setpoint"
        else:
            continue
        if address in circuit.signals or address in circuit.connections or address not in circuit.parameters:
            continue
        gauge = circuit.parameters[address] - circuit.surroundings.pressure - PRESSURE_STEP
        if gauge >= LEAST_PRESSURE:
            text = f"{1e-5 * gauge:.4g} bar g"
            yield Measure(f"{address} = {text}", {address: text})


def _smaller_bores(circuit: BaseCircuit) -> Iterator[Measure]:
    for name, part in circuit.parts.items():
        if not isinstance(part, Cylinder):
            continue
        bore, rod = float(part.bore), float(part.rod_diameter or 0.0)  # type: ignore[arg-type]
        smaller = [size for size in STANDARD_BORES if rod < size < 0.999 * bore]
        if smaller:
            text = f"{1e3 * smaller[-1]:g} mm"
            yield Measure(f"{name}.bore = {text}", {f"{name}.bore": text})


def _shorter_tubes(circuit: BaseCircuit) -> Iterator[Measure]:
    lengths = {
        f"{name}.length": f"{0.5 * float(part.length):.6g} m"  # type: ignore[arg-type]
        for name, part in circuit.parts.items()
        if isinstance(part, Tube)
    }
    if lengths:
        changes = ", ".join(f"{address} = {text}" for address, text in lengths.items())
        yield Measure(changes if len(lengths) <= 2 else "half of the length of all tubes", lengths)


def find_savings(
    circuit: _Circuit,
    audit: EnergyAudit,
    audit_circuit: Callable[[_Circuit], EnergyAudit],
    measures: Sequence[Measure] | None = None,
) -> tuple[tuple[SavingRow, ...], tuple[Note, ...]]:
    """Return the savings of measures, and notes on measures with which the machine does not complete its cycle.

    Parameters
    ----------
    circuit : Circuit
        The audited circuit.
    audit : EnergyAudit
        Audit of the circuit.
    audit_circuit : callable
        Function that audits a changed circuit in the same way.
    measures : sequence of Measure, optional
        Measures, by default those of `default_measures`.

    Returns
    -------
    tuple
        Savings in the order of the measures, with the upper bound for exhaust air at the end; and notes.

    Notes
    -----
    Costs and emissions per year refer to the number of cycles per year without the measure, so a slower cycle is not a
    saving. A measure is rejected if the run fails, the steps of the cycle change, or a body loses more than 2 % of its
    range of motion.
    """
    rows, notes = [], []
    motion = _ranges(circuit, audit)
    for measure in default_measures(circuit, audit) if measures is None else measures:
        try:
            changed = circuit.with_values(measure.values)
            result = audit_circuit(changed)
            new_motion = _ranges(changed, result)
        except InputError as error:
            notes.append(Note("savings.failed", measure.name, reason=f"{error.given} {error.reason}"))
            continue
        except SimulationError as error:
            notes.append(Note("savings.failed", measure.name, reason=str(error)))
            continue
        if result.cycle.steps != audit.cycle.steps:
            steps = {"steps": result.cycle.steps, "expected": audit.cycle.steps}
            notes.append(Note("savings.steps", measure.name, **steps))
        elif short := [body for body, extent in motion.items() if new_motion[body] < COMPLETE * extent]:
            body = min(short, key=lambda name: new_motion[name] / motion[name])
            facts = {"body": body, "fraction": new_motion[body] / motion[body]}
            notes.append(Note("savings.motion", measure.name, **facts))
        else:
            rows.append(_saving(measure.name, audit, result))
            if result.cycle.change > REPEATED:
                notes.append(Note("savings.not_repeated", measure.name, change=result.cycle.change))
    return (*rows, *reuse_bound(circuit, audit)), tuple(notes)


def _saving(measure: str, audit: EnergyAudit, result: EnergyAudit) -> SavingRow:
    cycles = math.nan if audit.tariff is None else audit.tariff.cycles_per_year(audit.cycle.duration)
    return SavingRow(
        measure,
        audit.air_used - result.air_used,
        audit.exergy_supplied - result.exergy_supplied,
        (audit.cost - result.cost) * cycles,
        (audit.co2 - result.co2) * cycles,
        result.cycle.duration,
    )


def _ranges(circuit: BaseCircuit, audit: EnergyAudit) -> dict[str, float]:
    """Return the range of motion of each body during the audited cycle."""
    recording = audit.recording
    if recording is None:
        return {}
    window = (recording.time >= audit.cycle.start) & (recording.time <= audit.cycle.end)
    bodies = dict.fromkeys(circuit.instance.bodies.values())
    return {body: float(np.ptp(recording[f"{body}.position"][window])) for body in bodies}


def reuse_bound(circuit: BaseCircuit, audit: EnergyAudit) -> list[SavingRow]:
    """Return an upper bound of the saving if exhaust air is used again; the list is empty without exhaust air.

    The bound is the exergy of the air that enters the exhaust side. This side consists of the flow paths and gas nodes
    from which all air flows to the surroundings. A device there cannot recover more if the cycle does not change. Leaks
    and volumes of actuators are not part of the exhaust side. The bound of the air is the supplied air with the same
    exergy.
    """
    leaks = {leak.flow_path for leak in audit.leaks}
    inner = {store.name for store in circuit.kernel.model.stores if store.work is not None}
    inner |= {name for name, volume in audit.air.items() if volume > 0.0}
    exhaust_side = {"", AMBIENT} - inner
    directions = [(path.source, path.target) for path in audit.flow_paths if path.forward > 0.0]
    directions += [(path.target, path.source) for path in audit.flow_paths if path.backward > 0.0]
    while True:
        feeding = {source for source, target in directions if target not in exhaust_side}
        grown = exhaust_side | ({source for source, _ in directions} - feeding - inner)
        if grown == exhaust_side:
            break
        exhaust_side = grown
    exergy = audit.total(EXHAUSTED)
    exergy += math.fsum(
        path.throttling for path in audit.flow_paths if path.target in exhaust_side and path.name not in leaks
    )
    exergy += math.fsum(row.exergy for row in audit.rows if row.category in (MIXING, HEAT) and row.name in exhaust_side)
    if exergy <= 0.0 or audit.exergy_supplied <= 0.0:
        return []
    air = audit.air_used * exergy / audit.exergy_supplied
    tariff = audit.tariff
    cost = co2 = math.nan
    if tariff is not None:
        cycles = tariff.cycles_per_year(audit.cycle.duration)
        cost, co2 = tariff.cost(air) * cycles, tariff.co2(air) * cycles
    return [SavingRow(REUSE, air, exergy, cost, co2, audit.cycle.duration, is_bound=True)]
