"""Static force of pneumatic muscles: laws of Chou and Hannaford, Tondu and Lopez, Sarosi, and a measured table.

Each law is linear in the pressure, F = p f1(eps) + f0(eps), with the gauge pressure p and the contraction
eps = (L0 - L)/L0. What the pressure adds is work of the gas, p dV = p f1 L0 d(eps), so that the integral of f1 gives
the volume that belongs to a law, and the same line solved for p gives the pressure of a wanted force.
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
    """Force of a muscle, linear in the pressure; floats, arrays and symbols alike."""

    @abstractmethod
    def slope(self, contraction: Any) -> Any:
        """Return the force per gauge pressure f1.

        Parameters
        ----------
        contraction : float, array or symbol
            (L0 - L)/L0 [1].

        Returns
        -------
        float, array or symbol
            [N/Pa]; as an area, -dV/dL.
        """

    def passive(self, contraction: Any) -> Any:
        """Return the force f0 of the hose without gauge pressure.

        Parameters
        ----------
        contraction : float, array or symbol
            (L0 - L)/L0 [1].

        Returns
        -------
        float, array or symbol
            [N], negative where the hose resists the contraction.
        """
        return 0.0 * contraction

    @abstractmethod
    def swept(self, contraction: Any) -> Any:
        """Return the integral of `slope` from zero contraction.

        Parameters
        ----------
        contraction : float, array or symbol
            (L0 - L)/L0 [1].

        Returns
        -------
        float, array or symbol
            Growth of the volume over the nominal length [m^2].
        """

    def force(self, pressure: Any, contraction: Any) -> Any:
        """Return the pulling force of the muscle.

        Parameters
        ----------
        pressure : float, array or symbol
            Gauge pressure [Pa].
        contraction : float, array or symbol
            (L0 - L)/L0 [1].

        Returns
        -------
        float, array or symbol
            [N]; negative where a muscle is slack, which can only pull.
        """
        return pressure * self.slope(contraction) + self.passive(contraction)

    def pressure_for(self, force: Any, contraction: Any) -> Any:
        """Return the gauge pressure for a given pulling force.

        Parameters
        ----------
        force : float, array or symbol
            Wanted pull [N].
        contraction : float, array or symbol
            (L0 - L)/L0, less than where `slope` vanishes [1].

        Returns
        -------
        float, array or symbol
            [Pa].

        Examples
        --------
        >>> law = Sarosi(1.2789e-4, 419.4831, -56.66, -8.7013e-3, 2.67672e-3, -309.6031)
        >>> round(law.pressure_for(law.force(4e5, 0.1), 0.1), 3)
        400000.0
        """
        return (force - self.passive(contraction)) / self.slope(contraction)


@dataclass(frozen=True)
class ChouHannaford(ForceLaw):
    r"""Braid of inextensible threads around a hose without stiffness.

    .. math:: F = p\,\frac{3 L^2 - b^2}{4 \pi n^2} = -p \frac{dV}{dL}, \qquad V = L\,\frac{b^2 - L^2}{4 \pi n^2}

    with :math:`L = L_0 (1 - \varepsilon) = b \cos\theta`.

    Parameters
    ----------
    nominal_diameter, nominal_length : float or symbol
        Diameter D and length L0 of the braid without contraction [m].
    braid_angle : float or symbol
        Angle between thread and axis without contraction [rad].

    Notes
    -----
    No force at a braid angle of 54.74 degrees. The muscle is taken to be a cylinder up to its ends, and what the hose
    and the threads' friction take is left out: measured muscles pull less.

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
        """Return the square of the thread's length b, and 4 pi n^2."""
        thread = self.nominal_length / cos(self.braid_angle)
        turns = thread * sin(self.braid_angle) / (math.pi * self.nominal_diameter)
        return thread**2, 4.0 * math.pi * turns**2

    def slope(self, contraction: Any) -> Any:
        thread_2, round_2 = self._braid()
        return (3.0 * (self.nominal_length * (1.0 - contraction)) ** 2 - thread_2) / round_2

    def swept(self, contraction: Any) -> Any:
        thread_2, round_2 = self._braid()
        # (V - V0)/L0 with V = L (b^2 - L^2)/(4 pi n^2), written out so that no difference of volumes is taken.
        e, length_2 = contraction, self.nominal_length**2
        return e * (length_2 * (3.0 - 3.0 * e + e * e) - thread_2) / round_2


@dataclass(frozen=True)
class TonduLopez(ForceLaw):
    r"""The braid's law with a factor for the ends that are no cylinder.

    .. math:: F = \pi r_0^2\, p\, [a (1 - k \varepsilon)^2 - b], \qquad
              a = \frac{3}{\tan^2\theta_0},\quad b = \frac{1}{\sin^2\theta_0}

    Parameters
    ----------
    nominal_diameter : float or symbol
        Twice r0 [m].
    braid_angle : float or symbol
        Angle theta_0 between thread and axis without contraction [rad].
    end_factor : float or symbol
        k, above 1 where the ends taper [1].

    Notes
    -----
    No force without pressure and one shape for all of them: it misses the steep first per cent of a muscle whose
    threads lie in rubber. With k = 1 it is the law of Chou and Hannaford.

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
        """Return the area pi r0^2, a and b."""
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
    r"""Six numbers that follow the measured force of muscles whose threads lie in rubber.

    .. math:: F = (a_1 p + a_2)\, e^{a_3 \varepsilon} + a_4\, p\, \varepsilon + a_5\, p + a_6

    Parameters
    ----------
    a1, a2, a3, a4, a5, a6 : float or symbol
        a1, a4 and a5 in [N/Pa], a2 and a6 in [N], a3, below zero, in [1].

    Notes
    -----
    Printed for pressures in bar and contractions in per cent: a1 and a5 are then in N/bar, a3 in 1/%, a4 in N/(bar %).
    Fitted, not derived: it holds between the contractions and pressures at which it was fitted, and muscles of one type
    differ by 6 to 14 % of their largest force.

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
    """Measured lines of force over pressure at several contractions, straight between them.

    Parameters
    ----------
    contraction : sequence
        Rising [1].
    slopes : sequence
        Force per gauge pressure there [N/Pa].
    passives : sequence
        Force without gauge pressure there [N].

    Notes
    -----
    Beyond its ends both stay what they are there.

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
        # The part of each gap that lies below, 0..1: a sum, so that it traces without a branch.
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
    r"""Return the pulling part of a force, with a smooth transition to zero.

    .. math:: F_+ = \frac{(F + w)^2}{4 w} \quad\text{between}\; -w \;\text{and}\; w

    Parameters
    ----------
    force : float, array or symbol
        Pull F by a law; negative where the muscle would have to push [N].
    width : float, array or symbol
        Half the zone w in which it goes slack [N].

    Returns
    -------
    float, array or symbol
        F above w, zero below -w, with a steady slope between; never more than w/4 above max(F, 0) [N].

    Examples
    --------
    >>> taut(50.0, 1.0), taut(0.0, 1.0), taut(-20.0, 1.0)
    (50.0, 0.25, 0.0)
    """
    reach = clip(force + width, 0.0, 2.0 * width)
    return where(force > width, force, reach * reach / (4.0 * width))


def slip_rate(deflection: Any, velocity: Any, reach: Any) -> Any:
    r"""Return the rate of the relative deflection of one elastic element in a Maxwell slip model.

    .. math:: \dot\zeta = \frac{v}{\delta} \left(1 - \zeta^{16}\right) \;\text{while bending further},\qquad
              \dot\zeta = \frac{v}{\delta} \;\text{on the way back}

    Parameters
    ----------
    deflection : float, array or symbol
        Deflection zeta over its largest, -1..1 [1].
    velocity : float, array or symbol
        Speed v of sliding [m/s].
    reach : float, array or symbol
        Way delta by which it bends before it slips [m].

    Returns
    -------
    float, array or symbol
        [1/s].

    Notes
    -----
    The power rounds the corner at which an ideal element begins to slip; elements of different reach, side by side,
    remember the turning points of the motion.

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
