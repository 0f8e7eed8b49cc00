"""Decorator for functions that accept either data or the path of a file."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])


def or_file(read: Callable[[str | Path], tuple[Any, dict[str, Any]]]) -> Callable[[Function], Function]:
    """Return a decorator that lets a function accept a file path instead of its data.

    The function `read` reads the file and returns the data and the keyword arguments of the file. Keyword arguments of
    the call override those of the file.

    Keyword arguments override those of the file.
    """

    def opened(function: Function) -> Function:
        first = next(iter(inspect.signature(function).parameters))

        @wraps(function)
        def door(*data: Any, **keywords: Any) -> Any:
            path = data[0] if data else keywords.get(first)
            if not isinstance(path, str | Path):
                return function(*data, **keywords)
            argument_from_file, options = read(path)
            return function(**{**options, **keywords, first: argument_from_file})

        return cast(Function, door)

    return opened
