"""Notes of recordings: on the outcome, held signals, domains and balances."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import pytest

from poppet import Circuit, load
from poppet.circuit.options import GasChoice
from poppet.core.codes import Note
from poppet.engine import solve as simulate
from poppet.engine.balances import Residual
from poppet.engine.problem import Outcome
from poppet.parts import Chamber, DirectionalValve, FlowSource, MainStage, Orifice, Reservoir
from poppet.signals import Constant, Points, SampledSignal, Steps

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"

SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}


def filling(signals: Any = None, **fields: Any) -> Circuit:
    return Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", **(fields or SIZE)),
            "tank": Chamber(volume="10 l"),
        },
        signals or {},
    )


def notes(circuit: Circuit, *arguments: Any, **options: Any) -> tuple[Note, ...]:
    return circuit.simulate(*arguments, **options).remarks


def test_usual_run_has_no_notes():
    assert notes(filling({"fill.opening": Constant(0.5)}), "1 s") == ()


def test_assumed_ratio_gives_a_note():
    note = Note("parts.assumed_ratio", "fill.critical_ratio", size="nominal_flow")
    assert notes(filling(nominal_flow="380 l/min ANR"), "1 s") == (note,)
    changed = filling(nominal_flow="380 l/min ANR").with_values({"fill.laminar_ratio": 0.99})
    assert notes(changed, "1 s") == (note,)
    assert notes(filling(nominal_flow="380 l/min ANR", critical_ratio=0.3), "1 s") == ()
    assert notes(filling(effective_area="10 mm^2"), "1 s") == ()


@pytest.mark.parametrize("thermal", ["isothermal", "isentrope"])
def test_unused_wall_parameters_give_a_note(thermal):
    """The parameters of the wall have no effect, and the run has a note on them."""
    circuit = filling()
    walled = circuit.with_values({"tank.wall_conductance": "45 W/K", "tank.wall_temperature": "30 degC"})
    without_wall, run = (c.with_values({"tank.thermal": thermal}).simulate("1 s") for c in (circuit, walled))
    assert without_wall.remarks == ()
    (note,) = run.remarks
    assert (note.code, note.address) == ("chamber.no_effect", "tank.wall_conductance")
    assert note.facts["law"] == thermal
    assert run["tank.pressure"].tolist() == without_wall["tank.pressure"].tolist()


def test_gas_gives_a_note():
    circuit = filling()
    (note,) = notes(dataclasses.replace(circuit, gas=GasChoice(name="helium")), "0.1 s")
    assert note.code == "options.conductances_as_given"
    (scaled,) = notes(dataclasses.replace(circuit, gas=GasChoice(name="helium", conductances="from air")), "0.1 s")
    assert (scaled.code, scaled.facts["factor"]) == ("options.conductances_from_air", pytest.approx(0.39, abs=0.01))


def test_stroke_outside_the_domain_gives_a_note():
    circuit = filling({"fill.stroke": Points([0.0, 1.0], [0.0, 1.5e-3])}, characteristic="varga2012")
    (note,) = notes(circuit, "1 s")
    assert (note.code, note.address) == ("curves.left_domain", "fill.stroke")
    assert (note.facts["strokes_mm"], note.facts["beyond_mm"]) == (pytest.approx((1.5,)), pytest.approx(0.5))


def test_small_overtravel_at_a_stop_gives_no_note():
    circuit = filling({"fill.stroke": Points([0.0, 1.0], [0.0, 1.005e-3])}, characteristic="varga2012")
    assert notes(circuit, "1 s") == ()


@pytest.mark.parametrize("volume", ["5 l", "50 l"])
def test_impact_on_a_stop_is_inside_the_domain(volume):
    """The plate moves 10 to 14 um into its stop, which is more than the tolerance of a driven stroke."""
    circuit = load(EXAMPLES / "regulator_parts.toml").with_values({"tank.volume": volume})
    recording = circuit.simulate()
    assert recording.remarks == ()
    soft = circuit.with_values({"main.upper_stop.stiffness": 1e8}).simulate()
    (note,) = soft.remarks
    assert (note.code, note.address) == ("curves.left_domain", "main.stroke")
    assert note.facts["beyond_mm"] > 0.05
    assert len(note.facts["strokes_mm"]) == 1  # below zero the passage is closed: nothing was left there


def test_excursion_between_two_rows_gives_a_note():
    """The position of a valve is checked at all steps of the solver, not only at the output times."""
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "tank": Chamber(volume="1 m^3"),
        "valve": MainStage(
            supply="supply", outlet="tank", exhaust="ambient", data="varga2012", upper_stop={"position": "1.3 mm"}
        ),
    }
    pulse = {"valve.pilot_pressure": Steps([0.0, 0.2, 0.3], [2e5, 9e5, 2e5])}
    recording = Circuit(parts, pulse).simulate("1 s", "0.5 s")
    assert recording["valve.stroke"].max() < 1e-3
    assert [(note.code, note.address) for note in recording.remarks] == [("curves.left_domain", "valve.stroke")]


def test_signal_held_after_its_last_point():
    circuit = filling({"supply.pressure": Points([0.0, 2.0], [7e5, 6e5])})
    assert notes(circuit, "5 s") == (Note("signals.held_after", "supply.pressure", source="", value=6e5, time=2.0),)
    assert notes(circuit, "2 s") == ()


def test_measured_signal_held_at_both_ends():
    circuit = filling({"supply.pressure": SampledSignal((1.0, 2.0), (7e5, 6e5), "bench.csv")})
    assert notes(circuit, "5 s") == (
        Note("signals.held_before", "supply.pressure", source="bench.csv", value=7e5, time=1.0),
        Note("signals.held_after", "supply.pressure", source="bench.csv", value=6e5, time=2.0),
    )


def test_steps_after_the_end_give_a_note():
    circuit = filling({"fill.opening": Steps([0.0, 2.0, 9.0], [1.0, 0.5, 0.0])})
    assert notes(circuit, "5 s") == (Note("signals.steps_unused", "fill.opening", unused=1, total=3, end=5.0),)


def test_notes_of_a_delayed_signal_include_the_delay():
    valve = DirectionalValve(supply="supply", outlet="tank", **SIZE, delay="0.5 s")
    parts = {"supply": Reservoir(pressure="7 bar"), "valve": valve, "tank": Chamber(volume="10 l")}
    circuit = Circuit(parts, {"valve.command": Points([0.0, 1.0], [0.0, 1.0])})
    assert notes(circuit, "5 s") == (Note("signals.held_after", "valve.command", source="", value=1.0, time=1.5),)


def test_notes_of_a_stopped_run_refer_to_its_end():
    circuit = filling({"supply.pressure": Points([0.0, 4.0], [7e5, 6e5])})
    assert notes(circuit, "20 s", stop_when="tank.pressure > 2 bar") == ()


def test_stalled_run_is_repeated_with_a_note(monkeypatch):
    """If the Rosenbrock method stalls, another method continues, and the run has a note."""
    original_run = simulate.run_kernel

    def stalled(problem: Any, progress: Any) -> Any:
        run = original_run(problem, progress)
        return dataclasses.replace(run, outcome=Outcome.STALLED, time=run.time[:11], values=run.values[:, :11])

    reference = filling().simulate("2 s", "0.1 s")
    monkeypatch.setattr(simulate, "run_kernel", stalled)
    recording = filling().simulate("2 s", "0.1 s")
    assert recording.remarks == (Note("run.handed_over", time=1.0, solver="cvodes"),)
    assert recording.ending.code == "run.done"
    assert recording["tank.pressure"] == pytest.approx(reference["tank.pressure"], rel=1e-5)


@pytest.mark.parametrize("solver", ["rosenbrock", "cvodes", "radau"])
def test_an_interrupted_run_of_another_solver_keeps_its_results(monkeypatch, solver):
    """Ctrl-C and time limits reach a run that another solver continues."""
    original_run = simulate.run_kernel
    monkeypatch.setattr(
        simulate, "run_kernel", lambda problem, _: dataclasses.replace(original_run(problem), outcome=Outcome.STALLED)
    )

    def interrupt(time: float) -> None:
        if time > 0.55:
            raise KeyboardInterrupt

    reference = filling().simulate("2 s", "0.1 s", solver="radau")
    recording = filling().simulate("2 s", "0.1 s", progress=interrupt, throw=False, solver=solver)
    assert recording.ending.code == "run.ended.interrupted"
    assert [note.code for note in recording.remarks] == ["run.handed_over"] * (solver == "rosenbrock")
    assert 0.45 < recording.time[-1] < 1.0
    rows = recording.time.size
    assert recording["tank.pressure"] == pytest.approx(reference["tank.pressure"][:rows], rel=1e-5)


def test_violated_balance_gives_a_note(monkeypatch):
    from poppet.circuit import notes as outcome

    monkeypatch.setattr(outcome, "residuals", lambda *_: (Residual("tank", "mass", "kg", 1e-3, 1.0, 1.0),))
    (note,) = notes(filling(), "1 s")
    assert (note.code, note.address) == ("run.not_conserved", "tank")
    assert (note.facts["quantity"], note.facts["error"], note.facts["unit"]) == ("mass", 1e-3, "kg")
    assert note.facts["allowed"] == pytest.approx(1e-9, rel=0.01)


def test_termination_reasons():
    assert filling().simulate("1 s").ending == Note("run.done")
    assert filling().simulate("20 s", stop_when="tank.pressure > 2 bar").ending.code == "run.condition_met"
    failed = Circuit({"tank": Chamber(volume="1 l"), "pull": FlowSource(to="tank", mass_flow_rate=-1e-3)}).simulate(
        "5 s", throw=False
    )
    assert (failed.ending.code, failed.ending.address) == ("run.emptied.stalled", "tank.mass")
    # Air at 28 K is no gas either.
    assert [note.code for note in failed.remarks] == ["gas.no_gas", "run.no_way_on"]


def test_condition_met_at_the_start_gives_a_note():
    recording = filling().simulate("20 s", stop_when="tank.pressure > 5")
    assert recording.time.tolist() == [0.0]
    assert recording.remarks == (Note("run.nothing_ran", condition="tank.pressure > 5"),)
    assert filling().simulate("20 s", stop_when="tank.pressure > 2 bar").remarks == ()
