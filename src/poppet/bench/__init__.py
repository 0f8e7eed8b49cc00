"""The virtual test bench of pressure valves after ISO 10094: figures of a model or of recordings, by one evaluation."""
