"""What the picture of a circuit writes into the box of a part."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from poppet.core.number_format import USUAL, readable_unit, with_unit
from poppet.core.provenance import Number
from poppet.core.units import convert
from poppet.parts.flow_path import FlowPath

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

ASSUMED = "*"
"""Stands behind a number that was assumed."""
_MOST_NUMBERS = 3  # in the box of a kind of part that has no caption of its own


def shown(number: Number, *, ambient_pressure: float = 1e5) -> str:
    """A number as an engineer writes it, assumed ones marked.

    Examples
    --------
    >>> from poppet.core.provenance import assumed
    >>> shown(assumed(2e-4, "m^3", "a guess"))
    '200 cm³*'
    """
    mark = ASSUMED if number.source.kind == "assumed" else ""
    if number.reference == "gauge":
        return number.display() + mark
    return shown_value(number.absolute(ambient_pressure), number.unit) + mark


def shown_value(value: float, unit: str) -> str:
    """A value in the unit an engineer reads.

    Examples
    --------
    >>> shown_value(7e5, "Pa"), shown_value(0.2, "m^3"), shown_value(0.3, "1")
    ('7 bar', '0.2 m³', '0.3')
    """
    # Volumes and masses of one circuit differ by decades; everything else has its one usual unit.
    target = readable_unit(unit, value) if unit in ("m^3", "kg") else USUAL.get(unit, unit)
    return with_unit(f"{convert(value, unit, target):z.4g}", target)


def signal_caption(circuit: Circuit, address: str) -> str:
    """What drives an input: the kind of signal and its range.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice
    >>> from poppet.timeseries.signals import Steps
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> tank = Chamber(volume="10 l")
    >>> steps = Steps([0.0, 1.0], [0.0, 0.5])
    >>> signal_caption(Circuit({"tank": tank, "vent": vent}, {"vent.opening": steps}), "vent.opening")
    'opening: steps, 0 ... 0.5'
    """
    signal = circuit.signals[address]
    part, _, local = address.partition(".")
    unit = next(item.unit for item in circuit.parts[part].inputs() if item.name == local)
    low, high = (shown_value(bound, unit) for bound in signal.bounds())
    reach = high if low == high else f"{low.partition(' ')[0]} ... {high}"  # the unit stands once, behind both
    return f"{local.replace('_', ' ')}: {type(signal).__name__.lower()}, {reach}"


def connection_caption(circuit: Circuit, address: str) -> str:
    """What an input takes from another part."""
    return f"{address.partition('.')[2].replace('_', ' ')} = {circuit.connections[address]}"


def caption(circuit: Circuit, name: str) -> list[str]:
    """Lines that say what a part is: its size, its law."""
    part: Any = circuit.parts[name]
    of = partial(shown, ambient_pressure=circuit.surroundings.pressure)
    size = _size(circuit, name, part, of) if isinstance(part, FlowPath) else []
    match part.kind:
        case "reservoir":
            return [of(part.pressure), of(part.temperature)]
        case "chamber":
            start = f"starts at {of(part.initial_pressure)}, {of(part.initial_temperature)}"
            return [of(part.volume), _thermal(part, of), start]
        case "main_stage":
            seat = part.exhaust_seat
            exhaust = f"exhaust C = {of(seat.sonic_conductance)}, b = {of(seat.critical_ratio)}"
            return [f"main stage, {part.mode} mode", f"C(x), b(x): {part.characteristic.name}", exhaust]
        case "pilot_stage":
            return [f"pilot stage, {part.drive}", of(part.volume), f"solenoids C = {of(part.fill.sonic_conductance)}"]
        case "electronics":
            times = sorted({of(loop.sample_time) for loop in (part.outer, part.inner)})
            setpoint = f"setpoint: {part.setpoint_type}"
            return [f"electronics, {part.preset}", setpoint, f"samples every {', '.join(times)}"]
        case "proportional_valve":
            assumed = sum(number.source.kind == "assumed" for number in part.numbers().values())
            numbers = f"{part.data}: {assumed} assumed numbers" if part.data else f"{assumed} assumed numbers"
            return [f"pressure regulator, {part.preset}", f"C(x), b(x): {part.main_stage.characteristic.name}", numbers]
        case "mass":
            load = [f"rises at {of(part.inclination)}"] if float(part.inclination) else []
            return [of(part.mass), *load, _friction(part, "force", of)]
        case "joint":
            return [of(part.inertia), f"pulley {of(part.pulley_radius)}", _friction(part, "torque", of)]
        case "guide":
            return ["moved by its signal"]
        case "cylinder":
            rod = f", rod {of(part.rod_diameter)}" if float(part.rod_diameter) else ""
            turned = [] if float(part.direction) > 0.0 else ["turned round"]
            return [
                f"cylinder, {part.acting} acting",
                f"{of(part.bore)}{rod}, stroke {of(part.stroke_length)}",
                *turned,
            ]
        case "muscle":
            towards = "larger" if float(part.direction) > 0.0 else "smaller"
            size = [f"{of(part.nominal_diameter)}, length {of(part.nominal_length)}"]
            return [f"muscle, {part.data or part.law}", *size, f"pulls towards {towards} positions"]
        case "inverse_muscle":
            return [f"force to pressure, {part.data or part.law}"]
        case "antagonist":
            return [f"torque to two pressures, {part.data or part.law}", f"pulley {of(part.pulley_radius)}"]
        case "tube":
            waves = "with waves" if part.inertia == "true" else "no waves"
            return [f"{part.length.display()}, bore {of(part.bore)}", f"{part.options()['cells']} cells, {waves}"]
        case "flow_source":
            return ["flow source"] if f"{name}.mass_flow_rate" in circuit.signals else [of(part.mass_flow_rate)]
        case "check_valve":
            return [*size, f"opens at {of(part.cracking_pressure)}"]
        case "relief_valve":
            return [*size, f"opens at {of(part.set_pressure)}"]
        case "directional_valve":
            return [f"{'3/2' if part.exhaust is not None else '2/2'}, normally {part.normally}", *size]
        case "spool_valve":
            overlaps = {"supply": part.overlap, "exhausts": part.exhaust_overlap or part.overlap}
            is_open = " and ".join(side for side, overlap in overlaps.items() if float(overlap) < 0.0)
            follows = part.lag if part.dynamics == "first_order" else part.natural_frequency
            return [f"5/3, {is_open or 'nothing'} open at the centre", *size, f"spool {of(follows)}"]
        case "pid" if part.schedule is not None:
            points = len(part.schedule.columns["gain"])
            return [f"PID, sampled every {of(part.sample_time)}", f"gains at {points} operating points"]
        case "pid":
            parts = {"Ti": part.integral_time, "Td": part.derivative_time}
            gains = [f"{symbol} = {of(n)}" for symbol, n in parts.items() if n is not None and float(n) > 0.0]
            return [f"PID, sampled every {of(part.sample_time)}", f"K = {of(part.gain)}", *gains]
        case "pressure_controller":
            sampled = f"linearising, sampled every {of(part.sample_time)}"
            reckons = f"reckons with {of(part.volume)}, n = {of(part.polytropic_exponent)}"
            return [sampled, f"time constant {of(part.time_constant)}", reckons]
    first = list(part.numbers().items())[:_MOST_NUMBERS]
    return size or [part.kind.replace("_", " "), *(f"{key.replace('_', ' ')} {of(number)}" for key, number in first)]


def _thermal(part: Any, of: Callable[[Number], str]) -> str:
    match part.thermal:
        case "polytropic":
            return f"polytropic, n = {of(part.polytropic_exponent)}"
        case "isentrope":
            return "isentrope (closed gas)"
        case "energy" if part.heat_transfer != "constant":
            return f"energy, {part.heat_transfer} convection"
        case "energy":
            is_adiabatic = float(part.wall_conductance) == 0.0
            return "energy, adiabatic" if is_adiabatic else f"energy, h A = {of(part.wall_conductance)}"
    return str(part.thermal)


def _friction(part: Any, effort: str, of: Callable[..., str]) -> str:
    """Which friction a body has, and how much."""
    law = "none" if part.friction is None else part.friction.kind
    if law == "none":
        return "no friction"
    if law == "viscous":
        return f"friction {of(part.friction.viscous_coefficient)}"
    return f"{law} friction {of(getattr(part.friction, f'coulomb_{effort}'))}"


def _size(circuit: Circuit, name: str, part: Any, of: Callable[[Number], str]) -> list[str]:
    """Size of any ISO 6358 passage, however it was given."""
    if part.characteristic is not None:
        stroke = getattr(part, "stroke", None)
        law = f"C(x), b(x): {part.characteristic.name}"
        return [law] if stroke is None or f"{name}.stroke" in circuit.signals else [law, f"x = {of(stroke)}"]
    conductance = shown_value(circuit.parameters[f"{name}.sonic_conductance"], "m^3/(s Pa)")
    mark = ASSUMED if part.sonic_conductance is not None and part.sonic_conductance.source.kind == "assumed" else ""
    return [f"C = {conductance}{mark}", f"b = {of(part.critical_ratio)}"]
