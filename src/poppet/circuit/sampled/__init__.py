"""Circuits with sampled memory for small changes: rest, kinks, and the discrete linear model over one sample."""
