"""Editing of circuit files: operations on their text, and their history."""
