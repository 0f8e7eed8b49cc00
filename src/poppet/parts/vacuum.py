"""Vacuum technology: ejector and suction cup."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, OutOfRangeError
from poppet.core.provenance import Number
from poppet.core.symbolic import clip, is_certain, maximum, minimum, where
from poppet.core.units import ANR
from poppet.laws import iso6358
from poppet.laws.physics.ejector import largest_suction, suction_flow
from poppet.laws.physics.gas import AIR_GAS_CONSTANT
from poppet.parts import symbols
from poppet.parts.captions import ASSUMED, CaptionNumbers, format_value
from poppet.parts.chamber import Chamber
from poppet.parts.fields import (
    NumberLike,
    laminar_limit,
    model,
    number,
    port,
    reference,
    subsonic_index_m,
    switch,
)
from poppet.parts.flow_path import iso_flow, named_flow
from poppet.parts.part import (
    AMBIENT,
    SELF,
    Flow,
    GasBalance,
    GasState,
    Input,
    Passage,
    PassageFlows,
    Quantities,
    Scope,
    State,
    Surroundings,
)
from poppet.parts.rows import SuctionRows
from poppet.parts.two_positions import switching_rate

SUCTION_PER_CONSUMPTION = 0.5
"""Assumed suction flow without vacuum, relative to the air consumption."""
VACUUM_FRACTION = 0.85
"""Assumed largest vacuum, relative to the ambient pressure."""
OPEN_PER_NOZZLE = 2.0
"""Assumed conductance of the path from the vacuum port to the exhaust, relative to that of the nozzle."""
_GENERIC = ("max_suction_flow", "max_vacuum")


@dataclass(frozen=True)
class VacuumEjector(Passage):
    r"""Vacuum ejector: a nozzle whose jet draws gas from the vacuum port.

    .. math:: q_v = \min\left(\varrho_0\, s\, Q\left(\frac{p_e - p_v}{s}\frac{p_a}{p_e}\right),\
              q_s \frac{\ln(p_s/p_e)}{\ln(p_e/p_v)}\right), \qquad
              s = \operatorname{clip}\left(\frac{p_s - p_e}{p_n - p_a}, 0, 1\right)

    Notes
    -----
    :math:`p_s`, :math:`p_v` and :math:`p_e` are the pressures at supply, vacuum port and exhaust, :math:`p_a` the
    ambient pressure, :math:`p_n` `nominal_pressure`, :math:`q_s` the flow through the nozzle and Q the suction curve at
    :math:`p_n`, as a volume flow at ANR. The curve is `suction_curve`, with straight lines between its points. Without
    it, the curve is a straight line from `max_suction_flow` at ambient pressure to 0 at `max_vacuum`, and a note
    reports this assumption. Close to the largest vacuum, the slope of the curve decreases to 0. The second term is the
    limit of the second law. For another exhaust pressure than the ambient one, the curve is valid for the same relative
    vacuum.

    `air_consumption` is converted to C for the gas of the circuit. The suction curve is a volume flow of any gas.

    If the vacuum exceeds the vacuum that the ejector can hold with the present supply, gas flows back from the exhaust
    to the vacuum port, unless `check_valve` is true. The flow path for it has `vacuum_conductance`. Without supply, the
    vacuum port is thus open to the exhaust.

    Exactly one of `nozzle_conductance` and `air_consumption` specifies the nozzle. The defaults are: `max_suction_flow`
    half the air consumption, `max_vacuum` 85 % of the ambient pressure, `vacuum_conductance` twice the conductance of
    the nozzle, and `exhaust` the ambient.

    References
    ----------
    Festo, Basic principles of vacuum technology: with a lower air pressure, the vacuum of an ejector is smaller, but
    not its relative vacuum.

    Examples
    --------
    >>> ejector = VacuumEjector(supply="net", vacuum="hose", air_consumption="60 l/min ANR")
    >>> ejector.ports()["exhaust"]
    'ambient'
    """

    kind: ClassVar[str] = "vacuum_ejector"
    sizes: ClassVar[tuple[str, ...]] = ("nozzle_conductance", "air_consumption")
    regimes: ClassVar[tuple[str, ...]] = ("supply_regime",)
    symbol: ClassVar[symbols.Symbol | str] = symbols.VACUUM_EJECTOR
    summary: ClassVar[str] = "a nozzle that draws gas from a vacuum port, with a measured or generic suction curve"

    supply: str | None = port("gas node at the supply port")
    vacuum: str | None = port("gas node that is evacuated")
    exhaust: str | None = port("gas node that receives both flows", optional=True)
    nozzle_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C of the nozzle", above=0.0)
    air_consumption: NumberLike = number(
        "m^3/s ANR",
        optional=True,
        kind="volume_flow_anr",
        doc="air consumption at the nominal pressure",
        above=0.0,
    )
    nozzle_ratio: NumberLike = number(
        "1", 0.5, doc="critical ratio b of the nozzle", low=0.0, below=1.0, note="nearly an ideal nozzle"
    )
    nominal_pressure: NumberLike = number(
        "Pa",
        "5 bar g",
        doc="nominal pressure; supply pressure for which the data are valid",
        kind="pressure",
        above=0.0,
        note="usual in catalogues",
    )
    suction_curve: Any = reference(doc="measured suction curve; mapping of lists pressure, suction_flow")
    max_suction_flow: NumberLike = number(
        "m^3/s ANR", optional=True, kind="volume_flow_anr", doc="suction flow at ambient pressure", above=0.0
    )
    max_vacuum: NumberLike = number(
        "Pa", optional=True, kind="pressure_difference", doc="largest vacuum; pressure below ambient", above=0.0
    )
    check_valve: str = switch(doc="check valve that prevents flow back into the vacuum port")
    vacuum_conductance: NumberLike = number(
        "m^3/(s Pa)", optional=True, doc="conductance C from the vacuum port to the exhaust", low=0.0
    )
    vacuum_ratio: NumberLike = number("1", 0.3, doc="critical ratio b of this path", low=0.0, below=1.0)
    model: Any = model()
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def check(self) -> None:
        if self.nozzle_conductance is None and self.air_consumption is None:
            raise InputError("vacuum.no_nozzle", "nozzle_conductance")
        with ErrorCollector() as errors:
            if self.nozzle_conductance is not None and self.air_consumption is not None:
                errors.add("vacuum.two_nozzles", "air_consumption")
            if self.suction_curve is not None:
                for name in _GENERIC:
                    if getattr(self, name) is not None:
                        errors.add("vacuum.idle_generic", name)
                with errors.collecting():
                    object.__setattr__(self, "suction_curve", SuctionRows.read(self.suction_curve))

    def ports(self) -> dict[str, str]:
        ports = super().ports()
        # Last: a schematic starts at the first port.
        return ports if "exhaust" in ports else {**ports, "exhaust": AMBIENT}

    def notes(self) -> tuple[Note, ...]:
        if self.suction_curve is not None:
            return ()
        assumed = [name for name in _GENERIC if getattr(self, name) is None]
        return (Note("vacuum.generic_curve", "suction_curve", assumed=assumed),)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        if self.suction_curve is not None:
            suction = "measured suction curve"
        else:
            flow = format_value(numbers.parameter("max_suction_flow"), "m^3/s ANR")
            suction = f"suction {flow}{'' if self.max_suction_flow is not None else ASSUMED}"
        nozzle = self.air_consumption or self.nozzle_conductance
        return ["ejector", f"nozzle {numbers.text(nozzle)}", suction]

    def structure(self) -> Hashable:
        return super().structure(), None if self.suction_curve is None else self.suction_curve.structure()

    def numbers(self) -> dict[str, Number]:
        table = {} if self.suction_curve is None else self.suction_curve.numbers()
        return super().numbers() | {f"suction_curve.{name}": value for name, value in table.items()}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        nominal = values["nominal_pressure"]
        if is_certain(nominal <= ambient.pressure):
            shown = self.nominal_pressure.display()  # type: ignore[union-attr]
            facts = {"shown": shown, "ambient": ambient.pressure}
            raise OutOfRangeError("vacuum.nominal_below_ambient", "nominal_pressure", **facts)
        # C is the choked volume flow at ANR per upstream pressure; the consumption is that of air.
        consumption = values.pop("air_consumption", None)
        if consumption is not None:
            gas = {"isentropic_exponent": ambient.isentropic_exponent, "gas_constant": ambient.gas_constant}
            conductance = iso6358.factors_from_air(**gas)[0] * consumption / nominal
            values["nozzle_conductance"] = ambient.capacity_as_stated(conductance, values["nozzle_ratio"])[0]
        values.setdefault("vacuum_conductance", OPEN_PER_NOZZLE * values["nozzle_conductance"])
        if self.suction_curve is not None:
            table = self.suction_curve.parameters(ambient.pressure)
            return values | {f"suction_curve.{name}": value for name, value in table.items()}
        values.setdefault("max_suction_flow", SUCTION_PER_CONSUMPTION * values["nozzle_conductance"] * nominal)
        values.setdefault("max_vacuum", VACUUM_FRACTION * ambient.pressure)
        if is_certain(values["max_vacuum"] >= ambient.pressure):
            shown = self.max_vacuum.display()  # type: ignore[union-attr]
            raise OutOfRangeError("vacuum.above_ambient", "max_vacuum", shown=shown, ambient=ambient.pressure)
        return values

    def _curve(self, scope: Scope) -> tuple[list[Any], list[Any]]:
        """Return the vacuum [Pa] and the suction flow [m^3/s ANR] of the points of the suction curve."""
        if self.suction_curve is None:
            return [0.0, scope["max_vacuum"]], [scope["max_suction_flow"], 0.0]
        table = {name: scope[f"suction_curve.{name}"] for name in self.suction_curve.numbers()}
        return self.suction_curve.points(table, scope.surroundings.pressure)  # type: ignore[no-any-return]

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        supply, vacuum, exhaust = gas["supply"], gas["vacuum"], gas["exhaust"]
        nozzle = scope["nozzle_conductance"], scope["nozzle_ratio"]
        motive, outputs = named_flow(scope, gas, "supply", ("supply", "exhaust"), nozzle)
        gauge = scope["nominal_pressure"] - scope.surroundings.pressure
        drive = clip((supply.pressure - exhaust.pressure) / gauge, 0.0, 1.0)
        depths, flows = self._curve(scope)
        # The ratio of vacuum and exhaust pressure is that of the curve, which is valid for the ambient pressure.
        depths = [depth * exhaust.pressure / scope.surroundings.pressure for depth in depths]
        zone = (1.0 - scope["laminar_ratio"]) * exhaust.pressure
        suction = suction_flow(exhaust.pressure - vacuum.pressure, drive, depths, flows, zone)
        limit = largest_suction(motive.mass, supply.pressure, exhaust.pressure, vacuum.pressure)
        density = ANR.density * AIR_GAS_CONSTANT / scope.surroundings.gas_constant
        suction = minimum(density * suction, maximum(limit, 0.0))
        mass, enthalpy = suction, scope.surroundings.heat_capacity_pressure * vacuum.temperature * suction
        # The jet holds a vacuum of this pressure: gas flows back only at a lower pressure.
        held = GasState(exhaust.pressure - drive * depths[-1], exhaust.temperature)
        size = scope["vacuum_conductance"], scope["vacuum_ratio"]
        paths = [(vacuum, exhaust, 1.0)] + [(held, vacuum, -1.0)] * (self.check_valve != "true")
        for first, second, sign in paths:
            ends = ("vacuum", "exhaust")
            flow, _ = iso_flow(scope, "vacuum_mass_flow_rate", ends, (first, second), size, one_way=True)
            mass, enthalpy = mass + sign * flow.mass, enthalpy + sign * flow.enthalpy
        total = Flow("vacuum_mass_flow_rate", "vacuum", "exhaust", mass, enthalpy)
        outputs["vacuum_mass_flow_rate"] = total.mass, "kg/s"
        return PassageFlows((motive, total), outputs)


LIP = "lip"
"""Port of a suction cup that is open to the ambient."""
SEALED = 0.5
"""Contact above which a workpiece closes a suction cup."""
FORCE_WIDTH = 1e-3
"""Half width of the hysteresis of a force limit, relative to the force of a complete vacuum."""
INITIAL_VACUUM = 0.05
"""Initial vacuum, relative to the ambient pressure, from which a cup holds its workpiece at the start."""
PORT_DIAMETER = 0.1
"""Assumed bore of the fitting, relative to the diameter of the cup."""


@dataclass(frozen=True)
class SuctionCup(Chamber, Passage):
    r"""Suction cup that holds a workpiece by vacuum.

    .. math:: F = c\, (p_a - p) \frac{\pi}{4} d^2

    Notes
    -----
    F is the holding force, c the contact, :math:`p_a` the ambient pressure, p the pressure in the cup and d `diameter`.
    The contact is the input `sealed` until the load drops, and then 0. The flow path from the ambient into the cup has
    the conductance :math:`C_l + (1 - c) C_o` with `leak_conductance` :math:`C_l` and `lip_conductance` :math:`C_o`.

    The workpiece lies on its support until the holding force exceeds `load_force` for the first time: the cup then
    holds the workpiece. If `load_force` exceeds the holding force later, the workpiece drops, and the cup is open until
    `sealed` has been 0. A cup whose initial vacuum exceeds 5 % of the ambient pressure holds its workpiece at the
    start. A negative `load_force` presses the workpiece against the cup.

    The defaults are an ideal nozzle of the bore d/10 for the fitting, and of the area of the cup for the open lip. The
    volume of the cup is constant, and leaks are flow paths after ISO 6358.

    Examples
    --------
    >>> cup = SuctionCup(port="hose", volume="5 cm^3", diameter="40 mm")
    >>> cup.ports()
    {'port': 'hose', 'lip': 'ambient'}
    """

    kind: ClassVar[str] = "suction_cup"
    regimes: ClassVar[tuple[str, ...]] = ("port_regime", "leak_regime")
    symbol: ClassVar[symbols.Symbol | str] = symbols.SUCTION_CUP
    summary: ClassVar[str] = "a suction cup that holds a workpiece, leaks, or drops it"
    internal_outputs: ClassVar[tuple[str, ...]] = (*Chamber.internal_outputs, "gripped", "dropped")
    resume: ClassVar[dict[str, str]] = {
        **Chamber.resume,
        "gripped": "initial_gripped",
        "dropped": "initial_dropped",
    }

    port: str | None = port("gas node that evacuates the cup")
    diameter: NumberLike = number("m", doc="effective diameter; that of the area of the holding force", above=0.0)
    leak_conductance: NumberLike = number(
        "m^3/(s Pa)", 0.0, doc="conductance C of the leak of a sealed cup", low=0.0, note="tight"
    )
    leak_ratio: NumberLike = number("1", 0.3, doc="critical ratio b of leak and lip", low=0.0, below=1.0)
    lip_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C of the open lip", above=0.0)
    port_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C of the fitting", above=0.0)
    port_ratio: NumberLike = number("1", 0.3, doc="critical ratio b of the fitting", low=0.0, below=1.0)
    sealed: NumberLike = number("1", 1.0, doc="contact with a workpiece", low=0.0, high=1.0, note="on a workpiece")
    load_force: NumberLike = number("N", 0.0, doc="load force; positive if it pulls the workpiece off", note="no load")
    switching_time: NumberLike = number("s", "2 ms", doc="time in which a load drops", above=0.0, note="fast")
    initial_pressure: NumberLike = number(
        "Pa", "0 bar g", doc="initial pressure", kind="pressure", above=0.0, note="that of the ambient"
    )
    initial_gripped: NumberLike = number("1", optional=True, doc="1 if it holds at the start", low=0.0, high=1.0)
    initial_dropped: NumberLike = number("1", 0.0, doc="1 if it has dropped its load", low=0.0, high=1.0, note="no")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def ports(self) -> dict[str, str]:
        return {**super().ports(), LIP: AMBIENT}

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        load = [] if "load_force" in numbers.signals else [f"load {numbers.text(self.load_force)}"]
        return ["suction cup", f"{numbers.text(self.diameter)}, {numbers.text(self.volume)}", *load]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        gas = {"isentropic_exponent": ambient.isentropic_exponent, "gas_constant": ambient.gas_constant}
        area = 0.25 * math.pi * values["diameter"] ** 2
        for name, fraction in (("lip_conductance", 1.0), ("port_conductance", PORT_DIAMETER**2)):
            nozzle = iso6358.conductance_from_effective_area(area * fraction, **gas)
            values.setdefault(name, ambient.capacity_as_stated(nozzle.sonic_conductance, nozzle.critical_ratio)[0])
        vacuum = ambient.pressure - values["initial_pressure"]
        holds = where(vacuum > INITIAL_VACUUM * ambient.pressure, values["sealed"], 0.0)
        values.setdefault("initial_gripped", holds)
        return values

    def states(self) -> tuple[State, ...]:
        latches = (State(name, "1", 1.0, floor=1.0) for name in ("gripped", "dropped"))
        return (*super().states(), *latches)

    def inputs(self) -> tuple[Input, ...]:
        return Input("sealed", "1", "sealed", low=0.0, high=1.0), Input("load_force", "N", "load_force")

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return super().output_ranges() | {"held": (0.0, 1.0)}

    def start(self, scope: Scope) -> dict[str, Any]:
        latches = {name: scope[f"initial_{name}"] for name in ("gripped", "dropped")}
        return {**super().start(scope), **latches}

    def _contact(self, scope: Scope) -> Any:
        return scope.inputs["sealed"] * (1.0 - clip(scope.states["dropped"], 0.0, 1.0))

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        gas = {**gas, SELF: self.gas(scope)}
        leak = scope["leak_conductance"] + (1.0 - self._contact(scope)) * scope["lip_conductance"]
        flows, outputs = list[Flow](), Quantities()
        for name, ends, size in (
            ("port", ("port", SELF), (scope["port_conductance"], scope["port_ratio"])),
            ("leak", (LIP, SELF), (leak, scope["leak_ratio"])),
        ):
            flow, flow_outputs = named_flow(scope, gas, name, ends, size)
            flows.append(flow)
            outputs |= flow_outputs
        return PassageFlows(tuple(flows), outputs)

    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        balance = super().balance(scope, flows)
        area = 0.25 * math.pi * scope["diameter"] ** 2
        force = (scope.surroundings.pressure - self.gas(scope).pressure) * area
        gripped, dropped = scope.states["gripped"], scope.states["dropped"]
        is_sealed = scope.inputs["sealed"] > SEALED
        excess = (force - scope.inputs["load_force"]) / (FORCE_WIDTH * scope.surroundings.pressure * area)
        # Within the hysteresis, a latch keeps its position; -2 resets it.
        grip_drive = where(is_sealed, clip(1.0 + excess, 0.0, 2.0), -2.0)
        drop_drive = where(is_sealed, where(gripped > 0.5, clip(1.0 - excess, 0.0, 2.0), 0.0), -2.0)
        time = scope["switching_time"]
        rates = {
            "gripped": switching_rate(gripped, grip_drive, time),
            "dropped": switching_rate(dropped, drop_drive, time),
        }
        gripped, dropped = clip(gripped, 0.0, 1.0), clip(dropped, 0.0, 1.0)
        outputs = {
            "holding_force": (force * self._contact(scope), "N"),
            "held": (gripped * (1.0 - dropped), "1"),
            "gripped": (gripped, "1"),
            "dropped": (dropped, "1"),
        }
        return GasBalance(
            {**balance.outputs, **outputs}, {**balance.rates, **rates}, balance.heat, balance.energy, balance.work
        )

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        is_dropped = series(f"{name}.dropped") > 0.5
        rows = np.flatnonzero(is_dropped[1:] & ~is_dropped[:-1])
        if not rows.size:
            return ()
        first = int(rows[0])
        facts = {"time": float(series("time")[first + 1]), "load": float(series(f"{name}.load_force")[first + 1])}
        return (Note("vacuum.dropped", "held", **facts, count=int(rows.size)),)
