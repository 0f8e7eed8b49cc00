"""Functions that list, read and write files of the folder."""

from __future__ import annotations

from typing import Annotated

from poppet.assist.arguments import Argument
from poppet.assist.folder import Folder
from poppet.assist.limits import TEXT
from poppet.assist.replies import Json
from poppet.assist.simulation import Replace

Name = Annotated[str, Argument("name of a file in the folder, such as plant.toml or tests/run.csv", longest=200)]


def list_files(folder: Folder) -> Json:
    """List the circuit files, recordings and texts of the folder with their sizes."""
    rows, has_more = folder.files()
    return {"files": rows, "has_more": has_more}


def read_file(folder: Folder, name: Name) -> Json:
    """Read a text file of the folder."""
    return {"name": name, "text": folder.read(name, "name")}


def write_file(
    folder: Folder,
    name: Name,
    text: Annotated[str, Argument("content of the file", longest=TEXT)],
    replace: Replace = False,
) -> Json:
    """Write a text file into the folder, for example a circuit file or an identification file."""
    return {"name": name, "bytes": folder.write(name, "name", text, replace)}
