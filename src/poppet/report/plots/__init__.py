"""Plots of a page that one can zoom and read off: what a figure shows as numbers, and the scripts that draw them."""
