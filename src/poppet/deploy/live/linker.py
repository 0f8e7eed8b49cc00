"""From a relocatable WebAssembly object of LLVM to a module that a browser takes.

One object holds everything, so that there is nothing to resolve between objects: its functions, types, globals and
tables keep the numbers they have. What remains is to say where data and stack lie, to own the memory, the table and the
stack pointer that an object asks its surroundings for, and to name what is called from outside. Formats are those of
the WebAssembly core specification, section 5, and of the tool conventions, "WebAssembly Object File Linking".
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

_MAGIC = b"\0asm\1\0\0\0"
_PAGE = 65536
_CUSTOM, _TYPE, _IMPORT, _FUNCTION, _TABLE, _MEMORY, _GLOBAL, _EXPORT, _START, _ELEMENT, _CODE, _DATA = range(12)
_COUNT = 12  # of data segments, stands before the code
_ORDER = (_TYPE, _IMPORT, _FUNCTION, _TABLE, _MEMORY, _GLOBAL, _EXPORT, _ELEMENT, _COUNT, _CODE, _DATA)
_OF_FUNCTION, _OF_TABLE, _OF_MEMORY, _OF_GLOBAL = range(4)
_SYMBOLS, _SYMBOL_FUNCTION, _SYMBOL_DATA = 8, 0, 1
_UNDEFINED, _EXPLICIT = 0x10, 0x40
_NUMBERED = (0, 6, 7, 20)
"""Relocations that name a function, a type, a global or a table: they hold its number already."""
_ADDRESSES = {3: "leb", 4: "sleb", 5: "i32"}
"""Relocations that hold an address of data, and how it is written."""


class Module(NamedTuple):
    """A linked module, and what its page has to know."""

    code: bytes
    table: Mapping[str, int]  # place of each function that is called by its address
    heap: int  # first byte that nobody uses, a multiple of 16
    imports: tuple[str, ...]  # functions that the page has to give


class LinkError(ValueError):
    """An object holds what this linker does not know."""


@dataclass
class _Reader:
    data: bytes
    at: int = 0

    def byte(self) -> int:
        self.at += 1
        return self.data[self.at - 1]

    def number(self) -> int:
        """An unsigned LEB128."""
        value = shift = 0
        while True:
            byte = self.byte()
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def signed(self) -> int:
        """A signed LEB128."""
        start = self.at
        value = self.number()
        bits = 7 * (self.at - start)
        return value - (1 << bits) if value >> (bits - 1) else value

    def bytes(self, length: int) -> bytes:
        self.at += length
        return self.data[self.at - length : self.at]

    def name(self) -> str:
        return self.bytes(self.number()).decode("utf-8")

    def limits(self) -> None:
        flags = self.byte()
        self.number()
        if flags & 1:
            self.number()


@dataclass
class _Object:
    """An object, taken apart."""

    sections: dict[int, bytearray] = field(default_factory=dict)
    places: list[int] = field(default_factory=list)  # kind of section by its place in the file
    relocations: list[tuple[int, bytes]] = field(default_factory=list)  # kind of section, what changes in it
    linking: bytes = b""
    functions: list[str] = field(default_factory=list)  # imported
    kept: list[bytes] = field(default_factory=list)  # their imports as they stand
    addresses: list[int] = field(default_factory=list)  # of data segments, in the object
    symbols: list[tuple[int, str, int]] = field(default_factory=list)  # kind, name, function or address


def link(code: bytes, exports: Sequence[str], tabled: Sequence[str], *, stack: int) -> Module:
    """Make a module of one object.

    Parameters
    ----------
    code : bytes
        Relocatable object.
    exports, tabled : sequence of str
        Functions called by name, and by their place in the table, which begins at 1.
    stack : int
        Its size; it lies below the data, so that one that overflows traps [B].
    """
    found = _taken_apart(code)
    base = -(-stack // 16) * 16
    for kind, text in found.relocations:
        _relocate(found, kind, text, base)
    own = {name: number for kind, name, number in found.symbols if kind == _SYMBOL_FUNCTION}
    size = _move_data(found, base)
    heap = -(-(base + size) // 16) * 16
    sections = {kind: bytes(text) for kind, text in found.sections.items()}
    sections[_IMPORT] = _vector(found.kept)
    sections[_TABLE] = _vector([b"\x70\0" + _leb(1 + len(tabled))])
    sections[_MEMORY] = _vector([b"\0" + _leb(-(-heap // _PAGE))])
    sections[_GLOBAL] = _vector([b"\x7f\1\x41" + _sleb(base) + b"\x0b"])
    outside = [_named(name) + bytes([_OF_FUNCTION]) + _leb(own[name]) for name in exports]
    sections[_EXPORT] = _vector([_named("memory") + bytes([_OF_MEMORY, 0]), *outside])
    sections[_ELEMENT] = _vector([b"\0\x41\1\x0b" + _vector([_leb(own[name]) for name in tabled])])
    body = b"".join(bytes([kind]) + _leb(len(sections[kind])) + sections[kind] for kind in _ORDER if kind in sections)
    return Module(_MAGIC + body, {name: k + 1 for k, name in enumerate(tabled)}, heap, tuple(found.functions))


def _taken_apart(code: bytes) -> _Object:
    reader, found = _Reader(code, len(_MAGIC)), _Object()
    if not code.startswith(_MAGIC):
        raise LinkError("no WebAssembly")
    while reader.at < len(code):
        kind = reader.byte()
        text = reader.bytes(reader.number())
        found.places.append(kind)
        if kind != _CUSTOM:
            found.sections[kind] = bytearray(text)
            continue
        own = _Reader(text)
        name = own.name()
        if name == "linking":
            found.linking = text[own.at :]
        elif name.startswith("reloc."):
            target = found.places[own.number()]
            if target != _CUSTOM:
                found.relocations.append((target, text[own.at :]))
    _read_imports(found)
    found.addresses = [address for address, _ in _segments(found)]
    _read_symbols(found)
    return found


def _read_imports(found: _Object) -> None:
    """Functions stay imports; of memory, table and stack pointer there may be one each, which the module will own."""
    reader, others = _Reader(bytes(found.sections[_IMPORT])), []
    for _ in range(reader.number()):
        begin = reader.at
        reader.name()
        name, kind = reader.name(), reader.byte()
        if kind == _OF_FUNCTION:
            reader.number()
            found.functions.append(name)
            found.kept.append(reader.data[begin : reader.at])
            continue
        others.append(name)
        if kind == _OF_TABLE:
            reader.byte()
        if kind == _OF_GLOBAL:
            reader.bytes(2)
        else:
            reader.limits()
    if not set(others) <= {"__linear_memory", "__indirect_function_table", "__stack_pointer"}:
        raise LinkError(f"imports {others}")
    if _GLOBAL in found.sections or _TABLE in found.sections or _ELEMENT in found.sections:
        raise LinkError("globals, tables or elements of its own")


def _segments(found: _Object) -> Iterator[tuple[int, bytes]]:
    """Address and content of each data segment."""
    reader = _Reader(bytes(found.sections.get(_DATA, b"\0")))
    for _ in range(reader.number()):
        if reader.byte() != 0 or reader.byte() != 0x41:
            raise LinkError("a data segment without a constant address")
        address = reader.signed()
        reader.byte()
        yield address, reader.bytes(reader.number())


def _read_symbols(found: _Object) -> None:
    reader = _Reader(found.linking)
    if reader.number() != 2:
        raise LinkError("another version of the conventions")
    while reader.at < len(found.linking):
        kind = reader.byte()
        end = reader.number() + reader.at
        if kind == _SYMBOLS:
            found.symbols = [_symbol(reader, found) for _ in range(reader.number())]
        reader.at = end


def _symbol(reader: _Reader, found: _Object) -> tuple[int, str, int]:
    kind, flags = reader.byte(), reader.number()
    if kind == _SYMBOL_DATA:
        name = reader.name()
        if flags & _UNDEFINED:
            raise LinkError(f"data {name} is missing")
        segment, offset = reader.number(), reader.number()
        reader.number()
        return kind, name, found.addresses[segment] + offset
    number = reader.number()
    # Of an import the name is that of the import, unless one is given.
    name = reader.name() if kind != 3 and (not flags & _UNDEFINED or flags & _EXPLICIT) else ""
    return kind, name, number


def _relocate(found: _Object, section: int, text: bytes, base: int) -> None:
    reader, target = _Reader(text), found.sections[section]
    for _ in range(reader.number()):
        kind, at, symbol = reader.byte(), reader.number(), reader.number()
        if kind in _NUMBERED:
            continue
        if kind not in _ADDRESSES:
            raise LinkError(f"relocation {kind}")
        value = base + found.symbols[symbol][2] + reader.signed()
        form = _ADDRESSES[kind]
        if form == "i32":
            target[at : at + 4] = value.to_bytes(4, "little")
        else:
            target[at : at + 5] = _padded(value)


def _move_data(found: _Object, base: int) -> int:
    """Write the data segments behind the stack; returns their size."""
    segments = list(_segments(found))
    if segments:
        moved = [b"\0\x41" + _sleb(base + at) + b"\x0b" + _leb(len(text)) + text for at, text in segments]
        found.sections[_DATA] = bytearray(_vector(moved))
    return max((at + len(text) for at, text in segments), default=0)


def _leb(value: int) -> bytes:
    text = bytearray()
    while value >= 0x80:
        text.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes([*text, value])


def _sleb(value: int) -> bytes:
    """A signed LEB128 of a number that is not negative."""
    text = _leb(value)
    return text if text[-1] < 0x40 else bytes([*text[:-1], text[-1] | 0x80, 0])


def _padded(value: int) -> bytes:
    """A LEB128 in five bytes, signed and unsigned alike below 2^31."""
    return bytes([*((value >> 7 * k) & 0x7F | 0x80 for k in range(4)), (value >> 28) & 0x7F])


def _vector(items: Sequence[bytes]) -> bytes:
    return _leb(len(items)) + b"".join(items)


def _named(text: str) -> bytes:
    return _vector([bytes([byte]) for byte in text.encode("utf-8")])
