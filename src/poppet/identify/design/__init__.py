"""Selection of tests by their predicted confidence intervals."""
