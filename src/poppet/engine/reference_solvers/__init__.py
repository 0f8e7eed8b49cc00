"""Independent solvers of the same problem."""
