"""Seeded mutations of every kind of file: a clear refusal or a result, never an internal error, a warning or a hang."""

from __future__ import annotations

import shutil
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from poppet.ground.errors import PoppetError

EXAMPLES = Path(__file__).parents[2] / "examples"
LONGEST = 10.0
"""Seconds for reading one file, as long as it may take on a busy machine."""
ODD = (
    *("nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "0", "-1", "9223372036854775808", "true", '""', "[]", "{}"),
    *(
        "[[1]]",
        "[1, 'a']",
        "{ a = 1 }",
        '"1 bar g"',
        '"-5 kPa"',
        '"1e300 m^3"',
        "1979-05-27",
        '"\\u0000"',
        '"\\u001b["',
    ),
    *('"a.b.c"', '"∞ bar"', '"../../x"', "0x7fffffffffffffff", "1e5000", '"ambient"', "[nan, nan]"),
)


def circuit(path: Path) -> None:
    from poppet.circuit.file import load

    load(path)


def fit(path: Path) -> None:
    from poppet.identify.fit.file import read_fit_file

    read_fit_file(path)


def tank(path: Path) -> None:
    from poppet.ground.toml_file import TomlFile
    from poppet.identify.tank.plan import tank_plan, tank_runs
    from poppet.identify.tank.test import test_of

    file = TomlFile.read(path, "recordings")
    with file.mistakes():
        test = test_of(file)
        tank_plan(test, tank_runs(test))


def flow(path: Path) -> None:
    from poppet.identify.flow.file import read_flow_file

    read_flow_file(path)


def characteristic(path: Path) -> None:
    from poppet.identify.characteristic.file import read_characteristic_file

    read_characteristic_file(path)


def recordings(path: Path) -> None:
    from poppet.bench.iso10094.recorded import recorded
    from poppet.ground.toml_file import TomlFile

    file = TomlFile.read(path, "recordings")
    with file.mistakes():
        recorded(file.content, path)


def table(path: Path) -> None:
    from poppet.series.tables.reading import read_table

    read_table(path)


KINDS: dict[str, tuple[Callable[[Path], None], tuple[str, ...]]] = {
    "circuit": (circuit, ("fill_staircase.toml", "pressure_regulator.toml", "pressure_control_scheduled.toml")),
    "fit": (fit, ("identify/fit.toml",)),
    "tank": (tank, ("identify/tank.toml",)),
    "flow": (flow, ("identify/flow.toml",)),
    "characteristic": (characteristic, ("identify/characteristic.toml",)),
    "recordings": (recordings, ("bench/recordings.toml",)),
    "csv": (table, ("identify/discharge.csv", "identify/flow_points.csv")),
}


def mutated(text: str, generator: np.random.Generator) -> str:
    """One to three things wrong, as hands, editors, disks and machines make them."""
    for _ in range(int(generator.integers(1, 4))):
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
                lines = [
                    text[:place]
                    + chr(int(generator.choice([0, 9, 10, 13, 27, 34, 44, 91, 0x2028, 0xFEFF, 0x4E2D])))
                    + text[place:]
                ]
            case 7:
                lines = [text[:place] + text[place + int(generator.integers(1, 30)) :]]
            case 8:
                other = int(generator.integers(len(lines)))
                lines[k], lines[other] = lines[other], lines[k]
            case _:
                word = lines[k].partition("=")[0].strip(' []"')
                lines[k] = lines[k].replace(word, f"{word}_", 1) if word else ""
        text = "\n".join(lines)
    return text


@pytest.mark.parametrize("count", [100, pytest.param(2000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", KINDS)
def test_a_mutated_file_is_read_or_refused(kind: str, count: int, tmp_path: Path) -> None:
    read, names = KINDS[kind]
    shutil.copytree(EXAMPLES, tmp_path / "examples")
    generator = np.random.default_rng([count, len(kind)])
    read_well = 0
    for k in range(count):
        name = names[k % len(names)]
        path = tmp_path / "examples" / name
        text = mutated((EXAMPLES / name).read_text(encoding="utf-8"), generator)
        path.write_text(text, encoding="utf-8", newline="")
        begin = time.perf_counter()
        try:
            read(path)
            read_well += 1
        except PoppetError as error:
            refused = str(error)
        except Exception as error:
            raise AssertionError(f"{kind}, number {k}:\n{text}") from error
        else:
            refused = "nothing"
        assert refused
        assert time.perf_counter() - begin < LONGEST
    # Mutations that are all harmless, or all fatal, would prove nothing.
    assert 0.02 * count < read_well < 0.98 * count
