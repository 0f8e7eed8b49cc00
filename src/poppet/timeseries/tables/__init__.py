"""Readers of tables of numbers in many file formats, with names and units of the columns."""
