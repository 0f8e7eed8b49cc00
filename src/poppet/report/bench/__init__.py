"""Pages on the test bench."""
