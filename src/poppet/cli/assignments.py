"""`ADDRESS=VALUE` and lists of units as a command line gives them."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from poppet.core.codes import Note
from poppet.core.errors import InputError, collect

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.timeseries.recording import Recording


def value(text: str) -> float | str:
    """A value: a bare number is SI, anything else stays text; quotes around it are stripped.

    Examples
    --------
    >>> value("0.1"), value('"0.1 m^3"')
    (0.1, '0.1 m^3')
    """
    text = text.strip()
    if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'":
        text = text[1:-1].strip()
    try:
        return text if "_" in text else float(text)  # Python would read 1_000
    except ValueError:
        return text


def assignments(texts: Sequence[str], option: str = "--set") -> dict[str, float | str]:
    """Addresses and values of a repeated option.

    Examples
    --------
    >>> assignments(["tank.volume=0.1 m^3"])
    {'tank.volume': '0.1 m^3'}
    """
    result, problems = {}, []
    for text in texts:
        address, equals, given = (part.strip() for part in text.partition("="))
        if not (equals and address and given):
            problems.append(InputError("cli.assignment", option=option, text=text))
        elif address in result:
            problems.append(InputError("cli.assigned_twice", option=option, address=address))
        else:
            result[address] = value(given)
    collect(problems)
    return result


def listed(text: str | None) -> list[str]:
    """The members of a list with commas."""
    return [entry.strip() for entry in (text or "").split(",") if entry.strip()]


def changed(circuit: Circuit, values: dict[str, float | str]) -> tuple[Circuit, list[Note]]:
    """A circuit with other numbers, and what a reader has to know about the change."""
    from dataclasses import replace

    if not values:
        return circuit, []
    circuit = circuit.with_values(values)
    dropped = [address for address in values if address in circuit.signals]
    # A number that is the default of an input would change nothing while a signal drives it.
    if dropped:
        circuit = replace(circuit, signals={k: v for k, v in circuit.signals.items() if k not in dropped})
    return circuit, [Note("cli.signal_left_out", address, value=values[address]) for address in dropped]


def loaded(options: Namespace, path: str | None = None) -> tuple[Circuit, list[Note]]:
    """A circuit file, that of the command unless told, with what `--with` and `--set` change, and notes about that."""
    from poppet.circuit.file import load

    circuit, notes = with_result(load(path or options.file), options.result)
    circuit, about = changed(circuit, assignments(options.values))
    return circuit, notes + about


def with_result(circuit: Circuit, path: str | None) -> tuple[Circuit, list[Note]]:
    """A circuit with the numbers of `--with`, and which of them are not to be trusted."""
    if path is None:
        return circuit, []
    from poppet.identify.parameter_file import with_numbers

    circuit, doubtful = with_numbers(circuit, path)
    return circuit, [Note("cli.not_trusted", file=path, names=doubtful)] if doubtful else []


@dataclass(frozen=True)
class Shape:
    """Which series of a recording are wanted, in which units."""

    patterns: tuple[str, ...] = ()  # names or patterns; none for all
    units: tuple[str, ...] = ()  # each for all series of its quantity
    named: tuple[tuple[str, str], ...] = ()  # name or pattern, and unit

    @classmethod
    def read(cls, select: str | None, units: str | None) -> Shape:
        """Read the options `--select` and `--units`."""
        from poppet.core.units import check_unit

        # `bar,mm` holds for all series of a quantity, `tank.pressure=psi` for one; both may stand in one list.
        entries = listed(units)
        named = tuple((name.strip(), unit.strip()) for name, _, unit in (e.partition("=") for e in entries if "=" in e))
        plain = tuple(entry for entry in entries if "=" not in entry)
        for unit in (*plain, *(unit for _, unit in named)):
            check_unit(unit)
        return cls(tuple(listed(select)), plain, named)

    def apply(self, recording: Recording) -> Recording:
        """The wanted series in the wanted units."""
        if self.patterns:
            recording = recording.select(self.patterns)
        # Names last: they go before the units that hold for a whole quantity.
        if self.units:
            recording = recording.converted(self.units)
        return recording.converted(dict(self.named)) if self.named else recording

    def plot_units(self, recordings: Sequence[Recording]) -> dict[str, str] | tuple[str, ...] | None:
        """The units as `poppet.timeseries.plotting.plots.plot_recordings` takes them."""
        from poppet.core.units import same_dimension

        if not self.named:
            return self.units or None
        # The plotter takes either, units or names with units: with both, units are spelled out by name.
        series = {
            name: unit
            for each in recordings
            for name, unit in zip(each.names, each.units, strict=True)
            if not self.patterns or any(fnmatchcase(name, pattern) for pattern in self.patterns)
        }
        fitting = {name: unit for unit in self.units for name, known in series.items() if same_dimension(known, unit)}
        return fitting | dict(self.named)
