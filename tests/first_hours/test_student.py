"""The student: from the installation to figure 6 of the paper with another tank and a leak."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from chromium import Browser, found

PAGE = Path(__file__).parents[2] / "website" / "pages" / "first_hours" / "student.md"
VOLUME, LEAK = 0.1, 5e-9  # 0.5 dm^3/(s bar)


def filled(volume: float, leak: float) -> float:
    """Time in which choked flow at the largest C fills an isothermal tank from 1 to 2 bar [s], without the leak."""
    flow = 1.65e-8 * 7e5 * 1.185 - 0.5 * leak * 1.5e5 * 1.185
    return volume * 1e5 / (287.05 * 293.15) / flow


@pytest.fixture(scope="module")
def circuits(installed, tmp_path_factory):
    """Folder in which the student has written the circuits."""
    folder = tmp_path_factory.mktemp("student")
    help_text = installed.run("poppet", "--help", folder=folder).stdout
    assert re.search(r"^ *paper +reproduce the figures", help_text, re.MULTILINE)
    assert "--circuits" in installed.run("poppet", "paper", "--help", folder=folder).stdout
    written = installed.run("poppet", "paper", "--circuits", "circuits", folder=folder)
    assert (written.returncode, written.stderr) == (0, "")
    proposed = [line.partition(": ")[2] for line in written.stdout.splitlines() if ": poppet " in line]
    assert [command.split()[1] for command in proposed] == ["simulate", "live"]
    for command in proposed:
        assert installed.run("sh", "-c", command, folder=folder).returncode == 0
    assert {path.suffix for path in folder.glob("figure6.*")} == {".png", ".html"}
    assert sorted(path.name for path in (folder / "circuits").iterdir()) == [f"figure{k}.toml" for k in (3, 4, 5, 6)]
    return folder


def test_every_circuit_runs_as_its_comment_says(installed, circuits):
    for k in (3, 4, 5, 6):
        run = installed.run("poppet", "simulate", f"circuits/figure{k}.toml", folder=circuits)
        assert (run.returncode, run.stderr) == (0, "")
        assert "The run is complete" in run.stdout
    text = (circuits / "circuits" / "figure6.toml").read_text().replace(" \\\n#", "")
    commands = re.findall(r"^#  ? ?(poppet (?:simulate|live) figure6\.toml .*?)(?: {3,}\(.*)?$", text, re.MULTILINE)
    assert len(commands) == 5
    for command in commands:
        result = installed.run("sh", "-c", command, folder=circuits / "circuits")
        assert result.returncode == 0, result.stderr


def test_figure_6_with_another_tank_and_a_leak_is_one_command(installed, circuits):
    changes = ("--set", f"tank.volume={VOLUME} m^3", "--set", "leak.sonic_conductance=0.5 dm^3/(s bar)")
    for name, options in {"paper": (), "changed": changes}.items():
        command = ("poppet", "simulate", "circuits/figure6.toml", *options, "-o", f"{name}.csv")
        assert installed.run(*command, folder=circuits).returncode == 0
    reached = {}
    for name in ("paper", "changed"):
        with (circuits / f"{name}.csv").open() as file:
            headings = file.readline().strip().split(",")
            rows = np.loadtxt(file, delimiter=",").T
        reached[name] = np.interp(1.99e5, rows[headings.index("tank.pressure [Pa]")][:301], rows[0][:301])
    # The wall keeps the tank nearly isothermal; an adiabatic one would be 30 % faster.
    assert reached["paper"] == pytest.approx(filled(0.2, 0.0), rel=0.12)
    assert reached["changed"] == pytest.approx(filled(VOLUME, LEAK), rel=0.12)


def test_the_cell_of_the_tutorial_draws_it(installed, circuits):
    text = PAGE.read_text(encoding="utf-8")
    cell = text[text.index("!poppet paper --circuits circuits") :].partition("```")[0]
    command, _, code = cell.partition("\n")
    assert installed.run("sh", "-c", command[1:], folder=circuits).returncode == 0
    (circuits / "cell.py").write_text(
        f"import matplotlib\nmatplotlib.use('agg')\nimport matplotlib.pyplot as plt\n{code}\n"
        "lines = {line.get_label(): line.get_ydata() for line in axes.lines}\n"
        "print(len(lines), *(round(float(max(values)), 2) for values in lines.values()))\n"
    )
    drawn = installed.run("python", "cell.py", folder=circuits)
    assert (drawn.returncode, drawn.stdout) == (0, "3 5.0 5.0 5.0\n"), drawn.stderr


def test_the_page_of_the_tutorial_has_both_sliders(installed, circuits):
    text = PAGE.read_text(encoding="utf-8")
    command = text[text.index("!poppet live circuits/figure6.toml") + 1 :].partition("\n")[0]
    assert installed.run("sh", "-c", command, folder=circuits).returncode == 0
    program = found()
    if program is None:
        pytest.skip("no Chromium here; POPPET_BROWSER names one")
    with Browser(program) as browser:
        browser.open(circuits / "figure6.html", width=360)
        assert browser("live.header.sliders.map(slider => slider.address)") == ["tank.volume", "leak.sonic_conductance"]
        before = settling_time(browser)
        move(browser, "tank.volume", VOLUME)
        halved = settling_time(browser)
        move(browser, "leak.sonic_conductance", LEAK)
        assert halved == pytest.approx(0.5 * before, rel=0.05)
        assert halved < settling_time(browser) < before


def move(browser: Browser, address: str, value: float) -> None:
    """Move a slider to a value in SI units."""
    browser(f"""(() => {{
        const k = live.header.sliders.findIndex(slider => slider.address === {json.dumps(address)});
        const range = document.querySelectorAll("#sliders input[type=range]")[k], slider = live.header.sliders[k];
        range.value = {value} * slider.factor + slider.shift;
        range.dispatchEvent(new Event("input"));
    }})()""")
    browser.settle()


def settling_time(browser: Browser) -> float:
    """Time at which the curve of the page first reaches 1.99 bar [s]."""
    shown = browser("live.header.outputs.findIndex(output => (output.address ?? output[0]) === 'tank.pressure')")
    pressure = np.array(browser(f"Array.from(live.kernel.series({shown}))"))
    return 0.1 * float(np.argmax(pressure > 1.99e5))
