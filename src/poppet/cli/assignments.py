"""Functions that apply the options --set, --with, --select and --units.

The first two change a circuit. The other two select outputs of a recording and set their units.
"""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from poppet.core.codes import Note
from poppet.core.errors import InputError, raise_errors

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.timeseries.recording import Recording


def read_value(text: str) -> float | str:
    """Convert the text of a value to a float if it contains a number only.

    The number is then in SI units. Any other text is returned without surrounding quotes.

    Examples
    --------
    >>> read_value("0.1"), read_value('"0.1 m^3"')
    (0.1, '0.1 m^3')
    """
    text = text.strip()
    if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'":
        text = text[1:-1].strip()
    try:
        return text if "_" in text else float(text)  # Python would read 1_000
    except ValueError:
        return text


def read_assignments(
    texts: Sequence[str], option: str = "--set", example: str = 'tank.volume="0.1 m^3"'
) -> dict[str, float | str]:
    """Return the values of a repeated option such as --set ADDRESS=VALUE by address.

    A value is a float in SI units, or a text with a unit. `option` is the name of the option in errors, and `example` a
    valid argument.

    Examples
    --------
    >>> read_assignments(["tank.volume=0.1 m^3"])
    {'tank.volume': '0.1 m^3'}
    """
    values: dict[str, float | str] = {}
    problems = []
    for text in texts:
        address, equals, value = (part.strip() for part in text.partition("="))
        if not (equals and address and value):
            problems.append(InputError("cli.assignment", option=option, text=text, example=example))
        elif address in values:
            problems.append(InputError("cli.assigned_twice", address, option=option))
        else:
            values[address] = read_value(value)
    raise_errors(problems)
    return values


@contextmanager
def named_by_options(options: Mapping[str, str]) -> Iterator[None]:
    """Replace the names of Python arguments in the addresses of errors by those of options.

    `options` maps names of arguments, such as `at`, to names of options, such as `--at`.
    """
    try:
        yield
    except InputError as error:
        for problem in error.problems:
            # The address of an unknown name is this name, and can be equal to that of an argument.
            if problem.code != "names.unknown":
                problem.address = options.get(problem.address or "", problem.address)
        raise


def split_list(text: str | None) -> list[str]:
    """Return the entries of a text that are separated by commas.

    The result for None is an empty list.
    """
    return [entry.strip() for entry in (text or "").split(",") if entry.strip()]


def load_circuit(options: Namespace, path: str | None = None) -> tuple[BaseCircuit, list[Note]]:
    """Load a circuit file, and apply the options --with and --set.

    The result contains the circuit and notes on the changes.
    """
    from poppet.circuit.file import load
    from poppet.identify.parameter_file import change_circuit

    return change_circuit(load(path or options.file), read_assignments(options.values), options.result)


@dataclass(frozen=True)
class OutputSelection:
    """Outputs that the option --select names, and units that the option --units names."""

    patterns: tuple[str, ...] = ()  # names or patterns; empty for all outputs
    units: tuple[str, ...] = ()  # each for all outputs of its quantity
    unit_by_name: tuple[tuple[str, str], ...] = ()  # name or pattern, and unit

    @classmethod
    def read(cls, select: str | None, units: str | None) -> OutputSelection:
        """Read the texts of the options `--select` and `--units`."""
        from poppet.core.units import check_unit

        # `bar,mm` is valid for all outputs of a quantity, `tank.pressure=psi` for one; a list can contain both.
        entries = split_list(units)
        pairs = (entry.partition("=") for entry in entries if "=" in entry)
        unit_by_name = tuple((name.strip(), unit.strip()) for name, _, unit in pairs)
        general_units = tuple(entry for entry in entries if "=" not in entry)
        for unit in (*general_units, *(unit for _, unit in unit_by_name)):
            check_unit(unit)
        return cls(tuple(split_list(select)), general_units, unit_by_name)

    def apply(self, recording: Recording) -> Recording:
        """Return the recording with only the selected outputs, in the selected units."""
        if self.patterns:
            recording = recording.select(self.patterns)
        # Names last: they override the units of a quantity.
        if self.units:
            recording = recording.converted(self.units)
        return recording.converted(dict(self.unit_by_name)) if self.unit_by_name else recording

    def plot_units(self, recordings: Sequence[Recording]) -> dict[str, str] | tuple[str, ...] | None:
        """Return the selected units as the argument `units` of `plot_recordings`.

        The result is None if no unit is selected.
        """
        from poppet.core.units import same_dimension

        if not self.unit_by_name:
            return self.units or None
        # The plotter accepts units, or names with units: with both, every unit is assigned to names.
        unit_of = {
            name: unit
            for recording in recordings
            for name, unit in zip(recording.names, recording.units, strict=True)
            if not self.patterns or any(fnmatchcase(name, pattern) for pattern in self.patterns)
        }
        matching = {name: unit for unit in self.units for name, si in unit_of.items() if same_dimension(si, unit)}
        return matching | dict(self.unit_by_name)
