"""Nodes of an OPC UA server: values of a machine with units, ranges and status codes.

This module requires asyncua; `poppet.serve.opcua` imports it if its option is used.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

import numpy as np
from asyncua import ua
from asyncua.crypto.permission_rules import User, UserRole
from asyncua.server.address_space import AddressSpace, AttributeService, NodeManagementService
from numpy.typing import NDArray

from poppet.core.errors import InputError
from poppet.serve.machine import WORDS, Machine
from poppet.serve.points import Point, PointRole
from poppet.serve.snapshot import MachineState, Snapshot

MACHINE_NODE = "$machine"
"""Identifier of the folder with all nodes of a circuit; no part has this name."""
STATE_CODES = {
    MachineState.STARTING: ua.StatusCodes.BadWaitingForInitialData,
    MachineState.FAILED: ua.StatusCodes.BadDeviceFailure,
    MachineState.STOPPED: ua.StatusCodes.BadOutOfService,
}
"""Status codes of inputs and outputs while the machine does not run."""
UNIT_CODES = {
    "1": "C62", "1/Pa": "C96", "1/m": "C92", "Hz": "HTZ", "J": "JOU", "J/(kg K)": "B11", "J/K": "JE", "K": "KEL",
    "N": "NEW", "N m": "NU", "N s/m": "C58", "N/m": "4P", "Pa": "PAL", "Pa s": "C65", "V": "VLT", "W": "WTT",
    "W/K": "D52", "kg": "KGM", "kg m^2": "B32", "kg/s": "KGS", "m": "MTR", "m/s": "MTS", "m/s^2": "MSK", "m^2": "MTK",
    "m^3": "MTQ", "m^3/s": "MQS", "rad": "C81", "rad/s": "2A", "rad/s^2": "2B", "s": "SEC",
}  # fmt: skip
"""Codes of SI units in UNECE Recommendation 20, from which OPC UA derives its unit identifiers."""
UNIT_NAMESPACE = "http://www.opcfoundation.org/UA/units/un/cefact"
_RANK = -1  # scalar


@dataclass(frozen=True, eq=False)
class OpcVariable:
    """Variable whose value is an element of the vector of `MachineValues`.

    Parameters
    ----------
    address : str
        Address of the point or fault, or the identifier of a status variable.
    type : VariantType
        Data type.
    index : int
        Index in the vector.
    convert : callable
        Function that converts the element to the value of the node.
    is_live : bool
        True if the value is invalid while the machine does not run.
    is_writable : bool
        True if clients can write the value.
    """

    address: str
    type: Any
    index: int
    convert: Callable[[float], Any]
    is_live: bool = False
    is_writable: bool = False


class MachineValues:
    """Present values of a machine as data values of OPC UA.

    One vector contains the values of all points, the codes of all faults, and the status of the machine.

    Attributes
    ----------
    variables : dict
        Mapping from node identifiers to variables.
    """

    STATUS = ("time", "periods", "late_periods", "state", "note")

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.variables: dict[Any, OpcVariable] = {}
        self.by_index: dict[int, list[Any]] = {}
        self.valves = tuple(machine.faults)
        self.faults = {f"{valve}.fault": valve for valve in self.valves}
        self.first_fault = len(machine.points)
        self.first_status = self.first_fault + len(self.valves)
        self.code: Any = None
        self.vector = np.empty(0)
        self.snapshot: Snapshot
        self._period, self._stamp = -2, datetime.now(UTC)  # before the first one
        self.refresh()

    def add(self, node_id: Any, variable: OpcVariable) -> None:
        """Add a variable."""
        self.variables[node_id] = variable
        self.by_index.setdefault(variable.index, []).append(node_id)

    def refresh(self) -> None:
        """Take the present values of the machine."""
        self.snapshot = snapshot = self.machine.snapshot()
        faults = [float(WORDS.index(self.machine.fault_of(valve))) for valve in self.valves]
        state = float(snapshot.state.value)
        status = (snapshot.time, snapshot.period + 1, snapshot.late, state, state)
        self.vector = np.concatenate((snapshot.array, faults, status))
        if self._period != snapshot.period:
            self._period, self._stamp = snapshot.period, datetime.now(UTC)
        self.code = STATE_CODES.get(snapshot.state)

    def data_value(self, node_id: Any, _attribute: Any = None) -> ua.DataValue:
        """Return the value of a node, with its status code and the time of the snapshot."""
        variable = self.variables[node_id]
        number = float(self.vector[variable.index])
        code = self.code if variable.is_live else None
        if code is None and math.isnan(number):
            code = ua.StatusCodes.BadWaitingForInitialData
        value = ua.Variant() if code else ua.Variant(variable.convert(number), variable.type)
        # An undefined code would be good.
        status = ua.StatusCode(code or ua.StatusCodes.Good)
        return ua.DataValue(value, status, SourceTimestamp=self._stamp, ServerTimestamp=datetime.now(UTC))

    def changed(self, previous: NDArray[np.float64], previous_code: Any) -> list[Any]:
        """Return the nodes whose values or status codes differ from those of a previous vector."""
        if previous_code != self.code or len(previous) != len(self.vector):
            return [*self.variables]
        same = (previous == self.vector) | (np.isnan(previous) & np.isnan(self.vector))
        return [node_id for k in np.flatnonzero(~same).tolist() for node_id in self.by_index.get(k, ())]


class MachineAttributes(AttributeService):  # type: ignore[misc]
    """Read and write services of a machine: the values of one request belong to one period.

    Clients can write the values of inputs and faults only. Each value of a request has its own status code, as OPC UA
    requires; all valid ones act in the same period.
    """

    def __init__(self, aspace: AddressSpace, values: MachineValues) -> None:
        super().__init__(aspace)
        self.values, self.n_written, self.n_rejected = values, 0, 0

    def read(self, params: Any) -> Any:
        self.values.refresh()
        return super().read(params)

    async def write(self, params: Any, user: Any = User(role=UserRole.Admin)) -> Any:  # noqa: B008
        if user.role is UserRole.Admin:  # the server itself
            return await super().write(params, user)
        codes = [self._problem(item) for item in params.NodesToWrite]
        batch: dict[str, tuple[int, Any]] = {}
        for k, item in enumerate(params.NodesToWrite):
            if codes[k] is None:
                address = self.values.variables[item.NodeId].address
                if address in batch:  # a client that writes a node twice: in this order
                    self._command(batch, codes)
                    batch = {}
                batch[address] = k, item.Value.Value.Value
        self._command(batch, codes)
        results = [ua.StatusCode(code) for code in codes]
        self.n_written += sum(result.is_good() for result in results)
        self.n_rejected += sum(not result.is_good() for result in results)
        return results

    def _command(self, batch: Mapping[str, tuple[int, Any]], codes: list[Any]) -> None:
        """Write the valid values of a batch, and set the status codes of all."""
        if not batch:
            return
        values = {address: value for address, (_, value) in batch.items()}
        rejected: set[str] = set()
        try:
            self._write_values(values)
        except InputError as error:
            rejected = {str(problem.address) for problem in error.problems}
            self._write_values({address: value for address, value in values.items() if address not in rejected})
        for address, (k, _) in batch.items():
            codes[k] = ua.StatusCodes.BadOutOfRange if address in rejected else ua.StatusCodes.Good

    def _write_values(self, values: Mapping[str, Any]) -> None:
        faults = self.values.faults
        self.values.machine.command(
            {address: float(value) for address, value in values.items() if address not in faults},
            {faults[address]: _word(value) for address, value in values.items() if address in faults},
        )

    def _problem(self, item: Any) -> Any:
        """Return the status code of a value that cannot be written, or None."""
        if item.NodeId not in self._aspace:
            return ua.StatusCodes.BadNodeIdUnknown
        if item.AttributeId not in self._aspace[item.NodeId].attributes:
            return ua.StatusCodes.BadAttributeIdInvalid
        variable = self.values.variables.get(item.NodeId)
        if variable is None or not variable.is_writable or item.AttributeId != ua.AttributeIds.Value:
            return ua.StatusCodes.BadNotWritable
        data = item.Value
        if item.IndexRange or (data.StatusCode is not None and not data.StatusCode.is_good()):
            return ua.StatusCodes.BadWriteNotSupported
        variant = data.Value
        if variant is None or variant.VariantType is not variable.type or isinstance(variant.Value, list | None):
            return ua.StatusCodes.BadTypeMismatch
        return STATE_CODES.get(self.values.machine.state)


def _word(code: int) -> str:
    """Return the word of a fault code; the machine rejects other texts."""
    return WORDS[code] if 0 <= code < len(WORDS) else str(code)


class NodeBuilder:
    """Address space of a machine: a folder, a folder for each part below it, and the variables of the part.

    Parameters
    ----------
    service : NodeManagementService
        Service of the server that adds nodes.
    aspace : AddressSpace
        Nodes of the server.
    values : MachineValues
        Values of the machine.
    namespace : int
        Index of the namespace.
    """

    def __init__(
        self, service: NodeManagementService, aspace: AddressSpace, values: MachineValues, namespace: int
    ) -> None:
        self._service, self._aspace, self._values, self._namespace = service, aspace, values, namespace
        self._folders: dict[str, Any] = {}

    def build(self) -> None:
        """Add all nodes."""
        values, machine = self._values, self._values.machine
        circuit = machine.served.circuit
        title = circuit.title or "Circuit"
        root = self._folder(ua.NodeId(ua.ObjectIds.ObjectsFolder), MACHINE_NODE, "Machine", title)
        for name in {point.address.partition(".")[0]: None for point in machine.points}:
            part = circuit.parts.get(name)
            self._folders[name] = self._folder(root, name, name, "" if part is None else part.summary)
        for k, point in enumerate(machine.points):
            self._add_point(k, point)
        for k, valve in enumerate(values.valves, values.first_fault):
            words = {WORDS.index(word): word for word in (WORDS[0], *machine.faults[valve])}
            parent = self._folders.get(valve) or self._folder(root, valve, valve, "")
            variable = OpcVariable(f"{valve}.fault", ua.VariantType.UInt32, k, int, is_writable=True)
            self._add_words(parent, "fault", variable, words, f"fault of {valve}")
        self._add_status(root)

    def _add_point(self, index: int, point: Point) -> None:
        name, _, local = point.address.partition(".")
        variable = OpcVariable(
            point.address, ua.VariantType.Boolean if point.is_flag else ua.VariantType.Double, index,
            _flag if point.is_flag else float, is_live=point.role is not PointRole.PARAMETER,
            is_writable=point.role is PointRole.INPUT,
        )  # fmt: skip
        has_range = math.isfinite(point.low) or math.isfinite(point.high)
        kinds = ua.ObjectIds
        kind = kinds.AnalogItemType if has_range else kinds.AnalogUnitType
        kind = kinds.BaseDataVariableType if point.is_flag else kind
        node = self._add_variable(self._folders[name], point.address, local or name, variable, kind, point.doc)
        if not point.is_flag:
            self._property(node, "EngineeringUnits", _unit(point.unit), kinds.EUInformation)
            if has_range:
                self._property(node, "EURange", ua.Range(point.low, point.high), kinds.Range)

    def _add_words(self, parent: Any, name: str, variable: OpcVariable, words: Mapping[int, str], doc: str) -> None:
        """Add a variable with named numbers, and its text."""
        identifier = variable.address
        node = self._add_variable(parent, identifier, name, variable, ua.ObjectIds.MultiStateValueDiscreteType, doc)
        texts = [ua.EnumValueType(code, ua.LocalizedText(word), ua.LocalizedText(word)) for code, word in words.items()]
        self._property(node, "EnumValues", texts, ua.ObjectIds.EnumValueType)
        text = OpcVariable(
            variable.address,
            ua.VariantType.LocalizedText,
            variable.index,
            lambda code: ua.LocalizedText(words[int(code)]),
        )
        self._add_variable(node, f"{identifier}/ValueAsText", "ValueAsText", text, ua.ObjectIds.PropertyType, "")

    def _add_status(self, root: Any) -> None:
        """Add the status of the machine."""
        kind, first, snapshot_of = ua.ObjectIds.BaseDataVariableType, self._values.first_status, self._values
        integer = ua.VariantType.UInt64
        docs = (
            ("time", ua.VariantType.Double, float, "time of the machine in s"),
            ("periods", integer, int, "number of periods since the start"),
            ("late_periods", integer, int, "number of periods that began more than 2 ms late"),
        )
        for k, (name, variant, convert, doc) in enumerate(docs, first):
            identifier = f"{MACHINE_NODE}.{name}"
            self._add_variable(root, identifier, name, OpcVariable(identifier, variant, k, convert), kind, doc)
        states = {state.value: state.name.lower() for state in MachineState}
        identifier, k = f"{MACHINE_NODE}.state", first + len(docs)
        state = OpcVariable(identifier, ua.VariantType.UInt32, k, int)
        self._add_words(root, "state", state, states, "state of the machine")
        identifier = f"{MACHINE_NODE}.note"
        note = OpcVariable(identifier, ua.VariantType.String, k + 1, lambda _: str(snapshot_of.snapshot.note or ""))
        self._add_variable(root, identifier, "note", note, kind, "reason of a failure")

    def _folder(self, parent: Any, identifier: str, name: str, doc: str) -> Any:
        node_id = ua.NodeId(identifier, self._namespace)
        attributes = ua.ObjectAttributes(DisplayName=ua.LocalizedText(name), Description=ua.LocalizedText(doc))
        kind, reference = ua.ObjectIds.FolderType, ua.ObjectIds.Organizes
        self._add(parent, node_id, name, ua.NodeClass.Object, attributes, kind, reference)
        return node_id

    def _add_variable(self, parent: Any, identifier: str, name: str, variable: OpcVariable, kind: int, doc: str) -> Any:
        """Add a variable whose value is read from the machine."""
        node_id = ua.NodeId(identifier, self._namespace)
        levels = (ua.AccessLevel.CurrentRead, *((ua.AccessLevel.CurrentWrite,) if variable.is_writable else ()))
        access = sum(level.mask for level in levels)
        attributes = ua.VariableAttributes(
            DisplayName=ua.LocalizedText(name), Description=ua.LocalizedText(doc), Value=ua.Variant(),
            DataType=ua.NodeId(variable.type.value), ValueRank=_RANK, AccessLevel=access, UserAccessLevel=access,
            MinimumSamplingInterval=0.0,
        )  # fmt: skip
        is_property = kind == ua.ObjectIds.PropertyType
        reference = ua.ObjectIds.HasProperty if is_property else ua.ObjectIds.HasComponent
        self._add(parent, node_id, name, ua.NodeClass.Variable, attributes, kind, reference)
        self._values.add(node_id, variable)
        self._aspace.set_attribute_value_callback(node_id, ua.AttributeIds.Value, self._values.data_value)
        return node_id

    def _property(self, parent: Any, name: str, value: Any, data_type: int) -> None:
        """Add a constant property of the standard."""
        rank = 1 if isinstance(value, list) else _RANK
        attributes = ua.VariableAttributes(
            DisplayName=ua.LocalizedText(name), Value=ua.Variant(value, ua.VariantType.ExtensionObject),
            DataType=ua.NodeId(data_type), ValueRank=rank, AccessLevel=ua.AccessLevel.CurrentRead.mask,
            UserAccessLevel=ua.AccessLevel.CurrentRead.mask,
        )  # fmt: skip
        node_id = ua.NodeId(f"{parent.Identifier}/{name}", self._namespace)
        kinds = ua.ObjectIds
        self._add(parent, node_id, name, ua.NodeClass.Variable, attributes, kinds.PropertyType, kinds.HasProperty)

    def _add(
        self, parent: Any, node_id: Any, name: str, node_class: Any, attributes: Any, kind: int, reference: int
    ) -> None:
        # Names of the standard's properties are in its own namespace.
        namespace = 0 if reference == ua.ObjectIds.HasProperty else self._namespace
        item = ua.AddNodesItem(
            ParentNodeId=parent, ReferenceTypeId=ua.NodeId(reference), RequestedNewNodeId=node_id,
            BrowseName=ua.QualifiedName(name, namespace), NodeClass=node_class, NodeAttributes=attributes,
            TypeDefinition=ua.NodeId(kind),
        )  # fmt: skip
        (result,) = self._service.add_nodes([item])
        result.StatusCode.check()


def _flag(value: float) -> bool:
    return value > 0.5


def _unit(symbol: str) -> ua.EUInformation:
    """Return a unit; units without a code of the standard have the identifier -1."""
    code, text = UNIT_CODES.get(symbol), ua.LocalizedText(symbol)
    identifier = -1 if code is None else int.from_bytes(code.encode(), "big")
    return ua.EUInformation(UNIT_NAMESPACE if code else "", identifier, text, text)
