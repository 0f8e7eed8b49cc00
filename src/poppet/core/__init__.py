"""Errors, units, sources of parameters and files, which all packages use.

This package imports no other package of poppet.
"""
