"""The virtual test bench of pressure valves: figures, and what limits them."""
