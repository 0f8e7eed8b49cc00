"""Fault table: runs of a circuit with every single fault of a valve, and their consequences."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import Any

from poppet.audit.consequences import RunPair, cycle_times, find_consequences
from poppet.audit.fault_result import Consequence, FaultRow, FaultTable, OmittedFault
from poppet.audit.moments import row_step
from poppet.audit.safety import read_positive
from poppet.audit.valve_faults import ValveFault, read_kinds, split_faults, valves_of, with_idle_faults
from poppet.audit.visits import visits_of
from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.units import quantity
from poppet.engine.batch import usable_cores
from poppet.parts.faults import FAULTS
from poppet.parts.sequence import Sequence as StepSequence

Progress = Callable[[int, int, str], Any]
"""Callback with the completed runs, the number of all runs, and the fault of the last run."""


def fault_table(
    circuit: BaseCircuit,
    *,
    kinds: Sequence[str] = FAULTS,
    start: Any = 0.0,
    duration: Any = None,
    threshold: Any = "0.5 bar",
    progress: Progress | None = None,
) -> FaultTable:
    """Return the consequences of every single fault of the valves of a circuit.

    Parameters
    ----------
    circuit : Circuit
        Circuit with its signals and connections.
    kinds : sequence of str, optional
        Faults to simulate (default: `stuck_open`, `stuck_closed`, `stuck`, `slow`, `leak`). A valve that already has a
        fault keeps it in all runs.
    start : float or str, optional
        Time at which each fault begins [s].
    duration : float or str, optional
        Duration of each run [s] (default: duration in the run options of the circuit).
    threshold : float or str, optional
        Gauge pressure below which a volume counts as exhausted [Pa].
    progress : callable, optional
        Function that is called with the completed runs, their total, and the fault of the last run.

    Returns
    -------
    FaultTable
        One row per fault, with all differences from the healthy run.

    Raises
    ------
    InputError
        If an argument is invalid, or no valve without a fault can have one of the faults.
    SimulationError
        If the healthy run fails.

    Notes
    -----
    All runs have the same signals, and share one compiled model. Results do not depend on the output step of the
    circuit. The table shows what happens in this run only: another run can reveal other consequences.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, DirectionalValve
    >>> tank = Chamber(volume="1 l", initial_pressure="6 bar g", thermal="isothermal")
    >>> dump = DirectionalValve(
    ...     supply="tank", outlet="ambient", command=1.0, sonic_conductance="1 dm^3/(s bar)", critical_ratio=0.3,
    ...     switching_time="20 ms",
    ... )
    >>> table = fault_table(Circuit({"tank": tank, "dump": dump}), duration="4 s")
    >>> [consequence.kind for consequence in table.row("dump.stuck_closed").consequences]
    ['pressure_stays']
    """
    with ErrorCollector() as errors:
        with errors.collecting():
            limit = read_positive("threshold", threshold, "Pa", "pressure_difference")
        with errors.collecting():
            begin = quantity(start, "s", name="start").value
        with errors.collecting():
            selected = read_kinds(kinds)
        with errors.collecting():
            # The times of the rows of the file end with its duration.
            end = (
                float(circuit.run.grid()[-1]) if duration is None else read_positive("duration", duration, "s", "plain")
            )
    if not 0.0 <= begin < end:
        raise InputError("safety.outside_run", "start", subject="fault", time=begin, end=end)
    if not selected:
        raise InputError("safety.no_kinds", "kinds", kinds=FAULTS)
    faults, omitted = split_faults(valves_of(circuit), selected)
    if not faults:
        raise InputError("safety.no_valve", circuit.title, kinds=list(selected))
    circuit.require_equations()
    base = with_idle_faults(circuit, faults)
    healthy = base.simulate(end, row_step(end), stop_when=())

    def run(fault: ValveFault) -> FaultRow:
        faulty = base.with_values(fault.values(begin)).simulate(end, row_step(end), stop_when=(), throw=False)
        if faulty.time.size < healthy.time.size:
            time = float(faulty.time[-1]) if faulty.time.size else 0.0
            failed = Consequence("failed", "run", time=time, facts={"reason": faulty.outcome})
            return FaultRow(fault.valve, fault.word, (failed,))
        return FaultRow(fault.valve, fault.word, find_consequences(RunPair(base, healthy, faulty, begin, limit)))

    rows: dict[str, FaultRow] = {}
    is_whole = True
    with ThreadPoolExecutor(max(1, min(usable_cores(), len(faults)))) as pool:
        futures = [pool.submit(run, fault) for fault in faults]
        try:
            for future in as_completed(futures):
                row = future.result()
                rows[row.fault] = row
                if progress is not None:
                    progress(len(rows), len(faults), row.fault)
        except KeyboardInterrupt:
            is_whole = False
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
    sequence = next((name for name, part in circuit.parts.items() if isinstance(part, StepSequence)), None)
    cycles = [] if sequence is None else cycle_times(visits_of(healthy, sequence))
    return FaultTable(
        circuit.title,
        begin,
        end,
        limit,
        tuple(rows[fault.name] for fault in faults if fault.name in rows),
        tuple(
            OmittedFault(*fault, str(Note("safety.not_possible", fault.name, kind=circuit.parts[fault.valve].kind)))
            for fault in omitted
        ),
        cycles[-1] if cycles else None,
        (*circuit.static_notes, Note("safety.one_run"), *(() if is_whole else (Note("safety.interrupted"),))),
        is_whole,
    )
