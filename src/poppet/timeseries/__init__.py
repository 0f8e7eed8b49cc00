"""Values over time: inputs, recordings, files that others measured, drawings."""
