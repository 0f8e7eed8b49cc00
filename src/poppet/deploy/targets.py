"""Registry of the export targets.

A target is a declaration with a function that returns the exported files.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.core.command_options import Option
from poppet.core.plugins import Registry, import_object

if TYPE_CHECKING:
    from pathlib import Path

    from poppet.circuit.circuit import BaseCircuit
    from poppet.core.codes import Note
    from poppet.deploy.exported_watch import WatchSource
    from poppet.deploy.parity.parity_check import ParityCheck

# Nothing heavy is imported here: the command line reads these declarations for its help.

PART = Option("--part LIST", "sampled controllers to export, by name; `controller` if the circuit has only one")


class CircuitSource(NamedTuple):
    """Origin of a circuit: text and name of its file, and changes made after reading.

    Some targets include the circuit file in the export.
    """

    text: str = ""  # of the circuit file; empty if unknown
    name: str = ""  # of the circuit file, without suffix
    changes: Mapping[str, float | str] = {}  # address to value: changes of the circuit after it was read
    result: str | None = None  # file of identified parameters, which was applied before the changes


MODEL_ELEMENT = '<script type="application/octet-stream" id="model">'
"""Start of the element with the model of a live page."""


class Export(NamedTuple):
    """Files of one export, before they are written."""

    files: Mapping[str, str | bytes]  # path in the folder, or name of the single file, to content
    summary: str = ""  # sentence or lines for the user
    notes: Sequence[Note] = ()


class Target(NamedTuple):
    """Declaration of an export target, for example C or FMU."""

    name: str
    summary: str  # of the help, without a full stop
    # `export(circuit, source, **settings)` returns an `Export`; the settings are the values of the options by name.
    # The text form `module:function` delays the import.
    export: Callable[..., Export] | str
    options: Sequence[Option] = ()  # without those of every target: circuit file, --output, --with, --set, --quiet
    examples: Sequence[str] = ()  # command lines of the help
    suffixes: Sequence[str] = ()  # of the output file; the output is a folder if there are none
    limitations: Sequence[str] = ()
    # Returns the checks of `poppet export check`.
    checks: Callable[[], Sequence[ParityCheck]] | str = tuple
    is_printable: bool = False  # True if the export is printed when no output file is specified
    # Bytes that each exported file contains. Without an output file, the export has the name of the circuit file, and
    # replaces only a file with this mark. If the mark is empty, there is no default name.
    mark: bytes = b""
    # `export_watch(watch, **settings)` returns the `Export` of a twin file; empty if the target has none.
    export_watch: Callable[..., Export] | str = ""
    watch_options: Sequence[str] = ("name",)  # names of the options that a twin file permits

    @property
    def command(self) -> str:
        """Name of the subcommand of `poppet export` that exports to this target."""
        return self.name if self.name == "live" else f"export {self.name}"

    def make(self, circuit: BaseCircuit, source: CircuitSource | None = None, **settings: Any) -> Export:
        """Return the exported files of a circuit without writing them.

        Parameters
        ----------
        circuit : Circuit
            Circuit with a duration.
        source : CircuitSource, optional
            Origin of the circuit.
        **settings
            Values of the options of the target by name.

        Returns
        -------
        Export
        """
        export: Callable[..., Export] = import_object(self.export)
        return export(circuit, source or CircuitSource(), **settings)

    def write(
        self, circuit: BaseCircuit, path: str | Path, source: CircuitSource | None = None, **settings: Any
    ) -> Export:
        """Export a circuit, and write the file or the folder.

        If the export fails, nothing is written.

        Parameters
        ----------
        circuit : Circuit
            Circuit with a duration.
        path : str or Path
            Output file, or folder of a target without suffixes.
        source : CircuitSource, optional
            Origin of the circuit.
        **settings
            Values of the options of the target by name.

        Returns
        -------
        Export
        """
        export = self.make(circuit, source, **settings)
        self._write(export, circuit.title, path)
        return export

    def write_watch(self, watch: WatchSource, path: str | Path, **settings: Any) -> Export:
        """Export the watch of a running plant, and write the file or the folder.

        If the export fails, nothing is written.

        Parameters
        ----------
        watch : WatchSource
            Plan and baseline of the watch.
        path : str or Path
            Output file, or folder of a target without suffixes.
        **settings
            Values of the options of the target by name.

        Returns
        -------
        Export

        Raises
        ------
        InputErrors
            If the target or one of the options is not available for a watch, or the watch cannot be exported.
        """
        from poppet.core.errors import ErrorCollector

        with ErrorCollector() as errors:
            if not self.export_watch:
                known = [f"poppet export {target.name}" for target in BUILT_IN if target.export_watch]
                errors.add("deploy.watch.target", target=f"poppet {self.command}", known=known)
            for option in self.options:
                if settings.get(option.name) and option.name not in self.watch_options:
                    errors.add("deploy.watch.option", option=option.names[-1])
        make: Callable[..., Export] = import_object(self.export_watch)
        export = make(watch, **{name: settings[name] for name in self.watch_options if name in settings})
        self._write(export, watch.title, path)
        return export

    def _write(self, export: Export, title: str, path: str | Path) -> None:
        from pathlib import Path

        from poppet.deploy.export_files import write_export

        write_export(Path(path), self.name, title, export.files, is_folder=not self.suffixes)

    def parity_checks(self) -> Sequence[ParityCheck]:
        """Return the comparisons with the simulation that `poppet export check` runs."""
        checks: Callable[[], Sequence[ParityCheck]] = import_object(self.checks)
        return checks()


BUILT_IN = (
    Target(
        "c",
        "export a circuit, a sampled controller or a watch as C, with a program that checks the code",
        "poppet.deploy.c.project:export_c",
        (
            Option("--name NAME", "name of the model (default: that of the file)"),
            Option("--substeps N", "integration steps per fixed-step call (default: 1)", keywords={"type": int}),
            PART,
            Option(
                "--precision WORD",
                "precision of a controller",
                choices={"double": "64 bits", "single": "32 bits"},
            ),
        ),
        (
            "poppet export c FILE.toml -o valve",
            "poppet export c FILE.toml --substeps 100 -o valve",
            "poppet export c FILE.toml --part controller --precision single -o controller",
            "poppet export c twin.toml -o watch",
        ),
        limitations=(
            "The signals of the file are constants of the code, with at most 100,000 segments.",
            "A parameter on which other parameters depend is constant.",
            "A controller contains no signals: its inputs are members of a struct.",
            "The watch of a twin file contains no fits (`docs/export_watch.md`).",
        ),
        checks="poppet.deploy.parity.host_runs:c_checks",
        export_watch="poppet.deploy.c.watch_project:export_c_watch",
    ),
    Target(
        "fmu",
        "export a circuit as an FMU (FMI 2.0 or 3.0) for Simulink, Dymola, OpenModelica and other importers",
        "poppet.deploy.fmu.package:export_fmu",
        (
            Option(
                "--fmi VERSION", "version of FMI", choices={"2": "FMI 2.0", "3": "FMI 3.0"}, keywords={"default": "2"}
            ),
            Option("--platform LIST", "platforms: linux64, win64, darwin64, aarch64-darwin (default: linux64)"),
            Option(
                "--input ADDRESS ...",
                "input or parameter that the importer sets, in addition to the inputs with signals; may be repeated",
                keywords={"dest": "inputs"},
            ),
            Option("--name NAME", "name of the model (default: title of the circuit)"),
            PART,
        ),
        (
            "poppet export fmu valve-fill.toml -o valve.fmu",
            "poppet export fmu FILE.toml --part controller --fmi 3 --platform linux64,win64 -o controller.fmu",
            "poppet export fmu twin.toml -o watch.fmu",
            "poppet export fmu valve-fill.toml -o valve.fmu --input bleed.opening --set run.duration=20",
        ),
        (".fmu",),
        limitations=(
            "The signals of the file are constants of the FMU, with at most 100,000 segments.",
            "A parameter on which other parameters depend is constant.",
            'Binaries for other platforms require pip install "poppet[fmu]".',
        ),
        checks="poppet.deploy.parity.host_runs:fmu_checks",
        export_watch="poppet.deploy.fmu.watch_package:export_fmu_watch",
        watch_options=("fmi", "platform", "name"),
    ),
    Target(
        "ssp",
        "export a circuit as a system of FMUs: one for each sampled controller, and one for the plant (SSP 1.0)",
        "poppet.deploy.ssp:export_ssp",
        (
            Option(
                "--fmi VERSION",
                "version of FMI",
                choices={"2": "FMI 2.0", "3": "FMI 3.0"},
                keywords={"default": "2"},
            ),
            Option("--platform LIST", "platforms: linux64, win64, darwin64, aarch64-darwin (default: linux64)"),
            Option("--name NAME", "name of the system (default: title of the circuit)"),
        ),
        (
            "poppet export ssp FILE.toml -o system.ssp",
            "poppet export ssp FILE.toml -o system.ssp --platform linux64,win64",
        ),
        (".ssp",),
        limitations=(
            "A controller inside a compound part, such as `proportional_valve`, is in the FMU of the plant.",
            "Stop conditions of a divided circuit are omitted.",
            "`poppet export check` does not run systems of FMUs.",
        ),
    ),
    Target(
        "live",
        "write an HTML page that simulates a circuit in the browser, with sliders",
        "poppet.deploy.live.live_page:export_live",
        (
            Option(
                "--parameter ADDRESS ...",
                'parameter or input with a slider, and its range if required: tank.volume="50 l..400 l"; may be '
                "repeated (default: inputs with signals, then the parameters with the greatest influence)",
                keywords={"dest": "parameters"},
                old_names=("--number",),
            ),
        ),
        (
            "poppet live valve-fill.toml",
            'poppet live valve-fill.toml --parameter "tank.volume=0.05 m^3..0.4 m^3" --parameter supply.pressure '
            "-o large_tanks.html",
        ),
        (".html", ".htm"),
        limitations=(
            "A run has at most 2001 rows and 500,000 steps.",
            "A parameter on which other parameters depend has no slider.",
        ),
        checks="poppet.deploy.parity.host_runs:live_checks",
        mark=MODEL_ELEMENT.encode(),
    ),
    Target(
        "st",
        "export sampled controllers as a function block of structured text for a PLC",
        "poppet.deploy.st.block:export_st",
        (PART,),
        (
            "poppet export st FILE.toml --part controller -o controller.st",
            "poppet export st muscle_joint.toml --part position,inverse -o cascade.st",
        ),
        (".st",),
        limitations=(
            "Only sampled controllers are exported, not their plant.",
            "A signal that is read from a file is not available in a function block.",
        ),
        checks="poppet.deploy.parity.host_runs:controller_checks",
        is_printable=True,
    ),
)


TARGETS: Registry[Target] = Registry(
    "poppet.targets",
    {target.name: target for target in BUILT_IN},
    lambda name, value: isinstance(value, Target) and value.name == name,
)
"""Targets by name, with those of installed packages."""
