"""The program of a controller as a function block of structured text (IEC 61131-3)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from poppet.core.errors import InputError, collect
from poppet.core.version import __version__
from poppet.deploy.controller import SIGNATURES, ControllerProgram, controller_program
from poppet.deploy.export_files import identifier, plain
from poppet.engine.printers.instructions import instructions
from poppet.engine.printers.st import FUNCTIONS, Statements, UnsupportedOperationError, literal
from poppet.parts.part import NEVER
from poppet.timeseries.signals import SampledSignal

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

LONGEST_NAME = 32
"""Characters of a name; some controllers look at no more."""
MOST_ROUNDS = 1000
"""Instants that one call may make up for."""
OWN = ("cycle_time", "restart", "overrun", "started", "calls", "now", "due", "never", "rounds", *FUNCTIONS)
"""Names of the block beside those of the program."""
# Keywords, types, standard functions and blocks that `identifier` does not know.
_RESERVED = frozenset(
    """
    acos action any_int any_num any_real asin array atan atan2 begin bool by byte case char concat configuration
    continue cos ct ctd ctu ctud date date_and_time delete dt dword else elsif en end_action end_case end_for
    end_function end_function_block end_if end_program end_repeat end_struct end_type end_var end_while eno eq exit expt
    f_trig find ge gt insert ld le left len lt mid move mux n ne non_retain not null of on pt q q1 r r1 r_edge r_trig
    read_write replace resource retain return right rs rtc s s1 sema sr st string task tod tof ton tp trunc var_access
    var_external var_global var_in_out var_input var_output var_temp with word wstring xor lword lint ulint et in in1
    in2 cv pv cu cd abstract class extends final implements interface internal method namespace overlap override
    private protected public ref ref_to super this using pointer property reference bit adr sizeof
    derivative hysteresis integral pid ramp rtc sema stack_int command_monitor
    """.split()  # noqa: SIM905 - as a list of strings nobody could read it
)


@dataclass
class Names:
    """Names of a block: valid, of at most 32 characters, and different also where case does not count."""

    taken: set[str] = field(default_factory=lambda: {name.lower() for name in OWN})

    def name(self, text: str) -> str:
        """A new name made of a text.

        Parameters
        ----------
        text : str
            Anything.

        Returns
        -------
        str

        Examples
        --------
        >>> names = Names()
        >>> [names.name(each) for each in ("outer.gain", "Outer gain", "end_if", "v1", "x" * 40)]
        ['outer_gain', 'Outer_gain_2', 'end_if_1', 'v1_1', 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx']
        """
        # No underline at the end, and no two of them: the standard has no such names.
        own = identifier(text).strip("_")[:LONGEST_NAME].strip("_")
        # `v1` and `fired_1` are variables of the block.
        if own.lower() in _RESERVED or identifier(own) != own or re.fullmatch(r"(?i)v\d+|fired_\d+", own):
            own = f"{own[: LONGEST_NAME - 2].strip('_')}_1"
        found, count = own, 1
        while found.lower() in self.taken:
            count += 1
            tail = f"_{count}"
            found = own[: LONGEST_NAME - len(tail)].strip("_") + tail
        self.taken.add(found.lower())
        return found


def block_of(circuit: Circuit, parts: Sequence[str] = ()) -> str:
    """Sampled controllers of a circuit as a function block.

    Parameters
    ----------
    circuit : Circuit
    parts : sequence of str, optional
        Names of controllers; default the only one.

    Returns
    -------
    str

    Raises
    ------
    InputErrors
        For what is no sampled controller, and an input that follows a measured series: a block has none to follow.
    """
    program = controller_program(circuit, parts)
    driven = [i.address for i in program.inputs if isinstance(circuit.signals.get(i.address), SampledSignal)]
    collect([InputError("deploy.file_in_block", each) for each in driven])
    return function_block(program)


def function_block(program: ControllerProgram) -> str:
    """The text of a function block, with the functions that it calls.

    Parameters
    ----------
    program : ControllerProgram
        Of one or several controllers.

    Returns
    -------
    str
        ASCII.

    Raises
    ------
    InputError
        If something in it cannot be said in structured text.
    """
    names = Names()
    block = names.name(f"FB_{program.name}")
    local = _local(program)
    inputs = [names.name(local(each.address)) for each in program.inputs]
    outputs = [names.name(local(each.address)) for each in program.outputs]
    numbers = [names.name(local(each.address)) for each in program.numbers]
    shown = {each.address for each in program.outputs} | {each.address for each in program.inputs}
    memory = [names.name(f"{'held ' * (each.address in shown)}{local(each.address)}") for each in program.memory]
    fired = [f"fired_{k + 1}" for k in range(program.n_timers)]
    vectors = {"t": ["now"], "u": inputs, "p": numbers, "z": memory, "fired": fired}
    printed: dict[str, Statements] = {}
    count = 0
    for name, signature in SIGNATURES.items():
        words = signature.partition(" -> ")[0].split()
        found = outputs if name == "outputs" else memory
        given = [vectors[word] for word in words]
        statements = Statements(given, [found], count + 1, frozenset(fired), {NEVER: "never"})
        try:
            statements.read(instructions(program.functions[name]))
        except UnsupportedOperationError as problem:
            raise InputError("deploy.no_structured_text", program.parts[0], what=str(problem)) from problem
        printed[name], count = statements, statements.count
    body = _body(printed, memory[: program.n_timers], fired)
    text = "\n".join(
        [*_head(program, block), *_declared(program, vectors, outputs, printed), *body, "END_FUNCTION_BLOCK", ""]
    )
    called = [own for name, own in FUNCTIONS.items() if f"{name}(" in text]
    return "\n".join([*called, text])


def _local(program: ControllerProgram) -> Callable[[str], str]:
    """From an address to a text for its name: of a program of one part without that part."""
    start = f"{program.parts[0]}." if len(program.parts) == 1 else ""
    return lambda address: address.removeprefix(start)


def _head(program: ControllerProgram, block: str) -> list[str]:
    title = [f"(* {plain(program.title)} *)"] if program.title else []
    return [
        *title,
        f"(* {plain(', '.join(program.parts))}; written by poppet {__version__}. All values are in SI units, pressures"
        " absolute. *)",
        f"(* Call it every cycle_time seconds, {program.cycle:g} s: it samples by its own count of its calls. *)",
        f"FUNCTION_BLOCK {block}",
    ]  # fmt: skip


def _row(name: str, kind: str, start: str, unit: str, *about: str) -> str:
    told = "; ".join(plain(each) for each in (unit if unit != "1" else "", *about) if each)
    return f"  {name} : {kind}{f' := {start}' if start else ''};{f' (* {told} *)' if told else ''}"


def _declared(
    program: ControllerProgram, vectors: dict[str, list[str]], outputs: list[str], printed: dict[str, Statements]
) -> list[str]:
    """The declarations."""
    fed = zip(vectors["u"], program.inputs, strict=True)
    numbers = zip(vectors["p"], program.numbers, strict=True)
    own = zip(outputs, program.outputs, strict=True)
    memory = zip(vectors["z"], program.memory, strict=True)
    variables = [pair for each in printed.values() for pair in each.variables]
    return [
        "VAR_INPUT",
        *(_row(n, "LREAL", _number(e.value), e.unit, e.address) for n, e in fed),
        _row("cycle_time", "LREAL", literal(program.cycle), "s", "time from call to call"),
        _row("restart", "BOOL", "FALSE", "", "TRUE: begin anew"),
        "  (* Numbers of the controller. *)",
        *(_row(n, "LREAL", _number(e.value), e.unit, e.meaning, e.address) for n, e in numbers),
        "END_VAR",
        "VAR_OUTPUT",
        *(_row(n, "LREAL", "", e.unit, e.address) for n, e in own),
        _row("overrun", "BOOL", "", "", "it was called too seldom, or a sample time is zero"),
        "END_VAR",
        "VAR",
        *(_row(n, "LREAL", "", e.unit, e.address) for n, e in memory),
        *(_row(name, "BOOL", "", "") for name in ("started", *vectors["fired"])),
        *(_row(name, "LREAL", "", "") for name in ("calls", "now", "due")),
        # Not the number of the house: it has more digits before the point than some compilers take.
        _row("never", "LREAL", "1.0E+30", "s", "a time that does not come"),
        _row("rounds", "INT", "", ""),
        *(_row(name, kind, "", "") for name, kind in variables),
        "END_VAR",
    ]


def _number(value: float) -> str:
    # A start value is no expression: it takes a sign, and no parentheses.
    return literal(value).strip("()")


def _body(printed: dict[str, Statements], timers: Sequence[str], fired: Sequence[str]) -> list[str]:
    """The statements of one call."""
    come = [f"{flag} := {timer} <= due;" for flag, timer in zip(fired, timers, strict=True)]
    any_one = " OR ".join(fired)
    return [
        "IF restart OR NOT started THEN",
        *_indented(printed["start"].lines),
        "  calls := 0.0;",
        "  started := TRUE;",
        "END_IF;",
        "now := calls * cycle_time;",
        "calls := calls + 1.0;",
        "(* What is closer than this is one instant. *)",
        "due := now + 1.0E-14 * now + 1.0E-15;",
        "rounds := 0;",
        *come,
        f"WHILE {f'({any_one})' if len(fired) > 1 else any_one} AND rounds < {MOST_ROUNDS} DO",
        *_indented(printed["update"].lines),
        "  rounds := rounds + 1;",
        *_indented(come),
        "END_WHILE;",
        f"overrun := rounds >= {MOST_ROUNDS};",
        *printed["outputs"].lines,
    ]


def _indented(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]
