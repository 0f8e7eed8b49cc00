"""Small controllers with sampled memory, and plain-float references for them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.parts.fields import NumberLike, number
from poppet.parts.part import (
    NEVER,
    Controller,
    ControlOutputs,
    DiscreteState,
    Input,
    Scope,
    State,
    Timer,
    advance_clock,
)

TIME = {"low": 1e-6}


@dataclass(frozen=True)
class Proportional(Controller):
    """output = gain * (wanted - measured), held between the ticks of a clock."""

    kind: ClassVar[str] = "test_proportional"
    summary: ClassVar[str] = "sampled proportional control"
    reads: ClassVar[str] = "1"
    gives: ClassVar[str] = "1"

    gain: NumberLike = number("1", 1.0, doc="gain")
    sample_time: NumberLike = number("s", 0.1, doc="sample time", **TIME)

    def memory(self) -> tuple[DiscreteState, ...]:
        return DiscreteState("output", "1"), DiscreteState("clock_count", "1")

    def timers(self) -> tuple[Timer, ...]:
        return (Timer("clock"),)

    def inputs(self) -> tuple[Input, ...]:
        return Input("measured", self.reads, 0.0), Input("wanted", self.reads, 0.0)

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"output": 0.0, "clock_count": 0.0, "clock": 0.0}

    def control(self, scope: Scope) -> ControlOutputs:
        return ControlOutputs(
            {"output": (scope.memory["output"], self.gives), "count": (scope.memory["clock_count"], "1")}
        )

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        new = {"output": scope["gain"] * (scope.inputs["wanted"] - scope.inputs["measured"])}
        return new | advance_clock(scope, timer, scope["sample_time"])


class Feeder(Proportional):
    """The same from a pressure to a mass flow rate."""

    reads = "Pa"
    gives = "kg/s"


@dataclass(frozen=True)
class Clocks(Controller):
    """Two clocks that write down when they ticked, and in which order at a common instant."""

    kind: ClassVar[str] = "test_clocks"
    summary: ClassVar[str] = "two clocks"

    first_period: NumberLike = number("s", 0.1, doc="period", **TIME)
    second_period: NumberLike = number("s", 0.1, doc="period", **TIME)
    phase: NumberLike = number("s", 0.0, doc="first tick of the second clock", low=0.0)

    def memory(self) -> tuple[DiscreteState, ...]:
        names = ("first_count", "second_count", "order", "common", "last", "seen")
        return tuple(DiscreteState(name, "1") for name in names)

    def timers(self) -> tuple[Timer, ...]:
        # Declared against their ranks.
        return Timer("second", 1), Timer("first", 0)

    def start(self, scope: Scope) -> dict[str, Any]:
        zero = {each.name: 0.0 for each in self.memory()}
        return zero | {"first": 0.0, "second": scope["phase"], "last": -1.0}

    def control(self, scope: Scope) -> ControlOutputs:
        return ControlOutputs({each.name: (scope.memory[each.name], "1") for each in self.memory()})

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        from poppet.core.symbolic import where

        phase = scope["phase"] if timer == "second" else 0.0
        new = advance_clock(scope, timer, scope[f"{timer}_period"], phase)
        # 1 where the first clock has just ticked at the same instant, seen by the second.
        if timer == "first":
            return new | {"last": scope.time}
        return new | {
            "seen": scope.memory["first_count"],
            "order": where(scope.memory["last"] == scope.time, 1.0, 0.0),
            "common": scope.memory["common"] + where(scope.memory["last"] == scope.time, 1.0, 0.0),
        }


@dataclass(frozen=True)
class Chain(Controller):
    """A timer that sets itself to the same instant `links` times before it waits for the next tick."""

    kind: ClassVar[str] = "test_chain"
    summary: ClassVar[str] = "a timer set to the same instant again"

    links: NumberLike = number("1", 3.0, doc="repeats")
    period: NumberLike = number("s", 0.25, doc="period", **TIME)

    def memory(self) -> tuple[DiscreteState, ...]:
        return DiscreteState("done", "1"), DiscreteState("total", "1"), DiscreteState("ticks", "1")

    def timers(self) -> tuple[Timer, ...]:
        return Timer("again"), Timer("never", 5)

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"done": 0.0, "total": 0.0, "ticks": 0.0, "again": 0.0, "never": NEVER}

    def control(self, scope: Scope) -> ControlOutputs:
        return ControlOutputs({name: (scope.memory[name], "1") for name in ("total", "ticks")})

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        from poppet.core.symbolic import where

        if timer == "never":
            return {"never": NEVER, "total": -1e9}
        done = scope.memory["done"] + 1.0
        is_over = where(done >= scope["links"], 1.0, 0.0)
        ticks = scope.memory["ticks"] + is_over
        return {
            "done": where(is_over > 0.0, 0.0, done),
            "total": scope.memory["total"] + 1.0,
            "ticks": ticks,
            "again": where(is_over > 0.0, ticks * scope["period"], scope.time),
        }


@dataclass(frozen=True)
class Lag(Controller):
    """A continuous lag between sampled parts, and an integrator of its input."""

    kind: ClassVar[str] = "test_lag"
    summary: ClassVar[str] = "a lag and an integrator"

    time_constant: NumberLike = number("s", 0.1, doc="time constant", above=0.0)
    initial: NumberLike = number("1", 0.0, doc="output at the start")

    def states(self) -> tuple[State, ...]:
        return State("output", "1", 1.0), State("integral", "1", 1.0)

    def inputs(self) -> tuple[Input, ...]:
        return (Input("input", "1", 0.0),)

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"output": scope["initial"], "integral": 0.0}

    def control(self, scope: Scope) -> ControlOutputs:
        given, states = scope.inputs["input"], scope.states
        rates = {"output": (given - states["output"]) / scope["time_constant"], "integral": given}
        return ControlOutputs({name: (states[name], "1") for name in ("output", "integral")}, rates)
