"""Electronics of a pressure valve: sampled loops of the outlet pressure and of the pilot pressure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import OutOfRangeError
from poppet.core.symbolic import clip, floor, is_certain, maximum, where
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
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
from poppet.parts.quantities import difference_properties
from poppet.parts.safe_state import FAULT_INPUT, FAULT_MEMORY, NEVER_VALID, fault_state

MIN_LAG = 1e-6
"""Lower bound of the lag of a sensor [s], which avoids a division by zero."""
MIN_SAMPLE_TIME = 1e-6
MIN_DEAD_BAND = 1e-3
"""Lower bound of the dead band [Pa], which avoids a division by zero."""
SENSOR_TOLERANCE = 10.0
"""Factor on the tolerance of the sensors: the default error is below a hundredth of a converter step."""


@dataclass(frozen=True)
class Scaling:
    """Outlet pressures for a setpoint of 0 % and 100 %."""

    low: NumberLike = number("Pa", "0 bar g", doc="pressure at 0 % of the setpoint", kind="pressure")
    high: NumberLike = number("Pa", doc="pressure at 100 % of the setpoint", kind="pressure")


@dataclass(frozen=True)
class FirstOrderSensor:
    """Parameters of a sensor with a first-order lag and an offset."""

    lag: NumberLike = number("s", 0.0, doc="time constant", low=0.0, note="none")
    offset: NumberLike = number("Pa", 0.0, doc="offset", note="none", varies=difference_properties)


@dataclass(frozen=True)
class Converter:
    """Parameters of the analogue-to-digital converter for the pressure sensors.

    The sensors measure outlet pressure and pilot pressure.
    """

    bits: NumberLike = number("1", 0.0, doc="bits of the converter", low=0.0, high=32.0, note="no quantisation")
    span: NumberLike = number("Pa", "10 bar", doc="pressure difference at full scale", above=0.0)


@dataclass(frozen=True)
class OuterLoop:
    """Parameters of the controller of the outlet pressure, which sets the setpoint of the pilot pressure.

    It is a PI or PID controller K (1 + 1/(T_i s) + T_d s) with feed-forward: the gauge setpoint times `feed_forward` is
    added to the pilot setpoint. `dead_zone` is added to the output with the sign of the error, so the valve seats open
    before the integral has grown. `correction_limit` keeps the pilot pressure close to the pressure at which the main
    stage closes.
    """

    gain: NumberLike = number("1", doc="gain", low=0.0)
    integral_time: NumberLike = number("s", 0.0, doc="integral time", low=0.0, note="no integral")
    derivative_time: NumberLike = number("s", 0.0, doc="derivative time", low=0.0, note="no derivative")
    derivative_filter: NumberLike = number("s", "5 ms", doc="time constant of the derivative's filter", low=0.0)
    feed_forward: NumberLike = number("1", 1.0, doc="feed-forward of the setpoint", low=0.0)
    bias: NumberLike = number("Pa", 0.0, doc="bias of the pilot pressure", note="none")
    dead_band: NumberLike = number("Pa", 0.0, doc="dead band of the error", low=0.0, note="none")
    integral_band: NumberLike = number("Pa", 0.0, doc="highest error that is integrated", low=0.0, note="no limit")
    integral_limit: NumberLike = number("Pa", 0.0, doc="limit of the integral", low=0.0, note="no limit")
    dead_zone: NumberLike = number("Pa", 0.0, doc="half the dead zone of the seats", low=0.0, note="none")
    correction_limit: NumberLike = number(
        "Pa",
        0.0,
        doc="limit of the correction; sum of proportional part, dead zone and integral",
        low=0.0,
        note="no limit",
    )
    pilot_limit: NumberLike = number("Pa", doc="highest pilot pressure", kind="pressure", above=0.0)
    sample_time: NumberLike = number("s", "1 ms", doc="sample time of the outer loop", low=MIN_SAMPLE_TIME)


@dataclass(frozen=True)
class InnerLoop:
    """Parameters of the proportional controller of the pilot pressure.

    Both solenoid valves are closed if the error is within `hold_band`.
    """

    gain: NumberLike = number("1/Pa", doc="duty per error of the pilot pressure", low=0.0)
    hold_band: NumberLike = number(
        "Pa", 0.0, doc="hold band; error up to which both solenoid valves are closed", low=0.0, note="none"
    )
    minimum_duty: NumberLike = number("1", 0.0, doc="minimum duty", low=0.0, below=1.0, note="none")
    vent_delay: NumberLike = number("s", 0.0, doc="delay of venting", low=0.0, note="at once")
    sample_time: NumberLike = number("s", "1 ms", doc="sample time of the inner loop", low=MIN_SAMPLE_TIME)


SCALES = {"pressure": ("Pa", 0.0, 0.0), "0-10 V": ("V", 0.0, 10.0), "4-20 mA": ("A", 4e-3, 20e-3)}
"""Unit of the setpoint by type, and its values at 0 % and 100 %; a pressure is not scaled."""
PRESETS = ("universal", "fast", "precise")
_UNLIMITED = 1e12
_SENSORS = ("outlet", "pilot")


@dataclass(frozen=True)
class Electronics(Controller):
    r"""Sampled controller of a piloted pressure valve with an outer and an inner loop.

    .. math:: p_{p,set} = p_a + f (w - p_a) + p_0
              + \operatorname{clip}\left(K e + z \operatorname{clip}(e / e_0, -1, 1) + I, -c, c\right)
              - K T_d\, \dot p_2, \qquad I = \frac{K}{T_i} \sum e\, T

    .. math:: d = \operatorname{clip}(K_i e_p + d_{min} \operatorname{sign} e_p, -1, 1) \quad (|e_p| > \text{band}),
              \qquad e_p = p_{p,set} - p_p

    In the first equation, w is the target of the outlet pressure, :math:`p_a` the ambient pressure, f `feed_forward`,
    :math:`p_0` `bias`, e the error beyond the dead band :math:`e_0`, z `dead_zone` (without effect if :math:`e_0` is
    0), c `correction_limit`, :math:`p_2` the outlet pressure and T the sample time. In the second one, :math:`p_p` is
    the pilot pressure, and d the duty of the fill solenoid; a negative d is the duty of the vent solenoid.

    Notes
    -----
    Inputs are `setpoint`, `outlet_pressure`, `pilot_pressure` [Pa], `power` (1 is on; at 0, both solenoids are closed
    and the pressure remains) and `input_fault` (1: an input is not valid). After `fault_time` with an input fault, the
    duty is `safe_command`, positive to fill, and the integral is constant. `setpoint_delay` acts on a signal, but not
    on an output that is connected to the setpoint. The parameter set `data` has a variant for each `preset`. If both
    loops sample at one instant, the inner loop uses the new result of the outer loop.

    Anti-windup is by back-calculation: the part of the pilot setpoint that c or the limits of the pilot pressure cut
    off is subtracted from the integral with the time constant `integral_time`. The integral is constant while the error
    exceeds `integral_band`. A run that continues another run starts with the last integral of that run; its clocks
    restart, and its derivative starts at zero.

    References
    ----------
    Varga & Keski-Honkola 2012, section 2 and fig. 1, mention the electronics without a model.
    """

    kind: ClassVar[str] = "electronics"
    symbol: ClassVar[symbols.Symbol | str] = symbols.ELECTRONICS
    summary: ClassVar[str] = "sampled pressure control: outer PI(D), inner pilot loop, sensors, converter"
    internal_outputs: ClassVar[tuple[str, ...]] = (
        "actual_value", "pilot_setpoint", "integral", "fill_duty", "vent_duty", "outlet_sensor_pressure",
        "pilot_sensor_pressure", "input_fault",
    )  # fmt: skip

    data: Any = reference(doc="name of a parameter set of the library")
    preset: str = option(*PRESETS, doc="preset; variant of the parameter set in `data`")
    setpoint_type: str = option(*SCALES, doc="type of setpoint")
    setpoint_delay: NumberLike = number("s", 0.0, doc="delay of the setpoint's signal", low=0.0, note="none")
    scaling: Any = group(Scaling, doc="pressures at 0 % and 100 %")
    zero_suppression: NumberLike = number(
        "1",
        0.0,
        doc="zero-point suppression; fraction of the range below which the setpoint counts as zero",
        low=0.0,
        below=1.0,
        note="none",
    )
    outlet_sensor: Any = group(FirstOrderSensor, doc="sensor of the outlet pressure")
    pilot_sensor: Any = group(FirstOrderSensor, doc="sensor of the pilot pressure")
    converter: Any = group(Converter, doc="converter")
    outer: Any = group(OuterLoop, doc="outer loop")
    inner: Any = group(InnerLoop, doc="inner loop")
    initial_integral: NumberLike = number("Pa", 0.0, doc="integral at the start", note="none")
    fault_time: NumberLike = number("s", "0.1 s", doc="time from an invalid input to the safe command", low=0.0)
    safe_command: NumberLike = number(
        "1", 0.0, doc="duty of the solenoids after an invalid input", low=-1.0, high=1.0, note="valves closed"
    )

    resume: ClassVar[dict[str, str]] = {"integral": "initial_integral"}
    measured: ClassVar[tuple[str, ...]] = ("outlet_pressure", "pilot_pressure")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        times = sorted({numbers.text(loop.sample_time) for loop in (self.outer, self.inner)})
        setpoint = f"setpoint: {self.setpoint_type}"
        return [f"electronics, {self.preset}", setpoint, f"samples every {', '.join(times)}"]

    def variant(self) -> str:
        # An invalid preset is reported by its own check, not by all numbers that would be missing.
        return self.preset if self.preset in PRESETS else PRESETS[0]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if is_certain(values["scaling.low"] >= values["scaling.high"]):
            raise OutOfRangeError("valve.scaling_exchanged", "scaling.high", shown=self.scaling.high.display())
        first = SCALES[self.setpoint_type][1]
        values["setpoint"] = values["scaling.low"] if self.setpoint_type == "pressure" else first
        values["outlet_pressure"] = values["pilot_pressure"] = ambient.pressure
        return values

    def ascending_parameters(self) -> tuple[tuple[str, str], ...]:
        return (("scaling.low", "scaling.high"),)

    def options(self) -> dict[str, str]:
        # A preset is a set of numbers and does not change the model.
        return {name: choice for name, choice in super().options().items() if name != "preset"}

    def states(self) -> tuple[State, ...]:
        return tuple(State(f"{name}_sensor_pressure", "Pa", 1e5, SENSOR_TOLERANCE) for name in _SENSORS)

    def memory(self) -> tuple[DiscreteState, ...]:
        pressures = ("integral", "pilot_setpoint", "last_pressure", "derivative", "actual_pressure")
        flags = ("vent_ready", "is_last_faulty", "is_limited")
        names = ("fill_duty", "vent_duty", "vent_wanted", "outer_count", "inner_count", *flags)
        fractions = (DiscreteState(name, "1") for name in names)
        return *(DiscreteState(name, "Pa") for name in pressures), *fractions, *FAULT_MEMORY

    def timers(self) -> tuple[Timer, ...]:
        return Timer("outer", 0), Timer("inner", 1), Timer("vent", 2)

    def inputs(self) -> tuple[Input, ...]:
        unit, first, last = SCALES[self.setpoint_type]
        limits: dict[str, Any] = {"low": first, "high": last}
        if self.setpoint_type == "pressure":
            limits = {"low": "scaling.low", "high": "scaling.high", "kind": "pressure"}
        setpoint = Input("setpoint", unit, "setpoint", delay="setpoint_delay", is_command=True, **limits)
        pressures = [Input(name, "Pa", name, kind="pressure", low=0.0) for name in self.measured]
        return setpoint, Input("power", "1", 1.0, low=0.0, high=1.0, is_flag=True), *pressures, FAULT_INPUT

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return {
            "target_pressure": ("scaling.low", "scaling.high"), "pilot_setpoint": (0.0, float("inf")),
            "fill_duty": (0.0, 1.0), "vent_duty": (0.0, 1.0),
        }  # fmt: skip

    def sensors(self) -> dict[str, tuple[str, str]]:
        return {f"{name}_sensor_pressure": (f"{name}_pressure", f"{name}_sensor") for name in _SENSORS}

    def start(self, scope: Scope) -> dict[str, Any]:
        ambient = scope.surroundings.pressure
        values = {f"{name}_sensor_pressure": scope.inputs[f"{name}_pressure"] for name in _SENSORS}
        values |= {state.name: 0.0 for state in self.memory()}
        values |= {"pilot_setpoint": ambient, "last_pressure": ambient, "integral": scope["initial_integral"]}
        values |= {"outer": 0.0, "inner": 0.0, "vent": NEVER, "faulty_samples": NEVER_VALID}
        return values | {"actual_pressure": scope.inputs["outlet_pressure"]}

    def list_internal_outputs(self) -> tuple[str, ...]:
        # With a setpoint in volts or amperes, the target is the output to compare with a pressure.
        return *self.internal_outputs, *(["target_pressure"] if self.setpoint_type == "pressure" else [])

    def control(self, scope: Scope) -> ControlOutputs:
        rates = {}
        for name in _SENSORS:
            lag = maximum(scope[f"{name}_sensor.lag"], MIN_LAG)
            state = f"{name}_sensor_pressure"
            rates[state] = (scope.inputs[f"{name}_pressure"] - scope.states[state]) / lag
        memory, actual_value = scope.memory, scope.memory["actual_pressure"]
        unit, first, last = SCALES[self.setpoint_type]
        if self.setpoint_type != "pressure":
            low, high = scope["scaling.low"], scope["scaling.high"]
            actual_value = first + (last - first) * (actual_value - low) / (high - low)
        outputs = {
            "target_pressure": (self._target(scope), "Pa"),
            "actual_value": (actual_value, unit),
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
        """Return the target of the outlet pressure for the present setpoint [Pa].

        The target is limited to the range from `scaling.low` to `scaling.high`.
        """
        low, high = scope["scaling.low"], scope["scaling.high"]
        target = scope.inputs["setpoint"]
        if self.setpoint_type != "pressure":
            _, first, last = SCALES[self.setpoint_type]
            target = low + (high - low) * (target - first) / (last - first)
        return clip(target, low, high)

    def _read(self, scope: Scope, name: str) -> Any:
        """Return the reading of a pressure sensor after analogue-to-digital conversion [Pa].

        `name` is `outlet` or `pilot`.
        """
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
        scope.label("target", target, "target of the outlet pressure [Pa]")
        scope.label("outlet_reading", pressure, "measured outlet pressure after conversion [Pa]")
        band, gain = scope["outer.dead_band"], scope["outer.gain"]
        error = target - pressure
        error = maximum(error - band, 0.0) - maximum(-error - band, 0.0)
        filter_time, derivative_time = scope["outer.derivative_filter"], scope["outer.derivative_time"]
        is_faulty = scope.inputs["input_fault"] > 0.5
        is_safe = where(is_faulty, memory["is_safe"], 0.0)
        # Neither the first sample nor the first one after a fault has a valid previous pressure.
        follows_fault = where(is_faulty, 0.0, memory["is_last_faulty"])
        has_last = where(follows_fault > 0.5, 0.0, memory["outer_count"])
        last = where(has_last > 0.0, memory["last_pressure"], pressure)
        # Of the pressure, not of the error: a setpoint step causes no kick. The backward difference is always stable.
        change = gain * derivative_time * (last - pressure)
        derivative = (filter_time * memory["derivative"] + change) / (filter_time + time)
        scope.label("new_derivative", derivative, "derivative part of the pilot pressure [Pa]")
        forward = ambient + scope["outer.feed_forward"] * (target - ambient) + scope["outer.bias"]
        scope.label("forward", forward, "feed-forward of the pilot pressure [Pa]")
        # Crosses the dead zone of the seats over a second dead band of the error; without this ramp it would be a
        # relay.
        crossing = scope["outer.dead_zone"] * clip(error / maximum(band, MIN_DEAD_BAND), -1.0, 1.0)
        crossing = where(band > 0.0, crossing, 0.0)
        scope.label("error", error, "error of the outlet pressure beyond the dead band [Pa]")
        correction = gain * error + crossing + memory["integral"]
        scope.label("correction", correction, "correction of the pilot pressure [Pa]")
        limit = where(scope["outer.correction_limit"] > 0.0, scope["outer.correction_limit"], _UNLIMITED)
        # The derivative is outside this limit: it acts on a small volume early and on a large one little.
        limited = forward + clip(correction, -limit, limit) + derivative
        pilot = clip(limited, ambient, scope["outer.pilot_limit"])
        scope.label("unlimited", limited, "setpoint of the pilot pressure before its limits [Pa]")
        scope.label("limited", pilot, "setpoint of the pilot pressure within its limits [Pa]")
        excess = pilot - forward - derivative - correction
        is_idle = self._is_suppressed(scope)
        is_on = scope.inputs["power"] * (1.0 - is_safe) > 0.5
        scope.label("is_idle", is_idle, "true below the zero-point suppression")
        integral = where(is_idle, 0.0, self._integral(scope, error, excess))
        return {
            "integral": where(is_on, integral, memory["integral"]),
            "derivative": derivative,
            "last_pressure": pressure,
            "is_last_faulty": where(is_faulty, 1.0, 0.0),
            "pilot_setpoint": where(is_idle, ambient, pilot),
            "actual_pressure": pressure,
            "is_limited": where(limited > scope["outer.pilot_limit"], 1.0, 0.0),
        }

    def _integral(self, scope: Scope, error: Any, excess: Any) -> Any:
        """Return the integral part of the outer loop after a sample, limited and with anti-windup [Pa].

        `error` is the control error [Pa]. `excess` is the change of the pilot setpoint by its limits [Pa]. `scope`
        contains parameters and states. The result is zero if the integral time is zero.
        """
        integral_time, time = scope["outer.integral_time"], scope["outer.sample_time"]
        band = scope["outer.integral_band"]
        # Parameters are symbols: 0 as "no band", "no limit" and "no integral" is decided at run time, not in Python.
        increment = scope["outer.gain"] * error + excess
        increment = where(band > 0.0, where(error * error > band * band, 0.0, increment), increment)
        new = scope.memory["integral"] + time / maximum(integral_time, time) * increment
        limit = where(scope["outer.integral_limit"] > 0.0, scope["outer.integral_limit"], _UNLIMITED)
        return where(integral_time > 0.0, clip(new, -limit, limit), 0.0)

    def _is_suppressed(self, scope: Scope) -> Any:
        low, high = scope["scaling.low"], scope["scaling.high"]
        # Never true without suppression: the target is at least `low`.
        return self._target(scope) < low + scope["zero_suppression"] * (high - low)

    def _inner(self, scope: Scope) -> dict[str, Any]:
        error = scope.memory["pilot_setpoint"] - self._read(scope, "pilot")
        minimum, band = scope["inner.minimum_duty"], scope["inner.hold_band"]
        scope.label("pilot_error", error, "error of the pilot pressure [Pa]")
        proportional = scope["inner.gain"] * error
        scope.label("proportional", proportional, "proportional part of the duty")
        fill = where(error > band, clip(proportional + minimum, 0.0, 1.0), 0.0)
        vent = where(error < -band, clip(minimum - proportional, 0.0, 1.0), 0.0)
        is_idle, is_on = self._is_suppressed(scope), scope.inputs["power"] > 0.5
        is_cut = where(fill + vent > 0.0, where(proportional * proportional > (1.0 - minimum) ** 2, 1.0, 0.0), 0.0)
        is_cut = maximum(is_cut, scope.memory["is_limited"])
        is_safe, fault = fault_state(scope, scope["inner.sample_time"])
        fill = where(is_safe > 0.5, maximum(scope["safe_command"], 0.0), where(is_idle, 0.0, fill))
        vent = where(is_safe > 0.5, maximum(-scope["safe_command"], 0.0), where(is_idle, 1.0, vent))
        # The vent solenoid opens after its delay. A request that continues keeps the end of its delay.
        scope.label("fill", fill, "requested duty of the fill solenoid")
        memory, delay, duty = scope.memory, scope["inner.vent_delay"], where(is_on, vent, 0.0)
        scope.label("duty", duty, "requested duty of the vent solenoid")
        continues = memory["vent_wanted"] > 0.0
        opening_time = where(delay > 0.0, scope.time + delay, NEVER)
        ready = where(continues, memory["vent_ready"], where(delay > 0.0, 0.0, 1.0))
        scope.label("ready", ready, "1 if the delay of venting is over")
        return {
            **fault,
            "is_saturated": where(is_on, where(is_safe > 0.5, 0.0, is_cut), 0.0),
            "fill_duty": where(is_on, fill, 0.0),
            "vent_wanted": duty,
            "vent": where(duty > 0.0, where(continues, memory["vent"], opening_time), NEVER),
            "vent_ready": where(duty > 0.0, ready, 0.0),
            "vent_duty": ready * duty,
        }
