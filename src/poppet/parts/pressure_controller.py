"""Pressure controller that inverts models of a chamber and of two valves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import clip, exp, maximum, where
from poppet.laws.physics.gas import AIR_ISENTROPIC_EXPONENT
from poppet.laws.physics.pressure_rates import open_rates, openings_for_rate
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, anr_temperature, group, laminar_limit, number, subsonic_index_m
from poppet.parts.part import DiscreteState, Input, Quantities, Scope
from poppet.parts.safe_state import is_first_after_fault
from poppet.parts.sampled_loop import NEXT_SAMPLE, SampledLoop, is_first

LARGEST_RATE = 1e15
"""Largest magnitude of a pressure rate [Pa/s]."""


@dataclass(frozen=True)
class ValveModel:
    """Flow capacity of a fill or vent valve in the model that the controller inverts."""

    sonic_conductance: NumberLike = number("m^3/(s Pa)", doc="sonic conductance C of the open valve", above=0.0)
    critical_ratio: NumberLike = number("1", 0.3, doc="critical ratio b", low=0.0, below=1.0)


@dataclass(frozen=True)
class PressureController(SampledLoop):
    r"""Controller by feedback linearisation: the pressure follows its setpoint with a first-order lag.

    .. math:: \dot p_w = \frac{1 - e^{-T/\tau}}{T} (w - p) - \hat d, \qquad
              a = \dot p_w \Big/ \frac{n R T_{up}}{V} q(p_1, p_2)

    Notes
    -----
    The first equation gives the required pressure rate for the setpoint w and the measured pressure p, the second the
    opening a of a valve with the upstream pressure p_1 and the downstream pressure p_2. T is the sample time. The
    factor (1 - exp(-T/tau))/T gives the sampled loop the speed of the continuous loop: a pressure that rises linearly
    between two samples (choked filling) equals the exponential response at each sample instant.

    An observer estimates the pressure rate :math:`\hat d` that the model does not explain, from the difference between
    each sample and its prediction by the model. The prediction takes the limits of the valves into account. The
    observer replaces an integral part and does not wind up; an observer time of 0 disables it. With the option `acts =
    "next_sample"`, the law uses the predicted pressure. Set `polytropic_exponent` to the isentropic exponent for a fast
    or adiabatic chamber, and to 1 for an isothermal one.

    The input `input_fault` is 1 if an input is not valid. The observer then pauses, until the second sample with valid
    inputs. After `fault_time` with an input
    fault, the command is `safe_command`.

    References
    ----------
    Slotine & Li, Applied Nonlinear Control, Prentice Hall 1991, chapter 6: input-output linearisation.
    """

    kind: ClassVar[str] = "pressure_controller"
    symbol: ClassVar[symbols.Symbol | str] = symbols.PRESSURE_CONTROLLER
    internal_outputs: ClassVar[tuple[str, ...]] = (*SampledLoop.internal_outputs, "wanted_rate", "disturbance")
    summary: ClassVar[str] = "feedback-linearising pressure control with two valves"

    time_constant: NumberLike = number("s", doc="time constant tau of the closed loop", above=0.0)
    observer_time: NumberLike = number("s", 0.0, doc="time constant of the observer", low=0.0, note="no observer")
    hold_band: NumberLike = number(
        "Pa", 0.0, doc="hold band; error up to which both valves are closed", low=0.0, note="none"
    )
    volume: NumberLike = number("m^3", doc="volume V in the model", above=0.0)
    polytropic_exponent: NumberLike = number(
        "1", AIR_ISENTROPIC_EXPONENT, doc="polytropic exponent n", low=1.0, high=1.7
    )
    fill: Any = group(ValveModel, doc="model of the fill valve")
    vent: Any = group(ValveModel, doc="model of the vent valve")
    supply_pressure: NumberLike = number("Pa", doc="supply pressure without a connection", kind="pressure", above=0.0)
    exhaust_pressure: NumberLike = number(
        "Pa", "0 bar g", doc="exhaust pressure", kind="pressure", low=0.0, note="the ambient"
    )
    supply_temperature: NumberLike = anr_temperature("temperature of the supply")
    gas_temperature: NumberLike = anr_temperature("temperature of the gas")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        sampled = f"linearising, sampled every {numbers.text(self.sample_time)}"
        model = f"reckons with {numbers.text(self.volume)}, n = {numbers.text(self.polytropic_exponent)}"
        return [sampled, f"time constant {numbers.text(self.time_constant)}", model]

    def inputs(self) -> tuple[Input, ...]:
        names = ("supply_pressure", "exhaust_pressure")
        pressures = (Input(name, "Pa", name, kind="pressure", low=0.0) for name in names)
        temperature = Input("gas_temperature", "K", "gas_temperature", kind="temperature", low=1.0)
        return *super().inputs(), *pressures, temperature

    def law_memory(self) -> tuple[DiscreteState, ...]:
        rates = (DiscreteState(name, "Pa/s") for name in ("wanted_rate", "disturbance"))
        return *rates, DiscreteState("predicted_pressure", "Pa")

    def law_outputs(self, scope: Scope) -> Quantities:
        return {name: (scope.memory[name], "Pa/s") for name in ("wanted_rate", "disturbance")}

    def _open_rates(self, scope: Scope, pressure: Any) -> tuple[Any, Any]:
        stated_sizes = ((scope[f"{v}.sonic_conductance"], scope[f"{v}.critical_ratio"]) for v in ("fill", "vent"))
        fill, vent = (scope.surroundings.capacity_in_circuit_gas(*size) for size in stated_sizes)
        return open_rates(
            maximum(pressure, 0.0), scope.inputs["supply_pressure"], scope.inputs["exhaust_pressure"],
            gas_temperature=scope.inputs["gas_temperature"], supply_temperature=scope["supply_temperature"],
            volume=scope["volume"], exponent=scope["polytropic_exponent"],
            gas_constant=scope.surroundings.gas_constant, subsonic_index=scope["subsonic_index"],
            laminar_ratio=scope["laminar_ratio"], fill=fill, vent=vent,
        )  # fmt: skip

    def compute_command(self, scope: Scope, measured: Any, is_safe: Any) -> tuple[Any, Any, dict[str, Any]]:
        pressure, memory, time = measured, scope.memory, scope["sample_time"]
        observer_time = scope["observer_time"]
        # The quotient is evaluated without an observer too: its divisor must be positive.
        observer_gain = 1.0 - exp(-time / maximum(observer_time, time * 1e-3))
        # The prediction is not comparable with an invalid measurement, nor with the first one after a fault.
        pauses = where(is_first(scope), 1.0, maximum(scope.inputs["input_fault"], is_first_after_fault(scope)))
        unexplained = where(pauses > 0.5, 0.0, (pressure - memory["predicted_pressure"]) / time)
        disturbance = memory["disturbance"] + where(observer_time > 0.0, observer_gain * unexplained, 0.0)
        # With extreme parameters, the observer would overflow, in single precision within a few samples.
        disturbance = clip(disturbance, -LARGEST_RATE, LARGEST_RATE)
        effective = pressure
        if self.acts == NEXT_SAMPLE:
            fill_rate, vent_rate = self._open_rates(scope, pressure)
            next_rate = maximum(memory["next_command"], 0.0) * fill_rate - memory["next_vent_command"] * vent_rate
            effective = pressure + time * (next_rate + disturbance)
        scope.label("new_disturbance", disturbance, "pressure rate that the model does not explain [Pa/s]")
        error = scope.inputs["setpoint"] - effective
        scope.label("error", error, "error [Pa]")
        rate = (1.0 - exp(-time / scope["time_constant"])) / time * error - disturbance
        rate = clip(rate, -LARGEST_RATE, LARGEST_RATE)
        rate = where(error * error > scope["hold_band"] * scope["hold_band"], rate, 0.0)
        scope.label("new_rate", rate, "requested pressure rate [Pa/s]")
        fill_rate, vent_rate = self._open_rates(scope, effective)
        scope.label("fill_rate", fill_rate, "pressure rate with an open fill valve [Pa/s]")
        scope.label("vent_rate", vent_rate, "pressure rate with an open vent valve [Pa/s]")
        limits = {"fill_limit": scope["fill_limit"], "vent_limit": scope["vent_limit"]}
        fill, vent = openings_for_rate(rate, fill_rate, vent_rate, **limits)
        exceeds_fill = where(rate > scope["fill_limit"] * fill_rate, fill, 0.0)
        is_cut = where(exceeds_fill + where(-rate > scope["vent_limit"] * vent_rate, vent, 0.0) > 0.0, 1.0, 0.0)
        fill = where(is_safe > 0.5, clip(scope["safe_command"], 0.0, scope["fill_limit"]), fill)
        vent = where(is_safe > 0.5, clip(-scope["safe_command"], 0.0, scope["vent_limit"]), vent)
        scope.label("fill", fill, "opening of the fill valve")
        scope.label("vent", vent, "opening of the vent valve")
        delivered = fill * fill_rate - vent * vent_rate
        # A command that acts one sample later does not affect the next sample.
        scope.label("delivered", delivered, "pressure rate of both valves [Pa/s]")
        predicted = effective if self.acts == NEXT_SAMPLE else pressure + time * (delivered + disturbance)
        discrete = {"wanted_rate": rate, "disturbance": disturbance, "predicted_pressure": predicted}
        return fill - vent, vent, discrete | {"is_saturated": where(is_safe > 0.5, 0.0, is_cut)}
