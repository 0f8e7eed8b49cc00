"""What the picture of a circuit writes into the box of a part."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from poppet.ground.provenance import Number
from poppet.ground.units import convert
from poppet.parts import Part
from poppet.parts.flow_path import FlowPath
from poppet.series.drawing.figures import pretty
from poppet.series.signals import Signal

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

    _Caption = Callable[[Circuit, str, Any], list[str]]

ASSUMED = "*"
"""Stands behind a number that was assumed."""

_SHOWN = {
    "Pa": "bar",
    "K": "degC",
    "m": "mm",
    "m^2": "mm^2",
    "kg/s": "g/s",
    "m^3/(s Pa)": "dm^3/(s bar)",
    "m^3/s ANR": "l/min ANR",
    "1/Pa": "1/bar",
}
_LITRES_BELOW, _CUBIC_CENTIMETRES_BELOW = 0.1, 1e-3  # [m^3]
_MOST_NUMBERS = 3  # in the box of a kind of part that has no caption of its own


def shown(number: Number, *, ambient_pressure: float = 1e5) -> str:
    """A number as an engineer writes it, assumed ones marked.

    Examples
    --------
    >>> from poppet.ground.provenance import assumed
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
    target = _SHOWN.get(unit, unit)
    if unit == "m^3" and value < _LITRES_BELOW:
        target = "cm^3" if value < _CUBIC_CENTIMETRES_BELOW else "l"
    text = f"{convert(value, unit, target):.4g}"
    return text if target in ("1", "") else f"{text} {pretty(target)}"


def caption(circuit: Circuit, name: str) -> list[str]:
    """Lines that say what a part is: its size, its law."""
    part = circuit.parts[name]
    usual: _Caption = _passage if isinstance(part, FlowPath) else _anything
    return _CAPTIONS.get(part.kind, usual)(circuit, name, part)


def signal_caption(circuit: Circuit, address: str) -> str:
    """What drives an input: the kind of signal and its range.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice
    >>> from poppet.series.signals import Steps
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> tank = Chamber(volume="10 l")
    >>> steps = Steps([0.0, 1.0], [0.0, 0.5])
    >>> signal_caption(Circuit({"tank": tank, "vent": vent}, {"vent.opening": steps}), "vent.opening")
    'opening: steps, 0 ... 0.5'
    """
    signal: Signal = circuit.signals[address]
    part, _, local = address.partition(".")
    unit = next(item.unit for item in circuit.parts[part].inputs() if item.name == local)
    low, high = (shown_value(bound, unit) for bound in signal.bounds())
    number = low.partition(" ")[0]
    reach = high if low == high else f"{number} ... {high}"
    return f"{local.replace('_', ' ')}: {type(signal).__name__.lower()}, {reach}"


def connection_caption(circuit: Circuit, address: str) -> str:
    """What an input takes from another part."""
    return f"{address.partition('.')[2].replace('_', ' ')} = {circuit.connections[address]}"


def _reservoir(circuit: Circuit, name: str, part: Any) -> list[str]:
    return [_of(circuit, part.pressure), _of(circuit, part.temperature)]


def _chamber(circuit: Circuit, name: str, part: Any) -> list[str]:
    laws = {
        "energy": _heat(part),
        "isothermal": "isothermal",
        "polytropic": f"polytropic, n = {_of(circuit, part.polytropic_exponent)}" if part.polytropic_exponent else "",
        "isentrope": "isentrope (closed gas)",
    }
    start = f"starts at {_of(circuit, part.initial_pressure)}, {_of(circuit, part.initial_temperature)}"
    return [_of(circuit, part.volume), laws[part.thermal], start]


def _heat(part: Any) -> str:
    if part.heat_transfer != "constant":
        return f"energy, {part.heat_transfer} convection"
    if float(part.wall_conductance) == 0.0:
        return "energy, adiabatic"
    return f"energy, h A = {shown(part.wall_conductance)}"


def _passage(circuit: Circuit, name: str, part: Any) -> list[str]:
    """Size of any ISO 6358 passage, however it was given."""
    if part.characteristic is not None:
        stroke = getattr(part, "stroke", None)
        fixed = (
            [f"x = {_of(circuit, stroke)}"] if stroke is not None and f"{name}.stroke" not in circuit.signals else []
        )
        return [f"C(x), b(x): {part.characteristic.name}", *fixed]
    conductance = shown_value(circuit.parameters[f"{name}.sonic_conductance"], "m^3/(s Pa)")
    mark = ASSUMED if part.sonic_conductance is not None and part.sonic_conductance.source.kind == "assumed" else ""
    return [f"C = {conductance}{mark}", f"b = {_of(circuit, part.critical_ratio)}"]


def _main_stage(circuit: Circuit, name: str, part: Any) -> list[str]:
    seat = part.exhaust_seat
    exhaust = f"exhaust C = {_of(circuit, seat.sonic_conductance)}, b = {_of(circuit, seat.critical_ratio)}"
    return [f"main stage, {part.mode} mode", f"C(x), b(x): {part.characteristic.name}", exhaust]


def _pilot_stage(circuit: Circuit, name: str, part: Any) -> list[str]:
    solenoid = f"solenoids C = {_of(circuit, part.fill.sonic_conductance)}"
    return [f"pilot stage, {part.drive}", _of(circuit, part.volume), solenoid]


def _electronics(circuit: Circuit, name: str, part: Any) -> list[str]:
    times = {shown(loop.sample_time) for loop in (part.outer, part.inner)}
    return [
        f"electronics, {part.preset}",
        f"setpoint: {part.setpoint_type}",
        f"samples every {', '.join(sorted(times))}",
    ]


def _proportional_valve(circuit: Circuit, name: str, part: Any) -> list[str]:
    assumed = sum(number.source.kind == "assumed" for number in part.numbers().values())
    numbers = f"{part.data}: {assumed} assumed numbers" if part.data else f"{assumed} assumed numbers"
    return [f"pressure regulator, {part.preset}", f"C(x), b(x): {part.main_stage.characteristic.name}", numbers]


def _flow_source(circuit: Circuit, name: str, part: Any) -> list[str]:
    driven = f"{name}.mass_flow_rate" in circuit.signals
    return ["flow source"] if driven else [_of(circuit, part.mass_flow_rate)]


def _check_valve(circuit: Circuit, name: str, part: Any) -> list[str]:
    return [*_passage(circuit, name, part), f"opens at {_of(circuit, part.cracking_pressure)}"]


def _relief_valve(circuit: Circuit, name: str, part: Any) -> list[str]:
    return [*_passage(circuit, name, part), f"opens at {_of(circuit, part.set_pressure)}"]


def _directional_valve(circuit: Circuit, name: str, part: Any) -> list[str]:
    ways = "3/2" if part.exhaust is not None else "2/2"
    return [f"{ways}, normally {part.normally}", *_passage(circuit, name, part)]


def _pid(circuit: Circuit, name: str, part: Any) -> list[str]:
    if part.schedule is not None:
        gains = [f"gains at {len(part.schedule.columns['pressure'])} operating points"]
    else:
        gains = [f"K = {_of(circuit, part.gain)}"]
        gains += [f"{symbol} = {_of(circuit, n)}" for symbol, n in _times(part)]
    return [f"PID, sampled every {_of(circuit, part.sample_time)}", *gains]


def _times(part: Any) -> list[tuple[str, Number]]:
    times = {"Ti": part.integral_time, "Td": part.derivative_time}
    return [(symbol, n) for symbol, n in times.items() if n is not None and float(n) > 0.0]


def _pressure_controller(circuit: Circuit, name: str, part: Any) -> list[str]:
    reckons = f"reckons with {_of(circuit, part.volume)}, n = {_of(circuit, part.polytropic_exponent)}"
    sampled = f"linearising, sampled every {_of(circuit, part.sample_time)}"
    return [sampled, f"time constant {_of(circuit, part.time_constant)}", reckons]


def _anything(circuit: Circuit, name: str, part: Part) -> list[str]:
    """Kind and first numbers of a part that has no caption of its own."""
    numbers = list(part.numbers().items())[:_MOST_NUMBERS]
    return [
        part.kind.replace("_", " "),
        *(f"{key.replace('_', ' ')} {_of(circuit, n)}" for key, n in numbers),
    ]


def _of(circuit: Circuit, number: Number) -> str:
    return shown(number, ambient_pressure=circuit.surroundings.pressure)


_CAPTIONS: dict[str, _Caption] = {
    "reservoir": _reservoir,
    "chamber": _chamber,
    "main_stage": _main_stage,
    "pilot_stage": _pilot_stage,
    "electronics": _electronics,
    "proportional_valve": _proportional_valve,
    "flow_source": _flow_source,
    "check_valve": _check_valve,
    "relief_valve": _relief_valve,
    "directional_valve": _directional_valve,
    "pid": _pid,
    "pressure_controller": _pressure_controller,
}
