"""A pressure controller that inverts the chamber's law and the flow law of its two valves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import exp, maximum, where
from poppet.laws.physics.gas import AIR_ISENTROPIC_EXPONENT
from poppet.laws.physics.pressure_rates import open_rates, openings_for_rate
from poppet.parts.fields import NumberLike, anr_temperature, group, laminar_limit, number, subsonic_index_m
from poppet.parts.part import DiscreteState, Input, Quantities, Scope
from poppet.parts.sampled_loop import NEXT_SAMPLE, SampledLoop, is_first


@dataclass(frozen=True)
class ValveModel:
    """What the controller knows of a valve."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", doc="sonic conductance C of the open valve", above=0.0)
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0)


@dataclass(frozen=True)
class PressureController(SampledLoop):
    r"""Feedback linearisation: the pressure follows its setpoint like a lag of first order.

    .. math:: \dot p_w = \frac{1 - e^{-T/\tau}}{T} (w - p) - \hat d, \qquad
              a = \dot p_w \Big/ \frac{n R T_{up}}{V} q(p_1, p_2)

    Parameters
    ----------
    time_constant : number
        tau of the closed loop [s].
    observer_time : number
        Time constant with which the rate that the model does not explain, :math:`\hat d`, is learnt [s]; 0: not at all.
    hold_band : number
        Error up to which both valves stay closed [Pa].
    volume : number
        V that the controller reckons with [m^3].
    polytropic_exponent : number
        n: the isentropic exponent for a fast or adiabatic chamber, 1 for an isothermal one.
    fill, vent : group
        sonic_conductance, critical_ratio that the controller reckons with.
    supply_pressure, exhaust_pressure : number
        Without a connection [Pa]; also inputs.
    supply_temperature, gas_temperature : number
        Of the supply and of the gas in the chamber [K]; the second is also an input.
    subsonic_index, laminar_ratio : number
        Subsonic index m of both valves, and pressure ratio at which the regularised zone begins.

    Notes
    -----
    The factor (1 - exp(-T/tau))/T makes the sampled loop as fast as the continuous one: a pressure that rises straight
    between two samples (choked filling) lies on the exponential at every instant. The observer compares each sample
    with what the model, with the valves' limits, said it would be: it is the integral part, does not wind up, and rests
    while the model is right. With `acts = "next_sample"` the law acts on the pressure that the model foresees.

    References
    ----------
    Slotine & Li, Applied Nonlinear Control, Prentice Hall 1991, chapter 6: input-output linearisation.
    """

    kind: ClassVar[str] = "pressure_controller"
    internal_outputs: ClassVar[tuple[str, ...]] = (*SampledLoop.internal_outputs, "wanted_rate", "disturbance")
    summary: ClassVar[str] = "feedback-linearising pressure control with two valves"

    time_constant: NumberLike = number("s", doc="time constant of the closed loop", above=0.0)
    observer_time: NumberLike = number("s", 0.0, doc="time constant of the observer", low=0.0, note="no observer")
    hold_band: NumberLike = number("Pa", 0.0, doc="hold band", low=0.0, note="none")
    volume: NumberLike = number("m^3", doc="volume of the chamber", above=0.0)
    polytropic_exponent: NumberLike = number("1", AIR_ISENTROPIC_EXPONENT, doc="polytropic exponent", low=1.0, high=1.7)
    fill: Any = group(ValveModel, doc="the valve that fills")
    vent: Any = group(ValveModel, doc="the valve that vents")
    supply_pressure: NumberLike = number("Pa", doc="supply pressure", kind="pressure", above=0.0)
    exhaust_pressure: NumberLike = number(
        "Pa", "0 bar g", doc="exhaust pressure", kind="pressure", low=0.0, note="the open air"
    )
    supply_temperature: NumberLike = anr_temperature("temperature of the supply")
    gas_temperature: NumberLike = anr_temperature("temperature of the gas")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def inputs(self) -> tuple[Input, ...]:
        pressures = ("supply_pressure", "exhaust_pressure")
        return (
            *super().inputs(),
            *(Input(name, "Pa", name, kind="pressure", low=0.0) for name in pressures),
            Input("gas_temperature", "K", "gas_temperature", kind="temperature", low=1.0),
        )

    def law_memory(self) -> tuple[DiscreteState, ...]:
        return (
            DiscreteState("wanted_rate", "Pa/s"),
            DiscreteState("disturbance", "Pa/s"),
            DiscreteState("predicted_pressure", "Pa"),
        )

    def law_outputs(self, scope: Scope) -> Quantities:
        return {name: (scope.memory[name], "Pa/s") for name in ("wanted_rate", "disturbance")}

    def _open_rates(self, scope: Scope, pressure: Any) -> tuple[Any, Any]:
        sizes = {
            name: scope.surroundings.size_with_gas(scope[f"{name}.sonic_conductance"], scope[f"{name}.critical_ratio"])
            for name in ("fill", "vent")
        }
        return open_rates(
            maximum(pressure, 0.0), scope.inputs["supply_pressure"], scope.inputs["exhaust_pressure"],
            gas_temperature=scope.inputs["gas_temperature"], supply_temperature=scope["supply_temperature"],
            volume=scope["volume"], exponent=scope["polytropic_exponent"],
            gas_constant=scope.surroundings.gas_constant, subsonic_index=scope["subsonic_index"],
            laminar_ratio=scope["laminar_ratio"], fill=sizes["fill"], vent=sizes["vent"],
        )  # fmt: skip

    def compute_command(self, scope: Scope, measured: Any) -> tuple[Any, Any, dict[str, Any]]:
        pressure, memory, time = measured, scope.memory, scope["sample_time"]
        learning = scope["observer_time"]
        # The quotient is formed where nothing is learnt as well, hence a divisor above zero.
        share = 1.0 - exp(-time / maximum(learning, time * 1e-3))
        surprise = where(is_first(scope), 0.0, (pressure - memory["predicted_pressure"]) / time)
        disturbance = memory["disturbance"] + where(learning > 0.0, share * surprise, 0.0)
        acting = pressure
        if self.acts == NEXT_SAMPLE:
            filling, venting = self._open_rates(scope, pressure)
            coming = maximum(memory["next_command"], 0.0) * filling - memory["next_vent_command"] * venting
            acting = pressure + time * (coming + disturbance)
        error = scope.inputs["setpoint"] - acting
        rate = (1.0 - exp(-time / scope["time_constant"])) / time * error - disturbance
        rate = where(error * error > scope["hold_band"] * scope["hold_band"], rate, 0.0)
        rates = self._open_rates(scope, acting)
        limits = {"fill_limit": scope["fill_limit"], "vent_limit": scope["vent_limit"]}
        fill, vent = openings_for_rate(rate, *rates, **limits)
        delivered = fill * rates[0] - vent * rates[1]
        # A command that comes one sample later has no part in what the next sample finds.
        predicted = acting if self.acts == NEXT_SAMPLE else pressure + time * (delivered + disturbance)
        new = {"wanted_rate": rate, "disturbance": disturbance, "predicted_pressure": predicted}
        return fill - vent, vent, new
