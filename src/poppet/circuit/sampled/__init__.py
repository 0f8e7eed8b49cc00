"""Sampled circuits: steady state, kinks, and the discrete linear model over one sample."""
