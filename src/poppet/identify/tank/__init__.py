"""Tests with a tank, after ISO 6358-2."""
