"""Identification of the friction of a body and of cylinder seals from tables or recordings."""
