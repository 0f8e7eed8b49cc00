"""Switches with hysteresis: pressure switches, reed switches and other two-position sensors."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.errors import InputError, OutOfRangeError
from poppet.core.provenance import Number
from poppet.core.symbolic import is_certain, where
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.conditions import KIND_OF_UNIT, read_literal
from poppet.parts.electronics import MIN_SAMPLE_TIME
from poppet.parts.fields import NumberLike, number, option, reference
from poppet.parts.part import (
    Controller,
    ControlOutputs,
    DiscreteState,
    Input,
    PartConnection,
    Scope,
    Surroundings,
    Timer,
    advance_clock,
)
from poppet.parts.quantities import QUANTITIES

LIMITS = ("on_above", "off_below", "on_below", "off_above")
UNITS = "by_unit"
"""Choice of the option `quantity` with which the units of the limits select the quantity."""


def limit_properties(part: Any) -> dict[str, Any]:
    """Return the unit of the limits of a switch, and the kind of their quantity.

    Without the option `quantity`, they follow from the first limit with a unit.
    """
    name = getattr(part, "quantity", UNITS)
    if name in QUANTITIES:
        return {"unit": QUANTITIES[name].unit, "kind": QUANTITIES[name].kind}
    unit = "1"
    for limit in (getattr(part, name) for name in LIMITS):
        value = limit.get("value") if isinstance(limit, dict) else limit
        if isinstance(value, Number) and value.unit != "1":
            unit = value.unit
            break
        if isinstance(value, str):
            try:
                unit = read_literal(value)[0].unit
            except InputError:
                continue  # the field itself reports an invalid text
            if unit != "1":
                break
    return {"unit": unit, "kind": KIND_OF_UNIT.get(unit, "plain")}


def _limit(doc: str) -> NumberLike:
    return number("1", optional=True, doc=doc, varies=limit_properties)


@dataclass(frozen=True)
class Switch(Controller):
    r"""Sampled switch with hysteresis, for example a pressure switch or a reed switch at a cylinder.

    .. math:: s_k = \begin{cases}1 & y_k > y_\mathrm{on}\\ 0 & y_k < y_\mathrm{off}\\ s_{k-1} & \text{otherwise}
              \end{cases}

    This applies with `on_above` and `off_below`. With `on_below` and `off_above`, both relations are reversed.

    Notes
    -----
    The output `state` is 0 or 1. The input `measurement` is connected to the output whose address is the field
    `measurement`, or in the table `[connections]`. The written units of the limits select its quantity. Limits without
    a unit are dimensionless, unless `quantity` names a quantity. At an instant, switches and sequences read the values
    before the instant.
    """

    kind: ClassVar[str] = "switch"
    symbol: ClassVar[symbols.Symbol | str] = symbols.SWITCH
    summary: ClassVar[str] = "sampled switch with hysteresis: pressure switch, reed switch"
    is_switching: ClassVar[bool] = True
    measured: ClassVar[tuple[str, ...]] = ("measurement",)
    resume: ClassVar[dict[str, str]] = {"state": "initial_state"}
    internal_outputs: ClassVar[tuple[str, ...]] = ("measurement",)

    measurement: Any = reference(doc="address of the measured output", form="str")
    on_above: NumberLike = _limit("value above which the switch turns on")
    off_below: NumberLike = _limit("value below which the switch turns off")
    on_below: NumberLike = _limit("value below which the switch turns on")
    off_above: NumberLike = _limit("value above which the switch turns off")
    quantity: str = option(UNITS, *QUANTITIES, doc="measured quantity")
    sample_time: NumberLike = number("s", "1 ms", doc="sample time", low=MIN_SAMPLE_TIME)
    initial_state: NumberLike = number("1", 0.0, doc="state before the first sample", low=0.0, high=1.0, note="off")

    @property
    def limits(self) -> tuple[str, str]:
        """Names of the fields with the limit to turn on and the limit to turn off."""
        return ("on_above", "off_below") if self.on_above is not None else ("on_below", "off_above")

    @property
    def unit(self) -> str:
        """SI unit of the measured quantity."""
        unit: str = limit_properties(self)["unit"]
        return unit

    def check(self) -> None:
        given = [name for name in LIMITS if getattr(self, name) is not None]
        if given not in (["on_above", "off_below"], ["on_below", "off_above"]):
            raise InputError("switch.limits", given[0] if given else "on_above", given=given)
        if self.measurement is not None and not isinstance(self.measurement, str):
            raise InputError("fields.not_a_name", "measurement", value=self.measurement)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        on, off = self.limits
        return ["switch", *(f"{name.replace('_', ' ')} {numbers.text(getattr(self, name))}" for name in (on, off))]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        on, off = self.limits
        if is_certain(values[on] <= values[off] if on == "on_above" else values[on] >= values[off]):
            texts = [getattr(self, name).display() for name in (on, off)]
            raise OutOfRangeError("switch.contradictory", on, shown=texts[0], off=off, limit=texts[1])
        # Without a connection it measures the ambient.
        defaults = {"Pa": ambient.pressure, "K": ambient.temperature}
        return values | {"measurement": defaults.get(self.unit, 0.0)}

    def ascending_parameters(self) -> tuple[tuple[str, str], ...]:
        on, off = self.limits
        return ((off, on) if on == "on_above" else (on, off),)

    def structure(self) -> Hashable:
        return super().structure(), self.unit, self.limits

    def connections(self) -> dict[str, PartConnection]:
        return {} if self.measurement is None else {"measurement": PartConnection(self.measurement, "measurement")}

    @classmethod
    def stated_connections(cls, table: Mapping[str, Any]) -> dict[str, tuple[PartConnection, str]]:
        address = table.get("measurement")
        # The unit of an invalid switch is not known.
        return {"measurement": (PartConnection(address, "measurement"), "")} if isinstance(address, str) else {}

    def inputs(self) -> tuple[Input, ...]:
        return (Input("measurement", self.unit, "measurement", kind=KIND_OF_UNIT.get(self.unit, "plain")),)

    def memory(self) -> tuple[DiscreteState, ...]:
        return DiscreteState("state", "1"), DiscreteState("sample_count", "1")

    def timers(self) -> tuple[Timer, ...]:
        return (Timer("sample", rank=-1, is_simultaneous=True),)

    def flags(self) -> tuple[str, ...]:
        return ("state",)

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return {"state": (0.0, 1.0)}

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"state": where(scope["initial_state"] > 0.5, 1.0, 0.0), "sample": 0.0, "sample_count": 0.0}

    def control(self, scope: Scope) -> ControlOutputs:
        return ControlOutputs({"state": (scope.memory["state"], "1")})

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        on, off = self.limits
        measured, state = scope.inputs["measurement"], scope.memory["state"]
        if on == "on_above":
            state = where(measured > scope[on], 1.0, where(measured < scope[off], 0.0, state))
        else:
            state = where(measured < scope[on], 1.0, where(measured > scope[off], 0.0, state))
        return {"state": state} | advance_clock(scope, timer, scope["sample_time"])
