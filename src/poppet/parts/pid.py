"""Sampled PID controller with fixed or scheduled gains."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError, OutOfRangeError
from poppet.core.provenance import Number
from poppet.core.symbolic import clip, is_certain, maximum, minimum, where
from poppet.laws.physics.dead_zone import add_dead_zone, remove_dead_zone
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, number, option, reference, switch
from poppet.parts.part import DiscreteState, Input, Quantities, Scope, Surroundings
from poppet.parts.quantities import (
    COMMANDS,
    QUANTITIES,
    command_change_properties,
    command_of,
    command_properties,
    difference_properties,
    gain_properties,
    limit_properties,
)  # fmt: skip
from poppet.parts.rows import GainSchedule
from poppet.parts.safe_state import is_first_after_fault, recovers
from poppet.parts.sampled_loop import SampledLoop, is_first

_SCHEDULED = ("gain", "integral_time", "derivative_time", "vent_factor")
_LIMITS = ("lower_limit", "upper_limit")
_OF_OPENINGS = ("fill_limit", "vent_limit", "vent_factor")
_DEAD_ZONES = ("fill_dead_zone", "vent_dead_zone")
_MARGIN = 0.1
"""Limit of the integral beyond the limits of the command, as a fraction of the range of the command."""
_MOVING = ("position", "angle")
"""Measured quantities with an acceleration."""


def _has_dead_zone(part: Any) -> bool:
    return any(getattr(part, name) is not None for name in _DEAD_ZONES)


@dataclass(frozen=True)
class PID(SampledLoop):
    r"""Sampled PID controller of a pressure, a position, a force or another quantity.

    .. math:: v_k = v_0 + K \left(e_k - (1 - \beta)(w_k - y_0)\right) + I_k + D_k + f_k, \qquad
              u_k = \operatorname{clip}(v_k, -a_v/\varphi, a_f)

    .. math:: D_k = \frac{T_f D_{k-1} - K T_d (y_k - y_{k-1})}{T_f + T}, \qquad
              I_{k+1} = I_k + d_k + \frac{T}{T_t} (u_k - v_k)

    Here w is the setpoint, y the measurement, e = w - y the error, u the command, T the sample time, :math:`y_0` the
    initial measurement, :math:`v_0` the `bias`, :math:`a_f` the `fill_limit` and :math:`a_v` the `vent_limit`. The
    increment :math:`d_k` is :math:`K T e_k / T_i`, limited so that :math:`v_k + d_k` exceeds the limits of the command
    by at most the smaller of the increment and a tenth of the range of the command. A positive opening command u opens
    the fill valve; a negative one opens the vent valve by :math:`-\varphi u`. Commands of other quantities are limited
    by `lower_limit` and `upper_limit`.

    Notes
    -----
    The units of the parameters above are those for a measured pressure. Inputs are `setpoint`, `measurement`,
    `automatic` (if it is 0, the command is `manual_command`) and, if the option `feedforward` is true, `feedforward`.
    Its value f is added to the command before its limits. In manual mode the integral follows the command, so the
    change to automatic is bumpless. A change of scheduled gains is bumpless too: gains act on changes of the error
    (velocity form).

    The input `input_fault` is 1 if an input is not valid. After `fault_time` with an input fault, the command is
    `safe_command`. An opening is limited to `fill_limit` and `vent_limit`; another command outside its limits becomes
    the lower limit. The first sample with valid inputs continues from the safe command. Its derivative does not contain
    the change of the measurement during the fault.

    With `acceleration_time` :math:`T_a`, the acceleration a contributes :math:`-K T_a^2 a` to the command. It is the
    second difference of the measured position or angle, each with the derivative filter, or the input `acceleration` if
    the option `acceleration_input` is true. After an input fault, the estimate begins again: the acceleration does not
    contain the change of the measurement during the fault.

    With `fill_dead_zone` and `vent_dead_zone`, the command of the law v becomes that of valves with dead zones, by
    `poppet.laws.physics.dead_zone.add_dead_zone`. Limits, manual command and safe command are those of the valves. The
    integral and its anti-windup refer to the command of the law.

    The derivative acts on the measurement alone. An integral or derivative time of 0 disables the integral or the
    derivative; a tracking time of 0 selects the integral time. A schedule is a mapping with one list per column: the
    measured quantity by its name (`pressure`), `gain`, `integral_time`, `derivative_time`, `vent_factor`.

    References
    ----------
    Aastroem & Haegglund, Advanced PID Control, ISA 2006: setpoint weight, filter, back-calculation and conditional
    integration, which are combined here. Kaminer, Pascoal, Khargonekar & Coleman, A velocity algorithm for the
    implementation of gain-scheduled controllers, Automatica 31 (1995). Wang, Pu & Moore, A practical control strategy
    for servo-pneumatic actuator systems, Control Engineering Practice 7 (1999) 1483-1488: acceleration feedback.
    """

    kind: ClassVar[str] = "pid"
    symbol: ClassVar[symbols.Symbol | str] = symbols.PID
    internal_outputs: ClassVar[tuple[str, ...]] = (
        *SampledLoop.internal_outputs, "integral", "derivative", "automatic", "manual_command",
        "acceleration_feedback", "uncompensated_command",
    )  # fmt: skip
    summary: ClassVar[str] = "sampled PID control, gains fixed or over operating points"

    quantity: str = option(*QUANTITIES, doc="measured quantity")
    command_quantity: str = option(*COMMANDS, doc="commanded quantity")
    feedforward: str = switch(doc="feedforward; adds an input to the command")
    acceleration_input: str = switch(doc="acceleration input; replaces the second difference of the measurement")
    lower_limit: NumberLike = number("1", optional=True, doc="lower limit of the command", varies=limit_properties)
    upper_limit: NumberLike = number("1", optional=True, doc="upper limit of the command", varies=limit_properties)
    gain: NumberLike = number("1/Pa", optional=True, doc="gain K, command per error", varies=gain_properties)
    integral_time: NumberLike = number("s", optional=True, doc="integral time T_i", low=0.0)
    derivative_time: NumberLike = number("s", optional=True, doc="derivative time T_d", low=0.0)
    derivative_filter: NumberLike = number("s", "5 ms", doc="time constant of the derivative's filter", low=0.0)
    acceleration_time: NumberLike = number("s", optional=True, doc="acceleration time T_a", low=0.0)
    setpoint_weight: NumberLike = number("1", 1.0, doc="setpoint weight beta", low=0.0, high=1.0, note="full")
    tracking_time: NumberLike = number("s", 0.0, doc="tracking time T_t", low=0.0, note="as the integral time")
    bias: NumberLike = number(
        "1", 0.0, doc="command at zero error", low=-1.0, high=1.0, note="none", varies=command_properties
    )
    dead_band: NumberLike = number(
        "Pa", 0.0, doc="dead band of the error", low=0.0, note="none", varies=difference_properties
    )
    integral_dead_band: NumberLike = number(
        "Pa", optional=True, doc="dead band of the integral", above=0.0, varies=difference_properties
    )
    fill_dead_zone: NumberLike = number(
        "1", optional=True, doc="dead zone of the fill valve; opening command without flow", low=0.0, below=1.0
    )
    vent_dead_zone: NumberLike = number(
        "1", optional=True, doc="dead zone of the vent valve; opening command without flow", low=0.0, below=1.0
    )
    dead_zone_smoothing: NumberLike = number(
        "1", 0.01, doc="smoothing h of the compensation", above=0.0, high=1.0, note="one percent of the command",
        # The field has a default only if there is a dead zone.
        varies=lambda part: {} if _has_dead_zone(part) else {"default": None, "optional": True},
    )  # fmt: skip
    vent_factor: NumberLike = number("1", optional=True, doc="vent factor phi of commands to vent", above=0.0)
    initial_integral: NumberLike = number(
        "1", 0.0, doc="integral at the start", note="none", varies=command_change_properties
    )
    schedule: Any = reference(doc="gains over operating points; mapping of lists")
    schedule_by: str = option("measurement", "setpoint", doc="quantity of the operating point")

    resume: ClassVar[dict[str, str]] = {"integral": "initial_integral"}

    def check(self) -> None:
        invalid = _LIMITS if self.is_of_openings else _OF_OPENINGS
        specified = [name for name in invalid if getattr(self, name) is not None]
        if specified:
            valid = _OF_OPENINGS[:2] if self.is_of_openings else _LIMITS
            raise InputError("pid.other_limits", specified[0], command=command_of(self), instead=valid)
        missing = [name for name in _LIMITS if getattr(self, name) is None]
        if missing and not self.is_of_openings:
            raise InputError("pid.no_limits", missing[0], command=command_of(self), unit=self.command_unit)
        dead_zones = [name for name in _DEAD_ZONES if getattr(self, name) is not None]
        if dead_zones and not self.is_of_openings:
            raise InputError("pid.other_dead_zone", dead_zones[0], command=command_of(self))
        if self.dead_zone_smoothing is not None and not dead_zones:
            raise InputError("pid.no_dead_zone", "dead_zone_smoothing", missing=_DEAD_ZONES)
        if self.acceleration_time is not None and self.controls not in _MOVING:
            raise InputError("pid.no_acceleration", "acceleration_time", quantity=self.controls, valid=_MOVING)
        if self.acceleration_input == "true" and self.acceleration_time is None:
            raise InputError("pid.unused_acceleration", "acceleration_input")
        if self.schedule is not None:
            form = self.controls, command_of(self)
            object.__setattr__(self, "schedule", GainSchedule.read(self.schedule, *form))
            specified = [name for name in _SCHEDULED if getattr(self, name) is not None]
            if specified:
                raise InputError("pid.said_twice", specified[0], given=specified)
        elif self.gain is None:
            raise InputError("pid.no_gain", "gain")
        elif not (self.integral_time and float(self.integral_time)) and float(self.setpoint_weight) < 1.0:  # type: ignore[arg-type]
            raise InputError("pid.lasting_error", "setpoint_weight", value=float(self.setpoint_weight))  # type: ignore[arg-type]

    def replaced_fields(self, fields: Iterable[str]) -> tuple[str, ...]:
        return _SCHEDULED if "schedule" in fields else ("schedule",) if "gain" in fields else ()

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        head = f"PID, sampled every {numbers.text(self.sample_time)}"
        if self.schedule is not None:
            return [head, f"gains at {len(self.schedule.columns['gain'])} operating points"]
        times: dict[str, Any] = {"Ti": self.integral_time, "Td": self.derivative_time}
        texts = [f"{symbol} = {numbers.text(t)}" for symbol, t in times.items() if t is not None and float(t) > 0.0]
        others = {"Ta": self.acceleration_time, "fill dead zone": self.fill_dead_zone}
        others["vent dead zone"] = self.vent_dead_zone
        texts += [f"{symbol} = {numbers.text(value)}" for symbol, value in others.items() if value is not None]
        return [head, f"K = {numbers.text(self.gain)}", *texts]

    def numbers(self) -> dict[str, Number]:
        table = {} if self.schedule is None else self.schedule.numbers()
        return super().numbers() | {f"schedule.{name}": value for name, value in table.items()}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if not self.is_of_openings and is_certain(values["lower_limit"] >= values["upper_limit"]):
            low, high = (values[name] for name in _LIMITS)
            raise OutOfRangeError("pid.limits_exchanged", "lower_limit", value=low, upper=high, unit=self.command_unit)
        safe = values["safe_command"]
        is_given = self.safe_command.source.kind == "given"  # type: ignore[union-attr]
        if (
            not self.is_of_openings
            and is_given
            and (is_certain(safe < values["lower_limit"]) or is_certain(safe > values["upper_limit"]))
        ):
            raise OutOfRangeError(
                "fields.out_of_range", "safe_command", shown=f"{safe:g} {self.command_unit}", meaning="safe command",
                limits=[f"at least {values['lower_limit']:g}", f"at most {values['upper_limit']:g}"],
                unit=self.command_unit,
            )  # fmt: skip
        if _has_dead_zone(self):
            values.setdefault("fill_dead_zone", 0.0)
            values.setdefault("vent_dead_zone", values["fill_dead_zone"])
        if self.schedule is not None:
            return values | {f"schedule.{k}": v for k, v in self.schedule.parameters(ambient.pressure).items()}
        values.setdefault("integral_time", 0.0)
        values.setdefault("derivative_time", 0.0)
        if self.is_of_openings:
            values.setdefault("vent_factor", 1.0)
        return values

    def ascending_parameters(self) -> tuple[tuple[str, str], ...]:
        table = self.schedule.ascending_numbers() if self.schedule is not None else ()
        return _LIMITS, *((f"schedule.{low}", f"schedule.{high}") for low, high in table)

    def structure(self) -> Hashable:
        return super().structure(), None if self.schedule is None else self.schedule.structure()

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return super().output_ranges() if self.is_of_openings else {"command": _LIMITS}

    def inputs(self) -> tuple[Input, ...]:
        unit, command = self.command_unit, COMMANDS[command_of(self)]
        manual = Input("manual_command", unit, "bias", kind=command.kind, low=command.low, is_command=True)
        if self.is_of_openings:
            manual = Input("manual_command", unit, 0.0, low=-1.0, high=1.0, is_command=True)
        feedforward = (Input("feedforward", unit, 0.0),) if self.feedforward == "true" else ()
        automatic = Input("automatic", "1", 1.0, low=0.0, high=1.0, is_flag=True)
        measured = (Input("acceleration", f"{self.unit}/s^2", 0.0),) if self.acceleration_input == "true" else ()
        return *super().inputs(), automatic, manual, *feedforward, *measured

    def start(self, scope: Scope) -> dict[str, Any]:
        values = super().start(scope) | {"integral": scope["initial_integral"]}
        if not self.is_of_openings:
            # An inner loop can sample first: a setpoint of zero would be a vacuum.
            command = clip(scope["bias"] + scope["initial_integral"], scope["lower_limit"], scope["upper_limit"])
            values |= {name: command for name in values if name.endswith("command")}
        return values

    def law_memory(self) -> tuple[DiscreteState, ...]:
        units = dict.fromkeys(("integral", "derivative"), self.command_unit)
        units |= dict.fromkeys(("origin", "last_measurement", "last_error"), self.unit)
        units |= {"last_gain": gain_properties(self)["unit"]} if self.schedule is not None else {}
        if self.acceleration_time is not None and self.acceleration_input == "false":
            units |= {"speed": f"{self.unit}/s", "acceleration": f"{self.unit}/s^2", "valid_samples": "1"}
        units |= dict.fromkeys(self._shown_additions(), self.command_unit)
        return tuple(DiscreteState(name, unit) for name, unit in units.items())

    def _shown_additions(self) -> tuple[str, ...]:
        """Return the names of the outputs of the dead zone and of the acceleration."""
        acceleration = () if self.acceleration_time is None else ("acceleration_feedback",)
        return *acceleration, *(("uncompensated_command",) if _has_dead_zone(self) else ())

    def law_outputs(self, scope: Scope) -> Quantities:
        names = ("integral", "derivative", *self._shown_additions())
        return {name: (scope.memory[name], self.command_unit) for name in names}

    def gains_at(self, scope: Scope, measured: Any, setpoint: Any) -> dict[str, Any]:
        """Return gain, times and vent factor of the controller at an operating point.

        Parameters
        ----------
        scope : Scope
            Parameters of the controller.
        measured, setpoint : float or symbol
            Measurement and setpoint in SI units; a pressure is absolute.

        Returns
        -------
        dict
            `gain` [SI unit of the command per unit of the measurement], `integral_time` and `derivative_time` [s], and
            `vent_factor` [1] if the command opens valves.
        """
        if self.schedule is None:
            return {name: scope[name] for name in _SCHEDULED if name in scope}
        table = {name: scope[f"schedule.{name}"] for name in self.schedule.numbers()}
        gains: dict[str, Any] = self.schedule.at(measured if self.schedule_by == "measurement" else setpoint, table)
        return gains

    def compute_command(self, scope: Scope, measured: Any, is_safe: Any) -> tuple[Any, Any, dict[str, Any]]:
        memory, setpoint, time = scope.memory, scope.inputs["setpoint"], scope["sample_time"]
        gains = self.gains_at(scope, measured, setpoint)
        gain, first, recovering = gains["gain"], is_first(scope), recovers(scope, is_safe)
        follows_fault = is_first_after_fault(scope)
        # The setpoint weight refers to the initial measurement, not to zero.
        origin = where(first, measured, memory["origin"])
        # Neither the first sample nor the first one after a fault has a valid previous measurement.
        last = where(first, measured, where(follows_fault > 0.5, measured, memory["last_measurement"]))
        error = setpoint - measured
        error = maximum(error - scope["dead_band"], 0.0) - maximum(-error - scope["dead_band"], 0.0)
        scope.label("error", error, f"error beyond the dead band [{self.unit}]")
        weighted = error - (1.0 - scope["setpoint_weight"]) * (setpoint - origin)
        scope.label("weighted", weighted, f"error with the setpoint weight [{self.unit}]")
        integral = memory["integral"]
        if self.schedule is not None:
            # Compensates the effect of the new gain on the previous error: gains act on changes alone.
            last_gain = where(first, gain, memory["last_gain"])
            integral = integral + (last_gain - gain) * memory["last_error"]
        filter_time = scope["derivative_filter"]
        change = gains["derivative_time"] * (measured - last)
        derivative = (filter_time * memory["derivative"] - gain * change) / (filter_time + time)
        scope.label("new_derivative", derivative, f"derivative part [{self.command_unit}]")
        without_integral = scope["bias"] + gain * weighted + derivative
        if self.feedforward == "true":
            without_integral = without_integral + scope.inputs["feedforward"]
        additions: dict[str, Any] = {}
        if self.acceleration_time is not None:
            acceleration, additions = self._acceleration(scope, measured - last)
            feedback = -gain * scope["acceleration_time"] * scope["acceleration_time"] * acceleration
            scope.label("new_acceleration_feedback", feedback, f"acceleration part [{self.command_unit}]")
            without_integral = without_integral + feedback
            additions["acceleration_feedback"] = feedback
        scope.label("without_integral", without_integral, f"all parts except the integral [{self.command_unit}]")
        low = -scope["vent_limit"] / gains["vent_factor"] if self.is_of_openings else scope["lower_limit"]
        high = scope["fill_limit" if self.is_of_openings else "upper_limit"]
        scope.label("lowest_command", low, f"lower limit of the command [{self.command_unit}]")
        # An opening beyond its limit becomes the limit. Another command outside its limits is not clipped: the upper
        # limit of a pressure is not safe.
        beyond = high if self.is_of_openings else low
        safe = where(scope["safe_command"] > high, beyond, maximum(scope["safe_command"], low))
        scope.label("safe_value", safe, f"safe command within the limits [{self.command_unit}]")
        # In the first sample after a safe state, the integral continues from the safe command.
        has_integral = gains["integral_time"] > 0.0
        safe_of_law = self._command_of_law(scope, gains, safe)
        integral = where(recovering > 0.5, where(has_integral, safe_of_law - without_integral, integral), integral)
        unlimited = without_integral + integral
        scope.label("unlimited", unlimited, f"command before its limits [{self.command_unit}]")
        is_automatic = scope.inputs["automatic"] > 0.5
        dead_zone = self._dead_zone(scope, gains) if _has_dead_zone(self) else None
        compensated = unlimited if dead_zone is None else add_dead_zone(unlimited, *dead_zone)
        requested = where(is_automatic, compensated, scope.inputs["manual_command"])
        scope.label("requested", requested, f"automatic or manual command before the limits [{self.command_unit}]")
        command = where(is_safe > 0.5, safe, clip(requested, low, high))
        scope.label("new_command", command, f"command [{self.command_unit}]")
        limits = self._command_of_law(scope, gains, low), self._command_of_law(scope, gains, high)
        increment = self._integral_increment(scope, gains, error, unlimited, limits)
        scope.label("increment", increment, f"increment of the integral [{self.command_unit}]")
        # In manual mode and in the safe state, the integral follows the command: the return is bumpless.
        command_of_law = self._command_of_law(scope, gains, command)
        following = where(has_integral, command_of_law - without_integral, integral)
        scope.label("following", following, f"integral that gives the present command [{self.command_unit}]")
        is_active = where(is_automatic, where(is_safe > 0.5, 0.0, 1.0), 0.0)
        is_cut = where(requested > high, 1.0, where(requested < low, 1.0, 0.0))
        if self.is_of_openings:
            # A closed valve is not saturated.
            is_cut = where(command * command > 0.0, is_cut, 0.0)
        discrete = {
            "integral": where(is_active > 0.5, integral + increment, following),
            "derivative": derivative,
            "origin": origin,
            "last_measurement": measured,
            "last_error": weighted,
            "is_saturated": where(is_safe > 0.5, 0.0, is_cut),
            **additions,
        } | ({"last_gain": gain} if self.schedule is not None else {})
        if _has_dead_zone(self):
            discrete["uncompensated_command"] = command_of_law
        return command, clip(-gains["vent_factor"] * command, 0.0, 1.0) if self.is_of_openings else None, discrete

    def _acceleration(self, scope: Scope, change: Any) -> tuple[Any, dict[str, Any]]:
        """Return the acceleration, and the new discrete states of its estimate.

        `change` is the change of the measurement since the previous sample. The estimate is the filtered second
        difference. It needs three successive samples with valid inputs; before the third, it decays.
        """
        if self.acceleration_input == "true":
            return scope.inputs["acceleration"], {}
        memory, time, filter_time = scope.memory, scope["sample_time"], scope["derivative_filter"]
        count = memory["valid_samples"]
        filtered = (filter_time * memory["speed"] + change) / (filter_time + time)
        # The first difference after a fault starts the filter, which would otherwise change from an invalid value.
        speed = where(count > 1.5, filtered, change / time)
        scope.label("new_speed", speed, f"rate of the measurement [{self.unit}/s]")
        speed_change = where(count > 1.5, speed - memory["speed"], 0.0)
        acceleration = (filter_time * memory["acceleration"] + speed_change) / (filter_time + time)
        is_faulty = scope.inputs["input_fault"] > 0.5
        acceleration = where(is_faulty, filter_time / (filter_time + time) * memory["acceleration"], acceleration)
        scope.label("new_acceleration", acceleration, f"acceleration [{self.unit}/s^2]")
        valid_samples = where(is_faulty, 0.0, minimum(count + 1.0, 2.0))
        return acceleration, {"speed": speed, "acceleration": acceleration, "valid_samples": valid_samples}

    def _dead_zone(self, scope: Scope, gains: dict[str, Any]) -> tuple[Any, Any, Any]:
        """Return the dead zones of positive and negative commands, and the smoothing.

        A positive command is the opening of the fill valve. A negative command, multiplied by the vent factor, is the
        opening of the vent valve.
        """
        return scope["fill_dead_zone"], scope["vent_dead_zone"] / gains["vent_factor"], scope["dead_zone_smoothing"]

    def _command_of_law(self, scope: Scope, gains: dict[str, Any], command: Any) -> Any:
        """Return the command of the law for a command of the valves."""
        return remove_dead_zone(command, *self._dead_zone(scope, gains)) if _has_dead_zone(self) else command

    def _integral_increment(
        self, scope: Scope, gains: dict[str, Any], error: Any, command: Any, limits: tuple[Any, Any]
    ) -> Any:
        """Return the change of the integral in one sample, with anti-windup.

        `command` is the command before its limits `limits`. The increment moves it at most to a small margin beyond a
        limit. Back-calculation then removes a fraction of the amount by which it exceeds the limit.
        """
        time, integral_time, (low, high) = scope["sample_time"], gains["integral_time"], limits
        if "integral_dead_band" in scope:
            error = where(error * error > scope["integral_dead_band"] * scope["integral_dead_band"], error, 0.0)
        tracking = where(scope["tracking_time"] > 0.0, scope["tracking_time"], integral_time)
        increment = time / maximum(integral_time, time * 1e-6) * gains["gain"] * error
        # Without the margin the command would leave its limit at each sample in which the proportional term falls.
        margin = minimum(maximum(increment, -increment), _MARGIN * (high - low))
        rising = minimum(maximum(high + margin - command, 0.0), increment)
        falling = maximum(minimum(low - margin - command, 0.0), increment)
        increment = where(increment > 0.0, rising, falling)
        increment = increment + time / maximum(tracking, time) * (clip(command, low, high) - command)
        return where(integral_time > 0.0, increment, 0.0)
