"""Files with passwords: passwords are never part of the command line, where other users can read them."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.toml_file import TomlFile


def read_secrets(path: str, option: str, report: Callable[[Note], None]) -> Mapping[str, str]:
    """Return the texts of a TOML file, such as `name = "password"`.

    A file that other users of the computer can read causes a warning.

    Parameters
    ----------
    path : str
        File.
    option : str
        Option that names the file, for messages.
    report : callable
        Function that shows a warning.
    """
    file = TomlFile.read(path)
    with file.errors() as errors:
        if not (content := file.content):
            errors.add("serve.no_secrets", option, path=path)
        for name, value in content.items():
            if not isinstance(value, str) or not value:
                # Without the value, which can be a password.
                errors.add("serve.secret", name)
    warn_of_readers(path, option, report)
    return content


def read_secret_bytes(path: str, option: str, report: Callable[[Note], None]) -> bytes:
    """Return the content of a file with a private key; a file that other users can read causes a warning."""
    content = read_bytes(path, option)
    warn_of_readers(path, option, report)
    return content


def read_bytes(path: str, option: str) -> bytes:
    """Return the content of a small binary file."""
    from poppet.core.files import open_input

    try:
        with open_input(path) as file:
            return file.read(2**20)
    except OSError as error:
        raise InputError("serve.unreadable", option, path=path, why=error.strerror) from None


def warn_of_readers(path: str, option: str, report: Callable[[Note], None]) -> None:
    """Report a warning if other users of the computer can read a file."""
    if os.name == "posix" and Path(path).stat().st_mode & 0o077:
        report(Note("serve.readable_secret", option, path=path))
