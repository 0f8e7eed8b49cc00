"""In notebooks of the site a command that fails stops the build; IPython alone goes on."""

from __future__ import annotations

from IPython import get_ipython

shell = get_ipython()
plain = shell.system


def checked(command: str) -> None:
    """Run a command of a `!` line, and raise where it fails."""
    plain(command)
    if status := shell.user_ns["_exit_code"]:
        raise RuntimeError(f"exit code {status}: {command}")


shell.system = checked
