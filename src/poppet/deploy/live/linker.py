"""Linker from a relocatable WebAssembly object of LLVM to a module for a browser.

There is only one object, so no symbols of other objects are resolved: functions, types, globals and tables keep their
indices. The linker sets the addresses of data and stack, and exports functions. The module defines the memory, the
table and the stack pointer, or it imports them to share them with another module. The formats are those of the
WebAssembly core specification, section 5, and of the tool conventions, "WebAssembly Object File Linking".
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from poppet.deploy.live.wasm_format import (
    MAGIC,
    PAGE,
    encode_name,
    encode_section,
    encode_signed,
    encode_unsigned,
    encode_vector,
)

_CUSTOM, _TYPE, _IMPORT, _FUNCTION, _TABLE, _MEMORY, _GLOBAL, _EXPORT, _START, _ELEMENT, _CODE, _DATA = range(12)
_COUNT = 12  # of data segments; precedes the code
_ORDER = (_TYPE, _IMPORT, _FUNCTION, _TABLE, _MEMORY, _GLOBAL, _EXPORT, _ELEMENT, _COUNT, _CODE, _DATA)
_OF_FUNCTION, _OF_TABLE, _OF_MEMORY, _OF_GLOBAL = range(4)
_POINTER = b"\x7f\1"  # type of the stack pointer: a variable integer of 32 bits
_SYMBOLS, _SYMBOL_FUNCTION, _SYMBOL_DATA = 8, 0, 1
_UNDEFINED, _EXPLICIT = 0x10, 0x40
_INDEX_RELOCATIONS = (0, 6, 7, 20)
"""Relocation types of indices (function, type, global, table), which the linker does not change."""
_ADDRESS_RELOCATIONS = {3: "leb", 4: "sleb", 5: "i32"}
"""Relocation types of data addresses, with the encoding of the address."""


class Module(NamedTuple):
    """Linked WebAssembly module, with the data that a page needs to call it."""

    code: bytes
    table: Mapping[str, int]  # index of each function that is called by its index
    heap: int  # first unused byte, a multiple of 16
    imports: tuple[str, ...]  # functions that the page provides


class LinkError(ValueError):
    """Error raised for an object file with features that this linker does not support."""


@dataclass
class _ByteReader:
    """Reader of the binary format of WebAssembly, at a position in some bytes."""

    data: bytes
    position: int = 0

    def byte(self) -> int:
        self.position += 1
        return self.data[self.position - 1]

    def number(self) -> int:
        """Read an unsigned integer in LEB128 encoding."""
        value = shift = 0
        while True:
            byte = self.byte()
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def signed(self) -> int:
        """Read a signed integer in LEB128 encoding."""
        start = self.position
        value = self.number()
        bits = 7 * (self.position - start)
        return value - (1 << bits) if value >> (bits - 1) else value

    def bytes(self, length: int) -> bytes:
        self.position += length
        return self.data[self.position - length : self.position]

    def name(self) -> str:
        return self.bytes(self.number()).decode("utf-8")

    def limits(self) -> None:
        flags = self.byte()
        self.number()
        if flags & 1:
            self.number()


@dataclass
class _Object:
    """Sections of a WebAssembly object file."""

    sections: dict[int, bytearray] = field(default_factory=dict)
    kinds: list[int] = field(default_factory=list)  # kinds of the sections in the order of the file
    relocations: list[tuple[int, bytes]] = field(default_factory=list)  # kind of section, its relocations
    linking: bytes = b""
    functions: list[str] = field(default_factory=list)  # imported
    function_imports: list[bytes] = field(default_factory=list)  # their imports, encoded
    addresses: list[int] = field(default_factory=list)  # of data segments, in the object
    symbols: list[tuple[int, str, int]] = field(default_factory=list)  # kind, name, function or address


def link(code: bytes, exports: Sequence[str], tabled: Sequence[str], *, stack: int, data: int | None = None) -> Module:
    """Link one WebAssembly object file to a module.

    Parameters
    ----------
    code : bytes
        Relocatable object.
    exports : sequence of str
        Functions that the page calls by name.
    tabled : sequence of str
        Functions that are called by their index in the function table, which begins at 1.
    stack : int
        Size of the stack [B]. The stack is below the data, so an overflow causes a trap.
    data : int, optional
        Address of the data of a module that imports memory, table and stack pointer, which it shares with another
        module. The imports are `memory`, `table` and `stack` of the module `shared`.

    Returns
    -------
    Module
    """
    wasm_object = _read_object(code)
    base = -(-max(stack, data or 0) // 16) * 16
    for section, relocations in wasm_object.relocations:
        reader, target = _ByteReader(relocations), wasm_object.sections[section]
        for _ in range(reader.number()):
            kind, offset, symbol = reader.byte(), reader.number(), reader.number()
            if kind in _INDEX_RELOCATIONS:
                continue
            if kind not in _ADDRESS_RELOCATIONS:
                raise LinkError(f"relocation {kind}")
            value = base + wasm_object.symbols[symbol][2] + reader.signed()
            if _ADDRESS_RELOCATIONS[kind] == "i32":
                target[offset : offset + 4] = value.to_bytes(4, "little")
            else:
                # A LEB128 of five bytes: below 2^31, the signed and the unsigned form are equal.
                padded = [*((value >> 7 * k) & 0x7F | 0x80 for k in range(4)), (value >> 28) & 0x7F]
                target[offset : offset + 5] = bytes(padded)
    function_index = {name: number for kind, name, number in wasm_object.symbols if kind == _SYMBOL_FUNCTION}
    segments = list(_iterate_segments(wasm_object))
    size = max((address + len(content) for address, content in segments), default=0)
    heap = -(-(base + size) // 16) * 16
    sections = {kind: bytes(content) for kind, content in wasm_object.sections.items()}
    if segments:
        encoded = [
            b"\0\x41" + encode_signed(base + address) + b"\x0b" + encode_unsigned(len(content)) + content
            for address, content in segments
        ]
        sections[_DATA] = encode_vector(encoded)
    table, memory = b"\x70\0" + encode_unsigned(1 + len(tabled)), b"\0" + encode_unsigned(-(-heap // PAGE))
    export_entries = [
        encode_name(name) + bytes([_OF_FUNCTION]) + encode_unsigned(function_index[name]) for name in exports
    ]
    if data is None:
        sections[_IMPORT] = encode_vector(wasm_object.function_imports)
        sections[_TABLE], sections[_MEMORY] = encode_vector([table]), encode_vector([memory])
        sections[_GLOBAL] = encode_vector([_POINTER + b"\x41" + encode_signed(base) + b"\x0b"])
        export_entries.insert(0, encode_name("memory") + bytes([_OF_MEMORY, 0]))
    else:
        shared = {"table": bytes([_OF_TABLE]) + table, "memory": bytes([_OF_MEMORY]) + memory}
        shared["stack"] = bytes([_OF_GLOBAL]) + _POINTER
        entries = [encode_name("shared") + encode_name(name) + entry for name, entry in shared.items()]
        sections[_IMPORT] = encode_vector([*wasm_object.function_imports, *entries])
    sections[_EXPORT] = encode_vector(export_entries)
    if tabled:
        sections[_ELEMENT] = encode_vector(
            [b"\0\x41\1\x0b" + encode_vector([encode_unsigned(function_index[name]) for name in tabled])]
        )
    body = b"".join(encode_section(kind, sections[kind]) for kind in _ORDER if kind in sections)
    return Module(MAGIC + body, {name: k + 1 for k, name in enumerate(tabled)}, heap, tuple(wasm_object.functions))


def _read_object(code: bytes) -> _Object:
    reader, wasm_object = _ByteReader(code, len(MAGIC)), _Object()
    if not code.startswith(MAGIC):
        raise LinkError("not a WebAssembly file")
    while reader.position < len(code):
        kind = reader.byte()
        content = reader.bytes(reader.number())
        wasm_object.kinds.append(kind)
        if kind != _CUSTOM:
            wasm_object.sections[kind] = bytearray(content)
            continue
        custom_reader = _ByteReader(content)
        name = custom_reader.name()
        if name == "linking":
            wasm_object.linking = content[custom_reader.position :]
        elif name.startswith("reloc."):
            target = wasm_object.kinds[custom_reader.number()]
            if target != _CUSTOM:
                wasm_object.relocations.append((target, content[custom_reader.position :]))
    # The imports of memory, table and stack pointer are replaced.
    reader, other_imports = _ByteReader(bytes(wasm_object.sections[_IMPORT])), []
    for _ in range(reader.number()):
        begin = reader.position
        reader.name()
        name, kind = reader.name(), reader.byte()
        if kind == _OF_FUNCTION:
            reader.number()
            wasm_object.functions.append(name)
            wasm_object.function_imports.append(reader.data[begin : reader.position])
            continue
        other_imports.append(name)
        if kind == _OF_TABLE:
            reader.byte()
        if kind == _OF_GLOBAL:
            reader.bytes(2)
        else:
            reader.limits()
    if not set(other_imports) <= {"__linear_memory", "__indirect_function_table", "__stack_pointer"}:
        raise LinkError(f"imports {other_imports}")
    if _GLOBAL in wasm_object.sections or _TABLE in wasm_object.sections or _ELEMENT in wasm_object.sections:
        raise LinkError("defines globals, tables or elements")
    wasm_object.addresses = [address for address, _ in _iterate_segments(wasm_object)]
    _read_symbols(wasm_object)
    return wasm_object


def _iterate_segments(wasm_object: _Object) -> Iterator[tuple[int, bytes]]:
    """Yield address and content of each data segment in an object file."""
    reader = _ByteReader(bytes(wasm_object.sections.get(_DATA, b"\0")))
    for _ in range(reader.number()):
        if reader.byte() != 0 or reader.byte() != 0x41:
            raise LinkError("a data segment without a constant address")
        address = reader.signed()
        reader.byte()
        yield address, reader.bytes(reader.number())


def _read_symbols(wasm_object: _Object) -> None:
    """Add all symbols of an object file to its field `symbols`.

    A symbol has a kind, a name, and a number: the index of a function or the address of data.
    """
    reader = _ByteReader(wasm_object.linking)
    if reader.number() != 2:
        raise LinkError("unsupported version of the conventions")
    while reader.position < len(wasm_object.linking):
        is_table = reader.byte() == _SYMBOLS
        end = reader.number() + reader.position
        for _ in range(reader.number() if is_table else 0):
            kind, flags = reader.byte(), reader.number()
            if kind == _SYMBOL_DATA:
                name = reader.name()
                if flags & _UNDEFINED:
                    raise LinkError(f"data {name} is missing")
                number = wasm_object.addresses[reader.number()] + reader.number()
                reader.number()
            else:
                number = reader.number()
                # An import has its own name, unless the symbol has an explicit one.
                name = reader.name() if kind != 3 and (not flags & _UNDEFINED or flags & _EXPLICIT) else ""
            wasm_object.symbols.append((kind, name, number))
        reader.position = end
