"""Tasks of the editor: their functions against closed forms, and their processes as the server runs them."""

from __future__ import annotations

import base64
import csv
import io
import json
import os
import re
import sys
import time
import zipfile
from pathlib import Path

import numpy as np
import pytest

from poppet import load
from poppet.api import loads
from poppet.core.errors import InputError
from poppet.core.provenance import Number, Source
from poppet.edit.document import Document
from poppet.edit.tasks import fits, manager, process, runs, studies, tank_tests
from poppet.edit.tasks.facts import task_facts
from poppet.edit.tasks.kinds import TASKS
from poppet.edit.tasks.manager import Tasks, check_file_name
from poppet.edit.tasks.order import TaskOrder, written_value
from poppet.identify.recorded_columns import UserStatement
from poppet.identify.tank.tank_recording import interpret_tank
from poppet.report.control_report import file_margin_table, margin_table
from poppet.timeseries.tables.table import Table
from refusals import refused
from tank_discharge import excel_export

EXAMPLES = Path(__file__).parents[3] / "examples"
FILL = """
# filling
title = "Filling"
[parts.supply]
kind = "reservoir"
pressure = "9 bar g"
[parts.fill]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "0.1 dm^3/(s bar)"   # of the catalogue
critical_ratio = 0.5
[parts.tank]
kind = "chamber"
volume = "1 l"
thermal = "isothermal"
initial_pressure = "1 bar"
[run]
duration = "2 s"
output_step = "10 ms"
"""
RATE = 1.185 * 287.1 * 293.15
"""A choked flow fills an isothermal tank at 20 degC at the constant rate dp/dt = C p_up rho_0 R T / V (ISO 6358)."""
TIME_TO_3_BAR = {"of": "tank.pressure", "metric": "time_to", "value": "3 bar"}


@pytest.fixture
def job(tmp_path):
    """Return a function that makes a job for `FILL`."""
    (tmp_path / "output").mkdir()
    (tmp_path / "uploads").mkdir()
    steps = []

    def make(text=FILL, **options):
        places = {name: tmp_path / name for name in ("output", "uploads")}
        report = lambda *step: steps.append(step)  # noqa: E731
        return TaskOrder(text, "plant", folder=tmp_path, **places, options=options, report=report)

    make.steps = steps
    return make


@pytest.fixture
def tasks():
    with Tasks() as made:
        yield made


def ended(tasks, identifier, within=60.0):
    """Return the state of a task after its end."""
    limit = time.monotonic() + within
    while (content := tasks.content(identifier))["state"] == "running":
        assert time.monotonic() < limit, content
        time.sleep(0.02)
    return content


def start(tasks, task, text=FILL, folder=Path(), name="plant.toml", **options):
    return tasks.start(task, options, text=text, name=name, folder=folder, revision=7)


# --- Studies ---


def test_the_smallest_conductance_fills_the_tank_in_time(job):
    order = job(address="fill.sonic_conductance", metric=TIME_TO_3_BAR, requirement="<= 0.5 s")
    result = studies.size_parameter(order)
    exact = 1e-3 * 2e5 / (1e6 * RATE * 0.5)
    (operation,) = result.operations
    changed = loads(Document(FILL).apply([operation]).text)
    value = float(changed.parts["fill"].sonic_conductance)
    assert exact <= value <= exact * 1.002
    assert operation["value"].endswith(" dm^3/(s bar)")  # the unit of the text
    assert result.data["curve"]["bounds"] == [0.5]
    assert result.data["curve"]["value"] == pytest.approx(value * 1e8)
    assert job.steps


def test_a_gauge_pressure_is_sized(job):
    order = job(address="supply.pressure", low="4 bar g", high="12 bar g", metric=TIME_TO_3_BAR, requirement="<= 1.6 s")
    (operation,) = studies.size_parameter(order).operations
    changed = loads(Document(FILL).apply([operation]).text)
    value = changed.numbers()["supply.pressure"].absolute(1e5)
    assert value == pytest.approx(1e-3 * 2e5 / (1e-9 * RATE * 1.6), rel=2e-3)


def test_a_curve_without_a_requirement(job):
    order = job(address="tank.volume", low="0.5 l", high="4 l", metric=TIME_TO_3_BAR)
    result = studies.size_parameter(order)
    curve = result.data["curve"]
    assert (curve["x_unit"], curve["y_unit"], result.operations) == ("l", "s", ())
    exact = np.array(curve["x"]) * 1e-3 * 2e5 / (1e-9 * 1e6 * RATE)
    late = exact > 2.0  # not reached in the run: null
    assert [y is None for y in curve["y"]] == late.tolist()
    assert [y for y in curve["y"] if y is not None] == pytest.approx(exact[~late].tolist(), rel=1e-3)


def test_a_curve_has_the_usual_units(job):
    metric = {"of": "tank.pressure", "metric": "final"}
    curve = studies.size_parameter(job(address="tank.volume", low="2 l", high="4 l", metric=metric)).data["curve"]
    assert (curve["name"], curve["y_unit"]) == ("final of tank.pressure", "bar")
    assert curve["y"][0] == pytest.approx(1.0 + 1e-9 * 1e6 * RATE * 2.0 / 2e-3 / 1e5, rel=1e-3)


def test_a_parameter_is_sized_in_the_range_of_the_form(job):
    order = job(address="supply.pressure", metric=TIME_TO_3_BAR, requirement="<= 1.6 s")
    result = studies.size_parameter(order)
    low, high = task_facts(order.circuit)["parameters"]["supply.pressure"]["range"]
    assert (low, high) == ("2.33 bar g", "29 bar g")  # a third and three times 10 bar absolute
    assert [min(result.data["curve"]["x"]), max(result.data["curve"]["x"])] == pytest.approx([7 / 3, 29], rel=1e-3)
    assert "limited by time_to_tank_pressure" in result.text


def test_the_largest_value_is_within_the_range_of_the_form(job):
    order = job(address="supply.pressure", metric=TIME_TO_3_BAR, requirement="<= 1.6 s", extreme="largest")
    result = studies.size_parameter(order)
    (operation,) = result.operations
    changed = loads(Document(FILL).apply([operation]).text)
    assert changed.numbers()["supply.pressure"].absolute(1e5) == pytest.approx(30e5)  # three times 10 bar
    assert max(result.data["curve"]["x"]) == pytest.approx(29.0)


def test_no_value_meets_the_requirement(job):
    result = studies.size_parameter(job(address="tank.volume", metric=TIME_TO_3_BAR, requirement="< 0 s"))
    assert result.operations == ()
    assert "value" not in result.data["curve"]


@pytest.mark.parametrize(
    ("value", "is_largest", "holding", "expected"),
    [
        (1.23451, False, [(1.23451, 2.0)], 1.235),
        (1.23459, True, [(1.0, 1.23459)], 1.234),
        (1.23451, False, [(1.23451, 1.2346)], 1.23451),
        (0.0, False, [(0.0, 1.0)], 0.0),
    ],
)
def test_a_sized_value_is_rounded_to_the_safe_side(value, is_largest, holding, expected):
    assert studies._rounded(value, is_largest, holding) == expected


def test_an_ensemble_of_stated_spreads(job):
    pytest.importorskip("pyarrow")
    order = job(spreads={"tank.volume": "10 %"}, runs=64, metric=TIME_TO_3_BAR)
    result = studies.run_ensemble(order)
    rows = [*csv.DictReader(order.path("-ensemble.csv").read_text(encoding="utf-8").splitlines())]
    volumes = np.array([float(row["tank.volume"]) for row in rows])
    times = np.array([float(row["time_to_tank_pressure"]) for row in rows])
    # About 1 l takes 2 s: the run ends before for larger volumes.
    reached = np.isfinite(times)
    assert times[reached] == pytest.approx(volumes[reached] * 2e5 / (1e-9 * 1e6 * RATE), rel=1e-3)
    assert 0.9e-3 < volumes.min() < volumes.max() < 1.1e-3
    assert order.path("-ensemble.html").stat().st_size > 10_000
    assert "time_to_tank_pressure" in result.text


@pytest.mark.parametrize("metric", ["../metrics.py:peak", "metrics.py:peak", None, 3])
@pytest.mark.parametrize("task", [studies.run_ensemble, studies.size_parameter])
def test_a_metric_never_executes_python(job, metric, task):
    with refused("fields.not_an_option", "metric"):
        task(job(address="tank.volume", spreads={"tank.volume": 0.1}, metric={"of": "tank.pressure", "metric": metric}))


def test_a_metric_of_the_file_never_executes_python(job, tmp_path):
    (tmp_path / "own.py").write_text("raise SystemExit", encoding="utf-8")
    table = '[ensemble]\nruns = 2\nparameters = {"tank.volume" = {distribution = "uniform", relative_range = 0.1}}\n'
    metric = 'metrics = {own = {of = "tank.pressure", metric = "own.py:own"}}\n'
    with refused("ensemble.python_forbidden"):
        studies.run_ensemble(job(FILL + table + metric))


@pytest.mark.parametrize(("low", "high"), [("3 l", "1 l"), ("1 l", "1 l")])
def test_an_empty_range(job, low, high):
    with refused("size.range", "tank.volume"):
        studies.size_parameter(job(address="tank.volume", low=low, high=high, metric=TIME_TO_3_BAR))


def test_a_range_beyond_the_limits(job):
    with refused("fields.out_of_range", "high"):
        studies.size_parameter(job(address="fill.critical_ratio", high=1.5, metric=TIME_TO_3_BAR))


# --- Fits ---


def recorded(uploads, text=FILL, conductance=0.13, name="bench.csv"):
    """Write a recording of the circuit with another conductance, in bar g and ms."""
    circuit = loads(text).with_values({"fill.sonic_conductance": f"{conductance} dm^3/(s bar)"})
    recording = circuit.simulate()
    lines = [
        f"{1e3 * t:.6f};{p / 1e5 - 1.0:.9f}" for t, p in zip(recording.time, recording["tank.pressure"], strict=True)
    ]
    (uploads / name).write_text("\n".join(["time [ms];p_tank", *lines]), encoding="utf-8")


def test_a_recording_gives_the_parameter_of_the_circuit_that_made_it(job):
    order = job(
        recording="bench.csv",
        time={"column": "time", "unit": "ms"},
        columns={"tank.pressure": {"column": "p_tank", "unit": "bar g"}},
        free=["fill.sonic_conductance"],
    )
    recorded(order.uploads)
    result = fits.fit_parameters(order)
    (operation,) = result.operations
    assert operation["value"]["source"] == "fitted"
    # The uncertainty has a unit, as the value: without one it would read as one of the unit beside it.
    assert re.fullmatch(r"\+/- \S+ dm\^3/\(s bar\) \(determined\)", operation["value"]["note"])
    text = Document(FILL).apply([operation]).text
    assert "# of the catalogue" in text
    assert float(loads(text).parts["fill"].sonic_conductance) == pytest.approx(0.13e-8, rel=1e-4)
    assert order.path("-fit.toml").exists()
    assert order.path("-fit.html").exists()


def test_a_tank_test_is_interpreted_as_on_the_command_line(job):
    order = job(recording="export.csv", statements={"volume": "20 l", "opens": ""})
    path = excel_export(order.uploads / "export.csv")
    data = tank_tests.interpret_recording(order).data
    expected = interpret_tank(path, {"volume": UserStatement("20 l", "answer")})
    assert [(item["subject"], item["value"], tuple(item["origins"])) for item in data["items"]] == [*expected.items]
    assert [question["key"] for question in data["questions"]] == ["reference", "opens", "ambient"]
    assert base64.b64decode(data["picture"])[:4] == b"\x89PNG"
    with pytest.raises(InputError) as caught:
        tank_tests.fit_tank_test(order)
    assert (caught.value.code, caught.value.address) == ("question.unanswered", "reference")


def test_columns_are_proposed_by_names_and_units(job):
    order = job(recording="bench.csv")
    recorded(order.uploads)
    columns = fits.list_columns(order).data["columns"]
    assert [(row["name"], row["unit"], row["address"], row["is_time"]) for row in columns] == [
        ("time", "ms", "", True),
        ("p_tank", "", "tank.pressure", False),
    ]
    assert columns[1]["high"] == pytest.approx(0.13e-8 * 1e6 * RATE * 2.0 / 1e-3 / 1e5, rel=1e-3)


def test_a_pressure_without_a_reference_is_no_column(job):
    order = job(
        recording="bench.csv",
        time={"column": "time", "unit": "ms"},
        columns={"tank.pressure": {"column": "p_tank", "unit": "bar"}},
        free=["fill.sonic_conductance"],
    )
    recorded(order.uploads)
    with pytest.raises(InputError) as caught:
        fits.fit_parameters(order)
    assert (caught.value.code, caught.value.address) == ("edit.no_reference", "tank.pressure")
    of_poppet = {"tank.pressure": {"column": "tank.pressure", "unit": "bar"}}
    assert "tank.pressure" in fits.recording_table(
        job(recording="bench.csv", time={"column": "time"}, columns=of_poppet, free=[])
    )


def test_a_column_has_one_quantity_and_a_quantity_one_column():
    empty = np.zeros(3)
    names = ("t", "Tank pressure", "tank.pressure", "T_tank", "spool", "noise")
    table = Table(names, (empty,) * 6, ("s", "bar", "bar g", "degC", "mm", "V"))
    quantities = {"tank.pressure": "Pa", "tank.temperature": "K", "valve.spool": "m", "supply.pressure": "Pa"}
    proposed = fits.propose_columns(table, quantities, 0)
    assert proposed[2] == "tank.pressure"
    assert proposed[3] == "tank.temperature"
    assert 5 not in proposed
    assert len({*proposed.values()}) == len(proposed)


@pytest.mark.parametrize("name", ["../plant.toml", "/etc/passwd", "nothing.csv", "", ".hidden"])
def test_a_recording_outside_the_uploads(job, name):
    with refused("names.unknown", name):
        fits.list_columns(job(recording=name))


def test_a_column_cannot_name_a_file(job):
    order = job(
        recording="bench.csv",
        time={"column": "time", "unit": "ms"},
        columns={"tank.pressure": {"column": "p", "file": "/etc/passwd"}},
        free=[],
    )
    recorded(order.uploads)
    with refused("edit.no_column", "tank.pressure"):
        fits.fit_parameters(order)


@pytest.mark.parametrize("is_scheduled", [False, True])
def test_tuned_gains_are_applied_as_in_python(job, is_scheduled):
    from poppet.control import schedule, tune

    file = EXAMPLES / "pressure_control.toml"
    text = file.read_text(encoding="utf-8")
    result = fits.tune_controller(job(text, form="pi", schedule=is_scheduled))
    changed = loads(Document(text).apply(result.operations).text)
    expected = (schedule if is_scheduled else tune)(load(file), form="pi").applied(load(file))
    numbers = expected.numbers()
    for address, number in changed.numbers().items():
        assert float(number.value) == pytest.approx(float(numbers[address].value), rel=1e-5), address
    assert changed.numbers().keys() == numbers.keys()
    tuning = (schedule if is_scheduled else tune)(load(file), form="pi")
    tables = result.text.partition("With the present gains:\n")
    assert tables[0].rstrip().endswith(margin_table(tuning).text())
    assert tables[2] == file_margin_table(tuning, load(file)).text()


@pytest.mark.parametrize(
    ("value", "unit", "text", "expected"),
    [
        (7e5, "Pa", "9 bar g", "6 bar g"),
        (7e5, "Pa", "600 kPa", "700 kPa"),
        (2.5e-3, "s", "", "2.5 ms"),
        (0.25, "1", "0.3", 0.25),
        (300.0, "K", "20 degC", "26.85 degC"),
    ],
)
def test_a_value_has_the_unit_of_the_user(value, unit, text, expected):
    assert written_value(value, unit, Number(1.0, unit, Source("given"), text=text)) == expected


# --- Runs ---


def test_the_report_of_a_run(job):
    order = job()
    result = runs.write_report(order)
    assert "complete" in result.text
    assert "Filling" in order.path(".html").read_text(encoding="utf-8")
    assert order.path(".csv").read_text(encoding="utf-8").count("\n") == 202


def test_an_export_of_several_files_is_an_archive(job):
    order = job(target="c")
    runs.export_circuit(order)
    with zipfile.ZipFile(order.path("-c.zip")) as archive:
        names = archive.namelist()
    assert "plant-c/CMakeLists.txt" in names or any(name.endswith(".c") for name in names)
    assert all(name.startswith("plant-c/") and ".." not in name for name in names)


def test_a_live_page_is_one_file(job):
    order = job(target="live")
    runs.export_circuit(order)
    assert [path.name for path in order.output.iterdir()] == ["plant.html"]


@pytest.mark.parametrize(("target", "option"), [("live", {"part": "fill"}), ("c", {"fmi": "2"})])
def test_an_option_of_another_target(job, target, option):
    with refused("fields.unknown", *option):
        runs.export_circuit(job(target=target, **option))


# --- Declarations and facts ---


@pytest.mark.parametrize(
    ("task", "options", "code"),
    [
        ("rm", {}, "fields.not_an_option"),
        (None, {}, "fields.not_an_option"),
        (["report"], {}, "fields.not_an_option"),
        ("report", {"output": "/x"}, "fields.unknown"),
        ("report", [], "fields.no_table"),
        ("export", {}, "fields.missing"),
        ("export", {"target": 3}, "fields.other_type"),
        ("export", {"target": "fmu", "fmi": "9; rm"}, "fields.not_an_option"),
        ("export", {"target": "fmu", "platform": "linux64"}, "fields.unknown"),
        ("ensemble", {"runs": 10**9}, "fields.out_of_range"),
        ("identify", {"recording": "a.csv"}, "fields.missing"),
    ],
)
def test_invalid_options_start_no_process(tasks, task, options, code):
    with refused(code):
        tasks.start(task, options, text=FILL, name="plant.toml", folder=Path())
    assert tasks.contents() == []


def test_each_task_has_a_function():
    from poppet.core.plugins import import_object

    for kind in TASKS.values():
        assert callable(import_object(f"poppet.edit.tasks.{kind.function}"))


def test_facts_about_a_circuit():
    facts = task_facts(load(EXAMPLES / "pressure_control.toml"))
    assert facts["controllers"] == ["regulator"]
    assert facts["outputs"]["tank.pressure"] == "Pa"
    assert facts["parameters"]["tank.volume"]["unit"] == "m^3"
    assert facts["targets"]["st"]["needs_part"]
    assert not facts["has_ensemble"]
    assert task_facts(load(EXAMPLES / "ensemble.toml"))["has_ensemble"]
    json.dumps(facts)


# --- Processes ---


def test_a_task_runs_in_a_process(tasks, tmp_path):
    content = ended(tasks, start(tasks, "export", target="live", folder=tmp_path))
    assert (content["state"], content["revision"], content["progress"]) == ("done", 7, 1.0)
    (name,) = content["files"]
    assert tasks.file(name).read_bytes().startswith(b"<!DOCTYPE html>")
    assert tasks.keep(name, tmp_path) == "plant.html"
    written = (tmp_path / "plant.html").read_bytes()
    with refused("edit.file_exists", path="plant.html"):
        tasks.keep(name, tmp_path)
    assert (tmp_path / "plant.html").read_bytes() == written
    assert tasks.keep(name, tmp_path, "other.html") == "other.html"
    for hostile in ("../x.html", "/x.html", ".x.html", "a/b.html", "x.html\0", "nul.html", "", "x.html/.."):
        if hostile:
            with refused("edit.file_name"):
                tasks.keep(name, tmp_path, hostile)
    with refused("edit.other_suffix"):
        tasks.keep(name, tmp_path, "x.toml")


def test_files_of_the_circuit_are_found_in_its_folder(tasks, tmp_path):
    (tmp_path / "course.csv").write_text("time [s],value [bar]\n0,9\n2,5\n", encoding="utf-8")
    signal_table = '[signals."supply.pressure"]\nkind = "file"\npath = "course.csv"\ncolumn = "value"\n'
    order = FILL.replace("[run]", f"{signal_table}[run]")
    content = ended(tasks, start(tasks, "export", text=order, folder=tmp_path, target="live"))
    assert content["state"] == "done", content["message"]
    content = ended(tasks, start(tasks, "export", text=order, folder=tmp_path / "uploads", target="live"))
    assert content["state"] == "failed"


def test_an_invalid_circuit_is_a_failed_task_with_all_errors(tasks):
    text = FILL.replace('"1 l"', '"1 bar"').replace("0.5", "2")
    content = ended(tasks, start(tasks, "report", text=text))
    assert content["state"] == "failed"
    assert {error["address"] for error in content["errors"]} == {"parts.tank.volume", "parts.fill.critical_ratio"}
    assert all(error["line"] and error["message"] and error["hint"] for error in content["errors"])


def test_python_files_beside_the_circuit_are_not_imported(tasks, tmp_path, monkeypatch):
    for name in ("numpy", "json", "sitecustomize"):
        (tmp_path / f"{name}.py").write_text("import os; os._exit(9)", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    content = ended(tasks, start(tasks, "export", folder=tmp_path, target="live"))
    assert content["state"] == "done", content["message"]


def test_two_tasks_at_the_same_time(tasks):
    long = FILL.replace('duration = "2 s"', 'duration = "2000 s"').replace('"10 ms"', '"1 ms"')
    identifiers = [start(tasks, "report", text=long) for _ in range(2)]
    with refused("edit.many_tasks", most=2):
        start(tasks, "report")
    assert tasks.cancel(identifiers[0])["state"] == "cancelled"
    third = start(tasks, "export", target="live")
    tasks.cancel(identifiers[1])
    assert ended(tasks, third)["state"] == "done"
    assert [task["id"] for task in tasks.contents()] == [third, *reversed(identifiers)]
    assert tasks.cancel(third)["state"] == "done"


def command_in_group(monkeypatch, code):
    """Let the processes of tasks execute other code."""
    start_process = manager.subprocess.Popen

    def popen(arguments, **keywords):
        return start_process([arguments[0], "-c", code], **keywords)

    monkeypatch.setattr(manager.subprocess, "Popen", popen)


def test_a_crash_is_a_failed_task(tasks, monkeypatch):
    command_in_group(monkeypatch, "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)")
    content = ended(tasks, start(tasks, "report"))
    assert (content["state"], content["errors"][0]["code"]) == ("failed", "edit.task_ended")
    monkeypatch.undo()
    assert ended(tasks, start(tasks, "export", target="live"))["state"] == "done"


def test_an_exception_is_a_failed_task_with_its_last_line(tasks, monkeypatch):
    command_in_group(monkeypatch, "print('{}'); print('no json'); raise RuntimeError('broken')")
    assert "RuntimeError: broken" in ended(tasks, start(tasks, "report"))["message"]


@pytest.mark.skipif(os.name != "posix", reason="process groups of POSIX")
@pytest.mark.parametrize("end", ["cancel", "close", "server"])
def test_children_of_a_task_end_with_it(tmp_path, monkeypatch, end):
    sleeper = f"p = subprocess.Popen(['sleep', '600']); open({str(tmp_path / 'pid')!r}, 'w').write(str(p.pid))"
    wait = "threading.Thread(target=process._end_with_server, daemon=True).start(); time.sleep(600)"
    code = f"import subprocess, threading, time; from poppet.edit.tasks import process; {sleeper}; {wait}"
    command_in_group(monkeypatch, code)
    tasks = Tasks()
    identifier = start(tasks, "report")
    limit = time.monotonic() + 30.0
    while not (tmp_path / "pid").exists() or not (tmp_path / "pid").read_text():
        assert time.monotonic() < limit
        time.sleep(0.02)
    pid = int((tmp_path / "pid").read_text())
    if end == "cancel":
        assert tasks.cancel(identifier)["state"] == "cancelled"
    elif end == "server":
        tasks._tasks[identifier].process.stdin.close()  # as the system does when the server is killed
    else:
        tasks.close()
    while is_alive(pid):
        assert time.monotonic() < limit
        time.sleep(0.02)
    tasks.close()
    assert not tasks.uploads.exists()


def is_alive(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    # A zombie of a container without an init process has ended.
    status = Path(f"/proc/{pid}/stat")
    return not status.exists() or status.read_text().rpartition(")")[2].split()[0] != "Z"


def test_a_process_writes_its_result_as_lines_of_json(tmp_path):
    (tmp_path / "output").mkdir()
    folders = {name: str(tmp_path / name) for name in ("output", "uploads")} | {"folder": str(tmp_path)}
    stream = io.StringIO()
    options = {"address": "tank.volume", "metric": TIME_TO_3_BAR}
    process.run_task({"task": "size", "options": options, "text": FILL, "name": "plant", **folders}, stream)
    *progress, last = map(json.loads, stream.getvalue().splitlines())
    assert progress[0]["step"] == "values"
    assert all(0.0 <= message["progress"] <= 1.0 for message in progress)
    assert len(last["result"]["data"]["curve"]["x"]) == studies.POINTS


@pytest.mark.parametrize(
    ("task", "table"),
    [
        ("report", '[signals."fill.opening"]\nkind = "file"\npath = "{}"\ncolumn = "value"\nunit = "1"\n'),
        ("ensemble", '[ensemble]\nsampling = "file"\nfile = "{}"\nmetrics = {{ a = {{ of = "tank.pressure" }} }}\n'),
        ("ensemble", '[ensemble]\nruns = 2\nparameters.from_fit = "{}"\n'),
    ],
)
@pytest.mark.parametrize("path", ["/etc/passwd", "../secret.csv", "link.csv"])
def test_files_outside_the_folder_are_not_read(tmp_path, task, table, path):
    folder = tmp_path / "work"
    for place in (folder, tmp_path / "task" / "output", tmp_path / "uploads"):
        place.mkdir(parents=True)
    (tmp_path / "secret.csv").write_text("time,value\n0,1\n1,2\n", encoding="utf-8")
    (folder / "link.csv").symlink_to(tmp_path / "secret.csv")
    folders = {"folder": str(folder), "output": str(tmp_path / "task" / "output"), "uploads": str(tmp_path / "uploads")}
    stream = io.StringIO()
    text = FILL + table.format(path)
    process.run_task({"task": task, "options": {}, "text": text, "name": "plant", **folders}, stream)
    assert "files.outside" in {error["code"] for error in json.loads(stream.getvalue().splitlines()[-1])["errors"]}


def test_too_little_memory_is_a_message(tmp_path, monkeypatch):
    def exhaust(job):
        raise MemoryError

    monkeypatch.setattr(runs, "write_report", exhaust)
    stream = io.StringIO()
    order = dict.fromkeys(("folder", "output", "uploads"), str(tmp_path)) | {"text": FILL, "name": "plant"}
    process.run_task({"task": "report", "options": {}, **order}, stream)
    assert json.loads(stream.getvalue())["errors"][0]["code"] == "edit.no_memory"


@pytest.mark.parametrize(("run", "package"), [(runs.write_report, "matplotlib"), (fits.fit_parameters, "matplotlib")])
def test_a_missing_package_is_reported_before_the_work(job, monkeypatch, run, package):
    monkeypatch.setitem(sys.modules, package, None)
    with refused("missing.package", package=package, extra="plot"):
        run(job("no circuit"))


# --- Recordings ---


def test_uploads(tasks, monkeypatch):
    assert tasks.upload("Messung 1.csv", io.BytesIO(b"t,p\n0,1\nrest"), 8) == "Messung_1.csv"
    assert (tasks.uploads / "Messung_1.csv").read_bytes() == b"t,p\n0,1\n"
    assert tasks.upload("../../etc/passwd.csv", io.BytesIO(b""), 0) == "passwd.csv"
    with refused("edit.large_upload"):
        tasks.upload("large.csv", io.BytesIO(b""), manager.MAX_UPLOAD + 1)
    with refused("edit.upload_ended"):
        tasks.upload("short.csv", io.BytesIO(b"12"), 3)
    for name in ("", "..", "/", "con.csv"):
        with refused("edit.file_name"):
            tasks.upload(name, io.BytesIO(b""), 0)
    monkeypatch.setattr(manager, "MAX_UPLOADS", 2)
    for k in range(4):
        tasks.upload(f"{k}.csv", io.BytesIO(b""), 0)
    assert sorted(path.name for path in tasks.uploads.iterdir()) == ["2.csv", "3.csv"]


@pytest.mark.parametrize("name", ["", ".", "..", "a/b", "a\\b", "-x.csv", ".x", "x.", "a\nb", "COM1.csv", "ä.csv", 3])
def test_file_names_that_are_refused(name):
    with refused("edit.file_name"):
        check_file_name(name)


def test_unknown_tasks_and_files(tasks):
    for call in (tasks.content, tasks.cancel, tasks.file):
        with refused("names.unknown", "../1"):
            call("../1")
