"""Time series: input signals, recordings, measured files and figures."""
