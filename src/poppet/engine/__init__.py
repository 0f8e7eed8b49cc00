"""Compilation of symbolic models to machine code, and solution of problems in plain arrays."""
