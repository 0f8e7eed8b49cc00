"""The bench engineer: from a raw recording with the usual traps to C, b and the wall conductance, beside the truth."""

from __future__ import annotations

import pytest

from poppet.identify import read_result
from tank_discharge import REST, TRUTH, excel_export, logger_file

NAMES = {"valve.sonic_conductance": "C", "valve.critical_ratio": "b", "tank.wall_conductance": "wall"}
KNOWN = ("--volume", "20 l", "--ambient", "987 hPa", "--ambient-temperature", "21 degC")


def compare(path, *, recording: str) -> None:
    """Compare a result file with the simulation of SciPy: all parameters are determined, and the intervals hold."""
    parameters = read_result(path).parameters
    for address, name in NAMES.items():
        estimate = parameters[address]
        assert estimate.verdict == "determined"
        assert estimate.low < TRUTH[name] < estimate.high, address
        assert estimate.high - estimate.low < 0.08 * TRUTH[name], address
    assert parameters[f"{recording}.valve.delay"].value == pytest.approx(REST, abs=0.02)


def test_the_export_of_a_spreadsheet_on_a_terminal(installed, tmp_path):
    excel_export(tmp_path / "messung.csv")
    assert "--from RECORDING" in installed.run("poppet", "identify", "--help", folder=tmp_path).stdout
    answers = {
        r"gauge or an absolute pressure": "gauge",
        r"When does the valve open": "",
        r"Volume of the tank": ["20", "20 l"],  # a number without a unit is asked for again
        r"Ambient pressure": "987 hPa",
        r"Ambient temperature": "Temperatur Raum",
        r"Wall conductance": "",
        r"Is this correct": "yes",
    }
    command = ("poppet", "identify", "tank", "--from", "messung.csv", "-o", "result.toml")
    session = installed.on_terminal(*command, folder=tmp_path, answers=answers)
    assert session.code == 0, session.text
    assert len(session.asked) == 8
    assert session.text.count("error: ") == 1
    shown = session.text.rindex("messung-interpretation.png: written."), session.text.index("All 5 parameters")
    assert shown[0] < session.text.index("Is this correct") < shown[1]
    assert (tmp_path / "messung-interpretation.png").read_bytes()[:4] == b"\x89PNG"
    compare(tmp_path / "result.toml", recording="messung")


def test_a_logger_with_milliseconds_by_options(installed, tmp_path):
    logger_file(tmp_path / "log.csv")
    command = ("poppet", "identify", "tank", "--from", "log.csv", "-o", "result.toml")
    listed = installed.run(*command, folder=tmp_path)
    assert listed.returncode == 2
    for option in (
        '--time "Zeit [s]"',
        "--reference gauge",
        "--opens free",
        '--volume "20 l"',
        '--ambient "1.013 bar"',
    ):
        assert option in listed.stderr
    assert not (tmp_path / "log.toml").exists()
    options = ("--time", "Zeit [ms]", "--pressure", "p1 [mbar g]", "--opens", "free", *KNOWN)
    done = installed.run(*command, *options, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    compare(tmp_path / "result.toml", recording="log")
    # The written file stays valid by itself.
    assert installed.run("poppet", "identify", "tank", "log.toml", folder=tmp_path).returncode == 0


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (("--pressure", "p1 [mbar a]", "--time", "Zeit [ms]", "--opens", "free"), "gauge pressure"),
        (("--pressure", "p1 [mbar g]", "--time", "Zeit [s]", "--opens", "free"), "milliseconds"),
        (("--pressure", "p1 [mbar g]", "--time", "Zeit [ms]", "--opens", "0.5 s"), "begins to change at 2.3"),
    ],
)
def test_each_trap_stops_the_fit(installed, tmp_path, wrong, message):
    logger_file(tmp_path / "log.csv")
    stopped = installed.run("poppet", "identify", "tank", "--from", "log.csv", *wrong, *KNOWN, folder=tmp_path)
    assert stopped.returncode == 2
    assert message in stopped.stderr
    assert not (tmp_path / "log.toml").exists()
    assert "log-interpretation.png: written." in stopped.stdout
