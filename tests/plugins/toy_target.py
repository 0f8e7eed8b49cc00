"""An export target of a third-party package: the numbers of a circuit as text."""

from __future__ import annotations

from typing import Any

from poppet.deploy.targets import Export, Target

POPPET_API = 1


def export(circuit: Any, source: Any = None, **settings: Any) -> Export:
    """Return one line for each number."""
    lines = [f"{address} = {number.display()}" for address, number in circuit.numbers().items()]
    return Export({"numbers.txt": "\n".join(lines) + "\n"}, "numbers written.")


TARGET = Target("toy", "numbers of a circuit as text", export, suffixes=(".txt",))
