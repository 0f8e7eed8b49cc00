"""Limits of the functions for assistants, and the names of their temporary folders."""

from __future__ import annotations

PREFIX = "poppet-assist-"
"""Beginning of the names of the temporary folders of processes."""
TIME_LIMIT = 60.0
"""Default time limit of a call [s]."""
LONGEST_LIMIT = 3600.0
"""Largest time limit of a call [s]."""
PATIENCE = 5.0
"""Time after the time limit in which a simulation can return its partial result before its process is killed [s]."""
WORKERS = 2
"""Largest number of calls that run at the same time."""
WAITING = 32
"""Largest number of calls that wait for a process."""
CALLS_PER_PROCESS = 200
"""Number of calls after which a process is replaced."""
MEMORY = 8 * 2**30
"""Address space of a process [bytes]."""
LINE = 4 * 2**20
"""Largest length of a line of the protocol [bytes]."""
REPLY = 16 * 2**20
"""Largest length of a reply of a process [bytes]."""
TEXT = 2**20
"""Largest size of a text that is read or written [bytes]."""
FILES = 500
"""Largest number of listed files."""
VISITED = 20_000
"""Largest number of files and folders that are visited for a list."""
RUN_ROWS = 100_000
"""Largest number of output rows of a simulation."""
RUN_VALUES = 2_000_000
"""Largest number of output values of a simulation."""
SERIES_ROWS = 500
"""Largest number of rows of the series in a result."""
SERIES_VALUES = 20_000
"""Largest number of values of the series in a result."""
LIST_ROWS = 100
"""Largest number of rows of a list in a result."""
RUNS = 10_000
"""Largest number of runs of an ensemble."""
TIMES = 200
"""Largest number of requested times, values and names in an argument."""
