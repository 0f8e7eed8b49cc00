"""Closed forms of the pilot stage: compression by the plate, choked venting, cooling at the wall, limited duties."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from poppet import Circuit, PilotStage, Recording, Reservoir
from poppet.signals import Points, Sine, Steps
from refusals import refused

V, KAPPA, R, T0, RHO0 = 5e-6, 1.4, 287.05, 293.15, 1.185
OPEN = {"sonic_conductance": 2e-10, "critical_ratio": 0.3}


def run(signals: dict[str, Any], duration: float = 1.0, step: float = 1e-3, **fields: Any) -> Recording:
    given: dict[str, Any] = {"volume": V, "fill": OPEN, "vent": OPEN, "initial_pressure": 4e5, **fields}
    parts = {"supply": Reservoir(pressure=7e5), "pilot": PilotStage(supply="supply", exhaust="ambient", **given)}
    driven = {f"pilot.{name}": signal for name, signal in signals.items()}
    return Circuit(parts, driven).simulate(duration, step, 1e-9)


def test_a_tight_adiabatic_pilot_is_compressed_along_the_isentrope():
    rec = run({"displacement": Points([0.0, 1.0], [0.0, 2e-6])})
    law = 4e5 * (V / (V + 2e-6 * rec.time)) ** KAPPA
    assert np.max(np.abs(rec["pilot.pressure"] / law - 1.0)) < 1e-7
    assert np.max(np.abs(rec["pilot.temperature"] / (T0 * (law / 4e5) ** (1.0 - 1.0 / KAPPA)) - 1.0)) < 1e-7


def kept_energy(rec: Recording, store: str) -> float:
    """What the balance of energy lacks, over all that went through."""
    (found,) = (each for each in rec.residuals if each.store == store and each.quantity == "energy")
    return found.error / (found.through + found.inventory)


@pytest.mark.parametrize("displacement", [Points([0.0, 0.4, 1.0], [0.0, 2e-6, -1e-6]), Sine(0.0, 2e-6, 3.0)])
def test_energy_is_kept_while_the_plate_moves_by_a_signal(displacement):
    moved = {"displacement": displacement, "fill_duty": Steps([0.0, 0.5], [1.0, 0.0])}
    rec = run(moved, wall_conductance=0.1, exhaust_leak=OPEN)
    assert np.ptp(rec["pilot.volume"]) > 2e-6
    assert np.max(np.abs(rec["pilot.work_rate"])) > 1.0
    assert kept_energy(rec, "pilot") < 1e-12


def test_work_of_the_plate_is_what_the_gas_gives_off():
    rec = run({"displacement": Points([0.0, 1.0], [0.0, 2e-6])})
    work = np.trapezoid(rec["pilot.work_rate"], rec.time)
    inner = (rec["pilot.pressure"] * rec["pilot.volume"])[[0, -1]] / (KAPPA - 1.0)
    assert work == pytest.approx(inner[1] - inner[0], rel=1e-6)
    assert work == pytest.approx(4e5 * V / (KAPPA - 1.0) * ((V / (V + 2e-6)) ** (KAPPA - 1.0) - 1.0), rel=1e-6)


def test_a_plate_that_moves_by_a_signal_begins_in_its_first_volume():
    rec = run({"displacement": Points([0.0, 1.0], [1e-6, 1e-6])})
    assert rec["pilot.pressure"] == pytest.approx(4e5, rel=1e-9)
    assert rec["pilot.mass"][0] == pytest.approx(4e5 * (V + 1e-6) / (R * T0))


def test_a_displacement_that_jumps_is_refused():
    with refused("signals.jumps", "signals.pilot.displacement"):
        run({"displacement": Steps([0.0, 0.5], [0.0, 1e-6])}, 1.0)
    polytropic = run({"displacement": Steps([0.0, 0.5], [0.0, 1e-6])}, 1.0, thermal="polytropic")
    assert polytropic["pilot.volume"][-1] == pytest.approx(V + 1e-6)


def test_a_tight_polytropic_pilot_is_compressed_along_its_polytrope():
    rec = run({"displacement": Points([0.0, 1.0], [0.0, -2e-6])}, thermal="polytropic", polytropic_exponent=1.2)
    law = 4e5 * (V / (V - 2e-6 * rec.time)) ** 1.2
    assert np.max(np.abs(rec["pilot.pressure"] / law - 1.0)) < 1e-7


@pytest.mark.parametrize("duty", [0.25, 1.0])
def test_choked_venting_follows_the_adiabatic_closed_form(duty):
    rec = run({"vent_duty": Steps([0.0], [duty])}, 0.05, 1e-4)
    tau = V / (duty * 2e-10 * RHO0 * R * T0)
    law = 4e5 * (1.0 + 0.5 * (KAPPA - 1.0) * rec.time / tau) ** (-2.0 * KAPPA / (KAPPA - 1.0))
    choked = law > 1e5 / 0.3
    assert np.count_nonzero(choked) > 10
    assert np.max(np.abs(rec["pilot.pressure"][choked] / law[choked] - 1.0)) < 1e-6


def test_choked_filling_of_a_polytropic_pilot_is_the_printed_equation():
    """p' = n R T q / V, with T of the polytrope: p^(1/n) rises in proportion to the time."""
    n = 1.3
    rec = run(
        {"fill_duty": Steps([0.0], [1.0])},
        0.03,
        1e-4,
        thermal="polytropic",
        polytropic_exponent=n,
        initial_pressure=1e5,
    )
    flow = 2e-10 * 7e5 * RHO0
    law = 1e5 * (1.0 + flow * rec.time / (1e5 * V / (R * T0))) ** n
    choked = law < 0.3 * 7e5
    assert np.count_nonzero(choked) > 10
    assert np.max(np.abs(rec["pilot.pressure"][choked] / law[choked] - 1.0)) < 1e-6


def test_a_closed_pilot_cools_at_its_wall_in_its_time_constant():
    """At constant volume and mass the temperature relaxes with m cv / (h A)."""
    rec = run({}, 1.0, wall_conductance=0.1, wall_temperature=350.0)
    mass = 4e5 * V / (R * T0)
    tau = mass * R / (KAPPA - 1.0) / 0.1
    law = 350.0 + (T0 - 350.0) * np.exp(-rec.time / tau)
    assert np.max(np.abs(rec["pilot.temperature"] - law)) < 1e-4


def test_the_volume_stays_above_a_tenth():
    rec = run({"displacement": Points([0.0, 0.01], [0.0, -6e-6])}, 0.01)
    assert kept_energy(rec, "pilot") < 1e-12
    assert rec["pilot.volume"][-1] == pytest.approx(0.1 * V)


def test_a_limited_opening_rises_at_its_rate_and_comes_to_rest_at_the_duty():
    limited = {**OPEN, "rate_limit": 20.0}
    rec = run({"fill_duty": Steps([0.0, 0.1], [0.8, 0.2])}, 0.2, 1e-3, fill=limited)
    rising = rec.time < 0.039
    assert np.max(np.abs(rec["pilot.fill_opening"][rising] - 20.0 * rec.time[rising])) < 1e-6
    assert rec["pilot.fill_opening"][99] == pytest.approx(0.8, abs=1e-6)
    falling = (rec.time > 0.1) & (rec.time < 0.129)
    assert np.max(np.abs(rec["pilot.fill_opening"][falling] - (0.8 - 20.0 * (rec.time[falling] - 0.1)))) < 1e-6
    assert rec["pilot.fill_opening"][-1] == pytest.approx(0.2, abs=1e-6)


@pytest.mark.parametrize(
    ("duty", "opening"), [(0.1, 0.0), (0.19, 0.0), (0.3, 0.25), (0.8, 0.75), (0.9, 1.0), (1.0, 1.0)]
)
def test_the_averaged_opening_has_the_dead_band_of_the_delays(duty, opening):
    """At 100 Hz 2 ms until it opens and 1.5 ms until it closes: nothing up to 0.2, d - 0.05 between, all from 0.85."""
    slow = {**OPEN, "frequency": 100.0, "opening_delay": 2e-3, "closing_delay": 1.5e-3}
    rec = run({"fill_duty": Steps([0.0], [duty])}, 0.01, fill=slow)
    assert rec["pilot.fill_opening"][-1] == pytest.approx(opening, abs=1e-12)


def test_leaks_flow_without_a_command():
    rec = run({}, 0.01, supply_leak={"sonic_conductance": 1e-12}, exhaust_leak={"sonic_conductance": 2e-12})
    first = {name: rec[f"pilot.{name}_leak_mass_flow_rate"][0] for name in ("supply", "exhaust")}
    ellipse = math.sqrt(1.0 - ((4.0 / 7.0 - 0.3) / 0.7) ** 2)
    assert first["supply"] == pytest.approx(1e-12 * 7e5 * RHO0 * ellipse, rel=1e-6)
    assert first["exhaust"] == pytest.approx(2e-12 * 4e5 * RHO0, rel=1e-6)
