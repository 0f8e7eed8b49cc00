"""Supply of compressed air: pressure regulator and compressor."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import OutOfRangeError
from poppet.core.symbolic import clip, is_certain, maximum, minimum
from poppet.core.units import ANR
from poppet.laws.physics.compression import isentropic_compression_work
from poppet.laws.physics.gas import AIR_GAS_CONSTANT
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.faults import FaultEffect, Valve
from poppet.parts.fields import NumberLike, model, number, option, port
from poppet.parts.flow_path import FlowPath, named_flow
from poppet.parts.part import AMBIENT, Flow, GasState, Input, Passage, PassageFlows, Scope, State, Surroundings
from poppet.parts.two_positions import switching_rate

WORK_TOLERANCE = 100.0
"""Tolerance of the work per tolerance of the gas states; no other state depends on the work."""


@dataclass(frozen=True)
class PressureRegulator(Valve, FlowPath):
    r"""Relieving pressure regulator, described by its characteristic values.

    .. math:: \dot z = \frac{1}{T} \begin{cases}
              \min(e - h,\ 1) - z & \text{if positive} \\ \max(e + h,\ -r - 1) - z & \text{if negative} \\
              0 & \text{otherwise}\end{cases}, \qquad
              e = \frac{p_s - p_2}{\Delta p_d},\quad h = \frac{\Delta p_h}{2 \Delta p_d},\quad
              r = \frac{\Delta p_r}{\Delta p_d}

    Notes
    -----
    z is the position of the membrane, :math:`p_s` the setpoint, :math:`p_2` the outlet pressure, :math:`\Delta p_d`
    `droop`, :math:`\Delta p_h` `hysteresis`, :math:`\Delta p_r` `relief_offset` and T `lag`. The supply valve is closed
    for z below 0 and open at 1. The relief valve is closed for z above -r and open at -r - 1. Both conductances are
    proportional to z between these positions. The friction of the membrane keeps its position within a band of the
    outlet pressure whose width is `hysteresis`.

    The outlet pressure does not depend on the supply pressure, except through the flow. The mass of the membrane is
    neglected. By default, the relief valve has the flow capacity of the supply valve, and the exhaust is the ambient. A
    regulator whose `exhaust_conductance` is 0 does not relieve.

    References
    ----------
    ISO 6953 for characteristic values of regulators: flow, relief and hysteresis.

    Examples
    --------
    >>> regulator = PressureRegulator(supply="net", outlet="tool", setpoint="4 bar g", nominal_flow="800 l/min ANR")
    >>> regulator.ports()["exhaust"]
    'ambient'
    """

    kind: ClassVar[str] = "pressure_regulator"
    regimes: ClassVar[tuple[str, ...]] = ("supply_regime", "exhaust_regime")
    symbol: ClassVar[symbols.Symbol | str] = symbols.PRESSURE_REGULATOR
    summary: ClassVar[str] = "relieving pressure regulator with droop, hysteresis and relief offset"
    resume: ClassVar[dict[str, str]] = {"position": "initial_position"}

    supply: str | None = port("gas node at the supply port")
    outlet: str | None = port("gas node at the regulated port")
    exhaust: str | None = port("gas node that receives the relief flow", optional=True)
    setpoint: NumberLike = number("Pa", "0 bar g", doc="setpoint", kind="pressure", low=0.0, note="closed by default")
    delay: NumberLike = number("s", 0.0, doc="delay of a setpoint signal", low=0.0, note="none by default")
    droop: NumberLike = number(
        "Pa",
        "1 bar",
        doc="droop; pressure drop from no flow to the open valve",
        kind="pressure_difference",
        above=0.0,
        note="1 to 2 bar in catalogue curves of six regulators",
    )
    hysteresis: NumberLike = number(
        "Pa",
        "50 mbar",
        doc="hysteresis; width of the loop of the outlet pressure",
        kind="pressure_difference",
        low=0.0,
        note="a general-purpose regulator",
    )
    relief_offset: NumberLike = number(
        "Pa",
        "0.1 bar",
        doc="relief offset; pressure above the setpoint at which the relief valve opens",
        kind="pressure_difference",
        low=0.0,
        note="a general-purpose regulator",
    )
    lag: NumberLike = number("s", "10 ms", doc="time constant of the membrane", above=0.0, note="a small regulator")
    exhaust_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="conductance C of the relief", low=0.0)
    exhaust_ratio: NumberLike = number("1", optional=True, doc="critical ratio b of the relief", low=0.0, below=1.0)
    initial_position: NumberLike = number("1", 0.0, doc="initial position of the membrane", high=1.0, note="closed")

    def ports(self) -> dict[str, str]:
        ports = super().ports()
        # Last: a schematic starts at the first port.
        return ports if "exhaust" in ports else {**ports, "exhaust": AMBIENT}

    def notes(self) -> tuple[Note, ...]:
        relief = () if self.exhaust_conductance is not None else (Note("supply.assumed_relief", "exhaust_conductance"),)
        return (*super().notes(), *relief)

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        excess = series(f"{name}.setpoint") - series(f"{self.supply}.pressure")
        rows = np.flatnonzero(excess > 0.0)
        if not rows.size:
            return ()
        facts = {"time": float(series("time")[rows[0]]), "excess": float(excess.max())}
        return (Note("supply.setpoint_above_supply", "setpoint", **facts),)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        head = "regulator" if "setpoint" in numbers.signals else f"regulator, {numbers.text(self.setpoint)}"
        return [head, *super().caption(numbers), f"droop {numbers.text(self.droop)}"]

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        values.setdefault("exhaust_conductance", values["sonic_conductance"])
        values.setdefault("exhaust_ratio", values["critical_ratio"])
        return values

    def states(self) -> tuple[State, ...]:
        return (State("position", "1", 1.0, floor=1.0),)

    def inputs(self) -> tuple[Input, ...]:
        setpoint = Input("setpoint", "Pa", "setpoint", "pressure", 0.0, delay="delay", is_command=True)
        return (setpoint, *super().inputs())

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"position": scope["initial_position"]}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        position, droop, fault = scope.states["position"], scope["droop"], FaultEffect.of(scope)
        error = (scope.inputs["setpoint"] - gas["outlet"].pressure) / droop
        half_width, relief = 0.5 * scope["hysteresis"] / droop, scope["relief_offset"] / droop
        # The limits are within both terms, so the friction does not prevent that the valves open completely.
        opening_error = fault.forced(minimum(error - half_width, 1.0), 1.0, 0.0) - position
        closing_error = fault.forced(maximum(error + half_width, -relief - 1.0), 1.0, 0.0) - position
        rate = (maximum(opening_error, 0.0) + minimum(closing_error, 0.0)) / (scope["lag"] * fault.slowness)
        conductance, ratio = self.size_at(scope, None)
        sizes = {
            "supply": (("supply", "outlet"), conductance, ratio, clip(position, 0.0, 1.0)),
            "exhaust": (
                ("outlet", "exhaust"),
                scope["exhaust_conductance"],
                scope["exhaust_ratio"],
                clip(-position - relief, 0.0, 1.0),
            ),
        }
        flows, outputs = [], {"position": (position, "1")}
        for name, (ends, largest, critical_ratio, opening) in sizes.items():
            opening = fault.leaking(opening)
            flow, flow_outputs = named_flow(scope, gas, name, ends, (largest * opening, critical_ratio))
            flows.append(flow)
            outputs |= {f"{name}_opening": (opening, "1"), **flow_outputs}
        return PassageFlows(tuple(flows), outputs, {"position": fault.held(rate)})


AFTERCOOLER, UNCOOLED = "aftercooler", "none"


@dataclass(frozen=True)
class Compressor(Passage):
    r"""Compressor that delivers ambient air into a gas node between two pressures.

    .. math:: q_m = x Q \varrho_0 \frac{p_a}{p_0} \frac{T_0}{T_a} \frac{R_0}{R}, \qquad
              P = \frac{q_m}{\eta} \frac{\kappa R T_a}{\kappa - 1}
              \left[\left(\frac{p}{p_a}\right)^{(\kappa - 1)/\kappa} - 1\right]

    Notes
    -----
    x is the speed of the motor as a fraction of its rated speed, Q `free_air_delivery`, :math:`p_a` and :math:`T_a` the
    ambient pressure and temperature, :math:`\varrho_0`, :math:`p_0`, :math:`T_0` and :math:`R_0` the values of air at
    ANR, p the outlet pressure and :math:`\eta` the isentropic efficiency. The volume flow at the inlet is constant, so
    the mass flow is proportional to the density of the ambient gas. The decrease of the delivery with the outlet
    pressure is neglected.

    The motor starts if the outlet pressure falls below `start_pressure`, and stops if it exceeds `stop_pressure`. Its
    speed changes linearly during `switching_time`. The aftercooler cools the gas to the ambient temperature; without
    it, the enthalpy of the delivered gas contains the complete power. No gas flows back.

    References
    ----------
    ISO 1217:2009 for the free air delivery.

    Examples
    --------
    >>> pump = Compressor("tank", free_air_delivery="200 l/min ANR", start_pressure="6 bar g", stop_pressure="8 bar g")
    >>> round(float(pump.free_air_delivery) * 60e3)
    200
    """

    kind: ClassVar[str] = "compressor"
    regimes: ClassVar[tuple[str, ...]] = ()
    symbol: ClassVar[symbols.Symbol | str] = symbols.COMPRESSOR
    summary: ClassVar[str] = "compressor with two-point control between a start and a stop pressure"
    resume: ClassVar[dict[str, str]] = {"position": "initial_position", "work": "initial_work"}

    outlet: str | None = port("gas node that receives the air, usually a tank")
    free_air_delivery: NumberLike = number(
        "m^3/s ANR", kind="volume_flow_anr", doc="free air delivery; volume flow at the inlet", above=0.0
    )
    start_pressure: NumberLike = number("Pa", doc="outlet pressure that starts the motor", kind="pressure", above=0.0)
    stop_pressure: NumberLike = number("Pa", doc="outlet pressure that stops the motor", kind="pressure", above=0.0)
    efficiency: NumberLike = number(
        "1",
        0.6,
        doc="isentropic efficiency; isentropic work per work of the motor",
        above=0.0,
        high=1.0,
        note="a small piston compressor",
    )
    cooling: str = option(AFTERCOOLER, UNCOOLED, doc="cooling of the delivered air")
    model: Any = model()
    switching_time: NumberLike = number(
        "s", "0.2 s", doc="time in which the motor starts or stops", above=0.0, note="a small motor"
    )
    initial_position: NumberLike = number("1", 0.0, doc="initial speed, relative to the rated speed", low=0.0, high=1.0)
    initial_work: NumberLike = number("J", 0.0, doc="initial value of the work", note="counts from the start")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        limits = f"{numbers.text(self.start_pressure)} to {numbers.text(self.stop_pressure)}"
        return ["compressor", numbers.text(self.free_air_delivery), limits]

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return super().output_ranges() | {"position": (0.0, 1.0)}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if is_certain(values["start_pressure"] >= values["stop_pressure"]):
            start, stop = (n.display() for n in (self.start_pressure, self.stop_pressure))  # type: ignore[union-attr]
            raise OutOfRangeError("supply.start_above_stop", "start_pressure", shown=start, stop=stop)
        return values

    def states(self) -> tuple[State, ...]:
        position = State("position", "1", 1.0, floor=1.0)
        return position, State("work", "J", 1e3, WORK_TOLERANCE, 1.0)

    def start(self, scope: Scope) -> dict[str, Any]:
        return {"position": scope["initial_position"], "work": scope["initial_work"]}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        ambient, position, pressure = scope.surroundings, scope.states["position"], gas["outlet"].pressure
        start, stop = scope["start_pressure"], scope["stop_pressure"]
        drive = (start + stop - 2.0 * pressure) / (stop - start)
        speed_rate = switching_rate(position, drive, scope["switching_time"])
        density = ANR.density * AIR_GAS_CONSTANT / ambient.gas_constant
        density = density * (ambient.pressure / ANR.pressure) * (ANR.temperature / ambient.temperature)
        speed = clip(position, 0.0, 1.0)  # the integrator can exceed the ends by its tolerance
        mass = scope["free_air_delivery"] * density * speed
        properties = ambient.temperature, ambient.gas_constant, ambient.isentropic_exponent
        power = mass * isentropic_compression_work(ambient.pressure, pressure, *properties) / scope["efficiency"]
        enthalpy = mass * ambient.heat_capacity_pressure * ambient.temperature
        enthalpy = enthalpy + power if self.cooling == UNCOOLED else enthalpy
        outputs = {
            "position": (speed, "1"),
            "mass_flow_rate": (mass, "kg/s"),
            "power": (power, "W"),
            "work": (scope.states["work"], "J"),
        }
        flow = Flow("mass_flow_rate", None, "outlet", mass, enthalpy)
        return PassageFlows((flow,), outputs, {"position": speed_rate, "work": power})
