"""Air and exergy of a double stroke of a cylinder, calculated by hand, and the circuit for which it is valid.

A cylinder of 32 x 200 mm (rod 12 mm) makes a double stroke at 6 bar gauge; its exhaust is throttled (meter-out). The
calculation assumes that each chamber reaches the supply pressure p_s and the ambient temperature T_a in its stroke, and
that it is vented to the ambient pressure p_a in the other one. Then a chamber with the dead volume d takes the air

    m = [p_s (A s + d) - p_a d] / (R T_a)

per cycle, from a reservoir at T_a whose flow exergy is e = R T_a ln(p_s/p_a).

| quantity | cap | rod |
|---|---|---|
| area A | pi/4 (32 mm)^2 = 804.25 mm^2 | less pi/4 (12 mm)^2 = 691.15 mm^2 |
| displacement A s | 160.85 cm^3 | 138.23 cm^3 |
| dead volume d with hose | 20 cm^3 | 20 cm^3 |
| p_s (A s + d) - p_a d | 124.6 J | 108.8 J |

The sum of 233.4 J gives m = 2.773 g, that is 2.340 l at ANR (1.185 kg/m^3), and m e = 233.4 J * ln 7 = 454.1 J. With
an ambient pressure of 1.01325 bar instead of 1 bar, the results are 2.344 l and 452.2 J. Both are within 0.5 % of the
figures 2.34 l and 453 J.

Without dead volumes, the same calculation gives 2.10 l and 407 J: the figures contain about 20 cm^3 at each end.
"""

from __future__ import annotations

import math

BORE, ROD, STROKE, DEAD = 32e-3, 12e-3, 200e-3, 20e-6
GAUGE = 6e5
GAS, WARM, DENSITY = 287.05, 293.15, 1.185
AIR_L_ANR, EXERGY_J = 2.34, 453.0
"""Expected figures of a double stroke."""


def double_stroke(ambient: float = 1e5, dead: float = DEAD) -> tuple[float, float]:
    """Return the air [l ANR] and the supplied exergy [J] of a double stroke."""
    supply = ambient + GAUGE
    cap = math.pi / 4 * BORE**2
    ring = cap - math.pi / 4 * ROD**2
    filled = sum(supply * (area * STROKE + dead) - ambient * dead for area in (cap, ring))
    mass = filled / (GAS * WARM)
    return 1e3 * mass / DENSITY, mass * GAS * WARM * math.log(supply / ambient)


PERIOD = 16.0
"""Period of the command [s]. The gas needs some seconds to reach the temperature of the wall."""


def circuit_text(ambient: float = 1e5) -> str:
    """Write a circuit that fulfils the assumptions: long rests in both positions, no hoses beside the dead volumes.

    The command rises at 0.5 s and at each period after that. The run contains two periods. The first one starts in the
    state that the second one repeats: extended never, rod side filled.
    """
    half = 0.5 * PERIOD
    return f"""
[ambient]
pressure = {ambient}
[parts.supply]
kind = "reservoir"
pressure = {ambient + GAUGE}
[parts.valve]
kind = "spool_valve"
function = "5/2 monostable"
supply = "supply"
a = "cylinder.cap"
b = "cylinder.rod"
sonic_conductance = "1.2 dm^3/(s bar)"
critical_ratio = 0.3
exhaust_a_conductance = "0.3 dm^3/(s bar)"    # meter-out: throttles in the exhaust ports
[parts.cylinder]
kind = "cylinder"
body = "slide"
bore = {BORE}
rod_diameter = {ROD}
stroke_length = {STROKE}
cap = {{ dead_volume = {DEAD}, wall_conductance = 1.0 }}
rod = {{ dead_volume = {DEAD}, wall_conductance = 1.0, initial_pressure = {ambient + GAUGE} }}
[parts.slide]
kind = "mass"
mass = 3.0
friction = {{ viscous_coefficient = 60.0 }}
[signals."valve.command"]
kind = "steps"
times = [0.0, 0.5, {0.5 + half}, {0.5 + PERIOD}, {0.5 + PERIOD + half}]
values = [0, 1, 0, 1, 0]
[run]
duration = {0.5 + 2 * PERIOD}
output_step = 0.01
"""
