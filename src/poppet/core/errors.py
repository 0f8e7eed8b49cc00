"""Errors. Each message has three parts: the input, the reason and the hint."""

from __future__ import annotations

import difflib
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from poppet.core import message_format
from poppet.core.codes import Note, notes_of


class PoppetError(Exception):
    """Base class of all errors; `exit_code` of the command is 1 for a failed run and 2 for invalid input."""

    exit_code = 1


class InputError(PoppetError, ValueError):
    """Error of an invalid input.

    Parameters
    ----------
    code : str
        Dotted name of the error, `fields.unknown`; the templates of its text are in `core/messages/`.
    address : str, optional
        Dotted path of the parameter or part, `tank.volume`.
    file, line : str, int, optional
        Location of the input, set by the reader of the file.
    **facts
        Values and names that the text shows.
    """

    exit_code = 2
    place = ""  # prefix that `at` and `within` set; texts without the address begin with it

    def __init__(
        self,
        code: str,
        address: str | None = None,
        /,
        *,
        file: str | None = None,
        line: int | None = None,
        **facts: Any,
    ) -> None:
        self.code, self.address, self.facts, self.file, self.line = code, address, facts, file, line
        super().__init__(code, address)

    def _text(self, part: str) -> str:
        return message_format.sentence(self.code, {**self.facts, "address": self.address or ""}, part)

    @property
    def problems(self) -> tuple[InputError, ...]:
        """Single errors; a single error contains itself."""
        return (self,)

    @property
    def given(self) -> str:
        """Invalid input, as `name = value unit`."""
        text = self._text("given")
        is_named = not self.place or "address" in message_format.facts_of(self.code, "given")
        return text if is_named else f"{self.place}: {text}"

    @property
    def reason(self) -> str:
        """Reason why the input is invalid, with the limit."""
        return self._text("reason")

    @property
    def hint(self) -> str:
        """Corrective action."""
        return self._text("hint")

    @property
    def cure(self) -> str:
        """Former name of `hint`."""
        warnings.warn("InputError.cure is now called hint.", DeprecationWarning, stacklevel=2)
        return self.hint

    def __str__(self) -> str:
        line = "" if self.line is None else f":{self.line}"
        location = "" if self.file is None else f"{self.file}{line}: "
        return f"{location}{self.given} {self.reason} {self.hint}"

    # By default, an exception is restored from its `args` and would lose its facts between processes.
    def __reduce__(self) -> Any:
        return _restore, (type(self), self.__dict__)

    def at(self, address: str) -> InputError:
        """Set the address, which precedes texts that do not show it; return the error."""
        for problem in self.problems:
            problem.address = problem.place = address
        return self

    def located(self, *, address: str | None = None, file: str | None = None, line: int | None = None) -> InputError:
        """Set the locations of the errors that have none; return the error."""
        for problem in self.problems:
            problem.address = problem.address or address
            problem.file = problem.file or file
            problem.line = problem.line if problem.line is not None else line
        return self

    def within(self, owner: str) -> InputError:
        """Add the name of an owner before the addresses; return the error."""
        for problem in self.problems if owner else ():
            problem.address = f"{owner}.{problem.address}" if problem.address else owner
            problem.place = f"{owner}.{problem.place}" if problem.place else owner
        return self


class OutOfRangeError(InputError):
    """Error of a value outside the valid range of a parameter, a law or a fit."""


class UnitError(InputError):
    """Error of a unit: missing, unknown, of another quantity, or of a wrong reference (gauge, absolute, ANR)."""


class MissingDependencyError(InputError):
    """Error of an optional package that is not installed."""

    def __init__(self, package: str, purpose: str, extra: str) -> None:
        self.package, self.extra = package, extra
        super().__init__("missing.package", package=package, purpose=purpose, extra=extra)


@contextmanager
def needed(package: str, purpose: str, extra: str) -> Iterator[None]:
    """Convert a failed import of an optional package to an error that names the `extra` to install."""
    try:
        yield
    except ImportError as problem:
        raise MissingDependencyError(package, purpose, extra) from problem


class InputErrors(InputError):
    """All errors of one input, at least one; nested collections are flattened."""

    def __init__(self, problems: Iterable[InputError]) -> None:
        self._problems = tuple(single for problem in problems for single in problem.problems)
        first = self._problems[0]
        super().__init__(first.code, first.address, file=first.file, line=first.line, **first.facts)

    @property
    def problems(self) -> tuple[InputError, ...]:
        return self._problems

    def __str__(self) -> str:
        return "\n".join(str(problem) for problem in self.problems)


MAX_ERRORS = 100
"""Maximum number of reported errors; larger files of errors are not written by users."""


class _TooManyErrors(InputError):
    """Error that stops the check after the maximum number of errors."""


class ErrorCollector:
    """Context manager that collects the errors of one input and raises all of them at its end.

    Examples
    --------
    >>> valid_names = ("volume", "thermal")
    >>> with ErrorCollector() as errors:
    ...     for name in ("volum", "termal"):
    ...         errors.add("fields.unknown", name, table="part", near=NameSuggestion(name, valid_names))
    Traceback (most recent call last):
    poppet.core.errors.InputErrors: volum is not a valid field of a part. Did you mean volume?
    termal is not a valid field of a part. Did you mean thermal?
    """

    def __init__(self) -> None:
        self.collected: list[InputError] = []

    def add(self, code: str, address: str | None = None, /, **facts: Any) -> None:
        """Add an error with the arguments of `InputError`."""
        self.extend([InputError(code, address, **facts)])

    def extend(self, problems: Iterable[InputError]) -> None:
        """Add errors."""
        self.collected += (single for problem in problems for single in problem.problems)
        if len(self.collected) >= MAX_ERRORS:
            raise _TooManyErrors("input.enough", most=MAX_ERRORS)

    @contextmanager
    def collecting(self, owner: str = "") -> Iterator[None]:
        """Collect an error that is raised in a block, with `owner` before its address."""
        try:
            yield
        except _TooManyErrors:
            raise
        except InputError as error:
            self.extend([error.within(owner)])

    def __enter__(self) -> ErrorCollector:
        return self

    def __exit__(self, kind: Any, error: BaseException | None, trace: Any) -> None:
        if isinstance(error, _TooManyErrors):
            self.collected = [*self.collected[:MAX_ERRORS], error]
        elif isinstance(error, InputError):
            self.collected += error.problems
        if error is None or isinstance(error, InputError):
            collect(self.collected)


class SimulationError(PoppetError):
    """Error of a run that ended before its end.

    Parameters
    ----------
    note : Note or str
        Time and cause of the end, and a remedy.
    recording : Recording, optional
        Rows up to the end of the run.
    """

    def __init__(self, note: Note | str, recording: Any = None) -> None:
        (self.note,) = notes_of([note])
        self.recording = recording
        super().__init__(note, recording)

    def __str__(self) -> str:
        return str(self.note)


def collect(problems: Sequence[InputError]) -> None:
    """Raise all errors together, a single one as itself; do nothing if there are none."""
    if problems:
        raise (problems[0] if len(problems) == 1 else InputErrors(problems)) from None


def relocated(error: InputError, address_in_file: Callable[[str], str]) -> InputError:
    """Return an error of a parameter with the address of that parameter in another file."""
    for problem in error.problems:
        if problem.file is None:
            problem.address = address_in_file(problem.address or "")
    return error


class NameSuggestion:
    """Hint for an unknown name: the closest valid names, or all if none is close."""

    def __init__(self, name: str, valid_names: Iterable[str]) -> None:
        self.name, self.valid_names = name, sorted(set(valid_names))

    @property
    def names(self) -> list[str]:
        """Closest valid names, at most three."""
        return difflib.get_close_matches(self.name, self.valid_names, n=3, cutoff=0.6)

    def __str__(self) -> str:
        code = "near.names" if self.names else "near.all" if self.valid_names else "near.none"
        return message_format.sentence(code, {"names": self.names or self.valid_names})


def _restore(kind: type[InputError], state: dict[str, Any]) -> InputError:
    """Restore an error from another process."""
    error = kind.__new__(kind)
    error.__dict__.update(state)
    return error
