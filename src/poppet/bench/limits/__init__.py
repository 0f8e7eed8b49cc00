"""Limits of a valve versus load volume and amplitude."""
