"""Random mutations of all kinds of input files, which the command line reads in this process.

`python tests/cli/mutated_files.py 20000 [KIND ...]` prints one row per kind of file; docs/cli.md states the maxima.
"""

from __future__ import annotations

import contextlib
import io
import os
import resource
import shutil
import signal
import sys
import tempfile
import time
import warnings
from argparse import Namespace
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

from poppet.cli import circuit_files, main
from poppet.timeseries.tables import reading

EXAMPLES = Path(__file__).parents[2] / "examples"
LONGEST, LONGEST_RUN = 10.0, 60.0
"""Processor time that reading one file may take, and a command on it, which tells how far it is [s]."""
WHOLE = 20
"""Of so many files that can be read, one is not only read: the command is run on it."""
ODD = (
    *("nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "0", "-1", "9223372036854775808", "true", '""', "[]", "{}"),
    *("[[1]]", "[1, 'a']", "{ a = 1 }", '"1 bar g"', '"-5 kPa"', '"1e300 m^3"', "1979-05-27", '"\\u0000"'),
    *('"\\u001b["', '"a.b.c"', '"∞ bar"', '"../../x"', "0x7fffffffffffffff", "1e5000", '"ambient"', "[nan, nan]"),
    *("1e6", "1e-6", '"1 s"', '"1e9 l"', "3", "9.2e18", "1e25", "-1e300", '"x.csv"', '"free"'),
)
FEW = 5
"""Of so many pieces a file of tests has the first, so that it is read quickly."""
SIGNS = (0, 9, 10, 13, 27, 34, 44, 91, 0x2028, 0xFEFF, 0x4E2D)


class TooLongError(BaseException):
    """Error raised if a file takes too long; the command line does not convert it to a message."""


@dataclass
class Tally:
    """Counts of the results for mutated files."""

    codes: Counter[int] = field(default_factory=Counter)
    slowest: float = 0.0  # processor time of one file [s]
    slowest_number: int = -1
    growth: float = 0.0  # of the largest memory of the process [MB]


def _circuit(path: Path) -> None:
    circuit_files.check_files(Namespace(files=[str(path)]))


def _fit(path: Path) -> None:
    from poppet.identify.fit.fit_plan import read_fit_file

    read_fit_file(path)


def _tank(path: Path) -> None:
    from poppet.core.toml_file import TomlFile
    from poppet.identify.tank.tank_plan import plan_tank_fit, read_runs
    from poppet.identify.tank.test import read_test

    file = TomlFile.read(path, "recordings")
    with file.errors():
        test = read_test(file)
        plan_tank_fit(test, read_runs(test))


def _flow(path: Path) -> None:
    from poppet.identify.flow.flow_file import read_flow_file

    read_flow_file(path)


def _characteristic(path: Path) -> None:
    from poppet.identify.characteristic.characteristic_file import read_characteristic_file

    read_characteristic_file(path)


def _recordings(path: Path) -> None:
    from poppet.bench.iso10094.valve_recordings import read_valve_recordings
    from poppet.core.toml_file import TomlFile

    file = TomlFile.read(path, "recordings")
    with file.errors():
        read_valve_recordings(file.content, path)


def _components(path: Path) -> None:
    from poppet.parts.component_file import read_components

    read_components(path)


def _twin(path: Path) -> None:
    from poppet.monitoring.twin_file import read_twin_file

    read_twin_file(path)


NAMED_BY = {"discharge.csv": "fit.toml", "flow_points.csv": "flow.toml", "tank_charge.csv": "tank.toml"}


def _csv(path: Path) -> None:
    {"fit.toml": _fit, "flow.toml": _flow, "tank.toml": _tank}[NAMED_BY[path.name]](path.with_name(NAMED_BY[path.name]))


def _identify(path: Path) -> list[str]:
    return ["identify", path.stem, str(path)]


KINDS: dict[str, tuple[tuple[str, ...], Callable[[Path], Any], Callable[[Path], list[str]]]] = {
    "circuit": (
        ("fill_staircase.toml", "pressure_regulator.toml", "pressure_control_scheduled.toml", "two_tanks.toml"),
        _circuit,
        lambda path: ["simulate", str(path), "--duration", "10 ms"],
    ),
    "twin": (("watch/twin.toml",), _twin, lambda path: ["watch", str(path), "--isolable"]),
    "fit": (("identify/fit.toml",), _fit, _identify),
    "tank": (("identify/tank.toml",), _tank, _identify),
    "flow": (("identify/flow.toml",), _flow, _identify),
    "characteristic": (("identify/characteristic.toml",), _characteristic, _identify),
    "recordings": (
        ("bench/recordings.toml",),
        _recordings,
        lambda path: ["bench", "iso10094", "--recording", str(path)],
    ),
    "components": (
        ("components/workshop.toml",),
        _components,
        lambda path: ["library", "--components", str(path)],
    ),
    "csv": (
        tuple(f"identify/{name}" for name in NAMED_BY),
        _csv,
        lambda path: _identify(path.with_name(NAMED_BY[path.name])),
    ),
}
"""Of each kind the files that are mutated, how one is read, and the command that does something with it."""


def mutated(text: str, generator: np.random.Generator) -> bytes:
    """One to three things wrong, as hands, editors, disks and machines make them."""
    for _ in range(int(generator.choice([1, 1, 1, 2, 3]))):
        lines = text.split("\n")
        k = int(generator.integers(len(lines)))
        place = int(generator.integers(len(text) + 1))
        match int(generator.integers(10)):
            case 0:
                del lines[k]
            case 1:
                lines.insert(int(generator.integers(len(lines) + 1)), lines[k])
            case 2 | 3 | 4 if "=" in lines[k]:
                lines[k] = f"{lines[k].partition('=')[0]}= {generator.choice(ODD)}"
            case 2 | 3 | 4:
                cells = lines[k].split(",")
                cells[int(generator.integers(len(cells)))] = str(generator.choice(ODD)).strip('"')
                lines[k] = ",".join(cells)
            case 5:
                lines = [text[:place]]
            case 6:
                lines = [text[:place] + chr(int(generator.choice(SIGNS))) + text[place:]]
            case 7:
                lines = [text[:place] + text[place + int(generator.integers(1, 30)) :]]
            case 8:
                other = int(generator.integers(len(lines)))
                lines[k], lines[other] = lines[other], lines[k]
            case _:
                word = lines[k].partition("=")[0].strip(' []"')
                lines[k] = lines[k].replace(word, f"{word}_", 1) if word else ""
        text = "\n".join(lines)
    return _stored(text, int(generator.integers(60)))


def _stored(text: str, way: int) -> bytes:
    """Mostly as it is, now and then as other systems and broken disks store it."""
    match way:
        case 0:
            return text.encode("utf-16")
        case 1:
            return text.encode("utf-8-sig")
        case 2:
            return text.replace("\n", "\r\n").encode()
        case 3:
            return text.replace("\n", "\r").encode()
        case 4:
            return text.replace(",", ";").replace(".", ",").encode()
        case 5:
            return f"\n{text}".encode()
        case 6:
            return "\n".join(text.split("\n")[:3]).encode()
        case 7:
            return text.encode() + bytes(4096)
        case 8:
            return text.replace("0", "٠").encode("utf-8")
    return text.encode("utf-8")


def campaign(kind: str, count: int, folder: Path) -> Tally:
    """Read so many mutations of a kind in a folder; whatever is no clear answer raises with its text."""
    names, read, command = KINDS[kind]
    shutil.copytree(EXAMPLES, folder / "examples")
    generator = np.random.default_rng([count, *kind.encode()])
    tally, well, memory = Tally(), 0, _largest_memory()
    with _as_command_line():
        for k in range(count):
            path = folder / "examples" / names[k % len(names)]
            original = (EXAMPLES / names[k % len(names)]).read_bytes()
            content = mutated("[[tests]]".join(original.decode().split("[[tests]]")[:FEW]), generator)
            path.write_bytes(content)
            begin = time.process_time()
            try:
                with mock.patch.object(main, "_dispatch", lambda _, path=path: read(path) or 0):
                    code = _answer([])
                well += not code
                if not code and well % WHOLE == 1:
                    code = _answer(command(path))
            except (Exception, TooLongError) as error:
                raise AssertionError(f"{kind}, number {k} of {count}:\n{content!r}") from error
            taken = time.process_time() - begin
            path.write_bytes(original)
            tally.codes[code] += 1
            if taken > tally.slowest:
                tally.slowest, tally.slowest_number = taken, k
    # Other tests of the process have used memory, too.
    tally.growth = _largest_memory() - memory
    return tally


def _largest_memory() -> float:
    """The largest memory that the process has used [MB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0  # kB on Linux


@contextlib.contextmanager
def _as_command_line() -> Iterator[None]:
    """Warnings and internal errors are raised; what is printed is dropped; tables as they were are read once."""
    read = reading.READERS[".csv"]

    @lru_cache(maxsize=32)
    def known(path: Path, _: bytes) -> Any:
        return read(path)

    def remembered(path: Path, *, separator: Any = None, decimal: Any = None, header_rows: Any = None) -> Any:
        options = {"separator": separator, "decimal": decimal, "header_rows": header_rows}
        given = {name: value for name, value in options.items() if value is not None}
        return read(path, **given) if given else known(path, path.read_bytes())

    with (
        warnings.catch_warnings(),
        mock.patch.dict(os.environ, {"POPPET_DEBUG": "1"}),
        mock.patch.dict(reading.READERS, {".csv": remembered}),
        contextlib.redirect_stdout(io.StringIO()) as out,
        contextlib.redirect_stderr(io.StringIO()) as err,
    ):
        warnings.simplefilter("error")
        before = signal.signal(signal.SIGPROF, _too_long)
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0.0)
            signal.signal(signal.SIGPROF, before)
            out.close()
            err.close()


def _too_long(*_: Any) -> None:
    raise TooLongError


def _answer(arguments: list[str]) -> int:
    """The exit code of a command."""
    out, err = sys.stdout, sys.stderr
    assert isinstance(out, io.StringIO)
    assert isinstance(err, io.StringIO)
    for stream in (out, err):
        stream.seek(0)
        stream.truncate()
    signal.setitimer(signal.ITIMER_PROF, LONGEST_RUN if arguments else LONGEST)
    code = main.run(arguments)
    signal.setitimer(signal.ITIMER_PROF, 0.0)
    assert code in (0, 1, 2), code
    assert code == 0 or err.getvalue().startswith(("error: ", "note: "))
    return code


if __name__ == "__main__":
    for each in sys.argv[2:] or KINDS:
        with tempfile.TemporaryDirectory() as place:
            of = campaign(each, int(sys.argv[1]), Path(place))
        shares = " | ".join(str(of.codes[code]) for code in (0, 1, 2))
        print(f"| {each} | {of.codes.total()} | {shares} | {of.slowest:.2f} | {of.growth:.0f} |", flush=True)
        print(f"slowest: number {of.slowest_number}", file=sys.stderr)
