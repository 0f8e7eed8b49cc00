"""Export as an FMU (FMI 2.0 and 3.0): model description, C code for the FMI functions, binaries."""
