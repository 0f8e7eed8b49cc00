"""Test design: selection of tests by their predicted confidence intervals."""
