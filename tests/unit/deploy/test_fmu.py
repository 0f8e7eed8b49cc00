"""Tests of FMUs in importers: values equal those of Python; functions of FMI."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
import zipfile
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from circuits_of_exports import check_and_relief
from poppet import loads
from poppet.cli.main import run as run_command
from poppet.deploy.fmu.importers import read_circuit
from poppet.deploy.fmu.package import build_fmu, zip_bytes
from poppet.engine.call import Call
from refusals import refused
from unit.deploy.fmus import COMPILER, EXAMPLES, Host, build, built, example, fmpy_run, held

FMI = pytest.mark.parametrize("fmi", [2, 3])
POINTS = [round(0.1 * k, 1) for k in range(31)]
SHOWN = ("tank.pressure", "tank.mass", "valve.stroke", "valve.supply_mass_flow_rate")


@FMI
@pytest.mark.parametrize(
    ("name", "duration"), [("fill_staircase", None), ("pressure_control", 2.0), ("two_tanks", None)]
)
def test_cosimulation_has_the_values_and_steps_of_the_kernel(fmi: int, name: str, duration: float | None) -> None:
    row = held(built(name, fmi, duration), example(name, duration), "fmu cs", fmi)
    assert row.why is None
    assert len(row.differences) > 8
    assert row.overall == 0.0


@FMI
@pytest.mark.parametrize(("name", "duration"), [("fill_staircase", 30.0), ("two_tanks", None)])
def test_model_exchange_by_cvode(fmi: int, name: str, duration: float | None) -> None:
    row = held(built(name, fmi, duration), example(name, duration), "fmu me", fmi)
    assert row.verdict == "within"
    assert row.until == example(name, duration).run.grid()[-1]
    assert 1e-12 < row.overall <= 1e-5


@pytest.mark.parametrize(("name", "duration"), [("fill_staircase", 3.0), ("pressure_control", 0.2)])
def test_a_second_importer_gives_the_same_bits(name: str, duration: float) -> None:
    """The steps of libcosim end at the output times of Python."""
    pytest.importorskip("libcosimpy", reason="the second host of FMUs is not installed")
    row = held(built(name, 2, duration), example(name, duration), "fmu cs (second host)")
    assert row.why is None
    assert row.overall == 0.0


@FMI
def test_one_long_step_equals_the_run(fmi: int) -> None:
    circuit = example("fill_staircase")
    run = Call(circuit.problem(circuit.run)).run()
    with Host(built("fill_staircase", fmi)).begin() as host:
        host.step(0.0, 120.0)
        index = circuit.model.columns[0].index("tank.pressure")
        assert host.get("tank.pressure")[0] == pytest.approx(run.values[index, -1], rel=1e-12)


@FMI
def test_reset_and_two_instances(fmi: int) -> None:
    path = built("fill_staircase", fmi, 3.0)
    with Host(path).begin() as first, Host(path).begin() as second:
        single_run = first.run(POINTS, *SHOWN)
        # The second begins while the first has a run behind it, and the first anew beside it.
        first.fmu.reset()
        first.begin()
        parallel_runs = [(first.run(p, *SHOWN)[0], second.run(p, *SHOWN)[0]) for p in map(list, pairwise(POINTS))]
    assert [a for a, _ in parallel_runs] == single_run
    assert [b for _, b in parallel_runs] == single_run


@FMI
def test_a_restored_state_continues_exactly(fmi: int) -> None:
    with Host(built("pressure_control", fmi, 2.0)).begin() as host:
        names = [v.name for v in host.description.modelVariables if v.causality in ("output", "local")]
        host.run(POINTS[:8], *names)
        suffix = "FMUstate" if fmi == 2 else "FMUState"
        get, put = getattr(host.fmu, f"get{suffix}"), getattr(host.fmu, f"set{suffix}")
        state = get()
        first = host.run(POINTS[7:15], *names)
        put(state)
        assert host.run(POINTS[7:15], *names) == first
        # Over bytes, into the same instance.
        serialise = getattr(host.fmu, f"serialize{suffix}")
        back = getattr(host.fmu, f"{'deSerialize' if fmi == 2 else 'deserialize'}{suffix}")
        put(back(serialise(state)))
        assert host.run(POINTS[7:15], *names) == first


@FMI
def test_results_do_not_depend_on_the_length_of_steps(fmi: int) -> None:
    path = built("fill_staircase", fmi, 3.0)
    with Host(path).begin() as even, Host(path).begin() as uneven:
        (expected,) = even.run(POINTS, *SHOWN)[-1:]
        (final,) = uneven.run([0.0, 0.001, 0.4, 0.41, 1.7, 2.999, 3.0], *SHOWN)[-1:]
    np.testing.assert_allclose(final, expected, rtol=1e-5)


@FMI
def test_parameters_change_between_runs_and_within_a_run(fmi: int) -> None:
    circuit = example("two_tanks")
    changed = circuit.with_values({"high.volume": 0.02})
    names, _ = circuit.model.columns
    k, end = names.index("high.pressure"), float(circuit.run.grid()[-1])
    with Host(built("two_tanks", fmi), follows=False).begin() as host:
        host.step(0.0, end)
        old_pressure = host.get("high.pressure")[0]
        host.fmu.reset()
        host.begin(high__volume=0.02)
        host.step(0.0, end)
        new_pressure = host.get("high.pressure")[0]
        # A start value, which is of no use any more once a run has begun.
        with pytest.raises(Exception, match="status 3"):
            host.set("high.initial_pressure", 3e5)
    run, changed_run = (Call(variant.problem(variant.run)).run() for variant in (circuit, changed))
    assert old_pressure == pytest.approx(run.values[k, -1], rel=1e-12)
    assert new_pressure == pytest.approx(changed_run.values[k, -1], rel=1e-12)
    assert abs(new_pressure - old_pressure) > 1.0


@FMI
@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("fill_staircase", {"tank.volume": 0.13, "tank.initial_pressure": 1.7e5, "bleed.sonic_conductance": 2e-8}),
        ("pressure_control", {"tank.volume": 0.002, "tank.initial_pressure": 1.7e5, "regulator.gain": 4e-5}),
    ],
)
def test_changed_parameters_act_like_with_values(fmi: int, name: str, changes: dict[str, float]) -> None:
    duration = 3.0 if name == "fill_staircase" else 2.0
    end = 0.9995 * duration  # at no instant: a host is shown what comes after it
    circuit = example(name).with_values({**changes, "run.duration": end, "run.output_step": end})
    run, names = Call(circuit.problem(circuit.run)).run(), circuit.model.columns[0]
    with Host(built(name, fmi, duration)).begin(**changes) as host:
        outputs = [v.name for v in host.description.modelVariables if v.causality == "output" and v.name in names]
        host.step(0.0, end)
        last_values = host.get(*outputs)
    series = [run.values[names.index(output)] for output in outputs]
    assert len(series) > 3
    for value, expected in zip(last_values, series, strict=True):
        assert value == pytest.approx(expected[-1], rel=1e-9, abs=1e-9 * np.max(np.abs(expected)))


@FMI
def test_invalid_parameters_give_an_error_status_and_a_message(fmi: int) -> None:
    path = built("fill_staircase", fmi, 3.0)
    with Host(path) as host:
        wrong = (-1.0, 0.0, 1e-300, 1e300, float("nan"), float("inf"))
        for value in wrong:
            with pytest.raises(Exception, match="status 3"):
                host.set("tank.volume", value)
        assert [status for status, _ in host.log] == [3] * len(wrong)
        # Each within its limits, and together nothing that one can compute with: the gas of a tank in a speck.
        host.begin()
        host.step(0.0, 0.1)
        host.set("tank.volume", 1e-18)
        with pytest.raises(Exception, match="status 2"):
            host.step(0.1, 0.1)
        assert host.log[-1][0] == 2
        assert host.get("time") == [0.1]
        host.fmu.reset()
        host.begin()
        host.step(0.0, 0.1)
        assert host.get("tank.pressure")[0] > 1e5
    with Host(path, "ModelExchange").begin() as host:
        n = host.description.numberOfContinuousStates
        x, found = (ctypes.c_double * n)(), (ctypes.c_double * n)()
        host.fmu.getContinuousStates(x, n)
        host.fmu.setContinuousStates((ctypes.c_double * n)(*[1e308] * n), n)
        derivatives = host.fmu.getDerivatives if fmi == 2 else host.fmu.getContinuousStateDerivatives
        rates = [name for name in host.references if name.startswith("der(")]
        for call in (lambda: derivatives(found, n), lambda: host.get(*rates)):
            with pytest.raises(Exception, match="status 2"):
                call()
        assert [status for status, _ in host.log] == [2, 2]
        host.fmu.setContinuousStates(x, n)
        derivatives(found, n)
        assert np.all(np.isfinite(list(found)))


@FMI
def test_a_refused_parameter_keeps_its_value(fmi: int) -> None:
    """Between events of model exchange nothing but inputs may change."""
    with Host(built("fill_staircase", fmi, 3.0, ("tank.volume", "bleed.opening")), "ModelExchange").begin() as host:
        host.fmu.enterContinuousTimeMode()
        conductance = host.get("bleed.sonic_conductance")
        with pytest.raises(Exception, match="status 3"):
            host.set("bleed.sonic_conductance", 2.0 * conductance[0])
        assert host.get("bleed.sonic_conductance") == conductance
        host.set("tank.volume", 0.1)  # an input
        host.fmu.enterEventMode()
        host.set("bleed.sonic_conductance", 2.0 * conductance[0])
        assert host.get("bleed.sonic_conductance", "tank.volume") == [2.0 * conductance[0], 0.1]


@FMI
def test_a_saved_state_continues_in_another_instance(fmi: int) -> None:
    path = built("pressure_control", fmi, 2.0)
    own = "FMUstate" if fmi == 2 else "FMUState"
    back = f"{'deSerialize' if fmi == 2 else 'deserialize'}{own}"
    with Host(path).begin() as first, Host(path) as second, Host(path, "ModelExchange").begin() as exchange:
        first.run(POINTS[:8], "tank.pressure")
        bytes_ = getattr(first.fmu, f"serialize{own}")(getattr(first.fmu, f"get{own}")())
        # Not initialised: the state says that it is.
        getattr(second.fmu, f"set{own}")(getattr(second.fmu, back)(bytes_))
        both = [host.run(POINTS[7:15], "tank.pressure", "regulator.command") for host in (first, second)]
        assert both[0] == both[1]
        with pytest.raises(Exception, match="status 3"):
            getattr(exchange.fmu, f"set{own}")(getattr(exchange.fmu, back)(bytes_))
        for wrong in (bytes_[:-8], b"x" + bytes(bytes_)[1:]):
            with pytest.raises(Exception, match="status 3"):
                getattr(second.fmu, back)(wrong)


@FMI
def test_the_log_has_its_categories(fmi: int) -> None:
    path = built("fill_staircase", fmi, 3.0)
    with zipfile.ZipFile(path) as archive:
        root = ElementTree.fromstring(archive.read("modelDescription.xml"))
    names = [category.get("name") for category in root.find("LogCategories")]  # type: ignore[union-attr]
    with Host(path) as host:
        host.fmu.setDebugLogging(True, names)
        assert host.log == []
        host.fmu.setDebugLogging(True, ["nonsense"])
        assert [status for status, _ in host.log] == [1]
        host.begin()
        with pytest.raises(Exception, match="status 3"):
            host.step(0.0, -1.0)
        assert host.log[-1][0] == 3


@FMI
def test_inputs_of_the_host(fmi: int) -> None:
    """An input or parameter that the host sets acts like a step of a signal in Python."""
    circuit = example("fill_staircase", 3.0)
    with Host(built("fill_staircase", fmi, 3.0, ("tank.volume", "bleed.opening")), follows=False).begin() as host:
        kinds = {v.name: v.causality for v in host.description.modelVariables}
        assert kinds["tank.volume"] == kinds["bleed.opening"] == kinds["valve.pilot_pressure"] == "input"
        old_pressure = host.get("tank.pressure")[0]
        host.step(0.0, 1.0)
        resting = host.get("tank.pressure")[0]
        host.set("valve.pilot_pressure", 5e5)
        host.step(1.0, 1.0)
        filling = host.get("tank.pressure")[0]
        host.set("bleed.opening", 0.0)
        assert host.get("bleed.mass_flow_rate")[0] == 0.0
        with pytest.raises(Exception, match="status 3"):
            host.set("valve.pilot_pressure", float("nan"))
    assert old_pressure == pytest.approx(circuit.parameters["tank.initial_pressure"])
    assert filling > resting + 1000.0


@FMI
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_inputs_outside_their_limits_saturate(fmi: int, kind: str) -> None:
    """Rounding errors saturate silently, larger deviations with one warning; only non-finite values are rejected."""
    path = built("fill_staircase", fmi, 3.0, ("tank.volume", "bleed.opening"))
    with Host(path, kind, follows=False).begin() as host:
        for value, limit in ((1.0000000000000002, 1.0), (-1e-17, 0.0), (1.0 + 9e-7, 1.0), (-9e-7, 0.0)):
            host.set("bleed.opening", value)
            assert host.get("bleed.opening") == [limit]
        assert host.log == []
        for value, limit in ((1.00001, 1.0), (1e6, 1.0), (-5.0, 0.0)):
            host.set("bleed.opening", value)
            assert host.get("bleed.opening") == [limit]
        assert [(status, "bleed.opening" in text) for status, text in host.log] == [(1, True)]
        host.set("valve.pilot_pressure", -1e5)
        assert host.get("valve.pilot_pressure") == [0.0]
        assert [status for status, _ in host.log] == [1, 1]
        for value in (float("nan"), float("inf"), -float("inf")):
            with pytest.raises(Exception, match="status 3"):
                host.set("bleed.opening", value)
        assert "bleed.opening" in host.log[-1][1]
        assert host.get("bleed.opening") == [0.0]
        volume = host.get("tank.volume")[0]
        host.set("tank.volume", -1.0)  # a parameter that is an input of this FMU
        assert 0.0 < host.get("tank.volume")[0] < 1e-9
        assert "tank.volume" in host.log[-1][1]
        host.set("tank.volume", volume)
        if kind == "CoSimulation":
            host.step(0.0, 0.1)
            assert host.get("time") == [pytest.approx(0.1)]
        n_messages = len(host.log)
        host.fmu.reset()
        host.set("bleed.opening", 7.0)
        assert len(host.log) == n_messages + 1


def test_a_saturated_input_gives_the_run_of_its_limit() -> None:
    """Co-simulation with an opening of 3, and with a slope that leaves the limits, as with an opening of 1."""
    path = built("fill_staircase", 2, 3.0, ("tank.volume", "bleed.opening"))
    ends = []
    for opening, slope in ((1.0, 0.0), (3.0, 0.0), (1.0, 5.0)):
        with Host(path, follows=False).begin() as host:
            host.set("bleed.opening", opening)
            host.fmu.setRealInputDerivatives([host.references["bleed.opening"]], [1], [slope])
            host.step(0.0, 1.0)
            ends.append(host.get("tank.pressure", "bleed.opening"))
            assert len(host.log) == (opening > 1.0 or slope > 0.0)
    assert ends[1] == ends[2] == ends[0]


def test_a_slope_ends_at_the_limit_of_its_input() -> None:
    """A slope that would leave the limits within a step is the slope that ends at the limit."""
    path = built("fill_staircase", 2, 3.0, ("tank.volume", "bleed.opening"))
    ends = []
    for slope in (0.5, 2.0):
        with Host(path, follows=False).begin() as host:
            host.set("bleed.opening", 0.5)
            host.fmu.setRealInputDerivatives([host.references["bleed.opening"]], [1], [slope])
            host.step(0.0, 1.0)
            ends.append(host.get("tank.pressure", "bleed.opening"))
    assert ends[0] == ends[1]
    assert ends[0][1] == 1.0


@FMI
def test_derivatives_along_a_direction(fmi: int) -> None:
    with Host(built("fill_staircase", fmi, 3.0), "ModelExchange").begin() as host:
        state, rate = host.references["tank.pressure"], host.references["der(tank.pressure)"]
        arguments = ([rate], [state], [1.0])
        derivative = host.fmu.getDirectionalDerivative(*arguments)[0]
        names = [v.name for v in host.description.modelVariables if v.causality != "independent"]
        x = host.get(*(v.name for v in host.description.modelVariables if f"der({v.name})" in names))
        index = [v.name for v in host.description.modelVariables if f"der({v.name})" in names].index("tank.pressure")
        slopes = []
        for sign in (1.0, -1.0):
            shifted = np.array(x)
            shifted[index] += sign * 1.0
            host.fmu.setContinuousStates(shifted.ctypes.data_as(ctypes.POINTER(ctypes.c_double)), len(shifted))
            slopes.append(host.get("der(tank.pressure)")[0])
    assert derivative == pytest.approx((slopes[0] - slopes[1]) / 2.0, rel=1e-4)


@FMI
def test_calls_that_are_not_allowed_return_an_error(fmi: int) -> None:
    with Host(built("fill_staircase", fmi, 3.0)) as host:
        for wrong in (lambda: host.step(0.0, 0.1), host.fmu.exitInitializationMode, lambda: host.get("tank.pressure")):
            with pytest.raises(Exception, match="status 3"):
                wrong()
        host.begin()
        host.step(0.0, 0.1)
        for begin, length in ((0.5, 0.1), (0.1, 0.0), (0.1, -0.1), (0.1, float("inf"))):
            with pytest.raises(Exception, match="status 3"):
                host.step(begin, length)
        with pytest.raises(Exception, match="status 3"):
            host.set("tank.pressure", 2e5)
        get, put = (host.fmu.getReal, host.fmu.setReal) if fmi == 2 else (host.fmu.getFloat64, host.fmu.setFloat64)
        for call in (lambda: get([10**6]), lambda: put([10**6], [1.0])):
            with pytest.raises(Exception, match="status 3"):
                call()
        # And goes on afterwards.
        host.step(0.1, 0.1)
        assert host.get("time") == [pytest.approx(0.2)]


@FMI
def test_a_stop_condition_ends_a_step_early(fmi: int, tmp_path: Path) -> None:
    """The time reached and the wish to end are told, in model exchange at the step that has passed it."""
    circuit = example("two_tanks").with_values({"run.stop_when": "low.pressure > 2 bar"})
    stopped = circuit.simulate()
    path = build(circuit, fmi, tmp_path / "stops.fmu")
    with Host(path, follows=False).begin() as host:
        if fmi == 2:
            with pytest.raises(Exception, match="status 2"):
                host.step(0.0, 300.0)
            found = host.fmu.getRealStatus(2)
            assert host.fmu.getBooleanStatus(3)
        else:
            _, ends, is_early, found = host.step(0.0, 300.0)
            assert (ends, is_early) == (True, False)  # FMPy does not allow early returns
        assert found == pytest.approx(stopped.time[-1], rel=1e-9)
        assert host.get("low.pressure")[0] == pytest.approx(2e5, rel=1e-6)
        with pytest.raises(Exception, match="status 3"):
            host.step(found, 1.0)
    with zipfile.ZipFile(path) as archive:
        assert fmi == 2 or b'mightReturnEarlyFromDoStep="true"' in archive.read("modelDescription.xml")
    rows = fmpy_run(path, "ModelExchange", 300.0)
    assert stopped.time[-1] < rows["time"][-1] + 1.0 < stopped.time[-1] + 3.0


@FMI
def test_start_time_is_arbitrary(fmi: int) -> None:
    """Signals begin where the run does."""
    path = built("fill_staircase", fmi, 3.0)
    rows = []
    for start in (0.0, 100.0):
        with Host(path).begin(start) as host:
            host.step(start, 1.0)
            host.step(start + 1.0, 1.0)
            rows.append(host.get(*SHOWN))
            assert host.get("time") == [pytest.approx(start + 2.0)]
    np.testing.assert_allclose(rows[1], rows[0], rtol=1e-9)


def test_inputs_follow_the_derivative_that_the_importer_sets(tmp_path: Path) -> None:
    """A ramp that the host gives by slopes over long steps is the ramp of a signal in Python."""
    circuit = check_and_relief()
    path = build(circuit, 2, tmp_path / "ramp.fmu")
    ends = [2.0, 4.0, 5.0]
    with Host(path, follows=False).begin() as host:
        reference, time = host.references["line.pressure"], 0.0
        for end, begin, slope in zip(ends, (2e5, 8e5, 1e5), (3e5, -3.5e5, 0.0), strict=True):
            host.set("line.pressure", begin)
            host.fmu.setRealInputDerivatives([reference], [1], [slope])
            host.step(time, end - time)
            time = end
        with pytest.raises(Exception, match="status 3"):
            host.fmu.setRealInputDerivatives([reference], [2], [1.0])
        pressure = host.get("vessel.pressure")[0]
    assert pressure == pytest.approx(circuit.simulate()["vessel.pressure"][-1], rel=1e-6)


@FMI
def test_linked_models_share_no_symbol(fmi: int, tmp_path: Path) -> None:
    """Sources with the function prefix of the standard, as C++ too."""
    assert COMPILER is not None
    if shutil.which("nm") is None:
        pytest.skip("there is no nm on this machine")
    with zipfile.ZipFile(built("two_tanks", fmi)) as archive:
        for name in archive.namelist():
            if name.startswith("sources/"):
                (tmp_path / Path(name).name).write_bytes(archive.read(name))
    names = set()
    for options, prefix in ((["-std=c99"], "one_"), (["-x", "c++"], "two_")):
        for source in (f"fmi{fmi}.c", "model.c"):
            command = [COMPILER, *options, "-Wall", "-Werror", f"-DFMI{fmi}_FUNCTION_PREFIX={prefix}", "-c", source]
            subprocess.run([*command, "-o", f"{prefix}{source}.o"], cwd=tmp_path, check=True)
            listing = subprocess.run(
                ["nm", "--defined-only", "--extern-only", f"{prefix}{source}.o"], cwd=tmp_path, capture_output=True,
                text=True, check=True,
            )  # fmt: skip
            symbols = {line.split()[-1] for line in listing.stdout.splitlines()}
            assert symbols
            # A name of C++ without C linkage would be mangled.
            assert all(name.startswith(prefix) for name in symbols), symbols
            names |= symbols
    assert len(names) > 60


@FMI
def test_calls_in_a_wrong_state_return_an_error(fmi: int) -> None:
    """Functions of one kind in an instance of the other, and without an instance."""
    names = ["EnterEventMode", "EnterContinuousTimeMode", *(["GetDerivatives"] if fmi == 2 else [])]
    with Host(built("fill_staircase", fmi, 3.0)).begin() as steps:
        for name in names:
            for instance in (steps.fmu.component, None):
                function = getattr(steps.fmu.dll, f"fmi{fmi}{name}")
                function.argtypes = None
                buffer = (ctypes.c_double * 99)()
                assert function(ctypes.c_void_p(instance), buffer, ctypes.c_size_t(99)) == 3, name
        assert steps.get("tank.pressure")[0] > 0.0
    with Host(built("fill_staircase", fmi, 3.0), "ModelExchange").begin() as exchange:
        step = getattr(exchange.fmu.dll, f"fmi{fmi}DoStep")
        step.argtypes = None
        results = [ctypes.byref(ctypes.c_double()) for _ in range(4)]
        begin, length = ctypes.c_double(0.0), ctypes.c_double(0.1)
        assert step(ctypes.c_void_p(exchange.fmu.component), begin, length, 0, *results) == 3
        with pytest.raises(Exception, match="status 3"):
            exchange.fmu.setTime(float("nan"))


def test_an_fmu_is_compared_with_the_circuit_that_it_contains(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("poppet.deploy.fmu.binaries.has_zig", lambda: False)
    file, path = str(EXAMPLES / "two_tanks.toml"), tmp_path / "tanks.fmu"
    changes = ["--set", "run.duration=10 s", "--set", "high.volume=0.02"]
    assert run_command(["export", "fmu", file, "-o", str(path), *changes]) == 0
    assert read_circuit(path).parameters["high.volume"] == 0.02
    capsys.readouterr()
    assert run_command(["export", "check", str(path), "--only", "fmu cs,scipy"]) == 0
    output = capsys.readouterr().out
    assert "fmu cs" in output
    assert "scipy" not in output
    # Held beside another circuit it is found out.
    assert run_command(["export", "check", str(path), "--circuit", file, "--duration", "10 s", "--only", "fmu cs"]) == 1
    with refused("deploy.fmu.no_circuit", name="two_tanks.fmu"):
        read_circuit(Path(shutil.copy(built("two_tanks", 2), tmp_path / "two_tanks.fmu")))


@FMI
def test_the_same_circuit_gives_the_same_bytes(fmi: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("poppet.deploy.fmu.binaries.has_zig", lambda: False)
    built("two_tanks", fmi)
    first, second = (zip_bytes(build_fmu(example("two_tanks"), fmi=fmi).content) for _ in range(2))
    assert first == second == built("two_tanks", fmi).read_bytes()


@FMI
def test_description(fmi: int) -> None:
    """Units with exponents and what is shown, dependencies that the equations have, limits, start values."""
    with zipfile.ZipFile(built("fill_staircase", fmi, 3.0)) as archive:
        root = ElementTree.fromstring(archive.read("modelDescription.xml"))
    pascal = next(u for u in root.iter("Unit") if u.get("name") == "Pa")
    assert pascal.find("BaseUnit").attrib == {"m": "-1", "kg": "1", "s": "-2"}  # type: ignore[union-attr]
    assert pascal.find("DisplayUnit").attrib == {"name": "bar", "factor": "1e-05"}  # type: ignore[union-attr]
    kelvin = next(u for u in root.iter("Unit") if u.get("name") == "K")
    assert kelvin.find("DisplayUnit").attrib == {"name": "degC", "offset": "-273.15"}  # type: ignore[union-attr]
    by_name = {v.get("name"): v for v in root.find("ModelVariables")}  # type: ignore[union-attr]
    volume = by_name["tank.volume"]
    assert (volume.get("causality"), volume.get("variability")) == ("parameter", "tunable")
    assert by_name["tank.initial_pressure"].get("variability") == "fixed"
    assert by_name["tank.mass"].get("initial") == "calculated"


def test_special_characters_are_escaped_and_invalid_inputs_are_refused() -> None:
    text = (EXAMPLES / "two_tanks.toml").read_text()
    title = "'/><script>&]]>../x"
    circuit = loads(f'title = "{title}"\n' + "\n".join(x for x in text.splitlines() if not x.startswith("title")))
    fmu = build_fmu(circuit, platforms=())
    root = ElementTree.fromstring(fmu.content["modelDescription.xml"])
    assert root.get("modelName").startswith("'/><script>&]]>")  # type: ignore[union-attr]
    identifier = root.find("CoSimulation").get("modelIdentifier")  # type: ignore[union-attr]
    assert identifier.isidentifier()  # type: ignore[union-attr]
    assert all(".." not in path and not path.startswith("/") for path in fmu.content)
    with refused("fields.not_an_option", value="amiga"):
        build_fmu(circuit, platforms=("amiga",))
    with refused("names.unknown", "high.volum"):
        build_fmu(circuit, inputs=("high.volum",))
    with refused("deploy.fmu.fixed_input", "ambient.pressure"):
        build_fmu(example("fill_staircase", 3.0), inputs=("ambient.pressure",), platforms=())


def test_without_a_compiler_the_fmu_has_sources_and_a_note(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("poppet.deploy.fmu.package.link_commands", lambda platform: [])
    fmu = build_fmu(example("two_tanks"), platforms=("linux64", "win64"))
    assert [(note.code, note.facts["platform"]) for note in fmu.notes] == [
        ("deploy.fmu.no_binary", "linux64"),
        ("deploy.fmu.no_binary", "win64"),
    ]
    assert [str(note) for note in fmu.notes]
    assert fmu.platforms == ()


@FMI
@pytest.mark.parametrize("standard", ["c99", "c90"])
def test_compiled_sources_give_the_same_results(fmi: int, standard: str, tmp_path: Path) -> None:
    path = built("fill_staircase", fmi, 3.0)
    with zipfile.ZipFile(path) as archive:
        content = {name: archive.read(name) for name in archive.namelist()}
    for name in content:
        if name.startswith("sources/"):
            (tmp_path / Path(name).name).write_bytes(content[name])
    strict = ["-Wall", "-Werror", *(["-pedantic"] if standard == "c90" and fmi == 2 else [])]
    flags = [f"-std={standard}", "-O1", "-fPIC", "-shared", "-fvisibility=hidden", "-ffp-contract=off", *strict]
    assert COMPILER is not None
    command = [COMPILER, *flags, "-o", "own.so", f"fmi{fmi}.c", "model.c", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    (binary,) = (name for name in content if name.startswith("binaries/"))
    compiled = tmp_path / "own.fmu"
    compiled.write_bytes(zip_bytes({**content, binary: (tmp_path / "own.so").read_bytes()}))
    row = held(compiled, example("fill_staircase", 3.0), "fmu cs", fmi)
    assert row.overall == 0.0


def exported(library: bytes) -> set[str]:
    """Names that a Windows library exports, from the table of its file."""

    def number(offset: int, size: int = 4) -> int:
        return int.from_bytes(library[offset : offset + size], "little")

    head = number(0x3C)
    optional = head + 24
    tables, sections = optional + 112, optional + number(head + 20, 2)

    def place(address: int) -> int:
        for k in range(number(head + 6, 2)):
            at = sections + 40 * k
            if 0 <= address - number(at + 12) < number(at + 8):
                return address - number(at + 12) + number(at + 20)
        raise AssertionError(address)

    table = place(number(tables))
    names = (place(number(place(number(table + 32)) + 4 * k)) for k in range(number(table + 24)))
    return {library[at : library.index(0, at)].decode() for at in names}


@FMI
@pytest.mark.slow
def test_windows_and_linux_libraries_export_the_same_functions(fmi: int) -> None:
    """Symbol by symbol; test_fmu_windows.py runs it where there is Wine."""
    pytest.importorskip("ziglang", reason="the extra fmu is not installed")
    fmu = build_fmu(example("two_tanks"), fmi=fmi, platforms=("linux64", "win64"))
    assert fmu.platforms == ("linux64", "win64")
    linux, windows = (next(v for k, v in fmu.content.items() if k.endswith(ending)) for ending in (".so", ".dll"))
    symbols = exported(windows)
    assert {name[:4] for name in symbols} == {f"fmi{fmi}"}
    header = fmu.content[f"sources/fmi{fmi}Functions.h"].decode()
    assert symbols == set(re.findall(rf"FMI{fmi}_Export fmi{fmi}\w+TYPE\s+(fmi{fmi}\w+);", header))
    assert all(name.encode() in linux for name in symbols)
