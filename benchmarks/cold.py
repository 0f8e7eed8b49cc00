"""From process start to a CSV file on disk, in fresh processes: poppet against a SciPy script.

Cases: everything cached; a topology this machine has never seen (the integrator is cached, the model is not); the very
first run after installation (an empty cache). The SciPy script simulates the staircase of `staircase.py`.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

FOLDER = Path(__file__).parent
EXAMPLE = FOLDER.parent / "examples" / "fill_staircase.toml"
SCIPY = f"""
import sys; sys.path.insert(0, {str(FOLDER)!r})
import numpy as np
from peer import NUMBERS, START, peer_rates, peer_run
rows = peer_run(peer_rates(NUMBERS), START, 3e-7)
np.savetxt(sys.argv[1], rows.T, delimiter=",", header="x,v,p,m,Q")
"""


def seconds(command: list[str], environment: dict[str, str]) -> float:
    """Wall time of one process that must succeed."""
    begin = time.perf_counter()
    subprocess.run(command, check=True, capture_output=True, env=environment)
    return time.perf_counter() - begin


def unseen(folder: Path, number: int) -> Path:
    """A circuit with one more tank and bleed than the example, under names of its own."""
    text = EXAMPLE.read_text(encoding="utf-8")
    more = "".join(
        f'\n[parts.link{k}]\nkind = "orifice"\nfrom = "tank"\nto = "side{k}"\nsonic_conductance = 1e-9\n'
        f'critical_ratio = 0.3\n\n[parts.side{k}]\nkind = "chamber"\nvolume = "1 l"\n'
        for k in range(number + 1)
    )
    path = folder / f"unseen{number}.toml"
    path.write_text(text + more, encoding="utf-8")
    return path


def main(size: float = 1.0) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        out = str(folder / "out.csv")
        environment = dict(os.environ, POPPET_CACHE_DIR=str(folder / "cache"))
        simulate = [sys.executable, "-m", "poppet", "simulate"]
        first = seconds([*simulate, str(EXAMPLE), "-o", out], environment)
        rows: dict[str, list[float]] = {"SciPy LSODA script": [], "poppet, cached": [], "poppet, new topology": []}
        for k in range(max(1, round(7 * size))):
            rows["SciPy LSODA script"].append(seconds([sys.executable, "-c", SCIPY, out], environment))
            rows["poppet, cached"].append(seconds([*simulate, str(EXAMPLE), "-o", out], environment))
            rows["poppet, new topology"].append(seconds([*simulate, str(unseen(folder, k)), "-o", out], environment))
    print(f"{'process start to CSV written':32s} {'median s':>9s} {'fastest s':>10s}")
    for label, times in rows.items():
        print(f"{label:32s} {statistics.median(times):9.2f} {min(times):10.2f}")
    print(f"{'poppet, very first run':32s} {first:9.2f}")


if __name__ == "__main__":
    main()
