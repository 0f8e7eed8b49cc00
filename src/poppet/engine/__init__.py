"""A traced model becomes machine code, and a problem in plain arrays a run."""
