"""Checks of an FMU archive before a host program unpacks it and executes its binary."""

from __future__ import annotations

import re
import stat
import xml.etree.ElementTree as ElementTree
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from xml.parsers import expat

from poppet.core.errors import InputError
from poppet.core.files import open_input
from poppet.core.number_format import printable

DESCRIPTION = "modelDescription.xml"
MAX_SIZE, MAX_ENTRIES = 512 * 2**20, 10_000
"""Maximum size of the unpacked content of an archive in bytes, and maximum number of its entries."""
_CHUNK = 2**20
_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_INTERFACES = ("CoSimulation", "ModelExchange", "ScheduledExecution")


@contextmanager
def open_archive(path: Path) -> Iterator[zipfile.ZipFile]:
    """Open an FMU archive for reading; a file that is not an archive raises an error."""
    try:
        with open_input(path) as stream, zipfile.ZipFile(stream) as archive:
            yield archive
    except OSError as problem:
        raise InputError("files.unreadable", path=str(path), why=problem.strerror or str(problem)) from problem
    except zipfile.BadZipFile as problem:
        raise InputError("deploy.fmu.no_archive", name=path.name) from problem


def check_archive(path: Path) -> int:
    """Check that an FMU can be unpacked safely, and return its FMI version, which is 2 or 3.

    The names, sizes and checksums of all entries and the model identifiers are checked. Nothing is written.

    Raises
    ------
    InputError
        If the file cannot be read, is not an FMU, or is not safe.
    """
    with open_archive(path) as archive:
        check_entries(archive, path.name)
        if DESCRIPTION not in archive.namelist():
            raise InputError("deploy.fmu.no_fmu", name=path.name)
        content = archive.read(DESCRIPTION)
    try:
        parser = expat.ParserCreate()
        parser.StartDoctypeDeclHandler = _reject_entities
        parser.Parse(content, True)
        root = ElementTree.fromstring(content)
        version = {"2": 2, "3": 3}[root.attrib["fmiVersion"].partition(".")[0]]
    except (KeyError, ValueError, LookupError, expat.ExpatError, ElementTree.ParseError) as problem:
        raise InputError("deploy.fmu.no_fmu", name=path.name) from problem
    for interface in _INTERFACES:
        for element in root.iter(interface):
            identifier = element.get("modelIdentifier", "")
            if not _IDENTIFIER.fullmatch(identifier):
                raise InputError("deploy.fmu.identifier", name=path.name, identifier=identifier)
    return version


def check_entries(archive: zipfile.ZipFile, name: str) -> None:
    """Check the names, sizes and checksums of all entries of the archive with the file name `name`."""
    entries = archive.infolist()
    size = sum(entry.file_size for entry in entries)
    if size > MAX_SIZE or len(entries) > MAX_ENTRIES:
        raise InputError(
            "deploy.fmu.too_large", name=name, megabytes=size / 2**20, count=len(entries), most=MAX_SIZE // 2**20,
            most_entries=MAX_ENTRIES,
        )  # fmt: skip
    names: dict[str, tuple[str, int, int]] = {}
    for entry in entries:
        # The original name: the class cuts names at null characters.
        raw = entry.orig_filename
        parts = raw.removesuffix("/").split("/")
        is_plain = printable(raw) == raw and not set("\\:\n\t\0") & set(raw)
        if not is_plain or not all(part and part.strip(". ") for part in parts):
            raise InputError("deploy.fmu.entry_path", name=name, entry=raw)
        mode = entry.external_attr >> 16
        if stat.S_IFMT(mode) not in (0, stat.S_IFREG, stat.S_IFDIR):
            raise InputError("deploy.fmu.entry_link", name=name, entry=raw)
        content = raw, entry.file_size, entry.CRC
        # Some tools add an identical entry again.
        if names.setdefault(raw.lower(), content) != content:
            raise InputError("deploy.fmu.entry_twice", name=name, entry=raw)
    for entry in entries:
        try:
            with archive.open(entry) as stream:
                while stream.read(_CHUNK):  # checks length and checksum
                    pass
        except (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError, ValueError) as problem:
            raise InputError("deploy.fmu.damaged", name=name, entry=entry.filename, why=str(problem)) from problem


def _reject_entities(*_: object) -> None:
    # Entities can expand to any size or include other files; no FMU needs them.
    raise ValueError("document type")
