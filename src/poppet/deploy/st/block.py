"""Export of sampled controllers as a function block of structured text (IEC 61131-3)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from poppet.core.errors import InputError, raise_errors
from poppet.core.version import __version__
from poppet.deploy.controller import controller_program, controllers_of_option, find_controllers
from poppet.deploy.controller_program import FLAGS, SIGNATURES, STATUS, ControllerProgram
from poppet.deploy.export_files import comment_text, identifier
from poppet.deploy.targets import CircuitSource, Export
from poppet.engine.printers.instructions import instructions
from poppet.engine.printers.st import FUNCTIONS, STRUCTURED_TEXT, literal
from poppet.engine.printers.statements import (
    CaseStatement,
    ResultVariable,
    Statements,
    UnsupportedOperationError,
    Value,
)
from poppet.parts.part import NEVER
from poppet.timeseries.signals import SampledSignal

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

MAX_NAME_LENGTH = 32
"""Maximum number of characters of a name; some controllers ignore further characters."""
BLOCK_NAMES = ("cycle_time", "restart", "never", *STATUS, *FLAGS, *FUNCTIONS)
"""Names of the block in addition to those of the program."""
_STATUS_MEANINGS = {
    "input_held": "an input is not valid; its last valid value is used",
    "safe": "the command is the safe command",
    "saturated": "a command is cut by a limit",
    "late": "a sample was late or is dropped, or time ran backwards",
    "parameter_held": "a parameter is not valid; the last valid parameters are used",
}
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
        >>> [names.add(text) for text in ("outer.gain", "Outer gain", "end_if", "x" * 40)]
        ['outer_gain', 'Outer_gain_2', 'end_if_1', 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx']
        """
        # The standard allows neither an underscore at the end nor two in a row.
        base = identifier(text).strip("_")[:MAX_NAME_LENGTH].strip("_")
        if base.lower() in _RESERVED or identifier(base) != base:
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

    The keyword `part` is the value of the option --part, with the names of the controllers.
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

    def local_names(addresses: Iterable[str], mark: str = "") -> list[str]:
        return [names.add(f"{mark}{address.removeprefix(prefix)}") for address in addresses]

    inputs = local_names(item.address for item in program.inputs)
    outputs = local_names(output.address for output in program.outputs)
    parameters = local_names(parameter.address for parameter in program.parameters)
    interface = {*(item.address for item in program.inputs), *(output.address for output in program.outputs)}
    states = [
        state.address
        if state.group == "flag"
        else names.add(
            f"{'held ' if state.group != 'memory' or state.address in interface else ''}"
            f"{state.address.removeprefix(prefix)}"
        )
        for state in program.states
    ]
    fired = [names.add(f"sample {name}") for name in states[: program.n_timers]]
    values = {
        "dt": [Value("cycle_time")],
        "u": [Value(name, q.address in program.flags) for name, q in zip(inputs, program.inputs, strict=True)],
        "p": [Value(name) for name in parameters],
        "z": [Value(name, state.is_flag) for name, state in zip(states, program.states, strict=True)],
        "fired": [Value(name, True) for name in fired],
        "y": [Value(name, q.address in program.output_flags) for name, q in zip(outputs, program.outputs, strict=True)],
        "status": [Value(name, True) for name in STATUS],
    }
    labels = {
        function: [(names.add(address.removeprefix(prefix)), comment_text(text)) for address, text in items.items()]
        for function, items in program.labels.items()
    }
    selections = [
        CaseStatement([ResultVariable(names.add(address.removeprefix(prefix)), is_flag)
                   for address, is_flag in zip(item.names, item.flags, strict=True)],
            [comment_text(title) for title in item.cases], {k: comment_text(title) for k, title in item.titles.items()})
        for item in program.selections
    ]  # fmt: skip
    values["chosen"] = [Value(r.name, r.is_flag) for selection in selections for r in selection.results]
    label_names = {name for items in labels.values() for name, _ in items}
    printed: dict[str, Statements] = {}
    for name in SIGNATURES:
        function, signature = program.printed(name)
        arguments, results = (side.split() for side in signature.split("->"))
        statements = Statements(
            STRUCTURED_TEXT,
            [values[argument] for argument in arguments],
            [[ResultVariable(v.text, v.is_flag) for v in values[result]] for result in results if result in values],
            # A labelled value has its name already.
            lambda text: text if text in label_names else names.add(text),
            labels=labels[name],
            constants={NEVER: "never"},
            is_in_place=True,
            selections=selections if "selection" in results else (),
        )
        try:
            statements.read(instructions(function))
        except UnsupportedOperationError as problem:
            raise InputError("deploy.no_structured_text", program.parts[0], what=str(problem)) from problem
        printed[name] = statements
    any_fired = " OR ".join(fired)
    text = "\n".join(
        [
            *([f"(* {comment_text(program.title)} *)"] if program.title else []),
            f"(* {comment_text(', '.join(program.parts))}; written by poppet {__version__}. All values are in SI units,"
            " pressures absolute. *)",
            f"(* Call it every {program.cycle:g} s, with the time since the previous call in cycle_time. *)",
            f"FUNCTION_BLOCK {block_name}",
            *_declarations(program, {key: [v.text for v in group] for key, group in values.items()}, printed),
            *printed["accept"].lines,
            "IF restart OR NOT is_started THEN",
            *_indent(printed["start"].lines),
            "  is_started := FALSE;",
            "END_IF;",
            *printed["advance"].lines,
            f"IF {any_fired} THEN",
            *_indent(printed["update"].lines),
            "END_IF;",
            *printed["outputs"].lines,
            "END_FUNCTION_BLOCK",
            "",
        ]
    )
    called_functions = [function for name, function in FUNCTIONS.items() if f"{name}(" in text]
    return "\n".join([*called_functions, text])


def _declaration(name: str, kind: str, start: str, unit: str, *texts: str) -> str:
    """Return the declaration of one variable in structured text, with a comment.

    `kind` is its type and `start` its start value. The comment contains the unit and all further arguments.
    """
    comment = "; ".join(comment_text(text) for text in (unit if unit != "1" else "", *texts) if text)
    return f"  {name} : {kind}{f' := {start}' if start else ''};{f' (* {comment} *)' if comment else ''}"


def _type_and_start(quantity: Any) -> tuple[str, str]:
    """Return type and start value of a variable for an input or an element of the state."""
    if quantity.is_flag:
        return "BOOL", "TRUE" if quantity.value > 0.5 else "FALSE"
    # A start value is no expression: it accepts a sign, but no parentheses.
    return "LREAL", literal(quantity.value).strip("()")


def _declarations(
    program: ControllerProgram, names: Mapping[str, list[str]], printed: Mapping[str, Statements]
) -> list[str]:
    """Return the declarations of all variables of a function block.

    `names` maps quantities to names, and `printed` contains the printed functions.
    """

    inputs = zip(names["u"], [state for state in program.states if state.group == "in"], strict=True)
    parameters = zip(names["p"], program.parameters, strict=True)
    return [
        "VAR_INPUT",
        *(_declaration(name, *_type_and_start(q), q.unit, q.address) for name, q in inputs),
        _declaration("cycle_time", "LREAL", literal(program.cycle), "s", "time since the previous call"),
        _declaration("restart", "BOOL", "FALSE", "", "TRUE: start again"),
        "  (* Parameters of the controller. *)",
        *(
            _declaration(name, "LREAL", literal(q.value).strip("()"), q.unit, q.meaning, q.address)
            for name, q in parameters
        ),
        "END_VAR",
        "VAR_OUTPUT",
        *(
            _declaration(name, STRUCTURED_TEXT.types[q.address in program.output_flags], "", q.unit, q.address)
            for name, q in zip(names["y"], program.outputs, strict=True)
        ),
        *(_declaration(name, "BOOL", "", "", meaning) for name, meaning in _STATUS_MEANINGS.items()),
        "END_VAR",
        "VAR",
        *(
            _declaration(name, *_type_and_start(state), state.unit)
            for name, state in zip(names["z"], program.states, strict=True)
        ),
        # Not `NEVER`: it has more digits before the point than some compilers accept.
        _declaration("never", "LREAL", "1.0E+30", "s", "time of an inactive timer"),
        "END_VAR",
        "VAR_TEMP",
        *(_declaration(name, "BOOL", "", "") for name in names["fired"]),
        *(
            _declaration(name, STRUCTURED_TEXT.types[is_flag], "", "")
            for statements in printed.values()
            for name, is_flag in statements.variables
        ),
        "END_VAR",
    ]


def _indent(lines: Iterable[str]) -> list[str]:
    return [f"  {line}" for line in lines]
