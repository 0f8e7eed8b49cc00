"""Export as structured text."""
