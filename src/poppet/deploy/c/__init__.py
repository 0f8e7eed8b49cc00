"""A circuit as C: the model, the adaptive integrator of the kernel, a fixed step for real time, a host."""
