"""One family of errors. Every message has three parts in order: what was given, why it cannot be, what to do."""

from __future__ import annotations

import difflib
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from poppet.core.codes import Note, notes_of


class PoppetError(Exception):
    """Root of the family. `exit_code` is what the command line returns: 1 a run failed, 2 the input is wrong."""

    exit_code = 1


class InputError(PoppetError, ValueError):
    """Something given cannot be used.

    Parameters
    ----------
    code : str
        Dotted name of the mistake, `units.unknown`; what was given, why it cannot be and what to do instead stand
        in `core/messages/`.
    address : str, optional
        Dotted path of the number or part, `tank.volume`.
    file, line : str, int, optional
        Where it stands, filled in by whoever read the file.
    **facts
        Numbers and names that the words show.
    """

    exit_code = 2
    place = ""  # what `at` and `within` have put before the address; words that do not show it begin with this

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

    def _words(self, part: str) -> str:
        from poppet.core.message_format import sentence

        return sentence(self.code, {**self.facts, "address": self.address or ""}, part)

    @property
    def problems(self) -> tuple[InputError, ...]:
        """All mistakes that it holds: itself, where it is one."""
        return (self,)

    @property
    def given(self) -> str:
        """What was given, as `name = value unit`."""
        from poppet.core.message_format import facts_of

        words = self._words("given")
        is_named = not self.place or "address" in facts_of(self.code, "given")
        return words if is_named else f"{self.place}: {words}"

    @property
    def reason(self) -> str:
        """Why it cannot be: the limit and where it comes from."""
        return self._words("reason")

    @property
    def hint(self) -> str:
        """What to do instead."""
        return self._words("hint")

    @property
    def cure(self) -> str:
        """Former name of `hint`."""
        warnings.warn("InputError.cure is now called hint.", DeprecationWarning, stacklevel=2)
        return self.hint

    def __str__(self) -> str:
        where = ""
        if self.file is not None:
            where = f"{self.file}:{self.line}: " if self.line is not None else f"{self.file}: "
        return f"{where}{self.given} {self.reason} {self.hint}"

    # Of itself, an exception is made again from its `args`, and would lose its facts on the way to another process.
    def __reduce__(self) -> Any:
        return _again, (type(self), self.__dict__)

    def at(self, address: str) -> InputError:
        """The same at another address, which is shown before words that name none; returns itself."""
        for problem in self.problems:
            problem.address = problem.place = address
        return self

    def located(self, *, address: str | None = None, file: str | None = None, line: int | None = None) -> InputError:
        """Fill in where the mistakes stand, keeping what is already known; returns itself."""
        for problem in self.problems:
            problem.address = problem.address or address
            problem.file = problem.file or file
            problem.line = problem.line if problem.line is not None else line
        return self

    def within(self, owner: str) -> InputError:
        """Put the name of what the mistakes are in before their addresses; returns itself."""
        for problem in self.problems if owner else ():
            problem.address = f"{owner}.{problem.address}" if problem.address else owner
            problem.place = f"{owner}.{problem.place}" if problem.place else owner
        return self


class OutOfRangeError(InputError):
    """A value outside the range in which a number, a law or a fit holds."""


class UnitError(InputError):
    """A unit that is missing, unknown, of another quantity, or of the wrong reference (gauge, absolute, ANR)."""


class MissingDependencyError(InputError):
    """An optional package is needed for what was asked and is not installed."""

    def __init__(self, package: str, purpose: str, extra: str) -> None:
        self.package, self.extra = package, extra
        super().__init__("missing.package", package=package, purpose=purpose, extra=extra)


@contextmanager
def needed(package: str, purpose: str, extra: str) -> Iterator[None]:
    """Around the import of a package that not everybody has; `extra` of the house installs it."""
    try:
        yield
    except ImportError as problem:
        raise MissingDependencyError(package, purpose, extra) from problem


class InputErrors(InputError):
    """All mistakes of one input at once, at least one; nested collections are flattened."""

    def __init__(self, problems: Iterable[InputError]) -> None:
        self._problems = tuple(single for problem in problems for single in problem.problems)
        first = self._problems[0]
        super().__init__(first.code, first.address, file=first.file, line=first.line, **first.facts)

    @property
    def problems(self) -> tuple[InputError, ...]:
        return self._problems

    def __str__(self) -> str:
        return "\n".join(str(problem) for problem in self.problems)


MOST_MISTAKES = 100
"""Nobody reads more at once, and a file of a hundred thousand mistakes is not one that somebody wrote."""


class _Enough(InputError):
    """There are as many mistakes as will be told."""


class ErrorCollector:
    """Gathers the mistakes of one input, and raises all of them where its block ends.

    Examples
    --------
    >>> known = ("volume", "thermal")
    >>> with ErrorCollector() as errors:
    ...     for name in ("volum", "termal"):
    ...         errors.add("fields.unknown", name, table="part", near=NameSuggestion(name, known))
    Traceback (most recent call last):
    poppet.core.errors.InputErrors: volum is not a valid field of a part. Did you mean volume?
    termal is not a valid field of a part. Did you mean thermal?
    """

    def __init__(self) -> None:
        self.collected: list[InputError] = []

    def add(self, code: str, address: str | None = None, /, **facts: Any) -> None:
        """A mistake as `InputError` takes it."""
        self.extend([InputError(code, address, **facts)])

    def extend(self, problems: Iterable[InputError]) -> None:
        """Mistakes that others have found."""
        self.collected += (single for problem in problems for single in problem.problems)
        if len(self.collected) >= MOST_MISTAKES:
            raise _Enough("input.enough", most=MOST_MISTAKES)

    @contextmanager
    def collecting(self, owner: str = "") -> Iterator[None]:
        """Go on behind a block in which a mistake was raised; `owner` is put before its address."""
        try:
            yield
        except _Enough:
            raise
        except InputError as error:
            self.extend([error.within(owner)])

    def __enter__(self) -> ErrorCollector:
        return self

    def __exit__(self, kind: Any, error: BaseException | None, trace: Any) -> None:
        if isinstance(error, _Enough):
            self.collected = [*self.collected[:MOST_MISTAKES], error]
        elif isinstance(error, InputError):
            self.collected += error.problems
        if error is None or isinstance(error, InputError):
            collect(self.collected)


class SimulationError(PoppetError):
    """A run ended before its time.

    Parameters
    ----------
    note : Note or str
        Where it ended, why, and what to try.
    recording : Recording, optional
        What it has so far, so that nothing is lost.
    """

    def __init__(self, note: Note | str, recording: Any = None) -> None:
        (self.note,) = notes_of([note])
        self.recording = recording
        super().__init__(note, recording)

    def __str__(self) -> str:
        return str(self.note)


def collect(problems: Sequence[InputError]) -> None:
    """Raise all problems at once; do nothing when there is none. A single one is raised as itself."""
    if problems:
        raise (problems[0] if len(problems) == 1 else InputErrors(problems)) from None


def relocated(error: InputError, place: Callable[[str], str]) -> InputError:
    """A mistake in a number of a circuit, at the place of another file where that number was given."""
    for problem in error.problems:
        if problem.file is None:
            problem.address = place(problem.address or "")
    return error


class NameSuggestion:
    """A cure for a name that is not known: the nearest known names, or all of them when none is near."""

    def __init__(self, name: str, known: Iterable[str]) -> None:
        self.name, self.known = name, sorted(set(known))

    @property
    def names(self) -> list[str]:
        """At most three known names that look alike."""
        return difflib.get_close_matches(self.name, self.known, n=3, cutoff=0.6)

    def __str__(self) -> str:
        from poppet.core.message_format import sentence

        code = "near.names" if self.names else "near.all" if self.known else "near.none"
        return sentence(code, {"names": self.names or self.known})


def _again(kind: type[InputError], state: dict[str, Any]) -> InputError:
    """A mistake that comes from another process."""
    error = kind.__new__(kind)
    error.__dict__.update(state)
    return error
