"""Flow paths after ISO 6358: flow capacity, flow law and orifice."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar

from poppet import library
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import is_symbolic, where
from poppet.laws import iso6358
from poppet.laws.curves import Characteristic, characteristic_from_mapping
from poppet.laws.curves.characteristic import ANYWHERE
from poppet.parts import symbols
from poppet.parts.captions import ASSUMED, CaptionNumbers, format_value
from poppet.parts.fields import NumberLike, laminar_limit, model, number, port, reference, subsonic_index_m
from poppet.parts.part import Flow, GasState, Input, Passage, PassageFlows, Quantities, Scope, Surroundings

_SIZES = (
    "sonic_conductance", "effective_area", "flow_coefficient_kv", "flow_coefficient_cv", "nominal_flow",
    "characteristic",
)  # fmt: skip

_WITH_RATIO = ("effective_area", "characteristic")
"""Sizes that determine the critical ratio."""

# Stated for air or a liquid, independent of the gas of the circuit.
_FROM_AIR: dict[str, Callable[..., iso6358.Conductance]] = {
    "flow_coefficient_kv": iso6358.conductance_from_flow_coefficient_kv,
    "flow_coefficient_cv": iso6358.conductance_from_flow_coefficient_cv,
    "nominal_flow": iso6358.conductance_from_nominal_flow,
}


def read_characteristic(argument: Any, address: str) -> Characteristic:
    """Read a flow characteristic from the library, a TOML file or a table.

    `argument` is the name in the library, the path of the file, or the table. `address` is the address of the field in
    errors.
    """
    if isinstance(argument, Characteristic):
        return argument
    if isinstance(argument, Mapping):
        return characteristic_from_mapping(argument, name=address)
    if isinstance(argument, str) and argument.endswith(".toml"):
        return characteristic_from_mapping(read_table_file(argument, address), name=argument)
    if isinstance(argument, str):
        return library.characteristic(argument)
    raise InputError("parts.not_a_characteristic", address, value=argument, known=library.characteristics())


def read_table_file(path: str, address: str) -> Mapping[str, Any]:
    """Return the content of a TOML file with the table of a field.

    `address` is the address of the field in errors.
    """
    from poppet.core.toml_file import TomlFile

    try:
        return TomlFile.read(Path(path)).content
    except InputError as error:
        raise InputError("parts.unreadable_file", address, path=path, why=error.reason) from None


def _assumed_ratio(size: str) -> Number:
    return Number(0.3, "1", Source("assumed", note=f"{size} alone does not determine b: 0.3 assumed"))


@dataclass(frozen=True)
class FlowPath(Passage):
    """Base class of flow paths after ISO 6358.

    Exactly one field specifies the flow capacity: `sonic_conductance`, `effective_area`, `flow_coefficient_kv`,
    `flow_coefficient_cv`, `nominal_flow` or `characteristic`. Subclasses declare the ports.

    Notes
    -----
    If a flow coefficient, a nominal flow or a sonic conductance is specified without a critical ratio, the critical
    ratio is 0.3 and has the source `assumed`. An effective area is converted to C and b of an isentropic nozzle with
    the gas of the circuit. A flow coefficient refers to a liquid and a nominal flow to air; both are converted to C and
    b for the gas of the circuit.
    """

    sonic_conductance: NumberLike = number("m^3/(s Pa)", optional=True, doc="sonic conductance C", low=0.0)
    critical_ratio: NumberLike = number("1", optional=True, doc="critical ratio b", low=0.0, below=1.0)
    effective_area: NumberLike = number("m^2", optional=True, doc="effective area of an isentropic nozzle", low=0.0)
    flow_coefficient_kv: NumberLike = number("1", optional=True, doc="flow coefficient Kv", low=0.0, high=1e6)
    flow_coefficient_cv: NumberLike = number("1", optional=True, doc="flow coefficient Cv", low=0.0, high=1e6)
    nominal_flow: NumberLike = number(
        "m^3/s ANR", optional=True, kind="volume_flow_anr", doc="nominal flow qNn (6 to 5 bar g)", low=0.0
    )
    characteristic: Any = reference(doc="C and b as functions of a stroke; library name, .toml file or table")
    subsonic_index: NumberLike = subsonic_index_m()
    laminar_ratio: NumberLike = laminar_limit()
    model: Any = model()

    sizes: ClassVar[tuple[str, ...]] = _SIZES
    has_stroke: ClassVar[bool] = False
    """True if the flow path has a stroke, which a characteristic needs."""

    def usable_numbers(self, stated: Mapping[str, Number]) -> Mapping[str, Number]:
        # The copied part can have the assumed ratio of another component.
        ratio = self.critical_ratio
        is_number = isinstance(ratio, Number) and not is_symbolic(ratio.value)
        if is_number and ratio in [_assumed_ratio(size) for size in _SIZES]:
            object.__setattr__(self, "critical_ratio", None)
        specified = [name for name in _SIZES if getattr(self, name) is not None]
        if not specified:
            return stated
        idle = {*_SIZES} | ({"critical_ratio"} if specified[0] in _WITH_RATIO else set())
        return {name: value for name, value in stated.items() if name not in idle}

    def check(self) -> None:
        specified = [name for name in _SIZES if getattr(self, name) is not None]
        if not specified:
            raise InputError("parts.no_size", "sonic_conductance", sizes=[*_SIZES])
        if len(specified) > 1:
            raise InputError("parts.several_sizes", specified[1], given=specified, sizes=[*_SIZES])
        if self.critical_ratio is not None and specified[0] in _WITH_RATIO:
            raise InputError("parts.idle_critical_ratio", "critical_ratio", size=specified[0])
        if self.characteristic is not None:
            object.__setattr__(self, "characteristic", self.read_curve("characteristic"))
            if not self.has_stroke:
                raise InputError("parts.no_stroke_to_follow", "characteristic", kind=self.kind)
        # The ratio of an effective area depends on the gas.
        elif self.critical_ratio is None and self.effective_area is None:
            object.__setattr__(self, "critical_ratio", _assumed_ratio(specified[0]))

    def read_curve(self, field: str) -> Characteristic:
        """Return the flow characteristic that a field of the flow path specifies."""
        return read_characteristic(getattr(self, field), field)

    @property
    def _size(self) -> str:
        """Name of the field that specifies the flow capacity, such as `nominal_flow`."""
        return next(name for name in _SIZES if getattr(self, name) is not None)

    def notes(self) -> tuple[Note, ...]:
        is_assumed = self.critical_ratio == _assumed_ratio(self._size)
        return (Note("parts.assumed_ratio", "critical_ratio", size=self._size),) if is_assumed else ()

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        if self.characteristic is not None:
            return [f"C(x), b(x): {self.characteristic.name}"]
        conductance: Any = self.sonic_conductance
        mark = ASSUMED if conductance is not None and conductance.source.kind == "assumed" else ""
        value = format_value(numbers.parameter("sonic_conductance"), "m^3/(s Pa)")
        return [f"C = {value}{mark}", f"b = {numbers.text(self.critical_ratio)}"]

    def numbers(self) -> dict[str, Number]:
        values = super().numbers()
        if self.characteristic is not None:
            values.update({f"characteristic.{name}": value for name, value in self.characteristic.numbers().items()})
        return values

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values = super().parameters(ambient)
        if self.characteristic is not None:
            return values | {f"characteristic.{k}": v for k, v in self.characteristic.parameters().items()}
        if self._size != "sonic_conductance":
            # Other specifications of the flow capacity give C and b for the gas of the circuit.
            gas = {"isentropic_exponent": ambient.isentropic_exponent, "gas_constant": ambient.gas_constant}
            if self._size == "effective_area":
                nozzle = iso6358.conductance_from_effective_area(values[self._size], **gas)
                conductance, ratio = nozzle.sonic_conductance, nozzle.critical_ratio
            else:
                ratio_of_air = values["critical_ratio"]
                factor, shift = iso6358.factors_from_air(**gas)
                of_air = _FROM_AIR[self._size](values[self._size], critical_ratio=ratio_of_air)
                conductance, ratio = factor * of_air.sonic_conductance, ratio_of_air + (1.0 - ratio_of_air) * shift
            values["sonic_conductance"], values["critical_ratio"] = ambient.capacity_as_stated(conductance, ratio)
        return {name: value for name, value in values.items() if name not in _SIZES[1:]}

    def structure(self) -> Hashable:
        return super().structure(), None if self.characteristic is None else self.characteristic.structure()

    def size_at(self, scope: Scope, stroke: Any) -> tuple[Any, Any]:
        """Return the sonic conductance [m^3/(s Pa)] and the critical pressure ratio [1] at a stroke.

        `scope` contains the values of the parameters. The stroke [m] has an effect only if a characteristic specifies
        the flow capacity.
        """
        if self.characteristic is None:
            return scope["sonic_conductance"], scope["critical_ratio"]
        return characteristic_at(self.characteristic, scope, "characteristic.", stroke)


def characteristic_at(curve: Characteristic, scope: Scope, prefix: str, stroke: Any) -> tuple[Any, Any]:
    """Return sonic conductance [m^3/(s Pa)] and critical pressure ratio [1] of a characteristic at a stroke [m].

    `curve` is the characteristic. Its parameters are the parameters of the part in `scope` whose names begin with
    `prefix`.
    """
    values = _PrefixedParameters(scope, prefix)
    return curve.sonic_conductance_at(stroke, values), curve.critical_ratio_at(stroke, values)


class _PrefixedParameters(Mapping[str, Any]):
    """Mapping of all parameters of a part whose names begin with a prefix, by the name without the prefix."""

    def __init__(self, scope: Scope, prefix: str) -> None:
        self._scope, self._prefix = scope, prefix

    def __getitem__(self, name: str) -> Any:
        return self._scope[f"{self._prefix}{name}"]

    @cached_property
    def _names(self) -> tuple[str, ...]:
        start = len(self._prefix)
        return tuple(name[start:] for name in self._scope.numbers if name.startswith(self._prefix))

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


def iso_flow(
    scope: Scope, name: str, ports: tuple[str, str], gas: tuple[GasState, GasState], size: tuple[Any, Any], *,
    cracking_pressure: Any = 0.0, one_way: bool = False, regime: str = "regime",
) -> tuple[Flow, Quantities]:  # fmt: skip
    """Return the ISO 6358 flow between two ports, and the outputs of the flow path.

    `ports` and `gas` are the names and the gas states of the two ports. `size` contains the sonic conductance and the
    critical pressure ratio of the flow path. `scope` contains the other parameters. `name` is the name of the output
    for the mass flow rate, and the keyword `regime` is the name of the output for the flow regime. The flow starts at
    the pressure difference `cracking_pressure` [Pa]. If the keyword `one_way` is True, flow from the second port to the
    first port is blocked.
    """
    conductance, ratio = scope.surroundings.capacity_in_circuit_gas(*size)
    first, second = gas
    law = {"cracking_pressure": cracking_pressure, "laminar_ratio": scope["laminar_ratio"], "one_way": one_way}
    law_of_size = {"sonic_conductance": conductance, "subsonic_index": scope["subsonic_index"], **law}
    mass, temperature = iso6358.flow(
        first.pressure, second.pressure, first.temperature, second.temperature, critical_ratio=ratio, **law_of_size
    )
    code = iso6358.flow_regime(first.pressure, second.pressure, critical_ratio=ratio, **law)
    if is_symbolic(conductance):
        code = where(conductance > 0.0, code, 0.0)
    enthalpy = scope.surroundings.heat_capacity_pressure * temperature * mass
    return Flow(name, *ports, mass, enthalpy), {name: (mass, "kg/s"), regime: (code, "1")}


def single_flow(scope: Scope, gas: Mapping[str, GasState], size: tuple[Any, Any], **law: Any) -> PassageFlows:
    """Return the flow of a part whose ports are `from` and `to`, with its outputs.

    `gas` contains the gas states at the ports, `size` contains sonic conductance and critical pressure ratio, and the
    keyword arguments are further arguments of `iso_flow`.
    """
    flow, outputs = iso_flow(scope, "mass_flow_rate", ("from", "to"), (gas["from"], gas["to"]), size, **law)
    return PassageFlows((flow,), outputs)


def named_flow(
    scope: Scope, gas: Mapping[str, GasState], name: str, ends: tuple[str, str], size: tuple[Any, Any], **law: Any
) -> tuple[Flow, Quantities]:
    """Return one of several flows of a part, and its outputs.

    `gas` contains the gas states at all ports, `ends` the two ports of the flow, and `size` sonic conductance and
    critical pressure ratio. The names of the outputs begin with `name`. The keyword arguments are further arguments of
    `iso_flow`.
    """
    states = gas[ends[0]], gas[ends[1]]
    return iso_flow(scope, f"{name}_mass_flow_rate", ends, states, size, regime=f"{name}_regime", **law)


@dataclass(frozen=True)
class Orifice(FlowPath):
    """Restriction, fitting, line or valve seat with a sonic conductance and a critical ratio.

    Flow from the first to the second port is positive. If a characteristic specifies the flow capacity, the part has
    the input `stroke`.

    Examples
    --------
    >>> bleed = Orifice(from_="tank", to="ambient", sonic_conductance="1.2 dm^3/(s bar)", critical_ratio=0.3)
    >>> float(bleed.sonic_conductance)
    1.2e-08
    """

    kind: ClassVar[str] = "orifice"
    symbol: ClassVar[symbols.Symbol | str] = symbols.RESTRICTION
    has_stroke: ClassVar[bool] = True
    summary: ClassVar[str] = "an ISO 6358 flow path: C, b, m; or Kv, Cv, qNn, effective area, characteristic"

    from_: str | None = port("gas node at the first port")
    to: str | None = port("gas node at the second port")
    opening: NumberLike = number("1", 1.0, doc="opening", low=0.0, high=1.0, note="fully open by default")
    stroke: NumberLike = number("m", optional=True, doc="stroke")

    def check(self) -> None:
        super().check()
        if self.stroke is not None and self.characteristic is None:
            raise InputError("parts.idle_stroke", "stroke")

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        has_fixed_stroke = self.stroke is not None and "stroke" not in numbers.signals
        return super().caption(numbers) + ([f"x = {numbers.text(self.stroke)}"] if has_fixed_stroke else [])

    def symbol_for(self, is_driven: bool) -> symbols.Symbol | str:
        is_variable = is_driven or self.characteristic is not None
        return symbols.VARIABLE_RESTRICTION if is_variable and self.symbol is symbols.RESTRICTION else self.symbol

    def inputs(self) -> tuple[Input, ...]:
        opening = Input("opening", "1", "opening", low=0.0, high=1.0, is_command=True)
        if self.characteristic is None:
            return (opening,)
        return Input("stroke", "m", "stroke" if self.stroke is not None else 0.0, is_command=True), opening

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        return {"stroke": (self.characteristic, ANYWHERE)} if self.characteristic is not None else {}

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        conductance, ratio = self.size_at(scope, scope.inputs.get("stroke"))
        return single_flow(scope, gas, (conductance * scope.inputs["opening"], ratio))
