"""Places of the ports of parts on the borders of their symbols, in modules of ISO 1219-1."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import count

from poppet.edit.svg_symbols import distance_to, ends_of
from poppet.parts.symbols import Symbol

Place = tuple[str, int]
"""Side of the border, and distance from the centre of the symbol to the right or down."""
Box = tuple[int, int, int, int]
"""Left end, top end, width and height."""
INWARD = {"left": (1.0, 0.0), "right": (-1.0, 0.0), "top": (0.0, 1.0), "bottom": (0.0, -1.0)}
"""Side to the direction from the border to the symbol."""

PLACES: dict[str, dict[str, Place]] = {
    "reservoir": {"": ("right", 0)},
    "chamber": {"": ("left", 0)},
    "flow_source": {"to": ("right", 0)},
    "main_stage": {
        "supply": ("bottom", 1),
        "outlet": ("top", 1),
        "exhaust": ("bottom", 3),
        "pilot_pressure": ("left", 0),
    },
    "pilot_stage": {
        "": ("top", 0),
        "supply": ("left", 0),
        "exhaust": ("right", 0),
        "fill_duty": ("top", -2),
        "vent_duty": ("top", 2),
        "displacement": ("bottom", -2),
        "displacement_rate": ("bottom", 2),
    },
    "proportional_valve": {
        "supply": ("bottom", 1),
        "outlet": ("top", 1),
        "exhaust": ("bottom", 3),
        "pilot_exhaust": ("bottom", -2),
        "setpoint": ("left", 0),
    },
    "directional_valve": {
        "supply": ("bottom", 1),
        "outlet": ("top", 1),
        "exhaust": ("bottom", 3),
        "command": ("left", 0),
    },
    "piloted_check_valve": {"pilot": ("bottom", -2)},
    "shuttle_valve": {"a": ("left", 0), "b": ("right", 0), "outlet": ("top", 0)},
    "two_pressure_valve": {"a": ("left", 0), "b": ("right", 0), "outlet": ("top", 0)},
    "quick_exhaust_valve": {"inlet": ("left", 0), "outlet": ("top", 0), "exhaust": ("right", 0)},
    "spool_valve": {
        "supply": ("bottom", 0),
        "a": ("top", -1),
        "b": ("top", 1),
        "exhaust_a": ("bottom", -1),
        "exhaust_b": ("bottom", 1),
        "pilot_a": ("left", -1),
        "pilot_b": ("right", -1),
        "command": ("left", 0),
        "command_a": ("left", 0),
        "command_b": ("right", 0),
    },
    "pressure_regulator": {"supply": ("left", 0), "outlet": ("right", 0), "exhaust": ("left", 2)},
    "compressor": {"outlet": ("right", 0)},
    "vacuum_ejector": {"supply": ("left", 0), "vacuum": ("bottom", 0), "exhaust": ("right", 0)},
    "suction_cup": {"port": ("left", 0), "": ("top", 1), "sealed": ("bottom", 1), "load_force": ("right", 0)},
    "mass": {"": ("left", 0)},
    "joint": {"": ("left", -3)},
    "guide": {"": ("left", 0)},
    "cylinder": {"cap": ("bottom", -3), "rod": ("bottom", 1), "body": ("right", 0)},
    "pressure_booster": {
        "supply": ("left", 0),
        "outlet": ("right", 0),
        "exhaust": ("bottom", -3),
        "drive_supply": ("bottom", -1),
    },
    "gripper": {"cap": ("bottom", -3), "rod": ("bottom", -1)},
    "rotary_actuator": {"forward": ("left", -2), "backward": ("left", 2)},
    "muscle": {"": ("left", 0), "body": ("right", 0)},
}
"""Places of the ports of each kind; other ports have the places of their type."""

SECOND_PLACES: dict[str, dict[str, Place]] = {
    "chamber": {"": ("right", 0)},
    "mass": {"": ("right", 0)},
    "joint": {"": ("left", 3)},
}
"""Further places at which a wire can end."""


@dataclass(frozen=True)
class PortPlace:
    """Place of a port on the border of a symbol, with the length of the line from there to the symbol."""

    x: int
    y: int
    side: str
    lead: float


def arrange(
    kind: str, ports: Sequence[tuple[str, str]], symbols: Sequence[Symbol], is_controller: bool
) -> tuple[Box, dict[str, PortPlace], dict[str, PortPlace]]:
    """Return the box of a symbol, the place of each port, and the second places of some ports.

    `ports` contains name and type of each port. The box contains all `symbols`, which are the symbol of a part without
    and with driven inputs. Places are on its border, with whole modules as coordinates, and no two are equal.
    """
    chosen = {name: PLACES.get(kind, {})[name] for name, _ in ports if name in PLACES.get(kind, {})}
    second = {name: place for name, place in SECOND_PLACES.get(kind, {}).items() if name in dict(ports)}
    taken = {*chosen.values(), *second.values()}
    pipes = [name for name, port_type in ports if port_type in ("port", "tube")]
    for side, step, names in (
        *((side, 2, pipes[k : k + 1]) for k, side in enumerate(("left", "right"))),
        ("bottom", 2, pipes[2:]),
        ("bottom", 2, [name for name, port_type in ports if port_type == "store"]),
        ("right", 2, [name for name, port_type in ports if port_type == "body"]),
        ("left" if is_controller else "top", 1, [name for name, port_type in ports if port_type == "input"]),
        ("right", 1, [name for name, port_type in ports if port_type == "output"]),
    ):
        others = [name for name in names if name not in chosen]
        free = (offset for offset in _offsets(step) if (side, offset) not in taken)
        for name, offset in zip(others, sorted(next(free) for _ in others), strict=True):
            chosen[name] = side, offset
            taken.add((side, offset))
    left, top, right, bottom = ends_of(*symbols)
    # The corners of the box are no places.
    across = max((abs(offset) + 1 for side, offset in taken if side in ("top", "bottom")), default=1)
    down = max((abs(offset) + 1 for side, offset in taken if side in ("left", "right")), default=1)
    left, right = math.floor(min(left, -across)), math.ceil(max(right, across))
    top, bottom = math.floor(min(top, -down)), math.ceil(max(bottom, down))
    edges = {"left": left, "right": right, "top": top, "bottom": bottom}

    def place(side: str, offset: int) -> PortPlace:
        x, y = (edges[side], offset) if side in ("left", "right") else (offset, edges[side])
        return PortPlace(x, y, side, round(distance_to(symbols[0], (x, y), INWARD[side]) or 0.0, 3))

    box = (left, top, right - left, bottom - top)
    places = {name: place(*chosen[name]) for name, _ in ports}
    return box, places, {name: place(*where) for name, where in second.items()}


def _offsets(step: int) -> Iterator[int]:
    """Yield 0 and multiples of `step` with both signs, from the smallest size."""
    yield 0
    for offset in count(step, step):
        yield -offset
        yield offset
