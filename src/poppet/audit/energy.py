"""Audit of one machine cycle: air, energy and exergy."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from poppet.audit.air import air_of_parts
from poppet.audit.cycle import find_cycle, read_cycle, with_change
from poppet.audit.energy_result import (
    EXHAUSTED,
    FRICTION,
    HEAT,
    INTEGRATION,
    MIXING,
    STORED,
    SUPPLIED,
    THROTTLING,
    WORK,
    BalanceRow,
    Cycle,
    EnergyAudit,
    FlowPathAir,
    PartRow,
)
from poppet.audit.energy_run import EnergyRun, run_energy
from poppet.audit.moves import find_moves
from poppet.audit.tariff import Tariff
from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.energy_trace import EnergyTerm
from poppet.circuit.options import Run
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.units import ANR
from poppet.laws.physics.gas import AIR_GAS_CONSTANT
from poppet.parts.part import AMBIENT, TUBE
from poppet.parts.sequence import Sequence
from poppet.timeseries.recording import Recording

AT_AMBIENT = 1e-6
"""Largest relative difference from the ambient pressure of a reservoir that receives exhaust air."""
CLOSED, INTEGRATED = 1e-9, 1e-3
"""Residual of a balance, and integration error, relative to the sum of all rows, above which a note reports them."""
LOSSES = (THROTTLING, MIXING, HEAT, FRICTION, EXHAUSTED)
"""Categories of exergy that is lost in a part."""


def audit_energy(
    circuit: BaseCircuit,
    *,
    cycle: Cycle | str | None = None,
    step: str = "",
    count: int = 1,
    duration: Any = None,
    tariff: Tariff | None = None,
    progress: Callable[[float], Any] | None = None,
) -> EnergyAudit:
    r"""Audit one machine cycle of a circuit: air, energy and exergy.

    .. math:: \sum_\text{supplies} E = \sum_\text{loads} W + \sum_\text{losses} E_L + \Delta E

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration in its run options.
    cycle : Cycle or str, optional
        Period of the audit, for example ``"0.5 s, 1.9 s"`` (default: last whole cycle of the run).
    step : str, optional
        Step of a sequence with which the cycle begins (default: the first step that the sequence enters twice).
    count : int, optional
        Number of successive cycles whose mean is evaluated, at least 1. A stated period contains this number.
    duration : float or str, optional
        Duration of the run [s] (default: duration in the run options).
    tariff : Tariff, optional
        Prices and emissions of compressed air.
    progress : callable, optional
        Function that is called with the time reached [s].

    Returns
    -------
    EnergyAudit

    Raises
    ------
    InputError
        If the run contains no cycle, the stated period is invalid or after its end, or `count` is less than 1.
    SimulationError
        If the run failed.

    Notes
    -----
    See docs/energy_audit.md for the definition of each row. Each row is an integral of its own. The integrator applies
    one formula to all integrals, so the balances close except for rounding errors. The row `integration` is the
    difference between the integral and the state function of the stored energy.

    References
    ----------
    Cai, Kawashima & Kagawa 2002, Power assessment of flowing compressed air, for the exergy of air; ISO 8778 for ANR.
    """
    if count < 1:
        raise InputError("cycle.no_count", "--cycles", value=count)
    circuit.require_equations()
    run = circuit.run.changed(duration=duration)
    recording = circuit.simulate(run.duration, _output_step(circuit, run), progress=progress)
    if cycle is None:
        cycle = find_cycle(circuit, recording, step=step, count=count)
    elif isinstance(cycle, str):
        cycle = replace(read_cycle(cycle), count=count)
    end = float(recording.time[-1])
    if cycle.end > end * (1.0 + 1e-12):
        raise InputError("cycle.beyond_end", "--cycle", end=cycle.end, duration=end)
    result = run_energy(circuit, run, (cycle.start, cycle.end), cycle.count, progress)
    cycle = with_change(cycle, result.energy.model, result.values[list(result.energy.states)])
    supplies = {""} | {name for name, pressure in _reservoirs(circuit, recording, result).items() if pressure > 1.0}
    tubes = {name for name, part in circuit.parts.items() if part.kind == TUBE}
    masses = {store.name: result.values[result.energy.states[store.mass]] for store in result.energy.model.stores}
    rows = tuple(_balance_rows(circuit, recording, result))
    flow_paths = tuple(_flow_paths(circuit, result))
    audit = EnergyAudit(
        circuit.title,
        cycle,
        _air_of_supplies(circuit, result, supplies),
        rows,
        flow_paths,
        _part_rows(circuit, rows, air_of_parts(result, masses, supplies, tubes)),
        tariff=tariff,
        notes=(*recording.remarks, *cycle.notes(), *_limits(circuit, result, rows)),
        recording=recording,
        moves=find_moves(circuit, recording, (cycle.start, cycle.end)),
    )
    return replace(audit, notes=(*audit.notes, *_accuracy_notes(audit)))


def _output_step(circuit: BaseCircuit, run: Run) -> float | None:
    """Return a time between rows in which a sequence changes its step at most once, or None without a sequence."""
    periods = [float(part.sample_time) for part in circuit.parts.values() if isinstance(part, Sequence)]  # type: ignore[arg-type]
    step = None if run.output_step is None else float(run.output_step)  # type: ignore[arg-type]
    return min((*periods, *([] if step is None else [step])), default=None)


def anr_volume(circuit: BaseCircuit, mass: float) -> float:
    """Return the volume of a mass of the gas of a circuit [kg] at ANR [m^3]."""
    # The density of air is the value of the standard, for moist air.
    density: float = ANR.density * AIR_GAS_CONSTANT / circuit.surroundings.gas_constant
    return mass / density


def _reservoirs(circuit: BaseCircuit, recording: Recording, run: EnergyRun) -> dict[str, float]:
    """Return the highest pressure of each reservoir, relative to the ambient pressure.

    The result is 1 for the ambient, and for a reservoir whose pressure is that of the ambient during the whole run.
    """
    ambient, ratios = circuit.surroundings.pressure, {}
    for name in {term.node for term in run.energy.terms if term.node}:
        ratios[name] = 1.0
        if name != AMBIENT:
            pressures = recording[f"{name}.pressure"] / ambient
            low, high = float(pressures.min()), float(pressures.max())
            ratios[name] = high if high > 1.0 + AT_AMBIENT else low if low < 1.0 - AT_AMBIENT else 1.0
    return ratios


def _balance_rows(circuit: BaseCircuit, recording: Recording, run: EnergyRun) -> list[BalanceRow]:
    """Return all rows of the balances of energy and exergy that are not zero."""
    reservoirs = _reservoirs(circuit, recording, run)
    drawn: dict[str, list[float]] = defaultdict(lambda: [0.0, 0.0])
    rows = []

    def add(term: EnergyTerm, category: str, sign: float = 1.0) -> None:
        energy, exergy = sign * run.integral(term.energy), sign * run.integral(term.exergy)
        rows.append(BalanceRow(term.name, term.part, category, energy, exergy))

    for term in run.energy.terms:
        if term.kind != "supply":
            add(term, {"throttling": THROTTLING, "mixing": MIXING, "heat": HEAT, "work": WORK}.get(term.kind, FRICTION))
        elif term.node and reservoirs[term.node] == 1.0:
            add(term, EXHAUSTED, -1.0)
        else:
            values = drawn[term.node or term.part]
            values[0] += run.integral(term.energy)
            values[1] += run.integral(term.exergy)
    supplied = [BalanceRow(name, name, SUPPLIED, *values) for name, values in drawn.items()]
    stored = [
        BalanceRow(term.name, term.part, STORED, run.change(term.energy), run.change(term.exergy))
        for term in run.energy.stored
    ]
    totals = run.integral(run.energy.stored_energy), run.integral(run.energy.stored_exergy)
    errors = (
        total - math.fsum(getattr(row, quantity) for row in stored)
        for total, quantity in zip(totals, ("energy", "exergy"), strict=True)
    )
    rows = [*supplied, *rows, *stored, BalanceRow("integration", "", INTEGRATION, *errors)]
    return [row for row in rows if row.energy != 0.0 or row.exergy != 0.0]


def _flow_paths(circuit: BaseCircuit, run: EnergyRun) -> list[FlowPathAir]:
    throttling = {term.name: run.integral(term.exergy) for term in run.energy.terms if term.kind == "throttling"}
    return [
        FlowPathAir(
            flow.name, flow.part, flow.source, flow.target, anr_volume(circuit, run.integral(flow.net)),
            anr_volume(circuit, run.integral(flow.forward)), throttling.get(flow.name, 0.0),
        )
        for flow in run.energy.flows
    ]  # fmt: skip


def _air_of_supplies(circuit: BaseCircuit, run: EnergyRun, supplies: set[str]) -> dict[str, float]:
    """Return the air that each reservoir or flow source supplies per cycle [m^3 ANR]."""
    air: dict[str, float] = defaultdict(float)
    for flow in run.energy.flows:
        for node, sign in ((flow.source, 1.0), (flow.target, -1.0)):
            if node in supplies:
                air[node or flow.part] += sign * anr_volume(circuit, run.integral(flow.net))
    return dict(air)


def _part_rows(circuit: BaseCircuit, rows: tuple[BalanceRow, ...], air: Mapping[str, float]) -> tuple[PartRow, ...]:
    """Return air and lost exergy of all parts that have at least one of both, in descending order of the loss."""
    lost: dict[str, dict[str, float]] = {part: {} for part in air}
    for row in rows:
        if row.category in LOSSES:
            of_part = lost.setdefault(row.part, {})
            of_part[row.category] = of_part.get(row.category, 0.0) + row.exergy
    parts = [
        PartRow(
            part, anr_volume(circuit, air.get(part, 0.0)), math.fsum(losses.values()),
            max(losses, key=lambda category: losses[category], default=""),
        )
        for part, losses in lost.items()
    ]  # fmt: skip
    return tuple(sorted(parts, key=lambda row: -row.exergy_lost))


def _limits(circuit: BaseCircuit, run: EnergyRun, rows: tuple[BalanceRow, ...]) -> list[Note]:
    """Return notes on what the balances do not contain."""
    heats = {row.name: row.exergy for row in rows if row.category == HEAT}
    notes = [Note("energy.implied_heat", name, exergy=heats[name]) for name in run.energy.implied if name in heats]
    # A polytropic pilot volume has no input for the rate of its displacement.
    driven = [name for name in run.energy.implied if f"{name}.displacement" in circuit.signals]
    notes += [Note("energy.unknown_work", name) for name in driven]
    compressors = [name for name, part in circuit.parts.items() if part.kind == "compressor"]
    return [*notes, *(Note("energy.compressor", name) for name in compressors)]


def _accuracy_notes(audit: EnergyAudit) -> list[Note]:
    """Return notes on a balance that does not close, and on inaccurate integrals."""
    notes = []
    residual = max((audit.residual(quantity) for quantity in ("energy", "exergy")), key=abs)
    if abs(residual) > CLOSED:
        notes.append(Note("energy.not_closed", residual=residual))
    errors = [abs(audit.total(INTEGRATION, quantity=quantity)) for quantity in ("energy", "exergy")]
    scale = sum(abs(row.exergy) for row in audit.rows)
    if max(errors) > INTEGRATED * scale:
        notes.append(Note("energy.inaccurate", error=max(errors)))
    return notes
