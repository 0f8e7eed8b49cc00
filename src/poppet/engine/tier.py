"""Replacement of machine code without optimisation, as soon as its runs have taken as long as the optimisation would.

The code of a large model takes LLVM seconds, but most models run only for a fraction of a second. Such a model first
runs with code that is not optimised. If its runs take long, more computing time probably follows, and the code is
optimised. The total time is then at most about twice that of the better choice, which is unknown at the start.

The optimisation takes place in the thread that waits for the run, never in a thread that remains after it.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from threading import Lock
from time import perf_counter

from poppet.engine.compiled import CompiledFunctions


class Tier:
    """Code of a model without optimisation, and the computing time of its runs.

    Parameters
    ----------
    code : CompiledFunctions
        Code without optimisation.
    compile_it : callable
        Function that compiles the same functions with optimisation; their results must be equal.
    expected : float
        Expected time of this compilation [s].
    """

    def __init__(self, code: CompiledFunctions, compile_it: Callable[[], CompiledFunctions], expected: float) -> None:
        self.expected, self.seconds, self.is_optimised = expected, 0.0, False
        self._code, self._compile, self._lock = code, compile_it, Lock()
        self._optimised: CompiledFunctions | None = None

    def timed(self, run: Callable[[], int]) -> int:
        """Perform a run with a status, and add its computing time; before it, optimise the code if that is due."""
        self.review()
        begin = perf_counter()
        status = run()
        self.seconds += perf_counter() - begin
        return status

    def review(self, seconds: float = 0.0) -> None:
        """Optimise the code if its runs and the present one, after some time [s], have taken as long as expected."""
        if self.seconds + seconds > self.expected:
            self.optimise()

    def optimise(self) -> None:
        """Optimise the code, and replace the functions that the integrator calls, also in a run that is under way."""
        with self._lock:
            if self.is_optimised:
                return
            self._optimised = self._compile()  # owns the code
            for name, address in self._code.switches.items():
                ctypes.c_void_p.from_address(address).value = self._optimised.addresses[name]
            self.is_optimised = True
