"""The way back through the law of a muscle: which pressure gives a force, and which two give a torque at a joint."""

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
from poppet.core.symbolic import clip, maximum
from poppet.parts.fields import NumberLike, number, reference
from poppet.parts.muscle_law import MuscleLawPart
from poppet.parts.part import AMBIENT, Controller, ControlOutputs, Input, Quantities, Scope, Surroundings

LEAST_SLOPE = 1e-7
"""Force per pressure below which a muscle counts as at the end of its way [N/Pa]: no division by zero beyond it."""


@dataclass(frozen=True)
class _Inverse(MuscleLawPart, Controller):
    """What a part shares that turns forces into pressures; without memory, so that it follows its inputs at once."""

    data: Any = reference(doc="library set")
    lowest_pressure: NumberLike = number(
        "Pa", "0 bar g", doc="lowest pressure", kind="pressure", low=0.0, note="vented"
    )
    highest_pressure: NumberLike = number("Pa", doc="highest pressure", kind="pressure", above=0.0)

    pressures: ClassVar[tuple[str, ...]]  # outputs

    def library_sets(self) -> Sequence[Mapping[str, Number]]:
        return [_of_muscle(each) for each in library.every_set("muscle")]

    def library_numbers(self) -> Mapping[str, Number]:
        return {} if self.data is None else _of_muscle(library.numbers(str(self.data), "muscle"))

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        low, high = values["lowest_pressure"], values["highest_pressure"]
        if not ambient.pressure <= low < high:
            raise InputError("muscle.no_range", "lowest_pressure", low=low, high=high, ambient=ambient.pressure)
        return values

    @abstractmethod
    def wanted(self, scope: Scope) -> Quantities:
        """Absolute pressures within the limits, and what else is shown."""

    def control(self, scope: Scope) -> ControlOutputs:
        return ControlOutputs(self.wanted(scope))

    def _limits(self, scope: Scope) -> tuple[Any, Any]:
        """Gauge pressures."""
        ambient = scope.surroundings.pressure
        return scope["lowest_pressure"] - ambient, scope["highest_pressure"] - ambient

    def line_at(self, scope: Scope, contraction: Any) -> tuple[Any, Any]:
        """Force per gauge pressure [N/Pa], and force without it [N], at a contraction."""
        law = self.force_law(scope.numbers)
        return maximum(law.slope(contraction), LEAST_SLOPE), law.passive(contraction)

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        given: Number = self.highest_pressure  # type: ignore[assignment]
        time, found, limit = series("time"), [], given.absolute(float(series(f"{AMBIENT}.pressure")[0]))
        for output in self.pressures:
            held = np.flatnonzero(series(f"{name}.{output}") >= limit * (1.0 - 1e-12))
            if held.size:
                facts = {"time": float(time[held[0]]), "rows": int(held.size), "limit_bar": limit / 1e5}
                found.append(Note("muscle.at_limit", output, **facts))
        return tuple(found)


def _of_muscle(numbers: Mapping[str, Number]) -> dict[str, Number]:
    """Of the set of a muscle: its law, and the pressure that its maker allows."""
    law = {name: value for name, value in numbers.items() if not name.startswith("limits.")}
    highest = numbers.get("limits.highest_pressure")
    return law if highest is None else law | {"highest_pressure": highest}


@dataclass(frozen=True)
class InverseMuscle(_Inverse):
    r"""The pressure at which a muscle pulls with a wanted force.

    .. math:: p = \operatorname{clip}\left(p_a + \frac{F - f_0(\varepsilon)}{f_1(\varepsilon)},
              p_\mathrm{low}, p_\mathrm{high}\right)

    Parameters
    ----------
    force : number
        Wanted pull without a signal [N].

    Notes
    -----
    `data`, `law` and the numbers of the law are given as those of a muscle, and need not be the same: what they differ
    by is the error of a model. `lowest_pressure` and `highest_pressure`, absolute unless marked, hold the result; the
    lowest is not below the ambient pressure, the highest that which the set allows. Inputs are `force` and
    `contraction`, the output `pressure`. Every law is a line over the pressure, so that its inverse is exact, with
    hysteresis and damping left out. A force below zero, which no muscle has, asks for less than the pressure at which
    it hangs loose.

    Examples
    --------
    >>> inverse = InverseMuscle(data="dmsp_20_300")
    >>> round(inverse.pressure_for(595.0, 0.1), -3)
    500000.0
    """

    kind: ClassVar[str] = "inverse_muscle"
    summary: ClassVar[str] = "the pressure at which a muscle pulls with a wanted force"
    measured: ClassVar[tuple[str, ...]] = ("contraction",)
    pressures: ClassVar[tuple[str, ...]] = ("pressure",)

    force: NumberLike = number("N", 0.0, doc="wanted force", note="none by default")

    def inputs(self) -> tuple[Input, ...]:
        return Input("force", "N", "force"), Input("contraction", "1", 0.0)

    def wanted(self, scope: Scope) -> Quantities:
        slope, passive = self.line_at(scope, scope.inputs["contraction"])
        gauge = clip((scope.inputs["force"] - passive) / slope, *self._limits(scope))
        return {"pressure": (scope.surroundings.pressure + gauge, "Pa")}


@dataclass(frozen=True)
class Antagonist(_Inverse):
    r"""The pressures of two equal muscles at a joint that give a torque, about a mean pressure.

    .. math:: M = r \left(F_f - F_e\right), \qquad \tfrac12 (p_f + p_e) = \bar p

    Parameters
    ----------
    pulley_radius : number
        Radius r on which both pull [m].
    torque : number
        Wanted torque without a signal, towards larger angles [N m].
    mean_pressure : number
        Wanted mean of the two pressures without a signal [Pa]: the higher, the stiffer the joint.

    Notes
    -----
    The flexor pulls towards larger angles, the extensor towards smaller ones. `data`, `law`, the numbers of the law and
    the limits of the pressures are given as those of `inverse_muscle`. Inputs are `torque`, `mean_pressure`,
    `flexor_contraction` and `extensor_contraction`, outputs `flexor_pressure`, `extensor_pressure` and `given_torque`,
    what the law makes of the two. Both equations are linear in the pressures. A muscle keeps the pressure at which it
    is just taut, as long as that is below the mean. Where a limit of one muscle is met the other gives the torque as
    far as it can, and the mean becomes another one: the torque counts more.

    Examples
    --------
    >>> pair = Antagonist(data="dmsp_20_300", pulley_radius="25 mm", lowest_pressure="0.3 bar g")
    >>> print(pair.highest_pressure)
    600000 Pa g
    """

    kind: ClassVar[str] = "antagonist"
    summary: ClassVar[str] = "the pressures of two muscles at a joint that give a torque about a mean pressure"
    measured: ClassVar[tuple[str, ...]] = ("flexor_contraction", "extensor_contraction")
    pressures: ClassVar[tuple[str, ...]] = ("flexor_pressure", "extensor_pressure")

    pulley_radius: NumberLike = number("m", doc="pulley radius", above=0.0)
    torque: NumberLike = number("N m", 0.0, doc="wanted torque", note="none by default")
    mean_pressure: NumberLike = number("Pa", "2 bar g", doc="wanted mean pressure", kind="pressure", low=0.0)

    def inputs(self) -> tuple[Input, ...]:
        return (
            Input("torque", "N m", "torque"),
            Input("mean_pressure", "Pa", "mean_pressure", kind="pressure", low=0.0),
            *(Input(name, "1", 0.0) for name in self.measured),
        )

    def wanted(self, scope: Scope) -> Quantities:
        ambient, low, high = scope.surroundings.pressure, *self._limits(scope)
        pull = scope.inputs["torque"] / scope["pulley_radius"]
        mean = scope.inputs["mean_pressure"] - ambient
        (slope, passive), (against, resting) = (self.line_at(scope, scope.inputs[name]) for name in self.measured)
        half = (pull - mean * (slope - against) - passive + resting) / (slope + against)
        # Neither is let loose, as far as the mean pressure keeps it taut.
        lines = ((slope, passive), (against, resting))
        least = [clip(-each / per_pressure, low, maximum(mean, low)) for per_pressure, each in lines]
        # What one muscle cannot do at its limit the other makes up for.
        pulled = maximum(clip(mean + half, least[0], high) * slope + passive, 0.0)
        yielded = maximum(clip(mean - half, least[1], high) * against + resting, 0.0)
        flexor = clip((yielded + pull - passive) / slope, least[0], high)
        extensor = clip((pulled - pull - resting) / against, least[1], high)
        given = maximum(flexor * slope + passive, 0.0) - maximum(extensor * against + resting, 0.0)
        return {
            "flexor_pressure": (ambient + flexor, "Pa"),
            "extensor_pressure": (ambient + extensor, "Pa"),
            "given_torque": (scope["pulley_radius"] * given, "N m"),
        }
