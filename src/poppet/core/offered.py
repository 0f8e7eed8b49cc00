"""What things below offer and rooms above do, as `Circuit.ensemble`; the front door names who does it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

_doers: dict[str, Callable[..., Any]] = {}


def done_by(name: str, doer: Callable[..., Any]) -> None:
    """Name who does it."""
    _doers[name] = doer


def done(name: str, *given: Any, **options: Any) -> Any:
    """Have it done."""
    return _doers[name](*given, **options)
