"""Runs of a safety audit: an event at one moment, with one fault and one sample of the parameters."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from poppet.audit.events import event_signals, with_fixed_sweeps, with_switches
from poppet.audit.pressure_holds import FinalState
from poppet.audit.safety_result import EventValue, Moment, SafetyCurves
from poppet.audit.settling import Motion, motion_of, sample_times, time_below
from poppet.audit.valve_faults import STUCK_KINDS, ValveFault, with_idle_faults
from poppet.audit.volumes import bodies_of, volumes_of
from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.engine.batch import usable_cores
from poppet.engine.problem import Problem, RawRun, ending, is_failure
from poppet.engine.solve import solve

CURVE_POINTS = 600
"""Maximum number of points of a stored curve."""
REFUSED = "ensemble.refused_run"
"""Code of the note on a run whose parameter values contradict each other, so that it is not possible."""


class AuditCase(NamedTuple):
    """One run of the audit."""

    fault: int  # index of the fault, -1 in normal operation
    moment: int  # index of the moment
    sample: int = -1  # index of the sample, -1 for the parameters of the circuit


@dataclass(frozen=True, eq=False)
class AuditRunResult:
    """Results of one run of the audit. In a failed run, `failure` is the reason and all values are NaN."""

    times: Mapping[str, float]  # exhaust time of each volume [s]
    pressures: Mapping[str, tuple[float, float]]  # gauge pressures of each volume at the event and at the end [Pa]
    motions: Mapping[str, Motion]  # of each body
    curves: SafetyCurves | None = None
    failure: Note | None = None


class SafetyRuns:
    """Runs of a safety audit, which share one compiled model.

    `circuit` is the audited circuit, `events` the values of the event, and `faults` the simulated faults. `threshold`
    is the gauge pressure below which a volume counts as exhausted [Pa], and `duration` the simulated time after the
    event [s]. Assign `moments` and `samples` before a run.
    """

    def __init__(
        self, circuit: BaseCircuit, events: tuple[EventValue, ...], faults: Sequence[ValveFault], threshold: float,
        duration: float,
    ) -> None:  # fmt: skip
        self.circuit = with_idle_faults(with_switches(with_fixed_sweeps(circuit), events), faults)
        self.events, self.faults, self.threshold = events, tuple(faults), threshold
        self.moments: tuple[Moment, ...] = ()
        self.samples: tuple[Mapping[str, float], ...] = ()
        self.time = sample_times(duration)
        self.volumes, self.bodies = volumes_of(self.circuit), bodies_of(self.circuit)
        observed = [address for addresses in self.volumes.values() for address in addresses]
        observed += [f"{body}.{name}" for body in self.bodies for name in ("position", "velocity")]
        names = [name for name, _ in self.circuit.model.outputs]
        indices = [names.index(address) for address in observed]
        # Stop conditions use the indices of all outputs.
        has_conditions = any(curve.edge == "error" for curve, _ in self.circuit.domains.values())
        self.kernel = self.circuit.kernel if has_conditions else self.circuit.kernel.observing(indices)
        self.rows = dict(zip(observed, indices if has_conditions else range(len(indices)), strict=True))

    def fault_name(self, fault: int) -> str:
        """Return the name of a fault, `VALVE.WORD`, for its index; it is empty in normal operation."""
        return self.faults[fault].name if fault >= 0 else ""

    def with_event(self, time: float) -> BaseCircuit:
        """Return the circuit with the event at a given time [s]; an infinite time omits the event."""
        return self.circuit.with_signals(event_signals(self.circuit, self.events, time))

    def problem(self, case: AuditCase) -> Problem:
        """Return the definition of one run, with all outputs at the sample times."""
        moment = self.moments[case.moment].time
        values: dict[str, Any] = dict(self.samples[case.sample]) if case.sample >= 0 else {}
        values |= self.faults[case.fault].values(moment) if case.fault >= 0 else {}
        circuit = self.circuit.with_values(values) if values else self.circuit
        shift = self._ambient_pressure(case) - self.circuit.surroundings.pressure
        events = tuple(replace(event, value=event.value + shift) if event.is_gauge else event for event in self.events)
        circuit = circuit.with_signals(event_signals(circuit, events, moment))
        end = moment + float(self.time[-1])
        # Without the stop conditions of the file, which could end the run before the volumes are exhausted.
        problem = circuit.instance.problem(circuit.run.changed(duration=end, output_step=end, stop_when=()))
        return replace(problem, grid=np.append(moment + self.time[:-1], end))

    def _ambient_pressure(self, case: AuditCase) -> float:
        """Return the ambient pressure of one run, to which gauge pressures refer [Pa]."""
        sample = self.samples[case.sample] if case.sample >= 0 else {}
        return sample.get("ambient.pressure", self.circuit.surroundings.pressure)

    def run(self, case: AuditCase) -> AuditRunResult:
        """Run one case, and return its results."""
        try:
            problem = self.problem(case)
        except InputError:
            if case.sample < 0:
                raise
            return self._failed(Note(REFUSED))
        raw = solve(replace(problem, kernel=self.kernel), self.circuit.run.solver)
        if is_failure(problem, raw) or raw.time.size < self.time.size:
            return self._failed(ending(problem, raw))
        return self._evaluate(case, raw)

    def _failed(self, reason: Note) -> AuditRunResult:
        return AuditRunResult(
            dict.fromkeys(self.volumes, math.nan), dict.fromkeys(self.volumes, (math.nan, math.nan)),
            dict.fromkeys(self.bodies, Motion(math.nan, math.nan, math.nan, math.nan)), failure=reason,
        )  # fmt: skip

    def _evaluate(self, case: AuditCase, raw: RawRun) -> AuditRunResult:
        time, ambient = self.time, self._ambient_pressure(case)
        gauge = {
            volume: raw.values[[self.rows[address] for address in addresses]].max(axis=0) - ambient
            for volume, addresses in self.volumes.items()
        }
        position = {body: raw.values[self.rows[f"{body}.position"]] for body in self.bodies}
        velocity = {body: raw.values[self.rows[f"{body}.velocity"]] for body in self.bodies}
        curves = None
        if case.sample < 0:
            # Points in proportion to the logarithm of the time show fast and slow volumes.
            points = np.append(0.0, np.geomspace(1e-3, time[-1], CURVE_POINTS - 1))
            k = np.unique(np.minimum(np.searchsorted(time, points), time.size - 1))
            series = ({name: values[k] for name, values in group.items()} for group in (gauge, position))
            curves = SafetyCurves(self.fault_name(case.fault), self.moments[case.moment], time[k], *series)
        return AuditRunResult(
            {volume: time_below(time, values - self.threshold) for volume, values in gauge.items()},
            {volume: (float(values[0]), float(values[-1])) for volume, values in gauge.items()},
            {body: motion_of(time, position[body], velocity[body]) for body in self.bodies},
            curves,
        )

    def run_all(self, cases: Sequence[AuditCase]) -> Iterator[tuple[AuditCase, AuditRunResult]]:
        """Run cases on all processors, and yield each with its results when it is complete."""
        with ThreadPoolExecutor(max(1, min(usable_cores(), len(cases)))) as pool:
            futures = {pool.submit(self.run, case): case for case in cases}
            try:
                for future in as_completed(futures):
                    yield futures[future], future.result()
            finally:
                pool.shutdown(wait=True, cancel_futures=True)

    def final_state(self, case: AuditCase) -> FinalState:
        """Return the state at the end of one run, at which flow paths can be tested."""
        fault = self.faults[case.fault] if case.fault >= 0 else None
        stuck = fault.valve if fault is not None and fault.word in STUCK_KINDS else ""
        return FinalState(self.problem(case), self.circuit.parts, self.circuit.surroundings.pressure, stuck)
