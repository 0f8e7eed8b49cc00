"""Style sheets of reports."""

from functools import cache
from importlib.resources import files


@cache
def stylesheet(name: str) -> str:
    """Return the style sheet with the given name, such as `bench`, as text."""
    return (files("poppet.report.styles") / f"{name}.css").read_text(encoding="utf-8")
