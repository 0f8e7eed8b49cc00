"""Exports of a circuit: C, FMU, structured text and HTML pages with WebAssembly.

All exports are made from the same symbolic (CasADi) model of the circuit.
"""
