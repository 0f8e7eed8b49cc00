"""The control engineer: gains, Bode plot and step responses, against a plant by hand in python-control."""

from __future__ import annotations

import math
import re
import tomllib

import numpy as np
import pytest

from pages import needs_nothing_else, plots

FILE = "pressure-control.toml"
T, LAG, SUPPLY, VOLUME, WALL = 2e-3, 3e-3, 7e5, 1e-3, 1.5
C, B, KAPPA, R, T0, RHO0 = 5e-9, 0.35, 1.4, 287.05, 293.15, 1.185
CP = KAPPA / (KAPPA - 1.0) * R


@pytest.fixture(scope="module")
def folder(installed, tmp_path_factory):
    """Folder in which the engineer has tuned the template."""
    folder = tmp_path_factory.mktemp("control")
    assert installed.run("poppet", "new", "pressure-control", folder=folder).returncode == 0
    command = ("poppet", "control", "tune", FILE, "-o", "gains.toml", "--report", "tuning.html")
    result = installed.run(*command, folder=folder)
    assert (result.returncode, result.stderr) == (0, "")
    (folder / "output.txt").write_text(result.stdout, encoding="utf-8")
    return folder


def gains_of(folder, file: str = "gains.toml") -> tuple[float, float, float, float]:
    """Return gain [1/Pa], integral time [s], vent factor and setpoint weight of a file with gains."""
    part = tomllib.loads((folder / file).read_text(encoding="utf-8"))["parts"]["regulator"]
    gain, integral_time = (float(str(part[name]).split()[0]) for name in ("gain", "integral_time"))
    return gain / 1e5, integral_time / 1e3, part["vent_factor"], part["setpoint_weight"]


def psi(ratio: float) -> float:
    """Subsonic factor of the flow."""
    return math.sqrt(1.0 - max(0.0, (ratio - B) / (1.0 - B)) ** 2)


def plant_by_hand(control, pressure: float, side: str):
    """Sampled plant from the opening to the sensor: a chamber with heat transfer, about a rest without flow."""
    if side == "fill":
        flow = C * RHO0 * SUPPLY * psi(pressure / SUPPLY)
    else:
        flow = -C * RHO0 * pressure * psi(1e5 / pressure)
    mass, factor = pressure * VOLUME / (R * T0), (KAPPA - 1.0) / VOLUME
    # States: pressure, mass; T = p V/(m R).
    a = np.array([[-factor * WALL * T0 / pressure, factor * WALL * T0 / mass], [0.0, 0.0]])
    b = np.array([[factor * CP * T0 * flow], [flow]])
    chamber = control.ss(a, b, [[1.0, 0.0]], [[0.0]])
    plant = control.ss(control.tf([1.0], [LAG, 1.0])) * chamber
    delay = control.tf([1.0], [1.0, 0.0], T)
    return control.sample_system(plant, T, "zoh"), delay


def loop_by_hand(control, folder, pressure: float, side: str, file: str = "gains.toml"):
    """Open loop of the sampled controller with the command of the next sample."""
    gain, integral_time, vent_factor, _ = gains_of(folder, file)
    plant, delay = plant_by_hand(control, pressure, side)
    sign = 1.0 if side == "fill" else -vent_factor
    controller = control.tf([gain, gain * (T / integral_time - 1.0)], [1.0, -1.0], T)
    return sign * plant * control.ss(delay) * control.ss(controller)


def margin_rows(folder) -> tuple[list[tuple[str, ...]], list[tuple[str, ...]]]:
    """Return the rows of the tables of margins in the output: with the tuned gains, and with those of the file."""
    row = re.compile(
        r"^(\d) bar, (fill|vent) +([\d.]+) +([\d.]+) +([\d.]+) +([\d.]+) +([\d.]+) +([\d.]+)$", re.MULTILINE
    )
    tuned, before = (folder / "output.txt").read_text(encoding="utf-8").split(f"With the gains of {FILE}:\n")
    return row.findall(tuned), row.findall(before)


@pytest.mark.parametrize(("table", "file"), [(0, "gains.toml"), (1, FILE)])
def test_margins_are_those_of_a_plant_by_hand(folder, table, file):
    control = pytest.importorskip("control", reason="python-control is not installed")
    rows = margin_rows(folder)[table]
    assert len(rows) == 8
    omega = 2.0 * np.pi * np.geomspace(0.1, 249.9, 6000)
    for pressure, side, *numbers in rows:
        sensitivity, complementary, gain, phase, _, crossover = map(float, numbers)
        loop = loop_by_hand(control, folder, 1e5 * float(pressure), side, file)
        response = control.frequency_response(loop, omega).complex.ravel()
        wanted_gain, wanted_phase, _, _, wanted_crossover, _ = control.stability_margins(control.frd(response, omega))
        assert gain == pytest.approx(wanted_gain, rel=5e-3)
        assert phase == pytest.approx(wanted_phase, rel=5e-3)
        assert crossover == pytest.approx(wanted_crossover / (2.0 * np.pi), rel=5e-3)
        assert sensitivity == pytest.approx(np.max(1.0 / np.abs(1.0 + response)), rel=5e-3)
        assert complementary == pytest.approx(np.max(np.abs(response / (1.0 + response))), rel=5e-3)


def test_report_has_bode_and_step_plots_of_the_true_loop(folder):
    """The curves of the page are those of python-control, and the texts have the margins of the table."""
    control = pytest.importorskip("control", reason="python-control is not installed")
    page = (folder / "tuning.html").read_text(encoding="utf-8")
    needs_nothing_else(page)
    bode, steps = plots(page)
    values = np.array([[float(cell) for cell in row[2:]] for row in margin_rows(folder)[0]])
    texts = " ".join(text[2] for plot in (bode, steps) for panel in plot["panels"] for text in panel.get("texts", []))
    assert f"gain margin {values[:, 2].min():.3g} " in texts
    assert f"phase margin {values[:, 3].min():.3g}°" in texts
    assert re.search(r"overshoot [\d.]+ %", texts)
    assert texts.count("settled within 2 % after") == 2
    magnitude, phase = (curve(bode, k, "3 bar, fill") for k in (0, 1))
    is_inside = (magnitude[0] > 0.2) & (magnitude[0] < 200.0)
    omega = 2.0 * np.pi * magnitude[0][is_inside]
    response = control.frequency_response(loop_by_hand(control, folder, 3e5, "fill"), omega).complex.ravel()
    assert np.max(np.abs(magnitude[1][is_inside] - 20.0 * np.log10(np.abs(response)))) < 0.05
    assert np.max(np.abs(phase[1][is_inside] - (np.degrees(np.unwrap(np.angle(response)))))) < 0.5
    assert f"With the gains of {FILE}:" in page
    assert all(cell in page for row in margin_rows(folder)[1] for cell in row[2:])
    time, measured = curve(steps, 0, "3 bar, fill")
    gain, _, _, weight = gains_of(folder)
    # With a setpoint weight, the proportional part sees only this fraction of the setpoint.
    loop = loop_by_hand(control, folder, 3e5, "fill")
    plant, delay = plant_by_hand(control, 3e5, "fill")
    without = (1.0 - weight) * gain * plant * control.ss(delay)
    closed = control.feedback(control.ss([], [], [], [[1.0]], T), loop) * (loop - without)
    wanted = control.step_response(closed, np.arange(len(time)) * T).outputs
    assert np.max(np.abs(measured - wanted)) < 5e-3


def curve(plot, panel: int, label: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the abscissae and the values of a line of a plot in a page."""
    (line,) = [line for line in plot["panels"][panel]["lines"] if line["label"] == label]
    return tuple(column(plot["columns"][line[axis]]) for axis in ("x", "y"))


def column(values) -> np.ndarray:
    """Return a column of a plot, also an equidistant one."""
    if isinstance(values, dict):
        return values["from"] + values["step"] * np.arange(values["count"])
    return np.array(values, dtype=float)


def test_tuned_loop_follows_its_setpoint(installed, folder):
    result = installed.run("poppet", "simulate", FILE, "--with", "gains.toml", "-o", "run.csv", folder=folder)
    assert result.returncode == 0
    with (folder / "run.csv").open(encoding="utf-8") as file:
        headings = file.readline().strip().split(",")
        rows = np.loadtxt(file, delimiter=",").T
    pressure = rows[headings.index("tank.pressure [Pa]")]
    for time, level in ((2.4, 4e5), (4.4, 3e5), (6.4, 5e5)):
        assert np.interp(time, rows[0], pressure) == pytest.approx(level, rel=2e-3)


def test_tuning_in_a_notebook(installed, folder):
    """One expression shows both figures, and the accessors write them."""
    (folder / "cell.py").write_text(
        "import poppet\nfrom poppet.control import tune\n"
        "tuning = tune(poppet.load('pressure-control.toml'), at=['3 bar'])\n"
        "print(tuning._repr_html_().count('<svg'))\n"
        "tuning.plot_bode('bode.png')\ntuning.plot_steps('steps.svg')\n",
        encoding="utf-8",
    )
    result = installed.run(installed.python, "cell.py", folder=folder)
    assert (result.returncode, result.stdout.strip()) == (0, "2"), result.stderr
    assert (folder / "bode.png").read_bytes().startswith(b"\x89PNG")
    assert "</svg>" in (folder / "steps.svg").read_text(encoding="utf-8")
