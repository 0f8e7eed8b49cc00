"""One file of all that an FMU is: description, sources, binaries, the circuit's file; the same bytes every time."""

from __future__ import annotations

import hashlib
import io
import uuid
import zipfile
from collections.abc import Mapping, Sequence
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.deploy.c.c_model import integrator_text, model_text
from poppet.deploy.export_model import ExportModel, build_export_model
from poppet.deploy.fmu.binaries import PLATFORMS, compilers, kernel_text, linked
from poppet.deploy.fmu.description import build_description, describe
from poppet.deploy.fmu.fmu_layout import FmuLayout, plan_of
from poppet.deploy.fmu.fmu_tables import DIRECTIONAL, model_header, names_header
from poppet.engine.compiled import INTEGRATOR
from poppet.engine.printers.c import print_function, used_prelude

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

ZIP_TIME = (1980, 1, 1, 0, 0, 0)
HEADERS = {
    2: ("fmi2FunctionTypes.h", "fmi2Functions.h", "fmi2TypesPlatform.h"),
    3: ("fmi3FunctionTypes.h", "fmi3Functions.h", "fmi3PlatformTypes.h"),
}
C_ENDS = "#ifdef __cplusplus\n}\n#endif\n"
NOTHING: Mapping[str, bytes] = {}


class Fmu(NamedTuple):
    """An FMU in memory."""

    plan: FmuLayout
    content: dict[str, bytes]  # path in the file to bytes
    platforms: tuple[str, ...]  # with a binary
    notes: tuple[Note, ...] = ()


def directional(model: Any) -> Any:
    """The CasADi function of the derivatives of rates and outputs along a direction of x, u and p."""
    import casadi as ca

    s, e = model.symbols, model.expressions
    names = ("t", "x", "u", "p")
    towards = [ca.SX.sym(f"d{name}", s[name].shape[0]) for name in names[1:]]
    f, y = e["rates"], e["outputs"]
    found = []
    for expression in (f, y):
        along = ca.SX.zeros(expression.shape[0])
        for name, direction in zip(names[1:], towards, strict=True):
            if s[name].shape[0]:
                along += ca.jtimes(expression, s[name], direction)
        found.append(ca.densify(along))
    return ca.Function("directional", [*(s[name] for name in names), *towards], ca.cse(found))


def fmu_of(
    circuit: Circuit,
    name: str = "",
    *,
    fmi: int = 2,
    platforms: Sequence[str] = ("linux64",),
    inputs: Sequence[str] = (),
    resources: Mapping[str, bytes] = NOTHING,
) -> Fmu:
    """A circuit as an FMU.

    Parameters
    ----------
    circuit : Circuit
        With a duration.
    name : str, optional
        Of the model; default its title.
    fmi : int, optional
        2 or 3.
    platforms : sequence of str, optional
        Of `linux64`, `win64`, `darwin64`, `aarch64-darwin`.
    inputs : sequence of str, optional
        Addresses of inputs and numbers that the host is to drive, besides the inputs that have signals.
    resources : mapping of str to bytes, optional
        Further files, by their paths in the FMU; see `poppet.deploy.fmu.origin`.

    Returns
    -------
    Fmu
        With a note for each platform for which nothing here links.

    Raises
    ------
    InputErrors
        For a platform or an input that is unknown, and for what no target carries.
    """
    with ErrorCollector() as errors:
        for platform in platforms:
            if platform not in PLATFORMS:
                near = NameSuggestion(platform, PLATFORMS)
                errors.add("fields.not_an_option", "platform", value=platform, meaning="platform", near=near)
    plan = plan_of(build_export_model(circuit, name), inputs)
    directional_function = directional(plan.carried.model)
    text = kernel_text(plan.carried, {"directional": directional_function})
    functions = [name for name in (*plan.carried.functions, "directional", "step", "dense") if name != "energy"]
    if not plan.carried.model.size:
        functions = [each for each in functions if each not in ("jacobian", "factor", "solve", "step", "dense")]
    identifier = plan.carried.name
    sources = {each: _read("c", each) for each in ("core.h", "core.c", f"fmi{fmi}.c")}
    sources |= {each: _read("headers", each) for each in HEADERS[fmi]}
    sources["names.h"] = names_header(functions, fmi)
    token = _token(model_header(plan, functions, ""), text, *sources.values())
    sources["model.h"] = model_header(plan, functions, token)
    content = {**resources, "modelDescription.xml": describe(plan, fmi, token, identifier).encode()}
    content |= {f"sources/{each}": text.encode() for each, text in sources.items()}
    content["sources/model.c"] = model_source(plan.carried, directional_function).encode()
    content["sources/LICENSE.txt"] = LICENSE.encode()
    if fmi == 3:
        build = build_description(identifier, (f"fmi{fmi}.c", "model.c"))
        content["sources/buildDescription.xml"] = build.encode()
    linkable = tuple(platform for platform in platforms if compilers(platform))
    for platform in linkable:
        place = PLATFORMS[platform]
        path = f"binaries/{place.folders[fmi - 2]}/{identifier}{place.suffix}"
        content[path] = linked(text, sources, platform, f"fmi{fmi}.c")
    notes = [Note("deploy.fmu.no_binary", platform=each) for each in platforms if each not in linkable]
    return Fmu(plan, content, linkable, (*notes, *_delays(plan)))


def _delays(plan: FmuLayout) -> list[Note]:
    """Of inputs whose signal comes late: what a host sets does not."""
    told = plan.carried.model.inputs
    late = [item for item in told if item.delay and plan.carried.instance.parameters[item.delay]]
    return [Note("deploy.fmu.no_delay", item.name, delay=item.delay) for item in late]


LICENSE = """The files fmi2*.h and fmi3*.h are licensed by the Modelica Association Project FMI under the 2-Clause BSD
License, whose text stands in them. All other sources were written by poppet, and are licensed with it.
"""


def model_source(build_export_model: ExportModel, directional: Any) -> str:
    """The functions of a model and the integrator in C, for hosts that compile."""
    along = print_function(directional, "directional", DIRECTIONAL, prefix="model_")
    own = model_text(build_export_model, "model_")
    # What one of them uses of the mathematics stands before both.
    both = "\n\n".join([own, along])
    own = own.replace(used_prelude(own), "", 1).lstrip()
    head = "/* The model and the integrator; written by poppet. */\n#include <math.h>\n#include <stdint.h>\n\n"
    head += '#include "names.h"\n\n#ifdef __cplusplus\nextern "C" {\n#endif\n'
    return "\n\n".join([head, used_prelude(both), own, along, integrator_text("model_integrate"), C_ENDS])


def _read(folder: str, name: str) -> str:
    return files("poppet.deploy.fmu").joinpath(folder, name).read_text(encoding="utf-8")


def _token(*texts: str) -> str:
    """A GUID of the model's content."""
    digest = hashlib.sha256("\0".join([*texts, INTEGRATOR.read()]).encode()).hexdigest()
    return f"{{{uuid.UUID(digest[:32])}}}"


def packed(content: Mapping[str, bytes]) -> bytes:
    """A ZIP archive whose bytes depend on nothing but its content."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for path in sorted(content, key=lambda path: (path != "modelDescription.xml", path)):
            info = zipfile.ZipInfo(path, ZIP_TIME)
            info.compress_type, info.create_system, info.external_attr = zipfile.ZIP_DEFLATED, 3, 0o644 << 16
            archive.writestr(info, content[path])
    return buffer.getvalue()


def write_fmu(fmu: Fmu, path: Path) -> Path:
    """Write an FMU aside, and rename it."""
    aside = path.with_name(f".{path.name}.{uuid.uuid4().hex[:12]}")
    try:
        aside.write_bytes(packed(fmu.content))
        aside.replace(path)
    finally:
        aside.unlink(missing_ok=True)
    return path
