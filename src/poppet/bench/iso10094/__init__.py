"""Characteristic values of a pressure valve after ISO 10094, from a model or from recordings."""
