"""Tests of watches that are exported as FMUs, in the importer FMPy."""

from __future__ import annotations

import numpy as np
import pytest

from exported_watch_example import FOLDER, recorded, tank_watch
from poppet.deploy.exported_watch import ExportedWatch
from poppet.deploy.fmu.watch_package import export_fmu_watch
from refusals import refused

fmpy = pytest.importorskip("fmpy")
STEP, SAMPLES = 0.125, 1200
"""Step with exact sums in binary, so that importer and reference have the same times."""


@pytest.mark.parametrize("fmi", ["2", "3"])
def test_estimates_have_the_bits_of_python(fmi, tmp_path):
    from fmpy.validation import validate_fmu

    source = tank_watch()
    path = tmp_path / "tank.fmu"
    (content,) = export_fmu_watch(source, fmi=fmi, name="tank").files.values()
    path.write_bytes(content)
    assert validate_fmu(str(path)) == []
    description = fmpy.read_model_description(str(path))
    references = {variable.name: variable.valueReference for variable in description.modelVariables}
    folder = fmpy.extract(str(path), str(tmp_path / "unpacked"))
    fmu = fmpy.instantiate_fmu(folder, description, fmi_type="CoSimulation")
    if fmi == "2":
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
        write, read = fmu.setReal, fmu.getReal
    else:
        fmu.enterInitializationMode(startTime=0.0)
        write, read = fmu.setFloat64, fmu.getFloat64
    fmu.exitInitializationMode()
    inputs = [references[f"measured.{item.address}"] for item in (*source.plan.channels, *source.plan.inputs)]
    names = [fault.name for fault in source.plan.faults]
    outputs = [references[f"faults.{name}.{kind}"] for kind in ("value", "sigma") for name in names]
    outputs += [references["nis"], *(references[f"faults.{name}.alarm"] for name in names)]
    watch, kept = ExportedWatch(source.plan, source.baseline), None
    for k, (_, readings, driven) in enumerate(recorded(source, FOLDER / "day.csv")[1500 : 1500 + SAMPLES]):
        readings = readings if k % 10 else np.full(readings.size, np.nan)
        write(inputs, [*readings, *driven])
        fmu.doStep(k * STEP, STEP)
        watch.update(k * STEP, readings, driven)
        row = watch.row()
        values = list(read(outputs))
        assert values[: len(row) - 1] == row[:-1], k
        assert sum(2**j for j, alarm in enumerate(values[len(row) - 1 :]) if alarm) == row[-1]
        if k == SAMPLES // 2:  # later samples are repeated from a stored state
            kept = fmu.getFMUState() if fmi == "3" else fmu.getFMUstate()
            stored = k, row
    (fmu.setFMUState if fmi == "3" else fmu.setFMUstate)(kept)
    assert list(read(outputs))[: len(row) - 1] == stored[1][:-1]
    fmu.terminate()
    fmu.freeInstance()


def test_an_unknown_platform():
    with refused("fields.not_an_option", "platform"):
        export_fmu_watch(tank_watch(), platform="linux65")
