"""One thread of linear algebra: the systems are small, and threads of several workers only wait for each other. Costly
tests are marked."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

# Before NumPy is imported: OpenBLAS and its kin read these once. A worker of pytest-xdist inherits them.
for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")

if "POPPET_GOLDEN" in os.environ:  # `make golden HARVEST=1` keeps the facts of what is said
    import importlib.util

    spec = importlib.util.spec_from_file_location("golden", Path(__file__).parents[1] / "tools" / "golden.py")
    golden = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(golden)
    golden.watch(Path(os.environ["POPPET_GOLDEN"]))


COSTLY = frozenset(Path(__file__).with_name("costly.txt").read_text(encoding="utf-8").split())
"""Tests that take a second and more on the server on which they were timed."""


@pytest.fixture(scope="session")
def site(tmp_path_factory):
    """Folder of the pages of the website."""
    pytest.importorskip("sphinx", reason="the site is built where the extra `docs` is installed")
    from website_files import built_site

    return built_site(tmp_path_factory.getbasetemp())


@pytest.hookimpl(tryfirst=True)  # before -m chooses
def pytest_collection_modifyitems(items):
    for item in items:
        if item.nodeid.partition("[")[0] in COSTLY:
            item.add_marker("costly")
