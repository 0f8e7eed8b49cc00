"""Encoding of WebAssembly modules, as in the WebAssembly core specification, section 5."""

from __future__ import annotations

from collections.abc import Sequence

MAGIC = b"\0asm\1\0\0\0"
"""First bytes of a module."""
PAGE = 65536
"""Size of a page of memory [B]."""


def encode_section(kind: int, content: bytes) -> bytes:
    """Encode a section of a module."""
    return bytes([kind]) + encode_unsigned(len(content)) + content


def encode_unsigned(value: int) -> bytes:
    """Encode a non-negative integer as LEB128."""
    encoded = bytearray()
    while value >= 0x80:
        encoded.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes([*encoded, value])


def encode_signed(value: int) -> bytes:
    """Encode a non-negative integer as signed LEB128, the integer format of WebAssembly."""
    encoded = encode_unsigned(value)
    return encoded if encoded[-1] < 0x40 else bytes([*encoded[:-1], encoded[-1] | 0x80, 0])


def encode_vector(items: Sequence[bytes]) -> bytes:
    """Encode a list of encoded items."""
    return encode_unsigned(len(items)) + b"".join(items)


def encode_name(text: str) -> bytes:
    """Encode a name."""
    return encode_vector([bytes([byte]) for byte in text.encode("utf-8")])
