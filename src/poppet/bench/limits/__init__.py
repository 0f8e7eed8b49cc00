"""Dynamic limits of a valve model versus load volume and amplitude."""
