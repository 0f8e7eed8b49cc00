"""What everything stands on: errors, units, sources of numbers, files. Imports nothing of the house."""
