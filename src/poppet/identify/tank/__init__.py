"""Tank tests according to ISO 6358-2."""
