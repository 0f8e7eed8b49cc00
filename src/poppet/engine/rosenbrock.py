"""Coefficients of the Rosenbrock method.

RODAS (Hairer & Wanner, Solving Ordinary Differential Equations II, 2nd ed. 1996, section VI.4): six stages, order 4(3),
stiffly accurate, L-stable, with an interpolant of order 3.
"""

from __future__ import annotations

GAMMA = 0.25
STAGE_TIME = (0.0, 0.386, 0.21, 0.63, 1.0, 1.0)
STAGE_DRIFT = (0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0)
ARGUMENT = (
    (),
    (1.544,),
    (0.9466785280815826, 0.2557011698983284),
    (3.314825187068521, 2.896124015972201, 0.9986419139977817),
    (1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950),
    (1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1.0),
)
"""Weights of the previous stages in the argument of each stage."""
COUPLING = (
    (),
    (-5.6688,),
    (-2.430093356833875, -0.2063599157091915),
    (-0.1073529058151375, -9.594562251023355, -20.47028614809616),
    (7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160),
    (8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054),
)
"""Weights of the previous stages in the right-hand side of each stage, divided by the step."""
DENSE = (
    (10.12623508344586, -7.487995877610167, -34.80091861555747, -7.992771707568823, 1.025137723295662),
    (-0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386, -6.594389125716872),
)
"""Weights of the stages in the two coefficients of the interpolant."""
INPUT_TIMES = (0.386, 0.21, 0.63, 1.0)
"""Fractions of the step with evaluations of the inputs; stages 5 and 6 share the last."""
GROWTH, SHRINK, SAFETY = 6.0, 0.15, 0.9
"""Maximum and minimum factor between two steps, and safety factor on the step that the errors permit."""
SCRATCH = 2
"""Doubles of scratch memory before the vectors: 1/(h gamma) and the time of the stage."""


def scratch_size(n_states: int, factor_size: int) -> int:
    """Return the number of doubles that a printed solver step needs as working memory."""
    return SCRATCH + 2 * n_states + factor_size
