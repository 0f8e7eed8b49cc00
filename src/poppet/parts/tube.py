"""Tube: a series of gas cells with pressure losses between them, optionally with gas inertia."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, ClassVar

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import is_symbolic, maximum, sqrt
from poppet.laws import iso6358
from poppet.laws.physics import gas as gas_law
from poppet.laws.physics import pipe
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.chamber import Chamber
from poppet.parts.compound import Compound
from poppet.parts.fields import (
    NumberLike,
    NumberSpec,
    anr_pressure,
    anr_temperature,
    laminar_limit,
    model,
    number,
    option,
    port,
    read_number,
    reference,
    subsonic_index_m,
    switch,
    unknown_field,
)
from poppet.parts.flow_path import iso_flow
from poppet.parts.part import TUBE, Flow, GasState, Part, Passage, PassageFlows, Scope, State, Surroundings, is_port

ISO, FRICTION = "iso6358", "friction"
MAX_CELLS = 200
AT_PORT, AT_NODE, CLOSED = "met", "made", "closed"
"""End of a tube: at a port of another part, connected to a gas node by half a cell, or closed."""
_CELL = ("pressure", "temperature", "mass", "heat_flow_rate")
_START = {
    "pressure": NumberSpec("Pa", "pressure of a cell at the start", kind="pressure", above=0.0),
    "temperature": NumberSpec("K", "temperature of a cell at the start", kind="temperature", above=0.0),
    "mass_flow_rate": NumberSpec("kg/s", "mass flow rate at the start", kind="mass_flow"),
}


@dataclass(frozen=True)
class TubeSegment(Passage):
    """Flow path between neighbouring cells of a tube, or between an end cell and a gas node.

    It is a member part of `Tube`.
    """

    kind: ClassVar[str] = "tube_segment"
    summary: ClassVar[str] = "a piece of a tube"

    from_: str | None = port("cell or gas node at the first end")
    to: str | None = port("cell or gas node at the second end")
    loss: str = option(ISO, FRICTION, doc="law of the pressure loss")
    inertia: str = switch(doc="inertia of the gas")
    length: NumberLike = number("m", doc="length", above=0.0)
    bore: NumberLike = number("m", doc="bore", above=0.0)
    sonic_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="sonic conductance C", above=0.0)
    critical_ratio: NumberLike = number("1", 0.0, doc="critical ratio b", low=0.0, below=1.0)
    viscosity: NumberLike = number("Pa s", doc="dynamic viscosity", above=0.0)
    roughness: NumberLike = number("m", doc="roughness", low=0.0)
    initial_mass_flow_rate: NumberLike = number("kg/s", 0.0, doc="mass flow rate at the start")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if self.loss == FRICTION:  # the choked flow is that of the cross-section
            gas = {"isentropic_exponent": ambient.isentropic_exponent, "gas_constant": ambient.gas_constant}
            nozzle = iso6358.conductance_from_effective_area(0.25 * math.pi * values["bore"] ** 2, **gas)
            values["sonic_conductance"], _ = ambient.capacity_as_stated(nozzle.sonic_conductance, 0.0)
        return values

    def states(self) -> tuple[State, ...]:
        return (State("mass_flow_rate", "kg/s", 1e-3),) if self.inertia == "true" else ()

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"mass_flow_rate": scope["initial_mass_flow_rate"]} if self.inertia == "true" else {}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        size = scope["sonic_conductance"], scope["critical_ratio"]
        first, second = gas["from"], gas["to"]
        if self.inertia != "true":
            flow, outputs = iso_flow(scope, "mass_flow_rate", ("from", "to"), (first, second), size)
            return PassageFlows((flow,), outputs)
        mass, surroundings = scope.states["mass_flow_rate"], scope.surroundings
        pressures = first.pressure, second.pressure
        conductance, ratio = surroundings.capacity_in_circuit_gas(*size)
        # Times the square root of the temperature, which follows.
        sonic = conductance * iso6358.REFERENCE_DENSITY * sqrt(iso6358.REFERENCE_TEMPERATURE) * maximum(*pressures)
        temperature = iso6358.temperature_of_flow(
            mass, sonic / sqrt(first.temperature), first.temperature, second.temperature
        )
        choked = sonic / sqrt(temperature)
        density = gas_law.density(0.5 * (first.pressure + second.pressure), temperature, surroundings.gas_constant)
        tube = scope["length"], scope["bore"], density, scope["viscosity"]
        if self.loss == ISO:
            coefficient = iso6358.loss_coefficient(*pressures, choked, ratio)
        else:
            # The pressure difference cannot sustain a flow above the choked one.
            smallest = abs(first.pressure - second.pressure) / choked**2
            coefficient = maximum(pipe.darcy_coefficient(mass, *tube, scope["roughness"]), smallest)
        reynolds = pipe.reynolds_number(mass, scope["bore"], scope["viscosity"])
        laminar, turbulent = pipe.laminar_resistance(*tube) * mass, coefficient * mass * abs(mass)
        loss = pipe.between_laminar_and_turbulent(reynolds, laminar, turbulent)
        area = 0.25 * math.pi * scope["bore"] ** 2
        rate = area / scope["length"] * (first.pressure - second.pressure - loss)
        flow = Flow("mass_flow_rate", "from", "to", mass, surroundings.heat_capacity_pressure * temperature * mass)
        return PassageFlows((flow,), {"mass_flow_rate": (mass, "kg/s")}, {"mass_flow_rate": rate})


def _computed(value: Any, unit: str) -> Any:
    """Return a computed value of a member. A symbol becomes a number with the SI unit `unit`."""
    return Number(value, unit, Source("given")) if is_symbolic(value) else value


@dataclass(frozen=True)
class Profile:
    """Initial states of all cells and flow paths of a tube.

    `specified` contains the states that a user set, and `defaults` the initial values of the tube for all states.
    """

    specified: Mapping[str, Number]
    defaults: Mapping[str, Number]

    def numbers(self) -> dict[str, Number]:
        """Return all initial states by name and cell number, for example `pressure_3`."""
        return {**self.defaults, **self.specified}

    def with_numbers(self, values: Mapping[str, Number]) -> Profile:
        """Return a copy of the profile in which some initial states are replaced."""
        return Profile({**self.specified, **values}, self.defaults)


@dataclass(frozen=True)
class Tube(Compound):
    r"""Tube or hose: a row of cells with pressure losses and heat transfer, optionally with inertia of the gas.

    .. math:: \frac{V \dot p}{\kappa - 1} = \sum c_p T q + h A (T_w - T), \qquad
              \frac{L}{A} \dot q = p_1 - p_2 - \Delta p(q) \quad \text{(with inertia)}

    Notes
    -----
    See docs/tube.md. Each end (`from_` and `to`) is the name of a gas node, such as `tank`, or a port of another part,
    such as `valve.outlet`. This port must name the tube, and is connected to the cell at that end. If `to` is omitted,
    the second end is closed. Ports of other parts can be connected to any cell, for example `hose.3`.

    If `inertia` is true, the mass flow rates are states, and pressure waves travel in the tube. The default C and b are
    those of `poppet.iso6358.tube`. The loss `friction`, by Darcy-Weisbach with a roughness, requires inertia. The loss
    of a tube with inertia is laminar up to Re = 2000. Its flow does not exceed the choked flow, and the model neglects
    kinetic energy. A run that continues another run starts with the `profile` at the end of that run.

    Examples
    --------
    >>> hose = Tube(from_="valve.outlet", to="tank", length="2 m", bore="4 mm", cells=4, inertia=True)
    >>> hose.stores()
    ('1', '2', '3', '4')
    >>> [*hose.members][4:]
    ['1_to_2', '2_to_3', '3_to_4', 'outlet']
    """

    kind: ClassVar[str] = TUBE
    symbol: ClassVar[symbols.Symbol | str] = symbols.TUBE
    summary: ClassVar[str] = "a tube: cells with pressure loss, heat transfer and, optionally, inertia of the gas"

    from_: str | None = port("gas node at the first end, or port that names the tube")
    to: str | None = port("gas node at the second end, or port that names the tube; closed without it", optional=True)
    length: NumberLike = number("m", doc="length", above=0.0)
    bore: NumberLike = number("m", doc="bore", above=0.0)
    cells: NumberLike = number("1", 8.0, doc="number of cells", low=1.0, high=float(MAX_CELLS))
    inertia: str = switch(doc="inertia of the gas")
    loss: str = option(ISO, FRICTION, doc="law of the pressure loss")
    sonic_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="sonic conductance C", above=0.0)
    critical_ratio: NumberLike = number("1", optional=True, doc="critical ratio b of the tube", low=0.0, below=1.0)
    roughness: NumberLike = number("m", 0.0, doc="height of the wall's roughness", low=0.0, note="smooth")
    viscosity: NumberLike = number(
        "Pa s", pipe.AIR_VISCOSITY_ANR, doc="dynamic viscosity", above=0.0, source="paper", note="air at 20 degC, White"
    )
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")
    model: Any = model()
    profile: Any = reference(doc="initial states of single cells; mapping such as pressure_3")

    def check(self) -> None:
        count = self._value("cells")
        with ErrorCollector() as errors:
            if count != int(count):
                errors.add("tube.cells", "cells", value=count)
            elif count == 1.0 and self._ends == (AT_PORT, AT_PORT):
                errors.add("tube.one_cell", "cells", ends=[self.from_, self.to])
            if self.loss == FRICTION and self.inertia != "true":
                errors.add("tube.friction_without_inertia", "loss")
        table = self.profile.specified if isinstance(self.profile, Profile) else self.profile or {}
        if not isinstance(table, Mapping):
            raise InputError("fields.no_table", "profile", value=table)
        defaults: dict[str, Any] = {}
        for k in range(1, self._count + 1):
            defaults |= {f"pressure_{k}": self.initial_pressure, f"temperature_{k}": self.initial_temperature}
        at_rest = Number(0.0, "kg/s", Source("assumed", note="at rest"))
        for name in self._open_passages if self.inertia == "true" else ():
            defaults[f"mass_flow_rate_{self._cell_index(name)}"] = at_rest
        with ErrorCollector() as errors:
            errors.extend(unknown_field(f"profile.{key}", key, defaults) for key in table if key not in defaults)
            numbers = {}
            for key in (key for key in table if key in defaults):
                with errors.collecting():
                    numbers[key] = read_number(f"profile.{key}", _START[key.rpartition("_")[0]], table[key])
        object.__setattr__(self, "profile", Profile(numbers, defaults))

    @property
    def _count(self) -> int:
        return int(self._value("cells"))

    @property
    def _ends(self) -> tuple[str, str]:
        """Types of both ends: `AT_PORT` of another part, `AT_NODE` for a gas node, or `CLOSED`."""
        first, second = (
            CLOSED if end is None else AT_PORT if is_port(end) else AT_NODE for end in (self.from_, self.to)
        )
        return first, second

    def outer_ports(self) -> dict[str, str]:
        cells = {self.from_: "1", self.to: str(self._count)}
        return {end: cell for end, cell in cells.items() if end is not None and is_port(end)}

    # Members -----------------------------------------------------------------------------------------------------

    @property
    def _spacing(self) -> float:
        """Distance between neighbouring cells, divided by the length of the tube.

        A cell at a port of another part has half the length of the other cells.
        """
        return 1.0 / (self._count - sum(0.5 for end in self._ends if end == AT_PORT))

    @cached_property
    def _passages(self) -> dict[str, tuple[str, str, float]]:
        """Mapping from the name of each flow path in the tube to its two ends and its length.

        The length is relative to the spacing of the cells. A closed end is included with a length of 0.5.
        """
        names = [str(k) for k in range(1, self._count + 1)]
        paths = {} if self._ends[0] == AT_PORT else {"inlet": (str(self.from_), f".{names[0]}", 0.5)}
        for first, second in pairwise(names):
            paths[f"{first}_to_{second}"] = f".{first}", f".{second}", 1.0
        return paths if self._ends[1] == AT_PORT else {**paths, "outlet": (f".{names[-1]}", str(self.to), 0.5)}

    @property
    def _open_passages(self) -> list[str]:
        """Names of all flow paths in the tube, except one at a closed end."""
        return [name for name in self._passages if name != "outlet" or self._ends[1] != CLOSED]

    def _cell_index(self, passage: str) -> str:
        """Return the number of the cell before a flow path, as text.

        The number is 0 for the first flow path, `inlet`.
        """
        return {"inlet": "0", "outlet": str(self._count)}.get(passage) or passage.partition("_")[0]

    def _value(self, name: str) -> Any:
        """Return a number of the tube in SI units, as a float or symbol."""
        return getattr(self, name).value

    @cached_property
    def members(self) -> dict[str, Part]:
        """Mapping from names to members: first the cells by index, then the flow paths."""
        start, conductance = self.profile.numbers(), self._value("wall_conductance")
        volume = 0.25 * math.pi * self._value("bore") ** 2 * self._value("length")
        cells: dict[str, Part] = {}
        for k in range(1, self._count + 1):
            port_ends = (k == 1 and self._ends[0] == AT_PORT) + (k == self._count and self._ends[1] == AT_PORT)
            fraction = self._spacing * (1.0 - 0.5 * port_ends)
            cells[str(k)] = Chamber(
                volume=_computed(volume * fraction, "m^3"),
                wall_conductance=_computed(conductance * fraction, "W/K"),
                wall_temperature=self.wall_temperature,
                initial_pressure=start[f"pressure_{k}"],
                initial_temperature=start[f"temperature_{k}"],
            )
        segments: dict[str, Part] = {}
        weights = [weight for *_, weight in self._passages.values()]
        sizes = iso6358.divided(*self._size, weights) if self.loss == ISO else [(None, 0.0)] * len(weights)
        for name, (sonic_conductance, ratio) in zip(self._passages, sizes, strict=True):
            first, second, weight = self._passages[name]
            flow = start.get(f"mass_flow_rate_{self._cell_index(name)}")
            if name in self._open_passages:
                segments[name] = TubeSegment(
                    first, second, self.loss, self.inertia,
                    _computed(self._value("length") * self._spacing * weight, "m"), self.bore,
                    _computed(sonic_conductance, "m^3/(s Pa)"), _computed(ratio, "1"),
                    self.viscosity, self.roughness, flow,
                    laminar_ratio=1.0 - 1e-3 * weight * self._spacing,  # the default one for the whole tube
                )  # fmt: skip
        return cells | segments

    @property
    def _size(self) -> tuple[Any, Any]:
        """Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the whole tube.

        Values that are not specified follow from `poppet.iso6358.tube`.
        """
        conductance, ratio = iso6358.tube(self._value("length"), self._value("bore"))
        return (
            conductance if self.sonic_conductance is None else self._value("sonic_conductance"),
            ratio if self.critical_ratio is None else self._value("critical_ratio"),
        )

    # Interface to circuits ------------------------------------------------------------------------------------------

    def stores(self) -> tuple[str, ...]:
        return tuple(str(k) for k in range(1, self._count + 1))

    def outside(self) -> dict[str, str]:
        flows = {self._cell_index(name): name for name in self._open_passages}
        names = {"mass_flow_rate": "inlet.mass_flow_rate"} if "0" in flows else {}
        for cell in self.stores():
            names |= {f"{cell}.{name}": f"{cell}.{name}" for name in _CELL}
            if cell in flows:
                names[f"{cell}.mass_flow_rate"] = f"{flows[cell]}.mass_flow_rate"
        return names

    @property
    def resume(self) -> dict[str, str]:  # type: ignore[override]
        """Mapping from each output that a run can continue from to the field of its initial value.

        The outputs are pressure and temperature of the cells, and the mass flow rates if the gas has inertia.
        """
        targets = {}
        for key in self.profile.numbers():
            name, _, index = key.rpartition("_")
            targets[name if index == "0" else f"{index}.{name}"] = f"profile.{key}"
        return targets

    def can_resume(self, target: str) -> bool:
        return True

    def numbers(self) -> dict[str, Number]:
        numbers = {name: value for name, value in Part.numbers(self).items() if name != "cells"}
        return numbers | {f"profile.{key}": value for key, value in self.profile.specified.items()}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        Part.parameters(self, ambient)  # reports a gauge value below vacuum at the address of the tube
        return super().parameters(ambient)

    def options(self) -> dict[str, str]:
        return {**super().options(), "cells": str(self._count)}

    def notes(self) -> tuple[Note, ...]:
        unused = ("sonic_conductance", "critical_ratio") if self.loss == FRICTION else ("roughness",)
        specified = [name for name in unused if getattr(self, name) is not None and self._value(name) > 0.0]
        return (Note("tube.no_effect", specified[0], loss=self.loss),) if specified else ()

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        waves = "with waves" if self.inertia == "true" else "no waves"
        length: Any = self.length
        return [f"{length.display()}, bore {numbers.text(self.bore)}", f"{self._count} cells, {waves}"]
