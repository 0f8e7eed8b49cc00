"""Figures, pictures of circuits and self-contained reports."""
