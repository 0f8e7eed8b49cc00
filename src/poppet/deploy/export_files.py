"""What an export writes: names that are identifiers, texts that cannot leave their quotes, folders that stay whole."""

from __future__ import annotations

import os
import re
import shutil
import uuid
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path, PurePosixPath

from poppet.core.errors import InputError
from poppet.core.toml import toml_text
from poppet.core.version import __version__

MARK = "poppet-export.toml"
"""In every folder that an export has written: only such a folder is written into again."""
# Of C, C++ and structured text, in lower case, for the last knows no other.
_RESERVED = frozenset(
    re.findall(
        r"\w+",
        """
    abs action alignas alignof and any array asm at auto begin bitand bitor bool boolean break by byte case catch char
    class compl complex concept const constant constexpr continue date decltype default delete dint div do double dword
    dynamic_cast else elsif end enum exit exp explicit export extern f_edge false far final float for friend from
    function goto huge if imaginary implements import inline int interface interval into ldate limit lint ln log long
    lreal ltod lword main max method min mod module mutable namespace near near_ new nil noexcept not null nullptr of on
    operator or overlap override pascal pi pointer private program property protected public read_only real ref
    reference register reinterpret_cast repeat replace requires restrict resume retain return rol ror sel self shl short
    shr signed sin sint sizeof sqrt static step string struct super switch tan task template then this thread_local
    throw time to transition true trunc try type typedef typeid typename uint ulint union unix unsigned until usint
    using var virtual void volatile wchar_t when while with word wstring xor
    """,
    )
)
_FILE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]*")


def identifier(text: str) -> str:
    """A name that C, C++, XML and structured text take, made of any text.

    Examples
    --------
    >>> identifier("valve.pilot_pressure"), identifier("2/2 Ventil für Öl"), identifier("do")
    ('valve_pilot_pressure', 'm2_2_Ventil_f_r_l', 'do_v')
    """
    plain = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")[:60].strip("_") or "model"
    plain = f"m{plain}" if plain[0].isdigit() else plain
    return f"{plain}_v" if plain.lower() in _RESERVED else plain


def identifiers(texts: Sequence[str]) -> list[str]:
    """One for each text, all different, also where case does not count.

    Examples
    --------
    >>> identifiers(["a.b_c", "a_b.c", "A.b.c"])
    ['a_b_c', 'a_b_c_2', 'A_b_c_3']
    """
    taken: set[str] = set()
    found = []
    for text in texts:
        name = own = identifier(text)
        count = 1
        while name.lower() in taken:
            count += 1
            name = f"{own}_{count}"
        taken.add(name.lower())
        found.append(name)
    return found


def plain(text: str) -> str:
    """A text for a comment of any language: printable ASCII in one line, and nothing that ends a comment.

    Examples
    --------
    >>> plain('a */ b' + chr(10) + 'c (* d *) 5 µm')
    'a * / b c ( * d * ) 5 ?m'
    """
    line = " ".join(text.split())
    # Question marks two by two are trigraphs, and a backslash at the end of a line joins it to the next.
    line = "".join(c if " " <= c <= "~" else "?" for c in line).replace("\\", "/")
    line = re.sub(r"\?(?=\?)", "? ", line)
    return re.sub(r"\*(?=[/)])|[/(](?=\*)|/(?=/)", lambda m: f"{m.group()} ", line)


def c_string(text: str) -> str:
    """A literal of C: whatever is not plain is written by its bytes.

    Examples
    --------
    >>> print(c_string('say "m\u00b2"?'))
    "say \\042m\\302\\262\\042\\077"
    """
    kept = b" .,:;_-+*/()[]=^|<>"
    # Three octal digits always: what follows cannot become part of them.
    shown = (chr(b) if b in kept or (b < 128 and chr(b).isalnum()) else f"\\{b:03o}" for b in text.encode())
    return f'"{"".join(shown)}"'


def mark(target: str, title: str, files: Mapping[str, str | bytes]) -> str:
    """What a folder says of itself, in TOML."""
    return toml_text({"target": target, "title": title, "poppet": __version__, "files": sorted(files)})


def write_folder(folder: Path, files: Mapping[str, str | bytes], mark: str) -> Path:
    """Write a folder of files.

    A new folder appears whole or not at all. One that an export has written before keeps what others have put there;
    each file of the export is replaced as a whole, after all of them have been written.

    Parameters
    ----------
    folder : Path
        In a folder that exists.
    files : mapping
        Path within the folder, with slashes, to content; text is written as UTF-8.
    mark : str
        TOML that says what the folder is.

    Returns
    -------
    Path

    Raises
    ------
    InputError
        If the folder holds something else, or cannot be written.
    """
    target = Path(os.path.realpath(folder))
    if not target.parent.is_dir():
        raise InputError("files.no_folder", path=str(folder), folder=str(target.parent))
    if target.exists() and (not target.is_dir() or (any(target.iterdir()) and not (target / MARK).is_file())):
        raise InputError("deploy.folder_taken", path=str(folder))
    contents = {MARK: mark, **files}
    for path in contents:
        _check_path(path)
    aside = target.with_name(f".{target.name}.{uuid.uuid4().hex[:12]}")
    try:
        for path, content in contents.items():
            place = aside.joinpath(*PurePosixPath(path).parts)
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(content.encode() if isinstance(content, str) else content)
        if target.exists():
            _move_into(aside, target, contents)
        else:
            aside.rename(target)
    except OSError as problem:
        raise InputError("files.unwritable", path=str(folder), why=problem.strerror or str(problem)) from problem
    finally:
        with suppress(OSError):
            shutil.rmtree(aside)
    return folder


def _check_path(path: str) -> None:
    """Refuse what would lie outside the folder, on any system."""
    parts = path.split("/")
    if not all(_FILE_NAME.fullmatch(part) and not part.endswith(".") for part in parts):
        raise InputError("deploy.outside", path=path)


def _move_into(aside: Path, target: Path, paths: Mapping[str, str | bytes]) -> None:
    for path in paths:
        place = target.joinpath(*PurePosixPath(path).parts)
        # A link instead of a folder leads out of it; one instead of a file is replaced itself.
        if any(parent.is_symlink() for parent in place.parents if target in parent.parents):
            raise InputError("deploy.outside", path=path)
        place.parent.mkdir(parents=True, exist_ok=True)
        os.replace(aside.joinpath(*PurePosixPath(path).parts), place)
