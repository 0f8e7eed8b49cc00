"""Registry of the identification methods; each method is one declaration and one package."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.core.command_options import Option
from poppet.core.plugins import Registry, import_object

if TYPE_CHECKING:
    from poppet.identify.result import Result

# Nothing heavy is imported here: the command line reads these declarations for its help.

REPORT = "poppet.report.identification.identification_report:write_identification"
SUMMARY = "poppet.report.identification.headline:result_summary"
_SECTIONS = "poppet.report.identification.method_sections:"
_INTERVALS_OF_FITS = (
    "The intervals follow from the sensitivities of the model at the optimum. They are enlarged if the residuals "
    "exceed the noise or are correlated."
)


class MethodOption(NamedTuple):
    """Command-line option that only some identification methods have."""

    option: Option
    # Keyword argument of `run` that takes the value; empty for an option that writes a file.
    keyword: str = ""
    write: Callable[[Any, Path], Any] | str = ""  # `write(result, path)` writes the file of the option


class Method(NamedTuple):
    """Declaration of an identification method: its functions, options and texts.

    A function can also be given as the string `module:name`. The module is then imported at the first use.
    """

    name: str
    summary: str  # of the help, without a full stop
    # `run(path, **options)` returns a result; it may also take `progress` and `stages`.
    run: Callable[..., Any] | str
    read: Callable[[Path], Any] | str  # reads and checks a file
    fields: Mapping[str, Any] | str  # declarations of the top level of a file, for its JSON schema
    options: Sequence[MethodOption] = ()
    examples: Sequence[str] = ()  # command lines of the help
    description: str = ""  # sentence of a report
    intervals: str = ""  # meaning of the intervals, for a report
    has_coefficients: bool = False  # True if single parameters have little meaning
    is_fit: bool = False  # True if recordings can validate the result
    counts_points: bool = False  # True if `progress` takes the number of points, all points and the next point
    sections: Any = ""  # `MethodReport` with the sections of this method
    report: Callable[[Any, Path], Any] | str = REPORT  # writes a report
    text: Callable[[Any, int | None], str] | str = SUMMARY  # terminal output with at most so many findings

    def identify(self, path: str | Path, **options: Any) -> Result:
        """Run the identification method on an input file, and return the result.

        The options `progress` and `stages` are ignored if the method does not accept them.
        """
        run = import_object(self.run)
        accepted = inspect.signature(run).parameters
        is_accepted = {key: key in accepted or key not in ("progress", "stages") for key in options}
        result: Result = run(Path(path), **{key: value for key, value in options.items() if is_accepted[key]})
        return result

    def file_schema(self) -> dict[str, Any]:
        """Return the JSON schema of the input files of the identification method."""
        from poppet.core.tables import table_schema

        title = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": f"poppet identify {self.name}"}
        return title | table_schema(import_object(self.fields))


_PROFILE = MethodOption(Option("--profile ADDRESS ...", "interval by profile likelihood; may be repeated"), "profile")
_CONTOUR = MethodOption(Option("--contour", "cost versus conductance and wall conductance, for the report"), "contour")
_BOOTSTRAP = MethodOption(Option("--bootstrap N", "N bootstrap fits", keywords={"type": int, "default": 0}), "repeats")
_COMPARE = MethodOption(Option("--compare FILE", "compare with another fit file"), "compare")
_TANK_RECORDING = tuple(
    MethodOption(Option(usage, help_text, **keywords))
    for usage, help_text, keywords in (
        (
            "--from RECORDING",
            "recording of a test; poppet asks on a terminal for what it does not contain, writes FILE "
            "(default: RECORDING.toml), and fits",
            {"keywords": {"dest": "recording"}},
        ),
        ("--time COLUMN", 'column of the time, with its unit if the heading has none: "t [ms]"', {}),
        ("--pressure COLUMN", 'column of the tank pressure: "p_tank [bar g]"', {}),
        ("--temperature COLUMN", 'column of the gas temperature in the tank: "T [degC]" (default: not used)', {}),
        ("--reference NAME", "gauge or absolute, if neither heading nor --pressure states it", {}),
        ("--volume VOLUME", 'volume of the tank with its lines: "20 l"', {}),
        ("--ambient PRESSURE", 'ambient pressure, absolute: "987 hPa"; or its column', {}),
        ("--ambient-temperature TEMPERATURE", "ambient temperature, or its column (default: 20 degC +/- 3 K)", {}),
        ("--direction NAME", "discharge or charge (default: from the recorded pressure)", {}),
        ("--supply PRESSURE", 'supply pressure of a charge, or its column: "p_supply [bar g]"', {}),
        (
            "--opens TIME",
            'time at which the valve opens, from the first sample: "2.3 s"; or a column with the valve signal; free: '
            "estimated",
            {},
        ),
        ("--closes TIME", "time at which the valve closes; no: not in the recording", {}),
        ("--window TIMES", 'start and end of the test in the recording: "0.5 s, 20 s"', {}),
        ("--wall-conductance VALUE", 'wall conductance h A: "6 W/K" (default: free)', {}),
        (
            "--picture FILE",
            "picture of the interpretation (default: FILE-interpretation.png, without .toml)",
            {"formats": (".png", ".svg", ".pdf")},
        ),
        ("--yes", "accept the interpretation without a question, also with doubts", {}),
        ("--force", "overwrite FILE", {}),
    )
)  # fmt: skip
"""Options with which a recording is described instead of a file."""
_LIBRARY = MethodOption(
    Option("--library FILE", "write C(x), b(x) for circuit files", (".toml",)),
    write="poppet.identify.characteristic.characteristic_file:write_characteristic",
)

BUILT_IN = (
    Method(
        "fit",
        "any free parameters of any circuit, from any recordings",
        run="poppet.identify.fit.identify_fit:identify_fit",
        read="poppet.identify.fit.fit_plan:read_fit_file",
        fields="poppet.identify.fit.fit_plan:TOP_LEVEL",
        options=(_COMPARE, _PROFILE, _CONTOUR, _BOOTSTRAP),
        examples=("poppet identify fit FIT.toml --compare OTHER.toml -o RESULT.toml --report REPORT.html",),
        description="Parameters of a circuit, fitted to recordings by weighted least squares on the integrated "
        "equations.",
        intervals=_INTERVALS_OF_FITS,
        is_fit=True,
    ),
    Method(
        "tank",
        "C, b and wall heat from a charge or discharge test (ISO 6358-2)",
        run="poppet.identify.tank.identify_tank:identify_tank",
        read="poppet.identify.tank.test:read_tank_file",
        fields="poppet.identify.tank.test:FILE_FIELDS",
        options=(_PROFILE, _CONTOUR, _BOOTSTRAP, *_TANK_RECORDING),
        examples=(
            'poppet identify tank --from RECORDING.csv --time "t [s]" --pressure "p_tank [bar g]" --volume "20 l" '
            '--ambient "987 hPa" -o RESULT.toml',
        ),
        description="Flow characteristics from the pressure in a tank during charge or discharge, fitted to the "
        "integrated equations.",
        intervals=_INTERVALS_OF_FITS,
        is_fit=True,
        sections=f"{_SECTIONS}TANK",
    ),
    Method(
        "flow",
        "C, b, m and cracking pressure from a steady flow bench (ISO 6358-1)",
        run="poppet.identify.flow.identify_flow:identify_flow",
        read="poppet.identify.flow.flow_file:read_flow_file",
        fields="poppet.identify.flow.flow_file:TOP_LEVEL",
        description="Flow characteristics from the points of a steady flow bench (mass flow rate and pressures), "
        "fitted by weighted least squares.",
        intervals="The intervals contain the scatter and the common errors that are stated. If the scatter is not "
        "stated, the residuals give it, and the intervals use Student's t.",
        sections=f"{_SECTIONS}FLOW",
    ),
    Method(
        "characteristic",
        "C(x), b(x) from tests at known strokes",
        run="poppet.identify.characteristic.identify_characteristic:identify_characteristic",
        read="poppet.identify.characteristic.characteristic_file:read_characteristic_file",
        fields="poppet.identify.characteristic.characteristic_file:TOP_LEVEL",
        options=(_LIBRARY,),
        examples=("poppet identify characteristic TESTS.toml --library valve.toml",),
        description="Flow characteristics versus stroke, from tests at known strokes.",
        intervals="The coefficients of a curve are strongly correlated, especially those of a polynomial. The band, "
        "not the verdicts on the coefficients, is the uncertainty of the curve. The result file has all "
        "digits.",
        has_coefficients=True,
        sections=f"{_SECTIONS}CHARACTERISTIC",
    ),
    Method(
        "muscle",
        "force law of a muscle, from a force map or recordings",
        run="poppet.identify.muscle.identify_muscle:identify_muscle",
        read="poppet.identify.muscle.muscle_file:read_muscle_file",
        fields="poppet.identify.muscle.muscle_file:TOP_LEVEL",
        description="Force of a muscle versus pressure and contraction. Each law is fitted to the taut points by "
        "least squares; the validation error ranks the laws.",
        intervals="The intervals are a jackknife: the fit is repeated without each pressure or recording, and the "
        "spread of these fits gives the interval, with Student's t. Errors common to one pressure are "
        "included; errors common to all points are not.",
        sections=f"{_SECTIONS}MUSCLE",
    ),
    Method(
        "friction",
        "friction law, from velocity-force tables or recordings of motion",
        run="poppet.identify.friction.identify_friction:identify_friction",
        read="poppet.identify.friction.friction_file:read_friction_file",
        fields="poppet.identify.friction.friction_file:TOP_LEVEL",
        description="Dry friction versus speed and pressure. Each law is fitted to steady sliding by least squares; "
        "the validation error of recordings or strokes ranks the laws. The motion after reversals gives "
        "the bristles.",
        intervals="The intervals are based on the number of recordings or strokes, not of samples: they use the sum "
        "of the residuals of each, with Student's t. The intervals of a Stribeck velocity and of its "
        "forces contain all equivalent values.",
        sections=f"{_SECTIONS}FRICTION",
    ),
    Method(
        "design",
        "most informative of the possible tests",
        run="poppet.identify.design.identify_design:identify_design",
        read="poppet.identify.design.design_file:read_design_file",
        fields="poppet.identify.design.design_file:TOP_LEVEL",
        examples=("poppet identify design DESIGN.toml --report DESIGN.html",),
        counts_points=True,
        report="poppet.report.identification.design_report:write_design",
        text="poppet.report.identification.design_report:design_text",
    ),
)

METHODS: Registry[Method] = Registry(
    "poppet.methods",
    {method.name: method for method in BUILT_IN},
    lambda name, value: isinstance(value, Method) and value.name == name,
)
"""Methods by name, with those of installed packages."""
