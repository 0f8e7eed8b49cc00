"""Exports of a circuit: C, FMU, structured text, WebAssembly pages; all are made from one trace of the model."""
