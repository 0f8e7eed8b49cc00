"""The law of a muscle from its measured force."""
