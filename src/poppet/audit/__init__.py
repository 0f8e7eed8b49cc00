"""Audits of a machine: motion, energy, leaks, exhaust times and faults."""
