"""Tests on a flow bench, after ISO 6358-1."""
