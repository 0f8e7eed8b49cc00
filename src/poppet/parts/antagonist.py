"""Controllers that invert the force law of a muscle: one pressure for a force, or two for a torque."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from poppet import library
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.core.symbolic import clip, is_certain, maximum
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, number, reference
from poppet.parts.muscle_law import MuscleLawPart
from poppet.parts.part import AMBIENT, Controller, ControlOutputs, Input, Quantities, Scope, Surroundings

MIN_SLOPE = 1e-7
"""Lower bound of the force per pressure [N/Pa], which avoids a division by zero at the end of the stroke."""


@dataclass(frozen=True)
class _InverseMuscleLaw(MuscleLawPart, Controller):
    """Base class of controllers that invert the force law of a muscle.

    The law gives the pressure for a required force. The pressure is then limited to the permitted range.
    """

    data: Any = reference(doc="name of a parameter set of the library")
    lowest_pressure: NumberLike = number(
        "Pa", "0 bar g", doc="lowest pressure", kind="pressure", low=0.0, note="vented"
    )
    highest_pressure: NumberLike = number("Pa", doc="highest pressure", kind="pressure", above=0.0)

    pressures: ClassVar[tuple[str, ...]]  # names of the outputs with pressures

    def library_sets(self) -> Sequence[Mapping[str, Number]]:
        return [_law_numbers(numbers) for numbers in library.every_set("muscle")]

    def library_numbers(self) -> Mapping[str, Number]:
        return {} if self.data is None else _law_numbers(library.numbers(str(self.data), "muscle"))

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        low, high = values["lowest_pressure"], values["highest_pressure"]
        if is_certain(low < ambient.pressure) or is_certain(low >= high):
            raise InputError("muscle.no_range", "lowest_pressure", low=low, high=high, ambient=ambient.pressure)
        return values

    def ascending_parameters(self) -> tuple[tuple[str, str], ...]:
        return (("lowest_pressure", "highest_pressure"),)

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return dict.fromkeys(self.pressures, ("lowest_pressure", "highest_pressure"))

    @abstractmethod
    def compute_outputs(self, scope: Scope) -> Quantities:
        """Return the outputs of the controller by name, each with its unit.

        The pressures of the muscles are absolute, and within the limits of the controller.
        """

    def control(self, scope: Scope) -> ControlOutputs:
        return ControlOutputs(self.compute_outputs(scope))

    def _limits(self, scope: Scope) -> tuple[Any, Any]:
        """Return the lowest and the highest pressure of the controller as gauge pressures [Pa]."""
        ambient = scope.surroundings.pressure
        return scope["lowest_pressure"] - ambient, scope["highest_pressure"] - ambient

    def line_at(self, scope: Scope, contraction: Any) -> tuple[Any, Any]:
        """Return slope and offset of the muscle force, a linear function of the gauge pressure.

        The slope [N/Pa] and the offset, the force at zero gauge pressure [N], are valid at the given contraction. The
        slope is at least `MIN_SLOPE`.
        """
        law = self.force_law(scope.numbers)
        return maximum(law.slope(contraction), MIN_SLOPE), law.passive(contraction)

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        highest: Number = self.highest_pressure  # type: ignore[assignment]
        time, notes, limit = series("time"), [], highest.absolute(float(series(f"{AMBIENT}.pressure")[0]))
        for output in self.pressures:
            rows = np.flatnonzero(series(f"{name}.{output}") >= limit * (1.0 - 1e-12))
            if rows.size:
                facts = {"time": float(time[rows[0]]), "rows": int(rows.size), "limit_bar": limit / 1e5}
                notes.append(Note("muscle.at_limit", output, **facts))
        return tuple(notes)


def _law_numbers(numbers: Mapping[str, Number]) -> dict[str, Number]:
    """Return the parameters of the force law from a published parameter set.

    `numbers` contains the parameters of the set by dotted name. The result also contains `highest_pressure` if the set
    contains the permitted pressure.
    """
    law = {name: value for name, value in numbers.items() if not name.startswith("limits.")}
    highest = numbers.get("limits.highest_pressure")
    return law if highest is None else law | {"highest_pressure": highest}


@dataclass(frozen=True)
class InverseMuscle(_InverseMuscleLaw):
    r"""Controller that returns the pressure at which a muscle exerts a setpoint force.

    .. math:: p = \operatorname{clip}\left(p_a + \frac{F - f_0(\varepsilon)}{f_1(\varepsilon)},
              p_\mathrm{low}, p_\mathrm{high}\right)

    Here F is the setpoint force, :math:`\varepsilon` the contraction, :math:`f_0` the force at zero gauge pressure,
    :math:`f_1` the force per gauge pressure, and :math:`p_a` the ambient pressure.

    Notes
    -----
    `data` (a published parameter set), `law` and the parameters of the law describe the muscle that the controller
    assumes. They can differ from those of the muscle in the circuit, to study the effect of model errors.
    `lowest_pressure` and `highest_pressure` limit the output; the default of `highest_pressure` is the permitted
    pressure in the parameter set. Inputs are `force` [N] and `contraction` [1], the output is `pressure` [Pa]. Every
    law is linear in the pressure, so the inverse is exact, but it neglects hysteresis and damping. For a negative
    force, the output is a pressure at which the muscle is slack.

    Examples
    --------
    >>> inverse = InverseMuscle(data="dmsp_20_300")
    >>> round(inverse.pressure_for(595.0, 0.1), -3)
    500000.0
    """

    kind: ClassVar[str] = "inverse_muscle"
    symbol: ClassVar[symbols.Symbol | str] = symbols.INVERSE_MUSCLE
    summary: ClassVar[str] = "the pressure at which a muscle exerts a setpoint force"
    measured: ClassVar[tuple[str, ...]] = ("contraction",)
    pressures: ClassVar[tuple[str, ...]] = ("pressure",)

    force: NumberLike = number("N", 0.0, doc="setpoint force without a signal", note="none by default")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [f"force to pressure, {self.data or self.law}"]

    def inputs(self) -> tuple[Input, ...]:
        return Input("force", "N", "force", is_command=True), Input("contraction", "1", 0.0, low=-1.0, high=1.0)

    def compute_outputs(self, scope: Scope) -> Quantities:
        slope, passive = self.line_at(scope, scope.inputs["contraction"])
        gauge = clip((scope.inputs["force"] - passive) / slope, *self._limits(scope))
        return {"pressure": (scope.surroundings.pressure + gauge, "Pa")}


@dataclass(frozen=True)
class Antagonist(_InverseMuscleLaw):
    r"""Controller of two equal muscles at a joint: pressures for a torque and a mean pressure.

    .. math:: M = r \left(F_f - F_e\right), \qquad \tfrac12 (p_f + p_e) = \bar p

    Here M is the setpoint torque, r the pulley radius, :math:`\bar p` the setpoint mean pressure, and F and p are force
    and pressure of the flexor (f) and the extensor (e).

    Notes
    -----
    The flexor pulls towards larger angles, the extensor towards smaller ones; a higher mean pressure makes the joint
    stiffer. `data`, `law`, the parameters of the law and the limits of the pressures have the meaning as in
    `InverseMuscle`. Inputs are `torque`, `mean_pressure`, `flexor_contraction` and `extensor_contraction`. Outputs are
    `flexor_pressure`, `extensor_pressure` and `given_torque`, the torque that the force law gives for both pressures.

    The pressure of each muscle is at least the pressure at which the muscle is taut, if this pressure is below the mean
    pressure. If one muscle is at a limit, the other one provides the torque within its own limits, and the mean
    pressure changes: torque has priority over the mean pressure.

    Examples
    --------
    >>> pair = Antagonist(data="dmsp_20_300", pulley_radius="25 mm", lowest_pressure="0.3 bar g")
    >>> print(pair.highest_pressure)
    600000 Pa g
    """

    kind: ClassVar[str] = "antagonist"
    symbol: ClassVar[symbols.Symbol | str] = symbols.ANTAGONIST
    summary: ClassVar[str] = "the pressures of two muscles at a joint for a torque and a mean pressure"
    measured: ClassVar[tuple[str, ...]] = ("flexor_contraction", "extensor_contraction")
    pressures: ClassVar[tuple[str, ...]] = ("flexor_pressure", "extensor_pressure")

    pulley_radius: NumberLike = number("m", doc="pulley radius of both muscles", above=0.0)
    torque: NumberLike = number("N m", 0.0, doc="setpoint torque, towards larger angles", note="none by default")
    mean_pressure: NumberLike = number("Pa", "2 bar g", doc="setpoint mean pressure", kind="pressure", low=0.0)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return [f"torque to two pressures, {self.data or self.law}", f"pulley {numbers.text(self.pulley_radius)}"]

    def inputs(self) -> tuple[Input, ...]:
        mean_pressure = Input("mean_pressure", "Pa", "mean_pressure", kind="pressure", low=0.0)
        return (
            Input("torque", "N m", "torque", is_command=True),
            mean_pressure,
            *(Input(name, "1", 0.0, low=-1.0, high=1.0) for name in self.measured),
        )

    def compute_outputs(self, scope: Scope) -> Quantities:
        ambient, low, high = scope.surroundings.pressure, *self._limits(scope)
        pull = scope.inputs["torque"] / scope["pulley_radius"]
        mean = scope.inputs["mean_pressure"] - ambient
        (slope_f, passive_f), (slope_e, passive_e) = (self.line_at(scope, scope.inputs[k]) for k in self.measured)
        half = (pull - mean * (slope_f - slope_e) - passive_f + passive_e) / (slope_f + slope_e)
        # Each muscle remains taut if the mean pressure permits it.
        lowest_f, lowest_e = (
            clip(-passive / slope, low, maximum(mean, low))
            for slope, passive in ((slope_f, passive_f), (slope_e, passive_e))
        )
        # The other muscle compensates for a muscle at its limit.
        force_f = maximum(clip(mean + half, lowest_f, high) * slope_f + passive_f, 0.0)
        force_e = maximum(clip(mean - half, lowest_e, high) * slope_e + passive_e, 0.0)
        flexor = clip((force_e + pull - passive_f) / slope_f, lowest_f, high)
        extensor = clip((force_f - pull - passive_e) / slope_e, lowest_e, high)
        difference = maximum(flexor * slope_f + passive_f, 0.0) - maximum(extensor * slope_e + passive_e, 0.0)
        return {
            "flexor_pressure": (ambient + flexor, "Pa"),
            "extensor_pressure": (ambient + extensor, "Pa"),
            "given_torque": (scope["pulley_radius"] * difference, "N m"),
        }
