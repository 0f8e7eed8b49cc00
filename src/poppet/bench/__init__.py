"""The virtual test bench of pressure valves: figures after ISO 10094, of a model or of recordings; what limits them."""
