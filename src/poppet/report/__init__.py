"""Figures, schematics of circuits and self-contained HTML reports."""
