"""Priority of the machine process, in a process of its own."""

from __future__ import annotations

import subprocess
import sys

import pytest

from poppet.serve import priority

PROGRAM = """
import os, subprocess
from poppet.serve import priority
child = subprocess.Popen(["sleep", "60"])
processes = 0, child.pid
print(priority.raise_priority([child.pid]))
print(all(os.sched_getscheduler(p) & ~os.SCHED_RESET_ON_FORK == os.SCHED_RR for p in processes))
priority.lower_priority([child.pid])
print(all(os.sched_getscheduler(p) & ~os.SCHED_RESET_ON_FORK == os.SCHED_OTHER for p in processes))
child.kill()
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="schedulers of Linux")
def test_the_scheduler_has_the_stated_priority():
    name, is_real_time, is_usual = subprocess.check_output([sys.executable, "-c", PROGRAM], text=True).splitlines()
    assert (name == priority.REAL_TIME) == (is_real_time == "True")
    assert name in (priority.REAL_TIME, priority.SLICE, priority.NORMAL)
    assert is_usual == "True"


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="schedulers of Linux")
def test_without_permission_the_time_slice_is_short_if_the_system_accepts_it(monkeypatch):
    def refuse(*arguments):
        raise PermissionError

    monkeypatch.setattr(priority.os, "sched_setscheduler", refuse)
    monkeypatch.setattr(priority, "_set_slice", lambda process: True)
    assert priority.raise_priority() == priority.SLICE
    monkeypatch.setattr(priority, "_set_slice", lambda process: not process)
    assert priority.raise_priority() == priority.SLICE
    # A process for which this one waits delays it.
    assert priority.raise_priority([1]) == priority.NORMAL
