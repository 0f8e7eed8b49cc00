"""Faults of valves: a closing element that sticks, switches slowly or leaks.

`Valve` declares the fields of a fault. The equations of each kind of valve apply a `FaultEffect` to their openings and
to the speed of the closing element.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, ClassVar, cast

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.symbolic import clip, where
from poppet.parts.fields import NumberLike, NumberSpec, default_number, number, option, specs
from poppet.parts.part import Input, Part, Scope, Surroundings

HEALTHY = "none"
STUCK_OPEN, STUCK_CLOSED, STUCK, SLOW, LEAK = FAULTS = ("stuck_open", "stuck_closed", "stuck", "slow", "leak")
"""Faults of valves; their codes are 1, 2, ..."""
WITHOUT_POSITION = (STUCK_OPEN, STUCK_CLOSED, LEAK)
"""Faults of valves whose opening is a function of the pressures: they have neither a position nor a switching time."""
ABSENT, COMPLETE = 0.25, 0.75
"""Values of the input `fault` up to which the element moves freely, and from which it is stuck."""
NUMBERS = ("fault_start", "slow_factor", "leak_fraction")
_DEFAULTS = {SLOW: ("slow_factor", 10.0), LEAK: ("leak_fraction", 0.05)}
"""Field that a fault needs, and its default."""


@dataclass(frozen=True)
class FaultEffect:
    """Effect of a fault on the equations of a valve; the default has no effect."""

    opens: Any = 0.0  # weight of the drive to the open position, 0 to 1
    closes: Any = 0.0  # weight of the drive to the closed position, 0 to 1
    holds: Any = 0.0  # 1 for an element that keeps its position
    slowness: Any = 1.0  # factor on the switching times
    leak: Any = 0.0  # opening of the closed flow path, as a fraction of the open one

    @classmethod
    def of(cls, scope: Scope) -> FaultEffect:
        """Return the effect of the fault of a part for its inputs and parameters."""
        if "fault" not in scope.inputs:
            return cls()
        level, code = scope.inputs["fault"], scope["fault_code"]
        stuck = clip((level - ABSENT) / (COMPLETE - ABSENT), 0.0, 1.0)

        def of_fault(fault: str, value: Any) -> Any:
            return where(code == fault_code(fault), value, 0.0)

        return cls(
            opens=of_fault(STUCK_OPEN, stuck),
            closes=of_fault(STUCK_CLOSED, stuck),
            holds=of_fault(STUCK, stuck),
            slowness=1.0 + of_fault(SLOW, level * (scope["slow_factor"] - 1.0)),
            leak=of_fault(LEAK, level * scope["leak_fraction"]),
        )

    def forced(self, value: Any, open_value: Any, closed_value: Any) -> Any:
        """Return the drive of an element that a fault moves to its open or closed position.

        `value` is the drive without a fault, `open_value` and `closed_value` those of both positions.
        """
        return value + self.opens * (open_value - value) + self.closes * (closed_value - value)

    def held(self, rate: Any) -> Any:
        """Return the rate of change of a position; it is 0 if the element keeps its position."""
        return (1.0 - self.holds) * rate

    def leaking(self, value: Any, open_value: Any = 1.0) -> Any:
        """Return an opening or a conductance with the leak past the closing element.

        `open_value` is its value at the open position.
        """
        return value + self.leak * (open_value - value)


def fault_code(fault: str) -> float:
    """Return the value of the parameter that selects a fault."""
    return float(FAULTS.index(fault) + 1)


def _default_of(fault: str) -> Callable[[Any], Mapping[str, Any]]:
    return lambda part: {"default": _DEFAULTS[fault][1]} if part.fault == fault else {}


@dataclass(frozen=True, kw_only=True)
class Valve(Part):
    """Base class of valves, which can have a fault.

    All faults of a valve have the same equations, in which the parameter `fault_code` selects the fault.
    """

    faults: ClassVar[tuple[str, ...]] = FAULTS
    """Faults that this kind of valve can have."""

    fault: str = option(HEALTHY, *FAULTS, doc="fault")
    fault_start: NumberLike = number(
        "s", optional=True, doc="start of the fault; by default the start of the run", low=0.0
    )
    slow_factor: NumberLike = number(
        "1",
        optional=True,
        doc='slow factor; factor on the switching times with fault = "slow", by default 10',
        low=1.0,
        note="a dirty valve",
        varies=_default_of(SLOW),
    )
    leak_fraction: NumberLike = number(
        "1",
        optional=True,
        doc='leak fraction; C past the closed element per C of the open path with fault = "leak", by default 0.05',
        low=0.0,
        high=1.0,
        note="a worn seal",
        varies=_default_of(LEAK),
    )

    def __post_init__(self) -> None:
        self.forget_defaults()
        super().__post_init__()

    def forget_defaults(self) -> None:
        """Reset the defaults of faults to None, because a copy with another fault must not keep them."""
        for fault, (name, _) in _DEFAULTS.items():
            value, spec = getattr(self, name), cast(NumberSpec, specs(type(self))[name])
            if value is not None and value == default_number(name, spec.within(SimpleNamespace(fault=fault))):
                object.__setattr__(self, name, None)

    def check(self) -> None:
        super().check()
        if self.fault not in (HEALTHY, *self.faults):
            raise InputError("faults.not_possible", "fault", fault=self.fault, kind=self.kind, possible=[*self.faults])

    def notes(self) -> tuple[Note, ...]:
        return (*super().notes(), *self.fault_notes())

    def fault_notes(self) -> tuple[Note, ...]:
        """Return a note on the fault, or on a start without a fault."""
        start: Any = self.fault_start
        if self.fault == HEALTHY:
            return () if start is None else (Note("faults.idle_start", "fault_start"),)
        return (Note("faults.present", "fault", fault=self.fault, start="" if start is None else start.display()),)

    def options(self) -> dict[str, str]:
        # The fault is a parameter: one compiled model serves all faults of a valve.
        chosen = {name: choice for name, choice in super().options().items() if name != "fault"}
        return chosen if self.fault == HEALTHY else {**chosen, "fault": "any"}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        of_fault = {"fault_start": 0.0, **dict(_DEFAULTS.values())}
        of_fault |= {name: values.pop(name) for name in of_fault if name in values}
        return values if self.fault == HEALTHY else {**values, "fault_code": fault_code(self.fault), **of_fault}

    def inputs(self) -> tuple[Input, ...]:
        onset = Input("fault", "1", 1.0, low=0.0, high=1.0, delay="fault_start", is_onset=True)
        return super().inputs() if self.fault == HEALTHY else (*super().inputs(), onset)
