"""Export of sampled controllers as a function block of structured text (IEC 61131-3)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from poppet.core.errors import InputError, raise_errors
from poppet.core.version import __version__
from poppet.deploy.controller import (
    SIGNATURES,
    ControllerProgram,
    controller_program,
    controllers_of_option,
    find_controllers,
)
from poppet.deploy.export_files import comment_text, identifier
from poppet.deploy.targets import CircuitSource, Export
from poppet.engine.printers.instructions import instructions
from poppet.engine.printers.st import FUNCTIONS, Statements, UnsupportedOperationError, literal
from poppet.parts.part import NEVER
from poppet.timeseries.signals import SampledSignal

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

MAX_NAME_LENGTH = 32
"""Maximum number of characters of a name; some controllers ignore further characters."""
MAX_ROUNDS = 1000
"""Maximum number of sample instants in one call."""
BLOCK_NAMES = ("cycle_time", "restart", "overrun", "started", "calls", "now", "due", "never", "rounds", *FUNCTIONS)
"""Names of the block in addition to those of the program."""
# Keywords, types, standard functions and blocks in addition to those of `identifier`.
_RESERVED = frozenset(
    """
    abstract acos adr any_int any_num any_real asin atan atan2 bit cd command_monitor concat configuration cos ct ctd
    ctu ctud cu cv date_and_time derivative dt en end_action end_case end_for end_function end_function_block end_if
    end_program end_repeat end_struct end_type end_var end_while eno eq et expt extends f_trig find ge gt hysteresis in
    in1 in2 insert integral internal ld le left len lt mid move mux n ne non_retain pid pt pv q q1 r r1 r_edge r_trig
    ramp read_write ref_to resource right rs rtc s s1 sema sr st stack_int tod tof ton tp var_access var_external
    var_global var_in_out var_input var_output var_temp
    """.split()  # noqa: SIM905 - a list of strings is not readable
)


@dataclass
class BlockNames:
    """Set of variable names in a function block.

    The names are valid, have at most 32 characters, and differ even if upper and lower case are not distinguished.
    """

    used: set[str] = field(default_factory=lambda: {name.lower() for name in BLOCK_NAMES})

    def add(self, text: str) -> str:
        """Return a new valid name that resembles a text.

        Parameters
        ----------
        text : str
            Any text.

        Returns
        -------
        str

        Examples
        --------
        >>> names = BlockNames()
        >>> [names.add(text) for text in ("outer.gain", "Outer gain", "end_if", "v1", "x" * 40)]
        ['outer_gain', 'Outer_gain_2', 'end_if_1', 'v1_1', 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx']
        """
        # The standard allows neither an underscore at the end nor two in a row.
        base = identifier(text).strip("_")[:MAX_NAME_LENGTH].strip("_")
        # `v1` and `fired_1` are variables of the block.
        if base.lower() in _RESERVED or identifier(base) != base or re.fullmatch(r"(?i)v\d+|fired_\d+", base):
            base = f"{base[: MAX_NAME_LENGTH - 2].strip('_')}_1"
        name, count = base, 1
        while name.lower() in self.used:
            count += 1
            suffix = f"_{count}"
            name = base[: MAX_NAME_LENGTH - len(suffix)].strip("_") + suffix
        self.used.add(name.lower())
        return name


def export_st(circuit: BaseCircuit, source: CircuitSource, *, part: str | None = None) -> Export:
    """Export sampled controllers as structured text.

    `part` is the value of the option --part, with the names of the controllers.
    """
    if not part:
        controllers = [*find_controllers(circuit)]
        raise (
            InputError("deploy.no_part_named", known=controllers)
            if controllers
            else InputError("deploy.controller.none")
        )
    return Export({"controller.st": block_of(circuit, controllers_of_option(circuit, part))})


def block_of(circuit: BaseCircuit, parts: Sequence[str] = ()) -> str:
    """Return sampled controllers of a circuit as a function block.

    Parameters
    ----------
    circuit : Circuit
        Circuit with controllers.
    parts : sequence of str, optional
        Names of the controllers (default: the only one).

    Returns
    -------
    str
        Structured text in ASCII.

    Raises
    ------
    InputErrors
        If a part is no sampled controller, or if a signal from a file drives an input: a function block cannot read it.
    """
    program = controller_program(circuit, parts)
    sampled = [i.address for i in program.inputs if isinstance(circuit.signals.get(i.address), SampledSignal)]
    raise_errors([InputError("deploy.file_in_block", address) for address in sampled])
    return function_block(program)


def function_block(program: ControllerProgram) -> str:
    """Return the structured text of a function block, with the functions that it calls.

    Parameters
    ----------
    program : ControllerProgram
        Program of one or several controllers.

    Returns
    -------
    str
        Structured text in ASCII.

    Raises
    ------
    InputError
        If structured text does not support an operation of the program.
    """
    names = BlockNames()
    block_name = names.add(f"FB_{program.name}")
    # In a program of one part, the names omit the part.
    prefix = f"{program.parts[0]}." if len(program.parts) == 1 else ""

    def local_names(quantities: Iterable[Any], mark: Callable[[str], str] = lambda address: "") -> list[str]:
        return [names.add(f"{mark(q.address)}{q.address.removeprefix(prefix)}") for q in quantities]

    inputs, outputs = local_names(program.inputs), local_names(program.outputs)
    parameters = local_names(program.parameters)
    interface = {q.address for q in program.outputs} | {q.address for q in program.inputs}
    memory = local_names(program.memory, lambda address: "held " * (address in interface))
    fired = [f"fired_{k + 1}" for k in range(program.n_timers)]
    variables = {"t": ["now"], "u": inputs, "p": parameters, "z": memory, "fired": fired}
    printed: dict[str, Statements] = {}
    count = 0
    for name, signature in SIGNATURES.items():
        arguments = [variables[argument] for argument in signature.partition(" -> ")[0].split()]
        results = outputs if name == "outputs" else memory
        statements = Statements(arguments, [results], count + 1, frozenset(fired), {NEVER: "never"})
        try:
            statements.read(instructions(program.functions[name]))
        except UnsupportedOperationError as problem:
            raise InputError("deploy.no_structured_text", program.parts[0], what=str(problem)) from problem
        printed[name], count = statements, statements.count
    text = "\n".join(
        [
            *([f"(* {comment_text(program.title)} *)"] if program.title else []),
            f"(* {comment_text(', '.join(program.parts))}; written by poppet {__version__}. All values are in SI units,"
            " pressures absolute. *)",
            f"(* Call it every cycle_time seconds, {program.cycle:g} s: it samples by its own count of its calls. *)",
            f"FUNCTION_BLOCK {block_name}",
            *_declarations(program, {**variables, "y": outputs}, printed),
            *_statements_of_call(printed, memory[: program.n_timers], fired),
            "END_FUNCTION_BLOCK",
            "",
        ]
    )
    called_functions = [function for name, function in FUNCTIONS.items() if f"{name}(" in text]
    return "\n".join([*called_functions, text])


def _declaration(name: str, kind: str, start: str, unit: str, *texts: str) -> str:
    """Return the declaration of one variable in structured text, with a comment.

    `kind` is its type and `start` its start value. The comment contains the unit and `texts`.
    """
    comment = "; ".join(comment_text(text) for text in (unit if unit != "1" else "", *texts) if text)
    return f"  {name} : {kind}{f' := {start}' if start else ''};{f' (* {comment} *)' if comment else ''}"


def _declarations(
    program: ControllerProgram, names: Mapping[str, list[str]], printed: Mapping[str, Statements]
) -> list[str]:
    """Return the declarations of all variables of a function block.

    `names` maps quantities to names, and `printed` contains the printed functions.
    """

    def start_value(quantity: Any) -> str:
        # A start value is no expression: it accepts a sign, but no parentheses.
        return literal(quantity.value).strip("()")

    inputs = zip(names["u"], program.inputs, strict=True)
    parameters = zip(names["p"], program.parameters, strict=True)
    outputs = zip(names["y"], program.outputs, strict=True)
    memory = zip(names["z"], program.memory, strict=True)
    return [
        "VAR_INPUT",
        *(_declaration(name, "LREAL", start_value(q), q.unit, q.address) for name, q in inputs),
        _declaration("cycle_time", "LREAL", literal(program.cycle), "s", "time from call to call"),
        _declaration("restart", "BOOL", "FALSE", "", "TRUE: begin anew"),
        "  (* Numbers of the controller. *)",
        *(_declaration(name, "LREAL", start_value(q), q.unit, q.meaning, q.address) for name, q in parameters),
        "END_VAR",
        "VAR_OUTPUT",
        *(_declaration(name, "LREAL", "", q.unit, q.address) for name, q in outputs),
        _declaration("overrun", "BOOL", "", "", "it was called too seldom, or a sample time is zero"),
        "END_VAR",
        "VAR",
        *(_declaration(name, "LREAL", "", q.unit, q.address) for name, q in memory),
        *(_declaration(name, "BOOL", "", "") for name in ("started", *names["fired"])),
        *(_declaration(name, "LREAL", "", "") for name in ("calls", "now", "due")),
        # Not `NEVER`: it has more digits before the point than some compilers accept.
        _declaration("never", "LREAL", "1.0E+30", "s", "a time that does not come"),
        _declaration("rounds", "INT", "", ""),
        *(_declaration(*variable, "", "") for statements in printed.values() for variable in statements.variables),
        "END_VAR",
    ]


def _statements_of_call(printed: Mapping[str, Statements], timers: Sequence[str], fired: Sequence[str]) -> list[str]:
    """Return the statements that the function block executes in each call.

    `timers` are the names of the timers, and `fired` those of the variables that show which timer is due.
    """
    expiry = [f"{flag} := {timer} <= due;" for flag, timer in zip(fired, timers, strict=True)]
    any_expired = " OR ".join(fired)
    return [
        "IF restart OR NOT started THEN",
        *_indent(printed["start"].lines),
        "  calls := 0.0;",
        "  started := TRUE;",
        "END_IF;",
        "now := calls * cycle_time;",
        "calls := calls + 1.0;",
        "(* What is closer than this is one instant. *)",
        "due := now + 1.0E-14 * now + 1.0E-15;",
        "rounds := 0;",
        *expiry,
        f"WHILE {f'({any_expired})' if len(fired) > 1 else any_expired} AND rounds < {MAX_ROUNDS} DO",
        *_indent(printed["update"].lines),
        "  rounds := rounds + 1;",
        *_indent(expiry),
        "END_WHILE;",
        f"overrun := rounds >= {MAX_ROUNDS};",
        *printed["outputs"].lines,
    ]


def _indent(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]
