"""`import poppet` stays light: what is heavy is imported where it is used."""

from __future__ import annotations

import subprocess
import sys

import pytest

HEAVY = ("scipy", "numba", "llvmlite", "casadi", "matplotlib", "pandas", "pyarrow", "rich", "control")


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
        "import poppet.series.files, poppet.circuit.file, poppet.circuit.schema",
    ],
)
def test_nothing_heavy_is_loaded(statement):
    assert loaded_after(statement) & set(HEAVY) == set()


def test_import_alone_does_not_even_need_numpy():
    assert "numpy" not in loaded_after("import poppet")
