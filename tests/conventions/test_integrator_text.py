"""The shipped integrator is the one of its source, and runs as the source does when numba compiles it afresh."""

from __future__ import annotations

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.engine import call, compiled


@pytest.mark.parametrize(
    "shipped", [compiled.INTEGRATOR, compiled.LANES, compiled.ESTIMATOR], ids=lambda each: each.entry
)
def test_the_text_is_made_from_the_present_source(shipped: compiled.PrebuiltIntegrator) -> None:
    path = compiled.Path(compiled.__file__).with_name(shipped.text)
    first = path.read_text(encoding="utf-8").partition("\n")[0]
    assert first == f"; {shipped.mark()}", "run `make integrator` after a change of engine/integrator.py or its kin"


@pytest.mark.slow  # numba takes most of a minute on a busy machine; the mark above tells of a forgotten change
def test_shipped_and_fresh_integrators_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("numba", reason="only developers need numba")
    from poppet.engine import integrator

    circuit = Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
            "tank": Chamber(volume="10 l", wall_conductance=1.0),
        }
    )
    shipped = circuit.simulate("20 s", "0.1 s", stop_when="tank.pressure > 6 bar")
    fresh = compiled.load(compiled.optimised_object(integrator.integrator_text()), ["integrate"])
    function = compiled.as_function(fresh)
    monkeypatch.setattr(call, "integrator", lambda: function)
    again = circuit.simulate("20 s", "0.1 s", stop_when="tank.pressure > 6 bar")
    assert again.statistics == shipped.statistics
    assert np.max(np.abs(again.values - shipped.values) / (1e-12 + np.abs(shipped.values))) < 1e-9


def test_nothing_of_numba_is_imported_by_a_run() -> None:
    import subprocess
    import sys

    code = (
        "import sys, poppet\n"
        "c = poppet.Circuit({'s': poppet.Reservoir(pressure=2e5), 't': poppet.Chamber(volume=1e-3),\n"
        "  'o': poppet.Orifice(from_='s', to='t', sonic_conductance=1e-9, critical_ratio=0.3)})\n"
        "c.simulate(1.0)\n"
        "assert not {'numba', 'scipy'} & set(sys.modules), sorted(sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
