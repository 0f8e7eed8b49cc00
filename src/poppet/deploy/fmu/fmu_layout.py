"""Variables of an FMU and their value references.

The role of each input and parameter determines which variable of the FMU represents it.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.deploy.export_model import ExportModel

Flags = NDArray[np.bool_]

NUMBER, CONSTANT, PORT, DRIVEN = range(4)
"""Sources of the value of an input, in this order: parameter in p, default value, importer, importer and signal."""
UNCHANGED, FIXED, TUNABLE, INPUT = range(4)
"""Role of a parameter, in this order: constant, set before the run, set during the run, input of the FMU."""
VARIABLE_KINDS = {
    UNCHANGED: ("local", "constant", "exact"),
    FIXED: ("parameter", "fixed", "exact"),
    TUNABLE: ("parameter", "tunable", "exact"),
    INPUT: ("input", "continuous", ""),
}
"""Causality, variability and `initial` of the variable for a parameter, by its role."""
FOLLOWS = "follow_signals"
TIME_REFERENCE, FOLLOWS_REFERENCE, FIRST_REFERENCE = range(3)


class Variable(NamedTuple):
    """Variable of an FMU, with the attributes of its model description.

    `start` is the start value, or None if the FMU calculates the value.
    """

    name: str
    reference: int
    causality: str
    variability: str
    initial: str = ""
    start: float | bool | None = None
    unit: str = ""
    low: float = -np.inf
    high: float = np.inf
    meaning: str = ""
    state: int = -1  # reference of the state whose derivative it is


@dataclass(frozen=True, eq=False)
class FmuLayout:
    """Layout of an FMU: variables, their roles, and the dependencies between them.

    Importers identify each variable by an integer, its value reference.
    """

    export_model: ExportModel
    requested: frozenset[str]  # inputs and parameters that the importer sets, in addition to inputs with signals
    exposed: frozenset[str] = frozenset()  # internal outputs that are outputs of the FMU
    follows_signals: bool = False  # start value of the parameter `follow_signals`
    starts: Mapping[str, float] = field(default_factory=dict)  # start values of inputs that differ from the circuit

    # Roles --------------------------------------------------------------------------------------------------------

    @cached_property
    def sources(self) -> tuple[int, ...]:
        """Source of the value of each input.

        It is `CONSTANT`, `NUMBER` (a parameter), `PORT` (the importer) or `DRIVEN` (a signal, or the importer).
        """
        sources = []
        for item, info in zip(self.export_model.inputs, self.export_model.model.inputs, strict=True):
            if item.is_driven:
                sources.append(DRIVEN)
            elif item.address in self.requested or info.slope_of in self.requested:
                sources.append(PORT)
            else:
                sources.append(NUMBER if item.parameter >= 0 else CONSTANT)
        return tuple(sources)

    @cached_property
    def roles(self) -> tuple[int, ...]:
        """Role of each parameter in the FMU.

        It is `UNCHANGED`, `FIXED` (set before the run), `TUNABLE` (set at any time) or `INPUT`.
        """
        inputs = list(zip(self.export_model.inputs, self.sources, strict=True))
        of_inputs = {item.parameter for item, source in inputs if source == NUMBER}
        ports = {item.address for item, source in inputs if source >= PORT}
        roles = []
        for k, parameter in enumerate(self.export_model.parameters):
            if parameter.fixed or parameter.address in ports:
                roles.append(UNCHANGED)
            elif parameter.address in self.requested and k not in of_inputs:
                roles.append(INPUT)
            elif self.acts_on_run[k] or k in of_inputs:
                roles.append(TUNABLE)
            else:
                roles.append(FIXED if self.acts_on_start[k] else UNCHANGED)
        return tuple(roles)

    @cached_property
    def acts_on_run(self) -> Flags:
        """Mask of the parameters on which rates, outputs or updates of discrete states depend."""
        patterns = [self._pattern(name, "p") for name in ("rates", "outputs", "update")]
        return np.asarray(np.vstack(patterns).any(axis=0))

    @cached_property
    def acts_on_start(self) -> Flags:
        """Mask of the parameters on which initial states or initial discrete states depend."""
        return np.asarray(np.vstack([self._pattern(name, "p") for name in ("start", "memory_start")]).any(axis=0))

    # Dependencies -------------------------------------------------------------------------------------------------

    def _pattern(self, expression: str, symbol: str) -> Flags:
        """Return the dependencies of an expression on the elements of x, u or p.

        `expression` and `symbol` are names. The result is a Boolean matrix with one row per element of the expression
        and one column per element of the symbol. Quadratures (integrals of flows) and discrete states have no columns.
        """
        model = self.export_model.model
        width = {"x": len(model.states), "u": len(model.inputs), "p": len(model.parameters)}[symbol]
        return self._full_pattern(expression, symbol)[:, :width]

    def _memory_pattern(self, expression: str) -> NDArray[np.int_]:
        """Return the dependencies of an expression on the discrete states.

        The result is a matrix of 0 and 1, with one row per element of the expression and one column per discrete state.
        """
        return self._full_pattern(expression, "p")[:, len(self.export_model.model.parameters) :].astype(int)

    def _full_pattern(self, expression: str, symbol: str) -> Flags:
        import casadi as ca

        model = self.export_model.model
        value = ca.SX(model.expressions[expression])
        value = value[: len(model.states)] if expression in ("rates", "start") else value
        pattern = np.zeros((value.shape[0], model.symbols[symbol].shape[0]), dtype=bool)
        if value.shape[0]:
            rows, columns = ca.jacobian_sparsity(value, model.symbols[symbol]).get_triplet()
            pattern[rows, columns] = True
        return pattern

    @cached_property
    def direct_dependencies(self) -> dict[str, tuple[Flags, Flags, Flags]]:
        """Masks of the states, inputs and parameters on which each rate and output depends.

        The keys are `rates` and `outputs`. Each value contains three masks, for x, u and p, with one row per rate or
        output. Dependencies through discrete states are included.
        """
        memory = [self._pattern("update", symbol) for symbol in "xup"]
        between_memory = self._memory_pattern("update")
        for _ in range(between_memory.shape[0]):  # effects over several sample instants
            extended = [pattern | (between_memory @ pattern.astype(int) > 0) for pattern in memory]
            if all(np.array_equal(a, b) for a, b in zip(memory, extended, strict=True)):
                break
            memory = extended
        dependencies = {}
        for name in ("rates", "outputs"):
            by_memory = self._memory_pattern(name)
            x, u, p = (
                self._pattern(name, symbol) | (by_memory @ pattern.astype(int) > 0)
                for symbol, pattern in zip("xup", memory, strict=True)
            )
            dependencies[name] = x, u, p
        return dependencies

    def dependencies(self, name: str) -> list[list[int]]:
        """Return the value references of the variables on which each rate or output depends.

        `name` is `rates` or `outputs`. The variables are states, and variables that the importer sets.
        """
        x, u, p = self.direct_dependencies[name]
        u, p = self._resolve_inputs(u, p)
        return [self._references(x[k], u[k], p[k], (INPUT,)) for k in range(len(x))]

    def initial_dependencies(self, name: str) -> list[list[int]]:
        """Return the inputs and parameters on which each initial value of a group depends.

        `name` selects the group of initial values: `start` (of the states), `rates` or `outputs`. The result contains a
        list for each initial value of the group. The list contains the value references of the inputs and parameters.
        """
        start = self._pattern("start", "p")
        if name == "start":
            u, p = np.zeros((len(start), len(self.export_model.inputs)), dtype=bool), start
        else:
            x, u, p = self.direct_dependencies[name]
            by_memory = self._memory_pattern(name) @ self._pattern("memory_start", "p").astype(int) > 0
            p = p | (x.astype(int) @ start.astype(int) > 0) | by_memory
        u = u.copy()
        for parameter, item in self.initial_inputs:
            u[:, item] |= p[:, parameter]
        u, p = self._resolve_inputs(u, p)
        no_states = np.zeros(0, dtype=bool)
        return [self._references(no_states, u[k], p[k], (FIXED, TUNABLE, INPUT)) for k in range(len(p))]

    def _resolve_inputs(self, u: Flags, p: Flags) -> tuple[Flags, Flags]:
        """Replace dependencies on inputs by dependencies on the parameters that set these inputs.

        `u` and `p` are masks of inputs and parameters, with one row per dependent quantity. The result contains both.
        """
        u, p = u.copy(), p.copy()
        for k, (item, source) in enumerate(zip(self.export_model.inputs, self.sources, strict=True)):
            if source == NUMBER:
                p[:, item.parameter] |= u[:, k]
            if source < PORT:
                u[:, k] = False
        return u, p

    def _references(self, x: Flags, u: Flags, p: Flags, roles: Collection[int]) -> list[int]:
        """Return the value references of selected elements of x, u and p.

        `x`, `u` and `p` are masks. Only parameters with one of the roles `roles` are included.
        """
        state_of = {parameter: k for k, parameter in self.initial_parameters.items()}
        of_p = [
            self.state_reference(state_of[k]) if k in state_of else self.parameter_reference(k)
            for k in map(int, np.flatnonzero(p))
            if self.roles[k] in roles
        ]
        of_u = [self.input_reference(int(k)) for k in np.flatnonzero(u)]
        return [*of_p, *of_u, *(self.state_reference(int(k)) for k in np.flatnonzero(x))]

    @cached_property
    def initial_inputs(self) -> list[tuple[int, int]]:
        """Inputs of the importer on whose start values initial states depend.

        They prescribe the motion of a body, or have no signal in the circuit, such as the measurement of a controller.
        Each item contains the index of the parameter with the start value, and the index of the input.
        """
        names = [item.name for item in self.export_model.model.inputs]
        bases = sorted({item.slope_of for item in self.export_model.model.inputs if item.slope_of})
        pairs = [(self.export_model.instance.place(base), names.index(base)) for base in bases if base in names]
        guided = [(parameter, item) for parameter, item in pairs if self.sources[item] >= PORT]
        inputs = zip(self.export_model.inputs, self.sources, strict=True)
        others = [(item.parameter, k) for k, (item, source) in enumerate(inputs) if source == PORT]
        return [*guided, *(pair for pair in others if pair[0] >= 0 and pair not in guided)]

    n_indicators = 0

    # References ---------------------------------------------------------------------------------------------------

    def parameter_reference(self, k: int) -> int:
        """Return the value reference of the parameter with index k in p."""
        return FIRST_REFERENCE + int(k)

    def input_reference(self, k: int) -> int:
        """Return the value reference of the input with index k in u."""
        return self.parameter_reference(len(self.export_model.parameters)) + k

    def state_reference(self, k: int) -> int:
        """Return the value reference of the state with index k in x."""
        return self.input_reference(len(self.export_model.inputs)) + k

    def rate_reference(self, k: int) -> int:
        """Return the value reference of the derivative of the state with index k."""
        return self.state_reference(len(self.export_model.states)) + k

    def output_reference(self, k: int) -> int:
        """Return the value reference of the output with index k in y."""
        return self.rate_reference(len(self.export_model.states)) + k

    # Variables ----------------------------------------------------------------------------------------------------

    @cached_property
    def state_outputs(self) -> dict[int, int]:
        """Indices of the states that are also outputs, by the index of the output.

        A state and its output have the same address and value.
        """
        import casadi as ca

        model = self.export_model.model
        index_of = {state.name: k for k, state in enumerate(model.states)}
        y, x = model.expressions["outputs"], model.symbols["x"]
        return {
            k: index_of[address]
            for k, (address, _) in enumerate(model.outputs)
            if address in index_of and ca.is_equal(y[k], x[index_of[address]])
        }

    @cached_property
    def initial_parameters(self) -> dict[int, int]:
        """Indices of parameters that are initial values of states, by the index of the state.

        Only parameters without any other effect are included.
        """
        index_of = {parameter.address: k for k, parameter in enumerate(self.export_model.parameters)}
        pairs = {k: index_of.get(state.address, -1) for k, state in enumerate(self.export_model.states)}
        return {k: index for k, index in pairs.items() if index >= 0 and self.roles[index] == FIXED}

    @cached_property
    def computed_addresses(self) -> set[str]:
        """Addresses of all quantities that the FMU calculates.

        They are the states, and the outputs that are not copies of an input with the same address.
        """
        import casadi as ca

        model = self.export_model.model
        index_of = {item.name: k for k, item in enumerate(model.inputs)}
        y, u = model.expressions["outputs"], model.symbols["u"]
        outputs = {
            address
            for k, (address, _) in enumerate(model.outputs)
            if address not in index_of or not ca.is_equal(y[k], u[index_of[address]])
        }
        return outputs | {state.name for state in model.states}

    @cached_property
    def variables(self) -> list[Variable]:
        """All variables of the FMU, with one variable per address."""
        variables = [Variable("time", TIME_REFERENCE, "independent", "continuous", unit="s", meaning="time")]
        if DRIVEN in self.sources:
            text = "the inputs follow the signals of the circuit, and what is set is not looked at"
            follows = self.follows_signals
            variables.append(Variable(FOLLOWS, FOLLOWS_REFERENCE, "parameter", "fixed", "exact", follows, meaning=text))
        items = zip(self.export_model.inputs, self.export_model.model.inputs, self.sources, strict=True)
        for k, (item, info, source) in enumerate(items):
            if source < PORT:
                continue
            start = 0.0 if info.slope_of else self.starts.get(item.address, item.value)
            meaning = f"time derivative of {info.slope_of}" if info.slope_of else ""
            if info.delay and self.export_model.instance.parameters[info.delay]:
                meaning = f"acts at once: {info.delay} delays the signal of the circuit only"
            variables.append(Variable(
                structured_name(item.address), self.input_reference(k), "input", "continuous", "", start, item.unit,
                item.low, item.high, meaning,
            ))  # fmt: skip
        names = {variable.name for variable in variables}
        initial_parameters = set(self.initial_parameters.values())
        for k, parameter in enumerate(self.export_model.parameters):
            is_unused = not (self.acts_on_run[k] or self.acts_on_start[k])
            is_computed = parameter.address in self.computed_addresses
            name = structured_name(parameter.address)
            if name in names or k in initial_parameters or (is_unused and is_computed):
                continue
            variables.append(Variable(
                f"{name}.number" if is_computed else name, self.parameter_reference(k), *VARIABLE_KINDS[self.roles[k]],
                parameter.value, parameter.unit, parameter.low, parameter.high, parameter.meaning,
            ))  # fmt: skip
        names = {variable.name for variable in variables}
        for k in range(len(self.export_model.states)):
            variables += self._state_variables(k, names)
        for k, output in enumerate(self.export_model.outputs):
            name = structured_name(output.address)
            if name in names and output.address in self.exposed:
                name = f"{name}.output"  # of a parameter or an input
            if k not in self.state_outputs and name not in names:
                reference, causality = self.output_reference(k), self._causality(output.address)
                variables.append(Variable(name, reference, causality, "continuous", "calculated", None, output.unit))
        return variables

    def _state_variables(self, k: int, names: set[str]) -> list[Variable]:
        """Return the variable of the state with index `k`, and the variable of its derivative.

        `names` are the names of the variables so far.
        """
        state = self.export_model.states[k]
        name, outputs = structured_name(state.address), self.export_model.outputs
        is_other_output = k not in self.state_outputs.values() and any(y.address == state.address for y in outputs)
        name = f"{name}.state" if name in names or is_other_output else name
        unit = "1/s" if state.unit == "1" else f"{state.unit}/s"
        unit = {"m/s/s": "m/s^2", "rad/s/s": "rad/s^2"}.get(unit, unit)
        reference, causality = self.state_reference(k), self._causality(state.address)
        initial, start = "calculated", None
        if k in self.initial_parameters:
            initial, start = "exact", self.export_model.parameters[self.initial_parameters[k]].value
        return [
            Variable(name, reference, causality, "continuous", initial, start, state.unit),
            Variable(
                f"der({name})", self.rate_reference(k), "local", "continuous", "calculated", None, unit, state=reference
            ),
        ]

    def _causality(self, address: str) -> str:
        is_internal = address in self.export_model.instance.inner and address not in self.exposed
        return "local" if is_internal else "output"

    def output_variable(self, address: str) -> Variable:
        """Return the variable of an output."""
        k = [output.address for output in self.export_model.outputs].index(address)
        of_state = self.state_outputs.get(k)
        reference = self.output_reference(k) if of_state is None else self.state_reference(of_state)
        return next(variable for variable in self.variables if variable.reference == reference)


_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def structured_name(address: str) -> str:
    """Convert an address to the FMI naming convention `structured`.

    Names with special characters are quoted.

    Examples
    --------
    >>> structured_name("tank.volume"), structured_name("tank-1.volume")
    ('tank.volume', "'tank-1'.volume")
    """
    return ".".join(name if _IDENTIFIER.fullmatch(name) else f"'{name}'" for name in address.split("."))


def build_layout(
    export_model: ExportModel, inputs: Sequence[str] = (), exposed: Collection[str] = (), *,
    follows_signals: bool = False, starts: Mapping[str, float] | None = None,
) -> FmuLayout:  # fmt: skip
    """Return the layout of the FMU of a model.

    Parameters
    ----------
    export_model : ExportModel
        Model of the circuit.
    inputs : sequence of str
        Addresses of inputs and parameters that the importer sets, in addition to the inputs with signals.
    exposed : collection of str, optional
        Addresses of internal outputs that are outputs of the FMU.
    follows_signals : bool, optional
        Start value of the parameter `follow_signals`.
    starts : mapping of str to float, optional
        Start values of inputs by address (default: those of the circuit).

    Returns
    -------
    FmuLayout

    Raises
    ------
    InputErrors
        If an address is unknown, or its parameter must not change during a run.
    """
    reasons = {parameter.address: parameter.fixed for parameter in export_model.parameters}
    reasons |= {item.address: "" for item in export_model.inputs}
    with ErrorCollector() as errors:
        for address in inputs:
            if address not in reasons:
                near = NameSuggestion(address, reasons)
                errors.add("names.unknown", address, meaning="an input or parameter of this circuit", suggestion=near)
            elif reasons[address]:
                errors.add("deploy.fmu.fixed_input", address, why=reasons[address])
    return FmuLayout(export_model, frozenset(inputs), frozenset(exposed), follows_signals, starts or {})
