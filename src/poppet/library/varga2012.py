"""Main stage of a VPPM-6L proportional pressure valve, after Varga & Keski-Honkola 2012.

Z. Varga, P. Keski-Honkola: Mathematical model of pneumatic proportional valve. Journal of applied science in
the thermodynamics and fluid mechanics, vol. 1, no. 1/2012, ISSN 1802-9388.

The paper prints the polynomials of sonic conductance and critical pressure ratio for filling (Table 1). All mechanical
parameters and the conductance and ratio of the exhaust are assumed here. There are two sets of them: one for the
equations of the paper and one for a pressure regulator.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from poppet.core.provenance import Number, Source, assumed, printed
from poppet.laws.curves import Characteristic, PolynomialCurve, TableCurve

NAME = "varga2012"
REFERENCE = "Varga & Keski-Honkola 2012, J. Appl. Sci. Thermodyn. Fluid Mech. 1(1), ISSN 1802-9388"
TABLE = Source("paper", "Table 1", "eqs (3), (4); x in mm, 0..1; filling (port 1 to 2) only")
DOMAIN = (0.0, 1e-3)

# --- Table 1: x in mm, highest power first ---

B, C = "1", "m^3/(s Pa)"
EQ_B, EQ_C = "Varga & Keski-Honkola 2012, Table 1, eq. (3)", "Varga & Keski-Honkola 2012, Table 1, eq. (4)"
DOUBTFUL = (
    "printed as -2.2269e-6. With -2.2229e-6, one digit changed, C would peak at 1.88e-8 and be nearly "
    "monotone, as the axis of fig. 3 (to 2.0e-8) suggests; a suspicion, never used"
)

CRITICAL_RATIO = tuple(printed(value, B, EQ_B) for value in (3.16180, -8.31770, 7.68470, -2.73840, 0.71748))
SONIC_CONDUCTANCE = (
    printed(-1.1858e-6, C, EQ_C),
    printed(4.5064e-6, C, EQ_C),
    printed(-6.9209e-6, C, EQ_C),
    printed(5.4385e-6, C, EQ_C),
    printed(-2.2269e-6, C, EQ_C, DOUBTFUL),
    printed(3.7653e-7, C, EQ_C),
    printed(2.1902e-8, C, EQ_C),
    printed(5.0034e-9, C, EQ_C, "C(0): the polynomial has no closed state"),
)

# --- Variants of the flow characteristic ---

CLOSING = assumed(2e-5, "m", "stroke over which the seat closes; the printed polynomial does not close")
TABLE_STROKES = tuple(1e-4 * i for i in range(11))


def _polynomials(name: str, *, closing: Number | None = None, monotone: bool = False) -> Characteristic:
    return Characteristic(
        PolynomialCurve(SONIC_CONDUCTANCE),
        PolynomialCurve(CRITICAL_RATIO, letter="p"),
        domain=DOMAIN,
        closing=closing,
        monotone=monotone,
        name=name,
        source=TABLE,
    )


def printed_characteristic(name: str = f"{NAME}.printed") -> Characteristic:
    """Return the flow characteristic with the polynomials as printed in the paper.

    At strokes outside 0 to 1 mm, C and b have the values at the ends of this range.
    """
    return _polynomials(name)


def closed_characteristic(name: str = f"{NAME}.closed") -> Characteristic:
    """Return the printed flow characteristic with a sonic conductance C that is zero at zero stroke.

    The published polynomial is not zero at zero stroke. Here C is zero for strokes up to 0, rises smoothly between 0
    and 0.02 mm, and equals the polynomial above.
    """
    return _polynomials(name, closing=CLOSING)


def monotone_characteristic(name: str = f"{NAME}.monotone") -> Characteristic:
    """Return the closed flow characteristic with a sonic conductance that never decreases with the stroke.

    Its running maximum replaces the printed polynomial. C is zero for strokes up to 0.
    """
    return _polynomials(name, closing=CLOSING, monotone=True)


def table_characteristic(name: str = f"{NAME}.table") -> Characteristic:
    """Return the flow characteristic as a table of values of the printed polynomials.

    The table has eleven points from 0 to 1 mm and is interpolated by monotone piecewise cubics.
    """
    polynomials = printed_characteristic()
    return Characteristic(
        _tabled(polynomials.sonic_conductance, C, EQ_C),
        _tabled(polynomials.critical_ratio, B, EQ_B),
        domain=(TABLE_STROKES[0], TABLE_STROKES[-1]),
        name=name,
        source=TABLE,
    )


def _tabled(curve: Callable[[float], float], unit: str, equation: str) -> TableCurve:
    note = "calculated from the polynomial at x = {:.1f} mm"
    points = (printed(float(curve(x)), unit, equation, note.format(1e3 * x)) for x in TABLE_STROKES)
    return TableCurve(TABLE_STROKES, tuple(points))


CHARACTERISTICS: Mapping[str, Callable[[str], Characteristic]] = {
    NAME: printed_characteristic,
    f"{NAME}.printed": printed_characteristic,
    f"{NAME}.closed": closed_characteristic,
    f"{NAME}.monotone": monotone_characteristic,
    f"{NAME}.table": table_characteristic,
}

# --- Mechanics: the paper prints no values of these parameters ---

STOP_STIFFNESS = assumed(7.07e9, "N/m^1.5", "20 N press the plate 2 um into the stop")
STOP_DISSIPATION = assumed(300.0, "s/m", "20 g at 0.1 m/s rebound with 0.15 of their speed; 20 N rest overdamped")

ENDS_AND_SEATS: Mapping[str, Number] = {
    "overlap": assumed(5e-6, "m", "both seats closed between 0 and -5 um"),
    "exhaust_seat.sonic_conductance": assumed(0.93e-8, C, "constant, measured, not printed (section 3)"),
    "exhaust_seat.critical_ratio": assumed(0.35, B, "constant, measured, not printed (section 3)"),
    "exhaust_seat.opening": assumed(1e-5, "m", "the exhaust opens over -5..-15 um"),
    "upper_stop.position": assumed(1e-3, "m", "end of the range of figs 3 and 4"),
    "upper_stop.stiffness": STOP_STIFFNESS,
    "upper_stop.dissipation": STOP_DISSIPATION,
    "lower_stop.stiffness": STOP_STIFFNESS,
    "lower_stop.dissipation": STOP_DISSIPATION,
    "contact.width": assumed(2e-6, "m", "the seat takes the lower spring's force over -2..0 um"),
    "contact.dissipation": assumed(300.0, "s/m", "as at the stops"),
}

PAPER: Mapping[str, Number] = {
    "plate_area": assumed(4.909e-4, "m^2", "a disc of 25 mm"),
    "moving_mass": assumed(0.020, "kg", "m_p of eq. (5): plate, stem and poppet"),
    "emptying_mass": assumed(0.012, "kg", "m_o of eq. (7): plate and stem, the poppet sits on its seat"),
    "damping": assumed(106.0, "N s/m", "natural frequency 600 Hz, damping ratio 0.7"),
    "upper_spring.rate": assumed(2.55e5, "N/m", "k1, with the linearised membrane; 6 bar g give 1 mm"),
    "upper_spring.preload": assumed(2.0e-5, "m", "h1; the plate rests at -20 um at zero pilot pressure"),
    "lower_spring.rate": assumed(3.0e4, "N/m", "k2"),
    "lower_spring.preload": assumed(1.57e-4, "m", "h2; k1 h1 + k2 h2 = 9.8 N, so 0.2 bar g lift the poppet"),
    "seat_area": assumed(3.3e-5, "m^2", "seat of 6.5 mm; without effect while seat_balance is 0"),
    "seat_balance": assumed(0.0, "1", "phi; eqs (5)-(8) have no force of p1 - p2 on the poppet"),
    "lower_stop.position": assumed(-5e-5, "m", "below the rest at -20 um, which the upper spring sets"),
    **ENDS_AND_SEATS,
}

REGULATOR: Mapping[str, Number] = {
    "plate_area": assumed(7.07e-4, "m^2", "a membrane of 30 mm, the same for pilot and output"),
    "moving_mass": assumed(0.020, "kg", "plate, stem and poppet"),
    "emptying_mass": assumed(0.020, "kg", "taken equal to the moving mass"),
    "damping": assumed(12.0, "N s/m", "damping ratio 0.5 with 7e3 N/m and 20 g"),
    "upper_spring.rate": assumed(2e3, "N/m", "soft, so that the output follows the pilot pressure"),
    "upper_spring.preload": assumed(1e-3, "m", "h1: 2 N of the 14 N at rest"),
    "lower_spring.rate": assumed(5e3, "N/m", "soft, so that the output follows the pilot pressure"),
    "lower_spring.preload": assumed(2.4e-3, "m", "h2: 12 N of the 14 N at rest; they make the dead zone"),
    "seat_area": assumed(3.3e-5, "m^2", "seat of 6.5 mm"),
    "seat_balance": assumed(
        0.0, "1", "phi 0..1: 0 is a fully balanced poppet, 1 one on which p1 - p2 acts on all of the seat"
    ),
    "lower_stop.position": assumed(-5e-4, "m", "gives the exhaust half of the supply's stroke"),
    **ENDS_AND_SEATS,
}

MAIN_STAGES: Mapping[str, Mapping[str, Number]] = {"paper": PAPER, "regulator": REGULATOR}
