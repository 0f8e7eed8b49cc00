"""Virtual test bench for pressure valves: characteristic values after ISO 10094, and dynamic limits."""
