"""Virtual bench around a valve of a circuit: supply, closed outlet volume, and valves for flow.

The bleed takes air out of the outlet volume, and the feed adds air to it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from poppet.bench.iso10094.evaluation import Trial, constant_setpoint
from poppet.bench.iso10094.scale import ELECTRIC, Record, Scale, setpoint_scale
from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.notes import make_recording
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, SimulationError
from poppet.engine.problem import Outcome, is_failure
from poppet.engine.solve import solve
from poppet.parts import Chamber, FlowSource, Orifice, Part, Reservoir
from poppet.timeseries.recording import Recording
from poppet.timeseries.segments import Signal
from poppet.timeseries.signals import Constant, Points

SUPPLY, OUTLET, BLEED, FEED = "bench_supply", "bench_outlet", "bench_bleed", "bench_feed"
SETPOINTS = ("setpoint", "pilot_pressure")  # inputs that can be the setpoint; the first existing one is used
NEEDED = ("supply", "outlet", "exhaust")
SCALING = "electronics.scaling"  # address of the pressures at both ends of the setpoint range
MOST_SAMPLES = 400_000  # maximum number of samples of a record with one row per controller sample
WALL = 120.0  # wall conductance per V^(2/3) [W/(K m^2)], for a cylinder of height = diameter with 22 W/(m^2 K)
PROBED = 30.0  # change of the outlet pressure at the largest flow of the bench [% FS]
PROBE_SETPOINT = 50.0
SMALLEST, DECADES = 1e-4, 5
# Units of the probed loads: 1 dm^3/(s bar) in m^3/(s Pa), and 1 g/s in kg/s. The probe starts at `SMALLEST` times the
# unit and increases by `DECADES` decades.
BLEED_UNIT, FEED_UNIT = 1e-8, 1e-3
# A conductance of zero is invalid, so the unused bleed has the smallest conductance and stays closed.
NOT_DRAWN: tuple[float, Signal] = (SMALLEST * BLEED_UNIT, Constant(0.0))
NOT_FED: Signal = Constant(0.0)
BELOW_SUPPLY = 1e5  # difference between supply pressure and default full scale [Pa]


@dataclass
class Rig:
    """Virtual bench that tests one valve of a circuit by simulation."""

    circuit: BaseCircuit  # valve with supply, outlet volume, bleed and feed
    valve: str
    setpoint: str  # address of the setpoint
    scale: Scale
    supply: float  # absolute supply pressure [Pa]
    title: str
    notes: list[Note] = field(default_factory=list)
    _load_sizes: dict[float, float] = field(default_factory=dict)  # bleed conductance (+1), feed flow (-1)

    def respond(self, trial: Trial) -> Record:
        """Simulate a trial, and return the recorded channels."""
        numbers, prefix = self.circuit.parameters, f"{self.valve}."
        clocks = [name for name in numbers if name.startswith(prefix) and name.endswith(".sample_time")]
        fastest = min((numbers[name] for name in clocks), default=math.inf)
        if trial.kind == "leakage" and fastest < trial.step:
            # Rows at the sample time: solenoids can open for single samples, which affects the mean flow.
            if trial.duration <= MOST_SAMPLES * fastest:
                trial = replace(trial, step=fastest)
            else:
                note = Note("rig.pulses", step=trial.step, sample=fastest)
                self.notes += [] if note in self.notes else [note]
        bleed, feed = NOT_DRAWN, NOT_FED
        if trial.load is not None:
            assert isinstance(trial.load, Points)
            times, load = np.asarray(trial.load.times), np.asarray(trial.load.values)
            outflow, inflow = np.maximum(load, 0.0), np.maximum(-load, 0.0)
            bleed = self._load_size(1.0, trial.volume) if outflow.any() else NOT_DRAWN[0], Points(times, outflow)
            feed = Points(times, (self._load_size(-1.0, trial.volume) if inflow.any() else 0.0) * inflow)
        part = self._run(trial, bleed, feed).between(trial.lead - 0.5 * trial.step, trial.duration + trial.step)
        total = np.zeros(part.time.size)  # flow out of the supply
        for flow in self.circuit.model.flows:
            if SUPPLY in (flow.source, flow.target) and flow.name in part:
                total += part[flow.name] * (1.0 if flow.source == SUPPLY else -1.0)
        return Record(
            trial.name, trial.kind, part.time - part.time[0], trial.setpoint.evaluate(part.time, trial.duration),
            part[f"{OUTLET}.pressure"], part[f"{SUPPLY}.pressure"],
            part[f"{BLEED}.mass_flow_rate"] - part[f"{FEED}.mass_flow_rate"], total, trial.volume, is_exact=True,
        )  # fmt: skip

    def _run(self, trial: Trial, bleed: tuple[float, Signal], feed: Signal, stops: Sequence[str] = ()) -> Recording:
        """Simulate a trial with flow out of the outlet volume (bleed) or into it (feed).

        `bleed` contains the sonic conductance [m^3/(s Pa)] of the bleed and the signal of its opening. `feed` is the
        signal of the mass flow rate [kg/s]. `stops` are conditions that end the run.
        """
        scale, circuit = self.scale, self.circuit
        # The outlet starts at the pressure that an ideal valve would hold.
        setpoint = scale.setpoint_percent(trial.setpoint.evaluate(0.0, trial.duration))
        values = {
            f"{OUTLET}.volume": trial.volume,
            f"{OUTLET}.wall_conductance": WALL * trial.volume ** (2.0 / 3.0),
            f"{OUTLET}.initial_pressure": float(scale.pressure(np.clip(setpoint, 0.0, 100.0))),
            f"{BLEED}.sonic_conductance": bleed[0],
        }
        signals = {
            self.setpoint: trial.setpoint,
            f"{SUPPLY}.pressure": trial.supply or Constant(self.supply),
            f"{BLEED}.opening": bleed[1],
            f"{FEED}.mass_flow_rate": feed,
        }
        circuit = replace(circuit.with_values(values), signals={**circuit.signals, **signals})
        run = circuit.run.changed(duration=trial.duration, output_step=trial.step, stop_when=list(stops))
        problem = circuit.problem(run)
        raw = solve(problem, progress=lambda _: None)  # only a run with a progress callback ends at Ctrl-C
        if raw.outcome is Outcome.INTERRUPTED:
            raise KeyboardInterrupt
        recording = make_recording(circuit.instance, problem, raw)
        if is_failure(problem, raw):
            raise SimulationError(recording.outcome, recording)
        return recording

    def _load_size(self, sign: float, volume: float) -> float:
        """Return the load that changes the outlet pressure by 30 % FS.

        The load is the conductance [m^3/(s Pa)] of the bleed if `sign` is +1, and the mass flow rate [kg/s] of the feed
        if it is -1. A run with increasing load determines the value. It is the largest load in all trials, so their
        flows are comparable.
        """
        if sign in self._load_sizes:
            return self._load_sizes[sign]
        steps = np.arange(10 * DECADES + 1, dtype=np.float64)  # two seconds for each tenth of a decade
        times, load = 2.0 * (1.0 + steps), SMALLEST * 10.0 ** (steps / 10.0)
        largest, growing = float(load[-1]), load / load[-1]
        level = float(self.scale.pressure(PROBE_SETPOINT - sign * PROBED))
        bleed, feed = NOT_DRAWN, NOT_FED
        if sign > 0.0:
            bleed = BLEED_UNIT * largest, Points(times, growing)
        else:
            feed = Points(times, FEED_UNIT * largest * growing)
        stop = f"{OUTLET}.pressure {'<' if sign > 0.0 else '>'} {level:.6g}"
        end = float(times[-1])
        trial = Trial("flow", "probe", constant_setpoint(self.scale, PROBE_SETPOINT), end, 0.0, 0.05, volume)
        reached = np.interp(self._run(trial, bleed, feed, [stop]).time[-1], times, load, left=SMALLEST)
        self._load_sizes[sign] = (BLEED_UNIT if sign > 0.0 else FEED_UNIT) * float(reached)
        return self._load_sizes[sign]


def build_rig(
    circuit: BaseCircuit, valve: str, *, full_scale: tuple[float, float] | None = None, supply: float | None = None
) -> Rig:
    """Return a virtual bench for one valve of a circuit.

    The keywords `supply` and `full_scale` are absolute pressures [Pa]. By default, they come from the circuit: the
    supply pressure, and the pressure range of the valve electronics. Without electronics, the full scale ends at least
    1 bar below the supply pressure.
    """
    part = circuit.parts[find_valve(circuit, valve)]
    item = next(item for name in SETPOINTS for item in part.inputs() if item.name == name)
    notes: list[Note] = []
    pressure = supply
    if pressure is None:
        store = part.ports()["supply"]
        if store == "ambient":
            raise InputError("rig.open_supply")
        if f"{store}.pressure" in circuit.signals:
            pressure = _at_start(circuit.signals[f"{store}.pressure"])
            notes.append(Note("rig.supply_at_start", supply=pressure))
        else:
            candidates = (f"{store}.pressure", f"{store}.initial_pressure")
            pressure = float(next(circuit.parameters[key] for key in candidates if key in circuit.parameters))
    ambient = circuit.surroundings.pressure
    smallest, largest = (circuit.parameters.get(f"{valve}.{SCALING}.{end}") for end in ("low", "high"))
    scaling = None if smallest is None or largest is None else (float(smallest), float(largest))
    ends = full_scale or scaling
    if ends is None:  # 1 bar below the supply, in whole bars above ambient
        bars = math.floor((pressure - ambient - BELOW_SUPPLY) / 1e5 + 1e-9)
        if bars < 1:
            raise InputError("rig.low_supply", supply=pressure)
        notes.append(Note("rig.full_scale", bars=bars))
        ends = ambient, ambient + 1e5 * bars
    if scaling is not None:
        slack = 1e-9 * ends[1]
        # Pressures outside the scaling of the valve have no setpoint.
        if not scaling[0] - slack <= ends[0] < ends[1] <= scaling[1] + slack:
            (low, high), (own_low, own_high) = ends, scaling
            address = f"{valve}.{SCALING}"
            raise InputError("rig.beyond_scaling", address, low=low, high=high, own_low=own_low, own_high=own_high)
    if ends[1] > pressure:
        notes.append(Note("rig.above_supply", high=ends[1], supply=pressure))
    if item.unit not in ("Pa", *ELECTRIC):
        raise InputError("rig.setpoint_unit", f"{valve}.{item.name}", unit=item.unit)
    ports = dict.fromkeys(part.ports(), "ambient") | {"supply": SUPPLY, "outlet": OUTLET}
    parts: dict[str, Part] = {
        SUPPLY: Reservoir(pressure=pressure),
        valve: replace(part, **ports),  # type: ignore[type-var]
        OUTLET: Chamber(volume=1e-3, wall_conductance=WALL * 1e-2),
        BLEED: Orifice(from_=OUTLET, to="ambient", sonic_conductance=NOT_DRAWN[0], critical_ratio=0.3, opening=0.0),
        FEED: FlowSource(to=OUTLET),
    }
    other_inputs = {f"{valve}.{input_.name}" for input_ in part.inputs()} - {f"{valve}.{item.name}"}
    signals = {name: Constant(_at_start(signal)) for name, signal in circuit.signals.items() if name in other_inputs}
    rig = replace(circuit, parts=parts, signals=signals, connections={})
    scale = setpoint_scale(None, ends, ambient, item.unit)
    if item.unit != "Pa" and scaling:  # range of the setpoint for the requested full scale
        full = setpoint_scale(None, scaling, ambient, item.unit)
        low, high = (float(full.setpoint(full.percent(end))) for end in ends)
        scale = Scale(low, high, item.unit, *ends)
    return Rig(rig, valve, f"{valve}.{item.name}", scale, pressure, circuit.title or valve, notes)


def find_valve(circuit: BaseCircuit, name: str | None = None, kind: type[Part] = Part) -> str:
    """Return the name of the valve in a circuit that the bench can test.

    A suitable valve is a part of the class `kind` with a setpoint and with supply, outlet and exhaust ports. `name`
    must be such a part. Without `name`, the circuit must contain exactly one.
    """
    valves = [
        name
        for name, part in circuit.parts.items()
        if isinstance(part, kind)
        and {*NEEDED} <= {*part.ports()}
        and any(item.name in SETPOINTS for item in part.inputs())
    ]
    if not valves:
        raise InputError("rig.no_valve")
    if name is None and len(valves) > 1:
        raise InputError("rig.several_valves", count=len(valves), valves=tuple(valves))
    name = name or valves[0]
    if name not in valves:
        suggestion = NameSuggestion(name, valves)
        raise InputError("names.unknown", name, meaning="a pressure valve of this circuit", suggestion=suggestion)
    return name


def _at_start(signal: Signal) -> float:
    return float(signal.evaluate(0.0, 1.0))
