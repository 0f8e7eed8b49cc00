"""Figures of a pressure valve, of a model or of recordings."""
