"""The electronics of a pressure valve: a sampled outer loop on the outlet and an inner one on the pilot pressure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import OutOfRangeError
from poppet.core.symbolic import clip, floor, maximum, where
from poppet.parts.fields import NumberLike, group, number, option, reference
from poppet.parts.part import (
    NEVER,
    Controller,
    ControlOutputs,
    DiscreteState,
    Input,
    Scope,
    State,
    Surroundings,
    Timer,
    advance_clock,
)
from poppet.parts.quantities import as_difference

SHORTEST_LAG = 1e-6
"""A sensor's lag below it counts as this [s]: far below any sample time, and no division by zero."""
SHORTEST_SAMPLE = 1e-6
SMALLEST_BAND = 1e-3
"""A dead band below it counts as this [Pa]: no division by zero."""
SENSOR_TOLERANCE = 10.0
"""Factor on the tolerance of the sensors: by default an error of less than a hundredth of a step of the converter."""


@dataclass(frozen=True)
class Scaling:
    """What the ends of the setpoint mean."""

    low: NumberLike = number("Pa", "0 bar g", doc="pressure at 0 % of the setpoint", kind="pressure")
    high: NumberLike = number("Pa", doc="pressure at 100 % of the setpoint", kind="pressure")


@dataclass(frozen=True)
class FirstOrderSensor:
    """A sensor of first order."""

    lag: NumberLike = number("s", 0.0, doc="time constant", low=0.0, note="none")
    offset: NumberLike = number("Pa", 0.0, doc="offset", note="none", varies=as_difference)


@dataclass(frozen=True)
class Converter:
    """The analogue-to-digital converter of both sensors."""

    bits: NumberLike = number("1", 0.0, doc="bits of the converter", low=0.0, high=32.0, note="no quantisation")
    span: NumberLike = number("Pa", "10 bar", doc="pressure difference at full scale", above=0.0)


@dataclass(frozen=True)
class OuterLoop:
    """PI(D) on the outlet pressure with feed-forward; its output is the pilot pressure that is wanted.

    The parallel form K (1 + 1/(T_i s) + T_d s); the feed-forward is the part of the wanted gauge pressure that goes
    straight to the pilot. `dead_zone` is added with the sign of the error, so that the seats open without waiting for
    the integral; `correction_limit` keeps the pilot near the pressure at which the main stage closes by itself.
    """

    gain: NumberLike = number("1", doc="gain", low=0.0)
    integral_time: NumberLike = number("s", 0.0, doc="integral time", low=0.0, note="no integral")
    derivative_time: NumberLike = number("s", 0.0, doc="derivative time", low=0.0, note="no derivative")
    derivative_filter: NumberLike = number("s", "5 ms", doc="time constant of the derivative's filter", low=0.0)
    feed_forward: NumberLike = number("1", 1.0, doc="feed-forward of the setpoint", low=0.0)
    bias: NumberLike = number("Pa", 0.0, doc="added pilot pressure", note="none")
    dead_band: NumberLike = number("Pa", 0.0, doc="dead band of the error", low=0.0, note="none")
    integral_band: NumberLike = number("Pa", 0.0, doc="error beyond which the integral rests", low=0.0, note="no limit")
    integral_limit: NumberLike = number("Pa", 0.0, doc="greatest size of the integral", low=0.0, note="no limit")
    dead_zone: NumberLike = number("Pa", 0.0, doc="half the dead zone of the seats", low=0.0, note="none")
    correction_limit: NumberLike = number("Pa", 0.0, doc="greatest size of the correction", low=0.0, note="no limit")
    pilot_limit: NumberLike = number("Pa", doc="highest pilot pressure", kind="pressure", above=0.0)
    sample_time: NumberLike = number("s", "1 ms", doc="sample time of the outer loop", low=SHORTEST_SAMPLE)


@dataclass(frozen=True)
class InnerLoop:
    """Proportional control of the pilot pressure with a hold band: it decides to fill, to hold or to vent."""

    gain: NumberLike = number("1/Pa", doc="duty per error of the pilot pressure", low=0.0)
    hold_band: NumberLike = number("Pa", 0.0, doc="hold band", low=0.0, note="none")
    minimum_duty: NumberLike = number("1", 0.0, doc="least duty", low=0.0, below=1.0, note="none")
    vent_delay: NumberLike = number("s", 0.0, doc="time that venting must be wanted", low=0.0, note="at once")
    sample_time: NumberLike = number("s", "1 ms", doc="sample time of the inner loop", low=SHORTEST_SAMPLE)


SCALES = {"pressure": ("Pa", 0.0, 0.0), "0-10 V": ("V", 0.0, 10.0), "4-20 mA": ("A", 4e-3, 20e-3)}
"""Unit of the setpoint by its type, and its value at 0 % and 100 %; a pressure stands for itself."""
PRESETS = ("universal", "fast", "precise")
_UNLIMITED = 1e12
_SENSORS = ("outlet", "pilot")


@dataclass(frozen=True)
class Electronics(Controller):
    r"""Sampled control of a piloted pressure valve.

    .. math:: p_{p,set} = p_a + f (w - p_a) + p_0
              + \operatorname{clip}\left(K e + z \operatorname{clip}(e / e_0, -1, 1) + I, -c, c\right)
              - K T_d\, \dot p_2, \qquad I = \frac{K}{T_i} \sum e\, T

    .. math:: d = \operatorname{clip}(K_i e_p + d_{min} \operatorname{sign} e_p, -1, 1) \quad (|e_p| > \text{band}),
              \qquad e_p = p_{p,set} - p_p

    A positive d is the duty of the filling solenoid, a negative one that of the venting solenoid.

    Parameters
    ----------
    data : str
        A library set; fields given here override it.
    preset : str
        `universal` (default), `fast` or `precise`: which loop numbers of the set.
    setpoint_type : str
        `pressure` (default), `0-10 V` or `4-20 mA`.
    setpoint_delay : number
        Time by which a signal of the setpoint acts later [s]; a connected setpoint is not delayed.
    scaling : group
        low, high: the pressures at 0 % and 100 %.
    zero_suppression : number
        Part of the span below which the setpoint counts as zero and the pilot is vented.
    outlet_sensor, pilot_sensor : group
        lag, offset.
    converter : group
        bits, span.
    outer, inner : group
        The two loops.
    initial_integral : number
        Integral of the outer loop at the start [Pa].

    Notes
    -----
    Inputs are `setpoint`, `outlet_pressure`, `pilot_pressure` [Pa] and `power` (1 on, 0 off: both solenoids stay
    closed, so that the pressure is held). A sample reads the sensors' values at its instant; where both loops sample
    together, the inner one already has the outer one's new result. e is what the dead band e_0 leaves of the error, z
    half the dead zone between the seats (no effect without e_0), c the limit of the correction. Anti-windup: the
    integral takes back, over `integral_time`, what c and the limits of the pilot pressure cut off, and rests beyond its
    band. A resumed run takes the integral over; its clocks begin anew, and the derivative begins at zero.

    References
    ----------
    Varga & Keski-Honkola 2012, section 2 and fig. 1: electronics named, not modelled there.
    """

    kind: ClassVar[str] = "electronics"
    summary: ClassVar[str] = "sampled pressure control: outer PI(D), inner pilot loop, sensors, converter"
    internal_outputs: ClassVar[tuple[str, ...]] = (
        "actual_value", "pilot_setpoint", "integral", "fill_duty", "vent_duty", "outlet_sensor_pressure",
        "pilot_sensor_pressure",
    )  # fmt: skip

    data: Any = reference(doc="library set")
    preset: str = option(*PRESETS, doc="preset")
    setpoint_type: str = option(*SCALES, doc="type of setpoint")
    setpoint_delay: NumberLike = number("s", 0.0, doc="delay of the setpoint's signal", low=0.0, note="none")
    scaling: Any = group(Scaling, doc="the pressures at 0 % and 100 %")
    zero_suppression: NumberLike = number("1", 0.0, doc="zero-point suppression", low=0.0, below=1.0, note="none")
    outlet_sensor: Any = group(FirstOrderSensor, doc="the sensor of the outlet pressure")
    pilot_sensor: Any = group(FirstOrderSensor, doc="the sensor of the pilot pressure")
    converter: Any = group(Converter, doc="the converter")
    outer: Any = group(OuterLoop, doc="the outer loop")
    inner: Any = group(InnerLoop, doc="the inner loop")
    initial_integral: NumberLike = number("Pa", 0.0, doc="integral at the start", note="none")

    resume: ClassVar[dict[str, str]] = {"integral": "initial_integral"}
    measured: ClassVar[tuple[str, ...]] = ("outlet_pressure", "pilot_pressure")

    def variant(self) -> str:
        # A misspelt preset is reported by its own check, not by every number that it would leave missing.
        return self.preset if self.preset in PRESETS else PRESETS[0]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if values["scaling.low"] >= values["scaling.high"]:
            raise OutOfRangeError("valve.scaling_exchanged", "scaling.high", shown=self.scaling.high.display())
        first = SCALES[self.setpoint_type][1]
        values["setpoint"] = values["scaling.low"] if self.setpoint_type == "pressure" else first
        values["outlet_pressure"] = values["pilot_pressure"] = ambient.pressure
        return values

    def options(self) -> dict[str, str]:
        # A preset is a set of numbers and shapes no model.
        return {name: choice for name, choice in super().options().items() if name != "preset"}

    def states(self) -> tuple[State, ...]:
        return tuple(State(f"{name}_sensor_pressure", "Pa", 1e5, SENSOR_TOLERANCE) for name in _SENSORS)

    def memory(self) -> tuple[DiscreteState, ...]:
        pressures = ("integral", "pilot_setpoint", "last_pressure", "derivative", "actual_pressure")
        others = ("fill_duty", "vent_duty", "vent_wanted", "vent_ready", "outer_count", "inner_count")
        return *(DiscreteState(name, "Pa") for name in pressures), *(DiscreteState(name, "1") for name in others)

    def timers(self) -> tuple[Timer, ...]:
        return Timer("outer", 0), Timer("inner", 1), Timer("vent", 2)

    def inputs(self) -> tuple[Input, ...]:
        unit, first, last = SCALES[self.setpoint_type]
        limits: dict[str, Any] = {"low": first, "high": last}
        if self.setpoint_type == "pressure":
            limits = {"low": "scaling.low", "high": "scaling.high", "kind": "pressure"}
        setpoint = Input("setpoint", unit, "setpoint", delay="setpoint_delay", **limits)
        pressures = [Input(name, "Pa", name, kind="pressure", low=0.0) for name in self.measured]
        return setpoint, Input("power", "1", 1.0, low=0.0, high=1.0), *pressures

    def sensors(self) -> dict[str, tuple[str, str]]:
        return {f"{name}_sensor_pressure": (f"{name}_pressure", f"{name}_sensor") for name in _SENSORS}

    def start(self, scope: Scope) -> dict[str, Any]:
        ambient = scope.surroundings.pressure
        values = {f"{name}_sensor_pressure": scope.inputs[f"{name}_pressure"] for name in _SENSORS}
        values |= {each.name: 0.0 for each in self.memory()}
        values |= {"pilot_setpoint": ambient, "last_pressure": ambient, "integral": scope["initial_integral"]}
        values |= {"outer": 0.0, "inner": 0.0, "vent": NEVER}
        return values | {"actual_pressure": scope.inputs["outlet_pressure"]}

    def list_internal_outputs(self) -> tuple[str, ...]:
        # Of a setpoint in volts or amperes it is the target that can be compared with a pressure.
        return (
            (*self.internal_outputs, "target_pressure") if self.setpoint_type == "pressure" else self.internal_outputs
        )

    def control(self, scope: Scope) -> ControlOutputs:
        rates = {}
        for name in _SENSORS:
            lag = maximum(scope[f"{name}_sensor.lag"], SHORTEST_LAG)
            state = f"{name}_sensor_pressure"
            rates[state] = (scope.inputs[f"{name}_pressure"] - scope.states[state]) / lag
        memory = scope.memory
        outputs = {
            "target_pressure": (self._target(scope), "Pa"),
            "actual_value": (self._shown(scope, memory["actual_pressure"]), SCALES[self.setpoint_type][0]),
            **{name: (memory[name], "Pa") for name in ("pilot_setpoint", "integral")},
            **{name: (memory[name], "1") for name in ("fill_duty", "vent_duty")},
            **{name: (pressure, "Pa") for name, pressure in scope.states.items()},
        }
        return ControlOutputs(outputs, rates)

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        if timer == "vent":
            return {"vent": NEVER, "vent_ready": 1.0, "vent_duty": scope.memory["vent_wanted"]}
        new = self._outer(scope) if timer == "outer" else self._inner(scope)
        return new | advance_clock(scope, timer, scope[f"{timer}.sample_time"])

    # Scaling and sensing -----------------------------------------------------------------------------------------

    def _target(self, scope: Scope) -> Any:
        """The pressure that the setpoint asks for, within the scaling."""
        low, high = scope["scaling.low"], scope["scaling.high"]
        given = scope.inputs["setpoint"]
        if self.setpoint_type != "pressure":
            _, first, last = SCALES[self.setpoint_type]
            given = low + (high - low) * (given - first) / (last - first)
        return clip(given, low, high)

    def _shown(self, scope: Scope, pressure: Any) -> Any:
        """A pressure as the output of the actual value."""
        if self.setpoint_type == "pressure":
            return pressure
        _, first, last = SCALES[self.setpoint_type]
        low, high = scope["scaling.low"], scope["scaling.high"]
        return first + (last - first) * (pressure - low) / (high - low)

    def _read(self, scope: Scope, name: str) -> Any:
        """A sensor's value as the program sees it."""
        gauge = scope.states[f"{name}_sensor_pressure"] + scope[f"{name}_sensor.offset"] - scope.surroundings.pressure
        bits, span = scope["converter.bits"], scope["converter.span"]
        step = span * 2.0 ** (-bits)
        rounded = floor(gauge / step + 0.5) * step
        return where(bits > 0.0, rounded, gauge) + scope.surroundings.pressure

    # The two loops -----------------------------------------------------------------------------------------------

    def _outer(self, scope: Scope) -> dict[str, Any]:
        memory, time = scope.memory, scope["outer.sample_time"]
        ambient, target = scope.surroundings.pressure, self._target(scope)
        pressure = self._read(scope, "outlet")
        band, gain = scope["outer.dead_band"], scope["outer.gain"]
        error = target - pressure
        error = maximum(error - band, 0.0) - maximum(-error - band, 0.0)
        filtered, ahead = scope["outer.derivative_filter"], scope["outer.derivative_time"]
        # At the first sample there is no earlier pressure to differ from.
        before = where(memory["outer_count"] > 0.0, memory["last_pressure"], pressure)
        # Of the pressure, not of the error: a step of the setpoint gives no kick. Backward in time: always stable.
        derivative = (filtered * memory["derivative"] + gain * ahead * (before - pressure)) / (filtered + time)
        forward = ambient + scope["outer.feed_forward"] * (target - ambient) + scope["outer.bias"]
        # Across the dead zone of the seats within a second dead band of error: without one it would be a relay.
        across = where(
            band > 0.0, scope["outer.dead_zone"] * clip(error / maximum(band, SMALLEST_BAND), -1.0, 1.0), 0.0
        )
        correction = gain * error + across + memory["integral"]
        limit = where(scope["outer.correction_limit"] > 0.0, scope["outer.correction_limit"], _UNLIMITED)
        # The derivative stands outside of this limit: it brakes a small volume early and a large one hardly.
        limited = forward + clip(correction, -limit, limit) + derivative
        given = clip(limited, ambient, scope["outer.pilot_limit"])
        cut = given - forward - derivative - correction
        is_idle = self._is_suppressed(scope)
        is_on = scope.inputs["power"] > 0.5
        integral = where(is_idle, 0.0, self._integral(scope, error, cut))
        return {
            "integral": where(is_on, integral, memory["integral"]),
            "derivative": derivative,
            "last_pressure": pressure,
            "pilot_setpoint": where(is_idle, ambient, given),
            "actual_pressure": pressure,
        }  # fmt: skip

    def _integral(self, scope: Scope, error: Any, cut: Any) -> Any:
        """The integral after a sample; without an integral time it is zero."""
        integral_time, time = scope["outer.integral_time"], scope["outer.sample_time"]
        band = scope["outer.integral_band"]
        # Numbers are symbols here: 0 as "no band", "no limit", "no integral" is a choice at run time, not in Python.
        counted = scope["outer.gain"] * error + cut
        counted = where(band > 0.0, where(error * error > band * band, 0.0, counted), counted)
        new = scope.memory["integral"] + time / maximum(integral_time, time) * counted
        limit = where(scope["outer.integral_limit"] > 0.0, scope["outer.integral_limit"], _UNLIMITED)
        return where(integral_time > 0.0, clip(new, -limit, limit), 0.0)

    def _is_suppressed(self, scope: Scope) -> Any:
        low, high = scope["scaling.low"], scope["scaling.high"]
        # Never without a suppression: the target is held at `low` from below.
        return self._target(scope) < low + scope["zero_suppression"] * (high - low)

    def _inner(self, scope: Scope) -> dict[str, Any]:
        error = scope.memory["pilot_setpoint"] - self._read(scope, "pilot")
        least = scope["inner.minimum_duty"]
        band = scope["inner.hold_band"]
        push = scope["inner.gain"] * error
        fill = where(error > band, clip(push + least, 0.0, 1.0), 0.0)
        vent = where(error < -band, clip(least - push, 0.0, 1.0), 0.0)
        is_idle, is_on = self._is_suppressed(scope), scope.inputs["power"] > 0.5
        return {
            "fill_duty": where(is_on, where(is_idle, 0.0, fill), 0.0),
            **self._vented(scope, where(is_on, where(is_idle, 1.0, vent), 0.0)),
        }

    def _vented(self, scope: Scope, wanted: Any) -> dict[str, Any]:
        """The venting solenoid after a sample that wants a duty of it: it opens when the delay is over."""
        memory, delay = scope.memory, scope["inner.vent_delay"]
        # A wish to vent that goes on keeps the instant at which its delay is over.
        goes_on = memory["vent_wanted"] > 0.0
        begins = where(delay > 0.0, scope.time + delay, NEVER)
        ready = where(goes_on, memory["vent_ready"], where(delay > 0.0, 0.0, 1.0))
        return {
            "vent_wanted": wanted,
            "vent": where(wanted > 0.0, where(goes_on, memory["vent"], begins), NEVER),
            "vent_ready": where(wanted > 0.0, ready, 0.0),
            "vent_duty": ready * wanted,
        }
