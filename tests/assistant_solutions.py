"""Scripted solutions of the tasks in `tasks.toml`, by the tools of `poppet mcp` alone."""

from __future__ import annotations

import math
from collections.abc import Awaitable, Callable, Sequence
from typing import Any

from assistant_client import Call, ToolError

Solution = Callable[[Call], Awaitable[float]]
SOLUTIONS: dict[str, Solution] = {}


def solution(function: Solution) -> Solution:
    """Register a solution under the name of its function."""
    SOLUTIONS[function.__name__] = function
    return function


# --- Texts of circuits ---


def part(name: str, kind: str, **fields: Any) -> str:
    """Return the table of a part; a double underscore stands for a dot, `from_` for `from`."""
    rows = [f"{key.strip('_').replace('__', '.')} = {toml(value)}" for key, value in fields.items()]
    return "\n".join([f"[parts.{name}]", f'kind = "{kind}"', *rows, "", ""])


def toml(value: Any) -> str:
    return f'"{value}"' if isinstance(value, str) else str(value).lower() if isinstance(value, bool) else str(value)


def run(duration: str, **options: str) -> str:
    return "\n".join(["[run]", f'duration = "{duration}"', *(f'{k} = "{v}"' for k, v in options.items()), ""])


def reservoir(name: str, pressure: str, **fields: Any) -> str:
    return part(name, "reservoir", pressure=pressure, **fields)


def valve(from_: str, to: str, conductance: float, ratio: float, name: str = "valve") -> str:
    capacity = {"sonic_conductance": f"{conductance} dm^3/(s bar)", "critical_ratio": ratio}
    return part(name, "orifice", from_=from_, to=to, **capacity)


def tank(volume: str, pressure: str = "1 bar", name: str = "tank", **fields: Any) -> str:
    return part(name, "chamber", volume=volume, initial_pressure=pressure, **fields)


async def final(call: Call, text: str, output: str, unit: str = "", **options: Any) -> float:
    """Return the last value of an output."""
    units = {"units": [unit]} if unit else {}
    result = await call("simulate", text=text, select=[output], **units, **options)
    assert result["outcome"]["code"] in ("run.done", "run.condition_met"), result["outcome"]
    return result["summary"][output]["last"]


async def first(call: Call, text: str, output: str, unit: str) -> float:
    result = await call("simulate", text=text, select=[output], units=[unit])
    return result["summary"][output]["first"]


# --- Flow ---


@solution
async def choked(call: Call) -> float:
    text = reservoir("supply", "7 bar") + valve("supply", "ambient", 1.0, 0.3) + run("0.1 s")
    return await final(call, text, "valve.mass_flow_rate", "g/s")


@solution
async def subsonic(call: Call) -> float:
    ends = reservoir("supply", "5 bar") + reservoir("outlet", "4 bar")
    return await final(call, ends + valve("supply", "outlet", 1.0, 0.3) + run("0.1 s"), "valve.mass_flow_rate", "g/s")


@solution
async def hot(call: Call) -> float:
    fields = await call("describe_kind", kind="reservoir")
    assert "temperature" in fields["fields"]
    text = reservoir("supply", "7 bar", temperature="80 degC") + valve("supply", "ambient", 1.0, 0.3) + run("0.1 s")
    return await final(call, text, "valve.mass_flow_rate", "g/s")


@solution
async def nominal(call: Call) -> float:
    text = reservoir("supply", "6 bar g") + reservoir("outlet", "5 bar g")
    text += part("valve", "orifice", from_="supply", to="outlet", nominal_flow="500 l/min ANR") + run("0.1 s")
    return await final(call, text, "valve.mass_flow_rate", "l/min ANR", set={"ambient.pressure": "1.01325 bar"})


@solution
async def helium(call: Call) -> float:
    gas = f"[gas]\ngas_constant = 2077.1\nisentropic_exponent = {5 / 3}\n\n"
    nozzle = part("valve", "orifice", from_="supply", to="ambient", effective_area="5 mm^2")
    return await final(call, gas + reservoir("supply", "4 bar") + nozzle + run("0.1 s"), "valve.mass_flow_rate", "g/s")


@solution
async def series(call: Call) -> float:
    text = reservoir("supply", "6 bar") + valve("supply", "middle", 1.0, 0.5, "inlet")
    text += tank("0.1 l", name="middle") + valve("middle", "ambient", 1.0, 0.5, "outlet") + run("20 s")
    return await final(call, text, "middle.pressure", "bar")


# --- Tanks ---


def filled_tank(volume: str = "10 l", conductance: float = 0.1) -> str:
    text = reservoir("supply", "8 bar") + valve("supply", "tank", conductance, 0.3)
    return text + tank(volume, thermal="isothermal")


@solution
async def discharge_half(call: Call) -> float:
    text = tank("10 l", "7 bar", thermal="isothermal") + valve("tank", "ambient", 0.1, 0.3) + run("200 s")
    result = await call("simulate", text=text, stop_when=["tank.pressure < 3.5 bar"], select=["tank.pressure"])
    return result["duration"]["value"]


@solution
async def fill_time(call: Call) -> float:
    result = await call("simulate", text=filled_tank(), duration="60 s", stop_when=["tank.pressure > 2 bar"])
    return result["duration"]["value"]


def adiabatic_tank() -> str:
    return tank("5 l", "8 bar") + valve("tank", "ambient", 0.2, 0.3) + run("60 s", stop_when="tank.pressure < 4 bar")


@solution
async def adiabatic_time(call: Call) -> float:
    return (await call("simulate", text=adiabatic_tank()))["duration"]["value"]


@solution
async def adiabatic_temperature(call: Call) -> float:
    return await final(call, adiabatic_tank(), "tank.temperature", "degC")


@solution
async def charge_temperature(call: Call) -> float:
    text = reservoir("supply", "7 bar") + valve("supply", "tank", 1.0, 0.3) + tank("2 l") + run("10 s")
    return await final(call, text, "tank.temperature", "degC")


CLOSED = part("cock", "orifice", from_="tank", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3, opening=0)
"""Closed valve of a tank."""


def two_tanks(volumes: tuple[str, str], pressure: str, **fields: Any) -> str:
    text = tank(volumes[0], pressure, "first", **fields) + tank(volumes[1], "1 bar", "second", **fields)
    return text + valve("first", "second", 1.0, 0.3) + run("60 s")


@solution
async def equalise(call: Call) -> float:
    return await final(call, two_tanks(("2 l", "6 l"), "7 bar", thermal="isothermal"), "second.pressure", "bar")


@solution
async def equalise_adiabatic(call: Call) -> float:
    return await final(call, two_tanks(("1 l", "3 l"), "9 bar"), "second.pressure", "bar")


@solution
async def mass(call: Call) -> float:
    return await first(call, tank("20 l", "6 bar g") + CLOSED + run("1 s"), "tank.mass", "g")


@solution
async def source(call: Call) -> float:
    text = tank("20 l", thermal="isothermal") + part("inlet", "flow_source", to="tank", mass_flow_rate="1 g/s")
    return await final(call, text + run("10 s"), "tank.pressure", "bar")


def hot_tank(pressure: str) -> str:
    walls = {"wall_conductance": "2 W/K", "wall_temperature": "20 degC"}
    return tank("10 l", pressure, initial_temperature="80 degC", **walls) + CLOSED


@solution
async def cooling(call: Call) -> float:
    result = await call(
        "simulate", text=hot_tank("1 bar"), duration="10 s", times=[3.53957242], select=["tank.temperature"]
    )
    return result["values_at"]["tank.temperature"]["values"][0]


@solution
async def cooled_pressure(call: Call) -> float:
    return await final(call, hot_tank("2 bar"), "tank.pressure", "bar", duration="200 s")


# --- Bodies and cylinders ---


def free(body: str) -> str:
    """Return the actuator that each body must have, here a needle whose force is negligible."""
    volumes = {"cap__dead_volume": "1 l", "rod__dead_volume": "1 l"}
    needle = part("needle", "cylinder", body=body, bore="0.1 mm", stroke_length="10 m", offset="5 m", **volumes)
    return needle + valve("needle.cap", "ambient", 1.0, 0.3, "cap") + valve("needle.rod", "ambient", 1.0, 0.3, "rod")


@solution
async def fall(call: Call) -> float:
    body = part("body", "mass", mass="1 kg", inclination="-90 deg", friction__kind="none")
    return await final(call, body + free("body") + run("0.5 s"), "body.position", "mm")


@solution
async def terminal(call: Call) -> float:
    body = part("body", "mass", mass="2 kg", load_force="-50 N", friction__viscous_coefficient="100 N s/m")
    return await final(call, body + free("body") + run("2 s"), "body.velocity", "mm/s")


@solution
async def incline(call: Call) -> float:
    body = part("body", "mass", mass="3 kg", inclination="-30 deg", friction__kind="none")
    return await final(call, body + free("body") + run("1 s"), "body.position", "m")


@solution
async def angle(call: Call) -> float:
    body = part("arm", "joint", inertia="0.1 kg m^2", pulley_radius="50 mm", load_torque="-0.4 N m")
    return await final(call, body + free("arm") + run("0.5 s"), "arm.position", "deg")


def cylinder(bore: str, rod: str, cap: str) -> str:
    fields = {"stroke_length": "100 mm", "cap.dead_volume": "50 cm^3", "rod.dead_volume": "50 cm^3"}
    rows = {key.replace(".", "__"): value for key, value in fields.items()}
    pressures = {"cap__initial_pressure": cap}
    return part("drive", "cylinder", bore=bore, rod_diameter=rod, body="slide", **rows, **pressures)


@solution
async def piston_force(call: Call) -> float:
    body = part("slide", "guide") if "position" in (await call("describe_kind", kind="guide"))["inputs"] else ""
    text = cylinder("50 mm", "20 mm", "6 bar g") + body + run("1 ms")
    return await first(call, text, "drive.force", "N")


@solution
async def load_pressure(call: Call) -> float:
    body = part("slide", "mass", mass="40 kg", inclination="90 deg", initial_position="50 mm",
                friction__viscous_coefficient="2 kN s/m")  # fmt: skip
    text = cylinder("32 mm", "0 mm", "5 bar g") + body + valve("drive.rod", "ambient", 1.0, 0.3, "vent")
    return await final(call, text + run("60 s"), "drive.cap.pressure", "bar g")


# --- Sizing and uncertainty ---


def fill_requirement(text: str, limit: str) -> str:
    metric = '[ensemble.metrics]\nfill = { of = "tank.pressure", metric = "time_to", value = "2 bar", unit = "s" }\n\n'
    return f'{text}{metric}[requirements]\nfast = "fill < {limit}"\n\n{run("30 s", output_step="20 ms")}'


@solution
async def size_valve(call: Call) -> float:
    result = await call("size", text=fill_requirement(filled_tank(), "5 s"), free="valve.sonic_conductance")
    assert (result["is_met"], result["unit"]) == (True, "m^3/(s Pa)")
    return 1e8 * result["value"]


@solution
async def size_tank(call: Call) -> float:
    result = await call("size", text=fill_requirement(filled_tank("1 l"), "5 s"), free="tank.volume", largest=True)
    return 1e3 * result["value"]


def component_file(conductances: Sequence[float]) -> str:
    """Return a component file with orifices named X1, X2, ..."""
    lines = ['manufacturer = "Acme"', "[documents.sheet]", 'title = "Data sheet"']
    for k, conductance in enumerate(conductances, 1):
        fields = f'{{ sonic_conductance = "{conductance} dm^3/(s bar)", critical_ratio = 0.3 }}'
        lines += [f"[components.X{k}]", 'kinds = ["orifice"]', 'document = "sheet"', f"fields = {fields}"]
    return "\n".join([*lines, ""])


@solution
async def size_catalogue(call: Call) -> float:
    await call("write_file", name="acme.toml", text=component_file((0.2, 0.3, 0.5)))
    text = 'components = ["acme.toml"]\n' + fill_requirement(filled_tank(), "5 s")
    result = await call("size", text=text, catalogue="valve", find="Acme")
    assert result["selected"]["component"] == "Acme X2"
    return result["selected"]["metrics"]["fill"]


async def yield_(call: Call) -> float:
    ensemble = '[ensemble]\nruns = 1000\nseed = 3\nsampling = "random"\n\n[ensemble.parameters]\n'
    ensemble += '"tank.volume" = { distribution = "uniform", low = "9 l", high = "11 l" }\n\n'
    result = await call("ensemble", text=fill_requirement(filled_tank() + ensemble, "13.162352 s"))
    return result["yields"][0]["share"]


SOLUTIONS["yield"] = yield_


# --- Identification ---


def flow(p1: float, p2: float, conductance: float, ratio: float) -> float:
    """Return a mass flow rate of ISO 6358-1 at 20 degC [kg/s]; pressures in Pa."""
    excess = max((p2 / p1 - ratio) / (1.0 - ratio), 0.0)
    return conductance * 1.185 * p1 * math.sqrt(1.0 - excess**2)


@solution
async def identify_flow(call: Call) -> float:
    rows = [f"{1e3 * flow(6e5, p * 1e5, 2e-8, 0.4):.9g},6,{p},20" for p in (1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5)]
    await call("write_file", name="bench.csv", text="\n".join(["q,p1,p2,T1", *rows, ""]))
    channels = {"mass_flow_rate": ("q", "g/s"), "pressure_1": ("p1", "bar"), "pressure_2": ("p2", "bar")}
    channels["temperature_1"] = ("T1", "degC")
    text = 'title = "bench"\nfile = "bench.csv"\n'
    text += "".join(f'{name} = {{ column = "{c}", unit = "{u}" }}\n' for name, (c, u) in channels.items())
    await call("write_file", name="bench.toml", text=text)
    result = await call("identify", method="flow", file="bench.toml")
    (value,) = (row["value"] for name, row in result["parameters"].items() if name.endswith("sonic_conductance"))
    return 1e8 * value


@solution
async def identify_tank(call: Call) -> float:
    tau = 10e-3 / (3e-9 * 1.185 * 287.05 * 293.15)
    rows = [f"{0.2 * k:.1f},{7.0 * math.exp(-0.2 * k / tau):.9g}" for k in range(101)]
    await call("write_file", name="discharge.csv", text="\n".join(["t,p", *rows, ""]))
    await call("write_file", name="tank.toml", text=(
        'volume = "10 l"\nthermal = "isothermal"\ncritical_ratio = 0.3\nambient_temperature = "20 degC"\n\n'
        '[recordings.discharge]\nfile = "discharge.csv"\ntime = { column = "t", unit = "s" }\n'
        '"tank.pressure" = { column = "p", unit = "bar" }\n'
    ))  # fmt: skip
    result = await call("identify", method="tank", file="tank.toml", output="tank_result.toml")
    assert "tank_result.toml" in [row["name"] for row in (await call("list_files"))["files"]]
    return 1e8 * result["parameters"]["valve.sonic_conductance"]["value"]


# --- Audits ---


async def survey(call: Call, name: str, leak: str) -> dict[str, Any]:
    tariff = '[audit]\ntariff = "0.25 EUR/kWh"\nspecific_energy = "0.12 kWh/m^3"\nhours = "6000 h"\n\n'
    await call("write_file", name=name, text=f'title = "leaks"\n\n{tariff}[leaks.hose]\n{leak}')
    return await call("audit_leaks", file=name)


@solution
async def leak_cost(call: Call) -> float:
    result = await survey(call, "cost.toml", 'method = "estimate"\nflow = "45 l/min ANR"\ncount = 2\n')
    return result["total"]["cost_per_year"]


@solution
async def bag(call: Call) -> float:
    leak = 'method = "bag"\ndiameter = "300 mm"\nheight = "500 mm"\nfill_time = "12 s"\n'
    return (await survey(call, "bag.toml", leak))["total"]["air_l_anr_per_min"]


@solution
async def exergy(call: Call) -> float:
    text = reservoir("supply", "7 bar") + valve("supply", "tank", 1.0, 0.3) + tank("10 l", thermal="isothermal")
    result = await call("audit_energy", text=text + run("60 s"), cycle="0 s, 60 s")
    return result["cycle"]["exergy_supplied_j"]


@solution
async def exhaust(call: Call) -> float:
    dump = part("dump", "directional_valve", supply="tank", outlet="ambient", normally="open", command=1,
                initial_position=0, sonic_conductance="1 dm^3/(s bar)", critical_ratio=0.3,
                switching_time="1 ms")  # fmt: skip
    text = tank("5 l", "6 bar g", thermal="isothermal") + dump + run("1 s")
    event = {"event": {"dump.command": 0}, "at": ["0 s"], "threshold": "2.5 bar", "kinds": ["stuck_closed"]}
    result = await call("audit_safety", text=text, **event)
    times = {row["fault"]: row["time_s"] for row in result["exhaust"]}
    assert times["dump.stuck_closed"] == "inf"
    return times[""]


@solution
async def cycle(call: Call) -> float:
    steps = "".join(f'[parts.plc.steps.s{k}]\nnext = {{ s{(k + 1) % 4} = "elapsed >= 0.5 s" }}\n\n' for k in range(4))
    text = '[parts.plc]\nkind = "sequence"\nstart = "s0"\n\n' + steps
    text += reservoir("supply", "7 bar") + valve("supply", "tank", 1.0, 0.3) + tank("1 l") + run("9 s")
    return (await call("audit_energy", text=text))["cycle"]["duration_s"]


# --- Errors ---


async def errors_of(call: Call, text: str) -> list[dict[str, Any]]:
    """Return the errors of a circuit."""
    try:
        await call("check", text=text)
    except ToolError as error:
        return error.errors
    return []


@solution
async def errors(call: Call) -> float:
    text = reservoir("supply", "7 bar").replace("reservoir", "reservor") + valve("supply", "tnak", 1.0, 0.3)
    text += tank("1 bar") + run("1 s")
    found = await errors_of(call, text)
    assert all(row["code"] and row["address"] and row["hint"] for row in found)
    return len(found)


@solution
async def repair(call: Call) -> float:
    text = reservoir("supply", "7 bar") + valve("supply", "tank", 1.0, 0.3) + tank("1 l") + run("1 s")
    text = text.replace("volume", "volum").replace("sonic_conductance", "sonic_conductanc")
    for row in await errors_of(call, text):
        hint = row["hint"].removeprefix("Did you mean ").rstrip("?")
        if hint != row["hint"]:
            text = text.replace(f"{row['address'].rpartition('.')[2]} =", f"{hint} =")
    return await first(call, text, "valve.mass_flow_rate", "g/s")
