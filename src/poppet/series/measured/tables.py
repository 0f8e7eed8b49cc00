"""One door for all files of measured columns; each format has a file of its own."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from poppet.ground.errors import InputError
from poppet.ground.files import by_suffix
from poppet.series.measured import mat_file, mdf_file, parquet_file, tdms_file, text_file
from poppet.series.measured.columns import Table

__all__ = ["Table", "read_table"]

_TEXT = (".csv", ".txt", ".tsv", ".dat", ".asc", ".lvm", ".log")


def read_table(
    path: Path,
    *,
    separator: str | None = None,
    decimal: str | None = None,
    header_rows: int | None = None,
    group: str | int | None = None,
) -> Table:
    r"""Read the columns of a measured file.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "bench.csv"
    ...     _ = file.write_text("t(s);p [bar]\n0,0;1,5\n0,1;1,25\n")
    ...     table = read_table(file)
    >>> table.names, table.units, table.columns[1].tolist()
    (('t', 'p'), ('s', 'bar'), [1.5, 1.25])
    """
    text = partial(text_file.read, separator=separator, decimal=decimal, header_rows=header_rows)
    grouped: dict[str, Callable[[Path], Table]] = {
        ".tdms": partial(tdms_file.read, group=group),
        **dict.fromkeys((".mf4", ".mdf"), partial(mdf_file.read, group=group)),
    }
    plain: dict[str, Callable[[Path], Table]] = {".mat": mat_file.read, ".parquet": parquet_file.read}
    readers: dict[str, Callable[[Path], Table]] = {**dict.fromkeys(_TEXT, text), **grouped, **plain}
    reader = by_suffix(path, readers)
    options = {"separator": separator, "decimal": decimal, "header_rows": header_rows}
    _check_options(path, options if reader is not text else {})
    _check_options(path, {"group": group} if path.suffix.lower() not in grouped else {})
    try:
        table: Table = reader(path)
    except OSError as problem:
        reason = f"cannot be read: {problem.strerror or problem}."
        raise InputError(f"file {path}", reason, "Check the path.") from problem
    except InputError as problem:
        raise problem.located(file=str(path)) from problem.__cause__
    except Exception as problem:
        # Readers of binary formats end in errors of any kind when a file is damaged or of another format.
        reason = f"is not a sound {path.suffix} file ({type(problem).__name__}: {problem})."
        raise InputError(f"file {path}", reason, "Check what wrote it.") from problem
    return table


def _check_options(path: Path, unfit: dict[str, str | int | None]) -> None:
    for name, value in unfit.items():
        if value is not None:
            given = f"{name} = {value!r}"
            raise InputError(given, f"says nothing about a {path.suffix} file.", f"Leave {name} out.", address=name)
