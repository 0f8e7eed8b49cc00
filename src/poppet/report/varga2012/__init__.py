"""The page on the paper of Varga and Keski-Honkola."""
