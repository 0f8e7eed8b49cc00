"""Readers of the traced functions' instruction list."""
