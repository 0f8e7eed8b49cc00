"""Tests of the C project: strict compilation, its host program, and calls from other programs."""

from __future__ import annotations

import graphlib
import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from c_compiler import COMPILER, compile_c
from circuits_of_exports import EXAMPLES, TEN, check_and_relief, example
from poppet import Circuit, load
from poppet.cli.main import run
from poppet.deploy.c.project import c_project
from refusals import refused

HOSTILE = '*/ int x; /* \\ ??/ "%s" @NAME@ </title>\u202e'


def host(files: dict[str, str], folder: Path, *options: str, step: str = "1e-3") -> subprocess.CompletedProcess[str]:
    return subprocess.run([compile_c(files, folder, *options), step], capture_output=True, text=True, check=False)


def driven(circuit: Circuit, folder: Path, body: str) -> np.ndarray:
    """Numbers that a program prints which drives the fixed step `m` or the adaptive run `a` of the model `it`."""
    files = {name: text for name, text in c_project(circuit, "it").items() if not name.endswith("host.c")}
    head = '#include "it.h"\n#include <math.h>\n#include <stdio.h>\n'
    head += "static it_fixed m;\nstatic it_adaptive a;\nint main(void) {\n"
    ending = "(void)m; (void)a; (void)k; (void)y; return 0; }\n"
    files["own.c"] = f"{head}double y[IT_OUTPUTS]; int k = 0;\n{body}\n{ending}"
    out = subprocess.run([compile_c(files, folder, "-std=c99", "-O1")], capture_output=True, text=True, check=True)
    return np.array([float(number_text) for number_text in out.stdout.split()])


def test_host_program_reports_success(tmp_path):
    host_run = host(c_project(TEN["two tanks"](), "tanks"), tmp_path, "-std=c99", "-O1", step="0.1")
    assert host_run.returncode == 0, host_run.stdout


@pytest.mark.parametrize("name", TEN)
@pytest.mark.parametrize("options", [("-std=c99", "-O2"), ("-std=c90", "-O1"), ("-x", "c++", "-O1")], ids=" ".join)
def test_all_hosts_and_languages(name, options, tmp_path):
    if name == "32 chambers" and options[0] != "-std=c99":
        pytest.skip("as the others, and long")
    host_run = host(c_project(TEN[name](), "it"), tmp_path, *options, step="1e-4")
    assert host_run.returncode == 0, host_run.stdout


def test_allowed_differences_follow_the_effect_of_rounding():
    """The states of a valve that hunts, by what they are from a start that is moved, and no looser before it does."""
    files = c_project(example("muscle_joint", "0.4 s"), "it")
    rows = re.search(r"allowed_adaptive\[\] = \{\n(.*?)\n\};", files["it_host.c"], re.DOTALL)
    allowed = np.array([[float(text) for text in row.strip(" ,").split(",")] for row in rows[1].splitlines()])
    assert np.all(allowed[:, :3] == 1e-5)
    assert np.all(np.diff(allowed, axis=1) >= 0.0)
    assert allowed[:, -1].max() > 1e-4


def test_a_changed_test_vector_is_detected(tmp_path):
    files = c_project(TEN["two tanks"](), "it")
    text = files["it_host.c"]
    rows = text.index("known[] = {")
    first = re.compile(r"\d\.?\d*").search(text, rows)
    assert first is not None
    files["it_host.c"] = text[: first.start()] + "9" + text[first.start() :]
    assert host(files, tmp_path, "-std=c99", "-O1", step="0.1").returncode == 1


def test_special_characters_in_names_and_titles_are_escaped(tmp_path):
    circuit = replace(TEN["two tanks"](), title=HOSTILE)
    files = c_project(circuit, HOSTILE)
    assert all(re.fullmatch(r"[A-Za-z0-9_.]+", name) for name in files)
    assert all(text.isascii() for text in files.values())
    assert host(files, tmp_path, "-std=c90", "-O0", step="0.1").returncode == 0


def test_exported_c_has_no_allocation_and_no_global_state(tmp_path):
    if shutil.which("nm") is None:
        pytest.skip("there is no nm on this machine")
    for name, text in c_project(TEN["staircase"](), "it").items():
        if not name.endswith((".c", ".h")) or name.endswith("host.c"):
            continue
        assert not re.search(r"\b(malloc|calloc|realloc|free|alloca)\b", text)
    files = {name: text for name, text in c_project(TEN["staircase"](), "it").items() if "host" not in name}
    for name in [name for name in files if name.endswith(".c")]:
        headers = {header: text for header, text in files.items() if header.endswith(".h")}
        object_file = compile_c({**headers, name: files[name]}, tmp_path, "-std=c99", "-O1", "-fno-pie", "-c")
        symbols = subprocess.run(["nm", str(object_file)], capture_output=True, text=True, check=True).stdout.split(
            "\n"
        )
        kinds = {line.split()[-1]: line.split()[-2] for line in symbols if line.strip()}
        # Constants only: nothing that could be written.
        assert not {symbol for symbol, kind in kinds.items() if kind in "BbDdCGgSs"}, name
        imports = {symbol for symbol, kind in kinds.items() if kind == "U" and not symbol.startswith("it_")}
        assert imports <= {"pow", "sqrt", "sin", "cos", "floor", "fabs", "exp", "log", "tanh", "_GLOBAL_OFFSET_TABLE_"}
        assert all(symbol.startswith("it_") for symbol, kind in kinds.items() if kind in "TR"), name


def test_exported_c_has_no_recursion_and_a_bounded_stack(tmp_path):
    """Call graph and stack usage from GCC."""
    if COMPILER is None:
        pytest.skip("there is no C compiler on this machine")
    version = subprocess.run([COMPILER, "--version"], capture_output=True, text=True, check=True).stdout
    if "Free Software" not in version:
        pytest.skip("call graphs are written by GCC")
    files = {name: text for name, text in c_project(TEN["regulator"](), "it").items() if not name.endswith("host.c")}
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    calls, stacks = {}, {}
    for source in (name for name in files if name.endswith(".c")):
        command = [COMPILER, "-std=c99", "-O1", "-fcallgraph-info=su", "-c", source]
        subprocess.run(command, cwd=tmp_path, check=True)
        graph = (tmp_path / source).with_suffix(".ci").read_text(encoding="utf-8")
        for edge in re.finditer(r'sourcename: "([^"]+)" targetname: "([^"]+)"', graph):
            calls.setdefault(edge[1].split(":")[-1], set()).add(edge[2].split(":")[-1])
        for node in re.finditer(r'title: "([^"]+)" label: "[^"]*?(\d+) bytes \((\w+(?:,\w+)?)\)', graph):
            stacks[node[1].split(":")[-1]] = int(node[2]), node[3]
    assert {"it_fixed_step", "it_adaptive_run"} <= stacks.keys()
    assert {kind for _, kind in stacks.values()} <= {"static", "dynamic,bounded"}
    list(graphlib.TopologicalSorter(calls).static_order())  # raises CycleError where something calls itself

    def deepest(name):
        return stacks.get(name, (0, ""))[0] + max(map(deepest, calls.get(name, ())), default=0)

    # What a task of a real-time system must have, without the functions of the mathematics.
    assert deepest("it_fixed_step") < 16_000


def smooth() -> Circuit:
    return load(EXAMPLES / "two_tanks.toml").with_values({"run.duration": "10 s", "run.output_step": "10 s"})


END = 'it_fixed_outputs(&m, y); for (k = 0; k < IT_OUTPUTS; k++) printf("%.17g ", y[k]);'


def test_the_fixed_step_is_of_second_order(tmp_path):
    names = [name for name, _ in smooth().model.outputs]
    exact = smooth().simulate(relative_tolerance=1e-12)
    expected, errors = np.array([exact[name][-1] for name in names]), []
    for parts in (50, 100, 200):
        loop = f"it_fixed_begin(&m); for (k = 1; k <= {parts}; k++) it_fixed_step(&m, k * 10.0 / {parts}.0);"
        outputs = driven(smooth(), tmp_path, loop + END)
        errors.append(np.max(np.abs(outputs - expected)[:2] / expected[:2]))
    assert errors[0] < 1e-3
    ratios = np.array(errors[:-1]) / np.array(errors[1:])
    assert np.all((ratios > 3.0) & (ratios < 5.5)), ratios


def test_substeps_equal_as_many_calls(tmp_path):
    """Calls in substeps give what as many calls give, where a clock ticks too."""
    circuit = example("pressure_control", "0.3 s", **{"tank.initial_pressure": "3 bar"})
    loop = "it_fixed_begin(&m); %s for (k = 1; k <= %d; k++) if (it_fixed_step(&m, k * 0.3 / %d.0)) return 1;"
    bodies = [loop % (change, calls, calls) + END for change, calls in (("", 30), ("", 600), ("m.substeps = 20;", 30))]
    coarse, fine, substepped = driven(circuit, tmp_path, "\n".join(bodies)).reshape(3, -1)
    size = np.abs(fine) + 1e-9
    assert np.max(np.abs(substepped - fine) / size) < 1e-7 < 1e-5 < np.max(np.abs(coarse - fine) / size)
    with refused("fields.out_of_range", "substeps", value=0):
        c_project(circuit, substeps=0)
    assert "IT_SUBSTEPS = 7" in c_project(circuit, "it", substeps=7)["it.h"]


def test_parameters_change_at_run_time(tmp_path):
    circuit = smooth()
    numbers = {name: k for k, name in enumerate(circuit.model.parameters)}
    k, fixed = numbers["low.volume"], numbers["ambient.pressure"]
    body = f"""
      double times[2] = {{0.0, 10.0}}, table[2 * IT_OUTPUTS];
      it_adaptive_begin(&a);
      printf("%d %d %d ", it_set(a.p, {k}, 0.05), it_set(a.p, {k}, -1.0), it_set(a.p, {fixed}, 9e4));
      printf("%d %d ", it_set(a.p, {k}, 0.0), it_set(a.p, {k}, HUGE_VAL));
      printf("%d %d %d ", it_set(a.p, {k}, HUGE_VAL - HUGE_VAL), it_set(a.p, -1, 1.0), it_set(a.p, IT_NUMBERS, 1.0));
      if (it_adaptive_run(&a, times, 2, table)) return 1;
      for (k = 0; k < IT_OUTPUTS; k++) printf("%.17g ", table[2 * k + 1]);
    """
    outputs = driven(circuit, tmp_path, f"{{ {body} }}")
    assert outputs[:8].tolist() == [0.0, 2.0, 1.0, 2.0, 2.0, 2.0, 1.0, 1.0]
    changed = circuit.with_values({"low.volume": 0.05}).simulate()
    expected = np.array([changed[name][-1] for name, _ in circuit.model.outputs])
    assert np.max(np.abs(outputs[8:] - expected) / (np.abs(expected) + 1e-9)) < 1e-6


INVALID, LIMITED = 5, 16


def test_values_that_are_not_finite_are_rejected_and_change_nothing(tmp_path):
    """An input, its slope, the time, and a time that runs backwards; then the run continues as without."""
    circuit = check_and_relief()
    index = circuit.instance.input_names.index("line.pressure")
    values = "HUGE_VAL - HUGE_VAL", "HUGE_VAL", "-HUGE_VAL"
    wrong = [f'm.u[{index}] = {value}; printf("%d ", it_fixed_step(&m, 0.02));' for value in values]
    wrong += [f"m.slopes[{index}] = {v}; printf(\"%d \", it_fixed_step(&m, 0.02)); m.slopes[{index}] = 0.0;"
              for v in values]  # fmt: skip
    wrong += [f'printf("%d ", it_fixed_step(&m, {value}));' for value in (*values, "0.005")]
    begin = f"it_fixed_begin(&m); m.by_host[{index}] = 1; m.u[{index}] = 3e5; it_fixed_step(&m, 0.01);"
    state = f'it_fixed_outputs(&m, y); printf("%.17g %.17g ", m.t, m.u[{index}]);' + END
    last = 'printf("%d ", it_fixed_step(&m, 0.02));' + END
    outputs = driven(circuit, tmp_path, begin + state + "".join(wrong) + state + last)
    n = (len(outputs) - len(wrong) - 1 - len(circuit.model.outputs)) // 2
    before, statuses, after = outputs[:n], outputs[n : n + len(wrong)], outputs[n + len(wrong) : 2 * n + len(wrong)]
    assert statuses.tolist() == [INVALID] * len(wrong)
    assert np.array_equal(after, before)
    assert before[:2].tolist() == [0.01, 3e5]
    undisturbed = driven(circuit, tmp_path, begin + last)
    assert undisturbed[0] == 0
    assert np.array_equal(outputs[2 * n + len(wrong) :], undisturbed)


def test_inputs_outside_their_limits_saturate_and_are_reported(tmp_path):
    """Openings of -5 and 1e6 act as 0 and 1; the status has a bit, and a flag names the input."""
    circuit = example("fill_staircase", "3 s")
    index = circuit.instance.input_names.index("bleed.opening")
    other = circuit.instance.input_names.index("valve.pilot_pressure")
    flags = f'printf("%d %d %d %.17g ", status, m.limited[{index}], m.limited[{other}], m.u[{index}]);'
    run = f"""it_fixed_begin(&m); m.by_host[{index}] = 1;
      {{ int status = 0; for (k = 1; k <= 50; k++) {{ m.u[{index}] = VALUE; m.slopes[{index}] = SLOPE;
      status |= it_fixed_step(&m, k * 1e-2); }} {flags} {END} }}"""
    cases = [
        ("1.0", "0.0"), ("1e6", "0.0"), ("1.0", "7.0"), ("1.0000000000000002", "0.0"),
        ("0.0", "0.0"), ("-5.0", "0.0"), ("-1e-17", "0.0"),
    ]  # fmt: skip
    body = "\n".join(run.replace("VALUE", value).replace("SLOPE", slope) for value, slope in cases)
    rows = driven(circuit, tmp_path, body).reshape(len(cases), -1)
    assert rows[:, 0].tolist() == [0, LIMITED, LIMITED, 0, 0, LIMITED, 0]
    assert np.array_equal(rows[:, 1], rows[:, 0] / LIMITED)
    assert np.all(rows[:, 2] == 0)
    assert rows[:, 3].tolist() == [1.0] * 4 + [0.0] * 3
    assert np.all(rows[1:4, 4:] == rows[0, 4:])
    assert np.all(rows[5:, 4:] == rows[4, 4:])
    assert np.any(rows[4, 4:] != rows[0, 4:])


def test_a_slope_ends_at_the_limit_of_its_input(tmp_path):
    """A slope that would leave the limits within a step is the slope that ends at the limit."""
    circuit = example("fill_staircase", "3 s")
    index = circuit.instance.input_names.index("bleed.opening")
    run = f"""it_fixed_begin(&m); m.by_host[{index}] = 1; m.u[{index}] = 0.5; m.slopes[{index}] = SLOPE;
      printf("%d ", it_fixed_step(&m, 0.25)); printf("%g %.17g ", m.slopes[{index}], m.u[{index}]); {END}"""
    within, beyond = driven(circuit, tmp_path, run.replace("SLOPE", "2.0") + run.replace("SLOPE", "8.0")).reshape(2, -1)
    assert (within[:3].tolist(), beyond[:3].tolist()) == ([0, 2, 1], [LIMITED, 8, 1])
    assert np.array_equal(beyond[3:], within[3:])


def test_the_adaptive_run_limits_inputs_and_rejects_invalid_times(tmp_path):
    circuit = example("fill_staircase", "3 s")
    number = circuit.model.parameters.index("bleed.opening")
    begin, end = "it_adaptive_begin(&a);", 'printf("%d ", (int)it_adaptive_run(&a, times, 2, table));'
    values = 'for (k = 0; k < IT_OUTPUTS; k++) printf("%.17g ", table[2 * k + 1]);'
    changed = f"{begin} a.p[{number}] = VALUE; {end} {values}"
    wrong = f"{begin} times[1] = VALUE; {end} times[1] = 3.0;"
    body = "double times[2] = {0.0, 3.0}, table[2 * IT_OUTPUTS];"
    body += "".join(changed.replace("VALUE", value) for value in ("1.0", "1e6", "1.0000000000000002"))
    body += "".join(wrong.replace("VALUE", value) for value in ("HUGE_VAL", "HUGE_VAL - HUGE_VAL", "-1.0"))
    body += f"{begin} a.p[{number}] = HUGE_VAL - HUGE_VAL; {end}"
    outputs = driven(circuit, tmp_path, f"{{ {body} }}")
    rows = outputs[:-4].reshape(3, -1)
    assert rows[:, 0].tolist() == [0, LIMITED, 0]
    assert np.all(rows[1:, 1:] == rows[0, 1:])
    assert outputs[-4:].tolist() == [INVALID] * 4


@pytest.mark.parametrize("name", ["staircase", "regulator"])
def test_exported_c_compiles_without_conversion_and_shadow_warnings(name, tmp_path):
    files = c_project(TEN[name](), "it", substeps=3)
    compile_c(files, tmp_path, "-std=c99", "-O0", "-Wconversion", "-Wshadow")


def test_an_input_of_the_host_replaces_its_signal(tmp_path):
    circuit = check_and_relief()
    index = circuit.instance.input_names.index("line.pressure")
    signal = circuit.signals["line.pressure"]
    step = "it_fixed_begin(&m);\nfor (k = 0; k < 500; k++) { %s if (it_fixed_step(&m, (k + 1) * 0.01)) return 1; }"
    by_signal = driven(circuit, tmp_path, step % "" + END)
    by_host = f"""double p0 = k < 200 ? 2e5 + 3000.0 * k : k < 400 ? 8e5 - 3500.0 * (k - 200) : 1e5;
      m.by_host[{index}] = 1; m.u[{index}] = p0;
      m.slopes[{index}] = k < 200 ? 3e5 : k < 400 ? -3.5e5 : 0.0;"""
    assert float(signal.evaluate(1.0)) == 5e5
    outputs = driven(circuit, tmp_path, step % by_host + END)
    assert np.max(np.abs(outputs - by_signal) / (np.abs(by_signal) + 1e-9)) < 1e-9


def test_export_command_writes_a_folder(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    file = str(EXAMPLES / "two_tanks.toml")
    assert run(["export", "c", file, "-o", "tanks"]) == 0
    assert "tanks" in capsys.readouterr().out
    names = {path.name for path in (tmp_path / "tanks").iterdir()}
    parts = ("data.c", "fixed.c", "adaptive.c", "integrator.c", "host.c")
    assert names == {"poppet-export.toml", "CMakeLists.txt", "two_tanks.h", *(f"two_tanks_{part}" for part in parts)}
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("mine")
    assert run(["export", "c", file, "-o", "mine"]) == 2
    assert run(["export", "c", file]) == 2
    assert run(["export", "c", file, "--precision", "single", "-o", "more"]) == 2
    assert run(["export", "c", file, "--part", "controller", "--substeps", "2", "-o", "more"]) == 2
    assert {path.name for path in tmp_path.iterdir()} == {"tanks", "mine"}
    assert run(["export"]) == 2
    assert "export c" in capsys.readouterr().out


def test_a_circuit_without_duration_is_refused_before_writing():
    circuit = smooth()
    with refused("fields.missing", "run.duration"):
        c_project(replace(circuit, run=replace(circuit.run, duration=None)))
