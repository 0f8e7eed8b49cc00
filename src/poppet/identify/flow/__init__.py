"""Identification of flow characteristics from a steady flow bench, after ISO 6358-1."""
