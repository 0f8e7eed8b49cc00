"""Rules of MISRA C:2012 that exported controllers violate according to cppcheck, compared with docs/export_c.md."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from circuits_of_exports import CONTROLLERS, EXAMPLES
from poppet import load
from poppet.deploy.c.controller import c_controller

PAGE = Path(__file__).parents[3] / "docs" / "export_c.md"
CPPCHECK = shutil.which("cppcheck")


def violated_rules(files, folder):
    """Return the rules that cppcheck reports for the controller."""
    for name, text in files.items():
        (folder / name).write_text(text)
    command = [CPPCHECK, "-q", "--addon=misra", "--std=c99", "--enable=style", "ctl.c"]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True, timeout=300)
    return set(re.findall(r"misra-c2012-([\d.]+)\]", run.stderr))


@pytest.mark.skipif(CPPCHECK is None, reason="cppcheck is not installed")
@pytest.mark.parametrize(
    ("name", "precision"), [("pressure_control", "single"), ("muscle_joint", "double"), ("two_cylinders", "double")]
)
def test_page_lists_the_violated_rules(name, precision, tmp_path):
    files = c_controller(load(EXAMPLES / f"{name}.toml"), CONTROLLERS[name], name="ctl", precision=precision)
    listed = set(re.findall(r"^\| (\d+\.\d+) \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE))
    rules = violated_rules(files, tmp_path)
    assert "8.7" in rules
    assert rules <= listed
    # A rule that the code does not violate is found if it does.
    files["ctl.c"] = files["ctl.c"].replace("int k;", "int k; if (dt > 100.0) return 0u;")
    assert "15.5" in violated_rules(files, tmp_path)
