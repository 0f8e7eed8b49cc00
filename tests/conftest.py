"""One thread of linear algebra: the systems are small, and threads of several workers only wait for each other."""

from __future__ import annotations

import os

# Before NumPy is imported: OpenBLAS and its kin read these once. A worker of pytest-xdist inherits them.
for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")

if "POPPET_GOLDEN" in os.environ:  # `make golden HARVEST=1` keeps the facts of what is said
    import importlib.util
    from pathlib import Path

    spec = importlib.util.spec_from_file_location("golden", Path(__file__).parents[1] / "tools" / "golden.py")
    golden = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(golden)
    golden.watch(Path(os.environ["POPPET_GOLDEN"]))
