"""Registries of built-in objects, which third-party packages extend by entry points.

A package declares an entry point in one of `GROUPS` and sets `POPPET_API` in the module that it names. Entry points are
read at the first listing of a registry, or at the first request for a name that is not built in.
"""

from __future__ import annotations

import importlib
import warnings
from collections import UserDict
from collections.abc import Callable, Iterator, Mapping
from typing import Any, TypeVar

from poppet.core.codes import Note

API_VERSION = 1
"""Version of the interface of plugins. The module of an entry point states it as `POPPET_API = 1`."""
GROUPS = ("poppet.parts", "poppet.library", "poppet.readers", "poppet.targets", "poppet.methods", "poppet.components")
"""Groups of entry points."""

T = TypeVar("T")


class PluginWarning(UserWarning):
    """Warning about a plugin that was ignored; `note` contains the reason.

    Parameters
    ----------
    note : Note
        Reason for ignoring it.
    """

    def __init__(self, note: Note) -> None:
        super().__init__(str(note))
        self.note = note


def import_object(value: Any) -> Any:
    """Import the object to which a text of the form `package.module:name` refers.

    Any other value is returned unchanged.
    """
    if not isinstance(value, str) or not value:
        return value
    module, _, name = value.partition(":")
    return getattr(importlib.import_module(module), name)


class Registry(UserDict[str, T]):
    """Mapping from names to built-in objects, followed by the objects of plugins.

    Parameters
    ----------
    group : str
        Group of entry points that extend the registry.
    built_in : mapping of str
        Built-in objects. A text `package.module:name` is imported when it is requested.
    accepts : callable, optional
        Function that returns True if the name and the object of a plugin are valid. By default, all are valid.
    prefix : str, optional
        First character of every name. The names of entry points can omit it.

    Examples
    --------
    >>> readers = Registry("example.readers", {"json": "json:loads"})
    >>> readers["json"]("[1]"), "toml" in readers
    ([1], False)
    """

    def __init__(
        self,
        group: str,
        built_in: Mapping[str, T | str],
        accepts: Callable[[str, Any], bool] = lambda name, value: True,
        prefix: str = "",
    ) -> None:
        self.group, self.accepts, self.prefix = group, accepts, prefix
        self.is_extended = False
        super().__init__()
        self.data: dict[str, Any] = dict(built_in)

    def __getitem__(self, name: str) -> T:
        if name not in self:
            raise KeyError(name)
        return import_object(self.data[name])  # type: ignore[no-any-return]

    def __contains__(self, name: object) -> bool:
        if name not in self.data:
            self._extend()
        return name in self.data

    def __iter__(self) -> Iterator[str]:
        self._extend()
        return iter(self.data)

    def __len__(self) -> int:
        self._extend()
        return len(self.data)

    def _extend(self) -> None:
        """Add the objects of all plugins to the registry.

        Only the first call has an effect. A warning is issued for each plugin that is ignored.
        """
        if self.is_extended:
            return
        self.is_extended = True
        import importlib.metadata

        for entry in importlib.metadata.entry_points(group=self.group):
            name = self.prefix + entry.name.removeprefix(self.prefix)
            facts: dict[str, Any] = {"group": self.group, "package": entry.dist.name if entry.dist else entry.module}
            try:
                module: Any = importlib.import_module(entry.module)
                version = getattr(module, "POPPET_API", None)
                value = entry.load() if version == API_VERSION else None
            # Any error of a third-party module, also of its imports.
            except Exception as error:
                why = f"{type(error).__name__}: {error}"
                warnings.warn(PluginWarning(Note("plugins.failed", name, **facts, why=why)), stacklevel=3)
                continue
            if version != API_VERSION:
                note = Note("plugins.version", name, **facts, version=version, supported=API_VERSION)
            elif name in self.data:
                note = Note("plugins.duplicate", name, **facts)
            elif not self.accepts(name, value):
                note = Note("plugins.invalid", name, **facts, value=str(value))
            else:
                self.data[name] = value
                continue
            warnings.warn(PluginWarning(note), stacklevel=3)
