"""One family of errors. Every message has three parts in order: what was given, why it cannot be, what to do."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable, Sequence
from typing import Any


class PoppetError(Exception):
    """Root of the family. `exit_code` is what the command line returns: 1 a run failed, 2 the input is wrong."""

    exit_code = 1


class InputError(PoppetError, ValueError):
    """Something given cannot be used.

    Parameters
    ----------
    given : str
        What was given, as `name = value unit`.
    reason : str
        Why it cannot be: the limit and where it comes from.
    cure : str
        What to do instead.
    address : str, optional
        Dotted path of the number or part, `tank.volume`.
    file, line : str, int, optional
        Where it stands, filled in by whoever read the file.
    """

    exit_code = 2

    def __init__(
        self,
        given: str,
        reason: str,
        cure: str,
        *,
        address: str | None = None,
        file: str | None = None,
        line: int | None = None,
    ) -> None:
        self.given, self.reason, self.cure = given, reason, cure
        self.address, self.file, self.line = address, file, line
        super().__init__(given, reason, cure)

    def __str__(self) -> str:
        where = ""
        if self.file is not None:
            where = f"{self.file}:{self.line}: " if self.line is not None else f"{self.file}: "
        return f"{where}{self.given} {self.reason} {self.cure}"

    def located(self, *, address: str | None = None, file: str | None = None, line: int | None = None) -> InputError:
        """Fill in where the mistake stands, keeping what is already known; returns itself."""
        self.address = self.address or address
        self.file = self.file or file
        self.line = self.line if self.line is not None else line
        return self


class OutOfRangeError(InputError):
    """A value outside the range in which a number, a law or a fit holds."""


class UnitError(InputError):
    """A unit that is missing, unknown, of another quantity, or of the wrong reference (gauge, absolute, ANR)."""


class MissingDependencyError(InputError):
    """An optional package is needed for what was asked and is not installed."""

    def __init__(self, package: str, purpose: str, extra: str) -> None:
        self.package, self.extra = package, extra
        super().__init__(
            f"{purpose} needs the package {package},",
            "which is not installed.",
            f'Install it with: pip install "poppet[{extra}]".',
        )


class InputErrors(InputError):
    """All mistakes of one input at once.

    Parameters
    ----------
    problems : sequence of InputError
        At least one; nested collections are flattened.
    """

    def __init__(self, problems: Sequence[InputError]) -> None:
        self.problems: tuple[InputError, ...]
        flat: list[InputError] = []
        for problem in problems:
            flat.extend(problem.problems if isinstance(problem, InputErrors) else [problem])
        self.problems = tuple(flat)
        first = self.problems[0]
        super().__init__(first.given, first.reason, first.cure, address=first.address, file=first.file, line=first.line)

    def __str__(self) -> str:
        return "\n".join(str(problem) for problem in self.problems)

    def located(self, *, address: str | None = None, file: str | None = None, line: int | None = None) -> InputError:
        for problem in self.problems:
            problem.located(address=address, file=file, line=line)
        return self


class SimulationError(PoppetError):
    """A run ended before its time.

    Parameters
    ----------
    message : str
        Where it ended, why, and what to try.
    recording : object, optional
        The partial `Recording`, so that nothing is lost.
    """

    def __init__(self, message: str, recording: Any = None) -> None:
        self.recording = recording
        super().__init__(message)


def collect(problems: Sequence[InputError]) -> None:
    """Raise all problems at once; do nothing when there is none. A single one is raised as itself."""
    if len(problems) == 1:
        raise problems[0]
    if problems:
        raise InputErrors(problems)


def relocated(error: InputError, place: Callable[[str], str]) -> InputError:
    """A mistake in a number of a circuit, at the place of another file where that number was given.

    Parameters
    ----------
    error : InputError
        One mistake or several.
    place : callable
        Makes the address in that file of the one in the circuit.

    Returns
    -------
    InputError
        The same; mistakes that stand in a file already are left alone.
    """
    for problem in getattr(error, "problems", (error,)):
        if problem.file is None:
            problem.address = place(problem.address or problem.given.partition(" = ")[0])
    return error


def suggestion(name: str, known: Iterable[str]) -> str:
    """A cure that names the nearest known name, or all of them when none is near."""
    options = sorted(set(known))
    near = difflib.get_close_matches(name, options, n=3, cutoff=0.6)
    if near:
        return f"Did you mean {' or '.join(near)}?"
    if not options:
        return "Remove it."
    return f"Use one of: {', '.join(options)}."


def prefixed(error: InputError, prefix: str) -> InputError:
    """An error with the owner's name put before the addresses of its mistakes."""
    for problem in getattr(error, "problems", (error,)):
        if problem.address and not problem.address.startswith(prefix):
            if problem.given.startswith(problem.address):
                problem.given = prefix + problem.given
            problem.address = prefix + problem.address
    return error
