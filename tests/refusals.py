"""Asking for what was refused by its code, its address and its numbers, never by its words."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest

from poppet.core.errors import InputError


@contextmanager
def refused(
    code: str, address: str | None = None, *, kind: type[Exception] = InputError, **facts: Any
) -> Iterator[pytest.ExceptionInfo[Any]]:
    """Like `pytest.raises`: one of the mistakes that were made has this code, this address and these facts."""
    with pytest.raises(kind) as caught:
        yield caught
    error = caught.value
    found = getattr(error, "problems", None) or [getattr(error, "note", error)]
    assert any(
        each.code == code
        and address in (None, each.address)
        and all(each.facts.get(name) == value for name, value in facts.items())
        for each in found
    ), f"{code} {address or ''} {facts or ''} is not among {[(each.code, each.address, each.facts) for each in found]}"
