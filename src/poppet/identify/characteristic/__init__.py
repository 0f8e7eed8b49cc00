"""Identification of C(x) and b(x) from tests at several strokes."""
