"""ISO 6358: the flow law of a pneumatic passage, its inverses, combinations and conversions."""

from poppet.laws.iso6358.combination import parallel, parallel_of, series, series_of, tube
from poppet.laws.iso6358.conversion import (
    ASSUMED_CRITICAL_RATIO,
    Conductance,
    conductance_from_effective_area,
    conductance_from_flow_coefficient_cv,
    conductance_from_flow_coefficient_kv,
    effective_area_from_conductance,
    flow_coefficient_cv_from_conductance,
    flow_coefficient_kv_from_conductance,
)
from poppet.laws.iso6358.inverse import downstream_pressure, upstream_pressure
from poppet.laws.iso6358.law import (
    LAMINAR_RATIO,
    REFERENCE_DENSITY,
    REFERENCE_TEMPERATURE,
    REGIMES,
    flow,
    flow_regime,
    mass_flow_rate,
    upstream_temperature,
)
from poppet.laws.iso6358.measured_point import (
    critical_ratio_from_point,
    effective_conductance,
    sonic_conductance_from_flow,
)
from poppet.laws.iso6358.nominal_flow import (
    conductance_from_nominal_flow,
    mass_from_volume_flow_rate,
    nominal_flow_from_conductance,
    volume_from_mass_flow_rate,
)
from poppet.laws.iso6358.nozzle import nozzle_choked_flux, nozzle_critical_ratio, nozzle_mass_flow_rate

__all__ = [
    "ASSUMED_CRITICAL_RATIO",
    "LAMINAR_RATIO",
    "REFERENCE_DENSITY",
    "REFERENCE_TEMPERATURE",
    "REGIMES",
    "Conductance",
    "conductance_from_effective_area",
    "conductance_from_flow_coefficient_cv",
    "conductance_from_flow_coefficient_kv",
    "conductance_from_nominal_flow",
    "critical_ratio_from_point",
    "downstream_pressure",
    "effective_area_from_conductance",
    "effective_conductance",
    "flow",
    "flow_coefficient_cv_from_conductance",
    "flow_coefficient_kv_from_conductance",
    "flow_regime",
    "mass_flow_rate",
    "mass_from_volume_flow_rate",
    "nominal_flow_from_conductance",
    "nozzle_choked_flux",
    "nozzle_critical_ratio",
    "nozzle_mass_flow_rate",
    "parallel",
    "parallel_of",
    "series",
    "series_of",
    "sonic_conductance_from_flow",
    "tube",
    "upstream_pressure",
    "upstream_temperature",
    "volume_from_mass_flow_rate",
]
