"""Identification of the force law of a pneumatic muscle from measured forces."""
