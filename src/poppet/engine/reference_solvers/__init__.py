"""Reference solvers, which are independent of the Rosenbrock kernel."""
