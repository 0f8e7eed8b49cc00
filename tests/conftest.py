"""One thread of linear algebra: the systems are small, and threads of several workers only wait for each other."""

from __future__ import annotations

import os

# Before NumPy is imported: OpenBLAS and its kin read these once. A worker of pytest-xdist inherits them.
for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")
