"""Export as C."""
