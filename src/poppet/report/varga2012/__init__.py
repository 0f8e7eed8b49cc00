"""Report on the paper of Varga and Keski-Honkola (2012)."""
