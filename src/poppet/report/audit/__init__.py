"""Reports of the audits of a machine: energy, safety and faults."""
