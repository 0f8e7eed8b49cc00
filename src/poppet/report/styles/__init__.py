"""Style sheets of reports."""

from functools import cache
from importlib.resources import files


@cache
def stylesheet(name: str) -> str:
    """Return the style sheet of a kind of report as text."""
    return (files("poppet.report.styles") / f"{name}.css").read_text(encoding="utf-8")
