"""Export of sampled controllers as C for a microcontroller, to be called once per cycle."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from poppet.core.version import __version__
from poppet.deploy.c.c_model import fill_template, number_list, number_rows
from poppet.deploy.controller import controller_program
from poppet.deploy.controller_program import FLAGS, SIGNATURES, STATUS, ControllerProgram, ProgramRun
from poppet.deploy.export_files import c_string, comment_text, identifier, identifiers
from poppet.engine.model_evaluation import Array
from poppet.engine.printers.c import DOUBLE, SINGLE, Precision, statement_helpers, statement_language
from poppet.engine.printers.instructions import instructions
from poppet.engine.printers.statements import CaseStatement, ResultVariable, Statements, Value
from poppet.parts.steps import BUILT_IN_INPUTS

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

N_CALLS = 100
"""Number of calls of the test vector."""
N_INVALID = 20
"""Number of these calls with an input that is not finite."""
ALLOWED = {"double": 1e-11, "single": 1e-3}
"""Allowed differences of outputs from the test vector, relative to their size."""


class Member(NamedTuple):
    """Member of a struct in C."""

    path: str  # of the member in the struct: `gain`, or `position.gain` with several controllers
    declaration: str  # type, name and comment
    is_flag: bool = False


def c_controller(
    circuit: BaseCircuit, parts: Sequence[str] = (), *, name: str = "", precision: str = "double"
) -> dict[str, str]:
    """Return the C files of one or several sampled controllers by name.

    Parameters
    ----------
    circuit : Circuit
        Circuit with controllers.
    parts : sequence of str, optional
        Names of the controllers; required if there are several.
    name : str, optional
        Prefix of all names (default: names of the controllers).
    precision : str, optional
        `double` or `single`. With `single`, the code contains no double-precision operation.

    Returns
    -------
    dict
        Header, program, a host program that checks it, and a `CMakeLists.txt`.

    Raises
    ------
    InputErrors
        If there is no such part, or the part is no sampled controller.
    """
    program = controller_program(circuit, parts)
    name = identifier(name or program.name)
    kind = SINGLE if precision == "single" else DOUBLE
    structs = _structs(program, kind)
    bodies = _function_bodies(program, structs, kind)
    title = f"{comment_text(program.title or name)}: {', '.join(map(comment_text, program.parts))}"
    helpers = statement_helpers("\n".join(bodies.values()), kind)
    initial = [("in", member, item.value) for member, item in zip(structs["in"], program.inputs, strict=True)]
    parameters = zip(structs["param"], program.parameters, strict=True)
    initial += [("param", member, item.value) for member, item in parameters]
    fields = {
        "ABOUT": f"{title}, exported by poppet {__version__}",
        "NAME": name, "REAL": kind.real, "CYCLE": f"{program.cycle:g}", "CYCLE_LITERAL": kind.literal(program.cycle),
        "HELPERS": f"{helpers}\n\n" if helpers else "", "N_TIMERS": f"{program.n_timers}",
        **{group.upper(): _struct_text(structs[group]) for group in ("in", "out", "param", "memory")},
        **{function.upper(): body for function, body in bodies.items()},
        "INITIAL": "\n".join(
            f"  r->{group}.{member.path} = "
            f"{('true' if value > 0.5 else 'false') if member.is_flag else kind.literal(value)};"
            for group, member, value in initial
        ),
        **_test_vector(program, structs, kind, precision),
    }  # fmt: skip
    templates = {".h": "controller.h", ".c": "controller.c", "_host.c": "controller_host.c"}
    project = {f"{name}{ending}": fill_template(template, name, fields) for ending, template in templates.items()}
    return {**project, "CMakeLists.txt": fill_template("controller.txt", name, fields)}


def _structs(program: ControllerProgram, kind: Precision) -> dict[str, list[Member]]:
    """Return the members of the structs of a program: `in`, `out`, `param` and `memory`.

    With several controllers, inputs, outputs and parameters of each controller form a struct of their own.
    """
    structs: dict[str, list[Member]] = {}
    limits = {q.address: (q.low, q.high) for q in program.parameters}
    meanings = {q.address: q.meaning for q in program.parameters}
    groups: dict[str, list[tuple[str, str, bool]]] = {
        "in": [(q.address, q.unit, q.address in program.flags) for q in program.inputs],
        "out": [(q.address, q.unit, q.address in program.output_flags) for q in program.outputs],
        "param": [(q.address, q.unit, False) for q in program.parameters],
        "memory": [(s.address, s.unit, s.is_flag) for s in program.states if s.group == "memory"],
    }
    single = f"{program.parts[0]}."
    for group, items in groups.items():
        is_nested = len(program.parts) > 1 and group != "memory"
        owners = [identifier(address.partition(".")[0]) if is_nested else "" for address, _, _ in items]
        texts = [
            address.partition(".")[2] if owner else address.removeprefix(single) if len(program.parts) == 1 else address
            for owner, (address, _, _) in zip(owners, items, strict=True)
        ]
        names = [""] * len(items)
        for owner in set(owners):
            indices = [k for k, other in enumerate(owners) if other == owner]
            # The struct of the state has further members besides the memory.
            taken = ("in", "param", *FLAGS) if group == "memory" else ()
            for k, member_name in zip(indices, identifiers([texts[k] for k in indices], taken), strict=True):
                names[k] = member_name
        members = []
        for owner, member_name, (address, unit, is_flag) in zip(owners, names, items, strict=True):
            low, high = limits.get(address, (-np.inf, np.inf)) if group == "param" else (-np.inf, np.inf)
            bounds = f", {low:g} to {high:g}" if np.isfinite([low, high]).all() else ""
            meaning = f"{comment_text(meanings[address])} " if group == "param" else ""
            what = "0 or 1" if is_flag else f"[{comment_text(unit if unit not in ('', '1') else '-')}]{bounds}"
            text = f"{'bool' if is_flag else kind.real} {member_name}; /* {meaning}{what} */"
            members.append(Member(f"{owner}.{member_name}" if owner else member_name, text, is_flag))
        structs[group] = members
    return structs


def _struct_text(members: Sequence[Member]) -> str:
    """Return the declarations of the members of a struct; nested members form inner structs."""
    if not members:
        return "  char unused;"
    lines, inner = [], ""
    for member in sorted(members, key=lambda member: member.path.rpartition(".")[0]):
        part = member.path.rpartition(".")[0]
        if part != inner:
            lines += [f"  }} {inner};"] if inner else []
            lines += ["  struct {"] if part else []
            inner = part
        lines.append(f"{'    ' if part else '  '}{member.declaration}")
    return "\n".join([*lines, *([f"  }} {inner};"] if inner else [])])


def _function_bodies(program: ControllerProgram, structs: dict[str, list[Member]], kind: Precision) -> dict[str, str]:
    """Return the C statements of the functions of a program."""

    def values(members: Iterable[Member], owner: str) -> list[Value]:
        return [Value(f"{owner}{member.path}", member.is_flag) for member in members]

    def state(owner: str) -> list[Value]:
        flags = [Value(f"{owner}{s.address}", True) for s in program.states if s.group == "flag"]
        held = values(structs["in"], f"{owner}in."), values(structs["param"], f"{owner}param.")
        return [*values(structs["memory"], owner), *held[0], *held[1], *flags]

    arguments = {
        "dt": [Value("dt")],
        "u": values(structs["in"], "in->"),
        "p": values(structs["param"], "param->"),
        "z": state("z->"),
        "fired": [Value(f"fired[{k}]", True) for k in range(program.n_timers)],
    }
    results = {
        "z": state("next->"),
        "fired": arguments["fired"],
        "y": values(structs["out"], "out->"),
        "status": [Value(name, True) for name in STATUS],
    }
    unchanged = {new.text: old.text for new, old in zip(results["z"], arguments["z"], strict=True)}
    prefix = f"{program.parts[0]}." if len(program.parts) == 1 else ""
    bodies = {}
    for name in SIGNATURES:
        function, signature = program.printed(name)
        inputs, outputs = (side.split() for side in signature.split("->"))
        used: set[str] = {*inputs, *outputs, "z", "next", "in", "param", "out", "r"}

        def new_name(text: str, used: set[str] = used) -> str:
            candidate = base = identifier(text)
            count = 1
            while candidate.lower() in used:
                count += 1
                candidate = f"{base}_{count}"
            used.add(candidate.lower())
            return candidate

        labels = [
            (identifier(address.removeprefix(prefix)), comment_text(meaning))
            for address, meaning in program.labels[name].items()
        ]
        selections = [
            CaseStatement(
                [ResultVariable(new_name(address.removeprefix(prefix)), is_flag)
                 for address, is_flag in zip(item.names, item.flags, strict=True)],
                [comment_text(title) for title in item.cases],
                {value: comment_text(title) for value, title in item.titles.items()},
            )
            for item in (program.selections if "selection" in outputs else ())
        ]  # fmt: skip
        arguments["chosen"] = [Value(r.name, r.is_flag) for selection in selections for r in selection.results]
        statements = Statements(
            statement_language(kind),
            [arguments[argument] for argument in inputs],
            [[ResultVariable(value.text, value.is_flag) for value in results[r]] for r in outputs if r in results],
            new_name,
            labels=labels,
            unchanged=unchanged,
            selections=selections,
        )
        statements.read(instructions(function))
        names = {"dt": "dt", "u": "in", "p": "param", "z": "z", "fired": "fired"}
        text = "\n".join(statements.lines)
        read = set(re.findall(r"(?<![\w.])(?<!->)[A-Za-z_]\w*", text))  # without the members of structs
        ignored = [
            f"  (void){names[argument]};" for argument in inputs if argument in names and names[argument] not in read
        ]
        bodies[name] = "\n".join([*ignored, *statements.lines])
    return bodies


def _test_vector(
    program: ControllerProgram, structs: dict[str, list[Member]], kind: Precision, precision: str
) -> dict[str, str]:
    """Return test calls of a controller program with the expected outputs.

    The inputs are random values of typical size; for some calls, one of them is not finite. The result maps each
    placeholder of the C template to its text.
    """
    rows = test_inputs(program)
    run: ProgramRun = program.run(rows)
    magnitudes = np.abs(run.outputs).max(axis=0)
    read = [
        f"    r.in.{member.path} = {f'row[{k}] > 0.5' if member.is_flag else f'({kind.real})row[{k}]'};"
        for k, member in enumerate(structs["in"])
    ]
    return {
        "CALLS": f"{N_CALLS}", "ALLOWED": DOUBLE.literal(ALLOWED[precision]),
        "N_IN": f"{len(program.inputs)}", "N_OUT": f"{len(program.outputs)}",
        "GIVEN": number_rows(rows).replace("(0.0 / 0.0)", "NAN"), "KNOWN": number_rows(run.outputs),
        "STATUS": ", ".join(f"{bits}u" for bits in run.status),
        "SIZES": number_list(np.where(magnitudes > 0.0, magnitudes, 1.0)),
        "NAMES": ", ".join(c_string(output.address) for output in program.outputs),
        "READ": "\n".join(read),
        "WRITE": "\n".join(f"    out[{k}] = (double)r.out.{member.path};" for k, member in enumerate(structs["out"])),
    }  # fmt: skip


def test_inputs(program: ControllerProgram) -> list[Array]:
    """Return random inputs of the test calls, of which some are not finite."""
    generator = np.random.default_rng(0)
    sizes: dict[str, float] = {}
    for item in program.inputs:
        sizes[item.unit] = max(sizes.get(item.unit, 0.0), abs(item.value))
    rows = []
    numeric = [k for k, item in enumerate(program.inputs) if item.address not in program.flags]
    for call in range(N_CALLS):
        u = np.array([item.value for item in program.inputs])
        for k, item in enumerate(program.inputs):
            if program.selections and item.address in program.flags:
                # Buttons of a sequence; a reset or an emergency is rare.
                is_rare = item.address.rpartition(".")[2] in BUILT_IN_INPUTS
                u[k] = float(generator.random() < (0.02 if is_rare else 0.5))
            # Other inputs between 0 and 1 are switches and keep their values.
            elif item.unit != "1":
                size = sizes[item.unit] or (item.high if np.isfinite(item.high) else 1.0)
                u[k] = np.clip(size * generator.uniform(0.6, 1.4), item.low, item.high)
        u = np.asarray(u, dtype=np.float32).astype(float)
        first = (N_CALLS - N_INVALID) // 2
        if numeric and first <= call < first + N_INVALID:
            u[numeric[0]] = np.nan
        rows.append(u)
    return rows
