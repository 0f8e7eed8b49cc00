"""Static force of pneumatic muscles: laws of Chou and Hannaford, Tondu and Lopez, Sarosi, and a measured table.

Each law is linear in the pressure, F = p f1(eps) + f0(eps), with the gauge pressure p and the contraction
eps = (L0 - L)/L0. The pressure term does the work of the gas, p dV = p f1 L0 d(eps). The volume of the muscle therefore
results from the integral of f1. The law solved for p gives the pressure for a required force.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from poppet.core.symbolic import clip, cos, exp, maximum, sin, where


class ForceLaw(ABC):
    """Base class of static force laws of a muscle.

    The force is f1 p + f0 with the gauge pressure p; f1 (`slope`) and f0 (`passive`) depend on the contraction. The
    methods accept floats, arrays and symbols.
    """

    @abstractmethod
    def slope(self, contraction: Any) -> Any:
        """Return f1, the force per gauge pressure at a contraction.

        Parameters
        ----------
        contraction : float, array or symbol
            Contraction (L0 - L)/L0 with the length L and the nominal length L0 [1].

        Returns
        -------
        float, array or symbol
            Force per gauge pressure [N/Pa]. It equals the area -dV/dL of an ideal muscle with the volume V and the
            length L.
        """

    def passive(self, contraction: Any) -> Any:
        """Return f0, the force of the hose at zero gauge pressure.

        Parameters
        ----------
        contraction : float, array or symbol
            Contraction (L0 - L)/L0 with the length L and the nominal length L0 [1].

        Returns
        -------
        float, array or symbol
            Force [N], negative if the hose resists the contraction.
        """
        return 0.0 * contraction

    @abstractmethod
    def swept(self, contraction: Any) -> Any:
        """Return the integral of `slope` from zero to the given contraction.

        The increase in volume is this integral, multiplied by the nominal length.

        Parameters
        ----------
        contraction : float, array or symbol
            Contraction (L0 - L)/L0 with the length L and the nominal length L0 [1].

        Returns
        -------
        float, array or symbol
            Increase in volume, divided by the nominal length [m^2].
        """

    def force(self, pressure: Any, contraction: Any) -> Any:
        """Return the pulling force of the muscle for a gauge pressure and a contraction.

        Parameters
        ----------
        pressure : float, array or symbol
            Gauge pressure [Pa].
        contraction : float, array or symbol
            Contraction (L0 - L)/L0 with the length L and the nominal length L0 [1].

        Returns
        -------
        float, array or symbol
            Force [N]. If it is negative, the muscle is slack, because it cannot push.
        """
        return pressure * self.slope(contraction) + self.passive(contraction)

    def pressure_for(self, force: Any, contraction: Any) -> Any:
        """Return the gauge pressure at which the muscle exerts a given pulling force.

        Parameters
        ----------
        force : float, array or symbol
            Required pulling force [N].
        contraction : float, array or symbol
            Contraction (L0 - L)/L0, below the contraction at which `slope` is zero [1].

        Returns
        -------
        float, array or symbol
            Gauge pressure [Pa].

        Examples
        --------
        >>> law = Sarosi(1.2789e-4, 419.4831, -56.66, -8.7013e-3, 2.67672e-3, -309.6031)
        >>> round(law.pressure_for(law.force(4e5, 0.1), 0.1), 3)
        400000.0
        """
        return (force - self.passive(contraction)) / self.slope(contraction)


@dataclass(frozen=True)
class ChouHannaford(ForceLaw):
    r"""Force law of a braid of inextensible threads around a hose without stiffness.

    .. math:: F = p\,\frac{3 L^2 - b^2}{4 \pi n^2} = -p \frac{dV}{dL}, \qquad V = L\,\frac{b^2 - L^2}{4 \pi n^2}

    Here p is the gauge pressure, :math:`L = L_0 (1 - \varepsilon) = b \cos\theta` the length at the contraction
    :math:`\varepsilon`, b the length of a thread and n the number of its turns.

    Parameters
    ----------
    nominal_diameter, nominal_length : float or symbol
        Diameter D and length L0 of the braid without contraction [m].
    braid_angle : float or symbol
        Angle between thread and axis without contraction [rad].

    Notes
    -----
    The force is zero if the angle between thread and axis reaches 54.74 degrees. The law assumes a cylinder up to both
    ends and neglects the stiffness of the hose and the friction of the threads, so measured forces are smaller.

    References
    ----------
    Chou & Hannaford 1996, Measurement and modeling of McKibben pneumatic artificial muscles, IEEE Trans. Robotics and
    Automation 12, 90-102, equations (3), (4).

    Examples
    --------
    >>> law = ChouHannaford(0.02, 0.3, math.radians(25.0))
    >>> at = 1.0 - math.cos(math.acos(1.0 / math.sqrt(3.0))) / math.cos(math.radians(25.0))
    >>> abs(law.force(6e5, at)) < 1e-9
    True
    """

    nominal_diameter: Any
    nominal_length: Any
    braid_angle: Any

    def _braid(self) -> tuple[Any, Any]:
        """Return b^2 and 4 pi n^2 for the length b of a thread and the number n of its turns."""
        thread = self.nominal_length / cos(self.braid_angle)
        turns = thread * sin(self.braid_angle) / (math.pi * self.nominal_diameter)
        return thread**2, 4.0 * math.pi * turns**2

    def slope(self, contraction: Any) -> Any:
        thread_2, round_2 = self._braid()
        return (3.0 * (self.nominal_length * (1.0 - contraction)) ** 2 - thread_2) / round_2

    def swept(self, contraction: Any) -> Any:
        thread_2, round_2 = self._braid()
        # (V - V0)/L0 with V = L (b^2 - L^2)/(4 pi n^2), expanded because a difference of volumes loses digits.
        e, length_2 = contraction, self.nominal_length**2
        return e * (length_2 * (3.0 - 3.0 * e + e * e) - thread_2) / round_2


@dataclass(frozen=True)
class TonduLopez(ForceLaw):
    r"""Force law of a braid with a correction factor for tapered ends.

    .. math:: F = \pi r_0^2\, p\, [a (1 - k \varepsilon)^2 - b], \qquad
              a = \frac{3}{\tan^2\theta_0},\quad b = \frac{1}{\sin^2\theta_0}

    Parameters
    ----------
    nominal_diameter : float or symbol
        Nominal diameter without contraction, 2 r0 [m].
    braid_angle : float or symbol
        Angle theta_0 between thread and axis without contraction [rad].
    end_factor : float or symbol
        Factor k, above 1 for tapered ends [1].

    Notes
    -----
    The force is proportional to the gauge pressure p; :math:`\varepsilon` is the contraction. If the threads of a
    muscle are embedded in rubber, its force decreases steeply in the first per cent of contraction. The law does not
    describe this decrease. With k = 1 it is the law of Chou and Hannaford.

    References
    ----------
    Tondu & Lopez 2000, Modeling and control of McKibben artificial muscle robot actuators, IEEE Control Systems
    Magazine 20(2), 15-38, equations (5), (8).

    Examples
    --------
    >>> plain, braid = TonduLopez(0.02, 0.4, 1.0), ChouHannaford(0.02, 0.3, 0.4)
    >>> abs(plain.force(6e5, 0.1) / braid.force(6e5, 0.1) - 1.0) < 1e-12
    True
    """

    nominal_diameter: Any
    braid_angle: Any
    end_factor: Any

    def _numbers(self) -> tuple[Any, Any, Any]:
        """Return the area pi r0^2 [m^2] and the coefficients a and b [1] of the force law."""
        b = 1.0 / sin(self.braid_angle) ** 2
        return 0.25 * math.pi * self.nominal_diameter**2, 3.0 * (b - 1.0), b

    def slope(self, contraction: Any) -> Any:
        area, a, b = self._numbers()
        return area * (a * (1.0 - self.end_factor * contraction) ** 2 - b)

    def swept(self, contraction: Any) -> Any:
        area, a, b = self._numbers()
        e = self.end_factor * contraction
        return area * contraction * (a * (1.0 - e + e * e / 3.0) - b)


@dataclass(frozen=True)
class Sarosi(ForceLaw):
    r"""Empirical force law with six parameters for muscles whose threads are embedded in rubber.

    .. math:: F = (a_1 p + a_2)\, e^{a_3 \varepsilon} + a_4\, p\, \varepsilon + a_5\, p + a_6

    Parameters
    ----------
    a1, a2, a3, a4, a5, a6 : float or symbol
        a1, a4 and a5 in [N/Pa], a2 and a6 in [N]; a3 is dimensionless and negative.

    Notes
    -----
    The source prints the parameters for pressures in bar and contractions in per cent: a1 and a5 in N/bar, a3 in 1/%,
    a4 in N/(bar %). The law is empirical: it is valid in the range of contractions and pressures of the fit. Muscles
    of one type differ by 6 to 14 % of their largest force.

    References
    ----------
    Sarosi 2012, New approximation algorithm for the force of Fluidic Muscles, IEEE SACI, 229-233; Sarosi et al. 2015.

    Examples
    --------
    >>> law = Sarosi(1.2789e-4, 419.4831, -56.66, -8.7013e-3, 2.67672e-3, -309.6031)
    >>> round(law.force(6e5, 0.06), 1)
    999.7
    """

    a1: Any
    a2: Any
    a3: Any
    a4: Any
    a5: Any
    a6: Any

    def slope(self, contraction: Any) -> Any:
        return self.a1 * exp(self.a3 * contraction) + self.a4 * contraction + self.a5

    def passive(self, contraction: Any) -> Any:
        return self.a2 * exp(self.a3 * contraction) + self.a6

    def swept(self, contraction: Any) -> Any:
        rest = 0.5 * self.a4 * contraction**2 + self.a5 * contraction
        return self.a1 * (exp(self.a3 * contraction) - 1.0) / self.a3 + rest


@dataclass(frozen=True)
class ForceTable(ForceLaw):
    """Force law from a table of measurements, linear between the contractions of the table.

    For each contraction, the table contains the force per gauge pressure and the force at zero gauge pressure.

    Parameters
    ----------
    contraction : sequence of float or symbol, shape (n,)
        Increasing contractions [1].
    slopes : sequence of float or symbol, shape (n,)
        Force per gauge pressure at these contractions [N/Pa].
    passives : sequence of float or symbol, shape (n,)
        Force at zero gauge pressure at these contractions [N].

    Notes
    -----
    Beyond the ends of the table, the values at its ends are used.

    Examples
    --------
    >>> law = ForceTable([0.0, 0.1], [3e-3, 1e-3], [0.0, -100.0])
    >>> law.force(1e5, 0.05), round(law.swept(0.1), 7)
    (150.0, 0.0002)
    """

    contraction: Sequence[Any]
    slopes: Sequence[Any]
    passives: Sequence[Any]

    def _between(self, contraction: Any, heights: Sequence[Any]) -> Any:
        gaps = zip(pairwise(self.contraction), pairwise(heights), strict=True)
        # Fraction of each interval below the contraction, 0..1; a sum of them needs no branch in the trace.
        return heights[0] + sum((h - g) * clip((contraction - x) / (y - x), 0.0, 1.0) for (x, y), (g, h) in gaps)

    def slope(self, contraction: Any) -> Any:
        return self._between(contraction, self.slopes)

    def passive(self, contraction: Any) -> Any:
        return self._between(contraction, self.passives)

    def swept(self, contraction: Any) -> Any:
        return self._integral(contraction) - self._integral(0.0)

    def _integral(self, contraction: Any) -> Any:
        result = self.slopes[0] * contraction
        for (x, y), (g, h) in zip(pairwise(self.contraction), pairwise(self.slopes), strict=True):
            share = clip((contraction - x) / (y - x), 0.0, 1.0)
            result = result + (h - g) * (0.5 * (y - x) * share * share + maximum(contraction - y, 0.0))
        return result


def taut(force: Any, width: Any) -> Any:
    r"""Limit the force of a muscle smoothly to pulling forces, because a slack muscle cannot push.

    .. math:: F_+ = \frac{(F + w)^2}{4 w} \quad\text{between}\; -w \;\text{and}\; w

    Parameters
    ----------
    force : float, array or symbol
        Force F of a force law; a negative value is a pushing force [N].
    width : float, array or symbol
        Half width w of the range of forces in which the result becomes zero [N].

    Returns
    -------
    float, array or symbol
        F above w, zero below -w, and between them the formula above, with a continuous slope [N]. It exceeds max(F, 0)
        by at most w/4.

    Examples
    --------
    >>> taut(50.0, 1.0), taut(0.0, 1.0), taut(-20.0, 1.0)
    (50.0, 0.25, 0.0)
    """
    reach = clip(force + width, 0.0, 2.0 * width)
    return where(force > width, force, reach * reach / (4.0 * width))


def slip_rate(deflection: Any, velocity: Any, reach: Any) -> Any:
    r"""Return the rate of change of the relative deflection of an elastic element in a Maxwell slip model.

    .. math:: \dot\zeta = \frac{v}{\delta} \left(1 - \zeta^{16}\right) \;\text{while } |\zeta| \text{ increases},\qquad
              \dot\zeta = \frac{v}{\delta} \;\text{while it decreases}

    Parameters
    ----------
    deflection : float, array or symbol
        Deflection :math:`\zeta` relative to its maximum, from -1 to 1 [1].
    velocity : float, array or symbol
        Speed v of sliding [m/s].
    reach : float, array or symbol
        Distance :math:`\delta` by which the element deflects before it slips [m].

    Returns
    -------
    float, array or symbol
        Rate of change [1/s].

    Notes
    -----
    An ideal element begins to slip abruptly; the power of 16 smooths this transition. Parallel elements with different
    distances :math:`\delta` represent the hysteresis after each reversal of the motion.

    References
    ----------
    Iwan 1966, A distributed-element model for hysteresis, J. Appl. Mech. 33, 893-900; for muscles Vo-Minh et al. 2011,
    IEEE/ASME Trans. Mechatronics 16, 177-186.

    Examples
    --------
    >>> slip_rate(1.0, 0.1, 0.01), slip_rate(1.0, -0.1, 0.01)
    (0.0, -10.0)
    """
    return velocity / reach * (1.0 - where(velocity * deflection > 0.0, deflection**16, 0.0))
