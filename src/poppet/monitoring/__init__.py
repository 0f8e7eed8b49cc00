"""Condition monitoring: states, slowly changing parameters and faults of a running plant."""
