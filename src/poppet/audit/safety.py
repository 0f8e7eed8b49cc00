"""Safety audit: exhaust times and travels after an event, in normal operation and with each single fault of a valve."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.audit.events import changes_nothing, default_value, read_events
from poppet.audit.moments import find_moments, healthy_run, present_value, read_times
from poppet.audit.pressure_holds import Hold
from poppet.audit.safety_result import EventValue, ExhaustTime, Moment, SafetyAudit, Travel
from poppet.audit.safety_runs import AuditCase, AuditRunResult, SafetyRuns
from poppet.audit.valve_faults import STUCK_KINDS, read_kinds, split_faults, valves_of
from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, UnitError
from poppet.core.units import quantity
from poppet.ensemble import plan_of
from poppet.parts.part import Part
from poppet.parts.sources import Reservoir
from poppet.parts.supply import PressureRegulator
from poppet.timeseries.recording import Recording

SAMPLES = 50
"""Default number of samples of the uncertain parameters."""
LOW, HIGH = 0.025, 0.975
"""Probabilities of the limits of the 95 % intervals."""

Results = Mapping[AuditCase, AuditRunResult]
Progress = Callable[[int, int, str], Any]
"""Callback with the completed runs, the number of all runs, and the fault of the last run."""


def audit_safety(
    circuit: BaseCircuit,
    events: Mapping[str, Any],
    *,
    at: Any = None,
    threshold: Any = "0.5 bar",
    duration: Any = "10 s",
    kinds: Sequence[str] = STUCK_KINDS,
    samples: int | None = None,
    seed: int | None = None,
    progress: Progress | None = None,
) -> SafetyAudit:
    """Return exhaust times and travels after an event, in normal operation and with each single fault of a valve.

    Parameters
    ----------
    circuit : Circuit
        Circuit with its signals and connections.
    events : mapping
        Mapping from the addresses of inputs to their values from the event on, in SI units or as texts with a unit:
        ``{"plc.emergency": 1, "supply.pressure": "0 bar g"}``.
    at : float, str or sequence, optional
        Times of the event [s], or `steps`: the start and the ends of the first three quarters of the last complete
        visit to each step. The default is `steps` if the circuit has a sequence, otherwise 20 times that divide the run
        evenly.
    threshold : float or str, optional
        Gauge pressure below which a volume counts as exhausted [Pa].
    duration : float or str, optional
        Simulated time after the event [s].
    kinds : sequence of str, optional
        Faults to simulate, one valve at a time (default: `stuck_open`, `stuck_closed`, `stuck`). Each fault begins at
        the event. A valve that already has a fault keeps it in all runs.
    samples : int, optional
        Number of samples of the uncertain parameters, for the 95 % intervals. The default is 50 if the file has the
        table `ensemble`; 0 computes no intervals.
    seed : int, optional
        Seed of the samples (default: that of the table `ensemble`).
    progress : callable, optional
        Function that is called with the completed runs, their total, and the fault of the last run.

    Returns
    -------
    SafetyAudit
        For each volume and body, the longest time or distance of all moments. A time is infinite if the volume is above
        the threshold at the end of the run.

    Raises
    ------
    InputError
        If an input is unknown, a value is invalid, the event changes nothing, or the circuit has neither volumes nor
        bodies.
    SimulationError
        If the run without the event fails.

    Notes
    -----
    Before the event, the circuit runs without the simulated fault. From the event on, each input of `events` has its
    value; a connection to this input has no effect. All other signals and connections are unchanged. A volume counts
    as exhausted after its *last* fall below the threshold. The travel is the length of the path, so it includes
    falling and rebounding. Results do not depend on the output step of the circuit.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, DirectionalValve
    >>> tank = Chamber(volume="1 l", initial_pressure="6 bar g", thermal="isothermal")
    >>> dump = DirectionalValve(
    ...     supply="tank", outlet="ambient", normally="open", command=1.0, initial_position=0.0,
    ...     sonic_conductance="1 dm^3/(s bar)", critical_ratio=0.3, switching_time="20 ms",
    ... )
    >>> circuit = Circuit({"tank": tank, "dump": dump})
    >>> audit = audit_safety(circuit, {"dump.command": 0}, at=0.0)
    >>> round(audit.exhaust_of("tank").time, 1), audit.exhaust_of("tank", "dump.stuck_closed").time
    (1.6, inf)
    """
    with ErrorCollector() as errors:
        with errors.collecting():
            limit = read_positive("threshold", threshold, "Pa", "pressure_difference")
        with errors.collecting():
            horizon = read_positive("duration", duration, "s", "plain")
        with errors.collecting():
            values = read_events(circuit, events)
        with errors.collecting():
            times = read_times(circuit, at)
        with errors.collecting():
            selected = read_kinds(kinds)
    circuit.require_equations()
    faults, _ = split_faults(valves_of(circuit), selected)
    runs = SafetyRuns(circuit, values, faults, limit, horizon)
    if not runs.volumes and not runs.bodies:
        raise InputError("safety.nothing", circuit.title)
    count = (SAMPLES if "ensemble" in circuit.origin.tables else 0) if samples is None else samples
    runs.samples = _samples(circuit, count, seed, horizon) if count else ()
    healthy = healthy_run(runs.with_event(math.inf), times)
    runs.moments = find_moments(circuit, healthy, times)
    _check_changes(circuit, healthy, values, runs.moments, is_stated=bool(times))
    results: dict[AuditCase, AuditRunResult] = {}
    cases = [AuditCase(fault, k) for fault in range(-1, len(faults)) for k in range(len(runs.moments))]
    is_whole = _collect(runs, cases, results, progress)
    worst = _worst_cases(runs, results)
    if is_whole and runs.samples:
        sampled = [case._replace(sample=k) for case in sorted(set(worst.values())) for k in range(len(runs.samples))]
        is_whole = _collect(runs, sampled, results, progress)
    return SafetyAudit(
        circuit.title,
        values,
        runs.moments,
        limit,
        horizon,
        tuple(fault.name for fault in faults),
        tuple(_exhaust_times(runs, results, worst)),
        tuple(_travels(runs, results, worst)),
        len(runs.samples),
        (*circuit.static_notes, *_notes(runs, results, is_selected=bool(selected), is_whole=is_whole)),
        tuple(_curves(runs, results, worst)),
        is_whole,
    )


def read_positive(name: str, given: Any, unit: str, kind: Any) -> float:
    """Return a positive threshold or duration in SI units; a threshold can be written as a gauge pressure.

    An InputError reports a value that is not above 0, and a UnitError a wrong unit.
    """
    try:
        read = quantity(given, unit, kind=kind, name=name)
    except UnitError:
        if kind != "pressure_difference":
            raise
        read = quantity(given, unit, kind="pressure", name=name)
        if read.reference != "gauge":
            raise
    if not read.value > 0.0:
        raise InputError("safety.not_positive", name, shown=str(given))
    return read.value


def _check_changes(
    circuit: BaseCircuit,
    healthy: Recording,
    events: Sequence[EventValue],
    moments: Sequence[Moment],
    *,
    is_stated: bool,
) -> None:
    """Raise an error if the event changes nothing, because the inputs already have its values.

    The keyword `is_stated` is True if the user has stated the moments: the event must then change an input at each.
    """
    idle = []
    for moment in moments:
        present = {
            event.address: present_value(healthy, event.address, moment.time, default_value(circuit, event.address))
            for event in events
        }
        if all(changes_nothing(event, present[event.address]) for event in events):
            idle.append(moment)
    if idle and (is_stated or len(idle) == len(moments)):
        raise InputError(
            "safety.no_change", events[0].address, events=[event.shown for event in events],
            time=idle[0].time if is_stated else None, is_always=not is_stated, count=len(moments),
        )  # fmt: skip


def _samples(circuit: BaseCircuit, count: int, seed: int | None, duration: float) -> tuple[Mapping[str, float], ...]:
    """Return samples of the uncertain parameters of the table `ensemble`, by address."""
    if count < 0:
        raise InputError("safety.negative_samples", "samples", value=count)
    if "ensemble" not in circuit.origin.tables:
        raise InputError("safety.no_distributions")
    if circuit.run.duration is None:
        circuit = circuit.with_values({"run.duration": duration})
    # A plan requires a metric or a curve, which the audit does not use.
    plan = plan_of(circuit, keep="bands", curves=[circuit.model.outputs[0][0]], requirements={}, allow_python=True)
    if plan.table is None:
        plan = replace(plan, runs=count, sampling="random" if plan.sampling == "grid" else plan.sampling)
        plan = plan if seed is None else replace(plan, seed=seed)
        sample = plan.sample(0, count)
    else:
        sample = plan.table[1][np.linspace(0, plan.runs - 1, min(count, plan.runs)).round().astype(int)]
    return tuple(dict(zip(plan.addresses, row.tolist(), strict=True)) for row in sample)


def _collect(
    runs: SafetyRuns, cases: Sequence[AuditCase], results: dict[AuditCase, AuditRunResult], progress: Progress | None
) -> bool:
    """Run cases and add their results; return False if Ctrl-C stopped the runs."""
    total = len(results) + len(cases)
    try:
        for case, result in runs.run_all(cases):
            results[case] = result
            if progress is not None:
                progress(len(results), total, runs.fault_name(case.fault) or "normal operation")
    except KeyboardInterrupt:
        return False
    return True


def _worst_cases(runs: SafetyRuns, results: Results) -> dict[tuple[int, str], AuditCase]:
    """Return the case with the longest time of each volume and the longest distance of each body, by fault.

    An unknown value counts as the longest. Faults with incomplete runs are omitted.
    """
    worst: dict[tuple[int, str], AuditCase] = {}
    for fault in range(-1, len(runs.faults)):
        cases = [AuditCase(fault, k) for k in range(len(runs.moments))]
        if not all(case in results for case in cases):
            continue
        for name in (*runs.volumes, *runs.bodies):

            def size(case: AuditCase, name: str = name) -> tuple[bool, float]:
                value = _value(results[case], name)
                return math.isnan(value), value

            worst[fault, name] = max(cases, key=size)
    return worst


def _value(result: AuditRunResult, name: str) -> float:
    """Return the exhaust time of a volume, or the distance of a body."""
    return result.times[name] if name in result.times else _distance(result, name)


def _distance(result: AuditRunResult, body: str) -> float:
    motion = result.motions[body]
    return math.inf if math.isinf(motion.stop_time) else motion.path


def _interval(
    runs: SafetyRuns, results: Results, worst: Mapping[tuple[int, str], AuditCase], fault: int, name: str
) -> dict[str, Any]:
    """Return the limits of the 95 % interval of a time or distance; empty without samples or with missing runs.

    Each sample has the largest value of the moments that are the worst of any volume or body with this fault.
    """
    moments = {case.moment for (other, _), case in worst.items() if other == fault}
    values = []
    for k in range(len(runs.samples)):
        cases = [AuditCase(fault, moment, k) for moment in moments]
        if not all(case in results for case in cases):
            return {}  # interrupted
        if all(results[case].failure is None for case in cases):
            values.append(max(_value(results[case], name) for case in cases))
    if not values:
        return {}
    # The samples at or beyond both probabilities, without interpolation: some can be infinite.
    values.sort()
    last = len(values) - 1
    return {"low": values[math.floor(LOW * last)], "high": values[math.ceil(HIGH * last)]}


def _exhaust_times(
    runs: SafetyRuns, results: Results, worst: Mapping[tuple[int, str], AuditCase]
) -> Iterator[ExhaustTime]:
    kept: dict[AuditCase, list[str]] = defaultdict(list)
    for (_, name), case in worst.items():
        if name in runs.volumes and math.isinf(results[case].times[name]):
            kept[case].append(name)
    holds: dict[tuple[AuditCase, str], Hold] = {}
    for case, volumes in kept.items():
        final = runs.final_state(case)
        for volume in volumes if final.is_valid else ():
            # All cells of a tube have the same pressure at the end.
            holds[case, volume] = final.hold(runs.volumes[volume][0].rpartition(".")[0])
    for (fault, name), case in worst.items():
        if name in runs.volumes:
            result, hold = results[case], holds.get((case, name), Hold("", ()))
            yield ExhaustTime(
                name, runs.fault_name(fault), result.times[name], runs.moments[case.moment], *result.pressures[name],
                hold.reason, hold.by, **_interval(runs, results, worst, fault, name),
            )  # fmt: skip


def _travels(runs: SafetyRuns, results: Results, worst: Mapping[tuple[int, str], AuditCase]) -> Iterator[Travel]:
    for (fault, name), case in worst.items():
        if name in runs.bodies:
            result, unit = results[case], runs.bodies[name]
            motion, moment = result.motions[name], runs.moments[case.moment]
            yield Travel(
                name, runs.fault_name(fault), unit, _distance(result, name), moment, motion.path, motion.net,
                motion.farthest, motion.stop_time, **_interval(runs, results, worst, fault, name),
            )  # fmt: skip


def _curves(runs: SafetyRuns, results: Results, worst: Mapping[tuple[int, str], AuditCase]) -> Iterator[Any]:
    """Yield the curves of each fault at the moment with the longest exhaust time."""
    for fault in range(-1, len(runs.faults)):
        cases = [case for (other, name), case in worst.items() if other == fault]
        if cases:
            longest = max(cases, key=lambda case: max(results[case].times.values(), default=0.0))
            if (curves := results[longest].curves) is not None:
                yield curves


def _has_assumed_exhaust(part: Part) -> bool:
    """Return True if the flow path to the exhaust has the flow capacity of the supply, because none is specified.

    The relief of a pressure regulator is excluded: it has a note of its own.
    """
    fields = ("exhaust_conductance", "exhaust_a_conductance")
    is_missing = any(getattr(part, field, 0.0) is None for field in fields)
    has_exhaust = getattr(part, "exhaust", "") is not None
    has_own = getattr(part, "exhaust_a_characteristic", None) is not None or isinstance(part, PressureRegulator)
    return is_missing and has_exhaust and not has_own


def _notes(runs: SafetyRuns, results: Results, *, is_selected: bool, is_whole: bool) -> Iterator[Note]:
    for event in runs.events:
        if event.replaced:
            yield Note("safety.replaced", event.address, source=event.replaced)
        ambient, part = runs.circuit.surroundings.pressure, event.address.removesuffix(".pressure")
        is_supply = isinstance(runs.circuit.parts.get(part), Reservoir)
        if is_supply and event.value < ambient <= default_value(runs.circuit, event.address):
            yield Note("safety.vacuum", event.address, value=event.value)
    if valves := [name for name, part in runs.circuit.parts.items() if _has_assumed_exhaust(part)]:
        yield Note("safety.assumed_exhaust", valves=valves)
    if len(runs.moments) > 1:
        yield Note("safety.sampled_moments", count=len(runs.moments))
    if not runs.faults:
        yield Note("safety.no_fault" if is_selected else "safety.no_selection")
    for case, result in results.items():
        if case.sample < 0 and result.failure is not None:
            fault, time = runs.fault_name(case.fault), runs.moments[case.moment].time
            yield Note("safety.failed", fault, time=time, reason=result.failure)
    failed = {case.sample for case, result in results.items() if case.sample >= 0 and result.failure is not None}
    if runs.samples:
        yield Note("safety.intervals", samples=len(runs.samples), failed=len(failed) or None)
    if not is_whole:
        yield Note("safety.interrupted")
