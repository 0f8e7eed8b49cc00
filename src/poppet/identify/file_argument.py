"""One door for data and for files that name them."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])


def or_file(read: Callable[[str | Path], tuple[Any, dict[str, Any]]]) -> Callable[[Function], Function]:
    """Let a function of data and keywords take the path of a file with both; what is given goes before the file's."""

    def opened(function: Function) -> Function:
        first = next(iter(inspect.signature(function).parameters))

        @wraps(function)
        def door(*data: Any, **given: Any) -> Any:
            path = data[0] if data else given.get(first)
            if not isinstance(path, str | Path):
                return function(*data, **given)
            found, told = read(path)
            return function(**{**told, **given, first: found})

        return cast(Function, door)

    return opened
