"""Claims of the validation page and their measurements; `validate.py` stores the results.

A claim names its source, the licence of this source, the data that no fit has used, and its criterion. Its function
measures the values with tests, examples and benchmarks. Without the external files (`../shared/data`), a claim keeps
its last result.

A claim names who made what it is compared with, under which licence, what of it was not seen by any fit, and when it
holds. Its function measures figures, and takes what it runs from tests, examples and benchmarks. Files of others that
are not beside the checkout (`../shared/data`) leave a claim as it was last measured.
"""

from __future__ import annotations

import importlib.util
import os
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
DATA = ROOT.parent / "shared" / "data"
DAYS = os.environ.get("POPPET_SOFTARM")
"""A copy of the recordings of other days (`data-collection/2023` of their repository)."""
sys.path += [str(ROOT / place) for place in ("tests", "benchmarks", "examples/regulators")]

Figures = dict[str, Any]
"""Numbers and texts of a result by name."""


@dataclass(frozen=True)
class Source:
    """Origin of the values that a claim is compared with."""

    name: str
    licence: str
    files: Path | None = None  # measured data, which are not in the repository
    link: str = ""
    package: str = ""  # the independent code, for its version

    @property
    def is_here(self) -> bool:
        """True if the claim can be measured here."""
        if self.package:
            return importlib.util.find_spec(self.package) is not None
        return self.files is None or self.files.is_dir()


OWN_TEXTBOOK = "none needed: a formula"
SOURCES = {
    "vessel": Source(
        "Discharge of a vessel of 16.2 l: validation set Air_790kPa_21mm of HydDown",
        "MIT",
        DATA / "tank_discharge_16l",
        "https://github.com/andr1976/HydDown",
    ),
    "tanks": Source(
        "Two tanks, laboratory CHE260: PeterL-Engineering/CHE260_Thermodynamics_Heat_Transfer",
        "Apache-2.0",
        DATA / "two_tanks",
        "https://github.com/PeterL-Engineering/CHE260_Thermodynamics_Heat_Transfer",
    ),
    "cylinder": Source(
        "Cylinder of 25 mm, pulled, and leaking: EvaZillen/3D-printed-pneumatic-actuator",
        "CC0-1.0",
        DATA / "cylinder_25mm",
        "https://github.com/EvaZillen/3D-printed-pneumatic-actuator",
    ),
    "muscle": Source(
        "Force map of a DMSP-20-300: Martens & Boblan, Actuators 2017, 6(4), 33",
        "CC BY 4.0",
        DATA / "muscle_dmsp20_300",
        "https://doi.org/10.3390/act6040033",
    ),
    "softarm": Source(
        "Regulators ITV0050 at a soft arm: ASU-RISE-Lab/4-chamber-softarm-control",
        "MIT",
        DATA / "regulator_itv0050",
        "https://github.com/ASU-RISE-Lab/4-chamber-softarm-control",
    ),
    "days": Source(
        "The same repository, recordings of other days (name a copy in POPPET_SOFTARM)",
        "MIT",
        Path(DAYS) if DAYS else Path("a copy of these recordings"),
        "https://github.com/ASU-RISE-Lab/4-chamber-softarm-control",
    ),
    "lung": Source(
        "Proportional solenoid at a test lung: RespiraWorks/Ventilator, sample data",
        "Apache-2.0",
        DATA / "proportional_solenoid",
        "https://github.com/RespiraWorks/Ventilator",
    ),
    "paper": Source(
        "Varga & Keski-Honkola 2012, J. Appl. Sci. Thermodyn. Fluid Mech. 1(1)", "published article, figures quoted"
    ),
    "cantera": Source("Cantera: its reactors, walls, valves and fluids", "BSD-3-Clause", package="cantera"),
    "lsoda": Source("SciPy, LSODA, on equations written anew in plain floats", "BSD-3-Clause", package="scipy"),
    "control": Source("python-control: margins and responses", "BSD-3-Clause", package="control"),
    "fmpy": Source("FMPy and its CVODE, hosts of the exported FMU", "BSD-2-Clause", package="fmpy"),
    "cvodes": Source("SUNDIALS CVODES by CasADi, on the traced equations", "BSD-3-Clause, LGPL-3.0", package="casadi"),
    "closed": Source("Closed forms", OWN_TEXTBOOK),
    "tanktests": Source(
        "Tank tests of known truth, by a program that takes nothing from the library: tests/exact/independent_tanks.py",
        "MIT",
    ),
    "leaktests": Source(
        "Random tank tests with leaks of up to 3 % of C, sensors of 10 to 16 bits and supplies that are up to 0.5 % "
        "off, by a program that takes nothing from the library: tests/exact/independent_edge_tanks.py",
        "MIT",
    ),
    "benchtests": Source(
        "Flow benches and valves of known truth, by programs that take nothing from the library: "
        "tests/exact/independent_flow_benches.py and independent_characteristics.py",
        "MIT",
    ),
    "eos": Source(
        "Reference equations of state, values by CoolProp 8.0 (Lemmon et al. 2000, Span & Wagner 1996 and others)",
        "MIT; figures quoted",
    ),
}


@dataclass(frozen=True)
class Claim:
    """Line of the page. `ours` and `theirs` are formats of the values; `rounding` is relative."""

    name: str
    title: str
    source: str  # a key of SOURCES
    unseen: str
    ours: str
    theirs: str
    holds: Callable[[Figures], bool]
    when: str  # it holds, in words
    measure: Callable[[], Figures]
    rounding: float = 0.02
    is_quick: bool = False


CLAIMS: dict[str, Claim] = {}


def claim(source: str, title: str, **more: Any) -> Callable[[Callable[[], Figures]], Callable[[], Figures]]:
    """Declare the claim that a function measures."""

    def declared(measure: Callable[[], Figures]) -> Callable[[], Figures]:
        CLAIMS[measure.__name__] = Claim(measure.__name__, title, source, measure=measure, **more)
        return measure

    return declared


def module(name: str) -> Any:
    """Import a module of tests, benchmarks or examples."""
    return importlib.import_module(name)


TANK_TESTS = 100
"""Number of tests; `tests/exact/test_independent_coverage.py` runs 300."""
FLOW_BENCHES, SPLINES = 40, 35
"""Number of benches of each kind, and of valves of each shape."""
NOTHING_FITTED = "all data: nothing was fitted"
NONE_NEEDED = "not applicable: no fit"

# --- Measured: tanks -------------------------------------------------------------------------------------------------


@claim(
    "vessel",
    "Adiabatic and isothermal runs enclose a measured discharge",
    unseen=NOTHING_FITTED,
    ours="{adiabatic:.1f} s adiabatic, {isothermal:.1f} s isothermal, to 2.09 bar",
    theirs="{measured:.1f} s measured",
    when="the measured time lies between them",
    holds=lambda f: f["adiabatic"] < f["measured"] < f["isothermal"],
    is_quick=True,
)
def discharge_bracket() -> Figures:
    tanks = module("published.test_measured_tanks")
    time, bar = np.loadtxt(DATA / "tank_discharge_16l" / "pressure.csv", delimiter=",", skiprows=2).T
    limits = {name: tanks.seconds_to(tanks.discharge(thermal=thermal), 2.0884e5)
              for name, thermal in (("adiabatic", "energy"), ("isothermal", "isothermal"))}  # fmt: skip
    return {"measured": np.interp(-2.0884, -bar, time), **limits}


@claim(
    "vessel",
    "Free convection at the wall predicts a measured discharge",
    unseen=NOTHING_FITTED + "; Nu = 0.13 Ra^(1/3) is a textbook correlation",
    ours="{ours:.1f} kPa rms",
    theirs="{adiabatic:.1f} kPa adiabatic, {isothermal:.1f} kPa isothermal",
    when="the rms error is below that of the better limit",
    holds=lambda f: f["ours"] < min(f["adiabatic"], f["isothermal"]),
    is_quick=True,
)
def discharge_predicted() -> Figures:
    tanks = module("published.test_measured_tanks")
    time, bar = np.loadtxt(DATA / "tank_discharge_16l" / "pressure.csv", delimiter=",", skiprows=2).T
    wall = {"heat_transfer": "natural", "wall_area": tanks.AREA, "height": tanks.DIAMETER, "wall_temperature": "298 K"}

    def rms(**thermal: Any) -> float:
        run = tanks.discharge(**thermal).simulate("60 s", "0.01 s")
        return 1e-3 * _rms(run.interpolate("tank.pressure", time) - 1e5 * bar)

    return {"ours": rms(**wall), "adiabatic": rms(), "isothermal": rms(thermal="isothermal")}


@cache
def _discharge() -> Any:
    """Fit the discharge with pressure and temperature."""
    fits = module("published.test_identify_real_data")
    with tempfile.TemporaryDirectory() as folder:
        fits.write(Path(folder), "vessel.toml", fits.VESSEL)
        return fits.identify_fit(fits.write(Path(folder), "fit.toml", fits.DISCHARGE))


@claim(
    "vessel",
    "Discharge coefficient of the bore from a fit",
    unseen="nothing: one recording",
    ours="{value:.3f} ({low:.3f} to {high:.3f})",
    theirs="0.84 published",
    when="the interval contains 0.84. It covers noise, but not the error of the bore diameter, which counts twice, and "
    "not the simplified wall model. A deviation of 2.6 % is therefore no evidence against 0.84",
    holds=lambda f: f["low"] <= 0.84 <= f["high"],
)
def discharge_coefficient() -> Figures:
    conductance = _discharge().parameters["outlet.sonic_conductance"]
    area = importlib.import_module("poppet.iso6358").conductance_from_effective_area(np.pi / 4.0 * 2.71e-3**2)
    return {k: getattr(conductance, k) / area.sonic_conductance for k in ("value", "low", "high")}


@claim(
    "vessel",
    "Prefactor of free convection from a fit",
    unseen="nothing: one recording",
    ours="{value:.3f} ({low:.3f} to {high:.3f})",
    theirs="0.13 in textbooks",
    when="the interval contains 0.13",
    holds=lambda f: f["low"] <= 0.13 <= f["high"],
)
def discharge_nusselt() -> Figures:
    return _interval(_discharge().parameters["tank.nusselt_prefactor"])


@claim(
    "vessel",
    "Critical back-pressure ratio b from a fit",
    unseen="nothing: one recording",
    ours="{value:.2f} ({low:.2f} to {high:.2f}), {verdict}",
    theirs="not published; the end of this recording contains little information on b",
    when="the verdict for b is determined",
    holds=lambda f: f["verdict"] == "determined",
)
def discharge_ratio() -> Figures:
    return _interval(_discharge().parameters["outlet.critical_ratio"])


@claim(
    "tanks",
    "A recorded mass flow fills the measured tank",
    unseen=NOTHING_FITTED
    + "; 7.5 l and 8 W/K come from other runs of the rig; the delay of the flow meter, 1.3 s, was read from this "
    "recording",
    ours="{wall:.1f} kPa rms",
    theirs="{adiabatic:.1f} kPa adiabatic",
    when="the rms error is below that without heat flow",
    holds=lambda f: f["wall"] < f["adiabatic"],
    is_quick=True,
)
def filled_tank() -> Figures:
    rms = module("published.test_measured_tanks").filled()
    return {"wall": 1e-3 * rms(8.0), "adiabatic": 1e-3 * rms(0.0)}


@cache
def _equalised(*, free_walls: bool) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        return module("published.test_identify_real_data").equalised(Path(folder), free_walls=free_walls)


@claim(
    "tanks",
    "Ratio of two volumes from a fast equalisation",
    unseen="none: the end pressures, which give the other ratio, belong to the fitted recording",
    ours="{value:.3f} ({low:.3f} to {high:.3f}), {verdict}",
    theirs="0.540 from the end pressures",
    when="0.540 lies in the interval, and it is determined",
    holds=lambda f: f["low"] <= 0.540 <= f["high"] and f["verdict"] == "determined",
)
def equalised_ratio() -> Figures:
    return _interval(_equalised(free_walls=True).parameters["right.volume"], 7.5e-3)


@claim(
    "tanks",
    "Ratio of two volumes with assumed wall conductances and a recording that starts at the opening",
    unseen="none: the end pressures belong to the fitted recording",
    ours="{value:.2f} ({low:.2f} to {high:.2f}), {verdict}",
    theirs="0.540 from the end pressures",
    when="0.540 lies in the interval, and it is determined",
    holds=lambda f: f["low"] <= 0.540 <= f["high"] and f["verdict"] == "determined",
)
def equalised_ratio_guessed_walls() -> Figures:
    return _interval(_equalised(free_walls=False).parameters["right.volume"], 7.5e-3)


@claim(
    "tanks",
    "Conductance C of the valve from a fast equalisation",
    unseen="nothing: one recording, five samples of the flow",
    ours="{value:.2g} ({low:.2g} to {high:.2g}) m^3/(s Pa), {verdict}",
    theirs="not published",
    when="the verdict for C is determined",
    holds=lambda f: f["verdict"] == "determined",
)
def equalised_conductance() -> Figures:
    return _interval(_equalised(free_walls=True).parameters["valve.sonic_conductance"])


# --- Measured: a cylinder and a muscle -------------------------------------------------------------------------------


@claim(
    "cylinder",
    "C/V of a leak in a closed chamber",
    unseen="nothing: one recording",
    ours="{value:.2e} ({low:.2e} to {high:.2e}) 1/(s Pa)",
    theirs="{crude:.2e} by hand from first and last pressure",
    when="the interval contains the value by hand",
    holds=lambda f: f["low"] <= f["crude"] <= f["high"],
)
def leak() -> Figures:
    fits = module("published.test_identify_real_data")
    with tempfile.TemporaryDirectory() as folder:
        value, low, high = fits.leak_over_volume(Path(folder), "leak_aluminium.csv")
    return {"value": value, "low": low, "high": high, "crude": fits.crude_leak()}


@cache
def _friction() -> Any:
    tests = module("published.test_cylinder_friction")
    with tempfile.TemporaryDirectory() as folder:
        return tests.identify_page_file(Path(folder))


@claim(
    "cylinder",
    "Friction at 1, 3, 5 and 7 bar",
    unseen="nothing: four recordings, ten strokes each",
    ours="{found} N",
    theirs="{half} N: half of the force difference; published with the data: 5.3, 7.1, 8.4, 10.4 N",
    when="within 10 % of the published values. The pressure is higher during retraction, so the published values also "
    "contain a pressure force",
    holds=lambda f: np.allclose([float(x) for x in f["found"].split(", ")], [5.3, 7.1, 8.4, 10.4], rtol=0.1),
)
def friction_levels() -> Figures:
    rows = _friction().comparison["recordings"]
    return {
        name: ", ".join(f"{row[key]:.2f}" for row in rows)
        for name, key in (("found", "level"), ("half", "half_of_force"))
    }


@claim(
    "cylinder",
    "Friction law from pull tests",
    unseen="each recording in turn",
    ours="Coulomb {value:.1f} N ({low:.1f} to {high:.1f}), {verdict}; {open_numbers} other parameters not determined",
    theirs="not published",
    when="all parameters are determined",
    holds=lambda f: f["verdict"] == "determined" and f["open_numbers"] == 0,
)
def friction_law() -> Figures:
    result = _friction()
    (coulomb,) = [e for name, e in result.parameters.items() if name.endswith("coulomb_force")]
    undetermined = [
        n for n in result.remarks if n.code == "friction.bounded" and n.facts["verdict"] == "not determined"
    ]
    return {**_interval(coulomb), "open_numbers": len(undetermined)}


@claim(
    "muscle",
    "Muscle of the library versus its measured force map",
    unseen="nothing: its six parameters are fitted to this map",
    ours="{rms:.1f} N rms, {share:.2f} % of the largest force; worst point {worst:.0f} N",
    theirs="braid of Chou & Hannaford, fitted to the same points: {braid:.1f} %",
    when="below 1 %",
    holds=lambda f: f["share"] < 1.0,
    is_quick=True,
)
def muscle_map() -> Figures:
    tests = module("published.test_muscle_map")
    error, force = tests.library_errors()
    braid = next(row for row in _muscle().comparison["forces"] if row["law"] == "chou_hannaford")
    rms = _rms(error)
    return {
        "rms": rms,
        "share": 100.0 * rms / force.max(),
        "worst": np.max(np.abs(error)),
        "braid": 100.0 * braid["rms_of_largest"],
    }


@cache
def _muscle() -> Any:
    tests = module("published.test_muscle_map")
    return tests.identified_muscle()


@claim(
    "muscle",
    "Prediction of validation points of the map by the law of Sarosi",
    unseen="each row of pressures or contractions in turn",
    ours="{sarosi:.2f} % of the largest force",
    theirs="straight lines {table:.1f} %, Tondu & Lopez {tondu_lopez:.1f} %, Chou & Hannaford {chou_hannaford:.1f} %",
    when="the error is below that of each other law",
    holds=lambda f: f["sarosi"] < min(f["table"], f["tondu_lopez"], f["chou_hannaford"]),
    is_quick=True,
)
def muscle_held_out() -> Figures:
    return {row["law"]: 100.0 * row["held_out_of_largest"] for row in _muscle().comparison["forces"]}


@claim(
    "muscle",
    "Sarosi's law is also better between pressures",
    unseen="a pressure at a time",
    ours="{sarosi:.1f} N rms",
    theirs="straight lines between rows {table:.1f} N",
    when="the error is below that of straight lines",
    holds=lambda f: f["sarosi"] < f["table"],
    is_quick=True,
)
def muscle_between_pressures() -> Figures:
    return {
        row["law"]: row["held_out_by_pressure"]
        for row in _muscle().comparison["forces"]
        if row["law"] in ("sarosi", "table")
    }


# --- Measured: regulators --------------------------------------------------------------------------------------------


def _regulator(bench: str, number: int) -> Figures:
    """Return the worst validation window: NRMSE of circuit and linear models [%]."""
    tests = module("published.test_real_regulators")
    names = {tests.GREY_BOX: "circuit", tests.FIRST_ORDER: "first_order", tests.ARX: "arx", "ARX, one step": "one_step"}
    windows = [{names[k]: 100.0 * v for k, v in window.items()} for window in tests.windows(bench, number)]
    return {**max(windows, key=lambda window: float(window["circuit"])), "windows": len(windows)}


def _regulators(source: str, bench: str, number: int, title: str) -> None:
    def measure() -> Figures:
        return _regulator(bench, number)

    measure.__name__ = f"{bench}_{number}"
    claim(
        source,
        title,
        unseen="{windows} windows, of which the worst is shown; the model structure was selected with knowledge of "
        "them",
        ours="{circuit:.2f} % NRMSE",
        theirs="first order with dead time {first_order:.2f} %, ARX {arx:.2f} %",
        when="the NRMSE is below that of both linear models",
        holds=lambda f: f["circuit"] < min(f["first_order"], f["arx"]),
        rounding=0.05,
    )(measure)


for channel in (1, 2, 4, 5):
    _regulators("softarm", "itv0050", channel, f"Regulator, channel {channel}: free run on validation windows")
for record in (1, 5):
    _regulators(
        "lung", "test_lung", record, f"Solenoid with a test lung, recording {record}: free run on validation breaths"
    )


@claim(
    "softarm",
    "Regulator, channel 5: one-step prediction",
    unseen="4 windows, of which the one with the worst free run is shown",
    ours="{circuit:.2f} % NRMSE in a free run",
    theirs="ARX with all previous measured samples {one_step:.2f} %",
    when="the NRMSE is below that of ARX. A linear model is sufficient for one-step prediction",
    holds=lambda f: f["circuit"] < f["one_step"],
    rounding=0.05,
)
def itv0050_one_step() -> Figures:
    return _regulator("itv0050", 5)


def _other_days(channel: int) -> Figures:
    """Return mean NRMSE [%] of files from other days, and the number of files with a better linear model."""
    days = module("days")
    recordings = days.recordings(Path(str(DAYS)), channel)
    scores, anew = days.judged(channel, recordings)
    all_scores = [s for own in scores.values() for s in own]
    by_file: dict[str, dict[str, float]] = {}
    for score in all_scores:
        by_file.setdefault(score.response, {})[score.model] = 100.0 * score.nrmse
    linear = [min(models[days.FIRST_ORDER], models[days.ARX]) for models in by_file.values()]
    own = [models[days.GREY_BOX] for models in by_file.values()]
    return {
        "circuit": float(np.mean(own)),
        "linear": float(np.mean(linear)),
        "files": len(own),
        "behind": int(np.sum(np.array(own) > np.array(linear))),
        "days": len(scores),
        "anew": 100.0 * float(np.mean([value for values in anew.values() for value in values])),
    }


def _on_other_days(channel: int) -> None:
    def measure() -> Figures:
        return _other_days(channel)

    measure.__name__ = f"other_days_{channel}"
    claim(
        "days",
        f"Regulator, channel {channel}: the same parameters on other days and step heights",
        unseen="all {files} files; the fit used 20 s of another file",
        ours="{circuit:.1f} % mean NRMSE, worse than the linear model on {behind} of {files} files; {anew:.1f} % "
        "after a refit of two steady-state parameters",
        theirs="better linear model of each file: {linear:.1f} % mean NRMSE",
        when="better than the linear model on every file",
        holds=lambda f: f["behind"] == 0,
        rounding=0.05,
    )(measure)


for channel in (1, 2, 4, 5):
    _on_other_days(channel)

# --- The paper -------------------------------------------------------------------------------------------------------


@cache
def _paper() -> Any:
    return module("poppet.report.varga2012.runs").run_simulations(lambda step: None)


@claim(
    "paper",
    "Temperature rise of the isentropic tank at 5 bar",
    unseen=NONE_NEEDED,
    ours="{isentrope:.0f} K by the paper's equations, {adiabatic:.0f} K by the energy balance",
    theirs="{reported:.0f} K reported",
    when="the difference is below 50 % of the reported value. The measured tank loses heat to its wall, which the "
    "paper omits",
    holds=lambda f: abs(f["isentrope"] - f["reported"]) < 0.5 * f["reported"],
)
def paper_warming() -> Figures:
    (statement,) = [
        s for s in module("poppet.report.varga2012.paper").statements(_paper()) if s.code == "paper.warming"
    ]
    return {name: statement.facts[name] for name in ("isentrope", "adiabatic", "reported")}


@claim(
    "paper",
    "Recomputed statements of the paper",
    unseen=NONE_NEEDED,
    ours="{holds} confirmed, {fails} not confirmed, {open} undecided",
    theirs="{count} statements",
    when="all are confirmed",
    holds=lambda f: f["holds"] == f["count"],
)
def paper_statements() -> Figures:
    module_ = module("poppet.report.varga2012.paper")
    verdicts = [s.verdict.name.lower() for s in module_.statements(_paper())]
    return {"count": len(verdicts), **{name: verdicts.count(name) for name in ("holds", "fails", "open")}}


# --- Independent codes -----------------------------------------------------------------------------------------------


def _cantera(names: Sequence[str]) -> Iterator[float]:
    tests = module("cross.test_cantera")
    for name in names:
        for conductance in tests.CONDUCTANCES:
            yield getattr(tests, name)(conductance)


@claim(
    "cantera",
    "Filling, emptying and equalising tanks, with and without wall heat flow",
    unseen=NONE_NEEDED,
    ours="{worst:.1e} apart in pressure, temperature and mass",
    theirs="relative tolerance 1e-9 asked",
    when="within 2e-8",
    holds=lambda f: f["worst"] < 2e-8,
    rounding=2.0,
    is_quick=True,
)
def cantera_tanks() -> Figures:
    return {"worst": max(_cantera(("charging", "discharging", "equalising")))}


@claim(
    "cantera",
    "Two cylinder chambers with sinusoidal motion, open and closed",
    unseen=NONE_NEEDED,
    ours="{worst:.1e} apart in pressure, temperature and mass",
    theirs="relative tolerance 1e-9 asked",
    when="within 2e-6",
    holds=lambda f: f["worst"] < 2e-6,
    rounding=2.0,
)
def cantera_cylinder() -> Figures:
    tests = module("cross.test_cantera_moving_walls")
    return {"worst": max(run(c) for run in (tests.closed_run, tests.open_run) for c in (0.0, 0.5))}


@claim(
    "lsoda",
    "The staircase of the paper: main stage and tank with wall heat, 120 s",
    unseen=NONE_NEEDED,
    ours="{worst:.1e} apart in pressure, at the default tolerance",
    theirs="LSODA at 1e-10",
    when="within 1e-5",
    holds=lambda f: f["worst"] < 1e-5,
    rounding=2.0,
)
def lsoda_staircase() -> Figures:
    bench, peer = module("staircase"), module("peer")
    circuit = bench.loads(bench.CIRCUIT)
    reference = peer.peer_run(peer.peer_rates(circuit.parameters), peer.START, 1e-10)[2]
    return {"worst": np.max(np.abs(circuit.simulate()["tank.pressure"] / reference - 1.0))}


@claim(
    "lsoda",
    "Cylinder that lifts 4 kg against dry friction, 2 s",
    unseen=NONE_NEEDED,
    ours="{worst:.1e} of the stroke apart, at the default tolerance",
    theirs="LSODA at 1e-9",
    when="within 1e-5",
    holds=lambda f: f["worst"] < 1e-5,
    rounding=2.0,
)
def lsoda_cylinder() -> Figures:
    bench, peer = module("loads"), module("loads_peer")
    reference = peer.peer_run(1e-9)[4]
    position = bench.loads(bench.CIRCUIT).simulate()["slide.position"]
    return {"worst": np.max(np.abs(position - reference)) / bench.STROKE}


@claim(
    "cvodes",
    "Gas states of two tanks and of a switched tank with another integrator",
    unseen=NONE_NEEDED,
    ours="{worst:.1e} apart in pressure, temperature and mass",
    theirs="CVODES at 1e-8. The equations are the same, so the comparison tests only the integrator",
    when="within 1e-6",
    holds=lambda f: f["worst"] < 1e-6,
    rounding=2.0,
    is_quick=True,
)
def cvodes_tanks() -> Figures:
    tests = module("cross.test_solvers_agree")
    worst = 0.0
    for circuit in (tests.two_tanks, tests.pulsed_tank):
        kernel_run, reference = (
            tests.kernel_run(circuit),
            circuit().simulate(relative_tolerance=tests.TOLERANCE, solver="cvodes"),
        )
        gas = [name for name, unit in zip(kernel_run.names, kernel_run.units, strict=True) if unit in ("Pa", "K", "kg")]
        worst = max(worst, *(float(np.max(np.abs(reference[name] / kernel_run[name] - 1.0))) for name in gas))
    return {"worst": worst}


@claim(
    "fmpy",
    "FMUs of two tanks and of a valve with a tank, in another simulator",
    unseen=NONE_NEEDED,
    ours="{cosimulation:.1e} from the kernel in co-simulation, {exchange:.1e} in model exchange",
    theirs="FMPy, with CVODE in model exchange. The equations are the same, so the comparison tests only the export",
    when="within 1e-10 and 1e-5",
    holds=lambda f: f["cosimulation"] < 1e-10 and f["exchange"] < 1e-5,
    rounding=2.0,
)
def fmpy_host() -> Figures:
    fmus, worst = module("unit.deploy.fmus"), {"fmu cs": 0.0, "fmu me": 0.0}
    for name, duration in (("two_tanks", None), ("fill_staircase", 30.0)):
        for kind in worst:
            row = fmus.held(fmus.built(name, 2, duration), fmus.example(name, duration), kind)
            worst[kind] = max(worst[kind], row.overall)
    return {"cosimulation": worst["fmu cs"], "exchange": worst["fmu me"]}


@claim(
    "control",
    "Margins of a tuned pressure loop",
    unseen=NONE_NEEDED,
    ours="{ours_gain:.3f} gain margin, {ours_phase:.2f} deg phase margin",
    theirs="{theirs_gain:.3f}, {theirs_phase:.2f} deg",
    when="within 0.1 %",
    holds=lambda f: all(abs(f[f"ours_{k}"] / f[f"theirs_{k}"] - 1.0) < 1e-3 for k in ("gain", "phase")),
)
def control_margins() -> Figures:
    tests = module("cross.test_python_control")
    control, (plant, gains) = module("control"), tests.tuned_loop()
    gain, phase = tests.their_margins(control, plant, gains)[:2]
    result = tests.margins(plant, gains)
    return {
        "ours_gain": result.gain_margin,
        "ours_phase": result.phase_margin,
        "theirs_gain": gain,
        "theirs_phase": phase,
    }


@claim(
    "eos",
    "Real-gas deviation in the notes of a run",
    unseen=NONE_NEEDED,
    ours="error of the estimate at most {share:.0f} % of the deviation, in {states} states of 8 gases up to 200 bar",
    theirs="Z and critical flow factor by the reference equations",
    when="within 20 % of the larger deviation (and 0.05 %)",
    holds=lambda f: f["outside"] == 0,
    is_quick=True,
)
def real_gases() -> Figures:
    tests = module("published.test_real_gases")
    off = np.array([[abs(e) for e in tests.errors(*state)] for state in tests.STATES])
    larger, miss = off[:, 0], off[:, 1]
    return {"share": 100.0 * np.max(miss[larger > 0.01] / larger[larger > 0.01]), "states": len(off),
            "outside": int(np.sum(miss > 0.2 * larger + 5e-4))}  # fmt: skip


# --- Closed forms ----------------------------------------------------------------------------------------------------


@claim(
    "closed",
    "Discharge and charging of a tank, isothermal and adiabatic",
    unseen=NONE_NEEDED,
    ours="{worst:.1e} apart in pressure",
    theirs="closed forms; tolerance 1e-9 asked",
    when="within 1e-8",
    holds=lambda f: f["worst"] < 1e-8,
    rounding=2.0,
    is_quick=True,
)
def closed_tanks() -> Figures:
    tests = module("exact.test_closed_forms")
    out = {
        k: tests.discharge(k).simulate(2.0 * tests.TAU, 0.01 * tests.TAU, tests.TOLERANCE)
        for k in ("isothermal", "energy")
    }
    into = {
        k: tests.charging(k).simulate(1.5 / tests.RATE, 0.01 / tests.RATE, tests.TOLERANCE)
        for k in ("isothermal", "energy")
    }
    worst = []
    for k, law in (
        ("isothermal", tests.tanks.isothermal_discharge_pressure),
        ("energy", tests.tanks.adiabatic_discharge_pressure),
    ):
        p = out[k]["tank.pressure"]
        choked = p * tests.B >= tests.LOW
        worst.append(tests.worst(p[choked], law(out[k].time[choked], tests.HIGH, tests.TAU)))
    for k, speed in (("isothermal", 1.0), ("energy", 1.4)):
        p = into[k]["tank.pressure"]
        is_filling = p <= 0.999 * tests.HIGH
        expected = tests.tanks.charging_pressure(
            into[k].time[is_filling], tests.LOW, tests.HIGH, tests.B, speed * tests.RATE
        )
        worst.append(tests.worst(p[is_filling], expected))
    return {"worst": max(worst)}


@claim(
    "closed",
    "Wave in a tube at the speed of sound",
    unseen=NONE_NEEDED,
    ours="arrives after {late:.3f} L/c, 12 cells",
    theirs="1 L/c",
    when="within 3 %",
    holds=lambda f: abs(f["late"] - 1.0) < 0.03,
)
def closed_tube() -> Figures:
    return {"late": module("exact.test_tube").arrival(12, 0.5)}


@claim(
    "tanktests",
    "Coverage of the 95 % confidence intervals for C, b and wall conductance",
    unseen="the true values",
    ours="{C} of {C_said}, {b} of {b_said} and {hA} of {hA_said} determined values, in {tests} tests",
    theirs="95 of 100",
    when="each count is consistent with a coverage of 93 to 98 % at a significance of 0.1 %",
    holds=lambda f: all(_is_sound(f[name], f[f"{name}_said"]) for name in ("C", "b", "hA")),
)
def tank_intervals() -> Figures:
    tests = module("exact.test_independent_coverage")
    answers, figures = [tests.answer(seed) for seed in range(TANK_TESTS)], {"tests": TANK_TESTS}
    for name in tests.NAMES:
        determined = [answer for answer in answers if answer.found[name].verdict == "determined"]
        figures |= {name: sum(answer.holds(name) for answer in determined), f"{name}_said": len(determined)}
    return figures


def _is_sound(contained: int, count: int) -> bool:
    """Return True if the count is consistent with 95 % intervals."""
    low, high = module("exact.test_independent_coverage").bounds(count)
    return bool(low <= contained <= high)


@claim(
    "tanktests",
    "No false verdict for a charge test with two equivalent optima",
    unseen="the true values",
    ours="{determined} of {twins} with the verdict determined",
    theirs="0: an adiabatic tank and an isothermal tank with 1.4 C have the same pressure",
    when="the count is 0",
    holds=lambda f: f["determined"] == 0,
)
def tank_twins() -> Figures:
    tests = module("exact.test_independent_coverage")
    twins = [seed for seed in range(TANK_TESTS) if tests.drawn(seed).has_twin]
    return {"twins": len(twins), "determined": len(tests.twins_called_determined(TANK_TESTS))}


@claim(
    "leaktests",
    "Coverage of the intervals with the default uncertainty budget, for tanks that leak",
    unseen="the true values",
    ours="{C} of {C_said}, {b} of {b_said} and {hA} of {hA_said} determined values, in {tests} tests; none is more "
    "than five standard errors off",
    theirs="at least 93 of 100",
    when="each count is consistent with a coverage of at least 93 % at a significance of 0.1 %",
    holds=lambda f: all(_is_covered(f[name], f[f"{name}_said"]) for name in ("C", "b", "hA")),
)
def leaking_tanks() -> Figures:
    covered = module("exact.test_thermal_limits").random_coverage(TANK_TESTS)
    figures: Figures = {"tests": TANK_TESTS}
    for name, values in zip(("C", "b", "hA"), covered.values(), strict=True):
        figures |= {name: sum(values), f"{name}_said": len(values)}
    return figures


def _is_covered(contained: int, count: int) -> bool:
    """Return True if the count is consistent with intervals of at least 93 %."""
    return bool(contained >= module("exact.test_independent_coverage").bounds(count)[0])


@claim(
    "benchtests",
    "Coverage of the 95 % confidence intervals of flow benches",
    unseen="the true values",
    ours="{covered} of {determined} determined values of C and b, in {benches} benches of five kinds",
    theirs="95 of 100",
    when="the count is consistent with a coverage of 93 to 98 % at a significance of 0.1 %",
    holds=lambda f: _is_sound(f["covered"], f["determined"]),
)
def flow_intervals() -> Figures:
    tests = module("exact.test_independent_flow_benches")
    kinds = (*tests.CALIBRATED, "scatter unknown", "few points")
    counts = [tests.counts_of(kind, range(8000, 8000 + FLOW_BENCHES)) for kind in kinds]
    determined, covered = (sum(row[k] for row in counts) for k in (0, 1))
    return {"benches": FLOW_BENCHES * len(kinds), "determined": determined, "covered": covered}


@claim(
    "benchtests",
    "Coverage of the 95 % bands of C(x) and b(x) by splines",
    unseen="the true curves",
    ours="C(x) {C:.1f} % and b(x) {b:.1f} % of the tested range, in {valves} valves of six shapes",
    theirs="95 %",
    when="both are from 93 to 98 %",
    holds=lambda f: all(93.0 <= f[name] <= 98.0 for name in ("C", "b")),
)
def spline_bands() -> Figures:
    tests = module("exact.test_stiff_splines")
    fractions = [tests.bands_of(shape, range(3000, 3000 + SPLINES))[0] for shape in tests.SHAPES]
    conductance, ratio = (100.0 * np.mean(fractions, axis=0)).tolist()
    return {"valves": SPLINES * len(fractions), "C": conductance, "b": ratio}


def _rms(error: Any) -> float:
    return float(np.sqrt(np.mean(np.square(error))))


def _interval(estimate: Any, per: float = 1.0) -> Figures:
    return {**{k: getattr(estimate, k) / per for k in ("value", "low", "high")}, "verdict": estimate.verdict}
