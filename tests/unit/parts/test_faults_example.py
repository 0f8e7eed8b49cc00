"""Results of the example of faults that its page states."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from poppet import load

ROOT = Path(__file__).parents[3]
AIR_ANR = 1.185
"""Density of air at 1 bar and 20 degC with 65 % humidity [kg/m^3], ISO 8778."""


def numbers_of_page() -> dict[str, list[str]]:
    """Cells of the table of results by fault."""
    text = (ROOT / "docs" / "faults.md").read_text(encoding="utf-8")
    table = text[text.index("| `valve.fault` |") :].partition("\n\n")[0]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()[2:]]
    return {name.strip("`"): cells for name, *cells in rows}


@pytest.mark.parametrize("fault", ["none", "stuck_open", "stuck_closed", "stuck", "slow", "leak"])
def test_results_of_the_page(fault):
    run = load(ROOT / "examples" / "valve_faults.toml").with_values({"valve.fault": fault}).simulate()
    returned, second, pressure, air = numbers_of_page()[fault]
    time, position = run.time, run["slide.position"]
    below = time[(time > 1.0) & (position < 1e-3)]
    assert returned.startswith("never") if not below.size else returned == f"{below[0]:.2f} s"
    is_back = bool(np.interp(1.79, time, position) < 1e-3)
    arrived = time[(time > 1.8) & (position > 99e-3)]
    if not is_back:
        assert second == "none; already extended"
    else:
        assert second == (f"1.8 to {arrived[0]:.1f} s" if arrived.size else "never")
    assert pressure == f"{run['cylinder.cap.pressure'][-1] / 1e5:.1f} bar"
    supplied = np.trapezoid(np.where(time < 3.4, run["supply.mass_flow_rate"], 0.0), time)
    assert air == f"{1e3 * supplied / AIR_ANR:.2f} l ANR"
