"""Error classes of the package.

Each message consists of the invalid input, the reason and the hint.
"""

from __future__ import annotations

import copyreg
import difflib
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from poppet.core import message_format
from poppet.core.codes import Note, notes_of


class PoppetError(Exception):
    """Base class of all errors of the package.

    `exit_code` is the exit status of the command: 1 for a failed run, and 2 for invalid input.
    """

    exit_code = 1


class InputError(PoppetError, ValueError):
    """Error of an invalid input, with its address and location in a file.

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
        """Errors that this object contains.

        A single error contains only itself. A collection (`InputErrors`) contains several errors.
        """
        return (self,)

    @property
    def given(self) -> str:
        """First part of the error text: the invalid input and its address."""
        text = self._text("given")
        is_named = not self.place or "address" in message_format.facts_of(self.code, "given")
        return text if is_named else f"{self.place}: {text}"

    @property
    def reason(self) -> str:
        """Second part of the error text: the reason why the input is invalid."""
        return self._text("reason")

    @property
    def hint(self) -> str:
        """Last part of the error text: the corrective action."""
        return self._text("hint")

    @property
    def cure(self) -> str:
        """Former name of the property `hint`."""
        warnings.warn("InputError.cure is now called hint.", DeprecationWarning, stacklevel=2)
        return self.hint

    def __str__(self) -> str:
        line = "" if self.line is None else f":{self.line}"
        location = "" if self.file is None else f"{self.file}{line}: "
        return f"{location}{self.given} {self.reason} {self.hint}"

    # By default, an exception is restored from its `args` and would lose its facts between processes.
    def __reduce__(self) -> tuple[Any, ...]:
        return copyreg.__newobj__, (type(self),), self.__dict__  # type: ignore[attr-defined]

    def at(self, address: str) -> InputError:
        """Set the address of the error, and return the error.

        If the text of the error does not show the address, the text begins with it.
        """
        for problem in self.problems:
            problem.address = problem.place = address
        return self

    def located(self, *, address: str | None = None, file: str | None = None, line: int | None = None) -> InputError:
        """Add address, file and line where they are missing, and return the error.

        This applies to each single error of a collection. Values that are already set are unchanged.
        """
        for problem in self.problems:
            problem.address = problem.address or address
            problem.file = problem.file or file
            problem.line = problem.line if problem.line is not None else line
        return self

    def within(self, owner: str) -> InputError:
        """Add a prefix before the address of each single error, and return the error.

        `owner` is this prefix, for example the name of a part.
        """
        for problem in self.problems if owner else ():
            problem.address = f"{owner}.{problem.address}" if problem.address else owner
            problem.place = f"{owner}.{problem.place}" if problem.place else owner
        return self


class OutOfRangeError(InputError):
    """Error of a value outside its valid range.

    The range can be that of a parameter, of a physical law or of a fit.
    """


class UnitError(InputError):
    """Error of a unit that is missing, unknown or unsuitable.

    A unit is unsuitable if it belongs to another quantity, or if it has the wrong reference (gauge, absolute, ANR).
    """


class MissingDependencyError(InputError):
    """Error of a function whose optional package is not installed."""

    def __init__(self, package: str, purpose: str, extra: str) -> None:
        self.package, self.extra = package, extra
        super().__init__("missing.package", package=package, purpose=purpose, extra=extra)


@contextmanager
def needed(package: str, purpose: str, extra: str) -> Iterator[None]:
    """Replace an ImportError in a `with` block by an error with installation advice.

    `package` is the optional package, and `purpose` describes what requires it. `extra` is the installation option of
    poppet that includes the package.
    """
    try:
        yield
    except ImportError as problem:
        raise MissingDependencyError(package, purpose, extra) from problem


class InputErrors(InputError):
    """Collection of all errors of one input.

    It contains at least one error. A collection inside another collection is replaced by its errors.
    """

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
"""Maximum number of reported errors of one input."""


class _TooManyErrors(InputError):
    """Error that ends a check after the maximum number of errors."""


class ErrorCollector:
    """Context manager that collects errors and raises them together at its end.

    Examples
    --------
    >>> valid_names = ("volume", "thermal")
    >>> with ErrorCollector() as errors:
    ...     for name in ("volum", "termal"):
    ...         errors.add("fields.unknown", name, table="part", suggestion=NameSuggestion(name, valid_names))
    Traceback (most recent call last):
    poppet.core.errors.InputErrors: volum is not a valid field of a part. Did you mean volume?
    termal is not a valid field of a part. Did you mean thermal?
    """

    def __init__(self) -> None:
        self.collected: list[InputError] = []

    def add(self, code: str, address: str | None = None, /, **facts: Any) -> None:
        """Create an `InputError` with the given arguments, and add it."""
        self.extend([InputError(code, address, **facts)])

    def extend(self, problems: Iterable[InputError]) -> None:
        """Add several errors."""
        self.collected += (single for problem in problems for single in problem.problems)
        if len(self.collected) >= MAX_ERRORS:
            raise _TooManyErrors("input.enough", most=MAX_ERRORS)

    @contextmanager
    def collecting(self, owner: str = "") -> Iterator[None]:
        """Collect an error that is raised inside a `with` block.

        The prefix `owner` is added before the address of the error.
        """
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
            raise_errors(self.collected)


class SimulationError(PoppetError):
    """Error of a run that ended before its end time.

    Parameters
    ----------
    note : Note or str
        Time and cause of the failure, and a remedy.
    recording : Recording, optional
        Results up to the end of the run.
    """

    def __init__(self, note: Note | str, recording: Any = None) -> None:
        (self.note,) = notes_of([note])
        self.recording = recording
        super().__init__(note, recording)

    def __str__(self) -> str:
        return str(self.note)


def raise_errors(problems: Sequence[InputError]) -> None:
    """Raise a single error, or one `InputErrors` that contains several errors.

    If the list is empty, the function does nothing.
    """
    if problems:
        raise (problems[0] if len(problems) == 1 else InputErrors(problems)) from None


def relocated(error: InputError, address_in_file: Callable[[str], str]) -> InputError:
    """Convert the addresses of an error to addresses in the file of the user, and return the error.

    For example, `tank.volume` becomes `recordings.fill.start.tank.volume`. The function `address_in_file` converts one
    address. Errors whose file is already set are unchanged.
    """
    for problem in error.problems:
        if problem.file is None:
            problem.address = address_in_file(problem.address or "")
    return error


class NameSuggestion:
    """Hint for an unknown name: the closest valid names.

    If no valid name is close, the hint lists all valid names.
    """

    def __init__(self, name: str, valid_names: Iterable[str]) -> None:
        self.name, self.valid_names = name, sorted(set(valid_names))

    @property
    def names(self) -> list[str]:
        """Closest valid names, at most three."""
        return difflib.get_close_matches(self.name, self.valid_names, n=3, cutoff=0.6)

    def __str__(self) -> str:
        code = "near.names" if self.names else "near.all" if self.valid_names else "near.none"
        return message_format.sentence(code, {"names": self.names or self.valid_names})
