"""A sampled PID controller, with gains that may follow the operating point."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError, OutOfRangeError
from poppet.core.provenance import Number
from poppet.core.symbolic import clip, maximum, where
from poppet.parts.fields import NumberLike, number, option, reference, switch
from poppet.parts.gain_schedule import GainSchedule
from poppet.parts.part import DiscreteState, Input, Quantities, Scope, Surroundings
from poppet.parts.quantities import (
    COMMANDS,
    QUANTITIES,
    as_command,
    as_command_change,
    as_difference,
    as_gain,
    as_limit,
    command_of,
)  # fmt: skip
from poppet.parts.sampled_loop import SampledLoop, is_first

_SCHEDULED = ("gain", "integral_time", "derivative_time", "vent_factor")
_LIMITS = ("lower_limit", "upper_limit")
_OF_OPENINGS = ("fill_limit", "vent_limit", "vent_factor")


@dataclass(frozen=True)
class PID(SampledLoop):
    r"""A sampled PID controller of a pressure, a position, a force or another quantity.

    .. math:: v_k = v_0 + K \left(e_k - (1 - \beta)(w_k - y_0)\right) + I_k + D_k + f_k, \qquad
              u_k = \operatorname{clip}(v_k, -a_v/\varphi, a_f)

    .. math:: D_k = \frac{T_f D_{k-1} - K T_d (y_k - y_{k-1})}{T_f + T}, \qquad
              I_{k+1} = I_k + \frac{K T}{T_i} e_k + \frac{T}{T_t} (u_k - v_k)

    A positive command u fills, a negative one vents with :math:`-\varphi u`; a command that is no opening lies between
    two limits of its own.

    Parameters
    ----------
    quantity : str
        What is measured: `pressure` (default), `position`, `angle`, `velocity`, `angular_velocity`, `force`, `torque`,
        `temperature` or `mass_flow`. Units below are those of a pressure.
    command_quantity : str
        `opening` (default) of valves, or any of these quantities: the setpoint of a loop further in.
    feedforward : bool
        Whether it has the input `feedforward`: f, added to the command before its limits, in the command's unit.
    lower_limit, upper_limit : number
        Least and greatest command, in its unit, where that is no opening.
    gain : number
        K, command per error [1/Pa].
    integral_time : number
        T_i [s]; 0 or left out: no integral.
    derivative_time : number
        T_d [s]; 0 or left out: no derivative. It acts on the measurement alone.
    derivative_filter : number
        T_f, time constant of the derivative's filter [s].
    setpoint_weight : number
        beta, part of a setpoint's change that the proportional part sees at once.
    tracking_time : number
        T_t of the anti-windup by back-calculation [s]; 0: as the integral time.
    bias : number
        v_0, command at zero error.
    dead_band : number
        Error that counts as none [Pa].
    integral_dead_band : number
        Error up to which the integral alone rests [Pa].
    vent_factor : number
        phi, opening of the venting valve per negative command.
    initial_integral : number
        I at the start.
    schedule : mapping
        Gains over operating points: lists of the quantity by its name (`pressure`), gain, integral_time,
        derivative_time, vent_factor.
    schedule_by : str
        `measurement` (default) or `setpoint`: which of them is the operating point.

    Notes
    -----
    Inputs are `setpoint`, `measurement`, `automatic` (0: the command is `manual_command`). While it is manual the
    integral follows, so that the change to automatic makes no bump. Gains that follow the operating point act on
    changes of the error (the velocity form), so that they make no bump either.

    References
    ----------
    Aastroem & Haegglund, Advanced PID Control, ISA 2006: setpoint weight, filter, back-calculation. Kaminer, Pascoal,
    Khargonekar & Coleman, A velocity algorithm for the implementation of gain-scheduled controllers, Automatica 31
    (1995).
    """

    kind: ClassVar[str] = "pid"
    internal_outputs: ClassVar[tuple[str, ...]] = (
        *SampledLoop.internal_outputs, "integral", "derivative", "automatic", "manual_command",
    )  # fmt: skip
    summary: ClassVar[str] = "sampled PID control, gains fixed or over operating points"

    quantity: str = option(*QUANTITIES, doc="what is measured")
    command_quantity: str = option(*COMMANDS, doc="what is commanded")
    feedforward: str = switch(doc="true: an input is added to the command")
    lower_limit: NumberLike = number("1", optional=True, doc="least command", varies=as_limit)
    upper_limit: NumberLike = number("1", optional=True, doc="greatest command", varies=as_limit)
    gain: NumberLike = number("1/Pa", optional=True, doc="gain", varies=as_gain)
    integral_time: NumberLike = number("s", optional=True, doc="integral time", low=0.0)
    derivative_time: NumberLike = number("s", optional=True, doc="derivative time", low=0.0)
    derivative_filter: NumberLike = number("s", "5 ms", doc="time constant of the derivative's filter", low=0.0)
    setpoint_weight: NumberLike = number("1", 1.0, doc="setpoint weight", low=0.0, high=1.0, note="full")
    tracking_time: NumberLike = number("s", 0.0, doc="tracking time", low=0.0, note="as the integral time")
    bias: NumberLike = number("1", 0.0, doc="command at zero error", low=-1.0, high=1.0, note="none", varies=as_command)
    dead_band: NumberLike = number("Pa", 0.0, doc="dead band of the error", low=0.0, note="none", varies=as_difference)
    integral_dead_band: NumberLike = number(
        "Pa", optional=True, doc="dead band of the integral", above=0.0, varies=as_difference
    )
    vent_factor: NumberLike = number("1", optional=True, doc="factor on commands to vent", above=0.0)
    initial_integral: NumberLike = number("1", 0.0, doc="integral at the start", note="none", varies=as_command_change)
    schedule: Any = reference(doc="gains over operating points: table of lists")
    schedule_by: str = option("measurement", "setpoint", doc="operating point")

    resume: ClassVar[dict[str, str]] = {"integral": "initial_integral"}

    def check(self) -> None:
        self._check_limits()
        if self.schedule is not None:
            form = self.controls, command_of(self)
            object.__setattr__(self, "schedule", GainSchedule.read(self.schedule, *form))
            given = [name for name in _SCHEDULED if getattr(self, name) is not None]
            if given:
                raise InputError("pid.said_twice", given[0], given=given)
        elif self.gain is None:
            raise InputError("pid.no_gain", "gain")
        elif not self._has_integral and float(self.setpoint_weight) < 1.0:  # type: ignore[arg-type]
            raise InputError("pid.lasting_error", "setpoint_weight", value=float(self.setpoint_weight))  # type: ignore[arg-type]

    def _check_limits(self) -> None:
        """Openings have limits of their own; any other command needs its two."""
        others = _LIMITS if self.is_of_openings else _OF_OPENINGS
        given = [name for name in others if getattr(self, name) is not None]
        if given:
            instead = _OF_OPENINGS[:2] if self.is_of_openings else _LIMITS
            raise InputError("pid.other_limits", given[0], command=command_of(self), instead=instead)
        missing = [name for name in _LIMITS if getattr(self, name) is None]
        if missing and not self.is_of_openings:
            raise InputError("pid.no_limits", missing[0], command=command_of(self), unit=self.command_unit)

    def replaced_fields(self, fields: Iterable[str]) -> tuple[str, ...]:
        return _SCHEDULED if "schedule" in fields else ("schedule",) if "gain" in fields else ()

    @property
    def _has_integral(self) -> bool:
        return self.schedule is not None or (self.integral_time is not None and float(self.integral_time) > 0.0)  # type: ignore[arg-type]

    def numbers(self) -> dict[str, Number]:
        table = {} if self.schedule is None else self.schedule.numbers()
        return super().numbers() | {f"schedule.{name}": value for name, value in table.items()}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if not self.is_of_openings and values["lower_limit"] >= values["upper_limit"]:
            low, high = (values[name] for name in _LIMITS)
            raise OutOfRangeError("pid.limits_exchanged", "lower_limit", value=low, upper=high, unit=self.command_unit)
        if self.schedule is not None:
            return values | {f"schedule.{k}": v for k, v in self.schedule.parameters(ambient.pressure).items()}
        values.setdefault("integral_time", 0.0)
        values.setdefault("derivative_time", 0.0)
        if self.is_of_openings:
            values.setdefault("vent_factor", 1.0)
        return values

    def structure(self) -> Hashable:
        return super().structure(), None if self.schedule is None else self.schedule.structure()

    def inputs(self) -> tuple[Input, ...]:
        unit, of = self.command_unit, COMMANDS[command_of(self)]
        manual = (
            Input("manual_command", unit, 0.0, low=-1.0, high=1.0)
            if self.is_of_openings
            else Input("manual_command", unit, "bias", kind=of.kind, low=of.low)
        )
        fed = (Input("feedforward", unit, 0.0),) if self.feedforward == "true" else ()
        return *super().inputs(), Input("automatic", "1", 1.0, low=0.0, high=1.0), manual, *fed

    def start(self, scope: Scope) -> dict[str, Any]:
        values = super().start(scope) | {"integral": scope["initial_integral"]}
        if not self.is_of_openings:
            # A loop further in may sample before this one has: zero would be a vacuum to it.
            first = clip(scope["bias"] + scope["initial_integral"], scope["lower_limit"], scope["upper_limit"])
            values |= {name: first for name in values if name.endswith("command")}
        return values

    def law_memory(self) -> tuple[DiscreteState, ...]:
        gain = as_gain(self)["unit"]
        gains = (DiscreteState("last_gain", gain),) if self.schedule is not None else ()
        of_command = (DiscreteState(name, self.command_unit) for name in ("integral", "derivative"))
        return *of_command, *(DiscreteState(n, self.unit) for n in ("origin", "last_measurement", "last_error")), *gains

    def law_outputs(self, scope: Scope) -> Quantities:
        return {name: (scope.memory[name], self.command_unit) for name in ("integral", "derivative")}

    def gains_at(self, scope: Scope, measured: Any, setpoint: Any) -> dict[str, Any]:
        """Gain, times and vent factor at an operating point.

        Parameters
        ----------
        scope : Scope
            Gives the numbers.
        measured, setpoint : float or symbol
            In SI, a pressure absolute.

        Returns
        -------
        dict
            `gain` (command per quantity, SI), `integral_time`, `derivative_time` [s], `vent_factor` of openings.
        """
        if self.schedule is None:
            return {name: scope[name] for name in _SCHEDULED if name in scope}
        table = {name: scope[f"schedule.{name}"] for name in self.schedule.numbers()}
        found: dict[str, Any] = self.schedule.at(measured if self.schedule_by == "measurement" else setpoint, table)
        return found

    def compute_command(self, scope: Scope, measured: Any) -> tuple[Any, Any, dict[str, Any]]:
        memory, setpoint, time = scope.memory, scope.inputs["setpoint"], scope["sample_time"]
        now = self.gains_at(scope, measured, setpoint)
        gain, first = now["gain"], is_first(scope)
        # The weight counts the setpoint from where the run began, not from zero.
        origin = where(first, measured, memory["origin"])
        last = where(first, measured, memory["last_measurement"])
        error = setpoint - measured
        error = maximum(error - scope["dead_band"], 0.0) - maximum(-error - scope["dead_band"], 0.0)
        weighted = error - (1.0 - scope["setpoint_weight"]) * (setpoint - origin)
        integral = memory["integral"]
        if self.schedule is not None:
            # What the new gain would make of the old error is taken out again: gains act on changes alone.
            before = where(first, gain, memory["last_gain"])
            integral = integral + (before - gain) * memory["last_error"]
        filtered = scope["derivative_filter"]
        slope = now["derivative_time"] * (measured - last)
        derivative = (filtered * memory["derivative"] - gain * slope) / (filtered + time)
        rest = scope["bias"] + gain * weighted + derivative
        if self.feedforward == "true":
            rest = rest + scope.inputs["feedforward"]
        low, high = self._limits(scope, now)
        given = clip(rest + integral, low, high)
        manual = clip(scope.inputs["manual_command"], low, high)
        is_automatic = scope.inputs["automatic"] > 0.5
        command = where(is_automatic, given, manual)
        growth = self._growth(scope, now, error, given - rest - integral)
        # In manual the integral becomes what the command would need: the change to automatic finds nothing to correct.
        new = {
            "integral": where(is_automatic, integral + growth, manual - rest),
            "derivative": derivative,
            "origin": origin,
            "last_measurement": measured,
            "last_error": weighted,
        } | ({"last_gain": gain} if self.schedule is not None else {})
        return command, clip(-now["vent_factor"] * command, 0.0, 1.0) if self.is_of_openings else None, new

    def _limits(self, scope: Scope, now: dict[str, Any]) -> tuple[Any, Any]:
        """Least and greatest command."""
        if self.is_of_openings:
            return -scope["vent_limit"] / now["vent_factor"], scope["fill_limit"]
        return scope["lower_limit"], scope["upper_limit"]

    def _growth(self, scope: Scope, now: dict[str, Any], error: Any, cut: Any) -> Any:
        """What a sample adds to the integral, with what the limits cut off taken back."""
        time, integral_time = scope["sample_time"], now["integral_time"]
        if "integral_dead_band" in scope:
            error = where(error * error > scope["integral_dead_band"] * scope["integral_dead_band"], error, 0.0)
        tracking = where(scope["tracking_time"] > 0.0, scope["tracking_time"], integral_time)
        grown = time / maximum(integral_time, time * 1e-6) * now["gain"] * error + time / maximum(tracking, time) * cut
        return where(integral_time > 0.0, grown, 0.0)
