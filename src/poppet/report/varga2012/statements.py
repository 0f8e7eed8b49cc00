"""What Varga & Keski-Honkola 2012 state, one by one, and what the simulator finds."""

from __future__ import annotations

import enum
from dataclasses import dataclass

import numpy as np

from poppet.report.varga2012.circuits import REPORTED_RISE, START_TEMPERATURE, SUPPLIES, SUPPLY, TANKS
from poppet.report.varga2012.runs import Findings


class Verdict(enum.Enum):
    """What becomes of a statement; the value is what a reader sees."""

    HOLDS = "holds"
    FAILS = "does not hold"
    OPEN = "cannot be told"


@dataclass(frozen=True)
class Statement:
    """One statement of the paper.

    Parameters
    ----------
    text : str
        What the paper says.
    place : str
        Where.
    finding : str
        What the simulator finds, with numbers.
    verdict : Verdict
        Whether it holds.
    """

    text: str
    place: str
    finding: str
    verdict: Verdict


def statements(found: Findings) -> tuple[Statement, ...]:
    """All statements with their verdicts."""
    return (
        *_flow_law(found),
        *_characteristic(found),
        *_mechanics(found),
        *_tank(found),
        *_conclusions(found),
    )


def _if(condition: bool) -> Verdict:
    return Verdict.HOLDS if condition else Verdict.FAILS


def _conductance(value: float) -> str:
    return f"{1e8 * value:.3f}e-8 m³/(s Pa)"


def _flow_law(found: Findings) -> tuple[Statement, ...]:
    return (
        Statement(
            "Air flow is described by ISO 6358: choked at p2/p1 <= b, subsonic above, with C(x) and b(x).",
            "section 2.1, eqs (1), (2)",
            "The flow law with subsonic index 0.5 (edition of 1989) is eqs (1) and (2) as printed: largest "
            f"difference {found.law_deviation:.1g} of choked flow, at eleven strokes and pressure ratios up "
            "to "
            f'0.999; closer to 1 it is regularised. "Checked flow" is a misprint of choked.',
            _if(found.law_deviation < 1e-9),
        ),
        Statement(
            "T0 means upstream temperature, T1 means downstream temperature.",
            "section 2.1, list of symbols",
            "In ISO 6358 T0 = 293.15 K belongs to the reference atmosphere, like rho0, and T1 is the "
            "upstream temperature; the downstream one never enters. With T1 read as the temperature in an "
            f"adiabatic tank at 5 bar, choked flow would be off by {100 * found.downstream_error:.1f} %.",
            _if(abs(found.downstream_error) < 1e-3),
        ),
        Statement(
            "The stroke x has a range in mm, determined on the actual valve (0..1 on the axes of figs 3 and 4).",
            "section 2.1; figs 3, 4",
            "On 0..1 mm the polynomials are physical: C > 0 and 0 < b < 1. Beyond, C falls through zero at "
            f"{1e3 * found.zero_beyond:.3f} mm and would be {_conductance(found.conductance_beyond)} at 1.2 "
            "mm, so the range is binding.",
            _if(min(found.conductances) > 0.0 and min(found.ratios) > 0.0 and max(found.ratios) < 1.0),
        ),
    )


def _characteristic(found: Findings) -> tuple[Statement, ...]:
    c, b, (stroke, largest) = found.conductances, found.ratios, found.largest
    return (
        Statement(
            "C and b are not constant but nonlinear functions of the poppet position.",
            "section 3, under fig. 4",
            f"C grows {largest / c[0]:.1f}-fold, from {_conductance(c[0])} at zero to "
            f"{_conductance(largest)} at {1e3 * stroke:.3f} mm; b ranges from {found.smallest_ratio[1]:.3f} "
            f"(at {1e3 * found.smallest_ratio[0]:.3f} mm) to {b[0]:.3f}.",
            _if(largest > 1.1 * c[0] and b[0] > 1.1 * found.smallest_ratio[1]),
        ),
        Statement(
            "The printed C(x) is the approximation drawn in fig. 3.",
            "section 3, fig. 3 and Table 1",
            "The points of fig. 3 are not in the text. Its axis reaches 2.0e-8, the printed polynomial "
            f"{_conductance(largest)}, and from there it falls by {100 * (1 - c[-1] / largest):.1f} % as "
            "the valve opens further. With k5 = -2.2229e-6, one digit changed, it would reach "
            f"{_conductance(found.suspected_largest)} and be nearly monotone: a suspicion that nothing else "
            "here uses.",
            Verdict.OPEN,
        ),
        Statement(
            "The polynomials describe the passage from x = 0 on.",
            "section 3, figs 3, 4 and Table 1 (implied)",
            f"C(0) = {_conductance(c[0])}, {100 * c[0] / largest:.0f} % of the largest: a poppet on its "
            f"seat would pass {1e3 * found.leak:.2f} g/s from 7 bar. The polynomial has no closed state; a "
            "valve needs a closing law, here a smoothstep over 0.02 mm.",
            _if(c[0] < 1e-3 * largest),
        ),
    )


def _mechanics(found: Findings) -> tuple[Statement, ...]:
    low, high = found.open_end
    strokes = ", ".join(f"{1e6 * x:.1f}" for x in found.exhaust_strokes)
    filling = found.fillings["wall of the peak"].time
    return (
        Statement(
            "While emptying, the poppet moves to the same position every time, so C and b are constant.",
            "section 3, eqs (7), (8)",
            f"Emptying from 2, 4 and 6 bar the plate comes to rest at {strokes} µm: no pressure of the tank "
            "enters eq. (7). The constants C and b themselves are not printed; those used here are assumed.",
            _if(max(found.exhaust_strokes) - min(found.exhaust_strokes) < 1e-9),
        ),
        Statement(
            "Fig. 5 is the model of eqs (5) to (8).",
            "section 3, fig. 5 against eq. (5)",
            "Fig. 5 shows k2*(h2-x) where eq. (5) prints k2(h2 + x). With the assumed springs and 3 bar g "
            f"the stroke is {1e3 * found.stroke_printed:.3f} mm by the equation and "
            f"{1e3 * found.stroke_fig5:.3f} mm by the figure. The equation is followed: a spring that is "
            "compressed further pushes back harder.",
            _if(abs(found.stroke_fig5 - found.stroke_printed) < 1e-3 * found.stroke_printed),
        ),
        Statement(
            "The main stage of eqs (5) to (8) makes the tank pressure follow a required value.",
            "section 2.2 and fig. 6 (implied)",
            "No force of the outlet pressure p2 acts on the poppet in eqs (5) to (8): at a constant pilot "
            f"pressure of 1 and of 4 bar g the tank ends at {1e-5 * low:.3f} and {1e-5 * high:.3f} bar, the "
            "supply. Following needs the outlet pressure under the plate (regulator mode here), or the "
            "control left out of the paper.",
            _if(max(low, high) < 0.99 * SUPPLY),
        ),
        Statement(
            "Filling a large volume is too slow to show any dynamic behaviour of the main stage.",
            "section 1",
            f"With the assumed mechanics the stroke settles {1e3 * found.settling_time:.1f} ms after a "
            f"pilot step of 3 bar; the tank takes {filling:.0f} s to 5 bar.",
            _if(found.settling_time < 1e-2 * filling),
        ),
        Statement(
            "The model reacts faster than the real valve, since control and pilot stage are left out.",
            "abstract",
            f"Left alone, the main stage settles in {1e3 * found.settling_time:.1f} ms (assumed mechanics), "
            "and a pilot stage can only add to that. No response of the real valve is given to compare "
            "with.",
            Verdict.OPEN,
        ),
    )


def _tank(found: Findings) -> tuple[Statement, ...]:
    fill, wall = found.fillings, found.wall
    isentrope, adiabatic, peak = fill["isentrope"], fill["adiabatic"], fill["wall of the peak"]
    conductances = "/".join(f"{each.for_peak:.1f}" for each in found.walls)
    supplies = "/".join(f"{1e-5 * p:g}" for p in SUPPLIES)
    rise = isentrope.end_temperature - START_TEMPERATURE
    return (
        Statement(
            "The tank is isentropic because its gas warms by approximately 18 °C while it is filled.",
            "section 3, under Table 1",
            f"The isentrope p ~ rho^1.4 of fig. 5 warms by {rise:.0f} K from 1 to 5 bar, adiabatic charging "
            f"by {adiabatic.end_temperature - START_TEMPERATURE:.0f} K. A rise of {REPORTED_RISE:.0f} K "
            f"means n = {found.exponent:.3f} if it is that at 5 bar, or h A = {conductances} W/K at "
            f"{supplies} bar supply if it is the highest on the way: nearly isothermal.",
            _if(abs(rise - REPORTED_RISE) < 0.5 * REPORTED_RISE),
        ),
        Statement(
            "An isentropic tank is one that exchanges no heat.",
            "section 5 with fig. 5 (implied)",
            "The isentrope holds for a closed gas. Gas that streams in brings its enthalpy: the balance of "
            f"energy without heat gives {adiabatic.end_temperature:.1f} K and {adiabatic.time:.1f} s to 5 "
            f"bar, the isentrope {isentrope.end_temperature:.1f} K and {isentrope.time:.1f} s.",
            _if(abs(isentrope.time - adiabatic.time) < 1e-2 * adiabatic.time),
        ),
        Statement(
            "Measured pressure does not rise as fast as the model's.",
            "section 5",
            f"The isentrope reaches 5 bar in {isentrope.time:.1f} s, a tank with the wall heat of an 18 K "
            f"peak (h A = {wall.for_peak:.1f} W/K) in {peak.time:.1f} s, an isothermal one in "
            f"{fill['isothermal'].time:.1f} s: the paper's tank is {peak.time / isentrope.time:.2f} to "
            f"{fill['isothermal'].time / isentrope.time:.2f} times too fast.",
            _if(peak.time > isentrope.time),
        ),
    )


def _conclusions(found: Findings) -> tuple[Statement, ...]:
    fill = found.fillings
    isentrope, adiabatic, wall = fill["isentrope"].time, fill["adiabatic"].time, fill["wall of the peak"].time
    polytropic = fill["polytropic"].time
    return (
        Statement(
            "The main reason is heat that passes into the steel tank, which also drops the pressure.",
            "section 5",
            f"Of the {wall - isentrope:.1f} s between the isentrope and the tank with wall heat, heat makes "
            f"{wall - adiabatic:.1f} s; the other {adiabatic - isentrope:.1f} s come from the isentrope in "
            "place of a balance of energy. After closing at 5 bar the pressure falls by "
            f"{1e-5 * found.pressure_drop:.2f} bar as the gas cools.",
            _if(wall - adiabatic > adiabatic - isentrope and found.pressure_drop > 0.0),
        ),
        Statement(
            "A more precise model of the tank would be polytropic.",
            "section 5",
            f"With n = {found.exponent:.3f} the time to 5 bar is {polytropic:.1f} s, against {wall:.1f} s "
            f"with wall heat and {isentrope:.1f} s for the isentrope. It cannot show the fall of pressure "
            "after closing; a balance of energy with a wall can.",
            _if(abs(polytropic - wall) < 0.1 * abs(isentrope - wall)),
        ),
        Statement(
            "C(x) and b(x) make the model much more precise when the valve operates with different pilot pressures.",
            "section 5",
            f"At 0.1 mm an isothermal tank takes {found.slow_time:.1f} s to 5 bar; with C and b of 0.5 mm "
            f"kept, the model would say {found.slow_time_constant:.1f} s.",
            _if(found.slow_time > 1.1 * found.slow_time_constant),
        ),
        _staircase(found),
        Statement(
            "The model works well in slow processes.",
            "section 5",
            "The points of fig. 6 are not in the text, nor are supply pressure and required values: only "
            "its axes and the statements around it can be compared.",
            Verdict.OPEN,
        ),
    )


def _staircase(found: Findings) -> Statement:
    run = found.staircase
    required = run["required.pressure"]
    ends = np.append(np.flatnonzero(np.diff(required)), required.size - 1)
    rows = np.array([run[f"{tank}.pressure"] for tank in TANKS])
    low, high = 1e-5 * float(rows.min()), 1e-5 * float(rows.max())
    miss = float(np.max(np.abs(rows[:, ends] / required[ends] - 1.0)))
    return Statement(
        "Pressure follows steps between 1 and 5.5 bar within 120 s.",
        "fig. 6, axes",
        f"With four steps to 5 bar (chosen) and the regulator mode, every tank stays within {low:.2f} ... "
        f"{high:.2f} bar and is within {100 * miss:.2f} % of the required value when the next step comes.",
        _if(miss < 1e-2 and low > 0.999 and high < 5.5),
    )
