"""Priority of the machine process: the highest that the operating system permits without a change of its settings."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Sequence

NORMAL, SLICE, HIGH, REAL_TIME = "normal", "short time slice", "high", "real time"
"""Priorities, from the lowest."""
SLICE_NS = 100_000
"""Requested time slice [ns]: the scheduler of Linux 6.12 and later wakes processes with short slices earlier."""
_SCHED_SETATTR = {"x86_64": 314, "aarch64": 274}
"""Number of the system call that sets a time slice, by processor; the C library has no function for it."""
_HIGH_PRIORITY_CLASS = 0x80


def raise_priority(children: Sequence[int] = ()) -> str:
    """Raise the priority of this process, and return the priority that it has now.

    Linux permits real time to privileged processes only. The second choice is a short time slice, which needs no
    permission. On Linux, the processes with the identifiers `children`, for which this process waits, get the same
    priority.
    """
    if sys.platform == "win32":
        import ctypes

        kernel = ctypes.windll.kernel32
        return HIGH if kernel.SetPriorityClass(kernel.GetCurrentProcess(), _HIGH_PRIORITY_CLASS) else NORMAL
    if hasattr(os, "sched_setscheduler"):
        with contextlib.suppress(OSError):
            os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(1))
            for child in children:
                # Without the programs that a child starts.
                with contextlib.suppress(OSError):
                    os.sched_setscheduler(child, os.SCHED_RR | os.SCHED_RESET_ON_FORK, os.sched_param(1))
            return REAL_TIME
        if all(_set_slice(process) for process in (0, *children)):
            return SLICE
    return NORMAL


def lower_priority(children: Sequence[int] = ()) -> None:
    """Give up real time, with which a machine that is always behind would use a processor alone."""
    if hasattr(os, "sched_setscheduler"):
        for process in (0, *children):
            with contextlib.suppress(OSError):
                os.sched_setscheduler(process, os.SCHED_OTHER, os.sched_param(0))


def _set_slice(process: int) -> bool:
    """Request a short time slice, and return True if the system has accepted it."""
    import ctypes
    import platform

    call = _SCHED_SETATTR.get(platform.machine())
    if call is None or not sys.platform.startswith("linux"):
        return False
    # struct sched_attr: size, policy, flags, nice, priority, runtime, deadline, period.
    attributes = (ctypes.c_uint64 * 6)(48, 0, 0, SLICE_NS, 0, 0)
    return ctypes.CDLL(None).syscall(call, process, ctypes.byref(attributes), 0) == 0  # type: ignore[no-any-return]
