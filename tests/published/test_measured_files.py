"""Files that others measured, read as they are: values, units, notes and suspicions.

Discharge: HydDown validation set `Air_790kPa_21mm` (MIT). Two tanks: CHE260 laboratory,
PeterL-Engineering/CHE260_Thermodynamics_Heat_Transfer (Apache-2.0). Cylinder: EvaZillen/3D-printed-pneumatic-actuator
(CC0). Regulators: ASU-RISE-Lab/4-chamber-softarm-control (MIT). Lung: RespiraWorks/Ventilator (Apache-2.0).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet.core.codes import Note
from poppet.timeseries.measurements import Measurement, noise_of, read_measurement
from poppet.timeseries.tables.reading import read_table

DATA = Path(__file__).resolve().parents[3] / "shared" / "data"
PSI = 6894.757293168
AMBIENT = 101325.0
pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the measured data are not beside this checkout")


def read(folder: str, table: dict[str, Any]) -> Measurement:
    return read_measurement("test", table, DATA / folder, ambient_pressure=AMBIENT)


def about(found: Measurement, code: str) -> Note:
    (note,) = [note for note in found.findings if note.code == code]
    return note


def test_every_file_is_read() -> None:
    # The times of chamber_leaks have thousands separators, which no reader accepts.
    candidates = [file for file in sorted(DATA.glob("*/*")) if file.suffix in (".csv", ".txt")]
    files = [file for file in candidates if file.parent.name != "chamber_leaks"]
    assert len(files) >= 14
    for file in files:
        table = read_table(file)
        assert len(table.names) >= 2, file
        assert all(np.isfinite(column).all() for column in table.columns), file


def fill(**changes: Any) -> Measurement:
    table = {
        "file": "fill_left.txt",
        "time": {"column": "Time(s)", "unit": "s"},
        "tank.pressure": {"column": "P1(PSI)", "unit": "psi g"},
        "tank.temperature": {"column": "T1(Deg C)", "unit": "degC"},
        "inputs": {"inlet.mass_flow_rate": {"column": "Mass Flowrate(g/min)", "unit": "g/min"}},
        "start": {"tank.initial_pressure": "first"},
    }
    return read("two_tanks", table | changes)


def test_a_labview_log() -> None:
    table = read_table(DATA / "two_tanks" / "fill_left.txt")
    assert table.names == ("Time", "T1", "T2", "P1", "P2", "Mass Flowrate")
    assert table.units == ("s", "degC", "degC", "psi", "psi", "g/min")
    assert [column[1] for column in table.columns] == [0.1, 23.1, 23.1, 1.2, 3.5, 0.0]
    assert Note("table.header_line", number=1, text="Ambient Temperature(C): 23.8") in table.notes


def test_the_filled_tank_in_si() -> None:
    found = fill()
    pressure, temperature = found.channels
    assert pressure.values[:3] == pytest.approx(AMBIENT + PSI * np.array([1.6, 1.2, 2.1]))
    assert pressure.quantum == pytest.approx(0.1 * PSI)
    assert noise_of(pressure.values) == pytest.approx(1.6e3, rel=0.15)
    assert temperature.values[0] == pytest.approx(273.15 + 23.1)
    assert found.inputs[0].values.max() == pytest.approx(64.27 / 6e4)
    assert (found.duration, pressure.time.size) == (pytest.approx(87.8), 879)


def test_the_flow_meter_is_late_and_the_thermometer_slow() -> None:
    found = fill()
    late = about(found, "suspicion.recorded_late")
    assert (late.address, late.facts["shift"]) == ("inlet.mass_flow_rate", pytest.approx(1.3, abs=0.3))
    assert late.facts["silent_until"] == pytest.approx(13.8)
    assert late.facts["moved"] == pytest.approx(12e3, abs=1e3)
    assert about(found, "suspicion.slow_sensor").address == "tank.temperature"


def test_a_gauge_pressure_without_its_mark_is_suspected() -> None:
    found = fill(**{"tank.pressure": {"column": "P1(PSI)"}})
    assert about(found, "suspicion.read_as_absolute").address == "tank.pressure"


def test_a_digitised_discharge_in_two_files() -> None:
    found = read(
        "tank_discharge_16l",
        {
            "file": "pressure.csv",
            "time": {"column": "t_s", "unit": "s"},
            "tank.pressure": {"column": "p_bar_abs", "unit": "bar"},
            "tank.temperature": {
                "column": "T_gas_K",
                "unit": "K",
                "lag": "free",
                "file": "gas_temperature.csv",
                "time": {"column": "t_s", "unit": "s"},
            },
        },
    )
    pressure, temperature = found.channels
    assert (pressure.time.size, temperature.time.size) == (15, 14)
    assert pressure.values[0] == pytest.approx(7.6883e5)
    assert temperature.time[0] == pytest.approx(3.58 - 0.226)
    assert temperature.values[0] == 285.9
    assert any("V=pi/4*0.2^2*0.515 m3" in note.facts["text"] for note in found.notes if note.code == "table.comment")
    assert found.findings == ()


def test_a_log_without_headings_in_milliseconds() -> None:
    table = {"file": "friction_oring_3bar.csv", "cylinder.pressure": {"column": 5, "unit": "bar g"}}
    wrong = read("cylinder_25mm", table | {"time": {"column": 0}})
    assert about(wrong, "suspicion.milliseconds").facts["step"] > 1.0
    right = read("cylinder_25mm", table | {"time": {"column": 0, "unit": "ms"}, "skip": "150 ms"})
    assert "suspicion.milliseconds" not in {note.code for note in right.findings}
    assert right.channels[0].values.min() > AMBIENT + 2.5e5


def test_repeated_stamps_of_a_regulator() -> None:
    table = {"file": "jan10-2_1.csv", "time": "t_s", "arm.pressure": {"column": "pm1_psi", "unit": "psi g"}}
    found = read("regulator_itv0050", table)
    assert Note("measured.repeated_stamps", "arm.pressure", count=3) in found.notes
    assert found.channels[0].time.size == 1270
    assert about(found, "suspicion.uneven").address == "arm.pressure"


@pytest.mark.parametrize(
    ("folder", "table"),
    [
        (
            "cylinder_25mm",
            {"file": "leak_aluminium.csv", "time": "t_s", "a.pressure": {"column": "p_bar", "unit": "bar g"}},
        ),
        (
            "proportional_solenoid",
            {"file": "covent_pc_1.csv", "time": "time(sec)", "lung.pressure": {"column": "pressure", "unit": "kPa g"}},
        ),
    ],
)
def test_sound_recordings_are_not_suspected(folder: str, table: dict[str, Any]) -> None:
    assert read(folder, table).findings == ()
