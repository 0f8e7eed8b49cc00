"""What is claimed of this program, and how each claim is measured anew; `validate.py` keeps the figures.

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
"""Numbers and words by name, as a run gives them."""


@dataclass(frozen=True)
class Source:
    """Who made what a claim is compared with."""

    name: str
    licence: str
    files: Path | None = None  # measured data, which are not in the repository
    link: str = ""
    package: str = ""  # the independent code, for its version

    @property
    def is_here(self) -> bool:
        """Whether a claim can be measured here."""
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
    "eos": Source(
        "Reference equations of state, values by CoolProp 8.0 (Lemmon et al. 2000, Span & Wagner 1996 and others)",
        "MIT; figures quoted",
    ),
}


@dataclass(frozen=True)
class Claim:
    """One line of the page. `ours` and `theirs` are formats of the figures; `rounding` is relative."""

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
    """Declare what a function measures."""

    def declared(measure: Callable[[], Figures]) -> Callable[[], Figures]:
        CLAIMS[measure.__name__] = Claim(measure.__name__, title, source, measure=measure, **more)
        return measure

    return declared


def module(name: str) -> Any:
    """A module of tests, benchmarks or examples."""
    return importlib.import_module(name)


TANK_TESTS = 100
"""Of the 300 that `tests/exact/test_independent_coverage.py` runs."""
NOTHING_FITTED = "all of it: nothing was fitted"
NONE_NEEDED = "not asked: no fit"

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
    unseen=NOTHING_FITTED + "; Nu = 0.13 Ra^(1/3) is the textbook's",
    ours="{ours:.1f} kPa rms",
    theirs="{adiabatic:.1f} kPa adiabatic, {isothermal:.1f} kPa isothermal",
    when="nearer than the better textbook limit",
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
    """The fit of the discharge with pressure and temperature."""
    fits = module("published.test_identify_real_data")
    with tempfile.TemporaryDirectory() as folder:
        fits.write(Path(folder), "vessel.toml", fits.VESSEL)
        return fits.identify_fit(fits.write(Path(folder), "fit.toml", fits.DISCHARGE))


@claim(
    "vessel",
    "A fit of the discharge finds the coefficient of its bore",
    unseen="nothing: one recording",
    ours="{value:.3f} ({low:.3f} to {high:.3f})",
    theirs="0.84 published",
    when="0.84 lies in the interval. An error of the bore counts twice, and the wall is one number: the interval holds "
    "noise and not these, so 2.6 % more is no proof against 0.84",
    holds=lambda f: f["low"] <= 0.84 <= f["high"],
)
def discharge_coefficient() -> Figures:
    conductance = _discharge().parameters["outlet.sonic_conductance"]
    area = importlib.import_module("poppet.iso6358").conductance_from_effective_area(np.pi / 4.0 * 2.71e-3**2)
    return {k: getattr(conductance, k) / area.sonic_conductance for k in ("value", "low", "high")}


@claim(
    "vessel",
    "A fit of the discharge finds the prefactor of free convection",
    unseen="nothing: one recording",
    ours="{value:.3f} ({low:.3f} to {high:.3f})",
    theirs="0.13 in textbooks",
    when="0.13 lies in the interval",
    holds=lambda f: f["low"] <= 0.13 <= f["high"],
)
def discharge_nusselt() -> Figures:
    return _interval(_discharge().parameters["tank.nusselt_prefactor"])


@claim(
    "vessel",
    "A fit of the discharge finds the critical pressure ratio b",
    unseen="nothing: one recording",
    ours="{value:.2f} ({low:.2f} to {high:.2f}), {verdict}",
    theirs="not published; the tail of this record does not say it",
    when="b is determined",
    holds=lambda f: f["verdict"] == "determined",
)
def discharge_ratio() -> Figures:
    return _interval(_discharge().parameters["outlet.critical_ratio"])


@claim(
    "tanks",
    "A recorded mass flow fills the measured tank",
    unseen=NOTHING_FITTED
    + "; 7.5 l and 8 W/K are those of other runs of the rig, the flow meter's 1.3 s were seen here",
    ours="{wall:.1f} kPa rms",
    theirs="{adiabatic:.1f} kPa adiabatic",
    when="nearer than without heat",
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
    "A fast equalisation gives the ratio of two volumes",
    unseen="the end pressures, from which the other ratio follows, are in the fitted record",
    ours="{value:.3f} ({low:.3f} to {high:.3f}), {verdict}",
    theirs="0.540 from the end pressures",
    when="0.540 lies in the interval, and it is determined",
    holds=lambda f: f["low"] <= 0.540 <= f["high"] and f["verdict"] == "determined",
)
def equalised_ratio() -> Figures:
    return _interval(_equalised(free_walls=True).parameters["right.volume"], 7.5e-3)


@claim(
    "tanks",
    "The ratio of two volumes, walls held at a guess and the record cut at the opening",
    unseen="the end pressures are in the fitted record",
    ours="{value:.2f} ({low:.2f} to {high:.2f}), {verdict}",
    theirs="0.540 from the end pressures",
    when="0.540 lies in the interval, and it is determined",
    holds=lambda f: f["low"] <= 0.540 <= f["high"] and f["verdict"] == "determined",
)
def equalised_ratio_guessed_walls() -> Figures:
    return _interval(_equalised(free_walls=False).parameters["right.volume"], 7.5e-3)


@claim(
    "tanks",
    "A fast equalisation gives the conductance C of its valve",
    unseen="nothing: one recording, five samples of the flow",
    ours="{value:.2g} ({low:.2g} to {high:.2g}) m^3/(s Pa), {verdict}",
    theirs="not published",
    when="C is determined",
    holds=lambda f: f["verdict"] == "determined",
)
def equalised_conductance() -> Figures:
    return _interval(_equalised(free_walls=True).parameters["valve.sonic_conductance"])


# --- Measured: a cylinder and a muscle -------------------------------------------------------------------------------


@claim(
    "cylinder",
    "A leak of a closed chamber gives C/V",
    unseen="nothing: one recording",
    ours="{value:.2e} ({low:.2e} to {high:.2e}) 1/(s Pa)",
    theirs="{crude:.2e} from first and last pressure by hand",
    when="the value by hand lies in the interval",
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
        return tests.identified(Path(folder))


@claim(
    "cylinder",
    "Friction at 1, 3, 5 and 7 bar",
    unseen="nothing: four recordings, ten strokes each",
    ours="{found} N",
    theirs="{half} N: halves of the difference of the forces, as published with the data 5.3, 7.1, 8.4, 10.4 N",
    when="within 10 % of the halves. It is not: the pressure is higher while the piston is pulled in, and that part of "
    "the halves is no friction",
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
    "The pulls give the friction's law",
    unseen="recordings left out in turn",
    ours="Coulomb {value:.1f} N ({low:.1f} to {high:.1f}), {verdict}; {open_numbers} other numbers not determined",
    theirs="not published",
    when="all is determined",
    holds=lambda f: f["verdict"] == "determined" and f["open_numbers"] == 0,
)
def friction_law() -> Figures:
    result = _friction()
    (coulomb,) = [e for name, e in result.parameters.items() if name.endswith("coulomb_force")]
    said = [n for n in result.remarks if n.code == "friction.bounded" and n.facts["verdict"] == "not determined"]
    return {**_interval(coulomb), "open_numbers": len(said)}


@claim(
    "muscle",
    "The library's muscle follows its measured map",
    unseen="nothing: its six numbers are fitted to this map",
    ours="{rms:.1f} N rms, {share:.2f} % of the largest force; worst point {worst:.0f} N",
    theirs="braid of Chou & Hannaford, fitted to the same points: {braid:.1f} %",
    when="under 1 %",
    holds=lambda f: f["share"] < 1.0,
    is_quick=True,
)
def muscle_map() -> Figures:
    tests = module("published.test_muscle_map")
    error, force = tests.misses()
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
    return tests.identified()


@claim(
    "muscle",
    "Sarosi's law predicts what is held out of the map",
    unseen="a row of pressures or of contractions at a time",
    ours="{sarosi:.2f} % of the largest force",
    theirs="straight lines {table:.1f} %, Tondu & Lopez {tondu_lopez:.1f} %, Chou & Hannaford {chou_hannaford:.1f} %",
    when="better than every other law",
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
    when="better than straight lines",
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
    """The worst held-out window: NRMSE of circuit and linear models in per cent."""
    tests = module("published.test_real_regulators")
    names = {tests.GREY_BOX: "circuit", tests.FIRST_ORDER: "first_order", tests.ARX: "arx", "ARX, one step": "one_step"}
    found = [{names[k]: 100.0 * v for k, v in window.items()} for window in tests.windows(bench, number)]
    return {**max(found, key=lambda window: float(window["circuit"])), "windows": len(found)}


def _regulators(source: str, bench: str, number: int, title: str) -> None:
    def measure() -> Figures:
        return _regulator(bench, number)

    measure.__name__ = f"{bench}_{number}"
    claim(
        source,
        title,
        unseen="{windows} windows, of which the worst is shown; the structure was chosen while looking at them",
        ours="{circuit:.2f} % NRMSE",
        theirs="first order with dead time {first_order:.2f} %, ARX {arx:.2f} %",
        when="better than both linear models",
        holds=lambda f: f["circuit"] < min(f["first_order"], f["arx"]),
        rounding=0.05,
    )(measure)


for channel in (1, 2, 4, 5):
    _regulators("softarm", "itv0050", channel, f"Regulator, channel {channel}: free run on held-out windows")
for record in (1, 5):
    _regulators("lung", "test_lung", record, f"Solenoid at a lung, recording {record}: free run on held-out breaths")


@claim(
    "softarm",
    "Regulator, channel 5: one step ahead",
    unseen="4 windows, of which that with the worst free run is shown",
    ours="{circuit:.2f} % NRMSE, running freely",
    theirs="ARX with every measured sample at hand {one_step:.2f} %",
    when="better than ARX. To predict one sample, a linear model is enough",
    holds=lambda f: f["circuit"] < f["one_step"],
    rounding=0.05,
)
def itv0050_one_step() -> Figures:
    return _regulator("itv0050", 5)


def _other_days(channel: int) -> Figures:
    """Over files of other days: mean NRMSE in per cent, and on how many files the circuit is behind."""
    days = module("days")
    found = days.recordings(Path(str(DAYS)), channel)
    scores, anew = days.judged(channel, found)
    each = [s for own in scores.values() for s in own]
    by_file: dict[str, dict[str, float]] = {}
    for score in each:
        by_file.setdefault(score.response, {})[score.model] = 100.0 * score.nrmse
    linear = [min(one[days.FIRST_ORDER], one[days.ARX]) for one in by_file.values()]
    own = [one[days.GREY_BOX] for one in by_file.values()]
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
        f"Regulator, channel {channel}: the same numbers on other days and step heights",
        unseen="all: {files} files, fitted on 20 s of another file",
        ours="{circuit:.1f} % NRMSE, behind on {behind} of {files} files; {anew:.1f} % with two steady numbers anew",
        theirs="better linear model of each file {linear:.1f} %",
        when="ahead on every file",
        holds=lambda f: f["behind"] == 0,
        rounding=0.05,
    )(measure)


for channel in (1, 2, 4, 5):
    _on_other_days(channel)

# --- The paper -------------------------------------------------------------------------------------------------------


@cache
def _paper() -> Any:
    return module("poppet.report.varga2012.runs").find(lambda step: None)


@claim(
    "paper",
    "Warming of the isentropic tank at 5 bar",
    unseen=NONE_NEEDED,
    ours="{isentrope:.0f} K by the paper's equations, {adiabatic:.0f} K by the energy balance",
    theirs="{reported:.0f} K reported",
    when="within half of what is reported. The measured tank loses heat to its wall, which the paper leaves out",
    holds=lambda f: abs(f["isentrope"] - f["reported"]) < 0.5 * f["reported"],
)
def paper_warming() -> Figures:
    (said,) = [
        s for s in module("poppet.report.varga2012.statements").statements(_paper()) if s.code == "paper.warming"
    ]
    return {name: said.facts[name] for name in ("isentrope", "adiabatic", "reported")}


@claim(
    "paper",
    "Statements of the paper, recomputed",
    unseen=NONE_NEEDED,
    ours="{holds} hold, {fails} do not, {open} cannot be told",
    theirs="{count} statements",
    when="all hold",
    holds=lambda f: f["holds"] == f["count"],
)
def paper_statements() -> Figures:
    said = module("poppet.report.varga2012.statements")
    found = [s.verdict.name.lower() for s in said.statements(_paper())]
    return {"count": len(found), **{name: found.count(name) for name in ("holds", "fails", "open")}}


# --- Independent codes -----------------------------------------------------------------------------------------------


def _cantera(names: Sequence[str]) -> Iterator[float]:
    tests = module("cross.test_cantera")
    for name in names:
        for conductance in tests.CONDUCTANCES:
            yield getattr(tests, name)(conductance)


@claim(
    "cantera",
    "Tanks that fill, empty and equalise, with and without wall heat",
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
    "A cylinder's two chambers, driven as a sine, open and closed",
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
    other = peer.peer_run(peer.peer_rates(circuit.parameters), peer.START, 1e-10)[2]
    return {"worst": np.max(np.abs(circuit.simulate()["tank.pressure"] / other - 1.0))}


@claim(
    "lsoda",
    "A cylinder lifts 4 kg against dry friction, 2 s",
    unseen=NONE_NEEDED,
    ours="{worst:.1e} of the stroke apart, at the default tolerance",
    theirs="LSODA at 1e-9",
    when="within 1e-5",
    holds=lambda f: f["worst"] < 1e-5,
    rounding=2.0,
)
def lsoda_cylinder() -> Figures:
    bench, peer = module("loads"), module("loads_peer")
    other = peer.peer_run(1e-9)[4]
    own = bench.loads(bench.CIRCUIT).simulate()["slide.position"]
    return {"worst": np.max(np.abs(own - other)) / bench.STROKE}


@claim(
    "cvodes",
    "Gas states of two tanks and of a switched tank by another integrator",
    unseen=NONE_NEEDED,
    ours="{worst:.1e} apart in pressure, temperature and mass",
    theirs="CVODES at 1e-8. The equations are the same ones: this tests the integrator alone",
    when="within 1e-6",
    holds=lambda f: f["worst"] < 1e-6,
    rounding=2.0,
    is_quick=True,
)
def cvodes_tanks() -> Figures:
    tests = module("cross.test_solvers_agree")
    worst = 0.0
    for circuit in (tests.two_tanks, tests.pulsed_tank):
        own, other = tests.kernel_run(circuit), circuit().simulate(relative_tolerance=tests.TOLERANCE, solver="cvodes")
        gas = [name for name, unit in zip(own.names, own.units, strict=True) if unit in ("Pa", "K", "kg")]
        worst = max(worst, *(float(np.max(np.abs(other[name] / own[name] - 1.0))) for name in gas))
    return {"worst": worst}


@claim(
    "fmpy",
    "An FMU of two tanks and of a valve that fills one, in a host",
    unseen=NONE_NEEDED,
    ours="{cosimulation:.1e} from the kernel in co-simulation, {exchange:.1e} in model exchange",
    theirs="FMPy, by CVODE in model exchange. The equations are the exported ones: this tests export and host",
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
    own = tests.margins(plant, gains)
    return {"ours_gain": own.gain_margin, "ours_phase": own.phase_margin, "theirs_gain": gain, "theirs_phase": phase}


@claim(
    "eos",
    "How far a gas is from ideal, as the notes of a run say it",
    unseen=NONE_NEEDED,
    ours="at most {share:.0f} % of the error itself off, {states} states of 8 gases to 200 bar",
    theirs="Z and critical flow factor by the reference equations",
    when="within a fifth of the larger error (and 0.05 %)",
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
        before = p <= 0.999 * tests.HIGH
        expected = tests.tanks.charging_pressure(
            into[k].time[before], tests.LOW, tests.HIGH, tests.B, speed * tests.RATE
        )
        worst.append(tests.worst(p[before], expected))
    return {"worst": max(worst)}


@claim(
    "closed",
    "A wave passes a tube at the speed of sound",
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
    "Intervals of 95 % for C, b and wall heat hold the truth",
    unseen="the truth, which no fit was told",
    ours="{C} of {C_said}, {b} of {b_said} and {hA} of {hA_said} that are called determined, in {tests} tests",
    theirs="95 of 100",
    when="the counts are those of intervals that hold 93 to 98 %, but for a chance of 0.1 % each",
    holds=lambda f: all(_is_sound(f[name], f[f"{name}_said"]) for name in ("C", "b", "hA")),
)
def tank_intervals() -> Figures:
    tests = module("exact.test_independent_coverage")
    answers, figures = [tests.answer(seed) for seed in range(TANK_TESTS)], {"tests": TANK_TESTS}
    for name in tests.NAMES:
        sure = [each for each in answers if each.found[name].verdict == "determined"]
        figures |= {name: sum(each.holds(name) for each in sure), f"{name}_said": len(sure)}
    return figures


def _is_sound(held: int, count: int) -> bool:
    """Whether so many of a count are what intervals of 95 % would hold."""
    low, high = module("exact.test_independent_coverage").bounds(count)
    return bool(low <= held <= high)


@claim(
    "tanktests",
    "What one recording cannot tell is not called determined: a charge with two answers",
    unseen="the truth, which no fit was told",
    ours="{determined} of {twins} called determined",
    theirs="none can be: an adiabatic tank and an isothermal one with 1.4 C have the same pressure",
    when="none is",
    holds=lambda f: f["determined"] == 0,
)
def tank_twins() -> Figures:
    tests = module("exact.test_independent_coverage")
    twins = [seed for seed in range(TANK_TESTS) if tests.drawn(seed).has_twin]
    return {"twins": len(twins), "determined": len(tests.twins_called_determined(TANK_TESTS))}


def _rms(error: Any) -> float:
    return float(np.sqrt(np.mean(np.square(error))))


def _interval(estimate: Any, per: float = 1.0) -> Figures:
    return {**{k: getattr(estimate, k) / per for k in ("value", "low", "high")}, "verdict": estimate.verdict}
