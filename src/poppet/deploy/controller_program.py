"""Traced program of sampled controllers: equations, reaction to invalid inputs and parameters, and clock.

The equations are those of the parts. The rest of the program is traced here, once for all targets, so that exported
code and its evaluation in Python (`ControllerProgram.run`) agree.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.trace import TracedProgram, trace_program
from poppet.core.errors import InputError
from poppet.deploy.export_model import ExportInput, ExportModel, ExportParameter, ExportQuantity
from poppet.engine.model_evaluation import Array, ArrayFunction
from poppet.parts.compound import expand_compounds
from poppet.parts.electronics import MIN_SAMPLE_TIME
from poppet.parts.part import NEVER, Controller

if TYPE_CHECKING:
    import casadi


SIGNATURES = {
    "accept": "u p z -> z labels",
    "start": "z -> z",
    "advance": "dt z -> z fired labels",
    "update": "z fired -> z labels",
    "outputs": "z -> y status",
}
"""Arguments and results of a program's functions: time since the previous call dt, inputs u, parameters p, state z,
outputs y, status flags; `fired` is 1 for each expired timer, and `labels` are intermediate values with a name.

A call consists of `accept`; `start` if it is the first; `advance`; `update` if a timer has expired; and `outputs`."""
SELECTING_UPDATE = "z fired chosen -> {selections} z labels"
"""Arguments and results of `update` with selections, for a printer.

`chosen` contains the results of all selections. The result of a selection contains its selector, then the results of
each case."""
STATUS = ("input_held", "safe", "saturated", "late", "parameter_held")
"""Status flags, in the order of the bits of a status: bit k is flag k."""
LARGEST_INPUT = 1e15
"""Largest magnitude of a valid input. It also rejects values that are not finite; its square is finite as a float."""
COUNTED = {"faulty_samples": 0.5, "elapsed_samples": -0.5}
"""Names of discrete states that count samples, with the value above which they have begun to count."""
FLAGS = ("is_started", "has_input_fault", "has_parameter_fault", "is_late")
"""Last elements of the state z, which belong to the program itself."""

_LABELS = {
    "accept": {
        "parameters_are_valid": "true if all parameters are finite and within their limits",
        "inputs_are_valid": "true if all inputs are finite",
    },
    "start": {},
    "advance": {"elapsed": "time since the previous call [s]"},
    "outputs": {},
}


class ProgramState(NamedTuple):
    """Element of the state z of a controller program."""

    # `memory` of the controllers, last valid inputs (`in`), last valid parameters (`param`), or `flag` of the program
    group: str
    address: str
    unit: str
    is_flag: bool  # 0 or 1, a Boolean in exported programs
    value: float = 0.0  # before the first call; `start` sets the memory


class ProgramSelection(NamedTuple):
    """Selection of a program, which a printer writes as a CASE or switch statement."""

    names: tuple[str, ...]  # addresses of the results
    flags: tuple[bool, ...]  # True for results that are 0 or 1
    cases: tuple[str, ...]  # titles of the cases 1, 2, ...
    titles: Mapping[int, str]  # comments by the value of a result


class ProgramRun(NamedTuple):
    """Results of the calls of a controller program."""

    outputs: Array  # (n_calls, n_outputs) array, SI
    status: npt.NDArray[np.int_]  # (n_calls,) array of status bits


@dataclass(frozen=True, eq=False)
class ControllerProgram:
    """Program of sampled controllers.

    Parameters
    ----------
    name, title : str
        Identifier of the program; title of the circuit.
    parts : tuple of str
        Names of the controllers in the circuit.
    inputs : tuple of ExportInput
        Inputs of the program, in the order of u.
    flags : frozenset of str
        Addresses of the inputs that are 0 or 1.
    parameters : tuple of ExportParameter
        Parameters that can change at run time, in the order of p; the others are constants.
    states : tuple of ProgramState
        Elements of the state z; the first `n_timers` are the times until the next sample instants [s].
    n_timers : int
        Number of timers.
    outputs : tuple of ExportQuantity
        Outputs, in the order of y.
    labels : dict
        Name of each function to its labelled intermediate values: address and meaning with unit.
    cycle : float
        Shortest sample time; call the program with this period [s].
    sensed : dict
        Address of a measured input to the output of a run with its value, and the offset that the sensor adds.
    functions : dict
        CasADi functions with the `SIGNATURES`.
    output_flags : frozenset of str
        Addresses of the outputs that are 0 or 1.
    selections : tuple of ProgramSelection
        Selections in `update`, in the order of execution.
    selecting_update : casadi.Function, optional
        The function `update` with the arguments `SELECTING_UPDATE`, if there are selections.

    Notes
    -----
    An input that is not finite keeps its last valid value, and all controllers of the program receive an input fault.
    If a parameter is outside its limits, or two parameters contradict each other, all parameters keep their last valid
    values. A call executes each sample whose instant is at most half the call interval ahead, and at most one per
    timer. If two samples or more are pending after a call, they are dropped, and the clock of this timer restarts.
    Dropped samples count for the fault time. The first call executes the first sample of each timer.
    """

    name: str
    title: str
    parts: tuple[str, ...]
    inputs: tuple[ExportInput, ...]
    flags: frozenset[str]
    parameters: tuple[ExportParameter, ...]
    states: tuple[ProgramState, ...]
    n_timers: int
    outputs: tuple[ExportQuantity, ...]
    labels: Mapping[str, Mapping[str, str]]
    cycle: float
    sensed: Mapping[str, tuple[str, float]]
    functions: Mapping[str, casadi.Function]
    output_flags: frozenset[str] = frozenset()
    selections: tuple[ProgramSelection, ...] = ()
    selecting_update: casadi.Function | None = None

    def printed(self, name: str) -> tuple[casadi.Function, str]:
        """Return the function `name` in the form for a printer, and its signature.

        Results of selections are named `selection`.
        """
        if name != "update" or self.selecting_update is None:
            return self.functions[name], SIGNATURES[name]
        return self.selecting_update, SELECTING_UPDATE.format(selections=" ".join("selection" for _ in self.selections))

    def run(
        self,
        inputs: Sequence[Array] | Array,
        parameters: Array | None = None,
        intervals: Sequence[float] | Array | None = None,
    ) -> ProgramRun:
        """Return outputs and status of each call of the program, evaluated by CasADi.

        Parameters
        ----------
        inputs : (n_calls, n_inputs) array
            Inputs of each call, SI.
        parameters : (n_parameters,) or (n_calls, n_parameters) array, optional
            Parameters (default: those of the circuit).
        intervals : (n_calls,) array, optional
            Time between the previous call and each call (default: `cycle` of the program) [s]. The first is ignored.

        Returns
        -------
        ProgramRun
        """
        defaults = np.array([parameter.value for parameter in self.parameters])
        given = defaults if parameters is None else parameters
        all_parameters = np.broadcast_to(given, (len(inputs), defaults.size))
        functions = {name: ArrayFunction(function) for name, function in self.functions.items()}
        z = np.array([state.value for state in self.states])
        rows, status = [], []
        for call, (u, p) in enumerate(zip(inputs, all_parameters, strict=True)):
            dt = self.cycle if intervals is None else intervals[call]
            z = functions["accept"](u, p, z)[0].ravel()
            if not call:
                z = functions["start"](z)[0].ravel()
            z, fired, _ = (result.ravel() for result in functions["advance"](dt, z))
            if fired.any():
                z = functions["update"](z, fired)[0].ravel()
            y, bits = (result.ravel() for result in functions["outputs"](z))
            rows.append(y)
            status.append(sum(1 << k for k, bit in enumerate(bits) if bit))
        return ProgramRun(np.array(rows).reshape(len(rows), len(self.outputs)), np.array(status, dtype=int))


class _Equations(NamedTuple):
    """Expressions of the controllers, for inputs u, parameters p, memory and expired timers.

    Updates and labels contain the symbols of the selections, which `selections` maps to the values of all cases.
    """

    start: Any  # memory at the start
    update: Any  # memory after a sample instant
    outputs: Any
    labels: Any  # labelled intermediate values of `update`
    u: Any  # symbols of the inputs with an effect
    p: Any  # symbols of the parameters with an effect
    memory: Any
    fired: Any
    selections: Sequence[Any] = ()  # of each selection: selector, then the results of each case
    symbols: Sequence[Any] = ()  # of each selection: symbols of its results


class _Interface(NamedTuple):
    """Inputs and parameters of a program with their rules."""

    inputs: tuple[ExportInput, ...]
    flags: frozenset[str]  # addresses of the inputs that are 0 or 1
    limits: Sequence[tuple[float, float]]  # of each input; NaN if there is none
    parameters: tuple[ExportParameter, ...]
    ascending: Sequence[tuple[str, str]]  # pairs of parameters of which the first must be below the second


def trace_controller_program(
    circuit: BaseCircuit,
    controllers: BaseCircuit,
    export_model: ExportModel,
    sensors: Mapping[str, tuple[str, str]],
) -> ControllerProgram:
    """Return the program of sampled controllers.

    Parameters
    ----------
    circuit : Circuit
        Circuit of the controllers.
    controllers : Circuit
        The controllers alone, with their connections.
    export_model : ExportModel
        Export model of `controllers`.
    sensors : dict
        State of each sensor to the measured input and the prefix of the parameters of the sensor.

    Returns
    -------
    ControllerProgram
    """
    import casadi as ca

    traced = trace_program(controllers.parts, tuple(controllers.parameters), controllers.connections)
    model, labels = traced.model, traced.labels
    if continuous := sorted({state.name for state in model.states} - set(sensors)):
        raise InputError("deploy.controller.continuous", continuous[0])
    recorded = {f"{name}.{item.name}" for name, part in controllers.parts.items() for item in part.inputs()}
    outputs = [k for k, (name, _) in enumerate(model.outputs) if name not in recorded and name not in sensors]
    equations, used_u, used_p = _trace_equations(traced, export_model, sensors, outputs)
    inputs = tuple(export_model.inputs[k] for k in used_u)
    parameters = tuple(export_model.parameters[k] for k in used_p)
    elementary, _, shown = expand_compounds(controllers.parts, controllers.connections)
    declared = {
        shown.get(address, address): item
        for name, part in elementary.items()
        for item in part.inputs()
        if (address := f"{name}.{item.name}")
    }
    flags = frozenset(item.address for item in inputs if declared[item.address].is_flag)
    limits = [
        (_number_or_nan(item.low), _number_or_nan(item.high)) for item in (declared[one.address] for one in inputs)
    ]
    part_flags = {
        shown.get(address, address)
        for name, part in elementary.items()
        if isinstance(part, Controller)
        for address in (f"{name}.{local}" for local in part.flags())
    }
    states = (
        *(
            ProgramState("memory", name, unit, name in part_flags or name.rpartition(".")[2].startswith("is_"))
            for name, unit in model.memory
        ),
        *(ProgramState("in", item.address, item.unit, item.address in flags, item.value) for item in inputs),
        *(ProgramState("param", parameter.address, parameter.unit, False, parameter.value) for parameter in parameters),
        *(ProgramState("flag", name, "1", True) for name in FLAGS),
    )
    first_u, first_p = (np.array([item.value for item in items]) for items in (inputs, parameters))
    u, p, symbolic = equations.u, equations.p, equations.memory
    memory = ArrayFunction(ca.Function("start", [u, p], [ca.densify(equations.start)]))(first_u, first_p)[0].ravel()
    is_due = symbolic[: model.n_timers] <= 0.0
    timers = ca.substitute([equations.update[: model.n_timers]], [equations.fired], [is_due])[0]
    second = ArrayFunction(ca.Function("timers", [u, p, symbolic], [ca.densify(timers)]))
    next_instants = second(first_u, first_p, memory)[0].ravel()
    cycle = float(next_instants[next_instants < NEVER].min())
    ascending = [
        (f"{name}.{low}", f"{name}.{high}")
        for name, part in elementary.items()
        if isinstance(part, Controller)
        for low, high in part.ascending_parameters()
    ]
    interface = _Interface(inputs, flags, limits, parameters, ascending)
    functions, selecting_update = _program_functions(equations, interface, states, model.n_timers, cycle)
    selections = tuple(
        ProgramSelection(
            tuple(
                shown.get(address, address) for address in (f"{item.owner}.{name}" for name in item.selection.symbols)
            ),
            tuple(name in item.selection.flags for name in item.selection.symbols),
            tuple(case.title for case in item.selection.cases),
            item.selection.titles,
        )
        for item in traced.selections
    )
    program_outputs = tuple(export_model.outputs[k] for k in outputs)
    values = {parameter.address: parameter.value for parameter in export_model.parameters}
    return ControllerProgram(
        export_model.name, circuit.title, tuple(controllers.parts), inputs, flags, parameters, states, model.n_timers,
        program_outputs,
        _LABELS | {"update": {shown.get(address, address): meaning for address, (_, meaning) in labels.items()}}, cycle,
        {target: (state, values[f"{group}offset"]) for state, (target, group) in sensors.items()}, functions,
        frozenset(output.address for output in program_outputs) & part_flags, selections, selecting_update,
    )  # fmt: skip


def _trace_equations(
    traced: TracedProgram,
    export_model: ExportModel,
    sensors: Mapping[str, tuple[str, str]],
    output_indices: Sequence[int],
) -> tuple[_Equations, list[int], list[int]]:
    """Return the expressions of the controllers, and the indices of inputs and parameters with an effect.

    The measured values replace the states of the sensors.
    """
    import casadi as ca

    model = traced.model
    outputs, indices = ca.densify(model.expressions["outputs"]), {name: k for k, (name, _) in enumerate(model.outputs)}
    p, memory, u = ca.SX.sym("p", len(export_model.parameters)), ca.SX.sym("z", len(model.memory)), model.symbols["u"]
    groups = tuple(group for _, group in sensors.values())
    values = [
        0.0 if parameter.address.startswith(groups) else p[k] if parameter.is_free else parameter.value
        for k, parameter in enumerate(export_model.parameters)
    ]
    label_values = ca.vertcat(*(value for value, _ in traced.labels.values()))
    selections = [ca.vertcat(item.selector, ca.vec(item.values.T)) for item in traced.selections]
    results = [model.expressions["memory_start"], model.expressions["update"], outputs[output_indices], label_values]
    results += selections
    # The states first, because their replacements contain inputs and parameters.
    measured = ca.vertcat(*(outputs[indices[sensors[state.name][0]]] for state in model.states))
    results = ca.substitute([ca.densify(result) for result in results], [model.symbols["x"]], [measured])
    results = ca.substitute(results, [model.symbols["p"]], [ca.vertcat(*values, memory)])
    used_u, used_p = (sorted({*ca.jacobian_sparsity(ca.vertcat(*results), symbol).get_col()}) for symbol in (u, p))
    start, update, output_values, label_values, *selections = results
    symbols = u[used_u], p[used_p], memory, model.symbols["fired"]
    chosen = [ca.vertcat(*item.selection.symbols.values()) for item in traced.selections]
    return _Equations(start, update, output_values, label_values, *symbols, selections, chosen), used_u, used_p


def _number_or_nan(limit: str | float) -> float:
    """Return a limit of an input, or NaN if it is a parameter: the equations then contain it."""
    return limit if isinstance(limit, float) else math.nan


def _program_functions(
    equations: _Equations, interface: _Interface, states: Sequence[ProgramState], n_timers: int, cycle: float
) -> tuple[dict[str, casadi.Function], casadi.Function | None]:
    """Return the functions of a program with the `SIGNATURES`, and `update` with selections, if there are any."""
    import casadi as ca

    inputs, parameters = interface.inputs, interface.parameters
    memory, held_u, held_p = equations.memory, ca.SX.sym("u", len(inputs)), ca.SX.sym("p", len(parameters))
    flag = ca.SX.sym("flag", len(FLAGS))
    z = ca.vertcat(memory, held_u, held_p, flag)
    is_started, has_input_fault, has_parameter_fault, is_late = ca.vertsplit(flag)
    u, p, dt = ca.SX.sym("u", len(inputs)), ca.SX.sym("p", len(parameters)), ca.SX.sym("dt")
    # Each controller of the program receives the fault of any input.
    effective_u = ca.vertcat(
        *(ca.fmax(held_u[k], has_input_fault) if item.address.endswith(".input_fault") else held_u[k]
          for k, item in enumerate(inputs))
    )  # fmt: skip
    old, new = [equations.u, equations.p], [effective_u, held_p]
    start, update, outputs, labels, *selections = ca.substitute([*equations[:4], *equations.selections], old, new)

    accepted_p = _accepts_parameters(p, interface)
    accepted_u, are_valid = _accept_inputs(u, held_u, interface)
    accept = ca.vertcat(
        memory, accepted_u, _choose(accepted_p, p, held_p), is_started, ca.logic_not(are_valid),
        ca.logic_not(accepted_p), is_late,
    )  # fmt: skip

    # A time that is not finite counts as one cycle. A time that runs backwards, and that of the first call, is 0.
    has_time = ca.fabs(dt) <= LARGEST_INPUT
    elapsed = _choose(is_started, _choose(has_time, ca.fmax(dt, 0.0), cycle), 0.0)
    remaining = _limited_timers(equations, n_timers, held_p) - elapsed
    has_fault = ca.logic_or(has_input_fault, ca.logic_not(has_time))
    runs_backwards = ca.logic_and(ca.logic_and(dt < 0.0, has_time), is_started)
    advance = ca.vertcat(
        remaining, memory[n_timers:], held_u, held_p, 1.0, has_fault, has_parameter_fault, runs_backwards
    )
    due = remaining <= 0.5 * elapsed

    fired = equations.fired
    if n_timers == 1:
        # `update` is called only if a timer has expired.
        update, labels, *selections = ca.substitute([update, labels, *selections], [fired], [ca.SX(1.0)])
        fired = ca.SX(1.0)
    new_memory, late = _without_pending_samples(equations, update, fired, states[: memory.shape[0]], is_late, n_timers)
    after = ca.vertcat(*new_memory, held_u, held_p, flag[:3], late)

    flags = (_any_flag(memory, states, name) for name in ("is_safe", "is_saturated"))
    status = ca.vertcat(has_input_fault, *flags, is_late, has_parameter_fault)
    symbols = equations.symbols
    values = [_chosen(selection, symbol.shape[0]) for selection, symbol in zip(selections, symbols, strict=True)]
    complete, complete_labels = [after, labels]
    # In the reverse order, because the values of a selection can contain the symbols of previous ones.
    for symbol, value in zip(reversed(symbols), reversed(values), strict=True):
        complete, complete_labels = ca.substitute([complete, complete_labels], [symbol], [value])
    arguments = {"dt": dt, "u": u, "p": p, "z": z, "fired": equations.fired}
    results = {
        "accept": [accept, ca.vertcat(accepted_p, are_valid)],
        "start": [ca.vertcat(start, held_u, held_p, flag)],
        "advance": [advance, due, elapsed],
        "update": [complete, complete_labels],
        "outputs": [outputs, status],
    }
    functions = {}
    for name, signature in SIGNATURES.items():
        sources = [arguments[argument] for argument in signature.partition(" -> ")[0].split()]
        functions[name] = ca.Function(name, sources, ca.cse([ca.densify(ca.SX(result)) for result in results[name]]))
    if not selections:
        return functions, None
    printed = ca.cse([ca.densify(ca.SX(result)) for result in (*selections, after, labels)])
    return functions, ca.Function("update", [z, equations.fired, ca.vertcat(*symbols)], printed)


def _without_pending_samples(
    equations: _Equations, update: Any, fired: Any, states: Sequence[ProgramState], late: Any, n_timers: int
) -> tuple[list[Any], Any]:
    """Return the memory after an update, in which long delays drop samples, and the flag `late`, set by shorter ones.

    `states` describes the memory.
    """
    import casadi as ca

    memory = equations.memory
    new_memory = [update[k] for k in range(update.shape[0])]
    for k in range(n_timers):
        period = update[k] - memory[k]
        has_fired = fired[k] > 0.0
        # If two samples or more remain pending, they are dropped, and the clock restarts at this call.
        is_dropped = ca.logic_and(has_fired, update[k] <= -period)
        new_memory[k] = _choose(is_dropped, period, update[k])
        late = ca.logic_or(late, ca.logic_and(has_fired, update[k] <= -0.5 * period))
        # Dropped samples count for the fault time and the time in a step, unless it begins or is halted at this
        # instant. The period of a timer that has not expired is 0.
        divisor = ca.fmax(period, MIN_SAMPLE_TIME)
        for j, state in enumerate(states):
            begun = COUNTED.get(state.address.rpartition(".")[2])
            if begun is not None and ca.depends_on(equations.update[j], equations.fired[k]):
                continues = ca.logic_and(memory[j] > begun, update[j] > memory[j])
                n_dropped = _choose(ca.logic_and(is_dropped, continues), 1.0 - update[k] / divisor, 0.0)
                new_memory[j] = new_memory[j] + n_dropped
    return new_memory, late


def _any_flag(memory: Any, states: Sequence[ProgramState], name: str) -> Any:
    """Return 1 if a flag with a name is set in any controller of a program."""
    import casadi as ca

    result = ca.SX(0.0)
    for k, state in enumerate(states):
        if state.group == "memory" and state.address.endswith(f".{name}"):
            result = ca.logic_or(result, memory[k]) if not result.is_zero() else memory[k]
    return result


def _chosen(selection: Any, n_results: int) -> Any:
    """Return the results of a selection as nested choices; `selection` contains the selector and all cases."""
    import casadi as ca

    table = ca.reshape(selection[1:], n_results, -1)
    result = table[:, -1]
    for k in reversed(range(table.shape[1] - 1)):
        result = ca.if_else(selection[0] < k + 1.5, table[:, k], result)
    return result


def _limited_timers(equations: _Equations, n_timers: int, held_p: Any) -> Any:
    """Return the times until the next sample instants, at most the present sample times.

    Without this limit, a sample time that was wrong in one sample would stop the controller for this time. A timer
    that is not periodic, such as a delay, has no limit.
    """
    import casadi as ca

    memory, limited = equations.memory, []
    fired = ca.SX.ones(n_timers)
    for k in range(n_timers):
        # The update adds the sample time to a timer that has expired.
        start = ca.vertcat(*(0.0 if other == k else memory[other] for other in range(memory.shape[0])))
        symbols = [equations.fired, memory, equations.p]
        period = ca.substitute([equations.update[k]], symbols, [fired, start, held_p])[0]
        is_periodic = ca.depends_on(period, held_p) and not ca.depends_on(period, memory)
        limited.append(ca.fmin(memory[k], period) if is_periodic else memory[k])
    return ca.vertcat(*limited)


def _choose(condition: Any, if_true: Any, if_false: Any) -> Any:
    """Return a choice for each element of two vectors."""
    import casadi as ca

    return ca.if_else(condition, ca.SX(if_true), ca.SX(if_false))


def _accepts_parameters(p: Any, interface: _Interface) -> Any:
    """Return a symbol that is 1 if all parameters are finite and valid.

    Each parameter must be within its limits, and each lower limit below the upper limit.
    """
    import casadi as ca

    addresses, conditions = [parameter.address for parameter in interface.parameters], []
    for k, parameter in enumerate(interface.parameters):
        # Both comparisons are false if the parameter is not a number.
        low, high = max(parameter.low, -LARGEST_INPUT), min(parameter.high, LARGEST_INPUT)
        conditions.append(p[k] > parameter.above if parameter.above is not None else p[k] >= low)
        conditions.append(p[k] < parameter.below if parameter.below is not None else p[k] <= high)
    for lower, upper in interface.ascending:
        if lower in addresses and upper in addresses:
            conditions.append(p[addresses.index(lower)] < p[addresses.index(upper)])
    return reduce(ca.logic_and, conditions, ca.SX(1.0))


def _accept_inputs(u: Any, held: Any, interface: _Interface) -> tuple[Any, Any]:
    """Return the inputs that the controllers use, and the condition that all given inputs are valid.

    An input that is not valid keeps the value of `held`. Valid inputs are clipped to their limits.
    """
    import casadi as ca

    accepted, conditions = [], []
    for k, (item, (low, high)) in enumerate(zip(interface.inputs, interface.limits, strict=True)):
        if item.address in interface.flags:
            accepted.append(_choose(u[k] > 0.5, 1.0, 0.0))
            continue
        is_valid = ca.fabs(u[k]) <= LARGEST_INPUT
        value = ca.fmax(u[k], low) if math.isfinite(low) else u[k]
        value = ca.fmin(value, high) if math.isfinite(high) else value
        accepted.append(_choose(is_valid, value, held[k]))
        conditions.append(is_valid)
    return ca.vertcat(*accepted), reduce(ca.logic_and, conditions, ca.SX(1.0))
