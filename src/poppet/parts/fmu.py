"""Part `fmu`: an FMU whose inputs and outputs are those of a part of the circuit."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.provenance import Number, Source
from poppet.cosim.description import FmuDescription, FmuVariable, read_fmu
from poppet.cosim.fmu_slave import FmuSetup
from poppet.cosim.fmu_units import NUMBER, FmuUnit, unit_of_text
from poppet.parts import symbols
from poppet.parts.captions import CaptionNumbers
from poppet.parts.conditions import KIND_OF_UNIT
from poppet.parts.fields import NumberLike, NumberSpec, number, option, read_number, reference
from poppet.parts.part import Controller, ControlOutputs, Input, Scope, Surroundings

SHORTEST_STEP = 1e-6
"""Shortest communication step [s]."""


class StartValues(Mapping[str, Any]):
    """Values of FMU variables at the start by local name: numbers, or texts of text variables.

    `numbers` and `with_numbers` are the interface for changes of single values.
    """

    def __init__(self, values: Mapping[str, Any], variables: Mapping[str, FmuVariable]) -> None:
        self._values, self._variables = dict(values), variables

    def __getitem__(self, name: str) -> Any:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def numbers(self) -> dict[str, Number]:
        """Return all numbers that can be changed: those of the user and those of the FMU."""
        of_fmu = {
            local: Number(v.unit.to_si(float(v.start)), v.unit.name, Source("given", "model description"))
            for local, v in self._variables.items()
            if v.type != "String" and v.start is not None
        }
        return of_fmu | {local: value for local, value in self._values.items() if isinstance(value, Number)}

    def number_specs(self) -> dict[str, NumberSpec]:
        """Return the declarations of these numbers."""
        return {local: _spec(v) for local, v in self._variables.items()}

    def with_numbers(self, numbers: Mapping[str, Number]) -> StartValues:
        """Return a copy with other numbers."""
        return StartValues(self._values | dict(numbers), self._variables)


@dataclass(frozen=True, init=False)
class FMU(Controller):
    """FMU for co-simulation (FMI 2.0 or 3.0), an imported model of any tool.

    Its inputs and outputs are inputs and outputs of the part. Characters of a name other than letters, digits and
    underscores become an underscore in addresses: `body.v[1]` is `body_v_1`. Values are converted to SI units.

    Notes
    -----
    The model description is read when the part is created, which executes nothing. A run executes native code of the
    FMU, which requires permission: ``circuit.simulate(allow_native=True)``. The circuit and the FMU exchange their
    values at communication points. A circuit with an FMU can be simulated; analyses that require the equations, such as
    a steady state, are not available.
    """

    kind: ClassVar[str] = "fmu"
    symbol: ClassVar[symbols.Symbol | str] = symbols.FMU
    summary: ClassVar[str] = "imported model (FMU) for co-simulation"

    path: Any = reference(doc="path of the FMU, relative to the circuit file", form="str")
    step: NumberLike = number(
        "s", optional=True, low=SHORTEST_STEP,
        doc="communication step; default: that of the FMU, or `output_step`; the shortest of several FMUs applies",
    )  # fmt: skip
    start_: Any = reference(doc="start values of parameters and inputs of the FMU, by name", form="mapping")
    units: Any = reference(doc="units of variables for which the FMU states none, by name", form="mapping")
    coupling: str = option(
        "continuous", "sampled",
        doc="course of the values in a step; sampled: the FMU is a controller that samples at the communication points",
    )  # fmt: skip
    time_limit: NumberLike = number(
        "s", "60 s", doc="maximum time of one call; a longer one ends the run", above=0.0, note="default"
    )

    def __init__(
        self, path: Any = None, *, step: NumberLike = None, start: Any = None, units: Any = None,
        coupling: str = "continuous", time_limit: NumberLike = None, start_: Any = None,
    ) -> None:  # fmt: skip
        # The attribute ends with an underscore, because `start` is a method of all parts.
        fields = {
            "path": path, "step": step, "start_": start if start_ is None else start_, "units": units,
            "coupling": coupling, "time_limit": time_limit,
        }  # fmt: skip
        for name, value in fields.items():
            object.__setattr__(self, name, value)
        self.__post_init__()

    def check(self) -> None:
        if self.path is None:
            raise InputError("fields.missing", "path", meaning="path of the FMU", unit="", plain=False, example="")
        if not isinstance(self.path, str | Path) or not str(self.path):
            raise InputError("fields.not_a_name", "path", value=self.path)
        object.__setattr__(self, "path", str(self.path))
        try:
            description = read_fmu(self.path)
        except InputError as error:
            raise error.at("path") from None
        with ErrorCollector() as errors:
            description = description.with_units(self._read_units(errors, description))
            object.__setattr__(self, "_description", description)
            start = self._read_start(errors, description)
        object.__setattr__(self, "start_", start)

    def _read_units(self, errors: ErrorCollector, description: FmuDescription) -> dict[str, FmuUnit]:
        units = {}
        for name, text in self._table(errors, "units", self.units).items():
            variable = _find(errors, f"units.{name}", str(name), description)
            if variable is None:
                continue
            if not isinstance(text, str):
                errors.add("fields.not_a_name", f"units.{name}", value=text)
                continue
            with errors.collecting():
                try:
                    unit = unit_of_text(text)
                except InputError as error:
                    raise error.at(f"units.{name}") from None
                if variable.unit not in (NUMBER, unit):
                    raise InputError("fmu.unit_stated", f"units.{name}", value=text, unit=variable.unit.name)
                units[variable.local] = unit
        return units

    def _read_start(self, errors: ErrorCollector, description: FmuDescription) -> StartValues:
        variables = {v.local: v for v in description.variables if v.causality != "output"}
        if isinstance(self.start_, StartValues):
            return StartValues(dict(self.start_), variables)
        values: dict[str, Any] = {}
        for name, argument in self._table(errors, "start", self.start_).items():
            address = f"start.{name}"
            variable = _find(errors, address, str(name), description, is_set=True)
            if variable is None:
                continue
            if variable.causality == "output":
                errors.add("fmu.start_of_output", address)
                continue
            with errors.collecting():
                values[variable.local] = _read_start_value(address, argument, variable)
        return StartValues(values, variables)

    def _table(self, errors: ErrorCollector, name: str, table: Any) -> Mapping[str, Any]:
        if table is None or isinstance(table, Mapping):
            return table or {}
        errors.add("fmu.no_table", name, value=table)
        return {}

    @property
    def description(self) -> FmuDescription:
        """Properties and variables of the FMU."""
        description: FmuDescription = self._description  # type: ignore[attr-defined]
        return description

    def setup(self, name: str, numbers: Mapping[str, float], tolerance: float) -> FmuSetup:
        """Return the FMU of a run, with the values of its parameters in its own units.

        Parameters
        ----------
        name : str
            Name of the part.
        numbers : mapping
            Mapping from names of parameters of the part to values in SI units.
        tolerance : float
            Relative tolerance of the run.

        Returns
        -------
        FmuSetup
            FMU, start values, time limit and course of its inputs.
        """
        start = {
            v.name: value if isinstance(value, str) else v.unit.from_si(numbers[f"start.{v.local}"])
            for v in self.description.variables
            if v.causality == "parameter" and (value := self.start_.get(v.local)) is not None
        }
        return FmuSetup(name, self.description, start, numbers["time_limit"], self.coupling == "sampled", tolerance)

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        return ["FMU", Path(self.path).name]

    def numbers(self) -> dict[str, Number]:
        given = {f"start.{name}": value for name, value in self.start_.items() if isinstance(value, Number)}
        return super().numbers() | given

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        for v in self.description.variables:
            given = self.start_.get(v.local)
            if isinstance(given, Number):
                values[f"start.{v.local}"] = given.absolute(ambient.pressure)
            elif v.causality != "parameter":
                values[f"start.{v.local}"] = v.unit.to_si(float(v.start)) if v.start is not None else 0.0
        return values

    def structure(self) -> Hashable:
        coupled = (*self.description.inputs, *self.description.outputs)
        variables = tuple((v.local, v.causality, v.unit.name) for v in coupled)
        return super().structure(), variables, tuple(n for n in self.start_ if isinstance(self.start_[n], Number))

    def inputs(self) -> tuple[Input, ...]:
        def declare(v: FmuVariable) -> Input:
            flags = {"is_flag": v.type == "Boolean", "kind": KIND_OF_UNIT.get(v.unit.name, "plain")}
            limits = {"low": v.low, "high": v.high} if v.causality == "input" else {"is_coupled": True}
            return Input(v.local, v.unit.name, f"start.{v.local}", **flags, **limits)  # type: ignore[arg-type]

        return tuple(map(declare, (*self.description.inputs, *self.description.outputs)))

    def control(self, scope: Scope) -> ControlOutputs:
        coupled = (*self.description.outputs, *self.description.inputs)
        return ControlOutputs({v.local: (scope.inputs[v.local], v.unit.name) for v in coupled})


def _find(
    errors: ErrorCollector, address: str, name: str, description: FmuDescription, *, is_set: bool = False
) -> FmuVariable | None:
    """Return the variable with a name in the FMU or in addresses; collect an error if there is none.

    With `is_set`, the error suggests only variables that can be set.
    """
    for variable in description.variables:
        if name in (variable.name, variable.local):
            return variable
    near = NameSuggestion(name, [v.name for v in description.variables if not (is_set and v.causality == "output")])
    errors.add("fields.not_an_option", address, value=name, meaning="variable of the FMU", suggestion=near)
    return None


def _spec(variable: FmuVariable) -> NumberSpec:
    name = variable.unit.name
    return NumberSpec(name, "start value", kind=KIND_OF_UNIT.get(name, "plain"), low=variable.low, high=variable.high)


def _read_start_value(address: str, argument: Any, variable: FmuVariable) -> Any:
    """Return the start value of a variable: a text, or a number in SI units."""
    if variable.type == "String":
        if not isinstance(argument, str):
            raise InputError("fields.not_a_name", address, value=argument)
        return argument
    if isinstance(argument, bool):
        argument = float(argument)
    return read_number(address, _spec(variable), argument)
