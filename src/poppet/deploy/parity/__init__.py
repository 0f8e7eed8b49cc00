"""Comparison of runs by all export targets with the run of the kernel."""
