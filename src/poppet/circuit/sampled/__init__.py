"""Analysis of sampled circuits: steady state, kinks, and linear model over one sample."""
