"""Identifiers, comments and string literals of exported files, and writing of an export.

A folder is written completely or not at all.
"""

from __future__ import annotations

import os
import re
import shutil
import uuid
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path, PurePosixPath

from poppet.core.errors import InputError
from poppet.core.files import check_characters, check_folder, unwritable, write_whole
from poppet.core.toml import toml_text
from poppet.core.version import __version__

MARK = "poppet-export.toml"
"""File name of the manifest in each exported folder. Only an empty folder or one with this file can be rewritten."""
# Words of C, C++ and structured text, in lower case because structured text ignores the case.
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
    """Convert a text to an identifier that is valid in all exported languages.

    The languages are C, C++, XML and structured text.

    Examples
    --------
    >>> identifier("valve.pilot_pressure"), identifier("2/2 Ventil für Öl"), identifier("do"), identifier("steps.A+")
    ('valve_pilot_pressure', 'm2_2_Ventil_f_r_l', 'do_v', 'steps_A_plus')
    """
    # Movements of cylinders are A+ and A-.
    text = re.sub(r"\+(?=[.\s]|$)", " plus", re.sub(r"-(?=[.\s]|$)", " minus", text))
    name = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")[:60].strip("_") or "model"
    name = f"m{name}" if name[0].isdigit() else name
    return f"{name}_v" if name.lower() in _RESERVED else name


def identifiers(texts: Sequence[str], taken: Iterable[str] = ()) -> list[str]:
    """Convert texts to identifiers that differ from each other, even without regard to case.

    The identifiers in `taken` are not available.

    Examples
    --------
    >>> identifiers(["a.b_c", "a_b.c", "A.b.c"])
    ['a_b_c', 'a_b_c_2', 'A_b_c_3']
    """
    lower_names = {name.lower() for name in taken}
    names = []
    for text in texts:
        name = base = identifier(text)
        count = 1
        while name.lower() in lower_names:
            count += 1
            name = f"{base}_{count}"
        lower_names.add(name.lower())
        names.append(name)
    return names


def comment_text(text: str) -> str:
    """Convert a text to one line of printable ASCII for a comment.

    The line cannot end the comment in any of the exported languages.

    Examples
    --------
    >>> comment_text('a */ b' + chr(10) + 'c (* d *) 5 µm')
    'a * / b c ( * d * ) 5 ?m'
    """
    line = " ".join(text.split())
    # Pairs of question marks start trigraphs, and a backslash at the end joins the line with the next.
    line = "".join(c if " " <= c <= "~" else "?" for c in line).replace("\\", "/")
    line = re.sub(r"\?(?=\?)", "? ", line)
    return re.sub(r"\*(?=[/)])|[/(](?=\*)|/(?=/)", lambda match: f"{match.group()} ", line)


def c_string(text: str) -> str:
    """Convert a text to a string literal of C.

    Special characters are written as octal codes of their UTF-8 bytes.

    Examples
    --------
    >>> print(c_string('say "m\u00b2"?'))
    "say \\042m\\302\\262\\042\\077"
    """
    safe = b" .,:;_-+*/()[]=^|<>"
    # Always three octal digits: a following digit cannot become part of them.
    characters = (chr(b) if b in safe or (b < 128 and chr(b).isalnum()) else f"\\{b:03o}" for b in text.encode())
    return f'"{"".join(characters)}"'


def write_export(path: Path, target: str, title: str, files: Mapping[str, str | bytes], *, is_folder: bool) -> Path:
    """Write an export to its output file or folder.

    Parameters
    ----------
    path : Path
        Output file or folder.
    target, title : str
        Name of the target and title of the circuit, for the manifest of a folder.
    files : mapping
        Content by path in the folder; a single entry if the output is a file.
    is_folder : bool
        True if the output is a folder.

    Returns
    -------
    Path
        The written file or folder.
    """
    if is_folder:
        manifest = {"target": target, "title": title, "poppet": __version__, "files": sorted(files)}
        return write_folder(path, files, toml_text(manifest))
    (content,) = files.values()
    return write_whole(path, lambda stream: stream.write(content.encode() if isinstance(content, str) else content))


def write_folder(folder: Path, files: Mapping[str, str | bytes], manifest: str) -> Path:
    """Write a folder of files.

    A new folder appears completely or not at all. In the folder of an earlier export, the files of the export are
    replaced after all of them have been written; other files are kept.

    Parameters
    ----------
    folder : Path
        Output folder; its parent exists.
    files : mapping
        Content by path in the folder, with slashes; text is written as UTF-8.
    manifest : str
        TOML text that describes the export.

    Returns
    -------
    Path
        The folder.

    Raises
    ------
    InputError
        If the folder contains anything but an earlier export, or cannot be written.
    """
    check_characters(folder)
    target = Path(os.path.realpath(folder))
    check_folder(folder, target.parent)
    if target.exists() and (not target.is_dir() or (any(target.iterdir()) and not (target / MARK).is_file())):
        raise InputError("deploy.folder_taken", path=str(folder))
    contents = {MARK: manifest, **files}
    for path in contents:
        # Reject paths that would be outside of the folder on any system.
        names = path.split("/")
        if not all(_FILE_NAME.fullmatch(name) and not name.endswith(".") for name in names):
            raise InputError("deploy.outside", path=path)
    temporary = target.with_name(f".{target.name}.{uuid.uuid4().hex[:12]}")
    try:
        for path, content in contents.items():
            file = temporary.joinpath(*PurePosixPath(path).parts)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content.encode() if isinstance(content, str) else content)
        if target.exists():
            for path in contents:
                file = target.joinpath(*PurePosixPath(path).parts)
                # A link in place of a folder leads out of the target; a link in place of a file is replaced.
                if any(parent.is_symlink() for parent in file.parents if target in parent.parents):
                    raise InputError("deploy.outside", path=path)
                file.parent.mkdir(parents=True, exist_ok=True)
                os.replace(temporary.joinpath(*PurePosixPath(path).parts), file)
        else:
            temporary.rename(target)
    except OSError as problem:
        raise unwritable(folder, problem) from problem
    finally:
        with suppress(OSError):
            shutil.rmtree(temporary)
    return folder
