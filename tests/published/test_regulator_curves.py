"""Flow characteristics of six regulators from a catalogue, and those of a fitted `pressure_regulator`.

Source: SMC catalogue es40-69-AC-D, pages 22 (AC, with filter and lubricator) and 103 (AR), representative values for a
supply of 7 bar g and a setpoint of 5 bar g. The curves were digitised by a third party (PneuComplete on GitHub,
db/seed/charts/ac-flow.yaml, 2026); they were not compared with the catalogue itself.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from poppet import Circuit, PressureRegulator, Reservoir
from poppet.signals import Points

ROOT = Path(__file__).parents[2]
# Flow [l/min ANR] and outlet pressure [MPa g].
CURVES = {
    "AR20": [
        (0, 0.496), (7.2, 0.489), (69.3, 0.472), (213.9, 0.451), (474.8, 0.431), (809.6, 0.409), (1123.7, 0.384),
        (1372, 0.36), (1509.4, 0.343),
    ],
    "AR30": [
        (0, 0.497), (6.7, 0.49), (102.7, 0.475), (327, 0.457), (732.6, 0.445), (1182.2, 0.438), (1523, 0.434),
        (1783.5, 0.431), (1992.3, 0.429), (2259.3, 0.424), (2596.3, 0.414), (2885, 0.404), (3007.5, 0.4),
    ],
    "AR40": [
        (0, 0.498), (24, 0.493), (172.3, 0.482), (475.8, 0.468), (980.6, 0.456), (1554.9, 0.449), (2029.8, 0.444),
        (2395.5, 0.442), (2642.5, 0.442), (3087.7, 0.441), (3842.8, 0.439), (4589.3, 0.437), (5009.1, 0.432),
    ],
    "AC20": [
        (0, 0.501), (2.6, 0.497), (19.9, 0.486), (44.5, 0.474), (72.8, 0.465), (142, 0.455), (263.9, 0.44),
        (396.9, 0.426), (499.1, 0.416), (606.1, 0.406), (753.9, 0.392), (901.3, 0.377), (1007.4, 0.364),
        (1106.7, 0.348), (1242.6, 0.323), (1387.3, 0.29), (1513, 0.248),
    ],
    "AC30": [
        (0, 0.498), (23.7, 0.488), (86.1, 0.476), (194.8, 0.468), (361.7, 0.461), (571.6, 0.451), (795.6, 0.442),
        (1005, 0.436), (1238.6, 0.431), (1518.9, 0.424), (1792.7, 0.416), (2006.5, 0.409), (2214.8, 0.398),
        (2480.2, 0.378), (2761.6, 0.351), (3018, 0.318),
    ],
    "AC40": [
        (0, 0.496), (24.1, 0.486), (131.4, 0.474), (325.4, 0.465), (674.7, 0.456), (1149.6, 0.445), (1627.8, 0.434),
        (1986.9, 0.428), (2282.2, 0.426), (2624, 0.423), (2973.5, 0.42), (3291.8, 0.416), (3575.8, 0.412),
        (3843.9, 0.406), (4089, 0.399), (4303.9, 0.39), (4527.5, 0.376), (4762.5, 0.359), (4948.2, 0.343),
        (5023.6, 0.337),
    ],
}  # fmt: skip


@pytest.mark.parametrize("name", CURVES)
def test_deviations_are_those_of_the_page(name: str) -> None:
    page = (ROOT / "docs" / "supply.md").read_text(encoding="utf-8")
    (row,) = re.findall(rf"^\| {name} \| (.*) \|$", page, re.MULTILINE)
    conductance, droop, rms, largest = (float(cell) for cell in row.split(" | "))
    regulator = PressureRegulator(
        supply="net", outlet="line", setpoint="5 bar g", hysteresis=0.0, droop=droop * 1e5, lag=1e-4,
        sonic_conductance=conductance * 1e-8, critical_ratio=0.3, exhaust_conductance=0.0,
    )  # fmt: skip
    # The prescribed outlet pressure falls slowly.
    parts = {"net": Reservoir(pressure="7 bar g"), "regulator": regulator, "line": Reservoir(pressure=6e5)}
    run = Circuit(parts, {"line.pressure": Points([0.0, 100.0], [6e5, 2.5e5])}).simulate(100.0, 0.05)
    flow = run["regulator.supply_mass_flow_rate"] / 1.185 * 60e3
    curve = np.array(CURVES[name])
    deviation = np.interp(curve[:, 0], flow, run["line.pressure"] / 1e5) - (10.0 * curve[:, 1] + 1.0)
    assert np.sqrt(np.mean(deviation**2)) == pytest.approx(rms, abs=0.006)
    assert np.abs(deviation).max() == pytest.approx(largest, abs=0.01)
