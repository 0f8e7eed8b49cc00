"""Co-simulation with FMUs: model descriptions, child processes and the master."""
