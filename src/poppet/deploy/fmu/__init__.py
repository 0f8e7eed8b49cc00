"""A circuit as an FMU, FMI 2.0 and 3.0: description, C around the kernel, binaries, one file."""
