"""Export as an FMU (FMI 2.0 and 3.0): description, C code around the kernel, binaries."""
