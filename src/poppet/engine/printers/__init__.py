"""Printers (code generators) for the instruction lists of traced functions."""
