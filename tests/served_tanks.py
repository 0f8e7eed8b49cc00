"""Circuit files of tests of served circuits."""

from __future__ import annotations

SUPPLY = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
"""
FLOW = 'sonic_conductance = "{} m^3/(s Pa)"\ncritical_ratio = 0.3\n'
TANK = """
[parts.tank]
kind = "chamber"
volume = "2 l"
"""
FILLED_TANK = SUPPLY + '\n[parts.fill]\nkind = "orifice"\nfrom = "supply"\nto = "tank"\n' + FLOW.format("1e-9") + TANK
"""Tank that fills through an orifice."""
VALVE = '\n[parts.valve]\nkind = "directional_valve"\nsupply = "supply"\noutlet = "tank"\nexhaust = "ambient"\n'
SWITCHED_TANK = SUPPLY + VALVE + FLOW.format("1e-8") + TANK
"""Tank behind a valve."""
DELAYED_TANK = SUPPLY + VALVE + FLOW.format("1e-8") + 'delay = "25 ms"\n' + TANK
"""Tank behind a valve that reacts after 25 ms."""
EMPTIED_TANK = (
    '[parts.pump]\nkind = "flow_source"\nto = "tank"\nmass_flow_rate = "-1 g/s"\n\n'
    '[parts.tank]\nkind = "chamber"\nvolume = "1 cm^3"\n'
)
"""Tank whose integration fails: a flow that does not depend on the pressure empties it."""
