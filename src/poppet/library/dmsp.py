"""Fluidic muscles DMSP of 10, 20 and 40 mm, after the force maps of Martens & Boblan 2017.

M. Martens, I. Boblan: Modeling the Static Force of a Festo Pneumatic Muscle Actuator: A New Approach and a Comparison
to Existing Models. Actuators 2017, 6(4), 33, Appendix A (CC BY 4.0).

The source has maps of the measured force over contraction and pressure for one DMSP-20-300 and one DMSP-10-250. The six
parameters of Sarosi's law are fitted to the taut points of these maps. There is no map for size 40: its forces are four
times those of size 20. The highest forces and pressures are manufacturer data from memory. Volume, damping and
hysteresis were not measured. The volume is that of a cylinder of the nominal size, and its growth does the work of the
force law.
"""

from __future__ import annotations

from collections.abc import Mapping

from poppet.core.provenance import Number, Source, assumed

MAP = "Martens & Boblan 2017, Actuators 6(4), 33, Appendix A"
REFERENCES = {
    "dmsp_10_250": f"Sarosi's law fitted to the force map of {MAP}",
    "dmsp_20_300": f"Sarosi's law fitted to the force map of {MAP}",
    "dmsp_40_300": f"assumed, by similarity with dmsp_20_300: no force map of this size is published in {MAP}",
}
_UNITS = {"a1": "N/Pa", "a2": "N", "a3": "1", "a4": "N/Pa", "a5": "N/Pa", "a6": "N"}


def _numbers(values: Mapping[str, float], source: Source) -> dict[str, Number]:
    return {f"sarosi.{name}": Number(values[name], unit, source) for name, unit in _UNITS.items()}


def _convert_printed(a1: float, a2: float, a3: float, a4: float, a5: float, a6: float) -> dict[str, float]:
    """Convert the printed parameters of Sarosi's law to SI.

    The printed parameters are for pressures in bar and contractions in per cent.
    """
    return {"a1": a1 * 1e-5, "a2": a2, "a3": a3 * 1e2, "a4": a4 * 1e-3, "a5": a5 * 1e-5, "a6": a6}


def _remembered(value: float, unit: str, note: str, reference: str = "") -> Number:
    source = Source("datasheet", "Festo DMSP/MAS", f"{note}; as remembered, verify before use")
    return Number(value, unit, source, reference)  # type: ignore[arg-type]


def _body(diameter: float, length: float, force: float, pressure: float) -> dict[str, Number]:
    return {
        "nominal_diameter": _remembered(diameter, "m", "nominal inner diameter"),
        "nominal_length": Number(length, "m", Source("paper", MAP, "nominal length of the muscle")),
        "limits.highest_force": _remembered(force, "N", "largest permitted force"),
        "limits.highest_pressure": _remembered(pressure, "Pa", "largest permitted pressure", "gauge"),
    }


_FITTED = Source("fitted", MAP, "taut points; rms 6.2 N, 0.37 % of the largest force")
_SMALL_FIT = Source("fitted", MAP, "taut points; rms 1.1 N, 0.20 % of the largest force")
_SIMILAR = Source("assumed", note="four times that of dmsp_20_300: forces go with the area")
_TWENTY = _convert_printed(12.789, 419.4831, -0.5666, -8.7013, 267.672, -309.6031)
_FORTY = {name: value if name == "a3" else 4.0 * value for name, value in _TWENTY.items()}
_MAPPED = {
    "limits.lowest_contraction": Number(0.01333, "1", Source("measured", MAP, "smallest contraction of the map")),
    "limits.highest_contraction": Number(0.26, "1", Source("measured", MAP, "largest contraction of the map")),
    "limits.lowest_pressure": Number(3.5e4, "Pa", Source("measured", MAP, "lowest pressure of the map"), "gauge"),
}
_AS_MAPPED = {
    name: assumed(number.value, number.unit, "as of dmsp_20_300", reference=number.reference)
    for name, number in _MAPPED.items()
}

SETS: Mapping[str, Mapping[str, Number]] = {
    "dmsp_10_250": {
        **_numbers(_convert_printed(-3.0515, 168.2348, -0.4246, -2.9021, 91.4042, -201.0267), _SMALL_FIT),
        **_body(0.010, 0.25, 630.0, 8e5),
        **_AS_MAPPED,
    },
    "dmsp_20_300": {**_numbers(_TWENTY, _FITTED), **_body(0.020, 0.3, 1500.0, 6e5), **_MAPPED},
    "dmsp_40_300": {
        **_numbers(_FORTY, _SIMILAR),
        **_body(0.040, 0.3, 6000.0, 6e5),
        "nominal_length": assumed(0.3, "m", "as dmsp_20_300"),
        **_AS_MAPPED,
    },
}
