"""A tube: a row of cells with loss between them, and by option the inertia of the gas."""

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
from poppet.core.symbolic import maximum, sqrt
from poppet.laws import iso6358
from poppet.laws.physics import gas as gas_law
from poppet.laws.physics import pipe
from poppet.parts.chamber import Chamber
from poppet.parts.compound import Compound
from poppet.parts.fields import (
    NumberLike,
    NumberSpec,
    anr_pressure,
    anr_temperature,
    laminar_limit,
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
MOST_CELLS = 200
MET, MADE, CLOSED = "met", "made", "closed"
"""An end of a tube: named by another part's port, joined to a store by a passage of half a cell, or shut."""
_CELL = ("pressure", "temperature", "mass", "heat_flow_rate")
_START = {
    "pressure": NumberSpec("Pa", "pressure of a cell at the start", kind="pressure", above=0.0),
    "temperature": NumberSpec("K", "temperature of a cell at the start", kind="temperature", above=0.0),
    "mass_flow_rate": NumberSpec("kg/s", "mass flow rate at the start", kind="mass_flow"),
}


@dataclass(frozen=True)
class TubeSegment(Passage):
    """The gas between two cells of a tube; a member of `Tube`, which tells it everything."""

    kind: ClassVar[str] = "tube_segment"
    summary: ClassVar[str] = "a piece of a tube"

    from_: str | None = port("cell or store at the first end")
    to: str | None = port("cell or store at the second end")
    loss: str = option(ISO, FRICTION, doc="law of the loss")
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
        if self.loss == FRICTION:  # chokes as its cross-section does
            gas = {"isentropic_exponent": ambient.isentropic_exponent, "gas_constant": ambient.gas_constant}
            nozzle = iso6358.conductance_from_effective_area(0.25 * math.pi * values["bore"] ** 2, **gas)
            values["sonic_conductance"], _ = ambient.stated_size(nozzle.sonic_conductance, 0.0)
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
        mass, air = scope.states["mass_flow_rate"], scope.surroundings
        temperature, loss = self._temperature_and_loss(scope, mass, first, second)
        area = 0.25 * math.pi * scope["bore"] ** 2
        rate = area / scope["length"] * (first.pressure - second.pressure - loss)
        flow = Flow("mass_flow_rate", "from", "to", mass, air.heat_capacity_pressure * temperature * mass)
        return PassageFlows((flow,), {"mass_flow_rate": (mass, "kg/s")}, {"mass_flow_rate": rate})

    def _temperature_and_loss(self, scope: Scope, mass: Any, first: GasState, second: GasState) -> tuple[Any, Any]:
        """Temperature of the gas that flows, and what friction takes of the pressure."""
        pressures, air = (first.pressure, second.pressure), scope.surroundings
        conductance, ratio = air.size_with_gas(scope["sonic_conductance"], scope["critical_ratio"])
        # Per root of the temperature, which follows.
        sonic = conductance * iso6358.REFERENCE_DENSITY * sqrt(iso6358.REFERENCE_TEMPERATURE) * maximum(*pressures)
        temperature = iso6358.temperature_of_flow(
            mass, sonic / sqrt(first.temperature), first.temperature, second.temperature
        )
        choked = sonic / sqrt(temperature)
        density = gas_law.density(0.5 * (first.pressure + second.pressure), temperature, air.gas_constant)
        tube = scope["length"], scope["bore"], density, scope["viscosity"]
        if self.loss == ISO:
            coefficient = iso6358.loss_coefficient(*pressures, choked, ratio)
        else:
            # No drop holds a flow above the choked one for long.
            least = abs(first.pressure - second.pressure) / choked**2
            coefficient = maximum(pipe.darcy_coefficient(mass, *tube, scope["roughness"]), least)
        reynolds = pipe.reynolds_number(mass, scope["bore"], scope["viscosity"])
        laminar, turbulent = pipe.laminar_resistance(*tube) * mass, coefficient * mass * abs(mass)
        return temperature, pipe.between_laminar_and_turbulent(reynolds, laminar, turbulent)


@dataclass(frozen=True)
class Profile:
    """States of the single cells at the start: those that were given, and those of the whole tube."""

    given: Mapping[str, Number]
    usual: Mapping[str, Number]

    def numbers(self) -> dict[str, Number]:
        """Number of every state by name and place, `pressure_3`."""
        return {**self.usual, **self.given}

    def with_numbers(self, values: Mapping[str, Number]) -> Profile:
        """The same but for some states."""
        return Profile({**self.given, **values}, self.usual)


@dataclass(frozen=True)
class Tube(Compound):
    r"""A tube or hose: cells in a row, with loss between them, wall heat, and by option the inertia of the gas.

    .. math:: \frac{V \dot p}{\kappa - 1} = \sum c_p T q + h A (T_w - T), \qquad
              \frac{L}{A} \dot q = p_1 - p_2 - \Delta p(q) \quad \text{(with inertia)}

    Parameters
    ----------
    from_, to : str
        What its ends are joined to (`from` in a circuit file): a store, `tank`, to which the tube makes the passage; a
        port, `valve.outlet`, of a part that names this tube there: the port is joined to the cell at that end. Without
        `to` that end is shut.
    length, bore : number
        Length and inner diameter [m].
    cells : number
        Number of cells, 1 ... 200; not a number that can be fitted.
    inertia : bool
        With true the mass flow rates are states, and pressure waves travel.
    loss : str
        `iso6358` (default): C and b, those of the tube formula where they are not given; `friction`: Darcy-Weisbach
        with the tube's roughness, for tubes with inertia.
    sonic_conductance, critical_ratio : number
        C [m^3/(s Pa)] and b of the whole tube, where a catalogue or a bench has them, for `iso6358`.
    roughness : number
        Height of the wall's roughness [m], for `friction`.
    viscosity : number
        Dynamic viscosity of the gas [Pa s], for tubes with inertia.
    wall_conductance, wall_temperature : number
        Product h A of the whole tube's heat transfer [W/K], 0 is adiabatic; temperature of its wall [K].
    initial_pressure, initial_temperature : number
        Absolute pressure [Pa] and temperature [K] at the start.
    profile : table
        States of single cells at the start, by name and place, ``{"pressure_3": "1.1 bar"}``; a run that goes on where
        another has ended begins with these.

    Notes
    -----
    See docs/tube.md. Ports of other parts may be joined to any cell, `hose.3`. Up to Re = 2000 the loss of a tube with
    inertia is laminar; its flow is held below the choked one, and its kinetic energy is not reckoned.

    Examples
    --------
    >>> hose = Tube(from_="valve.outlet", to="tank", length="2 m", bore="4 mm", cells=4, inertia=True)
    >>> hose.stores()
    ('1', '2', '3', '4')
    >>> [*hose.members][4:]
    ['1_to_2', '2_to_3', '3_to_4', 'outlet']
    """

    kind: ClassVar[str] = TUBE
    summary: ClassVar[str] = "a tube: cells with loss, wall heat and, by option, the inertia of the gas"

    from_: str | None = port("store at the first end, or port that names the tube")
    to: str | None = port("store at the second end, or port that names the tube; shut without", optional=True)
    length: NumberLike = number("m", doc="length", above=0.0)
    bore: NumberLike = number("m", doc="bore", above=0.0)
    cells: NumberLike = number("1", 8.0, doc="number of cells", low=1.0, high=float(MOST_CELLS))
    inertia: str = switch(doc="inertia of the gas")
    loss: str = option(ISO, FRICTION, doc="law of the loss")
    sonic_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="sonic conductance C", above=0.0)
    critical_ratio: NumberLike = number("1", optional=True, doc="critical ratio b", low=0.0, below=1.0)
    roughness: NumberLike = number("m", 0.0, doc="height of the wall's roughness", low=0.0, note="smooth")
    viscosity: NumberLike = number(
        "Pa s", pipe.AIR_VISCOSITY_ANR, doc="dynamic viscosity", above=0.0, source="paper", note="air at 20 degC, White"
    )
    wall_conductance: NumberLike = number("W/K", 0.0, doc="wall conductance h A", low=0.0, note="adiabatic by default")
    wall_temperature: NumberLike = number("K", optional=True, doc="wall temperature", kind="temperature", above=0.0)
    initial_pressure: NumberLike = anr_pressure("initial pressure")
    initial_temperature: NumberLike = anr_temperature("initial temperature")
    profile: Any = reference(doc="states of single cells at the start, by name and place")

    def check(self) -> None:
        count = self._value("cells")
        with ErrorCollector() as errors:
            if count != int(count):
                errors.add("tube.cells", "cells", value=count)
            elif count == 1.0 and self._ends == (MET, MET):
                errors.add("tube.one_cell", "cells", ends=[self.from_, self.to])
            if self.loss == FRICTION and self.inertia != "true":
                errors.add("tube.friction_without_inertia", "loss")
        object.__setattr__(self, "profile", self._profile())

    def _profile(self) -> Profile:
        given = self.profile.given if isinstance(self.profile, Profile) else self.profile or {}
        if not isinstance(given, Mapping):
            raise InputError("fields.no_table", "profile", value=given)
        usual: dict[str, Any] = {}
        for k in range(1, self._count + 1):
            usual |= {f"pressure_{k}": self.initial_pressure, f"temperature_{k}": self.initial_temperature}
        for name in self._open_passages if self.inertia == "true" else ():
            usual[f"mass_flow_rate_{self._place(name)}"] = Number(0.0, "kg/s", Source("assumed", note="at rest"))
        with ErrorCollector() as errors:
            errors.extend(unknown_field(f"profile.{key}", key, usual) for key in given if key not in usual)
            read = {}
            for key in (key for key in given if key in usual):
                with errors.collecting():
                    read[key] = read_number(f"profile.{key}", _START[key.rpartition("_")[0]], given[key])
        return Profile(read, usual)

    @property
    def _count(self) -> int:
        return int(self._value("cells"))

    @property
    def _ends(self) -> tuple[str, str]:
        """How the first and the second end are joined."""
        first, second = (CLOSED if end is None else MET if is_port(end) else MADE for end in (self.from_, self.to))
        return first, second

    def outer_ports(self) -> dict[str, str]:
        """Port of another part that names this tube, to the cell that it is joined to."""
        cells = {self.from_: "1", self.to: str(self._count)}
        return {end: cell for end, cell in cells.items() if end is not None and is_port(end)}

    # Members -----------------------------------------------------------------------------------------------------

    @property
    def _spacing(self) -> float:
        """Distance between two cells, over the length: at a port lies half a cell, elsewhere the middle of a whole."""
        return 1.0 / (self._count - sum(0.5 for end in self._ends if end == MET))

    @cached_property
    def _passages(self) -> dict[str, tuple[str, str, float]]:
        """Name to both ends and length in spacings of all between cells, half a cell at a shut end as well."""
        names = [str(k) for k in range(1, self._count + 1)]
        found = {} if self._ends[0] == MET else {"inlet": (str(self.from_), f".{names[0]}", 0.5)}
        for one, other in pairwise(names):
            found[f"{one}_to_{other}"] = f".{one}", f".{other}", 1.0
        return found if self._ends[1] == MET else {**found, "outlet": (f".{names[-1]}", str(self.to), 0.5)}

    @property
    def _open_passages(self) -> list[str]:
        """Names of those that gas can pass."""
        return [name for name in self._passages if name != "outlet" or self._ends[1] != CLOSED]

    def _place(self, passage: str) -> str:
        """Number of the cell in front of a passage: 0 at the first end."""
        return {"inlet": "0", "outlet": str(self._count)}.get(passage) or passage.partition("_")[0]

    def _value(self, name: str) -> float:
        return float(getattr(self, name))

    @cached_property
    def members(self) -> dict[str, Part]:
        """Cells by number, then the passages between them."""
        start, conductance = self.profile.numbers(), self._value("wall_conductance")
        volume = 0.25 * math.pi * self._value("bore") ** 2 * self._value("length")
        cells: dict[str, Part] = {}
        for k in range(1, self._count + 1):
            at_ports = (k == 1 and self._ends[0] == MET) + (k == self._count and self._ends[1] == MET)
            share = self._spacing * (1.0 - 0.5 * at_ports)
            cells[str(k)] = Chamber(
                volume=volume * share,
                wall_conductance=conductance * share,
                wall_temperature=self.wall_temperature,
                initial_pressure=start[f"pressure_{k}"],
                initial_temperature=start[f"temperature_{k}"],
            )
        return cells | self._segments(start)

    def _segments(self, start: Mapping[str, Number]) -> dict[str, Part]:
        """What joins the cells to each other and to stores."""
        found: dict[str, Part] = {}
        weights = [weight for *_, weight in self._passages.values()]
        sizes = iso6358.divided(*self._size, weights) if self.loss == ISO else [(None, 0.0)] * len(weights)
        for name, (conductance, ratio) in zip(self._passages, sizes, strict=True):
            one, other, weight = self._passages[name]
            flow = start.get(f"mass_flow_rate_{self._place(name)}")
            if name in self._open_passages:
                found[name] = TubeSegment(
                    one, other, self.loss, self.inertia, self._value("length") * self._spacing * weight, self.bore,
                    conductance, ratio, self.viscosity, self.roughness, flow,
                    laminar_ratio=1.0 - 1e-3 * weight * self._spacing,  # of the whole tube it is the usual one
                )  # fmt: skip
        return found

    @property
    def _size(self) -> tuple[float, float]:
        """C [m^3/(s Pa)] and b of the whole tube, by the tube formula where they are not given."""
        conductance, ratio = iso6358.tube(self._value("length"), self._value("bore"))
        return (
            conductance if self.sonic_conductance is None else self._value("sonic_conductance"),
            ratio if self.critical_ratio is None else self._value("critical_ratio"),
        )

    # What a circuit asks ------------------------------------------------------------------------------------------

    def stores(self) -> tuple[str, ...]:
        return tuple(str(k) for k in range(1, self._count + 1))

    def outside(self) -> dict[str, str]:
        flows = {self._place(name): name for name in self._open_passages}
        found = {"mass_flow_rate": "inlet.mass_flow_rate"} if "0" in flows else {}
        for cell in self.stores():
            found |= {f"{cell}.{name}": f"{cell}.{name}" for name in _CELL}
            if cell in flows:
                found[f"{cell}.mass_flow_rate"] = f"{flows[cell]}.mass_flow_rate"
        return found

    @property
    def resume(self) -> dict[str, str]:  # type: ignore[override]
        """The states of every cell, and of every passage with inertia."""
        found = {}
        for key in self.profile.numbers():
            name, _, place = key.rpartition("_")
            found[name if place == "0" else f"{place}.{name}"] = f"profile.{key}"
        return found

    def can_resume(self, target: str) -> bool:
        return True

    def numbers(self) -> dict[str, Number]:
        own = {name: value for name, value in Part.numbers(self).items() if name != "cells"}
        return own | {f"profile.{key}": value for key, value in self.profile.given.items()}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        Part.parameters(self, ambient)  # where a gauge value lies below vacuum, it is the tube's own
        return super().parameters(ambient)

    def options(self) -> dict[str, str]:
        return {**super().options(), "cells": str(self._count)}

    def notes(self) -> tuple[Note, ...]:
        idle = ("sonic_conductance", "critical_ratio") if self.loss == FRICTION else ("roughness",)
        given = [name for name in idle if getattr(self, name) is not None and self._value(name) > 0.0]
        return (Note("tube.no_effect", given[0], loss=self.loss),) if given else ()
