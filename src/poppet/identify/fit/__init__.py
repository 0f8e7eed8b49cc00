"""Identification of any parameters of a circuit from recordings."""
