"""Declarations of all commands.

The parsers, the help, tables of the documentation and tests are made from these declarations.
"""

from __future__ import annotations

from collections.abc import Iterable

from poppet.cli.parser import Command
from poppet.core.command_options import FILE, SET, WITH, Option
from poppet.deploy import targets as export_targets
from poppet.deploy.targets import TARGETS, Target
from poppet.identify import methods as identification
from poppet.identify.methods import METHODS, Method

RECORDINGS = (".csv", ".parquet", ".mat")
PICTURES = (".png", ".svg", ".pdf")
SIZES = {"C": "m^3/(s Pa)", "Kv": "", "Cv": "", "qNn": "l/min ANR", "area": "mm^2"}
"""Flow capacities by name, with the default unit in which `poppet convert` prints the result."""

VALVE = Option("--valve NAME", "part under test; required if the circuit has several valves")
RESULT = Option("-o, --output FILE", "write the result", (".toml", ".json"))
REPORT = Option("--report FILE", "write an HTML report", (".html",))
UNITS = Option("--units LIST", 'units of the results: "bar,degC,l/min ANR" or ADDRESS=UNIT')
SELECT = Option("--select LIST", 'outputs of the results: "tank.*,valve.stroke"')
ALL = Option("--all", "include internal outputs of the parts: sensors, integrals, duties")
PYTHON = Option("--allow-python", "execute the Python functions in files that the circuit file uses as metrics")
NATIVE = Option("--allow-native", "permit FMUs of the circuit to execute native code, with all rights of your account")
THRESHOLD = Option(
    "--threshold PRESSURE",
    "gauge pressure below which a volume is exhausted (default: 0.5 bar)",
    keywords={"default": "0.5 bar"},
)
FAULT_KINDS = "faults to simulate: stuck_open, stuck_closed, stuck, slow, leak"
TUNE, COMPARE = ("tune",), ("compare",)

_COMMANDS = {
    "simulate": Command(
        "run a circuit file",
        "simulate:execute",
        (
            FILE,
            WITH,
            SET,
            Option("-o, --output FILE", "write the recording", RECORDINGS),
            Option("--plot FILE", "plot the recording", PICTURES),
            Option("--diagram FILE", "draw the displacement-step diagram of the step sequence", PICTURES),
            REPORT,
            Option("--duration TIME", 'duration of the run: "60 s"'),
            Option("--output-step TIME", 'time between rows: "10 ms"'),
            Option("--tolerance NUMBER", "relative tolerance (default: 1e-6)"),
            Option(
                "--stop-when CONDITION ...",
                'end the run early: "tank.pressure > 5 bar"; adds to the conditions of the file; may be repeated',
            ),
            Option("--solver NAME", "rosenbrock (default); for a comparison cvodes, lsoda, bdf, radau"),
            Option("--start-from RECORDING", "start from the end of a recording; --set is applied after"),
            NATIVE,
            UNITS,
            SELECT,
            ALL,
        ),
        (
            "poppet simulate valve-fill.toml",
            'poppet simulate valve-fill.toml --set tank.volume="0.1 m^3" -o fill.csv --plot fill.png',
            'poppet simulate valve-fill.toml --stop-when "tank.pressure > 2 bar" --units "bar,degC,l/min ANR"',
        ),
    ),
    "bench": Command(
        "characteristic values of a pressure valve, from a model or from recordings: iso10094",
        "bench:run_bench_command",
        (
            Option("STANDARD", "", choices={"iso10094": "electro-pneumatic pressure valves (ISO 10094-1, -2)"}),
            Option("[FILE]", "circuit file with the valve (.toml), or a result to print again"),
            VALVE,
            Option("--recording FILE", "recordings of a real valve, instead of a circuit (.toml)"),
            RESULT,
            REPORT,
            Option("--compare FILE", "result, circuit or recordings to compare with"),
            Option("--tests LIST", "selected tests: step,frequency (default: all)"),
            Option(
                "--full-scale RANGE", 'outlet pressure at full setpoint: "6 bar g", or both ends: "0 bar g, 6 bar g"'
            ),
            Option("--supply PRESSURE", "supply pressure (default: that of the circuit)"),
            Option("--volume LIST", 'volumes at the outlet (default: "1 l, 5 l")'),
            Option("--rated-flow FLOW", 'flow at which droop and relief are evaluated: "300 l/min ANR"'),
            Option("--sweep-time TIME", "time of the setpoint from end to end (default: from the response)"),
            Option("--frequencies LIST", 'frequencies of the sines: "1 Hz, 2 Hz" (default: from the response)'),
            WITH,
            SET,
        ),
        (
            "poppet bench iso10094 VALVE.toml --valve valve -o RESULT.toml --report REPORT.html",
            "poppet bench iso10094 VALVE.toml --valve valve --set valve.preset=fast --compare RESULT.toml",
            "poppet bench iso10094 --recording MAP.toml --tests step,frequency --report REPORT.html",
        ),
    ),
    "ensemble": Command(
        "many runs with uncertain parameters: yield, bands, influence of each parameter, worst cases",
        "ensemble:run_ensemble",
        (
            FILE,
            WITH,
            SET,
            Option("-o, --output FOLDER", "folder of the dataset (default: NAME.ensemble beside NAME.toml)"),
            REPORT,
            PYTHON,
            Option("--worst FOLDER", "write the worst runs of each requirement as circuit files"),
            Option("--runs N", "number of runs", keywords={"type": int}),
            Option("--seed N", "seed of the random numbers", keywords={"type": int}),
            Option(
                "--executor NAME",
                "executor of the runs",
                choices={"threads": "of this process (default)", "processes": "of this machine"},
                group="executor",
            ),
            Option(
                "--scheduler ADDRESS", "address of a Dask scheduler, whose workers execute the runs", group="executor"
            ),
            Option("--workers N", "threads or processes (default: one per processor)", keywords={"type": int}),
        ),
        (
            "poppet ensemble ensemble.toml",
            "poppet ensemble ensemble.toml --runs 100000 -o bench/ensemble --report ensemble.html",
            "poppet ensemble ensemble.toml --scheduler tcp://bench:8786",
        ),
    ),
    "size": Command(
        "smallest or largest parameter value, or catalogue component, with which a circuit meets its requirements",
        "ensemble:find_size",
        (
            FILE,
            WITH,
            SET,
            Option("--free ADDRESS", "parameter to be sized", group="sized"),
            Option("--catalogue PART", "part to be sized: tries all components that suit it", group="sized"),
            Option("--find TEXT", 'components to try: "CKD, C < 3 dm^3/(s bar)" (default: all that suit the part)'),
            Option("--meet NAME ...", "requirement of the file (default: all); may be repeated"),
            Option("--between LOW HIGH", "search range, with units", keywords={"nargs": 2, "metavar": ("LOW", "HIGH")}),
            Option("--largest", "find the largest value instead of the smallest"),
            PYTHON,
            Option("--yield SHARE", "required fraction of runs that meet the requirements: 95 % or 0.95"),
            Option("--size SIZE ...", "standard size; reports the next that meets the requirements; may be repeated"),
            RESULT,
            REPORT,
        ),
        (
            "poppet size ensemble.toml --free fill.sonic_conductance --meet fast",
            "poppet size drive-sizing.toml --catalogue valve --find 5/2",
            'poppet size ensemble.toml --free tank.volume --largest --between "0.5 l" "20 l" --yield "95 %"',
            "poppet size ensemble.toml --free tank.volume --largest --size '1 l' --size '2 l' --report size.html",
        ),
    ),
    "bench limits": Command(
        "part that limits a valve: maps of bandwidth, step response and stability",
        "bench:find_bench_limits",
        (
            Option("FILE", "circuit file with a proportional_valve and its load (.toml)"),
            VALVE,
            RESULT,
            REPORT,
            Option("--mean PRESSURE", "mean pressure (default: middle of the span)"),
            Option("--volumes LIST", 'outlet volumes: "0.1 l, 1 l" (default: a tenth to ten times that of the file)'),
            Option("--amplitudes LIST", 'amplitudes of the sine: "5 kPa, 50 kPa" (default: 0.5 to 25 % of the span)'),
            Option("--springs LIST", 'factors on the spring rates (default: "0.5, 1, 2")'),
            Option("--dampings LIST", 'factors on the damping (default: "0.25, 0.5, 1, 2, 4")'),
            WITH,
            SET,
        ),
        (
            "poppet bench limits VALVE.toml --valve valve -o RESULT.toml --report REPORT.html",
            'poppet bench limits VALVE.toml --volumes "0.1 l, 1 l, 10 l" --amplitudes "5 kPa, 50 kPa" '
            "--report REPORT.html",
        ),
    ),
    "audit energy": Command(
        "air, energy and exergy of one machine cycle: balance, losses and consumption of each part",
        "audit:audit_energy",
        (
            FILE,
            WITH,
            SET,
            RESULT,
            REPORT,
            Option("--cycle TIMES", 'start and end of the cycle: "0.5 s, 1.9 s"', group="cycle"),
            Option("--cycle-from STEP", "step of a sequence with which the cycle begins", group="cycle"),
            Option(
                "--cycles N",
                "average over the last N cycles, or over the N cycles in --cycle (default: 1)",
                keywords={"type": int, "default": 1},
            ),
            Option("--duration TIME", 'duration of the run: "60 s"'),
            Option("--tariff PRICE", 'price of electricity, "0.20 EUR/kWh", or of air at ANR, "0.02 EUR/m^3"'),
            Option("--specific-energy ENERGY", 'electricity per volume of air (default: "0.12 kWh/m^3")'),
            Option("--emission MASS", 'CO2 per electrical energy: "0.4 kg/kWh"'),
            Option("--hours TIME", 'operating time per year (default: "4000 h")'),
            Option("--leak ADDRESS ...", "part or flow path whose whole flow is a leak; may be repeated"),
            Option(
                "--saving CHANGES ...",
                "measure to simulate, in place of the default measures; all changes of one measure apply together: "
                '"cylinder.bore=25 mm, supply.pressure=5 bar g"; may be repeated',
                group="savings",
            ),
            Option("--no-savings", "simulate no measures", group="savings"),
        ),
        (
            "poppet audit energy two_cylinders.toml",
            'poppet audit energy double_stroke.toml --cycle "2 s, 4 s" -o RESULT.toml --report REPORT.html',
            "poppet audit energy two_cylinders.toml --cycle-from wait --cycles 3 --duration '20 s'",
            'poppet audit energy two_cylinders.toml --tariff "0.20 EUR/kWh" --emission "0.4 kg/kWh"',
        ),
    ),
    "audit leaks": Command(
        "flow and cost of the leaks in a leak survey of a plant",
        "audit_leaks:survey_leaks",
        (Option("FILE", "leak survey (.toml)"), RESULT),
        (
            "poppet audit leaks leak_survey.toml",
            "poppet audit leaks leak_survey.toml -o RESULT.toml",
        ),
    ),
    "audit safety": Command(
        "exhaust times and travels after an event, in normal operation and with each single fault of a valve",
        "safety:run_audit",
        (
            FILE,
            WITH,
            SET,
            Option(
                "--event ADDRESS=VALUE ...",
                'value of an input from the event on: supply.pressure="0 bar g", plc.emergency=1; may be repeated',
            ),
            Option(
                "--at TIME ...",
                'time of the event: "0.5 s"; or steps: the start and the ends of the first three quarters of each step '
                "(default: steps, or 20 evenly spaced times without a sequence); may be repeated",
            ),
            THRESHOLD,
            Option("--duration TIME", "simulated time after the event (default: 10 s)", keywords={"default": "10 s"}),
            Option("--kinds LIST", f"{FAULT_KINDS} (default: the first three)"),
            Option(
                "--samples N",
                "samples of the uncertain parameters of the table ensemble, for 95 % intervals (default: 50)",
                keywords={"type": int},
            ),
            Option("--seed N", "seed of the samples", keywords={"type": int}),
            RESULT,
            REPORT,
        ),
        (
            'poppet audit safety machine.toml --event supply.pressure="0 bar g"',
            "poppet audit safety machine.toml --event plc.halt=1 --event valveA.command=0 --at steps -o safety.toml",
            'poppet audit safety machine.toml --event supply.pressure="0 bar g" --at "1.9 s" --report safety.html',
        ),
    ),
    "faults": Command(
        "consequences of every single fault of the valves: waiting steps, uncommanded motion, trapped pressure",
        "safety:run_faults",
        (
            FILE,
            WITH,
            SET,
            Option("--at TIME", "start of each fault (default: 0 s)", keywords={"default": "0 s"}),
            Option("--duration TIME", "duration of each run (default: that of the file)"),
            THRESHOLD,
            Option("--kinds LIST", f"{FAULT_KINDS} (default: all)"),
            RESULT,
            REPORT,
        ),
        (
            "poppet faults machine.toml",
            'poppet faults machine.toml --kinds stuck,leak --at "1.6 s" -o faults.toml --report faults.html',
        ),
    ),
    "watch": Command(
        "states and faults of a running plant, from a recording or from lines on the standard input",
        "watch:execute",
        (
            Option("FILE", "twin file (.toml), see docs/watch.md"),
            Option(
                "--commission RECORDING",
                "fit a recording of the healthy plant, and write the baseline file of the twin file",
            ),
            Option("--recording RECORDING", "recording to process, instead of lines on the standard input"),
            Option(
                "--isolable",
                "print the faults that the sensors can distinguish, with the inputs of --recording, if any",
            ),
            Option("-o, --output FILE", "write the estimates of each sample", (".csv",)),
            REPORT,
            Option("--force", "replace an existing baseline"),
        ),
        (
            "poppet watch twin.toml --commission healthy.csv",
            "poppet watch twin.toml --recording day.csv -o states.csv --report day.html",
            "poppet watch twin.toml --isolable --recording healthy.csv",
        ),
    ),
    "serve": Command(
        "run a circuit in real time as a virtual device, with Modbus TCP, OPC UA, MQTT or a page",
        "serve:execute",
        (
            FILE,
            WITH,
            SET,
            Option(
                "--period TIME", "time between two exchanges of values (default: 10 ms)", keywords={"default": "10 ms"}
            ),
            Option(
                "--speed FACTOR",
                "time of the machine per real time (default: 1); inf: runs without a clock",
                keywords={"type": float, "default": 1.0},
            ),
            Option("--duration TIME", "duration of the run in the time of the machine (default: until Ctrl-C)"),
            Option(
                "--modbus ADDRESS",
                "Modbus TCP server: 127.0.0.1:5020, or a port; registers of the table [modbus], or a default map",
            ),
            Option(
                "--map [FILE]",
                "print the map of the Modbus registers as Markdown, or write it (.csv or .md), and end",
                keywords={"nargs": "?", "const": ""},
            ),
            Option("--opcua URL", "OPC UA server: opc.tcp://127.0.0.1:4840, or a port"),
            Option(
                "--opcua-certificate FILE", "certificate of the OPC UA server (.pem, .der); connections are encrypted"
            ),
            Option("--opcua-key FILE", "private key of the certificate"),
            Option("--opcua-users FILE", "users of the OPC UA server and their passwords (.toml)"),
            Option(
                "--mqtt BROKER",
                "MQTT broker for values and commands: HOST, HOST:PORT or mqtts://HOST",
            ),
            Option("--mqtt-topic TOPIC", "first levels of the topics (default: poppet/TITLE)"),
            Option("--mqtt-interval TIME", "time between two messages of a topic (default: 1 s)"),
            Option(
                "--mqtt-credentials FILE",
                "user and password (.toml); default: POPPET_MQTT_USER and POPPET_MQTT_PASSWORD of the environment",
            ),
            Option("--mqtt-ca FILE", "certificate of the authority of the broker (default: those of the system)"),
            Option(
                "--live ADDRESS",
                "page in the browser: 127.0.0.1:8030, or a port; drawing, curves, inputs and faults of the machine",
            ),
            Option("--watch TWIN", "twin file (.toml) of a watch: estimates and alarms on the page"),
            Option(
                "--lines TIME", "JSON lines: commands on the standard input, values in this interval; 0: replies only"
            ),
            Option("--record FILE", "write all outputs of each period", (".csv",)),
            NATIVE,
        ),
        (
            "poppet serve two_cylinders.toml --modbus 127.0.0.1:5020 --record run.csv",
            "poppet serve two_cylinders.toml --map registers.csv",
            "poppet serve two_cylinders.toml --live 127.0.0.1:8030",
            "poppet serve two_cylinders.toml --lines 0.1 --speed 10",
        ),
    ),
    "check": Command(
        "report all errors of circuit files without running them",
        "circuit_files:check_files",
        (Option("FILE ...", "circuit files (.toml)"),),
        ("poppet check valve-fill.toml", "poppet check bench/*.toml"),
    ),
    "new": Command(
        "write a template of a circuit file",
        "circuit_files:write_template",
        (
            Option("[TEMPLATE]", "template to write; if omitted, lists all templates"),
            Option("-o, --output FILE", "output file (default: TEMPLATE.toml)", (".toml",)),
            Option("--force", "overwrite an existing file"),
        ),
        ("poppet new", "poppet new valve-fill", "poppet new two-tanks -o rig.toml"),
    ),
    "edit": Command(
        "draw a circuit in the browser, and simulate it after each change",
        "edit:execute",
        (
            Option("[FILE]", "circuit file (.toml), created by Save if it is missing; or a folder (default: this one)"),
            Option("--no-browser", "print the address, but do not open the browser"),
            Option(
                "--port N",
                "port of the server on this computer (default: any free one)",
                keywords={"type": int, "default": 0},
            ),
        ),
        ("poppet edit", "poppet edit plant.toml", "poppet edit plant.toml --no-browser --port 8800"),
    ),
    "mcp": Command(
        "offer functions to assistants: check, simulate, identify, size, audit, explain, within one folder",
        "assist:execute",
        (
            Option("[FOLDER]", "folder to which all file access is limited (default: this one)"),
            Option("--lines", "lines of JSON instead of the Model Context Protocol; needs no further package"),
            Option("--time-limit TIME", 'largest time limit of a call, such as "5 min" (default: 60 s)'),
        ),
        (
            "poppet mcp circuits",
            "poppet mcp circuits --time-limit '5 min'",
            "poppet mcp circuits --lines",
        ),
    ),
    "show": Command(
        "list the parameters of a circuit by their source, assumed ones first",
        "circuit_files:show_parameters",
        (
            FILE,
            WITH,
            SET,
            Option("--kind KIND", "one kind of source: assumed, datasheet, fitted, measured, given, paper, standard"),
            Option("--json", "print JSON, for programs"),
        ),
        (
            "poppet show valve-fill.toml",
            "poppet show valve-fill.toml --kind assumed",
            "poppet show valve-fill.toml --json",
        ),
    ),
    "draw": Command(
        "draw the schematic of a circuit",
        "circuit_files:draw_schematic",
        (FILE, Option("-o, --output PICTURE", "output file", (".svg", ".png", ".pdf"), keywords={"required": True})),
        ("poppet draw valve-fill.toml -o valve-fill.svg", "poppet draw valve-fill.toml -o valve-fill.png"),
    ),
    "plot": Command(
        "plot recordings in common axes",
        "simulate:plot_files",
        (
            Option("RECORDING ...", "recordings: .csv, .parquet or .mat"),
            Option("-o, --output PICTURE", "output file (default: FIRST.png)", PICTURES),
            SELECT,
            UNITS,
            ALL,
        ),
        (
            "poppet plot fill.csv -o fill.png",
            'poppet plot measured.csv simulated.csv -o both.svg --select "tank.pressure,valve.stroke" --units bar,mm',
        ),
    ),
    "linearise": Command(
        "linear model, eigenvalues and time constants of a circuit",
        "simulate:linearise_file",
        (
            FILE,
            WITH,
            SET,
            Option(
                "--at RECORDING", "operating point at the end of a recording (default: steady state)", group="point"
            ),
            Option(
                "--set-input ADDRESS=VALUE ...",
                'constant value of an input in the steady state: valve.pilot_pressure="2 bar g"; may be repeated',
                group="point",
                keywords={"dest": "inputs"},
            ),
            Option("-o, --output FILE", "write A, B, C, D", (".json", ".mat", ".npz")),
        ),
        (
            "poppet linearise two-tanks.toml",
            'poppet linearise valve-fill.toml --set-input valve.pilot_pressure="2 bar g"',
            "poppet linearise valve-fill.toml --at fill.csv -o linear.json",
        ),
    ),
    "control": Command(
        "tune a controller with Bode and step plots, compare controllers under uncertainty",
        "control:execute",
        (
            Option(
                "ACTION",
                "",
                choices={
                    "tune": "gains of a pid from the linear model, or from responses to sines",
                    "compare": "controllers on one plant with uncertain parameters, one circuit file each",
                },
            ),
            Option("FILE ...", "circuit file (.toml); compare: several"),
            Option("--controller NAME", "controller; required if a circuit has several"),
            WITH,
            SET,
            Option(
                "--at VALUE ...",
                'operating point: "2 bar" or "100 mm" (default: levels of the setpoint); may be repeated',
                actions=TUNE,
            ),
            Option("--form FORM", "pi (default), pid or p", actions=TUNE),
            Option("--sensitivity M", "bound of Ms and Mt (default: 1.4)", actions=TUNE, keywords={"type": float}),
            Option(
                "--amplitude VALUE ...",
                'tune for the responses to a sine of the command with this amplitude: 0.05 or "20 N"; may be repeated',
                actions=TUNE,
            ),
            Option("--schedule", "gains for each operating point", actions=TUNE),
            Option(
                "--vary ADDRESS=RANGE ...", 'uncertain parameter: tank.volume="20 %"; may be repeated', actions=COMPARE
            ),
            Option("--draws N", "number of sampled plants (default: 50)", actions=COMPARE, keywords={"type": int}),
            Option("--seed N", "seed of the samples (default: 0)", actions=COMPARE, keywords={"type": int}),
            Option("--plot FILE", "plot Bode plots and steps (tune), or responses and spread (compare)", PICTURES),
            REPORT,
            Option("-o, --output FILE", "tune: write the gains, .toml; compare: write the metrics of every run, .csv"),
        ),
        (
            "poppet control tune pressure_control.toml --form pid --sensitivity 1.6",
            'poppet control tune pressure_control.toml --schedule --at "2 bar" --at "5 bar" -o gains.toml',
            'poppet control tune muscle_joint.toml --form pid --at "25 deg" --amplitude "20 N" --amplitude "100 N"',
            'poppet control compare pid.toml linearising.toml --vary tank.volume="20 %" --draws 100 --plot spread.png',
        ),
    ),
    "export": Command(
        "export a circuit to other programs: c, fmu, st",
        "export:list_targets",
        (Option("[TARGET]", "export target; see TARGET --help"),),
        ("poppet export", "poppet export c FILE.toml -o valve"),
    ),
    "export check": Command(
        "run a circuit with every export target and compare the results with the kernel",
        "export:check_targets",
        (
            Option("FILE", "circuit file (.toml), or an exported FMU (.fmu), which is then the only one that runs"),
            Option("--circuit FILE", "circuit of an FMU that does not contain its circuit"),
            Option("--duration TIME", 'duration of the run: "2 s" (default: that of the file)'),
            Option("--only LIST", "names of targets (default: all)"),
            WITH,
            SET,
            REPORT,
        ),
        (
            "poppet export check FILE.toml",
            'poppet export check FILE.toml --duration "2 s" --report parity.html',
            'poppet export check FILE.toml --only "c adaptive,controllers"',
            "poppet export check valve.fmu",
        ),
    ),
    "convert": Command(
        "convert units, and C, Kv, Cv, qNn and effective areas",
        "convert:execute",
        (
            Option("VALUE", 'number and unit: "6 bar g", "1.2 Kv", "380 l/min ANR"'),
            Option("--to UNIT", f"unit, or one of {', '.join(SIZES)}", keywords={"required": True}),
            Option("--ambient PRESSURE", "ambient pressure of gauge values [Pa], or with unit"),
            Option("--critical-ratio B", "critical back-pressure ratio b; assumed if omitted"),
            Option(
                "--definition NAME",
                "definition of Kv and Cv",
                choices={"pneumatic": "of pneumatic catalogues (default)", "small_dp": "of a liquid test"},
                keywords={"default": "pneumatic"},
            ),
            Option("--gas NAME", "gas of C and b (default: air); Kv, Cv and qNn refer to water or air"),
        ),
        (
            'poppet convert "6 bar g" --to psi --ambient "1.013 bar"',
            'poppet convert "1.2 Kv" --to C --critical-ratio 0.35',
            'poppet convert "380 l/min ANR" --to C',
            'poppet convert "1 mm^2" --to C --gas helium',
        ),
    ),
    "library": Command(
        "list or describe published parameter sets, characteristics, gases and components",
        "reference:show_library",
        (
            Option("[NAME]", "set, characteristic, gas or component to describe; if omitted, lists all"),
            Option(
                "--components [FILE]",
                "list the components of the library, or those of a component file",
                keywords={"nargs": "?", "const": ""},
            ),
            Option("--find CONDITIONS", 'list the components that fulfil all conditions: "5/2, C > 3 dm^3/(s bar)"'),
        ),
        (
            "poppet library",
            "poppet library varga2012",
            'poppet library "SMC SY5000"',
            'poppet library --find "5/2, C > 3 dm^3/(s bar)"',
        ),
    ),
    "explain": Command(
        "explain the code of an error, note or finding, or a verdict: cause, example and remedy",
        "reference:explain_codes",
        (Option("[CODE] ...", "codes, or first parts of codes to list; if omitted, lists all first parts"),),
        ("poppet explain fields.out_of_range", "poppet explain finding.capped run.stalled", "poppet explain wiring"),
    ),
    "schema": Command(
        "write the JSON schema of circuit files for editors",
        "circuit_files:write_schema",
        (Option("-o, --output FILE", "write to a file instead of the standard output", (".json",)),),
        ("poppet schema", "poppet schema -o circuit.schema.json"),
    ),
    "paper": Command(
        "reproduce the figures of Varga & Keski-Honkola 2012, or write their circuits",
        "reference:reproduce_paper",
        (
            Option(
                "-o, --output FOLDER",
                "folder of the report (default: paper)",
                group="written",
                keywords={"default": "paper"},
            ),
            Option(
                "--circuits FOLDER",
                "write the circuits of figures 3 to 6 with their pilot pressures, instead of the report",
                group="written",
            ),
            Option("--force", "replace circuits that you have changed"),
        ),
        ("poppet paper", "poppet paper -o figures", "poppet paper --circuits circuits"),
    ),
}
"""Commands by name, except those of export targets and identification methods."""


def target_command(target: Target) -> Command:
    """Return the declaration of the command `export TARGET` for one export target."""
    if not target.suffixes:
        output = Option("-o, --output FOLDER", "output folder; a folder of an earlier export is written again")
    elif target.mark:
        meaning = f"output file (default: name of the circuit file with {target.suffixes[0]}, in the current folder)"
        output = Option("-o, --output FILE", meaning, target.suffixes)
    else:
        keywords = {"required": not target.is_printable}
        output = Option("-o, --output FILE", "output file", target.suffixes, keywords=keywords)
    return Command(
        target.summary,
        "export:write_target",
        (FILE, output, *target.options, WITH, SET),
        target.examples,
        target.limitations,
    )


def identify_command(methods: Iterable[Method]) -> Command:
    """Return the declaration of the command `identify`.

    It includes the options that each identification method declares.
    """
    methods = tuple(methods)
    options = {item.option.usage: item.option for method in methods for item in method.options}
    actions = {
        usage: tuple(m.name for m in methods if any(item.option.usage == usage for item in m.options))
        for usage in options
    }
    return Command(
        f"parameters with confidence intervals from recordings: {', '.join(method.name for method in methods)}",
        "identify:execute",
        (
            Option("METHOD", "", choices={method.name: method.summary for method in methods}),
            Option("[FILE]", "identification file (.toml), see docs/identify.md; with --from, the file to write"),
            RESULT,
            REPORT,
            *(option._replace(actions=actions[usage]) for usage, option in options.items()),
            Option("--all", "print all findings instead of the first three"),
        ),
        tuple(example for method in methods for example in method.examples),
    )


def _with_plugins(targets: Iterable[Target], methods: Iterable[Method]) -> dict[str, Command]:
    commands: dict[str, Command] = {}
    for name, command in _COMMANDS.items():
        if name == "bench":
            commands["identify"] = identify_command(methods)
        if name == "export check":
            commands |= {target.command: target_command(target) for target in targets}
        commands[name] = command
    return commands


def all_commands() -> dict[str, Command]:
    """Return the declarations of all commands by name.

    They include commands for the export targets and identification methods of installed plugins.
    """
    return _with_plugins(TARGETS.values(), METHODS.values())


COMMANDS = _with_plugins(export_targets.BUILT_IN, identification.BUILT_IN)
"""Built-in commands by name, in the order of the help."""
