"""First steps in Python: load a circuit, run it, change a parameter, read the result.

Run: python examples/first_steps.py

Run: python examples/first_steps.py
"""

from __future__ import annotations

from pathlib import Path

import poppet

circuit = poppet.load(Path(__file__).parent / "fill_staircase.toml")
recording = circuit.simulate()

print(circuit.title)
print(recording.outcome)
for volume in ("0.1 m^3", "0.2 m^3", "0.4 m^3"):
    changed = circuit.with_values({"tank.volume": volume}).simulate()
    peak = changed.converted(["bar"])["tank.pressure"].max()
    print(f"tank of {volume}: highest pressure {peak:.3f} bar")

# Each parameter has a source; measure the assumed ones first.
assumed = [address for address, number in circuit.numbers().items() if number.source.kind == "assumed"]
print(f"{len(assumed)} of {len(circuit.numbers())} numbers are assumed, {assumed[0]} for example.")

# Mass and energy are computed in two independent ways; the difference is the residual.
for balance in recording.residuals:
    print(f"{balance.name}: residual {balance.error:.1e} of {balance.allowed:.1e} {balance.unit} allowed")
