"""`import poppet` stays light: what is heavy is imported where it is used."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import poppet
from poppet import parts
from poppet.parts import KINDS

HEAVY = ("scipy", "numba", "llvmlite", "casadi", "matplotlib", "pandas", "pyarrow", "rich", "control", "tomlkit")


def loaded_after(statement: str) -> set[str]:
    code = f"{statement}\nimport sys\nprint(' '.join(sorted(set(name.partition('.')[0] for name in sys.modules))))"
    result = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True)
    return set(result.stdout.split())


@pytest.mark.parametrize(
    "statement",
    [
        "import poppet",
        "import poppet; poppet.load, poppet.Circuit, poppet.Recording, poppet.Chamber, poppet.Run",
        "from poppet import Chamber; Chamber(volume='1 l')",
        "import poppet.cli.main",
        "import poppet.timeseries.recording_files, poppet.circuit.file, poppet.circuit.schema",
    ],
)
def test_nothing_heavy_is_loaded(statement):
    assert loaded_after(statement) & set(HEAVY) == set()


def test_import_alone_does_not_even_need_numpy():
    assert "numpy" not in loaded_after("import poppet")


def test_statistics_of_scipy_are_not_loaded_for_a_few_quantiles():
    """A second of every fit; `scipy.special` has what they are made of."""
    texts = [path.read_text(encoding="utf-8") for path in (Path(poppet.__file__).parent / "identify").rglob("*.py")]
    assert len(texts) > 30
    assert not any("scipy.stats" in text for text in texts)


def test_parts_are_loaded_with_the_circuits_that_have_them():
    circuit = "Circuit({'a': Reservoir(pressure=1e5), 'b': Orifice(from_='a', to='ambient', effective_area=1e-6)})"
    code = f"import sys; from poppet import Circuit, Orifice, Reservoir; {circuit}; print(*sys.modules)"
    found = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True)
    loaded = {name for name in found.stdout.split() if name.startswith("poppet.parts.")}
    assert "poppet.parts.flow_path" in loaded
    assert not loaded & {f"poppet.parts.{name}" for name in ("bodies", "cylinder", "muscle", "tube", "electronics")}


def test_every_kind_is_found():
    assert [part.kind for part in KINDS.values()] == [*KINDS]
    assert {part.__name__ for part in KINDS.values()} <= set(parts.__all__)
    assert all(hasattr(parts, name) for name in parts.__all__)
