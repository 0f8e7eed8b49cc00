"""Files outside the folder cannot be read through the files of the folder, whatever their format."""

from __future__ import annotations

import pytest

from poppet.assist.folder import Folder
from poppet.assist.functions import FUNCTIONS, perform
from poppet.core.errors import InputError
from small_fmus import DESCRIPTION, write_fmu

FIT = """
circuit = "{circuit}"

[free]
"valve.sonic_conductance" = {{}}

[recordings.fill]
file = "{recording}"
time = {{ column = "t", unit = "s" }}
"tank.pressure" = {{ column = "p", unit = "bar" }}
"""
FLOW = """
file = "{recording}"
mass_flow_rate = {{ column = "q", unit = "g/s" }}
pressure_1 = {{ column = "p1", unit = "bar" }}
pressure_2 = {{ column = "p2", unit = "bar" }}
temperature_1 = {{ column = "T1", unit = "degC" }}
"""


def refused(folder, name, **arguments) -> list[str]:
    with pytest.raises(InputError) as caught:
        perform(Folder.of(folder), FUNCTIONS[name], arguments)
    return [problem.code for problem in caught.value.problems]


@pytest.fixture
def outside(folder):
    """Recordings beside the folder."""
    for suffix in ("csv", "txt", "parquet", "mat", "mf4", "mdf", "tdms"):
        (folder.parent / f"run.{suffix}").write_text("t,p,q,p1,p2,T1\n0,1,1,7,1,20\n1,2,2,7,2,20\n2,3,3,7,3,20\n")
    (folder.parent / "tank.toml").write_text((folder / "tank.toml").read_text())
    return folder


@pytest.mark.parametrize("suffix", ["csv", "txt", "parquet", "mat", "mf4", "mdf", "tdms"])
@pytest.mark.parametrize("place", ["../run", "{parent}/run"])
def test_recordings(outside, suffix, place):
    recording = f"{place.format(parent=outside.parent.as_posix())}.{suffix}"
    (outside / "fit.toml").write_text(FIT.format(circuit="tank.toml", recording=recording))
    assert refused(outside, "identify", method="fit", file="fit.toml") == ["files.outside"]
    (outside / "flow.toml").write_text(FLOW.format(recording=recording))
    assert refused(outside, "identify", method="flow", file="flow.toml") == ["files.outside"]


def test_circuits_of_fits(outside):
    (outside / "run.csv").write_text("t,p\n0,1\n1,2\n2,3\n")
    (outside / "fit.toml").write_text(FIT.format(circuit="../tank.toml", recording="run.csv"))
    assert refused(outside, "identify", method="fit", file="fit.toml") == ["files.outside"]


def test_characteristics(outside):
    (outside.parent / "curve.toml").write_text('kind = "constant"\nsonic_conductance = 1e-8\ncritical_ratio = 0.3\n')
    text = (outside / "tank.toml").read_text()
    stated = 'sonic_conductance = "0.5 dm^3/(s bar)"\ncritical_ratio = 0.35'
    text = text.replace(stated, 'characteristic = "../curve.toml"')
    assert refused(outside, "check", text=text) == ["parts.unreadable_file"]


def test_results_that_distributions_refer_to(outside):
    (outside.parent / "result.toml").write_text('method = "fit"\n')
    text = (
        outside / "tank.toml"
    ).read_text() + '[ensemble]\nruns = 2\n[ensemble.parameters]\nfrom_fit = "../result.toml"\n'
    text += '[ensemble.metrics]\nx = { of = "tank.pressure", metric = "max" }\n'
    assert "files.outside" in refused(outside, "check", text=text)
    assert "files.outside" in refused(outside, "ensemble", text=text)


def test_a_link_in_a_circuit(outside):
    (outside / "opening.csv").symlink_to(outside.parent / "run.csv")
    signal = '[signals."valve.opening"]\nkind = "file"\npath = "opening.csv"\ncolumn = "p"\ntime = "t"\n'
    assert refused(outside, "check", text=(outside / "tank.toml").read_text() + signal) == ["files.outside"]


def test_a_large_ensemble_is_rejected(outside):
    text = (outside / "tank.toml").read_text() + "[ensemble]\nruns = 100\nindices = 8192\n"
    text += '[ensemble.parameters]\n"tank.volume" = { distribution = "normal", relative_sigma = 0.1 }\n'
    text += '[ensemble.metrics]\nx = { of = "tank.pressure", metric = "max" }\n'
    assert refused(outside, "ensemble", text=text) == ["assist.too_many_runs"]


def test_recordings_and_components_behind_links(outside):
    (outside.parent / "components.toml").write_text("[components]\n")
    (outside / "link").symlink_to(outside.parent, target_is_directory=True)
    text = (outside / "tank.toml").read_text()
    signal = '[signals."valve.opening"]\nkind = "file"\npath = "link/run.csv"\ncolumn = "p"\ntime = "t"\n'
    for changed in (text + signal, f'components = ["link/components.toml"]\n{text}'):
        assert refused(outside, "check", text=changed) == ["files.outside"]
        assert refused(outside, "simulate", text=changed) == ["files.outside"]


NATIVE = """
[parts.extra]
kind = "fmu"
path = "extra.fmu"
"""


def test_no_function_executes_an_fmu(outside):
    write_fmu(outside / "extra.fmu", DESCRIPTION.format(variable="true", interpolates="true", rolls="true"))
    text = (outside / "tank.toml").read_text() + NATIVE
    for name in ("check", "parameters", "simulate", "ensemble", "audit_energy", "audit_faults"):
        assert refused(outside, name, text=text) == ["assist.native"], name
    # A fit names its circuit itself.
    (outside / "native.toml").write_text(text)
    rows = [f"{0.1 * k:.1f},{1.0 + 0.05 * k}" for k in range(50)]
    (outside / "run.csv").write_text("\n".join(["t,p", *rows, ""]))
    (outside / "fit.toml").write_text(FIT.format(circuit="native.toml", recording="run.csv"))
    assert refused(outside, "identify", method="fit", file="fit.toml") == ["fmu.unavailable"]


@pytest.mark.parametrize("path", ["../extra.fmu", "{parent}/extra.fmu", "link/extra.fmu", "/etc/passwd"])
def test_no_function_reads_an_fmu_outside(outside, path):
    """The circuit of a fit is read without the check of the other functions."""
    write_fmu(outside.parent / "extra.fmu", DESCRIPTION.format(variable="true", interpolates="true", rolls="true"))
    (outside / "link").symlink_to(outside.parent, target_is_directory=True)
    text = NATIVE.replace("extra.fmu", path.format(parent=outside.parent.as_posix()))
    (outside / "native.toml").write_text((outside / "tank.toml").read_text() + text)
    assert refused(outside, "check", file="native.toml") == ["assist.native"]
    (outside / "run.csv").write_text("t,p\n0,1\n1,2\n2,3\n")
    (outside / "fit.toml").write_text(FIT.format(circuit="native.toml", recording="run.csv"))
    assert refused(outside, "identify", method="fit", file="fit.toml") == ["files.outside"]
