"""Model whose runs start from a given state instead of the initial state of the parts."""

from __future__ import annotations

from dataclasses import replace

from poppet.engine.kernel import KERNELS, Kernel, compile_kernel
from poppet.engine.lru_cache import LruCache
from poppet.engine.model import Model

START = "start."
"""Beginning of the addresses of the parameters from which the derived model takes states and discrete states."""
INPUT = "input."
"""Beginning of the addresses of parameters that no equation reads.

`poppet.engine.members.Batch` can hold each input at the value of its parameter, a different one in each run."""
MODELS: LruCache[Model] = LruCache(100)
"""Derived models by model."""


def model_from_state(model: Model) -> Model:
    """Return a model with the same equations, whose initial state consists of parameters.

    The derived model has no quadratures, and therefore no balances. Its further parameters ``start.<state>``,
    ``start.<discrete state>`` and ``input.<input>`` follow those of the model, so the indices of the latter are
    unchanged. A start time of a timer is absolute. Calls with the same model return the same object.
    """
    return MODELS.get(model, lambda: _derive(model))


def kernel_from_state(model: Model) -> Kernel:
    """Return the compiled form of `model_from_state`, which all circuits of the same structure share."""
    derived = model_from_state(model)
    return KERNELS.get(derived, lambda: compile_kernel(derived))


def _derive(model: Model) -> Model:
    import casadi as ca

    n, n_parameters = len(model.states), len(model.parameters)
    started = [*(state.name for state in model.states), *(name for name, _ in model.memory)]
    start, p = ca.SX.sym("start", len(started)), model.symbols["p"]
    constant = ca.SX.sym("constant", len(model.inputs))
    # No expression depends on the quadratures.
    symbols = {
        **model.symbols,
        "x": model.symbols["x"][:n],
        "p": ca.vertcat(p[:n_parameters], start, constant, p[n_parameters:]),
    }
    expressions = {
        **model.expressions,
        "rates": model.expressions["rates"][:n],
        "start": start[:n],
        "memory_start": start[n:],
        "energy": ca.SX(0, 1),
    }
    further = [*(f"{START}{name}" for name in started), *(f"{INPUT}{item.name}" for item in model.inputs)]
    return replace(
        model,
        n_quadratures=0,
        parameters=(*model.parameters, *further),
        flows=(),
        stores=(),
        bodies=(),
        symbols=symbols,
        expressions=expressions,
    )
